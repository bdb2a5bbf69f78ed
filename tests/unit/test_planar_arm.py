"""The planar arm's closed forms against Pinocchio, the general kinematics, and what kth2012 prints."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan import planar

UNIT = planar.PlanarArm([1.0, 1.0, 1.0])
ODD = planar.PlanarArm([0.9, 0.4, 0.7, 0.2])


def test_positions_and_jacobian_are_those_of_the_robot(rng):
    robot = ODD.robot()
    data = robot.model.createData()
    for q in rng.uniform(-7, 7, (20, 4)):
        pin.framesForwardKinematics(robot.model, data, q)
        tool = data.oMf[robot.model.getFrameId("tool")]
        np.testing.assert_allclose(ODD.position(q), tool.translation[:2], atol=1e-12)
        turned = pin.log3(tool.rotation @ pin.exp3(np.array([0, 0, -ODD.orientation(q)])))
        np.testing.assert_allclose(turned, 0, atol=1e-7)
        joints = np.array([data.oMi[i].translation[:2] for i in range(1, 5)])
        np.testing.assert_allclose(ODD.joint_positions(q)[:-1], joints, atol=1e-12)
        jacobian = pin.computeFrameJacobian(robot.model, data, q, robot.model.getFrameId("tool"), pin.LOCAL_WORLD_ALIGNED)
        np.testing.assert_allclose(ODD.pose_jacobian(q), jacobian[[0, 1, 5]], atol=1e-12)


def test_manipulability_gradient_and_hessian_are_those_of_the_general_kinematics(rng):
    kinematics = ODD.robot().kinematics(mp.Task.planar())
    q = rng.uniform(-3, 3, (30, 4))
    np.testing.assert_allclose(planar.manipulability(ODD, q), kinematics.manipulability(q), atol=1e-12)
    np.testing.assert_allclose(planar.manipulability_gradient(ODD, q), kinematics.gradient(q), atol=1e-9)
    np.testing.assert_allclose(planar.manipulability_hessian(ODD, q), kinematics.hessian(q), atol=1e-7)


def test_batches_keep_their_shape(rng):
    q = rng.uniform(-3, 3, (2, 5, 4))
    assert ODD.jacobian(q).shape == (2, 5, 2, 4)
    for of, shape in (
        (planar.squared_manipulability, ()),
        (planar.squared_manipulability_gradient, (4,)),
        (planar.squared_manipulability_hessian, (4, 4)),
        (planar.frobenius_norm, ()),
        (planar.inverse_condition, ()),
    ):
        many = of(ODD, q)
        assert many.shape == (2, 5, *shape)
        np.testing.assert_allclose(many[1, 3], of(ODD, q[1, 3]), atol=1e-14)


def test_frobenius_norm_as_printed_needs_its_range_corrected(rng):
    """(4.2) in kth2012: the sum over m has to begin at p + 1; as printed, from i + 1, it is another function."""
    n, lengths = ODD.n, ODD.lengths
    for q in rng.uniform(-3, 3, (5, n)):

        def literal(begin, q=q):
            double = sum(
                lengths[p - 1] * lengths[m - 1] * np.cos(q[p:m].sum())
                for i in range(1, n)
                for p in range(i, n + 1)
                for m in range(begin(i, p), n + 1)
            )
            return np.sqrt(sum(i * lengths[i - 1] ** 2 for i in range(1, n + 1)) / 2 + double)

        truth = np.sqrt(np.trace(ODD.jacobian(q) @ ODD.jacobian(q).T) / 2)
        np.testing.assert_allclose(planar.frobenius_norm(ODD, q), truth, rtol=1e-12)
        np.testing.assert_allclose(literal(lambda i, p: p + 1), truth, rtol=1e-12)
        assert abs(literal(lambda i, p: i + 1) - truth) > 0.05


def test_series_of_unit_links_is_the_corrected_equation():
    """(5.2) in kth2012 with constant 5/2 and -cos 2θ_3; the print's form has its maximum elsewhere."""
    series = planar.squared_manipulability_series(UNIT)
    found = {tuple(int(x) for x in k): c for k, c in zip(series.frequencies, series.cosine, strict=True)}
    assert found == {
        (0, 0): 2.5, (1, 0): 1.0, (2, 0): -0.5, (0, 1): 1.0, (0, 2): -1.0, (2, 2): -1.0, (2, 1): -1.0, (1, 2): -1.0,
    }  # fmt: skip
    assert not series.sine.any()
    found[0, 2] = -0.5
    printed = planar.TrigonometricPolynomial(
        frequencies=np.array(list(found), dtype=float), cosine=np.array(list(found.values())), sine=np.zeros(8)
    )
    points = planar.torus_zeros([printed.derivative(0), printed.derivative(1)]).points
    np.testing.assert_allclose(np.abs(points[printed(points).argmax()]), 0.936, atol=5e-4)


def test_singular_postures_are_all_there_are(rng):
    rows = planar.singular_postures(ODD)
    assert rows.shape == (8, 4)
    np.testing.assert_allclose(planar.manipulability(ODD, rows), 0, atol=1e-15)
    np.testing.assert_allclose(planar.singular_radii(ODD), ODD.radius(rows), atol=1e-14)
    assert planar.singular_radii(ODD)[0] == pytest.approx(2.2)
    # μ grows at least in proportion to the distance from that set: sampled, μ vanishes nowhere else
    q = rng.uniform(-np.pi, np.pi, (200_000, 4))
    assert (planar.manipulability(ODD, q) / planar.singular_distance(ODD, q)).min() > 0.01
    brute = np.linalg.norm(np.angle(np.exp(1j * (q[:200, None, 1:] - rows[None, :, 1:]))), axis=-1).min(axis=1)
    np.testing.assert_allclose(planar.singular_distance(ODD, q[:200]), brute, atol=1e-12)


