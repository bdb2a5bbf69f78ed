"""Controller: statuses, arguments, machine code against CasADi's virtual machine, rollout against single steps."""

import copy
import pickle
from dataclasses import dataclass

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.paths.tolerance import row_shares
from manipplan.support.compiler import find_compiler
from manipplan.tracking.controller import Controller
from studies.dufour2020.quasi_newton import QuasiNewton

DT = 0.01
REST = np.zeros(3)
Q = np.array([0.3, 0.8, 0.7])
FORMULATIONS = [
    mp.formulations.Classical(gain=0.1),
    mp.formulations.General(),
    mp.formulations.Objective(alpha=10.0),
    mp.formulations.Equality(alpha=100.0),
    mp.formulations.LogDrive(),
]


@dataclass(frozen=True)
class Near(mp.measures.Measure):
    """A measure of one's own: 1 at Q, less elsewhere."""

    name, formula, source = "near", "exp(-‖q - Q‖²/4)", ""

    def unit(self, task):
        return "1"

    def value(self, posture):
        return ca.exp(-ca.sumsqr(posture.q - Q) / 4)


@dataclass(frozen=True)
class Depth(Near):
    """One that is better when smaller."""

    name, larger_is_better = "depth", False


@pytest.fixture(scope="module")
def arm():
    return mp.planar_arm([0.4, 0.3, 0.2]).with_limits(lower=-2.5, upper=2.5, velocity=2.0, acceleration=8.0)


@pytest.fixture(scope="module")
def ball():
    return mp.Scene([mp.Sphere(radius=0.05, position=(0.0, 0.9, 0.0), name="ball")])


@pytest.fixture(scope="module")
def tracker(arm, ball):
    """With all that a controller can have; not compiled."""
    avoidance = mp.Avoidance(scene=ball, moving=["ball"])
    return Controller(
        arm, mp.formulations.LogDrive(), dt=DT, tolerance=mp.Tolerance(position=0.05), avoidance=avoidance, compiled=False
    )


@pytest.fixture
def controller(tracker):
    tracker.reset()
    tracker._set_obstacles({"ball": (pin.SE3(np.eye(3), np.array([0.0, 0.9, 0.0])), np.zeros(6))})
    tracker.step(Q, REST, tracker.robot.kinematics().pose(Q))
    return tracker


def pose_of(arm, q=Q, shift=(0.0, 0.0, 0.0)):
    pose = np.array(arm.kinematics().pose(q))
    pose[:3, 3] += shift
    return pose


def targets(arm, count, size=0.2):
    """A sweep to and fro."""
    swing = size * np.sin(np.linspace(0, 2 * np.pi, count))
    return np.array([pose_of(arm, shift=(0.0, each, 0.0)) for each in swing])


# ---- statuses


BAD_TARGETS = {
    "target": {"target": np.full((4, 4), np.nan)},
    "infinite target": {"target": np.diag([np.inf, 1.0, 1.0, 1.0])},
    "negative stiffness": {"stiffness": -1.0},
    "zero stiffness": {"stiffness": 0.0},
    "NaN stiffness": {"stiffness": np.nan},
    "negative drive": {"drive": -1e-9},
    "NaN drive": {"drive": np.nan},
    "obstacle": {"obstacles": {"ball": (np.full((4, 4), np.nan), np.zeros(6))}},
    "obstacle's velocity": {"obstacles": {"ball": (np.eye(4), np.full(6, np.nan))}},
}


@pytest.mark.parametrize("given", BAD_TARGETS.values(), ids=BAD_TARGETS)
def test_what_is_no_usable_number_brakes_within_all_limits(controller, given):
    arm = controller.robot
    q, qd = Q, np.array([1.0, -1.5, 0.5])
    arguments = {"target": pose_of(arm), **given}
    for k in range(30):
        before, qd = qd, controller.step(q, qd, **arguments)
        assert controller.report.status == mp.results.StepStatus.BAD_TARGET
        np.testing.assert_allclose(qd, np.sign(before) * np.maximum(np.abs(before) - 8.0 * DT, 0), atol=1e-12)
        q = q + DT * qd
        if k == 20:
            assert not qd.any()


