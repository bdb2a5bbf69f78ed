"""A plan or program in the browser, with a time slider, playback at real speed, and a switch per layer; or recorded as HTML.

Parts of the panel that all viewers share, such as the measure over time as SVG, which a browser draws without scripts.
"""

import json
import threading
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from manipplan.plans.result import Plan
from manipplan.programs.program import Program
from manipplan.support.checks import Array, ArrayLike, flag, number, whole_number
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_text
from manipplan.support.progress import Progress, as_callback, silent
from manipplan.viz import style
from manipplan.viz.motions import ShownMotion
from manipplan.viz.viewer.bodies import appearance_of
from manipplan.viz.viewer.replanner import Replanner, can_replan
from manipplan.viz.viewer.server import HOST, PORT, Page, furnished, require_extra
from manipplan.viz.viewer.stage import WIDE, Stage


def switches(gui: Any, layers: Mapping[str, Any]) -> None:
    """A folder with a checkbox per layer, labelled with its name, that shows and hides it."""

    def switch(name: str, handle: Any) -> None:
        box = gui.add_checkbox(name, initial_value=bool(handle.visible))
        box.on_update(lambda _: setattr(handle, "visible", box.value))

    with gui.add_folder("Show"):
        for name, handle in layers.items():
            switch(name, handle)


def table(rows: Sequence[tuple[str, str]]) -> str:
    """Names and values in two columns, as HTML."""
    cells = "".join(f"<tr><td>{escape(name)}</td><td>{escape(value)}</td></tr>" for name, value in rows)
    return f'<div class="figures"><table>{cells}</table></div>'


#: Size of the drawing and its margins: left, right, top, bottom [px].
WIDTH, HEIGHT = 300, 170
LEFT, RIGHT, TOP, BOTTOM = 42, 8, 14, 30
#: Minimum distance of two words above the drawing [px].
WORD = 14


@dataclass(frozen=True, kw_only=True, eq=False)
class ChartLine:
    """One curve: its name in the legend, its colour, and its values at the chart's times."""

    name: str
    colour: str
    values: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Chart:
    """Curves over the same times t (k,) [s], on an axis that includes zero; `label` gives quantity and unit.

    `marks`: times [s] with names, drawn as dotted lines that show their name under the mouse; above them stands the first word
    of it. `seeks`: whether a click selects the time.
    """

    t: Array
    curves: Sequence[ChartLine]
    label: str
    marks: Sequence[tuple[float, str]] = ()
    seeks: bool = False

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
            parts.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{at}" y2="{at}" class="grid"/>')
            parts.append(f'<text x="{LEFT - 5}" y="{at}" dy="3.5" text-anchor="end">{value:.6g}</text>')
        time_step = _round_step((end - start) / 4)
        for t in np.arange(np.ceil(start / time_step) * time_step, end + 1e-9, time_step):
            parts.append(f'<text x="{x(t):.1f}" y="{HEIGHT - BOTTOM + 13}" text-anchor="middle">{t:.6g}</text>')
        parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 3}" text-anchor="middle">time [s]</text>')
        written = -np.inf
        for begin, name in self.marks:
            ends = f'x1="{x(begin):.1f}" x2="{x(begin):.1f}" y1="{TOP}" y2="{HEIGHT - BOTTOM}"'
            lines = f'<line {ends} stroke="#999" stroke-dasharray="2 2"/><line {ends} stroke="transparent" stroke-width="6"/>'
            word = ""
            if x(begin) >= written + WORD:
                written = x(begin)
                word = f'<text x="{x(begin):.1f}" y="{TOP - 2}" text-anchor="middle">{escape(name.split()[0])}</text>'
            parts.append(f'<g class="mark"><title>{escape(name)}</title>{lines}{word}</g>')
        for curve in reversed(self.curves):
            points = " ".join(f"{place:.1f},{y(value):.1f}" for place, value in zip(across, curve.values, strict=True))
            parts.append(f'<polyline points="{points}" fill="none" stroke="{curve.colour}" stroke-width="2"/>')
        if now is not None:
            here, foot = f"{x(now):.1f}", HEIGHT - BOTTOM
            parts.append(f'<line class="now" x1="{here}" x2="{here}" y1="{TOP}" y2="{foot}"/>')
            for curve in reversed(self.curves):
                height = f"{y(float(np.interp(now, self.t, curve.values))):.1f}"
                parts.append(f'<circle cx="{here}" cy="{height}" r="4" fill="{curve.colour}" stroke="#fff"/>')
        time = f' data-time="{json.dumps([LEFT, WIDTH - RIGHT, start, end])}"' if self.seeks else ""
        label = f"{escape(self.label)} over time"
        return f'<svg viewBox="0 0 {WIDTH} {HEIGHT}"{time} role="img" aria-label="{label}">{"".join(parts)}</svg>'

    def html(self, now: float | None = None) -> str:
        """Legend and picture."""
        keys = " ".join(
            f'<span class="key"><span style="color:{curve.colour}">&#9644;</span> {escape(curve.name)}</span>'
            for curve in self.curves
        )
        keys = f"<br>{keys}" if len(self.curves) > 1 else ""
        return f'<div class="figures"><p>{escape(self.label)}{keys}</p>{self.svg(now)}</div>'


