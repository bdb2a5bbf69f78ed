"""Constant speeds of the tool: kept between short ramps, and where they are not possible the fastest one is named."""

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.search.layers import step_limits
from manipplan.timing.constant_speed import SpeedDemand, check_tool_speed, limits_bound, measure_speed

FEW = {"samples": 48, "epsilon": 0.5}


def tool_speeds(robot, trajectory, count=20001):
    """Times and speeds of the tool's origin, by finite differences of its positions."""
    t = np.linspace(0.0, trajectory.duration, count)
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    places = []
    for q in trajectory(t):
        pin.framesForwardKinematics(robot.model, data, q)
        places.append(data.oMf[frame].translation.copy())
    return (t[1:] + t[:-1]) / 2, np.linalg.norm(np.diff(places, axis=0), axis=1) / np.diff(t)


def one_joint():
    """An arm of which only the first joint moves, on a quarter of a circle of a metre."""
    arm = mp.planar_arm([0.6, 0.4]).with_limits(velocity=2.0, acceleration=5.0)
    return arm, mp.JointPath.line([0.0, 0.0], [np.pi / 2, 0.0])


@pytest.fixture(scope="module")
def line(panda):
    begin = np.array(panda.kinematics().pose(panda.neutral))
    end = begin.copy()
    end[:3, 3] += [0.1, 0.25, -0.1]
    return mp.CartesianPath.line(begin, end)


@pytest.mark.slow
@pytest.mark.parametrize("jerk", [None, np.inf])
def test_a_line_at_constant_speed(panda, line, jerk):
    arm = panda if jerk is None else panda.with_limits(jerk=jerk)
    plan = mp.follow(arm, line, tool_speed=0.02, positions=8, **FEW)
    assert plan.report.passed
    kept = plan.report.along[0].tool_speed
    t, speeds = tool_speeds(arm, plan.trajectory)
    between = speeds[(t > kept.begin + 1e-3) & (t < kept.end - 1e-3)]
    assert between.min() >= 0.02 * 0.99 and speeds.max() <= 0.02 * (1 + 1e-4)
    assert 0.02 * 0.99 <= kept.slowest <= between.min() * (1 + 1e-4)
    assert kept.fastest == pytest.approx(between.max(), rel=1e-3)
    assert max(kept.ramps) < 1e-3 and kept.length == pytest.approx(line.length, rel=1e-3)
    assert plan.trajectory.duration == pytest.approx(line.length / 0.02, rel=0.01)
    assert f"tool speed   {1e3 * kept.slowest:.4g}" in str(plan.report) and "(20 asked for)" in str(plan.report)


@pytest.mark.slow
def test_after_a_lead_in(panda, line, tmp_path):
    start = panda.neutral + 0.3
    plan = mp.follow(panda, line, start=start, tool_speed=0.05, positions=8, **FEW)
    kept = plan.report.along[0].tool_speed
    assert plan.path_begin < kept.begin < plan.path_begin + 0.1
    t, speeds = tool_speeds(panda, plan.trajectory)
    inside = speeds[(t > kept.begin + 1e-3) & (t < kept.end - 1e-3)]
    assert inside.min() > 0.05 * 0.99 and inside.max() <= 0.05 * (1 + 1e-4)
    assert speeds[t < plan.path_begin].max() > 0.1  # the lead-in is as fast as it can be
    plan.save(tmp_path)
    assert mp.Plan.load(tmp_path).report.along[0].tool_speed == kept


@pytest.mark.slow
def test_the_fastest_speed_is_named_and_kept(panda, line):
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"tool_speed: got 2.5; allowed: at most [\d.]+ m/s, the fastest"
    ) as told:
        mp.follow(panda, line, tool_speed=2.5, positions=8, **FEW)
    fastest = float(re.search(r"at most ([\d.]+) m/s", str(told.value)).group(1))
    plan = mp.follow(panda, line, tool_speed=fastest, positions=8, **FEW)
    assert plan.report.passed and plan.report.along[0].tool_speed.is_steady
    with pytest.raises(mp.errors.InvalidInputError, match="tool_speed"):
        mp.follow(panda, line, tool_speed=1.1 * fastest, positions=8, throw=False, **FEW)


