"""Report: every figure of a finished trajectory, measured on the trajectory itself; PlanReport: what a plan adds."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from manipplan.constraints.constraint_set import ConstraintFigure
from manipplan.cost.integral import PathIntegral
from manipplan.measures.manipulability import Constant
from manipplan.paths.deviation import Deviation, angles_between, largest_deviation
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.limits import TakenToLimit
from manipplan.support.checks import COINCIDENT, Array, existing_file
from manipplan.support.data_files import from_json, json_ready, read_json
from manipplan.support.display import one_line
from manipplan.support.errors import reading
from manipplan.support.files import write_text
from manipplan.support.status import RECORDED, Status
from manipplan.symbolic.task import Task
from manipplan.timing.constant_speed import SteadySpeed
from manipplan.timing.verify import LimitUse

#: Number of intervals of time over which the mean manipulability is taken, and at whose ends two motions are compared.
TIMES = 2000
#: Relative change up to which a figure counts as the same, and by which manipulability has to rise to count as better.
UNCHANGED, BETTER = 1e-6, 1e-3
#: Manipulability below this is rounding noise.
VANISHING = 1e-12


@dataclass(frozen=True, kw_only=True)
class MotionFigures:
    """Figures of one motion.

    Attributes:
        min_manipulability, mean_manipulability: of m over the time.
        g: of the objective.
        length: in joint space [rad or m].
        duration: [s].
        peak_jerk, rms_jerk: largest and root mean square jerk of the joints [rad/s³ or m/s³]: change of acceleration from the
            middle of one piece of the trajectory to the middle of the next, per time.
    """

    min_manipulability: float
    mean_manipulability: float
    g: float
    length: float
    duration: float
    peak_jerk: float
    rms_jerk: float

    @classmethod
    def of(cls, motion: Trajectory, integral: PathIntegral) -> "MotionFigures":
        """Measure a motion."""
        path = motion.path()
        cost = integral.cost(path)
        m = integral.kinematics.manipulability(path(np.linspace(0.0, 1.0, TIMES + 1)))
        peak, rms = _jerk(motion)
        return cls(
            min_manipulability=cost.min_manipulability,
            mean_manipulability=float((m[1:] + m[:-1]).mean() / 2),
            g=cost.g,
            length=cost.length,
            duration=motion.duration,
            peak_jerk=peak,
            rms_jerk=rms,
        )


@one_line
@dataclass(frozen=True, kw_only=True)
class Comparison:
    """A recorded motion and the improved one.

    Attributes:
        recorded, improved: the figures of both.
        measure_unit: unit of m.
        deviation: largest distances of the improved tool from the recorded one, at the same share of the time.
        tolerance: what was allowed of it.
    """

    recorded: MotionFigures
    improved: MotionFigures
    measure_unit: str
    deviation: Deviation
    tolerance: Tolerance

    @property
    def worse(self) -> tuple[str, ...]:
        """Names of figures that must not get worse and did: minimum manipulability, g, and jerk unless the motion is faster."""
        before, after = self.recorded, self.improved
        rises = [] if after.duration < before.duration * (1 - UNCHANGED) else ["peak_jerk", "rms_jerk"]
        names = [name for name in ("g", *rises) if getattr(after, name) > getattr(before, name) * (1 + UNCHANGED)]
        if before.min_manipulability >= VANISHING and after.min_manipulability < before.min_manipulability * (1 - UNCHANGED):
            names.insert(0, "min_manipulability")
        return tuple(names)

    @property
    def better(self) -> bool:
        """Whether the minimum or the mean manipulability rose by at least 0.1 %, and no figure of `worse` got worse."""
        names = ("min_manipulability", "mean_manipulability")
        pairs = [(getattr(self.recorded, name), getattr(self.improved, name)) for name in names]
        higher = any(after > max((1 + BETTER) * before, VANISHING) for before, after in pairs)
        return higher and not self.worse

    def __str__(self) -> str:
        unit = "" if self.measure_unit == "1" else f" [{self.measure_unit}]"
        names = (
            f"minimum m{unit}",
            f"mean m{unit}",
            "g",
            "length [rad]",
            "duration [s]",
            "peak jerk [rad/s³]",
            "RMS jerk [rad/s³]",
        )
        lines = [f"{'':<20}{'recorded':>10}{'improved':>10}"]
        for name, each in zip(names, fields(MotionFigures), strict=True):
            lines.append(f"{name:<20}{getattr(self.recorded, each.name):>10.4g}{getattr(self.improved, each.name):>10.4g}")
        allowed = [f"{1e3 * self.tolerance.position:.4g} mm"] if self.tolerance.position is not None else []
        if self.tolerance.rotation is not None:
            allowed.append(f"{np.rad2deg(self.tolerance.rotation):.3g}°")
        return "\n".join([*lines, f"tool {str(self.deviation).replace('path', 'recording')}; allowed: {' and '.join(allowed)}"])


def deviation_between(recorded: Trajectory, improved: Trajectory, integral: PathIntegral) -> Deviation:
    """Largest distances of the tools of two motions from each other, at the same shares of time: at all samples
    of both, and at even times.

    What the task leaves free does not count: of a task without angular rows the orientation, of a pointing task the turn
    about its axis, of a task without linear rows the position.
    """
    even = np.linspace(0.0, 1.0, TIMES + 1)
    u = np.unique(np.concatenate([recorded.t / recorded.duration, improved.t / improved.duration, even]))
    kinematics = integral.kinematics
    first, second = (kinematics.pose(each(np.minimum(u * each.duration, each.duration))) for each in (recorded, improved))
    return largest_deviation(u, *pose_distances(first, second, kinematics.task))


def pose_distances(first: Array, second: Array, task: Task) -> tuple[Array, Array]:
    """Distances [m] and angles [rad] (k,) between poses (k, 4, 4), as far as the task holds them."""
    moves, turns = held(task)
    position = np.linalg.norm(first[:, :3, 3] - second[:, :3, 3], axis=1) if moves else np.zeros(len(first))
    rotation = angles_between(first[:, :3, :3], second[:, :3, :3], task.free_axis) if turns else np.zeros(len(first))
    return position, rotation


def held(task: Task) -> tuple[bool, bool]:
    """Whether the task holds the tool's position, and its orientation."""
    rows = np.array([*task.world_rows, *task.tool_rows])
    return bool(rows[:, :3].any()), bool(rows[:, 3:].any())


