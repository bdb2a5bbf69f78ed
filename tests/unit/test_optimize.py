"""The path optimiser: the thesis' planar problems, its building blocks, and what it promises among obstacles."""

import itertools
import multiprocessing
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace

import casadi as ca
import numpy as np
import pytest

import manipplan as mp
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import energy_density, hessian_of, length_density
from manipplan.measures.names import MEASURES
from manipplan.optimize import clearance
from manipplan.optimize.clearance import row_functions
from manipplan.optimize.optimize import are_homotopic, best_and_rivals
from manipplan.paths import basis

THESIS = {  # start, goal, g of the straight line for p = 2 (Tables 6.1 and 6.2) and p = 1 (ERRATA): [kth2012]
    "6.10": ((0.0, -3.0, -2.0), (np.pi, 0.1, 1.4), 2.7218, 3.7288),
    "6.12": ((0.0, -1.1, -1.6), (np.pi / 2, 0.5, 1.5), 3.9420, 2.9307),
}
TABLES = {  # degree: g for p = 2, as printed in Tables 6.1 and 6.2
    "6.10": {2: 2.4600, 3: 2.3168, 4: 2.2542, 5: 2.2376, 6: 2.2361},
    "6.12": {2: 1.1371, 3: 1.1185, 4: 1.1143, 5: 1.1114, 6: 1.1114},
}
BEST_OF_60 = {  # (path, p, degree): best of 60 random starts of BFGS on g itself, by benchmarks/planar_suite.py
    ("6.10", 1, 2): 3.650752,
    ("6.10", 1, 4): 3.521593,
    ("6.10", 1, 8): 3.513078,
    ("6.10", 2, 3): 2.316832,
    ("6.10", 2, 5): 2.223079,
    ("6.12", 1, 3): 2.174214,
    ("6.12", 1, 5): 2.171373,
    ("6.12", 2, 2): 1.137127,
    ("6.12", 2, 4): 1.111175,
    ("6.12", 2, 7): 1.110667,
}


def g_by_hand(robot, path, power):
    """∫ ‖q'‖ / m^p ds by a trapezoid of 200,001 points, index from numpy's determinant."""
    s = np.linspace(0, 1, 200_001)
    jacobian = robot.kinematics().jacobian(path(s))
    index = np.sqrt(np.maximum(np.linalg.det(jacobian @ jacobian.transpose(0, 2, 1)), 1e-300))
    return np.trapezoid(np.linalg.norm(path(s, 1), axis=1) / index**power, s)


@pytest.mark.parametrize("problem", THESIS)
def test_straight_lines_have_the_thesis_values(planar, problem):
    start, goal, squared, single = THESIS[problem]
    kinematics = planar.kinematics()
    line = mp.JointPath.line(start, goal)
    assert mp.path_cost(line, kinematics, 2).g == pytest.approx(squared, abs=6e-5)
    assert mp.path_cost(line, kinematics, 1).g == pytest.approx(single, abs=6e-5)


def test_cost_equals_a_plain_sum(planar):
    result = mp.optimize_path(planar, [0, 1.5, -2], [np.pi, -2, 2], objective=mp.PathObjective(power=2, floor=0.0))
    assert result.g == pytest.approx(g_by_hand(planar, result.path, 2), rel=1e-8)
    assert result.length == pytest.approx(result.path.length)


def test_the_thesis_comparison_of_section_6_3(planar):
    """Table 6.4 prints g / g_L = 0.27, under a column headed the other way round (ERRATA)."""
    result = mp.optimize_path(
        planar, [0, 1.5, -2], [np.pi, -2, 2], shape=mp.PathShape(degree=6), objective=mp.PathObjective(power=2)
    )
    assert result.status is mp.Status.OPTIMAL
    assert result.g / result.seed_cost.g == pytest.approx(0.27, abs=0.006)
    assert result.seed_cost.length / result.length == pytest.approx(0.92, abs=0.006)
    assert result.min_manipulability > 2 * result.seed_cost.min_manipulability


@pytest.mark.parametrize(("problem", "degree"), [(problem, degree) for problem in TABLES for degree in TABLES[problem]])
def test_no_value_of_the_thesis_is_lower(planar, problem, degree):
    start, goal, *_ = THESIS[problem]
    assert (
        round(
            mp.optimize_path(planar, start, goal, shape=mp.PathShape(degree=degree), objective=mp.PathObjective(power=2)).g, 4
        )
        <= TABLES[problem][degree]
    )


