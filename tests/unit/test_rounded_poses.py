"""Poses as they come from outside: rounded ones are taken to the nearest rigid transform, all others are refused."""

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.support.checks import pose_matrix
from manipplan.tracking.step import StepStatus

UR5 = mp.load_robot("ur5")


def random_pose(seed):
    place = np.random.default_rng(seed).normal(size=3)
    return pin.SE3(Rotation.random(random_state=seed).as_matrix(), place).homogeneous


POSES = st.integers(0, 10**6).map(random_pose)
ROUNDED = {
    "float32": lambda pose: pose.astype(np.float32),
    "seven decimals": lambda pose: np.round(pose, 7),
    "five decimals": lambda pose: np.round(pose, 5),
}
#: What is no pose, made from one.
SPOILT = {
    "zeros": (lambda pose: np.zeros((4, 4)), "last row"),
    "zero rotation": (lambda pose: np.block([[np.zeros((3, 3)), pose[:3, 3:]], [np.array([[0, 0, 0, 1.0]])]]), "it is zero"),
    "mirrored": (lambda pose: pose @ np.diag([1.0, 1.0, -1.0, 1.0]), "it mirrors"),
    "scaled": (lambda pose: pose @ np.diag([1.0001, 1.0001, 1.0001, 1.0]), r"differs by \S+e-0[56]|differs by 0.0001"),
    "millimetres": (lambda pose: pose @ np.diag([1e3, 1e3, 1e3, 1.0]), "differs by"),
    "sheared": (lambda pose: pose @ (np.eye(4) + 1e-3 * np.eye(4, k=1)), "differs by|last row"),
    "transposed": (lambda pose: pose.T.copy(), "last row"),
    "huge": (lambda pose: pose @ np.diag([1e200, 1e200, 1e200, 1.0]), "numbers from -1e"),
    "nan": (lambda pose: np.full((4, 4), np.nan), "finite"),
}


@given(POSES, st.sampled_from(sorted(ROUNDED)))
def test_a_rounded_pose_is_the_nearest_rigid_one(pose, kind):
    rounded = ROUNDED[kind](pose)
    found = pose_matrix("pose", rounded)
    rotation = found[:3, :3]
    assert np.abs(rotation.T @ rotation - np.eye(3)).max() < 1e-14 and np.linalg.det(rotation) > 0
    assert np.abs(rotation - Rotation.from_matrix(np.asarray(rounded[:3, :3], float)).as_matrix()).max() < 1e-9
    assert np.array_equal(found[:3, 3], rounded[:3, 3]) and np.array_equal(found[3], [0, 0, 0, 1])
    assert np.array_equal(pose_matrix("pose", found), found)  # once is enough


@given(POSES)
def test_an_exact_pose_is_kept_bit_by_bit(pose):
    assert np.array_equal(pose_matrix("pose", pose), pose)


@given(POSES, st.sampled_from(sorted(SPOILT)))
def test_what_is_no_pose_is_refused_with_the_error(pose, kind):
    spoil, message = SPOILT[kind]
    with pytest.raises(mp.errors.InvalidInputError, match=f"pose: got .*({message})"):
        pose_matrix("pose", spoil(pose))


@given(POSES, st.floats(-6, -4), st.integers(0, 10**6))
def test_the_bound_is_that_of_the_entries(pose, exponent, seed):
    """A rotation R S with S symmetric is nearest to R: refused from 1e-5 on, and the message says the size."""
    stretch = np.random.default_rng(seed).normal(size=(3, 3))
    change = pose[:3, :3] @ (stretch + stretch.T)
    change *= 10**exponent / np.abs(change).max()
    given_pose = pose.copy()
    given_pose[:3, :3] += change
    if 10**exponent < 0.99e-5:
        assert np.abs(pose_matrix("pose", given_pose) - pose).max() < 1e-9
    elif 10**exponent > 1.01e-5:
        with pytest.raises(mp.errors.InvalidInputError, match="differs by .*at most 1e-05"):
            pose_matrix("pose", given_pose)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur5", "panda"])
def test_rounded_poses_have_the_solutions_of_the_exact_one(name):
    """F01 of the field reports; joint 1 of the UR5 stands at a multiple of half its range."""
    robot = mp.load_robot(name)
    q = robot.neutral + 0.2 * np.sin(np.arange(robot.n))
    pose = robot.kinematics().pose(q)
    exact = mp.inverse_kinematics(robot, pose).q
    for rounded in (pose.astype(np.float32), np.round(pose, 7), np.round(pose, 8), np.round(pose, 9)):
        found = mp.inverse_kinematics(robot, rounded)
        assert len(found) == len(exact)
        apart = np.abs(found.q[:, None] - exact).max(axis=2)
        assert apart.min(axis=0).max() < 1e-5 and apart.min(axis=1).max() < 1e-5
        assert np.abs(robot.kinematics().pose(found.q) - pose).max() < 1e-6
        assert (robot.limits.outside(found.q) == 0).all()


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.integers(0, 5), st.booleans())
def test_a_joint_at_its_limit_stays_a_solution(seed, joint, upper):
    robot = UR5
    q = robot.random_configuration(np.random.default_rng(seed))
    q[joint] = (robot.limits.upper if upper else robot.limits.lower)[joint]
    if robot.kinematics().manipulability(q) < 5e-3:
        return  # rounding moves much near a singularity
    pose = robot.kinematics().pose(q)
    for rounded in (pose.astype(np.float32), np.round(pose, 7)):
        found = mp.inverse_kinematics(robot, rounded).q
        assert np.abs(found - q).max(axis=1).min() < 1e-4


