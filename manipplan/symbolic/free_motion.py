"""FreeMotion: the motions of the tool that a task leaves free at a pose, so that a whole set of poses counts as that pose.

BoundedMotion: those of a task whose poses count within a region.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.task import PoseRegion, Task

#: Cosines and lengths below this are 0.
SMALL = 1e-9
#: Cosine of an angle of rotation from which on the skew part of the matrix does not tell the axis well.
HALF_TURN = -0.99


class Turns(Enum):
    """The free rotations of the tool."""

    NONE = ()
    TOOL_AXIS = ("tool rotation",)
    WORLD_AXIS = ("rotation",)
    ANY = ("azimuth", "tilt", "tool rotation")


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class FreeMotion:
    """The shifts and rotations that a task leaves free: `poses` and `values` are the set of poses that they give, and back.

    A free rotation is about the tool's origin. Values of it are angles [rad]: from the pose to the tool about one axis, or from
    the world to the tool as the Euler angles ZYZ. Values of shifts are [m]: coordinates of the origin in the world along their
    directions, or shifts from the pose along the tool's.

    Attributes:
        shifts: (k, 3) orthonormal directions of free shifts.
        in_tool: whether these are directions of the tool at the pose; otherwise of the world.
        turns: the free rotations.
        axis: (3,) unit vector, the axis of the free rotation, in the tool or in the world; zeros where there is not one.
    """

    shifts: Array
    in_tool: bool
    turns: Turns
    axis: Array

    @classmethod
    def of(cls, task: Task, *, planar: bool = False) -> "FreeMotion":
        """What a task leaves free. Raises InvalidInputError for a task whose rows do not fix a set of poses.

        `planar`: whether the arm moves its tool in the x-y plane, turning it about z, only.
        """
        if task.region is not None:
            return BoundedMotion.about(task.region, planar=planar)
        world, tool = task.matrices
        for rows in (world, tool):
            if (rows[:, :3].any(axis=1) & rows[:, 3:].any(axis=1)).any():
                raise InvalidInputError("task", task.name, "rows that are each a direction or an axis, for poses of a path")
        if planar and tool[:, :3].any():
            raise InvalidInputError("task", task.name, "directions of the world, for a planar arm")
        if planar:  # the arm itself fixes z and the tilt
            turns_fixed = bool(world[:, 5].any() or tool[:, 5].any())
            shifts, in_tool = _free_directions(task, np.vstack([world[:, :3], np.eye(3)[2]]), tool[:, :3])
            turns, axis = (Turns.NONE, np.zeros(3)) if turns_fixed else (Turns.TOOL_AXIS, np.eye(3)[2])
        else:
            shifts, in_tool = _free_directions(task, world[:, :3], tool[:, :3])
            turns, axis = _free_rotations(task, world[:, 3:], tool[:, 3:])
        if in_tool and not (turns is Turns.NONE or (turns is Turns.TOOL_AXIS and _is_kept(shifts, axis))):
            wanted = (
                "shifts that are free along the tool axis about which it turns freely, all across it, or in the world, as of "
                "Task.custom([[1, 0, 0, 0, 0, 0]], frame='world', name='x')"
            )
            raise InvalidInputError("task", task.name, wanted)
        return cls(shifts=shifts, in_tool=in_tool, turns=turns, axis=axis)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the values."""
        return (*(f"shift along ({', '.join(f'{x:.3g}' for x in each)})" for each in self.shifts), *self.turns.value)

    @property
    def only_axis(self) -> Array | None:
        """The tool axis (3,) where a rotation about it is all that is free."""
        return self.axis if self.turns is Turns.TOOL_AXIS and not len(self.shifts) else None

    @property
    def fixed_directions(self) -> Array:
        """Orthonormal directions (3 - k, 3) along which the tool's position is fixed."""
        return complement(self.shifts)

    def line(self, value: int, count: int, centre: Array, radius: float, poses: Array) -> Array:
        """A grid (count,) of the value of an index: around the circle, evenly over the sphere, or over where the tool can be.

        For at least one of poses (k, 4, 4) a shift is inside the ball (3,) [m] that holds every place of the tool.
        """
        if value >= len(self.shifts):
            if self.turns is Turns.ANY and value == len(self.shifts) + 1:
                return np.arccos(1.0 - (2.0 * np.arange(count) + 1.0) / count)
            return -np.pi + 2 * np.pi * np.arange(count) / count
        away = centre - poses[:, :3, 3]
        if self.in_tool:
            away = _rotate(np.swapaxes(poses[:, :3, :3], 1, 2), away)
        half = np.sqrt(np.maximum(radius**2 - np.square(away @ self.fixed_directions.T).sum(axis=1), 0.0))
        middle = (away if self.in_tool else centre[None]) @ self.shifts[value]
        lower, upper = float((middle - half).min()), float((middle + half).max())
        return np.linspace(lower, upper, count) if count > 1 else np.array([(lower + upper) / 2])

    def values(self, reached: Array, poses: Array) -> Array:
        """The values (k, f) of tool poses reached (k, 4, 4) that count as poses (k, 4, 4)."""
        have, want = reached[:, :3, :3], poses[:, :3, :3]
        there = reached[:, :3, 3]
        if self.in_tool:
            there = _rotate(np.swapaxes(want, 1, 2), there - poses[:, :3, 3])
        columns = [there @ self.shifts.T]
        if self.turns is Turns.TOOL_AXIS:
            columns.append((rotation_vectors(np.swapaxes(want, 1, 2) @ have) @ self.axis)[:, None])
        elif self.turns is Turns.WORLD_AXIS:
            columns.append((rotation_vectors(have @ np.swapaxes(want, 1, 2)) @ self.axis)[:, None])
        elif self.turns is Turns.ANY:
            columns.append(_euler(have))
        return np.hstack(columns)

    def poses(self, poses: Array, values: Array) -> Array:
        """The poses (k, 4, 4) with values (k, f) that count as poses (k, 4, 4)."""
        from scipy.spatial.transform import Rotation

        moved, count = poses.copy(), len(self.shifts)
        shift, angles = values[:, :count], values[:, count:]
        if self.in_tool:
            moved[:, :3, 3] += _rotate(poses[:, :3, :3], shift @ self.shifts)
        else:
            moved[:, :3, 3] += (shift - poses[:, :3, 3] @ self.shifts.T) @ self.shifts
        if self.turns is Turns.TOOL_AXIS:
            moved[:, :3, :3] = poses[:, :3, :3] @ rotations_of(angles * self.axis)
        elif self.turns is Turns.WORLD_AXIS:
            moved[:, :3, :3] = rotations_of(angles * self.axis) @ poses[:, :3, :3]
        elif self.turns is Turns.ANY:
            moved[:, :3, :3] = Rotation.from_euler("ZYZ", angles).as_matrix()
        return moved

    def nearest(self, reached: Array, poses: Array) -> Array:
        """The poses (k, 4, 4) that count as `poses` and are near tool poses reached (k, 4, 4)."""
        return self.poses(poses, self.values(reached, poses)) if self.names else poses

    @property
    def bounds(self) -> Array | None:
        """Largest values (f,); None: there are none."""
        return None

    def fixed_rows(self, poses: Array) -> Array:
        """Rows (k, r, 6) that count of a small displacement in the world, position and then rotation, at poses (k, 4, 4)."""
        own, turned = np.broadcast_to(np.eye(3), (len(poses), 3, 3)), np.swapaxes(poses[:, :3, :3], 1, 2)
        position = self.fixed_directions @ (turned if self.in_tool else own)
        if self.turns is Turns.ANY:
            return np.concatenate([position, np.zeros_like(position)], axis=2)
        across = np.eye(3) if self.turns is Turns.NONE else complement(self.axis[None])
        rotation = across @ (turned if self.turns is Turns.TOOL_AXIS else own)
        return np.concatenate(
            [np.concatenate([position, np.zeros_like(position)], 2), np.concatenate([np.zeros_like(rotation), rotation], 2)], 1
        )

    def offsets(self, displacements: Array, rotations: Array) -> Array:
        """What counts of displacements (k, 3) [m] from poses with rotations (k, 3, 3)."""
        if not len(self.shifts):
            return displacements
        own = _rotate(np.swapaxes(rotations, 1, 2), displacements) if self.in_tool else displacements
        fixed = self.fixed_directions
        counts = own @ fixed.T @ fixed
        return _rotate(rotations, counts) if self.in_tool else counts

    def directions(self, rotations: Array) -> Array:
        """What counts of rotations (..., 3, 3), as vectors (..., d) that are equal where the rotations count as equal."""
        if self.turns is Turns.NONE:
            return rotations.reshape(*rotations.shape[:-2], 9)
        if self.turns is Turns.TOOL_AXIS:
            return np.asarray(rotations @ self.axis)
        if self.turns is Turns.WORLD_AXIS:
            return np.asarray(np.swapaxes(rotations, -2, -1) @ self.axis)
        return np.zeros((*rotations.shape[:-2], 1))


