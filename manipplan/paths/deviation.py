"""Deviation: how far the tool leaves a workspace path, measured independently of how the motion was computed."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from manipplan.paths.cartesian import RADIAN, CartesianPath, neighbourhood, turns_between
from manipplan.paths.tolerance import Tolerance, with_defaults
from manipplan.support.checks import Array, instance
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.free_motion import NOTHING, BoundedMotion, FreeMotion, Turns, rotation_vectors, rotations_of

#: Number of poses on the path.
POSES = 2001
#: Number of poses between two knots of a path at least, and of poses of a path that may be the nearest one.
BETWEEN_KNOTS, CANDIDATES = 4, 32
#: Largest distance of a path from its pieces at their middle [m, rad], and maximum number of times that they are halved for it.
FLAT, BENDS = (1e-6, 1e-5), 4
#: Largest numbers of pieces with regions about them that a pose is compared with closely, first and then, number of places on
#: each, largest number of rounds of closer places, and share of the tolerance to which the nearest place is found.
MANY_PIECES, NEAREST_PIECES, CLOSE, ROUNDS, CLOSELY_FOUND = 24, 3, 9, 4, 1 / 64
#: Every which pose is compared with all pieces; number of pieces beyond those of two such poses, and between them, that poses
#: between are compared with.
ANCHORS, BEYOND, FEW = 48, 16, 400
#: Number of places on a piece at which a pose outside the tolerance is compared with it.
SHARES = 33
#: Distance from the neighbourhood of a polygon that counts as beside [m].
BESIDE = 1e-3
#: Number of tool poses compared at a time, of pairs of a pose and a piece, and of pairs of which distances are estimated.
BLOCK, PAIRS, MOST_PAIRS = 256, 10_000, 1_000_000
#: Largest number of pieces with which a pose outside the tolerance is compared closely, and rounding of distances [m, rad].
CLOSELY, ROUNDING = 128, 1e-7


@dataclass(frozen=True, kw_only=True)
class Deviation:
    """The largest distances of a tool from a path.

    Attributes:
        position: [m]; `position_at` is where it occurs, as a fraction of the samples.
        rotation: [rad], of what counts of the tool's rotation, 0 where nothing does; `rotation_at` is where it occurs.
    """

    position: float
    position_at: float
    rotation: float
    rotation_at: float

    def excess(self, tolerance: Tolerance, of: str) -> str:
        """Which part of a tolerance is exceeded, and after which share `of` what; "" if it is kept."""
        instance("tolerance", tolerance, Tolerance)
        for name, value, limit, unit, at in (
            ("position", self.position, tolerance.position, "m", self.position_at),
            ("rotation", self.rotation, tolerance.rotation, "rad", self.rotation_at),
        ):
            if limit is not None and value > limit:
                where = f"the tool's {name} leaves the path by {value:.3g} {unit} after {at:.2f} of the {of}"
                return f"{where}; allowed: {limit:g} {unit}"
        return ""

    def __str__(self) -> str:
        return f"at most {1e3 * self.position:.3g} mm and {np.rad2deg(self.rotation):.2g}° from the path"


def deviation_from(path: CartesianPath, poses: Array, free: FreeMotion = NOTHING) -> Deviation:
    """Deviation of tool poses (k, 4, 4) from a path, regardless of time, but for what is free."""
    return largest_deviation(_shares(len(poses)), *deviations(path, poses, free))


def deviations(
    path: CartesianPath, poses: Array, free: FreeMotion = NOTHING, tolerance: Tolerance | None = None
) -> tuple[Array, Array]:
    """Distances [m] and angles [rad], (k,) each, of tool poses (k, 4, 4) from a path, as in `deviation_from`.

    Each pose is compared with the nearest of at least 2000 pieces of the path, whose knots are all ends of pieces, and which
    are shorter where the path bends. Nearest is what has the smallest sum of distance and angle: with a tolerance of both, as
    shares of it, and where that is outside, what is within or exceeds it by the smallest factor; else 1 rad counts as 10 cm.
    """
    if not len(poses):
        raise InvalidInputError("poses", f"an array of shape {poses.shape}", "at least one pose (4, 4)")
    counts = np.maximum(BETWEEN_KNOTS, np.ceil((POSES - 1) * np.diff(path.knots)).astype(np.int64))
    ends = np.concatenate([[0], np.cumsum(counts)])
    return distances_from(_bent(path, np.interp(np.arange(ends[-1] + 1), ends, path.knots)), poses, free, tolerance)


def _bent(path: CartesianPath, s: Array) -> Array:
    """The poses (k, 4, 4) of a path at s (j,), and between them where its middle is farther than FLAT from straight pieces."""
    line = path(s)
    for _ in range(BENDS):
        middle = path((s[:-1] + s[1:]) / 2)
        position, rotation = _from_piece(middle, line[:-1], line[1:], NOTHING)
        wide = np.flatnonzero((position > FLAT[0]) | (rotation > FLAT[1]))
        if not len(wide):
            break
        s = np.insert(s, wide + 1, (s[wide] + s[wide + 1]) / 2)
        line = np.insert(line, wide + 1, middle[wide], axis=0)
    return line


def beyond_polygon(
    given: Array, poses: Array, free: FreeMotion = NOTHING, tolerance: Tolerance | None = None
) -> tuple[Array, Array]:
    """How far poses (k, 4, 4) are outside the neighbourhood of the polygon of given ones (n, 4, 4): [m] and [rad], (k,) each.

    The neighbourhood of a piece between two given poses is as wide as a path through them may be: `NEAR` times the longest of
    the piece and its two neighbours, or of their angles. Positions and rotations on a piece are compared on their own. Of
    several pieces that counts whose neighbourhood is left the least, and outside the tolerance, in shares of it.
    """
    if isinstance(free, BoundedMotion) or (free.in_tool and len(free.shifts)):
        return _beyond_region(given, poses, free, tolerance, widen=True)
    turns, sizes, middles = _pieces_of(given)
    room = neighbourhood(sizes)
    blocks = [slice(begin, begin + BLOCK) for begin in range(0, len(poses), BLOCK)]
    first = np.concatenate([_nearest(poses[each], given, free)[0] for each in blocks])
    pieces = np.clip(np.concatenate([first - 1, first, first + 1]), 0, len(turns) - 1)
    position, rotation = _beyond_pieces(np.tile(np.arange(len(poses)), 3), pieces, given, room, poses, free)
    # a pose outside the neighbourhoods of the nearest pieces is compared with all that may be nearer than BESIDE, or with all
    outside = np.flatnonzero(position + RADIAN * rotation > 0)
    step = max(1, MOST_PAIRS // len(turns))

    def compare(some: NDArray[np.intp], near: NDArray[np.bool_] | None = None, allowed: Array | None = None) -> None:
        rows, pieces = np.nonzero(np.ones((len(some), len(turns))) if near is None else near)
        position[some], rotation[some] = _beyond_pieces(rows, pieces, given, room, poses[some], free, allowed)

    for some in (outside[begin : begin + step] for begin in range(0, len(outside), step)):
        compare(some, _least_beyond(middles, sizes, room, poses[some], free) <= BESIDE)
        compare(some[~(position[some] + RADIAN * rotation[some] <= BESIDE)])
    allowed = _allowed(tolerance)
    outside = np.flatnonzero((np.stack([position, rotation], axis=1) > allowed).any(axis=1))
    for some in (outside[begin : begin + step] for begin in range(0, len(outside), step)):
        compare(some, allowed=allowed)
    return position, rotation


def _allowed(tolerance: Tolerance | None) -> Array:
    """The largest distance and angle (2,) of a tolerance [m, rad]; inf where it allows any."""
    parts = (None, None) if tolerance is None else (tolerance.position, tolerance.rotation)
    return np.array([np.inf if part is None else part for part in parts])


def _pieces_of(line: Array) -> tuple[Array, Array, Array]:
    """Of the pieces between poses of a line (m, 4, 4): turns (m - 1, 3), sizes (2, m - 1) [m, rad], poses at the middle."""
    turns = turns_between(line)
    sizes = np.linalg.norm([np.diff(line[:, :3, 3], axis=0), turns], axis=2)
    return turns, sizes, _along(line, turns, np.arange(len(turns)), np.full(len(turns), 0.5))


def _beyond_region(
    line: Array, poses: Array, free: FreeMotion, tolerance: Tolerance | None, *, widen: bool = False, is_reached: bool = False
) -> tuple[Array, Array]:
    """How far poses (k, 4, 4) are outside the regions about the pieces between poses of a line (m, 4, 4): [m] and [rad], (k,).

    Of each pose the place counts that it exceeds by the smallest sum of shares of the tolerance, and where that is outside, by
    the smallest factor. Every ANCHORS-th is compared with all pieces, those between with the pieces between its two, and where
    that leaves more than half of the tolerance with all. With `is_reached` the line is the tool's way, and the regions are
    those about the poses. With `widen` the neighbourhoods of the pieces count as they do for `beyond_polygon`.
    """
    pieces = _RegionPieces(line, free, with_defaults(tolerance), widen=widen, is_reached=is_reached)
    count, every = len(poses), np.arange(len(line) - 1)
    found, near = np.empty((count, 2)), np.empty(count, dtype=np.int64)
    anchors = np.unique(np.append(np.arange(0, count, ANCHORS), count - 1))
    for k in anchors:
        found[k], near[k] = pieces.compare_all(poses[k])
    for first, last in pairwise(anchors):
        between = slice(first + 1, last)
        low, high = sorted((near[first], near[last]))
        window = every[max(low - BEYOND, 0) : high + BEYOND] if high - low < FEW else every
        if first + 1 < last:
            found[between], _ = pieces.compare(poses[between], window)
            for k in first + 1 + np.flatnonzero((found[between] > pieces.allowed / 2).any(axis=1)):
                found[k], _ = pieces.compare_all(poses[k])
    for k in np.flatnonzero((found > pieces.allowed).any(axis=1)):
        found[k], _ = pieces.compare_all(poses[k], by=_worst_share)
    return found[:, 0], found[:, 1]


def _sum_of_shares(found: Array, allowed: Array) -> Array:
    """The sum of the shares of a distance and an angle (..., 2) of what is allowed (2,)."""
    return np.asarray((found / allowed).sum(axis=-1))


def _worst_share(found: Array, allowed: Array) -> Array:
    """The larger share of a distance and an angle (..., 2) of what is allowed (2,); of equal ones the nearest is the least."""
    shares = found / allowed
    return np.asarray(shares.max(axis=-1) + 1e-6 * shares.sum(axis=-1))


class _RegionPieces:
    """The pieces between poses of a line (m, 4, 4), to compare poses with; arguments as in `_beyond_region`."""

    def __init__(self, line: Array, free: FreeMotion, tolerance: Tolerance, *, widen: bool, is_reached: bool) -> None:
        self.line, self.free, self.widen, self.is_reached = line, free, widen, is_reached
        self.allowed = np.array([tolerance.position, tolerance.rotation], dtype=np.float64)
        self.turns, sizes, self.middles = _pieces_of(line)
        self.room = neighbourhood(sizes) if widen else np.zeros_like(sizes)
        self.half = sizes / 2 + self.room

    def compare(self, poses: Array, pieces: NDArray[np.int64]) -> tuple[Array, NDArray[np.int64]]:
        """How far poses (k, 4, 4) are outside the best of `pieces` (j,), (k, 2), and which it is, (k,)."""
        least, ranks, middle = self._least(poses, pieces, _sum_of_shares)
        may_be = int((least <= middle.min(axis=1)[:, None]).sum(axis=1).max())
        return self._closely(poses, pieces[np.argsort(ranks, axis=1)[:, : min(may_be, MANY_PIECES)]], _sum_of_shares)

    def compare_all(self, pose: Array, by: Callable[[Array, Array], Array] = _sum_of_shares) -> tuple[Array, int]:
        """How far a pose (4, 4) is outside the best of all pieces by a measure, (2,), and which it is."""
        least, ranks, _ = (each[0] for each in self._least(pose[None], np.arange(len(self.turns)), by))
        order, found, best = np.argsort(ranks), np.full(2, np.inf), 0
        for begin, end in pairwise([0, *range(MANY_PIECES, len(order), BLOCK), len(order)]):
            if (found <= self.allowed / 4).all() or by(found, self.allowed) <= least[order[begin]]:
                break
            own, piece = self._closely(pose[None], order[None, begin:end], by)
            if by(own[0], self.allowed) < by(found, self.allowed):
                found, best = own[0], int(piece[0])
        return found, best

    def _least(
        self, poses: Array, pieces: NDArray[np.int64], by: Callable[[Array, Array], Array]
    ) -> tuple[Array, Array, Array]:
        """The least that any place on pieces (j,) can leave of poses (k, 4, 4), (k, j), by shares of what is allowed.

        Also ranks (k, j) by which, of equal ones, those come first whose middle leaves less, and what the middles leave (k, j).
        """
        excess = self._excess(np.repeat(poses, len(pieces), axis=0), self.middles[np.tile(pieces, len(poses))])
        middle = excess.reshape(2, len(poses), -1)
        half = np.repeat(self.half[:, None, pieces], len(poses), axis=1)
        if self.free.in_tool:  # the directions of shifts turn along a piece
            reach = np.linalg.norm(poses[:, None, :3, 3] - self.middles[pieces, :3, 3], axis=2)
            half[0] += reach * (self.half - self.room)[1, pieces]
        least = by(np.moveaxis(np.maximum(middle - half, 0.0), 0, 2), self.allowed)
        of_middle = by(np.moveaxis(middle, 0, 2), self.allowed)
        return least, least + 1e-6 * of_middle, of_middle

    def _closely(
        self, poses: Array, chosen: NDArray[np.int64], by: Callable[[Array, Array], Array]
    ) -> tuple[Array, NDArray[np.int64]]:
        """How far poses (k, 4, 4) are outside the best of pieces chosen (k, j), (k, 2), and which it is, (k,)."""
        count = len(poses)
        share, width, least = np.full(chosen.shape, 0.5), 0.5, np.full((2, *chosen.shape), np.inf)
        largest = float(((self.half - self.room)[:, chosen].max(axis=(1, 2)) / self.allowed).max())
        for _ in range(ROUNDS):  # closer and closer about the best places of the best pieces
            piece, row = np.repeat(chosen.ravel(), CLOSE), np.repeat(np.arange(count), chosen.shape[1] * CLOSE)
            close = np.clip(share[..., None] + width * np.linspace(-1.0, 1.0, CLOSE), 0.0, 1.0)
            excess = self._excess(poses[row], _along(self.line, self.turns, piece, close.ravel()))
            excess = np.maximum(excess - self.room[:, piece], 0.0).reshape(2, *close.shape)
            worth = by(np.moveaxis(excess, 0, 3), self.allowed)
            place = worth.argmin(axis=2)[..., None]
            order = np.argsort(np.take_along_axis(worth, place, axis=2)[..., 0], axis=1, kind="stable")[:, :NEAREST_PIECES]
            share = np.take_along_axis(np.take_along_axis(close, place, axis=2)[..., 0], order, axis=1)
            # beside a polygon position and rotation are each compared on their own
            own = np.take_along_axis(excess, place[None], axis=3)[..., 0] if not self.widen else excess.min(axis=3)
            least = np.take_along_axis(np.minimum(least, own) if self.widen else own, order[None], axis=2)
            chosen = np.take_along_axis(chosen, order, axis=1)
            if width * largest <= 4 * CLOSELY_FOUND:  # half the distance between two places
                break
            width *= 2 / (CLOSE - 1)
        return least[:, :, 0].T, chosen[:, 0]

    def _excess(self, poses: Array, there: Array) -> Array:
        return np.array(distances_between(*((there, poses) if self.is_reached else (poses, there)), self.free))


def _along(line: Array, turns: Array, pieces: NDArray[np.intp], shares: Array) -> Array:
    """The poses (k, 4, 4) at shares (k,) of pieces (k,) between poses of a line (m, 4, 4), which turn by `turns` (m - 1, 3)."""
    poses = line[pieces].copy()
    poses[:, :3, 3] += shares[:, None] * (line[pieces + 1, :3, 3] - line[pieces, :3, 3])
    poses[:, :3, :3] = poses[:, :3, :3] @ rotations_of(shares[:, None] * turns[pieces])
    return poses


def _least_beyond(middles: Array, sizes: Array, room: Array, poses: Array, free: FreeMotion) -> Array:
    """Lower bounds (k, n - 1) on how far poses (k, 4, 4) are outside the neighbourhoods of pieces [m], angles counted in."""
    position, angle = _apart(poses, middles, free)
    least = np.maximum(position - sizes[0] / 2 - room[0], 0.0)
    return np.asarray(least + RADIAN * np.maximum(angle - sizes[1] / 2 - room[1], 0.0))


def _beyond_pieces(
    rows: NDArray[np.intp],
    pieces: NDArray[np.intp],
    given: Array,
    room: Array,
    poses: Array,
    free: FreeMotion,
    allowed: Array | None = None,
) -> tuple[Array, Array]:
    """How far poses (k, 4, 4) are outside the nearest neighbourhood of pieces (p,), each paired with one of `rows` (p,).

    In [m] and [rad], (k,) each; inf where there is none. Nearest is what is left the least, in shares of `allowed` if given.
    """
    found = np.empty((2, len(rows)))
    for begin in range(0, len(rows), PAIRS):
        row, piece = rows[begin : begin + PAIRS], pieces[begin : begin + PAIRS]
        position, _ = _from_piece(poses[row], given[piece], given[piece + 1], free, radian=0.0)
        _, rotation = _from_piece(poses[row], given[piece], given[piece + 1], free, radian=1e6)
        found[:, begin : begin + PAIRS] = np.maximum(np.array([position, rotation]) - room[:, piece], 0.0)
    order = np.lexsort((found[0] + RADIAN * found[1] if allowed is None else _worst_share(found.T, allowed), rows))
    own, first = np.unique(rows[order], return_index=True)
    least = np.full((2, len(poses)), np.inf)
    least[:, own] = found[:, order[first]]
    return least[0], least[1]


def distances_from(
    line: Array, poses: Array, free: FreeMotion = NOTHING, tolerance: Tolerance | None = None, *, is_reached: bool = False
) -> tuple[Array, Array]:
    """Distances [m] and angles [rad], (k,) each, of poses (k, 4, 4) from the pieces between the poses of a line (m, 4, 4).

    `is_reached`: the line is the tool's way, and the poses are those about which a region counts; else it is the other way.
    """
    position, rotation = np.empty(len(poses)), np.empty(len(poses))
    radian = RADIAN
    if isinstance(free, BoundedMotion) or (is_reached and free.in_tool and len(free.shifts)):
        return _beyond_region(line, poses, free, tolerance, is_reached=is_reached)
    if tolerance is not None and tolerance.position is not None and tolerance.rotation is not None:
        radian = tolerance.position / tolerance.rotation
    for begin in range(0, len(poses), BLOCK):
        some = poses[begin : begin + BLOCK]
        first, other = _nearest(some, line, free, radian)
        pieces = np.clip([first - 1, first, first + 1, other - 1, other, other + 1], 0, len(line) - 2)
        k, each = pieces.ravel(), np.tile(some, (len(pieces), 1, 1))
        found = np.array(_from_piece(each, line[k], line[k + 1], free, radian)).reshape(2, *pieces.shape).swapaxes(0, 1)
        best = (found[:, 0] + radian * found[:, 1]).argmin(axis=0)
        own = found[best, :, np.arange(len(some))]
        if tolerance is not None:
            allowed = _allowed(tolerance)
            outside = np.flatnonzero((own > allowed).any(axis=1))
            if len(outside):
                found = _least_excess(allowed, line, some[outside], free)
                nearer = (found / allowed).max(axis=1) < (own[outside] / allowed).max(axis=1)
                own[outside] = np.where(nearer[:, None], found, own[outside])
        position[begin : begin + BLOCK], rotation[begin : begin + BLOCK] = own.T
    return position, rotation


def _least_excess(allowed: Array, line: Array, poses: Array, free: FreeMotion) -> Array:
    """Distances and angles (k, 2) of poses (k, 4, 4) from where on a line (m, 4, 4) they exceed `allowed` (2,) the least.

    A piece is compared closely if its middle less its half size may be better than the best middle, at most CLOSELY of a pose.
    """
    _, sizes, middles = _pieces_of(line)
    apart = np.array(_apart(poses, middles, free))
    half = np.repeat(sizes[:, None] / 2, len(poses), axis=1) + ROUNDING
    if free.in_tool and len(free.shifts):  # the directions of shifts turn along a piece
        half[0] += half[1] * np.sqrt(_squares(poses[:, :3, 3], middles[:, :3, 3]))
    at_middle = _worst_share(np.moveaxis(apart, 0, 2), allowed)
    may_be = _worst_share(np.moveaxis(np.maximum(apart - half, 0.0), 0, 2), allowed) <= at_middle.min(axis=1)[:, None]
    by_both = at_middle + 1e-3 * (apart / allowed[:, None, None]).sum(axis=0)
    order = np.argsort(np.where(may_be, by_both, np.inf), axis=1)[:, :CLOSELY]
    row, column = np.nonzero(np.take_along_axis(may_be, order, axis=1))
    piece = order[row, column]
    start, along, offset, turn = _on_pieces(poses[row], line[piece], line[piece + 1], free)
    best, least = np.full((len(row), 2), np.inf), np.full(len(row), np.inf)
    for share in np.linspace(0.0, 1.0, SHARES):
        angles = _angles(poses[row, :3, :3], start @ rotations_of(share * turn), free)
        found = np.column_stack([np.linalg.norm(offset - share * along, axis=1), angles])
        worst = _worst_share(found, allowed)
        better = worst < least
        best[better], least[better] = found[better], worst[better]
    first = np.lexsort((least, row))
    return best[first[np.searchsorted(row[first], np.arange(len(poses)))]]


def _nearest(poses: Array, line: Array, free: FreeMotion, radian: float = RADIAN) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The nearest piece between poses (m, 4, 4) of a path to each of poses (k, 4, 4), and the next one not near it; (k,) each.

    Where a path closes or meets itself, rounding decides which of the two is nearer.
    """
    rows, last = np.arange(len(poses)), len(line) - 2
    if free.in_tool and len(free.shifts):  # what counts of a position depends on the pose of the path
        pieces = np.broadcast_to(np.arange(last + 1), (len(poses), last + 1))
        position, angle = _apart(poses, line, free)
        of_ends = position + radian * angle
        apart = np.minimum(of_ends[:, :-1], of_ends[:, 1:])
    else:
        vectors, others = _vectors(poses, free, radian), _vectors(line, free, radian)
        pieces, apart = _piece_distances(vectors, others, len(free.fixed_directions))
    first = pieces[rows, apart.argmin(axis=1)]
    apart[np.abs(pieces - first[:, None]) <= 2] = np.inf
    return first, pieces[rows, apart.argmin(axis=1)]


