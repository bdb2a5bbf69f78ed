"""Positions and orientations that a two- or three-link arm reaches within joint limits, exact at each position."""

import itertools

import numpy as np
from numpy.typing import ArrayLike

from manipplan.planar.arm import PlanarArm
from manipplan.planar.inverse import GRAZE, position_family, two_link_postures, two_links, wrapped
from manipplan.planar.limits import ON_LIMIT, AngleLimits
from manipplan.support.checks import Array, instance
from manipplan.support.errors import InvalidInputError

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
    pieces += _folded(arm, family.position, limits)
    return _joined(pieces)


def is_reachable(arm: PlanarArm, position: ArrayLike, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> bool:
    """Whether the tool can reach `position` (2,) [m] within joint limits; two or three links.

    Raises InvalidInputError for more links, or limits of a wrong shape or order.
    """
    instance("arm", arm, PlanarArm)
    check_few_links(arm)
    if arm.n == 2:
        limits, rows = AngleLimits.of(lower, upper, 2), two_link_postures(arm, position)
        if len(rows) and np.hypot(*np.asarray(position)) <= GRAZE * arm.lengths.sum():  # folded: θ_1 is free
            rows[:, 0] = np.where(limits.bounded[0], limits.lower[0], 0.0)
        return bool(limits.contain(rows).any())
    return bool(reachable_orientations(arm, position, lower, upper))


def is_dexterous(arm: PlanarArm, position: ArrayLike, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> bool:
    """Whether a three-link arm can reach every tool orientation at `position` (2,) [m] within joint limits."""
    instance("arm", arm, PlanarArm)
    return any(end - begin >= 2 * np.pi for begin, end in reachable_orientations(arm, position, lower, upper))


def check_few_links(arm: PlanarArm) -> None:
    """Raises InvalidInputError for more than three links."""
    if not isinstance(arm, PlanarArm) or arm.n > 3:
        raise InvalidInputError("arm", arm, "a PlanarArm with two or three links")


def _folded(arm: PlanarArm, target: Array, limits: AngleLimits) -> list[Interval]:
    """The one orientation at which equal links 1 and 2 fold onto each other: θ_1 is free and θ_3 follows from it."""
    slack = GRAZE * arm.lengths.sum()
    if abs(arm.lengths[0] - arm.lengths[1]) > slack or abs(np.hypot(*target) - arm.lengths[2]) > slack:
        return []
    phi = float(np.arctan2(target[1], target[0]))
    # θ_1 in its own range and in the one that θ_3 = φ - π - θ_1 leaves it
    low, high = phi - np.pi - limits.upper[2], phi - np.pi - limits.lower[2]
    free = not (limits.bounded[0] and limits.bounded[2])
    turns = 0.0 if free else np.ceil((limits.lower[0] - ON_LIMIT - high) / (2 * np.pi)) * 2 * np.pi
    straight = AngleLimits(lower=limits.lower[1:2], upper=limits.upper[1:2]).contain([np.pi])
    return [(phi, phi)] if straight and (free or low + turns <= limits.upper[0] + ON_LIMIT) else []


def _marks(arm: PlanarArm, target: Array, limits: AngleLimits) -> list[float]:
    """Orientations at which a joint is on a limit, or the third joint is in line with the base and the tool."""
    l1, l2, l3 = (float(length) for length in arm.lengths)
    direction = float(np.arctan2(target[1], target[0]))
    marks = [direction, direction + np.pi]
    for joint in np.flatnonzero(limits.bounded):
        for end in (float(limits.lower[joint]), float(limits.upper[joint])):
            c, s = np.cos(end), np.sin(end)
            if joint == 0:
                rows = two_links(l2, l3, target - l1 * np.array([c, s]))
                marks += rows.sum(axis=1).tolist()
            elif joint == 1:  # links 1 and 2 as one rigid part
                part = float(np.hypot(l1 + l2 * c, l2 * s))
                marks += two_links(part, l3, target).sum(axis=1).tolist()
            else:
                part, offset = np.hypot(l2 + l3 * c, l3 * s), np.arctan2(l3 * s, l2 + l3 * c)
                rows = two_links(l1, float(part), target)
                marks += (rows.sum(axis=1) - offset + end).tolist()
    return marks


def _joined(pieces: list[Interval]) -> tuple[Interval, ...]:
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
