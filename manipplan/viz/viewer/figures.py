"""Moving parts of the scene: a robot, the bodies it is checked with, a carried part, and the velocity ellipsoid at its tool.

The measure over time as SVG, with a mark at the displayed time; a browser draws it without scripts.
"""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.robots.attached import Solid
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.viz import style
from manipplan.viz.motions import DrawnTool
from manipplan.viz.shapes import triangles_of
from manipplan.viz.viewer.bodies import DrawnBody, appearance_of, capsules, convex_bodies

#: Opacity of the ghost robot shown for comparison.
GHOST = 0.45
#: Largest drawn radius of an ellipsoid, as a share of half the diagonal of the arm's box.
LARGEST = 0.12
#: Half thickness of a drawn ellipse, as a share of its larger radius.
THIN = 0.02


class RobotFigure:
    """A robot in the scene under `root`; with a `ghost` colour, only its moving parts, translucent in that colour.

    Attributes:
        root: viser's handle of the whole robot; its `visible` shows and hides it.
        frames: viser's handles of the world frame and the joint frames.
        meshes: viser's handles of the drawn bodies.
    """

    def __init__(self, scene: Any, root: str, robot: Robot, *, ghost: str | None = None) -> None:
        self.robot = robot
        self._data = robot.model.createData()
        self.root: Any = scene.add_frame(root, show_axes=False)
        self.frames: list[Any] = [scene.add_frame(f"{root}/{i}", show_axes=False) for i in range(robot.model.njoints)]
        self.meshes: list[Any] = []
        for k, body in enumerate(appearance_of(robot).bodies):
            if ghost is not None and not body.joint:
                continue  # it would coincide with that of the other robot
            colour = body.colour if ghost is None else (*style.rgb(ghost), GHOST)
            self.meshes.append(draw_body(scene, f"{root}/{body.joint}/{k}", body, colour, casts=ghost is None))
        self.place(robot.neutral)

    def place(self, q: Array) -> None:
        """Move the robot to q (n,)."""
        pin.forwardKinematics(self.robot.model, self._data, q)
        for frame, placement in zip(self.frames[1:], list(self._data.oMi)[1:], strict=True):
            put(frame, placement)


class PartFigure:
    """A part that moves in the scene, at first where it is given."""

    def __init__(self, scene: Any, name: str, solid: Solid) -> None:
        self.root: Any = scene.add_frame(name, show_axes=False)
        for k, shape in enumerate(solid.shapes()):
            colour = style.rgb(style.OPTIMUM)
            scene.add_mesh_simple(f"{name}/{k}", *triangles_of(shape), color=colour, side="double", receive_shadow=False)
        self.place(solid)

    def place(self, solid: Solid | None) -> None:
        """Move the part to where `solid` is; None hides it."""
        self.root.visible = solid is not None
        if solid is not None:
            put(self.root, solid.pose)


def draw_body(scene: Any, name: str, body: DrawnBody, colour: tuple[float, ...], *, casts: bool) -> Any:
    """Draw a body in a colour with opacity (4,); `casts`: whether it casts a shadow. Returns viser's handle."""
    return scene.add_mesh_simple(
        name,
        body.vertices,
        body.faces,
        color=tuple(colour[:3]),
        opacity=colour[3] if colour[3] < 1 else None,
        side="double",
        cast_shadow=casts,
        receive_shadow=False,
    )


class EllipsoidFigure:
    """The velocity ellipsoid of the tool's position in the scene.

    `scale`: metres drawn per unit of its radii.
    """

    def __init__(self, scene: Any, name: str, tool: DrawnTool, scale: float, *, opacity: float) -> None:
        self._tool, self._scale = tool, scale
        self.mesh: Any = scene.add_mesh_simple(
            name,
            *triangles_of(coal.Sphere(1.0)),
            color=style.rgb(style.ELLIPSOID),
            opacity=opacity,
            cast_shadow=False,
            receive_shadow=False,
        )

    def place(self, q: Array) -> None:
        """Move the ellipsoid to the tool at q (n,)."""
        axes, radii = principal(self._tool, q)
        self.mesh.scale = tuple(float(r) for r in self._scale * radii)
        put(self.mesh, pin.SE3(axes, np.asarray(self._tool.pose(q))[:3, 3]))


def principal(tool: DrawnTool, q: Array) -> tuple[Array, Array]:
    """Axes, a rotation (3, 3), and radii (3,) of the velocity ellipsoid; an ellipse is thin along z."""
    ellipsoid = velocity_ellipsoid(tool.jacobian(q))
    axes, radii = np.eye(3), np.full(3, THIN * ellipsoid.radii[0])
    m = len(ellipsoid.radii)
    axes[:m, :m] = ellipsoid.axes
    radii[:m] = np.maximum(ellipsoid.radii, 0.2 * THIN * ellipsoid.radii[0])  # a flat ellipsoid stays visible
    axes[:, 2] *= np.linalg.det(axes)
    return axes, radii


def ellipsoid_scale(tools: Sequence[DrawnTool], q: Array, box: Array) -> float:
    """Metres to draw per unit of the radii of the ellipsoids at q (k, n), for a robot within the box (2, 3) [m]."""
    largest = max(principal(tool, each)[1].max() for tool in tools for each in q)
    return float(LARGEST * np.linalg.norm(box[1] - box[0]) / 2 / max(largest, 1e-9))


def corners(robot: Robot, q: Array, *, moving: bool) -> Array:
    """Lower and upper corner (2, 3) [m] of the box around the robot at q (n,), or around its moving parts."""
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, q)
    bodies = [body for body in appearance_of(robot).bodies if body.joint or not moving]
    points = [body.vertices @ data.oMi[body.joint].rotation.T + data.oMi[body.joint].translation for body in bodies]
    together = np.concatenate([*points, np.zeros((1, 3))])  # the base is always included
    return np.array([together.min(axis=0), together.max(axis=0)])


