"""LoneArm: one of several arms without the others, and the motion of its tool along a path in view of theirs."""

from dataclasses import dataclass, replace

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.ik.newton import MovingArm
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.robots.arms import arm_of
from manipplan.robots.attached import without_bodies
from manipplan.robots.robot import Robot
from manipplan.search.candidates.layers import Layers
from manipplan.search.max_min import max_min_search
from manipplan.search.program import PoseRows, joint_path
from manipplan.search.refine import refine
from manipplan.support.checks import Array
from manipplan.support.errors import PlanningError

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
