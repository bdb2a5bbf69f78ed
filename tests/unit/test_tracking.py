"""The controller in a loop: paths, limits, obstacles, wrong input, and the same in C."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from studies.dufour2020.quasi_newton import QuasiNewton

START = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, np.pi / 4])
DT = 0.01


@pytest.fixture(scope="module")
def circle(panda):
    """A circle that touches the edge of the arm's reach."""
    pose = panda.kinematics().pose(START)
    return mp.CartesianPath.circle(pose, pose[:3, 3] + [0.1405, 0.0, 0.0], (0.0, 0.0, 1.0))


def line(robot, q, by):
    start = robot.kinematics().pose(q)
    end = start.copy()
    end[:3, 3] += by
    return mp.CartesianPath.line(start, end)


FORMULATIONS = [
    mp.formulations.Classical(1.0),
    mp.formulations.General(),
    mp.formulations.Objective(15e3),
    QuasiNewton(15e3, "bfgs"),
    QuasiNewton(15e3, "sr1"),
    mp.formulations.Equality(5e5),
    mp.formulations.LogDrive(),
]


@pytest.mark.parametrize("formulation", FORMULATIONS, ids=str)
def test_every_formulation_follows_a_line_within_all_limits(panda, formulation):
    tracking = mp.track(panda, line(panda, START, [0.0, 0.3, 0.0]), START, formulation, dt=DT, duration=2.0, compiled=False)
    assert tracking.status is mp.Status.TRACKED, tracking.message
    assert tracking.deviation[-1] < 1e-4 and tracking.rotation_deviation[-1] < 1e-3
    for use in mp.limit_use(tracking.trajectory(), panda.limits).values():
        assert use.ratio <= 1 + 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("measure", ["frobenius", "isotropy"])
def test_another_measure_is_raised_on_the_same_line(panda, measure):
    shared = {"dt": DT, "duration": 2.0, "measure": measure, "compiled": False}
    start = np.array([0.0, -0.3, 1.0, -2.0, -0.8, 1.6, 0.3])
    path = line(panda, start, [0.0, 0.1, 0.0])
    still = mp.track(panda, path, start, mp.formulations.Classical(), **shared)
    driven = mp.track(panda, path, start, mp.formulations.LogDrive(), **shared)
    assert still.status.ok and driven.status.ok, driven.message
    kinematics = panda.kinematics(measure=measure)
    np.testing.assert_allclose(driven.manipulability, kinematics.manipulability(driven.q))
    assert driven.manipulability.mean() > 1.015 * still.manipulability.mean()
    for use in mp.limit_use(driven.trajectory(), panda.limits).values():
        assert use.ratio <= 1 + 1e-9


@pytest.mark.slow
def test_inside_a_tube_the_manipulability_stays_higher(panda, circle):
    held = mp.track(panda, circle, START, mp.formulations.General(), dt=DT, duration=4.0)
    tube = mp.Tolerance(position=0.02, rotation=0.08)
    free = mp.track(panda, circle, START, mp.formulations.LogDrive(), dt=DT, duration=4.0, tolerance=tube)
    assert free.status.ok and held.status.ok
    assert free.manipulability.min() > 1.8 * held.manipulability.min()
    assert free.deviation.max() <= 0.02 * 1.02 and free.rotation_deviation.max() <= 0.08 * 1.02


def test_a_tolerance_along_the_path(panda, circle):
    tracking = mp.track(
        panda,
        circle,
        START,
        mp.formulations.LogDrive(),
        dt=DT,
        duration=4.0,
        tolerance=lambda s: mp.Tolerance(position=0.002 + 0.02 * s * (1 - s)),
    )
    assert tracking.status.ok
    assert tracking.deviation[:20].max() < 0.004


def test_a_path_out_of_reach_says_how_far_it_got(panda):
    path = line(panda, START, [1.5, 0.0, 0.0])
    tracking = mp.track(
        panda,
        path,
        START,
        mp.formulations.LogDrive(),
        dt=DT,
        duration=3.0,
        tolerance=mp.Tolerance(position=0.02),
        compiled=False,
    )
    assert tracking.status is mp.Status.LEFT_TOLERANCE
    assert "s = 0." in tracking.message
    for use in mp.limit_use(tracking.trajectory(), panda.limits).values():
        assert use.ratio <= 1 + 1e-9


