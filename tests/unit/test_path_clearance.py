"""The proven clearance of whole curves, against dense samples, closed forms, and what checks at 1 mrad do not see."""

import numpy as np
import pytest

import manipplan as mp
from manipplan.collision import path_clearance as continuous
from manipplan.collision.path_clearance import BodyMotion, path_clearance

BOXES = [
    mp.Box(size=(0.1, 0.1, 0.4), position=(0.45, 0.2, 0.3), name="post"),
    mp.Box(size=(0.9, 1.4, 0.05), position=(0.5, 0.0, -0.05), name="table"),
    mp.Capsule(radius=0.05, length=0.3, position=(-0.2, 0.5, 0.6), name="bar"),
]


def curve(rng, robot, degree, size=0.5):
    """A random polynomial path of moderate size in the middle of the limits."""
    centre = robot.neutral
    control = centre + size * rng.uniform(-1, 1, (1, degree + 1, robot.n))
    return mp.JointPath(breaks=[0.0, 1.0], control=control)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5", pytest.param("xarm7", marks=pytest.mark.long)])
def test_the_bound_lies_just_below_dense_samples(name, rng, request):
    robot = mp.load_robot(name) if name == "xarm7" else request.getfixturevalue(name)
    scene = mp.Scene(BOXES)
    model = scene.collision_model(robot)
    for degree in (1, 6):
        path = curve(rng, robot, degree, size=0.3)
        sampled = min(model.distances(q).min() for q in path(path.fine_samples(5e-4)))
        found = scene.path_clearance(robot, path)
        fine = scene.path_clearance(robot, path, tolerance=2e-4)
        assert found.lower <= fine.upper
        assert fine.lower <= sampled + 1e-6
        assert fine.upper >= sampled - 3e-4
        assert found.upper - found.lower <= 1e-3
        assert fine.upper - fine.lower <= 2e-4
        decided = scene.path_clearance(robot, path, clearance=max(fine.lower - 1e-3, 0.0), tolerance=None)
        assert decided.proven is (fine.lower > 1e-3)
        assert decided.refuted is not decided.proven


def cells(box, *counts):
    """A box cut into small ones."""
    ticks = [(np.arange(count) + 0.5) / count - 0.5 for count in counts]
    places = np.stack(np.meshgrid(*ticks, indexing="ij"), axis=-1).reshape(-1, 3)
    size = np.asarray(box.size)
    return [mp.Box(size=size / counts, position=box.position + size * place) for place in places]


@pytest.mark.slow
def test_a_box_cut_into_a_thousand_has_the_same_bounds(panda, rng):
    post, *others = BOXES
    whole, cut = mp.Scene(BOXES), mp.Scene([*cells(post, 8, 8, 16), *others])
    assert len(cut.collision_model(panda).pair_names) > 10_000
    several = [curve(rng, panda, degree, size=0.3) for degree in (1, 6)]
    several.append(mp.JointPath.through(curve(rng, panda, 6)(np.linspace(0.0, 1.0, 150))))  # pieces are looked at in runs
    for path in several:
        one, many = (scene.path_clearance(panda, path, tolerance=2e-4) for scene in (whole, cut))
        assert abs(one.lower - many.lower) < 2.1e-4 and abs(one.upper - many.upper) < 2.1e-4
        for clearance, proven in ((max(one.lower - 1e-3, 0.0), True), (max(one.upper + 1e-3, 0.0), False)):
            decided = cut.path_clearance(panda, path, clearance=clearance, tolerance=None)
            assert (decided.proven, decided.refuted) == ((proven, not proven) if one.lower > 1e-3 else (False, True))


def blade(tmp_path):
    """A turning arm of 0.8 m that ends in a blade of 0.1 mm."""
    file = tmp_path / "blade.urdf"
    file.write_text("""<robot name="blade"><link name="base"/><link name="b"><collision><origin xyz="0.4 0 0"/><geometry>
      <box size="0.8 0.0001 0.05"/></geometry></collision></link><joint name="turn" type="revolute"><parent link="base"/>
      <child link="b"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint></robot>""")
    return mp.load_robot(file)


