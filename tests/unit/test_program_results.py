"""Programs as pictures, in the viewer, in files and from a shell."""

import numpy as np
import pinocchio as pin
import pytest
from program_cell import part_pose, placed_part

import manipplan as mp
from manipplan.cli import main
from manipplan.viz.figure import draw_figure
from manipplan.viz.motions import find_moved_parts
from manipplan.viz.viewer import plan_viewer


@pytest.mark.slow
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


@pytest.mark.slow
def test_a_part_that_appears_in_the_hand_is_shown_from_then_on(hand):
    pytest.importorskip("viser")
    ball = mp.Sphere(radius=0.02, position=(0, 0, 0.04), name="ball")
    steps = [mp.MoveTo(hand.neutral + 0.1), mp.Attach(ball), mp.MoveTo("default"), mp.Detach("ball")]
    made = mp.sequence(hand, "default", steps)
    (part,) = find_moved_parts(made)
    assert part.at(0.0, hand, hand.neutral) is None
    assert part.is_held((made.marks[1].begin + made.duration) / 2) and not part.is_held(made.duration)
    with made.show(port=0, open_browser=False) as page:
        seen = []
        for t in (0.0, made.duration):
            page.time = t
            seen.append(page.stage.parts[0].root.visible)
        assert seen == [False, True]


@pytest.mark.slow
def test_pictures_of_a_program(program, planar, tmp_path):
    assert "\n" not in repr(program) and len(repr(program)) <= 200
    assert '<img alt="Program(' in program._repr_html_()
    left, right = draw_figure(program).subfigs
    labels = [text.get_text() for text in left.axes[0].texts]
    assert {"table", "post", "part", "part, put down"} <= set(labels)
    told = ", ".join(text.get_text() for text in right.axes[0].texts)
    assert all(f"{mark.step} {mark.name}" in told for mark in program.marks)
    flat_one = mp.sequence(planar, [0.4, 0.6, 0.8], [mp.MoveTo([1.0, -0.3, 0.25])])
    assert len(draw_figure(flat_one).subfigs) == 2
    program.save(tmp_path / "made")
    assert main(["view", str(tmp_path / "made"), "--record", str(tmp_path / "motion.html")]) == 0
    assert (tmp_path / "motion.html").stat().st_size > 1e6
    rows = (tmp_path / "made" / "marks.csv").read_text().splitlines()
    assert rows[0] == "step,name,begin,path_begin,tool_speed,blend,path_blend"
    begins = [row.split(",")[3] for row in rows[1:]]
    assert begins == ["" if mark.path_begin is None else str(mark.path_begin) for mark in program.marks] and any(begins)
    assert [row.split(",")[1] for row in rows[1:]] == [mark.name for mark in program.marks]
    assert float(rows[2].split(",")[2]) == program.marks[1].begin
    assert (tmp_path / "made" / "program.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
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
    with pytest.raises(mp.errors.FileFormatError, match="changed since"):
        mp.Program.load(tmp_path / "made")
    (tmp_path / "made" / "program.json").write_text(text.replace('"version": 1', '"version": 7', 1))
    with pytest.raises(mp.errors.FileFormatError, match="this is version 7"):
        mp.Program.load(tmp_path / "made")
    (tmp_path / "made" / "program.json").write_text(text)
    part = tmp_path / "made" / "part_1.json"
    part.write_text(part.read_text().replace('"version": ', '"version": 9', 1))
    with pytest.raises(mp.errors.FileFormatError, match=r"part_1\.json.*this is version 9"):
        mp.Program.load(tmp_path / "made")
    part.unlink()
    with pytest.raises(mp.errors.FileFormatError, match=r"part_1\.json"):
        mp.Program.load(tmp_path / "made")


@pytest.mark.slow
def test_parts_go_to_controllers(tmp_path):
    arm = mp.load_robot("ur5")
    away = arm.neutral + [0.3, -0.4, 0.5, 0.2, 0.3, 0.0]
    made = mp.sequence(arm, arm.neutral, [mp.MoveTo(away), mp.Wait(0.5), mp.MoveTo(arm.neutral)])
    first, mark, second = made.in_order
    assert (first, second) == made.parts and mark is made.marks[1]
    for k, part in enumerate(made.parts):
        part.trajectory.to_urscript(tmp_path / f"part_{k}.script", name=f"part_{k}")
        assert f"def part_{k}():" in (tmp_path / f"part_{k}.script").read_text()
    for kind in ("csv", "json", "ros", "npz"):
        getattr(made.trajectory, f"to_{kind}")(tmp_path / f"all.{kind}")
        again = getattr(mp.Trajectory, f"from_{kind}")(tmp_path / f"all.{kind}")
        np.testing.assert_allclose(again.q, made.trajectory.q, atol=1e-9)


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


@pytest.mark.slow
def test_a_program_from_a_shell(tmp_path, capsys):
    (tmp_path / "scene.yaml").write_text(
        "obstacles: [{shape: box, size: [0.9, 1.6, 0.04], position: [0.6, 0, -0.02], name: table}]\n"
    )
    (tmp_path / "program.yaml").write_text(PROGRAM)
    assert main(["run", str(tmp_path / "program.yaml"), "--out", str(tmp_path / "made")]) == 0
    assert "4 steps, all checks passed" in capsys.readouterr().out
    assert [mark.name for mark in mp.Program.load(tmp_path / "made").marks] == ["MoveTo", "MoveAlong", "Wait", "MoveTo"]


@pytest.mark.slow
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
