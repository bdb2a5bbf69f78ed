"""Random paths timed by `mp.retime`: how far limits are exceeded, how long it takes, and how near the motion is to the fastest.

Run with `make benchmark`. Paths are polynomials, splines, polylines with corners, and curves with a standstill or a cusp
inside, 1e-4 to 1e3 rad long, on three arms; shares of them with torque limits, jerk limits, a segment of tighter limits, or
speeds at the ends. Trajectories are judged here with NumPy and Pinocchio's inverse dynamics from their samples alone. Writes
docs/benchmarks/timing.md.
"""

import argparse
import logging
import platform
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import Progress

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "timing.md"
#: Violations beyond this share of a limit are counted.
ALLOWED = 1e-6
ARMS = ("planar", "ur5", "panda")
PATHS = ("polynomial", "spline", "polyline", "standstill", "cusp")
EXTRAS = ("none", "torque", "jerk", "segment", "speeds", "jerk and torque", "jerk and speeds")
SHARES = (0.5, 0.1, 0.15, 0.08, 0.07, 0.05, 0.05)
#: Points at which each piece of a trajectory is judged.
POINTS = np.linspace(0.0, 1.0, 12)
CHUNK = 25


@dataclass(kw_only=True)
class Count:
    """What happened to the paths of one kind."""

    paths: int = 0
    outside: int = 0
    worst: dict[str, float] = field(default_factory=dict)
    seconds: list[float] = field(default_factory=list)
    refused: int = 0
    failures: list[str] = field(default_factory=list)

    def add(self, other: "Count") -> None:
        self.paths += other.paths
        self.outside += other.outside
        self.refused += other.refused
        self.seconds += other.seconds
        self.failures += other.failures
        for kind, value in other.worst.items():
            self.worst[kind] = max(self.worst.get(kind, -np.inf), value)


def arm(name: str) -> mp.Robot:
    """An arm without jerk limits."""
    if name == "planar":
        return mp.planar_arm([1.0, 0.8, 0.5]).with_limits(velocity=[2.0, 2.5, 3.0], acceleration=[8.0, 10.0, 15.0])
    return mp.load_robot(name).with_limits(jerk=np.inf)


def random_path(rng: np.random.Generator, kind: str, n: int) -> mp.JointPath:
    """A path of this kind, 1e-4 to 1e3 rad long."""
    if kind == "polynomial":
        breaks, control = [0.0, 1.0], rng.normal(size=(1, rng.integers(2, 9), n))
    elif kind == "spline":
        count = rng.integers(4, 16)
        s = np.concatenate([[0.0], np.cumsum(rng.uniform(0.3, 1.0, count - 1))])
        spline = mp.JointPath.spline(s / s[-1], np.cumsum(rng.normal(size=(count, n)), axis=0))
        breaks, control = spline.breaks, spline.control
    elif kind == "polyline":
        line = mp.JointPath.through(np.cumsum(rng.normal(size=(rng.integers(3, 9), n)), axis=0))
        breaks, control = line.breaks, line.control
    elif kind == "standstill":  # a straight or curved way that stands still inside: q' = (x - x0)² times something
        middle, ends = rng.normal(size=n), rng.normal(size=(2, n))
        join = rng.uniform(0.2, 0.8)
        before, after = [ends[0], middle + rng.normal(size=n), middle, middle], [middle, middle, ends[1], ends[1] + 1.0]
        control = np.array([before, after])
        breaks = [0.0, join, 1.0]
    else:  # q' changes its direction through zero
        x0 = rng.uniform(0.3, 0.7)
        powers = rng.normal(size=(2, n))
        x = np.polynomial.Polynomial([-x0, 1.0])
        c = sum(p[None] * np.pad((x**k).coef, (0, 3 - k))[:, None] for p, k in zip(powers, (3, 2), strict=True))
        control = np.array([[c[0], c[0] + c[1] / 3, c[0] + 2 * c[1] / 3 + c[2] / 3, c.sum(axis=0)]])
        breaks = [0.0, 1.0]
    path = mp.JointPath(breaks=breaks, control=control)
    size = 10 ** rng.uniform(-4, 3) / path.length
    return mp.JointPath(breaks=breaks, control=rng.uniform(-1, 1, n) + size * (np.asarray(control) - np.asarray(control)[0, 0]))


