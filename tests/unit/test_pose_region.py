"""Regions about each pose, `Task.within`: their coordinates, the rows of the path program, the checks and motions of `follow`."""

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.paths.deviation import beyond_polygon, deviations, distances_between, distances_from
from manipplan.search.program import PoseRows
from manipplan.symbolic.free_motion import FreeMotion

POSITIONS = st.sampled_from([0.0, 0.005, (0.0, 0.0, 0.03), (0.1, 0.02, 0.0), 0.2])
ROTATIONS = st.sampled_from([0.0, 0.05, (0.0, 0.0, 0.5), (0.3, 0.0, 1.0), (0.0, 0.0, np.pi), 2.0, np.pi])
AXES = st.sampled_from([(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.6, 0.0, -0.8)])


@st.composite
def regions(draw):
    """A task within a box or a cone."""
    position = draw(POSITIONS)
    if draw(st.booleans()):
        cone, spin = draw(st.sampled_from([0.05, 0.4, 1.5, 2.9])), draw(st.sampled_from([0.1, 2.0, np.pi]))
        return mp.Task.pose().within(position=position, cone=cone, spin=spin, axis=draw(AXES))
    rotation = draw(ROTATIONS)
    frame = draw(st.sampled_from(["tool", "world"]))
    return mp.Task.pose().within(position=position, rotation=rotation if rotation else 0.1, frame=frame)


def random_poses(rng, count):
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, :3, :3] = Rotation.random(count, rng).as_matrix()
    poses[:, :3, 3] = rng.uniform(-1, 1, (count, 3))
    return poses


def excess(region, pose, reached):
    """By how much a tool pose exceeds a region about a pose [m], [rad], by its definition."""
    moved = reached[:3, 3] - pose[:3, 3]
    turned = reached[:3, :3] @ pose[:3, :3].T
    if region.frame == "tool":
        moved, turned = pose[:3, :3].T @ moved, pose[:3, :3].T @ reached[:3, :3]
    beyond = np.linalg.norm(np.maximum(np.abs(moved) - region.position, 0.0))
    if region.cone is None:
        vector = Rotation.from_matrix(turned).as_rotvec()
        return beyond, np.linalg.norm(np.maximum(np.abs(vector) - region.rotation, 0.0))
    axis = np.array(region.axis)
    tilt = np.arctan2(np.linalg.norm(np.cross(axis, turned @ axis)), axis @ turned @ axis)
    # a turn about the axis, then the smallest rotation that tilts it
    across = np.cross(axis, turned @ axis)
    lean = Rotation.from_rotvec(tilt * across / max(np.linalg.norm(across), 1e-12))
    spin = abs((lean.inv() * Rotation.from_matrix(turned)).as_rotvec() @ axis)
    return beyond, max(tilt - region.cone, spin - region.spin, 0.0)


@pytest.mark.slow
@settings(max_examples=60)
@given(regions(), st.integers(0, 2**31))
def test_values_give_poses_inside_and_poses_values(task, seed):
    free, rng = FreeMotion.of(task), np.random.default_rng(seed)
    poses = random_poses(rng, 8)
    values = rng.uniform(-1, 1, (8, len(free.names))) * free.bounds * 0.69
    reached = free.poses(poses, values)
    for pose, there in zip(poses, reached, strict=True):
        np.testing.assert_allclose(excess(task.region, pose, there), 0.0, atol=1e-9)
    again = free.poses(poses, free.values(reached, poses))
    np.testing.assert_allclose(again, reached, atol=1e-9)
    np.testing.assert_allclose(free.nearest(reached, poses), reached, atol=1e-9)
    np.testing.assert_allclose(distances_between(reached, poses, free), 0.0, atol=1e-7)


@pytest.mark.slow
@settings(max_examples=60)
@given(regions(), st.integers(0, 2**31))
def test_a_pose_outside_has_a_distance_and_its_nearest_is_inside(task, seed):
    free, rng = FreeMotion.of(task), np.random.default_rng(seed)
    poses, reached = random_poses(rng, 20), random_poses(rng, 20)
    nearest = free.nearest(reached, poses)
    position, rotation = distances_between(reached, poses, free)
    for k in range(20):
        beyond, angle = excess(task.region, poses[k], reached[k])
        np.testing.assert_allclose(excess(task.region, poses[k], nearest[k]), 0.0, atol=1e-7)
        assert position[k] == pytest.approx(beyond, abs=1e-9)
        assert (rotation[k] > 1e-6) == (angle > 1e-6)


