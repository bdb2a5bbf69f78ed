"""Avoidance: the rows (A.1) against Pinocchio and coal, and what they do to a motion."""

import coal
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.tracking.bodies import CapsuleBodies
from manipplan.tracking.controller import Controller

DT = 0.01
OBSTACLES = {
    "ball": mp.Sphere(radius=0.08, position=(0.5, 0.2, 0.4), name="ball"),
    "bar": mp.Capsule(radius=0.05, length=0.5, position=(0.5, -0.3, 0.6), rotation=(0.3, 0.5, 0.1), name="bar"),
    "tube": mp.Cylinder(radius=0.05, length=0.3, position=(-0.4, 0.3, 0.7), rotation=(0.3, 0.9, 0.1), name="tube"),
    "box": mp.Box(size=(0.3, 0.2, 0.4), position=(0.4, 0.5, 0.2), rotation=(0.3, 0.5, 0.1), name="box"),
    "floor": mp.Plane(position=(0.0, 0.0, -0.1), rotation=(0.1, 0.05, 0.0), name="floor"),
}


@pytest.fixture(scope="module")
def arm():
    """Generous with accelerations."""
    return mp.planar_arm([0.4, 0.3, 0.2], radius=0.03).with_limits(lower=-2.8, upper=2.8, velocity=3.0, acceleration=400.0)


# ---- the rows


def coal_of(obstacle):
    if isinstance(obstacle, mp.Cylinder):
        return coal.Capsule(obstacle.radius, obstacle.length)
    return obstacle.shapes()[0]


def coal_capsule(robot, body, q):
    """A body as a coal capsule, and its place by Pinocchio."""
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, q)
    place = data.oMi[body.joint]
    start, end = place.act(body.start), place.act(body.end)
    length = np.linalg.norm(end - start)
    turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), end - start).matrix() if length > 0 else np.eye(3)
    return coal.Capsule(body.radius, length) if length > 0 else coal.Sphere(body.radius), turn, (start + end) / 2


def distance(first, second):
    request, result = coal.DistanceRequest(), coal.DistanceResult()
    return coal.distance(first[0], coal.Transform3s(*first[1:]), second[0], coal.Transform3s(*second[1:]), request, result)


def distances(robot, avoidance, names, q, moved):
    """Of all pairs by coal, with obstacles at the poses `moved` where these name one."""
    bodies = {body.name: body for body in CapsuleBodies.of(robot).items}
    scene = dict(zip(avoidance.scene.names, avoidance.scene.obstacles, strict=True))
    found = []
    for first, second in names:
        mine = coal_capsule(robot, bodies[first], q)
        if second in scene:
            pose = moved.get(second, scene[second].pose)
            other = coal_of(scene[second]), pose.rotation, pose.translation
        else:
            other = coal_capsule(robot, bodies[second], q)
        found.append(distance(mine, other))
    return np.array(found)


def rows(controller, q, obstacles=None):
    """Matrix (k, n) and bound (k,) of the rows, and the least distance."""
    controller.step(q, np.zeros(len(q)), np.eye(4), obstacles=obstacles)
    around = controller.defaults["obstacles"]
    n = len(q)
    memory = np.zeros(controller._step.problem.nnz_in("memory"))
    out = controller._step.problem(q, np.zeros(n), np.zeros(n), np.eye(4), 1.0, 1.0, [1.0, 1.0], around, memory)
    made = dict(zip(controller._step.problem.name_out(), out, strict=True))
    count = len(controller.pairs)
    bound = np.array(made["lba"]).ravel()[-count:]
    return np.array(made["a"])[-count:, :n], bound, controller.report.clearance


def advanced(pose, velocity, time):
    """A pose after `time` at the velocity (6,) of its origin, linear first, in the world."""
    return pin.SE3(pin.exp3(time * velocity[3:]) @ pose.rotation, pose.translation + time * velocity[:3])


