"""Laws that hold for every arm, on random planar and spatial chains."""

import numpy as np
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.timing.verify import limit_use

angles = st.floats(-np.pi, np.pi)
lengths = st.lists(st.floats(0.1, 2.0), min_size=2, max_size=6)


@examples(40)
@given(lengths, st.data())
def test_planar_manipulability_does_not_depend_on_the_first_angle(sizes, data):
    """Theorem 4.2 of kth2012."""
    arm = mp.planar_arm(sizes)
    q = np.array(data.draw(st.lists(angles, min_size=arm.n, max_size=arm.n)))
    turned = q.copy()
    turned[0] += data.draw(angles)
    kinematics = arm.kinematics()
    np.testing.assert_allclose(kinematics.manipulability(turned), kinematics.manipulability(q), atol=1e-9)


@examples(40)
@given(lengths, st.floats(0.1, 10.0), st.data())
def test_planar_manipulability_scales_with_the_square_of_the_lengths(sizes, factor, data):
    arm, larger = mp.planar_arm(sizes), mp.planar_arm(factor * np.array(sizes))
    q = data.draw(st.lists(angles, min_size=arm.n, max_size=arm.n))
    expected = factor**2 * arm.kinematics().manipulability(q)
    np.testing.assert_allclose(larger.kinematics().manipulability(q), expected, rtol=1e-7, atol=1e-9)


@examples(25)
@given(lengths, st.data())
def test_manipulability_is_the_product_of_the_singular_values(sizes, data):
    arm = mp.planar_arm(sizes)
    q = data.draw(st.lists(angles, min_size=arm.n, max_size=arm.n))
    singular = np.linalg.svd(arm.kinematics().jacobian(q))[1]
    np.testing.assert_allclose(arm.kinematics().manipulability(q), singular.prod(), rtol=1e-9, atol=1e-12)


@examples(25)
@given(st.integers(0, 2**32 - 1), st.integers(1, 6), st.floats(1e-3, 30.0))
def test_retimed_motion_never_exceeds_a_limit(seed, degree, size):
    """Random paths from tiny to huge, with corners, on an arm with random limits."""
    rng = np.random.default_rng(seed)
    limits = rng.uniform(0.2, 5.0, (2, 3))
    arm = mp.planar_arm([1.0, 1.0, 1.0]).with_limits(velocity=limits[0], acceleration=limits[1])
    control = size * rng.normal(size=(2, degree + 1, 3))
    control[1, 0] = control[0, -1]
    path = mp.JointPath(breaks=[0.0, 0.4, 1.0], control=control)
    trajectory = mp.retime(path, arm)
    use = limit_use(trajectory, arm.limits)
    assert max(use["velocity"].ratio, use["acceleration"].ratio) <= 1
    np.testing.assert_allclose(trajectory.q[-1], path.goal, atol=1e-9 * max(size, 1))
