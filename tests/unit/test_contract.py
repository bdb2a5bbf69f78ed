"""The public names of DESIGN.md that exist so far, called as it says: checks outside the project use these names."""

import inspect

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan import formulations

#: Arguments by position, in order; all others are by keyword only.
POSITIONAL = {
    mp.plan: ["robot", "start", "goal", "scene"],
    mp.plan_many: ["problems", "executor"],
    mp.optimize_path: ["robot", "start", "goal", "scene"],
    mp.seed_path: ["robot", "start", "goal", "scene"],
    mp.follow: ["robot", "path", "scene"],
    mp.improve: ["robot", "recorded", "scene"],
    mp.check: ["robot", "trajectory", "scene"],
    mp.track: ["robot", "path", "start", "formulation"],
    mp.Controller: ["robot", "formulation"],
    mp.PoseGoal: ["pose"],
    mp.retime: ["path", "robot"],
    mp.sample_layers: ["robot", "path", "positions"],
    mp.max_min_search: ["layers", "epsilon"],
    mp.inverse_kinematics: ["robot", "pose", "parameters"],
    mp.load_robot: ["name"],
    mp.Robot.from_urdf: ["file"],
    mp.Robot.from_mjcf: ["file"],
    mp.Robot.kinematics: ["self", "task"],
}
#: Options that each function takes by name.
OPTIONS = {
    mp.plan: {"objective", "shape", "seeding", "clearance", "torque", "executor", "throw", "progress"},
    mp.optimize_path: {"objective", "shape", "seeding", "clearance", "executor", "throw", "progress"},
    mp.plan_many: {"folder", "progress"},
    mp.Problem: {"robot", "start", "goal", "scene", "objective", "shape", "seeding", "clearance", "torque"},
    mp.seed_path: {"seeding", "clearance"},
    mp.follow: {"positions", "objective", "epsilon", "samples", "tolerance", "clearance", "closed", "torque"},
    mp.improve: {"objective", "duration", "tolerance", "clearance", "degrees"},
    mp.check: {"start", "goal", "path", "tolerance", "clearance", "objective", "torque"},
    mp.track: {"dt", "duration", "task", "measure"},
    mp.Controller: {"dt", "task", "measure"},
    mp.retime: {"limits", "torque", "segments"},
    mp.PoseGoal: {"free_axis", "tolerance"},
    mp.PathObjective: {"power", "task", "measure", "metric"},
    mp.PathShape: {
        "degree",
        "basis",
        "pieces",
        "start_slope",
        "goal_slope",
        "start_second_derivative",
        "goal_second_derivative",
    },
    mp.Seeding: {"planner", "seed", "count", "time_limit", "shifts", "initial"},
    mp.Robot.from_urdf: {"tool", "joints", "srdf"},
    mp.Robot.kinematics: {"measure", "backend", "compiled"},
}
BY_POSITION = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.POSITIONAL_ONLY)


@pytest.mark.parametrize("function", POSITIONAL, ids=lambda each: each.__qualname__)
def test_only_what_a_job_is_about_stands_by_position(function):
    parameters = inspect.signature(function).parameters.values()
    assert [each.name for each in parameters if each.kind in BY_POSITION] == POSITIONAL[function]


@pytest.mark.parametrize("function", OPTIONS, ids=lambda each: each.__qualname__)
def test_options_are_taken_by_name(function):
    parameters = inspect.signature(function).parameters.values()
    assert {each.name for each in parameters if each.kind is inspect.Parameter.KEYWORD_ONLY} >= OPTIONS[function]


def test_a_robot_has_its_names(panda):
    assert "panda" in mp.available_robots()
    assert (panda.n, len(panda.joint_names), panda.tool) == (7, 7, "panda_hand_tcp")
    assert panda.neutral.shape == (7,) and set(panda.states) >= {"default"}
    for kind in ("lower", "upper", "velocity", "acceleration", "jerk", "effort"):
        assert getattr(panda.limits, kind).shape == (7,)
    assert mp.load_robot("panda", locked={"panda_finger_joint1": 0.02}).locked["panda_finger_joint1"] == 0.02


@pytest.mark.parametrize("shape", [(), (4,), (2, 3)])
def test_kinematics_take_one_configuration_or_many(panda, shape):
    task = mp.Task.pose(length=1.0)
    kin = panda.kinematics(task, measure=None, backend="auto", compiled="auto")
    q = np.broadcast_to(panda.neutral, (*shape, 7))
    assert kin.pose(q).shape == (*shape, 4, 4) and kin.jacobian(q).shape == (*shape, 6, 7)
    assert np.shape(kin.manipulability(q)) == shape
    assert kin.gradient(q).shape == (*shape, 7) and kin.hessian(q).shape == (*shape, 7, 7)
    assert kin.symbolic.manipulability(panda.neutral).shape == (1, 1)


