"""The metric W of joint space: the relative cost of moving each joint."""

import numpy as np
from numpy.typing import ArrayLike

from manipplan.support.checks import Array, number_array
from manipplan.support.errors import InvalidInputError

#: Minimum ratio of the smallest eigenvalue of W to the largest.
DEFINITE = 1e-12
#: Upper bound on the entries of W, so that their squares do not overflow.
LARGEST = 1e150
#: Minimum of the largest entry of W: speeds below 1e-9 count as none.
SMALLEST = 1e-12


def metric_matrix(argument: str, value: ArrayLike | None, n: int) -> Array | None:
    """`value`, weights (n,) > 0 or a symmetric positive definite matrix (n, n), as a read-only matrix; None stays None.

    Raises InvalidInputError for anything else.
    """
    if value is None:
        return None
    wanted = (
        f"{n} weights above zero, one per joint, or a symmetric positive definite matrix ({n}, {n}), finite, below {LARGEST:g},"
        f" with the largest entry at least {SMALLEST:g}"
    )
    matrix = number_array(argument, value)
    if matrix.shape == (n,):
        matrix = np.diag(matrix)
    if matrix.shape != (n, n) or not (np.abs(matrix) < LARGEST).all() or np.abs(matrix).max() < SMALLEST:
        raise InvalidInputError(argument, value, wanted)
    eigenvalues = np.linalg.eigvalsh((matrix + matrix.T) / 2)
    lopsided = np.abs(matrix - matrix.T).max() > 1e-9 * np.abs(matrix).max()
    if lopsided or eigenvalues[0] <= DEFINITE * eigenvalues[-1]:
        raise InvalidInputError(argument, value, wanted)
    matrix = (matrix + matrix.T) / 2
    matrix.flags.writeable = False
    return matrix
