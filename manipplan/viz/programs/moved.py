"""MovedPart: a part that a program takes up or puts down, with where it is over time."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.robots.attached import Solid
from manipplan.robots.model_tree import frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

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
