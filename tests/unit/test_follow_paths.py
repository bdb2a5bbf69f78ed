"""follow on tool paths that others made, where a few positions or samples do not suffice; judged by Pinocchio and coal."""

import importlib
import json
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from scipy.optimize import minimize
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.search.interruptions import find_gaps
from manipplan.search.layers import choose_positions, step_limits
from manipplan.support.deadline import Deadline, OutOfTimeError, TimeLimit
from manipplan.support.progress import silent
from manipplan.tool_path.engine import ToolPathPlanner
from manipplan.tool_path.parts import connect, find_parts, raise_minimum

FOLDER = Path(__file__).parents[2] / "benchmarks" / "outside"
CLOSE = mp.Tolerance(position=1e-4, rotation=np.deg2rad(0.1))


def read(file, name):
    """The path and the boxes of a problem."""
    problem = json.loads((FOLDER / file).read_text())[name]
    rows = np.array(problem["poses_xyz_xyzw"])
    poses = np.tile(np.eye(4), (len(rows), 1, 1))
    poses[:, :3, 3], poses[:, :3, :3] = rows[:, :3], Rotation.from_quat(rows[:, 3:]).as_matrix()
    boxes = [mp.Box(**box, name=f"box {k}") for k, box in enumerate(problem["boxes"])]
    return mp.CartesianPath.through(poses), mp.Scene(boxes), problem.get("joints")


@pytest.fixture(scope="module")
def flappy():
    """The Panda with its hand as tool, and CppFlow's path between boxes."""
    arm = mp.load_robot("panda")
    data = arm.model.createData()
    pin.framesForwardKinematics(arm.model, data, arm.neutral)
    tool, hand = (data.oMf[arm.model.getFrameId(name)] for name in (arm.tool, "panda_hand"))
    path, scene, _ = read("tool_paths_cppflow.json", "panda__flappy_bird")
    return arm.with_tool((tool.inverse() * hand).homogeneous, name="hand"), path, scene


def farthest(robot, plan, path):
    """The largest distance and angle of given poses from the tool there, by Pinocchio, as shares of what is allowed."""
    data, frame, worst = robot.model.createData(), robot.model.getFrameId(robot.tool), np.zeros(2)
    for q, pose in zip(plan.path(path.knots), path(path.knots), strict=True):
        pin.framesForwardKinematics(robot.model, data, q)
        reached = data.oMf[frame].homogeneous
        angle = np.linalg.norm(pin.log3(reached[:3, :3].T @ pose[:3, :3]))
        worst = np.maximum(worst, [np.linalg.norm(reached[:3, 3] - pose[:3, 3]) / CLOSE.position, angle / CLOSE.rotation])
    return worst


@pytest.mark.slow
def test_branches_that_meet_between_samples_are_connected(flappy):
    """Without the samples at which branches meet, as many positions do not connect."""
    robot, path, scene = flappy
    s = choose_positions(path, stride=0.0075, closed=False)
    layers = [mp.sample_layers(robot, path, s, scene=scene, spare=1e-4, spacing=each) for each in (None, 0.05)]
    assert [find_gaps(each, 0.2).parts for each in layers] == [2, 1]


@pytest.mark.slow
def test_positions_are_added_only_where_gaps_have_to_be_closed(flappy):
    robot, path, scene = flappy
    s = choose_positions(path, closed=False)
    layers = mp.sample_layers(robot, path, s, scene=scene, spare=1e-4, spacing=0.05)
    planner = ToolPathPlanner(path=path, layers=layers)
    (first, last), *_ = find_gaps(layers, 0.2).ranges
    connected = connect(planner, 0.2, silent).layers
    assert find_gaps(connected, 0.2).ranges == ()
    added = np.setdiff1d(connected.s, s)
    assert len(added) and (added > s[first]).all() and (added < s[last]).all()
    assert np.isin(s, connected.s).all() and np.diff(connected.s).min() > np.diff(s).min() / 64.01
    for k, each in enumerate(connected.s):
        pose = path(np.array([each]))[0]
        np.testing.assert_allclose(connected.poses[k], pose, atol=1e-12)
        data = robot.model.createData()
        pin.framesForwardKinematics(robot.model, data, connected.q[k][0])
        np.testing.assert_allclose(data.oMf[robot.model.getFrameId(robot.tool)].homogeneous, pose, atol=1e-6)


