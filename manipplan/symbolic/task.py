"""Task: which motions of the tool count, and the length that makes radians comparable with metres.

PoseRegion: the poses about a pose that count as that pose, in a box or a cone.
"""

from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from manipplan.support.checks import Array, ArrayLike, finite_array, number, number_array, one_of, text, unit_vector
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError


@one_line
@dataclass(frozen=True, kw_only=True)
class PoseRegion:
    """A box of positions about a pose, and a box of rotation vectors or a cone about a tool axis. Made by `Task.within`.

    Attributes:
        position: half widths of the box [m], 0 for none.
        rotation: half widths of the box of rotation vectors [rad], at most π.
        cone: largest angle between the tool axis and that of the pose [rad]; None: no cone.
        axis: unit vector, the tool axis.
        spin: with a cone, largest turn about that axis [rad]; π: any.
        frame: whose axes the boxes have: those of the pose, "tool", or of the "world".
    """

    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rotation: tuple[float, float, float] = (0.0, 0.0, 0.0)
    cone: float | None = None
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    spin: float = np.pi
    frame: str = "tool"

    def __post_init__(self) -> None:
        one_of("frame", self.frame, ("tool", "world"))
        for k in range(3):
            number(f"position[{k}]", self.position[k], least=0.0)
            number(f"rotation[{k}]", self.rotation[k], least=0.0, most=np.pi)
        number("spin", self.spin, least=0.0, most=np.pi)
        if self.cone is not None:
            number("cone", self.cone, above=0.0, most=np.pi)
            if any(self.rotation):
                raise InvalidInputError("rotation", self.rotation, "0 together with a cone, which has `spin` for its axis")
        elif self.spin != np.pi:
            raise InvalidInputError("spin", self.spin, "π without a cone; rotation=(0, 0, ...) bounds a turn about one axis")
        if self.cone is None and not any(self.position) and not any(self.rotation):
            raise InvalidInputError("region", "all 0", "a position, a rotation, or a cone")


Row = tuple[float, ...]


