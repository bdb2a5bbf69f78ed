"""The bodies drawn for a robot: its visual meshes where they can be read, otherwise its collision geometry."""

import logging
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner
from manipplan.viz.viewer.triangles import MOST, Faces, triangles_of

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
    from manipplan.viz.viewer.visuals import visual_geometry

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
    made = []
    for item in geometry.geometryObjects:
        triangles = triangles_of(item.geometry, MOST if item.parentJoint else STILL)
        if triangles is None:
            continue
        vertices, faces = triangles
        placed = vertices @ item.placement.rotation.T + item.placement.translation
        red, green, blue, alpha = (float(c) for c in item.meshColor)
        colour = (red, green, blue, alpha) if item.overrideMaterial else GREY
        made.append(DrawnBody(name=item.name, joint=item.parentJoint, vertices=placed, faces=faces, colour=colour))
    return tuple(made)


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
