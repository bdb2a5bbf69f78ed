"""Every public function refuses odd values by an error of this package, or takes them and is right, within seconds."""

import inspect
import warnings
from enum import Enum

import matplotlib as mpl
import numpy as np
import odd_calls
import pytest

import manipplan as mp
from manipplan import formulations, planar, viz

#: Classes whose values this package makes, so that nothing checks them, and methods that take CasADi expressions or draw.
MADE = [
    "Certificate",
    "TakenToLimit",
    "Comparison",
    "ConstraintFigure",
    "Crossing",
    "Deviation",
    "Ellipsoid",
    "Evaluator",
    "GoalCandidate",
    "Interruptions",
    "Kinematics",
    "LimitApproach",
    "LimitUse",
    "Mark",
    "MotionFigures",
    "NoPath",
    "PartialPlan",
    "PlannerProblem",
    "PathClearance",
    "PathCost",
    "PathPart",
    "PathResult",
    "PinocchioCasadi",
    "Plan",
    "PlanReport",
    "Posture",
    "Program",
    "Reference",
    "Refinement",
    "Report",
    "Robot",
    "Rollout",
    "SearchResult",
    "ServoGauge",
    "SolutionSet",
    "SteadySpeed",
    "StepReport",
    "SymbolicPose",
    "ToolFigure",
    "Tracking",
    "Layers",
    "planar.Annulus",
    "planar.Arc",
    "planar.Counterexample",
    "planar.PostureFamily",
    "planar.PostureSet",
    "planar.Proportions",
    "planar.Theorem",
    "planar.TrigonometricPolynomial",
    "planar.Zeros",
    "formulations.Drive",
    "formulations.SymbolicMeasure",
]
EXPRESSIONS = (
    "check",
    "check_tools",
    "figure",
    "gradient",
    "hessian",
    "log_gradient",
    "mask",
    "of",
    "rows",
    "rows_of",
    "unit",
    "value",
    "drive",
)
EXPRESSIONS += ("closed_form", "count", "index")
#: Functions of classes that share one with another class that is tested, and such as open windows, ports and long jobs.
ELSEWHERE = [
    "Obstacle",
    "Formulation",
    "ProgramStep",
    "Measure",
    "Constraint",
    "CartesianPath",
    "formulations.Formulation",
    "Plane.at",
    "Plane.called",
    "PartialPlan.load",
    "PartialPlan.record",
    "PartialPlan.save",
    "PartialPlan.show",
    "Plan.record",
    "Plan.show",
    "Program.record",
    "Program.save",
    "Program.show",
    "PlanReport.from_json",
    "PlanReport.to_json",
    "MotionFigures.of",
    "Robot.from_mjcf",
    "Controller.export_c",
    "PoseGoal.distances",
    "PoseGoal.of_tool",
    "SteadySpeed.later",
    "Layers.of",
    "viz.draw_figure",
    "viz.save_figure",
    "viz.plot_convergence",
    "viz.plot_deviation",
    "viz.plot_ellipsoid",
    "viz.plot_singular_values",
    "planar.Arc.__call__",
]


