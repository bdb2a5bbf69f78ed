"""Timing: limits hold exactly, the motion is fast, and failure says why."""

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.paths.joint import cut
from manipplan.timing.verify import limit_use


def polynomial(control):
    return mp.JointPath(breaks=[0.0, 1.0], control=np.asarray(control)[None])


def dense_ratios(trajectory, limits):
    """Demand over limit on a dense grid: a second way to what `limit_use` finds in closed form."""
    t = np.linspace(0, trajectory.duration, 20001)
    return (
        (np.abs(trajectory(t, 1)) / limits.velocity).max(),
        (np.abs(trajectory(t, 2)) / limits.acceleration).max(),
    )


@pytest.mark.parametrize("degree", [1, 2, 4, 7])
def test_limits_hold_and_one_of_them_binds(panda, rng, degree):
    path = polynomial(panda.random_configuration(rng, size=degree + 1))
    trajectory = mp.retime(path, panda)
    use = limit_use(trajectory, panda.limits)
    velocity, acceleration = dense_ratios(trajectory, panda.limits)
    assert use["velocity"].ratio <= 1
    assert use["acceleration"].ratio <= 1
    assert velocity <= use["velocity"].ratio + 1e-12
    assert acceleration <= use["acceleration"].ratio + 1e-12
    assert acceleration > 0.97 * use["acceleration"].ratio
    assert max(use["velocity"].ratio, use["acceleration"].ratio) > 0.98
    np.testing.assert_allclose(trajectory.q[[0, -1]], [path.start, path.goal], atol=1e-9)
    np.testing.assert_allclose(trajectory.qd[[0, -1]], 0, atol=1e-9)


def test_every_sample_is_on_the_path(panda, rng):
    path = polynomial(panda.random_configuration(rng, size=4))
    trajectory = mp.retime(path, panda)
    dense = path(np.linspace(0, 1, 40001))
    for q in trajectory(np.linspace(0, trajectory.duration, 60)):
        assert np.abs(dense - q).max(axis=1).min() < 2e-4


def test_one_joint_takes_the_textbook_time():
    """A trapezoid: v = 1, a = 2 over 3 rad takes 3 / v + v / a = 3.5 s."""
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=1.0, acceleration=2.0)
    trajectory = mp.retime(mp.JointPath.line([0.0, 0.0], [3.0, 0.0]), robot)
    assert trajectory.duration == pytest.approx(3.5, rel=2e-3)


def test_given_limits_replace_those_of_the_robot(planar):
    """Joint names come from the robot; its own limits do not count."""
    path, slow = mp.JointPath.line([0.0, 0.0, 0.0], [1.0, -0.4, 0.2]), planar.with_limits(velocity=0.05, acceleration=0.2)
    usual, given = mp.retime(path, planar), mp.retime(path, planar, limits=slow.limits)
    assert usual.joint_names == given.joint_names == planar.joint_names
    np.testing.assert_array_equal(given.q, mp.retime(path, slow).q)
    np.testing.assert_array_equal(mp.retime(path, slow, limits=planar.limits).q, usual.q)
    assert given.duration > 2 * usual.duration


def test_torque_limits_hold_and_slow_the_motion(panda):
    path = mp.JointPath.line(panda.neutral, panda.neutral + [1.2, 0.8, -0.5, 0.6, 0.3, 0.4, 0.2])
    data = panda.model.createData()
    weight = np.abs([pin.computeGeneralizedGravity(panda.model, data, q) for q in path(np.linspace(0, 1, 100))]).max(axis=0)
    weak = panda.with_limits(effort=1.1 * weight + 1.0)
    free = mp.retime(path, weak)
    assert mp.torque_use(free, weak.model, weak.limits.effort).ratio > 1.5
    held = mp.retime(path, weak, torque=True)
    assert mp.torque_use(held, weak.model, weak.limits.effort, inside=40).ratio <= 1 + 1e-6
    assert free.duration * 1.05 < held.duration < free.duration * 5


def test_gravity_beyond_the_effort_names_the_joint(panda):
    weak = panda.with_limits(effort=np.array([87.0, 5.0, 87, 87, 12, 12, 12]))
    path = mp.JointPath.line(panda.neutral, panda.neutral + 0.3)
    with pytest.raises(mp.errors.PlanningError, match=r"gravity alone loads panda_joint2 .* at s ="):
        mp.retime(path, weak, torque=True)


