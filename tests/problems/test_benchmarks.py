"""Benchmarks that need no peer, each with little work: what their tables count is what happens."""

import sys
from dataclasses import replace
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import against_01
import against_revision
import blends
import check_trajectories
import closed_meshes
import cold_start
import control_step
import demo_timing
import files_to_read
import first_models
import first_paths
import first_plans
import grid_steps
import killed_saves
import lead_ins
import mesh_pairs
import motionbenchmaker
import motions
import online_global
import plan_many
import recorded_motions
import servo_step
import six_joint_arms
import threads
import timed_motions
import tool_paths
import two_arms
import version_01
from meshes import MeshModel
from outside import problems
from world import write_description


@pytest.fixture(scope="module")
def panda():
    return problems.robot("panda")


def test_refused_problems_are_those_that_plan_refuses(panda):
    """Those with an end beyond a joint limit, and no others: no start or goal touches anything."""
    every = problems.load("panda")
    found = [(problem, motionbenchmaker.refusal(panda, problem)) for problem in every]
    refused = [problem for problem, outcome in found if outcome is not None]
    assert all(outcome.result == motionbenchmaker.BEYOND for _, outcome in found if outcome is not None)
    with pytest.raises(mp.errors.InvalidInputError, match=r"^(start|goal)"):
        mp.plan(panda, refused[0].start, refused[0].goal, refused[0].scene)
    model = [problem.scene.collision_model(panda) for problem, outcome in found if outcome is None]
    accepted = [problem for problem, outcome in found if outcome is None]
    assert len(accepted) == 346
    for each, problem in zip(model, accepted, strict=True):
        assert min(each.distances(problem.start).min(), each.distances(problem.goal).min()) >= 0


def touches_pair_by_pair(robot, scene, q):
    """Whether coal finds a contact of a mesh of a moving link with an obstacle."""
    data, placed = robot.model.createData(), robot.geometry.createData()
    pin.updateGeometryPlacements(robot.model, data, robot.geometry, placed, q)
    for link, pose in zip(robot.geometry.geometryObjects, placed.oMg, strict=True):
        for obstacle in scene.obstacles if link.parentJoint else ():
            at, there = (coal.Transform3s(each.rotation, each.translation) for each in (pose, obstacle.pose))
            for shape in obstacle.shapes():
                if coal.collide(link.geometry, at, shape, there, coal.CollisionRequest(), coal.CollisionResult()):
                    return True
    return False


def test_meshes_touch_where_coal_finds_a_contact_pair_by_pair(panda):
    scene = next(problem for problem in problems.load("panda") if problem.set == "cage").scene
    model, q = MeshModel(panda, scene), panda.random_configuration(np.random.default_rng(1), size=60)
    touching = [touches_pair_by_pair(panda, scene, each) for each in q]
    assert [not model.is_free(each) for each in q] == touching
    assert 0 < sum(touching) < len(q)
    assert not model.is_free(q)


def test_a_thin_rod_on_the_way_is_met_between_the_ends(panda):
    path = mp.JointPath.line(panda.neutral - 0.3, panda.neutral + 0.3)
    wrist = panda.kinematics().pose(path(0.5))[:3, 3] + [0.0, 0.0, 0.1]
    for away, free in ((0.0, False), (0.6, True)):
        rod = mp.Cylinder(radius=0.0005, length=0.3, position=wrist + [away, 0.0, away], rotation=np.eye(3)[:, [2, 0, 1]])
        model = MeshModel(panda, mp.Scene([rod]))
        assert model.is_free(path(np.array([0.0, 1.0])))
        assert model.motion_is_free(path) is free


def test_the_first_problem_in_a_box_is_optimised(panda, tmp_path):
    problem = next(problem for problem in problems.load("panda") if problem.set == "box")
    outcome = motionbenchmaker.outcome(panda, problem)
    assert outcome.result in motionbenchmaker.OPTIMISED
    assert outcome.good
    motion = outcome.motion
    assert 0 < motion.over_seed < 1
    assert motion.least >= 0.99 * motion.seed_least
    assert 0 <= motion.seed_cpu < motion.cpu
    lines = motionbenchmaker.tables([outcome])
    assert "| box | 1 | 0 | 0 | 0 |" in lines[2]
    assert lines[-1].startswith("1 of 1 get a motion, 1 an optimised one; 1 of the 1 inside the limits")
    worse = replace(motion, g=2 * motion.g, cpu=4 * motion.cpu, least=motion.least / 2)
    assert motionbenchmaker.compared([outcome], [worse])[2].endswith("| 0.25 | 1 of 1 | 2.00 | 0.50 |")
    motionbenchmaker.draw([outcome], [worse], tmp_path / "picture.png")
    assert (tmp_path / "picture.png").stat().st_size < 300_000


