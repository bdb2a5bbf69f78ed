"""The suite of pairs in benchmarks/pairs, read and judged by code of this file alone."""

import csv
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp

FOLDER = Path(__file__).parents[2] / "benchmarks" / "pairs"
CLEARANCE = 0.01
COUNTS = {"panda": 17, "ur5": 17, "xarm7": 16}
SCENES = ("free", "table", "shelf")


def read_pairs():
    lines = [line for line in (FOLDER / "pairs.csv").read_text().splitlines() if not line.startswith("#")]
    for row in csv.DictReader(lines):
        yield row["arm"], row["scene"], *(np.array(row[end].split(), dtype=float) for end in ("start", "goal"))


@pytest.fixture(scope="module")
def robots():
    return {arm: mp.load_robot(arm) for arm in COUNTS}


@pytest.fixture(scope="module")
def scenes():
    furnished = {(arm, name): mp.Scene.from_yaml(FOLDER / f"{name}_{arm}.yaml") for arm in COUNTS for name in SCENES[1:]}
    return furnished | {(arm, "free"): mp.Scene() for arm in COUNTS}


def free_at_every_milliradian(robot, scene, path):
    """Distances of all pairs along the path, where no joint moves more than 1 mrad from one look to the next."""
    count = 2
    while True:
        q = path(np.linspace(0, 1, count))
        widest = np.abs(np.diff(q, axis=0)).max()
        if widest <= 1e-3:
            break
        count = int(count * max(widest / 1e-3, 1.01)) + 1
    model = scene.collision_model(robot)
    return not any(model.in_collision(each, clearance=CLEARANCE) for each in q)


def g_of(robot, path):
    """∫ ‖q'‖ / m ds by the trapezoidal rule, m the product of the singular values of J."""
    s = np.linspace(0, 1, 20_001)
    m = np.prod(np.linalg.svd(robot.kinematics().jacobian(path(s)), compute_uv=False), axis=1)
    return np.trapezoid(np.linalg.norm(path(s, 1), axis=1) / m, s)


def check(robot, scene, start, goal, plan):
    """A path from start to goal, inside the limits and free; returns whether it is optimised, and its g over the seed's."""
    path = plan.path
    np.testing.assert_allclose([path.start, path.goal], [start, goal], atol=1e-9)
    q = path(np.linspace(0, 1, 20_001))
    assert (robot.limits.outside(q.min(axis=0)) <= 1e-6).all()
    assert (robot.limits.outside(q.max(axis=0)) <= 1e-6).all()
    assert free_at_every_milliradian(robot, scene, path)
    if not plan.result.status.ok:
        return False, 1.0
    ratio = g_of(robot, path) / g_of(robot, plan.result.seed) if np.isfinite(plan.result.seed_cost.g) else 0.0
    assert ratio <= 1 + 1e-6
    return True, ratio


def test_the_suite_has_its_pairs():
    pairs = list(read_pairs())
    for arm, count in COUNTS.items():
        for name in SCENES:
            assert sum(pair[:2] == (arm, name) for pair in pairs) == count
    assert len(pairs) == 150


@pytest.mark.parametrize("arm", COUNTS)
def test_starts_and_goals_are_inside_the_limits_and_free(arm, robots, scenes):
    robot = robots[arm]
    for name in SCENES:
        q = np.array([end for pair in read_pairs() if pair[:2] == (arm, name) for end in pair[2:]])
        assert (q >= robot.limits.lower).all()
        assert (q <= robot.limits.upper).all()
        assert scenes[arm, name].distances(robot, q).min() >= CLEARANCE


def test_pairs_of_the_ur5_have_one_orientation(robots):
    """det J of a six-joint arm keeps its sign inside an aspect."""
    robot = robots["ur5"]
    for arm, _, start, goal in read_pairs():
        if arm == "ur5":
            first, last = np.linalg.det(robot.kinematics().jacobian(np.array([start, goal])))
            assert first * last > 0
            assert np.sin(start[2]) * np.sin(goal[2]) > 0
            assert np.sin(start[4]) * np.sin(goal[4]) > 0


def test_shelf_pairs_reach_into_it(robots):
    """Start or goal has the tool behind the shelf's front, between its boards and its sides."""
    for arm, name, start, goal in read_pairs():
        if name == "shelf":
            size = 0.85 if arm == "xarm7" else 1.0
            tool = robots[arm].kinematics(mp.Task.pose()).pose(np.array([start, goal]))[:, :3, 3] / size
            inside = (tool > [0.45, -0.42, 0.05]).all(axis=1) & (tool < [0.8, 0.42, 0.79]).all(axis=1)
            assert inside.any()


@pytest.mark.parametrize("arm", COUNTS)
def test_the_first_pair_of_each_scene(arm, robots, scenes):
    for name in SCENES:
        _, _, start, goal = next(pair for pair in read_pairs() if pair[:2] == (arm, name))
        scene = scenes[arm, name]
        plan = mp.plan(robots[arm], start, goal, scene, clearance=CLEARANCE, seeding=mp.Seeding(time_limit=30.0))
        check(robots[arm], scene, start, goal, plan)


def test_the_straight_line_starts_a_descent_although_it_collides(robots, scenes):
    """The planner's path leads to the same minimum of the energy, and no second descent starts from there."""
    start, goal = next(pair[2:] for pair in read_pairs() if pair[:2] == ("panda", "shelf"))
    robot, scene = robots["panda"], scenes["panda", "shelf"]
    plan = mp.plan(robot, start, goal, scene, clearance=CLEARANCE, seeding=mp.Seeding(time_limit=30.0))
    check(robot, scene, start, goal, plan)
    first, *others = plan.result.history
    assert first.clearance < 0
    assert {step.first for step in others} == {"straight"}
    assert plan.result.status is mp.Status.OPTIMAL


@pytest.mark.long
def test_all_pairs_with_obstacles(robots, scenes):
    ratios, optimised = [], 0
    for arm, name, start, goal in read_pairs():
        if name != "free":
            scene = scenes[arm, name]
            plan = mp.plan(robots[arm], start, goal, scene, clearance=CLEARANCE, seeding=mp.Seeding(time_limit=60.0))
            good, ratio = check(robots[arm], scene, start, goal, plan)
            optimised += good
            ratios.append(ratio)
    assert len(ratios) == 100
    assert np.median(ratios) <= 0.7
    assert optimised >= 95
