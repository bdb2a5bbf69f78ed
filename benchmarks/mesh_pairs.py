"""Arms of which two links are decided by their meshes: how long plans take, and how much of that another library's distances.

Run with `make benchmark`. Each robot is a six-joint arm with generated meshes on two links around one wrist: a ring around a
rod, a fork around a blade, and so on. Six convex pieces of most of them touch where the meshes do not, so that more pieces or
the triangles decide. Plans have no obstacles; start and goal are random and free. Where the determinant of the Jacobian has
another sign at the goal, every path crosses a singularity, and the cost has no smooth optimum there: these plans are counted
apart, and all are planned again with contact of the two links allowed. Writes docs/benchmarks/mesh_pairs.md.
"""

import argparse
import cProfile
import platform
import pstats
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from closed_meshes import extruded, turned, write_mesh
from numpy.typing import NDArray
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "mesh_pairs.md"
SEED = 6
#: Number of configurations whose poses a tool path goes through, on a straight motion by this much of each joint [rad].
POSES, MOTION = 9, np.array([0.3, 0.2, -0.2, 0.1, 0.01, 0.1])
#: The functions of the collision model that ask coal.
COAL = ("_distance", "_witness", "_touches")
HEAD = (
    "| robot | triangles | plans | `OPTIMAL` | other | `OPTIMAL` where no singularity is between start and goal "
    "| `OPTIMAL` with the pair allowed | processor time: median, worst | largest share in coal "
    "| lines followed | processor time: median, worst | largest share in coal | first collision model |"
)

Array = NDArray[np.float64]


# ---- meshes, around the x axis of a link


def lying(triangles: Array) -> Array:
    """With the z axis along x."""
    return triangles[:, :, [2, 0, 1]]


def tube(inner: float, outer: float, low: float, high: float, sides: int = 96) -> Array:
    """A tube from `low` to `high` along x."""
    return lying(turned([(inner, low), (outer, low), (outer, high), (inner, high)], sides))


def upright(triangles: Array) -> Array:
    """With the y axis along z."""
    return np.stack([triangles[..., 0], -triangles[..., 2], triangles[..., 1]], axis=-1)


def rod(radius: float, low: float, high: float, sides: int = 96) -> Array:
    """A cylinder from `low` to `high` along x."""
    angle = 2 * np.pi * np.arange(sides) / sides
    circle = extruded(radius * np.column_stack([np.cos(angle), np.sin(angle)]), high - low)
    return lying(circle) + np.array([(low + high) / 2, 0.0, 0.0])


def block(low: Sequence[float], high: Sequence[float]) -> Array:
    """A box from corner to corner."""
    size, middle = np.subtract(high, low), np.add(high, low) / 2
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * size[:2] / 2
    return extruded(square, size[2]) + middle


def outline(points: Sequence[tuple[float, float]], height: float) -> Array:
    """A prism over a polygon in the x-y plane, which is cut into triangles by its ears."""
    corners, left, ears = np.array(points, dtype=float), list(range(len(points))), []

    def area(a: int, b: int, c: int) -> float:
        (ax, ay), (bx, by), (cx, cy) = corners[[a, b, c]]
        return float((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))

    while len(left) > 2:
        for k, b in enumerate(left):
            a, c = left[k - 1], left[(k + 1) % len(left)]
            others = [d for d in left if d not in (a, b, c)]
            if area(a, b, c) > 0 and not any(min(area(a, b, d), area(b, c, d), area(c, a, d)) >= 0 for d in others):
                ears.append((a, b, c))
                left.remove(b)
                break
    low, high = (np.column_stack([corners, np.full(len(corners), z)]) for z in (-height / 2, height / 2))
    found = [[high[a], high[b], high[c]] for a, b, c in ears] + [[low[c], low[b], low[a]] for a, b, c in ears]
    for i in range(len(corners)):
        j = (i + 1) % len(corners)
        found += [[low[i], low[j], high[j]], [low[i], high[j], high[i]]]
    return np.array(found)


def star(teeth: int, inner: float, outer: float, thickness: float) -> Array:
    """A gear on the x axis."""
    angle = np.pi * np.arange(2 * teeth) / teeth
    radius = np.where(np.arange(2 * teeth) % 2, inner, outer)
    return lying(extruded(radius[:, None] * np.column_stack([np.cos(angle), np.sin(angle)]), thickness))


