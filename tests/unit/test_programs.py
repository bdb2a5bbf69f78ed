"""Programs of moves: choice, parts, blends, stops, files, bad input."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.cli import main
from manipplan.jobs.programs.assemble import assemble
from manipplan.jobs.programs.blend import is_corner
from manipplan.jobs.programs.courses import Motion
from manipplan.jobs.programs.legs import read_steps
from manipplan.jobs.programs.states import State
from manipplan.paths.joint import cut
from manipplan.paths.tolerance import BETWEEN
from manipplan.viz.programs.figure import program_figure
from manipplan.viz.programs.moved import moved_parts
from manipplan.viz.viewer import plan_viewer

DOWN = np.diag([1.0, -1.0, -1.0, 1.0])


def pose_at(x, y, z, turn=0.0):
    pose = DOWN.copy()
    pose[:3, :3] = pin.rpy.rpyToMatrix(0, 0, turn) @ DOWN[:3, :3]
    pose[:3, 3] = x, y, z
    return pose


@pytest.fixture(scope="module")
def hand():
    """A Panda whose hand is open."""
    return mp.load_robot("panda", locked={"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04})


@pytest.fixture(scope="module")
def cell():
    """A table with a post and a part."""
    return mp.Scene(
        [
            mp.Box(size=(0.9, 1.6, 0.04), position=(0.6, 0.0, -0.02), name="table"),
            mp.Box(size=(0.1, 0.1, 0.3), position=(0.45, 0.0, 0.15), name="post"),
            mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, 0.051), name="part"),
        ]
    ).allow("part", "table")


@pytest.fixture(scope="module")
def steps():
    return [
        mp.MoveTo(pose_at(0.45, 0.3, 0.09), approach=0.1),
        mp.Attach("part"),
        mp.MoveAlong([0, 0, -0.1]),
        mp.MoveTo([pose_at(0.45, -0.3, 0.09), pose_at(0.45, -0.3, 0.09, 1.57)], approach=0.1),
        mp.Detach("part"),
        mp.MoveAlong([0, 0, -0.1]),
        mp.Wait(0.5),
        mp.MoveTo("default"),
    ]


@pytest.fixture(scope="module")
def program(hand, cell, steps):
    return mp.sequence(hand, "default", steps, cell, blend=0.05)


def test_a_part_is_picked_carried_and_placed(hand, cell, program):
    assert program.passed
    assert [mark.name for mark in program.marks] == [
        "MoveTo", "Attach", "MoveAlong", "MoveTo", "Detach", "MoveAlong", "Wait", "MoveTo",
    ]  # fmt: skip
    assert [list(part.robot.carried) for part in program.parts] == [[], ["part"], [], []]
    assert ["part" in part.scene.names for part in program.parts] == [True, False, True, True]
    for part in program.parts:
        report = mp.check(part.robot, part.trajectory, part.scene)
        assert report.passed, report.faults
    _, scene, q = program.final_state
    np.testing.assert_allclose(q, hand.neutral, atol=1e-9)
    placed = scene.obstacles[scene.names.index("part")]
    np.testing.assert_allclose(placed.pose.translation, [0.45, -0.3, 0.051], atol=1e-4)


def test_one_trajectory_with_marks(program):
    assert program.trajectory.duration == pytest.approx(sum(p.trajectory.duration for p in program.parts) + 0.5)
    for part, begin in zip(program.parts, program.begins, strict=True):
        np.testing.assert_allclose(
            program.trajectory(begin + part.trajectory.duration / 3), part.trajectory(part.trajectory.duration / 3), atol=1e-9
        )
    waiting = next(mark.begin for mark in program.marks if mark.name == "Wait")
    assert np.abs(program.trajectory(waiting + 0.25, order=1)).max() == 0.0
    assert [mark.begin for mark in program.marks] == sorted(mark.begin for mark in program.marks)


def test_approach_and_retreat_are_straight(hand, program):
    """The tool stays on the vertical line over the part while it approaches, but for the blend at its upper end."""
    kinematics = hand.kinematics()
    last = kinematics.pose(program.parts[0].trajectory(np.linspace(0, program.parts[0].trajectory.duration, 4000)))
    near = last[last[:, 2, 3] < 0.09 + 0.04]
    assert np.abs(near[:, :2, 3] - [0.45, 0.3]).max() < 2e-4
    first = kinematics.pose(program.parts[2].trajectory(np.linspace(0, program.parts[2].trajectory.duration, 2000)))
    low = first[first[:, 2, 3] < 0.09 + 0.04]
    assert len(low) > 10
    assert np.abs(low[:, :2, 3] - [0.45, -0.3]).max() < 2e-4


def test_blends_leave_out_stops_and_stay_near_corners(hand, cell, steps, program):
    sharp = mp.sequence(hand, "default", steps, cell)
    assert not program.stops
    assert len(sharp.stops) == 3
    assert program.duration < sharp.duration
    for stop in sharp.stops:
        assert np.abs(sharp.trajectory(stop, order=1)).max() < 1e-3
        corner = hand.kinematics().pose(sharp.trajectory(stop))[:3, 3]
        t = np.linspace(0, program.duration, 20_000)
        way = hand.kinematics().pose(program.trajectory(t))[:, :3, 3]
        assert np.linalg.norm(way - corner, axis=1).min() <= 0.05
    moving = np.abs(program.trajectory(np.linspace(0.05, program.parts[0].trajectory.duration - 0.05, 500), order=1)).max(
        axis=1
    )
    assert moving.min() > 0.01


def test_the_choice_is_that_of_all_choices(planar):
    """Of a planar arm with two grasps at each of two places: the program with the largest minimum of all four that are possible."""
    start = np.array([0.4, 0.6, 0.8])
    kinematics = planar.kinematics()
    goals = [[np.array([0.9, 0.9, 0.9]), np.array([1.0, -0.3, 0.25])], [np.array([1.4, 1.2, -0.5]), np.array([1.2, -0.4, 2.0])]]
    whole = mp.sequence(planar, start, [mp.MoveTo(each) for each in goals])
    least = []
    for one in goals[0]:
        for other in goals[1]:
            first = mp.plan(planar, start, one, mp.Scene())
            second = mp.plan(planar, one, other, mp.Scene())
            least.append(min(first.report.min_manipulability, second.report.min_manipulability))
    assert whole.min_manipulability >= max(least) * 0.99
    assert set(whole.goals) == {0, 1}
    assert kinematics.manipulability(whole.trajectory.q[-1]) == pytest.approx(
        kinematics.manipulability(goals[1][whole.goals[1]])
    )


UPRIGHT = [pose_at(0.45, 0.3, 0.09, turn) for turn in np.arange(4) * np.pi / 2]


def carried_to(goal, *, first=None):
    """Steps that take up the part and bring it to a goal."""
    first = first or [mp.MoveTo(UPRIGHT, approach=0.1)]
    return [*first, mp.Attach("part"), mp.MoveAlong([0, 0, -0.1]), mp.MoveTo(goal, approach=0.1), mp.Detach("part")]


def part_pose(x, y, z, turn):
    pose = np.eye(4)
    pose[:3, :3] = pin.rpy.rpyToMatrix(0, 0, turn)
    pose[:3, 3] = x, y, z
    return pose


def placed_part(program):
    _, scene, _ = program.final_state
    return scene.obstacles[scene.names.index("part")].pose.homogeneous


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
        except mp.InvalidInputError as error:
            least.append(0.0)
            assert "out of reach" in str(error) or "in collision" in str(error) or "collides" in str(error)
    assert max(least) > 1.05 * min(least)
    assert whole.min_manipulability >= max(least) * 0.99
    assert least[whole.goals[0]] >= max(least) * 0.99


def test_free_axes_and_tolerances_of_a_part(hand, cell):
    place = part_pose(0.45, -0.3, 0.053, 0.4)
    turned = placed_part(mp.sequence(hand, "default", carried_to(mp.PoseGoal(place, of="part", free_axis=[0, 0, 1])), cell))
    np.testing.assert_allclose(turned[:, 2:], place[:, 2:], atol=3e-6)
    tolerance = mp.Tolerance(position=0.002, rotation=0.1)
    made = mp.sequence(hand, "default", carried_to(mp.PoseGoal(place, of="part", tolerance=tolerance)), cell)
    off = np.linalg.inv(place) @ placed_part(made)
    assert np.linalg.norm(off[:3, 3]) <= 0.002 + 1e-6
    assert np.arccos(np.clip((np.trace(off[:3, :3]) - 1) / 2, -1, 1)) <= 0.1 + 1e-6


def test_a_part_is_taken_up_twice(hand, cell):
    """Where it is after the first place depends on the grasp; its last pose does not."""
    steps = carried_to([pose_at(0.45, -0.3, 0.09, turn) for turn in (0.0, 1.0)])
    away = [mp.MoveAlong([0, 0, -0.1])]
    again = [pose_at(0.45, -0.3, 0.09, turn) for turn in (0.3, 0.3 + np.pi / 2)]
    place = part_pose(0.5, 0.25, 0.051, 0.7)
    steps += [*away, *carried_to(mp.PoseGoal(place, of="part"), first=[mp.MoveTo(again, approach=0.1)]), *away]
    made = mp.sequence(hand, "default", steps, cell, blend=0.05)
    np.testing.assert_allclose(placed_part(made), place, atol=3e-6)


def test_plan_to_a_pose_of_a_carried_part(hand):
    ball = mp.Box(size=(0.05, 0.03, 0.02), position=(0.02, 0.0, 0.05), rotation=(0.1, 0.2, 0.3), name="bar")
    carrying = hand.attach(ball)
    place = part_pose(0.4, 0.3, 0.4, 0.5)
    made = mp.plan(carrying, "default", mp.PoseGoal(place @ DOWN, of="bar"))
    reached = carrying.kinematics().pose(made.trajectory.q[-1]) @ carrying.carried["bar"].solid.pose.homogeneous
    np.testing.assert_allclose(reached, place @ DOWN, atol=3e-6)
    with pytest.raises(mp.UnknownNameError, match=r"goal\.of: got 'bra'; allowed: did you mean bar"):
        mp.plan(carrying, "default", mp.PoseGoal(place, of="bra"))
    with pytest.raises(mp.InvalidInputError, match=r"goal\.free_axis: .* it is 8\.81 mm beside that of bar"):
        mp.plan(carrying, "default", mp.PoseGoal(place, of="bar", free_axis=[0, 0, 1]))


def seam_steps(speed):
    seam = mp.CartesianPath.line(pose_at(0.4, -0.2, 0.3), pose_at(0.4, 0.2, 0.3))
    return [mp.MoveAlong(seam, tool_speed=speed), mp.MoveAlong([0, 0, -0.1], tool_speed=0.05), mp.MoveTo("default")]


@pytest.mark.parametrize("blend", [0.0, 0.02])
def test_the_tool_speed_is_constant(hand, blend, tmp_path):
    made = mp.sequence(hand, "default", seam_steps(0.1), blend=blend)
    assert made.passed
    assert len(made.stops) == (3 if blend == 0 else 0)
    assert made.marks[2].tool_speed is None
    for mark, asked in zip(made.marks[:2], (0.1, 0.05), strict=True):
        told = mark.tool_speed
        assert told.asked == asked
        assert max(told.ramps) < 0.1 * told.length
        t = np.linspace(told.begin, told.end, 4000)  # measured again, by finite differences
        way = hand.kinematics().pose(made.trajectory(t))[:, :3, 3]
        speed = np.linalg.norm(np.diff(way, axis=0), axis=1) / np.diff(t)
        assert 0.99 * asked * (1 - 1e-4) <= speed.min() <= speed.max() <= asked * (1 + 1e-4)
        assert told.length > (0.39 if asked == 0.1 else 0.09) - 2 * blend
    assert f"tool speed   {made.marks[0].tool_speed}" in str(made)
    made.save(tmp_path / "made")
    assert mp.Program.load(tmp_path / "made").marks[:2] == made.marks[:2]


def test_a_tool_speed_that_is_not_possible_is_refused_with_the_fastest(hand):
    steps = seam_steps(3.0)
    with pytest.raises(mp.InvalidInputError, match=r"steps\[0\]\.tool_speed: got 3\.0; allowed: at most [\d.]+ m/s") as caught:
        mp.sequence(hand, "default", steps)
    fastest = float(caught.value.allowed.split()[2])
    made = mp.sequence(hand, "default", seam_steps(fastest))
    assert made.marks[0].tool_speed.is_steady
    with pytest.raises(mp.InvalidInputError, match=r"steps\[0\]\.tool_speed"):
        mp.sequence(hand, "default", seam_steps(1.1 * fastest))


def test_constraints_of_a_move(hand):
    level = mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.1)
    steps = [mp.MoveTo(pose_at(0.2, 0.45, 0.35), constraints=[level]), mp.MoveTo(pose_at(0.4, -0.3, 0.4))]
    made = mp.sequence(hand, "default", steps, blend=0.05)
    end = made.marks[1].begin / made.duration
    path = cut(made.trajectory.path(), 0.0, end)
    axes = hand.kinematics().pose(path(np.linspace(0, 1, 3000)))[:, :3, 2]
    assert np.arccos(np.clip(-axes[:, 2], -1, 1)).max() <= 0.1 + 1e-6


def test_the_viewer_shows_parts_where_they_are(program, hand):
    pytest.importorskip("viser")
    with program.show(port=0, open_browser=False) as page:
        (figure,) = page.stage.parts
        marks = {mark.name: mark.begin for mark in program.marks}
        assert not page.motion.robot.carried and "part" not in page.motion.scene.names
        for t in (0.0, 0.5 * marks["Attach"], (marks["Attach"] + marks["Detach"]) / 2, program.duration):
            page.time = t
            k = max(k for k, begin in enumerate(program.begins) if begin <= t)
            robot, scene = program.parts[k].robot, program.parts[k].scene
            if robot.carried:
                data = robot.model.createData()
                pin.framesForwardKinematics(robot.model, data, program.trajectory(t))
                wanted = data.oMf[robot.model.getFrameId(robot.tool)] * robot.carried["part"].solid.pose
            else:
                wanted = scene.obstacles[scene.names.index("part")].pose
            np.testing.assert_allclose(figure.root.position, wanted.translation, atol=1e-6)
            assert dict(page.motion.values(t))["carries"] == ("part" if robot.carried else "nothing")
        page.time = (marks["Wait"] + program.marks[-1].begin) / 2
        assert dict(page.motion.values(page.time))["step"] == "6 Wait"
        assert page._chart.svg().count('<g class="mark">') == len(program.marks)
        assert "A program of moves." in plan_viewer.about(page.motion)
        assert f'<iframe src="{page.url}"' in page._repr_html_()


def test_a_part_that_appears_in_the_hand_is_shown_from_then_on(hand):
    pytest.importorskip("viser")
    ball = mp.Sphere(radius=0.02, position=(0, 0, 0.04), name="ball")
    steps = [mp.MoveTo(hand.neutral + 0.1), mp.Attach(ball), mp.MoveTo("default"), mp.Detach("ball")]
    made = mp.sequence(hand, "default", steps)
    (part,) = moved_parts(made)
    assert part.at(0.0, np.eye(4)) is None
    assert part.is_held((made.marks[1].begin + made.duration) / 2) and not part.is_held(made.duration)
    with made.show(port=0, open_browser=False) as page:
        seen = []
        for t in (0.0, made.duration):
            page.time = t
            seen.append(page.stage.parts[0].root.visible)
        assert seen == [False, True]


def test_pictures_of_a_program(program, planar, tmp_path):
    assert "\n" not in repr(program) and len(repr(program)) <= 200
    assert '<img alt="Program(' in program._repr_html_()
    left, right = program_figure(program).subfigs
    labels = [text.get_text() for text in left.axes[0].texts]
    assert {"table", "post", "part", "part, put down"} <= set(labels)
    told = ", ".join(text.get_text() for text in right.axes[0].texts)
    assert all(f"{mark.step} {mark.name}" in told for mark in program.marks)
    flat_one = mp.sequence(planar, [0.4, 0.6, 0.8], [mp.MoveTo([1.0, -0.3, 0.25])])
    assert len(program_figure(flat_one).subfigs) == 2
    program.save(tmp_path / "made")
    assert main(["view", str(tmp_path / "made"), "--record", str(tmp_path / "motion.html")]) == 0
    assert (tmp_path / "motion.html").stat().st_size > 1e6
    rows = (tmp_path / "made" / "marks.csv").read_text().splitlines()
    assert rows[0] == "step,name,begin"
    assert [row.split(",")[1] for row in rows[1:]] == [mark.name for mark in program.marks]
    assert float(rows[2].split(",")[2]) == program.marks[1].begin
    assert (tmp_path / "made" / "program.png").read_bytes().startswith(b"\x89PNG")


def test_saved_and_loaded(program, tmp_path):
    files = program.save(tmp_path / "made")
    assert all(file.is_file() for file in files)
    again = mp.Program.load(tmp_path / "made")
    assert str(again) == str(program)
    assert again.trajectory.digest == program.trajectory.digest
    assert list(again.parts[1].robot.carried) == ["part"]
    ros = mp.Trajectory.from_ros(tmp_path / "made" / "trajectory.yaml")
    np.testing.assert_allclose(ros.q, program.trajectory.q, atol=1e-9)
    text = (tmp_path / "made" / "program.json").read_text()
    (tmp_path / "made" / "program.json").write_text(text.replace('"begin"', '"begin" ', 1).replace("MoveTo", "MoveAt", 1))
    with pytest.raises(mp.FileFormatError, match="changed since"):
        mp.Program.load(tmp_path / "made")
    (tmp_path / "made" / "program.json").write_text(text.replace('"version": 1', '"version": 7', 1))
    with pytest.raises(mp.FileFormatError, match="this is version 7"):
        mp.Program.load(tmp_path / "made")
    (tmp_path / "made" / "program.json").write_text(text)
    part = tmp_path / "made" / "part_1.json"
    part.write_text(part.read_text().replace('"version": ', '"version": 9', 1))
    with pytest.raises(mp.FileFormatError, match=r"part_1\.json.*this is version 9"):
        mp.Program.load(tmp_path / "made")
    part.unlink()
    with pytest.raises(mp.FileFormatError, match=r"part_1\.json"):
        mp.Program.load(tmp_path / "made")


def test_cutting_a_path():
    rng = np.random.default_rng(0)
    path = mp.JointPath.spline([0.0, 0.3, 0.7, 1.0], rng.normal(size=(4, 7)))
    for begin, end in ((0.1, 0.2), (0.1, 0.5), (0.35, 0.95), (0.0, 0.7), (0.3, 1.0), (0.0, 1.0)):
        part = cut(path, begin, end)
        s = np.linspace(0.001, 0.999, 50)
        np.testing.assert_allclose(part(s), path(begin + s * (end - begin)), atol=1e-12)


def test_corners():
    line = mp.JointPath.line([0, 0], [1, 0])
    assert is_corner(line, mp.JointPath.line([1, 0], [1, 1]))
    assert not is_corner(line, mp.JointPath.line([1, 0], [3, 0]))


def test_a_part_let_go_in_the_air_is_told(hand, cell, steps):
    high = [*steps[:3], mp.MoveTo(pose_at(0.45, -0.3, 0.3)), mp.Detach("part"), mp.MoveTo("default")]
    scene = mp.Scene(cell.obstacles)  # nothing may touch: the part keeps its distance to the table
    lifted = mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, 0.053), name="part")
    scene = scene.without("part") + mp.Scene([lifted])
    made = mp.sequence(hand, "default", high, scene)
    assert any("let go in the air" in each for each in made.warnings)


def test_constraints_are_in_the_report(hand):
    level = mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.1)
    made = mp.sequence(hand, "default", [mp.MoveTo(pose_at(0.2, 0.45, 0.35), constraints=[level])])
    (figure,) = made.parts[0].report.constraints
    assert figure.proven
    assert figure.name.startswith("steps[0], tilt of tool axis")
    assert "constraint   steps[0]" in str(made)


def test_a_motion_there_and_back_stops_between(hand):
    """A blend cannot round a turn back; a goal where the arm is already is no motion."""
    near = hand.neutral + 0.2
    made = mp.sequence(hand, "default", [mp.MoveTo(near), mp.MoveTo(near), mp.MoveTo("default")], blend=0.05)
    assert made.passed
    assert len(made.stops) == 1


def test_marks_tell_when_a_path_begins(hand):
    path = mp.CartesianPath.line(pose_at(0.4, -0.2, 0.3), pose_at(0.4, 0.2, 0.3))
    made = mp.sequence(hand, "default", [mp.MoveAlong(path)])
    (mark,) = made.marks
    assert mark.begin == 0.0
    assert 0 < mark.path_begin < made.duration
    np.testing.assert_allclose(hand.kinematics().pose(made.trajectory(mark.path_begin)), path(0.0), atol=2e-4)


def test_parts_far_from_a_hand_are_told(hand, cell):
    steps = [mp.MoveTo(pose_at(0.45, 0.3, 0.3)), mp.Attach("part"), mp.MoveTo("default")]
    made = mp.sequence(hand, "default", steps, cell)
    assert any("steps[1]: part is taken up" in each for each in made.warnings)
    ball = mp.Sphere(radius=0.02, position=(0, 0, 0.04), name="ball")
    let_go = [mp.MoveTo(hand.neutral + 0.1), mp.Attach(ball), mp.Detach("ball"), mp.MoveTo("default")]
    assert any("steps[2]: ball is let go in the air" in each for each in mp.sequence(hand, "default", let_go).warnings)


BAD = {
    "no motion": ([mp.MoveTo("default")], r"steps: got \['MoveTo'\]; allowed: steps with at least one motion"),
    "no motion but a part": ([mp.Attach("part"), mp.Wait(1)], "steps with at least one motion"),
    "no steps": ([], "steps: got"),
    "no step": ([3], r"steps\[0\]: got 3"),
    "unknown part": ([mp.Attach("prt")], r"steps\[0\]\.part: got 'prt'; allowed: did you mean part"),
    "nothing to put down": ([mp.Detach("part")], r"steps\[0\]\.name: got 'part'"),
    "taken twice": ([mp.Attach("part"), mp.Attach("part")], r"steps\[1\]\.part"),
    "out of reach": (
        [mp.MoveTo("default"), mp.MoveTo(pose_at(2.0, 0.0, 0.3))],
        r"steps\[1\]\.goal: .*out of reach: the nearest configuration found leaves the tool",
    ),
    "no part": (
        [mp.MoveTo(mp.PoseGoal(DOWN, of="part"))],
        r"steps\[0\]\.goal\.of: got 'part'; allowed: none: the arm carries nothing then",
    ),
    "part put down": (
        [mp.Attach("part"), mp.Detach("part"), mp.MoveTo(["default", mp.PoseGoal(DOWN, of="part")])],
        r"steps\[2\]\.goal\[1\]\.of: got 'part'",
    ),
    "another part": (
        [mp.Attach("part"), mp.MoveTo(mp.PoseGoal(DOWN, of="prat"))],
        r"steps\[1\]\.goal\.of: got 'prat'; allowed: did you mean part",
    ),
    "turn in the hand not known": (
        [
            mp.MoveAlong(
                mp.CartesianPath.line(pose_at(0.45, 0.3, 0.3), pose_at(0.45, 0.3, 0.2)), task=mp.Task.pointing([0, 0, 1])
            ),
            mp.MoveAlong([0, 0, 0.1]),
            mp.Attach("part"),
            mp.MoveTo(mp.PoseGoal(DOWN, of="part")),
        ],
        r"steps\[3\]\.goal\.of: got 'part'; allowed: a part that was taken up and put down after a MoveTo",
    ),
    "unknown state": ([mp.MoveTo("redy")], r"steps\[0\]\.goal: got 'redy'"),
    "approach to a configuration": ([mp.MoveTo("default", approach=0.1)], "a pose of the tool, since there is an approach"),
    "turns in place": (
        [
            mp.MoveTo("default"),
            mp.MoveAlong(mp.CartesianPath.line(pose_at(0.4, 0.3, 0.4), pose_at(0.4, 0.3, 0.4, 1)), tool_speed=0.1),
        ],
        r"steps\[1\]\.tool_speed: got 0.1; allowed: None for this path: at s = .* it turns the tool in place",
    ),
    "path out of reach": (
        [mp.MoveAlong(mp.CartesianPath.line(pose_at(0.5, 0.3, 0.4), pose_at(1.5, 0.3, 0.4)))],
        r"steps\[0\]\.path, position \d+ of 0 to 19 \(s = [\d.]+\): .* the arm stays [\d.]+ mm and [\d.]+° away",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_programs(hand, cell, name):
    given, message = BAD[name]
    with pytest.raises(mp.InvalidInputError, match=message):
        mp.sequence(hand, "default", given, cell)


@pytest.mark.parametrize(
    ("steps", "message"),
    [
        (
            [mp.MoveTo(pose_at(0.5, 0.3, 0.4)), mp.MoveAlong([0.6, 0, 0])],
            r"steps\[1\]: path, position \d+ of 0 to 39 .* is not a pose within reach and joint limits; the arm stays [\d.]+ mm",
        ),
        (
            [mp.MoveTo(pose_at(0.5, 0.3, 0.4), approach=[1.2, 0, 0])],
            r"steps\[0\]: no straight approach: path, position .* the arm stays [\d.]+ mm",
        ),
        (
            [mp.MoveTo(pose_at(0.5, 0.3, 0.2)), mp.MoveAlong([0, 0, 0.3])],
            r"steps\[1\]: path, position .* in the best of them panda_leftfinger_\d and table overlap by [\d.]+ mm",
        ),
    ],
)
def test_ways_that_do_not_exist_are_told(hand, cell, steps, message):
    with pytest.raises(mp.PlanningError, match=message):
        mp.sequence(hand, "default", steps, cell)


def test_blends_never_overlap(hand, cell, steps):
    made = mp.sequence(hand, "default", steps, cell, blend=2.0)
    assert made.passed
    placed = hand.kinematics().pose(made.parts[1].trajectory.q[-1])
    np.testing.assert_allclose(placed[:3, 3], [0.45, -0.3, 0.09], atol=1e-5)


def test_blends_keep_the_clearance():
    """A ball inside the corner: the wide blend would touch it, and is halved."""
    hand = mp.load_robot("panda")  # its hand is closed
    corner = [pose_at(0.55, -0.2, 0.4), pose_at(0.55, 0.25, 0.4), pose_at(0.2, 0.25, 0.4)]
    steps = [mp.MoveAlong(mp.CartesianPath.line(one, other)) for one, other in pairwise(corner)]
    free = mp.sequence(hand, "default", steps, blend=0.15)
    cut_off = hand.kinematics().pose(free.trajectory(np.linspace(0, free.duration, 8000)))[:, :3, 3]
    away = np.linalg.norm(cut_off - corner[1][:3, 3], axis=1)
    ball = mp.Sphere(radius=0.005, position=cut_off[away.argmin()] + [0, 0, -0.006], name="ball")
    made = mp.sequence(hand, "default", steps, mp.Scene([ball]), blend=0.15, clearance=0.005)
    assert made.passed and made.parts[0].report.proven_clearance >= 0.005
    way = hand.kinematics().pose(made.trajectory(np.linspace(0, made.duration, 8000)))[:, :3, 3]
    assert np.linalg.norm(way - corner[1][:3, 3], axis=1).min() < 0.5 * away.min()


def test_parts_go_to_controllers(tmp_path):
    arm = mp.load_robot("ur5")
    away = arm.neutral + [0.3, -0.4, 0.5, 0.2, 0.3, 0.0]
    made = mp.sequence(arm, arm.neutral, [mp.MoveTo(away), mp.Wait(0.5), mp.MoveTo(arm.neutral)])
    for k, part in enumerate(made.parts):
        part.trajectory.to_urscript(tmp_path / f"part_{k}.script", name=f"part_{k}")
        assert f"def part_{k}():" in (tmp_path / f"part_{k}.script").read_text()
    for kind in ("csv", "json", "ros", "npz"):
        getattr(made.trajectory, f"to_{kind}")(tmp_path / f"all.{kind}")
        again = getattr(mp.Trajectory, f"from_{kind}")(tmp_path / f"all.{kind}")
        np.testing.assert_allclose(again.q, made.trajectory.q, atol=1e-9)


@pytest.mark.parametrize(
    ("picked", "placed", "message"),
    [
        (0.049, 0.1, r"steps\[1\]: part and table overlap by 1 mm; scene.allow"),
        (0.05, 0.1, r"steps\[1\]: part and table touch; scene.allow"),  # rounding would decide
        (0.051, 0.089, r"steps\[3\]: part and table touch"),
    ],
)
def test_a_part_that_touches_is_told(hand, cell, picked, placed, message):
    scene = cell.without("part") + mp.Scene([mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, picked), name="part")])
    steps = [mp.MoveTo(pose_at(0.45, 0.3, 0.09), approach=0.1), mp.Attach("part")]
    steps += [mp.MoveTo(pose_at(0.45, -0.3, placed), approach=0.1), mp.Detach("part"), mp.MoveTo("default")]
    with pytest.raises(mp.PlanningError, match=message):
        mp.sequence(hand, "default", steps, scene, seeding=mp.Seeding(time_limit=2.0))


@pytest.mark.parametrize("step", [mp.MoveTo(pose_at(0.45, 0.3, 0.3)), mp.MoveTo("default"), "along"])
def test_a_motion_that_does_not_do_its_step_fails_the_check(hand, step):
    state, start = State(robot=hand, scene=mp.Scene()), hand.neutral
    motion = Motion(step=0, path=mp.JointPath.line(start, start + 0.1), state=state)
    if step == "along":
        begin, end = hand.kinematics().pose(np.array([start, start + 0.1]))
        begin[2, 3] += 0.01
        step = mp.MoveAlong(mp.CartesianPath.line(begin, end))
        motion = replace(motion, workspace_path=step.path, task=mp.Task.pose(), tolerance=BETWEEN)
    legs = {leg.number: leg for leg in read_steps([step], hand, start)}
    made = assemble(
        [motion],
        state,
        state,
        [step],
        legs,
        goals={k: 0 for k, leg in legs.items() if leg.targets},
        blend=0.0,
        objective=mp.PathObjective(),
        clearance=0.0,
        torque=False,
    )
    assert not made.passed
    (fault,) = made.parts[0].report.faults
    assert fault.startswith("steps[0]: ")


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: mp.Wait(0), "seconds"),
        (lambda: mp.Wait("long"), "seconds"),
        (lambda: mp.Attach(3), "the name of an obstacle, or a shape"),
        (lambda: mp.MoveAlong([0, 0, 0]), "a way that is not zero"),
        (lambda: mp.MoveAlong("poses.csv"), "path"),
        (lambda: mp.MoveAlong([0, 0, 0.1], tool_speed=-1), "tool_speed"),
        (lambda: mp.MoveTo("default", approach=-0.1), "approach"),
        (lambda: mp.MoveTo("default", constraints=mp.HeldJoints("a")), "constraints"),
    ],
)
def test_bad_steps(make, message):
    with pytest.raises(mp.InvalidInputError, match=message):
        make()


PROGRAM = """
robot: panda
locked: {panda_finger_joint1: 0.03}
scene: scene.yaml
start: default
blend: 0.04
steps:
- move_to: {goal: {position: [0.45, 0.3, 0.2], rotation: [3.14159265, 0, 0]}}
- move_along: {way: [0, 0, 0.08], tool_speed: 0.1}
- wait: 0.2
- move_to: {goal: [{state: default}]}
"""
CARRY = """
robot: panda
locked: {panda_finger_joint1: 0.04, panda_finger_joint2: 0.04}
scene: scene.yaml
start: default
steps:
- move_to: {goal: {position: [0.45, 0.3, 0.09], rotation: [3.14159265, 0, 0]}}
- attach: part
- move_to: {goal: [{position: [0.45, -0.3, 0.3], rotation: [0, 0, 0.5], of: part}]}
- detach: part
"""


def test_a_program_from_a_shell(tmp_path, capsys):
    (tmp_path / "scene.yaml").write_text(
        "obstacles: [{shape: box, size: [0.9, 1.6, 0.04], position: [0.6, 0, -0.02], name: table}]\n"
    )
    (tmp_path / "program.yaml").write_text(PROGRAM)
    assert main(["run", str(tmp_path / "program.yaml"), "--out", str(tmp_path / "made")]) == 0
    assert "4 steps, all checks passed" in capsys.readouterr().out
    assert [mark.name for mark in mp.Program.load(tmp_path / "made").marks] == ["MoveTo", "MoveAlong", "Wait", "MoveTo"]


def test_a_part_is_carried_from_a_shell(tmp_path, capsys):
    (tmp_path / "scene.yaml").write_text(
        "obstacles: [{shape: box, size: [0.04, 0.04, 0.1], position: [0.45, 0.3, 0.05], name: part}]\n"
    )
    (tmp_path / "program.yaml").write_text(CARRY)
    assert main(["run", str(tmp_path / "program.yaml"), "--out", str(tmp_path / "made")]) == 0
    made = mp.Program.load(tmp_path / "made")
    np.testing.assert_allclose(placed_part(made), part_pose(0.45, -0.3, 0.3, 0.5), atol=3e-6)
    assert "let go in the air" in " ".join(capsys.readouterr().out.split())
    (tmp_path / "program.yaml").write_text(CARRY.replace("of: part", "of: prat"))
    assert main(["run", str(tmp_path / "program.yaml"), "--out", str(tmp_path / "again")]) == 2
    assert "steps[2].goal[0].of: got 'prat'; allowed: did you mean part?" in " ".join(capsys.readouterr().err.split())


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("start: default", "begin: default"), "keys start and steps"),
        (("blend: 0.04", "blnd: 0.04"), "did you mean blend"),
        (("wait: 0.2", "wait: -1"), r"steps\[2\]\.wait\.seconds"),
        (("- wait: 0.2", "- wiat: 0.2"), "did you mean wait"),
        (("way: [0, 0, 0.08], ", ""), r"steps\[1\]\.move_along\.path"),
        (("state: default", "state: defalt"), r"steps\[3\]\.move_to\.goal\[0\]\.state"),
        (("scene: scene.yaml", "scene: gone.yaml"), "gone.yaml"),
        (("locked: {panda_finger_joint1: 0.03}", "locked: [1]"), "locked in"),
        (("goal: [{state: default}]", "goal: [{state: default}], aproach: 0.1"), "did you mean approach"),
        (
            ("goal: [{state: default}]", "goal: [{state: default}], constraints: [{tilt_limt: 3}]"),
            r"steps\[3\]\.move_to\.constraints\[0\] .* did you mean tilt_limit",
        ),
    ],
)
def test_bad_program_files(tmp_path, capsys, change, message):
    (tmp_path / "scene.yaml").write_text("obstacles: []\n")
    (tmp_path / "program.yaml").write_text(PROGRAM.replace(*change))
    assert main(["run", str(tmp_path / "program.yaml"), "--out", str(tmp_path / "made")]) == 2
    error = capsys.readouterr().err
    assert __import__("re").search(message, " ".join(error.split())), error
    assert not (tmp_path / "made" / "program.json").exists()