def test_corners_are_stops():
    robot = mp.planar_arm([1.0, 1.0])
    path = mp.JointPath.through([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
    trajectory = mp.retime(path, robot)
    use = limit_use(trajectory, robot.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1
    corner = np.abs(trajectory.q - [1.0, 0.0]).max(axis=1).argmin()
    np.testing.assert_allclose(trajectory.qd[corner], 0, atol=1e-9)


def test_a_standstill_inside_the_path_is_a_stop():
    """Today's toppra answers Ok here with acceleration at 2.13 times its limit."""
    robot = mp.planar_arm([1.0, 1.0])
    # q = (x³, x²) with x = 2s - 1: q' = 0 in the middle, where the path has a cusp
    x = np.polynomial.Polynomial([-1.0, 2.0])
    control = []
    for power in (3, 2):
        c = np.pad((x**power).coef, (0, 3 - power))
        control.append([c[0], c[0] + c[1] / 3, c[0] + 2 * c[1] / 3 + c[2] / 3, c.sum()])
    trajectory = mp.retime(polynomial(np.array(control).T), robot)
    use = limit_use(trajectory, robot.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1
    assert trajectory.duration < 10


@pytest.mark.parametrize(
    "control",
    [[[0, 0], [0, 0], [0.7, 0.3], [1, 1]], [[0, 0], [0, 0], [0, 0], [1, 1], [1, 1], [1, 1]], [[0, 0], [1, 1], [1, 1]]],
)
def test_a_path_that_starts_or_ends_standing_is_timed(control):
    robot = mp.planar_arm([1.0, 1.0])
    trajectory = mp.retime(polynomial(np.array(control, dtype=float)), robot)
    use = limit_use(trajectory, robot.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1
    assert trajectory.duration < 1.5
    np.testing.assert_allclose(trajectory.q[-1], control[-1], atol=1e-9)


def test_a_sharp_bend_does_not_slow_the_whole_motion():
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=1.0, acceleration=10.0)
    hairpin = polynomial([[0.829921, 0], [-0.992079, 0.0005], [1.185921, 0.001]])
    stopping = mp.JointPath.through([hairpin(0.0), hairpin(0.4555), hairpin(1.0)])
    ratio = mp.retime(hairpin, robot).duration / mp.retime(stopping, robot).duration
    assert ratio < 1.3


@pytest.mark.parametrize("jerk", [np.inf, 500.0])
def test_a_jump_of_the_parameter_does_not_slow_the_motion(panda, jerk):
    """The same curve in parts whose ‖q'‖ differ where they meet, as after a blend."""
    q = np.array(
        [panda.neutral, panda.neutral + [0.4, 0.2, 0, 0.3, 0, 0.2, 0], panda.neutral + [0.6, -0.3, 0.4, 0.0, 0, 0, 0.5]]
    )
    smooth = mp.JointPath.spline([0.0, 0.4, 1.0], q)
    parts = [cut(smooth, begin, end) for begin, end in pairwise([0.0, 0.3, 0.4, 0.7, 1.0])]
    joined = mp.JointPath(breaks=[0.0, 0.2, 0.5, 0.6, 1.0], control=np.concatenate([each.control[:1] for each in parts]))
    arm = replace(panda, limits=replace(panda.limits, jerk=np.full(7, jerk)))
    assert mp.retime(joined, arm).duration == pytest.approx(mp.retime(smooth, arm).duration, rel=5e-3)


@pytest.mark.parametrize("middle", [0.3, 0.4, 0.5, 0.77])
def test_a_standstill_at_a_break_is_one_stop(middle):
    robot = mp.planar_arm([1.0, 1.0])
    control = [[[0, 0], [0.5, 0.5], [0.5, 0.5]], [[0.5, 0.5], [0.5, 0.5], [1.0, 0.0]]]
    trajectory = mp.retime(mp.JointPath(breaks=[0, middle, 1], control=control), robot)
    use = limit_use(trajectory, robot.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1
    assert trajectory.duration < 2.0


def test_position_extremes_of_nearly_quadratic_pieces():
    """c3 of a piece at constant acceleration is all but zero: its roots must not cancel."""
    t = np.array([0.0, 0.1])
    q = np.array([[0.0], [0.0]])
    qd = np.array([[0.06], [-0.06 * (1 + 1e-15)]])
    trajectory = mp.Trajectory(t=t, q=q, qd=qd, joint_names=("a",))
    arm = mp.planar_arm([1.0, 1.0]).with_limits(lower=-1.0, upper=1.0)
    limits = mp.JointLimits(
        **{name: getattr(arm.limits, name)[:1] for name in ("lower", "upper", "velocity", "acceleration", "jerk", "effort")}
    )
    assert limit_use(trajectory, limits)["position"].ratio == pytest.approx(0.0015 - 1, abs=1e-12)


def test_wrong_arguments(panda, planar):
    path = mp.JointPath.line(panda.neutral, panda.neutral + 0.1)
    with pytest.raises(mp.errors.InvalidInputError, match="robot: got 'an arm of 3 joints'; allowed: .* 7 joints"):
        mp.retime(path, planar)
    with pytest.raises(mp.errors.InvalidInputError, match="robot: got "):
        mp.retime(path, panda.limits)
    with pytest.raises(mp.errors.InvalidInputError, match="limits: got 'limits of 3 joints'; allowed: .* 7 joints"):
        mp.retime(path, panda, limits=planar.limits)
    with pytest.raises(mp.errors.InvalidInputError, match="limits: got "):
        mp.retime(path, panda, limits=panda)
    with pytest.raises(mp.errors.InvalidInputError, match="torque: got "):
        mp.retime(path, panda, torque=panda.model)
    with pytest.raises(mp.errors.InvalidInputError, match="a finite acceleration for each joint"):
        mp.retime(path, panda.with_limits(acceleration=np.inf))
    with pytest.raises(mp.errors.InvalidInputError, match="grid"):
        mp.retime(path, panda, grid=49)
    with pytest.raises(mp.errors.InvalidInputError, match="a path with a length"):
        mp.retime(mp.JointPath(breaks=[0, 1], control=np.zeros((1, 3, 7))), panda)


def test_pieces_that_stand_still_are_left_out():
    robot = mp.planar_arm([1.0, 1.0])
    still = np.array([[[0, 0], [1, 1]], [[1, 1], [1, 1]], [[1, 1], [2, 1]]], dtype=float)
    trajectory = mp.retime(mp.JointPath(breaks=[0, 0.3, 0.6, 1], control=still), robot)
    without = mp.retime(mp.JointPath.through([[0, 0], [1, 1], [2, 1]]), robot)
    assert trajectory.duration == pytest.approx(without.duration, rel=1e-2)
    assert limit_use(trajectory, robot.limits)["acceleration"].ratio <= 1


def jerk_limited(robot, **changes):
    return robot.limits.with_changes(changes)


@pytest.mark.parametrize("jerk", [1.0, 10.0, 1000.0])
def test_jerk_alone_takes_the_textbook_time(jerk):
    """Rest to rest over L under jerk j: four phases of (L / 2j)^(1/3), together (32 L / j)^(1/3)."""
    robot = mp.planar_arm([1.0, 1.0])
    limits = jerk_limited(robot, velocity=100.0, acceleration=1000.0, jerk=jerk)
    trajectory = mp.retime(mp.JointPath.line([0.0, 0.0], [1.0, 0.3]), robot, limits=limits)
    assert trajectory.duration == pytest.approx((32 / jerk) ** (1 / 3), rel=5e-3)
    assert trajectory.duration >= (32 / jerk) ** (1 / 3) * (1 - 1e-9)


def test_the_seven_phases_take_the_textbook_time():
    """L / v + v / a + a / j."""
    robot = mp.planar_arm([1.0, 1.0])
    limits = jerk_limited(robot, velocity=1.0, acceleration=2.0, jerk=20.0)
    trajectory = mp.retime(mp.JointPath.line([0.0, 0.0], [3.0, 0.3]), robot, limits=limits)
    assert trajectory.duration == pytest.approx(3 + 0.5 + 0.1, rel=5e-3)


@pytest.mark.parametrize("jerk", [5.0, 200.0, 7500.0])
def test_jerk_holds_and_acceleration_is_continuous(panda, rng, jerk):
    limits = jerk_limited(panda, jerk=jerk)
    path = polynomial(panda.random_configuration(rng, size=5))
    trajectory = mp.retime(path, panda, limits=limits)
    t = trajectory.t
    before, after = trajectory(np.nextafter(t[1:-1], 0), 2), trajectory(t[1:-1], 2)
    assert np.abs(before - after).max() < 1e-9 * limits.acceleration.max() + 1e-10 * jerk
    assert np.abs(trajectory(t[[0, -1]], 2)).max() < 1e-9 * limits.acceleration.max()
    assert np.abs(trajectory(t, 3)).max() <= jerk * (1 + 1e-9)
    assert mp.jerk_use(trajectory, limits).ratio <= 1
    assert max(dense_ratios(trajectory, limits)) <= 1 + 1e-9
    free = mp.retime(path, panda, limits=jerk_limited(panda, jerk=np.inf))
    assert free.duration <= trajectory.duration
    assert jerk < 1000 or trajectory.duration < 1.03 * free.duration
    dense = path(np.linspace(0, 1, 40001))
    for q in trajectory(np.linspace(0, trajectory.duration, 60)):
        assert np.abs(dense - q).max(axis=1).min() < 2e-4


def test_acceleration_does_not_swing_where_a_speed_limit_holds(panda):
    """Under a jerk limit that hardly counts, a spline held at its knots alone swings about the limit between them."""
    path = polynomial(
        [
            [-0.2, 0.1, -0.5, -2.1, -0.3, 1.9, -0.9],
            [0.4, 0.9, 0.6, -1.2, 0.3, 1.2, 0.4],
            [-1.5, 0.0, 2.6, -2.0, -0.5, 2.1, -0.6],
        ]
    )
    trajectory = mp.retime(path, panda)
    inner = (trajectory.t > 0.1) & (trajectory.t < trajectory.duration - 0.1)
    qdd = trajectory(trajectory.t, 2)[inner]
    held = np.abs(trajectory.qd[inner] / panda.limits.velocity).max(axis=1) > 0.99
    assert held.sum() > 50
    rises = np.diff(qdd, axis=0)
    turning = (rises[1:] * rises[:-1] < 0) & (np.minimum(np.abs(rises[1:]), np.abs(rises[:-1])) > 0.1) & held[1:-1, None]
    assert turning.sum() < 10


@pytest.mark.parametrize("kind", ["csv", "json", "ros", "npz"])
def test_files_keep_the_jerk_limit(planar, tmp_path, kind):
    limits = jerk_limited(planar, jerk=30.0)
    trajectory = mp.retime(mp.JointPath.line([0, 0, 0], [1.0, -0.4, 0.2]), planar, limits=limits)
    file = tmp_path / f"motion.{kind}"
    getattr(trajectory, f"to_{kind}")(file)
    again = getattr(mp.Trajectory, f"from_{kind}")(file)
    np.testing.assert_array_equal(again.qd, trajectory.qd)
    assert mp.jerk_use(again, limits).ratio <= 1 + 1e-6


def test_jumps_of_acceleration_are_infinite_jerk(planar):
    limits = jerk_limited(planar, jerk=30.0)
    trajectory = mp.retime(mp.JointPath.line([0, 0, 0], [1.0, -0.4, 0.2]), planar)
    assert mp.jerk_use(trajectory, limits).ratio == np.inf
    assert mp.jerk_use(trajectory, planar.limits).ratio == 0


def test_jerk_with_corners_stops_and_torque(panda):
    limits = jerk_limited(panda, jerk=100.0, effort=panda.limits.effort * 0.8)
    points = panda.neutral + np.array([[0.0] * 7, [0.5, 0.3, 0, 0.2, 0, 0, 0], [0.2, 0.6, 0.3, 0, 0, 0.4, 0]])
    trajectory = mp.retime(mp.JointPath.through(points), panda, limits=limits, torque=True)
    assert mp.jerk_use(trajectory, limits).ratio <= 1
    assert mp.torque_use(trajectory, panda.model, limits.effort, inside=40).ratio <= 1 + 1e-6


@pytest.mark.parametrize("jerk", [np.inf, 60.0])
@pytest.mark.parametrize(("start", "end"), [(0.4, 0.0), (0.0, 0.4), (0.3, 0.5)])
def test_speeds_at_the_ends(panda, rng, start, end, jerk):
    limits = jerk_limited(panda, jerk=jerk)
    path = mp.JointPath(breaks=[0.0, 1.0], control=rng.uniform(-1, 1, (1, 4, 7)))
    trajectory = mp.retime(path, panda, limits=limits, start_speed=start, end_speed=end)
    np.testing.assert_allclose(np.linalg.norm(trajectory.qd[[0, -1]], axis=1), [start, end], rtol=1e-9)
    for k, s, speed in ((0, 0.0, start), (-1, 1.0, end)):
        tangent = path(s, 1) / np.linalg.norm(path(s, 1))
        np.testing.assert_allclose(trajectory.qd[k], speed * tangent, atol=1e-4 * speed)
    assert max(dense_ratios(trajectory, limits)) <= 1 + 1e-6
    assert mp.jerk_use(trajectory, limits).ratio <= 1 + 1e-8
    assert trajectory.duration < mp.retime(path, panda, limits=limits).duration


@pytest.mark.slow
def test_speeds_that_limits_do_not_allow():
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=[1.0, 2.0], acceleration=2.0)
    path = mp.JointPath.line([0.0, 0.0], [0.01, 0.0])
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"start_speed: got 1.5; allowed: 0 to 1: the velocity limit of joint1 .* s = 0"
    ):
        mp.retime(path, robot, start_speed=1.5)
    # v² / 2a = 0.01
    with pytest.raises(mp.errors.InvalidInputError, match=r"start_speed: got 0.5; allowed: 0 to 0.199.* slow down in time"):
        mp.retime(path, robot, start_speed=0.5)
    with pytest.raises(mp.errors.InvalidInputError, match=r"end_speed: got 0.5; allowed: 0 to 0.199.* cannot be reached"):
        mp.retime(path, robot, end_speed=0.5)
    mp.retime(path, robot, start_speed=0.195)
    limits = jerk_limited(robot, jerk=1.0)
    with pytest.raises(mp.errors.InvalidInputError, match=r"start_speed: got 0.19.*within the jerk limits"):
        mp.retime(path, robot, limits=limits, start_speed=0.19)


def test_segments_hold_where_they_are_and_nowhere_else():
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=1.0, acceleration=4.0)
    path = mp.JointPath.line([0.0, 0.0], [4.0, 1.0])  # s = q0 / 4
    slow = robot.limits.with_changes({"velocity": 0.3})
    for segment in (mp.Segment(begin=0.2, end=0.4, velocity=0.3), mp.Segment(begin=0.2, end=0.4, limits=slow)):
        trajectory = mp.retime(path, robot, segments=[segment])
        t = np.linspace(0, trajectory.duration, 20001)
        s, speed = trajectory(t)[:, 0] / 4, trajectory(t, 1)[:, 0]
        inside = (s >= 0.2 + 1e-9) & (s <= 0.4 - 1e-9)
        assert 0.299 < speed[inside].max() <= 0.3 + 1e-9
        assert speed[~inside].max() == pytest.approx(1.0, rel=1e-6)
        # 0.8 rad at 0.3, and on both sides ramps of 0 to 1 and 1 to 0.3
        left, right = 0.8 / 1 + 0.5 / 4 + 0.49 / 8, 2.4 / 1 + 0.5 / 4 + 0.49 / 8
        assert trajectory.duration == pytest.approx(left + 0.8 / 0.3 + right, rel=3e-3)


@pytest.mark.slow
@given(limit=st.floats(0.1, 10.0))
@settings(max_examples=30, deadline=None)
def test_the_speed_that_a_message_allows_is_allowed(limit):
    robot, path = (
        mp.planar_arm([1.0, 1.0]).with_limits(velocity=limit, acceleration=1e3),
        mp.JointPath.line([0.0, 0.0], [1.0, 0.3]),
    )
    with pytest.raises(mp.errors.InvalidInputError, match="the velocity limit of") as told:
        mp.retime(path, robot, start_speed=20.0)
    assert mp.retime(path, robot, start_speed=float(re.search(r"0 to ([\d.e+-]+):", str(told.value))[1])).duration > 0


def test_segments_overlap_and_survive_pieces_left_out():
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=1.0, acceleration=4.0)
    still = np.array([[[0, 0], [2, 0]], [[2, 0], [2, 0]], [[2, 0], [4, 0]]], dtype=float)
    path = mp.JointPath(breaks=[0, 0.4, 0.6, 1], control=still)
    segments = [mp.Segment(begin=0.7, end=0.9, velocity=0.5), mp.Segment(begin=0.8, end=1.0, velocity=0.25, acceleration=0.5)]
    trajectory = mp.retime(path, robot, segments=segments)
    t = np.linspace(0, trajectory.duration, 20001)
    q, qd, qdd = (trajectory(t, k)[:, 0] for k in range(3))
    assert qd[(q > 2.5001) & (q < 2.9999)].max() == pytest.approx(0.5, rel=1e-3)
    assert qd[q > 3.0001].max() == pytest.approx(0.25, rel=1e-3)
    assert np.abs(qdd[q > 3.0001]).max() <= 2 + 1e-6
    assert qd.max() == pytest.approx(1.0, rel=1e-3)


@pytest.mark.slow
def test_the_tool_keeps_its_speed(planar):
    path = polynomial([[0.1, 0.5, 0.3], [0.8, -0.5, 1.2], [1.2, 1.0, -0.3]])
    segment = mp.Segment(begin=0.3, end=0.7, tool_speed=0.2)
    trajectory = mp.retime(path, planar, segments=[segment])
    kinematics = planar.kinematics(mp.Task.position())
    t = np.linspace(0, trajectory.duration, 4001)
    speed = np.array([np.linalg.norm(kinematics.jacobian(q) @ v) for q, v in zip(trajectory(t), trajectory(t, 1), strict=True)])
    fine = np.linspace(0, 1, 20001)
    at = np.array([fine[np.abs(path(fine) - q).max(axis=1).argmin()] for q in trajectory(t[::20])])
    inside = (at > 0.301) & (at < 0.699)
    assert 0.19 < speed[::20][inside].max() <= 0.2 * (1 + 1e-4)
    assert speed.max() > 0.4


@pytest.mark.slow
@pytest.mark.parametrize("name", ["z1", "so100", "b1_z1"])
def test_a_tool_whose_name_a_joint_has_too_keeps_its_speed(name):
    robot = mp.load_robot(name)
    assert sum(frame.name == robot.tool for frame in robot.model.frames) > 1
    inside = (robot.limits.lower + robot.limits.upper) / 2
    path = mp.JointPath.line(inside, inside + 0.1 * (robot.limits.upper - inside))
    trajectory = mp.retime(path, robot, segments=[mp.Segment(begin=0.0, end=1.0, tool_speed=0.02)])
    t = np.linspace(0, trajectory.duration, 400)
    data, link = robot.model.createData(), robot.model.getFrameId(robot.tool, pin.FrameType.BODY)
    places = []
    for q in trajectory(t):
        pin.framesForwardKinematics(robot.model, data, q)
        places.append(data.oMf[link].translation.copy())
    assert 0.019 < np.linalg.norm(np.diff(places, axis=0), axis=1).max() / (t[1] - t[0]) <= 0.02 * (1 + 1e-4)


def test_wrong_speeds_and_segments(panda, planar):
    path = mp.JointPath.line(panda.neutral, panda.neutral + 0.1)
    for options, match in (
        ({"start_speed": -1.0}, "start_speed: got -1.0; allowed: a finite number, at least 0"),
        ({"end_speed": np.nan}, "end_speed"),
        ({"segments": 3}, "segments: got 3; allowed: a list of Segment"),
        ({"segments": [3]}, r"segments\[0\]"),
        ({"segments": [mp.Segment(begin=0, end=1, limits=planar.limits)]}, r"segments\[0\].limits"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=match):
            mp.retime(path, panda, **options)
    for options, match in (
        ({"begin": 0.5, "end": 0.5}, "segment.end"),
        ({"begin": -0.1, "end": 0.5}, "segment.begin"),
        ({"begin": 0.0, "end": 0.5, "velocity": 1.5}, "segment.velocity"),
        ({"begin": 0.0, "end": 0.5, "acceleration": 0.0}, "segment.acceleration"),
        ({"begin": 0.0, "end": 0.5, "tool_speed": 0.0}, "segment.tool_speed"),
        ({"begin": 0.0, "end": 0.5, "tool_speed": np.array([1.0, 2.0])}, "segment.tool_speed"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=match):
            mp.Segment(**options)


def test_limits_of_another_arm_tell_nothing_of_jerk(panda, planar):
    trajectory = mp.retime(mp.JointPath.line(panda.neutral, panda.neutral + 0.1), panda)
    with pytest.raises(mp.errors.InvalidInputError, match="limits: got 'limits of 3 joints'; allowed: .* 7 joints"):
        mp.jerk_use(trajectory, planar.limits)
    with pytest.raises(mp.errors.InvalidInputError, match="trajectory: got None"):
        mp.jerk_use(None, panda.limits)


@pytest.mark.parametrize("kind", ["velocity", "acceleration", "jerk"])
def test_limits_beyond_all_sense(panda, kind):
    path = mp.JointPath.line(panda.neutral, panda.neutral + 0.1)
    with pytest.raises(mp.errors.InvalidInputError, match=f"limits.{kind}.*at least 1e-09"):
        mp.retime(path, panda, limits=panda.limits.with_changes({kind: 1e-50}))
    if kind != "jerk":
        with pytest.raises(mp.errors.InvalidInputError, match=f"limits.{kind}.*at most 1e.12"):
            mp.retime(path, panda, limits=panda.limits.with_changes({kind: 1e300}))