@pytest.mark.slow
def test_cppflows_path_between_boxes_is_followed_without_interruption(flappy):
    robot, path, scene = flappy
    plan = mp.follow(robot, path, scene, tolerance=CLOSE)
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    assert (farthest(robot, plan, path) <= 1.0).all()
    assert np.abs(np.diff(plan.path(path.knots), axis=0)).max() < np.deg2rad(7)
    q = plan.trajectory(np.linspace(0, plan.trajectory.duration, 2000))
    assert not scene.collision_model(robot).in_collision_rows(q).any()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["fetch_arm__rot_yz", "fetch_arm__hello_mini", "fetch_arm__hello"])
def test_paths_of_an_arm_like_fetch_are_followed_within_a_tenth_of_a_millimetre(name):
    path, scene, joints = read("fetch_like_paths.json", name)
    robot = mp.load_robot(FOLDER / "fetch_like.urdf", tool="gripper", joints=joints)
    plan = mp.follow(robot, path, scene, tolerance=CLOSE)
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    assert (farthest(robot, plan, path) <= 1.0).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["fetch_arm__hello_mini", "fetch_arm__s"])
def test_with_the_torso_fewer_samples_give_as_large_a_minimum(name):
    path, scene, _ = read("fetch_like_paths.json", name)
    robot = mp.load_robot(FOLDER / "fetch_like.urdf", tool="gripper")
    plan, full = (mp.follow(robot, path, scene, tolerance=CLOSE, samples=each) for each in (None, 96))
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    assert (farthest(robot, plan, path) <= 1.0).all()
    assert np.abs(np.diff(plan.path(path.knots), axis=0)).max() < np.deg2rad(7)
    assert plan.report.min_manipulability > 0.99 * full.report.min_manipulability


@pytest.mark.slow
def test_all_samples_are_taken_where_fewer_do_not_suffice(monkeypatch):
    """With two values of each parameter no configuration is free at the first pose."""
    monkeypatch.setattr(importlib.import_module("manipplan.jobs.follow"), "FEWER_SAMPLES", 2)
    path, scene, _ = read("fetch_like_paths.json", "fetch_arm__hello_mini")
    robot = mp.load_robot(FOLDER / "fetch_like.urdf", tool="gripper")
    layers = mp.sample_layers(robot, path, choose_positions(path), scene=scene, spare=1e-4).inside(robot.limits)
    assert mp.follow(robot, path, scene).search.bound == pytest.approx(layers.bound, rel=1e-12)
    few = mp.sample_layers(robot, path, choose_positions(path), samples=5, scene=scene, spare=1e-4).inside(robot.limits)
    share = mp.max_min_search(few, 0.2).minimum / few.bound
    planner = ToolPathPlanner(path=path, layers=few)
    assert planner.reaches(0.99 * share, 0.2) and not planner.reaches(1.01 * share, 0.2)


@pytest.mark.slow
def test_positions_are_added_where_faster_joints_allow_a_larger_minimum(monkeypatch):
    """On the square, with at most 0.2 rad between positions 3 cm apart, the minimum is 5 % smaller than it can be.

    No joint moves more than 7° between given poses for that, as on the motion without it; some do where all may be as fast.
    """
    path, scene, joints = read("fetch_like_paths.json", "fetch_arm__square")
    robot = mp.load_robot(FOLDER / "fetch_like.urdf", tool="gripper", joints=joints)
    layers = mp.sample_layers(robot, path, choose_positions(path), scene=scene, spare=1e-4, spacing=0.05)
    planner, before = ToolPathPlanner(path=path, layers=layers), mp.max_min_search(layers, 0.2)
    calm, (_, found) = raise_minimum(planner, 0.2, silent)
    assert planner.is_calm(before) and calm.is_calm(found) and found.minimum > 1.04 * before.minimum
    monkeypatch.setattr("manipplan.tool_path.parts.CALM", np.inf)
    raised, (_, after) = raise_minimum(planner, 0.2, silent)
    assert after.minimum >= found.minimum and (np.abs(np.diff(after.q, axis=0)) < 0.2).all() and not raised.is_calm(after)
    assert after.minimum > 0.99 * mp.max_min_search(layers, 1.6).minimum  # nothing more is to win
    assert np.isin(layers.s, raised.layers.s).all() and len(raised.layers.s) < 1.5 * len(layers.s)


