"""Claim 1, the methods for the Hessian, computation times, and the effect of the time step."""

from collections.abc import Callable
from itertools import product

import numpy as np

import manipplan as mp
from studies.dufour2020 import config
from studies.dufour2020.follow import Arm, Run
from studies.dufour2020.quasi_newton import HESSIANS, QuasiNewton
from studies.dufour2020.scenarios import RUN_HEAD, Comparison, best, run_row, sweep
from studies.tables import Cell, Table

HESSIAN_ALPHAS = (config.ALPHA, 100e3)
#: Heading of the column next to a value: the same value for a start that is moved by a tiny amount.
NUDGED = "the same, start moved by 10⁻¹⁰ rad"


def indefinite(arm: Arm, run: Run) -> float:
    """Share of the steps on the path at which Q - α T² H_m is indefinite."""
    curve = config.DT**2 * run.strength * arm.kinematics.hessian(run.q[: run.steps])
    return float((np.linalg.eigvalsh(np.eye(arm.robot.n) - curve)[:, 0] <= 0).mean())


def convexity(arm: Arm, comparison: Comparison) -> Table:
    """Claim 1, over T1 to T5 and every α of the sweep."""
    convexified = {name: sweep(arm, name, "(10)", config.SWEEP) for name in config.TABLE_1}
    near = {
        formula: [sweep(arm, name, formula, config.SWEEP, nudge=config.NUDGE) for name in config.TABLE_1]
        for formula in ("(10)", "(14)")
    }
    rows = []
    for k, alpha in enumerate(config.SWEEP):
        raw = [runs[k] for runs in comparison.objective.values()]
        made = [runs[k] for runs in convexified.values()]
        equal = [runs[k] for runs in comparison.equality.values()]
        nudged = {formula: [runs[k] for runs in every] for formula, every in near.items()}
        steps = sum(run.steps for run in raw)
        rows.append(
            (
                alpha,
                100 * float(np.mean([indefinite(arm, run) for run in made])),
                100 * sum(run.convexified for run in made) / steps,
                100 * sum(run.convexified for run in nudged["(10)"]) / steps,
                100 * sum(run.unsolved for run in raw) / steps,
                100 * sum(run.unsolved for run in equal) / steps,
                100 * float(np.mean([run.chatter for run in made])),
                100 * float(np.mean([run.chatter for run in equal])),
                100 * float(np.mean([run.chatter for run in nudged["(14)"]])),
            )
        )
    whole = "whole cost of (10) indefinite [%]"
    head = ("α", "Q - αT²H indefinite [%]", whole, NUDGED, "(10) as it is: not solved [%]", "(14): not solved [%]")
    return Table.of("claim1", (*head, "(10) chatter [%]", "(14) chatter [%]", NUDGED), rows)


def hessians(arm: Arm) -> tuple[Table, dict[tuple[str, str, float], Run]]:
    """(10) with every method for the Hessian."""
    runs, rows = {}, []
    for name, hessian, alpha in product(("S1", "S2"), HESSIANS, HESSIAN_ALPHAS):
        run, near = (
            arm.follow(name, hessian, alpha, formulation=HESSIANS[hessian], compiled=False, nudge=nudge)
            for nudge in (0.0, config.NUDGE)
        )
        runs[name, hessian, alpha] = run
        figures = (run.mean, near.mean, run.least, 1e3 * run.worst, run.convexified, 100 * run.chatter, run.reached)
        rows.append((name, hessian, alpha, *figures))
    head = (
        "path",
        "Hessian",
        "α",
        "mean manipulability",
        NUDGED,
        "minimum manipulability",
        "deviation [mm]",
        "steps made convex",
        "chatter [%]",
    )
    return Table.of("hessians", (*head, "goal reached"), rows), runs


def literal(arm: Arm) -> tuple[Table, dict[tuple[str, float], Run]]:
    """(20) as printed, solved as it is, on every path."""
    printed = QuasiNewton(1.0, "bfgs-literal", convexify=False)
    runs, rows = {}, []
    for name, alpha in product(arm.courses, config.LITERAL_ALPHAS):
        run, near = (
            arm.follow(name, "(20)", alpha, formulation=printed, compiled=False, nudge=nudge) for nudge in (0.0, config.NUDGE)
        )
        runs[name, alpha] = run
        exact, without = arm.follow(name, "(10)", alpha), arm.follow(name, "(7)", 0.0)
        unsolved = (100 * run.unsolved / run.steps, 100 * near.unsolved / near.steps)
        figures = (run.mean, without.mean, exact.mean, 1e3 * run.worst, 100 * run.chatter, run.reached)
        rows.append((name, alpha, *unsolved, *figures))
    head = (
        "path",
        "α",
        "steps without an answer [%]",
        NUDGED,
        "mean manipulability",
        "of (2)",
        "of (10), exact",
        "deviation [mm]",
    )
    return Table.of("literal", (*head, "chatter [%]", "goal reached"), rows), runs


