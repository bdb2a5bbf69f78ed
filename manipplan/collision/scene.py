"""Scene: the obstacles around a robot, in code or from a YAML file."""

import os
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import MISSING, dataclass, field, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike, NDArray

from manipplan.paths.joint import JointPath
from manipplan.robots.hulls import FARTHEST, convex_hull, has_hull
from manipplan.robots.ply import fault_of
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, configurations, existing_file, finite_array, instance, number, number_array
from manipplan.support.display import Pictured
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.files import write_text
from manipplan.support.memo import once_per_owner, state_without_memo

if TYPE_CHECKING:
    from manipplan.collision.model import CollisionModel
    from manipplan.collision.path_clearance import PathClearance


@dataclass(frozen=True, kw_only=True, eq=False)
class Obstacle(ABC):
    """A static obstacle. Its pose in the world: `position` (3,) [m] of its centre and `rotation`.

    `rotation` is None, a rotation matrix (3, 3), or roll, pitch and yaw (3,) [rad] as in URDF.
    """

    position: ArrayLike = (0.0, 0.0, 0.0)
    rotation: ArrayLike | None = None
    name: str = ""
    shape_name: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise InvalidInputError(f"{type(self).__name__}.name", self.name, "text")
        object.__setattr__(self, "position", finite_array(self._argument("position"), self.position, (3,)))
        if self.rotation is not None:
            object.__setattr__(self, "rotation", self._rotation_matrix(self.rotation))
        for length in ("radius", "length"):
            if hasattr(self, length):
                object.__setattr__(self, length, number(self._argument(length), getattr(self, length), above=0.0))

    @property
    def pose(self) -> pin.SE3:
        """T_world_obstacle."""
        rotation = np.eye(3) if self.rotation is None else np.asarray(self.rotation)
        return pin.SE3(rotation, np.asarray(self.position))

    @abstractmethod
    def shapes(self) -> list[coal.CollisionGeometry]:
        """Convex coal shapes that make up the obstacle, in its own frame."""

    def _argument(self, name: str) -> str:
        return f"{self.name or type(self).__name__}.{name}"

    def _rotation_matrix(self, rotation: ArrayLike) -> Array:
        argument = self._argument("rotation")
        if number_array(argument, rotation).shape == (3,):
            return np.asarray(pin.rpy.rpyToMatrix(*finite_array(argument, rotation, (3,))))
        matrix = finite_array(argument, rotation, (3, 3))
        if not np.allclose(matrix @ matrix.T, np.eye(3), atol=1e-6) or np.linalg.det(matrix) < 0:
            raise InvalidInputError(argument, rotation, "a rotation matrix (3, 3), or roll, pitch, yaw (3,) [rad]")
        return matrix


@dataclass(frozen=True, kw_only=True, eq=False)
class Box(Obstacle):
    """A box with edges `size` (dx, dy, dz) [m]."""

    size: ArrayLike
    shape_name = "box"

    def __post_init__(self) -> None:
        super().__post_init__()
        size = finite_array(self._argument("size"), self.size, (3,))
        if not (size > 0).all():
            raise InvalidInputError(self._argument("size"), self.size, "three numbers above zero [m]")
        object.__setattr__(self, "size", size)

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Box(np.asarray(self.size))]


@dataclass(frozen=True, kw_only=True, eq=False)
class Sphere(Obstacle):
    """A ball of `radius` [m]."""

    radius: float
    shape_name = "sphere"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Sphere(self.radius)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Capsule(Obstacle):
    """A cylinder of `radius` and `length` [m] along z with a hemisphere at either end."""

    radius: float
    length: float
    shape_name = "capsule"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Capsule(self.radius, self.length)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Cylinder(Obstacle):
    """A cylinder of `radius` and `length` [m] along z."""

    radius: float
    length: float
    shape_name = "cylinder"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Cylinder(self.radius, self.length)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Plane(Obstacle):
    """The half-space below the x-y plane of its pose: a floor or, rotated, a wall."""

    shape_name = "plane"

    def shapes(self) -> list[coal.CollisionGeometry]:
        return [coal.Halfspace(np.array([0.0, 0.0, 1.0]), 0.0)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh(Obstacle):
    """The mesh of a file (STL, OBJ, DAE, ...), with its vertices multiplied by `scale`.

    A mesh is a hollow surface, inside which nothing would collide, so every connected part is replaced by its convex hull.
    """

    file: str | Path
    scale: float = 1.0
    hulls: list[coal.CollisionGeometry] = field(init=False, repr=False)
    shape_name = "mesh"

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "file", existing_file(self._argument("file"), self.file))
        object.__setattr__(self, "scale", number(self._argument("scale"), self.scale, above=0.0))
        object.__setattr__(self, "hulls", _hulls(self._argument("file"), Path(self.file), self.scale))

    def shapes(self) -> list[coal.CollisionGeometry]:
        return self.hulls


