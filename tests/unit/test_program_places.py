"""Goals that are poses of carried parts: the grasp and the place that goes with it."""

import numpy as np
import pytest
from program_cell import DOWN, UPRIGHT, carried_to, part_pose, placed_part, pose_at
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.programs.leg_motions import ToolPathPlanners, nodes_of
from manipplan.programs.legs import NOWHERE, State, read_steps


@pytest.mark.slow
@pytest.mark.parametrize(
    "first", [None, [mp.MoveTo([each @ pose_at(0, 0, -0.1) @ DOWN for each in UPRIGHT]), mp.MoveAlong([0, 0, 0.1])]]
)
def test_a_part_is_placed_at_its_own_pose(hand, cell, first):
    """Also where the grasp ends a path, which the tool follows to its tolerance only."""
    place = part_pose(0.45, -0.3, 0.051, 0.4)
    made = mp.sequence(hand, "default", carried_to(mp.PoseGoal(place, of="part"), first=first), cell)
    assert made.passed
    np.testing.assert_allclose(placed_part(made), place, atol=3e-6)


def flat(x, y, turn):
    return part_pose(x, y, 0.0, turn)


@pytest.mark.slow
@pytest.mark.parametrize("place", [flat(-1.0, 1.2, 0.5), flat(-0.5, 1.5, -1.0), flat(0.2, 1.8, 2.0), flat(-1.0, -1.0, 2.0)])
def test_the_grasp_goes_with_the_place_of_the_part(place):
    """Another grasp is best for each place, and the program is as good as with that one alone."""
    arm, start, at = mp.planar_arm([1.0, 1.0, 1.0]), np.array([0.4, 0.9, 0.8]), np.array([1.2, 1.0])
    scene = mp.Scene([mp.Box(size=(0.1, 0.05, 0.1), position=(*at, 0.0), name="part")])
    grasps = [flat(*(at - 0.2 * np.array([np.cos(angle), np.sin(angle)])), angle) for angle in np.linspace(-1.5, 1.5, 4)]
    ends = [mp.Attach("part"), mp.MoveTo(mp.PoseGoal(place, of="part"))]
    whole = mp.sequence(arm, start, [mp.MoveTo(grasps), *ends], scene)
    least = []
    for grasp in grasps:
        try:
            least.append(mp.sequence(arm, start, [mp.MoveTo(grasp), *ends], scene).min_manipulability)
        except mp.errors.InvalidInputError as error:
            least.append(0.0)
            assert "out of reach" in str(error) or "in collision" in str(error) or "collides" in str(error)
    assert max(least) > 1.05 * min(least)
    assert whole.min_manipulability >= max(least) * 0.99
    assert least[whole.goals[0]] >= max(least) * 0.99


@pytest.mark.slow
def test_free_axes_and_tolerances_of_a_part(hand, cell):
    place = part_pose(0.45, -0.3, 0.053, 0.4)
    turned = placed_part(mp.sequence(hand, "default", carried_to(mp.PoseGoal(place, of="part", free_axis=[0, 0, 1])), cell))
    np.testing.assert_allclose(turned[:, 2:], place[:, 2:], atol=3e-6)
    tolerance = mp.Tolerance(position=0.002, rotation=0.1)
    made = mp.sequence(hand, "default", carried_to(mp.PoseGoal(place, of="part", tolerance=tolerance)), cell)
    off = np.linalg.inv(place) @ placed_part(made)
    assert np.linalg.norm(off[:3, 3]) <= 0.002 + 1e-6
    assert np.arccos(np.clip((np.trace(off[:3, :3]) - 1) / 2, -1, 1)) <= 0.1 + 1e-6


@pytest.mark.slow
def test_a_part_is_taken_up_twice(hand, cell):
    """Where it is after the first place depends on the grasp; its last pose does not."""
    steps = carried_to([pose_at(0.45, -0.3, 0.09, turn) for turn in (0.0, 1.0)])
    away = [mp.MoveAlong([0, 0, -0.1])]
    again = [pose_at(0.45, -0.3, 0.09, turn) for turn in (0.3, 0.3 + np.pi / 2)]
    place = part_pose(0.5, 0.25, 0.051, 0.7)
    steps += [*away, *carried_to(mp.PoseGoal(place, of="part"), first=[mp.MoveTo(again, approach=0.1)]), *away]
    made = mp.sequence(hand, "default", steps, cell, blend=0.05)
    np.testing.assert_allclose(placed_part(made), place, atol=3e-6)


@pytest.mark.slow
def test_plan_to_a_pose_of_a_carried_part(hand):
    ball = mp.Box(size=(0.05, 0.03, 0.02), position=(0.02, 0.0, 0.05), rotation=(0.1, 0.2, 0.3), name="bar")
    carrying = hand.attach(ball)
    place = part_pose(0.4, 0.3, 0.4, 0.5)
    made = mp.plan(carrying, "default", mp.PoseGoal(place @ DOWN, of="bar"))
    reached = carrying.kinematics().pose(made.trajectory.q[-1]) @ carrying.carried["bar"].solid.pose.homogeneous
    np.testing.assert_allclose(reached, place @ DOWN, atol=3e-6)
    with pytest.raises(mp.errors.UnknownNameError, match=r"goal\.of: got 'bra'; allowed: one of bar"):
        mp.plan(carrying, "default", mp.PoseGoal(place, of="bra"))
    with pytest.raises(mp.errors.InvalidInputError, match=r"goal\.free_axis: .* it is 8\.81 mm beside that of bar"):
        mp.plan(carrying, "default", mp.PoseGoal(place, of="bar", free_axis=[0, 0, 1]))


@pytest.mark.slow
def test_each_of_many_grasps_is_searched_as_well_as_alone(hand):
    """With the goals of the whole leg at once, each would get few samples and most no refinement."""
    tilted = []
    for tilt in (0.0, 0.6, 1.2):
        for turn in np.arange(8) * np.pi / 4:
            pose = np.eye(4)
            pose[:3, :3] = Rotation.from_euler("ZX", [turn, np.pi - tilt]).as_matrix()
            pose[:3, 3] = [0.5, 0.2, 0.1] - 0.03 * pose[:3, 2]
            tilted.append(pose)
    planners = ToolPathPlanners(objective=mp.PathObjective(), clearance=0.0)
    state = State(robot=hand, scene=mp.Scene())

    def bounds(goals):
        (leg,) = read_steps([mp.MoveTo(goals)], hand, hand.neutral)
        nodes = nodes_of(leg, state, hand.neutral, planners, [NOWHERE], set())
        return [max(node.bound for node in nodes if node.goal_index == k) for k in range(len(goals))]

    alone = np.array([bounds([goal])[0] for goal in tilted])
    assert (np.array(bounds(tilted)) >= 0.95 * np.minimum(alone, hand.kinematics().manipulability(hand.neutral))).all()
