"""The suite of pairs in benchmarks/pairs: our paths beside OMPL, drake and tesseract, all judged here by the same measure.

Run with `make benchmark-paths`; the peers' environments are made on the first run. Writes docs/benchmarks/path_suite.md, and
every figure of every pair to --results. Everything is measured in this one run; times are of this machine, ratios travel
better.
"""

import argparse
import csv
import json
import os
import platform
import sys
import tempfile
import time
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from rich.progress import Progress
from scipy.interpolate import BPoly, BSpline, PPoly

import manipplan as mp

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "benchmarks" / "peers"))
from run import run_peer  # noqa: E402  # its folder is put on the path first
from world import write_world  # noqa: E402  # the same

PAIRS = ROOT / "benchmarks" / "pairs"
OUT = ROOT / "docs" / "benchmarks" / "path_suite.md"
CLEARANCE, STEP, SEARCH_TIME = 0.01, 1e-3, 30.0
#: What peers are given beside the world: the rule is as fine as ours, B-splines have more freedom than our polynomials.
GIVEN = {"control_points": 10, "samples": 40, "checks": 30, "clearance": CLEARANCE, "weight": 5.0}
WAYPOINTS = 31
LEAST = "minimum manipulability"
#: The rows of the table: a key, which peer's environment or none, what it is given, and what it is.
PEERS = {
    "drake, g": ("drake", {"cost": "g"}, "drake, B-splines, the cost is g"),
    "drake, sum": ("drake", {"cost": "sum"}, "drake, B-splines, path energy + mean of 1/m"),
    "tesseract": ("tesseract", {}, "tesseract, TrajOpt with AvoidSingularity"),
}
BIT = {"BIT*": "OMPL BIT*, length, our time", "BIT* on g": "OMPL BIT*, g as its objective, our time"}


def load() -> list[dict]:
    """The pairs, with start and goal as arrays."""
    with (PAIRS / "pairs.csv").open() as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [row | {end: np.array(row[end].split(), dtype=float) for end in ("start", "goal")} for row in rows]


def judged(robot: mp.Robot, scene: mp.Scene, path: mp.JointPath | None, pair: dict) -> dict:
    """Of a path: g, minimum manipulability, length, and whether it is free at every milliradian, inside limits, at its ends."""
    if path is None:
        return {"g": np.inf, "found": False, "free": False, "touches": False, "within": False}
    model, kinematics = scene.collision_model(robot), robot.kinematics()
    q = path(path.fine_samples(STEP))
    assert np.abs(np.diff(q, axis=0)).max() <= STEP * (1 + 1e-9)
    free, clear = (not any(model.in_collision(each, clearance=gap) for each in q) for gap in (CLEARANCE, 0.0))
    ends = np.abs(np.array([path.start - pair["start"], path.goal - pair["goal"]])).max()
    low, high = path.bounds()
    beyond = max(robot.limits.outside(low).max(), robot.limits.outside(high).max())
    cost = mp.path_cost(path, kinematics, 1.0)
    return {
        "g": cost.g,
        "length": cost.length,
        LEAST: cost.min_manipulability,
        "found": True,
        "free": free,
        "touches": not clear,
        "within": bool(beyond <= 1e-6 and ends <= 1e-6),
    }


def ours(robot: mp.Robot, scene: mp.Scene, pair: dict) -> tuple[mp.Plan, dict]:
    """`mp.plan`, and wall and processor time [s] of the seed, up to the path, without the timing of the motion, and of all."""
    marks = {}

    def say(_: float, step: str) -> None:
        marks[step] = np.array([time.perf_counter(), time.process_time()])

    plan = mp.plan(
        robot,
        pair["start"],
        pair["goal"],
        scene,
        clearance=CLEARANCE,
        seeding=mp.Seeding(time_limit=SEARCH_TIME),
        throw=False,
        progress=say,
    )
    say(1.0, "end")
    begun = marks["looking for a first path"]
    seed = marks.get("optimising the path", marks["end"]) - begun
    path, whole = marks.get("timing the motion", marks["end"]) - begun, marks["end"] - begun
    times = {
        "seed time": seed[0],
        "seed cpu": seed[1],
        "time": path[0],
        "cpu": path[1],
        "plan time": whole[0],
        "plan cpu": whole[1],
    }
    return plan, times


