"""A tool frame, another place of the base and carried parts on the Pinocchio models of an arm; each returns copies."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Protocol, runtime_checkable

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.description import largest_size
from manipplan.robots.hulls import box_around
from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import Array, distinct_names
from manipplan.support.errors import InvalidInputError, UnknownNameError


@runtime_checkable
class Solid(Protocol):
    """A shape with a pose and a name, such as an obstacle."""

    @property
    def name(self) -> str:
        """What it is called."""
        ...

    @property
    def pose(self) -> pin.SE3:
        """Where it is."""
        ...

    def shapes(self) -> list[coal.CollisionGeometry]:
        """The coal shapes that make it up, in its own frame."""
        ...

    def at(self, pose: Any) -> "Solid":
        """A copy moved by `pose`."""
        ...


@dataclass(frozen=True, kw_only=True)
class CarriedPart:
    """A carried part: its shape, the names of its bodies in the robot's geometry, and the tool frame that it is posed in."""

    solid: Solid
    bodies: tuple[str, ...]
    frame: str


@dataclass(frozen=True, kw_only=True)
class AddedFrame:
    """A tool frame that was added: its name, and its pose (4, 4) in the tool frame before it."""

    name: str
    pose: Array
    frame: str


def check_in_hand(argument: str, name: str, hands: Mapping[str, str], tool: str) -> None:
    """Raise an error unless a part is in the hand `tool`; `hands`: the tool frame that carries each part, by its name.

    UnknownNameError, with the nearest names, for one that no hand carries; InvalidInputError for one in another hand.
    """
    if name not in hands:
        raise UnknownNameError(argument, name, hands, empty="none: the arm carries nothing then")
    if hands[name] != tool:
        raise InvalidInputError(argument, name, f"a part in the hand {tool}: {name} is in the hand {hands[name]}")


def number_names(name: str, count: int) -> tuple[str, ...]:
    """`name` for one body; name.0, name.1, ... for several."""
    return (name,) if count == 1 else tuple(f"{name}.{k}" for k in range(count))


def with_frame(model: pin.Model, parent: str, pose: pin.SE3, name: str) -> pin.Model:
    """The model with one more frame, at `pose` in the frame `parent`."""
    model = model.copy()
    index = frame_index(model, parent)
    frame = model.frames[index]
    model.addBodyFrame(name, frame.parentJoint, frame.placement * pose, index)
    return model


def in_new_frame(carried: Mapping[str, CarriedPart], old: str, pose: pin.SE3, new: str) -> dict[str, CarriedPart]:
    """The carried parts, those posed in the frame `old` now in the frame `new`, which is at `pose` in it."""
    return {
        name: replace(part, solid=part.solid.at(pose.inverse()), frame=new) if part.frame == old else part
        for name, part in carried.items()
    }


def move_base(model: pin.Model, geometry: pin.GeometryModel, motion: pin.SE3) -> tuple[pin.Model, pin.GeometryModel]:
    """The arm as a whole, moved by `motion` in the world."""
    model, geometry = model.copy(), geometry.copy()
    for joint in range(1, model.njoints):
        if model.parents[joint] == 0:
            model.jointPlacements[joint] = motion * model.jointPlacements[joint]
    for frame in list(model.frames)[1:]:  # the first is the world
        if frame.parentJoint == 0:
            frame.placement = motion * frame.placement
    for item in geometry.geometryObjects:
        if item.parentJoint == 0 and item.parentFrame > 0:  # geoms of the world of an MJCF belong to no link
            item.placement = motion * item.placement
    return model, geometry


def keeps_plane(pose: Array) -> bool:
    """Whether a pose (4, 4) maps the x-y plane to itself, and up to up."""
    return bool(np.allclose(pose[2], [0.0, 0.0, 1.0, 0.0], atol=1e-9))


def with_part(
    model: pin.Model, geometry: pin.GeometryModel, tool: str, part: Solid, name: str
) -> tuple[pin.GeometryModel, tuple[str, ...]]:
    """The geometry with a part posed in the frame `tool`, and the names of its bodies.

    Raises InvalidInputError when the part has no bounded shape, is larger than the arm makes plausible, or one of its bodies
    would have a name that is taken.
    """
    shapes = part.shapes()
    if not shapes or any(isinstance(shape, coal.Halfspace | coal.Plane) for shape in shapes):
        raise InvalidInputError("shape", part, "a bounded shape: Box, Sphere, Capsule, Cylinder or Mesh")
    if hasattr(part, "parts") and any(each.radius for each in part.parts()):  # obstacles have parts
        raise InvalidInputError("shape", part, "a shape without a distance around it (radius of its CarriedPart)")
    most = largest_size(model)
    for shape in shapes:
        size = float(np.ptp(box_around(shape), axis=0).max())
        if size > most:
            wanted = f"a part of at most {most:.3g} m, ten times the length of the arm or 5 m; {name} is {size:.3g} m long."
            raise InvalidInputError("shape", part, f"{wanted} Is it in another unit? mp.Mesh(scale=0.001) reads millimetres")
    names = number_names(name, len(shapes))
    for each in names:
        check_new_name(each, model, geometry, ())
    index = frame_index(model, tool)
    frame = model.frames[index]
    geometry = geometry.copy()
    for each, shape in zip(names, shapes, strict=True):
        geometry.addGeometryObject(pin.GeometryObject(each, frame.parentJoint, index, frame.placement * part.pose, shape))
    return geometry, names


def without_bodies(geometry: pin.GeometryModel, names: Iterable[str]) -> pin.GeometryModel:
    """The geometry without the bodies of these names."""
    geometry = geometry.copy()
    for name in names:
        geometry.removeGeometryObject(name)
    return geometry


def check_new_name(name: str, model: pin.Model, geometry: pin.GeometryModel, parts: Iterable[str]) -> None:
    """Raise InvalidInputError where `name` is not printable text, or that of a frame, a body or one of `parts`."""
    [name] = distinct_names("name", [name], 1)
    if name in parts or any(each.name == name for each in (*model.frames, *geometry.geometryObjects)):
        raise InvalidInputError("name", name, "a name that no link, frame, body or part of the robot has")
