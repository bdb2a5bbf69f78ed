"""Control steps of manipplan beside those of pink, placo, mink, roboplan and the Robotics Toolbox: time and quality.

Run with `make benchmark-peers`; the peers' environments are made on the first run (about 3 GB). Everything is measured in
this one run, on one thread. Writes docs/benchmarks/tracking.md; times are of this machine, ratios travel better.
"""

import argparse
import platform
import sys
import time
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import Progress

import manipplan as mp

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "benchmarks" / "peers"))
from run import PEERS, run_peer  # noqa: E402

OUT = ROOT / "docs" / "benchmarks" / "tracking.md"
DT = 0.01
START = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4])
#: Metres that a radian of deviation counts as.
RADIAN = 0.25
#: Factors on the peers' tuned manipulability terms.
COSTS = (0.0, 0.3, 1.0, 3.0, 10.0, 30.0)
WITH_TERM = ("pink", "placo", "rtb")


@dataclass(frozen=True, kw_only=True)
class Quality:
    """Results of a path: minimum and mean m, worst deviation [m], worst use of velocity and acceleration, failures."""

    least: float
    mean: float
    deviation: float
    velocity: float
    acceleration: float
    failed: int


class Judge:
    """Measures every solver's motion in the same way, with Pinocchio alone."""

    def __init__(self, robot: mp.Robot) -> None:
        self.model, self.limits = robot.model, robot.limits
        self.data = self.model.createData()
        self.frame = self.model.getFrameId(robot.tool)

    def quality(self, poses: np.ndarray, q: np.ndarray, failed: int) -> Quality:
        """Of positions q (N, n) after each of the N targets."""
        index, deviation = [], []
        for target, each in zip(poses, q, strict=True):
            pin.computeJointJacobians(self.model, self.data, each)
            place = pin.updateFramePlacement(self.model, self.data, self.frame)
            jacobian = pin.getFrameJacobian(self.model, self.data, self.frame, pin.LOCAL_WORLD_ALIGNED)
            index.append(np.prod(np.linalg.svd(jacobian, compute_uv=False)))
            turned = np.linalg.norm(pin.log3(target[:3, :3] @ place.rotation.T))
            deviation.append(max(np.linalg.norm(target[:3, 3] - place.translation), RADIAN * turned))
        qd = np.diff(np.vstack([START, q]), axis=0) / DT
        qdd = np.diff(np.vstack([np.zeros(len(START)), qd]), axis=0) / DT
        return Quality(
            least=min(index),
            mean=float(np.mean(index)),
            deviation=max(deviation),
            velocity=float((np.abs(qd) / self.limits.velocity).max()),
            acceleration=float((np.abs(qdd) / self.limits.acceleration).max()),
            failed=failed,
        )


def paths(robot: mp.Robot) -> dict[str, np.ndarray]:
    """Targets (N, 4, 4) of each path; the first ends at the edge of the arm's reach."""
    start = robot.kinematics().pose(START)

    def line(direction: tuple[float, float, float], seconds: float) -> np.ndarray:
        end = start.copy()
        end[:3, 3] += direction
        u = np.arange(1, round(seconds / DT) + 1) / round(seconds / DT)
        return mp.CartesianPath.line(start, end)(10 * u**3 - 15 * u**4 + 6 * u**5)

    u = np.arange(1, 401) / 400
    circle = mp.CartesianPath.circle(start, start[:3, 3] - [0.12, 0.0, 0.0], (0.0, 0.0, 1.0))
    return {
        "singular: 0.3 m outwards, to the edge of reach": line((0.3, 0.0, 0.0), 2.0),
        "0.3 m sideways": line((0.0, 0.3, 0.0), 2.0),
        "0.3 m upwards": line((0.0, 0.0, 0.3), 2.0),
        "0.4 m down and inwards": line((-0.2, 0.1, -0.33), 3.0),
        "circle of 0.24 m": circle(10 * u**3 - 15 * u**4 + 6 * u**5),
    }


def problem(robot: mp.Robot, poses: np.ndarray) -> dict:
    """A problem as the peers' scripts take it."""
    from example_robot_data.robots_loader import PandaLoader

    return {
        "urdf": str(PandaLoader().df_path),
        "package_dir": "",
        "frame": robot.tool,
        "active": list(robot.joint_names),
        "locked": list(robot.locked),
        "locked_q": list(robot.locked.values()),
        "q0": START,
        "dt": DT,
        "poses": poses,
        "velocity": robot.limits.velocity,
        "acceleration": robot.limits.acceleration,
        "lower": robot.limits.lower,
        "upper": robot.limits.upper,
    }


def five_spheres() -> mp.Avoidance:
    """Five spheres that a hand keeps away from."""
    spheres = [mp.Sphere(radius=0.05, position=(0.5, 0.1 * k - 0.2, 0.15), name=f"ball{k}") for k in range(5)]
    return mp.Avoidance(scene=mp.Scene(spheres), links=["panda_hand"], itself=False)


def ours(robot: mp.Robot, judge: Judge, poses: np.ndarray, allowed: float) -> Quality:
    """Our best motion whose worst deviation is at most `allowed` [m], of a sweep as the peers have one."""
    tube = mp.Tolerance(position=allowed, rotation=allowed / RADIAN)
    found = []
    for weight, stiffness, tolerance in product(WEIGHTS, STIFFNESSES, (tube, None)):
        controller = mp.Controller(robot, mp.formulations.LogDrive(weight), dt=DT, tolerance=tolerance, stiffness=stiffness)
        motion = controller.rollout(START, poses)
        failed = sum(mp.results.StepStatus(int(status)).brakes for status in motion["status"])
        found.append(judge.quality(poses, motion.q[1:], failed))
    inside = [quality for quality in found if quality.deviation <= 1.01 * allowed]
    if not inside:
        return min(found, key=lambda quality: quality.deviation)
    return max(inside, key=lambda quality: (round(quality.least, 4), quality.mean))


