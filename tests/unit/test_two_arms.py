"""Robots with several tools: kinematics, collisions between the arms, goals of both tools, and an object that both carry."""

from dataclasses import replace

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from coal_oracle import by_coal
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.collision.path_clearance import body_motion
from manipplan.goals.goal import goals_from_yaml
from manipplan.goals.two_arms import reaching_tools
from manipplan.optimize.clearance import ClearanceRows, row_functions

TOOLS = ("left_gripper", "right_gripper")
TABLE = mp.Box(size=(0.7, 1.6, 0.05), position=(0.85, 0.0, -0.2), name="table")


@pytest.fixture(scope="module")
def baxter():
    return mp.load_robot("baxter")


@pytest.fixture(scope="module")
def scene():
    return mp.Scene([TABLE])


def down(x, y, z, turn=0.0):
    """A pose of a hand that looks down."""
    pose = np.eye(4)
    pose[:3, :3] = Rotation.from_euler("ZX", [turn, np.pi]).as_matrix()
    pose[:3, 3] = x, y, z
    return pose


def slopes(function, q, step=1e-6):
    """Central differences of a function of q, the last axis of the result."""
    return np.stack([(function(q + step * e) - function(q - step * e)) / (2 * step) for e in np.eye(len(q))], axis=-1)


def place(robot, frame, q):
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    return data.oMf[robot.model.getFrameId(frame)].homogeneous


@pytest.mark.slow
@pytest.mark.parametrize(("name", "joints", "shared"), [("baxter", 14, 0), ("tiago_dual", 15, 1), ("talos", 16, 2)])
def test_robots_with_both_arms(name, joints, shared):
    robot = mp.load_robot(name)
    assert robot.n == joints
    assert len(robot.tools) == 2
    left, right = (set(robot.joints_of(tool)) for tool in robot.tools)
    assert len(left & right) == shared
    assert left | right == set(range(joints))
    assert not mp.Scene().in_collision(robot, robot.neutral)
    q = robot.random_configuration(np.random.default_rng(0))
    for tool in robot.tools:
        arm = robot.arm(tool, robot.neutral)
        np.testing.assert_allclose(arm.kinematics().pose(q[list(robot.joints_of(tool))]), place(robot, tool, q), atol=1e-12)


def test_one_tool_is_its_own_arm():
    panda = mp.load_robot("panda")
    assert panda.tools == (panda.tool,)
    assert panda.arm(panda.tool) is panda


