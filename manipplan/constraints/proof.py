"""The proof that a path keeps constraints everywhere, and ConstraintFigure: how it keeps each of them.

Rows of the tool's pose are proven. Between two parameters of a path, d apart, a row is at least the smaller value of both minus
M d² / 8, where M bounds its second derivative along the path: joint speeds and accelerations are bounded by control points, and
the tool's by `ToolFrame.bend`. Intervals are halved until that suffices. Rows of a user's class are sampled.
"""

from dataclasses import dataclass

import numpy as np

from manipplan.constraints.constraint import ROW_TOLERANCE, HeldJoints
from manipplan.constraints.constraint_set import POSE, ConstraintSet
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.display import one_line

#: Value down to which a row counts as kept in a proof [rad or m]. A tenth of what a report allows.
TOLERANCE = 1e-7
#: Maximum joint motion in the first intervals, and between samples of rows without a proof [rad or m].
FIRST_STEP, SAMPLE_STEP = 0.05, 1e-3
#: Maximum number of halvings of an interval.
HALVINGS = 14
#: Number of samples at which held joints are compared with their first values.
FIXED_JOINT_SAMPLES = 1001


@dataclass(frozen=True, kw_only=True, eq=False)
class ConstraintProof:
    """What is known about constraints on a whole path.

    Attributes:
        kept: no row is below -TOLERANCE, or by more than that below an end of the path: proven, or at samples SAMPLE_STEP apart
            for rows of a user's class.
        failed_at: the s where that is refuted, or where the proof ends; nan where it is kept.
        least, least_at: (c,) smallest value found of each constraint, and its s; for held joints minus the largest change.
        proven: (c,) whether each one is proven, and not only sampled.
    """

    kept: bool
    failed_at: float
    least: Array
    least_at: Array
    proven: tuple[bool, ...]


def prove(constraints: ConstraintSet, path: JointPath) -> ConstraintProof:
    """Judge a path. It is a proof for rows of the tool's pose and held joints."""
    samples = _RowSamples(constraints, path)
    unproven = _prove_tool_rows(samples) if len(constraints.weights) else None
    if constraints.own is not None and samples.broken_at is None:
        samples.values(path.fine_samples(SAMPLE_STEP))
    if constraints.held.any():
        samples.take_held()
    failed_at = samples.broken_at if samples.broken_at is not None else unproven
    sampled = set(constraints.owners[len(constraints.weights) :].tolist())
    return ConstraintProof(
        kept=failed_at is None,
        failed_at=np.nan if failed_at is None else failed_at,
        least=samples.least,
        least_at=samples.least_at,
        proven=tuple(failed_at is None and k not in sampled for k in range(len(constraints.constraints))),
    )


class _RowSamples:
    """The rows at places of a path, and the smallest values found.

    Attributes:
        least, least_at: as in ConstraintProof.
        floor: (r,) what rows have to keep; at most ROW_TOLERANCE below 0.
        broken_at: a place where a row is not kept; None for none.
    """

    def __init__(self, constraints: ConstraintSet, path: JointPath) -> None:
        self.constraints, self.path = constraints, path
        count = len(constraints.constraints)
        self.least, self.least_at = np.full(count, np.inf), np.zeros(count)
        ends = constraints.values(np.array([path.start, path.goal])).min(axis=0)
        self.floor = np.maximum(np.minimum(ends, 0.0) - TOLERANCE, -ROW_TOLERANCE)
        self.broken_at: float | None = None

    def values(self, s: Array) -> Array:
        """The rows (m, r) at s (m,)."""
        s = np.minimum(s, 1.0)  # sums of widths may end a rounding error beyond
        values = self.constraints.values(self.path(s))
        lowest = values.argmin(axis=0)
        for row, owner in enumerate(self.constraints.owners):
            value, at = float(values[lowest[row], row]), float(s[lowest[row]])
            self._take(int(owner), value, at)
            if value < self.floor[row] and self.broken_at is None:
                self.broken_at = at
        return values

    def take_held(self) -> None:
        """The largest changes of held joints, on the whole path."""
        bottom, top = self.path.bounds()
        moved = np.maximum(np.abs(bottom - self.path.start), np.abs(top - self.path.start))
        joint = int(np.where(self.constraints.held, moved, -1.0).argmax())
        s = np.linspace(0.0, 1.0, FIXED_JOINT_SAMPLES)
        at = float(s[np.abs(self.path(s)[:, joint] - self.path.start[joint]).argmax()])
        for k, each in enumerate(self.constraints.constraints):
            if isinstance(each, HeldJoints):
                self._take(k, -float(moved[each.mask(self.constraints.robot)].max()), at)
        if moved[joint] > TOLERANCE and self.broken_at is None:
            self.broken_at = at

    def _take(self, constraint: int, value: float, s: float) -> None:
        if value < self.least[constraint]:
            self.least[constraint], self.least_at[constraint] = value, s


