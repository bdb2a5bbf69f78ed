"""ConstraintSet: the constraints of one motion, evaluated for a robot, and the proof that a path keeps them everywhere.

Rows of the tool's pose are proven. Between two parameters of a path, d apart, a row is at least the smaller value of both minus
M d² / 8, where M bounds its second derivative along the path: joint speeds and accelerations are bounded by control points, and
the tool's by `ToolFrame.bend`. Intervals are halved until that suffices. Rows of a user's class are sampled.
"""

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from manipplan.constraints.constraint import (
    ROW_TOLERANCE,
    Constraint,
    HeldJoints,
    SymbolicPose,
    TiltLimit,
    constraint_tuple,
    contradiction,
)
from manipplan.kinematics.batch import BatchKernel, run_kernel
from manipplan.paths.joint import JointPath
from manipplan.robots.arms import led_by
from manipplan.robots.model_tree import JointTree, frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.expressions import making_expressions
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.backends import chain_of
from manipplan.symbolic.machine_code import BatchFunction

#: Number of entries of a pose: position and columns of the rotation.
POSE = 12


@dataclass(frozen=True, kw_only=True, eq=False)
class ToolFrame:
    """The tool of an arm: its pose and Jacobian in one call, and bounds on how fast both change.

    Attributes:
        function: POSE + 6 n numbers of q (n,): position, columns of the rotation, then linear and angular part of the Jacobian
            of each joint, in the world's axes.
        kernel: the same for batches.
        tree: the arm's N joints.
        turns, slides: (N,) whether a joint carries the tool and is revolute, or prismatic; 1 or 0.
        lengths: (N + 1,) distances from the origin of the joint before to that of each joint, and of the tool [m].
    """

    function: ca.Function
    kernel: BatchKernel
    tree: JointTree
    turns: Array
    slides: Array
    lengths: Array

    def at(self, q: Array) -> tuple[Array, Array]:
        """Poses (m, POSE) and Jacobians (m, n, 6) at configurations (m, n)."""
        n, q = q.shape[1], np.ascontiguousarray(q, dtype=float)
        found = run_kernel(self.kernel, q, POSE + 6 * n, threads=1)
        if found is None:
            raise InvalidInputError("q", q, "finite numbers, no NaN or inf")
        return found[:, :POSE], found[:, POSE:].reshape(-1, n, 6)

    def bend(self, q: Array, speed: Array, acceleration: Array) -> tuple[Array, Array]:
        """Upper bounds (m,) on |u''| of any unit vector u that the tool carries, and on |p''| of its position [m].

        For absolute joint values, speeds and accelerations of at most `q`, `speed` and `acceleration` (m, n). Of joints i <= j,
        in their order from the base, ∂²u = z_i x (z_j x u), and ∂²p = z_i x ∂_j p, which is 0 where i is prismatic.
        """
        tree = self.tree
        q, speed, acceleration = tree.sizes(q) + np.abs(tree.offset), tree.sizes(speed), tree.sizes(acceleration)
        # from the origin of each joint to that of the tool, at most
        far = self.lengths[-1] + np.cumsum((self.lengths[:-1] + self.slides * q)[:, ::-1], axis=1)[:, ::-1]
        far = np.hstack([far[:, 1:], np.full((len(q), 1), self.lengths[-1])])
        reach = self.turns * far + self.slides
        turning = speed * self.turns
        unit = turning.sum(axis=1) ** 2 + (acceleration * self.turns).sum(axis=1)
        # Σ_j (2 Σ_{i<j} turning_i + turning_j) speed_j reach_j
        before = 2 * np.cumsum(turning, axis=1) - turning
        position = (before * speed * reach).sum(axis=1) + (acceleration * reach).sum(axis=1)
        return unit, position


@once_per_owner
def tool_frame(robot: Robot, tool: str) -> ToolFrame:
    """One tool of a robot."""
    robot = led_by(robot, tool)
    chain = chain_of(robot, "auto")
    pose = ca.vertcat(chain.tool.origin, ca.reshape(chain.tool.rotation, 9, 1))
    values = ca.vertcat(pose, ca.reshape(chain.jacobian, 6 * robot.n, 1))
    function = ca.Function("tool_frame", [chain.q], [ca.densify(values)], ["q"], ["values"])
    model = robot.model
    frame = model.frames[frame_index(model, robot.tool)]
    turns, slides, lengths = np.zeros(model.njoints - 1), np.zeros(model.njoints - 1), np.zeros(model.njoints)
    lengths[-1] = np.linalg.norm(frame.placement.translation)
    for i in model.supports[frame.parentJoint]:
        if i > 0:
            (slides if chain.tree.slides[i - 1] else turns)[i - 1] = 1.0
            lengths[i - 1] = np.linalg.norm(model.jointPlacements[i].translation)
    return ToolFrame(
        function=function,
        kernel=BatchKernel(function, "auto", f"{tool} of {robot.name}, in batches"),
        tree=chain.tree,
        turns=turns,
        slides=slides,
        lengths=lengths,
    )


