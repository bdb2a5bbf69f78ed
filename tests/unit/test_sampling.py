"""sample_layers: every candidate against Pinocchio, the same layers from every executor, and what is refused."""

import itertools
import multiprocessing
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.paths.cartesian import CartesianPath

PLANAR_START = np.array([0.3, 0.9, 0.8])


def moved(pose, by):
    """The same pose elsewhere."""
    matrix = np.array(pose)
    matrix[:3, 3] += by
    return matrix


def tool_poses(robot, q):
    """By Pinocchio alone, (k, 4, 4)."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    poses = []
    for each in q:
        pin.framesForwardKinematics(robot.model, data, each)
        poses.append(data.oMf[frame].homogeneous.copy())
    return np.array(poses)


def jacobians(robot, q):
    """Of the tool's origin in the world's axes, by Pinocchio alone, (k, 6, n)."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    return np.array([pin.computeFrameJacobian(robot.model, data, each, frame, pin.LOCAL_WORLD_ALIGNED) for each in q])


def pose_index(robot, q, length=0.5):
    """Yoshikawa's: the product of the singular values, angles times `length`."""
    weights = np.array([1.0] * 3 + [length] * 3)[:, None]
    return np.linalg.svd(weights * jacobians(robot, q), compute_uv=False).prod(axis=1)


@pytest.fixture(scope="module")
def line(panda):
    start = panda.kinematics().pose(panda.neutral)
    return CartesianPath.line(start, moved(start, [0.1, 0.2, -0.15]))


@pytest.fixture(scope="module")
def table():
    return mp.Scene(
        [
            mp.Box(size=(0.6, 0.1, 0.3), position=(0.35, 0.36, 0.75), name="shelf"),
            mp.Sphere(radius=0.08, position=(0.1, -0.4, 0.6), name="ball"),
        ]
    )


@pytest.fixture(scope="module")
def layers(panda, line, table):
    return mp.sample_layers(panda, line, 4, samples=40, scene=table)


@pytest.fixture(scope="module")
def six(tmp_path_factory):
    """Six joints, the last three meeting, in cylinders: quick to load in any process, and has a closed form."""
    joints = (("z", 0.0), ("y", 0.3), ("y", 0.4), ("z", 0.2), ("y", 0.2), ("z", 0.0))
    axes = {"z": "0 0 1", "y": "0 1 0"}
    text = '<robot name="six"><link name="l0"/>'
    for k, (axis, far) in enumerate(joints, start=1):
        size = 'radius="0.04" length="0.16"'
        shape = (
            f'<collision><origin xyz="0 0 0.1"/><geometry><cylinder {size}/></geometry></collision>' if k in (2, 3, 6) else ""
        )
        text += (
            f'<link name="l{k}">{shape}</link><joint name="j{k}" type="revolute"><parent link="l{k - 1}"/><child link="l{k}"/>'
            f'<origin xyz="0 0 {far}"/><axis xyz="{axes[axis]}"/>'
            '<limit lower="-2.9" upper="2.9" velocity="2" effort="50"/></joint>'
        )
    text += '<link name="tip"/><joint name="end" type="fixed"><parent link="l6"/><child link="tip"/><origin xyz="0 0 0.25"/></joint>'
    file = tmp_path_factory.mktemp("six") / "six.urdf"
    file.write_text(text + "</robot>")
    return mp.load_robot(str(file), tool="tip")


SIX = np.array([0.2, 0.5, 1.0, 0.3, 0.6, 0.1])


def six_layers(six, **options):
    start = np.array(six.kinematics().pose(SIX))
    scene = mp.Scene([mp.Sphere(radius=0.15, position=start[:3, 3] + [0.1, 0.25, 0.0], name="ball")])
    path = CartesianPath.line(start, moved(start, [-0.1, 0.1, 0.0]))
    return mp.sample_layers(six, path, **{"positions": 6, "task": mp.Task.pointing(), "samples": 60, "scene": scene, **options})


def assert_same_layers(one, other):
    assert one.count > 0
    assert all(np.array_equal(a, b) for a, b in zip(one.q, other.q, strict=True))
    assert all(np.array_equal(a, b) for a, b in zip(one.m, other.m, strict=True))
    np.testing.assert_array_equal(one.poses, other.poses)


def rows(array):
    return {tuple(row) for row in array}


# ---- what a candidate is


