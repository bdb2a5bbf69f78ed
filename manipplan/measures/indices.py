"""Yoshikawa's manipulability index m = sqrt(det(J Jᵀ)) as a CasADi expression."""

import casadi as ca


def row_norms(jacobian: ca.SX) -> list[ca.SX]:
    """Lengths r_i of J's rows after Gram-Schmidt against the rows before; m is their product.

    This is the diagonal of R in Jᵀ = Q R, so m loses no digits to the square in J Jᵀ.
    """
    m = jacobian.shape[0]
    directions: list[ca.SX] = []
    norms: list[ca.SX] = []
    for i in range(m):
        row = jacobian[i, :].T
        for direction in directions:
            row = row - direction * ca.dot(direction, row)
        square = ca.sumsqr(row)
        norm = ca.sqrt(square)
        norms.append(norm)
        # A row that vanished has no direction; the floor keeps the other rows finite.
        directions.append(row / ca.fmax(norm, 1e-150))
    return norms


def yoshikawa(jacobian: ca.SX) -> ca.SX:
    """The index m = sqrt(det(J Jᵀ)) of a task Jacobian (m, n); identically zero when m > n [yoshikawa1985]."""
    if jacobian.shape[0] > jacobian.shape[1]:
        return ca.SX(0.0)
    product = ca.SX(1.0)
    for norm in row_norms(jacobian):
        product *= norm
    return product


def log_yoshikawa(jacobian: ca.SX, regularisation: float) -> ca.SX:
    """The value of log sqrt(det(J Jᵀ + ε I)) through a Cholesky factor, with ε = `regularisation` [unit of J squared]."""
    gram = jacobian @ jacobian.T + regularisation * ca.SX.eye(jacobian.shape[0])
    factor = ca.chol(gram)
    return ca.sum1(ca.log(ca.diag(factor)))
