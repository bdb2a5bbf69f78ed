"""Collision checks: whether they agree with the arms' own meshes, and how long they take.

`--old PATH` adds the times beside version 0.1, whose checkout PATH is: `git worktree add PATH 6f9afba`. The versions take turns
in one run. `--many` measures only the tables of plans among many obstacles. Writes docs/benchmarks/collision.md. Times are of
this machine, ratios travel better.
"""

import argparse
import json
import platform
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import numpy as np
import pinocchio as pin
from convergence import ROOT, Worker, no_package, speaker
from rich.progress import track

import manipplan as mp

OUT = ROOT / "docs" / "benchmarks" / "collision.md"
#: Configurations that are further than this from touching by the meshes should be called free [m].
CLEAR = 2e-3
#: A pair of links that touches in at least this share of the configurations touches by construction.
ALWAYS = 0.95
CONFIGURATIONS = 10_000
ROUNDS = 15
#: Time limit of the search for first paths of plans that are timed [s].
LIMIT = 60.0
Call = Callable[[], object]


# Agreement with the meshes


class Meshes:
    """The collision geometry of the description itself, judged by Pinocchio and coal.

    Its pairs are those of the collision model, each link with its own meshes, except those that touch by construction.
    """

    def __init__(self, robot: mp.Robot, scene: mp.Scene) -> None:
        self.robot, self.geometry = robot, robot.geometry.copy()
        links = [item.name for item in robot.geometry.geometryObjects]
        for first, second in sorted({self._pair(links, *names) for names in mp.Scene().collision_model(robot).pair_names}):
            self.geometry.addCollisionPair(pin.CollisionPair(first, second))
        self.own = len(self.geometry.collisionPairs)
        for obstacle in scene.obstacles:
            for k, shape in enumerate(obstacle.shapes()):
                item = pin.GeometryObject(f"{obstacle.name} {k}", 0, 0, obstacle.pose, shape)
                index = self.geometry.addGeometryObject(item)
                for link in range(len(links)):
                    if self.geometry.geometryObjects[link].parentJoint > 0:
                        self.geometry.addCollisionPair(pin.CollisionPair(link, index))
        self.always: set[int] = set()
        self.data, self.placed = robot.model.createData(), pin.GeometryData(self.geometry)

    @staticmethod
    def _pair(links: Sequence[str], *names: str) -> tuple[int, int]:
        found = [
            max((k for k, link in enumerate(links) if f"{name}.".startswith(f"{link}.")), key=lambda k: len(links[k]))
            for name in names
        ]
        return min(found), max(found)

    def touching(self, q: np.ndarray, margin: float) -> np.ndarray:
        """Whether any pair is nearer than `margin` [m] at each row of q (m, n)."""
        for request in self.placed.collisionRequests:
            request.security_margin = margin
        hits = np.zeros((len(q), len(self.geometry.collisionPairs)), dtype=bool)
        for k, each in enumerate(q):
            pin.computeCollisions(self.robot.model, self.data, self.geometry, self.placed, each, False)
            hits[k] = [result.isCollision() for result in self.placed.collisionResults]
        self.always = set(np.flatnonzero(hits.mean(axis=0)[: self.own] >= ALWAYS).tolist())
        hits[:, sorted(self.always)] = False
        return hits.any(axis=1)

    def distance(self, q: np.ndarray) -> float:
        """The smallest distance of the pairs that coal calls touching at q (n,), except those always near in the last test [m].

        coal's test calls triangles that are less than a micrometre apart touching; its distance does not.
        """
        for request in self.placed.collisionRequests:
            request.security_margin = 0.0
        pin.computeCollisions(self.robot.model, self.data, self.geometry, self.placed, q, False)
        results = enumerate(self.placed.collisionResults)
        hit = [k for k, result in results if result.isCollision() and k not in self.always]
        distances = [pin.computeDistance(self.geometry, self.placed, k).min_distance for k in hit]
        return float(min(distances, default=np.inf))


