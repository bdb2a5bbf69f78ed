"""The command line: what it writes, its exit codes, and one-line errors without tracebacks."""

import os
import re
import shlex
import signal
import subprocess
import sys
import time
import tomllib
from importlib import import_module
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from chains import chain_file

import manipplan as mp
from manipplan.cli import COMMANDS, main

doctor = import_module("manipplan.cli.doctor")  # the package has its function under this name
START = ["0", "1.5", "-2"]


@pytest.fixture(scope="module")
def arm_file(tmp_path_factory):
    """A planar arm as a file, since the command takes files and names."""
    links = "".join(
        f'<link name="l{i}"><collision><origin xyz="0.5 0 0" rpy="0 1.5707963 0"/><geometry><cylinder radius="0.03" length="0.9"/>'
        f'</geometry></collision></link><joint name="j{i}" type="revolute"><parent link="{"base" if i == 0 else f"l{i - 1}"}"/>'
        f'<child link="l{i}"/><origin xyz="{0 if i == 0 else 1} 0 {0.1 * (i > 0)}"/><axis xyz="0 0 1"/>'
        '<limit lower="-4" upper="4" velocity="2" effort="10"/></joint>'
        for i in range(3)
    )
    file = tmp_path_factory.mktemp("arm") / "arm.urdf"
    tip = '<link name="tip"/><joint name="end" type="fixed"><parent link="l2"/><child link="tip"/><origin xyz="1 0 0"/></joint>'
    file.write_text(f'<robot name="arm"><link name="base"/>{links}{tip}</robot>')
    return str(file)


def plan_arguments(arm_file, folder, **changes):
    options = {"start": START, "goal": ["3.1", "-2", "2"], "out": [str(folder)], **changes}
    return ["plan", arm_file, *[word for key, values in options.items() for word in (f"--{key}", *values)]]


@pytest.mark.slow
def test_a_singular_plan_is_written_and_told_by_its_exit_code(tmp_path, capsys, monkeypatch):
    """Three rows of position for an arm whose last joint does not move the tool: the manipulability is zero everywhere."""
    monkeypatch.setattr(mp.Robot, "default_task", property(lambda robot: mp.Task.position()))
    joints = [
        ("revolute", "0 0 0.2", "0 0 0", "0 0 1", -3, 3),
        ("revolute", "0 0 0.1", f"{np.pi / 2} 0 0", "0 0 1", -1.5, 1.5),
        ("revolute", "0.3 0 0", f"0 {np.pi / 2} 0", "0 0 1", -2.5, 2.5),
    ]
    file = chain_file(tmp_path / "three.urdf", joints, "0 0 0.1")
    arguments = ["plan", str(file), "--start", "0", "0", "0", "--goal", "1", "0.5", "0.3", "--out", str(tmp_path / "out")]
    assert main([*arguments, "--acceleration", "9", "--measure", "yoshikawa"]) == 3
    shown = capsys.readouterr()
    assert "the path is SINGULAR" in shown.out and "all checks passed\n" not in shown.out
    assert "default" not in shown.out
    assert "trajectory.yaml" in shown.out
    trajectory = mp.Trajectory.from_csv(tmp_path / "out" / "trajectory.csv")
    np.testing.assert_allclose(trajectory.q[-1], [1, 0.5, 0.3], atol=1e-9)
    assert np.abs(trajectory.qd).max() > 0.5 and np.abs(trajectory(trajectory.t, 2)).max() < 9 * (1 + 1e-6)


