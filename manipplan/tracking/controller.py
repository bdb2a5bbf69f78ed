"""Controller: joint velocities that follow a target and raise manipulability, from one compiled QP per step."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from manipplan.cost.objective import PathObjective
from manipplan.measures.measure import Measure
from manipplan.paths.tolerance import Tolerance
from manipplan.plans.result import Plan
from manipplan.robots.arms import one_tool
from manipplan.robots.robot import Robot
from manipplan.support.checks import (
    Array,
    ArrayLike,
    array_of_shape,
    finite_array,
    instance,
    number,
    number_array,
    one_of,
    positive_array,
)
from manipplan.support.display import one_line
from manipplan.support.errors import CompilerError, InvalidInputError
from manipplan.symbolic.machine_code import do_without, wants_machine_code
from manipplan.symbolic.task import Task
from manipplan.tracking.avoidance import Avoidance, set_moving
from manipplan.tracking.bodies import CapsuleBodies, CapsuleBody
from manipplan.tracking.bounds import limits_jerk
from manipplan.tracking.export import MachineCode, Sources
from manipplan.tracking.formulations import Formulation
from manipplan.tracking.reference import reference_of
from manipplan.tracking.step import HUGE, REPORT, StepSetup, StepStatus, step_of

#: Maximum number of characters of generated code that compiled="auto" compiles.
MOST_CHARACTERS = 1_500_000


class StepReport(NamedTuple):
    """Result of one step.

    Attributes:
        status: outcome of the step; the arm brakes unless it is SOLVED or STALLED.
        manipulability: m before the step.
        position_deviation, rotation_deviation: from the target, after the step, to first order [m, rad].
        tube_excess: violation of the tube, or of the required return into it, that this step cannot avoid, in the unit of the
            task's rows [m].
        clearance: minimum distance before the step [m]; inf without avoidance, negative in contact.
        avoidance_excess: amount by which an approach velocity exceeds its limit [m/s].
        convexified: largest entry added to make the cost convex; 0 if it was convex.
    """

    status: StepStatus
    manipulability: float
    position_deviation: float
    rotation_deviation: float
    tube_excess: float
    clearance: float
    avoidance_excess: float
    convexified: float


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Rollout:
    """N steps: q and qd (N + 1, n) with the start in the first row, and the report of each step (N, 8)."""

    q: Array
    qd: Array
    reports: Array

    def __getitem__(self, figure: str) -> Array:
        """One figure of the reports (N,), by its name in StepReport."""
        return np.asarray(self.reports[:, REPORT.index(one_of("figure", figure, REPORT))])


class Controller:
    """A controller of `robot` with time step `dt`; the equations are those of dufour2020.

    From any state from which the arm can stop in time, every step keeps the position, velocity and acceleration limits
    exactly, and the jerk limits where they are finite. Values from sensors or planners never raise an error: if the target
    is NaN or no pose, such as a matrix of zeros, the arm brakes, and `report` says so. A rounded target is taken to the nearest
    pose.

    A controller is not thread-safe.

    Attributes:
        robot, formulation, dt, task: the arguments; `task` is the robot's default task if none was given.
        kinematics: of the task, with the measure that is raised.
        stiffness: default of Q_δ.
        tolerance: default tube; None if the controller was made without one.
        pairs: names of the pairs of bodies that are kept apart.
        unguarded: pairs of the robot's own bodies that are not kept apart, with the reason.
        compiled: whether steps run as machine code.
    """

    def __init__(
        self,
        robot: Robot,
        formulation: Formulation,
        *,
        dt: float,
        task: Task | None = None,
        measure: Measure | str | None = None,
        stiffness: float = 1e4,
        weights: ArrayLike = 1.0,
        approach: float = 2.0,
        tolerance: Tolerance | None = None,
        avoidance: Avoidance | None = None,
        reference: Plan | None = None,
        compiled: bool | str = "auto",
    ) -> None:
        """Build the step; with a compiler this takes seconds the first time, or a minute for a measure with a long Hessian.

        Args:
            robot: the arm, with its limits.
            formulation: Classical, General, Objective, Equality or LogDrive of `manipplan.formulations`, or your own.
            dt: time step T > 0 [s].
            task: task that is tracked, and whose manipulability counts; default `robot.default_task`.
            measure: the manipulability that is raised, a name from `available_measures()` or a Measure that is at least zero
                and better when larger; default: Yoshikawa's.
            stiffness: default of Q_δ > 0, per row in metres.
            weights: diagonal of Q > 0, one number or n.
            approach: deceleration a > 0 [m/s²] at which the correction of a deviation e can be braked: its speed is at most
                sqrt(2 a |e|), with angles scaled by the task's length. inf: correction within one step, as in the paper,
                which overshoots where accelerations are bounded.
            tolerance: default tube around the target; None: no tube.
            avoidance: collision avoidance; None: no avoidance.
            reference: a plan along the tool path, such as that of `mp.follow`, for this arm and task. The null space returns
                to the planned configurations, in the branch that the plan chose. Begin at `reference.start`: from another
                branch the arm is not pulled. None: the formulation decides alone.
            compiled: as in `Robot.kinematics`; "auto" does not compile a step with several hundred pairs of bodies, which
                would take minutes: give `Avoidance` fewer links.

        Raises:
            InvalidInputError: an argument is invalid, or Classical has a tolerance or an avoidance.
            CompilerError: compiled is True and there is no compiler, or it fails.
        """
        one_tool(instance("robot", robot, Robot), "a controller")
        if task is not None and instance("task", task, Task).relative_to is not None:
            raise InvalidInputError("task", task, "a task in the world, in which targets are given")
        if task is not None and task.region is not None:
            raise InvalidInputError("task", task, "a task without a region: a controller tracks the target itself")
        if not isinstance(formulation, Formulation):
            raise InvalidInputError("formulation", formulation, "a Formulation, such as formulations.LogDrive()")
        self.robot, self.formulation, self.dt = robot, formulation, number("dt", dt, above=0.0)
        for name, value, kind in (("tolerance", tolerance, Tolerance), ("avoidance", avoidance, Avoidance)):
            if value is not None:
                instance(name, value, kind)
                if not formulation.solves_qp:
                    wanted = f"None with {type(formulation).__name__}, which has no inequality constraints"
                    raise InvalidInputError(name, value, wanted)
        if (
            np.isfinite(robot.limits.jerk).any()
            and not np.isfinite(robot.limits.velocity[np.isfinite(robot.limits.jerk)]).all()
        ):
            raise InvalidInputError(
                "limits.velocity", robot.limits.velocity, "a velocity limit for each joint with a jerk limit"
            )
        self.kinematics = PathObjective(task=task, measure=measure).kinematics(robot, compiled=compiled)
        self.task = self.kinematics.task
        self.tolerance, self._avoidance = tolerance, avoidance
        #: of the plan that was given; None without one
        self.reference = None if reference is None else reference_of(reference, robot, self.task)
        setup = StepSetup(
            kinematics=self.kinematics,
            formulation=formulation,
            dt=self.dt,
            weights=positive_array("weights", weights, robot.n),
            approach=float(positive_array("approach", approach, 1)[0]),
            tube=tolerance is not None,
            avoidance=avoidance,
            reference=self.reference,
        )
        self._step = step_of(setup)
        self.pairs = self._step.pairs
        self.unguarded: Mapping[tuple[str, str], str] = (
            CapsuleBodies.of(robot).dropped if avoidance is not None and avoidance.itself else {}
        )
        self._machine: MachineCode | None = None
        function = self._step.function
        sources = self.sources() if wants_machine_code(compiled) else None
        if sources is not None and (compiled is True or len(sources.step) <= MOST_CHARACTERS):
            try:
                self._machine = MachineCode(sources, f"a controller of {robot.name}")
                function = self._machine.function
            except CompilerError as error:
                do_without(error, compiled)
        self.compiled = self._machine is not None
        self._connect(function, number("stiffness", stiffness, above=0.0))

    def __repr__(self) -> str:
        how = "machine code" if self.compiled else "virtual machine"
        return f"Controller({self.robot!r}, {self.formulation!r}, dt={self.dt:g}, task={self.task.name!r}, {how})"

    def __reduce__(self) -> Any:
        raise TypeError("a Controller cannot be copied or pickled, as it holds machine code: make one in each process")

    @property
    def bodies(self) -> tuple[CapsuleBody, ...]:
        """The capsules that an avoidance keeps apart, each with its radius and its excess beyond the link."""
        return CapsuleBodies.of(self.robot).items

    def sources(self) -> Sources:
        """The controller in C."""
        return Sources.of(self._step.function, self.robot.name, self.dt)

    @property
    def symbolic(self) -> ca.Function:
        """The step as a CasADi Function; its inputs and outputs are described in `manipplan.tracking.step`."""
        return self._step.function

    def step(
        self,
        q: ArrayLike,
        qd: ArrayLike,
        target: Any,
        *,
        qdd: ArrayLike | None = None,
        stiffness: float | None = None,
        drive: float = 1.0,
        tolerance: Tolerance | None = None,
        obstacles: Mapping[str, tuple[Any, ArrayLike]] | None = None,
    ) -> Array:
        """Joint velocities (n,) to command for the next `dt`, which move the arm to q + dt times these.

        Args:
            q: positions (n,) [rad or m].
            qd: last commanded velocities (n,).
            target: desired pose (4, 4) or pin.SE3 of the tool after the step.
            qdd: last acceleration (n,), used only by jerk limits; default: that of this controller's last step.
            stiffness: Q_δ of this step.
            drive: factor >= 0 on the terms that the formulation adds, to fade them in or out.
            tolerance: tube of this step, for a controller made with one.
            obstacles: name -> (pose, velocity (6,) of its origin, linear first) of the moving obstacles; default: their
                last pose, at rest.

        `report` has the result of the step. Raises InvalidInputError only for arguments of a wrong shape or name.
        """
        try:
            if target.shape != _POSE or target.dtype.char != "d" or not (type(q) is type(qd) is type(target) is np.ndarray):
                raise TypeError
            self._q[:] = q  # memoryviews accept exactly n doubles
            self._qd[:] = qd
            self._target[...] = target
            self._stiffness[0] = self.stiffness if stiffness is None else stiffness
            self._drive[0] = drive
        except (TypeError, ValueError, AttributeError):
            self._take(q, qd, target, self.stiffness if stiffness is None else stiffness, drive)
        if tolerance is not None or self._tolerance_changed:
            self._set_tolerance(tolerance)
        if obstacles is not None or self._obstacles.size:
            self._set_obstacles({} if obstacles is None else obstacles)
        if qdd is not None:
            self._acceleration[:] = array_of_shape("qdd", qdd, (self.robot.n,))
        self._run()
        self._remembered[:] = self._to_remember
        velocity: Array = self._velocity.copy()
        if self._jerk:
            self._acceleration[:] = (velocity - np.asarray(self._qd)) / self.dt
        return velocity

    def brake(self, q: ArrayLike, qd: ArrayLike) -> Array:
        """Joint velocities (n,) that brake as hard as all limits allow."""
        return self.step(q, qd, np.full(_POSE, np.nan))

    @property
    def report(self) -> StepReport:
        """Result of the last step."""
        status, *figures = self._report.tolist()
        return StepReport(StepStatus(int(status)), *figures)

    @property
    def defaults(self) -> Mapping[str, Array]:
        """Values that steps use for tolerance (2,) and moving obstacles if none are given."""
        return {"tolerance": self._tube.copy(), "obstacles": self._obstacles.copy()}

    def reset(self) -> None:
        """Clear the memory of past steps: last acceleration and target, approach to it, and what the formulation learned."""
        self._acceleration[:] = 0.0
        self._memory[:] = 0.0

    def rollout(
        self,
        q: ArrayLike,
        targets: ArrayLike,
        *,
        qd: ArrayLike | None = None,
        stiffness: ArrayLike | None = None,
        drive: ArrayLike = 1.0,
        tolerance: Tolerance | None = None,
    ) -> Rollout:
        """Run N steps towards `targets` (N, 4, 4) from q and qd (n,), in C if the controller is compiled.

        `stiffness` and `drive` are one number or (N,); moving obstacles rest at their last pose.

        Raises InvalidInputError for a wrong shape, NaN or inf.
        """
        n = self.robot.n
        poses = finite_array("targets", targets, (None, 4, 4))
        count = len(poses)
        path = np.zeros((count + 1, n))
        speed = np.zeros((count + 1, n))
        path[0] = finite_array("q", q, (n,))
        speed[0] = 0.0 if qd is None else finite_array("qd", qd, (n,))
        stiff = _each("stiffness", self.stiffness if stiffness is None else stiffness, count)
        drives = _each("drive", drive, count)
        reports = np.zeros((count, len(REPORT)))
        self.reset()
        self._set_tolerance(tolerance)
        self._set_obstacles({})
        if self._machine is not None:
            tubes, around = np.tile(self._tube, (count, 1)), np.tile(self._obstacles, (count, 1))
            self._machine.rollout([poses, stiff, drives, tubes, around], path, speed, np.zeros(n), reports)
            return Rollout(q=path, qd=speed, reports=reports)
        for k, pose in enumerate(poses):
            speed[k + 1] = self.step(path[k], speed[k], pose, stiffness=stiff[k], drive=drives[k], tolerance=tolerance)
            path[k + 1] = path[k] + self.dt * speed[k + 1]
            reports[k] = self._report
        return Rollout(q=path, qd=speed, reports=reports)

    def export_c(self, folder: str | Path) -> list[Path]:
        """Write a self-contained C project: header, source, DAQP as a static library, CMake file and an example program.

        It needs neither Python nor CasADi at run time. Returns the files; raises InvalidInputError when the folder cannot
        be written.
        """
        from manipplan.tracking.export import export_c

        return export_c(self, folder)

    def _connect(self, function: ca.Function, stiffness: float) -> None:
        """Connect the arrays that the Function reads and writes."""
        self.stiffness = stiffness
        described = self._step.function  # machine code does not keep the names
        flat = {name: np.zeros(described.nnz_in(name)) for name in described.name_in()}
        self._buffer, self._run = function.buffer()
        for i, values in enumerate(flat.values()):
            self._buffer.set_arg(i, values.data)
        self._q: Any = flat["q"].data
        self._qd: Any = flat["qd"].data
        self._acceleration = flat["qdd"]
        self._target = flat["target"].reshape(4, 4)
        self._stiffness: Any = flat["stiffness"].data
        self._drive: Any = flat["drive"].data
        self._tube, self._obstacles, self._memory = flat["tolerance"], flat["obstacles"], flat["memory"]
        self._jerk = limits_jerk(self.robot.limits, self.dt)
        self._velocity, self._report = np.zeros(self.robot.n), np.zeros(len(REPORT))
        next_memory = np.zeros(len(self._memory))
        self._remembered: Any = self._memory.data
        self._to_remember: Any = next_memory.data
        for i, values in enumerate((self._velocity, self._report, next_memory)):
            self._buffer.set_res(i, values.data)
        self._set_tolerance(None)
        if self._avoidance is not None:
            scene = dict(zip(self._avoidance.scene.names, self._avoidance.scene.obstacles, strict=True))
            self._set_obstacles({name: (scene[name].pose, np.zeros(6)) for name in self._avoidance.moving})

    def _take(self, q: ArrayLike, qd: ArrayLike, target: Any, stiffness: Any, drive: Any) -> None:
        """Set the inputs of a step, some of which are not plain arrays of doubles."""
        n = self.robot.n
        np.asarray(self._q)[:] = array_of_shape("q", q, (n,))
        np.asarray(self._qd)[:] = array_of_shape("qd", qd, (n,))
        self._target[...] = array_of_shape("target", getattr(target, "homogeneous", target), _POSE)
        self._stiffness[0] = float(array_of_shape("stiffness", stiffness, ()))
        self._drive[0] = float(array_of_shape("drive", drive, ()))

    def _set_tolerance(self, tolerance: Tolerance | None) -> None:
        self._tolerance_changed = tolerance is not None
        if tolerance is not None and self.tolerance is None:
            raise InvalidInputError("tolerance", tolerance, "None: this controller was made without a tolerance")
        chosen = tolerance or self.tolerance
        limits = (chosen.position, chosen.rotation) if chosen is not None else (None, None)
        self._tube[:] = [HUGE if limit is None else limit for limit in limits]

    def _set_obstacles(self, obstacles: Mapping[str, tuple[Any, ArrayLike]]) -> None:
        set_moving(self._avoidance, obstacles, self._obstacles)


_POSE = (4, 4)


def _each(argument: str, value: ArrayLike, count: int) -> Array:
    """One finite number per step (count,), from one number or `count` numbers."""
    array = number_array(argument, value)
    if array.shape not in ((), (count,)) or not np.isfinite(array).all():
        raise InvalidInputError(argument, value, f"one number or {count} of them, no NaN or inf")
    return np.broadcast_to(array, (count,))
