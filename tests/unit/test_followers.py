"""Robots whose joints follow active ones, from kinematics to export.

The oracle is Pinocchio's model of the file, in which followers are independent and are placed by hand.
"""

import copy
import itertools
import pickle

import casadi as ca
import coal
import numpy as np
import pinocchio as pin
import pytest
from examples import examples
from follower_robots import ONE_TOOL, ROBOTS, Whole, joint, link, written
from hypothesis import given
from hypothesis import strategies as st
from test_export_c import build, example_in_python, run

import manipplan as mp
from manipplan.collision.path_clearance import body_motion
from manipplan.constraints.constraint_set import tool_frame
from manipplan.goals.solutions import beyond_links
from manipplan.ik.geometry import Screws
from manipplan.ik.newton import MovingArm
from manipplan.jobs.plan_many import robot_key
from manipplan.optimize.clearance import ClearanceRows, row_functions
from manipplan.robots.arms import arm_of, tool_reach
from manipplan.robots.limits import nearest_turns
from manipplan.timing.constant_speed import most_acceleration
from manipplan.tracking.avoidance import avoidance_rows
from manipplan.viz.motions import skeleton
from manipplan.viz.viewer.bodies import appearance_of


@pytest.fixture(scope="module")
def arms(tmp_path_factory):
    """File, robot and oracle by name."""
    folder = tmp_path_factory.mktemp("followers")
    made = {}

    def get(name):
        if name not in made:
            made[name] = written(folder, name)
        return made[name]

    return get


def samples(robot, count, seed=0):
    return robot.random_configuration(np.random.default_rng(seed), size=count)


# ---- model and kinematics


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
def test_pose_and_jacobian_are_those_of_the_whole_file(arms, name):
    _, robot, whole = arms(name)
    assert robot.model.nq == robot.n == len(robot.joint_names) < whole.model.nq
    for each in (robot, pickle.loads(pickle.dumps(robot)), copy.deepcopy(robot), robot.with_limits(velocity=1.0)):
        for tool in robot.tools:
            joints = list(robot.joints_of(tool))
            kinematics = each.arm(tool).kinematics(mp.Task.pose(length=1.0), compiled=False)
            for sample in samples(robot, 5):
                q = np.where(np.isin(np.arange(robot.n), joints), sample, robot.neutral)
                np.testing.assert_allclose(kinematics.pose(q[joints]), whole.pose(q, tool), atol=1e-12)
                np.testing.assert_allclose(kinematics.jacobian(q[joints]), whole.jacobian(q, tool)[:, joints], atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("name", ONE_TOOL)
def test_derivatives_of_the_manipulability(arms, name, compiled):
    _, robot, whole = arms(name)
    task = mp.Task.pose(length=0.7) if robot.n >= 6 else mp.Task.position()
    kinematics = robot.kinematics(task, compiled=compiled)
    rows = np.diag([1, 1, 1, 0.7, 0.7, 0.7])[: task.rows]
    q = samples(robot, 4, seed=3)
    values = [np.sqrt(np.linalg.det((J := rows @ whole.jacobian(each, robot.tool)) @ J.T)) for each in q]
    np.testing.assert_allclose(kinematics.manipulability(q), values, rtol=1e-7, atol=1e-10)
    step, unit = 1e-5, np.eye(robot.n)
    by_value = [(kinematics.manipulability(q + step * e) - kinematics.manipulability(q - step * e)) / (2 * step) for e in unit]
    by_slope = [(kinematics.gradient(q + step * e) - kinematics.gradient(q - step * e)) / (2 * step) for e in unit]
    np.testing.assert_allclose(kinematics.gradient(q), np.transpose(by_value), atol=1e-6)
    np.testing.assert_allclose(kinematics.hessian(q), np.transpose(by_slope, (1, 2, 0)), atol=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("name", ONE_TOOL)
def test_inverse_kinematics_finds_its_own_configuration(arms, name):
    _, robot, whole = arms(name)
    task = mp.Task.pose() if robot.n >= 6 else mp.Task.position()
    for q in samples(robot, 3, seed=1):
        pose = whole.pose(q, robot.tool)
        known = {"held": [robot.joint_names[0]], "parameters": q[:1]} if robot.n == 7 else {}
        found = mp.inverse_kinematics(robot, pose, task=task, **known)
        if name.startswith("torso"):  # the follower moves one arm as its leader the other: neither needs it
            assert found.method == "spherical" and found.complete.name == "EXACT"
        else:
            assert found.method == "newton" and found.complete.name == "STATISTICAL"
        for each in found.q:
            miss = whole.pose(each, robot.tool) - pose
            np.testing.assert_allclose(miss[:3] if task.rows == 6 else miss[:3, 3], 0.0, atol=1e-8)
            assert not robot.limits.outside(each).any()
        assert robot.n == 4 or np.abs(found.q - q).max(axis=1).min() < 1e-6


# ---- limits


def test_limits_of_leaders_keep_those_of_followers(arms, caplog, tmp_path):
    for name in ROBOTS:
        with caplog.at_level("INFO", logger="manipplan"):
            _, robot, whole = written(tmp_path, name)
        q = whole.all(np.vstack([samples(robot, 200), robot.limits.lower, robot.limits.upper]))
        moved = whole.matrix.any(axis=1)
        low, high = whole.model.lowerPositionLimit, whole.model.upperPositionLimit
        assert (q >= low - 1e-12)[:, moved].all() and (q <= high + 1e-12)[:, moved].all()
        fastest = np.abs(whole.matrix) @ robot.limits.velocity
        assert (fastest <= whole.model.velocityLimit + 1e-12).all()
        # they are no narrower than that: a leader at its limit has itself or a follower at one
        for bound in (robot.limits.lower, robot.limits.upper):
            at = np.minimum(np.abs(whole.all(bound) - low), np.abs(whole.all(bound) - high)) < 1e-9
            assert ((at[:, None] & (whole.matrix != 0)).any(axis=0)).all()
        full = np.abs(fastest - whole.model.velocityLimit) < 1e-9
        assert ((full[:, None] & (whole.matrix != 0)).any(axis=0)).all()
        np.testing.assert_allclose(robot.limits.acceleration, robot.limits.velocity / 0.2)
    assert "j5: limits narrowed by j5b, which moves as -1.5 * j5 + 0.4: lower -1.2, upper 1.2, velocity 1.66667" in caplog.text
    assert "j5b: its effort limit of" in caplog.text and "is not taken, as it moves as -1.5 * j5 + 0.4, by" in caplog.text


def test_given_limits_stay_as_they_are(arms):
    file, _, _ = arms("double")
    robot = mp.Robot.from_urdf(file, velocity=3.0, upper=2.0)
    assert robot.limits.velocity.tolist() == [3.0] * 6
    assert robot.limits.upper[4] == 2.0 and robot.limits.lower[4] == pytest.approx(-1.2)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('lower="-1.4" upper="2.2"', 'lower="9" upper="9.5"', r"position limits of j5b: got \[9.0, 9.5\].*moves as -1.5 \* j5 \+ 0.4"),
        ('velocity="2.5"', 'velocity="0"', "velocity limit of j5b: got 0.0; allowed: above zero; give velocity="),
    ],
)  # fmt: skip
def test_limits_that_leave_no_room(arms, tmp_path, old, new, message):
    file, _, _ = arms("double")
    changed = tmp_path / "changed.urdf"
    changed.write_text(file.read_text().replace(old, new))
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Robot.from_urdf(changed)