@settings(max_examples=40)
@given(regions(), st.integers(0, 2**31))
def test_samples_are_spread_over_the_region(task, seed):
    free, count = FreeMotion.of(task), 64
    values = free.spread(count)
    assert values.shape == (count, len(free.bounds))
    assert (np.abs(values) <= free.bounds + 1e-12).all()
    assert len(np.unique(values, axis=0)) > count / 2
    # every half of each value has its share of the samples
    assert (np.abs((values > 0).mean(axis=0) - 0.5) < 0.2).all()


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(regions(), st.integers(0, 2**31))
def test_the_rows_of_the_path_program_are_inside_their_box_inside_the_region_only(panda, task, seed):
    kinematics, rng = panda.kinematics(task), np.random.default_rng(seed)
    rows, free = PoseRows(kinematics), kinematics.free_motion
    q = panda.random_configuration(rng, size=12)
    reached = kinematics.pose(q)
    # poses around the reached ones: near the boundary, inside and outside
    poses = free.poses(reached, rng.uniform(-1, 1, (12, len(free.names))) * free.bounds * rng.choice([0.3, 0.9, 1.0], (12, 1)))
    poses[6:, :3, 3] += rng.normal(0, 0.01, (6, 3))
    box, errors = rows.box(None), rows.errors(q, poses)
    for k in range(12):
        amount = max(excess(task.region, poses[k], reached[k]))
        inside = (np.abs(errors[k]) <= box + 1e-9).all()
        if amount > 1e-6 or amount == 0.0:
            assert inside == (amount == 0.0) or abs(amount) < 1e-6
    tolerance = mp.Tolerance(position=1e-3, rotation=1e-2)
    assert (rows.box(tolerance) >= box).all()


@pytest.mark.slow
def test_a_path_within_the_region_has_no_distance_from_either_end():
    task = mp.Task.pose().within(position=(0.02, 0.0, 0.01), rotation=(0.0, 0.3, 0.0))
    free, rng = FreeMotion.of(task), np.random.default_rng(3)
    path = mp.CartesianPath.through([*random_poses(rng, 1), *random_poses(rng, 2)])
    s = np.sort(rng.uniform(0, 1, 700))
    s[[0, -1]] = 0.0, 1.0
    share = np.stack([np.sin(5 * s), np.cos(3 * s), np.sin(2 * s)], axis=1)
    reached = free.poses(path(s), 0.999 * share * free.bounds)
    position, rotation = deviations(path, reached, free)
    assert position.max() < 1e-5 and rotation.max() < 1e-5
    outside = reached.copy()
    outside[100, :3, 3] += 0.01 * outside[100, :3, 1]
    worse = deviations(path, outside, free)[0]
    assert worse[100] > 1e-3 and np.delete(worse, 100).max() < 1e-5
    # from where the tool comes past: the region is about the pose of the path
    missed = distances_from(reached, path(s[5:-5]), free, is_reached=True)
    assert missed[0].max() < 5e-3 and missed[0].max() < distances_from(reached, path(s[5:-5]))[0].max()
    assert max(each.max() for each in beyond_polygon(path.given, reached, free)) < 1e-5


