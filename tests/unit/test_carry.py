"""carry: an object that both arms of a robot hold."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.jobs.carry import _count, lone_robot, tool_poses
from manipplan.paths.cartesian import Offset
from manipplan.robots.arms import own_joints, shared_joints


@pytest.fixture(scope="module")
def baxter():
    return mp.load_robot("baxter")


@pytest.fixture(scope="module")
def scene():
    return mp.Scene([mp.Box(size=(0.7, 1.6, 0.05), position=(0.85, 0.0, -0.2), name="table")])


def grasp(side):
    """A hand at the side of a tray, from above and outside."""
    pose = np.eye(4)
    pose[:3, :3] = Rotation.from_euler("xz", [np.pi - side * np.pi / 4, 0.0]).as_matrix()
    pose[:3, :3] = pose[:3, :3] @ Rotation.from_euler("z", side * np.pi / 2).as_matrix()
    pose[:3, 3] = 0.0, 0.22 * side, 0.02
    return pose


def tray_at(x, y, z, turn=0.0):
    pose = np.eye(4)
    pose[:3, :3] = Rotation.from_euler("z", turn).as_matrix()
    pose[:3, 3] = x, y, z
    return pose


GRASPS = {"left_gripper": grasp(1), "right_gripper": grasp(-1)}
WAY = mp.CartesianPath.line(tray_at(0.6, -0.05, 0.05), tray_at(0.65, 0.05, 0.15, 0.2))


@pytest.fixture(scope="module")
def waiter(baxter):
    """Baxter with a tray in its left hand."""
    tray = mp.Box(size=(0.3, 0.4, 0.02), name="tray").at(np.linalg.inv(GRASPS["left_gripper"]))
    return baxter.attach(tray, tool="left_gripper")


def judge(plan):
    """Check the poses of the hands and the object by Pinocchio's kinematics."""
    assert plan.status is mp.Status.CARRIED
    assert plan.report.passed
    poses = tool_poses(plan.robot, plan.trajectory(np.linspace(0, plan.trajectory.duration, 500)))
    seen = np.linalg.inv(poses["left_gripper"]) @ poses["right_gripper"]
    wanted = np.linalg.inv(GRASPS["left_gripper"]) @ GRASPS["right_gripper"]
    assert np.abs(seen - wanted).max() < 1e-3
    assert np.abs(seen[:, :3, 3] - wanted[:3, 3]).max() < 1e-4
    assert plan.report.tools[1].held_position < 1e-4
    assert plan.report.tools[1].held_position >= np.linalg.norm(seen[:, :3, 3] - wanted[:3, 3], axis=1).max() - 1e-6
    objects = poses["left_gripper"] @ np.linalg.inv(GRASPS["left_gripper"])
    np.testing.assert_allclose(objects[[0, -1]], [WAY(0.0), WAY(1.0)], atol=1e-4)


@pytest.mark.slow
def test_both_arms_carry_a_tray(waiter, scene, tmp_path):
    plan = mp.carry(waiter, WAY, GRASPS, scene, positions=15, samples=12, epsilon=0.4)
    judge(plan)
    plan.save(tmp_path)
    loaded = mp.Plan.load(tmp_path)
    assert isinstance(loaded.workspace_path, Offset)
    np.testing.assert_allclose(loaded.workspace_path(0.5), plan.workspace_path(0.5))


@pytest.mark.slow
@pytest.mark.parametrize("options", [{}, {"positions": 15, "samples": 3}], ids=["defaults", "samples far from the start"])
def test_a_tray_is_carried_on_from_where_the_hands_took_it(baxter, waiter, scene, options):
    goal = {tool: WAY(0.0) @ pose for tool, pose in GRASPS.items()}
    taken = mp.plan(baxter, baxter.neutral, goal, scene)
    plan = mp.carry(waiter, WAY, GRASPS, scene, start=taken.path.goal, **options)
    judge(plan)
    np.testing.assert_array_equal(plan.path.start, taken.path.goal)


@pytest.mark.slow
def test_a_time_limit_that_is_too_short_for_both_arms_is_said(waiter, scene):
    plan = mp.carry(waiter, WAY, GRASPS, scene, time_limit=0.05, throw=False)
    assert plan.status is mp.Status.NOT_IN_TIME and plan.trajectory is None
    assert plan.message.startswith("no motion of both arms was proven within time_limit = 0.05 s; the last step was 'sampling")
    with pytest.raises(mp.errors.InvalidInputError, match="^time_limit: got 0"):
        mp.carry(waiter, WAY, GRASPS, scene, time_limit=0.0)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["tiago_dual", "talos"])