# ---- the robot as a value


@pytest.mark.parametrize("name", ["double", "upstream", "palletiser"])
def test_moved_robots_with_tools_and_parts(arms, name):
    _, robot, whole = arms(name)
    base = pin.SE3(pin.rpy.rpyToMatrix(0.2, -0.1, 0.7), np.array([0.3, -0.2, 0.5])).homogeneous
    tcp = pin.SE3(pin.rpy.rpyToMatrix(0.1, 0.3, -0.2), np.array([0.02, 0.03, 0.1])).homogeneous
    changed = robot.at(base).with_tool(tcp, name="tip").attach(mp.Sphere(radius=0.03, position=(0.0, 0.0, 0.05)), name="ball")
    changed = pickle.loads(pickle.dumps(changed)).detach("ball").attach(mp.Sphere(radius=0.02), name="pearl")
    kinematics = changed.kinematics(mp.Task.position(), compiled=False)
    scene = mp.Scene([mp.Box(size=(0.1, 0.2, 0.3), position=(0.6, 0.2, 1.1), name="box")])
    for q in samples(robot, 3):
        pose = base @ whole.pose(q, robot.tool) @ tcp
        np.testing.assert_allclose(kinematics.pose(q), pose, atol=1e-12)
        model = scene.collision_model(changed)
        pair = model.pair_names.index(("pearl", "box"))
        outside = np.abs(pose[:3, 3] - [0.6, 0.2, 1.1]) - [0.05, 0.1, 0.15]
        expected = np.linalg.norm(np.maximum(outside, 0)) + min(outside.max(), 0.0) - 0.02
        assert model.distance_rows(q[None])[0, pair] == pytest.approx(expected, abs=1e-6)


