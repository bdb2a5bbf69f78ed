"""Seeds: an objective that OMPL really asks, repeatable searches, time limits, recorded motions, and interrupts."""

import csv
import json
import signal
import subprocess
import sys
import time
from itertools import product
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.collision.model import CollisionModel
from manipplan.optimize.problem import initial_path
from manipplan.seeds import connect
from manipplan.seeds.connect import MotionCheck
from manipplan.seeds.ompl import motion_cost, ompl_objective
from manipplan.seeds.seeding import OPTIMISING, PLANNERS, STAR

START, GOAL = [0, 1.5, -2], [np.pi, -2, 2]
POST = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
#: What the optimising planners lower: the length, or g with power 2.
OBJECTIVES = {"length": None, "manipulability": mp.PathObjective(power=2)}


def test_the_cost_of_a_motion_is_that_of_its_straight_path(planar, ur5, rng):
    for robot, power, middle in ((planar, 2.0, [0.0, 1.2, 1.0]), (ur5, 1.0, [0.0, -1.2, 1.5, -1.0, -1.2, 0.0])):
        integral = mp.PathObjective(power=power).integral(robot)
        for _ in range(5):
            first, second = middle + 0.5 * rng.uniform(-1, 1, (2, robot.n))
            expected = mp.path_cost(mp.JointPath.line(first, second), robot.kinematics(), power, panels=400).g
            assert motion_cost(integral, first, second) == pytest.approx(expected, rel=2e-3)
    assert motion_cost(integral, first, first) == 0.0


def test_the_cost_of_a_motion_counts_the_metric_and_the_measure(planar):
    first, second, weights = np.array([0.0, 1.2, 1.0]), np.array([0.3, 1.5, 0.4]), np.array([4.0, 1.0, 0.25])
    integral = mp.PathObjective(measure="smallest_singular_value", metric=weights, power=2.0).integral(planar)
    kinematics = planar.kinematics(measure="smallest_singular_value")
    expected = mp.path_cost(mp.JointPath.line(first, second), kinematics, 2.0, metric=weights, panels=400).g
    assert motion_cost(integral, first, second) == pytest.approx(expected, rel=2e-3)