def _piece_distances(vectors: Array, line: Array, moves: int) -> tuple[NDArray[np.intp], Array]:
    """Pieces (k, c) of a line (m, d) that may be the nearest to each of vectors (k, d), and their distances.

    The first `moves` columns are positions, the others angles, whose distances are added.
    """
    from scipy.spatial import cKDTree

    ends = np.asarray(cKDTree(line).query(vectors, k=min(CANDIDATES, len(line)))[1]).reshape(len(vectors), -1)
    pieces = np.clip(np.hstack([ends - 1, ends]), 0, len(line) - 2)
    steps = np.diff(line, axis=0)
    along, offset = steps[pieces], vectors[:, None] - line[pieces]
    share = np.einsum("kcd,kcd->kc", along, offset) / np.maximum(np.einsum("md,md->m", steps, steps), 1e-30)[pieces]
    offset -= np.clip(share, 0.0, 1.0)[:, :, None] * along
    position, rotation = (np.einsum("kcd,kcd->kc", each, each) for each in (offset[..., :moves], offset[..., moves:]))
    return pieces, np.sqrt(position) + np.sqrt(rotation)


def _vectors(poses: Array, free: FreeMotion, radian: float) -> Array:
    """Vectors (k, d) of poses (k, 4, 4), whose distances are about those of what counts of the poses [m]."""
    scale = radian / np.sqrt(2.0) if free.turns is Turns.NONE else radian
    return np.hstack([poses[:, :3, 3] @ free.fixed_directions.T, scale * free.directions(poses[:, :3, :3])])


