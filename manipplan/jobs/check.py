"""Report: every figure of a finished trajectory, measured on the trajectory itself."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import path_clearance
from manipplan.cost.crossings import describe, find_crossings, least_crossings, with_shares
from manipplan.cost.integral import PathCost, PathIntegral
from manipplan.optimize.result import PathResult
from manipplan.paths.joint import SHORTEST, JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.seeds.acceptance import CHECK_STEP
from manipplan.support.checks import Array, existing_file
from manipplan.support.display import one_line
from manipplan.support.errors import FileFormatError
from manipplan.support.files import write_text
from manipplan.support.json_data import from_json, json_ready
from manipplan.support.status import RECORDED, Status
from manipplan.timing.verify import LimitUse, jerk_use, limit_use, torque_use

T = TypeVar("T")

#: Excess of a limit [rad, m], or share of it, up to which the limit counts as kept.
TOLERANCE = 1e-6
#: Distance in s from an end of the path within which the minimum manipulability counts as that of the end.
AT_END = 0.01
#: Manipulability below this is rounding noise.
VANISHING = 1e-12
#: Number of equal intervals of time, at whose ends the report measures distances.
PLACES = 400
#: Number of intervals at whose ends m is compared with the floor, and of places inside those where it may pass it.
FINE_PLACES, PARTS = 5_000, 200


@one_line
@dataclass(frozen=True, kw_only=True)
class Report:
    """Figures of a finished trajectory. Lengths are in radians or metres of joint space, times in seconds.

    Attributes:
        robot, tool, task, measure, measure_unit: what was planned for, and the unit of the measure.
        power, floor: exponent and floor of g.
        status: text of the Status.
        duration: of the trajectory [s].
        g, seed_g: g of the objective along the trajectory and along the seed.
        length, seed_length: in joint space.
        min_manipulability, min_at: minimum manipulability along the trajectory, and the share of the duration at which it
            occurs.
        seed_min_manipulability, straight_min_manipulability: minimum manipulability on the seed, and on the straight line.
        crossing_note: which singularities the trajectory meets, and whether that can be avoided; "" for none.
        below_floor: time for which m is below the floor of g [s], to 1e-6 of the duration.
        minimum_note: how the minimum manipulability compares with those two, and the reason if it is not twice both.
        clearance, nearest_pair: minimum distance [m] measured at evenly spaced times, and its pair; inf and () if nothing
            is checked.
        proven_clearance: lower bound on the distances of all checked pairs on the whole trajectory, at all times [m].
        collision_free: whether the required clearance is proven on the whole trajectory or, where the proof does not decide,
            kept at samples between which no joint moves more than 1e-3 rad or m.
        limits: highest use of the limits of position, velocity, acceleration and, where they limit the motion, jerk and
            torque.
        position_unit: "rad" or "m", of the joint that comes closest to a position limit.
        straight_free: whether the straight line from start to goal is collision-free.
        goal_error: largest distance of the last sample from the goal [rad or m].
        passed: whether all limits are kept, no collision occurs and the goal is reached.
    """

    robot: str
    tool: str
    task: str
    measure: str
    measure_unit: str
    power: float
    status: str
    duration: float
    g: float
    seed_g: float
    length: float
    seed_length: float
    min_manipulability: float
    min_at: float
    seed_min_manipulability: float
    straight_min_manipulability: float
    minimum_note: str
    clearance: float
    nearest_pair: tuple[str, ...]
    proven_clearance: float
    collision_free: bool
    limits: Mapping[str, LimitUse]
    position_unit: str
    straight_free: bool
    goal_error: float
    passed: bool
    floor: float = 0.0
    crossing_note: str = ""
    below_floor: float = 0.0

    @classmethod
    def of(
        cls,
        trajectory: Trajectory,
        result: PathResult,
        model: CollisionModel,
        goal: Array,
        *,
        clearance: float,
        torque: bool,
        jerk: bool,
    ) -> "Report":
        """Measure a finished trajectory; only the figures of the seed are taken from the optimiser.

        `torque` and `jerk` say whether these limits are checked; infinite jerk limits are not.
        """
        robot = model.robot
        kinematics = robot.kinematics(result.task, measure=result.measure)
        integral = PathIntegral(kinematics=kinematics, power=result.power, floor=result.floor, metric=result.metric)
        path = trajectory.path()
        cost = integral.cost(path)
        crossings = with_shares(find_crossings(path, integral, cost), path, integral, cost)
        line = JointPath.line(path.start, path.goal) if np.linalg.norm(path.goal - path.start) >= SHORTEST else None
        straight = integral.cost(line) if line is not None else _standing(path, integral)
        use = dict(limit_use(trajectory, robot.limits))
        if jerk and np.isfinite(robot.limits.jerk).any():
            use["jerk"] = jerk_use(trajectory, robot.limits)
        if torque:
            use["torque"] = torque_use(trajectory, robot.model, robot.limits.effort)
        least, _, nearest = model.least_distance(path(np.linspace(0.0, 1.0, PLACES + 1)))
        pair = model.pair_names[nearest] if nearest >= 0 else ()
        proof = path_clearance(model, path, clearance=clearance)
        free = proof.proven or model.path_is_free(path, CHECK_STEP, max(clearance - TOLERANCE, 0.0))
        goal_error = float(np.abs(trajectory.q[-1] - goal).max())
        kept = use["position"].ratio <= TOLERANCE and all(
            each.ratio <= 1 + TOLERANCE for kind, each in use.items() if kind != "position"
        )
        return cls(
            robot=robot.name,
            tool=robot.tool,
            task=result.task.name,
            measure=result.measure.name,
            measure_unit=result.measure.unit(result.task),
            power=result.power,
            floor=result.floor,
            status=result.status.value,
            duration=trajectory.duration,
            g=cost.g,
            seed_g=result.seed_cost.g,
            length=cost.length,
            seed_length=result.seed_cost.length,
            min_manipulability=cost.min_manipulability,
            min_at=cost.at,
            seed_min_manipulability=result.seed_cost.min_manipulability,
            straight_min_manipulability=straight.min_manipulability,
            minimum_note=_minimum_note(cost, result, straight),
            crossing_note=describe(crossings, least_crossings(kinematics, path.start, path.goal)),
            below_floor=trajectory.duration * _share_below(path, integral, cost),
            clearance=min(least, proof.upper),
            nearest_pair=pair,
            proven_clearance=proof.lower,
            collision_free=free,
            limits=use,
            position_unit=_unit_of(use["position"].joint, robot),
            straight_free=line is None or _is_free(model, line, max(clearance - TOLERANCE, 0.0)),
            goal_error=goal_error,
            passed=bool(free and kept and goal_error <= TOLERANCE),
        )

    def __str__(self) -> str:
        unit = f" {self.measure_unit}" if self.measure_unit != "1" else ""
        first = _first_path(self.status)
        others = f"{first} {_shown(self.seed_min_manipulability)}, straight {_shown(self.straight_min_manipulability)}"
        lines = [
            f"{self.robot}, tool {self.tool}, task {self.task}: {self._verdict()}",
            f"  status       {self.status}",
            f"  duration     {self.duration:.3f} s",
            f"  minimum m    {_shown(self.min_manipulability)}{unit} ({self.measure}; {others}"
            f"{'' if self.straight_free else ', which collides'})",
            f"               {self.minimum_note}",
            f"  g            {self.g:.5g} ({first} {self.seed_g:.5g}), exponent {self.power:g}",
            f"  length       {self.length:.4g} rad ({first} {self.seed_length:.4g})",
        ]
        if self.crossing_note:
            lines.append(f"  singularity  {self.crossing_note}")
        if self.below_floor > 0:
            lines.append(
                f"               m is below {self.floor:.2g} for {1e3 * self.below_floor:.2g} ms: joint control is unaffected, "
                "but a controller of the tool cannot correct errors in a lost direction"
            )
        if self.nearest_pair:
            lines.append(
                f"  clearance    {1e3 * self.clearance:.2f} mm between {' and '.join(self.nearest_pair)}; "
                f"proven on the whole motion: {1e3 * self.proven_clearance:.2f} mm"
            )
        else:
            lines.append(
                "  clearance    nothing to check: no two bodies of the description can touch, and there is no obstacle"
            )
        for kind, use in self.limits.items():
            if not use.joint:
                continue
            worst = f"{100 * use.ratio:.2f} %"
            if kind == "position":
                worst = (
                    f"{use.ratio:.2e} {self.position_unit} outside"
                    if use.ratio > 0
                    else f"{abs(use.ratio):.3f} {self.position_unit} inside"
                )
            lines.append(f"  {kind:<12} {worst} of the limit, {use.joint} at {use.time:.2f} s")
        return "\n".join(lines)

    def _verdict(self) -> str:
        """The verdict at the end of the first line."""
        if not self.passed:
            return "CHECK FAILED"
        if self.status == Status.SINGULAR.value:
            return "limits, collisions and goal passed their checks, but the path is SINGULAR"
        return "all checks passed"

    def to_json(self, file: str | Path) -> None:
        """Write all figures as JSON."""
        write_text(file, json.dumps(json_ready(self), indent=1, allow_nan=False) + "\n")

    @classmethod
    def from_json(cls, file: str | Path) -> "Report":
        """Read what `to_json` wrote; raises FileFormatError for another file."""
        path = existing_file("file", file)
        try:
            return from_json(json.loads(path.read_text()), cls)
        except (ValueError, TypeError, KeyError, AttributeError, RecursionError, OverflowError, OSError) as error:
            raise FileFormatError("file", str(path), f"a report written by manipplan ({error})") from error


def _is_free(model: CollisionModel, path: JointPath, clearance: float) -> bool:
    """Whether a path keeps the clearance [m]: by the proof or, where that does not decide, at samples."""
    proof = path_clearance(model, path, clearance=clearance, tolerance=None)
    return proof.proven or (not proof.refuted and model.path_is_free(path, CHECK_STEP, clearance))


def _standing(path: JointPath, integral: PathIntegral) -> PathCost:
    """The cost of standing still, in place of that of the straight line, for a path that returns to its start."""
    m = float(integral.kinematics.manipulability(path.start))
    return PathCost(g=0.0, length=0.0, min_manipulability=m, at=0.0)


def _share_below(path: JointPath, integral: PathIntegral, cost: PathCost) -> float:
    """The share of [0, 1] on which m is below the floor: intervals of a grid, and finer ones around its dips and roots."""
    if cost.min_manipulability >= integral.floor:
        return 0.0
    s = np.linspace(0.0, 1.0, FINE_PLACES + 1)
    m = integral.kinematics.manipulability(path(s))
    low = m < integral.floor
    is_dip = (m <= np.append(np.inf, m[:-1])) & (m <= np.append(m[1:], np.inf))
    unclear = (low[:-1] != low[1:]) | is_dip[:-1] | is_dip[1:]
    between = s[:-1][unclear, None] + (np.arange(PARTS) + 0.5) / (PARTS * FINE_PLACES)
    share = (integral.kinematics.manipulability(path(between)) < integral.floor).mean(axis=1).sum()
    return float((share + (low[:-1] & low[1:] & ~unclear).sum()) / FINE_PLACES)


def _shown(m: float) -> str:
    """A manipulability in four digits; 0 for rounding noise."""
    return f"{m:.4g}" if m >= VANISHING else "0"


def _unit_of(joint: str, robot: Robot) -> str:
    """Unit of the named joint's position."""
    return "m" if joint and robot.joint_types[robot.joint_names.index(joint)] == "prismatic" else "rad"


