"""Puts the motions of a program together: blends, timing, checks, marks.

Times a part of a program, with the constant speeds of the tool that its motions ask for.
"""

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from manipplan.constraints.constraint import ROW_TOLERANCE
from manipplan.constraints.constraint_set import ConstraintFigure, figures, prove
from manipplan.cost.crossings import is_singular
from manipplan.cost.objective import PathObjective
from manipplan.optimize.result import make_result
from manipplan.paths.deviation import deviation_at, deviation_from
from manipplan.paths.joint import JointPath, cut
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.plans.report import PlanReport
from manipplan.plans.result import PartialPlan, Plan, finish
from manipplan.programs.blend import HULL, Blend, blend_of, find_unblended, is_corner, with_blends
from manipplan.programs.leg_motions import RawMotion, Stop
from manipplan.programs.legs import Leg, State
from manipplan.programs.program import Mark, Program
from manipplan.programs.steps import Attach, Detach, MoveAlong, MoveTo, ProgramStep
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.status import Failure, Status
from manipplan.timing.constant_speed import GRIDS, RAMP, SteadySpeed, measure_speed, slower, steady_segments
from manipplan.timing.retime import retime
from manipplan.timing.stops import Segment

#: Number of times that are compared to find when a motion comes past a place.
TIMES = 4000


@dataclass(frozen=True, kw_only=True, eq=False)
class Timed:
    """A timed part.

    Attributes:
        trajectory: the motion.
        speeds: the speed of the tool on each motion that asks for one, by its place in the part.
    """

    trajectory: Trajectory
    speeds: Mapping[int, SteadySpeed]


@dataclass(frozen=True, kw_only=True, eq=False)
class Timing:
    """What is to be timed.

    Attributes:
        robot, path: the arm, with what it carries, and the path of the whole part.
        motions: its motions.
        spans: the s of the path between which each motion reaches, up to the middle of its blends.
        own: the s between which it keeps its own path.
        torque: whether the joints' effort limits are kept as well.
    """

    robot: Robot
    path: JointPath
    motions: Sequence[RawMotion]
    spans: Sequence[tuple[float, float]]
    own: Sequence[tuple[float, float]]
    torque: bool

    def made(self) -> Timed:
        """The fastest motion with the tool speeds that are asked for.

        Raises InvalidInputError, which names the step and the fastest speed that is possible, where the tool cannot keep its
        speed between the ramps, and PlanningError as `retime`.
        """
        asked = {k: motion.tool_speed for k, motion in enumerate(self.motions) if motion.tool_speed is not None}
        timed = self._timed(asked, GRIDS)
        for k, speed in timed.speeds.items():
            if not speed.is_steady:
                own = cut(self.path, *self.own[k])

                def keep(value: float, k: int = k) -> bool:
                    return self._timed({k: value}, GRIDS).speeds[k].is_steady

                wanted = slower(own, self.robot, speed.asked, keep, torque=self.torque)
                raise InvalidInputError(f"steps[{self.motions[k].step}].tool_speed", speed.asked, wanted)
        return timed

    def _timed(self, asked: Mapping[int, float], grids: Sequence[int]) -> Timed:
        """The motion with these speeds, by the first grid on which they are constant, else by the last."""
        segments: list[Segment] = []
        for k, speed in asked.items():
            begin, end = self.spans[k]
            segments += [Segment(begin=begin, end=end, tool_speed=speed), *steady_segments(*self.own[k], speed)]
        for grid in grids:  # slow motions need more points, as the tool turns between two of them
            trajectory = retime(self.path, self.robot, torque=self.torque, segments=segments, grid=grid)
            speeds = {}
            for k, speed in asked.items():
                begin, end = times_of(trajectory, self.path, self.own[k])
                speeds[k] = measure_speed(
                    trajectory, self.robot, speed, slowdown=self.motions[k].slowdown, begin=begin, end=end, short=RAMP
                )
            if all(each.is_steady for each in speeds.values()):
                break
        return Timed(trajectory=trajectory, speeds=speeds)


def times_of(trajectory: Trajectory, path: JointPath, places: Sequence[float]) -> list[float]:
    """When the motion comes past places s of its path, in their order [s]."""
    t = np.union1d(np.linspace(0.0, trajectory.duration, TIMES + 1), trajectory.t)  # stops are at samples
    q = trajectory(t)
    found: list[float] = []
    begin = 0
    for s in places:
        away = np.linalg.norm(q[begin:] - path(np.array([s]))[0], axis=1)
        begin += int(away.argmin())
        found.append(float(t[begin]))
    return found