def test_a_jump_of_the_target_is_followed_as_fast_as_limits_let(panda):
    controller = mp.Controller(panda, mp.formulations.General(), dt=DT, compiled=False)
    target = panda.kinematics().pose(START).copy()
    target[:3, 3] += [0.0, 0.3, 0.1]
    motion = controller.rollout(START, np.repeat(target[None], 150, axis=0))
    assert motion["position_deviation"][-1] < 1e-4
    acceleration = np.diff(motion.qd, axis=0) / DT
    assert (np.abs(acceleration) / panda.limits.acceleration).max() <= 1 + 1e-9


def test_braking_for_what_is_no_number(panda):
    controller = mp.Controller(panda, mp.formulations.LogDrive(), dt=DT, compiled=False)
    moving = 0.5 * panda.limits.velocity
    for target, extra in (
        (np.full((4, 4), np.nan), {}),
        (panda.kinematics().pose(START), {"stiffness": -1.0}),
        (panda.kinematics().pose(START), {"drive": np.nan}),
    ):
        slower = controller.step(START, moving, target, **extra)
        assert controller.report.status is mp.results.StepStatus.BAD_TARGET
        np.testing.assert_allclose(slower, moving - panda.limits.acceleration * DT, atol=1e-12)
    assert not controller.step(np.full(7, np.nan), moving, panda.kinematics().pose(START)).any()
    assert controller.report.status is mp.results.StepStatus.BAD_STATE


def test_an_exactly_singular_posture_is_left(panda):
    stretched = np.clip(np.zeros(7), panda.limits.lower, panda.limits.upper)
    stretched[5] = 0.0 if panda.limits.lower[5] <= 0 else panda.limits.lower[5]
    kinematics = panda.kinematics()
    controller = mp.Controller(panda, mp.formulations.LogDrive(yields=False), dt=DT, stiffness=1e-3, compiled=False)
    motion = controller.rollout(stretched, np.repeat(kinematics.pose(stretched)[None], 100, axis=0))
    assert kinematics.manipulability(motion.q[-1]) > 100 * kinematics.manipulability(stretched) + 1e-3


@pytest.mark.slow
def test_an_obstacle_on_the_way_is_passed_at_its_distance(panda):
    ball = mp.Sphere(radius=0.05, position=(0.55, 0.28, 0.55), name="ball")
    avoidance = mp.Avoidance(scene=mp.Scene([ball]), itself=False)
    path = line(panda, START, [0.0, 0.3, 0.0])
    past = mp.track(panda, path, START, mp.formulations.LogDrive(), dt=DT, duration=4.0, stiffness=10.0, avoidance=avoidance)
    assert past.clearance.min() > 0.019
    scene = mp.Scene([ball])
    assert not scene.in_collision(panda, past.q[::5]).any()


@pytest.mark.slow
def test_an_obstacle_that_comes_is_evaded(panda):
    ball = mp.Sphere(radius=0.06, position=(0.55, 0.5, 0.55), name="ball")
    avoidance = mp.Avoidance(scene=mp.Scene([ball]), moving=["ball"], links=["panda_hand"], itself=False)
    controller = mp.Controller(panda, mp.formulations.General(), dt=DT, stiffness=10.0, avoidance=avoidance)
    target, q, qd = panda.kinematics().pose(START), START, np.zeros(7)
    place, speed = np.eye(4), np.array([0.0, -0.15, 0.0, 0.0, 0.0, 0.0])
    place[:3, 3] = target[:3, 3] + [0.0, 0.35, 0.05]
    nearest = []
    for _ in range(200):
        qd = controller.step(q, qd, target, obstacles={"ball": (place, speed)})
        q = q + DT * qd
        place[:3, 3] += DT * speed[:3]
        nearest.append(controller.report.clearance)
    assert min(nearest) > 0.018
    assert np.linalg.norm(panda.kinematics().pose(q)[:3, 3] - target[:3, 3]) > 0.02


