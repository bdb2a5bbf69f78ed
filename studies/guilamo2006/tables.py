"""The tables of the study."""

import numpy as np

from studies.guilamo2006 import config
from studies.guilamo2006.courses import Course
from studies.guilamo2006.runs import Grid, Restarted, Runs, Sampled, Searched
from studies.tables import Cell, Table

NONE = "-"


def grid_name(grid: Grid) -> str:
    """The name of a grid in tables and figures."""
    return " × ".join(str(each) for each in grid)


def epsilon_of(course: Course, grid: Grid) -> float:
    """The ε [degrees] of Table I for a course on a grid."""
    return (config.COARSE_EPSILON if grid == config.COARSE else config.FULL_EPSILON)[course.name]


def most_of(grid: Grid) -> int:
    """The number of branches after which the paper's search is stopped."""
    return config.MOST_BRANCHES if grid == config.COARSE else config.MOST_BRANCHES_FULL


def table_1(runs: Runs, courses: tuple[Course, ...], grids: tuple[Grid, ...]) -> Table:
    """Table I: the paper's rows, and ours for the paper's search, with and without memoisation, and for the exact search."""
    head = ("path", "search", "ε [°]", "considered per position", "valid", "per position", "positions", "new starts")
    rows: list[tuple[Cell, ...]] = [
        ("circle", "paper", 2, "306306", "59561", "~800-2000", 50, "9407", "36596", "~4", NONE, "1.5 min"),
        ("line", "paper", NONE, "306306", "33902", NONE, 20, NONE, NONE, "~6", NONE, "20 s, text: 4 s"),
    ]
    for grid in grids:
        for course in courses:
            sampled, epsilon = runs.sampled(course, grid), epsilon_of(course, grid)
            searches = [runs.restarted(sampled, epsilon, memoised=each, most=most_of(grid)) for each in (False, True)]
            rows += [_search_row(each) for each in searches]
            rows.append(_exact_row(runs.searched(sampled, epsilon, "first")))
    return Table.of("table1", (*head, "branches", "branching factor", "minimum manipulability", "time of search"), rows)


def _common(sampled: Sampled, epsilon: float, search: str) -> tuple[Cell, ...]:
    sizes = sampled.layers.sizes
    spread = f"{sizes.min()}-{sizes.max()}"
    whole = (str(sampled.per_position), str(sampled.layers.count), spread, len(sizes))
    return sampled.course.name, search, epsilon, *whole


def _search_row(run: Restarted) -> tuple[Cell, ...]:
    name = "the paper's, memoised" if run.memoised else "the paper's"
    found = run.found
    least: Cell = f"{found.minimum:.5f}" if run.ended else "did not end"
    counts = (str(found.new_starts), str(found.branches), run.factor)
    return *_common(run.sampled, run.epsilon, name), *counts, least, NONE


def _exact_row(run: Searched) -> tuple[Cell, ...]:
    least = f"{run.found.minimum:.5f}" if run.found.connected else "not connected"
    passes = f"{run.found.rounds} pass{'es' if run.found.rounds > 1 else ''}"
    return *_common(run.sampled, run.epsilon, "exact"), passes, NONE, NONE, least, seconds(run.seconds)


def seconds(value: float) -> str:
    """The text of a duration."""
    return f"{1e3 * value:.2g} ms" if value < 0.1 else f"{value:.2g} s" if value < 10 else f"{value:.0f} s"


def starts_table(runs: Runs, courses: tuple[Course, ...], grids: tuple[Grid, ...]) -> Table:
    """Number of starts that the paper's search needs, computed from the exact optimum."""
    rows = []
    for grid in grids:
        for course in courses:
            sampled, epsilon = runs.sampled(course, grid), epsilon_of(course, grid)
            found = runs.searched(sampled, epsilon, "first").found
            memoised = runs.restarted(sampled, epsilon, memoised=True, most=most_of(grid))
            did: Cell = str(memoised.found.new_starts) + ("" if memoised.ended else ", not ended")
            rows.append(
                (
                    course.name,
                    grid_name(grid),
                    epsilon,
                    f"{found.bound:.5f}",
                    f"{found.minimum:.5f}",
                    str(sampled.above(found.minimum)),
                    did,
                    str(memoised.found.comparisons),
                )
            )
    head = ("path", "grid", "ε [°]", "bound", "optimum", "candidates from optimum to bound", "starts, memoised")
    return Table.of("starts", (*head, "comparisons"), rows)


def needed(runs: Runs, course: Course, grid: Grid, epsilon: float) -> int:
    """Number of starts that the paper's search needs: the candidates above the optimum, and the one that succeeds."""
    sampled = runs.sampled(course, grid)
    return sampled.above(runs.searched(sampled, epsilon, "first").found.minimum) + 1


