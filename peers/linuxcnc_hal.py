"""Drives by LinuxCNC's HAL: the saddle example welded in real time on a headless HAL, with a correction every 3 s; then a
`seamwright run` on it that is killed, and the next one that must find HAL free again; then each of HAL's own programs killed
in the middle of a weld.

Usage: linuxcnc_hal.py SEAMWRIGHT EXAMPLE   (the built example linuxcnc_hal of the crate cell)
"""

import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

SEAMWRIGHT, EXAMPLE = sys.argv[1:]
JOB = Path(__file__).resolve().parent.parent / "examples" / "saddle.toml"
# Set-points in store: what a computer without a real-time kernel, busy with other things, may stand still for, ms.
STORE = os.environ.get("SEAMWRIGHT_PEERS_STORE", "60")


def written(folder):
    """A job on LinuxCNC's drives."""
    machine = subprocess.run([SEAMWRIGHT, "machine", "show", "ellipse-xy"], capture_output=True, text=True, check=True)
    (folder / "m.toml").write_text(f"{machine.stdout}\n[devices.drives.linuxcnc]\nstore = 150\n")
    job = (JOB.parent / "ellipse.toml").read_text().replace('"ellipse-xy"', '"m.toml"')
    (folder / "job.toml").write_text(job)


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
        written(folder)
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


def welds_until_killed(program):
    """A part of HAL killed with -9 in a weld: fault, the record complete, HAL back by itself, homed by the operator. Times of
    fault and return, s."""
    with tempfile.TemporaryDirectory(prefix="seamwright-peer-") as name:
        folder = Path(name)
        written(folder)
        data = str(folder / "data")
        run = subprocess.Popen(
            [SEAMWRIGHT, "run", str(folder / "job.toml"), "-o", str(folder / "out"), "--data", data, "--part", "P"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        )
        # A computer that is too busy stops the weld before: then nothing more comes.
        late = threading.Timer(90, run.kill)
        late.start()

        def order(*lines):
            run.stdin.write("".join(f"{line}\n" for line in lines))
            run.stdin.flush()

        def until(wanted, seen):
            for line in run.stdout:
                seen.append(line)
                if wanted in line:
                    return
            raise RuntimeError(f"{program}: no `{wanted}`: {''.join(seen)[-2000:]}")

        while run.poll() is None and not given_priority():
            time.sleep(0.02)
        order("on", "wait 1 s", "home", "wait ready", "arm", "weld", "wait 5 mm", "?")
        seen = []
        until("mode weld, pass 1", seen)
        pids = subprocess.run(["pgrep", "-x", program], capture_output=True, text=True).stdout.split()
        if len(pids) != 1:
            raise RuntimeError(f"{program} runs {len(pids)} times")
        os.kill(int(pids[0]), signal.SIGKILL)
        begun = time.monotonic()
        until("weld -> fault", seen)
        fault = time.monotonic() - begun
        until("runs again", seen)
        back = time.monotonic() - begun
        order("ack", "wait 1 s", "ack", "reset", "on", "wait 1 s", "home")
        until("homing -> ready", seen)
        run.stdin.close()
        run.stdout.read()
        run.wait(timeout=60)
        late.cancel()
        if "alarm    drives silent" not in "".join(seen):
            raise RuntimeError(f"{program}: {''.join(seen)[-2000:]}")
        listed = subprocess.run([SEAMWRIGHT, "records", "list", "--data", data, "--json"], capture_output=True, text=True, check=True)
        if [weld["result"] for weld in json.loads(listed.stdout)] != ["stopped"]:
            raise RuntimeError(f"{program}: the record: {listed.stdout}")
        subprocess.run([SEAMWRIGHT, "records", "verify", "--data", data], capture_output=True, check=True)
        return fault, back


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
    for program in ["rtapi_app", "halstreamer", "halsampler"]:
        fault, back = welds_until_killed(program)
        print(f"{program} killed with -9 in a weld: fault after {fault:.2f} s, HAL back after {back:.1f} s, homed again, the record in order")
    return 0


sys.exit(main())
