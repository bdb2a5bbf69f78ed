"""Tables of chapter 6: thesis, ours, difference."""

import numpy as np

import manipplan as mp
from studies.kth2012 import config
from studies.kth2012.config import FIRST, SECOND, THIRD, Example
from studies.kth2012.polynomials import Means, means, polynomial
from studies.kth2012.results import Results, signed
from studies.tables import Table


def degrees_table(results: Results, example: Example, name: str) -> Table:
    """Table 6.1 or 6.2: g by degree, with p = 2 as in the table and p = 1 as in the text."""
    rows, before = [], None
    for degree, thesis in zip(config.DEGREES, example.thesis, strict=True):
        g, text = results.path(example, degree).g, results.path(example, degree, config.TEXT_POWER).g
        random = f"{results.multistart(example, degree):.6f}" if degree in results.start_degrees else ""
        change = "" if before is None else f"{before - g:.4f}"
        rows.append((str(degree), f"{thesis:.4f}", f"{g:.6f}", signed(g - thesis, 4), change, random, f"{text:.6f}"))
        before = g
    head = ("degree", "thesis", "ours, p = 2", "difference", "Δg, ours", "random starts", "ours, p = 1")
    return Table.of(name, head, rows)


def path_tables(results: Results) -> tuple[Table, Table]:
    """Tables 6.1 and 6.2."""
    return degrees_table(results, FIRST, "table6_1"), degrees_table(results, SECOND, "table6_2")


def table_6_3(results: Results) -> Table:
    """The coefficients of (6.14), printed and ours."""
    ours = results.path(THIRD, config.BEST_DEGREE).path.coefficients("monomial")
    rows = []
    for i, (printed, own) in enumerate(zip(config.TABLE_6_3, ours, strict=True), start=1):
        joint = "₁₂₃"[i - 1]
        rows.append((f"a{joint}ⱼ, thesis", *(f"{a:.2f}" for a in printed), f"{sum(printed):.2f}"))
        rows.append((f"a{joint}ⱼ, ours", *(f"{a:.2f}" for a in own), f"{own.sum():.2f}"))
        rows.append(("difference", *(signed(b - a, 2) for a, b in zip(printed, own, strict=True)), ""))
    return Table.of("table6_3", ("j", *(str(j) for j in range(7)), "sum"), rows)


def printed_path() -> mp.JointPath:
    """The path with the coefficients of Table 6.3 as printed."""
    return polynomial(config.TABLE_6_3)


def corrected_path() -> mp.JointPath:
    """The same path, with the rounding error at the goal corrected in the linear terms."""
    a = np.array(config.TABLE_6_3)
    a[:, 1] += np.array(THIRD.goal) - a.sum(axis=1)
    return polynomial(a)


def costs_6_3(results: Results) -> Table:
    """g and length of the printed path, of ours and of the line; they do not depend on the parametrisation."""
    line, ours = (results.path(THIRD, degree) for degree in (1, config.BEST_DEGREE))
    printed, right = (mp.path_cost(each, results.kinematics, config.TABLE_POWER) for each in (printed_path(), corrected_path()))
    text = [results.path(THIRD, degree, config.TEXT_POWER) for degree in (1, config.BEST_DEGREE)]
    rows = [
        ("line", f"{line.g:.6f}", f"{line.length:.6f}", f"{line.min_manipulability:.4f}", f"{text[0].g:.6f}"),
        ("Table 6.3, as printed", f"{printed.g:.6f}", f"{printed.length:.6f}", f"{printed.min_manipulability:.4f}", ""),
        ("the same, its goal put right", f"{right.g:.6f}", f"{right.length:.6f}", f"{right.min_manipulability:.4f}", ""),
        ("ours, degree 6", f"{ours.g:.6f}", f"{ours.length:.6f}", f"{ours.min_manipulability:.4f}", f"{text[1].g:.6f}"),
        ("random starts, degree 6", "" if results.quick else f"{results.multistart(THIRD, 6):.6f}", "", "", ""),
    ]
    return Table.of("costs6_3", ("path", "g, p = 2", "length [rad]", "minimum μ [m²]", "g of the optimum with p = 1"), rows)


def table_6_4(results: Results) -> Table:
    """The ratios between the line and the optimum: as printed, recomputed, and by arc length."""
    kept = ratios_6_4(results)
    first = "g/g_L, headed g_L/g"
    head = ("", first, "length_L/length", "∫μ_L/∫μ", "∫κ_L/∫κ")
    rows = [
        ("thesis", *(f"{x:.2f}" for x in config.TABLE_6_4)),
        ("thesis' coefficients, by t", *(f"{x:.4f}" for x in kept["thesis"])),
        ("ours, by t", *(f"{x:.4f}" for x in kept["ours"])),
        ("difference", *(signed(a - b, 4) for a, b in zip(kept["ours"], config.TABLE_6_4, strict=True))),
        ("thesis' coefficients, by arc length", "", "", *(f"{x:.4f}" for x in kept["thesis by length"])),
        ("ours, by arc length", "", "", *(f"{x:.4f}" for x in kept["ours by length"])),
        ("ours with p = 1, by arc length", *(f"{x:.4f}" for x in kept["text by length"])),
    ]
    return Table.of("table6_4", head, rows)


def ratios_6_4(results: Results) -> dict[str, tuple[float, ...]]:
    """The rows of Table 6.4."""
    line, ours = (results.path(THIRD, degree) for degree in (1, config.BEST_DEGREE))
    text_line, text = (results.path(THIRD, degree, config.TEXT_POWER) for degree in (1, config.BEST_DEGREE))
    straight, printed = means(line.path), means(corrected_path())
    cost = mp.path_cost(corrected_path(), results.kinematics, config.TABLE_POWER)
    own, by_text = means(ours.path), means(text.path)
    return {
        "thesis": (cost.g / line.g, line.length / cost.length, straight.mu / printed.mu, straight.kappa / printed.kappa),
        "ours": (ours.g / line.g, line.length / ours.length, straight.mu / own.mu, straight.kappa / own.kappa),
        "thesis by length": _by_length(straight, printed),
        "ours by length": _by_length(straight, own),
        "text by length": (text.g / text_line.g, text_line.length / text.length, *_by_length(straight, by_text)),
    }


def _by_length(line: Means, path: Means) -> tuple[float, float]:
    return line.mu_by_length / path.mu_by_length, line.kappa_by_length / path.kappa_by_length
