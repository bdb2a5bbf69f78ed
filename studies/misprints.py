"""Misprints of the three papers, each with the corrected formula and a number that shows it: `python -m studies.misprints`.

The numbers come from NumPy alone; they share nothing with the package.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from studies.tables import Cell, Table

Array = NDArray[np.float64]
PAGES = Path(__file__).parents[1] / "docs" / "studies" / "papers"
LENGTHS = np.array([1.0, 0.8, 0.6])
POSTURE = np.array([0.3, 0.7, -1.2])


@dataclass(frozen=True, kw_only=True)
class Misprint:
    """What is printed where, what is right, and a check.

    Attributes:
        check: returns what the printed formula gives, what the corrected one gives, and the right value; None: nothing to
            compute, `how` says why the correction is right.
        how: what was computed.
    """

    paper: str
    place: str
    printed: str
    corrected: str
    how: str
    check: Callable[[], tuple[float, float, float]] | None = None

    @property
    def values(self) -> tuple[float, float, float] | None:
        """What the check returns."""
        return self.check() if self.check else None


def jacobian(q: Array, lengths: Array = LENGTHS) -> Array:
    """(2.11) of the planar arm, (2, n)."""
    phi = np.cumsum(q)
    x, y = lengths * np.cos(phi), lengths * np.sin(phi)
    return np.stack([-np.cumsum(y[::-1])[::-1], np.cumsum(x[::-1])[::-1]])


def squared(q: Array, lengths: Array = LENGTHS) -> float:
    """μ²."""
    J = jacobian(q, lengths)
    return float(np.linalg.det(J @ J.T))


def _product() -> tuple[float, float, float]:
    J = jacobian(POSTURE)
    right = float(np.prod(np.linalg.svd(J, compute_uv=False)))
    return float(np.prod(np.linalg.eigvalsh(J @ J.T))), right, squared(POSTURE) ** 0.5


def _axes() -> tuple[float, float, float]:
    J = jacobian(POSTURE)
    s = np.linalg.svd(J, compute_uv=False)
    return float(s.sum()), float(np.sqrt((s**2).sum() / 2)), float(np.sqrt(np.trace(J @ J.T) / 2))


def _roundness() -> tuple[float, float, float]:
    J = jacobian(POSTURE)
    turn = np.linspace(0, 2 * np.pi, 100_001)
    # the ellipse vᵀ (J Jᵀ)⁻¹ v = 1, by its distances from the centre
    radius = np.einsum("ik,ij,jk->k", d := np.stack([np.cos(turn), np.sin(turn)]), np.linalg.inv(J @ J.T), d) ** -0.5
    whole, own = np.linalg.svd(J @ J.T, compute_uv=False), np.linalg.svd(J, compute_uv=False)
    return float(whole[1] / whole[0]), float(own[1] / own[0]), float(radius.min() / radius.max())


def _trace() -> tuple[float, float, float]:
    q, size, n = POSTURE, LENGTHS, 3
    phi = np.cumsum(q)

    def total(first: Callable[[int, int], int]) -> float:
        pairs = [(p, m) for i in range(n) for p in range(i, n) for m in range(first(i, p), n)]
        terms = sum(size[p] * size[m] * np.cos(phi[m] - phi[p]) for p, m in pairs)
        return float(np.arange(1, n + 1) @ size**2 + 2 * terms)

    J = jacobian(q)
    return total(lambda i, _: i + 1), total(lambda _, p: p + 1), float(np.trace(J @ J.T))


def _derivative(sign: int) -> float:
    x, y = jacobian(POSTURE)
    a = -2 * (x * y).sum() * (y * y).sum() + 2 * (x * x).sum() * (x * y).sum()
    b = -(y * y).sum() * (x * y).sum() + (x * x).sum() * (x * y).sum()
    b += -(x * y).sum() * (y * y).sum() + (x * y).sum() * (x * x).sum()
    return float(a + sign * b)


def _sums(last: float) -> float:
    x, y = jacobian(POSTURE)
    xy, xx, yy = (x * y).sum(), (x * x).sum(), (y * y).sum()
    return float(-xy * yy + xx * xy + yy * xy - last)


def _last_row() -> tuple[float, float, float]:
    x, y = jacobian(POSTURE)
    xy, xx = (x * y).sum(), (x * x).sum()
    return _sums(xy * xy), _sums(xy * xx), _slope()


def _slope() -> float:
    step = np.array([1e-6, 0, 0])
    return round((squared(POSTURE + step) - squared(POSTURE - step)) / 2e-6, 6)


def _first_form() -> tuple[float, float, float]:
    (a, b, c), (second, third) = LENGTHS, POSTURE[1:]

    def total(term: float) -> float:
        value = a**2 * b**2 / 2 + (a**2 + b**2) * c**2 + a * b * c**2 * np.cos(second) - a**2 * b**2 / 2 * np.cos(2 * second)
        value += term * np.cos(third) - b**2 * c**2 * np.cos(2 * third) - a**2 * c**2 * np.cos(2 * second + 2 * third)
        return float(value - a**2 * b * c * np.cos(2 * second + third) - a * b * c**2 * np.cos(second + 2 * third))

    return total(a * b**2 * c), total(a**2 * b * c), squared(POSTURE)


def _last_form() -> tuple[float, float, float]:
    second, third = POSTURE[1:]

    def total(constant: float, double: float) -> float:
        value = constant + np.cos(second) - np.cos(2 * second) / 2 + np.cos(third) - double * np.cos(2 * third)
        value -= np.cos(2 * second + 2 * third) + np.cos(2 * second + third) + np.cos(second + 2 * third)
        return float(value)

    return total(1.5, 0.5), total(2.5, 1.0), squared(POSTURE, np.ones(3))


def _line(power: float) -> float:
    s = (np.arange(20_000) + 0.5) / 20_000
    start, step = np.array([0.0, -3.0, -2.0]), np.array([np.pi, 3.1, 3.4])
    density = [squared(start + each * step, np.ones(3)) ** (-power / 2) for each in s]
    return float(np.linalg.norm(step) * np.mean(density))


def _robot(n: int = 7) -> Array:
    return np.random.default_rng(0).normal(size=(6, n))


def _projector() -> tuple[float, float, float]:
    J, z = _robot(), np.random.default_rng(1).normal(size=7)
    P = np.linalg.pinv(J) @ J
    return float(np.linalg.norm(J @ P @ z)), round(float(np.linalg.norm(J @ (np.eye(7) - P) @ z)), 9), 0.0


def _singular_values() -> tuple[float, float, float]:
    J = _robot()
    values = np.sqrt(np.abs(np.linalg.eigvalsh(J.T @ J)))
    six = float(np.prod(np.sort(values)[1:]))
    return round(float(np.prod(values)), 5), six, float(np.sqrt(np.linalg.det(J @ J.T)))


def _relaxed() -> tuple[float, float, float]:
    J, rate, slope = _robot(), np.random.default_rng(2).normal(size=6), np.random.default_rng(3).normal(size=7)
    free = slope  # min ½ q̇ᵀ q̇ - ∇mᵀ q̇ with δ free and without a price
    kept = slope + np.linalg.pinv(J) @ (rate - J @ slope)  # with δ = 0
    return float(np.linalg.norm(J @ free - rate)), round(float(np.linalg.norm(J @ kept - rate)), 9), 0.0


def _at_zero() -> tuple[float, float, float]:
    stretched, step = np.zeros(3), 1e-4
    ahead, behind = (squared(stretched + np.array([0, sign * step, 0])) ** 0.5 for sign in (1, -1))
    return (ahead - behind) / (2 * step), ahead / step, ahead / step


def _secant() -> tuple[float, float, float]:
    random = np.random.default_rng(4)
    root = random.normal(size=(7, 7))
    H, s = root @ root.T, random.normal(size=7)
    y = (root @ root.T + np.eye(7)) @ s
    rho, eye = 1 / (y @ s), np.eye(7)
    printed = (eye - rho * np.outer(s, y)) @ H @ (eye - rho * np.outer(y, s)) + rho * np.outer(s, s)
    direct = H - np.outer(H @ s, H @ s) / (s @ H @ s) + rho * np.outer(y, y)
    return float(np.linalg.norm(printed @ s - y)), round(float(np.linalg.norm(direct @ s - y)), 9), 0.0


def _jacobi() -> tuple[float, float, float]:
    random = np.random.default_rng(5)
    A, D = random.normal(size=(3, 3)), random.normal(size=(3, 3))
    adjugate = np.linalg.det(A) * np.linalg.inv(A)
    step = 1e-6
    slope = (np.linalg.det(A + step * D) - np.linalg.det(A - step * D)) / (2 * step)
    return float((adjugate @ D)[0, 0]), float(np.trace(adjugate @ D)), float(slope)


def _normal() -> tuple[float, float, float]:
    q, rate, sphere = POSTURE, np.array([0.2, -0.1, 0.3]), np.array([2.0, 1.5])

    def tool(q: Array) -> Array:
        phi = np.cumsum(q)
        return np.array([LENGTHS @ np.cos(phi), LENGTHS @ np.sin(phi)])

    n = (tool(q) - sphere) / np.linalg.norm(tool(q) - sphere)
    ahead, behind = (np.linalg.norm(tool(q + sign * 1e-6 * rate) - sphere) for sign in (1, -1))
    return float(-n @ jacobian(q) @ rate), float(n @ jacobian(q) @ rate), float((ahead - behind) / 2e-6)


def _next_start() -> tuple[float, float, float]:
    m = np.random.default_rng(6).uniform(0, 1, 50)
    start = np.sort(m)[30]
    others = m[m != start]
    printed = others[np.argmin(start - others)]
    return float(printed), float(others[others <= start].max()), float(np.sort(m)[29])


MISPRINTS = (
    Misprint(
        paper="kth2012",
        place="section 2.1",
        printed="prismatic joints",
        corrected="revolute joints",
        how="all of its formulas turn the joints",
    ),
    Misprint(
        paper="kth2012",
        place="Definition 2.8",
        printed="μ is the product of the eigenvalues of J Jᵀ",
        corrected="of the singular values of J",
        how="μ of a posture",
        check=_product,
    ),
    Misprint(
        paper="kth2012",
        place="sections 2.6, 2.7.1",
        printed="‖J‖_F is the sum of the axes",
        corrected="√((σ₁² + σ₂²)/2)",
        how="‖J‖_F of a posture",
        check=_axes,
    ),
    Misprint(
        paper="kth2012",
        place="Definition 2.10, (2.23)",
        printed="κ from the singular values of J Jᵀ",
        corrected="of J",
        how="axes of the ellipse, measured",
        check=_roundness,
    ),
    Misprint(
        paper="kth2012",
        place="(4.2), (4.8), (4.10) to (4.15)",
        printed="innermost sum from m = i + 1",
        corrected="from m = p + 1",
        how="tr(J Jᵀ) of a posture",
        check=_trace,
    ),
    Misprint(
        paper="kth2012",
        place="(4.21)",
        printed="B = ΣΣ ∂/∂θ₁(…)",
        corrected="B = -ΣΣ ∂/∂θ₁(…)",
        how="A + B, the derivative of μ² by θ₁",
        check=lambda: (_derivative(1), round(_derivative(-1), 9), _slope()),
    ),
    Misprint(
        paper="kth2012",
        place="(4.22), last term",
        printed="xᵢ yᵢ xⱼ yⱼ",
        corrected="xᵢ yᵢ xⱼ xⱼ",
        how="the derivative of μ² by θ₁",
        check=_last_row,
    ),
    Misprint(
        paper="kth2012", place="(4.29)", printed="p ≠ 1", corrected="i ≠ 1", how="p is the index of the sum; the case is i = 1"
    ),
    Misprint(
        paper="kth2012",
        place="(5.2), first form",
        printed="l₁ l₂² l₃ cos θ₃",
        corrected="l₁² l₂ l₃ cos θ₃",
        how="μ² for lengths 1, 0.8, 0.6",
        check=_first_form,
    ),
    Misprint(
        paper="kth2012",
        place="(5.2), last form, and (5.3)",
        printed="3/2 and -½ cos 2θ₃",
        corrected="5/2 and -cos 2θ₃",
        how="μ² for unit links",
        check=_last_form,
    ),
    Misprint(
        paper="kth2012",
        place="(5.7), second row",
        printed="-θ ≤ -π/2",
        corrected="-θ ≤ π/2",
        how="whether θ = 0 is allowed",
        check=lambda: (float(-np.pi / 2 >= 0.0), float(np.pi / 2 >= 0.0), 1.0),
    ),
    Misprint(
        paper="kth2012",
        place="(6.5)",
        printed="arc length",
        corrected="the speed ‖Θ′(t)‖",
        how="the arc length is its integral, (6.6) without μ",
    ),
    Misprint(
        paper="kth2012",
        place="(6.6) and Tables 6.1, 6.2, 6.4",
        printed="∫ ‖Θ′‖/μ dt",
        corrected="the tables hold ∫ ‖Θ′‖/μ² dt",
        how="straight line of Table 6.1, which prints 2.7218",
        check=lambda: (_line(1.0), _line(2.0), 2.7218),
    ),
    Misprint(
        paper="kth2012",
        place="Table 6.4, first column",
        printed="g_L/g",
        corrected="g/g_L",
        how="the optimum is cheaper than the line, so g_L/g is above 1; 0.27 is not",
    ),
    Misprint(
        paper="kth2012",
        place="Appendix A",
        printed="positive semi-definite",
        corrected="positive definite",
        how="1/√λ needs λ > 0",
    ),
    Misprint(
        paper="dufour2020",
        place="(2), (7)",
        printed="I₆ - J†J",
        corrected="Iₙ - J†J, n = 7",
        how="size of J†J",
        check=lambda: (6.0, 7.0, float(len(np.linalg.pinv(_robot()) @ _robot()))),
    ),
    Misprint(
        paper="dufour2020",
        place="below (2)",
        printed="J†J projects onto the kernel of J",
        corrected="I - J†J does; J†J projects onto the row space",
        how="‖J x‖ of the projection x of a random vector",
        check=_projector,
    ),
    Misprint(
        paper="dufour2020",
        place="(5)",
        printed="product of n singular values",
        corrected="of 6, the rank",
        how="m of a random J (6, 7)",
        check=_singular_values,
    ),
    Misprint(
        paper="dufour2020",
        place="(8), (12)",
        printed="J q̇ = ṙ beside a δ in the objective",
        corrected="J q̇ + δ = ṙ",
        how="as in (10) and (14); else δ = 0",
    ),
    Misprint(
        paper="dufour2020",
        place="(9)",
        printed="linearised",
        corrected="a second-order expansion",
        how="it holds H_m",
    ),
    Misprint(
        paper="dufour2020",
        place="Lemma 1, proof",
        printed="q_t is the new and the present posture",
        corrected="ε = h(q_t) with q_t fixed, to first order in q̇",
        how="with h of the new posture, ε would be constant",
    ),
    Misprint(
        paper="dufour2020",
        place="(16)",
        printed="Q_δ = 0",
        corrected="δ = 0",
        how="‖J q̇ - ṙ‖ of the solution for a random J",
        check=_relaxed,
    ),
    Misprint(
        paper="dufour2020",
        place="(17) at m = 0",
        printed="always defined",
        corrected="defined, but 0 there: m has a kink",
        how="slope of m of a stretched planar arm",
        check=_at_zero,
    ),
    Misprint(
        paper="dufour2020",
        place="(20)",
        printed="update of H_m",
        corrected="it is the update of its inverse; direct: H - H s sᵀH/(sᵀH s) + y yᵀ/(yᵀs)",
        how="error of the secant, ‖H s - y‖",
        check=_secant,
    ),
    Misprint(
        paper="dufour2020",
        place="(A.1)",
        printed="n without orientation",
        corrected="n from the obstacle to the robot",
        how="rate of the distance, nᵀ J q̇, of a planar arm; printed: the other orientation",
        check=_normal,
    ),
    Misprint(
        paper="dufour2020",
        place="Appendix B, first formula",
        printed="adj(A) ∂A",
        corrected="tr(adj(A) ∂A)",
        how="derivative of a determinant; printed: first element of the matrix",
        check=_jacobi,
    ),
    Misprint(
        paper="guilamo2006",
        place="IV, next q_start",
        printed="M(q_start) - M(q) ≤ M(q_start) - M(q_ij) for all q_ij",
        corrected="the same for all q_ij with M(q_ij) ≤ M(q_start) that are not tried yet",
        how="next start after the 31st of 50 sorted values; printed: the largest of all",
        check=_next_start,
    ),
    Misprint(
        paper="guilamo2006",
        place="Table I and the text below it",
        printed="20 s and 4 s for the line",
        corrected="one of the two",
        how="our machine and robot cannot tell which",
    ),
)


def misprints_table() -> Table:
    """All misprints with their checks."""
    rows: list[tuple[Cell, ...]] = []
    for each in MISPRINTS:
        values = each.values
        numbers = ("", "", "") if values is None else tuple(f"{value + 0.0:.5g}" for value in values)
        rows.append((each.paper, each.place, each.printed, each.corrected, each.how, *numbers))
    head = ("paper", "place", "printed", "right", "checked by", "printed gives", "right gives", "true value")
    return Table.of("misprints", head, rows)


if __name__ == "__main__":
    PAGES.mkdir(exist_ok=True)
    misprints_table().write(PAGES)
