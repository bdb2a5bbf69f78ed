"""An arm as a product of exponentials."""

from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.robots.model_tree import Mimic, frame_index, joint_tree
from manipplan.robots.robot import Robot
from manipplan.robots.subchain import uncouple
from manipplan.support.checks import Array

#: Axes that miss a point by less than this meet in it [m]; directions that differ by less are parallel. Descriptions round
#: angles to 1e-5 or better; solutions are refined on the arm as described.
MEETS = 1e-5
#: Deviation below which a closed form fits an arm exactly, up to rounding.
EXACT = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class Screws:
    """T(q) = e^[ξ_1] q_1 ... e^[ξ_n] q_n T(0): the joint axes at q = 0.

    Where joints that carry the tool follow others, the axes are those of all N that carry it, from base to tool, at position 0.

    Attributes:
        n: number of joints that follow no other.
        axes: (N, 3) unit directions.
        points: (N, 3) a point on each axis [m].
        slides: (N,) whether each joint is prismatic.
        home: (4, 4) the tool's pose at position 0 of all joints.
        follow: the entry of q (n,), the ratio and the offset of each joint, (N,) each, which is at ratio * q + offset; None
            where none of them follows another and N = n.
    """

    n: int
    axes: Array
    points: Array
    slides: NDArray[np.bool_]
    home: Array
    follow: tuple[NDArray[np.int64], Array, Array] | None = None

    @classmethod
    def of(cls, robot: Robot) -> "Screws":
        """The screws of a robot."""
        model, _, followers = uncouple(robot.model, pin.GeometryModel())
        data, frame = model.createData(), frame_index(model, robot.tool)
        pin.forwardKinematics(model, data, pin.neutral(model))
        pin.updateFramePlacements(model, data)
        pin.computeJointJacobians(model, data, pin.neutral(model))
        twists = pin.getFrameJacobian(model, data, frame, pin.WORLD).reshape(6, -1)  # it is flat for one joint
        slides, follow = joint_tree(model).slides, None
        if followers:
            links = np.array(list(model.supports[model.frames[frame].parentJoint])[1:], dtype=np.int64)
            named = [
                followers.get(name, Mimic(leader=name, multiplier=1.0, offset=0.0)) for name in np.array(model.names)[links]
            ]
            leader = np.array([robot.joint_names.index(each.leader) for each in named], dtype=np.int64)
            ratio, offset = np.array([each.multiplier for each in named]), np.array([each.offset for each in named])
            if len(leader) != robot.n or (leader != np.arange(robot.n)).any() or (ratio != 1.0).any() or offset.any():
                follow = leader, ratio, offset
            twists, slides = twists[:, links - 1], slides[links - 1]
        axes = np.where(slides, twists[:3], twists[3:]).T
        points = np.where(slides[:, None], 0.0, np.cross(twists[3:].T, twists[:3].T))
        home = data.oMf[frame].homogeneous
        return cls(n=robot.n, axes=np.ascontiguousarray(axes), points=points, slides=slides, home=home, follow=follow)

    def meeting_point(self, joints: tuple[int, ...]) -> tuple[Array, float] | None:
        """The point (3,) where all these axes meet, and their largest distance from it [m]; None where there is none."""
        if self.slides[list(joints)].any():
            return None
        across = [np.eye(3) - np.outer(h, h) for h in self.axes[list(joints)]]
        total = sum(across)
        if np.linalg.matrix_rank(total, tol=1e-6) < 3:
            return None
        point = np.linalg.solve(total, sum(a @ p for a, p in zip(across, self.points[list(joints)], strict=True)))
        miss = max(np.linalg.norm(a @ (point - p)) for a, p in zip(across, self.points[list(joints)], strict=True))
        return (np.asarray(point), float(miss)) if miss < MEETS else None

    def askew(self, *joints: int) -> float:
        """The largest sine of the angle between the first of these axes and another; inf if any joint is prismatic."""
        if self.slides[list(joints)].any():
            return float("inf")
        first = self.axes[joints[0]]
        return max(float(np.linalg.norm(np.cross(first, self.axes[k]))) for k in joints[1:])