def test_ellipses_are_dual(rng):
    for q in rng.uniform(-3, 3, (10, 3)):
        velocity, force = planar.velocity_ellipse(UNIT, q), planar.force_ellipse(UNIT, q)
        np.testing.assert_allclose(velocity.radii * force.radii[::-1], 1.0, rtol=1e-9)
        np.testing.assert_allclose(np.abs(velocity.axes.T @ force.axes), [[0, 1], [1, 0]], atol=1e-9)
        assert velocity.volume == pytest.approx(np.pi * planar.manipulability(UNIT, q))
        assert velocity.radii[1] / velocity.radii[0] == pytest.approx(planar.inverse_condition(UNIT, q))
        gram = UNIT.jacobian(q) @ UNIT.jacobian(q).T
        for same, matrix in ((velocity, np.linalg.inv(gram)), (force, gram)):  # (2.22), (2.25)
            found = planar.matrix_ellipsoid(matrix)
            np.testing.assert_allclose(found.radii, same.radii, rtol=1e-8)
            np.testing.assert_allclose(np.abs(np.diag(found.axes.T @ same.axes)), 1, atol=1e-8)


def test_an_ellipsoid_on_its_principal_axes(rng):
    """Appendices A and B in kth2012: points on the axes fulfil xᵀAx = 1, and the volume counted by throwing points."""
    root = rng.normal(size=(3, 3))
    a = root @ root.T + 0.3 * np.eye(3)
    body = planar.matrix_ellipsoid(a)
    ends = body.axes * body.radii
    np.testing.assert_allclose(ends.T @ a @ ends, np.eye(3), atol=1e-10)
    box = body.radii.max()
    points = rng.uniform(-box, box, (400_000, 3))
    share = (np.einsum("ki,ij,kj->k", points, a, points) <= 1).mean()
    assert body.volume == pytest.approx(share * (2 * box) ** 3, rel=0.03)
    assert body.volume == pytest.approx(4 / 3 * np.pi * np.sqrt(np.linalg.det(np.linalg.inv(a))))
    assert np.isposinf(planar.matrix_ellipsoid([[1.0, 0.0], [0.0, 0.0]]).radii[0])


@pytest.mark.slow
@pytest.mark.parametrize("n", [2, 3, 5, 8])
def test_theorems_hold(n):
    for theorem in (planar.frobenius_theorem(n), planar.manipulability_theorem(n), planar.condition_theorem(n)):
        assert theorem.holds
        assert theorem.n == n
        assert len(theorem.steps) >= 2


def test_the_proof_engine_refuses_what_is_false():
    from manipplan.planar.theorems import _Symbols, vanishes

    arm = _Symbols.of(3)
    import casadi as ca

    assert not arm.vanishes(arm.turn(arm.x[0] ** 2))  # one entry of J does depend on θ_1
    assert not arm.vanishes(arm.turn(ca.sumsqr(arm.x)))
    assert not arm.vanishes(ca.sumsqr(arm.x) + ca.sumsqr(arm.y) - sum(i**2 for i in arm.lengths))
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    assert vanishes((x + y) ** 3 - x**3 - 3 * x**2 * y - 3 * x * y**2 - y**3, ca.vertcat(x, y))
    assert not vanishes((x + y) ** 3 - x**3 - 3 * x**2 * y - 2 * x * y**2 - y**3, ca.vertcat(x, y))
    assert not vanishes(ca.sin(x) - x, ca.vertcat(x, y))  # not a polynomial


@pytest.mark.parametrize("lengths", [[1, 1], [1, 1, 1], [0.3, 2.0, 0.1, 0.5, 1.0]])
def test_manipulability_is_not_convex(lengths):
    shown = planar.convexity_counterexample(planar.PlanarArm(lengths))
    assert shown.holds
    np.testing.assert_allclose(shown.manipulability[[0, 2]], 0, atol=1e-15)
    np.testing.assert_allclose(shown.manipulability[1], shown.closed_form, rtol=1e-12)
    np.testing.assert_allclose(shown.q[1], shown.q[[0, 2]].mean(axis=0))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: planar.PlanarArm([1.0, -1.0]), "lengths: got"),
        (lambda: planar.PlanarArm([1.0, 0.0, 1.0]), "lengths: got"),
        (lambda: planar.PlanarArm([1.0, np.inf]), "lengths: got"),
        (lambda: planar.PlanarArm([1.0]), "at least two"),
        (lambda: planar.PlanarArm("ab"), "lengths: got"),
        (lambda: UNIT.position([0.0, 1.0]), "q: got"),
        (lambda: UNIT.jacobian([0.0, np.nan, 0.0]), "q: got"),
        (lambda: planar.manipulability_gradient(UNIT, [0.3, 0.0, np.pi]), "not singular"),
        (lambda: planar.velocity_ellipse(UNIT, np.zeros((2, 3))), "one posture"),
        (lambda: planar.matrix_ellipsoid([[1.0, 2.0], [0.0, 1.0]]), "symmetric"),
        (lambda: planar.matrix_ellipsoid([[1.0, 2.0], [2.0, 1.0]]), "no negative eigenvalue"),
        (lambda: planar.frobenius_theorem(1), "n: got 1"),
    ],
)
def test_wrong_arguments(call, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        call()
