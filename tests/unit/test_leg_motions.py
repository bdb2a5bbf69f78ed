"""Motions of legs along paths: what is said where the positions that are added find none either."""

from types import SimpleNamespace

import pytest

import manipplan as mp
from manipplan.programs import leg_motions
from manipplan.programs.leg_motions import ToolPathPlanners, _along, _on_path
from manipplan.search.sampling import sample_layers
from manipplan.support.status import Failure
from manipplan.tool_path.engine import ToolPathPlanner


@pytest.fixture
def step(planar):
    start = planar.kinematics().pose(planar.neutral + 0.4)
    end = start.copy()
    end[1, 3] += 0.2
    return mp.MoveAlong(mp.CartesianPath.line(start, end))


@pytest.fixture
def state(planar):
    return SimpleNamespace(robot=planar, scene=mp.Scene(), history=())


def no_pose(*_, **__):
    raise mp.errors.InvalidInputError("path, s = 0.25", [], "a pose within reach")


@pytest.mark.slow
def test_a_pose_between_positions_out_of_reach_is_not_for_every_start(planar, step, state, monkeypatch):
    """That a position in between is out of reach does not rule out other configurations in which the path begins."""
    failure = Failure(message="positions 3 and 4 are not connected")
    planner = SimpleNamespace(has_several_parameters=False, path=step.path, best_from=lambda *_: failure)
    monkeypatch.setattr(ToolPathPlanners, "along", lambda *_: planner)
    monkeypatch.setattr(leg_motions, "find_whole", no_pose)
    finders = ToolPathPlanners(objective=mp.PathObjective(), clearance=0.0)
    failure = _along(1, step, step.path, planar.neutral + 0.4, state, finders)
    assert (failure.message, failure.always) == ("path, s = 0.25 is not a pose within reach", False)


@pytest.mark.slow
def test_a_pose_between_positions_that_no_configuration_reaches_is_named(planar, step, state, monkeypatch):
    layers = sample_layers(planar, step.path, 4)
    apart = mp.Layers(q=(layers.q[0], layers.q[1] + 3.0, *layers.q[2:]), m=layers.m, s=layers.s, continuous=layers.continuous)
    monkeypatch.setattr(ToolPathPlanners, "made", lambda *_, **__: ToolPathPlanner(path=step.path, layers=apart))
    monkeypatch.setattr(leg_motions, "connect", no_pose)
    leg = SimpleNamespace(rest=[(2, step)], along=step)
    with pytest.raises(mp.errors.InvalidInputError, match=r"steps\[2\].path, s = 0.25: got .* a pose within reach"):
        list(_on_path(leg, state, ToolPathPlanners(objective=mp.PathObjective(), clearance=0.0)))
