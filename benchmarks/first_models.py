"""Time of the first collision model of a process: with an empty cache folder, and in later processes that find what it stored.

What is timed begins with a loaded robot and ends with the first answer of a collision query, as at the beginning of `mp.plan`:
the convex pieces of the meshes, the pairs that are checked, and the compiled kernel. Robots are named as `mp.load_robot` takes
them. Some of MuJoCo Menagerie are added if the environment variable MUJOCO_MENAGERIE names a checkout. Run with
`make benchmark`. Writes docs/benchmarks/first_models.md.
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from rich.progress import track

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "first_models.md"
#: Arms of each maker, and those with the most bodies.
ROBOTS = (
    "panda",
    "ur5",
    "ur10",
    "xarm7",
    "kinova",
    "z1",
    "so101",
    "baxter",
    "pr2",
    "icub",
    "talos",
    "tiago_dual",
    "romeo_left_arm",
    "g1_left_arm",
    "centauro",
)
MENAGERIE = (
    "agilex_piper",
    "flexiv_rizon4",
    "kinova_gen3",
    "kuka_iiwa_14",
    "rethink_robotics_sawyer",
    "ufactory_lite6",
    "ufactory_xarm7",
)
#: Wanted: at most these times of the first and of later processes [s].
FIRST, LATER = 10.0, 0.1
PROGRAM = """
import json, resource, time
import manipplan as mp

def now():
    own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return time.perf_counter(), own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime

robot = mp.load_robot({name!r})
scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), position=(9.0, 0.0, 0.0), name="box")])
began = now()
scene.in_collision(robot, robot.neutral)
ended = now()
model = scene.collision_model(robot)
took = [end - begin for begin, end in zip(began, ended)]
print(json.dumps({{"wall": took[0], "cpu": took[1], "bodies": model.geometry.ngeoms - 1, "pairs": len(model.pair_names)}}))
"""


@dataclass(frozen=True, kw_only=True)
class Times:
    """Of one robot.

    Attributes:
        name: of the robot.
        bodies, pairs: number of bodies of its collision model, without obstacles, and of the pairs that are checked.
        first, later: wall and processor time [s] with an empty cache folder; and in processes after that one.
    """

    name: str
    bodies: int
    pairs: int
    first: tuple[float, float]
    later: list[tuple[float, float]]

    @property
    def usual(self) -> tuple[float, float]:
        """The medians of the later processes [s]."""
        walls, cpus = zip(*self.later, strict=True)
        return statistics.median(walls), statistics.median(cpus)


def measure(name: str, runs: int) -> Times:
    """The times of a robot, in one process with an empty cache folder and `runs` after it."""
    with tempfile.TemporaryDirectory() as cache:
        environment = os.environ | {"MANIPPLAN_CACHE": cache, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        program = [sys.executable, "-c", PROGRAM.format(name=name)]
        found = []
        for _ in range(1 + runs):
            done = subprocess.run(program, env=environment, check=False, capture_output=True, text=True)
            if done.returncode:
                raise RuntimeError(f"{name}: {done.stderr[-2000:]}")
            found.append(json.loads(done.stdout))
    first, *later = [(each["wall"], each["cpu"]) for each in found]
    return Times(name=name, bodies=found[0]["bodies"], pairs=found[0]["pairs"], first=first, later=later)


def table(found: Sequence[Times]) -> list[str]:
    """The lines of the page."""
    lines = [
        "| robot | bodies | pairs | first process: wall, processor time | later processes, median: wall, processor time |",
        "|---" * 5 + "|",
    ]
    for each in found:
        first, usual = each.first, each.usual
        lines.append(
            f"| {each.name} | {each.bodies} | {each.pairs} | {first[0]:.2f} s, {first[1]:.2f} s "
            f"| {usual[0]:.3f} s, {usual[1]:.3f} s |"
        )
    slowest, last = max(found, key=lambda each: each.first[1]), max(found, key=lambda each: each.usual[1])
    return [
        *lines,
        "",
        f"The slowest first process is that of {slowest.name} with {slowest.first[1]:.2f} s of processor time; at most "
        f"{FIRST:g} s is wanted, which {sum(each.first[1] <= FIRST for each in found)} of {len(found)} reach. "
        f"The slowest later one is that of {last.name} with {last.usual[1]:.3f} s; at most {LATER:g} s is wanted, which "
        f"{sum(each.usual[1] <= LATER for each in found)} reach.",
    ]


def main(arguments: Sequence[str] | None = None) -> list[Times]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    checkout = os.environ.get("MUJOCO_MENAGERIE")
    more = [f"menagerie:{each}" for each in MENAGERIE if checkout and (Path(checkout) / each).is_dir()]
    parser.add_argument("--robots", nargs="+", default=[*ROBOTS, *more], help="names or files of robots")
    parser.add_argument("--runs", type=int, default=5, help="number of later processes for each robot")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    found = [measure(name, given.runs) for name in track(given.robots, description="first models")]
    lines = [
        *table(found),
        "",
        f"One first process and {given.runs} later ones for each robot; Python {platform.python_version()}, "
        f"{platform.machine()}, {os.cpu_count()} cores; command: `.venv/bin/python benchmarks/first_models.py "
        f"--robots {' '.join(given.robots)} --runs {given.runs}`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
