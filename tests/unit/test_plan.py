"""The job from start to goal on a real arm, its files, and every wrong input."""

import json

import numpy as np
import pytest

import manipplan as mp

#: Groups of options; where one has a wrong value, it raises when it is made.
GROUPS = {"objective": mp.PathObjective, "shape": mp.PathShape, "seeding": mp.Seeding}


def test_the_demo_plan_keeps_its_promises(demo_problem, demo_plan):
    report = demo_plan.report
    assert demo_plan.status is mp.Status.OPTIMAL
    assert report.passed
    assert report.collision_free
    assert report.min_manipulability > 2 * report.seed_min_manipulability
    assert report.min_manipulability > 2 * report.straight_min_manipulability
    assert report.g <= report.seed_g
    for kind in ("velocity", "acceleration"):
        assert 0.9 < report.limits[kind].ratio <= 1 + 1e-6
        assert report.limits[kind].joint.startswith("panda_joint")
    np.testing.assert_allclose(demo_plan.trajectory.q[-1], demo_problem.goal, atol=1e-9)


@pytest.mark.slow
def test_the_same_seed_gives_the_same_plan(demo_problem, demo_plan):
    again = mp.plan(demo_problem.robot, demo_problem.start, demo_problem.goal, demo_problem.scene)
    np.testing.assert_array_equal(again.trajectory.q, demo_plan.trajectory.q)


@pytest.mark.slow
def test_files_have_a_way_back(tmp_path, demo_plan):
    files = demo_plan.save(tmp_path / "out")
    assert {file.name for file in files} == {
        "trajectory.csv", "trajectory.json", "trajectory.yaml", "report.json", "report.txt", "plan.png", "plan.json",
    }  # fmt: skip
    for name, read in (("csv", "from_csv"), ("json", "from_json"), ("yaml", "from_ros")):
        again = getattr(mp.Trajectory, read)(tmp_path / "out" / f"trajectory.{name}")
        np.testing.assert_array_equal(again.q, demo_plan.trajectory.q)
        np.testing.assert_array_equal(again.t, demo_plan.trajectory.t)
    assert mp.results.Report.from_json(tmp_path / "out" / "report.json") == demo_plan.report
    picture = (tmp_path / "out" / "plan.png").read_bytes()
    assert picture[:8] == b"\x89PNG\r\n\x1a\n"
    assert 50_000 < len(picture) < 300_000


def test_a_broken_report_is_told(tmp_path):
    (tmp_path / "report.json").write_text(json.dumps({"robot": "panda"}))
    with pytest.raises(mp.errors.FileFormatError, match="a report written by manipplan"):
        mp.results.Report.from_json(tmp_path / "report.json")


@pytest.mark.slow
def test_clearance_is_kept(planar):
    scene = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    near = mp.plan(planar, [0, 1.5, -2], [np.pi, -2, 2], scene, objective=mp.PathObjective(power=2.0))
    wide = mp.plan(planar, [0, 1.5, -2], [np.pi, -2, 2], scene, objective=mp.PathObjective(power=2.0), clearance=0.12)
    assert near.report.clearance < 0.1
    assert wide.report.clearance >= 0.12 - 1e-6


@pytest.mark.slow
def test_torque_is_reported_and_kept(demo_problem):
    plan = mp.plan(demo_problem.robot, demo_problem.start, demo_problem.goal, demo_problem.scene, torque=True)
    assert 0 < plan.report.limits["torque"].ratio <= 1 + 1e-6


