"""The static bodies of a MuJoCo model (MJCF) as obstacles, read by MuJoCo itself."""

from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.shapes import Box, Capsule, Cylinder, Mesh, Obstacle, Plane, Sphere
from manipplan.robots.formats.xml_files import read_xml
from manipplan.support.errors import FileFormatError, MissingExtraError, UnknownNameError

#: Shapes of MuJoCo that become obstacles.
SHAPES = ("plane", "sphere", "capsule", "cylinder", "box", "mesh")


def read_static_bodies(file: Path) -> list[Obstacle]:
    """Every geom that collides and belongs to a body without a joint between it and the world.

    Raises:
        FileFormatError: MuJoCo cannot read the file.
        UnknownNameError: a static geom has another shape, such as an ellipsoid.
        MissingExtraError: MuJoCo is not installed.
    """
    read_xml("file", file, "mujoco")
    try:
        import mujoco
    except ImportError as error:
        raise MissingExtraError("mujoco", "mujoco") from error
    mujoco.mj_clearCache(mujoco.mj_getCache())  # it keeps a mesh whose file is changed within one second
    try:
        model = mujoco.MjModel.from_xml_path(str(file))
    except ValueError as error:
        reason = " ".join(str(error).split())[:200]
        raise FileFormatError("file", str(file), f"an MJCF file; MuJoCo says: {reason}") from error
    try:
        model.names.decode()
    except UnicodeDecodeError as error:  # in an included file
        raise FileFormatError("file", str(file), f"an MJCF file with names in UTF-8 ({error})") from error
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    static = model.body_weldid[model.geom_bodyid] == 0
    collides = (model.geom_contype != 0) | (model.geom_conaffinity != 0)
    obstacles, meshes = list[Obstacle](), dict[int, Mesh]()
    for k in np.flatnonzero(static & collides):
        geom = model.geom(k)
        body = model.body(geom.bodyid[0]).name
        name = geom.name or f"{body}.{k}"
        shape = mujoco.mjtGeom(int(geom.type[0])).name.removeprefix("mjGEOM_").lower()
        position, rotation = data.geom_xpos[k].copy(), data.geom_xmat[k].reshape(3, 3).copy()
        if shape == "mesh":  # several geoms may show one mesh
            number = int(geom.dataid[0])
            meshes[number] = meshes.get(number) or _mesh(model, number)
            obstacles.append(meshes[number].at(pin.SE3(rotation, position)).called(name))
        else:
            obstacles.append(_obstacle(geom, name, shape, position, rotation))
    return obstacles


def _mesh(model: Any, number: int) -> Mesh:
    mesh = model.mesh(number)
    vertices = model.mesh_vert[mesh.vertadr[0] : mesh.vertadr[0] + mesh.vertnum[0]]
    faces = model.mesh_face[mesh.faceadr[0] : mesh.faceadr[0] + mesh.facenum[0]]
    return Mesh(triangles=np.asarray(vertices[faces], dtype=float))


def _obstacle(geom: Any, name: str, shape: str, position: Any, rotation: Any) -> Obstacle:
    at = {"name": name, "position": position, "rotation": rotation}
    size = [float(value) for value in geom.size]
    if shape == "plane":
        return Plane(**at)
    if shape == "sphere":
        return Sphere(radius=size[0], **at)
    if shape == "capsule":
        return Capsule(radius=size[0], length=2 * size[1], **at)
    if shape == "cylinder":
        return Cylinder(radius=size[0], length=2 * size[1], **at)
    if shape == "box":
        return Box(size=[2 * value for value in size], **at)
    raise UnknownNameError(f"shape of the geom {name}", shape, SHAPES)
