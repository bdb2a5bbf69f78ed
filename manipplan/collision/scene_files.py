"""Scenes of other programs: files of MoveIt and MuJoCo go in, obstacles come out.

MoveIt's scenes: the text format `.scene`, objects with their shapes, poses and colours, and the message PlanningScene in YAML,
as ROS and MotionBenchMaker write it.

The static bodies of a MuJoCo model (MJCF) are read by MuJoCo itself.
"""

import itertools
import logging
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.shapes import Box, Capsule, Cylinder, Mesh, Obstacle, Plane, Sphere, check_obstacles
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.mjcf import SHAPES, colliding_geoms, fixed_pose, local_pose, stands_still, surface_of
from manipplan.robots.mjcf_files import compile_mjcf
from manipplan.support.checks import Array, existing_file, finite_array, unit_quaternion
from manipplan.support.data_files import read_yaml
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

log = logging.getLogger("manipplan")


def pose_of(argument: str, position: Array, quaternion: Array) -> pin.SE3:
    """The pose of a position (3,) [m] and a quaternion x, y, z, w; zeros mean no rotation, as in MoveIt."""
    finite_array("position", position, (3,), most=FARTHEST)
    if not np.any(quaternion):
        log.warning("%s is 0 0 0 0, which is no rotation: taken as none, as in MoveIt", argument)
        return pin.SE3(np.eye(3), position)
    return pin.SE3(pin.Quaternion(unit_quaternion(argument, quaternion, "x, y, z, w")).matrix(), position)


def half_space(argument: str, coefficients: Array) -> Plane:
    """The half-space a x + b y + c z + d <= 0 of `coefficients` (4,)."""
    size = float(np.linalg.norm(finite_array(argument, coefficients, (4,), most=FARTHEST)[:3]))
    if not size > 0:
        raise InvalidInputError(argument, coefficients.tolist(), "a plane with a normal other than zero")
    normal = coefficients[:3] / size
    distance = float(coefficients[3]) / size
    if not abs(distance) <= FARTHEST:
        raise InvalidInputError(argument, coefficients.tolist(), f"a plane within {FARTHEST:g} m")
    turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), normal).matrix()
    return Plane(position=-distance * normal, rotation=turn)


def triangles_of(argument: str, vertices: Array, corners: Array) -> Array:
    """Triangles (t, 3, 3) of vertices (v, 3) and the numbers of their corners (t, 3), from 0."""
    if not np.isin(corners, np.arange(len(vertices))).all():
        raise InvalidInputError(argument, f"vertex {corners.max():g}", f"vertices 0 to {len(vertices) - 1}")
    return np.asarray(vertices[corners.astype(int)])


#: Number of sizes of the primitives of MoveIt.
SIZES = {"box": 3, "sphere": 1, "cylinder": 2}


def primitive(kind: str, sizes: Array, **options: Any) -> Obstacle:
    """A box of three edges, a sphere of a radius, or a cylinder or capsule of radius and length [m]."""
    if kind == "box":
        return Box(size=sizes, **options)
    if kind == "sphere":
        return Sphere(radius=float(sizes[0]), **options)
    shape = Cylinder if kind == "cylinder" else Capsule
    return shape(radius=float(sizes[0]), length=float(sizes[1]), **options)


@contextmanager
def _errors_of(where: str) -> Iterator[None]:
    """Turn an InvalidInputError in this block into a FileFormatError that says where the fault is."""
    try:
        yield
    except (FileFormatError, UnknownNameError):
        raise
    except InvalidInputError as error:
        raise FileFormatError("file", f"{where}, {error.argument}: {error.value}", error.allowed) from error


TEXT_SHAPES = ("box", "sphere", "cylinder", "plane", "mesh")
#: Number of values of a colour: red, green, blue, opacity.
COLOUR = 4


