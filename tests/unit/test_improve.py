"""A recorded motion without its noise, in the same time, with a higher manipulability; and what cannot be a recording."""

import re
import time
from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import manipplan as mp
from manipplan.plans.report import Comparison, MotionFigures
from manipplan.recordings.program import TubeProgram, Weights
from manipplan.recordings.recording import Ends, SplineBasis, smooth

TUBE = mp.Tolerance(position=0.02, rotation=0.2)


def recorded_by(robot, curve, duration, rate=125.0, noise=3e-4, seed=0):
    """Positions with white noise at a rate [Hz], the velocities from the cubic spline through them."""
    t = np.arange(0.0, duration, 1 / rate)
    q = curve(t) + np.random.default_rng(seed).normal(0.0, noise, (len(t), robot.n))
    return mp.Trajectory(t=t, q=q, qd=CubicSpline(t, q)(t, 1), joint_names=robot.joint_names)


@pytest.fixture(scope="module")
def curve():
    """A Panda's motion of 4 s from rest to rest that passes near the stretched elbow."""
    waypoints = [
        [0.0, -0.3, 0.0, -2.2, 0.0, 2.0, 0.785],
        [0.3, 0.3, 0.1, -0.6, 0.1, 1.2, 0.9],
        [0.6, 0.4, 0.3, -1.5, 0.0, 1.9, 0.5],
    ]
    path = mp.JointPath.spline([0.0, 0.5, 1.0], waypoints)

    def at(t):
        u = t / 4.0
        return path(np.clip(10 * u**3 - 15 * u**4 + 6 * u**5, 0.0, 1.0))

    return at


@pytest.fixture(scope="module")
def recording(panda, curve):
    return recorded_by(panda, curve, 4.0)


@pytest.fixture(scope="module")
def plan(panda, recording):
    return mp.improve(panda, recording, tolerance=TUBE)


def log(recording, *, unit=1.0, order=1, prefix="q_", more=()):
    """Lines of a CSV log of positions, its joints in another order."""
    names = recording.joint_names[::order]
    head = ",".join(["time", *(f"{prefix}{name}" for name in names), *more])
    rows = np.column_stack([recording.t + 7.0, recording.q[:, ::order] * unit])
    return [head, *(",".join([*map(repr, map(float, row)), *("1" for _ in more)]) for row in rows)]


@pytest.mark.slow
def test_every_figure_is_better_in_the_same_time(panda, recording, plan):
    assert plan.status is mp.Status.IMPROVED and plan.report.passed and plan.status.ok
    assert plan.trajectory.duration == recording.duration
    found = plan.comparison
    before, after = found.recorded, found.improved
    assert after.min_manipulability > 5 * before.min_manipulability and after.mean_manipulability > before.mean_manipulability
    assert after.g < before.g and after.length < before.length and after.peak_jerk < before.peak_jerk / 100
    m = panda.kinematics().manipulability
    assert after.min_manipulability == pytest.approx(
        m(plan.trajectory(np.linspace(0, plan.trajectory.duration, 4001))).min(), rel=1e-4
    )
    assert before.mean_manipulability == pytest.approx(m(recording(np.linspace(0, recording.duration, 4001))).mean(), rel=1e-3)
    np.testing.assert_allclose(plan.trajectory.q[[0, -1]], recording.q[[0, -1]], atol=1e-12)
    np.testing.assert_allclose(plan.trajectory.qd[[0, -1]], 0.0, atol=1e-12)


@pytest.mark.slow
def test_the_tool_stays_inside_the_tolerance_of_every_recorded_pose(panda, recording, plan):
    pose = panda.kinematics().pose
    first, second = pose(recording.q), pose(plan.trajectory(np.minimum(recording.t, plan.trajectory.duration)))
    apart = np.linalg.norm(first[:, :3, 3] - second[:, :3, 3], axis=1)
    turned = np.arccos(np.clip((np.einsum("kij,kij->k", first[:, :3, :3], second[:, :3, :3]) - 1) / 2, -1, 1))
    assert 0.005 < apart.max() <= plan.comparison.deviation.position + 1e-12 <= TUBE.position
    assert turned.max() <= plan.comparison.deviation.rotation + 1e-9 <= TUBE.rotation


