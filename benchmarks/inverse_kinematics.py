"""All inverse kinematics of random poses: how many random configurations are found again, and the time beside EAIK and ssik.

Run with `make benchmark-peers`; the peers' environments are made on the first run. Everything is measured in this one run, on
one thread, the peers' figures by their own scripts in benchmarks/peers. Writes docs/benchmarks/inverse_kinematics.md; times
are of this machine, ratios travel better.
"""

import argparse
import os
import platform
import sys
import time
from collections.abc import Callable
from itertools import combinations
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
import pinocchio as pin
from rich.progress import Progress

import manipplan as mp
from manipplan.ik.bridge import swivels_of
from manipplan.ik.form import closed_form
from manipplan.ik.geometry import Screws
from manipplan.ik.solutions import distinct
from manipplan.ik.solver import REACHED, Solver

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "benchmarks" / "peers"))
from run import run_peer  # noqa: E402  # its folder is put on the path first

OUT = ROOT / "docs" / "benchmarks" / "inverse_kinematics.md"
ARMS = ("simple_humanoid_right_arm", "panda", "talos_right_arm", "ur5", "xarm7")
#: The joint that is held in the comparison with EAIK, which knows no swivel; None for six joints.
HELD = {"simple_humanoid_right_arm": 0, "panda": 6, "talos_right_arm": 0, "ur5": None, "xarm7": 6}
SSIK = {"panda": "franka_panda_ik", "ur5": "ur5_ik", "xarm7": "xarm7_ik", "z1": "z1_ik"}
POSES, ALONE, GRID, BLOCK, REPEATS = 20_000, 2_000, 1_000, 5_000, 5


def parameters(robot: mp.Robot, q: np.ndarray) -> np.ndarray:
    """The values (k, r) of what the arm has to spare at q (k, n)."""
    form = closed_form(robot)
    values = q[:, list(form.held)]
    if form.name == "swivel":
        free = list(form.free)
        axes, points = form.screws.axes[free], form.screws.points[free]
        wrist, shoulder = form.meeting
        values = np.column_stack([values, swivels_of(axes, points, shoulder, wrist, q[:, free])])
    return np.ascontiguousarray(values)


def pinocchio_misses(robot: mp.Robot, q: np.ndarray, poses: np.ndarray) -> np.ndarray:
    """The largest entry (k,) by which each q (k, n) misses its pose, by Pinocchio alone."""
    data = robot.model.createData()
    frame = robot.model.getFrameId(robot.tool, pin.FrameType.BODY)
    worst = np.empty(len(q))
    for k, each in enumerate(q):
        pin.framesForwardKinematics(robot.model, data, each)
        worst[k] = np.abs(data.oMf[frame].homogeneous - poses[k]).max()
    return worst


