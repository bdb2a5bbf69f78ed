"""Scenarios 1 to 4 of section 5."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

import manipplan as mp
from studies.dufour2020 import config
from studies.dufour2020.follow import Arm, Run
from studies.tables import Cell, Table

RUN_HEAD = (
    "path",
    "formulation",
    "parameter",
    "mean manipulability",
    "minimum manipulability",
    "deviation [mm]",
    "rotation [°]",
    "rms acceleration",
)


def run_row(run: Run) -> tuple[Cell, ...]:
    """The row of a run in a table."""
    millimetres, degrees = 1e3 * run.worst, float(np.rad2deg(run.turned))
    return run.course.name, run.formula, run.strength, run.mean, run.least, millimetres, degrees, run.roughness


def sweep(
    arm: Arm, name: str, formula: str, strengths: Sequence[float], *, tube: float | None = None, nudge: float = 0.0
) -> list[Run]:
    """One run per strength."""
    return [arm.follow(name, formula, strength, tube=tube, nudge=nudge) for strength in strengths]


def best(runs: Sequence[Run]) -> Run | None:
    """The sound run with the largest mean manipulability; None if no run is sound."""
    return max((run for run in runs if run.sound), key=lambda run: run.mean, default=None)


@dataclass(frozen=True, kw_only=True, eq=False)
class Scenario:
    """Runs of a course: (2), without manipulability, the best of (7), and (10) for every α of the study."""

    plain: Run
    classical: Run | None
    relaxed: tuple[Run, ...]

    @classmethod
    def of(cls, arm: Arm, name: str) -> "Scenario":
        """Scenario 1 or 2."""
        gains = sweep(arm, name, "(7)", config.GAINS)
        relaxed = tuple(sweep(arm, name, "(10)", config.ALPHAS))
        return cls(plain=gains[0], classical=best(gains), relaxed=relaxed)

    @property
    def runs(self) -> tuple[Run, ...]:
        """All runs of the scenario."""
        return (self.plain, *([self.classical] if self.classical else []), *self.relaxed)

    @property
    def at_alpha(self) -> Run:
        """(10) with the α that Fig. 4 names."""
        return next(run for run in self.relaxed if run.strength == config.ALPHA)


@dataclass(frozen=True, kw_only=True, eq=False)
class Obstacle:
    """Scenario 3: runs with α = 0 and α > 0 that avoid the sphere, and the minimum distances [m] without avoidance."""

    runs: tuple[Run, ...]
    unguarded: tuple[float, ...]
    avoidance: mp.Avoidance

    @classmethod
    def of(cls, arm: Arm, sphere: mp.Sphere) -> "Obstacle":
        """Scenario 1 with a sphere."""
        avoidance = mp.Avoidance(
            scene=mp.Scene([sphere]),
            influence=config.INFLUENCE,
            security=config.SECURITY,
            damping=config.DAMPING,
            itself=False,
        )
        runs = tuple(arm.follow("S1", "(10)", alpha, avoidance=avoidance) for alpha in (0.0, config.ALPHA))
        # a point only measures the distance, since no link reaches its centre
        point = mp.Sphere(radius=1e-6, position=sphere.position)
        seen = mp.Avoidance(scene=mp.Scene([point]), influence=2e-9, security=1e-9, damping=config.DAMPING, itself=False)
        free = [arm.follow("S1", "(10)", run.strength, avoidance=seen, compiled=False) for run in runs]
        unguarded = tuple(float(run.rollout["clearance"].min()) + point.radius - sphere.radius for run in free)
        return cls(runs=runs, unguarded=unguarded, avoidance=avoidance)

    def rows(self) -> list[tuple[Cell, ...]]:
        """Position of the sphere, distances, manipulability and deviation."""
        place = ", ".join(f"{x:g}" for x in self.avoidance.scene.obstacles[0].position)
        return [
            (
                place,
                run.strength,
                1e3 * free,
                1e3 * float(run.rollout["clearance"].min()),
                run.mean,
                run.least,
                1e3 * run.worst,
                1e3 * float(run.deviation[-1]),
            )
            for run, free in zip(self.runs, self.unguarded, strict=True)
        ]


def obstacle_table(found: Sequence[Obstacle]) -> Table:
    """Table of scenario 3 with every sphere."""
    head = (
        "sphere at [m]",
        "α",
        "least distance without avoidance [mm]",
        "with [mm]",
        "mean manipulability",
        "minimum manipulability",
    )
    return Table.of("scenario3", (*head, "deviation [mm]", "at the end [mm]"), [row for each in found for row in each.rows()])


def goals_in_collision(arm: Arm) -> tuple[Table, list[Run]]:
    """Section 3.2: a sphere at the end of every path that begins outside it; the arm has to stop at d_s from it."""
    rows: list[tuple[Cell, ...]] = []
    runs = []
    for name, course in arm.courses.items():
        if name == "S1":  # the sphere would be in the upper arm from the start
            continue
        x, y, z = (round(float(each), 3) for each in course.path(1.0)[:3, 3])
        avoidance = mp.Avoidance(
            scene=mp.Scene([mp.Sphere(radius=config.SPHERE.radius, position=(x, y, z))]),
            influence=config.INFLUENCE,
            security=config.SECURITY,
            damping=config.DAMPING,
            itself=False,
        )
        run = arm.follow(name, "(10)", config.ALPHA, avoidance=avoidance)
        clearance = 1e3 * run.rollout["clearance"]
        ends = (float(clearance.min()), float(clearance[-1]), 1e3 * float(run.deviation[-1]), float(np.abs(run.qd[-1]).max()))
        rows.append((name, f"{x:g}, {y:g}, {z:g}", *ends, 100 * run.unsolved / run.steps))
        runs.append(run)
    head = ("path", "sphere at [m]", "least distance [mm]", "at the end [mm]", "tool to goal [mm]", "joint speed there [rad/s]")
    return Table.of("goal", (*head, "steps not solved [%]"), rows), runs


@dataclass(frozen=True, kw_only=True, eq=False)
class Comparison:
    """Scenario 4: sweeps of (10), without convexification, and of (14) over the five paths."""

    objective: dict[str, list[Run]]
    equality: dict[str, list[Run]]
    one: dict[str, Run]
    papers: dict[str, Run]

    @classmethod
    def of(cls, arm: Arm) -> "Comparison":
        """Run the sweeps."""
        return cls(
            objective={name: sweep(arm, name, "(10) as it is", config.SWEEP) for name in config.TABLE_1},
            equality={name: sweep(arm, name, "(14)", config.SWEEP) for name in config.TABLE_1},
            one={name: arm.follow(name, "(14)", config.ONE_ALPHA) for name in config.TABLE_1},
            papers={name: arm.follow(name, "(10) as it is", config.PAPERS_ALPHAS[name]) for name in config.TABLE_1},
        )

    @property
    def own_alpha(self) -> float:
        """Of all α at which (14) is sound on all paths, the one with the largest mean manipulability over the paths."""
        columns = list(zip(*self.equality.values(), strict=True))
        sound = [column for column in columns if all(run.sound for run in column)]
        return float(max(sound, key=lambda column: np.mean([run.mean for run in column]))[0].strength)

    @property
    def own(self) -> dict[str, Run]:
        """(14) with this α."""
        return {name: next(run for run in runs if run.strength == self.own_alpha) for name, runs in self.equality.items()}

    @property
    def most(self) -> dict[str, Run]:
        """(10) with the best α of each path."""
        found = {name: best(runs) for name, runs in self.objective.items()}
        return {name: run for name, run in found.items() if run is not None}

    @property
    def most_equal(self) -> dict[str, Run]:
        """(14) with the best α of each path."""
        found = {name: best(runs) for name, runs in self.equality.items()}
        return {name: run for name, run in found.items() if run is not None}

    def table(self) -> Table:
        """Table 1: at the paper's values, and at the best values of our sweeps."""
        rows = []
        for name in config.TABLE_1:
            papers, one, most, own = self.papers[name], self.one[name], self.most[name], self.own[name]
            first = (
                papers.strength,
                papers.mean,
                1e3 * papers.worst,
                one.mean,
                1e3 * one.worst,
                100 * (1 - one.mean / papers.mean),
            )
            second = (most.strength, most.mean, 1e3 * most.worst, own.mean, 1e3 * own.worst, 100 * (1 - own.mean / most.mean))
            rows.append((name, *first, *second))
        part = ("mean manipulability", "deviation [mm]", "(14): mean manipulability", "deviation [mm]", "lower by [%]")
        return Table.of("table1", ("path", "paper's α of (10)", *part, "best α of (10)", *part), rows)
