"""A plan as the reference of a servo and of a controller: what is taken, where the arm stays, and which limits hold."""

import itertools

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.tracking.reference import BRANCH, KNOTS, planned_beside, reference_of

DT = 0.004
TASK = mp.Task.pose(0.3)
FEW = {"positions": 8, "samples": 120}


@pytest.fixture(scope="module")
def panda():
    return mp.load_robot("panda").with_limits(jerk=np.inf)


def line_from(robot, q, shift):
    begin = np.array(robot.kinematics(TASK).pose(q))
    end = begin.copy()
    end[:3, 3] += shift
    return mp.CartesianPath.line(begin, end)


@pytest.fixture(scope="module")
def line(panda):
    return line_from(panda, panda.neutral, [0.1, 0.25, -0.1])


@pytest.fixture(scope="module")
def plan(panda, line):
    return mp.follow(panda, line, **FEW)


@pytest.fixture(scope="module")
def servo(panda, plan):
    return mp.Servo(panda, dt=DT, task=TASK, reference=plan)


@pytest.fixture(scope="module")
def plain(panda):
    return mp.Servo(panda, dt=DT, task=TASK)


def aside(kinematics, q, goal, angle):
    """The configuration at about the same pose, `angle` [rad] away through the null space."""
    pose, q = kinematics.pose(q), np.array(q)
    direction = None
    for _ in range(round(angle / 0.01)):
        null = np.linalg.svd(kinematics.jacobian(q))[2][-1]
        direction = null * np.sign(null @ (goal if direction is None else direction))
        q = q + 0.01 * direction
        for _ in range(3):
            here = kinematics.pose(q)
            turn = pin.log3(pose[:3, :3] @ here[:3, :3].T)
            error = np.concatenate([pose[:3, 3] - here[:3, 3], turn])
            q = q + np.linalg.pinv(kinematics.jacobian(q)) @ (error * np.repeat([1, TASK.length], 3))
    return q


def along(servo, q, line, seconds):
    """Positions (N + 1, n) of a servo that gets the twists of a line, and the deviation at the end [m]."""
    kinematics = servo.robot.kinematics(TASK)
    u = np.linspace(0, 1, round(seconds / DT) + 1)
    poses = line(3 * u**2 - 2 * u**3)
    servo.reset()
    q, qd = np.array(q), np.zeros(len(q))
    motion = [q]
    for before, target in itertools.pairwise(poses):
        here = kinematics.pose(q)
        turn = pin.log3(target[:3, :3] @ here[:3, :3].T)
        twist = np.concatenate([(target - before)[:3, 3] / DT + 10 * (before - here)[:3, 3], 10 * turn])
        qd = servo.step(q, qd, twist, "world")
        q = q + DT * qd
        motion.append(q)
    return np.array(motion), np.linalg.norm((kinematics.pose(q) - poses[-1])[:3, 3])


@pytest.mark.slow
def test_a_reference_is_the_part_of_the_plan_along_the_path(panda, plan, line):
    start = panda.states["default"] + np.array([0.4, 0.2, -0.3, 0.1, 0.2, 0.0, 0.1])
    led = mp.follow(panda, line, start=start, **FEW)
    reference = reference_of(led, panda, TASK)
    assert reference.q.shape == (KNOTS, 7) and reference.poses.shape == (KNOTS, 4, 4)
    assert np.allclose(reference.start, led.trajectory(led.path_begin), atol=1e-9)
    assert np.allclose(reference.q[-1], led.trajectory(led.trajectory.duration), atol=1e-9)
    assert np.allclose(reference.poses[0], line(0.0), atol=1e-4)
    assert np.allclose(reference.lead_in(0.0), start)
    assert np.allclose(reference.lead_in(reference.lead_in.duration), reference.start, atol=1e-9)
    assert reference.lead_in.duration == pytest.approx(led.path_begin)
    assert reference_of(plan, panda, TASK).lead_in is None