def test_obstacles_that_are_no_mapping_are_refused(controller, arm):
    with pytest.raises(mp.errors.InvalidInputError, match="obstacles: got 'ball'; allowed: a mapping"):
        controller.step(Q, REST, pose_of(arm), obstacles="ball")


def test_a_controller_is_not_copied(tracker):
    for copied in (copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match="make one in each process"):
            copied(tracker)


def test_braking_near_a_limit_stops_before_it(controller):
    q, qd = np.array([2.5 - 0.2, 0.0, -2.5 + 0.2]), np.array([1.7, 0.0, -1.7])
    for _ in range(40):
        qd = controller.brake(q, qd)
        q = q + DT * qd
    assert (np.abs(q) <= 2.5).all()
    assert not qd.any()


@pytest.mark.parametrize("bad", [np.nan, np.inf, 1e13])
@pytest.mark.parametrize("argument", ["q", "qd", "qdd"])
def test_a_state_that_is_no_number_gives_velocity_zero(controller, argument, bad):
    state = {"q": Q, "qd": np.ones(3), "qdd": REST}
    state[argument] = np.array([0.0, bad, 0.0])
    velocity = controller.step(target=pose_of(controller.robot), **state)
    np.testing.assert_array_equal(velocity, 0)
    assert controller.report.status == mp.results.StepStatus.BAD_STATE
    controller._acceleration[:] = 0.0


def test_after_numbers_that_are_none_a_step_is_as_good_as_the_first(arm):
    """Nothing of them is remembered: neither the target, nor what bfgs learned."""
    formulation = QuasiNewton(10.0, "bfgs")
    fresh, hurt = (Controller(arm, formulation, dt=DT, tolerance=mp.Tolerance(position=0.1), compiled=False) for _ in range(2))
    hurt.step(np.full(3, np.nan), REST, pose_of(arm))
    hurt.step(Q, REST, np.full((4, 4), np.nan))
    hurt.reset()
    target = pose_of(arm, shift=(0.01, 0.0, 0.0))
    np.testing.assert_array_equal(hurt.step(Q, REST, target), fresh.step(Q, REST, target))
    hurt.step(Q, REST, np.full((4, 4), np.nan))
    hurt.step(np.full(3, np.nan), REST, target)
    assert np.isfinite(hurt.step(Q, REST, target)).all()
    assert hurt.report.status == mp.results.StepStatus.SOLVED


@pytest.mark.compiler
def test_what_the_solver_gives_up_brakes_in_machine_code_as_well(arm, rng):
    """The paper's (10) with a huge α is indefinite. CasADi's generated code then returns an error and writes no answer: the
    velocity of the step before must not come back as if it were solved."""
    formulation, qd, given_up = mp.formulations.Objective(alpha=1e8, convexify=False), np.full(3, 0.5), 0
    virtual, machine = (Controller(arm, formulation, dt=DT, compiled=compiled) for compiled in (False, True))
    postures = [
        (np.array([0.7, -1.2, -2.3]), np.array([-2.4, 1.6, 2.1])),
        *arm.random_configuration(rng, size=400).reshape(-1, 2, 3),
    ]
    for q, goal in postures:
        for controller in (virtual, machine):
            controller.reset()
            controller.step(q, np.zeros(3), pose_of(arm, q), drive=0.0)
            controller.reset()
        expected = virtual.step(q, qd, pose_of(arm, goal), stiffness=1.0)
        found = machine.step(q, qd, pose_of(arm, goal), stiffness=1.0)
        if virtual.report.status == mp.results.StepStatus.NOT_SOLVED:
            given_up += 1
            assert machine.report.status == mp.results.StepStatus.NOT_SOLVED
            np.testing.assert_allclose(found, expected, atol=1e-12)
    assert given_up > 20


