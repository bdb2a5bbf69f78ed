"""Kinematics: pose, Jacobian, a measure of manipulability and its derivatives for one arm and one task.

Jacobians in the frame of a middle joint: the same manipulability with far fewer operations.

Rotating all rows does not change Yoshikawa's manipulability; nor does another reference point if the task has all six rows.
In such a frame base and tool angle do not occur, and the columns near the middle are short.
"""

import math
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from manipplan.kinematics.batch import BatchKernel, Evaluator, all_cores, batch_kernel, run_kernel
from manipplan.measures.measure import Measure, Posture, ToolPosture
from manipplan.measures.names import measure_of
from manipplan.measures.over_tools import OverTools
from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import MOST_THREADS, Array, ArrayLike, configurations, instance, one_of, whole_number
from manipplan.support.deadline import building
from manipplan.support.display import one_line
from manipplan.support.errors import CompilerError, InvalidInputError, UnknownNameError
from manipplan.support.expressions import making_expressions
from manipplan.support.memo import once_per_owner, source_of
from manipplan.symbolic.backends import chain_of
from manipplan.symbolic.chain import WORLD, Placement, SymbolicChain, constant, jacobian_of, step
from manipplan.symbolic.free_motion import FreeMotion
from manipplan.symbolic.machine_code import as_asked, check_compiled, compiled, do_without, wants_machine_code
from manipplan.symbolic.motion import LedMotion, Motion, Seen, task_rows
from manipplan.symbolic.spanned import usual_task
from manipplan.symbolic.task import Task

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot


def isometric_jacobians(chain: SymbolicChain, task: Task, plain: tuple[ca.SX, Motion]) -> tuple[ca.SX, tuple[ca.SX, Motion]]:
    """A Jacobian (m, n) with the manipulability of `task` and the fewest operations that we know, and one with its motion.

    The second is for derivatives of functions of det(J Jᵀ) alone. Both are `plain`, the task's rows, if these depend on the
    world axes.
    """
    if not (task.turns_freely and _straight(chain) and task.relative_to is None):
        return plain[0], plain
    n = len(chain.joints) - 1
    middle = (n + 1) // 2
    if task.tool_rows or len(task.world_rows) < 6:
        seen = _express_at(chain, n if task.tool_rows else middle, None)
        return _with_followers(chain, task.rows_of(*seen)), plain
    smooth = _rows_along(chain, task, *_sparsest_view(chain))
    return smooth[0], smooth


@once_per_owner
def _sparsest_view(chain: SymbolicChain) -> tuple[ca.SX, int]:
    """Of the Jacobians (6, N) along the axes of a middle joint for the origin of any joint one with the fewest entries.

    The second is the middle joint.
    """
    n = len(chain.joints) - 1
    middle = (n + 1) // 2
    views = [(_express_at(chain, f, at)[0], f) for f in (middle, max(middle - 1, 1)) for at in range(1, n + 1)]
    return min(views, key=lambda view: int(view[0].nnz()))


def _rows_along(chain: SymbolicChain, task: Task, seen: ca.SX, f: int) -> tuple[ca.SX, Motion]:
    """The rows of a pose task from a Jacobian (6, N) along the axes of joint f, and their motion."""
    rows = ca.sparsify(ca.DM(task.matrices[0]))
    return LedMotion.of(rows @ seen, ViewMotion(jacobian=seen, f=f, rows=rows), chain.tree)


def steady(chain: SymbolicChain, task: Task) -> tuple[ca.SX, Motion]:
    """A Jacobian (m, n) with the manipulability of `task` and its true derivatives, for functions of J Jᵀ + ρ² I.

    Such functions depend on the reference point of J. Here it is the origin of the middle joint, at rest in that frame.
    This takes a third more operations than `Posture.smooth`, and a third of those of the plain Jacobian.
    """
    n = len(chain.joints) - 1
    is_pose = task.turns_freely and not task.tool_rows and len(task.world_rows) == 6
    if not (_straight(chain) and is_pose and task.relative_to is None):
        return task_rows(chain, task)
    middle = (n + 1) // 2
    return _rows_along(chain, task, _express_at(chain, middle, middle)[0], middle)