@pytest.mark.parametrize("case", BEST_OF_60)
def test_g_is_the_best_of_sixty_random_starts(planar, case):
    problem, power, degree = case
    start, goal, *_ = THESIS[problem]
    assert mp.optimize_path(
        planar, start, goal, shape=mp.PathShape(degree=degree), objective=mp.PathObjective(power=power)
    ).g < BEST_OF_60[case] * (1 + 1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("power", [0.5, 1, 2])
def test_higher_degrees_never_have_a_higher_g(planar, power):
    start, goal, *_ = THESIS["6.12"]
    costs = [
        mp.optimize_path(planar, start, goal, shape=mp.PathShape(degree=k), objective=mp.PathObjective(power=power)).g
        for k in (1, 2, 3, 5, 8)
    ]
    assert (np.diff(costs) < 1e-6 * costs[-1]).all()
    assert costs[-1] < 0.95 * costs[0]


def test_no_small_change_of_the_solution_lowers_g(planar, rng):
    result = mp.optimize_path(
        planar, [0.0, 1.5, -2], [np.pi, -2, 2], shape=mp.PathShape(degree=5), objective=mp.PathObjective(power=2)
    )
    for size in (1e-3, 1e-2):
        for _ in range(20):
            control = result.path.control.copy()
            control[:, 1:-1] += size * rng.normal(size=control[:, 1:-1].shape)
            changed = mp.JointPath(breaks=result.path.breaks, control=control)
            assert mp.path_cost(changed, planar.kinematics(), 2).g > result.g - 1e-9


@pytest.mark.slow
def test_the_descent_lowers_g_among_obstacles_too(planar):
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.0, 0.0), name="post")])
    result = mp.optimize_path(planar, [0, 1.5, -2], [np.pi, -2, 2], objective=mp.PathObjective(power=2), scene=post)
    free = [step.g for step in result.history if step.clearance > 0]
    energy = [step.g for step in result.history if step.clearance > 0 and step.solver.startswith("energy")]
    assert result.g < min(energy) and result.g < min(free) * (1 + 1e-6)
    assert post.collision_model(planar).path_is_free(result.path, 1e-3)


@pytest.mark.slow
def test_a_dip_beside_a_row_gets_a_row_of_its_own(planar):
    """A path that dipped 46 mm into this post right beside a row was solved again and again without another one."""
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    result = mp.optimize_path(planar, [0, 1.5, -2], [np.pi, -2, 2], objective=mp.PathObjective(power=2), scene=post)
    assert result.status is mp.Status.OPTIMAL
    assert result.g < 0.8 * result.seed_cost.g


def test_merged_places_come_closer_when_asked():
    old = [(0.28, 3)]
    assert clearance.merged(old, [(0.275, 3)]) == old
    assert clearance.merged(old, [(0.275, 4)]) == [*old, (0.275, 4)]
    assert clearance.merged(old, [(0.275, 3)], clearance.CLOSE) == [*old, (0.275, 3)]


@pytest.mark.slow
def test_only_the_nearest_places_get_rows(demo_problem):
    """Where there are many, those whose pairs are nearest on the path, in their order."""
    problem = demo_problem
    model = problem.scene.collision_model(problem.robot)
    path = mp.JointPath.line(problem.start, problem.goal)
    places = [(s, pair) for s in np.linspace(0.1, 0.9, 9) for pair in range(0, len(model.pair_names), 12)]
    assert len(places) > clearance.MOST_PLACES
    distance = {place: model.distances(path(place[0]))[place[1]] for place in places}
    kept = clearance.nearest(model, path, places)
    assert len(kept) == clearance.MOST_PLACES
    assert max(distance[place] for place in kept) <= min(distance[place] for place in places if place not in kept) + 1e-9
    near = clearance.nearest(model, path, places, most=0.1)
    assert set(near) == {place for place in kept if distance[place] <= 0.1}
    assert clearance.nearest(model, path, places[:5], most=0.0) == tuple(places[:5])


DENSITIES = [
    *itertools.product(["planar", "panda", "tiago"], [None], [None, "weights"]),
    *itertools.product(["planar"], ["inverse_condition", "isotropy", "joint_limit_penalised", "dynamic"], ["matrix"]),
    *itertools.product(["panda"], ["smallest_singular_value", "frobenius", "isotropy"], ["weights"]),
    ("ur5", None, "weights"),
]


@pytest.mark.slow
@pytest.mark.parametrize("floor", [0.0, 0.01])
@pytest.mark.parametrize(("name", "measure", "metric"), DENSITIES)
@pytest.mark.parametrize("kind", [energy_density, length_density])
def test_densities_have_exact_derivatives(name, measure, metric, kind, floor, rng):
    robot = mp.planar_arm([1.0, 1.0, 1.0]) if name == "planar" else mp.load_robot(name)
    n = robot.n
    W = {None: None, "weights": np.diag(np.arange(1.0, n + 1)), "matrix": np.eye(n) + 0.3}[metric]
    density, slope, derivatives = kind(
        PathIntegral(kinematics=robot.kinematics(measure=measure), power=1.5, metric=W)
    ).functions
    x, numbers = ca.SX.sym("x", 2 * n), [0.7, 1.5, floor]  # g0, exponent and floor
    value = ca.Function("value", [x], [density(x[:n], x[n:], numbers)])
    eps = 1e-6
    for q in robot.random_configuration(rng, size=5):
        at = np.concatenate([0.7 * q, rng.normal(size=n)])
        gradient, hessian = (np.asarray(f(at[:n], at[n:], numbers)) for f in (slope, hessian_of(derivatives)))
        steps = eps * np.eye(2 * n)
        first = [float(value(at + step) - value(at - step)) / (2 * eps) for step in steps]
        ahead, behind = (
            [np.asarray(slope((at + s)[:n], (at + s)[n:], numbers)).ravel() for s in sign * steps] for sign in (1, -1)
        )
        np.testing.assert_allclose(gradient.ravel(), first, rtol=1e-5, atol=2e-6 * np.abs(first).max())
        second = (np.array(ahead) - behind) / (2 * eps)
        np.testing.assert_allclose(hessian, second, rtol=1e-4, atol=2e-5 * np.abs(second).max())


