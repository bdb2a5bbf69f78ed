"""Clearance rows for the path program: where a path comes near something, planes that keep it on its side.

At a place s of a path, two convex bodies have a plane between them that touches the second. As long as the first stays
beyond that plane the two are apart, whatever else the arm does: rows built on a free path keep a path free at s. The
planes are renewed on each new path, so they follow it; where it is not free yet, those of the free seed push it out.
"""

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from manipplan.checks import Array
from manipplan.optimize.rounding import FINE, FINE_DISTANCE, configurations, on_grid
from manipplan.optimize.rows import ClearanceRow
from manipplan.paths.joint import JointPath
from manipplan.robots.collision import CollisionModel

#: Places along a path at which all distances are looked at.
PLACES = 160
#: A pair is watched where its distance has a dip below this [m].
NEAR = 0.03
#: Rows ask for this much more than the demanded clearance, for what happens between places [m].
SPARE = 0.003
#: Rows are made at so many places a solve at most, those where pairs are nearest.
MOST_PLACES = 60
#: Where there are more and no free path is known yet, only where pairs are nearer than this [m]: of the rows of a long search
#: nine of ten are further off, and most of a solve's time is the factorisation of all of them.
FAR = 0.1
#: Distance in s of the places that are added on either side of a dip.
REACH = 0.02
#: New places nearer in s than this to one of the same pair are not added.
APART = 0.4 * REACH
#: The same once a path touches something between places that far apart.
CLOSE = 0.05 * REACH
#: Points of a body that are kept on their side of a plane: those nearest to it.
POINTS = 2

Place = tuple[float, int]


def distance_profile(model: CollisionModel, q: Array) -> Array:
    """Distance of every pair (m, k) [m] at each of the configurations q (m, n)."""
    return on_grid(np.array([model.distances(each) for each in on_grid(q, FINE)]), FINE_DISTANCE)


def dips(distances: Array, near: float) -> list[Place]:
    """Places inside an evenly sampled path where a pair's distance has a local minimum below `near`, deepest first."""
    s = np.linspace(0.0, 1.0, len(distances))
    inner = distances[1:-1]
    low = (inner <= distances[:-2]) & (inner < distances[2:]) & (inner < near)
    found = sorted(zip(*np.nonzero(low), strict=True), key=lambda at: inner[at])
    return [(float(s[k + 1]), int(pair)) for k, pair in found]


def around(places: Iterable[Place]) -> list[Place]:
    """Each place with one on either side of it, so that a path cannot slip past a single row."""
    return [(s + step, pair) for s, pair in places for step in (0.0, -REACH, REACH) if 0 < s + step < 1]


def merged(old: Iterable[Place], new: Iterable[Place], apart: float = APART) -> list[Place]:
    """Old places and those of the new ones that are more than `apart` from each one of the same pair."""
    places = list(old)
    for s, pair in new:
        if all(other != pair or abs(s - place) > apart for place, other in places):
            places.append((s, pair))
    return places


def nearest(model: CollisionModel, path: JointPath, places: Sequence[Place], *, most: float = np.inf) -> tuple[Place, ...]:
    """All places, or where they are more than MOST_PLACES, the nearest of them on `path` that are not beyond `most` [m]."""
    if len(places) <= MOST_PLACES:
        return tuple(places)
    at = configurations(path, [s for s, _ in places])
    distances = np.array([model.contact(q, pair).distance for q, (_, pair) in zip(at, places, strict=True)])
    chosen = np.argsort(on_grid(distances, FINE_DISTANCE), kind="stable")[:MOST_PLACES]
    return tuple(places[k] for k in sorted(chosen) if distances[k] <= most)


def rows_for(
    model: CollisionModel, path: JointPath, safe: Callable[[float], Array], places: Sequence[Place], clearance: float
) -> list[ClearanceRow]:
    """Rows at the given places: with the planes of `path` where it is free there, else with those of the safe path.

    `safe` gives the configuration (n,) of a collision-free path at s.
    """
    rows = []
    for (s, pair), q in zip(places, configurations(path, [s for s, _ in places]), strict=True):
        contact = model.contact(q, pair)
        if contact.distance <= 0:
            contact = model.contact(on_grid(safe(s), FINE), pair)
        for point in model.nearest_points(q, contact, POINTS):
            rows.append(
                ClearanceRow(
                    s=s,
                    joint=contact.first,
                    point=point,
                    other=contact.second,
                    normal=contact.normal,
                    offset=contact.offset,
                    distance=contact.radius + clearance + SPARE,
                )
            )
    return rows