def entrances():
    """Calls that take a pose, each with the name under which it complains."""
    arm = UR5
    box = mp.Box(size=[0.1, 0.1, 0.1], name="box")
    q = np.array([0.3, -1.0, 1.2, 0.4, 0.5, 0.6])
    here = arm.kinematics().pose(q)
    return {
        "inverse_kinematics": lambda x: mp.inverse_kinematics(arm, x),
        "several poses": lambda x: mp.inverse_kinematics(arm, [here, x]),
        "a stack of poses": lambda x: mp.inverse_kinematics(arm, np.array([here, x])),
        "goal": mp.PoseGoal,
        "line": lambda x: mp.CartesianPath.line(here, x),
        "circle": lambda x: mp.CartesianPath.circle(x, (0, 0, 0), (0, 0, 1)),
        "through": lambda x: mp.CartesianPath.through([here, x]),
        "with_tool": arm.with_tool,
        "at": arm.at,
        "scene": mp.Scene([box]).at,
        "obstacle": box.at,
        "rotation of an obstacle": lambda x: mp.Box(size=[0.1, 0.1, 0.1], rotation=np.asarray(x)[:3, :3]),
        "position box": lambda x: mp.PositionBox([-1, -1, -1], [1, 1, 1], pose=x),
    }


@pytest.mark.parametrize("entrance", sorted(entrances()))
def test_every_entrance_takes_rounded_poses_and_refuses_others(entrance):
    call = entrances()[entrance]
    pose = pin.SE3(Rotation.random(random_state=3).as_matrix(), np.array([0.3, 0.2, 0.4])).homogeneous
    for rounded in ROUNDED.values():
        call(rounded(pose))
    for kind in ("zero rotation", "mirrored", "scaled"):
        with pytest.raises(mp.errors.InvalidInputError, match=SPOILT[kind][1]):
            call(SPOILT[kind][0](pose))


@pytest.fixture(scope="module", params=[False, "auto"])
def controller(request):
    return mp.Controller(mp.load_robot("panda"), mp.formulations.LogDrive(), dt=0.01, compiled=request.param)


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(seed=st.integers(0, 10**6), kind=st.sampled_from(sorted(SPOILT)))
def test_a_controller_brakes_for_what_is_no_pose(controller, seed, kind):
    """F17 of the field reports: a matrix of zeros was taken as a target."""
    robot = controller.robot
    rng = np.random.default_rng(seed)
    q, qd = robot.neutral, 0.1 * rng.uniform(-1, 1, robot.n)
    pose = robot.kinematics().pose(q + 0.01 * rng.normal(size=robot.n))
    controller.reset()
    velocity = controller.step(q, qd, SPOILT[kind][0](pose))
    assert controller.report.status is StepStatus.BAD_TARGET
    assert (np.abs(velocity) <= np.abs(qd)).all() and np.linalg.norm(velocity) < np.linalg.norm(qd)
    controller.step(q, qd, pose)
    assert controller.report.status is StepStatus.SOLVED


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(seed=st.integers(0, 10**6), kind=st.sampled_from(sorted(ROUNDED)))
def test_a_controller_follows_rounded_targets(controller, seed, kind):
    robot = controller.robot
    rng = np.random.default_rng(seed)
    pose = robot.kinematics().pose(robot.neutral + 0.01 * rng.normal(size=robot.n))
    commands = []
    for target in (pose, ROUNDED[kind](pose)):
        controller.reset()
        commands.append(controller.step(robot.neutral, np.zeros(robot.n), target))
        assert controller.report.status is StepStatus.SOLVED
    assert np.abs(commands[0] - commands[1]).max() < (1e-2 if kind == "five decimals" else 1e-3)


@pytest.mark.slow
def test_a_moving_obstacle_that_is_no_pose_brakes():
    robot = mp.load_robot("panda")
    scene = mp.Scene([mp.Sphere(radius=0.05, position=[0.6, 0.5, 0.5], name="ball")])
    own = mp.Controller(
        robot, mp.formulations.LogDrive(), dt=0.01, avoidance=mp.Avoidance(scene=scene, moving=("ball",)), compiled=False
    )
    pose = robot.kinematics().pose(robot.neutral)
    place = np.eye(4)
    place[:3, 3] = 0.6, 0.5, 0.5
    for obstacle, status in (
        (place, StepStatus.SOLVED),
        (place.astype(np.float32), StepStatus.SOLVED),
        (place @ np.diag([1.0, 1.0, -1.0, 1.0]), StepStatus.BAD_TARGET),
        (np.zeros((4, 4)), StepStatus.BAD_TARGET),
    ):
        own.step(robot.neutral, np.zeros(7), pose, obstacles={"ball": (obstacle, np.zeros(6))})
        assert own.report.status is status