def test_the_key_of_a_robot_has_its_followers(arms, tmp_path):
    file, robot, _ = arms("double")
    assert robot_key(pickle.loads(pickle.dumps(robot))) == robot_key(robot)
    other = tmp_path / "double.urdf"
    keys = set()
    for old, new in (('multiplier="-1.5"', 'multiplier="-1.50001"'), ('offset="0.4"', 'offset="0.40001"'), ("", "")):
        other.write_text(file.read_text().replace(old, new) if old else file.read_text())
        keys.add(robot_key(mp.Robot.from_urdf(other, lower=-1.0, upper=1.0, velocity=1.0)))
    assert len(keys) == 3


def test_arms_of_a_torso_and_locked_leaders(arms):
    """Where the leader is locked, its followers are locked as well."""
    _, robot, whole = arms("torso")
    assert robot.joints_of("lefttool")[0] == robot.joints_of("righttool")[0] == 0
    q = samples(robot, 1)[0]
    held = arm_of(robot, "righttool", [i for i in robot.joints_of("righttool") if i > 0], q)
    assert held.locked["b1"] == held.locked["b2"] == q[0] and not held.followers
    np.testing.assert_allclose(
        held.kinematics(mp.Task.pose(), compiled=False).pose(q[7:]), whole.pose(q, "righttool"), atol=1e-12
    )
    alone = robot.arm("righttool", q)
    assert alone.joint_names[0] == "b1" and list(alone.followers) == ["b2"]
    moved = np.concatenate([[q[0] + 0.3], q[7:]])
    together = np.concatenate([[q[0] + 0.3], q[1:]])
    np.testing.assert_allclose(
        alone.kinematics(mp.Task.pose(), compiled=False).pose(moved), whole.pose(together, "righttool"), atol=1e-12
    )
    data = alone.model.createData()  # the other arm moves with the leader of its torso
    pin.framesForwardKinematics(alone.model, data, moved)
    found = data.oMf[alone.model.getFrameId("lefttool")].homogeneous
    np.testing.assert_allclose(found, whole.pose(together, "lefttool"), atol=1e-12)


def test_frames_of_a_task_may_move_with_followers(arms):
    """Relative to the other hand both halves of the torso cancel out."""
    _, robot, whole = arms("torso")
    kinematics = robot.kinematics(mp.Task.pose(length=1.0, relative_to="righttool"), compiled=False)
    for q in samples(robot, 3):
        assert np.abs(kinematics.jacobian(q)[:, 0]).max() < 1e-12
        step = 1e-6 * np.eye(robot.n)
        seen = [np.linalg.inv(whole.pose(each, "righttool")) @ whole.pose(each, "lefttool") for each in (*(q + step), q)]
        slopes = (np.array(seen[:-1])[:, :3, 3] - seen[-1][:3, 3]).T / 1e-6
        np.testing.assert_allclose(kinematics.jacobian(q)[:3], slopes, atol=1e-5)


@pytest.mark.parametrize("source", ["bridge", "auto"])
def test_pinocchios_own_symbols_are_refused(arms, source):
    with pytest.raises(
        mp.errors.InvalidInputError, match="without joints that follow others, unlike j5b: backend='chain' has them"
    ):
        mp.pinocchio_casadi(arms("double")[1], source=source)


def test_the_table_and_pictures_have_followers(arms):
    _, robot, whole = arms("palletiser")
    assert "followers: level2 = -1 * j2 + 0, level3 = -1 * j3 + 0" in str(robot)
    q = samples(robot, 1)[0]
    line = skeleton(robot, q)
    np.testing.assert_allclose(line[-1], whole.pose(q, "tool")[:3, 3], atol=1e-12)
    data = whole.model.createData()
    pin.forwardKinematics(whole.model, data, whole.all(q))
    np.testing.assert_allclose(line[1:-1], [each.translation for each in list(data.oMi)[1:]], atol=1e-12)
    bodies = {body.name: body for body in appearance_of(robot).bodies}
    own = robot.model.createData()
    pin.forwardKinematics(robot.model, own, q)
    for item in whole.geometry.geometryObjects:
        body = bodies[item.name]
        middle = own.oMi[body.joint].act(body.vertices.mean(axis=0))
        np.testing.assert_allclose(middle, data.oMi[item.parentJoint].act(item.placement).translation, atol=1e-6)


# ---- collisions