#: Names of the coordinates of a bounded motion: of a box, and of a cone.
BOX = ("shift along x", "shift along y", "shift along z", "turn about x", "turn about y", "turn about z")
CONE = (*BOX[:3], "first tilt", "second tilt", "spin")


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class BoundedMotion(FreeMotion):
    """The shifts and rotations inside a region. Values are those of its six coordinates that are not 0.

    The coordinates are shifts along the axes of the frame [m] and, of a box, the rotation vector about them [rad]; of a cone,
    the two components of the rotation vector across the tool axis that tilts it, and the turn about the axis before that.

    Attributes:
        region: see there.
        widths: (6,) largest coordinates [m, rad].
    """

    region: PoseRegion
    widths: Array

    @classmethod
    def about(cls, region: PoseRegion, *, planar: bool) -> "BoundedMotion":
        """The motions inside a region. Raises InvalidInputError for what an arm in the plane cannot do."""
        turns = region.rotation if region.cone is None else (region.cone, region.cone, region.spin)
        widths = np.array([*region.position, *turns])
        if planar and region.cone is not None:
            raise InvalidInputError("region", region, "no cone, for a planar arm: rotation=(0, 0, ...)")
        if planar:
            widths[2:5] = 0.0
        return cls(
            shifts=np.eye(3)[widths[:3] > 0],
            in_tool=region.frame == "tool",
            turns=Turns.ANY if widths[3:].any() else Turns.NONE,
            axis=np.zeros(3),
            region=region,
            widths=widths,
        )

    @property
    def names(self) -> tuple[str, ...]:
        names = BOX if self.region.cone is None else CONE
        return tuple(name for name, width in zip(names, self.widths, strict=True) if width > 0)

    @property
    def only_axis(self) -> None:
        return None

    @property
    def bounds(self) -> Array:
        return self.widths[self.widths > 0]

    def values(self, reached: Array, poses: Array) -> Array:
        return self.coordinates(reached, poses)[:, self.widths > 0]

    def poses(self, poses: Array, values: Array) -> Array:
        """As `FreeMotion.poses`; values outside the region are taken to its boundary."""
        region, moved, every = self.region, poses.copy(), np.zeros((len(values), 6))
        every[:, self.widths > 0] = np.clip(values, -self.bounds, self.bounds)
        rotations = rotations_of(every[:, 3:])
        if region.cone is not None:
            tilts = every[:, 3:5]
            tilts *= np.minimum(region.cone / np.maximum(np.linalg.norm(tilts, axis=1), 1e-300), 1.0)[:, None]
            rotations = rotations_of(tilts @ complement(self._axis[None])) @ rotations_of(every[:, 5:] * self._axis)
        if self.in_tool:
            moved[:, :3, 3] += _rotate(poses[:, :3, :3], every[:, :3])
            moved[:, :3, :3] = poses[:, :3, :3] @ rotations
        else:
            moved[:, :3, 3] += every[:, :3]
            moved[:, :3, :3] = rotations @ poses[:, :3, :3]
        return moved

    def coordinates(self, reached: Array, poses: Array) -> Array:
        """All coordinates (k, 6) of tool poses reached (k, 4, 4) from poses (k, 4, 4)."""
        moved, turned = self._displacement(reached, poses)
        if self.region.cone is None:
            return np.hstack([moved, rotation_vectors(turned)])
        tilts = tilts_of(turned @ self._axis, self._axis)
        spins = rotation_vectors(np.swapaxes(rotations_of(tilts), 1, 2) @ turned) @ self._axis
        return np.hstack([moved, tilts @ complement(self._axis[None]).T, spins[:, None]])

    def _displacement(self, reached: Array, poses: Array) -> tuple[Array, Array]:
        """Shifts (k, 3) and rotations (k, 3, 3) from poses to tool poses reached (k, 4, 4), in the frame of the region."""
        back, moved = np.swapaxes(poses[:, :3, :3], 1, 2), reached[:, :3, 3] - poses[:, :3, 3]
        if self.in_tool:
            return _rotate(back, moved), back @ reached[:, :3, :3]
        return moved, reached[:, :3, :3] @ back

    def excess(self, reached: Array, poses: Array) -> tuple[Array, Array]:
        """How far tool poses reached (k, 4, 4) are outside the regions about poses (k, 4, 4): [m] and [rad], (k,) each.

        Of a box it is the length of what is beyond it of the shift, or of the rotation vector; of a cone what tilt or spin
        exceed, the larger.
        """
        moved, turned = self._displacement(reached, poses)
        position = np.linalg.norm(np.maximum(np.abs(moved) - self.widths[:3], 0.0), axis=1)
        if self.region.cone is not None:
            there = turned @ self._axis
            tilt = np.arctan2(np.linalg.norm(np.cross(self._axis, there), axis=1), there @ self._axis)
            spin = 2 * np.abs(np.arctan2(_skew(turned) @ self._axis, 1 + np.trace(turned, axis1=1, axis2=2)))
            return position, np.maximum(np.maximum(tilt - self.region.cone, spin - self.region.spin), 0.0)
        return position, np.linalg.norm(np.maximum(np.abs(rotation_vectors(turned)) - self.widths[3:], 0.0), axis=1)

    def fixed_rows(self, poses: Array) -> Array:
        """All six rows: what is missing to the nearest pose of the region counts."""
        return np.broadcast_to(np.eye(6), (len(poses), 6, 6))

    def spread(self, count: int) -> Array:
        """Values (count, f) that are spread over the region, some of them on its boundary."""
        bounds = self.bounds
        if len(bounds) == 1:
            return np.linspace(-bounds, bounds, count) if count > 1 else np.zeros((1, 1))
        # the additive sequence of the generalised golden ratio: evenly spread in any number of dimensions
        ratio = 2.0
        for _ in range(60):
            ratio = (1.0 + ratio) ** (1.0 / (len(bounds) + 1))
        shares = (0.5 + np.arange(count)[:, None] * ratio ** -np.arange(1.0, len(bounds) + 1)) % 1.0
        return np.asarray(np.clip(WIDENED * (2 * shares - 1), -1.0, 1.0) * bounds)

    @property
    def _axis(self) -> Array:
        return np.array(self.region.axis)