def _round_step(rough: float) -> float:
    """1, 2 or 5 times a power of ten, at least `rough`."""
    power = 10.0 ** np.floor(np.log10(max(rough, 1e-12)))
    return float(next(k * power for k in (1, 2, 5, 10) if k * power >= rough * (1 - 1e-9)))


#: Pictures per second during playback.
RATE = 25.0
#: Playback speeds by label.
REAL = "real speed"
SPEEDS = {"0.1 x": 0.1, "0.25 x": 0.25, "0.5 x": 0.5, REAL: 1.0, "2 x": 2.0}


def show(plan: Plan | Program, *, port: int = PORT, host: str = HOST, open_browser: bool = True) -> "PlanViewer":
    """Show a plan in the browser; the page stays open until `stop`, or until Python exits: use `show(plan).wait()` in a script.

    Args:
        plan: with a trajectory; or a Program, whose parts are shown where they are, with the steps on the axis of time.
        port: of the page; 0: any free port.
        host: "localhost", visible to this machine only, or one of its network addresses ("0.0.0.0": all of them).
        open_browser: whether to open the page; if no browser can be opened, the log gives the page's address.

    Raises:
        MissingExtraError: viser is not installed.
        InvalidInputError: the port is in use.
        PlanningError: the plan has no trajectory.
    """
    require_extra()
    flag("open_browser", open_browser)
    viewer = PlanViewer(ShownMotion.of(plan), port=port, host=host)
    if open_browser:
        viewer.open()
    return viewer


