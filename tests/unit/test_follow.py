"""follow: a workspace path in, a timed motion out, judged here by Pinocchio, singular values and coal alone."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.paths.cartesian import CartesianPath

FEW = {"samples": 48, "epsilon": 0.5}
#: What `follow` keeps to where no tolerance is given [m, rad].
BETWEEN = (1e-4, 1e-3)


def moved(pose, by):
    matrix = np.array(pose)
    matrix[:3, 3] += by
    return matrix


@pytest.fixture(scope="module")
def start(panda):
    return np.array(panda.kinematics().pose(panda.neutral))


@pytest.fixture(scope="module")
def line(start):
    return CartesianPath.line(start, moved(start, [0.1, 0.25, -0.1]))


def motion(robot, plan, count=1201):
    """Times, configurations, tool poses and Jacobians along the finished trajectory, by Pinocchio alone."""
    t = np.linspace(0.0, plan.trajectory.duration, count)
    q = plan.trajectory(t)
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    poses, jacobians = [], []
    for each in q:
        jacobians.append(pin.computeFrameJacobian(robot.model, data, each, frame, pin.LOCAL_WORLD_ALIGNED))
        pin.framesForwardKinematics(robot.model, data, each)
        poses.append(data.oMf[frame].homogeneous.copy())
    return t, q, np.array(poses), np.array(jacobians)


def assert_followed(robot, plan, *, scene=None, clearance=0.0, axis=None, index=True, least_length=0.5):
    """The plan's own promises; returns the tool poses, to be compared with the analytic path."""
    assert plan.status is mp.Status.FOLLOWED and plan.status.ok and plan.message == ""
    assert plan.report.passed and plan.report.collision_free and plan.report.goal_error < 1e-6
    t, q, poses, jacobians = motion(robot, plan)
    limits = robot.limits
    assert not (limits.outside(q) > 1e-6).any()
    assert (np.abs(plan.trajectory(t, 1)) <= limits.velocity * (1 + 1e-6)).all()
    assert (np.abs(plan.trajectory(t, 2)) <= limits.acceleration * (1 + 1e-6)).all()
    np.testing.assert_allclose(plan.trajectory(t[[0, -1]], 1), 0, atol=1e-9)
    model = (scene or mp.Scene()).collision_model(robot)
    assert not any(model.in_collision(each, clearance=max(clearance - 1e-6, 0)) for each in q[::3])
    weights = np.array([1.0] * 3 + [0.5] * 3)[:, None]
    rows = weights * jacobians
    if axis is not None:
        basis = np.linalg.svd(np.array(axis)[None])[2][1:]
        across = 0.5 * basis @ np.swapaxes(poses[:, :3, :3], 1, 2) @ jacobians[:, 3:]
        rows = np.concatenate([jacobians[:, :3], across], axis=1)
    values = np.linalg.svd(rows, compute_uv=False).prod(axis=1)
    assert plan.report.min_manipulability == pytest.approx(values.min(), rel=1e-3)
    assert plan.report.min_manipulability <= values.min() * (1 + 1e-9)
    assert plan.refinement.refined >= plan.search.minimum * (1 - 1e-8)
    return poses


def angles(one, other):
    return np.array([np.linalg.norm(pin.log3(a.T @ b)) for a, b in zip(one, np.broadcast_to(other, one.shape), strict=True)])


def assert_along_line(poses, begin, end, position, rotation):
    """On the straight line between two points with one rotation, from one end to the other, never far back."""
    way = (end - begin)[:3, 3]
    share = (poses[:, :3, 3] - begin[:3, 3]) @ way / (way @ way)
    off = poses[:, :3, 3] - begin[:3, 3] - np.clip(share, 0, 1)[:, None] * way
    assert np.linalg.norm(off, axis=1).max() <= position
    assert angles(poses[:, :3, :3], begin[:3, :3]).max() <= rotation
    slack = 2 * position / np.linalg.norm(way)
    assert abs(share[0]) <= slack and abs(share[-1] - 1) <= slack
    assert np.diff(share).min() >= -slack


# ---- what is followed