def _prove_tool_rows(samples: _RowSamples) -> float | None:
    """Where the proof of rows of the tool's pose ends; None where it succeeds, or a row is not kept."""
    rows = len(samples.constraints.weights)
    begins, widths, bend = _intervals(samples.constraints, samples.path)
    low, high = samples.values(begins)[:, :rows], samples.values(begins + widths)[:, :rows]
    for _ in range(HALVINGS):
        left = np.flatnonzero((np.minimum(low, high) - bend * (widths**2)[:, None] / 8 < samples.floor[:rows]).any(axis=1))
        if not len(left) or samples.broken_at is not None:
            return None
        widths = widths[left] / 2
        middle = samples.values(begins[left] + widths)[:, :rows]
        begins = np.concatenate([begins[left], begins[left] + widths])
        low, high = np.concatenate([low[left], middle]), np.concatenate([middle, high[left]])
        bend, widths = np.tile(bend[left], (2, 1)), np.tile(widths, 2)
    return float(begins[0])


def _intervals(constraints: ConstraintSet, path: JointPath) -> tuple[Array, Array, Array]:
    """Intervals of a path: their begins and widths (m,) in s, and bounds (m, r) on second derivatives of the tool's rows."""
    assert constraints.tool is not None
    h = np.diff(path.breaks)
    first = path.degree * np.diff(path.control, axis=1) / h[:, None, None]
    second = (path.degree - 1) * np.diff(first, axis=1) / h[:, None, None]
    q, speed, acceleration = (np.abs(each).max(axis=1, initial=0.0) for each in (path.control, first, second))
    unit, position = constraints.tool.bend(q, speed, acceleration)
    of_position, of_rotation = constraints.weights[:, :3], constraints.weights[:, 3:POSE].reshape(-1, 3, 3)
    turning = np.linalg.svd(of_rotation, compute_uv=False).sum(axis=1)  # |tr(W R'')| is at most that times |R''|
    bend = np.outer(position, np.linalg.norm(of_position, axis=1)) + np.outer(unit, turning)
    counts = np.maximum(1, np.ceil(speed.sum(axis=1) * h / FIRST_STEP)).astype(int)
    piece = np.repeat(np.arange(len(h)), counts)
    share = (np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)) / counts[piece]
    return path.breaks[piece] + share * h[piece], (h / counts)[piece], bend[piece]


@one_line
@dataclass(frozen=True, kw_only=True)
class ConstraintFigure:
    """How a path or a motion keeps one constraint.

    Attributes:
        name: of the constraint.
        least, at: the smallest value of its rows that was found, at least 0 where it is kept, and the share of the path or of
            the duration at which it occurs. For held joints minus the largest change [rad or m].
        figure: the same in words.
        proven: whether it is proven on the whole path, and not only kept at samples between which no joint moves by more than
            1e-3 rad or m.
    """

    name: str
    least: float
    at: float
    figure: str
    proven: bool

    def __str__(self) -> str:
        return f"{self.name}: {self.figure}{', proven' if self.proven else ''}"


def figures(constraints: ConstraintSet, proof: ConstraintProof) -> tuple[ConstraintFigure, ...]:
    """The figures of all constraints on a path that was judged."""
    found = []
    for k, each in enumerate(constraints.constraints):
        least, is_noise = float(proof.least[k]), isinstance(each, HeldJoints) and abs(proof.least[k]) <= TOLERANCE
        figure = each.figure(0.0 if is_noise else least)
        at, proven = float(proof.least_at[k]), proof.proven[k]
        found.append(ConstraintFigure(name=each.name, least=least, at=at, figure=figure, proven=proven))
    return tuple(found)