@pytest.mark.slow
def test_rows_hold_the_rates_of_the_distances(panda, rng):
    """A q̇ - b is ḋ and the damper, by finite differences of coal's distances: resting, moving, and the arm's own links."""
    robot = panda
    avoidance = mp.Avoidance(
        scene=mp.Scene(list(OBSTACLES.values())),
        influence=10.0,
        security=0.02,
        damping=0.5,
        moving=["bar", "box", "ball"],
        links=["panda_link3", "panda_hand"],
    )
    controller = Controller(robot, mp.formulations.General(), dt=DT, avoidance=avoidance, compiled=False)
    assert any(second not in OBSTACLES for _, second in controller.pairs)
    step, compared = 1e-5, 0
    for q in robot.random_configuration(rng, size=4):
        poses = {each: pin.SE3(pin.exp3(rng.normal(size=3)), rng.uniform(-0.8, 0.8, 3)) for each in avoidance.moving}
        speeds = {each: rng.normal(size=6) for each in avoidance.moving}
        qd = rng.normal(size=robot.n)
        matrix, bound, least = rows(controller, q, {each: (poses[each], speeds[each]) for each in poses})
        here = distances(robot, avoidance, controller.pairs, q, poses)
        after, before = (
            distances(
                robot,
                avoidance,
                controller.pairs,
                q + time * qd,
                {each: advanced(poses[each], speeds[each], time) for each in poses},
            )
            for time in (step, -step)
        )
        rate = (after - before) / (2 * step)
        smooth = np.abs(after + before - 2 * here) < 1e-8  # the nearest points do not jump between the two
        apart = (here > 0.01) & smooth
        damper = 0.5 * (here - 0.02) / (10.0 - 0.02)
        np.testing.assert_allclose((matrix @ qd - bound)[apart], (rate + damper)[apart], atol=1e-4)
        assert least == pytest.approx(here.min(), abs=1e-5) or here.min() < 0
        compared += apart.sum()
    assert compared > 50


def test_rows_act_only_within_the_influence(arm):
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.9, 0.2, 0.0), name="ball")])
    controller = Controller(
        arm, mp.formulations.General(), dt=DT, avoidance=mp.Avoidance(scene=scene, influence=0.3), compiled=False
    )
    assert controller.pairs == (("link1_0", "ball"), ("link2_0", "ball"), ("link3_0", "ball"))
    _, bound, least = rows(controller, np.zeros(3))
    expected = np.array([np.hypot(0.5, 0.2), np.hypot(0.2, 0.2), 0.2]) - 0.08
    assert least == pytest.approx(expected.min())
    np.testing.assert_allclose(bound, np.where(expected <= 0.3, -0.5 * (expected - 0.02) / 0.28, -np.inf))


def test_a_moving_obstacle_rests_where_it_was_last(arm):
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.9, 0.2, 0.0), name="ball")])
    avoidance = mp.Avoidance(scene=scene, influence=3.0, moving=["ball"])
    controller = Controller(arm, mp.formulations.General(), dt=DT, avoidance=avoidance, compiled=False)
    _, rest, first = rows(controller, np.zeros(3))
    pose = pin.SE3(np.eye(3), np.array([0.9, 0.4, 0.0]))
    _, coming, _ = rows(controller, np.zeros(3), {"ball": (pose, [0.0, -1.0, 0.0, 0.0, 0.0, 0.0])})
    _, left, later = rows(controller, np.zeros(3))
    assert first == pytest.approx(0.2 - 0.08)
    assert later == pytest.approx(0.4 - 0.08)
    share = (np.array([0.12, 0.32]) - 0.02) / 2.98
    assert rest[2] == pytest.approx(-0.5 * share[0])
    assert coming[2] == pytest.approx(1.0 - 0.5 * share[1])
    assert left[2] == pytest.approx(-0.5 * share[1])


# ---- motion


def up_and_down(arm, start, end, count):
    """Targets on a line between two points, there and back."""
    u = 0.5 - 0.5 * np.cos(np.linspace(0, 2 * np.pi, count))
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, :2, 3] = np.asarray(start) + u[:, None] * (np.asarray(end) - start)
    return poses