def resolution_table(runs: Runs, course: Course, grids: tuple[Grid, ...]) -> Table:
    """Section VI: starts that the paper's search needs, by the number of samples and ε."""
    rows = []
    for grid in grids:
        sampled = runs.sampled(course, grid)
        found = [runs.searched(sampled, each, "first").found.minimum for each in config.COMPARED_EPSILONS]
        counts = [str(needed(runs, course, grid, each)) for each in config.COMPARED_EPSILONS]
        cells = [cell for pair in zip(counts, (f"{each:.4f}" for each in found), strict=True) for cell in pair]
        rows.append((grid_name(grid), str(sampled.per_position), f"{sampled.layers.bound:.4f}", *cells))
    parts = [cell for each in config.COMPARED_EPSILONS for cell in (f"starts at {each:g}°", f"optimum at {each:g}°")]
    return Table.of("resolution", ("grid", "samples per position", "bound", *parts), rows)


def sampling_table(runs: Runs, courses: tuple[Course, ...], grids: tuple[Grid, ...]) -> Table:
    """Optimum by ε and grid, with the bound and the smallest ε that connects."""
    rows = []
    for course in courses:
        for grid in grids:
            rows.append(_sampling_row(runs, runs.sampled(course, grid), grid_name(grid)))
        if config.FULL in grids:
            full = runs.sampled(course, config.FULL)
            rows.append(
                _sampling_row(runs, runs.thinned(full, config.THIN), f"{grid_name(config.FULL)}, every {config.THIN}nd")
            )
    heads = tuple(f"ε = {each:g}°" for each in config.EPSILONS)
    return Table.of(
        "sampling", ("path", "grid", "widest step [°]", "valid", "smallest ε [°]", "bound", *heads, "sampling [s]"), rows
    )


def _sampling_row(runs: Runs, sampled: Sampled, name: str) -> tuple[Cell, ...]:
    smallest = runs.smallest(sampled)
    optima: list[Cell] = []
    for epsilon in config.EPSILONS:
        connected = epsilon > smallest
        optima.append(f"{runs.searched(sampled, epsilon, 'first').found.minimum:.4f}" if connected else NONE)
    count, bound = str(sampled.layers.count), f"{sampled.layers.bound:.4f}"
    return (
        sampled.course.name,
        name,
        f"{sampled.widest:.2f}",
        count,
        f"{smallest:.2f}",
        bound,
        *optima,
        f"{sampled.seconds:.2f}",
    )


def branching_runs(runs: Runs, course: Course) -> list[Restarted]:
    """The paper's search, memoised, over ε and the coarse grids whose size is near the paper's."""
    found = []
    for grid in (config.GRIDS[1], config.COARSE, config.GRIDS[3]):
        sampled = runs.sampled(course, grid)
        smallest = runs.smallest(sampled)
        for epsilon in config.EPSILONS:
            if epsilon > smallest:
                found.append(runs.restarted(sampled, epsilon, memoised=True, most=config.MOST_BRANCHES_SWEEP))
    return found


def branching_table(found: list[Restarted]) -> Table:
    """Section VI: branching factor and comparisons by ε and resolution."""
    rows = [
        (
            grid_name(run.sampled.grid),
            run.epsilon,
            str(run.sampled.layers.count),
            str(run.found.new_starts),
            str(run.found.branches),
            run.factor,
            f"{run.found.comparisons:.2e}",
            run.ended,
        )
        for run in found
    ]
    head = ("grid", "ε [°]", "valid", "new starts", "branches", "branching factor", "comparisons", "ended")
    return Table.of("branching", head, rows)


def refinement_table(runs: Runs, searches: list[Searched]) -> Table:
    """Minimum manipulability of the discrete, resampled and refined paths, and the bound."""
    rows = []
    for searched in searches:
        refined = runs.refined(searched)
        result, found = refined.refinement, searched.found
        rows.append(
            (
                searched.sampled.course.name,
                grid_name(searched.sampled.grid),
                searched.epsilon,
                f"{result.discrete:.5f}",
                f"{result.resampled:.5f}",
                f"{result.refined:.5f}",
                f"{result.bound:.5f}",
                f"{100 * (result.bound - result.discrete) / result.bound:.2f}",
                f"{100 * (result.bound - result.refined) / result.bound:.3f}",
                f"{found.length:.2f}",
                f"{result.length:.2f}",
                seconds(refined.seconds),
            )
        )
    head = ("path", "grid", "ε [°]", "discrete", "finer samples", "refined", "bound", "discrete below the bound [%]")
    return Table.of(
        "refinement", (*head, "refined below it [%]", "length, discrete [rad]", "refined [rad]", "time of refinement"), rows
    )