def test_an_independent_check_passes_with_jerk_limits(panda, recording, plan):
    report = mp.check(panda, plan.trajectory, start=recording.q[0], goal=recording.q[-1])
    assert report.passed and report.limits["jerk"].ratio < 1


@pytest.mark.slow
def test_the_comparison_is_printed_and_saved(plan, tmp_path):
    text = str(plan.report)
    assert "recorded  improved" in text and "peak jerk [rad/s³]" in text and "allowed: 20 mm and 11.5°" in text
    plan.save(tmp_path)
    assert mp.Plan.load(tmp_path).comparison == plan.comparison
    assert mp.results.Report.from_json(tmp_path / "report.json").comparison == plan.comparison
    assert (tmp_path / "report.txt").read_text() == f"{text}\n"


@pytest.mark.slow
def test_another_duration_is_kept(panda, recording):
    for duration in (2.5, 6.0):
        plan = mp.improve(panda, recording, duration=duration)
        assert plan.status is mp.Status.IMPROVED and plan.trajectory.duration == pytest.approx(duration, rel=1e-12)


@pytest.mark.slow
def test_a_duration_that_is_too_short_is_refused_with_the_shortest_one(panda, recording):
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"duration: got 0\.4; allowed: at least .* s, the shortest found"
    ) as caught:
        mp.improve(panda, recording, duration=0.4, throw=False)
    shortest = float(re.search(r"at least ([\d.]+) s", str(caught.value)).group(1))
    plan = mp.improve(panda, recording, duration=shortest)
    assert plan.report.passed and max(plan.report.limits[kind].ratio for kind in ("velocity", "acceleration")) > 0.99
    with pytest.raises(mp.errors.InvalidInputError, match="at least"):
        mp.improve(panda, recording, duration=0.97 * shortest)


@pytest.mark.slow
def test_a_recording_of_a_faster_arm_is_refused_with_the_duration_it_needs(panda, recording):
    slow = panda.with_limits(velocity=0.2)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"recorded: got 'a motion of 3\.99.*; allowed: duration=[\d.]+ or"
    ) as told:
        mp.improve(slow, recording)
    assert mp.improve(slow, recording, duration=float(re.search(r"duration=([\d.]+)", str(told.value))[1])).report.passed


@pytest.mark.slow
@pytest.mark.parametrize("size", [1e-2, 1e-3])
def test_a_tight_tolerance_on_a_planned_motion_ends(panda, size):
    """It took IPOPT more than two minutes: the factors of its matrix filled up."""
    start, goal = [-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8]
    planned = mp.plan(panda, start, goal).trajectory
    t = np.linspace(0.0, 4.0, 400)
    q = planned(np.minimum(t / 4 * planned.duration, planned.duration))
    recorded = mp.Trajectory(t=t, q=q, qd=np.gradient(q, t, axis=0), joint_names=panda.joint_names)
    assert mp.improve(panda, recorded, tolerance=mp.Tolerance(position=1e-3, rotation=size)).report.passed


@pytest.mark.slow
def test_jerk_limits_are_kept(panda, recording):
    calm = panda.with_limits(jerk=6.0)
    plan = mp.improve(calm, recording, duration=4.2)
    assert plan.report.passed and plan.report.limits["jerk"].ratio <= 1 + 1e-6


@pytest.mark.slow
def test_obstacles_are_avoided(panda, recording, plan):
    """A ball beside the tool's way, which the improved motion of an empty scene would touch."""
    model = panda.kinematics()
    middle = plan.trajectory.duration / 2
    here, there = (model.pose(each(middle))[:3, 3] for each in (recording, plan.trajectory))
    away = (there - here) / np.linalg.norm(there - here)
    geometry = mp.Scene([mp.Sphere(radius=0.02, position=there + 0.1 * away, name="ball")])
    distance = geometry.distances(panda, recording(np.linspace(0.0, recording.duration, 400))).min()
    ball = mp.Sphere(radius=0.02 + distance - 0.002, position=there + 0.1 * away, name="ball")
    scene = mp.Scene([ball])
    assert scene.in_collision(panda, plan.trajectory(np.linspace(0.0, plan.trajectory.duration, 400))).any()
    beside = mp.improve(panda, recording, scene)
    assert beside.report.passed and beside.report.collision_free and beside.status is mp.Status.IMPROVED