@pytest.mark.slow
def test_the_arm_returns_to_the_plan_through_the_null_space(panda, plan, line, servo, plain):
    kinematics = panda.kinematics(TASK)
    end = plan.trajectory(plan.trajectory.duration)
    for sign in (1, -1):
        start = aside(
            kinematics, servo.reference.start, sign * np.linalg.svd(kinematics.jacobian(servo.reference.start))[2][-1], 0.3
        )
        near, off = along(servo, start, line, 3.0)
        assert np.linalg.norm(near[0] - servo.reference.start) > 0.2
        assert np.linalg.norm(near[-1] - end) < 0.06 and off < 1e-3
        free, _ = along(plain, start, line, 3.0)
        assert np.linalg.norm(free[-1] - end) > 2 * np.linalg.norm(near[-1] - end)


@pytest.mark.slow
def test_from_another_branch_the_arm_is_not_pulled(panda, servo, plain):
    kinematics = panda.kinematics(TASK)
    null = np.linalg.svd(kinematics.jacobian(servo.reference.start))[2][-1]
    q = aside(kinematics, servo.reference.start, null, 2.6 * BRANCH)
    twist = np.array([0.05, 0.1, -0.05, 0.0, 0.0, 0.0])
    servo.reset()
    plain.reset()
    assert np.array_equal(servo.step(q, np.zeros(7), twist, "world"), plain.step(q, np.zeros(7), twist, "world"))
    servo.reset()
    plain.reset()
    q = servo.reference.start + 0.1 * null
    assert not np.array_equal(servo.step(q, np.zeros(7), twist, "world"), plain.step(q, np.zeros(7), twist, "world"))


def test_an_arm_at_rest_stays_at_rest(servo):
    servo.reset()
    assert not servo.step(servo.reference.q[90] + 0.1, np.zeros(7), np.zeros(6)).any()


@settings(max_examples=60)
@given(
    st.integers(0, KNOTS - 1), st.lists(st.floats(-1.2, 1.2), min_size=7, max_size=7),
    st.lists(st.floats(-0.5, 0.5), min_size=6, max_size=6), st.floats(0.2, 4.9),
)  # fmt: skip
def test_limits_hold_near_the_plan_and_away_from_it(servo, knot, shift, twist, factor):
    limits, dt = servo.robot.limits, factor * DT
    q, qd = np.clip(servo.reference.q[knot] + shift, limits.lower, limits.upper), np.zeros(7)
    servo.reset()
    for _ in range(20):
        before = qd
        qd = servo.step(q, qd, twist, "world", dt=dt)
        q = q + dt * qd
        assert (np.abs(qd) <= limits.velocity * (1 + 1e-12)).all()
        assert (np.abs(qd - before) <= limits.acceleration * dt * (1 + 1e-9) + 1e-12).all()
        assert (q >= limits.lower - 1e-9).all() and (q <= limits.upper + 1e-9).all()


def test_law_and_expression_find_the_same_place_on_the_plan(panda, servo):
    symbolic = panda.kinematics(TASK).symbolic
    q = symbolic.chain.q
    beside = ca.Function("beside", [q], [planned_beside(servo.reference, q, symbolic.chain.tool, TASK)])
    rng = np.random.default_rng(0)
    for knot in (0, 3, 50, 101, 160, 200):
        here = servo.reference.q[knot] + 0.02 * rng.standard_normal(7)
        servo.reset()
        servo.step(here, np.zeros(7), np.full(6, 0.01), "world")
        assert np.allclose(servo.law.beside[:7], beside(here).full().ravel(), atol=5e-3)
        exact = beside(servo.reference.q[knot]).full().ravel()
        assert np.allclose(exact, servo.reference.q[knot], atol=2e-3)


