"""A robot and a scene in JSON: their sources, and the data that identify a different robot."""

import logging
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle
from manipplan.robots.attached import CarriedPart, with_part
from manipplan.robots.hulls import box_around
from manipplan.robots.limits import JointLimits
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.robots.source import FILES, FOLDERS, FOLDERS_BY_NAME, TRUST, RobotSource
from manipplan.support.checks import Array, instance
from manipplan.support.errors import FileFormatError, InvalidInputError, ManipplanError, MissingExtraError
from manipplan.support.files import absolute_and_relative, found_again
from manipplan.support.json_data import from_json, packed_array, stored_array, unpacked_array

log = logging.getLogger("manipplan")

#: Tolerance on screws, home pose and bodies of the rebuilt robot against the stored ones [m, rad].
SAME = 1e-6
#: Number of values for a body's joint, placement and box.
OUTLINE = 1 + 12 + 6
#: Number of points or triangles of an obstacle above which they are stored compressed.
MANY = 100
LIMITS = ("lower", "upper", "velocity", "acceleration", "jerk", "effort")


def fingerprint(robot: Robot) -> tuple[Array, Array]:
    """The pose of each tool at q = 0 (k, 4, 4) and every joint's screw there (n, 6), linear part first, in the world's frame.

    By the product of exponentials they give the poses of the tools at every q: different kinematics have different values.
    """
    data = robot.model.createData()
    zero = np.zeros(robot.n)
    pin.computeJointJacobians(robot.model, data, zero)
    pin.framesForwardKinematics(robot.model, data, zero)
    tools = [data.oMf[frame_index(robot.model, tool)].homogeneous for tool in robot.tools]
    return np.array(tools), np.array(data.J.T)


def outlines(robot: Robot) -> Array:
    """Joint number, placement in the joint's frame and bounding box of each body of the collision geometry (k, OUTLINE).

    A shape that was replaced, scaled or moved has a different row.
    """
    rows = []
    for body in robot.geometry.geometryObjects:
        rows.append([[body.parentJoint], body.placement.homogeneous[:3].ravel(), *box_around(body.geometry)])
    return np.array([np.concatenate(row) for row in rows]).reshape(-1, OUTLINE)


def robot_data(robot: Robot, folder: Path) -> dict[str, Any]:
    """The data of a robot for a file in `folder`; paths are stored both absolute and relative to `folder`."""
    home, screws = fingerprint(robot)
    limits = {kind: getattr(robot.limits, kind) for kind in LIMITS}
    data = {
        "arm": robot.name,
        "tools": robot.tools,
        "joint_names": robot.joint_names,
        "neutral": robot.neutral,
        "limits": {**limits, "sources": robot.limits.sources},
        "limit_tolerance": robot.limit_tolerance,
        "home": home,
        "screws": screws,
        "outlines": outlines(robot),
        "base": robot.base,
        "frames": [vars(added) for added in robot.added_frames],
        "parts": [[name, type(part.solid).__name__, part.frame] for name, part in robot.carried.items()],
    }
    carried = []
    for name, part in robot.carried.items():
        if not isinstance(part.solid, Obstacle) or "missing" in scene_data(Scene([part.solid]), folder):
            return {**data, "missing": f"the part {name!r} of a class of your own, {type(part.solid).__name__}"}
        carried.append(part.solid.called(name))
    data["carried"] = scene_data(Scene(carried), folder)
    source = robot.source
    if source is None:
        return {**data, "missing": "an arm that was put together by hand"}
    options = {
        key: _option(key, value, lambda path: absolute_and_relative(path, folder))
        for key, value in source.options.items()
        if key != TRUST
    }
    file = absolute_and_relative(source.file, folder) if source.file is not None and source.kind != "catalogue" else None
    return {**data, "source": {"kind": source.kind, "name": source.name, "file": file, "options": options}}


