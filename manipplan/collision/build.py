"""Build a collision model: the bodies of a robot and of a scene, and the pairs of them that are checked."""

from collections import Counter

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers.stored_fits import find_or_cut
from manipplan.collision.described import DescribedBodies
from manipplan.collision.model import CollisionModel
from manipplan.collision.primitives import mesh_triangles
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Part
from manipplan.robots.attached import number_names
from manipplan.robots.hulls import convex_hull
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, UnknownNameError
from manipplan.support.memo import once_per_owner

#: Number of random configurations. A pair that touches in at least the share ALWAYS of them is dropped: it touches by
#: construction.
SAMPLES = 200
ALWAYS = 0.95
#: Maximum share of the samples at which a pair's pieces touch while its meshes do not; above it the meshes are checked.
COARSE = 0.02
#: Distances above this need not be known to tell whether a pair touches [m].
TOUCHING = 1e-6


def build_model(robot: Robot, scene: Scene) -> CollisionModel:
    """The collision model of a robot among the obstacles of a scene, with convex pieces for the robot's meshes.

    An SRDF's disabled pairs, adjacent pairs, pairs that touch nearly everywhere and pairs that the scene allows are not
    checked; `dropped` of the model lists them.

    Raises:
        InvalidInputError: there are obstacles, but the robot's description has no collision geometry; or a name is both an
            obstacle's and that of a carried part or, in an allowed pair, of a link.
        UnknownNameError: an allowed pair names something that neither the scene nor the robot has.
    """
    alone, origins = _self_model(robot)
    geometry = alone.geometry.copy()
    if scene.obstacles and not alone.bodies:
        raise InvalidInputError("scene", repr(scene), f"no obstacles: {robot.name} has no collision geometry to check")
    check_names(robot, scene)
    dropped, radii, solids = dict(alone.dropped), dict[int, float](), set(alone.solids)
    named = {k: robot.link_of(robot.geometry.geometryObjects[origin]) for k, origin in enumerate(origins)}
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
        robot, geometry, dropped, bodies=alone.bodies, excess=alone.excess, radii=radii, solids=frozenset(solids)
    )


def check_names(robot: Robot, scene: Scene) -> None:
    """Raise an error where a name of the scene is unclear, or an allowed pair names nothing that is there."""
    for name in scene.names:
        if name in robot.carried:
            wanted = f"a scene without {name!r}, which {robot.name} carries: scene.without({name!r})"
            raise InvalidInputError("scene", repr(scene), wanted)
    links = [frame.name for frame in robot.model.frames if frame.type == pin.FrameType.BODY]
    known = [*scene.names, *robot.carried, *links]
    for name in sorted(frozenset[str]().union(*scene.allowed)):
        if name not in known:
            raise UnknownNameError("allowed", name, known)
        if name in scene.names and name in links:
            raise InvalidInputError(
                "allowed", name, f"another name for the obstacle {name!r}: a link of {robot.name} is called so"
            )


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
def _self_model(robot: Robot) -> tuple[CollisionModel, list[int]]:
    """The robot alone: its convex pieces and the pairs of its own bodies that are checked.

    Also the object of the robot's geometry that each object of the model represents.
    """
    geometry, origins, excess = _convex_geometry(robot)
    bodies = geometry.ngeoms
    dropped = add_self_pairs(robot, geometry, origins)
    samples = np.array([robot.neutral, *robot.random_configuration(np.random.default_rng(0), size=SAMPLES)])
    touching = _touching(robot, geometry, samples)
    solids = _use_meshes_for_coarse_pairs(robot, geometry, origins, samples, touching)
    if solids is not None:
        touching = _touching(robot, geometry, samples, solids)
    _drop_always_touching(robot, geometry, origins, dropped, touching)
    return CollisionModel(robot, geometry, dropped, bodies=bodies, excess=excess, solids=solids or ()), origins


def _convex_geometry(robot: Robot) -> tuple[pin.GeometryModel, list[int], dict[str, float]]:
    """The robot's geometry with convex pieces for its meshes, and the object of the description that each represents.

    Also by how much each piece is known to stick out of its mesh [m].
    """
    geometry = pin.GeometryModel()
    origins, excess = [], {}
    for origin, item in enumerate(robot.geometry.geometryObjects):
        shapes, out = [item.geometry], [0.0]
        if isinstance(item.geometry, coal.BVHModelBase):
            pieces = find_or_cut(mesh_triangles(item.geometry))
            shapes, out = [convex_hull(piece.corners) for piece in pieces], [piece.excess for piece in pieces]
        for name, shape, beyond in zip(number_names(item.name, len(shapes)), shapes, out, strict=True):
            geometry.addGeometryObject(pin.GeometryObject(name, item.parentJoint, item.parentFrame, item.placement, shape))
            origins.append(origin)
            excess[name] = beyond
    return geometry, origins, excess