@pytest.fixture(scope="module")
def calls(tmp_path_factory):
    folder = tmp_path_factory.mktemp("odd")
    return odd_calls.calls(folder)


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Some of the odd values are names of files, which are written."""
    monkeypatch.chdir(tmp_path)


def public_functions():
    """Names of all public functions, classes and methods that take arguments."""
    spaces = [("", mp), ("", mp.measures), ("", mp.results)]
    spaces += [("planar.", planar), ("viz.", viz), ("formulations.", formulations)]
    for prefix, place in spaces:
        for name in place.__all__:
            value = getattr(place, name)
            if not callable(value) or not getattr(value, "__module__", "").startswith("manipplan"):
                continue
            if not inspect.isclass(value):
                yield prefix + name, value
            elif not issubclass(value, Exception | Enum):
                yield prefix + name, value
                for member, method in inspect.getmembers(value, callable):
                    if member == "__call__" or not member.startswith("_"):
                        yield f"{prefix}{name}.{member}", method


@pytest.mark.slow
def test_every_public_function_is_called(calls):
    left = []
    for name, function in public_functions():
        kind, _, member = name.rpartition(".")
        same = [each for each in calls if each.rpartition(".")[2] == member and member not in ("", "at", "called")]
        known = name in calls or name in MADE or name in ELSEWHERE or member in EXPRESSIONS or bool(kind and same)
        inherited = member in ("at", "called") and f"Box.{member}" in calls
        parameters = [each for each in inspect.signature(function).parameters if each != "self"]
        if parameters and not known and not inherited:
            left.append(name)
    assert left == []


@pytest.mark.slow
def test_the_calls_themselves_are_valid(calls):
    invalid = {"pinocchio_casadi"}  # Pinocchio without its CasADi bindings; to compile the bridge takes minutes
    mpl.use("agg")
    for name, call in calls.items():
        if name not in invalid:
            call.function(**call.arguments)
        for argument in call.arguments:
            assert argument in odd_calls.signature_of(call) or {"changes", "limits"} & odd_calls.signature_of(call), (
                name,
                argument,
            )


@pytest.mark.slow
def test_no_value_that_is_always_wrong_is_taken(calls):
    wrong = {}
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        for name, call in calls.items():
            for argument, valid in call.arguments.items():
                for value in odd_calls.never(valid) if argument not in call.free else ():
                    found = odd_calls.outcome(call, argument, value)
                    taken_nan = found == "accepted" and argument in call.nan and odd_calls.has_nan(value)
                    if found != "refused" and not taken_nan:
                        wrong.setdefault(f"{name}({argument}=)", []).append((type(value).__name__, found))
    assert wrong == {}


@pytest.mark.slow
def test_no_value_raises_a_foreign_error_or_takes_long(calls):
    wrong = {}
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        for name, call in calls.items():
            for argument in call.arguments if not call.heavy else ():
                for value in odd_calls.perhaps():
                    found = odd_calls.outcome(call, argument, value)
                    if found not in ("refused", "accepted"):
                        wrong.setdefault(f"{name}({argument}=)", []).append((repr(value)[:60], found))
    assert wrong == {}


@pytest.mark.slow
def test_a_step_with_nan_brakes_and_says_so(calls):
    """NaN in a measured position or a target is an ordinary event of a control loop: a status, not an exception."""
    controller = calls["Controller.step"].function.__self__
    q, target = np.array([0.1, 0.6, 0.8]), controller.robot.kinematics().pose([0.2, 0.6, 0.8])
    controller.step(q, np.zeros(3), np.full((4, 4), np.nan))
    assert controller.report.status is mp.results.StepStatus.BAD_TARGET
    controller.step(np.full(3, np.nan), np.zeros(3), target)
    assert controller.report.status not in (mp.results.StepStatus.SOLVED, mp.results.StepStatus.BAD_TARGET)
    with pytest.raises(mp.errors.InvalidInputError, match="target"):
        controller.step(q, np.zeros(3), np.ma.array(target))


PUSHED = mp.planar_arm([1.0, 1.0, 1.0])


@pytest.mark.parametrize(
    ("call", "message"),
    [  # reviews: each was taken, hung, or raised a foreign exception
        (lambda: PUSHED.configuration("q", [100.0] * 3, tolerance=np.nan), "tolerance: got nan"),
        (lambda: mp.Scene().in_collision(PUSHED, [1e300] * 3), "q: got .*; allowed: numbers from -1e\\+08 to 1e\\+08"),
        (lambda: mp.Box(size=np.ma.array([1.0, 1.0, 1.0], mask=[0, 1, 0])), "no value may be masked"),
        (lambda: mp.plan(PUSHED, np.ma.array([0.1, 0.2, 0.3]), [0.4, 0.2, 0.3]), "start: .*no value may be masked"),
        (lambda: mp.plan(PUSHED, [0.1, 0.2, 0.3], [0.4, 0.2, 0.3], throw="nan"), "throw: got 'nan'; allowed: True or False"),
        (lambda: mp.Seeding(seed=10**5000), "seed: got a whole number of 16610 bits"),
        (lambda: mp.Box(size=[10**5000, 1, 1]), "size: got .*a whole number of 16610 bits.*real numbers"),
        (lambda: mp.PositionBox([10**400, 0, 0], [1, 1, 1]), "lower: .*real numbers"),
        (lambda: mp.Seeding(planner=np.array(["a", "b"])), "planner: .*allowed: one of"),
        (lambda: mp.Kinematics.batch_code(PUSHED.kinematics(), 3), "quantity: got 3"),
        (lambda: mp.Program.load("x" * 100_000), "folder: .*an existing file"),
        (lambda: PUSHED.link_of(3), "body: got 3; allowed: a GeometryObject"),
    ],
)
def test_odd_calls_of_the_reviews(call, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        call()


@pytest.mark.slow
def test_odd_figures_of_the_reviews(calls):
    motion = calls["torque_use"].arguments["trajectory"]
    path, kinematics = calls["path_cost"].arguments["path"], PUSHED.kinematics()
    for options in ({"effort": np.full(3, np.nan)}, {"effort": -np.ones(3)}, {"effort": np.ones(3), "inside": -1}):
        with pytest.raises(mp.errors.InvalidInputError, match="effort|inside"):
            mp.torque_use(motion, PUSHED.model, **options)
    for power, panels in ((np.nan, 40), (-1.0, 40), (1.0, np.nan), (1.0, -1), (1.0, 0)):
        with pytest.raises(mp.errors.InvalidInputError, match="power|panels"):
            mp.path_cost(path, kinematics, power, panels=panels)
    with pytest.raises(mp.errors.InvalidInputError, match="order: .*at most 100"):
        motion(0.1, 10**400)
    for step in (-1, 1e-8, np.nan):
        with pytest.raises(mp.errors.InvalidInputError, match="step"):
            path.fine_samples(step)
