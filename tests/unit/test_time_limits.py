"""The time limit of a whole call: at whatever moment it comes, the result is a checked path, and no worse than the first one."""

import pickle
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

import manipplan as mp
from manipplan.optimize.descents.descent import LATE
from manipplan.optimize.problem import PathProblem, solve_local
from manipplan.support.deadline import NEVER, Deadline, OutOfTimeError

POST = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post")])
START, GOAL = np.array([-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8]), np.array([0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8])


class AfterChecks(Deadline):
    """A deadline that passes after a number of looks at it, so that no test depends on the machine's speed."""

    looks = 0

    @property
    def passed(self):
        object.__setattr__(self, "looks", self.looks + 1)
        return self.looks > self.at


@pytest.fixture(scope="module")
def problem(panda):
    return PathProblem(
        robot=panda,
        scene=POST,
        objective=mp.PathObjective().resolved(panda),
        shape=mp.PathShape(),
        seeding=mp.Seeding(),
        clearance=0.01,
    )


@pytest.fixture(scope="module")
def first(panda):
    return mp.seed_path(panda, START, GOAL, POST, clearance=0.01)


@pytest.mark.slow
def test_the_result_is_checked_and_better_the_later_it_comes(problem, first):
    whole = AfterChecks(at=np.inf)
    best = solve_local(problem, START, GOAL, first, deadline=whole)
    assert best.status is mp.Status.OPTIMAL
    g = []
    for share in (0.0, 0.02, 0.1, 0.3, 0.6, 0.9):
        result = solve_local(problem, START, GOAL, first, deadline=AfterChecks(at=int(share * whole.looks)))
        assert result.certificate.proven_clearance > 0.01
        assert result.g <= result.seed_cost.g
        assert result.status.has_path  # another optimum may have been reached before
        assert result.certificate.solver.endswith(LATE)
        g.append(result.g)
    assert g[0] == result.seed_cost.g
    assert g[-1] < 1.05 * best.g


@pytest.mark.slow
@pytest.mark.parametrize("shape", [{"degree": 12}, {"degree": 3, "basis": "bspline", "pieces": 8}])
def test_the_optimum_of_a_lower_degree_is_not_lost(problem, first, shape):
    """Time ends right after the lower degree is optimised."""
    higher = replace(problem, shape=mp.PathShape(**shape))
    alone = solve_local(higher.lower(), START, GOAL, first)
    looks = AfterChecks(at=np.inf)
    solve_local(higher, START, GOAL, first, deadline=looks)
    g = {solve_local(higher, START, GOAL, first, deadline=AfterChecks(at=k)).g for k in range(0, looks.looks, 40)}
    assert min(g) <= alone.g * (1 + 1e-6)


def test_without_a_scene_the_straight_line_is_left(panda, problem):
    free = replace(problem, scene=None, clearance=0.0)
    line = mp.JointPath.line(START, GOAL)
    result = solve_local(free, START, GOAL, line, deadline=AfterChecks(at=0))
    assert result.status is mp.Status.SEED_IS_BETTER
    assert result.certificate.solver == LATE
    assert "time_limit" in result.status.value


@pytest.mark.parametrize("limit", [0.0, -1.0, np.nan, "soon"])
def test_wrong_limits(limit):
    with pytest.raises(mp.InvalidInputError, match="time_limit"):
        mp.Seeding(time_limit=limit)


def test_a_plan_with_hardly_any_time_is_a_checked_motion_or_says_that_there_is_no_path(panda):
    for limit in (1e-3, 0.05, 0.2):
        plan = mp.plan(panda, START, GOAL, POST, clearance=0.01, seeding=mp.Seeding(time_limit=limit), throw=False)
        assert plan.status is mp.Status.NO_PATH or plan.report.passed


def test_an_executor_keeps_the_limit_too(panda):
    with ThreadPoolExecutor(2) as executor:
        result = mp.optimize_path(
            panda,
            START,
            GOAL,
            POST,
            clearance=0.01,
            seeding=mp.Seeding(time_limit=1e-2, count=2),
            executor=executor,
            throw=False,
        )
    assert isinstance(result, mp.NoPath) or result.certificate.proven_clearance > 0.01


def test_a_deadline():
    assert not NEVER.passed and NEVER.left == np.inf
    NEVER.check()
    soon = Deadline.within(100.0)
    assert 99.0 < soon.left <= 100.0 and not soon.passed
    past = Deadline(at=time.monotonic() - 1.0)
    assert past.passed and past.left == 0.0
    with pytest.raises(OutOfTimeError):
        past.check()


@pytest.mark.parametrize("made", [NEVER, Deadline.within(50.0), Deadline(at=0.0)], ids=["never", "later", "past"])
def test_a_deadline_in_another_process(made):
    sent = pickle.loads(pickle.dumps(made))
    assert sent.left == pytest.approx(made.left, abs=1.0) or sent.left == made.left == np.inf
    assert sent.passed == made.passed


def test_the_search_for_a_first_path_gets_what_is_left(panda, monkeypatch):
    given = []

    def seed(*_, seeding, **__):
        given.append(seeding.time_limit)
        raise mp.PlanningError("none")

    monkeypatch.setattr("manipplan.optimize.problem.seed_path", seed)
    for planner, share in (("auto", 1.0), ("RRTstar", 0.5)):
        with pytest.raises(mp.PlanningError):
            mp.optimize_path(panda, START, GOAL, POST, seeding=mp.Seeding(planner=planner, time_limit=8.0))
        assert 0.9 * 8.0 * share < given[-1] <= 8.0 * share
