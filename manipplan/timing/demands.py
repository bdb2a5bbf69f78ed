"""What motion along a path asks of the joints at each grid point, as rows that are linear in x = (dl/dt)² and u = d²l/dt².

Acceleration is t u + κ x with unit tangent t and curvature κ; torque is M t u + (M κ + C) x + g. Rows are divided by their
limit, so each has to stay in [-1, 1]. Lengths are shares of the piece's length and times are in units in which the largest
row of acceleration is one: tiny and huge paths look alike to what solves for x.
"""

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.support.checks import Array
from manipplan.timing.arc import ArcLength
from manipplan.timing.segment import Bounds, LimitsAlong, ToolSpeed

#: A grid point this near to the end of a segment is at it.
AT_EDGE = 1e-7
#: Stands for an infinite effort, which leaves rows of zeros.
NO_EFFORT = 1e12


@dataclass(frozen=True, kw_only=True, eq=False)
class Demands:
    """Rows at k grid points of a piece of path.

    Attributes:
        curve: the piece by arc length.
        length: (k,) grid points [rad or m].
        time_unit: [s]; the unit of length is the length of the piece.
        tangent, curvature: (k, n) in these units.
        bounds: limits at the grid points.
        fastest: (k,) greatest x by velocity and tool speed.
        u, x, constant: (k, r) rows: |u row · u + x row · x + constant| <= 1; n of acceleration, then n of torque, if asked.
    """

    curve: ArcLength
    length: Array
    time_unit: float
    tangent: Array
    curvature: Array
    bounds: Bounds
    fastest: Array
    u: Array
    x: Array
    constant: Array

    @property
    def at(self) -> Array:
        """Grid points as shares of the length (k,)."""
        return self.length / self.curve.length

    @property
    def speed_unit(self) -> float:
        """Unit of dl/dt [rad/s]."""
        return self.curve.length / self.time_unit

    def eased(self, velocity: Array, rows: Array) -> "Demands":
        """The same with stricter limits: each grid point's velocity and rows divided by factors (k,) >= 1."""
        values = {name: getattr(self, name) for name in ("curve", "length", "time_unit", "tangent", "curvature", "bounds")}
        # what is constant (gravity) is not scaled: the room beside it is
        room = 1 / rows[:, None]
        left = np.maximum(room - np.abs(self.constant), 1e-3 * (1 - np.abs(self.constant)))
        share = np.where(self.constant == 0, rows[:, None], (1 - np.abs(self.constant)) / left)
        return Demands(**values, fastest=self.fastest / velocity**2, u=self.u * share, x=self.x * share, constant=self.constant)


def demands(
    curve: ArcLength, length: Array, limits: LimitsAlong, torque_model: pin.Model | None, tool: ToolSpeed | None
) -> Demands:
    """The rows at the grid points `length` (k,) of a piece."""
    tangent, curvature = curve.tangent(length), curve.curvature(length)
    s = curve.s(length)
    bounds = limits.at(s, around=AT_EDGE)
    q = curve.path(s)
    time_unit = float(np.sqrt(curve.length * (np.abs(tangent) / bounds.acceleration).max()))
    with np.errstate(divide="ignore"):
        speed = (bounds.velocity / np.abs(tangent)).min(axis=1)
        if tool is not None:
            speed = np.minimum(speed, bounds.tool_speed / tool(q, tangent))
    u, x = tangent / bounds.acceleration, curvature / bounds.acceleration
    constant = np.zeros_like(u)
    if torque_model is not None:
        data, still = torque_model.createData(), np.zeros(torque_model.nv)
        rows = np.array(
            [
                [pin.rnea(torque_model, data, *state).copy() for state in ((a, still, still), (a, still, b), (a, b, c))]
                for a, b, c in zip(q, tangent, curvature, strict=True)
            ]
        )
        effort = np.minimum(bounds.effort, NO_EFFORT)
        gravity = rows[:, 0] / effort
        u, x = np.hstack([u, rows[:, 1] / effort - gravity]), np.hstack([x, rows[:, 2] / effort - gravity])
        constant = np.hstack([constant, gravity])
    size = curve.length
    return Demands(
        curve=curve,
        length=length,
        time_unit=time_unit,
        tangent=tangent * size,
        curvature=curvature * size**2,
        bounds=bounds,
        fastest=(speed * time_unit / size) ** 2,
        u=u * size / time_unit**2,
        x=x * size**2 / time_unit**2,
        constant=constant,
    )
