"""Areas of 1,000 random grooves by Shapely: the parts as solids cut by half-planes and discs, the groove as what is left.

Prints `tests/data/grooves.json`, which `crates/weld/src/joint/tests.rs` compares with. No edge is built here: a part is a
half-plane or a slab, its cuts are taken out, and the groove is the piece of air below the line from toe to toe.

Usage: grooves.py > tests/data/grooves.json      (needs Shapely)
"""

import json
import math
import random

from shapely.geometry import LineString, Point, Polygon
from shapely.ops import unary_union

FAR = 4000.0
CASES = 1000


def unit(angle):
    return math.cos(angle), math.sin(angle)


def half_plane(point, along):
    """The points on the left of the line through `point` along `along`."""
    (x, y), (c, s) = point, along
    a, b = (x - FAR * c, y - FAR * s), (x + FAR * c, y + FAR * s)
    return Polygon([a, b, (b[0] - FAR * s, b[1] + FAR * c), (a[0] - FAR * s, a[1] + FAR * c)])


def right_of(point, along):
    return half_plane(point, (-along[0], -along[1]))


def meet(p, d, q, e):
    """Where the lines through p along d and q along e meet."""
    t = ((q[0] - p[0]) * e[1] - (q[1] - p[1]) * e[0]) / (d[0] * e[1] - d[1] * e[0])
    return p[0] + t * d[0], p[1] + t * d[1]


def piece_with(shape, near):
    pieces = getattr(shape, "geoms", [shape])
    return min(pieces, key=lambda piece: piece.distance(Point(near)))


def cut_away(start, slope, radius, land, side):
    """What is cut off an edge whose root face ends at `start`: up (y) is across the wall in a butt joint's frame where
    the depth goes down and the part lies at `side` (1: x > 0). `slope` is the angle of the straight part from up."""
    x, y = start
    up = (side * math.sin(slope), math.cos(slope))
    below = half_plane if side > 0 else right_of
    if radius is None:
        return below((x, y), up).intersection(half_plane((x, y), (1.0, 0.0)))
    centre = (x + side * land, y + radius)
    tangent = (centre[0] + side * radius * math.cos(slope), centre[1] - radius * math.sin(slope))
    floor = half_plane((x, y), (1.0, 0.0))
    middle = below((centre[0], y), (0.0, 1.0)).intersection(floor)
    straight = below(tangent, up).intersection(half_plane(tangent, (1.0, 0.0)))
    return unary_union([middle, Point(centre).buffer(radius, quad_segs=2000), straight])