@pytest.mark.slow
def test_a_line(panda, start, line):
    told = []
    plan = mp.follow(panda, line, positions=8, **FEW, progress=lambda share, text: told.append((share, text)))
    poses = assert_followed(panda, plan)
    assert_along_line(poses, start, line.end, *BETWEEN)
    shares = [share for share, _ in told]
    assert shares == sorted(shares) and shares[-1] == 1.0 and told[-1][1] == "done"
    assert plan.deviation.position < BETWEEN[0] and plan.deviation.rotation < BETWEEN[1]
    assert plan.workspace_path is line
    assert (plan.tolerance.position, plan.tolerance.rotation) == BETWEEN
    assert plan.report.min_manipulability > 0.9 * plan.refinement.refined
    np.testing.assert_allclose(plan.path(0.0), plan.refinement.q[0], atol=1e-12)


@pytest.mark.slow
def test_a_circle_ends_as_it_began(panda, start):
    centre = moved(start, [0, 0, -0.1])[:3, 3]
    plan = mp.follow(panda, CartesianPath.circle(start, centre, [1, 0, 0]), positions=10, closed=True, **FEW)
    poses = assert_followed(panda, plan)
    np.testing.assert_allclose(plan.trajectory.q[-1], plan.trajectory.q[0], atol=1e-6)
    spoke = poses[:, :3, 3] - centre
    assert np.abs(spoke[:, 0]).max() < BETWEEN[0]
    assert np.abs(np.linalg.norm(spoke[:, 1:], axis=1) - 0.1).max() < BETWEEN[0]
    turned = np.unwrap(np.arctan2(spoke[:, 2], spoke[:, 1]))
    assert turned[-1] - turned[0] == pytest.approx(2 * np.pi, abs=2e-3)
    assert np.diff(turned).min() > -2e-3
    assert angles(poses[:, :3, :3], start[:3, :3]).max() < BETWEEN[1]


@pytest.mark.slow
def test_a_seam_whose_torch_may_turn(panda, start, line):
    plan = mp.follow(
        panda, line, positions=6, samples=(16, 10), epsilon=0.7, objective=mp.PathObjective(task=mp.Task.pointing())
    )
    poses = assert_followed(panda, plan, axis=(0, 0, 1))
    free = np.array(poses)
    free[:, :3, :3] = start[:3, :3]  # the axis is judged alone
    assert_along_line(free, start, line.end, *BETWEEN)
    lean = np.linalg.norm(np.cross(poses[:, :3, 2], start[:3, 2]), axis=1)
    assert lean.max() < BETWEEN[1]
    assert angles(poses[:, :3, :3], start[:3, :3]).max() > 0.01


@pytest.mark.slow
@pytest.mark.parametrize(
    ("task", "fixed"),
    [
        (mp.Task.position(), np.eye(3)),
        (mp.Task.custom(np.eye(6)[[0, 1, 3, 4, 5]], name="height free"), np.eye(3)[:2]),
        (mp.Task.planar(), np.eye(3)[:2]),
    ],
    ids=["position", "height free", "planar"],
)
def test_rows_that_a_task_leaves_free_are_used(panda, start, line, task, fixed):
    """Pinocchio judges what is fixed; the manipulability is above that of the same path with whole poses."""
    plan = mp.follow(panda, line, positions=6, objective=mp.PathObjective(task=task))
    assert plan.report.passed and plan.report.task == task.name
    t = np.linspace(0.0, plan.trajectory.duration, 400)
    data, frame = panda.model.createData(), panda.model.getFrameId(panda.tool)
    poses = []
    for q in plan.trajectory(t):
        pin.framesForwardKinematics(panda.model, data, q)
        poses.append(data.oMf[frame].homogeneous.copy())
    poses = np.array(poses)
    way = fixed @ (line.end - line.start)[:3, 3]
    off = (poses[:, :3, 3] - line.start[:3, 3]) @ fixed.T
    share = off @ way / (way @ way)
    assert np.linalg.norm(off - share[:, None] * way, axis=1).max() < BETWEEN[0]
    assert abs(share[0]) < 1e-6 and abs(share[-1] - 1) < 1e-6 and np.diff(share).min() > -1e-6
    if task.name == "height free":
        assert angles(poses[:, :3, :3], start[:3, :3]).max() < BETWEEN[1]
    free = np.abs(poses - line(np.linspace(0, 1, 400)))
    assert free.max() > 0.02
    whole = mp.follow(panda, line, positions=6)
    minimum = panda.kinematics(task).manipulability(whole.trajectory(t)).min()
    assert plan.report.min_manipulability > 1.02 * minimum