#: Held joints whose values differ by no more than this are the same [rad or m].
EQUAL_VALUE = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class OwnRows:
    """Rows of constraints of a user's class: values (r), and values with gradients and Hessians, as functions of q."""

    count: int
    value: BatchFunction
    gradient: BatchFunction
    hessian: BatchFunction

    @classmethod
    @making_expressions()
    def of(cls, robot: Robot, constraints: Sequence[Constraint]) -> tuple["OwnRows", list[int]]:
        """The rows of all of them, and the number of rows of each; raises InvalidInputError for anything but a column."""
        chain = chain_of(robot, "auto")
        columns = []
        for each in constraints:
            made = each.rows(_symbolic_pose(robot, each.of_tool or robot.tool))
            if not isinstance(made, ca.SX) or made.shape[1] != 1 or not made.shape[0]:
                raise InvalidInputError("constraints", each.name, "constraints whose rows are a ca.SX (r, 1), r at least 1")
            if set(_names(ca.symvar(made))) - set(_names(ca.symvar(chain.q))):
                raise InvalidInputError("constraints", each.name, "rows of the symbols q, position and rotation alone")
            columns.append(ca.densify(made))
        rows = ca.vertcat(*columns)
        jacobian = ca.densify(ca.jacobian(rows, chain.q))
        second = [ca.reshape(ca.densify(ca.hessian(rows[k], chain.q)[0]), robot.n**2, 1) for k in range(rows.shape[0])]
        made = [rows, ca.reshape(jacobian.T, rows.shape[0] * robot.n, 1), ca.vertcat(*second)]
        value, gradient, hessian = (
            BatchFunction(ca.Function(f"own_{name}", [chain.q], [ca.densify(each)]))
            for name, each in zip(("rows", "gradients", "hessians"), made, strict=True)
        )
        own = cls(count=rows.shape[0], value=value, gradient=gradient, hessian=hessian)
        return own, [each.shape[0] for each in columns]


@dataclass(frozen=True, kw_only=True, eq=False)
class ConstraintSet:
    """The constraints of one motion: rows of the tool's pose first, then those of a user's classes, and the held joints.

    Attributes:
        robot: the arm.
        constraints: all of them.
        owners: (r,) index of the constraint of each row.
        weights: (t, 13) the rows of the tool's pose, as `Constraint.tool_rows`; those of other tools are among `own`.
        tool: the pose and Jacobian of the first tool that a constraint is about.
        own: the other rows; None for none.
        held: (n,) whether a joint is held.
    """

    robot: Robot
    constraints: tuple[Constraint, ...]
    owners: NDArray[np.intp]
    weights: Array
    tool: ToolFrame | None
    own: OwnRows | None
    held: NDArray[np.bool_]

    @classmethod
    def of(cls, robot: Robot, constraints: Sequence[Constraint]) -> "ConstraintSet":
        """The set; raises InvalidInputError for what is no constraint, does not fit the robot, or contradicts another one."""
        given, held = constraint_tuple(constraints), np.zeros(robot.n, dtype=bool)
        weights, tool_owners, others, other_owners = [np.empty((0, 13))], [], [], []
        tool = None
        for k, each in enumerate(given):
            each.check(robot)
            of_tool = each.tool_rows()
            if of_tool is not None:
                tool = tool or each.of_tool or robot.tool
            if isinstance(each, HeldJoints):
                held |= each.mask(robot)
            elif of_tool is not None and (each.of_tool or robot.tool) == tool:
                weights.append(of_tool)
                tool_owners += [k] * len(of_tool)
            else:
                others.append(each)
                other_owners.append(k)
        if held.all():
            raise InvalidInputError("constraints", "all joints held", "constraints that leave a joint to move")
        _check_contradictions(robot, given)
        own, counts = OwnRows.of(robot, others) if others else (None, [])
        return cls(
            robot=robot,
            constraints=given,
            owners=np.array(tool_owners + list(np.repeat(other_owners, counts)), dtype=np.intp),
            weights=np.vstack(weights),
            tool=tool_frame(robot, tool) if tool is not None else None,
            own=own,
            held=held,
        )

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return ConstraintSet.of, (self.robot, self.constraints)

    @property
    def count(self) -> int:
        """Number of rows."""
        return len(self.owners)

    def values(self, q: Array) -> Array:
        """The rows (m, r) at configurations (m, n)."""
        parts = []
        if self.tool is not None:
            pose, _ = self.tool.at(q)
            parts.append(pose @ self.weights[:, :POSE].T + self.weights[:, POSE])
        if self.own is not None:
            parts.append(self.own.value.by_columns(q))
        return np.hstack(parts) if parts else np.empty((len(q), 0))

    def gradients(self, q: Array) -> Array:
        """Their gradients (m, r, n)."""
        parts = []
        if self.tool is not None:
            pose, jacobian = self.tool.at(q)
            linear, angular = jacobian[:, :, :3], jacobian[:, :, 3:]
            vectors = pose[:, 3:].reshape(-1, 1, 3, 3)  # column k of the rotation in row k
            turned = np.cross(angular[:, :, None], vectors)  # (m, n, 3, 3)
            moved = np.concatenate([linear, turned.reshape(len(q), self.robot.n, 9)], axis=2)
            parts.append(np.swapaxes(moved @ self.weights[:, :POSE].T, 1, 2))
        if self.own is not None:
            parts.append(self.own.gradient.by_columns(q).reshape(len(q), self.own.count, self.robot.n))
        return np.concatenate(parts, axis=1) if parts else np.empty((len(q), 0, self.robot.n))

    def hessians(self, q: Array, rows: NDArray[np.intp]) -> Array:
        """The Hessians (m, n, n) of one row (m,) at each configuration (m, n)."""
        n, tool_rows = self.robot.n, len(self.weights)
        found = np.empty((len(q), n, n))
        of_tool = rows < tool_rows
        if of_tool.any():
            assert self.tool is not None
            pose, jacobian = self.tool.at(q[of_tool])
            linear, angular, weights = jacobian[:, :, :3], jacobian[:, :, 3:], self.weights[rows[of_tool]]
            turned = np.cross(angular[:, :, None], pose[:, 3:].reshape(-1, 1, 3, 3))  # z_j x R_k
            once = np.cross(angular[:, :, None, None], turned[:, None])  # z_i x (z_j x R_k), (m, i, j, k, 3)
            moved = np.cross(angular[:, :, None], linear[:, None])  # z_i x ∂_j p, (m, i, j, 3)
            both = np.einsum("mijkc,mkc->mij", once, weights[:, 3:POSE].reshape(-1, 3, 3))
            both += np.einsum("mijc,mc->mij", moved, weights[:, :3])
            upper = np.triu(both)  # of joints i <= j
            found[of_tool] = upper + np.swapaxes(np.triu(both, 1), 1, 2)
        if not of_tool.all():
            assert self.own is not None
            at = q[~of_tool]
            every = self.own.hessian.by_columns(at).reshape(len(at), self.own.count, n, n)
            found[~of_tool] = every[np.arange(len(at)), rows[~of_tool] - tool_rows]
        return found

    def broken(self, q: Array) -> str:
        """Which constraint a configuration (n,) breaks, and how; "" for none. Held joints do not count."""
        for k, value in enumerate(self.worst(self.values(q[None]))):
            if value < -ROW_TOLERANCE:
                return f"{self.constraints[k].name}: {self.constraints[k].figure(float(value))}"
        return ""

    def worst(self, values: Array) -> Array:
        """The smallest value of each constraint (c,) among rows (m, r); inf for held joints."""
        smallest = np.full(len(self.constraints), np.inf)
        np.minimum.at(smallest, self.owners, values.min(axis=0))
        return smallest

    def moved(self, start: Array, q: Array) -> str:
        """Which held joints differ between start and q (n,), and by how much; "" for none."""
        off = np.where(self.held, np.abs(q - start), 0.0)
        if off.max() <= EQUAL_VALUE:
            return ""
        joint = int(off.argmax())
        return f"{self.robot.joint_names[joint]} is held, and differs by {off[joint]:.4g} from the start"