def robot_of(path: Path, data: Mapping[str, Any], folder: Path, given: Robot | None) -> Robot:
    """The arm rebuilt from the data, or the one given; both have to be the robot of the file."""
    if given is None:
        if "source" not in data:
            raise FileFormatError("file", str(path), f"a result with its robot, but it has {data['missing']}; give robot=")
        source = data["source"]
        try:
            options = {
                key: _option(key, value, lambda each: found_again(each, folder))
                for key, value in source["options"].items()
                if key != TRUST  # a saved plan may come from anywhere
            }
            file = found_again(source["file"], folder) if source["file"] is not None else None
            arm = RobotSource(kind=source["kind"], name=source["name"], file=file, options=options).load()
            arm = _apply_changes(arm, path, data, folder)
            limits = from_json(data["limits"], JointLimits)
            if limits.n == arm.n:  # otherwise it is another arm, which raises below
                arm = replace(arm, limits=limits, neutral=stored_array(data["neutral"]))
                arm = arm.with_limits(limit_tolerance=data["limit_tolerance"])
        except MissingExtraError:
            raise
        except ManipplanError as error:
            wanted = f"a result whose robot can be read again ({error}); put its files back, or give robot="
            raise FileFormatError("file", str(path), wanted) from error
    else:
        arm = instance("robot", given, Robot)
    stored = [stored_array(data[key]) for key in ("home", "screws")]
    stored.append(stored_array(data["outlines"]).reshape(-1, OUTLINE))
    names = tuple(data["joint_names"])
    found = (*fingerprint(arm), outlines(arm))
    tools = tuple(data["tools"])
    parts = [[name, type(part.solid).__name__, part.frame] for name, part in arm.carried.items()]
    if (
        arm.joint_names != names
        or arm.tools != tools
        or parts != data["parts"]
        or not all(_same(a, b) for a, b in zip(found, stored, strict=True))
    ):
        said = f"{arm.name} with {', '.join(arm.joint_names)} and tool {' and '.join(arm.tools)}"
        wanted = (
            f"the robot of {path}: {data['arm']} with {', '.join(names)} and tool {' and '.join(tools)}, and links as when the "
            "plan was saved. Its files were changed, or it is another robot: give the right robot="
        )
        raise FileFormatError("robot", said, wanted)
    other = [kind for kind in LIMITS if not np.array_equal(getattr(arm.limits, kind), stored_array(data["limits"][kind]))]
    if other:
        log.warning("%s: the robot given has other limits (%s) than the plan was made and checked for", path, ", ".join(other))
    return arm


def _apply_changes(arm: Robot, path: Path, data: Mapping[str, Any], folder: Path) -> Robot:
    """The arm with the base, the tool frames and the parts of the data."""
    base = stored_array(data["base"])
    if not np.array_equal(base, arm.base):
        arm = arm.at(base)
    for added in data["frames"]:
        arm = arm.with_tool(stored_array(added["pose"]), name=added["name"], tool=added["frame"])
    return with_parts(arm, path, data, folder)


def with_parts(arm: Robot, path: Path, data: Mapping[str, Any], folder: Path) -> Robot:
    """The arm with the parts of the data instead of those that it carries; as it is where the data have none.

    A part may be in the hand of another arm, which does not move.
    """
    if "carried" not in data:
        return arm
    for name in arm.carried:
        arm = arm.detach(name)
    solids = scene_of(path, data["carried"], folder, None).named
    for solid, (name, _, frame) in zip(solids, data["parts"], strict=True):
        geometry, bodies = with_part(arm.model, arm.geometry, frame, solid, name)
        arm = replace(
            arm, geometry=geometry, carried={**arm.carried, name: CarriedPart(solid=solid, bodies=bodies, frame=frame)}
        )
    return arm


def _same(first: Array, second: Array) -> bool:
    return first.shape == second.shape and np.allclose(first, second, rtol=0.0, atol=SAME)


def scene_data(scene: Scene, folder: Path) -> Any:
    """The data of a scene for a file in `folder`, or why there are none: an obstacle is of an unknown class."""
    try:
        obstacles = [{key: _stored(value, folder) for key, value in entry.items()} for entry in scene.entries()]
        return {"obstacles": obstacles, "allowed": scene.allowed_names()}
    except InvalidInputError as error:
        return {"missing": str(error)}


def scene_of(path: Path, data: Any, folder: Path, given: Scene | None) -> Scene:
    """The scene rebuilt from the data, or the one given."""
    if given is not None:
        return instance("scene", given, Scene)
    if "missing" in data:
        raise FileFormatError("file", str(path), f"a result with its scene, but {data['missing']}; give scene=")
    entries = [{key: _restored(key, value, folder) for key, value in entry.items()} for entry in data["obstacles"]]
    try:
        return Scene.from_entries(entries, folder, allowed=data["allowed"])
    except InvalidInputError as error:
        wanted = f"a result whose scene can be built again ({error}); put its files back, or give scene="
        raise FileFormatError("file", str(path), wanted) from error


def _stored(value: Any, folder: Path) -> Any:
    """A value of an obstacle: paths as two, many numbers compressed."""
    if isinstance(value, Path):
        return absolute_and_relative(value, folder)
    return packed_array(np.array(value, dtype=float)) if isinstance(value, list) and len(value) > MANY else value


def _restored(key: str, value: Any, folder: Path) -> Any:
    if key == "file":
        return found_again(value, folder)
    return unpacked_array(value) if isinstance(value, Mapping) else value


def _option(key: str, value: Any, change: Callable[[Any], Any]) -> Any:
    """An option of a robot, with its paths changed and its lists of numbers as arrays."""
    if key in FILES:
        return change(value)
    if key in FOLDERS:
        return [change(each) for each in value]
    if key in FOLDERS_BY_NAME:
        return {name: change(folder) for name, folder in value.items()}
    return stored_array(value) if key in (*LIMITS, "neutral", "lengths") else value
