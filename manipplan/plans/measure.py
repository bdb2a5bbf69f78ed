"""Measures a finished trajectory: every figure of its Report, and what of it does not pass."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import path_clearance
from manipplan.constraints.constraint import ROW_TOLERANCE, Constraint
from manipplan.constraints.constraint_set import ConstraintSet, figures, prove
from manipplan.cost.crossings import describe, find_crossings, least_crossings, with_shares
from manipplan.cost.integral import PathCost, PathIntegral
from manipplan.cost.objective import idle_hint
from manipplan.kinematics.kinematics import Kinematics
from manipplan.optimize.result import PathResult
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import (
    Deviation,
    beyond_polygon,
    deviations,
    distances_between,
    distances_from,
    largest_deviation,
)
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import UNCOUNTED, VANISHING, PathPart, PlanReport, Report, first_path, tool_figures
from manipplan.robots.robot import Robot
from manipplan.seeds.task import CHECK_STEP
from manipplan.support.checks import COINCIDENT, Array
from manipplan.support.status import ALONG, Status
from manipplan.timing.verify import LimitUse, jerk_use, limit_use, torque_use

#: Maximum joint motion between two poses of the tool that are compared [rad or m], minimum number of these poses, and number of
#: evenly spaced poses of the path that the tool has to come past, beside those through which it was laid.
STEP, LEAST, POSES = 2e-3, 1500, 2001
#: Tolerance below which this joint motion is smaller, as chords leave the tool's way by its square, and smallest share of it.
CHORDS, SMALLEST_SHARE = 2.5e-5, 0.05
#: By which factors it is smaller where a tolerance is exceeded, which chords may cause.
FINER = 1, 4, 16


def tool_distances(
    path: JointPath,
    duration: float,
    kinematics: Kinematics,
    workspace_path: CartesianPath,
    along: Sequence[PathPart],
    tolerance: Tolerance | None = None,
) -> tuple[Deviation, Deviation]:
    """The largest distances of the tool from a workspace path, and of the path's poses from where the tool comes past.

    `..._at` is s of the joint path, and s of the workspace path. The first and the last pose of each part are compared with
    those of the motion: a tool that stops early, or goes backwards, misses one. What the task leaves free does not count.
    Where the path was laid through given poses, the tool is compared with these, too: it must not leave the neighbourhood of
    their polygon, and come past each of them.

    Args:
        path: the motion over its time, in shares of the duration [s].
        along: the parts of the motion on which the tool follows the path; (): all of it.
        tolerance: what the distances are compared with: a pose within it counts as such.
    """
    least = min(part for part in (tolerance.position, tolerance.rotation) if part is not None) if tolerance else CHORDS
    step = STEP * float(np.clip(np.sqrt(least / CHORDS), SMALLEST_SHARE, 1.0))
    for finer in FINER:
        found = _distances_at(path, step / finer, duration, kinematics, workspace_path, along, tolerance)
        if tolerance is None or not any(each.excess(tolerance, "path") for each in found):
            break
    return found


def _distances_at(
    path: JointPath,
    step: float,
    duration: float,
    kinematics: Kinematics,
    workspace_path: CartesianPath,
    along: Sequence[PathPart],
    tolerance: Tolerance | None,
) -> tuple[Deviation, Deviation]:
    """The same, measured on chords between poses between which no joint moves by more than `step` [rad or m]."""
    free, fine = kinematics.free_motion, np.union1d(path.fine_samples(step), path.breaks)  # which are dense at corners
    parts = along or (PathPart(begin=0.0, end=duration),)
    left, missed, ways = [], [], []
    for part in parts:
        begin, end = part.begin / duration, min(part.end / duration, 1.0)
        s = np.union1d(np.linspace(begin, end, LEAST // len(parts)), fine[(fine > begin) & (fine < end)])
        way, stretch = kinematics.pose(path(s)), workspace_path.part(part.s_begin, part.s_end)
        ways.append(way)
        left.append((s, *deviations(stretch, way, free, tolerance)))
        shares = np.union1d(np.linspace(0.0, 1.0, POSES // len(parts)), stretch.knots)
        poses = stretch(shares)
        position, rotation = distances_from(way, poses, free, tolerance, is_reached=True)
        ends = [0, -1]
        position[ends], rotation[ends] = distances_between(way[ends], poses[ends], free)
        missed.append((part.s_begin + shares * (part.s_end - part.s_begin), position, rotation))
    if workspace_path.given is not None:
        whole = np.concatenate(ways)
        left.append((np.concatenate([s for s, *_ in left]), *beyond_polygon(workspace_path.given, whole, free, tolerance)))
        given = distances_from(whole, workspace_path.given, free, tolerance, is_reached=True)
        missed.append((workspace_path.knots, *given))
    left_most, missed_most = (largest_deviation(*map(np.concatenate, zip(*each, strict=True))) for each in (left, missed))
    return left_most, missed_most


#: Excess of a limit [rad, m], or share of it, up to which the limit counts as kept.
TOLERANCE = 1e-6
#: Distance in s from an end of the path within which the minimum manipulability counts as that of the end.
AT_END = 0.01
#: Number of equal intervals of time, at whose ends the report measures distances.
TIME_INTERVALS = 400
#: Number of intervals at whose ends m is compared with the floor, and of samples inside those where it may pass it.
FINE_INTERVALS, PARTS = 5_000, 200


def measure(
    trajectory: Trajectory,
    model: CollisionModel,
    integral: PathIntegral,
    *,
    start: Array | None = None,
    goal: Array | None = None,
    workspace_path: CartesianPath | None = None,
    along: Sequence[PathPart] = (),
    tolerance: Tolerance | None = None,
    constraints: Sequence[Constraint] = (),
    clearance: float = 0.0,
    torque: bool = False,
) -> Report:
    """Measure a finished trajectory of the model's robot, whose columns are the robot's joints, in their order.

    Args:
        start, goal: (n,) where the motion has to begin and end [rad or m]; None: anywhere.
        workspace_path, tolerance: path of the tool, and how far the tool may be from it; None: no path.
        constraints: what every configuration has to keep; held joints keep their first value.
        along: the parts of the motion on which the tool follows that path; (): all of it.
        clearance, torque: required clearance [m], and whether the torque limits are checked, too.
    """
    robot, kinematics = model.robot, integral.kinematics
    path = trajectory.path()
    cost = integral.cost(path)
    crossings = with_shares(find_crossings(path, integral, cost), path, integral, cost)
    use = _limit_uses(trajectory, robot, torque=torque)
    unit = _unit_of(use["position"].joint, robot)
    faults = list(_excesses(use, unit))
    errors: dict[str, float | None] = {"start": None, "goal": None}
    for name, wanted, got in (("start", start, trajectory.q[0]), ("goal", goal, trajectory.q[-1])):
        if wanted is None:
            continue
        off = got - wanted
        if name == "goal":  # full turns of joints without limits are the same posture
            off = np.where(robot.continuous_joints, off - 2 * np.pi * np.round(off / (2 * np.pi)), off)
        off = np.abs(off)
        errors[name] = float(off.max())
        if off.max() > TOLERANCE:
            joint = robot.joint_names[int(off.argmax())]
            faults.append(f"{name}: {joint} is {off.max():.3g} {_unit_of(joint, robot)} away from it")
    clear = _Clearance.of(path, model, clearance)
    if not clear.free:
        faults.append(clear.fault(clearance, trajectory.duration))
    constraint_set = ConstraintSet.of(robot, constraints)
    constraint_figures = figures(constraint_set, prove(constraint_set, path))
    faults += [
        f"constraint: {each.name}: {each.figure}, at {each.at * trajectory.duration:.3f} s"
        for each in constraint_figures
        if each.least < -ROW_TOLERANCE
    ]
    deviation = missed = None
    if workspace_path is not None:
        deviation, missed = tool_distances(path, trajectory.duration, kinematics, workspace_path, along, tolerance)
        for what, distances in (("the tool leaves the path", deviation), ("the tool misses a pose of the path", missed)):
            faults += _outside(what, distances, tolerance)
    return Report(
        robot=robot.name,
        tool=" and ".join(robot.tools),
        task=kinematics.task.name,
        measure=kinematics.measure.name,
        measure_unit=kinematics.measure.unit(kinematics.task),
        power=integral.power,
        floor=integral.floor,
        digest=trajectory.digest,
        duration=trajectory.duration,
        g=cost.g,
        length=cost.length,
        min_manipulability=cost.min_manipulability,
        min_at=cost.at,
        crossing_note=describe(crossings, least_crossings(kinematics, path.start, path.goal)),
        below_floor=trajectory.duration * _share_below(path, integral, cost),
        required_clearance=clearance,
        clearance=clear.smallest,
        nearest_pair=clear.pair,
        proven_clearance=clear.proven,
        collision_free=clear.free,
        limits=use,
        position_unit=unit,
        start_error=errors["start"],
        goal_error=errors["goal"],
        deviation=deviation,
        missed=missed,
        tolerance=tolerance,
        constraints=constraint_figures,
        tools=tool_figures(path, integral),
        faults=tuple(faults),
        passed=not faults,
    )


def measure_plan(
    trajectory: Trajectory,
    result: PathResult,
    model: CollisionModel,
    goal: Array,
    *,
    constraints: Sequence[Constraint] = (),
    clearance: float,
    torque: bool,
) -> PlanReport:
    """Measure the trajectory of a plan, with arguments as in `measure`; only figures of the seed are the optimiser's."""
    kinematics = model.robot.kinematics(result.task, measure=result.measure)
    integral = PathIntegral(kinematics=kinematics, power=result.power, floor=result.floor, metric=result.metric)
    start = result.path.start
    found = measure(
        trajectory, model, integral, start=start, goal=goal, constraints=constraints, clearance=clearance, torque=torque
    )
    first, last = trajectory.q[0], trajectory.q[-1]
    line = JointPath.line(first, last) if np.linalg.norm(last - first) >= COINCIDENT else None
    straight = integral.cost(line).min_manipulability if line is not None else float(kinematics.manipulability(first))
    common = {each.name: getattr(found, each.name) for each in fields(found)}
    return PlanReport(
        **common,
        status=result.status,
        seed_g=result.seed_cost.g,
        seed_length=result.seed_cost.length,
        seed_min_manipulability=result.seed_cost.min_manipulability,
        straight_min_manipulability=straight,
        minimum_note=idle_hint(kinematics) or _minimum_note(found, result, straight),
        straight_free=line is None or _is_free(model, line, max(clearance - TOLERANCE, 0.0)),
    )


