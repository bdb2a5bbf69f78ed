"""Build a collision model: the bodies of a robot and of a scene, and the pairs of them that are checked."""

from collections import Counter
from collections.abc import Callable

import coal
import numpy as np
import pinocchio as pin

from manipplan.collision.model import CollisionModel
from manipplan.collision.primitives import mesh_triangles
from manipplan.collision.scene import Scene
from manipplan.collision.stored_fits import find_or_fit
from manipplan.robots.attached import number_names
from manipplan.robots.hulls import has_hull
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, UnknownNameError
from manipplan.support.memo import once_per_owner

#: Number of random configurations. A pair that touches in at least the share ALWAYS of them is dropped: it touches by
#: construction.
SAMPLES = 200
ALWAYS = 0.95
#: Maximum share of the samples at which a pair's primitives touch while its meshes do not. Above it the pair is checked with
#: convex hulls and, when these are too coarse as well, with its meshes.
COARSE = 0.02


def build_model(robot: Robot, scene: Scene) -> CollisionModel:
    """The collision model of a robot among the obstacles of a scene, with primitives for the robot's meshes.

    An SRDF's disabled pairs, adjacent pairs, pairs that touch nearly everywhere and pairs that the scene allows are not
    checked; `dropped` of the model lists them.

    Raises:
        InvalidInputError: there are obstacles, but the robot's description has no collision geometry; or a name is both an
            obstacle's and that of a carried part or, in an allowed pair, of a link.
        UnknownNameError: an allowed pair names something that neither the scene nor the robot has.
    """
    alone, origins = _self_model(robot)
    geometry = alone.geometry.copy()
    bodies = list(range(alone.primitives))
    if scene.obstacles and not bodies:
        raise InvalidInputError("scene", repr(scene), f"no obstacles: {robot.name} has no collision geometry to check")
    check_names(robot, scene)
    named = {k: robot.link_of(robot.geometry.geometryObjects[origin]) for k, origin in enumerate(origins)}
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        shapes = obstacle.shapes()
        for label, shape in zip(number_names(name, len(shapes)), shapes, strict=True):
            index = geometry.addGeometryObject(pin.GeometryObject(label, 0, 0, obstacle.pose, shape))
            named[index] = name
            for body in bodies:
                if geometry.geometryObjects[body].parentJoint > 0:
                    geometry.addCollisionPair(pin.CollisionPair(body, index))
    dropped = dict(alone.dropped)
    _drop_allowed(scene, geometry, named, dropped)
    return CollisionModel(robot, geometry, dropped, alone.primitives)


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


@once_per_owner
def _self_model(robot: Robot) -> tuple[CollisionModel, list[int]]:
    """The robot alone: its primitives and the pairs of its own bodies that are checked.

    Also the object of the robot's geometry that each object of the model represents.
    """
    geometry, origins = _primitive_geometry(robot)
    primitives = geometry.ngeoms
    dropped = add_self_pairs(robot, geometry, origins)
    samples = [robot.neutral, *robot.random_configuration(np.random.default_rng(0), size=SAMPLES)]
    for tighter in (_hull, _mesh):
        _tighten_coarse_pairs(robot, geometry, origins, samples, tighter)
    _drop_always_touching(robot, geometry, origins, dropped, samples)
    return CollisionModel(robot, geometry, dropped, primitives), origins


def _primitive_geometry(robot: Robot) -> tuple[pin.GeometryModel, list[int]]:
    """The robot's geometry without meshes, and the object of the description that each primitive represents."""
    geometry = pin.GeometryModel()
    origins = []
    for origin, item in enumerate(robot.geometry.geometryObjects):
        if isinstance(item.geometry, coal.BVHModelBase):
            fitted = find_or_fit(mesh_triangles(item.geometry))
            shapes = [(primitive.shape, item.placement * primitive.placement) for primitive in fitted]
        else:
            shapes = [(item.geometry, item.placement)]
        for name, (shape, placement) in zip(number_names(item.name, len(shapes)), shapes, strict=True):
            geometry.addGeometryObject(pin.GeometryObject(name, item.parentJoint, item.parentFrame, placement, shape))
            origins.append(origin)
    return geometry, origins


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
            if origin in robot.adjacent_pairs:
                dropped[first.name, second.name] = "adjacent"
                continue
            geometry.addCollisionPair(pin.CollisionPair(j, i))
    return dropped


