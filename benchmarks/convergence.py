"""Whether OPTIMAL means a local optimum: four measurements of the path optimiser.

- cpu: the same problems with the kernels of several processors, with and without machine code.
- old: g and processor time beside version 0.1, whose checkout `--old` names: `git worktree add PATH 6f9afba`.
- again: results are optimised twice more, from themselves; none that was OPTIMAL may get lower.
- degree: degree 12 beside degree 6; more freedom may not give a higher g.

`make benchmark-convergence` makes that checkout and runs all four; `--part` runs one, `--count` shortens each suite. Writes
docs/benchmarks/convergence.md, where the tables of other parts stay. Problems are solved in worker processes, one thread each.
Every answer is kept in --results, so a run that was stopped continues. `--again` solves everything anew, and so does a change
of the package's sources.
"""

import argparse
import contextlib
import hashlib
import json
import os
import platform
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import cycle, islice, zip_longest
from pathlib import Path
from typing import Any

import numpy as np
from rich.progress import Progress

import manipplan as mp

ROOT = Path(__file__).resolve().parents[1]
ManipplanError = getattr(mp, "errors", mp).ManipplanError  # an older version has it at the top
OUT = ROOT / "docs" / "benchmarks" / "convergence.md"
#: The environment variables that hold every worker to one thread. OpenBLAS prints the kernels it uses.
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OPENBLAS_VERBOSE": "2"}
CORES = ("Haswell", "Zen", "SkylakeX", "Nehalem")
COMPILED = {True: "machine code", False: "virtual machine"}
#: Values of g that differ by no more than this share are the same; a g that is lower or higher by more than CHANGED differs.
SAME, CHANGED = 1e-6, 1e-3
#: A ratio of at most 1.000 to three decimals.
NO_WORSE = 1.0005
#: A clearance this near to the one asked for is active [m].
ACTIVE = 1e-4
TIME_LIMIT, CLEARANCE = 30.0, 0.01
FIGURES = ("projected_gradient", "complementarity", "active_clearance")
#: Headings in the page, by part.
PARTS = {
    "cpu": "The same on every processor",
    "old": "Beside version 0.1",
    "again": "Optimised again",
    "degree": "Degree 12 beside degree 6",
}

Row = dict[str, Any]
Solve = Callable[[Row], Row]


# The problems: every task is a mapping that JSON holds, so that a worker of any version can build it.


def task(suite: str, name: str, arm: Row, start: Any, goal: Any, scene: mp.Scene | None = None, **options: Any) -> Row:
    """One problem. `arm` has the link `lengths` of a planar arm, or a `name` and `locked` joints."""
    return {
        "suite": suite,
        "name": name,
        "arm": arm,
        "start": [float(each) for each in start],
        "goal": [float(each) for each in goal],
        "obstacles": None if scene is None else list(scene.entries()),
        "options": options,
    }


def planar_tasks() -> list[Row]:
    from planar_suite import DEGREES, PROBLEMS

    return [
        task("planar", f"{name}, p = {power}, degree {degree}", {"lengths": [1.0, 1.0, 1.0]}, *ends, power=power, degree=degree)
        for degree in reversed(DEGREES)  # with --count those that need no optimiser are left out
        for power in (1, 2)
        for name, ends in PROBLEMS.items()
    ]


def random_tasks(count: int) -> list[Row]:
    """The first random pairs of panda_pairs.py."""
    robot, rng = mp.load_robot("panda"), np.random.default_rng(2012)
    pairs = [robot.random_configuration(rng, size=2) for _ in range(count)]
    return [task("random", f"{number}", {"name": "panda"}, *ends) for number, ends in enumerate(pairs)]


def boxes_tasks(count: int) -> list[Row]:
    from panda_boxes import pairs

    problem = mp.demo.panda_among_boxes()
    return [
        task("boxes", f"{number}", {"name": "panda"}, *ends, problem.scene, clearance=0.0)
        for number, ends in enumerate(islice(pairs(problem), count))
    ]


