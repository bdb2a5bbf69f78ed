"""Layers: the configurations that reach each position of a workspace path, with their manipulability.

choose_positions: where along a tool path configurations are enumerated, if the caller does not say.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import angles_between
from manipplan.paths.tolerance import distinct
from manipplan.robots.limits import JointLimits
from manipplan.support.checks import COINCIDENT, Array, ArrayLike, finite_array, instance, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

if TYPE_CHECKING:
    from manipplan.search.sampling import CandidateSampler, PathSampling

#: Default of the largest distance of the tool between two positions [m], weight of an angle in it [m/rad], and minimum number
#: of positions.
STRIDE, RADIAN, FEWEST = 0.03, 0.1, 40
#: Maximum number of positions.
MOST_POSITIONS = 100_000
#: Angle of a corner between the ways from and to the poses beside it [rad]. A position is at every corner.
CORNER = np.deg2rad(30.0)
#: Number of places at which the tool's way is measured.
WAY_SAMPLES = 2001
#: Way between two poses of a path below which they share a position [m]: half of the default tolerance.
SHARED = 5e-5


def choose_positions(path: CartesianPath, *, stride: float = STRIDE, closed: bool = False) -> Array:
    """Parameters s (L,) of positions at most `stride` apart [m], where 1 rad counts as 10 cm, and at least 40.

    They are at poses through which the path was laid as far as possible, and at every one where it turns a corner. A closed
    path does not repeat its first position.
    """
    knots = path.knots
    places = np.union1d(np.linspace(0.0, 1.0, WAY_SAMPLES), knots)
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


#: What candidates keep beyond what is required, for the motion between positions, whose splines bow outwards: clearance [m],
#: and distance from position limits where they can [rad or m].
SPARE_CLEARANCE, INSIDE_LIMITS = 0.003, 2e-3
#: Number of rows that are folded into one when extremes are taken: NumPy is fast along long rows only.
FOLD = 64
#: Maximum number of candidates per layer: they have 32-bit indices.
MOST = 2**31 - 1
#: Maximum joint value [rad or m], so that differences and squares stay finite.
LARGEST = 1e100


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Layers:
    """Candidates q[i] (k_i, n) at each of L positions, with their manipulability m[i] (k_i,).

    A path takes one candidate of each layer. It is continuous when every joint's step between neighbouring layers is
    below an ε, and below what `joint_pace`, `pose_step` and `longest` allow; the step of a continuous joint is wrapped to
    (-π, π].

    Attributes:
        q: configurations of each layer, (k_i, n) float64 [rad or m], contiguous; never copied or changed.
        m: manipulability of each candidate, (k_i,) float64.
        continuous: (n,) which joints are continuous, without position limits.
        closed: whether the last layer neighbours the first, so that a path is a cycle.
        s: (L,) path parameter of each position, or None.
        poses: (L, 4, 4) pose reached at each position, or None.
        considered: total number of candidates, including those that were dropped.
        sampling: how they were sampled, or None.
        joint_pace: (n,) largest step of each joint per metre of the tool's way between neighbouring layers [rad/m or 1], for
            layers with s and sampling; None: any.
        pose_step: largest step of a joint from one given pose of the path to the next [rad or m], for the same layers; between
            layers it is shared by the number of poses from one to the next. None: any.
        longest: largest step of a joint from each layer to the next (L - 1,), or (L,) where they are closed [rad or m]; None:
            any.
        turn_middles: (n,) the middle of the limits of each joint of which candidates are listed at all full turns inside these,
            nan for others; None: of no joint. A layer with a single candidate need not be listed so.
    """

    q: tuple[Array, ...]
    m: tuple[Array, ...]
    continuous: NDArray[np.bool_]
    closed: bool = False
    s: Array | None = None
    poses: Array | None = None
    considered: int = 0
    sampling: "PathSampling | None" = None
    joint_pace: Array | None = None
    pose_step: float | None = None
    longest: Array | None = None
    turn_middles: Array | None = None

    @classmethod
    def from_arrays(
        cls, q: Sequence[ArrayLike], m: Sequence[ArrayLike], *, continuous: ArrayLike | None = None, closed: bool = False
    ) -> Self:
        """Layers of given configurations q[i] (k_i, n) [rad or m] and their manipulability m[i] (k_i,), at least two layers.

        Contiguous float64 arrays are used without a copy: do not change them afterwards. `continuous` (n,) bool marks
        the continuous joints, by default none.

        Raises InvalidInputError, which names the layer, for fewer than two layers, an empty layer, shapes that do not
        match, or values that are not finite.
        """
        if not isinstance(closed, bool | np.bool_):
            raise InvalidInputError("closed", closed, "True or False")
        sets, given = _each("q", q), _each("m", m)
        if len(sets) < 2:
            raise InvalidInputError("q", f"{len(sets)} layers", "at least two layers, each an array (k_i, n)")
        if len(given) != len(sets):
            raise InvalidInputError("m", f"{len(given)} layers", f"as many layers as q: {len(sets)}")
        configurations = tuple(_contiguous(f"q[{i}]", each, 2) for i, each in enumerate(sets))
        n = configurations[0].shape[1]
        for i, layer in enumerate(configurations):
            if layer.shape[1] != n or n == 0:
                wanted = f"(k, {n}), the width of q[0]" if n else "(k, n) with n at least 1"
                raise InvalidInputError(f"q[{i}]", f"an array of shape {layer.shape}", wanted)
            if len(layer) == 0:
                raise InvalidInputError(f"q[{i}]", "no candidate", "at least one: a path has to pass each layer")
            if len(layer) > MOST:
                raise InvalidInputError(f"q[{i}]", f"{len(layer)} candidates", f"at most {MOST}")
        values = tuple(_contiguous(f"m[{i}]", each, 1) for i, each in enumerate(given))
        for i, (layer, value) in enumerate(zip(configurations, values, strict=True)):
            if len(layer) != len(value):
                raise InvalidInputError(f"m[{i}]", f"{len(value)} values", f"one per candidate of q[{i}]: {len(layer)}")
        turning = np.zeros(n, dtype=np.bool_)
        if continuous is not None:
            turns = np.asarray(continuous)
            if turns.dtype != np.bool_ or turns.shape != (n,):
                raise InvalidInputError("continuous", continuous, f"{n} booleans, one per joint")
            turning[:] = turns
        turning.flags.writeable = False
        count = sum(len(layer) for layer in configurations)
        layers = cls(q=configurations, m=values, continuous=turning, closed=bool(closed), considered=count)
        layers._check_finite()
        return layers

    @property
    def sampler(self) -> "CandidateSampler | None":
        """The sampler that made them, or None."""
        return None if self.sampling is None else self.sampling.sampler

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.q[0].shape[1])

    @property
    def count(self) -> int:
        """Total number of candidates."""
        return sum(len(layer) for layer in self.q)

    @property
    def sizes(self) -> NDArray[np.int64]:
        """Number of candidates per layer (L,)."""
        return np.array([len(layer) for layer in self.q], dtype=np.int64)

    @cached_property
    def bound(self) -> float:
        """Smallest over the layers of the largest manipulability: no path's minimum manipulability exceeds it, for any ε."""
        return float(min(value.max() for value in self.m))

    @cached_property
    def ways(self) -> Array:
        """Length of the tool's way from each layer to the next (L - 1,), or (L,) where they are closed [m]."""
        assert self.s is not None and self.sampling is not None
        s = np.append(self.s, 1.0) if self.closed else self.s
        places = np.union1d(np.linspace(0.0, 1.0, WAY_SAMPLES), s)
        steps = np.linalg.norm(np.diff(self.sampling.path(places)[:, :3, 3], axis=0), axis=1)
        way = np.concatenate([[0.0], np.cumsum(steps)])
        return np.abs(np.diff(way[np.searchsorted(places, s)]))

    @cached_property
    def poses_passed(self) -> Array:
        """Number of given poses from each layer to the next (L - 1,), or (L,) where they are closed, with fractions."""
        assert self.s is not None and self.sampling is not None
        knots = self.sampling.path.knots
        s = np.append(self.s, 1.0) if self.closed else self.s
        return np.abs(np.diff(np.interp(s, knots, np.arange(len(knots)))))

    @property
    def nbytes(self) -> int:
        """Memory of q and m [bytes]."""
        return sum(layer.nbytes for layer in self.q) + sum(value.nbytes for value in self.m)

    @cached_property
    def extent(self) -> Array:
        """Smallest and largest value of each joint over all layers, (2, n); the grids of a search span it."""
        lower = np.min([_extreme(layer, np.minimum) for layer in self.q], axis=0)
        upper = np.max([_extreme(layer, np.maximum) for layer in self.q], axis=0)
        return np.array([lower, upper])

    def inside(self, limits: JointLimits) -> Self:
        """The same without the candidates nearer to a position limit than INSIDE_LIMITS, except at positions where all are."""
        instance("limits", limits, JointLimits)
        lower, upper = limits.lower + INSIDE_LIMITS, limits.upper - INSIDE_LIMITS
        inside = [((lower <= q) & (q <= upper)).all(axis=1) for q in self.q]
        inside = [each if each.any() else np.ones_like(each) for each in inside]
        q = tuple(np.ascontiguousarray(q[each]) for q, each in zip(self.q, inside, strict=True))
        return replace(self, q=q, m=tuple(m[each] for m, each in zip(self.m, inside, strict=True)))

    @cached_property
    def in_one_turn(self) -> "Layers | None":
        """The same with candidates at one of their full turns, of joints that turn without end; None without `turn_middles`.

        Each path through these layers is one through it, but not the other way round: there joints may turn beyond their
        limits.
        """
        if self.turn_middles is None:
            return None
        turning = ~np.isnan(self.turn_middles)
        sets, values = list[Array](), list[Array]()
        for q, m in zip(self.q, self.m, strict=True):
            away = q[:, turning] - self.turn_middles[turning]
            inside = (np.abs(away) <= np.pi + COINCIDENT).all(axis=1)
            once = np.ascontiguousarray(q[inside])
            if not len(once):
                inside, once = np.ones_like(inside), q.copy()
                once[:, turning] -= 2 * np.pi * np.round(away / (2 * np.pi))
            sets.append(once)
            values.append(m[inside])
        return replace(self, q=tuple(sets), m=tuple(values), continuous=self.continuous | turning, turn_middles=None)

    def part(self, first: int, last: int) -> Self:
        """The open layers from one position to another one of these, both included."""
        own = slice(first, last + 1)
        s, poses = (None if each is None else each[own] for each in (self.s, self.poses))
        longest = None if self.longest is None else self.longest[first:last]
        return replace(self, q=self.q[own], m=self.m[own], closed=False, s=s, poses=poses, longest=longest)

    def _check_finite(self) -> None:
        # minimum and maximum propagate NaN and inf: no boolean array is needed
        if not (np.abs(self.extent) <= LARGEST).all():
            i = next(i for i, layer in enumerate(self.q) if not (np.abs(layer) <= LARGEST).all())
            raise InvalidInputError(f"q[{i}]", "NaN, inf or a number too large", f"finite numbers up to {LARGEST:g}")
        for i, value in enumerate(self.m):
            if not (np.isfinite(value.min()) and np.isfinite(value.max())):
                raise InvalidInputError(f"m[{i}]", "NaN or inf", "finite numbers")


