"""The descent on g among the true obstacles: its derivatives, what it converges to, and that it says when it did not."""

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import length_density
from manipplan.optimize import descent, steps
from manipplan.optimize.certificate import SINGLE, measure_optimality
from manipplan.optimize.local import Candidate, LocalSearch
from manipplan.optimize.problem import TIE, _best
from manipplan.optimize.program import PathProgram
from manipplan.optimize.rows import ClearanceSearch
from manipplan.optimize.steps import Derivatives
from manipplan.paths.basis import find_basis
from manipplan.paths.rounding import with_bits

POST = mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post")
START, GOAL = [-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8]
CLEARANCE = 0.01


@pytest.fixture(scope="module")
def around_a_post(panda):
    """The example of docs/start.md, with everything that goes into its last descent."""
    result = mp.optimize_path(panda, START, GOAL, scene=mp.Scene([POST]), clearance=CLEARANCE)
    program = PathProgram(PathIntegral(kinematics=panda.kinematics(), power=1.0), find_basis("legendre", 6))
    model = mp.Scene([POST]).collision_model(panda)
    clearance_search = ClearanceSearch(model=model, functions=program.row_functions, clearance=CLEARANCE)
    coefficients = program.basis.fit(result.path, np.linspace(0.0, 1.0, 161))
    true, z = program.descent_program(np.array(START), np.array(GOAL), coefficients, clearance_search)
    return result, true, z


def differences(f, z, step):
    """The derivative (z.size, ...) of f by every unknown, by central differences."""
    rows = []
    for k in range(z.size):
        change = step * np.eye(z.size)[k].reshape(z.shape)
        rows.append((f(z + change) - f(z - change)) / (2 * step))
    return np.array(rows)


@pytest.mark.slow
def test_derivatives_of_g_are_exact(around_a_post):
    _, true, z = around_a_post
    gradient = true.length.gradient(z).ravel()
    np.testing.assert_allclose(gradient, differences(true.length.value, z, 1e-5), atol=1e-8)
    hessian = differences(lambda at: true.length.gradient(at).ravel(), z, 1e-5)
    np.testing.assert_allclose(true.length.derivatives(z)[1], hessian, atol=1e-6)


@pytest.mark.slow
def test_rows_do_not_depend_on_the_paths_before(around_a_post, panda):
    """Bodies are sought nearer where the path before had enough rows: the rows are those of the widest search."""
    _, true, z = around_a_post
    crowd = [mp.Sphere(radius=0.03, position=(0.5, y, 0.2), name=f"ball {k}") for k, y in enumerate(np.linspace(-0.5, 0.5, 30))]
    model, functions = mp.Scene([POST, *crowd]).collision_model(panda), true.clearance.functions
    before, curves = ClearanceSearch(model=model, functions=functions, clearance=CLEARANCE), true.length.curves
    bands, search = list[float](), before._search.find_near

    def noted(curve, target, band, known):
        bands.append(band)
        return search(curve, target, band, known)

    before._search.find_near = noted
    rng = np.random.default_rng(0)
    for size in (0.0, 1e-3, 1e-2, 0.1, 0.3, 0.5, 1e-3):
        at = z + size * rng.normal(size=z.shape)
        alone = ClearanceSearch(model=model, functions=functions, clearance=CLEARANCE)
        found, wanted = (each.at(curves, at, curves.curve(at), 0.1) for each in (before, alone))
        np.testing.assert_array_equal(found.pairs, wanted.pairs)
        np.testing.assert_allclose(found.s, wanted.s, rtol=0, atol=1e-5)
        np.testing.assert_allclose(found.value, wanted.value, rtol=0, atol=1e-8)
    assert len(bands) > 7 and min(bands) < 0.05 and max(bands) == 0.1  # narrower ones, and again where these were too narrow


@pytest.mark.slow
def test_rows_have_value_gradient_and_curvature_of_the_least_distance(around_a_post):
    """Also as the place of least distance moves along the path."""
    _, true, z = around_a_post
    curves = true.length.curves
    rows = true.clearance.at(curves, z, curves.curve(z), 0.0)
    k = int(np.flatnonzero(rows.is_bottom)[0])
    s, pair = rows.s[k], rows.pairs[k]

    def least(at):
        found = true.clearance.at(curves, at, curves.curve(at), 0.0).samples
        near = found.distances[(found.pairs == pair) & (np.abs(found.s - s) < 0.03)]
        return min(near) - true.clearance.target

    assert rows.value[k] == pytest.approx(least(z), abs=1e-9)
    np.testing.assert_allclose(
        rows.linear.jacobian[k], differences(least, z, 1e-5), atol=1e-5
    )  # distances are good to about 1e-10 m
    curvature = rows.curvature(np.eye(len(rows.s))[k])
    direction = np.linalg.eigh(curvature)[1][:, -1]
    for across in (direction, np.roll(direction, 3)):
        h = 1e-3
        along = [least(z + t * across.reshape(z.shape)) for t in (-h, 0.0, h)]
        measured = (along[0] - 2 * along[1] + along[2]) / h**2
        assert across @ curvature @ across == pytest.approx(measured, rel=0.05, abs=0.05)


