"""Goals of `plan`: every form, what is chosen and what is left out, and every wrong one."""

import copy
import pickle

import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.cli import main
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.goals.candidates import PATHS, choose, find_candidates, ordered
from manipplan.goals.goal import PoseGoal, goals_from_yaml, pose_of_numbers, read_goals
from manipplan.goals.solutions import nearest, poses_inside, reaching
from manipplan.robots.limits import nearest_turns
from manipplan.support.deadline import Deadline

GOAL = np.array([1.2, -0.3, 0.0, -2.2, 0.0, 2.0, 0.8])
POST = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.44, 0.0, 0.3), name="post")])
#: A posture whose forearm goes through the post.
THROUGH = np.array([0.0, 1.76, 0.0, -0.1, 0.0, 1.5, 0.0])
UR5_START = np.array([0.3, -1.2, 1.4, -1.6, -1.4, 0.2])


def tool_of(robot, q):
    """The tool's pose by Pinocchio alone."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, np.asarray(q))
    return data.oMf[robot.model.getFrameId(robot.tool)].homogeneous


@pytest.fixture(scope="module")
def pose(panda):
    return tool_of(panda, GOAL)


@pytest.fixture(scope="module")
def plan_to_pose(panda, pose):
    return mp.plan(panda, "default", pose, POST)


def moved(pose, **changes):
    """The pose, moved in the world and turned in the tool's frame."""
    out = pose.copy()
    out[:3, 3] += changes.get("by", 0.0)
    out[:3, :3] = out[:3, :3] @ Rotation.from_rotvec(changes.get("turn", np.zeros(3))).as_matrix()
    return out


# forms of a goal


def test_a_pose_is_reached(panda, pose, plan_to_pose):
    assert plan_to_pose.report.passed and plan_to_pose.status.ok
    np.testing.assert_allclose(tool_of(panda, plan_to_pose.trajectory.q[-1]), pose, atol=1e-6)
    np.testing.assert_array_equal(plan_to_pose.trajectory.q[0], panda.states["default"])
    assert plan_to_pose.goal_index == 0
    chosen = [each for each in plan_to_pose.candidates if each.chosen]
    assert len(chosen) == 1 and chosen[0].status.startswith("chosen, planned: minimum manipulability")
    np.testing.assert_allclose(chosen[0].q, plan_to_pose.path.goal)
    assert chosen[0].min_manipulability == pytest.approx(plan_to_pose.report.min_manipulability, rel=1e-3)


def test_the_motion_is_no_worse_than_to_the_joint_values(panda, plan_to_pose):
    given = mp.plan(panda, panda.neutral, GOAL, POST)
    assert plan_to_pose.report.min_manipulability >= given.report.min_manipulability * (1 - 1e-6)
    assert len(given.candidates) == 1 and given.candidates[0].chosen and given.goal_index == 0


def test_the_forms_of_a_pose_give_the_same_plan(panda, pose, plan_to_pose):
    forms = [pin.SE3(pose), pose.tolist(), PoseGoal(pose), [pose], (pin.SE3(pose),), pose[None], [PoseGoal(pin.SE3(pose))]]
    read = [read_goals("goal", each, panda)[0] for each in forms]
    assert all(len(each) == 1 and np.array_equal(each[0].pose.matrix, pose) for each in read)
    again = mp.plan(panda, panda.neutral, forms[3], POST)
    np.testing.assert_array_equal(again.trajectory.q, plan_to_pose.trajectory.q)


def test_states_are_goals_and_starts(panda):
    plan = mp.plan(panda, GOAL, "default", POST)
    np.testing.assert_allclose(plan.trajectory.q[-1], panda.states["default"], atol=1e-9)
    assert mp.plan(panda, "default", [GOAL, "default"], POST).goal_index == 1
    with pytest.raises(mp.errors.UnknownNameError, match=r"goal: got 'defalt'; allowed: did you mean default\?"):
        mp.plan(panda, GOAL, "defalt")
    with pytest.raises(mp.errors.UnknownNameError, match=r"goal\[1\]: got 'redy'"):
        mp.plan(panda, "default", [GOAL, "redy"])
    with pytest.raises(mp.errors.UnknownNameError, match="start: got 'redy'"):
        mp.plan(panda, "redy", GOAL)


