"""The 3D scene of a motion: robots, the bodies they are checked with, carried parts, ellipsoids and tool paths that move.

Static parts of the scene: obstacles with their names, the floor, and the initial camera.
"""

import threading
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle, PointCloud
from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.robots.attached import Solid
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.viz import style
from manipplan.viz.motions import DrawnTool, MotionSamples, ShownMotion
from manipplan.viz.shapes import PLANE, Faces, evenly_chosen, fit_camera, triangles_of
from manipplan.viz.viewer.bodies import DrawnBody, appearance_of, capsules, convex_bodies

#: Opacity of the ghost robot shown for comparison.
GHOST = 0.45
#: Half thickness of a drawn ellipse, as a share of its larger radius.
THIN = 0.02


class RobotFigure:
    """A robot in the scene under `root`.

    Attributes:
        root: viser's handle of the whole robot; its `visible` shows and hides it.
        frames: viser's handles of the world frame and the joint frames.
        meshes: viser's handles of the drawn bodies.
    """

    def __init__(self, scene: Any, root: str, robot: Robot) -> None:
        self.robot = robot
        self._data = robot.model.createData()
        self.root: Any = scene.add_frame(root, show_axes=False)
        self.frames: list[Any] = [scene.add_frame(f"{root}/{i}", show_axes=False) for i in range(robot.model.njoints)]
        self._bodies = appearance_of(robot).bodies
        self.meshes: list[Any] = [
            draw_body(scene, f"{root}/{body.joint}/{k}", body, body.colour, casts=True) for k, body in enumerate(self._bodies)
        ]
        self.place(robot.neutral)

    def paint(self, ghost: str | None) -> None:
        """Draw the robot in its own colours, or translucent in one colour, without what does not move."""
        for mesh, body in zip(self.meshes, self._bodies, strict=True):
            red, green, blue, opacity = body.colour if ghost is None else (*style.rgb(ghost), GHOST)
            mesh.color = tuple(round(255 * each) for each in (red, green, blue))
            mesh.opacity = opacity if opacity < 1 else None
            mesh.cast_shadow, mesh.visible = ghost is None, ghost is None or body.joint > 0

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


@cache
def _ball() -> tuple[Array, Faces]:
    return triangles_of(coal.Sphere(1.0))


