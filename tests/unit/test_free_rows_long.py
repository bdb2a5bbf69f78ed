"""follow with free rows through many poses: corners, steps of a micrometre and of centimetres, judged by Pinocchio."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp

ROWS = np.eye(6)
CORNERS = np.array([[0.45, -0.2, 0.35], [0.6, -0.2, 0.35], [0.6, 0.2, 0.35], [0.45, 0.2, 0.45], [0.45, -0.1, 0.45]])
#: Tasks, and the directions in which the position is given.
TASKS = {
    "pose": (mp.Task.pose(), [0, 1, 2]),
    "position": (mp.Task.position(), [0, 1, 2]),
    "height free": (mp.Task.custom(ROWS[[0, 1, 3, 4, 5]]), [0, 1]),
    "drill": (mp.Task.custom(ROWS[[0, 1, 3, 4]], frame="tool"), [0, 1]),
}


def thousand_poses():
    """The tool points down along a polyline; most poses are near its ends."""
    way = np.append(0.0, np.linalg.norm(np.diff(CORNERS, axis=0), axis=1).cumsum())
    u = np.sort(np.append(way, way[-1] * np.random.default_rng(3).beta(0.4, 0.6, 1000)))
    u = u[np.append(True, np.diff(u) > 2e-6)]
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (len(u), 1, 1))
    poses[:, :3, 3] = np.array([np.interp(u, way, column) for column in CORNERS.T]).T
    return poses


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5"])
@pytest.mark.parametrize("task", TASKS)
def test_each_of_a_thousand_poses_is_met(name, task):
    robot = mp.load_robot(name)
    if name == "ur5":
        robot = robot.with_limits(lower=-np.pi, upper=np.pi)
    poses, (rows, given) = thousand_poses(), TASKS[task]
    assert len(poses) > 950
    plan = mp.follow(robot, mp.CartesianPath.through(poses), objective=mp.PathObjective(task=rows))
    assert plan.report.passed and plan.status is mp.Status.FOLLOWED
    whole = plan if task == "pose" else mp.follow(robot, plan.workspace_path)
    minimum = robot.kinematics(rows).manipulability(whole.trajectory(np.linspace(0, whole.trajectory.duration, 4000))).min()
    assert plan.report.min_manipulability > 0.999 * minimum
    s = plan.workspace_path.knots
    data, frame, last = robot.model.createData(), robot.model.getFrameId(robot.tool), 0.0
    for pose, at in zip(poses, s, strict=True):
        pin.framesForwardKinematics(robot.model, data, plan.path(at))
        reached = data.oMf[frame].homogeneous
        assert np.abs((reached - pose)[given, 3]).max() < 1e-4
        if task != "position":
            assert np.arccos(np.clip(reached[:3, 2] @ pose[:3, 2], -1, 1)) < 1e-3
        assert at >= last
        last = at
    # the timed motion goes along this path
    time = plan.trajectory(np.linspace(0, plan.trajectory.duration, 300))
    fine = plan.path(np.linspace(0, 1, 20001))
    assert np.abs(time[:, None] - fine).max(axis=2).min(axis=1).max() < 1e-3
