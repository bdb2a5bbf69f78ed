"""PathObjective: what the optimiser of a path minimises, as its user states it; and the integrands along a path.

These are the energy, which is minimised until a free path is found, and the length, g itself.

g = ∫ h ds with h = ‖q'‖_W / (m² + ε²)^(p/2) does not change when a path is re-parametrised, so its Hessian is singular. The
energy E = ∫ h² ds does change: g² <= E, with equality where h is constant, so both have the same minimum over all curves. Over
the polynomials of one degree, which cannot represent every re-parametrisation, the minima differ slightly.

The floor ε of an objective: below it, a smaller manipulability costs hardly more.

∫ ‖q'‖ / m^p ds is infinite on every path that crosses a singularity for p >= 1. With (m² + ε²)^(p/2) in place of m^p it is
finite, and smooth where det J changes its sign.
"""

import logging
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from manipplan.cost.integral import MOST_POWER, PathIntegral, metric_matrix
from manipplan.kinematics.factors import idle_joints
from manipplan.kinematics.kinematics import Kinematics, steady
from manipplan.measures.manipulability import Constant, Yoshikawa
from manipplan.measures.measure import Measure
from manipplan.measures.names import MEASURES
from manipplan.paths.rounding import with_bits
from manipplan.robots.robot import Robot
from manipplan.support.checks import ArrayLike, instance, number, number_array
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.expressions import making_expressions
from manipplan.support.memo import once_per_source
from manipplan.symbolic.machine_code import CodedFunctions, as_asked
from manipplan.symbolic.motion import Factor, determinant, log_gradient, log_hessian
from manipplan.symbolic.spanned import is_always_singular
from manipplan.symbolic.task import Task

log = logging.getLogger("manipplan")

#: Default floor as a share of the arm's typical measure. Where m stays above ten floors, g differs by less than p / 2 per cent;
#: on most paths of redundant arms m stays above a tenth of its typical value, where g differs by less than p / 2 * 1e-4.
SHARE = 1e-3
#: Number of random configurations whose median is the typical value.
SAMPLES = 200
#: Bits of the typical value, so that it is the same on every processor.
BITS = 24


def typical_measure(kinematics: Kinematics) -> float:
    """The median of the measure over SAMPLES random configurations with a fixed seed, to BITS bits."""
    return _typical(kinematics.robot, kinematics.task, kinematics.measure, kinematics.compiled)


def floor_of(kinematics: Kinematics, floor: float | None) -> float:
    """The floor ε, in the unit of the measure: `floor` itself, or the default for None.

    That is SHARE of the typical measure, and 0 for a constant one.
    """
    if floor is not None:
        return floor
    return 0.0 if kinematics.measure.constant else SHARE * typical_measure(kinematics)


def warn_of_floor(kinematics: Kinematics, floor: float) -> None:
    """Log a warning about a floor above the typical measure: it hides most singularities."""
    typical = typical_measure(kinematics)
    if floor > typical:
        name, unit = kinematics.measure.name, kinematics.measure.unit(kinematics.task)
        template = "floor=%g is above the typical %s of %s, %.4g %s: singularities hardly count"
        log.warning(template, floor, name, kinematics.robot.name, typical, unit)


@once_per_source
def _typical(robot: Robot, task: Task, measure: Measure, compiled: bool | str) -> float:
    q = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    values = robot.kinematics(task, measure=measure, compiled=compiled).manipulability(q)
    return float(with_bits(np.array([np.median(values)]), BITS)[0])


#: ρ in log sqrt(det(J Jᵀ + ρ² I)) of the energy and of the length; it keeps them finite at a singular configuration. The
#: reported g is not regularised.
ENERGY_REGULARISATION, LENGTH_REGULARISATION = 1e-5, 1e-7
#: δ in log sqrt(m² + ε² + δ²), of det J and of any other measure, is its typical value times this times ρ over that of the
#: energy.
MEASURE_REGULARISATION = 1e-6
#: Speed [rad] below which ‖q'‖ is smoothed, so that it has derivatives where a path stands still.
STANDSTILL = 1e-9
#: Weight κ of the speed's variance in the descent's integral ∫ h + κ h² / g₀ ds. It selects one of the re-parametrisations
#: of a curve, and changes g by less than κ times that variance.
CONSTANCY = 1e-6


def hessian_of(derivatives: ca.Function) -> ca.Function:
    """The Hessian (2n, 2n) in (q, v) alone, of the derivatives of a density."""
    at = [ca.MX.sym(name, derivatives.size1_in(k)) for k, name in enumerate(("q", "v", "numbers"))]
    return ca.Function("density_hessian", at, [derivatives(*at)[:, 1:]])


@making_expressions()
def energy_density(integral: PathIntegral, *, at_once: bool = False) -> CodedFunctions:
    """h² = ‖v‖_W² / (m² + ε²)^p, whose integral over s is the energy E; `at_once`: its machine code is built now.

    A density is three Functions of q, v and [g₀, p, ε], so that one build serves all exponents and floors: its value, its
    gradient (2n,) in (q, v), and gradient and Hessian side by side (2n, 1 + 2n). g₀ is an estimate of the path's g; the energy
    does not depend on it.
    """
    metric, g0, power, floor = _metric(integral), ca.SX.sym("g0"), ca.SX.sym("p"), ca.SX.sym("floor")
    q, v, log_m, slope, bend = _symbols(integral.kinematics, floor, ENERGY_REGULARISATION)
    weight = ca.exp(-2 * power * log_m)
    square = ca.bilin(metric, v, v)
    # derived by hand from w(q) = exp(-2p log m): w' = -2p w ∇log m, w'' = w (4p² ∇log m ∇log mᵀ - 2p ∇²log m)
    gradient = ca.vertcat(-2 * power * weight * square * slope, 2 * weight * metric @ v)
    qq = weight * square * (4 * power**2 * slope @ slope.T - 2 * power * bend)
    qv = -4 * power * weight * slope @ (metric @ v).T
    hessian = _blocks(qq, qv, 2 * weight * metric)
    at = (q, v, ca.vertcat(g0, power, floor))
    return _density(integral, "energy", at, weight * square, gradient, hessian, at_once=at_once)