OBSTACLES = {
    "box": (coal.Box(0.2, 0.3, 0.4), pin.SE3(np.eye(3), np.array([0.7, 0.3, 0.6]))),
    "ball": (coal.Sphere(0.1), pin.SE3(np.eye(3), np.array([-0.5, 0.4, 0.8]))),
}
SCENE = mp.Scene(
    [mp.Box(size=(0.2, 0.3, 0.4), position=(0.7, 0.3, 0.6), name="box"), mp.Sphere(radius=0.1, position=(-0.5, 0.4, 0.8), name="ball")]
)  # fmt: skip


def distances(whole, pairs, q, obstacles=OBSTACLES):
    """Distances of pairs of names at q (n,), by coal on the bodies of the file."""
    data = whole.model.createData()
    pin.forwardKinematics(whole.model, data, whole.all(q))
    objects = {item.name: item for item in whole.geometry.geometryObjects}

    def placed(name):
        if name in obstacles:
            shape, place = obstacles[name]
        else:
            shape, place = objects[name].geometry, data.oMi[objects[name].parentJoint] * objects[name].placement
        return shape, coal.Transform3s(place.rotation, place.translation)

    ask = coal.DistanceRequest()
    return np.array([coal.distance(*placed(a), *placed(b), ask, coal.DistanceResult()) for a, b in pairs])


@pytest.mark.parametrize("name", ROBOTS)
def test_distances_and_their_gradients(arms, name):
    _, robot, whole = arms(name)
    model = SCENE.collision_model(robot)
    q = samples(robot, 8, seed=4)
    rows = model.distance_rows(q)
    for each, row in zip(q, rows, strict=True):
        np.testing.assert_allclose(row, distances(whole, model.pair_names, each), atol=2e-6)
        assert model.in_collision_rows(each[None])[0] == (row <= 0).any()
    pairs, step = np.arange(len(model.pair_names)), 1e-6
    found = model.witnesses(np.tile(q[0], (len(pairs), 1)), pairs)
    ends = [model.distance_rows(q[0] + sign * step * np.eye(robot.n)) for sign in (1, -1)]
    slopes = ((ends[0] - ends[1]) / (2 * step)).T
    apart = found.distances > 1e-3
    assert apart.sum() > 10 and np.quantile(np.abs(found.gradients - slopes)[apart], 0.98) < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
def test_proofs_hold_for_all_bodies(arms, name):
    """The proven distance is below every sample on the original bodies, and near to the least of them."""
    _, robot, whole = arms(name)
    names = SCENE.collision_model(robot).pair_names
    q = samples(robot, 5, seed=6)
    for a, b in itertools.pairwise(q):
        path = mp.JointPath.line(a, a + 0.3 * (b - a))
        proven = SCENE.path_clearance(robot, path)
        sampled = min(distances(whole, names, each).min() for each in path(np.linspace(0, 1, 60)))
        assert proven.lower <= sampled + 1e-6 and sampled < proven.upper + 0.02
        bound = body_motion(SCENE.collision_model(robot))
        change = np.abs(0.3 * (b - a))[None]
        pairs = np.arange(len(names))
        most = bound.motion(a[None], change, np.zeros(len(pairs), dtype=int), pairs)
        by_numpy = bound._motion_by_numpy(a[None], change, np.zeros(len(pairs), dtype=int), pairs)
        np.testing.assert_allclose(most, by_numpy, rtol=1e-9)
        start = distances(whole, names, a)
        for each in path(np.linspace(0, 1, 20)):
            assert (np.abs(distances(whole, names, each) - start) <= most + 1e-6).all()


def test_rows_of_clearance(arms):
    """Value, gradient and Hessian of a clearance row by differences."""
    for name in ("double", "torso-right", "upstream"):
        _, robot, _ = arms(name)
        functions = row_functions(robot.kinematics(mp.Task.position(), compiled=False)).functions
        size = robot.model.njoints - 1
        rng = np.random.default_rng(2)
        for _ in range(5):
            joint, other = rng.choice(size + 1, 2, replace=False).tolist()
            point, q = rng.normal(size=3), samples(robot, 1, seed=joint)[0]
            column = ClearanceRows.of(size, np.zeros(1), joint, point, other, np.eye(3)[1], 0.1, 0.05).columns[0]

            def value(q, joint=joint, other=other, point=point, robot=robot):
                data = robot.model.createData()
                pin.forwardKinematics(robot.model, data, q)
                return data.oMi[other].actInv(data.oMi[joint].act(point))[1] - 0.1 - 0.05

            step, unit = 1e-4, np.eye(robot.n)
            slopes = [(value(q + step * e) - value(q - step * e)) / (2 * step) for e in unit]
            bends = [(np.array(functions[1](q + step * e, column)) - np.array(functions[1](q - step * e, column))) / (2 * step) for e in unit]  # fmt: skip
            assert float(functions[0](q, column)) == pytest.approx(value(q), abs=1e-12)
            np.testing.assert_allclose(np.array(functions[1](q, column))[:, 0], slopes, atol=1e-6)
            np.testing.assert_allclose(np.array(functions[2](q, column)), np.hstack(bends), atol=1e-6)