def test_robots_lists_and_prints(arm_file, capsys):
    assert main(["robots", arm_file]) == 0
    assert "j2" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("changes", "code", "message"),
    [
        ({"start": ["0", "1"]}, 2, "start: got '0 1'; allowed: 3 numbers, one per joint (j0, j1, j2), not 2"),
        ({"goal": ["0", "90", "0"]}, 2, "-4 to 4 rad; it is 86 rad above; 90 degrees are 1.571 rad"),
        ({"acceleration": ["-1"]}, 2, "acceleration"),
        ({"goal": ["9", "0", "0"]}, 2, "goal[0] (j0): got 9.0"),
        ({"goal": ["nan", "0", "0"]}, 2, "finite"),
        ({"scene": ["no_such_scene.yaml"]}, 2, "scene: got 'no_such_scene.yaml'"),
        ({"degree": ["0"]}, 2, "degree: got 0"),
        ({"out": ["/proc/nowhere"]}, 2, "out: got '/proc/nowhere'; allowed: a folder that can be written"),
        ({"out": ["x" * 300]}, 2, "allowed: a folder that can be written (File name too long)"),
        ({"tool": ["tipp"]}, 2, "did you mean tip"),
    ],
)
def test_wrong_input_is_one_line(arm_file, tmp_path, capsys, changes, code, message):
    assert main(plan_arguments(arm_file, tmp_path / "out", **changes)) == code
    errors = [line for line in capsys.readouterr().err.splitlines() if not line.startswith("...")]
    assert len(errors) == 1
    assert message in errors[0]
    assert "Traceback" not in errors[0]
    assert list(tmp_path.rglob("trajectory*")) == []


def test_unknown_robot(capsys, tmp_path):
    assert main(["plan", "pnada", "--start", "0", "--goal", "1", "--out", str(tmp_path)]) == 2
    assert "did you mean panda" in capsys.readouterr().err


def test_no_path_is_exit_code_one(arm_file, tmp_path, capsys):
    scene = tmp_path / "cage.yaml"
    scene.write_text(
        "obstacles:\n- {shape: box, size: [0.05, 8, 1], position: [-0.4, 0, 0]}\n"
        "- {shape: box, size: [5, 0.02, 1], position: [2.6, 0, 0]}\n"
    )
    changes = {"start": ["0.5"] * 3, "goal": ["-0.5"] * 3, "scene": [str(scene)], "time-limit": ["60"]}
    assert main(plan_arguments(arm_file, tmp_path / "out", **changes)) == 1
    assert "it is proven that the goal cannot be reached" in capsys.readouterr().err


@pytest.fixture(scope="module")
def six_file(tmp_path_factory):
    """Six joints, the last three meeting: an arm that reaches poses and is read in no time."""
    text = '<robot name="six"><link name="l0"/>'
    for k, (axis, far) in enumerate(
        (("0 0 1", 0), ("0 1 0", 0.3), ("0 1 0", 0.4), ("0 0 1", 0.2), ("0 1 0", 0.2), ("0 0 1", 0))
    ):
        text += (
            f'<link name="l{k + 1}"/><joint name="j{k}" type="revolute"><parent link="l{k}"/><child link="l{k + 1}"/>'
            f'<origin xyz="0 0 {far}"/><axis xyz="{axis}"/><limit lower="-2.9" upper="2.9" velocity="2" effort="50"/></joint>'
        )
    file = tmp_path_factory.mktemp("six") / "six.urdf"
    file.write_text(f"{text}</robot>")
    return str(file)


@pytest.fixture(scope="module")
def seam(six_file, tmp_path_factory):
    """A CSV file of poses along a straight line."""
    pose = pin.SE3(np.array(mp.load_robot(six_file).kinematics().pose([0.2, 0.5, 1.0, 0.3, 0.6, 0.1])))
    x, y, z, w = pin.Quaternion(pose.rotation).coeffs()
    file = tmp_path_factory.mktemp("seam") / "seam.csv"
    points = [pose.translation + d * np.array([-1, 1, 0]) for d in (0.0, 0.04, 0.1)]
    rows = [",".join(f"{value:.15g}" for value in (*point, w, x, y, z)) for point in points]
    file.write_text("x,y,z,qw,qx,qy,qz\n" + "\n".join(rows) + "\n")
    return str(file)


