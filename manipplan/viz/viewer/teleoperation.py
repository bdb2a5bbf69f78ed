"""teleoperate: move the tool of an arm by keys and buttons in the browser, or by twists from a program, through a servo."""

import time
from typing import Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, array_of_shape, number, one_of
from manipplan.symbolic.task import Task
from manipplan.tracking.servo import Servo, ServoGauge, ServoLimit, Singularity
from manipplan.viz.viewer.live import LiveArm, read_live
from manipplan.viz.viewer.plan_viewer import table
from manipplan.viz.viewer.server import HOST, PORT

#: Keys, what they do, and the direction: index of the twist and sign. viser itself moves the camera by W, A, S, D, Q, E.
KEYS = (
    ("I", "forward, +x", (0, 1)),
    ("K", "backward, -x", (0, -1)),
    ("J", "left, +y", (1, 1)),
    ("L", "right, -y", (1, -1)),
    ("U", "up, +z", (2, 1)),
    ("O", "down, -z", (2, -1)),
    ("R", "turn about +x", (3, 1)),
    ("F", "turn about -x", (3, -1)),
    ("T", "turn about +y", (4, 1)),
    ("G", "turn about -y", (4, -1)),
    ("Y", "turn about +z", (5, 1)),
    ("H", "turn about -z", (5, -1)),
)
#: How long a message of a held button counts, as a busy browser sends few, and the last one before it is let go [s].
HOLD, TAP = 0.5, 0.1
#: Messages per second of a button that is held down.
HOLD_RATE = 20.0
#: Initial, smallest and largest speed [m/s], and radians per metre of turns.
SPEED, SLOWEST, FASTEST, TURN = 0.1, 0.01, 0.5, 4.0
#: What the two axes of commands are called.
FRAMES = ("world", "tool")


def teleoperate(
    robot: Robot,
    *,
    start: ArrayLike | str | None = None,
    dt: float = 0.005,
    task: Task | None = None,
    side: str = "same",
    scene: Scene | None = None,
    port: int = PORT,
    host: str = HOST,
    open_browser: bool = True,
) -> "ServoViewer":
    """Show an arm in the browser whose tool keys and buttons move, through singularities and within all limits.

    Args:
        start: initial configuration (n,), or the name of one of `robot.states`; default `robot.neutral`.
        dt: time step of the servo [s].
        task, side: as for `Servo`.
        scene: obstacles that the arm avoids.
        port, host, open_browser: as for `show`.

    The page stays open until `stop`, or until Python exits: call `wait()` in a script. A program can move the tool as well: it
    assigns `twist`.

    Raises:
        MissingExtraError: viser is not installed.
        InvalidInputError: an argument is not usable, or the port is in use.
    """
    q, scene, avoidance = read_live(robot, start, scene, open_browser=open_browser)
    servo = Servo(robot, dt=dt, task=task, side=side, avoidance=avoidance)
    viewer = ServoViewer(servo, q, scene, port=port, host=host)
    if open_browser:
        viewer.open()
    return viewer