def test_a_thin_plate_between_checks_at_one_milliradian_is_found(tmp_path):
    robot = blade(tmp_path)
    line = mp.JointPath.line([-0.5], [0.5])
    angles = line(line.fine_samples(1e-3))[:, 0]
    k = len(angles) // 3
    angle = (angles[k] + angles[k + 1]) / 2
    at = 0.75 * np.array([np.cos(angle), np.sin(angle)])
    plate = mp.Box(size=(0.1, 1e-4, 0.1), position=(*at, 0.0), rotation=(0.0, 0.0, angle), name="plate")
    scene = mp.Scene([plate])
    assert scene.collision_model(robot).path_is_free(line, 1e-3), "the plate must be out of sight"
    found = scene.path_clearance(robot, line, tolerance=None)
    assert found.refuted
    assert not found.proven
    assert found.at == pytest.approx((angle + 0.5), abs=5e-4)
    assert found.pair == ("b_0", "plate")
    with pytest.raises(mp.errors.InvalidInputError, match=r"initial: got .*b_0 and plate.* at s = 0\.3"):
        mp.optimize_path(
            robot,
            [-0.5],
            [0.5],
            objective=mp.PathObjective(task=mp.Task.direction((0.0, 1.0, 0.0))),
            scene=scene,
            seeding=mp.Seeding(initial=line),
        )


def test_a_sliding_ball_has_the_closed_form(tmp_path):
    file = tmp_path / "ball.urdf"
    file.write_text("""<robot name="ball"><link name="base"/><link name="b"><collision><geometry><sphere radius="0.1"/></geometry>
      </collision></link><joint name="x" type="prismatic"><parent link="base"/><child link="b"/><axis xyz="1 0 0"/>
      <limit lower="-5" upper="5" velocity="1" effort="1"/></joint></robot>""")
    robot = mp.load_robot(file)
    scene = mp.Scene([mp.Sphere(radius=0.5, position=(0.0, 0.7, 0.0), name="ball")])
    found = scene.path_clearance(robot, mp.JointPath.line([-2.0], [3.0]), tolerance=1e-4)
    assert found.lower <= 0.1 <= found.upper
    assert found.upper - found.lower <= 1e-4
    assert found.at == pytest.approx(0.4, abs=5e-3)
    for clearance, proven in ((0.0999, True), (0.1001, False)):
        decided = scene.path_clearance(robot, mp.JointPath.line([-2.0], [3.0]), clearance=clearance, tolerance=None)
        assert (decided.proven, decided.refuted) == (proven, not proven)


def test_what_slides_along_a_surface_is_given_up(tmp_path):
    """A path exactly at the clearance can be neither proven nor refuted; the search ends all the same."""
    file = tmp_path / "cube.urdf"
    file.write_text("""<robot name="cube"><link name="base"/><link name="b"><collision><geometry><box size="0.2 0.2 0.2"/></geometry>
      </collision></link><joint name="x" type="prismatic"><parent link="base"/><child link="b"/><axis xyz="1 0 0"/>
      <limit lower="-5" upper="5" velocity="1" effort="1"/></joint></robot>""")
    robot = mp.load_robot(file)
    scene = mp.Scene([mp.Box(size=(4.0, 0.2, 4.0), position=(0.0, 0.25, 0.0), name="wall")])
    found = scene.path_clearance(robot, mp.JointPath.line([-1.0], [1.0]), clearance=0.05 - 5e-6, tolerance=None)
    assert not found.proven
    assert not found.refuted
    assert found.checks <= continuous.MOST_CHECKS
    assert 0.04 < found.lower < 0.05
    wider = scene.path_clearance(robot, mp.JointPath.line([-1.0], [1.0]), clearance=0.049, tolerance=None)
    assert wider.proven


def test_a_slide_after_a_turn_counts_both(two_link_urdf, rng):
    """Motion of points of the sliding body, seen by Pinocchio, against the bound; for small changes it is nearly reached."""
    import pinocchio as pin

    robot = mp.Robot.from_urdf(two_link_urdf(), tool="tip")
    model = mp.Scene([mp.Sphere(radius=0.1, position=(2.0, 2.0, 2.0), name="ball")]).collision_model(robot)
    reach = BodyMotion(model)
    data = robot.model.createData()
    pair = next(k for k, names in enumerate(model.pair_names) if names[0].startswith("fore"))
    body = model.geometry.geometryObjects[int(reach.body[pair])]

    def place(q):
        pin.forwardKinematics(robot.model, data, q)
        return (data.oMi[body.parentJoint] * body.placement).translation.copy()

    for size in (1e-6, 0.3):
        q = robot.random_configuration(rng)
        for change in (np.array([size, 0.0]), np.array([0.0, size]), np.array([size, -size])):
            moved = np.linalg.norm(place(q + change) - place(q))
            bound = reach.motion(q[None], np.abs(change)[None], np.array([0]), np.array([pair]))[0]
            assert moved <= bound + 1e-15
            radius = body.geometry.radius if change[0] else 0.0
            if size < 1e-3 and not change.all():
                assert bound <= 1.001 * moved + radius * size