@pytest.mark.compiler
def test_rollout_goes_on_where_the_solver_gives_up(arm):
    formulation = mp.formulations.Objective(alpha=1e8, convexify=False)
    path = [pose_of(arm, np.array([-2.4, 1.6, 2.1]))] * 6
    runs = []
    for compiled in (False, True):
        controller = Controller(arm, formulation, dt=DT, compiled=compiled)
        runs.append(controller.rollout([0.7, -1.2, -2.3], path, qd=np.full(3, 0.5), stiffness=1.0))
    assert runs[0]["status"][0] == mp.results.StepStatus.NOT_SOLVED
    assert runs[1].q[1:].any(axis=1).all()
    np.testing.assert_allclose(runs[1].q[:2], runs[0].q[:2], atol=1e-12)
    np.testing.assert_array_equal(runs[1]["status"][0], runs[0]["status"][0])


# ---- arguments


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"q": [0.0, 0.0]}, r"q: .*shape \(3,\), not \(2,\)"),
        ({"q": [[0.0, 0.0, 0.0]]}, r"q: .*shape \(3,\), not \(1, 3\)"),
        ({"qd": np.zeros(4)}, r"qd: .*shape \(3,\), not \(4,\)"),
        ({"qdd": np.zeros(4)}, r"qdd: .*shape \(3,\), not \(4,\)"),
        ({"q": ["a", "b", "c"]}, "q: .*real numbers"),
        ({"target": np.eye(3)}, r"target: .*shape \(4, 4\), not \(3, 3\)"),
        ({"target": None}, "target: got None"),
        ({"obstacles": {"bal": (np.eye(4), np.zeros(6))}}, "obstacles: got 'bal'.*did you mean ball"),
        ({"obstacles": {"ball": (np.eye(3), np.zeros(6))}}, r"obstacles\[ball\]: .*a pose \(4, 4\)"),
        ({"obstacles": {"ball": (np.eye(4), np.zeros(3))}}, r"obstacles\[ball\]: .*velocity \(6,\)"),
        ({"stiffness": "high"}, "stiffness: got 'high'"),
        ({"drive": "all"}, "drive: got 'all'"),
        ({"obstacles": {"ball": ("here", np.zeros(6))}}, r"obstacles\[ball\]: got"),
    ],
)
def test_arguments_of_a_wrong_kind_raise(controller, given, message):
    arguments = {"q": Q, "qd": REST, "target": pose_of(controller.robot), **given}
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        controller.step(**arguments)


def test_all_kinds_of_numbers_are_taken(controller):
    """Lists, integers, single precision, strided arrays, pin.SE3."""
    arm = controller.robot
    q, target = np.array([0.0, 1.0, 1.0]), pose_of(arm, np.array([0.0, 1.0, 1.0]), (0.01, 0.0, 0.0))
    controller.reset()
    expected = controller.step(q, REST, target)
    strided = np.empty((3, 2))
    strided[:, 0] = q
    for other in (q.tolist(), q.astype(int), q.astype(np.float32), strided[:, 0]):
        controller.reset()
        np.testing.assert_array_equal(controller.step(other, [0, 0, 0], target), expected)
    for pose in (target.tolist(), pin.SE3(target), np.asfortranarray(target)):
        controller.reset()
        np.testing.assert_array_equal(controller.step(q, REST, pose), expected)