def read_scene_text(file: Path) -> list[tuple[str, list[Obstacle]]]:
    """Name and shapes of each object, posed in the world.

    Raises:
        FileFormatError: the file is cut off or holds something else; the message names the object.
        UnknownNameError: a shape that this package does not have, such as a cone.
    """
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise FileFormatError("file", str(file), f"text in UTF-8 ({error})") from error
    starts = [k for k, line in enumerate(lines) if line.startswith("*")]
    ends = [k for k, line in enumerate(lines) if line.strip() == "."]
    first = starts[0] if starts else ends[0] if ends else 0
    between = lines[1:first] + (lines[ends[0] + 1 :] if ends else [])
    if not ends or first == 0 or any(k > ends[0] for k in starts) or any(line.strip() for line in between):
        raise FileFormatError("file", str(file), "a scene of MoveIt: its name, objects that begin with *, and a last line .")
    check_obstacles("file", len(starts))
    objects = []
    for first, last in itertools.pairwise([*starts, ends[0]]):
        name = lines[first][1:].strip()
        where = f"{file}, object {name}"
        with _errors_of(where):
            objects.append((name, _Words(where, lines[first + 1 : last]).shapes()))
    return objects


class _Words:
    """The words of one object, from first to last."""

    def __init__(self, where: str, lines: Sequence[str]) -> None:
        self.where = where
        self.words = " ".join(lines).split()
        self.at = 0
        #: whether the pose of the object comes before the number of its shapes, as in the newer format
        self.posed = bool(lines) and len(lines[0].split()) > 1

    def shapes(self) -> list[Obstacle]:
        """The shapes, up to the last word."""
        frame = self._pose() if self.posed else pin.SE3.Identity()
        shapes = []
        for _ in range(self._count("the number of shapes", least=1)):
            shape, pose = self._shape(), self._pose()
            self._numbers("a colour", COLOUR)
            shapes.append(shape.at(frame * pose))
        for _ in range(self._count("the number of subframes") if self.posed else 0):
            self._word("the name of a subframe")
            self._pose()
        if self.at < len(self.words):
            raise self._error("the next object", self.words[self.at])
        return shapes

    def _shape(self) -> Obstacle:
        kind = self._word("a shape").lower()
        if kind in SIZES:
            return primitive(kind, self._numbers(f"a {kind}", SIZES[kind]))
        if kind == "plane":
            return half_space("plane", self._numbers("a plane", 4))
        if kind == "mesh":
            counts = self._count("the number of vertices", least=3), self._count("the number of triangles", least=1)
            vertices = self._numbers("vertices", 3 * counts[0]).reshape(-1, 3)
            corners = self._numbers("triangles", 3 * counts[1])
            return Mesh(triangles=triangles_of("triangles", vertices, corners.reshape(-1, 3)))
        raise UnknownNameError(self.where, kind, TEXT_SHAPES)

    def _pose(self) -> pin.SE3:
        """Position and unit quaternion x, y, z, w."""
        values = self._numbers("a pose", 7)
        return pose_of("orientation", values[:3], values[3:])

    def _count(self, wanted: str, least: int = 0) -> int:
        [value] = self._numbers(wanted, 1)
        if value != int(value) or not least <= value <= len(self.words):
            raise self._error(f"{wanted}, {least} to {len(self.words)}", f"{value:g}")
        return int(value)

    def _numbers(self, wanted: str, count: int) -> Array:
        words = self.words[self.at : self.at + count]
        try:
            values = np.array([float(word) if "_" not in word else np.nan for word in words])
        except ValueError as error:
            raise self._error(f"{count} numbers for {wanted}", str(error)) from error
        if len(values) < count or not np.isfinite(values).all():
            raise self._error(f"{count} finite numbers for {wanted}", " ".join(words) or "the end")
        self.at += count
        return values

    def _word(self, wanted: str) -> str:
        if self.at == len(self.words):
            raise self._error(wanted, "the end")
        self.at += 1
        return self.words[self.at - 1]

    def _error(self, wanted: str, found: str) -> FileFormatError:
        return FileFormatError("file", f"{self.where}: {found[:80]}", wanted)