def test_a_recording_that_ends_in_an_obstacle_is_refused(panda, recording):
    end = panda.kinematics().pose(recording.q[-1])[:3, 3]
    scene = mp.Scene([mp.Sphere(radius=0.1, position=end, name="ball")])
    with pytest.raises(mp.errors.InvalidInputError, match=r"recorded goal: .*ball overlap"):
        mp.improve(panda, recording, scene)


def test_a_recording_through_an_obstacle_fails(panda, recording):
    middle = panda.kinematics().pose(recording(2.0))[:3, 3]
    scene = mp.Scene([mp.Sphere(radius=0.05, position=middle, name="ball")])
    plan = mp.improve(panda, recording, scene, throw=False)
    assert plan.status is mp.Status.NOT_FOLLOWED and plan.trajectory is None and not plan.status.has_path
    with pytest.raises(mp.errors.PlanningError, match="clear of collisions"):
        mp.improve(panda, recording, scene)


@pytest.mark.slow
def test_a_generous_time_limit_changes_nothing(panda, recording, plan):
    again = mp.improve(panda, recording, tolerance=TUBE, time_limit=600.0)
    np.testing.assert_array_equal(again.trajectory.q, plan.trajectory.q)
    assert again.status is plan.status and again.message == plan.message == ""


def test_the_best_motion_by_then_is_returned_at_the_time_limit(panda, recording, plan):
    begun = time.monotonic()
    early = mp.improve(panda, recording, tolerance=TUBE, time_limit=1e-6)
    assert time.monotonic() - begun < 5.0  # 0.05 s on a quiet machine
    assert early.report.passed and "the time limit of 1e-06 s ended the search" in early.message
    assert early.status is mp.Status.IMPROVED and early.comparison.better  # without its noise it is better already
    assert early.comparison.improved.min_manipulability < plan.comparison.improved.min_manipulability


def clean(panda):
    """A planned motion, which smoothing does not make better."""
    return mp.retime(mp.JointPath.line(panda.neutral, panda.neutral + 0.3), panda).slower(2.0)


@pytest.mark.slow
def test_a_motion_that_was_not_improved_in_time_says_so(panda):
    motion = mp.improve(panda, clean(panda), time_limit=1e-6)
    assert motion.status is mp.Status.SMOOTHED_OUT_OF_TIME and motion.report.passed
    assert not motion.status.ok and motion.status.has_path
    assert mp.improve(panda, clean(panda)).status is mp.Status.IMPROVED


@pytest.mark.slow
def test_a_motion_that_was_not_found_in_time_says_so(panda):
    """A ball that touches the recorded way, but not what the tolerance allows."""
    recorded = clean(panda)
    pose = panda.kinematics().pose(recorded(recorded.duration / 2))
    away = pose[:3, 3] + 0.15 * pose[:3, 1]
    gap = mp.Scene([mp.Sphere(radius=0.01, position=away)]).distances(panda, recorded(np.linspace(0, recorded.duration, 300)))
    scene = mp.Scene([mp.Sphere(radius=0.01 + gap.min() + 2e-3, position=away, name="ball")])
    early = mp.improve(panda, recorded, scene, tolerance=TUBE, time_limit=1e-6, throw=False)
    assert early.status is mp.Status.NOT_IN_TIME and early.trajectory is None and "got 1e-06 s" in early.message
    with pytest.raises(mp.errors.PlanningError, match="the time limit ended the work"):
        mp.improve(panda, recorded, scene, tolerance=TUBE, time_limit=1e-6)
    assert mp.improve(panda, recorded, scene, tolerance=TUBE, time_limit=600.0).report.passed


@pytest.mark.parametrize("limit", [0.0, -1.0, np.nan, np.inf, "long", True])
def test_wrong_time_limits_are_refused(panda, recording, limit):
    with pytest.raises(mp.errors.InvalidInputError, match="time_limit: got"):
        mp.improve(panda, recording, time_limit=limit)


