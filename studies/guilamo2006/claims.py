"""The paper's claims as numbers, and whether each holds here."""

import csv
from dataclasses import dataclass

import numpy as np

from studies.expected import differences as within
from studies.guilamo2006 import config, runs, tables
from studies.guilamo2006.results import Results
from studies.guilamo2006.runs import Grid
from studies.tables import Table

QUICK, FULL = "quick", "full"


@dataclass(frozen=True, kw_only=True)
class Claim:
    """One number: what the paper says, the measured value, and whether the claim holds (None: our own number, no claim).

    `part` is "quick" for a number that --quick measures as well, "full" for one that needs the full grid.
    """

    text: str
    paper: str
    value: float
    holds: bool | None = None
    part: str = QUICK


def claims(results: Results) -> list[Claim]:
    """All claims that do not depend on the machine's speed."""
    found = [
        *_table_1(results, config.COARSE, QUICK),
        *_searches(results),
        *_resolution(results),
        *_refinement(results, config.COARSE, QUICK),
        *_rest(results),
    ]
    if not results.quick:
        found += [*_table_1(results, config.FULL, FULL), *_refinement(results, config.FULL, FULL), *_full(results)]
    return found


def _table_1(results: Results, grid: Grid, part: str) -> list[Claim]:
    circle, line = (results.sampled(course, grid) for course in results.courses)
    best = results.best(results.courses[0], grid)
    name = f"{tables.grid_name(grid)}, "
    sizes = circle.layers.sizes
    return [
        Claim(text=f"{name}circle: valid candidates", paper="59561", value=circle.layers.count, part=part),
        Claim(text=f"{name}circle: fewest at a position", paper="~800", value=int(sizes.min()), part=part),
        Claim(text=f"{name}circle: most at a position", paper="~2000", value=int(sizes.max()), part=part),
        Claim(text=f"{name}line: valid candidates", paper="33902", value=line.layers.count, part=part),
        Claim(
            text=f"{name}line: candidates at the last position by those at the first",
            paper="very few when extended",
            value=float(line.layers.sizes[-1] / line.layers.sizes[0]),
            holds=bool(line.layers.sizes[-1] < 0.1 * line.layers.sizes[0]),
            part=part,
        ),
        Claim(
            text=f"{name}circle: smallest ε that connects [°]",
            paper="2 is enough",
            value=results.runs.smallest(circle),
            holds=results.runs.smallest(circle) < config.DELTA,
            part=part,
        ),
        Claim(
            text=f"{name}line: smallest ε that connects [°]", paper="not stated", value=results.runs.smallest(line), part=part
        ),
        Claim(text=f"{name}circle: optimum", paper="Fig. 3", value=best.found.minimum, part=part),
        Claim(text=f"{name}circle: bound", paper="-", value=best.found.bound, part=part),
        Claim(
            text=f"{name}line: optimum", paper="Fig. 5", value=results.best(results.courses[1], grid).found.minimum, part=part
        ),
    ]


def _searches(results: Results) -> list[Claim]:
    circle = results.courses[0]
    best = results.best(circle, config.COARSE).found
    literal, memoised = (results.restarted(circle, config.COARSE, memoised=each) for each in (False, True))
    return [
        Claim(
            text="circle, coarse: optimum of the paper's search less the exact one",
            paper="the paper's is optimal",
            value=literal.found.minimum - best.minimum,
            holds=literal.found.minimum == best.minimum,
        ),
        Claim(
            text="circle, coarse: the same, memoised",
            paper="the paper's is optimal",
            value=memoised.found.minimum - best.minimum,
            holds=memoised.found.minimum == best.minimum,
        ),
        Claim(
            text="circle: ended runs of the paper's search, over ε and grids, with another optimum than the exact search",
            paper="the paper's is optimal",
            value=sum(run.found.minimum != _exact(results, run) for run in results.branching if run.ended),
            holds=all(run.found.minimum == _exact(results, run) for run in results.branching if run.ended),
        ),
        Claim(text="circle, coarse: new starts", paper="9407", value=literal.found.new_starts),
        Claim(text="circle, coarse: branches", paper="36596", value=literal.found.branches),
        Claim(text="circle, coarse: branches, memoised", paper="36596", value=memoised.found.branches),
        Claim(text="circle, coarse: branching factor", paper="~4", value=literal.factor),
        Claim(text="circle, coarse: branching factor, memoised", paper="~4", value=memoised.factor),
    ]


def _exact(results: Results, run: runs.Restarted) -> float:
    """The optimum of the exact search with the layers and ε of a run."""
    return results.runs.searched(run.sampled, run.epsilon, "first").found.minimum


