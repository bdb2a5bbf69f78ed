"""The visual geometry of a robot, read from its description only when the robot is drawn."""

import pinocchio as pin

from manipplan.robots import attached, mjcf, reduced
from manipplan.robots.description import read_visuals
from manipplan.robots.model_tree import plain_angles
from manipplan.robots.robot import Robot
from manipplan.support.errors import InvalidInputError, ManipplanError


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
        model, geometry = reduced.reduce(*parts, robot.joint_names, robot.locked, robot.followers)
    except (ValueError, RuntimeError, IndexError, ManipplanError) as error:
        reason = error.allowed if isinstance(error, InvalidInputError) else str(error)
        return None, f"the visual meshes of {file.name} cannot be read: {' '.join(reason.split())[:160]}"
    geometry = attached.move_base(model, geometry, pin.SE3(robot.base))[1]
    for item in robot.geometry.geometryObjects:
        if any(item.name in part.bodies for part in robot.carried.values()):
            geometry.addGeometryObject(item.copy())
    return geometry, ""
