"""Manipulability against deviation: every formulation with a swept parameter, without a tube and inside three tubes."""

from collections.abc import Callable

import numpy as np

from studies.dufour2020 import config
from studies.dufour2020.follow import Arm, Run
from studies.dufour2020.scenarios import sweep
from studies.tables import Table

SWEEPS = {"(7)": config.GAINS, "(10)": config.SWEEP, "(14)": config.SWEEP, "LogDrive": config.WEIGHTS}
#: None: no tube; (7) cannot use one.
SPACES: tuple[float | None, ...] = (None, *config.TUBES)

Fronts = dict[tuple[str, float | None, str], list[Run]]


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
