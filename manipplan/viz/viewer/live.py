"""An arm that moves in real time in the browser; follow_target: drag a target, and a controller follows it."""

import threading
import time
from abc import ABC, abstractmethod
from collections import deque
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.goals.goal import read_configuration
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, flag, instance, number, pose_matrix
from manipplan.symbolic.task import Task
from manipplan.tracking.avoidance import Avoidance
from manipplan.tracking.controller import Controller
from manipplan.tracking.formulations import Formulation, LogDrive
from manipplan.tracking.step import StepStatus
from manipplan.viz import style
from manipplan.viz.motions import drawn_tools, ellipsoid_scale, limits_now
from manipplan.viz.viewer.plan_viewer import Chart, ChartLine, switches, table
from manipplan.viz.viewer.server import HOST, PORT, Page, require_extra
from manipplan.viz.viewer.stage import Backdrop, EllipsoidFigure, RobotFigure, corners, draw_checked_layers, put

#: Pictures per second, and number of pictures per update of the chart and the values.
RATE, EVERY = 25.0, 3
#: Time span of the chart [s].
PAST = 10.0
#: Delay of the steps beyond which the clock is reset instead of catching up [s].
LATE = 0.1


def follow_target(
    robot: Robot,
    formulation: Formulation | None = None,
    *,
    start: ArrayLike | str | None = None,
    dt: float = 0.01,
    task: Task | None = None,
    scene: Scene | None = None,
    port: int = PORT,
    host: str = HOST,
    open_browser: bool = True,
) -> "LiveViewer":
    """Show a target to drag in the browser; the tool follows it in real time while the formulation raises the manipulability.

    Args:
        formulation: of the controller; default LogDrive().
        start: initial configuration (n,), or the name of one of `robot.states`; default `robot.neutral`.
        dt: time step of the controller [s].
        task: rows that are followed; default `robot.default_task`.
        scene: obstacles that the arm avoids; not with Classical.
        port, host, open_browser: as for `show`.

    The page stays open until `stop`, or until Python exits: call `wait()` in a script.

    Raises:
        MissingExtraError: viser is not installed.
        InvalidInputError: an argument is not usable, or the port is in use.
    """
    q, scene, avoidance = read_live(robot, start, scene, open_browser=open_browser)
    controller = Controller(robot, formulation or LogDrive(), dt=dt, task=task, avoidance=avoidance)
    viewer = LiveViewer(controller, q, scene, port=port, host=host)
    if open_browser:
        viewer.open()
    return viewer


def read_live(
    robot: Robot, start: ArrayLike | str | None, scene: Scene | None, *, open_browser: bool
) -> tuple[Array, Scene, Avoidance | None]:
    """The start (n,), the scene and the avoidance for the arguments of a live page; raises as `follow_target` does."""
    require_extra()
    instance("robot", robot, Robot)
    flag("open_browser", open_browser)
    scene = instance("scene", scene if scene is not None else Scene(), Scene)
    q = robot.configuration("start", robot.neutral if start is None else read_configuration("start", start, robot))
    return q, scene, Avoidance(scene=scene) if scene.obstacles else None


class LiveArm(Page, ABC):
    """A page on which an arm moves: what `_step` returns is its velocity for the next time step.

    Attributes:
        arm: the robot.
        dt: time step [s].
    """

    #: Margin of the view on each side of the arm's initial posture, as a share of its diagonal.
    room = 0.3

    def __init__(
        self, robot: Robot, task: Task, dt: float, start: Array, scene: Scene, *, title: str, port: int, host: str
    ) -> None:
        super().__init__(port, host, title)
        self.arm, self.dt = robot, dt
        self._first, self._q, self._qd = start, start.copy(), np.zeros(robot.n)
        self._kinematics = robot.kinematics(task)
        self._position = drawn_tools(robot)[0]
        self._lock = threading.RLock()
        self._past: deque[tuple[float, float]] = deque(maxlen=int(PAST * RATE))
        with self._furnishing():
            self._furnish(scene)
            self._fill_panel()
        self._start(self._run)

    @property
    def q(self) -> Array:
        """Current configuration (n,)."""
        with self._lock:
            return self._q.copy()

    @property
    def pose(self) -> Array:
        """Current pose of the tool, (4, 4)."""
        return np.asarray(self._position.pose(self.q))

    def restart(self) -> None:
        """Move the arm back to the start."""
        with self._lock:
            self._q, self._qd = self._first.copy(), np.zeros(self.arm.n)

    @abstractmethod
    def _step(self) -> Array:
        """Velocities (n,) for the next time step; the lock is held."""

    def _rows(self, q: Array, m: float) -> list[tuple[str, str]]:
        """Names and values in the panel at q (n,) with the measure m."""
        return [("measure now", f"{m:.4g}"), *limits_now(self.arm, q, self._qd)]

    def _furnish(self, scene: Scene) -> None:
        robot = self.arm
        box = corners(robot, self._first, moving=True)
        size = float(np.linalg.norm(box[1] - box[0]))
        scale = ellipsoid_scale(robot, [self._position], self._first[None])
        box[:, :2] += [[-self.room * size], [self.room * size]]
        self.robot = RobotFigure(self.server.scene, "/robot", robot)
        self.ellipsoid = EllipsoidFigure(self.server.scene, "/ellipsoid", self._position, scale, opacity=0.5)
        self._add_handles(size)
        self._layers = {"ellipsoid, tool": self.ellipsoid.mesh}
        self._layers |= Backdrop(self.server, robot, self._first, scene, box).layers
        self._layers |= draw_checked_layers(self.server.scene, self.robot)

    def _add_handles(self, size: float) -> None:
        """Add what can be dragged, for an arm of this size [m]."""

    def _fill_panel(self) -> None:
        gui = self.server.gui
        self._add_controls(gui)
        gui.add_button("Back to the start", icon="player-skip-back").on_click(lambda _: self.restart())
        self._picture = gui.add_html("")
        self._values = gui.add_html("")
        switches(gui, self._layers)

    def _add_controls(self, gui: Any) -> None:
        """Add the controls of the panel."""

    def _run(self) -> None:
        began = due = time.monotonic()
        drawn, count = 0.0, 0
        while self.running:
            with self._lock:
                self._qd = self._step()
                self._q = self._q + self.dt * self._qd
            due += self.dt
            now = time.monotonic()
            if now - drawn >= 1.0 / RATE:
                drawn, count = now, count + 1
                self._draw(now - began, figures=count % EVERY == 1)
                now = time.monotonic()
            if due < now - LATE:
                due = now
            time.sleep(max(due - now, 0.0))

    def _draw(self, now: float, *, figures: bool) -> None:
        q = self._q
        self._past.append((now, float(self._kinematics.manipulability(q))))
        with self.server.atomic():
            self.robot.place(q)
            self.ellipsoid.place(q)
            if figures and len(self._past) > 1:
                t, m = np.array(self._past).T
                curve = ChartLine(name="measure", colour=style.OPTIMUM, values=m)
                self._picture.content = Chart(t=t, curves=[curve], label=style.measure_label(self._kinematics)).html(now)
                self._values.content = table(self._rows(q, m[-1]))