@pytest.mark.slow
def test_a_larger_minimum_keeps_the_steps_between_given_poses(flappy):
    """Without more positions the minimum is 0.00181; a grid of 7,200 samples at each given pose, steps below 7°, has 0.00202."""
    robot, path, scene = flappy
    plan = mp.follow(robot, path, scene, tolerance=CLOSE)
    assert plan.report.passed and plan.report.min_manipulability > 0.00194
    assert (farthest(robot, plan, path) <= 1.0).all()
    assert np.abs(np.diff(plan.path(path.knots), axis=0)).max() < np.deg2rad(7)


# ---- no motion


def turning(pose, angle):
    """The tool turns about its own z-axis where it stands."""
    poses = np.tile(pose, (40, 1, 1))
    for k, each in enumerate(np.linspace(0, angle, 40)):
        poses[k, :3, :3] = pose[:3, :3] @ pin.exp3(np.array([0, 0, each]))
    return mp.CartesianPath.through(poses)


@pytest.mark.slow
def test_a_motion_that_a_joint_limit_ends_names_the_place_the_joint_and_the_resolution():
    panda = mp.load_robot("panda")
    pose = panda.kinematics().pose(panda.states["default"])
    found = mp.follow(panda, turning(pose, 11.0), throw=False)
    assert found.status is mp.Status.NOT_CONNECTED
    assert found.message.startswith("no motion leads on from s = 0.")
    assert "limit of panda_joint" in found.message and "values of panda_joint7 0.00806 rad apart" in found.message
    apart = float(found.message.split("positions at most ")[1].split(" mm")[0])
    assert apart < 1e-6  # the tool turns on the spot
    assert "with 2 interruptions there is a motion: interruptions=2 allows them" in found.message


@pytest.mark.slow
def test_a_wall_that_ends_all_motions_is_named():
    panda = mp.load_robot("panda")
    begin = panda.kinematics().pose(panda.states["default"])
    end = begin.copy()
    end[:3, 3] += [0, 0.3, 0]
    wall = mp.Box(size=(0.6, 0.02, 0.6), position=begin[:3, 3] + [0, 0.15, -0.25], name="wall")
    with pytest.raises(mp.errors.ManipplanError) as caught:
        mp.follow(panda, mp.CartesianPath.line(begin, end), mp.Scene([wall]))
    assert "wall" in str(caught.value)


# ---- the time limit


def test_what_was_found_is_kept_where_no_time_is_left_for_more():
    """No positions are added then, and the refinement begins no solve."""
    panda = mp.load_robot("panda")
    begin = panda.kinematics().pose(panda.states["default"])
    end = begin.copy()
    end[:3, 3] += [0, 0.4, 0]
    path = mp.CartesianPath.line(begin, end)
    layers = mp.sample_layers(panda, path, 12, samples=60)
    late = ToolPathPlanner(path=path, layers=layers, deadline=Deadline.within(0.0))
    planner, (_, found) = raise_minimum(late, 0.4, silent)
    assert planner is late and np.array_equal(found.q, mp.max_min_search(layers, 0.4).q)
    refined = late.along(found, silent)
    assert np.array_equal(refined.refinement.q, found.q) and np.abs(refined.path(layers.s) - found.q).max() < 1e-3


def test_a_motion_is_not_begun_to_be_improved_where_its_checks_would_end_too_late():
    panda = mp.load_robot("panda")
    path = mp.CartesianPath.line(*(panda.kinematics().pose(panda.neutral + [each, 0, 0, 0, 0, 0, 0]) for each in (0.0, 0.1)))
    planner = ToolPathPlanner(path=path, layers=mp.sample_layers(panda, path, 6, samples=40))
    _, found = planner.search(0.4)
    with pytest.raises(OutOfTimeError):
        replace(planner, check_ending=TimeLimit(1e-3, "").check_ending).along(found, silent)
    assert replace(planner, check_ending=TimeLimit(600.0, "").check_ending).along(found, silent).ending > 0.3


@pytest.mark.slow
def test_a_time_limit_that_is_too_short_finds_nothing_and_says_so(flappy):
    robot, path, scene = flappy
    began = time.monotonic()
    found = mp.follow(robot, path, scene, tolerance=CLOSE, time_limit=0.05, throw=False)
    assert time.monotonic() - began < 2.0
    assert found.status is mp.Status.NOT_IN_TIME and found.trajectory is None
    assert found.message.startswith(
        "no motion along the path was proven within time_limit = 0.05 s; the last step was 'sampling"
    )
    with pytest.raises(mp.errors.PlanningError, match="time_limit = 0.05 s"):
        mp.follow(robot, path, scene, tolerance=CLOSE, time_limit=0.05)