def test_the_result_is_the_caller_s_own(controller):
    first = controller.step(Q, REST, pose_of(controller.robot, shift=(0.01, 0.0, 0.0)))
    kept = first.copy()
    controller.step(Q, REST, pose_of(controller.robot, shift=(-0.1, 0.1, 0.0)))
    np.testing.assert_array_equal(first, kept)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"dt": 0.0}, "dt: got 0.0.*above 0"),
        ({"dt": -0.01}, "dt: got -0.01"),
        ({"dt": np.nan}, "dt: got nan"),
        ({"dt": "fast"}, "dt: got 'fast'"),
        ({"robot": "panda"}, "robot: got 'panda'"),
        ({"formulation": "LogDrive"}, "formulation: got 'LogDrive'"),
        ({"stiffness": 0.0}, "stiffness: got 0.0"),
        ({"weights": 0.0}, "weights: got 0.0"),
        ({"weights": [1.0, 2.0]}, "weights: .*3 of them"),
        ({"approach": 0.0}, "approach: got 0.0"),
        ({"approach": [1.0, 2.0]}, "approach: got"),
        ({"tolerance": 0.05}, "tolerance: got 0.05.*a Tolerance"),
        ({"avoidance": []}, r"avoidance: got \[\].*an? Avoidance"),
        (
            {"formulation": mp.formulations.Classical(), "tolerance": mp.Tolerance(position=0.1)},
            "tolerance: .*None with Classical",
        ),
        ({"formulation": mp.formulations.Classical(), "avoidance": mp.Avoidance()}, "avoidance: .*None with Classical"),
        ({"task": mp.Task.pose()}, "task: got 'pose'; allowed: at most 3 rows; with more rows than joints"),
        ({"measure": "log_det"}, "measure: got 'log_det'; allowed: .*better when larger: yoshikawa, frobenius, inverse_cond"),
        ({"measure": mp.measures.ConditionNumber()}, "measure: got 'condition_number'; allowed: .*better when larger"),
        ({"measure": mp.measures.ForceTransmission(direction=(1.0, 0.0))}, "measure: got 'force_transmission'"),
        ({"measure": Depth(), "formulation": mp.formulations.Classical()}, "measure: got 'depth'"),
        ({"measure": "isotropi"}, "measure: got 'isotropi'.*did you mean isotropy"),
        ({"measure": "velocity_transmission"}, "measure: .*needs a direction"),
        ({"measure": mp.measures.VelocityTransmission(direction=(1.0, 0.0, 0.0))}, "direction: .*2 numbers, one per task row"),
        ({"measure": mp.measures.FrobeniusNorm(weights=[1.0, 1.0])}, "weights: .*3 of them"),
        ({"measure": 3}, "measure: got 3"),
    ],
)
def test_options_that_cannot_be_used_raise(arm, options, message):
    given = {"robot": arm, "formulation": mp.formulations.General(), "dt": DT, "compiled": False, **options}
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        Controller(given.pop("robot"), given.pop("formulation"), dt=given.pop("dt"), **given)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: mp.formulations.Objective(alpha=-1.0), "alpha: got -1.0.*at least 0"),
        (lambda: mp.formulations.Equality(alpha=-1.0), "alpha: got -1.0"),
        (lambda: mp.formulations.Equality(alpha=np.nan), "alpha: got nan"),
        (lambda: mp.formulations.Objective(alpha=1.0, sample_time=0.0), "sample_time: got 0.0"),
        (lambda: mp.formulations.Objective(alpha=1.0, gradient="exat"), "gradient: got 'exat'.*did you mean exact"),
        (lambda: mp.formulations.Objective(alpha=1.0, hessian="centre"), "hessian: got 'centre'.*did you mean central"),
        (lambda: mp.formulations.Objective(alpha=1.0, convexify=1), "convexify: got 1"),
        (lambda: mp.formulations.LogDrive(weight=-1.0), "weight: got -1.0"),
        (lambda: mp.formulations.LogDrive(rate=0.0), "rate: got 0.0"),
        (lambda: mp.formulations.LogDrive(regularisation=0.0), "regularisation: got 0.0"),
        (lambda: mp.formulations.Classical(gain=-1.0), "gain: got -1.0"),
        (lambda: mp.formulations.Classical(damping=0.0), "damping: got 0.0"),
        (mp.Tolerance, "tolerance: got None"),
        (lambda: mp.Tolerance(position=0.0), "position: got 0.0"),
        (lambda: mp.Tolerance(rotation=-0.1), "rotation: got -0.1"),
        (lambda: mp.StiffnessProfile(low=0.0), "low: got 0.0"),
        (lambda: mp.StiffnessProfile(high=1.0, low=2.0), "high: got 1.0.*at least 2"),
        (lambda: mp.StiffnessProfile(degree=0.5), "degree: got 0.5"),
    ],
)
def test_values_that_cannot_be_used_raise(make, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        make()


def test_a_jerk_limit_needs_a_velocity_limit(arm):
    with pytest.raises(mp.errors.InvalidInputError, match="limits.velocity: .*for each joint with a jerk limit"):
        Controller(arm.with_limits(velocity=[1.0, np.inf, 1.0], jerk=100.0), mp.formulations.General(), dt=DT, compiled=False)


def test_a_tolerance_needs_a_controller_with_one(arm):
    controller = Controller(arm, mp.formulations.General(), dt=DT, compiled=False)
    with pytest.raises(mp.errors.InvalidInputError, match="tolerance: .*made without a tolerance"):
        controller.step(Q, REST, pose_of(arm), tolerance=mp.Tolerance(position=0.1))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"q": [0.0, np.nan, 0.0]}, "q: .*no NaN"),
        ({"q": [0.0]}, r"q: .*\(3,\)"),
        ({"targets": np.eye(4)}, "targets: .*any, 4, 4"),
        ({"targets": np.full((2, 4, 4), np.nan)}, "targets: .*no NaN"),
        ({"stiffness": [1.0, 2.0, 3.0]}, "stiffness: got"),
        ({"drive": [1.0, 1.0, 1.0]}, "drive: got"),
        ({"stiffness": [1.0, np.nan]}, "stiffness: .*NaN"),
        ({"drive": [1.0, np.inf]}, "drive: .*NaN or inf"),
    ],
)
def test_arguments_of_rollout_that_cannot_be_used_raise(controller, given, message):
    arguments = {"q": Q, "targets": targets(controller.robot, 2), **given}
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        controller.rollout(**arguments)


