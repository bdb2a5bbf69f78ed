"""Build a collision model: the bodies of a robot and of a scene, and the pairs of them that are checked.

The bodies of a robot as finely as a pair needs them: meshes as convex pieces, or as the solids and surfaces they are.
"""

import logging
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers import MOST_PIECES
from manipplan.collision.model import CollisionModel
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Part
from manipplan.collision.stored_fits import FitChoice, find_or_choose, find_or_cut, find_or_split
from manipplan.robots.attached import number_names
from manipplan.robots.description import VISUAL_HINT
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, UnknownNameError
from manipplan.support.memo import once_per_owner, once_per_pair

log = logging.getLogger("manipplan")

#: How finely a mesh is taken: by its triangles, or by at most this number of convex pieces, tried in turn.
MESH, FINE = 0, (12, 24, 48)
#: Distances above this need not be known to tell whether a pair touches [m].
TOUCHING = 1e-6
#: Total number of triangles of two meshes up to which they are compared as fast as pieces of them.
FEW_TRIANGLES = 100


class DescribedBodies:
    """The objects of a robot's geometry, each as finely as it is asked for.

    By its triangles a mesh has a part for each solid and one for all its open surfaces; convex solids are hulls.
    """

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.objects = list(robot.geometry.geometryObjects)
        self._parts: dict[tuple[int, int], list[tuple[coal.CollisionGeometry, bool, float]]] = {}

    def parts(self, origin: int, level: int) -> list[tuple[coal.CollisionGeometry, bool, float]]:
        """The shapes of an object; whether each is solid, and by how much it is known to stick out of the mesh [m]."""
        if (origin, level) not in self._parts:
            item = self.objects[origin]
            if not isinstance(item.geometry, coal.BVHModelBase):
                found = [(item.geometry, True, 0.0)]
            elif level == MESH:
                found = [(part.shape(), part.closed, 0.0) for part in find_or_split(item.geometry, item.name)]
            else:
                pieces = find_or_cut(item.geometry, f"{item.name}, body {origin + 1} of {len(self.objects)}", level)
                found = [(piece.hull.shape(), True, piece.excess) for piece in pieces]
            self._parts[origin, level] = found
        return self._parts[origin, level]

    def has_triangles(self, origin: int) -> bool:
        """Whether an object is no convex solid, so that convex pieces may stick out of it."""
        shapes = [shape for shape, _, _ in self.parts(origin, MESH)]
        return len(shapes) > 1 or any(isinstance(shape, coal.BVHModelBase) for shape in shapes)

    def finer(self, pair: tuple[int, int], many: int) -> Iterator[tuple[int, int]]:
        """Ways to take two objects by `many` pieces of one and few of the other, the fewest pairs first."""
        meshes = [k for k in (0, 1) if self.has_triangles(pair[k])]
        if sum(self.objects[pair[k]].geometry.num_tris for k in meshes) <= FEW_TRIANGLES:
            return
        meshes.sort(key=lambda k: -max(excess for _, _, excess in self.parts(pair[k], MOST_PIECES)))
        for few in (1, MOST_PIECES):
            for k in meshes:
                yield (many, few) if k == 0 else (few, many)

    def touching(self, pairs: Sequence[tuple[int, int]], levels: tuple[int, int], samples: Array) -> list[NDArray[np.bool_]]:
        """For each pair of objects, whether they touch, taken so finely, at samples (m, n); (m,)."""
        bodies, body_pairs, first = Bodies(self), list[tuple[int, int]](), list[int]()
        for pair in pairs:
            one, other = (bodies.numbers(*each) for each in zip(pair, levels, strict=True))
            first.append(len(body_pairs))
            body_pairs += [(i, j) for i in one for j in other]
        near = bodies.touching(np.array(body_pairs, dtype=np.int64).reshape(-1, 2), samples)
        return [np.asarray(near[:, start:end].any(axis=1)) for start, end in pairwise([*first, len(body_pairs)])]


