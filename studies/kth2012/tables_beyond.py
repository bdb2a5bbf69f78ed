"""Tables on the questions that the thesis leaves open: classes, shifted goals, convergence, posts, more links."""

import numpy as np

from manipplan.planar import inverse_condition
from studies.kth2012 import classes, config
from studies.kth2012.config import EXAMPLES
from studies.kth2012.many_links import ManyLinks, many_links
from studies.kth2012.results import Crossing, Results
from studies.tables import Table

MARKS = {-1: "-2π", 0: "0", 1: "+2π"}


def classes_table(results: Results) -> Table:
    """Every class of the three examples within one winding, the best first."""
    rows = []
    for example in EXAMPLES:
        found = sorted((each for each in results.classes if each.example is example), key=lambda each: each.found.g)
        rows += [(example.name, *_crossing(each)) for each in found]
    return Table.of("classes", ("example", "class", "g, p = 2", "length [rad]", "minimum μ [m²]"), rows)


def torus_table(results: Results) -> Table:
    """The best goals among those that differ by full turns, and the goal of the example itself."""
    rows = []
    for example in EXAMPLES:
        found = sorted((each for each in results.torus if each.example is example), key=lambda each: each.found.g)
        shown = [*found[:2], *(each for each in found[2:] if each.shift == (0, 0, 0))]
        for each in shown:
            goal = f"({', '.join(MARKS[k] for k in each.shift)})"
            rows.append((example.name, goal, *_crossing(each)))
    return Table.of("torus", ("example", "goal shifted by", "class", "g, p = 2", "length [rad]", "minimum μ [m²]"), rows)


def shifts_table(results: Results) -> Table:
    """mp.optimize_path with shifts="within-limits", compared with the goal of the thesis."""
    rows = []
    for example in EXAMPLES:
        plain, best = results.path(example, config.BEST_DEGREE), results.shifted(example)
        as_good = [each for each in (best, *best.rivals) if each.g <= best.g * (1 + 1e-9)]  # θ_1 = π and -π are equally good
        shifts = [np.round((each.path.goal - np.array(example.goal)) / (2 * np.pi)).astype(int) for each in as_good]
        turns = min(shifts, key=lambda each: int(np.abs(each).sum()))
        limit = results.best_crossing(example, shifted=True).found.g
        goal = f"({', '.join(MARKS[int(k)] for k in turns)})"
        gain = f"{100 * (1 - best.g / plain.g):.1f} %"
        rows.append((example.name, f"{plain.g:.6f}", f"{best.g:.6f}", goal, gain, f"{limit:.6f}", str(1 + len(best.rivals))))
    head = ("example", "goal as it is", "best goal", "shifted by", "better by", "geodesic", "different paths found")
    return Table.of("shifts", head, rows)


def _crossing(each: Crossing) -> tuple[str, ...]:
    found = each.found
    return classes.arrows(each.walk), f"{found.g:.6f}", f"{found.length:.4f}", f"{found.least:.4f}"


def convergence_table(results: Results) -> Table:
    """How far g is above that of the geodesic, by degree, for both exponents."""
    cases = [(example, power) for example in EXAMPLES for power in (config.TABLE_POWER, config.TEXT_POWER)]
    rows: list[tuple[str, ...]] = [("geodesic", *(f"{results.limit(*case).g:.8f}" for case in cases))]
    for degree in range(1, config.MOST_DEGREE + 1):
        above = (gap(results, *case, degree) for case in cases)
        rows.append((str(degree), *(f"{x:+.1e}" for x in above)))
    return Table.of("convergence", ("degree", *(f"{example.name}, p = {power:g}" for example, power in cases)), rows)


def two_links_table(results: Results) -> Table:
    """The check in closed form: two links and p = 1."""
    curve, polynomial, exact = results.two_links()
    names = ("hyperbolic distance", "geodesic", f"mp.optimize_path, degree {config.MOST_DEGREE}")
    rows = [
        (name, f"{g:.9f}", "" if g == exact else f"{g - exact:+.0e}")
        for name, g in zip(names, (exact, curve, polynomial), strict=True)
    ]
    return Table.of("two_links", ("two links, p = 1", "g", "difference"), rows)


def gap(results: Results, example: config.Example, power: float, degree: int) -> float:
    """g of the optimal polynomial minus that of the geodesic."""
    return float(results.path(example, degree, power).g - results.limit(example, power).g)


def obstacles_table(results: Results) -> Table:
    """Paths among posts, compared with the optimum without posts."""
    rows = []
    for example, posts in config.POSTS:
        free, found = results.path(example, config.OBSTACLE_DEGREE), results.among(example, posts)
        places = ", ".join(f"({x:g}, {y:g})" for x, y in posts)
        others = ", ".join(f"{each.g:.3f}" for each in found.rivals)
        rows.append(
            (
                example.name,
                places,
                f"{free.g:.4f}",
                f"{found.seed_cost.g:.4f}",
                f"{found.g:.4f}",
                others,
                f"{1000 * found.certificate.proven_clearance:.1f}",
                f"{found.min_manipulability:.3f}",
            )
        )
    head = (
        "example",
        "posts at [m]",
        "no posts",
        "planner's path",
        "ours",
        "other ways",
        "proven clearance [mm]",
        "minimum μ [m²]",
    )
    return Table.of("obstacles", head, rows)


def links(results: Results) -> list[ManyLinks]:
    """Arms with an increasing number of unit links."""
    return [results.once(("links", n), lambda n=n: many_links(n)) for n in config.MANY_LINKS]


def links_table(results: Results) -> Table:
    """Optimal postures, and one path per arm."""
    rows = []
    for each in links(results):
        bends = ", ".join(f"{x:.4f}" for x in each.q[1:])
        straight = each.path.seed_cost.g
        rows.append(
            (
                str(each.arm.n),
                bends,
                f"{each.manipulability:.6f}",
                f"{float(each.arm.radius(each.q)):.4f}",
                f"{float(inverse_condition(each.arm, each.q)):.4f}",
                "proven" if each.proven else f"{config.POSTURE_STARTS} starts",
                f"{straight:.4f}",
                f"{each.path.g:.4f}",
            )
        )
    head = ("n", "θ₂ … θₙ [rad]", "μ [m²]", "R [m]", "κ", "largest", "g of the line", "g, degree 6")
    return Table.of("links", head, rows)
