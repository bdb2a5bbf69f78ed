"""Planners of the user for first paths: what they are given, and what they may return."""

import pickle
import time
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp

START, GOAL = np.array([0.0, 1.5, -2.0]), np.array([np.pi, -2.0, 2.0])
POST = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])


def tree_search(problem):
    """A plain RRT whose last step is the straight motion to the goal."""
    points, parents = [problem.start], [-1]
    while True:
        target = problem.random.uniform(problem.lower, problem.upper)
        near = int(np.argmin([np.linalg.norm(target - each) for each in points]))
        step = target - points[near]
        new = points[near] + step * min(1.0, 1.0 / np.linalg.norm(step))
        if not problem.motion_is_free(points[near], new):
            continue
        points.append(new)
        parents.append(near)
        if problem.motion_is_free(new, problem.goal):
            way, at = [problem.goal], len(points) - 1
            while at >= 0:
                way.append(points[at])
                at = parents[at]
            return way[::-1]


def path_of(planner, robot, scene=POST, **options):
    return mp.seed_path(robot, START, GOAL, scene, seeding=mp.Seeding(planner=planner, **options))


def test_its_path_is_free_and_repeatable(planar):
    path = path_of(tree_search, planar, seed=3)
    assert np.abs(path.start - START).max() == 0.0 and np.abs(path.goal - GOAL).max() < 1e-12
    assert POST.path_clearance(planar, path).proven
    assert np.array_equal(path.control, path_of(tree_search, planar, seed=3).control)
    assert not np.array_equal(path.control, path_of(tree_search, planar, seed=4).control)


@pytest.mark.slow
def test_plan_and_optimize_path_ask_it(planar):
    asked = []

    def counted(problem):
        asked.append(problem)
        return tree_search(problem)

    result = mp.optimize_path(planar, START, GOAL, POST, seeding=mp.Seeding(planner=counted, count=2))
    assert result.status.ok and len(asked) >= 2
    assert mp.plan(planar, START, GOAL, POST, seeding=mp.Seeding(planner=counted)).status.ok


def test_what_it_is_given(planar):
    given = []

    def planner(problem):
        given.append(problem)
        assert isinstance(problem, mp.PlannerProblem)
        assert problem.robot is planar
        assert np.array_equal(problem.start, START) and np.array_equal(problem.goal, GOAL)
        assert 0 < problem.time_left <= 5.0
        assert (problem.lower <= np.minimum(START, GOAL)).all() and (problem.upper >= np.maximum(START, GOAL)).all()
        q = problem.random.uniform(problem.lower, problem.upper, (4, 5, 3))
        model = POST.collision_model(planar)
        wanted = [[not model.in_collision(each, clearance=0.01) for each in row] for row in q]
        assert problem.is_free(q).tolist() == wanted
        assert not problem.is_free(problem.upper + 1.0)
        for first, last in pairwise(q.reshape(-1, 3)):
            path = mp.JointPath.line(first, last)
            free = not model.in_collision_rows(path(path.fine_samples(problem.step)), clearance=0.01).any()
            assert problem.motion_is_free(first, last) == free
        assert problem.motion_is_free(START, START)
        problem.start[:] = 7.0

    with pytest.raises(mp.errors.PlanningError, match=r"the planner .*planner \(it returned None\)"):
        mp.seed_path(planar, START, GOAL, POST, seeding=mp.Seeding(planner=planner, time_limit=5.0), clearance=0.01)
    assert len(given) == 1


class Detour:
    """Returns the same waypoints each time."""

    def __init__(self, waypoints):
        self.waypoints = waypoints

    def __call__(self, problem):
        return self.waypoints


FAR = [0.0, 1e4, 0.0]


