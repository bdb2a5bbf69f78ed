"""The paper's claims as numbers, and whether each holds here."""

import csv
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

import manipplan as mp
from studies.dufour2020 import config
from studies.dufour2020.follow import Arm, Run
from studies.dufour2020.numerics import indefinite
from studies.dufour2020.scenarios import Comparison, Obstacle, Scenario
from studies.expected import differences as within
from studies.tables import Table


@dataclass(frozen=True, kw_only=True)
class Claim:
    """One figure: what the paper says, what is measured, and whether it holds (None: ours, no claim)."""

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
) -> list[Claim]:
    """All that do not depend on the machine's speed."""
    literal = arm.follow(
        "S1",
        "(20)",
        config.ALPHA,
        formulation=mp.Objective(1.0, hessian="bfgs-literal", convexify=False),
        compiled=False,
    )
    maxima = arm.maxima
    found = [
        Claim(text="largest index of the arm [m³]", paper="not stated", value=float(maxima[0])),
        Claim(
            text="starts of the search that find it [%]",
            paper="not stated",
            value=100 * float((maxima > maxima[0] * (1 - 1e-6)).mean()),
        ),
    ]
    for name, scenario in (("S1", first), ("S2", second)):
        classical, relaxed = scenario.classical or scenario.plain, scenario.at_alpha
        found += [
            Claim(text=f"{name}: mean index, (2)", paper="Fig. 3, 4", value=scenario.plain.mean),
            Claim(text=f"{name}: mean index, best (7)", paper="little better than (2)", value=classical.mean),
            Claim(
                text=f"{name}: mean index, (10) with α = 15000",
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
        Claim(text="S2: least index, best (7)", paper="close to a singularity", value=classical.least),
        Claim(
            text="S2: least index, (10) with α = 15000",
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
            text="S3: gain in mean index by α",
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
        Claim(
            text="S1: steps that (20) as printed leaves unsolved, α = 15000 [%]",
            paper="(20) is what the paper uses",
            value=100 * literal.unsolved / literal.steps,
        ),
        Claim(
            text="T1 to T5: rms acceleration of (14) by that of (2)",
            paper="smoother than the path given",
            value=float(np.median(ratio)),
            holds=bool(np.median(ratio) < 1),
        ),
        Claim(
            text="mean over all paths of LogDrive's mean index less that of (14)",
            paper="ours",
            value=float(np.mean([a.mean - b.mean for a, b in zip(log, equal, strict=True) if a and b])),
        ),
        Claim(
            text="mean over all paths of LogDrive's least index less that of (14)",
            paper="ours",
            value=float(np.mean([a.least - b.least for a, b in zip(log, equal, strict=True) if a and b])),
        ),
    ]
    return found


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
    papers = 100 * comparison.losses(comparison.papers, comparison.one)
    ours = 100 * comparison.losses(comparison.most, comparison.own)
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
        Claim(
            text="(14) at 5e5 below (10) at the paper's α, most of T1 to T5 [%]",
            paper="3 to 5",
            value=float(papers.max()),
            holds=bool(papers.max() <= 5),
        ),
        Claim(
            text="(14) at 5e5 below (10) at the paper's α, mean of T1 to T5 [%]",
            paper="3 to 5",
            value=float(papers.mean()),
            holds=bool(papers.mean() <= 5),
        ),
        Claim(text="one α of (14) that is best for T1 to T5", paper="5e5", value=comparison.own_alpha),
        Claim(
            text="(14) at its best one α below (10) at its best α of each path, most [%]",
            paper="3 to 5",
            value=float(ours.max()),
            holds=bool(ours.max() <= 5),
        ),
        Claim(
            text="(14) at its best one α below (10) at its best α of each path, median [%]",
            paper="3 to 5",
            value=float(np.median(ours)),
            holds=bool(np.median(ours) <= 5),
        ),
    ]


def table(found: list[Claim]) -> Table:
    """Paper against ours."""
    words = {True: "yes", False: "no", None: ""}
    rows = [(claim.text, claim.paper, claim.value, words[claim.holds]) for claim in found]
    return Table.of("claims", ("claim", "paper", "ours", "holds"), rows)


def expected() -> list[tuple[str, float, float]]:
    """Claim, ours and tolerance of expected.csv."""
    with config.EXPECTED.open(newline="") as file:
        return [(row["claim"], float(row["ours"]), float(row["tolerance"])) for row in csv.DictReader(file)]


def differences(found: list[Claim]) -> list[str]:
    """What is not as expected.csv has it."""
    return within({claim.text: claim.value for claim in found}, expected())
