"""Scene: the obstacles around a robot, in code or from a file (YAML, MoveIt, MuJoCo)."""

import itertools
import os
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import MISSING, fields
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.shapes import OBSTACLES, Obstacle, check_obstacles, is_own
from manipplan.paths.joint import JointPath
from manipplan.robots.attached import number_names
from manipplan.robots.robot import Robot
from manipplan.robots.urdf_files import UrdfFiles
from manipplan.support.checks import (
    Array,
    ArrayLike,
    configurations,
    entries,
    existing_file,
    instance,
    one_of,
    path_of,
    pose_matrix,
)
from manipplan.support.display import Pictured
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError
from manipplan.support.files import write_bytes, write_text
from manipplan.support.memo import state_without_memo

if TYPE_CHECKING:
    from manipplan.collision.model import CollisionModel
    from manipplan.collision.path_clearance import PathClearance


#: Maximum number of points that are written into a scene file.
MOST_POINTS = 1000


class Scene(Pictured):
    """Static obstacles. An empty scene still checks a robot for self-collision.

    Attributes:
        obstacles: what was given.
        names: their names; an obstacle without one is numbered, such as `box0`.
        allowed: pairs of names, of obstacles, links or carried parts, that may touch and are not checked.
    """

    def __init__(self, obstacles: Sequence[Obstacle] = (), *, allowed: Iterable[Collection[str]] = ()) -> None:
        if not isinstance(obstacles, list | tuple):
            raise InvalidInputError("obstacles", obstacles, "a list of obstacles")
        check_obstacles("obstacles", len(obstacles))
        for obstacle in obstacles:
            if not isinstance(obstacle, Obstacle):
                raise InvalidInputError("obstacles", obstacle, f"a list of {', '.join(k.__name__ for k in OBSTACLES.values())}")
        taken = set[str]()
        for obstacle in obstacles:
            if obstacle.name in taken:
                raise InvalidInputError("obstacles", obstacle.name, "names that differ")
            taken |= {obstacle.name} - {""}
        names: list[str] = []
        for i, obstacle in enumerate(obstacles):
            if is_own(obstacle):
                obstacle.parts()  # raises where they are not usable
            kind = obstacle.shape_name or type(obstacle).__name__.lower()
            numbered = (f"{kind}{k}" for k in itertools.count(i))
            names.append(obstacle.name or next(name for name in numbered if name not in taken))
            taken.add(names[-1])
        self.obstacles = tuple(obstacles)
        self.names = tuple(names)
        self.allowed = _pairs(allowed)

    @classmethod
    def from_yaml(cls, file: str | Path) -> "Scene":
        """Read a scene: ``obstacles: [{shape: box, size: [1, 1, 0.1], position: [0, 0, -0.05], name: table}, ...]``.

        Shapes are box (size), sphere (radius), capsule and cylinder (radius, length), plane, mesh (file or triangles, scale,
        up, fill) and cloud (file or points, radius, spacing); each takes position, rotation (matrix, or roll-pitch-yaw [rad])
        and name. The path of a file is relative to the scene file. A second key, `allowed`, may hold pairs of names.

        Raises FileFormatError or InvalidInputError that names the obstacle, the key and what is allowed.
        """
        from manipplan.support.data_files import read_yaml

        path = existing_file("scene", file)
        data = read_yaml("scene", path)
        lists = isinstance(data, dict) and all(isinstance(value, list) for value in data.values())
        if not lists or "obstacles" not in data or not set(data) <= {"obstacles", "allowed"}:
            keys = f" with the keys {', '.join(map(str, data))}" if isinstance(data, dict) else ""
            wanted = "a list under the key obstacles and, where pairs may touch, a list of pairs of names under allowed"
            raise FileFormatError("scene", f"{path}{keys}", wanted)
        return cls.from_entries(data["obstacles"], path.parent, allowed=data.get("allowed", ()))

    @classmethod
    def from_moveit(cls, file: str | Path, *, packages: Mapping[str, str | Path] | None = None) -> "Scene":
        """Read a scene of MoveIt: its text format `.scene`, or the message PlanningScene as `.yaml`.

        Objects of several shapes become several obstacles, named `id.0`, `id.1`, ... A plane becomes the half-space behind it.
        Of the allowed collision matrix the pairs of an object and a link are taken.

        Args:
            file: the file; its frame is taken as the world.
            packages: the folder of each package that a mesh names as `package://name/...`.

        Raises:
            FileFormatError: the file is cut off or holds something else; the message names the object and the entry.
            UnknownNameError: a shape that this package does not have, such as a cone, or an unknown package.
        """
        from manipplan.collision.scene_files import read_planning_scene, read_scene_text

        path, folders = existing_file("file", file), UrdfFiles(packages={} if packages is None else packages).packages
        allowed: list[list[str]] = []
        if path.suffix.lower() in (".yaml", ".yml"):
            objects, allowed = read_planning_scene(path, folders)
        else:
            objects = read_scene_text(path)
        obstacles, parts = list[Obstacle](), dict[str, tuple[str, ...]]()
        for name, shapes in objects:
            if name in parts:
                raise FileFormatError("file", f"{path}, object {name}, twice", "objects with names that differ")
            parts[name] = number_names(name, len(shapes))
            obstacles += [shape.called(part) for part, shape in zip(parts[name], shapes, strict=True)]
        return cls(obstacles, allowed=[(part, other) for name, other in allowed for part in parts[name]])

    @classmethod
    def from_mjcf(cls, file: str | Path) -> "Scene":
        """The static bodies of a MuJoCo model: every colliding geom without a joint between it and the world.

        A plane, also a finite one, becomes the half-space below it. A mesh is what its triangles say, while MuJoCo takes its
        convex hull. Bodies that move are left out. If the file holds an arm,
        its base is static and becomes an obstacle: remove it with `scene.without`, or use a file without the arm.

        Raises:
            FileFormatError: MuJoCo cannot read the file.
            UnknownNameError: a static geom has a shape that this package does not have, such as an ellipsoid.
            MissingExtraError: MuJoCo is not installed.
        """
        from manipplan.collision.scene_files import read_static_bodies

        return cls(read_static_bodies(existing_file("file", file)))

    def to_yaml(self, file: str | Path) -> None:
        """Write the scene so that `from_yaml` reads it back.

        A cloud of more than 1,000 points that was not read from a file is written to one beside the scene, such as
        scene.cloud3.npy.
        """
        import yaml

        path = path_of("file", file).resolve()
        entries = self.entries()
        for k, entry in enumerate(entries):
            if len(entry.get("points", ())) > MOST_POINTS:
                entry["file"] = path.with_name(f"{path.stem}.cloud{k}.npy")
                points = np.array(entry.pop("points"))
                write_bytes(entry["file"], partial(np.save, arr=points))
            for key, value in entry.items():
                if isinstance(value, Path):
                    entry[key] = os.path.relpath(value, path.parent)
        data = {"obstacles": entries, **({"allowed": self.allowed_names()} if self.allowed else {})}
        write_text(file, yaml.safe_dump(data, sort_keys=False, default_flow_style=None))

    @classmethod
    def from_entries(
        cls, entries: Sequence[Any], folder: str | Path = ".", *, allowed: Iterable[Collection[str]] = ()
    ) -> "Scene":
        """The scene of `entries`, each a mapping as in a YAML file; paths of files are relative to `folder`."""
        if isinstance(entries, str | bytes) or not isinstance(entries, Sequence):
            raise InvalidInputError("entries", entries, "a list of mappings, as in a YAML file")
        check_obstacles("entries", len(entries))
        folder = path_of("folder", folder)
        return cls([_obstacle(f"obstacles[{i}]", entry, folder) for i, entry in enumerate(entries)], allowed=allowed)

    def entries(self) -> list[dict[str, Any]]:
        """Name, shape and numbers of every obstacle as plain values; a file as a Path.

        Raises InvalidInputError for an obstacle of a class that is not in this package.
        """
        entries = []
        for name, obstacle in zip(self.names, self.obstacles, strict=True):
            if OBSTACLES.get(obstacle.shape_name) is not type(obstacle):
                kinds = ", ".join(kind.__name__ for kind in OBSTACLES.values())
                got = f"{name}, a {type(obstacle).__name__}"
                raise InvalidInputError("obstacles", got, f"obstacles of the kinds {kinds}: a file stores no others")
            entry: dict[str, Any] = {"name": name, "shape": obstacle.shape_name}
            for each in fields(obstacle):
                value = getattr(obstacle, each.name)
                if each.name != "name" and value is not None and each.init:
                    entry[each.name] = value.tolist() if isinstance(value, np.ndarray) else value
            entries.append(entry)
        return entries

    def allowed_names(self) -> list[list[str]]:
        """The pairs of `allowed` in alphabetical order."""
        return sorted(sorted(pair) for pair in self.allowed)

    def at(self, pose: ArrayLike | pin.SE3) -> "Scene":
        """The scene moved as a whole by `pose`, (4, 4) or pin.SE3."""
        pose = pose_matrix("pose", pose)
        return Scene([obstacle.at(pose) for obstacle in self.obstacles], allowed=self.allowed)

    def __add__(self, other: "Scene") -> "Scene":
        """The obstacles and allowed pairs of both scenes; obstacles of `other` without a name are numbered anew.

        Raises InvalidInputError when a name of `other` is taken.
        """
        if not isinstance(other, Scene):
            return NotImplemented
        both = Scene([*self.named, *other.obstacles])
        now = dict(zip(other.names, both.names[len(self.names) :], strict=True))  # a numbered obstacle may get another number
        allowed = [[now.get(name, name) for name in pair] for pair in other.allowed]
        return Scene(both.obstacles, allowed=[*self.allowed, *allowed])

    def without(self, *names: str) -> "Scene":
        """The scene without the obstacles of these names, and without the allowed pairs that name them.

        Raises UnknownNameError for a name that no obstacle has; the nearest names are listed.
        """
        for name in names:
            one_of("names", name, self.names)
        left = [obstacle for obstacle in self.named if obstacle.name not in names]
        return Scene(left, allowed=[pair for pair in self.allowed if not pair & set(names)])

    @property
    def named(self) -> list[Obstacle]:
        """The obstacles, each with its name, also where the scene has numbered it."""
        return [obstacle.called(name) for name, obstacle in zip(self.names, self.obstacles, strict=True)]

    def allow(self, first: str, second: str) -> "Scene":
        """The scene with one more pair that may touch: names of obstacles, links or carried parts.

        The pair is not checked anywhere on a path, as in MoveIt's allowed collision matrix: meant for a carried part and the
        table from which it is lifted. A name that neither the scene nor the robot has raises UnknownNameError when the two
        are first checked against each other.
        """
        return Scene(self.obstacles, allowed=[*self.allowed, (first, second)])

    def collision_model(self, robot: Robot) -> "CollisionModel":
        """The collision model of the robot among these obstacles, built once."""
        from manipplan.collision.build import build_model

        return build_model(instance("robot", robot, Robot), self)

    def in_collision(self, robot: Robot, q: ArrayLike) -> bool | NDArray[np.bool_]:
        """Whether the robot touches an obstacle or itself at q (n,); a boolean array for q (..., n)."""
        model = self.collision_model(robot)
        batch = configurations("q", q, robot.n)
        if batch.ndim == 1:
            return model.in_collision(batch)
        return model.in_collision_rows(batch.reshape(-1, robot.n)).reshape(batch.shape[:-1])

    def distances(self, robot: Robot, q: ArrayLike) -> Array:
        """Signed distance of every pair [m], (k,) for q (n,), (..., k) for q (..., n); negative where they overlap.

        The pairs are in the order of `collision_model(robot).pair_names`.
        """
        model = self.collision_model(robot)
        batch = configurations("q", q, robot.n)
        rows = model.distance_rows(batch.reshape(-1, robot.n))
        return rows.reshape((*batch.shape[:-1], len(model.pair_names)))

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


def _pairs(allowed: Iterable[Collection[str]]) -> frozenset[frozenset[str]]:
    pairs = set()
    for pair in entries("allowed", allowed, "pairs of two different names"):
        names = entries("allowed", pair, "pairs of two different names")
        if len(names) != 2 or not all(isinstance(name, str) and name for name in names) or names[0] == names[1]:
            raise InvalidInputError("allowed", pair, "pairs of two different names")
        pairs.add(frozenset(names))
    return frozenset(pairs)


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