def butt(dihedral, thickness, gap, mismatch, sides):
    """`sides`: (root face, slope, radius, land) of the part at x > 0 and at x < 0; None: square."""
    half = 0.5 * dihedral
    metal, toes, roots, under = [], [], [], []
    for side, shift, edge in ((1, 0.0, sides[0]), (-1, mismatch, sides[1])):
        along = (side * math.sin(half), math.cos(half))
        out = (-side * math.cos(half), math.sin(half))
        origin = (0.0, shift)
        below = right_of(origin, along) if side > 0 else half_plane(origin, along)
        wall = (side * 0.5 * gap, 0.0)
        part = below.intersection(right_of(wall, (0.0, 1.0)) if side > 0 else half_plane(wall, (0.0, 1.0)))
        depth = lambda t: (origin[0] - t * out[0], origin[1] - t * out[1])
        roots.append(meet(wall, (0.0, 1.0), depth(thickness), along))
        if edge is None:
            toes.append(meet(wall, (0.0, 1.0), origin, along))
        else:
            root_face, slope, radius, land = edge
            start = meet(wall, (0.0, 1.0), depth(thickness - root_face), along)
            cut = cut_away(start, slope, radius, land, side)
            part = part.difference(cut)
            from_ = start
            if radius is not None:
                from_ = (start[0] + side * (land + radius * math.cos(slope)), start[1] + radius * (1 - math.sin(slope)))
            toes.append(meet(from_, (side * math.sin(slope), math.cos(slope)), origin, along))
        # The inside face begins beyond where the cut breaks through it; what is left before that falls off.
        x, y = depth(thickness)
        face = LineString([roots[-1], (x + FAR * along[0], y + FAR * along[1])])
        left = face if edge is None else face.difference(cut.buffer(-1e-7))
        roots[-1] = getattr(left, "geoms", [left])[-1].coords[0]
        inside = half_plane(depth(thickness), along) if side > 0 else right_of(depth(thickness), along)
        metal.append(part.intersection(inside))
        beyond = right_of(roots[-1], (0.0, 1.0)) if side > 0 else half_plane(roots[-1], (0.0, 1.0))
        under.append(beyond.difference(inside))
    chord = (toes[0][0] - toes[1][0], toes[0][1] - toes[1][1])
    size = math.hypot(*chord)
    air = right_of(toes[1], (chord[0] / size, chord[1] / size))
    # Below: the line from root to root.
    bottom = (roots[0][0] - roots[1][0], roots[0][1] - roots[1][1])
    size = math.hypot(*bottom)
    if size > 1e-6 and roots[0][0] - roots[1][0] > 1e-6:
        middle = half_plane(roots[0], (0.0, 1.0)).intersection(right_of(roots[1], (0.0, 1.0)))
        below = middle.intersection(right_of(roots[1], (bottom[0] / size, bottom[1] / size)))
        air = air.difference(below)
    # Beyond the toes a line from toe to toe that slants more than a face passes over it.
    air = air.intersection(half_plane(toes[0], (0.0, 1.0))).intersection(right_of(toes[1], (0.0, 1.0)))
    shape = air.difference(unary_union(metal + under))
    near = (0.5 * (roots[0][0] + roots[1][0]), max(roots[0][1], roots[1][1]) + (1.0 if gap == 0.0 else 1e-3))
    return piece_with(shape, near).area


def corner(dihedral, thickness, gap, leg, root_face, slope, radius=None, land=0.0):
    """An edge on the face y = 0, air above it, its part's outside rising from the origin at `dihedral` from +x."""
    up = unit(dihedral)
    normal = (-up[1], up[0])
    inside = (thickness * normal[0], thickness * normal[1])
    lifted = (gap * up[0], gap * up[1])
    slab = half_plane((0, 0), up).intersection(right_of(inside, up)).intersection(half_plane(lifted, (1.0, 0.0)))
    to = thickness - root_face
    start = meet((to * normal[0], to * normal[1]), up, lifted, (1.0, 0.0))
    # The edge lies along -x: as a butt's edge turned by a right angle, its depth to -x, square to the face +y.
    turn = lambda shape: Polygon([(y, x) for x, y in shape.exterior.coords])
    # In the turned frame x is square to the face, y is along it to the toe.
    cut = turn(cut_away((start[1], start[0]), slope, radius, land, 1))
    metal = slab.difference(cut)
    at = start
    if radius is not None:
        at = (start[0] + radius * (1 - math.sin(slope)), start[1] + land + radius * math.cos(slope))
    toe = meet(at, unit(slope), (0, 0), up)
    chord = (toe[0] - leg, toe[1])
    size = math.hypot(*chord)
    air = half_plane((0, 0), (1.0, 0.0)).intersection(right_of(inside, up))
    air = air.intersection(half_plane((leg, 0.0), (chord[0] / size, chord[1] / size)))
    shape = air.difference(metal)
    root = meet(inside, up, (0, 1e-4 * max(gap, 1e-3)), (1.0, 0.0))
    return piece_with(shape, root).area


def number(value):
    return float(f"{value:.6g}")