#: Numbers of shapes in SolidPrimitive.msg.
PRIMITIVES = {1: "box", 2: "sphere", 3: "cylinder"}
#: Values of `operation` in CollisionObject.msg that add an object: as a number, a byte or a word.
ADD = (0, "\x00", "add", "ADD")
#: Keys of PlanningScene.msg and CollisionObject.msg.
MESSAGE = (
    "name",
    "robot_state",
    "robot_model_name",
    "fixed_frame_transforms",
    "allowed_collision_matrix",
    "link_padding",
    "link_scale",
    "object_colors",
    "world",
    "is_diff",
)
OBJECT = (
    "header",
    "id",
    "type",
    "pose",
    "primitives",
    "primitive_poses",
    "meshes",
    "mesh_poses",
    "planes",
    "plane_poses",
    "operation",
    "subframe_names",
    "subframe_poses",
)
Packages = Mapping[str, str | Path]
#: Name and shapes of each object, and pairs of names that may touch.
Contents = tuple[list[tuple[str, list[Obstacle]]], list[list[str]]]
#: Frames by name: the frame in which each is given, and its pose there.
Frames = Mapping[str, tuple[str, pin.SE3]]


def read_planning_scene(file: Path, packages: Packages) -> Contents:
    """Name and shapes of each object, posed in one frame for all, and pairs of an object and a link that may touch.

    Pairs of links in the allowed collision matrix are left out: those of the robot's SRDF count.

    Raises:
        FileFormatError: the file holds something else; the message names the entry.
        UnknownNameError: a shape that this package does not have, such as a cone, or an unknown package.
    """
    with _errors_of(str(file)):
        return _read(file, packages)


def _read(file: Path, packages: Packages) -> Contents:
    data = _mapping("PlanningScene", read_yaml("file", file), MESSAGE)
    world = _mapping("world", data.get("world"), ("collision_objects", "octomap"))
    if "collision_objects" not in world:
        raise InvalidInputError("PlanningScene", sorted(map(str, data)), "the key world with collision_objects")
    _check_left_out(file, data, world)
    frames: dict[str, tuple[str, pin.SE3]] = {}
    for each in _list("fixed_frame_transforms", data):
        child, transform = _transform(each)
        if child in frames:
            raise InvalidInputError("fixed_frame_transforms", f"{child!r} twice", "each frame once")
        frames[child] = transform
    objects, roots = [], set()
    check_obstacles("collision_objects", len(_list("collision_objects", world)))
    for i, entry in enumerate(_list("collision_objects", world)):
        where = f"collision_objects[{i}]"
        name, frame, shapes = _object(where, _mapping(where, entry, OBJECT), file, packages)
        root, pose = _in_root(frame, frames)
        roots.add(root)
        objects.append((name, [shape.at(pose) for shape in shapes]))
    if len(roots) > 1:
        wanted = "one frame for all objects, or fixed_frame_transforms that connect their frames"
        raise InvalidInputError("frame_id", ", ".join(repr(root) for root in sorted(roots)), wanted)
    matrix = _mapping("allowed_collision_matrix", data.get("allowed_collision_matrix"))
    return objects, _read_allowed(matrix, [name for name, _ in objects])


def _check_left_out(file: Path, data: Mapping[str, Any], world: Mapping[str, Any]) -> None:
    """Raise InvalidInputError for an octomap or attached objects, which are not read; warn of link_padding and link_scale."""
    octomap = _mapping("octomap", _mapping("octomap", world.get("octomap")).get("octomap"))
    carried = _list("attached_collision_objects", _mapping("robot_state", data.get("robot_state")))
    if octomap.get("data"):
        raise InvalidInputError("octomap", "data", "an empty octomap: it is not read")
    if carried:
        names = [_mapping("object", _mapping("attached_collision_objects", each).get("object")).get("id") for each in carried]
        raise InvalidInputError("attached_collision_objects", names, "none: attach parts to the robot with robot.attach")
    for key, value, usual in (("link_padding", "padding", 0.0), ("link_scale", "scale", 1.0)):
        if any(_mapping(key, each).get(value, usual) != usual for each in _list(key, data)):
            log.warning("%s: %s is not used; give clearance= instead", file, key)


