"""Pictures of a robot among obstacles, lit and shaded, by MuJoCo's renderer: no display and no graphics card are needed."""

import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Self

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Plane
from manipplan.measures.ellipsoid import Ellipsoid
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import ManipplanError
from manipplan.viz import style
from manipplan.viz.motions import arm_length
from manipplan.viz.shapes import Faces, faces_of, fit_camera, obstacle_surfaces, triangles_of
from manipplan.viz.viewer.bodies import appearance_of

Picture = NDArray[np.uint8]

#: Pixels rendered per pixel shown, in each direction.
FINER = 2
#: Direction in which the camera looks: azimuth and elevation [°]; vertical field of view [°].
AZIMUTH, ELEVATION, FIELD = 140.0, -20.0, 45.0
#: Share of the picture's width and height that what is shown fills.
FILLED = 0.94
#: Least distance of what is shown from the camera [m].
NEAREST = 0.2
#: Background, light and dark.
GROUND = {False: (0.955, 0.96, 0.97), True: (0.135, 0.15, 0.175)}
#: Colour of obstacles that are larger than the arm, such as tables and floors, light and dark.
LARGE = {False: (0.86, 0.84, 0.81, 1.0), True: (0.34, 0.35, 0.37, 1.0)}
#: Radius of a line ahead of the tool, and of the way that it has gone [m].
AHEAD, GONE = 0.005, 0.0075
#: Maximum number of shapes in a picture.
MOST_SHAPES = 4000
#: Smallest radius of an ellipsoid [m].
THIN = 0.004


@dataclass(frozen=True, kw_only=True)
class DrawnWay:
    """A line through points (k, 3) [m], drawn thick up to the share `done` of its points."""

    points: Array
    colour: str
    done: float = 1.0


class Renderer:
    """Renders one robot among obstacles; a context manager, as its buffers have to be freed."""

    def __init__(
        self,
        robot: Robot,
        scene: Scene,
        shown: Array,
        size: tuple[int, int],
        *,
        dark: bool = False,
        direction: tuple[float, float] = (AZIMUTH, ELEVATION),
    ) -> None:
        """Build the model and place the camera.

        Args:
            shown: (k, 3) points that have to be in the picture [m], beside the obstacles.
            size: width and height [pixels].
            direction: azimuth and elevation in which the camera looks [°].

        Raises ManipplanError where MuJoCo cannot render.
        """
        import mujoco

        self.robot, self.size = robot, size
        self._data = robot.model.createData()
        spec, points = self._world(mujoco, dark), [shown]
        for k, body in enumerate(appearance_of(robot).bodies):
            colour = (*(0.93 * np.array(body.colour[:3])), body.colour[3])
            _add_mesh(mujoco, spec, spec.body(f"joint {body.joint}"), f"body {k}", body.vertices, body.faces, colour)
        reach = arm_length(robot)
        for k, (vertices, faces) in enumerate(_obstacles(scene)):
            is_large = np.linalg.norm(np.ptp(vertices, axis=0)) > reach
            colour = LARGE[dark] if is_large else (*style.rgb(style.OBSTACLE), 0.92)
            _add_mesh(mujoco, spec, spec.worldbody, f"obstacle {k}", vertices, faces, colour)
            points += [] if is_large else [vertices]
        self._model = spec.compile()
        self._state = mujoco.MjData(self._model)
        self._mocap = [self._model.body(f"joint {k}").mocapid[0] for k in range(robot.model.njoints)]
        self._camera = mujoco.MjvCamera()
        self._camera.lookat[:], self._camera.distance = _fit(np.concatenate(points), size[0] / size[1], direction)
        self._camera.azimuth, self._camera.elevation = direction
        self._rectangle = mujoco.MjrRect(0, 0, FINER * size[0], FINER * size[1])
        self._shown, self._options = mujoco.MjvScene(self._model, maxgeom=MOST_SHAPES), mujoco.MjvOption()
        try:
            self._screen = _context_type()(FINER * size[0], FINER * size[1])
            self._screen.make_current()
            self._buffers = mujoco.MjrContext(self._model, mujoco.mjtFontScale.mjFONTSCALE_100)
        except Exception as error:  # each of the libraries that can be used has errors of its own
            raise ManipplanError(f"MuJoCo cannot render here: {str(error).rstrip('.')}. {REMEDY}") from error
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN, self._buffers)

    def _world(self, mujoco: Any, dark: bool) -> Any:
        """Light, background, and a body for each joint."""
        spec = mujoco.MjSpec()
        spec.visual.global_.offwidth, spec.visual.global_.offheight = FINER * self.size[0], FINER * self.size[1]
        spec.visual.global_.fovy, spec.visual.quality.shadowsize, spec.visual.map.znear = FIELD, 4096, 0.02
        headlight = spec.visual.headlight
        headlight.ambient, headlight.diffuse, headlight.specular = [0.46] * 3, [0.20] * 3, [0.02] * 3
        flat = mujoco.mjtBuiltin.mjBUILTIN_FLAT
        sky = spec.add_texture(name="sky", type=mujoco.mjtTexture.mjTEXTURE_SKYBOX, builtin=flat, width=64, height=64)
        sky.rgb1 = sky.rgb2 = GROUND[dark]  # the second is that of the face below
        sun = mujoco.mjtLightType.mjLIGHT_DIRECTIONAL
        light = {"pos": [1.2, -1.6, 3.2], "dir": [-0.36, 0.5, -1.0], "diffuse": [0.46] * 3, "specular": [0.05] * 3}
        spec.worldbody.add_light(type=sun, castshadow=True, **light)
        for k in range(self.robot.model.njoints):
            spec.worldbody.add_body(name=f"joint {k}", mocap=True)
        return spec

    def draw(
        self, q: Array, lines: Sequence[DrawnWay] = (), ellipsoids: Sequence[tuple[Ellipsoid, Array, float, str]] = ()
    ) -> Picture:
        """A picture (height, width, 3) at q (n,) with ways of tools.

        The ellipsoids come with their centres (3,) [m], metres per unit of their radii, and colours.
        """
        import mujoco

        pin.forwardKinematics(self.robot.model, self._data, q)
        for mocap, place in zip(self._mocap, self._data.oMi, strict=True):
            self._state.mocap_pos[mocap] = place.translation
            self._state.mocap_quat[mocap] = pin.Quaternion(place.rotation).coeffs()[[3, 0, 1, 2]]
        mujoco.mj_forward(self._model, self._state)
        every = mujoco.mjtCatBit.mjCAT_ALL
        mujoco.mjv_updateScene(self._model, self._state, self._options, None, self._camera, every, self._shown)
        for line in lines:
            self._add_line(mujoco, line)
        for ellipsoid, centre, scale, colour in ellipsoids:
            radii = np.maximum(scale * np.asarray(ellipsoid.radii), THIN)
            axes = np.asarray(ellipsoid.axes) * [1.0, 1.0, np.sign(np.linalg.det(ellipsoid.axes))]
            self._add(mujoco, mujoco.mjtGeom.mjGEOM_ELLIPSOID, radii, centre, axes, (*style.rgb(colour), 0.45))
        width, height = self.size
        fine = np.empty((FINER * height, FINER * width, 3), dtype=np.uint8)
        self._screen.make_current()
        mujoco.mjr_render(self._rectangle, self._shown, self._buffers)
        mujoco.mjr_readPixels(fine, None, self._rectangle, self._buffers)  # the lowest row comes first
        return np.asarray(fine[::-1].reshape(height, FINER, width, FINER, 3).mean(axis=(1, 3)).round(), dtype=np.uint8)

    def _add_line(self, mujoco: Any, line: DrawnWay) -> None:
        for k in range(len(line.points) - 1):
            gone = k < line.done * (len(line.points) - 1)
            colour = (*style.rgb(line.colour), 1.0 if gone else 0.35)
            geom = self._add(mujoco, mujoco.mjtGeom.mjGEOM_CAPSULE, np.zeros(3), np.zeros(3), np.eye(3), colour)
            kind, radius = mujoco.mjtGeom.mjGEOM_CAPSULE, GONE if gone else AHEAD
            mujoco.mjv_connector(geom, kind, radius, line.points[k], line.points[k + 1])

    def _add(self, mujoco: Any, kind: Any, size: Array, centre: Array, axes: Array, colour: Sequence[float]) -> Any:
        """A shape of this picture only."""
        scene = self._shown
        geom = scene.geoms[scene.ngeom]
        mujoco.mjv_initGeom(geom, kind, size, centre, np.asarray(axes).ravel(), np.array(colour, dtype=np.float32))
        scene.ngeom += 1
        return geom

    def close(self) -> None:
        """Free the buffers."""
        self._buffers.free()
        self._screen.free()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()


