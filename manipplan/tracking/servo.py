"""Servo: joint velocities from a stream of twists, poses or joint velocities, through and out of singularities.

The law is `csrc/servo.c`, which docs/concepts/servo.md derives. Here are the CasADi Function of what depends on the arm (the
columns of its Jacobian, the bounds, the rows of the avoidance) and the class that calls both.
"""

import ctypes
from collections.abc import Collection, Mapping
from enum import IntEnum
from pathlib import Path
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from manipplan.plans.result import Plan
from manipplan.robots.arms import one_tool
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, array_of_shape, instance, number, one_of, texts
from manipplan.support.compiler import load_library
from manipplan.support.errors import CompilerError, InvalidInputError
from manipplan.support.expressions import making_expressions
from manipplan.support.kernels import load_kernel, struct
from manipplan.symbolic.chain import SymbolicChain
from manipplan.symbolic.free_motion import NOTHING, FreeMotion, Turns
from manipplan.symbolic.machine_code import check_compiled, do_without, generate_source, native_flags, wants_machine_code
from manipplan.symbolic.task import Task
from manipplan.tracking.avoidance import OBSTACLE_SIZE, Avoidance, avoidance_rows, set_moving
from manipplan.tracking.bounds import velocity_bounds
from manipplan.tracking.reference import reference_of

#: Maximum number of joints, those that follow others included; as in servo.c.
MOST_JOINTS = 16
#: Metres per radian of a task that is not given: the law's thresholds are chosen for it.
LENGTH = 0.3
#: Ratio of the longest time step to `dt`.
LONGEST_STEP = 5.0
#: Rows of a twist, as `free` names them.
DIRECTIONS = ("x", "y", "z", "rx", "ry", "rz")
#: Which way out of a fold, and in which axes a command is; numbered as in servo.c.
WAYS = ("same", "other", "free")
FRAMES = ("world", "tool", "base")
#: Largest change of a row from one step to the next with which the rows count as the same.
TURNED = 0.1
#: In place of a frame or `free` that may have other contents at the next step.
_CHANGING = object()
PROBLEM = "servo_problem"
INPUTS = ("q", "qd", "qdd", "dt", "obstacles")
OUTPUTS = ("columns", "rotation", "origin", "low", "high", "matrix", "bound", "distance")


class ServoStatus(IntEnum):
    """How a step ended."""

    FOLLOWING = 0
    #: The QP was not solved: the arm brakes.
    NOT_SOLVED = 1
    #: There was no new command for longer than `timeout`: the arm brakes.
    STALE = 2
    #: The command or an obstacle is not finite, the command is 1e6 m/s or rad/s or more, the target is no pose, or the axes are
    #: no rotation: the arm brakes.
    BAD_COMMAND = 3
    #: The state is not finite: the velocity is zero.
    BAD_STATE = 4
    #: The time step is not above 0, or more than five times `dt`: the arm brakes.
    BAD_TIME_STEP = 5


class Singularity(IntEnum):
    """Kind of the next singularity in the commanded direction."""

    #: All singular values of the task's Jacobian are above 0.12 m.
    CLEAR = 0
    #: The edge of the reach, such as a straight elbow: the tool comes back, whichever way the arm folds.
    FOLD = 1
    #: A posture that can be passed, such as a straight wrist: joints turn fast beside it.
    POLE = 2


class ServoLimit(IntEnum):
    """What limits a step most."""

    NOTHING = 0
    POSITION = 1
    VELOCITY = 2
    ACCELERATION = 3
    OBSTACLE = 4


class ServoGauge(NamedTuple):
    """What a teleoperator wants to know about a step.

    Attributes:
        status: how it ended; the arm brakes unless it is FOLLOWING.
        followed: speed along the command over commanded speed.
        slip: speed across the command over commanded speed.
        kind, joint: the next singularity in the commanded direction, and the joint that moves most in its lost direction;
            "" if clear.
        seconds, metres: time and way of the tool to it at the commanded speed [s, m]; inf if none is ahead.
        wall: share of the command, in [0, 1], that points into the edge of the reach, such as for haptic feedback.
        reason, limit_joint: what limits the step most, and which joint; "" for none or an obstacle.
        smallest: smallest singular value of the task's Jacobian [m], where the way is clear a lower bound of it; NaN without a
            command.
        clearance: smallest distance of the avoidance [m]; inf without one.
    """

    status: ServoStatus
    followed: float
    slip: float
    kind: Singularity
    joint: str
    seconds: float
    metres: float
    wall: float
    reason: ServoLimit
    limit_joint: str
    smallest: float
    clearance: float