def pairs_tasks(per_scene: int) -> list[Row]:
    """Pairs over the table and in the shelf of benchmarks/pairs, in turn from each scene and arm."""
    from path_suite import PAIRS, load

    groups: dict[tuple[str, str], list[Row]] = {}
    for pair in load():
        group = pair["scene"], pair["arm"]
        if pair["scene"] == "free":
            continue
        groups.setdefault(group, [])
        scene = mp.Scene.from_yaml(PAIRS / f"{pair['scene']}_{pair['arm']}.yaml")
        name = f"{pair['arm']}, {pair['scene']}, {len(groups[group])}"
        arm = {"name": pair["arm"]}
        groups[group].append(task("pairs", name, arm, pair["start"], pair["goal"], scene, clearance=CLEARANCE))
    found: list[Row] = []
    for scene_name in ("table", "shelf"):
        found += in_turn([tasks for (scene, _), tasks in groups.items() if scene == scene_name])[:per_scene]
    return in_turn([found[:per_scene], found[per_scene:]])


def outside_tasks(per_set: int) -> list[Row]:
    """The first problems of each set of MotionBenchMaker that `mp.plan` accepts, in turn from each set."""
    from motionbenchmaker import refusal
    from outside import problems

    robot = problems.robot("panda")
    arm = {"name": "panda", "locked": problems.LOCKED["panda"]}
    sets: dict[str, list[Row]] = {}
    for each in problems.load("panda"):
        tasks = sets.setdefault(each.set, [])
        if len(tasks) < per_set and refusal(robot, each) is None:
            tasks.append(task("outside", f"{each.set}, {each.number}", arm, each.start, each.goal, each.scene, clearance=0.0))
    return in_turn(list(sets.values()))


def in_turn(lists: list[list[Row]]) -> list[Row]:
    """The first of each list, then the second of each, and so on."""
    return [each for several in zip_longest(*lists) for each in several if each is not None]


# The worker: it uses only names that version 0.1 has, too.


def work() -> None:
    """Answer tasks, one JSON object per line, from standard input to standard output until the input ends."""
    say = speaker()
    robots: dict[str, mp.Robot] = {}
    scenes: dict[str, mp.Scene] = {}
    for line in sys.stdin:
        given = json.loads(line)
        arm, obstacles = given["arm"], given["obstacles"]
        if (key := json.dumps(arm)) not in robots:
            robots[key] = build_robot(arm)
        robot, scene = robots[key], None
        if obstacles is not None:
            if (key := json.dumps(obstacles)) not in scenes:
                scenes[key] = mp.Scene.from_entries(obstacles)
            scene = scenes[key]
        try:
            row = JOBS[given["job"]](robot, scene, given)
        except ManipplanError as error:
            row = {"status": type(error).__name__, "g": np.inf, "first g": np.inf, "error": str(error)}
        say(row)


def no_package(folder: Path) -> str:
    """The message for a folder that is no checkout."""
    return f"--old is {folder}, which has no package manipplan; name a checkout of version 0.1"