#: What helps where no picture can be made.
REMEDY = "On Linux it needs EGL: sudo apt-get install libegl1 libgl1-mesa-dri"


def _context_type() -> Any:
    """The class of a place to render to: of EGL on Linux, unless the variable MUJOCO_GL names another library."""
    if sys.platform == "linux" and not os.environ.get("MUJOCO_GL"):
        from mujoco.egl import GLContext
    else:
        from mujoco.gl_context import GLContext
    return GLContext


def _add_mesh(mujoco: Any, spec: Any, body: Any, name: str, vertices: Array, faces: Faces, colour: Sequence[float]) -> None:
    vertices = np.concatenate([vertices, *[vertices[:1]] * max(4 - len(vertices), 0)])  # MuJoCo wants four
    mesh = spec.add_mesh(name=name, uservert=vertices.ravel(), userface=faces.ravel().astype(np.int32))
    mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    kind = mujoco.mjtGeom.mjGEOM_MESH
    body.add_geom(type=kind, meshname=name, rgba=list(colour), contype=0, conaffinity=0)


def _obstacles(scene: Scene) -> list[tuple[Array, Faces]]:
    """Vertices (v, 3) [m] and faces (f, 3) of each obstacle in the world."""
    made = []
    for _, surface in obstacle_surfaces(scene):
        fans = [face[[0, k, k + 1]] for face in surface.faces for k in range(1, len(face) - 1)]
        made.append(faces_of(np.array(fans)))
    for each in scene.obstacles:
        if isinstance(each, Plane):
            vertices, faces = triangles_of(each.shapes()[0])
            made.append((vertices @ each.pose.rotation.T + each.pose.translation, faces))
    return made


def _fit(points: Array, wide: float, direction: tuple[float, float] = (AZIMUTH, ELEVATION)) -> tuple[Array, float]:
    """Where the camera looks, (3,), and its distance [m], so that points (k, 3) fill a picture `wide` times as wide as high."""
    azimuth, elevation = np.deg2rad(direction)
    ahead = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    across, up = FILLED * np.tan(np.deg2rad(FIELD) / 2) * np.array([wide, 1.0])
    target, camera = fit_camera(points, ahead, (-across, across), (-up, up), nearest=NEAREST)
    return target, float(np.linalg.norm(target - camera))