def test_states_of_an_arm_without_any(planar):
    with pytest.raises(mp.errors.UnknownNameError, match="goal: got 'home'.*no named states"):
        mp.plan(planar, [0, 1.5, -2], "home")


@pytest.mark.slow
def test_a_free_axis_is_free(panda, pose):
    goal = mp.PoseGoal(pose, free_axis=[0, 0, 2.0])
    plan = mp.plan(panda, panda.neutral, goal, POST)
    tool = tool_of(panda, plan.trajectory.q[-1])
    np.testing.assert_allclose(tool[:3, 3], pose[:3, 3], atol=1e-6)
    np.testing.assert_allclose(tool[:3, 2], pose[:3, 2], atol=1e-6)
    turns = {round(float(np.arctan2(*(pose[:3, :2].T @ tool_of(panda, each.q)[:3, 0])[::-1])), 1) for each in plan.candidates}
    assert len(turns) > 10  # the angle about the axis is sampled
    exact = mp.plan(panda, panda.neutral, pose, POST)
    assert plan.report.min_manipulability >= exact.report.min_manipulability * (1 - 1e-6)


@pytest.mark.parametrize("rotation", [0.1, None])
def test_a_tolerance_is_used_and_kept(panda, pose, rotation):
    goal = mp.PoseGoal(pose, tolerance=mp.Tolerance(position=0.02, rotation=rotation))
    plan = mp.plan(panda, panda.neutral, goal, POST)
    off, turned = (float(each[0]) for each in goal.distances(tool_of(panda, plan.trajectory.q[-1])[None]))
    assert off <= 0.02 and turned <= (np.pi if rotation is None else rotation)
    centre = [each for each in plan.candidates if np.allclose(tool_of(panda, each.q), pose, atol=1e-6)]
    assert 0 < len(centre) < len(plan.candidates)


def test_poses_inside_a_tolerance_are_inside_and_spread(pose):
    goal = mp.PoseGoal(pose, tolerance=mp.Tolerance(position=0.02, rotation=0.1))
    inside = poses_inside(goal, 50)
    np.testing.assert_array_equal(inside, poses_inside(goal, 50))
    off, turned = goal.distances(inside)
    assert off[0] == 0 and turned[0] == pytest.approx(0, abs=1e-9)
    assert off.max() <= 0.02 and turned.max() <= 0.1 and np.median(off[1:]) > 0.01
    assert np.linalg.norm(np.mean(inside[1:, :3, 3] - pose[:3, 3], axis=0)) < 0.005


def test_of_a_list_the_best_is_taken_and_its_index_told(panda, pose):
    poor = np.array([1.2, 0.6, 0.0, -0.4, 0.0, 1.3, 0.8])  # nearly stretched
    plan = mp.plan(panda, panda.neutral, [poor, PoseGoal(pose), THROUGH], POST)
    assert plan.goal_index == 1
    np.testing.assert_allclose(tool_of(panda, plan.trajectory.q[-1]), pose, atol=1e-6)
    assert {each.goal_index for each in plan.candidates} == {0, 1, 2}
    rows = {each.goal_index: each.status for each in plan.candidates}
    assert "collides with post" in rows[2]
    assert "is not above" in rows[0]


def test_a_planar_arm_reaches_position_and_angle(planar):
    goal = tool_of(planar, [0.5, 1.0, -0.7])
    plan = mp.plan(planar, [0, 1.5, -2], goal)
    np.testing.assert_allclose(tool_of(planar, plan.trajectory.q[-1]), goal, atol=1e-6)
    free = mp.plan(planar, [0, 1.5, -2], mp.PoseGoal(goal, free_axis=[0, 0, 1]))
    np.testing.assert_allclose(tool_of(planar, free.trajectory.q[-1])[:3, 3], goal[:3, 3], atol=1e-6)
    assert free.report.min_manipulability >= plan.report.min_manipulability * (1 - 1e-6)
    with pytest.raises(mp.errors.InvalidInputError, match=r"goal\.free_axis.*planar arm"):
        mp.plan(planar, [0, 1.5, -2], mp.PoseGoal(goal, free_axis=[1, 0, 0]))