def test_a_task_that_fixes_no_poses_is_refused_at_once(panda, line):
    with pytest.raises(mp.errors.InvalidInputError, match="task: got 'rotation'"):
        mp.follow(panda, line, objective=mp.PathObjective(task=mp.Task.rotation([0, 0, 1])))


@pytest.mark.slow
@pytest.mark.parametrize("task", [mp.Task.position(), mp.Task.pointing()], ids=["position", "pointing"])
def test_an_arm_of_five_joints_follows_what_counts(task):
    arm = mp.load_robot("so100")
    q = np.linspace([0.0, 0.6, -0.8, 0.5, 0.3], [0.3, 0.9, -0.5, 0.8, 0.6], 8)
    poses = arm.kinematics().pose(q)
    plan = mp.follow(arm, CartesianPath.through(poses), positions=12, objective=mp.PathObjective(task=task))
    assert plan.report.passed
    reached = arm.kinematics().pose(plan.path(plan.workspace_path.knots))
    assert np.abs(reached[:, :3, 3] - poses[:, :3, 3]).max() < 1e-4
    if task.name == "pointing":
        assert np.abs(reached[:, :3, 2] - poses[:, :3, 2]).max() < 1e-3
    best = mp.max_min_search(mp.sample_layers(arm, plan.workspace_path, 12, task=task), 0.2).minimum
    assert plan.report.min_manipulability > 0.95 * best > 0


def test_an_arm_with_fewer_joints_than_rows_is_refused():
    arm = mp.load_robot("so100")
    path = CartesianPath.through(arm.kinematics().pose(np.linspace(arm.neutral, arm.neutral + 0.3, 4)))
    with pytest.raises(
        mp.errors.InvalidInputError, match="measure: got 'yoshikawa'; allowed: at most as many task rows as joints"
    ):
        mp.follow(arm, path, objective=mp.PathObjective(task=mp.Task.pose()))
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"objective: .*a task of at most 5 rows.*Task.position\(\) or.*Task.pointing\(axis\)"
    ):
        mp.follow(arm, path)


@pytest.mark.slow
def test_a_path_that_is_singular_everywhere_is_refused():
    """The SO-100 turns its tool about y with three parallel joints: the direction of that axis is no row of its own."""
    arm = mp.load_robot("so100")
    begin = arm.kinematics(mp.Task.pose(length=1.0)).pose([0.0, 1.6, -1.6, -0.3, 0.2])
    end = begin.copy()
    end[1:3, 3] += 0.02
    objective = mp.PathObjective(task=mp.Task.pointing([0, 1, 0]))
    with pytest.raises(
        mp.errors.InvalidInputError, match="objective: got 'pointing'; allowed: a task whose rows are independent"
    ):
        mp.follow(arm, CartesianPath.line(begin, end), positions=5, objective=objective)


@pytest.mark.slow
def test_poses_that_one_configuration_meets_are_told(panda, line):
    with pytest.raises(
        mp.errors.InvalidInputError, match="objective: got 'orientation'; allowed: a task for which the arm has to move"
    ):
        mp.follow(panda, line, positions=4, objective=mp.PathObjective(task=mp.Task.orientation()))


@pytest.mark.slow
@pytest.mark.parametrize("task", [mp.Task.position(), mp.Task.pointing([0, 0, 1])], ids=["position", "pointing"])
def test_a_start_at_the_first_pose_of_free_rows(panda, task):
    """The start is no sample: samples around its parameters connect it."""
    rng = np.random.default_rng(4)
    for _ in range(3):
        q = panda.neutral + rng.uniform(-0.3, 0.3, 7)
        pose = panda.kinematics().pose(q)
        end = pose.copy()
        end[:3, 3] += 0.05
        plan = mp.follow(panda, CartesianPath.line(pose, end), start=q, objective=mp.PathObjective(task=task))
        assert plan.report.passed and np.abs(plan.trajectory.q[0] - q).max() < 1e-9 and plan.path_begin == 0.0


@pytest.mark.slow
def test_a_seam_on_a_cylinder_with_a_turning_torch(panda, start):
    """The path itself turns about the free axis: that part of its rotation neither counts nor misleads."""
    centre = moved(start, [0, 0.1, 0])[:3, 3]
    path = CartesianPath.circle(start, centre, [0, 0, 1], 1.5, turning=True)
    plan = mp.follow(
        panda, path, positions=6, samples=(16, 10), epsilon=0.9, objective=mp.PathObjective(task=mp.Task.pointing())
    )
    poses = assert_followed(panda, plan, axis=(0, 0, 1))
    spoke = poses[:, :3, 3] - centre
    assert np.abs(np.linalg.norm(spoke[:, :2], axis=1) - 0.1).max() < BETWEEN[0]