@pytest.mark.parametrize(
    ("tool", "message"),
    [
        (("left_gripper", "right_griper"), "right_gripper"),
        (("left_gripper", "left_gripper"), "each tool frame once"),
        (("left_gripper", "left_wrist"), "tools of different arms"),
        ((), "at least one frame"),
    ],
)
def test_wrong_tools(tool, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.load_robot("baxter", tool=tool)


def test_an_unknown_arm(baxter):
    with pytest.raises(mp.errors.UnknownNameError, match="left_gripper"):
        baxter.arm("left_griper")


def test_tools_and_parts_of_either_hand(baxter):
    pose = np.eye(4)
    pose[2, 3] = 0.1
    changed = baxter.with_tool(pose, name="tip", tool="right_gripper").attach(mp.Sphere(radius=0.02, name="ball"), tool="tip")
    assert changed.tools == ("left_gripper", "tip")
    np.testing.assert_allclose(place(changed, "tip", baxter.neutral), place(baxter, "right_gripper", baxter.neutral) @ pose)
    [ball] = [item for item in changed.geometry.geometryObjects if item.name == "ball"]
    assert ball.parentJoint - 1 == baxter.joints_of("right_gripper")[-1]
    with pytest.raises(mp.errors.UnknownNameError, match="tip"):
        changed.attach(mp.Sphere(radius=0.02), tool="tap")


@pytest.mark.slow
def test_the_smooth_minimum_is_near_the_minimum_of_both_arms(baxter):
    q = baxter.random_configuration(np.random.default_rng(1), size=200)
    m = np.array([baxter.arm(tool).kinematics().manipulability(q[:, list(baxter.joints_of(tool))]) for tool in TOOLS])
    found = baxter.kinematics().manipulability(q)
    assert (found <= m.min(axis=0) * (1 + 1e-12)).all()
    assert (found >= m.min(axis=0) * 2 ** (-1 / 16) * (1 - 1e-12)).all()


@pytest.mark.slow
def test_weights_give_the_mean(baxter):
    q = baxter.random_configuration(np.random.default_rng(1), size=20)
    m = [baxter.arm(tool).kinematics().manipulability(q[:, list(baxter.joints_of(tool))]) for tool in TOOLS]
    measure = mp.measures.OverTools(weights={"left_gripper": 1.0, "right_gripper": 3.0})
    np.testing.assert_allclose(baxter.kinematics(measure=measure).manipulability(q), (m[0] + 3 * m[1]) / 4, rtol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(
    "options",
    [
        {},
        {"measure": mp.measures.OverTools(weights={"left_gripper": 1.0, "right_gripper": 2.0})},
        {"task": mp.Task.pose(relative_to="right_gripper")},
        {"task": mp.Task.position(relative_to="torso")},
    ],
    ids=["minimum", "weights", "relative", "relative to the torso"],
)
def test_gradient_and_hessian(baxter, options):
    kinematics = baxter.kinematics(compiled=False, **options)
    q = baxter.random_configuration(np.random.default_rng(2))
    gradient, hessian = kinematics.gradient(q), kinematics.hessian(q)
    np.testing.assert_allclose(gradient, slopes(kinematics.manipulability, q), atol=1e-6 * np.abs(gradient).max())
    np.testing.assert_allclose(hessian, slopes(kinematics.gradient, q), atol=1e-6 * np.abs(hessian).max())


def test_one_singular_arm_makes_the_minimum_zero_and_decides_its_slope():
    value, first, second = mp.measures.OverTools()._combine(["left", "right"], [ca.SX(0.0), ca.SX(0.5)])
    assert float(value) == 0.0
    assert [float(each) for each in first] == pytest.approx([1.0, 0.0])
    assert np.isfinite([[float(each) for each in row] for row in second]).all()


def test_the_pose_and_jacobian_relative_to_the_other_tool(baxter):
    kinematics = baxter.kinematics(mp.Task.pose(length=1.0, relative_to="right_gripper"), compiled=False)
    q = baxter.random_configuration(np.random.default_rng(3))
    seen = np.linalg.inv(place(baxter, "right_gripper", q)) @ place(baxter, "left_gripper", q)
    np.testing.assert_allclose(kinematics.pose(q), seen, atol=1e-12)
    changes = slopes(kinematics.pose, q)
    np.testing.assert_allclose(kinematics.jacobian(q)[:3], changes[:3, 3], atol=1e-8)
    spin = np.einsum("ijk,lj->ilk", changes[:3, :3], seen[:3, :3])
    np.testing.assert_allclose(kinematics.jacobian(q)[3:], [spin[2, 1], spin[0, 2], spin[1, 0]], atol=1e-8)


def test_a_frame_before_the_arm_changes_nothing_but_the_axes():
    panda = mp.load_robot("panda")
    q = panda.random_configuration(np.random.default_rng(0), size=5)
    found = panda.kinematics(mp.Task.pose(relative_to="panda_link0")).manipulability(q)
    np.testing.assert_allclose(found, panda.kinematics().manipulability(q), rtol=1e-9)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"task": mp.Task.pose(relative_to="right_griper")}, "right_gripper"),
        ({"task": mp.Task.pose(relative_to="torso"), "measure": mp.measures.OverTools()}, "one motion"),
        ({"task": mp.Task.pose(relative_to="left_gripper")}, "can move against, such as right_gripper"),
        ({"task": mp.Task.position(relative_to="left_wrist")}, "can move against, such as right_gripper"),
        ({"measure": mp.measures.OverTools(weights={"left_gripper": 1.0})}, "right_gripper has none"),
        ({"measure": mp.measures.OverTools(weights={"left_gripper": 1.0, "rigth_gripper": 1.0})}, "right_gripper"),
        ({"measure": "log_det"}, "at least 0 and better when larger"),
    ],
)
def test_wrong_tasks_and_measures(baxter, options, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        baxter.kinematics(**options)


@pytest.mark.parametrize(
    "weights",
    [
        {"left_gripper": 0.0},
        {"left_gripper": -1.0},
        {"left_gripper": np.nan},
        {"left_gripper": "large"},
        {"left_gripper": True},
        {1: 2.0},
        {},
        2.0,
        [1, 2],
        ["left_gripper", 1.0],
        [("left_gripper", 1.0), ("left_gripper", 2.0)],
        "ab",
    ],
)
def test_weights_are_positive(weights):
    with pytest.raises(mp.errors.InvalidInputError, match="weights"):
        mp.measures.OverTools(weights=weights)


def test_distances_between_the_arms_and_their_gradients(baxter, scene):
    model = scene.collision_model(baxter)
    rng, slow = np.random.default_rng(4), by_coal(model)
    for q in baxter.random_configuration(rng, size=3):
        ours, coal = model.distances(q), slow.distances(q)
        apart = (ours > 1e-3) & (coal > 1e-3)
        np.testing.assert_allclose(ours[apart], coal[apart], atol=1e-6)
        pairs = np.flatnonzero(apart)[rng.integers(0, apart.sum(), 40)]
        found = model.witnesses(np.tile(q, (len(pairs), 1)), pairs).gradients
        wanted = slopes(lambda q, pairs=pairs: model.pair_distances(np.tile(q, (len(pairs), 1)), pairs), q)
        assert np.median(np.abs(found - wanted).max(axis=1)) < 1e-6


def test_bounds_on_the_motion_of_arms_towards_each_other(baxter, scene):
    model = scene.collision_model(baxter)
    bounds, pairs, rng = body_motion(model), np.arange(len(model.pair_names)), np.random.default_rng(5)
    rows = np.zeros(len(pairs), dtype=int)
    for q in baxter.random_configuration(rng, size=5):
        change = rng.uniform(0, 0.3, baxter.n)
        found = bounds.motion(q[None], change[None], rows, pairs)
        np.testing.assert_allclose(found, bounds._motion_by_numpy(q[None], change[None], rows, pairs), atol=1e-7)
        moved = q + change * rng.choice([-1, 1], size=(20, baxter.n))
        before, after = model.distances(q), model.distance_rows(moved).min(axis=0)
        assert (found >= before - after - 1e-6)[before > 0].all()


def test_clearance_rows_between_the_arms(baxter):
    value, gradient, hessian = row_functions(baxter.kinematics(compiled=False)).functions
    rng = np.random.default_rng(6)
    for carrier, other in ((7, 14), (14, 7), (3, 10), (12, 0), (9, 12)):
        normal = rng.normal(size=3)
        normal /= np.linalg.norm(normal)
        row = ClearanceRows.of(baxter.n, np.zeros(1), carrier, rng.normal(size=3), other, normal, 0.1, 0.01)
        column, q = row.columns[0], baxter.random_configuration(rng)
        slope = np.array(gradient(q, column)).ravel()
        np.testing.assert_allclose(slopes(lambda q, c=column: float(value(q, c)), q), slope, atol=1e-7)
        bends = slopes(lambda q, c=column: np.array(gradient(q, c)).ravel(), q)
        np.testing.assert_allclose(bends, np.array(hessian(q, column)), atol=1e-7)


def test_forearms_are_checked_though_the_srdf_disables_them(baxter):
    alone = mp.load_robot("baxter_left")
    pair = frozenset(("left_upper_forearm_visual", "right_upper_forearm_visual"))
    assert pair in alone.disabled_pairs
    assert pair not in baxter.disabled_pairs
    assert frozenset(("left_upper_elbow", "left_lower_elbow")) in baxter.disabled_pairs


@pytest.fixture(scope="module")
def swapped(baxter, scene):
    """A plan in which both hands go over the table, one of them to the other's side."""
    goal = {"left_gripper": down(0.65, -0.05, 0.2), "right_gripper": mp.PoseGoal(down(0.75, -0.25, 0.0), free_axis=(0, 0, 1))}
    return goal, mp.plan(baxter, baxter.neutral, goal, scene)


@pytest.mark.slow
def test_both_hands_reach_their_poses(baxter, scene, swapped):
    goal, plan = swapped
    q = plan.trajectory.q[-1]
    np.testing.assert_allclose(place(baxter, "left_gripper", q), goal["left_gripper"], atol=1e-6)
    reached = place(baxter, "right_gripper", q)
    np.testing.assert_allclose(reached[:3, 3], (0.75, -0.25, 0.0), atol=1e-6)
    np.testing.assert_allclose(reached[:3, 2], (0, 0, -1), atol=1e-6)
    assert plan.report.passed
    assert plan.report.proven_clearance > 0
    model = scene.collision_model(baxter)
    assert not any(model._touches(each, 0.0) for each in plan.path(np.linspace(0, 1, 100)))


@pytest.mark.slow
def test_the_report_tells_of_each_tool(baxter, swapped):
    _, plan = swapped
    left, right = plan.report.tools
    assert (left.tool, right.tool) == TOOLS
    q = plan.trajectory.path()(np.linspace(0, 1, 2001))
    for figure in (left, right):
        m = baxter.arm(figure.tool).kinematics().manipulability(q[:, list(baxter.joints_of(figure.tool))])
        assert figure.min_manipulability == pytest.approx(m.min(), rel=1e-4)
        assert figure.goal_position < 1e-6
    assert plan.report.min_manipulability <= min(left.min_manipulability, right.min_manipulability)
    assert "left_gripper: minimum m" in str(plan.report)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("task", "measure", "of_each"),
    [
        (mp.Task.position(), mp.measures.OverTools(measure=mp.measures.InverseCondition()), mp.measures.InverseCondition()),
        (None, mp.measures.JointLimitPenalised(measure=mp.measures.OverTools(), k=2.0), mp.measures.JointLimitPenalised(k=2.0)),
        (mp.Task.position(relative_to="right_gripper"), mp.measures.InverseCondition(), mp.measures.InverseCondition()),
    ],
    ids=["over tools", "penalised", "relative"],
)
def test_figures_of_each_tool_are_of_the_measure_that_is_reported(baxter, swapped, task, measure, of_each):
    objective = mp.PathObjective(task=task, measure=measure)
    report = mp.check(baxter, swapped[1].trajectory, objective=objective)
    q = swapped[1].trajectory.path()(np.linspace(0, 1, 2001))
    alone = None if task is None else replace(task, relative_to=None)
    for figure in report.tools:
        joints = list(baxter.joints_of(figure.tool))
        m = baxter.arm(figure.tool).kinematics(alone, measure=of_each).manipulability(q[:, joints])
        assert figure.min_manipulability == pytest.approx(m.min(), rel=1e-3)