@dataclass(frozen=True, kw_only=True)
class _Clearance:
    """The smallest distance found on a path [m], its pair and its s, the proven bound, and whether the clearance is kept."""

    smallest: float
    pair: tuple[str, ...]
    at: float
    proven: float
    free: bool

    @classmethod
    def of(cls, path: JointPath, model: CollisionModel, clearance: float) -> "_Clearance":
        least, row, nearest = model.least_distance(path(np.linspace(0.0, 1.0, TIME_INTERVALS + 1)))
        pair: tuple[str, ...] = model.pair_names[nearest] if nearest >= 0 else ()
        at = row / TIME_INTERVALS
        proof = path_clearance(model, path, clearance=clearance)
        if proof.refuted and proof.upper < least:
            pair, at = proof.pair, proof.at
        smallest, required = min(least, proof.upper), max(clearance - TOLERANCE, 0.0)
        free = proof.proven or (smallest > required and model.path_is_free(path, CHECK_STEP, required))
        return cls(smallest=smallest, pair=pair, at=at, proven=proof.lower, free=free)

    def fault(self, clearance: float, duration: float) -> str:
        """What is wrong where the clearance is not kept."""
        where = f"{' and '.join(self.pair)} at {self.at * duration:.3f} s"
        if self.smallest <= 0:
            return f"collision: overlap by {-1e3 * self.smallest:.3g} mm of {where}"
        if self.smallest <= clearance:
            return f"clearance: {1e3 * self.smallest:.4g} mm instead of {1e3 * clearance:g} mm between {where}"
        return f"collision: two bodies come nearer than {1e3 * clearance:g} mm, at a sample of those {CHECK_STEP:g} rad apart"