def speaker() -> Callable[[Row], None]:
    """A function that writes a row to the parent process; the first one tells which package was imported."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # whatever a library prints is no answer

    def say(row: Row) -> None:
        answers.write(json.dumps(row) + "\n")
        answers.flush()

    say({"package": str(Path(mp.__file__).resolve().parent)})
    return say


def build_robot(arm: Row) -> mp.Robot:
    if "lengths" in arm:
        return mp.planar_arm(arm["lengths"])
    return mp.load_robot(arm["name"], locked=arm["locked"]) if "locked" in arm else mp.load_robot(arm["name"])


#: The group that each option belongs to since version 0.1; the others are arguments of their own.
GROUPS = {
    "power": "objective",
    "degree": "shape",
    "basis": "shape",
    "pieces": "shape",
    "time_limit": "seeding",
    "initial": "seeding",
}


def arguments(options: Row) -> Row:
    """The arguments of `mp.optimize_path` and `mp.plan` for the options of a task: in groups, for version 0.1 as they are."""
    if not hasattr(mp, "PathObjective"):
        return options
    kinds = {"objective": mp.PathObjective, "shape": mp.PathShape, "seeding": mp.Seeding}
    groups = {
        group: kind(**{name: value for name, value in options.items() if GROUPS.get(name) == group})
        for group, kind in kinds.items()
    }
    return groups | {name: value for name, value in options.items() if name not in GROUPS}


def figures(result: Any) -> Row:
    """What a row says of a path: g, status, clearance, g of the first path, and what the certificate measures."""
    if result is None or result.path is None:
        return {"g": np.inf, "status": "NO_PATH", "clearance": np.nan, "first g": np.inf}
    certificate = result.certificate
    row = {"g": result.g, "status": result.status.name, "first g": result.seed_cost.g}
    for name in ("clearance", "unconstrained_g", *FIGURES):
        value = getattr(certificate, name, None)
        row[name] = np.nan if value is None else float(value)
    return row


def optimised(robot: mp.Robot, scene: mp.Scene | None, given: Row) -> Row:
    return figures(
        mp.optimize_path(robot, given["start"], given["goal"], scene=scene, throw=False, **arguments(given["options"]))
    )


def planned(robot: mp.Robot, scene: mp.Scene | None, given: Row) -> Row:
    began = time.process_time()
    plan = mp.plan(robot, given["start"], given["goal"], scene, throw=False, **arguments(given["options"]))
    seconds = time.process_time() - began
    row = figures(plan.result) | {"status": plan.status.name, "cpu": seconds}
    return row if plan.status.has_path else row | {"g": np.inf}


def again(robot: mp.Robot, scene: mp.Scene | None, given: Row) -> Row:
    """A result, and where it is OPTIMAL, g of two more solves, each from the path of the last, in its basis."""
    start, goal, options = given["start"], given["goal"], given["options"]
    if scene is None:
        result = mp.optimize_path(robot, start, goal, throw=False, **arguments(options))
    else:
        result = mp.plan(robot, start, goal, scene, throw=False, **arguments(options)).result
    row = figures(result) | {"again": []}
    if row["status"] != mp.Status.OPTIMAL.name:
        return row
    kept = {name: options[name] for name in ("clearance", "power") if name in options}
    path = result.path
    pieces, degree = len(path.breaks) - 1, path.degree
    row |= {"pieces": pieces, "degree": degree}
    basis = "legendre" if pieces == 1 else "bspline"
    for _ in range(2):
        shape = {"degree": degree, "basis": basis, "pieces": pieces}
        result = mp.optimize_path(robot, start, goal, scene=scene, throw=False, **arguments(kept | shape | {"initial": path}))
        row["again"].append({"g": result.g, "status": result.status.name})
        path = result.path
    return row


JOBS = {"optimise": optimised, "plan": planned, "again": again}


class Worker:
    """A process of `script --worker` that imports the package from `checkout`; it starts with the first task."""

    def __init__(self, checkout: Path, *, script: str = __file__, **environment: str) -> None:
        self.checkout, self.script, self.environment = checkout.resolve(), script, environment
        self.closing = contextlib.ExitStack()

    def __enter__(self) -> "Worker":
        return self

    def __exit__(self, *_: object) -> None:
        self.closing.close()

    @cached_property
    def process(self) -> "subprocess.Popen[str]":
        self.said = Path(self.closing.enter_context(tempfile.TemporaryDirectory())) / "messages.txt"
        process = self.closing.enter_context(
            subprocess.Popen(  # leaving its context closes the pipes, which ends the worker, and waits
                [sys.executable, self.script, "--worker"],
                env=os.environ | ONE_THREAD | self.environment | {"PYTHONPATH": str(self.checkout)},
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self.closing.enter_context(self.said.open("w")),
                text=True,
            )
        )
        package = self.line(process)["package"]
        if Path(package) != self.checkout / "manipplan":
            raise RuntimeError(f"the worker imported {package}, not the package of {self.checkout}")
        return process

    def line(self, process: "subprocess.Popen[str]") -> Row:
        assert process.stdout is not None
        line = process.stdout.readline()
        if not line:
            code = process.wait()
            raise RuntimeError(f"a worker of {self.checkout} ended with code {code}:\n{self.said.read_text()[-4000:]}")
        return json.loads(line)

    def __call__(self, given: Row) -> Row:
        process = self.process
        assert process.stdin is not None
        process.stdin.write(json.dumps(given) + "\n")
        process.stdin.flush()
        return self.line(process)

    @property
    def kernels(self) -> str:
        """The kernels that OpenBLAS uses, by its own report."""
        return ", ".join(sorted(set(re.findall(r"Core: (\w+)", self.said.read_text())))) or "unknown"


# Runs: answers are kept in files, a line each.


def sources(checkout: Path) -> str:
    """A digest of the package's sources."""
    files = sorted(file for file in (checkout / "manipplan").rglob("*") if file.suffix in (".py", ".c", ".h", ".cpp", ".in"))
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def answered(file: Path, tasks: list[Row], made_by: str, solve: Solve, advance: Callable[[], None]) -> list[Row]:
    """A row per task: the one in `file` where it is of the same task and sources, else what `solve` answers, which is kept."""
    known = {row["key"]: row for row in map(json.loads, file.read_text().splitlines())} if file.exists() else {}
    rows = []
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("a") as lines:
        for given in tasks:
            key = hashlib.sha256((made_by + json.dumps(given)).encode()).hexdigest()
            if key not in known:
                known[key] = {"key": key, "suite": given["suite"], "name": given["name"]} | solve(given)
                lines.write(json.dumps(known[key]) + "\n")
                lines.flush()
            rows.append(known[key])
            advance()
    return rows


