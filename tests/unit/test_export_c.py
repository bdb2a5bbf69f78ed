"""The exported C project: it is built as a user would, and its controller is Python's, step by step."""

import ctypes
import shutil
import subprocess

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.support.compiler import find_compiler
from manipplan.tracking import export
from manipplan.tracking.controller import Controller
from manipplan.tracking.step import REPORT
from studies.dufour2020.quasi_newton import QuasiNewton

pytestmark = pytest.mark.compiler
DT = 0.01
Q = np.array([0.3, 0.8, 0.7])


@pytest.fixture(scope="module")
def arm():
    robot = mp.planar_arm([0.4, 0.3, 0.2]).with_limits(lower=-2.5, upper=2.5, velocity=2.0, acceleration=8.0)
    return robot.with_limits(jerk=800.0)


def run(*command, cwd):
    done = subprocess.run([str(each) for each in command], cwd=cwd, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done


def build(folder, by):
    """The example program, by CMake or by what CMakeLists.txt says."""
    if by == "cmake":
        run("cmake", "-S", folder, "-B", folder / "build", cwd=folder)
        run("cmake", "--build", folder / "build", cwd=folder)
        return folder / "build" / "example"
    flags = ("-std=c99", "-O2", "-I.", "-Iinclude", "example.c", "controller.c", "step.c", "lib/libdaqpstat.a", "-lm")
    run(*find_compiler(), *flags, "-o", "example", cwd=folder)
    return folder / "example"


def example_in_python(controller):
    """What the example program does: 0.1 m along -x in a second; q, status and manipulability after each step."""
    robot, steps = controller.robot, int(np.ceil(1 / controller.dt))
    q, qd, pose = robot.neutral, np.zeros(robot.n), np.array(robot.kinematics(controller.task).pose(robot.neutral))
    lines, start = [], pose[0, 3]
    controller.reset()
    for k in range(1, steps + 1):
        u = k / steps
        pose[0, 3] = start - 0.1 * u * u * (3 - 2 * u)
        qd = controller.step(q, qd, pose)
        q = q + controller.dt * qd
        lines.append([*q, controller.report.status, controller.report.manipulability])
    return np.array(lines)


BUILDS = [
    pytest.param("cmake", marks=pytest.mark.skipif(shutil.which("cmake") is None, reason="there is no cmake")),
    "by hand",
]


@pytest.mark.slow
@pytest.mark.parametrize("by", BUILDS)
def test_the_example_program_prints_what_python_computes(panda, tmp_path, by):
    """The Panda within a tube, at work on its limits of jerk."""
    tube = mp.Tolerance(position=0.02, rotation=0.1)
    controller = Controller(panda, mp.formulations.LogDrive(), dt=0.002, tolerance=tube, compiled=False)
    files = controller.export_c(tmp_path / "controller")
    assert all(file.is_file() for file in files)
    folder = tmp_path / "elsewhere"  # nothing in it may point to where it was written
    shutil.move(tmp_path / "controller", folder)
    program = build(folder, by)
    printed = run(program, cwd=folder).stdout
    found = np.array([[float(word) for word in line.split()] for line in printed.splitlines()])
    expected = example_in_python(controller)
    assert found.shape == expected.shape == (500, 9)
    assert not found[:, 7].any()
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


class Exported:
    """The exported controller as a shared library, called as a C program calls it."""

    def __init__(self, controller, folder):
        controller.export_c(folder)
        flags = ("-std=c99", "-O2", "-shared", "-fPIC", "-I.", "-Iinclude", "controller.c", "step.c")
        run(*find_compiler(), *flags, "lib/libdaqpstat.a", "-lm", "-o", "controller.so", cwd=folder)
        self.library = ctypes.CDLL(str(folder / "controller.so"))
        self.library.controller_new.restype = ctypes.c_void_p
        self.held = ctypes.c_void_p(self.library.controller_new())
        assert self.held
        self.n = controller.robot.n

    def step(self, q, qd, qdd, target, stiffness, drive, tolerance, obstacles):
        velocity, report = np.full(self.n, np.nan), np.full(len(REPORT), np.nan)
        arrays = [np.ascontiguousarray(each, dtype=float) for each in (q, qd, qdd, target)]
        more = [np.ascontiguousarray(each, dtype=float) for each in (tolerance, [*obstacles, 0.0])]
        status = self.library.controller_step(
            self.held,
            *(pointer(each) for each in arrays),
            ctypes.c_double(stiffness),
            ctypes.c_double(drive),
            *(pointer(each) for each in (*more, velocity, report)),
        )
        return status, velocity, report

    def close(self):
        self.library.controller_free(self.held)


def pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


CASES = {
    "bfgs": (QuasiNewton(10.0, "bfgs"), {}),
    "moving obstacles": (
        mp.formulations.LogDrive(),
        {
            "avoidance": mp.Avoidance(
                scene=mp.Scene(
                    [
                        mp.Sphere(radius=0.05, position=(0.52, 0.8, 0.0), name="ball"),
                        mp.Box(size=(0.1, 0.1, 0.1), position=(-0.5, 0.0, 0.0), name="box"),
                    ]
                ),
                moving=["box", "ball"],
            ),
            "tolerance": mp.Tolerance(position=0.03),
        },
    ),
    "classical": (mp.formulations.Classical(gain=0.5), {"approach": np.inf}),
}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_the_exported_controller_is_python_s_step_by_step(arm, tmp_path, case):
    formulation, options = CASES[case]
    controller = Controller(arm, formulation, dt=DT, compiled=False, **options)
    exported = Exported(controller, tmp_path)
    q, qd, qdd, near = Q, np.zeros(3), np.zeros(3), np.inf
    pose = np.array(arm.kinematics().pose(Q))
    start, obstacles = pose[1, 3], None
    for k in range(200):
        pose[1, 3] = start + 0.25 * np.sin(2 * np.pi * k / 100)
        stiffness, drive = 10.0 ** (4 - k % 3), (k % 5) / 4
        if "avoidance" in options:
            ball = pin.SE3(np.eye(3), np.array([0.52, 0.8 - 0.05 * k / 100, 0.0]))
            obstacles = {"ball": (ball, np.array([0.0, -0.05, 0, 0, 0, 0]))}
        expected = controller.step(q, qd, pose, stiffness=stiffness, drive=drive, obstacles=obstacles)
        given = controller.defaults
        status, found, report = exported.step(q, qd, qdd, pose, stiffness, drive, given["tolerance"], given["obstacles"])
        assert status == controller.report.status == mp.results.StepStatus.SOLVED
        near = min(near, controller.report.clearance)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)
        finite = np.isfinite(report)
        np.testing.assert_allclose(report[finite], controller._report[finite], rtol=0, atol=1e-11)
        qdd, q, qd = (expected - qd) / DT, q + DT * expected, expected
    assert near < 0.1 or "avoidance" not in options
    exported.close()


