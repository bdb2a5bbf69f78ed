"""Tables of chapters 4 and 5: theorems, optimal postures, proportions."""

import math

import numpy as np

from manipplan.planar import (
    PlanarArm,
    Proportions,
    TrigonometricPolynomial,
    condition_theorem,
    convexity_counterexample,
    force_ellipse,
    frobenius_norm,
    frobenius_theorem,
    manipulability,
    manipulability_theorem,
    matrix_ellipsoid,
    optimal_lengths,
    squared_manipulability,
    squared_manipulability_series,
    stationary_kind,
    torus_zeros,
    velocity_ellipse,
)
from studies.kth2012 import config
from studies.kth2012.config import ARM
from studies.kth2012.many_links import best_posture
from studies.kth2012.results import Results, signed
from studies.tables import Table

# (5.2) and (5.3) as printed: frequencies (θ_2, θ_3) and coefficients; μ̃ omits the constant.
_FREQUENCIES = np.array([[1, 0], [2, 0], [0, 1], [0, 2], [2, 2], [2, 1], [1, 2]], dtype=float)
_PRINTED = np.array([1, -1 / 2, 1, -1 / 2, -1, -1, -1])
PRINTED_5_3 = TrigonometricPolynomial(frequencies=_FREQUENCIES, cosine=_PRINTED, sine=np.zeros(7))
CORRECTED_5_3 = TrigonometricPolynomial(
    frequencies=_FREQUENCIES, cosine=_PRINTED - 1 / 2 * (_FREQUENCIES == (0, 2)).all(axis=1), sine=np.zeros(7)
)
PRINTED_CONSTANT, CONSTANT = 3 / 2, 5 / 2
EXACT = "identity of polynomials, exact"


def printed_optimum() -> tuple[float, ...]:
    """The maximum (θ_2, θ_3) of (5.3) as printed, with θ_2 > 0: the best of all its stationary points."""
    found = torus_zeros([PRINTED_5_3.derivative(0), PRINTED_5_3.derivative(1)])
    if not found.complete:
        raise RuntimeError("not all stationary points of (5.3) were found")
    best = found.points[PRINTED_5_3(found.points).argmax()]
    return tuple(float(angle) for angle in best * np.sign(best[0]))


def printed_general(arm: PlanarArm, q: np.ndarray) -> np.ndarray:
    """μ² (m,) by the first form of (5.2) as printed, at q (m, 3)."""
    l1, l2, l3 = arm.lengths
    sizes = [l1 * l2 * l3**2, -(l1**2) * l2**2 / 2, l1 * l2**2 * l3, -(l2**2) * l3**2]
    sizes += [-(l1**2) * l3**2, -(l1**2) * l2 * l3, -l1 * l2 * l3**2]
    constant = l1**2 * l2**2 / 2 + (l1**2 + l2**2) * l3**2
    return np.asarray(constant + np.cos(q[:, 1:] @ _FREQUENCIES.T) @ np.array(sizes))


def printed_trace(arm: PlanarArm, q: np.ndarray) -> float:
    """tr(J Jᵀ) by (4.2) as printed, with the innermost sum from m = i + 1."""
    phi, size, n = np.cumsum(q), arm.lengths, arm.n
    terms = (size[p] * size[m] * np.cos(phi[m] - phi[p]) for i in range(n - 1) for p in range(i, n) for m in range(i + 1, n))
    return float(np.arange(1, n + 1) @ size**2 + 2 * sum(terms))