@pytest.mark.slow
def test_a_moved_base_moves_the_reference(line):
    base = pin.SE3(pin.rpy.rpyToMatrix(0.3, -0.5, 1.0), np.array([0.2, -0.1, 0.4])).homogeneous
    moved = mp.load_robot("panda").at(base)
    plan = mp.follow(moved, line_from(moved, moved.neutral, base[:3, :3] @ [0.05, 0.1, 0.0]), **FEW)
    reference = reference_of(plan, moved, TASK)
    data = moved.model.createData()
    frame = moved.model.getFrameId(moved.tool)
    for q, pose in zip(reference.q[::40], reference.poses[::40], strict=True):
        pin.framesForwardKinematics(moved.model, data, q)
        assert np.allclose(data.oMf[frame].homogeneous, pose, atol=1e-9)
    with pytest.raises(mp.errors.InvalidInputError, match="with the same tool and base"):
        mp.Servo(mp.load_robot("panda"), dt=DT, task=TASK, reference=plan)


@pytest.mark.slow
def test_track_begins_at_the_reference_and_stays_near_it(panda, plan, line):
    tracking = mp.track(panda, line, None, mp.formulations.LogDrive(), dt=DT, duration=3.0, task=TASK, reference=plan)
    reference = reference_of(plan, panda, TASK)
    assert tracking.status is mp.Status.TRACKED
    assert np.array_equal(tracking.q[0], reference.start)
    far = np.abs(tracking.q[:, None, :] - reference.q[None]).max(axis=2).min(axis=1)
    assert far.max() < 0.1
    alone = mp.track(panda, line, reference.start, mp.formulations.LogDrive(), dt=DT, duration=3.0, task=TASK)
    assert np.abs(alone.q[:, None, :] - reference.q[None]).max(axis=2).min(axis=1).max() > 0.15


@pytest.mark.parametrize("formulation", [mp.formulations.Classical(), mp.formulations.General(), mp.formulations.Equality(1.0)])
def test_every_formulation_takes_a_reference(panda, plan, line, formulation):
    controller = mp.Controller(panda, formulation, dt=DT, task=TASK, reference=plan, compiled=False)
    kinematics = panda.kinematics(TASK)
    null = np.linalg.svd(kinematics.jacobian(controller.reference.start))[2][-1]
    q, qd = aside(kinematics, controller.reference.start, null, 0.2), np.zeros(7)
    far = np.linalg.norm(q - controller.reference.start)
    for u in np.linspace(0, 0.05, 100):
        qd = controller.step(q, qd, line(u))
        q = q + DT * qd
    assert np.linalg.norm(q - controller.reference.q, axis=1).min() < 0.5 * far
    assert np.linalg.norm((kinematics.pose(q) - line(0.05))[:3, 3]) < 1e-3


@pytest.mark.slow
def test_what_is_no_reference_is_refused(panda, plan, line):
    free = mp.plan(panda, panda.neutral, panda.neutral + 0.1)
    cases = [
        ("reference: got .*a Plan", panda, {"reference": plan.trajectory}),
        ("reference: .*a plan along a tool path", panda, {"reference": free}),
        ("reference.robot: .*'panda'.*xarm7", mp.load_robot("xarm7"), {"reference": plan}),
        ("reference.task: .*'pose'.*same motions of the tool free", panda, {"reference": plan, "task": mp.Task.position()}),
        (
            "position limits; it exceeds those of panda_joint1",
            panda.with_limits(upper=[plan.trajectory.q[:, 0].max() - 0.01, *panda.limits.upper[1:]]),
            {"reference": plan},
        ),
    ]
    for message, robot, options in cases:
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            mp.Servo(robot, dt=DT, **{"task": TASK} | options)
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            mp.Controller(robot, mp.formulations.LogDrive(), dt=DT, **{"task": TASK} | options)
    with pytest.raises(mp.errors.InvalidInputError, match="start: .*or a reference"):
        mp.track(panda, line, None, mp.formulations.LogDrive(), dt=DT)
