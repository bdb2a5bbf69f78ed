"""MoveIt's message PlanningScene in YAML, as ROS and MotionBenchMaker write it."""

import logging
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.shapes import Box, Cylinder, Mesh, Obstacle, Sphere, half_space
from manipplan.support.checks import Array, existing_file, finite_array
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.yaml_files import read_yaml

log = logging.getLogger("manipplan")

#: Numbers of shapes in SolidPrimitive.msg.
PRIMITIVES = {1: "box", 2: "sphere", 3: "cylinder"}
#: What adds an object, in CollisionObject.msg: a number, a letter of a byte array, or a word.
ADD = (0, "\x00", "add", "ADD")
#: Frames by name: the frame in which each is given, and its pose there.
Frames = Mapping[str, tuple[str, pin.SE3]]


def read_planning_scene(file: Path, packages: Mapping[str, Path]) -> tuple[list[tuple[str, list[Obstacle]]], list[list[str]]]:
    """Name and shapes of each object, posed in one frame for all, and pairs of an object and a link that may touch.

    Pairs of links in the allowed collision matrix are left out: those of the robot's SRDF count.

    Raises InvalidInputError that names the entry.
    """
    data = _mapping("PlanningScene", read_yaml("file", file))
    if "world" not in data:
        raise InvalidInputError("PlanningScene", sorted(map(str, data)), "a mapping with the key world")
    world = _mapping("world", data["world"])
    _check_left_out(file, data, world)
    frames = dict(_transform(each) for each in _list("fixed_frame_transforms", data))
    objects, roots = [], set()
    for i, entry in enumerate(_list("collision_objects", world)):
        name, frame, shapes = _object(f"collision_objects[{i}]", _mapping(f"collision_objects[{i}]", entry), file, packages)
        root, pose = _in_root(frame, frames)
        roots |= {root} - {""}
        objects.append((name, [shape.at(pose) for shape in shapes]))
    if len(roots) > 1:
        wanted = "one frame for all objects, or fixed_frame_transforms that connect their frames"
        raise InvalidInputError("frame_id", ", ".join(sorted(roots)), wanted)
    matrix = _mapping("allowed_collision_matrix", data.get("allowed_collision_matrix"))
    return objects, _allowed(matrix, [name for name, _ in objects])


def _check_left_out(file: Path, data: Mapping[str, Any], world: Mapping[str, Any]) -> None:
    """Raise InvalidInputError for bodies that are not read, and warn of paddings."""
    octomap = _mapping("octomap", _mapping("octomap", world.get("octomap")).get("octomap"))
    carried = _list("attached_collision_objects", _mapping("robot_state", data.get("robot_state")))
    if octomap.get("data"):
        raise InvalidInputError("octomap", f"{len(octomap['data'])} bytes", "an empty octomap: it is not read")
    if carried:
        names = [_mapping("object", _mapping("attached_collision_objects", each).get("object")).get("id") for each in carried]
        raise InvalidInputError("attached_collision_objects", names, "none: attach parts to the robot with robot.attach")
    for key, usual in (("link_padding", 0.0), ("link_scale", 1.0)):
        if any(_mapping(key, each).get(key[5:], usual) != usual for each in _list(key, data)):
            log.warning("%s: %s is not used; give clearance= instead", file, key)


def _object(where: str, given: Mapping[str, Any], file: Path, packages: Mapping[str, Path]) -> tuple[str, str, list[Obstacle]]:
    """Name and frame of a collision object, and its shapes posed in that frame."""
    name = given.get("id")
    if not isinstance(name, str) or not name.strip():
        raise InvalidInputError(f"{where}.id", name, "a name")
    if given.get("operation", 0) not in ADD:
        raise InvalidInputError(f"{name}.operation", given["operation"], "0, which adds the object")
    place = _pose(f"{name}.pose", given["pose"]) if given.get("pose") else pin.SE3.Identity()
    shapes: list[Obstacle] = []
    for kind, key in (("primitives", "primitive_poses"), ("meshes", "mesh_poses"), ("planes", "plane_poses")):
        values, poses = _list(kind, given), _list(key, given)
        if len(values) != len(poses):
            raise InvalidInputError(f"{name}.{key}", f"{len(poses)} poses", f"{len(values)}, one for each of the {kind}")
        for i, (value, pose) in enumerate(zip(values, poses, strict=True)):
            at = f"{name}.{kind}[{i}]"
            entry = _mapping(at, value)
            if kind == "primitives":
                shape = _primitive(at, entry)
            elif kind == "meshes":
                shape = _mesh(at, entry, file, packages)
            else:
                shape = half_space(finite_array(f"{at}.coef", entry.get("coef", ()), (4,)))
            shapes.append(shape.at(place * _pose(f"{name}.{key}[{i}]", pose)))
    if not shapes:
        raise InvalidInputError(name, "no shape", "at least one primitive, mesh or plane")
    return name.strip(), _frame_of(given), shapes


