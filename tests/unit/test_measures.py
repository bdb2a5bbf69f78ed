"""Every measure against NumPy, its derivatives against central differences, its limits on singularities."""

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.measures.names import measure_of

U = np.array([1.0, -2.0, 0.5])


def singular(jacobian):
    return np.linalg.svd(jacobian, compute_uv=False)


ORACLES = [
    (mp.measures.Yoshikawa(), lambda J: np.sqrt(np.linalg.det(J @ J.T))),
    (mp.measures.LogDet(regularisation=0.1), lambda J: np.log(np.sqrt(np.linalg.det(J @ J.T + 0.01 * np.eye(len(J)))))),
    (mp.measures.FrobeniusNorm(), np.linalg.norm),
    (mp.measures.FrobeniusNorm(weights=range(1, 8)), lambda J: np.sqrt(np.trace(J @ np.diag(np.arange(1.0, 8.0)) @ J.T))),
    (mp.measures.ConditionNumber(), np.linalg.cond),
    (mp.measures.InverseCondition(), lambda J: 1 / np.linalg.cond(J)),
    (mp.measures.SmallestSingularValue(), lambda J: singular(J)[-1]),
    (mp.measures.Isotropy(), lambda J: np.linalg.det(J @ J.T) ** (1 / len(J)) / (np.trace(J @ J.T) / len(J))),
    (mp.measures.VelocityTransmission(direction=U), lambda J: (U @ np.linalg.inv(J @ J.T) @ U / (U @ U)) ** -0.5),
    (mp.measures.ForceTransmission(direction=U), lambda J: (U @ J @ J.T @ U / (U @ U)) ** -0.5),
]


@pytest.mark.parametrize(("measure", "oracle"), ORACLES, ids=lambda each: getattr(each, "name", ""))
def test_value_of_a_matrix(measure, oracle, rng):
    jacobians = rng.normal(size=(2, 5, 3, 7))
    expected = [[oracle(each) for each in row] for row in jacobians]
    np.testing.assert_allclose(measure(jacobians), expected, rtol=1e-10)


def with_mass(robot, q):
    data = robot.model.createData()
    upper = np.triu(pin.crba(robot.model, data, q))
    return upper + np.triu(upper, 1).T


def test_dynamic_measures_of_an_arm(panda, rng):
    dynamic = panda.kinematics(mp.Task.position(), measure="dynamic")
    asada = panda.kinematics(mp.Task.position(), measure="asada")
    for q in panda.random_configuration(rng, size=5):
        jacobian, mass = dynamic.jacobian(q), with_mass(panda, q)
        image = jacobian @ np.linalg.inv(mass)
        assert dynamic.manipulability(q) == pytest.approx(np.sqrt(np.linalg.det(image @ image.T)), rel=1e-9)
        inertia = np.linalg.eigvalsh(np.linalg.inv(jacobian @ np.linalg.inv(mass) @ jacobian.T))
        assert asada.manipulability(q) == pytest.approx(inertia[0] / inertia[-1], rel=1e-9)


def test_penalty_of_the_position_limits(panda):
    kinematics = panda.kinematics(mp.Task.position(), measure=mp.measures.JointLimitPenalised(k=5.0))
    plain = panda.kinematics(mp.Task.position())
    middle = (panda.limits.lower + panda.limits.upper) / 2
    factor = 1 - np.exp(-5.0)
    assert kinematics.manipulability(middle) == pytest.approx(factor * plain.manipulability(middle))
    at_limit = middle.copy()
    at_limit[2] = panda.limits.upper[2]
    assert kinematics.manipulability(at_limit) == 0.0
    beyond = middle.copy()
    beyond[2] += 10
    assert kinematics.manipulability(beyond) == 0.0


def choose(name, rows):
    direction = np.arange(1.0, rows + 1)
    given = {"velocity_transmission": mp.measures.VelocityTransmission, "force_transmission": mp.measures.ForceTransmission}
    return given[name](direction=direction) if name in given else measure_of(name)