@pytest.mark.slow
def test_the_exported_controller_tells_a_bad_target_and_a_bad_state(arm, tmp_path):
    exported = Exported(Controller(arm, mp.formulations.LogDrive(), dt=DT, compiled=False), tmp_path)
    pose, zero, tube = np.array(arm.kinematics().pose(Q)), np.zeros(3), [1e12, 1e12]
    speed = np.array([0.5, -0.5, 0.0])
    status, velocity, _ = exported.step(Q, speed, zero, np.full((4, 4), np.nan), 1e4, 1.0, tube, [])
    assert status == mp.results.StepStatus.BAD_TARGET
    np.testing.assert_allclose(np.abs(velocity), [0.42, 0.42, 0.0], atol=1e-12)
    status, velocity, _ = exported.step(np.full(3, np.nan), zero, zero, pose, 1e4, 1.0, tube, [])
    assert status == mp.results.StepStatus.BAD_STATE
    np.testing.assert_array_equal(velocity, 0)
    status, velocity, _ = exported.step(Q, zero, zero, pose, 1e4, 1.0, tube, [])
    assert status == mp.results.StepStatus.SOLVED
    assert np.isfinite(velocity).all()
    exported.close()


@pytest.mark.slow
def test_two_exported_controllers_do_not_share_what_they_learn(arm, tmp_path):
    controller = Controller(arm, QuasiNewton(10.0, "bfgs"), dt=DT, compiled=False)
    first = Exported(controller, tmp_path)
    second = first.library.controller_new
    other = Exported.__new__(Exported)
    other.library, other.held, other.n = first.library, ctypes.c_void_p(second()), 3
    pose, zero, tube = np.array(arm.kinematics().pose(Q)), np.zeros(3), [1e12, 1e12]
    fresh = other.step(Q, zero, zero, pose, 10.0, 1.0, tube, [])[1]
    for k in range(5):
        learned = first.step(Q + 0.02 * k, zero, zero, pose, 10.0, 1.0, tube, [])[1]
    again = other.step(Q, zero, zero, pose, 10.0, 1.0, tube, [])[1]
    assert np.abs(learned - fresh).max() > 1e-6
    np.testing.assert_allclose(again, fresh, rtol=0, atol=1e-12)
    first.close()
    other.close()


def test_the_header_compiles_without_warnings_as_c_and_says_its_numbers(arm, tmp_path):
    Controller(arm, mp.formulations.LogDrive(), dt=DT, compiled=False).export_c(tmp_path)
    text = (tmp_path / "controller.h").read_text()
    assert "#define CONTROLLER_JOINTS 3" in text
    assert "#define CONTROLLER_DT 0.01" in text
    assert "@" not in text
    flags = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", "-I.")
    for file in ("controller.c", "example.c"):
        run(*find_compiler(), *flags, file, "-o", "object.o", cwd=tmp_path)


def test_a_folder_that_cannot_be_written_raises(arm, tmp_path):
    taken = tmp_path / "file"
    taken.write_text("")
    with pytest.raises(mp.errors.InvalidInputError, match="folder: "):
        Controller(arm, mp.formulations.General(), dt=DT, compiled=False).export_c(taken)


def test_generated_code_of_the_solver_is_changed_only_where_it_is_known(arm):
    controller = Controller(arm, mp.formulations.LogDrive(), dt=DT, compiled=False)
    step = export.generate_source([controller.symbolic])
    changed = controller.sources().step
    assert changed.count("d_qp.x[0] = 0.0 / 0.0") == 1 and "0.0 / 0.0" not in step
    for other in (step.replace("casadi_daqp_solve(d, arg", "casadi_daqp_solve(d,  arg"), step.replace("return -1", "return 1")):
        with pytest.raises(mp.errors.ManipplanError, match=r"CasADi .* other code for DAQP"):
            export._going_on(other)
    closed_form = Controller(arm, mp.formulations.Classical(), dt=DT, compiled=False)
    assert closed_form.sources().step == export.generate_source([closed_form.symbolic])
