"""Our follower against other ways to find a dark line, on the same simulated frames with the same start.

EBW-2004's region growing (ours, in Rust), and with OpenCV: adaptive threshold and the component at the start, the
smallest-scale ridge of the Hessian followed from the start, and Steger's lines. Printed: rows off by more than 2 px of
all rows given, the median error, the part of the joint that is reached, and milliseconds. The peers have no confidence:
every row of theirs counts; of ours the confident ones and all.

Fails if ours has more wrong confident rows than any peer has wrong rows, on any kind of frame.

Usage: vision.py DIRECTORY (written by the example joint_scenes)
"""

import math
import sys
import time
from collections import defaultdict
from pathlib import Path

import cv2
import numpy as np

WRONG = 2.0


def read(path):
    scene = defaultdict(list)
    for line in path.read_text().splitlines():
        key, *numbers = line.split()
        scene[key].append([float(n) for n in numbers])
    return scene


def threshold(grey, scene):
    """Middle of the component at the start of what is darker than its surroundings, along the longer side."""
    dark = cv2.adaptiveThreshold(grey, 255, cv2.ADAPTIVE_THRESH_MEAN_C, cv2.THRESH_BINARY_INV, 51, 10)
    count, labels = cv2.connectedComponents(dark)
    x, y, _ = scene["start"][0]
    near = labels[max(int(y) - 4, 0) : int(y) + 5, max(int(x) - 4, 0) : int(x) + 5]
    near = near[near > 0]
    if near.size == 0:
        return []
    ys, xs = np.nonzero(labels == np.bincount(near).argmax())
    rows = defaultdict(list)
    upright = np.ptp(ys) > np.ptp(xs)
    for px, py in zip(xs, ys):
        rows[py if upright else px].append(px if upright else py)
    return [(np.mean(v), k) if upright else (k, np.mean(v)) for k, v in rows.items()]


def derivatives(grey, sigma):
    smooth = cv2.GaussianBlur(grey.astype(np.float32), (0, 0), sigma)
    dx, dy = cv2.Sobel(smooth, cv2.CV_32F, 1, 0, scale=1 / 8), cv2.Sobel(smooth, cv2.CV_32F, 0, 1, scale=1 / 8)
    xx, yy = cv2.Sobel(smooth, cv2.CV_32F, 2, 0, scale=1 / 4), cv2.Sobel(smooth, cv2.CV_32F, 0, 2, scale=1 / 4)
    return dx, dy, xx, yy, cv2.Sobel(smooth, cv2.CV_32F, 1, 1, scale=1 / 4)


def strongest(xx, yy, xy):
    """The greater eigenvalue of the Hessian and its direction: across a dark line."""
    half, difference = (xx + yy) / 2, (xx - yy) / 2
    root = np.hypot(difference, xy)
    angle = 0.5 * np.arctan2(2 * xy, xx - yy)
    return half + root, angle


def follow(strength, scene, refine=lambda x, y: (x, y)):
    """Pixel steps along the greatest strength ahead, as long as there is any."""
    x, y, heading = scene["start"][0]
    height, width = strength.shape
    least = 0.25 * np.percentile(strength, 99)
    places = []
    while 1 <= x < width - 1 and 1 <= y < height - 1 and len(places) < 4 * width:
        best = max(
            (strength[round(y + 2 * math.sin(a)) % height, round(x + 2 * math.cos(a)) % width], a)
            for a in heading + np.linspace(-0.6, 0.6, 9)
        )
        if best[0] < least:
            break
        heading += 0.3 * (best[1] - heading)
        x, y = x + 2 * math.cos(best[1]), y + 2 * math.sin(best[1])
        places.append(refine(x, y))
    return places


def hessian(grey, scene):
    _, _, xx, yy, xy = derivatives(grey, 2.0)
    return follow(strongest(xx, yy, xy)[0], scene)


def steger(grey, scene):
    """Steger 1998: the place between pixels where the first derivative across is none; the width is told."""
    dx, dy, xx, yy, xy = derivatives(grey, max(scene["width"][0][0] / (2 * math.sqrt(3)), 1.0))
    value, angle = strongest(xx, yy, xy)
    nx, ny = np.cos(angle), np.sin(angle)
    t = -(dx * nx + dy * ny) / np.maximum(value, 1e-6)
    height, width = grey.shape

    def refine(x, y):
        i, j = min(round(y), height - 1), min(round(x), width - 1)
        step = float(np.clip(t[i, j], -3, 3))
        return x + step * float(nx[i, j]), y + step * float(ny[i, j])

    return follow(value, scene, refine)


def score(places, scene):
    """Errors outside tacks, and the part of the joint that is reached."""
    truth = np.array(scene["truth"])
    # A wide joint's midline goes on beyond the rim.
    truth = truth[((truth >= 0) & (truth <= 511)).all(axis=1)]
    errors, reached = [], 0
    for x, y in places:
        if any(math.hypot(x - tx, y - ty) < r + 2 for tx, ty, r in scene["tack"]):
            continue
        distances = np.hypot(truth[:, 0] - x, truth[:, 1] - y)
        at = int(distances.argmin())
        errors.append(float(distances[at]))
        if errors[-1] <= WRONG:
            reached = max(reached, at)
    return errors, reached / max(len(truth) - 1, 1)


def main():
    results = defaultdict(lambda: defaultdict(lambda: ([], [], [])))
    for path in sorted(Path(sys.argv[1]).glob("*.txt")):
        scene = read(path)
        grey = cv2.imread(str(path.with_suffix(".pgm")), cv2.IMREAD_GRAYSCALE)
        kind = path.stem.rsplit("-", 1)[0]
        ours = scene["ours"]
        found = {
            "ours, confident": ([r[:2] for r in ours if r[2]], scene["ms"][0][0]),
            "ours, all": ([r[:2] for r in ours], scene["ms"][0][0]),
            "region growing": (scene["growth"], scene["ms"][0][1]),
        }
        for name, peer in (("threshold", threshold), ("Hessian", hessian), ("Steger", steger)):
            begun = time.perf_counter()
            places = peer(grey, scene)
            found[name] = (places, 1e3 * (time.perf_counter() - begun))
        for name, (places, ms) in found.items():
            errors, reach = score(places, scene)
            all_errors, reaches, times = results[kind][name]
            all_errors.extend(errors)
            reaches.append(reach)
            times.append(ms)
    if not results:
        raise SystemExit("no frames: run the example joint_scenes first")
    bad = []
    print(f"{'':24} {'> 2 px':>8} {'median':>8} {'reach':>7} {'lost':>6} {'ms':>8}")
    for kind, methods in results.items():
        print(kind)
        wrong = {}
        for name, (errors, reaches, times) in methods.items():
            wrong[name] = 100 * np.mean(np.array(errors) > WRONG) if errors else 100.0
            median = np.median(errors) if errors else math.nan
            lost = sum(r < 0.95 for r in reaches)
            print(
                f"  {name:22} {wrong[name]:7.2f}% {median:7.2f} {100 * np.mean(reaches):6.1f}% "
                f"{lost:3}/{len(reaches)} {np.median(times):8.2f}"
            )
        best = min(value for name, value in wrong.items() if not name.startswith("ours"))
        if wrong["ours, confident"] > best:
            bad.append(kind)
    if bad:
        raise SystemExit(f"a peer has fewer wrong rows than ours on: {', '.join(bad)}")


main()
