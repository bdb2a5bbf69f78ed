"""The problem of a control step against the formulas of dufour2020 in NumPy, and its answer against other solvers."""

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.measures.names import MEASURES
from manipplan.tracking.controller import Controller
from manipplan.tracking.derivatives import convexified
from manipplan.tracking.formulations import NUDGE
from manipplan.tracking.step import INPUTS, MEMORY, PROGRAM

DT = 0.01
GOLDEN = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4])


def controller(robot, formulation, **options):
    return Controller(robot, formulation, dt=options.pop("dt", DT), compiled=False, **{"approach": np.inf, **options})


def moved(pose, rng, size):
    """A pose near another one."""
    near = np.array(pose)
    near[:3, 3] += size * rng.normal(size=3)
    near[:3, :3] = pin.exp3(size * rng.normal(size=3)) @ near[:3, :3]
    return near


def state(robot, rng, size=0.05):
    """Position, velocity and target of a step."""
    q = 0.8 * robot.random_configuration(rng) + 0.2 * robot.neutral
    qd = 0.3 * robot.limits.velocity * rng.uniform(-1, 1, robot.n)
    return q, qd, moved(robot.kinematics().pose(q), rng, size)


def problem(of, q, qd, target, *, stiffness=1e4, drive=1.0, tolerance=(1e12, 1e12), memory=None, qdd=None):
    """Outputs of the problem by name, as arrays."""
    function = of._step.problem
    remembered = np.zeros(function.nnz_in("memory")) if memory is None else memory
    obstacles = of.defaults["obstacles"]
    inputs = (q, qd, np.zeros(len(q)) if qdd is None else qdd, target.T, stiffness, drive, tolerance, obstacles, remembered)
    given = dict(zip(INPUTS, inputs, strict=True))
    return {name: np.array(value) for name, value in function(**given).items()}


def error_of(robot, q, target, task=None):
    """v T and ω T of (1), ω in units of the task's length."""
    kinematics = robot.kinematics(task)
    pose = kinematics.pose(q)
    turn = pin.log3(target[:3, :3] @ pose[:3, :3].T)
    return np.concatenate([target[:3, 3] - pose[:3, 3], kinematics.task.length * turn])


# ---- the cost


def log_slope(kinematics, q, regularisation):
    """∇ log sqrt(det(J Jᵀ + r² I)) by central differences."""

    def log_m(each):
        jacobian = kinematics.jacobian(each)
        return np.linalg.slogdet(jacobian @ jacobian.T + regularisation**2 * np.eye(len(jacobian)))[1] / 2

    return np.array([(log_m(q + move) - log_m(q - move)) / 2e-5 for move in 1e-5 * np.eye(len(q))])


def log_slope_of_measure(kinematics, q, regularisation):
    """∇ log sqrt(m² + r²) by central differences."""
    moves = 1e-5 * np.eye(len(q))
    logs = [np.log(kinematics.manipulability(q + sign * moves) ** 2 + regularisation**2) / 2 for sign in (1, -1)]
    return (logs[0] - logs[1]) / 2e-5


