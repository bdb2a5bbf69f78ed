"""Constraints on free motion: rows and derivatives, proofs, plans that keep them, bad input."""

import pickle
from dataclasses import replace

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.constraints.constraint import constraints_from_yaml
from manipplan.constraints.constraint_set import TOLERANCE, ConstraintSet, prove, tool_frame
from manipplan.kinematics.batch import BatchKernel
from manipplan.seeds.connect import _of_own
from manipplan.symbolic.backends import chain_of

DOWN = (0.0, 0.0, -1.0)


class Cylinder(mp.Constraint):
    """The tool stays in a cylinder around the z-axis; a row without a proof."""

    name = "inside a cylinder"

    def __init__(self, radius):
        self.radius = radius

    def rows(self, at):
        return self.radius**2 - at.position[0] ** 2 - at.position[1] ** 2


def tilt_of(robot, q, axis=(0.0, 0.0, 1.0), direction=DOWN):
    """The angle between a tool axis and a direction at each q (m, n), by Pinocchio."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    found = []
    for each in q:
        pin.forwardKinematics(robot.model, data, each)
        turned = pin.updateFramePlacement(robot.model, data, frame).rotation @ np.array(axis)
        found.append(np.arctan2(np.linalg.norm(np.cross(turned, direction)), turned @ np.array(direction)))
    return np.array(found)


@pytest.fixture(scope="module")
def level(panda):
    """Two configurations of the Panda whose hand points down, and the limit of 5° that both keep."""
    kinematics = panda.kinematics()
    pose = kinematics.pose(panda.neutral)
    goal = pose.copy()
    goal[:3, 3] = [0.25, 0.45, 0.35]
    q = mp.inverse_kinematics(panda, goal).q
    free = q[~mp.Scene().collision_model(panda).in_collision_rows(q)]
    q_goal = free[np.linalg.norm(free - panda.neutral, axis=1).argmin()]
    return panda.neutral, q_goal, mp.TiltLimit((0, 0, 1), DOWN, np.deg2rad(5.0))


@pytest.fixture(scope="module")
def lift():
    """An arm with a prismatic joint."""
    return mp.load_robot("tiago")


@pytest.mark.parametrize("arm", ["panda", "ur5", "lift"])
def test_rows_and_derivatives_are_those_of_their_expressions(request, arm):
    robot = request.getfixturevalue(arm)
    pose = np.array(pin.SE3(pin.rpy.rpyToMatrix(0.3, -0.2, 0.8), np.array([0.1, 0.2, 0.3])).homogeneous)
    given = [
        mp.TiltLimit((1, 2, -1), (0.2, -0.3, 1), 0.4),
        mp.PositionBox((-1, -np.inf, 0), (1, 2, 3), pose),
        Cylinder(0.7),
        mp.TiltLimit((0, 0, 1), DOWN, 2.5),
    ]
    kept, chain = ConstraintSet.of(robot, given), chain_of(robot, "auto")
    at = mp.SymbolicPose(q=chain.q, position=chain.tool.origin, rotation=chain.tool.rotation)
    q = robot.random_configuration(np.random.default_rng(1), size=4)
    values, gradients = kept.values(q), kept.gradients(q)
    assert values.shape == (4, kept.count)
    for k, each in enumerate(given):
        rows = np.flatnonzero(kept.owners == k)
        made = each.rows(at)
        parts = ca.Function("f", [chain.q], [made, ca.jacobian(made, chain.q)])
        for i, here in enumerate(q):
            value, jacobian = (np.array(part) for part in parts(here))
            np.testing.assert_allclose(values[i, rows], value.ravel(), atol=1e-12)
            np.testing.assert_allclose(gradients[i, rows], jacobian, atol=1e-12)
            for row, expression in zip(rows, ca.vertsplit(made), strict=True):
                hessian = ca.Function("h", [chain.q], [ca.hessian(expression, chain.q)[0]])(here)
                np.testing.assert_allclose(kept.hessians(q[i : i + 1], np.array([row]))[0], np.array(hessian), atol=1e-10)


@pytest.mark.compiler
def test_rows_by_machine_code_are_the_same(panda):
    kept, frame = ConstraintSet.of(panda, [mp.TiltLimit((0, 0, 1), DOWN, 0.4)]), tool_frame(panda, panda.tool)
    fast = replace(kept, tool=replace(frame, kernel=BatchKernel(frame.function, True, "a test")))
    q = panda.random_configuration(np.random.default_rng(1), size=70)
    np.testing.assert_array_equal(fast.values(q), kept.values(q))
    np.testing.assert_array_equal(fast.gradients(q), kept.gradients(q))


@pytest.mark.parametrize("arm", ["panda", "lift"])
def test_bounds_on_the_tools_acceleration_hold(request, arm):
    """Second differences along random straight and bent motions stay below the bounds, and come within a factor of ten."""
    robot, rng = request.getfixturevalue(arm), np.random.default_rng(0)
    frame, shares = tool_frame(robot, robot.tool), []
    for _ in range(300):
        q, v, a = robot.random_configuration(rng), rng.normal(size=robot.n), rng.normal(size=robot.n)
        t = 1e-4 * np.array([-1.0, 0.0, 1.0])[:, None]
        pose, _ = frame.at(q + t * v + t**2 / 2 * a)
        second = (pose[0] - 2 * pose[1] + pose[2]) / 1e-8
        unit, position = frame.bend(*(np.abs(each)[None] for each in (q, v, a)))
        size = np.linalg.norm(second.reshape(4, 3), axis=1)
        assert size[0] <= position[0] + 1e-5
        assert size[1:].max() <= unit[0] + 1e-5
        shares.append(max(size[0] / position[0], size[1:].max() / unit[0]))
    assert max(shares) > 0.1


@pytest.mark.slow
def test_proofs_agree_with_dense_samples(panda):
    """Of random paths, each with a limit just above or below its largest tilt: a proof never contradicts 20,000 samples."""
    rng, proven = np.random.default_rng(2), 0
    for k in range(60):
        path = mp.JointPath(breaks=np.array([0.0, 1.0]), control=panda.random_configuration(rng, size=5)[None])
        most = tilt_of(panda, path(np.linspace(0.0, 1.0, 4001))).max()
        limit = mp.TiltLimit((0, 0, 1), DOWN, min(most + (1e-4 if k % 2 else -1e-4), 3.1))
        found = prove(ConstraintSet.of(panda, [limit]), path)
        assert found.kept == (limit.angle > most)
        assert found.proven == (found.kept,)
        proven += found.kept
        if not found.kept:
            assert tilt_of(panda, path(np.array([found.failed_at])))[0] > limit.angle
    assert proven == 30


def test_boxes_and_held_joints_are_proven(panda):
    line = mp.JointPath.line(panda.neutral, panda.neutral + [0.4, 0.1, 0, 0, 0, 0.1, 0])
    x = panda.kinematics().pose(line(np.linspace(0, 1, 2001)))[:, 0, 3]
    for change, kept in ((1e-5, True), (-1e-5, False)):
        box = mp.PositionBox((-np.inf,) * 3, (x.max() + change, np.inf, np.inf))
        assert prove(ConstraintSet.of(panda, [box]), line).kept is kept
    assert prove(ConstraintSet.of(panda, [mp.HeldJoints(["panda_joint3", "panda_joint5"])]), line).kept
    moved = prove(ConstraintSet.of(panda, [mp.HeldJoints("panda_joint2")]), line)
    assert not moved.kept
    assert moved.least[0] == pytest.approx(-0.1)


@pytest.mark.slow
def test_a_level_cup(panda, level):
    start, goal, limit = level
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.5), position=(0.4, 0.25, 0.25), name="post")])
    free = mp.plan(panda, start, goal, scene)
    plan = mp.plan(panda, start, goal, scene, constraints=[limit])
    for made, most in ((free, 1.0), (plan, limit.angle + 1e-6)):
        path = made.trajectory.path()
        tilt = tilt_of(panda, path(path.fine_samples(1e-3))).max()
        assert tilt <= most
        assert made is plan or tilt > limit.angle + 0.05
    assert plan.report.passed
    (figure,) = plan.report.constraints
    assert figure.proven
    assert figure.least >= 0
    assert "allowed 5°" in str(plan.report)
    assert plan.result.certificate.constraints[0].proven
    assert plan.status.ok


@pytest.mark.slow
def test_constraints_that_nothing_meets_change_nothing(panda, level):
    start, goal, _ = level
    wide = [mp.TiltLimit((0, 0, 1), DOWN, 3.0), mp.PositionBox((-5, -5, -5), (5, 5, 5))]
    usual, kept = (mp.optimize_path(panda, start, goal, mp.Scene(), constraints=each) for each in ((), wide))
    assert kept.status is usual.status is mp.Status.OPTIMAL
    assert kept.g == pytest.approx(usual.g, rel=1e-7)


@pytest.mark.slow
def test_an_optimum_at_its_limit_is_one(panda, level):
    """No small change of the optimum's coefficients that keeps the limit lowers g by more than the margin of its rows is worth."""
    start, goal, _ = level
    limit = mp.TiltLimit((0, 0, 1), DOWN, np.deg2rad(1.0))
    found = mp.optimize_path(panda, start, goal, mp.Scene(), constraints=[limit])
    assert found.status is mp.Status.OPTIMAL
    assert found.certificate.constraints[0].least < 1e-3  # the limit is active
    kept, rng, lower = ConstraintSet.of(panda, [limit]), np.random.default_rng(0), 0
    for size in (1e-2, 1e-3, 1e-4):
        for _ in range(100):
            control = found.path.control.copy()
            control[0, 1:-1] += size * rng.normal(size=control[0, 1:-1].shape)
            other = mp.JointPath(breaks=found.path.breaks, control=control)
            if prove(kept, other).kept:
                lower += mp.PathObjective().integral(panda).cost(other).g < found.g * (1 - 1e-5)
    assert lower == 0