@pytest.mark.slow
def test_the_limits_that_bound_a_constant_speed():
    """On a circle of a metre the joint's velocity is the tool's speed."""
    arm, path = one_joint()
    bound, _ = limits_bound(path, arm)
    assert bound.speed == pytest.approx(2.0, rel=1e-9) and (bound.kind, bound.joint) == ("velocity", "joint1")
    with pytest.raises(mp.errors.InvalidInputError, match="velocity limit of joint1") as told:
        SpeedDemand(speed=3.0).timed(path, arm.with_limits(acceleration=50.0))
    assert float(re.search(r"at most ([\d.]+) m/s", str(told.value)).group(1)) == pytest.approx(2.0, rel=0.02)


@pytest.mark.slow
def test_a_path_too_short_for_its_ramps():
    """From rest v takes v² / 2a, and a tenth of the path is 0.157 m: v = √(2a · 0.157 m)."""
    arm, path = one_joint()
    with pytest.raises(mp.errors.InvalidInputError, match="to or from rest") as told:
        SpeedDemand(speed=3.0).timed(path, arm.with_limits(velocity=10.0))
    most = np.sqrt(2 * 5.0 * np.pi / 20)
    assert float(re.search(r"at most ([\d.]+) m/s", str(told.value)).group(1)) == pytest.approx(most, rel=0.03)


def test_effort_limits_bound_the_speed_as_well(panda):
    path = mp.JointPath.spline([0, 0.5, 1], [panda.neutral, panda.neutral + 0.4, panda.neutral + [0.8, 0, 0.8, 0, 0.8, 0, 0.8]])
    strong = panda.with_limits(velocity=50.0, acceleration=500.0, jerk=np.inf)
    free, _ = limits_bound(path, strong)
    weak = strong.with_limits(effort=panda.limits.effort * 0.6)
    bound, _ = limits_bound(path, weak, torque=True)
    assert bound.speed < free.speed and bound.kind == "effort"


@pytest.mark.slow
def test_a_motion_that_turns_back_has_no_constant_speed():
    arm = mp.planar_arm([0.6, 0.4])
    there = mp.JointPath.through([[0.0, 0.0], [1.0, 0.0], [0.2, 0.0]])
    with pytest.raises(mp.errors.InvalidInputError, match="a path that is split at s = 0.5.*stands still"):
        SpeedDemand(speed=0.1).timed(there, arm)


def test_the_measure_tells_a_dip():
    """A motion that slows down half-way, or once it has reached its speed, is not steady; one that begins slowly is."""
    arm = mp.planar_arm([0.6, 0.4])
    for slow, steady in ((0.5, False), (0.08, False), (0.0, True)):
        s = np.linspace(0.0, 1.0, 401)
        pace = np.where(np.abs(s - slow) < 0.02, 0.5, 1.0)
        t = np.concatenate([[0.0], np.cumsum(2 * np.diff(s) / (pace[1:] + pace[:-1]))])
        q = np.stack([s, 0 * s], axis=1)
        moving = mp.Trajectory(t=t, q=q, qd=np.gradient(q, t, axis=0), joint_names=arm.joint_names)
        found = measure_speed(moving, arm, 1.0)
        assert found.is_steady is steady
        assert (found.slowest < 0.6) is not steady
        assert sum(found.ramps) < 0.03 and found.length == pytest.approx(1.0, rel=1e-3)


@pytest.mark.slow
def test_a_winding_seam_is_followed_at_a_constant_speed(panda):
    """Redundancy winds between the positions, so that the tool's way per joint motion changes within millimetres."""
    u = np.linspace(0, 1, 400)
    angle, radius = -2.6 + 7.4 * u, 0.45 + 0.05 * np.sin(9 * u)
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (400, 1, 1))
    poses[:, :3, 3] = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.25 + 0.25 * u], axis=1)
    objective = mp.PathObjective(task=mp.Task.pointing([0, 0, 1]))
    plan = mp.follow(panda, mp.CartesianPath.through(poses), objective=objective)
    for arm in (panda, panda.with_limits(jerk=np.inf)):
        for speed in (0.015, 0.09):
            motion, kept = SpeedDemand(speed=speed).timed(plan.path, arm)
            t, speeds = tool_speeds(arm, motion)
            between = speeds[(t > kept.begin + 0.02) & (t < kept.end - 0.02)]
            assert kept.is_steady and between.min() >= 0.9899 * speed and speeds.max() <= speed * (1 + 1e-4)


def bent_path():
    """An arm and a joint path that bends in its second half."""
    arm = mp.planar_arm([0.6, 0.4]).with_limits(velocity=2.0, acceleration=5.0, jerk=100.0)
    return arm, mp.JointPath.spline([0.0, 0.45, 0.5, 0.55, 1.0], [[0, 1.0], [0.45, 1.0], [0.5, 1.02], [0.53, 1.1], [0.7, 1.6]])