#: By robot: the mesh on the link before the wrist, the one on the link behind it, and the limits of the joint between
#: that bends [rad] and of the one that turns.
PAIRS: dict[str, Callable[[], tuple[Array, Array, float, float]]] = {
    "ring around a rod": lambda: (tube(0.06, 0.08, -0.025, 0.025), rod(0.04, -0.1, 0.1), 0.3, 3.0),
    "ring around a flanged rod": lambda: (
        tube(0.06, 0.08, -0.02, 0.02),
        lying(turned([(0.0, -0.1), (0.07, -0.1), (0.07, -0.08), (0.04, -0.08), (0.04, 0.1), (0.0, 0.1)], 48)),
        0.3,
        3.0,
    ),
    "fork around a blade": lambda: (
        upright(
            outline([(-0.1, -0.06), (0.08, -0.06), (0.08, -0.035), (-0.07, -0.035),
                     (-0.07, 0.035), (0.08, 0.035), (0.08, 0.06), (-0.1, 0.06)], 0.08)
        ),
        block((-0.04, -0.03, -0.02), (0.2, 0.03, 0.02)),
        0.8,
        0.3,
    ),
    "hollow wrist": lambda: (tube(0.05, 0.065, -0.12, 0.03), tube(0.03, 0.042, -0.1, 0.15, 64), 0.12, 3.0),
    "gear in a housing": lambda: (
        lying(turned([(0.0, -0.05), (0.09, -0.05), (0.09, 0.05), (0.08, 0.05), (0.08, -0.04), (0.0, -0.04)], 64)),
        np.concatenate([star(24, 0.055, 0.065, 0.03), rod(0.02, 0.016, 0.15, 24)]),
        0.15,
        3.0,
    ),
    "telescoping sleeves": lambda: (tube(0.041, 0.05, -0.1, 0.1), tube(0.033, 0.04, -0.08, 0.18), 0.003, 3.0),
    "hook": lambda: (
        outline([(-0.1, -0.02), (0.05, -0.02), (0.05, 0.08), (-0.02, 0.08),
                 (-0.02, 0.06), (0.03, 0.06), (0.03, 0.0), (-0.1, 0.0)], 0.05),
        block((-0.01, 0.02, -0.06), (0.015, 0.04, 0.06)),
        0.5,
        0.3,
    ),
    "window": lambda: (
        np.concatenate(
            [
                block((-0.01, -0.1, -0.1), (0.01, -0.05, 0.1)),
                block((-0.01, 0.05, -0.1), (0.01, 0.1, 0.1)),
                block((-0.01, -0.0501, -0.1), (0.01, 0.0501, -0.05)),
                block((-0.01, -0.0501, 0.05), (0.01, 0.0501, 0.1)),
            ]
        ),
        outline([(-0.06, -0.02), (0.2, -0.02), (0.2, 0.04), (0.17, 0.04), (0.17, 0.015), (-0.06, 0.015)], 0.04),
        0.4,
        1.0,
    ),
}  # fmt: skip


def build(name: str, folder: Path) -> tuple[mp.Robot, int]:
    """A six-joint arm with the two meshes, and their number of triangles."""
    before, behind, bend, turn = PAIRS[name]()
    boxes = '<collision><origin xyz="{} 0 0"/><geometry><box size="{} 0.05 0.05"/></geometry></collision>'
    geometry = {
        "l2": boxes.format(0.15, 0.25),
        "l3": f'<collision><geometry><mesh filename="{write_mesh(folder / "before.obj", before)}"/></geometry></collision>',
        "l5": f'<collision><geometry><mesh filename="{write_mesh(folder / "behind.obj", behind)}"/></geometry></collision>',
        "l6": boxes.format(0.06, 0.08),
    }
    joints = [
        ("l1", "0 0 0.4", "0 0 1", 2.9),
        ("l2", "0 0 0.1", "0 1 0", 2.0),
        ("l3", "0.4 0 0", "0 1 0", 2.4),
        ("l4", "0 0 0", "1 0 0", turn),
        ("l5", "0 0 0", "0 0 1", bend),
        ("l6", "0.25 0 0", "0 1 0", 1.8),
    ]
    parts, parent = ['<link name="base"/>'], "base"
    for link, origin, axis, most in joints:
        parts.append(f'<link name="{link}">{geometry.get(link, "")}</link>')
        parts.append(
            f'<joint name="{link}_joint" type="revolute"><parent link="{parent}"/><child link="{link}"/>'
            f'<origin xyz="{origin}"/>'
            f'<axis xyz="{axis}"/><limit lower="-{most}" upper="{most}" velocity="2" effort="50"/></joint>'
        )
        parent = link
    parts.append('<link name="tool"/><joint name="fixed" type="fixed"><parent link="l6"/><child link="tool"/>')
    file = folder / "arm.urdf"
    file.write_text(f'<robot name="{name}">{"".join(parts)}<origin xyz="0.1 0 0"/></joint></robot>', encoding="utf-8")
    return mp.Robot.from_urdf(file, tool="tool"), len(before) + len(behind)


