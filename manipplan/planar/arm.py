"""The planar n-link arm: joint positions, tool position and Jacobian in closed form."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from manipplan.support.checks import FARTHEST, Array, configurations, number_array
from manipplan.support.errors import InvalidInputError

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot


@dataclass(frozen=True, eq=False, init=False)
class PlanarArm:
    """n revolute joints about z and n links in the plane [kth2012, ch. 2], in closed form.

    Symbols: θ_i = q[i-1] is the angle of link i relative to link i-1 [rad], φ_p = θ_1 + ... + θ_p the angle of link p
    to the x axis, l_p its length [m].

    Args:
        lengths: (n,) link lengths l_i [m], each above zero, n >= 2.

    Raises InvalidInputError for lengths that are not positive and finite, or for fewer than two.
    """

    lengths: Array

    def __init__(self, lengths: ArrayLike) -> None:
        array = number_array("lengths", lengths)
        if array.ndim != 1 or len(array) < 2 or not ((array > 0) & (array <= FARTHEST)).all():
            raise InvalidInputError("lengths", lengths, f"at least two numbers above zero, up to {FARTHEST:g} [m]")
        array.flags.writeable = False
        object.__setattr__(self, "lengths", array)

    def __repr__(self) -> str:
        return f"PlanarArm({self.lengths.tolist()})"

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.lengths)

    def joint_positions(self, q: ArrayLike) -> Array:
        """Positions of the base, joints 2 to n and the tool, (..., n + 1, 2) [m], at q (..., n) [rad]."""
        steps = self._links(q)
        base = np.zeros((*steps.shape[:-2], 1, 2))
        return np.concatenate([base, np.cumsum(steps, axis=-2)], axis=-2)

    def position(self, q: ArrayLike) -> Array:
        """The tool's position p_e = f(θ), (..., 2) [m], at q (..., n) [rad]; (2.3) in kth2012."""
        return np.asarray(self._links(q).sum(axis=-2))

    def orientation(self, q: ArrayLike) -> Array:
        """The tool's angle φ_e = θ_1 + ... + θ_n [rad], not wrapped, (...,), at q (..., n); (2.4) in kth2012."""
        return np.asarray(configurations("q", q, self.n).sum(axis=-1))

    def radius(self, q: ArrayLike) -> Array:
        """The tool's distance from the base, (...,) [m], at q (..., n); it does not depend on θ_1."""
        position = self.position(q)
        return np.hypot(position[..., 0], position[..., 1])

    def levers(self, q: ArrayLike) -> Array:
        """Vectors r_i from joint i to the tool, (..., n, 2) [m], at q (..., n) [rad]."""
        return np.flip(np.cumsum(np.flip(self._links(q), axis=-2), axis=-2), axis=-2)

    def jacobian(self, q: ArrayLike) -> Array:
        """The Jacobian of the position, (..., 2, n) [m], at q (..., n) [rad]; (2.11) in kth2012."""
        r = self.levers(q)
        return np.stack([-r[..., 1], r[..., 0]], axis=-2)  # column i is r_i rotated by 90 degrees

    def pose_jacobian(self, q: ArrayLike) -> Array:
        """Position rows [m], then the orientation row [1], (..., 3, n), at q (..., n); (2.9) in kth2012."""
        linear = self.jacobian(q)
        return np.concatenate([linear, np.ones((*linear.shape[:-2], 1, self.n))], axis=-2)

    def robot(self) -> "Robot":
        """The same arm as a general robot, `manipplan.planar_arm(lengths)`."""
        from manipplan.robots.catalog import planar_arm

        return planar_arm(self.lengths)

    def _links(self, q: ArrayLike) -> Array:
        """Link vectors l_p (cos φ_p, sin φ_p), (..., n, 2)."""
        phi = np.cumsum(configurations("q", q, self.n), axis=-1)
        return np.asarray(self.lengths[:, None] * np.stack([np.cos(phi), np.sin(phi)], axis=-1))