class EllipsoidFigure:
    """The velocity ellipsoid of the tool's position in the scene.

    `scale`: metres drawn per unit of its radii.
    """

    def __init__(
        self, scene: Any, name: str, tool: DrawnTool, scale: float, *, opacity: float, colour: str = style.ELLIPSOID
    ) -> None:
        self._tool, self._scale = tool, scale
        self.mesh: Any = scene.add_mesh_simple(
            name,
            *_ball(),
            color=style.rgb(colour),
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


#: Directions from the contents of the view to the camera: for arms in space, and for planar arms, which are seen from above.
FROM = {False: (1.0, -1.25, 0.6), True: (0.0, -0.55, 1.0)}
#: Vertical field of view of the camera [rad], and the ratio of width to height of the pictures that it holds for; the script of
#: the page widens it in narrower ones.
VIEW, WIDE = np.deg2rad(45.0), 1.5
#: Share of the picture that is filled, and minimum distance of what is shown from the camera [m].
FILLED, NEAREST = 0.94, 0.1
#: Distance beyond the arm up to which obstacles and static parts of the robot are in the view, as a share of the diagonal of
#: the arm's workspace box.
NEAR = 0.2
#: Maximum number of points that are drawn of a cloud.
POINTS = 5000


class ObstaclesFigure:
    """The obstacles in the scene under `root`, with their names where these are wanted.

    Attributes:
        root: viser's handle of all of them.
        frames: viser's handles of each, at its pose.
        names: viser's handle of the names; None without them.
        points: the corners of the boxes around all but planes (k, 3) [m].
    """

    def __init__(self, scene: Any, root: str, obstacles: Scene, *, named: bool = True) -> None:
        self.root: Any = scene.add_frame(root, show_axes=False)
        self.frames: list[Any] = []
        self.names: Any = scene.add_frame(f"{root}/names", show_axes=False) if named else None
        self._labels: list[tuple[Any, Array]] = []
        seen = [np.empty((0, 3))]
        for k, (name, obstacle) in enumerate(zip(obstacles.names, obstacles.obstacles, strict=True)):
            self.frames.append(scene.add_frame(f"{root}/{k}", show_axes=False))
            points = _draw_obstacle(scene, f"{root}/{k}", obstacle)
            placed = points @ obstacle.pose.rotation.T + obstacle.pose.translation
            if len(points):
                seen.append(_corners_of(placed))
                above = np.append(seen[-1][:, :2].mean(axis=0), placed[:, 2].max() + 0.02)
            else:  # a plane: its name beside the arm in the initial view
                turn = obstacle.pose.rotation
                above = obstacle.pose.translation - 0.1 * PLANE * (turn[:, 0] + turn[:, 1]) + [0.0, 0.0, 0.02]
            if named:
                options = {"anchor": "bottom-center", "font_screen_scale": 0.8, "depth_test": False}
                label = scene.add_label(f"{root}/names/{k}", name, **options)
                self._labels.append((label, above - obstacle.pose.translation))
            self.place(k, obstacle.pose)
        self.points = np.concatenate(seen)

    def place(self, k: int, pose: pin.SE3) -> None:
        """Move an obstacle."""
        put(self.frames[k], pose)
        if self._labels:
            label, above = self._labels[k]
            label.position = pose.translation + above


def _draw_obstacle(scene: Any, name: str, obstacle: Obstacle) -> Array:
    """Draw an obstacle in the frame `name`; returns its points (k, 3) there [m], none of a plane."""
    if isinstance(obstacle, PointCloud):
        points = evenly_chosen(obstacle.kept, POINTS).astype(np.float32)
        options = {"point_size": 2 * obstacle.parts()[0].radius, "point_shape": "circle", "precision": "float32"}
        scene.add_point_cloud(f"{name}/0", points, style.rgb(style.OBSTACLE), **options)
        return obstacle.kept
    seen = [np.empty((0, 3))]
    for i, shape in enumerate(obstacle.shapes()):
        vertices, faces = triangles_of(shape)
        endless = isinstance(shape, coal.Halfspace)
        scene.add_mesh_simple(
            f"{name}/{i}",
            vertices,
            faces,
            color=style.rgb(style.OBSTACLE),
            opacity=0.18 if endless else 0.55,
            side="double",
            cast_shadow=not endless,
        )
        seen += [] if endless else [vertices]
    return np.concatenate(seen)


#: Colour of the grid, as far from the white as from the dark background of the page, with fine lines.
GRID = (136, 140, 146)


def draw_floor(scene: Any, height: float, size: float) -> Any:
    """A grid of squares of 10 cm, or of 1 m under a large robot, and the axes of the world; returns the grid's handle."""
    cell = 0.1 if size < 3 else 1.0
    grid = scene.add_grid(
        "/floor",
        width=max(2 * size, 20 * cell),
        height=max(2 * size, 20 * cell),
        cell_size=cell,
        section_size=5 * cell,
        cell_color=GRID,
        section_color=GRID,
        cell_thickness=0.4,
        section_thickness=0.7,
        position=(0.0, 0.0, height - 1e-3),
        shadow_opacity=0.12,
    )
    scene.add_frame("/base", axes_length=0.12 * size, axes_radius=0.0025 * size, origin_radius=0.004 * size)
    return grid


def right_of(robot: Robot) -> Array:
    """The direction (3,) that points to the right in the initial view."""
    right = np.cross([0.0, 0.0, 1.0], FROM[robot.planar])
    return np.asarray(right / np.linalg.norm(right))


class Layer:
    """Nodes of the scene that are shown and hidden together."""

    def __init__(self, *nodes: Any) -> None:
        self.nodes = nodes

    @property
    def visible(self) -> bool:
        """Whether they are shown."""
        return bool(self.nodes[0].visible)

    @visible.setter
    def visible(self, value: bool) -> None:
        for node in self.nodes:
            node.visible = value


class Apart:
    """The switch by which the seed stands beside the motion, or at the same place."""

    def __init__(self, stage: "Stage") -> None:
        self._stage = stage

    @property
    def visible(self) -> bool:
        """Whether it stands beside the motion."""
        return self._stage.apart

    @visible.setter
    def visible(self, value: bool) -> None:
        self._stage.apart = value


class Backdrop:
    """Obstacles, floor and camera around an arm that starts at q (n,) and moves among points (k, 3) [m].

    Attributes:
        obstacles: figures of the obstacles: first those with names.
        layers: what can be shown and hidden, by the names of their switches.
        aside: where the second of two motions stands [m], to the left of the first; zero where there is one.
        size: the diagonal of the box around the points [m].
    """

    def __init__(
        self, server: Any, robot: Robot, q: Array, obstacles: Scene, points: Array, *, beside: str = "", wide: float = WIDE
    ) -> None:
        """`beside`: name of the frame of a second motion, among obstacles of its own; `wide`: as for `Stage`."""
        box = np.array([points.min(axis=0), points.max(axis=0)])
        scene, size = server.scene, float(np.linalg.norm(box[1] - box[0]))
        self.size = size
        self.obstacles = [ObstaclesFigure(scene, "/obstacles", obstacles)]
        if beside:
            self.obstacles.append(ObstaclesFigure(scene, f"{beside}/obstacles", obstacles, named=False))
        around, whole = self.obstacles[0].points, _corners_of(corners(robot, q, moving=False))
        near = np.clip(np.concatenate([around, whole]), box[0] - NEAR * size, box[1] + NEAR * size)
        seen, right = np.concatenate([points, near]), right_of(robot)
        self.aside = -APART * float(np.ptp(seen @ right)) * right if beside else np.zeros(3)
        grid = draw_floor(scene, float(min(whole[0, 2], *around[:, 2], box[0, 2])), size + float(np.linalg.norm(self.aside)))
        self.layers: dict[str, Any] = {}
        if obstacles.obstacles:
            self.layers["obstacles"] = Layer(*(each.root for each in self.obstacles))
            self.layers["names"] = self.obstacles[0].names
        self.layers["grid"] = grid
        _fit_view(server, np.concatenate([seen, seen + self.aside]), wide, planar=robot.planar)


def _corners_of(points: Array) -> Array:
    """The corners (8, 3) of the box around points (k, 3)."""
    return np.array(np.meshgrid(*np.array([points.min(axis=0), points.max(axis=0)]).T)).reshape(3, -1).T


def _fit_view(server: Any, points: Array, wide: float, *, planar: bool) -> None:
    """Place the camera so that points (k, 3) [m] fill the picture; z is up."""
    ahead = -np.array(FROM[planar]) / np.linalg.norm(FROM[planar])
    up = FILLED * np.tan(VIEW / 2)
    target, place = fit_camera(points, ahead, (-wide * up, wide * up), (-up, up), nearest=NEAREST)
    camera = server.initial_camera
    camera.up, camera.fov, camera.near = (0.0, 0.0, 1.0), VIEW, 0.01 * float(np.linalg.norm(target - place))
    camera.position, camera.look_at = place, target


#: Thickness of a drawn path [px], and number of places along it at which ellipsoids are drawn.
LINE, ELLIPSOIDS = 3.0, 7
#: The frame of the second motion, and in it that of what is shown only where it stands beside the first.
BESIDE, APART_ONLY = "/beside", "/beside/apart"
#: Distance of two motions that are drawn beside each other, as a share of the width of one.
APART = 1.02


class MotionFigure:
    """One motion: the arm on it, the ways of its tools, ellipsoids and a title.

    Attributes:
        ellipsoids: the ellipsoid at each tool.
        path, moving, fixed, title: viser's handles of ways, ellipsoids at the tool, ellipsoids on the way, and the title.
    """

    def __init__(self, scene: Any, root: str, own: str, motion: ShownMotion, samples: MotionSamples) -> None:
        """`root`, `own`: names of the frame of arm and way, and of that of ellipsoids and title."""
        self.samples = samples
        self.robot = RobotFigure(scene, f"{root}/robot", motion.robot)
        pieces = np.concatenate([np.stack([way[:-1], way[1:]], axis=1) for way in samples.tools])
        colour = style.rgb(samples.colour)
        self.path = scene.add_line_segments(f"{root}/path", pieces, colour, thickness=LINE, thickness_units="screen")
        self.moving, self.fixed = (scene.add_frame(f"{own}/{each}", show_axes=False) for each in ("ellipsoid", "ellipsoids"))
        self.ellipsoids: list[EllipsoidFigure] = []
        paint = style.ELLIPSOID if samples is motion.ours else samples.colour
        for i, tool in enumerate(motion.tools):
            moving = EllipsoidFigure(scene, f"{own}/ellipsoid/{i}", tool, motion.scale, opacity=0.5, colour=paint)
            self.ellipsoids.append(moving)
            for k, q in enumerate(evenly_chosen(samples.q, ELLIPSOIDS)):
                name = f"{own}/ellipsoids/{i}_{k}"
                EllipsoidFigure(scene, name, tool, motion.scale, opacity=0.18, colour=paint).place(q)
        title = f"{samples.name}: m ≥ {motion.minimum(samples, digits=3)}"
        self.title = scene.add_label(f"{own}/title", title, anchor="bottom-center", depth_test=False)

    def place(self, q: Array) -> None:
        """Move arm and ellipsoids to q (n,)."""
        self.robot.place(q)
        for ellipsoid in self.ellipsoids:
            ellipsoid.place(q)


class Stage:
    """The drawing of a motion in the scene of a viser server.

    Attributes:
        figures: the figure of each of its motions, first that of the motion itself.
        around: obstacles, floor and camera.
        parts: figures of the parts that a program moves.
        layers: what can be shown and hidden, by the name of its switch: each has the attribute `visible`.
    """

    def __init__(self, server: Any, motion: ShownMotion, wide: float = WIDE) -> None:
        """`wide`: width of the picture over its height."""
        scene = server.scene
        self.motion = motion
        self._beside: tuple[Any, ...] = ()
        if motion.seed is not None:
            self._beside = tuple(scene.add_frame(name, show_axes=False) for name in (BESIDE, APART_ONLY))
        roots = (("", ""), (BESIDE, APART_ONLY))
        self.figures = [MotionFigure(scene, *each, motion, one) for one, each in zip(motion.motions, roots, strict=False)]
        ours, names = self.figures[0], [each.samples.name for each in self.figures]
        self.layers: dict[str, Any] = {"side by side": Apart(self)} if self._beside else {}
        self.layers |= {name: each.robot.root for name, each in zip(names, self.figures, strict=True)}
        self.layers |= {f"path, {name}": each.path for name, each in zip(names, self.figures, strict=True)}
        self.layers["ellipsoid, tool"] = Layer(*(each.moving for each in self.figures))
        self.layers["ellipsoids, path"] = Layer(*(each.fixed for each in self.figures))
        some = (q for each in motion.motions for q in each.q[:: len(motion.motions) * len(motion.t) // 12])
        points = np.concatenate([_corners_of(corners(motion.robot, q, moving=True)) for q in some])
        beside = APART_ONLY if self._beside else ""
        self.around = Backdrop(server, motion.robot, ours.samples.q[0], motion.scene, points, beside=beside, wide=wide)
        self.layers |= self.around.layers
        self.layers |= draw_checked_layers(scene, ours.robot)
        if motion.moved:
            self.layers["parts"] = scene.add_frame("/parts", show_axes=False)
        self.parts = [PartFigure(scene, f"/parts/{k}", part.solid) for k, part in enumerate(motion.moved)]
        for each in self.figures:
            low, high = points.min(axis=0), points.max(axis=0)
            each.title.position = np.append((low + high)[:2] / 2, high[2] + 0.04 * (high - low)[2])
        self.apart = bool(self._beside)
        self.place(0.0)

    @property
    def apart(self) -> bool:
        """Whether the seed stands beside the motion, in the colours of the arm, instead of translucent at the same place."""
        return self._apart

    @apart.setter
    def apart(self, value: bool) -> None:
        self._apart = value
        self.figures[0].title.visible = value
        if self._beside:
            root, only = self._beside
            root.position = self.around.aside if value else np.zeros(3)
            only.visible = value
            self.figures[1].robot.paint(None if value else style.SEED)

    def place(self, t: float, q: Array | None = None) -> None:
        """Move all moving parts to their poses at time t [s], the arm to q (n,) where it is given."""
        q = self.motion.trajectory(t) if q is None else q
        self.figures[0].place(q)
        for part, figure in zip(self.motion.moved, self.parts, strict=True):
            figure.place(part.at(t, self.motion.robot, q))
        for each in self.figures[1:]:
            each.place(each.samples.at(t))
