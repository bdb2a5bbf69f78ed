"""PathObjective: what the optimiser of a path minimises, as its user states it."""

from dataclasses import dataclass, replace

import numpy as np

from manipplan.cost.density import floor_of, warn_of_floor
from manipplan.cost.integral import MOST_POWER, PathIntegral, metric_matrix
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.manipulability import Constant
from manipplan.measures.measure import Measure
from manipplan.measures.names import MEASURES
from manipplan.robots.robot import Robot
from manipplan.support.checks import ArrayLike, instance, number, number_array
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.spanned import is_always_singular
from manipplan.symbolic.task import Task

#: Number of random configurations in which joints that do not move the tool are looked for, and the largest entry of their
#: columns of the Jacobian, as a share of the largest of all.
POSTURES, IDLE = 50, 1e-9


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class PathObjective:
    """The objective g = ∫ ‖q'‖_W / (m² + floor²)^(power/2) ds of a path: (6.6) in kth2012, with its exponent and a floor.

    Attributes:
        power: exponent p of m, above 0 and at most 100. A larger one keeps further away from singularities.
        task: task whose manipulability m counts; None: the robot's default task.
        measure: m, a name from `available_measures()` or a Measure that is at least zero and better when larger; "constant"
            for the shortest path. None: Yoshikawa's manipulability, and "constant" where that of the default task is zero in
            every configuration of the arm, as for a positioner of two joints.
        metric: W in ‖q'‖_W² = q'ᵀ W q': weights (n,) > 0, or a symmetric positive definite matrix (n, n); None: the identity.
        floor: ε >= 0 in the unit of m. It keeps g finite on a path through a singularity. Where m is above ε on the whole path,
            g with the floor is at most g without it, and at least its (1 + (ε / min m)²)^(-power/2) part. 0: no floor, and g is
            infinite on such a path. None: a thousandth of the arm's typical m, the median over 200 random configurations.
    """

    power: float = 1.0
    task: Task | None = None
    measure: Measure | str | None = None
    metric: ArrayLike | None = None
    floor: float | None = None

    def __post_init__(self) -> None:
        if self.floor is not None:
            object.__setattr__(self, "floor", number("floor", self.floor, least=0.0))
        object.__setattr__(self, "power", number("power", self.power, above=0.0, most=MOST_POWER))
        if self.task is not None:
            instance("task", self.task, Task)
        if self.measure is not None and not isinstance(self.measure, str | Measure):
            raise InvalidInputError("measure", self.measure, "a Measure or the name of one")
        if self.metric is not None and np.isnan(number_array("metric", self.metric)).any():
            raise InvalidInputError("metric", self.metric, "numbers, no NaN")

    def kinematics(self, robot: Robot, *, compiled: bool | str = "auto") -> Kinematics:
        """The kinematics of a robot with this task and measure.

        Raises:
            InvalidInputError: the task has more rows than the arm has joints, or the measure can be negative or is better
                when smaller.
        """
        measure, robot = self.measure, instance("robot", robot, Robot)
        if self.task is None and measure is None and is_always_singular(robot, robot.default_task):
            measure = Constant()
        kinematics = robot.kinematics(self.task, measure=measure, compiled=compiled)
        task, n = kinematics.task, kinematics.symbolic.joints
        if task.rows > n and not kinematics.measure.constant:
            rows = f"at most {n} row{'s' * (n > 1)}; with more rows than joints the manipulability is identically zero"
            remedy = 'leave task out for the motions that the joints span, or take measure="constant" for the shortest path'
            raise InvalidInputError("task", task.name, f"{rows}: {remedy}")
        check_measure(kinematics)
        return kinematics

    def integral(self, robot: Robot, *, compiled: bool | str = "auto") -> PathIntegral:
        """g of a robot's paths; raises InvalidInputError where the objective does not fit the robot."""
        metric = metric_matrix("metric", self.metric, instance("robot", robot, Robot).n)
        kinematics = self.kinematics(robot, compiled=compiled)
        return PathIntegral(kinematics=kinematics, power=self.power, floor=floor_of(kinematics, self.floor), metric=metric)

    def resolved(self, robot: Robot, *, compiled: bool | str = "auto") -> "PathObjective":
        """The same objective with the task, measure, floor and metric (n, n) that hold for a robot; it can be pickled."""
        integral = self.integral(robot, compiled=compiled)
        kinematics = integral.kinematics
        warn_of_floor(kinematics, integral.floor)
        return replace(self, task=kinematics.task, measure=kinematics.measure, metric=integral.metric, floor=integral.floor)


def idle_hint(kinematics: Kinematics) -> str:
    """The joints that make the manipulability of an arm zero everywhere, and the remedy; "" where there are none.

    A joint whose axis the tool lies on does not move what counts of it.
    """
    robot = kinematics.robot
    q = robot.random_configuration(np.random.default_rng(0), size=POSTURES)
    jacobians = np.abs(kinematics.jacobian(q))
    idle = jacobians.max(axis=(0, 1)) <= IDLE * jacobians.max()
    if not idle.any() or robot.n - idle.sum() >= kinematics.task.rows:
        return ""
    names = " and ".join(name for name, still in zip(robot.joint_names, idle, strict=True) if still)
    verb = "do" if idle.sum() > 1 else "does"
    return (
        f"{names} {verb} not move the tool as the task {kinematics.task.name!r} counts it, so that m is zero everywhere; give "
        f"a tool beside the axis (robot.with_tool), or a task of at most {robot.n - idle.sum()} rows"
    )


def check_measure(kinematics: Kinematics) -> None:
    """Raise InvalidInputError for a measure that can be negative, or is better when smaller."""
    measure = kinematics.measure
    if not measure.larger_is_better:
        usable = [name for name, kind in MEASURES.items() if kind.larger_is_better]
        wanted = f"a measure that is at least zero and better when larger: {', '.join(usable)}, or a custom one"
        raise InvalidInputError("measure", measure.name, wanted)
    measure.check(kinematics.task.rows, kinematics.symbolic.joints)