def bit_star(robot: mp.Robot, scene: mp.Scene, pair: dict, seconds: float, on_g: bool) -> mp.JointPath | None:
    """The best path of BIT* in `seconds`, by length or by g; its straight pieces' g is measured on ten points a 0.1 rad."""
    from ompl import base, geometric, util

    util.setLogLevel(util.LogLevel.LOG_NONE)
    util.RNG.setSeed(1)
    model, kinematics, n = scene.collision_model(robot), robot.kinematics(), robot.n
    space = base.RealVectorStateSpace(n)
    bounds = base.RealVectorBounds(n)
    for joint in range(n):
        bounds.setLow(joint, float(robot.limits.lower[joint]))
        bounds.setHigh(joint, float(robot.limits.upper[joint]))
    space.setBounds(bounds)
    information = base.SpaceInformation(space)
    information.setStateValidityChecker(lambda state: not model.in_collision(np.array(state[0:n]), clearance=CLEARANCE))
    information.setStateValidityCheckingResolution(0.003 / float(space.getMaximumExtent()))
    information.setup()
    nodes, weights = np.polynomial.legendre.leggauss(10)

    class Index(base.OptimizationObjective):
        def stateCost(self, state):  # noqa: N802  # OMPL's name
            return base.Cost(1.0 / max(float(kinematics.manipulability(np.array(state[0:n]))), 1e-12))

        def motionCost(self, first, second):  # noqa: N802  # OMPL's name
            a, b = np.array(first[0:n]), np.array(second[0:n])
            distance = float(np.linalg.norm(b - a))
            panels = max(1, int(np.ceil(distance / 0.1)))
            u = ((np.arange(panels)[:, None] + (nodes + 1) / 2) / panels).ravel()
            index = np.maximum(kinematics.manipulability(a + u[:, None] * (b - a)), 1e-12)
            return base.Cost(distance * float(np.tile(weights / (2 * panels), panels) @ (1 / index)))

    problem = base.ProblemDefinition(information)
    ends = [space.allocState(), space.allocState()]
    for state, end in zip(ends, ("start", "goal"), strict=True):
        state[0:n] = [float(x) for x in pair[end]]
    problem.setStartAndGoalStates(*ends, 1e-9)
    problem.setOptimizationObjective(Index(information) if on_g else base.PathLengthOptimizationObjective(information))
    planner = geometric.BITstar(information)
    planner.setProblemDefinition(problem)
    planner.setup()
    planner.solve(float(seconds))
    if not problem.hasExactSolution():
        return None
    path = problem.getSolutionPath()
    points = np.array([path.getState(k)[0:n] for k in range(path.getStateCount())])
    points[0], points[-1] = pair["start"], pair["goal"]
    return mp.JointPath.through(points[np.r_[True, np.abs(np.diff(points, axis=0)).max(axis=1) > 1e-9]])


def of_spline(knots: np.ndarray, control: np.ndarray) -> mp.JointPath:
    """The JointPath of a clamped B-spline (knots, control points (k, n))."""
    degree = len(knots) - len(control) - 1
    joints = [BPoly.from_power_basis(PPoly.from_spline(BSpline(knots, each, degree))) for each in control.T]
    breaks = joints[0].x
    real = np.diff(breaks) > 0  # clamped: the knots at the ends stand there several times
    places = np.r_[breaks[:-1][real], breaks[-1]]
    pieces = np.stack([each.c.T[real] for each in joints], axis=-1)
    return mp.JointPath(breaks=(places - places[0]) / (places[-1] - places[0]), control=pieces)


def of_waypoints(points: np.ndarray) -> mp.JointPath | None:
    """Straight pieces through the waypoints that differ; None where there are not two of them."""
    points = points[np.r_[True, np.abs(np.diff(points, axis=0)).max(axis=1) > 1e-9]]
    return mp.JointPath.through(points) if len(points) > 1 and np.isfinite(points).all() else None


def by_peer(key: str, robot: mp.Robot, scene: mp.Scene, pairs: list[dict], seeds: list[mp.JointPath], options) -> list[dict]:
    """What a peer makes of the pairs, from the same seeds."""
    name, given, _ = PEERS[key]
    with tempfile.TemporaryDirectory() as folder:
        problem = write_world(robot, scene, Path(folder)) | GIVEN | given
        problem |= {"seeds": np.array([seed(np.linspace(0, 1, WAYPOINTS)) for seed in seeds]), "time_limit": options.time_limit}
        found = run_peer(name, problem, options.environments, "paths")
    rows = []
    for k, pair in enumerate(pairs):
        path = of_spline(found["knots"], found["control"][k]) if "knots" in found else of_waypoints(found["waypoints"][k])
        rows.append(judged(robot, scene, path, pair) | {"time": float(found["time"][k]), "cpu": float(found["cpu"][k])})
        rows[-1]["said"] = str(found["said"][k])
    return rows


