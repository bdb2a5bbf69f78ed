"""The planar n-link arm: joint positions, tool position and Jacobian in closed form.

Inverse kinematics of planar arms with two or three links in closed form.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from manipplan.support.checks import FARTHEST, Array, ArrayLike, configurations, finite_array, instance, number, number_array
from manipplan.support.errors import InvalidInputError

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot


@dataclass(frozen=True, eq=False, init=False)
class PlanarArm:
    """n revolute joints about z and n links in the plane [kth2012, chapter 2], in closed form.

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


#: A position outside the workspace by less than this share of the arm's length counts as on its boundary.
GRAZE = 1e-12


def two_link_postures(arm: PlanarArm, position: ArrayLike) -> Array:
    """Postures (k, 2) [rad] of a two-link arm that bring the tool to `position` (2,) [m]; k is 0, 1 or 2.

    θ_1 is in (-π, π]; θ_2 is in [0, π] in the first row and negated in the second. Where l_1 = l_2 and the position is the
    base, θ_1 is free and the only row has θ_1 = 0. Raises InvalidInputError for an arm that does not have two links.
    """
    check_links(arm, 2, 2)
    target = finite_array("position", position, (2,))
    return two_links(float(arm.lengths[0]), float(arm.lengths[1]), target)


def pose_postures(arm: PlanarArm, position: ArrayLike, orientation: float) -> Array:
    """Postures (k, 3) [rad] of a three-link arm with the tool at `position` (2,) [m] and at the angle `orientation` [rad].

    Both elbow solutions: θ_2 >= 0 in the first row, θ_2 <= 0 in the second; one row where they coincide, none out of reach.
    All angles are in (-π, π]. Where the third joint is at the base, θ_1 is free and the only row has θ_1 = 0. Raises
    InvalidInputError for an arm that does not have three links.
    """
    check_links(arm, 3, 3)
    target = finite_array("position", position, (2,))
    return _with_orientation(arm, target, number("orientation", orientation))


@dataclass(frozen=True, kw_only=True, eq=False)
class PostureFamily:
    """All postures of a three-link arm for one position: one parameter, the tool's angle φ, and two elbow solutions.

    Attributes:
        arm: three links.
        position: (2,) of the tool [m].
        orientations: none, one or two reachable intervals (begin, end) of φ [rad]. An interval of length 2π is the whole
            circle.
    """

    arm: PlanarArm
    position: Array
    orientations: tuple[tuple[float, float], ...]

    def __call__(self, orientation: float) -> Array:
        """The postures (k, 3) [rad] with this φ, as in `pose_postures`."""
        return _with_orientation(self.arm, self.position, number("orientation", orientation))


def position_family(arm: PlanarArm, position: ArrayLike) -> PostureFamily:
    """The one-parameter family of postures of a three-link arm that bring the tool to `position` (2,) [m].

    The third joint is at distance d from the base with d² = R² + l_3² - 2 R l_3 cos(φ - α), where α is the direction of the
    position; the first two links reach it where d is between the difference and the sum of their lengths.

    Raises InvalidInputError for an arm that does not have three links.
    """
    check_links(arm, 3, 3)
    target = finite_array("position", position, (2,))
    return PostureFamily(arm=arm, position=target, orientations=_orientations(arm, target))


def two_links(first: float, second: float, target: Array) -> Array:
    """`two_link_postures` for lengths already checked; a link may also be several links held rigidly."""
    distance = float(np.hypot(*target))
    found = elbow_between(first, second, distance)
    if found is None:
        return np.zeros((0, 2))
    if distance <= GRAZE * (first + second):  # folded back onto the base
        return np.array([[0.0, np.pi]])
    elbow, is_straight = found
    bend = np.arctan2(second * np.sin(elbow), first + second * np.cos(elbow))
    direction = np.arctan2(target[1], target[0])
    rows = np.array([[direction - bend, elbow], [direction + bend, -elbow]])
    return wrapped(rows[:1] if is_straight else rows)


def elbow_between(first: float, second: float, distance: float) -> tuple[float, bool] | None:
    """The angle from one part to the next, in [0, π], that brings their ends this far apart, and whether they are in line.

    None where they do not reach. Half-angle form of the law of cosines: accurate even near the stretched and the folded arm.
    """
    total = first + second
    if abs(first - second) > distance + GRAZE * total or distance > total * (1 + GRAZE):
        return None
    near = max((distance - (first - second)) * (distance + (first - second)), 0.0)
    far = max((total - distance) * (total + distance), 0.0)
    return float(2 * np.arctan2(np.sqrt(far), np.sqrt(near))), min(near, far) <= GRAZE * total**2


def rigid_part(first: float, second: float, angle: float) -> tuple[float, float]:
    """Length of two links held at an angle, and its direction relative to the first."""
    x, y = first + second * np.cos(angle), second * np.sin(angle)
    return float(np.hypot(x, y)), float(np.arctan2(y, x))


def wrapped(angles: ArrayLike) -> Array:
    """Angles in (-π, π]."""
    return np.asarray(np.pi - np.mod(np.pi - np.asarray(angles), 2 * np.pi))


def _with_orientation(arm: PlanarArm, target: Array, orientation: float) -> Array:
    l1, l2, l3 = arm.lengths
    wrist = target - l3 * np.array([np.cos(orientation), np.sin(orientation)])
    pairs = two_links(float(l1), float(l2), wrist)
    return wrapped(np.column_stack([pairs, orientation - pairs.sum(axis=1)]))


def _orientations(arm: PlanarArm, target: Array) -> tuple[tuple[float, float], ...]:
    l1, l2, l3 = (float(length) for length in arm.lengths)
    radius, alpha = float(np.hypot(*target)), float(np.arctan2(target[1], target[0]))
    slack = GRAZE * (l1 + l2 + l3)
    least, most = abs(l1 - l2), l1 + l2
    if radius <= slack:
        return ((-np.pi, np.pi),) if least - slack <= l3 <= most + slack else ()
    near, far = abs(radius - l3), radius + l3
    if near > most + slack or far < least - slack:
        return ()

    def angle(distance: float) -> float:
        cosine = (radius**2 + l3**2 - distance**2) / (2 * radius * l3)
        return float(np.arccos(np.clip(cosine, -1.0, 1.0)))

    begin, end = angle(max(near, least)), angle(min(far, most))  # range of |φ - α|
    if near >= least and far <= most:
        return ((alpha - np.pi, alpha + np.pi),)
    if near >= least:
        return ((alpha - end, alpha + end),)
    if far <= most:
        return ((alpha + begin, alpha + 2 * np.pi - begin),)
    return ((alpha - end, alpha - begin), (alpha + begin, alpha + end))


def check_links(arm: PlanarArm, least: int, most: int) -> None:
    """Raise InvalidInputError for anything but a planar arm with a number of links in this range."""
    if not least <= instance("arm", arm, PlanarArm).n <= most:
        count = str(most) if least == most else f"{least} to {most}"
        raise InvalidInputError("arm", arm, f"a PlanarArm with {count} links")