#: How much farther than a region samples are spread before they are taken to its boundary.
WIDENED = 1.3


def tilts_of(directions: Array, axis: Array) -> Array:
    """The smallest rotation vectors (k, 3) that turn a unit vector `axis` (3,) to directions (k, 3)."""
    across = np.cross(axis, directions)
    sine = np.linalg.norm(across, axis=1)
    angle = np.arctan2(sine, directions @ axis)
    opposite = complement(axis[None])[0]
    unit = np.where((sine > SMALL)[:, None], across / np.maximum(sine, SMALL)[:, None], opposite)
    return np.asarray(unit * angle[:, None])


def complement(rows: Array) -> Array:
    """Orthonormal directions (3 - k, 3) across independent rows (k, 3)."""
    return np.asarray(np.linalg.svd(rows)[2][len(rows) :]) if len(rows) else np.eye(3)


#: Nothing is free: a pose is met as it is.
NOTHING = FreeMotion(shifts=np.zeros((0, 3)), in_tool=False, turns=Turns.NONE, axis=np.zeros(3))


def _is_kept(shifts: Array, axis: Array) -> bool:
    """Whether directions (k, 3) span the same after any turn about an axis (3,): its line, or the plane across it."""
    along = np.abs(shifts @ axis)
    return bool((len(shifts) == 1 and along[0] > 1 - SMALL) or (len(shifts) == 2 and (along < SMALL).all()))


