"""The judge of any trajectory: what passes, what is found wrong with a spoilt one, and every wrong input."""

import json
from dataclasses import fields, replace

import numpy as np
import pytest

import manipplan as mp
from manipplan.plans.archive import checksum
from manipplan.seeds.task import CHECK_STEP

START, GOAL = np.array([0.1, 1.0, -1.2]), np.array([0.9, 0.6, -0.4])
SCENE = mp.Scene([mp.Cylinder(radius=0.1, length=1.0, position=(-1.5, 2.0, 0.0), name="post")])


@pytest.fixture(scope="module")
def arm():
    """A planar arm whose jerk is limited."""
    return mp.planar_arm([1.0, 1.0, 1.0]).with_limits(jerk=300.0, lower=-2.5, upper=2.5)


@pytest.fixture(scope="module")
def motion(arm):
    return mp.retime(mp.JointPath.line(START, GOAL), arm)


def faster(arm, motion, kind, order, ratio):
    """The motion so fast that it uses `ratio` of a limit at its samples."""
    used = (np.abs(motion(motion.t, order)) / getattr(arm.limits, kind)).max()
    factor = (used / ratio) ** (1 / order)
    return replace(motion, t=motion.t * factor, qd=motion.qd / factor)


def along(motion, changed):
    """The motion with q(t) and its derivative changed by a function of its samples."""
    q = changed(motion.q)
    return replace(motion, q=q, qd=np.gradient(q, motion.t, axis=0, edge_order=2))


def test_a_good_motion_passes(arm, motion):
    report = mp.check(arm, motion, SCENE, start=START, goal=GOAL, clearance=0.05)
    assert report.passed and report.collision_free and report.faults == ()
    assert "all checks passed" in str(report) and "CHECK FAILED" not in str(report)
    assert set(report.limits) == {"position", "velocity", "acceleration", "jerk"}
    assert report.start_error <= 1e-9 and report.goal_error <= 1e-9
    assert report.proven_clearance > 0.05 and report.nearest_pair[1] == "post"
    assert not isinstance(report, mp.results.PlanReport)


def test_figures_are_those_of_dense_samples(arm, motion):
    objective = mp.PathObjective(power=2.0, floor=0.0, measure="smallest_singular_value")
    report = mp.check(arm, motion, SCENE, objective=objective)
    t = np.linspace(0.0, motion.duration, 40_001)
    m = arm.kinematics(measure="smallest_singular_value").manipulability(motion(t))
    speed = np.linalg.norm(motion(t, 1), axis=1)
    assert report.g == pytest.approx(np.trapezoid(speed / m**2, t), rel=1e-6)
    assert report.length == pytest.approx(np.trapezoid(speed, t), rel=1e-6)
    assert report.min_manipulability == pytest.approx(m.min(), rel=1e-6)
    assert report.min_at * motion.duration == pytest.approx(t[m.argmin()], abs=1e-3)
    for order, kind in ((1, "velocity"), (2, "acceleration")):
        ratios = np.abs(motion(t, order)) / getattr(arm.limits, kind)
        assert report.limits[kind].ratio == pytest.approx(ratios.max(), rel=1e-3)
        assert report.limits[kind].joint == arm.joint_names[int(ratios.max(axis=0).argmax())]
    assert report.clearance == pytest.approx(SCENE.distances(arm, motion(t[::100])).min(), abs=1e-4)
    assert (report.power, report.floor, report.measure) == (2.0, 0.0, "smallest_singular_value")


@pytest.mark.slow
def test_a_plan_has_the_figures_of_its_trajectory(demo_problem, demo_plan):
    found = mp.check(
        demo_problem.robot, demo_plan.trajectory, demo_problem.scene, start=demo_problem.start, goal=demo_plan.path.goal
    )
    for each in fields(mp.results.Report):
        assert getattr(found, each.name) == getattr(demo_plan.report, each.name), each.name