def _limit_uses(trajectory: Trajectory, robot: Robot, *, torque: bool) -> Mapping[str, LimitUse]:
    """The highest use of each kind of limit that is checked."""
    use = dict(limit_use(trajectory, robot.limits))
    if np.isfinite(robot.limits.jerk).any():
        use["jerk"] = jerk_use(trajectory, robot.limits)
    if torque:
        use["torque"] = torque_use(trajectory, robot.model, robot.limits.effort)
    return use


def _excesses(use: Mapping[str, LimitUse], unit: str) -> Iterator[str]:
    """One sentence for each limit that is exceeded."""
    for kind, worst in use.items():
        where = f"{worst.joint} at {worst.time:.3f} s"
        if kind == "position":
            if worst.ratio > TOLERANCE:
                yield f"position: {worst.ratio:.4g} {unit} outside the limits, {where}"
        elif np.isinf(worst.ratio):
            yield f"{kind}: the acceleration jumps, {where}"
        elif worst.ratio > 1 + TOLERANCE:
            yield f"{kind}: {100 * worst.ratio:.6g} % of the limit, {where}"


def _outside(what: str, distances: Deviation, tolerance: Tolerance | None) -> Iterator[str]:
    """One sentence for each part of a tolerance that is exceeded."""
    if tolerance is None:
        return
    for value, allowed, at, unit in (
        (distances.position, tolerance.position, distances.position_at, "m"),
        (distances.rotation, tolerance.rotation, distances.rotation_at, "rad"),
    ):
        if allowed is not None and value > allowed:
            yield f"tool: {what} by {value:.4g} {unit} after {100 * at:.0f} % of it; allowed: {allowed:g} {unit}"