@one_line
@dataclass(frozen=True, kw_only=True)
class Task:
    """Rows of the tool's Jacobian; build one with `pose`, `position`, `orientation`, `planar`, `pointing`, `direction`,
    `rotation` or `custom`.

    A row is six numbers: a direction of the tool's origin, then an axis of rotation, which `length` multiplies.

    Attributes:
        name: name of the task in reports.
        world_rows: rows with directions and axes in the world frame; they come first in the Jacobian.
        tool_rows: rows whose directions and axes turn with the tool.
        length: characteristic length [m] that weights rotation; 1.0 leaves the raw Jacobian.
        relative_to: frame of the robot, such as another tool, in which the tool's motion counts; "world" then means that frame
            in the rows. None: the world.
        region: the poses that count as a pose of a path; None: those that the rows leave free. See `within`.
    """

    name: str
    world_rows: tuple[Row, ...] = ()
    tool_rows: tuple[Row, ...] = ()
    length: float = 1.0
    relative_to: str | None = None
    region: PoseRegion | None = None

    def __post_init__(self) -> None:
        text("name", self.name)
        number("length", self.length, above=0.0)
        if self.relative_to is not None and (not isinstance(self.relative_to, str) or not self.relative_to):
            raise InvalidInputError("relative_to", self.relative_to, "the name of a frame of the robot, or None for the world")
        given = [
            finite_array(name, rows, (None, 6)) if np.ndim(number_array(name, rows)) != 1 or len(rows) else np.empty((0, 6))
            for name, rows in (("world_rows", self.world_rows), ("tool_rows", self.tool_rows))
        ]
        if not any(map(len, given)):
            raise InvalidInputError("world_rows, tool_rows", (), "at least one row, each of six finite numbers")
        for name, rows in zip(("world_rows", "tool_rows"), given, strict=True):
            object.__setattr__(self, name, tuple(map(tuple, rows.tolist())))

    @classmethod
    def pose(cls, length: float = 0.5, *, relative_to: str | None = None) -> "Task":
        """Position and orientation, 6 rows; angular rows times `length` [m] > 0."""
        length = number("length", length, above=0.0)
        return cls(name="pose", world_rows=_LINEAR + _ANGULAR, length=length, relative_to=relative_to)

    @classmethod
    def position(cls, *, relative_to: str | None = None) -> "Task":
        """Position only, 3 rows."""
        return cls(name="position", world_rows=_LINEAR, relative_to=relative_to)

    @classmethod
    def orientation(cls, *, relative_to: str | None = None) -> "Task":
        """Orientation only, 3 rows."""
        return cls(name="orientation", world_rows=_ANGULAR, relative_to=relative_to)

    @classmethod
    def planar(cls, *, relative_to: str | None = None) -> "Task":
        """Position in the x-y plane, 2 rows: the task of the planar arm in [kth2012]."""
        return cls(name="planar", world_rows=_LINEAR[:2], relative_to=relative_to)

    @classmethod
    def pointing(cls, axis: ArrayLike = (0.0, 0.0, 1.0), length: float = 0.5, *, relative_to: str | None = None) -> "Task":
        """Position and direction of a tool axis (3,) given in the tool's frame, 5 rows: rotation about it is free."""
        _, _, basis = np.linalg.svd(unit_vector("axis", axis)[None, :])
        across = tuple((0.0, 0.0, 0.0, *(float(x) for x in row)) for row in basis[1:])
        length = number("length", length, above=0.0)
        return cls(name="pointing", world_rows=_LINEAR, tool_rows=across, length=length, relative_to=relative_to)

    @classmethod
    def direction(cls, axis: ArrayLike, frame: str = "world", *, relative_to: str | None = None) -> "Task":
        """Speed of the tool's origin along one axis (3,) of the "world" or of the "tool", 1 row."""
        rows = np.concatenate([unit_vector("axis", axis), np.zeros(3)])[None, :]
        return cls._rows("direction", rows, frame, 1.0, relative_to)

    @classmethod
    def rotation(cls, axis: ArrayLike, frame: str = "world", *, relative_to: str | None = None) -> "Task":
        """Angular speed of the tool about one axis (3,) of the "world" or of the "tool", 1 row."""
        rows = np.concatenate([np.zeros(3), unit_vector("axis", axis)])[None, :]
        return cls._rows("rotation", rows, frame, 1.0, relative_to)

    @classmethod
    def custom(
        cls, rows: ArrayLike, frame: str = "world", length: float = 1.0, name: str = "custom", *, relative_to: str | None = None
    ) -> "Task":
        """Any linearly independent rows (m, 6): a direction of the tool's origin, then an axis of rotation.

        Args:
            rows: directions and axes of `frame`; the last three columns are multiplied by `length`.
            frame: "world" or "tool".
            length: characteristic length [m] > 0.
            name: name of the task.
            relative_to: frame of the robot that takes the place of the world; None: the world.
        """
        matrix = finite_array("rows", rows, (None, 6))
        length = number("length", length, above=0.0)
        if not len(matrix) or np.linalg.matrix_rank(matrix * np.array([1.0] * 3 + [length] * 3)) < len(matrix):
            raise InvalidInputError("rows", matrix.tolist(), "1 to 6 linearly independent rows of six numbers")
        if not isinstance(name, str) or not name:
            raise InvalidInputError("name", name, "a name that is not empty")
        return cls._rows(name, matrix, frame, length, relative_to)

    @classmethod
    def _rows(cls, name: str, matrix: Array, frame: str, length: float, relative_to: str | None) -> "Task":
        one_of("frame", frame, ("world", "tool"))
        rows = tuple(tuple(float(x) for x in row) for row in matrix)
        return cls(
            name=name,
            world_rows=rows if frame == "world" else (),
            tool_rows=rows if frame == "tool" else (),
            length=length,
            relative_to=relative_to,
        )

    def within(
        self,
        *,
        position: ArrayLike = 0.0,
        rotation: ArrayLike = 0.0,
        cone: float | None = None,
        axis: ArrayLike = (0.0, 0.0, 1.0),
        spin: float = np.pi,
        frame: str = "tool",
    ) -> "Task":
        """The same rows, which define m, for poses in a region about each pose of a path.

        `follow`, `MoveAlong`, `sample_layers`, `inverse_kinematics` and `check` take any pose in the region for the pose
        itself: a search uses all of it. What the rows leave free is replaced by the region: Task.pointing(axis) within
        rotation=(0, 0, 0.5) turns the tool about its z-axis by at most 0.5 rad. A Controller and `improve` refuse a region.

        Args:
            position: largest shift along each axis [m], one number or (3,); 0: none.
            rotation: largest component about each axis of the rotation vector [rad], one number or (3,), at most π; 0: none.
            cone: largest angle between a tool axis and that of the pose [rad], at most π; not together with `rotation`.
            axis: (3,) that tool axis, in the tool's frame.
            spin: with `cone`, largest turn about that axis [rad]; π: any.
            frame: whose axes: those of the pose, "tool", or of the "world".

        Raises InvalidInputError for values that are negative, too large or all 0.
        """
        widths = []
        for name, value in (("position", position), ("rotation", rotation)):
            given = number_array(name, value)
            widths.append(np.full(3, number(name, given.item())) if given.ndim == 0 else finite_array(name, given, (3,)))
        region = PoseRegion(
            position=tuple(widths[0].tolist()),
            rotation=tuple(widths[1].tolist()),
            cone=cone,
            axis=tuple(unit_vector("axis", axis).tolist()),
            spin=spin,
            frame=frame,
        )
        return replace(self, region=region)

    @property
    def rows(self) -> int:
        """Number m of task rows."""
        return len(self.world_rows) + len(self.tool_rows)

    @property
    def matrices(self) -> tuple[Array, Array]:
        """The world's and the tool's rows, (k, 6) and (m - k, 6), with `length` multiplied in."""
        scale = np.array([1.0, 1.0, 1.0] + [self.length] * 3)
        world, tool = (np.array(rows).reshape(-1, 6) * scale for rows in (self.world_rows, self.tool_rows))
        return world, tool

    @property
    def metres(self) -> int:
        """Number of rows in metres; with length 1, angular rows count as dimensionless."""
        if self.length != 1.0:
            return self.rows
        return sum(any(row[:3]) for row in self.world_rows + self.tool_rows)

    @property
    def unit(self) -> str:
        """Unit of Yoshikawa's manipulability: one metre per row; with length 1, angular rows count as dimensionless."""
        return {0: "1", 1: "m"}.get(self.metres, f"m^{self.metres}")

    @property
    def turns_freely(self) -> bool:
        """Whether turning the base or tool frame leaves m unchanged: the linear and the angular rows are each all or none."""
        world, tool = self.matrices
        full = not (world[:, :3].any(1) & world[:, 3:].any(1)).any()
        for part in (world[:, :3], world[:, 3:]):
            full = full and np.linalg.matrix_rank(part) in (0, 3)
        return full and not tool[:, :3].any()

    @property
    def free_axis(self) -> Array | None:
        """The tool's unit axis (3,) about which it may turn, if the only angular rows are two tool rows; otherwise None."""
        if any(any(row[3:]) for row in self.world_rows):
            return None
        angular = np.array([row[3:] for row in self.tool_rows if any(row[3:])])
        if angular.shape != (2, 3) or np.linalg.matrix_rank(angular) < len(angular):
            return None
        axis = np.cross(*angular)
        return np.asarray(axis / np.linalg.norm(axis))

    def rows_of(self, jacobian: ca.SX, rotation: ca.SX) -> ca.SX:
        """The task's rows (m, n) of a (6, n) LOCAL_WORLD_ALIGNED Jacobian, for a tool with `rotation` (3, 3)."""
        world, tool = (ca.sparsify(ca.DM(matrix)) for matrix in self.matrices)
        if not self.tool_rows:
            return world @ jacobian
        turned = ca.vertcat(rotation.T @ jacobian[:3, :], rotation.T @ jacobian[3:, :])
        return ca.vertcat(world @ jacobian, tool @ turned)


_LINEAR: tuple[Row, ...] = tuple(tuple(row) for row in np.eye(6)[:3].tolist())
_ANGULAR: tuple[Row, ...] = tuple(tuple(row) for row in np.eye(6)[3:].tolist())
