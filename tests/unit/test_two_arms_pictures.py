"""Pictures and the viewer show all tools of a robot: ways, ellipsoids, names."""

import numpy as np
import pinocchio as pin
import pytest
from matplotlib.figure import Figure

import manipplan as mp
from manipplan.viz.animation import _stage
from manipplan.viz.arm import plot_arm, plot_ellipsoids
from manipplan.viz.figure import draw_figure
from manipplan.viz.motions import ShownMotion
from manipplan.viz.viewer.bodies import _rods
from manipplan.viz.viewer.plan_viewer import about


@pytest.fixture(scope="module")
def plan():
    robot = mp.load_robot("baxter")
    goal = robot.neutral.copy()
    goal[[0, 7]] = 0.3, -0.4
    return mp.plan(robot, robot.neutral, goal)


def places(robot, q):
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    return [data.oMf[robot.model.getFrameId(tool)].translation.copy() for tool in robot.tools]


def ends(ax):
    """The last point of each line of 3D axes."""
    return np.array([np.array(line.get_data_3d())[:, -1] for line in ax.lines])


@pytest.mark.slow
def test_the_way_of_each_tool_is_drawn(plan):
    for ax in (
        plot_arm(plan.robot, plan.path),
        plot_ellipsoids(plan.robot.kinematics(), plan.path),
        draw_figure(plan).axes[0],
    ):
        for place in places(plan.robot, plan.path.goal):
            assert np.abs(ends(ax) - place).max(axis=1).min() < 1e-9
    assert "tools, path" in [text.get_text() for text in plot_arm(plan.robot, plan.path).get_legend().get_texts()]


@pytest.mark.slow
def test_ellipsoids_of_an_animation_are_at_their_tools(plan, monkeypatch):
    centres = []
    monkeypatch.setattr("manipplan.viz.animation.plot_ellipsoid", lambda _, centre, **__: centres.append(centre))
    _stage(ShownMotion.of(plan), Figure())(plan.trajectory.duration)
    np.testing.assert_allclose(centres, places(plan.robot, plan.path.goal), atol=1e-9)


@pytest.mark.slow
def test_the_viewer_shows_all_tools(plan):
    shown = ShownMotion.of(plan)
    assert len(shown.tools) == len(shown.ours.tools) == 2
    for way, tool, first, last in zip(
        shown.ours.tools, shown.tools, places(plan.robot, plan.path.start), places(plan.robot, plan.path.goal), strict=True
    ):
        np.testing.assert_allclose(way[[0, -1]], [first, last], atol=1e-9)
        np.testing.assert_allclose(tool.pose(plan.path.goal)[:3, 3], last, atol=1e-9)
    assert "tool frames left_gripper and right_gripper" in about(shown)


@pytest.mark.slow
def test_the_ellipsoids_of_the_viewer_are_at_their_tools(plan):
    with plan.show(port=0, open_browser=False) as viewer:
        viewer.time = plan.trajectory.duration
        for figure, place in zip(viewer.stage.figures[0].ellipsoids, places(plan.robot, plan.path.goal), strict=True):
            np.testing.assert_allclose(figure.mesh.position, place, atol=1e-9)


@pytest.mark.slow
def test_rods_lead_to_each_tool(plan):
    robot, q = plan.robot, plan.robot.neutral
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, q)
    points = [body.vertices @ data.oMi[body.joint].rotation.T + data.oMi[body.joint].translation for body in _rods(robot)]
    for place in places(robot, q):
        assert min(np.linalg.norm(each - place, axis=1).min() for each in points) < 0.1
