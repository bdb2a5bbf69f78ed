"""Measures of manipulability in JSON: their name and options."""

from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from manipplan.measures.measure import Measure
from manipplan.measures.names import MEASURES
from manipplan.support.errors import FileFormatError, InvalidInputError


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


def measure_of(path: Path, data: Mapping[str, Any], given: Measure | None) -> Measure:
    """The stored measure, or `given`, which must have the same name; `path` is the file named in errors."""
    if given is not None:
        if not isinstance(given, Measure) or given.name != data["name"]:
            raise InvalidInputError("measure", given, f"the measure of the plan, {data['name']}")
        return given
    if "missing" in data:
        raise FileFormatError("file", str(path), f"a result with its measure, but it has {data['missing']}; give measure=")
    stored: dict[str, Any] = data["options"]
    options = {key: measure_of(path, value, None) if isinstance(value, dict) else value for key, value in stored.items()}
    kind: Callable[..., Measure] = MEASURES[data["name"]]
    return kind(**options)