class Bodies:
    """Objects of a robot's geometry, each added as finely as it is asked for, once.

    Attributes:
        geometry: the bodies, without pairs.
        origins: the number of the object that each body represents.
        excess: by how much each body is known to stick out of its object [m], by name.
        solids: the numbers of the bodies that are surfaces and solid inside.
    """

    def __init__(self, described: DescribedBodies) -> None:
        self._described = described
        self._numbers: dict[tuple[int, int], list[int]] = {}
        self.geometry = pin.GeometryModel()
        self.origins: list[int] = []
        self.excess: dict[str, float] = {}
        self.solids: set[int] = set()

    def numbers(self, origin: int, level: int) -> list[int]:
        """The numbers of the bodies that an object is taken as; those that are not there yet are added."""
        item = self._described.objects[origin]
        if not isinstance(item.geometry, coal.BVHModelBase):
            level = MOST_PIECES
        if (origin, level) not in self._numbers:
            parts = self._described.parts(origin, level)
            kind = "" if level == MOST_PIECES else ".mesh" if level == MESH else f".of{level}"
            added = self._numbers[origin, level] = []
            for name, (shape, closed, beyond) in zip(number_names(f"{item.name}{kind}", len(parts)), parts, strict=True):
                body = pin.GeometryObject(name, item.parentJoint, item.parentFrame, item.placement, shape)
                added.append(self.geometry.addGeometryObject(body))
                self.origins.append(origin)
                self.excess[name] = beyond
                if closed and isinstance(shape, coal.BVHModelBase):
                    self.solids.add(added[-1])
        return self._numbers[origin, level]

    def touching(self, pairs: NDArray[np.int64], samples: Array) -> NDArray[np.bool_]:
        """Whether each of pairs (k, 2) of bodies touches at each of the samples (m, n); (m, k)."""
        model = CollisionModel(self._described.robot, self.geometry, pairs, {}, solids=self.solids)
        return np.asarray(model.distance_rows(samples, beyond=TOUCHING) <= 0)


#: Number of random configurations. Two links that touch in at least the share ALWAYS of them are not checked: they touch by
#: construction.
SAMPLES = 200
ALWAYS = 0.95
#: Maximum share of the samples at which a pair's pieces touch while its meshes do not; above it the meshes are checked.
COARSE = 0.02


@once_per_pair
def build_model(robot: Robot, scene: Scene) -> CollisionModel:
    """The collision model of a robot among the obstacles of a scene, with convex pieces for the robot's meshes.

    Pairs of links that the description or an SRDF exempts, that touch nearly everywhere, or that the scene allows are not
    checked; `dropped` of the model lists them.

    Raises:
        InvalidInputError: there are obstacles, but the robot's description has no collision geometry; or a name is both an
            obstacle's and that of a carried part or, in an allowed pair, of a link.
        UnknownNameError: an allowed pair names something that neither the scene nor the robot has.
    """
    alone = self_model(robot)
    if scene.obstacles and not alone.bodies:
        hint = f"; {VISUAL_HINT}" if robot.source is not None and robot.source.kind == "urdf" else ""
        raise InvalidInputError("scene", repr(scene), f"no obstacles: {robot.name} has no collision geometry to check{hint}")
    check_names(robot, scene)
    geometry = alone.copy_of_bodies()
    dropped, radii, solids = dict(alone.dropped), dict[int, float](), set(alone.solids)
    links, pairs = list(alone.links), [alone.pairs]
    own = alone.objects[: alone.bodies]
    moves = np.array([item.parentJoint > 0 for item in own], dtype=bool)
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        parts = obstacle.parts()
        for label, part in zip(number_names(name, len(parts)), parts, strict=True):
            index = geometry.addGeometryObject(pin.GeometryObject(label, 0, 0, obstacle.pose, part.shape))
            links.append(name)
            radii[index] = part.radius
            if part.closed and isinstance(part.shape, coal.BVHModelBase):
                solids.add(index)
            pairs.append(np.column_stack([np.flatnonzero(moves), np.full(moves.sum(), index)]))
            for body in np.flatnonzero(~moves).tolist():
                if frozenset((links[body], name)) not in scene.allowed:
                    depth = _overlap(own[body], part, obstacle.pose)
                    if depth >= 0:
                        dropped[own[body].name, label] = f"neither moves; they overlap by {1e3 * depth:.2g} mm"
    return CollisionModel(
        robot,
        geometry,
        _without_allowed(scene, geometry, links, np.concatenate(pairs), dropped),
        dropped,
        bodies=alone.bodies,
        excess=alone.excess,
        radii=radii,
        solids=frozenset(solids),
        links=links,
        contacts=alone.contacts,
    )