def test_a_motion_of_a_peer_is_read_as_the_curve_that_it_is(panda):
    t = np.linspace(0.0, 2.0, 201)
    q = panda.neutral + np.outer(np.sin(t), np.ones(7))
    path = motions.through(t, q, np.outer(np.cos(t), np.ones(7)))
    s = np.linspace(0.0, 1.0, 997)
    assert np.abs(path(s) - panda.neutral - np.sin(2 * s)[:, None]).max() < 1e-9


@pytest.mark.parametrize("arm", ["panda", "xarm7"])
def test_the_description_for_peers_has_our_kinematics_and_meshes(arm, tmp_path):
    robot = problems.robot(arm) if arm == "panda" else mp.load_robot(arm)
    given = write_description(robot, tmp_path)
    model = pin.buildModelFromUrdf(given["urdf"])
    assert list(model.names[1:]) == list(robot.joint_names)
    theirs = pin.buildGeomFromUrdf(model, given["urdf"], pin.GeometryType.COLLISION, package_dirs=str(tmp_path))
    assert len(theirs.geometryObjects) == len(robot.geometry.geometryObjects)
    q = robot.random_configuration(np.random.default_rng(3))
    data, placed, ours = model.createData(), theirs.createData(), robot.geometry.createData()
    pin.updateGeometryPlacements(model, data, theirs, placed, q)
    pin.updateGeometryPlacements(robot.model, robot.model.createData(), robot.geometry, ours, q)
    for link, pose in zip(theirs.geometryObjects, placed.oMg, strict=True):
        where = ours.oMg[robot.geometry.getGeometryId(link.name)]
        assert np.abs(pose.homogeneous - where.homogeneous).max() < 1e-9
    assert "disable_collisions" in (tmp_path / "arm.srdf").read_text()


def test_each_kind_of_timed_motions_has_its_problems():
    found = timed_motions.kinds(1)
    assert list(found) == ["free pairs", "five boxes", "table", "shelf"]
    assert [len(each[0].scene.obstacles) > 0 for each in found.values()] == [False, True, True, True]


def test_figures_beside_an_older_version_count_g_and_time():
    def row(new, old):
        return {name: {"g": g, "cpu": cpu, "status": "OPTIMAL"} for name, (g, cpu) in (("new", new), ("old", old))}

    rows = [
        row((1.0, 0.1), (1.0, 0.5)),
        row((1.005, 0.1), (1.0, 0.4)),
        row((1.2, 0.1), (1.0, 0.3)),
        row((1.0, 0.1), (np.inf, 1.0)),
    ]
    cells = against_01.cells(rows)
    assert cells[0] == "4"
    assert cells[3].startswith("4.50, ")
    assert cells[4] == "3 of 4 (75 %)"
    assert cells[5] == "1.0683, 1.200"
    assert cells[6] == "1, 0"


def test_figures_beside_an_older_revision_are_of_problems_with_the_same_status():
    def row(name, old, new, status="OPTIMAL"):
        return {"name": name, "old": {"status": "OPTIMAL", "cpu": old}, "new": {"status": status, "cpu": new}}

    rows = [row("a", 0.1, 0.1), row("b", 0.2, 0.3), row("c", 0.4, 0.2), row("d", 1.0, 9.0, "NO_PATH")]
    assert against_revision.cells(rows) == ["4", "3", "200 ms", "200 ms", "1.000", "1.000", "1.50 (b)"]
    assert against_revision.cells(rows[3:])[:2] == ["1", "0"]


@pytest.mark.slow
def test_each_set_beside_an_older_revision_has_problems_that_are_solved():
    rows = [against_revision.planner_rows("ur5", 1)[0], against_revision.path_rows(0)[0], against_revision.program_rows(1)[0]]
    assert [against_revision.answer(row)["status"] for row in rows] == ["OPTIMAL", "FOLLOWED", "SOLVED"]


