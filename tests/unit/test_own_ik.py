"""Inverse kinematics of the user: what it is asked, what its answers are checked for, and what uses them."""

import copy
import pickle

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.jobs.plan_many import robot_key
from manipplan.robots.arms import arm_of

UR5 = mp.load_robot("ur5")
Q = np.array([0.4, -1.2, 1.5, -1.0, 1.2, 0.3])


def of_ur5(pose):
    """The eight solutions of the UR5 as it is in the catalogue, each at one turn."""
    return mp.inverse_kinematics(UR5, pose, method="closed-form", turns=False).q


def nothing(pose):
    return None


def pose_of(robot, q):
    """By Pinocchio alone."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, np.asarray(q, dtype=float))
    return data.oMf[robot.model.getFrameId(robot.tool)].homogeneous


def assert_same_set(robot, own, wanted):
    assert len(own) == len(wanted) > 0
    for q in wanted.q:
        assert np.abs(own.q - q).max(axis=1).min() < 1e-7
    for q, k in zip(own.q, own.pose_index, strict=True):
        assert np.abs(pose_of(robot, q) - pose_of(robot, wanted.q[list(wanted.pose_index).index(k)])).max() < 1e-9


@pytest.mark.slow
def test_it_replaces_the_library_s_method():
    robot = UR5.with_inverse_kinematics(of_ur5, complete=True)
    pose = pose_of(UR5, Q)
    found = mp.inverse_kinematics(robot, pose)
    assert (found.method, found.complete, found.missing, found.parameter_names) == ("of_ur5", "exact", 0.0, ())
    assert_same_set(robot, found, mp.inverse_kinematics(UR5, pose))
    assert len(mp.inverse_kinematics(robot, pose, turns=False)) == len(of_ur5(pose))
    assert mp.inverse_kinematics(robot, pose, method="closed-form").method == "parallel"
    assert mp.inverse_kinematics(robot.with_inverse_kinematics(None), pose).method == "parallel"
    part = mp.inverse_kinematics(UR5.with_inverse_kinematics(of_ur5), pose)
    assert part.complete == "statistical" and np.isnan(part.missing)


def placements():
    values = st.tuples(*[st.floats(-3.0, 3.0)] * 6)
    return values.map(lambda x: pin.SE3(pin.rpy.rpyToMatrix(*x[:3]), np.array(x[3:]) / 3).homogeneous)


@pytest.mark.slow
@settings(deadline=None, max_examples=15)
@given(bases=st.tuples(placements(), placements()), tools=st.tuples(placements(), placements()), early=st.booleans())
def test_it_speaks_of_the_robot_as_it_was(bases, tools, early):
    """Base and tool frame change after, and before, the solver is given."""
    robot = UR5
    if early:
        robot = robot.at(bases[0]).with_tool(tools[0], name="first")
    then = robot
    robot = robot.with_inverse_kinematics(lambda pose: mp.inverse_kinematics(then, pose, method="closed-form").q)
    robot = robot.at(bases[1]).with_tool(tools[1], name="second")
    pose = pose_of(robot, Q)
    assert_same_set(robot, mp.inverse_kinematics(robot, pose), mp.inverse_kinematics(robot, pose, method="closed-form"))


@pytest.mark.slow
def test_it_stays_with_parts_and_limits_but_not_with_fewer_joints():
    robot = UR5.with_inverse_kinematics(of_ur5)
    held = robot.attach(mp.Box(size=(0.1, 0.1, 0.1), position=(0.0, 0.0, 0.1), name="part"))
    for each in (held, held.detach("part"), copy.deepcopy(robot), pickle.loads(pickle.dumps(robot))):
        assert mp.inverse_kinematics(each, pose_of(UR5, Q)).method == "of_ur5"
    narrow = robot.with_limits(lower=-np.pi, upper=np.pi)
    assert_same_set(
        narrow, *(mp.inverse_kinematics(each, pose_of(UR5, Q)) for each in (narrow, narrow.with_inverse_kinematics(None)))
    )
    both = mp.load_robot("baxter")
    with pytest.raises(mp.errors.InvalidInputError, match="an arm with one tool"):
        both.with_inverse_kinematics(nothing)
    panda = mp.load_robot("panda").with_inverse_kinematics(nothing)
    assert arm_of(panda, panda.tool, range(6), panda.neutral).own_ik is None


@pytest.mark.slow
def test_rounded_answers_are_refined():
    robot = UR5.with_inverse_kinematics(lambda pose: np.round(of_ur5(pose), 5))
    found = mp.inverse_kinematics(robot, pose_of(UR5, Q))
    assert_same_set(robot, found, mp.inverse_kinematics(UR5, pose_of(UR5, Q)))
    assert found.residual.max() <= 1e-10


def test_answers_outside_the_limits_are_left_out():
    robot = UR5.with_limits(lower=[-6.2, -3.0, 0.0, -6.2, -6.2, -6.2], upper=[6.2, 0.0, 3.0, 6.2, 6.2, 6.2])
    pose = pose_of(UR5, Q)
    found = mp.inverse_kinematics(robot.with_inverse_kinematics(of_ur5), pose)
    assert_same_set(robot, found, mp.inverse_kinematics(robot, pose))
    assert len(found) < len(mp.inverse_kinematics(UR5, pose))


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (Q, r"configurations of answering: .*shape \(any, 6\), not \(6,\)"),
        ([Q[:5]], r"shape \(any, 6\), not \(1, 5\)"),
        ([Q, np.full(6, np.inf)], "configurations of answering.*finite"),
        ([Q, Q[:3]], "configurations of answering"),
        ("none", "configurations of answering: got 'none'"),
        ([Q, Q + 0.01], r"configurations of answering\[1\].*it misses it by 0.0\d+ m or rad"),
    ],
)
def test_wrong_answers(answer, message):
    def answering(pose):
        return answer

    answering.__qualname__ = "answering"
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.inverse_kinematics(UR5.with_inverse_kinematics(answering), pose_of(UR5, Q))


def test_an_error_inside_names_the_solver():
    def broken(pose):
        raise KeyError("elbow")

    with pytest.raises(mp.errors.InvalidInputError, match="broken.*it raised KeyError: 'elbow'") as caught:
        mp.inverse_kinematics(UR5.with_inverse_kinematics(broken), np.eye(4))
    assert isinstance(caught.value.__cause__, KeyError)


@pytest.mark.parametrize("solver", [3, "closed-form", dict])
def test_what_is_no_solver(solver):
    with pytest.raises(mp.errors.InvalidInputError, match="solver"):
        UR5.with_inverse_kinematics(solver)


def test_joints_are_not_held_for_it():
    with pytest.raises(mp.errors.InvalidInputError, match="held.*nothing.*'newton' is the library's"):
        mp.inverse_kinematics(UR5.with_inverse_kinematics(nothing), pose_of(UR5, Q), held=["elbow_joint"])


@pytest.mark.slow
def test_pose_goals_are_what_it_returns():
    """Of eight solutions it returns one, which is the goal, though others are nearer."""
    pose = pose_of(UR5, Q)
    start = Q + [0.3, 0.2, -0.2, 0.1, 0.1, 0.2]
    only = max(of_ur5(pose), key=lambda q: np.abs(q - start).max())
    plan = mp.plan(UR5.with_inverse_kinematics(lambda pose: [only]), start, pose)
    off = plan.path.goal - only
    assert np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max() < 1e-6
    assert np.abs(mp.plan(UR5, start, pose).path.goal - only).max() > 1.0
    with pytest.raises(mp.errors.InvalidInputError, match="nothing returns no configuration inside the limits"):
        mp.plan(UR5.with_inverse_kinematics(nothing), start, pose)


@pytest.mark.slow
@pytest.mark.parametrize("task", [None, mp.Task.pointing([0, 0, 1])], ids=["pose", "pointing"])
def test_tool_paths_use_it(task):
    robot = UR5.with_inverse_kinematics(of_ur5)
    begin = pose_of(UR5, Q)
    end = begin.copy()
    end[2, 3] -= 0.1
    path = mp.CartesianPath.line(begin, end)
    own = mp.sample_layers(robot, path, 5, task=task, samples=8 if task else None)
    library = mp.sample_layers(UR5, path, 5, task=task, samples=8 if task else None)
    assert [len(m) for m in own.m] == [len(m) for m in library.m]
    assert mp.follow(robot, path, objective=mp.PathObjective(task=task), samples=16 if task else None).status.ok
    with pytest.raises(mp.errors.InvalidInputError, match="a pose for which nothing returns a configuration"):
        mp.sample_layers(UR5.with_inverse_kinematics(nothing), path, 5, task=task)


def test_a_planar_arm_and_a_redundant_one():
    planar = mp.planar_arm([1.0, 0.8, 0.6])
    q = np.array([0.3, 0.7, -0.9])

    def solver(pose):
        return [q] if np.abs(pose - pose_of(planar, q)).max() < 1e-9 else None

    found = mp.inverse_kinematics(planar.with_inverse_kinematics(solver), pose_of(planar, q), parameters=[0.0])
    assert len(found) == 1 and np.abs(found.q[0] - q).max() < 1e-9
    panda = mp.load_robot("panda")
    goal = panda.neutral + 0.1
    found = mp.inverse_kinematics(panda.with_inverse_kinematics(lambda pose: goal[None]), pose_of(panda, goal))
    assert np.abs(found.q - goal).max() < 1e-9


@pytest.mark.slow
def test_stored_results_name_it():
    robots = [UR5, UR5.with_inverse_kinematics(of_ur5), UR5.with_inverse_kinematics(of_ur5, complete=True)]
    robots.append(UR5.with_inverse_kinematics(nothing))
    assert len({robot_key(each) for each in robots}) == 4
    assert robot_key(robots[1]) == robot_key(UR5.with_inverse_kinematics(of_ur5))


@pytest.mark.slow
def test_a_path_does_not_leave_what_the_solver_returns():
    """From a given start, too, where steps along the path would lead on into postures that are left out."""
    library = mp.load_robot("ur5")

    def bent(pose):
        """Those with an elbow beyond 1.3 rad, or bent to the other side."""
        q = mp.inverse_kinematics(library, pose).q
        return q[(q[:, 2] > 1.3) | (q[:, 2] < 0)]

    arm = library.with_inverse_kinematics(bent, complete=True)
    first = library.kinematics().pose([0.3, -1.2, -1.4, -1.0, 1.3, 0.2])
    last = first.copy()
    last[:3, 3] += [0.0, 0.06, 0.03]
    path = mp.CartesianPath.through([first, last])
    solutions = mp.inverse_kinematics(arm, first).q
    start = solutions[(solutions[:, 2] > 1.3) & (np.abs(solutions) < 3.6).all(axis=1)][0]
    assert mp.follow(library, path, start=start, throw=False).status is mp.Status.FOLLOWED
    led = mp.follow(arm, path, start=start)
    elbow = led.trajectory(np.linspace(led.path_begin, led.trajectory.duration, 50))[:, 2]
    assert led.path_begin > 0 and ((elbow > 1.3).all() or (elbow < 0).all())
    program = mp.sequence(arm, start, [mp.MoveAlong(path)])
    begin = program.marks[0].path_begin
    elbow = program.trajectory(np.linspace(begin, program.trajectory.duration, 50))[:, 2]
    assert begin > 0 and ((elbow > 1.3).all() or (elbow < 0).all())
    begins = mp.follow(arm, path, throw=False)
    elbow = begins.path(np.linspace(0.0, 1.0, 50))[:, 2]
    assert begins.status is mp.Status.FOLLOWED and ((elbow > 1.3).all() or (elbow < 0).all())


@pytest.mark.slow
def test_rounded_answers_at_a_limit_are_not_lost(ur5):
    upper = np.array([0.5, 6.0, 6.0, 6.0, 6.0, 6.0])
    arm, q = ur5.with_limits(upper=upper, lower=-3.0), np.array([0.5, -1.0, 1.0, -1.0, -1.0, 0.0])
    pose = arm.kinematics().pose(q)
    exact = arm.with_inverse_kinematics(lambda pose: mp.inverse_kinematics(ur5, pose).q, complete=True)
    rough = arm.with_inverse_kinematics(lambda pose: mp.inverse_kinematics(ur5, pose).q + 1e-4, complete=True)
    expected, found = (mp.inverse_kinematics(each, pose).q for each in (exact, rough))
    np.testing.assert_allclose(found[np.lexsort(found.round(5).T)], expected[np.lexsort(expected.round(5).T)], atol=1e-7)
    assert (np.abs(found - q).max(axis=1) < 1e-6).any()