# ---- relaxation


def test_stiffness_profile_is_high_at_the_ends_and_low_in_the_middle():
    profile = mp.StiffnessProfile(high=1e5, low=10.0, degree=4.0)
    assert profile(0.0) == profile(1.0) == 1e5
    assert profile(0.5) == 10.0
    assert profile(0.25) == pytest.approx(10.0 + (1e5 - 10.0) / 16)
    assert profile(0.3) == pytest.approx(profile(0.7))


def test_shares_of_the_rows_make_a_box_inside_the_ball():
    """Its corners lie on the ball: |row| / sqrt(rows of that kind), angles by the task's length."""
    position, rotation = row_shares(mp.Task.pose(length=0.25))
    np.testing.assert_allclose(position, [3**-0.5] * 3 + [0] * 3)
    np.testing.assert_allclose(rotation, [0] * 3 + [0.25 * 3**-0.5] * 3)
    assert row_shares(mp.Task.position())[1] == [0, 0, 0]


def test_a_tolerance_of_rows_that_mix_raises(panda):
    mixed = mp.Task.custom([[1.0, 0, 0, 0, 0.5, 0], [0, 1.0, 0, 0, 0, 0]], length=1.0, name="mixed")
    with pytest.raises(mp.errors.InvalidInputError, match="tolerance: got 'mixed'.*not both in one"):
        Controller(panda, mp.formulations.General(), dt=DT, task=mixed, tolerance=mp.Tolerance(position=0.1), compiled=False)


def test_the_tolerance_of_one_step_does_not_stay(controller):
    target = pose_of(controller.robot)
    controller.step(Q, REST, target, tolerance=mp.Tolerance(position=0.01))
    assert controller._tube[0] == 0.01
    controller.step(Q, REST, target)
    assert controller._tube[0] == 0.05


# ---- the report


def test_report_holds_what_the_step_found(controller):
    arm = controller.robot
    velocity = controller.step(Q, REST, pose_of(arm, shift=(0.02, -0.01, 0.0)))
    report, kinematics = controller.report, arm.kinematics()
    assert report.status == mp.results.StepStatus.SOLVED
    assert report.manipulability == pytest.approx(kinematics.manipulability(Q))
    left = pose_of(arm, shift=(0.02, -0.01, 0.0)) - kinematics.pose(Q + DT * velocity)
    assert report.position_deviation == pytest.approx(np.linalg.norm(left[:2, 3]), abs=2e-5)
    assert report.rotation_deviation == 0
    assert report.clearance > 0.1
    assert report.avoidance_excess == pytest.approx(0, abs=1e-9)


def test_without_avoidance_the_clearance_is_infinite(arm):
    controller = Controller(arm, mp.formulations.General(), dt=DT, compiled=False)
    controller.step(Q, REST, pose_of(arm))
    assert controller.report.clearance == np.inf
    assert controller.pairs == ()