def test_a_metric_is_a_change_of_joint_units(planar):
    """With W = diag(w²) g is that of the Euclidean norm of w θ, here by a plain sum; equal weights only scale it."""
    start, goal = [0, 1.5, -2], [np.pi, -2, 2]
    plain, scaled = (
        mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2, metric=metric, floor=0.0))
        for metric in (None, [9.0, 9.0, 9.0])
    )
    assert scaled.g == pytest.approx(3 * plain.g, rel=1e-7)
    weights = np.array([9.0, 1.0, 0.25])
    weighed = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2, metric=weights, floor=0.0))
    s = np.linspace(0, 1, 100_001)
    v, index = weighed.path(s, 1), planar.kinematics().manipulability(weighed.path(s))
    assert weighed.g == pytest.approx(np.trapezoid(np.sqrt((weights * v**2).sum(axis=1)) / index**2, s), rel=1e-7)
    assert weighed.g < mp.path_cost(plain.path, planar.kinematics(), 2, metric=weights).g
    assert plain.g < mp.path_cost(weighed.path, planar.kinematics(), 2).g
    full = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2, metric=np.diag(weights), floor=0.0))
    assert full.g == weighed.g
    np.testing.assert_array_equal(full.metric, np.diag(weights))


@pytest.mark.slow
@pytest.mark.parametrize(
    "measure", [name for name, kind in MEASURES.items() if kind.larger_is_better and "transmission" not in name]
)
def test_any_measure_that_grows_is_raised(planar, measure):
    """Its g is below those of the straight line and of the path that is best for Yoshikawa's index."""
    start, goal, *_ = THESIS["6.12"]
    result = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=1, measure=measure))
    kinematics = planar.kinematics(measure=measure)
    assert result.status.ok
    assert result.measure.name == measure
    assert result.g == pytest.approx(mp.path_cost(result.path, kinematics, 1).g)
    usual = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=1))
    assert result.g <= mp.path_cost(usual.path, kinematics, 1).g * (1 + 1e-9)
    assert result.g < result.seed_cost.g


def test_a_measure_with_a_direction(planar):
    result = mp.optimize_path(
        planar,
        [0, 1.5, -2],
        [np.pi, -2, 2],
        objective=mp.PathObjective(measure=mp.measures.VelocityTransmission(direction=[1.0, 0.0])),
    )
    assert result.status.ok
    assert result.g < result.seed_cost.g


def test_degree_one_is_the_straight_line(planar, demo_problem):
    detour = mp.JointPath.through([[0, 1.5, -2], [1.0, 1.0, 1.0], [np.pi, -2, 2]])
    for options in ({}, {"seeding": mp.Seeding(initial=detour)}, {"scene": mp.Scene()}):
        result = mp.optimize_path(
            planar, [0, 1.5, -2], [np.pi, -2, 2], shape=mp.PathShape(degree=1), objective=mp.PathObjective(power=2), **options
        )
        assert result.path.degree == 1
        assert result.status in (mp.Status.OPTIMAL, mp.Status.SEED_IS_BETTER)
    assert mp.plan(planar, [0, 1.5, -2], [np.pi, -2, 2], shape=mp.PathShape(degree=1)).path.degree == 1