@pytest.mark.slow
@pytest.mark.parametrize("n", [3, 8])
def test_a_tolerance_is_used_and_kept(panda, start, line, n):
    """Also where few positions leave a spline that would leave the tube between them."""
    exact = mp.follow(panda, line, positions=n, samples=48, epsilon=1.0)
    plan = mp.follow(panda, line, positions=n, samples=48, epsilon=1.0, tolerance=mp.Tolerance(position=0.01, rotation=0.1))
    poses = assert_followed(panda, plan)
    assert_along_line(poses, start, line.end, 0.01, 0.1)
    assert plan.deviation.position > 1e-3
    assert plan.refinement.refined > exact.refinement.refined


@pytest.mark.slow
def test_a_tolerance_of_rotation_alone_leaves_the_position_as_it_is(panda, start, line):
    plan = mp.follow(panda, line, positions=4, samples=48, epsilon=1.0, tolerance=mp.Tolerance(rotation=0.05))
    poses = assert_followed(panda, plan)
    assert_along_line(poses, start, line.end, BETWEEN[0], 0.05)
    assert angles(poses[:, :3, :3], start[:3, :3]).max() > 0.01


def wave_of(robot, q):
    """A wave of the tool, 28 cm long, from where it is at q."""
    poses = np.repeat(robot.kinematics(mp.Task.pose()).pose(q)[None], 60, axis=0)
    u = np.linspace(0, 1, 60)
    poses[:, :3, 3] += 0.28 * (np.outer(u, [0.0, 1.0, 0.0]) + 0.15 * np.outer(np.sin(4 * np.pi * u), [0.6, 0.0, 0.8]))
    return mp.CartesianPath.through(poses)


@pytest.mark.slow
@pytest.mark.parametrize("begins", ["where it is best", "at a start"])
@pytest.mark.parametrize("arm", ["panda", "ur5"])
def test_a_wide_tolerance_is_searched(arm, begins, request):
    """By the judge the tool keeps it, and the minimum is at least that of the path itself and of the box about its poses."""
    robot = request.getfixturevalue(arm)
    if arm == "ur5":
        robot = robot.with_limits(lower=-np.pi, upper=np.pi)
    task = mp.Task.pose() if arm == "panda" else mp.Task.pointing([0, 0, 1])
    q = np.array([0, -0.5, 0, -2.2, 0, 1.8, 0.7] if arm == "panda" else [0.2, -1.4, 1.9, -2.0, -1.5, 0.3])
    path, tube = wave_of(robot, q), mp.Tolerance(position=0.01, rotation=0.08)
    start, objective = None if begins == "where it is best" else q, mp.PathObjective(task=task)
    plan = mp.follow(robot, path, start=start, objective=objective, tolerance=tube)
    exact = mp.follow(robot, path, start=start, objective=objective)
    box = {"rotation": 0.85 * 0.08 / np.sqrt(3)} if arm == "panda" else {"cone": 0.85 * 0.08}
    region = mp.PathObjective(task=task.within(position=0.0085 / np.sqrt(3), **box))
    assert plan.report.passed and plan.tolerance == tube
    assert plan.report.min_manipulability >= (1.01 if start is None else 1.0) * exact.report.min_manipulability
    assert (
        plan.report.min_manipulability
        >= 0.999 * mp.follow(robot, path, start=start, objective=region).report.min_manipulability
    )
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool, pin.FrameType.BODY)
    [part] = plan.report.along
    for share in np.linspace(0.0, 1.0, 300):
        s = part.begin + share * (part.end - part.begin)
        pin.forwardKinematics(robot.model, data, plan.trajectory(s))
        tool = pin.updateFramePlacement(robot.model, data, frame).homogeneous
        near = path(np.linspace(0, 1, 2000))
        off = np.linalg.norm(near[:, :3, 3] - tool[:3, 3], axis=1) / 0.01
        turned = (
            angles(near[:, :3, :3], tool[:3, :3]) if arm == "panda" else np.arccos(np.clip(near[:, :3, 2] @ tool[:3, 2], -1, 1))
        )
        assert np.maximum(off, turned / 0.08).min() < 1.01