@pytest.mark.slow
def test_an_arm_with_fewer_joints_than_a_relative_task_has_rows():
    robot = mp.load_robot(
        "baxter", joints=[f"{side}_{name}" for side in ("left", "right") for name in ("s0", "s1", "e1", "w1")]
    )
    objective = mp.PathObjective(task=mp.Task.pose(relative_to="right_gripper"))
    path = mp.JointPath.line(robot.neutral, robot.neutral + 0.05)
    report = mp.check(robot, mp.retime(path, robot), objective=objective)
    assert [figure.min_manipulability for figure in report.tools] == [0.0, 0.0]
    assert report.min_manipulability > 0


@pytest.mark.slow
def test_a_plan_is_the_same_when_it_is_loaded(swapped, tmp_path):
    _, plan = swapped
    plan.save(tmp_path)
    loaded = mp.Plan.load(tmp_path)
    assert loaded.robot.tools == TOOLS
    assert loaded.report == plan.report
    np.testing.assert_array_equal(loaded.trajectory.q, plan.trajectory.q)


def test_goals_of_both_tools_in_a_file(baxter, tmp_path):
    file = tmp_path / "goals.yml"
    left, right = (
        "{position: [0.7, 0.2, 0.1], rotation: [3.1416, 0, 0]}",
        "{position: [0.7, -0.2, 0.1], rotation: [1, 0, 0, 0]}",
    )
    file.write_text(f"goals:\n- tools: {{left_gripper: {left}, right_gripper: {right}}}\n")
    [goal] = goals_from_yaml(file, baxter)
    assert list(goal) == list(TOOLS)
    np.testing.assert_allclose(goal["right_gripper"].matrix, down(0.7, -0.2, 0.1), atol=1e-12)
    file.write_text(f"goals:\n- tools: {{left_griper: {left}}}\n")
    with pytest.raises(mp.errors.InvalidInputError, match=r"goals\[0\]\.tools.*left_gripper"):
        goals_from_yaml(file, baxter)
    file.write_text("goals:\n- tools: {left_gripper: {position: [0.7, 0.2, 0.1]}}\n")
    with pytest.raises(mp.errors.FileFormatError, match=r"goals\[0\]\.tools\.left_gripper"):
        goals_from_yaml(file, baxter)