OBSTACLES: dict[str, type[Obstacle]] = {kind.shape_name: kind for kind in (Box, Sphere, Capsule, Cylinder, Plane, Mesh)}


class Scene(Pictured):
    """Static obstacles. An empty scene still checks a robot for self-collision."""

    def __init__(self, obstacles: Sequence[Obstacle] = ()) -> None:
        if not isinstance(obstacles, list | tuple):
            raise InvalidInputError("obstacles", obstacles, "a list of obstacles")
        for obstacle in obstacles:
            if not isinstance(obstacle, Obstacle):
                raise InvalidInputError("obstacles", obstacle, f"a list of {', '.join(k.__name__ for k in OBSTACLES.values())}")
        self.obstacles = tuple(obstacles)
        names = [obstacle.name or f"{obstacle.shape_name}{i}" for i, obstacle in enumerate(self.obstacles)]
        doubled = next((name for name in names if names.count(name) > 1), None)
        if doubled is not None:
            raise InvalidInputError("obstacles", doubled, "names that differ")
        self.names = tuple(names)

    @classmethod
    def from_yaml(cls, file: str | Path) -> "Scene":
        """Read a scene: ``obstacles: [{shape: box, size: [1, 1, 0.1], position: [0, 0, -0.05], name: table}, ...]``.

        Shapes are box (size), sphere (radius), capsule and cylinder (radius, length), plane and mesh (file, scale); each takes
        position, rotation (matrix, or roll-pitch-yaw [rad]) and name. The path of a mesh is relative to the scene file.

        Raises FileFormatError or InvalidInputError that names the obstacle, the key and what is allowed.
        """
        from manipplan.support.yaml_files import read_yaml

        path = existing_file("scene", file)
        data = read_yaml("scene", path)
        if not isinstance(data, dict) or set(data) != {"obstacles"} or not isinstance(data["obstacles"], list):
            keys = f" with the keys {', '.join(map(str, data))}" if isinstance(data, dict) else ""
            raise FileFormatError("scene", f"{path}{keys}", "one key, obstacles, with a list")
        return cls.from_entries(data["obstacles"], path.parent)

    def to_yaml(self, file: str | Path) -> None:
        """Write the scene so that `from_yaml` reads it back."""
        import yaml

        folder = Path(file).expanduser().resolve().parent
        entries = [
            {key: os.path.relpath(value, folder) if isinstance(value, Path) else value for key, value in entry.items()}
            for entry in self.entries()
        ]
        write_text(file, yaml.safe_dump({"obstacles": entries}, sort_keys=False, default_flow_style=None))

    @classmethod
    def from_entries(cls, entries: Sequence[Any], folder: str | Path = ".") -> "Scene":
        """The scene of `entries`, each a mapping as in a YAML file; paths of mesh files are relative to `folder`."""
        return cls([_obstacle(f"obstacles[{i}]", entry, Path(folder)) for i, entry in enumerate(entries)])

    def entries(self) -> list[dict[str, Any]]:
        """Name, shape and numbers of every obstacle as plain values; the file of a mesh as a Path.

        Raises InvalidInputError for an obstacle of a class that is not in this package.
        """
        entries = []
        for name, obstacle in zip(self.names, self.obstacles, strict=True):
            if OBSTACLES.get(obstacle.shape_name) is not type(obstacle):
                kinds = ", ".join(kind.__name__ for kind in OBSTACLES.values())
                raise InvalidInputError("obstacles", f"{name}, a {type(obstacle).__name__}", f"obstacles of the kinds {kinds}")
            entry: dict[str, Any] = {"name": name, "shape": obstacle.shape_name}
            for each in fields(obstacle):
                value = getattr(obstacle, each.name)
                if each.name != "name" and value is not None and each.init:
                    entry[each.name] = value.tolist() if isinstance(value, np.ndarray) else value
            entries.append(entry)
        return entries

    def collision_model(self, robot: Robot) -> "CollisionModel":
        """The collision model of the robot among these obstacles, built once."""
        return self._collision_model(instance("robot", robot, Robot))

    @once_per_owner
    def _collision_model(self, robot: Robot) -> "CollisionModel":
        from manipplan.collision.model import CollisionModel

        return CollisionModel.of(robot, self)

    def in_collision(self, robot: Robot, q: ArrayLike) -> bool | NDArray[np.bool_]:
        """Whether the robot touches an obstacle or itself at q (n,); a boolean array for q (..., n)."""
        model = self.collision_model(robot)
        batch = configurations("q", q, robot.n)
        hits = np.array([model.in_collision(each) for each in batch.reshape(-1, robot.n)], dtype=bool)
        return bool(hits[0]) if batch.ndim == 1 else hits.reshape(batch.shape[:-1])

    def distances(self, robot: Robot, q: ArrayLike) -> Array:
        """Signed distance of every pair [m], (k,) for q (n,), (..., k) for q (..., n); negative where they overlap.

        The pairs are in the order of `collision_model(robot).pair_names`.
        """
        model = self.collision_model(robot)
        batch = configurations("q", q, robot.n)
        rows = [model.distances(each) for each in batch.reshape(-1, robot.n)]
        return np.array(rows).reshape((*batch.shape[:-1], len(model.pair_names)))

    def path_clearance(
        self, robot: Robot, path: JointPath, *, clearance: float = 0.0, tolerance: float | None = 1e-3
    ) -> "PathClearance":
        """Proven bounds [m] on the robot's distance to the obstacles and to itself on the whole path, also between samples.

        Args:
            robot: the arm.
            path: a JointPath of its joints; for a Trajectory, `trajectory.path()`.
            clearance: required clearance [m], to which `proven` of the result refers.
            tolerance: maximum gap of the bounds [m], at least 1e-4; None: only as tight as needed to decide on `clearance`.

        Raises InvalidInputError when an argument is invalid.
        """
        from manipplan.collision.path_clearance import path_clearance

        return path_clearance(self.collision_model(robot), path, clearance=clearance, tolerance=tolerance)

    def __getstate__(self) -> dict[str, Any]:
        return state_without_memo(self)

    def __repr__(self) -> str:
        return f"Scene({', '.join(self.names)})"