@pytest.mark.slow
def test_the_post_is_touched_at_the_clearance_and_nothing_is_left_to_gain(around_a_post):
    result, true, z = around_a_post
    certificate = result.certificate
    assert result.status is mp.Status.OPTIMAL
    assert result.g < 178.0, "version 0.1 stopped at 182.3 here, 13.1 mm from the post"
    assert certificate.clearance == pytest.approx(CLEARANCE, abs=1e-4)
    assert certificate.proven_clearance > CLEARANCE
    assert certificate.projected_gradient < 1e-3
    assert certificate.complementarity < 1e-5
    assert 0 < certificate.active_clearance < 1e-4
    again = descent.descend(true, z)
    assert true.length.value(again.z) == pytest.approx(true.length.value(z), rel=1e-5)


@pytest.mark.slow
def test_a_path_that_keeps_more_than_the_clearance_is_not_optimal(around_a_post):
    """The optimum for 10 mm, measured as a path for 7 mm: the post is 3 mm further away than it has to be."""
    _, true, z = around_a_post
    assert measure_optimality(true, z).reached
    demanded = replace(true.clearance, clearance=CLEARANCE - 3e-3)
    measured = measure_optimality(replace(true, clearance=demanded), z)
    assert not measured.reached
    assert measured.projected_gradient < 1e-3
    assert measured.active_clearance == pytest.approx(3e-3, abs=2.5e-4)
    assert measured.complementarity > 1e-5


@pytest.mark.slow
@pytest.mark.parametrize("options", [{}, {"degree": 9}, {"degree": 3, "basis": "bspline", "pieces": 8}])
def test_optimising_the_result_again_lowers_g_by_nothing(panda, options):
    scene, shape = mp.Scene([POST]), mp.PathShape(**options)
    first = mp.optimize_path(panda, START, GOAL, scene, shape=shape, clearance=CLEARANCE)
    seeding = mp.Seeding(initial=first.path)
    again = mp.optimize_path(panda, START, GOAL, scene, shape=shape, seeding=seeding, clearance=CLEARANCE)
    assert again.g == pytest.approx(first.g, rel=5e-4)


def test_second_derivatives_are_computed_once_for_each_path(panda, monkeypatch):
    computed, seen = steps.derivatives, list[bytes]()

    def derivatives(n, weights, values, slopes, each):
        seen.append(weights.tobytes() + each.tobytes())
        return computed(n, weights, values, slopes, each)

    monkeypatch.setattr(steps, "derivatives", derivatives)
    rng = np.random.default_rng(3)
    lower, upper = panda.limits.lower, panda.limits.upper
    for _ in range(5):
        mp.optimize_path(panda, rng.uniform(lower, upper), rng.uniform(lower, upper))
    assert len(seen) > 50
    assert len(set(seen)) == len(seen)


@pytest.mark.slow
def test_a_higher_degree_and_a_spline_are_never_worse(panda):
    scene = mp.Scene([POST])
    costs = [
        mp.optimize_path(panda, START, GOAL, shape=mp.PathShape(degree=k), scene=scene, clearance=CLEARANCE).g
        for k in (6, 8, 12)
    ]
    assert costs[1] <= costs[0] * (1 + 1e-6)
    assert costs[2] <= costs[1] * (1 + 1e-3)  # by way of degree 9
    spline = mp.optimize_path(
        panda, START, GOAL, shape=mp.PathShape(degree=3, basis="bspline", pieces=8), scene=scene, clearance=CLEARANCE
    )
    assert spline.g <= costs[0] * (1 + 1e-3)


@pytest.mark.slow
def test_an_optimum_beside_a_post_is_one_beside_its_parts(panda, around_a_post):
    result, *_ = around_a_post
    ticks = [np.linspace(-0.5, 0.5, count, endpoint=False) + 0.5 / count for count in (4, 4, 24)]
    size, cells = np.array(POST.size), np.stack(np.meshgrid(*ticks), axis=-1).reshape(-1, 3)
    parts = [mp.Box(size=size / (4, 4, 24), position=POST.position + size * cell) for cell in cells]
    again = mp.optimize_path(
        panda, START, GOAL, scene=mp.Scene(parts), clearance=CLEARANCE, seeding=mp.Seeding(initial=result.path)
    )
    assert again.status is mp.Status.OPTIMAL
    assert again.g == pytest.approx(result.g, rel=1e-4)


