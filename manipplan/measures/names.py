"""The measures by name."""

from manipplan.measures.dynamic import Asada, DynamicManipulability
from manipplan.measures.limited import JointLimitPenalised
from manipplan.measures.manipulability import Constant, FrobeniusNorm, Isotropy, LogDet, Yoshikawa
from manipplan.measures.measure import Measure
from manipplan.measures.over_tools import OverTools
from manipplan.measures.spectral import ConditionNumber, InverseCondition, SmallestSingularValue
from manipplan.measures.transmission import ForceTransmission, VelocityTransmission
from manipplan.support.errors import InvalidInputError, UnknownNameError

MEASURES: dict[str, type[Measure]] = {
    kind.name: kind
    for kind in (
        Yoshikawa,
        LogDet,
        FrobeniusNorm,
        ConditionNumber,
        InverseCondition,
        SmallestSingularValue,
        Isotropy,
        DynamicManipulability,
        Asada,
        VelocityTransmission,
        ForceTransmission,
        JointLimitPenalised,
        OverTools,
        Constant,
    )
}


def available_measures() -> tuple[str, ...]:
    """Names that `Robot.kinematics(measure=...)` accepts."""
    return tuple(MEASURES)


def measure_of(measure: Measure | str | None) -> Measure:
    """The given measure, or the measure of that name with default options; Yoshikawa's manipulability for None."""
    if measure is None:
        return Yoshikawa()
    if isinstance(measure, Measure):
        if type(measure).__hash__ is None:
            raise InvalidInputError("measure", measure, "a measure that can be hashed, such as a frozen dataclass")
        return measure
    if not isinstance(measure, str):
        raise InvalidInputError("measure", measure, "a Measure or the name of one")
    if measure not in MEASURES:
        raise UnknownNameError("measure", measure, MEASURES)
    kind = MEASURES[measure]
    if kind in (VelocityTransmission, ForceTransmission):
        raise InvalidInputError("measure", measure, f"mp.{kind.__name__}(direction=...), which needs a direction")
    return kind()