@pytest.mark.slow
def test_a_later_process_finds_the_collision_model(tmp_path):
    [found] = first_models.main(["--robots", "ur5", "--runs", "1", "--out", str(tmp_path / "table.md")])
    assert found.first[1] > 5 * found.usual[1] > 0
    assert "| ur5 | " in (tmp_path / "table.md").read_text()


@pytest.mark.slow
def test_bodies_in_closed_meshes_get_the_judge_s_verdicts(tmp_path):
    found = closed_meshes.main(["--meshes", "7", "--bodies", "30", "--out", str(tmp_path / "table.md")])
    assert sum(row.verdicts for row in found.values()) > 400 and sum(row.inside for row in found.values()) > 20
    assert not any(row.free or row.beyond for row in found.values())
    assert not any(row.touching for (where, kind), row in found.items() if where == "obstacle" and kind != "tube")


def test_the_judge_of_closed_meshes_knows_insides_and_distances():
    cube = closed_meshes.extruded(np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]), 2.0)
    ball = closed_meshes.Body(kind="sphere", size=(0.25,), triangles=np.empty((0, 3, 3)))
    box = closed_meshes.Body(kind="box", size=(0.25,) * 3, triangles=0.25 * cube)
    for x, distance, place in ((0.0, -0.75, "inside"), (3.0, 1.75, "outside"), (1.1, -0.15, "across")):
        pose = np.eye(4)
        pose[0, 3] = x
        assert ball.signed_distance(pose, cube) == (pytest.approx(distance), place)
        apart, where = box.signed_distance(pose, cube)
        assert where == place and (place == "across" or apart == pytest.approx(distance))


@pytest.mark.slow
def test_arms_with_pairs_of_meshes_are_planned_for_without_coal(tmp_path):
    robots = ["fork around a blade", "window"]
    found = mesh_pairs.main(["--plans", "2", "--lines", "1", "--robots", *robots, "--out", str(tmp_path / "table.md")])
    assert [each.plans.statuses for each in found] == [["OPTIMAL", "OPTIMAL"]] * 2
    assert max(share for each in found for share in each.plans.shares + each.lines.shares) < 0.1
    assert "| all | 128 | 4 | 4 |" in (tmp_path / "table.md").read_text()


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
    assert outcome.good
    assert 0 < outcome.motion.over_seed < 1


def test_ur5_reaches_out_of_a_cage_from_an_upright_start():
    """The fit at an even pace spends nearly all of the path beside the singular start."""
    ur5 = problems.robot("ur5")
    problem = next(each for each in problems.load("ur5") if each.set == "cage" and each.number == 23)
    plan = mp.plan(ur5, problem.start, problem.goal, problem.scene)
    assert plan.status is mp.Status.OPTIMAL
    assert plan.result.g < 0.5 * plan.result.seed_cost.g


@pytest.mark.parametrize(("name", "number"), [("bookshelf_small", 71), ("cage", 51), ("table_under_pick", 71)])
def test_descents_end_at_optima_at_kinks(name, number):
    """The nearest features change along these paths; without a mixture of their gradients descents ended at 2e-3 to 2e-2."""
    panda = problems.robot("panda")
    problem = next(each for each in problems.load("panda") if each.set == name and each.number == number)
    plan = mp.plan(panda, problem.start, problem.goal, problem.scene)
    assert plan.status is mp.Status.OPTIMAL
    again = mp.optimize_path(panda, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(initial=plan.path))
    assert 1 - again.g / plan.result.g < 2e-5


@pytest.mark.slow
@pytest.mark.parametrize(("scene", "number"), [("bookshelf_thin", 7), ("box", 11)])
def test_an_optimum_beside_an_edge_stays_optimal(panda, scene, number):
    """A second descent from there ended at a g that was larger by 1e-7, and the seed was called better."""
    [problem] = [each for each in problems.load("panda") if (each.set, each.number) == (scene, number)]
    plan = mp.plan(panda, problem.start, problem.goal, problem.scene)
    again = mp.optimize_path(panda, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(initial=plan.path))
    assert plan.status is again.status is mp.Status.OPTIMAL
    assert abs(1 - again.g / plan.result.g) < 2e-5


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


