"""The static bodies of a MuJoCo model (MJCF) as obstacles, read by MuJoCo itself."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pinocchio as pin

from manipplan.collision.shapes import Box, Capsule, Cylinder, Mesh, Obstacle, Plane, Sphere, check_obstacles
from manipplan.robots.mjcf import SHAPES, colliding_geoms, fixed_pose, local_pose, stands_still, surface_of
from manipplan.robots.mjcf_files import compile_mjcf
from manipplan.support.errors import UnknownNameError

#: Shapes of MuJoCo that become obstacles.
TAKEN = ("plane", "hfield", "sphere", "capsule", "cylinder", "box", "mesh")


def read_static_bodies(file: Path) -> list[Obstacle]:
    """Every geom that collides, by its masks or a `<pair>`, and belongs to a body without a joint between it and the world.

    Raises:
        FileFormatError: MuJoCo cannot read the file, or it has too many geoms.
        UnknownNameError: a static geom has another shape, such as an ellipsoid.
        MissingExtraError: MuJoCo is not installed.
    """
    mj = compile_mjcf(file)
    obstacles, surfaces = list[Obstacle](), dict[tuple[str, int], Mesh]()
    standing = [each for each in colliding_geoms(file, mj) if stands_still(mj, mj.geom_bodyid[each])]
    check_obstacles("file", len(standing))
    for k in standing:
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