def test_every_candidate_is_what_it_says(panda, line, table, layers):
    assert len(layers.q) == 4
    assert layers.considered == 4 * 40
    np.testing.assert_allclose(layers.s, [0, 1 / 3, 2 / 3, 1])
    np.testing.assert_allclose(layers.poses, line(layers.s), atol=0)
    assert layers.count > 40
    for pose, q, m in zip(layers.poses, layers.q, layers.m, strict=True):
        assert np.abs(tool_poses(panda, q) - pose).max() < 1e-10
        assert not panda.limits.outside(q).any()
        np.testing.assert_allclose(m, pose_index(panda, q), rtol=1e-9, atol=1e-14)
        assert not table.in_collision(panda, q).any()


def test_without_collisions_exactly_those_that_touch_come_back(panda, line, table, layers):
    every = mp.sample_layers(panda, line, 4, samples=40, scene=table, collisions=False)
    dropped = 0
    for all_q, q in zip(every.q, layers.q, strict=True):
        free = all_q[~table.in_collision(panda, all_q)]
        assert rows(free) == rows(q)
        dropped += len(all_q) - len(q)
    assert dropped > 20


def test_clearance_drops_exactly_what_is_nearer(panda, line, table, layers):
    kept = mp.sample_layers(panda, line, 4, samples=40, scene=table, clearance=0.02)
    model = table.collision_model(panda)
    for q, far in zip(layers.q, kept.q, strict=True):
        distances = np.array([model.distances(each).min() for each in q])
        assert rows(far) == rows(q[distances >= 0.02])
    assert kept.count < layers.count


def test_a_pointing_tool_turns_about_its_axis_alone(panda, line):
    axis = np.array([0.0, 0.6, 0.8])
    layers = mp.sample_layers(panda, line, 2, task=mp.Task.pointing(axis), samples=(12, 8), collisions=False)
    basis = np.linalg.svd(axis[None])[2][1:]
    turns = []
    for pose, q, m in zip(layers.poses, layers.q, layers.m, strict=True):
        reached = tool_poses(panda, q)
        assert np.abs(reached[:, :3, 3] - pose[:3, 3]).max() < 1e-10
        assert np.abs(reached[:, :3, :3] @ axis - pose[:3, :3] @ axis).max() < 1e-10
        turns.append(np.linalg.norm(reached[:, :3, :3] - pose[:3, :3], axis=(1, 2)))
        jacobian = jacobians(panda, q)
        across = basis @ np.swapaxes(reached[:, :3, :3], 1, 2) @ jacobian[:, 3:]
        matrix = np.concatenate([jacobian[:, :3], 0.5 * across], axis=1)
        np.testing.assert_allclose(m, np.linalg.svd(matrix, compute_uv=False).prod(axis=1), rtol=1e-9, atol=1e-14)
    assert len(np.unique(np.concatenate(turns).round(6))) >= 5  # of eight turns, ± alike


def test_a_closed_path_does_not_repeat_its_first_position(six):
    start = six.kinematics().pose(SIX)
    circle = CartesianPath.circle(start, moved(start, [-0.1, 0, 0])[:3, 3], [0, 0, 1])
    layers = mp.sample_layers(six, circle, 5, closed=True, collisions=False)
    assert layers.closed
    np.testing.assert_allclose(layers.s, [0, 0.2, 0.4, 0.6, 0.8])
    np.testing.assert_allclose(np.linalg.norm(np.diff(layers.poses[:, :3, 3], axis=0), axis=1), 0.2 * np.sin(np.pi / 5))
    arc = CartesianPath.circle(start, moved(start, [-0.1, 0, 0])[:3, 3], [0, 0, 1], 6.0)
    with pytest.raises(mp.errors.InvalidInputError, match="closed: .*the path's last pose is not its first"):
        mp.sample_layers(six, arc, 5, closed=True)


def test_another_measure_is_the_candidates_index(six):
    layers = six_layers(six, measure="frobenius", samples=6, task=None, positions=2)
    weights = np.array([1.0] * 3 + [0.5] * 3)[:, None]
    norm = np.linalg.norm(weights * jacobians(six, layers.q[1]), axis=(1, 2))
    np.testing.assert_allclose(layers.m[1], norm, rtol=1e-9)


# ---- who does the work


@pytest.mark.slow
def test_a_pool_of_processes_gives_the_assert_same_layers(six):
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        elsewhere = six_layers(six, executor=pool)
    assert_same_layers(six_layers(six), elsewhere)


