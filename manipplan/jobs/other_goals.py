"""other_goals: other configurations of a goal's pose, and the best path found to each."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.collision.scene import Scene
from manipplan.cost.crossings import least_crossings
from manipplan.cost.objective import PathObjective
from manipplan.ik.solutions import inverse_kinematics
from manipplan.optimize.optimize import optimize_path
from manipplan.optimize.result import PathResult
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance, number, whole_number
from manipplan.support.display import one_line
from manipplan.support.progress import Progress, part, teller

#: Configurations are the same when no joint differs by more than this [rad or m].
SAME = 1e-6


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
        return f"g {self.g:.5g}, crosses {count}: {self.q.round(4).tolist()}"


def other_goals(
    robot: Robot,
    start: ArrayLike,
    goal: ArrayLike,
    scene: Scene | None = None,
    *,
    objective: PathObjective = PathObjective(),
    clearance: float = 0.0,
    most: int = 4,
    progress: Progress | None = None,
) -> tuple[OtherGoal, ...]:
    """Other configurations of the goal's pose with the best path found to each: a remedy where a path crosses singularities.

    Of the solutions of inverse kinematics that are inside the limits and collision-free, paths are optimised to those that need
    the fewest crossings and are nearest to the start.

    Args:
        robot: the arm.
        start, goal: (n,) [rad or m].
        scene: obstacles; None: nothing is checked for collision.
        objective: what the paths minimise.
        clearance: minimum distance [m] to keep; needs a scene.
        most: maximum number of configurations that are tried. Each takes as long as `optimize_path`.
        progress: called with the fraction done in [0, 1] and a text.

    Returns:
        The configurations to which a collision-free path was found, that of the smallest g first; empty where there is none.

    Raises:
        InvalidInputError: as in `optimize_path` and `inverse_kinematics`.
    """
    instance("robot", robot, Robot)
    instance("objective", objective, PathObjective)
    q_start, q_goal = robot.configuration("start", start), robot.configuration("goal", goal)
    clearance, most = number("clearance", clearance, least=0.0), whole_number("most", most, least=1)
    tell = teller(progress)
    tell(0.0, "solving the inverse kinematics")
    solutions = inverse_kinematics(robot, robot.kinematics().pose(q_goal)).q
    solutions = solutions[np.abs(solutions - q_goal).max(axis=1) > SAME]
    if scene is not None and len(solutions):
        model = instance("scene", scene, Scene).collision_model(robot)
        solutions = solutions[[not model.in_collision(q, clearance=clearance) for q in solutions]]
    kinematics = objective.resolved(robot).integral(robot).kinematics
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
            clearance=clearance,
            throw=False,
            progress=part(tell, done / len(order), (done + 1) / len(order)),
        )
        if isinstance(result, PathResult):
            found.append(OtherGoal(q=solutions[k], least_crossings=needed[k], result=result))
    return tuple(sorted(found, key=lambda each: each.g))