def _hull(item: pin.GeometryObject) -> pin.GeometryObject:
    if not isinstance(item.geometry, coal.BVHModelBase):
        return _renamed(item, item.geometry, "exact")
    if not has_hull(np.unique(np.array(item.geometry.vertices()), axis=0)):  # a flat mesh has no hull and is used as it is
        return _mesh(item)
    item.geometry.buildConvexHull(True, "Qt")
    return _renamed(item, item.geometry.convex, "hull")


def _mesh(item: pin.GeometryObject) -> pin.GeometryObject:
    return _renamed(item, item.geometry, "mesh")


def _renamed(item: pin.GeometryObject, shape: coal.CollisionGeometry, suffix: str) -> pin.GeometryObject:
    return pin.GeometryObject(f"{item.name}.{suffix}", item.parentJoint, item.parentFrame, item.placement, shape)


def _tighten_coarse_pairs(
    robot: Robot,
    geometry: pin.GeometryModel,
    origins: list[int],
    samples: list[Array],
    tighter: Callable[[pin.GeometryObject], pin.GeometryObject],
) -> None:
    """Use tighter shapes for pairs that touch at samples where the meshes that they represent do not."""
    pairs = [(p.first, p.second) for p in geometry.collisionPairs]
    stands_for = [(origins[i], origins[j]) for i, j in pairs]
    described = robot.geometry.copy()
    described_pairs = {pair: k for k, pair in enumerate(dict.fromkeys(stands_for))}
    for i, j in described_pairs:
        described.addCollisionPair(pin.CollisionPair(i, j))
    model = CollisionModel(robot, geometry, {})
    data, described_data = robot.model.createData(), pin.GeometryData(described)
    coarse = Counter[tuple[int, int]]()
    for number, q in enumerate(samples):
        touching = {stands_for[k] for k in model.touching_pairs(q)}
        pin.updateGeometryPlacements(robot.model, data, described, described_data, q)
        for pair in touching:
            if not pin.computeCollision(described, described_data, described_pairs[pair]):
                coarse[pair] += SAMPLES if number == 0 else 1  # one wrong contact in the neutral posture is enough
    replaced = {pair for pair, count in coarse.items() if count > COARSE * SAMPLES}
    added: dict[int, int] = {}
    for pair in sorted(replaced):
        for origin in pair:
            if origin not in added:
                added[origin] = geometry.addGeometryObject(tighter(robot.geometry.geometryObjects[origin]))
                origins.append(origin)
        geometry.addCollisionPair(pin.CollisionPair(added[pair[0]], added[pair[1]]))
    for (i, j), origin_pair in zip(pairs, stands_for, strict=True):
        if origin_pair in replaced:
            geometry.removeCollisionPair(pin.CollisionPair(i, j))


def _drop_always_touching(
    robot: Robot, geometry: pin.GeometryModel, origins: list[int], dropped: dict[tuple[str, str], str], samples: list[Array]
) -> None:
    """Drop pairs of links that touch nearly everywhere: they touch by construction, as at a shoulder."""
    model = CollisionModel(robot, geometry, {})
    counts = Counter(k for q in samples for k in model.touching_pairs(q))
    for k, pair in enumerate([(p.first, p.second) for p in geometry.collisionPairs]):
        carried = robot.carried.keys() & {robot.link_of(robot.geometry.geometryObjects[origins[body]]) for body in pair}
        if counts[k] >= ALWAYS * len(samples) and not carried:
            geometry.removeCollisionPair(pin.CollisionPair(*pair))
            dropped[model.pair_names[k]] = f"touching at {counts[k]} of {len(samples)} configurations"
