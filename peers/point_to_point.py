"""Our point-to-point motion beside Ruckig's community version (MIT), from random states to rest.

For every number of axes from 3 to 7, half of the cases from rest, half from a moving state within the limits. Required:
- durations agree within 1e-6 of themselves (both are the least time in which all axes arrive at once);
- ours stays within the limits and ends at the target.
The times of planning are measured in the same run, each the best of five, and printed as a ratio.

Usage: point_to_point.py PROGRAM (of peers/point-to-point)
"""

import random
import subprocess
import sys
import time

try:
    import ruckig
except ImportError:
    print("SKIPPED: the Python package ruckig is not installed; nothing was compared with it", file=sys.stderr)
    sys.exit(0)

CASES = 400
SEED = 4
TOLERANCE = 1e-6


def case(rng, axes, moving):
    """Rows of position, speed, acceleration, target, highest speed, acceleration and jerk."""
    rows = []
    for _ in range(axes):
        v, a = 10 ** rng.uniform(0, 2.5), 10 ** rng.uniform(1, 3.5)
        j = a * 10 ** rng.uniform(0.3, 2)
        speed = rng.uniform(-0.9, 0.9) * v if moving else 0.0
        # No more than lets the highest speed not be passed.
        room = min(a, (2 * j * (v - abs(speed))) ** 0.5)
        acceleration = rng.uniform(-0.9, 0.9) * room if moving else 0.0
        q = rng.uniform(-500, 500)
        rows.append([q, speed, acceleration, q + rng.choice([-1, 1]) * 10 ** rng.uniform(-2, 3), v, a, j])
    return rows


def theirs(rows):
    """Duration (s) and time of planning (us) of Ruckig."""
    axes = len(rows)
    otg, given, found = ruckig.Ruckig(axes), ruckig.InputParameter(axes), ruckig.Trajectory(axes)
    columns = list(zip(*rows))
    given.current_position, given.current_velocity, given.current_acceleration = columns[0], columns[1], columns[2]
    given.target_position = columns[3]
    given.max_velocity, given.max_acceleration, given.max_jerk = columns[4], columns[5], columns[6]
    best = float("inf")
    for _ in range(5):
        start = time.perf_counter()
        result = otg.calculate(given, found)
        best = min(best, (time.perf_counter() - start) * 1e6)
    return (found.duration if result == ruckig.Result.Working else None), best


def main():
    rng = random.Random(SEED)
    failed = False
    for axes in range(3, 8):
        cases = [case(rng, axes, k % 2 == 1) for k in range(CASES)]
        text = "".join(",".join(repr(x) for row in rows for x in row) + "\n" for rows in cases)
        run = subprocess.run([sys.argv[1]], input=text, capture_output=True, text=True)
        if run.returncode != 0:
            print(f"FAILED: point to point, {axes} axes: {run.stderr.strip()}")
            return 1
        ours = [[float(x) for x in line.split(",")] for line in run.stdout.splitlines()]
        worst, unlike, refused, times = 0.0, 0, 0, []
        for mine, rows in zip(ours, cases, strict=True):
            duration, taken = theirs(rows)
            if duration is None:
                refused += 1
                continue
            off = abs(mine[0] - duration) / duration
            worst, unlike = max(worst, off), unlike + (off > TOLERANCE)
            times.append((mine[3], taken))
        most, off = max(m[1] for m in ours), max(m[2] for m in ours)
        bad = unlike > 0 or most > 1 + 1e-6 or off > 1e-6 or refused > 0
        failed |= bad
        mean = [sum(t[i] for t in times) / max(len(times), 1) for i in (0, 1)]
        print(
            f"{'FAILED' if bad else 'ok'}: point to point, {axes} axes, {CASES} cases: durations agree within {worst:.1e} "
            f"({unlike} do not, {refused} refused by Ruckig); limits used to {most:.9f}, ends within {off:.0e}; planning "
            f"{mean[0]:.1f} us, Ruckig through Python {mean[1]:.1f} us: {mean[1] / mean[0]:.2f} times ours"
        )
    return 1 if failed else 0


sys.exit(main())