@pytest.mark.slow
@pytest.mark.parametrize("task", [mp.Task.pose(0.4), mp.Task.position(), mp.Task.pointing()], ids=lambda task: task.name)
@pytest.mark.parametrize("name", mp.measures.available_measures())
def test_derivatives_equal_central_differences(panda, name, task):
    kinematics = panda.kinematics(task, measure=choose(name, task.rows), compiled=False)
    step = 1e-5
    for q in panda.random_configuration(np.random.default_rng(5), size=2):
        moved = q + step * np.concatenate([np.eye(7), -np.eye(7)])
        values, slopes = kinematics.manipulability(moved), kinematics.gradient(moved)
        gradient = (values[:7] - values[7:]) / (2 * step)
        hessian = (slopes[:7] - slopes[7:]) / (2 * step)
        np.testing.assert_allclose(kinematics.gradient(q), gradient, atol=1e-6 * np.abs(gradient).max())
        np.testing.assert_allclose(kinematics.hessian(q), hessian, atol=1e-5 * np.abs(hessian).max())


@pytest.mark.parametrize("name", [n for n in mp.measures.available_measures() if n != "condition_number"])
def test_values_on_a_singularity_are_finite(name, planar):
    kinematics = planar.kinematics(measure=choose(name, 2))
    value = kinematics.manipulability([0.3, 0.0, 0.0])
    assert np.isfinite(value)
    if name in ("yoshikawa", "isotropy", "smallest_singular_value", "inverse_condition", "dynamic", "asada"):
        assert value == pytest.approx(0.0, abs=1e-7)


def test_transmission_along_what_is_left_on_a_singularity(planar):
    """Stretched along a slanted line, the tool moves across it as before and along it not at all."""
    angle = 0.3
    across, along = (-np.sin(angle), np.cos(angle)), (np.cos(angle), np.sin(angle))
    q = [angle, 0.0, 0.0]
    free = planar.kinematics(measure=mp.measures.VelocityTransmission(direction=across)).manipulability(q)
    assert free == pytest.approx(np.sqrt(9 + 4 + 1), rel=1e-6)
    stuck = planar.kinematics(measure=mp.measures.VelocityTransmission(direction=along)).manipulability(q)
    assert stuck == pytest.approx(0.0, abs=1e-7)


def test_singular_values_of_hard_matrices():
    """Equal, zero and widely spread values, against LAPACK."""
    from manipplan.measures.spectral import SingularValues

    rng = np.random.default_rng(3)
    symbols = ca.SX.sym("J", 6, 7)
    values = ca.Function("values", [symbols], [ca.vertcat(*SingularValues.of(symbols).sigma)])
    for spread in (
        [1, 1, 1, 1, 1, 1],
        [1, 1, 0.5, 0.5, 0.5, 0],
        [1, 1e-3, 1e-6, 1e-9, 1e-12, 0],
        [0] * 6,
        [3, 3, 3, 1e-8, 1e-8, 1e-8],
    ):
        left, right = (np.linalg.qr(rng.normal(size=(k, k)))[0] for k in (6, 7))
        matrix = left @ np.diag(np.array(spread, dtype=float)) @ right[:6]
        np.testing.assert_allclose(np.asarray(values(matrix)).ravel(), singular(matrix), atol=1e-14)
    for _ in range(200):
        matrix = rng.normal(size=(6, 7)) * 10 ** rng.uniform(-4, 4, size=(6, 1))
        expected = singular(matrix)
        np.testing.assert_allclose(np.asarray(values(matrix)).ravel(), expected, rtol=1e-12, atol=2e-15 * expected[0])


@pytest.mark.slow
def test_golden_numbers_of_the_panda(panda):
    """Numbers that the Robotics Toolbox for Python holds in its tests."""
    q = [0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4]
    raw = mp.Task.pose(1.0)
    assert panda.kinematics(raw, measure="inverse_condition").manipulability(q) == pytest.approx(0.11222, abs=5e-6)
    assert panda.kinematics(raw, measure="smallest_singular_value").manipulability(q) == pytest.approx(0.209013, abs=5e-7)


