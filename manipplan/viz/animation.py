"""Animation of a plan: the arm beside its manipulability over time.

An animated figure, written as the frames of a GIF or an MP4 file.
"""

import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np

from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.support.checks import Array, finite_array, number, whole_number
from manipplan.support.errors import InvalidInputError, MissingProgramError
from manipplan.support.files import write_bytes
from manipplan.support.progress import Progress, as_callback
from manipplan.viz import style
from manipplan.viz.arm import (
    LINES,
    default_scale,
    draw_flat_bodies,
    draw_flat_scene,
    draw_scene,
    draw_skeleton,
    draw_surface,
    look_at,
    plot_ellipsoid,
    points_of,
)
from manipplan.viz.figure import finished
from manipplan.viz.motions import beside, drawn_tools, name_paths, skeleton, tool_ways
from manipplan.viz.shapes import arm_surfaces, joined

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan

#: Time for which a GIF shows its last frame before it repeats [s].
HOLD = 1.0


@dataclass(frozen=True, kw_only=True)
class Film:
    """An animated figure and its frames.

    Attributes:
        figure: a Matplotlib figure.
        show: updates the figure to a time [s].
        times: (k,) times of the frames [s].
        fps: frames per second.
        colours: number of colours of a GIF.
        tell: progress callback.
    """

    figure: Any
    show: Callable[[float], None]
    times: Array
    fps: float
    colours: int
    notify: Progress

    def write_gif(self, stream: IO[bytes]) -> None:
        """Write the frames as a GIF, with durations in hundredths of a second and `HOLD` for the last frame."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from PIL import Image

        canvas: Any = FigureCanvasAgg(self.figure)

        def picture(time: float) -> Any:
            self.show(time)
            canvas.draw()
            return Image.fromarray(np.asarray(canvas.buffer_rgba())[:, :, :3].copy())

        palette = _palette([picture(time) for time in self.times[[0, len(self.times) // 2, -1]]], self.colours)
        frames = [picture(time).quantize(palette=palette, dither=Image.Dither.NONE) for time in self._time_frames()]
        ends = np.round(100 * np.arange(len(frames)) / self.fps).astype(int)
        shown = [*(10 * np.diff(ends)).tolist(), int(1000 * HOLD)]
        frames[0].save(stream, format="GIF", save_all=True, append_images=frames[1:], duration=shown, loop=0)

    def write_mp4(self, stream: IO[bytes]) -> None:
        """Write the frames as an MP4 with ffmpeg."""
        from matplotlib.animation import FFMpegWriter
        from matplotlib.backends.backend_agg import FigureCanvasAgg

        FigureCanvasAgg(self.figure)
        writer: Any = FFMpegWriter(fps=self.fps)  # type: ignore[arg-type]  # ffmpeg takes any rate
        with tempfile.TemporaryDirectory() as folder:  # ffmpeg seeks to the start of its file, which a stream may not allow
            file = Path(folder) / "film.mp4"
            with writer.saving(self.figure, str(file), self.figure.dpi):
                for time in self._time_frames():
                    self.show(time)
                    writer.grab_frame()
            stream.write(file.read_bytes())

    def _time_frames(self) -> Iterator[float]:
        for k, time in enumerate(self.times.tolist()):
            self.notify(k / len(self.times), f"frame {k + 1} of {len(self.times)}")
            yield time


def _palette(frames: list[Any], colours: int) -> Any:
    """One palette for all frames, so that static parts look the same in each.

    Half of it holds the most frequent colours, such as background and lines; the other half approximates the rest.
    """
    from PIL import Image

    width, height = frames[0].size
    some = Image.new("RGB", (width, len(frames) * height))
    for k, frame in enumerate(frames):
        some.paste(frame, (0, k * height))
    counted: Any = sorted(some.getcolors(width * height * len(frames)) or (), reverse=True)
    entries = [value for _, colour in counted[: colours // 2] for value in colour]
    others = some.quantize(colours - len(entries) // 3, method=Image.Quantize.MAXCOVERAGE, kmeans=1, dither=Image.Dither.NONE)
    palette = Image.new("P", (1, 1))
    palette.putpalette((entries + (others.getpalette() or []))[: 3 * colours])
    return palette


#: Maximum frame rate of a GIF [1/s]: it counts hundredths of a second, and browsers slow down frames shorter than two.
MOST_GIF_FPS = 50.0
#: Minimum and maximum side length [pixels]: smaller pictures are illegible, larger ones exceed any screen.
PIXELS = (50, 8192)
#: Number of points of the motion from which the axis limits are taken.
POSTURES = 40
#: Factor by which the single ellipsoid is drawn larger than the several of a still picture.
LARGER = 1.8


def animate(
    plan: "Plan",
    file: str | Path,
    *,
    fps: float = 20,
    speed: float = 1.0,
    size: tuple[float, float] = (9.6, 4.8),
    dpi: float = 100,
    colours: int = 96,
    progress: Progress | None = None,
) -> None:
    """Write an animation of a plan: the arm with its velocity ellipsoid and the obstacles, and the manipulability over time.

    The initial path of the plan, such as the planner's seed, is shown beside it as a ghost. It has no timing of its own: it is
    shown at the same share of its length.

    Args:
        plan: with a trajectory.
        file: its suffix selects the format: .gif, written by Pillow, or .mp4, written by the program ffmpeg.
        fps: frames per second; at most 50 for a GIF.
        speed: playback speed; 0.5 is half the real speed.
        size: of the picture [inches], and `dpi`: pixels per inch, 10 to 1000; each side has 50 to 8192 pixels.
        colours: number of colours of a GIF, 2 to 256: fewer make a smaller file.
        progress: called with the share done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is not usable, or the file cannot be written.
        PlanningError: the plan has no trajectory.
        MissingProgramError: ffmpeg is needed and not installed.
    """
    notify = as_callback(progress)
    kind = Path(file).suffix.lower() if isinstance(file, str | Path) else ""
    if kind not in (".gif", ".mp4"):
        raise InvalidInputError("file", file, "a file whose name ends in .gif or .mp4")
    fps = number("fps", fps, above=0.0, most=MOST_GIF_FPS if kind == ".gif" else 1000.0)
    speed, dpi = number("speed", speed, above=0.0), number("dpi", dpi, least=10.0, most=1000.0)
    colours = whole_number("colours", colours, least=2, most=256)
    pixels = dpi * finite_array("size", size, (2,))
    if not ((pixels >= PIXELS[0]) & (pixels <= PIXELS[1])).all():
        allowed = f"width and height [inches] that make {PIXELS[0]} to {PIXELS[1]} pixels at {dpi:g} per inch"
        raise InvalidInputError("size", size, allowed)
    finished(plan)
    if kind == ".mp4":
        from matplotlib.animation import FFMpegWriter

        if not FFMpegWriter.isAvailable():
            raise MissingProgramError("ffmpeg", "sudo apt-get install ffmpeg", "or write a .gif file, which needs no program")
    duration = plan.trajectory.duration
    times = np.minimum(np.arange(np.ceil(duration / speed * fps - 1e-9) + 1) * speed / fps, duration)

    def write(stream: IO[bytes]) -> None:
        from matplotlib.figure import Figure

        figure = Figure(figsize=size, dpi=dpi)
        film = Film(figure=figure, show=_stage(plan, figure), times=times, fps=fps, colours=colours, notify=notify)
        (film.write_gif if kind == ".gif" else film.write_mp4)(stream)

    with style.shared():
        write_bytes(file, write)
    notify(1.0, "done")


def _stage(plan: "Plan", figure: Any) -> Callable[[float], None]:
    """Draw the static parts; returns the function that shows the plan at a time [s]."""
    robot, trajectory, ours = plan.robot, plan.trajectory, plan.path
    paths = name_paths(plan)
    m = 2 if robot.planar else 3
    figure.set_layout_engine("constrained")
    grid = figure.add_gridspec(1, 2, width_ratios=(1.25, 1))
    space = figure.add_subplot(grid[0], **({} if robot.planar else {"projection": "3d"}))
    over_time = figure.add_subplot(grid[1])

    colours = {name: style.OPTIMUM if path is ours else style.SEED for name, path in paths.items()}
    motions = {name: trajectory if path is ours else beside(trajectory, path) for name, path in paths.items()}
    ways = {name: [way[:, :m] for way in tool_ways(robot, path)] for name, path in paths.items()}
    postures = trajectory(np.linspace(0.0, trajectory.duration, POSTURES))
    seen = [*chain(*ways.values()), *(skeleton(robot, q)[:, :m] for q in postures)]
    if robot.planar:
        draw_flat_scene(space, plan.scene, seen)
        style.name_axes(space)
    else:
        ends = [joined(arm_surfaces(robot, q)) for q in (postures[0], postures[-1])]
        look_at(space, draw_scene(space, plan.scene, [*seen, *points_of(ends)]), zoom=1.2)
        space.set(xticklabels=[], yticklabels=[], zticklabels=[], xlabel="", ylabel="", zlabel="")
        space.computed_zorder = False  # arm over obstacles, ellipsoid over both: moving parts are always visible
    for name, tools in ways.items():
        label = f"{'tools' if len(tools) > 1 else 'tool'}, {name}"
        for k, way in enumerate(tools):
            line = {"color": colours[name], "linewidth": 1.3, "alpha": 0.7, "zorder": LINES}
            space.plot(*way.T, label=None if k else label, **line)
    space.legend(loc="upper right")

    kinematics = robot.kinematics(plan.result.task, measure=plan.result.measure)
    t = np.linspace(0.0, trajectory.duration, 400)
    for name, at in motions.items():
        over_time.plot(t, kinematics.manipulability(at(t)), color=colours[name], label=name)
    over_time.set(xlabel="time [s]", xlim=(0, trajectory.duration))
    if over_time.dataLim.ymin >= 0:
        over_time.set_ylim(0, None)
    over_time.set_ylabel(style.measure_label(kinematics))
    over_time.legend(loc="best")
    figure.draw_without_rendering()  # the layout is computed once, so that nothing jitters
    figure.set_layout_engine("none")
    space.autoscale(False)

    drawn = drawn_tools(robot)
    scale = LARGER * default_scale(robot, drawn, postures)
    moving: list[Any] = []

    def show(time: float) -> None:
        while moving:
            moving.pop().remove()
        before = set(figure.findobj(include_self=False))
        q = trajectory(time)
        if robot.planar:
            draw_flat_bodies(space, robot, q, style.BODY_LAST, alpha=0.9)
        else:
            draw_surface(space, joined(arm_surfaces(robot, q)), style.BODY_LAST, alpha=0.95)
        draw_skeleton(space, skeleton(robot, q)[:, :m])
        for tool in drawn:
            ellipsoid, centre = velocity_ellipsoid(tool.jacobian(q)), tool.pose(q)[:m, 3]
            plot_ellipsoid(ellipsoid, centre, ax=space, scale=scale, alpha=0.55)
        for name, at in motions.items():
            over_time.plot(time, kinematics.manipulability(at(time)), "o", color=colours[name], clip_on=False)
            if at is not trajectory:
                draw_skeleton(space, skeleton(robot, at(time))[:, :m], colour=colours[name], alpha=0.6)
        moving.extend(each for axes in (space, over_time) for each in axes.get_children() if each not in before)

    return show
