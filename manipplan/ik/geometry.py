"""An arm as a product of exponentials."""

from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

#: Axes that miss a point by less than this meet in it [m]; directions that differ by less are parallel. Descriptions round
#: angles to 1e-5 or better; solutions are refined on the arm as described.
MEETS = 1e-5
#: Deviation below which a closed form fits an arm exactly, up to rounding.
EXACT = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class Screws:
    """T(q) = e^[ξ_1] q_1 ... e^[ξ_n] q_n T(0): the joint axes at q = 0.

    Attributes:
        axes: (n, 3) unit directions.
        points: (n, 3) a point on each axis [m].
        slides: (n,) whether each joint is prismatic.
        home: (4, 4) the tool's pose at q = 0.
    """

    axes: Array
    points: Array
    slides: NDArray[np.bool_]
    home: Array

    @classmethod
    def of(cls, robot: Robot) -> "Screws":
        """The screws of a robot."""
        data = robot.model.createData()
        frame = frame_index(robot.model, robot.tool)
        pin.forwardKinematics(robot.model, data, pin.neutral(robot.model))
        pin.updateFramePlacements(robot.model, data)
        pin.computeJointJacobians(robot.model, data, pin.neutral(robot.model))
        twists = pin.getFrameJacobian(robot.model, data, frame, pin.WORLD).reshape(6, -1)  # it is flat for one joint
        slides = np.array([kind == "prismatic" for kind in robot.joint_types])
        axes = np.where(slides, twists[:3], twists[3:]).T
        points = np.where(slides[:, None], 0.0, np.cross(twists[3:].T, twists[:3].T))
        home = data.oMf[frame].homogeneous
        return cls(axes=np.ascontiguousarray(axes), points=points, slides=slides, home=home)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.axes)

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