@pytest.mark.slow
def test_a_dask_cluster_gives_the_assert_same_layers(six):
    import distributed

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        client.wait_for_workers(2)
        elsewhere = six_layers(six, executor=client.get_executor())
        workers = client.run(lambda: None)
    assert len(workers) == 2
    assert_same_layers(six_layers(six), elsewhere)


def test_one_thread_or_many_give_the_assert_same_layers(panda, line, table, layers):
    with ThreadPoolExecutor(1) as one:
        assert_same_layers(layers, mp.sample_layers(panda, line, 4, samples=40, scene=table, executor=one))


def test_progress_never_falls_and_ends_at_one(six):
    told = []
    layers = six_layers(six, progress=lambda share, text: told.append((share, text)))
    shares = [share for share, _ in told]
    assert shares == sorted(shares) and 0 < shares[0] < 1 and shares[-1] == 1.0
    assert len(told) == 6
    assert f"{layers.count:,} candidates" in told[-1][1]


class Interrupted(Executor):
    """An executor whose third job meets Ctrl-C."""

    def __init__(self):
        self.jobs = []

    def submit(self, function, *arguments):
        future = Future()
        self.jobs.append(future)
        if len(self.jobs) < 3:
            future.set_result(function(*arguments))
        elif len(self.jobs) == 3:
            future.set_exception(KeyboardInterrupt())
        return future


def test_an_interrupt_ends_sampling_and_cancels_what_waits(six):
    executor = Interrupted()
    with pytest.raises(KeyboardInterrupt):
        six_layers(six, executor=executor)
    assert len(executor.jobs) == 6
    assert all(job.cancelled() for job in executor.jobs[3:])


@pytest.mark.slow
def test_an_interrupt_between_positions_is_not_swallowed(panda, line):
    """Ctrl-C in the main thread, as it tells of the first position: no work is done for most of the other positions."""

    def interrupt(share, text):
        raise KeyboardInterrupt

    began = time.process_time()
    mp.sample_layers(panda, line, 60, samples=20_000, collisions=False)  # reads or compiles the kernels, too
    whole = time.process_time() - began
    began = time.process_time()
    with pytest.raises(KeyboardInterrupt):
        mp.sample_layers(panda, line, 60, samples=20_000, collisions=False, progress=interrupt)
    assert time.process_time() - began < whole / 3


# ---- what is refused


def test_memory_is_refused_before_work_starts(six):
    told = []
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"samples: got '60 at each of 6 positions'.*need .* GB.*allows 1.3e-05 GB"
    ):
        six_layers(six, memory=13_000.0, progress=lambda share, text: told.append(share))
    assert told == []
    assert 13_000 < six_layers(six, memory=1e6).nbytes < 1e6


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"samples": 10**12}, "samples: got 1000000000000; allowed: fewer"),
        ({"positions": 10**12}, "positions: got 1000000000000; allowed: a whole number, at least 2, at most 100000"),
    ],
)
def test_a_grid_larger_than_memory_is_refused_before_it_is_made(panda, line, change, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.sample_layers(panda, line, **{"positions": 3, **change})


@pytest.mark.slow
def test_a_position_out_of_reach_is_named_with_the_distance(planar):
    """The arm is three metres long; the last position lies half a metre further."""
    start = planar.kinematics().pose(PLANAR_START)
    end = np.eye(4)
    end[:3, 3] = [3.5, 0.0, start[2, 3]]
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"path, position 3 of 0 to 3 \(s = 1\): .*stays 500 mm and"
    ) as caught:
        mp.sample_layers(planar, CartesianPath.line(start, end), 4, samples=8, task=mp.Task.planar())
    assert "within reach" in caught.value.allowed


@pytest.mark.slow
def test_a_pose_between_the_samples_is_told_as_reachable(planar):
    """Stretched out, only one tool rotation reaches; a grid of seven passes it by."""
    start = planar.kinematics().pose([0.1, 0.0, 0.0])
    end = planar.kinematics().pose([0.2, 0.0, 0.0])
    with pytest.raises(
        mp.errors.InvalidInputError, match="within reach, but no value on the grid reaches it; take more samples"
    ):
        mp.sample_layers(planar, CartesianPath.line(start, end), 2, samples=7, task=mp.Task.planar(), collisions=False)