@pytest.mark.slow
def test_improve_writes_all_files(six_file, tmp_path, capsys):
    start, goal = ["0.2", "0.5", "1.0", "0.3", "0.6", "0.1"], ["0.9", "0.7", "0.6", "0.1", "0.8", "0.4"]
    assert main(plan_arguments(six_file, tmp_path / "plan", start=start, goal=goal)) == 0
    shown = capsys.readouterr().out
    assert "all checks passed" in shown and "acceleration limits: default: full speed in 0.2 s" in shown
    middle = [1.2, 0.2, 0.5, 0.6, 0.3, 0.5]  # a detour
    path = mp.JointPath.spline([0.0, 0.5, 1.0], [[float(each) for each in start], middle, [float(each) for each in goal]])
    recorded = tmp_path / "log.csv"
    mp.retime(path, mp.load_robot(six_file)).slower(2.0).to_csv(recorded)
    arguments = ["improve", six_file, str(recorded), "--out", str(tmp_path / "out"), "--tolerance", "0.05", "0.5"]
    assert main(arguments) == 0
    shown = capsys.readouterr().out
    assert "improved: " in shown and "recorded  improved" in shown and "allowed: 50 mm" in shown
    before, after = (mp.Trajectory.from_csv(each) for each in (recorded, tmp_path / "out" / "trajectory.csv"))
    kinematics = mp.load_robot(six_file).kinematics()
    np.testing.assert_allclose(after.q[[0, -1]], before.q[[0, -1]], atol=1e-9)
    assert after.duration == before.duration
    assert kinematics.manipulability(after.q).mean() > kinematics.manipulability(before.q).mean()


def follow_arguments(six_file, seam, folder, **changes):
    options = {"positions": ["3"], "epsilon": ["0.8"], "out": [str(folder)], **changes}
    return ["follow", six_file, seam, *[word for key, values in options.items() for word in (f"--{key}", *values)]]


@pytest.mark.slow
def test_follow_the_position_only(six_file, seam, tmp_path, capsys):
    assert main(follow_arguments(six_file, seam, tmp_path / "out", only=["position"])) == 0
    assert "task position: all checks passed" in capsys.readouterr().out


@pytest.mark.slow
def test_follow_writes_all_files(six_file, seam, tmp_path, capsys):
    assert main(follow_arguments(six_file, seam, tmp_path / "out")) == 0
    shown = capsys.readouterr()
    assert "all checks passed" in shown.out and "° from the path" in shown.out and "refined" in shown.out
    names = {file.name for file in (tmp_path / "out").iterdir()}
    assert {"trajectory.csv", "trajectory.json", "trajectory.yaml", "report.json", "report.txt", "plan.png"} <= names
    assert mp.results.Report.from_json(tmp_path / "out" / "report.json").passed
    trajectory = mp.Trajectory.from_csv(tmp_path / "out" / "trajectory.csv")
    tool = mp.load_robot(six_file).kinematics().pose(trajectory(np.linspace(0, trajectory.duration, 50)))[:, :3, 3]
    ends = np.loadtxt(seam, delimiter=",", skiprows=1)[[0, -1], :3]
    np.testing.assert_allclose(tool[[0, -1]], ends, atol=1e-6)
    across = np.cross(tool - ends[0], (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0]))
    assert np.abs(across).max() < 1e-4
    shares = [int(line.split()[1]) for line in shown.err.splitlines() if line.startswith("...")]
    assert shares == sorted(shares) and shares[-1] == 100


