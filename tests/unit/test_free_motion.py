"""What tasks leave free, judged by the twist between two poses that count as the same."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.ik.solver import Solver
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import deviation_from, distances_between
from manipplan.search.program import PoseRows
from manipplan.symbolic.free_motion import NOTHING, FreeMotion

X, Y, Z = np.eye(3)
ROWS = np.eye(6)

#: Tasks by name, with the number of motions that they leave free.
TASKS = {
    "pose": (mp.Task.pose(), 0),
    "position": (mp.Task.position(), 3),
    "orientation": (mp.Task.orientation(), 3),
    "planar": (mp.Task.planar(), 4),
    "pointing": (mp.Task.pointing([0.6, 0.0, 0.8]), 1),
    "direction of the world": (mp.Task.direction([1, 2, 2]), 5),
    "any turn about the vertical": (mp.Task.custom(ROWS[[0, 1, 2, 3, 4]]), 1),
    "height": (mp.Task.custom(ROWS[[0, 1, 3, 4, 5]]), 1),
    "depth of the tool": (mp.Task.custom(ROWS[[0, 1, 3, 4, 5]], frame="tool"), 1),
    "drill": (mp.Task.custom(ROWS[[0, 1, 3, 4]], frame="tool"), 2),
    "disc": (mp.Task.custom(ROWS[[2, 3, 4]], frame="tool"), 3),
    "height and turn": (mp.Task.custom(ROWS[[0, 1, 3, 4]]), 2),
}


def random_poses(rng, count):
    poses = np.array([pin.SE3.Random().homogeneous for _ in range(count)])
    poses[:, :3, 3] = rng.uniform(-1, 1, (count, 3))
    return poses


@pytest.fixture(autouse=True)
def seeded():
    pin.seed(5)


@pytest.fixture(params=TASKS)
def case(request):
    task, count = TASKS[request.param]
    return task, FreeMotion.of(task), count


def random_values(free, rng, count):
    poses = random_poses(rng, 3)
    return np.stack([rng.choice(free.line(k, 40, np.zeros(3), 1.0, poses), count) for k in range(len(free.names))], axis=1)


def test_values_give_poses_and_poses_values(case):
    _, free, count = case
    rng = np.random.default_rng(1)
    assert len(free.names) == count == len(set(free.names))
    if not count:
        return
    poses, values = random_poses(rng, 30), random_values(free, rng, 30)
    reached = free.poses(poses, values)
    np.testing.assert_allclose(free.poses(poses, free.values(reached, poses)), reached, atol=1e-12)
    np.testing.assert_allclose(free.nearest(reached, poses), reached, atol=1e-12)
    np.testing.assert_allclose(free.values(reached, poses)[:, : len(free.shifts)], values[:, : len(free.shifts)], atol=1e-12)


def test_poses_that_count_as_the_same_have_no_distance(case):
    _, free, count = case
    rng = np.random.default_rng(2)
    poses = random_poses(rng, 30)
    reached = free.poses(poses, random_values(free, rng, 30)) if count else poses
    for distance in distances_between(reached, poses, free):
        np.testing.assert_allclose(distance, 0.0, atol=2e-8)


def test_a_small_free_motion_has_no_task_speed_and_any_other_has(case):
    """The rows of the task, applied to the twist between two nearby poses of the set, are zero: Pinocchio's log tells the twist."""
    task, free, count = case
    rng, step = np.random.default_rng(3), 1e-6
    world, tool = task.matrices
    for pose in random_poses(rng, 20):
        here = free.poses(pose[None], random_values(free, rng, 1))[0] if count else pose
        values = free.values(here[None], pose[None])
        twists = []
        for k in range(count):
            there = free.poses(pose[None], values + step * np.eye(count)[k : k + 1])[0]
            turn = pin.log3(there[:3, :3] @ here[:3, :3].T)
            twist = np.concatenate([there[:3, 3] - here[:3, 3], turn]) / step
            own = np.concatenate([here[:3, :3].T @ twist[:3], here[:3, :3].T @ twist[3:]])
            twists.append(twist)
            np.testing.assert_allclose(world @ twist, 0.0, atol=1e-5)
            np.testing.assert_allclose(tool @ own, 0.0, atol=1e-5)
        assert np.linalg.matrix_rank(np.array(twists).reshape(-1, 6), tol=1e-4) == count == 6 - task.rows


def test_a_pose_that_does_not_count_as_the_same_has_its_distance():
    still = np.eye(4)[None]
    higher, turned = still.copy(), still.copy()
    higher[0, 2, 3], turned[0, :3, :3] = 0.25, pin.exp3(0.3 * X)
    position, planar, spin = (FreeMotion.of(each) for each in (mp.Task.position(), mp.Task.planar(), mp.Task.pointing(Z)))
    assert distances_between(higher, still, position) == (pytest.approx(0.25), 0.0)
    assert distances_between(higher, still, planar) == (0.0, 0.0)
    assert distances_between(turned, still, position)[1] == 0.0
    assert distances_between(turned, still, spin)[1] == pytest.approx(0.3)
    assert distances_between(turned, still, FreeMotion.of(mp.Task.custom(ROWS[[0, 1, 2, 3, 4]])))[1] == pytest.approx(0.3)
    assert distances_between(turned, still, FreeMotion.of(mp.Task.custom(ROWS[[0, 1, 2, 4, 5]])))[1] == pytest.approx(0.0)