def _apart(poses: Array, others: Array, free: FreeMotion) -> tuple[Array, Array]:
    """Distances [m] and angles [rad], (k, m) each, of poses (k, 4, 4) from others (m, 4, 4), whose directions count."""
    if free.in_tool and len(free.shifts):
        fixed = free.fixed_directions @ np.swapaxes(others[:, :3, :3], 1, 2)  # (m, c, 3)
        offsets = np.einsum("mci,ki->kmc", fixed, poses[:, :3, 3]) - np.einsum("mci,mi->mc", fixed, others[:, :3, 3])
        position = np.asarray(np.linalg.norm(offsets, axis=2))
    else:
        fixed = free.fixed_directions.T
        position = np.sqrt(_squares(poses[:, :3, 3] @ fixed, others[:, :3, 3] @ fixed))
    if free.turns is Turns.ANY:
        return position, np.zeros_like(position)
    chords = _squares(free.directions(poses[:, :3, :3]), free.directions(others[:, :3, :3]))
    chords /= 8.0 if free.turns is Turns.NONE else 4.0  # sin² of half the angle
    return position, 2 * np.arcsin(np.sqrt(np.minimum(chords, 1.0)))


def _squares(first: Array, second: Array) -> Array:
    """Squared distances (k, m) of vectors (k, d) and (m, d)."""
    squares = (first**2).sum(axis=1)[:, None] + (second**2).sum(axis=1) - 2 * first @ second.T
    return np.asarray(np.maximum(squares, 0.0))


