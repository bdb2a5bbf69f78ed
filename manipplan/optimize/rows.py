"""Clearance rows: a point of the robot stays on its side of a plane, with exact derivatives of its distance."""

from dataclasses import dataclass

import casadi as ca
import numpy as np

from manipplan.checks import Array
from manipplan.kinematics.compile import as_asked
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.description import axis_of, is_prismatic


@dataclass(frozen=True, kw_only=True)
class ClearanceRow:
    """A point of the robot that has to stay on its side of a plane, at one place of the path.

    The plane is fixed in the frame of joint `other` (0: the world); row: normal · (point - plane) >= distance.

    Attributes:
        s: place on the path.
        joint, point: index of the joint that carries the point, and the point (3,) in its frame [m].
        other, normal, offset: index of the joint that carries the plane, its unit normal (3,) and offset [m] there.
        distance: to keep from the plane [m].
    """

    s: float
    joint: int
    point: Array
    other: int
    normal: Array
    offset: float
    distance: float

    def column(self, n: int) -> Array:
        """The row of a robot of n joints as numbers, (column_height(n),): what `row_functions` take."""
        carrier, other = np.eye(n + 1)[[self.joint, self.other]]
        return np.array([*carrier, *other, *self.point, *self.normal, self.offset, self.distance])


def column_height(n: int) -> int:
    """Numbers of a column: two joints one-hot, point, normal, offset and distance."""
    return 2 * (n + 1) + 8


def met_column(n: int) -> Array:
    """The column of a row that is always met: no normal and offset -1 m, so 0 >= -1."""
    return ClearanceRow(s=0.0, joint=0, point=np.zeros(3), other=0, normal=np.zeros(3), offset=-1.0, distance=0.0).column(n)


def row_functions(kinematics: Kinematics) -> tuple[ca.Function, ...]:
    """Signed distance of a clearance row [m], its gradient (n) and Hessian (n, n) in q, a Function each, compiled as asked.

    The second argument is a `ClearanceRow.column`. Only joints between the two move the point against the plane: sign σ_i is
    1 where joint i carries the point alone, -1 where it carries the plane alone. Then with c_i the velocity of the point as
    carried by joint i, ∂_i d = σ_i n · c_i, and for i <= j ∂_i ∂_j d = n · (z_i x c_j), or n · (z_j x c_i) for the plane.
    """
    chain, model = kinematics.symbolic.chain, kinematics.robot.model
    q, n = chain.q, kinematics.robot.n
    carrier, other = ca.SX.sym("carrier", n + 1), ca.SX.sym("other", n + 1)
    point, normal = ca.SX.sym("point", 3), ca.SX.sym("normal", 3)
    offset, keep = ca.SX.sym("offset"), ca.SX.sym("keep")
    position, plane_origin, plane_normal = ca.SX.zeros(3), ca.SX.zeros(3), ca.SX.zeros(3)
    for k, placement in enumerate(chain.joints):
        position += carrier[k] * (placement.origin + placement.rotation @ point)
        plane_origin += other[k] * placement.origin
        plane_normal += other[k] * (placement.rotation @ normal)
    distance = ca.dot(plane_normal, position - plane_origin) - offset - keep

    spin, velocity, sign = [], [], []
    for i in range(1, n + 1):
        axis = chain.joints[i].rotation @ ca.DM(axis_of(model.joints[i]))
        slides = is_prismatic(model.joints[i])
        spin.append(ca.SX.zeros(3) if slides else axis)
        velocity.append(axis if slides else ca.cross(axis, position - chain.joints[i].origin))
        sign.append(ca.sum1(carrier[i:]) - ca.sum1(other[i:]))
    gradient = ca.vertcat(*(sign[i] * ca.dot(plane_normal, velocity[i]) for i in range(n)))
    hessian = ca.SX.zeros(n, n)
    for j in range(n):
        for i in range(j + 1):
            both = sign[i] * sign[j] / 2
            bend = both * ca.dot(
                plane_normal,
                (1 + sign[i]) * ca.cross(spin[i], velocity[j]) + (1 - sign[i]) * ca.cross(spin[j], velocity[i]),
            )
            hessian[i, j] = hessian[j, i] = bend
    column = ca.vertcat(carrier, other, point, normal, offset, keep)
    functions = [
        ca.Function("path_row", [q, column], [distance]),
        ca.Function("path_row_gradient", [q, column], [ca.densify(gradient)]),
        ca.Function("path_row_hessian", [q, column], [ca.densify(hessian)]),
    ]
    return as_asked(functions, kinematics.compiled, f"clearance rows of paths of {kinematics.robot.name}")