def run(options) -> list[dict]:
    """One row a pair: arm, scene, and by method its figures."""
    rows, problems = [], []
    groups: dict[tuple[str, str], list[dict]] = {}
    for pair in load():
        groups.setdefault((pair["scene"], pair["arm"]), []).append(pair)
    robots = {arm: mp.load_robot(arm) for _, arm in groups}
    with Progress() as progress:
        bar = progress.add_task("paths", total=sum(len(pairs[: options.pairs]) for pairs in groups.values()))
        for (name, arm), group_pairs in groups.items():
            robot, pairs = robots[arm], group_pairs[: options.pairs]
            scene = mp.Scene() if name == "free" else mp.Scene.from_yaml(PAIRS / f"{name}_{arm}.yaml")
            ours(robot, scene, pairs[0])  # fits primitives and builds programs
            group, seeds = [], []
            for number, pair in enumerate(pairs):
                plan, times = ours(robot, scene, pair)
                seed = plan.result.seed if plan.result is not None else None
                row = {"scene": name, "arm": arm, "number": number, "status": plan.status.name}
                row["ours"] = judged(robot, scene, plan.path, pair) | times
                row["OMPL"] = judged(robot, scene, seed, pair) | {"time": times["seed time"], "cpu": times["seed cpu"]}
                row["ours"]["proven"] = plan.report is not None and plan.report.proven_clearance >= CLEARANCE - 1e-6
                row["ours"]["optimised"] = plan.result is not None and plan.result.status.ok
                row["ours"]["safe seed"] = seed is not None and plan.path is seed
                for key in BIT if number < options.peer_pairs else ():
                    path = bit_star(robot, scene, pair, times["time"], key == "BIT* on g")
                    row[key] = judged(robot, scene, path, pair) | {"time": times["time"], "cpu": times["cpu"]}
                group.append(row)
                seeds.append(seed)
                progress.advance(bar)
            chosen = [k for k, seed in enumerate(seeds) if seed is not None][: options.peer_pairs]
            for key in options.peers if chosen else ():
                try:
                    found = by_peer(key, robot, scene, [pairs[k] for k in chosen], [seeds[k] for k in chosen], options)
                except RuntimeError as error:
                    problems.append(f"{key}, {name}, {arm}: {error}")
                    continue
                for k, each in zip(chosen, found, strict=True):
                    each |= {kind: each[kind] + group[k]["OMPL"][kind] for kind in ("time", "cpu")}  # they start from it
                    group[k][key] = each
            rows += group
            options.results.parent.mkdir(parents=True, exist_ok=True)
            options.results.write_text(json.dumps(rows, indent=1))
    for problem in problems:
        print(problem)
    return rows


def over_seed(row: dict) -> float:
    """Our g over that of OMPL's simplified path: 0 where only that crosses a singularity, 1 where both do."""
    mine, seed = row["ours"]["g"], row["OMPL"]["g"]
    if np.isfinite(seed):
        return mine / seed
    return 0.0 if np.isfinite(mine) else 1.0


