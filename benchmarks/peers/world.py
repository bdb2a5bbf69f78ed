"""Writes an arm among the obstacles of a scene as one URDF, so that peers see the kinematics and the shapes that we see."""

import os
from pathlib import Path
from xml.etree import ElementTree

import coal
import numpy as np
import pinocchio as pin
from scipy.spatial import ConvexHull

import manipplan as mp

#: Names of the bodies in the URDF: shape k is `shape<k>`, a link of its own.
BASE, TOOL = "base", "tool"


def write_world(robot: mp.Robot, scene: mp.Scene, folder: Path) -> dict:
    """Writes world.urdf and world.srdf and returns what peers need: file names, joint names, limits and checked pairs.

    Every body of the arm and of the scene is a link of its own, fixed to the link it belongs to. `pairs` (k, 2) holds the
    pairs of links that are checked for collision, those of our own model; pairs of which one is a mesh that is not convex
    are left out, as peers take such a mesh for its hull.
    """
    model, tree = scene.collision_model(robot), ElementTree.Element("robot", name="world")
    ElementTree.SubElement(tree, "link", name=BASE)
    parents = [BASE, *robot.joint_names]
    for i in range(1, robot.n + 1):
        name = robot.joint_names[i - 1]
        ElementTree.SubElement(tree, "link", name=name)
        joint = _joint(tree, f"{name}_axis", parents[robot.model.parents[i]], name, robot.model.jointPlacements[i], "revolute")
        _limit(joint, robot, i - 1)
    frame = robot.model.frames[robot.model.getFrameId(robot.tool, pin.FrameType.BODY)]
    ElementTree.SubElement(tree, "link", name=TOOL)
    _joint(tree, "tool_fixed", parents[frame.parentJoint], TOOL, frame.placement, "fixed")
    shapes = model.geometry.geometryObjects
    pairs = []
    for pair in model.geometry.collisionPairs:
        if not any(isinstance(shapes[k].geometry, coal.BVHModelBase) for k in (pair.first, pair.second)):
            pairs.append((pair.first, pair.second))
    for k in sorted({k for pair in pairs for k in pair}):
        link = ElementTree.SubElement(tree, "link", name=f"shape{k}")
        collision = ElementTree.SubElement(link, "collision")
        _shape(ElementTree.SubElement(collision, "geometry"), shapes[k].geometry, folder / f"shape{k}.obj")
        _joint(tree, f"shape{k}_fixed", parents[shapes[k].parentJoint], f"shape{k}", shapes[k].placement, "fixed")
    urdf, srdf = folder / "world.urdf", folder / "world.srdf"
    urdf.write_text(ElementTree.tostring(tree, encoding="unicode"))
    used = sorted({k for pair in pairs for k in pair})
    srdf.write_text(_semantics(used, {frozenset(pair) for pair in pairs}, folder))
    return {
        "urdf": str(urdf),
        "srdf": str(srdf),
        "joints": np.array([f"{name}_axis" for name in robot.joint_names]),
        "pairs": np.array([(f"shape{i}", f"shape{j}") for i, j in pairs]).reshape(-1, 2),
        "lower": robot.limits.lower,
        "upper": robot.limits.upper,
        "angular": robot.default_task.length,
    }


