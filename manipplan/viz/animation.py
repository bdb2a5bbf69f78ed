"""Animation of a plan: the arm beside its manipulability over time.

An animated figure, written as the frames of a GIF or an MP4 file.
"""

import tempfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import IO, Any

import numpy as np

from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.plans.result import PartialPlan, Plan
from manipplan.support.checks import Array, finite_array, instance, number, whole_number
from manipplan.support.errors import InvalidInputError, MissingProgramError
from manipplan.support.files import write_bytes
from manipplan.support.progress import Progress, as_callback
from manipplan.viz import style
from manipplan.viz.arm import (
    LINES,
    draw_flat_bodies,
    draw_flat_scene,
    draw_scene,
    draw_skeleton,
    draw_surface,
    fit_view,
    plot_ellipsoid,
    points_of,
)
from manipplan.viz.curves import draw_measure
from manipplan.viz.motions import ShownMotion, skeleton
from manipplan.viz.shapes import arm_surfaces, joined

#: Time for which a GIF shows its last frame before it repeats [s].
HOLD = 1.0


def write_gif(stream: IO[bytes], figure: Any, some: Iterable[None], frames: Iterable[None], fps: float, colours: int) -> None:
    """Write frames as a GIF, with durations in hundredths of a second and `HOLD` for the last one.

    Both `some` and `frames` show one frame after the other; the colours are chosen from `some`.
    """
    from PIL import Image

    palette = _palette([picture_of(figure) for _ in some], colours)
    pictures = [picture_of(figure).quantize(palette=palette, dither=Image.Dither.NONE) for _ in frames]
    ends = np.round(100 * np.arange(len(pictures)) / fps).astype(int)
    durations = [*(10 * np.diff(ends)).tolist(), int(1000 * HOLD)]
    pictures[0].save(stream, format="GIF", save_all=True, append_images=pictures[1:], duration=durations, loop=0)


def picture_of(figure: Any) -> Any:
    """The figure as a Pillow image."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    return Image.fromarray(np.asarray(canvas.buffer_rgba())[:, :, :3].copy())


def frame_times(duration: float, speed: float, fps: float) -> Array:
    """The times of the frames of a motion of `duration` [s]."""
    return np.minimum(np.arange(np.ceil(duration / speed * fps - 1e-9) + 1) * speed / fps, duration)


def frames_of(times: Array, show: Callable[[float], None], notify: Progress) -> Iterator[None]:
    """Show what is at each of the times [s], one after the other, and tell the progress."""
    for k, time in enumerate(times.tolist()):
        notify(k / len(times), f"frame {k + 1} of {len(times)}")
        show(time)
        yield


def _write_mp4(stream: IO[bytes], figure: Any, frames: Iterable[None], fps: float) -> None:
    """Write frames, shown one after the other, as an MP4 with ffmpeg."""
    from matplotlib.animation import FFMpegWriter
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    FigureCanvasAgg(figure)
    writer: Any = FFMpegWriter(fps=fps)  # type: ignore[arg-type]  # ffmpeg takes any rate
    with tempfile.TemporaryDirectory() as folder:  # ffmpeg seeks to the start of its file, which a stream may not allow
        file = Path(folder) / "film.mp4"
        with writer.saving(figure, str(file), figure.dpi):
            for _ in frames:
                writer.grab_frame()
        stream.write(file.read_bytes())


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
#: Number of points of the motion from which the axis limits are taken, and of each curve.
POSTURES, SAMPLES = 40, 400
#: Factor by which the single ellipsoid is drawn larger than the several of a still picture.
LARGER = 1.8


def animate(
    plan: Plan,
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
    shown = ShownMotion.of(instance("plan", plan, PartialPlan), SAMPLES)
    if kind == ".mp4":
        from matplotlib.animation import FFMpegWriter

        if not FFMpegWriter.isAvailable():
            raise MissingProgramError("ffmpeg", "sudo apt-get install ffmpeg", "or write a .gif file, which needs no program")
    times = frame_times(shown.trajectory.duration, speed, fps)

    def write(stream: IO[bytes]) -> None:
        from matplotlib.figure import Figure

        figure = Figure(figsize=size, dpi=dpi)
        show = _stage(shown, figure)
        frames = frames_of(times, show, notify)
        if kind == ".gif":
            some = (show(time) for time in times[[0, len(times) // 2, -1]])
            write_gif(stream, figure, some, frames, fps, colours)
        else:
            _write_mp4(stream, figure, frames, fps)

    with style.shared():
        write_bytes(file, write)
    notify(1.0, "done")


def _stage(shown: ShownMotion, figure: Any) -> Callable[[float], None]:
    """Draw the static parts; returns the function that shows the plan at a time [s]."""
    robot, trajectory, scene = shown.robot, shown.trajectory, shown.scene
    m = 2 if robot.planar else 3
    figure.set_layout_engine("constrained")
    grid = figure.add_gridspec(1, 2, width_ratios=(1.25, 1))
    space = figure.add_subplot(grid[0], **({} if robot.planar else {"projection": "3d"}))
    over_time = figure.add_subplot(grid[1])

    postures = trajectory(np.linspace(0.0, trajectory.duration, POSTURES))
    seen = [way[:, :m] for each in shown.motions for way in each.tools] + [skeleton(robot, q)[:, :m] for q in postures]
    if robot.planar:
        draw_flat_scene(space, scene, seen)
        style.name_axes(space)
    else:
        ends = [joined(arm_surfaces(robot, q)) for q in (postures[0], postures[-1])]
        fit_view(space, draw_scene(space, scene, [*seen, *points_of(ends)]), zoom=1.2)
        space.set(xticklabels=[], yticklabels=[], zticklabels=[], xlabel="", ylabel="", zlabel="")
        space.computed_zorder = False  # arm over obstacles, ellipsoid over both: moving parts are always visible
    for each in shown.motions:
        label = f"{'tools' if len(each.tools) > 1 else 'tool'}, {each.name}"
        for k, way in enumerate(each.tools):
            line = {"color": each.colour, "linewidth": 1.3, "alpha": 0.7, "zorder": LINES}
            space.plot(*way[:, :m].T, label=None if k else label, **line)
    space.legend(loc="upper right")
    draw_measure(shown, over_time)
    over_time.legend(loc="best")
    figure.draw_without_rendering()  # the layout is computed once, so that nothing jitters
    figure.set_layout_engine("none")
    space.autoscale(False)

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
        for tool in shown.tools:
            ellipsoid, centre = velocity_ellipsoid(tool.jacobian(q)), tool.pose(q)[:m, 3]
            plot_ellipsoid(ellipsoid, centre, ax=space, scale=LARGER * shown.scale, alpha=0.55)
        for each in shown.motions:
            m_now = shown.kinematics.manipulability(each.at(time))
            over_time.plot(time, m_now, "o", color=each.colour, clip_on=False)
        if shown.seed is not None:
            draw_skeleton(space, skeleton(robot, shown.seed.at(time))[:, :m], colour=shown.seed.colour, alpha=0.6)
        moving.extend(each for axes in (space, over_time) for each in axes.get_children() if each not in before)

    return show
