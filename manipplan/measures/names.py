"""The measures by name.

Measures of manipulability in JSON: their name and options.
"""

from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from manipplan.measures import dynamic, manipulability, over_tools, spectral
from manipplan.measures.measure import Measure
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

MEASURES: dict[str, type[Measure]] = {
    kind.name: kind
    for kind in (
        manipulability.Yoshikawa,
        manipulability.LogDet,
        manipulability.FrobeniusNorm,
        spectral.ConditionNumber,
        spectral.InverseCondition,
        spectral.SmallestSingularValue,
        manipulability.Isotropy,
        dynamic.DynamicManipulability,
        dynamic.Asada,
        manipulability.VelocityTransmission,
        manipulability.ForceTransmission,
        manipulability.JointLimitPenalised,
        over_tools.OverTools,
        manipulability.Constant,
    )
}


def available_measures() -> tuple[str, ...]:
    """Names that `Robot.kinematics(measure=...)` accepts."""
    return tuple(MEASURES)


def measure_of(measure: Measure | str | None) -> Measure:
    """The given measure, or the measure of that name with default options; Yoshikawa's manipulability for None."""
    if measure is None:
        return manipulability.Yoshikawa()
    if isinstance(measure, Measure):
        if type(measure).__hash__ is None:
            raise InvalidInputError("measure", measure, "a measure that can be hashed, such as a frozen dataclass")
        return measure
    if not isinstance(measure, str):
        raise InvalidInputError("measure", measure, "a Measure or the name of one")
    if measure not in MEASURES:
        raise UnknownNameError("measure", measure, MEASURES)
    kind = MEASURES[measure]
    if kind in (manipulability.VelocityTransmission, manipulability.ForceTransmission):
        raise InvalidInputError("measure", measure, f"mp.{kind.__name__}(direction=...), which needs a direction")
    return kind()


def measure_data(measure: Measure) -> dict[str, Any]:
    """The JSON data of a measure; "missing" names the class where it is not one of this package."""
    kind = type(measure)
    if MEASURES.get(kind.name) is not kind:
        return {"missing": f"a measure of your own, {kind.__name__}", "name": kind.name}
    options: dict[str, Any] = (
        {each.name: getattr(measure, each.name) for each in fields(measure)} if is_dataclass(measure) else {}
    )
    inner = {key: measure_data(value) for key, value in options.items() if isinstance(value, Measure)}
    lost = next((each["missing"] for each in inner.values() if "missing" in each), None)
    return {"name": kind.name, "options": {**options, **inner}, **({"missing": lost} if lost else {})}


def restore_measure(path: Path, data: Mapping[str, Any], given: Measure | None) -> Measure:
    """The stored measure, or `given`, which must have the same name; `path` is the file named in errors."""
    if given is not None:
        if not isinstance(given, Measure) or given.name != data["name"]:
            raise InvalidInputError("measure", given, f"the measure of the plan, {data['name']}")
        return given
    if "missing" in data:
        raise FileFormatError("file", str(path), f"a result with its measure, but it has {data['missing']}; give measure=")
    stored: dict[str, Any] = data["options"]
    options = {key: restore_measure(path, value, None) if isinstance(value, dict) else value for key, value in stored.items()}
    kind: Callable[..., Measure] = MEASURES[data["name"]]
    return kind(**options)