def kernels_of(core: str) -> str:
    """The kernels that OpenBLAS uses when asked for those of a processor; "" where this machine cannot run them."""
    program = "import numpy as np; np.linalg.eigh(np.ones((64, 64)) @ np.ones((64, 64)))"
    environment = os.environ | ONE_THREAD | {"OPENBLAS_CORETYPE": core}
    done = subprocess.run([sys.executable, "-c", program], check=False, env=environment, capture_output=True, text=True)
    return ", ".join(sorted(set(re.findall(r"Core: (\w+)", done.stderr)))) if done.returncode == 0 else ""


def different(cores: Sequence[str]) -> tuple[list[str], list[str]]:
    """The processors whose kernels this machine can run, each kind once, and for every other one the reason it is left out."""
    used: dict[str, str] = {}
    left_out = []
    for core in cores:
        kernels = kernels_of(core)
        if not kernels:
            left_out.append(f"This machine cannot run the kernels for {core}.")
        elif kernels in used:
            left_out.append(f"For {core} OpenBLAS uses the kernels that it uses for {used[kernels]}.")
        else:
            used[kernels] = core
    return list(used.values()), left_out


def run_cpu(tasks: list[Row], folder: Path, cores: Sequence[str] = CORES) -> dict[str, list[Row]]:
    """Rows by setting, each in the order of the tasks."""
    found = {}
    with Progress() as progress:
        for core in cores:
            for compiled, how in COMPILED.items():
                setting = f"{core}, {how}"
                bar = progress.add_task(setting, total=len(tasks))
                given = [each | {"job": "optimise", "options": each["options"] | {"compiled": compiled}} for each in tasks]
                with Worker(ROOT, OPENBLAS_CORETYPE=core) as worker:
                    found[setting] = answered(
                        folder / f"cpu_{core}_{how.replace(' ', '_')}.jsonl",
                        [limited(each) for each in given],
                        sources(ROOT),
                        lambda each, worker=worker: worker(each) | {"kernels": worker.kernels},
                        lambda bar=bar: progress.advance(bar),
                    )
    return found


def limited(given: Row) -> Row:
    """The task with the planner's time limit, where there is a scene."""
    return given if given["obstacles"] is None else given | {"options": given["options"] | {"time_limit": TIME_LIMIT}}


def run_old(tasks: list[Row], folder: Path, old: Path) -> list[Row]:
    """Rows with the answers of both versions, which take turns; which one begins alternates."""
    given = [limited(each | {"job": "plan"}) for each in tasks]
    warm = set()
    with Progress() as progress, Worker(ROOT) as new_worker, Worker(old) as old_worker:
        bar = progress.add_task("both versions", total=len(given))
        turns = cycle(([("new", new_worker), ("old", old_worker)], [("old", old_worker), ("new", new_worker)]))

        def solve(each: Row) -> Row:
            # Problems outside have a scene each: there the first of each set stands for the others.
            group = json.dumps([each["arm"], each["name"].split(",")[0] if each["suite"] == "outside" else each["obstacles"]])
            for worker in (new_worker, old_worker) if group not in warm else ():
                worker(each)
            warm.add(group)
            answers = {version: worker(each) for version, worker in next(turns)}
            return answers | {"clearance": each["options"].get("clearance", 0.0)}

        made_by = sources(ROOT) + sources(old)
        return answered(folder / "old.jsonl", given, made_by, solve, lambda: progress.advance(bar))