# ---- jobs


def clear(robot, scene, count, seed=5):
    """Configurations without collisions and not near limits, far from singularities first."""
    task = mp.Task.pose() if robot.n >= 6 else mp.Task.position()
    q = robot.neutral + 0.7 * (samples(robot, 200, seed) - robot.neutral)
    q = q[~scene.in_collision(robot, q)]
    return q[np.argsort(-robot.kinematics(task).manipulability(q))][:count], task


def judged(whole, trajectory, names, obstacles=OBSTACLES):
    """Limits of all joints of the file, and the least distance of pairs of its bodies, by samples."""
    t = np.linspace(0.0, trajectory.duration, 300)
    q, qd = whole.all(trajectory(t)), trajectory(t, 1) @ whole.matrix.T
    moved = whole.matrix.any(axis=1)
    assert (q >= whole.model.lowerPositionLimit - 1e-9)[:, moved].all()
    assert (q <= whole.model.upperPositionLimit + 1e-9)[:, moved].all()
    assert (np.abs(qd) <= whole.model.velocityLimit * (1 + 1e-6)).all()
    return min(distances(whole, names, each, obstacles).min() for each in trajectory(t[::3]))


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in ROBOTS if name != "torso-left"])
def test_plans_are_safe_for_all_bodies(arms, name, tmp_path):
    _, robot, whole = arms(name)
    if name == "torso":
        q = samples(robot, 400)
        start, goal = q[~SCENE.in_collision(robot, q)][:2]
    else:
        start, goal = clear(robot, SCENE, 4)[0][[0, 3]]
    seeding = mp.Seeding(time_limit=10.0 if name == "torso" else 60.0)
    names = SCENE.collision_model(robot).pair_names
    free = mp.plan(robot, start, goal, seeding=seeding)
    assert free.report.passed
    plan = mp.plan(robot, start, goal, SCENE, seeding=seeding)
    assert plan.report.passed and judged(whole, plan.trajectory, names) > 0
    plan.save(tmp_path / "plan")
    loaded = mp.Plan.load(tmp_path / "plan")
    assert loaded.robot.followers == robot.followers and robot_key(loaded.robot) == robot_key(robot)
    assert mp.check(loaded.robot, loaded.trajectory, SCENE).passed
    if name != "torso":
        held = mp.plan(robot, start, robot.kinematics(mp.Task.pose()).pose(goal), SCENE, seeding=seeding)
        assert held.report.passed and judged(whole, held.trajectory, names) > 0
        miss = whole.pose(held.trajectory(held.trajectory.duration), robot.tool) - whole.pose(goal, robot.tool)
        assert np.abs(miss).max() < 1e-5


@pytest.mark.slow
@pytest.mark.parametrize("name", ["hollow", "palletiser", "double", "chain"])
def test_lines_are_followed(arms, name):
    _, robot, whole = arms(name)
    [start, *_], task = clear(robot, SCENE, 1)
    first = whole.pose(start, robot.tool)
    last = first.copy()
    last[:3, 3] += [0.0, 0.03, 0.02]
    plan = mp.follow(robot, mp.CartesianPath.line(first, last), SCENE, objective=mp.PathObjective(task=task))
    assert plan.report.passed and judged(whole, plan.trajectory, SCENE.collision_model(robot).pair_names) > 0
    for q in plan.trajectory(np.linspace(0, plan.trajectory.duration, 50)):
        pose = whole.pose(q, robot.tool)
        way = last[:3, 3] - first[:3, 3]
        off = pose[:3, 3] - first[:3, 3]
        assert np.linalg.norm(off - way * (off @ way) / (way @ way)) < 2e-4
        assert robot.n < 6 or np.abs(pose[:3, :3] - first[:3, :3]).max() < 2e-3