@dataclass(frozen=True, kw_only=True)
class ViewMotion(Motion):
    """The six rows of a pose along the axes of joint f, for a reference point frozen in that frame at q.

    A column only changes with the joints between it and f: ∂_k S_j = ± [S_k, S_j], plus for f < k < j, minus for
    j < k <= f, with the bracket (w_k x v_j + v_k x w_j, w_k x w_j). So most of the kinematic Hessian is zero. If the
    reference point of `jacobian` moves with q, this is not the derivative of `jacobian`. But det(J Jᵀ) does not depend
    on the point, so its gradient and Hessian are still correct.

    Attributes:
        jacobian: (6, n), not weighted.
        f: the joint, counted from 1.
        rows: the task's rows (6, 6), including the task's length.
    """

    jacobian: ca.SX
    f: int
    rows: ca.DM

    def kinematic_hessian(self) -> list[ca.SX]:
        n = self.jacobian.shape[1]
        derivatives = []
        for k in range(n):
            moved = self._differentiate_axes(k)
            derivatives.append(self.rows @ ca.horzcat(*(moved.get(j, ca.SX(6, 1)) for j in range(n))))
        return derivatives

    def first(self, weights: ca.SX) -> ca.SX:
        plain = self.rows.T @ weights
        n = self.jacobian.shape[1]
        return ca.vertcat(
            *(sum((ca.dot(plain[:, j], s) for j, s in self._differentiate_axes(k).items()), ca.SX(0.0)) for k in range(n))
        )

    def second(self, weights: ca.SX) -> ca.SX:
        plain = self.rows.T @ weights
        n = self.jacobian.shape[1]
        out = ca.SX(n, n)
        for k in range(n):
            after = k >= self.f
            # <weights_j, [S_i, [S_k, S_j]]> = S_i · Σ_j (dual of [S_k, S_j] with weights_j), for every i nearer to f
            dual = sum((_dual(s, plain[:, j]) for j, s in self._differentiate_axes(k).items()), ca.SX(6, 1))
            for i in range(self.f, k + 1) if after else range(k, self.f):
                entry = ca.dot(self.jacobian[:, i], dual)
                out[i, k] = out[k, i] = entry if after else -entry
        return out

    def _differentiate_axes(self, k: int) -> dict[int, ca.SX]:
        """∂_k S_j for the j that joint k moves; joints counted from 0."""
        n = self.jacobian.shape[1]
        if k >= self.f:
            return {j: _bracket(self.jacobian[:, k], self.jacobian[:, j]) for j in range(k + 1, n)}
        return {j: -_bracket(self.jacobian[:, k], self.jacobian[:, j]) for j in range(k)}


def _straight(chain: SymbolicChain) -> bool:
    """Whether each joint carries the next and the last one the tool, and the expressions are our own."""
    n = len(chain.joints) - 1
    return chain.own and list(chain.model.parents)[1:] == list(range(n)) and chain.frame.parentJoint == n


def _with_followers(chain: SymbolicChain, jacobian: ca.SX) -> ca.SX:
    """The Jacobian by q of one with a column for each joint."""
    return jacobian @ ca.sparsify(ca.DM(chain.tree.matrix)) if chain.tree.has_followers else jacobian


def _bracket(a: ca.SX, b: ca.SX) -> ca.SX:
    return ca.vertcat(ca.cross(a[3:], b[:3]) + ca.cross(a[:3], b[3:]), ca.cross(a[3:], b[3:]))


def _dual(b: ca.SX, weights: ca.SX) -> ca.SX:
    """The vector d with <weights, [a, b]> = a · d for every a."""
    f, t = weights[:3], weights[3:]
    return ca.vertcat(ca.cross(b[3:], f), ca.cross(b[:3], f) + ca.cross(b[3:], t))