def real_time(arm: Arm, avoidance: mp.Avoidance, advance: Callable[[], None]) -> tuple[Table, dict[str, float]]:
    """Step times on scenario 1 at 100 Hz and 1 kHz, and the share of steps that took longer than T."""
    strengths = {"(7)": 1.0, "(10)": config.ALPHA, "(14)": config.ONE_ALPHA, "LogDrive": config.LOG_WEIGHT}
    cases = [(formula, strength, None) for formula, strength in strengths.items()] + [("(10)", config.ALPHA, avoidance)]
    rows: list[tuple[Cell, ...]] = []
    late = {"100 Hz": 0.0, "1 kHz": 0.0}
    for dt, rate in ((config.DT, "100 Hz"), (config.FAST_DT, "1 kHz")):
        for compiled in (True, False):
            for formula, strength, kept in cases:
                times = arm.step_times("S1", formula, strength, dt=dt, avoidance=kept, compiled=compiled)
                name = f"{formula}, sphere" if kept else formula
                micro = 1e6 * times
                share = float((times > dt).mean())
                late[rate] = max(late[rate], share)
                made = "compiled" if compiled else "no compiler"
                rows.append((rate, made, name, *(float(np.percentile(micro, p)) for p in (50, 99, 100)), 100 * share))
                advance()
    head = ("rate", "step", "formulation", "median [µs]", "99 % [µs]", "longest [µs]", "longer than T [%]")
    return Table.of("real_time", head, rows), late


def time_step(arm: Arm) -> tuple[Table, dict[str, float]]:
    """Whether the motion is the same at 10 ms and at 1 ms: largest difference of a joint on scenarios 1 and 2 [rad]."""
    alike: dict[str, tuple[mp.formulations.Formulation, float]] = {
        "(10), T of the step": (mp.formulations.Objective(1.0), config.ALPHA),
        "(10), T = 10 ms": (mp.formulations.Objective(1.0, sample_time=config.DT), config.ALPHA),
        "(14), T of the step": (mp.formulations.Equality(1.0), config.ONE_ALPHA),
        "(14), T = 10 ms": (mp.formulations.Equality(1.0, sample_time=config.DT), config.ONE_ALPHA),
        "LogDrive": (mp.formulations.LogDrive(1.0, rate=config.LOG_RATE), config.LOG_WEIGHT),
    }
    rows: list[tuple[Cell, ...]] = []
    apart: dict[str, float] = {}
    ratio = round(config.DT / config.FAST_DT)
    for label, (formulation, strength) in alike.items():
        for name in ("S1", "S2"):
            slow, fast = (
                arm.follow(name, label, strength, formulation=formulation, dt=dt, approach=config.GENTLE, compiled=False)
                for dt in (config.DT, config.FAST_DT)
            )
            gap = float(np.abs(slow.q[: slow.steps + 1] - fast.q[: fast.steps + 1 : ratio]).max())
            apart[label] = max(apart.get(label, 0.0), gap)
            rows.append((name, label, slow.mean, fast.mean, 1e3 * slow.worst, 1e3 * fast.worst, gap))
    head = (
        "path",
        "formulation",
        "mean manipulability, 10 ms",
        "1 ms",
        "deviation [mm], 10 ms",
        "1 ms",
        "joints apart by [rad]",
    )
    return Table.of("time_step", head, rows), apart


def approaches(arm: Arm) -> Table:
    """Effect of the return to the path: dead-beat, as in the paper, against the library's default."""
    strengths = {"(10)": config.ALPHA, "(14)": config.ONE_ALPHA, "LogDrive": config.LOG_WEIGHT}
    rows = []
    for name in ("S1", "S2"):
        for formula, strength in strengths.items():
            for label, approach in (("inf (paper)", config.DEAD_BEAT), ("2 m/s²", config.GENTLE)):
                run = arm.follow(name, formula, strength, approach=approach, compiled=False)
                rows.append((name, formula, label, run.mean, run.least, 1e3 * run.worst, run.roughness))
    head = (
        "path",
        "formulation",
        "approach",
        "mean manipulability",
        "minimum manipulability",
        "deviation [mm]",
        "rms acceleration [rad/s²]",
    )
    return Table.of("approach", head, rows)


def all_courses(arm: Arm) -> tuple[Table, dict[str, dict[str, Run | None]]]:
    """Every path with every formulation: (7) at its best sound k₀, the others at one parameter for all paths."""
    found: dict[str, dict[str, Run | None]] = {}
    for name in arm.courses:
        gains = sweep(arm, name, "(7)", config.GAINS)
        found[name] = {
            "(2)": gains[0],
            "(7)": best(gains),
            "(10)": arm.follow(name, "(10)", config.ALPHA),
            "(14)": arm.follow(name, "(14)", config.ONE_ALPHA),
            "LogDrive": arm.follow(name, "LogDrive", config.LOG_WEIGHT),
        }
    rows: list[tuple[Cell, ...]] = []
    for name, runs in found.items():
        for formula, run in runs.items():
            if run is None:
                rows.append((name, formula, "none keeps the path", "-", "-", "-", "-", "-"))
            else:
                rows.append((name, formula, *run_row(run)[2:]))
    return Table.of("all_paths", RUN_HEAD, rows), found
