"""The motion of both arms that hold an object: one arm has its best motion, and the other one keeps free of it.

LoneArm: one of several arms without the others, and the motion of its tool along a path in view of theirs.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import permutations

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.ik.newton import MovingArm
from manipplan.ik.solver import Solver
from manipplan.jobs.carrying.request import Request
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath, side_by_side
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.arms import arm_of, own_joints
from manipplan.robots.attached import without_bodies
from manipplan.robots.robot import Robot
from manipplan.search.layers import SPARE_CLEARANCE, STRIDE, Layers
from manipplan.search.max_min import max_min_search
from manipplan.search.program import PoseRows, joint_path
from manipplan.search.refine import refine
from manipplan.search.sampling import default_samples, sample_layers
from manipplan.seeds.task import CHECK_STEP
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, part

#: Maximum number of steps from one position to the next, and error at which a pose counts as reached [m, rad].
STEPS, EXACT = 100, 1e-10


@dataclass(frozen=True, kw_only=True, eq=False)
class LoneArm:
    """The joints that move one tool alone, the path of this tool, and all configurations at its positions.

    Attributes:
        tool: the tool frame.
        joints: indices of the joints among those of the robot.
        path: of the tool.
        layers: configurations of these joints; those in collision with what stands still or moves with this tool are left out.
        epsilon: (k,) maximum step of these joints between positions [rad or m].
        tolerance: of the tool on its path.
        hold_start: whether the motion begins in the one configuration of the first position.
    """

    tool: str
    joints: list[int]
    path: CartesianPath
    layers: Layers
    epsilon: Array
    tolerance: Tolerance
    hold_start: bool = False

    def starting_at(self, q: Array) -> "LoneArm":
        """The same with q (k,) as only configuration at the first position, at the pose that it reaches.

        Where steps from one position to the next lead from it is added to the configurations of the others.
        """
        sampler, poses = self.layers.sampler, self.layers.poses
        assert sampler is not None and sampler.collision is not None and poses is not None
        steps = self._onwards(q, poses[1:])
        free = ~sampler.collision.in_collision_rows(steps, clearance=sampler.spec.clearance)
        layers, m = [np.array(q[None]), *self.layers.q[1:]], [sampler.kinematics.manipulability(q[None]), *self.layers.m[1:]]
        for k in np.flatnonzero(free):
            layers[k + 1] = np.vstack([layers[k + 1], steps[k]])
            m[k + 1] = np.append(m[k + 1], sampler.kinematics.manipulability(steps[k]))
        poses = np.concatenate([sampler.solver.kinematics.pose(q[None]), poses[1:]])
        return replace(self, layers=replace(self.layers, q=tuple(layers), m=tuple(m), poses=poses), hold_start=True)

    def _onwards(self, q: Array, poses: Array) -> Array:
        """Configurations (j, k) at poses (p, 4, 4), the first by steps from q, each other from the one before."""
        sampler, found = self.layers.sampler, [np.zeros((0, len(q)))]
        assert sampler is not None
        limits = sampler.spec.robot.limits
        arm = MovingArm(sampler.solver.screws, np.ones(len(q), dtype=np.bool_))
        for pose in poses:
            moved, miss = arm.search(q[None], pose, limits.lower, limits.upper, steps=STEPS, tolerance=EXACT)
            if miss[0] > EXACT:
                break
            q = moved[0]
            found.append(moved)
        return np.concatenate(found)

    def beside(self, model: CollisionModel, q: Array, clearance: float) -> "LoneArm":
        """The arm with only the configurations that are free where the robot's other joints are as in q (L, n).

        Raises PlanningError, which names the position, where there is none.
        """
        kept, m = [], []
        for k, (own, values) in enumerate(zip(self.layers.q, self.layers.m, strict=True)):
            whole = np.repeat(q[k : k + 1], len(own), axis=0)
            whole[:, self.joints] = own
            free = ~model.in_collision_rows(whole, clearance=clearance)
            if not free.any():
                bodies, _ = model.nearest_bodies(whole)
                wanted = f"at position {k} of {len(q)} every configuration of {self.tool} is in the way of the other arms"
                raise PlanningError(f"{wanted}: {bodies}")
            kept.append(np.ascontiguousarray(own[free]))
            m.append(values[free])
        return replace(self, layers=replace(self.layers, q=tuple(kept), m=tuple(m)))

    def courses(self) -> tuple[JointPath, JointPath]:
        """The joint path of the largest minimum manipulability, refined, and the one that was searched.

        Raises PlanningError where no continuous path leads through the configurations.
        """
        layers = self.layers
        found = max_min_search(layers, self.epsilon, throw=False)
        if not found.connected:
            raise PlanningError(f"{self.tool}: {found.message}")
        refined = refine(layers, found, hold_start=self.hold_start)
        return self._joined(refined.q), self._joined(found.q)

    def _joined(self, q: Array) -> JointPath:
        sampler, s = self.layers.sampler, self.layers.s
        assert sampler is not None and s is not None
        rows = PoseRows(sampler.kinematics)
        return joint_path(sampler.solver, rows, self.path, s, q, closed=False, allowed=rows.box(self.tolerance))


def lone_robot(robot: Robot, tool: str, joints: list[int], posture: Array) -> Robot:
    """The arm of some joints of one tool, with the others locked at `posture` (n,) and without the bodies of other arms."""
    others = {i for i in range(robot.n) if i not in robot.joints_of(tool)}
    away = [item.name for item in robot.geometry.geometryObjects if robot.model.joints[item.parentJoint].idx_q in others]
    arm = arm_of(robot, tool, joints, posture)
    return replace(arm, geometry=without_bodies(arm.geometry, away), source=None)


#: Number of places at which the nearest bodies are looked for.
PROXIMITY_SAMPLES = 401
#: How many times as many samples are taken where those of the default do not connect.
FINER = 4


def motion_of_both(request: Request, notify: Progress) -> tuple[JointPath, JointPath]:
    """The joint path of the whole robot, and the same as searched; where nothing connects, with closer positions and samples.

    Raises PlanningError with the reason, and InvalidInputError for a position that a tool cannot reach.
    """
    if request.positions is not None and request.samples is not None:
        return _tried(request, notify, finer=False)
    try:
        return _tried(request, part(notify, 0.0, 0.5), finer=False)
    except PlanningError as first:
        try:
            return _tried(request, part(notify, 0.5, 1.0), finer=True)
        except InvalidInputError as error:  # the positions and samples are not the caller's
            raise first from error


def _tried(request: Request, notify: Progress, *, finer: bool) -> tuple[JointPath, JointPath]:
    """The same with the default positions and samples, or finer ones."""
    arms = _arms(request, part(notify, 0.0, 0.8), finer=finer)
    notify(0.8, "searching for motions of the arms")
    return _motion(request, arms)


def _arms(request: Request, notify: Progress, *, finer: bool) -> list[LoneArm]:
    """Both arms with all their configurations at the positions."""
    arms, robot = [], request.robot
    s = request.at(STRIDE / 2 if finer else STRIDE)
    for k, tool in enumerate(request.grasps):
        joints = own_joints(robot, tool)
        lone = lone_robot(robot, tool, joints, request.still)
        try:
            layers = sample_layers(
                lone,
                request.way(tool),
                s,
                measure=request.integral.kinematics.measure.of_one_tool(),
                task=request.integral.kinematics.task,
                samples=request.samples if request.samples is not None else _count(lone) * (FINER if finer else 1),
                scene=request.scene,
                clearance=request.clearance,
                spare=SPARE_CLEARANCE,
                seed=request.seed,
                progress=part(notify, k / len(request.grasps), (k + 1) / len(request.grasps)),
            )
        except InvalidInputError as error:
            argument = error.argument if error.argument == "samples" else f"{tool}: {error.argument}"
            raise InvalidInputError(argument, error.value, error.allowed) from error
        layers = layers.inside(lone.limits)
        arm = LoneArm(
            tool=tool,
            joints=joints,
            path=request.way(tool),
            layers=layers,
            epsilon=request.epsilon[joints],
            tolerance=request.own_tolerance,
        )
        arms.append(arm if request.start is None else arm.starting_at(request.start[joints]))
    return arms


def _count(lone: Robot) -> int:
    """Default number of samples per parameter of redundancy."""
    solver = Solver.of(lone, task=None, held=None, method="auto", seed=0)
    usual = default_samples(solver)
    return usual[min(max(len(solver.names), 1), len(usual)) - 1]


def _motion(request: Request, arms: Sequence[LoneArm]) -> tuple[JointPath, JointPath]:
    """The motion of the first order of the arms that gives one; raises PlanningError with the reasons where none does."""
    reasons = []
    for lead, follow in permutations(arms):
        try:
            return _in_order(request, lead, follow)
        except PlanningError as error:
            reasons.append(f"{lead.tool} leads: {error}")
    raise PlanningError("; ".join(reasons))


def _in_order(request: Request, lead: LoneArm, follow: LoneArm) -> tuple[JointPath, JointPath]:
    model, s, still = request.scene.collision_model(request.robot), lead.layers.s, request.still
    assert s is not None
    refined, searched = lead.courses()
    q = np.tile(still, (len(s), 1))
    q[:, lead.joints] = refined(s)
    beside = follow.beside(model, q, request.clearance + SPARE_CLEARANCE)
    refined_beside, searched_beside = beside.courses()
    seed = side_by_side([(searched, lead.joints), (searched_beside, follow.joints)], still)
    for own in (refined_beside, searched_beside):  # what is refined knows nothing of the other arm
        joint = side_by_side([(refined, lead.joints), (own, follow.joints)], still)
        if model.path_is_free(joint, CHECK_STEP, request.clearance):
            return joint, seed
    bodies, _ = model.nearest_bodies(joint(np.linspace(0.0, 1.0, PROXIMITY_SAMPLES)))
    raise PlanningError(f"between the positions {bodies}; take more positions")