def _express_at(chain: SymbolicChain, f: int, at: int | None) -> tuple[ca.SX, ca.SX]:
    """The Jacobian (6, N) along the axes of joint f for the origin of joint `at` (None: the tool), and the tool's rotation.

    It has a column for each joint, whether it follows another or not.
    """
    frames = _frames_along(chain, f)
    end = frames[-1] @ constant(chain.frame.placement)
    point = end.origin if at is None else frames[at - 1].origin
    return ca.sparsify(jacobian_of(chain.tree.alone(), frames, point)), end.rotation


@once_per_owner
def _frames_along(chain: SymbolicChain, f: int) -> list[Placement]:
    """The placements of all joints in the frame of joint f."""
    tree, n = chain.tree, len(chain.joints) - 1
    frames = {f: WORLD}
    for i in range(f + 1, n + 1):
        frames[i] = frames[i - 1] @ step(tree, i, chain.q)
    for i in range(f - 1, 0, -1):
        frames[i] = frames[i + 1] @ step(tree, i + 1, chain.q).inverse()
    return [frames[i] for i in range(1, n + 1)]


#: Number of single configurations that CasADi's virtual machine evaluates before machine code is built.
FEW = 100
QUANTITIES = ("pose", "jacobian", "manipulability", "gradient", "hessian")