@pytest.mark.slow
def test_one_hand_moves_and_the_other_ends_where_it_began(baxter, scene):
    plan = mp.plan(baxter, baxter.neutral, {"left_gripper": down(0.7, 0.2, 0.1)}, scene)
    right = list(baxter.joints_of("right_gripper"))
    np.testing.assert_array_equal(plan.path.goal[right], baxter.neutral[right])


@pytest.mark.slow
def test_the_torso_helps_both_arms():
    robot = mp.load_robot("tiago_dual")
    q = robot.neutral.copy()
    q[0] = 0.3
    goal = {tool: place(robot, tool, q) for tool in robot.tools}
    plan = mp.plan(robot, robot.neutral, goal)
    assert plan.report.passed
    assert max(figure.goal_position for figure in plan.report.tools) < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("name", ["tiago_dual", "talos"])
def test_goals_of_random_configurations_are_reached(name):
    robot = mp.load_robot(name)
    model, integral, rng = mp.Scene().collision_model(robot), mp.PathObjective().integral(robot), np.random.default_rng(7)
    some = robot.random_configuration(rng, size=400)
    for q in some[~model.in_collision_rows(some, clearance=1e-3)][:60]:
        goals = {tool: mp.PoseGoal(place(robot, tool, q)) for tool in robot.tools}
        found = reaching_tools(goals, robot.neutral, model, integral, 0.0, np.zeros(robot.n, dtype=bool))
        assert len(found.q) and not found.rejected
        assert not model.in_collision_rows(found.q).any()
        assert (found.q >= robot.limits.lower).all() and (found.q <= robot.limits.upper).all()
        for tool in robot.tools:
            np.testing.assert_allclose(place(robot, tool, found.q[0]), goals[tool].matrix, atol=1e-6)