def test_steps_of_a_servo_are_timed_far_from_singular_postures_and_near_them(tmp_path):
    found = servo_step.main(["--rounds", "1", "--seconds", "4", "--out", str(tmp_path / "table.md")])
    assert set(found) == set(servo_step.NAMES)
    assert all(times.shape == (1, 2000) and (times > 0).all() for times in found.values())
    table = (tmp_path / "table.md").read_text()
    assert all(f"\n| {name} |" in table for name in servo_step.NAMES)
    assert "| panda | 0 |" not in table


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
    text = demo_timing.page([row, row, row], path, panda, scene, 3)
    assert f"| ours | all | {motion.duration:.4f} | 0.000 | " in text
    assert "| 2, 3 |" in text and "takes 1.00 times as long as toppra" in text


def test_first_calls_build_no_machine_code(tmp_path):
    name = "inverse_kinematics, ur5"
    found = cold_start.main(["--runs", "1", "--jobs", name, "--out", str(tmp_path / "table.md")])[name]
    (_, ever), (_, later), (_, again) = (samples[0] for samples in found.values())
    assert 3 * later > ever > 3 * again > 0, "processor times"
    assert (tmp_path / "table.md").read_text().count("inverse_kinematics, ur5") == 3


def test_checks_agree_with_the_other_judge_and_a_wrong_one_is_caught(tmp_path, monkeypatch, capsys):
    arguments = ["--count", "18", "--out", str(tmp_path / "table.md")]
    assert check_trajectories.main(arguments) == 0
    rows = [line.split(" | ") for line in (tmp_path / "table.md").read_text().splitlines() if line.startswith("| ")][1:]
    assert [row[0].strip("| ") for row in rows] == [*check_trajectories.RESPECTS, "all"]
    assert sum(int(row[1]) for row in rows[:-1]) == int(rows[-1][1]) == 9  # every other one is spoilt
    assert int(rows[-1][3]) >= 9
    right = check_trajectories.judged

    def lenient(case):
        report, seconds = right(case)
        return replace(report, faults=()), seconds

    monkeypatch.setattr(check_trajectories, "judged", lenient)
    assert check_trajectories.main(arguments) >= 9


def test_recorded_motions_keep_everything_and_a_worse_one_is_caught(tmp_path, monkeypatch, capsys):
    arguments = ["--count", "9", "--out", str(tmp_path / "table.md")]
    assert recorded_motions.main(arguments) == 0
    rows = [line.split(" | ") for line in (tmp_path / "table.md").read_text().splitlines() if line.startswith("| ")][1:]
    assert [row[0].strip("| ") for row in rows] == [*recorded_motions.KINDS, *recorded_motions.ARMS, "all"]
    assert [int(cell) for cell in (rows[-1][1], rows[-1][3])] == [9, 9]
    right = mp.improve

    def slower(robot, recorded, *rest, **options):
        return right(robot, recorded, *rest, duration=1.01 * recorded.duration, **options)

    monkeypatch.setattr(mp, "improve", slower)
    assert recorded_motions.main(arguments) == 9


def test_the_judge_of_two_arms_refuses_arms_that_touch_and_goals_that_are_missed():
    robot = mp.load_robot("baxter")
    case = two_arms.baxter_case(robot, 0, 0)
    [plan] = two_arms.together(case)
    judge = two_arms.TwoArmJudge(robot, case.scene)
    assert judge.accepts(plan.trajectory, case.goal)
    moved = {tool: pose @ pin.exp6(pin.Motion(np.array([1e-5, 0, 0, 0, 0, 0]))).homogeneous for tool, pose in case.goal.items()}
    assert not judge.accepts(plan.trajectory, moved)
    inwards, place = robot.neutral.copy(), np.diag([1.0, -1.0, -1.0, 1.0])
    place[:3, 3] = 0.7, 0.0, 0.1  # of both hands
    for tool in robot.tools:
        inwards[list(robot.joints_of(tool))] = mp.inverse_kinematics(robot.arm(tool), place, samples=4).q[0]
    crossing = mp.retime(mp.JointPath.line(robot.neutral, inwards), robot)
    free = two_arms.TwoArmJudge(robot, mp.Scene())
    assert not free.accepts(crossing, {})
    aside = mp.retime(mp.JointPath.line(robot.neutral, robot.neutral + 0.05), robot)
    assert free.accepts(aside, {})