@pytest.mark.slow
def test_what_touches_at_the_start_is_pushed_out(panda):
    at = panda.kinematics().pose(START)[:3, 3]
    ball = mp.Sphere(radius=0.05, position=at + [0.0, 0.06, 0.05], name="ball")
    avoidance = mp.Avoidance(scene=mp.Scene([ball]), links=["panda_hand"], itself=False)
    controller = mp.Controller(panda, mp.formulations.General(), dt=DT, stiffness=10.0, avoidance=avoidance, compiled=False)
    motion = controller.rollout(START, np.repeat(panda.kinematics().pose(START)[None], 150, axis=0))
    assert motion["clearance"][0] < 0 < motion["clearance"][-1]


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("formulation", [mp.formulations.LogDrive(), QuasiNewton(15e3, "bfgs")], ids=str)
def test_exported_c_is_the_same_controller(panda, formulation, tmp_path):
    tube = mp.Tolerance(position=0.01, rotation=0.05)
    files = mp.Controller(panda, formulation, dt=DT, tolerance=tube).export_c(tmp_path)
    assert {"controller.h", "controller.c", "step.c", "example.c", "CMakeLists.txt"} <= {file.name for file in files}
    if shutil.which("cmake"):
        for command in (["cmake", "-S", ".", "-B", "build"], ["cmake", "--build", "build"]):
            subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
        program = tmp_path / "build" / "example"
    else:
        sources = ["example.c", "controller.c", "step.c", "lib/libdaqpstat.a", "-lm"]
        subprocess.run(["cc", "-O1", "-Iinclude", "-o", "example", *sources], cwd=tmp_path, check=True)
        program = tmp_path / "example"
    lines = subprocess.run([program], capture_output=True, text=True, check=True).stdout.splitlines()
    got = np.array([[float(cell) for cell in line.split()[:7]] for line in lines])
    controller = mp.Controller(panda, formulation, dt=DT, tolerance=tube, compiled=False)
    pose, q, qd = panda.kinematics().pose(panda.neutral), panda.neutral, np.zeros(7)
    for k, row in enumerate(got, start=1):
        u = k / len(got)
        target = pose.copy()
        target[0, 3] -= 0.1 * u * u * (3 - 2 * u)
        qd = controller.step(q, qd, target)
        q = q + DT * qd
        np.testing.assert_allclose(row, q, rtol=0, atol=1e-9)


@pytest.mark.compiler
def test_a_rollout_in_c_is_the_loop_in_python(panda, circle):
    controller = mp.Controller(panda, mp.formulations.LogDrive(), dt=DT, tolerance=mp.Tolerance(position=0.02, rotation=0.08))
    targets = circle.sample(200)
    motion = controller.rollout(START, targets, stiffness=10.0)
    controller.reset()
    q, qd = START, np.zeros(7)
    for k, target in enumerate(targets):
        qd = controller.step(q, qd, target, stiffness=10.0)
        q = q + DT * qd
        np.testing.assert_allclose(motion.q[k + 1], q, rtol=0, atol=1e-9)


@pytest.mark.slow
def test_wrong_input_is_refused(panda, circle):
    sphere = mp.Scene([mp.Sphere(radius=0.1, position=(1.0, 0.0, 0.0), name="ball")])
    wrong = [
        (lambda: mp.formulations.Objective(-1.0), "alpha"),
        (lambda: mp.formulations.Objective(1.0, hessian="exakt"), "exact"),
        (lambda: mp.formulations.Equality(1.0, sample_time=0.0), "sample_time"),
        (lambda: mp.formulations.LogDrive(rate=0.0), "rate"),
        (lambda: mp.StiffnessProfile(low=0.0), "low"),
        (mp.Tolerance, "tolerance"),
        (lambda: mp.Tolerance(position=-1.0), "position"),
        (lambda: mp.Avoidance(scene=sphere, influence=0.01, security=0.02), "influence"),
        (lambda: mp.Avoidance(scene=sphere, moving=["bal"]), "ball"),
        (lambda: mp.Controller(panda, mp.formulations.LogDrive(), dt=0.0), "dt"),
        (lambda: mp.Controller(panda, "LogDrive", dt=DT), "formulation"),
        (lambda: mp.Controller(panda, mp.formulations.Classical(), dt=DT, tolerance=mp.Tolerance(position=0.1)), "Classical"),
        (lambda: mp.Controller(panda, mp.formulations.LogDrive(), dt=DT, stiffness=0.0, compiled=False), "stiffness"),
        (
            lambda: mp.Controller(
                panda, mp.formulations.LogDrive(), dt=DT, avoidance=mp.Avoidance(scene=sphere, links=["hand"])
            ),
            "panda_hand",
        ),
        (lambda: mp.track(panda, circle, START + 9.0, mp.formulations.LogDrive(), dt=DT), "start"),
        (lambda: mp.track(panda, "line", START, mp.formulations.LogDrive(), dt=DT), "path"),
        (lambda: mp.track(panda, circle, START, mp.formulations.LogDrive(), dt=DT, duration=-1.0), "duration"),
        (lambda: circle(1.5), "s"),
        (lambda: mp.CartesianPath.line(np.zeros((4, 4)), np.eye(4)), "start"),
        (lambda: mp.CartesianPath.through([np.eye(4)]), "poses"),
    ]
    for call, words in wrong:
        with pytest.raises(mp.errors.InvalidInputError, match=words):
            call()


