"""The bodies that are checked for collisions: a plan's convex bodies in place of the links, and a controller's capsules."""

import threading
from collections.abc import Callable, Sequence
from itertools import cycle
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.robots.robot import Robot
from manipplan.tracking.bodies import CapsuleBodies
from manipplan.viz import style
from manipplan.viz.viewer.bodies import DrawnBody, triangles_of
from manipplan.viz.viewer.figures import RobotFigure, draw_body, rgb

#: Opacity of capsules, which are drawn around the links.
AROUND = 0.35


class CheckedFigure:
    """CapsuleBodies on the joint frames of a robot's figure. They are made when they are shown for the first time."""

    def __init__(
        self, scene: Any, figure: RobotFigure, name: str, make: Callable[[Robot], Sequence[DrawnBody]], *, replaces: bool
    ) -> None:
        """`name`: in the scene; `make` gives the bodies of a robot; `replaces`: whether its links are hidden meanwhile."""
        self._scene, self._figure, self._name, self._make, self._replaces = scene, figure, name, make, replaces
        self._lock = threading.Lock()
        self._meshes: list[Any] = []
        self._visible = False

    @property
    def visible(self) -> bool:
        """Whether the bodies are shown."""
        return self._visible

    @visible.setter
    def visible(self, value: bool) -> None:
        with self._lock:
            if value and not self._meshes:
                self._meshes = [
                    draw_body(
                        self._scene, f"{self._figure.root.name}/{body.joint}/{self._name}{k}", body, body.colour, casts=False
                    )
                    for k, body in enumerate(self._make(self._figure.robot))
                ]
            self._visible = value
            for mesh in self._meshes:
                mesh.visible = value
            for link in self._figure.meshes if self._replaces else ():
                link.visible = not value


def checked_layers(scene: Any, figure: RobotFigure) -> dict[str, CheckedFigure]:
    """The convex bodies that a plan is checked with, and a controller's capsules, by the names of their switches.

    Empty for a robot without collision geometry.
    """
    if not figure.robot.geometry.ngeoms:
        return {}
    return {
        "what is checked": CheckedFigure(scene, figure, "checked", convex_bodies, replaces=True),
        "controller's capsules": CheckedFigure(scene, figure, "capsule", capsules, replaces=False),
    }


def convex_bodies(robot: Robot) -> list[DrawnBody]:
    """The bodies of the collision model; neighbouring ones differ in colour."""
    model = Scene().collision_model(robot)
    found = []
    for item, colour in zip(model.objects[: model.bodies], cycle(style.PIECES), strict=False):
        found += _drawn(item.name, item.parentJoint, item.placement, item.geometry, (*rgb(colour), 1.0))
    return found


def capsules(robot: Robot) -> list[DrawnBody]:
    """The capsules and balls that a controller keeps apart."""
    found = []
    for body in CapsuleBodies.of(robot).items:
        along = body.end - body.start
        length = float(np.linalg.norm(along))
        turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), along).matrix() if length > 0 else np.eye(3)
        shape = coal.Capsule(body.radius, length) if length > 0 else coal.Sphere(body.radius)
        place = pin.SE3(turn, (body.start + body.end) / 2)
        found += _drawn(body.name, body.joint, place, shape, (*rgb(style.ELLIPSOID), AROUND))
    return found


def _drawn(
    name: str, joint: int, place: pin.SE3, shape: coal.CollisionGeometry, colour: tuple[float, float, float, float]
) -> list[DrawnBody]:
    """The body, or nothing for a mesh without triangles and for an endless plane."""
    triangles = None if isinstance(shape, coal.Halfspace | coal.Plane) else triangles_of(shape)
    if triangles is None:
        return []
    vertices = triangles[0] @ place.rotation.T + place.translation
    return [DrawnBody(name=name, joint=joint, vertices=vertices, faces=triangles[1], colour=colour)]