SPOILT = {
    "position": (lambda arm, m: along(m, lambda q: q + [0.0, 1.7, 0.0]), {}, "position: 0.2 rad outside the limits, "),
    "velocity": (lambda arm, m: faster(arm, m, "velocity", 1, 1.3), {}, "velocity: 130"),
    "acceleration": (lambda arm, m: faster(arm, m, "acceleration", 2, 1.02), {}, "acceleration: 102 % of the limit, "),
    "jerk": (lambda arm, m: replace(m, qd=m.qd * 1.001), {}, "jerk: the acceleration jumps, "),
    "start": (lambda arm, m: m, {"start": START + [0.0, 2e-6, 0.0]}, "start: {1} is 2e-06 rad away"),
    "goal": (lambda arm, m: m, {"goal": GOAL - [0.0, 0.0, 0.5]}, "goal: {2} is 0.5 rad away"),
    "clearance": (lambda arm, m: m, {"clearance": 5.0}, "clearance: "),
}


@pytest.mark.parametrize("kind", SPOILT)
def test_a_spoilt_motion_fails_and_says_why(arm, motion, kind):
    spoil, asked, message = SPOILT[kind]
    report = mp.check(arm, spoil(arm, motion), SCENE, **asked)
    assert not report.passed
    assert any(fault.startswith(message.format(*arm.joint_names)) for fault in report.faults), report.faults
    assert f"  failed       {message.format(*arm.joint_names)}" in str(report) and "CHECK FAILED" in str(report)


def test_a_jerk_that_is_not_limited_is_not_judged(arm, motion):
    rough = SPOILT["jerk"][0](arm, motion)
    wide = arm.with_limits(jerk=np.inf, acceleration=1e3, velocity=1.01 * arm.limits.velocity)
    assert "jerk" not in mp.check(wide, rough).limits
    assert mp.check(wide, rough).passed
    assert not mp.check(arm.with_limits(acceleration=np.inf), rough).passed


@pytest.mark.parametrize("factor", [1.3, 1.37123, 5.0])
def test_a_slower_motion_has_no_jumps(arm, motion, factor):
    """Its times are in whole nanoseconds, which moves the accelerations of both sides of a sample apart."""
    fast, slow = (mp.check(arm, each, SCENE) for each in (motion, motion.slower(factor)))
    assert slow.passed and slow.limits["jerk"].ratio == pytest.approx(fast.limits["jerk"].ratio / factor**3, rel=0.05)
    assert slow.g == pytest.approx(fast.g, rel=1e-6) and slow.duration == pytest.approx(factor * fast.duration)


def test_torque_is_judged_if_asked(panda):
    motion = mp.retime(mp.JointPath.line(panda.neutral, panda.neutral + 0.3), panda)
    weak = panda.with_limits(effort=10.0)
    assert mp.check(weak, motion).passed and "torque" not in mp.check(weak, motion).limits
    report = mp.check(weak, motion, torque=True)
    assert not report.passed and report.faults[0].startswith("torque: ")
    assert report.limits["torque"] == mp.torque_use(motion, weak.model, weak.limits.effort)


def test_a_collision_names_its_bodies_and_time(arm, motion):
    tip = arm.kinematics().pose(motion(0.4 * motion.duration))[:3, 3]
    scene = mp.Scene([mp.Sphere(radius=0.05, position=tip, name="ball"), *SCENE.obstacles])
    report = mp.check(arm, motion, scene)
    assert not report.passed and not report.collision_free and report.nearest_pair[1] == "ball"
    [fault] = report.faults
    assert fault.startswith("collision: overlap by ") and " and ball at " in fault
    at = float(fault.split(" at ")[1].split(" s")[0])
    assert scene.in_collision(arm, motion(at)) and report.clearance < 0


@pytest.mark.slow
def test_a_graze_between_the_samples_is_found(arm, motion):
    """A ball that the tip touches for less than the 1 mrad between samples: the proof finds what these miss."""
    t = np.linspace(0.0, motion.duration, 40_001)
    tip = arm.kinematics().pose(motion(motion.duration / 2))[:3, 3]
    out = tip / np.linalg.norm(tip)
    ball, depth = mp.Sphere(radius=0.05, position=tip + 0.2 * out, name="ball"), 2e-8
    for _ in range(8):
        apart = mp.Scene([ball]).distances(arm, motion(t)).min()
        ball = replace(ball, position=np.array(ball.position) - (apart + depth) * out)
    scene = mp.Scene([ball])
    assert -1e-6 < scene.distances(arm, motion(t)).min() < 0
    assert scene.collision_model(arm).path_is_free(motion.path(), CHECK_STEP, 0.0)
    assert not mp.check(arm, motion, scene).collision_free


