"""The best proportions of a planar arm: link lengths of a given total whose optimal posture has the largest μ."""

import math
from dataclasses import dataclass

import numpy as np

from manipplan.planar.arm import PlanarArm
from manipplan.planar.manipulability import manipulability
from manipplan.support.checks import Array, number, random_seed, whole_number
from manipplan.support.errors import InvalidInputError


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
        lengths=lengths,
        q=q,
        manipulability=float(manipulability(PlanarArm(lengths), q)),
        bound=manipulability_bound(n, total),
    )