@pytest.mark.slow
@pytest.mark.parametrize(
    ("changes", "code", "message"),
    [
        ({"positions": ["1"]}, 2, "positions: got 1"),
        ({"epsilon": ["0"]}, 2, "epsilon: got 0.0"),
        ({"epsilon": ["1e-9"]}, 1, "can be reached from position"),
        ({"scene": ["no_such_scene.yaml"]}, 2, "scene: got 'no_such_scene.yaml'"),
        ({"tolerance": ["-1", "0.1"]}, 2, "position: got -1.0"),
        ({"clearance": ["-1"]}, 2, "clearance: got -1.0"),
        ({"samples": ["0"]}, 2, "samples: got 0"),
        ({"samples": ["3", "3", "3"]}, 2, "samples: got"),
        ({"pointing": ["0", "0", "0"]}, 2, "axis"),
        ({"pointing": ["0", "0", "1"], "only": ["position"]}, 2, "only: got 'position'"),
        ({"closed": []}, 2, "the path's last pose is not its first"),
        ({"out": ["/proc/nowhere"]}, 2, "out: got '/proc/nowhere'"),
    ],
)
def test_wrong_input_to_follow_is_one_line(six_file, seam, tmp_path, capsys, changes, code, message):
    assert main(follow_arguments(six_file, seam, tmp_path / "out", **changes)) == code
    errors = [line for line in capsys.readouterr().err.splitlines() if not line.startswith("...")]
    assert len(errors) == 1
    assert message in errors[0]
    assert list(tmp_path.rglob("trajectory*")) == []


def test_improve_refuses_what_is_no_recording(arm_file, tmp_path, capsys):
    wrong = tmp_path / "wrong.csv"
    wrong.write_text("time,a\n0,1\n")
    assert main(["improve", arm_file, str(wrong), "--out", str(tmp_path / "out")]) == 2
    assert "a CSV with columns time, q_<joint>" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.fixture(scope="module")
def motion_file(arm_file, tmp_path_factory):
    """A motion of the planar arm from (0, 1.5, -2) to (1, 1, -1)."""
    robot = mp.load_robot(arm_file)
    file = tmp_path_factory.mktemp("motion") / "motion.csv"
    mp.retime(mp.JointPath.line([0.0, 1.5, -2.0], [1.0, 1.0, -1.0]), robot).to_csv(file)
    return str(file)


@pytest.mark.slow
def test_check_tells_by_its_exit_code_whether_a_motion_passes(arm_file, motion_file, tmp_path, capsys):
    scene = tmp_path / "scene.yaml"
    scene.write_text("obstacles:\n- {shape: sphere, radius: 0.2, position: [0.3, 2.4, 0.1], name: ball}\n")
    arguments = ["check", motion_file, "--robot", arm_file, "--start", *START, "--goal", "1", "1", "-1"]
    assert main(arguments) == 0
    shown = capsys.readouterr().out
    assert "acceleration limits: default" in shown and "all checks passed" in shown
    assert main([*arguments, "--scene", str(scene), "--acceleration", "1", "--measure", "smallest_singular_value"]) == 1
    shown = capsys.readouterr().out
    assert "CHECK FAILED" in shown and "failed       acceleration: " in shown and " of l2_0 and ball at " in shown
    assert main([*arguments, "--json"]) == 0
    (tmp_path / "report.json").write_text(capsys.readouterr().out)
    robot = mp.load_robot(arm_file)
    same = mp.check(robot, motion_file, start=[0.0, 1.5, -2.0], goal=[1.0, 1.0, -1.0])
    assert mp.results.Report.from_json(tmp_path / "report.json") == same
    (tmp_path / "saved").mkdir()
    (tmp_path / "saved" / "trajectory.csv").write_text(Path(motion_file).read_text())
    assert main(["check", str(tmp_path / "saved"), *arguments[2:]]) == 0