def ties_table(runs: Runs, searches: list[Searched]) -> Table:
    """The first path found against the shortest of the same minimum manipulability."""
    rows = []
    for shortest in searches:
        first = runs.searched(shortest.sampled, shortest.epsilon, "first")
        rows.append(
            (
                shortest.sampled.course.name,
                grid_name(shortest.sampled.grid),
                shortest.epsilon,
                f"{first.found.minimum:.5f}",
                first.found.minimum == shortest.found.minimum,
                f"{first.found.length:.2f}",
                f"{shortest.found.length:.2f}",
                f"{shorter(first, shortest):.1f}",
                seconds(first.seconds),
                seconds(shortest.seconds),
            )
        )
    head = ("path", "grid", "ε [°]", "minimum manipulability", "same", "first [rad]", "shortest [rad]", "shorter by [%]")
    return Table.of("ties", (*head, "time, first", "time, shortest"), rows)


def shorter(first: Searched, shortest: Searched) -> float:
    """By how much the shortest path is shorter than the first one [%]."""
    return 100 * (1 - shortest.found.length / first.found.length)


def closed_table(pairs: list[tuple[Searched, Searched]]) -> Table:
    """The circle as an open path and as a cycle."""
    rows = []
    for pair in pairs:
        for name, run in zip(("open", "closed"), pair, strict=True):
            end = run.found.q[0] - run.found.q[-1]
            rows.append(
                (
                    grid_name(run.sampled.grid),
                    run.epsilon,
                    name,
                    str(run.sampled.layers.count),
                    f"{run.found.minimum:.5f}",
                    f"{run.found.bound:.5f}",
                    f"{run.found.length:.2f}",
                    f"{np.rad2deg(np.abs(end).max()):.2f}",
                    run.found.rounds,
                    seconds(run.seconds),
                )
            )
    head = (
        "grid",
        "ε [°]",
        "circle",
        "valid",
        "minimum manipulability",
        "bound",
        "length [rad]",
        "last to first position, largest step [°]",
    )
    return Table.of("closed", (*head, "passes", "time"), rows)


def collisions_table(runs: Runs, courses: tuple[Course, Course]) -> Table:
    """Effect of the filter for self-collisions."""
    rows = []
    circle, line = courses
    pairs = [(circle, each) for each in config.COMPARED_EPSILONS] + [(line, config.COARSE_EPSILON["line"])]
    for course, epsilon in pairs:
        for collisions in (False, True):
            sampled = runs.sampled(course, config.COARSE, collisions=collisions)
            run = runs.searched(sampled, epsilon, "first")
            rows.append(
                (
                    course.name,
                    epsilon,
                    "dropped" if collisions else "kept",
                    str(sampled.layers.count),
                    int(sampled.layers.sizes.min()),
                    f"{run.found.bound:.5f}",
                    f"{run.found.minimum:.5f}" if run.found.connected else "not connected",
                    f"{runs.smallest(sampled):.2f}",
                    seconds(sampled.seconds),
                )
            )
    head = (
        "path",
        "ε [°]",
        "self-collisions",
        "valid",
        "fewest at a position",
        "bound",
        "minimum manipulability",
        "smallest ε [°]",
    )
    return Table.of("collisions", (*head, "sampling"), rows)


def second_table(runs: Runs, courses: tuple[Course, ...]) -> Table:
    """The second robot: optimum by ε, and refined."""
    rows = []
    for course in courses:
        sampled = runs.sampled(course, (config.SECOND_SAMPLES,))
        smallest = runs.smallest(sampled)
        for epsilon in (each for each in config.SECOND_EPSILONS if each > smallest):
            run = runs.searched(sampled, epsilon)
            refined = runs.refined(run).refinement
            rows.append(
                (
                    course.name.removeprefix("second "),
                    epsilon,
                    str(sampled.layers.count),
                    f"{smallest:.2f}",
                    f"{run.found.minimum:.6f}",
                    f"{refined.refined:.6f}",
                    f"{refined.bound:.6f}",
                    f"{run.found.length:.2f}",
                    f"{refined.length:.2f}",
                    seconds(run.seconds),
                )
            )
    head = (
        "path",
        "ε [°]",
        "valid",
        "smallest ε [°]",
        "minimum manipulability",
        "refined",
        "bound",
        "length [rad]",
        "refined [rad]",
    )
    return Table.of("second", (*head, "time of search"), rows)


def positions_table(runs: Runs, course: Course, grids: tuple[Grid, ...]) -> Table:
    """The smallest ε that connects the line, by number of positions."""
    rows = []
    for grid in grids:
        for times in (1, 2, 4) if grid == config.COARSE else (1, 2):
            positions = times * (course.positions - 1) + 1
            sampled = runs.sampled(course, grid, positions=positions if times > 1 else None)
            step = f"{1e3 * course.path.length / (positions - 1):.1f}"
            count, smallest = str(sampled.layers.count), f"{runs.smallest(sampled):.2f}"
            rows.append((grid_name(grid), positions, step, count, smallest))
            if times > 1:
                runs.forget(sampled)
    return Table.of("positions", ("grid", "positions", "step of the wrist [mm]", "valid", "smallest ε [°]"), rows)
