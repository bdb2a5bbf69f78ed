"""other_goals: other configurations of a goal's pose, and the best path found to each."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.cost.crossings import least_crossings
from manipplan.cost.objective import PathObjective
from manipplan.ik.solutions import inverse_kinematics
from manipplan.optimize.optimize import optimize_path
from manipplan.optimize.result import PathResult
from manipplan.paths.basis import PathShape
from manipplan.robots.robot import Robot
from manipplan.seeds.seeding import Seeding
from manipplan.support.checks import Array, instance, number, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.progress import Progress, part, teller
from manipplan.support.status import Status
from manipplan.support.tolerances import SAME


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class OtherGoal:
    """A configuration that reaches the pose of a goal.

    Attributes:
        q: (n,) [rad or m].
        least_crossings: lower bound on the singularities that any path to it crosses; None for redundant arms.
        result: the path to it.
    """

    q: Array
    least_crossings: int | None
    result: PathResult

    @property
    def g(self) -> float:
        """g of the path to it."""
        return self.result.g

    def __str__(self) -> str:
        crossings = sum(not each.at_end for each in self.result.certificate.crossings) if self.result.certificate else 0
        count = "no singularity" if crossings == 0 else f"{crossings} singularit{'y' if crossings == 1 else 'ies'}"
        status = "" if self.result.status in (Status.OPTIMAL, Status.SHORTEST) else f", {self.result.status.name}"
        return f"g {self.g:.5g}, crosses {count}{status}: {self.q.round(9).tolist()}"


def other_goals(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    objective: PathObjective = PathObjective(),
    shape: PathShape = PathShape(),
    seeding: Seeding = Seeding(),
    constraints: Sequence[Constraint] = (),
    clearance: float = 0.0,
    most: int = 4,
    progress: Progress | None = None,
) -> tuple[OtherGoal, ...]:
    """Other configurations of the goal's pose with the best path found to each: a remedy where a path crosses singularities.

    Of the solutions of inverse kinematics that are inside the limits and collision-free, paths are optimised to those that need
    the fewest crossings and are nearest to the start. Of configurations that differ by full turns only the nearest counts.

    Args:
        robot: the arm.
        start, goal: (n,) [rad or m].
        scene: obstacles; None: nothing is checked for collision.
        objective, shape: what the paths minimise, and their degree and basis.
        seeding: how first paths are found; without `initial` and `shifts`.
        constraints: what every configuration keeps, as in `plan`; they need a scene.
        clearance: minimum distance [m] to keep; needs a scene.
        most: maximum number of configurations that are tried. Each takes as long as `optimize_path`.
        progress: called with the fraction done in [0, 1] and a text.

    Returns:
        The configurations to which a path was found, with a scene a collision-free one, that of the smallest g first; empty
        where there is none.

    Raises:
        InvalidInputError: as in `optimize_path` and `inverse_kinematics`.
    """
    instance("robot", robot, Robot)
    instance("objective", objective, PathObjective)
    if instance("seeding", seeding, Seeding).initial is not None or seeding.shifts != "none":
        raise InvalidInputError("seeding", seeding, "one without `initial` and `shifts`")
    q_start, q_goal = robot.configuration("start", start), robot.configuration("goal", goal)
    clearance, most = number("clearance", clearance, least=0.0), whole_number("most", most, least=1)
    tell = teller(progress)
    tell(0.0, "solving the inverse kinematics")
    solutions = inverse_kinematics(robot, robot.kinematics().pose(q_goal)).q
    solutions = _nearest_turns(robot, q_start, solutions[np.abs(solutions - q_goal).max(axis=1) > SAME])
    solutions = solutions[np.abs(solutions - q_start).max(axis=1) >= SAME]
    if scene is not None:
        model = instance("scene", scene, Scene).collision_model(robot)
        least = np.array([model.least_distance(q[None])[0] for q in solutions])
        solutions = solutions[(least > 0) & (least >= clearance)]
    kept = ConstraintSet.of(robot, constraints)
    solutions = np.array([q for q in solutions if not (kept.broken(q) or kept.moved(q_start, q))]).reshape(-1, robot.n)
    kinematics = objective.kinematics(robot)
    needed = [least_crossings(kinematics, q_start, q) for q in solutions]
    distance = np.linalg.norm(solutions - q_start, axis=1)
    order = sorted(range(len(solutions)), key=lambda k: (needed[k] or 0, distance[k]))[:most]
    found = []
    for done, k in enumerate(order):
        result = optimize_path(
            robot,
            q_start,
            solutions[k],
            scene,
            objective=objective,
            shape=shape,
            seeding=seeding,
            constraints=kept.constraints,
            clearance=clearance,
            throw=False,
            progress=part(tell, done / len(order), (done + 1) / len(order)),
        )
        if result.status is Status.INTERRUPTED:
            raise KeyboardInterrupt
        if isinstance(result, PathResult):
            found.append(OtherGoal(q=solutions[k], least_crossings=needed[k], result=result))
    return tuple(sorted(found, key=lambda each: each.g))


def _nearest_turns(robot: Robot, start: Array, solutions: Array) -> Array:
    """Of configurations (k, n) that differ by full turns, the one nearest to the start (n,)."""
    turns = robot.turns
    kept: list[Array] = []
    for q in solutions[np.argsort(np.linalg.norm(solutions - start, axis=1), kind="stable")]:
        apart = [q - other for other in kept]
        apart = [np.where(turns, each - 2 * np.pi * np.round(each / (2 * np.pi)), each) for each in apart]
        if not any(np.abs(each).max() <= SAME for each in apart):
            kept.append(q)
    return np.array(kept).reshape(-1, robot.n)
