"""Clearance rows: planes that keep a path on its side of bodies that it comes near.

At a place s of a path, a plane that touches the second of two convex bodies separates them. As long as the first stays
beyond that plane the two are apart, whatever else the arm does: rows built on a free path keep a path free at s. The
planes are renewed on each new path, so they follow it; where it is not free yet, those of the free seed push it out.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel, NearPairs
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import FINE, FINE_DISTANCE, configurations, on_grid
from manipplan.support.checks import Array
from manipplan.support.expressions import making_expressions
from manipplan.symbolic.machine_code import CodedFunctions, as_asked


@dataclass(frozen=True, kw_only=True, eq=False)
class ClearanceRows:
    """Points of the robot that have to stay on their side of planes, each at one place of the path.

    A plane is fixed in the frame of a joint; row: normal · (point - plane) >= distance.

    Attributes:
        s: (r,) places on the path.
        columns: (r, 2 (N + 1) + 8) the other numbers of each row, the second argument of `row_functions`, for a tree of N
            joints: the joint that carries the point and the one that carries the plane (0: the world), one-hot; the point and
            the plane's normal and offset in the frames of these joints; and the minimum distance [m].
    """

    s: Array
    columns: Array

    @classmethod
    def of(
        cls,
        n: int,
        s: Array,
        joints: NDArray[np.int64],
        points: Array,
        others: NDArray[np.int64],
        normals: Array,
        offsets: Array,
        distances: Array,
    ) -> "ClearanceRows":
        """Rows for a tree of n joints, from (r,) or (r, 3) of each number."""
        columns, each = np.zeros((len(s), 2 * (n + 1) + 8)), np.arange(len(s))
        columns[each, joints] = columns[each, n + 1 + others] = 1.0
        columns[:, -8:-5], columns[:, -5:-2], columns[:, -2], columns[:, -1] = points, normals, offsets, distances
        return cls(s=s, columns=columns)


@making_expressions()
def row_functions(kinematics: Kinematics, *, at_once: bool = False) -> CodedFunctions:
    """Signed distance of a clearance row [m], its gradient (n) and Hessian (n, n) in q, one Function each, compiled on request.

    They are first taken by the positions of the N joints of the tree, which are linear in q.

    The second argument is one of `ClearanceRows.columns`. Only joints between the two move the point relative to the plane:
    the sign σ_i is 1 where joint i carries only the point, -1 where it carries only the plane. With c_i the velocity of the
    point as carried by joint i, ∂_i d = σ_i n · c_i, and for i <= j ∂_i ∂_j d = n · (z_i x c_j), or n · (z_j x c_i) for the
    plane. If neither of two joints carries the other, at most one, j, carries the point and one, i, the plane: then it is
    -n · (z_i x c_j).
    """
    chain = kinematics.symbolic.chain
    tree, q, n = chain.tree, chain.q, len(chain.joints) - 1
    carrier, other = ca.SX.sym("carrier", n + 1), ca.SX.sym("other", n + 1)
    point, normal = ca.SX.sym("point", 3), ca.SX.sym("normal", 3)
    offset, keep = ca.SX.sym("offset"), ca.SX.sym("keep")
    position, plane_origin, plane_normal = ca.SX.zeros(3), ca.SX.zeros(3), ca.SX.zeros(3)
    for k, placement in enumerate(chain.joints):
        position += carrier[k] * (placement.origin + placement.rotation @ point)
        plane_origin += other[k] * placement.origin
        plane_normal += other[k] * (placement.rotation @ normal)
    distance = ca.dot(plane_normal, position - plane_origin) - offset - keep

    carries = tree.carries
    spin, velocity, sign = [], [], []
    for i in range(1, n + 1):
        axis = chain.joints[i].rotation @ ca.DM(tree.axes[i - 1])
        slides = tree.slides[i - 1]
        spin.append(ca.SX.zeros(3) if slides else axis)
        velocity.append(axis if slides else ca.cross(axis, position - chain.joints[i].origin))
        above = np.flatnonzero(carries[:, i]).tolist()
        sign.append(ca.sum1(carrier[above]) - ca.sum1(other[above]))
    gradient = ca.vertcat(*(sign[i] * ca.dot(plane_normal, velocity[i]) for i in range(n)))
    hessian = ca.SX.zeros(n, n)
    for j in range(n):
        for i in range(j + 1):
            both = sign[i] * sign[j] / 2
            first, second = (i, j) if carries[j + 1, i + 1] else (j, i)
            bend = both * ca.dot(
                plane_normal,
                (1 + sign[i]) * ca.cross(spin[first], velocity[second])
                + (1 - sign[i]) * ca.cross(spin[second], velocity[first]),
            )
            hessian[i, j] = hessian[j, i] = bend
    if tree.has_followers:
        led = ca.SX(ca.sparsify(ca.DM(tree.matrix)))
        gradient, hessian = led.T @ gradient, led.T @ hessian @ led
    column = ca.vertcat(carrier, other, point, normal, offset, keep)
    functions = [
        ca.Function("path_row", [q, column], [distance]),
        ca.Function("path_row_gradient", [q, column], [ca.densify(gradient)]),
        ca.Function("path_row_hessian", [q, column], [ca.densify(hessian)]),
    ]
    subject = f"clearance rows of paths of {kinematics.robot.name}"
    return as_asked(functions, kinematics.compiled, subject, at_once=at_once)


#: Number of intervals of a path at whose ends all distances are measured.
DISTANCE_INTERVALS = 160
#: A pair gets rows where its distance has a dip below the clearance plus this [m].
NEAR = 0.03
#: Margin of rows above the required clearance, to cover the path between places [m].
SPARE = 0.003
#: Maximum number of places at which clearance rows are added per round, the deepest dips first.
NEW_PLACES = 10
#: Maximum number of places with rows per solve, those where pairs are nearest.
MOST_PLACES = 60
#: If there are more and no free path is known yet, only places where pairs are nearer than the clearance plus this [m] get
#: rows: nine of ten rows of a long search are further away, and most of a solve's time is the factorisation of all of them.
FAR = 0.1
#: Distance in s of the places that are added on either side of a dip.
REACH = 0.02
#: New places closer in s than this to one of the same pair are not added.
APART = 0.4 * REACH
#: The same after a path touched something between places that far apart.
CLOSE = 0.05 * REACH
#: Number of points per body that are kept on their side of a plane: those nearest to it.
POINTS = 2

Place = tuple[float, int]


def distance_profile(model: CollisionModel, q: Array, beyond: float | Array) -> NearPairs:
    """The pairs nearer than `beyond`, a number or (m,), at the configurations q (m, n) along a path [m]."""
    found = model.near_pairs(on_grid(q, FINE), beyond)
    return replace(found, distances=on_grid(found.distances, FINE_DISTANCE))


def dips(profile: NearPairs, near: float) -> list[Place]:
    """Places inside an evenly sampled path where a pair's distance has a local minimum below `near`, deepest first."""
    s = np.linspace(0.0, 1.0, profile.shape[0])
    before, after = profile.beside(np.inf)
    inside = (profile.rows > 0) & (profile.rows < profile.shape[0] - 1)
    low = np.flatnonzero(inside & (profile.distances <= before) & (profile.distances < after) & (profile.distances < near))
    found = low[np.argsort(profile.distances[low], kind="stable")]
    return [(float(s[profile.rows[k]]), int(profile.pairs[k])) for k in found]