# ---- another measure than Yoshikawa's manipulability


@pytest.mark.parametrize("measure", ["frobenius", mp.measures.JointLimitPenalised(k=2.0), Near()], ids=str)
def test_report_has_the_given_measure(arm, measure):
    controller = Controller(arm, mp.formulations.LogDrive(), dt=DT, measure=measure, compiled=False)
    kinematics = arm.kinematics(measure=measure)
    controller.step(Q + 0.2, REST, pose_of(arm, Q + 0.2))
    assert controller.kinematics.measure == kinematics.measure
    assert controller.report.manipulability == pytest.approx(kinematics.manipulability(Q + 0.2))
    assert controller.report.status == mp.results.StepStatus.SOLVED


@pytest.mark.parametrize(
    "formulation", [mp.formulations.Objective(1e3), mp.formulations.Equality(1e3), mp.formulations.LogDrive()], ids=str
)
def test_a_measure_of_one_s_own_is_raised_until_the_null_space_holds_no_more(arm, formulation):
    """The tool stays where it is, and the joints come to rest where ∇m is orthogonal to the null space of J."""
    start = np.array([1.6, -0.9, 1.9])
    controller = Controller(arm, formulation, dt=DT, measure=Near(), compiled=False)
    run = controller.rollout(start, np.repeat(pose_of(arm, start)[None], 400, axis=0))
    assert (run["status"] == mp.results.StepStatus.SOLVED).all()
    assert run["position_deviation"].max() < 1e-3
    assert run["manipulability"][-1] > 1.2 * run["manipulability"][0]
    assert np.abs(run.qd[-1]).max() < 1e-4
    kinematics = arm.kinematics(measure=Near())
    null = np.linalg.svd(kinematics.jacobian(run.q[-1]))[2][-1]
    slope = kinematics.gradient(run.q[-1])
    assert abs(null @ kinematics.gradient(start)) > 0.02
    assert abs(null @ slope) < 1e-4 < np.linalg.norm(slope)


@pytest.mark.parametrize("start", [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0]])
@pytest.mark.parametrize("measure", ["inverse_condition", "smallest_singular_value", "isotropy", "asada", "dynamic"])
def test_a_measure_that_vanishes_drives_the_arm_out_of_a_singularity(arm, measure, start):
    """With hardly any stiffness; the measure and its gradient may be zero or not defined there."""
    controller = Controller(arm, mp.formulations.LogDrive(yields=False), dt=DT, measure=measure, stiffness=1e-3, compiled=False)
    run = controller.rollout(start, np.repeat(pose_of(arm, np.array(start))[None], 200, axis=0))
    assert np.isin(
        run["status"], (mp.results.StepStatus.SOLVED, mp.results.StepStatus.STALLED)
    ).all()  # the drive leads away from the target
    assert run["manipulability"][0] == pytest.approx(0, abs=1e-7)
    assert run["manipulability"][-1] > 0.02
    assert arm.kinematics().manipulability(run.q[-1]) > 0.03


# ---- machine code and rollout


def test_without_a_compiler_a_compiled_controller_is_refused(arm, monkeypatch):
    monkeypatch.setenv("CC", "")
    find_compiler.cache_clear()
    try:
        with pytest.raises(mp.errors.CompilerError, match="a controller of|there is no C compiler"):
            Controller(arm, mp.formulations.General(), dt=DT, compiled=True)
        assert not Controller(arm, mp.formulations.General(), dt=DT).compiled
    finally:
        find_compiler.cache_clear()


def assert_same_run(first, second, near=1e-9):
    for quantity in ("q", "qd", "reports"):
        np.testing.assert_allclose(getattr(first, quantity), getattr(second, quantity), rtol=near, atol=near)


def in_steps(controller, q, path, **options):
    """What rollout does, by step."""
    controller.reset()
    place, speed, reports = [np.array(q)], [np.zeros(len(q))], []
    for target in path:
        speed.append(controller.step(place[-1], speed[-1], target, **options))
        place.append(place[-1] + controller.dt * speed[-1])
        reports.append(controller._report.copy())
    return mp.results.Rollout(q=np.array(place), qd=np.array(speed), reports=np.array(reports))