def check_names(robot: Robot, scene: Scene) -> None:
    """Raise an error where a name of the scene is unclear, or an allowed pair names nothing that is there."""
    for name in scene.names:
        if name in robot.carried:
            wanted = f"a scene without {name!r}, which {robot.name} carries: scene.without({name!r})"
            raise InvalidInputError("scene", repr(scene), wanted)
    links = [frame.name for frame in robot.model.frames if frame.type == pin.FrameType.BODY]
    known = [*scene.names, *robot.carried, *links, *robot.world_geoms]
    for name in sorted(frozenset[str]().union(*scene.allowed)):
        if name not in known:
            raise UnknownNameError(_pair_with(scene, name), name, known)
        if name in scene.names and name in links:
            raise InvalidInputError(
                _pair_with(scene, name), name, f"another name for the obstacle {name!r}: a link of {robot.name} is called so"
            )


def _pair_with(scene: Scene, name: str) -> str:
    """The first allowed pair with this name, for a message."""
    first, second = min(sorted(pair) for pair in scene.allowed if name in pair)
    return f"allowed pair {first} - {second}"


def _without_allowed(
    scene: Scene,
    geometry: pin.GeometryModel,
    links: Sequence[str],
    pairs: NDArray[np.int64],
    dropped: dict[tuple[str, str], str],
) -> NDArray[np.int64]:
    """The pairs (k, 2) without those that the scene allows to touch, which are added to `dropped`.

    `links` has the link, part or obstacle of each object of `geometry`.
    """
    if not scene.allowed:
        return pairs
    allowed = np.array([frozenset((links[i], links[j])) in scene.allowed for i, j in pairs.tolist()], dtype=bool)
    for first, second in pairs[allowed].tolist():
        pair = geometry.geometryObjects[first].name, geometry.geometryObjects[second].name
        dropped[pair] = "allowed in the scene"
    return np.asarray(pairs[~allowed])


def _overlap(body: pin.GeometryObject, part: Part, pose: pin.SE3) -> float:
    """How deep a body that does not move and a part of an obstacle overlap [m]; negative where they do not touch."""
    poses = [coal.Transform3s(placement.rotation, placement.translation) for placement in (body.placement, pose)]
    apart = coal.distance(body.geometry, poses[0], part.shape, poses[1], coal.DistanceRequest(), coal.DistanceResult())
    return part.radius - float(apart)


