"""Timing: limits hold exactly, the motion is fast, and failure says why."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
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
    trajectory = mp.retime(path, panda.limits, joint_names=panda.joint_names)
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
    trajectory = mp.retime(path, panda.limits)
    dense = path(np.linspace(0, 1, 40001))
    for q in trajectory(np.linspace(0, trajectory.duration, 60)):
        assert np.abs(dense - q).max(axis=1).min() < 2e-4


def test_one_joint_takes_the_textbook_time():
    """A trapezoid: v = 1, a = 2 over 3 rad takes 3 / v + v / a = 3.5 s."""
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=1.0, acceleration=2.0)
    trajectory = mp.retime(mp.JointPath.line([0.0, 0.0], [3.0, 0.0]), robot.limits)
    assert trajectory.duration == pytest.approx(3.5, rel=2e-3)


def test_torque_limits_hold_and_slow_the_motion(panda):
    path = mp.JointPath.line(panda.neutral, panda.neutral + [1.2, 0.8, -0.5, 0.6, 0.3, 0.4, 0.2])
    data = panda.model.createData()
    weight = np.abs([pin.computeGeneralizedGravity(panda.model, data, q) for q in path(np.linspace(0, 1, 100))]).max(axis=0)
    weak = panda.with_limits(effort=1.1 * weight + 1.0)
    free = mp.retime(path, weak.limits)
    assert mp.torque_use(free, weak.model, weak.limits.effort).ratio > 1.5
    held = mp.retime(path, weak.limits, torque_model=weak.model)
    assert mp.torque_use(held, weak.model, weak.limits.effort, inside=40).ratio <= 1 + 1e-6
    assert free.duration * 1.05 < held.duration < free.duration * 5


def test_gravity_beyond_the_effort_names_the_joint(panda):
    weak = panda.with_limits(effort=np.array([87.0, 5.0, 87, 87, 12, 12, 12]))
    path = mp.JointPath.line(panda.neutral, panda.neutral + 0.3)
    with pytest.raises(mp.PlanningError, match=r"gravity alone asks q1 .* at s ="):
        mp.retime(path, weak.limits, torque_model=weak.model)


def test_corners_are_stops():
    robot = mp.planar_arm([1.0, 1.0])
    path = mp.JointPath.through([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
    trajectory = mp.retime(path, robot.limits)
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
    trajectory = mp.retime(polynomial(np.array(control).T), robot.limits)
    use = limit_use(trajectory, robot.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1
    assert trajectory.duration < 10


@pytest.mark.parametrize(
    "control",
    [[[0, 0], [0, 0], [0.7, 0.3], [1, 1]], [[0, 0], [0, 0], [0, 0], [1, 1], [1, 1], [1, 1]], [[0, 0], [1, 1], [1, 1]]],
)
def test_a_path_that_starts_or_ends_standing_is_timed(control):
    robot = mp.planar_arm([1.0, 1.0])
    trajectory = mp.retime(polynomial(np.array(control, dtype=float)), robot.limits)
    use = limit_use(trajectory, robot.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1
    assert trajectory.duration < 1.5
    np.testing.assert_allclose(trajectory.q[-1], control[-1], atol=1e-9)


def test_a_sharp_bend_does_not_slow_the_whole_motion():
    robot = mp.planar_arm([1.0, 1.0]).with_limits(velocity=1.0, acceleration=10.0)
    hairpin = polynomial([[0.829921, 0], [-0.992079, 0.0005], [1.185921, 0.001]])
    stopping = mp.JointPath.through([hairpin(0.0), hairpin(0.4555), hairpin(1.0)])
    ratio = mp.retime(hairpin, robot.limits).duration / mp.retime(stopping, robot.limits).duration
    assert ratio < 1.3


@pytest.mark.parametrize("middle", [0.3, 0.4, 0.5, 0.77])
def test_a_standstill_at_a_break_is_one_stop(middle):
    robot = mp.planar_arm([1.0, 1.0])
    control = [[[0, 0], [0.5, 0.5], [0.5, 0.5]], [[0.5, 0.5], [0.5, 0.5], [1.0, 0.0]]]
    trajectory = mp.retime(mp.JointPath(breaks=[0, middle, 1], control=control), robot.limits)
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
    with pytest.raises(mp.InvalidInputError, match="limits"):
        mp.retime(path, planar.limits)
    with pytest.raises(mp.InvalidInputError, match="a finite acceleration for each joint"):
        mp.retime(path, panda.with_limits(acceleration=np.inf).limits)
    with pytest.raises(mp.InvalidInputError, match="grid"):
        mp.retime(path, panda.limits, grid=49)
    with pytest.raises(mp.InvalidInputError, match="a path with a length"):
        mp.retime(mp.JointPath(breaks=[0, 1], control=np.zeros((1, 3, 7))), panda.limits)


def test_pieces_that_stand_still_are_left_out():
    robot = mp.planar_arm([1.0, 1.0])
    still = np.array([[[0, 0], [1, 1]], [[1, 1], [1, 1]], [[1, 1], [2, 1]]], dtype=float)
    trajectory = mp.retime(mp.JointPath(breaks=[0, 0.3, 0.6, 1], control=still), robot.limits)
    without = mp.retime(mp.JointPath.through([[0, 0], [1, 1], [2, 1]]), robot.limits)
    assert trajectory.duration == pytest.approx(without.duration, rel=1e-2)
    assert limit_use(trajectory, robot.limits)["acceleration"].ratio <= 1
