"""`mp.improve` on 50 recorded motions of three arms: what becomes of duration, jerk, manipulability and the tool's way.

Run with `make benchmark`. Writes docs/benchmarks/recorded_motions.md. Three kinds of recordings, each with white noise on every
position: motions guided by hand (smooth, with pauses at waypoints), motions timed at the limits and replayed at a lower speed,
and OMPL's paths through problems of MotionBenchMaker (benchmarks/outside/README.md), with their obstacles. A second judge
measures: jerk is that of the cubic spline with continuous acceleration through the positions, poses come from Pinocchio, and
limits, ends and collisions from `mp.check`. A manipulability below 1e-4 of the recorded mean counts as zero, and two that
are zero as equal: where a motion crosses a singularity, chance decides how near to it a sample is.
"""

import argparse
import os
import platform
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from outside import problems
from rich.progress import track
from scipy.interpolate import CubicSpline, PchipInterpolator
from trajectory_judge import Judge

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "recorded_motions.md"
ARMS, RATES = ("panda", "ur5", "xarm7"), (100, 125, 250, 500)
#: Smallest and largest standard deviation of the noise [rad], and tolerance of the tool.
NOISE, TUBE = (1e-4, 1e-3), mp.Tolerance(position=0.02, rotation=0.2)
#: Kinds of recordings, in turn.
KINDS = ("guided", "timed", "planned")
#: Number of times at which two motions are compared, share up to which a minimum manipulability counts as the same, and share
#: of the mean up to which it counts as zero.
TIMES, SAME, ZERO = 4001, 1e-6, 1e-4
#: Columns of the table: head, attribute, format, and the worse end of its values.
COLUMNS = (
    ("duration", "duration", "{:.3f}", max),
    ("peak jerk", "peak", "{:.2g}", max),
    ("RMS jerk", "rms", "{:.2g}", max),
    ("minimum m", "least", "{:.3g}", min),
    ("mean m", "mean", "{:.3f}", min),
    ("g", "g", "{:.3f}", max),
    ("length", "length", "{:.3f}", max),
)


@dataclass(frozen=True, kw_only=True)
class Recording:
    """A recorded motion, its scene, and how it was made."""

    kind: str
    robot: mp.Robot
    scene: mp.Scene
    motion: mp.Trajectory
    rate: float
    noise: float


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """What `improve` made of a recording, by the second judge; ratios are improved over recorded.

    Attributes:
        status: name of the status, or the error.
        passed: whether `mp.check` passes the motion, from the recorded start to the recorded goal.
        duration, least, mean, g, length, peak, rms: ratios of duration, minimum and mean manipulability, g, length, and peak
            and root mean square jerk.
        position, rotation: largest distances of the tool [m], [rad].
        seconds: CPU time of the call.
    """

    recording: Recording
    status: str
    passed: bool = False
    duration: float = np.nan
    least: float = np.nan
    mean: float = np.nan
    g: float = np.nan
    length: float = np.nan
    peak: float = np.nan
    rms: float = np.nan
    position: float = np.nan
    rotation: float = np.nan
    seconds: float = np.nan

    @property
    def good(self) -> bool:
        """Whether everything that must hold holds."""
        kept = self.position <= TUBE.position and self.rotation <= TUBE.rotation
        calmer = self.duration <= 1 + 1e-9 and self.peak < 1 and self.rms < 1
        return self.passed and kept and calmer and self.least >= 1 - SAME


def guided(robot: mp.Robot, rng: np.random.Generator) -> tuple[PchipInterpolator, float]:
    """Positions over time of an arm that is led through waypoints, with a stop at one of them; and the duration."""
    low, high = robot.limits.lower + 0.3, robot.limits.upper - 0.3
    centre = np.clip(robot.neutral + rng.uniform(-0.8, 0.8, robot.n), low, high)
    way = np.clip(centre + rng.uniform(-0.5, 0.5, (rng.integers(3, 6), robot.n)), low, high)
    stop = rng.integers(1, len(way) - 1)
    way = np.insert(way, stop, way[stop], axis=0)  # the same twice: a pause
    times = np.concatenate([[0.0], np.cumsum(rng.uniform(0.8, 2.0, len(way) - 1))])
    return PchipInterpolator(times, way), float(times[-1])