@pytest.mark.parametrize("name", ["double", "palletiser", "upstream"])
def test_torques_are_those_of_all_bodies(arms, name):
    _, robot, whole = arms(name)
    data, own = whole.model.createData(), robot.model.createData()
    chain = robot.kinematics(mp.Task.position(), compiled=False).symbolic.chain
    for q, qd, qdd in np.random.default_rng(0).normal(size=(4, 3, robot.n)):
        expected = whole.matrix.T @ pin.rnea(whole.model, data, whole.all(q), whole.matrix @ qd, whole.matrix @ qdd)
        np.testing.assert_allclose(pin.rnea(robot.model, own, q, qd, qdd), expected, atol=1e-9)
        inertia = pin.crba(whole.model, data, whole.all(q))
        inertia = np.triu(inertia) + np.triu(inertia, 1).T
        found = np.array(ca.Function("m", [chain.q], [chain.mass_matrix])(q))
        np.testing.assert_allclose(found, whole.matrix.T @ inertia @ whole.matrix, atol=1e-9)
    rng = np.random.default_rng(1)
    path = mp.JointPath.line(*(0.5 * samples(robot, 2) + 0.5 * robot.neutral))
    gravity = [np.abs(whole.matrix.T @ pin.computeGeneralizedGravity(whole.model, data, whole.all(q))) for q in path(np.linspace(0, 1, 50))]  # fmt: skip
    effort = 1.3 * np.max(gravity, axis=0) + 2.0 + rng.uniform(0, 1, robot.n)
    slow = mp.retime(path, robot.with_limits(effort=effort), torque=True)
    t = np.linspace(0, slow.duration, 400)
    torque = [whole.matrix.T @ pin.rnea(whole.model, data, whole.all(a), whole.matrix @ b, whole.matrix @ c) for a, b, c in zip(slow(t), slow(t, 1), slow(t, 2), strict=True)]  # fmt: skip
    assert (np.abs(torque) <= effort * (1 + 1e-4)).all()


# ---- control


@pytest.mark.slow
@pytest.mark.parametrize("name", ["hollow", "palletiser", "upstream"])
def test_a_controller_moves_the_tool(arms, name):
    _, robot, whole = arms(name)
    [start, *_], task = clear(robot, mp.Scene([]), 1)
    first = whole.pose(start, robot.tool)
    last = first.copy()
    last[:3, 3] += [0.02, 0.05, -0.03]
    for formulation in (mp.formulations.Classical(), mp.formulations.LogDrive()):
        tracked = mp.track(robot, mp.CartesianPath.line(first, last), start, formulation, dt=0.01, duration=1.0, task=task)
        end = whole.pose(tracked.q[-1], robot.tool)
        assert np.linalg.norm(end[:3, 3] - last[:3, 3]) < 2e-3
        velocity = np.abs(tracked.qd @ whole.matrix.T)
        assert (velocity <= whole.model.velocityLimit * (1 + 1e-9)).all()


def test_avoidance_rows(arms):
    """Distances and their rates by differences of the placements of the file."""
    _, robot, _ = arms("double")
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.6, 0.2, 0.9), name="ball")])
    avoidance = mp.Avoidance(scene=scene, influence=3.0, itself=True)
    chain = robot.kinematics(compiled=False).symbolic.chain
    rows = avoidance_rows(robot, chain, avoidance)
    function = ca.Function("rows", [chain.q, rows.obstacles], [rows.distance, rows.matrix])
    for q in samples(robot, 3):
        ends = [np.array(function(q + sign * 1e-6 * e, [])[0])[:, 0] for e in np.eye(robot.n) for sign in (1, -1)]
        slopes = (np.array(ends[::2]) - np.array(ends[1::2])).T / 2e-6
        distance, matrix = (np.array(each) for each in function(q, []))
        apart = distance[:, 0] > 1e-3
        assert apart.sum() > 5 and np.quantile(np.abs(matrix - slopes)[apart], 0.97) < 1e-5


@pytest.mark.slow
@pytest.mark.compiler
def test_the_exported_controller_is_that_of_python(arms, tmp_path):
    _, robot, _ = arms("double")
    controller = mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01, compiled=False)
    controller.export_c(tmp_path / "controller")
    program = build(tmp_path / "controller", "by hand")
    printed = run(program, cwd=tmp_path).stdout
    found = np.array([[float(word) for word in line.split()] for line in printed.splitlines()])
    np.testing.assert_allclose(found, example_in_python(controller), atol=1e-9)


def test_files_have_the_leaders_alone(arms, tmp_path):
    _, robot, _ = arms("palletiser")
    trajectory = mp.retime(mp.JointPath.line(robot.neutral, robot.neutral + 0.2), robot)
    trajectory.to_csv(tmp_path / "motion.csv")
    read = mp.Trajectory.from_csv(tmp_path / "motion.csv", joints=robot.joint_names)
    assert read.joint_names == trajectory.joint_names == ("j1", "j2", "j3", "j4")
    assert mp.check(robot, read, mp.Scene([])).passed