def around(places: Iterable[Place]) -> list[Place]:
    """Each place with one on either side of it, so that a path cannot slip past a single row."""
    return [(s + step, pair) for s, pair in places for step in (0.0, -REACH, REACH) if 0 < s + step < 1]


def merged(old: Iterable[Place], new: Iterable[Place], apart: float = APART) -> list[Place]:
    """Old places, and the new ones that are more than `apart` from every place of the same pair."""
    places = list(old)
    for s, pair in new:
        if all(other != pair or abs(s - place) > apart for place, other in places):
            places.append((s, pair))
    return places


def more_places(
    places: tuple[Place, ...], profile: NearPairs, failed_at: tuple[Place, ...], clearance: float, *, is_free: bool
) -> tuple[Place, ...]:
    """The places, with those around the place where the proof failed, and around the deepest dips below the clearance [m].

    The dips are those of the distance profile. If that adds no place although the path is not free, closer places
    are allowed, then dips up to SPARE above the clearance.
    """
    attempts = [(0.0, APART)]
    if not is_free:
        attempts += [(0.0, CLOSE), (SPARE, APART), (SPARE, CLOSE)]
    for spare, apart in attempts:
        deepest = [*failed_at, *dips(profile, clearance + spare)][:NEW_PLACES]
        more = merged(places, around(deepest), apart)
        if len(more) > len(places):
            return tuple(more)
    return places


def nearest(model: CollisionModel, path: JointPath, places: Sequence[Place], *, most: float = np.inf) -> tuple[Place, ...]:
    """All places; if there are more than MOST_PLACES, the nearest on `path` whose distance is at most `most` [m]."""
    if len(places) <= MOST_PLACES:
        return tuple(places)
    at = configurations(path, [s for s, _ in places])
    distances = model.pair_distances(at, [pair for _, pair in places])
    chosen = np.argsort(on_grid(distances, FINE_DISTANCE), kind="stable")[:MOST_PLACES]
    return tuple(places[k] for k in sorted(chosen) if distances[k] <= most)


def rows_for(
    model: CollisionModel, path: JointPath, safe: Callable[[float], Array], places: Sequence[Place], clearance: float
) -> ClearanceRows | None:
    """Rows at the given places: with the planes of `path` where it is free there, else with those of the safe path.

    `safe` gives the configuration (n,) of a collision-free path at s. None without places.
    """
    if not places:
        return None
    s, pairs = np.array([s for s, _ in places]), [pair for _, pair in places]
    q = configurations(path, s)
    found = model.witnesses(q, pairs)
    normals, opposites, offsets = found.normals.copy(), found.opposites.copy(), found.offsets.copy()
    overlaps = np.flatnonzero(found.distances <= 0).tolist()
    if overlaps:
        safe_q = np.array([on_grid(safe(places[k][0]), FINE) for k in overlaps])
        free = model.witnesses(safe_q, [pairs[k] for k in overlaps])
        normals[overlaps], offsets[overlaps] = free.normals, free.offsets
        for k, normal in zip(overlaps, free.normals, strict=True):
            first, second = found.joints[k]
            opposites[k] = -model.turned(q[k], normal, int(second), int(first))
    points, owners, distances = [], [], []
    for k, pair in enumerate(pairs):
        core, radius = model.core(pair)
        heights = np.round(core @ -opposites[k], 9)  # so that rounding errors do not change the order
        nearest_points = core[np.argsort(heights, kind="stable")[:POINTS]]
        points.append(nearest_points)
        owners += [k] * len(nearest_points)
        distances += [radius + clearance + SPARE] * len(nearest_points)
    first, second = found.joints[owners].T
    all_points, n = np.concatenate(points), model.robot.model.njoints - 1
    return ClearanceRows.of(n, s[owners], first, all_points, second, normals[owners], offsets[owners], np.array(distances))