def _is_free(model: CollisionModel, path: JointPath, clearance: float) -> bool:
    """Whether a path keeps the clearance [m]: by the proof or, where that does not decide, at samples."""
    proof = path_clearance(model, path, clearance=clearance, tolerance=None)
    return proof.proven or (not proof.refuted and model.path_is_free(path, CHECK_STEP, clearance))


def _share_below(path: JointPath, integral: PathIntegral, cost: PathCost) -> float:
    """The share of [0, 1] on which m is below the floor: intervals of a grid, and finer ones around its dips and roots."""
    if cost.min_manipulability >= integral.floor:
        return 0.0
    s = np.linspace(0.0, 1.0, FINE_INTERVALS + 1)
    m = integral.kinematics.manipulability(path(s))
    low = m < integral.floor
    is_dip = (m <= np.append(np.inf, m[:-1])) & (m <= np.append(m[1:], np.inf))
    unclear = (low[:-1] != low[1:]) | is_dip[:-1] | is_dip[1:]
    between = s[:-1][unclear, None] + (np.arange(PARTS) + 0.5) / (PARTS * FINE_INTERVALS)
    share = (integral.kinematics.manipulability(path(between)) < integral.floor).mean(axis=1).sum()
    return float((share + (low[:-1] & low[1:] & ~unclear).sum()) / FINE_INTERVALS)


def _unit_of(joint: str, robot: Robot) -> str:
    """Unit of the named joint's position."""
    return "m" if joint and robot.joint_types[robot.joint_names.index(joint)] == "prismatic" else "rad"


def _compare(least: float, other: float, name: str) -> str:
    """Comparison of a minimum manipulability with that of another path."""
    if other < VANISHING:
        return f"the {name}'s is zero"
    ratio = least / other
    return f"same as the {name}'s" if abs(ratio - 1) < 5e-3 else f"{ratio:.3g} times the {name}'s"


def _minimum_note(found: Report, result: PathResult, straight: float) -> str:
    """How the minimum manipulability compares with the seed's and the straight path's, and why if it is not twice both."""
    least, at = found.min_manipulability, found.min_at
    if result.status in ALONG:
        return "seed: the best path among the samples; straight: a line between the ends, which leaves the workspace path"
    if result.status is Status.CARRIED:
        return "seed: the best paths among the samples; straight: a line between the ends, on which the tools leave the object"
    if result.status is Status.COMPOSED:
        return "seed: the same motions without blends; straight: a line between the ends"
    if not found.counts:
        return UNCOUNTED
    first = first_path(result.status)
    others = {first: result.seed_cost.min_manipulability, "straight path": straight}
    note = ", ".join(_compare(least, other, name) for name, other in others.items())
    if least > 0 and all(least >= 2 * other for other in others.values()):
        return note
    if at <= AT_END or at >= 1 - AT_END:
        return f"{note}; it is at the {'start' if at <= AT_END else 'goal'}, which all paths share"
    if result.path is result.seed:
        return f"{note}; this is the {first} itself"
    return f"{note}; no path with a larger minimum and an equally low g was found"
