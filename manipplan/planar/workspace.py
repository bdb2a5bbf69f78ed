"""Workspaces of the planar arm: without joint limits rings around the base, within joint limits bounded by arcs."""

import itertools
import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from manipplan.planar.arm import PlanarArm
from manipplan.planar.limits import AngleLimits
from manipplan.planar.orientations import Interval, check_few_links, is_reachable
from manipplan.support.checks import Array, configurations, instance
from manipplan.support.errors import InvalidInputError

#: Distance to each side of an arc at which reachability is tested, as a share of the arm's length.
BESIDE = 1e-6


@dataclass(frozen=True, kw_only=True)
class Annulus:
    """The ring inner <= ‖p‖ <= outer around the base; a disc when inner is 0.

    Attributes:
        inner: [m].
        outer: [m].
    """

    inner: float
    outer: float

    @property
    def area(self) -> float:
        """π (outer² - inner²) [m²]."""
        return math.pi * (self.outer**2 - self.inner**2)

    def contains(self, position: ArrayLike) -> np.ndarray:
        """(...,) whether positions (..., 2) [m] lie in it."""
        p = configurations("position", position, 2)
        radius = np.hypot(p[..., 0], p[..., 1])
        return np.asarray((radius >= self.inner) & (radius <= self.outer))


def reachable_annulus(arm: PlanarArm) -> Annulus:
    """The reachable workspace W_R (2.5) in kth2012: from max(0, 2 max l - Σ l) to Σ l."""
    instance("arm", arm, PlanarArm)
    total = math.fsum(arm.lengths)
    return Annulus(inner=max(0.0, math.fsum([2 * max(arm.lengths), *(-arm.lengths)])), outer=total)


def dexterous_annuli(arm: PlanarArm) -> tuple[Annulus, ...]:
    """The dexterous workspace W_D (2.6) in kth2012: positions that can be reached with every orientation.

    As φ makes a full turn, the last joint's distance from the base ranges from abs(R - l_n) to R + l_n; this range must lie
    in the ring [a, b] of the first n - 1 links. Hence R <= b - l_n together with R <= l_n - a or R >= l_n + a: an empty set,
    one ring, or a disc and a ring.
    """
    instance("arm", arm, PlanarArm)
    last, *others = arm.lengths[::-1].tolist()
    total = math.fsum(others)
    inner = max(0.0, math.fsum([2 * max(others), *(-x for x in others)]))
    parts = [(0.0, min(total - last, last - inner)), (last + inner, total - last)]
    if inner == 0.0:
        parts = [(0.0, total - last)]  # the two parts touch, or the second is empty
    return tuple(Annulus(inner=low, outer=high) for low, high in parts if low <= high)


@dataclass(frozen=True, kw_only=True, eq=False)
class Arc:
    """A circular arc, counter-clockwise from angle `begin` to `end`.

    Attributes:
        centre: (2,) [m].
        radius: [m].
        begin: [rad].
        end: [rad], from begin to begin + 2π.
    """

    centre: Array
    radius: float
    begin: float
    end: float

    def __call__(self, share: ArrayLike) -> Array:
        """Points (..., 2) at shares (...,) of the way from begin to end."""
        angle = self.begin + np.asarray(share) * (self.end - self.begin)
        return np.asarray(self.centre + self.radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1))


