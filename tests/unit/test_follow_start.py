"""follow with a start: the lead-in, the choice of the first configuration, and motions that begin on the path."""

import time

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.support.status import Failure
from manipplan.tool_path.engine import ToolPathPlanner
from manipplan.tool_path.entry import FirstConfigurations, choose_entry
from manipplan.tool_path.transit import Transit, TransitPlanner

FEW = {"samples": 48, "epsilon": 0.5}


def tool(robot, q):
    """Poses of the tool at q (k, n) by Pinocchio."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    poses = []
    for each in q:
        pin.framesForwardKinematics(robot.model, data, each)
        poses.append(data.oMf[frame].homogeneous.copy())
    return np.array(poses)


@pytest.fixture(scope="module")
def line(panda):
    begin = np.array(panda.kinematics().pose(panda.neutral))
    begin[:3, 3] += [0.05, -0.2, -0.1]
    end = begin.copy()
    end[:3, 3] += [0.05, 0.3, 0.05]
    return mp.CartesianPath.line(begin, end)


@pytest.fixture(scope="module")
def post(line):
    """A post between the arm's neutral posture and the beginning of the line."""
    return mp.Scene([mp.Box(size=(0.04, 0.04, 0.3), position=line(0.0)[:3, 3] + [-0.1, 0.12, 0.0], name="post")])


def assert_begins_and_follows(robot, plan, start, path, scene):
    """Judged by Pinocchio and coal alone."""
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    motion, begin = plan.trajectory, plan.path_begin
    np.testing.assert_array_equal(motion.q[0], start)
    np.testing.assert_allclose(motion(np.array([0.0, begin, motion.duration]), 1), 0.0, atol=1e-9)
    poses = tool(robot, motion(np.linspace(begin, motion.duration, 500)))
    way = (path(1.0) - path(0.0))[:3, 3]
    share = (poses[:, :3, 3] - path(0.0)[:3, 3]) @ way / (way @ way)
    assert np.linalg.norm(poses[:, :3, 3] - path(0.0)[:3, 3] - share[:, None] * way, axis=1).max() < 1e-4
    np.testing.assert_allclose(share[[0, -1]], [0.0, 1.0], atol=1e-4)
    assert np.diff(share).min() > -1e-4
    q = motion(np.linspace(0.0, motion.duration, 800))
    assert not scene.collision_model(robot).in_collision_rows(q).any()
    assert not (robot.limits.outside(q) > 1e-6).any()
    np.testing.assert_array_equal(plan.path(0.0), start)
    np.testing.assert_allclose(plan.path(1.0), motion.q[-1], atol=1e-9)


@pytest.fixture(scope="module")
def led_in(panda, line, post):
    return mp.follow(panda, line, post, start="default", positions=8, **FEW)


@pytest.mark.slow
def test_a_lead_in_goes_round_an_obstacle(panda, line, post, led_in):
    assert_begins_and_follows(panda, led_in, panda.states["default"], line, post)
    assert 0.1 < led_in.path_begin < led_in.trajectory.duration
    assert led_in.path_begin == led_in.report.along[0].begin
    assert led_in.report.along[0].tool_speed is None
    motion = led_in.trajectory
    along = panda.kinematics().manipulability(motion(np.linspace(led_in.path_begin, motion.duration, 2000)))
    assert led_in.report.along[0].min_manipulability == pytest.approx(along.min(), rel=1e-3)
    whole = panda.kinematics().manipulability(motion(np.linspace(0.0, motion.duration, 4000)))
    assert led_in.report.min_manipulability == pytest.approx(whole.min(), rel=1e-3)
    (chosen,) = [each for each in led_in.candidates if each.chosen]
    np.testing.assert_allclose(chosen.q, motion(led_in.path_begin), atol=1e-9)
    assert chosen.min_manipulability == pytest.approx(led_in.report.min_manipulability, rel=1e-3)
    assert f"lead-in      {led_in.path_begin:.3f} s" in str(led_in.report)


@pytest.mark.slow
def test_the_path_part_alone_is_judged_by_check(panda, line, post, led_in):
    judged = mp.check(panda, led_in.trajectory, post, path=line, path_begin=led_in.path_begin)
    assert judged.passed and judged.deviation.position < 1e-4 and judged.missed.position < 1e-4
    assert not mp.check(panda, led_in.trajectory, post, path=line).passed
    late = mp.check(panda, led_in.trajectory, post, path=line, path_begin=led_in.path_begin + 0.1)
    assert any("misses a pose" in fault for fault in late.faults)
    for begin, options in ((-1.0, {"path": line}), (1e3, {"path": line}), (0.5, {})):
        with pytest.raises(mp.errors.InvalidInputError, match="path_begin"):
            mp.check(panda, led_in.trajectory, post, path_begin=begin, **options)