@pytest.fixture(scope="module")
def six():
    return mp.load_robot("ur5")


@pytest.fixture(scope="module")
def seam(six):
    """A straight path of the tool, and a motion along it."""
    pose = six.kinematics().pose([0.3, -1.2, 1.6, -1.5, -1.4, 0.2])
    end = pose.copy()
    end[:3, 3] += [0.05, 0.1, 0.05]
    path = mp.CartesianPath.line(pose, end)
    return path, mp.follow(six, path, positions=12).trajectory


def reverse(motion):
    return replace(motion, t=motion.duration - motion.t[::-1], q=motion.q[::-1], qd=-motion.qd[::-1])


@pytest.mark.slow
def test_the_tool_is_compared_with_its_path(six, seam):
    path, motion = seam
    report = mp.check(six, motion, path=path)
    assert report.passed and report.tolerance == mp.Tolerance(position=1e-4, rotation=1e-3)
    assert 0 < report.deviation.position < 1e-4 and 0 <= report.missed.position < 1e-4
    assert "from the path" in str(report) and "from the way of the tool" in str(report)
    # a straight line from pose to pose, by hand
    poses = six.kinematics().pose(motion(np.linspace(0.0, motion.duration, 5000)))
    along = path(1.0)[:3, 3] - path(0.0)[:3, 3]
    off = np.linalg.norm(np.cross(poses[:, :3, 3] - path(0.0)[:3, 3], along / np.linalg.norm(along)), axis=1)
    assert report.deviation.position == pytest.approx(off.max(), abs=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda m: replace(m, q=m.q + [0, 0, 2e-3, 0, 0, 0]), "tool: the tool leaves the path by 0.00"),
        (lambda m: replace(m, q=m.q + [0, 0, 0, 0, 0, 2e-3]), "tool: the tool leaves the path by 0.002 rad"),
        (reverse, "tool: the tool misses a pose of the path by 0.1225 m after"),
        (lambda m: replace(m, t=m.t[:300], q=m.q[:300], qd=m.qd[:300]), "tool: the tool misses a pose of the path by 0.0"),
    ],
)
def test_a_tool_beside_its_path_is_told(six, seam, spoil, message):
    path, motion = seam
    report = mp.check(six, spoil(motion), path=path)
    assert not report.passed and report.collision_free
    assert any(fault.startswith(message) for fault in report.faults), report.faults


@pytest.mark.slow
def test_a_free_axis_and_a_wide_tolerance(six, seam):
    path, motion = seam
    turned = replace(motion, q=motion.q + [0, 0, 0, 0, 0, 0.5])
    assert not mp.check(six, turned, path=path).passed
    kinematics, q = six.kinematics(), motion.q[0]
    turn = kinematics.pose(q)[:3, :3].T @ kinematics.pose(q + [0, 0, 0, 0, 0, 0.5])[:3, :3]
    free = np.linalg.svd(turn - np.eye(3))[2][-1]  # about which the last joint turns the tool
    axis = mp.PathObjective(task=mp.Task.pointing(free))
    found = mp.check(six, turned, path=path, objective=axis)
    assert found.deviation.rotation < 1e-3
    assert mp.check(six, turned, path=path, tolerance=mp.Tolerance(position=0.5)).passed  # the rotation is not limited
    assert not mp.check(six, turned, path=path, tolerance=mp.Tolerance(position=0.5, rotation=0.4)).passed


@pytest.mark.parametrize("kind", ["csv", "json", "ros", "npz"])
def test_a_file_is_judged_as_its_trajectory(arm, motion, tmp_path, kind):
    file = tmp_path / f"motion.{kind.replace('ros', 'yaml')}"
    getattr(motion, f"to_{kind}")(file)
    assert mp.check(arm, str(file), SCENE) == mp.check(arm, file, SCENE) == mp.check(arm, motion, SCENE)


