"""The 3D scene of a motion: both robots, tool paths, ellipsoids, obstacles, floor and camera.

Static parts of the scene: obstacles with their names, the floor, and the initial camera.
"""

from collections.abc import Sequence
from typing import Any

import coal
import numpy as np

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import PointCloud
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.viz import style
from manipplan.viz.shapes import PLANE, evenly_chosen, triangles_of
from manipplan.viz.viewer.figures import EllipsoidFigure, PartFigure, RobotFigure, corners, draw_checked_layers, put
from manipplan.viz.viewer.motion import ShownMotion

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


def look_at(server: Any, box: Array, *, planar: bool) -> None:
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
        camera.look_at = target  # last: moving the camera also moves the point it looks at

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
    look_at(server, np.array([seen.min(axis=0), seen.max(axis=0)]), planar=robot.planar)
    return layers


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
        for each, node, colour in zip(motion.motions, ("/path", "/seed_path"), (style.OPTIMUM, style.SEED), strict=False):
            self.layers[f"path, {each.name}"] = draw_path(scene, node, each.tools, colour)
        self.layers["ellipsoid, tool"] = moving
        self.layers["ellipsoids, path"] = fixed
        self.layers |= surround(server, motion.robot, motion.ours.q[0], motion.scene, motion.box)
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


def draw_path(scene: Any, name: str, ways: Sequence[Array], colour: str) -> Any:
    """Lines through the points (k, 3) of each way [m]; returns viser's handle."""
    pieces = np.concatenate([np.stack([points[:-1], points[1:]], axis=1) for points in ways])
    return scene.add_line_segments(name, pieces, style.rgb(colour), thickness=LINE, thickness_units="screen")
