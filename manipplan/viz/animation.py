"""A plan in motion, as a GIF or an MP4 file: the arm beside its index over time."""

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np

from manipplan.checks import Array, number
from manipplan.errors import InvalidInputError, MissingProgramError, PlanningError
from manipplan.files import write_bytes
from manipplan.measures.ellipsoid import velocity_ellipsoid
from manipplan.measures.task import Task
from manipplan.progress import Progress, teller
from manipplan.viz import style
from manipplan.viz.arm import draw_scene
from manipplan.viz.ellipsoids import default_scale, plot_ellipsoid
from manipplan.viz.motions import length_shares, skeleton, tool_way
from manipplan.viz.plan import named_paths
from manipplan.viz.planar import draw_flat_bodies, draw_flat_scene
from manipplan.viz.shapes import arm_surfaces, joined
from manipplan.viz.space import LINES, draw_skeleton, draw_surface, look_at, points_of

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan

#: A GIF counts time in hundredths of a second, and browsers slow down what shows a frame for less than two.
MOST_GIF_FPS = 50.0
#: How long a GIF shows its last frame before it begins again [s].
HOLD = 1.0
#: Places at which the whole motion is looked at for what the axes have to show.
LOOKS = 40
#: The one ellipsoid is drawn so much larger than the several of a still picture.
LARGER = 1.5


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
    """Write a plan in motion: the arm with its velocity ellipsoid among the obstacles, and the index over time with a dot.

    The path that the plan started from, the planner's seed for instance, is shown beside it as a ghost. It has no time of its
    own: it is where the same share of its length lies behind it.

    Args:
        plan: with a trajectory.
        file: its suffix says what is written: .gif, by Pillow, or .mp4, by the program ffmpeg.
        fps: frames a second; of a GIF at most 50.
        speed: 0.5 shows the motion at half its speed.
        size: of the picture [inches], and `dpi`: pixels an inch.
        colours: of a GIF, from 2 to 256: fewer make a smaller file.
        progress: called with the share done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is not usable, or the file cannot be written.
        PlanningError: the plan has no trajectory.
        MissingProgramError: ffmpeg is needed and not installed.
    """
    tell = teller(progress)
    kind = Path(file).suffix.lower() if isinstance(file, str | Path) else ""
    if kind not in (".gif", ".mp4"):
        raise InvalidInputError("file", file, "a file whose name ends in .gif or .mp4")
    fps = number("fps", fps, above=0.0, most=MOST_GIF_FPS if kind == ".gif" else 1000.0)
    speed, dpi = number("speed", speed, above=0.0), number("dpi", dpi, above=0.0)
    colours = int(number("colours", colours, least=2, most=256))
    if plan.trajectory is None or plan.result is None or plan.path is None:
        raise PlanningError(f"there is no trajectory to animate: {plan.status.value}", plan)
    write = _write_gif if kind == ".gif" else _write_mp4
    if kind == ".mp4":
        from matplotlib.animation import FFMpegWriter

        if not FFMpegWriter.isAvailable():
            raise MissingProgramError("ffmpeg", "sudo apt-get install ffmpeg", "or name a .gif file, which needs no program")
    duration = plan.trajectory.duration
    times = np.minimum(np.arange(np.ceil(duration / speed * fps - 1e-9) + 1) * speed / fps, duration)

    from matplotlib import rc_context
    from matplotlib.figure import Figure

    with rc_context(style.STYLE):
        figure = Figure(figsize=size, dpi=dpi)
        show = _stage(plan, figure)

        def shown(k: int) -> None:
            show(float(times[k]))
            tell(k / len(times), f"frame {k + 1} of {len(times)}")

        write_bytes(file, lambda stream: write(figure, shown, len(times), fps, colours, stream))
    tell(1.0, "done")