class Servo:
    """Joint velocities that follow streams of twists, poses or joint velocities, through singularities and out of them.

    Every step keeps the position, velocity and acceleration limits exactly, from any state from which the arm can stop in time,
    and jerk limits where they are finite and time steps equal `dt`. Values from sensors or operators never raise an error: a
    command that is NaN, late or no pose makes the arm brake, and `gauge` says so.

    Beside a singularity the tool follows what it can: it leaves the edge of the reach by the shortest way, passes a straight
    wrist with the least damping, and turns out of exact zeros, see docs/concepts/servo.md. Goes beyond [dufour2020].

    A servo is not thread-safe.

    Attributes:
        robot, dt, task, side: the arguments.
        reference: of the plan that was given: where it begins, and the motion there; None without a plan.
        pairs: names of the pairs of bodies that are kept apart.
        compiled: whether the arm's part of a step runs as machine code; the law always does.
    """

    def __init__(
        self,
        robot: Robot,
        *,
        dt: float,
        task: Task | None = None,
        side: str = "same",
        reference: Plan | None = None,
        avoidance: Avoidance | None = None,
        smoothing: float = 0.0,
        timeout: float = 0.1,
        compiled: bool | str = "auto",
    ) -> None:
        """Build the step; with a compiler this takes a second the first time.

        Args:
            robot: the arm with its limits, of at most 16 joints.
            dt: time step [s]; single steps may take any time up to five times as long.
            task: the rows that are followed; default: whole twists with 0.3 m per radian, or the robot's default task where
                this has fewer rows.
            side: which way the arm leaves the edge of its reach: to the "same" side from which it came (elbow up stays up),
                to the "other" one, or "free": to the side with more room to joint limits. A straight wrist is passed whatever
                it is: no setting keeps the arm on one side; nor a joint that the rows which are followed can pass.
            avoidance: collision avoidance; None: no avoidance.
            smoothing: time constant of a low-pass filter of the command [s]; 0: none.
            timeout: time after which a command that was not renewed is stale [s].
            compiled: as in `Robot.kinematics`.

        Raises:
            InvalidInputError: an argument is invalid.
            CompilerError: compiled is True and there is no compiler, or it fails.
        """
        one_tool(instance("robot", robot, Robot), "a servo")
        self.robot, self.dt = robot, number("dt", dt, above=0.0)
        self.side = one_of("side", side, WAYS)
        check_compiled(compiled)
        if task is None:
            task = Task.pose(LENGTH) if robot.default_task.name == "pose" else robot.default_task
        self.task = _usable(task)
        self.reference = None if reference is None else reference_of(reference, robot, self.task)
        self._avoidance = None if avoidance is None else instance("avoidance", avoidance, Avoidance)
        self.law: Any = struct("servo", "Servo")()
        self.law.smoothing = number("smoothing", smoothing, least=0.0)
        self.law.timeout = number("timeout", timeout, least=0.0)
        chain = SymbolicChain.of(robot.model, robot.tool)
        if len(chain.tree.leader) > MOST_JOINTS:
            raise InvalidInputError("robot", f"{robot.name}, with {len(chain.tree.leader)} joints", f"at most {MOST_JOINTS}")
        self._problem, self.pairs = _problem_of(robot, chain, self.dt, self._avoidance)
        self._describe(chain)
        self._library = _library_of(self._problem, robot.name, compiled)
        self.compiled = self._library is not None
        self._connect()
        self.reset()
        if avoidance is not None:
            scene = dict(zip(avoidance.scene.names, avoidance.scene.obstacles, strict=True))
            set_moving(avoidance, {name: (scene[name].pose, np.zeros(6)) for name in avoidance.moving}, self._obstacles)

    def __repr__(self) -> str:
        how = "machine code" if self.compiled else "virtual machine"
        return f"Servo({self.robot!r}, dt={self.dt:g}, task={self.task.name!r}, side={self.side!r}, {how})"

    def __reduce__(self) -> Any:
        raise TypeError("a Servo cannot be copied or pickled, as it holds machine code: make one in each process")

    def step(
        self,
        q: ArrayLike,
        qd: ArrayLike,
        twist: ArrayLike | None,
        frame: str | ArrayLike = "tool",
        *,
        free: Collection[str] | None = None,
        obstacles: Mapping[str, tuple[Any, ArrayLike]] | None = None,
        dt: float | None = None,
    ) -> Array:
        """Joint velocities (n,) to command for the next `dt` that move the tool with `twist`.

        Args:
            q: positions (n,) [rad or m]; where measurements are late, those that were commanded.
            qd: last commanded velocities (n,).
            twist: velocity (6,) of the tool's origin [m/s], then of its rotation [rad/s]; None: no new command, so the last one
                goes on until `timeout`.
            frame: axes of the twist: "world", "base", "tool", or the rotation (3, 3) of other axes in the world, such as a
                camera's.
            free: directions of these axes that need not be followed, of "x", "y", "z", "rx", "ry" and "rz"; they replace those
                that the task leaves free. None: the task's.
            obstacles: name -> (pose, velocity (6,) of its origin, linear first) of the moving obstacles; default: their last
                pose, at rest.
            dt: time that this step takes [s], at most five times the servo's; default: that.

        `gauge` tells the result. Raises InvalidInputError only for arguments of a wrong shape or name, never for values.
        """
        if frame is not self._frame or free is not self._free:
            self._choose_axes(frame, free)
        return self._step(_TWIST, q, qd, "twist", self._twist, twist, obstacles, dt)

    def step_pose(
        self,
        q: ArrayLike,
        qd: ArrayLike,
        pose: Any,
        *,
        obstacles: Mapping[str, tuple[Any, ArrayLike]] | None = None,
        dt: float | None = None,
    ) -> Array:
        """The same towards a `pose` (4, 4) or pin.SE3 of the tool in the world: no faster than the tool can stop there.

        Rotations that the task leaves free need not be reached.
        """
        if self._frame != "world" or self._free is not None:
            self._choose_axes("world", None)
        pose = array_of_shape("pose", getattr(pose, "homogeneous", pose), (4, 4)).ravel()
        return self._step(_POSE, q, qd, "pose", self._pose, pose, obstacles, dt)

    def step_joints(
        self,
        q: ArrayLike,
        qd: ArrayLike,
        velocity: ArrayLike,
        *,
        obstacles: Mapping[str, tuple[Any, ArrayLike]] | None = None,
        dt: float | None = None,
    ) -> Array:
        """The joint velocities (n,) nearest to `velocity` (n,) that keep limits and distances: a joint jog."""
        velocity = array_of_shape("velocity", velocity, (self.robot.n,))
        return self._step(_JOINTS, q, qd, "velocity", self._joints, velocity, obstacles, dt)

    def brake(self, q: ArrayLike, qd: ArrayLike, *, dt: float | None = None) -> Array:
        """Joint velocities (n,) that brake as hard as all limits allow."""
        return self._step(_BRAKE, q, qd, "", self._joints, None, None, dt)

    def reset(self) -> None:
        """Clear the memory of past steps: last command, last acceleration, the side of a singularity that was approached."""
        s = self.law
        for name in ("qdd", "held", "filtered", "inside", "way", "stays", "reverses"):
            ctypes.memset(ctypes.addressof(s) + getattr(type(s), name).offset, 0, getattr(type(s), name).size)
        s.age = np.inf
        s.guessed = s.has_inside = s.has_way = s.leaves = s.placed = 0

    @property
    def gauge(self) -> ServoGauge:
        """What the last step did, and what is ahead."""
        s, names = self.law, self.robot.joint_names
        return ServoGauge(
            status=ServoStatus(s.status),
            followed=s.followed,
            slip=s.slip,
            kind=Singularity(s.kind),
            joint=names[s.joint] if s.joint >= 0 else "",
            seconds=s.seconds,
            metres=s.metres,
            wall=s.wall,
            reason=ServoLimit(s.limit),
            limit_joint=names[s.limit_joint] if s.limit_joint >= 0 else "",
            smallest=s.smallest,
            clearance=s.clearance,
        )

    @property
    def symbolic(self) -> ca.Function:
        """What depends on the arm, as a CasADi Function from q, qd, qdd, dt and the moving obstacles' numbers to the Jacobian's
        columns, the tool's rotation and origin, the bounds of the velocities, and rows, bounds and distances of the avoidance.
        """
        return self._problem

    @property
    def obstacles(self) -> Array:
        """The numbers of the moving obstacles, as `set_moving` writes them."""
        return self._obstacles.copy()

    def export_c(self, folder: str | Path) -> list[Path]:
        """Write a self-contained C project with the same numbers, bit by bit: header, sources, CMake file, example program.

        Frames that are given by a rotation, and `free`, are left to Python. Returns the files; raises InvalidInputError when
        the folder cannot be written.
        """
        from manipplan.tracking.export import export_servo

        return export_servo(self, folder)

    @property
    def status(self) -> ServoStatus:
        """How the last step ended."""
        return ServoStatus(self.law.status)

    def _describe(self, chain: SymbolicChain) -> None:
        """Write the arm and the settings to the struct; arrays that it points to live as long as this servo."""
        s, limits = self.law, self.robot.limits
        self._arrays = {
            "leader": np.ascontiguousarray(chain.tree.leader, dtype=np.int_),
            "ratio": np.ascontiguousarray(chain.tree.ratio, dtype=np.float64),
            **{name: np.ascontiguousarray(getattr(limits, name)) for name in ("lower", "upper", "velocity", "acceleration")},
            **{name: np.zeros(max(self._problem.nnz_out(name), 1)) for name in OUTPUTS},
            "selection": np.zeros((6, 6)),
        }
        if self.reference is not None:
            self._arrays["planned"] = self.reference.q
            self._arrays["rotations"] = self.reference.poses[:, :3, :3].transpose(0, 2, 1).copy()
            self._arrays["origins"] = self.reference.poses[:, :3, 3].copy()
            s.knots = len(self.reference.q)
        world, tool = self.task.matrices
        free = _free_motion(self.task, planar=self.robot.planar)
        s.free_turns = list(Turns).index(free.turns)
        _view(s, "free_axis", 3)[:] = free.axis
        names = ("leader", "ratio", "lower", "upper", "velocity", "acceleration")
        #: constant numbers of the law, by their names in servo.c; `axes` are those of the base
        self.constants = {
            **{name: self._arrays[name] for name in names},
            "selection": np.concatenate([world, tool]),
            "free_axis": free.axis,
            "axes": self.robot.base[:3, :3].T,
            **{name: self._arrays.get(name, np.zeros(1)) for name in ("planned", "rotations", "origins")},
        }
        for name, array in self._arrays.items():
            setattr(s, name, array.ctypes.data)
        s.joints, s.physical, s.pairs = self.robot.n, len(chain.tree.leader), len(self.pairs)
        s.usual, s.slowest, s.side = self.dt, LONGEST_STEP * self.dt, WAYS.index(self.side)
        s.limit_joint = s.joint = -1

    def _connect(self) -> None:
        """Connect the arrays that the Function and the law read and write."""
        n, s = self.robot.n, self.law
        places = (("q", n), ("qd", n), ("command", n), ("command", 6), ("pose", 16))
        views: list[Any] = [_view(s, name, count).data for name, count in places]
        self._q, self._qd, self._joints, self._twist, self._pose = views
        self._axes, self._result = _view(s, "axes", 9), _view(s, "result", n)
        self._obstacles = np.zeros(self._problem.nnz_in("obstacles"))
        inputs = [_view(s, "q", n), _view(s, "qd", n), _view(s, "qdd", n), _view(s, "dt", 1), self._obstacles]
        outputs = [self._arrays[name] for name in OUTPUTS]
        s.obstacles, s.moving = self._obstacles.ctypes.data, len(self._obstacles) // OBSTACLE_SIZE
        self._frame: Any = _CHANGING
        self._free: Any = None
        self._choose_axes("tool", None)
        self._law = load_kernel("servo").functions(quick=("servo",))["servo"]
        self._address = ctypes.addressof(s)
        if self._library is not None:
            self._pointers = _point_to(s, self._library, inputs, outputs)
            return
        self._buffer, self._evaluate = self._problem.buffer()
        for i, array in enumerate(inputs):
            self._buffer.set_arg(i, array.data)
        for i, array in enumerate(outputs[: self._problem.n_out()]):
            self._buffer.set_res(i, array.data)

    def _step(
        self, mode: int, q: ArrayLike, qd: ArrayLike, name: str, into: Any, command: Any, obstacles: Any, dt: float | None
    ) -> Array:
        """One step with a command, the argument `name`, that is written `into` a view of the struct; None: no new one."""
        s = self.law
        s.mode, s.fresh = mode, command is not None
        try:  # memoryviews take exactly as many doubles as they hold
            if not (type(q) is type(qd) is np.ndarray):
                raise TypeError
            self._q[:] = q
            self._qd[:] = qd
            if command is not None:
                if type(command) is not np.ndarray:
                    raise TypeError
                into[:] = command
        except (TypeError, ValueError):
            given = {"q": (self._q, q), "qd": (self._qd, qd)} | ({} if command is None else {name: (into, command)})
            for argument, (view, value) in given.items():
                np.asarray(view)[:] = array_of_shape(argument, value, view.shape)
        if obstacles is not None or self._obstacles.size:
            set_moving(self._avoidance, {} if obstacles is None else obstacles, self._obstacles)
        s.dt = self.dt if dt is None else float(array_of_shape("dt", dt, ()))
        if self._library is None:
            self._evaluate()
        self._law(self._address)
        velocity: Array = self._result.copy()
        return velocity

    def _choose_axes(self, frame: str | ArrayLike, free: Collection[str] | None) -> None:
        """Set the axes of twists, and the rows that are followed."""
        s = self.law
        unfollowed = None if free is None else _directions(free)
        if isinstance(frame, str):
            s.frame = {"world": _WORLD, "tool": _TOOL, "base": _OTHER_AXES}[one_of("frame", frame, FRAMES)]
            axes = self.robot.base[:3, :3]
        else:
            s.frame, axes = _OTHER_AXES, array_of_shape("frame", frame, (3, 3))
        self._axes[:] = axes.ravel(order="F")
        world, tool = self.task.matrices
        if unfollowed is not None:
            rows = np.diag([1.0] * 3 + [self.task.length] * 3)[[name not in unfollowed for name in DIRECTIONS]]
            turned = np.kron(np.eye(2), np.eye(3) if s.frame == _WORLD else axes.T)
            world, tool = (np.empty((0, 6)), rows) if s.frame == _TOOL else (rows @ turned, np.empty((0, 6)))
        selection = np.concatenate([world, tool])
        before = self._arrays["selection"][: len(selection)]
        # what was learned still holds in axes that turn slowly, such as a camera's
        alike = (s.world_rows, s.tool_rows) == (len(world), len(tool)) and np.abs(before - selection).max() <= TURNED
        if not alike:
            s.guessed = s.has_inside = s.has_way = s.leaves = 0
        before[:] = selection
        s.world_rows, s.tool_rows = len(world), len(tool)
        self._frame = frame if isinstance(frame, str) else _CHANGING
        self._free = free if isinstance(free, str | tuple | None) else _CHANGING