@pytest.mark.slow
@pytest.mark.parametrize("power", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("folded", [0.0, np.pi])
def test_a_path_that_is_singular_all_along_costs_no_time(planar, power, folded):
    """Its index is rounding errors, 1e-16 m^2, of which every finer panel sees others: halving went on for ever."""
    path = mp.JointPath.line([0.1, folded, 0.0], [0.9, folded, 0.0])
    cost = PathIntegral(kinematics=planar.kinematics(), power=power).cost(path)
    assert cost.g == np.inf
    assert cost.min_manipulability < 1e-12
    plan = mp.plan(planar, path.start, path.goal, objective=mp.PathObjective(power=power, floor=0.0), throw=False)
    assert plan.report.seed_g == np.inf
    assert plan.report.min_manipulability < 1e-12


def test_an_interior_singularity_is_seen():
    """Every path of a two-link arm from q2 = -1 to sqrt(2) crosses q2 = 0, between the points of any grid."""
    arm = mp.planar_arm([1.0, 1.0])
    cost = mp.path_cost(mp.JointPath.line([0.0, -1.0], [0.5, np.sqrt(2.0)]), arm.kinematics(), 1)
    assert cost.g == np.inf
    assert cost.min_manipulability < 1e-9
    assert cost.at == pytest.approx(1 / (1 + np.sqrt(2.0)), abs=1e-9)
    no_floor = mp.PathObjective(floor=0.0)
    result = mp.optimize_path(arm, [0.0, -1.0], [0.5, np.sqrt(2.0)], objective=no_floor, throw=False)
    assert result.status is mp.Status.SINGULAR
    with pytest.raises(mp.errors.PlanningError, match="manipulability is zero"):
        mp.optimize_path(arm, [0.0, -1.0], [0.5, np.sqrt(2.0)], objective=no_floor)


@pytest.mark.slow
def test_a_full_turn_to_the_same_place_is_a_shift(planar):
    result = mp.optimize_path(
        planar,
        [2 * np.pi, 1.0, 1.0],
        [0.0, 1.0, 1.0],
        objective=mp.PathObjective(power=2),
        seeding=mp.Seeding(shifts="within-limits"),
    )
    assert np.abs(result.path.goal - [2 * np.pi, 1.0, 1.0]).max() > 1


def test_a_path_that_rests_on_limits_is_inside_of_them(planar):
    """Not outside by what steps are rounded by: such a path would be given up."""
    ends = np.random.default_rng(3).uniform(-1.5, 1.5, (12, 2, 3))
    for start, goal in ends[[1, 8, 10]]:
        lower, upper = np.minimum(start, goal) - 0.02, np.maximum(start, goal) + 0.02
        result = mp.optimize_path(planar.with_limits(lower=lower, upper=upper), start, goal)
        low, high = result.path.bounds()
        assert 0 < min((low - lower).min(), (upper - high).min()) < 1e-6


def test_joint_limits_hold_on_the_whole_curve(planar):
    start, goal, *_ = THESIS["6.12"]
    free = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2))
    low, high = free.path.bounds()
    ends = np.minimum(start, goal), np.maximum(start, goal)
    assert max((ends[0] - low).max(), (high - ends[1]).max()) > 0.1, "the limits below must bind"
    tight = planar.with_limits(lower=0.3 * low + 0.7 * ends[0] - 1e-3, upper=0.3 * high + 0.7 * ends[1] + 1e-3)
    held = mp.optimize_path(tight, start, goal, objective=mp.PathObjective(power=2))
    low, high = held.path.bounds()
    assert held.status is mp.Status.OPTIMAL
    assert max(tight.limits.outside(low).max(), tight.limits.outside(high).max()) < 1e-7
    assert free.g < held.g < held.seed_cost.g


@pytest.mark.slow
def test_shifted_goals_find_a_better_turn(planar):
    """The first path of section 6.2 is much better with a goal 2π away (ERRATA)."""
    start, goal, *_ = THESIS["6.10"]
    plain = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2))
    shifted = mp.optimize_path(
        planar, start, goal, objective=mp.PathObjective(power=2), seeding=mp.Seeding(shifts="within-limits")
    )
    assert shifted.g < 0.9 * plain.g
    turns = (shifted.path.goal - np.array(goal)) / (2 * np.pi)
    np.testing.assert_allclose(turns, np.round(turns), atol=1e-12)


@pytest.mark.slow
def test_rivals_are_other_paths_best_first(planar):
    start, goal, *_ = THESIS["6.10"]
    best = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2), seeding=mp.Seeding(count=8))
    costs = [each.g for each in (best, *best.rivals)]
    assert len(costs) > 1
    assert costs == sorted(costs)
    assert best.g == pytest.approx(mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2)).g, rel=1e-6)
    s = np.linspace(0, 1, 201)
    for first, second in itertools.combinations((best, *best.rivals), 2):
        apart = np.linalg.norm(first.path(s)[:, None] - second.path(s)[None], axis=2).min(axis=1).max()
        assert apart > 1e-2, "one and the same path"
    assert all(rival.rivals == () for rival in best.rivals)
    again = mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2), seeding=mp.Seeding(count=8))
    assert [each.g for each in (again, *again.rivals)] == costs


@pytest.fixture(scope="module")
def around_a_post(planar):
    """A post that the arm can pass on the inner or the outer side, or turn away from the long way round."""
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    seeding = mp.Seeding(count=6, shifts="within-limits")
    options = {"scene": post, "objective": mp.PathObjective(power=2), "seeding": seeding}
    bounded = planar.with_limits(lower=np.full(3, -np.pi), upper=np.full(3, 1.5 * np.pi))
    return bounded, options, mp.optimize_path(bounded, [0, 1.5, -2], [np.pi, -2, 2], **options)


@pytest.mark.slow
def test_shifted_goals_and_several_classes_among_obstacles(around_a_post):
    robot, options, best = around_a_post
    every = (best, *best.rivals)
    assert len({tuple(np.round(each.path.goal, 6)) for each in every}) > 1
    turns = [(each.path.goal - np.array([np.pi, -2, 2])) / (2 * np.pi) for each in every]
    np.testing.assert_allclose(turns, np.round(turns), atol=1e-12)
    assert [each.g for each in every] == sorted(each.g for each in every)
    model = options["scene"].collision_model(robot)
    assert all(model.path_is_free(each.path, 1e-3) for each in every)
    assert (
        best.g
        <= mp.optimize_path(robot, [0, 1.5, -2], [np.pi, -2, 2], objective=mp.PathObjective(power=2), scene=options["scene"]).g
    )


