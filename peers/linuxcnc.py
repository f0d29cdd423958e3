"""Every posted example through LinuxCNC's own interpreter.

`rs274 -g` must accept the program; its path, integrated by its own feeds, must take as long as planned (0.1 %); and
every point it reaches must lie on our set-points (1e-4 mm or degrees; it prints four decimals).

Usage: linuxcnc.py SEAMWRIGHT
"""

import csv
import io
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SEAMWRIGHT = sys.argv[1]
ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = [(path.stem, "joint") for path in sorted((ROOT / "examples").glob("*.toml"))] + [("trunnion-saddle", "tip")]
TIME_TOLERANCE = 1e-3
POINT_TOLERANCE = 1e-4


def seamwright(*arguments):
    return subprocess.run([SEAMWRIGHT, *arguments], check=True, capture_output=True, text=True).stdout


def canonical(program):
    """What the interpreter makes of a part program: list of (function, numbers)."""
    with tempfile.NamedTemporaryFile("w", suffix=".ngc") as file:
        file.write(program)
        file.flush()
        done = subprocess.run(["rs274", "-g", file.name], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"rs274 refuses the program (rc {done.returncode}):\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    calls = []
    for line in done.stdout.splitlines():
        match = re.search(r"([A-Z_0-9]+)\(([^\"]*)\)\s*$", line)
        if match:
            numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*", match.group(2))]
            name = match.group(1)
            calls.append((name + match.group(2)[-2:] if name == "SELECT_PLANE" else name, numbers))
    return calls


def block_length(a, b):
    """Length that LinuxCNC's feed counts: of X Y Z if they move, else of A B C."""
    linear = math.dist(a[:3], b[:3])
    return linear if linear > 0 else math.dist(a[3:6], b[3:6])


# Places of the two axes of each plane and of the one square to it, in the interpreter's order.
PLANES = {"XY": (0, 1, 2), "YZ": (1, 2, 0), "XZ": (2, 0, 1)}


def arc_feed(here, plane, numbers):
    """End of an arc or helix, and its length."""
    u, v, w = PLANES[plane]
    end_u, end_v, centre_u, centre_v, turns, end_w = numbers[:6]
    end = list(here)
    end[u], end[v], end[w] = end_u, end_v, end_w
    end[3:] = numbers[6 : 6 + len(end) - 3]
    radius = math.hypot(here[u] - centre_u, here[v] - centre_v)
    begin = math.atan2(here[v] - centre_v, here[u] - centre_u)
    angle = math.atan2(end_v - centre_v, end_u - centre_u) - begin
    angle = angle % math.tau + math.tau * (turns - 1) if turns > 0 else -(-angle % math.tau) + math.tau * (turns + 1)
    return end, math.hypot(radius * angle, end_w - here[w])


def arc_path(calls):
    """Points with their times while output 0 (the arc) is on, and the time it is on."""
    feed, here, time, on, plane = 0.0, None, 0.0, False, "XY"
    points = []
    for name, numbers in calls:
        if name == "SET_FEED_RATE":
            feed = numbers[0]
        elif name in ("SET_AUX_OUTPUT_BIT", "SET_MOTION_OUTPUT_BIT") and numbers == [0]:
            on = True
        elif name in ("CLEAR_AUX_OUTPUT_BIT", "CLEAR_MOTION_OUTPUT_BIT") and numbers == [0]:
            on = False
        elif name == "DWELL" and on:
            time += numbers[0]
        elif name.startswith("SELECT_PLANE"):
            plane = name[-2:]
        elif name == "ARC_FEED":
            here, length = arc_feed(here, plane, numbers)
            if on:
                time += length / feed * 60
                points.append((time, here))
        elif name in ("STRAIGHT_FEED", "STRAIGHT_TRAVERSE"):
            if on:
                # Feeds are printed with four decimals.
                time += block_length(here, numbers) / feed * 60
                points.append((time, numbers))
            here = numbers
    return points, time


def planned(job, columns):
    """Our set-points while the arc is on: times from its start and positions in the order of LinuxCNC's words."""
    rows = csv.DictReader(io.StringIO(seamwright("tools", "motion", job, "--period-ms", "1")))
    arc = [row for row in rows if row["arc"] == "1"]
    # Of several passes only the time with the arc on counts.
    return [(1e-3 * i, [float(r[c]) if c else 0.0 for c in columns]) for i, r in enumerate(arc)]


def off(point, a, b):
    """Greatest difference (mm or deg) of a point from the straight line between two set-points, at its nearest place."""
    d = [y - x for x, y in zip(a, b)]
    square = sum(x * x for x in d)
    f = 0.0 if square == 0 else sum((p - x) * y for p, x, y in zip(point, a, d)) / square
    f = min(1.0, max(0.0, f))
    return max(abs(p - x - f * y) for p, x, y in zip(point, a, d))


def tips(job, machine, rows, names):
    """The tip positions of joint rows, by our forward kinematics."""
    text = ",".join(names) + "\n" + "\n".join(",".join(repr(v) for v in row) for row in rows) + "\n"
    done = subprocess.run([SEAMWRIGHT, "machine", "kinematics", machine, "--forward"], input=text, check=True, capture_output=True, text=True)
    return [[float(r[c]) for c in ("x_mm", "y_mm", "z_mm")] for r in csv.DictReader(io.StringIO(done.stdout))]


def compare(name, level):
    job = str(ROOT / "examples" / f"{name}.toml")
    done = subprocess.run([SEAMWRIGHT, "post", job, "--dialect", "linuxcnc", "--level", level], capture_output=True, text=True)
    if done.returncode == 2 and "letter" in done.stderr:
        print(f"left out: {name}: its machine has axes that LinuxCNC has no letters for")
        return None
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    program = done.stdout
    axes = dict(re.findall(r"([XYZABC]) = (\w+) \[", program))
    columns = [axes.get(letter) for letter in "XYZABC"]
    with tempfile.TemporaryDirectory() as folder:
        report = json.loads(seamwright("plan", job, "-o", folder, "--json"))
    points, time = arc_path(canonical(program))
    path = planned(job, columns)
    if level == "tip":
        machine = report["machine"]["name"]
        names = [n for n in columns if n]
        rows = [[p[i] for i, n in enumerate(columns) if n] for _, p in path]
        path = [(t, tip + p[3:]) for (t, p), tip in zip(path, tips(job, machine, rows, names))]
    worst = 0.0
    for t, point in points:
        # The set-points within 80 ms of the interpreter's time hold the point.
        at = min(range(len(path)), key=lambda i: abs(path[i][0] - t)) if len(path) < 2 else int(t * 1000)
        window = path[max(0, at - 80) : at + 82]
        worst = max(worst, min(off(point, a[1], b[1]) for a, b in zip(window, window[1:])))
    want = sum(figures["plan"]["arc_on_s"] for figures in report["passes"])
    error = abs(time - want) / want
    good = error <= TIME_TOLERANCE and worst <= POINT_TOLERANCE
    word = "ok" if good else "FAILED"
    print(f"{word}: {name} ({level}): {len(points)} blocks, arc on {time:.4f} s (planned {want:.4f}, {100 * error:.4f} % off), points {worst:.1e} off")
    return good


results = [good for name, level in EXAMPLES if (good := compare(name, level)) is not None]
print(f"LinuxCNC: {sum(results)} of {len(results)} programs agree")
sys.exit(0 if all(results) else 1)