@pytest.mark.slow
@pytest.mark.parametrize("tube", [mp.Tolerance(position=0.01), mp.Tolerance(rotation=0.1)], ids=["position", "rotation"])
def test_a_wide_tolerance_of_one_part_with_a_free_axis(panda, line, tube):
    objective = mp.PathObjective(task=mp.Task.pointing([0, 0, 1]))
    plan = mp.follow(panda, line, positions=4, objective=objective, tolerance=tube)
    assert plan.report.passed
    assert plan.deviation.excess(mp.Tolerance(position=tube.position or 1e-4, rotation=tube.rotation or 1e-3), "time") == ""


@pytest.mark.slow
def test_a_wide_tolerance_reaches_a_path_that_is_a_little_too_far(panda):
    begin = panda.kinematics().pose(np.array([0.0, 0.8, 0.0, -0.4, 0.0, 1.2, 0.78]))
    while len(mp.inverse_kinematics(panda, begin).q):
        begin[0, 3] += 0.002
    end = begin.copy()
    end[1, 3] += 0.02
    path = mp.CartesianPath.line(begin, end)
    with pytest.raises(mp.errors.OutOfReachError):
        mp.follow(panda, path)
    with pytest.raises(mp.errors.OutOfReachError):
        mp.follow(panda, path, tolerance=mp.Tolerance(position=0.001))
    plan = mp.follow(panda, path, tolerance=mp.Tolerance(position=0.02, rotation=0.05))
    assert plan.report.passed and plan.deviation.position < 0.02


@pytest.mark.slow
def test_an_obstacle_beside_the_path_is_missed_by_the_clearance(panda, start, line):
    """A ball where the free plan's elbow passes."""
    free = mp.follow(panda, line, positions=6, **FEW)
    data = panda.model.createData()
    pin.forwardKinematics(panda.model, data, free.trajectory(free.trajectory.duration / 2))
    scene = mp.Scene([mp.Sphere(radius=0.06, position=data.oMi[4].translation.copy(), name="ball")])
    assert scene.in_collision(panda, free.trajectory(free.trajectory.duration / 2))
    plan = mp.follow(panda, line, positions=6, scene=scene, clearance=0.02, **FEW)
    poses = assert_followed(panda, plan, scene=scene, clearance=0.02)
    assert_along_line(poses, start, line.end, *BETWEEN)
    assert plan.report.clearance >= 0.02 - 1e-6


@pytest.mark.slow
def test_six_joints_and_torque(ur5):
    begin = ur5.kinematics().pose([0.3, -1.2, 1.4, -1.0, -1.2, 0.4])
    path = CartesianPath.line(begin, moved(begin, [0.05, 0.15, 0.05]))
    plan = mp.follow(ur5, path, positions=5, epsilon=0.5, torque=True)
    poses = assert_followed(ur5, plan)
    assert_along_line(poses, begin, path.end, *BETWEEN)
    assert 0 < plan.report.limits["torque"].ratio <= 1 + 1e-6


@pytest.mark.slow
def test_two_positions_are_enough_for_a_winding_path(panda, start):
    """Both positions are the same pose: the way between them is made of knots, and it is the whole circle."""
    centre = moved(start, [0, 0, -0.08])[:3, 3]
    plan = mp.follow(panda, CartesianPath.circle(start, centre, [1, 0, 0]), positions=2, **FEW)
    poses = assert_followed(panda, plan)
    spoke = poses[:, 1:3, 3] - centre[1:]
    assert np.abs(np.linalg.norm(spoke, axis=1) - 0.08).max() < BETWEEN[0]
    turned = np.unwrap(np.arctan2(spoke[:, 1], spoke[:, 0]))
    assert turned[-1] - turned[0] == pytest.approx(2 * np.pi, abs=3e-3)


@pytest.mark.slow
def test_a_tool_that_only_turns(panda, start):
    end = np.array(start)
    end[:3, :3] = start[:3, :3] @ pin.exp3(np.array([0.0, 0.3, 0.6]))
    plan = mp.follow(panda, CartesianPath.line(start, end), positions=4, **FEW)
    poses = assert_followed(panda, plan)
    assert np.linalg.norm(poses[:, :3, 3] - start[:3, 3], axis=1).max() < BETWEEN[0]
    assert angles(poses[-1:, :3, :3], end[:3, :3]).max() < BETWEEN[1]