@pytest.mark.slow
def test_random_starts_reach_a_pose_between_the_default_samples(planar):
    start, end = (planar.kinematics().pose([angle, 0.0, 0.0]) for angle in (0.1234, 0.2))
    layers = mp.sample_layers(planar, CartesianPath.line(start, end), [0.0, 1.0], task=mp.Task.planar(), collisions=False)
    for q, pose in zip(layers.q, (start, end), strict=True):
        reached = planar.kinematics().pose(q)[:, :2, 3]
        np.testing.assert_allclose(reached, np.tile(pose[:2, 3], (len(q), 1)), atol=1e-8)


@pytest.mark.slow
def test_positions_inside_an_obstacle_are_told(planar):
    start = planar.kinematics().pose(PLANAR_START)
    ball = mp.Scene([mp.Sphere(radius=0.2, position=start[:3, 3], name="ball")])
    path = CartesianPath.line(start, moved(start, [0.0, 0.05, 0.0]))
    with pytest.raises(
        mp.errors.InvalidInputError,
        match=r"\d+ reach it, and in the best of them link3_0 and ball overlap by \d+ mm; needed: no collision",
    ):
        mp.sample_layers(planar, path, 2, samples=6, scene=ball)
    near = mp.Scene([mp.Sphere(radius=0.2, position=start[:3, 3] + [0, 0, 0.4], name="ball")])
    with pytest.raises(mp.errors.InvalidInputError, match=r"link3_0 and ball are \d+ mm apart; needed: clearance 300 mm"):
        mp.sample_layers(planar, path, 2, samples=6, scene=near, clearance=0.3)


class Broken(CartesianPath):
    """A user's own path with a NaN at its second position."""

    def __init__(self, pose):
        self.pose = pose

    def _at(self, s):
        positions = np.tile(self.pose[:3, 3], (len(s), 1))
        positions[(s > 0.3) & (s < 0.7)] = np.nan
        return positions, np.tile(self.pose[:3, :3], (len(s), 1, 1))


