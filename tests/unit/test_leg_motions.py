"""Motions of legs along paths: what is said where positions half as far apart find none either."""

from types import SimpleNamespace

import pytest

import manipplan as mp
from manipplan.programs.leg_motions import LegFailure, ToolPathPlanners, _along, _on_path
from manipplan.search.sampling import sample_layers
from manipplan.support.status import Failure


@pytest.fixture
def step(planar):
    start = planar.kinematics().pose(planar.neutral + 0.4)
    end = start.copy()
    end[1, 3] += 0.2
    return mp.MoveAlong(mp.CartesianPath.line(start, end))


@pytest.fixture
def state(planar):
    return SimpleNamespace(robot=planar, scene=mp.Scene(), history=())


def finder_that_fails_with_closer(planner):
    def made(self, number, step, path, state, *, closer=False):
        return LegFailure(message="path is not reached at s = 0.25", always=True) if closer else planner

    return made


def test_the_first_reason_is_kept_and_is_not_for_every_start(planar, step, state, monkeypatch):
    """That a position in between is out of reach does not rule out other configurations in which the path begins."""
    failure = Failure(message="positions 3 and 4 are not connected")
    planner = SimpleNamespace(has_several_parameters=False, path=step.path, best_from=lambda *_: failure)
    monkeypatch.setattr(ToolPathPlanners, "along", finder_that_fails_with_closer(planner))
    finders = ToolPathPlanners(objective=mp.PathObjective(), clearance=0.0)
    failure = _along(1, step, step.path, planar.neutral, state, finders)
    expected = "positions 3 and 4 are not connected; with positions half as far apart: path is not reached at s = 0.25"
    assert (failure.message, failure.always) == (expected, False)


def test_a_reason_that_is_the_same_twice_is_said_once(planar, step, state, monkeypatch):
    failure = Failure(message="not connected")
    planner = SimpleNamespace(has_several_parameters=False, path=step.path, best_from=lambda *_: failure)
    monkeypatch.setattr(ToolPathPlanners, "along", lambda *_, **__: planner)
    finders = ToolPathPlanners(objective=mp.PathObjective(), clearance=0.0)
    assert _along(1, step, step.path, planar.neutral, state, finders).message == "not connected"


def test_no_error_is_about_positions_that_were_not_asked_for(planar, step, state, monkeypatch):
    """Where a leg begins on a path and its positions are not connected, that is the error."""
    layers = sample_layers(planar, step.path, 4)
    apart = mp.Layers(q=(layers.q[0], layers.q[1] + 3.0, *layers.q[2:]), m=layers.m, s=layers.s, continuous=layers.continuous)

    def made(self, step, path, state, *, closer=False, near=None):
        if closer:
            raise mp.errors.InvalidInputError("path", path, "free at s = 0.25")
        return SimpleNamespace(layers=apart, in_the_way=lambda _: "")

    monkeypatch.setattr(ToolPathPlanners, "made", made)
    leg = SimpleNamespace(rest=[(2, step)], along=step)
    with pytest.raises(mp.errors.PlanningError, match=r"steps\[2\]: no candidate of position 1 can be reached"):
        list(_on_path(leg, state, ToolPathPlanners(objective=mp.PathObjective(), clearance=0.0)))
