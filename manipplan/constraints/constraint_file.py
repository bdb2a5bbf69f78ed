"""Constraints from a YAML file.

Constraints in JSON.
"""

from collections.abc import Callable, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

from manipplan.constraints.constraint import Constraint, HeldJoints, PositionBox, TiltLimit
from manipplan.support.checks import existing_file
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.yaml_files import read_yaml

#: For each key of an entry: the class, and its keys, those first that are needed.
KEYS: dict[str, tuple[Callable[..., Constraint], tuple[str, ...], tuple[str, ...]]] = {
    "tilt_limit": (TiltLimit, ("axis", "direction", "angle"), ("tool",)),
    "position_box": (PositionBox, ("lower", "upper"), ("pose", "tool")),
    "held_joints": (HeldJoints, ("joints",), ()),
}


def constraints_from_yaml(file: str | Path) -> tuple[Constraint, ...]:
    """Read constraints: ``constraints: [{tilt_limit: {axis: [0, 0, 1], direction: [0, 0, -1], angle: 0.1}}, ...]``.

    The other entries are ``{position_box: {lower: [x, y, z], upper: [x, y, z]}}`` [m], where .inf leaves a side open and
    `pose`, a matrix (4, 4), moves the box; and ``{held_joints: {joints: [name, ...]}}``. Angles are in radians. Of several
    tools, `tool` names the one that a tilt limit or a box is about.

    Raises FileFormatError, which names the file, the entry, the key and what is allowed.
    """
    path = existing_file("constraints", file)
    data = read_yaml("constraints", path)
    entries = data.get("constraints") if isinstance(data, Mapping) and set(data) == {"constraints"} else None
    if not isinstance(entries, list) or not entries:
        raise FileFormatError("constraints", str(path), "a list of at least one constraint under the single key constraints")
    return tuple(constraint_of_entry(f"constraints[{k}]", entry, path) for k, entry in enumerate(entries))


def constraint_of_entry(argument: str, entry: Any, path: Path) -> Constraint:
    """One constraint of an entry; raises FileFormatError, which names the argument and the file."""
    place = f"{argument} in {path}"
    if not isinstance(entry, Mapping) or len(entry) != 1:
        raise FileFormatError(place, str(entry), f"a mapping with one of the keys {', '.join(KEYS)}")
    key, values = next(iter(entry.items()))
    if key not in KEYS:
        raise FileFormatError(place, str(key), UnknownNameError(argument, str(key), KEYS).allowed)
    make, needed, optional = KEYS[key]
    if not isinstance(values, Mapping) or not set(needed) <= set(values) <= {*needed, *optional}:
        raise FileFormatError(f"{argument}.{key} in {path}", str(values), f"a mapping with the keys {', '.join(needed)}")
    try:
        return make(**values)
    except InvalidInputError as error:
        raise FileFormatError(f"{argument}.{key}.{error.argument} in {path}", str(error.value), error.allowed) from error


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
