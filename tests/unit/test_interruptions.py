"""follow with interruptions, judged by Pinocchio alone: a circle about the Panda's base is longer than its first joint's range."""

from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest
from matplotlib.figure import Figure

import manipplan as mp
from manipplan.paths.deviation import deviation_from
from manipplan.plans.report import PathPart
from manipplan.search.layers import choose_positions
from manipplan.viz.figure import draw_figure

#: Retreat of the tool [m].
AWAY = 0.04


@pytest.fixture(scope="module")
def circle():
    start = np.diag([1.0, -1.0, -1.0, 1.0])
    start[:3, 3] = 0.5, 0.0, 0.3
    return mp.CartesianPath.circle(start, (0, 0, 0.3), (0, 0, 1), turning=True)


@pytest.fixture(scope="module")
def table():
    sides = {"left table": 0.6, "right table": -0.6}
    return mp.Scene([mp.Box(size=(2, 0.7, 0.04), position=(0, y, 0.2), name=name) for name, y in sides.items()])


@pytest.fixture(scope="module")
def plan(panda, circle, table):
    return mp.follow(panda, circle, table, interruptions=1, retreat=AWAY, start="default")


def tool(robot, plan, begin, end, count=400):
    """Times, and tool poses by Pinocchio."""
    t = np.linspace(begin, end, count)
    data, frame, poses = robot.model.createData(), robot.model.getFrameId(robot.tool), []
    for q in plan.trajectory(t):
        pin.framesForwardKinematics(robot.model, data, q)
        poses.append(data.oMf[frame].homogeneous.copy())
    return t, np.array(poses)


@pytest.mark.slow
def test_the_message_tells_how_many_interruptions_are_needed(panda, circle):
    found = mp.follow(panda, circle, positions=60, throw=False)
    assert found.status is mp.Status.NOT_CONNECTED and found.trajectory is None
    assert "with 1 interruption there is a motion: interruptions=1 allows it" in found.message
    with pytest.raises(mp.errors.PlanningError, match="1 interruption"):
        mp.follow(panda, circle, positions=60)


@pytest.mark.slow
def test_parts_of_the_path_are_followed_and_cover_it(panda, circle, table, plan):
    assert plan.status is mp.Status.FOLLOWED_IN_PARTS and plan.status.ok and plan.report.passed
    first, second = plan.report.along
    assert (first.s_begin, second.s_end) == (0.0, 1.0) and first.s_end == second.s_begin
    assert plan.path_begin == first.begin > 0.1  # the lead-in
    assert plan.off_path == ((0.0, first.begin), (first.end, second.begin))
    model = table.collision_model(panda)
    t = np.linspace(0, plan.trajectory.duration, 2000)
    q, qd = plan.trajectory(t), plan.trajectory(t, 1)
    assert not model.in_collision_rows(q).any() and not (panda.limits.outside(q) > 1e-6).any()
    assert (np.abs(qd) <= panda.limits.velocity * (1 + 1e-6)).all()
    for part in plan.report.along:
        _, poses = tool(panda, plan, part.begin, part.end)
        off = deviation_from(circle.part(part.s_begin, part.s_end), poses)
        assert off.position < 1e-4 and off.rotation < 1e-3
        ends = circle([part.s_begin, part.s_end])
        np.testing.assert_allclose(poses[[0, -1]], ends, atol=1e-4)
        least = float(panda.kinematics().manipulability(plan.trajectory(np.linspace(part.begin, part.end, 2000))).min())
        assert part.min_manipulability == pytest.approx(least, rel=1e-3)


@pytest.mark.slow
def test_the_tool_leaves_the_path_and_comes_back_straight(panda, plan):
    begin, end = plan.off_path[1]
    _, poses = tool(panda, plan, begin, end)
    np.testing.assert_allclose(poses[0], poses[-1], atol=2e-4)
    assert np.abs(plan.trajectory(begin) - plan.trajectory(end)).max() > 1.0  # in another configuration
    inside = np.linalg.inv(poses[0]) @ poses  # in the frame of the tool where it left
    away = np.linalg.norm(inside[:, :3, 3], axis=1)
    for way in (inside[: int(away.argmax())], inside[::-1][: int(away[::-1].argmax())]):
        near = way[np.linalg.norm(way[:, :3, 3], axis=1) < 0.9 * AWAY]
        assert len(near) > 5
        assert (np.abs(near[:, :2, 3]) < 2e-4).all() and (near[:, 2, 3] < 2e-4).all()  # against its z-axis