def test_columns_are_matched_by_names(arm, motion, tmp_path):
    turned = replace(motion, q=motion.q[:, ::-1], qd=motion.qd[:, ::-1], joint_names=motion.joint_names[::-1])
    assert mp.check(arm, turned, SCENE) == mp.check(arm, motion, SCENE)
    assert turned.digest != motion.digest == turned.in_order(motion.joint_names).digest
    text = "time," + ",".join(f"q_{name}" for name in turned.joint_names)
    rows = [",".join(map(repr, [t, *q])) for t, q in zip(motion.t.tolist(), turned.q.tolist(), strict=True)]
    (tmp_path / "turned.csv").write_text("\n".join([text, *rows]))
    found = mp.check(arm.with_limits(jerk=np.inf), tmp_path / "turned.csv", SCENE, start=START, goal=GOAL)
    assert found.passed


def test_a_motion_that_stands_still_is_judged(arm):
    still = mp.Trajectory(t=[0.0, 1.0], q=[START, START], qd=np.zeros((2, 3)), joint_names=arm.joint_names)
    report = mp.check(arm, still, SCENE, start=START, goal=START)
    assert report.passed and report.g == report.length == 0.0
    assert report.min_manipulability == pytest.approx(arm.kinematics().manipulability(START))
    assert not mp.check(arm, still, SCENE, goal=GOAL).passed


@pytest.mark.slow
def test_reports_have_a_way_back(six, seam, arm, motion, demo_plan, tmp_path):
    path, along_seam = seam
    for report in (mp.check(six, along_seam, path=path), mp.check(arm, motion, clearance=9.0), demo_plan.report):
        report.to_json(tmp_path / "report.json")
        again = mp.results.Report.from_json(tmp_path / "report.json")
        assert again == report and type(again) is type(report)


@pytest.mark.slow
def test_a_plan_cannot_have_another_trajectory(demo_plan, tmp_path):
    slow = demo_plan.trajectory.slower(2.0)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"trajectory: got 'a motion of .* s'; allowed: .*mp\.check\(plan\.robot"
    ):
        replace(demo_plan, trajectory=slow)
    with pytest.raises(mp.errors.InvalidInputError, match="trajectory: got 'none'"):
        mp.results.PartialPlan(robot=demo_plan.robot, scene=demo_plan.scene, status=demo_plan.status, report=demo_plan.report)
    same = replace(demo_plan, trajectory=replace(demo_plan.trajectory))  # an equal one is no other
    assert same.report is demo_plan.report
    demo_plan.save(tmp_path)
    data = json.loads((tmp_path / "plan.json").read_text())
    data["trajectory"]["t"] = slow.t.tolist()
    del data["sha256"]
    (tmp_path / "plan.json").write_text(json.dumps({**data, "sha256": checksum(data)}))
    with pytest.raises(mp.errors.FileFormatError, match="the trajectory that plan.report was measured on"):
        mp.Plan.load(tmp_path)


DEGREES = r"trajectory\.q\[0, 0\] \(panda_joint1\): got 17.18.*positions in rad, .* inside the limits if they are in degrees"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda m: replace(m, joint_names=("panda_joint_1", *m.joint_names[1:])), "got 'panda_joint_1'; .*mean panda_joint1"),
        (
            lambda m: replace(m, joint_names=("panda_finger_joint1", *m.joint_names[1:])),
            "got 'panda_finger_joint1'; allowed: .* alone; panda_finger_joint1 is locked at 0.001",
        ),
        (
            lambda m: replace(m, q=m.q[:, :6], qd=m.qd[:, :6], joint_names=m.joint_names[:6]),
            "trajectory.joint_names: .*; panda_joint7 is missing",
        ),
        (lambda m: replace(m, q=np.rad2deg(m.q), qd=np.rad2deg(m.qd)), DEGREES),
        (lambda m: replace(m, qd=np.rad2deg(m.qd)), "velocities 57.28 times as large .* degrees per second"),
        (lambda m: replace(m, t=m.t * 1e3), "velocities 999.6 times as large .* times in milliseconds"),
        (lambda m: replace(m, q=m.q + 50.0), r"trajectory.q\[0, 0\] .*near the limits -2.8973 to 2.8973 rad$"),
        (lambda m: m.q, "trajectory: got array.*a Trajectory, or the path of a trajectory file"),
        (lambda m: m.path(), "trajectory: got JointPath"),
        (lambda m: "motion.txt", r"trajectory: got 'motion.txt'; allowed: a trajectory file: .csv, .json"),
        (lambda m: "motion.csv", "existing file"),
    ],
)
def test_a_motion_that_cannot_be_judged_raises(panda, change, message):
    motion = mp.retime(mp.JointPath.line(panda.neutral + [0.3, 0, 0, 0, 0, 0, 0], panda.neutral), panda)
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.check(panda, change(motion))