#: Distance from the nearest body above which a part counts as let go in the air [m].
IN_THE_AIR = 5e-3
#: The same where a part is taken up: a hand closes around it [m].
OUT_OF_HAND = 5e-2
#: Number of places at which a motion is compared with the path of the tool, and a blend with what it replaces.
MOTION_SAMPLES, BLEND_SAMPLES = 800, 200


def assemble(
    items: Sequence[RawMotion | Stop],
    first: State,
    last: State,
    steps: Sequence[ProgramStep],
    legs: Mapping[int, Leg],
    *,
    goals: Mapping[int, int],
    blend: float,
    objective: PathObjective,
    clearance: float,
    torque: bool,
) -> Program:
    """The program of motions and stops; each run of motions between two stops is one part.

    `first` and `last`: arm and scene before and after it. `legs` and `goals`: the leg that begins at a step, and the index of
    the goal that its free motion reaches.

    Raises PlanningError, which names the step, where a part cannot be timed.
    """
    parts: list[Plan] = []
    clocks: list[float] = []
    marks: list[Mark] = []
    stops: list[float] = []
    warnings: list[str] = []
    pieces: list[Trajectory] = []
    clock = 0.0
    for group in _groups(items):
        if isinstance(group, Stop):
            marks.append(Mark(step=group.step, name=type(steps[group.step]).__name__, begin=clock))
            warnings += _far_away(steps[group.step], group)
            if group.seconds:
                still = np.array([group.q, group.q])
                names = first.robot.joint_names
                pieces.append(Trajectory(t=np.array([0.0, group.seconds]), q=still, qd=np.zeros_like(still), joint_names=names))
                clock += group.seconds
            continue
        corners = _corners(group, steps, blend)
        blends = _blends(group, corners, clearance, legs)
        warnings += _smaller(group, corners, blends)
        made = [each if isinstance(each, Blend) else None for each in blends]
        part, begins, speeds, standing = _part(group, made, clock, legs, goals, objective, clearance, torque)
        for k, (motion, begin, speed) in enumerate(zip(group, begins, speeds, strict=True)):
            if not marks or marks[-1].step != motion.step:
                marks.append(Mark(step=motion.step, name=type(steps[motion.step]).__name__, begin=begin))
            if motion.workspace_path is not None:
                marks[-1] = replace(marks[-1], path_begin=begin, tool_speed=speed)
            if k + 1 < len(group) and corners[k] is not None:
                blended = made[k]
                radius = 0.0 if blended is None else blended.radius
                inner = group[k + 1].step == motion.step
                marks[-1] = replace(marks[-1], path_blend=radius) if inner else replace(marks[-1], blend=radius)
        stops += standing
        parts.append(part)
        clocks.append(clock)
        pieces.append(part.trajectory)
        clock += part.trajectory.duration
    return Program(
        robot=first.robot,
        scene=first.scene,
        final_robot=last.robot,
        final_scene=last.scene,
        parts=tuple(parts),
        begins=tuple(clocks),
        marks=tuple(marks),
        trajectory=joined(pieces),
        goals={step: index for step, index in goals.items() if len(legs[step].targets) > 1},
        stops=tuple(stops),
        warnings=tuple(warnings),
    )


def _groups(items: Sequence[RawMotion | Stop]) -> list[list[RawMotion] | Stop]:
    """Runs of motions, and the stops between them."""
    groups: list[list[RawMotion] | Stop] = []
    for item in items:
        if isinstance(item, Stop):
            groups.append(item)
        elif groups and isinstance(groups[-1], list):
            groups[-1].append(item)
        else:
            groups.append([item])
    return groups


def _corners(group: list[RawMotion], steps: Sequence[ProgramStep], blend: float) -> list[float | None]:
    """The radius asked for at each corner between motions; None where the arm goes straight on."""
    asked: list[float | None] = []
    for one, other in pairwise(group):
        step = steps[one.step]
        own = step.blend if isinstance(step, MoveTo | MoveAlong) else None
        asked.append((blend if own is None else own) if is_corner(one.path, other.path) else None)
    return asked


def _blends(
    group: list[RawMotion], corners: list[float | None], clearance: float, legs: Mapping[int, Leg]
) -> list[Blend | Failure | None]:
    """The blends of motions, or why there is none; None where none is asked for."""
    made: list[Blend | Failure | None] = []
    for k, ((one, other), asked) in enumerate(zip(pairwise(group), corners, strict=True)):
        if not asked:
            made.append(None)
            continue
        constraints = tuple(legs[each.step].constraints for each in (one, other) if each.workspace_path is None)
        alone = k == 0 or not corners[k - 1], k + 1 == len(corners) or not corners[k + 1]
        made.append(blend_of(one, other, asked, clearance, constraints, alone=alone))
    return made


