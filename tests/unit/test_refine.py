"""refine: never worse, every constraint checked anew, and how much it raises what coarse samples hold."""

from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.paths.cartesian import CartesianPath
from manipplan.search.program import _extremes, full_turns


def moved(pose, by):
    matrix = np.array(pose)
    matrix[:3, 3] += by
    return matrix


def tool(robot, q):
    """Pose (4, 4) and Jacobian (6, n) of the tool's origin in the world's axes, by Pinocchio alone."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    jacobian = pin.computeFrameJacobian(robot.model, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
    pin.framesForwardKinematics(robot.model, data, q)
    return data.oMf[frame].homogeneous.copy(), jacobian


def pose_index(robot, q):
    weights = np.array([1.0] * 3 + [0.5] * 3)[:, None]
    return np.linalg.svd(weights * tool(robot, q)[1], compute_uv=False).prod()


def steps(q, layers):
    d = np.diff(np.vstack([q, q[:1]]) if layers.closed else q, axis=0)
    return np.where(layers.continuous, (d + np.pi) % (2 * np.pi) - np.pi, d)


def assert_sound(robot, layers, found, result, position=1e-9, rotation=1e-9, index=pose_index):
    """Every promise of a refinement, without the package's own means but the collision model."""
    assert result.q.shape == (len(layers.q), robot.n)
    for q, target in zip(result.q, layers.poses, strict=True):
        reached = tool(robot, q)[0]
        assert np.linalg.norm(reached[:3, 3] - target[:3, 3]) <= position
        assert np.linalg.norm(pin.log3(target[:3, :3].T @ reached[:3, :3])) <= rotation
    assert (robot.limits.lower <= result.q).all() and (result.q <= robot.limits.upper).all()
    assert (np.abs(steps(result.q, layers)) < found.epsilon).all()
    if layers.sampler.spec.collisions:
        model = layers.sampler.spec.scene.collision_model(robot)
        assert not any(model.in_collision(q, clearance=layers.sampler.spec.clearance) for q in result.q)
    values = np.array([index(robot, q) for q in result.q])
    np.testing.assert_allclose(result.manipulability, values, rtol=1e-9)
    assert result.refined == pytest.approx(values.min(), rel=1e-9)
    assert result.length == pytest.approx(np.linalg.norm(steps(result.q, layers), axis=1).sum(), rel=1e-12)
    assert result.discrete == found.minimum
    assert found.minimum <= result.resampled <= result.refined <= result.bound
    assert result.gap == result.bound - result.refined
    assert result.history[0] == found.minimum and sorted(result.history) == list(result.history)
    assert f"{result.refined:.6g} refined" in str(result)


@pytest.fixture(scope="module")
def scene():
    return mp.Scene([mp.Sphere(radius=0.1, position=(0.35, 0.45, 0.6), name="ball")])


@pytest.fixture(scope="module")
def problem(panda, scene):
    start = panda.kinematics().pose(panda.neutral)
    path = CartesianPath.line(start, moved(start, [0.1, 0.15, -0.2]))
    layers = mp.sample_layers(panda, path, 6, samples=9, scene=scene, clearance=0.002)
    return layers, mp.max_min_search(layers, 0.7)


@pytest.mark.slow
def test_coarse_samples_are_raised_clearly(panda, problem):
    layers, found = problem
    told = []
    result = mp.refine(layers, found, progress=lambda share, text: told.append(share))
    assert_sound(panda, layers, found, result)
    assert result.refined > 1.2 * found.minimum
    assert result.bound < 1.01 * result.refined
    assert told == sorted(told) and told[0] >= 0 and told[-1] <= 1


@pytest.mark.slow
def test_it_nears_what_fine_samples_hold(panda, scene, problem):
    """A search through fifty times as many samples is an independent way to the same optimum."""
    layers, found = problem
    fine = mp.sample_layers(panda, _path_of(panda), 6, samples=650, scene=scene, clearance=0.002)
    best = mp.max_min_search(fine, 0.7).minimum
    result = mp.refine(layers, found)
    assert found.minimum < best
    assert best * (1 - 1e-3) < result.refined
    assert result.refined < best * (1 + 1e-3)