def _free_directions(task: Task, world: Array, tool: Array) -> tuple[Array, bool]:
    """Directions (k, 3) of free shifts for rows of the world (i, 3) and of the tool (j, 3), and whether they are the tool's."""
    ranks = [int(np.linalg.matrix_rank(rows)) if len(rows) else 0 for rows in (world, tool)]
    if max(ranks) == 3:
        return np.zeros((0, 3)), False
    if min(ranks):
        raise InvalidInputError("task", task.name, "directions of the world or of the tool, not of both, for poses of a path")
    if not max(ranks):
        return np.eye(3), False
    directions = np.linalg.svd(world if ranks[0] else tool)[2][max(ranks) :]
    largest = np.take_along_axis(directions, np.abs(directions).argmax(axis=1)[:, None], axis=1)
    return directions * np.sign(largest), bool(ranks[1])


def _free_rotations(task: Task, world: Array, tool: Array) -> tuple[Turns, Array]:
    """Free rotations for rows of the world (i, 3) and of the tool (j, 3), and their axis (3,), zeros for none."""
    ranks = [int(np.linalg.matrix_rank(rows)) if len(rows) else 0 for rows in (world, tool)]
    if max(ranks) == 3:
        return Turns.NONE, np.zeros(3)
    if not max(ranks):
        return Turns.ANY, np.zeros(3)
    if min(ranks) or max(ranks) == 1:
        wanted = "rotations that are fixed, free, or free about one axis of the tool or of the world, for poses of a path"
        raise InvalidInputError("task", task.name, wanted)
    kind, rows = (Turns.WORLD_AXIS, world) if ranks[0] else (Turns.TOOL_AXIS, tool)
    first, second = rows[rows.any(axis=1)][:2]
    axis = np.linalg.svd(rows)[2][2]
    return kind, axis if axis @ np.cross(first, second) >= 0 else -axis