def judged(robot, plan, region, path):
    """Whether the tool passes within the region about each pose of the path in order, by Pinocchio: [] or where it does not."""
    model, data, frame = robot.model, robot.model.createData(), robot.model.getFrameId(robot.tool)
    poses, k, missed = path(np.linspace(0, 1, 8001)), 0, []
    for time in np.linspace(0, plan.trajectory.duration, 500):
        pin.framesForwardKinematics(model, data, plan.trajectory(time))
        reached = data.oMf[frame].homogeneous
        # the first pose, from the one before on, about which the region holds the tool
        moved = reached[:3, 3] - poses[k:, :3, 3]
        if region.frame == "tool":
            moved = np.einsum("kji,kj->ki", poses[k:, :3, :3], moved)
        near = k + np.flatnonzero(np.linalg.norm(np.maximum(np.abs(moved) - region.position, 0.0), axis=1) <= 1.3e-4)
        ahead = (j for j in near if max(np.divide(excess(region, poses[j], reached), (1.3e-4, 1.2e-3))) <= 1)
        k = next(ahead, -1)
        if k < 0:
            return [time]
    ends = ((0, plan.trajectory(0.0)), (-1, plan.trajectory(plan.trajectory.duration)))
    for end, q in ends:
        pin.framesForwardKinematics(model, data, q)
        if max(np.divide(excess(region, poses[end], data.oMf[frame].homogeneous), (1e-4, 1e-3))) > 1:
            missed.append(end)
    return missed


REGIONS = {
    "box": {"position": 0.01, "rotation": 0.1},
    "box of the world": {"position": (0.0, 0.0, 0.03), "frame": "world"},
    "cone": {"cone": 0.3},
    "cone of little spin": {"cone": 0.2, "spin": 0.1, "position": (0.0, 0.0, 0.01)},
}


@pytest.fixture(scope="module", params=["panda", "ur5"])
def followed(request):
    """A robot, a path, and the motion that follows it exactly."""
    arm = request.param
    robot = request.getfixturevalue(arm)
    robot = robot.with_limits(lower=-np.pi, upper=np.pi) if arm == "ur5" else robot
    q = np.array([0, -0.5, 0, -2.2, 0, 1.8, 0.7] if arm == "panda" else [0.2, -1.4, 1.9, -2.0, -1.5, 0.3])
    poses = np.repeat(robot.kinematics().pose(q)[None], 3, axis=0)
    poses[:, :3, 3] += [[0, 0, 0], [0.1, 0.05, 0.0], [0.15, -0.05, 0.04]]
    path = mp.CartesianPath.through(poses)
    return robot, path, mp.follow(robot, path)


@pytest.mark.slow
@pytest.mark.parametrize("name", REGIONS)
def test_follow_uses_the_region_and_stays_inside(followed, name):
    robot, path, exact = followed
    task = mp.Task.pose().within(**REGIONS[name])
    plan = mp.follow(robot, path, objective=mp.PathObjective(task=task))
    assert plan.status is mp.Status.FOLLOWED
    assert plan.report.min_manipulability > 1.002 * exact.report.min_manipulability
    assert judged(robot, plan, task.region, path) == []
    assert judged(robot, exact, task.region, path) == []
    found = mp.check(robot, plan.trajectory, path=path, objective=mp.PathObjective(task=task))
    assert found.passed
    assert not mp.check(robot, plan.trajectory, path=path).passed  # it is off the poses themselves


@pytest.mark.slow
def test_a_region_reaches_what_the_pose_does_not(panda):
    """A path up to 1 cm beyond the arm's reach, with 3 cm to spare that way."""
    begin = panda.kinematics().pose(np.array([0.0, 0.8, 0.0, -0.4, 0.0, 1.2, 0.78]))
    while len(mp.inverse_kinematics(panda, begin).q):
        begin[0, 3] += 0.01
    end = begin.copy()
    end[1, 3] += 0.1
    path = mp.CartesianPath.line(begin, end)
    with pytest.raises(mp.errors.OutOfReachError):
        mp.follow(panda, path)
    task = mp.Task.pose().within(position=(0.03, 0.0, 0.0), frame="world")
    plan = mp.follow(panda, path, objective=mp.PathObjective(task=task))
    assert plan.report.passed and judged(panda, plan, task.region, path) == []


@pytest.mark.slow
def test_inverse_kinematics_samples_the_region(ur5):
    pose = ur5.kinematics().pose(np.array([0.2, -1.4, 1.9, -2.0, -1.5, 0.3]))
    task = mp.Task.pose().within(cone=0.4, spin=0.2)
    found = mp.inverse_kinematics(ur5, pose, task=task, samples=30)
    assert len(found.q) > 5 * len(mp.inverse_kinematics(ur5, pose).q)
    for q in found.q[::7]:
        np.testing.assert_allclose(excess(task.region, pose, ur5.kinematics().pose(q)), 0.0, atol=1e-8)


