"""Machines: kinematics against each other, a closed form and the command line."""

import subprocess

import numpy as np
import pytest

import seamwright


@pytest.mark.parametrize("name", ["torch-5axis", "irb-2600", "ur10e"])
def test_every_branch_reaches_the_pose(name):
    machine = seamwright.Machine.load(name)
    start = [h + 5 for h in machine.home]
    pose = machine.forward(start)
    solutions = machine.inverse(pose, near=start)
    assert solutions
    for solution in solutions:
        back = machine.forward(solution.joints)
        assert np.linalg.norm(np.subtract(back.point, pose.point)) < 1e-6
        assert np.dot(back.direction, pose.direction) == pytest.approx(1, abs=1e-9)
    if not name.startswith("torch"):
        assert len(solutions) > 1
    nearest = min(solutions, key=lambda s: np.linalg.norm(np.subtract(s.joints, start)))
    assert nearest.joints == pytest.approx(start, abs=1e-6)
    assert machine.reach(pose, near=start)[0].in_range


def test_kinematics_are_those_of_the_command_line(program):
    machine = seamwright.Machine.load("torch-5axis")
    names = [axis.name for axis in machine.axes]
    rows = np.array(machine.home) + np.linspace(-3, 3, 5)[:, None]
    table = ",".join(names) + "\n" + "\n".join(",".join(map(repr, row.tolist())) for row in rows) + "\n"
    command = [program, "machine", "kinematics", "torch-5axis", "--forward"]
    output = subprocess.run(command, input=table, capture_output=True, text=True, check=True).stdout
    printed = np.loadtxt(output.splitlines()[1:], delimiter=",")
    assert np.allclose(machine.forward_table(rows), printed, rtol=0, atol=1e-9)


def test_the_first_axis_of_an_arm_turns_about_its_base():
    """Closed form: a quarter turn moves the tip by a quarter turn about a vertical line."""
    machine = seamwright.Machine.load("ur10e")
    back, front, left = (np.array(machine.forward([a, -60, 50, 0, 0, 0]).point) for a in (-90, 90, 0))
    centre = (back + front) / 2
    assert left - centre == pytest.approx([(front - centre)[1], -(front - centre)[0], 0], abs=1e-6)


def test_a_table_of_positions_gives_the_rows_of_single_ones():
    machine = seamwright.Machine.load("torch-5axis")
    rows = np.array(machine.home) + np.linspace(-3, 3, 7)[:, None]
    poses = machine.forward_table(rows)
    for row, pose in zip(rows, poses):
        one = machine.forward(row)
        assert np.array_equal(pose, one.point + one.direction)
    assert np.array_equal(machine.forward_table(rows.astype(np.float32).tolist()), machine.forward_table(rows.astype(np.float32)))


def test_unreachable_poses_and_wrong_arguments_are_exceptions():
    machine = seamwright.Machine.load("irb-2600")
    with pytest.raises(seamwright.InvalidInput) as caught:
        machine.inverse(seamwright.Pose([1e5, 0, 0], [0, 0, -1]))
    assert caught.value.code == "machine-unreachable-point"
    with pytest.raises(ValueError, match="6 finite numbers"):
        machine.forward([1, 2, 3])
    with pytest.raises(ValueError, match="direction"):
        seamwright.Pose([0, 0, 0], [0, 0, 0])
    with pytest.raises(seamwright.InvalidInput) as caught:
        seamwright.Machine.load("irb-2500")
    assert caught.value.code == "project-no-such-machine"
    with pytest.raises(seamwright.InvalidInput) as caught:
        seamwright.Machine.from_dict({"schema": 1})
    assert caught.value.file == "machine"


def test_lists_of_what_ships():
    assert "saddle" in seamwright.examples() and "ur10e" in seamwright.machines() and "fanuc-ls" in seamwright.posts()
    assert seamwright.LANGUAGES[0] == "en" and len(seamwright.LANGUAGES) == 5
    axis = seamwright.Machine.load("ur10e").axes[0]
    assert axis.unit == "deg" and axis.range and axis.max_speed > 0