def beside(robot: mp.Robot, count: int = 8) -> mp.Scene:
    """Boxes, balls and cylinders where the tool can come, a tenth to a third of the arm's reach in size.

    None touches the arm in more than a tenth of its configurations.
    """
    rng = np.random.default_rng(2)
    q = robot.random_configuration(rng, size=400)
    tool = robot.kinematics().pose(q)[:, :3, 3]
    reach = float(np.linalg.norm(np.ptp(tool, axis=0))) / 2
    alone = np.asarray(mp.Scene().in_collision(robot, q))
    obstacles: list[mp.Obstacle] = []
    for place in tool:
        pose = {"position": place, "rotation": rng.uniform(-np.pi, np.pi, 3), "name": f"obstacle {len(obstacles)}"}
        size = rng.uniform(0.1, 0.33, 3) * reach
        shapes = (
            mp.Box(size=size, **pose),
            mp.Sphere(radius=size[0] / 2, **pose),
            mp.Cylinder(radius=size[0] / 2, length=size[1], **pose),
        )
        chosen = shapes[len(obstacles) % 3]
        if (np.asarray(mp.Scene([chosen]).in_collision(robot, q)) & ~alone).mean() < 0.1:
            obstacles.append(chosen)
        if len(obstacles) == count:
            break
    return mp.Scene(obstacles)


def agreement(name: str, count: int) -> str:
    """The line of one arm: random configurations judged by the model and by the meshes."""
    robot = mp.load_robot(name)
    scene = beside(robot)
    q = robot.random_configuration(np.random.default_rng(1), size=count)
    said = np.asarray(scene.in_collision(robot, q))
    meshes = Meshes(robot, scene)
    within, touching = meshes.touching(q, CLEAR), meshes.touching(q, 0.0)
    model = scene.collision_model(robot)
    excess = 1e3 * max(model.excess.values(), default=0.0)
    wrong = sum(meshes.distance(each) <= 0 for each in q[~said & touching])
    strict = (said & ~within).mean()
    return f"| {name} | {model.bodies} | {excess:.1f} mm | {100 * touching.mean():.1f} % | {wrong} | {100 * strict:.2f} % |"


def ends_of_motionbenchmaker() -> tuple[int, int, int, int]:
    """Problems whose start and goal are free by the model, by the meshes, all problems, and ends on which they disagree."""
    from outside import problems

    robot = problems.robot("panda")
    free = by_meshes = differ = 0
    every = problems.load("panda")
    for problem in track(every, description="MotionBenchMaker"):
        ends = np.array([problem.start, problem.goal])
        said = np.asarray(problem.scene.in_collision(robot, ends))
        true = Meshes(robot, problem.scene).touching(ends, 0.0)
        free, by_meshes, differ = free + (not said.any()), by_meshes + (not true.any()), differ + int((said != true).sum())
    return free, by_meshes, len(every), differ


# Times beside version 0.1


def ten_boxes() -> mp.Scene:
    """Ten boxes around the Panda."""
    rng = np.random.default_rng(5)
    boxes = []
    for k in range(10):
        angle, far, height = 2 * np.pi * (k + 0.3 * rng.random()) / 10, rng.uniform(0.45, 0.75), rng.uniform(0.1, 0.9)
        place = (far * np.cos(angle), far * np.sin(angle), height)
        boxes.append(mp.Box(size=tuple(rng.uniform(0.08, 0.25, 3)), position=place, name=f"box {k}"))
    return mp.Scene(boxes)


def calls(path: Sequence[Sequence[float]]) -> dict[str, Call]:
    """What is timed in both versions, with everything built; `path`: waypoints of a free motion."""
    robot, scene = mp.load_robot("panda"), ten_boxes()
    model = scene.collision_model(robot)
    q = robot.random_configuration(np.random.default_rng(3), size=CONFIGURATIONS)
    some = list(q[:1000])
    motion = mp.JointPath.through(np.array(path))
    if not model.path_is_free(motion, 1e-3):
        raise SystemExit("the motion is not free")
    return {
        "one configuration (1,000 in turn)": lambda: [model.in_collision(each) for each in some],
        "a batch of 10,000 configurations": lambda: scene.in_collision(robot, q),
        "all distances of one configuration (100 in turn)": lambda: [model.distances(each) for each in some[:100]],
        "a whole motion at every milliradian": lambda: model.path_is_free(motion, 1e-3),
        "proof of a whole motion": lambda: scene.path_clearance(robot, motion),
    }


def work() -> None:
    """Answer a call's name by its time [s]; the first task brings the path."""
    say = speaker()
    made: dict[str, Call] = {}
    for line in sys.stdin:
        task = json.loads(line)
        if "path" in task:
            made = calls(task["path"])
            for call in made.values():
                call()
            say({"names": list(made)})
            continue
        began = time.perf_counter()
        made[task["call"]]()
        say({"seconds": time.perf_counter() - began})