def _resolution(results: Results) -> list[Claim]:
    ended = [run for run in results.branching if run.ended]
    narrow, wide = (
        next(run for run in ended if run.sampled.grid == config.COARSE and run.epsilon == each)
        for each in config.COMPARED_EPSILONS
    )
    coarse, fine = (
        next(run for run in ended if run.sampled.grid == grid and run.epsilon == config.COMPARED_EPSILONS[-1])
        for grid in (config.GRIDS[1], config.COARSE)
    )
    grids = f"{tables.grid_name(config.COARSE)} by {tables.grid_name(config.GRIDS[1])}"
    names = " by ".join(f"{each:g}°" for each in config.COMPARED_EPSILONS)
    return [
        Claim(
            text=f"circle, coarse, memoised: branching factor at ε = {names}",
            paper="below 1: falls with ε",
            value=narrow.factor / wide.factor,
            holds=narrow.factor < wide.factor,
        ),
        Claim(
            text=f"circle, coarse, memoised: comparisons at ε = {names}",
            paper="above 1: time can rise as ε falls",
            value=narrow.found.comparisons / wide.found.comparisons,
            holds=narrow.found.comparisons > wide.found.comparisons,
        ),
        Claim(
            text=f"circle, memoised: branching factor on {grids}",
            paper="above 1: rises with resolution",
            value=fine.factor / coarse.factor,
            holds=fine.factor > coarse.factor,
        ),
        Claim(
            text=f"circle, memoised: comparisons on {grids}",
            paper="below 1: time can fall with resolution",
            value=fine.found.comparisons / coarse.found.comparisons,
            holds=fine.found.comparisons < coarse.found.comparisons,
        ),
        Claim(
            text=f"circle, memoised: new starts on {grids}",
            paper="below 1: fewer with resolution",
            value=fine.found.new_starts / coarse.found.new_starts,
            holds=fine.found.new_starts < coarse.found.new_starts,
        ),
    ]


def _refinement(results: Results, grid: Grid, part: str) -> list[Claim]:
    found = []
    for course in results.courses:
        result = results.refined(course, grid).refinement
        name = f"{tables.grid_name(grid)}, {course.name}: "
        found += [
            Claim(
                text=f"{name}optimum below the bound of refinement [%]",
                paper="optimal for the samples",
                value=100 * (1 - result.discrete / result.bound),
                part=part,
            ),
            Claim(
                text=f"{name}refined path below it [%]",
                paper="ours",
                value=100 * (1 - result.refined / result.bound),
                part=part,
            ),
        ]
    line = results.courses[1]
    shortest = results.best(line, grid).found.manipulability
    papers = results.restarted(line, grid, memoised=True).found.manipulability
    smooth = results.refined(line, grid).refinement.manipulability
    return [
        *found,
        Claim(
            text=f"{tables.grid_name(grid)}, line: m off a smooth curve, at most, by the largest m, the paper's search",
            paper="~1/1000",
            value=runs.perturbation(papers),
            holds=runs.perturbation(papers) <= config.PERTURBATION,
            part=part,
        ),
        Claim(
            text=f"{tables.grid_name(grid)}, line: the same of the shortest optimal path",
            paper="ours",
            value=runs.perturbation(shortest),
            part=part,
        ),
        Claim(
            text=f"{tables.grid_name(grid)}, line: the same of the refined path",
            paper="ours",
            value=runs.perturbation(smooth),
            part=part,
        ),
    ]


def _rest(results: Results) -> list[Claim]:
    circle, line = results.courses
    sampled = results.sampled(line, config.COARSE)
    _, still = runs.still_torso(sampled)
    every, upright = runs.still_torso(results.sampled(circle, config.COARSE))
    first, shortest = (results.best(circle, config.COARSE, each) for each in ("first", "shortest"))
    opened, closed = results.cycles[-1]
    second_circle, second_line = (results.runs.sampled(each, (config.SECOND_SAMPLES,)) for each in results.second)
    best = results.runs.searched(second_circle, config.DELTA)
    return [
        Claim(
            text="line: positions of 20 that an upright torso reaches",
            paper="torso used at the edge",
            value=int(np.isfinite(still).sum()),
            holds=bool(np.isfinite(still).sum() < line.positions),
        ),
        Claim(
            text="circle: bound with an upright torso by that with all",
            paper="torso raises the manipulability",
            value=float(upright.min() / every.min()),
            holds=bool(upright.min() < every.min()),
        ),
        Claim(text="circle: shortest path shorter than the first [%]", paper="ours", value=tables.shorter(first, shortest)),
        Claim(
            text="circle as a cycle by the open one: optimum", paper="ours", value=closed.found.minimum / opened.found.minimum
        ),
        Claim(text="second robot, circle: smallest ε [°]", paper="-", value=results.runs.smallest(second_circle)),
        Claim(text="second robot, line: smallest ε [°]", paper="-", value=results.runs.smallest(second_line)),
        Claim(text="second robot, circle: optimum at 2°", paper="-", value=best.found.minimum),
        Claim(text="second robot, circle: bound less optimum", paper="-", value=best.found.gap),
    ]