# six joints


def test_six_joints_stay_in_their_aspect(ur5):
    goal = tool_of(ur5, UR5_START + [0.6, 0.3, -0.3, 0.2, 0.3, 0.5])
    plan = mp.plan(ur5, UR5_START, goal)
    np.testing.assert_allclose(tool_of(ur5, plan.trajectory.q[-1]), goal, atol=1e-6)
    chosen = next(each for each in plan.candidates if each.chosen)
    assert chosen.least_crossings == 0 and "aspect" not in chosen.status
    others = [each for each in plan.candidates if each.least_crossings]
    assert others and all(each.bound == 0 and "in another aspect" in each.status for each in others)
    assert 4 <= len(plan.candidates) <= 8  # full turns are not listed


@pytest.mark.slow
def test_another_aspect_is_taken_only_where_the_same_is_not_free(ur5):
    goals = [UR5_START * [1, 1, 1, 1, -1, 1] + 0.2, UR5_START * [1, 1, 1, 1, -1, 1]]  # the wrist turned over
    plan = mp.plan(ur5, UR5_START, goals)
    chosen = next(each for each in plan.candidates if each.chosen)
    assert chosen.least_crossings == 1
    assert "in another aspect than the start, since none in the same is free" in chosen.status
    assert "different aspects" in plan.report.crossing_note


# the choice


def test_the_nearest_turn_inside_the_limits_is_taken(ur5, panda):
    near = np.full(6, 3.0)
    q = nearest_turns(ur5, np.full((1, 6), -3.0), near)
    np.testing.assert_allclose(q[0], np.where(np.arange(6) == 2, -3.0, -3.0 + 2 * np.pi))  # the elbow turns by ±180° only
    np.testing.assert_array_equal(nearest_turns(panda, np.full((1, 7), -2.0), np.full(7, 2.8)), np.full((1, 7), -2.0))


@pytest.mark.slow
def test_candidates_reach_their_goals_and_bounds_hold(panda, pose):
    goals = {3: PoseGoal(pose), 5: PoseGoal(moved(pose, by=[0.0, 0.05, 0.0]), free_axis=[0, 0, 1])}
    found = reaching(panda, goals, panda.neutral)
    assert set(found.goals) == {3, 5}
    for k, q in zip(found.goals, found.q, strict=True):
        assert goals[k].missed_by(panda, q) == ""
        assert not (panda.limits.outside(q) > 0).any()
    plan = mp.plan(panda, panda.neutral, [goals[3], goals[5]], POST)
    for each in plan.candidates:
        if each.is_free:
            ends = panda.kinematics().manipulability(np.array([panda.neutral, each.q]))
            assert each.bound == pytest.approx(ends.min())
            assert each.straight_min_manipulability <= each.bound * (1 + 1e-9)
        if not np.isnan(each.g):
            assert each.min_manipulability <= each.bound * (1 + 1e-6)


def test_redundancy_is_refined_between_the_samples(panda):
    """The best posture is at least as good as the best of 4000 samples of the redundancy."""
    start = panda.neutral
    target = tool_of(panda, [0.9, 0.5, -0.3, -1.6, 0.4, 2.0, 0.6])
    integral = mp.PathObjective().integral(panda)
    targets = read_goals("goal", target, panda)[0]
    best = find_candidates(targets, start, mp.Scene().collision_model(panda), integral, 0.0, ConstraintSet.of(panda, ()))[0]
    q = mp.inverse_kinematics(panda, target, samples=4000).q
    bound = min(panda.kinematics().manipulability(q).max(), panda.kinematics().manipulability(start))
    assert best.bound >= bound * (1 - 1e-5)


