"""The grouped options of a path: they validate themselves, jobs refuse other types, and every field is used."""

import dataclasses

import numpy as np
import pytest

import manipplan as mp
from manipplan.jobs.plan import MORE_DEGREES, SPLINE_PIECES
from manipplan.optimize import problem
from manipplan.seeds.seeding import OPTIMISING, PLANNERS

START, GOAL = [0, 1.5, -2], [np.pi, -2, 2]
POST = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
LINE = mp.JointPath.line(START, GOAL)
GROUPS = {"objective": mp.PathObjective, "shape": mp.PathShape, "seeding": mp.Seeding}


@pytest.mark.parametrize(
    ("kind", "values", "message"),
    [
        (mp.PathObjective, {"power": 0}, "power: got 0; allowed: a finite number, above 0, at most 100"),
        (mp.PathObjective, {"power": -1.0}, "power: got -1"),
        (mp.PathObjective, {"power": 101}, "power: got 101"),
        (mp.PathObjective, {"power": np.nan}, "power: got nan"),
        (mp.PathObjective, {"power": True}, "power: got True"),
        (mp.PathObjective, {"power": "1"}, "power: got '1'"),
        (mp.PathObjective, {"task": "pose"}, "task: got 'pose'; allowed: a Task"),
        (mp.PathShape, {"degree": 0}, "degree: got 0; allowed: a whole number, at least 1, at most 20"),
        (mp.PathShape, {"degree": 21}, "degree: got 21"),
        (mp.PathShape, {"degree": 2.5}, "degree: got 2.5"),
        (mp.PathShape, {"degree": "6"}, "degree: got '6'"),
        (mp.PathShape, {"degree": True}, "degree: got True"),
        (mp.PathShape, {"degree": None}, "degree: got None"),
        (mp.PathShape, {"basis": "bsplines"}, r"basis: got 'bsplines'; allowed: did you mean bspline\?"),
        (mp.PathShape, {"basis": "legendr"}, "basis: got 'legendr'; allowed: did you mean legendre"),
        (mp.PathShape, {"basis": "fourier"}, "basis: got 'fourier'; allowed: one of bernstein, bspline"),
        (mp.PathShape, {"basis": 3}, "basis: got 3; allowed: one of"),
        (mp.PathShape, {"pieces": 3}, "pieces: got 3; allowed: 1 with basis 'legendre'"),
        (mp.PathShape, {"basis": "bspline", "pieces": 0}, "pieces: got 0"),
        (mp.PathShape, {"basis": "bspline", "pieces": 33}, "pieces: got 33.*at most 32"),
        (mp.PathShape, {"basis": "bspline", "pieces": 1.5}, "pieces: got 1.5"),
        (mp.PathShape, {"basis": "composite", "pieces": 32, "degree": 20}, "pieces: got 32; allowed: fewer.*608 coefficients"),
        (mp.PathShape, {"basis": "composite", "pieces": 3, "degree": 1}, "degree: got 1; allowed: at least 2"),
        (mp.Seeding, {"planner": "RRTconnect"}, "planner: got 'RRTconnect'; allowed: did you mean RRTConnect"),
        (mp.Seeding, {"planner": "PRM"}, "planner: got 'PRM'"),
        (mp.Seeding, {"planner": None}, "planner: got None; allowed: .*RRTConnect"),
        (mp.Seeding, {"shifts": "within_limits"}, "shifts: got 'within_limits'; allowed: did you mean within-limits"),
        (mp.Seeding, {"seed": -1}, "seed: got -1"),
        (mp.Seeding, {"seed": 0.5}, "seed: got 0.5"),
        (mp.Seeding, {"seed": 2**31}, "seed: got 2147483648"),
        (mp.Seeding, {"count": 0}, "count: got 0; allowed: a whole number, at least 1"),
        (mp.Seeding, {"count": 10_001}, "count: got 10001.*at most 10000"),
        (mp.Seeding, {"count": 2.0}, "count: got 2.0"),
        (mp.Seeding, {"time_limit": 0}, "time_limit: got 0; allowed: a finite number, above 0"),
        (mp.Seeding, {"time_limit": np.inf}, "time_limit: got inf"),
        (mp.Seeding, {"time_limit": "10 s"}, "time_limit: got '10 s'"),
        (mp.Seeding, {"initial": LINE, "count": 2}, "count: got 2; allowed: 1 together with an initial path"),
        (mp.Seeding, {"initial": LINE, "shifts": "within-limits"}, "shifts: got 'within-limits'; allowed: 'none' together"),
    ],
)
def test_a_wrong_value_raises_where_the_options_are_made(kind, values, message):
    with pytest.raises(mp.errors.InvalidInputError, match=f"^{message}") as caught:
        kind(**values)
    assert caught.value.argument in values


