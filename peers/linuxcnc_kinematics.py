"""Our kinematics beside LinuxCNC's own modules, joint by joint.

LinuxCNC runs without hardware or window and is sent to 1,000 random poses a module (fixed seed); it turns each pose into
joints. We must agree within 1e-6 mm and degrees:
- our forward kinematics of its joints is the pose it was sent to;
- our inverse of that pose, with the torch's direction at its rotary words, is its joints (on its branch: the path is
  walked through from joint to joint in small steps with --continuous);
- at every tenth pose: moving back along our direction, LinuxCNC moves along the tool only.

Usage: linuxcnc_kinematics.py SEAMWRIGHT
"""

import csv
import io
import math
import random
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from linuxcnc_session import NotStarted, TooSlow, joints_at, python_of_linuxcnc

SEAMWRIGHT = sys.argv[1]

MACHINES = Path(__file__).resolve().parent / "machines"
POSES = 1000
SEED = 20
BOX_MM = 150.0
BACK_MM = 50.0
TOLERANCE = 1e-6
# Between poses; small enough that the nearest solution is on the same branch.
STEP_DEG = 30.0
STEP_MM = 100.0
# What can show that LinuxCNC is running already.
RUNNING = ["milltask", "rtapi_app", "linuxcncsvr"]

# A module's axes are its joints, in order; its pins say what the machine file says; rotary words are drawn up to +/- these.
# `back`: the joint that alone moves when the tip goes back along the tool, and by how much per mm: Z lifts a torch that
# never tilts; W makes the mill's tool shorter.
MODULES = {
    "xyzac-trt": {
        "kinematics": "xyzac-trt-kins", "axes": "XYZAC", "machine": "table-tilting-xyzac", "back": ("Z", 1.0),
        "pins": {"y-offset": 20, "z-offset": 10}, "rotary": {"A": 110, "C": 720},
    },
    "xyzbc-trt": {
        "kinematics": "xyzbc-trt-kins", "axes": "XYZBC", "machine": str(MACHINES / "xyzbc-trt.toml"), "back": ("Z", 1.0),
        "pins": {"x-rot-point": 30, "y-rot-point": -40, "z-rot-point": -120, "x-offset": 15, "z-offset": -25},
        "rotary": {"B": 110, "C": 360},
    },
    "5axiskins": {
        "kinematics": "5axiskins", "axes": "XYZBCW", "machine": str(MACHINES / "5axiskins.toml"), "back": ("W", -1.0),
        "pins": {"pivot-length": 250}, "rotary": {"B": 110, "C": 360},
    },
}


def kinematics(machine, way, columns, rows):
    """Rows of our `kinematics`, one call for all, as dictionaries of numbers."""
    text = ",".join(columns) + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows)
    done = subprocess.run([SEAMWRIGHT, "machine", "kinematics", machine, *way], input=text, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"seamwright machine kinematics: {done.stderr[-1000:]}")
    found = list(csv.DictReader(io.StringIO(done.stdout)))
    bad = [row["error"] for row in found if row.get("error")]
    if bad:
        raise RuntimeError(f"seamwright machine kinematics {' '.join(way)}: {len(bad)} rows refused, the first: {bad[0]}")
    return [{key: float(value) for key, value in row.items() if value} for row in found]


def walk(joints):
    """Joint positions from zero through all of `joints` in small steps, and where these are in it."""
    path, marks, here = [], [], [0.0] * len(joints[0])
    for goal in joints:
        change = [b - a for a, b in zip(here, goal)]
        steps = math.ceil(max(abs(d) / (STEP_MM if i < 3 else STEP_DEG) for i, d in enumerate(change)))
        path += [[a + d * n / steps for a, d in zip(here, change)] for n in range(1, steps + 1)]
        marks.append(len(path) - 1)
        here = goal
    return path, marks


def worst(pairs):
    """Greatest difference in pairs of rows."""
    return max(abs(a - b) for one, other in pairs for a, b in zip(one, other))