@pytest.mark.slow
def test_out_of_reach_is_said_only_where_it_is_proven():
    robot = mp.load_robot("tiago_dual")
    goal = {tool: place(robot, tool, robot.neutral) for tool in robot.tools}
    first = robot.tool
    far, just = np.array(goal[first]), np.array(goal[first])
    far[0, 3] += 0.9
    just[0, 3] += 0.35
    with pytest.raises(
        mp.errors.InvalidInputError, match=f"{first} is out of reach: 1.44 m from torso_lift_joint, .* 1.41 m long"
    ):
        mp.plan(robot, robot.neutral, goal | {first: far})
    with pytest.raises(mp.errors.InvalidInputError, match=f"{first} may be out of reach: .*torso_lift_joint .*mp.PoseGoal"):
        mp.plan(robot, robot.neutral, goal | {first: just})


@pytest.mark.slow
def test_two_poses_that_need_different_torsos():
    robot = mp.load_robot("tiago_dual")
    model, integral = mp.Scene().collision_model(robot), mp.PathObjective().integral(robot)
    q, goals = robot.random_configuration(np.random.default_rng(0), size=200_000), {}
    for tool, sign in zip(robot.tools, (1, -1), strict=True):  # the highest pose of one tool and the lowest of the other
        poses = robot.arm(tool).kinematics().pose(q[:, list(robot.joints_of(tool))])
        goals[tool] = mp.PoseGoal(poses[(sign * poses[:, 2, 3]).argmax()])
    found = reaching_tools(goals, robot.neutral, model, integral, 0.0, np.zeros(robot.n, dtype=bool))
    assert not len(found.q)
    assert "each tool reaches its pose alone, but no value of torso_lift_joint was found" in found.rejected[0][1]


