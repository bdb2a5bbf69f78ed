"""The numbers of the thesis compared with ours; those in expected.csv are asserted."""

import csv
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

import manipplan as mp
from manipplan.planar import dexterous_annuli
from studies.expected import differences as within
from studies.kth2012 import classes, config, tables_beyond, tables_global, tables_more, tables_paths, tables_postures
from studies.kth2012.config import EXAMPLES, FIRST, SECOND, THIRD
from studies.kth2012.results import Results
from studies.tables import Table

QUICK, FULL = "quick", "full"
#: A value counts as above a value printed with four decimals only if it is larger by more than this.
ROUNDING = 5e-5


@dataclass(frozen=True, kw_only=True)
class Claim:
    """One number: what the thesis says, the computed value, and whether both agree (None: our own number, no claim).

    `part` is "quick" for a number that --quick computes as well.
    """

    text: str
    thesis: str
    value: float
    holds: bool | None = None
    part: str = QUICK


def claims(results: Results) -> list[Claim]:
    """All claims."""
    found = [*_theorems(), *_postures(results), *_paths(results), *_third(results), *_statements(results), *_classes(results)]
    if not results.quick:
        found += [*_full(results), *_global(results)]
    return found


def _theorems() -> list[Claim]:
    return [
        Claim(text=statement, thesis="holds", value=float(holds), holds=holds)
        for statement, _, holds in tables_postures.theorems()
    ]


def _printed(text: str, thesis: float, value: float, digits: int) -> Claim:
    """A number printed with `digits` decimals; the claim holds if our value rounds to it."""
    return Claim(
        text=text, thesis=f"{thesis:.{digits}f}", value=value, holds=abs(value - thesis) <= 0.5 * 10**-digits * (1 + 1e-9)
    )


def _postures(results: Results) -> list[Claim]:
    best = results.free.best
    ours = (best.radius[0], *np.abs(best.q[0, 1:]), best.manipulability[0])
    names = ("R", "θ₂", "θ₃", "μ")
    found = [
        _printed(f"Table 5.1: {name}", thesis, float(value), 2)
        for name, thesis, value in zip(names, config.TABLE_5_1, ours, strict=True)
    ]
    found.append(Claim(text="stationary postures on the torus, all", thesis="-", value=float(len(results.free))))
    second, third = tables_postures.printed_optimum()
    found.append(
        Claim(text="(5.3) as printed: θ₂ of its maximum", thesis="0.78", value=second, holds=abs(second - 0.78) < 0.005)
    )
    found.append(Claim(text="(5.3) as printed: θ₃ of its maximum", thesis="1.13", value=third, holds=abs(third - 1.13) < 0.005))
    for radius, thesis in config.TABLE_5_2.items():
        row = tables_postures.row_5_2(results, radius)
        found += [
            _printed(f"Table 5.2, R = {radius:.1f}: {name}", printed, value, 2)
            for name, printed, value in zip(("θ₂", "θ₃", "μ", "κ"), thesis, row, strict=True)
        ]
    rows = [tables_postures.row_5_2(results, radius)[-1] for radius in config.TABLE_5_2]
    rises = sum(after >= before for before, after in pairwise(rows))
    found.append(Claim(text="Table 5.2: rows in which κ rises", thesis="0", value=float(rises), holds=rises == 0))
    for radius in config.SMALL_RADII:
        kappa = float(results.at_radius(radius, limited=False).best.inverse_condition[0])
        found.append(Claim(text=f"R = {radius:g}, no limits: κ of the best posture", thesis="κ decreases with R", value=kappa))
    return found


def _paths(results: Results) -> list[Claim]:
    found = []
    for example, table in ((FIRST, "6.1"), (SECOND, "6.2")):
        for degree, thesis in zip(config.DEGREES, example.thesis, strict=True):
            g = results.path(example, degree).g
            found.append(_printed(f"Table {table}, degree {degree}: g, p = 2", thesis, g, 4))
            text = f"Table {table}, degree {degree}: g, p = 1 as in (6.6)"
            found.append(Claim(text=text, thesis="-", value=results.path(example, degree, config.TEXT_POWER).g))
    above = max(
        results.path(example, degree).g - thesis
        for example in (FIRST, SECOND)
        for degree, thesis in zip(config.DEGREES, example.thesis, strict=True)
    )
    beside = max(
        abs(results.path(example, degree).g / results.multistart(example, degree) - 1)
        for example in EXAMPLES
        for degree in results.start_degrees
    )
    return [
        *found,
        Claim(
            text="Tables 6.1, 6.2: rows in which ours is above the print",
            thesis="-",
            value=float(above > ROUNDING),
            holds=above <= ROUNDING,
        ),
        Claim(
            text="optimal paths and random starts differ by more than a share of 1e-6",
            thesis="-",
            value=float(beside > 1e-6),
            holds=beside <= 1e-6,
        ),
    ]


