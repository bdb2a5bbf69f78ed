"""track: whole paths, tubes, and what is told when a path cannot be followed."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.measures.names import MEASURES
from manipplan.paths.cartesian import CartesianPath

DT = 0.01
Q = np.array([0.3, 0.8, 0.7])


@pytest.fixture(scope="module")
def arm():
    return mp.planar_arm([0.4, 0.3, 0.2]).with_limits(lower=-2.5, upper=2.5, velocity=2.0, acceleration=8.0)


def line(robot, q, shift, task=None):
    start = np.array(robot.kinematics(task).pose(q))
    end = start.copy()
    end[:3, 3] += shift
    return CartesianPath.line(start, end)


def track(robot, path, start, formulation=None, duration=None, **options):
    options.setdefault("compiled", False)
    return mp.track(
        robot, path, start, formulation or mp.formulations.LogDrive(), dt=options.pop("dt", DT), duration=duration, **options
    )


def assert_within_limits(robot, tracking):
    """The motion of the samples, from the start at rest to its end at rest."""
    dt, limits = tracking.t[1], robot.limits
    assert not limits.outside(tracking.q).any()
    assert (np.abs(tracking.qd) <= limits.velocity * (1 + 1e-12)).all()
    assert (np.abs(np.diff(tracking.qd, axis=0)) <= dt * limits.acceleration * (1 + 1e-9)).all()
    np.testing.assert_allclose(np.diff(tracking.q, axis=0), dt * tracking.qd[1:], atol=1e-12)
    assert not tracking.qd[0].any()
    assert not tracking.qd[-1].any()


# ---- what comes of a path


def test_a_path_is_followed_from_rest_to_rest(arm):
    path = line(arm, Q, [-0.2, 0.1, 0.0])
    tracking = track(arm, path, Q)
    assert tracking.status is mp.Status.TRACKED
    assert tracking.status.ok
    assert_within_limits(arm, tracking)
    np.testing.assert_array_equal(tracking.q[0], Q)
    np.testing.assert_allclose(arm.kinematics().pose(tracking.q[-1])[:2, 3], path(1.0)[:2, 3], atol=1e-4)
    assert tracking.deviation.max() < 1e-3
    assert tracking.braked == tracking.convexified == 0


def test_the_timing_is_cubic(arm):
    """s = 3u² - 2u³."""
    path = line(arm, Q, [-0.2, 0.1, 0.0])
    tracking = track(arm, path, Q, duration=1.0)
    u = np.arange(101) / 100
    np.testing.assert_allclose(tracking.targets[:101], path(3 * u**2 - 2 * u**3))
    assert tracking.duration == 1.0
    np.testing.assert_allclose(tracking.t, DT * np.arange(len(tracking.t)))


def test_what_is_told_equals_forward_kinematics(arm):
    tracking = track(arm, line(arm, Q, [-0.2, 0.1, 0.0]), Q, stiffness=20.0)
    kinematics = arm.kinematics()
    left = kinematics.pose(tracking.q)[:, :2, 3] - tracking.targets[:, :2, 3]
    assert tracking.deviation.max() > 0.01
    np.testing.assert_allclose(tracking.deviation, np.linalg.norm(left, axis=1), atol=1e-12)
    np.testing.assert_allclose(tracking.manipulability, kinematics.manipulability(tracking.q))
    assert len(tracking.reports) == len(tracking.solve_times) <= len(tracking.q) - 1


@pytest.mark.slow
def test_the_deviation_in_rotation_is_an_angle(panda):
    """Whatever the length of the task: a tool that stays behind by 0.2 rad."""
    start = np.array(panda.kinematics().pose(panda.neutral))
    turned = start.copy()
    turned[:3, :3] = pin.exp3(np.array([0.0, 0.0, 0.2])) @ start[:3, :3]
    for length in (0.1, 1.0):
        path = CartesianPath.line(turned, turned + np.diag([0, 0, 0, 0.0]) + _shift(1e-3))
        tracking = track(panda, path, panda.neutral, mp.formulations.General(), 0.05, task=mp.Task.pose(length))
        assert tracking.rotation_deviation[0] == pytest.approx(0.2)
        assert tracking.deviation[0] == pytest.approx(0.0, abs=1e-9)


def _shift(by):
    matrix = np.zeros((4, 4))
    matrix[0, 3] = by
    return matrix


@pytest.mark.slow
@pytest.mark.parametrize("name", ["arm", "panda"])
def test_inside_a_tube_the_manipulability_rises_and_the_tolerance_holds(request, name):
    """To 2 %, for what the path bends within a step; without the tube the same low stiffness leaves it."""
    robot = request.getfixturevalue(name)
    start = Q if name == "arm" else robot.neutral
    shift = [-0.1, 0.15, 0.0] if name == "arm" else [0.15, 0.1, -0.1]
    path, tube = line(robot, start, shift), mp.Tolerance(position=0.02, rotation=0.1)
    held = track(robot, path, start, mp.formulations.General(), 2.0)
    inside = track(robot, path, start, mp.formulations.LogDrive(), 2.0, tolerance=tube)
    free = track(robot, path, start, mp.formulations.LogDrive(), 2.0, stiffness=mp.StiffnessProfile())
    assert inside.status is mp.Status.TRACKED
    assert_within_limits(robot, inside)
    assert 0.01 < inside.deviation.max() <= 0.02 * 1.02
    assert inside.rotation_deviation.max() <= 0.1 * 1.02
    assert free.deviation.max() > 0.03
    assert held.manipulability.mean() < inside.manipulability.mean() < free.manipulability.mean()


BENT = np.array([0.3, 0.3, 1.8])
MEASURES_THAT_GROW = [
    mp.measures.VelocityTransmission(direction=(1.0, -2.0)) if kind is mp.measures.VelocityTransmission else kind()
    for kind in MEASURES.values()
    if kind.larger_is_better and not kind.constant
]


@pytest.mark.slow
@pytest.mark.parametrize("measure", MEASURES_THAT_GROW, ids=lambda each: each.name)
def test_the_given_measure_is_raised_while_the_tool_follows(arm, measure):
    """Above what it is without a drive, and above what driving Yoshikawa's manipulability gives."""
    path, shared = line(arm, BENT, [-0.1, 0.05, 0.0]), {"duration": 2.0, "dt": 0.02}
    still = track(arm, path, BENT, mp.formulations.Classical(), measure=measure, **shared)
    driven = track(arm, path, BENT, mp.formulations.LogDrive(), measure=measure, **shared)
    usual = track(arm, path, BENT, mp.formulations.LogDrive(), **shared)
    for each in (still, driven):
        assert each.status is mp.Status.TRACKED, each.message
        assert_within_limits(arm, each)
        assert each.deviation.max() < 1e-3
    kinematics = arm.kinematics(measure=measure)
    np.testing.assert_allclose(driven.manipulability, kinematics.manipulability(driven.q))
    assert driven.manipulability[0] == still.manipulability[0]
    assert driven.manipulability.mean() > 1.004 * still.manipulability.mean()
    if measure == mp.measures.Yoshikawa():
        np.testing.assert_array_equal(driven.q, usual.q)
    else:
        assert driven.manipulability.mean() > kinematics.manipulability(usual.q).mean()