@making_expressions()
def length_density(integral: PathIntegral) -> CodedFunctions:
    """h + κ h² / g₀ with h = ‖v‖_W / (m² + ε²)^(p/2): its integral is g plus a small multiple of the energy."""
    metric, g0, power, floor = _metric(integral), ca.SX.sym("g0"), ca.SX.sym("p"), ca.SX.sym("floor")
    q, v, log_m, slope, bend = _symbols(integral.kinematics, floor, LENGTH_REGULARISATION)
    weight = ca.exp(-power * log_m)
    speed = ca.sqrt(ca.bilin(metric, v, v) + STANDSTILL**2)
    along = metric @ v / speed
    h = weight * speed
    dh = ca.vertcat(-power * h * slope, weight * along)
    qq = h * (power**2 * slope @ slope.T - power * bend)
    qv = -power * weight * slope @ along.T
    ddh = _blocks(qq, qv, weight / speed * (metric - along @ along.T))
    first, second = 1 + 2 * CONSTANCY * h / g0, 2 * CONSTANCY / g0
    gradient, hessian = first * dh, first * ddh + second * dh @ dh.T
    return _density(integral, "length", (q, v, ca.vertcat(g0, power, floor)), h + CONSTANCY * h**2 / g0, gradient, hessian)


def _metric(integral: PathIntegral) -> ca.SX:
    n = integral.kinematics.robot.n
    return ca.SX.eye(n) if integral.metric is None else ca.sparsify(ca.SX(ca.DM(integral.metric)))


def _symbols(kinematics: Kinematics, floor: ca.SX, regularisation: float) -> tuple[ca.SX, ca.SX, ca.SX, ca.SX, ca.SX]:
    """q, v, and log sqrt(m² + ε²) with gradient and Hessian in q; m is regularised by ρ."""
    posture, measure = kinematics.symbolic.posture, kinematics.measure
    q = kinematics.symbolic.chain.q
    v = ca.SX.sym("v", q.shape[0])
    if isinstance(measure, Yoshikawa):
        jacobian, motion = steady(kinematics.symbolic.chain, kinematics.task)
        if jacobian.shape[0] == jacobian.shape[1]:  # m = |det J|, and det J is smooth where it vanishes
            value = determinant(ca.sparsify(jacobian))
            bend, slope = ca.hessian(value, q)
            return q, v, *_log_of_root(kinematics, value, slope, bend, floor, regularisation)
        factor = Factor.of(jacobian, regularisation)
        square = factor.manipulability**2
        share = square / (square + floor**2)
        slope, bend = log_gradient(factor, motion), log_hessian(factor, motion)
        # derivatives of log sqrt(e^(2l) + ε²) in l = log m: the share, and twice the share times its complement
        bend = share * bend + 2 * share * (1 - share) * slope @ slope.T
        return q, v, ca.log(square + floor**2) / 2, share * slope, bend
    value, slope, bend = measure.value(posture), measure.gradient(posture), measure.hessian(posture)
    return q, v, *_log_of_root(kinematics, value, slope, bend, floor, regularisation)


def _log_of_root(
    kinematics: Kinematics, value: ca.SX, slope: ca.SX, bend: ca.SX, floor: ca.SX, regularisation: float
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """log sqrt(m² + ε² + δ²), gradient and Hessian, from those of m; δ is too small to matter except where m vanishes."""
    least = MEASURE_REGULARISATION * regularisation / ENERGY_REGULARISATION * typical_measure(kinematics)
    square = value**2 + floor**2 + least**2
    share = value / square
    log_bend = share * bend + (1 / square - 2 * share**2) * slope @ slope.T
    return ca.log(square) / 2, share * slope, log_bend


def _blocks(qq: ca.SX, qv: ca.SX, vv: ca.SX) -> ca.SX:
    return ca.vertcat(ca.horzcat(qq, qv), ca.horzcat(qv.T, vv))


def _density(
    integral: PathIntegral,
    name: str,
    at: tuple[ca.SX, ca.SX, ca.SX],
    value: ca.SX,
    gradient: ca.SX,
    hessian: ca.SX,
    *,
    at_once: bool = False,
) -> CodedFunctions:
    """The density, compiled to machine code as `integral.kinematics.compiled` specifies."""
    functions = [
        ca.Function(f"path_{name}", at, [value]),
        ca.Function(f"path_{name}_gradient", at, [ca.densify(gradient)]),
        ca.Function(f"path_{name}_derivatives", at, [ca.densify(ca.horzcat(gradient, hessian))]),
    ]
    kinematics = integral.kinematics
    subject = f"the {name} of paths of {kinematics.robot.name}"
    return as_asked(functions, kinematics.compiled, subject, at_once=at_once)


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
    robot, idle = kinematics.robot, idle_joints(kinematics)
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