@pytest.mark.slow
def test_a_log_in_degrees_with_other_columns_in_another_order(panda, recording, plan, tmp_path):
    file = tmp_path / "log.csv"
    for prefix in ("q_", ""):
        file.write_text("\n".join(log(recording, unit=180 / np.pi, order=-1, prefix=prefix, more=["gripper", "note"])))
        again = mp.improve(panda, file, degrees=True, tolerance=TUBE)
        np.testing.assert_allclose(again.trajectory.q, plan.trajectory.q, atol=1e-6)


def test_degrees_are_recognised_with_row_and_value(panda, recording, tmp_path):
    file = tmp_path / "log.csv"
    file.write_text("\n".join(log(recording, unit=180 / np.pi)))
    wanted = r"log\.csv, row 2, panda_joint2: got -17\.\d+; .* -1\.7628 to 1\.7628 rad; .* degrees=True"
    with pytest.raises(mp.errors.InvalidInputError, match=wanted):
        mp.improve(panda, file)
    turned = replace(recording, q=np.rad2deg(recording.q))
    with pytest.raises(mp.errors.InvalidInputError, match=r"recorded\.q\[0, 1\] \(panda_joint2\): got -17\."):
        mp.improve(panda, turned)


@pytest.mark.parametrize(
    ("line", "text", "message"),
    [
        (10, "repeat", r"log\.csv, row 11, time: .*; allowed: a time after that of row 10"),
        (10, "nan", r"log\.csv, row 11, q_panda_joint1: nan'; allowed: a finite number"),
        (10, "word", r"log\.csv, row 11, q_panda_joint1: off'; allowed: a number"),
        (10, "jump", r"log\.csv, row 11, panda_joint1: got 1\.5; allowed: a position that panda_joint1 reaches"),
        (
            10,
            "outside",
            r"log\.csv, row 11, panda_joint1: got 3\.5; allowed: positions inside the limits -2\.8973 to 2\.8973 rad",
        ),
        (10, "short", r"log\.csv, row 11, with 3 cells"),
        (0, "joint", r"it has no column q_panda_joint7 or panda_joint7"),
        (0, "twice", r"row 2, with 8 cells.*9 cells"),
        (0, "time", r"it has no column time or t"),
    ],
)
def test_what_is_wrong_in_a_log_is_named(panda, recording, tmp_path, line, text, message):
    lines = log(recording)
    cells = lines[line].split(",")
    first = {"nan": "nan", "word": "off", "jump": "1.5", "outside": "3.5"}
    lines[line] = {
        "repeat": ",".join([lines[line - 1].split(",")[0], *cells[1:]]),
        "short": ",".join(cells[:3]),
        "joint": lines[line].replace("joint7", "joint8"),
        "twice": f"{lines[line]},q_panda_joint7",
        "time": lines[line].replace("time", "clock"),
    }.get(text, ",".join([cells[0], first.get(text, ""), *cells[2:]]))
    file = tmp_path / "log.csv"
    file.write_text("\n".join(lines))
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.improve(panda, file)


def test_wrong_arguments_are_refused(panda, recording):
    with pytest.raises(mp.errors.InvalidInputError, match="recorded: got"):
        mp.improve(panda, np.zeros((3, 7)))
    with pytest.raises(mp.errors.InvalidInputError, match=r"trajectory\.joint_names"):
        mp.improve(mp.load_robot("xarm7"), recording)
    with pytest.raises(mp.errors.FileFormatError, match="existing file"):
        mp.improve(panda, "nowhere.csv")
    with pytest.raises(mp.errors.InvalidInputError, match="objective: got 'yoshikawa'; allowed: a PathObjective"):
        mp.improve(panda, recording, objective="yoshikawa")
    with pytest.raises(mp.errors.InvalidInputError, match="tolerance: got None; allowed: a Tolerance"):
        mp.improve(panda, recording, tolerance=None)
    with pytest.raises(mp.errors.InvalidInputError, match="duration: got 0"):
        mp.improve(panda, recording, duration=0.0)
    with pytest.raises(mp.errors.InvalidInputError, match="a motion in which no joint moves"):
        mp.improve(panda, replace(recording, q=np.tile(recording.q[0], (len(recording.t), 1)), qd=0 * recording.qd))
    with pytest.raises(mp.errors.InvalidInputError, match="degrees: got True; allowed: False with a JointPath"):
        mp.improve(panda, recording.path(), degrees=True)