def test_shapes_are_the_only_thing_a_step_raises_for(panda):
    controller = mp.Controller(panda, mp.formulations.LogDrive(), dt=DT, compiled=False)
    for q, qd, target in (([0.0] * 6, [0.0] * 7, np.eye(4)), ([0.0] * 7, 0.0, np.eye(4)), ([0.0] * 7, [0.0] * 7, np.eye(3))):
        with pytest.raises(mp.errors.InvalidInputError):
            controller.step(q, qd, target)
    assert controller.step(START.tolist(), [0] * 7, panda.kinematics().pose(START).tolist()).shape == (7,)


def test_poses_from_a_file(tmp_path):
    file = tmp_path / "poses.csv"
    file.write_text("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0.1,0,0,0.7071067811865476,0,0,0.7071067811865476\n")
    path = mp.CartesianPath.from_csv(file)
    np.testing.assert_allclose(path(1.0)[:3, 3], [0.1, 0.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(path.sample(7)[:, :3, :3] @ path.sample(7)[:, :3, :3].swapaxes(1, 2), [np.eye(3)] * 7, atol=1e-9)
    for text, words in (("x,y\n1,2\n", "first line"), ("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0\n", "row 2"), ("", "first line")):
        file.write_text(text)
        with pytest.raises(mp.errors.FileFormatError, match=words):
            mp.CartesianPath.from_csv(file)


@pytest.mark.slow
def test_random_steps_find_no_failure(tmp_path, monkeypatch):
    """The benchmark of a million steps, with few."""
    monkeypatch.syspath_prepend(str(Path(__file__).parents[2] / "benchmarks"))
    import random_steps

    counts = random_steps.main(["--steps", "500", "--arms", "xarm7", "--interpreted", "--out", str(tmp_path / "table.md")])
    assert counts["xarm7"].steps == 500
    assert counts["xarm7"].not_solved == counts["xarm7"].not_finite == counts["xarm7"].outside == 0


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5"])
def test_the_arm_comes_to_rest_before_a_target_out_of_reach(name):
    robot = mp.load_robot(name)
    controller = mp.Controller(robot, mp.formulations.General(), dt=DT, compiled=False)
    target = robot.kinematics().pose(robot.neutral).copy()
    target[:2, 3] *= 1 + 1 / np.linalg.norm(target[:2, 3])
    motion = controller.rollout(robot.neutral, np.repeat(target[None], 2000, axis=0))
    assert np.abs(motion.qd[-50:]).max() < 0.02


def test_a_rotation_about_a_free_tool_axis_is_no_deviation(panda):
    start = panda.kinematics().pose(START)
    end = start.copy()
    end[:3, :3] = start[:3, :3] @ np.diag([-1.0, -1.0, 1.0])  # half a turn about the tool's z axis, which is free
    path = mp.CartesianPath.line(start, end)
    tracking = mp.track(
        panda, path, START, mp.formulations.General(), dt=DT, duration=1.0, task=mp.Task.pointing(), compiled=False
    )
    assert tracking.status.ok
    assert tracking.rotation_deviation.max() < 1e-3
    np.testing.assert_allclose(tracking.q[-1], START, atol=1e-3)
