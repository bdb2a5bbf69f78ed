"""choose_positions: where along a tool path configurations are enumerated, if the caller does not say."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import angles_between
from manipplan.paths.distinct import distinct
from manipplan.support.checks import Array, finite_array, whole_number
from manipplan.support.errors import InvalidInputError

#: Default of the largest distance of the tool between two positions [m], weight of an angle in it [m/rad], and minimum number
#: of positions.
STRIDE, RADIAN, FEWEST = 0.03, 0.1, 40
#: Maximum number of positions.
MOST_POSITIONS = 100_000
#: Angle of a corner between the ways from and to the poses beside it [rad]. A position is at every corner.
CORNER = np.deg2rad(30.0)
#: Number of places at which the tool's way is measured.
PLACES = 2001
#: Way between two poses of a path below which they share a position [m]: half of the default tolerance.
SHARED = 5e-5


def choose_positions(path: CartesianPath, *, stride: float = STRIDE, closed: bool = False) -> Array:
    """Parameters s (L,) of positions at most `stride` apart [m], where 1 rad counts as 10 cm, and at least 40.

    They are at poses through which the path was laid as far as possible, and at every one where it turns a corner. A closed
    path does not repeat its first position.
    """
    knots = path.knots
    places = np.union1d(np.linspace(0.0, 1.0, PLACES), knots)
    poses = path(places)
    steps = np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1)
    steps += RADIAN * angles_between(poses[:-1, :3, :3], poses[1:, :3, :3])
    way = np.concatenate([[0.0], np.cumsum(steps)])
    if way[-1] < SHARED:
        raise InvalidInputError("path", f"a path of {way[-1]:.2g} m", f"one on which the tool moves by {SHARED:g} m or turns")
    at = np.interp(knots, places, way)
    own = distinct(len(knots), lambda i, j: np.abs(at[i] - at[j]), SHARED)
    knots, at = knots[own], at[own]
    stride = min(stride, way[-1] / (FEWEST - 1))
    corners = set(_corners(path(knots)[:, :3, 3]))
    chosen, last = [0.0], 0
    while last < len(knots) - 1:
        within = int(np.searchsorted(at, at[last] + stride * (1 + 1e-9), side="right")) - 1
        following = next((k for k in range(last + 1, within) if k in corners), max(within, last + 1))
        count = int(np.ceil((at[following] - at[last]) / stride * (1 - 1e-9))) or 1
        between = np.linspace(at[last], at[following], count + 1)[1:-1]
        chosen += [*np.interp(between, way, places), knots[following]]
        last = following
    s = np.array(chosen)
    return s[:-1] if closed else s


def count_positions(value: int | ArrayLike) -> int:
    """Number of positions where `value` is that, or gives their s; raises InvalidInputError."""
    if isinstance(value, list | tuple | np.ndarray):
        return len(finite_array("positions", value, (None,)))
    return whole_number("positions", value, least=2, most=MOST_POSITIONS)


def check_positions(value: int | ArrayLike, *, closed: bool) -> Array:
    """Parameters s (L,) of a number of equally spaced positions, or the given ones; raises InvalidInputError."""
    if not isinstance(value, list | tuple | np.ndarray):
        n = count_positions(value)
        return np.arange(n) / n if closed else np.linspace(0.0, 1.0, n)
    s = finite_array("positions", value, (None,))
    if len(s) < 2 or s[0] != 0.0 or (np.diff(s) <= 0).any() or (s[-1] >= 1.0 if closed else s[-1] != 1.0):
        wanted = f"at least two increasing numbers from 0 to {'below 1, as the path is closed' if closed else '1'}"
        raise InvalidInputError("positions", value, wanted)
    return s


def _corners(points: Array) -> NDArray[np.int64]:
    """Indices of the points (k, 3) at which their polygon turns by more than CORNER."""
    chords = np.diff(points, axis=0)
    lengths = np.linalg.norm(chords, axis=1)
    moves = (lengths[:-1] > 0) & (lengths[1:] > 0)
    products = (chords[:-1] * chords[1:]).sum(axis=1)
    return np.flatnonzero(moves & (products < np.cos(CORNER) * lengths[:-1] * lengths[1:])) + 1
