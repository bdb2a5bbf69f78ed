"""The determinant of a sparse symbolic matrix as a polynomial in its entries: smooth, signed, and cheap to differentiate."""

import casadi as ca


def determinant(matrix: ca.SX) -> ca.SX:
    """det of a matrix (n, n) by Laplace's expansion, with each minor computed once; zero entries cost nothing.

    No division occurs, so the expression and its derivatives are exact at singular matrices too.
    """
    n = matrix.shape[0]
    minors: dict[tuple[int, ...], ca.SX] = {(): ca.SX(1.0)}  # of the first rows, by their columns
    for i in range(n):
        larger: dict[tuple[int, ...], ca.SX] = {}
        for columns, minor in minors.items():
            for j in range(n):
                if j in columns or matrix[i, j].is_zero():
                    continue
                chosen = tuple(sorted((*columns, j)))
                sign = (-1) ** sum(column > j for column in columns)
                larger[chosen] = larger.get(chosen, ca.SX(0.0)) + sign * minor * matrix[i, j]
        minors = larger
    return minors.get(tuple(range(n)), ca.SX(0.0))