def share(rows: list[dict]) -> list[str]:
    """Lines of the first table, one a scene and one for all."""
    lines = [
        "| scene | pairs | paths optimised and free at 1 mrad with 10 mm | other statuses | all paths free | motions proven "
        "| g over the first path's, median | 90 % below | minimum manipulability over the first path's: median, 5 % "
        "| processor time of the path: median, 95 %, worst [s] | of the whole plan: median, 95 % [s] | of the first path [s] |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    scenes = {name: [row for row in rows if row["scene"] == name] for name in ("free", "table", "shelf")}
    scenes["with obstacles"] = scenes["table"] + scenes["shelf"]
    scenes["all"] = rows
    for name, some in scenes.items():
        if not some:
            continue
        mine = [row["ours"] for row in some]
        good = [each["optimised"] and each["free"] and each["within"] for each in mine]
        others: dict[str, int] = {}
        for row, ok in zip(some, good, strict=True):
            if not ok:
                others[row["status"]] = others.get(row["status"], 0) + 1
        ratio = [over_seed(row) for row in some]
        seconds, whole = (np.array([each[kind] for each in mine]) for kind in ("cpu", "plan cpu"))
        least = [a / b for a, b in ((row["ours"].get(LEAST, 0.0), row["OMPL"].get(LEAST, 0.0)) for row in some) if b > 0]
        raised = f"{np.median(least):.2f}, {np.quantile(least, 0.05):.2f}" if least else ""
        said = ", ".join(f"{count} {status}" for status, count in others.items()) or "none"
        lines.append(
            f"| {name} | {len(some)} | {sum(good)} | {said} | {sum(each['free'] and each['within'] for each in mine)} "
            f"| {sum(each['proven'] for each in mine)} | {np.median(ratio):.3f} | {np.quantile(ratio, 0.9):.3f} | {raised} "
            f"| {np.median(seconds):.2f}, {np.quantile(seconds, 0.95):.2f}, {seconds.max():.1f} "
            f"| {np.median(whole):.2f}, {np.quantile(whole, 0.95):.2f} | {np.median([each['seed cpu'] for each in mine]):.2f} |"
        )
    return lines


def beside(rows: list[dict]) -> list[str]:
    """Lines of the second table, one a peer."""
    lines = [
        "| method | pairs | found | free at 1 mrad with 10 mm | touches something | leaves the limits or misses the goal "
        "| ours has lower g or the other is not free, share | of its free paths, ours lower | its g over ours, median "
        "| its minimum manipulability over ours, median | ours over its processor time, median "
        "| its processor time, median [s] |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for key, title in [("OMPL", "OMPL simplified: RRTConnect and PathSimplifier, our seed"), *BIT.items()] + [
        (key, told) for key, (_, _, told) in PEERS.items()
    ]:
        some = [row for row in rows if key in row]
        if not some:
            continue
        theirs, mine = [row[key] for row in some], [row["ours"] for row in some]
        usable = np.array([each["found"] and not each["touches"] and each["within"] for each in theirs])
        lower = np.array([a["g"] < b["g"] for a, b in zip(mine, theirs, strict=True)])
        ours_usable = np.array([each["free"] and each["within"] for each in mine])
        wins = ours_usable & (lower | ~usable)
        finite = usable & np.isfinite([a["g"] for a in mine]) & np.isfinite([b["g"] for b in theirs])
        ratio = [b["g"] / a["g"] for a, b, ok in zip(mine, theirs, finite, strict=True) if ok]
        least = [b[LEAST] / a[LEAST] for a, b, ok in zip(mine, theirs, finite, strict=True) if ok and a[LEAST] > 0]
        clocks = [a["cpu"] / b["cpu"] for a, b in zip(mine, theirs, strict=True)]
        lines.append(
            f"| {title} | {len(some)} | {sum(each['found'] for each in theirs)} | {sum(each['free'] for each in theirs)} "
            f"| {sum(each['touches'] for each in theirs)} | {sum(each['found'] and not each['within'] for each in theirs)} "
            f"| {100 * wins.mean():.0f} % | {100 * (lower & usable & ours_usable).sum() / max(usable.sum(), 1):.0f} % "
            f"| {np.median(ratio) if ratio else np.nan:.2f} | {np.median(least) if least else np.nan:.2f} "
            f"| {np.median(clocks):.2f} | {np.median([each['cpu'] for each in theirs]):.2f} |"
        )
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--environments", type=Path, default=ROOT / ".peers", help="folder of the peers' environments")
    parser.add_argument("--pairs", type=int, default=None, help="so many pairs of each arm and scene; default: all")
    parser.add_argument("--peer-pairs", type=int, default=6, help="so many pairs of each arm and scene for the peers and BIT*")
    parser.add_argument("--peers", nargs="*", choices=PEERS, default=list(PEERS), help="which peers to run")
    parser.add_argument("--time-limit", type=float, default=30.0, help="of drake for each pair [s]")
    results = Path(tempfile.gettempdir()) / "manipplan_path_suite.json"
    parser.add_argument("--results", type=Path, default=results, help="every figure of every pair")
    parser.add_argument("--out", type=Path, default=OUT, help="the table")
    options = parser.parse_args()
    rows = run(options)
    told = f"Python {platform.python_version()}, {platform.machine()}, one thread each; command: `make benchmark-paths`."
    lines = [*share(rows), "", *beside(rows), "", told]
    options.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
