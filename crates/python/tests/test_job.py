"""Jobs: read from files, texts and dictionaries; planned; refused."""

import json
import signal
import subprocess
import threading
import time

import numpy as np
import pytest

import seamwright
from conftest import ROOT

LONG = ROOT / "tests/data/field-trial/u3.toml"


def test_a_dictionary_gives_the_same_plan_as_its_file():
    job = seamwright.Job.load("saddle")
    again = seamwright.Job.from_dict(job.to_dict())
    assert again.to_dict() == job.to_dict()
    plan, same = job.plan(), again.plan()
    assert np.array_equal(plan.set_points(1, 0.05), same.set_points(1, 0.05))
    assert plan.findings == same.findings


def test_a_plan_is_that_of_the_command_line(program, tmp_path):
    plan = seamwright.Job.load("saddle").plan()
    report = json.loads(
        subprocess.run([program, "plan", "saddle", "-o", tmp_path, "--json"], capture_output=True, check=True).stdout
    )
    assert [p["plan"]["length_mm"] for p in report["passes"]] == [p.length_mm for p in plan.passes]
    assert report["totals"]["total_s"] == plan.total_s
    assert [f["code"] for f in report["findings"]] == [f.code for f in plan.findings]


def test_set_points_keep_the_ranges_and_speeds_of_all_axes():
    job = seamwright.Job.load("hillside")
    plan = job.plan()
    period = 0.004
    for planned in plan.passes:
        q = plan.set_points(planned.number, period)
        assert q.shape[1] == len(job.machine.axes)
        assert q.dtype == np.float64
        for axis, column in zip(job.machine.axes, q.T):
            if axis.range:
                assert axis.range[0] - 1e-9 <= column.min() and column.max() <= axis.range[1] + 1e-9
            assert np.abs(np.diff(column)).max() <= axis.max_speed * period * (1 + 1e-9)
        t, s, v, on = plan.progress(planned.number, period).T
        assert np.allclose(np.diff(t), period) and s[-1] == pytest.approx(planned.length_mm)
        assert on.max() == 1.0 and v.max() > 0


def test_numbers_are_handed_over_without_a_copy():
    q = seamwright.Job.load("first-weld").plan().set_points(1, 0.01)
    # The memory belongs to the library's list of numbers.
    assert not q.flags.owndata and q.flags.c_contiguous and q.flags.writeable
    base = q
    while isinstance(base.base, np.ndarray):
        base = base.base
    assert "SliceContainer" in type(base.base).__name__


def test_the_torch_is_on_the_seam():
    """Set-points through the forward kinematics against the seam: two ways to the same points."""
    job = seamwright.Job.load("saddle")
    plan = job.plan()
    q, progress = plan.set_points(1, 0.05), plan.progress(1, 0.05)
    poses = job.machine.forward_table(q)
    points = job.seam.points(progress[:, 1])
    assert np.linalg.norm(poses[:, :3] - points, axis=1).max() < 0.01


def test_frames_of_the_seam_are_right_handed_and_follow_it():
    seam = seamwright.Job.load("saddle").seam
    s = np.linspace(0, seam.length_mm, 41)
    frames = seam.frames(s)
    assert frames.shape == (41, 4, 4)
    turn = frames[:, :3, :3]
    assert np.allclose(turn @ turn.transpose(0, 2, 1), np.eye(3)) and np.allclose(np.linalg.det(turn), 1)
    assert np.array_equal(frames[:, :3, 3], seam.points(s))
    step = 1e-3
    along = (seam.points(s + step) - seam.points(s - step)) / (2 * step)
    assert np.abs((along * turn[:, :, 0]).sum(axis=1) - 1).max() < 1e-4
    assert min(seam.dihedral_deg(s)) > 0


def test_impossible_welds_are_an_exception_with_findings():
    values = seamwright.Job.load("first-weld").to_dict()
    values["weld"]["speed_mm_s"] = 400
    job = seamwright.Job.from_dict(values)
    with pytest.raises(seamwright.NotWeldable) as caught:
        job.plan()
    error = caught.value
    finding = next(f for f in error.findings if f.severity == "error")
    assert error.code == finding.code and finding.code.startswith("motion-")
    assert finding.cure() and finding.text() in str(error) and finding.arguments
    assert finding.text("de") != finding.text() and error.text("zh") != str(error)
    assert finding.to_dict()["code"] == finding.code
    assert job.check() == error.findings
    with pytest.raises(ValueError, match="en, uk, zh, de, ru"):
        finding.text("fr")


