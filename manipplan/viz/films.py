"""A film of a plan: the arm as its meshes show it, on the planner's path and on the optimised one, side by side over m."""

from collections.abc import Iterator
from contextlib import ExitStack
from importlib.util import find_spec
from pathlib import Path
from typing import IO, Any

import numpy as np

from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.plans.result import PartialPlan, Plan
from manipplan.support.checks import flag, instance, number, whole_number
from manipplan.support.errors import InvalidInputError, MissingExtraError
from manipplan.support.files import write_bytes
from manipplan.support.progress import Progress, as_callback
from manipplan.viz import style
from manipplan.viz.animation import HOLD, LARGER, MOST_GIF_FPS, SAMPLES, frame_times, frames_of, picture_of, write_gif
from manipplan.viz.motions import MotionSamples, ShownMotion, skeleton
from manipplan.viz.render import DrawnWay, Picture, Renderer

#: Heights of titles, arms and chart, as shares of the width.
HEAD, ARMS, CHART = 0.07, 0.42, 0.165
#: Text, faint lines and paper, light and dark.
INK = {False: ("#464A50", "#E5E7EB", "#FFFFFF"), True: ("#CDD2D8", "#34393F", "#1A1D22")}
#: Pixels per inch: a text of 9 points has this height in pixels over 8.
DPI = 100
#: Number of postures whose points have to be in the picture, of points of a way, and of frames whose colours make the palette.
POSTURES, WAY, SOME = 40, 120, 5


