"""sequence: a program of moves, whose configurations are chosen together."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from manipplan.collision.scene import Scene
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import read_configuration
from manipplan.jobs.plan import find_path
from manipplan.optimize.optimize import check_options
from manipplan.optimize.result import PathResult
from manipplan.paths.basis import PathShape
from manipplan.plans.result import PartialPlan, failed
from manipplan.programs.assemble import assemble
from manipplan.programs.choose import Chosen, Planner, ProgramSearch
from manipplan.programs.leg_motions import Node, RawMotion, Stop, ToolPathPlanners, nodes_of, part_poses_after
from manipplan.programs.legs import Leg, PartPoses, State, check_parts, needed_by, read_steps
from manipplan.programs.program import Program
from manipplan.programs.steps import Attach, Detach, ProgramStep
from manipplan.robots.limits import taken_to_limits
from manipplan.robots.robot import Robot
from manipplan.seeds.seeding import AS_GIVEN, NEAREST, WITHIN_LIMITS, Seeding
from manipplan.support.checks import Array, ArrayLike, flag, instance, number
from manipplan.support.deadline import OutOfTimeError, TimeLimit, until, work_time
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, as_callback, interruptible, part
from manipplan.support.status import Failure, Status
from manipplan.support.workers import one_thread
from manipplan.timing.retime import check_timing_limits, retime


@interruptible()
@one_thread()
def sequence(
    robot: Robot,
    start: ArrayLike | str,
    steps: Sequence[ProgramStep],
    scene: Scene | None = None,
    *,
    blend: float = 0.0,
    objective: PathObjective = PathObjective(),
    shape: PathShape = PathShape(),
    seeding: Seeding = Seeding(),
    clearance: float = 0.0,
    torque: bool = False,
    time_limit: float | None = None,
    progress: Progress | None = None,
) -> Program:
    """Plan several moves together as one program: pick, carry, place, weld, retreat.

    All configurations that reach the goals of the moves are candidates. One search over the whole program chooses among them
    for the largest minimum manipulability. It begins with upper bounds for the free motions, then plans the motions that it
    chose. If one fails or keeps less than its bound, the search is repeated with what it kept. Of programs whose bounds differ
    by less than 1 % it takes the one with the smallest sum of g on straight lines.

    A program that begins with a path goes on from the start where it reaches the path's first pose; if no motion leads on from
    there, another configuration may begin the path.

    A part is carried as it was grasped. A goal that is a pose of the part has configurations of its own for each grasp, and
    both are chosen together.

    Args:
        robot: the arm; of several tools `Attach` names the hand, and only `MoveTo` moves them.
        start: (n,) inside the limits and collision-free [rad or m], or the name of one of `robot.states`.
        steps: `MoveTo`, `MoveAlong`, `Attach`, `Detach` and `Wait`, in their order.
        scene: obstacles at the beginning; None: none.
        blend: largest distance of the tool from a corner between two moves where the arm goes around it without a stop [m];
            0: it stops at each corner. It holds for moves that have no `blend` of their own. Paths of the tool are left near
            their ends by that much, and at least half of each is left. On a blend the tool stays in the convex hull of the
            two pieces of its way that the blend replaces, to 0.1 mm. A blend that would leave it, touch something, or leave
            the limits or constraints, is halved, and at last the arm stops. The marks have the radii, and a warning says
            where one is smaller than asked for.
        objective: as for `plan`, for all moves.
        shape, seeding: as for `plan`, for free motions; `time_limit` holds for each of them. With shifts="nearest" the joints
            go the short way to every goal that is a configuration.
        clearance: distance [m] to keep from obstacles and between the arm's own links.
        torque: keep the joints' effort limits as well.
        time_limit: time [s] for all of it; None: none. A program is found first, and better ones are searched while timing and
            checks are likely to end in time. What is built once per robot or scene does not count.
        progress: called with the fraction done in [0, 1] and a text.

    Returns:
        The Program, all of whose parts passed their checks.

    Raises:
        InvalidInputError: an argument is invalid, no goal of a move can be reached, or a tool speed is too fast; the message
            names the step, and the fastest speed.
        UnknownNameError: a part or state of that name is not there; the nearest names are listed.
        PlanningError: no program was found, or a part did not pass its check; the message names the step. Where none was found
            in time, `result` is a PartialPlan with Status.NOT_IN_TIME.
    """
    instance("robot", robot, Robot)
    check_options(objective, shape, seeding)
    if seeding.shifts == WITHIN_LIMITS:
        raise InvalidInputError("seeding.shifts", seeding.shifts, f"{AS_GIVEN!r}, or {NEAREST!r} for the short way")
    if seeding.initial is not None:
        raise InvalidInputError("seeding.initial", seeding.initial, "None: a program has several free motions")
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    blend, clearance = number("blend", blend, least=0.0), number("clearance", clearance, least=0.0)
    flag("torque", torque)
    limit = TimeLimit(time_limit, "configurations of the steps")
    notify = limit.noting(as_callback(progress))
    in_time = until(limit.deadline, notify)
    check_timing_limits(robot.limits)
    given = read_configuration("start", start, robot)
    q_start = scene.collision_model(robot).free_configuration("start", given, clearance)
    legs = read_steps(steps, robot, q_start, blend=blend, turns=seeding.shifts == NEAREST)
    check_parts([(f"steps[{k}]", each) for k, each in enumerate(steps)], robot, scene)
    first = State(robot=robot, scene=scene)
    planners = ToolPathPlanners(objective=objective, clearance=clearance, deadline=limit.deadline)
    planner = _planner(objective, shape, replace(seeding, shifts=AS_GIVEN), clearance, torque)
    try:
        search = _search(legs, first, q_start, planners, planner, seeding.time_limit, in_time)
        chosen = search.best(part(in_time, 0.2, 0.9))
        if chosen is None and search.leads_nowhere:
            legs = read_steps(steps, robot, q_start, blend=blend, turns=seeding.shifts == NEAREST, leads_in=True)
            search = _search(legs, first, q_start, planners, planner, seeding.time_limit, in_time)
            chosen = search.best(part(in_time, 0.2, 0.9))
        limit.check_ending(search.ending)
    except OutOfTimeError:
        late = PartialPlan(robot=robot, scene=scene, status=Status.NOT_IN_TIME)
        failed(late, True, limit.missed("program"))
    if chosen is None:
        reasons = "; ".join(dict.fromkeys(search.failures[-3:])) or "no program is possible"
        raise PlanningError(f"no program was found: {reasons}")
    items = list(_items(legs, chosen, first))
    if not any(isinstance(each, RawMotion) for each in items):
        raise InvalidInputError("steps", [type(each).__name__ for each in steps], "steps with at least one motion")
    notify(0.9, "timing and checking")
    program = assemble(
        items,
        first,
        chosen.along[-1].state,
        steps,
        {leg.number: leg for leg in legs},
        goals={leg.number: search.nodes[k][chosen.nodes[k]].goal_index for k, leg in enumerate(legs) if leg.targets},
        blend=blend,
        objective=objective,
        clearance=clearance,
        torque=torque,
    )
    first_part, *others = program.parts
    taken = (*taken_to_limits(robot, "start", given), *first_part.report.taken_to_limits)
    first_part = replace(first_part, report=replace(first_part.report, taken_to_limits=taken))
    program = replace(program, parts=(first_part, *others))
    if not program.passed:
        raise PlanningError(f"the program did not pass its check\n{program}", program)
    notify(1.0, "done")
    return program


def _search(
    legs: list[Leg],
    first: State,
    q_start: Array,
    planners: ToolPathPlanners,
    planner: Planner,
    seconds: float,
    notify: Progress,
) -> ProgramSearch:
    """The search for a program of these legs, with the configurations of each; each free motion may take some seconds."""
    nodes: list[list[Node]] = []
    known, needed = first, needed_by(legs)
    part_poses = [PartPoses.at_first(first.robot, first.scene, needed[0])]
    for k, leg in enumerate(legs):
        notify(0.2 * k / len(legs), f"configurations of step {leg.number}")
        nodes.append(nodes_of(leg, known, q_start, planners, part_poses, needed[k + 1]))
        known, part_poses = _known_after(leg, known), part_poses_after(nodes[-1])
    return ProgramSearch(
        legs=legs,
        nodes=nodes,
        start=q_start,
        state=first,
        planners=planners,
        planner=planner,
        deadline=work_time() + seconds * max(sum(each.is_free for each in legs), 1),
    )


def _planner(objective: PathObjective, shape: PathShape, seeding: Seeding, clearance: float, torque: bool) -> Planner:
    def plan_leg(leg: Leg, q: Array, entry: Array, state: State, seconds: float) -> PathResult | Failure:
        try:
            found = find_path(
                state.robot,
                q,
                entry,
                state.scene,
                constraints=leg.constraints.constraints,
                objective=objective,
                shape=shape,
                seeding=replace(seeding, time_limit=min(seeding.time_limit, seconds / seeding.count)),
                clearance=clearance,
            ).draft
            if found.result is None:
                return Failure(message=found.message)
            if torque:  # there may be no motion on a path
                retime(found.result.path, state.robot, torque=True)
        except (InvalidInputError, PlanningError) as error:
            return Failure(message=str(error))
        return found.result

    return plan_leg


def _known_after(leg: Leg, state: State) -> State:
    """What is known of arm and scene after a leg before its configurations are: parts of a given pose, and gone obstacles."""
    for _, step in leg.rest:
        if isinstance(step, Attach) and isinstance(step.part, str):
            if step.part in state.scene.names:  # one that was put down is not
                state = replace(state, scene=state.scene.without(step.part))
        elif isinstance(step, Attach):
            state = state.after(step, state.robot.neutral)
        elif isinstance(step, Detach) and step.name in state.robot.carried:
            state = replace(state, robot=state.robot.detach(step.name))
    return state


def _items(legs: Sequence[Leg], chosen: Chosen, state: State) -> Iterator[RawMotion | Stop]:
    """All motions and stops of a program in their order, from the first state on."""
    for leg, free, motion in zip(legs, chosen.free, chosen.along, strict=True):
        if free is not None:
            yield RawMotion(step=leg.number, path=free.path, state=state)
        yield from motion.items
        state = motion.state