def _jerk(motion: Trajectory) -> tuple[float, float]:
    """Largest and root mean square jerk of a motion."""
    widths, (_, _, second, third) = motion.segments()
    if len(widths) == 1:
        return float(6 * np.abs(third).max()), float(6 * np.sqrt(np.mean(third**2)))
    middle = 2 * second + 3 * third * widths[:, None]
    apart = (widths[1:] + widths[:-1]) / 2
    jerk = np.diff(middle, axis=0) / apart[:, None]
    return float(np.abs(jerk).max()), float(np.sqrt(np.average((jerk**2).mean(axis=1), weights=apart)))


@one_line
@dataclass(frozen=True, kw_only=True)
class PathPart:
    """A part of a motion on which the tool follows a workspace path, or a part of one.

    Attributes:
        begin, end: times at which it begins and ends [s].
        s_begin, s_end: where on the workspace path; beyond 1 where it goes on around a closed one.
        min_manipulability: minimum manipulability on it; None where it is not known.
        tool_speed: speed of the tool on it; None where none was asked for.
    """

    begin: float
    end: float
    s_begin: float = 0.0
    s_end: float = 1.0
    min_manipulability: float | None = None
    tool_speed: SteadySpeed | None = None


def part_lines(along: tuple[PathPart, ...], duration: float) -> list[str]:
    """Lines of a report on the parts of a motion of some duration [s]."""
    made = []
    least = [part.min_manipulability for part in along if part.min_manipulability is not None]
    if along and along[0].begin > 0:
        after = f"; minimum m along the path after it: {min(least):.4g}" if least else ""
        made.append(f"  lead-in      {along[0].begin:.3f} s{after}")
    in_parts = len(along) > 1 or any(part.s_begin > 0 for part in along)
    if in_parts:
        kind = "between which the tool leaves it" if len(along) > 1 else "which goes on around it"
        made.append(f"  parts        {len(along)} of the path, {kind}:")
    for part in along:
        if in_parts:
            minimum = "" if part.min_manipulability is None else f"; minimum m {part.min_manipulability:.4g}"
            when = f"from {part.begin:.3f} s to {part.end:.3f} s"
            made.append(f"               s = {part.s_begin:.4f} to {part.s_end:.4f} {when}{minimum}")
        if part.tool_speed is not None:
            made.append(f"  tool speed   {part.tool_speed}")
    if along and along[-1].end < duration:
        made.append(f"  return       {duration - along[-1].end:.3f} s, to the configuration in which the path began")
    return made