@pytest.mark.slow
def test_check_compares_the_tool_with_poses(six_file, seam, tmp_path, capsys):
    robot, file = mp.load_robot(six_file), tmp_path / "motion.npz"
    mp.follow(robot, mp.CartesianPath.from_csv(seam), positions=3, epsilon=0.8).trajectory.to_npz(file)
    arguments = ["check", str(file), "--robot", six_file, "--path", seam]
    assert main(arguments) == 0
    assert "its poses are at most" in capsys.readouterr().out
    assert main([*arguments, "--tolerance", "1e-9", "1e-9", "--pointing", "0", "0", "1"]) == 1
    assert "tool: the tool leaves the path by" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"robot": ["no_such_arm"]}, "name: got 'no_such_arm'"),
        ({"start": ["0", "1"]}, "start: got '0 1'; allowed: 3 numbers"),
        ({"goal": ["home"]}, "goal: got 'home'"),
        ({"clearance": ["-1"]}, "clearance: got -1.0"),
        ({"scene": ["no_such_scene.yaml"]}, "scene: got 'no_such_scene.yaml'"),
        ({"tolerance": ["0.1", "0.1"]}, "tolerance: got "),
        ({"path": ["no_such_poses.csv"]}, "existing file"),
        ({"measure": ["yoshi"]}, "did you mean yoshikawa"),
        ({"jerk": ["0"]}, "jerk"),
    ],
)
def test_wrong_input_to_check_is_one_line(arm_file, motion_file, capsys, changes, message):
    options = {"robot": [arm_file], **changes}
    assert main(["check", motion_file, *[word for key, values in options.items() for word in (f"--{key}", *values)]]) == 2
    errors = [line for line in capsys.readouterr().err.splitlines() if not line.startswith("...")]
    assert len(errors) == 1 and message in errors[0]


def test_check_refuses_what_is_no_motion(arm_file, six_file, motion_file, tmp_path, capsys):
    wrong = tmp_path / "wrong.csv"
    wrong.write_text("time,q_j0,q_j1,q_j2\n0,0,0,0\n0,1,1,1\n")
    for arguments, message in (
        ([str(wrong), "--robot", arm_file], "row 3, time: 0"),
        ([motion_file, "--robot", six_file], "j3, j4, j5 is missing"),
        ([str(tmp_path / "none.csv"), "--robot", arm_file], "existing file"),
        ([str(tmp_path / "none.xls"), "--robot", arm_file], "a trajectory file: .csv"),
    ):
        assert main(["check", *arguments]) == 2
        assert message in capsys.readouterr().err


@pytest.mark.slow
def test_a_study_outside_its_sources_tells_where_they_are(tmp_path):
    """As for somebody who installed the package alone: `studies` is not on the path."""
    root = Path(mp.__file__).parents[1]
    (tmp_path / "manipplan").symlink_to(root / "manipplan")
    code = (
        "import sys; from pathlib import Path; sys.path = [p for p in sys.path if Path(p).resolve() != Path(sys.argv[1])]\n"
        "from manipplan.cli import main; sys.exit(main(['study', 'kth2012', '--out', sys.argv[2]]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(root), str(tmp_path / "out")],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert done.returncode == 1
    assert "in a clone of the repository" in done.stderr and "Traceback" not in done.stderr


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "which is empty"),
        ("a,b,c\n1,2,3\n", "a first line x,y,z,qx,qy,qz,qw"),
        ("x,y,z,qw,qx,qy,qz\n", "at least two poses"),
        ("x,y,z,qw,qx,qy,qz\n1,1,0,1,0,0\n1,1.2,0,1,0,0,0\n", "row 2"),
        ("x,y,z,qw,qx,qy,qz\n1,1,0,1,0,0,0\n1,nan,0,1,0,0,0\n", "row 3"),
        ("x,y,z,qw,qx,qy,qz\n1,1,0,2,0,0,0\n1,1.2,0,1,0,0,0\n", "a quaternion qx, qy, qz, qw of length 1"),
        ("x,y,z,qw,qx,qy,qz\n1,1,0,1,0,0,0\n1,1,0,1,0,0,0\n", "at least two poses that differ"),
        ("x,y,z,qw,qx,qy,qz\n9,9,0,1,0,0,0\n9,8,0,1,0,0,0\n", "a pose within reach and joint limits; the arm stays"),
    ],
)
def test_poses_that_cannot_be_read_or_reached(six_file, tmp_path, capsys, text, message):
    file = tmp_path / "poses.csv"
    file.write_text(text)
    code = 4 if "within reach" in message else 2
    assert main(follow_arguments(six_file, str(file), tmp_path / "out")) == code
    assert message in capsys.readouterr().err
    assert main(follow_arguments(six_file, str(tmp_path / "none.csv"), tmp_path / "out")) == 2
    assert "existing file" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize(
    ("step", "file"),
    [
        ("preparing collision shapes", None),
        ("optimising the path", None),
        ("checking the result", None),
        ("writing files", None),
        ("writing files", "panda/trajectory.csv"),
    ],
)
def test_an_interrupt_leaves_no_broken_file(tmp_path, step, file, sigint):
    """A real process, interrupted by a real signal in one of its steps, or when a file is there."""
    process = subprocess.Popen(
        [sys.executable, "-m", "manipplan", "demo", "--out", str(tmp_path / "demo")],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONWARNINGS": "default"},
    )
    seen = ""
    while step not in seen:
        seen = process.stderr.readline()
        assert seen, "the process ended before it came so far"
    while file is not None and not (tmp_path / "demo" / file).exists():
        assert process.poll() is None, "the process ended before it wrote the file"
        time.sleep(0.002)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "Traceback" not in errors
    assert "interrupted" in errors
    files = [each for each in (tmp_path / "demo").rglob("*") if each.is_file()]
    assert not [each for each in files if each.name.endswith(".part")]
    readers = {"trajectory.csv": mp.Trajectory.from_csv, "trajectory.json": mp.Trajectory.from_json}
    read = [readers[each.name](each) for each in files if each.name in readers]
    assert read or file is None


