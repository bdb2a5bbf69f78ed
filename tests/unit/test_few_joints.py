"""Arms of one to four joints are planned without a task: the default one is cut to what the joints span, or does not count."""

import re

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
#: Joints (type, axis, origin) and the tool's origin, of arms with a task that is cut, and its rows in the world or the tool.
CUT = {
    "one": ([("revolute", Z, (0, 0, 0.3))], (0.3, 0, 0), "tool", [Y]),
    "slide": ([("prismatic", X, (0, 0, 0.3))], (0.1, 0, 0), "world", [X]),
    "gantry_xy": ([("prismatic", X, (0, 0, 0.3)), ("prismatic", Y, (0, 0, 0.3))], (0, 0, 0.1), "world", [X, Y]),
    "two_in_a_plane": ([("revolute", Z, (0, 0, 0.3)), ("revolute", Z, (0.4, 0, 0))], (0.3, 0, 0), "world", [X, Y]),
    "three_in_a_plane": (
        [("revolute", Y, (0, 0, 0.3)), ("revolute", Y, (0.4, 0, 0)), ("revolute", Y, (0.3, 0, 0))],
        (0.2, 0, 0),
        "world",
        [X, Z],
    ),
    "pan_tilt": ([("revolute", Z, (0, 0, 0.3)), ("revolute", Y, (0, 0, 0.2))], (0.3, 0, 0), "tool", [Y, Z]),
    "crane": ([("revolute", Z, (0, 0, 0.3)), ("prismatic", X, (0.2, 0, 0.1))], (0.3, 0, 0), "world", [X, Y]),
}
#: Arms whose position Jacobian has dependent rows everywhere, in no fixed directions.
UNCOUNTED = {
    "positioner": ([("revolute", Y, (0, 0, 0.3)), ("revolute", Z, (0, 0, 0.2))], (0, 0, 0.1)),
    "camera": ([("revolute", Z, (0, 0, 0.3)), ("revolute", Y, (0, 0, 0.2))], (0, 0, 0)),
    "spindle": ([("revolute", Z, (0, 0, 0.3))], (0, 0, 0.1)),
    "skew": ([("revolute", Z, (0, 0, 0.3)), ("revolute", (0.6, 0.8, 0), (0.1, 0.2, 0.1))], (0.2, 0.1, 0.3)),
    "tool_on_the_last_axis": (
        [("revolute", Z, (0, 0, 0.3)), ("revolute", Y, (0, 0, 0.2)), ("revolute", Y, (0, 0, 0.3))],
        (0, 0, 0),
    ),
}
#: Arms with the usual task.
USUAL = {
    "gantry": ([("prismatic", X, (0, 0, 0.3)), ("prismatic", Y, (0, 0, 0)), ("prismatic", Z, (0, 0, 0))], (0, 0, 0.1)),
    "scara": (
        [
            ("revolute", Z, (0, 0, 0.3)),
            ("revolute", Z, (0.4, 0, 0)),
            ("prismatic", Z, (0.3, 0, 0)),
            ("revolute", Z, (0, 0, -0.1)),
        ],
        (0, 0, -0.1),
    ),
}
ARMS = {**{name: each[:2] for name, each in CUT.items()}, **UNCOUNTED, **USUAL}


@pytest.fixture
def arm(tmp_path):
    """The arm of that name."""

    def make(name):
        joints, tool = ARMS[name]
        body = '<collision><geometry><box size="0.05 0.05 0.05"/></geometry></collision>'
        text = f'<link name="l0">{body}</link>'
        for k, (kind, axis, origin) in enumerate(joints, start=1):
            text += (
                f'<link name="l{k}">{body}</link><joint name="j{k}" type="{kind}"><parent link="l{k - 1}"/><child link="l{k}"/>'
            )
            text += f'<origin xyz="{" ".join(map(str, origin))}"/><axis xyz="{" ".join(map(str, axis))}"/>'
            text += '<limit lower="-1.5" upper="1.5" velocity="2" effort="1"/></joint>'
        text += f'<link name="tool"/><joint name="end" type="fixed"><parent link="l{len(joints)}"/><child link="tool"/>'
        text += f'<origin xyz="{" ".join(map(str, tool))}"/></joint>'
        file = tmp_path / f"{name}.urdf"
        file.write_text(f'<robot name="{name}">{text}</robot>')
        return mp.load_robot(file)

    return make


def jacobian(robot, q, frame):
    """The linear rows (3, n) along the axes of the world or the tool, by Pinocchio."""
    axes = pin.ReferenceFrame.LOCAL if frame == "tool" else pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    data, index = robot.model.createData(), robot.model.getFrameId(robot.tool)
    return pin.computeFrameJacobian(robot.model, data, np.asarray(q), index, axes).reshape(6, -1)[:3]


def ends(robot):
    return np.linspace(-0.5, -0.4, robot.n), np.linspace(0.9, 0.7, robot.n)


@pytest.mark.parametrize("name", CUT)
def test_the_default_task_is_what_the_joints_span(arm, name):
    robot, (_, _, frame, rows) = arm(name), CUT[name]
    task = robot.default_task
    assert task.name == f"position in {len(rows)} direction{'s' * (len(rows) > 1)}"
    used = task.tool_rows if frame == "tool" else task.world_rows
    assert task.rows == len(used) == len(rows)
    np.testing.assert_allclose(np.array(used), np.hstack([rows, np.zeros((len(rows), 3))]), atol=1e-9)