def _object(where: str, given: Mapping[str, Any], file: Path, packages: Packages) -> tuple[str, str, list[Obstacle]]:
    """Name and frame of a collision object, and its shapes posed in that frame."""
    name = given.get("id")
    if not isinstance(name, str) or not name.strip():
        raise InvalidInputError(f"{where}.id", name, "a name")
    if given.get("operation", 0) not in ADD:
        raise InvalidInputError(f"{name}.operation", given["operation"], "0, which adds the object")
    frame = _pose(f"{name}.pose", given["pose"]) if given.get("pose") else pin.SE3.Identity()
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
                shape = half_space(f"{at}.coef", finite_array(f"{at}.coef", entry.get("coef", ()), (4,)))
            shapes.append(shape.at(frame * _pose(f"{name}.{key}[{i}]", pose)))
    if not shapes:
        raise InvalidInputError(name, "no shape", "at least one primitive, mesh or plane")
    return name.strip(), _frame_of(given), shapes


def _primitive(where: str, given: Mapping[str, Any]) -> Obstacle:
    kind = given.get("type")
    kind = PRIMITIVES.get(kind, str(kind)) if isinstance(kind, int) else str(kind).lower()
    if kind not in PRIMITIVES.values():
        raise UnknownNameError(f"{where}.type", kind, [*PRIMITIVES.values(), *map(str, PRIMITIVES)])
    sizes = finite_array(f"{where}.dimensions", given.get("dimensions", ()), (SIZES[kind],))
    return primitive(kind, sizes[::-1] if kind == "cylinder" else sizes)  # a cylinder's length comes first


def _mesh(where: str, given: Mapping[str, Any], file: Path, packages: Packages) -> Obstacle:
    if "resource" in given:
        scale = finite_array(f"{where}.dimensions", given.get("dimensions", [1.0, 1.0, 1.0]), (3,))
        if scale.min() != scale.max():
            raise InvalidInputError(f"{where}.dimensions", scale.tolist(), "three equal factors")
        return Mesh(file=_file(where, str(given["resource"]), file, packages), scale=float(scale[0]))
    vertices = np.array([_vector(f"{where}.vertices", each, "xyz") for each in _list("vertices", given)]).reshape(-1, 3)
    faces = [_mapping(where, each).get("vertex_indices", ()) for each in _list("triangles", given)]
    corners = np.array([finite_array(f"{where}.triangles", face, (3,)) for face in faces]).reshape(-1, 3)
    return Mesh(triangles=triangles_of(f"{where}.triangles", vertices, corners))


def _file(where: str, resource: str, file: Path, packages: Packages) -> Path:
    if not resource.startswith("package://"):
        return existing_file(where, file.parent / resource.removeprefix("file://"))
    package, _, rest = resource.removeprefix("package://").partition("/")
    if package not in packages:
        raise UnknownNameError("packages", package, packages, empty="none: give packages={name: folder}")
    folder = Path(packages[package])
    if not (folder / rest).resolve().is_relative_to(folder.resolve()):
        raise InvalidInputError(f"{where}.resource", resource, "the name of a mesh that stays inside its package")
    return existing_file(where, folder / rest)


def _transform(entry: Any) -> tuple[str, tuple[str, pin.SE3]]:
    given = _mapping("fixed_frame_transforms", entry, ("header", "child_frame_id", "transform"))
    transform = _mapping("transform", given.get("transform"))
    pose = _pose("transform", transform, ("translation", "rotation"))
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


def _read_allowed(matrix: Mapping[str, Any], objects: list[str]) -> list[list[str]]:
    names, rows = _list("entry_names", matrix), _list("entry_values", matrix)
    if any(_list("default_entry_values", matrix)):
        log.warning("default_entry_values of the allowed collision matrix are not used: only pairs are allowed to touch")
    pairs = []  # the matrix is symmetric
    for name, row in zip(names, rows, strict=False):
        for other, may in zip(names, _list("enabled", _mapping("entry_values", row)), strict=False):
            if may is True and name in objects and other not in objects:
                pairs.append([str(name), str(other)])
    return pairs