def test_invalid_jobs_have_an_address(tmp_path):
    path = tmp_path / "job.toml"
    text = seamwright.Job.load("saddle").toml.replace("speed_mm_s = 10", "speed_mm_s = -10")
    path.write_text(text)
    with pytest.raises(seamwright.InvalidInput) as caught:
        seamwright.Job.load(path)
    error = caught.value
    line = 1 + text.split("\n").index(next(row for row in text.split("\n") if "speed_mm_s = -10" in row))
    assert (error.file, error.line, error.key) == (str(path), line, "weld.speed_mm_s")
    assert error.address == f"{path}:{line}: weld.speed_mm_s"
    assert isinstance(error, ValueError) and "-10" in str(error) and error.allowed()
    with pytest.raises(seamwright.InvalidInput) as caught:
        seamwright.Job.load("sadle")
    assert caught.value.code == "project-no-such-file" and "saddle" in str(caught.value)
    with pytest.raises(TypeError, match="weld.speed_mm_s"):
        seamwright.Job.from_dict({"weld": {"speed_mm_s": object()}})
    loop = {}
    loop["self"] = loop
    with pytest.raises(TypeError, match="contains itself"):
        seamwright.Job.from_dict(loop)


def test_another_machine_is_taken_by_name_or_as_an_object():
    job = seamwright.Job.load("hillside")
    by_name = job.plan("ebw-7axis")
    by_object = job.plan(seamwright.Machine.load("ebw-7axis"))
    assert by_name.machine.name == by_object.machine.name == "ebw-7axis" != job.machine.name
    assert np.array_equal(by_name.set_points(1, 0.1), by_object.set_points(1, 0.1))


@pytest.mark.parametrize("control", ["linuxcnc", "sinumerik", "grblhal", "pmac"])
def test_posts_are_those_of_the_command_line(control, program, tmp_path):
    text = seamwright.Job.load("saddle").plan().post(control)
    subprocess.run([program, "plan", "saddle", "-o", tmp_path, "--post", control], capture_output=True, check=True)
    assert text in [path.read_text() for path in tmp_path.iterdir() if path.suffix in (".ngc", ".mpf", ".nc", ".pmc")]


def test_posts_that_are_impossible_say_why():
    plan = seamwright.Job.load("saddle").plan()
    with pytest.raises(seamwright.InvalidInput) as caught:
        plan.post("fanuc-ls")
    assert caught.value.code
    with pytest.raises(ValueError, match="linuxcnc"):
        plan.post("basic")
    with pytest.raises(IndexError, match="1 to 1"):
        plan.set_points(2)


def test_other_threads_run_while_a_plan_runs():
    job = seamwright.Job.load(LONG)
    counts = []
    stop = threading.Event()

    def count():
        n = 0
        while not stop.is_set():
            n += 1
            time.sleep(0.001)
            counts.append(time.monotonic())

    thread = threading.Thread(target=count)
    thread.start()
    begin = time.monotonic()
    job.check()
    end = time.monotonic()
    stop.set()
    thread.join()
    during = np.array([begin] + [t for t in counts if begin < t < end] + [end])
    # With the lock held it would not count at all, and the longest gap would be the whole plan.
    assert end - begin > 0.3, "a plan that is long enough"
    assert len(during) > 20 and np.diff(during).max() < 0.5 * (end - begin)


def test_ctrl_c_ends_a_plan():
    job = seamwright.Job.load(LONG)
    begin = time.monotonic()
    job.check()
    whole = time.monotonic() - begin
    timer = threading.Timer(0.1, signal.raise_signal, [signal.SIGINT])
    begin = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        job.check()
        time.sleep(5)
    assert time.monotonic() - begin < max(0.5 * whole, 0.5)
    timer.join()


def test_a_plan_ends_at_its_time_limit():
    with pytest.raises(seamwright.NotWeldable) as caught:
        seamwright.Job.load(LONG).plan(time_limit_s=0.001)
    assert any(f.kind == "search" for f in caught.value.findings)
    with pytest.raises(ValueError, match="time_limit_s"):
        seamwright.Job.load("saddle").plan(time_limit_s=0)
