"""Build a collision model: the bodies of a robot and of a scene, and the pairs of them that are checked."""

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers.stored_fits import find_or_choose, find_or_cut
from manipplan.collision.described import FINE, MESH, DescribedBodies
from manipplan.collision.model import CollisionModel
from manipplan.collision.primitives import mesh_triangles
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Part
from manipplan.robots.attached import number_names
from manipplan.robots.description import VISUAL_HINT
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.compiling.patience import logged_when_slow
from manipplan.support.errors import InvalidInputError, UnknownNameError
from manipplan.support.memo import once_per_owner

#: Number of random configurations. Two links that touch in at least the share ALWAYS of them are not checked: they touch by
#: construction.
SAMPLES = 200
ALWAYS = 0.95
#: Maximum share of the samples at which a pair's pieces touch while its meshes do not; above it the meshes are checked.
COARSE = 0.02
#: Distances above this need not be known to tell whether a pair touches [m].
TOUCHING = 1e-6


def build_model(robot: Robot, scene: Scene) -> CollisionModel:
    """The collision model of a robot among the obstacles of a scene, with convex pieces for the robot's meshes.

    Pairs of links that the description or an SRDF exempts, that touch nearly everywhere, or that the scene allows are not
    checked; `dropped` of the model lists them.

    Raises:
        InvalidInputError: there are obstacles, but the robot's description has no collision geometry; or a name is both an
            obstacle's and that of a carried part or, in an allowed pair, of a link.
        UnknownNameError: an allowed pair names something that neither the scene nor the robot has.
    """
    alone, _ = self_model(robot)
    geometry = alone.geometry.copy()
    if scene.obstacles and not alone.bodies:
        hint = f"; {VISUAL_HINT}" if robot.source is not None and robot.source.kind == "urdf" else ""
        raise InvalidInputError("scene", repr(scene), f"no obstacles: {robot.name} has no collision geometry to check{hint}")
    check_names(robot, scene)
    dropped, radii, solids = dict(alone.dropped), dict[int, float](), set(alone.solids)
    named = dict(enumerate(alone.links))
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        parts = obstacle.parts()
        for label, part in zip(number_names(name, len(parts)), parts, strict=True):
            index = geometry.addGeometryObject(pin.GeometryObject(label, 0, 0, obstacle.pose, part.shape))
            named[index] = name
            radii[index] = part.radius
            if part.closed and isinstance(part.shape, coal.BVHModelBase):
                solids.add(index)
            for body in range(alone.bodies):
                item = geometry.geometryObjects[body]
                if item.parentJoint > 0:
                    geometry.addCollisionPair(pin.CollisionPair(body, index))
                elif (
                    frozenset((named[body], name)) not in scene.allowed and (depth := _overlap(item, part, obstacle.pose)) >= 0
                ):
                    dropped[item.name, label] = f"neither moves; they overlap by {1e3 * depth:.2g} mm"
    _drop_allowed(scene, geometry, named, dropped)
    return CollisionModel(
        robot,
        geometry,
        dropped,
        bodies=alone.bodies,
        excess=alone.excess,
        radii=radii,
        solids=frozenset(solids),
        links=[named[k] for k in range(geometry.ngeoms)],
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


def _drop_allowed(
    scene: Scene, geometry: pin.GeometryModel, named: dict[int, str], dropped: dict[tuple[str, str], str]
) -> None:
    """Drop the pairs that the scene allows to touch; `named`: the link, part or obstacle of each object of `geometry`."""
    for first, second in [(pair.first, pair.second) for pair in geometry.collisionPairs]:
        if frozenset((named[first], named[second])) in scene.allowed:
            geometry.removeCollisionPair(pin.CollisionPair(first, second))
            pair = geometry.geometryObjects[first].name, geometry.geometryObjects[second].name
            dropped[pair] = "allowed in the scene"


def _overlap(body: pin.GeometryObject, part: Part, pose: pin.SE3) -> float:
    """How deep a body that does not move and a part of an obstacle overlap [m]; negative where they do not touch."""
    places = [coal.Transform3s(place.rotation, place.translation) for place in (body.placement, pose)]
    apart = coal.distance(body.geometry, places[0], part.shape, places[1], coal.DistanceRequest(), coal.DistanceResult())
    return part.radius - float(apart)


@once_per_owner
def self_model(robot: Robot) -> tuple[CollisionModel, list[int]]:
    """The robot alone: its convex pieces and the pairs of its own bodies that are checked.

    Also the object of the robot's geometry that each object of the model represents.
    """
    geometry, origins, excess = _convex_geometry(robot)
    bodies = geometry.ngeoms
    left_out = add_self_pairs(robot, geometry, origins)
    samples = np.array([robot.neutral, *robot.random_configuration(np.random.default_rng(0), size=SAMPLES)])
    touching = _touching(robot, geometry, samples)
    solids = _use_meshes_for_coarse_pairs(robot, geometry, origins, excess, samples, touching)
    if solids is not None:
        touching = _touching(robot, geometry, samples, solids)
    links = [robot.link_of(robot.geometry.geometryObjects[origin]) for origin in origins]
    contacts = _drop_always_touching(robot, geometry, links, left_out, touching)
    model = CollisionModel(
        robot,
        geometry,
        _by_links(geometry, links, left_out),
        bodies=bodies,
        excess=excess,
        solids=solids or (),
        links=links,
        contacts=contacts,
    )
    return model, origins


def _convex_geometry(robot: Robot) -> tuple[pin.GeometryModel, list[int], dict[str, float]]:
    """The robot's geometry with convex pieces for its meshes, and the object of the description that each represents.

    Also by how much each piece is known to stick out of its mesh [m].
    """
    geometry = pin.GeometryModel()
    origins, excess, total = [], {}, robot.geometry.ngeoms
    for origin, item in enumerate(robot.geometry.geometryObjects):
        shapes, out = [item.geometry], [0.0]
        if isinstance(item.geometry, coal.BVHModelBase):
            with logged_when_slow(f"convex pieces of the mesh of {item.name}, body {origin + 1} of {total}, once per machine"):
                pieces = find_or_cut(mesh_triangles(item.geometry))
            shapes, out = [piece.hull.shape() for piece in pieces], [piece.excess for piece in pieces]
        for name, shape, beyond in zip(number_names(item.name, len(shapes)), shapes, out, strict=True):
            geometry.addGeometryObject(pin.GeometryObject(name, item.parentJoint, item.parentFrame, item.placement, shape))
            origins.append(origin)
            excess[name] = beyond
    return geometry, origins, excess


def add_self_pairs(robot: Robot, geometry: pin.GeometryModel, origins: list[int]) -> dict[tuple[str, str], str]:
    """Add the pairs of bodies that can move relative to each other to `geometry`; returns those left out, with the reason.

    Left out are pairs that the description or the SRDF exempts. `origins` gives the object of the robot's description that each
    object of `geometry` represents.
    """
    left_out: dict[tuple[str, str], str] = {}
    objects, described = list(geometry.geometryObjects), list(robot.geometry.geometryObjects)
    links = [robot.link_of(described[origin]) for origin in origins]
    disabled = robot.disabled_pairs or frozenset()
    for j, second in enumerate(objects):
        for i, first in enumerate(objects[:j]):
            if first.parentJoint == second.parentJoint:
                continue
            reason = robot.unchecked.get(frozenset((described[origins[i]].name, described[origins[j]].name)))
            if frozenset((links[i], links[j])) in disabled:
                reason = "disabled in the SRDF"
            if reason is None:
                geometry.addCollisionPair(pin.CollisionPair(j, i))
            else:
                left_out[first.name, second.name] = reason
    return left_out


def _touching(
    robot: Robot, geometry: pin.GeometryModel, samples: Array, solids: frozenset[int] = frozenset()
) -> NDArray[np.bool_]:
    """Whether each pair touches at each of the samples (m, n); (m, k)."""
    return np.asarray(CollisionModel(robot, geometry, {}, solids=solids).distance_rows(samples, beyond=TOUCHING) <= 0)


def _use_meshes_for_coarse_pairs(
    robot: Robot,
    geometry: pin.GeometryModel,
    origins: list[int],
    excess: dict[str, float],
    samples: Array,
    touching: NDArray[np.bool_],
) -> frozenset[int] | None:
    """Check pairs with finer bodies whose pieces are `touching` (m, k) at samples (m, n) where the meshes are not.

    These are more pieces of one of the two, where that is enough, otherwise the meshes themselves. The bodies are added to
    `geometry`, `origins` and `excess`. Returns those that are surfaces and solid inside; None where no pair is replaced.
    """
    pairs = [(p.first, p.second) for p in geometry.collisionPairs]
    stands_for = [(origins[i], origins[j]) for i, j in pairs]
    described = DescribedBodies(robot)
    if not touching.any():
        return None
    chosen = find_or_choose(robot, samples, lambda: _levels(described, stands_for, samples, touching))
    if not chosen:
        return None
    added: dict[tuple[int, int], list[int]] = {}
    for pair, levels in sorted(chosen.items()):
        for each in zip(pair, levels, strict=True):
            if each not in added:
                added[each] = described.add_to(geometry, *each, excess)
                origins += [each[0]] * len(added[each])
        for i in added[pair[0], levels[0]]:
            for j in added[pair[1], levels[1]]:
                geometry.addCollisionPair(pin.CollisionPair(i, j))
    for (i, j), origin_pair in zip(pairs, stands_for, strict=True):
        if origin_pair in chosen:
            geometry.removeCollisionPair(pin.CollisionPair(i, j))
    return described.solids(added)


def _levels(
    described: DescribedBodies, stands_for: list[tuple[int, int]], samples: Array, touching: NDArray[np.bool_]
) -> dict[tuple[int, int], tuple[int, int]]:
    """How finely the two objects of each pair are taken whose pieces are too coarse.

    Args:
        described: the objects.
        stands_for: (k) the two objects that each pair of pieces represents.
        samples: (m, n) configurations.
        touching: (m, k) whether each pair of pieces touches there.
    """
    rows = np.flatnonzero(touching.any(axis=1))
    suspects = dict.fromkeys(stands_for[k] for k in np.flatnonzero(touching.any(axis=0)))
    chosen: dict[tuple[int, int], tuple[int, int]] = {}
    for pair in suspects:
        if not any(described.has_triangles(origin) for origin in pair):
            continue
        by_mesh = described.touching(pair, (MESH, MESH), samples[rows])
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
            by_pieces = described.touching(pair, levels, samples[rows])
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
    robot: Robot,
    geometry: pin.GeometryModel,
    links: list[str],
    left_out: dict[tuple[str, str], str],
    touching: NDArray[np.bool_],
) -> dict[frozenset[str], float]:
    """Drop pairs of links of which any pieces are `touching` (m, k) nearly everywhere: they touch by construction.

    Args:
        robot: parts that it carries, and walls and tables of its MJCF, are never dropped.
        geometry: the pairs.
        links: the link or part of each object of `geometry`.
        left_out: gets the pairs that are dropped.
        touching: whether each pair touches at each of m configurations.

    Returns the share of the configurations at which each two links touch that are checked, where there are any.
    """
    pairs = [(pair.first, pair.second) for pair in geometry.collisionPairs]
    anywhere: dict[frozenset[str], NDArray[np.bool_]] = {}
    never = robot.carried.keys() | robot.world_geoms
    for k in np.flatnonzero(touching.any(axis=0)):
        names = frozenset(links[body] for body in pairs[k])
        anywhere[names] = anywhere.get(names, np.zeros(len(touching), dtype=bool)) | touching[:, k]
    always = {
        names: f"touching at {rows.sum()} of {len(rows)} configurations"
        for names, rows in anywhere.items()
        if rows.sum() >= ALWAYS * len(rows) and not names & never
    }
    for first, second in pairs:
        reason = always.get(frozenset((links[first], links[second])))
        if reason is not None:
            geometry.removeCollisionPair(pin.CollisionPair(first, second))
            left_out[geometry.geometryObjects[second].name, geometry.geometryObjects[first].name] = reason
    return {names: float(rows.mean()) for names, rows in anywhere.items() if names not in always}


def _by_links(
    geometry: pin.GeometryModel, links: list[str], left_out: dict[tuple[str, str], str]
) -> dict[tuple[str, str], str]:
    """The pairs left out, as one pair of links where no bodies of these are checked, otherwise by the names of the bodies."""
    link = {item.name: name for item, name in zip(geometry.geometryObjects, links, strict=True)}
    checked = {frozenset((links[pair.first], links[pair.second])) for pair in geometry.collisionPairs}
    found: dict[tuple[str, str], str] = {}
    for (first, second), reason in left_out.items():
        if frozenset((link[first], link[second])) in checked:
            found[first, second] = reason
        elif (link[second], link[first]) not in found:
            found.setdefault((link[first], link[second]), reason)
    return found