@pytest.mark.slow
def test_a_path_does_not_depend_on_what_was_planned_before(panda, around_a_post):
    """Coal once began at its last answer, so depths of overlaps depended on earlier ones."""
    first, *_ = around_a_post
    scene = mp.Scene([POST])
    mp.optimize_path(panda, GOAL, np.add(START, 0.05), scene, clearance=CLEARANCE)
    again = mp.optimize_path(panda, START, GOAL, scene, clearance=CLEARANCE)
    np.testing.assert_array_equal(again.path.control, first.path.control)


@pytest.mark.slow
def test_what_was_cut_off_is_not_called_optimal(panda, monkeypatch):
    monkeypatch.setattr(descent, "STEPS", 1)
    result = mp.optimize_path(panda, START, GOAL, scene=mp.Scene([POST]), clearance=CLEARANCE)
    assert result.status is mp.Status.STOPPED_EARLY
    assert result.certificate.projected_gradient > 1e-3
    assert result.certificate.proven_clearance > CLEARANCE


def test_without_multipliers_a_path_is_not_called_optimal(around_a_post, monkeypatch):
    def give_up(*_):
        raise RuntimeError("Maximum number of iterations reached.")

    monkeypatch.setattr("scipy.optimize.nnls", give_up)
    _, true, z = around_a_post
    assert not measure_optimality(true, z).reached


@pytest.mark.slow
@pytest.mark.parametrize("room", [3e-3, 1e-4, 2e-5])
def test_a_start_that_has_hardly_more_than_the_clearance(panda, room):
    """The margins of the descents are no wider than the distance that the start has to spare."""
    scene = mp.Scene([POST])
    clearance = scene.collision_model(panda).distances(np.array(START)).min() - room
    result = mp.optimize_path(panda, START, GOAL, scene=scene, clearance=clearance)
    assert result.status.has_path
    assert result.certificate.proven_clearance >= clearance


@pytest.mark.slow
def test_plan_tries_other_shapes_where_no_descent_gave_a_free_path(panda, monkeypatch):
    """The path of low energy that is left counts as a path, but not as the result when another degree has a lower g."""
    descend = LocalSearch.descend

    def fails_for_degree_6(self, name, coefficients, **options):
        return None if self.program.basis.degree == 6 else descend(self, name, coefficients, **options)

    monkeypatch.setattr(LocalSearch, "descend", fails_for_degree_6)
    scene = mp.Scene([POST])
    alone = mp.optimize_path(panda, START, GOAL, scene=scene, clearance=CLEARANCE)
    assert alone.status is mp.Status.STOPPED_EARLY
    assert not np.isfinite(alone.certificate.projected_gradient)
    plan = mp.plan(panda, START, GOAL, scene, clearance=CLEARANCE)
    assert plan.path.degree == 9
    assert plan.result.g < alone.g


@pytest.mark.slow
@pytest.mark.parametrize("clearance", [0.0, 0.002, 0.03])
def test_other_clearances_are_kept_exactly_too(panda, clearance):
    result = mp.optimize_path(panda, START, GOAL, scene=mp.Scene([POST]), clearance=clearance)
    assert result.certificate.clearance == pytest.approx(clearance, abs=1e-4)
    assert result.certificate.proven_clearance > clearance


def test_of_two_optima_that_tie_the_earlier_one_is_taken():
    def candidate(g):
        cost = mp.results.PathCost(g=g, length=1.0, min_manipulability=1.0, at=0.0)
        return Candidate(path=None, coefficients=np.zeros((1, 1)), cost=cost, optimality=SINGLE, solver="")

    first, second = candidate(1.0), candidate(1.0 - TIE / 2)
    assert _best([first, second]) is first
    assert _best([first, candidate(1.0 - 2 * TIE)]).cost.g < 1.0
    assert _best([]) is None


def test_a_curve_may_come_as_near_to_a_limit_as_it_is():
    """Limits of the control points are stricter than those of the curve. The best path of random changes has g = 0.216508."""
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    change = {"lower": [-np.inf, 0.0, 0.0], "upper": [np.inf, 0.71120776, 0.54381329]}
    arm = replace(arm, limits=arm.limits.with_changes(change, source="a test"))
    start, goal = [0.0, 0.59317156, 0.22661668], [3.43774942, 0.43372053, 0.4126402]
    result = mp.optimize_path(arm, start, goal, shape=mp.PathShape(degree=2), objective=mp.PathObjective(power=4))
    q = result.path(np.linspace(0.0, 1.0, 20001))
    assert (q < arm.limits.upper + 1e-7).all() and (q > arm.limits.lower - 1e-7).all()
    assert result.g < 0.216508 * 1.001