def _third(results: Results) -> list[Claim]:
    ratios = tables_paths.ratios_6_4(results)
    names = ("g/g_L", "length_L/length", "∫μ_L/∫μ over t", "∫κ_L/∫κ over t")
    line, ours = (results.path(THIRD, degree) for degree in (1, config.BEST_DEGREE))
    printed = mp.path_cost(tables_paths.corrected_path(), results.kinematics, config.TABLE_POWER)
    found = [
        Claim(text="(6.13), line: g, p = 2", thesis="-", value=line.g),
        Claim(text="(6.13), degree 6: g, p = 2", thesis="-", value=ours.g),
        Claim(text="(6.13), degree 6: length", thesis="-", value=ours.length),
        Claim(text="Table 6.3, its goal put right: g, p = 2", thesis="-", value=printed.g),
        Claim(text="Table 6.3, its goal put right: length", thesis="-", value=printed.length),
    ]
    for k, (name, thesis) in enumerate(zip(names, config.TABLE_6_4, strict=True)):
        found.append(_printed(f"Table 6.4 from the thesis' coefficients: {name}", thesis, ratios["thesis"][k], 2))
        if k < 2:  # the others depend on the parametrisation
            found.append(_printed(f"Table 6.4, ours: {name}", thesis, ratios["ours"][k], 2))
    for k, name in enumerate(("μ", "κ")):
        text = f"Table 6.4, ours: mean {name} by arc length, line by optimum"
        found.append(Claim(text=text, thesis="-", value=ratios["ours by length"][k]))
    return found


def _classes(results: Results) -> list[Claim]:
    found = []
    for each in results.classes:
        text = f"{each.example.name}, class {classes.arrows(each.walk)}: g of its geodesic"
        short = len(each.walk) <= 3
        found.append(Claim(text=text, thesis="-", value=each.found.g, part=QUICK if short else FULL))
    strayed = sum(not each.stayed for each in (*results.classes, *results.torus))
    return [*found, Claim(text="geodesics outside their class", thesis="-", value=float(strayed), holds=strayed == 0)]


def _statements(results: Results) -> list[Claim]:
    (_, most, singular), (_, least, better) = tables_more.frobenius_extremes()
    [dexterous] = dexterous_annuli(config.ARM)
    found = [
        Claim(text="4.1.2: largest ‖J‖_F, at θ = 0", thesis="the global maximum", value=most, holds=abs(most**2 - 7) < 1e-9),
        Claim(text="4.1.2: μ there", thesis="0, singular", value=singular, holds=singular < 1e-6),
        Claim(text="4.1.2: smallest ‖J‖_F", thesis="no use either", value=least),
        Claim(text="4.1.2: μ there, of the smallest", thesis="no use either", value=better, holds=better < 1.0),
        Claim(text="Definition 2.6: outer radius of the dexterous workspace", thesis="-", value=dexterous.outer),
        Claim(text="Definition 2.6: its inner radius", thesis="-", value=dexterous.inner),
    ]
    for (name, degree), (plane, every) in tables_more.distances(results).items():
        alike = every < config.ALIKE
        text = f"{name}: path of degree {degree} from that of degree 6, all joints [rad]"
        thesis = "approximately the same" if degree >= 3 else "-"
        found.append(Claim(text=text, thesis=thesis, value=every, holds=alike if degree >= 3 else None))
        found.append(Claim(text=f"{text.split(',', maxsplit=1)[0]}, (θ₂, θ₃) [rad]", thesis="-", value=plane))
    plane, every = tables_more.printed_apart(results)
    share = tables_more.roundings(results)[2]
    return [
        *found,
        Claim(text="Table 6.3: its curve from ours, (θ₂, θ₃) [rad]", thesis="-", value=plane),
        Claim(text="Table 6.3: its curve from ours, all joints [rad]", thesis="-", value=every, holds=every < config.ALIKE),
        Claim(text="Table 6.4: share of the roundings of Table 6.3 that print 0.27", thesis="1", value=share, holds=share == 1),
    ]


