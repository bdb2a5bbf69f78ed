"""Bounds of one step: the stopping distance by brute force, and single states whose answer is known."""

import casadi as ca
import numpy as np
import pytest

from manipplan.robots.limits import JointLimits
from manipplan.tracking.bounds import _fastest, limits_jerk, velocity_bounds


def limits(**changes):
    """Of one joint: ±1 rad, 2 rad/s, 10 rad/s²."""
    usual = {"lower": -1.0, "upper": 1.0, "velocity": 2.0, "acceleration": 10.0, "jerk": np.inf, "effort": np.inf}
    return JointLimits(**{name: np.array([value]) for name, value in {**usual, **changes}.items()})


def bounds(q, v, a=0.0, *, dt=0.01, **changes):
    """The interval of one joint."""
    states = [ca.SX.sym(name) for name in "qva"]
    function = ca.Function("bounds", states, velocity_bounds(*states, limits(**changes), dt))
    return tuple(float(each) for each in function(q, v, a))


def stopping_distance(velocity, change, dt):
    """By adding up the steps of a joint that moves and slows down."""
    way = 0.0
    while velocity > 0:
        way += dt * velocity
        velocity -= change
    return way


@pytest.mark.slow
@pytest.mark.parametrize("dt", [1e-3, 0.01, 0.05])
@pytest.mark.parametrize("acceleration", [0.3, 10.0])
def test_fastest_velocity_equals_a_search_of_the_stopping_distance(acceleration, dt, rng):
    room, change = ca.SX.sym("room"), acceleration * dt
    fastest = ca.Function("fastest", [room], [_fastest(room, np.inf, acceleration, dt)])
    corners = [dt * change * k * (k + 1) / 2 for k in (1, 2, 7)]  # where the number of braking steps changes
    for value in [0.0, 1e-12, *corners, *10 ** rng.uniform(-8, 0.5, 40)]:
        low, high = 0.0, value / dt + 1
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if stopping_distance(middle, change, dt) <= value else (low, middle)
        assert float(fastest(value)) == pytest.approx(low, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(
    ("state", "changes", "expected"),
    [
        ((0.0, 0.0), {}, (-0.1, 0.1)),  # acceleration
        ((0.0, 1.95), {}, (1.85, 2.0)),  # and velocity
        ((0.0, 0.0), {"acceleration": np.inf}, (-2.0, 2.0)),
        ((0.99, 0.0), {"acceleration": np.inf}, (-2.0, 1.0)),  # to the limit in one step
        ((1.0, 0.0), {}, (-0.1, 0.0)),  # at the limit
        ((0.9995, 0.0), {}, (-0.1, 0.05)),  # half a step's acceleration away from it
        ((9.0, 0.0), {"lower": -np.inf, "upper": np.inf}, (-0.1, 0.1)),  # continuous
        ((0.0, 7.0), {"velocity": np.inf, "upper": np.inf}, (6.9, 7.1)),
    ],
)
def test_bounds_of_known_states(state, changes, expected):
    assert bounds(*state, **changes) == pytest.approx(expected, abs=1e-12)


def test_outside_its_limits_a_joint_goes_back_in_one_step_as_far_as_its_velocity_allows():
    assert bounds(1.005, 0.0) == pytest.approx((-0.5, -0.5))
    assert bounds(-3.0, 0.0) == pytest.approx((2.0, 2.0))


def test_where_braking_comes_too_late_the_position_limit_comes_first():
    """At 0.99 rad with 2 rad/s the stop would take 0.19 rad: the last velocity that still stops inside is given."""
    low, high = bounds(0.99, 2.0)
    assert low == high < 1.9
    assert stopping_distance(high, 0.1, 0.01) == pytest.approx(0.01)


def test_jerk_limits_matter_only_where_accelerations_can_differ_by_more():
    assert limits_jerk(limits(jerk=1999.0), 0.01)
    assert not limits_jerk(limits(jerk=2000.0), 0.01)
    assert not limits_jerk(limits(acceleration=np.inf), 0.01)


def test_jerk_limits_the_change_of_acceleration():
    assert bounds(0.0, 0.0, 0.0, jerk=100.0) == pytest.approx((-0.01, 0.01))
    low, high = bounds(0.0, 0.02, 2.0, jerk=100.0)
    assert (low, high) == pytest.approx((0.03, 0.05))