@pytest.mark.slow
def test_check_judges_the_parts(panda, circle, table, plan, tmp_path):
    judged = mp.check(panda, plan.trajectory, table, path=circle, path_parts=plan.report.along)
    assert judged.passed and judged.missed.position < 1e-4
    whole = mp.check(panda, plan.trajectory, table, path=circle, path_begin=plan.path_begin)
    assert not whole.passed and whole.deviation.position > 0.5 * AWAY
    plan.save(tmp_path)
    again = mp.Plan.load(tmp_path)
    assert again.report.along == plan.report.along and again.off_path == plan.off_path
    assert "parts        2" in str(again.report) and "lead-in" in str(again.report)
    assert isinstance(draw_figure(plan), Figure)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda along: [*along, along[0]], "increasing times"),
        (lambda along: along[:1], "all together one path"),
        (lambda along: along[::-1], "increasing times"),
        (lambda _: [1.0], "a list of PathPart"),
        (lambda along: [replace(along[0], begin="0"), *along[1:]], r"path_parts\[0\].begin: got '0'; allowed: a finite number"),
        (lambda along: [*along[:-1], replace(along[-1], end=np.nan)], r"path_parts\[1\].end: got nan"),
        (
            lambda along: [replace(along[0], s_begin=-0.1), *along[1:]],
            r"path_parts\[0\].s_begin: got -0.1; allowed: .*at least 0",
        ),
        (lambda along: [replace(along[0], s_end=None), *along[1:]], r"path_parts\[0\].s_end: got None"),
        (lambda along: [replace(along[0], begin=-1.0), *along[1:]], r"path_parts\[0\].begin: got -1.0"),
        (lambda along: [replace(along[0], s_end=0.0), replace(along[1], s_begin=0.0)], "all together one path"),
        (
            lambda along: [replace(each, s_begin=each.s_begin + 1, s_end=each.s_end + 1) for each in along],
            "all together one path",
        ),
    ],
)
def test_parts_that_do_not_fit_are_refused(panda, circle, plan, change, match):
    with pytest.raises(mp.errors.InvalidInputError, match=match):
        mp.check(panda, plan.trajectory, path=circle, path_parts=change(list(plan.report.along)))


@pytest.mark.slow
def test_parts_beyond_the_end_need_a_closed_path(panda, plan):
    away = np.eye(4)
    away[0, 3] = 0.1
    line = mp.CartesianPath.line(np.eye(4), away)
    parts = [PathPart(begin=0.0, end=plan.trajectory.duration, s_begin=0.5, s_end=1.5)]
    with pytest.raises(mp.errors.InvalidInputError, match="from 0 to 1, as the path's last pose is not its first"):
        mp.check(panda, plan.trajectory, path=line, path_parts=parts)


@pytest.mark.slow
def test_parts_need_a_path_and_no_other_begin(panda, circle, plan):
    along = plan.report.along
    with pytest.raises(mp.errors.InvalidInputError, match="path_parts"):
        mp.check(panda, plan.trajectory, path_parts=along)
    with pytest.raises(mp.errors.InvalidInputError, match="path_begin"):
        mp.check(panda, plan.trajectory, path=circle, path_parts=along, path_begin=0.5)


@pytest.mark.slow
def test_a_retreat_that_is_not_free_names_the_bodies(panda, circle, table):
    table = table + mp.Scene([mp.Box(size=(0.6, 0.4, 0.04), position=(-0.55, 0, 0.2), name="back table")])
    found = mp.follow(panda, circle, table, positions=60, interruptions=1, retreat=[0.0, 0.0, 0.3], throw=False)
    assert found.status is mp.Status.NO_PATH
    assert "no straight retreat from the path" in found.message and "table" in found.message
    assert "4 other places do not help either" in found.message


@pytest.mark.slow
def test_the_tool_leaves_the_path_where_the_retreat_is_free(panda, circle):
    free = mp.follow(panda, circle, positions=60, interruptions=1, retreat=[0.06, 0.0, 0.0])
    at = free.report.along[0].s_end
    post = mp.Box(size=(0.03, 0.03, 0.3), position=circle(at)[:3, 3] + 0.1 * circle(at)[:3, 0] + [0, 0, 0.05], name="post")
    shares = []
    plan = mp.follow(
        panda,
        circle,
        mp.Scene([post]),
        positions=60,
        interruptions=1,
        retreat=[0.06, 0.0, 0.0],
        progress=lambda share, _: shares.append(share),
    )
    assert shares == sorted(shares) and shares[-1] == 1.0
    assert plan.report.passed and len(plan.report.along) == 2
    assert abs(plan.report.along[0].s_end - at) > 0.02
    assert plan.refinement.refined == pytest.approx(free.refinement.refined, rel=1e-3)


@pytest.mark.parametrize(
    "options",
    [
        {"interruptions": -1},
        {"interruptions": 1.5},
        {"interruptions": True},
        {"retreat": -0.1},
        {"retreat": [0.0, 0.1]},
        {"retreat": np.nan},
        {"retreat": 1e-12},
        {"positions": 1},
        {"positions": [0.0, 0.5]},
        {"positions": [0.0, 0.6, 0.4, 1.0]},
        {"positions": "many"},
    ],
)
def test_bad_input_is_named(panda, circle, options):
    with pytest.raises(mp.errors.InvalidInputError, match=next(iter(options))):
        mp.follow(panda, circle, **options)


