"""Configurations a little outside the limits are taken to them, and reports say so; beyond, messages say by how much.

Reproductions: reviews of moveit2#3383, moveit2#3492 and curobo#499 (encoders at a stop), aikido#430 and prpl-mono#490 (the short
way), ros_controllers#274, moveit2#1777 and ros2_controllers#172 (logs in (-π, π]).
"""

import logging
import re
import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.robots.limits import enough_digits

TURN = 2 * np.pi
ARM = mp.planar_arm([1.0, 0.8, 0.5]).with_limits(lower=[-3.0, -2.5, -2.0], upper=[3.0, 2.5, 2.0], jerk=np.inf)
FREE = mp.planar_arm([1.0, 0.8, 0.5])
UR5 = mp.load_robot("ur5")
MIDDLE = np.array([0.3, 0.7, 0.4])

offsets = st.floats(1e-15, 9.9e-7)


def beyond(robot, joint, above, off, q):
    """The configuration with one joint outside a limit."""
    q = np.array(q, dtype=float)
    q[joint] = robot.limits.upper[joint] + off if above else robot.limits.lower[joint] - off
    return q


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(joint=st.integers(0, 2), above=st.booleans(), off=offsets, tolerance=st.sampled_from([1e-6, 1e-4, 0.02]))
def test_what_is_within_the_tolerance_is_taken_to_the_limit(joint, above, off, tolerance):
    robot = ARM.with_limits(limit_tolerance=tolerance)
    q = beyond(robot, joint, above, off * tolerance / 1e-6, MIDDLE)
    inside = robot.configuration("q", q)
    limit = (robot.limits.upper if above else robot.limits.lower)[joint]
    assert inside[joint] == limit
    np.testing.assert_array_equal(np.delete(inside, joint), np.delete(q, joint))
    exactly = beyond(robot, joint, above, tolerance, MIDDLE)  # as a user computes it
    assert robot.configuration("q", exactly)[joint] == limit


@settings(max_examples=200, deadline=None)
@given(joint=st.integers(0, 2), above=st.booleans(), off=st.floats(1.01e-6, 50.0))
def test_a_message_prints_a_value_outside_the_bounds_and_by_how_much(joint, above, off):
    q = beyond(ARM, joint, above, off, MIDDLE)
    with pytest.raises(mp.errors.InvalidInputError) as refused:
        ARM.configuration("q", q)
    text = str(refused.value)
    parts = re.search(r"got (\S+); allowed: (\S+) to (\S+) rad; it is (\S+) rad (above|below)", text)
    value, low, high, by = (float(part) for part in parts.groups()[:4])
    assert value == q[joint] and f"q[{joint}] (joint{joint + 1})" in text
    assert parts[5] == ("above" if above else "below")
    printed = value - high if above else low - value
    assert printed > 0
    assert printed == pytest.approx(off, rel=0.02, abs=1e-12) and by == pytest.approx(off, rel=6e-3)
    assert ("degrees" in text) <= (abs(value) > TURN and off > 0.5)
    assert ("limit_tolerance" in text) == (max(ARM.limits.lower[joint] - q[joint], q[joint] - ARM.limits.upper[joint]) <= 0.1)


@settings(max_examples=300, deadline=None)
@given(value=st.floats(-1e4, 1e4), difference=st.floats(1e-9, 10.0))
def test_enough_digits_tell_a_number_from_its_neighbour(value, difference):
    assert abs(float(enough_digits(value, difference)) - value) <= max(difference / 100, 1e-12)


def test_no_hint_where_it_cannot_be_the_cause():
    for off, hint in ((1e-5, None), (1e-3, None), (0.3, None), (90 - TURN, "90 degrees are 1.571 rad")):
        q = UR5.neutral.copy()
        q[5] = TURN + off
        with pytest.raises(mp.errors.InvalidInputError) as refused:
            mp.plan(UR5, q, UR5.neutral)
        assert ("degrees" in str(refused.value)) == (hint is not None) and (hint or "") in str(refused.value)
    remedy = re.search(r"limit_tolerance=(\S+?)\)", _message(UR5, TURN + 1.234e-3))
    near = UR5.with_limits(limit_tolerance=float(remedy[1]))
    assert near.configuration("q", [*UR5.neutral[:5], TURN + 1.234e-3])[5] == UR5.limits.upper[5]
    assert "0.3 rad is the same posture" in _message(UR5, TURN + 0.3)


def _message(robot, last):
    with pytest.raises(mp.errors.InvalidInputError) as refused:
        robot.configuration("q", [*robot.neutral[:-1], last])
    return str(refused.value)


def test_a_slide_far_outside_may_be_in_millimetres(tmp_path):
    file = tmp_path / "slide.urdf"
    file.write_text("""<robot name="slide"><link name="a"/><link name="b"/><joint name="x" type="prismatic"><parent link="a"/>
      <child link="b"/><axis xyz="1 0 0"/><limit lower="0" upper="0.5" velocity="1" effort="1"/></joint></robot>""")
    robot = mp.load_robot(file)
    assert "300 mm are 0.3 m" in _message(robot, 300.0)
    assert "mm" not in _message(robot, 0.7) and "degrees" not in _message(robot, 0.7)
    assert robot.configuration("q", [0.5 + 1e-6])[0] == 0.5