def timed(robot: mp.Robot, rng: np.random.Generator) -> mp.Trajectory:
    """A motion at the limits, 1 to 2 times slower."""
    low, high = robot.limits.lower + 0.3, robot.limits.upper - 0.3
    centre = np.clip(robot.neutral + rng.uniform(-0.8, 0.8, robot.n), low, high)
    way = np.clip(centre + rng.uniform(-0.6, 0.6, (4, robot.n)), low, high)
    path = mp.JointPath.spline(np.linspace(0.0, 1.0, 4), way)
    return mp.retime(path, robot).slower(float(rng.uniform(1.0, 2.0)))


def recordings(count: int, rng: np.random.Generator) -> Iterator[Recording]:
    """The recordings, whose motions are free of collisions with their noise."""
    outside = {arm: iter(sorted(problems.load(arm), key=lambda each: each.number)) for arm in ("panda", "ur5")}
    for k in range(count):
        kind, arm = KINDS[k % len(KINDS)], ARMS[(k // len(KINDS)) % len(ARMS)]
        if kind == "planned" and arm not in outside:
            kind = KINDS[(k // 9) % 2]
        robot = problems.robot(arm) if kind == "planned" else mp.load_robot(arm)
        while True:
            scene = mp.Scene()
            if kind == "guided":
                curve, duration = guided(robot, rng)
            elif kind == "timed":
                made = timed(robot, rng)
                curve, duration = made, made.duration
            else:
                problem = next(outside[arm])
                ends = np.array([problem.start, problem.goal])
                if (robot.limits.outside(ends) > 0).any() or problem.scene.in_collision(robot, ends).any():
                    continue
                scene = problem.scene
                made = mp.retime(mp.seed_path(robot, *ends, scene), robot).slower(float(rng.uniform(1.0, 2.0)))
                curve, duration = made, made.duration
            rate, noise = float(rng.choice(RATES)), float(np.exp(rng.uniform(*np.log(NOISE))))
            t = np.arange(0.0, duration, 1 / rate)
            q = curve(t) + rng.normal(0.0, noise, (len(t), robot.n))
            q = np.clip(q, robot.limits.lower, robot.limits.upper)
            motion = mp.Trajectory(t=t, q=q, qd=CubicSpline(t, q)(t, 1), joint_names=robot.joint_names)
            if not scene.in_collision(robot, motion(np.linspace(0.0, motion.duration, 300))).any():
                break
        yield Recording(kind=kind, robot=robot, scene=scene, motion=motion, rate=rate, noise=noise)


def judged(recording: Recording) -> Outcome:
    """`improve`, measured by the second judge."""
    robot, before, scene = recording.robot, recording.motion, recording.scene
    began = time.process_time()
    try:
        plan = mp.improve(robot, before, scene, tolerance=TUBE)
    except (mp.errors.InvalidInputError, mp.errors.PlanningError) as error:
        return Outcome(recording=recording, status=f"{type(error).__name__}: {error}")
    seconds, after = time.process_time() - began, plan.trajectory
    report = mp.check(robot, after, scene, start=before.q[0], goal=before.q[-1])
    q = [each(np.linspace(0.0, each.duration, TIMES)) for each in (before, after)]
    m = [robot.kinematics().manipulability(each) for each in q]
    zero = ZERO * m[0].mean()
    length = [np.linalg.norm(np.diff(each, axis=0), axis=1) for each in q]
    g = [(step / np.maximum((each[1:] + each[:-1]) / 2, zero)).sum() for step, each in zip(length, m, strict=True)]
    jerk = [CubicSpline(each.t, each.q)(each.t[:-1], 3) for each in (before, after)]
    judge = Judge(robot, scene.collision_model(robot).geometry)
    first = judge.poses(before.q)
    second = judge.poses(after(np.minimum(before.t * (after.duration / before.duration), after.duration)))
    turn = np.einsum("kij,kij->k", first[:, :3, :3], second[:, :3, :3])
    return Outcome(
        recording=recording,
        status=plan.status.name,
        passed=report.passed,
        duration=after.duration / before.duration,
        least=max(m[1].min(), zero) / max(m[0].min(), zero),
        mean=m[1].mean() / m[0].mean(),
        g=g[1] / g[0],
        length=length[1].sum() / length[0].sum(),
        peak=np.abs(jerk[1]).max() / np.abs(jerk[0]).max(),
        rms=np.sqrt(np.mean(jerk[1] ** 2) / np.mean(jerk[0] ** 2)),
        position=np.linalg.norm(first[:, :3, 3] - second[:, :3, 3], axis=1).max(),
        rotation=np.arccos(np.clip((turn - 1) / 2, -1.0, 1.0)).max(),
        seconds=seconds,
    )


def row(name: str, found: Sequence[Outcome]) -> str:
    """A line of the table: median, and worst case in brackets."""
    improved = sum(each.status == "IMPROVED" for each in found)
    cells = [name, f"{len(found)}", f"{improved}", f"{sum(each.good for each in found)}"]
    made = [each for each in found if np.isfinite(each.duration)]
    for _, attribute, form, worst in COLUMNS:
        values = [float(getattr(each, attribute)) for each in made]
        cells.append(f"{form.format(np.median(values))} ({form.format(worst(values))})" if values else "")
    cells.append(f"{1e3 * max((each.position for each in made), default=np.nan):.2f} mm")
    cells.append(f"{max((each.rotation for each in made), default=np.nan):.3f} rad")
    return "| " + " | ".join(cells) + " |"


def table(outcomes: Sequence[Outcome]) -> list[str]:
    """The lines of the table: by kind, by arm, and all."""
    heads = ["recordings", "number", "IMPROVED", "all kept", *(head for head, *_ in COLUMNS), "position", "rotation"]
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    for kind in KINDS:
        lines.append(row(kind, [each for each in outcomes if each.recording.kind == kind]))
    for arm in ARMS:
        lines.append(row(arm, [each for each in outcomes if each.recording.robot.name == arm]))
    return [*lines, row("all", outcomes)]


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=50, help="number of recordings")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    made = recordings(given.count, np.random.default_rng(20))
    outcomes = [judged(each) for each in track(made, total=given.count, description="improving")]
    for each in outcomes:
        if not each.good:
            print(f"{each.recording.kind}, {each.recording.robot.name}: {each.status}, {each}")
    seconds = np.array([each.seconds for each in outcomes if np.isfinite(each.seconds)])
    lines = [
        *table(outcomes),
        "",
        f"{len(outcomes)} recordings of {min(RATES)} to {max(RATES)} Hz with white noise of {1e3 * NOISE[0]:g} to "
        f"{1e3 * NOISE[1]:g} mrad; tolerance {1e3 * TUBE.position:g} mm and {TUBE.rotation:g} rad. Improved over recorded: "
        "median, and in brackets the worst of all; the last two columns hold the largest deviation of the tool. *All kept*: "
        "limits, ends and collisions pass `mp.check`, the duration is not longer, both jerks are lower, the minimum "
        "manipulability is not, and "
        f"the deviation is within the tolerance. CPU time per call: median {np.median(seconds):.2f} s, largest "
        f"{seconds.max():.1f} s. Python {platform.python_version()}, {platform.machine()}, one thread; command: "
        f"`.venv/bin/python benchmarks/recorded_motions.py --count {given.count}`.",
    ]
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return sum(not each.good for each in outcomes)


if __name__ == "__main__":
    raise SystemExit(main())