def rows(*bounds):
    """Candidates of bounds far apart from one another."""
    return ordered([
        mp.results.GoalCandidate(
            goal_index=k, q=np.full(3, float(k)), manipulability=b, bound=b, straight_g=1.0, straight_length=float(k)
        )
        for k, b in enumerate(bounds)
    ])  # fmt: skip


def made(planar, least, g=1.0):
    path = mp.JointPath.line([0.0, 0.1, 0.2], [0.5, 0.6, 0.7])
    result = mp.optimize_path(planar, path.start, path.goal)
    return copy.copy(result).__class__(**{**vars(result), "min_manipulability": least, "g": g})


def chosen(candidates, results):
    """The choice, and the goals tried, with results by goal."""
    tried = []

    def planner(q, seconds, notify):
        assert seconds > 0
        tried.append(int(q[0]))
        return results[int(q[0])]

    return choose(candidates, planner, Deadline.within(10.0), lambda share, text: None), tried


def test_no_path_is_planned_that_cannot_win(planar):
    choice, tried = chosen(rows(0.1, 0.3, 0.2), {1: made(planar, 0.25)})
    assert tried == [1] and choice.goal_index == 1
    assert "bound 0.2 is not above 0.25" in next(each.status for each in choice.candidates if each.goal_index == 2)


def test_others_are_planned_where_they_can_be_better(planar):
    results = {k: made(planar, least) for k, least in enumerate((0.05, 0.1, 0.19, 0.02))}
    choice, tried = chosen(rows(0.11, 0.3, 0.2, 0.15), results)
    assert tried[0] == 1 and tried[1] == 0  # the best bound, then the nearest
    assert choice.goal_index == 2 and 3 not in tried


def test_a_candidate_without_a_path_is_left_out(planar):
    choice, tried = chosen(rows(0.1, 0.3), {1: mp.results.NoPath(message="no path was found"), 0: made(planar, 0.1)})
    assert tried == [1, 0] and choice.goal_index == 0
    assert [each.status for each in choice.candidates if each.goal_index == 1] == ["left out: no path: no path was found"]
    nothing, _ = chosen(rows(0.1, 0.3), {0: mp.results.NoPath(message="walls"), 1: mp.results.NoPath(message="more walls")})
    assert nothing.result is None and "2 candidates tried; the first: more walls" in nothing.failure


@pytest.mark.slow
def test_only_a_few_paths_are_planned(planar):
    bounds = np.linspace(0.9, 1.0, 20)
    _, tried = chosen(rows(*bounds), {k: made(planar, 0.1) for k in range(20)})
    assert len(tried) == PATHS


def test_candidates_share_the_time(planar):
    given = []

    def planner(q, seconds, notify):
        given.append(seconds)
        return made(planar, 0.1)

    choose(rows(0.9, 0.91, 0.92, 0.93, 0.94), planner, Deadline.within(10.0), lambda share, text: None)
    assert len(given) == PATHS
    assert all(0 < each <= 0.76 * 10.0 for each in given[:-1])
    assert given == sorted(given, reverse=True) or given[-1] > given[-2]  # the last one gets what is left


def test_of_equal_minima_the_smaller_g_is_taken(planar):
    results = {0: made(planar, 0.1, g=5.0), 1: made(planar, 0.1, g=4.0)}
    choice, tried = chosen(rows(0.2, 0.21), results)
    assert sorted(tried) == [0, 1] and choice.goal_index == 1


# what is left out, and wrong input


@pytest.mark.slow
def test_what_is_out_of_reach_is_told(panda, pose):
    with pytest.raises(mp.errors.InvalidInputError, match=r"goal: .*out of reach: .* leaves the tool .* mm and .* away"):
        mp.plan(panda, panda.neutral, moved(pose, by=[2.0, 0.0, 0.0]), POST)
    plan = mp.plan(panda, panda.neutral, [moved(pose, by=[2.0, 0.0, 0.0]), pose], POST)
    assert plan.goal_index == 1
    assert "out of reach" in next(each.status for each in plan.candidates if each.goal_index == 0)