def add_self_pairs(robot: Robot, geometry: pin.GeometryModel, origins: list[int]) -> dict[tuple[str, str], str]:
    """Add the pairs of different links to `geometry`, except adjacent and disabled ones; returns these, with the reason.

    `origins` gives the object of the robot's description that each object of `geometry` represents.
    """
    dropped: dict[tuple[str, str], str] = {}
    objects = list(geometry.geometryObjects)
    for j, second in enumerate(objects):
        for i, first in enumerate(objects[:j]):
            joints = (first.parentJoint, second.parentJoint)
            if joints[0] == joints[1]:
                continue
            if robot.disabled_pairs is not None:
                links = frozenset(robot.link_of(robot.geometry.geometryObjects[origins[k]]) for k in (i, j))
                if links in robot.disabled_pairs:
                    dropped[first.name, second.name] = "disabled in the SRDF"
                    continue
            origin = frozenset(robot.geometry.geometryObjects[origins[k]].name for k in (i, j))
            if origin in robot.unchecked:
                dropped[first.name, second.name] = robot.unchecked[origin]
                continue
            geometry.addCollisionPair(pin.CollisionPair(j, i))
    return dropped


def _touching(
    robot: Robot, geometry: pin.GeometryModel, samples: Array, solids: frozenset[int] = frozenset()
) -> NDArray[np.bool_]:
    """Whether each pair touches at each of the samples (m, n); (m, k)."""
    return np.asarray(CollisionModel(robot, geometry, {}, solids=solids).distance_rows(samples, beyond=TOUCHING) <= 0)


def _use_meshes_for_coarse_pairs(
    robot: Robot, geometry: pin.GeometryModel, origins: list[int], samples: Array, touching: NDArray[np.bool_]
) -> frozenset[int] | None:
    """Check pairs with their meshes whose pieces are `touching` (m, k) at samples (m, n) where the meshes are not.

    Returns the objects of `geometry` that are surfaces and solid inside; None where no pair is replaced.
    """
    pairs = [(p.first, p.second) for p in geometry.collisionPairs]
    stands_for = [(origins[i], origins[j]) for i, j in pairs]
    rows = np.flatnonzero(touching.any(axis=1))
    suspects = list(dict.fromkeys(stands_for[k] for k in np.flatnonzero(touching.any(axis=0))))
    described = DescribedBodies(robot)
    checked = [pair for pair in suspects if any(described.has_triangles(origin) for origin in pair)]
    if not checked:
        return None
    exact, number, solids = described.model(checked)
    by_part = _touching(robot, exact, samples[rows], solids)
    coarse = Counter[tuple[int, int]]()
    for pair in checked:
        by_pieces = touching[rows][:, [each == pair for each in stands_for]].any(axis=1)
        wrong = by_pieces & ~by_part[:, number == checked.index(pair)].any(axis=1)
        coarse[pair] = int(wrong.sum()) + SAMPLES * int(wrong[rows == 0].any())  # one wrong contact in the neutral posture is enough
    replaced = {pair for pair, count in coarse.items() if count > COARSE * SAMPLES}
    if not replaced:
        return None
    added, filled = described.add_to(geometry, origins, sorted({origin for pair in replaced for origin in pair}))
    for first, second in sorted(replaced):
        for i in added[first]:
            for j in added[second]:
                geometry.addCollisionPair(pin.CollisionPair(i, j))
    for (i, j), origin_pair in zip(pairs, stands_for, strict=True):
        if origin_pair in replaced:
            geometry.removeCollisionPair(pin.CollisionPair(i, j))
    return filled


def _drop_always_touching(
    robot: Robot,
    geometry: pin.GeometryModel,
    origins: list[int],
    dropped: dict[tuple[str, str], str],
    touching: NDArray[np.bool_],
) -> None:
    """Drop pairs of links that are `touching` (m, k) nearly everywhere: they touch by construction, as at a shoulder."""
    counts = touching.sum(axis=0)
    for k, pair in enumerate([(p.first, p.second) for p in geometry.collisionPairs]):
        carried = robot.carried.keys() & {robot.link_of(robot.geometry.geometryObjects[origins[body]]) for body in pair}
        if counts[k] >= ALWAYS * len(touching) and not carried:
            geometry.removeCollisionPair(pin.CollisionPair(*pair))
            first, second = (geometry.geometryObjects[body].name for body in pair)
            dropped[first, second] = f"touching at {counts[k]} of {len(touching)} configurations"