@pytest.mark.slow
def test_a_trajectory_of_many_pieces_has_the_clearance_of_its_path(demo_problem, demo_plan):
    problem, result, motion = demo_problem, demo_plan.result, demo_plan.trajectory
    assert len(motion.t) > 100
    one, many = (problem.scene.path_clearance(problem.robot, path, tolerance=3e-4) for path in (result.path, motion.path()))
    assert one.lower == pytest.approx(many.lower, abs=4e-4)
    assert one.upper == pytest.approx(many.upper, abs=4e-4)  # the path touches its clearance at several pairs, any may be named
    assert many.checks < 40 * len(motion.t), "runs of pieces are looked at as one"


@pytest.mark.slow
def test_certificate_and_report_hold_the_proof(demo_problem, demo_plan):
    certificate = demo_plan.result.certificate
    for measured, proven in (
        (certificate.clearance, certificate.proven_clearance),
        (demo_plan.report.clearance, demo_plan.report.proven_clearance),
    ):
        assert 0 < proven <= measured <= proven + 1.1e-3
    assert f"proven on the whole curve: {1e3 * certificate.proven_clearance:.2f} mm" in str(certificate)
    assert "proven on the whole motion" in str(demo_plan.report)


def test_nothing_to_check(planar):
    found = mp.Scene().path_clearance(planar.with_limits(velocity=1.0), mp.JointPath.line([0.0, 0.5, 0.5], [1.0, 0.2, 0.1]))
    if not mp.Scene().collision_model(planar).pair_names:
        assert (found.lower, found.pair, found.checks) == (np.inf, (), 0)
    assert found.proven


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"path": mp.JointPath.line([0.0], [1.0])}, "path: got .*1 joints.*7 joints"),
        ({"path": "a path"}, "path: got 'a path'; allowed: a JointPath"),
        ({"clearance": -1.0}, "clearance: got -1.0"),
        ({"clearance": np.nan}, "clearance: got nan"),
        ({"tolerance": 0.0}, "tolerance: got 0.0; allowed: .*at least 0.0001"),
    ],
)
def test_wrong_arguments(demo_problem, change, message):
    problem = demo_problem
    options = {"path": mp.JointPath.line(problem.start, problem.goal), **change}
    path = options.pop("path")
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        problem.scene.path_clearance(problem.robot, path, **options)


def test_seeds_are_proven(demo_problem):
    problem = demo_problem
    for seed in range(3):
        path = mp.seed_path(
            problem.robot, problem.start, problem.goal, problem.scene, seeding=mp.Seeding(seed=seed), clearance=0.005
        )
        model = problem.scene.collision_model(problem.robot)
        assert path_clearance(model, path, clearance=0.005, tolerance=None).proven


def test_a_tolerance_does_not_hide_what_can_be_proven(demo_problem):
    """The path is a fifth of a millimetre further away than demanded, which a bound of 1 mm alone does not tell."""
    robot, scene = demo_problem.robot, demo_problem.scene
    path = mp.seed_path(robot, demo_problem.start, demo_problem.goal, scene)
    least = scene.path_clearance(robot, path, tolerance=1e-4).lower
    demanded = max(least - 2e-4, 0.0)
    assert scene.path_clearance(robot, path, clearance=demanded).proven
    assert scene.path_clearance(robot, path, clearance=least + 2e-4).refuted


def test_a_certificate_proves_the_clearance_that_the_path_was_accepted_with(planar):
    scene = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    result = mp.optimize_path(planar, [0, 1.5, -2], [3.14, -2, 2], shape=mp.PathShape(degree=5), scene=scene, clearance=0.02)
    assert result.status.ok
    assert result.certificate.proven_clearance > 0.02