def beside_old(old: Path) -> list[str]:
    """Lines with the times of both versions."""
    robot = mp.load_robot("panda")
    start, goal = pairs_among(ten_boxes(), robot, 1)[0]
    plan = mp.plan(robot, start, goal, ten_boxes(), clearance=0.06, throw=False)
    motion = plan.trajectory.path()
    path = motion(np.linspace(0.0, 1.0, 40)).tolist()
    lines = ["| Panda among ten boxes | version 0.1 | this version | ratio: median, lowest |", "|---|---|---|---|"]
    times: dict[str, list[tuple[float, float]]] = {}
    with Worker(ROOT, script=__file__) as new, Worker(old, script=__file__) as before:
        names = new({"path": path})["names"]
        before({"path": path})
        for _ in track(range(ROUNDS), description="times"):
            for name in names:
                times.setdefault(name, []).append((before({"call": name})["seconds"], new({"call": name})["seconds"]))
    for name, every in times.items():
        pairs = np.array(every)
        ratio = pairs[:, 0] / pairs[:, 1]
        was, now = np.median(pairs, axis=0)
        lines.append(f"| {name} | {1e3 * was:.3g} ms | {1e3 * now:.3g} ms | {np.median(ratio):.1f}, {ratio.min():.1f} |")
    return lines


# Plans among many obstacles


