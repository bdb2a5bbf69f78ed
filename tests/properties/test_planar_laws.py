"""Laws of the planar arm's closed forms, for any number of links from two to eight and any lengths."""

import numpy as np
import pinocchio as pin
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

from manipplan import planar

angles = st.floats(-np.pi, np.pi)
lengths = st.lists(st.floats(0.05, 3.0), min_size=2, max_size=8)


@st.composite
def postures(draw, sizes=lengths):
    arm = planar.PlanarArm(draw(sizes))
    return arm, np.array(draw(st.lists(angles, min_size=arm.n, max_size=arm.n)))


def jacobian(arm, q):
    """Of Pinocchio, the two rows of position."""
    robot = arm.robot()
    frame = robot.model.getFrameId("tool")
    return pin.computeFrameJacobian(robot.model, robot.model.createData(), q, frame, pin.LOCAL_WORLD_ALIGNED)[:2]


@examples(60)
@given(postures())
def test_measures_are_those_of_the_singular_values(case):
    arm, q = case
    found = jacobian(arm, q)
    np.testing.assert_allclose(arm.jacobian(q), found, atol=1e-12)
    sigma = np.linalg.svd(found, compute_uv=False)
    size = arm.lengths.sum()
    np.testing.assert_allclose(planar.manipulability(arm, q), sigma.prod(), atol=1e-12 * arm.n * size**2)
    np.testing.assert_allclose(planar.frobenius_norm(arm, q), np.linalg.norm(sigma) / np.sqrt(2), rtol=1e-10)
    np.testing.assert_allclose(planar.inverse_condition(arm, q), sigma[1] / sigma[0], atol=1e-10)
    shape = planar.velocity_ellipse(arm, q)
    np.testing.assert_allclose(shape.radii, sigma, atol=1e-12 * size)


@examples(60)
@given(postures())
def test_derivatives_are_those_of_differences(case):
    """Central differences of det(J Jᵀ) of Pinocchio's J, and of our gradient."""
    arm, q = case
    h, size = 1e-4, arm.lengths.sum() ** 4

    def square(q):
        found = jacobian(arm, q)
        return np.linalg.det(found @ found.T)

    slope = [(square(q + h * e) - square(q - h * e)) / (2 * h) for e in np.eye(arm.n)]
    np.testing.assert_allclose(planar.squared_manipulability_gradient(arm, q), slope, atol=1e-6 * size)
    gradient = planar.squared_manipulability_gradient
    bend = [(gradient(arm, q + h * e) - gradient(arm, q - h * e)) / (2 * h) for e in np.eye(arm.n)]
    hessian = planar.squared_manipulability_hessian(arm, q)
    np.testing.assert_allclose(hessian, bend, atol=1e-5 * size)
    np.testing.assert_allclose(hessian, hessian.T, atol=1e-12 * size)


@examples(60)
@given(postures(), angles)
def test_nothing_depends_on_the_first_angle(case, turn):
    """Theorems 4.1, 4.2 and 4.4 of kth2012."""
    arm, q = case
    turned = q + turn * np.eye(arm.n)[0]
    for measure in (planar.manipulability, planar.frobenius_norm, planar.inverse_condition):
        scale = max(1.0, arm.lengths.sum() ** 2)
        np.testing.assert_allclose(measure(arm, turned), measure(arm, q), atol=1e-10 * scale)
    assert planar.squared_manipulability_gradient(arm, q)[0] == 0
    assert not planar.squared_manipulability_hessian(arm, q)[0].any()
    assert np.abs(arm.radius(turned) - arm.radius(q)) < 1e-12 * arm.lengths.sum()


@examples(40)
@given(postures(st.lists(st.floats(0.05, 3.0), min_size=2, max_size=6)))
def test_series_are_the_functions(case):
    arm, q = case
    size = arm.lengths.sum()
    square = planar.squared_manipulability(arm, q)
    np.testing.assert_allclose(planar.squared_manipulability_series(arm)(q[1:]), square, atol=1e-11 * size**4)
    np.testing.assert_allclose(planar.squared_radius_series(arm)(q[1:]), arm.radius(q) ** 2, atol=1e-12 * size**2)


@examples(60)
@given(postures())
def test_no_arm_passes_the_bound_of_its_length(case):
    arm, q = case
    bound = planar.manipulability_bound(arm.n, float(arm.lengths.sum()))
    assert planar.manipulability(arm, q) <= bound * (1 + 1e-12)


@examples(40)
@given(postures(st.lists(st.floats(0.05, 3.0), min_size=3, max_size=3)))
def test_inverse_of_forward(case):
    arm, q = case
    position, phi = arm.position(q), float(arm.orientation(q))
    found = planar.pose_postures(arm, position, phi)
    assert 1 <= len(found) <= 2
    size = arm.lengths.sum()
    np.testing.assert_allclose(arm.position(found), np.tile(position, (len(found), 1)), atol=1e-6 * size)
    np.testing.assert_allclose(np.exp(1j * arm.orientation(found)), np.exp(1j * phi), atol=1e-12)
    assert planar.is_reachable(arm, position, q - 1e-3, q + 1e-3)
    ring = planar.reachable_annulus(arm)
    assert ring.inner - 1e-12 * size <= arm.radius(q) <= ring.outer + 1e-12 * size


@examples(25)
@given(st.lists(st.floats(0.1, 2.0), min_size=3, max_size=3), st.floats(0.0, 1.0), st.integers(0, 2**31))
def test_optimum_at_a_radius_is_above_every_posture_there(sizes, share, seed):
    arm = planar.PlanarArm(sizes)
    ring = planar.reachable_annulus(arm)
    radius = ring.inner + share * (ring.outer - ring.inner)
    best = planar.stationary_postures(arm, radius=radius).best
    size = arm.lengths.sum()
    assert np.abs(best.radius - radius).max() < 1e-9 * size
    rng = np.random.default_rng(seed)
    family = planar.position_family(arm, [radius, 0.0])
    for begin, end in family.orientations:
        for phi in rng.uniform(begin, end, 40):
            mu = planar.manipulability(arm, family(phi)).max(initial=0.0)
            assert mu <= best.manipulability[0] + 1e-6 * size**2  # a radius beside a singular one is snapped to it
