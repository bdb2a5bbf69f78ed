"""The paper's claims as numbers, and whether each holds here."""

import csv
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from studies.dufour2020 import config
from studies.dufour2020.courses import Array
from studies.dufour2020.follow import Arm, Run
from studies.dufour2020.numerics import indefinite
from studies.dufour2020.scenarios import Comparison, Obstacle, Scenario
from studies.expected import differences as within
from studies.tables import Table


@dataclass(frozen=True, kw_only=True)
class Claim:
    """One number: what the paper says, the measured value, and whether the claim holds (None: our own number, no claim)."""

    text: str
    paper: str
    value: float
    holds: bool | None = None


def claims(
    arm: Arm,
    first: Scenario,
    second: Scenario,
    sphere: Obstacle,
    comparison: Comparison,
    everything: Mapping[str, Mapping[str, Run | None]],
    printed: Mapping[tuple[str, float], Run],
) -> list[Claim]:
    """All claims that neither depend on the machine's speed nor are chaotic; `printed` are the runs of (20) as printed."""
    maxima = arm.maxima
    found = [
        Claim(text="largest manipulability of the arm [m³]", paper="not stated", value=float(maxima[0])),
        Claim(
            text="starts of the search that find it [%]",
            paper="not stated",
            value=100 * float((maxima > maxima[0] * (1 - 1e-6)).mean()),
        ),
    ]
    for name, scenario in (("S1", first), ("S2", second)):
        classical, relaxed = scenario.classical or scenario.plain, scenario.at_alpha
        found += [
            Claim(text=f"{name}: mean manipulability, (2)", paper="Fig. 3, 4", value=scenario.plain.mean),
            Claim(text=f"{name}: mean manipulability, best (7)", paper="little better than (2)", value=classical.mean),
            Claim(
                text=f"{name}: mean manipulability, (10) with α = 15000",
                paper="better than (7)",
                value=relaxed.mean,
                holds=relaxed.mean > classical.mean,
            ),
            Claim(
                text=f"{name}: deviation of (10) [mm]",
                paper="small" if name == "S1" else "limited",
                value=1e3 * relaxed.worst,
            ),
            Claim(
                text=f"{name}: deviation of (10) at the end [mm]",
                paper="the goal is reached",
                value=1e3 * float(relaxed.deviation[-1]),
                holds=relaxed.reached,
            ),
        ]
    classical = second.classical or second.plain
    spread = [1e3 * run.worst for run in second.relaxed]
    found += [
        Claim(text="S2: minimum manipulability, best (7)", paper="close to a singularity", value=classical.least),
        Claim(
            text="S2: minimum manipulability, (10) with α = 15000",
            paper="escapes from the singularity",
            value=second.at_alpha.least,
            holds=second.at_alpha.least > 10 * classical.least,
        ),
        Claim(
            text="S2: deviation at α = 50000 by that at 5000",
            paper="grows with α",
            value=spread[-1] / spread[0],
            holds=bool(np.all(np.diff(spread) > 0)),
        ),
    ]
    for run, free in zip(sphere.runs, sphere.unguarded, strict=True):
        least = float(run.rollout["clearance"].min())
        found += [
            Claim(text=f"S3: distance without avoidance, α = {run.strength:g} [mm]", paper="below d_s", value=1e3 * free),
            Claim(
                text=f"S3: distance with avoidance, α = {run.strength:g} [mm]",
                paper="d_s is kept, the goal is reached",
                value=1e3 * least,
                holds=least >= config.SECURITY - 1e-4 and run.reached,
            ),
        ]
    found.append(
        Claim(
            text="S3: gain in mean manipulability by α",
            paper="above 0",
            value=sphere.runs[1].mean - sphere.runs[0].mean,
            holds=sphere.runs[1].mean > sphere.runs[0].mean,
        )
    )
    found += _fourth(arm, comparison)
    rough = [(runs["(14)"], runs["(2)"]) for name, runs in everything.items() if name in config.TABLE_1]
    ratio = [fast.roughness / plain.roughness for fast, plain in rough if fast and plain]
    log = [runs["LogDrive"] for runs in everything.values()]
    equal = [runs["(14)"] for runs in everything.values()]
    found += [
        *(
            Claim(
                text=f"{name}: steps that (20) as printed leaves unsolved, α = 15000 [%]",
                paper="(20) spares the exact Hessian",
                value=100 * printed[name, config.ALPHA].unsolved / printed[name, config.ALPHA].steps,
            )
            for name in ("S1", "T5")
        ),
        Claim(
            text="T1 to T5: rms acceleration of (14) by that of (2)",
            paper="smoother than the path given",
            value=float(np.median(ratio)),
            holds=bool(np.median(ratio) < 1),
        ),
        *(
            Claim(
                text=f"{name}: rms torque of (14) by that of (2)", paper="not stated", value=arm.torque(one) / arm.torque(plain)
            )
            for name, runs in everything.items()
            if name in ("S1", "S2") and (one := runs["(14)"]) and (plain := runs["(2)"])
        ),
        Claim(
            text="mean over all paths of LogDrive's mean manipulability less that of (14)",
            paper="ours",
            value=float(np.mean([a.mean - b.mean for a, b in zip(log, equal, strict=True) if a and b])),
        ),
        Claim(
            text="mean over all paths of LogDrive's minimum manipulability less that of (14)",
            paper="ours",
            value=float(np.mean([a.least - b.least for a, b in zip(log, equal, strict=True) if a and b])),
        ),
    ]
    return found