@pytest.mark.slow
def test_held_joints_stay_where_both_arms_and_a_torso_move():
    robot = mp.load_robot("tiago_dual")
    model, integral = mp.Scene().collision_model(robot), mp.PathObjective().integral(robot)
    held = np.zeros(robot.n, dtype=bool)
    held[robot.joints_of(robot.tools[0])[1]] = True
    q = robot.neutral.copy()
    q[0] = 0.3
    goals = {tool: mp.PoseGoal(place(robot, tool, q)) for tool in robot.tools}
    found = reaching_tools(goals, robot.neutral, model, integral, 0.0, held)
    assert len(found.q)
    np.testing.assert_array_equal(found.q[:, held], np.tile(robot.neutral[held], (len(found.q), 1)))
    np.testing.assert_allclose(place(robot, robot.tools[0], found.q[0]), goals[robot.tools[0]].matrix, atol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("goal", "message"),
    [
        (np.eye(4), "which tool reaches it"),
        ({"left_griper": np.eye(4)}, "left_gripper"),
        ({}, "at least one of the tools"),
        ({"left_gripper": "neutral"}, r"goal\['left_gripper'\]"),
        ({"left_gripper": down(3.0, 0.2, 0.1), "right_gripper": down(0.7, -0.2, 0.1)}, "left_gripper is out of reach"),
        ({tool: down(0.7, 0.0, 0.1) for tool in TOOLS}, "collides with"),
        ([{"left_gripper": np.eye(3)}], r"goal\[0\]\['left_gripper'\]"),
    ],
    ids=["one pose", "unknown tool", "no tool", "a name", "out of reach", "both in one place", "no pose"],
)
def test_wrong_goals(baxter, scene, goal, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.plan(baxter, baxter.neutral, goal, scene)


def test_what_needs_one_arm_says_so(baxter):
    line = mp.CartesianPath.line(down(0.6, 0.2, 0.1), down(0.7, 0.2, 0.1))
    calls = [
        lambda: mp.inverse_kinematics(baxter, np.eye(4)),
        lambda: mp.follow(baxter, line),
        lambda: mp.sample_layers(baxter, line),
        lambda: mp.Controller(baxter, mp.formulations.Classical(), dt=0.01),
    ]
    for call in calls:
        with pytest.raises(mp.errors.InvalidInputError, match=r"robot\.arm\('left_gripper'\)"):
            call()


def test_a_goal_of_several_tools_takes_no_pose_of_a_part(baxter):
    part = mp.PoseGoal(np.eye(4), of="cup")
    with pytest.raises(mp.errors.InvalidInputError, match=r"left_gripper'\].of: got 'cup'"):
        mp.plan(baxter, baxter.neutral, {"left_gripper": part})


def test_a_task_has_at_most_as_many_rows_as_the_joints_of_one_arm():
    """Two arms of four joints each: the pose of either tool needs six."""
    joints = [f"{side}_{name}" for side in ("left", "right") for name in ("s0", "s1", "e1", "w1")]
    with pytest.raises(mp.errors.InvalidInputError, match="task.*at most 4 rows"):
        mp.PathObjective(task=mp.Task.pose()).kinematics(mp.load_robot("baxter", joints=joints))