@pytest.mark.parametrize("approach", [2.0, np.inf])
@pytest.mark.parametrize("stiffness", [1e2, 1e4, 1e5])
def test_clearance_stays_above_the_security_distance(arm, stiffness, approach):
    """The tool is asked to go through a ball; accelerations are generous. No stiffness buys a contact."""
    scene = mp.Scene([mp.Sphere(radius=0.08, position=(0.55, 0.35, 0.0), name="ball")])
    avoidance = mp.Avoidance(scene=scene, influence=0.2, security=0.02)
    controller = Controller(arm, mp.formulations.LogDrive(), dt=DT, avoidance=avoidance, approach=approach, compiled=False)
    q = np.array([-0.5, 1.2, 0.6])
    start = arm.kinematics().pose(q)[:2, 3]
    run = controller.rollout(q, up_and_down(arm, start, [0.55, 0.35], 400), stiffness=stiffness)
    oracle = scene.collision_model(arm)
    np.testing.assert_allclose(run["clearance"][::40], [oracle.distances(each).min() for each in run.q[:-1:40]], atol=1e-6)
    assert (run["status"] == mp.results.StepStatus.SOLVED).all()
    assert run["clearance"].min() < 0.03  # it was in the way
    assert run["clearance"].min() >= 0.02 - 1e-3


def test_a_jump_of_the_target_behind_an_obstacle_does_not_push_through_it(arm):
    scene = mp.Scene([mp.Box(size=(0.1, 0.6, 0.2), position=(0.65, 0.3, 0.0), name="wall")])
    avoidance = mp.Avoidance(scene=scene, influence=0.2, security=0.02)
    controller = Controller(arm, mp.formulations.General(), dt=DT, avoidance=avoidance, approach=np.inf, compiled=False)
    target = np.eye(4)
    target[:2, 3] = [0.85, 0.2]
    q = np.array([0.6, 1.0, 0.5])
    run = controller.rollout(q, [target] * 200, stiffness=1e5)
    assert run["clearance"].min() < 0.03
    assert run["clearance"].min() >= 0.02 - 1e-3


def test_a_ball_that_comes_is_evaded(arm):
    """0.3 m/s towards an arm that is asked to stay."""
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.8, 0.8, 0.0), name="ball")])
    avoidance = mp.Avoidance(scene=scene, influence=0.15, security=0.02, moving=["ball"])
    controller = Controller(arm, mp.formulations.LogDrive(), dt=DT, avoidance=avoidance, compiled=False)
    q, qd, least = np.array([0.2, 0.9, 0.4]), np.zeros(3), np.inf
    stay, speed = arm.kinematics().pose(q), np.array([-0.25, -0.15, 0, 0, 0, 0])
    for k in range(250):
        ball = pin.SE3(np.eye(3), np.array([0.8, 0.8, 0.0]) + k * DT * speed[:3])
        qd = controller.step(q, qd, stay, obstacles={"ball": (ball, speed)})
        q, least = q + DT * qd, min(least, controller.report.clearance)
    assert 0.02 - 1e-3 <= least < 0.1


def test_an_obstacle_in_contact_at_the_start_is_pushed_out_and_reported(arm):
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.6, 0.06, 0.0), name="ball")])
    controller = Controller(arm, mp.formulations.General(), dt=DT, avoidance=mp.Avoidance(scene=scene), compiled=False)
    stay = arm.kinematics().pose(np.zeros(3))
    run = controller.rollout(np.zeros(3), [stay] * 100)
    assert run["clearance"][0] == pytest.approx(0.06 - 0.08)
    assert run["clearance"][-1] >= 0.02 - 1e-3
    assert (np.diff(run["clearance"][:10]) > -1e-9).all()