class PlanViewer(Page):
    """A page that shows a motion.

    Attributes:
        motion: the motion that is shown.
        stage: the 3D scene.
        repeats: whether the playback starts again at the end.
        replanner: what is dragged and planned again; None where the motion is no plan from a start to a goal.
    """

    def __init__(self, motion: ShownMotion, *, port: int, host: str) -> None:
        super().__init__(port, host, motion.robot.name)
        self._speed = 1.0
        self.repeats = True
        self._lock = threading.RLock()
        self._playing = threading.Event()
        self.replanner = Replanner(self.server, lambda: self.running, self.show_motion) if can_replan(motion) else None
        with self._furnishing():
            self._take(motion)
        self._start(self._play)
        if self.replanner is not None:
            self._start(self.replanner.run)

    @property
    def time(self) -> float:
        """The displayed time [s]."""
        return self._time

    @time.setter
    def time(self, value: float) -> None:
        self._show(number("time", value, least=0.0, most=self.motion.trajectory.duration))

    @property
    def q(self) -> Array:
        """The displayed configuration (n,); the arm can be moved to another one inside its limits."""
        return self.motion.trajectory(self._time) if self._by_hand is None else self._by_hand.copy()

    @q.setter
    def q(self, value: ArrayLike) -> None:
        self.pause()
        self._show(self._time, self.motion.robot.configuration("q", value))

    @property
    def speed(self) -> float:
        """Playback speed relative to real time, above zero."""
        return self._speed

    @speed.setter
    def speed(self, value: float) -> None:
        self._speed = number("speed", value, above=0.0)

    @property
    def playing(self) -> bool:
        """Whether the motion is playing."""
        return self._playing.is_set()

    def play(self) -> None:
        """Play from the displayed time, or from the start if that is the end."""
        if self._time >= self.motion.trajectory.duration:
            self._show(0.0)
        self._button.label, self._button.icon = "Pause", "player-pause"
        self._playing.set()

    def pause(self) -> None:
        """Pause the playback."""
        with self._lock:
            self._playing.clear()
        self._button.label, self._button.icon = "Play", "player-play"

    def show_worst(self) -> None:
        """Show the time at which the manipulability is smallest."""
        self.pause()
        self._show(self.motion.worst)

    def stop(self) -> None:
        self._playing.clear()
        super().stop()

    def show_motion(self, motion: ShownMotion) -> None:
        """Show another motion of the same robot in place of this one; the camera stays where it is."""
        with self._lock, self.server.atomic():
            self._playing.clear()
            self.server.gui.reset()
            self.server.scene.reset()
            self._take(motion)

    def _take(self, motion: ShownMotion) -> None:
        self.motion, self._time = motion, 0.0
        self._by_hand: Array | None = None
        self._chart = chart_of(motion)
        self.stage = Stage(self.server, motion)
        self._fill_panel()

    def _fill_panel(self) -> None:
        gui, duration, robot = self.server.gui, self.motion.trajectory.duration, self.motion.robot
        self._button = gui.add_button("Play", icon="player-play")
        self._slider = gui.add_slider("time [s]", min=0.0, max=np.ceil(100 * duration) / 100, step=0.01, initial_value=0.0)
        worst = gui.add_button("Worst moment", icon="arrow-down", color="gray", hint="Where the manipulability is smallest")
        named = next((name for name, value in SPEEDS.items() if value == self._speed), REAL)
        speed = gui.add_dropdown("speed", tuple(SPEEDS), initial_value=named)
        repeats = gui.add_checkbox("repeat", initial_value=self.repeats)
        self._picture = gui.add_html(self._chart.html(0.0))
        self._values = gui.add_html(table(self.motion.values(0.0)))
        with gui.add_folder("Move by hand", expand_by_default=False):
            path, limits = self.motion.ours.q, np.array([robot.limits.lower, robot.limits.upper])
            ranges = np.where(np.isfinite(limits), limits, [path.min(axis=0) - np.pi, path.max(axis=0) + np.pi])
            self._joints = [
                gui.add_slider(name, min=low, max=high, step=1e-3, initial_value=float(np.clip(q, low, high)))
                for name, low, high, q in zip(robot.joint_names, *ranges.tolist(), self.motion.trajectory(0.0), strict=True)
            ]
        if self.replanner is not None:
            self.replanner.fill_panel(self.motion, self.stage)
        switches(gui, self.stage.layers)
        with gui.add_folder("About", expand_by_default=False):
            gui.add_html(about(self.motion))

        def slide(event: Any) -> None:
            if event.client is not None:  # ignore changes made by `_show`
                self.pause()
                self._show(min(float(self._slider.value), duration), moved=self._slider)

        def move(event: Any) -> None:
            if event.client is not None:
                self.pause()
                q = np.clip([each.value for each in self._joints], robot.limits.lower, robot.limits.upper)
                self._show(self._time, q, moved=event.target)

        self._slider.on_update(slide)
        for joint in self._joints:
            joint.on_update(move)
        self._button.on_click(lambda _: self.pause() if self.playing else self.play())
        worst.on_click(lambda _: self.show_worst())
        speed.on_update(lambda _: setattr(self, "speed", SPEEDS[speed.value]))
        repeats.on_update(lambda _: setattr(self, "repeats", repeats.value))

    def _show(self, t: float, by_hand: Array | None = None, *, moved: Any = None) -> None:
        """Show time t, or a posture (n,); `moved`: the slider by which it was chosen, which stays as it is."""
        with self._lock, self.server.atomic():
            self._time, self._by_hand = t, by_hand
            self.stage.place(t, by_hand)
            values = [(self._slider, round(t, 2)), *zip(self._joints, self.q.tolist(), strict=True)]
            for slider, value in values:
                if slider is not moved:
                    slider.value = float(np.clip(value, slider.min, slider.max))
            self._picture.content = self._chart.html(t)
            self._values.content = table(self.motion.values(t, by_hand))

    def _play(self) -> None:
        while self.running:
            if not self._playing.wait(0.2):
                continue
            last = time.monotonic()
            while self.playing and self.running:
                time.sleep(1.0 / RATE)
                now = time.monotonic()
                with self._lock:
                    if self.playing:  # it may have been paused meanwhile
                        last = self._advance(now, last)

    def _advance(self, now: float, last: float) -> float:
        """Show what is due at `now`, after `last` [s]; returns the time from which the next pictures count."""
        duration = self.motion.trajectory.duration
        if self._time < duration:
            self._show(min(self._time + self.speed * (now - last), duration))
            if self._time >= duration and not self.repeats:
                self.pause()
        elif now - last < PAUSE:
            return last
        else:
            self._show(0.0)
        return now


def chart_of(motion: ShownMotion) -> Chart:
    """The measure over time, of the motion and of the seed."""
    curves = [
        ChartLine(name=each.name, colour=each.colour, values=np.nan_to_num(each.manipulability, posinf=0.0))
        for each in motion.motions
    ]
    marks = [(mark.begin, f"{mark.step} {mark.name}") for mark in motion.marks]
    return Chart(t=motion.t, curves=curves, label=style.measure_label(motion.kinematics), marks=marks, seeks=True)


