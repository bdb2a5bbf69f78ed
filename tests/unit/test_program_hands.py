"""Programs of robots with several tools, and of one arm of such a robot."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.robots.model_tree import frame_pose
from manipplan.viz.motions import find_moved_parts

LEFT, RIGHT = "left_gripper", "right_gripper"
OFF = np.eye(4)
OFF[2, 3] = 0.06


@pytest.fixture(scope="module")
def baxter():
    return mp.load_robot("baxter")


def away(robot, q, tool, by):
    """The configuration with the joints of one tool moved."""
    q = q.copy()
    q[list(robot.joints_of(tool))] += by
    return q


def ball_at(robot, tool, q, far=0.06):
    """A ball in front of a hand, in the world."""
    place = frame_pose(robot.model, tool, q)
    return mp.Sphere(radius=0.02, position=place[:3, 3] + far * place[:3, 2], name="ball")


def placed_ball(program):
    scene = program.final_scene
    return scene.obstacles[scene.names.index("ball")].pose.homogeneous


@pytest.mark.slow
def test_the_hand_that_is_named_takes_up_a_part(baxter, tmp_path):
    first = away(baxter, baxter.neutral, RIGHT, 0.1)
    second = away(baxter, away(baxter, first, RIGHT, -0.3), LEFT, 0.2)
    scene = mp.Scene([ball_at(baxter, RIGHT, first)])
    steps = [mp.MoveTo(first), mp.Attach("ball", tool=RIGHT), mp.MoveTo(second), mp.Detach("ball"), mp.MoveTo(baxter.neutral)]
    made = mp.sequence(baxter, baxter.neutral, steps, scene, blend=0.02)
    assert made.passed
    assert not any("taken up" in each for each in made.warnings)
    assert made.parts[1].robot.carried["ball"].frame == RIGHT
    grip = np.linalg.inv(frame_pose(baxter.model, RIGHT, first)) @ scene.obstacles[0].pose.homogeneous
    np.testing.assert_allclose(placed_ball(made), frame_pose(baxter.model, RIGHT, second) @ grip, atol=1e-8)
    assert made.final_robot is baxter
    (part,) = find_moved_parts(made)
    t = made.marks[2].begin + 0.5 * (made.marks[3].begin - made.marks[2].begin)
    q = made.trajectory(t)
    shown = part.at(t, baxter, q).pose.homogeneous
    np.testing.assert_allclose(shown, frame_pose(baxter.model, RIGHT, q) @ grip, atol=1e-6)
    made.save(tmp_path / "made")
    again = mp.Program.load(tmp_path / "made")
    assert again.parts[1].robot.carried["ball"].frame == RIGHT
    assert again.marks == made.marks


@pytest.mark.slow
def test_a_hand_far_from_the_part_is_told(baxter):
    """The ball is in front of the right hand; the left one takes it up."""
    scene = mp.Scene([ball_at(baxter, RIGHT, baxter.neutral)])
    steps = [mp.MoveTo(away(baxter, baxter.neutral, LEFT, 0.05)), mp.Attach("ball", tool=LEFT), mp.Wait(0.1)]
    made = mp.sequence(baxter, baxter.neutral, steps, scene)
    (warning,) = made.warnings
    assert warning.startswith("steps[1]: ball is taken up, ") and warning.endswith(" mm from the hand")


@pytest.mark.slow
def test_a_part_between_fingers_that_may_touch_it_is_not_far(hand, cell):
    """The nearest body that is checked would be the arm's."""
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = 0.45, 0.3, 0.09
    scene = cell
    for link in ("panda_hand", "panda_leftfinger", "panda_rightfinger"):
        scene = scene.allow("part", link)
    assert not mp.sequence(hand, "default", [mp.MoveTo(pose, approach=0.1), mp.Attach("part")], scene).warnings


@pytest.mark.parametrize(
    ("steps", "message"),
    [
        ([mp.Attach("ball")], r"steps\[0\]\.tool: got ''; allowed: the hand that .* 'left_gripper' or 'right_gripper'"),
        ([mp.Attach("ball", tool="left_griper")], r"steps\[0\]\.tool: got 'left_griper'; allowed: did you mean left_gripper"),
        (
            [mp.MoveAlong([0, 0, 0.1])],
            r"steps\[0\]\.path: got 'baxter, with 2 tools'.*robot\.arm\('left_gripper'\) or robot\.arm\('right_gripper'\)",
        ),
        (
            [mp.MoveAlong(mp.CartesianPath.line(np.eye(4), OFF))],
            r"steps\[0\]\.path: got 'baxter, with 2 tools'.*robot\.arm\('left_gripper'\)",
        ),
        ([mp.MoveTo(np.eye(4))], r"steps\[0\]\.goal: got 'one pose'; allowed: which tool reaches it"),
        ([mp.MoveTo({LEFT: np.eye(4)}, approach=0.1)], r"steps\[0\]\.goal: .*a pose of the tool, since there is an approach"),
    ],
)
def test_what_two_hands_cannot_do_is_refused(baxter, steps, message):
    scene = mp.Scene([ball_at(baxter, RIGHT, baxter.neutral)])
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.sequence(baxter, baxter.neutral, steps, scene)