def judge(trajectory: mp.Trajectory, limits: mp.JointLimits, model: pin.Model | None) -> dict[str, float]:
    """By what share a trajectory's samples (t, q, qd), joined by cubics, exceed limits; jumps of acceleration as they are."""
    h = np.diff(trajectory.t)[:, None]
    q0, q1, v0, v1 = trajectory.q[:-1], trajectory.q[1:], trajectory.qd[:-1], trajectory.qd[1:]
    mean = (q1 - q0) / h
    start = 2 * (3 * mean - 2 * v0 - v1) / h
    slope = 6 * (v0 + v1 - 2 * mean) / h**2
    u = POINTS[:, None, None] * h
    qdd = start + slope * u
    qd = v0 + u * (start + slope * u / 2)
    excess = {
        "velocity": float((np.abs(qd) / limits.velocity).max() - 1),
        "acceleration": float((np.abs(qdd) / limits.acceleration).max() - 1),
    }
    if np.isfinite(limits.jerk).any():
        excess["jerk"] = float((np.abs(slope) / limits.jerk).max() - 1)
        jumps = np.abs(qdd[-1, :-1] - qdd[0, 1:])
        resting = [np.abs(qdd[i, j]) for i, j in ((0, 0), (-1, -1)) if not trajectory.qd[j].any()]
        excess["jump"] = float((np.vstack([jumps, *resting]) / limits.acceleration).max())
    if model is not None:
        data = model.createData()
        q = q0 + u * (v0 + u * (start / 2 + u * slope / 6))
        rows = np.stack([q, qd, qdd], axis=2).reshape(-1, 3, len(q0[0]))
        torque = np.array([pin.rnea(model, data, *row).copy() for row in rows])
        excess["torque"] = float((np.abs(torque) / limits.effort).max() - 1)
    return excess


def judge_segment(trajectory: mp.Trajectory, path: mp.JointPath, segment: mp.Segment, limits: mp.JointLimits) -> float:
    """The same for the shares of velocity and acceleration that a segment allows, at times when the motion is inside it."""
    t = np.linspace(0.0, trajectory.duration, 20001)
    speed = np.linalg.norm(trajectory(t, 1), axis=1)
    gone = np.concatenate([[0.0], np.cumsum((speed[1:] + speed[:-1]) / 2)]) * t[1]
    s = np.linspace(0.0, 1.0, 20001)
    pace = np.linalg.norm(path(s, 1), axis=1)
    length = np.concatenate([[0.0], np.cumsum((pace[1:] + pace[:-1]) / 2)]) * s[1]
    at = np.interp(gone / gone[-1], length / length[-1], s)
    inside = (at > segment.begin + 2e-3) & (at < segment.end - 2e-3)
    if not inside.any():
        return -1.0
    velocity = np.abs(trajectory(t[inside], 1)) / (segment.velocity * limits.velocity)
    acceleration = np.abs(trajectory(t[inside], 2)) / (segment.acceleration * limits.acceleration)
    return float(max(velocity.max(), acceleration.max()) - 1)