def pairs_among(scene: mp.Scene, robot: mp.Robot, count: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Random starts and goals that keep 10 mm from everything and are joined by a path."""
    rng, found = np.random.default_rng(8), []
    model = scene.collision_model(robot)
    while len(found) < count:
        start, goal = robot.random_configuration(rng, size=2)
        if model.in_collision(start, clearance=0.07) or model.in_collision(goal, clearance=0.07):
            continue
        try:
            mp.seed_path(robot, start, goal, scene, seeding=mp.Seeding(time_limit=3.0))
        except getattr(mp, "errors", mp).PlanningError:  # version 0.1 has it at the top
            continue
        found.append((start, goal))
    return found


def same_boxes() -> dict[str, mp.Scene]:
    """The ten boxes in other forms: cut into smaller ones, filled with balls, as points and as a rippled mesh."""
    small: list[mp.Obstacle] = []
    balls: list[mp.Obstacle] = []
    points, triangles = [], []
    for box in ten_boxes().obstacles:
        place, size = np.asarray(box.position), np.asarray(box.size)
        for cell in grid(5, 5, 4):
            small.append(mp.Box(size=size / (5, 5, 4), position=place + size * cell))
        for cell in grid(5, 5, 6):
            balls.append(mp.Sphere(radius=float(size.min()) / 10, position=place + (size - size.min() / 5) * cell * 1.2))
        faces = surface(size, 41)
        points.append(place + faces.reshape(-1, 3) * (1 - 4e-3 / size))
        ripple = 5e-4 * np.sin(200 * np.roll(faces, 1, axis=-1)) * np.sign(faces)
        triangles.append(place + faces - 1e-3 * np.sign(faces) + ripple)
    corners = np.unique(np.concatenate(points).round(6), axis=0)
    chosen = np.random.default_rng(0).choice(len(corners), 100_000, replace=len(corners) < 100_000)
    return {
        "ten boxes": ten_boxes(),
        f"{len(small):,} boxes": mp.Scene(small),
        f"{len(balls):,} balls": mp.Scene(balls),
        "a cloud of 100,000 points": mp.Scene([mp.PointCloud(points=corners[chosen], radius=2e-3, name="cloud")]),
        f"a mesh of {sum(map(len, triangles)):,} triangles": mp.Scene(
            [mp.Mesh(triangles=np.concatenate(triangles), name="mesh")]
        ),
    }


def grid(*counts: int) -> np.ndarray:
    """Centres of the cells of a unit cube about 0, (k, 3)."""
    lines = [(np.arange(count) + 0.5) / count - 0.5 for count in counts]
    return np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3)


def surface(size: np.ndarray, cells: int) -> np.ndarray:
    """The triangles (t, 3, 3) of a box about 0 whose faces are cut into cells, seen from outside counterclockwise."""
    ticks = np.linspace(-0.5, 0.5, cells + 1)
    u, v = np.meshgrid(ticks, ticks, indexing="ij")
    found = []
    for axis in range(3):
        for side in (-0.5, 0.5):
            corner = np.empty((*u.shape, 3))
            corner[..., axis], corner[..., axis - 2], corner[..., axis - 1] = side, u, v
            a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
            both = np.concatenate([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)
            found.append(both if side > 0 else both[:, ::-1])
    return np.concatenate(found) * size


def timed_plan(robot: mp.Robot, start: np.ndarray, goal: np.ndarray, scene: mp.Scene) -> tuple[mp.Plan, float]:
    """The plan, and its processor time [s]; the time limit is so long that other work on the machine does not cut it short."""
    began = time.process_time()
    plan = mp.plan(robot, start, goal, scene, seeding=mp.Seeding(time_limit=LIMIT), throw=False)
    return plan, time.process_time() - began


def prepared(robot: mp.Robot, start: np.ndarray, goal: np.ndarray, scene: mp.Scene) -> float:
    """Processor time that the first plan in a scene takes beyond the second one, for its model and its coarse copy [s]."""
    first = timed_plan(robot, start, goal, scene)[1]
    return max(first - timed_plan(robot, start, goal, scene)[1], 0.0)


def among_many(count: int) -> list[str]:
    """Lines with the times of plans among the same boxes in several forms."""
    robot, scenes = mp.load_robot("panda"), same_boxes()
    boxes = scenes["ten boxes"]
    chosen = pairs_among(boxes, robot, count)
    times: dict[str, list[float]] = {name: [] for name in scenes}
    results: dict[str, Counter[str]] = {name: Counter() for name in scenes}
    falls = dict.fromkeys(scenes, 0.0)
    mp.plan(robot, *chosen[0], ten_boxes(), throw=False)  # the first plan of a process also imports and compiles
    once = {name: prepared(robot, *chosen[0], scene) for name, scene in (scenes | {"ten boxes": ten_boxes()}).items()}
    for start, goal in track(chosen, description="plans"):
        for name, scene in scenes.items():
            plan, seconds = timed_plan(robot, start, goal, scene)
            times[name].append(seconds)
            results[name][plan.status.name] += 1
            if plan.status is mp.Status.OPTIMAL:
                shape, seeding = mp.PathShape(degree=plan.path.degree), mp.Seeding(initial=plan.path)
                again = mp.optimize_path(robot, start, goal, scene, shape=shape, seeding=seeding, throw=False)
                falls[name] = max(falls[name], 1 - again.g / plan.result.g)
    lines = [
        f"| Panda, {len(chosen)} pairs, among | prepared, once | plan: median, worst | over ten boxes: median, worst | results "
        "| OPTIMAL ones optimised again: largest fall of g |",
        "|---|---|---|---|---|---|",
    ]
    for name in scenes:
        ratio = np.array(times[name]) / np.array(times["ten boxes"])
        found = ", ".join(f"{number} {status}" for status, number in results[name].most_common())
        lines.append(
            f"| {name} | {once[name]:.2f} s | {np.median(times[name]):.2f} s, {max(times[name]):.2f} s "
            f"| {np.median(ratio):.2f}, {ratio.max():.2f} | {found} | {falls[name]:.0e} |"
        )
    return lines


def as_cloud(scene: mp.Scene, spacing: float = 8e-3, radius: float = 4e-3) -> mp.Scene:
    """The scene with one cloud of points on the surfaces of its boxes; other obstacles stay."""
    points, others = [], []
    for obstacle in scene.obstacles:
        if not isinstance(obstacle, mp.Box):
            others.append(obstacle)
            continue
        size = np.maximum(np.asarray(obstacle.size) - 2 * radius, 0.0)
        lines = [np.linspace(-edge / 2, edge / 2, int(np.ceil(edge / spacing)) + 1) for edge in size]
        lattice = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3)
        points.append(lattice[(np.abs(lattice) >= size / 2).any(axis=1)] @ obstacle.pose.rotation.T + obstacle.pose.translation)
    return mp.Scene([*others, mp.PointCloud(points=np.concatenate(points), radius=radius, name="cloud")])


def among_clouds(count: int) -> list[str]:
    """Lines with the times of MotionBenchMaker's problems, the first of each set, with their boxes as clouds of points."""
    from outside import problems

    robot = problems.robot("panda")
    chosen: dict[str, list[problems.Problem]] = {}
    for problem in problems.load("panda"):
        if not robot.limits.outside(problem.goal).any():
            chosen.setdefault(problem.set, []).append(problem)
    lines = [
        f"| MotionBenchMaker, Panda, first {count} of each set | points | prepared, once | plan among boxes | among points "
        "| ratio | with preparation | results |",
        "|---|---|---|---|---|---|---|---|",
    ]
    ratios, optimal = [], 0
    for name, every in track(chosen.items(), description="clouds"):
        for problem in every[:count]:
            told, seconds, once = [], [], []
            cloud = as_cloud(problem.scene)
            for scene in (problem.scene, cloud):
                once.append(prepared(robot, problem.start, problem.goal, scene))
                plan, taken = timed_plan(robot, problem.start, problem.goal, scene)
                seconds.append(taken)
                told.append(f"{plan.status.name}, g {plan.result.g:.4g}" if plan.result is not None else plan.status.name)
            optimal += plan.status is mp.Status.OPTIMAL
            ratios.append((seconds[1] / seconds[0], (seconds[1] + once[1]) / (seconds[0] + once[0])))
            lines.append(
                f"| {name} {problem.number} | {len(cloud.obstacles[-1].kept):,} | {once[1]:.2f} s | {seconds[0]:.2f} s "
                f"| {seconds[1]:.2f} s | {ratios[-1][0]:.1f} | {ratios[-1][1]:.1f} | {'; '.join(told)} |"
            )
    middle, worst = np.median(ratios, axis=0), np.max(ratios, axis=0)
    lines.append(
        f"| median; worst | | | | | {middle[0]:.1f}; {worst[0]:.1f} | {middle[1]:.1f}; {worst[1]:.1f} "
        f"| {optimal} of {len(ratios)} OPTIMAL among points |"
    )
    return lines


SECOND = """
import time
import manipplan as mp
began = time.perf_counter()
robot = mp.load_robot("panda")
mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), position=(0.5, 0.0, 0.5))]).in_collision(robot, robot.neutral)
print(time.perf_counter() - began)
"""


def second_process(times: int = 9) -> list[float]:
    """Times from the end of the import to the first answer, in processes after one that has stored everything [s]."""
    run = [sys.executable, "-c", SECOND]
    found = [float(subprocess.run(run, capture_output=True, text=True, check=True).stdout) for _ in range(times + 1)]
    return sorted(found[1:])


def replace_tables(file: Path, tables: Sequence[Sequence[str]]) -> None:
    """Put tables in place of those in a file whose first lines begin alike."""
    sections = file.read_text().rstrip("\n").split("\n\n")
    for table in tables:
        [at] = [k for k, section in enumerate(sections) if section.startswith(table[0][:9])]
        sections[at] = "\n".join(table)
    file.write_text("\n\n".join(sections) + "\n")


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--old", type=Path, help="checkout of version 0.1")
    parser.add_argument("--configurations", type=int, default=CONFIGURATIONS, help="number of configurations of each arm")
    parser.add_argument("--plans", type=int, default=10, help="number of pairs among many obstacles")
    parser.add_argument("--arms", nargs="*", default=list(mp.available_robots()), help="arms of the first table")
    parser.add_argument("--many", action="store_true", help="only the tables of plans among many obstacles; the others stay")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the tables")
    given = parser.parse_args(arguments)
    if given.old is not None and not (given.old / "manipplan").is_dir():
        parser.error(no_package(given.old))
    sections: list[Iterable[str]] = []
    if given.many:
        replace_tables(given.out, [among_many(given.plans), among_clouds(max(1, given.plans // 3))])
        return
    second = 1e3 * np.array(second_process())
    told = f"{np.median(second):.0f} ms after the import (median of {len(second)}; worst {second[-1]:.0f} ms)"
    sections.append([f"Second process, load Panda and check one configuration: {told}."])
    if given.old is not None:
        sections.append(beside_old(given.old.resolve()))
    if given.plans:
        sections.append(among_many(given.plans))
        sections.append(among_clouds(max(1, given.plans // 3)))
    free, by_meshes, problems, differ = ends_of_motionbenchmaker()
    told = f"start and goal of {free} are free, by the meshes of {by_meshes}; the two disagree on {differ} ends"
    sections.append([f"MotionBenchMaker, Panda, {problems} problems, fingers at 65 mm: {told}."])
    head = [
        f"| arm, {given.configurations:,} random configurations | bodies | largest excess | touching by the meshes "
        "| called free, but touching | called touching, but 2 mm clear |",
        "|---|---|---|---|---|---|",
    ]
    sections.append([*head, *(agreement(name, given.configurations) for name in track(given.arms, description="arms"))])
    options = f"--old PATH --plans {given.plans} --configurations {given.configurations}"
    command = f"`.venv/bin/python benchmarks/collision.py {options}`"
    alone = f"`.venv/bin/python benchmarks/collision.py --many --plans {given.plans}`"
    told = f"command: {command}; the tables of plans, in processor time: {alone}"
    sections.append([f"Python {platform.python_version()}, {platform.machine()}; {told}."])
    text = "\n\n".join("\n".join(section) for section in sections) + "\n"
    given.out.write_text(text)
    print(text)


if __name__ == "__main__":
    if sys.argv[1:] == ["--worker"]:
        work()
    else:
        main()
