"""Problem: the arguments of one call of `plan`, to be planned together with others."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from typing import Any

from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.cost.integral import metric_matrix
from manipplan.cost.objective import PathObjective
from manipplan.goals.pose_goal import Goal
from manipplan.goals.read import named_configuration, read_goals
from manipplan.optimize.optimize import check_options
from manipplan.optimize.problem import initial_path
from manipplan.paths.basis import PathShape
from manipplan.robots.robot import Robot
from manipplan.robots.subchain import uncoupled
from manipplan.seeds.seeding import Seeding
from manipplan.support.checks import flag, instance, number
from manipplan.support.content import content_key
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_owner
from manipplan.timing.retime import check_timing_limits


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """One of the problems of `plan_many`: a robot, a start, a goal, obstacles, and the options of `plan`.

    Problems may share a robot and a scene, and should: each process then prepares them once. `plan_many` checks the values.

    Attributes:
        robot, start, goal, scene, constraints, objective, shape, seeding, clearance, torque: the arguments of `plan`.
        name: what the problem is called in messages and progress.
    """

    robot: Robot
    start: ArrayLike | str
    goal: Goal
    scene: Scene | None = None
    constraints: Sequence[Constraint] = ()
    objective: PathObjective = PathObjective()
    shape: PathShape = PathShape()
    seeding: Seeding = Seeding()
    clearance: float = 0.0
    torque: bool = False
    name: str = ""


def checked(argument: str, problem: Problem) -> Problem:
    """The problem with arrays and poses for start, goal and first path; raises InvalidInputError, which names `argument`.

    Whether robot and scene allow start, goal and first path is left to `plan`: it depends on values that are computed, and one
    such problem is no reason to plan none.
    """
    instance(argument, problem, Problem)
    with _inside(argument):
        robot, seeding = instance("robot", problem.robot, Robot), problem.seeding
        if problem.scene is not None:
            instance("scene", problem.scene, Scene)
        instance("name", problem.name, str)
        flag("torque", problem.torque)
        check_options(problem.objective, problem.shape, seeding)
        start = named_configuration("start", problem.start, robot)
        targets, is_list = read_goals("goal", problem.goal, robot)
        goals = [each.goal for each in targets]
        clearance = number("clearance", problem.clearance, least=0.0)
        check_timing_limits(robot.limits)
        problem.shape.ends(robot.n)
        metric_matrix("metric", problem.objective.metric, robot.n)
        problem.objective.kinematics(robot)
        constraints = ConstraintSet.of(robot, problem.constraints).constraints
        if seeding.initial is not None:
            seeding = replace(seeding, initial=initial_path(robot, seeding.initial))
        return replace(
            problem,
            start=start,
            goal=goals if is_list else goals[0],
            seeding=seeding,
            constraints=constraints,
            clearance=clearance,
        )


@contextmanager
def _inside(argument: str) -> Iterator[None]:
    """Errors of the block name the argument as a part of `argument`."""
    try:
        yield
    except InvalidInputError as error:
        raise InvalidInputError(f"{argument}.{error.argument}", error.value, error.allowed) from error


def options_of(problem: Problem) -> dict[str, Any]:
    """The options of `plan` that a problem holds, by name."""
    given = {each.name: getattr(problem, each.name) for each in fields(problem)}
    return {name: value for name, value in given.items() if name not in ("robot", "start", "goal", "scene", "name")}


def obstacles_of(problem: Problem) -> Scene:
    """The obstacles; an empty scene for None."""
    return problem.scene if problem.scene is not None else Scene()


def problem_key(problem: Problem) -> str:
    """What the result of a checked problem depends on, except for the version of this package, as a key."""
    return content_key(
        [robot_key(problem.robot), scene_key(obstacles_of(problem)), problem.start, problem.goal, options_of(problem)]
    )


@once_per_owner
def robot_key(robot: Robot) -> str:
    """The content of a robot as a key: all that plans depend on, not where it was read from."""
    model, geometry, followers = uncoupled(robot.model, robot.geometry)  # as it is pickled
    parts = {each.name: getattr(robot, each.name) for each in fields(robot) if each.name not in ("model", "geometry", "source")}
    bodies = [
        (body.name, body.parentJoint, body.parentFrame, body.placement, body.meshScale, body.geometry)
        for body in geometry.geometryObjects
    ]
    return content_key([parts, model, followers, bodies])


@once_per_owner
def scene_key(scene: Scene) -> str:
    """The content of a scene as a key."""
    return content_key([scene.obstacles, scene.names, scene.allowed])