def one(robot: mp.Robot, seed: int, count: Count) -> tuple[str, str]:
    """One random path, timed, judged and counted; its kind and what is asked of it."""
    rng = np.random.default_rng(seed)
    kind, extra = str(rng.choice(PATHS)), str(rng.choice(EXTRAS, p=SHARES))
    path = random_path(rng, kind, robot.n)
    changes: dict[str, np.ndarray] = {"acceleration": robot.limits.acceleration * 10 ** rng.uniform(-1, 1)}
    model = None
    if "jerk" in extra:
        changes["jerk"] = changes["acceleration"] * 10 ** rng.uniform(0.3, 3)
    if "torque" in extra:
        model, data = robot.model, robot.model.createData()
        weight = [np.abs(pin.computeGeneralizedGravity(model, data, q)) for q in path(np.linspace(0, 1, 1001))]
        changes["effort"] = 1.2 * np.max(weight, axis=0) + 10 ** rng.uniform(-1, 1.5)
    limits = robot.limits.with_changes(changes)
    options: dict[str, object] = {}
    if extra == "segment":
        begin = rng.uniform(0.1, 0.6)
        options["segments"] = [
            mp.Segment(
                begin=begin, end=rng.uniform(begin + 0.1, 0.95), velocity=rng.uniform(0.1, 1), acceleration=rng.uniform(0.1, 1)
            )
        ]
    speeds = 10 ** rng.uniform(-2, 0.5, 2) if "speeds" in extra else None
    count.paths += 1
    began = time.process_time()
    try:
        for attempt in range(12):  # speeds that limits do not allow are refused: halve them
            if speeds is not None:
                options.update(start_speed=float(speeds[0]), end_speed=float(speeds[1]))
            try:
                trajectory = mp.retime(path, robot, limits=limits, torque=model is not None, **options)
                break
            except mp.errors.InvalidInputError as error:
                if error.argument not in ("start_speed", "end_speed") or attempt == 11:
                    raise
                count.refused += attempt == 0
                speeds = speeds / 4
    except Exception as error:  # each kind is counted and told
        count.failures.append(f"{type(error).__name__}: {error} (seed {seed}, {robot.name}, {kind}, {extra})")
        return kind, extra
    count.seconds.append(time.process_time() - began)
    excess = judge(trajectory, limits, model)
    if speeds is not None:
        wanted = [float(np.linalg.norm(trajectory.qd[k])) for k in (0, -1)]
        excess["speeds"] = float(np.abs(np.array(wanted) / speeds - 1).max())
    excess["ends"] = float(np.abs(trajectory.q[[0, -1]] - [path.start, path.goal]).max() / max(path.length, 1.0))
    if extra == "segment" and kind in ("polynomial", "spline"):
        excess["segment"] = judge_segment(trajectory, path, options["segments"][0], limits)
    outside = any(value > ALLOWED for value in excess.values())
    count.outside += outside
    if outside:
        told = ", ".join(f"{name} {value:.1e}" for name, value in excess.items())
        count.failures.append(f"outside: {told} (seed {seed}, {robot.name}, {kind}, {extra})")
    for name, value in excess.items():
        count.worst[name] = max(count.worst.get(name, -np.inf), value)
    return kind, extra


def chunk(name: str, seeds: range) -> dict[str, Count]:
    """Some random paths of one arm, by what is asked of them."""
    robot = arm(name)
    counts: dict[str, Count] = {}
    for seed in seeds:
        count = Count()
        _, extra = one(robot, seed, count)
        counts.setdefault(extra, Count()).add(count)
    return counts


def optimum(path: mp.JointPath, limits: mp.JointLimits, points: int = 1000) -> float | None:
    """Duration of toppra's own answer on a regular path, on a grid of its parameter."""
    import toppra
    from toppra.interpolator import AbstractGeometricPath

    class Given(AbstractGeometricPath):
        dof = path.n
        path_interval = np.array([0.0, 1.0])
        waypoints = None

        def __call__(self, s, order=0):
            return path(np.clip(s, 0.0, 1.0), order)

    both = [np.column_stack([-each, each]) for each in (limits.velocity, limits.acceleration)]
    scheme = toppra.constraint.DiscretizationType.Interpolation
    constraints = [
        toppra.constraint.JointVelocityConstraint(both[0]),
        toppra.constraint.JointAccelerationConstraint(both[1], discretization_scheme=scheme),
    ]
    s = np.union1d(np.linspace(0.0, 1.0, points + 1), path.breaks)
    s = s[np.concatenate([[True], np.diff(s) > 1e-6])]
    s[-1] = 1.0
    algorithm = toppra.algorithm.TOPPRA(constraints, Given(), gridpoints=s, solver_wrapper="seidel")
    _, speed, _ = algorithm.compute_parameterization(0.0, 0.0)
    if speed is None or not np.isfinite(speed).all() or (speed[1:-1] <= 0).any():
        return None
    return float((2 * np.diff(s) / (speed[:-1] + speed[1:])).sum())


def compared(name: str, seeds: range) -> list[float]:
    """Durations of `mp.retime` over toppra's, on random polynomials and splines of 0.1 to 30 rad that slow down nowhere."""
    logging.getLogger("toppra").setLevel(logging.ERROR)
    robot = arm(name)
    ratios = []
    for seed in seeds:
        rng = np.random.default_rng(seed)
        while True:
            path = random_path(rng, str(rng.choice(PATHS[:2])), robot.n)
            speed = np.linalg.norm(path(np.linspace(0, 1, 4001), 1), axis=1)
            if 0.1 < path.length < 30 and speed.min() > 0.1 * speed.mean():
                break
        limits = robot.limits.with_changes({"acceleration": robot.limits.acceleration * 10 ** rng.uniform(-1, 1)})
        fastest = optimum(path, limits)
        if fastest is not None:
            ratios.append(mp.retime(path, robot, limits=limits).duration / fastest)
    return ratios