def run_again(tasks: list[Row], folder: Path) -> list[Row]:
    given = [limited(each | {"job": "again"}) for each in tasks]
    with Progress() as progress, Worker(ROOT) as worker:
        bar = progress.add_task("optimised again", total=len(given))
        return answered(folder / "again.jsonl", given, sources(ROOT), worker, lambda: progress.advance(bar))


def run_degree(tasks: list[Row], folder: Path) -> list[Row]:
    """Rows with the answers of degree 6 and degree 12."""

    def solve(each: Row) -> Row:
        return {f"{degree}": worker(each | {"options": each["options"] | {"degree": degree}}) for degree in (6, 12)}

    given = [each | {"job": "optimise"} for each in tasks]
    with Progress() as progress, Worker(ROOT) as worker:
        bar = progress.add_task("degrees 6 and 12", total=len(given))
        return answered(folder / "degree.jsonl", given, sources(ROOT), solve, lambda: progress.advance(bar))


# Tables.


def ratio(over: float, under: float) -> float:
    """over / under for g: 0 or inf where one of them is infinite, nan where both are."""
    if np.isinf(over):
        return np.nan if np.isinf(under) else np.inf
    return over / under


def spread(values: Sequence[float]) -> float:
    """By which share the largest g is above the lowest; 0 where all are infinite."""
    above = ratio(max(values), min(values))
    return 0.0 if np.isnan(above) else above - 1


def certified(rows: Sequence[Row]) -> list[list[str]]:
    """Of each further figure of the certificate that the version has: median and largest among OPTIMAL results."""
    lines = []
    for name in FIGURES:
        values = [row[name] for row in rows if row["status"] == "OPTIMAL" and np.isfinite(row.get(name, np.nan))]
        if values:
            said = f"{np.median(values):.2g}, {max(values):.2g}"
            lines.append([f"`{name}` of {len(values)} certificates of OPTIMAL results: median, largest", said])
    return lines


def percent(part: int, whole: int) -> str:
    return f"{part} of {whole} ({100 * part / whole:.1f} %)" if whole else "none"


def statuses(rows: Sequence[Row]) -> str:
    return ", ".join(f"{count} {name}" for name, count in Counter(row["status"] for row in rows).most_common()) or "none"


def table(head: Sequence[str], lines: Sequence[Sequence[str]]) -> list[str]:
    return [f"| {' | '.join(each)} |" for each in (head, ["---"] * len(head), *lines)]


def named(title: str, lines: Sequence[str]) -> list[str]:
    """A list of problems with its title; nothing where there are none."""
    return ["", title, "", *(f"- {line}" for line in lines)] if lines else []


def by_suite(rows: Sequence[Row]) -> dict[str, list[int]]:
    """The places of the rows of each suite, and of all where there are several."""
    places: dict[str, list[int]] = {}
    for k, row in enumerate(rows):
        places.setdefault(row["suite"], []).append(k)
    return places | {"all": list(range(len(rows)))} if len(places) > 1 else places


def optima(runs: dict[str, Row]) -> str:
    """The different values of g among the runs of a problem, with their statuses and settings."""
    groups: list[list[str]] = []
    for setting in sorted(runs, key=lambda each: runs[each]["g"]):
        if groups and spread([runs[groups[-1][0]]["g"], runs[setting]["g"]]) <= SAME:
            groups[-1].append(setting)
        else:
            groups.append([setting])
    return "; ".join(
        f"g = {runs[group[0]]['g']:.9g}, {'/'.join(sorted({runs[each]['status'] for each in group}))} ({' and '.join(group)})"
        for group in groups
    )


