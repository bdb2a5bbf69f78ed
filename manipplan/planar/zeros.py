"""All zeros of a square system of trigonometric polynomials on the torus, found with proof by subdivision.

A box is discarded when bounds prove that one equation has no zero in it; it is done when Krawczyk's operator proves that it
contains exactly one [krawczyk1969]; otherwise it is halved along every angle. No zero is lost: a box for which neither can
be proven down to `SMALLEST` is returned as unresolved.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.planar.trigonometric import TrigonometricPolynomial
from manipplan.support.checks import Array, entries
from manipplan.support.errors import InvalidInputError

#: Half width at which boxes are no longer split [rad].
SMALLEST = 1e-8
#: Maximum number of boxes examined; the rest is returned as unresolved.
MOST = 4_000_000
#: Factor by which a box is enlarged for Krawczyk's test, so that a zero on an edge can be proven.
MARGIN = 1.25
#: Proven zeros closer than this are one, found by neighbouring boxes: two would lie in one enlarged box [rad].
SAME = 1e-9
#: Maximum number of boxes per batch.
_BATCH = 60_000


@dataclass(frozen=True, kw_only=True, eq=False)
class Zeros:
    """All zeros of a system on the torus.

    Attributes:
        points: (k, d) in (-π, π] [rad], each in a box that contains no other.
        unresolved: (u, d) centres of boxes of half width at most `half_width` that may contain any number of zeros; there
            are no zeros elsewhere.
        half_width: largest half width of the unresolved boxes [rad], 0 when there are none.
        boxes: number of boxes examined.
    """

    points: Array
    unresolved: Array
    half_width: float
    boxes: int

    @property
    def complete(self) -> bool:
        """Whether `points` is proven to contain all zeros."""
        return not len(self.unresolved)


def torus_zeros(system: Sequence[TrigonometricPolynomial]) -> Zeros:
    """All x on the torus with f_i(x) = 0 for the d polynomials f_i of d angles."""
    system = entries("system", system, "a list of TrigonometricPolynomial")
    if not system or not all(isinstance(f, TrigonometricPolynomial) and f.dimension == len(system) for f in system):
        raise InvalidInputError("system", system, "as many TrigonometricPolynomial as each has angles")
    form = _System.of(system)
    d = form.dimension
    grid = (np.arange(8) + 0.5) / 8 * 2 * np.pi - np.pi
    work = [(np.stack(np.meshgrid(*[grid] * d, indexing="ij"), axis=-1).reshape(-1, d), np.pi / 8)]
    found: list[Array] = []
    left: list[tuple[Array, float]] = []
    boxes = 0
    while work:
        centres, half = work.pop()
        if len(centres) > _BATCH:
            work.append((centres[_BATCH:], half))
            centres = centres[:_BATCH]
        boxes += len(centres)
        points, open_ones = form.judge(centres, half)
        found.extend(points)
        if not len(open_ones):
            continue
        if half <= SMALLEST or boxes > MOST:
            left.append((open_ones, half))
            continue
        corners = np.stack(np.meshgrid(*[(-half / 2, half / 2)] * d, indexing="ij"), axis=-1).reshape(-1, d)
        work.append(((open_ones[:, None] + corners).reshape(-1, d), half / 2))
    proven = form.distinct(found)
    return Zeros(
        points=proven,
        unresolved=np.concatenate([each for each, _ in left]) if left else np.zeros((0, d)),
        half_width=max((half for _, half in left), default=0.0),
        boxes=boxes,
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class _System:
    """f_i with common frequencies, and bounds on their second derivatives and rounding errors.

    Attributes:
        frequencies: (m, d) vectors k.
        cosine: (m, d) coefficients, one column per equation.
        sine: (m, d) coefficients.
        bends: (d, d, d) bounds on |∂_j ∂_l f_i|.
        rounding: bounds on the rounding error, (d,) of a value and (d, d) of a slope.
    """

    frequencies: Array
    cosine: Array
    sine: Array
    bends: Array
    rounding: tuple[Array, Array]

    @classmethod
    def of(cls, system: Sequence[TrigonometricPolynomial]) -> "_System":
        frequencies = np.concatenate([f.frequencies for f in system])
        starts = np.cumsum([0, *(len(f.frequencies) for f in system)])
        cosine, sine = np.zeros((2, len(frequencies), len(system)))
        for i, f in enumerate(system):
            cosine[starts[i] : starts[i + 1], i] = f.cosine
            sine[starts[i] : starts[i + 1], i] = f.sine
        frequencies, same = np.unique(frequencies, axis=0, return_inverse=True)
        merge = np.equal.outer(np.arange(len(frequencies)), same.ravel()).astype(np.float64)
        cosine, sine = merge @ cosine, merge @ sine
        size, k = np.hypot(cosine, sine), np.abs(frequencies)
        # Relative rounding error of a term: sum of m terms, its coefficient, and the error of k · x with |x| <= 4.
        share = np.finfo(float).eps * (len(k) + 8 * (1 + k.sum(axis=1)))
        return cls(
            frequencies=frequencies,
            cosine=cosine,
            sine=sine,
            bends=np.einsum("mi,mj,ml->ijl", size, k, k),
            rounding=(
                np.einsum("mi,m->i", size, share),
                np.einsum("mi,mj,m->ij", size, k, share),
            ),
        )

    @property
    def dimension(self) -> int:
        return int(self.frequencies.shape[1])

    def values(self, x: Array) -> tuple[Array, Array]:
        """f (B, d) and its Jacobian (B, d, d) at x (B, d)."""
        phases = x @ self.frequencies.T
        c, s = np.cos(phases), np.sin(phases)
        k = self.frequencies
        slopes = np.einsum("bm,mi,mj->bij", c, self.sine, k, optimize=True)
        slopes -= np.einsum("bm,mi,mj->bij", s, self.cosine, k, optimize=True)
        return c @ self.cosine + s @ self.sine, slopes

    def judge(self, centres: Array, half: float) -> tuple[list[Array], Array]:
        """Zeros (d,) of boxes proven to contain just one when enlarged, and the centres of boxes that stay open."""
        value, slope = self.values(centres)
        # |f_i(x) - f_i(c)| <= Σ_j |∂_j f_i(c)| h + Σ_jl bends_ijl h²/2 in the box
        steepness = np.abs(slope) + self.rounding[1]
        span = steepness.sum(axis=2) * half + self.bends.sum(axis=(1, 2)) * half**2 / 2 + self.rounding[0]
        alive = (np.abs(value) <= span).all(axis=1)
        centres, value, slope = centres[alive], value[alive], slope[alive]
        size = np.linalg.norm(slope, axis=(1, 2))
        regular = np.abs(np.linalg.det(slope)) > 1e-9 * size**self.dimension
        inverse = np.zeros_like(slope)
        inverse[regular] = np.linalg.inv(slope[regular])
        step, reach = self._krawczyk(value, slope, inverse, half * MARGIN)
        empty = regular & (np.abs(step) > reach + half).any(axis=1)  # all zeros of the enlarged box are outside the box
        single = regular & ~empty & (np.abs(step) + reach < half * MARGIN).all(axis=1)
        points = [self._refined(c - s) for c, s in zip(centres[single], step[single], strict=True)]
        return points, centres[~empty & ~single]

    def _krawczyk(self, value: Array, slope: Array, inverse: Array, half: float) -> tuple[Array, Array]:
        """Y f(c) and the radius of (I - Y J(box)) (box - c): zeros in the box are in c - Y f(c) ± the radius.

        If that is inside the box, the box contains exactly one. The radius includes a bound on rounding.
        """
        y = np.abs(inverse)
        step = np.einsum("bij,bj->bi", inverse, value)
        spread = self.bends.sum(axis=2) * half + self.rounding[1]  # of the entries of J in the box
        identity = np.abs(np.eye(self.dimension) - inverse @ slope) + np.einsum("bij,jk->bik", y, spread)
        return step, identity.sum(axis=2) * half + y @ self.rounding[0]

    def _refined(self, x: Array) -> Array:
        for _ in range(6):
            value, slope = self.values(x[None])
            x = x - np.linalg.solve(slope[0], value[0])
        return x

    def distinct(self, found: list[Array]) -> Array:
        """The zeros in (-π, π], without duplicates from neighbouring boxes."""
        kept: list[Array] = []
        for x in found:
            turned = np.pi - np.mod(np.pi - x + 1e-9, 2 * np.pi) + 1e-9
            if all(np.abs(np.remainder(turned - y + np.pi, 2 * np.pi) - np.pi).max() > SAME for y in kept):
                kept.append(turned)
        return np.array(kept).reshape(-1, self.dimension)