def put(handle: Any, placement: pin.SE3) -> None:
    """Set the pose of a scene node."""
    handle.position = np.asarray(placement.translation)
    handle.wxyz = pin.Quaternion(placement.rotation).coeffs()[[3, 0, 1, 2]]


class CheckedFigure:
    """Bodies that are checked for collisions, on the joint frames of a figure; made when they are shown for the first time."""

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


def draw_checked_layers(scene: Any, figure: RobotFigure) -> dict[str, CheckedFigure]:
    """The convex bodies that a plan is checked with, and a controller's capsules, by the names of their switches.

    Empty for a robot without collision geometry.
    """
    if not figure.robot.geometry.ngeoms:
        return {}
    return {
        "what is checked": CheckedFigure(scene, figure, "checked", convex_bodies, replaces=True),
        "controller's capsules": CheckedFigure(scene, figure, "capsule", capsules, replaces=False),
    }


#: Size of the drawing and its margins: left, right, top, bottom [px].
WIDTH, HEIGHT = 300, 170
LEFT, RIGHT, TOP, BOTTOM = 42, 8, 10, 30


@dataclass(frozen=True, kw_only=True, eq=False)
class ChartLine:
    """One curve: its name in the legend, its colour, and its values at the chart's times."""

    name: str
    colour: str
    values: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Chart:
    """Curves over the same times t (k,) [s], on an axis that includes zero; `label` gives quantity and unit.

    `marks`: times [s] with names, drawn as dotted lines that show their name under the mouse.
    """

    t: Array
    curves: Sequence[ChartLine]
    label: str
    marks: Sequence[tuple[float, str]] = ()

    def svg(self, now: float | None = None) -> str:
        """The picture; a line and a dot on each curve mark the time `now` [s]."""
        end, start = float(self.t[-1]), float(self.t[0])
        highest = max([float(np.max(c.values, initial=0.0)) for c in self.curves])
        lowest = min([float(np.min(c.values, initial=0.0)) for c in self.curves])
        highest = highest if highest > lowest else 1.0
        step = _round_step((highest - lowest) / 3)
        top, bottom = float(step * np.ceil(highest * 1.02 / step)), float(step * np.floor(lowest * 1.02 / step))

        across = LEFT + (WIDTH - LEFT - RIGHT) * (self.t - start) / max(end - start, 1e-9)

        def x(t: float) -> float:
            return float(np.interp(t, self.t, across))

        def y(value: float) -> float:
            return float(HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (value - bottom) / (top - bottom))

        parts = []
        for value in np.arange(bottom, top + step / 2, step):
            at = f"{y(value):.1f}"
            parts.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{at}" y2="{at}" stroke="#e4e4e4"/>')
            parts.append(f'<text x="{LEFT - 5}" y="{at}" dy="3.5" text-anchor="end">{value:.6g}</text>')
        time_step = _round_step((end - start) / 4)
        for t in np.arange(np.ceil(start / time_step) * time_step, end + 1e-9, time_step):
            parts.append(f'<text x="{x(t):.1f}" y="{HEIGHT - BOTTOM + 13}" text-anchor="middle">{t:.6g}</text>')
        parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 3}" text-anchor="middle">time [s]</text>')
        for begin, name in self.marks:
            ends = f'x1="{x(begin):.1f}" x2="{x(begin):.1f}" y1="{TOP}" y2="{HEIGHT - BOTTOM}"'
            lines = f'<line {ends} stroke="#999" stroke-dasharray="2 2"/><line {ends} stroke="transparent" stroke-width="6"/>'
            parts.append(f'<g class="mark"><title>{escape(name)}</title>{lines}</g>')
        for curve in reversed(self.curves):
            points = " ".join(f"{place:.1f},{y(value):.1f}" for place, value in zip(across, curve.values, strict=True))
            parts.append(f'<polyline points="{points}" fill="none" stroke="{curve.colour}" stroke-width="2"/>')
        if now is not None:
            here, foot = f"{x(now):.1f}", HEIGHT - BOTTOM
            parts.append(f'<line class="now" x1="{here}" x2="{here}" y1="{TOP}" y2="{foot}" stroke="#333"/>')
            for curve in reversed(self.curves):
                height = f"{y(float(np.interp(now, self.t, curve.values))):.1f}"
                parts.append(f'<circle cx="{here}" cy="{height}" r="4" fill="{curve.colour}" stroke="#fff"/>')
        return (
            f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" width="100%" role="img" aria-label="{escape(self.label)} over time" '
            f'font-family="sans-serif" font-size="10.5" fill="#444">{"".join(parts)}</svg>'
        )

    def html(self, now: float | None = None) -> str:
        """Legend and picture."""
        keys = " ".join(
            f'<span style="white-space:nowrap;margin-right:0.8em"><span style="color:{curve.colour}">&#9644;</span> '
            f"{escape(curve.name)}</span>"
            for curve in self.curves
        )
        keys = f"<br>{keys}" if len(self.curves) > 1 else ""
        return (
            f'<div style="padding:0 0.75em;font:12px sans-serif;color:#333"><div style="margin:0.3em 0">'
            f"{escape(self.label)}{keys}</div>{self.svg(now)}</div>"
        )


def _round_step(rough: float) -> float:
    """1, 2 or 5 times a power of ten, at least `rough`."""
    power = 10.0 ** np.floor(np.log10(max(rough, 1e-12)))
    return float(next(k * power for k in (1, 2, 5, 10) if k * power >= rough * (1 - 1e-9)))
