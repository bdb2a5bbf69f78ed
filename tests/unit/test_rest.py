"""Controllers that come to rest: at their target, or with a status that says that they are away from it."""

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.tracking.step import AWAY, STALLING

DT = 0.01
FORMULATIONS = {
    "General": mp.formulations.General(),
    "Classical": mp.formulations.Classical(1.0),
    "Objective": mp.formulations.Objective(15e3),
    "Equality": mp.formulations.Equality(5e5),
    "LogDrive": mp.formulations.LogDrive(),
}


@pytest.fixture(scope="module")
def panda():
    return mp.load_robot("panda")


@pytest.fixture(scope="module")
def controllers(panda):
    return {name: mp.Controller(panda, formulation, dt=DT) for name, formulation in FORMULATIONS.items()}


def distance(robot, q, target):
    """Of the tool from its target [m or rad], by Pinocchio from the original file."""
    model = pin.buildModelFromUrdf(str(robot.source.file))
    data, whole = model.createData(), pin.neutral(model)
    whole[[model.joints[model.getJointId(name)].idx_q for name in robot.joint_names]] = q
    pin.forwardKinematics(model, data, whole)
    pose = pin.updateFramePlacement(model, data, model.getFrameId(robot.tool))
    turned = np.linalg.norm(pin.log3(pose.rotation.T @ target[:3, :3]))
    return max(np.linalg.norm(pose.translation - target[:3, 3]), turned)


def standing(target, seconds):
    return np.broadcast_to(target, (round(seconds / DT), 4, 4))


@pytest.mark.slow
def test_a_drive_does_not_hold_the_arm_away_from_its_target(panda, controllers):
    """pink#59: joint 4 rests at its limit, 0.25 m away, where the drive balances the tracking."""
    target = panda.kinematics().pose(panda.neutral)
    start = panda.neutral.copy()
    start[3] = -0.08
    held = mp.Controller(panda, mp.formulations.LogDrive(yields=False), dt=DT).rollout(start, standing(target, 20.0))
    assert distance(panda, held.q[-1], target) > 0.1
    assert held["status"][-1] == mp.results.StepStatus.STALLED
    run = controllers["LogDrive"].rollout(start, standing(target, 20.0))
    assert distance(panda, run.q[-1], target) < 1e-3
    assert run["status"][-1] == mp.results.StepStatus.SOLVED


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(seed=st.integers(0, 10**6), name=st.sampled_from(sorted(FORMULATIONS)))
def test_an_arm_reaches_its_target_or_says_that_it_stalled(panda, controllers, seed, name):
    rng = np.random.default_rng(seed)
    start, end = (rng.uniform(panda.limits.lower, panda.limits.upper) for _ in range(2))
    target = panda.kinematics().pose(end)
    run = controllers[name].rollout(start, standing(target, 120.0))
    away = distance(panda, run.q[-1], target)
    closer = away < 0.97 * distance(panda, run.q[-1001], target)  # may take minutes along a joint limit
    assert away < 1e-3 or run["status"][-1] == mp.results.StepStatus.STALLED or closer


@pytest.mark.slow
def test_a_drive_reaches_what_is_reached_without_one(panda, controllers):
    rng = np.random.default_rng(45)
    kinematics = panda.kinematics()
    reached = 0
    for _ in range(40):
        start, end = (rng.uniform(panda.limits.lower, panda.limits.upper) for _ in range(2))
        target = kinematics.pose(end)
        ends = [
            distance(panda, controllers[name].rollout(start, standing(target, 30.0)).q[-1], target)
            for name in ("General", "LogDrive")
        ]
        assert (ends[0] < 1e-3) <= (ends[1] < 1e-3)
        reached += ends[0] < 1e-3
    assert reached > 10


@pytest.mark.slow
def test_a_held_pose_keeps_its_place_and_raises_manipulability(panda, controllers):
    kinematics = panda.kinematics()
    start = np.array([0.3, 0.4, -0.5, -1.2, 0.6, 2.4, 0.2])
    target = kinematics.pose(start)
    run = controllers["LogDrive"].rollout(start, standing(target, 20.0))
    assert distance(panda, run.q[-1], target) < 2e-4
    assert run["manipulability"][-1] > 1.01 * run["manipulability"][0]
    assert np.abs(run.qd[-1]).max() < 1e-4


@pytest.mark.parametrize("compiled", [False, pytest.param(True, marks=pytest.mark.compiler)])
def test_a_target_out_of_reach_stalls_within_the_stated_time_and_ends_when_it_moves(compiled):
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    controller = mp.Controller(arm, mp.formulations.General(), dt=DT, compiled=compiled)
    target = np.asarray(arm.kinematics().pose([0.3, 0.5, 0.4])).copy()
    q, qd = np.array([0.3, 0.5, 0.4]), np.zeros(3)
    target[:2, 3] *= 4.0 / np.linalg.norm(target[:2, 3])
    found = []
    for _ in range(2000):
        qd = controller.step(q, qd, target)
        q = q + DT * qd
        found.append(controller.report.status)
    assert found[-1] is mp.results.StepStatus.STALLED
    assert not found[-1].brakes
    assert mp.results.StepStatus.STALLED not in found[: round(STALLING / DT)]
    target[:2, 3] *= 0.5
    qd = controller.step(q, qd, target)
    assert controller.report.status is mp.results.StepStatus.SOLVED
    controller.reset()
    controller.step(q, qd, target)
    assert controller.report.status is mp.results.StepStatus.SOLVED


def test_an_arm_that_follows_or_has_arrived_has_not_stalled():
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    controller = mp.Controller(arm, mp.formulations.LogDrive(), dt=DT, compiled=False)
    start = np.array([0.3, 0.5, 0.4])
    pose = np.asarray(arm.kinematics().pose(start))
    moving = np.repeat(pose[None], 600, axis=0)
    moving[:, 1, 3] -= np.minimum(np.arange(600) / 300, 1.0) * 0.3
    run = controller.rollout(start, moving)
    assert (run["status"] == mp.results.StepStatus.SOLVED).all()
    assert run["position_deviation"][-1] < AWAY


def test_inside_its_tolerance_an_arm_has_not_stalled():
    """A tolerance says how far the arm may rest from its target, and the drive uses it."""
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    start = np.array([0.3, 0.2, 0.2])
    pose = np.asarray(arm.kinematics().pose(start))
    tube = mp.Tolerance(position=0.02, rotation=0.05)
    controller = mp.Controller(arm, mp.formulations.LogDrive(), dt=DT, tolerance=tube, compiled=False)
    run = controller.rollout(start, standing(pose, 5.0))
    assert (run["status"] == mp.results.StepStatus.SOLVED).all()
    assert 0.002 < run["position_deviation"][-1] < 0.0205
    exact = mp.Controller(arm, mp.formulations.LogDrive(), dt=DT, compiled=False).rollout(start, standing(pose, 5.0))
    assert exact["position_deviation"][-1] < 2e-4
    assert run["manipulability"][-1] > exact["manipulability"][-1]
