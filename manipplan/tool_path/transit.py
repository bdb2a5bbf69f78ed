"""Transits: free motions of the arm to where the tool comes onto the path, with straight ways off the path and onto it.

Straight ways of the tool: the path, how densely it is searched, and the best motion along it from a configuration.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import PathObjective
from manipplan.ik.solver import Solver
from manipplan.measures.measure import Measure
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.robots.arms import has_few_joints
from manipplan.robots.robot import Robot
from manipplan.search.sampling import default_samples, sample_layers
from manipplan.support.checks import COINCIDENT, Array
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress
from manipplan.support.status import Failure
from manipplan.symbolic.task import Task
from manipplan.timing.retime import retime
from manipplan.tool_path.engine import ToolPathPlanner

#: Maximum step of a joint between neighbouring positions of a straight way [rad or m].
STRAIGHT_EPSILON = 0.4
#: Distance between positions on a straight way [m], their smallest number, and the largest number of samples per parameter.
STRIDE, FEWEST, SAMPLES = 0.015, 6, 144


def moved_by(way: Array) -> Array:
    """The pose (4, 4) in the tool frame that is a way (3,) off [m]."""
    pose = np.eye(4)
    pose[:3, 3] = way
    return pose


def straight_on(pose: Array, way: Array) -> CartesianPath:
    """The straight path from a pose (4, 4) by a way (3,) in the tool frame [m]."""
    return CartesianPath.line(pose, pose @ moved_by(way))


def straight_planner(
    robot: Robot,
    scene: Scene,
    path: CartesianPath,
    *,
    measure: Measure | str | None,
    clearance: float,
    task: Task | None = None,
    tolerance: Tolerance | None = None,
) -> ToolPathPlanner:
    """The planner of motions along a straight path; raises InvalidInputError for a position out of reach or not free."""
    count = max(FEWEST, int(np.ceil(path.length / STRIDE - 1e-6)))  # without the rounding of a length
    solver = Solver.of(robot, task=task, held=None, method="auto", seed=0)
    names, counts = len(solver.names), default_samples(solver)
    samples = min(SAMPLES, counts[max(names, 1) - 1]) if names < 3 and solver.free.bounds is None else None
    layers = sample_layers(robot, path, count, task=task, measure=measure, samples=samples, scene=scene, clearance=clearance)
    return ToolPathPlanner(path=path, layers=layers, tolerance=tolerance)


@dataclass(frozen=True, kw_only=True, eq=False)
class Transit:
    """A motion from where the arm stands to where the tool comes onto the path.

    Attributes:
        path, trajectory: the motion; it stops where a straight way begins or ends.
        min_manipulability, g: minimum manipulability on it, and its g.
    """

    path: JointPath
    trajectory: Trajectory
    min_manipulability: float
    g: float


#: Plans a free motion from one configuration (n,) to another within a time [s].
PlanFree = Callable[[Array, Array, float, Progress], tuple[JointPath, Trajectory] | Failure]
#: Plans a transit to a configuration (n,) within a time [s]; Failure tells why there is none.
PlanTransit = Callable[[Array, float, Progress], Transit | Failure]


@dataclass(frozen=True, kw_only=True, eq=False)
class TransitPlanner:
    """What transits of one job share.

    Attributes:
        robot, scene: the arm among its obstacles.
        integral: of the g and the manipulability that count.
        objective: the same as an objective.
        clearance: distance to keep [m].
        torque: whether the joints' effort limits are kept.
        plan_free: plans free motions.
        seconds: time limit of all transits that are tried to one part of the path [s].
    """

    robot: Robot
    scene: Scene
    integral: PathIntegral
    objective: PathObjective
    clearance: float
    torque: bool
    plan_free: PlanFree
    seconds: float

    def lead_in(self, start: Array) -> PlanTransit:
        """The planner of free motions from a start (n,)."""

        def plan_to(goal: Array, seconds: float, notify: Progress) -> Transit | Failure:
            made = self.plan_free(start, goal, seconds, notify)
            return made if isinstance(made, Failure) else self._of([made[0]], [made[1]])

        return plan_to

    def between(self, begin: Array, way: Array) -> PlanTransit | Failure:
        """The planner of motions off the path and onto it again, from a configuration (n,) on the path; or why there is none.

        The tool leaves the path and comes back along the straight `way` (3,) in its frame [m]; zeros: freely.
        """
        if not way.any():
            return self.lead_in(begin)
        off = self._straight(begin, way)
        if isinstance(off, Failure):
            return Failure(message=f"no straight retreat from the path: {off.message}")

        def plan_to(goal: Array, seconds: float, notify: Progress) -> Transit | Failure:
            on = self._straight(goal, way)
            if isinstance(on, Failure):
                return Failure(message=f"no straight way back onto the path: {on.message}")
            back, middle = on.backwards(), list[tuple[JointPath, Trajectory]]()
            if np.abs(off.goal - back.start).max() < COINCIDENT:  # the tool comes back from where it went to
                control = back.control.copy()
                control[0, 0] = off.goal
                back = JointPath(breaks=back.breaks, control=control)
            else:
                found = self.plan_free(off.goal, back.start, seconds, notify)
                if isinstance(found, Failure):
                    return found
                middle.append(found)
            try:
                timed = [retime(each, self.robot, torque=self.torque) for each in (off, back)]
            except PlanningError as error:
                return Failure(message=f"the straight way cannot be timed: {error}")
            return self._of([off, *(path for path, _ in middle), back], [timed[0], *(motion for _, motion in middle), timed[1]])

        return plan_to

    def _straight(self, q: Array, way: Array) -> JointPath | Failure:
        """The best motion from q (n,) on which the tool moves straight by `way` (3,) in its frame, or why there is none.

        The tool keeps its orientation; that of an arm with too few joints for that keeps what counts on the path.
        """
        path = straight_on(self.robot.kinematics(Task.pose()).pose(q), way)
        try:
            planner = straight_planner(
                self.robot,
                self.scene,
                path,
                measure=self.objective.measure,
                clearance=self.clearance,
                task=self.objective.task if has_few_joints(self.robot) else None,
            )
        except InvalidInputError as error:
            return Failure(message=f"{error.argument} is not {error.allowed}")
        return planner.best_from(q, STRAIGHT_EPSILON)

    def _of(self, paths: list[JointPath], motions: list[Trajectory]) -> Transit:
        path, trajectory = JointPath.joined(paths), joined(motions)
        cost = self.integral.cost(path)
        return Transit(path=path, trajectory=trajectory, min_manipulability=cost.min_manipulability, g=cost.g)