def theorems() -> list[tuple[str, str, bool]]:
    """Each statement, how it is shown, and whether it holds."""
    rng = np.random.default_rng(0)
    links = f"n = {config.LINKS[0]} to {config.LINKS[-1]}"
    q = rng.uniform(-np.pi, np.pi, (200, 3))
    posture = np.array([0.3, *config.TABLE_5_1[1:3]])
    trace = 2 * float(frobenius_norm(ARM, posture)) ** 2
    values = CORRECTED_5_3(q[:, 1:]) + CONSTANT
    printed = PRINTED_5_3(q[:, 1:]) + PRINTED_CONSTANT
    exact, other = squared_manipulability(ARM, q), PlanarArm([1.0, 0.8, 0.6])
    roots = [rng.normal(size=(m, m)) for m in range(1, 7)]
    matrices = [root @ root.T for root in roots]
    ellipsoids = [matrix_ellipsoid(matrix) for matrix in matrices]
    on_surface = [
        np.einsum("im,ij,jm->m", e.axes * e.radii, a, e.axes * e.radii) for e, a in zip(ellipsoids, matrices, strict=True)
    ]
    volumes = [
        (e.volume, math.pi ** (m / 2) / math.gamma(m / 2 + 1) * math.sqrt(np.linalg.det(np.linalg.inv(a))))
        for m, e, a in zip(range(1, 7), ellipsoids, matrices, strict=True)
    ]
    duals = [velocity_ellipse(ARM, each).radii * force_ellipse(ARM, each).radii[::-1] for each in q]
    counter = [convexity_counterexample(PlanarArm(rng.uniform(0.2, 2.0, n))) for n in config.LINKS]
    return [
        ("Theorem 4.1: ‖J‖_F does not depend on θ₁", f"{EXACT}, {links}", _all(frobenius_theorem)),
        (
            "(4.2) as printed, m from i + 1",
            f"tr(J Jᵀ) = {trace:.4f}, the print gives {printed_trace(ARM, posture):.4f} at Table 5.1",
            bool(abs(printed_trace(ARM, posture) - trace) < 1e-9),
        ),
        ("(4.2) with m from p + 1, as its proof says", f"{EXACT}, {links}", _all(frobenius_theorem)),
        ("Theorem 4.2: μ does not depend on θ₁", f"{EXACT}, {links}", _all(manipulability_theorem)),
        (
            "Proposition 4.3: μ is not convex",
            f"θ_a, θ_b, θ_c of the proof, random lengths, {links}; μ(θ_b) is (4.27)",
            all(each.holds and math.isclose(each.manipulability[1], each.closed_form, rel_tol=1e-12) for each in counter),
        ),
        ("Theorem 4.4: κ does not depend on θ₁", f"{EXACT}, {links}", _all(condition_theorem)),
        ("(5.2), first form, unit links", "200 random postures", bool(np.allclose(printed_general(ARM, q), exact))),
        (
            "(5.2), first form, other lengths",
            "200 random postures, links of 1.0, 0.8 and 0.6 m",
            bool(np.allclose(printed_general(other, q), squared_manipulability(other, q), atol=1e-9)),
        ),
        (
            "(5.2), last form, as printed",
            "200 random postures",
            bool(np.allclose(printed, exact, atol=1e-9)),
        ),
        ("(5.2) with 5/2 and -cos 2θ₃", "the same; and term by term from the minors of J", _is_series(values, exact)),
        (
            "(2.22), (2.25): axes of the force ellipse are 1/σ of the velocity ellipse's",
            "200 random postures",
            bool(np.allclose(duals, 1.0, rtol=1e-9)),
        ),
        (
            "Appendix A: the axes of xᵀ A x = 1 are 1/√λ long",
            "ends of the axes put into the equation, random A, m = 1 to 6",
            all(np.allclose(each, 1.0, rtol=1e-9) for each in on_surface),
        ),
        (
            "Appendix B: V = K √det(A⁻¹)",
            "the same A, by LU factors",
            all(math.isclose(a, b, rel_tol=1e-9) for a, b in volumes),
        ),
    ]


def _all(theorem: object) -> bool:
    return all(theorem(n).holds for n in config.LINKS)  # type: ignore[operator]  # a theorem is a function of n


def _is_series(values: np.ndarray, exact: np.ndarray) -> bool:
    series = squared_manipulability_series(ARM)
    own = {tuple(np.abs(k)): c for k, c in zip(series.frequencies.tolist(), series.cosine.tolist(), strict=True)}
    terms = {tuple(k): c for k, c in zip(_FREQUENCIES.tolist(), CORRECTED_5_3.cosine.tolist(), strict=True)}
    same = own.keys() == {*terms, (0.0, 0.0)} and all(abs(own[k] - c) < 1e-12 for k, c in terms.items())
    return same and bool(np.allclose(values, exact, atol=1e-9))


def theorems_table(rows: list[tuple[str, str, bool]]) -> Table:
    """Chapter 4 and the appendices."""
    return Table.of("theorems", ("statement", "how shown", "holds"), rows)