def test_a_search_goes_around_inside_the_limit(panda, level):
    """A wall between start and goal: the straight way and the free one break the limit, the seed does not."""
    start, goal, limit = level
    scene = mp.Scene([mp.Box(size=(0.5, 0.02, 0.6), position=(0.5, 0.22, 0.3), name="wall")])
    path = mp.seed_path(panda, start, goal, scene, constraints=[limit])
    assert scene.path_clearance(panda, path).proven
    assert tilt_of(panda, path(path.fine_samples(1e-3))).max() <= limit.angle + TOLERANCE


def test_the_search_is_given_a_users_rows_and_their_gradients(panda, level):
    kept = ConstraintSet.of(panda, [Cylinder(1.0)])
    q = np.array(level[:2])
    found = _of_own(kept.own)(q)
    np.testing.assert_allclose(found[:, : kept.own.count], kept.values(q))
    np.testing.assert_allclose(found[:, kept.own.count :], kept.gradients(q).reshape(2, -1))


@pytest.mark.slow
def test_held_joints_do_not_move(panda):
    goal = panda.neutral + [0.5, 0.3, 0.0, 0.4, 0.0, 0.2, 0.3]
    constraints = [mp.HeldJoints(["panda_joint3", "panda_joint5"])]
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.4), position=(0.45, 0.2, 0.2), name="post")])
    plan = mp.plan(panda, panda.neutral, goal, scene, constraints=constraints)
    assert np.abs(plan.trajectory.q[:, [2, 4]] - panda.neutral[[2, 4]]).max() <= 1e-9
    assert plan.status is mp.Status.OPTIMAL
    assert plan.report.constraints[0].proven
    pose = panda.kinematics().pose(goal)
    reached = mp.plan(panda, panda.neutral, pose, scene, constraints=constraints)
    assert np.abs(reached.trajectory.q[:, [2, 4]] - panda.neutral[[2, 4]]).max() <= 1e-9
    np.testing.assert_allclose(panda.kinematics().pose(reached.trajectory.q[-1]), pose, atol=1e-6)


