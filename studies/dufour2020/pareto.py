"""Manipulability against deviation: every formulation with a swept parameter, without a tube and inside three tubes."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from studies.dufour2020 import config
from studies.dufour2020.follow import Arm, Run
from studies.dufour2020.scenarios import best, sweep
from studies.tables import Cell, Table

SWEEPS = {"(7)": config.GAINS, "(10)": config.SWEEP, "(14)": config.SWEEP, "LogDrive": config.WEIGHTS}
#: None: no tube; (7) cannot use one.
SPACES: tuple[float | None, ...] = (None, *config.TUBES)

Fronts = dict[tuple[str, float | None, str], list[Run]]


@dataclass(frozen=True, kw_only=True, eq=False)
class Priced:
    """A run, and the root mean square of its joint torques [N m]."""

    run: Run
    torque: float


def fronts(arm: Arm, names: tuple[str, ...], advance: Callable[[], None]) -> Fronts:
    """Runs by path, tube [m] and formulation."""
    found: Fronts = {}
    for name in names:
        for tube in SPACES:
            for formula, strengths in SWEEPS.items():
                if tube is None or formula != "(7)":
                    found[name, tube, formula] = sweep(arm, name, formula, strengths, tube=tube)
        advance()
    return found


def front_table(found: Fronts) -> Table:
    """Table of all runs."""
    rows = [
        (
            name,
            "none" if tube is None else f"{1e3 * tube:g}",
            formula,
            run.strength,
            1e3 * run.worst,
            float(np.rad2deg(run.turned)),
            run.mean,
            run.least,
            100 * run.chatter,
            run.sound,
        )
        for (name, tube, formula), runs in found.items()
        for run in runs
    ]
    head = (
        "path",
        "tube [mm]",
        "formulation",
        "parameter",
        "deviation [mm]",
        "rotation [°]",
        "mean manipulability",
        "minimum manipulability",
    )
    return Table.of("pareto", (*head, "chatter [%]", "sound"), rows)


def tube_table(found: Fronts) -> Table:
    """Largest mean and minimum manipulability of the sound runs of each formulation inside each tube."""
    rows = []
    for (name, tube, formula), runs in found.items():
        counted = [run for run in runs if run.sound and (tube is None or run.worst <= config.TUBE_SLACK * tube)]
        if tube is not None and counted:
            top, safest = max(counted, key=lambda run: run.mean), max(counted, key=lambda run: run.least)
            rows.append((name, 1e3 * tube, formula, top.strength, top.mean, 1e3 * top.worst, safest.strength, safest.least))
    head = ("path", "tube [mm]", "formulation", "parameter", "largest mean manipulability", "deviation [mm]", "parameter")
    return Table.of("tubes", (*head, "largest minimum manipulability"), rows)


def prices(arm: Arm, found: Fronts) -> dict[tuple[str, str], list[Priced]]:
    """The sound runs without a tube with their torques, by path and formulation."""
    return {
        (name, formula): [Priced(run=run, torque=arm.torque(run)) for run in runs if run.sound]
        for (name, tube, formula), runs in found.items()
        if tube is None
    }


def front(priced: list[Priced], price: Callable[[Priced], float]) -> list[Priced]:
    """The runs with more mean manipulability than all cheaper ones, by ascending price."""
    chosen: list[Priced] = []
    for each in sorted(priced, key=price):
        if not chosen or each.run.mean > chosen[-1].run.mean:
            chosen.append(each)
    return chosen


def own_best(priced: list[Priced]) -> Priced | None:
    """The run with the largest mean manipulability, at the path's own parameter; None if no run is sound."""
    top = best([each.run for each in priced])
    return next((each for each in priced if each.run is top), None)


def own_table(arm: Arm, found: dict[tuple[str, str], list[Priced]], names: tuple[str, ...]) -> Table:
    """Each formulation with the best parameter of each path: what it gains, and its price in deviation and torque."""
    rows: list[tuple[Cell, ...]] = []
    for name in names:
        plain = arm.torque(arm.follow(name, "(7)", 0.0))
        for formula in SWEEPS:
            top = own_best(found[name, formula])
            if top is None:
                rows.append((name, formula, "none keeps the path", "-", "-", "-", "-", "-"))
                continue
            run = top.run
            figures = (run.strength, run.mean, run.least, 1e3 * run.worst, top.torque, 100 * (top.torque / plain - 1))
            rows.append((name, formula, *figures))
    head = ("path", "formulation", "best parameter", "mean manipulability", "minimum manipulability", "deviation [mm]")
    return Table.of("own_parameter", (*head, "rms torque [N m]", "torque over that of (2) [%]"), rows)