@pytest.mark.slow
def test_the_measure_of_the_objective_is_what_counts(panda, start, line):
    """Its minimum is the largest among the samples and is raised further, by singular values of Pinocchio's Jacobians alone."""

    def inverse_condition(jacobians):
        values = np.linalg.svd(np.array([1.0] * 3 + [0.5] * 3)[:, None] * jacobians, compute_uv=False)
        return values.min(axis=-1) / values.max(axis=-1)

    def least(q):
        data, frame = panda.model.createData(), panda.model.getFrameId(panda.tool)
        jacobians = [pin.computeFrameJacobian(panda.model, data, each, frame, pin.LOCAL_WORLD_ALIGNED).copy() for each in q]
        return inverse_condition(np.array(jacobians)).min()

    usual = mp.follow(panda, line, positions=8, **FEW)
    objective = mp.PathObjective(measure="inverse_condition", power=2.0, metric=np.arange(1.0, 8.0))
    plan = mp.follow(panda, line, positions=8, objective=objective, **FEW)
    assert plan.status is mp.Status.FOLLOWED
    assert plan.search.minimum == pytest.approx(least(plan.search.q), rel=1e-6)
    assert plan.search.minimum > 1.001 * least(usual.search.q)
    assert usual.search.minimum > panda.kinematics().manipulability(plan.search.q).min()
    assert plan.refinement.refined >= plan.search.minimum * (1 - 1e-8)
    t, _, poses, jacobians = motion(panda, plan)
    assert_along_line(poses, start, line.end, *BETWEEN)
    assert plan.report.measure == plan.result.measure.name == "inverse_condition"
    assert plan.report.min_manipulability == pytest.approx(inverse_condition(jacobians).min(), rel=1e-3)
    speed = np.sqrt(plan.trajectory(t, 1) ** 2 @ np.arange(1.0, 8.0))  # power and metric count in the g that is reported
    assert plan.report.g == pytest.approx(np.trapezoid(speed / inverse_condition(jacobians) ** 2, t), rel=1e-3)


# ---- what is not


@pytest.mark.slow
def test_steps_too_small_to_connect(panda, line):
    plan = mp.follow(panda, line, positions=4, samples=8, epsilon=0.01, throw=False)
    assert plan.status is mp.Status.NOT_CONNECTED and not plan.status.has_path
    assert plan.trajectory is None and plan.report is None
    smallest = plan.search.smallest_epsilon
    assert smallest.shape == (7,) and (smallest > 0.01).all()
    assert f"{smallest[0]:.6g}" in plan.message and "position" in plan.message
    with pytest.raises(mp.errors.PlanningError, match="no trajectory to save"):
        plan.save("nowhere")
    with pytest.raises(mp.errors.PlanningError, match="can be reached from position") as caught:
        mp.follow(panda, line, positions=4, samples=8, epsilon=0.01)
    assert type(caught.value.result) is mp.results.PartialPlan
    assert caught.value.result.status is mp.Status.NOT_CONNECTED
    again = mp.follow(panda, line, positions=4, samples=8, epsilon=1.001 * smallest, throw=False)
    assert again.search.connected


@pytest.mark.slow
def test_a_path_out_of_reach_between_its_positions(panda, start):
    """Both ends are reached, the middle a metre further is not: a position that is added tells."""
    path = CartesianPath.through([start, moved(start, [1.0, 0, 0]), moved(start, [0, 0.1, 0])])
    with pytest.raises(mp.errors.OutOfReachError, match=r"^path, s = 0\.5: got .* the arm stays 5\d\d\.?\d* mm"):
        mp.follow(panda, path, positions=2, throw=False, **FEW)


class OutAndBack(CartesianPath):
    """Straight out along x, and back."""

    def __init__(self, pose, far):
        self.pose, self.far = pose, far

    def _at(self, s):
        positions = self.pose[:3, 3] + np.outer(self.far * (1 - np.abs(2 * s - 1)), [1, 0, 0])
        return positions, np.tile(self.pose[:3, :3], (len(s), 1, 1))


@pytest.mark.slow
def test_a_motion_that_would_turn_back_early(panda, start):
    """No position lies at the far end, and each pose of a spline that turns back before it is near the path."""
    tube = mp.Tolerance(position=0.01, rotation=0.1)
    plan = mp.follow(panda, OutAndBack(start, 0.15), positions=4, samples=48, epsilon=1.0, tolerance=tube)
    poses = assert_followed(panda, plan)
    assert poses[:, 0, 3].max() - start[0, 3] > 0.14
    with pytest.raises(mp.errors.OutOfReachError, match="^path, s = 0"):
        mp.follow(panda, OutAndBack(start, 1.0), positions=2, throw=False, **FEW)


