"""Claim 1, the methods for the Hessian, computation times, and the effect of the time step."""

from collections.abc import Callable
from itertools import product

import numpy as np
from scipy.interpolate import CubicSpline

import manipplan as mp
from studies.dufour2020 import config
from studies.dufour2020.courses import Array
from studies.dufour2020.follow import FORMULAS, Arm, Run, rms_torque
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


def best_alphas(comparison: Comparison) -> Table:
    """Table 1 and the text below it: the best sound α of each path, and what is gained beyond the paper's α."""
    rows: list[tuple[Cell, ...]] = []
    for name in config.TABLE_1:
        first, papers = comparison.most[name], comparison.papers[name]
        second, one = comparison.most_equal[name], comparison.one[name]
        objective = (papers.strength, first.strength, first.strength / papers.strength, 100 * (first.mean / papers.mean - 1))
        rows.append((name, *objective, second.strength, 100 * (1 - one.mean / second.mean)))
    head = ("path", "(10): paper's α", "best α", "by the paper's", "gain [%]", "(14): best α", "5e5 is lower by [%]")
    return Table.of("best_alphas", head, rows)


def spreads(arm: Arm) -> tuple[Table, dict[float, Array]]:
    """(20) as printed on T3 from many starts that are moved by 10⁻¹⁰ rad: the least, median and largest share.

    Also returns the shares (starts,) of joints and steps that chatter [%], by α.
    """
    printed = QuasiNewton(1.0, "bfgs-literal", convexify=False)
    moves = config.NUDGE * np.random.default_rng(0).uniform(-1, 1, (config.MOVED_STARTS, arm.robot.n))
    rows, chatter = [], {}
    for alpha in config.LITERAL_ALPHAS:
        runs = [arm.follow("T3", "(20)", alpha, formulation=printed, nudge=move) for move in moves]
        chatter[alpha] = np.array([100 * run.chatter for run in runs])
        unsolved = np.array([100 * run.unsolved / run.steps for run in runs])
        cells = [each for values in (chatter[alpha], unsolved) for each in np.percentile(values, (0, 50, 100))]
        rows.append((alpha, len(runs), *(float(each) for each in cells)))
    parts = ("least", "median", "most")
    head = ("α", "starts", *(f"chatter, {each} [%]" for each in parts), *(f"not solved, {each} [%]" for each in parts))
    return Table.of("spread", head, rows), chatter


def recorded(arm: Arm) -> tuple[Table, dict[tuple[str, float, str], tuple[float, float]]]:
    """Section 5, last paragraphs: torque and smoothness against the recorded motion itself, with a hand's tremor added.

    Returns also rms acceleration [rad/s²] and rms torque [N m] by path, tremor [rad] and motion.
    """
    rows: list[tuple[Cell, ...]] = []
    found: dict[tuple[str, float, str], tuple[float, float]] = {}
    for demonstration in config.DEMONSTRATIONS:
        for tremor in config.TREMORS:
            q = shaken(arm, demonstration, tremor)
            steps = len(q) - 1
            qd = np.diff(q, axis=0) / config.DT
            qdd = np.diff(qd, axis=0) / config.DT
            measured = {"recorded": (rms(qdd), rms_torque(arm.robot, q[1:-1], qd[1:], qdd))}
            poses = arm.kinematics.pose(q[1:])
            stiffness = np.array([config.STIFFNESS(k / steps) for k in range(1, steps + 1)])
            for formula, strength in (("(2)", 0.0), ("(14)", config.ONE_ALPHA)):
                controller = arm.controller(FORMULAS["(7)" if formula == "(2)" else formula])
                drive = np.full(steps, strength)
                rollout = controller.rollout(q[0], poses, stiffness=stiffness, drive=drive)
                rates = np.diff(rollout.qd, axis=0) / config.DT
                measured[formula] = (rms(rates), rms_torque(arm.robot, rollout.q[:-1], rollout.qd[:-1], rates))
            for name, values in measured.items():
                found[demonstration.name, tremor, name] = values
            shown = [measured[name][k] for k in (0, 1) for name in ("recorded", "(2)", "(14)")]
            rows.append((demonstration.name, 1e3 * tremor, *shown, 100 * (shown[5] / shown[3] - 1)))
    motions = ("recorded", "(2)", "(14)")
    head = ("path", "tremor [mrad]", *(f"rms acceleration, {each} [rad/s²]" for each in motions))
    return Table.of(
        "recorded", (*head, *(f"rms torque, {each} [N m]" for each in motions), "(14) by recorded [%]"), rows
    ), found


def shaken(arm: Arm, demonstration: config.Demonstration, tremor: float) -> Array:
    """The recorded posture at every step (N, n) [rad], with this tremor in each joint, fading at both ends."""
    table = np.loadtxt(config.PATHS / f"{demonstration.name}.csv", delimiter=",", skiprows=1)
    t = np.arange(round(table[-1, 0] / config.DT) + 1) * config.DT
    phases = np.random.default_rng(demonstration.seed).uniform(0, 2 * np.pi, arm.robot.n)
    fade = np.minimum(1.0, np.minimum(t, t[-1] - t) / config.FADE)
    wave = np.sin(2 * np.pi * config.TREMOR_FREQUENCY * t[:, None] + phases)
    return np.asarray(CubicSpline(table[:, 0], table[:, 1:])(t) + tremor * fade[:, None] * wave)


def rms(values: Array) -> float:
    """The root mean square."""
    return float(np.sqrt((values**2).mean()))
