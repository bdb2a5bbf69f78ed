"""Convex pieces and capsules on disk, by the content of what they contain: both take seconds per arm, once per machine."""

import hashlib
import json
import logging
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision import covers, surfaces
from manipplan.collision.world import Primitive, mesh_key, mesh_triangles
from manipplan.robots import hulls
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.compiler import log_when_slow
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import private_folder, write_bytes
from manipplan.support.kernel_library import FOLDER
from manipplan.support.memo import content_key

log = logging.getLogger("manipplan")

#: Corners (v, 3) and faces (f, 3) of a body, and two numbers that say more.
_Stored = tuple[Array, NDArray[np.int64], float, float]


@dataclass(frozen=True, kw_only=True)
class FitChoice:
    """How a robot's own pairs are checked, as it takes long to find out.

    Attributes:
        levels: for two objects of the robot, by their numbers, how finely each is taken.
        touching: at how many of the configurations at which that was tried two links touch, where they do at any.
    """

    levels: Mapping[tuple[int, int], tuple[int, int]]
    touching: Mapping[frozenset[str], int]

    def plain(self) -> bytes:
        """The content of a file."""
        levels = [[*pair, *levels] for pair, levels in self.levels.items()]
        return json.dumps([levels, [[*sorted(links), count] for links, count in self.touching.items()]]).encode()

    @classmethod
    def of(cls, plain: bytes) -> "FitChoice":
        """What `plain` made a file of."""
        levels, touching = json.loads(plain)
        return cls(
            levels={(i, j): (first, second) for i, j, first, second in levels},
            touching={frozenset((first, second)): count for first, second, count in touching},
        )


def find_or_fit(triangles: Array) -> list[Primitive]:
    """The capsules of `fit_capsules`, read from the cache folder if an earlier process stored them.

    Raises ManipplanError as `fit_capsules` does.
    """

    def fit() -> bytes:
        return json.dumps([_plain(each) for each in covers.fit_capsules(triangles)]).encode()

    stored = _find_or_make("capsules", _key(np.ascontiguousarray(triangles).data), fit)
    return [_primitive(*entry) for entry in json.loads(stored)]


def find_or_cut(mesh: coal.BVHModelBase, name: str, most: int = covers.MOST_PIECES) -> list[covers.Piece]:
    """At most `most` pieces of `convex_pieces`, read from the cache folder if an earlier process stored them.

    When it takes long, the log says that it is the mesh of `name`.
    """

    def cut() -> bytes:
        with log_when_slow(f"convex pieces of the mesh of {name}, once per machine"):
            found = covers.convex_pieces(mesh_triangles(mesh), most)
        return _pack((piece.hull.corners, piece.hull.faces, piece.excess, 0.0) for piece in found)

    own = "" if most == covers.MOST_PIECES else f"_{most}"
    stored = _unpack(_find_or_make("pieces", f"{_key(mesh_key(mesh))}{own}", cut))
    return [covers.Piece(hull=hulls.Hull(corners=corners, faces=faces), excess=excess) for corners, faces, excess, _ in stored]


def find_or_split(mesh: coal.BVHModelBase, name: str) -> list[surfaces.MeshPart]:
    """The parts of the mesh of `name`, by `mesh_parts`, read from the cache folder if an earlier process stored them."""

    def split() -> bytes:
        found = surfaces.mesh_parts(name, mesh_triangles(mesh))
        return _pack((part.corners, part.faces, float(part.closed), float(part.convex)) for part in found)

    return [
        surfaces.MeshPart(corners=corners, faces=faces, closed=closed > 0, convex=convex > 0)
        for corners, faces, closed, convex in _unpack(_find_or_make("parts", _key(mesh_key(mesh)), split))
    ]


def find_or_choose(robot: Robot, samples: Array, choose: Callable[[], FitChoice]) -> FitChoice:
    """What `choose` tells of a robot's own pairs at samples (m, n), or what an earlier process has stored of it."""
    bodies = [
        (item.name, robot.link_of(item), item.parentJoint, item.placement.homogeneous, _content(item.geometry))
        for item in robot.geometry.geometryObjects
    ]
    parts = [_choice_sources(), robot.tree, samples, bodies, dict(robot.unchecked), robot.disabled_pairs]
    plain = _find_or_make("choices", content_key(parts)[:32], lambda: choose().plain())
    return FitChoice.of(plain)


def _content(shape: coal.CollisionGeometry) -> object:
    """What a shape is, for a key: the triangles of a mesh, since coal pickles far more of it."""
    return mesh_key(shape) if isinstance(shape, coal.BVHModelBase) else shape


@cache
def _choice_sources() -> bytes:
    """Digest of the sources that a choice depends on."""
    files = (Path(__file__).with_name("build.py"), FOLDER / "distances.c")
    return hashlib.sha256(b"".join([_sources(), *(file.read_bytes() for file in files)])).digest()


def _find_or_make(folder: str, name: str, make: Callable[[], bytes]) -> bytes:
    """What a file of the cache folder holds; where there is none, or it is not as it was written, it is made and stored."""
    try:
        file = private_folder() / folder / name
        file.parent.mkdir(mode=0o700, exist_ok=True)
        content = file.read_bytes() if file.exists() else b""
    except OSError as error:
        log.info("%s are not kept on disk: %s", folder, error)
        return make()
    if hashlib.sha256(content[32:]).digest() == content[:32]:
        return content[32:]
    plain = make()
    try:
        write_bytes(file, lambda stream: stream.write(hashlib.sha256(plain).digest() + plain))
    except InvalidInputError as error:
        log.info("%s are not kept on disk: %s", folder, error)
    return plain


def _pack(bodies: Iterable[_Stored]) -> bytes:
    """Bodies as the bytes of a file."""
    return b"".join(
        np.array([len(corners), len(faces), *values]).tobytes() + corners.tobytes() + faces.astype(float).tobytes()
        for corners, faces, *values in bodies
    )


def _unpack(content: bytes) -> list[_Stored]:
    """The bodies of a file."""
    found, numbers = [], np.frombuffer(content)
    while len(numbers):
        ends = np.cumsum([4, 3 * int(numbers[0]), 3 * int(numbers[1])])
        corners, faces = (numbers[start:end].reshape(-1, 3) for start, end in pairwise(ends))
        found.append((corners, faces.astype(np.int64), float(numbers[2]), float(numbers[3])))
        numbers = numbers[ends[2] :]
    return found


def _key(content: bytes | memoryview) -> str:
    """Hash of some content, of the sources of the fits and of the version of NumPy."""
    digest = hashlib.sha256(_sources())
    digest.update(content)
    return digest.hexdigest()[:32]


@cache
def _sources() -> bytes:
    """Digest of the sources of the fits and of the version of NumPy."""
    sources = b"".join(Path(str(module.__file__)).read_bytes() for module in (covers, surfaces, hulls))
    return hashlib.sha256(np.__version__.encode() + sources).digest()


def _plain(primitive: Primitive) -> list[Any]:
    """Radius and, of a capsule, length; pose and volume."""
    shape = primitive.shape
    sizes = [shape.radius] if isinstance(shape, coal.Sphere) else [shape.radius, 2 * shape.halfLength]
    return [sizes, primitive.placement.homogeneous.tolist(), primitive.volume]


def _primitive(sizes: list[float], pose: list[list[float]], volume: float) -> Primitive:
    """What `_plain` made these of."""
    kind = coal.Sphere if len(sizes) == 1 else coal.Capsule
    return Primitive(shape=kind(*sizes), placement=pin.SE3(np.array(pose)), volume=volume)