def best_alphas(comparison: Comparison) -> list[Claim]:
    """Whether one α serves all paths, and what a larger one than the paper's gains."""
    ratio = {
        formula: max(run.strength for run in found.values()) / min(run.strength for run in found.values())
        for formula, found in (("(10)", comparison.most), ("(14)", comparison.most_equal))
    }
    losses = [100 * (1 - comparison.one[name].mean / comparison.most_equal[name].mean) for name in config.TABLE_1]
    gains = [100 * (comparison.most[name].mean / comparison.papers[name].mean - 1) for name in config.TABLE_1]
    small = sum(each < config.NOT_MUCH for each in gains)
    return [
        Claim(
            text="largest best α of (14) by the smallest, T1 to T5",
            paper="one α for all paths",
            value=ratio["(14)"],
            holds=ratio["(14)"] < ratio["(10)"] / 10,
        ),
        Claim(text="(14) at 5e5 below (14) at the best α of each path, median [%]", paper="-", value=float(np.median(losses))),
        Claim(text="(14) at 5e5 below (14) at the best α of each path, most [%]", paper="-", value=max(losses)),
        Claim(
            text=f"paths, of 5, on which a larger α than the paper's raises (10) by less than {config.NOT_MUCH:g} %",
            paper="no more improvement",
            value=small,
            holds=small == len(gains),
        ),
        Claim(text="most that a larger α than the paper's raises (10) [%]", paper="no more improvement", value=max(gains)),
    ]


def stopped(runs: list[Run]) -> list[Claim]:
    """The goal in collision, section 3.2."""
    off = max(abs(float(run.rollout["clearance"][-1]) - config.SECURITY) for run in runs)
    least = min(float(run.rollout["clearance"].min()) for run in runs)
    return [
        Claim(
            text="goal in collision: distance at the end less d_s, most [mm]",
            paper="the robot stops as close as possible",
            value=1e3 * off,
            holds=off < 1e-4,
        ),
        Claim(
            text="goal in collision: least distance on all paths [mm]",
            paper="d_s is kept",
            value=1e3 * least,
            holds=least >= config.SECURITY - 1e-4,
        ),
    ]


def recorded(found: Mapping[tuple[str, float, str], tuple[float, float]]) -> list[Claim]:
    """Torque and smoothness of (14) against the recorded motion, as in the paper."""
    claims: list[Claim] = []
    for tremor in config.TREMORS:
        with_hand = f"tremor of {1e3 * tremor:g} mrad" if tremor else "no tremor"
        for name in (each.name for each in config.DEMONSTRATIONS):
            (rough, heavy), (smooth, light) = found[name, tremor, "recorded"], found[name, tremor, "(14)"]
            claims += [
                Claim(
                    text=f"{name}, {with_hand}: rms acceleration of (14) by that of the recorded motion",
                    paper="smoother than the recorded motion",
                    value=smooth / rough,
                    holds=smooth < rough,
                ),
                Claim(
                    text=f"{name}, {with_hand}: rms torque of (14) by that of the recorded motion",
                    paper="less than that of the recorded motion",
                    value=light / heavy,
                    holds=light < heavy,
                ),
            ]
    return claims


def chaotic(convexity: Table, hessians: Mapping[tuple[str, str, float], Run], chatter: Mapping[float, Array]) -> list[Claim]:
    """Claims that change with the last bit of a sum, and so with the type of processor: they have wide tolerances."""
    last = dict(zip(convexity.head, convexity.rows[-1], strict=True))
    return [
        Claim(
            text="changes from machine to machine: S2: mean manipulability with (20) made convex, α = 1e5",
            paper="-",
            value=hessians["S2", "bfgs-literal", config.LITERAL_ALPHAS[-1]].mean,
        ),
        Claim(
            text="changes from machine to machine: whole cost of (10) indefinite at α = 1e7 [%]",
            paper="-",
            value=float(last["whole cost of (10) indefinite [%]"]),
        ),
        Claim(
            text="changes from machine to machine: (14) chatter at α = 1e7 [%]",
            paper="-",
            value=float(last["(14) chatter [%]"]),
        ),
        *(
            Claim(
                text=f"changes from machine to machine: T3, (20) as printed, α = {alpha:g}: median chatter [%]",
                paper="oscillations",
                value=float(np.median(values)),
                holds=float(np.median(values)) > 100 * config.CHATTER,
            )
            for alpha, values in chatter.items()
        ),
    ]