def case(rng):
    within = lambda low, high: number(rng.uniform(low, high))
    kind = rng.choice(["square", "single_v", "bevel", "u", "j", "t_bevel", "t_bevel", "t_bevel", "t_j", "fillet",
                       "flare_bevel", "flare_v"])
    t = within(3, 60)
    gap = rng.choice([0.0, within(0.5, 5)])
    c = number(t * rng.choice([0.0, rng.uniform(0.02, 0.5)]))
    mismatch = 0.0
    sizes = {"thickness_mm": t, "root_face_mm": c}
    if kind in ("square", "single_v", "bevel", "u", "j"):
        psi = rng.choice([180.0, within(122, 180)])
        mismatch = rng.choice([0.0, within(-0.2, 0.2) * number(min(t, 8.0))])
        mismatch = number(mismatch)
        dihedral = math.radians(psi)
        slope = within(2, 60)
        if kind == "square":
            gap = max(gap, 0.5)
            sizes = {"thickness_mm": t}
            sides = (None, None)
        elif kind == "single_v":
            sizes["angle_deg"] = slope
            sides = ((c, math.radians(slope) / 2, None, 0.0),) * 2
        elif kind == "bevel":
            sizes["angle_deg"] = slope
            sizes["prepared"] = rng.choice(["first", "second"])
            one = (c, math.radians(slope), None, 0.0)
            sides = (one, None) if sizes["prepared"] == "first" else (None, one)
        else:
            slope = within(1, 20)
            radius = within(0.2, 0.8) * (t - c)
            radius = number(min(radius, 10.0))
            land = rng.choice([0.0, within(0.2, 3)])
            sizes.update(angle_deg=slope, radius_mm=radius, land_mm=land)
            one = (c, math.radians(slope), radius, land)
            sides = (one, one)
            if kind == "j":
                sizes["prepared"] = rng.choice(["first", "second"])
                sides = (one, None) if sizes["prepared"] == "first" else (None, one)
        area = butt(dihedral, t, gap, mismatch, sides)
    elif kind in ("t_bevel", "t_j"):
        psi = within(35, 145)
        dihedral = math.radians(psi)
        leg = rng.choice([0.0, within(2, 12)])
        sizes["leg_mm"] = leg
        sizes["prepared"] = rng.choice(["first", "second"])
        if kind == "t_bevel":
            slope = within(15, min(60, psi - 8))
            sizes["angle_deg"] = slope
            if rng.random() < 0.5:
                del sizes["angle_deg"]
                sizes["cut_deg"] = number(slope - psi + 90)
                slope = sizes["cut_deg"] + psi - 90
            area = corner(dihedral, t, gap, leg, c, math.radians(slope))
        else:
            slope = within(1, 25)
            radius = number(min(within(0.2, 0.8) * (t - c), 10.0))
            land = rng.choice([0.0, within(0.2, 3)])
            sizes.update(angle_deg=slope, radius_mm=radius, land_mm=land)
            area = corner(dihedral, t, gap, leg, c, math.radians(slope), radius, land)
    elif kind == "fillet":
        psi = within(35, 160)
        first, second = within(2, 20), within(2, 20)
        sizes = {"first_leg_mm": first, "second_leg_mm": second}
        up = unit(math.radians(psi))
        first += gap
        area = Polygon([(0, 0), (second, 0), (first * up[0], first * up[1])]).area
    else:
        radius, psi = within(3, 40), 90.0 if kind == "flare_bevel" else 180.0
        gap, unfilled = 0.0, number(rng.choice([0.0, rng.uniform(0.05, 0.6)]) * radius)
        sizes = {"radius_mm": radius, "unfilled_mm": unfilled}
        disc = Point(radius, radius).buffer(radius, quad_segs=4000)
        corner_ = Polygon([(0, 0), (radius, 0), (radius, radius), (0, radius)]).difference(disc)
        one = corner_.intersection(right_of((0.0, radius - unfilled), (1.0, 0.0)))
        area = one.area * (2 if kind == "flare_v" else 1)
    body = ", ".join(f'{key} = {json.dumps(value)}' for key, value in sizes.items())
    return {"preparation": f"p.{kind} = {{ {body} }}", "dihedral_deg": psi, "gap_mm": gap, "mismatch_mm": mismatch,
            "area_mm2": float(f"{area:.8g}")}


def main():
    rng = random.Random(46)
    cases = []
    while len(cases) < CASES:
        made = case(rng)
        if made["area_mm2"] > 1.0:
            cases.append(made)
    print("[")
    print(",\n".join(json.dumps(made) for made in cases))
    print("]")


main()
