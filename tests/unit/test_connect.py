"""Our own compiled search for paths, which counts crossings of singularities."""

import json
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import manipplan as mp
from manipplan.collision.model import CollisionModel
from manipplan.kinematics.factors import singularity_signs
from manipplan.seeds import connect
from manipplan.seeds.connect import MotionCheck, TreeSearch, can_check
from manipplan.seeds.ompl import OmplSearch
from manipplan.seeds.seeding import PLANNERS, STAR
from manipplan.seeds.task import Level, SeedTask
from manipplan.support.deadline import work_time

START, GOAL = [0.0, 1.5, -2.0], [3.14, -2.0, 2.0]
POST = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])


def crossings(robot, path):
    """Number of changes of sign of any factor of det J along a path."""
    return singularity_signs(robot.kinematics()).changes(path(path.fine_samples(1e-3)))


def task_of(robot, scene, start, goal, **options):
    given = {"seed": 0, "clearance": 0.0, "signs": None, "most_crossings": None, "checks": None}
    given |= {"deadline": work_time() + 30.0} | options
    model = scene.collision_model(robot)
    distances = tuple(model.least_distance(np.array([q], dtype=float))[0] for q in (start, goal))
    return SeedTask(model=model, distances=distances, start=np.array(start), goal=np.array(goal), **given)


def assert_free(scene, robot, waypoints):
    """Free by coal alone at every milliradian."""
    model = scene.collision_model(robot)
    path = mp.JointPath.through(waypoints)
    assert not any(model._touches(q, 0.0) for q in path(path.fine_samples(5e-3)))


def two_links(lower, upper):
    """Two links of 1 m; det J is zero where the second joint is."""
    arm = mp.planar_arm([1.0, 1.0])
    limits = replace(arm.limits, lower=np.array(lower), upper=np.array(upper))
    return replace(arm, limits=limits)


#: A post that the first link passes below: between these ends the elbow must straighten, unless it bends by 120 degrees or more.
NARROW = mp.Scene([mp.Cylinder(radius=0.03, length=1.0, position=(1.08 * np.cos(1.0), 1.08 * np.sin(1.0), 0.0), name="post")])
ENDS = [-0.8, 0.5], [2.8, 0.5]


def test_a_path_keeps_its_aspect_where_it_can():
    arm = two_links([-3.0, -2.6], [3.0, 2.6])
    path = mp.seed_path(arm, *ENDS, NARROW, fewest_crossings=True)
    assert crossings(arm, path) == 0
    assert NARROW.path_clearance(arm, path).proven


@pytest.mark.slow
def test_two_crossings_more_are_taken_where_none_is_not_enough():
    arm = two_links([-3.0, -2.6], [3.0, 1.6])
    path = mp.seed_path(arm, *ENDS, NARROW, fewest_crossings=True)
    assert crossings(arm, path) == 2
    assert NARROW.path_clearance(arm, path).proven
    with pytest.raises(mp.errors.PlanningError, match="no path from start to goal was found by RRT-Connect in 1 s"):
        mp.seed_path(arm, *ENDS, NARROW, same_aspect=True, seeding=mp.Seeding(time_limit=1.0))


@pytest.mark.slow
def test_the_time_limit_holds_for_an_enclosed_goal(monkeypatch):
    arm = two_links([-3.0, -2.6], [3.0, 1.6])
    wall = mp.Scene([mp.Cylinder(radius=0.03, length=1.0, position=(0.5 * np.cos(1.0), 0.5 * np.sin(1.0), 0.0), name="post")])
    began = work_time()
    with pytest.raises(
        mp.errors.PlanningError, match="every motion of joint1 within its limits .* link1_0 and post into contact"
    ):
        mp.seed_path(arm, [0.0, 0.5], [2.5, 0.5], wall, fewest_crossings=True, seeding=mp.Seeding(time_limit=0.8))
    assert work_time() - began < 0.7
    monkeypatch.setattr("manipplan.seeds.seed.why_unreachable", lambda _: None)
    began = work_time()
    with pytest.raises(mp.errors.PlanningError, match="allow more time"):
        mp.seed_path(arm, [0.0, 0.5], [2.5, 0.5], wall, fewest_crossings=True, seeding=mp.Seeding(time_limit=0.8))
    assert 0.7 < work_time() - began < 1.0