class LiveViewer(LiveArm):
    """A page on which a controller follows a target.

    Attributes:
        controller: computes the steps.
    """

    def __init__(self, controller: Controller, start: Array, scene: Scene, *, port: int, host: str) -> None:
        robot = controller.robot
        self.controller = controller
        self._drive = 1.0
        self._target = np.array(drawn_tools(robot)[0].pose(start))
        self._turns = bool(np.any([row[3:] for row in (*controller.task.world_rows, *controller.task.tool_rows)]))
        title = f"{robot.name}: drag the target"
        super().__init__(robot, controller.task, controller.dt, start, scene, title=title, port=port, host=host)

    @property
    def drive(self) -> float:
        """Factor >= 0 on the formulation's drive; 0: the arm only follows the target."""
        return self._drive

    @drive.setter
    def drive(self, value: float) -> None:
        self._drive = number("drive", value, least=0.0)
        self._raises.value = self._drive > 0.0

    @property
    def target(self) -> Array:
        """The target pose (4, 4); a (4, 4) array or a pin.SE3 can be assigned."""
        with self._lock:
            return self._target.copy()

    @target.setter
    def target(self, value: Any) -> None:
        pose = pose_matrix("target", value)
        with self._lock:
            self._target = np.array(pose)
        put(self.handle, pin.SE3(pose[:3, :3] if self._turns else np.eye(3), pose[:3, 3]))

    def restart(self) -> None:
        """Move arm and target back to the start."""
        with self._lock:
            super().restart()
            self.controller.reset()
        self.target = self._position.pose(self._first)

    def _step(self) -> Array:
        return self.controller.step(self._q, self._qd, self._target, drive=self.drive)

    def _add_handles(self, size: float) -> None:
        self.handle = self.server.scene.add_transform_controls(
            "/target",
            scale=0.18 * size,
            active_axes=(True, True, not self.arm.planar),
            disable_rotations=not self._turns,
            depth_test=False,
        )
        self.target = self._target
        self.handle.on_update(self._drag)

    def _drag(self, event: Any) -> None:
        dragged = self.target
        w, x, y, z = event.target.wxyz
        if self._turns:  # otherwise the arrows are aligned with the world
            dragged[:3, :3] = pin.Quaternion(w, x, y, z).normalized().toRotationMatrix()
        dragged[:3, 3] = event.target.position
        with self._lock:
            self._target = dragged

    def _add_controls(self, gui: Any) -> None:
        gui.add_markdown("Drag the arrows at the tool; the arm follows within its limits.")
        drives = self.controller.formulation.solves_qp
        self._raises = raises = gui.add_checkbox("raise the manipulability", initial_value=True, visible=drives)

        def choose(event: Any) -> None:
            if event.client:  # not where the program assigns
                self._drive = float(raises.value)

        raises.on_update(choose)

    def _rows(self, q: Array, m: float) -> list[tuple[str, str]]:
        pose, status = self._position.pose(q), self.controller.report.status
        distance = float(np.linalg.norm(pose[:3, 3] - self._target[:3, 3]))
        turned = np.rad2deg(np.linalg.norm(pin.log3(pose[:3, :3].T @ self._target[:3, :3])))
        away = f"{1e3 * distance:.1f} mm" + (f", {turned:.1f}°" if self._turns else "")
        first, *others = super()._rows(q, m)
        rows = [first, ("tool to target", away), *others]
        if status is StepStatus.STALLED:
            rows.append(("step", "stalled: the arm comes no closer to its target"))
        elif status.brakes:
            rows.append(("step", f"{status.name.lower().replace('_', ' ')}: the arm brakes"))
        return rows