@pytest.mark.slow
def test_the_tool_slows_where_it_may():
    arm, path = bent_path()
    with pytest.raises(
        mp.errors.InvalidInputError, match="acceleration limit of joint2 allows no faster one at s = "
    ) as refused:
        SpeedDemand(speed=0.4).timed(path, arm)
    share = float(re.search(r"slowdown=([\d.]+)", refused.value.allowed).group(1))
    fastest = float(refused.value.allowed.split()[2])
    assert 0.05 < share < 1 and fastest == pytest.approx(0.4 * (1 - share), rel=0.25)
    motion, kept = SpeedDemand(speed=0.4, slowdown=share).timed(path, arm)
    t, speeds = tool_speeds(arm, motion)
    inside = (t > kept.begin) & (t < kept.end)
    assert kept.is_steady and kept.slowdown == share and speeds[inside].min() >= 0.4 * (1 - share) * (1 - 1e-3)
    assert abs(t[inside][speeds[inside].argmin()] - kept.slowest_at) < 0.01 and kept.fastest > 0.395
    with pytest.raises(mp.errors.InvalidInputError, match="tool_speed"):
        SpeedDemand(speed=0.4, slowdown=share - 0.02).timed(path, arm)
    _, steady = SpeedDemand(speed=fastest).timed(path, arm)
    assert steady.is_steady


@pytest.mark.slow
def test_the_message_names_the_place_on_the_tools_path():
    arm, path = bent_path()
    with pytest.raises(mp.errors.InvalidInputError) as refused:
        SpeedDemand(speed=0.4).timed(path, arm, ends=(0.2, 0.4))
    s, *position = (float(each) for each in re.findall(r"-?\d\.\d{3}\b", refused.value.allowed.split(" allows ")[1])[:4])
    assert 0.3 < s < 0.4
    np.testing.assert_allclose(position, arm.kinematics().pose(path(np.array([(s - 0.2) / 0.2])))[0][:3, 3], atol=2e-3)


def test_a_sharp_corner_is_refused_before_the_work(panda):
    begin = np.array(panda.kinematics().pose(panda.neutral))
    poses = np.tile(begin, (31, 1, 1))
    poses[:, :3, 3] += 0.01 * np.stack([np.minimum(np.arange(31), 15), np.maximum(np.arange(31) - 15, 0), np.zeros(31)], axis=1)
    told = []
    with pytest.raises(mp.errors.InvalidInputError, match=r"at s = 0\.5\d*, x y z = .* turns a corner"):
        mp.follow(panda, mp.CartesianPath.through(poses), tool_speed=2.0, progress=lambda *each: told.append(each))
    assert told == []


def with_corners(panda, corners):
    """A path from the Panda's neutral pose straight on by each of corners (k, 2) [m], through poses of 10 mm or less apart."""
    places = np.vstack([[0.0, 0.0], corners])
    shares = np.linspace(0, 1, 16)[1:, None]
    way = np.vstack([places[:1], *(begin + shares * (end - begin) for begin, end in pairwise(places))])
    poses = np.tile(np.array(panda.kinematics().pose(panda.neutral)), (len(way), 1, 1))
    poses[:, :2, 3] += way
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1))])
    return mp.CartesianPath.through(poses), length / length[-1]


def is_kept(robot, plan, speed):
    """Whether the tool has the speed between the ramps of each part, by finite differences, and no limit is exceeded."""
    t, speeds = tool_speeds(robot, plan.trajectory)
    rates, limits = [plan.trajectory(t, order) for order in (1, 2)], robot.limits
    assert (np.abs(rates[0]) <= limits.velocity * (1 + 1e-3)).all()
    assert (np.abs(rates[1]) <= limits.acceleration * (1 + 1e-2)).all()
    kept = [each.tool_speed for each in plan.report.along]
    between = [speeds[(t > each.begin + 1e-3) & (t < each.end - 1e-3)] for each in kept]
    ramps = max(max(each.ramps) / each.length for each in kept)
    return ramps <= 0.1 and all(each.min() >= speed * 0.9899 and each.max() <= speed * (1 + 1e-4) for each in between)


