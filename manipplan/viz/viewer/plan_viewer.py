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
from manipplan.support.checks import Array, flag, number
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_text
from manipplan.viz import style
from manipplan.viz.motions import ShownMotion
from manipplan.viz.viewer.bodies import appearance_of
from manipplan.viz.viewer.server import HOST, PORT, Page, require_extra
from manipplan.viz.viewer.stage import Stage


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
    cells = "".join(
        f'<tr><td style="padding:0.1em 0.8em 0.1em 0;color:#666;white-space:nowrap">{escape(name)}</td>'
        f'<td style="font-variant-numeric:tabular-nums">{escape(value)}</td></tr>'
        for name, value in rows
    )
    return f'<table style="margin:0.2em 0.75em;font:12px sans-serif;color:#222;border-collapse:collapse">{cells}</table>'


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


#: Pictures per second during playback.
RATE = 25.0
#: Playback speeds by label.
SPEEDS = {"0.1 x": 0.1, "0.25 x": 0.25, "0.5 x": 0.5, "real speed": 1.0, "2 x": 2.0}


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
        speed: playback speed relative to real time, above zero.
    """

    def __init__(self, motion: ShownMotion, *, port: int, host: str) -> None:
        super().__init__(port, host, motion.robot.name)
        self.motion = motion
        self._speed = 1.0
        self._time = 0.0
        self._lock = threading.RLock()
        self._playing = threading.Event()
        self._chart = chart_of(motion)
        with self._furnishing():
            self.stage = Stage(self.server, motion)
            self._fill_panel()
        self._start(self._play)

    @property
    def time(self) -> float:
        """The displayed time [s]."""
        return self._time

    @time.setter
    def time(self, value: float) -> None:
        self._show(number("time", value, least=0.0, most=self.motion.trajectory.duration))

    @property
    def speed(self) -> float:
        """Playback speed relative to real time."""
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

    def stop(self) -> None:
        self._playing.clear()
        super().stop()

    def _fill_panel(self) -> None:
        gui, duration = self.server.gui, self.motion.trajectory.duration
        self._button = gui.add_button("Play", icon="player-play")
        self._slider = gui.add_slider("time [s]", min=0.0, max=np.ceil(100 * duration) / 100, step=0.01, initial_value=0.0)
        speed = gui.add_dropdown("speed", tuple(SPEEDS), initial_value="real speed")
        self._picture = gui.add_html(self._chart.html(0.0))
        self._values = gui.add_html(table(self.motion.values(0.0)))
        switches(gui, self.stage.layers)
        with gui.add_folder("About", expand_by_default=False):
            gui.add_html(about(self.motion))

        def slide(event: Any) -> None:
            if event.client is not None:  # ignore changes made by `_show`
                self.pause()
                self._show(min(float(self._slider.value), duration), from_slider=True)

        self._slider.on_update(slide)
        self._button.on_click(lambda _: self.pause() if self.playing else self.play())
        speed.on_update(lambda _: setattr(self, "speed", SPEEDS[speed.value]))

    def _show(self, t: float, *, from_slider: bool = False) -> None:
        with self._lock, self.server.atomic():
            self._time = t
            self.stage.place(t)
            if not from_slider:
                self._slider.value = round(t, 2)
            self._picture.content = self._chart.html(t)
            self._values.content = table(self.motion.values(t))

    def _play(self) -> None:
        duration = self.motion.trajectory.duration
        while self.running:
            if not self._playing.wait(0.2):
                continue
            last = time.monotonic()
            while self.playing and self.running:
                time.sleep(1.0 / RATE)
                now = time.monotonic()
                with self._lock:
                    if self.playing:  # it may have been paused meanwhile
                        self._show(min(self._time + self.speed * (now - last), duration))
                    if self._time >= duration:
                        self.pause()
                last = now


def chart_of(motion: ShownMotion) -> Chart:
    """The measure over time, of the motion and of the seed."""
    curves = [
        ChartLine(name=each.name, colour=each.colour, values=np.nan_to_num(each.manipulability, posinf=0.0))
        for each in motion.motions
    ]
    marks = [(mark.begin, f"{mark.step} {mark.name}") for mark in motion.marks]
    return Chart(t=motion.t, curves=curves, label=style.measure_label(motion.kinematics), marks=marks)


def about(motion: ShownMotion) -> str:
    """A description of the scene as HTML, with names escaped."""
    robot = motion.robot
    frames = f"tool frame{'s' * (len(robot.tools) > 1)} {' and '.join(robot.tools)}"
    lines = [f"{robot.name}, {frames}; drawn from its {appearance_of(robot).origin}."]
    lines.append(f"{motion.status}.")
    if motion.seed is not None:
        lines.append(f"The {motion.seed.name} is shown where it has covered the same share of its length.")
    lines.append(
        "Ellipsoids: tool velocities for joint velocities of norm 1, all drawn to the same scale, "
        f"{1e3 * motion.scale:.3g} mm for 1 m/s."
    )
    paragraphs = "".join(f"<p>{escape(line)}</p>" for line in lines)
    return f'<div style="padding:0 0.75em;font:12px sans-serif;color:#222">{paragraphs}</div>'


#: Time for which the last picture is shown before the motion repeats [s].
PAUSE = 0.8
#: Folds the panel initially on a narrow screen, and moves the mark in its chart with the time of viser's player.
FOLLOW = """<script>{
const panel = document.getElementById('figures'), lines = panel.querySelectorAll('polyline');
if (innerWidth < 600) panel.open = false;
const curves = [...lines].map(each => each.getAttribute('points').split(' ').map(point => point.split(',').map(Number)));
const [end, values] = JSON.parse(panel.dataset.motion), steps = values.length - 1;
function follow() {
  const time = Number(document.querySelector('[role=slider]')?.getAttribute('aria-valuenow') ?? 0);
  const at = steps * Math.min(time / end, 1), k = Math.min(Math.floor(at), steps - 1), share = at - k;
  const between = (a, b) => a + share * (b - a);
  const x = between(curves[0][k][0], curves[0][k + 1][0]);
  for (const name of ['x1', 'x2']) panel.querySelector('.now').setAttribute(name, x);
  panel.querySelectorAll('circle').forEach((dot, i) => {
    dot.setAttribute('cx', x);
    dot.setAttribute('cy', between(curves[i][k][1], curves[i][k + 1][1]));
  });
  const value = between(values[k], values[k + 1]).toPrecision(3);
  document.getElementById('now').textContent = `${Math.min(time, end).toFixed(2)} s, measure ${value}`;
}
setInterval(follow, 40);
}</script>"""
#: End of viser's part of the page.
END = "</body>"


def record(plan: Plan | Program, file: str | Path, *, rate: float = 25.0) -> Path:
    """Write the motion of a plan as a self-contained HTML file, with legend, measure over time and values; returns the file.

    The page of one to two megabytes plays the motion at real speed; the bar at its bottom selects the time.

    Args:
        plan: with a trajectory; or a Program.
        file: file name that ends in .html.
        rate: pictures per second.

    Raises:
        MissingExtraError: viser is not installed.
        PlanningError: the plan has no trajectory.
        InvalidInputError: the file name does not end in .html, or the file cannot be written.
    """
    require_extra()
    rate = number("rate", rate, above=0.0, most=120.0)
    if not isinstance(file, str | Path) or Path(file).suffix.lower() not in (".html", ".htm"):
        raise InvalidInputError("file", file, "a file whose name ends in .html")
    path = Path(file).expanduser()
    motion = ShownMotion.of(plan)
    with Page(0, "localhost", motion.robot.name) as page:
        stage = Stage(page.server, motion)
        serializer = page.server.get_scene_serializer()
        times = np.append(np.arange(0.0, motion.trajectory.duration, 1.0 / rate), motion.trajectory.duration)
        for t, wait in zip(times, np.append(np.diff(times), PAUSE), strict=True):
            stage.place(float(t))
            serializer.insert_sleep(float(wait))
        html = serializer.as_html()
    cut = html.rindex(END)
    write_text(path, html[:cut] + _panel(motion) + html[cut:])
    return path


def _panel(motion: ShownMotion) -> str:
    """The panel beside the scene; it can be folded, so that it covers nothing on a small screen."""
    rows = [("duration", f"{motion.trajectory.duration:.2f} s"), *motion.least()]
    samples = [float(f"{each:.4g}") for each in np.nan_to_num(motion.ours.manipulability, posinf=0.0)]
    return (
        f'<details open id="figures" data-motion="{json.dumps([motion.trajectory.duration, samples])}" style="position:fixed;'
        "left:0.8em;top:0.8em;width:min(320px,38vw);z-index:5;background:rgba(255,255,255,0.92);border:1px solid #ddd;"
        'border-radius:6px;padding:0.4em 0"><summary style="font:600 13px sans-serif;padding:0.1em 0.75em;cursor:pointer">'
        f"{escape(motion.robot.name)}</summary>"
        '<div id="now" style="font:13px sans-serif;padding:0.2em 0.75em;font-variant-numeric:tabular-nums"></div>'
        f"{chart_of(motion).html(0.0)}{table(rows)}</details>{FOLLOW}"
    )
