"""Symmetric matrices of the cost: products that use symmetry, and convexification."""

import casadi as ca

#: Minimum pivot, as a share of the largest entries; smaller ones are raised to it.
PIVOT = 1e-8


def gram(matrix: ca.SX) -> ca.SX:
    """matrixᵀ matrix; entries that are equal by symmetry are computed once."""
    columns = ca.horzsplit(matrix)
    product = ca.SX(len(columns), len(columns))
    for i, first in enumerate(columns):
        for j, second in enumerate(columns[: i + 1]):
            product[i, j] = product[j, i] = ca.dot(first, second)
    return product


def convexified(matrix: ca.SX) -> tuple[ca.SX, ca.SX]:
    """`matrix` (n, n) plus a diagonal >= 0 that makes it positive definite, and the largest entry of that diagonal.

    The diagonal is zero if the matrix is positive definite already. The method is L D Lᵀ with pivots raised so that no
    entry of L D^½ exceeds a bound [gill1981, section 4.4.2.2].
    """
    n = matrix.shape[0]
    largest = _largest([ca.fabs(matrix[i, i]) for i in range(n)])
    across = _largest([ca.fabs(matrix[i, j]) for i in range(n) for j in range(i)]) if n > 1 else ca.SX(0)
    bound = _largest([largest, across / max((n**2 - 1) ** 0.5, 1.0), ca.SX(1e-300)])
    least = PIVOT * ca.fmax(largest + across, 1e-300)
    columns = ca.SX(matrix)
    pivots: list[ca.SX] = []
    added: list[ca.SX] = []
    for j in range(n):
        below = [columns[i, j] for i in range(j + 1, n)]
        widest = _largest([ca.fabs(each) for each in below]) if below else ca.SX(0)
        pivot = _largest([ca.fabs(columns[j, j]), widest**2 / bound, least])
        added.append(pivot - columns[j, j])
        pivots.append(pivot)
        for i in range(j + 1, n):
            for k in range(j + 1, i + 1):
                columns[i, k] -= columns[i, j] * columns[k, j] / pivot
    extra = _largest(added)
    return matrix + ca.diag(ca.vertcat(*added)), ca.if_else(extra > least, extra, 0)


def _largest(values: list[ca.SX]) -> ca.SX:
    top = values[0]
    for each in values[1:]:
        top = ca.fmax(top, each)
    return top