@pytest.mark.parametrize("kind", GROUPS.values())
def test_options_are_frozen_named_and_validated_again_when_they_are_replaced(kind):
    made = kind()
    name, value = {"PathObjective": ("power", -1), "PathShape": ("degree", 0), "Seeding": ("seed", -1)}[kind.__name__]
    with pytest.raises(dataclasses.FrozenInstanceError):
        setattr(made, name, 3)
    with pytest.raises(mp.errors.InvalidInputError, match=f"{name}: got {value}"):
        dataclasses.replace(made, **{name: value})
    with pytest.raises(TypeError):
        kind(2)


def test_values_have_the_types_of_their_fields():
    assert type(mp.PathObjective(power=np.int64(2)).power) is float
    shape = mp.PathShape(degree=np.int64(3), basis="bspline", pieces=np.int64(8))
    assert (type(shape.degree), type(shape.pieces)) == (int, int)
    seeding = mp.Seeding(seed=np.int64(3), count=np.int64(2), time_limit=5)
    assert (type(seeding.seed), type(seeding.count), type(seeding.time_limit)) == (int, int, float)


@pytest.mark.parametrize("planner", ["auto", *PLANNERS])
def test_each_planner_is_accepted(planner):
    assert mp.Seeding(planner=planner).planner == planner


@pytest.mark.parametrize("job", [mp.optimize_path, mp.plan])
@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("objective", 2.0),
        ("objective", "yoshikawa"),
        ("objective", None),
        ("objective", mp.PathShape()),
        ("shape", 6),
        ("shape", None),
        ("shape", mp.PathObjective),
        ("seeding", 0),
        ("seeding", None),
        ("seeding", LINE),
    ],
)
def test_options_of_another_type_are_refused(planar, job, name, value):
    with pytest.raises(mp.errors.InvalidInputError, match=f"^{name}: got .*; allowed: a {GROUPS[name].__name__}$"):
        job(planar, START, GOAL, POST, throw=False, **{name: value})


@pytest.mark.parametrize("job", [mp.optimize_path, mp.plan])
@pytest.mark.parametrize("name", ["degree", "power", "initial", "seeds", "planner", "time_limit"])
def test_a_field_is_no_argument_of_a_job(planar, job, name):
    with pytest.raises(TypeError, match=name):
        job(planar, START, GOAL, POST, **{name: 1})


@pytest.mark.parametrize("planner", ["RRT", "KPIECE1"])
def test_the_planner_finds_the_first_path(planar, planner):
    """The seed of the result is the path that `seed_path` finds with the same options, and not that of RRTConnect."""
    seeding, shape = mp.Seeding(planner=planner, seed=3, time_limit=60.0), mp.PathShape(degree=3)
    result = mp.optimize_path(planar, START, GOAL, POST, shape=shape, seeding=seeding)
    np.testing.assert_array_equal(result.seed.control, mp.seed_path(planar, START, GOAL, POST, seeding=seeding).control)
    usual = mp.seed_path(planar, START, GOAL, POST, seeding=dataclasses.replace(seeding, planner="auto"))
    assert abs(usual.length - result.seed.length) > 1e-6


