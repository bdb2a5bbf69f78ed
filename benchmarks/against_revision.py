"""Processor time of the same problems with an older revision, which `--old` names, and with the present code, in one run.

A worktree of the revision is made in a temporary folder. One worker process per version has everything built; they take turns,
and which one begins alternates, so that a slow moment of the machine meets both. The sets are MotionBenchMaker's problems of
the Panda and of the UR5 by `mp.plan`, tool paths by `mp.follow`, and programs by `mp.sequence`. The present code chooses the
problems. Of several repetitions of a problem the shortest counts. Writes docs/benchmarks/against_revision.md.
"""

from __future__ import annotations  # an older version lacks mp.results

import argparse
import contextlib
import json
import platform
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import motionbenchmaker
import numpy as np
import programs
import tool_paths
from convergence import ROOT, ManipplanError, Row, Worker, speaker, table
from outside import problems
from outside import tool_paths as outside_paths
from rich.progress import track

import manipplan as mp

OUT = ROOT / "docs" / "benchmarks" / "against_revision.md"
#: Wanted: at most this ratio of the medians.
MOST = 1.05
#: Wall time that the planner gets [s]: a loaded machine should not change what is found.
TIME_LIMIT = 60.0


# The problems: each is a row that JSON holds, from which a worker of either version builds it.


def planner_rows(arm: str, count: int) -> list[Row]:
    """The first `count` problems of each set of MotionBenchMaker that are accepted."""
    robot, taken, rows = problems.robot(arm), Counter[str](), []
    for number, each in enumerate(problems.load(arm)):
        if taken[each.set] < count and motionbenchmaker.refusal(robot, each) is None:
            taken[each.set] += 1
            rows.append({"set": f"MotionBenchMaker, {arm}", "name": f"{each.set}, {each.number}", "arm": arm, "number": number})
    return rows


def path_rows(count: int) -> list[Row]:
    """CppFlow's paths of the Panda, and the first `count` of those made by tool_paths.py.

    None of the arm of Fetch's geometry and not IKLink's, for which older revisions take minutes.
    """
    rows = [{"name": each.name, "number": k} for k, each in enumerate(tool_paths.others()) if each.name.startswith("CppFlow")]
    made = [(k, case) for k, case in enumerate(tool_paths.made(2 * count)) if case.name != "made, like Fetch"]
    for number, case in made[:count]:
        poses = case.path(case.path.knots).tolist()
        rows.append({"name": f"{case.name}, {number}", "poses": poses, "obstacles": list(case.scene.entries())})
    return [{"set": "tool paths"} | row for row in rows]