def _smaller(group: list[RawMotion], corners: list[float | None], blends: list[Blend | Failure | None]) -> list[str]:
    """A warning for each blend that is smaller than asked for, or replaced by a stop."""
    warnings = []
    for (one, other), asked, made in zip(pairwise(group), corners, blends, strict=True):
        if made is None or asked is None or (isinstance(made, Blend) and not made.note):
            continue
        where = "where its path begins" if one.step == other.step else f"at the corner before steps[{other.step}]"
        used = f"a blend of {1e3 * made.radius:.3g} mm" if isinstance(made, Blend) else "a stop"
        why = made.note if isinstance(made, Blend) else made.message
        warnings.append(f"steps[{one.step}]: {used} {where}, instead of a blend of {1e3 * asked:.3g} mm: {why}")
    return warnings


def _part(
    group: list[RawMotion],
    blends: list[Blend | None],
    clock: float,
    legs: Mapping[int, Leg],
    goals: Mapping[int, int],
    objective: PathObjective,
    clearance: float,
    torque: bool,
) -> tuple[Plan, list[float], list[SteadySpeed | None], list[float]]:
    """A part, when its motions begin [s], their speeds of the tool, and when it stops at a corner [s]."""
    state = group[0].state
    robot, model = state.robot, state.scene.collision_model(state.robot)
    path, own = with_blends(group, blends)
    middles = [(before[1] + after[0]) / 2 for before, after in pairwise(own)]
    spans = list(pairwise([0.0, *middles, 1.0]))
    try:
        timed = Timing(robot=robot, path=path, motions=group, spans=spans, own=own, torque=torque).made()
    except PlanningError as error:
        raise PlanningError(f"steps[{group[0].step}] to steps[{group[-1].step}]: {error}") from error
    trajectory = timed.trajectory
    integral = objective.integral(robot)
    sharp, _ = with_blends(group, [None] * len(blends))
    cost = integral.cost(path)
    result = make_result(
        path,
        integral,
        cost=cost,
        seed=sharp if any(blends) else path,
        seed_cost=integral.cost(sharp),
        model=model,
        clearance=clearance,
        status=Status.COMPOSED,
    )
    begins = times_of(trajectory, path, middles)
    taken = tuple(
        each
        for motion in group
        if motion.workspace_path is None and motion.step in goals
        for each in legs[motion.step].targets[goals[motion.step]].taken
    )

    def compare_with_steps(report: PlanReport, _: Trajectory) -> PlanReport:
        found = _constraint_figures(group, trajectory, begins, legs)
        faults = (
            *report.faults,
            *(f"constraint: {each}" for each in found if each.least < -ROW_TOLERANCE),
            *(
                f"steps[{group[k].step}]: the tool speed is not constant: {v}"
                for k, v in timed.speeds.items()
                if not v.is_steady
            ),
            *_off_paths(group, blends, own, trajectory, path),
            *_off_hulls(group, blends, own, trajectory, path),
            *_missed(group, blends, goals, legs, trajectory),
        )
        return replace(report, faults=faults, constraints=tuple(found))

    part = finish(
        PartialPlan(
            robot=robot,
            scene=state.scene,
            status=Status.SINGULAR if is_singular(path, integral, cost) else Status.COMPOSED,
            path=path,
            result=result,
        ),
        lambda: (trajectory, ()),
        taken=taken,
        clearance=clearance,
        torque=torque,
        throw=False,
        amend=compare_with_steps,
    )
    assert isinstance(part, Plan)
    corners = [
        clock + begin
        for begin, one, other, made in zip(begins, group[:-1], group[1:], blends, strict=True)
        if made is None and is_corner(one.path, other.path)
    ]
    speeds = [timed.speeds.get(k) for k in range(len(group))]
    return part, [clock, *(clock + begin for begin in begins)], [each and each.later(clock) for each in speeds], corners


def _constraint_figures(
    group: list[RawMotion], trajectory: Trajectory, begins: list[float], legs: Mapping[int, Leg]
) -> list[ConstraintFigure]:
    """How each free motion keeps its constraints over its time."""
    whole, edges = trajectory.path(), np.array([0.0, *begins, trajectory.duration]) / trajectory.duration
    made = []
    for motion, (begin, end) in zip(group, pairwise(edges.tolist()), strict=True):
        constraints = legs[motion.step].constraints if motion.workspace_path is None else None
        if constraints is not None and constraints.constraints:
            made += [
                replace(each, name=f"steps[{motion.step}], {each.name}", at=begin + each.at * (end - begin))
                for each in figures(constraints, prove(constraints, cut(whole, begin, end)))
            ]
    return made


