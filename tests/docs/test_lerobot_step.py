"""The step of the LeRobot example: names, leash, gripper and reset."""

from pathlib import Path

import numpy as np
import pytest

import manipplan as mp

PAGE = Path(__file__).parents[2] / "docs" / "examples" / "track" / "plot_lerobot.py"
STAY = {"delta_x": 0.0, "delta_y": 0.0, "delta_z": 0.0}


@pytest.fixture
def step():
    names = {}
    code = PAGE.read_text().partition("# In LeRobot, a")[0]
    exec(compile(code, str(PAGE), "exec"), names)
    return names["ServoStep"](mp.load_robot("so100"), rate=30.0)


def observed(step, q, **others):
    return {f"{name}.pos": x for name, x in zip(step.names, np.degrees(q), strict=True)} | others


def test_it_gives_every_motor_a_position_in_degrees(step):
    q = np.array([0.3, 1.2, -1.8, 0.4, 0.1])
    command = step(STAY, observed(step, q))
    assert list(command) == [f"{name}.pos" for name in step.names]
    np.testing.assert_allclose(list(command.values()), np.degrees(q), atol=1e-6)
    pushed = step(STAY | {"delta_z": 1.0}, observed(step, q))
    assert np.abs(np.subtract(list(pushed.values()), np.degrees(q))).max() > 0.1


def test_a_blocked_arm_does_not_wind_up(step):
    q = np.array([0.3, 1.2, -1.8, 0.4, 0.1])
    for _ in range(90):
        command = step(STAY | {"delta_x": 1.0}, observed(step, q))
        assert np.abs(np.radians(list(command.values())) - q).max() < step.LEASH + 1 / 30 + 1e-9
    assert np.abs(np.radians(list(command.values())) - q).max() > 0.9 * step.LEASH
    step.reset()
    np.testing.assert_allclose(list(step(STAY, observed(step, q)).values()), np.degrees(q), atol=1e-6)


@pytest.mark.parametrize(("action", "change"), [(0, -10 / 3), (1, 0.0), (2, 10 / 3)])
def test_the_gripper_closes_stays_and_opens(step, action, change):
    q = np.array([0.3, 1.2, -1.8, 0.4, 0.1])
    command = step(STAY | {"gripper": action}, observed(step, q, **{"gripper.pos": 50.0}))
    assert command["gripper.pos"] == pytest.approx(50.0 + change)
    assert step(STAY | {"gripper": 2}, observed(step, q, **{"gripper.pos": 99.0}))["gripper.pos"] == 100.0
