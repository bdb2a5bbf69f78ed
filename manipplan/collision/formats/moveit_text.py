"""MoveIt's text format for scenes, `.scene`: objects with their shapes, poses and colours."""

import itertools
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pinocchio as pin

from manipplan.collision.formats.moveit_shapes import half_space, pose_of, triangles_of
from manipplan.collision.shapes import Box, Cylinder, Mesh, Obstacle, Sphere, check_obstacles
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

SHAPES = ("box", "sphere", "cylinder", "plane", "mesh")
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
        try:
            objects.append((name, _Words(where, lines[first + 1 : last]).shapes()))
        except (FileFormatError, UnknownNameError):
            raise
        except InvalidInputError as error:
            raise FileFormatError("file", f"{where}, {error.argument}: {error.value}", error.allowed) from error
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
        place = self._pose() if self.posed else pin.SE3.Identity()
        shapes = []
        for _ in range(self._count("the number of shapes", least=1)):
            shape, pose = self._shape(), self._pose()
            self._numbers("a colour", COLOUR)
            shapes.append(shape.at(place * pose))
        for _ in range(self._count("the number of subframes") if self.posed else 0):
            self._word("the name of a subframe")
            self._pose()
        if self.at < len(self.words):
            raise self._error("the next object", self.words[self.at])
        return shapes

    def _shape(self) -> Obstacle:
        kind = self._word("a shape").lower()
        if kind == "box":
            return Box(size=self._numbers("a box", 3))
        if kind == "sphere":
            return Sphere(radius=self._numbers("a sphere", 1)[0])
        if kind == "cylinder":
            radius, length = self._numbers("a cylinder", 2)
            return Cylinder(radius=radius, length=length)
        if kind == "plane":
            return half_space("plane", self._numbers("a plane", 4))
        if kind == "mesh":
            counts = self._count("the number of vertices", least=3), self._count("the number of triangles", least=1)
            vertices = self._numbers("vertices", 3 * counts[0]).reshape(-1, 3)
            corners = self._numbers("triangles", 3 * counts[1])
            return Mesh(triangles=triangles_of("triangles", vertices, corners.reshape(-1, 3)))
        raise UnknownNameError(self.where, kind, SHAPES)

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