@one_line
@dataclass(frozen=True, kw_only=True)
class ToolFigure:
    """Figures of one tool of a robot with several.

    Attributes:
        tool: the tool frame.
        min_manipulability, min_at: minimum of the measure of its arm alone, and the share of the duration at which it occurs;
            of a relative task that of its motion in the world. 0 where its arm has fewer joints than the task has rows.
        goal_position, goal_rotation: distance [m] and angle [rad] from the pose of the goal at the end; None where the goal has
            no pose for this tool.
        held_position, held_rotation: for `carry`: largest distance [m] and angle [rad] from its pose relative to the first
            tool; None for the first tool and for other jobs.
    """

    tool: str
    min_manipulability: float
    min_at: float
    goal_position: float | None = None
    goal_rotation: float | None = None
    held_position: float | None = None
    held_rotation: float | None = None

    def __str__(self) -> str:
        text = f"{self.tool}: minimum m {self.min_manipulability:.4g}"
        if self.goal_position is not None and self.goal_rotation is not None:
            text += f"; ends {1e3 * self.goal_position:.2g} mm, {np.rad2deg(self.goal_rotation):.2g}° from its pose"
        if self.held_position is not None and self.held_rotation is not None:
            held = f"{1e3 * self.held_position:.2g} mm, {1e3 * self.held_rotation:.2g} mrad"
            text += f"; keeps its pose relative to the first tool to {held}"
        return text


def tool_figures(path: JointPath, integral: PathIntegral) -> tuple[ToolFigure, ...]:
    """The figures of each tool on a path; none for a robot with one."""
    kinematics = integral.kinematics
    robot, task, measure = kinematics.robot, replace(kinematics.task, relative_to=None), kinematics.measure.of_one_tool()
    if len(robot.tools) == 1:
        return ()
    found = []
    for tool in robot.tools:
        joints = list(robot.joints_of(tool))
        if measure.needs_full_rank and task.rows > len(joints):  # of a relative task, which the joints of both tools serve
            found.append(ToolFigure(tool=tool, min_manipulability=0.0, min_at=0.0))
            continue
        one = robot.arm(tool).kinematics(task, measure=measure, compiled=kinematics.compiled, threads=1)
        own = JointPath(breaks=path.breaks, control=path.control[:, :, joints])
        if own.length < COINCIDENT:
            found.append(ToolFigure(tool=tool, min_manipulability=float(one.manipulability(own.start)), min_at=0.0))
            continue
        cost = replace(integral, kinematics=one, metric=None).cost(own)
        found.append(ToolFigure(tool=tool, min_manipulability=cost.min_manipulability, min_at=cost.at))
    return tuple(found)


def with_errors(
    figures: tuple[ToolFigure, ...], errors: Mapping[str, tuple[float, float]], name: Literal["goal", "held"]
) -> tuple[ToolFigure, ...]:
    """The figures with the distance [m] and angle [rad] of some tools from where each has to be: at its goal, or held."""
    found: dict[str, Any] = {tool: {f"{name}_position": p, f"{name}_rotation": r} for tool, (p, r) in errors.items()}
    return tuple(replace(each, **found.get(each.tool, {})) for each in figures)


#: What stands in place of the minimum manipulability where it does not count.
UNCOUNTED = "does not count: it is zero in every configuration, or the measure is constant; the shortest path was sought"