class SymbolicKinematics:
    """The CasADi expressions and Functions of one arm and task, each built on first use.

    Attributes:
        chain: the arm at symbolic q.
        posture: the quantities that measures depend on.
        joints: number of joints that can serve the task: all, or the fewest of a tool if the measure is over all tools.
    """

    def __init__(self, chain: SymbolicChain, task: Task, measure: Measure, robot: "Robot") -> None:
        self.chain = chain
        self.task = task
        self.measure = measure
        self.posture = posture_of(robot, chain, task)
        self.joints = min(map(len, map(robot.joints_of, robot.tools))) if measure.over_tools else robot.n
        self._expressions: dict[str, ca.SX] = {}

    @cached_property
    def pose(self) -> ca.Function:
        """T_world_tool (4, 4) of q (n,); the tool in the frame of a relative task."""
        return self.function("pose")

    @cached_property
    def jacobian(self) -> ca.Function:
        """Task Jacobian (m, n) of q (n,)."""
        return self.function("jacobian")

    @cached_property
    def manipulability(self) -> ca.Function:
        """The measure (1, 1) of q (n,)."""
        return self.function("manipulability")

    @cached_property
    def gradient(self) -> ca.Function:
        """The measure's gradient (n, 1) of q (n,)."""
        return self.function("gradient")

    @cached_property
    def hessian(self) -> ca.Function:
        """The measure's Hessian (n, n) of q (n,)."""
        return self.function("hessian")

    @cached_property
    @making_expressions()
    def mass_matrix(self) -> ca.Function:
        """M (n, n) of q (n,), with the rotors' inertia."""
        return ca.Function("mass_matrix", [self.chain.q], [ca.densify(self.chain.mass_matrix)], ["q"], ["M"])

    @making_expressions()
    def function(self, *quantities: str, with_sum: bool = False) -> ca.Function:
        """One Function of q for several of pose, jacobian, manipulability, gradient, hessian, and on request the sum of q."""
        outputs = [ca.densify(self._expression(quantity)) for quantity in quantities]
        names = list(quantities)
        if with_sum:
            outputs.append(ca.sum1(self.chain.q))
            names.append("sum")
        return ca.Function("_".join(quantities), [self.chain.q], outputs, ["q"], names)

    @making_expressions()
    def _expression(self, quantity: str) -> ca.SX:
        if quantity not in self._expressions:
            if quantity not in ("pose", "jacobian"):
                self.measure.check(self.task.rows, self.joints)
            build: dict[str, Callable[[], ca.SX]] = {
                "pose": Seen.of(self.chain, self.task).tool.matrix,
                "jacobian": lambda: self.posture.jacobian,
                "manipulability": lambda: self.measure.value(self.posture),
                "gradient": lambda: self.measure.gradient(self.posture),
                "hessian": lambda: self.measure.hessian(self.posture),
            }
            made = build[quantity]()
            n = self.chain.q.shape[0]
            shapes = {"manipulability": (1, 1), "gradient": (n, 1), "hessian": (n, n)}
            if not isinstance(made, ca.SX) or made.shape != shapes.get(quantity, made.shape):
                wanted = f"one whose {quantity} is a ca.SX of shape {shapes[quantity]}"
                raise InvalidInputError("measure", self.measure.name, wanted)
            self._expressions[quantity] = made
        return self._expressions[quantity]


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Kinematics:
    """Kinematics of `robot` for `task`; created by `Robot.kinematics`.

    Every method takes q (n,) or (..., n) [rad or m] and raises InvalidInputError for another shape, NaN or inf. The
    Jacobian is LOCAL_WORLD_ALIGNED: velocity of the tool's origin along world axes, then angular velocity about world axes
    times `task.length`. If the arm has fewer joints than the task has rows, a measure that would be identically zero raises
    InvalidInputError. Of a robot with several tools, pose and Jacobian are those of the first, and the measure is over all
    tools; `Robot.arm` gives the arm of each. With `relative_to` of the task, its frame takes the place of the world, and the
    measure is that of the motion of the first tool relative to it.

    Attributes:
        robot, task: the arm and its task.
        measure: evaluated by `manipulability`, `gradient` and `hessian`; Yoshikawa's manipulability by default.
        compiled: "auto", True or False; see `Robot.kinematics`.
        threads: number of threads that share a large batch.
        backend: source of the symbolic kinematics; see `Robot.kinematics`.
        chain: the arm at symbolic q.
        symbolic: the CasADi Functions themselves.
    """

    robot: "Robot"
    task: Task
    measure: Measure
    compiled: bool | str
    threads: int
    backend: str
    chain: SymbolicChain = field(repr=False)
    symbolic: SymbolicKinematics = field(init=False, repr=False)
    _own: threading.local = field(default_factory=threading.local, init=False, repr=False)
    _kernels: dict[str, BatchKernel | None] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        symbolic = SymbolicKinematics(self.chain, self.task, self.measure, self.robot)
        object.__setattr__(self, "symbolic", symbolic)

    @property
    def is_square(self) -> bool:
        """Whether the arm has as many joints as the task has rows, and the measure depends on det J."""
        return self.task.rows == self.robot.n and not (self.measure.over_tools or self.measure.constant)

    @property
    def free_motion(self) -> FreeMotion:
        """What the task leaves free of a pose: of a default task that is cut to what the joints span, what the whole one does.

        Raises InvalidInputError for a task whose rows do not fix a set of poses.
        """
        task = usual_task(self.robot) if self.task == self.robot.default_task else self.task
        return FreeMotion.of(task, planar=self.robot.planar)

    def __reduce__(self) -> tuple[object, ...]:
        return kinematics_of, (self.robot, self.task, self.measure, self.backend, self.compiled, self.threads)

    def of(self, robot: "Robot") -> "Kinematics":
        """The same for a robot whose joints and tools are the same, such as the arm with a part in its hand."""
        made = object.__new__(type(self))
        vars(made).update(vars(self) | {"robot": robot})
        return made

    def pose(self, q: ArrayLike) -> Array:
        """T_world_tool, (..., 4, 4); for a relative task the pose of the tool in the frame that it refers to."""
        return self._evaluate("pose", q)

    def jacobian(self, q: ArrayLike) -> Array:
        """Task Jacobian, (..., m, n) [m per rad or m]."""
        return self._evaluate("jacobian", q)

    def manipulability(self, q: ArrayLike) -> Array:
        """The measure, (...) [measure.unit(task)]; a scalar array for one q. Yoshikawa's manipulability by default."""
        return self._evaluate("manipulability", q)

    def gradient(self, q: ArrayLike) -> Array:
        """The measure's gradient, (..., n) [its unit per rad or m]."""
        return self._evaluate("gradient", q)

    def hessian(self, q: ArrayLike) -> Array:
        """The measure's exact Hessian, (..., n, n)."""
        return self._evaluate("hessian", q)

    def mass_matrix(self, q: ArrayLike) -> Array:
        """Joint-space inertia M with the rotors' inertia, (..., n, n) [kg m², kg m, kg]."""
        return self._columns(self.symbolic.mass_matrix, configurations("q", q, self.robot.n), self._shape("hessian"))

    @building()
    def evaluator(self, *quantities: str) -> Evaluator:
        """The fastest way to evaluate several quantities at one q: in one call, for instance per control step.

        `kin.evaluator("jacobian", "manipulability", "gradient")` returns a callable for `J, m, slope = call(q)`.

        Raises UnknownNameError for names other than pose, jacobian, manipulability, gradient and hessian.
        """
        if not quantities:
            raise InvalidInputError("quantities", quantities, f"at least one of {', '.join(QUANTITIES)}")
        for quantity in quantities:
            one_of("quantities", quantity, QUANTITIES)
        if len(set(quantities)) < len(quantities):
            raise InvalidInputError("quantities", quantities, "each quantity once")
        function = self.symbolic.function(*quantities, with_sum=True)
        if wants_machine_code(self.compiled):
            try:
                function = compiled(function, f"{function.name()} of {self.robot.name}")
            except CompilerError as error:
                do_without(error, self.compiled)
        return Evaluator(function, [self._shape(quantity) for quantity in quantities])

    def batch_code(self, quantity: str) -> tuple[int, int] | None:
        """The function of a quantity for other compiled code, see `BatchKernel.batch`; None where there is none."""
        kernel = self._kernel(one_of("quantity", quantity, QUANTITIES))
        return None if kernel is None else kernel.batch

    def _evaluate(self, quantity: str, q: ArrayLike) -> Array:
        n, shape = self.robot.n, self._shape(quantity)
        if not (type(q) is np.ndarray and q.dtype == np.float64 and q.ndim > 0 and q.shape[-1] == n):
            q = configurations("q", q, n)
        if q.ndim == 1:
            evaluators = self._own.__dict__  # each thread has its own
            if quantity not in evaluators:
                evaluators[quantity] = self._evaluator(quantity)
            value: Array = evaluators[quantity](q)[0].copy()
            return value
        if q.size == 0:
            return np.empty((*q.shape[:-1], *shape))
        kernel = self._kernel(quantity)
        if kernel is None:
            return self._columns(getattr(self.symbolic, quantity), configurations("q", q, n), shape)
        values = run_kernel(kernel, np.ascontiguousarray(q).reshape(-1, n), math.prod(shape), threads=self.threads)
        if values is None:
            raise InvalidInputError("q", q, "finite numbers, no NaN or inf")
        if len(shape) == 2:  # CasADi stores matrices column by column
            return np.ascontiguousarray(values.reshape(*q.shape[:-1], *shape[::-1]).swapaxes(-1, -2))
        return values.reshape(*q.shape[:-1], *shape)

    @building()
    def _evaluator(self, quantity: str) -> Evaluator:
        """The Evaluator of one quantity; its machine code is built after FEW calls, as a short script may need no more."""
        function = self.symbolic.function(quantity, with_sum=True)
        coded = as_asked([function], self.compiled, f"{function.name()} of {self.robot.name}", count=FEW)
        return Evaluator(coded.functions[0], [self._shape(quantity)], coded.pending)

    def _kernel(self, quantity: str) -> BatchKernel | None:
        """None: CasADi's virtual machine."""
        return self._kernels[quantity] if quantity in self._kernels else self._new_kernel(quantity)

    @building()
    def _new_kernel(self, quantity: str) -> BatchKernel | None:
        subject = f"{quantity} of {self.robot.name}, in batches"
        self._kernels[quantity] = batch_kernel(getattr(self.symbolic, quantity), self.compiled, subject)
        return self._kernels[quantity]

    def _shape(self, quantity: str) -> tuple[int, ...]:
        n = self.robot.n
        shapes = {"pose": (4, 4), "jacobian": (self.task.rows, n), "manipulability": (), "gradient": (n,), "hessian": (n, n)}
        return shapes[quantity]

    @staticmethod
    def _columns(function: ca.Function, q: Array, shape: tuple[int, ...]) -> Array:
        """Evaluate in CasADi's virtual machine, which takes all columns in one call and returns the results side by side."""
        batch = q.reshape(-1, q.shape[-1])
        if len(batch) == 0:
            return np.empty((*q.shape[:-1], *shape))
        out = np.asarray(function(ca.DM(batch.T)))
        rows, columns = (*shape, 1, 1)[:2]
        out = out.reshape(rows, len(batch), columns).transpose(1, 0, 2)
        return np.array(out.reshape((*q.shape[:-1], *shape)))