@pytest.mark.slow
def test_a_seam_that_only_joint_paths_chosen_for_the_speed_allow(panda):
    """A winding seam of 3.4 m: on the joint path of the largest minimum manipulability the tool has at most 0.12 m/s."""
    u = np.linspace(0, 1, 400)
    angle, radius = -2.6 + 7.4 * u, 0.45 + 0.05 * np.sin(9 * u)
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (400, 1, 1))
    poses[:, :3, 3] = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.25 + 0.25 * u], axis=1)
    path, objective = mp.CartesianPath.through(poses), mp.PathObjective(task=mp.Task.pointing([0, 0, 1]))
    best = mp.follow(panda, path, objective=objective)
    with pytest.raises(mp.errors.InvalidInputError, match="the fastest constant speed"):
        SpeedDemand(speed=0.12).timed(best.path, panda)
    plan = mp.follow(panda, path, objective=objective, tool_speed=1.0)
    assert plan.report.passed and len(plan.report.along) == 1 and is_kept(panda, plan, 1.0)
    assert plan.result.min_manipulability > 0.7 * best.result.min_manipulability


@pytest.mark.slow
def test_a_corner_is_parted_where_the_speed_demands_it(panda):
    path, _ = with_corners(panda, np.array([[0.15, 0.0], [0.15, 0.15]]))
    with pytest.raises(mp.errors.InvalidInputError, match=r"tool_speed: got 0\.2.*limit of panda_joint\d .* at s = 0\.500"):
        mp.follow(panda, path, tool_speed=0.2)
    plan = mp.follow(panda, path, tool_speed=0.2, interruptions=1, retreat=0.0)
    assert plan.report.passed and is_kept(panda, plan, 0.2)
    assert [each.s_end for each in plan.report.along] == pytest.approx([0.5, 1.0], abs=5e-4)


@pytest.mark.slow
def test_a_tool_retreats_at_a_corner_and_comes_back_from_there(panda):
    """Both straight ways end in one configuration, between which there is no free motion."""
    begin = np.diag([1.0, -1.0, -1.0, 1.0])
    places = np.array([[0.45, -0.15], [0.63, -0.15], [0.63, 0.11], [0.45, 0.11]])
    poses = np.tile(begin, (31, 1, 1))
    poses[:, :3, 3] = 0.0, 0.0, 0.4
    poses[:, :2, 3] = np.vstack([places[:1], *(a + np.linspace(0.1, 1, 10)[:, None] * (b - a) for a, b in pairwise(places))])
    plan = mp.follow(panda, mp.CartesianPath.through(poses), tool_speed=0.2, interruptions=2)
    assert plan.report.passed and is_kept(panda, plan, 0.2) and len(plan.report.along) == 3
    for first, last in plan.off_path:
        t = np.linspace(first, last, 200)
        height = panda.kinematics().pose(plan.trajectory(t))[:, 2, 3]
        assert height.max() == pytest.approx(0.45, abs=1e-4)  # by the default of 5 cm


@pytest.mark.slow
def test_cuts_are_at_the_corners_whatever_the_positions(panda):
    path, s = with_corners(panda, np.array([[0.12, 0.0], [0.06, 0.1], [0.0, 0.0]]))
    for positions in (None, 11):
        plan = mp.follow(panda, path, tool_speed=0.2, interruptions=5, retreat=0.0, positions=positions)
        assert plan.report.passed and is_kept(panda, plan, 0.2)
        assert [each.s_end for each in plan.report.along] == pytest.approx([s[15], s[30], 1.0], abs=2e-3)
    plan = mp.follow(panda, path, tool_speed=0.2, interruptions=3, retreat=0.0, closed=True)
    assert plan.report.passed and is_kept(panda, plan, 0.2)
    assert sorted(each.s_begin for each in plan.report.along) == pytest.approx([0, s[15], s[30]], abs=2e-3)


@pytest.mark.slow
def test_corners_and_gaps_that_need_more_interruptions_than_allowed_are_refused(panda, monkeypatch):
    """A turn of the tool that no motion makes without an interruption, and later a place at which the tool has to stop."""
    path, s = with_corners(panda, np.array([[0.15, 0.0], [0.15, 0.15]]))
    poses = path(path.knots)
    for k, angle in enumerate(np.minimum(20.0 * s, 8.0)):
        poses[k, :3, :3] = poses[k, :3, :3] @ pin.exp3(np.array([0.0, 0.0, angle]))
    path, asked = mp.CartesianPath.through(poses), {"tool_speed": 0.02, "retreat": 0.0, "positions": 40, **FEW}
    monkeypatch.setattr("manipplan.jobs.follow.check_corners", lambda *_, **__: (0.85,))
    with pytest.raises(mp.errors.InvalidInputError, match="interruptions: got 1; allowed: at least 2, at corners and where no"):
        mp.follow(panda, path, interruptions=1, **asked)
    plan = mp.follow(panda, path, interruptions=2, **asked)
    assert plan.report.passed and is_kept(panda, plan, 0.02)
    assert len(plan.report.along) == 3 and plan.report.along[1].s_end == pytest.approx(0.85, abs=2e-3)