@pytest.mark.slow
@pytest.mark.parametrize("kind", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_an_executor_changes_nothing(around_a_post, kind):
    robot, options, best = around_a_post
    workers = {"mp_context": multiprocessing.get_context("spawn")} if kind is ProcessPoolExecutor else {}
    with kind(2, **workers) as executor:
        again = mp.optimize_path(robot, [0, 1.5, -2], [np.pi, -2, 2], executor=executor, **options)
    assert len(again.rivals) == len(best.rivals)
    for one, other in zip((best, *best.rivals), (again, *again.rivals), strict=True):
        np.testing.assert_array_equal(one.path.control, other.path.control)


def test_paths_on_two_sides_of_a_post_are_two_classes(planar):
    model = mp.Scene([mp.Sphere(radius=0.05, position=(2.9, 0.0, 0.0), name="ball")]).collision_model(planar)
    start, goal = np.array([-0.8, 0.0, 0.0]), np.array([0.8, 0.0, 0.0])
    left = mp.JointPath.through([start, [-0.8, 1.2, 0.0], [0.8, 1.2, 0.0], goal])
    wider = mp.JointPath.through([start, [-0.8, 1.4, 0.1], [0.8, 1.4, 0.1], goal])
    right = mp.JointPath.through([start, [-0.8, -1.2, 0.0], [0.8, -1.2, 0.0], goal])
    assert all(model.path_is_free(path, 1e-3) for path in (left, wider, right))
    assert are_homotopic(model, left, wider)
    assert not are_homotopic(model, left, right)
    assert not are_homotopic(model, left, mp.JointPath.line(start, [0.8, 0.0, 0.5]))


ENDS = [
    ({"start_slope": [0.0, 0.0, 0.0]}, 2),
    ({"start_slope": [3.0, -1.0, 2.0], "goal_slope": [3.0, 0.0, 5.0]}, 3),
    ({"start_second_derivative": [1.0, 0.0, -1.0]}, 2),
    (
        {
            "start_slope": [0.0] * 3,
            "goal_slope": [0.0] * 3,
            "start_second_derivative": [0.0] * 3,
            "goal_second_derivative": [0.0] * 3,
        },
        5,
    ),
    (
        {"goal_slope": [1.0, 2.0, 3.0], "start_second_derivative": [4.0, 0.0, 0.0], "goal_second_derivative": [0.0, -3.0, 1.0]},
        4,
    ),
]
ORDERS = {
    "start_slope": (0.0, 1),
    "goal_slope": (1.0, 1),
    "start_second_derivative": (0.0, 2),
    "goal_second_derivative": (1.0, 2),
}


@pytest.mark.slow
@pytest.mark.parametrize(("conditions", "least"), ENDS)
def test_end_derivatives_are_met(planar, conditions, least):
    start, goal = [0, 1.5, -2], [np.pi, -2, 2]
    free = mp.optimize_path(planar, start, goal, shape=mp.PathShape(degree=8), objective=mp.PathObjective(power=2))
    costs = []
    for degree in (least, least + 1, least + 3, 12):
        shape = mp.PathShape(degree=degree, **conditions)
        result = mp.optimize_path(planar, start, goal, shape=shape, objective=mp.PathObjective(power=2))
        assert result.status is mp.Status.OPTIMAL
        for name, value in conditions.items():
            np.testing.assert_allclose(result.path(*ORDERS[name]), value, atol=1e-8)
        np.testing.assert_allclose(result.path([0.0, 1.0]), [start, goal], atol=1e-12)
        costs.append(result.g)
    assert (np.diff(costs[1:]) < 1e-6).all()
    assert free.g * (1 - 1e-4) < costs[-1] < 1.3 * free.g
    too_low = mp.PathShape(degree=least - 1, **conditions)
    with pytest.raises(mp.errors.InvalidInputError, match=f"degree: got {least - 1}; allowed: at least {least}"):
        mp.optimize_path(planar, start, goal, shape=too_low, objective=mp.PathObjective(power=2))


@pytest.mark.slow
def test_end_derivatives_among_obstacles_and_limits(planar):
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    rest = {"start_slope": np.zeros(3), "goal_slope": np.zeros(3)}
    start, goal = [0, 1.5, -2], [np.pi, -2, 2]
    result = mp.optimize_path(
        planar, start, goal, post, shape=mp.PathShape(degree=9, **rest), objective=mp.PathObjective(power=2)
    )
    assert result.status.ok
    assert post.collision_model(planar).path_is_free(result.path, 1e-3)
    np.testing.assert_allclose(result.path([0.0, 1.0], 1), 0, atol=1e-8)
    # the only cubic of these ends runs through the post; the seed is free, but has other ends, and says so
    cubic = mp.optimize_path(
        planar, start, goal, post, shape=mp.PathShape(degree=3, **rest), objective=mp.PathObjective(power=2)
    )
    assert cubic.status is mp.Status.ENDS_NOT_MET
    assert post.collision_model(planar).path_is_free(cubic.path, 1e-3)
    narrow = planar.with_limits(lower=[-0.1, -2.1, -2.1], upper=[np.pi + 0.1, 1.6, 2.1])
    wild = mp.optimize_path(
        narrow,
        start,
        goal,
        shape=mp.PathShape(degree=4, start_slope=[0, 30.0, 0]),
        objective=mp.PathObjective(power=2),
        throw=False,
    )
    assert wild.status is mp.Status.ENDS_NOT_MET


def test_a_certificate_is_measured_on_the_path(planar):
    start, goal, *_ = THESIS["6.12"]
    narrow = planar.with_limits(lower=[-3.0, -1.2, -1.7], upper=[3.0, 0.6, 2.0])
    result = mp.optimize_path(narrow, start, goal, objective=mp.PathObjective(power=2), compare=True)
    certificate = result.certificate
    assert certificate.status is result.status
    assert certificate.solver.startswith("no step lowers g after")
    assert certificate.projected_gradient < 1e-5, "beside the limits that bind"
    assert (certificate.complementarity, certificate.active_clearance) == (0.0, 0.0)
    assert certificate.g == result.g
    assert certificate.unconstrained_g == pytest.approx(
        mp.optimize_path(planar, start, goal, objective=mp.PathObjective(power=2)).g, rel=1e-6
    )
    assert certificate.gap == pytest.approx(result.g / certificate.unconstrained_g - 1)
    assert certificate.gap > 1e-3, "the limits bind"
    q = result.path(np.linspace(0, 1, 20_001))
    assert len(certificate.limits) == 6
    for each in certificate.limits:
        joint = narrow.joint_names.index(each.joint)
        limit = getattr(narrow.limits, each.side)[joint]
        assert each.distance == pytest.approx(np.abs(q[:, joint] - limit).min(), abs=1e-6)
        assert abs(result.path(each.at)[joint] - limit) == pytest.approx(each.distance, abs=1e-5)
    assert [each.distance for each in certificate.limits] == sorted(each.distance for each in certificate.limits)
    assert certificate.limits[0].distance == pytest.approx(0, abs=1e-4), "control points lie a little outside the curve"
    assert (certificate.clearance, certificate.nearest_pair) == (np.inf, ())
    text = str(certificate)
    for part in (
        "no step lowers g",
        "projected gradient",
        "minimum m",
        "nothing is checked for collision",
        "limit        joint",
        "yoshikawa",
    ):
        assert part in text


def test_without_constraints_that_bind_the_gap_is_zero(planar):
    result = mp.optimize_path(planar, [0, 1.5, -2], [np.pi, -2, 2], objective=mp.PathObjective(power=2), compare=True)
    assert result.certificate.gap == pytest.approx(0, abs=1e-7)
    line = mp.optimize_path(
        planar,
        [0, 1.5, -2],
        [np.pi, -2, 2],
        objective=mp.PathObjective(power=2),
        shape=mp.PathShape(degree=1),
        compare=True,
    )
    assert line.certificate.gap == pytest.approx(0, abs=1e-9)
    assert line.certificate.solver == ""
    arm = mp.planar_arm([1.0, 1.0])
    no_floor = mp.PathObjective(floor=0.0)
    ends = [0.0, -1.0], [0.5, np.sqrt(2.0)]
    singular = mp.optimize_path(arm, *ends, objective=no_floor, compare=True, throw=False).certificate
    assert np.isnan(singular.gap)
    assert "inf" in str(singular)


@pytest.mark.slow
def test_a_certificate_names_the_nearest_pair(planar):
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    start, goal = [0, 1.5, -2], [np.pi, -2, 2]
    for degree in (6, 1):  # an optimised path, and the safe seed
        result = mp.optimize_path(
            planar, start, goal, post, shape=mp.PathShape(degree=degree), objective=mp.PathObjective(power=2), compare=True
        )
        certificate, model = result.certificate, post.collision_model(planar)
        every = [model.distances(q).min() for q in result.path(np.linspace(0, 1, 4001))]
        assert certificate.clearance == pytest.approx(min(every), abs=1e-4)
        assert model.distances(result.path(certificate.clearance_at)).min() == pytest.approx(certificate.clearance, abs=1e-6)
        assert "post" in certificate.nearest_pair
        assert degree == 1 or certificate.gap > 0
        assert "mm at s" in str(certificate)
    assert result.status is mp.Status.SEED_IS_SAFE
    assert certificate.solver == ""


def test_a_singular_start_is_told(planar):
    options = {"shape": mp.PathShape(degree=1), "objective": mp.PathObjective(floor=0.0)}
    with pytest.raises(mp.errors.PlanningError, match="manipulability is zero"):
        mp.optimize_path(planar, [0.0, 0.0, 0.0], [0.0, 0.0, np.pi], **options)
    result = mp.optimize_path(planar, [0.0, 0.0, 0.0], [0.0, 0.0, np.pi], **options, throw=False)
    assert result.min_manipulability == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("degree", [1, 6, 20])
def test_subdivision_gives_the_same_curve(rng, degree):
    control = rng.normal(size=(degree + 1, 2))
    pieces = (basis.subdivision(degree, 4) @ control).reshape(4, degree + 1, 2)
    whole = mp.JointPath(breaks=[0, 1], control=control[None])
    parts = mp.JointPath(breaks=np.linspace(0, 1, 5), control=pieces)
    s = np.linspace(0, 1, 41)
    np.testing.assert_allclose(parts(s), whole(s), atol=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "tiago", "kinova"])
