"""The bodies drawn for a robot: its visual meshes where they can be read, otherwise its collision geometry.

The visual geometry of a robot, read from its description only when the robot is drawn.
"""

import logging
from dataclasses import dataclass
from itertools import cycle
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.robots import attached, mjcf, subchain
from manipplan.robots.description import read_visuals
from manipplan.robots.mesh_scenes import read_coloured
from manipplan.robots.model_tree import frame_index, plain_angles
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, ManipplanError
from manipplan.support.memo import once_per_owner
from manipplan.tracking.bodies import CapsuleBodies
from manipplan.viz import style
from manipplan.viz.shapes import MOST, Faces, faces_of_parts, triangles_of


def visual_geometry(robot: Robot) -> tuple[pin.GeometryModel | None, str]:
    """The visual geometry placed on `robot.model`, or None and the reason why there is none."""
    source = robot.source
    if source is None:
        return None, "the robot was not read from a file"
    if source.kind == "planar" or source.file is None:
        return None, "a planar arm has no meshes"
    file = source.file
    if not file.is_file():
        return None, f"{file} does not exist any more"
    try:
        if source.kind == "mjcf":
            whole, geometry = mjcf.read_visuals(file)
        else:
            whole, geometry = read_visuals(file, source.urdf_files)
        parts = plain_angles(whole), geometry
        model, geometry = subchain.reduce(*parts, robot.joint_names, robot.locked, robot.followers)
    except (ValueError, RuntimeError, IndexError, ManipplanError) as error:
        reason = error.allowed if isinstance(error, InvalidInputError) else str(error)
        return None, f"the visual meshes of {file.name} cannot be read: {' '.join(reason.split())[:160]}"
    geometry = attached.move_base(model, geometry, pin.SE3(robot.base))[1]
    for item in robot.geometry.geometryObjects:
        if any(item.name in part.bodies for part in robot.carried.values()):
            geometry.addGeometryObject(item.copy())
    return geometry, ""


log = logging.getLogger("manipplan")

Colour = tuple[float, float, float, float]
#: Number of triangles of all meshes that do not move, such as the legs of a humanoid, and of one of them at least.
STILL, LEAST_STILL = 30_000, 1000
#: Colour of geometry without a colour of its own.
GREY = (0.5, 0.52, 0.56, 1.0)


@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnBody:
    """One rigid body: vertices (v, 3) [m] in the frame of its joint, faces (f, 3), colour and opacity (4,) in [0, 1]."""

    name: str
    joint: int
    vertices: Array
    faces: Faces
    colour: Colour


@dataclass(frozen=True, kw_only=True, eq=False)
class Appearance:
    """The bodies of a robot, and a text on the geometry they were made from."""

    bodies: tuple[DrawnBody, ...]
    origin: str


@once_per_owner
def appearance_of(robot: Robot) -> Appearance:
    """The appearance of a robot; built once.

    Without readable visual meshes the collision geometry is drawn, and without collision geometry rods from joint to joint;
    `origin` tells which one and why.
    """
    geometry, reason = visual_geometry(robot)
    if geometry is not None:
        bodies = _bodies(geometry)
        if bodies:
            return Appearance(bodies=bodies, origin="visual meshes")
        reason = "the description has no visual geometry"
    bodies = _bodies(robot.geometry)
    origin = f"collision geometry ({reason})"
    if not bodies:
        bodies, origin = _rods(robot), f"rods from joint to joint ({reason}, and there is no collision geometry)"
    log.info("%s is drawn from its %s", robot.name, origin)
    return Appearance(bodies=bodies, origin=origin)