def test_positions_inside_an_obstacle(panda, start, line):
    scene = mp.Scene([mp.Sphere(radius=0.05, position=line(0.5)[:3, 3], name="ball")])
    named = r"path, position [12] of 0 to 4 .* reach it, and in the best of them panda_\w+ and ball (overlap by|are) [\d.]+ mm"
    with pytest.raises(mp.errors.InvalidInputError, match=named + ".*; needed: no collision and 0.1 mm to spare"):
        mp.follow(panda, line, positions=5, scene=scene, **FEW)
    with pytest.raises(mp.errors.InvalidInputError, match=named + ".*; needed: clearance 20 mm and 0.1 mm to spare"):
        mp.follow(panda, line, positions=5, scene=scene, clearance=0.02, **FEW)


@pytest.mark.slow
def test_an_obstacle_between_positions_fails_the_check(panda, start, line):
    """Thin enough to stand between two positions: candidates are free, the motion between them is not."""
    scene = mp.Scene([mp.Sphere(radius=0.01, position=line(0.5)[:3, 3], name="bead")])
    plan = mp.follow(panda, line, positions=2, scene=scene, throw=False, **FEW)
    assert plan.status is mp.Status.CHECK_FAILED
    assert not plan.report.collision_free and not plan.report.passed


def test_a_path_without_length(panda, start):
    with pytest.raises(mp.errors.InvalidInputError, match="a path with a length of at least"):
        mp.follow(panda, CartesianPath.line(start, start), positions=2, **FEW)


@pytest.mark.slow
def test_limits_that_gravity_exceeds(panda, line):
    weak = panda.with_limits(effort=np.array([87.0, 3.0, 87, 87, 12, 12, 12]))
    plan = mp.follow(weak, line, positions=4, torque=True, throw=False, **FEW)
    assert plan.status is mp.Status.NO_TIMING
    assert plan.path is not None and "gravity alone loads" in plan.message


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"robot": "panda"}, "robot: got 'panda'"),
        ({"robot": None}, "robot: got None"),
        ({"path": "path.csv"}, "path: got 'path.csv'"),
        ({"path": np.eye(4)}, "path: .*a CartesianPath"),
        ({"path": [np.eye(4)] * 2, "positions": None}, "path: .*a CartesianPath"),
        ({"path": None, "positions": None}, "path: got None"),
        ({"path": CartesianPath.line(np.eye(4), np.eye(4)), "positions": None}, "path: got 'a path of 0 m'.*the tool moves"),
        ({"positions": 1}, "positions: got 1"),
        ({"positions": -5}, "positions: got -5"),
        ({"positions": "50"}, "positions: got '50'"),
        ({"epsilon": 0.0}, "epsilon: got 0.0"),
        ({"epsilon": -0.1}, "epsilon: got -0.1"),
        ({"epsilon": np.nan}, "epsilon: got nan"),
        ({"epsilon": "0.1"}, "epsilon: got '0.1'"),
        ({"epsilon": None}, "epsilon: got None"),
        ({"epsilon": 4.0}, "epsilon: got 4.0; allowed: below π"),
        ({"epsilon": [0.1] * 6}, "epsilon: .*7 of them"),
        ({"objective": 1.0}, "objective: got 1.0; allowed: a PathObjective"),
        ({"objective": None}, "objective: got None; allowed: a PathObjective"),
        ({"objective": {"task": "pose"}}, "task: got 'pose'"),
        ({"objective": {"task": mp.Task.rotation([0, 0, 1])}}, "task: got 'rotation'"),
        ({"samples": 0}, "samples: got 0"),
        ({"samples": "all"}, "samples: got 'all'"),
        ({"samples": (10, 10)}, "samples: .*one for each of"),
        ({"tolerance": 0.01}, "tolerance: got 0.01"),
        ({"scene": "scene.yaml"}, "scene: got 'scene.yaml'"),
        ({"clearance": -1.0}, "clearance: got -1.0"),
        ({"clearance": "1 mm"}, "clearance: got '1 mm'"),
        ({"closed": 1}, "closed: got 1"),
        ({"closed": True}, "the path's last pose is not its first"),
        ({"torque": "yes"}, "torque: got 'yes'"),
        ({"throw": None}, "throw: got None"),
        ({"executor": "threads"}, "executor: got 'threads'"),
        ({"seeding": 3}, "seeding: got 3"),
        ({"progress": "bar"}, "progress: got 'bar'"),
    ],
)
def test_wrong_arguments_raise_before_work_starts(panda, line, change, message):
    told = []
    arguments = {
        "robot": panda,
        "path": line,
        "positions": 3,
        "throw": False,
        "progress": lambda *notify: told.append(notify),
        **change,
    }
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        if isinstance(arguments.get("objective"), dict):
            arguments["objective"] = mp.PathObjective(**arguments["objective"])
        mp.follow(**{**FEW, **arguments})
    assert told == []