@pytest.mark.slow
def test_the_arm_keeps_away_from_itself(panda):
    """The Panda's hand is asked to go into its own link."""
    robot = panda
    avoidance = mp.Avoidance(links=["panda_hand"], influence=0.08, security=0.02)
    controller = Controller(robot, mp.formulations.General(), dt=DT, avoidance=avoidance, compiled=False)
    assert ("panda_hand_0", "panda_link2_0") in {pair[::-1] for pair in controller.pairs} | set(controller.pairs)
    target = np.array(robot.kinematics().pose(robot.neutral))
    target[:3, 3] = [0.0, 0.0, 0.35]
    run = controller.rollout(robot.neutral, [target] * 400)
    assert run["clearance"].min() < 0.05
    assert run["clearance"].min() > 0.02 - 1e-3


def test_a_tube_gives_way_to_an_obstacle_and_says_so(arm):
    """The path runs through the ball: it is the tolerance that is exceeded."""
    scene = mp.Scene([mp.Sphere(radius=0.08, position=(0.55, 0.35, 0.0), name="ball")])
    avoidance = mp.Avoidance(scene=scene)
    tube = mp.Tolerance(position=0.01)
    controller = Controller(arm, mp.formulations.LogDrive(), dt=DT, avoidance=avoidance, tolerance=tube, compiled=False)
    q = np.array([-0.5, 1.2, 0.6])
    start = arm.kinematics().pose(q)[:2, 3]
    run = controller.rollout(q, up_and_down(arm, start, [0.55, 0.35], 400))
    k = int(run["position_deviation"].argmax())
    assert run["position_deviation"][k] > 0.08
    assert run["tube_excess"][k] > 0
    assert run["clearance"].min() >= 0.02 - 1e-3


# ---- arguments


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"influence": 0.02, "security": 0.02}, "influence: got 0.02.*above 0.02"),
        ({"influence": 0.01}, "influence: got 0.01.*above 0.02"),
        ({"security": -0.01}, "security: got -0.01.*at least 0"),
        ({"damping": 0.0}, "damping: got 0.0"),
        ({"scene": "table"}, "scene: got 'table'.*a Scene"),
        ({"moving": ["bal"]}, "moving: got 'bal'.*did you mean ball"),
        ({"influence": np.inf}, "influence: got inf"),
        ({"moving": "ball"}, "moving: got 'ball'"),
        ({"links": "panda_hand"}, "links: got 'panda_hand'"),
        ({"itself": "no"}, "itself: got 'no'"),
    ],
)
def test_what_cannot_be_avoided_raises(given, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Avoidance(**{"scene": mp.Scene([OBSTACLES["ball"]]), **given})


def test_a_mesh_is_refused(tmp_path):
    file = tmp_path / "wedge.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    with pytest.raises(mp.errors.InvalidInputError, match="scene: .*spheres, capsules, boxes, cylinders or planes"):
        mp.Avoidance(scene=mp.Scene([mp.Mesh(file=file, name="wedge")]))


def test_an_unknown_link_raises(arm):
    avoidance = mp.Avoidance(scene=mp.Scene([OBSTACLES["ball"]]), links=["link4"])
    with pytest.raises(mp.errors.UnknownNameError, match="links: got 'link4'.*link1"):
        Controller(arm, mp.formulations.General(), dt=DT, avoidance=avoidance, compiled=False)


def test_nothing_to_avoid_raises(arm):
    with pytest.raises(mp.errors.InvalidInputError, match="avoidance: .*at least one obstacle"):
        Controller(arm, mp.formulations.General(), dt=DT, avoidance=mp.Avoidance(itself=False), compiled=False)


def test_an_arm_without_shapes_raises():
    from chains import chain

    avoidance = mp.Avoidance(scene=mp.Scene([OBSTACLES["ball"]]))
    with pytest.raises(mp.errors.InvalidInputError, match="avoidance: got 'random'.*collision geometry"):
        Controller(chain(0, [False] * 6), mp.formulations.General(), dt=DT, avoidance=avoidance, compiled=False)


def test_unguarded_pairs_are_named_with_their_reason(panda):
    avoidance = mp.Avoidance(links=["panda_hand"])
    controller = Controller(panda, mp.formulations.General(), dt=DT, avoidance=avoidance, compiled=False)
    assert controller.unguarded
    assert not set(controller.unguarded) & set(controller.pairs)
    assert all(reason for reason in controller.unguarded.values())
