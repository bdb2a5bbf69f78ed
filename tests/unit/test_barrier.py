"""The barrier method of timing with jerk: its banded algebra against dense matrices, its gradient against differences."""

import numpy as np
import pytest
from barrier_oracle import BandedModel, model_of, slacks_of, time_of

import manipplan as mp
from manipplan.timing.dynamics import ArcLength, path_dynamics
from manipplan.timing.jerk import JerkProblem, applied, motion_inside
from manipplan.timing.piece import first_grid
from manipplan.timing.stops import LimitsAlong


def dense(rows, at, count):
    """The rows as matrices (r, k, count)."""
    rows = [row.reshape(len(row), -1) for row in rows]
    matrix = np.zeros((rows[0].shape[1], len(rows[0]), count))
    for m, row in enumerate(rows):
        for k, values in enumerate(row):
            matrix[:, k, at + k + m] = values
    return matrix.reshape(-1, count)


def test_a_banded_model_equals_the_dense_one(rng):
    count = 9
    model, gradient, hessian = BandedModel(count), np.zeros(count), np.zeros((count, count))
    for neighbours, places, rows, at in ((1, 9, (), 0), (2, 8, (4,), 0), (3, 7, (2,), 0), (2, 1, (), 7)):
        row = tuple(rng.normal(size=(places, *rows)) for _ in range(neighbours))
        slope, bend = rng.normal(size=(places, *rows)), rng.uniform(1, 2, size=(places, *rows))
        model.add(row, slope, bend, at=at)
        matrix = dense(row, at, count)
        gradient += matrix.T @ slope.reshape(places, -1).T.ravel()
        hessian += matrix.T @ np.diag(bend.reshape(places, -1).T.ravel()) @ matrix
        c = rng.normal(size=count)
        if at == 0:
            np.testing.assert_allclose(applied(row, c).reshape(places, -1).T.ravel(), matrix @ c)
    first, last = 0.3, -0.7
    model.tie_ends(first, last)
    tied = np.vstack([first * np.eye(count - 2)[0], np.eye(count - 2), last * np.eye(count - 2)[-1]])
    step, decrement = model.newton_step()
    np.testing.assert_allclose(model.gradient, tied.T @ gradient)
    np.testing.assert_allclose(step, -np.linalg.solve(tied.T @ hessian @ tied, tied.T @ gradient), rtol=1e-9)
    assert decrement == pytest.approx(-(tied.T @ gradient) @ step)


@pytest.mark.parametrize(("start", "end"), [(0.0, 0.0), (0.1, 0.0), (0.1, 0.2)])
def test_the_gradient_of_the_merit_is_that_of_differences(planar, rng, start, end):
    limits = planar.with_limits(velocity=2.0, acceleration=4.0).limits.with_changes({"jerk": 60.0})
    curve = ArcLength(mp.JointPath(breaks=[0.0, 1.0], control=rng.uniform(-1, 1, (1, 4, 3))), 0.0, 1.0)
    points = first_grid(curve, 40, np.empty(0), (start == 0, end == 0))
    asked = path_dynamics(curve, points, LimitsAlong(limits, (), np.empty((0, 2))), None, None)
    ends = [(each / asked.speed_unit) ** 2 for each in (start, end)]
    problem = JerkProblem(asked, np.full((len(points) - 1, 3), 60.0), *ends)
    z, weight = motion_inside(problem, None), 7.0

    def merit(z):
        slacks = slacks_of(problem, problem.coefficients(z))
        return weight * time_of(problem, slacks.pace) - sum(np.log(each[np.isfinite(each)]).sum() for each in slacks.every)

    gradient = model_of(problem, slacks_of(problem, problem.coefficients(z)), weight).gradient
    eps = 1e-5 * z
    differences = [(merit(z + e) - merit(z - e)) / (2 * e.max()) for e in np.diag(eps)]
    np.testing.assert_allclose(gradient * z, differences * z, rtol=1e-4, atol=1e-5 * np.abs(gradient * z).max())
