"""Drives by LinuxCNC's HAL: the saddle example welded in real time on a headless HAL, with a correction every 3 s; then a
`seamwright run` on it that is killed, and the next one that must find HAL free again.

Usage: linuxcnc_hal.py SEAMWRIGHT EXAMPLE   (the built example linuxcnc_hal of the crate cell)
"""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SEAMWRIGHT, EXAMPLE = sys.argv[1:]
JOB = Path(__file__).resolve().parent.parent / "examples" / "saddle.toml"
# Set-points in store: what a computer without a real-time kernel, busy with other things, may stand still for, ms.
STORE = os.environ.get("SEAMWRIGHT_PEERS_STORE", "60")


def orders(folder, seconds):
    """Starts `run` on LinuxCNC's drives: on, home, and waiting."""
    process = subprocess.Popen(
        [SEAMWRIGHT, "run", str(folder / "job.toml"), "-o", str(folder / "out")],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )
    process.stdin.write(f"on\nwait 1 s\nhome\nwait ready\nwait {seconds} s\n")
    process.stdin.flush()
    return process


def killed_and_again():
    """Time from a kill until another run has homed, s."""
    with tempfile.TemporaryDirectory(prefix="seamwright-peer-") as name:
        folder = Path(name)
        machine = subprocess.run([SEAMWRIGHT, "machines", "ellipse-xy"], capture_output=True, text=True, check=True)
        (folder / "m.toml").write_text(f"{machine.stdout}\n[devices.drives.linuxcnc]\nstore = 150\n")
        job = (JOB.parent / "ellipse.toml").read_text().replace('"ellipse-xy"', '"m.toml"')
        (folder / "job.toml").write_text(job)
        first = orders(folder, 60)
        time.sleep(3)
        if first.poll() is not None:
            raise RuntimeError(f"the run ended early: {first.stdout.read()[-1000:]}")
        first.send_signal(signal.SIGKILL)
        first.wait()
        begun = time.monotonic()
        second = orders(folder, 0)
        text, _ = second.communicate(timeout=60)
        if "homing -> ready" not in text:
            raise RuntimeError(f"after the kill: {text[-1000:]}")
        return time.monotonic() - begun


def given_priority():
    """Gives HAL's thread what LinuxCNC gives it on a real-time kernel, if we may; true once it is there."""
    threads = subprocess.run(["ps", "-eLo", "tid,comm"], capture_output=True, text=True).stdout.splitlines()
    ours = [line.split()[0] for line in threads if "rtapi_app:T" in line]
    for thread in ours:
        subprocess.run(["chrt", "-f", "-p", "75", thread], capture_output=True)
    return bool(ours)


def main():
    if not shutil.which("halrun"):
        print("SKIPPED: LinuxCNC is not installed; nothing was streamed into its HAL", file=sys.stderr)
        return 0
    done = subprocess.Popen([EXAMPLE, str(JOB), STORE])
    while done.poll() is None and not given_priority():
        time.sleep(0.02)
    if done.wait() != 0:
        return 1
    print(f"killed with -9 under power, the next run homes on a HAL of its own and ends after {killed_and_again():.1f} s")
    return 0


sys.exit(main())