def test_a_box_and_rows_of_a_users_class(panda, level):
    start, goal, _ = level
    pose = panda.kinematics().pose(np.array([start, goal]))
    top = pose[:, 2, 3].max() + 0.01
    constraints = (mp.PositionBox((-1, -1, 0), (1, 1, top)), Cylinder(0.53))
    plan = mp.plan(panda, start, goal, constraints=constraints)
    path = plan.trajectory.path()
    position = panda.kinematics().pose(path(path.fine_samples(1e-3)))[:, :3, 3]
    assert position[:, 2].max() <= top + 1e-6
    assert (position[:, :2] ** 2).sum(axis=1).max() <= 0.53**2 + 1e-6
    assert [each.proven for each in plan.report.constraints] == [True, False]


def test_of_several_candidates_those_that_keep_the_limit(panda, level):
    start, goal, limit = level
    kinematics = panda.kinematics()
    tilted = kinematics.pose(goal).copy()
    tilted[:3, :3] = tilted[:3, :3] @ pin.rpy.rpyToMatrix(0.6, 0.0, 0.0)
    plan = mp.plan(panda, start, [tilted, kinematics.pose(goal)], constraints=[limit])
    assert plan.goal_index == 1
    reasons = {each.status for each in plan.candidates if each.goal_index == 0 and not np.isnan(each.q).any()}
    assert any("breaks tilt of tool axis" in each and "34.3" in each for each in reasons)
    with pytest.raises(mp.errors.InvalidInputError, match=r"within the constraints.*breaks tilt of tool axis"):
        mp.plan(panda, start, tilted, constraints=[limit])


