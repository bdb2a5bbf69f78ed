"""Theorems 4.1, 4.2, 4.4 and proposition 4.3 of kth2012 as executable checks: polynomial identities, with CasADi.

With c_p = cos φ_p, s_p = sin φ_p as free symbols everything here is a polynomial, and ∂/∂θ_1 is the derivation that maps every
c_p to -s_p and s_p to c_p. A polynomial is zero when all its derivatives vanish at the origin. CasADi differentiates exactly,
and the coefficients are small integers, so this decides the identity for all link lengths and all angles without sampling
or tolerance. The steps use the symbols of `index`; J Jᵀ = ((a, b), (b, d)).

The best proportions of a planar arm: link lengths of a given total whose optimal posture has the largest μ.
"""

import math
from dataclasses import dataclass

import casadi as ca
import numpy as np

from manipplan.planar.arm import PlanarArm
from manipplan.planar.manipulability import manipulability
from manipplan.support.checks import Array, instance, number, random_seed, whole_number
from manipplan.support.errors import InvalidInputError


@dataclass(frozen=True, kw_only=True)
class Theorem:
    """A result of kth2012 for n links of any lengths in any posture; `steps`: identities, and whether each holds."""

    name: str
    n: int
    steps: tuple[tuple[str, bool], ...]

    @property
    def holds(self) -> bool:
        """Whether every step holds."""
        return all(shown for _, shown in self.steps)


@dataclass(frozen=True, kw_only=True, eq=False)
class Counterexample:
    """Three postures at which μ is not convex: μ(θ_b) > (μ(θ_a) + μ(θ_c))/2 though θ_b = (θ_a + θ_c)/2.

    Attributes:
        q: (3, n) θ_a, θ_b, θ_c [rad].
        manipulability: (3,) their μ [m²].
        closed_form: μ(θ_b) by (4.27) [m²].
    """

    q: Array
    manipulability: Array
    closed_form: float

    @property
    def holds(self) -> bool:
        """Whether convexity is violated at the midpoint."""
        return bool(self.manipulability[1] > self.manipulability[[0, 2]].mean())


def frobenius_theorem(n: int) -> Theorem:
    """Theorem 4.1 in kth2012: ‖J‖_F does not depend on θ_1 and equals (4.2), with the last sum from m = p + 1.

    The printed sum starts at m = i + 1, which would add terms with m <= p; its proof has m >= p + 1.
    """
    arm = _Symbols.of(n)
    trace = ca.sumsqr(arm.x) + ca.sumsqr(arm.y)
    closed = sum(
        (p + 1) * arm.lengths[p] ** 2 * (arm.c[p] ** 2 + arm.s[p] ** 2)  # cos² + sin² = 1
        + 2 * sum((p + 1) * arm.lengths[p] * arm.lengths[m] * arm.cosine(p, m) for m in range(p + 1, n))
        for p in range(n)
    )
    steps = (
        ("∂ tr(J Jᵀ)/∂θ_1 = 0", arm.vanishes(arm.turn(trace))),
        ("tr(J Jᵀ) = Σ_p p l_p² + 2 Σ_(p<m) p l_p l_m cos(φ_m - φ_p)", arm.vanishes(trace - closed)),
    )
    return Theorem(name="theorem 4.1", n=arm.n, steps=steps)


def manipulability_theorem(n: int) -> Theorem:
    """Theorem 4.2 in kth2012: μ does not depend on θ_1.

    Rotating by θ_1 rotates the columns of J, so a' = -2b, b' = a - d, d' = 2b, and (a d - b²)' = a' d + a d' - 2 b b' = 0.
    """
    arm = _Symbols.of(n)
    a, b, d = ca.sumsqr(arm.x), ca.dot(arm.x, arm.y), ca.sumsqr(arm.y)
    steps = (
        ("a' = -2b", arm.vanishes(arm.turn(a) + 2 * b)),
        ("b' = a - d", arm.vanishes(arm.turn(b) - a + d)),
        ("d' = 2b", arm.vanishes(arm.turn(d) - 2 * b)),
        ("a' d + a d' - 2 b b' = 0", _determinant_is_still()),
    )
    return Theorem(name="theorem 4.2", n=arm.n, steps=steps)