@one_line
@dataclass(frozen=True, kw_only=True)
class Report:
    """Figures of a finished trajectory. Lengths are in radians or metres of joint space, times in seconds.

    Attributes:
        robot, tool, task, measure, measure_unit: the arm, the task and the measure of manipulability, with its unit.
        power, floor: exponent and floor of g.
        digest: `Trajectory.digest` of the motion that was measured.
        duration: of the trajectory [s].
        g: g of the objective along the trajectory.
        length: in joint space.
        min_manipulability, min_at: minimum manipulability along the trajectory, and the share of the duration at which it
            occurs.
        crossing_note: which singularities the trajectory meets, and whether that can be avoided; "" for none.
        below_floor: time for which m is below the floor of g [s], to 1e-6 of the duration.
        required_clearance: the clearance that was asked for [m].
        clearance, nearest_pair: minimum distance [m] measured at evenly spaced times, and its pair; inf and () if nothing
            is checked.
        proven_clearance: lower bound on the distances of all checked pairs on the whole trajectory, at all times [m].
        collision_free: whether the required clearance is proven on the whole trajectory or, where the proof does not decide,
            kept at samples between which no joint moves more than 1e-3 rad or m.
        limits: highest use of the limits of position, velocity, acceleration and, where they are checked, jerk and torque.
        position_unit: "rad" or "m", of the joint that comes closest to a position limit.
        start_error, goal_error: largest distance of the first sample from the start, and of the last one from the goal [rad or
            m]; None where none was given.
        deviation: largest distances of the tool from the workspace path or, where they are larger, from the neighbourhood of
            the polygon of the poses that it was laid through, at shares of the duration; None without a path.
        missed: largest distances of the poses of the workspace path from where the tool comes past, at s of the path. Its first
            and last pose are compared with those of the motion.
        tolerance: what was allowed of both; None without a path.
        constraints: how the motion keeps each constraint, at shares of the duration.
        along: for `follow`: the part of the motion along the workspace path, or the parts, in their order.
        tools: for a robot with several tools, the figures of each.
        taken_to_limits: joints of start, goal or recording that were given outside a position limit, by at most
            `robot.limit_tolerance` (of a recording: its noise), and were taken to it.
        faults: one sentence for each check that did not pass.
        passed: whether all checks passed: limits, collisions and, where they were given, start, goal, constraints and workspace
            path.
    """

    robot: str
    tool: str
    task: str
    measure: str
    measure_unit: str
    power: float
    digest: str
    duration: float
    g: float
    length: float
    min_manipulability: float
    min_at: float
    clearance: float
    nearest_pair: tuple[str, ...]
    proven_clearance: float
    collision_free: bool
    limits: Mapping[str, LimitUse]
    position_unit: str
    passed: bool
    floor: float = 0.0
    crossing_note: str = ""
    below_floor: float = 0.0
    required_clearance: float = 0.0
    start_error: float | None = None
    goal_error: float | None = None
    deviation: Deviation | None = None
    missed: Deviation | None = None
    tolerance: Tolerance | None = None
    constraints: tuple[ConstraintFigure, ...] = ()
    along: tuple[PathPart, ...] = ()
    tools: tuple[ToolFigure, ...] = ()
    taken_to_limits: tuple[TakenToLimit, ...] = ()
    faults: tuple[str, ...] = ()

    def __str__(self) -> str:
        lines = [f"{self.robot}, tool {self.tool}, task {self.task}: {self._verdict()}"]
        lines += [f"  failed       {fault}" for fault in self.faults]
        lines += [
            f"  duration     {self.duration:.3f} s",
            f"  minimum m    {f'{self._minimum()}, after {self.min_at * self.duration:.3f} s' if self.counts else UNCOUNTED}",
            f"  g            {self.g:.5g}, exponent {self.power:g}",
            f"  length       {self.length:.4g} rad",
            *self._figure_lines(),
        ]
        for name, error in (("start", self.start_error), ("goal", self.goal_error)):
            if error is not None:
                lines.append(f"  {name:<12} {error:.2g} rad or m away")
        if self.deviation is not None:
            lines.append(f"  tool         {self.deviation}")
        if self.missed is not None:
            lines.append(f"  path         its poses are {str(self.missed).replace('the path', 'the way of the tool')}")
        return "\n".join(lines)

    @property
    def summary(self) -> str:
        """Duration, minimum manipulability and verdict in a few words."""
        least = f"minimum m {shown(self.min_manipulability)}{self.unit}" if self.counts else f"length {self.length:.4g}"
        return f"{self.duration:.3f} s, {least}, {self._verdict()}"

    @property
    def counts(self) -> bool:
        """Whether the manipulability counts: not with the constant measure, as for an arm where it is identically zero."""
        return self.measure != Constant.name

    def _minimum(self, others: str = "") -> str:
        """The minimum manipulability with its measure."""
        return f"{shown(self.min_manipulability)}{self.unit} ({self.measure}{others})"

    def _verdict(self) -> str:
        """The verdict at the end of the first line."""
        return "all checks passed" if self.passed else "CHECK FAILED"

    @property
    def unit(self) -> str:
        """Unit of the measure behind a space; "" for none."""
        return f" {self.measure_unit}" if self.measure_unit != "1" else ""

    def _figure_lines(self) -> list[str]:
        """Lines on singularities, clearance, constraints and limits."""
        lines = [f"  limit        {each}" for each in self.taken_to_limits]
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
        lines += [f"  tool         {each}" for each in self.tools]
        lines += [f"  constraint   {each}, at {each.at * self.duration:.2f} s" for each in self.constraints]
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
        return lines

    def to_json(self, file: str | Path) -> None:
        """Write all figures as JSON."""
        write_text(file, json.dumps(json_ready(self), indent=1, allow_nan=False) + "\n")

    @classmethod
    def from_json(cls, file: str | Path) -> "Report":
        """Read what `to_json` wrote, a PlanReport for that of a plan; raises FileFormatError for another file."""
        path = existing_file("file", file)
        with reading("file", path, "a report written by manipplan"):
            data = read_json("file", path)
            return from_json(data, PlanReport if "seed_g" in data else Report)