def recall(robot: mp.Robot, count: int, tick: Callable[[int], None]) -> tuple[float, float, float, float]:
    """Of `count` random q: the share found again to 1e-6 and to 1e-4, answers a pose, and the worst residual by Pinocchio."""
    rng = np.random.default_rng(20261121)
    solver = Solver.of(robot, task=None, held=None, method="closed-form", seed=0)
    endless = ~np.isfinite(robot.limits.lower)
    hits = close = rows = 0
    worst = 0.0
    for begin in range(0, count, BLOCK):
        q = robot.random_configuration(rng, size=min(BLOCK, count - begin))
        poses = solver.kinematics.pose(q)
        found = solver.solve(poses, np.arange(len(q)), parameters(robot, q))
        keep = distinct(found.q, found.source)
        answers, source = found.q[keep], found.source[keep]
        difference = answers - q[source]
        difference = np.where(endless, (difference + np.pi) % (2 * np.pi) - np.pi, difference)
        nearest = np.full(len(q), np.inf)
        np.minimum.at(nearest, source, np.abs(difference).max(axis=1))
        hits, close, rows = hits + (nearest < 1e-6).sum(), close + (nearest < 1e-4).sum(), rows + len(keep)
        some = slice(None, None, max(1, len(keep) // 1000))
        worst = max(worst, pinocchio_misses(robot, answers[some], poses[source[some]]).max())
        tick(len(q))
    return hits / count, close / count, rows / count, worst


def best(work: Callable[[], object]) -> tuple[float, object]:
    """The least time of some runs [s], and what came out."""
    times = []
    for _ in range(REPEATS):
        began = time.perf_counter()
        out = work()
        times.append(time.perf_counter() - began)
    return min(times), out


def exact_rows(robot: mp.Robot, q: np.ndarray, poses: np.ndarray) -> tuple[int, int]:
    """How many rows reach their pose to 1e-10, and how many of these fit into the limits, by a full turn more or less."""
    good = q[np.abs(robot.kinematics(mp.Task.pose()).pose(q) - poses).max(axis=(1, 2)) <= REACHED]
    lower = np.where(np.isfinite(robot.limits.lower), robot.limits.lower, -np.pi)
    upper = np.where(np.isfinite(robot.limits.upper), robot.limits.upper, np.pi)
    return len(good), int((lower + (good - lower) % (2 * np.pi) <= upper).all(axis=1).sum())


def compared(name: str, folder: Path) -> list[str]:
    """Rows of the table beside EAIK: one value of the held joint for many poses, and one pose with many values."""
    robot, joint = mp.load_robot(name), HELD[name]
    wide = robot.with_limits(lower=-np.pi, upper=np.pi)
    q = robot.random_configuration(np.random.default_rng(1), size=POSES)
    poses = robot.kinematics(mp.Task.pose()).pose(q)
    held = None if joint is None else [robot.joint_names[joint]]
    value = 0.0 if joint is None else 0.4  # inside all limits
    low, high = (0.0, 0.0) if joint is None else (robot.limits.lower[joint], robot.limits.upper[joint])
    grid = np.linspace(low, high, GRID)
    screws = Screws.of(robot)
    problem = {
        "axes": screws.axes,
        "points": screws.points,
        "home": screws.home,
        "poses": poses,
        "held": -1 if joint is None else joint,
        "value": value,
        "values": np.zeros(ALONE) if joint is None else q[:ALONE, joint],
        "grid": grid,
    }

    def ours(arm: mp.Robot, targets: np.ndarray, given: object) -> tuple[float, int]:
        given = None if joint is None else given
        seconds, found = best(lambda: mp.inverse_kinematics(arm, targets, given, held=held))
        return seconds, len(found)

    answer = run_peer("eaik", problem, folder, "solutions")
    measured = {
        "poses, no limits": (*ours(wide, poses, [value]), POSES),
        "poses, limits": (*ours(robot, poses, [value]), POSES),
    }
    if joint is not None:
        measured["values, no limits"] = (*ours(wide, poses[:1], grid[:, None]), GRID)
        measured["values, limits"] = (*ours(robot, poses[:1], grid[:, None]), GRID)
    again = run_peer("eaik", problem, folder, "solutions")  # before and after ours
    rows = []
    for case, (seconds, count, size) in measured.items():
        kind = "batch" if case.startswith("poses") else "grid"
        what = f"{size} {'poses, one value of the joint' if kind == 'batch' else 'values of the joint, one pose'}"
        if joint is None:
            what = f"{size} poses"
        what += ", joints in [-π, π]" if case.endswith("no limits") else ", limits of the arm"
        mine = 1e6 * seconds / max(count, 1)
        line = f"| {name}, {'joint ' + str(joint + 1) if joint is not None else 'no joint held'} | {what} | {count / size:.2f} "
        line += f"| {1e6 * seconds / size:.2f} | {mine:.2f} "
        if not answer["known"]:
            rows.append(line + "| refuses | | | |")
            continue
        bare = min(float(answer[kind]), float(again[kind]))
        targets = poses[answer[f"{kind}_source"]] if kind == "batch" else np.repeat(poses[:1], len(answer[f"{kind}_q"]), axis=0)
        exact, inside = exact_rows(robot, answer[f"{kind}_q"], targets)
        usable = exact if case.endswith("no limits") else inside
        theirs = 1e6 * bare / max(usable, 1)
        rows.append(line + f"| {usable / size:.2f} | {1e6 * bare / size:.2f} | {theirs:.2f} | {theirs / mine:.1f} x |")
    if answer["known"]:
        near = np.full(ALONE, np.inf)
        off = np.abs((answer["alone_q"] - q[answer["alone_source"]] + np.pi) % (2 * np.pi) - np.pi).max(axis=1)
        np.minimum.at(near, answer["alone_source"], off)
        misses = (near > 1e-6).sum()
        rows.append(
            f"| {name}, its own value for each pose | {ALONE} poses; EAIK makes a robot for each | | | | "
            f"| {1e6 * float(answer['alone']) / ALONE:.2f} | finds {ALONE - misses} of {ALONE} again | |"
        )
    return rows


def swivelled(name: str) -> str:
    """The row of our swivel, for which EAIK has nothing."""
    robot = mp.load_robot(name)
    q = robot.random_configuration(np.random.default_rng(1), size=POSES)
    poses = robot.kinematics(mp.Task.pose()).pose(q)
    seconds, found = best(lambda: mp.inverse_kinematics(robot, poses[:1], samples=GRID))
    return (
        f"| {name}, swivel | {GRID} values of the swivel, one pose, limits of the arm | {len(found) / GRID:.2f} "
        f"| {1e6 * seconds / GRID:.2f} | {1e6 * seconds / max(len(found), 1):.2f} | none | | | |"
    )


def beside_ssik(name: str, folder: Path) -> str:
    """One row: all answers of single calls, pose by pose, as ssik's interface has it, and of our batch."""
    robot = mp.load_robot(name)
    count = 100
    answer = run_peer("ssik", {"arm": SSIK[name], "count": count}, folder, "solutions")
    poses = robot.kinematics(mp.Task.pose()).pose(robot.random_configuration(np.random.default_rng(0), size=count))
    single, found = best(lambda: [mp.inverse_kinematics(robot, pose) for pose in poses])
    batch, together = best(lambda: mp.inverse_kinematics(robot, poses))
    mine, every = sum(map(len, found)), len(answer["residual"])
    good = int((answer["residual"] <= REACHED).sum())
    theirs = 1e6 * float(answer["seconds"]) / max(good, 1)
    return (
        f"| {name} | {mine / count:.0f} | {1e3 * single / count:.2f} | {1e6 * single / mine:.2f} "
        f"| {1e6 * batch / len(together):.2f} "
        f"| {every / count:.0f}, {100 * good / max(every, 1):.1f} % to 1e-10 | {1e3 * float(answer['seconds']) / count:.2f} "
        f"| {theirs:.2f} | {theirs / (1e6 * single / mine):.1f} x, {theirs / (1e6 * batch / len(together)):.1f} x |"
    )


def covered(folder: Path) -> list[str]:
    """Which arms of the catalogue each has a closed form or an exact method for."""
    names = run_peer("ssik", {"arm": "", "count": 0}, folder, "solutions")["names"]
    closed, known = [], []
    arms = [(name, robot) for name in mp.available_robots() if len((robot := mp.load_robot(name)).tools) == 1]
    for name, robot in arms:
        if closed_form(robot) is not None:
            closed.append(name)
        if "prismatic" in robot.joint_types:
            continue  # EAIK takes revolute joints alone
        screws = Screws.of(robot)
        locked = np.zeros((0, robot.n), dtype=bool)
        for chosen in combinations(range(robot.n), max(robot.n - 6, 0)):
            locked = np.vstack([locked, np.isin(np.arange(robot.n), chosen)])
        problem = {"axes": screws.axes, "points": screws.points, "home": screws.home, "locked": locked}
        if run_peer("eaik", problem, folder, "solutions")["known"]:
            known.append(name)
    total = len(arms)
    shipped = [name for name, prebuilt in SSIK.items() if prebuilt in names]
    return [
        f"Of the {total} arms of the catalogue manipplan has a closed form for {len(closed)} and random starts for the others; "
        f"EAIK has one for {len(known)}, with joints locked where there are more than six ({', '.join(known)}). "
        f"ssik ships {len(names)} arms, {len(shipped)} of them in the catalogue ({', '.join(shipped)}).",
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--environments", type=Path, default=ROOT / ".peers", help="folder of the peers' environments")
    parser.add_argument("--count", type=int, default=100_000, help="random configurations for the recall")
    options = parser.parse_args()
    lines = [
        "| arm | solver | random q | found again to 1e-6 | to 1e-4 | answers a pose | worst residual, by Pinocchio |",
        "|---|---|---|---|---|---|---|",
    ]
    with Progress() as progress:
        for name in ARMS:
            bar = progress.add_task(f"recall {name}", total=options.count)
            robot = mp.load_robot(name)
            hits, close, rows, worst = recall(robot, options.count, lambda k, bar=bar: progress.advance(bar, k))
            lines.append(
                f"| {name} | {closed_form(robot).name} | {options.count} | {hits:.5f} | {close:.5f} | {rows:.2f} "
                f"| {worst:.0e} |"
            )
        lines += [
            "",
            "What is found to 1e-4 and not to 1e-6 is next to a singularity; the description of xarm7 rounds its angles, and "
            "what it misses is where the closed form, which is that of the arm without rounding, has no answer.",
            "",
            "One thread. Ours is `inverse_kinematics` as users call it: poses checked, answers inside the limits, verified by "
            "forward kinematics to 1e-10, doubles removed. EAIK's time is its bare call, with a robot made for each value of "
            "the joint; its answers are counted when they reach the pose to 1e-10 and, with limits, fit into them.",
            "",
            "| arm, held | asked | answers each | time each [µs] | ours, µs an answer | EAIK: answers each | time each [µs] "
            "| µs an answer | EAIK over ours |",
            "|---|---|---|---|---|---|---|---|---|",
        ]
        bar = progress.add_task("beside EAIK and ssik", total=len(ARMS) + len(SSIK) + 2)
        for name in ARMS:
            lines += compared(name, options.environments)
            progress.advance(bar)
        lines.append(swivelled("simple_humanoid_right_arm"))
        lines += [
            "",
            "| arm | answers a pose | ms a pose, one by one | µs an answer, one by one | in a batch | ssik: answers a pose "
            "| ms a pose | µs an answer | ssik over ours: one by one, batch |",
            "|---|---|---|---|---|---|---|---|---|",
        ]
        for name in SSIK:
            lines.append(beside_ssik(name, options.environments))
            progress.advance(bar)
        lines += ["", *covered(options.environments)]
    told = f"Python {platform.python_version()}, {platform.machine()}; command: `make benchmark-peers`."
    text = "\n".join([*lines, "", told, ""])
    OUT.write_text(text)
    print(text)


if __name__ == "__main__":
    main()