def _primitive(where: str, given: Mapping[str, Any]) -> Obstacle:
    kind = given.get("type")
    kind = PRIMITIVES.get(kind, str(kind)) if isinstance(kind, int) else str(kind).lower()
    if kind not in PRIMITIVES.values():
        raise UnknownNameError(f"{where}.type", kind, [*PRIMITIVES.values(), *map(str, PRIMITIVES)])
    sizes = finite_array(f"{where}.dimensions", given.get("dimensions", ()), ({"box": 3, "sphere": 1, "cylinder": 2}[kind],))
    if kind == "box":
        return Box(size=sizes)
    return Sphere(radius=float(sizes[0])) if kind == "sphere" else Cylinder(length=float(sizes[0]), radius=float(sizes[1]))


def _mesh(where: str, given: Mapping[str, Any], file: Path, packages: Mapping[str, Path]) -> Obstacle:
    if "resource" in given:
        scale = finite_array(f"{where}.dimensions", given.get("dimensions", [1.0, 1.0, 1.0]), (3,))
        if scale.min() != scale.max():
            raise InvalidInputError(f"{where}.dimensions", scale.tolist(), "three equal factors")
        return Mesh(file=_file(where, str(given["resource"]), file, packages), scale=float(scale[0]))
    vertices = np.array([_vector(f"{where}.vertices", each, "xyz") for each in _list("vertices", given)]).reshape(-1, 3)
    faces = [_mapping(where, each).get("vertex_indices", ()) for each in _list("triangles", given)]
    corners = np.array([finite_array(f"{where}.triangles", face, (3,)) for face in faces]).reshape(-1, 3)
    if not np.isin(corners, np.arange(len(vertices))).all():
        raise InvalidInputError(f"{where}.triangles", f"vertex {corners.max():g}", f"vertices 0 to {len(vertices) - 1}")
    return Mesh(triangles=vertices[corners.astype(int)])


def _file(where: str, resource: str, file: Path, packages: Mapping[str, Path]) -> Path:
    if not resource.startswith("package://"):
        return existing_file(where, file.parent / resource.removeprefix("file://"))
    package, _, rest = resource.removeprefix("package://").partition("/")
    if package not in packages:
        raise UnknownNameError("packages", package, packages or ["none: give packages={name: folder}"])
    return existing_file(where, packages[package] / rest)


def _transform(entry: Any) -> tuple[str, tuple[str, pin.SE3]]:
    given = _mapping("fixed_frame_transforms", entry)
    transform = _mapping("transform", given.get("transform"))
    pose = _pose("transform", {"position": transform.get("translation"), "orientation": transform.get("rotation")})
    return str(given.get("child_frame_id", "")).strip("/"), (_frame_of(given), pose)


def _in_root(frame: str, frames: Frames) -> tuple[str, pin.SE3]:
    """The frame at the end of the chain of transforms that begins at `frame`, and the pose of `frame` in it."""
    pose, seen = pin.SE3.Identity(), [frame]
    while frame in frames:
        frame, step = frames[frame]
        pose = step * pose
        if frame in seen:
            raise InvalidInputError("fixed_frame_transforms", [*seen, frame], "a tree of frames, not a loop")
        seen.append(frame)
    return frame, pose


def _allowed(matrix: Mapping[str, Any], objects: list[str]) -> list[list[str]]:
    names, rows = _list("entry_names", matrix), _list("entry_values", matrix)
    if any(_list("default_entry_values", matrix)):
        log.warning("default_entry_values of the allowed collision matrix are not used: only pairs are allowed to touch")
    pairs = []  # the matrix is symmetric
    for name, row in zip(names, rows, strict=False):
        for other, may in zip(names, _list("enabled", _mapping("entry_values", row)), strict=False):
            if may is True and name in objects and other not in objects:
                pairs.append([str(name), str(other)])
    return pairs


def _pose(where: str, value: Any) -> pin.SE3:
    """A pose of mappings or lists: position x, y, z and orientation x, y, z, w; zeros mean no rotation, as in MoveIt."""
    given = _mapping(where, value)
    position = _vector(f"{where}.position", given.get("position"), "xyz")
    quaternion = _vector(f"{where}.orientation", given.get("orientation"), "xyzw")
    size = np.linalg.norm(quaternion)
    if size == 0:
        return pin.SE3(np.eye(3), position)
    if not 0.99 < size < 1.01:
        raise InvalidInputError(f"{where}.orientation", quaternion.tolist(), "a quaternion x, y, z, w of length 1")
    return pin.SE3(pin.Quaternion(quaternion / size).matrix(), position)


def _vector(where: str, value: Any, keys: str) -> Array:
    if isinstance(value, Mapping):
        value = [value.get(key, 0.0) for key in keys]
    return finite_array(where, value if value is not None else np.zeros(len(keys)), (len(keys),))


def _frame_of(given: Mapping[str, Any]) -> str:
    return str(_mapping("header", given.get("header")).get("frame_id") or "").strip("/")


def _mapping(where: str, value: Any) -> Mapping[str, Any]:
    """A mapping; {} for nothing."""
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        raise FileFormatError(where, str(value)[:80], "a mapping")
    return value


def _list(key: str, given: Mapping[str, Any]) -> list[Any]:
    """The list under a key; [] for nothing."""
    value = given.get(key)
    if value is not None and not isinstance(value, list):
        raise InvalidInputError(key, str(value)[:80], "a list")
    return value or []