def critical_arcs(arm: PlanarArm, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> tuple[Arc, ...]:
    """The images of all postures in which the tool can be on the boundary of its workspace; any number of links.

    Some joints are on a limit; the others lie on one line with the tool. While the first of them moves through its range,
    the tool traces an arc around it. The boundary of the workspace is part of these arcs. Raises InvalidInputError for
    limits of a wrong shape or order.
    """
    instance("arm", arm, PlanarArm)
    limits = AngleLimits.of(lower, upper, arm.n)
    return tuple(arc for _, arc in _critical(arm, limits))


def reachable_radii(arm: PlanarArm, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> Interval:
    """Smallest and largest distance [m] of the tool from the base within joint limits; all between are reachable.

    The extremes lie on the critical arcs around the base. Raises InvalidInputError like `critical_arcs`, and for limits on
    joints 2 to n of an arm with more than three links.
    """
    instance("arm", arm, PlanarArm)
    limits = AngleLimits.of(lower, upper, arm.n)
    free_base = AngleLimits(lower=np.r_[-np.inf, limits.lower[1:]], upper=np.r_[np.inf, limits.upper[1:]])
    radii = [arc.radius for first, arc in _critical(arm, free_base) if first == 0]
    if _closes(arm, free_base):
        radii.append(0.0)
    return min(radii), max(radii)


def workspace_boundary(arm: PlanarArm, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> tuple[Arc, ...]:
    """The boundary of the reachable workspace within joint limits, as arcs; two or three links.

    The critical arcs are split where they cross each other; a piece belongs to the boundary when a point `BESIDE` to one side
    of it is unreachable. Pieces shorter than 4 `BESIDE` are dropped or joined to their neighbours. Raises InvalidInputError for
    more links, or limits of a wrong shape or order.
    """
    instance("arm", arm, PlanarArm)
    check_few_links(arm)
    arcs = _different(critical_arcs(arm, lower, upper), float(arm.lengths.sum()))
    aside = BESIDE * float(arm.lengths.sum())
    kept: list[Arc] = []
    for arc in arcs:
        cuts = [arc.begin, arc.end, *(a for other in arcs if other is not arc for a in _crossings(arc, other))]
        for begin, end in itertools.pairwise(sorted(cuts)):
            if (end - begin) * arc.radius <= 4 * aside:
                continue
            piece = Arc(centre=arc.centre, radius=arc.radius, begin=begin, end=end)
            outward = (piece(0.5) - arc.centre) / arc.radius
            sides = (piece(0.5) + sign * aside * outward for sign in (1, -1))
            if not all(is_reachable(arm, side, lower, upper) for side in sides):
                kept.append(piece)
    return _merged(kept, 6 * aside)


def _critical(arm: PlanarArm, limits: AngleLimits) -> list[tuple[int, Arc]]:
    """The critical arcs, each with the index of the joint at its centre."""
    n, result = arm.n, []
    for free in itertools.product((False, True), repeat=n):
        joints = [i for i in range(n) if free[i]]
        if not joints or any(not limits.bounded[i] for i in range(n) if not free[i]):
            continue
        ends = [(0.0,) if free[i] else (float(limits.lower[i]), float(limits.upper[i])) for i in range(n)]
        for held in itertools.product(*ends):
            for straight in itertools.product((0.0, np.pi), repeat=len(joints) - 1):
                arc = _arc(arm, limits, np.array(held), joints, straight)
                if arc is not None:
                    result.append((joints[0], arc))
    return result


def _arc(arm: PlanarArm, limits: AngleLimits, held: Array, joints: list[int], straight: tuple[float, ...]) -> Arc | None:
    """The arc with joints[1:] set so that each rigid part between free joints points along the first one or opposite to it."""
    q, first = held.copy(), joints[0]
    for joint, turn in zip(joints[1:], straight, strict=True):
        before = arm.joint_positions(q)
        line = before[joint] - before[first]  # from the first free joint to this one
        last = joints[joints.index(joint) + 1] if joint != joints[-1] else arm.n
        part = before[last] - before[joint]
        if min(np.hypot(*line), np.hypot(*part)) <= 1e-12 * arm.lengths.sum():
            return None  # coincident joints move the tool like one: arcs with either of them on a limit cover this
        q[joint] += np.arctan2(line[1], line[0]) + turn - np.arctan2(part[1], part[0])
        placed = AngleLimits(lower=limits.lower[joint : joint + 1], upper=limits.upper[joint : joint + 1]).placed(q[[joint]])[0]
        if np.isnan(placed):
            return None
        q[joint] = placed
    points = arm.joint_positions(q)
    lever = points[-1] - points[first]
    radius = float(np.hypot(*lever))
    if radius <= 1e-12 * arm.lengths.sum():
        return None
    at = float(np.arctan2(lever[1], lever[0])) - q[first]
    if limits.bounded[first]:
        return Arc(centre=points[first], radius=radius, begin=at + limits.lower[first], end=at + limits.upper[first])
    return Arc(centre=points[first], radius=radius, begin=-np.pi, end=np.pi)


def _closes(arm: PlanarArm, limits: AngleLimits) -> bool:
    """Whether the tool can reach the base."""
    if arm.n <= 3:
        return is_reachable(arm, (0.0, 0.0), limits.lower, limits.upper)
    if limits.bounded[1:].any():
        raise InvalidInputError("arm", arm, "two or three links when joints 2 to n have limits")
    lengths = arm.lengths
    return bool(2 * lengths.max() <= lengths.sum())


def _crossings(arc: Arc, other: Arc) -> list[float]:
    """Angles inside `arc` at which the other's circle crosses it; on the same circle, the other's ends."""
    offset = other.centre - arc.centre
    distance = float(np.hypot(*offset))
    if distance <= 1e-12 * (arc.radius + other.radius):
        same = abs(arc.radius - other.radius) <= 1e-9 * arc.radius
        angles = [other.begin, other.end] if same else []
    else:
        cosine = (arc.radius**2 + distance**2 - other.radius**2) / (2 * arc.radius * distance)
        if abs(cosine) > 1 + 1e-9:
            return []
        half = float(np.arccos(np.clip(cosine, -1.0, 1.0)))
        at = float(np.arctan2(offset[1], offset[0]))
        angles = [at - half, at + half]
    placed = [arc.begin + float(np.mod(angle - arc.begin, 2 * np.pi)) for angle in angles]
    return [angle for angle in placed if angle < arc.end]


def _different(arcs: tuple[Arc, ...], size: float) -> list[Arc]:
    kept: list[Arc] = []
    for arc in arcs:
        ends = np.concatenate([arc(0.0), arc(0.5), arc(1.0)])
        if all(np.abs(ends - np.concatenate([o(0.0), o(0.5), o(1.0)])).max() > 1e-9 * size for o in kept):
            kept.append(arc)
    return kept


def _merged(pieces: list[Arc], gap: float) -> tuple[Arc, ...]:
    """Joins pieces of one circle that are less than `gap` [m] apart, and drops duplicates."""
    kept: list[Arc] = []
    for piece in sorted(pieces, key=lambda arc: (round(arc.radius, 6), *np.round(arc.centre, 6), arc.begin)):
        share = gap / piece.radius
        for k, other in enumerate(kept):
            if abs(other.radius - piece.radius) + np.abs(other.centre - piece.centre).max() > 1e-9:
                continue
            begin = other.begin + np.mod(piece.begin - other.begin + share, 2 * np.pi) - share
            if begin <= other.end + share:
                end = min(max(other.end, begin + piece.end - piece.begin), other.begin + 2 * np.pi)
                kept[k] = Arc(centre=other.centre, radius=other.radius, begin=other.begin, end=end)
                break
        else:
            kept.append(piece)
    return tuple(kept)