def test_rounding_keeps_the_leading_bits():
    values = np.array([0.1, -1e-3, 0.0])
    rounded = with_bits(values, 12)
    assert np.abs(rounded - values).max() <= 0.1 * 2.0**-11
    np.testing.assert_array_equal(with_bits(values * (1 + 1e-13), 12), rounded)
    np.testing.assert_array_equal(with_bits(rounded, 12), rounded)
    np.testing.assert_array_equal(with_bits(np.zeros(3), 12), np.zeros(3))


@pytest.mark.compiler
def test_machine_code_gives_the_same_bits_as_the_virtual_machine(panda):
    """So the path does not depend on whether there is a compiler."""
    rng = np.random.default_rng(0)
    q, v = panda.random_configuration(rng, size=50), rng.standard_normal((50, panda.n))
    numbers = np.tile([100.0, 1.0, 0.0], (50, 1))
    densities = [
        Derivatives.of(length_density(PathIntegral(kinematics=panda.kinematics(compiled=compiled), power=1.0)))
        for compiled in (True, False)
    ]
    for name in ("value", "first", "second"):
        code, machine = (getattr(density, name)(q, v, numbers) for density in densities)
        np.testing.assert_array_equal(code, machine)


ON_A_PROCESSOR = """
import json, sys
import manipplan as mp
scene, start, goal, compiled = json.loads(sys.argv[1])
robot = mp.load_robot("panda")
scene = mp.Scene.from_yaml(scene) if isinstance(scene, str) else mp.Scene.from_entries(scene)
result = mp.optimize_path(robot, start, goal, scene=scene, clearance=0.01, compiled=compiled)
print(repr(result.g))
"""
TABLE = str(Path(__file__).parents[2] / "benchmarks" / "pairs" / "table_panda.yaml")
#: One of the pairs over the table, on whose optimum two processors once differed by 1e-5.
TABLE_START = [2.1996, -0.6845, -1.9758, -2.0232, -0.7507, 1.1674, 0.9608]
TABLE_GOAL = [0.4721, -0.1534, 0.0011, -2.5304, 2.6415, 2.0647, 0.0184]


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize(
    ("scene", "start", "goal"),
    [(mp.Scene([POST]).entries(), START, GOAL), (TABLE, TABLE_START, TABLE_GOAL)],
    ids=["post", "table"],
)
def test_g_does_not_depend_on_the_processor(scene, start, goal):
    """OpenBLAS has kernels for each kind of processor, whose sums round differently; compiled code is another difference."""
    found = []
    for kind, compiled in (("Haswell", True), ("Nehalem", False)):
        environment = {**os.environ, "OPENBLAS_CORETYPE": kind}
        told = json.dumps([scene if isinstance(scene, str) else list(scene), start, goal, compiled])
        done = subprocess.run(
            [sys.executable, "-c", ON_A_PROCESSOR, told], env=environment, capture_output=True, text=True, check=True
        )
        found.append(float(done.stdout))
    assert found[0] == pytest.approx(found[1], rel=1e-6)


@pytest.mark.slow
def test_a_nearly_free_solution_that_leads_nowhere_is_followed_by_the_next(planar, monkeypatch):
    """None counts as free here, and the first two descents give no path; no solution is tried twice."""
    judge, descend_from, tried = LocalSearch._check_solution, LocalSearch.optimum_from, []

    def never_free(search, name, solution):
        _, distances, failed_at = judge(search, name, solution)
        search.history[-1] = replace(search.history[-1], clearance=-0.01)
        return False, distances, failed_at

    def fails_at_first(search, name, coefficients):
        tried.append((name, coefficients))
        return descend_from(search, name, coefficients) if len(tried) > 2 else []

    monkeypatch.setattr(LocalSearch, "_check_solution", never_free)
    monkeypatch.setattr(LocalSearch, "optimum_from", fails_at_first)
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.0, 0.0), name="post")])
    result = mp.optimize_path(
        planar,
        [0, 1.5, -2],
        [np.pi, -2, 2],
        post,
        objective=mp.PathObjective(power=2),
        seeding=mp.Seeding(planner="RRTConnect"),
    )
    assert result.status is mp.Status.OPTIMAL
    assert [name for name, _ in tried][:3] == ["straight", "seed", "seed"]
    assert not any(np.array_equal(first, second) for k, (_, first) in enumerate(tried[:3]) for _, second in tried[:k])