@pytest.mark.slow
def test_a_tolerance_below_the_noise_is_refused_with_the_smallest_one(panda, recording):
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"tolerance\.position: got 1e-05; allowed: at least .* m: .* row \d+"
    ) as caught:
        mp.improve(panda, recording, tolerance=mp.Tolerance(position=1e-5, rotation=0.2))
    least = float(re.search(r"at least ([\d.e-]+) m", str(caught.value)).group(1))
    plan = mp.improve(panda, recording, tolerance=mp.Tolerance(position=least, rotation=0.2))
    assert plan.report.passed and plan.comparison.deviation.position <= least


@pytest.mark.slow
def test_only_what_the_task_holds_counts(panda, recording):
    task = mp.PathObjective(task=mp.Task.position())
    plan = mp.improve(panda, recording, tolerance=mp.Tolerance(position=0.005, rotation=0.01), objective=task)
    pose = panda.kinematics().pose
    turn = (
        pose(recording.q)[:, :3, :3].transpose(0, 2, 1)
        @ pose(plan.trajectory(np.minimum(recording.t, recording.duration)))[:, :3, :3]
    )
    assert plan.report.passed and plan.comparison.deviation.rotation == 0.0
    assert np.arccos((np.trace(turn, axis1=1, axis2=2).min() - 1) / 2) > 0.05


@pytest.mark.slow
def test_a_motion_that_does_not_end_at_rest_keeps_its_speed(planar):
    recorded = recorded_by(planar, lambda t: np.stack([0.3 + 0.3 * t, 0.6 + 0.0 * t, 0.7 - 0.1 * t], axis=-1), 2.0, noise=1e-5)
    plan = mp.improve(planar, recorded)
    np.testing.assert_allclose(plan.trajectory.qd[[0, -1]], [[0.3, 0.0, -0.1]] * 2, atol=5e-3)
    assert plan.report.passed


@pytest.mark.slow
def test_a_planned_path_is_timed_first(planar):
    path = mp.JointPath.line([0.3, 0.6, 0.7], [0.9, 0.3, 0.4])
    plan = mp.improve(planar, path)
    assert plan.report.passed and plan.trajectory.duration == pytest.approx(1.25 * mp.retime(path, planar).duration)


def figures(**changes):
    same = {"min_manipulability": 1.0, "mean_manipulability": 2.0, "g": 3.0, "length": 1.0, "duration": 1.0}
    return MotionFigures(**same | {"peak_jerk": 5.0, "rms_jerk": 2.0} | changes)


@pytest.mark.parametrize(
    ("changes", "better", "worse"),
    [
        ({"mean_manipulability": 2.1}, True, ()),
        ({"min_manipulability": 1.1, "mean_manipulability": 1.9}, True, ()),
        ({}, False, ()),
        ({"mean_manipulability": 2.1, "min_manipulability": 0.99}, False, ("min_manipulability",)),
        ({"mean_manipulability": 2.1, "g": 3.1}, False, ("g",)),
        ({"mean_manipulability": 2.1, "peak_jerk": 6.0}, False, ("peak_jerk",)),
        ({"mean_manipulability": 2.1, "rms_jerk": 6.0, "duration": 0.8}, True, ()),
    ],
)
def test_what_counts_as_better(changes, better, worse):
    nothing = mp.results.Deviation(position=0.0, position_at=0.0, rotation=0.0, rotation_at=0.0)
    found = Comparison(
        recorded=figures(),
        improved=figures(**changes),
        measure_unit="1",
        deviation=nothing,
        tolerance=mp.Tolerance(position=0.1),
    )
    assert (found.better, found.worse) == (better, worse)


