"""Workspaces of the planar arm: without joint limits rings around the base, within joint limits bounded by arcs.

Joint limits on the torus: an angle is inside when it is inside after some number of full turns.

Positions and orientations that a two- or three-link arm reaches within joint limits, exact at each position.
"""

import itertools
import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from manipplan.planar.arm import (
    GRAZE,
    PlanarArm,
    check_links,
    position_family,
    rigid_part,
    two_link_postures,
    two_links,
    wrapped,
)
from manipplan.support.checks import Array, ArrayLike, configurations, instance, number_array
from manipplan.support.errors import InvalidInputError

#: An angle that exceeds a limit by less than this is on the limit [rad].
ON_LIMIT = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class AngleLimits:
    """lower <= θ <= upper (n,) [rad], -inf and inf where there is none; a range of 2π or more is no limit."""

    lower: Array
    upper: Array

    @classmethod
    def of(cls, lower: ArrayLike | None, upper: ArrayLike | None, n: int) -> "AngleLimits":
        """Limits from one number for all joints, n of them, or None.

        Raises InvalidInputError for NaN, other shapes, or a lower limit above the upper one.
        """
        low, high = (_one_side(name, value, n) for name, value in (("lower", lower), ("upper", upper)))
        if (low > high).any() or np.isposinf(low).any() or np.isneginf(high).any():
            raise InvalidInputError(
                "lower, upper", [low.tolist(), high.tolist()], "lower limits that are not above the upper ones"
            )
        return cls(lower=low, upper=high)

    @property
    def bounded(self) -> Array:
        """(n,) whether each joint's range is less than a full turn."""
        return np.asarray(self.upper - self.lower < 2 * np.pi)

    def placed(self, q: ArrayLike) -> Array:
        """q (..., n), each angle shifted by full turns into its range, as near to zero as possible; NaN where none fits.

        An angle that exceeds a limit by less than `ON_LIMIT` is set to it.
        """
        angles = np.asarray(q, dtype=np.float64)
        turn = 2 * np.pi
        wrapped = angles - turn * np.round(angles / turn)
        least = np.ceil((self.lower - ON_LIMIT - wrapped) / turn)
        most = np.floor((self.upper + ON_LIMIT - wrapped) / turn)
        turns = np.clip(0.0, least, most)
        placed = np.clip(wrapped + turn * np.where(np.isfinite(turns), turns, 0.0), self.lower, self.upper)
        return np.where(least <= most, placed, np.nan)

    def contain(self, q: ArrayLike) -> Array:
        """(...,) whether all angles of q (..., n) are inside, up to full turns."""
        return np.asarray(np.isfinite(self.placed(q)).all(axis=-1))


def _one_side(name: str, value: ArrayLike | None, n: int) -> Array:
    if value is None:
        return np.full(n, -np.inf if name == "lower" else np.inf)
    array = number_array(name, value)
    if array.shape not in ((), (n,)) or np.isnan(array).any():
        raise InvalidInputError(name, value, f"one angle or {n} angles [rad], without NaN")
    return np.broadcast_to(array, (n,)).copy()


Interval = tuple[float, float]


def reachable_orientations(
    arm: PlanarArm, position: ArrayLike, lower: ArrayLike | None = None, upper: ArrayLike | None = None
) -> tuple[Interval, ...]:
    """Tool angles φ [rad] that a three-link arm can reach at `position` (2,) [m] within joint limits.

    Disjoint closed intervals that start in [-π, π) and do not overlap on the circle; ((-π, π),) is every orientation. For
    each elbow the set of φ changes only where a joint reaches a limit or the elbow is straight; these φ have a closed form.
    Raises InvalidInputError for an arm that does not have three links, or limits of a wrong shape or order.
    """
    instance("arm", arm, PlanarArm)
    limits = AngleLimits.of(lower, upper, arm.n)
    family = position_family(arm, position)
    marks = wrapped(np.array(_marks(arm, family.position, limits)))
    pieces: list[Interval] = []
    for begin, end in family.orientations:
        inside = begin + np.mod(marks - begin, 2 * np.pi)
        cuts = np.unique(np.concatenate([[begin, end], inside[inside < end]]))
        for low, high in itertools.pairwise(cuts.tolist() if len(cuts) > 1 else [begin, end]):
            if limits.contain(family(0.5 * (low + high))).any():
                pieces.append((low, high))
        pieces += [(cut, cut) for cut in cuts.tolist() if limits.contain(family(cut)).any()]
    pieces += _fold_interval(arm, family.position, limits)
    return _join(pieces)


