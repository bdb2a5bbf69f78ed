"""Messages: plain numbers, values of any size, and remedies that name the call."""

import pickle

import numpy as np
import pytest
from chains import chain_file
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.support.display import round_down, round_up

QUARTER = "1.57079632679"
numbers = st.one_of(
    st.floats(allow_nan=True).map(np.float64),
    st.integers(-(2**31), 2**31 - 1).map(np.int32),
    st.booleans().map(np.bool_),
    st.floats(width=32).map(np.float32),
)


@given(st.recursive(numbers, lambda inner: st.one_of(st.lists(inner, max_size=4), st.tuples(inner, inner)), max_leaves=8))
def test_numbers_in_messages_are_plain(value):
    error = mp.errors.InvalidInputError("limits", value, f"below {value}")
    for each in (error, pickle.loads(pickle.dumps(error)), mp.errors.PlanningError(f"at {value!r}")):
        assert "np." not in str(each)


@given(st.floats(1e-12, 1e12), st.integers(1, 12))
def test_bounds_are_rounded_to_the_safe_side(value, digits):
    low, high = round_down(value, digits), round_up(value, digits)
    assert low <= value <= high and high - low < 1.1 * 10.0 ** (1 - digits) * value
    assert float(f"{low:.{digits}g}") == low and float(f"{high:.{digits}g}") == high


@pytest.mark.parametrize("value", [10**5000, -(10**5000), [10**5000], {"a": 10**400}], ids=("long", "negative", "list", "dict"))
def test_a_number_too_long_to_write_is_told_by_its_size(value):
    assert " bits" in str(mp.errors.InvalidInputError("seed", value, "less"))


def test_limits_and_their_order_are_told_in_plain_numbers(ur5):
    with pytest.raises(mp.errors.InvalidInputError, match=r"limits\.lower") as told:
        ur5.with_limits(lower=[np.float64(1.0)] * 6, upper=[np.float64(0.0)] * 6)
    assert "np.float64" not in str(told.value)


@pytest.mark.parametrize(
    ("call", "named"),
    [
        (lambda ur5: ur5.configuration("q", [100] * 6, tolerance=np.nan), "tolerance"),
        (lambda ur5: ur5.configuration("q", [0] * 6, tolerance=-1.0), "tolerance"),
        (lambda ur5: ur5.configuration("q", [0] * 6, tolerance="1"), "tolerance"),
        (lambda ur5: ur5.random_configuration(0), "rng"),
        (lambda ur5: ur5.random_configuration(np.random.default_rng(0), size=2.5), "size"),
        (lambda ur5: ur5.random_configuration(np.random.default_rng(0), size=-1), "size"),
        (lambda ur5: ur5.link_of("forearm"), "body"),
    ],
)
def test_odd_arguments_of_a_robot_are_refused(ur5, call, named):
    with pytest.raises(mp.errors.InvalidInputError, match=rf"^{named}: got"):
        call(ur5)


@pytest.mark.slow
def test_a_joint_that_does_not_move_the_tool_is_named(tmp_path):
    joints = [
        ("revolute", "0 0 0.2", "0 0 0", "0 0 1", -3, 3),
        ("revolute", "0 0 0.1", f"{QUARTER} 0 0", "0 0 1", -1.5, 1.5),
        ("revolute", "0.3 0 0", f"0 {QUARTER} 0", "0 0 1", -2.5, 2.5),
    ]
    arm = mp.Robot.from_urdf(chain_file(tmp_path / "three.urdf", joints, "0 0 0.1"), tool="tool")
    position = mp.PathObjective(task=mp.Task.position())  # the default task is cut to the directions that the joints span
    plan = mp.plan(arm, [0, 0, 0], [1, 0.5, 0.3], objective=position)
    assert plan.status is mp.Status.SINGULAR
    text = str(plan.report)
    assert "j3 does not move the tool" in text and "robot.with_tool" in text
    assert "crosses a singularity at" not in text  # it is singular everywhere
    with pytest.raises(mp.errors.PlanningError, match="j3 does not move the tool"):
        mp.optimize_path(arm, [0, 0, 0], [1, 0.5, 0.3], objective=mp.PathObjective(floor=0.0, task=mp.Task.position()))
    moved = np.eye(4)
    moved[0, 3] = 0.1
    beside = arm.with_tool(moved)
    assert "does not move" not in str(mp.plan(beside, [0, 0.3, 0.2], [1, 0.5, 0.6], objective=position).report)


@pytest.mark.slow
def test_five_joints_follow_position_and_direction(tmp_path):
    joints = [
        ("revolute", "0 0 0.2", "0 0 0", "0 0 1", -3, 3),
        ("revolute", "0 0 0.1", f"{QUARTER} 0 0", "0 0 1", -1.5, 1.5),
        ("revolute", "0.3 0 0", "0 0 0", "0 0 1", -2.5, 2.5),
        ("revolute", "0.05 0 0", f"0 {QUARTER} 0", "0 0 1", -2.9, 2.9),
        ("revolute", "0 0 0.2", f"{QUARTER} 0 0", "0 0 1", -2.5, 2.5),
    ]
    arm = mp.Robot.from_urdf(chain_file(tmp_path / "five.urdf", joints, "0 0 0.05"), tool="tool")
    begin = arm.kinematics(mp.Task.pose()).pose(np.array([0.2, 0.5, -1.0, -0.6, 0.7]))
    end = begin.copy()
    end[:3, 3] += [0.05, 0.05, -0.03]
    path = mp.CartesianPath.line(begin, end)
    with pytest.raises(mp.errors.InvalidInputError, match=r"Task\.position\(\) or.*Task\.pointing\(axis\)"):
        mp.follow(arm, path)
    plan = mp.follow(arm, path, objective=mp.PathObjective(task=mp.Task.pointing([1.0, 0.0, 0.0])))
    assert plan.report.passed
    reached = arm.kinematics(mp.Task.pose()).pose(plan.trajectory.q)
    np.testing.assert_allclose(reached[:, :3, 0], np.tile(begin[:3, 0], (len(reached), 1)), atol=2e-3)