def test_jerk_of_a_known_motion():
    t = np.linspace(0.0, 1.0, 101)
    robot = mp.planar_arm([1.0, 1.0])
    q, qd = np.stack([t**3, 1 + 0 * t], axis=1), np.stack([3 * t**2, 0 * t], axis=1)
    integral = mp.PathObjective(task=mp.Task.custom([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0]])).integral(robot)
    found = MotionFigures.of(mp.Trajectory(t=t, q=q, qd=qd, joint_names=robot.joint_names), integral)
    assert found.peak_jerk == pytest.approx(6.0) and found.rms_jerk == pytest.approx(6.0 / np.sqrt(2))
    assert found.mean_manipulability == pytest.approx(np.sin(1.0)) == pytest.approx(found.min_manipulability)
    assert found.length == pytest.approx(1.0) and found.duration == 1.0


def test_derivatives_of_splines_are_bounded_by_their_control_points(rng):
    basis, u = SplineBasis(pieces=7), np.linspace(0.0, 1.0, 301)
    control = rng.normal(size=(basis.size, 2))
    for order in (1, 2, 3):
        bound = np.abs(basis.slopes(order) @ control).max(axis=0)
        assert (np.abs(basis.values(u, order) @ control).max(axis=0) <= bound * (1 + 1e-12)).all()
    motion = basis.trajectory(control, 3.0, 0.01, ("a", "b"))
    np.testing.assert_allclose(motion(1.7), basis.values(np.array([1.7 / 3]))[0] @ control, atol=1e-12)
    assert np.diff(motion.t).max() <= 0.01 + 1e-12


def test_smoothing_takes_the_noise_and_leaves_the_motion(panda, curve):
    for noise in (1e-4, 1e-3):
        recorded = recorded_by(panda, curve, 4.0, rate=500.0, noise=noise)
        found = smooth(recorded, panda.limits, 0.0)
        u = np.linspace(0.05, 0.95, 500)
        error = found.basis.values(u) @ found.control - curve(u * recorded.duration)
        assert np.sqrt(np.mean(error**2)) < 0.6 * noise


def test_derivatives_of_the_program(panda, recording):
    """A solve ends at a point from which no small step that keeps the ends leads to a lower objective."""
    integral = mp.PathObjective().integral(panda)
    curve = smooth(recording, panda.limits, 2e-4)
    program = TubeProgram(integral, curve.basis, curve.ends, 4.0, panda.limits)
    wide = np.full((len(program.u), 2), np.inf)
    poses = integral.kinematics.pose(program.values @ curve.control)
    weights = Weights(energy=1.0, room=1.0, jerk=1.0)
    best, factor = program.solve(curve.control, weights, poses=poses, tube=wide)
    assert factor == 1.0

    def objective(control):
        third = curve.basis.slopes(3)
        jerk = [np.sum((third @ each) ** 2) for each in (control, curve.control)]
        parts = []
        for each in (control, curve.control):
            m = integral.kinematics.manipulability(program.values @ each)
            speed = np.sum((program.slopes @ each) ** 2, axis=1)
            parts.append([program.weights @ (speed / m**2), program.weights @ (1 / m**2)])
        return jerk[0] / jerk[1] + sum(a / b for a, b in zip(*parts, strict=True))

    least, free = objective(best), np.isnan(curve.ends.control(curve.basis))
    assert least < objective(curve.control)
    rng = np.random.default_rng(1)
    for _ in range(20):
        step = np.where(free, rng.normal(size=best.shape), 0.0)
        assert objective(best + 1e-4 * step) > least - 1e-9


def test_ends_at_rest_have_neither_speed_nor_acceleration():
    basis = SplineBasis(pieces=6)
    ends = Ends(start=np.zeros(1), goal=np.ones(1), goal_slope=np.array([2.0]))
    control = basis.fit(basis.shares, basis.shares[:, None], ends)
    at = np.array([0.0, 1.0])
    np.testing.assert_allclose((basis.values(at) @ control).ravel(), [0.0, 1.0], atol=1e-12)
    np.testing.assert_allclose((basis.values(at, 1) @ control).ravel(), [0.0, 2.0], atol=1e-12)
    assert (basis.values(at[:1], 2) @ control)[0, 0] == pytest.approx(0.0, abs=1e-12)
