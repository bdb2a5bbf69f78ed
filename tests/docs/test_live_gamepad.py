"""The example that moves an arm with a gamepad, without one: its recorded file, its mapping, and what it says without a device."""

import importlib.util
import sys
import types
from pathlib import Path

import numpy as np
import pytest

EXAMPLE = Path(__file__).parents[2] / "docs" / "examples" / "track" / "live_gamepad.py"
FILE = EXAMPLE.with_name("gamepad.csv")


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("live_gamepad", EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_sticks_move_and_turn_the_tool(example):
    rest = np.zeros(6)
    assert not example.twist_of(rest, set()).any()
    assert not example.twist_of(np.full(6, 0.1), {example.B}).any()  # a stick that does not quite return
    for axis, value, row, speed in ((1, -1, 0, 0.2), (0, -1, 1, 0.2), (5, 1, 2, 0.2), (4, 1, 2, -0.2), (3, -1, 4, 0.8)):
        axes = rest.copy()
        axes[axis] = value
        np.testing.assert_allclose(example.twist_of(axes, set()), speed * np.eye(6)[row], atol=1e-12)
    np.testing.assert_allclose(example.twist_of(rest, {example.LEFT_SHOULDER}), 0.8 * np.eye(6)[5])


def test_without_pygame_or_a_gamepad_it_says_what_to_do(example, monkeypatch):
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(SystemExit, match="pip install pygame; or use --replay FILE"):
        example.main([])
    controller = types.SimpleNamespace(init=lambda: None, get_count=lambda: 0)
    pygame = types.SimpleNamespace(display=types.SimpleNamespace(init=lambda: None))
    monkeypatch.setitem(sys.modules, "pygame", pygame)
    monkeypatch.setitem(sys.modules, "pygame._sdl2", types.SimpleNamespace(controller=controller))
    with pytest.raises(SystemExit, match="no gamepad found: connect one, or use --replay FILE"):
        example.main([])


@pytest.mark.slow
def test_a_recorded_file_moves_the_arm_to_the_edge_of_its_reach_and_back(example, capsys, tmp_path):
    pytest.importorskip("viser")
    example.main(["--replay", str(FILE), "--no-browser", "--record", str(tmp_path / "again.csv")])
    moved, edge = (float(line.split()[-2]) for line in capsys.readouterr().out.splitlines()[1:])
    assert 0.3 < moved < 1.0 and 0.2 < edge < 5.0
    given, again = ([line.partition(",") for line in file.read_text().splitlines()] for file in (FILE, tmp_path / "again.csv"))
    assert given[0] == again[0] and len(again) > 20
    states = {tuple(float(x or -1) for x in rest.split(",")) for _, _, rest in given[1:]}
    assert {tuple(float(x or -1) for x in rest.split(",")) for _, _, rest in again[1:]} <= states