def test_check_judges_constraints(panda, level):
    start, goal, limit = level
    plan = mp.plan(panda, start, goal, constraints=[limit])
    narrow = mp.TiltLimit((0, 0, 1), DOWN, np.deg2rad(1.0))
    assert mp.check(panda, plan.trajectory, constraints=[limit]).passed
    report = mp.check(panda, plan.trajectory, constraints=[narrow, mp.HeldJoints("panda_joint1")])
    assert [each.partition(":")[0] for each in report.faults] == ["constraint", "constraint"]
    assert "allowed 1°" in report.faults[0]
    assert "moved by" in report.faults[1]


@pytest.mark.slow
def test_saved_and_sent_to_other_processes(panda, level, tmp_path, caplog):
    start, goal, limit = level
    constraints = (limit, mp.PositionBox((-1, -1, -np.inf), (1, 1, np.inf)), mp.HeldJoints("panda_joint5"), Cylinder(2.0))
    held = np.where(np.arange(7) == 4, start, start + 0.02)
    plan = mp.plan(panda, start, held, constraints=constraints)
    plan.save(tmp_path)
    again = mp.Plan.load(tmp_path)
    assert again.constraints == constraints[:3]
    assert "Cylinder" in caplog.text
    assert again.report == plan.report
    copied = pickle.loads(pickle.dumps(ConstraintSet.of(panda, constraints)))
    np.testing.assert_array_equal(copied.values(start[None]), ConstraintSet.of(panda, constraints).values(start[None]))
    problems = [mp.Problem(robot=panda, start=start, goal=goal, constraints=[limit], name=str(k)) for k in range(2)]
    for made in mp.plan_many(problems, 2):
        assert made.report.constraints[0].proven