@pytest.mark.slow
def test_a_time_limit_that_is_not_reached_changes_nothing(flappy):
    robot, path, scene = flappy
    free, limited = (mp.follow(robot, path, scene, tolerance=CLOSE, time_limit=each) for each in (None, 600.0))
    np.testing.assert_array_equal(free.trajectory.q, limited.trajectory.q)


@pytest.mark.slow
def test_a_motion_that_is_found_in_time_is_returned_without_improvement(flappy, monkeypatch):
    from manipplan.support import deadline
    from manipplan.tool_path import engine

    robot, path, scene = flappy
    best = mp.follow(robot, path, scene, tolerance=CLOSE)
    monkeypatch.setattr(engine, "ENDING", 600.0)  # timing and checks seem to need all of the time
    monkeypatch.setattr(deadline, "LEAST_ENDING", 0.0)
    plan = mp.follow(robot, path, scene, tolerance=CLOSE, time_limit=600.0)
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    assert plan.refinement.refined == pytest.approx(plan.refinement.discrete)
    assert plan.report.min_manipulability <= best.report.min_manipulability * (1 + 1e-6)


@pytest.mark.parametrize("value", [0.0, -1.0, np.nan, np.inf, "soon", True])
def test_a_time_limit_that_is_none_is_refused(flappy, value):
    with pytest.raises(mp.errors.InvalidInputError, match="^time_limit: got"):
        mp.follow(*flappy, time_limit=value)


@pytest.mark.slow
def test_the_progress_never_falls_though_positions_are_added(flappy):
    robot, path, scene = flappy
    shares = []
    mp.follow(robot, path, scene, tolerance=CLOSE, progress=lambda share, text: shares.append((share, text)))
    assert [share for share, _ in shares] == sorted(share for share, _ in shares) and shares[-1] == (1.0, "done")
    assert any("positions half-way in" in text for _, text in shares)


@pytest.mark.slow
def test_given_poses_that_the_tool_does_not_come_past_fail_the_check(flappy, monkeypatch):
    """The tool may be near the path all the time, and yet no time near one of its poses."""
    from manipplan.jobs import follow

    robot, path, scene = flappy

    def miss_a_pose(*arguments):
        deviation, missed = measured(*arguments)
        return deviation, replace(missed, position=1.002e-4)

    measured = follow.tool_distances
    monkeypatch.setattr(follow, "tool_distances", miss_a_pose)
    plan = mp.follow(robot, path, scene, tolerance=CLOSE, throw=False)
    assert plan.status is mp.Status.CHECK_FAILED and not plan.report.passed
    assert "leaves the path by 0.0001 m after" in " ".join(plan.report.faults) and "of the poses" in plan.report.faults[0]


# ---- the same paths in a program


@pytest.mark.slow
def test_a_step_of_a_program_connects_where_follow_does(flappy):
    robot, path, scene = flappy
    program = mp.sequence(robot, robot.neutral, [mp.MoveAlong(path, tolerance=CLOSE)], scene)
    followed = mp.follow(robot, path, scene, start=robot.neutral, tolerance=CLOSE)
    assert program.passed and program.min_manipulability > 0.95 * followed.report.min_manipulability


@pytest.mark.slow
def test_a_long_seam_along_a_limit_is_a_step_of_a_program():
    """Splines between positions at a limit leave it; those a little inside stay inside."""
    u = np.linspace(0, 1, 400)
    angle, radius = 7.4 * u - 2.6, 0.45 + 0.05 * np.sin(9 * u)
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (400, 1, 1))
    poses[:, :3, 3] = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.25 + 0.25 * u], 1)
    seam = mp.MoveAlong(mp.CartesianPath.through(poses), task=mp.Task.pointing([0, 0, 1]))
    assert mp.sequence(mp.load_robot("panda"), "default", [seam]).passed


def test_steps_that_are_small_at_given_poses_do_not_part_a_path(panda):
    """Closer positions have smaller steps, below the distance of samples: there the path is searched with all."""
    begin = np.diag([1.0, -1.0, -1.0, 1.0])
    begin[:3, 3] = 0.5, -0.1, 0.4
    end = begin.copy()
    end[1, 3] = 0.1
    path = mp.CartesianPath.line(begin, end)
    layers = mp.sample_layers(panda, path, 12, spacing=0.05)
    planner = ToolPathPlanner(path=path, layers=layers).with_pose_step(0.01)
    assert not mp.max_min_search(planner.layers, 0.2, throw=False, explain=False).connected
    (part,) = next(find_parts(planner, 0.2, 12, silent))
    assert part.found.connected and part.found.minimum == mp.max_min_search(layers, 0.2).minimum