def _path_of(panda):
    start = panda.kinematics().pose(panda.neutral)
    return CartesianPath.line(start, moved(start, [0.1, 0.15, -0.2]))


def test_small_steps_are_kept_strictly(panda, problem):
    """ε a little above the least that connects: it binds, and is never reached."""
    layers, _ = problem
    apart = mp.max_min_search(layers, 0.001, throw=False)
    found = mp.max_min_search(layers, 1.02 * apart.smallest_epsilon)
    result = mp.refine(layers, found)
    assert_sound(panda, layers, found, result)


def test_without_finer_samples_the_program_alone_raises(panda, problem):
    layers, found = problem
    result = mp.refine(layers, found, resample=0)
    assert_sound(panda, layers, found, result)
    assert result.resampled == found.minimum < result.refined


def test_a_cycle_stays_a_cycle(panda):
    start = panda.kinematics().pose(panda.neutral)
    circle = CartesianPath.circle(start, moved(start, [0, 0, -0.08])[:3, 3], [1, 0, 0])
    layers = mp.sample_layers(panda, circle, 6, samples=21, closed=True)
    found = mp.max_min_search(layers, 0.6)
    result = mp.refine(layers, found)
    assert_sound(panda, layers, found, result)
    assert result.refined > found.minimum


@pytest.mark.slow
def test_a_tolerance_is_used_and_kept(panda, problem):
    layers, found = problem
    exact = mp.refine(layers, found)
    tube = mp.refine(layers, found, tolerance=mp.Tolerance(position=0.02, rotation=0.1))
    assert_sound(panda, layers, found, tube, position=0.02, rotation=0.1)
    assert tube.refined > 1.01 * exact.refined
    one = mp.refine(layers, found, tolerance=mp.Tolerance(rotation=0.1))
    assert_sound(panda, layers, found, one, rotation=0.1)
    assert exact.refined < one.refined < tube.refined


@pytest.mark.slow
def test_an_arm_without_anything_to_spare(ur5):
    """Six joints and a pose: only the choice among the samples is left, and the path is what it was."""
    start = ur5.kinematics().pose([0.3, -1.2, 1.4, -1.0, -1.2, 0.4])
    path = CartesianPath.line(start, moved(start, [0.05, 0.1, 0.05]))
    layers = mp.sample_layers(ur5, path, 4)
    found = mp.max_min_search(layers, 0.5)
    result = mp.refine(layers, found)
    assert_sound(ur5, layers, found, result)
    np.testing.assert_allclose(result.q, found.q, atol=1e-7)
    tube = mp.refine(layers, found, tolerance=mp.Tolerance(position=0.01, rotation=0.05))
    assert_sound(ur5, layers, found, tube, position=0.01, rotation=0.05)
    assert tube.refined > result.refined


@pytest.mark.slow
def test_joints_without_end_go_on(ur5):
    """The first joint has no limits and crosses ±π."""
    lower, upper = np.array(ur5.limits.lower), np.array(ur5.limits.upper)
    lower[0], upper[0] = -np.inf, np.inf
    arm = ur5.with_limits(lower=lower, upper=upper)
    start = arm.kinematics().pose([np.pi - 0.15, -1.2, 1.4, -1.0, -1.2, 0.4])
    layers = mp.sample_layers(arm, CartesianPath.circle(start, np.zeros(3), [0, 0, 1], 0.5, turning=True), 4)
    assert layers.continuous.tolist() == [True] + [False] * 5
    found = mp.max_min_search(layers, 0.3)
    result = mp.refine(layers, found, tolerance=mp.Tolerance(position=0.01, rotation=0.05))
    assert_sound(arm, layers, found, result, position=0.01, rotation=0.05)
    assert np.abs(np.diff(result.q[:, 0])).max() < 0.3  # unwrapped