BAD = {
    "one without a list": (lambda arm, limit: limit, "constraints: got TiltLimit"),
    "a text": (lambda arm, limit: [limit, "level"], r"constraints\[1\]: got 'level'"),
    "unknown joint": (lambda arm, limit: [mp.HeldJoints("panda_joint33")], "did you mean panda_joint3"),
    "all held": (lambda arm, limit: [mp.HeldJoints(arm.joint_names)], "all is still"),
    "all held by two": (
        lambda arm, limit: [mp.HeldJoints(arm.joint_names[:4]), mp.HeldJoints(arm.joint_names[4:])],
        "leave a joint to move",
    ),
    "contradiction": (
        lambda arm, limit: [limit, mp.TiltLimit((0, 0, 1), (0, 0, 1), 0.2)],
        r"constraints\[1\].*kept together with constraints\[0\]",
    ),
    "start": (lambda arm, limit: [mp.TiltLimit((0, 0, 1), (1, 0, 0), 0.2)], r"start: .*breaks tilt.*allowed 11\.459°"),
    "start in a box": (lambda arm, limit: [mp.PositionBox((5, 5, 5), (6, 6, 6))], r"start: .*breaks tool position.*mm outside"),
    "goal": (lambda arm, limit: [mp.HeldJoints("panda_joint1")], "panda_joint1 is held, and differs"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_constraints(panda, level, name):
    start, goal, limit = level
    make, message = BAD[name]
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.plan(panda, start, goal, constraints=make(panda, limit))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: mp.TiltLimit((0, 0, 0), DOWN, 0.1), "axis: .*not zero"),
        (lambda: mp.TiltLimit((0, 0, 1), (0, 0), 0.1), "direction"),
        (lambda: mp.TiltLimit((0, 0, 1), DOWN, 0.0), "angle: got 0"),
        (lambda: mp.TiltLimit((0, 0, 1), DOWN, 4.0), "angle: got 4.*below π"),
        (lambda: mp.TiltLimit((0, 0, 1), DOWN, np.nan), "angle"),
        (lambda: mp.PositionBox((0, 0, 0), (1, 0, 1)), "upper: got 'y from 0 to 0'"),
        (lambda: mp.PositionBox((0, 0, np.nan), (1, 1, 1)), r"lower: got \(0, 0, nan\); allowed: three numbers"),
        (lambda: mp.PositionBox((-np.inf,) * 3, (np.inf,) * 3), "at least one wall"),
        (lambda: mp.PositionBox("abc", (1, 1, 1)), "lower"),
        (lambda: mp.PositionBox((0, 0, 0), (1, 1, 1), np.zeros((4, 4))), "pose"),
        (lambda: mp.HeldJoints([]), "at least one"),
        (lambda: mp.HeldJoints(["a", "a"]), "each name once"),
        (lambda: mp.HeldJoints([3]), "names of joints"),
    ],
)
def test_bad_values(make, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        make()


def test_where_constraints_are_not_possible(panda, level):
    start, goal, limit = level
    with pytest.raises(mp.errors.InvalidInputError, match="none without a scene"):
        mp.optimize_path(panda, start, goal, constraints=[limit])
    with pytest.raises(mp.errors.InvalidInputError, match="'auto': the other planners keep no constraints"):
        mp.seed_path(panda, start, goal, constraints=[limit], seeding=mp.Seeding(planner="RRTConnect"))
    tilted = mp.JointPath.through([start, start + [0, 0, 0, 0, 0, 0.5, 0], goal])
    with pytest.raises(mp.errors.InvalidInputError, match=r"a path with tilt .* at s = "):
        mp.optimize_path(panda, start, goal, mp.Scene(), constraints=[limit], seeding=mp.Seeding(initial=tilted))

    class NoColumn(mp.Constraint):
        name = "wrong"

        def rows(self, at):
            return 3.0

    with pytest.raises(mp.errors.InvalidInputError, match=r"'wrong'; allowed: .*ca.SX \(r, 1\)"):
        mp.plan(panda, start, goal, constraints=[NoColumn()])


@pytest.mark.slow
def test_no_way_inside_a_limit_says_so(panda, level):
    """One joint alone does not bring the hand around a post."""
    start = level[0]
    goal = start + [1.4, 0, 0, 0, 0, 0, 0]
    wall = mp.Scene([mp.Box(size=(0.02, 0.02, 1.5), position=(0.22, 0.22, 0.75), name="post")])
    limit = mp.HeldJoints(panda.joint_names[1:])
    with pytest.raises(mp.errors.PlanningError, match=r"widen the constraints \(held: .*panda_joint7\)"):
        mp.plan(panda, start, goal, wall, constraints=[limit], seeding=mp.Seeding(time_limit=0.5))


def test_constraints_of_a_file(tmp_path):
    file = tmp_path / "kept.yaml"
    file.write_text(
        "constraints:\n- tilt_limit: {axis: [0, 0, 1], direction: [0, 0, -1], angle: 0.1}\n"
        "- position_box: {lower: [-.inf, 0, 0], upper: [1, 1, .inf]}\n- held_joints: {joints: [a, b]}\n"
    )
    assert constraints_from_yaml(file) == (
        mp.TiltLimit((0, 0, 1), DOWN, 0.1),
        mp.PositionBox((-np.inf, 0, 0), (1, 1, np.inf)),
        mp.HeldJoints(["a", "b"]),
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("constraint: []", "single key constraints"),
        ("constraints: []", "at least one"),
        ("constraints: [3]", r"constraints\[0\] in .*one of the keys"),
        ("constraints: [{tilt_limt: {}}]", "did you mean tilt_limit"),
        ("constraints: [{tilt_limit: {axis: [0, 0, 1]}}]", "keys axis, direction, angle"),
        (
            "constraints: [{tilt_limit: {axis: [0, 0, 1], direction: [0, 0, 1], angle: 9}}]",
            r"\[0\].tilt_limit.angle in .*got '9",
        ),
        ("constraints: [{held_joints: {joints: 3}}]", r"held_joints.joints in"),
    ],
)
def test_bad_files(tmp_path, text, message):
    file = tmp_path / "kept.yaml"
    file.write_text(text)
    with pytest.raises(mp.errors.FileFormatError, match=message):
        constraints_from_yaml(file)