def _pose(where: str, value: Any, keys: tuple[str, str] = ("position", "orientation")) -> pin.SE3:
    """A pose of mappings or lists under two keys: x, y, z and a quaternion x, y, z, w."""
    given = _mapping(where, value, keys)
    position = _vector(f"{where}.{keys[0]}", given.get(keys[0]), "xyz")
    return pose_of(f"{where}.{keys[1]}", position, _vector(f"{where}.{keys[1]}", given.get(keys[1]), "xyzw"))


def _vector(where: str, value: Any, keys: str) -> Array:
    if isinstance(value, Mapping):
        value = [_mapping(where, value, tuple(keys)).get(key, 0.0) for key in keys]
    return finite_array(where, value if value is not None else np.zeros(len(keys)), (len(keys),))


def _frame_of(given: Mapping[str, Any]) -> str:
    return str(_mapping("header", given.get("header")).get("frame_id") or "").strip("/")


def _mapping(where: str, value: Any, keys: tuple[str, ...] | None = None) -> Mapping[str, Any]:
    """A mapping with no other keys than `keys`; {} for nothing."""
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        raise InvalidInputError(where, str(value)[:80], "a mapping")
    for key in value:
        if keys is not None and key not in keys:
            raise UnknownNameError(where, str(key), keys)
    return value


def _list(key: str, given: Mapping[str, Any]) -> list[Any]:
    """The list under a key; [] for nothing."""
    value = given.get(key)
    if value is not None and not isinstance(value, list):
        raise InvalidInputError(key, str(value)[:80], "a list")
    return value or []


#: Shapes of MuJoCo that become obstacles.
TAKEN = ("plane", "hfield", "sphere", "capsule", "cylinder", "box", "mesh")


def read_static_bodies(file: Path) -> list[Obstacle]:
    """Every geom that collides, by its masks or a `<pair>`, and belongs to a body without a joint between it and the world.

    Raises:
        FileFormatError: MuJoCo cannot read the file, or it has too many geoms.
        UnknownNameError: a static geom has another shape, such as an ellipsoid.
        MissingExtraError: MuJoCo is not installed.
    """
    mj = compile_mjcf(file)
    obstacles, surfaces = list[Obstacle](), dict[tuple[str, int], Mesh]()
    standing = [each for each in colliding_geoms(file, mj) if stands_still(mj, mj.geom_bodyid[each])]
    check_obstacles("file", len(standing))
    for k in standing:
        body, shape = int(mj.geom_bodyid[k]), SHAPES[mj.geom_type[k]]
        name = mj.geom(k).name or f"{mj.body(body).name}.{k}"
        pose = fixed_pose(mj, body) * local_pose(mj.geom_pos[k], mj.geom_quat[k])
        if shape in ("mesh", "hfield"):  # several geoms may show one mesh
            data = shape, int(mj.geom_dataid[k])
            if data not in surfaces:
                vertices, faces = surface_of(file, mj, k)
                surfaces[data] = Mesh(triangles=vertices[faces])
            obstacles.append(surfaces[data].at(pose).called(name))
        else:
            obstacles.append(_obstacle(name, shape, np.array(mj.geom_size[k], dtype=float), pose))
    return obstacles


def _obstacle(name: str, shape: str, size: Array, pose: pin.SE3) -> Obstacle:
    """What a geom is; MuJoCo gives half the edges of a box, and half the length of a cylinder or capsule."""
    at: dict[str, Any] = {"name": name, "position": pose.translation, "rotation": pose.rotation}
    if shape == "plane":
        return Plane(**at)
    if shape not in TAKEN:
        raise UnknownNameError(f"shape of the geom {name}", shape, TAKEN)
    return primitive(shape, size * (2.0 if shape == "box" else [1.0, 2.0, 1.0]), **at)