@pytest.mark.slow
def test_a_plan_with_a_lead_in_is_saved_and_drawn(led_in, tmp_path):
    import matplotlib.pyplot as plt

    from manipplan import viz

    led_in.save(tmp_path)
    again = mp.Plan.load(tmp_path)
    assert again.path_begin == led_in.path_begin and str(again.report) == str(led_in.report)
    assert [each.status for each in again.candidates] == [each.status for each in led_in.candidates]
    ax = viz.plot_deviation(again)
    shown = ax.lines[0].get_xydata()
    assert shown[0, 0] == led_in.path_begin and shown[:, 1].max() < 0.1  # the lead-in is not on the path
    plt.close(ax.figure)


@pytest.mark.slow
def test_on_the_path_the_motion_begins_where_the_arm_stands(panda, line):
    """The best motion from there through the samples, or a better one that goes on from it by steps."""
    at = mp.inverse_kinematics(panda, line(0.0), samples=20).q
    m = panda.kinematics().manipulability(at)
    start = at[np.argsort(m)[len(m) // 2]]
    plan = mp.follow(panda, line, start=start, positions=6, **FEW)
    assert_begins_and_follows(panda, plan, start, line, mp.Scene())
    assert plan.path_begin == 0.0 and plan.candidates == ()
    assert plan.search.indices[0] == 0 and len(plan.search.q) == 6
    layers = mp.sample_layers(panda, line, 6, samples=48, clearance=0.003)
    best, last = np.array([panda.kinematics().manipulability(start)]), start[None]
    for q, values in zip(layers.q[1:], layers.m[1:], strict=True):
        near = (np.abs(q[:, None] - last) < FEW["epsilon"]).all(axis=2)
        best = np.minimum(values, np.where(near, best, -np.inf).max(axis=1))
        last = q
    assert plan.search.minimum >= best.max() * (1 - 1e-12)
    assert plan.refinement.refined >= plan.search.minimum


@pytest.mark.slow
def test_a_start_a_little_off_the_first_pose(panda, line):
    """Within the tolerance the path begins there; beyond it a lead-in closes the gap."""
    at = mp.follow(panda, line, positions=6, **FEW).trajectory.q[0]
    for off, leads in ((1e-5, False), (1e-3, True)):
        start = at + off
        plan = mp.follow(panda, line, start=start, positions=6, **FEW)
        assert_begins_and_follows(panda, plan, start, line, mp.Scene())
        assert (plan.path_begin > 0) is leads
    wide = mp.Tolerance(position=0.01, rotation=0.05)
    plan = mp.follow(panda, line, start=at + 1e-3, positions=6, tolerance=wide, **FEW)
    assert plan.path_begin == 0.0 and plan.report.passed


@pytest.mark.slow
def test_a_closed_path_returns_to_the_start(panda, line):
    pose = line(0.0)
    circle = mp.CartesianPath.circle(pose, pose[:3, 3] - [0, 0, 0.08], [1, 0, 0])
    at = mp.inverse_kinematics(panda, pose, samples=20).q
    start = at[panda.kinematics().manipulability(at).argmax()]
    plan = mp.follow(panda, circle, start=start, positions=10, closed=True, **FEW)
    assert plan.path_begin == 0.0
    np.testing.assert_allclose(plan.trajectory.q[[0, -1]], [start, start], atol=1e-6)
    led = mp.follow(panda, circle, start=panda.neutral, positions=10, closed=True, **FEW)
    np.testing.assert_allclose(led.trajectory(led.path_begin), led.trajectory.q[-1], atol=1e-6)


@pytest.mark.slow
def test_full_turns_are_kept():
    """Joints without limits turn less than once on the way to the path, however far from zero they are."""
    arm, at = mp.load_robot("kinova"), np.array([0.3, 3.6, 2.0, 1.0, 2.0, 0.8])
    begin = np.array(arm.kinematics().pose(at))
    end = begin.copy()
    end[:3, 3] += [0.05, 0.1, 0.05]
    start = at + [2 * np.pi, 0.2, -0.2, 4 * np.pi, 0.4, -6.3]
    plan = mp.follow(arm, mp.CartesianPath.line(begin, end), start=start, positions=8, epsilon=0.9)
    assert_begins_and_follows(arm, plan, start, plan.workspace_path, mp.Scene())
    assert plan.path_begin > 0
    assert (np.abs(plan.trajectory(plan.path_begin) - start)[arm.continuous_joints] < np.pi + 0.1).all()


# ---- the choice of the first configuration


@pytest.fixture(scope="module")
def searched(panda, line):
    layers = mp.sample_layers(panda, line, 5, samples=32)
    finder = ToolPathPlanner(path=line, layers=layers, tolerance=None)
    return finder, mp.max_min_search(layers, 0.6)


@pytest.mark.slow
def test_what_the_first_configurations_allow(searched):
    """The largest minimum of a path from each, by one pass backwards over all pairs; and the path itself."""
    finder, first = searched
    configurations = FirstConfigurations(planner=finder, best=first)
    best, last = finder.layers.m[-1], finder.layers.q[-1]
    for q, values in zip(finder.layers.q[-2::-1], finder.layers.m[-2::-1], strict=True):
        near = (np.abs(q[:, None] - last) < 0.6).all(axis=2)
        best = np.minimum(values, np.where(near, best, -np.inf).max(axis=1))
        last = q
    np.testing.assert_array_equal(configurations.minimum, best)
    assert best.max() == first.minimum
    for k in np.flatnonzero(np.isfinite(best))[::7]:
        motion = configurations.motion(int(k))
        assert motion.indices[0] == k and motion.minimum == best[k]
        q = np.array([each[i] for each, i in zip(finder.layers.q, motion.indices, strict=True)])
        np.testing.assert_array_equal(motion.q, q)
        assert (np.abs(np.diff(q, axis=0)) < 0.6).all()


class Lead:
    """A planner that only finds lead-ins of a given minimum manipulability, or none."""

    def __init__(self, robot, minima):
        self.robot, self.minima, self.goals = robot, minima, []

    def __call__(self, goal, seconds, notify):
        self.goals.append(goal)
        least = self.minima[len(self.goals) - 1] if len(self.goals) <= len(self.minima) else None
        if least is None:
            return Failure(message="a wall is in the way")
        made = mp.plan(self.robot, self.robot.neutral, self.robot.neutral + 0.1)
        return Transit(path=made.path, trajectory=made.trajectory, min_manipulability=least, g=made.report.g)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("minima", "chosen", "tried"),
    [
        ([1.0], 0, 1),  # the path itself is the narrowest place: nothing can be better
        ([None, 1.0], 1, 2),  # the next one, where there is no lead-in
        ([1e-4, 1.0], 1, 2),  # a poor lead-in: the next one is better
        ([1e-4, 1e-5, 1e-5, 1e-5, 1.0], 0, 4),  # at most four
        ([None] * 8, None, 8),
    ],
)
def test_the_best_entry_is_chosen(panda, searched, minima, chosen, tried):
    finder, first = searched
    planner = Lead(panda, minima)
    # the start allows more than any path, so that it does not bound the minimum
    start = panda.neutral
    integral = mp.PathObjective().integral(panda)
    choice = choose_entry(finder, first, start, integral, planner, 10.0, lambda share, text: None)
    assert len(planner.goals) == tried
    marks = [each.chosen for each in choice.candidates]
    if chosen is None:
        assert choice.entry is None and not any(marks)
        assert "any of the 8 first configurations" in choice.failure and "a wall is in the way" in choice.failure
        return
    assert marks.index(True) == chosen and sum(marks) == 1
    np.testing.assert_array_equal(choice.candidates[chosen].q, planner.goals[chosen])
    np.testing.assert_array_equal(choice.entry.refined.path.start, planner.goals[chosen])
    assert choice.candidates[chosen].status.startswith("chosen, planned: minimum manipulability")


@pytest.mark.slow
def test_no_lead_in_is_told(panda, line, monkeypatch):
    monkeypatch.setattr(TransitPlanner, "lead_in", lambda *_: Lead(panda, []))
    plan = mp.follow(panda, line, start=panda.neutral, positions=5, throw=False, **FEW)
    assert plan.status is mp.Status.NO_PATH and "a wall is in the way" in plan.message
    assert plan.search is not None and plan.trajectory is None and len(plan.candidates) > 0


# ---- what is refused


@pytest.mark.parametrize(
    ("start", "error", "message"),
    [
        ("raedy", mp.errors.UnknownNameError, "start"),
        ([0.0] * 6, mp.errors.InvalidInputError, "start: .*7"),
        ([0.0] * 7, mp.errors.InvalidInputError, r"start\[3\] \(panda_joint4\)"),
        (np.full(7, np.nan), mp.errors.InvalidInputError, "start"),
        (True, mp.errors.InvalidInputError, "start"),
    ],
)
def test_wrong_starts_are_refused_before_the_work(panda, line, start, error, message):
    told = []
    with pytest.raises(error, match=message):
        mp.follow(panda, line, start=start, positions=3, progress=lambda *each: told.append(each), **FEW)
    assert told == []


def test_a_start_in_collision_names_the_bodies(panda, line):
    scene = mp.Scene([mp.Sphere(radius=0.05, position=panda.kinematics().pose(panda.neutral)[:3, 3], name="ball")])
    with pytest.raises(mp.errors.InvalidInputError, match=r"start: .* and ball overlap by"):
        mp.follow(panda, line, scene, start=panda.neutral, positions=3, **FEW)


@pytest.mark.slow
def test_bodies_in_the_way_are_named(panda, line):
    """A pole that no posture passes from one position to the next."""
    scene = mp.Scene([mp.Box(size=(0.02, 0.02, 0.9), position=(0.29, 0.0, 0.45), name="pole")])
    free = mp.follow(panda, line, positions=6, throw=False, **FEW)
    assert free.status is mp.Status.FOLLOWED
    plan = mp.follow(panda, line, scene, positions=6, clearance=0.003, throw=False, **FEW)
    assert plan.status is mp.Status.NOT_CONNECTED
    assert "without bodies in the way there is a motion, on which" in plan.message and "pole overlap by" in plan.message


@pytest.mark.parametrize(
    "seeding", [mp.Seeding(shifts="nearest"), mp.Seeding(initial=mp.JointPath.line([0.0] * 3, [1.0] * 3)), 3]
)
def test_a_seeding_that_says_nothing_of_a_path_is_refused(planar, seeding):
    path = mp.CartesianPath.line(*planar.kinematics(mp.Task.planar()).pose(np.array([[0.3, 0.8, 0.6], [0.4, 0.9, 0.5]])))
    with pytest.raises(mp.errors.InvalidInputError, match="seeding"):
        mp.follow(planar, path, seeding=seeding)


@pytest.mark.slow
def test_lead_ins_keep_the_time_limit(planar):
    """All lead-ins together take the time limit: a planner that finds nothing and takes all the time it gets."""
    wall = mp.Scene([mp.Box(size=[0.2, 0.2, 0.2], position=[0.92, 2.53, 0.0], name="wall")])
    path = mp.CartesianPath.line(*planar.kinematics(mp.Task.planar()).pose(np.array([[0.3, 0.8, 0.6], [0.4, 0.9, 0.5]])))
    calls = []

    def planner(problem):
        calls.append(problem.time_left)
        time.sleep(problem.time_left)

    options = {"positions": 8, "epsilon": 0.5, "throw": False}
    began = time.monotonic()
    free = mp.follow(planar, path, wall, start=[1.5, 0.2, 0.1], **options)
    work = time.monotonic() - began
    assert free.status is mp.Status.FOLLOWED
    began = time.monotonic()
    seeding = mp.Seeding(planner=planner, time_limit=1.0)
    made = mp.follow(planar, path, wall, start=[1.5, 0.2, 0.1], seeding=seeding, **options)
    assert calls and made.status is mp.Status.NO_PATH
    assert time.monotonic() - began < work + 2.0


def test_where_no_motion_leads_on_from_the_first_pose_the_path_begins_in_another_configuration():
    """The arm stands at the first pose, and a joint at the limit that the path leads beyond."""
    robot = mp.load_robot("ur5_limited")
    start = np.array([0.3, -1.2, 1.4, -1.7, -1.5, robot.limits.upper[5]])
    begin = tool(robot, [start])[0]
    turn = np.array([[np.cos(1), -np.sin(1), 0, 0], [np.sin(1), np.cos(1), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    path = mp.CartesianPath.line(begin, begin @ turn)
    plan = mp.follow(robot, path, start=start)
    motion = plan.trajectory
    assert plan.report.passed and plan.path_begin > 0
    np.testing.assert_array_equal(motion.q[0], start)
    poses = tool(robot, motion(np.linspace(plan.path_begin, motion.duration, 200)))
    np.testing.assert_allclose(poses[[0, -1]], [begin, begin @ turn], atol=1e-4)
    np.testing.assert_allclose(poses[:, :3, 3], np.tile(begin[:3, 3], (200, 1)), atol=1e-4)
    turned = mp.follow(robot, mp.CartesianPath.line(begin, begin @ turn.T), start=start)
    assert turned.path_begin == 0.0


def test_a_start_from_which_no_motion_follows_the_path_is_told():
    """The path begins within reach of one posture of the elbow, and ends within that of the other."""
    robot = mp.planar_arm([1.0, 1.0]).with_limits(lower=[0.0, -3.0], upper=[2.0, 3.0])
    angles = np.linspace(0.5, 1.5, 21)
    poses = np.tile(np.eye(4), (21, 1, 1))
    poses[:, :2, 3] = 1.5 * np.column_stack([np.cos(angles), np.sin(angles)])
    path = mp.CartesianPath.through(poses)
    start = mp.inverse_kinematics(robot, path(0.0)).q[0]
    with pytest.raises(mp.errors.PlanningError, match="from the start, which is at the first pose.* upper limit of joint1"):
        mp.follow(robot, path, start=start)