#: What our drive and stiffness are swept over.
WEIGHTS = (1.0, 10.0, 100.0)
STIFFNESSES = (1.0, 1e2, 1e4, 1e6, 1e8)


def step_times(controller: mp.Controller, poses: np.ndarray, rounds: int) -> np.ndarray:
    """Seconds of each step of a control loop (rounds * N,)."""
    seconds = []
    for _ in range(rounds):
        q, qd = START.copy(), np.zeros(len(START))
        controller.reset()
        for pose in poses:
            began = time.perf_counter()
            qd = controller.step(q, qd, pose)
            seconds.append(time.perf_counter() - began)
            q = q + DT * qd
    return np.array(seconds)


def times(robot: mp.Robot, poses: np.ndarray, peers: dict[str, np.ndarray], again: object) -> list[str]:
    """The table of step times; peers' times are measured before and after ours."""
    rows = []
    solvers = {
        "(14)": mp.formulations.Equality(5e5),
        "LogDrive": mp.formulations.LogDrive(),
        "(10), exact Hessian": mp.formulations.Objective(15e3),
    }
    measured = {}
    for name, formulation in solvers.items():
        for compiled in (True, False):
            controller = mp.Controller(robot, formulation, dt=DT, avoidance=five_spheres(), compiled=compiled)
            step_times(controller, poses, 2)
            measured[name, compiled] = step_times(controller, poses, 20)
            if compiled:
                best = []
                for _ in range(50):
                    began = time.perf_counter()
                    controller.rollout(START, poses)
                    best.append((time.perf_counter() - began) / len(poses))
                measured[name, "rollout"] = np.array(best)
    peers = {name: np.concatenate([peers[name], seconds]) for name, seconds in again().items()}  # type: ignore[operator]
    placo, pink = np.median(peers["placo"]) if "placo" in peers else np.nan, np.median(peers.get("pink", np.array([np.nan])))
    rows.append(
        "| step of a 7-joint arm, pose task, limits | collision rows | median | 99 % | placo's over it | pink's over it |"
    )
    rows.append("|---|---|---|---|---|---|")
    labels = {True: "compiled, from Python", False: "without a compiler", "rollout": "rollout in C"}
    for (name, kind), seconds in measured.items():
        middle, high = np.median(seconds), np.percentile(seconds, 99)
        tail = "" if kind == "rollout" else f"{1e6 * high:.2f} µs"
        rows.append(
            f"| ours, {name}, {labels[kind]} | 5 | {1e6 * middle:.2f} µs | {tail} "
            f"| {placo / middle:.1f} x | {pink / middle:.0f} x |"
        )
    for name, seconds in peers.items():
        middle, high = np.median(seconds), np.percentile(seconds, 99)
        term = "with its manipulability term" if name in WITH_TERM else "has no such term"
        rows.append(f"| {name}, {term} | 0 | {1e6 * middle:.1f} µs | {1e6 * high:.1f} µs | {placo / middle:.2f} x | |")
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--environments", type=Path, default=ROOT / ".peers", help="folder of the peers' environments")
    folder = parser.parse_args().environments
    robot = mp.load_robot("panda")
    judge, suite = Judge(robot), paths(robot)
    missing: dict[str, str] = {}
    found: dict[str, dict[str, list[Quality]]] = {name: {} for name in suite}
    easy = suite["0.3 m sideways"]

    def timed() -> dict[str, np.ndarray]:
        seconds = {}
        for peer in PEERS:
            if peer in missing:
                continue
            try:
                answer = run_peer(peer, problem(robot, easy) | {"manipulability_cost": 1.0}, folder)
                seconds[peer] = answer["time"]
            except RuntimeError as error:
                missing[peer] = str(error)
        return seconds

    with Progress() as progress:
        bar = progress.add_task("peers", total=len(suite) * len(PEERS) + 3)
        before = timed()
        progress.advance(bar)
        table = times(robot, easy, before, timed)
        progress.advance(bar)
        for name, poses in suite.items():
            for peer in before:
                costs = COSTS if peer in WITH_TERM else (0.0,)
                answers = [run_peer(peer, problem(robot, poses) | {"manipulability_cost": cost}, folder) for cost in costs]
                found[name][peer] = [judge.quality(poses, each["q"], int(each["failed"].sum())) for each in answers]
                progress.advance(bar)
    lines = [
        *table,
        "",
        "| path | solver | minimum manipulability | mean manipulability | worst deviation | velocity | acceleration | failed |"
        " ours, minimum manipulability | mean | deviation | acceleration |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for name, by_peer in found.items():
        for peer, qualities in by_peer.items():
            best = max(qualities, key=lambda quality: quality.least)
            allowed = max(best.deviation, 1e-4)  # a tube has to have a width
            mine = ours(robot, judge, suite[name], allowed)
            lines.append(
                f"| {name} | {peer} | {best.least:.4f} | {best.mean:.4f} | {1e3 * best.deviation:.2f} mm "
                f"| {best.velocity:.2f} | {best.acceleration:.2f} | {best.failed} | {mine.least:.4f}, "
                f"{mine.least / best.least:.2f} x | {mine.mean:.4f} | {1e3 * mine.deviation:.2f} mm | {mine.acceleration:.2f} |"
            )
    for peer, why in missing.items():
        lines.append(f"\n{peer} could not be run: {why.splitlines()[-1]}")
    lines += [
        "",
        f"Panda, dt = 10 ms; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark-peers`.",
    ]
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