@pytest.mark.parametrize("name", ["panda", "ur5"])
def test_paths_are_free_and_depend_on_the_seed_alone(name, panda, ur5, demo_problem):
    robot = {"panda": panda, "ur5": ur5}[name]
    scene = (
        demo_problem.scene
        if name == "panda"
        else mp.Scene([mp.Box(size=(0.2, 0.6, 0.6), position=(0.5, 0.0, 0.4), name="wall")])
    )
    ends = (
        (demo_problem.start, demo_problem.goal)
        if name == "panda"
        else ([-0.9, -1.0, 1.0, -1, -1.2, 0], [0.9, -1.0, 1.0, -1, -1.2, 0])
    )
    task = task_of(robot, scene, *ends)
    first = TreeSearch(task, [Level(step=0.01, margin=0.005)]).path()
    assert len(first) > 2
    assert_free(scene, robot, first)
    np.testing.assert_array_equal(first[[0, -1]], ends)
    with ThreadPoolExecutor(3) as pool:
        for again in pool.map(lambda _: TreeSearch(task, [Level(step=0.01, margin=0.005)]).path(), range(3)):
            np.testing.assert_array_equal(again, first)
    other = TreeSearch(replace(task, seed=1), [Level(step=0.01, margin=0.005)]).path()
    assert other.shape != first.shape or np.abs(other - first).max() > 0.01


def test_a_search_ends_after_its_checks(planar):
    blocked = mp.Scene([mp.Cylinder(radius=0.05, length=1.0, position=(0.0, 0.6, 0.0), name="post")])
    task = task_of(planar, blocked, START, GOAL, checks=5000)
    began = work_time()
    assert TreeSearch(task, [Level(step=0.02, margin=0.0)]).path() is None
    assert work_time() - began < 5.0
    assert TreeSearch(replace(task, deadline=began), [Level(step=0.02, margin=0.0)]).path() is None


def test_many_nodes(planar, monkeypatch):
    """The room for nodes grows, which changes nothing."""
    task = task_of(planar, POST, START, GOAL)
    usual = TreeSearch(task, [Level(step=0.02, margin=0.0)]).path()
    monkeypatch.setattr(connect, "TREE_ROOM", 2)
    np.testing.assert_array_equal(TreeSearch(task, [Level(step=0.02, margin=0.0)]).path(), usual)


EGGS = """<mujoco><worldbody><body name="a" pos="0 0 0.3"><joint name="i" axis="0 0 1" range="-170 170"/>
  <geom type="ellipsoid" size="0.3 0.1 0.05" pos="0.3 0 0"/><body name="b" pos="0.7 0 0"><joint name="j" axis="0 1 0" range="-120 120"/>
  <geom type="ellipsoid" size="0.25 0.05 0.1" pos="0.3 0 0"/></body></body></worldbody></mujoco>"""


@pytest.fixture
def eggs(tmp_path):
    """An arm of ellipsoids, which the collision kernel leaves to coal, and a post in its way."""
    (tmp_path / "eggs.xml").write_text(EGGS)
    arm = mp.Robot.from_mjcf(tmp_path / "eggs.xml", tool="b", velocity=1.0)
    return arm, mp.Scene([mp.Cylinder(radius=0.05, length=0.5, position=(1.05, 0.0, 0.3), name="post")])


@pytest.mark.slow
def test_coal_decides_what_the_kernel_cannot(eggs):
    arm, scene = eggs
    task = task_of(arm, scene, [-1.0, 0.0], [1.0, 0.0])
    way = TreeSearch(task, [Level(step=0.02, margin=0.002)]).path()
    assert len(way) > 2
    assert_free(scene, arm, way)


@pytest.mark.slow
@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError])
def test_an_error_of_coal_s_answer_is_raised(eggs, monkeypatch, error):
    arm, scene = eggs

    def fail(*_, **__):
        raise error

    task = task_of(arm, scene, [-1.0, 0.0], [1.0, 0.0])
    monkeypatch.setattr(CollisionModel, "in_collision", fail)
    with pytest.raises(error):
        TreeSearch(task, [Level(step=0.02, margin=0.0)]).path()