@once_per_owner
def self_model(robot: Robot) -> CollisionModel:
    """The robot alone: its convex pieces and the pairs of its own bodies that are checked."""
    described = DescribedBodies(robot)
    samples = np.array([robot.neutral, *robot.random_configuration(np.random.default_rng(0), size=SAMPLES)])
    choice = find_or_choose(robot, samples, lambda: _choose(described, samples))
    own = _own_bodies(described, choice.levels)
    left_out = dict(own.left_out)
    pairs, contacts = _drop_always_touching(robot, own, choice.touching, left_out)
    return CollisionModel(
        robot,
        own.bodies.geometry,
        pairs,
        _by_links(own, pairs, left_out),
        bodies=own.count,
        excess=own.bodies.excess,
        solids=frozenset(own.bodies.solids),
        links=own.links,
        contacts=contacts,
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class _OwnBodies:
    """A robot's bodies, as finely as its pairs need them, and the pairs that can move relative to each other.

    Attributes:
        count: number of those that are no finer than the others.
        links: the link or part of each body.
        pairs: (k, 2) numbers of the bodies of each pair that is checked.
        left_out: the pairs that the description or an SRDF exempts, with the reason.
    """

    bodies: Bodies
    count: int
    links: list[str]
    pairs: NDArray[np.int64]
    left_out: dict[tuple[str, str], str]

    @cached_property
    def names(self) -> list[frozenset[str]]:
        """The two links of each pair."""
        return [frozenset((self.links[i], self.links[j])) for i, j in self.pairs.tolist()]


def _own_bodies(described: DescribedBodies, levels: Mapping[tuple[int, int], tuple[int, int]]) -> _OwnBodies:
    """The bodies of a robot, where `levels` says how finely the two objects of some pairs are taken."""
    robot, bodies = described.robot, Bodies(described)
    total = len(described.objects)
    for origin in range(total):
        bodies.numbers(origin, MOST_PIECES)
    count = bodies.geometry.ngeoms
    pairs, left_out = self_pairs(robot, bodies.geometry, bodies.origins)
    if levels:
        finer = np.zeros((total, total), dtype=bool)
        finer[tuple(np.array(list(levels)).T)] = True
        added = [
            (i, j)
            for pair, (first, second) in sorted(levels.items())
            for i in bodies.numbers(pair[0], first)
            for j in bodies.numbers(pair[1], second)
        ]
        origins = np.array(bodies.origins)
        pairs = np.concatenate([pairs[~finer[tuple(origins[pairs].T)]], np.array(added)])
    names = [robot.link_of(item) for item in described.objects]
    return _OwnBodies(
        bodies=bodies, count=count, links=[names[origin] for origin in bodies.origins], pairs=pairs, left_out=left_out
    )


def self_pairs(
    robot: Robot, geometry: pin.GeometryModel, origins: Sequence[int]
) -> tuple[NDArray[np.int64], dict[tuple[str, str], str]]:
    """The pairs (k, 2) of bodies that can move relative to each other, and those left out, with the reason.

    Left out are pairs that the description or the SRDF exempts. `origins` gives the object of the robot's description that each
    object of `geometry` represents.
    """
    described = list(robot.geometry.geometryObjects)
    number = {item.name: k for k, item in enumerate(described)}
    reasons = [""]
    why = np.zeros((len(described), len(described)), dtype=np.int64)  # the reason for which two objects are not checked

    def exempt(first: NDArray[np.intp] | int, second: NDArray[np.intp] | int, reason: str) -> None:
        if reason not in reasons:
            reasons.append(reason)
        why[first, second] = why[second, first] = reasons.index(reason)

    for names, reason in robot.unchecked.items():
        if len(names) == 2 and names <= number.keys():
            one, other = (number[name] for name in names)
            exempt(one, other, reason)
    links = np.array([robot.link_of(item) for item in described], dtype=object)
    for names in robot.disabled_pairs or ():
        if len(names) == 2:
            first, second = (np.flatnonzero(links == name) for name in names)
            exempt(first[:, None], second, "disabled in the SRDF")
    objects, origin = list(geometry.geometryObjects), np.array(origins, dtype=np.int64)
    joint = np.array([item.parentJoint for item in objects])
    pairs = np.column_stack(np.tril_indices(len(objects), -1))
    pairs = pairs[joint[pairs[:, 0]] != joint[pairs[:, 1]]]
    reason_of = why[tuple(origin[pairs].T)]
    out = np.flatnonzero(reason_of)
    left_out = {
        (objects[i].name, objects[j].name): reasons[k]
        for (j, i), k in zip(pairs[out].tolist(), reason_of[out].tolist(), strict=True)
    }
    return pairs[reason_of == 0], left_out


def _choose(described: DescribedBodies, samples: Array) -> FitChoice:
    """How finely the objects of each pair are taken, and how often links touch then, by comparison at samples (m, n).

    Finer are pairs whose pieces touch where their meshes do not: there are more pieces of one of the two, where that is enough,
    otherwise the meshes themselves.
    """
    own = _own_bodies(described, {})
    touching = own.bodies.touching(own.pairs, samples)
    origins = own.bodies.origins
    levels = _levels(described, [(origins[i], origins[j]) for i, j in own.pairs.tolist()], samples, touching)
    if levels:
        own = _own_bodies(described, levels)
        touching = own.bodies.touching(own.pairs, samples)
    anywhere: dict[frozenset[str], NDArray[np.bool_]] = {}
    for k in np.flatnonzero(touching.any(axis=0)):
        anywhere[own.names[k]] = anywhere.get(own.names[k], np.zeros(len(touching), dtype=bool)) | touching[:, k]
    return FitChoice(levels=levels, touching={names: int(rows.sum()) for names, rows in anywhere.items()})


def _levels(
    described: DescribedBodies, stands_for: list[tuple[int, int]], samples: Array, touching: NDArray[np.bool_]
) -> dict[tuple[int, int], tuple[int, int]]:
    """How finely the two objects of each pair are taken whose pieces are too coarse.

    `stands_for` (k) has the objects of each pair of pieces, and `touching` (m, k) whether these touch at samples (m, n).
    """
    rows = np.flatnonzero(touching.any(axis=1))
    touch = dict.fromkeys(stands_for[k] for k in np.flatnonzero(touching.any(axis=0)))
    suspects = [pair for pair in touch if any(described.has_triangles(origin) for origin in pair)]
    chosen: dict[tuple[int, int], tuple[int, int]] = {}
    for pair, by_mesh in zip(suspects, described.touching(suspects, (MESH, MESH), samples[rows]), strict=True):
        by_pieces = np.asarray(touching[rows][:, [each == pair for each in stands_for]].any(axis=1))
        if _is_coarse(by_pieces, by_mesh, rows):
            chosen[pair] = _fine_enough(described, pair, samples, by_mesh, rows)
    return chosen


def _fine_enough(
    described: DescribedBodies, pair: tuple[int, int], samples: Array, by_mesh: NDArray[np.bool_], rows: NDArray[np.intp]
) -> tuple[int, int]:
    """By how many pieces to take two objects, or MESH for both where no number helps."""
    wrong = np.inf
    for many in FINE:
        least = np.inf
        for levels in described.finer(pair, many):
            [by_pieces] = described.touching([pair], levels, samples[rows])
            if not _is_coarse(by_pieces, by_mesh, rows):
                return levels
            least = min(least, int((by_pieces & ~by_mesh).sum()))
        if least > wrong / 2:  # twice as many pieces do not help
            break
        wrong = least
    return MESH, MESH


def _is_coarse(by_pieces: NDArray[np.bool_], by_mesh: NDArray[np.bool_], rows: NDArray[np.intp]) -> bool:
    """Whether pieces touch too often where meshes do not, at samples `rows`; in the neutral posture, row 0, once is."""
    wrong = by_pieces & ~by_mesh
    return bool(wrong.sum() > COARSE * SAMPLES or wrong[rows == 0].any())


def _drop_always_touching(
    robot: Robot, own: _OwnBodies, touching: Mapping[frozenset[str], int], left_out: dict[tuple[str, str], str]
) -> tuple[NDArray[np.int64], dict[frozenset[str], float]]:
    """The pairs (k, 2) without those of links that touch nearly everywhere, by construction, which are added to `left_out`.

    Parts that the robot carries, and walls and tables of its MJCF, stay. `touching` has the number of samples at which two
    links touch. Also returns the share of the samples at which each two links touch that are checked, where there are any.
    """
    total, never = SAMPLES + 1, robot.carried.keys() | robot.world_geoms
    always = {names for names, count in touching.items() if count >= ALWAYS * total and not names & never}
    if always:
        listed = "; ".join(sorted(" and ".join(sorted(names)) for names in always)[:12])
        log.info("%s: not checked, as they touch nearly everywhere (robot.self_collisions lists all): %s", robot.name, listed)
    objects = own.bodies.geometry.geometryObjects
    for (first, second), names in zip(own.pairs.tolist(), own.names, strict=True):
        if names in always:
            left_out[objects[second].name, objects[first].name] = f"touching at {touching[names]} of {total} configurations"
    kept = np.array([names not in always for names in own.names], dtype=bool)
    return own.pairs[kept], {names: count / total for names, count in touching.items() if names not in always}


def _by_links(own: _OwnBodies, pairs: NDArray[np.int64], left_out: dict[tuple[str, str], str]) -> dict[tuple[str, str], str]:
    """The pairs left out, as one pair of links where no bodies of these are checked, otherwise by the names of the bodies.

    `pairs` (k, 2) are those that are checked.
    """
    link = {item.name: name for item, name in zip(own.bodies.geometry.geometryObjects, own.links, strict=True)}
    number = {name: k for k, name in enumerate(dict.fromkeys(own.links))}
    of_body = np.array([number[name] for name in own.links], dtype=np.int64)
    checked = np.zeros((len(number), len(number)), dtype=bool)
    checked[tuple(of_body[pairs].T)] = True
    checked |= checked.T
    found: dict[tuple[str, str], str] = {}
    for (first, second), reason in left_out.items():
        if checked[number[link[first]], number[link[second]]]:
            found[first, second] = reason
        elif (link[second], link[first]) not in found:
            found.setdefault((link[first], link[second]), reason)
    return found