def test_the_judge_of_blends():
    """Distances beyond a segment, a triangle and a tetrahedron that are known."""
    segment = np.array([[0.0, 0, 0], [1, 0, 0], [0.5, 0, 0]])
    assert blends.beyond_hull(segment, np.array([[0.3, 0, 0]])) == pytest.approx(0.0, abs=1e-12)
    assert blends.beyond_hull(segment, np.array([[1.3, 0, 0.4]])) == pytest.approx(0.5)
    triangle = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 0]])
    assert blends.beyond_hull(triangle, np.array([[0.2, 0.2, 0.1], [0.5, -0.2, 0]])) == pytest.approx(0.2)
    corner = np.vstack([triangle, [[0, 0, 1.0]]])
    assert blends.beyond_hull(corner, np.array([[0.1, 0.1, 0.1]])) == pytest.approx(0.0, abs=1e-12)
    assert blends.beyond_hull(corner, np.array([[0.1, 0.1, -0.3]])) == pytest.approx(0.3)


def test_the_judge_of_lead_ins():
    """A motion through the singularity of the wrist and by a full turn too many; and one without either."""
    robot = mp.load_robot("ur5")
    judge = lead_ins.Judge(robot)
    start = np.array([0.0, -1.4, 1.6, -1.77, -1.57, 0.0])
    for goal, count, excess in (
        (start + [0.5, 0, 0, 0, 0, 0], 0, 0.0),
        (start + [0, 0, 0, 0, 3.0, 0], 1, 0.0),
        (start + [6.0, 0, 0, 0, 0, 0], 0, 2 * (6.0 - np.pi)),
    ):
        lead_in = mp.retime(mp.JointPath.line(start, goal), robot)
        assert judge.crossings(lead_in) == count
        assert judge.excess(lead_in, lead_in.duration) == pytest.approx(excess, abs=1e-6)
    assert judge.minimum(lead_in) == pytest.approx(robot.kinematics(mp.Task.pose(length=1.0)).manipulability(start), rel=1e-6)


def test_lead_ins_and_blends_make_their_tables(tmp_path):
    lead_ins.main(["--arms", "ur5", "--lines", "1", "--starts", "3", "--out", str(tmp_path / "lead_ins.md")])
    rows = (tmp_path / "lead_ins.md").read_text().splitlines()
    assert rows[2].startswith("| ur5 | `follow` | 3 | 3 | ") and rows[3].startswith("| ur5 | `MoveAlong` | 3 | 3 | ")
    assert all(row.split("|")[8].strip() == "0" for row in rows[2:4])  # needless crossings
    blends.main(["--arms", "ur5", "--corners", "4", "--out", str(tmp_path / "blends.md")])
    cells = [row.split("|") for row in (tmp_path / "blends.md").read_text().splitlines()[2:6]]
    assert len(cells) == 4 and all(float(each[8]) <= 0.1 for each in cells)


@pytest.mark.slow
def test_killed_saves_leave_one_plan(tmp_path):
    assert killed_saves.mixed_and_left(4, tmp_path) == (0, 0)


@pytest.mark.slow
def test_first_and_second_plan_end_alike():
    (first, g, _), (second, again, _) = first_plans.measure("planar arm, a column", 20.0)
    assert (first, g) == (second, again)
    assert first == "OPTIMAL"


@pytest.mark.slow
def test_plans_in_threads_are_those_one_by_one():
    assert threads.compare(4, 6) == (6, 6)


@pytest.mark.slow
def test_files_that_run_in_a_job(tmp_path):
    found = files_to_read.main(["--out", str(tmp_path / "table.md")])
    assert all(0 < found[name] <= wanted for name, (_, wanted) in files_to_read.WANTED.items()), found