def test_ompl_asks_the_objective_and_adds_its_costs(planar):
    from ompl import base, geometric, util

    util.setLogLevel(util.LogLevel.LOG_NONE)
    space = base.RealVectorStateSpace(3)
    bounds = base.RealVectorBounds(3)
    bounds.setLow(-np.pi)
    bounds.setHigh(np.pi)
    space.setBounds(bounds)
    information = base.SpaceInformation(space)
    information.setStateValidityChecker(lambda state: True)
    information.setup()
    path = geometric.PathGeometric(information)
    points = np.array([START, [1.0, 1.0, 1.0], [2.0, -1.5, 1.5], GOAL])
    for point in points:
        state = space.allocState()
        state[0:3] = [float(x) for x in point]
        path.append(state)
    cost = path.cost(ompl_objective(information, mp.PathObjective(power=2.0).integral(planar))).value()
    assert cost == pytest.approx(mp.path_cost(mp.JointPath.through(points), planar.kinematics(), 2).g, rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("planner", OPTIMISING)
def test_a_search_with_an_objective_finds_a_lower_g(planar, planner):
    seeding, g = mp.Seeding(planner=planner, time_limit=30.0), {}
    for name, objective in OBJECTIVES.items():
        path = mp.seed_path(planar, START, GOAL, seeding=seeding, objective=objective, checks=20_000)
        g[name] = mp.path_cost(path, planar.kinematics(), 2).g
    least = mp.optimize_path(
        planar, START, GOAL, shape=mp.PathShape(degree=10), objective=mp.PathObjective(power=2), seeding=mp.Seeding(count=4)
    ).g
    assert 0.999 * least < g["manipulability"] < min(0.5 * g["length"], 1.4 * least)


@pytest.mark.slow
def test_among_obstacles_the_gain_survives_what_makes_a_path_simpler(planar):
    seeding, g = mp.Seeding(planner="BITstar", time_limit=60.0), {}
    for name, objective in OBJECTIVES.items():
        path = mp.seed_path(planar, START, GOAL, POST, seeding=seeding, objective=objective)
        g[name] = mp.path_cost(path, planar.kinematics(), 2).g
    assert g["manipulability"] < 0.8 * g["length"]


REPEAT = """
import json, sys
import manipplan as mp
arm = mp.planar_arm([1.0, 1.0, 1.0])
post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
found = {}
for planner in sys.argv[1:]:
    seeding = mp.Seeding(planner=planner, seed=5, time_limit=60.0)
    path = mp.seed_path(arm, [0, 1.5, -2], [3.14, -2, 2], post, seeding=seeding, checks=8000)
    found[planner] = path.control.tolist()
print(json.dumps(found))
"""


@pytest.mark.slow
def test_another_process_finds_the_same_paths():
    planners = list(PLANNERS)
    runs = [
        subprocess.Popen([sys.executable, "-c", REPEAT, *planners], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for _ in range(2)
    ]
    first, second = (json.loads(run.communicate(timeout=120)[0]) for run in runs)
    assert list(first) == planners
    for planner in planners:
        assert first[planner] == second[planner], planner


@pytest.mark.slow
@pytest.mark.parametrize("planner", [name for name in PLANNERS if name != STAR])
def test_the_time_limit_holds_where_checks_are_slow(planar, planner, monkeypatch):
    quick = CollisionModel.in_collision

    def slow(model, q, **options):
        time.sleep(0.02)
        return quick(model, q, **options)

    mp.seed_path(planar, START, GOAL, POST, seeding=mp.Seeding(planner="RRTConnect"))  # loads and compiles
    monkeypatch.setattr(CollisionModel, "in_collision", slow)
    monkeypatch.setattr(connect, "MOST_JOINTS", 1)  # the compiled check does not ask it
    began = time.monotonic()
    try:
        mp.seed_path(planar, START, GOAL, POST, seeding=mp.Seeding(planner=planner, time_limit=0.6))
    except mp.errors.PlanningError as error:
        assert "allow more time" in str(error)
    assert time.monotonic() - began < 0.6 + 0.6


def test_too_few_checks_are_told(planar):
    with pytest.raises(mp.errors.PlanningError, match=r"by BITstar with 50 checks; allow more of them \(checks\)"):
        mp.seed_path(planar, START, GOAL, POST, seeding=mp.Seeding(planner="BITstar"), checks=50)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"objective": "length"}, "objective: got 'length'; allowed: a PathObjective"),
        ({"objective": mp.PathObjective(measure="log_det")}, "measure: got 'log_det'.*better when larger"),
        ({"objective": mp.PathObjective(metric=[1.0, 1.0])}, "metric.*3 weights above zero"),
        ({"seeding": "BITstar"}, "seeding: got 'BITstar'; allowed: a Seeding"),
        ({"seeding": mp.Seeding(count=2)}, r"seeding\.count: got 2; allowed: 1: seed_path looks for one path"),
        ({"seeding": mp.Seeding(shifts="within-limits")}, r"seeding\.shifts: got 'within-limits'; allowed: 'none'"),
        ({"seeding": mp.Seeding(initial=mp.JointPath.line(START, GOAL))}, r"seeding\.initial: .*allowed: None"),
        ({"checks": 0}, "checks: got 0"),
        ({"clearance": 3.0}, "(start|goal): .* apart, but the required clearance is 3 m"),
        ({"start": [np.nan, 0, 0]}, "start.*finite"),
    ],
)
def test_wrong_arguments(planar, change, message):
    options = {"start": START, "goal": GOAL, "scene": POST, **change}
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.seed_path(planar, **options)


@pytest.mark.slow
def test_a_recorded_motion_is_a_first_path(planar, tmp_path):
    seed = mp.seed_path(planar, START, GOAL, POST)
    motion = mp.retime(seed, planar.with_limits(velocity=1.0, acceleration=2.0))
    start, goal = motion.q[0], motion.q[-1]
    motion.to_csv(tmp_path / "motion.csv")
    motion.to_json(tmp_path / "motion.json")
    motion.to_npz(tmp_path / "motion.npz")
    motion.to_ros(tmp_path / "motion.yaml")
    results = [
        mp.optimize_path(
            planar, start, goal, objective=mp.PathObjective(power=2), scene=POST, seeding=mp.Seeding(initial=first)
        )
        for first in (motion, str(tmp_path / "motion.csv"))
    ]
    assert results[0].status is mp.Status.OPTIMAL
    assert results[0].g == pytest.approx(results[1].g, rel=1e-6)
    assert results[0].seed_cost.length == pytest.approx(seed.length, rel=1e-4)
    for kind in ("json", "npz", "yaml"):
        again = initial_path(planar, tmp_path / f"motion.{kind}")
        np.testing.assert_allclose(again(0.37), motion.path()(0.37), atol=1e-6)


