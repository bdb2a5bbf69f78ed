"""Makes the suite of start-goal pairs: scenes as YAML and pairs.csv, from one random seed by the rule below.

Run `python benchmarks/pairs/make.py`; the files are written beside it. Every draw is uniform inside the joint limits, of
joints that turn more than once within half a turn of zero, and is taken when

- the arm is free with CLEARANCE at start and goal;
- table: the tool is over the table top at start and goal. Shelf: the tool is inside a compartment at the start, and at the
  goal inside another one (every second pair) or anywhere outside of the shelf; half of the pairs are turned round;
- UR5: start and goal lie in one aspect, a region of configurations without a singularity. A six-joint arm cannot pass from
  one aspect to another but through a singularity, where g of every path is infinite;
- `seed_path` with CLEARANCE finds a path within TIME_LIMIT.

Nothing else is looked at: neither how hard a pair is nor what any optimiser makes of it.
"""

import itertools
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import manipplan as mp

HERE = Path(__file__).resolve().parent
SEED, CLEARANCE, TIME_LIMIT = 20261122, 0.01, 10.0
#: Pairs of each scene, by arm, and the size of its furniture beside that of the Panda.
PAIRS = {"panda": 17, "ur5": 17, "xarm7": 16}
SIZE = {"panda": 1.0, "ur5": 1.0, "xarm7": 0.85}
SCENES = ("free", "table", "shelf")
#: Where the tool is over the table: least and greatest x, y, z [m], times the size.
OVER = np.array([[0.25, -0.6, 0.0], [0.8, 0.6, 0.45]])
#: The shelf: front and back in x, half width, heights of the boards, thickness of all its parts [m], times the size.
FRONT, BACK, HALF_WIDTH, BOARDS, THICK = 0.45, 0.8, 0.42, (0.05, 0.42, 0.79), 0.02
BATCH = 20_000


def scene(name: str, size: float) -> mp.Scene:
    """The furniture around an arm whose base stands at the origin, on a plate 30 mm thick."""

    def box(label: str, low: tuple[float, ...], high: tuple[float, ...]) -> mp.Box:
        low, high = size * np.array(low), size * np.array(high)
        return mp.Box(name=label, size=np.round(high - low, 4), position=np.round((low + high) / 2, 4))

    if name == "free":
        return mp.Scene()
    if name == "table":
        return mp.Scene(
            [
                box("table", (-0.4, -0.8, -0.08), (0.9, 0.8, -0.03)),
                box("wall", (-0.4, 0.75, -0.03), (0.9, 0.8, 1.0)),
                box("carton", (0.38, 0.22, -0.03), (0.54, 0.38, 0.25)),
                box("crate", (0.5, -0.15, -0.03), (0.75, 0.05, 0.15)),
                box("stack", (0.3, -0.5, -0.03), (0.45, -0.3, 0.35)),
            ]
        )
    boards = [box(f"board{k}", (FRONT, -HALF_WIDTH, z - THICK), (BACK, HALF_WIDTH, z)) for k, z in enumerate(BOARDS)]
    sides = [
        box(f"side{k}", (FRONT, y - THICK / 2, BOARDS[0]), (BACK, y + THICK / 2, BOARDS[-1] - THICK))
        for k, y in enumerate((-HALF_WIDTH, 0.0, HALF_WIDTH))
    ]
    return mp.Scene([*boards, *sides, box("back", (BACK, -HALF_WIDTH, BOARDS[0]), (BACK + THICK, HALF_WIDTH, BOARDS[-1]))])


def place(name: str, size: float, tool: np.ndarray) -> np.ndarray:
    """Where the tool (k, 3) is: -1 anywhere, from 0 on the number of the place that it is in."""
    if name == "free":
        return np.zeros(len(tool), dtype=int)
    at = tool / size
    if name == "table":
        return np.where(((at > OVER[0]) & (at < OVER[1])).all(axis=1), 0, -1)
    row, column = np.searchsorted(BOARDS, at[:, 2]) - 1, (at[:, 1] > 0).astype(int)
    inside = (at[:, 0] > FRONT) & (at[:, 0] < BACK) & (np.abs(at[:, 1]) < HALF_WIDTH) & (row >= 0) & (row < len(BOARDS) - 1)
    return np.where(inside, 2 * row + column, -1)


