"""Compares arms with Pinocchio: forward and inverse kinematics on the same URDF, 10,000 random positions each.

Usage: arms.py SEAMWRIGHT [POSITIONS]. Needs the packages `pin` and `numpy`.

Descriptions of the supplied arms are written here from their machine files, read without Seamwright; those in tests/data of
the crate `machine` are used as they are. Each is imported by `seamwright machine import`, so that both programs read the
same file.
"""

import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import numpy as np
import pinocchio as pin

LIMIT_MM = 1e-9
LIMIT_DEG = 1e-9
ROOT = Path(__file__).resolve().parent.parent
ARMS = ["ur10e", "irb-2600", "kr-16", "arc-mate-120id", "ar1440", "iiwa-14", "irb-2600-rail"]
# Not ur10e.urdf: its angles have ten digits, and the import reads them as right angles, 1e-7 mm from what is written.
DATA = ["kuka_kr16_2"]


def rotation(axis, angle):
    axis = np.array(axis, float) / np.linalg.norm(axis)
    return pin.AngleAxis(angle, axis).toRotationMatrix()


def urdf(machine):
    """A URDF of the tool steps of a machine file: every joint frame parallel to the base, as the file has them."""
    lines, link, at = [], 0, np.zeros(3)
    lines.append('<robot name="arm"><link name="link_0"/>')
    turned = np.eye(3)
    for step in machine["tool"]:
        parent, link = link, link + 1
        if "axis" in step:
            assert np.array_equal(turned, np.eye(3)), "an axis behind a turned frame"
            is_rotary = "turn" in step
            # The joint is at the axis; the next frame counts from there.
            place = np.array(step.get("at_mm", at), float) if is_rotary else at
            low, high = step["range_deg" if is_rotary else "range_mm"]
            unit = np.pi / 180 if is_rotary else 1e-3
            speed = step["max_speed_deg_s" if is_rotary else "max_speed_mm_s"]
            direction = " ".join(repr(float(v)) for v in step["turn" if is_rotary else "move"])
            kind = "revolute" if is_rotary else "prismatic"
            limits = f'<limit lower="{low * unit!r}" upper="{high * unit!r}" velocity="{speed * unit!r}" effort="0"/>'
            joint = (kind, place - at, np.zeros(3), f'<axis xyz="{direction}"/>{limits}')
            at = place
        else:
            fixed = step["fixed"]
            move = np.array(fixed.get("move_mm", [0, 0, 0]), float)
            matrix = rotation(fixed.get("turn", [0, 0, 1]), np.radians(fixed.get("angle_deg", 0.0)))
            joint = ("fixed", turned.T @ (move - at) if np.array_equal(turned, np.eye(3)) else move, pin.rpy.matrixToRpy(matrix), "")
            turned = turned @ matrix
            at = np.zeros(3)
        kind, xyz, rpy, inner = joint
        xyz = " ".join(repr(float(v)) for v in xyz * 1e-3)
        rpy = " ".join(repr(float(v)) for v in rpy)
        lines.append(f'<link name="link_{link}"/><joint name="{step.get("axis", f"fixed_{link}")}" type="{kind}">')
        lines.append(f'<parent link="link_{parent}"/><child link="link_{link}"/><origin xyz="{xyz}" rpy="{rpy}"/>{inner}</joint>')
    return "\n".join(lines) + "</robot>\n"


def run(seamwright, machine, options, header, rows):
    text = header + "\n" + "\n".join(",".join(repr(float(v)) for v in row) for row in rows) + "\n"
    command = [seamwright, "machine", "kinematics", str(machine), *options]
    out = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout.splitlines()
    return out[0].split(","), [line.split(",") for line in out[1:]]


def deviations(model, frame, joints, poses):
    """Largest deviation of points (mm) and of directions z and x (degrees) from Pinocchio's frames."""
    data, point, angle = model.createData(), 0.0, 0.0
    for q, pose in zip(joints, poses):
        pin.framesForwardKinematics(model, data, q)
        placement = data.oMf[frame]
        point = max(point, np.linalg.norm(1e3 * placement.translation - pose[:3]))
        for ours, theirs in ((pose[3:6], placement.rotation[:, 2]), (pose[6:9], placement.rotation[:, 0])):
            sine = np.linalg.norm(np.cross(ours, theirs))
            angle = max(angle, np.degrees(np.arctan2(sine, ours @ theirs)))
    return point, angle


def compare(seamwright, name, description, tip, folder, count):
    file = folder / f"{name}.toml"
    subprocess.run([seamwright, "machine", "import", str(description), "--no-shapes", "-o", str(file)], check=True, capture_output=True)
    model = pin.buildModelFromUrdf(str(description))
    frame = model.getFrameId(tip)
    random = np.random.default_rng(1)
    joints = random.uniform(model.lowerPositionLimit, model.upperPositionLimit, (count, model.nq))
    axes = tomllib.loads(file.read_text())["tool"]
    kinds = ["turn" in step for step in axes if "axis" in step]
    units = np.array([180 / np.pi if is_rotary else 1e3 for is_rotary in kinds])
    names = [step["axis"] for step in axes if "axis" in step]
    _, rows = run(seamwright, file, ["--forward", "--frame"], ",".join(names), joints * units)
    poses = np.array(rows, float)
    forward = deviations(model, frame, joints, poses)
    if not all(kinds):
        # A rail stays at home in the inverse, so that most of these poses are out of reach.
        good = forward[0] <= LIMIT_MM and forward[1] <= LIMIT_DEG
        print(f"  {name:16} forward {forward[0]:.1e} mm {forward[1]:.1e} deg   {'ok' if good else 'FAILED'}")
        return good
    header = "x_mm,y_mm,z_mm,ax,ay,az,ux,uy,uz"
    columns, rows = run(seamwright, file, ["--inverse", "--frame", "--branches"], header, poses)
    error = columns.index("error")
    found = [row for row in rows if row[1] != ""]
    solved = np.array([row[1:error] for row in found], float) / units
    wanted = poses[[int(float(row[0])) - 1 for row in found]]
    inverse = deviations(model, frame, solved, wanted)
    missing = count - len({row[0] for row in found})
    good = max(forward[0], inverse[0]) <= LIMIT_MM and max(forward[1], inverse[1]) <= LIMIT_DEG and missing == 0
    print(f"  {name:16} forward {forward[0]:.1e} mm {forward[1]:.1e} deg   inverse {inverse[0]:.1e} mm {inverse[1]:.1e} deg, "
          f"{len(found)} branches of {count} poses, {missing} without   {'ok' if good else 'FAILED'}")
    return good


def main():
    seamwright, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10_000
    print(f"Pinocchio {pin.__version__}: {count} random positions of each arm")
    good = True
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for name in ARMS:
            machine = tomllib.loads((ROOT / "machines" / f"{name}.toml").read_text())
            description = folder / f"{name}.urdf"
            description.write_text(urdf(machine))
            good &= compare(seamwright, name, description, f"link_{len(machine['tool'])}", folder, count)
        for name in DATA:
            description = ROOT / "crates/machine/tests/data" / f"{name}.urdf"
            good &= compare(seamwright, f"{name}.urdf", description, "tool0", folder, count)
    sys.exit(0 if good else 1)


main()