@pytest.mark.slow
def test_planar_arm_among_obstacles(planar):
    """The free optimum of (6.13) passes (0, 2.2) m; a post there is avoided."""
    scene = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    free = mp.plan(planar, [0, 1.5, -2], [np.pi, -2, 2], objective=mp.PathObjective(power=2.0))
    tool = planar.kinematics().pose(free.path(np.linspace(0, 1, 500)))[:, :2, 3]
    assert np.linalg.norm(tool - [0.03, 2.2], axis=1).min() < 0.05
    plan = mp.plan(planar, [0, 1.5, -2], [np.pi, -2, 2], scene, objective=mp.PathObjective(power=2.0))
    assert plan.report.collision_free
    tool = planar.kinematics().pose(plan.path(np.linspace(0, 1, 500)))[:, :2, 3]
    assert np.linalg.norm(tool - [0.03, 2.2], axis=1).min() > 0.12


def test_wrong_kinds_of_things(demo_problem):
    start, goal = demo_problem.start, demo_problem.goal
    with pytest.raises(mp.errors.InvalidInputError, match="robot: got 'panda'; allowed: a Robot"):
        mp.plan("panda", start, goal)
    with pytest.raises(mp.errors.InvalidInputError, match="scene: got 'scene.yaml'; allowed: a Scene"):
        mp.plan(demo_problem.robot, start, goal, "scene.yaml")
    with pytest.raises(mp.errors.InvalidInputError, match="a list of obstacles"):
        mp.Scene(mp.Sphere(radius=1.0))


def test_a_singular_start_is_planned_and_told(planar, tmp_path):
    plan = mp.plan(planar, [0.0, 0.0, 0.0], [1.0, 1.0, 1.0], objective=mp.PathObjective(floor=0.0))
    assert plan.status is mp.Status.SINGULAR
    assert plan.report.min_manipulability == pytest.approx(0.0, abs=1e-15)
    assert "at the start, which all paths" in plan.report.minimum_note
    plan.report.to_json(tmp_path / "report.json")
    assert json.loads((tmp_path / "report.json").read_text(), parse_constant=pytest.fail)["g"] == "inf"
    assert mp.results.Report.from_json(tmp_path / "report.json") == plan.report


def test_progress_tells_each_step(planar):
    told = []
    mp.plan(
        planar,
        [0, 1.5, -2],
        [np.pi, -2, 2],
        objective=mp.PathObjective(power=2.0),
        progress=lambda share, text: told.append((share, text)),
    )
    shares, texts = zip(*told, strict=True)
    assert list(shares) == sorted(shares)
    assert shares[0] == 0.0 and shares[-1] == 1.0
    assert list(dict.fromkeys(texts)) == [
        "preparing collision shapes", "looking for a first path", "optimising the path", "timing the motion",
        "checking the result", "done",
    ]  # fmt: skip


def test_the_measure_and_metric_that_counted_are_reported(planar):
    plan = mp.plan(
        planar,
        [0, 1.5, -2],
        [np.pi, -2, 2],
        objective=mp.PathObjective(measure="smallest_singular_value", metric=[4.0, 1.0, 1.0], power=2.0),
    )
    kinematics = planar.kinematics(measure="smallest_singular_value")
    path = plan.trajectory.path()
    s, weights = path.quadrature(panels=80)
    speed = np.sqrt(path(s, 1) ** 2 @ [4.0, 1.0, 1.0])
    g = weights @ (speed / kinematics.manipulability(path(s)) ** 2)
    assert plan.report.measure == plan.result.measure.name == "smallest_singular_value"
    assert plan.report.g == pytest.approx(g, rel=1e-6)
    assert plan.report.measure_unit == "m"
    assert plan.report.min_manipulability == pytest.approx(
        kinematics.manipulability(path(np.linspace(0, 1, 5000))).min(), rel=1e-3
    )


@pytest.mark.slow
def test_several_first_paths_and_shifted_goals(planar):
    start, goal = [0, -3.0, -2.0], [np.pi, 0.1, 1.4]
    one = mp.plan(planar, start, goal, objective=mp.PathObjective(power=2.0))
    more = mp.plan(
        planar, start, goal, objective=mp.PathObjective(power=2.0), seeding=mp.Seeding(shifts="within-limits", count=2)
    )
    assert more.report.g < 0.8 * one.report.g  # a turn of one joint is much better (ERRATA)
    assert more.result.rivals
    turns = (more.path.goal - goal) / (2 * np.pi)
    assert turns == pytest.approx(np.round(turns), abs=1e-9)
    assert np.abs(more.trajectory.q[-1] - more.path.goal).max() < 1e-6