def deviation_at(path: CartesianPath, s: Array, poses: Array, free: FreeMotion = NOTHING) -> Deviation:
    """Deviation of tool poses (k, 4, 4) from those of a path at s (k,): small only if all of the path is followed, in order."""
    return largest_deviation(_shares(len(poses)), *distances_between(poses, path(s), free))


def distances_between(poses: Array, others: Array, free: FreeMotion = NOTHING) -> tuple[Array, Array]:
    """Distances [m] and angles [rad], (k,) each, of poses (k, 4, 4) from others (k, 4, 4)."""
    if isinstance(free, BoundedMotion):
        return free.excess(poses, others)
    rotations = others[:, :3, :3]
    position = np.linalg.norm(free.offsets(poses[:, :3, 3] - others[:, :3, 3], rotations), axis=1)
    return position, _angles(poses[:, :3, :3], rotations, free)


def largest_deviation(at: Array, position: Array, rotation: Array) -> Deviation:
    """The largest of distances (k,) [m] and of angles (k,) [rad] at places (k,)."""
    far, turned = int(position.argmax()), int(rotation.argmax())
    return Deviation(
        position=float(position[far]),
        position_at=float(at[far]),
        rotation=float(rotation[turned]),
        rotation_at=float(at[turned]),
    )


def _shares(count: int) -> Array:
    return np.arange(count) / max(count - 1, 1)