def about(motion: ShownMotion) -> str:
    """A description of the scene as HTML, with names escaped."""
    robot = motion.robot
    frames = f"tool frame{'s' * (len(robot.tools) > 1)} {' and '.join(robot.tools)}"
    lines = [f"{robot.name}, {frames}; drawn from its {appearance_of(robot).origin}."]
    lines.append(f"{motion.status}.")
    if motion.seed is not None:
        lines.append(f"The {motion.seed.name}, to the left, is shown where it has covered the same share of its length.")
    lines.append(
        "Ellipsoids: tool velocities for joint velocities of norm 1, all drawn to the same scale, "
        f"{1e3 * motion.scale:.3g} mm for 1 m/s."
    )
    paragraphs = "".join(f"<p>{escape(line)}</p>" for line in lines)
    return f'<div class="figures">{paragraphs}</div>'


#: Time for which the last picture is shown before the motion repeats [s].
PAUSE = 0.8
#: Width of the picture of an embedded recording over its height: its page cannot adapt to the width of the cell.
EMBEDDED = 1.1


def record(plan: Plan | Program, file: str | Path, *, rate: float = 25.0, progress: Progress | None = None) -> Path:
    """Write the motion of a plan as a self-contained HTML file, with legend, measure over time and values; returns the file.

    The page of one to two megabytes plays the motion at real speed, again and again; the bar at its bottom or a click on the
    curves selects the time.

    Args:
        plan: with a trajectory; or a Program.
        file: file name that ends in .html.
        rate: pictures per second.
        progress: called with the share done in [0, 1] and a text.

    Raises:
        MissingExtraError: viser is not installed.
        PlanningError: the plan has no trajectory.
        InvalidInputError: the file name does not end in .html, or the file cannot be written.
    """
    require_extra()
    if not isinstance(file, str | Path) or Path(file).suffix.lower() not in (".html", ".htm"):
        raise InvalidInputError("file", file, "a file whose name ends in .html")
    path = Path(file).expanduser()
    write_text(path, _recording(plan, rate, notify=as_callback(progress)))
    return path


@dataclass(frozen=True, kw_only=True)
class Embedded:
    """A recording that a notebook shows in a cell, without a server, also where others only read it.

    Attributes:
        html: the page.
        height: of the cell's picture [px].
    """

    html: str
    height: int

    def __repr__(self) -> str:
        return f"Embedded({len(self.html) / 1e6:.1f} MB)"

    def _repr_html_(self) -> str:
        frame = f'style="width:100%;height:{self.height}px;border:0" title="recording"'
        return f'<iframe srcdoc="{escape(self.html)}" {frame}></iframe>'


def embed(plan: Plan | Program, *, height: int = 480, rate: float = 25.0) -> Embedded:
    """The recording of a plan or program as the value of a notebook's cell.

    Args:
        plan: with a trajectory; or a Program.
        height: of the cell's picture [px], 100 to 2000.
        rate: pictures per second.

    Raises:
        MissingExtraError: viser is not installed.
        PlanningError: the plan has no trajectory.
    """
    height = whole_number("height", height, least=100, most=2000)
    require_extra()
    return Embedded(html=_recording(plan, rate, EMBEDDED), height=height)


def _recording(plan: Plan | Program, rate: float, wide: float = WIDE, notify: Progress = silent) -> str:
    """The page of a recording, whose camera is placed for a picture `wide` times as wide as high."""
    rate = number("rate", rate, above=0.0, most=120.0)
    notify(0.0, "preparing the scene")
    motion = ShownMotion.of(plan)
    with Page(0, "localhost", motion.robot.name) as page:
        stage = Stage(page.server, motion, wide)
        serializer = page.server.get_scene_serializer()
        times = np.append(np.arange(0.0, motion.trajectory.duration, 1.0 / rate), motion.trajectory.duration)
        for t, wait in zip(times, np.append(np.diff(times), PAUSE), strict=True):
            notify(float(t) / motion.trajectory.duration, "recording")
            stage.place(float(t))
            serializer.insert_sleep(float(wait))
        return furnished(serializer.as_html(), motion.robot.name, _panel(motion))


def _panel(motion: ShownMotion) -> str:
    """The panel beside the scene, whose values and mark the script of the page moves."""
    values = [[value for _, value in motion.values(float(t))] for t in motion.t]
    data = escape(json.dumps({"seconds": motion.trajectory.duration, "worst": motion.worst, "values": values}))
    return (
        f'<aside id="recorded" data-motion="{data}"><div class="figures"><h1>{escape(motion.robot.name)}</h1>'
        f"<button>Worst moment</button></div>{chart_of(motion).html(0.0)}{table(motion.values(0.0))}</aside>"
    )
