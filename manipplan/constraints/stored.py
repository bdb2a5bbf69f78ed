"""Constraints in JSON."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from manipplan.constraints.box import PositionBox
from manipplan.constraints.constraint import Constraint
from manipplan.constraints.held import HeldJoints
from manipplan.constraints.tilt import TiltLimit

#: The classes that can be stored.
KINDS: dict[str, type[TiltLimit] | type[PositionBox] | type[HeldJoints]] = {
    each.__name__: each for each in (TiltLimit, PositionBox, HeldJoints)
}


def constraint_data(constraint: Constraint) -> dict[str, Any]:
    """A constraint for JSON; one of a class of a user's own only as its name, under `missing`."""
    kind = type(constraint)
    if KINDS.get(kind.__name__) is not kind:
        return {"missing": f"a constraint of a class of your own, {kind.__name__}"}
    return {"kind": kind.__name__, **{each.name: getattr(constraint, each.name) for each in fields(kind)}}


def constraint_of(data: Mapping[str, Any]) -> Constraint:
    """The constraint of such data; raises KeyError, TypeError or InvalidInputError for others."""
    values = {key: _numbers(value) for key, value in data.items() if key != "kind"}
    return KINDS[data["kind"]](**values)


def _numbers(value: Any) -> Any:
    """The value with numbers for the strings "inf" and "-inf", by which JSON has them."""
    if isinstance(value, list):
        return [_numbers(each) for each in value]
    return float(value) if value in ("inf", "-inf") else value