def _write_gif(figure: Any, show: Callable[[int], None], count: int, fps: float, colours: int, stream: IO[bytes]) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    canvas: Any = FigureCanvasAgg(figure)
    frames = []
    for k in range(count):
        show(k)
        canvas.draw()
        frames.append(Image.fromarray(np.asarray(canvas.buffer_rgba())[:, :, :3].copy()))
    width, height = frames[0].size
    some = Image.new("RGB", (width, 3 * height))  # one palette for all frames: what stands still is the same in each
    for k, at in enumerate((0, count // 2, count - 1)):
        some.paste(frames[at], (0, k * height))
    palette = some.quantize(colours, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    indexed = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    ends = np.round(100 * np.arange(count + 1) / fps).astype(int)
    shown = [*(10 * np.diff(ends)[:-1]).tolist(), int(1000 * HOLD)]
    indexed[0].save(stream, format="GIF", save_all=True, append_images=indexed[1:], duration=shown, loop=0)


def _write_mp4(figure: Any, show: Callable[[int], None], count: int, fps: float, _colours: int, stream: IO[bytes]) -> None:
    from matplotlib.animation import FFMpegWriter
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    FigureCanvasAgg(figure)
    writer = FFMpegWriter(fps=fps)  # type: ignore[arg-type]  # ffmpeg takes any rate
    with tempfile.TemporaryDirectory() as folder:  # ffmpeg goes back to its file's begin, which a stream may not allow
        film = Path(folder) / "film.mp4"
        with writer.saving(figure, str(film), figure.dpi):
            for k in range(count):
                show(k)
                writer.grab_frame()
        stream.write(film.read_bytes())


def _stage(plan: "Plan", figure: Any) -> Callable[[float], None]:
    """Draw what stands still; returns what shows the plan at a time [s]."""
    assert plan.path is not None
    assert plan.result is not None
    assert plan.trajectory is not None
    robot, trajectory, ours = plan.robot, plan.trajectory, plan.path
    paths = named_paths(plan)
    m = 2 if robot.planar else 3
    figure.set_layout_engine("constrained")
    grid = figure.add_gridspec(1, 2, width_ratios=(1.25, 1))
    space = figure.add_subplot(grid[0], **({} if robot.planar else {"projection": "3d"}))
    over_time = figure.add_subplot(grid[1])
    ghost = _ghost(plan)

    colours = {name: style.OPTIMUM if path is ours else style.SEED for name, path in paths.items()}
    ways = {name: tool_way(robot, path)[:, :m] for name, path in paths.items()}
    looks = trajectory(np.linspace(0.0, trajectory.duration, LOOKS))
    seen = [*ways.values(), *(skeleton(robot, q)[:, :m] for q in looks)]
    if robot.planar:
        draw_flat_scene(space, plan.scene, seen)
        style.name_axes(space)
    else:
        ends = [joined(arm_surfaces(robot, q)) for q in (looks[0], looks[-1])]
        look_at(space, draw_scene(space, plan.scene, [*seen, *points_of(ends)]))
        space.computed_zorder = False  # the arm over the obstacles, and the ellipsoid over both: what moves is always seen
    for name, way in ways.items():
        space.plot(*way.T, color=colours[name], linewidth=1.3, alpha=0.7, label=f"tool, {name}", zorder=LINES)
    space.legend(loc="upper right")

    index = robot.kinematics(plan.result.task, measure=plan.result.measure)
    t = np.linspace(0.0, trajectory.duration, 400)
    for name, path in paths.items():
        q = trajectory(t) if path is ours else ghost(t)
        over_time.plot(t, index.manipulability(q), color=colours[name], label=name)
    over_time.set(xlabel="time [s]", xlim=(0, trajectory.duration), ylim=(0, None))
    over_time.set_ylabel(style.with_unit(index.measure.name, index.measure.unit(index.task)))
    over_time.legend(loc="best")
    figure.draw_without_rendering()  # the layout is made once, so that nothing trembles
    figure.set_layout_engine("none")
    space.autoscale(False)

    linear = robot.kinematics(Task.planar() if robot.planar else Task.position())
    scale = LARGER * default_scale(robot, linear.jacobian(looks))
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
        plot_ellipsoid(velocity_ellipsoid(linear.jacobian(q)), skeleton(robot, q)[-1, :m], ax=space, scale=scale)
        over_time.plot(time, index.manipulability(q), "o", color=style.OPTIMUM, clip_on=False)
        if len(paths) > 1:
            draw_skeleton(space, skeleton(robot, ghost(time))[:, :m], colour=style.SEED, alpha=0.6)
            over_time.plot(time, index.manipulability(ghost(time)), "o", color=style.SEED, clip_on=False)
        moving.extend(each for axes in (space, over_time) for each in axes.get_children() if each not in before)

    return show


def _ghost(plan: "Plan") -> Callable[[Any], Array]:
    """The path that the plan started from at times [s]: as much of its length is behind it as of the plan's own."""
    assert plan.trajectory is not None
    assert plan.result is not None
    seed = plan.result.seed
    if seed is None:
        return plan.trajectory
    s = np.linspace(0.0, 1.0, 2001)
    ours, theirs = length_shares(plan.trajectory.path(), s), length_shares(seed, s)
    duration = plan.trajectory.duration
    return lambda time: seed(np.interp(np.interp(np.asarray(time) / duration, s, ours), theirs, s))
