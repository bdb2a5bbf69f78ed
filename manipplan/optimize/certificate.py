"""Certificate: what an optimised path reaches, measured on the path and not taken from the solver.

First-order conditions of a local optimum [nocedal2006, sec. 12.3]: the multipliers λ >= 0 of the active rows come from a
non-negative least-squares fit, min ‖∇g - Σ λ_i ∇d_i‖, and not from the solver that found the path.
"""

import logging
from dataclasses import dataclass, replace

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.constraints.constraint_set import ConstraintFigure
from manipplan.cost.crossings import Crossing, describe
from manipplan.measures.manipulability import Constant
from manipplan.optimize.descent import DescentProgram
from manipplan.optimize.rows import ClearanceSearch, LinearRows
from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.deadline import building
from manipplan.support.display import one_line
from manipplan.support.status import Status

log = logging.getLogger("manipplan")

#: A path is optimal when the projected gradient is at most this [1/rad], ...
GRADIENT = 1e-3
#: ... the complementarity at most this share of g, ...
COMPLEMENTARITY = 1e-5
#: ... and active clearances differ from the required one by at most this [m].
ACTIVE = 1e-4
#: No further descent is tried from an optimal path whose projected gradient is at most this share of GRADIENT.
CLEAR = 0.2
#: Joint limits that a step of this radius can reach are active [rad or m].
LIMIT = 1e-6
#: The gradient of a distance may be any convex combination of those at configurations whose joints differ by this from the
#: path's [rad or m]: near the edges of two bodies it turns within a fraction of a millimetre [goldstein1977].
KINK = 1e-4
#: If the pairs within ACTIVE do not balance the gradient, pairs further away are tried, up to these distances from the
#: required clearance [m]. If those balance it, the path keeps more distance than required; the active clearance says how much.
KEPT_AWAY = tuple(ACTIVE * 2.0**k for k in range(1, 8))
#: Clearances count as active when their multiplier is above this share of the largest.
NOTABLE = 1e-3


@dataclass(frozen=True, kw_only=True)
class Optimality:
    """First-order conditions of a path, as `Certificate` explains them.

    The complementarity is Σ λ_i |d_i - target| over g; the target is the required clearance plus the margin for the proof.
    The active clearance is above ACTIVE where only pairs that are further away balance the gradient.
    """

    projected_gradient: float
    complementarity: float
    active_clearance: float

    @property
    def reached(self) -> bool:
        """Whether all three are within their tolerances."""
        return bool(
            self.projected_gradient <= GRADIENT and self.complementarity <= COMPLEMENTARITY and self.active_clearance <= ACTIVE
        )

    @property
    def is_clear(self) -> bool:
        """Whether they are, and the gradient well so: then another descent hardly lowers g."""
        return self.reached and self.projected_gradient <= CLEAR * GRADIENT


#: For the only path of a basis, which has no unknowns.
SINGLE = Optimality(projected_gradient=0.0, complementarity=0.0, active_clearance=0.0)
#: For a path at which no descent ended, or whose g the quadrature panels of the descent do not resolve.
UNKNOWN = Optimality(projected_gradient=np.inf, complementarity=np.inf, active_clearance=np.inf)


def measure_optimality(program: DescentProgram, z: Array) -> Optimality:
    """The first-order conditions at z (f, n)."""
    close = _fitted(program, z, ACTIVE)
    if not program.is_checked or close.projected_gradient <= GRADIENT:
        return close
    *nearer, furthest = KEPT_AWAY  # what the furthest pairs do not balance, fewer do not balance either
    last = _fitted(program, z, furthest)
    if last.projected_gradient > GRADIENT:
        return close
    further = (_fitted(program, z, reach) for reach in nearer)
    return next((each for each in further if each.projected_gradient <= GRADIENT), last)