@making_expressions()
def _symbolic_pose(robot: Robot, tool: str) -> SymbolicPose:
    """The pose of one tool at the symbols of the robot's chain."""
    chain, own = chain_of(robot, "auto"), chain_of(led_by(robot, tool), "auto")
    made = ca.Function("pose", [own.q], [own.tool.origin, own.tool.rotation])
    position, rotation = made.call([chain.q], True, False)
    return SymbolicPose(q=chain.q, position=position, rotation=rotation)


def _check_contradictions(robot: Robot, constraints: Sequence[Constraint]) -> None:
    """Raise InvalidInputError for two tilt limits that no rotation keeps."""
    tilts = [(k, each) for k, each in enumerate(constraints) if isinstance(each, TiltLimit)]
    for (k, one), (j, other) in itertools.combinations(tilts, 2):
        if (one.tool or robot.tool) == (other.tool or robot.tool) and contradiction(one, other):
            wanted = f"one that can be kept together with constraints[{k}]: {one.name}"
            raise InvalidInputError(f"constraints[{j}]", other.name, wanted)


def _names(symbols: Sequence[ca.SX]) -> list[int]:
    return [each.element_hash() for each in symbols]


def check_start(constraints: ConstraintSet, start: Array, argument: str = "start") -> None:
    """Raise InvalidInputError where the start (n,) breaks a constraint: it names the constraint, and by how much."""
    broken = constraints.broken(start)
    if broken:
        raise InvalidInputError(argument, start.tolist(), f"a configuration that keeps the constraints, but it breaks {broken}")


def check_ends(constraints: ConstraintSet, start: Array, goal: Array) -> None:
    """The same for both ends; and where the goal (n,) differs from the start in a held joint."""
    check_start(constraints, start)
    check_start(constraints, goal, "goal")
    moved = constraints.moved(start, goal)
    if moved:
        raise InvalidInputError("goal", goal.tolist(), f"a configuration with the held joints of the start: {moved}")


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
    """The rows at places of a path, and the smallest values found, as in ConstraintProof.

    Rows have to keep `floor` (r,), at most ROW_TOLERANCE below 0; `broken_at` is a place where one does not, None for none.
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