def _first_path(status: str) -> str:
    """Name of the path that the result is compared with."""
    return "recorded" if status in {each.value for each in RECORDED} else "seed"


def _compared(least: float, other: float, name: str) -> str:
    """Comparison of a minimum manipulability with that of another path."""
    if other < VANISHING:
        return f"the {name}'s is zero"
    ratio = least / other
    return f"same as the {name}'s" if abs(ratio - 1) < 5e-3 else f"{ratio:.3g} times the {name}'s"


def _minimum_note(cost: PathCost, result: PathResult, straight: PathCost) -> str:
    """How the minimum manipulability compares with the seed's and the straight path's, and why if it is not twice both."""
    least = cost.min_manipulability
    if result.status is Status.FOLLOWED:
        return "seed: the best path among the samples; straight: a line between the ends, which leaves the workspace path"
    first = _first_path(result.status.value)
    others = {first: result.seed_cost.min_manipulability, "straight path": straight.min_manipulability}
    note = ", ".join(_compared(least, other, name) for name, other in others.items())
    if least > 0 and all(least >= 2 * other for other in others.values()):
        return note
    if cost.at <= AT_END or cost.at >= 1 - AT_END:
        return f"{note}; it is at the {'start' if cost.at <= AT_END else 'goal'}, which all paths share"
    if result.path is result.seed:
        return f"{note}; this is the {first} itself"
    return f"{note}; no path with a larger minimum and an equally low g was found"
