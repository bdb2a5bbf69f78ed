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
from manipplan.jobs.following.course import ToolPathPlanner
from manipplan.jobs.plan import plan
from manipplan.jobs.result import Plan
from manipplan.measures.measure import Measure
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory, joined
from manipplan.robots.arms import has_few_joints
from manipplan.robots.robot import Robot
from manipplan.search.max_min import max_min_search
from manipplan.search.sampling import default_samples, sample_layers
from manipplan.seeds.seeding import Seeding
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, silent
from manipplan.symbolic.task import Task
from manipplan.timing.retime import retime

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


def straight_finder(
    robot: Robot,
    scene: Scene,
    path: CartesianPath,
    *,
    measure: Measure | str | None,
    clearance: float,
    task: Task | None = None,
    tolerance: Tolerance | None = None,
) -> ToolPathPlanner:
    """The finder of motions along a straight path; raises InvalidInputError for a position that is out of reach or not free."""
    count = max(FEWEST, int(np.ceil(path.length / STRIDE - 1e-6)))  # without the rounding of a length
    solver = Solver.of(robot, task=task, held=None, method="auto", seed=0)
    names, usual = len(solver.names), default_samples(solver)
    samples = min(SAMPLES, usual[max(names, 1) - 1]) if names < 3 else None
    layers = sample_layers(robot, path, count, task=task, measure=measure, samples=samples, scene=scene, clearance=clearance)
    return ToolPathPlanner(path=path, layers=layers, tolerance=tolerance)


def motion_from(finder: ToolPathPlanner, q: Array, robot: Robot, epsilon: float) -> JointPath | str:
    """The best motion along a path that begins at q (n,) and stays inside the limits, or why there is none."""
    beginning = finder.starting_at(q)
    found = max_min_search(beginning.layers, epsilon, explain=False, throw=False)
    if not found.connected:
        return found.message
    path = beginning.along(found, silent, hold_start=True).path
    return outside_limits(path, robot) or path


def outside_limits(path: JointPath, robot: Robot) -> str:
    """Which joint of a path leaves its limits between the positions that were searched; "" where none does."""
    outside = robot.limits.outside(np.array(path.bounds())).max(axis=0)
    joint = int(outside.argmax())
    return f"{robot.joint_names[joint]} is {outside[joint]:.2g} outside its limits" if outside[joint] > 0 else ""


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


#: Plans a transit to a configuration (n,) within a time [s]; a text tells why there is none.
PlanTransit = Callable[[Array, float, Progress], Transit | str]


@dataclass(frozen=True, kw_only=True, eq=False)
class TransitPlanner:
    """What transits of one job share.

    Attributes:
        robot, scene: the arm among its obstacles.
        integral: of the g and the manipulability that count.
        objective: the same as an objective.
        clearance: distance to keep [m].
        torque: whether the joints' effort limits are kept.
        seed: of the planner of free motions.
    """

    robot: Robot
    scene: Scene
    integral: PathIntegral
    objective: PathObjective
    clearance: float
    torque: bool
    seed: int

    def lead_in(self, start: Array) -> PlanTransit:
        """The planner of free motions from a start (n,)."""

        def planned(goal: Array, seconds: float, notify: Progress) -> Transit | str:
            made = self._free(start, goal, seconds, notify)
            return made if isinstance(made, str) else self._of([made.path], [made.trajectory])

        return planned

    def between(self, begin: Array, way: Array) -> PlanTransit | str:
        """The planner of motions off the path and onto it again, from a configuration (n,) on the path; or why there is none.

        The tool leaves the path and comes back along the straight `way` (3,) in its frame [m]; zeros: freely.
        """
        if not way.any():
            return self.lead_in(begin)
        off = self._straight(begin, way)
        if isinstance(off, str):
            return f"no straight retreat from the path: {off}"

        def planned(goal: Array, seconds: float, notify: Progress) -> Transit | str:
            on = self._straight(goal, way)
            if isinstance(on, str):
                return f"no straight way back onto the path: {on}"
            back = on.backwards()
            middle = self._free(off.goal, back.start, seconds, notify)
            if isinstance(middle, str):
                return middle
            try:
                timed = [retime(each, self.robot, torque=self.torque) for each in (off, back)]
            except PlanningError as error:
                return f"the straight way cannot be timed: {error}"
            return self._of([off, middle.path, back], [timed[0], middle.trajectory, timed[1]])

        return planned

    def _straight(self, q: Array, way: Array) -> JointPath | str:
        """The best motion from q (n,) on which the tool moves straight by `way` (3,) in its frame, or why there is none.

        The tool keeps its orientation; that of an arm with too few joints for that keeps what counts on the path.
        """
        path = straight_on(self.robot.kinematics(Task.pose()).pose(q), way)
        try:
            finder = straight_finder(
                self.robot,
                self.scene,
                path,
                measure=self.objective.measure,
                clearance=self.clearance,
                task=self.objective.task if has_few_joints(self.robot) else None,
            )
        except InvalidInputError as error:
            return f"{error.argument} is not {error.allowed}"
        return motion_from(finder, q, self.robot, STRAIGHT_EPSILON)

    def _free(self, begin: Array, goal: Array, seconds: float, notify: Progress) -> Plan | str:
        made = plan(
            self.robot,
            begin,
            goal,
            self.scene,
            objective=self.objective,
            seeding=Seeding(seed=self.seed, time_limit=seconds),
            clearance=self.clearance,
            torque=self.torque,
            throw=False,
            progress=notify,
        )
        return made if isinstance(made, Plan) and made.status.has_path else made.message

    def _of(self, paths: list[JointPath], motions: list[Trajectory]) -> Transit:
        path, trajectory = JointPath.joined(paths), joined(motions)
        cost = self.integral.cost(path)
        return Transit(path=path, trajectory=trajectory, min_manipulability=cost.min_manipulability, g=cost.g)
