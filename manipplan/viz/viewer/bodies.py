"""The bodies drawn for a robot: its visual meshes where they can be read, otherwise its collision geometry.

The visual geometry of a robot, read from its description only when the robot is drawn.

Triangle meshes of coal's shapes, for a browser.
"""

import logging
from dataclasses import dataclass
from itertools import cycle

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.scene import Scene
from manipplan.collision.world import core_of, mesh_triangles
from manipplan.robots import attached, mjcf, subchain
from manipplan.robots.description import read_visuals
from manipplan.robots.model_tree import plain_angles
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, ManipplanError
from manipplan.support.memo import once_per_owner
from manipplan.tracking.bodies import CapsuleBodies
from manipplan.viz import style


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


#: Maximum number of triangles per mesh: a browser without a graphics card can still animate two arms of ten links.
MOST = 4000
#: Minimum angle of an edge that stays sharp under smooth shading [rad].
CREASE = 0.6
#: Half the side of the square that is drawn for a plane [m].
PLANE = 1.5

Faces = NDArray[np.int64]


def triangles_of(shape: coal.CollisionGeometry, most: int = MOST) -> tuple[Array, Faces] | None:
    """Vertices (v, 3) [m] in the shape's frame and faces (f, 3), about `most` of them for a mesh; None for an empty mesh.

    A shape of an unknown type is drawn as its bounding box.
    """
    from trimesh import creation

    if isinstance(shape, coal.BVHModelBase):
        return _reduce(*_mesh(shape), most)
    if isinstance(shape, coal.ConvexBase):
        return _hull(core_of(shape)[0])
    if isinstance(shape, coal.Halfspace | coal.Plane):
        return _square(np.asarray(shape.n), float(shape.d))
    if isinstance(shape, coal.Box):
        mesh = creation.box(2 * np.asarray(shape.halfSide))
        return np.asarray(mesh.triangles).reshape(-1, 3), np.arange(3 * len(mesh.faces)).reshape(-1, 3)  # sharp edges
    if isinstance(shape, coal.Sphere):
        mesh = creation.icosphere(subdivisions=3, radius=shape.radius)
    elif isinstance(shape, coal.Ellipsoid):
        mesh = creation.icosphere(subdivisions=3)
        mesh.apply_scale(np.asarray(shape.radii))
    elif isinstance(shape, coal.Capsule):
        mesh = creation.capsule(height=2 * shape.halfLength, radius=shape.radius, count=(24, 24))
        mesh.apply_translation(-mesh.bounds.mean(axis=0))
    elif isinstance(shape, coal.Cylinder):
        mesh = creation.cylinder(radius=shape.radius, height=2 * shape.halfLength, sections=40)
    elif isinstance(shape, coal.Cone):
        mesh = creation.cone(radius=shape.radius, height=2 * shape.halfLength, sections=40)
        mesh.apply_translation((0.0, 0.0, -shape.halfLength))
    else:
        return _hull(core_of(shape)[0])
    return _crease(np.asarray(mesh.vertices), np.asarray(mesh.faces))


def _mesh(shape: coal.BVHModelBase) -> tuple[Array, Faces]:
    """A mesh with coincident vertices merged."""
    vertices, index = np.unique(mesh_triangles(shape).reshape(-1, 3).round(6), axis=0, return_inverse=True)
    faces = index.reshape(-1, 3)
    flat = (faces == np.roll(faces, 1, axis=1)).any(axis=1)
    return vertices, faces[~flat]


def _reduce(vertices: Array, faces: Faces, most: int) -> tuple[Array, Faces] | None:
    import fast_simplification

    if not len(faces):
        return None
    if len(faces) > most:
        fewer = fast_simplification.simplify(vertices.astype(np.float32), faces.astype(np.int32), target_count=most)
        vertices, faces = np.asarray(fewer[0], dtype=float), np.asarray(fewer[1], dtype=int)
    return _crease(vertices, faces)


def _hull(points: Array) -> tuple[Array, Faces] | None:
    import trimesh

    mesh = trimesh.convex.convex_hull(points)
    return _crease(np.asarray(mesh.vertices), np.asarray(mesh.faces))