def _fitted(program: DescentProgram, z: Array, reach: float) -> Optimality:
    """The conditions with the best-fitting multipliers of pairs within `reach` of the required clearance [m]."""
    with building():
        from scipy.optimize import nnls

    length = program.length.without_energy
    gradient = length.gradient(z).ravel() / length.value(z)
    limits = program.limits.near(program.limits.points(z), LIMIT)
    curves, curve = program.length.curves, program.length.curves.curve(z)
    margin, beyond, jacobian, owner = 0.0, np.empty(0), np.empty((0, z.size)), np.empty(0, dtype=int)
    if isinstance(program.clearance, ClearanceSearch):
        near, further = program.clearance, reach - ACTIVE
        margin = near.margin
        rows = replace(near, clearance=near.clearance + further).at(curves, z, curve, 0.0)
        beyond = rows.value + further
        jacobian, owner = rows.gradients_nearby(np.flatnonzero(beyond < reach - margin), KINK)
    constraints = LinearRows.stacked([], z.size)
    if program.constraints is not None:
        found = program.constraints.at(curves, z, curve, 0.0).linear
        active = found.value < ACTIVE
        constraints = LinearRows(value=found.value[active], jacobian=found.jacobian[active])
    whole = np.concatenate([limits.jacobian, constraints.jacobian, jacobian])
    gradient, whole = gradient[program.moving], whole[:, program.moving]
    if not len(whole):
        return Optimality(projected_gradient=float(np.linalg.norm(gradient)), complementarity=0.0, active_clearance=0.0)
    try:
        multipliers, left = nnls(whole.T, gradient)
    except RuntimeError as error:  # nnls reached its maximum number of iterations
        log.debug("no multipliers for %d active rows: %s", len(whole), error)
        return UNKNOWN
    # several gradients of one row are one convex combination times the sum of their multipliers [goldstein1977]
    of_constraints = multipliers[len(limits.value) :][: len(constraints.value)]
    of_clearance = multipliers[len(limits.value) + len(constraints.value) :]
    multipliers = np.bincount(owner, of_clearance, minlength=len(beyond))
    active = multipliers > NOTABLE * multipliers.max(initial=0.0)
    return Optimality(
        projected_gradient=float(left),
        complementarity=float(multipliers @ np.abs(beyond) + of_constraints @ np.abs(constraints.value)),
        active_clearance=float(np.abs(beyond[active] + margin).max(initial=0.0)),
    )


#: Number of intervals of the path at whose ends all distances are measured; the grid is refined around the smallest one.
DISTANCE_INTERVALS = 400


@one_line
@dataclass(frozen=True, kw_only=True)
class LimitApproach:
    """Smallest distance of a path to one position limit of a joint.

    Attributes:
        joint: name of the joint.
        side: "lower" or "upper".
        distance: smallest on the whole curve [rad or m]; negative beyond the limit.
        at: the s where it is nearest, on a grid of 2001 points.
        unit: "rad" or "m".
    """

    joint: str
    side: str
    distance: float
    at: float
    unit: str


