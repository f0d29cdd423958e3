"""A schedule and a study on Sail, a Spark server in Rust, against the same on this computer.

usage: spark.py SEAMWRIGHT [ROWS]

This Python needs the packages seamwright, pysail, pyspark-client, pandas and pyarrow: peers/run makes an environment.
Fails if a file differs, if a run that was killed is not resumed, or if a cluster of this computer takes more than 1.3 times
as long as the command line alone.
"""

import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SEAMWRIGHT = sys.argv[1]
ROWS = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
MAX_RATIO = 1.3
SERVER = """
import sys, time
from pysail.spark import SparkConnectServer
server = SparkConnectServer("127.0.0.1", 0)
server.start(background=True)
print(server.listening_address[1], flush=True)
sys.stdin.read()
"""
STUDY = """
schema = 1
job = "nozzle.toml"
seed = 3
[[quantities]]
name = "z"
vary.work = "z_mm"
draw.normal = { deviation = 20 }
[[quantities]]
name = "lift"
vary.axis_error = "h"
draw.uniform = { within = 0.5 }
"""
failures = 0


def check(is_right, what):
    global failures
    print(("ok      " if is_right else "FAILED  ") + what)
    failures += not is_right


def table(folder):
    """Nozzles of one template beside the table, with a machine file of its own; every tenth is impossible."""
    def shown(*command):
        return subprocess.run([SEAMWRIGHT, *command], capture_output=True, text=True, check=True).stdout

    (folder / "turntable.toml").write_text(shown("machine", "show", "saddle-4axis"))
    (folder / "nozzle.toml").write_text(shown("examples", "saddle").replace('"saddle-4axis"', '"turntable.toml"'))
    numbers = random.Random(48)
    with open(folder / "nozzles.csv", "w", encoding="utf-8") as file:
        file.write("name,template,seam.nozzle.radius_mm,weld.speed_mm_s\n*,nozzle.toml,,\n")
        for i in range(ROWS):
            radius = 900 if i % 10 == 9 else round(numbers.uniform(180, 260), 2)
            file.write(f"N{i},,{radius},{round(numbers.uniform(7, 12), 2)}\n")
    (folder / "study.toml").write_text(STUDY)
    return folder / "nozzles.csv"


def processor_s(server):
    """Processor time of the server and of all commands so far: unlike the clock, it does not depend on other programs."""
    fields = Path(f"/proc/{server.pid}/stat").read_text().rsplit(")", 1)[1].split()
    commands = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK") + commands.ru_utime + commands.ru_stime


def run(*command):
    begin = time.monotonic()
    # 1: some rows cannot be welded.
    done = subprocess.run([SEAMWRIGHT, *map(str, command)], capture_output=True, text=True)
    if done.returncode > 1:
        sys.exit(done.stderr)
    return time.monotonic() - begin, done.stdout


def files(folder):
    """All files; of a journal its lines in any order."""
    found = {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    return {name: sorted(data.split(b"\n")) if name.suffix == ".jsonl" else data for name, data in found.items()}


def main():
    folder = Path(tempfile.mkdtemp())
    server = subprocess.Popen(
        [sys.executable, "-c", SERVER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    try:
        cluster = ["--spark", f"sc://127.0.0.1:{server.stdout.readline().strip()}", "--python", sys.executable]
        nozzles = table(folder)
        here, there = folder / "here", folder / "there"
        begin = processor_s(server)
        here_s, _ = run("schedule", nozzles, "-o", here, "--post", "linuxcnc")
        between = processor_s(server)
        there_s, _ = run("schedule", nozzles, "-o", there, "--post", "linuxcnc", *cluster)
        here_cpu_s, there_cpu_s = between - begin, processor_s(server) - between
        ratio = there_s / here_s
        print(f"{ROWS} rows: {here_s:.1f} s here, {there_s:.1f} s on Sail on this computer, ratio {ratio:.3f}")
        print(f"processor time {here_cpu_s:.1f} s and {there_cpu_s:.1f} s, ratio {there_cpu_s / here_cpu_s:.3f}")
        check(files(here) == files(there), f"all {len(files(here))} files are equal, byte by byte")
        check(ratio <= MAX_RATIO, f"at most {MAX_RATIO} times as long")

        # Killed in the middle; then it goes on.
        killed = folder / "killed"
        command = [SEAMWRIGHT, "schedule", nozzles, "-o", killed, "--post", "linuxcnc", *cluster]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        journal = killed / "rows.jsonl"
        while not journal.exists() or journal.read_bytes().count(b"\n") < ROWS // 10:
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.wait()
        kept = journal.read_bytes().count(b"\n")
        run("schedule", nozzles, "-o", killed, "--post", "linuxcnc", *cluster)
        check(0 < kept < ROWS and files(here) == files(killed), f"killed after {kept} rows, resumed, and equal")

        draws = max(20, ROWS // 5)
        study = ["study", folder / "study.toml", "--draws", draws, "-o"]
        here_s, _ = run(*study, folder / "study-here")
        there_s, _ = run(*study, folder / "study-there", *cluster)
        print(f"{draws} draws: {here_s:.1f} s here, {there_s:.1f} s on Sail")
        check(files(folder / "study-here") == files(folder / "study-there"), "all files of the study are equal")
    finally:
        server.kill()
        shutil.rmtree(folder)
    sys.exit(failures > 0)


main()