def table_cpu(found: dict[str, list[Row]]) -> list[str]:
    rows = next(iter(found.values()))
    runs = [{setting: of_setting[k] for setting, of_setting in found.items()} for k in range(len(rows))]
    spreads = np.array([spread([run["g"] for run in each.values()]) for each in runs])
    firsts = np.array([spread([run["first g"] for run in each.values()]) for each in runs])
    several = np.array([len({run["status"] for run in each.values()}) > 1 for each in runs])
    lines = []
    for suite, places in by_suite(rows).items():
        same = int((spreads[places] <= SAME).sum())
        largest = f"{spreads[places].max():.1e}"
        others = [f"{int((firsts[places] > SAME).sum())}", f"{int(several[places].sum())}"]
        lines.append([suite, f"{len(places)}", percent(same, len(places)), "99 %", largest, *others])
    head = [
        "suite",
        "problems",
        f"g is the same to {1e6 * SAME:g}e-6 in all {len(found)} runs",
        "wanted",
        "largest difference",
        "g of the first path differs",
        "status differs",
    ]
    lists = [f"{rows[k]['suite']}, {rows[k]['name']}: {optima(runs[k])}" for k in np.nonzero(spreads > SAME)[0]]
    every = [row for of_setting in found.values() for row in of_setting]
    kernels = {setting.split(",")[0]: each[0]["kernels"] for setting, each in found.items()}
    more = [f"{label}: {value}." for label, value in certified(every)]
    return [
        *table(head, lines),
        "",
        f"Statuses of all runs: {statuses(every)}. Kernels that OpenBLAS reports: "
        f"{', '.join(f'{used} for {asked}' for asked, used in kernels.items())}. First paths among "
        f"obstacles are those of the planner with seed 0, whose time limit is {TIME_LIMIT:g} s.",
        *(["", *more] if more else []),
        *named("Problems with several values of g:", lists),
    ]


def table_old(rows: Sequence[Row]) -> list[str]:
    ratios = np.array([ratio(row["new"]["g"], row["old"]["g"]) for row in rows])
    clocks = np.array([_clock(row) for row in rows])
    active = np.array([abs(row["new"].get("clearance", np.nan) - row["clearance"]) <= ACTIVE for row in rows])
    # by how much the optimiser could lower g of 0.1 if the obstacles were taken away
    least = np.array([ratio(row["old"].get("unconstrained_g", np.nan), row["old"]["g"]) for row in rows])
    suites = by_suite(rows)
    columns = []
    for places in suites.values():
        some, clock = ratios[places], clocks[places]
        some, clock = some[~np.isnan(some)], clock[~np.isnan(clock)]
        held = ratios[places][active[places] & ~np.isnan(ratios[places])]
        possible = least[places][active[places] & ~np.isnan(least[places])]
        columns.append(
            [
                f"{len(places)}",
                statuses([rows[k]["new"] for k in places]),
                statuses([rows[k]["old"] for k in places]),
                f"{int((some == 0).sum())}, {int(np.isinf(some).sum())}",
                percent(int((some <= NO_WORSE).sum()), len(some)),
                f"{np.median(some):.3f}, {some.max():.3f}" if len(some) else "none",
                f"{np.median(held):.3f} of {len(held)}" if len(held) else "none",
                f"{np.median(possible):.3f} of {len(possible)}" if len(possible) else "none",
                f"{np.median(clock):.2f}, {np.quantile(clock, 0.9):.2f}, {clock.max():.2f}" if len(clock) else "none",
            ]
        )
    labels = [
        "problems",
        "statuses of this version",
        "statuses of 0.1",
        "finite g from this version alone; from 0.1 alone",
        "g over that of 0.1 is at most 1.000",
        "g over that of 0.1: median, worst",
        f"the same, of paths within {1e3 * ACTIVE:g} mm of the demanded clearance: median",
        "of these, g of 0.1's nearby optimum without limits and obstacles over that of 0.1: median",
        "processor time of `mp.plan` over that of 0.1: median, 90 %, worst",
    ]
    lines = [[label, *(column[k] for column in columns)] for k, label in enumerate(labels)]
    lines += [[label, *[""] * (len(suites) - 1), value] for label, value in certified([row["new"] for row in rows])]
    worse = [
        f"{row['suite']}, {row['name']}: g = {row['new']['g']:.6g} ({row['new']['status']}), with 0.1 {row['old']['g']:.6g} "
        f"({row['old']['status']}); ratio {each:.4f}"
        for row, each in sorted(zip(rows, ratios, strict=True), key=lambda pair: -pair[1])
        if each > NO_WORSE
    ]
    return [
        *table(["figure", *suites], lines),
        "",
        "Both versions solve each problem; which one begins alternates. Not counted: the first call for each arm and scene, "
        f"and for each set where every problem has its own scene. The planner's time limit is {TIME_LIMIT:g} s. Problems "
        "without a finite g from either version have no ratio.",
        *named("Problems with a higher g than in 0.1:", worse),
    ]