def _obstacle(where: str, entry: object, folder: Path) -> Obstacle:
    if not isinstance(entry, dict) or "shape" not in entry:
        raise InvalidInputError(where, entry, f"a mapping with shape: one of {', '.join(OBSTACLES)}")
    if not isinstance(entry["shape"], str) or entry["shape"] not in OBSTACLES:
        raise UnknownNameError(f"{where}.shape", str(entry["shape"]), OBSTACLES)
    kind = OBSTACLES[entry["shape"]]
    options = {key: value for key, value in entry.items() if key != "shape"}
    known = [each.name for each in fields(kind) if each.init]
    for key in options:
        if key not in known:
            raise UnknownNameError(f"{where} ({kind.shape_name})", str(key), known)
    required = [each.name for each in fields(kind) if each.init and each.default is MISSING]
    for key in required:
        if key not in options:
            raise InvalidInputError(f"{where} ({kind.shape_name})", sorted(options), f"a mapping with {' and '.join(required)}")
    if "file" in options:
        options["file"] = folder / str(options["file"])
    try:
        return kind(**options)
    except InvalidInputError as error:
        raise InvalidInputError(f"{where} ({error.argument})", error.value, error.allowed) from error


def _hulls(argument: str, file: Path, scale: float) -> list[coal.CollisionGeometry]:
    """Convex hulls of the connected parts of a mesh file."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    fault = fault_of(file) if file.suffix.lower() == ".ply" else None
    if fault is not None:
        raise FileFormatError(argument, str(file), f"a mesh (STL, OBJ, DAE, ...); {fault}")
    try:
        mesh = coal.MeshLoader(coal.NODE_TYPE.BV_OBBRSS).load(str(file), np.full(3, scale))
    except (ValueError, RuntimeError) as error:
        reason = " ".join(str(error).split())[:160]
        raise FileFormatError(argument, str(file), f"a mesh (STL, OBJ, DAE, ...); the loader says: {reason}") from error
    if not (mesh.num_tris and np.isfinite(np.array(mesh.vertices())).all()):
        raise FileFormatError(argument, str(file), "a mesh of triangles with finite vertices")
    vertices, same = np.unique(np.array(mesh.vertices()).round(9), axis=0, return_inverse=True)
    faces = same[np.array([[t[0], t[1], t[2]] for t in map(mesh.tri_indices, range(mesh.num_tris))])]
    links = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]]])
    graph = coo_array((np.ones(len(links)), (links[:, 0], links[:, 1])), shape=(len(vertices),) * 2)
    count, part_of = connected_components(graph, directed=False)
    hulls = []
    for part in range(count):
        corners = vertices[part_of == part]
        if not has_hull(corners):
            wanted = f"a mesh whose parts have a volume, with corners within {FARTHEST:g} m; one part is flat or too far away"
            raise FileFormatError(argument, str(file), wanted)
        hulls.append(convex_hull(corners))
    return hulls
