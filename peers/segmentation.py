"""One weld cut in segments of 2, 0.5 and 0.02 mm: our speed profile along taught points beside LinuxCNC in simulation.

The saddle of a nozzle of radius 25 on a shell of radius 60, one turn of C, the trunnion A at 20 sin(phi) degrees, 20 mm/s
asked; both get the same axis positions and the same limits of speed and acceleration. LinuxCNC gets its trivial
kinematics, so that the words are its joints, G64 (its fastest), and the time of every block (G93). Required of ours:
- durations of all three cuts within 0.1 %, so that the cut does not matter;
- speeds, accelerations and jerks of axes kept, by differences of the set-points from rest to rest;
- a mean speed of the tip no less than LinuxCNC's.

Usage: segmentation.py SEAMWRIGHT
"""

import csv
import io
import math
import shutil
import signal
import statistics
import subprocess
import sys
from pathlib import Path

from linuxcnc_session import NotStarted, TooSlow, joints_along, python_of_linuxcnc

SEAMWRIGHT = sys.argv[1]
MACHINE = Path(__file__).resolve().parent / "machines" / "segmentation-xyzac.toml"
STEPS_MM = [2.0, 0.5, 0.02]
ASKED_MM_S = 20.0
PERIOD_S = 1e-3
# As in the machine file; jerk is ten times the acceleration there.
LIMITS = {"X": (50, 500), "Y": (50, 500), "Z": (50, 500), "A": (60, 600), "C": (60, 600)}
SAME = 1e-3
# Rounding of set-points in the third difference.
KEPT = 1 + 1e-5
# How far (mm or deg) the last set-point may be from the end.
AT_END = 1e-3
# LinuxCNC's set-points are printed with six decimals.
AT_REST = 2e-6
# What can show that LinuxCNC is running already.
RUNNING = ["milltask", "rtapi_app", "linuxcncsvr"]


def place(phi):
    """Axis positions (mm, deg) that put the tip on the saddle at `phi`."""
    z = math.sqrt(60.0**2 - (25.0 * math.sin(phi)) ** 2)
    tilt = math.radians(20.0) * math.sin(phi)
    return [25.0, -z * math.sin(tilt), z * math.cos(tilt), math.degrees(tilt), math.degrees(phi)]


def tip(row):
    """The tip on the work of axis positions, both tables turned back."""
    x, y, z, a, c = row[:3] + [math.radians(angle) for angle in row[3:]]
    y, z = y * math.cos(a) + z * math.sin(a), z * math.cos(a) - y * math.sin(a)
    return [x * math.cos(c) + y * math.sin(c), y * math.cos(c) - x * math.sin(c), z]


def cut(step):
    """Axis positions every `step` mm along the seam and at its end, and the length of each segment."""
    points, lengths, way = [place(0.0)], [], 0.0
    fine, last = 200_000, tip(place(0.0))
    for i in range(1, fine + 1):
        phi = math.tau * i / fine
        here = tip(place(phi))
        way, last = way + math.dist(here, last), here
        if way >= step or i == fine:
            points.append(place(phi))
            lengths.append(way)
            way = 0.0
    return points, lengths


def program(points, lengths):
    """The weld as a part program, every block with the time it should take."""
    blocks = ["G21 G90 G64 G93"]
    for point, length in zip(points[1:], lengths):
        words = " ".join(f"{axis}{word:.9f}" for axis, word in zip(LIMITS, point))
        blocks.append(f"G1 {words} F{60 * ASKED_MM_S / length:.6f}")
    return "\n".join([*blocks, "G94", "M2", ""])


def ours(points):
    """Our set-points."""
    text = ",".join(LIMITS).lower() + "\n" + "".join(",".join(map(repr, point)) + "\n" for point in points)
    command = [SEAMWRIGHT, "tools", "follow", "-", "--machine", str(MACHINE), "--speed-mm-s", str(ASKED_MM_S)]
    done = subprocess.run([*command, "--period-ms", str(1e3 * PERIOD_S)], input=text, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"seamwright tools follow: {done.stderr[-1000:]}")
    return [[float(row[axis.lower()]) for axis in LIMITS] for row in csv.DictReader(io.StringIO(done.stdout))]