@pytest.mark.slow
def test_jerk_of_a_plan_is_reported_where_it_is_limited(demo_problem):
    plan = mp.plan(demo_problem.robot, demo_problem.start, demo_problem.goal, demo_problem.scene)
    t = plan.trajectory.t
    midway = (t[1:] + t[:-1]) / 2
    jerk = np.abs(plan.trajectory(midway, 3)) / demo_problem.robot.limits.jerk
    assert plan.report.limits["jerk"].ratio == pytest.approx(jerk.max(), rel=1e-6)
    assert 0.1 < plan.report.limits["jerk"].ratio <= 1 + 1e-6
    assert "jerk" in str(plan.report)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"start": [0.0] * 6}, r"start.*shape \(7,\)"),
        ({"start": [[0.0] * 7]}, "start.*one configuration"),
        ({"goal": [0.0] * 6 + [np.nan]}, "goal.*finite"),
        ({"goal": "home"}, "goal: got 'home'"),
        ({"start": [9.0, 0, 0, -2, 0, 2, 0]}, r"start\[0\] \(panda_joint1\): got 9\.0; allowed: -2\.8973 to 2\.8973"),
        ({"goal": [0.0, 1.76, 0, -0.1, 0, 1.5, 0]}, "goal.*free configuration.*post overlap by"),
        ({"clearance": -1}, "clearance"),
        ({"clearance": 0.5}, "start.*the required clearance is 0.5"),
        ({"shape": {"degree": 0}}, "degree"),
        ({"objective": {"power": -1}}, "power"),
        ({"seeding": {"seed": -1}}, "seed"),
        ({"seeding": {"time_limit": 0}}, "time_limit"),
        ({"objective": {"task": "pose"}}, "task"),
        ({"start": [True] * 7}, "start.*real numbers"),
        ({"goal": [1j] * 7}, "goal.*real numbers"),
        ({"shape": {"degree": "6"}}, "degree: got '6'"),
        ({"seeding": {"time_limit": np.inf}}, "time_limit"),
    ],
)
@pytest.mark.parametrize("throw", [True, False])
def test_wrong_arguments_raise_at_once(demo_problem, change, message, throw):
    arguments = {"start": demo_problem.start, "goal": demo_problem.goal, **change}
    start, goal = arguments.pop("start"), arguments.pop("goal")
    steps = []
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.plan(
            demo_problem.robot,
            start,
            goal,
            demo_problem.scene,
            throw=throw,
            progress=lambda *told: steps.append(told),
            **{name: GROUPS[name](**value) if name in GROUPS else value for name, value in arguments.items()},
        )
    needs_shapes = "free configuration" in message or "required clearance" in message
    assert len(steps) <= (2 if needs_shapes else 0)


def test_an_unreachable_goal_is_told(planar):
    wall = mp.Scene([mp.Box(size=(0.05, 8.0, 1.0), position=(-0.4, 0.0, 0.0), name="wall")])
    start, goal = [0.5, 0.5, 0.5], [-0.5, -0.5, -0.5]
    # a second wall between the two on the other side
    cage = mp.Scene([*wall.obstacles, mp.Box(size=(5.0, 0.02, 1.0), position=(2.6, 0.0, 0.0), name="shelf")])
    with pytest.raises(
        mp.errors.PlanningError, match=r"proven .* joint1 .* into contact; at the goal link1_0 and shelf"
    ) as caught:
        mp.plan(planar, start, goal, cage, seeding=mp.Seeding(time_limit=60.0))
    assert caught.value.result.status is mp.Status.NO_PATH
    failed = mp.plan(planar, start, goal, cage, seeding=mp.Seeding(time_limit=60.0), throw=False)
    assert failed.trajectory is None
    assert not failed.status.has_path
    with pytest.raises(mp.errors.PlanningError, match="no trajectory to save"):
        failed.save("nowhere")