def aspect(q: np.ndarray) -> tuple[int, ...]:
    """Which aspect of a UR5 q (6,) lies in; configurations of the same aspect have the same numbers.

    det J has three factors: sin q3 (elbow), sin q5 (wrist) and the distance of the wrist's centre from the plane of the
    first two axes (shoulder), a2 cos q2 + a3 cos(q2 + q3) + d5 sin(q2 + q3 + q4). The sum of its first two terms is a cosine
    of q2 plus an angle of q3; which of its half waves q2 is in tells turns of the shoulder apart.
    """
    a2, a3, d5 = -0.425, -0.39225, 0.09465
    wave = a2 + a3 * np.exp(1j * q[2])
    shoulder = a2 * np.cos(q[1]) + a3 * np.cos(q[1] + q[2]) + d5 * np.sin(q[1] + q[2] + q[3])
    if abs(wave) <= d5:
        return ()  # folded upon itself: the arm is in collision with itself
    phase = q[1] + np.angle(wave) - (0.0 if shoulder > 0 else np.pi)
    return (int(q[2] // np.pi), int(q[4] // np.pi), int(shoulder > 0), round(phase / (2 * np.pi)))


def draws(
    robot: mp.Robot, name: str, size: float, rng: np.random.Generator, *, inside: bool
) -> Iterator[tuple[np.ndarray, int]]:
    """Free configurations (n,) and the place the tool is in; with `inside` only those where it is in one."""
    model, kinematics = scene(name, size).collision_model(robot), robot.kinematics(mp.Task.pose())
    low, high = np.maximum(robot.limits.lower, -np.pi), np.minimum(robot.limits.upper, np.pi)
    while True:
        q = np.round(rng.uniform(low, high, (BATCH, robot.n)), 4)
        places = place(name, size, kinematics.pose(q)[:, :3, 3])
        for each, where in zip(q, places, strict=True):
            wanted = where >= 0 if inside else where < 0
            in_limits = (robot.limits.outside(each) <= 0).all()  # rounding can leave them
            if (
                wanted
                and in_limits
                and not model.in_collision(each, clearance=CLEARANCE)
                and model.distances(each).min() > CLEARANCE
            ):
                yield each, int(where)


def pairs(arm: str, name: str, count: int, rng: np.random.Generator) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """`count` pairs of the rule above."""
    robot, size = mp.load_robot(arm), SIZE[arm]
    placed = scene(name, size)
    inside, outside = (draws(robot, name, size, rng, inside=way) for way in (True, False))
    for k in itertools.count():
        start, first = next(inside)
        to_other = name != "shelf" or k % 2
        goal, second = next(inside if to_other else outside)
        while (name == "shelf" and first == second) or (arm == "ur5" and aspect(start) != aspect(goal)):
            goal, second = next(inside if to_other else outside)
        if name == "shelf" and rng.random() < 0.5:
            start, goal = goal, start
        try:
            mp.seed_path(robot, start, goal, placed, clearance=CLEARANCE, seeding=mp.Seeding(time_limit=TIME_LIMIT))
        except mp.errors.PlanningError:
            continue
        yield start, goal
        count -= 1
        if not count:
            return


def main() -> None:
    lines = [
        f"# Start-goal pairs of benchmarks/pairs/make.py, random seed {SEED}; joint angles in rad, from base to tool.",
        f"# Start and goal are free with {CLEARANCE:g} m of clearance; a path between them is found within {TIME_LIMIT:g} s.",
        "# UR5: start and goal lie in one aspect (the signs of the factors of det J: shoulder, elbow, wrist). Between",
        "# aspects every path crosses a singularity, and g is infinite for all.",
        "arm,scene,start,goal",
    ]
    for row, (name, arm) in enumerate(itertools.product(SCENES, PAIRS)):
        if name != "free":
            scene(name, SIZE[arm]).to_yaml(HERE / f"{name}_{arm}.yaml")
        for ends in pairs(arm, name, PAIRS[arm], np.random.default_rng([SEED, row])):
            lines.append(",".join([arm, name, *(" ".join(f"{x:.4f}" for x in q) for q in ends)]))
        print(name, arm, flush=True)
    (HERE / "pairs.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
