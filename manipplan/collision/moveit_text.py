"""MoveIt's text format for scenes, `.scene`: objects with their shapes, poses and colours."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pinocchio as pin

from manipplan.collision.shapes import Box, Cylinder, Mesh, Obstacle, Sphere, half_space
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

SHAPES = ("box", "sphere", "cylinder", "plane", "mesh")
#: Number of values of a colour: red, green, blue, opacity.
COLOUR = 4


def read_scene_text(file: Path) -> list[tuple[str, list[Obstacle]]]:
    """Name and shapes of each object, posed in the world.

    Raises FileFormatError that names the object when the file is cut off or holds something else.
    """
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise FileFormatError("file", str(file), f"text in UTF-8 ({error})") from error
    starts = [k for k, line in enumerate(lines) if line.startswith("*")]
    ends = [k for k, line in enumerate(lines) if line.strip() == "."]
    if not ends or 0 in starts or any(k > ends[0] for k in starts):
        raise FileFormatError("file", str(file), "a scene of MoveIt: its name, objects that begin with *, and a last line .")
    objects = []
    for first, last in zip(starts, [*starts[1:], ends[0]], strict=True):
        name = lines[first][1:].strip()
        where = f"{file}, object {name}"
        try:
            objects.append((name, _Words(where, lines[first + 1 : last]).shapes()))
        except (FileFormatError, UnknownNameError):
            raise
        except InvalidInputError as error:  # such as a negative radius
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
            return half_space(self._numbers("a plane", 4))
        if kind == "mesh":
            counts = self._count("the number of vertices", least=3), self._count("the number of triangles", least=1)
            vertices = self._numbers("vertices", 3 * counts[0]).reshape(-1, 3)
            corners = self._numbers("triangles", 3 * counts[1])
            if not np.isin(corners, np.arange(len(vertices))).all():
                raise self._error(f"vertices 0 to {len(vertices) - 1} in triangles", f"{corners.max():g}")
            return Mesh(triangles=vertices[corners.astype(int)].reshape(-1, 3, 3))
        raise UnknownNameError(self.where, kind, SHAPES)

    def _pose(self) -> pin.SE3:
        """Position and unit quaternion x, y, z, w."""
        values = self._numbers("a pose", 7)
        size = np.linalg.norm(values[3:])
        if not 0.99 < size < 1.01:
            raise self._error("a quaternion x y z w of length 1", " ".join(map(str, values[3:])))
        return pin.SE3(pin.Quaternion(values[3:] / size).matrix(), values[:3])

    def _count(self, wanted: str, least: int = 0) -> int:
        [value] = self._numbers(wanted, 1)
        if value != int(value) or not least <= value <= len(self.words):
            raise self._error(f"{wanted}, at least {least}", f"{value:g}")
        return int(value)

    def _numbers(self, wanted: str, count: int) -> Array:
        words = self.words[self.at : self.at + count]
        try:
            values = np.array([float(word) for word in words])
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
