"""An arm on two slides of a mobile base, whose limits are far beyond what the arm reaches from one place."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.ik.bridge import reach_in
from manipplan.ik.newton import random_near, window
from manipplan.robots.arms import lengths_to
from manipplan.robots.model_tree import frame_index

#: Parent, child, place and axis of the six revolute joints.
ARM = (
    ("platform", "l1", "0 0 0.22", "0 0 1"),
    ("l1", "l2", "0 0 0.12", "0 1 0"),
    ("l2", "l3", "0 0 0.4", "0 1 0"),
    ("l3", "l4", "0 0 0.35", "0 1 0"),
    ("l4", "l5", "0 0.1 0", "0 0 1"),
    ("l5", "l6", "0 0 0.1", "0 1 0"),
)
START = np.array([0.0, 0.0, 0.2, 0.5, 0.6, 0.4, 0.3, 0.5])


def mobile_arm(limit, folder):
    joints = [("base_x", "world", "cart", "0 0 0", "1 0 0", limit), ("base_y", "cart", "platform", "0 0 0", "0 1 0", limit)]
    joints += [(f"a{k + 1}", *joint, 3.0) for k, joint in enumerate(ARM)]
    parts = [
        f'<link name="{child}"/><joint name="{name}" type="{"prismatic" if name.startswith("base") else "revolute"}">'
        f'<parent link="{parent}"/><child link="{child}"/><origin xyz="{place}"/><axis xyz="{axis}"/>'
        f'<limit lower="{-most}" upper="{most}" velocity="2" effort="100"/></joint>'
        for name, parent, child, place, axis, most in joints
    ]
    tool = (
        '<link name="tool"/><joint name="flange" type="fixed"><parent link="l6"/><child link="tool"/>'
        '<origin xyz="0 0 0.1"/></joint>'
    )
    file = folder / "mobile.urdf"
    file.write_text(f'<robot name="mobile"><link name="world"/>{"".join(parts)}{tool}</robot>')
    return mp.Robot.from_urdf(file, tool="tool")


@pytest.fixture(scope="module", params=[2.0, 30.0, 1e6])
def arm(request, tmp_path_factory):
    return mobile_arm(request.param, tmp_path_factory.mktemp("mobile"))


@pytest.mark.slow
def test_the_window_holds_every_configuration_that_reaches_the_pose(arm):
    rng = np.random.default_rng(1)
    q = arm.random_configuration(rng, size=300)
    q[:, :2] = rng.uniform(-2, 2, (300, 2))
    for each, pose in zip(q, arm.kinematics().pose(q), strict=True):
        lower, upper = window(arm, pose[None])
        assert (lower <= each).all() and (each <= upper).all()
        assert (upper - lower)[:2].max() < 4.1
    near = random_near(arm, pose, rng, 50)
    assert (lower <= near).all() and (near <= upper).all() and np.ptp(near[:, 0]) > 0.5


@pytest.mark.slow
def test_solutions_are_found_wherever_the_base_can_be(arm):
    q = np.array([1.5, 1.0, -0.8, 0.7, 0.9, -0.4, 0.5, 0.8])
    pose = arm.kinematics().pose(q)
    found = mp.inverse_kinematics(arm, pose, samples=16)
    assert len(found) > 100
    np.testing.assert_allclose(arm.kinematics().pose(found.q), np.tile(pose, (len(found), 1, 1)), atol=1e-9)


@pytest.mark.slow
def test_a_pose_goal_and_a_path(arm):
    far = min(20.0, arm.limits.upper[0] - 1.0)
    goal = arm.kinematics().pose(START)
    goal[0, 3] += far
    assert mp.plan(arm, START, goal).report.passed
    begin = arm.kinematics().pose(START)
    end = begin.copy()
    end[:3, 3] += [0.2, 0.1, 0.0]
    assert mp.follow(arm, mp.CartesianPath.line(begin, end), positions=12, start=START).report.passed


@pytest.mark.slow
def test_a_pose_that_is_out_of_reach_is_told_with_a_true_distance(arm):
    high = arm.kinematics().pose(START)
    high[2, 3] = 3.0
    with pytest.raises(mp.errors.InvalidInputError, match="out of reach") as told:
        mp.plan(arm, START, high)
    missed = float(str(told.value).split("leaves the tool ")[1].split(" mm")[0])
    assert 1300 < missed < 2000  # 3 m against 0.22 + 0.12 + 0.4 + 0.35 + 0.2 m and some width


@pytest.mark.parametrize("name", ["panda", "tiago", "so100"])
def test_no_configuration_takes_the_tool_farther_from_a_joint_than_its_bound(name):
    robot = mp.load_robot(name)
    lengths = np.array([length for _, length in lengths_to(robot, robot.tool)])
    data, frame = robot.model.createData(), frame_index(robot.model, robot.tool)
    farthest = np.zeros(robot.n)
    for q in robot.random_configuration(np.random.default_rng(0), size=500):
        pin.framesForwardKinematics(robot.model, data, q)
        for joint in range(robot.n):
            origin = data.oMi[joint + 1].translation
            if robot.joint_types[joint] == "prismatic":
                origin = data.oMi[joint].act(robot.model.jointPlacements[joint + 1].translation)
            farthest[joint] = max(farthest[joint], np.linalg.norm(data.oMf[frame].translation - origin))
    assert (farthest <= lengths + 1e-12).all() and farthest[0] > 0.3 * lengths[0]


def test_the_ball_of_a_long_arm_holds_it_stretched_out():
    arm = mp.planar_arm([0.1] * 20)
    centre, radius = reach_in(arm, window(arm, arm.kinematics().pose(arm.neutral)[None]))
    assert np.linalg.norm(arm.kinematics().pose(np.zeros(20))[:3, 3] - centre) <= radius + 1e-12