@pytest.mark.slow
def test_the_distance_out_of_reach_is_that_beyond_the_arm(planar):
    goal = np.eye(4)
    goal[0, 3] = 3.4
    found = nearest(planar, [PoseGoal(goal)], planar.neutral, np.zeros(planar.n, dtype=bool))[0]
    assert found.position == pytest.approx(0.4, abs=1e-3) and found.rotation < 1e-2
    within = nearest(
        planar,
        [PoseGoal(goal, tolerance=mp.Tolerance(position=0.5, rotation=0.1))],
        planar.neutral,
        np.zeros(planar.n, dtype=bool),
    )[0]
    assert len(within.reaching) and not len(found.reaching)


@pytest.mark.slow
def test_joints_that_stop_a_pose_are_named(planar):
    arm = planar.with_limits(lower=-0.5, upper=0.5)
    goal = tool_of(planar, [0.4, 0.4, 0.9])
    found = nearest(arm, [PoseGoal(goal)], arm.neutral, np.zeros(arm.n, dtype=bool))[0]
    assert "joint3" in found.stopped and "joint3" in str(found)
    with pytest.raises(mp.errors.InvalidInputError, match="with .*joint3.* at a limit"):
        mp.plan(arm, [0.0, 0.1, 0.2], goal)


def test_colliding_candidates_are_counted(panda):
    with pytest.raises(mp.errors.InvalidInputError, match=r"of \d+ configurations, \d+ x panda_link\d_0 collides with post"):
        mp.plan(panda, panda.neutral, tool_of(panda, THROUGH), POST)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"1 x panda_joint1 is 6\.1 rad outside its limits; 1 x .* collides with post"
    ):
        mp.plan(panda, panda.neutral, [THROUGH, [9.0, 0, 0, -2, 0, 2, 0]], POST)


@pytest.mark.slow
def test_solutions_outside_the_limits_are_told(ur5):
    goal = tool_of(ur5, UR5_START + [0.6, 0.3, -0.3, 0.2, 0.3, 0.5])
    tight = ur5.with_limits(lower=UR5_START - 1.0, upper=UR5_START + 1.0)
    plan = mp.plan(tight, UR5_START, goal)
    np.testing.assert_allclose(tool_of(ur5, plan.trajectory.q[-1]), goal, atol=1e-6)
    outside = [each for each in plan.candidates if "rad outside its limits" in each.status]
    assert len(outside) + sum(each.is_free for each in plan.candidates) == len(mp.inverse_kinematics(ur5, goal, turns=False))
    assert outside
    for each in outside:
        np.testing.assert_allclose(tool_of(ur5, each.q), goal, atol=1e-6)
        joint = each.status.split()[2]
        assert tight.limits.outside(each.q)[tight.joint_names.index(joint)] > 0


def test_two_links_reach_a_pose_or_a_place():
    two = mp.planar_arm([1.0, 0.5])
    goal = tool_of(two, [0.4, 0.9])
    plan = mp.plan(two, [0.1, 0.5], goal)
    np.testing.assert_allclose(tool_of(two, plan.trajectory.q[-1]), goal, atol=1e-6)
    free = mp.plan(two, [0.1, 0.5], mp.PoseGoal(goal, free_axis=[0, 0, -1]))
    assert {round(each.q[1], 6) for each in free.candidates} == {0.9, -0.9}


@pytest.mark.slow
def test_five_joints_point_and_use_a_tolerance():
    arm = mp.load_robot("so100")
    q = arm.neutral + [0.3, 0.2, -0.2, 0.3, 0.4]
    goal = arm.kinematics().pose(q).copy()
    goal[:3, :3] = goal[:3, :3] @ Rotation.from_rotvec([0.0, 0.0, 0.3]).as_matrix()
    for free in (
        mp.PoseGoal(goal, free_axis=[0, 0, 1]),
        mp.PoseGoal(goal, tolerance=mp.Tolerance(position=0.01, rotation=0.35)),
    ):
        plan = mp.plan(arm, arm.neutral, free)
        off, turned = (float(each[0]) for each in free.distances(arm.kinematics().pose(plan.trajectory.q[-1:])))
        assert off <= free.allowed[0] + 1e-6 and turned <= free.allowed[1] + 1e-6