@pytest.mark.slow
def test_a_closed_path_begins_where_that_takes_the_fewest_interruptions(panda, circle):
    plan = mp.follow(panda, circle, closed=True, interruptions=1, retreat=0.0)
    assert plan.status is mp.Status.FOLLOWED_IN_PARTS
    (around,) = plan.report.along
    assert 0.0 < around.s_begin < 1.0 and around.s_end == pytest.approx(around.s_begin + 1.0)
    np.testing.assert_allclose(plan.trajectory.q[0], plan.trajectory.q[-1], atol=1e-9)
    assert plan.off_path == ((around.end, plan.trajectory.duration),)
    _, poses = tool(panda, plan, around.begin, around.end)
    assert deviation_from(circle, poses).position < 1e-4
    assert mp.check(panda, plan.trajectory, path=circle, path_parts=plan.report.along).passed


@pytest.mark.slow
def test_a_closed_path_with_a_free_axis_that_no_motion_follows_is_told_within_seconds(panda, circle):
    objective = mp.PathObjective(task=mp.Task.pointing())
    found = mp.follow(panda, circle, closed=True, positions=60, objective=objective, throw=False)
    assert "with 1 interruption there is a motion" in found.message and found.search.smallest_epsilon is None


def test_the_retreat_of_a_planar_arm_stays_in_its_plane():
    arm = mp.planar_arm([0.4, 0.4, 0.3])
    line = mp.CartesianPath.through(arm.kinematics(mp.Task.pose()).pose(np.array([[0.3, 0.8, 0.5], [0.4, 0.9, 0.5]])))
    with pytest.raises(mp.errors.InvalidInputError, match="retreat.*plane"):
        mp.follow(arm, line, positions=5, samples=20, interruptions=1)


@pytest.mark.slow
def test_each_part_has_its_tool_speed(panda, circle):
    plan = mp.follow(panda, circle, interruptions=1, retreat=0.0, tool_speed=0.1)
    assert len(plan.report.along) == 2
    for part in plan.report.along:
        assert part.tool_speed.is_steady and part.begin < part.tool_speed.begin < part.tool_speed.end < part.end
        t, poses = tool(panda, plan, part.tool_speed.begin, part.tool_speed.end, 200)
        speeds = np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1) / np.diff(t)
        assert (np.abs(speeds - 0.1) < 0.0015).all()


def test_positions_are_at_poses_and_corners_of_the_path():
    corner = [[0.5, 0.0, 0.3], [0.5, 0.004, 0.3], [0.5, 0.1, 0.3], [0.4, 0.1, 0.3], [0.399, 0.1, 0.3], [0.3, 0.1, 0.3]]
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (6, 1, 1))
    poses[:, :3, 3] = corner
    path = mp.CartesianPath.through(poses)
    s = choose_positions(path)
    assert s[0] == 0.0 and s[-1] == 1.0 and (np.diff(s) > 0).all() and len(s) >= 40
    assert path.knots[2] in s  # the corner
    np.testing.assert_allclose(path(path.knots)[:, :3, 3], corner, atol=1e-12)
    steps = np.linalg.norm(np.diff(path(np.linspace(0, 1, 4001))[:, :3, 3], axis=0), axis=1)
    way = np.interp(s, np.linspace(0, 1, 4001), np.append(0, np.cumsum(steps)))
    assert np.diff(way).max() < 0.0305
    assert len(choose_positions(path, closed=True)) == len(s) - 1


def test_parts_of_a_path(circle):
    whole = circle.part(0.25, 1.25)
    np.testing.assert_allclose(whole([0.0, 0.5, 1.0]), circle([0.25, 0.75, 0.25]), atol=1e-12)
    poses = circle.sample(9)
    spline = mp.CartesianPath.through(poses[:-1])
    part = spline.part(spline.knots[1], spline.knots[4])
    np.testing.assert_allclose(part(part.knots), poses[1:5], atol=1e-12)
    for begin, end in ((-0.1, 0.5), (0.5, 0.5), (0.5, 1.6)):
        with pytest.raises(mp.errors.InvalidInputError):
            circle.part(begin, end)
    with pytest.raises(mp.errors.InvalidInputError, match="end.*last pose is not its first"):
        spline.part(0.5, 1.2)


@pytest.mark.slow
def test_a_plan_along_a_part_of_a_path_is_saved_with_it(panda, circle, tmp_path):
    plan = mp.follow(panda, circle.part(0.1, 0.2), positions=8)
    plan.save(tmp_path / "saved")
    loaded = mp.Plan.load(tmp_path / "saved").workspace_path
    np.testing.assert_array_equal(loaded.sample(9), plan.workspace_path.sample(9))
