"""Lead-ins: the aspect of the start before a crossing, true bounds, of full turns the nearest; of follow and of programs."""

import re

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp

#: A usual posture of the arms of Universal Robots [rad].
READY = np.array([0.0, -1.4, 1.6, -1.77, -1.57, 0.0])
#: How far lines are from the base [m].
REACH = {"ur3": 0.28, "ur5": 0.5, "ur10": 0.7}


def down(x, y, z):
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = x, y, z
    return pose


def line(name, side=1.0, height=0.3):
    reach = REACH[name]
    return mp.CartesianPath.line(down(reach, -0.6 * side * reach, height), down(reach, 0.6 * side * reach, height))


def jacobians(robot, q):
    """By Pinocchio: raw rows, of the position and the whole pose."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    return np.array([pin.computeFrameJacobian(robot.model, data, each, frame, pin.LOCAL_WORLD_ALIGNED).copy() for each in q])


def crossings(robot, motion):
    """How often det J changes its sign on a motion, and its smallest size."""
    values = np.linalg.det(jacobians(robot, motion(np.linspace(0.0, motion.duration, 3000))))
    return int(np.count_nonzero(np.diff(values >= 0))), float(np.abs(values).min())


def entered(robot, path, start, way):
    """The motion, and when it comes onto the path."""
    if way == "follow":
        plan = mp.follow(robot, path, start=start)
        return plan.trajectory, plan.path_begin, plan.report.crossing_note
    program = mp.sequence(robot, start, [mp.MoveAlong(path)])
    return program.trajectory, program.marks[0].path_begin, program.parts[0].report.crossing_note


@pytest.mark.slow
@pytest.mark.parametrize("way", ["follow", "MoveAlong"])
@pytest.mark.parametrize("name", list(REACH))
def test_the_seam_of_the_review(name, way):
    """Each of these went through three singularities, and turned a joint by up to 7 rad."""
    robot = mp.load_robot(name)
    motion, begin, note = entered(robot, line(name), READY, way)
    count, least = crossings(robot, motion)
    assert count == 0 and note == "" and least > 1e-4
    assert np.ptp(motion(np.linspace(0.0, begin, 500)), axis=0).max() < np.pi


@pytest.mark.slow
@settings(max_examples=8, deadline=None)
@given(
    turns=st.lists(st.sampled_from([-1, 0, 1]), min_size=6, max_size=6),
    away=st.lists(st.floats(-0.3, 0.3), min_size=6, max_size=6),
    side=st.sampled_from([-1.0, 1.0]),
    height=st.floats(0.15, 0.4),
    way=st.sampled_from(["follow", "MoveAlong"]),
)
def test_the_same_aspect_and_the_nearest_turn(turns, away, side, height, way):
    """From postures that are full turns off: the elbow and the wrist keep their signs, and no joint turns needlessly."""
    robot = mp.load_robot("ur5")
    start = READY + 2 * np.pi * np.array(turns) + away
    start += 2 * np.pi * ((start < robot.limits.lower) * 1.0 - (start > robot.limits.upper) * 1.0)
    path = line("ur5", side, height)
    motion, begin, note = entered(robot, path, start, way)
    assert crossings(robot, motion)[0] == 0 and note == ""
    lead, rest = (motion(np.linspace(*span, 500)) for span in ((0.0, begin), (begin, motion.duration)))
    for joint in range(6):
        turned = rest[:, joint, None] + 2 * np.pi * np.arange(-2, 3)
        inside = (turned.min(axis=0) >= robot.limits.lower[joint]) & (turned.max(axis=0) <= robot.limits.upper[joint])
        needed = np.abs(turned[0, inside] - start[joint]).min()
        assert np.ptp(lead[:, joint]) <= needed + np.pi


@pytest.mark.slow
def test_bounds_are_those_of_start_and_path():
    robot = mp.load_robot("ur5")
    path = line("ur5")
    plan = mp.follow(robot, path, start=READY)
    m = robot.kinematics().manipulability
    (chosen,) = [each for each in plan.candidates if each.chosen]
    assert chosen.least_crossings == 0
    assert 0.99 * chosen.bound <= plan.report.min_manipulability <= chosen.bound * (1 + 1e-9) <= m(READY)
    assert all(each.bound == 0.0 for each in plan.candidates if each.least_crossings)
    # each candidate, planned by itself, keeps no more than its bound
    for each in plan.candidates[:4]:
        alone = mp.plan(robot, READY, each.q)
        assert alone.report.min_manipulability <= m(READY) * (1 + 1e-9)
        assert min(alone.report.min_manipulability, mp.follow(robot, path, start=each.q).report.min_manipulability) <= max(
            each.bound * (1 + 1e-3), 1e-9
        )


@pytest.mark.slow
@pytest.mark.parametrize("way", ["follow", "MoveAlong"])
def test_a_crossing_that_cannot_be_avoided_is_reported(way):
    """In the aspect of the start the shoulder would have to be lowered further than its limit allows."""
    whole = mp.load_robot("ur5")
    lower, upper = whole.limits.lower.copy(), whole.limits.upper.copy()
    lower[1], upper[1] = -2.5, 0.0
    robot = whole.with_limits(lower=lower, upper=upper)
    start = np.array([0.0, -1.0, -1.2, -0.9, -1.57, 0.0])
    motion, begin, note = entered(robot, line("ur5"), start, way)
    count, _ = crossings(robot, motion)
    assert count == 1 and begin > 0
    assert re.match(r"crosses an? \w+ singularity at s = [\d.]+; this cannot be avoided", note)
    if way == "follow":
        (chosen,) = [each for each in mp.follow(robot, line("ur5"), start=start).candidates if each.chosen]
        assert chosen.least_crossings == 1 and chosen.bound == 0.0
        assert "in another aspect than the start, since no motion along the path begins in the same" in chosen.status