def test_the_first_path_beside_the_best_motion_has_the_figures_of_the_table():
    [case] = online_global.cases("panda", 1)
    rows = [row for row in online_global.read(online_global.CSV) if row["arm"] == "panda"][:4]
    for row in rows:
        assert (row["shape"], int(row["seed"])) == (case.shape, case.seed)
        best = online_global.judge_best(case, row["allowed"])
        assert best.whole
        assert best.least == pytest.approx(float(row["best m"]), rel=2e-3)
        q = online_global.start_of(case, row["start"], row["allowed"])
        for name in ("(3)", "(10)"):
            controller = case.arm.controller(name, row["allowed"])
            found = online_global.judge_steps(case.arm, case.path, controller, q, case.duration, row["allowed"])
            assert found.whole == bool(row[name])
            if found.whole:
                assert found.least / best.least == pytest.approx(float(row[name]), rel=5e-3)
            assert found.share == pytest.approx(float(row[f"{name} path"]), abs=0.02)


def test_controllers_beside_the_best_motion_move_as_track_does(panda):
    arm = online_global.Arm.of("panda")
    start = panda.neutral
    begin = arm.robot.kinematics(mp.Task.pose()).pose(start)
    path = online_global.shape_of("line", begin, np.random.default_rng(0))
    targets, _ = online_global.timed(path, 2.0)
    motion = arm.controller("(3)", "path").rollout(start, targets)
    tracked = mp.track(
        arm.robot,
        path,
        start,
        arm.formulation("(3)"),
        dt=online_global.DT,
        duration=2.0,
        task=arm.task,
        stiffness=online_global.STIFFNESS["path"],
        tolerance=online_global.PATH,
    )
    np.testing.assert_allclose(motion.q, tracked.q[: len(motion.q)], atol=1e-9)


def test_a_controller_that_leaves_its_path_or_limits_is_not_counted():
    arm = online_global.Arm.of("panda")
    q = np.tile(arm.robot.neutral, (3, 1))
    poses = arm.robot.kinematics(mp.Task.pose()).pose(q)
    s = np.array([0.0, 0.5, 1.0])
    kept = online_global.judge(arm, q, poses, s, "path", limits=True)
    assert kept.whole
    assert kept.least == pytest.approx(arm.robot.kinematics(arm.task).manipulability(q[0]))
    assert not online_global.judge(arm, q, poses, s, "path", limits=False).whole
    poses[1, 0, 3] += 2 * online_global.KEPT[0]
    left = online_global.judge(arm, q, poses, s, "path", limits=True)
    assert (left.share, left.whole) == (0.5, False)


@pytest.mark.parametrize("slow", [1.0, 40.0])
def test_the_judge_finds_poses_in_order_on_a_path_that_crosses_itself_however_slow_a_passage_is(slow):
    """A figure of eight, whose middle pose and ends are in one place; the first loop takes `slow` times as long."""
    u = np.concatenate([np.linspace(0.0, 0.5, round(100 * slow))[:-1], np.linspace(0.5, 1.0, 100)])
    at = [np.column_stack([np.sin(4 * np.pi * each), np.sin(2 * np.pi * each)]) for each in (u, np.linspace(0.0, 1.0, 9))]
    found = tool_paths.times_in_order(np.linalg.norm(at[0][None] - at[1][:, None], axis=2))
    assert np.abs(u[found] - np.linspace(0.0, 1.0, 9)).max() < 0.01
    missed = np.delete(at[0], np.flatnonzero(np.abs(u - 0.375) < 0.1), axis=0)  # the tool leaves out a pose
    left = np.linalg.norm(missed[None] - at[1][:, None], axis=2)
    assert left[np.arange(9), tool_paths.times_in_order(left)].max() > 0.3


def test_both_searches_come_nearer_to_the_continuum_on_finer_grids(panda):
    top = np.diag([1.0, -1.0, -1.0, 1.0])
    top[:3, 3] = (0.5, 0.0, 0.5)
    case = grid_steps.one_joint("Panda", panda, mp.CartesianPath.circle(top, (0.5, 0.0, 0.4), (1.0, 0.0, 0.0)))
    found = grid_steps.curve(replace(case, grids=((24,), (384,))), most=3000)
    coarse, fine = found.rows
    assert coarse.paper.minimum == pytest.approx(coarse.exact)
    assert fine.paper.end == "gave up"
    assert coarse.exact < fine.exact <= found.refined <= found.bound * (1 + 1e-6)
    assert coarse.step > fine.step