def _off_paths(
    group: list[RawMotion], blends: list[Blend | None], own: list[tuple[float, float]], trajectory: Trajectory, path: JointPath
) -> list[str]:
    """Which motions leave their paths of the tool, but for their blends: in order as planned, and over their time."""
    faults = []
    times = np.array(times_of(trajectory, path, [s for each in own for s in each])).reshape(-1, 2)
    for motion, (low, high), (begin, end) in zip(group, find_unblended(blends), times, strict=True):
        if motion.workspace_path is None:
            continue
        assert motion.task is not None and motion.tolerance is not None
        kinematics = motion.state.robot.kinematics(motion.task)
        pose, free = kinematics.pose, kinematics.free_motion
        knots = motion.workspace_path.knots
        # given poses are met, too
        s = np.union1d(np.linspace(low, high, MOTION_SAMPLES), knots[(knots >= low) & (knots <= high)])
        timed = trajectory(np.linspace(begin, end, MOTION_SAMPLES))
        fault = deviation_from(motion.workspace_path, pose(timed), free).excess(motion.tolerance, "time") or deviation_at(
            motion.workspace_path, s, pose(motion.path(s)), free
        ).excess(motion.tolerance, "path")
        if fault:
            faults.append(f"steps[{motion.step}]: {fault}")
    return faults


def _off_hulls(
    group: list[RawMotion], blends: list[Blend | None], own: list[tuple[float, float]], trajectory: Trajectory, path: JointPath
) -> list[str]:
    """At which blends the tool leaves the convex hull of the pieces that the blend replaces."""
    faults = []
    for motion, blend, (before, after) in zip(group[:-1], blends, pairwise(own), strict=True):
        if blend is not None:
            step = trajectory.duration / TIMES  # of the times that are compared
            begin, end = times_of(trajectory, path, [before[1], after[0]])
            if begin + step >= end - step:
                continue
            beyond = blend.beyond(trajectory(np.linspace(begin + step, end - step, BLEND_SAMPLES)))
            if beyond > HULL:
                faults.append(f"steps[{motion.step}]: at its end the tool is {1e3 * beyond:.3g} mm outside of the corner")
    return faults


def _missed(
    group: list[RawMotion],
    blends: list[Blend | None],
    goals: Mapping[int, int],
    legs: Mapping[int, Leg],
    trajectory: Trajectory,
) -> list[str]:
    """Which motions do not reach their goals, but for those that a blend rounds off."""
    faults = []
    for k, motion in enumerate(group):
        last = k + 1 == len(group)
        if motion.step not in goals or (not last and (group[k + 1].step == motion.step or blends[k] is not None)):
            continue
        q = trajectory.q[-1] if last else motion.path.goal
        missed = legs[motion.step].targets[goals[motion.step]].missed_by(motion.state.robot, q)
        if missed:
            faults.append(f"steps[{motion.step}]: {missed}")
    return faults


def _far_away(step: ProgramStep, stop: Stop) -> list[str]:
    """A warning where a part is taken up far from the hand, or let go far from every body that could hold it."""
    robot, scene = stop.state.robot, stop.state.scene
    model = scene.collision_model(robot)
    pairs = [(model.objects[i], model.objects[j]) for i, j in model.pairs.tolist()]
    if isinstance(step, Detach):
        name, what, most, where = step.name, "let go in the air", IN_THE_AIR, "the nearest body"
        own = set(robot.carried[name].bodies)
        near = [k for k, pair in enumerate(pairs) if any(_is_of(each.name, own) for each in pair)]
        is_allowed = any(name in pair for pair in scene.allowed)
    elif isinstance(step, Attach) and isinstance(step.part, str):
        name, what, most, where = step.part, "taken up", OUT_OF_HAND, "the hand"
        joint = robot.model.frames[frame_index(robot.model, step.tool or robot.tool)].parentJoint
        near = [k for k, (body, part) in enumerate(pairs) if body.parentJoint == joint and _is_of(part.name, {name})]
        links = {frame.name for frame in robot.model.frames if frame.parentJoint == joint}
        is_allowed = any(name in pair and pair & links for pair in scene.allowed)
    else:
        return []
    if is_allowed:  # they may touch, and their distance is not known
        return []
    if not near:
        return [f"steps[{stop.step}]: {name} is {what}, and there is no body that could hold it"]
    distance = float(model.pair_distances(np.tile(stop.q, (len(near), 1)), near).min())
    return [f"steps[{stop.step}]: {name} is {what}, {1e3 * distance:.3g} mm from {where}"] if distance > most else []


def _is_of(body: str, names: Container[str]) -> bool:
    """Whether a body belongs to one of some parts: of several bodies they are name.0, name.1, ..."""
    return body in names or body.rpartition(".")[0] in names
