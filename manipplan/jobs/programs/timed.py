"""Times a part of a program, with the constant speeds of the tool that its motions ask for."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.jobs.programs.courses import RawMotion
from manipplan.paths.joint import JointPath, cut
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.support.errors import InvalidInputError
from manipplan.timing.retime import retime
from manipplan.timing.segment import Segment
from manipplan.timing.steady.retime_steady import GRIDS, slower, steady_segments
from manipplan.timing.steady.speed import RAMP, SteadySpeed, measure_speed

#: Number of times that are compared to find when a motion comes past a place.
TIMES = 4000


@dataclass(frozen=True, kw_only=True, eq=False)
class Timed:
    """A timed part.

    Attributes:
        trajectory: the motion.
        speeds: the speed of the tool on each motion that asks for one, by its place in the part.
    """

    trajectory: Trajectory
    speeds: Mapping[int, SteadySpeed]


@dataclass(frozen=True, kw_only=True, eq=False)
class Timing:
    """What is to be timed.

    Attributes:
        robot, path: the arm, with what it carries, and the path of the whole part.
        motions: its motions.
        spans: the s of the path between which each motion reaches, up to the middle of its blends.
        own: the s between which it keeps its own path.
        torque: whether the joints' effort limits are kept as well.
    """

    robot: Robot
    path: JointPath
    motions: Sequence[RawMotion]
    spans: Sequence[tuple[float, float]]
    own: Sequence[tuple[float, float]]
    torque: bool

    def made(self) -> Timed:
        """The fastest motion with the tool speeds that are asked for.

        Raises InvalidInputError, which names the step and the fastest speed that is possible, where the tool cannot keep its
        speed between the ramps, and PlanningError as `retime`.
        """
        asked = {k: motion.tool_speed for k, motion in enumerate(self.motions) if motion.tool_speed is not None}
        timed = self._timed(asked, GRIDS)
        for k, speed in timed.speeds.items():
            if not speed.is_steady:
                own = cut(self.path, *self.own[k])

                def keep(value: float, k: int = k) -> SteadySpeed | None:
                    other = self._timed({k: value}, GRIDS).speeds[k]
                    return other if other.is_steady else None

                wanted = slower(own, self.robot, speed.asked, keep, torque=self.torque)
                raise InvalidInputError(f"steps[{self.motions[k].step}].tool_speed", speed.asked, wanted)
        return timed

    def _timed(self, asked: Mapping[int, float], grids: Sequence[int]) -> Timed:
        """The motion with these speeds, by the first grid on which they are constant, else by the last."""
        segments: list[Segment] = []
        for k, speed in asked.items():
            begin, end = self.spans[k]
            segments += [Segment(begin=begin, end=end, tool_speed=speed), *steady_segments(*self.own[k], speed)]
        for grid in grids:  # slow motions need more points, as the tool turns between two of them
            trajectory = retime(self.path, self.robot, torque=self.torque, segments=segments, grid=grid)
            speeds = {}
            for k, speed in asked.items():
                begin, end = times_of(trajectory, self.path, self.own[k])
                speeds[k] = measure_speed(trajectory, self.robot, speed, begin=begin, end=end, short=RAMP)
            if all(each.is_steady for each in speeds.values()):
                break
        return Timed(trajectory=trajectory, speeds=speeds)


def times_of(trajectory: Trajectory, path: JointPath, places: Sequence[float]) -> list[float]:
    """When the motion comes past places s of its path, in their order [s]."""
    t = np.linspace(0.0, trajectory.duration, TIMES + 1)
    q = trajectory(t)
    found: list[float] = []
    begin = 0
    for s in places:
        away = np.linalg.norm(q[begin:] - path(np.array([s]))[0], axis=1)
        begin += int(away.argmin())
        found.append(float(t[begin]))
    return found