def test_a_tolerance_may_change_along_the_path(arm):
    path = line(arm, Q, [-0.1, 0.15, 0.0])
    tracking = track(arm, path, Q, duration=2.0, tolerance=lambda s: mp.Tolerance(position=0.004 + 0.04 * s * (1 - s)))
    assert tracking.status is mp.Status.TRACKED, tracking.message
    u = np.minimum(np.arange(len(tracking.t)) / 200, 1.0)
    s = 3 * u**2 - 2 * u**3
    assert (tracking.deviation <= 1.02 * (0.004 + 0.04 * s * (1 - s))).all()
    assert tracking.deviation.max() > 0.008


def test_the_trajectory_keeps_acceleration_limits_throughout(arm):
    tracking = track(arm, line(arm, Q, [-0.2, 0.1, 0.0]), Q)
    use = mp.limit_use(tracking.trajectory(), arm.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1 + 1e-9


def test_without_a_duration_exact_tracking_uses_half_of_the_limits(arm):
    tracking = track(arm, line(arm, Q, [-0.2, 0.1, 0.0]), Q, mp.formulations.General())
    velocity = (np.abs(tracking.qd) / arm.limits.velocity).max()
    acceleration = (np.abs(np.diff(tracking.qd, axis=0)) / DT / arm.limits.acceleration).max()
    assert 0.3 < max(velocity, acceleration) < 0.75


def test_an_obstacle_on_the_way_is_passed_at_its_security_distance(arm):
    robot = arm.with_limits(acceleration=100.0)
    path = line(robot, Q, [-0.3, 0.2, 0.0])
    middle = path(0.5)[:3, 3] + [0.03, 0.03, 0.0]
    scene = mp.Scene([mp.Sphere(radius=0.05, position=middle, name="ball")])
    tracking = track(robot, path, Q, duration=2.0, avoidance=mp.Avoidance(scene=scene, security=0.02))
    assert tracking.status is mp.Status.TRACKED, tracking.message
    assert 0.02 - 1e-3 <= tracking.clearance.min() < 0.03
    assert "clearance" in str(tracking)


# ---- what cannot be followed is told


def test_a_path_out_of_reach_says_how_far_it_got(arm):
    tracking = track(arm, line(arm, Q, [1.0, 0.0, 0.0]), Q, duration=2.0)
    assert tracking.status is mp.Status.NOT_REACHED
    assert not tracking.status.ok
    missing = np.linalg.norm(arm.kinematics().pose(Q)[:2, 3] + [1.0, 0.0]) - 0.9
    assert tracking.deviation[-1] == pytest.approx(missing, abs=5e-3)
    assert f"{1e3 * tracking.deviation[-1]:.3g} mm" in tracking.message
    assert_within_limits(arm, tracking)


def test_a_tolerance_that_is_left_says_where_and_by_how_much(arm):
    tube = mp.Tolerance(position=0.01)
    tracking = track(arm, line(arm, Q, [1.0, 0.0, 0.0]), Q, duration=2.0, tolerance=tube)
    assert tracking.status is mp.Status.LEFT_TOLERANCE
    first = int(np.argmax(tracking.deviation > 0.01 * 1.02))
    assert f"t = {first * DT:.3f} s; allowed 0.01" in tracking.message
    assert f"deviates by {tracking.deviation[first]:.4g} m" in tracking.message


def test_a_path_that_is_too_fast_is_told(arm):
    tracking = track(arm, line(arm, Q, [-0.4, 0.3, 0.0]), Q, duration=0.05, tolerance=mp.Tolerance(position=0.02))
    assert tracking.status is mp.Status.LEFT_TOLERANCE
    assert_within_limits(arm, tracking)


def test_a_jump_at_the_start_is_followed_as_fast_as_limits_allow(arm):
    away = np.array(arm.kinematics().pose(Q))
    away[:3, 3] += [-0.2, 0.0, 0.0]
    end = away.copy()
    end[1, 3] += 0.05
    tracking = track(arm, CartesianPath.line(away, end), Q, mp.formulations.General(), 1.5)
    assert tracking.status is mp.Status.TRACKED, tracking.message
    assert tracking.deviation[0] == pytest.approx(0.2)
    assert_within_limits(arm, tracking)


def test_a_start_that_touches_an_obstacle_is_pushed_out(arm):
    tool = arm.kinematics().pose(Q)[:3, 3]
    scene = mp.Scene([mp.Sphere(radius=0.05, position=tool + [0.03, 0.02, 0.0], name="ball")])
    tracking = track(arm, line(arm, Q, [-0.25, 0.0, 0.0]), Q, duration=2.0, avoidance=mp.Avoidance(scene=scene))
    assert tracking.clearance[0] < 0
    assert (tracking.clearance[20:] > 0).all()
    assert tracking.status is mp.Status.TRACKED, tracking.message


def test_steps_without_a_sound_answer_are_counted(arm):
    """A profile that gives a stiffness of zero in the middle of the path."""
    path = line(arm, Q, [-0.2, 0.1, 0.0])
    tracking = track(arm, path, Q, duration=1.0, stiffness=lambda u: 0.0 if 0.4 < u < 0.5 else 1e4)
    assert tracking.status is mp.Status.BRAKED
    assert tracking.braked == sum(0.4 < k / 100 < 0.5 for k in range(101))
    assert f"{tracking.braked} steps" in tracking.message
    assert_within_limits(arm, tracking)


# ---- arguments


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"start": [0.0, 3.0, 0.0]}, r"start\[1\] \(joint2\): got 3.0.*-2.5 to 2.5"),
        ({"start": [0.0, 0.0]}, r"start: .*\(3,\)"),
        ({"start": [0.0, np.nan, 0.0]}, "start: .*no NaN"),
        ({"path": np.eye(4)}, "path: .*a CartesianPath"),
        ({"robot": "planar"}, "robot: got 'planar'"),
        ({"dt": 0.0}, "dt: got 0.0"),
        ({"dt": -0.01}, "dt: got -0.01"),
        ({"duration": 0.0}, "duration: got 0.0"),
        ({"duration": np.inf}, "duration: got inf"),
        ({"stiffness": 0.0}, "stiffness: got 0.0"),
        ({"stiffness": "stiff"}, "stiffness: got 'stiff'"),
        ({"tolerance": 0.01}, "tolerance: got 0.01.*a Tolerance, or a function"),
        ({"tolerance": lambda s: 0.01}, "tolerance: got"),
        (
            {"formulation": mp.formulations.Classical(), "tolerance": mp.Tolerance(position=0.1)},
            "tolerance: .*None with Classical",
        ),
        ({"formulation": 5e5}, "formulation: got 500000.0"),
        ({"measure": "condition_number"}, "measure: got 'condition_number'; allowed: .*at least zero and better when larger"),
        ({"measure": "yosikawa"}, "measure: got 'yosikawa'.*did you mean yoshikawa"),
        ({"task": mp.Task.pose()}, "task: got 'pose'; allowed: at most 3 rows"),
    ],
)
def test_what_cannot_be_tracked_raises(arm, given, message):
    arguments = {
        "robot": arm,
        "path": line(arm, Q, [0.1, 0, 0]),
        "start": Q,
        "dt": DT,
        "formulation": mp.formulations.LogDrive(),
        **given,
    }
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.track(**arguments, compiled=False)