def test_clearance_rows_have_exact_derivatives(name, rng):
    robot = mp.load_robot(name)
    value, gradient, hessian = row_functions(robot.kinematics(compiled=False)).functions
    n = robot.n
    q, column = ca.SX.sym("q", n), ca.SX.sym("column", value.size1_in(1))
    second, first = ca.hessian(value(q, column), q)
    automatic = ca.Function("automatic", [q, column], [first, second])
    for carrier in range(n + 1):
        for other in range(n + 1):
            data = np.concatenate([np.eye(n + 1)[carrier], np.eye(n + 1)[other], rng.normal(size=8)])
            at = robot.random_configuration(rng)
            first, second = automatic(at, data)
            np.testing.assert_allclose(gradient(at, data), first, atol=1e-13)
            np.testing.assert_allclose(hessian(at, data), second, atol=1e-13)


@pytest.mark.slow
def test_a_row_is_the_distance_of_its_pair(demo_problem, rng):
    """Where two bodies are d apart, the nearest core point of the first lies d + radius beyond the plane."""
    robot = demo_problem.robot
    model = demo_problem.scene.collision_model(robot)
    data = robot.model.createData()
    import pinocchio as pin

    for q in robot.random_configuration(rng, size=10):
        pin.forwardKinematics(robot.model, data, q)
        for pair in rng.choice(len(model.pair_names), 15, replace=False):
            found, (points, radius) = model.witnesses(q[None], [pair]), model.core(int(pair))
            first, second = found.joints[0].tolist()
            plane, carrier = data.oMi[second], data.oMi[first]
            point = points[np.argmax(points @ found.opposites[0])]
            world = carrier.rotation @ point + carrier.translation - plane.translation
            beyond = (plane.rotation @ found.normals[0]) @ world - found.offsets[0] - radius
            if found.distances[0] > 1e-3:
                assert beyond == pytest.approx(found.distances[0], abs=1e-9)


