"""Statements of the thesis without a table of their own: Frobenius norm, workspaces, distances of paths, a rounding."""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.spatial.distance import directed_hausdorff

import manipplan as mp
from manipplan.planar import dexterous_annuli, frobenius_norm, manipulability, reachable_annulus
from studies.kth2012 import config
from studies.kth2012.config import ARM, EXAMPLES, THIRD
from studies.kth2012.polynomials import polynomial
from studies.kth2012.results import Results
from studies.kth2012.tables_paths import corrected_path
from studies.tables import Table

Array = NDArray[np.float64]
#: Printed with two decimals: the true coefficient is at most this far away.
HALF = 0.005
ROUNDINGS = 400


def frobenius_extremes() -> tuple[tuple[Array, float, float], tuple[Array, float, float]]:
    """Posture, ‖J‖_F and μ of its maximum and of its minimum, the best of many descents."""
    random = np.random.default_rng(0)

    def extreme(sign: float) -> tuple[Array, float, float]:
        found = min(
            (
                minimize(lambda x: sign * float(frobenius_norm(ARM, [0.0, *x])), start, tol=1e-12)
                for start in random.uniform(-np.pi, np.pi, (20, 2))
            ),
            key=lambda each: each.fun,
        )
        q = np.array([0.0, *(np.mod(found.x + np.pi, 2 * np.pi) - np.pi)])
        q *= -np.sign(q[1]) if abs(q[1]) > 1e-4 else 0.0  # of a posture and its mirror image, θ_2 < 0
        return q, float(frobenius_norm(ARM, q)), float(manipulability(ARM, q))

    return extreme(-1.0), extreme(1.0)


def frobenius_table() -> Table:
    """4.1.2: why the Frobenius norm is no goal."""
    rows = [
        (name, f"({q[1] + 0.0:.3f}, {q[2] + 0.0:.3f})", f"{norm:.4f}", f"{np.sqrt(2) * norm:.4f}", f"{mu:.4f}")
        for name, (q, norm, mu) in zip(("maximum", "minimum"), frobenius_extremes(), strict=True)
    ]
    return Table.of("frobenius", ("", "(θ₂, θ₃) [rad]", "√(tr(J Jᵀ)/2)", "√tr(J Jᵀ)", "μ [m²]"), rows)


def workspaces_table() -> Table:
    """Definitions 2.5 and 2.6 for the unit arm: positions that can be reached, and those with every orientation."""
    reachable, dexterous = reachable_annulus(ARM), dexterous_annuli(ARM)
    rows = [("reachable, Definition 2.5", f"{reachable.inner:g}", f"{reachable.outer:g}")]
    rows += [("dexterous, Definition 2.6", f"{each.inner:g}", f"{each.outer:g}") for each in dexterous]
    return Table.of("workspaces", ("workspace", "from R [m]", "to R [m]"), rows)


def apart(first: mp.JointPath, second: mp.JointPath) -> tuple[float, float]:
    """Hausdorff distance of two curves [rad]: in (θ_2, θ_3), and in all joints."""
    s = np.linspace(0.0, 1.0, 1501)
    a, b = first(s), second(s)

    def distance(a: Array, b: Array) -> float:
        return float(max(directed_hausdorff(a, b)[0], directed_hausdorff(b, a)[0]))

    return distance(a[:, 1:], b[:, 1:]), distance(a, b)


def distances(results: Results) -> dict[tuple[str, int], tuple[float, float]]:
    """How far the optimal path of a degree is from that of degree 6 [rad]."""
    return {
        (example.name, degree): apart(results.path(example, degree).path, results.path(example, config.BEST_DEGREE).path)
        for example in EXAMPLES[:2]
        for degree in config.DEGREES[1:-1]
    }


def printed_apart(results: Results) -> tuple[float, float]:
    """How far the curve of Table 6.3 is from ours [rad]."""
    return apart(corrected_path(), results.path(THIRD, config.BEST_DEGREE).path)


def distances_table(results: Results) -> Table:
    """Whether degrees of three or more give approximately the same path."""
    rows = [
        (f"{name}, degree {degree}", "ours, degree 6", f"{plane:.3f}", f"{every:.3f}")
        for (name, degree), (plane, every) in distances(results).items()
    ]
    plane, every = printed_apart(results)
    rows.append(("(6.13), Table 6.3", "ours, degree 6", f"{plane:.3f}", f"{every:.3f}"))
    return Table.of("distances", ("path", "from", "apart in (θ₂, θ₃) [rad]", "in all joints [rad]"), rows)


def roundings(results: Results) -> tuple[float, float, float]:
    """g/g_L of Table 6.4 from coefficients that round to the printed ones and end at the goal: least, most, share ≥ 0.265."""
    line, random = results.path(THIRD, 1).g, np.random.default_rng(0)
    printed, found = np.array(config.TABLE_6_3), []
    gap = np.array(THIRD.goal) - printed.sum(axis=1)
    for _ in range(ROUNDINGS):
        noise = random.uniform(-HALF, HALF, (3, 6))
        noise += ((gap - noise.sum(axis=1)) / 6)[:, None]
        if np.abs(noise).max() <= HALF:
            a = printed.copy()
            a[:, 1:] += noise
            found.append(mp.path_cost(polynomial(a), results.kinematics, config.TABLE_POWER).g / line)
    values = np.array(found)
    return float(values.min()), float(values.max()), float((values >= 0.265).mean())


def rounding_table(results: Results) -> Table:
    """Table 6.4: g/g_L, depending on where the rounding error at the goal is put."""
    line, printed = results.path(THIRD, 1).g, np.array(config.TABLE_6_3)
    gap = np.array(THIRD.goal) - printed.sum(axis=1)
    rows = [("as printed, goal missed", _ratio(results, printed, line))]
    for j in range(1, 7):
        a = printed.copy()
        a[:, j] += gap
        rows.append((f"error put into aᵢ{'₀₁₂₃₄₅₆'[j]}", _ratio(results, a, line)))
    least, most, share = roundings(results)
    rows.append((f"random roundings: {100 * share:.0f} % print as 0.27", f"{least:.6f} to {most:.6f}"))
    rows.append(("ours, degree 6", f"{results.path(THIRD, config.BEST_DEGREE).g / line:.5f}"))
    return Table.of("rounding", ("coefficients of Table 6.3", "g/g_L, printed as 0.27"), rows)


def _ratio(results: Results, a: Array, line: float) -> str:
    return f"{mp.path_cost(polynomial(a), results.kinematics, config.TABLE_POWER).g / line:.6f}"