@dataclass(kw_only=True)
class Times:
    """Of several calls: statuses, processor times [s], and the shares of it in coal's distances."""

    statuses: list[str] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)
    shares: list[float] = field(default_factory=list)

    def run(self, call: Callable[[], mp.Plan]) -> None:
        """Measure one call, then its profile."""
        began = time.process_time()
        status = call().status
        self.seconds.append(time.process_time() - began)
        self.statuses.append(getattr(status, "name", str(status)))
        profile = cProfile.Profile()
        profile.runcall(call)
        stats = pstats.Stats(profile)
        spent = [each[3] for (_, _, name), each in stats.stats.items() if name in COAL]  # type: ignore[attr-defined]
        self.shares.append(sum(spent) / stats.total_tt)  # type: ignore[attr-defined]

    def cells(self) -> list[str]:
        """Median and worst time, and the largest share."""
        if not self.seconds:
            return ["–", "–"]
        return [f"{np.median(self.seconds):.2f} s, {max(self.seconds):.2f} s", f"{max(self.shares):.1%}"]


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Of one robot.

    `same_side`: whether no singularity is between start and goal; `allowed`: statuses with the pair allowed.
    """

    name: str
    triangles: int
    same_side: list[bool]
    allowed: list[str]
    plans: Times
    lines: Times
    model: float


def measure(name: str, plans: int, lines: int) -> Outcome:
    """Plans and lines with one robot."""
    rng, planned, followed = np.random.default_rng(SEED), Times(), Times()
    with tempfile.TemporaryDirectory() as folder:
        robot, triangles = build(name, Path(folder))
        began = time.process_time()
        model = mp.Scene().collision_model(robot)
        first = time.process_time() - began
        free = [q for q in robot.random_configuration(rng, size=40 * (plans + lines)) if not model.in_collision(q)]
        scene = mp.Scene(allowed=[("l3", "l5")])
        sides = np.linalg.det(robot.kinematics().jacobian(np.array(free))) > 0
        same_side = [bool(sides[2 * k] == sides[2 * k + 1]) for k in range(plans)]
        allowed = [mp.plan(robot, *free[2 * k : 2 * k + 2], scene, throw=False).status.name for k in range(plans)]
        for k in range(plans):
            start, goal = free[2 * k : 2 * k + 2]
            planned.run(lambda start=start, goal=goal: mp.plan(robot, start, goal, throw=False))  # type: ignore[misc]
        for q in free[2 * plans : 2 * plans + lines]:
            path = mp.CartesianPath.through(robot.kinematics().pose(np.linspace(q / 2, q / 2 + MOTION, POSES)))
            try:
                followed.run(lambda path=path: mp.follow(robot, path, throw=False))  # type: ignore[misc]
            except mp.errors.InvalidInputError:  # gaps of less than the 3 mm that the search along a tool path keeps
                followed.statuses.append("refused")
    return Outcome(
        name=name, triangles=triangles, same_side=same_side, allowed=allowed, plans=planned, lines=followed, model=first
    )


def row(found: Outcome) -> str:
    """The line of one robot."""
    optimal = found.plans.statuses.count("OPTIMAL")
    others = sorted({each for each in found.plans.statuses if each != "OPTIMAL"})
    done = len(found.lines.seconds)
    cells = [found.name, str(found.triangles), str(len(found.plans.statuses)), str(optimal), ", ".join(others) or "–"]
    easy = [status for status, same in zip(found.plans.statuses, found.same_side, strict=True) if same]
    cells += [f"{easy.count('OPTIMAL')} of {len(easy)}", str(found.allowed.count("OPTIMAL"))]
    cells += [*found.plans.cells(), f"{done} of {len(found.lines.statuses)}", *found.lines.cells(), f"{found.model:.1f} s"]
    return f"| {' | '.join(cells)} |"


def main(arguments: Sequence[str] | None = None) -> list[Outcome]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plans", type=int, default=10, help="plans per robot")
    parser.add_argument("--lines", type=int, default=2, help="tool paths per robot")
    parser.add_argument("--robots", nargs="*", default=list(PAIRS), choices=list(PAIRS))
    parser.add_argument("--out", type=Path, default=OUT)
    given = parser.parse_args(arguments)
    found = [measure(name, given.plans, given.lines) for name in track(given.robots, "robots")]
    lines = [HEAD, "|---" * 13 + "|", *map(row, found)]
    if len(found) > 1:
        plans, follows = Times(), Times()
        for each in found:
            for all_, own in ((plans, each.plans), (follows, each.lines)):
                all_.statuses += own.statuses
                all_.seconds += own.seconds
                all_.shares += own.shares
        whole = Outcome(
            name="all",
            triangles=sum(each.triangles for each in found),
            same_side=[each for one in found for each in one.same_side],
            allowed=[each for one in found for each in one.allowed],
            plans=plans,
            lines=follows,
            model=sum(each.model for each in found),
        )
        lines.append(row(whole))
    command = f"python benchmarks/mesh_pairs.py --plans {given.plans} --lines {given.lines}"
    if given.robots != list(PAIRS):
        command += " --robots " + " ".join(f"'{each}'" for each in given.robots)
    lines += ["", f"Python {platform.python_version()}, {platform.machine()}; command: `{command}`."]
    given.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(given.out.read_text(encoding="utf-8"))
    return found


if __name__ == "__main__":
    main()
