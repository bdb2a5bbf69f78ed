"""Tables on the global optimum by fast marching."""

import numpy as np

from studies.kth2012 import config
from studies.kth2012.config import EXAMPLES, FIRST, PAIR_PATHS, TABLE_POWER, TEXT_POWER, Example
from studies.kth2012.results import Results
from studies.kth2012.tables_beyond import MARKS
from studies.tables import Table

#: The problems whose global optimum is sought: example, p, and whether the goal is the best of those a full turn away.
CASES: tuple[tuple[Example, float, bool], ...] = (
    *((example, power, False) for example in EXAMPLES for power in (TABLE_POWER, TEXT_POWER)),
    *((FIRST, power, True) for power in (TABLE_POWER, TEXT_POWER)),
)
#: Share [%] by which the optimiser's path of a random pair counts as above the global optimum.
ABOVE = 0.1


def case_name(example: Example, power: float, shifted: bool) -> str:
    """A problem in tables and claims."""
    return f"{example.name}{', θ₂ - 2π' if shifted else ''}, p = {power:g}"


def best_path(results: Results, example: Example, power: float, shifted: bool) -> float:
    """g of the optimiser's path of degree 6."""
    goal = results.shifted_goal(example) if shifted else np.array(example.goal)
    return float(results.to_goal(example, power, goal).g) if shifted else float(results.path(example, 6, power).g)


def global_table(results: Results) -> Table:
    """V by grid step, the geodesic that it leads to, and the optimiser's path."""
    rows = []
    for case in CASES:
        found, ours = results.global_optimum(*case[:2], shifted=case[2]), best_path(results, *case)
        values = [f"{each:.4f}" for each in found.values]
        above = f"{ours / found.path.g - 1:.1e}"
        rows.append((case_name(*case), *values, f"{found.path.g:.6f}", f"{ours:.6f}", above, f"{found.outside:.2f}"))
    steps = tuple(f"V, step {each:g} rad" for each in config.MARCH_STEPS)
    head = ("problem", *steps, "its path, polished", "optimiser, degree 6", "above it, share", "through the walls, at least")
    return Table.of("global", head, rows)


def turns_table(results: Results) -> Table:
    """V at all goals that differ by full turns of θ₂ and θ₃."""
    rows = []
    for example in EXAMPLES:
        for power in (TABLE_POWER, TEXT_POWER):
            values = results.turns(example, power)
            best = min(values, key=lambda each: values[each])
            rows.append((example.name, f"{power:g}", *(f"{each:.2f}" for each in values.values()), _turn(best)))
    head = ("example", "p", *(_turn(each) for each in results.turns(FIRST, TABLE_POWER)), "best")
    return Table.of("turns", head, rows)


def _turn(shift: tuple[int, int]) -> str:
    return f"({', '.join(MARKS[each] for each in shift)})"


def global_posts_table(results: Results) -> Table:
    """V among posts by grid step, the polyline that it leads to, and the study's path."""
    rows = []
    for example, posts in config.POSTS:
        (values, best), ours = results.among_optimum(example, posts), results.among(example, posts).g
        low = results.among(example, posts, config.LOW_DEGREE).g
        places = ", ".join(f"({x:g}, {y:g})" for x, y in posts)
        paths = (f"{best:.4f}", f"{low:.4f}", f"{ours:.4f}", f"{ours / best - 1:.1e}")
        rows.append((example.name, places, *(f"{each:.3f}" for each in values), *paths))
    steps = tuple(f"V, step {each:g} rad" for each in config.POST_STEPS)
    degrees = (f"optimiser, degree {config.LOW_DEGREE}", f"degree {config.OBSTACLE_DEGREE}")
    head = ("example", "posts at [m]", *steps, "its path, polished", *degrees, "above it, share")
    return Table.of("global_posts", head, rows)


def pairs_table(results: Results) -> Table:
    """How often one run of the optimiser misses the global optimum of a random pair."""
    rows = []
    for power in (TABLE_POWER, TEXT_POWER):
        values, polished, *found = results.pairs(power).T
        coarse = 100 * (values / polished - 1)
        for count, g in zip((1, PAIR_PATHS), found, strict=True):
            excess = 100 * (g / polished - 1)
            shares = (*(f"{np.percentile(excess, each):.3f}" for each in (50, 90, 100)), str(int((excess > ABOVE).sum())))
            rows.append((f"{power:g}", str(len(g)), f"{coarse.min():.2f}, {coarse.max():.2f}", str(count), *shares))
    head = ("p", "pairs", "V on the grid: least, most [%]", "first paths", "median [%]", "90 % of pairs [%]", "most [%]")
    return Table.of("pairs", (*head, f"above by more than {ABOVE:g} %"), rows)
