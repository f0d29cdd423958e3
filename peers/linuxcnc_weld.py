"""The whole LinuxCNC in simulation welds our post of the trunnion example; its joints, sampled in every servo period,
beside our plan.

It gets trivial kinematics, so that words are joints, and the machine's limits of speed and acceleration. Through our
forward kinematics its tip must stay within the post's tolerance and LinuxCNC's own blends of the planned path, and the
weld must take as long as planned.

Usage: linuxcnc_weld.py SEAMWRIGHT
"""

import csv
import io
import math
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from linuxcnc_session import NotStarted, TooSlow, joints_along, python_of_linuxcnc

SEAMWRIGHT = sys.argv[1]
JOB = Path(__file__).resolve().parent.parent / "examples" / "trunnion-saddle.toml"
MACHINE = "table-tilting-xyzac"
AXES = "XYZAC"
# The post's tolerance, which its blends are part of, and what six decimals and interpolation between samples add.
TOLERANCE_MM = 0.01
ROUNDED_MM = 2e-4
# LinuxCNC speeds up and slows down within its first and last blocks; the plan has a jerk limit.
TIME = 2e-3
PERIOD_S = 1e-3
EVERY = 5
# A place is looked for within this time of where it should be, s.
WINDOW_S = 0.5
# What can show that LinuxCNC is running already.
RUNNING = ["milltask", "rtapi_app", "linuxcncsvr"]


def run(*arguments, text=None):
    done = subprocess.run([SEAMWRIGHT, *map(str, arguments)], input=text, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"seamwright {arguments[0]}: {done.stderr[-1000:]}")
    return done.stdout


def tips(rows):
    """Torch tips of joints by our forward kinematics."""
    text = ",".join(AXES).lower() + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows)
    answer = csv.DictReader(io.StringIO(run("machine", "kinematics", MACHINE, "--forward", text=text)))
    return [[float(row[name]) for name in ("x_mm", "y_mm", "z_mm")] for row in answer]


def planned():
    """Joints of the plan in every servo period of the travel."""
    rows = csv.DictReader(io.StringIO(run("tools", "motion", JOB, "--period-ms", 1e3 * PERIOD_S)))
    rows = [(float(row["s_mm"]), [float(row[axis.lower()]) for axis in AXES]) for row in rows]
    last = max(i for i, row in enumerate(rows) if row[0] < rows[-1][0])
    first = max(i for i, row in enumerate(rows[:last]) if row[0] <= 0.0)
    return [row[1] for row in rows[first : last + 2]]


def away(point, line):
    """Distance of a point from a polyline."""
    nearest = math.inf
    for a, b in zip(line, line[1:]):
        along = [y - x for x, y in zip(a, b)]
        square = sum(x * x for x in along)
        part = sum(x * (p - q) for x, p, q in zip(along, point, a)) / square if square > 0 else 0.0
        part = min(max(part, 0.0), 1.0)
        nearest = min(nearest, math.dist(point, [q + part * x for q, x in zip(a, along)]))
    return nearest


def near(a, b):
    return max(abs(x - y) for x, y in zip(a, b)) < 1e-4


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    python = python_of_linuxcnc()
    missing = [tool for tool in ("linuxcnc", "halrun", "halsampler") if not shutil.which(tool)]
    if missing or not python or subprocess.run(["pidof", *RUNNING], capture_output=True).returncode == 0:
        print("SKIPPED: LinuxCNC is not installed, or runs already; no weld was compared with it", file=sys.stderr)
        return 0
    mine = planned()
    text = run("post", JOB, "--dialect", "linuxcnc", "--tolerance-mm", TOLERANCE_MM)
    limits = {axis: (1e3, 1e5) for axis in AXES}
    module = {"kinematics": "trivkins", "axes": AXES, "pins": {}, "limits": limits}
    try:
        theirs = joints_along(module, mine[0], text, python)
    except NotStarted as error:
        print(f"SKIPPED: LinuxCNC does not start: {error}", file=sys.stderr)
        return 0
    except TooSlow as error:
        print(f"SKIPPED: this computer is too slow or too busy, nothing differs: {error}", file=sys.stderr)
        return 0
    # Between the last rest at the start of the weld and the first at its end.
    begins = [i for i, row in enumerate(theirs) if near(row, mine[0])]
    ends = [i for i, row in enumerate(theirs) if near(row, mine[-1])]
    if not begins or not ends:
        raise RuntimeError("LinuxCNC was not at the start of the weld, or not at its end")
    first, last = max(begins), min(i for i in ends if i > max(begins))
    weld = theirs[first : last + 1]
    duration, asked = PERIOD_S * (len(weld) - 1), PERIOD_S * (len(mine) - 1)
    line, there = tips(mine), tips(weld[::EVERY])
    worst = 0.0
    for k, tip in enumerate(there):
        i = round(k * EVERY * (len(mine) - 1) / (len(weld) - 1))
        reach = round(WINDOW_S / PERIOD_S)
        worst = max(worst, away(tip, line[max(i - reach, 0) : i + reach + 1]))
    off = duration / asked - 1
    print(f"LinuxCNC welds the trunnion example: {len(weld)} set-points, tip at most {worst:.5f} mm from the plan "
          f"({TOLERANCE_MM} mm allowed), {duration:.3f} s for {asked:.3f} s planned ({100 * off:+.3f} %)")
    return 0 if worst <= TOLERANCE_MM + ROUNDED_MM and abs(off) < TIME else 1


sys.exit(main())