def condition_theorem(n: int) -> Theorem:
    """Theorem 4.4 in kth2012: κ does not depend on θ_1, since by (4.38) the eigenvalues follow from trace and determinant."""
    a, b, d, eigenvalue = (ca.SX.sym(name) for name in ("a", "b", "d", "λ"))
    characteristic = (a - eigenvalue) * (d - eigenvalue) - b * b
    from_invariants = eigenvalue**2 - (a + d) * eigenvalue + (a * d - b * b)
    steps = (
        *frobenius_theorem(n).steps[:1],
        *manipulability_theorem(n).steps,
        (
            "det(J Jᵀ - λ I) = λ² - tr(J Jᵀ) λ + det(J Jᵀ)",
            vanishes(characteristic - from_invariants, ca.vertcat(a, b, d, eigenvalue)),
        ),
    )
    return Theorem(name="theorem 4.4", n=n, steps=steps)


def convexity_counterexample(arm: PlanarArm) -> Counterexample:
    """Proposition 4.3 in kth2012: μ is not convex, shown by θ_a = 0, θ_c = (0, π, 0, ..., 0) and their midpoint θ_b."""
    instance("arm", arm, PlanarArm)
    q = np.zeros((3, arm.n))
    q[1, 1], q[2, 1] = np.pi / 2, np.pi
    rest = np.cumsum(arm.lengths[::-1])[::-1][1:]  # Σ_(p>=i) l_p for i = 2 ... n
    closed = float(arm.lengths[0] * np.linalg.norm(rest))  # (4.27)
    return Counterexample(q=q, manipulability=manipulability(arm, q), closed_form=closed)


def vanishes(polynomial: ca.SX, symbols: ca.SX) -> bool:
    """Whether a polynomial is zero for all values of its symbols, i.e. all its derivatives vanish at the origin.

    Differentiates until no term is left, which also proves that the expression is a polynomial of low degree (at most 12).
    """
    terms = ca.SX(polynomial)
    for _ in range(13):
        at_origin = ca.Function("terms", [symbols], [ca.densify(terms)])(0)
        if np.any(np.asarray(at_origin) != 0):
            return False
        terms = ca.sparsify(ca.vec(ca.jacobian(terms, symbols)))
        if not terms.nnz():
            return True
        terms = ca.vertcat(*{each.element_hash(): each for each in terms.nonzeros()}.values())  # without duplicates
    return False


@dataclass(frozen=True, kw_only=True, eq=False)
class _Symbols:
    """An arm with n links in free symbols l, c, s, and the rows x, y of its Jacobian (4.4)."""

    n: int
    lengths: list[ca.SX]
    c: list[ca.SX]
    s: list[ca.SX]
    x: ca.SX
    y: ca.SX

    @classmethod
    def of(cls, n: int) -> "_Symbols":
        n = whole_number("n", n, least=2, most=12)
        lengths, c, s = (ca.vertsplit(ca.SX.sym(name, n)) for name in "lcs")
        x = ca.vertcat(*(-sum(lengths[p] * s[p] for p in range(i, n)) for i in range(n)))
        y = ca.vertcat(*(sum(lengths[p] * c[p] for p in range(i, n)) for i in range(n)))
        return cls(n=n, lengths=lengths, c=c, s=s, x=x, y=y)

    def cosine(self, p: int, m: int) -> ca.SX:
        """cos(φ_m - φ_p)."""
        return self.c[p] * self.c[m] + self.s[p] * self.s[m]

    def turn(self, expression: ca.SX) -> ca.SX:
        """∂/∂θ_1, which rotates every link."""
        c, s = ca.vertcat(*self.c), ca.vertcat(*self.s)
        return ca.dot(ca.gradient(expression, s), c) - ca.dot(ca.gradient(expression, c), s)

    def vanishes(self, expression: ca.SX) -> bool:
        return vanishes(expression, ca.vertcat(*self.lengths, *self.c, *self.s))


