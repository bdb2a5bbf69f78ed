"""Formulations of inverse kinematics that raise manipulability, as frozen values.

Each adds a quadratic ½ q̇ᵀ H q̇ + gᵀ q̇ to the cost ½ q̇ᵀ Q q̇ + ½ δᵀ Q_δ δ of (3) in dufour2020. Equation numbers are those
of the paper. There T is the controller's time step, and g scales with α T and H with α T²: the same α gives a different motion
at a different step. `sample_time` fixes this T instead: then the cost of a velocity, and so the motion, does not depend on
the time step.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field

import casadi as ca

from manipplan.support.checks import flag, number, one_of
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.motion import Factor
from manipplan.tracking.derivatives import SymbolicMeasure, gram

__all__ = [
    "Classical",
    "Drive",
    "Equality",
    "Formulation",
    "General",
    "LogDrive",
    "Objective",
    "SymbolicMeasure",
]

#: Offset added to ∇ log m [1/rad], which vanishes in symmetric and in exactly singular configurations although m could grow.
NUDGE = 1e-6
#: Ways to compute the gradient and the Hessian of m: exactly, or by the paper's differences (17) and (19).
DERIVATIVES = ("exact", "central")


@dataclass(frozen=True, kw_only=True)
class Drive:
    """Terms that a formulation adds to the cost ½ q̇ᵀ Q q̇ + ½ δᵀ Q_δ δ: H (n, n) and g (n, 1).

    A formulation that learns from step to step also gives `memory`, symbols (k, 1) for what the last step computed, and
    `next_memory`, what this step computes for the next one. The memory is zero at the first step and after a state that is not
    finite.

    Raises InvalidInputError if the memories differ in shape.
    """

    hessian: ca.SX
    gradient: ca.SX
    memory: ca.SX = field(default_factory=lambda: ca.SX(0, 1))
    next_memory: ca.SX = field(default_factory=lambda: ca.SX(0, 1))

    def __post_init__(self) -> None:
        if self.memory.shape != self.next_memory.shape or self.memory.shape[1] != 1:
            wanted = f"a column of the shape of memory, {self.memory.shape}"
            raise InvalidInputError("next_memory", self.next_memory.shape, wanted)


class Formulation(ABC):
    """Base class of formulations that use manipulability in inverse kinematics; subclasses are frozen values.

    One's own formulation implements `drive`. Its terms are added to the QP of a step, which keeps all limits and constraints.
    """

    #: Whether a step is a QP, which keeps a tolerance and avoids obstacles; False: it is `closed_form`.
    solves_qp: bool = True
    #: Whether the drive fades where the target stands still and the tool is away from it: then the arm rests there only if it
    #: would do so without a drive.
    yields: bool = False
    #: Whether an indefinite cost is made convex before it is solved.
    convexify: bool = False

    @abstractmethod
    def drive(self, measure: SymbolicMeasure, dt: float) -> Drive:
        """Terms added to the cost at the symbolic configuration of `measure` for a time step `dt` [s]."""

    def closed_form(self, jacobian: ca.SX, rate: ca.SX, push: ca.SX) -> ca.SX:
        """Joint velocities (n, 1) where `solves_qp` is False.

        Args:
            jacobian: (m, n).
            rate: ṙ (m, 1), the velocity of the task.
            push: (n, 1), minus the gradient of the drive.
        """
        raise NotImplementedError(f"{type(self).__name__} sets solves_qp = False and has no closed_form")


@dataclass(frozen=True)
class Classical(Formulation):
    """The pseudo-inverse with the gradient in its null space, (7): q̇ = J⁺ ṙ + k₀ (I - J⁺ J) ∇m; (2) with gain 0.

    It has no inequality constraints: its velocities are clipped to the joint bounds, and it takes no obstacles or tolerance.

    Attributes:
        gain: k₀ >= 0 [(rad/s) per (unit of m per rad)].
        damping: λ >= 0 in J⁺ = Jᵀ (J Jᵀ + λ² I)⁻¹, in the unit of J's rows; it keeps the inverse finite at singularities.
    """

    gain: float = 0.0
    damping: float = 1e-9
    solves_qp = False

    def __post_init__(self) -> None:
        number("gain", self.gain, least=0.0)
        number("damping", self.damping, above=0.0)

    def drive(self, measure: SymbolicMeasure, dt: float) -> Drive:  # noqa: ARG002
        """k₀ ∇m, which is then projected into the null space."""
        n = measure.q.shape[0]
        return Drive(hessian=ca.SX(n, n), gradient=-self.gain * measure.gradient)

    def closed_form(self, jacobian: ca.SX, rate: ca.SX, push: ca.SX) -> ca.SX:
        """(2): J⁺ ṙ + (I - J⁺ J) z, with J⁺ = Q L⁻¹ for J = L Qᵀ."""
        factor = Factor.of(jacobian, self.damping)
        return push + factor.Q @ ca.solve(factor.L, rate - jacobian @ push)


@dataclass(frozen=True)
class General(Formulation):
    """The relaxed formulation without manipulability, (3)."""

    def drive(self, measure: SymbolicMeasure, dt: float) -> Drive:  # noqa: ARG002
        """Zero terms."""
        n = measure.q.shape[0]
        return Drive(hessian=ca.SX(n, n), gradient=ca.SX(n, 1))


@dataclass(frozen=True)
class Objective(Formulation):
    """Manipulability in the objective, (10), (11): the cost - α (T ∇mᵀ q̇ + ½ T² q̇ᵀ H_m q̇).

    Attributes:
        alpha: α >= 0 [1/(unit of m)].
        sample_time: time step T for which α is chosen [s]; None: the controller's time step, as in the paper.
        gradient: "exact", or "central" for the paper's (17).
        hessian: "exact", or "central" for (19).
        convexify: make Q - α T² H_m positive definite where it is not (and count it); False leaves the cost
            unchanged, as in the paper.
    """

    alpha: float
    sample_time: float | None = None
    gradient: str = "exact"
    hessian: str = "exact"
    convexify: bool = True

    def __post_init__(self) -> None:
        _check_alpha(self.alpha, self.sample_time, self.gradient)
        one_of("hessian", self.hessian, DERIVATIVES)
        flag("convexify", self.convexify)

    def drive(self, measure: SymbolicMeasure, dt: float) -> Drive:
        """(11): H = - α T² H_m, g = - α T ∇m."""
        time = self.sample_time or dt
        slope = measure.gradient if self.gradient == "exact" else measure.central_gradient
        hessian = measure.hessian if self.hessian == "exact" else measure.central_hessian
        return Drive(hessian=-self.alpha * time**2 * hessian, gradient=-self.alpha * time * slope)


@dataclass(frozen=True)
class Equality(Formulation):
    """Manipulability as an equality with a slack, (14), (15): the cost ½ α ε², m - T ∇mᵀ q̇ = ε. It is always convex.

    Attributes:
        alpha: α >= 0 [1/(unit of m)²].
        sample_time: time step T for which α is chosen [s]; None: the controller's time step, as in the paper.
        gradient: "exact", or "central" for the paper's (17).
    """

    alpha: float
    sample_time: float | None = None
    gradient: str = "exact"

    def __post_init__(self) -> None:
        _check_alpha(self.alpha, self.sample_time, self.gradient)

    def drive(self, measure: SymbolicMeasure, dt: float) -> Drive:
        """(16), ε eliminated: H = α T² ∇m ∇mᵀ, g = - α m T ∇m."""
        time = self.sample_time or dt
        slope = measure.gradient if self.gradient == "exact" else measure.central_gradient
        return Drive(hessian=self.alpha * time**2 * gram(slope.T), gradient=-self.alpha * measure.value * time * slope)


@dataclass(frozen=True)
class LogDrive(Formulation):
    """Lemma 1 with log m and a fixed rate in place of h: the cost ½ β e², e = ρ - ∇(log m)ᵀ q̇. Not in the paper.

    It demands that log m grow by ρ per second. It is convex, needs no Hessian, does not depend on the time step or on the
    unit of m, and pulls hardest where m is small: (10) and (14) pull with ∇m and m ∇m, which fade where m vanishes.

    Attributes:
        weight: β >= 0 [s²].
        rate: ρ > 0 [1/s].
        regularisation: r of log m = log sqrt(det(J Jᵀ + r² I)), in the unit of J's rows: singular values below r pull no
            harder. For a full pose J is taken at the middle of the arm, where m is the same.
        yields: whether the drive fades where the target stands still and the tool is away from it or outside its tolerance.
            False: the arm may rest decimetres away, where the drive balances the tracking.
    """

    weight: float = 10.0
    rate: float = 10.0
    regularisation: float = 1e-3
    yields: bool = True

    def __post_init__(self) -> None:
        number("weight", self.weight, least=0.0)
        number("rate", self.rate, above=0.0)
        number("regularisation", self.regularisation, above=0.0)
        flag("yields", self.yields)

    def drive(self, measure: SymbolicMeasure, dt: float) -> Drive:  # noqa: ARG002
        """e eliminated: the Hessian β g gᵀ and the gradient - β ρ g with g = ∇ log m + NUDGE."""
        slope = measure.log_gradient(self.regularisation) + NUDGE
        return Drive(hessian=self.weight * gram(slope.T), gradient=-self.weight * self.rate * slope)


def _check_alpha(alpha: float, sample_time: float | None, gradient: str) -> None:
    number("alpha", alpha, least=0.0)
    if sample_time is not None:
        number("sample_time", sample_time, above=0.0)
    one_of("gradient", gradient, DERIVATIVES)