def test_length_1_gives_the_raw_jacobian(panda):
    data = panda.model.createData()
    frame = panda.model.getFrameId(panda.tool)
    raw = pin.computeFrameJacobian(panda.model, data, panda.neutral, frame, pin.LOCAL_WORLD_ALIGNED)
    np.testing.assert_allclose(panda.kinematics(mp.Task.pose(length=1.0)).jacobian(panda.neutral), raw, atol=1e-12)


def test_tasks_have_their_names():
    tasks = [mp.Task.pose(length=0.5), mp.Task.position(), mp.Task.orientation(), mp.Task.planar(), mp.Task.pointing([0, 0, 1])]
    assert [task.rows for task in tasks] == [6, 3, 3, 2, 5]


def test_a_scene_answers(panda):
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), rotation=None, name="post")])
    assert scene.in_collision(panda, panda.neutral) in (True, False)
    assert np.min(scene.distances(panda, panda.neutral)) < np.inf
    assert scene.path_clearance(panda, mp.JointPath.line(panda.neutral, panda.neutral + 0.1)).checks > 0
    for kind in (mp.Sphere, mp.Capsule, mp.Cylinder, mp.Plane, mp.Mesh):
        assert "name" in inspect.signature(kind).parameters


def test_robots_and_scenes_are_values(panda):
    robot = panda.with_tool(pin.SE3.Identity(), name="tcp").at(np.eye(4)).attach(mp.Sphere(radius=0.02), name="part")
    assert robot.tool == "tcp" and robot.detach("part").n == panda.n == 7 and panda.tool == "panda_hand_tcp"
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), name="box")]).at(np.eye(4)) + mp.Scene([mp.Sphere(radius=0.1, name="ball")])
    assert callable(mp.Scene.from_moveit) and scene.names == ("box", "ball") and scene.without("box").names == ("ball",)


def test_paths_and_trajectories_have_their_names(planar, tmp_path):
    line = mp.CartesianPath.line(np.eye(4), pin.SE3(np.eye(3), np.array([0.1, 0.0, 0.0])).homogeneous)
    assert line(0.5).shape == (4, 4) and line.sample(3).shape == (3, 4, 4)
    path = mp.JointPath.line([0.0, 0.5, 0.5], [0.5, 0.4, 0.3])
    assert path(0.5, order=1).shape == (3,) and path.length > 0
    trajectory = mp.retime(path, planar, limits=None, torque=False, segments=())
    assert trajectory(0.0, order=2).shape == (3,) and trajectory.duration > 0
    for kind, suffix in (("csv", "csv"), ("json", "json"), ("ros", "yaml"), ("npz", "npz")):
        file = tmp_path / f"motion.{suffix}"
        getattr(trajectory, f"to_{kind}")(file)
        back = getattr(mp.Trajectory, f"from_{kind}")(file)
        np.testing.assert_allclose(back(back.duration), path.goal, atol=1e-6)


def test_formulations_have_their_names():
    given = [formulations.Classical(0.1), formulations.Objective(1.0), formulations.Equality(1.0), formulations.LogDrive()]
    assert all(isinstance(each, formulations.Formulation) for each in given)
    assert formulations is mp.formulations


def test_a_controller_and_a_tracked_path_have_their_names(planar, tmp_path):
    q = np.array([0.0, 1.5, -2.0])
    controller = mp.Controller(planar, formulations.LogDrive(), dt=0.01, compiled=False)
    target = planar.kinematics(controller.task).pose(q)
    assert controller.step(q, np.zeros(3), target).shape == (3,)
    assert controller.report.status is mp.results.StepStatus.SOLVED
    assert controller.export_c(tmp_path)
    line = mp.CartesianPath.line(target, target)
    tracking = mp.track(planar, line, q, formulations.Classical(), dt=0.01, duration=0.05, compiled=False)
    assert tracking.q.shape == tracking.qd.shape == (len(tracking.manipulability), 3)


def test_a_plan_has_its_names(planar):
    plan = mp.plan(planar, [0.0, 1.5, -2.0], [1.0, 1.0, -1.0], None, objective=mp.PathObjective(power=2.0))
    assert isinstance(plan, mp.Plan)
    assert isinstance(plan.path, mp.JointPath) and isinstance(plan.trajectory, mp.Trajectory)
    assert isinstance(plan.report, mp.results.Report) and isinstance(plan.status, mp.Status)
    assert plan.report.passed