@pytest.mark.slow
def test_joints_keep_their_limits_where_they_turn_back_between_knots(panda):
    """Joint 5 turns back at its limit: it was 5e-6 rad beyond it, between the points at which that was seen."""
    begin = np.eye(4)
    begin[:3, :3], begin[:3, 3] = Rotation.from_rotvec([-0.87, -0.36, -1.71]).as_matrix(), (0.01, 0.32, 0.74)
    circle = mp.CartesianPath.circle(begin, (-0.02885211, 0.26843216, 0.7579842), (0.4099795, -0.559972, -0.719964))
    plan = mp.follow(panda, mp.CartesianPath.through(circle.sample(25)), tolerance=mp.Tolerance(position=5e-4, rotation=5e-3))
    assert plan.report.passed and plan.report.limits["position"].ratio <= 0


def distances_from_line(points, line):
    """Distances (k,) of points (k, 3) from a finely sampled line (m, 3)."""
    _, nearest = cKDTree(line).query(points)
    found = []
    for first in (np.maximum(nearest - 1, 0), np.minimum(nearest, len(line) - 2)):
        edge, offset = line[first + 1] - line[first], points - line[first]
        share = np.clip((offset * edge).sum(axis=1) / np.maximum((edge**2).sum(axis=1), 1e-300), 0.0, 1.0)
        found.append(np.linalg.norm(offset - share[:, None] * edge, axis=1))
    return np.min(found, axis=0)


def assert_follows(robot, motion, path, position):
    """The tool's way by Pinocchio stays within a distance of the path and comes past its given poses within it."""
    data, way = robot.model.createData(), []
    frame = robot.model.getFrameId(robot.tool, pin.FrameType.BODY)
    times = motion.t[:-1, None] + np.diff(motion.t)[:, None] * np.linspace(0, 1, 41)
    for q in motion(np.union1d(times.ravel(), np.linspace(0, motion.duration, 20_001))):
        pin.framesForwardKinematics(robot.model, data, q)
        way.append(data.oMf[frame].translation.copy())
    line = path(np.union1d(np.linspace(0, 1, 100_001), path.knots))[:, :3, 3]
    assert distances_from_line(np.array(way), line).max() <= position
    assert distances_from_line(path(path.knots)[:, :3, 3], np.array(way)).max() <= position


@pytest.mark.slow
@pytest.mark.parametrize("position", [1e-5, 1e-6, 3e-7])
@pytest.mark.parametrize("name", ["panda", "ur5"])
def test_small_tolerances_hold_at_corners(name, position):
    """Knots were as dense as for half of the default tolerance, and measured on chords that cut off a corner."""
    robot = mp.load_robot(name)
    q = {"panda": [0, -0.5, 0, -2.0, 0, 1.6, 0.8], "ur5": [0.3, -1.2, 1.4, -1.7, -1.5, 0]}[name]
    poses = np.tile(robot.kinematics().pose(q), (4, 1, 1))
    poses[:, :3, 3] += np.array([[0, 0, 0], [0.03, 0.12, -0.1], [0.03, 0.15, -0.02], [-0.05, 0.02, 0.0]])
    path = mp.CartesianPath.through(poses)
    plan = mp.follow(robot, path, tolerance=mp.Tolerance(position=position, rotation=1e-4))
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    assert_follows(robot, plan.trajectory, path, position)


@pytest.mark.slow
def test_a_refined_path_stays_on_its_branch_where_the_arm_is_almost_stretched():
    """The refinement moved some positions to the other posture of the elbow, from which the path between cannot be followed."""
    robot, task = mp.load_robot("so100"), mp.Task.position()
    begin = np.array([0.7076, 2.7099, -2.9054, -0.4206, -1.2687])
    end = np.array([0.715, 2.7236, -2.7308, -0.5535, -1.0387])
    poses = robot.kinematics(task).pose(begin + (end - begin) * np.linspace(0, 1, 12)[:, None])
    path = mp.CartesianPath.through(poses)
    plan = mp.follow(robot, path, objective=mp.PathObjective(task=task))
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    assert_follows(robot, plan.trajectory, path, 1e-4)