def test_an_initial_path_is_used(planar):
    detour = mp.JointPath.through([[0, 1.5, -2], [1.0, 1.0, 1.0], [np.pi, -2, 2]])
    result = mp.optimize_path(
        planar, [0, 1.5, -2], [np.pi, -2, 2], objective=mp.PathObjective(power=2), seeding=mp.Seeding(initial=detour)
    )
    assert {"straight", "path"} <= {step.first for step in result.history} <= {"straight", "even pace", "path"}
    assert result.g <= result.seed_cost.g


@pytest.mark.parametrize("beyond", [0.0, 9e-8, 2e-7])
def test_a_path_that_a_result_may_be_is_taken_as_initial(planar, beyond):
    """Results keep the limits to 1e-7; the next call from one of them is not refused."""
    bend = mp.JointPath(breaks=[0.0, 1.0], control=[[[0.0, 1.0, -2.0], [1.0, 2.0, 0.0], [2.0, 1.0, 2.0]]])
    arm = planar.with_limits(upper=[4.0, 1.5 - beyond, 4.0])
    seeding = mp.Seeding(initial=bend)
    if beyond > 1e-7:
        with pytest.raises(mp.errors.InvalidInputError, match="initial"):
            mp.optimize_path(arm, bend.start, bend.goal, seeding=seeding)
    else:
        assert mp.optimize_path(arm, bend.start, bend.goal, seeding=seeding).path is not None


