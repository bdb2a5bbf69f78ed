"""A recorded motion and the improved one side by side, each figure measured in the same way."""

from dataclasses import dataclass, fields

import numpy as np

from manipplan.cost.integral import PathIntegral
from manipplan.paths.deviation import Deviation, angles_between
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.support.display import one_line
from manipplan.symbolic.task import Task

#: Number of intervals of time over which the mean manipulability is taken, and at whose ends two motions are compared.
TIMES = 2000
#: Relative change up to which a figure counts as the same, and by which manipulability has to rise to count as better.
UNCHANGED, BETTER = 1e-6, 1e-3
#: Manipulability below this is rounding noise.
VANISHING = 1e-12


@dataclass(frozen=True, kw_only=True)
class MotionFigures:
    """Figures of one motion.

    Attributes:
        min_manipulability, mean_manipulability: of m over the time.
        g: of the objective.
        length: in joint space [rad or m].
        duration: [s].
        peak_jerk, rms_jerk: largest and root mean square jerk of the joints [rad/s³ or m/s³]: change of acceleration from the
            middle of one piece of the trajectory to the middle of the next, per time.
    """

    min_manipulability: float
    mean_manipulability: float
    g: float
    length: float
    duration: float
    peak_jerk: float
    rms_jerk: float

    @classmethod
    def of(cls, motion: Trajectory, integral: PathIntegral) -> "MotionFigures":
        """Measure a motion."""
        path = motion.path()
        cost = integral.cost(path)
        m = integral.kinematics.manipulability(path(np.linspace(0.0, 1.0, TIMES + 1)))
        peak, rms = _jerk(motion)
        return cls(
            min_manipulability=cost.min_manipulability,
            mean_manipulability=float((m[1:] + m[:-1]).mean() / 2),
            g=cost.g,
            length=cost.length,
            duration=motion.duration,
            peak_jerk=peak,
            rms_jerk=rms,
        )


@one_line
@dataclass(frozen=True, kw_only=True)
class Comparison:
    """A recorded motion and the improved one.

    Attributes:
        recorded, improved: the figures of both.
        measure_unit: unit of m.
        deviation: largest distances of the improved tool from the recorded one, at the same share of the time.
        tolerance: what was allowed of it.
    """

    recorded: MotionFigures
    improved: MotionFigures
    measure_unit: str
    deviation: Deviation
    tolerance: Tolerance

    @property
    def worse(self) -> tuple[str, ...]:
        """Names of figures that must not get worse and did: minimum manipulability, g, and jerk unless the motion is faster."""
        before, after = self.recorded, self.improved
        rises = [] if after.duration < before.duration * (1 - UNCHANGED) else ["peak_jerk", "rms_jerk"]
        names = [name for name in ("g", *rises) if getattr(after, name) > getattr(before, name) * (1 + UNCHANGED)]
        if before.min_manipulability >= VANISHING and after.min_manipulability < before.min_manipulability * (1 - UNCHANGED):
            names.insert(0, "min_manipulability")
        return tuple(names)

    @property
    def better(self) -> bool:
        """Whether the minimum or the mean manipulability rose by at least 0.1 %, and no figure of `worse` got worse."""
        names = ("min_manipulability", "mean_manipulability")
        pairs = [(getattr(self.recorded, name), getattr(self.improved, name)) for name in names]
        higher = any(after > max((1 + BETTER) * before, VANISHING) for before, after in pairs)
        return higher and not self.worse

    def __str__(self) -> str:
        unit = "" if self.measure_unit == "1" else f" [{self.measure_unit}]"
        names = (
            f"minimum m{unit}",
            f"mean m{unit}",
            "g",
            "length [rad]",
            "duration [s]",
            "peak jerk [rad/s³]",
            "RMS jerk [rad/s³]",
        )
        lines = [f"{'':<20}{'recorded':>10}{'improved':>10}"]
        for name, each in zip(names, fields(MotionFigures), strict=True):
            lines.append(f"{name:<20}{getattr(self.recorded, each.name):>10.4g}{getattr(self.improved, each.name):>10.4g}")
        allowed = [f"{1e3 * self.tolerance.position:.4g} mm"] if self.tolerance.position is not None else []
        if self.tolerance.rotation is not None:
            allowed.append(f"{np.rad2deg(self.tolerance.rotation):.3g}°")
        return "\n".join([*lines, f"tool {str(self.deviation).replace('path', 'recording')}; allowed: {' and '.join(allowed)}"])


def deviation_between(recorded: Trajectory, improved: Trajectory, integral: PathIntegral) -> Deviation:
    """Largest distances of the tools of two motions from each other, at the same shares of time: at all samples
    of both, and at even times.

    What the task leaves free does not count: of a task without angular rows the orientation, of a pointing task the turn
    about its axis, of a task without linear rows the position.
    """
    even = np.linspace(0.0, 1.0, TIMES + 1)
    u = np.unique(np.concatenate([recorded.t / recorded.duration, improved.t / improved.duration, even]))
    position, rotation = tool_distances(recorded, improved, u, integral)
    far, turned = int(position.argmax()), int(rotation.argmax())
    return Deviation(
        position=float(position[far]),
        position_at=float(u[far]),
        rotation=float(rotation[turned]),
        rotation_at=float(u[turned]),
    )


def tool_distances(recorded: Trajectory, improved: Trajectory, u: Array, integral: PathIntegral) -> tuple[Array, Array]:
    """Distances [m] and angles [rad] (k,) between the tools of two motions at shares u (k,) of their times."""
    kinematics = integral.kinematics
    first, second = (kinematics.pose(each(np.minimum(u * each.duration, each.duration))) for each in (recorded, improved))
    return pose_distances(first, second, kinematics.task)


def pose_distances(first: Array, second: Array, task: Task) -> tuple[Array, Array]:
    """Distances [m] and angles [rad] (k,) between poses (k, 4, 4), as far as the task holds them."""
    moves, turns = held(task)
    position = np.linalg.norm(first[:, :3, 3] - second[:, :3, 3], axis=1) if moves else np.zeros(len(first))
    rotation = angles_between(first[:, :3, :3], second[:, :3, :3], task.free_axis) if turns else np.zeros(len(first))
    return position, rotation


def held(task: Task) -> tuple[bool, bool]:
    """Whether the task holds the tool's position, and its orientation."""
    rows = np.array([*task.world_rows, *task.tool_rows])
    return bool(rows[:, :3].any()), bool(rows[:, 3:].any())


def _jerk(motion: Trajectory) -> tuple[float, float]:
    """Largest and root mean square jerk of a motion."""
    widths, (_, _, second, third) = motion.segments()
    if len(widths) == 1:
        return float(6 * np.abs(third).max()), float(6 * np.sqrt(np.mean(third**2)))
    middle = 2 * second + 3 * third * widths[:, None]
    apart = (widths[1:] + widths[:-1]) / 2
    jerk = np.diff(middle, axis=0) / apart[:, None]
    return float(np.abs(jerk).max()), float(np.sqrt(np.average((jerk**2).mean(axis=1), weights=apart)))
