"""Constraints on the tools of a robot with two arms: each names its tool."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.constraints.constraint import constraint_data, constraint_of, constraints_from_yaml
from manipplan.constraints.constraint_set import ConstraintSet


@pytest.fixture(scope="module")
def baxter():
    return mp.load_robot("baxter")


def place(robot, frame, q):
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    return data.oMf[robot.model.getFrameId(frame)].homogeneous


def test_rows_are_those_of_the_tool_that_is_named(baxter):
    given = [
        mp.PositionBox((0, -1, -1), (1, 1, 1), tool="right_gripper"),
        mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.4, tool="left_gripper"),
        mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.4, tool="right_gripper"),
        mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.4),
    ]
    kept = ConstraintSet.of(baxter, given)
    assert len(kept.weights) == 7  # the box and the second limit
    for q in baxter.random_configuration(np.random.default_rng(0), size=4):
        values, slopes = kept.values(q[None])[0], kept.gradients(q[None])[0]
        left, right = (place(baxter, tool, q) for tool in baxter.tools)
        x = right[0, 3]
        assert values[kept.owners == 0][:2] == pytest.approx([x, 1 - x])
        for k, pose in ((1, left), (2, right), (3, left)):
            [row] = np.flatnonzero(kept.owners == k)
            assert values[row] == pytest.approx((-pose[2, 2] - np.cos(0.4)) / np.sin(0.4))
        steps = 1e-6 * np.eye(baxter.n)
        wanted = (kept.values(q + steps) - kept.values(q - steps)).T / 2e-6
        np.testing.assert_allclose(slopes, wanted, atol=1e-7)


@pytest.mark.slow
def test_both_hands_keep_level_and_the_report_says_how(baxter):
    def down(x, y, z):
        pose = np.diag([1.0, -1.0, -1.0, 1.0])
        pose[:3, 3] = x, y, z
        return pose

    goals = [{"left_gripper": down(0.7, y, 0.1), "right_gripper": down(0.7, -y, 0.1)} for y in (0.3, 0.15)]
    start = mp.plan(baxter, baxter.neutral, goals[0]).path.goal
    limits = [mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.2, tool=tool) for tool in baxter.tools]
    plan = mp.plan(baxter, start, goals[1], constraints=limits)
    assert plan.report.passed
    poses = [
        [place(baxter, tool, q) for q in plan.trajectory(np.linspace(0, plan.trajectory.duration, 300))]
        for tool in baxter.tools
    ]
    assert -np.array(poses)[:, :, 2, 2].max() >= np.cos(0.2 + 1e-5)
    assert [each.name.split(" axis")[0] for each in plan.report.constraints] == [
        "tilt of left_gripper",
        "tilt of right_gripper",
    ]
    assert [each.proven for each in plan.report.constraints] == [True, False]  # of one tool they are proven


def test_opposite_limits_contradict_each_other_only_on_one_tool(baxter):
    up, down = (mp.TiltLimit((0, 0, 1), (0, 0, z), 0.4, tool=tool) for z, tool in zip((1, -1), baxter.tools, strict=True))
    assert ConstraintSet.of(baxter, [up, down]).count == 2
    with pytest.raises(mp.errors.InvalidInputError, match="together with"):
        ConstraintSet.of(baxter, [mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.4), up])


def test_names_of_tools(baxter, tmp_path):
    with pytest.raises(mp.errors.UnknownNameError, match="left_gripper"):
        mp.plan(
            baxter,
            baxter.neutral,
            baxter.neutral + 0.1,
            constraints=[mp.TiltLimit((0, 0, 1), (0, 0, -1), 3.0, tool="left_griper")],
        )
    for wrong in ("", 1):
        with pytest.raises(mp.errors.InvalidInputError, match="tool: got"):
            mp.PositionBox((0, 0, 0), (1, 1, 1), tool=wrong)
    limit = mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.4, tool="right_gripper")
    assert constraint_of(constraint_data(limit)) == limit
    file = tmp_path / "kept.yml"
    file.write_text("constraints:\n- tilt_limit: {axis: [0, 0, 1], direction: [0, 0, -1], angle: 0.4, tool: right_gripper}\n")
    assert constraints_from_yaml(file) == (limit,)