@pytest.mark.parametrize("command", ["plan", "follow", "improve", "run", "check"])
def test_the_help_has_a_box_for_the_robot(command, capsys):
    with pytest.raises(SystemExit):
        main([command, "--help"])
    told = capsys.readouterr().out
    assert "robot options" in told and "options options" not in told


@pytest.mark.parametrize("command", ["plan", "follow", "improve", "run", "check", "view", "study", "demo", "robots"])
def test_the_help_says_what_is_wanted(command, capsys):
    with pytest.raises(SystemExit):
        main([command, "--help"])
    told = capsys.readouterr().out
    assert not re.search(r"\{None\}\|(PATH|STR|FLOAT|INT)|\bPATH\b|\[STR", told)


@pytest.mark.slow
def test_doctor_lists_every_extra_and_runs_its_tests(capsys, monkeypatch):
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text())["project"]
    assert set(doctor.EXTRAS) == set(project["optional-dependencies"]) - {"docs", "dev"}
    assert main(["doctor"]) == 0
    told = capsys.readouterr().out
    assert "failed" not in told and told.count("OPTIMAL") == 2 and "FOLLOWED" in told
    assert all(f"{extra}: " in told for extra in doctor.EXTRAS)

    def fail():
        raise mp.errors.PlanningError("no path")

    def lack():
        raise mp.errors.MissingExtraError("example-robot-data", "robots")

    monkeypatch.setattr(doctor, "find_spec", lambda name: None)
    monkeypatch.setattr(doctor, "TESTS", {"first": fail, "second": lack})
    assert main(["doctor"]) == 1
    told = capsys.readouterr().out
    assert "first: failed: no path" in told and "second: left out: example-robot-data is not installed" in told
    assert told.count("pip install 'manipplan[viewer]'") == 1