class ServoViewer(LiveArm):
    """A page on which a servo moves an arm.

    Attributes:
        servo: computes the steps.
    """

    room = 0.6  # keys take the arm to the edge of its reach

    def __init__(self, servo: Servo, start: Array, scene: Scene, *, port: int, host: str) -> None:
        self.servo, self._speed = servo, SPEED
        self._twist: Array | None = None
        self._steered = False
        self._presses: dict[tuple[int, int], float] = {}
        self._gauge: ServoGauge | None = None
        robot = servo.robot
        title = f"{robot.name}: move the tool"
        super().__init__(robot, servo.task, servo.dt, start, scene, title=title, port=port, host=host)

    @property
    def speed(self) -> float:
        """Of keys and buttons [m/s]; turns take four radians per metre."""
        return self._speed

    @speed.setter
    def speed(self, value: float) -> None:
        self._speed = number("speed", value, above=0.0)
        self._speed_control.value = min(max(self._speed, SLOWEST), FASTEST)

    @property
    def frame(self) -> str:
        """Axes of the commands, "world" or "tool"."""
        return str(self._frame_control.value)

    @frame.setter
    def frame(self, value: str) -> None:
        self._frame_control.value = one_of("frame", value, FRAMES)

    @property
    def twist(self) -> Array:
        """The command (6,): linear [m/s], then angular [rad/s]. An assigned one counts until the servo's `timeout` is over."""
        with self._lock:
            return self._pressed() if self._twist is None else self._twist.copy()

    @twist.setter
    def twist(self, value: ArrayLike) -> None:
        twist = array_of_shape("twist", value, (6,))
        with self._lock:
            self._twist, self._steered = twist, True

    @property
    def gauge(self) -> ServoGauge | None:
        """What the last step did, and what is ahead; None before the first step."""
        with self._lock:
            return self._gauge

    def restart(self) -> None:
        """Move the arm back to the start."""
        with self._lock:
            super().restart()
            self.servo.reset()
            self._twist = None
            self._presses.clear()

    def press(self, index: int, sign: int, *, seconds: float = HOLD) -> None:
        """Move along a direction of the twist for some time [s]."""
        with self._lock:
            self._presses[index, sign] = time.monotonic() + seconds
            self._twist = None

    def _let_go(self, index: int, sign: int) -> None:
        with self._lock:
            if (index, sign) in self._presses:
                self._presses[index, sign] -= HOLD - TAP

    def _pressed(self) -> Array:
        twist, now = np.zeros(6), time.monotonic()
        for (index, sign), until in self._presses.items():
            if now < until:
                twist[index] += sign * self.speed * (TURN if index >= 3 else 1.0)
        return twist

    def _step(self) -> Array:
        if self._twist is None:
            velocity = self.servo.step(self._q, self._qd, self._pressed(), self.frame)
        else:
            velocity = self.servo.step(self._q, self._qd, self._twist if self._steered else None, self.frame)
            self._steered = False
        self._gauge = self.servo.gauge
        return velocity

    def _add_controls(self, gui: Any) -> None:
        gui.add_markdown("Hold a button, or its key. Stretch the arm: it stops at the edge of its reach, and comes back.")
        speed = gui.add_slider("speed [m/s]", min=SLOWEST, max=FASTEST, step=0.01, initial_value=self.speed)
        self._speed_control, self._frame_control = speed, gui.add_dropdown("axes", FRAMES, initial_value=FRAMES[0])

        def choose_speed(event: Any) -> None:
            if event.client:  # not where the program assigns, which may be faster
                self._speed = float(speed.value)

        speed.on_update(choose_speed)
        self._ahead = gui.add_html("")
        turns = bool(np.any([row[3:] for row in (*self.servo.task.world_rows, *self.servo.task.tool_rows)]))
        with gui.add_folder("Move"):
            self._add_keys(gui, KEYS[:4] if self.arm.planar else KEYS[:6])
        if turns:
            with gui.add_folder("Turn", expand_by_default=False):
                self._add_keys(gui, KEYS[-2:] if self.arm.planar else KEYS[6:])

    def _add_keys(self, gui: Any, keys: tuple[tuple[str, str, tuple[int, int]], ...]) -> None:
        for key, name, (index, sign) in keys:
            button = gui.add_button(f"{key}: {name}")
            command = gui.add_command(name, hotkey=key)
            button.on_hold(lambda _, i=index, s=sign: self.press(i, s), callback_hz=HOLD_RATE)
            button.on_click(lambda _, i=index, s=sign: self._let_go(i, s))
            command.on_trigger(lambda _, i=index, s=sign: self.press(i, s))

    def _draw(self, now: float, *, figures: bool) -> None:
        super()._draw(now, figures=figures)
        if figures and self._gauge is not None:
            self._ahead.content = table(gauge_rows(self._gauge))


def gauge_rows(gauge: ServoGauge) -> list[tuple[str, str]]:
    """The gauge in words; as many rows at each step, as buttons are below them."""
    ahead, when, limit = "none", "-", "nothing"
    if gauge.kind is not Singularity.CLEAR:
        ahead = f"{gauge.kind.name.lower()} of {gauge.joint}"
    if np.isfinite(gauge.seconds):
        when = f"{gauge.seconds:.1f} s, {1e3 * gauge.metres:.0f} mm"
    if gauge.status:
        limit = f"{gauge.status.name.lower().replace('_', ' ')}: the arm brakes"
    elif gauge.reason is not ServoLimit.NOTHING:
        limit = f"{gauge.reason.name.lower()} {gauge.limit_joint}".strip()
    rows = [
        ("followed", f"{100 * gauge.followed:z.0f} %, sideways {100 * gauge.slip:.0f} %"),
        ("singularity ahead", ahead),
        ("reached in", when),
        ("edge of the reach", f"{100 * gauge.wall:.0f} % of the command points at it"),
        ("limited by", limit),
    ]
    if np.isfinite(gauge.clearance):
        rows.append(("distance", f"{1e3 * gauge.clearance:.0f} mm"))
    return rows