def _bodies(geometry: pin.GeometryModel) -> tuple[DrawnBody, ...]:
    made: list[DrawnBody] = []
    still = sum(not item.parentJoint for item in geometry.geometryObjects)
    of_still = min(max(STILL // max(still, 1), LEAST_STILL), MOST)
    for item in geometry.geometryObjects:
        red, green, blue, alpha = (float(c) for c in item.meshColor)
        colour = (red, green, blue, alpha) if item.overrideMaterial else GREY
        most = MOST if item.parentJoint else of_still
        parts = () if item.overrideMaterial else _coloured_parts(item)
        if parts:
            surfaces = faces_of_parts([triangles for _, triangles in parts], most)
            for (own, _), surface in zip(parts, surfaces, strict=True):
                made += _moved(item.name, item.parentJoint, item.placement, surface, own)
        else:
            made += _drawn(item.name, item.parentJoint, item.placement, item.geometry, colour, most)
    return tuple(made)


def _coloured_parts(item: pin.GeometryObject) -> list[tuple[Colour, Array]]:
    """The triangles (t, 3, 3) [m] of each colour of a mesh, where its file has colours that are read, as COLLADA files may."""
    file = Path(item.meshPath)
    if file.suffix.lower() != ".dae" or not file.is_file():
        return []
    scale = np.asarray(item.meshScale)
    parts = [((*colour, 1.0) if colour else GREY, scale * part) for colour, part in read_coloured("file", file) if len(part)]
    return [(colour, part[:, ::-1] if scale.prod() < 0 else part) for colour, part in parts]


def _drawn(
    name: str, joint: int, place: pin.SE3, shape: coal.CollisionGeometry, colour: Colour, most: int = MOST
) -> list[DrawnBody]:
    """The body, or nothing for a mesh without triangles."""
    return _moved(name, joint, place, triangles_of(shape, most), colour)


def _moved(name: str, joint: int, place: pin.SE3, surface: tuple[Array, Faces], colour: Colour) -> list[DrawnBody]:
    """The body of a surface in its own frame, or nothing for one without triangles."""
    vertices, faces = surface
    vertices = vertices @ place.rotation.T + place.translation
    return [DrawnBody(name=name, joint=joint, vertices=vertices, faces=faces, colour=colour)] if len(faces) else []


def _rods(robot: Robot) -> tuple[DrawnBody, ...]:
    """A capsule from each joint to the next, and from the last to each tool."""
    model = robot.model
    tools = [model.frames[frame_index(model, tool)] for tool in robot.tools]
    ends = [(model.parents[i], model.jointPlacements[i].translation) for i in range(1, model.njoints)]
    ends += [(tool.parentJoint, tool.placement.translation) for tool in tools]
    radius = 0.03 * max(sum(float(np.linalg.norm(end)) for _, end in ends), 1e-3)
    made: list[DrawnBody] = []
    for k, (joint, end) in enumerate(ends):
        length = float(np.linalg.norm(end))
        if length >= 1e-6:
            made += _capsule(f"rod{k}", joint, np.zeros(3), np.asarray(end), min(radius, 0.3 * length), GREY)
    return tuple(made)


def _capsule(name: str, joint: int, start: Array, end: Array, radius: float, colour: Colour) -> list[DrawnBody]:
    """A capsule about the line between two points (3,), or a ball where they are one."""
    length = float(np.linalg.norm(end - start))
    turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), end - start).matrix() if length > 0 else np.eye(3)
    shape = coal.Capsule(radius, length) if length > 0 else coal.Sphere(radius)
    return _drawn(name, joint, pin.SE3(turn, (start + end) / 2), shape, colour)


#: Opacity of capsules, which are drawn around the links.
AROUND = 0.35


def convex_bodies(robot: Robot) -> list[DrawnBody]:
    """The bodies of the collision model; neighbouring ones differ in colour."""
    model = Scene().collision_model(robot)
    found: list[DrawnBody] = []
    for item, colour in zip(model.objects[: model.bodies], cycle(style.PIECES), strict=False):
        if not isinstance(item.geometry, coal.Halfspace | coal.Plane):
            found += _drawn(item.name, item.parentJoint, item.placement, item.geometry, (*style.rgb(colour), 1.0))
    return found


def capsules(robot: Robot) -> list[DrawnBody]:
    """The capsules and balls that a controller keeps apart."""
    colour = (*style.rgb(style.ELLIPSOID), AROUND)
    items = CapsuleBodies.of(robot).items
    return [each for body in items for each in _capsule(body.name, body.joint, body.start, body.end, body.radius, colour)]