def test_the_deviation_from_a_path_is_that_of_what_counts(case):
    _, free, count = case
    rng = np.random.default_rng(4)
    first, last = np.eye(4), pin.SE3(pin.exp3(0.4 * Y), np.array([0.3, 0.1, -0.2])).homogeneous
    path = CartesianPath.line(first, last)
    poses = path(np.linspace(0, 1, 40))
    poses = free.poses(poses, random_values(free, rng, 40)) if count else poses
    found = deviation_from(path, poses, free)
    assert found.position < 1e-6 and found.rotation < 1e-6


@pytest.mark.parametrize(
    "name", ["pose", "position", "orientation", "pointing", "drill", "depth of the tool", "height and turn"]
)
def test_the_rows_of_the_path_program_vanish_on_the_set_only(panda, name):
    task, _ = TASKS[name]
    kinematics = panda.kinematics(task)
    free, rows = kinematics.free_motion, PoseRows(kinematics)
    rng = np.random.default_rng(6)
    q = panda.random_configuration(rng, size=20)
    reached = panda.kinematics().pose(q)
    poses = free.poses(reached, random_values(free, rng, 20)) if free.names else reached
    assert rows.count == task.rows
    np.testing.assert_allclose(rows.errors(q, poses), 0.0, atol=1e-12)
    away = panda.random_configuration(rng, size=20)
    assert (np.abs(rows.errors(away, poses)).max(axis=1) > 1e-3).all()


@pytest.mark.slow
def test_the_grid_of_a_shift_covers_where_the_tool_can_be(panda):
    """Whatever the arm reaches is inside the grid of the shifts, and no more than its size outside."""
    rng = np.random.default_rng(9)
    poses = panda.kinematics().pose(panda.random_configuration(rng, size=200))
    for name in ("height", "depth of the tool", "planar", "orientation"):
        task, _ = TASKS[name]
        solver = Solver.of(panda, task=task, held=None, method="auto", seed=0)
        for pose in poses:
            own = len(solver.names) - len(solver.free.names)
            grid = solver.grid(5, (5,), pose[None])[:, own : own + len(solver.free.shifts)]
            value = solver.free.values(pose[None], pose[None])[0, : len(solver.free.shifts)]
            assert (grid.min(axis=0) <= value).all() and (value <= grid.max(axis=0)).all()
            assert np.ptp(grid, axis=0).max() < 3.0


def test_nothing_is_free_of_a_pose():
    assert NOTHING.names == () and FreeMotion.of(mp.Task.pose()).names == ()


@pytest.mark.parametrize(
    "task",
    [
        mp.Task.rotation([0, 0, 1]),
        mp.Task.custom(ROWS[[0, 1, 2, 3]]),
        mp.Task.custom([[1, 0, 0, 0, 1, 0]]),
        mp.Task.custom(ROWS[[0, 1]], frame="tool"),
        mp.Task.custom(ROWS[[0, 3, 4]], frame="tool"),
        mp.Task.custom(ROWS[[0, 2, 3, 4]], frame="tool"),
    ],
    ids=[
        "one rotation",
        "position and one rotation",
        "a screw",
        "directions that turn with the tool",
        "one direction across the axis",
        "a wheel",
    ],
)
def test_a_task_that_fixes_no_set_of_poses_is_refused(task):
    with pytest.raises(mp.errors.InvalidInputError, match="task: "):
        FreeMotion.of(task)


@pytest.mark.parametrize(
    "name", ["position", "orientation", "planar", "pointing", "drill", "depth of the tool", "height and turn"]
)
def test_newton_steps_reach_what_counts_and_move_the_joints_little(panda, name):
    task, _ = TASKS[name]
    rng = np.random.default_rng(8)
    solver = Solver.of(panda, task=task, held=None, method="auto", seed=0)
    q = panda.random_configuration(rng, size=40)
    q += np.clip(panda.neutral - q, -0.2, 0.2)
    poses = panda.kinematics().pose(q + rng.uniform(-0.02, 0.02, q.shape))
    moved = solver.onto(q, poses)
    for distance in distances_between(panda.kinematics().pose(moved), poses, solver.free):
        assert (distance < 1e-7).mean() > 0.9  # some stop at a limit
    assert np.median(np.abs(moved - q).max(axis=1)) < 0.02


def test_newton_steps_pass_a_singularity_that_does_not_count(ur5):
    """With a straight elbow the arm cannot go up, and with a free height it need not."""
    task = mp.Task.custom(ROWS[[0, 1, 3, 4, 5]])
    solver = Solver.of(ur5, task=task, held=None, method="auto", seed=0)
    q = np.array([[0.3, -0.9, 1e-9, -0.6, -1.57, 0.2]])
    pose = ur5.kinematics().pose(q)
    pose[:, 0, 3] += 0.01
    moved = solver.onto(q, pose)
    position, rotation = distances_between(ur5.kinematics().pose(moved), pose, solver.free)
    assert position[0] < 1e-9 and rotation[0] < 1e-7 and np.abs(moved - q).max() < 0.1