# ---- bounds


@pytest.mark.parametrize("name", ["hollow", "double", "chain", "upstream"])
def test_bounds_on_the_motion_of_the_tool(arms, name):
    """Upper bounds on its acceleration along random curves, by differences, and on its distance from the first joint."""
    _, robot, whole = arms(name)
    place, length = tool_reach(robot, robot.tool)
    bound, rng, h = tool_frame(robot, robot.tool), np.random.default_rng(3), 1e-4
    most, largest = most_acceleration(robot), 0.0
    for q in samples(robot, 40):
        v, a = rng.uniform(-1, 1, (2, robot.n)) * [robot.limits.velocity, robot.limits.acceleration]
        poses = [whole.pose(q + v * u + a * u * u / 2, robot.tool) for u in (-h, 0.0, h)]
        bend = (poses[0] - 2 * poses[1] + poses[2]) / h**2
        unit, position = bound.bend(np.abs(q)[None], np.abs(v)[None], np.abs(a)[None])
        assert np.linalg.norm(bend[:3, :3], 2) <= unit[0] + 1e-3
        assert np.linalg.norm(bend[:3, 3]) <= position[0] + 1e-3 and position[0] <= most * 1.001
        assert np.linalg.norm(poses[1][:3, 3] - place) <= length
        pose, jacobian = bound.at(q[None])
        np.testing.assert_allclose(pose[0, :3], poses[1][:3, 3], atol=1e-12)
        np.testing.assert_allclose(jacobian[0].T, whole.jacobian(q, robot.tool), atol=1e-12)
        largest = max(largest, np.linalg.norm(bend[:3, 3]))
    assert largest > 0.02 * most


@pytest.mark.slow
def test_a_pose_out_of_reach(arms):
    _, robot, whole = arms("upstream")
    far = whole.pose(robot.neutral, robot.tool)
    far[2, 3] = 5.0
    told = beyond_links(robot, robot.tool, mp.PoseGoal(far))
    assert told.startswith("out of reach: 4.79 m from stage2, and the links up to the tool are")
    with pytest.raises(mp.errors.InvalidInputError, match="out of reach.*with stage2 at a limit"):
        mp.plan(robot, robot.neutral, far)


def test_a_level_tool_stays_level(arms):
    """The palletiser cannot tilt its tool: the constraint holds by construction, and the box limits the rest."""
    _, robot, whole = arms("palletiser")
    (start, goal, *_), _ = clear(robot, mp.Scene([]), 4)
    level = mp.TiltLimit(axis=(0.0, 0.0, 1.0), direction=(0.0, 0.0, -1.0), angle=0.01)
    plan = mp.plan(robot, start, goal, constraints=[level])
    assert plan.report.passed
    for q in plan.trajectory(np.linspace(0, plan.trajectory.duration, 40)):
        np.testing.assert_allclose(whole.pose(q, "tool")[:3, 2], [0, 0, -1], atol=1e-9)


@pytest.mark.parametrize(
    ("ratio", "kind", "back"), [("2", "revolute", True), ("-1.5", "revolute", False), ("1", "prismatic", False)]
)
def test_full_turns(tmp_path, ratio, kind, back):
    """A full turn of a leader is the same posture only where its followers make whole turns."""
    file = tmp_path / "arm.urdf"
    wide = joint("wide", "base", "l1", "0 0 0.3", "0 0 1", limit=(-7, 7))
    follower = joint(
        "f", "l1", "l2", "0.3 0 0", "0 1 0", limit=(-20, 20), velocity=9.0, kind=kind, mimic=("wide", ratio, "0.3")
    )
    file.write_text(
        f'<robot name="r">{link("base")}{wide}{link("l1")}{follower}{link("l2")}{joint("j", "l2", "tip", "0.3 0 0", "0 1 0")}'
        f"{link('tip')}</robot>"
    )
    robot = mp.Robot.from_urdf(file, tool="tip")
    assert robot.turns.tolist() == [back, True]
    whole = Whole.of(file, robot)
    q, near = np.array([[3.0, 0.4]]), np.array([-3.2, 0.4])
    nearest = nearest_turns(robot, q, near)[0]
    assert (abs(nearest[0] - near[0]) < 1.0) == back
    np.testing.assert_allclose(whole.pose(nearest, "tip"), whole.pose(q[0], "tip"), atol=1e-12)
    endless = robot.with_limits(lower=-np.inf, upper=np.inf)
    assert endless.continuous_joints.tolist() == [back, True]
    if not back:
        with pytest.raises(
            mp.errors.InvalidInputError, match=r"limits of wide: got \(-inf, inf\); allowed: finite limits on both sides"
        ):
            mp.inverse_kinematics(endless, whole.pose(q[0], "tip"))