#: Groups of options; where one has a wrong value, it raises when it is made, or where the robot is known.
GROUPS = {"objective": mp.PathObjective, "shape": mp.PathShape, "seeding": mp.Seeding}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"shape": {"degree": 0}}, "degree: got 0.*at least 1"),
        ({"shape": {"degree": 2.5}}, "degree"),
        ({"shape": {"degree": 21}}, "degree.*at most 20"),
        ({"objective": {"power": 0}}, "power: got 0"),
        ({"objective": {"power": np.nan}}, "power"),
        ({"seeding": {"shifts": "all"}}, "shifts: got 'all'.*within-limits"),
        ({"clearance": -0.1}, "clearance"),
        ({"start": [0, 1.5]}, "start"),
        ({"goal": [0, 1.5, np.nan]}, "goal.*finite"),
        ({"goal": [0.0, 1.5, -2.0]}, "goal.*differs from start"),
        ({"objective": {"task": mp.Task.pose()}}, "task.*at most 3 rows"),
        ({"shape": {"start_slope": [0.0, 1.0]}}, r"start_slope.*shape \(3,\)"),
        ({"shape": {"goal_second_derivative": [0.0, 1.0, np.inf]}}, "goal_second_derivative.*finite"),
        ({"shape": {"degree": 2, "start_slope": [0.0] * 3, "goal_slope": [0.0] * 3}}, "degree: got 2; allowed: at least 3"),
        ({"seeding": {"count": 0}}, "count: got 0.*at least 1"),
        (
            {"seeding": {"count": 2, "initial": mp.JointPath.line([0.0, 1.5, -2.0], [np.pi, -2.0, 2.0])}},
            "count: got 2.*initial",
        ),
        (
            {"seeding": {"shifts": "within-limits", "initial": mp.JointPath.line([0.0, 1.5, -2.0], [np.pi, -2.0, 2.0])}},
            "shifts.*initial",
        ),
        ({"executor": 4}, "executor: got 4.*Executor"),
        ({"seeding": {"time_limit": 0}}, "time_limit"),
        ({"objective": {"metric": [1.0, 1.0]}}, "metric.*3 weights above zero.*positive definite"),
        ({"objective": {"metric": [1.0, 1.0, 0.0]}}, "metric.*3 weights above zero"),
        ({"objective": {"metric": [[1, 2, 0], [2, 1, 0], [0, 0, 1]]}}, "metric.*positive definite"),
        ({"objective": {"metric": [[1, 1, 0], [0, 1, 0], [0, 0, 1]]}}, "metric.*symmetric"),
        ({"objective": {"metric": [1.0, np.nan, 1.0]}}, "metric.*no NaN"),
        ({"objective": {"metric": "heavy"}}, "metric.*real numbers"),
        ({"objective": {"metric": [1e308, 1e308, 1e308]}}, "metric.*below 1e.150"),
        ({"objective": {"metric": [1e-18, 1e-18, 1e-18]}}, "metric.*at least 1e-12"),
        ({"clearance": 0.05}, "clearance: got 0.05; allowed: 0 without a scene.*scene=Scene"),
        ({"objective": {"measure": "log_det"}}, "measure: got 'log_det'.*at least zero and better when larger: yoshikawa"),
        ({"objective": {"measure": "condition_number"}}, "measure: got 'condition_number'.*better when larger"),
        ({"objective": {"measure": "force_transmission"}}, "measure.*direction"),
        (
            {"objective": {"measure": mp.measures.ForceTransmission(direction=[1, 0])}},
            "measure: got 'force_transmission'.*better when larger",
        ),
        ({"objective": {"measure": mp.measures.VelocityTransmission(direction=[1, 0, 0])}}, "direction.*2 numbers"),
        ({"objective": {"measure": "yosikawa"}}, "yoshikawa"),
        ({"seeding": {"initial": mp.JointPath.line([0, 0, 0], [1, 1, 1])}}, "initial"),
    ],
)
def test_wrong_arguments(planar, change, message):
    arguments = {"start": [0.0, 1.5, -2.0], "goal": [np.pi, -2.0, 2.0], **change}
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.optimize_path(
            planar, **{name: GROUPS[name](**value) if name in GROUPS else value for name, value in arguments.items()}
        )


def test_an_executor_that_takes_no_work(planar):
    pool = ThreadPoolExecutor(1)
    pool.shutdown()
    with pytest.raises(mp.errors.InvalidInputError, match="executor: got .*takes work.*after shutdown"):
        mp.optimize_path(planar, [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0], executor=pool)


@pytest.mark.parametrize("scene", [None, mp.Scene()])
def test_an_index_that_is_zero_everywhere_is_told_without_warnings(planar, scene):
    """All three rows of position on an arm that moves in a plane."""
    result = mp.optimize_path(
        planar, [0.0, 1.5, -2.0], [1.0, 1.2, 1.0], objective=mp.PathObjective(task=mp.Task.position()), scene=scene, throw=False
    )
    assert result.status is mp.Status.SINGULAR
    assert result.min_manipulability == 0


def test_where_the_straight_line_is_best_it_is_optimal(planar):
    """The power is so low that g is the length; rounding must not decide what the status says."""
    for goal in ([1.0, 1.2, 1.0], [2.0, -1.2, 0.3], [0.3, 2.0, -1.0]):
        result = mp.optimize_path(planar, [0.0, 1.5, -2.0], goal, objective=mp.PathObjective(power=1e-300))
        assert result.status is mp.Status.OPTIMAL
        assert result.g == pytest.approx(np.linalg.norm(np.subtract(goal, [0.0, 1.5, -2.0])), rel=1e-12)


@pytest.mark.slow
def test_the_unconstrained_optimum_is_never_above_the_path(planar):
    """The path crosses a singularity, which a power below 1 forgives; the least energy nearby lies elsewhere."""
    arm = mp.planar_arm([1.0, 1.0])
    options = {"shape": mp.PathShape(degree=4), "objective": mp.PathObjective(power=0.5)}
    result = mp.optimize_path(arm, [0.0, -2.0], [1.0, 2.0], compare=True, **options)
    assert result.certificate.gap >= -1e-9
    alone = mp.optimize_path(arm, [0.0, -2.0], [1.0, 2.0], **options)
    assert np.isnan(alone.certificate.gap) and alone.g == result.g


def test_rivals_that_tie_keep_their_order(planar):
    first = mp.optimize_path(planar, [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0])
    second = mp.optimize_path(planar, [0.0, 1.5, -2.0], [np.pi, -2.0, 1.0])
    for higher, expected in ((1e-9, first), (1e-3, second)):
        best = best_and_rivals([replace(first, g=1.0 + higher), replace(second, g=1.0)])
        assert best.path is expected.path
        assert len(best.rivals) == 1