@pytest.mark.parametrize(
    ("waypoints", "message"),
    [
        (3.0, r"waypoints of the planner Detour: got 3.0; .*\(any, 3\)"),
        ("none", "waypoints of the planner Detour: got 'none'"),
        ([[0.0, 1.0], [1.0, 2.0]], r"shape \(any, 3\), not \(2, 2\)"),
        ([START, [0.0, np.nan, 0.0], GOAL], "waypoints of the planner Detour.*finite"),
        ([START], "1 waypoints'; allowed: 2 to 10000"),
        ([START, *[GOAL] * 10_000], "10001 waypoints"),
        ([START + 0.01, GOAL], r"Detour\[0\].*the start"),
        ([START, GOAL + 0.01], r"Detour\[1\].*the goal"),
        ([START, FAR, GOAL], "at most 1000 rad or m"),
    ],
)
def test_waypoints_that_are_refused(planar, waypoints, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        path_of(Detour(waypoints), planar)


def test_waypoints_outside_the_limits(ur5):
    start, goal = np.array([0.0, -1.5, 1.5, -1.5, -1.5, 0.0]), np.array([1.5, -1.5, 1.5, -1.5, -1.5, 0.0])
    middle = np.array([0.5, -1.5, 3.5, -1.5, -1.5, 0.0])
    wall = mp.Scene([mp.Box(size=(0.05, 0.05, 1.0), position=(0.4, 0.4, 0.5), name="wall")])
    with pytest.raises(mp.errors.InvalidInputError, match=r"Detour\[1\]: got 3.5; allowed: -3.1\d+ to 3.1\d+ for elbow_joint"):
        mp.seed_path(ur5, start, goal, wall, seeding=mp.Seeding(planner=Detour([start, middle, goal])))


@pytest.mark.slow
@settings(deadline=None, max_examples=30)
@given(middle=st.lists(st.tuples(*[st.floats(-4.0, 4.0)] * 3), max_size=4))
def test_whatever_it_returns_is_free_or_refused(middle):
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    try:
        path = path_of(Detour([START, *middle, GOAL]), arm)
    except mp.errors.PlanningError:
        return
    assert max(np.abs(path.start - START).max(), np.abs(path.goal - GOAL).max()) < 1e-12
    model = POST.collision_model(arm)
    assert not any(model._touches(q, 0.0) for q in path(path.fine_samples(0.02)))  # coal alone


def test_a_path_in_collision_names_the_bodies(planar):
    asked = []

    def straight(problem):
        asked.append(problem.step)
        return [problem.start, problem.goal]

    with pytest.raises(mp.errors.PlanningError, match=r"straight returned a path of 2 waypoints, but .*post .* at q = \["):
        path_of(straight, planar)
    assert len(asked) == 3 and asked[0] > asked[1] > asked[2]
    result = mp.plan(planar, START, GOAL, POST, seeding=mp.Seeding(planner=straight), throw=False)
    assert result.status is mp.Status.NO_PATH


def test_an_error_inside_names_the_planner(planar):
    def broken(problem):
        return 1 / 0

    with pytest.raises(mp.errors.InvalidInputError, match="broken'; allowed: .*it raised ZeroDivisionError") as caught:
        path_of(broken, planar)
    assert isinstance(caught.value.__cause__, ZeroDivisionError)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    with pytest.raises(mp.errors.InvalidInputError, match="raised InvalidInputError: q"):
        path_of(lambda problem: problem.is_free([0.0]), planar)


@pytest.mark.slow
def test_the_time_limit_ends_a_planner_that_asks_for_ever(planar):
    def endless(problem):
        while True:
            problem.is_free(problem.start)

    began = time.monotonic()
    with pytest.raises(mp.errors.PlanningError, match="endless in 0.5 s"):
        path_of(endless, planar, time_limit=0.5)
    assert time.monotonic() - began < 1.5


@pytest.mark.slow
def test_many_waypoints_take_little_time(planar):
    waypoints = path_of(tree_search, planar)(np.linspace(0.0, 1.0, 2000))
    began = time.monotonic()
    path = path_of(Detour(waypoints), planar)
    assert POST.path_clearance(planar, path).proven
    assert time.monotonic() - began < 5.0


@pytest.mark.parametrize("planner", [None, 3, mp.PlannerProblem, "RRTconnect"])
def test_what_is_no_planner(planner):
    with pytest.raises(mp.errors.InvalidInputError, match="planner"):
        mp.Seeding(planner=planner)


def test_it_keeps_no_constraints(planar):
    held = [mp.HeldJoints(["joint1"])]
    with pytest.raises(mp.errors.InvalidInputError, match="'auto': the other planners keep no constraints"):
        mp.seed_path(planar, START, [0.0, 1.0, 1.0], seeding=mp.Seeding(planner=tree_search), constraints=held)


@pytest.mark.slow
def test_plans_of_many_problems_are_found_again(planar, tmp_path):
    """The key of a stored result names the planner."""
    first = mp.Problem(robot=planar, start=START, goal=GOAL, scene=POST, seeding=mp.Seeding(planner=tree_search))
    for _ in range(2):
        assert [plan.status.ok for plan in mp.plan_many([first], folder=tmp_path)] == [True]
    assert len(list(tmp_path.glob("*.json"))) == 1
    detour = Detour(path_of(tree_search, planar)(np.linspace(0.0, 1.0, 50)))
    second = mp.Problem(robot=planar, start=START, goal=GOAL, scene=POST, seeding=mp.Seeding(planner=detour))
    list(mp.plan_many([second], folder=tmp_path))
    assert len(list(tmp_path.glob("*.json"))) == 2