@pytest.mark.slow
@pytest.mark.parametrize("planner", [name for name in PLANNERS if name != STAR])
def test_the_time_limit_holds_where_coal_is_slow(eggs, planner, monkeypatch):
    arm, scene = eggs
    quick = CollisionModel.in_collision

    def slow(model, q, **options):
        time.sleep(0.02)
        return quick(model, q, **options)

    monkeypatch.setattr(CollisionModel, "in_collision", slow)
    assert can_check(scene.collision_model(arm))  # compiled before the clock starts
    began = work_time()
    task = task_of(arm, scene, [-1.0, 0.0], [1.0, 0.0], deadline=began + 0.6)
    OmplSearch(task=task, planner=planner, integral=None).run([Level(step=0.02, margin=0.0)])
    assert work_time() - began < 0.6 + 0.6


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5"])
def test_a_motion_is_free_where_all_its_samples_are(name, panda, ur5, rng):
    """Against the batch check of every sample, and the signs of every factor of det J."""
    robot = {"panda": panda, "ur5": ur5}[name]
    scene = mp.Scene([mp.Box(size=(0.2, 0.6, 0.6), position=(0.5, 0.0, 0.4), name="wall")])
    model, signs = scene.collision_model(robot), singularity_signs(robot.kinematics())
    free = [q for q in robot.random_configuration(rng, size=1000) if not model.in_collision(q)]
    if signs:
        of_each = np.sign(signs.values(np.array(free)))
        free = [q for q, sign in zip(free, of_each, strict=True) if (sign == of_each[0]).all()]
    task = task_of(robot, scene, free[0], free[1], signs=signs, most_crossings=0 if signs else None)
    check, verdicts = MotionCheck(task, [Level(step=0.01, margin=0.0)]), []
    for first, towards in pairwise(free[:120]):
        last = first + rng.uniform(0.0, 0.5) * (towards - first)
        q = first + np.linspace(0.0, 1.0, int(np.ceil(np.abs(last - first).max() / 0.01)) + 1)[:, None] * (last - first)
        expected = not model.in_collision_rows(q).any()
        if signs:
            expected &= signs.changes(np.vstack([task.start, q])) == 0 and signs.changes(np.array([last, task.goal])) == 0
        verdicts.append(expected)
        assert check.motion(list(first), list(last)) == expected
        if signs is None:
            assert check.configuration(list(last)) != model.in_collision(last)
    assert 5 < sum(verdicts) < len(verdicts) - 5


WITHOUT_COMPILER = """
import json, sys, numpy as np, manipplan as mp
arm = mp.load_robot("ur5")
wall = mp.Scene([mp.Box(size=(0.2, 0.6, 0.6), position=(0.5, 0.0, 0.4), name="wall")])
ends = [-0.9, -1.0, 1.0, -1, -1.2, 0], [0.9, -1.0, 1.0, -1, -1.2, 0]
print(json.dumps(mp.seed_path(arm, *ends, wall, fewest_crossings=True).control.tolist()))
"""


@pytest.mark.slow
def test_without_a_compiler_the_path_is_the_same(tmp_path):
    found = []
    for compiler in (None, ""):
        environment = {**os.environ, "PYTHONWARNINGS": "ignore"} | ({} if compiler is None else {"CC": compiler})
        environment["MANIPPLAN_CACHE"] = str(tmp_path / str(compiler))
        run = subprocess.run(
            [sys.executable, "-c", WITHOUT_COMPILER], env=environment, capture_output=True, text=True, timeout=200, check=True
        )
        found.append(np.array(json.loads(run.stdout)))
    np.testing.assert_allclose(found[0], found[1], atol=1e-9)


def test_with_too_many_joints_ompl_searches(planar, monkeypatch):
    monkeypatch.setattr(connect, "MOST_JOINTS", 1)
    assert not can_check(POST.collision_model(planar))
    path = mp.seed_path(planar, START, GOAL, POST)
    np.testing.assert_array_equal(
        path.control, mp.seed_path(planar, START, GOAL, POST, seeding=mp.Seeding(planner="RRTConnect")).control
    )