def program_rows(count: int) -> list[Row]:
    """The first `count` programs of each kind whose arm is free at their beginning."""
    rows: list[Row] = []
    for kind, of_part in programs.SETS.items():
        for number in range(count):
            name = list(programs.ARMS)[number % len(programs.ARMS)]
            place = programs.PLACES[number // len(programs.ARMS) % len(programs.PLACES)]
            robot, seed = program_arm(name), [int(of_part), number, 0]
            while _program(name, place, seed, of_part)[1].in_collision(robot, robot.neutral):
                seed[2] += 1
            given = {"arm": name, "place": place, "seed": seed, "of_part": of_part}
            rows.append({"set": "programs", "name": f"{name}, {place}, by the {kind}'s pose, {number}"} | given)
    return rows


def _program(name: str, place: str, seed: list[int], of_part: bool) -> tuple[list[mp.results.ProgramStep], mp.Scene]:
    return programs.problem(program_arm(name), name, place, np.random.default_rng(seed), of_part)


# The worker: it uses only names that both versions have.


@cache
def program_arm(name: str) -> mp.Robot:
    """The arm of a program."""
    return mp.load_robot(name, locked=programs.OPEN if name == "panda" else {})


@cache
def planner_arm(arm: str) -> mp.Robot:
    """The arm of a problem of MotionBenchMaker."""
    return problems.robot(arm)


@cache
def planner_problems(arm: str) -> list[problems.Problem]:
    """The problems of MotionBenchMaker."""
    return problems.load(arm)


@cache
def path_arm(name: str) -> tuple[mp.Robot, mp.Task]:
    """The arm and the task of a path; "" is the arm of the paths that others made."""
    if not name:
        return outside_paths.robot(), mp.Task.pose()
    robot = mp.load_robot(name)
    if name == "ur5":
        return robot.with_limits(lower=-np.pi, upper=np.pi), mp.Task.pointing([0, 0, 1])
    return robot, mp.Task.pose()


def call(given: Row) -> Callable[[], Any]:
    """The call of a problem, with a scene of its own: what a call builds for a scene is part of its time."""
    seeding = mp.Seeding(time_limit=TIME_LIMIT)
    if given["set"] == "tool paths":
        if "poses" in given:
            robot, task = path_arm(given["name"].split(", ")[1])
            path, scene = mp.CartesianPath.through(np.array(given["poses"])), mp.Scene.from_entries(given["obstacles"])
        else:
            (robot, task), case = path_arm(""), outside_paths.load()[given["number"]]
            path, scene = case.path, case.scene
        options = {"epsilon": tool_paths.STEP, "interruptions": 9, "retreat": 0.0, "throw": False}
        objective = mp.PathObjective(task=task)
        return lambda: mp.follow(robot, path, scene, positions=path.knots, objective=objective, **options)
    if given["set"] == "programs":
        robot = program_arm(given["arm"])
        steps, scene = _program(given["arm"], given["place"], given["seed"], given["of_part"])
        return lambda: mp.sequence(robot, robot.neutral, steps, scene, blend=programs.BLEND, seeding=seeding)
    robot, each = planner_arm(given["arm"]), planner_problems(given["arm"])[given["number"]]
    scene = mp.Scene(each.scene.obstacles)
    return lambda: mp.plan(robot, each.start, each.goal, scene, seeding=seeding, throw=False)


def answer(given: Row) -> Row:
    """Status and processor time [s] of the call of a problem."""
    run = call(given)
    began = time.process_time()
    try:
        made = run()
        status = made.status.name if isinstance(made, mp.Plan) else "SOLVED"
    except ManipplanError as error:
        status = type(error).__name__
    return {"status": status, "cpu": time.process_time() - began}


def work() -> None:
    """Answer problems, one JSON object per line, from standard input to standard output until the input ends."""
    say = speaker()
    for line in sys.stdin:
        say(answer(json.loads(line)))


# The parent


@contextlib.contextmanager
def worktree(revision: str) -> Iterator[Path]:
    """A checkout of a revision, in a temporary folder that is removed at the end."""
    with tempfile.TemporaryDirectory() as folder:
        checkout = Path(folder).resolve() / "old"
        git = ["git", "-C", str(ROOT), "worktree"]
        subprocess.run([*git, "add", "--quiet", "--detach", str(checkout), revision], check=True)
        try:
            yield checkout
        finally:
            subprocess.run([*git, "remove", "--force", str(checkout)], check=True)


def measured(rows: Sequence[Row], old: Path, repeats: int) -> list[Row]:
    """The rows with the answers of both versions: the status, and the shortest processor time [s]."""
    found, warm = [], set[str]()
    with Worker(ROOT, script=__file__) as new_worker, Worker(old, script=__file__) as old_worker:
        workers = {"new": new_worker, "old": old_worker}
        for number, row in enumerate(track(rows, description="both versions")):
            group = f"{row['set']}, {row['name'].split(',')[0]}, {row.get('arm')}"
            if group not in warm:  # what a first call builds and compiles does not count
                warm.add(group)
                for worker in workers.values():
                    worker(row)
            answers: dict[str, list[Row]] = {"new": [], "old": []}
            for turn in range(repeats):
                order = list(workers) if (number + turn) % 2 else list(reversed(workers))
                for version in order:
                    answers[version].append(workers[version](row))
            best = {version: min(several, key=lambda each: each["cpu"]) for version, several in answers.items()}
            found.append({"set": row["set"], "name": row["name"]} | best)
    return found


def cells(rows: Sequence[Row]) -> list[str]:
    """The figures of a set."""
    equal = [row for row in rows if row["new"]["status"] == row["old"]["status"]]
    if not equal:
        return [f"{len(rows)}", "0", *[""] * 5]
    new, old = (np.array([row[version]["cpu"] for row in equal]) for version in ("new", "old"))
    ratios = new / old
    return [
        f"{len(rows)}",
        f"{len(equal)}",
        f"{1e3 * np.median(old):.0f} ms",
        f"{1e3 * np.median(new):.0f} ms",
        f"{np.median(new) / np.median(old):.3f}",
        f"{np.median(ratios):.3f}",
        f"{ratios.max():.2f} ({equal[int(ratios.argmax())]['name']})",
    ]


def main(arguments: Sequence[str] | None = None) -> list[Row]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--old", required=True, help="the older revision, as git names it")
    parser.add_argument("--problems", type=int, default=50, help="number of problems of each set of MotionBenchMaker")
    parser.add_argument("--paths", type=int, default=12, help="number of tool paths made here")
    parser.add_argument("--programs", type=int, default=30, help="number of programs of each kind")
    parser.add_argument("--repeats", type=int, default=3, help="number of repetitions of each problem")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    rows = [*planner_rows("panda", given.problems), *planner_rows("ur5", given.problems)]
    rows += [*path_rows(given.paths), *program_rows(given.programs)]
    with worktree(given.old) as old:
        found = measured(rows, old, given.repeats)
    sets = {name: [row for row in found if row["set"] == name] for name in dict.fromkeys(row["set"] for row in found)}
    head = [
        "set",
        "problems",
        "same status",
        "older revision: median",
        "this one: median",
        f"ratio of the medians, wanted at most {MOST:g}",
        "median of the ratios",
        "worst ratio",
    ]
    different = Counter(
        f"{row['set']}: {row['old']['status']} before, {row['new']['status']} now"
        for row in found
        if row["new"]["status"] != row["old"]["status"]
    )
    text = [
        *table(head, [[name, *cells(some)] for name, some in sets.items()]),
        "",
        *([f"Other statuses: {'; '.join(f'{count} {each}' for each, count in different.items())}.", ""] if different else []),
        f"Processor time of whole calls whose status is the same, the shortest of {given.repeats}; revision {given.old}; "
        f"Python {platform.python_version()}, {platform.machine()}, one thread; command: `.venv/bin/python "
        f"benchmarks/against_revision.py --old {given.old} --problems {given.problems} --paths {given.paths} "
        f"--programs {given.programs} --repeats {given.repeats}`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(text) + "\n")
    print("\n".join(text))
    return found


if __name__ == "__main__":
    if sys.argv[1:] == ["--worker"]:
        work()
    else:
        main()