def _global(results: Results) -> list[Claim]:
    found = []
    for case in tables_global.CASES:
        best, ours = results.global_optimum(*case[:2], shifted=case[2]), tables_global.best_path(results, *case)
        name = tables_global.case_name(*case)
        above = ours / best.path.g - 1
        found += [
            Claim(text=f"global optimum, {name}: V on the finest grid", thesis="-", value=best.values[-1], part=FULL),
            Claim(text=f"global optimum, {name}: g", thesis="-", value=best.path.g, part=FULL),
            Claim(
                text=f"global optimum, {name}: share by which degree 6 is above it",
                thesis="global optimality",
                value=above,
                holds=abs(above) < config.NEAR and best.proven and abs(best.values[-1] / best.path.g - 1) < 3 * config.NEAR,
                part=FULL,
            ),
        ]
    for example in EXAMPLES:
        for power in (config.TABLE_POWER, config.TEXT_POWER):
            turns = results.turns(example, power)
            text = f"{example.name}, p = {power:g}: goals a full turn away that are better"
            value = float(sum(each < 0.99 * turns[0, 0] for each in turns.values()))
            found.append(Claim(text=text, thesis="-", value=value, part=FULL))
    for example, posts in config.POSTS:
        values, best = results.among_optimum(example, posts)
        above, text = results.among(example, posts).g / best - 1, f"{example.name} among {len(posts)} of the posts"
        found += [
            Claim(
                text=f"{text}: above the global optimum, share",
                thesis="global optimality",
                value=above,
                holds=abs(above) < config.NEAR,
                part=FULL,
            ),
            Claim(
                text=f"{text}: V above it, share",
                thesis="-",
                value=values[-1] / best - 1,
                holds=abs(values[-1] / best - 1) < config.POST_ERROR,
                part=FULL,
            ),
        ]
    for power in (config.TABLE_POWER, config.TEXT_POWER):
        pairs = results.pairs(power)
        for count, g in zip((1, config.PAIR_PATHS), pairs.T[2:], strict=True):
            text = f"random pairs, p = {power:g}, first paths: {count}: "
            text += f"more than {tables_global.ABOVE:g} % above the global optimum"
            value = float((g > (1 + tables_global.ABOVE / 100) * pairs[:, 1]).sum())
            found.append(Claim(text=text, thesis="-", value=value, part=FULL))
    return found


def _full(results: Results) -> list[Claim]:
    found = []
    for example in EXAMPLES:
        turned = results.shifted(example).g
        best = results.best_crossing(example, shifted=True).found.g
        found += [
            Claim(text=f"{example.name}, goals by full turns: g, degree 6", thesis="-", value=turned, part=FULL),
            Claim(text=f"{example.name}, goals by full turns: g of the geodesic", thesis="-", value=best, part=FULL),
        ]
        for power in (config.TABLE_POWER, config.TEXT_POWER):
            case = f"{example.name}, p = {power:g}"
            limit, last = results.limit(example, power).g, tables_beyond.gap(results, example, power, config.MOST_DEGREE)
            found += [
                Claim(text=f"{case}: g of the geodesic", thesis="-", value=limit, part=FULL),
                Claim(text=f"{case}: g of degree {config.MOST_DEGREE} above it", thesis="-", value=last, part=FULL),
            ]
    curve, polynomial, exact = results.two_links()
    found += [
        Claim(text="two links, p = 1: hyperbolic distance", thesis="-", value=exact, part=FULL),
        Claim(text="two links, p = 1: g of the geodesic less it", thesis="-", value=curve - exact, part=FULL),
        Claim(text="two links, p = 1: g of degree 12 less it", thesis="-", value=polynomial - exact, part=FULL),
    ]
    for n in config.RATIO_LINKS:
        value = tables_postures.proportions(results, n).manipulability
        found.append(Claim(text=f"best proportions of {n} links: μ", thesis="-", value=value, part=FULL))
    for each in tables_beyond.links(results):
        found.append(Claim(text=f"{each.arm.n} unit links: largest μ", thesis="-", value=each.manipulability, part=FULL))
        found.append(Claim(text=f"{each.arm.n} unit links: g of degree 6", thesis="-", value=each.path.g, part=FULL))
    ways = [(results.among(*scene), results.path(scene[0], config.OBSTACLE_DEGREE)) for scene in config.POSTS]
    touching = sum(way.certificate.proven_clearance <= 0 for way, _ in ways)
    below = sum(way.g < free.g for way, free in ways)
    gained = sum(way.g < way.seed_cost.g for way, _ in ways)
    return [
        *found,
        Claim(
            text="paths among posts that are not proven free", thesis="-", value=float(touching), holds=touching == 0, part=FULL
        ),
        Claim(text="paths among posts better than without", thesis="-", value=float(below), holds=below == 0, part=FULL),
        Claim(
            text="paths among posts better than the planner's",
            thesis="-",
            value=float(gained),
            holds=gained == len(ways),
            part=FULL,
        ),
        *(
            Claim(
                text=f"{example.name} among {len(posts)} of the posts: g",
                thesis="-",
                value=way.g,
                part=FULL,
            )
            for (example, posts), (way, _) in zip(config.POSTS, ways, strict=True)
        ),
    ]


def table(found: list[Claim]) -> Table:
    """Table of the numbers of the thesis and ours."""
    words = {True: "yes", False: "no", None: ""}
    rows = [(claim.text, claim.thesis, _number(claim.value), words[claim.holds]) for claim in found]
    return Table.of("claims", ("figure", "thesis", "ours", "agrees"), rows)


def _number(value: float) -> str:
    return str(int(value)) if float(value).is_integer() else f"{value:.8g}"


def expected(*, quick: bool) -> list[tuple[str, float, float]]:
    """Claim, our value and tolerance from expected.csv."""
    with config.EXPECTED.open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["part"] == QUICK or not quick]
    return [(row["figure"], float(row["ours"]), float(row["tolerance"])) for row in rows]


def differences(found: list[Claim], *, quick: bool) -> list[str]:
    """Differences from expected.csv."""
    return within({claim.text: claim.value for claim in found}, expected(quick=quick))