def _each(argument: str, value: Any) -> list[Any]:
    if isinstance(value, list | tuple) or (isinstance(value, np.ndarray) and value.ndim > 0):
        return list(value)
    raise InvalidInputError(argument, value, "a list of arrays, one per layer")


def _contiguous(argument: str, value: Any, axes: int) -> Array:
    try:
        raw = np.asarray(value)
        if raw.dtype.kind not in "iuf" and raw.size:
            raise TypeError(raw.dtype)
        array = np.ascontiguousarray(raw, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInputError(argument, value, "real numbers") from error
    if raw.ndim != axes:
        wanted = "configurations of shape (k, n)" if axes == 2 else "one number per candidate, shape (k,)"
        raise InvalidInputError(argument, f"an array of shape {raw.shape}", wanted)
    return array


def _extreme(layer: Array, extreme: np.ufunc) -> Array:
    whole = len(layer) // FOLD * FOLD
    tail = layer[whole:] if whole < len(layer) else layer[:1]
    result = extreme.reduce(tail, axis=0)
    if whole:
        folded = extreme.reduce(layer[:whole].reshape(-1, FOLD * layer.shape[1]), axis=0)
        result = extreme(result, extreme.reduce(folded.reshape(FOLD, -1), axis=0))
    return np.asarray(result, dtype=np.float64)


def step_limits(layers: Layers, epsilon: Array) -> Array:
    """Bound on the step of each joint from each layer to the next, (L - 1, n), or (L, n) where they are closed.

    `epsilon` (n,), or one row for each step.
    """
    limits = np.broadcast_to(epsilon, (len(layers.q) - (not layers.closed), layers.n))
    if layers.joint_pace is not None:
        limits = np.minimum(limits, layers.ways[:, None] * layers.joint_pace)
    if layers.pose_step is not None:
        limits = np.minimum(limits, layers.poses_passed[:, None] * layers.pose_step)
    if layers.longest is not None:
        limits = np.minimum(limits, layers.longest[:, None])
    return limits