@pytest.mark.parametrize("formulation", FORMULATIONS, ids=str)
def test_rollout_is_one_step_after_the_other(arm, formulation):
    controller = Controller(arm, formulation, dt=DT, compiled=False)
    path = targets(arm, 60)
    assert_same_run(controller.rollout(Q, path), in_steps(controller, Q, path), near=1e-15)


@pytest.mark.compiler
@pytest.mark.parametrize(
    ("formulation", "measure"),
    [
        (mp.formulations.LogDrive(), None),
        (QuasiNewton(10.0, "bfgs"), None),
        (mp.formulations.LogDrive(), "isotropy"),
    ],
    ids=str,
)
def test_machine_code_equals_the_virtual_machine(arm, ball, formulation, measure):
    """Rollout in C, steps of machine code, and CasADi's virtual machine; limits, tube, ball and jerk are at work."""
    robot = arm.with_limits(jerk=800.0)
    avoidance = mp.Avoidance(scene=ball, moving=["ball"])
    options = {"tolerance": mp.Tolerance(position=0.03), "avoidance": avoidance, "measure": measure}
    machine = Controller(robot, formulation, dt=DT, compiled=True, **options)
    virtual = Controller(robot, formulation, dt=DT, compiled=False, **options)
    assert machine.compiled
    assert not virtual.compiled
    near = {"ball": (pin.SE3(np.eye(3), np.array([0.52, 0.8, 0.0])), np.array([0.05, -0.1, 0, 0, 0, 0]))}
    path = targets(arm, 120, 0.3)
    for controller in (machine, virtual):
        controller.step(Q, REST, path[0], obstacles=near)
    runs = [machine.rollout(Q, path), in_steps(machine, Q, path), in_steps(virtual, Q, path)]
    assert (runs[0]["clearance"] < 0.1).any()
    assert (runs[0]["tube_excess"] > 0).any()
    assert_same_run(runs[1], runs[0])
    assert_same_run(runs[2], runs[0])
    with pytest.raises(mp.errors.UnknownNameError, match="figure: got 'clearence'.*clearance"):
        runs[0]["clearence"]


def test_rollout_takes_stiffness_and_drive_of_each_step(arm):
    controller = Controller(arm, mp.formulations.LogDrive(), dt=DT, compiled=False)
    path, drive, stiffness = targets(arm, 40), np.linspace(0, 1, 40), np.geomspace(1e4, 10, 40)
    run = controller.rollout(Q, path, stiffness=stiffness, drive=drive, qd=[0.1, 0.0, -0.1])
    controller.reset()
    q, qd = Q, np.array([0.1, 0.0, -0.1])
    for k in range(40):
        qd = controller.step(q, qd, path[k], stiffness=stiffness[k], drive=drive[k])
        q = q + DT * qd
    np.testing.assert_allclose(run.q[-1], q, rtol=0, atol=1e-14)


def test_reset_forgets_what_was_learned(arm):
    controller = Controller(arm.with_limits(jerk=200.0), QuasiNewton(10.0, "sr1"), dt=DT, compiled=False)
    path = targets(arm, 20)
    first = controller.rollout(Q, path)
    assert controller._memory.any()
    assert controller._acceleration.any()
    assert_same_run(controller.rollout(Q, path), first, near=0)


def test_the_last_acceleration_is_remembered_for_jerk_limits(arm):
    """From rest 200 rad/s³ allow 0.02 rad/s a step more than before; qdd says otherwise."""
    controller = Controller(arm.with_limits(jerk=200.0), mp.formulations.General(), dt=DT, compiled=False)
    far = pose_of(arm, np.array([2.0, 1.5, 1.0]))
    first = controller.step(Q, REST, far)
    assert np.abs(first).max() == pytest.approx(0.02)
    second = controller.step(Q, first, far)
    assert np.abs(second - 2 * first).max() <= 0.02 + 1e-12
    assert np.abs(second).max() == pytest.approx(0.06)
    third = controller.step(Q, first, far, qdd=REST)
    assert np.abs(third).max() == pytest.approx(0.04)