def kinematics_of(
    robot: "Robot", task: Task | None, measure: Measure | str | None, backend: str, compiled: bool | str, threads: int | None
) -> Kinematics:
    """The kinematics of a robot, built once for each set of arguments; see `Robot.kinematics`."""
    task = instance("task", task if task is not None else robot.default_task, Task)
    chosen = measure_for(robot, task, measure_of(measure))
    check_compiled(compiled)
    threads = all_cores() if threads is None else whole_number("threads", threads, least=1, most=MOST_THREADS)
    if not isinstance(backend, str):
        raise InvalidInputError("backend", backend, "the name of a backend")
    return _kinematics(robot, task, chosen, backend, compiled, threads)


def measure_for(robot: "Robot", task: Task, measure: Measure) -> Measure:
    """The measure for a robot and a task: over all tools where there are several and the task is that of each.

    Raises InvalidInputError or UnknownNameError when the task's frame, or a tool that has a weight, does not exist.
    """
    if task.relative_to is not None:
        frames = [frame.name for frame in robot.model.frames]
        if task.relative_to not in frames:
            raise UnknownNameError("relative_to", task.relative_to, frames)
        carriers = {robot.model.frames[frame_index(robot.model, name)].parentJoint for name in (task.relative_to, robot.tool)}
        if len(carriers) == 1:
            other = f", such as {' or '.join(robot.other_tools)}" if robot.other_tools else ""
            wanted = f"a frame that the tool {robot.tool} can move against{other}"
            raise InvalidInputError("relative_to", task.relative_to, wanted)
        if measure.over_tools:
            raise InvalidInputError("measure", measure.name, f"a measure of one motion: that relative to {task.relative_to}")
        return measure
    if len(robot.tools) > 1 and not (measure.over_tools or measure.constant):
        return OverTools(measure=measure)
    inner = getattr(measure, "measure", None)
    for each in (measure, inner):
        if isinstance(each, OverTools):
            each.check_tools(robot.tools)
    return measure


