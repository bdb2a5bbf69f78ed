"""Random control steps on five arms: how many have no sound answer, and how far the joints' limits are exceeded.

Run with `make benchmark`. Episodes of 250 steps from random, singular or limiting starts towards targets that jump, lie out
of reach or run along a line, with random stiffness, tube and drive, among obstacles that move and jump into the arm. Every
start is a state from which the arm can stop. Limits are checked with NumPy from the commanded motion alone. Writes
docs/benchmarks/random_steps.md, and the inputs of steps that failed to the file that --failures names.
"""

import argparse
import platform
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import Progress

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "random_steps.md"
EPISODE = 250
#: Violations beyond this share of a limit are counted; for positions it is in rad or m.
ALLOWED = 1e-9
LIMITS = ("position", "velocity", "acceleration", "jerk")

CASES = {
    "panda": (mp.formulations.LogDrive(), 0.001),
    "baxter_left": (mp.formulations.Objective(alpha=15e3, sample_time=0.01), 0.01),
    "xarm7": (mp.formulations.Equality(alpha=5e5, sample_time=0.01), 0.01),
    "ur10": (mp.formulations.Objective(alpha=15e3, sample_time=0.01, hessian="central"), 0.002),
    "kinova": (mp.formulations.General(), 0.02),
}
#: Arms whose own links are not kept apart: so many pairs that the compiler takes most of the time.
CROWDED = ("baxter_left",)


@dataclass(kw_only=True)
class Count:
    """What happened on one arm: steps, answers that failed, and by how much limits were exceeded."""

    steps: int = 0
    not_solved: int = 0
    not_finite: int = 0
    outside: int = 0
    worst: dict[str, float] = field(default_factory=lambda: dict.fromkeys(LIMITS, 0.0))
    convexified: int = 0
    contacts: int = 0
    failures: list[dict] = field(default_factory=list)


def around(robot: mp.Robot) -> mp.Avoidance:
    """A floor, a box that rests, a ball and a bar that move; mostly the arm itself, too."""
    span = reach(robot)
    floor = mp.Plane(position=robot_base(robot) - np.array([0.0, 0.0, 0.5 * span]), name="floor")
    box = mp.Box(size=[0.3 * span] * 3, position=robot_base(robot) + np.array([0.8 * span, 0.0, 0.0]), name="box")
    ball = mp.Sphere(radius=0.1 * span, position=(0.0, 0.0, 3 * span), name="ball")
    bar = mp.Capsule(radius=0.05 * span, length=0.4 * span, position=(0.0, 0.0, 4 * span), name="bar")
    return mp.Avoidance(scene=mp.Scene([floor, box, ball, bar]), moving=["ball", "bar"], itself=robot.name not in CROWDED)


def robot_base(robot: mp.Robot) -> np.ndarray:
    """Where the first joint is (3,)."""
    return robot.model.jointPlacements[1].translation.copy()


def reach(robot: mp.Robot) -> float:
    """The length of the arm stretched out [m]."""
    return float(sum(np.linalg.norm(place.translation) for place in robot.model.jointPlacements.tolist()[2:])) + 0.1


def stopping(speed: np.ndarray, change: np.ndarray, dt: float) -> np.ndarray:
    """How far joints move that go on at `speed` and slow down by `change` each step."""
    steps = np.floor(speed / change)
    return dt * ((steps + 1) * speed - change * steps * (steps + 1) / 2)