@pytest.mark.parametrize("planner", ["auto", *OPTIMISING])
def test_the_planner_gets_the_objective_and_each_seed(planar, planner, monkeypatch):
    asked, free = [], mp.seed_path(planar, START, GOAL, POST)

    def seed_path(*_, seeding, objective, **__):
        asked.append((seeding, objective))
        return free

    monkeypatch.setattr(problem, "seed_path", seed_path)
    objective = mp.PathObjective(power=2, measure="smallest_singular_value", metric=[4.0, 1.0, 1.0])
    seeding = mp.Seeding(planner=planner, seed=5, count=3, time_limit=7.0)
    result = mp.optimize_path(planar, START, GOAL, POST, objective=objective, shape=mp.PathShape(degree=1), seeding=seeding)
    assert sorted(each.seed for each, _ in asked) == [5, 6, 7]
    limit = 3.5 if planner in OPTIMISING else 7.0  # they use up what they get
    for each, wanted in asked:
        assert (each.planner, each.time_limit, each.count, each.shifts) == (planner, limit, 1, "none")
        assert (wanted.power, wanted.measure.name) == (2.0, "smallest_singular_value")
        np.testing.assert_array_equal(wanted.metric, np.diag([4.0, 1.0, 1.0]))
    assert result.seed is free


@pytest.mark.slow
def test_the_result_holds_the_objective(planar):
    objective = mp.PathObjective(power=1.5, task=mp.Task.planar(), measure="inverse_condition", metric=[1.0, 2.0, 3.0])
    result = mp.optimize_path(planar, START, GOAL, objective=objective, shape=mp.PathShape(degree=3), compiled=False)
    assert (result.power, result.task.name, result.measure.name) == (1.5, "planar", "inverse_condition")
    kinematics = planar.kinematics(mp.Task.planar(), measure="inverse_condition")
    assert result.g == pytest.approx(mp.path_cost(result.path, kinematics, 1.5, metric=[1.0, 2.0, 3.0]).g)


SLOPES = {"start_slope": [0.0] * 3, "goal_slope": [0.0] * 3}
ORDERS = {
    "start_slope": (0.0, 1),
    "goal_slope": (1.0, 1),
    "start_second_derivative": (0.0, 2),
    "goal_second_derivative": (1.0, 2),
}


@pytest.mark.slow
@pytest.mark.parametrize(
    "conditions",
    [
        SLOPES,
        {"start_slope": [0.5, 0.0, -0.5], "goal_second_derivative": [0.0] * 3},
        {"start_second_derivative": [0.0] * 3} | SLOPES,
    ],
)
def test_further_shapes_of_a_plan_keep_the_end_derivatives(planar, conditions):
    """The only curve of this degree with these ends runs through the post, so a higher degree is taken."""
    shape = mp.PathShape(degree=len(conditions) + 1, **conditions)
    objective = mp.PathObjective(power=2)
    assert mp.optimize_path(planar, START, GOAL, POST, shape=shape, objective=objective).status is mp.Status.ENDS_NOT_MET
    plan = mp.plan(planar, START, GOAL, POST, shape=shape, objective=objective)
    assert plan.status.ok
    assert plan.path.degree == shape.degree + MORE_DEGREES or len(plan.path.breaks) == SPLINE_PIECES + 1
    for name, value in conditions.items():
        np.testing.assert_allclose(plan.path(*ORDERS[name]), value, atol=1e-8)
    np.testing.assert_allclose(plan.path([0.0, 1.0]), [START, GOAL], atol=1e-12)


@pytest.mark.slow
def test_the_spline_of_a_plan_keeps_the_end_derivatives(planar, monkeypatch):
    """Without the three more degrees the cubic spline of eight pieces is the first curve that passes the post."""
    monkeypatch.setattr("manipplan.jobs.plan.MORE_DEGREES", 0)
    shape, objective = mp.PathShape(degree=3, **SLOPES), mp.PathObjective(power=2)
    plan = mp.plan(planar, START, GOAL, POST, shape=shape, objective=objective)
    assert plan.status.ok
    assert (plan.path.degree, len(plan.path.breaks)) == (3, SPLINE_PIECES + 1)
    for name, value in SLOPES.items():
        np.testing.assert_allclose(plan.path(*ORDERS[name]), value, atol=1e-8)


def test_end_derivatives_that_do_not_fit_are_refused_before_the_work(planar):
    told = []
    for shape in (mp.PathShape(degree=2, start_slope=[0.0] * 3, goal_slope=[0.0] * 3), mp.PathShape(start_slope=[0.0] * 4)):
        with pytest.raises(mp.errors.InvalidInputError, match=r"degree: got 2|start_slope: got"):
            mp.optimize_path(
                planar, [0.0, 1.5, -2.0], [1.0, 1.0, -1.0], mp.Scene(), shape=shape, progress=lambda *each: told.append(each)
            )
    assert told == []