@pytest.mark.slow
def test_bounds_of_a_free_row(panda):
    """The manipulability is that of five rows; the sixth may turn by half a radian, not freely."""
    poses = np.repeat(panda.kinematics().pose(np.array([0, -0.5, 0, -2.2, 0, 1.8, 0.7]))[None], 2, axis=0)
    poses[1, :3, 3] += [0.1, 0.1, 0.0]
    task = mp.Task.pointing().within(rotation=(0.0, 0.0, 0.5))
    plan = mp.follow(panda, mp.CartesianPath.through(poses), objective=mp.PathObjective(task=task))
    assert plan.result.task == task and task.rows == 5
    assert plan.report.passed


@pytest.mark.parametrize(
    ("arguments", "argument"),
    [
        ({}, "region"),
        ({"position": -0.1}, "position"),
        ({"position": [0.1, 0.1]}, "position"),
        ({"rotation": 4.0}, "rotation"),
        ({"rotation": [0.0, np.nan, 0.1]}, "rotation"),
        ({"cone": 0.0}, "cone"),
        ({"cone": 0.1, "rotation": 0.1}, "rotation"),
        ({"cone": 0.1, "spin": 4.0}, "spin"),
        ({"position": 0.1, "spin": 1.0}, "spin"),
        ({"cone": 0.1, "axis": [0, 0, 0]}, "axis"),
        ({"cone": 0.1, "frame": "base"}, "frame"),
        ({"position": 0.1, "frame": None}, "frame"),
        ({"position": "wide"}, "position"),
    ],
)
def test_wrong_regions(arguments, argument):
    with pytest.raises(mp.errors.InvalidInputError, match=argument):
        mp.Task.pose().within(**arguments)


@pytest.mark.slow
def test_what_cannot_use_a_region_says_so(panda):
    so100 = mp.load_robot("so100")
    task = mp.Task.pose().within(cone=0.2)
    with pytest.raises(mp.errors.InvalidInputError, match="region"):
        mp.Controller(panda, mp.formulations.General(), dt=0.01, task=task)
    motion = mp.plan(panda, panda.neutral, panda.neutral + 0.1).trajectory
    with pytest.raises(mp.errors.InvalidInputError, match="region"):
        mp.improve(panda, motion, tolerance=mp.Tolerance(position=0.01), objective=mp.PathObjective(task=task))
    poses = np.repeat(so100.kinematics().pose(so100.neutral)[None], 2, axis=0)
    poses[1, :3, 3] += 0.01
    with pytest.raises(mp.errors.InvalidInputError, match="region"):
        mp.follow(
            so100,
            mp.CartesianPath.through(poses),
            objective=mp.PathObjective(task=mp.Task.position().within(position=0.01)),
        )


@pytest.mark.slow
def test_a_plan_with_a_region_is_saved_and_read(panda, tmp_path):
    poses = np.repeat(panda.kinematics().pose(np.array([0, -0.5, 0, -2.2, 0, 1.8, 0.7]))[None], 2, axis=0)
    poses[1, :3, 3] += [0.1, 0.1, 0.0]
    task = mp.Task.pose().within(cone=0.2, spin=0.5, position=(0.0, 0.0, 0.01))
    plan = mp.follow(panda, mp.CartesianPath.through(poses), objective=mp.PathObjective(task=task))
    plan.save(tmp_path / "plan")
    again = mp.Plan.load(tmp_path / "plan")
    assert again.result.task == task


@pytest.mark.slow
def test_a_planar_arm_turns_within_its_region(planar):
    start = planar.kinematics().pose(planar.neutral + 0.4)
    end = start.copy()
    end[1, 3] += 0.2
    path = mp.CartesianPath.line(start, end)
    task = planar.default_task.within(rotation=0.3)
    plan = mp.follow(planar, path, objective=mp.PathObjective(task=task))
    assert plan.report.passed and judged(planar, plan, task.region, path) == []
    with pytest.raises(mp.errors.InvalidInputError, match="no cone, for a planar arm"):
        mp.follow(planar, path, objective=mp.PathObjective(task=planar.default_task.within(cone=0.1)))