def quadratic(kinematics, formulation, q):
    """H and g that each formulation adds, by its equation."""
    m, slope, n = kinematics.manipulability(q), kinematics.gradient(q), len(q)
    if isinstance(formulation, mp.formulations.Objective):  # (11)
        time = formulation.sample_time or DT
        return -formulation.alpha * time**2 * kinematics.hessian(q), -formulation.alpha * time * slope
    if isinstance(formulation, mp.formulations.Equality):  # (16)
        time = formulation.sample_time or DT
        return formulation.alpha * time**2 * np.outer(slope, slope), -formulation.alpha * m * time * slope
    if isinstance(formulation, mp.formulations.LogDrive):
        of_log = log_slope if kinematics.measure == mp.measures.Yoshikawa() else log_slope_of_measure
        pull = of_log(kinematics, q, formulation.regularisation) + NUDGE
        return formulation.weight * np.outer(pull, pull), -formulation.weight * formulation.rate * pull
    return np.zeros((n, n)), np.zeros(n)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("formulation", "measure"),
    [
        (mp.formulations.General(), None),
        (mp.formulations.Objective(alpha=2e3), None),
        (mp.formulations.Objective(alpha=2e3, sample_time=0.004), None),
        (mp.formulations.Equality(alpha=5e5), None),
        (mp.formulations.Equality(alpha=5e5, sample_time=0.004), None),
        (mp.formulations.Equality(alpha=5e5), "frobenius"),
        (mp.formulations.LogDrive(yields=False), None),
        (mp.formulations.LogDrive(weight=3.0, rate=2.0, yields=False), None),
        (mp.formulations.LogDrive(yields=False), "frobenius"),
    ],
    ids=str,
)
def test_cost_equals_the_expanded_formula(panda, formulation, measure, rng):
    weights = rng.uniform(0.5, 2.0, 7)
    of, kinematics = controller(panda, formulation, weights=weights, measure=measure), panda.kinematics(measure=measure)
    for _ in range(5):
        q, qd, target = state(panda, rng)
        share = rng.uniform(0, 1)
        found = problem(of, q, qd, target, stiffness=300.0, drive=share)
        jacobian, rate = panda.kinematics().jacobian(q), error_of(panda, q, target) / DT
        bend, pull = quadratic(kinematics, formulation, q)
        hessian = np.diag(weights) + 300.0 * jacobian.T @ jacobian + share * bend
        gradient = share * pull - 300.0 * jacobian.T @ rate
        assert np.linalg.eigvalsh(hessian)[0] > 0  # else the cost would have been made convex
        near = (
            1e-4 if isinstance(formulation, mp.formulations.LogDrive) else 1e-7
        )  # its regularisation counts near singularities
        np.testing.assert_allclose(found["h"], hessian, atol=near * np.abs(hessian).max())
        np.testing.assert_allclose(found["g"].ravel(), gradient, atol=near * np.abs(gradient).max())


def test_log_drive_regularises_the_singular_values_of_the_task_s_jacobian(panda, rng):
    """Of a position; those of a whole pose are seen from the middle of the arm."""
    task = mp.Task.position()
    of = controller(panda, mp.formulations.LogDrive(weight=1.0, rate=1.0, regularisation=0.2), task=task)
    for _ in range(5):
        q, qd, _ = state(panda, rng)
        found = problem(of, q, qd, panda.kinematics().pose(q))["g"].ravel()
        np.testing.assert_allclose(found, -log_slope(panda.kinematics(task), q, 0.2), atol=1e-5)


def test_a_deviation_is_corrected_no_faster_than_it_can_be_braked(panda, rng):
    """ṙ T = (target - last target) + κ (last target - tool), κ = min(1, T sqrt(2 a / |e|))."""
    of = controller(panda, mp.formulations.General(), approach=3.0)
    for size in (1e-6, 1e-3, 0.2):
        q, qd, last = state(panda, rng, size)
        target = moved(last, rng, 1e-3)
        deviation, whole = error_of(panda, q, last), error_of(panda, q, target)
        share = min(1.0, DT * np.sqrt(2 * 3.0 / np.linalg.norm(deviation)))
        rate = (whole - (1 - share) * deviation) / DT
        jacobian = panda.kinematics().jacobian(q)
        memory = np.append(last.ravel(), [1.0, 0.0, 0.0, 0.0])
        assert len(memory) == MEMORY
        found = problem(of, q, qd, target, memory=memory)["g"].ravel()
        np.testing.assert_allclose(found, -1e4 * jacobian.T @ rate, rtol=1e-6, atol=1e-6)


# ---- the answer