@pytest.mark.slow
def test_a_refusal_does_not_depend_on_the_clock(panda, monkeypatch):
    path, _ = with_corners(panda, np.array([[0.15, 0.0], [0.15, 0.15]]))
    messages, now = [], [0.0]

    def slow_clock():
        now[0] += 100.0
        return now[0]

    for clock in (None, slow_clock):
        if clock is not None:
            monkeypatch.setattr("manipplan.support.deadline._clock.time", clock)
        with pytest.raises(mp.errors.InvalidInputError, match="tool_speed") as refused:
            mp.follow(panda, path, tool_speed=0.3, positions=20)
        messages.append(str(refused.value))
    assert messages[0] == messages[1]


def test_a_speed_that_the_arm_never_has_is_refused_before_the_work(panda, line):
    told = []
    wanted = "no motion within the acceleration limits reaches more from rest on a tenth of the path"
    with pytest.raises(mp.errors.InvalidInputError, match=wanted) as refused:
        mp.follow(panda, line, tool_speed=5.0, progress=lambda *each: told.append(each))
    most = float(re.search(r"at most ([\d.]+) m/s", str(refused.value)).group(1))
    fast = panda.with_limits(acceleration=1e4, jerk=np.inf)
    with pytest.raises(mp.errors.InvalidInputError, match="no motion within the velocity limits is faster"):
        mp.follow(fast, line, tool_speed=50.0, progress=lambda *each: told.append(each))
    with pytest.raises(mp.errors.InvalidInputError, match=r"steps\[0\]\.tool_speed.*no motion within the velocity limits"):
        mp.sequence(fast, panda.neutral, [mp.MoveAlong(line, tool_speed=50.0)])
    assert told == [] and 1.0 < most < 5.0


@pytest.mark.slow
def test_a_tool_of_a_program_slows_where_it_may(panda):
    path, _ = with_corners(panda, np.array([[0.15, 0.0], [0.15, 0.15]]))
    begin = panda.neutral
    with pytest.raises(mp.errors.InvalidInputError, match="tool_speed"):
        mp.sequence(panda, begin, [mp.MoveAlong(path, tool_speed=0.2)])
    made = mp.sequence(panda, begin, [mp.MoveAlong(path, tool_speed=0.2, slowdown=0.7)])
    kept = made.marks[0].tool_speed
    assert made.passed and kept.is_steady and kept.slowdown == 0.7 and 0.06 <= kept.slowest < 0.15 < kept.fastest
    t, speeds = tool_speeds(panda, made.trajectory)
    least = speeds[(t > kept.begin + 1e-3) & (t < kept.end - 1e-3)].min()
    assert 0.06 * 0.999 <= kept.slowest <= least * 1.001 and least < 0.15  # at the corner
    for slowdown in (0.0, 1.0, np.nan):
        with pytest.raises(mp.errors.InvalidInputError, match="slowdown"):
            mp.MoveAlong(path, tool_speed=0.2, slowdown=slowdown)
    with pytest.raises(mp.errors.InvalidInputError, match=r"0\.01 where no tool_speed"):
        mp.MoveAlong(path, slowdown=0.5)


def best_of_steps(layers, limits):
    """The largest minimum manipulability of all paths with steps (k, n) below `limits`, by brute force."""
    value = layers.m[0]
    for k in range(1, len(layers.q)):
        near = (np.abs(layers.q[k][:, None] - layers.q[k - 1]) < limits[k - 1]).all(axis=2)
        value = np.minimum(layers.m[k], np.where(near, value, -np.inf).max(axis=1))
    return value.max()