def is_reachable(arm: PlanarArm, position: ArrayLike, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> bool:
    """Whether the tool can reach `position` (2,) [m] within joint limits; two or three links.

    Raises InvalidInputError for more links, or limits of a wrong shape or order.
    """
    check_links(arm, 2, 3)
    if arm.n == 2:
        limits, rows = AngleLimits.of(lower, upper, 2), two_link_postures(arm, position)
        if len(rows) and np.hypot(*np.asarray(position)) <= GRAZE * arm.lengths.sum():  # folded: θ_1 is free
            rows[:, 0] = np.where(limits.bounded[0], limits.lower[0], 0.0)
        return bool(limits.contain(rows).any())
    return bool(reachable_orientations(arm, position, lower, upper))


def is_dexterous(arm: PlanarArm, position: ArrayLike, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> bool:
    """Whether a three-link arm can reach every tool orientation at `position` (2,) [m] within joint limits."""
    return any(end - begin >= 2 * np.pi for begin, end in reachable_orientations(arm, position, lower, upper))


def _fold_interval(arm: PlanarArm, target: Array, limits: AngleLimits) -> list[Interval]:
    """The one orientation at which equal links 1 and 2 fold onto each other: θ_1 is free and θ_3 follows from it."""
    slack = GRAZE * arm.lengths.sum()
    if abs(arm.lengths[0] - arm.lengths[1]) > slack or abs(np.hypot(*target) - arm.lengths[2]) > slack:
        return []
    phi = float(np.arctan2(target[1], target[0]))
    # θ_1 in its own range and in the one that θ_3 = φ - π - θ_1 leaves it
    low, high = phi - np.pi - limits.upper[2], phi - np.pi - limits.lower[2]
    free = not (limits.bounded[0] and limits.bounded[2])
    turns = 0.0 if free else np.ceil((limits.lower[0] - ON_LIMIT - high) / (2 * np.pi)) * 2 * np.pi
    straight = np.isfinite(limits.placed(np.full(3, np.pi))[1])
    return [(phi, phi)] if straight and (free or low + turns <= limits.upper[0] + ON_LIMIT) else []


def _marks(arm: PlanarArm, target: Array, limits: AngleLimits) -> list[float]:
    """Orientations at which a joint is on a limit, or the third joint is in line with the base and the tool."""
    l1, l2, l3 = (float(length) for length in arm.lengths)
    direction = float(np.arctan2(target[1], target[0]))
    marks = [direction, direction + np.pi]
    for joint in np.flatnonzero(limits.bounded):
        for end in (float(limits.lower[joint]), float(limits.upper[joint])):
            if joint == 0:
                rows = two_links(l2, l3, target - l1 * np.array([np.cos(end), np.sin(end)]))
                marks += rows.sum(axis=1).tolist()
            elif joint == 1:
                marks += two_links(rigid_part(l1, l2, end)[0], l3, target).sum(axis=1).tolist()
            else:
                part, offset = rigid_part(l2, l3, end)
                marks += (two_links(l1, part, target).sum(axis=1) - offset + end).tolist()
    return marks


def _join(pieces: list[Interval]) -> tuple[Interval, ...]:
    """The union on the circle; intervals that touch become one."""
    turn = 2 * np.pi
    rows: list[list[float]] = []
    shifted = sorted((float(wrapped(low)), float(wrapped(low)) + high - low) for low, high in pieces)
    for low, high in shifted:
        if rows and low <= rows[-1][1] + 1e-9:
            rows[-1][1] = max(rows[-1][1], high)
        else:
            rows.append([low, high])
    while len(rows) > 1 and rows[0][0] + turn <= rows[-1][1] + 1e-9:
        rows[-1][1] = max(rows[-1][1], rows[0][1] + turn)
        rows.pop(0)
    if len(rows) == 1 and rows[0][1] - rows[0][0] >= turn - 1e-9:
        return ((-np.pi, np.pi),)
    return tuple((low, high) for low, high in rows)


#: Distance to each side of an arc at which reachability is tested, as a share of the arm's length.
BESIDE = 1e-6


@dataclass(frozen=True, kw_only=True)
class Annulus:
    """The ring inner <= ‖p‖ <= outer [m] around the base; a disc when inner is 0."""

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
    return _ring(arm.lengths)


def _ring(lengths: Iterable[float]) -> Annulus:
    lengths = list(lengths)
    return Annulus(inner=max(0.0, math.fsum([2 * max(lengths), *(-each for each in lengths)])), outer=math.fsum(lengths))


def dexterous_annuli(arm: PlanarArm) -> tuple[Annulus, ...]:
    """The dexterous workspace W_D (2.6) in kth2012: positions that can be reached with every orientation.

    As φ makes a full turn, the last joint's distance from the base ranges from abs(R - l_n) to R + l_n; this range must lie
    in the ring [a, b] of the first n - 1 links. Hence R <= b - l_n together with R <= l_n - a or R >= l_n + a: an empty set,
    one ring, or a disc and a ring.
    """
    instance("arm", arm, PlanarArm)
    last, *others = arm.lengths[::-1].tolist()
    ring = _ring(others)
    parts = [(0.0, min(ring.outer - last, last - ring.inner)), (last + ring.inner, ring.outer - last)]
    if ring.inner == 0.0:
        parts = [(0.0, ring.outer - last)]  # the two parts touch, or the second is empty
    return tuple(Annulus(inner=low, outer=high) for low, high in parts if low <= high)


@dataclass(frozen=True, kw_only=True, eq=False)
class Arc:
    """A circular arc about `centre` (2,) [m], counter-clockwise from angle `begin` to `end`, at most begin + 2π [rad]."""

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
    check_links(arm, 2, 3)
    arcs = _different(critical_arcs(arm, lower, upper), float(arm.lengths.sum()))
    aside = BESIDE * float(arm.lengths.sum())
    boundary: list[Arc] = []
    for arc in arcs:
        cuts = [arc.begin, arc.end, *(a for other in arcs if other is not arc for a in _crossings(arc, other))]
        for begin, end in itertools.pairwise(sorted(cuts)):
            if (end - begin) * arc.radius <= 4 * aside:
                continue
            piece = Arc(centre=arc.centre, radius=arc.radius, begin=begin, end=end)
            outward = (piece(0.5) - arc.centre) / arc.radius
            beside = (piece(0.5) + sign * aside * outward for sign in (1, -1))
            if not all(is_reachable(arm, side, lower, upper) for side in beside):
                boundary.append(piece)
    return _merge(boundary, 6 * aside)


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
        placed = limits.placed(q)[joint]
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
        is_one_circle = abs(arc.radius - other.radius) <= 1e-9 * arc.radius
        angles = [other.begin, other.end] if is_one_circle else []
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
    different: list[Arc] = []
    for arc in arcs:
        ends = np.concatenate([arc(0.0), arc(0.5), arc(1.0)])
        if all(np.abs(ends - np.concatenate([o(0.0), o(0.5), o(1.0)])).max() > 1e-9 * size for o in different):
            different.append(arc)
    return different


def _merge(pieces: list[Arc], gap: float) -> tuple[Arc, ...]:
    """Joins pieces of one circle that are less than `gap` [m] apart, and drops duplicates."""
    merged: list[Arc] = []
    for piece in sorted(pieces, key=lambda arc: (round(arc.radius, 6), *np.round(arc.centre, 6), arc.begin)):
        share = gap / piece.radius
        for k, other in enumerate(merged):
            if abs(other.radius - piece.radius) + np.abs(other.centre - piece.centre).max() > 1e-9:
                continue
            begin = other.begin + np.mod(piece.begin - other.begin + share, 2 * np.pi) - share
            if begin <= other.end + share:
                end = min(max(other.end, begin + piece.end - piece.begin), other.begin + 2 * np.pi)
                merged[k] = Arc(centre=other.centre, radius=other.radius, begin=other.begin, end=end)
                break
        else:
            merged.append(piece)
    return tuple(merged)
