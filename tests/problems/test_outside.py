"""The problems of others in benchmarks/outside: read whole, in the frame of our arms, and accepted where our arms are free."""

import sys
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import collision  # its folder is put on the path first
from outside import problems

#: From our tool frame to where the gripper of the data grasps, along the tool's z [m], and how close an object must be there [m].
GRASP = {"panda": (0.0, 0.08), "ur5": (0.16, 0.10)}
GRASPED = ("Can", "Cube", "Object")


@pytest.fixture(scope="module", params=["panda", "ur5"])
def arm(request):
    return request.param


def test_seven_sets_of_fifty_problems(arm):
    found = problems.load(arm)
    assert Counter(problem.set for problem in found) == dict.fromkeys(
        ("bookshelf_small", "bookshelf_tall", "bookshelf_thin", "box", "cage", "table_pick", "table_under_pick"), 50
    )
    assert {problem.number for problem in found} == set(range(1, 100, 2))
    assert {len(problem.start) for problem in found} == {len(problem.goal) for problem in found} == {problems.robot(arm).n}
    assert {len(problem.scene.obstacles) for problem in found} == {7, 8, 12, 15, 21}


def test_the_goal_holds_the_tool_at_an_object(arm):
    """The obstacles are in the frame of our arm: turned or moved elsewhere, no tool is near an object."""
    reach, close = GRASP[arm]
    kinematics = problems.robot(arm).kinematics(mp.Task.pose())
    gaps = []
    for problem in problems.load(arm):
        pose = kinematics.pose(problem.goal)
        tip = pose[:3, 3] + reach * pose[:3, 2]
        gaps.append(
            min(np.linalg.norm(tip - each.position) for each in problem.scene.obstacles if each.name.startswith(GRASPED))
        )
    assert np.mean(np.array(gaps) < close) > 0.7


def test_most_starts_and_goals_are_free_and_inside_the_limits(arm):
    """Those of the Panda that are not: the primitives of our links are larger than the meshes."""
    robot = problems.robot(arm)
    accepted = 0
    for problem in problems.load(arm):
        ends = np.array([problem.start, problem.goal])
        accepted += not problem.scene.in_collision(robot, ends).any() and (robot.limits.outside(ends) <= 0).all()
    assert accepted >= {"panda": 260, "ur5": 345}[arm]


def test_the_fingers_are_as_far_open_as_in_the_data():
    assert set(problems.robot("panda").locked.values()) == {0.065}


@pytest.mark.slow
def test_a_plan_among_points_ends_at_an_optimum():
    """Steps to the required clearance fail along the bumps of a cloud: margins are widened as far as an optimum allows."""
    robot = problems.robot("panda")
    [problem] = [each for each in problems.load("panda") if (each.set, each.number) == ("bookshelf_thin", 3)]
    plan = mp.plan(robot, problem.start, problem.goal, collision.as_cloud(problem.scene), seeding=mp.Seeding(time_limit=60.0))
    assert plan.status is mp.Status.OPTIMAL
    assert plan.result.certificate.active_clearance <= 1e-4
