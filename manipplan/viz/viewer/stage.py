"""The 3D scene of a motion: both robots, tool paths, ellipsoids, obstacles, floor and camera."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from manipplan.support.checks import Array
from manipplan.viz import style
from manipplan.viz.viewer.checked import checked_layers
from manipplan.viz.viewer.figures import EllipsoidFigure, PartFigure, RobotFigure, rgb
from manipplan.viz.viewer.motion import ShownMotion
from manipplan.viz.viewer.surroundings import surround

#: Thickness of a drawn path [px].
LINE = 3.0


class Stage:
    """The drawing of a motion in the scene of a viser server.

    Attributes:
        motion: the motion that is shown.
        robot, seed: figures of the arm on its motion and on the seed; seed is None without a seed.
        ellipsoids: the ellipsoid at each tool.
        parts: figures of the parts that a program moves.
        layers: viser's handles, or a CheckedFigure, by the name of a switch; their `visible` shows and hides them.
    """

    def __init__(self, server: Any, motion: ShownMotion) -> None:
        scene = server.scene
        self.motion = motion
        self.robot = RobotFigure(scene, "/robot", motion.robot)
        self.seed = RobotFigure(scene, "/seed", motion.robot, ghost=style.SEED) if motion.seed is not None else None
        moving, fixed = (scene.add_frame(name, show_axes=False) for name in ("/ellipsoid", "/ellipsoids"))
        self.ellipsoids: list[EllipsoidFigure] = []
        for i, tool in enumerate(motion.tools):
            self.ellipsoids.append(EllipsoidFigure(scene, f"/ellipsoid/{i}", tool, motion.scale, opacity=0.5))
            for k, q in enumerate(motion.places):
                EllipsoidFigure(scene, f"/ellipsoids/{i}_{k}", tool, motion.scale, opacity=0.18).place(q)
        self.layers: dict[str, Any] = {motion.ours.name: self.robot.root}
        if self.seed is not None and motion.seed is not None:
            self.layers[motion.seed.name] = self.seed.root
        for course, node, colour in zip(motion.courses, ("/path", "/seed_path"), (style.OPTIMUM, style.SEED), strict=False):
            self.layers[f"path, {course.name}"] = draw_path(scene, node, course.tools, colour)
        self.layers["ellipsoid, tool"] = moving
        self.layers["ellipsoids, path"] = fixed
        self.layers |= surround(server, motion.robot, motion.ours.q[0], motion.scene, motion.box)
        self.layers |= checked_layers(scene, self.robot)
        if motion.moved:
            self.layers["parts"] = scene.add_frame("/parts", show_axes=False)
        self.parts = [PartFigure(scene, f"/parts/{k}", part.solid) for k, part in enumerate(motion.moved)]
        self.place(0.0)

    def place(self, t: float) -> None:
        """Move all moving parts to their poses at time t [s]."""
        q = self.motion.trajectory(t)
        self.robot.place(q)
        for ellipsoid in self.ellipsoids:
            ellipsoid.place(q)
        for part, figure in zip(self.motion.moved, self.parts, strict=True):
            figure.place(part.at(t, self.motion.robot, q))
        if self.seed is not None and self.motion.seed is not None:
            self.seed.place(self.motion.seed.at(t))


def draw_path(scene: Any, name: str, ways: Sequence[Array], colour: str) -> Any:
    """Lines through the points (k, 3) of each way [m]; returns viser's handle."""
    pieces = np.concatenate([np.stack([points[:-1], points[1:]], axis=1) for points in ways])
    return scene.add_line_segments(name, pieces, rgb(colour), thickness=LINE, thickness_units="screen")