@pytest.mark.parametrize(
    ("objective", "message"),
    [
        (
            mp.PathObjective(measure="condition_number"),
            "measure: got 'condition_number'; allowed: a measure that is at least zero",
        ),
        (mp.PathObjective(metric=[1.0, 2.0]), "metric: got"),
    ],
)
def test_objectives_that_do_not_fit_are_refused_before_the_work(panda, line, objective, message):
    told = []
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.follow(panda, line, objective=objective, progress=lambda *each: told.append(each))
    assert told == []


@pytest.mark.slow
@pytest.mark.parametrize("links", [2, 4])
def test_planar_arms_of_any_number_of_links(links):
    arm = mp.planar_arm([0.3] * links)
    start = arm.kinematics().pose(np.linspace(0.4, 0.9, links))
    end = start.copy()
    end[:2, 3] += [-0.1, 0.1]
    plan = mp.follow(arm, CartesianPath.line(start, end), positions=12, objective=mp.PathObjective(task=mp.Task.planar()))
    assert plan.report.passed
    reached = arm.kinematics().pose(plan.trajectory(np.linspace(0, plan.trajectory.duration, 200)))[:, :2, 3]
    across = np.array([1.0, 1.0]) / np.sqrt(2)
    assert np.abs((reached - start[:2, 3]) @ across).max() < BETWEEN[0]
    assert np.abs(reached[-1] - end[:2, 3]).max() < 1e-6


GAP = """<robot name="gap"><link name="base"/>
  <link name="l1"/><link name="l2"><collision><origin xyz="0.15 0 0"/><geometry><box size="0.2 0.06 0.06"/></geometry></collision></link>
  <link name="l3"/><link name="collar"><collision><geometry><cylinder radius="0.03" length="0.1"/></geometry></collision></link>
  <joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0 0 0.4"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" velocity="2" effort="1"/></joint>
  <joint name="j2" type="revolute"><parent link="l1"/><child link="l2"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" velocity="2" effort="1"/></joint>
  <joint name="j3" type="revolute"><parent link="l2"/><child link="l3"/><origin xyz="0.282 0 0"/><axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" velocity="2" effort="1"/></joint>
  <joint name="c" type="fixed"><parent link="l3"/><child link="collar"/><origin rpy="1.5707963267948966 0 0"/></joint>
  <joint name="t" type="fixed"><parent link="l3"/><child link="tool"/><origin xyz="0.3 0 0"/></joint><link name="tool"/></robot>"""


@pytest.mark.slow
def test_a_gap_that_no_motion_widens(tmp_path):
    """A collar turns 2 mm before the link that carries it, as on a wrist: less than candidates keep elsewhere."""
    (tmp_path / "gap.urdf").write_text(GAP)
    robot = mp.Robot.from_urdf(tmp_path / "gap.urdf", tool="tool")
    model = mp.Scene().collision_model(robot)
    [apart] = {round(float(model.distances(q)[0]), 9) for q in robot.random_configuration(np.random.default_rng(1), size=20)}
    assert apart == 0.002
    begin = robot.kinematics().pose(np.array([0.2, -0.5, 1.2]))
    path = CartesianPath.line(begin, moved(begin, [-0.1, 0.05, 0.0]))
    keep = {"objective": mp.PathObjective(task=mp.Task.position())}
    plan = mp.follow(robot, path, **keep)
    assert plan.status is mp.Status.FOLLOWED and plan.report.passed
    assert mp.follow(robot, path, clearance=0.0015, **keep).report.passed
    with pytest.raises(mp.errors.InvalidInputError, match="are 2 mm apart; needed: clearance 2.5 mm"):
        mp.follow(robot, path, clearance=0.0025, **keep)