@pytest.mark.parametrize("name", CUT)
def test_its_manipulability_is_that_of_the_motions_that_the_joints_make(arm, name):
    """The product of the singular values that are not zero, of the whole position Jacobian."""
    robot, (_, _, frame, rows) = arm(name), CUT[name]
    for q in robot.random_configuration(np.random.default_rng(1), size=20):
        values = np.linalg.svd(jacobian(robot, q, frame), compute_uv=False)[: len(rows)]
        assert robot.kinematics().manipulability(q) == pytest.approx(np.prod(values), abs=1e-12)


@pytest.mark.parametrize("name", USUAL)
def test_arms_that_span_space_have_the_usual_task(arm, name):
    assert arm(name).default_task == mp.Task.position()


@pytest.mark.parametrize("name", [each if each == "pan_tilt" else pytest.param(each, marks=pytest.mark.slow) for each in ARMS])
def test_plan_optimize_retime_check_and_save(arm, name, tmp_path):
    """Reproduction 10 in reviews of robots, and its kind: no task is named."""
    robot = arm(name)
    start, goal = ends(robot)
    plan = mp.plan(robot, start, goal)
    assert plan.status.ok
    assert plan.report.passed
    assert mp.check(robot, plan.trajectory, start=start, goal=goal).passed
    np.testing.assert_allclose(plan.trajectory.q[[0, -1]], [start, goal], atol=1e-9)
    result = mp.optimize_path(robot, start, goal)
    assert mp.retime(result.path, robot).duration > 0
    plan.save(tmp_path / "plan")
    again = mp.Plan.load(tmp_path / "plan")
    assert (again.status, again.report.g) == (plan.status, plan.report.g)
    assert robot.kinematics().pose(start).shape == (4, 4)
    assert robot.kinematics().jacobian(start).shape == (robot.default_task.rows, robot.n)


@pytest.mark.parametrize("name", UNCOUNTED)
def test_where_manipulability_is_identically_zero_the_shortest_path_is_planned_and_said_so(arm, name):
    robot = arm(name)
    start, goal = ends(robot)
    plan = mp.plan(robot, start, goal)
    assert plan.status is mp.Status.SHORTEST
    assert "zero in every configuration" in plan.status.value
    assert plan.report.g == pytest.approx(np.linalg.norm(goal - start), rel=1e-9)
    assert plan.report.measure == "constant"
    assert plan.report.crossing_note == ""
    assert "minimum m    does not count" in str(plan.report)
    assert "does not count" in str(plan.result.certificate)
    assert "does not count" in str(mp.check(robot, plan.trajectory))
    assert "minimum m" not in plan.report.summary


def test_the_shortest_path_goes_around_an_obstacle(arm):
    robot = arm("positioner")
    scene = mp.Scene([mp.Box(size=(0.05, 0.05, 0.05), position=(0.2, 0.0, 0.3))])
    start, goal = np.array([0.0, -1.0]), np.array([1.0, 1.0])
    plan = mp.plan(robot, start, goal, scene)
    assert plan.status.ok
    assert plan.report.collision_free


@pytest.mark.slow
@pytest.mark.parametrize("name", ["gantry_xy", "positioner", "one", "pan_tilt"])
def test_recordings_sequences_and_pose_goals_of_such_arms(arm, name):
    robot = arm(name)
    start, goal = ends(robot)
    plan = mp.plan(robot, start, goal)
    improved = mp.improve(robot, plan.trajectory, duration=1.2 * plan.trajectory.duration)
    assert improved.report.passed
    program = mp.sequence(robot, start, [mp.MoveTo(goal), mp.MoveTo(start)])
    assert program.passed
    assert all(mp.check(robot, each.trajectory).passed for each in program.parts)
    pose = robot.kinematics().pose(goal)
    found = mp.plan(robot, start, pose)
    np.testing.assert_allclose(robot.kinematics().pose(found.trajectory.q[-1]), pose, atol=1e-6)


@pytest.mark.slow
def test_improve_with_a_task_of_two_directions(arm):
    robot = arm("gantry_xy")
    plan = mp.plan(robot, *ends(robot))
    objective = mp.PathObjective(task=mp.Task.planar())
    improved = mp.improve(robot, plan.trajectory, duration=1.2 * plan.trajectory.duration, objective=objective)
    assert improved.report.passed


def test_a_task_of_more_rows_than_joints_is_refused_with_what_works(arm):
    robot = arm("pan_tilt")
    with pytest.raises(mp.errors.InvalidInputError, match=r"at most 2 rows;.*leave task out.*measure=\"constant\""):
        mp.plan(robot, *ends(robot), objective=mp.PathObjective(task=mp.Task.position()))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["pan_tilt", "crane"])
def test_a_task_in_the_tool_is_refused_with_one_that_a_path_can_have(arm, name):
    robot = arm(name)
    start, goal = (robot.kinematics().pose(q) for q in ends(robot))
    path, task = mp.CartesianPath.line(start, goal), mp.Task.custom([[0, 1, 0, 0, 0, 0]], frame="tool", name="y")
    with pytest.raises(mp.errors.InvalidInputError, match=r"task: got 'y'; allowed: .*as of Task\.custom\(") as told:
        mp.follow(robot, path, objective=mp.PathObjective(task=task))
    example = eval(re.search(r"Task\.custom\(.*?'x'\)", str(told.value))[0], {"Task": mp.Task})
    assert mp.follow(robot, path, objective=mp.PathObjective(task=example)).report.passed


def test_the_shortest_path_can_be_asked_for(arm):
    robot = arm("scara")
    start, goal = ends(robot)
    result = mp.optimize_path(robot, start, goal, objective=mp.PathObjective(measure="constant"))
    assert result.status is mp.Status.SHORTEST
    assert result.g == pytest.approx(np.linalg.norm(goal - start), rel=1e-9)