def write_description(robot: mp.Robot, folder: Path) -> dict:
    """Writes arm.urdf and arm.srdf: the description that the arm was loaded from, with its own meshes.

    Joints that do not move are fixed where our arm has them, and mesh files are named from `folder`. Returns file names,
    the names of base, tool and joints, and the limits of velocity and acceleration.
    """
    source = Path(robot.source.file)
    tree = ElementTree.parse(source).getroot()
    for joint in tree.findall("joint"):
        if joint.get("type") != "fixed" and joint.get("name") not in robot.joint_names:
            _fix(joint, robot.locked.get(joint.get("name"), 0.0))
    for link in tree.findall("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
    for mesh in tree.iter("mesh"):
        package, name = mesh.get("filename").removeprefix("package://").split("/", 1)
        [parent] = [each for each in source.parents if each.name == package]
        mesh.set("filename", os.path.relpath(parent / name, folder))  # mplib puts the folder before every name
    urdf, srdf = folder / "arm.urdf", folder / "arm.srdf"
    ElementTree.ElementTree(tree).write(urdf)
    near = {frozenset(name.rsplit("_", 1)[0] for name in pair) for pair in robot.unchecked}  # those are of bodies
    semantics = ElementTree.Element("robot", name=tree.get("name"))
    for pair in sorted(sorted(each) for each in robot.disabled_pairs | near if len(each) == 2):
        ElementTree.SubElement(semantics, "disable_collisions", link1=pair[0], link2=pair[1], reason="Never")
    srdf.write_text(ElementTree.tostring(semantics, encoding="unicode"))
    moved = {joint.find("child").get("link") for joint in tree.findall("joint") if joint.get("type") != "fixed"}
    base = (
        next(joint for joint in tree.findall("joint") if joint.get("name") == robot.joint_names[0]).find("parent").get("link")
    )
    assert base not in moved
    limits = {kind: getattr(robot.limits, kind) for kind in ("velocity", "acceleration")}
    names = {"base": base, "tool": robot.tool, "joints": np.array(robot.joint_names)}
    return {"urdf": str(urdf), "srdf": str(srdf), **names, **limits}


def _fix(joint, at: float) -> None:
    """Make a joint fixed where its angle or way is `at`."""
    origin, axis = joint.find("origin"), np.array(joint.find("axis").get("xyz").split(), float)
    given = {} if origin is None else origin.attrib
    rpy, xyz = (np.array(given.get(name, "0 0 0").split(), float) for name in ("rpy", "xyz"))
    slides = joint.get("type") == "prismatic"
    moved = pin.SE3(np.eye(3), at * axis) if slides else pin.SE3(pin.exp3(at * axis), np.zeros(3))
    placed = pin.SE3(pin.rpy.rpyToMatrix(*rpy), xyz) * moved
    for part in joint.findall("*"):
        if part.tag not in ("parent", "child"):
            joint.remove(part)
    joint.set("type", "fixed")
    ElementTree.SubElement(
        joint, "origin", xyz=_numbers(placed.translation), rpy=_numbers(pin.rpy.matrixToRpy(placed.rotation))
    )


def _joint(tree, name: str, parent: str, child: str, placement: pin.SE3, kind: str):
    joint = ElementTree.SubElement(tree, "joint", name=name, type=kind)
    ElementTree.SubElement(joint, "parent", link=parent)
    ElementTree.SubElement(joint, "child", link=child)
    rpy = pin.rpy.matrixToRpy(placement.rotation)
    ElementTree.SubElement(joint, "origin", xyz=_numbers(placement.translation), rpy=_numbers(rpy))
    return joint


def _limit(joint, robot: mp.Robot, i: int) -> None:
    kind = robot.model.joints[i + 1]
    axis = {"JointModelRX": [1, 0, 0], "JointModelRY": [0, 1, 0], "JointModelRZ": [0, 0, 1]}.get(kind.shortname())
    limits = robot.limits
    ElementTree.SubElement(joint, "axis", xyz=_numbers(kind.extract().axis if axis is None else axis))
    bounds = {"lower": limits.lower[i], "upper": limits.upper[i], "velocity": limits.velocity[i], "effort": limits.effort[i]}
    ElementTree.SubElement(joint, "limit", {key: _numbers([value]) for key, value in bounds.items()})


def _shape(geometry, shape, file: Path) -> None:
    if isinstance(shape, coal.Box):
        ElementTree.SubElement(geometry, "box", size=_numbers(2 * shape.halfSide))
    elif isinstance(shape, coal.Capsule):
        ElementTree.SubElement(geometry, "capsule", radius=_numbers([shape.radius]), length=_numbers([2 * shape.halfLength]))
    elif isinstance(shape, coal.Sphere):
        ElementTree.SubElement(geometry, "sphere", radius=_numbers([shape.radius]))
    else:
        points = np.array(shape.points())
        hull = ConvexHull(points)
        corners = {vertex: number for number, vertex in enumerate(hull.vertices, start=1)}
        turned = [
            face if np.linalg.det(points[face] - points[hull.vertices].mean(axis=0)) > 0 else face[::-1]
            for face in hull.simplices
        ]
        lines = [f"v {_numbers(points[vertex])}" for vertex in corners]
        lines += ["f " + " ".join(str(corners[vertex]) for vertex in face) for face in turned]
        file.write_text("\n".join(lines) + "\n")
        mesh = ElementTree.SubElement(geometry, "mesh", filename=str(file))
        mesh.set("tesseract:make_convex", "true")
        ElementTree.SubElement(mesh, "drake:declare_convex")


def _semantics(used: list[int], checked: set[frozenset[int]], folder: Path) -> str:
    """SRDF with the group `arm` and tesseract's two plugin files; every pair of shapes that is not checked is disabled."""
    tree = ElementTree.Element("robot", name="world")
    group = ElementTree.SubElement(tree, "group", name="arm")
    ElementTree.SubElement(group, "chain", base_link=BASE, tip_link=TOOL)
    for plugin in ("kinematics", "contact_managers"):
        ElementTree.SubElement(tree, f"{plugin}_plugin_config", filename=f"file://{folder / plugin}.yaml")
    for j, second in enumerate(used):
        for first in used[:j]:
            if frozenset((first, second)) not in checked:
                links = {"link1": f"shape{first}", "link2": f"shape{second}", "reason": "Never"}
                ElementTree.SubElement(tree, "disable_collisions", links)
    return ElementTree.tostring(tree, encoding="unicode")


def _numbers(values) -> str:
    return " ".join(repr(float(x)) for x in values)
