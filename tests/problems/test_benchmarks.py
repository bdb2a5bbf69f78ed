"""Benchmarks that need no peer, each with little work: what their tables count is what happens."""

import sys
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import cold_start
import control_step
import demo_timing
import first_paths
import motionbenchmaker
import plan_many
import six_joint_arms
import version_01
from outside import problems


@pytest.fixture(scope="module")
def panda():
    return problems.robot("panda")


def test_refused_problems_are_those_that_plan_refuses(panda):
    """Those with an end beyond a joint limit, and no others: no start or goal touches anything."""
    every = problems.load("panda")
    found = [(problem, motionbenchmaker.refusal(panda, problem)) for problem in every]
    refused = [problem for problem, outcome in found if outcome is not None]
    assert all(outcome.result == motionbenchmaker.BEYOND for _, outcome in found if outcome is not None)
    with pytest.raises(mp.InvalidInputError, match=r"^(start|goal)"):
        mp.plan(panda, refused[0].start, refused[0].goal, refused[0].scene)
    model = [problem.scene.collision_model(panda) for problem, outcome in found if outcome is None]
    accepted = [problem for problem, outcome in found if outcome is None]
    assert len(accepted) == 346
    for each, problem in zip(model, accepted, strict=True):
        assert min(each.distances(problem.start).min(), each.distances(problem.goal).min()) >= 0


def test_meshes_touch_where_an_obstacle_is_in_a_link(panda):
    hand = panda.kinematics().pose(panda.neutral)[:3, 3]
    ball = mp.Scene([mp.Sphere(radius=0.05, position=hand)])
    away = mp.Scene([mp.Sphere(radius=0.05, position=hand + [0.0, 0.0, -0.3])])
    assert not motionbenchmaker.free_by_meshes(panda, ball, panda.neutral)
    assert motionbenchmaker.free_by_meshes(panda, away, panda.neutral)


def test_the_first_problem_in_a_box_is_optimised(panda):
    problem = next(problem for problem in problems.load("panda") if problem.set == "box")
    outcome = motionbenchmaker.outcome(panda, problem)
    assert outcome.result in motionbenchmaker.OPTIMISED
    assert 0 < outcome.ratio < 1
    assert "| box | 1 | 0 | 0 | 0 |" in motionbenchmaker.row("box", [outcome])


@pytest.mark.slow
def test_pairs_of_six_joint_arms_are_optimised(tmp_path):
    found = six_joint_arms.main(["--pairs", "2", "--out", str(tmp_path / "table.md")])
    assert len(found) == 2 * len(six_joint_arms.ARMS)
    assert {each.status for each in found} == {mp.Status.OPTIMAL}
    assert all(each.ratio < 1 and each.crossings >= each.least for each in found)
    assert all(each.fall < 1e-6 for each in found), "OPTIMAL paths are optimised again"
    assert max(each.least for each in found) > 0
    assert "| all | 8 |" in (tmp_path / "table.md").read_text()


def test_upright_ur5_gets_a_proven_and_optimised_motion():
    ur5, problem = problems.robot("ur5"), problems.load("ur5")[0]
    assert np.allclose(problem.start[1:4], [-1.5707, 0.0, -1.5707], atol=1e-3)
    outcome = motionbenchmaker.outcome(ur5, problem)
    assert outcome.result in motionbenchmaker.OPTIMISED
    assert outcome.proven
    assert 0 < outcome.ratio < 1


@pytest.mark.slow
def test_twelve_first_paths_are_never_worse_than_one(tmp_path):
    made = first_paths.main(["--pairs", "1", "--out", str(tmp_path / "table.md")])
    every = [each for found in made.values() for each in found]
    assert len(every) == len(made) == 9
    assert all(each.ratio <= 1 + 1e-5 for each in every)
    assert all(abs(each.gained - 1) < 1e-2 for each in every if each.clear)
    assert all(each.apart <= 1e-3 for group in made if group[1] == "free" for each in made[group] if each.clear)
    assert any(each.clear for each in made["panda", "free"])


@pytest.mark.slow
def test_many_plans_are_the_same_on_one_process_and_two(tmp_path):
    runs = plan_many.main(["--problems", "3", "--out", str(tmp_path / "table.md")])
    assert len(runs) == 2 * 4
    for kind in plan_many.KINDS:
        digests = [each.digests for each in runs if each.kind == kind]
        assert all(each == digests[0] for each in digests) and len(digests[0]) == 3
    assert "| 3 of 3 |" in (tmp_path / "table.md").read_text()
    everything = plan_many.among_obstacles(702)
    assert np.array_equal(everything[0].start, everything[350].goal) and everything[700].seeding.seed == 1


def test_at_rest_bounds_are_active_and_along_a_path_hardly_any(tmp_path):
    found = control_step.main(["--rounds", "1", "--interpreted", "--out", str(tmp_path / "table.md")])
    assert len(found) == 3 * len(control_step.FORMULATIONS) * 2
    for case, _, _, _, middle in found:
        assert middle.active > 1.5 if case == control_step.REST else middle.active < 1
        assert 0 < middle.median <= middle.high
        assert np.isfinite(middle.high)


@pytest.mark.slow
def test_every_call_that_is_timed_beside_version_01_runs():
    for call in version_01.calls().values():
        assert call() is not None


@pytest.mark.parametrize(("duration", "text"), [(2.5, "2.5 s"), (0.0123, "12.3 ms"), (4.56e-6, "4.56 µs")])
def test_durations_are_shown_with_a_unit_that_suits_them(duration, text):
    assert version_01.shown(duration) == text


def test_how_far_a_motion_is_away_from_a_path(rng):
    path = mp.JointPath.line(np.zeros(3), [0.0, 0.0, 1.0])
    along, beside = rng.random(20), rng.uniform(-0.1, 0.1, (20, 2))
    assert demo_timing.away(path, path(along)) < 1e-12
    assert demo_timing.away(path, np.column_stack([beside, along])) == pytest.approx(np.linalg.norm(beside, axis=1).max())
    assert demo_timing.away(path, np.array([[0.0, 0.0, 1.5]])) == pytest.approx(0.5)


@pytest.mark.slow
def test_rows_of_the_demo_s_timing(panda):
    path = mp.JointPath.line(panda.neutral, panda.neutral + 0.3)
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), position=(0.0, 2.0, 0.0))])
    motion = mp.retime(path, panda)
    row = demo_timing.Row(name="ours", limits="all", duration=motion.duration, seconds=[0.003, 0.001, 0.002], q=motion.q)
    text = demo_timing.page([row, row, row], path, scene.collision_model(panda), 3)
    assert f"| ours | all | {motion.duration:.4f} | 0.000 | " in text
    assert "| 2, 3 |" in text and "takes 1.00 times as long as toppra" in text


def test_first_calls_compile_once_and_then_load(tmp_path):
    name = "inverse_kinematics, ur5"
    found = cold_start.main(["--runs", "1", "--jobs", name, "--out", str(tmp_path / "table.md")])[name]
    (_, ever), (_, later), (_, again) = (samples[0] for samples in found.values())
    assert ever > 3 * later > 3 * again > 0, "processor times"
    assert (tmp_path / "table.md").read_text().count("inverse_kinematics, ur5") == 3