#: What is commanded, and in which axes; as in servo.c.
_TWIST, _POSE, _JOINTS, _BRAKE = range(4)
_WORLD, _TOOL, _OTHER_AXES = range(3)


def _usable(task: Task) -> Task:
    instance("task", task, Task)
    if task.relative_to is not None:
        raise InvalidInputError("task", task, "a task in the world, in which the tool moves")
    if task.region is not None:
        raise InvalidInputError("task", task, "a task without a region: a servo follows the command itself")
    if task.rows > len(DIRECTIONS):
        raise InvalidInputError("task", task, "at most six rows")
    return task


def _free_motion(task: Task, *, planar: bool) -> FreeMotion:
    """What of a pose need not be reached; nothing of its rotation for a task that fixes no set of poses."""
    try:
        return FreeMotion.of(task, planar=planar)
    except InvalidInputError:
        return NOTHING


def _directions(free: Collection[str]) -> Collection[str]:
    names = [one_of("free", name, DIRECTIONS) for name in texts("free", free)]
    if len(set(names)) == len(DIRECTIONS):
        raise InvalidInputError("free", names, "at most five of the six directions")
    return names


@making_expressions()
def _problem_of(
    robot: Robot, chain: SymbolicChain, dt: float, avoidance: Avoidance | None
) -> tuple[ca.Function, tuple[tuple[str, str], ...]]:
    """The Function from INPUTS to OUTPUTS, and the names of the pairs of its rows."""
    n = chain.q.shape[0]
    qd, qdd, step = ca.SX.sym("qd", n), ca.SX.sym("qdd", n), ca.SX.sym("dt")
    rows = avoidance_rows(robot, chain, avoidance, brakes_in_time=True) if avoidance else None
    slowest = LONGEST_STEP * dt
    usable = ca.logic_and(step > 0, step <= slowest * (1 + 1e-9))
    low, high = velocity_bounds(chain.q, qd, qdd, robot.limits, dt, step=ca.if_else(usable, step, dt))
    made = {
        "columns": chain.alone.jacobian,
        "rotation": chain.tool.rotation,
        "origin": chain.tool.origin,
        "low": low,
        "high": high,
        "matrix": rows.matrix.T if rows else ca.SX(0, 1),
        "bound": rows.bound if rows else ca.SX(0, 1),
        "distance": rows.distance if rows else ca.SX(0, 1),
    }
    inputs = [chain.q, qd, qdd, step, rows.obstacles if rows else ca.SX(0, 1)]
    outputs = ca.cse([ca.densify(made[name]) for name in OUTPUTS])
    return ca.Function(PROBLEM, inputs, outputs, list(INPUTS), list(OUTPUTS)), rows.names if rows else ()