NUMBERS = st.floats(-1.5, 1.5).map(lambda x: round(x, 3))


@st.composite
def trees(draw):
    """A chain of joints with a branch, some of which mimic others, before or behind them."""
    count = draw(st.integers(3, 7))
    free = draw(st.lists(st.integers(0, count - 1), min_size=1, max_size=count, unique=True))
    text, mimics = link("l0"), {}
    for i in range(count):
        if i not in free:
            leaders = [k for k in range(count) if k != i and (k in free or k in mimics)]
            mimics[i] = draw(st.sampled_from(leaders)), draw(st.sampled_from([-1.0, 1.0, 0.5, -2.0, 0.0])), draw(NUMBERS)
    branch = draw(st.integers(0, count - 1))
    for i in range(count):
        parent = i if i != branch or i == 0 else draw(st.integers(0, i - 1))
        axis = draw(st.sampled_from(["1 0 0", "0 1 0", "0 0 1", "0 -1 0", "0.6 0 0.8"]))
        kind = draw(st.sampled_from(["revolute", "revolute", "prismatic"]))
        mimic = (f"j{mimics[i][0]}", *mimics[i][1:]) if i in mimics else None
        text += joint(
            f"j{i}", f"l{parent}", f"l{i + 1}", f"{draw(NUMBERS)} 0.1 0.3", axis, rpy="0.3 0.2 0.1", kind=kind, mimic=mimic
        )
        text += link(f"l{i + 1}") if i else link(f"l{i + 1}", ("0 0 0.1", "0.1 0.1 0.1"))
    return f'<robot name="tree">{text}</robot>', f"l{count}"


@pytest.mark.slow
@examples(80)
@given(tree=trees(), data=st.data())
def test_any_tree(tmp_path_factory, tree, data):
    text, tool = tree
    file = tmp_path_factory.mktemp("tree") / "tree.urdf"
    file.write_text(text)
    try:
        robot = mp.Robot.from_urdf(file, tool=tool, lower=-1.0, upper=1.0, velocity=1.0)
    except mp.errors.InvalidInputError as error:
        assert f"tool: got {tool!r}; allowed: a frame that a joint moves" in str(error)
        return
    whole = Whole.of(file, robot)
    q = np.array([data.draw(NUMBERS) for _ in range(robot.n)])
    for each in (robot, pickle.loads(pickle.dumps(robot)), robot.at(np.eye(4))):
        kinematics = each.kinematics(mp.Task.pose(length=1.0), compiled=False)
        np.testing.assert_allclose(kinematics.pose(q), whole.pose(q, tool), atol=1e-12)
        np.testing.assert_allclose(kinematics.jacobian(q), whole.jacobian(q, tool), atol=1e-12)
        assert each.joint_names == robot.joint_names and each.followers == robot.followers
    screws = Screws.of(robot)
    refined = MovingArm(screws, np.ones(robot.n, dtype=bool)).refine(
        q[None] + 0.01, kinematics.pose(q)[None], np.zeros(1, dtype=int), steps=30, tolerance=1e-12
    )
    assert np.abs(kinematics.pose(refined[0]) - kinematics.pose(q)).max() < 1e-3
    if robot.n > 1:
        rest = arm_of(robot, tool, range(1, robot.n), q)
        np.testing.assert_allclose(rest.kinematics(compiled=False).pose(q[1:]), whole.pose(q, tool), atol=1e-12)
        assert rest.locked[robot.joint_names[0]] == q[0]


UP = (0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
DIRECTED = {"velocity_transmission": mp.measures.VelocityTransmission, "force_transmission": mp.measures.ForceTransmission}


@pytest.mark.slow
@pytest.mark.parametrize("name", mp.measures.available_measures())
def test_every_measure_has_its_gradient(arms, name):
    _, robot, _ = arms("double")
    measure = DIRECTED[name](direction=UP) if name in DIRECTED else name
    kinematics = robot.kinematics(mp.Task.pose(), measure=measure, compiled=False)
    q, step = samples(robot, 3, seed=8), 1e-6
    ends = [kinematics.manipulability(q + sign * step * e) for e in np.eye(robot.n) for sign in (1, -1)]
    slopes = (np.array(ends[::2]) - np.array(ends[1::2])).T / (2 * step)
    np.testing.assert_allclose(kinematics.gradient(q), slopes, rtol=1e-4, atol=1e-6)
