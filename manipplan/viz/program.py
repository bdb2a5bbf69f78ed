"""The picture of a program: the arm with its parts, and manipulability and joints over time, with the steps.

MovedPart: a part that a program takes up or puts down, with where it is over time.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.robots.attached import Solid
from manipplan.robots.model_tree import frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance
from manipplan.viz import style
from manipplan.viz.arm import plot_arm, plot_planar_arm
from manipplan.viz.curves import POINTS
from manipplan.viz.plan import draw_motion, save_figure
from manipplan.viz.shapes import draw_surface, joined, surface_of, write

if TYPE_CHECKING:
    from manipplan.jobs.programs.program import Program

#: Places that differ by less than this are the same [m].
SAME = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class MovedPart:
    """A part that a program takes up or puts down.

    Attributes:
        name: of the part.
        times: when it is taken up or put down, from 0 on [s].
        held: for each of these times, whether the hand carries it from then on.
        solids: for each, the part posed in the frame of the hand or in the world; None while it is nowhere.
        frames: for each, the tool frame of the hand; "" while no hand carries it.
    """

    name: str
    times: tuple[float, ...]
    held: tuple[bool, ...]
    solids: tuple[Solid | None, ...]
    frames: tuple[str, ...]

    def at(self, t: float, robot: Robot, q: Array) -> Solid | None:
        """The part at time t [s], posed in the world, with the arm at q (n,); None where it is nowhere."""
        solid, frame = self.solids[self._since(t)], self.frames[self._since(t)]
        return solid.at(frame_pose(robot.model, frame, q)) if solid is not None and frame else solid

    def is_held(self, t: float) -> bool:
        """Whether the hand carries it at time t [s]."""
        return self.held[self._since(t)]

    def _since(self, t: float) -> int:
        return int(np.searchsorted(self.times, t, side="right")) - 1

    @property
    def solid(self) -> Solid:
        """The part, wherever it is first."""
        return next(each for each in self.solids if each is not None)


def moved_parts(program: "Program") -> tuple[MovedPart, ...]:
    """The parts that a program takes up or puts down, or carries from the beginning."""
    states = _states(program)
    names = dict.fromkeys(name for _, robot, _ in states for name in robot.carried)
    return tuple(_moved(name, states) for name in names)


def bare(robot: Robot) -> Robot:
    """The arm without what it carries."""
    for name in robot.carried:
        robot = robot.detach(name)
    return robot


def fixed(scene: Scene, moved: Sequence[MovedPart]) -> Scene:
    """The obstacles that stay where they are."""
    names = {each.name for each in moved}
    return Scene([each for each in scene.named if each.name not in names])


def _states(program: "Program") -> list[tuple[float, Robot, Scene]]:
    """Arm and scene, and since when they are so: parts change hands at the marks between two motions."""
    changes = [mark.begin for mark in program.marks if mark.name in ("Attach", "Detach")]
    states = [(0.0, program.robot, program.scene)]
    ends = [begin + part.trajectory.duration for part, begin in zip(program.parts, program.begins, strict=True)]
    later = [(begin, part.robot, part.scene) for part, begin in zip(program.parts, program.begins, strict=True)]
    for before, (begin, robot, scene) in zip(
        [0.0, *ends], [*later, (np.inf, program.final_robot, program.final_scene)], strict=True
    ):
        at = [each for each in changes if before - 1e-9 <= each <= begin + 1e-9]
        if at:
            states.append((min(at), robot, scene))
    return states


def _moved(name: str, states: Sequence[tuple[float, Robot, Scene]]) -> MovedPart:
    times, held, solids, frames = [], [], [], []
    for since, robot, scene in states:
        times.append(since)
        held.append(name in robot.carried)
        frames.append(robot.carried[name].frame if name in robot.carried else "")
        standing = next((each for each in scene.named if each.name == name), None)
        solids.append(robot.carried[name].solid if name in robot.carried else standing)
    return MovedPart(name=name, times=tuple(times), held=tuple(held), solids=tuple(solids), frames=tuple(frames))


#: Number of postures of the arm that are drawn, and of places of a part while it is carried.
POSTURES, CARRIED = 9, 4
#: Steps that begin within this share of the duration share a label.
TOGETHER = 0.015


def save_program(program: "Program", file: str | Path) -> None:
    """Write the picture of a program as PNG; see `program_figure`."""
    save_figure(lambda: program_figure(program), file)


def program_figure(program: "Program", figure: Any = None) -> Any:
    """Draw a program: the arm and its parts along the motion, and manipulability and joints over time, with the steps.

    Parts are drawn where they are at the start, on their way, and where they are put down. `figure` is a Matplotlib figure
    to draw into; default: a new one of 11.5 x 6 inches. Returns the figure.
    """
    from manipplan.jobs.programs.program import Program

    instance("program", program, Program)
    robot = bare(program.robot)
    title = f"{robot.name}: {len(program.marks)} steps, {program.duration:.2f} s, minimum m {program.min_manipulability:.3g}"
    with style.shared():
        figure, space, top, bottom = draw_motion(figure, title, robot, program.trajectory)
        plot = plot_planar_arm if robot.planar else plot_arm
        plot(robot, program.trajectory, program.scene, places=POSTURES, ax=space)
        if not robot.planar:
            _write_blends(space, program)
            for part in moved_parts(program):
                _draw_part(space, program, part)
        _plot_measure(program, top)
        draw_marks(program, top, names=True)
        draw_marks(program, bottom, names=False)
    return figure


def draw_marks(program: "Program", ax: Any, *, names: bool) -> None:
    """Draw when the steps of a program begin, as lines on axes over its time, and where wanted their names."""
    near: dict[float, list[str]] = {}
    for mark in program.marks:
        changes = mark.name in ("Attach", "Detach")
        ax.axvline(mark.begin, color=style.LIMIT if changes else style.ARM, linewidth=1.0, linestyle="-" if changes else ":")
        begin = next((each for each in near if mark.begin - each < TOGETHER * program.duration), mark.begin)
        near.setdefault(begin, []).append(f"{mark.step} {mark.name}")
    for begin, texts in near.items() if names else ():
        at = {"xycoords": ("data", "axes fraction"), "xytext": (2, 2), "textcoords": "offset points"}
        ax.annotate(", ".join(texts), (begin, 0.0), **at, fontsize=7, color=style.ARM, rotation=90, va="bottom", ha="left")


def _write_blends(ax: Any, program: "Program") -> None:
    """The radius of each blend, at its corner."""
    following = [mark.begin for mark in program.marks[1:]]
    for mark, end in zip(program.marks, [*following, program.duration], strict=True):
        for radius, t in ((mark.path_blend, mark.path_begin), (mark.blend, end)):
            if radius and t is not None:
                q = program.trajectory(t)
                for tool in program.robot.tools:
                    place = program.robot.arm(tool).kinematics().pose(q[list(program.robot.joints_of(tool))])[:3, 3]
                    write(ax, place, f"{1e3 * radius:.3g} mm", style.ARM)


def _plot_measure(program: "Program", ax: Any) -> None:
    """The measure over time; a dot marks its minimum."""
    result = program.parts[0].result
    kinematics = program.parts[0].robot.kinematics(result.task, measure=result.measure)
    t = np.linspace(0.0, program.duration, POINTS)
    m = kinematics.manipulability(program.trajectory(t))
    ax.plot(t, m, color=style.OPTIMUM)
    ax.plot(t[m.argmin()], m.min(), "o", color=style.OPTIMUM, markersize=4, clip_on=False)
    ax.set(xlabel="time [s]", xlim=(0, program.duration), title="measure over time; dot: minimum")
    ax.set_ylabel(style.measure_label(kinematics))
    ax.set_ylim(min(0.0, m.min()), None)


def _draw_part(ax: Any, program: "Program", part: MovedPart) -> None:
    """A part on its way in the hand, and where it is put down."""
    robot = bare(program.robot)
    edges = [*part.times, program.duration]
    for k, (begin, end) in enumerate(pairwise(edges)):
        times = np.linspace(begin, end, CARRIED + 2)[1:-1] if part.held[k] else [begin] if k else []
        for t in times:
            solid = part.at(float(t), robot, program.trajectory(float(t)))
            if solid is None:
                continue
            surface = joined(surface_of(shape).placed(solid.pose) for shape in solid.shapes())
            draw_surface(ax, surface, style.OPTIMUM, alpha=0.25 if part.held[k] else 0.7, edges=True)
            if not part.held[k]:
                low, high = surface.points.min(axis=0), surface.points.max(axis=0)
                write(ax, np.append((low + high)[:2] / 2, high[2]), f"{part.name}, put down", style.OPTIMUM)
