"""The compiled arithmetic of the steps of a descent, against NumPy's."""

import numpy as np
import pytest

from manipplan.optimize import steps
from manipplan.optimize.descent import LEAST_CURVATURE, ROW_SPACING, convex
from manipplan.paths.rounding import with_bits

M, N, F = 23, 7, 5


@pytest.fixture
def sums(rng):
    """Weights, values and slopes of a rule, and gradients and symmetric Hessians of e."""
    hessians = rng.normal(size=(M, 2 * N, 2 * N))
    values, slopes = rng.normal(size=(2, M, F))
    return rng.random(M), values, slopes, rng.normal(size=(M, 2 * N)), hessians + hessians.transpose(0, 2, 1)


def test_points(rng):
    line, values, z = rng.normal(size=(M, N)), rng.normal(size=(M, F)), rng.normal(size=(F, N))
    np.testing.assert_allclose(steps.points(line, values, z), line + values @ z, atol=1e-13)
    np.testing.assert_allclose(steps.points(line, values, np.asfortranarray(z)), line + values @ z, atol=1e-13)


def test_derivatives_of_a_sum(sums):
    weights, values, slopes, gradients, hessians = sums
    both = np.stack([values, slopes], axis=1)  # (M, 2, F)
    gradient = np.einsum("i,ipa,ipj->aj", weights, both, gradients.reshape(M, 2, N))
    hessian = np.einsum("i,ipa,iqb,ipjqk->ajbk", weights, both, both, hessians.reshape(M, 2, N, 2, N)).reshape(F * N, F * N)
    np.testing.assert_allclose(steps.gradient(weights, values, slopes, gradients), gradient, atol=1e-12)
    each = np.concatenate([gradients, hessians.reshape(M, -1)], axis=1)
    first, second = steps.derivatives(N, weights, values, slopes, each)
    np.testing.assert_allclose(first, gradient, atol=1e-12)
    np.testing.assert_allclose(second, hessian, atol=1e-11)
    np.testing.assert_array_equal(second, second.T)


def test_limit_rows(rng):
    points, directions = rng.uniform(-1.2, 1.2, (M, N)), rng.normal(size=(M, F))
    lower, upper, change = np.full(N, -1.0), np.full(N, 1.0), rng.random(M)
    upper[2] = np.inf
    expected = max((lower - points).max(), (points - upper).max(), 0.0)
    assert steps.violation(points, lower, upper) == pytest.approx(expected)
    assert steps.violation(0.5 * points, lower, upper) == 0.0
    value, jacobian = steps.limit_rows(points, directions, lower, upper, change)
    rows = []
    for distance, sign in ((points - lower, 1.0), (upper - points, -1.0)):
        for k, j in zip(*np.nonzero(distance < change[:, None]), strict=True):
            rows.append((distance[k, j], sign * np.outer(directions[k], np.eye(N)[j]).ravel()))
    assert len(value) == len(rows) > 50
    np.testing.assert_allclose(value, [row[0] for row in rows])
    np.testing.assert_allclose(jacobian, [row[1] for row in rows])


def test_curvature_of_a_least_distance(rng):
    """d(z) = min over s of a quadratic in q and s, whose Hessian is known in closed form by the implicit function theorem."""
    r, multipliers, moves = 4, rng.random(4), np.array([True, False, True, True])
    values, slopes = rng.normal(size=(2, r, F))
    speeds, bends, gradients = rng.normal(size=(3, r, N))
    hessians = rng.normal(size=(r, N, N))
    hessians += hessians.transpose(0, 2, 1)
    gradients[2] -= 50 * bends[2]  # its second derivative by s is negative: it does not count as a minimum
    expected = np.zeros((F * N, F * N))
    for i in range(r):
        expected += multipliers[i] * np.einsum("a,c,bd->abcd", values[i], values[i], hessians[i]).reshape(F * N, F * N)
        second = speeds[i] @ hessians[i] @ speeds[i] + gradients[i] @ bends[i]
        if moves[i] and second > 1e-3:
            change = (np.outer(slopes[i], gradients[i]) + np.outer(values[i], hessians[i] @ speeds[i])).ravel()
            expected -= multipliers[i] / second * np.outer(change, change)
    found = steps.curvature(multipliers, values, slopes, speeds, bends, gradients, hessians, moves, 1e-3)
    np.testing.assert_allclose(found, expected, rtol=1e-10, atol=1e-10 * np.abs(expected).max())


def test_rows_that_a_step_can_reach(rng):
    value, jacobian = rng.uniform(-0.5, 3.0, 40), rng.normal(size=(40, F * N))
    chosen, least, rows = steps.rows_within(value, jacobian, 0.05, ROW_SPACING, 24)
    wanted = np.flatnonzero(value < 0.05 * np.abs(jacobian).sum(axis=1) + ROW_SPACING)
    np.testing.assert_array_equal(chosen, wanted)
    assert 0 < len(wanted) < 40
    np.testing.assert_array_equal(least, -np.rint(value[wanted] / ROW_SPACING) * ROW_SPACING)
    np.testing.assert_array_equal(rows, with_bits(jacobian[wanted], 24))
    for empty in (
        steps.rows_within(value + 100, jacobian, 0.05, ROW_SPACING, 24),
        steps.rows_within(value[:0], jacobian[:0], 1.0, 1e-9, 24),
    ):
        assert [len(each) for each in empty] == [0, 0, 0]


@pytest.mark.parametrize("least", [1.0, 1e-5, 1e-7, 0.0, -1.0])
def test_a_matrix_is_changed_only_where_it_is_not_convex(rng, least):
    vectors = np.linalg.qr(rng.normal(size=(12, 12))).Q
    values = np.append(rng.uniform(1.0, 2.0, 11), least)
    matrix = (vectors * values) @ vectors.T + np.triu(1e-3 * np.ones((12, 12)), 1) - np.tril(1e-3 * np.ones((12, 12)), -1)
    symmetric = (matrix + matrix.T) / 2
    unchanged = steps.convex_part(matrix, LEAST_CURVATURE)
    assert (unchanged is not None) == (least >= 1e-5)
    found = np.linalg.eigvalsh(convex(matrix))
    assert found.min() == pytest.approx(max(least, LEAST_CURVATURE * values.max()), rel=1e-6)
    if unchanged is not None:
        np.testing.assert_array_equal(unchanged, symmetric)


def test_arrays_that_are_not_contiguous_are_refused(rng):
    """A wrong memory layout would give wrong numbers."""
    with pytest.raises(TypeError, match="contiguous"):
        steps.points(np.asfortranarray(rng.normal(size=(M, N))), rng.normal(size=(M, F)), rng.normal(size=(F, N)))