@one_line
@dataclass(frozen=True, kw_only=True)
class PlanReport(Report):
    """The report of a plan: that of its trajectory, with the attributes of Report, beside the seed and the straight line.

    Attributes:
        status: the outcome of the job.
        seed_g, seed_length, seed_min_manipulability: figures of the seed; for `improve`, of the recorded motion.
        straight_min_manipulability: minimum manipulability on the straight line from start to goal.
        straight_free: whether that line is collision-free.
        minimum_note: how the minimum manipulability compares with those two, and the reason if it is not twice both.
        comparison: for `improve`, the recorded motion and this one side by side.
    """

    status: Status
    goal_error: float
    seed_g: float
    seed_length: float
    seed_min_manipulability: float
    straight_min_manipulability: float
    minimum_note: str
    straight_free: bool
    comparison: Comparison | None = None

    def __str__(self) -> str:
        first = first_path(self.status)
        others = f"; {first} {shown(self.seed_min_manipulability)}, straight {shown(self.straight_min_manipulability)}"
        others += "" if self.straight_free else ", which collides"
        lines = [
            f"{self.robot}, tool {self.tool}, task {self.task}: {self._verdict()}",
            f"  status       {self.status.value}",
            *(f"  failed       {fault}" for fault in self.faults),
            f"  duration     {self.duration:.3f} s",
            f"  minimum m    {self._minimum(others) if self.counts else UNCOUNTED}",
            *([f"               {self.minimum_note}"] if self.counts else []),
            f"  g            {self.g:.5g} ({first} {self.seed_g:.5g}), exponent {self.power:g}",
            f"  length       {self.length:.4g} rad ({first} {self.seed_length:.4g})",
        ]
        lines += [*part_lines(self.along, self.duration), *self._figure_lines()]
        if self.comparison is not None:
            lines += [f"  {line}" for line in str(self.comparison).splitlines()]
        return "\n".join(lines)

    def _verdict(self) -> str:
        if self.passed and self.status is Status.SINGULAR:
            return "limits, collisions and goal passed their checks, but the path is SINGULAR"
        return super()._verdict()


def shown(m: float) -> str:
    """A manipulability in four digits; 0 for rounding noise."""
    return f"{m:.4g}" if m >= VANISHING else "0"


def first_path(status: Status) -> str:
    """Name of the path that the result is compared with."""
    return "recorded" if status in RECORDED else "seed"