def compare(name, module, python):
    machine, axes, generator = module["machine"], module["axes"], random.Random(SEED)
    reach = [module["rotary"].get(axis, 0.0 if axis == "W" else BOX_MM) for axis in axes]
    poses = [[round(generator.uniform(-r, r), 9) for r in reach] for _ in range(POSES)]
    columns = [axis.lower() for axis in axes[:5]]
    turned = kinematics(machine, ["--forward"], columns, [[0.0] * 3 + pose[3:5] for pose in poses])
    directions = [[row[key] for key in ("ax", "ay", "az")] for row in turned]

    joint, per_mm = axes.index(module["back"][0]), module["back"][1]
    backs = []
    for pose, direction in list(zip(poses, directions))[::10]:
        tip = [round(p - BACK_MM * d, 9) for p, d in zip(pose, direction)]
        backs.append(tip + pose[3:5] + [-BACK_MM] * (len(axes) - 5))
    theirs = joints_at(module, poses + backs, python)
    theirs, theirs_back = theirs[:POSES], theirs[POSES:]
    want_back = [[q + BACK_MM * per_mm * (i == joint) for i, q in enumerate(row)] for row in theirs[::10]]

    path, marks = walk([row[:5] for row in theirs])
    keys = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az"]
    on_path = [[row[key] for key in keys] for row in kinematics(machine, ["--forward"], columns, path)]
    forward = worst((on_path[mark][:3], pose[:3]) for mark, pose in zip(marks, poses))
    # Between the poses our own path leads to LinuxCNC's branch; at them everything but the direction is its own.
    for mark, pose, direction in zip(marks, poses, directions):
        on_path[mark] = pose[:3] + direction
    found = kinematics(machine, ["--inverse", "--continuous"], keys, on_path)
    ours = [[found[mark][column] for column in columns] for mark in marks]
    linear = worst((mine[:3], row[:3]) for mine, row in zip(ours, theirs))
    rotary = worst((mine[3:], row[3:5]) for mine, row in zip(ours, theirs))
    back = worst(zip(theirs_back, want_back))
    good = max(forward, linear, rotary, back) <= TOLERANCE
    print(
        f"{'ok' if good else 'FAILED'}: {name}: {len(ours)} poses, forward {forward:.1e} mm, inverse {linear:.1e} mm and "
        f"{rotary:.1e} deg, {len(backs)} times back along the tool {back:.1e} mm", flush=True,
    )
    return good


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    python = python_of_linuxcnc()
    missing = [tool for tool in ("linuxcnc", "halrun") if not shutil.which(tool)]
    if missing or not python:
        print(f"SKIPPED: no {missing or 'Python module linuxcnc'}; kinematics were not compared with it", file=sys.stderr)
        return 0
    if subprocess.run(["pidof", *RUNNING], capture_output=True).returncode == 0:
        print("SKIPPED: LinuxCNC is running on this machine; kinematics were not compared with it", file=sys.stderr)
        return 0
    results, slow = [], []
    for name, module in MODULES.items():
        try:
            results.append(compare(name, module, python))
        except NotStarted as error:
            if not results:
                print(f"SKIPPED: LinuxCNC does not start here; kinematics were not compared with it:\n{error}", file=sys.stderr)
                return 0
            print(f"FAILED: {name}: LinuxCNC does not start with it:\n{error}", flush=True)
            results.append(False)
        except TooSlow as error:
            print(f"SKIPPED: {name}: this computer is too slow or too busy, nothing differs: {error}", file=sys.stderr)
            slow.append(name)
        except RuntimeError as error:
            print(f"FAILED: {name}: {error}", flush=True)
            results.append(False)
    left = f", {len(slow)} not compared: too slow here" if slow else ""
    print(f"LinuxCNC: {sum(results)} of {len(results)} kinematics modules agree{left}")
    return 0 if all(results) else 1


sys.exit(main())