def _square(normal: Array, offset: float) -> tuple[Array, Faces]:
    """A square in the plane normal · x = offset."""
    normal = normal / np.linalg.norm(normal)
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    corners = [offset * normal + PLANE * (a * first + b * second) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return np.array(corners), np.array([[0, 1, 2], [0, 2, 3]])


def _crease(vertices: Array, faces: Faces) -> tuple[Array, Faces]:
    """The same triangles, with separate vertices on the two sides of a sharp edge."""
    import trimesh
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    mesh = trimesh.Trimesh(vertices=vertices, faces=faces, process=False)
    smooth = mesh.face_adjacency[mesh.face_adjacency_angles < CREASE]
    graph = coo_array((np.ones(len(smooth)), tuple(smooth.T)), shape=(len(faces),) * 2)
    patch = connected_components(graph, directed=False)[1]
    corners = np.stack([faces.ravel(), np.repeat(patch, 3)], axis=1)
    kept, index = np.unique(corners, axis=0, return_inverse=True)
    return vertices[kept[:, 0]], index.reshape(-1, 3)


log = logging.getLogger("manipplan")

#: Maximum number of triangles of a mesh that does not move, such as the legs of a humanoid.
STILL = 1000
#: Colour of geometry without a colour of its own.
GREY = (0.72, 0.74, 0.77, 1.0)


@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnBody:
    """One rigid body: vertices (v, 3) [m] in the frame of its joint, faces (f, 3), colour and opacity (4,) in [0, 1]."""

    name: str
    joint: int
    vertices: Array
    faces: Faces
    colour: tuple[float, float, float, float]


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
    for item in geometry.geometryObjects:
        red, green, blue, alpha = (float(c) for c in item.meshColor)
        colour = (red, green, blue, alpha) if item.overrideMaterial else GREY
        most = MOST if item.parentJoint else STILL
        made += _drawn(item.name, item.parentJoint, item.placement, item.geometry, colour, most)
    return tuple(made)


def _drawn(
    name: str,
    joint: int,
    place: pin.SE3,
    shape: coal.CollisionGeometry,
    colour: tuple[float, float, float, float],
    most: int = MOST,
) -> list[DrawnBody]:
    """The body, or nothing for a mesh without triangles."""
    triangles = triangles_of(shape, most)
    if triangles is None:
        return []
    vertices = triangles[0] @ place.rotation.T + place.translation
    return [DrawnBody(name=name, joint=joint, vertices=vertices, faces=triangles[1], colour=colour)]


def _rods(robot: Robot) -> tuple[DrawnBody, ...]:
    """A capsule from each joint to the next, and from the last to each tool."""
    import coal

    from manipplan.robots.model_tree import frame_index

    model = robot.model
    tools = [model.frames[frame_index(model, tool)] for tool in robot.tools]
    ends = [(model.parents[i], model.jointPlacements[i].translation) for i in range(1, model.njoints)]
    ends += [(tool.parentJoint, tool.placement.translation) for tool in tools]
    lengths = [float(np.linalg.norm(end)) for _, end in ends]
    radius = 0.03 * max(sum(lengths), 1e-3)
    made = []
    for k, ((joint, end), length) in enumerate(zip(ends, lengths, strict=True)):
        if length < 1e-6:
            continue
        turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), np.asarray(end) / length).toRotationMatrix()
        triangles = triangles_of(coal.Capsule(min(radius, 0.3 * length), length))
        assert triangles is not None
        placed = triangles[0] @ turn.T + np.asarray(end) / 2
        made.append(DrawnBody(name=f"rod{k}", joint=joint, vertices=placed, faces=triangles[1], colour=GREY))
    return tuple(made)


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
    found: list[DrawnBody] = []
    for body in CapsuleBodies.of(robot).items:
        along = body.end - body.start
        length = float(np.linalg.norm(along))
        turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), along).matrix() if length > 0 else np.eye(3)
        shape = coal.Capsule(body.radius, length) if length > 0 else coal.Sphere(body.radius)
        place = pin.SE3(turn, (body.start + body.end) / 2)
        found += _drawn(body.name, body.joint, place, shape, (*style.rgb(style.ELLIPSOID), AROUND))
    return found
