"""The best proportions of a planar arm: how link lengths share a given total so that the optimal posture has the largest μ."""

import math
from dataclasses import dataclass

import numpy as np

from manipplan.planar.arm import PlanarArm
from manipplan.planar.index import manipulability
from manipplan.support.checks import Array, number, random_seed, whole_number
from manipplan.support.errors import InvalidInputError


@dataclass(frozen=True, kw_only=True, eq=False)
class Proportions:
    """Link lengths, and the posture in which they have the largest μ.

    Attributes:
        lengths: (n,) [m].
        q: (n,) [rad], with θ_1 = 0.
        manipulability: μ there [m²].
        bound: what no arm of this total length exceeds, in any posture [m²].
    """

    lengths: Array
    q: Array
    manipulability: float
    bound: float


def manipulability_bound(n: int, total: float = 1.0) -> float:
    """sup μ over all planar arms of n links and total length L, in all postures [m²]: L²/4 sqrt(⌊n/2⌋ ⌈n/2⌉).

    It is approached, and for n >= 3 not reached, by ⌈n/2⌉ joints together at the base, the others together half way, and an
    elbow of 90 degrees: link lengths L/2 and L/2 at the ends of the two groups, and all others going to zero.

    Why: the tool is joined to joint i by links of total length a_i, so for i < j the minor M_ij = (r_i - r_j) × r_j is at most
    a_j (a_i - a_j) in size, and μ² <= Σ_(i<j) a_j² (a_i - a_j)² with L >= a_1 >= ... >= a_n >= 0. That sum is largest where the
    a_i take the two values L and L/2, which leaves ⌊n/2⌋ ⌈n/2⌉ pairs of (L/2)⁴. The last step is proven by the tests for n = 3;
    for n = 4 a grid confirms it to 4 %, and up to n = 8 random search found nothing above it.

    Args:
        n: number of links, at least 2.
        total: L > 0 [m].
    """
    n, total = whole_number("n", n, least=2), number("total", total, above=0.0)
    return total**2 / 4 * math.sqrt((n // 2) * ((n + 1) // 2))


def optimal_lengths(n: int, *, total: float = 1.0, least: float = 0.1, starts: int = 30, seed: int = 0) -> Proportions:
    """Link lengths l_i >= `least` of sum `total` with the largest μ in their optimal posture.

    By minimisation of -μ² over lengths and angles together from random starts; the best of them is not proven to be the
    global one, but `bound` says how much any could be above it.

    Args:
        n: number of links, 2 to 8.
        total: sum of the lengths [m].
        least: shortest link that can be built [m], above zero: without it links vanish, see `manipulability_bound`.
        starts: how many random starts.
        seed: of the random starts.

    Raises InvalidInputError when n links of `least` are longer than `total`.
    """
    from scipy.optimize import minimize

    n, total = whole_number("n", n, least=2, most=8), number("total", total, above=0.0)
    least = number("least", least, above=0.0)
    if n * least > total:
        raise InvalidInputError("least", least, f"at most total / n = {total / n:g} m")
    spare, rng = total - n * least, np.random.default_rng(random_seed("seed", seed))

    def unpacked(x: Array) -> tuple[Array, Array]:
        return least + spare * x[:n] ** 2 / (x[:n] @ x[:n]), np.r_[0.0, x[n:]]  # squares share what is spare

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