def _library_of(problem: ca.Function, robot: str, compiled: bool | str) -> ctypes.CDLL | None:
    """The machine code of the Function, where `compiled` asks for it and it can be built."""
    if not wants_machine_code(compiled):
        return None
    source = generate_source([problem])

    def load(file: Path) -> ctypes.CDLL:
        library = ctypes.CDLL(str(file))
        getattr(library, PROBLEM).restype = ctypes.c_int
        return library

    try:
        return load_library(source, load, flags=(*native_flags(source), "-lm"), subject=f"a servo of {robot}")
    except CompilerError as error:
        do_without(error, compiled)
        return None


def _point_to(s: Any, library: ctypes.CDLL, inputs: list[Array], outputs: list[Array]) -> list[Any]:
    """Point the struct to the machine code and to the arrays that it reads and writes; returns what has to live on."""
    sizes = [ctypes.c_longlong() for _ in range(4)]
    getattr(library, f"{PROBLEM}_work")(*map(ctypes.byref, sizes))
    arguments, results, integers, numbers = (each.value for each in sizes)
    held: list[Any] = [
        (ctypes.c_void_p * max(arguments, len(inputs)))(*(each.ctypes.data for each in inputs)),
        (ctypes.c_void_p * max(results, len(outputs)))(*(each.ctypes.data for each in outputs)),
        (ctypes.c_longlong * (integers + 1))(),
        (ctypes.c_double * (numbers + 1))(),
        *inputs,
    ]
    s.argument, s.results, s.integers, s.work = (ctypes.addressof(each) for each in held[:4])
    s.problem = ctypes.cast(getattr(library, PROBLEM), ctypes.c_void_p).value
    return held


def _view(s: Any, name: str, count: int) -> Array:
    """The first numbers of an array of the struct, which keeps the struct alive."""
    return np.frombuffer(s, dtype=np.float64, count=count, offset=getattr(type(s), name).offset)