def test_the_optimiser_tells_that_there_is_no_path(planar):
    cage = mp.Scene(
        [mp.Box(size=(8.0, 0.02, 1.0), position=(0.0, 0.02 + sign * 0.5, 0.0), name=f"wall{sign}") for sign in (-1, 1)]
    )
    start, goal = [0.0, 0.1, 0.0], [np.pi, -0.1, 0.0]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("manipplan.optimize.problem.seed_path", _no_seed)
        with pytest.raises(mp.errors.PlanningError, match="nothing") as caught:
            mp.optimize_path(planar, start, goal, scene=cage)
        result = mp.optimize_path(planar, start, goal, scene=cage, throw=False)
    assert caught.value.result.status is result.status is mp.Status.NO_PATH
    assert result.path is None
    assert result.g == np.inf


def _no_seed(*_, **__):
    raise mp.errors.PlanningError("nothing was found")


@pytest.mark.slow
def test_no_motion_within_the_limits_is_told(panda):
    weak = panda.with_limits(effort=np.array([87.0, 3.0, 87, 87, 12, 12, 12]))
    goal = weak.neutral + 0.3
    with pytest.raises(mp.errors.PlanningError, match="gravity alone loads panda_joint2"):
        mp.plan(weak, weak.neutral, goal, torque=True)
    failed = mp.plan(weak, weak.neutral, goal, torque=True, throw=False)
    assert failed.status is mp.Status.NO_TIMING
    assert failed.path is not None
    assert "gravity alone loads panda_joint2" in failed.message


def test_unlimited_speed_is_told_before_work_starts(panda):
    steps = []
    with pytest.raises(mp.errors.InvalidInputError, match=r"limits\.velocity.*give velocity="):
        mp.plan(
            panda.with_limits(velocity=np.inf), panda.neutral, panda.neutral + 0.3, progress=lambda *told: steps.append(told)
        )
    assert steps == []


def test_seed_path_is_deterministic_and_free(demo_problem):
    problem = demo_problem
    first = mp.seed_path(problem.robot, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(seed=3))
    second = mp.seed_path(problem.robot, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(seed=3))
    np.testing.assert_array_equal(first.control, second.control)
    assert problem.scene.collision_model(problem.robot).path_is_free(first, 1e-3)
    other = mp.seed_path(problem.robot, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(seed=4))
    assert abs(other.length - first.length) > 1e-6
    with pytest.raises(mp.errors.UnknownNameError, match="RRTConnect"):
        mp.seed_path(
            problem.robot, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(planner="RRTconnect", time_limit=3)
        )


def test_whole_numbers_serve_where_numbers_are_asked_for(demo_problem):
    problem = demo_problem
    path = mp.seed_path(
        problem.robot, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(time_limit=5), clearance=0
    )
    assert len(path.control) > 1


@pytest.mark.slow
def test_a_plane_in_the_scene_does_not_spoil_the_picture(panda, tmp_path):
    scene = mp.Scene([mp.Plane(position=(0.0, 0.0, -0.06), name="floor"), mp.Sphere(radius=0.1, position=(0.3, -0.4, 0.6))])
    plan = mp.plan(panda, panda.neutral, panda.neutral + 0.2, scene)
    assert (tmp_path / "plan.png") in plan.save(tmp_path)
    assert (tmp_path / "plan.png").stat().st_size > 10_000


def test_statuses_without_a_path_say_that_they_failed():
    for status in mp.Status:
        assert status.value.startswith("failed") == (not status.has_path) and not (status.ok and not status.has_path)
