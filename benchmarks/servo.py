"""`mp.Servo` on twist streams through, along and out of singularities, beside our controller and rules of the literature.

Run with `.venv/bin/python benchmarks/servo.py`; environments of the peers are made on the first run. Writes
docs/benchmarks/servo.md; docs/pictures/servo_film.py draws some of the streams. With --random 300 it runs that number of
random streams instead, in as many processes as there are cores, and writes docs/benchmarks/servo_random.md. With --own or
--peers the rows of the other laws stay as they are. Streams are those of servo_streams.py, the judge is servo_judge.py: 17
designed streams of 20 s for all laws, 20 mm from rest along 12 directions out of five singular postures, and random streams
that begin at or near random singular postures of six arms, for `mp.Servo` alone. Arms have no jerk limits here.

- share near: tool speed along the command over the largest that joint speeds and braking allow with at most 0.3 of it across,
  within 1 s of a smallest singular value below 0.05 m (0.3 m per radian)
- followed: share of the command over everything, at the edge of the reach as well
- stalled: time in windows of 0.25 s with less than 5 % followed, although a pose 5 mm ahead is reachable
- backward: share of samples that move backward by more than 2 % of the command
- avoidable: stalls and samples backward that are not for want of time. The judge seeks the best of all velocities that joints
  could have reached in 0.1 s, or since the command came, with at most 0.3 of motion across in each direction: it follows 5 % in
  the mean of a stall's window, or does not move backward. A command has come when all since are within 17° of it
- chatter: changes of sign of joint accelerations above 2 % of their limits, per second and joint
- over limits: of the raw command; -0.6 is 40 % of a limit
- exceptions, step: number of calls that raised, after which the command is zero, and median time of a call from Python
- leaving: of 45 cases that a posture exists for, and time over a lower bound joint by joint
"""

import os

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import argparse
import json
import platform
import sys
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from multiprocessing import get_context
from pathlib import Path

import example_robot_data as erd
import numpy as np
from rich.progress import track
from servo_judge import DT, LENGTH, Arm, Array, Law, Run, arms, arrival, judge, leaving_bound, simulate
from servo_laws import LAWS, Ours, robot_of
from servo_streams import POSTURES, Stream, designed, is_walk, steady, touching

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "benchmarks" / "peers"))
from run import run_peer  # noqa: E402

OUT = ROOT / "docs" / "benchmarks" / "servo.md"
RANDOM = OUT.with_name("servo_random.md")
PEERS = ("pink", "placo", "roboplan", "embodik", "rtb")
NAMES = ("panda", "ur5", "xarm7", "kinova", "so100", "baxter_left")
#: Way of the leaving test [m], and the time for it [s].
DISTANCE, LEAVING = 0.02, 4.0
#: The row of `mp.Servo`.
OWN = "`mp.Servo`"
Figures = dict[str, float]


def described() -> dict[str, Arm]:
    """The arms as their own URDF files describe them; of the package the accelerations and the rows of the task."""
    found = {}
    for name in NAMES:
        robot, file = robot_of(name), erd.load("baxter" if name == "baxter_left" else name).urdf
        rows = [0, 1, 2] if robot.default_task.name == "position" else list(range(6))
        found[name] = {
            "name": name,
            "urdf": str(file),
            "tool": robot.tool,
            "joints": list(robot.joint_names),
            "rows": rows,
            "acceleration": robot.limits.acceleration.tolist(),
        }
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "arms.json"
        path.write_text(json.dumps(found))
        return arms(path)


@dataclass(frozen=True, kw_only=True)
class Case:
    """DISTANCE along a twist (6,) from rest at a singular posture; `bound` is a lower bound of its time [s]."""

    arm: str
    start: Array
    twist: Array
    bound: float