def test_units():
    assert mp.measures.Yoshikawa().unit(mp.Task.position()) == "m^3"
    assert mp.measures.SmallestSingularValue().unit(mp.Task.pose(0.5)) == "m"
    assert mp.measures.SmallestSingularValue().unit(mp.Task.orientation()) == "1"
    assert "mixed" in mp.measures.SmallestSingularValue().unit(mp.Task.pose(1.0))
    assert mp.Task.direction((1, 0, 0)).unit == "m"
    for name in mp.measures.available_measures():
        measure = choose(name, 6)
        assert measure.unit(mp.Task.pose()) and measure.formula and measure.source


def test_ellipsoids(panda, rng):
    q = panda.random_configuration(rng)
    kinematics = panda.kinematics(mp.Task.position())
    jacobian, mass = kinematics.jacobian(q), kinematics.mass_matrix(q)
    velocity, force, dynamic = (
        mp.measures.velocity_ellipsoid(jacobian),
        mp.measures.force_ellipsoid(jacobian),
        mp.measures.dynamic_ellipsoid(jacobian, mass),
    )
    np.testing.assert_allclose(velocity.radii[::-1] * force.radii, 1.0)
    np.testing.assert_allclose(np.abs(np.sum(velocity.axes[:, ::-1] * force.axes, axis=0)), 1.0)
    assert velocity.volume == pytest.approx(4 / 3 * np.pi * kinematics.manipulability(q))
    dynamic_value = panda.kinematics(mp.Task.position(), measure="dynamic").manipulability(q)
    assert dynamic.volume == pytest.approx(4 / 3 * np.pi * dynamic_value)
    torque = rng.normal(size=7)
    inside = jacobian @ np.linalg.solve(mass, torque / np.linalg.norm(torque))
    assert np.linalg.norm(np.linalg.solve(dynamic.axes * dynamic.radii, inside)) <= 1 + 1e-12
    assert mp.measures.force_ellipsoid([[1.0, 0.0], [0.0, 0.0]]).radii.tolist() == [np.inf, 1.0]
    with pytest.raises(mp.errors.InvalidInputError, match="mass_matrix"):
        mp.measures.dynamic_ellipsoid(jacobian, -mass)


def test_wrong_measures(panda):
    with pytest.raises(mp.errors.UnknownNameError, match="yoshikawa"):
        panda.kinematics(measure="yosikawa")
    with pytest.raises(mp.errors.InvalidInputError, match="needs a direction"):
        panda.kinematics(measure="velocity_transmission")
    with pytest.raises(mp.errors.InvalidInputError, match="3 numbers, one per task row"):
        panda.kinematics(mp.Task.position(), measure=mp.measures.VelocityTransmission(direction=(1, 0))).manipulability(
            np.zeros(7)
        )
    with pytest.raises(mp.errors.InvalidInputError, match="length of direction"):
        mp.measures.ForceTransmission(direction=(0, 0, 0))
    with pytest.raises(mp.errors.InvalidInputError, match="weights"):
        mp.measures.FrobeniusNorm(weights=[1, -1])
    with pytest.raises(mp.errors.InvalidInputError, match="weights"):
        panda.kinematics(measure=mp.measures.FrobeniusNorm(weights=[1, 1])).manipulability(np.zeros(7))
    with pytest.raises(mp.errors.InvalidInputError, match="regularisation"):
        mp.measures.Yoshikawa(regularisation=0.0)
    with pytest.raises(mp.errors.InvalidInputError, match="identically zero"):
        mp.measures.Yoshikawa()(np.ones((3, 2)))
    with pytest.raises(mp.errors.InvalidInputError, match="finite matrices"):
        mp.measures.Yoshikawa()([[np.nan]])
    with pytest.raises(mp.errors.InvalidInputError, match="measure"):
        panda.kinematics(measure=3)