def test_millimetres_of_a_sliding_joint_are_told(two_link_urdf):
    arm = mp.Robot.from_urdf(two_link_urdf(), tool="tip", joints=["turn", "slide"], locked={"finger": 0.0})
    motion = mp.retime(mp.JointPath.line([0.0, 0.1], [0.5, 0.3]), arm)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"\[0, 1\] \(slide\): got 100.0; .* in m, .*if they are in millimetres"
    ):
        mp.check(arm, replace(motion, q=motion.q * [1.0, 1e3], qd=motion.qd * [1.0, 1e3]))


HEAD = "time,q_joint1,q_joint2,q_joint3"


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        (["0,0,0,0", "1,0,0,0", "1,0,0,1"], "row 4, time: 1'; allowed: a time after that of row 3, 1.0 s"),
        (["0,0,0,0", "2,0,0,0", "1,0,0,1", "3,0,0,0"], "row 4, time: 1'; allowed: a time after that of row 3, 2.0 s"),
        (["0,0,0,0", "1,0,nan,0"], "row 3, q_joint2: nan'; allowed: a finite number"),
        (["0,0,0,0", "1,0,0"], "row 3, with 3 cells'; allowed: 4 cells"),
        (["0,0,0,0", "", "1,0,x,0"], "row 4, q_joint2: x'; allowed: a number"),
        (["0,0,0,0"], "with 1 rows of numbers'; allowed: at least two"),
    ],
)
def test_a_file_that_cannot_be_read_names_its_row(arm, tmp_path, rows, message):
    (tmp_path / "m.csv").write_text("\n".join([HEAD, *rows]))
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.check(arm, tmp_path / "m.csv")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"t": [0.0, 1.0, 1.0]}, r"t\[2\]: got 1.0; allowed: a time after t\[1\] = 1.0 s"),
        ({"t": [0.0, 2.0, 1.0]}, r"t\[2\]: got 1.0"),
        ({"t": [0.0, np.nan, 1.0]}, r"t\[1\]: got nan"),
        ({"q": [[0.0], [np.nan], [0.0]]}, r"q\[1, 0\] \(a\): got nan; allowed: a finite number"),
        ({"qd": [[0.0], [0.0], [np.inf]]}, r"qd\[2, 0\] \(a\): got inf"),
    ],
)
def test_a_trajectory_names_the_sample_at_fault(change, message):
    given = {"t": [0.0, 1.0, 2.0], "q": np.zeros((3, 1)), "qd": np.zeros((3, 1)), **change}
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Trajectory(**given, joint_names=("a",))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"scene": "scene.yaml"}, "scene: got 'scene.yaml'; allowed: a Scene"),
        ({"start": [0.0, 0.0]}, r"start: .*shape \(3,\)"),
        ({"goal": [9.0, 0.0, 0.0]}, r"goal\[0\]"),
        ({"clearance": -1.0}, "clearance: got -1.0"),
        ({"clearance": np.nan}, "clearance: got nan"),
        ({"torque": 1}, "torque: got 1"),
        ({"path": np.eye(4)}, "path: got .*a CartesianPath"),
        ({"tolerance": mp.Tolerance(position=0.1)}, "tolerance: got .*None without a path"),
        ({"objective": "yoshikawa"}, "objective: got 'yoshikawa'; allowed: a PathObjective"),
    ],
)
def test_wrong_options_raise(arm, motion, options, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.check(arm, motion, **options)
    with pytest.raises(mp.errors.InvalidInputError, match="robot: got 'panda'; allowed: a Robot"):
        mp.check("panda", motion)