def leaving_cases(models: dict[str, Arm]) -> list[Case]:
    """The cases that a posture exists for."""
    found = []
    for name, posture in POSTURES.values():
        for i in range(12):
            twist = np.zeros(6)
            twist[i // 2] = (0.1 if i < 6 else 0.1 / LENGTH) * (1 - 2 * (i % 2))
            bound = leaving_bound(models[name], np.array(posture), twist, DISTANCE, i)
            if bound is not None:
                found.append(Case(arm=name, start=np.array(posture), twist=twist, bound=bound))
    return found


def leave(law: Law, arm: Arm, case: Case) -> Run:
    return simulate(law, arm, case.start, steady(case.twist), LEAVING, arrival(arm, case.start, case.twist, DISTANCE))


def over_bound(arm: Arm, run: Run, case: Case) -> float | None:
    """Time over the bound of a case; None where the arm does not get there."""
    there = arrival(arm, case.start, case.twist, DISTANCE)(run.q[-1])
    return len(run.raw) * DT / case.bound if there else None


def own_runs(make: Callable[[Arm], Law], models: dict[str, Arm], streams: dict[str, Stream], cases: list[Case]) -> list[Run]:
    """What a law does on all streams, then in all cases."""
    laws = {name: make(models[name]) for name in {each.arm for each in [*streams.values(), *cases]}}
    found = [simulate(laws[each.arm], models[each.arm], each.start, each.twist, each.seconds) for each in streams.values()]
    return found + [leave(laws[each.arm], models[each.arm], each) for each in cases]


def peer_runs(
    peer: str, models: dict[str, Arm], streams: dict[str, Stream], cases: list[Case], folder: Path
) -> dict[str, list[Run]]:
    """The same of each law of a peer, in the peer's own environment."""
    whole = [
        (each.arm, each.start, [each.twist(k * DT) for k in range(round(each.seconds / DT))], 0.0) for each in streams.values()
    ]
    short = [(each.arm, each.start, [each.twist] * round(LEAVING / DT), DISTANCE) for each in cases]
    runs = [{"arm": arm, "start": list(start), "distance": distance} for arm, start, _, distance in whole + short]
    twists = [np.array(each) for _, _, each, _ in whole + short]
    problem = {f"twists {k}": each for k, each in enumerate(twists)} | {
        "arms": json.dumps({name: each.description for name, each in models.items()}),
        "runs": json.dumps(runs),
    }
    answer = run_peer(peer, problem, folder, "twists")

    def run(i: int, k: int) -> Run:
        raw = answer[f"{i} {k} raw"]
        parts = {key: answer[f"{i} {k} {key}"] for key in ("q", "qd", "seconds")}
        return Run(raw=raw, twist=twists[k][: len(raw)], errors=int(answer[f"{i} {k} errors"]), halts=0, **parts)

    return {str(name): [run(i, k) for k in range(len(runs))] for i, name in enumerate(answer["laws"])}


def row(name: str, figures: Sequence[Figures], walks: Sequence[bool], leaving: Sequence[float | None]) -> str:
    values = {key: np.array([each[key] for each in figures]) for key in figures[0]}
    walk, chatter = np.array(walks), values["chatter"]
    times = [each for each in leaving if each is not None]
    cells = [
        name,
        f"{np.nanmedian(values['near']):.2f}, {np.nanmin(values['near']):.2f}",
        f"{values['followed'].mean():.3f}",
        f"{values['stalled'].sum():.2f} s",
        f"{100 * values['backward'].mean():.2f} %",
        f"{values['angle'].mean():.0f}°, {values['slip'].mean():.2f}",
        f"{np.median(chatter[~walk]):.1f}, {chatter[~walk].max():.1f}; {chatter[walk].mean():.1f}",
        f"{values['over_velocity'].max():.1e}, {values['over_acceleration'].max():.1e}, {values['over_position'].max():.1e}",
        f"{values['errors'].sum():.0f}",
        f"{1e6 * np.median(values['step']):.0f} µs",
        f"{len(times)} of {len(leaving)}; {np.median(times):.2f}, {max(times):.2f}" if times else f"0 of {len(leaving)}",
    ]
    return "| " + " | ".join(cells) + " |"


#: Head of the tables; random streams have no last column.
HEAD = (
    "| law | share near: median, worst | followed | stalled | backward | angle, slip "
    "| chatter: designed median, worst; walks | over limits: velocity, acceleration (shares), position (rad) "
    "| exceptions | step | leaving: cases; time over its bound: median, worst |"
)


def rows_of_table() -> dict[str, str]:
    """The rows of the table as it stands, by the names of the laws."""
    rows = [line for line in OUT.read_text().splitlines() if line.count("|") == HEAD.count("|")]
    return {line[2:].partition(" | ")[0]: line for line in rows[2:]}


def designed_streams(
    models: dict[str, Arm], own: Sequence[str], peers: Sequence[str], environments: Path, rows: dict[str, str]
) -> list[str]:
    """The table with new rows of some of our laws and peers, in place of those in `rows`."""
    streams, cases = designed(models), leaving_cases(models)
    walks, count = ["walk" in name for name in streams], len(streams)
    arms = [models[each.arm] for each in [*streams.values(), *cases]]

    def add(name: str, runs: list[Run]) -> None:
        found = []
        for key, arm, run in zip(streams, arms, runs, strict=False):
            found.append(judge(arm, run))
            print(name, key, {k: round(v, 3) for k, v in found[-1].items()}, flush=True)
        leaving = [over_bound(*each) for each in zip(arms[count:], runs[count:], cases, strict=True)]
        rows[name] = row(name, found, walks, leaving)
        print(rows[name], flush=True)

    for name in own:
        add(name, own_runs(LAWS[name], models, streams, cases))
    for peer in peers:
        for name, runs in peer_runs(peer, models, streams, cases, environments).items():
            add(name, runs)
    return ["### Designed streams", "", HEAD, "|" + "---|" * 11, *rows.values()]


@cache
def own_law(name: str) -> tuple[Arm, Ours]:
    """An arm of the random streams, and `mp.Servo` of it."""
    arm = described()[name]
    return arm, Ours(arm)


def random_stream(k: int) -> Figures:
    """What `mp.Servo` does on a random stream."""
    arm, law = own_law(NAMES[k % len(NAMES)])
    stream = touching(arm, k)
    return judge(arm, simulate(law, arm, stream.start, stream.twist, stream.seconds))


def random_streams(count: int) -> list[str]:
    """The table of `mp.Servo` on random streams, one row per arm."""
    lines = [HEAD.rpartition("| leaving")[0] + "|", "|" + "---|" * 10]
    by_arm: dict[str, list[Figures]] = {name: [] for name in NAMES}
    halts, walking = 0, {name: list[bool]() for name in NAMES}
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as pool:
        for k, figures in enumerate(track(pool.map(random_stream, range(count)), description="random streams", total=count)):
            name = NAMES[k % len(NAMES)]
            by_arm[name].append(figures)
            walking[name].append(is_walk(k))
            halts += int(figures["halts"] + figures["errors"])
            if figures["stalled"] or figures["backward"] or figures["halts"]:
                print(k, name, {k: round(v, 3) for k, v in figures.items()}, flush=True)
    for name, each in by_arm.items():
        if each:
            lines.append(row(name, each, walking[name], []).rpartition("| 0 of 0")[0] + "|")
    every = [each for part in by_arm.values() for each in part]

    def having(figure: str) -> int:
        return sum(each[figure] > 0 for each in every)

    return [
        *lines,
        "",
        f"Of {len(every)} streams of 20 s, {having('stalled')} stall, avoidably {having('stalls_avoidable')}, "
        f"and {having('backward')} have a sample that moves backward, avoidably {having('backward_avoidable')}; "
        f"{halts} steps halted or raised.",
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--random", type=int, metavar="COUNT", help="number of random streams to run instead")
    parser.add_argument("--environments", type=Path, default=ROOT / ".peers", help="folder of the peers' environments")
    parser.add_argument("--own", action="store_true", help="run `mp.Servo` alone; the other laws keep their rows")
    parser.add_argument("--peers", nargs="+", choices=PEERS, help="run these alone; the other laws keep their rows")
    given = parser.parse_args()
    if given.random:
        write(RANDOM, random_streams(given.random), f" --random {given.random}")
        return
    models = described()
    own, peers = list(LAWS), list(PEERS)
    if given.own or given.peers:
        own, peers = [OWN] if given.own else [], given.peers or []
    rows = rows_of_table() if given.own or given.peers else {}
    lines = designed_streams(models, own, peers, given.environments, rows)
    write(OUT, lines, "", ", rows of single laws with `--own` and `--peers`" if given.own or given.peers else "")


def write(file: Path, lines: list[str], options: str, single: str = "") -> None:
    """A page of tables, with the command that made it."""
    command = f".venv/bin/python benchmarks/servo.py{options}"
    made = f"Called from Python {platform.python_version()}, {platform.machine()}; command: `{command}`{single}."
    file.write_text("\n".join([*lines, "", made]) + "\n")
    print(file.read_text())


if __name__ == "__main__":
    main()
