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
from manipplan.collision.shapes import PointCloud
from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.robots.attached import Solid
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.viz import style
from manipplan.viz.motions import DrawnTool, ShownMotion
from manipplan.viz.shapes import PLANE, Faces, evenly_chosen, triangles_of
from manipplan.viz.viewer.bodies import DrawnBody, appearance_of, capsules, convex_bodies

#: Opacity of the ghost robot shown for comparison.
GHOST = 0.45
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


@cache
def _ball() -> tuple[Array, Faces]:
    return triangles_of(coal.Sphere(1.0))


class EllipsoidFigure:
    """The velocity ellipsoid of the tool's position in the scene.

    `scale`: metres drawn per unit of its radii.
    """

    def __init__(self, scene: Any, name: str, tool: DrawnTool, scale: float, *, opacity: float) -> None:
        self._tool, self._scale = tool, scale
        self.mesh: Any = scene.add_mesh_simple(
            name,
            *_ball(),
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
#: Vertical field of view of the camera [rad].
VIEW = np.deg2rad(45.0)
#: Factor on the camera's distance: the bounding sphere slightly exceeds the picture, as its outermost parts are empty.
FILL = 0.92
#: Distance beyond the arm up to which obstacles and static parts of the robot are in the view, as a share of the diagonal of
#: the arm's workspace box.
NEAR = 0.2
#: Maximum number of points that are drawn of a cloud.
POINTS = 5000


def draw_obstacles(scene: Any, obstacles: Scene) -> tuple[Any, Any, Array]:
    """Draw obstacles; returns viser's handles of bodies and of names, and the box corners of all but planes (k, 3) [m]."""
    bodies = scene.add_frame("/obstacles", show_axes=False)
    names = scene.add_frame("/names", show_axes=False)
    seen = [np.empty((0, 3))]
    for k, (name, obstacle) in enumerate(zip(obstacles.names, obstacles.obstacles, strict=True)):
        top, above = -np.inf, obstacle.pose.translation.copy()
        if isinstance(obstacle, PointCloud):
            points = evenly_chosen(obstacle.kept, POINTS).astype(np.float32)
            size = 2 * obstacle.parts()[0].radius
            cloud = scene.add_point_cloud(
                f"/obstacles/{k}", points, style.rgb(style.OBSTACLE), point_size=size, point_shape="circle", precision="float32"
            )
            put(cloud, obstacle.pose)
            placed = obstacle.kept @ obstacle.pose.rotation.T + obstacle.pose.translation
            top = placed[:, 2].max()
            above = (placed.min(axis=0) + placed.max(axis=0)) / 2  # its frame is often that of the camera
            seen.append(np.array([placed.min(axis=0), placed.max(axis=0)]))
        for i, shape in enumerate(() if isinstance(obstacle, PointCloud) else obstacle.shapes()):
            vertices, faces = triangles_of(shape)
            endless = isinstance(shape, coal.Halfspace)
            mesh = scene.add_mesh_simple(
                f"/obstacles/{k}/{i}",
                vertices,
                faces,
                color=style.rgb(style.OBSTACLE),
                opacity=0.18 if endless else 0.55,
                side="double",
                cast_shadow=not endless,
            )
            put(mesh, obstacle.pose)
            placed = vertices @ obstacle.pose.rotation.T + obstacle.pose.translation
            top = max(top, placed[:, 2].max()) if not endless else top
            if not endless:
                seen.append(np.array([placed.min(axis=0), placed.max(axis=0)]))
        above[2] = max(above[2], top) + 0.02
        if not np.isfinite(top):  # a plane: its name beside the arm in the initial view
            above -= 0.1 * PLANE * (obstacle.pose.rotation[:, 0] + obstacle.pose.rotation[:, 1])
        scene.add_label(f"/names/{k}", name, position=above, anchor="bottom-center", font_screen_scale=0.8, depth_test=False)
    return bodies, names, np.concatenate(seen)


def draw_floor(scene: Any, height: float, size: float) -> Any:
    """A grid of squares of 10 cm, or of 1 m under a large robot, and the axes of the world; returns the grid's handle."""
    cell = 0.1 if size < 3 else 1.0
    grid = scene.add_grid(
        "/floor",
        width=max(2 * size, 20 * cell),
        height=max(2 * size, 20 * cell),
        cell_size=cell,
        section_size=5 * cell,
        cell_color=(226, 228, 232),
        section_color=(200, 204, 210),
        position=(0.0, 0.0, height - 1e-3),
        shadow_opacity=0.12,
    )
    scene.add_frame("/base", axes_length=0.12 * size, axes_radius=0.0025 * size, origin_radius=0.004 * size)
    return grid


def fit_view(server: Any, box: Array, *, planar: bool) -> None:
    """Place the camera so that the box (2, 3) [m] fills the picture on a screen of any aspect ratio; z is up."""
    middle, reach = box.mean(axis=0), max(float(np.linalg.norm(box[1] - box[0])) / 2, 0.05)
    direction = np.array(FROM[planar]) / np.linalg.norm(FROM[planar])
    upward = np.eye(3)[2] - direction[2] * direction

    def place(camera: Any, aspect: float) -> None:
        angle = np.arctan(np.tan(VIEW / 2) * min(aspect, 1.0))
        target = middle if aspect >= 1.0 else middle - 0.7 * reach * upward / np.linalg.norm(upward)  # the panel is below
        camera.fov = VIEW
        camera.near = reach / 100
        camera.position = target + FILL * reach / np.sin(angle) * direction
        camera.fit_view = target  # last: moving the camera also moves the point it looks at

    server.initial_camera.up = (0.0, 0.0, 1.0)
    place(server.initial_camera, 1.0)

    def fit(client: Any) -> None:
        if client.camera.aspect < 1.0:
            place(client.camera, client.camera.aspect)

    server.on_client_connect(fit)


def surround(server: Any, robot: Robot, q: Array, obstacles: Scene, box: Array) -> dict[str, Any]:
    """Obstacles, floor and camera around an arm that starts at q (n,) and moves within the box (2, 3) [m].

    Returns viser's handles by the names of their switches.
    """
    scene, size = server.scene, float(np.linalg.norm(box[1] - box[0]))
    layers, around = {}, np.empty((0, 3))
    if obstacles.obstacles:
        layers["obstacles"], layers["names"], around = draw_obstacles(scene, obstacles)
    whole = corners(robot, q, moving=False)
    layers["grid"] = draw_floor(scene, float(min(whole[0, 2], *around[:, 2], box[0, 2])), size)
    near = np.clip(np.concatenate([around, whole]), box[0] - NEAR * size, box[1] + NEAR * size)
    seen = np.concatenate([box, near])
    fit_view(server, np.array([seen.min(axis=0), seen.max(axis=0)]), planar=robot.planar)
    return layers


#: Thickness of a drawn path [px], and number of places along it at which ellipsoids are drawn.
LINE, ELLIPSOIDS = 3.0, 7


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
            for k, q in enumerate(evenly_chosen(motion.ours.q, ELLIPSOIDS)):
                EllipsoidFigure(scene, f"/ellipsoids/{i}_{k}", tool, motion.scale, opacity=0.18).place(q)
        self.layers: dict[str, Any] = {motion.ours.name: self.robot.root}
        if self.seed is not None and motion.seed is not None:
            self.layers[motion.seed.name] = self.seed.root
        for each, node in zip(motion.motions, ("/path", "/seed_path"), strict=False):
            pieces = np.concatenate([np.stack([way[:-1], way[1:]], axis=1) for way in each.tools])
            lines = scene.add_line_segments(node, pieces, style.rgb(each.colour), thickness=LINE, thickness_units="screen")
            self.layers[f"path, {each.name}"] = lines
        self.layers["ellipsoid, tool"] = moving
        self.layers["ellipsoids, path"] = fixed
        some = (q for each in motion.motions for q in each.q[:: len(motion.motions) * len(motion.t) // 12])
        boxes = np.array([corners(motion.robot, q, moving=True) for q in some])
        box = np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])
        self.layers |= surround(server, motion.robot, motion.ours.q[0], motion.scene, box)
        self.layers |= draw_checked_layers(scene, self.robot)
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
