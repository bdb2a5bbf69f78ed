"""A goal in which the arm stands already, and motions that an obstacle makes impossible."""

import time
import warnings

import numpy as np
import pytest

import manipplan as mp

ARM = mp.planar_arm([1.0, 1.0, 1.0])
Q = np.array([0.1, 0.6, 0.8])
POSE = ARM.kinematics().pose(Q)


def stands(plan, q):
    assert plan.status is mp.Status.AT_GOAL and plan.status.ok
    assert plan.report.passed
    assert plan.path.length == 0.0
    np.testing.assert_array_equal(plan.trajectory.q, [q, q])
    np.testing.assert_array_equal(plan.trajectory.qd, 0.0)
    assert plan.candidates[0].chosen


@pytest.mark.parametrize(
    "goal",
    [
        Q,
        Q + 5e-7,
        POSE,
        mp.PoseGoal(POSE, free_axis=[0, 0, 1]),
        mp.PoseGoal(POSE, tolerance=mp.Tolerance(position=0.01, rotation=0.1)),
    ],
    ids=["configuration", "nearly", "pose", "free axis", "tolerance"],
)
def test_a_plan_to_where_the_arm_stands_stands_still(goal):
    plan = mp.plan(ARM, Q, goal)
    stands(plan, Q)
    assert plan.goal_index == 0
    stands(mp.plan_many([mp.Problem(robot=ARM, start=Q, goal=goal)])[0], Q)


def test_of_a_list_the_goal_in_which_the_arm_stands_is_taken():
    plan = mp.plan(ARM, Q, [Q + 0.3, POSE, Q])
    stands(plan, Q)
    assert plan.goal_index == 1


@pytest.mark.slow
def test_a_standing_plan_is_saved_shown_and_read_again(tmp_path):
    plan = mp.plan(ARM, Q, Q)
    plan.save(tmp_path / "plan")
    again = mp.Plan.load(tmp_path / "plan")
    stands(again, Q)
    assert mp.check(ARM, tmp_path / "plan" / "trajectory.csv").passed
    assert "AT_GOAL" in repr(plan) and "<" in plan._repr_html_()


def test_an_arm_that_stands_in_an_obstacle_is_refused():
    post = mp.Scene([mp.Sphere(radius=0.2, position=ARM.kinematics().pose(Q)[:3, 3], name="post")])
    with pytest.raises(mp.errors.InvalidInputError, match="start: .*post"):
        mp.plan(ARM, Q, POSE, post)


def test_a_goal_beside_the_start_is_a_motion():
    plan = mp.plan(ARM, Q, Q + 1e-3)
    assert plan.status is not mp.Status.AT_GOAL
    assert plan.path.length > 1e-3


@pytest.mark.slow
def test_no_warning_from_limits_that_are_infinite():
    robot = mp.load_robot("kinova")
    start, goal = robot.neutral.copy(), robot.neutral.copy()
    start[0], goal[0] = 3.1, -3.1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plan = mp.plan(robot, start, robot.kinematics().pose(goal))
    assert plan.path.length < 0.1


@pytest.mark.parametrize(
    ("lower", "upper", "middle"),
    [(-1.0, 3.0, 1.0), (-np.inf, np.inf, 0.0), (2.0, np.inf, 2.0), (-np.inf, -2.0, -2.0), (-np.inf, 5.0, 0.0)],
)
def test_the_middle_of_limits(lower, upper, middle):
    limits = ARM.limits.with_changes({"lower": lower, "upper": upper})
    np.testing.assert_array_equal(limits.middle, [middle] * 3)


@pytest.fixture(scope="module")
def panda():
    return mp.load_robot("panda")


@pytest.fixture(scope="module")
def sweep(panda):
    """The first joint turns by 1.6 rad."""
    u = np.linspace(0, 1, 200)
    q = np.tile(panda.states["default"], (200, 1))
    q[:, 0] += 1.6 * (10 * u**3 - 15 * u**4 + 6 * u**5)
    qd = np.zeros_like(q)
    qd[:, 0] = 0.4 * (30 * u**2 - 60 * u**3 + 30 * u**4)
    return mp.Trajectory(t=4 * u, q=q, qd=qd, joint_names=panda.joint_names)