def test_layers_with_a_pace_have_only_steps_below_it(panda, line):
    """The best path is that of brute force among the candidates with such steps."""
    layers = mp.sample_layers(panda, line, 6, samples=16)
    free = mp.max_min_search(layers, 1.0)
    widest = np.abs(np.diff(free.q, axis=0)).max(axis=0)
    slower = replace(layers, joint_pace=np.where(widest == widest.max(), 0.7, 10.0) * widest / (line.length / 5))
    limits = step_limits(slower, np.ones(7))
    found = mp.max_min_search(slower, 1.0, throw=False)
    assert limits.shape == (5, 7) and (limits < 1).any()
    assert found.minimum == best_of_steps(layers, limits) <= free.minimum


def test_steps_between_given_poses_are_below_their_limit(panda, line):
    """Positions at, between and beyond given poses; the best path is that of brute force."""
    path = mp.CartesianPath.through(line.sample(9))
    s = np.interp([0, 1, 1.25, 2, 4, 8], np.arange(9), path.knots)
    layers = mp.sample_layers(panda, path, s, samples=16)
    free = mp.max_min_search(layers, 1.0)
    passed = np.array([1, 0.25, 0.75, 2, 4])
    most = 0.7 * float((np.abs(np.diff(free.q, axis=0)).max(axis=1) / passed).max())
    calm = replace(layers, pose_step=most)
    found = mp.max_min_search(calm, 1.0, throw=False)
    np.testing.assert_allclose(step_limits(calm, np.ones(7)), np.minimum(1.0, most * passed)[:, None] * np.ones(7), rtol=1e-9)
    assert found.minimum == best_of_steps(layers, step_limits(calm, np.ones(7))) <= free.minimum
    backwards = replace(calm, q=calm.q[::-1], m=calm.m[::-1], s=calm.s[::-1])
    assert mp.max_min_search(backwards, 1.0, throw=False).minimum == found.minimum


@pytest.mark.parametrize("slowdown", [0.0, 1.0, -0.1, np.nan, "half"])
def test_wrong_slowdowns_are_refused_before_the_work(panda, line, slowdown):
    with pytest.raises(mp.errors.InvalidInputError, match="slowdown"):
        mp.follow(panda, line, tool_speed=0.1, slowdown=slowdown, positions=3, **FEW)
    with pytest.raises(mp.errors.InvalidInputError, match=r"slowdown: got 0\.2; allowed: 0\.01 where no tool_speed"):
        mp.follow(panda, line, slowdown=0.2, positions=3, **FEW)


def test_a_tool_that_turns_in_place(panda):
    begin = np.array(panda.kinematics().pose(panda.neutral))
    turned = begin.copy()
    turned[:3, :3] = begin[:3, :3] @ pin.exp3(np.array([0.0, 0.0, 0.5]))
    with pytest.raises(mp.errors.InvalidInputError, match="turns the tool in place"):
        mp.follow(panda, mp.CartesianPath.line(begin, turned), tool_speed=0.1, positions=3, **FEW)


@given(at=st.floats(0.05, 0.95), poses=st.integers(2, 60), speed=st.floats(1e-3, 1.0))
def test_a_tool_that_turns_back_is_refused_however_dense_the_poses(at, poses, speed):
    there = np.tile(np.eye(4), (poses, 1, 1))
    there[:, 0, 3] = np.linspace(0.0, 0.2, poses)
    back = there[::-1][1:][: max(int(at * poses), 1)]
    with pytest.raises(mp.errors.InvalidInputError, match=r"x y z = 0\.(19|20)\d .* turns the tool in place or back"):
        check_tool_speed(speed, mp.CartesianPath.through(np.concatenate([there, back])))


@given(radius=st.floats(1e-3, 0.05))
def test_a_narrow_turn_is_not_a_turn_back(radius):
    angles = np.linspace(0.0, np.pi, 200)
    line = np.linspace([0.0, 0.0], [0.1, 0.0], 50)[:-1]
    turn = np.column_stack([0.1 + radius * np.sin(angles), radius * (1 - np.cos(angles))])
    way = np.concatenate([line, turn, (line * [1.0, 0.0] + [0.0, 2 * radius])[::-1]])
    poses = np.tile(np.eye(4), (len(way), 1, 1))
    poses[:, :2, 3] = way
    assert check_tool_speed(0.05, mp.CartesianPath.through(poses)) == 0.05


@pytest.mark.parametrize("speed", [0.0, -0.1, np.nan, np.inf, "fast", True])
def test_wrong_speeds_are_refused_before_the_work(panda, line, speed):
    told = []
    with pytest.raises(mp.errors.InvalidInputError, match="tool_speed"):
        mp.follow(panda, line, tool_speed=speed, positions=3, progress=lambda *each: told.append(each), **FEW)
    assert told == []