def _determinant_is_still() -> bool:
    a, b, d = (ca.SX.sym(name) for name in "abd")
    return vanishes(-2 * b * d + a * (2 * b) - 2 * b * (a - d), ca.vertcat(a, b, d))


@dataclass(frozen=True, kw_only=True, eq=False)
class Proportions:
    """Link lengths and the posture with their largest μ.

    Attributes:
        lengths: (n,) [m].
        q: (n,) [rad], with θ_1 = 0.
        manipulability: μ at q [m²].
        bound: upper bound on μ of any arm of this total length in any posture [m²].
    """

    lengths: Array
    q: Array
    manipulability: float
    bound: float


def manipulability_bound(n: int, total: float = 1.0) -> float:
    """sup μ over all planar arms of n links and total length L, in all postures [m²]: L²/4 sqrt(⌊n/2⌋ ⌈n/2⌉).

    It is approached, but for n >= 3 not reached, with ⌈n/2⌉ joints together at the base, the others together halfway, and an
    elbow of 90 degrees: the last link of each of the two groups has length L/2, and all other lengths tend to zero.

    Reason: links of total length a_i connect joint i to the tool, so for i < j the minor M_ij = (r_i - r_j) × r_j is at most
    a_j (a_i - a_j) in size, and μ² <= Σ_(i<j) a_j² (a_i - a_j)² with L >= a_1 >= ... >= a_n >= 0. That sum is largest where the
    a_i take the two values L and L/2, which leaves ⌊n/2⌋ ⌈n/2⌉ pairs of (L/2)⁴. The last step is proven by the tests for n = 3;
    for n = 4 a grid confirms it to 4 %, and up to n = 8 random search found nothing larger.

    Args:
        n: number of links, at least 2.
        total: L > 0 [m].
    """
    n, total = whole_number("n", n, least=2), number("total", total, above=0.0)
    return total**2 / 4 * math.sqrt((n // 2) * ((n + 1) // 2))


def optimal_lengths(n: int, *, total: float = 1.0, least: float = 0.1, starts: int = 30, seed: int = 0) -> Proportions:
    """Link lengths l_i >= `least` with sum `total` whose optimal posture has the largest μ.

    Minimises -μ² over lengths and angles together from random starts. The best result is not proven to be the global
    optimum, but `bound` limits how far any arm could exceed it.

    Args:
        n: number of links, 2 to 8.
        total: sum of the lengths [m].
        least: minimum link length [m], above zero: without it links vanish, see `manipulability_bound`.
        starts: number of random starts.
        seed: seed of the random starts.

    Raises InvalidInputError when n links of length `least` are longer than `total`.
    """
    from scipy.optimize import minimize

    n, total = whole_number("n", n, least=2, most=8), number("total", total, above=0.0)
    least = number("least", least, above=0.0)
    if n * least > total:
        raise InvalidInputError("least", least, f"at most total / n = {total / n:g} m")
    spare, rng = total - n * least, np.random.default_rng(random_seed("seed", seed))

    def unpacked(x: Array) -> tuple[Array, Array]:
        return least + spare * x[:n] ** 2 / (x[:n] @ x[:n]), np.r_[0.0, x[n:]]  # squares divide the spare length

    def cost(x: Array) -> float:
        lengths, q = unpacked(x)
        return -(float(manipulability(PlanarArm(lengths), q)) ** 2) / total**4

    best: tuple[float, Array] | None = None
    for _ in range(whole_number("starts", starts, least=1)):
        x = np.r_[rng.uniform(0.1, 1.0, n), rng.uniform(-np.pi, np.pi, n - 1)]
        result = minimize(cost, x, method="BFGS", options={"gtol": 1e-9})
        if best is None or result.fun < best[0]:
            best = float(result.fun), np.asarray(result.x)
    assert best is not None
    lengths, q = unpacked(best[1])
    q = q - 2 * np.pi * np.round(q / (2 * np.pi))
    return Proportions(
        lengths=lengths, q=q, manipulability=float(manipulability(PlanarArm(lengths), q)), bound=manipulability_bound(n, total)
    )