def table_5_1(results: Results) -> Table:
    """Thesis, ours, difference, and the result of (5.3) as printed."""
    best = results.free.best
    ours = (best.radius[0], *np.abs(best.q[0, 1:]), best.manipulability[0])
    second, third = printed_optimum()
    q = np.array([0.0, second, third])
    printed = (ARM.radius(q), second, third, manipulability(ARM, q))
    signs = ("", "±", "±", "")
    rows = [
        ("thesis", *(f"{sign}{x:.2f}" for sign, x in zip(signs, config.TABLE_5_1, strict=True))),
        ("ours", *(f"{sign}{x:.8f}" for sign, x in zip(signs, ours, strict=True))),
        ("difference", *(signed(a - b, 4) for a, b in zip(ours, config.TABLE_5_1, strict=True))),
        ("maximum of (5.3) as printed", *(f"{sign}{x:.4f}" for sign, x in zip(signs, printed, strict=True))),
    ]
    return Table.of("table5_1", ("", "R [m]", "θ₂ [rad]", "θ₃ [rad]", "μ [m²]"), rows)


def stationary_table(results: Results) -> Table:
    """All stationary postures, one of each mirror pair."""
    found = results.free
    rows = []
    for q, mu, radius in zip(found.q, found.manipulability, found.radius, strict=True):
        bent = np.where(np.abs(q[1:]) < 1e-9, 0.0, q[1:])
        mirrored = bool((np.abs(np.sin(bent)) > 1e-9).any())
        if mirrored and bent[0] < 0:
            continue
        sign = "±" if mirrored else ""
        pair = f"{sign}({bent[0]:.6f}, {bent[1]:.6f})"
        rows.append((pair, f"{abs(mu):.6f}", f"{radius:.6f}", stationary_kind(ARM, q)))
    return Table.of("stationary", ("(θ₂, θ₃) [rad]", "μ [m²]", "R [m]", "of μ²"), rows)


def table_5_2(results: Results) -> Table:
    """Thesis and ours for every radius."""
    rows = []
    for radius, thesis in config.TABLE_5_2.items():
        ours = row_5_2(results, radius)
        cells = [f"{value:.2f} / {own:.6f}" for value, own in zip(thesis, ours, strict=True)]
        furthest = max((own - value for value, own in zip(thesis, ours, strict=True)), key=abs)
        rows.append((f"{radius:.1f}", *cells, signed(furthest, 4)))
    return Table.of("table5_2", ("R [m]", "θ₂ [rad]", "θ₃ [rad]", "μ [m²]", "κ", "largest difference"), rows)


def row_5_2(results: Results, radius: float) -> tuple[float, ...]:
    """θ_2, θ_3, μ, κ of the best posture that bends to the left."""
    best = results.at_radius(radius, limited=True).best
    row = int(best.q[:, 1].argmax())
    return (*(float(x) for x in best.q[row, 1:]), float(best.manipulability[row]), float(best.inverse_condition[row]))


def proportions_table(results: Results) -> Table:
    """Equal links, and links with the best proportions, for a total length of n."""
    rows = []
    for n in config.RATIO_LINKS:
        found, equal = proportions(results, n), equal_links(results, n)
        lengths = " : ".join(f"{x / n:.3f}" for x in found.lengths)
        bends = ", ".join(f"{abs(x):.3f}" for x in found.q[1:])
        gain = f"{100 * (found.manipulability / equal - 1):.1f} %"
        rows.append((str(n), f"{equal:.4f}", lengths, bends, f"{found.manipulability:.4f}", gain, f"{found.bound:.4f}"))
    head = ("n", "μ, equal links [m²]", "best shares of the length", "bends θ₂ … θₙ [rad]", "μ [m²]", "gain", "no arm exceeds")
    return Table.of("proportions", head, rows)


def proportions(results: Results, n: int) -> Proportions:
    """The best link lengths for a total length of n [m]."""
    return results.once(("lengths", n), lambda: optimal_lengths(n, total=float(n), least=config.SHARE * n))


def equal_links(results: Results, n: int) -> float:
    """The largest μ of n unit links [m²]."""
    arm = PlanarArm(np.ones(n))
    return results.once(("equal", n), lambda: float(manipulability(arm, best_posture(arm))))