@pytest.mark.slow
@pytest.mark.parametrize("radius", [0.02, 0.04])
def test_improve_sees_at_once_that_the_hand_stays_in_a_post(panda, sweep, radius):
    middle = panda.kinematics().pose(sweep.q[100])[:3, 3]
    post = mp.Scene([mp.Cylinder(radius=radius, length=0.3, position=middle, name="post")])
    tolerance = mp.Tolerance(position=0.01, rotation=0.1)
    mp.check(panda, sweep, post)
    began = time.process_time()
    with pytest.raises(mp.errors.PlanningError, match="and post overlap by .* no point of .* moves by more than") as caught:
        mp.improve(panda, sweep, post, tolerance=tolerance)
    assert time.process_time() - began < 3.0
    assert caught.value.result.status is mp.Status.NOT_FOLLOWED


@pytest.mark.slow
def test_a_post_that_the_tolerance_clears_is_left_to_the_solver(panda, sweep):
    """A thin post at the edge of the hand: it overlaps less than the tube lets the hand move."""
    beside = panda.kinematics().pose(sweep.q[100])[:3, 3]
    thin = mp.Scene([mp.Sphere(radius=0.003, position=beside, name="post")])
    from manipplan.recordings.inside import blocked

    model = thin.collision_model(panda)
    wide = mp.Tolerance(position=0.2, rotation=0.1)
    assert blocked(model, sweep, wide, mp.Task.pose(), 0.0) == ""
    assert blocked(model, sweep, mp.Tolerance(rotation=0.1), mp.Task.pose(), 0.0) == ""
    assert blocked(model, sweep, wide, mp.Task.orientation(), 0.0) == ""


@pytest.mark.slow
def test_a_pose_in_millimetres_is_named_as_one():
    far = POSE.copy()
    far[:3, 3] *= 1000
    with pytest.raises(mp.errors.OutOfReachError, match="within reach if it is in millimetres: divide it by 1000"):
        mp.plan(ARM, Q + 0.1, far)
    away = POSE.copy()
    away[0, 3] += 50.0
    with pytest.raises(mp.errors.OutOfReachError) as caught:
        mp.plan(ARM, Q + 0.1, away)
    assert "millimetres" in str(caught.value) or "divide" not in str(caught.value)


GRIPPER = """<robot name="hand"><link name="a"/><link name="b"/><link name="tip"/><link name="f"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
<limit lower="-2" upper="2" velocity="1" effort="9"/></joint>
<joint name="t" type="fixed"><parent link="b"/><child link="tip"/><origin xyz="1 0 0"/></joint>
<joint name="finger" type="prismatic"><parent link="b"/><child link="f"/><axis xyz="0 1 0"/>
<limit lower="0" upper="0.04" velocity="1" effort="9"/></joint></robot>"""
STATES = """<robot name="hand"><group_state name="open" group="hand"><joint name="finger" value="0.04"/></group_state>
<group_state name="close" group="hand"><joint name="finger" value="0.0"/></group_state>
<group_state name="ready" group="arm"><joint name="j" value="0.5"/></group_state></robot>"""


def test_a_state_of_a_gripper_can_be_locked(tmp_path):
    urdf, srdf = tmp_path / "hand.urdf", tmp_path / "hand.srdf"
    urdf.write_text(GRIPPER)
    srdf.write_text(STATES)
    for state, value in (("open", 0.04), ("close", 0.0)):
        robot = mp.Robot.from_urdf(urdf, srdf=srdf, tool="tip", locked=state)
        assert dict(robot.locked) == {"finger": value}
        assert robot.joint_names == ("j",)
    with pytest.raises(mp.errors.UnknownNameError, match="locked: got 'opened'; allowed: did you mean open"):
        mp.Robot.from_urdf(urdf, srdf=srdf, tool="tip", locked="opened")
    with pytest.raises(mp.errors.InvalidInputError, match="locked: got 'ready'"):
        mp.Robot.from_urdf(urdf, srdf=srdf, tool="tip", locked="ready")
    with pytest.raises(mp.errors.InvalidInputError, match="locked: got 'open'; allowed: a mapping.*no SRDF"):
        mp.Robot.from_urdf(urdf, tool="tip", locked="open")
