"""The static bodies of a MuJoCo model (MJCF) as obstacles, read by MuJoCo itself."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.shapes import Box, Capsule, Cylinder, Mesh, Obstacle, Plane, Sphere
from manipplan.robots.formats.mjcf_files import compile_mjcf
from manipplan.robots.mjcf import SHAPES, fixed_pose, local_pose, surface_of
from manipplan.support.errors import UnknownNameError

#: Shapes of MuJoCo that become obstacles.
TAKEN = ("plane", "hfield", "sphere", "capsule", "cylinder", "box", "mesh")


def read_static_bodies(file: Path) -> list[Obstacle]:
    """Every geom that collides and belongs to a body without a joint between it and the world.

    Raises:
        FileFormatError: MuJoCo cannot read the file.
        UnknownNameError: a static geom has another shape, such as an ellipsoid.
        MissingExtraError: MuJoCo is not installed.
    """
    mj = compile_mjcf(file)
    static = mj.body_weldid[mj.geom_bodyid] == 0
    collides = (mj.geom_contype != 0) | (mj.geom_conaffinity != 0)
    obstacles, surfaces = list[Obstacle](), dict[tuple[str, int], Mesh]()
    for k in np.flatnonzero(static & collides).tolist():
        body, shape = int(mj.geom_bodyid[k]), SHAPES[mj.geom_type[k]]
        name = mj.geom(k).name or f"{mj.body(body).name}.{k}"
        pose = fixed_pose(mj, body) * local_pose(mj.geom_pos[k], mj.geom_quat[k])
        if shape in ("mesh", "hfield"):  # several geoms may show one mesh
            data = shape, int(mj.geom_dataid[k])
            if data not in surfaces:
                vertices, faces = surface_of(file, mj, k)
                surfaces[data] = Mesh(triangles=vertices[faces])
            obstacles.append(surfaces[data].at(pose).called(name))
        else:
            obstacles.append(_obstacle(name, shape, [float(each) for each in mj.geom_size[k]], pose))
    return obstacles


def _obstacle(name: str, shape: str, size: Sequence[float], pose: pin.SE3) -> Obstacle:
    at: dict[str, Any] = {"name": name, "position": pose.translation, "rotation": pose.rotation}
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
    raise UnknownNameError(f"shape of the geom {name}", shape, TAKEN)