def test_wrong_first_paths(planar, tmp_path):
    names = ("a", "b", "c")
    other = mp.Trajectory(t=[0.0, 1.0], q=[START, GOAL], qd=np.zeros((2, 3)), joint_names=names)
    rows = "time,q_joint1,q_joint2,q_joint3\n0,0,1.5,-2\n1,nan,0,0\n2,3.1,-2,2\n"
    (tmp_path / "nan.csv").write_text(
        rows.replace("joint1", planar.joint_names[0])
        .replace("joint2", planar.joint_names[1])
        .replace("joint3", planar.joint_names[2])
    )
    for initial, message in (
        (other, "initial: got 'one of a, b, c'; allowed: a motion of the joints"),
        (tmp_path / "nan.csv", "finite|number"),
        (tmp_path / "motion.txt", r"initial: .*\.csv"),
        (tmp_path / "none.csv", "an existing file"),
        (3, "initial: got 3; allowed: a JointPath, a Trajectory"),
        (mp.JointPath.line(START, [3.0, -2, 2]), f"initial: .*goal is 0.142 off at {planar.joint_names[0]}"),
        (
            mp.JointPath.line(START, GOAL),
            r"initial: got .*post (overlapping|.* m apart) .*at s = 0\.\d+|initial: .*and post overlapping by .* at s",
        ),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            mp.optimize_path(planar, START, GOAL, scene=POST, seeding=mp.Seeding(initial=initial))


INTERRUPTED = """
import sys, threading, time, os, signal
import manipplan as mp
arm = mp.planar_arm([1.0, 1.0, 1.0])
post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
ends = [0, 1.5, -2], [3.14, -2, 2]
first = mp.seed_path(arm, *ends, post)
given = {"shape": mp.PathShape(degree=4), "seeding": mp.Seeding(initial=first)}
mp.optimize_path(arm, *ends, post, **given)
threading.Timer(float(sys.argv[1]), lambda: os.kill(os.getpid(), signal.SIGINT)).start()
began, results = time.monotonic(), 0
while time.monotonic() - began < 20:
    result = mp.optimize_path(arm, *ends, post, objective=mp.PathObjective(power=2), **given)
    results += 1
    if result.status is mp.Status.INTERRUPTED:
        assert post.collision_model(arm).path_is_free(result.path, 1e-3)
        assert result.g <= result.seed_cost.g
        assert "interrupted" in str(result.certificate)
        print("interrupted", results)
        break
"""


@pytest.mark.slow
@pytest.mark.parametrize("after", [0.05, 0.4, 0.75])
def test_an_interrupt_returns_the_best_so_far(after, sigint):
    run = subprocess.run(
        [sys.executable, "-c", INTERRUPTED, str(after)], capture_output=True, text=True, timeout=60, check=False
    )
    # outside the solves, a moment of each call, it is a KeyboardInterrupt as anywhere
    assert run.stdout.startswith("interrupted") or "KeyboardInterrupt" in run.stderr, run.stderr[-2000:]
    assert "AssertionError" not in run.stderr


@pytest.mark.slow
def test_an_interrupt_between_two_solves(planar, monkeypatch, sigint):
    """A later descent is interrupted: the best path so far is returned, and the status says so."""
    from manipplan.optimize import local

    descend, calls = local.descend, []

    def interrupted(*arguments, **options):
        calls.append(arguments)
        if len(calls) == 3:
            signal.raise_signal(signal.SIGINT)
        return descend(*arguments, **options)

    monkeypatch.setattr(local, "descend", interrupted)
    seed = mp.seed_path(planar, START, GOAL, POST)
    result = mp.optimize_path(
        planar, START, GOAL, objective=mp.PathObjective(power=2), scene=POST, seeding=mp.Seeding(initial=seed)
    )
    assert len(calls) == 3
    assert result.status is mp.Status.INTERRUPTED
    assert not result.status.ok
    assert result.status.has_path
    assert result.g <= result.seed_cost.g
    calls.clear()
    with pytest.raises(KeyboardInterrupt):
        mp.plan(planar, START, GOAL, POST, objective=mp.PathObjective(power=2))


def test_an_interrupt_of_the_measurement_keeps_the_path(planar, monkeypatch, sigint):
    """What was found is returned when the interrupt comes after the last solve."""
    from manipplan.optimize.local import LocalSearch

    monkeypatch.setattr(LocalSearch, "unconstrained_g", lambda *_: signal.raise_signal(signal.SIGINT))
    result = mp.optimize_path(planar, START, GOAL, objective=mp.PathObjective(power=2), compare=True)
    assert result.status is mp.Status.INTERRUPTED
    assert result.g < result.seed_cost.g
    assert np.isnan(result.certificate.unconstrained_g)


@pytest.mark.slow
def test_an_interrupt_of_a_solve_is_quiet(planar, sigint):
    """CasADi tells of it on the standard error stream, in pieces."""
    code = (
        "import os, signal, threading, time\n"
        "import manipplan as mp\n"
        "arm = mp.planar_arm([1.0] * 5)\n"
        "threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "began, result, shape = time.monotonic(), None, mp.PathShape(degree=14)\n"
        "while time.monotonic() - began < 20 and (result is None or result.status is not mp.Status.INTERRUPTED):\n"
        "    result = mp.optimize_path(arm, [0.1, 1.5, -2, 1, 1], [3, -2, 2, 1, -1], shape=shape, compiled=False)\n"
        "print(result.status.name)\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False)
    assert "INTERRUPTED" in run.stdout or "KeyboardInterrupt" in run.stderr, run.stderr[-2000:]
    assert "CasADi" not in run.stderr


def test_other_lines_pass_while_an_interrupt_is_told(capsys, sigint):
    from manipplan.support.progress import interruptible

    with pytest.raises(KeyboardInterrupt), interruptible():
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            for piece in ("before\nCas", "ADi - 20", "26 WARNING", "\nafter\n", "CasA"):
                sys.stderr.write(piece)
    assert capsys.readouterr().err == "before\nafter\nCasA"


def test_an_interrupt_of_the_planner_is_raised(planar, monkeypatch, sigint):
    def interrupt(*_, **__):
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(MotionCheck, "motion", interrupt)
    with pytest.raises(KeyboardInterrupt):
        mp.optimize_path(planar, START, GOAL, scene=POST, seeding=mp.Seeding(planner="RRTConnect"))


#: Pairs of the UR5 in one aspect, among them some around whose table the shortest ways cross a singularity.
SUITE = Path(__file__).parents[2] / "benchmarks" / "pairs"


def det_signs(robot, path):
    """Signs of det J at every milliradian, by Pinocchio alone."""
    data = robot.model.createData()
    frame = robot.model.getFrameId(robot.tool, pin.FrameType.BODY)
    signs = set()
    for q in path(path.fine_samples(1e-3)):
        pin.computeJointJacobians(robot.model, data, q)
        pin.updateFramePlacements(robot.model, data)
        signs.add(np.sign(np.linalg.det(pin.getFrameJacobian(robot.model, data, frame, pin.LOCAL_WORLD_ALIGNED))))
    return signs


@pytest.mark.slow
@pytest.mark.parametrize("planner", ["auto", "RRTConnect"])
def test_a_seed_that_keeps_its_aspect_crosses_no_singularity(ur5, planner):
    lines = [line for line in (SUITE / "pairs.csv").read_text().splitlines() if not line.startswith("#")]
    rows = [row for row in csv.DictReader(lines) if row["arm"] == "ur5" and row["scene"] == "table"]
    scene = mp.Scene.from_yaml(SUITE / "table_ur5.yaml")
    crossing = 0
    for row, seed in product((6, 8), range(4)):
        start, goal = (np.array(rows[row][end].split(), dtype=float) for end in ("start", "goal"))
        seeding = mp.Seeding(planner=planner, seed=seed, time_limit=30.0)
        free = mp.seed_path(ur5, start, goal, scene, seeding=seeding)
        kept = mp.seed_path(ur5, start, goal, scene, same_aspect=True, seeding=seeding)
        crossing += len(det_signs(ur5, free)) > 1
        assert len(det_signs(ur5, kept)) == 1
        assert not scene.in_collision(ur5, kept(kept.fine_samples(1e-3))).any()
        assert np.isfinite(mp.path_cost(kept, ur5.kinematics(), 1.0).g)
    assert crossing >= 1


def test_an_aspect_needs_a_square_jacobian_and_one_sign(ur5, panda):
    with pytest.raises(
        mp.errors.InvalidInputError, match="same_aspect: got True; allowed: False: det J of the task pose has no sign"
    ):
        mp.seed_path(panda, panda.neutral, panda.neutral + 0.2, same_aspect=True)
    q = np.array([0.0, -1.2, 1.5, -1.0, -1.2, 0.0])
    for others, message in (
        (q * [1, 1, 1, 1, -1, 1], "start and goal lie in different aspects of the task pose"),
        (q * [1, 1, 1, 1, 0, 1], "goal is singular for the task pose"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            mp.seed_path(ur5, q, others, same_aspect=True)