def _from_piece(poses: Array, begins: Array, ends: Array, free: FreeMotion, radian: float = RADIAN) -> tuple[Array, Array]:
    """Distances (k,) and angles (k,) of poses from straight pieces, each between two poses; `radian`: weight of angles [m]."""
    start, along, offset, turn = _on_pieces(poses, begins, ends, free)
    if free.turns is Turns.NONE:
        turns, leans = turn, rotation_vectors(np.swapaxes(start, 1, 2) @ poses[:, :3, :3])
    else:
        turns, leans = (free.directions(each[:, :3, :3]) - free.directions(start) for each in (ends, poses))
    length = (along**2).sum(axis=1) + radian**2 * (turns**2).sum(axis=1)
    share = (offset * along).sum(axis=1) + radian**2 * (leans * turns).sum(axis=1)
    share = np.clip(share / np.maximum(length, 1e-30), 0.0, 1.0)[:, None]
    rotations = start @ rotations_of(share * turn)
    return np.linalg.norm(offset - share * along, axis=1), _angles(poses[:, :3, :3], rotations, free)


def _on_pieces(poses: Array, begins: Array, ends: Array, free: FreeMotion) -> tuple[Array, Array, Array, Array]:
    """The rotations at the beginning of pieces, what counts of their ways and of the offsets of poses, and their turns."""
    start = begins[:, :3, :3]
    along, offset = ends[:, :3, 3] - begins[:, :3, 3], poses[:, :3, 3] - begins[:, :3, 3]
    turn = rotation_vectors(np.swapaxes(start, 1, 2) @ ends[:, :3, :3])
    if free.in_tool:  # the directions of free shifts turn along the piece
        along = along + np.cross((start @ turn[:, :, None])[:, :, 0], offset)
    return start, free.offsets(along, start), free.offsets(offset, start), turn


def _angles(first: Array, second: Array, free: FreeMotion) -> Array:
    """Angles (k,) between rotations (k, 3, 3), as far as they count."""
    if free.turns is Turns.ANY:
        return np.zeros(len(first))
    if free.turns is Turns.NONE:
        return angles_between(first, second)
    if free.turns is Turns.WORLD_AXIS:
        first, second = (np.swapaxes(each, 1, 2) for each in (first, second))
    return angles_between(first, second, free.axis)


def angles_between(first: Array, second: Array, axis: Array | None = None) -> Array:
    """Angles between rotations (..., 3, 3), or between the directions to which they turn `axis`."""
    if axis is not None:
        a, b = first @ axis, second @ axis
        return np.asarray(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), (a * b).sum(axis=-1)))
    chord = np.linalg.norm(first - second, axis=(-2, -1)) / np.sqrt(8)  # |R - S| = √8 sin(angle / 2)
    return np.asarray(2 * np.arcsin(np.minimum(chord, 1.0)))