def test_classical_with_gain_zero_is_the_pseudo_inverse(panda, rng):
    """(2) with z = 0."""
    of = controller(panda, mp.formulations.Classical())
    for _ in range(10):
        q, qd, target = state(panda, rng)
        expected = np.linalg.pinv(panda.kinematics().jacobian(q)) @ error_of(panda, q, target) / DT
        np.testing.assert_allclose(problem(of, q, qd, target)["velocity"].ravel(), expected, rtol=1e-7, atol=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize("measure", [None, "isotropy"])
def test_classical_projects_the_gradient_into_the_null_space(panda, measure, rng):
    """(7), with I_n."""
    of = controller(panda, mp.formulations.Classical(gain=20.0), measure=measure)
    kinematics = panda.kinematics(measure=measure)
    for _ in range(10):
        q, qd, target = state(panda, rng)
        jacobian = kinematics.jacobian(q)
        inverse = np.linalg.pinv(jacobian)
        still = (np.eye(7) - inverse @ jacobian) @ (20.0 * kinematics.gradient(q))
        expected = inverse @ error_of(panda, q, target) / DT + still
        np.testing.assert_allclose(problem(of, q, qd, target)["velocity"].ravel(), expected, rtol=1e-7, atol=1e-7)


def test_classical_cuts_its_velocity_to_the_bounds(panda, rng):
    of = controller(panda, mp.formulations.Classical())
    q, qd, target = state(panda, rng, 0.5)
    found = problem(of, q, qd, target)
    low, high = found["lbx"].ravel(), found["ubx"].ravel()
    expected = np.clip(found["velocity"].ravel(), low, high)
    assert (expected != found["velocity"].ravel()).any()
    np.testing.assert_allclose(of.step(q, qd, target), expected, rtol=1e-12)


OTHERS = {
    "highs": {"highs": {"output_flag": False}},
    "piqp": {"piqp": {"eps_abs": 1e-12, "eps_rel": 1e-13}},
    "proxqp": {"proxqp": {"eps_abs": 1e-11, "eps_rel": 0.0, "max_iter": 10_000}},
}


def solved_by(solver, program):
    """The minimiser by another solver, made anew; NaN where it gives up."""
    sparsity = {"h": ca.Sparsity.dense(*program["h"].shape), "a": ca.Sparsity.dense(*program["a"].shape)}
    other = ca.conic("qp", solver, sparsity, {"error_on_fail": False, **OTHERS[solver]})
    answer = np.array(other(**program)["x"]).ravel()
    return answer if other.stats()["success"] else np.full(len(answer), np.nan)


@pytest.mark.slow
@pytest.mark.parametrize(
    "formulation",
    [mp.formulations.Objective(alpha=2e3), mp.formulations.Equality(alpha=5e5), mp.formulations.LogDrive()],
    ids=str,
)
@pytest.mark.parametrize("tube", [False, True])
def test_three_solvers_of_the_same_problem_agree(panda, formulation, tube, rng):
    """With bounds of the joints and walls of the tube active; of the other three one may stop before 1e-6 or give up."""
    width = (0.002, 0.01)
    tolerance = mp.Tolerance(position=width[0], rotation=width[1]) if tube else None
    of = controller(panda.with_limits(acceleration=60.0), formulation, tolerance=tolerance)
    active = walls = 0
    for k in range(20):
        q, qd, target = state(panda, rng, 0.001 * (k % 4))
        stiffness = 10.0 ** (k % 5)
        found = problem(of, q, qd, target, stiffness=stiffness, tolerance=width)
        program = {name: found[name] for name in PROGRAM}
        of.reset()
        velocity = of.step(q, qd, target, stiffness=stiffness)
        assert of.report.status == mp.results.StepStatus.SOLVED
        apart = [np.abs(velocity - solved_by(solver, program)[:7]).max() for solver in OTHERS]
        assert np.sort(apart)[1] < 1e-6
        distance = np.minimum(velocity - found["lbx"].ravel()[:7], found["ubx"].ravel()[:7] - velocity)
        active += (distance < 1e-9).any()
        if tube:
            rows = found["a"][:, :7] @ velocity
            walls += (np.minimum(rows - found["lba"].ravel(), found["uba"].ravel() - rows) < 1e-7).any()
    assert active >= 5
    assert walls >= 5 or not tube


def test_without_active_bounds_the_answer_is_the_minimum_of_the_cost(panda, rng):
    of = controller(panda.with_limits(velocity=1e4, acceleration=np.inf, jerk=np.inf), mp.formulations.LogDrive(yields=False))
    for _ in range(10):
        q, qd, target = state(panda, rng, 1e-3)
        found = problem(of, q, qd, target)
        np.testing.assert_allclose(of.step(q, qd, target), np.linalg.solve(found["h"], -found["g"].ravel()), rtol=1e-8)


# ---- gradient and Hessian of the manipulability


@pytest.mark.slow
def test_central_differences_equal_the_exact_derivatives(panda, rng):
    """(17) and (19) against (18) and our Hessian, seen through H and g with Q_δ so small that the drive is all."""
    exact = controller(panda, mp.formulations.Objective(alpha=1.0, sample_time=1.0, convexify=False))
    central = controller(
        panda, mp.formulations.Objective(alpha=1.0, sample_time=1.0, gradient="central", hessian="central", convexify=False)
    )
    for _ in range(5):
        q, qd, _ = state(panda, rng)
        pose = panda.kinematics().pose(q)
        a, b = (problem(of, q, qd, pose, stiffness=1e-12) for of in (exact, central))
        np.testing.assert_allclose(a["h"], np.eye(7) - panda.kinematics().hessian(q), atol=1e-9)
        np.testing.assert_allclose(b["h"], a["h"], atol=1e-5)
        np.testing.assert_allclose(b["g"], a["g"], atol=1e-7)


#: Every measure that a controller can raise, for two rows.
RAISED = [
    mp.measures.VelocityTransmission(direction=(1.0, -2.0)) if kind is mp.measures.VelocityTransmission else kind()
    for kind in MEASURES.values()
    if kind.larger_is_better
]


@pytest.mark.parametrize("measure", RAISED, ids=lambda each: each.name)
def test_a_step_has_the_derivatives_of_its_measure(planar, measure, rng):
    """Those of `Kinematics`, seen through H and g with Q_δ so small that the drive is all."""
    of = controller(planar, mp.formulations.Objective(alpha=1.0, sample_time=1.0, convexify=False), measure=measure)
    kinematics = planar.kinematics(measure=measure, compiled=False)
    assert of.kinematics.measure == measure
    for _ in range(5):
        q, qd, _ = state(planar, rng)
        slope, bend = kinematics.gradient(q), kinematics.hessian(q)
        found = problem(of, q, qd, kinematics.pose(q), stiffness=1e-12)
        np.testing.assert_allclose(found["g"].ravel(), -slope, atol=1e-9 * np.abs(slope).max())
        np.testing.assert_allclose(found["h"], np.eye(3) - bend, atol=1e-9 * (1 + np.abs(bend).max()))


@pytest.mark.parametrize("measure", RAISED[1:], ids=lambda each: each.name)
def test_log_drive_pulls_along_the_regularised_logarithm_of_its_measure(planar, measure, rng):
    """-∇ log sqrt(m² + r²), with r as large as m is in one configuration."""
    kinematics = planar.kinematics(measure=measure, compiled=False)
    large = float(kinematics.manipulability([0.3, 0.8, 0.7]))
    of = controller(planar, mp.formulations.LogDrive(weight=1.0, rate=1.0, regularisation=large), measure=measure)
    for _ in range(5):
        q, qd, _ = state(planar, rng)
        expected = log_slope_of_measure(kinematics, q, large)
        found = problem(of, q, qd, kinematics.pose(q))["g"].ravel()
        np.testing.assert_allclose(found, -expected, atol=1e-5 * (1 + np.abs(expected).max()))


@pytest.mark.parametrize("measure", ["frobenius", "isotropy"])
def test_central_differences_of_a_measure_equal_its_exact_derivatives(planar, measure, rng):
    central = mp.formulations.Objective(alpha=1.0, sample_time=1.0, gradient="central", hessian="central", convexify=False)
    exact = mp.formulations.Objective(alpha=1.0, sample_time=1.0, convexify=False)
    both = [controller(planar, formulation, measure=measure) for formulation in (exact, central)]
    for _ in range(3):
        q, qd, _ = state(planar, rng)
        a, b = (problem(of, q, qd, planar.kinematics().pose(q), stiffness=1e-12) for of in both)
        assert np.abs(a["g"]).max() > 0.01
        np.testing.assert_allclose(b["h"], a["h"], atol=1e-5 * (1 + np.abs(a["h"]).max()))
        np.testing.assert_allclose(b["g"], a["g"], atol=1e-6 * (1 + np.abs(a["g"]).max()))


def test_a_drive_whose_memories_differ_in_shape_is_refused():
    with pytest.raises(mp.errors.InvalidInputError, match=r"next_memory.*\(3, 1\)"):
        mp.formulations.Drive(hessian=ca.SX(2, 2), gradient=ca.SX(2, 1), memory=ca.SX(3, 1), next_memory=ca.SX(2, 1))


# ---- convexity


def made_convex(matrix):
    symbol = ca.SX.sym("H", *matrix.shape)
    convex, added = ca.Function("convexified", [symbol], convexified(symbol))(matrix)
    return np.array(convex), float(added)


@pytest.mark.parametrize("scale", [1e-8, 1.0, 1e8])
@pytest.mark.parametrize("n", [1, 2, 7])
def test_convexified_leaves_what_is_positive_definite(n, scale, rng):
    for _ in range(20):
        root = rng.normal(size=(n, n + 1))
        matrix = scale * (root @ root.T + 0.1 * np.eye(n))
        convex, added = made_convex(matrix)
        assert added == 0
        np.testing.assert_allclose(convex, matrix, rtol=1e-12)


@pytest.mark.parametrize("scale", [1e-8, 1.0, 1e8])
@pytest.mark.parametrize("n", [1, 2, 7])
def test_convexified_makes_positive_definite_by_a_diagonal(n, scale, rng):
    for _ in range(20):
        matrix = scale * rng.normal(size=(n, n))
        matrix = matrix + matrix.T - scale * np.eye(n)
        if np.linalg.eigvalsh(matrix)[0] > 0:
            continue
        convex, added = made_convex(matrix)
        diagonal = np.diag(convex - matrix)
        np.testing.assert_array_equal(convex - np.diag(np.diag(convex)), matrix - np.diag(np.diag(matrix)))
        assert diagonal.min() >= 0
        assert added == pytest.approx(diagonal.max(), rel=1e-6)
        assert np.linalg.eigvalsh(convex)[0] > 0


def test_an_indefinite_cost_is_made_convex_and_reported(panda):
    of = controller(panda, mp.formulations.Objective(alpha=1e7))
    pose = panda.kinematics().pose(GOLDEN)
    plain = np.eye(7) - 1e7 * DT**2 * panda.kinematics().hessian(GOLDEN)
    assert np.linalg.eigvalsh(plain)[0] < 0
    found = problem(of, GOLDEN, np.zeros(7), pose, stiffness=1.0)
    assert np.linalg.eigvalsh(found["h"])[0] > 0
    of.step(GOLDEN, np.zeros(7), pose, stiffness=1.0)
    assert of.report.status == mp.results.StepStatus.SOLVED
    assert of.report.convexified > 0


def test_the_paper_s_indefinite_cost_never_breaks_a_limit(panda, rng):
    """Solved as it is, its answers may be unsound: then the arm brakes."""
    of = controller(panda, mp.formulations.Objective(alpha=1e8, convexify=False))
    q, qd = GOLDEN, np.zeros(7)
    for _ in range(100):
        before, qd = qd, of.step(q, qd, panda.kinematics().pose(GOLDEN), stiffness=1.0)
        assert np.isfinite(qd).all()
        assert (np.abs(qd) <= panda.limits.velocity).all()
        assert (np.abs(qd - before) <= DT * panda.limits.acceleration * (1 + 1e-9)).all()
        q = q + DT * qd
        assert not panda.limits.outside(q).any()