def _clock(row: Row) -> float:
    """Ratio of the processor times; nan where a version refused the problem."""
    return row["new"].get("cpu", np.nan) / row["old"].get("cpu", np.nan)


def lowered(row: Row) -> float:
    """By which share of g the better of the two further solves is lower."""
    return 1 - ratio(min(each["g"] for each in row["again"]), row["g"])


def table_again(rows: Sequence[Row]) -> list[str]:
    suites = by_suite(rows)
    columns = []
    for places in suites.values():
        some = [rows[k] for k in places]
        optimal = [row for row in some if row["status"] == "OPTIMAL"]
        shares = np.array([lowered(row) for row in optimal])
        columns.append(
            [
                f"{len(some)}",
                f"{len(optimal)}",
                statuses([row for row in some if row["status"] != "OPTIMAL"]),
                f"{int((shares > CHANGED).sum())}",
                f"{100 * max(shares.max(), 0.0):.2g} %" if len(shares) else "none",
            ]
        )
    labels = [
        "problems",
        "OPTIMAL at first",
        "others",
        f"OPTIMAL, and lowered by more than {100 * CHANGED:g} %",
        "largest lowering",
    ]
    wanted = ["", "", "", "0", f"at most {100 * CHANGED:g} %"]
    lines = [[label, *(column[k] for column in columns), wanted[k]] for k, label in enumerate(labels)]
    lines += [[label, *[""] * (len(suites) - 1), value, ""] for label, value in certified(rows)]
    names = [
        f"{row['suite']}, {row['name']}: g = {row['g']:.9g}, then "
        + ", ".join(f"{each['g']:.9g} ({each['status']})" for each in row["again"])
        for row in rows
        if row["status"] == "OPTIMAL" and lowered(row) > CHANGED
    ]
    return [
        *table(["figure", *suites, "wanted"], lines),
        "",
        "Without obstacles by `optimize_path`, among obstacles by `mp.plan`; then twice more by `optimize_path` from the last "
        "path (`Seeding.initial`), in its basis, degree and pieces.",
        *named("OPTIMAL results that were lowered:", names),
    ]


def table_degree(rows: Sequence[Row]) -> list[str]:
    ratios = np.array([ratio(row["12"]["g"], row["6"]["g"]) for row in rows])
    finite = ratios[~np.isnan(ratios)]
    lines = [
        ["pairs; with a finite g", f"{len(rows)}; {len(finite)}", ""],
        *([f"statuses of degree {degree}", statuses([row[degree] for row in rows]), ""] for degree in ("6", "12")),
        [f"degree 12 has a g higher by more than {100 * CHANGED:g} %", f"{int((finite > 1 + CHANGED).sum())}", "0"],
        [
            "g of degree 12 over that of degree 6: median, worst",
            f"{np.median(finite):.6f}, {finite.max():.6f}" if len(finite) else "none",
            f"worst at most {1 + CHANGED:g}",
        ],
        *([*line, ""] for line in certified([row[degree] for row in rows for degree in ("6", "12")])),
    ]
    names = [
        f"{row['suite']}, {row['name']}: degree 6 {row['6']['g']:.6g} ({row['6']['status']}), degree 12 {row['12']['g']:.6g} "
        f"({row['12']['status']}); ratio {each:.4f}"
        for row, each in sorted(zip(rows, ratios, strict=True), key=lambda pair: -pair[1])
        if each > 1 + CHANGED
    ]
    return [*table(["figure", "value", "wanted"], lines), *named("Pairs whose g is higher with degree 12:", names)]