@pytest.mark.parametrize("tolerance", [-1e-9, 0.11, np.nan, np.inf, "1e-6", True])
def test_a_tolerance_is_a_small_number(tolerance):
    with pytest.raises(mp.errors.InvalidInputError, match="limit_tolerance"):
        ARM.with_limits(limit_tolerance=tolerance)


def test_a_tolerance_of_zero_refuses_the_smallest_excess():
    strict = ARM.with_limits(limit_tolerance=0.0)
    assert strict.configuration("q", strict.limits.upper)[0] == 3.0
    with pytest.raises(mp.errors.InvalidInputError, match=r"it is 4\.44e-16 rad above"):
        strict.configuration("q", [np.nextafter(3.0, 4.0), 0.0, 0.0])


@pytest.mark.slow
def test_every_job_takes_start_and_goal_to_the_limit_and_says_so(caplog, tmp_path):
    off = 4e-5
    robot = ARM.with_limits(limit_tolerance=1e-4)
    start, goal = beyond(robot, 0, True, off, MIDDLE), beyond(robot, 1, False, off, MIDDLE)
    limits = ("start", "joint1", 3.0), ("goal", "joint2", -2.5)

    def said(report, *expected):
        found = [(each.argument, each.joint, each.limit) for each in report.taken_to_limits]
        assert found == list(expected)
        for each in report.taken_to_limits:
            assert each.outside == pytest.approx(off) and f"  limit        {each}" in str(report)

    with caplog.at_level(logging.INFO, logger="manipplan"):
        plan = mp.plan(robot, start, goal)
    assert "start: joint1 was 4e-05 rad above its limit 3, and was taken to it" in caplog.text
    assert "goal: joint2 was 4e-05 rad below its limit -2.5, and was taken to it" in caplog.text
    said(plan.report, *limits)
    assert plan.trajectory.q[0, 0] == 3.0 and plan.report.passed
    plan.save(tmp_path)
    again = mp.Plan.load(tmp_path, robot=robot)
    assert again.report == plan.report
    said(mp.plan(robot, start, [MIDDLE, goal]).report, limits[0])  # the other goal of the list is chosen
    (many,) = mp.plan_many([mp.Problem(robot=robot, start=start, goal=goal)])
    said(many.report, *limits)
    said(mp.check(robot, plan.trajectory, start=start, goal=goal), *limits)
    assert mp.check(robot, plan.trajectory, start=start, goal=goal).passed
    program = mp.sequence(robot, start, [mp.MoveTo(MIDDLE), mp.MoveTo(goal)])
    said(program.parts[0].report, ("start", "joint1", 3.0), ("steps[1].goal", "joint2", -2.5))
    assert program.passed and "joint2 was 4e-05 rad below its limit" in str(program)
    path = mp.optimize_path(robot, start, goal).path
    assert path.start[0] == 3.0 and path.goal[1] == -2.5
    assert mp.seed_path(robot, start, goal, mp.Scene()).start[0] == 3.0
    for job in (mp.plan, mp.optimize_path, mp.seed_path):
        with pytest.raises(mp.errors.InvalidInputError, match=r"start\[0\] \(joint1\).*3 rad; it is 4e-05 rad above"):
            job(ARM, start, MIDDLE)
    with pytest.raises(mp.errors.InvalidInputError, match=r"steps\[0\]\.goal\[1\] \(joint2\)"):
        mp.sequence(ARM, MIDDLE, [mp.MoveTo(goal)])


@pytest.mark.slow
def test_follow_begins_at_the_limit():
    robot = ARM.with_limits(limit_tolerance=1e-3)
    kinematics = robot.kinematics()
    start = np.array([0.4, 0.6, 2.0 + 5e-4])
    pose = kinematics.pose(np.array([0.4, 0.6, 2.0]))
    end = pose.copy()
    end[0, 3] -= 0.1
    plan = mp.follow(robot, mp.CartesianPath.line(pose, end), start=start)
    assert [(each.argument, each.joint) for each in plan.report.taken_to_limits] == [("start", "joint3")]
    assert plan.trajectory.q[0, 2] == 2.0


@pytest.mark.slow
def test_named_states_are_taken_to_the_limits(caplog):
    robot = mp.load_robot("panda")
    name = next(iter(robot.states))
    q = robot.states[name]
    narrow = robot.with_limits(upper=np.where(np.arange(7) == 3, q[3] - 5e-7, robot.limits.upper))
    plan = mp.plan(narrow, name, q + [0.1, 0, 0, -0.1, 0, 0, 0])
    assert [each.argument for each in plan.report.taken_to_limits] == ["start"]
    assert plan.trajectory.q[0, 3] == narrow.limits.upper[3]


