"""connect-star: our own search, which goes on to lower the cost of its path."""

import numpy as np
import pytest

import manipplan as mp
from manipplan.seeds import connect
from manipplan.seeds.ompl import motion_cost
from manipplan.seeds.seed import LEVELS
from manipplan.support.deadline import work_time

START, GOAL = [0, 1.5, -2], [np.pi, -2, 2]
POST = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
WALL = mp.Scene([mp.Box(size=(0.2, 0.6, 0.6), position=(0.5, 0.0, 0.4), name="wall")])
ENDS = {"planar": (START, GOAL, POST), "ur5": ([-0.9, -1.0, 1.0, -1, -1.2, 0], [0.9, -1.0, 1.0, -1, -1.2, 0], WALL)}
OBJECTIVES = {
    "length": None,
    "g": mp.PathObjective(power=2),
    "weighted": mp.PathObjective(power=1.5, metric=[4.0, 1.0, 0.25]),
}


def found(robot, scene, ends, objective, checks, seed=0):
    """A path of connect-star, and its cost."""
    seeding = mp.Seeding(planner="connect-star", seed=seed, time_limit=60.0)
    path = mp.seed_path(robot, *ends, scene, seeding=seeding, objective=objective, checks=checks)
    return path, path.length if objective is None else objective.integral(robot).cost(path).g


@pytest.mark.parametrize("name", OBJECTIVES)
def test_the_cost_is_at_most_that_of_the_first_path_and_falls_with_more_checks(planar, name):
    objective = OBJECTIVES[name]
    first = mp.seed_path(planar, START, GOAL, POST)
    cost = first.length if objective is None else objective.integral(planar).cost(first).g
    costs = [found(planar, POST, (START, GOAL), objective, checks)[1] for checks in (3000, 10_000, 40_000)]
    assert costs[0] <= 1.001 * cost  # rounded otherwise
    assert costs[2] <= 1.001 * costs[1] <= 1.002 * costs[0]
    assert costs[2] < (0.999 if objective is None else 0.9) * cost


@pytest.mark.parametrize("arm", ENDS)
def test_the_path_is_free_and_depends_on_the_seed_alone(request, arm):
    robot, (start, goal, scene) = request.getfixturevalue(arm), ENDS[arm]
    path, _ = found(robot, scene, (start, goal), mp.PathObjective(), 8000)
    assert scene.path_clearance(robot, path).proven
    again, _ = found(robot, scene, (start, goal), mp.PathObjective(), 8000)
    np.testing.assert_array_equal(again.control, path.control)
    other, _ = found(robot, scene, (start, goal), mp.PathObjective(), 8000, seed=1)
    assert other.control.shape != path.control.shape or np.abs(other.control - path.control).max() > 1e-3


def test_it_beats_a_planner_of_ompl_with_as_many_checks(ur5):
    start, goal, scene = ENDS["ur5"]
    objective = mp.PathObjective()
    _, g = found(ur5, scene, (start, goal), objective, 10_000)
    other = mp.seed_path(ur5, start, goal, scene, seeding=mp.Seeding(planner="BITstar"), objective=objective, checks=10_000)
    assert g < objective.integral(ur5).cost(other).g


def test_an_aspect_is_kept(ur5):
    start, goal, scene = ENDS["ur5"]
    seeding = mp.Seeding(planner="connect-star")
    path = mp.seed_path(ur5, start, goal, scene, seeding=seeding, objective=mp.PathObjective(), same_aspect=True, checks=10_000)
    signs = np.sign([np.linalg.det(ur5.kinematics().jacobian(q)) for q in path(np.linspace(0.0, 1.0, 2000))])
    assert (signs == signs[0]).all()


def test_a_cost_is_that_of_the_planners_of_ompl(planar, ur5, rng):
    """The same integral of a motion, by NumPy."""
    cost = connect._functions()["edge_cost"]
    for robot, objective in ((planar, OBJECTIVES["weighted"]), (planar, OBJECTIVES["g"]), (ur5, mp.PathObjective())):
        start, goal = robot.neutral, robot.neutral + 0.5
        task = motions_task(robot, start, goal)
        lowering = connect.StarSearch(task, LEVELS, objective.integral(robot))
        lowering.prepare()
        for _ in range(5):
            first, second = robot.neutral + rng.uniform(-1, 1, (2, robot.n))
            expected = motion_cost(objective.integral(robot), first, second)
            assert cost(lowering.star_at, first.ctypes.data, second.ctypes.data) == pytest.approx(expected, rel=1e-9)


def motions_task(robot, start, goal):
    model = mp.Scene().collision_model(robot)
    distances = tuple(model.least_distance(q[None])[0] for q in (start, goal))
    given = {"seed": 0, "clearance": 0.0, "signs": None, "most_crossings": None, "checks": None, "distances": distances}
    return connect.SeedTask(model=model, start=start, goal=goal, deadline=work_time() + 10.0, **given)


def test_too_few_checks_are_told(planar):
    with pytest.raises(mp.errors.PlanningError, match=r"by connect-star with 5 checks; allow more of them \(checks\)"):
        found(planar, POST, (START, GOAL), None, 5)


def test_with_too_many_joints_it_is_refused(planar, monkeypatch):
    monkeypatch.setattr(connect, "MOST_JOINTS", 1)
    with pytest.raises(mp.errors.InvalidInputError, match=r"seeding\.planner: got 'connect-star'; allowed: another one"):
        found(planar, POST, (START, GOAL), None, 1000)
