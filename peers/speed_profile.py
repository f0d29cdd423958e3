"""Our speed profile next to toppra's, on the paths of tests/data/path_timing.json.

Speed and acceleration limits: our duration at 1000 cells must be within 0.1 % of toppra's on its finest grid. Both are timed
in this run, each the least of many; ours with jerk limits too, which toppra has not, on cells that the profile chooses and on
1000 even ones. What either needs to come within 0.1 % is printed too. The aim of at least 50 times less time is printed,
not enforced: a busy machine is no failure.

Usage: speed_profile.py PROFILE_TIMES (the built example `profile_times`)
"""

import json
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import toppra
from scipy.interpolate import PPoly

toppra.setup_logging("ERROR")
ROOT = Path(__file__).resolve().parent.parent
PATHS = json.loads((ROOT / "tests/data/path_timing.json").read_text())["paths"]
TOLERANCE = 1e-3
REPEATS = 20
COUNTS = (100, 200, 400, 1000, 2000)


class Spline(toppra.interpolator.AbstractGeometricPath):
    """Piecewise cubics given by their coefficients."""

    def __init__(self, path):
        # (segments, powers, axes) to (powers, segments, axes).
        self.poly = PPoly(np.array(path["coefficients_highest_first"]).transpose(1, 0, 2), np.array(path["knots"]))

    @property
    def dof(self):
        return self.poly.c.shape[2]

    @property
    def path_interval(self):
        return np.array([self.poly.x[0], self.poly.x[-1]])

    @property
    def waypoints(self):
        return None

    def __call__(self, s, order=0):
        return self.poly(s, order)


def solve(path, count):
    """Duration, and the least time of some solutions."""
    speed, acceleration = np.array(path["max_speed"]), np.array(path["max_acceleration"])
    least, duration = float("inf"), None
    for _ in range(REPEATS):
        spline = Spline(path)
        limits = [
            toppra.constraint.JointVelocityConstraint(np.stack([-speed, speed], axis=1)),
            toppra.constraint.JointAccelerationConstraint(
                np.stack([-acceleration, acceleration], axis=1),
                discretization_scheme=toppra.constraint.DiscretizationType.Interpolation,
            ),
        ]
        grid = np.linspace(*spline.path_interval, count + 1)
        begin = time.perf_counter()
        solver = toppra.algorithm.TOPPRA(limits, spline, gridpoints=grid, solver_wrapper="seidel")
        _, speeds, _ = solver.compute_parameterization(0, 0)
        least = min(least, time.perf_counter() - begin)
        duration = float(np.sum(2 * np.diff(grid) / (speeds[1:] + speeds[:-1])))
    return duration, least


ours = json.loads(subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout)
good = 0
for number, (path, own) in enumerate(zip(PATHS, ours)):
    best = path["duration_s_grid_4000"]
    theirs = {count: solve(path, count) for count in COUNTS}
    for count in (100, 1000):
        duration, taken = theirs[count]
        mine = own["by_cells"][str(count)]
        print(
            f"path {number}, {len(path['max_speed'])} axes, N = {count}: toppra {duration:.4f} s in {1e3 * taken:.2f} ms; "
            f"ours {mine['duration_s']:.4f} s in {1e3 * mine['time_s']:.3f} ms, {taken / mine['time_s']:.0f} times less; "
            f"by toppra's finest grid {100 * (duration / best - 1):+.3f} % and {100 * (mine['duration_s'] / best - 1):+.3f} %"
        )
    near = lambda duration: duration / best - 1 <= TOLERANCE
    enough = [(n, taken) for n, (duration, taken) in theirs.items() if near(duration)]
    own_enough = [(int(n), law["time_s"]) for n, law in own["by_cells"].items() if near(law["duration_s"])]
    if enough and own_enough:
        (n, taken), (own_n, own_taken) = min(enough), min(own_enough)
        print(
            f"  for 0.1 % of the finest grid toppra takes N = {n} and {1e3 * taken:.2f} ms, ours {own_n} cells and "
            f"{1e3 * own_taken:.3f} ms, {taken / own_taken:.0f} times less"
        )
    for jerk in (own["jerk"], own["jerk_finely"]):
        print(
            f"  with jerk limits, which toppra has not, on {jerk['cells']} cells: "
            f"{jerk['duration_s']:.4f} s in {1e3 * jerk['time_s']:.1f} ms"
        )
    good += abs(own["by_cells"]["1000"]["duration_s"] / best - 1) <= TOLERANCE
print(f"{'ok' if good == len(PATHS) else 'FAILED'}: toppra: {good} of {len(PATHS)} durations within 0.1 % of its finest grid")
sys.exit(0 if good == len(PATHS) else 1)