def test_robots_with_a_torso_carry_and_hold_it_still(name):
    robot = mp.load_robot(name)
    model, shared = mp.Scene().collision_model(robot), shared_joints(robot)
    many = robot.random_configuration(np.random.default_rng(0), size=3000)
    many[:, shared] = robot.neutral[shared]
    hands = [robot.arm(tool).kinematics().pose(many[:, list(robot.joints_of(tool))])[:, :3, 3] for tool in robot.tools]
    apart = np.linalg.norm(hands[0][:, None] - hands[1], axis=2)
    before = (hands[0][:, None, 0] > 0.3) & (hands[1][:, 0] > 0.3)
    pairs = np.argwhere(before & (apart > 0.25) & (apart < 0.5))[:500]
    start, right = many[pairs[:, 0]], own_joints(robot, robot.tools[1])
    start[:, right] = many[pairs[:, 1]][:, right]
    q = start[~model.in_collision_rows(start, clearance=0.003)][0]
    poses = tool_poses(robot, q[None])
    first, other = robot.tools
    grasps = {first: np.eye(4), other: np.linalg.inv(poses[first][0]) @ poses[other][0]}
    end = poses[first][0].copy()
    end[2, 3] += 0.02
    plan = mp.carry(robot, mp.CartesianPath.line(poses[first][0], end), grasps, start=q)
    assert plan.report.passed and plan.report.tools[1].held_position < 1e-4
    np.testing.assert_array_equal(plan.path.start, q)
    np.testing.assert_allclose(plan.trajectory.q[:, shared] - q[shared], 0.0, atol=1e-12)


@pytest.mark.slow
def test_the_default_takes_few_samples_where_each_is_a_search(baxter):
    for robot, few in ((baxter, True), (mp.load_robot("tiago_dual"), False)):
        for tool in robot.tools:
            lone = lone_robot(robot, tool, robot.neutral)
            assert (_count(lone) < 50) is few


def test_an_arm_without_a_torso_is_built_once(baxter):
    for tool in baxter.tools:
        assert lone_robot(baxter, tool, baxter.neutral) is lone_robot(baxter, tool, baxter.neutral + 0.1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("grasps", "message"),
    [
        ({"left_gripper": np.eye(4)}, "two of the tools"),
        ({"left_gripper": np.eye(4), "right_griper": np.eye(4)}, "right_gripper"),
        ({"left_gripper": np.eye(4), "right_gripper": np.eye(3)}, r"grasps\['right_gripper'\]"),
        (
            {"left_gripper": grasp(1), "right_gripper": tray_at(0.0, -2.0, 0.0)},
            r"at s = 0 right_gripper is out of reach: 1.8. m",
        ),
        ({"left_gripper": grasp(1), "right_gripper": tray_at(0.3, -0.7, 0.9)}, r"right_gripper: path, position \d"),
    ],
)
def test_wrong_grasps(baxter, grasps, message):
    way = mp.CartesianPath.line(tray_at(0.6, -0.05, 0.05), tray_at(0.65, 0.05, 0.15))
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.carry(baxter, way, grasps, positions=5, samples=6)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("options", "argument"),
    [
        ({"objective": mp.PathObjective(task=mp.Task.pointing())}, "objective.task"),
        ({"objective": mp.PathObjective(task=mp.Task.position())}, "objective.task"),
        ({"objective": mp.PathObjective(task=mp.Task.pose(relative_to="right_gripper"))}, "objective.task"),
        ({"objective": "short"}, "objective"),
        ({"epsilon": -1.0}, "epsilon"),
        ({"epsilon": [0.2] * 7}, "epsilon"),
        ({"epsilon": "small"}, "epsilon"),
        ({"torque": 1}, "torque"),
        ({"throw": None}, "throw"),
        ({"clearance": -1.0}, "clearance"),
        ({"tolerance": 1e-3}, "tolerance"),
        ({"seed": -1}, "seed"),
        ({"positions": 1}, "positions"),
        ({"positions": [0.0, 0.5]}, "positions"),
        ({"positions": 5, "samples": 0}, "samples"),
        ({"positions": 5, "samples": "many"}, "samples"),
        ({"start": [0.0]}, "start"),
        ({"start": "nowhere"}, "start"),
        ({"start": np.zeros(14)}, "start"),
        ({"posture": "nowhere"}, "posture"),
        ({"posture": [0.0]}, "posture"),
    ],
    ids=str,
)
def test_bad_input_is_named_before_work_starts(baxter, monkeypatch, options, argument):
    def refused(*_, **__):
        raise AssertionError("work has started")

    monkeypatch.setattr("manipplan.search.sampling.CandidateSampler.sample", refused)
    with pytest.raises(mp.errors.InvalidInputError) as caught:
        mp.carry(baxter, WAY, GRASPS, **options)
    assert caught.value.argument == argument


def test_a_start_that_does_not_hold_the_object_says_how_far_it_is(baxter):
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"left_gripper is \d+ mm and .* from its grasp of the path's first pose"
    ):
        mp.carry(baxter, WAY, GRASPS, start=baxter.neutral)
    with pytest.raises(mp.errors.InvalidInputError, match="posture: .*None with a start"):
        mp.carry(baxter, WAY, GRASPS, start=baxter.neutral, posture=baxter.neutral)


def test_a_robot_with_one_tool_and_one_with_short_arms_are_refused():
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"robot: got 'panda, with the one tool panda_hand_tcp'; allowed: a robot with"
    ):
        mp.carry(mp.load_robot("panda"), WAY, GRASPS)
    short = mp.load_robot(
        "baxter", joints=[f"{side}_{name}" for side in ("left", "right") for name in ("s0", "s1", "e1", "w1")]
    )
    with pytest.raises(mp.errors.InvalidInputError, match="4 joints move left_gripper alone.*at least 6 joints"):
        mp.carry(short, WAY, GRASPS)
