"""Constraints: rows c(q) >= 0 that every configuration of a motion keeps; also from a YAML file, and in JSON."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.robots.arms import known_tool
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, existing_file, finite_array, number, number_array, pose_matrix
from manipplan.support.data_files import read_yaml
from manipplan.support.display import one_line
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

#: Value of a row, negative, up to which it counts as kept [rad or m].
ROW_TOLERANCE = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class SymbolicPose:
    """A configuration as symbols, and the pose of the tool there.

    Attributes:
        q: (n, 1) joint values [rad or m].
        position: (3, 1) of the tool in the world [m]; of several tools the first, or the one that the constraint names.
        rotation: (3, 3) of the tool in the world.
    """

    q: ca.SX
    position: ca.SX
    rotation: ca.SX


class Constraint(ABC):
    """A constraint on every configuration of a free motion; derive from it to write your own.

    A row is a smooth function c of the configuration, and is kept where c(q) >= 0. Scale rows so that a change by 1e-6 is
    negligible, as it is in radians and metres: a row counts as kept down to -1e-6. The set of allowed configurations needs some
    width, since searches go through its inside: write an equation as two rows some 1e-3 apart.

    Rows of a class of your own hold at samples between which no joint moves by more than 1e-3 rad or m. Those of TiltLimit and
    PositionBox are proven on the whole motion (`prove` in constraint_set.py); where they are about different tools, those of
    one tool, and the others are sampled.
    """

    @property
    @abstractmethod
    def name(self) -> str:
        """What messages and reports call it."""

    @abstractmethod
    def rows(self, at: SymbolicPose) -> ca.SX:
        """The rows (r, 1), as expressions of the configuration."""

    def figure(self, value: float) -> str:
        """What the smallest value of its rows means, for messages and reports."""
        return f"smallest row {value:.4g}" if value >= 0 else f"smallest row {value:.4g}, below 0"

    @property
    def of_tool(self) -> str | None:
        """The tool whose pose its rows take; None: the first one of the robot."""
        return None

    def tool_rows(self) -> Array | None:
        """Rows that are linear in the tool's pose, as weights (r, 13); None for other rows.

        The first three weigh the position, the next nine the columns of the rotation, the last one is added.
        """
        return None

    def check(self, robot: Robot) -> None:
        """Raise InvalidInputError where the constraint does not fit the robot."""
        if self.of_tool is not None:
            known_tool(robot, "constraints.tool", self.of_tool)


def tool_name(tool: object) -> str | None:
    """A tool that a constraint names; raises InvalidInputError for anything but text or None."""
    if tool is not None and (not isinstance(tool, str) or not tool):
        raise InvalidInputError("tool", tool, "the name of one of the robot's tools, or None for the first one")
    return tool


def constraint_tuple(constraints: Sequence[Constraint]) -> tuple[Constraint, ...]:
    """The constraints of a call; raises InvalidInputError, which names the entry, for anything else."""
    if isinstance(constraints, Constraint) or not isinstance(constraints, list | tuple):
        raise InvalidInputError("constraints", constraints, "a list or tuple of constraints, such as [mp.TiltLimit(...)]")
    for k, each in enumerate(constraints):
        if not isinstance(each, Constraint):
            raise InvalidInputError(f"constraints[{k}]", each, "a TiltLimit, PositionBox, HeldJoints or Constraint of yours")
    return tuple(constraints)


#: Smallest angle of a limit [rad], and smallest sine by which its row is scaled.
LEAST_ANGLE, LEAST_SINE = 1e-3, 0.05


@one_line
@dataclass(frozen=True)
class TiltLimit(Constraint):
    """An axis of the tool stays within an angle of a direction, as that of a cup which must not spill.

    Attributes:
        axis: (3,) in the tool's frame, of any length; kept with length 1.
        direction: (3,) in the world's frame, which is that of the base unless `robot.at` moved it; likewise.
        angle: largest angle between the two [rad], from 1e-3 to below π.
        tool: the tool frame of a robot with several; None: the first one.

    Raises InvalidInputError: an axis or direction of zero length, or another angle.
    """

    axis: ArrayLike
    direction: ArrayLike
    angle: float
    tool: str | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis", _unit("axis", self.axis))
        object.__setattr__(self, "direction", _unit("direction", self.direction))
        angle = number("angle", self.angle, least=LEAST_ANGLE)
        if angle >= np.pi:
            raise InvalidInputError("angle", angle, "an angle below π [rad]: any tool keeps a larger one")
        object.__setattr__(self, "angle", angle)
        tool_name(self.tool)

    @property
    def name(self) -> str:
        return f"tilt of {self.tool or 'tool'} axis {_format_vector(self.axis)} from {_format_vector(self.direction)}"

    @property
    def of_tool(self) -> str | None:
        return self.tool

    def rows(self, at: SymbolicPose) -> ca.SX:
        axis, direction = ca.DM(self.axis), ca.DM(self.direction)
        return (ca.dot(direction, at.rotation @ axis) - np.cos(self.angle)) / self._scale

    def tool_rows(self) -> Array:
        axis, direction = np.array(self.axis), np.array(self.direction)
        columns = (axis[:, None] * direction).ravel()
        return np.concatenate([np.zeros(3), columns, [-np.cos(self.angle)]])[None] / self._scale

    def figure(self, value: float) -> str:
        tilt = np.rad2deg(np.arccos(np.clip(value * self._scale + np.cos(self.angle), -1.0, 1.0)))
        return f"up to {tilt:.5g}°, allowed {np.rad2deg(self.angle):.5g}°"

    @property
    def _scale(self) -> float:
        """The slope of the cosine at the limit: the row is about the angle that is left [rad]."""
        sine = float(np.sin(self.angle))
        return sine if self.angle <= np.pi / 2 else max(sine, LEAST_SINE)


def contradiction(one: TiltLimit, other: TiltLimit) -> bool:
    """Whether no rotation of a tool keeps both limits."""
    axes, directions = (
        float(np.arccos(np.clip(np.dot(a, b), -1.0, 1.0)))
        for a, b in ((one.axis, other.axis), (one.direction, other.direction))
    )
    return abs(axes - directions) > one.angle + other.angle


def _unit(argument: str, vector: ArrayLike) -> tuple[float, ...]:
    array = finite_array(argument, vector, (3,))
    array = array / max(float(np.abs(array).max()), 1e-9)
    length = float(np.linalg.norm(array))
    if length < 1e-9:
        raise InvalidInputError(argument, vector, "a vector (3,) that is not zero")
    return tuple(float(each) for each in array / length)


def _format_vector(vector: ArrayLike) -> str:
    return "(" + ", ".join(f"{each:.4g}" for each in np.asarray(vector)) + ")"


#: Smallest width of a box [m].
LEAST_WIDTH = 1e-3


@one_line
@dataclass(frozen=True)
class PositionBox(Constraint):
    """The origin of the tool frame stays inside a box.

    Attributes:
        lower, upper: (3,) corners in the frame of `pose` [m], at least 1e-3 m apart; -inf and inf leave a side open.
        pose: (4, 4) or pin.SE3 of the box's frame in the world; None: the world's own.
        tool: the tool frame of a robot with several; None: the first one.

    Raises InvalidInputError: a box without an inside, or without any wall.
    """

    lower: ArrayLike
    upper: ArrayLike
    pose: ArrayLike | pin.SE3 | None = None
    tool: str | None = None

    def __post_init__(self) -> None:
        for name in ("lower", "upper"):
            given = getattr(self, name)
            array = number_array(name, given)
            if array.shape != (3,) or np.isnan(array).any():
                raise InvalidInputError(name, given, "three numbers [m]; -inf and inf leave a side open")
            object.__setattr__(self, name, tuple(array.tolist()))
        lower, upper = np.array(self.lower), np.array(self.upper)
        for axis, low, high in zip("xyz", lower, upper, strict=True):
            if not high - low >= LEAST_WIDTH:
                wanted = f"a box whose upper {axis} is at least {LEAST_WIDTH:g} m above the lower one"
                raise InvalidInputError("upper", f"{axis} from {low:g} to {high:g}", wanted)
        if not np.isfinite(np.concatenate([lower, upper])).any():
            raise InvalidInputError("upper", list(upper), "a box with at least one wall")
        if self.pose is not None:
            matrix = pose_matrix("pose", self.pose)
            object.__setattr__(self, "pose", tuple(tuple(float(each) for each in row) for row in matrix))
        tool_name(self.tool)

    @property
    def name(self) -> str:
        sides = zip("xyz", np.asarray(self.lower), np.asarray(self.upper), strict=True)
        walls = [f"{axis} {low:g} to {high:g}" for axis, low, high in sides if np.isfinite([low, high]).any()]
        frame = "" if self.pose is None else ", in its frame"
        return f"{self.tool or 'tool'} position {', '.join(walls)} m{frame}"

    @property
    def of_tool(self) -> str | None:
        return self.tool

    def rows(self, at: SymbolicPose) -> ca.SX:
        walls = self.tool_rows()
        return ca.DM(walls[:, :3]) @ at.position + ca.DM(walls[:, -1])

    def tool_rows(self) -> Array:
        frame = np.eye(4) if self.pose is None else np.array(self.pose)
        rows = []
        for axis, low, high in zip(frame[:3, :3].T, np.asarray(self.lower), np.asarray(self.upper), strict=True):
            at = float(axis @ frame[:3, 3])
            rows += [[*axis, *[0.0] * 9, -at - low]] if np.isfinite(low) else []
            rows += [[*-axis, *[0.0] * 9, at + high]] if np.isfinite(high) else []
        return np.array(rows)

    def figure(self, value: float) -> str:
        return f"{1e3 * value:.4g} mm inside" if value >= 0 else f"{-1e3 * value:.4g} mm outside"


@one_line
@dataclass(frozen=True)
class HeldJoints(Constraint):
    """Joints that keep their value at the start of a motion. The manipulability is still that of the whole arm.

    Attributes:
        joints: their names, at least one, and not all of the arm's.

    Raises InvalidInputError: no names, or one twice.
    """

    joints: str | Sequence[str]

    def __post_init__(self) -> None:
        joints = (self.joints,) if isinstance(self.joints, str) else self.joints
        if not isinstance(joints, list | tuple) or not joints or not all(isinstance(each, str) for each in joints):
            raise InvalidInputError("joints", self.joints, "names of joints, at least one")
        if len(set(joints)) < len(joints):
            raise InvalidInputError("joints", self.joints, "each name once")
        object.__setattr__(self, "joints", tuple(joints))

    @property
    def name(self) -> str:
        return f"held: {', '.join(self.joints)}"

    def rows(self, at: SymbolicPose) -> ca.SX:
        return at.q[:0]  # held joints are left out of the unknowns

    def figure(self, value: float) -> str:
        return "not moved" if value == 0 else f"moved by {abs(value):.4g} rad or m"

    def check(self, robot: Robot) -> None:
        for each in self.joints:
            if each not in robot.joint_names:
                raise UnknownNameError("constraints.joints", each, robot.joint_names)
        if len(self.joints) == robot.n:
            raise InvalidInputError(
                "constraints.joints", list(self.joints), "some of the joints: an arm that holds all is still"
            )

    def mask(self, robot: Robot) -> NDArray[np.bool_]:
        """Which joints (n,) are held."""
        return np.isin(robot.joint_names, self.joints)


#: For each key of an entry: the class, and its keys, those first that are needed.
KEYS: dict[str, tuple[type[TiltLimit | PositionBox | HeldJoints], tuple[str, ...], tuple[str, ...]]] = {
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
KINDS: dict[str, type[TiltLimit | PositionBox | HeldJoints]] = {each.__name__: each for each, *_ in KEYS.values()}


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
