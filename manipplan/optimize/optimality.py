"""How near a path is to a local optimum of the true problem: first-order conditions [nocedal2006, sec. 12.3] on the path.

The multipliers λ >= 0 of the active rows come from a non-negative least-squares fit, min ‖∇g - Σ λ_i ∇d_i‖, and not from the
solver that found the path.
"""

import logging
from dataclasses import dataclass, replace

import numpy as np

from manipplan.checks import Array
from manipplan.optimize.descent import TrueProgram

log = logging.getLogger("manipplan")

#: A path is optimal when the projected gradient is at most this [1/rad], ...
GRADIENT = 1e-3
#: ... the complementarity at most this share of g, ...
COMPLEMENTARITY = 1e-5
#: ... and active clearances differ from the demanded one by at most this [m].
ACTIVE = 1e-4
#: Joint limits that a step of this radius can reach are active [rad or m].
LIMIT = 1e-6
#: The gradient of a distance may be any convex combination of those at configurations whose joints differ by this from the
#: path's [rad or m]: near the edges of two bodies it turns within a fraction of a millimetre [goldstein1977].
KINK = 1e-4
#: Where the pairs within ACTIVE do not balance the gradient, pairs further away are tried, up to these distances from the
#: demanded clearance [m]. Where they do, the path keeps a distance that nothing demands: the active clearance says how much.
KEPT_AWAY = tuple(ACTIVE * 2.0**k for k in range(1, 8))
#: Clearances count as active when their multiplier is above this share of the largest.
NOTABLE = 1e-3


@dataclass(frozen=True, kw_only=True)
class Optimality:
    """First-order conditions of a path.

    Attributes:
        projected_gradient: norm of what the active limits and clearances leave of the gradient of g, over g [1/rad]: the
            relative change of g per radian of the root mean square of the slope's change, all joints together.
        complementarity: Σ λ_i |d_i - target| over g, where the target is the demanded clearance plus the margin for the proof:
            about the share by which g would fall if no active pair kept more than the target.
        active_clearance: largest difference between the distance of an active pair and the demanded clearance [m]; 0 where
            no clearance is active. Above ACTIVE where only pairs that are further away balance the gradient.
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


#: Of the only path of a basis, which has no unknowns.
SINGLE = Optimality(projected_gradient=0.0, complementarity=0.0, active_clearance=0.0)
#: Of a path at which no descent ended, or whose g the quadrature panels of the descent do not resolve.
UNKNOWN = Optimality(projected_gradient=np.inf, complementarity=np.inf, active_clearance=np.inf)


def measure_optimality(program: TrueProgram, z: Array) -> Optimality:
    """The first-order conditions at z (f, n)."""
    close = _fitted(program, z, ACTIVE)
    if program.surroundings is None or close.projected_gradient <= GRADIENT:
        return close
    further = (_fitted(program, z, reach) for reach in KEPT_AWAY)
    return next((each for each in further if each.projected_gradient <= GRADIENT), close)


def _fitted(program: TrueProgram, z: Array, reach: float) -> Optimality:
    """The conditions with the multipliers that fit best, of pairs within `reach` of the demanded clearance [m]."""
    from scipy.optimize import nnls

    length = program.length.without_energy
    gradient = length.gradient(z).ravel() / length.value(z)
    limits = program.limits.near(z, LIMIT)
    margin, beyond, jacobian, owner = 0.0, np.empty(0), np.empty((0, z.size)), np.empty(0, dtype=int)
    if program.surroundings is not None:
        near, further = program.surroundings, reach - ACTIVE
        margin = near.margin
        looking = replace(program, surroundings=replace(near, clearance=near.clearance + further))
        table = looking.table(z, looking.look(z, 0.0))
        beyond = table.linear(z, z).value + further
        jacobian, owner = table.gradients_nearby(z, np.flatnonzero(beyond < reach - margin), KINK)
    whole = np.concatenate([limits.jacobian, jacobian])
    if not len(whole):
        return Optimality(projected_gradient=float(np.linalg.norm(gradient)), complementarity=0.0, active_clearance=0.0)
    try:
        multipliers, left = nnls(whole.T, gradient)
    except RuntimeError as error:  # its maximum number of iterations
        log.debug("no multipliers for %d active rows: %s", len(whole), error)
        return UNKNOWN
    # several gradients of one row are one convex combination times the sum of their multipliers [goldstein1977]
    multipliers = np.bincount(owner, multipliers[len(limits.value) :], minlength=len(beyond))
    active = multipliers > NOTABLE * multipliers.max(initial=0.0)
    return Optimality(
        projected_gradient=float(left),
        complementarity=float(multipliers @ np.abs(beyond)),
        active_clearance=float(np.abs(beyond[active] + margin).max(initial=0.0)),
    )