def _full(results: Results) -> list[Claim]:
    circle = results.courses[0]
    free, kept = (results.runs.sampled(circle, config.COARSE, collisions=each) for each in (True, False))
    full, uneven = (results.sampled(circle, grid) for grid in (config.FULL, config.UNEVEN))
    thin = results.runs.thinned(full, config.THIN)
    restarted = results.restarted(circle, config.FULL, memoised=True)
    wide = results.wide.found
    name = tables.grid_name(config.FULL)
    ratios = {
        each: tables.needed(results.runs, circle, config.FULL, each) / tables.needed(results.runs, circle, config.COARSE, each)
        for each in config.COMPARED_EPSILONS
    }
    return [
        *(
            Claim(
                text=f"circle: starts needed at {each:g}°, {name} by {tables.grid_name(config.COARSE)}",
                paper="below 1: fewer with resolution",
                value=ratio,
                holds=ratio < 1,
                part=FULL,
            )
            for each, ratio in ratios.items()
        ),
        Claim(
            text=f"circle, {name}, 5°: the paper's search has ended",
            paper="1.5 min",
            value=float(results.wide.ended),
            holds=results.wide.ended,
            part=FULL,
        ),
        Claim(text=f"circle, {name}, 5°: new starts", paper="fewer with resolution", value=wide.new_starts, part=FULL),
        Claim(text=f"circle, {name}, 5°: branches", paper="-", value=wide.branches, part=FULL),
        Claim(text=f"circle, {name}, 5°: comparisons", paper="can fall with resolution", value=wide.comparisons, part=FULL),
        Claim(
            text=f"circle, {name}, 5°: optimum of the paper's search by the bound",
            paper="-",
            value=wide.minimum / full.layers.bound,
            part=FULL,
        ),
        Claim(
            text="circle, coarse: share that self-collision drops [%]",
            paper="not spoken of",
            value=100 * (1 - free.layers.count / kept.layers.count),
            part=FULL,
        ),
        *(
            Claim(
                text=f"circle, coarse: optimum at {each:g}° without self-collision by that with",
                paper="not spoken of",
                value=results.runs.searched(free, each, "first").found.minimum
                / results.runs.searched(kept, each, "first").found.minimum,
                part=FULL,
            )
            for each in config.COMPARED_EPSILONS
        ),
        Claim(text="considered per position", paper="306306", value=full.per_position, holds=True, part=FULL),
        Claim(
            text=f"{tables.grid_name(config.UNEVEN)}, circle: smallest ε [°]",
            paper="2 is enough",
            value=results.runs.smallest(uneven),
            holds=results.runs.smallest(uneven) < config.DELTA,
            part=FULL,
        ),
        Claim(
            text=f"circle: smallest ε of every {config.THIN}nd candidate [°]",
            paper="2 is enough for 59561",
            value=results.runs.smallest(thin),
            holds=results.runs.smallest(thin) < config.DELTA,
            part=FULL,
        ),
        Claim(
            text=f"circle, {tables.grid_name(config.FULL)}: starts that the paper's search needs",
            paper="9407",
            value=full.above(results.best(circle).found.minimum),
            part=FULL,
        ),
        Claim(
            text=f"circle, {tables.grid_name(config.FULL)}: the paper's search, memoised, has ended",
            paper="1.5 min",
            value=float(restarted.ended),
            holds=restarted.ended,
            part=FULL,
        ),
    ]


def table(found: list[Claim]) -> Table:
    """Table of the paper's statements and our values."""
    words = {True: "yes", False: "no", None: ""}
    rows = [(claim.text, claim.paper, _number(claim.value), words[claim.holds]) for claim in found]
    return Table.of("claims", ("claim", "paper", "ours", "holds"), rows)


def _number(value: float) -> str | float:
    return str(int(value)) if float(value).is_integer() else f"{value:.4g}"


def expected(*, quick: bool) -> list[tuple[str, float, float]]:
    """Claim, our value and tolerance from expected.csv."""
    with config.EXPECTED.open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["part"] == QUICK or not quick]
    return [(row["claim"], float(row["ours"]), float(row["tolerance"])) for row in rows]


def differences(found: list[Claim], *, quick: bool) -> list[str]:
    """Differences from expected.csv."""
    return within({claim.text: claim.value for claim in found}, expected(quick=quick))