def posture_of(robot: "Robot", chain: SymbolicChain, task: Task) -> Posture:
    """The symbolic quantities of a robot that measures depend on."""
    jacobian, motion = plain = task_rows(chain, task)
    isometric, smooth = isometric_jacobians(chain, task, plain)

    def tools() -> dict[str, ToolPosture]:
        """The posture of each tool's arm."""
        found = {}
        for tool in robot.tools:
            arm, joints = robot.arm(tool), robot.joints_of(tool)
            posture = posture_of(arm, chain_of(arm, "auto"), task)
            found[tool] = ToolPosture(posture=posture, joints=joints, q=chain.q)
        return found

    return Posture(
        q=chain.q,
        jacobian=jacobian,
        motion=motion,
        isometric=isometric,
        smooth=smooth,
        mass_matrix=lambda: chain.mass_matrix,
        lower=robot.limits.lower,
        upper=robot.limits.upper,
        tools=cache(tools),
    )


@once_per_owner
def _kinematics(robot: "Robot", task: Task, measure: Measure, backend: str, compiled: bool | str, threads: int) -> Kinematics:
    if source_of(robot) is not robot:
        return _kinematics(source_of(robot), task, measure, backend, compiled, threads).of(robot)
    return Kinematics(
        robot=robot,
        task=task,
        measure=measure,
        compiled=compiled,
        threads=threads,
        backend=backend,
        chain=chain_of(robot, backend),
    )