def moving(rows):
    """Set-points from the last one at rest at the start to the first one at rest at the end."""
    differs = [max(abs(x - y) for x, y in zip(a, b)) > AT_REST for a, b in zip(rows, rows[1:])]
    if True not in differs:
        raise RuntimeError("the set-points do not move")
    return rows[differs.index(True) : len(differs) - differs[::-1].index(True) + 1]


def figures(rows, order):
    """Duration, mean and median speed of the tip, and the greatest use of the limits of the first `order` derivatives."""
    weld = moving(rows)
    tips = [tip(row) for row in weld]
    steps = [math.dist(a, b) for a, b in zip(tips, tips[1:])]
    duration = PERIOD_S * len(steps)
    # At rest before and after.
    differences = [rows[0]] * 3 + rows + [rows[-1]] * 3
    used = []
    for k in range(order):
        differences = [[y - x for x, y in zip(a, b)] for a, b in zip(differences, differences[1:])]
        limits = [(speed, acceleration, 10 * acceleration)[k] for speed, acceleration in LIMITS.values()]
        used.append(max(abs(d) / m for row in differences for d, m in zip(row, limits)) / PERIOD_S ** (k + 1))
    return duration, sum(steps) / duration, statistics.median(steps) / PERIOD_S, used


def compare(step, python):
    """Our duration, and whether limits are kept and LinuxCNC is not faster."""
    points, lengths = cut(step)
    module = {"kinematics": "trivkins", "axes": "".join(LIMITS), "pins": {}, "limits": LIMITS}
    theirs = joints_along(module, points[0], program(points, lengths), python, points[-1])
    mine = ours(points)
    for name, rows in (("LinuxCNC", theirs), ("ours", mine)):
        if max(abs(x - y) for x, y in zip(rows[-1], points[-1])) > AT_END:
            raise RuntimeError(f"{name} ends at {rows[-1]}, not at {points[-1]}")
    mine, rival = figures(mine, 3), figures(theirs, 2)
    for name, (duration, mean, median, used) in (("LinuxCNC", rival), ("ours", mine)):
        print(
            f"{step:8} {len(lengths):7}  {name:9} {duration:8.3f} s {mean:7.2f} {median:8.2f} mm/s   "
            + " ".join(f"{u:7.4f}" for u in used), flush=True,
        )
    return mine[0], max(mine[3]) <= KEPT and mine[1] >= rival[1]


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    python = python_of_linuxcnc()
    missing = [tool for tool in ("linuxcnc", "halrun", "halsampler") if not shutil.which(tool)]
    why = None
    if missing or not python:
        why = f"no {missing or 'Python module linuxcnc'}"
    elif subprocess.run(["pidof", *RUNNING], capture_output=True).returncode == 0:
        why = "LinuxCNC is running on this machine"
    if why:
        print(f"SKIPPED: {why}; no weld in segments was compared with it", file=sys.stderr)
        return 0
    print(" segment  blocks             duration    mean   median tip   use of speed, acceleration, jerk")
    results = []
    for step in STEPS_MM:
        try:
            results.append(compare(step, python))
        except NotStarted as error:
            if not results:
                print(f"SKIPPED: LinuxCNC does not start here; no weld in segments was compared:\n{error}", file=sys.stderr)
                return 0
            print(f"FAILED: LinuxCNC does not start for {step} mm:\n{error}", flush=True)
            return 1
        except TooSlow as error:
            print(f"SKIPPED: {step} mm: this computer is too slow or too busy, nothing differs: {error}", file=sys.stderr)
        except RuntimeError as error:
            print(f"FAILED: {step} mm: {error}", flush=True)
            return 1
    if not results:
        return 0
    durations = [duration for duration, _ in results]
    spread = max(durations) / min(durations) - 1
    good = spread <= SAME and all(kept for _, kept in results)
    print(f"{'ok' if good else 'FAILED'}: segments: our durations within {100 * spread:.3f} %, limits and speeds as above")
    return 0 if good else 1


sys.exit(main())