@pytest.mark.slow
def test_goals_of_both_hands(baxter):
    def down(x, y, z):
        pose = np.eye(4)
        pose[:3, :3] = Rotation.from_euler("X", np.pi).as_matrix()
        pose[:3, 3] = x, y, z
        return pose

    goal = {LEFT: down(0.6, 0.3, 0.2), RIGHT: down(0.6, -0.3, 0.2)}
    made = mp.sequence(baxter, baxter.neutral, [mp.MoveTo(goal), mp.MoveTo(baxter.neutral)], blend=0.05)
    assert made.passed
    (corner,) = [mark.begin for mark in made.marks[1:]] if not made.stops else made.stops
    q = made.trajectory(corner)
    for tool, pose in goal.items():
        assert np.linalg.norm(frame_pose(baxter.model, tool, q)[:3, 3] - pose[:3, 3]) <= 0.05 + 1e-6


@pytest.fixture(scope="module")
def left(baxter):
    """The left arm, while the right hand holds a ball."""
    carrying = baxter.attach(mp.Sphere(radius=0.02, position=(0, 0, 0.06), name="ball"), tool=RIGHT)
    return carrying.arm(LEFT, away(baxter, baxter.neutral, RIGHT, 0.2))


def test_a_part_in_the_other_hand_is_no_goal(left):
    goal = mp.PoseGoal(left.kinematics().pose(left.neutral + 0.1), of="ball")
    with pytest.raises(
        mp.errors.InvalidInputError,
        match=r"steps\[0\]\.goal\.of: .* a part in the hand left_gripper: ball is in the hand right",
    ):
        mp.sequence(left, left.neutral, [mp.MoveTo(goal)])
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"goal\.of: .* a part in the hand left_gripper: ball is in the hand right"
    ):
        mp.plan(left, left.neutral, goal)
    where = frame_pose(left.model, RIGHT, left.neutral) @ left.carried["ball"].solid.pose.homogeneous
    assert mp.PoseGoal(where, of="ball").missed_by(left, left.neutral + 0.3) == ""  # it does not move with the left arm


@pytest.mark.slow
def test_the_other_hand_puts_a_part_down_where_it_is(left, baxter, tmp_path):
    where = frame_pose(left.model, RIGHT, left.neutral) @ left.carried["ball"].solid.pose.homogeneous
    steps = [mp.MoveTo(left.neutral + 0.1), mp.Detach("ball"), mp.MoveTo(left.neutral)]
    made = mp.sequence(left, left.neutral, steps)
    np.testing.assert_allclose(placed_ball(made), where, atol=1e-9)
    made.save(tmp_path / "made")
    with pytest.raises(mp.errors.FileFormatError, match="give robot="):
        mp.Program.load(tmp_path / "made")
    again = mp.Program.load(tmp_path / "made", robot=left)
    assert again.marks == made.marks
    assert str(again) == str(made)
    assert [dict(part.robot.carried).keys() for part in again.parts] == [{"ball"}, set()]
    assert again.parts[0].robot.carried["ball"].frame == RIGHT
    bare = mp.Program.load(tmp_path / "made", robot=left.detach("ball"))
    assert bare.robot.carried.keys() == {"ball"}
    with pytest.raises(mp.errors.FileFormatError, match="give the right robot="):
        mp.Program.load(tmp_path / "made", robot=baxter.arm(RIGHT))


def test_a_program_file_names_the_hand(baxter, tmp_path):
    from manipplan.programs.steps import ProgramFile

    file = tmp_path / "program.yaml"
    file.write_text("start: [0]\nsteps:\n- attach: {part: ball, tool: left_gripper}\n- attach: ball\n")
    first, second = ProgramFile.read(file).steps(baxter)
    assert (first.part, first.tool, second.tool) == ("ball", LEFT, "")
    for entry, message in (("{part: 3}", r"attach\.part"), ("{prt: ball}", "part and, where wanted, tool")):
        file.write_text(f"start: [0]\nsteps:\n- attach: {entry}\n")
        with pytest.raises(mp.errors.FileFormatError, match=message):
            ProgramFile.read(file).steps(baxter)