@pytest.mark.slow
def test_poses_that_no_sample_reaches_get_configurations_from_random_starts():
    """At the edge of the reach; the motion exists, as the poses are those of one."""
    robot, task = mp.load_robot("tiago"), mp.Task.position()
    kinematics = robot.kinematics(task)
    seen = []
    for seed in range(40):
        rng = np.random.default_rng(seed)
        lower, upper = np.maximum(robot.limits.lower, -3), np.minimum(robot.limits.upper, 3)
        starts = rng.uniform(lower, upper, (500, robot.n))
        direction = rng.normal(size=3)
        first = starts[np.argmax(kinematics.pose(starts)[:, :3, 3] @ direction)]
        found = minimize(
            lambda q, d=direction: -kinematics.pose(q)[:3, 3] @ d, first, bounds=list(zip(lower, upper, strict=True))
        )
        begin = np.clip(found.x + rng.normal(size=robot.n) * 0.02, lower, upper)
        q = begin + (np.clip(begin + rng.normal(size=robot.n) * 0.05, lower, upper) - begin) * np.linspace(0, 1, 6)[:, None]
        if mp.Scene().collision_model(robot).in_collision_rows(q, clearance=0.005).any():
            continue
        poses = kinematics.pose(q)
        seen.append(mp.follow(robot, mp.CartesianPath.through(poses), objective=mp.PathObjective(task=task)))
        if len(seen) == 2:
            break
    assert [each.status for each in seen] == [mp.Status.FOLLOWED] * 2


#: Positions [m] along motions of two arms at the edge of their reach.
STRETCHED = {
    "panda": [
        [-0.4874, 0.1289, -0.3903],
        [-0.4834, 0.1512, -0.3878],
        [-0.4784, 0.1734, -0.3852],
        [-0.4724, 0.1954, -0.3827],
        [-0.4653, 0.2173, -0.3802],
        [-0.4573, 0.2389, -0.3776],
        [-0.4482, 0.2602, -0.375],
        [-0.4382, 0.2811, -0.3724],
        [-0.4271, 0.3016, -0.3698],
        [-0.4151, 0.3218, -0.3671],
        [-0.4022, 0.3414, -0.3645],
        [-0.3883, 0.3605, -0.3618],
    ],
    "ur5": [
        [-0.2097, 0.7184, -0.4897],
        [-0.1907, 0.7428, -0.4663],
        [-0.1698, 0.766, -0.4421],
        [-0.1471, 0.7878, -0.4173],
        [-0.1227, 0.808, -0.3919],
        [-0.0966, 0.8267, -0.366],
        [-0.069, 0.8436, -0.3395],
        [-0.0401, 0.8586, -0.3125],
        [-0.01, 0.8716, -0.2851],
        [0.0212, 0.8825, -0.2574],
        [0.0533, 0.8914, -0.2292],
        [0.0862, 0.898, -0.2008],
    ],
}


@pytest.mark.slow
@pytest.mark.parametrize("name", STRETCHED)
def test_positions_at_the_edge_of_the_reach_are_followed(name):
    """Samples of the Panda were too far apart, and the UR5 turned its elbow over between two positions, off the path."""
    robot, task = mp.load_robot(name), mp.Task.position()
    poses = np.tile(np.eye(4), (12, 1, 1))
    poses[:, :3, 3] = STRETCHED[name]
    path = mp.CartesianPath.through(poses)
    plan = mp.follow(robot, path, objective=mp.PathObjective(task=task))
    assert plan.report.passed
    assert_follows(robot, plan.trajectory, path, 1e-4)


def test_layers_keep_their_bounds_on_steps():
    robot = mp.load_robot("ur5")
    pose = robot.kinematics().pose(np.array([0.3, -1.2, 1.4, -1.7, -1.5, 0.2]))
    ahead = pose.copy()
    ahead[2, 3] += 0.1
    layers = mp.sample_layers(robot, mp.CartesianPath.line(pose, ahead), positions=4)
    layers = replace(layers, longest=np.array([1.0, 2.0, 3.0]))
    more = layers.sampling.with_positions(layers, np.array([0.1, 0.2, 0.9]), lambda *_: None)
    assert more.longest.tolist() == [1.0, 1.0, 1.0, 2.0, 3.0, 3.0]
    assert more.part(2, 5).longest.tolist() == [1.0, 2.0, 3.0]
    assert (step_limits(more, np.full(6, 1.5))[:, 0] == [1.0, 1.0, 1.0, 1.5, 1.5, 1.5]).all()