# The page.


def sections(page: str) -> dict[str, str]:
    """The text of each part that the page has, without its heading."""
    heads = "|".join(re.escape(head) for head in PARTS.values())
    texts = re.split(rf"^\*\*({heads})\*\*\n", page, flags=re.MULTILINE)
    keys = {head: part for part, head in PARTS.items()}
    return {keys[head]: text.strip() for head, text in zip(texts[1::2], texts[2::2], strict=True)}


def assembled(texts: dict[str, str]) -> str:
    return "\n\n".join(f"**{head}**\n\n{texts[part]}" for part, head in PARTS.items() if part in texts) + "\n"


def told(part: str, options: argparse.Namespace) -> str:
    """How a table was made."""
    short = f" The first {options.count} problems of each suite only." if options.count is not None else ""
    of = (f" --old PATH --outside {options.outside}" if part == "old" else "") + (
        "" if options.count is None else f" --count {options.count}"
    )
    return (
        f"Python {platform.python_version()}, {platform.machine()}, version {mp.__version__}, one thread.{short} Command: "
        f"`.venv/bin/python benchmarks/convergence.py --part {part}{of}`."
    )


def measured(part: str, options: argparse.Namespace) -> list[str]:
    """Run one part; the lines of its table."""

    def of(tasks: list[Row]) -> list[Row]:
        return tasks[: options.count]

    def counted(count: int) -> int:
        return count if options.count is None else min(count, options.count)

    if part == "cpu":
        tasks = of(planar_tasks()) + random_tasks(counted(200)) + boxes_tasks(counted(20)) + of(pairs_tasks(30))
        cores, left_out = different(CORES)
        return [*table_cpu(run_cpu(tasks, options.results, cores)), *(["", " ".join(left_out)] if left_out else [])]
    if part == "old":
        tasks = of(pairs_tasks(50)) + boxes_tasks(counted(20)) + of(outside_tasks(options.outside))
        return table_old(run_old(tasks, options.results, options.old))
    if part == "again":
        tasks = random_tasks(counted(500)) + of(pairs_tasks(15)) + of(outside_tasks(5)[:30])
        return table_again(run_again(tasks, options.results))
    return table_degree(run_degree(random_tasks(counted(200)), options.results))


def parsed(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--part", choices=[*PARTS, "all"], default="all", help="which measurement to run")
    parser.add_argument("--old", type=Path, help="checkout of version 0.1, which parts old and all need")
    parser.add_argument("--count", type=int, help="maximum number of problems of each suite; default: all")
    parser.add_argument("--outside", type=int, default=8, help="number of problems of each set of MotionBenchMaker in part old")
    results = Path(tempfile.gettempdir()) / "manipplan_convergence"
    parser.add_argument("--results", type=Path, default=results, help="folder of the answers")
    parser.add_argument("--again", action="store_true", help="solve everything anew, also what --results holds")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the tables")
    options = parser.parse_args(arguments)
    for name, value in (("--count", options.count), ("--outside", options.outside)):
        if value is not None and value < 1:
            parser.error(f"{name} is {value}; allowed: 1 or more")
    if options.part in ("old", "all") and options.old is None:
        parser.error("--old PATH is needed: a checkout of version 0.1, made by git worktree add PATH 6f9afba")
    if options.old is not None and not (options.old / "manipplan" / "__init__.py").is_file():
        parser.error(no_package(options.old))
    return options


def main(arguments: Sequence[str] | None = None) -> None:
    options = parsed(arguments)
    parts = list(PARTS) if options.part == "all" else [options.part]
    for part in parts:
        for file in options.results.glob(f"{part}*.jsonl") if options.again else ():
            file.unlink()
        text = "\n".join([*measured(part, options), "", told(part, options)])
        texts = sections(options.out.read_text()) if options.out.exists() else {}
        options.out.parent.mkdir(parents=True, exist_ok=True)
        options.out.write_text(assembled(texts | {part: text}))
        print(text)


if __name__ == "__main__":
    if sys.argv[1:] == ["--worker"]:
        work()
    else:
        main()
