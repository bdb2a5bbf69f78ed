"""Recordings of continuous joints in (-π, π] give what the motion as driven gives; other joints cannot jump so."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

import manipplan as mp
from manipplan.recordings.recording import read_motion

TURN = 2 * np.pi
FREE = mp.planar_arm([1.0, 0.8, 0.5])
BOUND = FREE.with_limits(lower=-4.0, upper=4.0)
NAMES = FREE.joint_names


def reported(q):
    """Angles in [-π, π)."""
    return (q + np.pi) % TURN - np.pi


def recording(t, q, qd=None, names=NAMES):
    return mp.Trajectory(t=t, q=q, qd=CubicSpline(t, q)(t, 1) if qd is None else qd, joint_names=names)


def read(robot, motion, **options):
    given = {"joints": None, "degrees": False, "columns": None, **options}
    return read_motion(robot, "recorded", motion, **given)


motions = st.tuples(
    st.floats(-3.1, 3.1),  # where the first joint begins
    st.floats(-9.0, 9.0),  # by how much it turns
    st.floats(8.0, 20.0),  # duration [s]
    st.integers(100, 600),  # samples
    st.integers(0, 10**6),
)


def driven(motion, noise=0.0):
    begin, by, duration, count, seed = motion
    t = np.linspace(0.0, duration, count)
    u = t / t[-1]
    smooth = 10 * u**3 - 15 * u**4 + 6 * u**5
    q = np.stack([begin + by * smooth, 0.9 + 0.3 * np.sin(2 * u), 0.5 - 0.2 * u], axis=1)
    return t, q + np.random.default_rng(seed).normal(0.0, noise, q.shape)


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(motion=motions, noise=st.sampled_from([0.0, 1e-4, 5e-3]), kind=st.sampled_from(["true", "spline", "differences"]))
def test_a_log_as_reported_is_the_log_as_driven(motion, noise, kind):
    t, q = driven(motion, noise)
    whole = TURN * np.round((q[0] - reported(q[0])) / TURN)
    wrapped = q.copy()
    wrapped[:, 0] = reported(q[:, 0])
    rates = CubicSpline(t, q)(t, 1)
    given_rates = {"true": rates, "spline": None, "differences": np.gradient(wrapped, t, axis=0)}[kind]
    found = read(FREE, recording(t, wrapped, given_rates))
    np.testing.assert_allclose(found.q, q - whole, atol=1e-9)
    jumped = np.abs(np.diff(wrapped[:, 0])) > np.pi
    if kind != "differences" or jumped.any():  # otherwise the differences are kept as they are
        np.testing.assert_allclose(found.qd[:, 0], rates[:, 0], atol=1e-7)
    as_driven = read(FREE, recording(t, q))
    np.testing.assert_array_equal(as_driven.q, q)


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(motion=motions, row=st.integers(5, 90), turns=st.sampled_from([-1, 1]))
def test_a_jump_of_a_joint_with_limits_names_row_and_joint(motion, row, turns):
    t, q = driven((0.0, 0.0, *motion[2:]))
    q[:, 1] = -turns * np.pi
    q[row:, 1] += turns * TURN
    for job in (mp.improve, mp.check):
        name = "recorded" if job is mp.improve else "trajectory"
        with pytest.raises(
            mp.errors.InvalidInputError, match=rf"{name}\.q\[{row}, 1\] \(joint2\).*about a full turn.*not continuous"
        ):
            job(BOUND, recording(t, q))


def test_the_error_names_the_row_of_the_file_and_its_unit(tmp_path):
    file = tmp_path / "log.csv"
    t = np.linspace(0.0, 2.0, 50)
    q = np.tile([0.2, 3.1, 0.5], (50, 1))
    q[20:, 1] -= 6.2
    np.savetxt(file, np.c_[t, np.rad2deg(q)], delimiter=",", header=",".join(["time", *(f"q_{n}" for n in NAMES)]), comments="")
    with pytest.raises(mp.errors.InvalidInputError, match=r"log\.csv, row 22, joint2: got -177\.6.*full turn"):
        mp.improve(BOUND, file, degrees=True)


@pytest.mark.parametrize("ends", ["at rest", "at full speed"])
def test_a_turn_that_the_joint_can_drive_is_no_jump(ends):
    """A whole turn between two samples, or three times faster than allowed: the motion is judged as it is."""
    for seconds, passes in ((8.0, True), (0.7, False)):
        qd = np.zeros((2, 3)) if ends == "at rest" else np.tile([TURN / seconds, 0.0, 0.0], (2, 1))
        motion = mp.Trajectory(t=[0.0, seconds], q=[[0.0, 0.9, 0.5], [TURN, 0.9, 0.5]], qd=qd, joint_names=NAMES)
        report = mp.check(FREE, motion)
        assert report.length == pytest.approx(TURN, rel=1e-6)
        assert passes == (not any(fault.startswith("velocity") for fault in report.faults))


def test_without_velocity_limits_the_other_samples_tell():
    t, q = driven((2.8, 0.8, 8.0, 300, 0))
    free = FREE.with_limits(velocity=np.inf, acceleration=np.inf)
    np.testing.assert_allclose(read(free, recording(t, reported(q))).q, q, atol=1e-9)
    fast = mp.Trajectory(t=[0.0, 0.1], q=[[0.0] * 3, [TURN] * 3], qd=np.zeros((2, 3)), joint_names=NAMES)
    np.testing.assert_array_equal(read(free, fast).q, fast.q)


def test_slides_do_not_turn(tmp_path):
    file = tmp_path / "slide.urdf"
    file.write_text("""<robot name="slide"><link name="a"/><link name="b"/><joint name="x" type="prismatic"><parent link="a"/>
      <child link="b"/><axis xyz="1 0 0"/><limit lower="-9" upper="9" velocity="1" effort="1"/></joint></robot>""")
    robot = mp.load_robot(file)
    motion = mp.Trajectory(t=[0, 0.1, 0.2], q=[[0.0], [TURN], [TURN]], qd=np.zeros((3, 1)), joint_names=robot.joint_names)
    np.testing.assert_array_equal(read(robot, motion).q, motion.q)


@pytest.mark.slow
def test_a_kinova_log_gives_one_result_both_ways(tmp_path):
    robot = mp.load_robot("kinova")
    t = np.arange(0, 4, 0.01)
    u = t / t[-1]
    q = np.tile(robot.neutral, (len(t), 1))
    q[:, 0] = 2.8 + 0.8 * (10 * u**3 - 15 * u**4 + 6 * u**5)
    wrapped = np.where(np.arange(6) == 0, reported(q), q)
    file, plans = tmp_path / "log.csv", []
    for log in (q, wrapped):
        header = "time," + ",".join("q_" + name for name in robot.joint_names)
        np.savetxt(file, np.c_[t, log], delimiter=",", header=header, comments="")
        for recorded in (file, mp.Trajectory.from_csv(file)):
            plans.append(mp.improve(robot, recorded, tolerance=mp.Tolerance(position=0.01, rotation=0.05)))
            assert mp.check(robot, recorded, start=log[0], goal=log[-1]).goal_error < 1e-9
    for plan in plans:
        assert plan.status is plans[0].status and plan.report.passed
        np.testing.assert_allclose(plan.trajectory.q, plans[0].trajectory.q, atol=1e-9)


def test_a_first_path_as_reported_is_one_as_driven():
    t, q = driven((2.8, 0.8, 8.0, 120, 0))
    log = recording(t, np.where(np.arange(3) == 0, reported(q), q))
    for goal in (q[-1], reported(q[-1])):
        path = mp.optimize_path(FREE, q[0], goal, seeding=mp.Seeding(initial=log)).path
        np.testing.assert_allclose(path.goal, q[-1], atol=1e-9)
        assert path.length < 2.0


@pytest.mark.slow
def test_noise_beyond_a_limit_is_in_the_report():
    t, q = driven((1.0, 0.8, 8.0, 300, 0))
    robot = FREE.with_limits(lower=-3.0, upper=[1.795, 3.0, 3.0])
    plan = mp.improve(robot, recording(t, q))
    (taken,) = plan.report.taken_to_limits
    assert taken.argument == "recorded.q[299, 0]" and taken.outside == pytest.approx(0.005)
    assert plan.report.passed and plan.trajectory.q[-1, 0] <= 1.795


def test_positions_beyond_the_limits_are_named_with_how_far_and_no_wrong_hint():
    t, q = driven((1.0, 0.8, 8.0, 300, 0))
    for upper, off in ((1.75, 0.05), (1.2, 0.6)):
        robot = FREE.with_limits(lower=-3.0, upper=[upper, 3.0, 3.0])
        with pytest.raises(mp.errors.InvalidInputError) as refused:
            mp.improve(robot, recording(t, q))
        assert " rad above" in str(refused.value)
        assert ("degrees" in str(refused.value)) == (off > 0.5)
    degrees = replace(recording(t, np.rad2deg(q)), qd=np.zeros_like(q))
    with pytest.raises(mp.errors.InvalidInputError, match="if they are in degrees"):
        mp.improve(FREE.with_limits(lower=-3.0, upper=2.0), degrees)