@pytest.mark.slow
def test_kinova_with_continuous_joints():
    arm = mp.load_robot("kinova")
    start = arm.kinematics().pose(arm.neutral)
    path = CartesianPath.line(start, moved(start, [0.05, 0.08, -0.05]))
    layers = mp.sample_layers(arm, path, 3, collisions=False)
    assert layers.continuous.any() and not layers.continuous.all()
    found = mp.max_min_search(layers, 0.9)
    result = mp.refine(layers, found)
    assert_sound(arm, layers, found, result)


@pytest.mark.slow
def test_a_planar_arm(planar):
    """Its rows are x and y; the index is that of Task.planar()."""

    def index(robot, q):
        return np.linalg.svd(tool(robot, q)[1][:2], compute_uv=False).prod()

    start = planar.kinematics().pose([0.3, 0.9, 0.8])
    layers = mp.sample_layers(planar, CartesianPath.line(start, moved(start, [-0.3, 0.4, 0])), 3, samples=8, collisions=False)
    found = mp.max_min_search(layers, 1.5)
    result = mp.refine(layers, found)
    assert_sound(planar, layers, found, result, rotation=np.inf, index=index)
    assert result.refined > 1.001 * found.minimum


def test_what_cannot_be_refined_is_refused(panda, problem):
    layers, found = problem
    given = mp.Layers.from_arrays([np.zeros((1, 7))] * 2, [np.ones(1)] * 2)
    with pytest.raises(mp.errors.InvalidInputError, match="layers of sample_layers, which hold their robot and poses"):
        mp.refine(given, mp.max_min_search(given, 1.0))
    with pytest.raises(mp.errors.InvalidInputError, match="found: got 'NOT_CONNECTED'"):
        mp.refine(layers, mp.max_min_search(layers, 1e-6, throw=False))
    for change, message in (
        ({"layers": "layers"}, "layers: got 'layers'"),
        ({"found": None}, "found: got None"),
        ({"resample": -1}, "resample: got -1"),
        ({"resample": 1.5}, "resample: got 1.5"),
        ({"tolerance": 0.01}, "tolerance: got 0.01"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            mp.refine(**{"layers": layers, "found": found, **change})


def test_a_path_of_other_layers_is_refused(panda, problem):
    """As many positions, but not these: its configurations do not reach these poses."""
    layers, found = problem
    start = panda.kinematics().pose(panda.neutral)
    elsewhere = mp.sample_layers(panda, CartesianPath.line(start, moved(start, [0, -0.2, 0])), 6, samples=9)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"found: .*another candidate at position \d.*a search in these layers"
    ):
        mp.refine(layers, mp.max_min_search(elsewhere, 0.7))
    with pytest.raises(mp.errors.InvalidInputError, match="another candidate at position 3"):
        mp.refine(layers, replace(found, q=found.q + 0.01 * (np.arange(6) == 3)[:, None]))


def test_only_joints_without_end_close_a_cycle_by_full_turns():
    """A joint with limits of more than a turn has to come back itself, however large its last step is."""
    q = np.array([[0.1, 0.1, 0.0], [5.9, 5.9, -6.2]])
    np.testing.assert_allclose(full_turns(q, np.array([True, False, True])), [2 * np.pi, 0, -2 * np.pi])


def test_a_spline_turns_back_where_fine_samples_do():
    """Of each piece of a cubic spline and each joint the values where it turns back."""
    rng = np.random.default_rng(0)
    s = np.concatenate([[0.0], np.sort(rng.uniform(0.05, 0.95, 10)), [1.0]])
    path = mp.JointPath.spline(s, np.column_stack([rng.normal(size=(12, 3)), np.full(12, 0.3), s]))
    fine = path(s[:-1, None] + np.diff(s)[:, None] * np.linspace(0, 1, 20001))
    found = np.concatenate([_extremes(path, s), path(s[:-1])[:, None], path(s[1:])[:, None]], axis=1)
    np.testing.assert_allclose(found.max(axis=1), fine.max(axis=1), atol=1e-6)
    np.testing.assert_allclose(found.min(axis=1), fine.min(axis=1), atol=1e-6)
