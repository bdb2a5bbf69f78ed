"""Demands of motion along a path on the joints, and tightening of limits where a motion exceeds them.

At each grid point the demands are rows that are linear in x = (dl/dt)² and u = d²l/dt². Acceleration is t u + κ x with unit
tangent t and curvature κ; torque is M t u + (M κ + C) x + g. Rows are divided by their limit, so each has to stay in [-1, 1].
Lengths are shares of the piece's length, and the unit of time makes the largest row of acceleration one, so that tiny and
huge paths give the solver the same problem.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.support.checks import Array
from manipplan.timing.arc import ArcLength
from manipplan.timing.stops import Bounds, LimitsAlong, ToolSpeed

#: Distance in s by which segments are extended, so that grid points at their ends are inside.
AT_EDGE = 1e-7
#: Effort limit used in place of an infinite one; it makes the torque rows practically zero.
NO_EFFORT = 1e12


@dataclass(frozen=True, kw_only=True, eq=False)
class PathDynamics:
    """Demand rows at k grid points of a piece of path.

    Attributes:
        curve: the piece as a function of its arc length.
        length: (k,) grid points [rad or m].
        time_unit: unit of time [s]; the unit of length is the length of the piece.
        tangent, curvature: (k, n) in these units.
        bounds: limits at the grid points.
        fastest: (k,) largest x within the limits of velocity and tool speed.
        u, x, constant: (k, r) rows: |u row · u + x row · x + constant| <= 1; n of acceleration, then n of torque with a
            torque model.
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

    def eased(self, velocity: Array, rows: Array) -> "PathDynamics":
        """A copy with tighter limits: velocity and rows are divided by factors (k,) >= 1 per grid point."""
        values = {name: getattr(self, name) for name in ("curve", "length", "time_unit", "tangent", "curvature", "bounds")}
        # the constant part (gravity) is not scaled, only the room that it leaves
        room = 1 / rows[:, None]
        left = np.maximum(room - np.abs(self.constant), 1e-3 * (1 - np.abs(self.constant)))
        share = np.where(self.constant == 0, rows[:, None], (1 - np.abs(self.constant)) / left)
        return PathDynamics(
            **values, fastest=self.fastest / velocity**2, u=self.u * share, x=self.x * share, constant=self.constant
        )


def path_dynamics(
    curve: ArcLength, length: Array, limits: LimitsAlong, torque_model: pin.Model | None, tool: ToolSpeed | None
) -> PathDynamics:
    """The demand rows at the grid points `length` (k,) of a piece."""
    s = curve.s(length)
    tangent, curvature = curve.bends(s)
    bounds = limits.at(s, around=AT_EDGE)
    time_unit = float(np.sqrt(curve.length * (np.abs(tangent) / bounds.acceleration).max()))
    q = curve.path(s) if torque_model is not None or tool is not None else np.empty(0)
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
    return PathDynamics(
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


Use = Mapping[str, Array]


class LimitTightening:
    """Factors by which limits are tightened over rounds of solving: at grid points (k,), and for jerk between them.

    Factors are at least 1. That of velocity at an end with a given speed stays 1.
    """

    def __init__(self, count: int, given: tuple[bool, bool]) -> None:
        self.rounds = 0
        self.jerk = np.ones(count - 1)
        self._velocity, self._rows = np.ones(count), np.ones(count)
        self._given = given

    def of(self, demands: PathDynamics) -> PathDynamics:
        """The demands with limits tightened by these factors."""
        return demands.eased(self._velocity, self._rows) if self.rounds else demands

    def tighten(self, use: Use) -> None:
        """Tighten limits where a motion exceeds them; `use` holds demand over limit on each of its pieces."""
        margin = 1 + 1e-7 * 4.0 ** min(self.rounds, 7)  # neighbouring intervals affect each other
        for factors, kinds in ((self._velocity, ("velocity", "tool speed")), (self._rows, ("acceleration", "torque"))):
            for kind in kinds:
                if kind in use:
                    excess = self._excess(use[kind], margin)
                    factors[:-1] *= excess
                    factors[1:] *= excess
        self.jerk *= self._excess(use["jerk"], margin)
        for end, given in zip((0, -1), self._given, strict=True):
            if given:
                self._velocity[end] = 1.0
        self.rounds += 1

    def _excess(self, use: Array, margin: float) -> Array:
        """Divisors of the limits on each grid interval, which holds one or two cubic pieces."""
        intervals = len(self.jerk)
        pieces, over = divmod(len(use), intervals)
        # samples at the same nanosecond were dropped, so pieces cannot be matched to intervals
        most = use.reshape(-1, pieces).max(axis=1) if pieces and not over else np.full(intervals, use.max())
        return np.where(most > 1, most * margin, 1.0)


def slowdown(use: Use) -> float:
    """Factor by which a motion has to be slowed down; 1 when every limit holds."""
    factor = max(float(use["velocity"].max()), float(np.sqrt(use["acceleration"].max())), float(np.cbrt(use["jerk"].max())))
    if "tool speed" in use:
        factor = max(factor, float(use["tool speed"].max()))
    if "torque" in use and (excess := float(use["torque"].max()) - 1) > 0:
        # slowing down does not reduce the torque of gravity, so torque gets a small step per round
        factor = max(factor, 1 + 2 * excess)
    return max(factor, 1.0)