def test_drawn_ellipsoids_lie_where_the_matrix_says(panda):
    """In the plane the outline's points, in space the surface's, are images of the unit ball."""
    from matplotlib.figure import Figure

    from manipplan.viz.arm import plot_ellipsoid

    jacobian = np.array([[1.0, 0.5, 0.0], [0.0, 1.0, 0.3]])
    ax = Figure().add_subplot()
    plot_ellipsoid(mp.measures.velocity_ellipsoid(jacobian), (1.0, 2.0), ax=ax, scale=0.5, axes=True)
    outline = (ax.patches[0].get_path().vertices[:-1] - (1.0, 2.0)) / 0.5
    form = np.linalg.inv(jacobian @ jacobian.T)
    np.testing.assert_allclose(np.einsum("ki,ij,kj->k", outline, form, outline), 1.0)
    space = Figure().add_subplot(projection="3d")
    plot_ellipsoid(
        mp.measures.velocity_ellipsoid(panda.kinematics(mp.Task.position()).jacobian(panda.neutral)), (0, 0, 0), ax=space
    )
    assert len(space.collections) == 1
    stretched = mp.measures.force_ellipsoid([[1.0, 0.0], [0.0, 0.0]])
    with pytest.raises(mp.errors.InvalidInputError, match="largest"):
        plot_ellipsoid(stretched, (0, 0), ax=ax)
    plot_ellipsoid(stretched, (0, 0), ax=ax, largest=4.0)
    with pytest.raises(mp.errors.InvalidInputError, match="2 or 3 radii"):
        plot_ellipsoid(mp.measures.velocity_ellipsoid(np.eye(6)), np.zeros(6), ax=ax)


def test_sources_are_in_the_bibliography():
    from pathlib import Path

    from manipplan.measures.names import MEASURES

    bibliography = (Path(__file__).parents[2] / "docs" / "references.bib").read_text()
    for kind in MEASURES.values():
        assert f"{{{kind.source}," in bibliography


class Several(mp.measures.Measure):
    """A measure that gives three numbers by mistake."""

    name, formula, source = "several", "", ""

    def unit(self, task):
        return "1"

    def value(self, posture):
        return posture.jacobian[:3, 0]


def test_a_measure_that_is_no_number_is_refused(panda):
    with pytest.raises(mp.errors.InvalidInputError, match="several"):
        panda.kinematics(measure=Several()).manipulability(np.zeros((100, 7)))


@pytest.mark.parametrize(
    "measure", [mp.measures.LogDet(), mp.measures.ConditionNumber(), mp.measures.ForceTransmission(direction=(1, 0, 0))]
)
def test_limits_penalise_only_measures_that_grow(measure):
    with pytest.raises(mp.errors.InvalidInputError, match=measure.name):
        mp.measures.JointLimitPenalised(measure=measure)


@pytest.mark.parametrize("weights", [np.inf, [1.0, np.inf], [], 0.0, [[1.0], [1.0, 2.0]]])
def test_weights_are_finite_and_positive(weights):
    with pytest.raises(mp.errors.InvalidInputError, match="weights"):
        mp.measures.FrobeniusNorm(weights=weights)


@pytest.mark.parametrize("measure", ["asada", "isotropy", "inverse_condition"])
def test_an_arm_that_cannot_move_at_all_counts_as_singular(measure):
    planar = mp.planar_arm([0.3, 0.3, 0.3])
    upwards = planar.kinematics(mp.Task.direction((0.0, 0.0, 1.0)), measure=measure, compiled=False)
    assert upwards.manipulability([0.1, 0.2, 0.3]) == 0


def test_log_det_of_fewer_joints_than_rows_has_a_gradient(rng):
    robot = mp.load_robot("so100")
    kinematics = robot.kinematics(mp.Task.pose(0.5), measure="log_det")
    q = robot.random_configuration(rng)

    def value(x):
        return np.log(singular(kinematics.jacobian(x))[: robot.n]).sum()

    steps = 1e-5 * np.eye(robot.n)
    wanted = [(value(q + step) - value(q - step)) / 2e-5 for step in steps]
    np.testing.assert_allclose(kinematics.gradient(q), wanted, rtol=1e-3, atol=1e-3)