def _fourth(arm: Arm, comparison: Comparison) -> list[Claim]:
    runs = [run for each in comparison.objective.values() for run in each]
    unsolved = {name: [run.strength for run in each if run.unsolved] for name, each in comparison.objective.items()}
    firsts = [min(alphas) for alphas in unsolved.values() if alphas]
    indefinites = [run.strength for run in runs if not run.unsolved and indefinite(arm, run) > 0]
    equal = [run for each in comparison.equality.values() for run in each]
    best = [run.strength for run in comparison.most.values()]
    chatter = {
        formula: min((run.strength for run in group if run.chatter > config.CHATTER and not run.unsolved), default=np.inf)
        for formula, group in (("(10)", runs), ("(14)", equal))
    }
    return [
        Claim(
            text="T1 to T5: least α at which Q - αT²H is indefinite at some step",
            paper="there is one",
            value=min(indefinites),
            holds=bool(indefinites),
        ),
        Claim(
            text="T1 to T5: least α at which (10) as it is has steps without an answer",
            paper="there is one",
            value=min(firsts),
            holds=bool(firsts),
        ),
        Claim(text="paths on which (10) comes to that within the sweep, of 5", paper="-", value=len(firsts)),
        Claim(
            text="T1 to T5: steps of (14) without an answer, all α",
            paper="always feasible",
            value=sum(run.unsolved for run in equal),
            holds=not any(run.unsolved for run in equal),
        ),
        Claim(
            text="least α at which (14) chatters",
            paper="(10) oscillates, not (14)",
            value=chatter["(14)"],
            holds=chatter["(14)"] > chatter["(10)"],
        ),
        Claim(
            text="largest best α of (10) by the smallest, T1 to T5",
            paper="2.4, Table 1: it depends on the path",
            value=max(best) / min(best),
            holds=max(best) > min(best),
        ),
        *_losses("(14) at 5e5 below (10) at the α of the paper's own paths", comparison.papers, comparison.one),
        *_losses("(14) at 5e5 below (10) at the best α of each path", comparison.most, comparison.one),
        Claim(text="one α of (14) that is best for T1 to T5", paper="5e5", value=comparison.own_alpha),
        *_losses("(14) at its best one α below (10) at the best α of each path", comparison.most, comparison.own),
        *(
            Claim(text=f"deviation of {name} with it, most [mm]", paper="not stated", value=1e3 * max(r.worst for r in group))
            for name, group in (("(10)", comparison.most.values()), ("(14)", comparison.own.values()))
        ),
    ]


def _losses(text: str, reference: Mapping[str, Run], other: Mapping[str, Run]) -> list[Claim]:
    """How much lower the mean manipulability of `other` is on T1 to T5, compared with the paper's 3 to 5 %."""
    losses = np.array([100 * (1 - other[name].mean / reference[name].mean) for name in config.TABLE_1])
    low, high = config.PAPERS_LOSS
    inside = int(np.count_nonzero((losses >= low) & (losses <= high)))
    return [
        *(
            Claim(text=f"{text}, {what} [%]", paper="3 to 5", value=float(value), holds=bool(low <= value <= high))
            for what, value in (("least", losses.min()), ("mean", losses.mean()), ("most", losses.max()))
        ),
        Claim(text=f"{text}: paths on which by 3 to 5 %", paper="5 of 5", value=inside, holds=inside == len(losses)),
    ]


def table(found: list[Claim]) -> Table:
    """Table of the paper's statements and our values."""
    words = {True: "yes", False: "no", None: ""}
    rows = [(claim.text, claim.paper, claim.value, words[claim.holds]) for claim in found]
    return Table.of("claims", ("claim", "paper", "ours", "holds"), rows)


def expected() -> list[tuple[str, float, float]]:
    """Claim, our value and tolerance from expected.csv."""
    with config.EXPECTED.open(newline="") as file:
        return [(row["claim"], float(row["ours"]), float(row["tolerance"])) for row in csv.DictReader(file)]


def differences(found: list[Claim]) -> list[str]:
    """Differences from expected.csv."""
    return within({claim.text: claim.value for claim in found}, expected())