def test_a_pose_with_nan_is_refused(planar):
    pose = np.array(planar.kinematics().pose(PLANAR_START))
    with pytest.raises(mp.errors.InvalidInputError, match="path, position 1 of 0 to 2.*finite numbers"):
        mp.sample_layers(planar, Broken(pose), 3, samples=10)
    pose[0, 3] = np.nan
    with pytest.raises(mp.errors.InvalidInputError, match="finite"):
        CartesianPath.line(pose, np.eye(4))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"robot": "panda"}, "robot: got 'panda'"),
        ({"path": np.eye(4)}, "path: .*a CartesianPath"),
        ({"positions": 1}, "positions: got 1; allowed: .*at least 2"),
        ({"positions": 2.0}, "positions: got 2.0"),
        ({"positions": "many"}, "positions: got 'many'"),
        ({"positions": True}, "positions: got True"),
        ({"samples": 0}, "samples: got 0"),
        ({"samples": (3, 3)}, r"samples: got \(3, 3\)"),
        ({"samples": "fine"}, "samples: got 'fine'"),
        ({"samples": -4}, "samples: got -4"),
        ({"clearance": -0.1}, "clearance: got -0.1"),
        ({"clearance": np.nan}, "clearance: got nan"),
        ({"clearance": None}, "clearance: got None"),
        ({"memory": 0}, "memory: got 0"),
        ({"memory": "1 GB"}, "memory: got '1 GB'"),
        ({"closed": "yes"}, "closed: got 'yes'"),
        ({"collisions": None}, "collisions: got None"),
        ({"scene": "scene.yaml"}, "scene: got 'scene.yaml'"),
        ({"seed": -1}, "seed: got -1"),
        ({"task": "pose"}, "task: got 'pose'"),
        ({"task": mp.Task.rotation([0, 0, 1])}, "task: got 'rotation'"),
        ({"measure": "yoshikava"}, "did you mean yoshikawa"),
        ({"method": "magic"}, "method: got 'magic'"),
        ({"held": ["elbow"]}, "held"),
        ({"executor": "dask"}, "executor: got 'dask'"),
        ({"progress": 5}, "progress: got 5"),
    ],
)
def test_wrong_arguments(panda, line, change, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.sample_layers(**{"robot": panda, "path": line, "positions": 2, "samples": 4, "collisions": False, **change})


@pytest.mark.parametrize(
    ("epsilon", "message"), [(0, "above zero"), (-1.0, "above zero"), ([0.1, 0.1], "7 of them"), ("a", "real")]
)
def test_epsilon_is_checked(layers, epsilon, message):
    with pytest.raises(mp.errors.InvalidInputError, match=f"epsilon: .*{message}"):
        mp.max_min_search(layers, epsilon)


def test_the_search_over_samples_equals_all_pairs(six):
    """From sampling to the optimum, by brute force."""
    layers = six_layers(six, samples=24)
    best = dict(enumerate(layers.m[0]))
    for (before, q), m in zip(itertools.pairwise(layers.q), layers.m[1:], strict=True):
        near = (np.abs(q[:, None] - before[None]) < 0.5).all(axis=2)
        best = {k: min(m[k], max((best[j] for j in np.flatnonzero(near[k])), default=-np.inf)) for k in range(len(q))}
    assert mp.max_min_search(layers, 0.5).minimum == max(best.values()) > 0


@pytest.mark.slow
@pytest.mark.parametrize(("name", "task"), [("panda", None), ("xarm7", None), ("ur5", mp.Task.pointing([0, 0, 1]))])
def test_branches_are_sampled_as_closely_as_the_spacing_says(name, task):
    """Each solution has one at the next value of the parameter nearby, unless the values are as close as they may be."""
    robot, spacing, samples = mp.load_robot(name), 0.2, 90
    if name == "ur5":
        robot = robot.with_limits(lower=-np.pi, upper=np.pi)
    rng = np.random.default_rng(3)
    q = robot.random_configuration(rng, size=2)
    path = CartesianPath.line(*tool_poses(robot, q))
    options = {"task": task, "samples": samples, "collisions": False}
    grid, closely = (mp.sample_layers(robot, path, [0.0, 1.0], **options, spacing=each) for each in (None, spacing))
    solver, finest = closely.sampler.solver, 4 * np.pi / samples / 64
    left = 0
    for few, many, pose in zip(grid.q, closely.q, closely.poses, strict=True):
        assert len(many) >= len(few) and {tuple(each) for each in few.round(9)} <= {tuple(each) for each in many.round(9)}
        values = solver.parameters_of(many, np.tile(pose, (len(many), 1, 1)))[:, 0]
        values = np.where(values > np.pi - 1e-9, values - 2 * np.pi, values) if task else values
        for a, b in itertools.pairwise(np.unique(values.round(9))):
            own, following = (many[np.abs(values - each) < 2e-9] for each in (a, b))
            apart = np.abs(own[:, None] - following[None])
            apart = np.abs(apart - 2 * np.pi * np.round(apart / (2 * np.pi))).max(axis=2)
            is_close = max(apart.min(axis=1).max(), apart.min(axis=0).max()) < spacing + 1e-9
            if not is_close and b - a > finest:
                between = solver.solve_once(pose[None], np.zeros(1, dtype=np.int64), np.array([[(a + b) / 2]]))
                assert not len(between.q)  # a range without solutions
            left += not is_close
        assert len(many) > len(few) or not left


def test_a_spacing_that_is_no_distance_is_refused():
    robot = mp.load_robot("panda")
    path = CartesianPath.line(*tool_poses(robot, np.array([robot.neutral, robot.neutral + 0.1])))
    for value in (0.0, -1.0, np.nan, [0.1] * 3, "fine"):
        with pytest.raises(mp.errors.InvalidInputError, match="^spacing: got"):
            mp.sample_layers(robot, path, 3, spacing=value)


def test_candidates_of_a_ur5_are_searched_in_one_turn():
    """Five of its joints turn by ±360°, its elbow by ±180°."""
    ur5 = mp.load_robot("ur5")
    begin = ur5.kinematics(mp.Task.pose()).pose(np.array([0.3, -1.2, 1.4, -0.5, 1.0, 0.2]))
    end = begin.copy()
    end[:3, 3] += [0.0, 0.1, -0.1]
    path = mp.CartesianPath.through([begin, end])
    layers = mp.sample_layers(ur5, path, 12, task=mp.Task.pointing([0, 0, 1]), samples=24)
    assert layers.count == 32 * layers.in_one_turn.count
    found, wanted = (mp.max_min_search(each, 0.3) for each in (layers, replace(layers, turn_middles=None)))
    assert found.minimum == wanted.minimum and found.length == pytest.approx(wanted.length)
    assert all((layers.q[k][i] == q).all() for k, (i, q) in enumerate(zip(found.indices, found.q, strict=True)))
    assert (np.abs(found.q) <= np.deg2rad(181)).all(), "the middle turns"
    assert mp.sample_layers(mp.load_robot("panda"), path, 2, samples=24, collisions=False).turn_middles is None