@one_line
@dataclass(frozen=True, kw_only=True)
class Certificate:
    """Figures measured on one path.

    Attributes:
        status: how the path came about.
        solver: how the solver that gave the path ended; "" for a seed, and where there was nothing to solve.
        projected_gradient: the part of the gradient of g that active limits and clearances do not balance, over g [1/rad]: the
            relative change of g per radian of the root mean square of a change of q'(s). nan for a path that was not optimised;
            inf when no descent ended at it, or what the descent minimised differs from its g.
        complementarity: about the share by which g would fall if no active pair of bodies kept more than the clearance and the
            margin for the proof; nan and inf as above.
        active_clearance: largest difference between the distance of an active pair of bodies and the clearance [m]; 0 where no
            clearance is active, nan and inf as above.
        g: ∫ ‖q'‖_W / (m² + floor²)^(power/2) ds, to ten digits; to four where a power below 1 and no floor let a path cross a
            singularity.
        unconstrained_g: g of the local optimum that is reached from this path when limits and obstacles are taken away, in the
            same basis and with the same end conditions. nan unless `optimize_path(compare=True)` was asked for it, and when g
            is infinite. `gap` compares the two.
        power, floor, measure, unit: exponent, floor, name of the measure m, and its unit.
        min_manipulability, min_at: the minimum manipulability, and the s where it occurs.
        clearance, clearance_at, nearest_pair: the smallest measured distance [m], the s where it occurs, and the two bodies.
            inf, nan and () where nothing is checked. Measured at 401 places, and more densely around the smallest.
        proven_clearance: lower bound of the distance of all checked pairs on the whole curve, also between those places [m];
            inf where nothing is checked. For a seed that could not be proven free it is at most the required clearance.
        crossings: singularities that the path meets, such as those at which det J changes its sign.
        least_crossings: lower bound on the number of crossings of any path between start and goal; None for an arm with more
            joints than task rows.
        limits: smallest distance to every finite position limit of every joint, nearest first.
        constraints: how the path keeps each constraint.
    """

    status: Status
    solver: str
    projected_gradient: float
    complementarity: float
    active_clearance: float
    g: float
    unconstrained_g: float
    power: float
    measure: str
    unit: str
    min_manipulability: float
    min_at: float
    clearance: float
    clearance_at: float
    nearest_pair: tuple[str, ...]
    proven_clearance: float
    limits: tuple[LimitApproach, ...]
    floor: float = 0.0
    crossings: tuple[Crossing, ...] = ()
    least_crossings: int | None = None
    constraints: tuple[ConstraintFigure, ...] = ()

    @property
    def finite_g(self) -> float:
        """g without its crossings: what remains when the `cost` of each is taken away. It hardly depends on the floor.

        nan where one of them has no such cost. It can be negative, where m stays below its typical value beside a crossing.
        """
        return self.g - sum(each.cost for each in self.crossings)

    @property
    def gap(self) -> float:
        """g over the unconstrained optimum nearby, minus 1: the cost of limits and obstacles, or of keeping the seed."""
        return self.g / self.unconstrained_g - 1

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        lines = [
            f"status       {self.status.value}",
            f"solver       {self.solver or 'nothing was solved for this path'}",
            f"optimality   {self._optimality()}",
            f"g            {self.g:.6g}, exponent {self.power:g}{self._beside()}",
            f"minimum m    {self.min_manipulability:.4g}{unit} at s = {self.min_at:.3f} ({self.measure})"
            if self.measure != Constant.name
            else "minimum m    does not count: the shortest path was sought",
        ]
        if self.crossings:
            lines.append(f"singularity  {describe(self.crossings, self.least_crossings)}")
            lines.append(f"             g without them: {self.finite_g:.6g}")
        if self.nearest_pair:
            pair = " and ".join(self.nearest_pair)
            lines.append(
                f"clearance    {1e3 * self.clearance:.2f} mm at s = {self.clearance_at:.3f}, {pair}; "
                f"proven on the whole curve: {1e3 * self.proven_clearance:.2f} mm"
            )
        else:
            lines.append("clearance    nothing is checked for collision")
        lines += [f"constraint   {each}, at s = {each.at:.3f}" for each in self.constraints]
        lines += [
            f"limit        {each.joint}: {each.distance:.4g} {each.unit} to its {each.side} limit at s = {each.at:.3f}"
            for each in self.limits
        ]
        return "\n".join(lines if self.limits else [*lines, "limit        no joint has a position limit"])

    def _optimality(self) -> str:
        """The first-order conditions and their tolerances."""
        if np.isnan(self.projected_gradient):
            return "not measured: this path was not optimised"
        if np.isinf(self.projected_gradient):
            return "unknown: no descent ended at this path, or what it minimised differs from g here"
        return (
            f"projected gradient {self.projected_gradient:.1e} (at most {GRADIENT:g} per rad), "
            f"complementarity {self.complementarity:.1e} (at most {COMPLEMENTARITY:g}), "
            f"active clearances within {1e3 * self.active_clearance:.3f} mm (at most {1e3 * ACTIVE:g} mm)"
        )

    def _beside(self) -> str:
        """Comparison of g with the unconstrained optimum, if that is known."""
        if np.isnan(self.unconstrained_g):
            return ""
        return f"; nearby optimum without limits and obstacles: {self.unconstrained_g:.6g} ({100 * self.gap:+.3g} %)"


def limit_approaches(path: JointPath, robot: Robot) -> tuple[LimitApproach, ...]:
    """Smallest distance of the whole curve to every finite position limit, nearest first."""
    low, high = path.bounds()
    s = np.linspace(0.0, 1.0, 2001)
    q = path(s)
    found = []
    for joint, name in enumerate(robot.joint_names):
        unit = "m" if robot.joint_types[joint] == "prismatic" else "rad"
        for side, distance, at in (
            ("lower", low[joint] - robot.limits.lower[joint], q[:, joint].argmin()),
            ("upper", robot.limits.upper[joint] - high[joint], q[:, joint].argmax()),
        ):
            if np.isfinite(distance):
                found.append(LimitApproach(joint=name, side=side, distance=float(distance), at=float(s[at]), unit=unit))
    return tuple(sorted(found, key=lambda each: each.distance))


def _clearance(path: JointPath, model: CollisionModel | None) -> tuple[float, float, tuple[str, ...]]:
    """Smallest distance of all pairs [m], the s where it occurs, and the names of the pair."""
    if model is None or not model.pair_names:
        return np.inf, np.nan, ()
    s = np.linspace(0.0, 1.0, DISTANCE_INTERVALS + 1)
    least, at, pair = np.inf, 0.0, 0
    for _ in range(3):  # 400 intervals, then 40 around the smallest distance, then 40 around that
        distance, k, nearest = model.least_distance(path(s))
        if distance < least:
            least, at, pair = distance, float(s[k]), nearest
        s = np.linspace(s[max(k - 1, 0)], s[min(k + 1, len(s) - 1)], 41)
    return least, at, tuple(model.pair_names[pair])