def test_an_arm_that_stands_in_a_goal_of_a_list_stays(panda):
    plan = mp.plan(panda, panda.neutral, [GOAL, panda.neutral], POST)
    assert plan.goal_index == 1 and plan.status is mp.Status.AT_GOAL


NOT_RIGID = np.diag([2.0, 1.0, 1.0, 1.0])


@pytest.mark.parametrize(
    ("goal", "message"),
    [
        ([], r"goal: got \[\]; allowed: at least one goal"),
        ((), "at least one goal"),
        ([GOAL, [0.0] * 3], r"goal\[1\]: .*shape \(7,\)"),
        ([GOAL, NOT_RIGID], r"goal\[1\]: .*a rotation and a translation"),
        (NOT_RIGID, "goal: .*a rotation and a translation"),
        (np.zeros((3, 3)), "goal: .*shape"),
        (np.zeros((2, 7)), "goal: .*one configuration"),
        ([GOAL, None], r"goal\[1\]: got None; allowed: a configuration \(n,\), the name of a state, a pose"),
        ([[GOAL]], r"goal\[0\]"),
        (3.0, "goal: got 3.0"),
        ({"pose": 1}, "goal: got"),
        ([GOAL, np.full(7, np.nan)], r"goal\[1\]: .*finite"),
        ([1j] * 7, "goal.*real numbers"),
    ],
)
@pytest.mark.parametrize("throw", [True, False])
def test_wrong_goals_raise_at_once(panda, goal, message, throw):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.plan(panda, panda.neutral, goal, POST, throw=throw)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"free_axis": [0, 0, 0]}, "free_axis: .*not zero"),
        ({"free_axis": [0, 1]}, r"free_axis: .*shape \(3,\)"),
        ({"free_axis": "z"}, "free_axis: got 'z'"),
        ({"tolerance": 0.1}, "tolerance: got 0.1; allowed: a Tolerance"),
        ({"tolerance": mp.Tolerance(rotation=0.1)}, "tolerance: .*a position"),
        ({"pose": NOT_RIGID}, "pose: .*a rotation and a translation"),
        ({"pose": np.eye(3)}, r"pose: .*shape \(4, 4\)"),
    ],
)
def test_wrong_pose_goals(options, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.PoseGoal(**{"pose": np.eye(4), **options})


def test_four_joints_and_four_rows_are_a_pose_only_if_rigid():
    arm = mp.planar_arm([1.0, 1.0, 1.0, 1.0])
    assert read_goals("goal", np.eye(4).tolist(), arm)[0][0].pose is not None
    several, is_list = read_goals("goal", [[0.1] * 4, [0.2] * 4, [0.3] * 4, [0.4] * 4], arm)
    assert is_list and [each.q[0] for each in several] == [0.1, 0.2, 0.3, 0.4]


def test_a_first_path_needs_one_configuration(panda, pose):
    seeding = mp.Seeding(initial=mp.JointPath.line(panda.neutral, GOAL))
    with pytest.raises(mp.errors.InvalidInputError, match="seeding.initial"):
        mp.plan(panda, panda.neutral, pose, seeding=seeding)


def test_a_wrong_start_raises_before_goals_are_solved(panda, pose):
    with pytest.raises(mp.errors.InvalidInputError, match="start: .*overlap"):
        mp.plan(panda, THROUGH, pose, POST)
    with pytest.raises(mp.errors.InvalidInputError, match=r"start\[0\] \(panda_joint1\): got 9"):
        mp.plan(panda, [9.0, 0, 0, -2, 0, 2, 0], pose, POST)


@pytest.mark.slow
def test_an_end_beside_the_pose_fails_the_check(panda, pose, monkeypatch):
    monkeypatch.setattr(PoseGoal, "missed_by", lambda *_: "the tool ends 3 mm and 0° from the pose of the goal")
    with pytest.raises(mp.errors.PlanningError, match="the tool ends 3 mm"):
        mp.plan(panda, panda.neutral, pose, POST)
    plan = mp.plan(panda, panda.neutral, pose, POST, throw=False)
    assert plan.status is mp.Status.CHECK_FAILED and not plan.report.passed


def test_a_missed_pose_is_measured(panda, pose):
    goal = PoseGoal(moved(pose, by=[0.0, 0.0, 0.003]))
    assert goal.missed_by(panda, GOAL).startswith("the tool ends 3 mm and ")
    assert PoseGoal(goal.matrix, tolerance=mp.Tolerance(position=0.004, rotation=0.01)).missed_by(panda, GOAL) == ""
    turned = moved(pose, turn=[0.0, 0.0, 0.5])
    assert "29°" in PoseGoal(turned).missed_by(panda, GOAL)
    assert PoseGoal(turned, free_axis=[0, 0, 1]).missed_by(panda, GOAL) == ""


# many, files, shell


@pytest.mark.slow
def test_many_problems_take_all_forms(panda, pose, plan_to_pose):
    problems = [
        mp.Problem(robot=panda, start="default", goal=goal, scene=POST)
        for goal in (pose, [THROUGH, mp.PoseGoal(pose)], tool_of(panda, THROUGH))
    ]
    plans = mp.plan_many(problems)
    np.testing.assert_array_equal(plans[0].trajectory.q, plan_to_pose.trajectory.q)
    assert plans[1].goal_index == 1
    assert plans[2].status is mp.Status.NOT_VALID and "collides with post" in plans[2].message
    with pytest.raises(mp.errors.InvalidInputError, match=r"problems\[0\]\.goal\[1\]"):
        mp.plan_many([mp.Problem(robot=panda, start=GOAL, goal=[pose, [1.0]])])


def test_a_saved_plan_keeps_its_candidates(panda, plan_to_pose, tmp_path):
    from manipplan.plans.archive import read_plan, write_plan

    write_plan(plan_to_pose, tmp_path / "plan.json")
    again = read_plan(tmp_path / "plan.json", robot=panda, scene=None, measure=None)
    assert again.goal_index == plan_to_pose.goal_index
    assert list(map(str, again.candidates)) == list(map(str, plan_to_pose.candidates))


def test_pose_goals_are_pickled(pose):
    goal = pickle.loads(pickle.dumps(mp.PoseGoal(pose, free_axis=[0, 0, 1])))
    np.testing.assert_array_equal(goal.pose, pose)
    assert "\n" not in repr(goal)


def test_the_numbers_of_a_pose():
    by_angles = pose_of_numbers("goal_pose", [0.1, 0.2, 0.3, np.pi, 0.0, np.pi / 2])
    by_quaternion = pose_of_numbers("goal_pose", [0.1, 0.2, 0.3, *Rotation.from_matrix(by_angles[:3, :3]).as_quat()])
    np.testing.assert_allclose(by_angles, by_quaternion, atol=1e-12)
    np.testing.assert_allclose(by_angles[:3, 3], [0.1, 0.2, 0.3])
    with pytest.raises(mp.errors.InvalidInputError, match="6 or 7 numbers, not 5"):
        pose_of_numbers("goal_pose", [0.0] * 5)


def test_goals_of_a_file(panda, tmp_path):
    file = tmp_path / "grasps.yaml"
    file.write_text(
        "goals:\n"
        "  - {position: [0.45, 0.2, 0.4], rotation: [3.1416, 0, 0], free_axis: [0, 0, 1]}\n"
        "  - {position: [0.45, 0.2, 0.4], rotation: [1, 0, 0, 0], tolerance: {position: 0.01, rotation: 0.1}}\n"
        "  - {position: [0.45, 0.2, 0.4], rotation: [[1, 0, 0], [0, -1, 0], [0, 0, -1]]}\n"
        f"  - {{q: {GOAL.tolist()}}}\n"
        "  - {state: default}\n"
    )
    goals = goals_from_yaml(file, panda)
    np.testing.assert_allclose(goals[1].pose, goals[2].pose, atol=1e-12)
    np.testing.assert_allclose(goals[0].pose, goals[2].pose, atol=1e-4)
    assert goals[1].tolerance == mp.Tolerance(position=0.01, rotation=0.1)
    np.testing.assert_array_equal(goals[3], GOAL)
    np.testing.assert_array_equal(goals[4], panda.states["default"])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("goals: []", "at least one goal under the single key goals"),
        ("[1, 2]", "under the single key goals"),
        ("goals: [{position: [0, 0, 0]}]", r"goals\[0\] in .*: .*position and rotation"),
        ("goals: [{state: default}, {q: [1, 2]}]", r"goals\[1\]\.q in .*shape \(7,\)"),
        ("goals: [{state: defalt}]", r"goals\[0\]\.state in .*did you mean default"),
        ("goals: [{state: 3}]", r"goals\[0\]\.state in .*a name"),
        ("goals: [{q: default}]", r"goals\[0\]\.q in .*one number per joint"),
        ("goals: [{position: [0, 0, 0], rotation: [2, 0, 0, 0]}]", r"goals\[0\]\.rotation in .*of length 1, not 2"),
        ("goals: [{position: [0, 0], rotation: [0, 0, 0]}]", r"goals\[0\]\.position in .*shape \(3,\)"),
        ("goals: [{position: [0, 0, 0], rotation: [0, 0, 0], tolerance: 1}]", r"goals\[0\]\.tolerance in "),
        (
            "goals: [{position: [0, 0, 0], rotation: [0, 0, 0], tolerance: {position: -1}}]",
            r"goals\[0\]\.position in .*at least 1e-09",
        ),
        ("goals: [{position: [0, 0, 0], rotation: [0, 0, 0], free_axis: [0, 0, 0]}]", r"goals\[0\]\.free_axis in .*not zero"),
        ("goals: [{position: [0, 0, 0], rotation: [0, 0, 0], colour: red}]", r"goals\[0\] in "),
        ("goals: [7]", r"goals\[0\] in "),
        ("goals: [", "YAML"),
    ],
)
def test_wrong_files_of_goals(panda, tmp_path, text, message):
    (tmp_path / "grasps.yaml").write_text(text)
    with pytest.raises(mp.errors.FileFormatError, match=message):
        goals_from_yaml(tmp_path / "grasps.yaml", panda)


@pytest.mark.slow
def test_a_plan_to_a_pose_from_the_shell(tmp_path, capsys):
    out = ["--out", str(tmp_path / "out")]
    command = ["plan", "panda", "--start", "default", "--goal-pose", "0.45", "0.2", "0.4", "1", "0", "0", "0"]
    assert main([*command, *out]) == 0
    assert "all checks passed" in capsys.readouterr().out
    assert main([*command, "--goal", "default", *out]) == 2
    assert "exactly one of them" in capsys.readouterr().err
    far = [9.0, *GOAL[1:].tolist()]
    (tmp_path / "grasps.yaml").write_text(f"goals: [{{q: {far}}}, {{q: {GOAL.tolist()}}}]")
    assert main(["plan", "panda", "--start", "default", "--goals", str(tmp_path / "grasps.yaml"), *out]) == 0
    assert "goal 1 of" in capsys.readouterr().out


def test_a_goal_by_joints_says_what_a_mapping_is(ur5):
    goal = dict(zip(ur5.joint_names, ur5.neutral, strict=True))
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"poses by tool \(tool0\); a configuration is one value per joint, shape \(6,\)"
    ):
        mp.plan(ur5, ur5.neutral, goal)