def film(
    plan: Plan,
    file: str | Path,
    *,
    dark: bool = False,
    width: int = 900,
    fps: float = 14,
    speed: float = 0.5,
    colours: int = 128,
    quality: int = 80,
    progress: Progress | None = None,
) -> None:
    """Write a film of a plan: its meshes, rendered on the motion and beside it on the initial path, above the manipulability.

    The initial path, such as the planner's, has no timing of its own: it is shown at the same share of its length. Needs the
    extra `film`.

    Args:
        plan: with a trajectory.
        file: its suffix selects the format: .webp, or .gif, which is larger; .png for one picture, where the manipulability of
            the initial path is smallest.
        dark: for dark pages.
        width: of the picture [pixels], 300 to 2000, even; its height is two thirds of it.
        fps: frames per second; at most 50.
        speed: playback speed; 0.5 is half the real speed.
        colours: number of colours of a GIF, 2 to 256.
        quality: of a WebP, 1 to 100.
        progress: called with the share done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is not usable, the robot is planar, or the file cannot be written.
        PlanningError: the plan has no trajectory.
        MissingExtraError: MuJoCo is not installed.
        ManipplanError: MuJoCo cannot render here.
    """
    notify = as_callback(progress)
    if find_spec("mujoco") is None:
        raise MissingExtraError("mujoco", "film")
    kind = Path(file).suffix.lower() if isinstance(file, str | Path) else ""
    if kind not in (".webp", ".gif", ".png"):
        raise InvalidInputError("file", file, "a file whose name ends in .webp, .gif or .png")
    dark = flag("dark", dark)
    width = 2 * (whole_number("width", width, least=300, most=2000) // 2)
    fps, speed = number("fps", fps, above=0.0, most=MOST_GIF_FPS), number("speed", speed, above=0.0)
    colours, quality = whole_number("colours", colours, least=2, most=256), whole_number("quality", quality, least=1, most=100)
    shown = ShownMotion.of(instance("plan", plan, PartialPlan), SAMPLES)
    if shown.robot.planar:
        raise InvalidInputError("plan", shown.robot.name, "a plan of an arm in space; viz.animate draws planar arms")
    times = frame_times(shown.trajectory.duration, speed, fps)

    with ExitStack() as stack, style.shared():
        stage = _FilmFigure(shown, width, dark=dark, stack=stack)

        def write(stream: IO[bytes]) -> None:
            if kind == ".png":
                worst = shown.motions[-1]
                stage.show(float(shown.t[worst.manipulability.argmin()]))
                picture_of(stage.figure).save(stream, format="PNG", optimize=True)
                return

            frames = frames_of(times, stage.show, notify)
            if kind == ".gif":
                some = times[np.linspace(0, len(times) - 1, SOME).astype(int)].tolist()
                write_gif(stream, stage.figure, map(stage.show, some), frames, fps, colours)
            else:
                _write_webp(stream, stage.figure, frames, fps, quality)

        write_bytes(file, write)
    notify(1.0, "done")


def _write_webp(stream: IO[bytes], figure: Any, frames: Iterator[None], fps: float, quality: int) -> None:
    pictures = [picture_of(figure) for _ in frames]
    durations = [*[round(1000 / fps)] * (len(pictures) - 1), int(1000 * HOLD)]
    options = {"save_all": True, "append_images": pictures[1:], "duration": durations, "loop": 0}
    pictures[0].save(stream, format="WEBP", quality=quality, method=5, **options)


class _FilmFigure:
    """The figure of a film: a title and a picture for each motion, and the chart."""

    def __init__(self, shown: ShownMotion, width: int, *, dark: bool, stack: ExitStack) -> None:
        from matplotlib.figure import Figure

        self.shown, self.motions = shown, shown.motions[::-1]
        self.end = max(float(shown.t[-1]), 1e-9)
        self.highest = max(float(each.manipulability.max()) for each in self.motions)
        self.decimals = int(np.clip(2 - np.floor(np.log10(max(self.highest, 1e-12))), 0, 8))
        self.unit = style.raised(shown.kinematics.measure.unit(shown.kinematics.task))
        self.ink, self.faint, self.paper = INK[dark]
        heights = [2 * round(share * width / 2) for share in (HEAD, ARMS, CHART)]
        self.size = width // len(self.motions), heights[1]
        height = sum(heights)
        self.figure = Figure(figsize=(width / DPI, height / DPI), dpi=DPI, facecolor=self.paper)
        self.scale = width / 900
        robot = shown.robot
        seen = [way for each in self.motions for way in each.tools]
        seen += [skeleton(robot, q) for each in self.motions for q in each.at(np.linspace(0, shown.t[-1], POSTURES))]
        self.renderer = stack.enter_context(Renderer(robot, shown.scene, np.concatenate(seen), self.size, dark=dark))
        self.pictures, self.values = list[Any](), list[Any]()
        for k, each in enumerate(self.motions):
            left = k / len(self.motions)
            space = self.figure.add_axes((left, heights[2] / height, 1 / len(self.motions), heights[1] / height))
            space.set_axis_off()
            empty = np.zeros((self.size[1], self.size[0], 3), dtype=np.uint8)
            self.pictures.append(space.imshow(empty, interpolation="nearest", aspect="auto"))
            self.values.append(self._title(each, left, height, heights[0]))
        self.gain = self._gain()
        self.chart = self.figure.add_axes((0.075, 0.2 * heights[2] / height, 0.78, 0.7 * heights[2] / height))
        self.curves = self._draw_chart()

    def _title(self, each: MotionSamples, left: float, height: int, head: int) -> Any:
        """Name and colour of a motion; returns the text of its manipulability."""
        from matplotlib.patches import Rectangle

        top = 1 - 0.2 * head / height
        mark = Rectangle((left + 0.02, 1 - 0.84 * head / height), 0.006, 0.66 * head / height, color=each.colour)
        self.figure.add_artist(mark)
        text: dict[str, Any] = {"color": self.ink, "va": "top"}
        self.figure.text(left + 0.036, top, NAMES.get(each.name, each.name), weight="bold", size=12 * self.scale, **text)
        return self.figure.text(left + 0.036, top - 0.36 * head / height, "", size=10 * self.scale, **text)

    def _gain(self) -> Any:
        """The text, shown at the end, of how much higher the minimum is; None where it is not, or there is no other path."""
        least = [float(each.manipulability.min()) for each in self.motions]
        if len(least) < 2 or not least[1] > least[0] > 0:
            return None
        text = f"minimum {least[1] / least[0]:.1f} times as high"
        font: dict[str, Any] = {"color": self.ink, "weight": "bold", "size": 12 * self.scale}
        return self.figure.text(0.985, self.values[1].get_position()[1], text, ha="right", va="top", visible=False, **font)

    def _draw_chart(self) -> list[tuple[Any, Any, Any]]:
        """Curves, faint; returns for each what is drawn up to now, the dot, and the mark of its minimum."""
        ax, shown = self.chart, self.shown
        ax.set_facecolor(self.paper)
        ax.grid(False, axis="x")
        ax.grid(color=self.faint, axis="y")
        for side in ("left", "bottom"):
            ax.spines[side].set_visible(False)
        ax.tick_params(colors=self.ink, length=0, labelsize=8 * self.scale)
        ax.tick_params(axis="x", pad=6 * self.scale)
        ax.set(xlim=(0, self.end), ylim=(0, 1.12 * max(self.highest, 1e-12)))
        ax.locator_params(axis="y", nbins=4)
        ax.xaxis.set_major_formatter(lambda t, _: f"{t:g} s")
        text: dict[str, Any] = {"transform": ax.transAxes, "color": self.ink, "size": 9 * self.scale, "va": "top"}
        name, unit = shown.kinematics.measure.name, self.unit
        title = "manipulability\n√det(J Jᵀ)" if name == "yoshikawa" else name
        ax.text(1.02, 1.0, f"{title} [{unit}]" if unit else title, **text)
        made = []
        for each in self.motions:
            ax.plot(shown.t, each.manipulability, color=each.colour, alpha=0.28)
            [line] = ax.plot([], [], color=each.colour, linewidth=2.4 * self.scale)
            [dot] = ax.plot([], [], "o", color=each.colour, markersize=6 * self.scale, clip_on=False)
            k = int(each.manipulability.argmin())
            least = ax.annotate(
                f"minimum {each.manipulability[k]:.{self.decimals}f}",
                (shown.t[k], each.manipulability[k]),
                xytext=(0, 12 * self.scale),
                textcoords="offset points",
                ha=("left", "center", "right")[int(np.digitize(shown.t[k] / self.end, (0.1, 0.9)))],
                va="bottom",
                color=self.ink,
                weight="bold",
                size=9 * self.scale,
                visible=False,
            )
            made.append((line, dot, least))
        return made

    def show(self, time: float) -> None:
        """Show the motions at a time [s]."""
        shown = self.shown
        done = int(np.searchsorted(shown.t, time, side="right"))
        for each, picture, value, curve in zip(self.motions, self.pictures, self.values, self.curves, strict=True):
            picture.set_data(self._rendered(each, time))
            m = float(shown.kinematics.manipulability(each.at(time)))
            value.set_text(f"m = {m:.{self.decimals}f} {self.unit}".rstrip())
            line, dot, least = curve
            line.set_data([*shown.t[:done], time], [*each.manipulability[:done], m])
            dot.set_data([time], [m])
            least.set_visible(time >= shown.t[each.manipulability.argmin()])
        if self.gain is not None:
            self.gain.set_visible(time >= shown.t[-1])

    def _rendered(self, each: MotionSamples, time: float) -> Picture:
        q, shown = each.at(time), self.shown
        step = max(len(shown.t) // WAY, 1)
        lines = [DrawnWay(points=way[::step], colour=each.colour, done=time / self.end) for way in each.tools]
        scale = LARGER * shown.scale
        ellipsoids = [
            (velocity_ellipsoid(tool.jacobian(q)), np.asarray(tool.pose(q))[:3, 3], scale, each.colour) for tool in shown.tools
        ]
        return self.renderer.draw(q, lines, ellipsoids)


#: Titles of motions.
NAMES = {"seed": "planner's path", "optimised": "manipplan", "refined": "manipplan", "improved": "manipplan"}