@pytest.mark.slow
def test_output_that_is_not_read_to_its_end_is_no_error():
    code = "import sys; sys.argv = ['manipplan', 'robots']; from manipplan.cli import run; run()"
    line = f"{shlex.quote(sys.executable)} -c {shlex.quote(code)} | true"
    made = subprocess.run(line, shell=True, capture_output=True, text=True, check=False)
    assert "Traceback" not in made.stderr


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ([], "Expected one of {demo, plan,"),
        (["plna"], "Unrecognized options: plna"),
        (["plan", "panda", "--bogus"], "--start Q [Q ...]"),
        (["view", "plan", "--port", "abc"], "--port: got 'abc'; allowed: a whole number; --port N"),
        (["plan", "panda", "--start", "default", "--power", "x"], "--power: got 'x'; allowed: a number;"),
        (["plan", "panda"], "missing: --start Q [Q ...]; for help: manipplan plan --help"),
        (["plan", "panda", "--start", "default", "--gaol", "1"], "Perhaps you meant: --goal Q [Q ...]; for help"),
        (["study", "kth"], "paper: got 'kth'; allowed: 'kth2012', "),
        (["view", "--port"], "--port: a value is missing; for help"),
        (
            ["follow", "panda", "path", "--pointing", "1", "2"],
            "--pointing: got ['1', '2'], not what it takes; --pointing X Y Z",
        ),
    ],
)
def test_options_that_cannot_be_read_are_one_line_too(given, message, capsys):
    assert main(given) == 2
    out, error = capsys.readouterr()
    assert out == "" and error.startswith("manipplan: ") and error.count("\n") == 1
    assert message in error and "--help" in error and not set("╭│─╯") & set(error)


@pytest.mark.slow
def test_bash_completes_commands_and_options(tmp_path):
    """As the help and docs/howto/shell.md say it is switched on."""
    file = tmp_path / "completion"
    python = [sys.executable, "-m", "manipplan"]
    file.write_text(
        subprocess.run([*python, "--tyro-print-completion", "bash"], capture_output=True, text=True, check=True).stdout
    )
    assert "--tyro-print-completion" in " ".join(
        subprocess.run([*python, "--help"], capture_output=True, text=True, check=True).stdout.split()
    )
    for words, expected in (("manipplan pl", "plan"), ("manipplan view --rec", "--record"), ("manipplan plan --go", "--goals")):
        script = f"""source {file}
        COMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); COMP_LINE='{words}'; COMP_POINT=${{#COMP_LINE}}
        $(complete -p manipplan | sed -E 's/.*-F ([^ ]+).*/\\1/'); printf '%s\\n' "${{COMPREPLY[@]}}" """
        found = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True)
        assert expected in found.stdout.split(), (words, found)
        assert all(" " not in line for line in found.stdout.splitlines()), "part of a help text is offered"


def test_help_names_no_default_where_giving_nothing_is_the_default(capsys):
    for command in COMMANDS:
        with pytest.raises(SystemExit):
            main([command, "--help"])
        told = " ".join(capsys.readouterr().out.replace("│", " ").split())
        assert told and "default: )" not in told and "default: None)" not in told
        assert not set(re.findall(r"--[\w-]+ (INT|FLOAT|STR)\b", told)), "a metavar that does not say what is wanted"


@pytest.mark.slow
def test_output_that_goes_to_no_terminal_is_plain(tmp_path):
    """Also where the encoding has no superscripts."""
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "TERM": "xterm-256color"}
    for given in (["robots", "panda"], ["--help"], ["view", str(tmp_path)], ["plan"]):
        process = subprocess.run([sys.executable, "-m", "manipplan", *given], capture_output=True, env=environment, check=False)
        assert process.returncode in (0, 2)
        assert b"\x1b" not in process.stdout + process.stderr and b"Traceback" not in process.stderr


@pytest.mark.parametrize(
    "content", [b"", b'{"a": 1}', b"[1, 2]", b"\x89PNG\r\n\x1a\n\x00", b'{"format": "manipplan-plan"}', b"null"]
)
@pytest.mark.parametrize("name", ["plan.json", "program.json"])
def test_a_result_of_something_else_is_told_in_one_line(tmp_path, capsys, name, content):
    (tmp_path / name).write_bytes(content)
    assert main(["view", str(tmp_path), "--no-browser"]) == 2
    [error] = [line for line in capsys.readouterr().err.splitlines() if not line.startswith("...")]
    assert error.startswith("manipplan: ") and name in error