def rotation_vectors(rotations: Array) -> Array:
    """Rotation vectors (k, 3) of rotations (k, 3, 3), of at most half a turn."""
    cosine, skew = (np.trace(rotations, axis1=1, axis2=2) - 1) / 2, _skew(rotations)
    sine = np.linalg.norm(skew, axis=1) / 2
    vectors = skew * np.where(sine < SMALL, 0.5, np.arctan2(sine, cosine) / np.maximum(2 * sine, SMALL))[:, None]
    half_turn = cosine < HALF_TURN
    if half_turn.any():
        from scipy.spatial.transform import Rotation

        vectors[half_turn] = Rotation.from_matrix(rotations[half_turn]).as_rotvec()
    return vectors


def _skew(rotations: Array) -> Array:
    """2 sin(angle) times the axis of rotations (k, 3, 3), (k, 3)."""
    r = rotations
    return np.stack([r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]], axis=1)


def rotations_of(vectors: Array) -> Array:
    """Rotations (k, 3, 3) of rotation vectors (k, 3)."""
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_rotvec(vectors).as_matrix())


def _rotate(rotations: Array, vectors: Array) -> Array:
    """Rotations (k, 3, 3) applied to vectors (k, 3)."""
    return np.asarray((rotations @ vectors[:, :, None])[:, :, 0])


def _euler(rotations: Array) -> Array:
    """Euler angles ZYZ (k, 3) of rotations (k, 3, 3); where only their sum counts, the first is it."""
    r = rotations
    tilt = np.arctan2(np.hypot(r[:, 0, 2], r[:, 1, 2]), r[:, 2, 2])
    straight = np.sin(tilt) < SMALL
    azimuth = np.where(straight, np.arctan2(-r[:, 0, 1], r[:, 1, 1]), np.arctan2(r[:, 1, 2], r[:, 0, 2]))
    spin = np.where(straight, 0.0, np.arctan2(r[:, 2, 1], -r[:, 2, 0]))
    return np.stack([azimuth, tilt, spin], axis=1)