def page(counts: dict[str, Count], ratios: list[float]) -> str:
    """The counts as a page."""
    kinds = ("velocity", "acceleration", "jerk", "torque", "segment")
    lines = [
        "| asked beside velocity and acceleration | paths | failed | over a limit by more than 1e-6 | worst: velocity, "
        "acceleration, jerk, torque, segment [share over the limit] | median, worst processor time [s] |",
        "|---|---|---|---|---|---|",
    ]
    for extra in EXTRAS:
        count = counts.get(extra)
        if count is None or not count.paths:
            continue
        worst = ", ".join(f"{max(count.worst[kind], 0.0):.0e}" if kind in count.worst else "–" for kind in kinds)
        failed = sum(not told.startswith("outside") for told in count.failures)
        seconds = np.array(count.seconds or [np.nan])
        lines.append(
            f"| {extra} | {count.paths} | {failed} | {count.outside} | {worst} "
            f"| {np.median(seconds):.3f}, {seconds.max():.2f} |"
        )
    total = [sum(getattr(c, each) for c in counts.values()) for each in ("paths", "outside", "refused")]
    failures = [told for count in counts.values() for told in count.failures if not told.startswith("outside")]
    lines.append(f"| all | {total[0]} | {len(failures)} | {total[1]} | | |")
    jump = max((count.worst.get("jump", 0.0) for count in counts.values()), default=0.0)
    speeds = max((count.worst.get("speeds", 0.0) for count in counts.values()), default=0.0)
    lines += [
        "",
        f"With jerk limits acceleration jumps between samples, and is at stops, at most {jump:.0e} of its limit. Speeds asked "
        f"for at the ends are met to {speeds:.0e}; in {total[2]} cases the first ones were beyond what limits allow, which is "
        "refused with the most that they do, and smaller ones were asked for.",
    ]
    if failures:
        by_kind = Counter(told.split(":")[0] for told in failures)
        lines += ["", "Failures: " + ", ".join(f"{number} {kind}" for kind, number in by_kind.items()) + "."]
    if ratios:
        lines += [
            "",
            f"Duration over that of toppra's own answer on 1,000 grid points, on {len(ratios)} regular paths: median "
            f"{np.median(ratios):.4f}, worst {np.max(ratios):.4f}, least {np.min(ratios):.4f}.",
        ]
    told = f"Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`."
    return "\n".join([*lines, "", told, ""])


def main(arguments: list[str] | None = None) -> dict[str, Count]:
    """Run, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--paths", type=int, default=10_000)
    parser.add_argument("--compared", type=int, default=1_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=np.inf, help="stop after this long; the table counts what was run")
    parser.add_argument("--out", type=Path, default=OUT)
    options = parser.parse_args(arguments)
    counts: dict[str, Count] = {}
    ratios: list[float] = []
    began = time.monotonic()
    with ProcessPoolExecutor(options.workers) as pool, Progress() as progress:
        work = [range(k, min(k + CHUNK, options.compared)) for k in range(0, options.compared, CHUNK)]
        bar = progress.add_task("against toppra", total=len(work))
        for found in pool.map(compared, [ARMS[k % len(ARMS)] for k in range(len(work))], work):
            ratios += found
            progress.advance(bar)
        last = options.seed + options.paths
        work = [range(k, min(k + CHUNK, last)) for k in range(options.seed, last, CHUNK)]
        bar = progress.add_task("random paths", total=len(work))
        for found in pool.map(chunk, [ARMS[k % len(ARMS)] for k in range(len(work))], work):
            for extra, count in found.items():
                counts.setdefault(extra, Count()).add(count)
            progress.advance(bar)
            if time.monotonic() - began > 60 * options.minutes:
                pool.shutdown(wait=False, cancel_futures=True)
                break
    text = page(counts, ratios)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(text)
    print(text)
    for told in (told for count in counts.values() for told in count.failures):
        print(told)
    return counts


if __name__ == "__main__":
    main()