@pytest.mark.slow
def test_a_saved_plan_keeps_the_tolerance(tmp_path):
    robot = UR5.with_limits(limit_tolerance=1e-3)
    goal = UR5.neutral.copy()
    goal[5] += 0.2
    mp.plan(robot, UR5.neutral, goal).save(tmp_path)
    assert mp.Plan.load(tmp_path).robot.limit_tolerance == 1e-3


@pytest.mark.slow
def test_two_pi_and_one_microradian():
    q = UR5.neutral.copy()
    q[5] = TURN + 1e-6
    plan = mp.plan(UR5, q, UR5.neutral + 0.2)
    (taken,) = plan.report.taken_to_limits
    assert taken.joint == "wrist_3_joint" and taken.outside == pytest.approx(1e-6, rel=1e-3)
    assert plan.trajectory.q[0, 5] == UR5.limits.upper[5]


# the short way


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(turns=st.lists(st.integers(-3, 3), min_size=3, max_size=3), by=st.floats(-3.0, 3.0).filter(lambda x: abs(x) > 0.05))
def test_the_short_way_of_continuous_joints_is_the_same_for_every_turn(turns, by):
    start = np.array([3.1, 0.9, 0.5])
    goal = start + [by, 0.1, -0.2]
    short = mp.optimize_path(FREE, start, goal + TURN * np.array(turns), seeding=mp.Seeding(shifts="nearest")).path
    np.testing.assert_allclose(short.goal, goal, atol=1e-12)


@pytest.mark.slow
def test_the_short_way_across_pi():
    robot = mp.load_robot("kinova")
    start, goal = robot.neutral.copy(), robot.neutral.copy()
    start[0], goal[0] = 3.1, -3.1
    for target in (goal, [goal]):
        plan = mp.plan(robot, start, target, seeding=mp.Seeding(shifts="nearest"))
        assert plan.path.length == pytest.approx(TURN - 6.2, abs=1e-3)
        assert plan.report.passed and plan.report.goal_error == 0
        assert mp.check(robot, plan.trajectory, start=start, goal=goal).passed
    assert mp.plan(robot, start, goal).path.length > 6.0
    program = mp.sequence(robot, start, [mp.MoveTo(goal), mp.MoveTo(start)], seeding=mp.Seeding(shifts="nearest"))
    assert program.passed and np.ptp(program.trajectory.q[:, 0]) < 0.1


@pytest.mark.slow
def test_a_short_turn_neither_warns_nor_stops_early():
    robot = mp.load_robot("kinova")
    start, goal = robot.neutral.copy(), robot.neutral.copy()
    start[0], goal[0] = 3.1, -3.1
    pose = robot.kinematics().pose(goal)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plans = [mp.plan(robot, start, pose) for _ in range(2)]
    for plan in plans:
        assert plan.status is mp.Status.OPTIMAL and plan.path.length == pytest.approx(0.0832, abs=1e-3)


@pytest.mark.slow
def test_limits_bound_the_short_way_and_all_turns_pass_their_checks():
    start = np.array([0.0, -1.2, 1.4, -1.7, -1.5, 3.0])
    goal = start + [0.3, 0, 0, 0, 0, -6.0]
    for shifts, ends in (("none", -3.0), ("nearest", TURN - 3.0), ("within-limits", TURN - 3.0)):
        plan = mp.plan(UR5, start, goal, seeding=mp.Seeding(shifts=shifts))
        assert plan.report.passed and plan.path.goal[5] == pytest.approx(ends, abs=1e-9)
    pose = UR5.kinematics().pose(goal)  # turns of its configurations are tried anyway
    one, other = (mp.plan(UR5, start, pose, seeding=mp.Seeding(shifts=shifts)) for shifts in ("none", "within-limits"))
    assert np.array_equal(one.trajectory.q, other.trajectory.q)
    narrow = UR5.with_limits(upper=np.where(np.arange(6) == 5, 3.1, TURN))
    assert mp.plan(narrow, start, goal, seeding=mp.Seeding(shifts="nearest")).path.goal[5] == -3.0
    with pytest.raises(mp.errors.InvalidInputError, match="'nearest' for the short way"):
        mp.sequence(UR5, start, [mp.MoveTo(goal)], seeding=mp.Seeding(shifts="within-limits"))


def test_where_the_arm_stands_at_a_limit_is_the_goal_beyond_it():
    start = np.array([3.0, 0.9, 0.5])
    plan = mp.plan(ARM, start, start + [1e-7, 0.0, 0.0])
    assert plan.status is mp.Status.AT_GOAL
    assert [each.argument for each in plan.report.taken_to_limits] == ["goal"]


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(size=st.floats(0.01, 1.0), seed=st.integers(0, 1000))
def test_short_paths_reach_their_optimum(size, seed):
    """A gradient per radian means little on a short path, so the descent goes on until the certificate accepts it."""
    rng = np.random.default_rng(seed)
    start = MIDDLE + rng.uniform(-0.3, 0.3, 3)
    way = rng.normal(size=3)
    path = mp.optimize_path(ARM, start, start + size * way / np.linalg.norm(way), mp.Scene())
    assert path.status is mp.Status.OPTIMAL and path.certificate.projected_gradient <= 1e-3