def random_start(robot: mp.Robot, rng: np.random.Generator, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """Position and velocity (n,) from which the arm can stop: random, singular, or at limits."""
    limits, n = robot.limits, robot.n
    q = robot.random_configuration(rng)
    kind = rng.integers(4)
    if kind == 1:  # stretched or folded: many joints at zero are singular
        q = np.clip(np.where(rng.random(n) < 0.7, 0.0, q), limits.lower, limits.upper)
    if kind == 2:
        least, most = np.maximum(limits.lower, -np.pi), np.minimum(limits.upper, np.pi)
        q = np.where(rng.random(n) < 0.5, np.where(rng.random(n) < 0.5, least, most), q)
    if np.isfinite(limits.jerk).any() or rng.random() < 0.3:
        return q, np.zeros(n)
    change = limits.acceleration * dt
    sign = rng.choice([-1.0, 1.0], n)
    room = np.where(sign > 0, limits.upper - q, q - limits.lower)
    slow, fast = np.zeros(n), limits.velocity.copy()
    for _ in range(60):  # the largest velocity after which the room suffices for stopping
        middle = (slow + fast) / 2
        stops = stopping(np.maximum(middle - change, 0), change, dt) <= room - 1e-12
        slow, fast = np.where(stops, middle, slow), np.where(stops, fast, middle)
    return q, sign * slow * np.where(rng.random(n) < 0.5, 1.0, rng.random(n))


class Targets:
    """Poses of an episode, one a step: jumps inside the reach and far out of it, or a line."""

    def __init__(self, robot: mp.Robot, rng: np.random.Generator, q: np.ndarray) -> None:
        self.rng, self.robot, self.span = rng, robot, reach(robot)
        self.pose = robot.kinematics().pose(q).copy()
        self.kind = rng.choice(["jump", "far", "line", "still", "near"])
        self.step = rng.normal(size=3) * self.span * 10 ** rng.uniform(-5, -2)
        self.turn = pin.exp3(rng.normal(size=3) * 10 ** rng.uniform(-5, -1))
        if self.kind == "far":
            self.jump(10 ** rng.uniform(0, 3))
        if self.kind == "near":  # another posture of the arm
            self.pose = robot.kinematics().pose(robot.random_configuration(rng)).copy()

    def jump(self, size: float) -> None:
        self.pose[:3, 3] = robot_base(self.robot) + size * self.span * self.rng.normal(size=3)
        self.pose[:3, :3] = pin.exp3(self.rng.uniform(-np.pi, np.pi, 3))

    def next(self) -> np.ndarray:
        if self.kind == "jump" and self.rng.random() < 0.05:
            self.jump(0.5)
        if self.kind == "line":
            self.pose[:3, 3] += self.step
            self.pose[:3, :3] = self.pose[:3, :3] @ self.turn
        return self.pose.copy()


class Movers:
    """Obstacles that drift, and now and then jump to a place at the arm."""

    def __init__(self, robot: mp.Robot, rng: np.random.Generator, dt: float, names: tuple[str, ...]) -> None:
        self.rng, self.dt, self.span, self.base = rng, dt, reach(robot), robot_base(robot)
        self.poses = {name: np.eye(4) for name in names}
        self.speeds = {name: np.zeros(6) for name in names}
        for name in names:
            self.place(name)

    def place(self, name: str) -> None:
        self.poses[name][:3, 3] = self.base + self.rng.uniform(0.2, 1.2) * self.span * self.direction()
        self.poses[name][:3, :3] = pin.exp3(self.rng.uniform(-np.pi, np.pi, 3))
        self.speeds[name] = self.rng.normal(size=6) * 10 ** self.rng.uniform(-2, 0.5)

    def direction(self) -> np.ndarray:
        way = self.rng.normal(size=3)
        return way / np.linalg.norm(way)

    def next(self) -> dict[str, tuple[np.ndarray, np.ndarray]]:
        for name, pose in self.poses.items():
            if self.rng.random() < 0.01:
                self.place(name)
            pose[:3, 3] += self.dt * self.speeds[name][:3]
            pose[:3, :3] = pin.exp3(self.dt * self.speeds[name][3:]) @ pose[:3, :3]
        return {name: (pose.copy(), self.speeds[name]) for name, pose in self.poses.items()}


def episode(controller: mp.Controller, rng: np.random.Generator, steps: int, count: Count) -> None:
    """One episode, counted."""
    robot, dt = controller.robot, controller.dt
    q, qd = random_start(robot, rng, dt)
    targets, movers = Targets(robot, rng, q), Movers(robot, rng, dt, ("ball", "bar"))
    stiffness, drive = 10 ** rng.uniform(0, 6), rng.choice([0.0, 1.0, 1.0, 10.0])
    tolerance = mp.Tolerance(position=10 ** rng.uniform(-4, 0), rotation=10 ** rng.uniform(-4, 0))
    controller.reset()
    positions, velocities = [q], [qd]
    for _ in range(steps):
        given = {"target": targets.next(), "stiffness": stiffness, "drive": drive}
        obstacles = movers.next()
        before = {"memory": controller._memory.copy(), "qdd": controller._acceleration.copy()}
        controller._velocity[:] = np.nan  # a step that fails inside would leave the last answer
        qd = controller.step(q, qd, **given, tolerance=tolerance, obstacles=obstacles)
        report = controller.report
        count.convexified += report.convexified > 0
        count.contacts += report.clearance < 0
        failed = report.status.brakes
        strange = not (np.isfinite(qd).all() and np.isfinite(controller._report[:5]).all())
        count.not_solved += failed
        count.not_finite += strange
        if failed or strange:
            tube = (tolerance.position, tolerance.rotation)
            around_it = controller.defaults["obstacles"]
            count.failures.append({"q": q, "qd": velocities[-1], "tolerance": tube, "obstacles": around_it, **given, **before})
        qd = np.where(np.isfinite(qd), qd, 0.0)
        q = q + dt * qd
        positions.append(q)
        velocities.append(qd)
    count.steps += steps
    judge(robot, np.array(positions), np.array(velocities), dt, count)


def judge(robot: mp.Robot, q: np.ndarray, qd: np.ndarray, dt: float, count: Count) -> None:
    """How far the motion (N + 1, n) exceeds the limits: positions in rad or m, the others as shares of their limit."""
    limits = robot.limits
    acceleration = np.diff(qd, axis=0) / dt
    jerk = np.diff(acceleration, axis=0, prepend=np.zeros((1, robot.n))) / dt
    excess = {
        "position": limits.outside(q)[1:],
        "velocity": np.abs(qd[1:]) / limits.velocity - 1,
        "acceleration": np.abs(acceleration) / limits.acceleration - 1,
        "jerk": np.abs(jerk) / limits.jerk - 1,
    }
    outside = np.zeros(len(acceleration), dtype=bool)
    for kind, values in excess.items():
        count.worst[kind] = max(count.worst[kind], float(values.max()))
        outside |= (values > ALLOWED).any(axis=1)
    count.outside += int(outside.sum())


def run(name: str, steps: int, seed: int, progress: Progress, *, compiled: bool | str = "auto") -> Count:
    """Random steps of one arm."""
    robot = mp.load_robot(name)
    formulation, dt = CASES[name]
    tube = mp.Tolerance(position=0.01, rotation=0.05)
    bar = progress.add_task(f"{name}: building", total=steps)
    controller = mp.Controller(robot, formulation, dt=dt, tolerance=tube, avoidance=around(robot), compiled=compiled)
    progress.update(bar, description=name)
    count, rng = Count(), np.random.default_rng(seed)
    while count.steps < steps:
        length = min(EPISODE, steps - count.steps)
        episode(controller, rng, length, count)
        progress.advance(bar, length)
    return count


def table(counts: dict[str, Count]) -> str:
    """The counts as a page."""
    lines = [
        "| arm, formulation, time step | steps | failed | over a limit by more than 1e-9 | worst: position [rad], velocity, "
        "acceleration, jerk [share] | in contact | made convex |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, count in counts.items():
        formulation, dt = CASES[name]
        worst = ", ".join(f"{count.worst[kind]:.0e}" for kind in LIMITS)
        lines.append(
            f"| {name}, {type(formulation).__name__}, {1e3 * dt:g} ms | {count.steps} | {count.not_solved + count.not_finite} "
            f"| {count.outside} | {worst} | {count.contacts} | {count.convexified} |"
        )
    total = [sum(getattr(c, each) for c in counts.values()) for each in ("steps", "not_solved", "not_finite", "outside")]
    lines.append(f"| all | {total[0]} | {total[1] + total[2]} | {total[3]} | | | |")
    told = f"Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`."
    return "\n".join([*lines, "", told, ""])


def main(arguments: list[str] | None = None) -> dict[str, Count]:
    """Run, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--arms", nargs="+", choices=list(CASES), default=list(CASES))
    parser.add_argument("--out", type=Path, default=OUT)
    parser.add_argument("--failures", type=Path, default=None, help="a file .npz for the inputs of steps that failed")
    parser.add_argument("--interpreted", action="store_true", help="without the compiler")
    options = parser.parse_args(arguments)
    each = -(-options.steps // len(options.arms))
    counts = {}
    with Progress() as progress:
        for k, name in enumerate(options.arms):
            compiled = False if options.interpreted else "auto"
            counts[name] = run(name, each, options.seed + k, progress, compiled=compiled)
    text = table(counts)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(text)
    print(text)
    failures = [{"arm": name, **failure} for name, count in counts.items() for failure in count.failures]
    if options.failures is not None:
        np.savez(options.failures, failures=np.array(failures, dtype=object))
    return counts


if __name__ == "__main__":
    main()
