"""All inverse kinematics of a pose: nothing is missed, nothing is wrong, and what is not certain says so."""

import os
import subprocess
import sys
import time

import numpy as np
import pinocchio as pin
import pytest
from scipy.optimize import minimize

import manipplan as mp
from manipplan.ik.bridge import SKEW, arrangement, swivels_of
from manipplan.ik.form import closed_form
from manipplan.ik.solver import Solver
from manipplan.support.kernel_library import find_library

CLOSED = {
    "panda": "spherical",
    "panda_collision": "spherical",
    "ur3": "parallel",
    "ur5": "parallel",
    "ur10": "parallel",
    "xarm7": "spherical",
    "kinova": "spherical",
    "z1": "parallel",
    "talos_right_arm": "spherical",
    "talos_torso_right_arm": "spherical",
    "simple_humanoid_right_arm": "swivel",
    "tiago": "spherical",
    "icub": "swivel",
}
#: Further arms of the catalogue with closed forms: other sides, other grippers, other limits.
FURTHER = {
    **dict.fromkeys(("ur3_gripper", "ur3_limited", "ur5_gripper", "ur5_limited", "ur10_limited", "b1_z1"), "parallel"),
    **dict.fromkeys(("anymal_kinova", "talos_left_arm", "tiago_no_hand"), "spherical"),
    **dict.fromkeys(("pr2_left_arm", "pr2_right_arm", "centauro_left_arm", "centauro_right_arm"), "spherical"),
    **dict.fromkeys(("simple_humanoid_left_arm", "romeo_left_arm", "romeo_right_arm", "icub_left_arm"), "swivel"),
}
#: Their makers' descriptions round angles, so that the closed form is refined.
ROUNDED = ("xarm7",)


def pose_of(robot, q):
    """Pinocchio's own forward kinematics of one q (n,)."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    return data.oMf[robot.model.getFrameId(robot.tool, pin.FrameType.BODY)].homogeneous


def apart(robot, q, other):
    """The largest difference (...) of joint values, for joints without limits modulo full turns."""
    difference = q - other
    endless = ~np.isfinite(robot.limits.lower)
    return np.abs(np.where(endless, (difference + np.pi) % (2 * np.pi) - np.pi, difference)).max(axis=-1)


def parameters_of(robot, q, held=None):
    """The values (k, r) of what the arm has to spare at q (k, n)."""
    form = closed_form(robot, held)
    values = q[:, list(form.held)]
    if form.name == "swivel":
        f = list(form.free)
        axes, points, (wrist, shoulder) = form.screws.axes[f], form.screws.points[f], form.meeting
        values = np.column_stack([values, swivels_of(axes, points, shoulder, wrist, q[:, f])])
    return np.ascontiguousarray(values)


def least_singular_value(robot, q, held):
    """Of the Jacobian of the joints that are not held, (k,) for q (k, n): 1e-10 of the pose is 1e-10 over it of the joints."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool, pin.FrameType.BODY)
    world = pin.LOCAL_WORLD_ALIGNED
    jacobians = np.array([pin.computeFrameJacobian(robot.model, data, each, frame, world).copy() for each in q])
    return np.linalg.svd(np.delete(jacobians, held, axis=2), compute_uv=False)[:, 5]


def recall(robot, q, held=None):
    """The share of q (k, n) that is among the answers for its pose at its own parameters, to 1e-6."""
    poses = np.array([pose_of(robot, each) for each in q])
    solver = Solver.of(robot, task=None, held=held, method="closed-form", seed=0)
    found = solver.solve(poses, np.arange(len(q)), parameters_of(robot, q, held))
    nearest = np.full(len(q), np.inf)
    np.minimum.at(nearest, found.source, apart(robot, found.q, q[found.source]))
    return np.mean(nearest < np.maximum(1e-6, 1e-10 / least_singular_value(robot, q, solver.held)))


def sound(robot, found, poses):
    """Every answer reaches its pose by Pinocchio, lies inside the limits, and is there once.

    One that a limit stops may miss the pose by what rounding of the pose takes beyond the limit.
    """
    assert len(found.pose_index) == len(found.parameters) == len(found.residual) == len(found)
    assert (robot.limits.outside(found.q) <= 0).all()
    for k, q in enumerate(found.q):
        stopped = (q == robot.limits.lower).any() or (q == robot.limits.upper).any()
        assert np.abs(pose_of(robot, q) - poses[found.pose_index[k]]).max() <= (4e-7 if stopped else 1e-10)
    for k in range(len(poses)):
        rows = np.flatnonzero(found.pose_index == k)
        for i, row in enumerate(rows):
            same = rows[i + 1 :][np.abs(found.parameters[rows[i + 1 :]] - found.parameters[row]).sum(axis=1) == 0]
            assert not len(same) or np.abs(found.q[same] - found.q[row]).max(axis=1).min() > 1e-7


def same_set(robot, one, other):
    """Whether two sets of q hold the same configurations."""
    return len(one) == len(other) and all(apart(robot, other, q).min() < 1e-5 for q in one)


@pytest.fixture(scope="module")
def arm():
    kept = {}

    def load(name):
        if name not in kept:
            kept[name] = mp.load_robot(name)
        return kept[name]

    return load


@pytest.mark.slow
def test_which_arms_have_a_closed_form(arm):
    arms = {name: arm(name) for name in mp.available_robots()}
    forms = {name: closed_form(robot) for name, robot in arms.items() if len(robot.tools) == 1}
    assert {name: form.name for name, form in forms.items() if form is not None} == CLOSED | FURTHER
    assert {name for name, form in forms.items() if form is not None and not form.exact} == set(ROUNDED)


@pytest.mark.slow
@pytest.mark.parametrize("name", CLOSED)
def test_random_configurations_are_found_again(arm, rng, name):
    robot = arm(name)
    q = robot.random_configuration(rng, size=100 if name.startswith("ur") else 1000)
    assert recall(robot, q) == 1.0


@pytest.mark.slow
@pytest.mark.parametrize("name", CLOSED)
def test_answers_are_sound(arm, rng, name):
    robot = arm(name)
    q = robot.random_configuration(rng, size=3)
    poses = np.array([pose_of(robot, each) for each in q])
    given = parameters_of(robot, q)
    found = mp.inverse_kinematics(robot, poses, given if given.shape[1] else None)
    assert found.method == CLOSED[name]
    assert found.complete == ("to-resolution" if name in ROUNDED else "exact")
    assert found.missing == 0.0
    sound(robot, found, poses)
    for k, each in enumerate(q):
        assert apart(robot, found.for_pose(k), each).min() < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5", "xarm7", "kinova", "z1", "talos_right_arm", "tiago"])
def test_random_starts_find_no_more_and_no_less(arm, rng, name):
    robot = arm(name).with_limits(lower=np.maximum(arm(name).limits.lower, -3.1), upper=np.minimum(arm(name).limits.upper, 3.1))
    form = closed_form(robot)
    held = [robot.joint_names[k] for k in form.held]
    for q in robot.random_configuration(rng, size=2):
        pose, given = pose_of(robot, q), list(q[list(form.held)]) or None
        closed = mp.inverse_kinematics(robot, pose, given, held=held)
        brute = mp.inverse_kinematics(robot, pose, given, held=held, method="newton")
        assert brute.method == "newton" and brute.complete == "statistical" and brute.missing < 0.1
        assert same_set(robot, closed.q, brute.q)


@pytest.mark.slow
def test_random_starts_find_what_the_swivel_finds(arm, rng):
    """Held first joint: another way to cut the same continuum; each of its answers has its swivel."""
    robot = arm("simple_humanoid_right_arm")
    for q in robot.random_configuration(rng, size=3):
        brute = mp.inverse_kinematics(robot, pose_of(robot, q), [q[0]], held=[robot.joint_names[0]], method="newton")
        assert len(brute)
        for each, swivel in zip(brute.q, parameters_of(robot, brute.q), strict=True):
            assert apart(robot, mp.inverse_kinematics(robot, pose_of(robot, q), swivel).q, each).min() < 1e-6


@pytest.mark.slow
def test_without_turns_sliding_joints_and_held_ones_stay(arm, rng):
    tiago = arm("tiago")
    pose = pose_of(tiago, tiago.random_configuration(rng))
    found, once = (mp.inverse_kinematics(tiago, pose, samples=3, turns=turns) for turns in (True, False))
    assert len(once) <= len(found)
    assert {tuple(np.round(row, 9)) for row in once.q} <= {tuple(np.round(row, 9)) for row in found.q}
    assert set(map(tuple, once.parameters)) == set(map(tuple, found.parameters))


def test_every_full_turn_is_listed(ur5, rng):
    q = rng.uniform(0.1, 3.0, 6)
    pose = pose_of(ur5, q)
    found = mp.inverse_kinematics(ur5, pose)
    once = mp.inverse_kinematics(ur5.with_limits(lower=-np.pi, upper=np.pi), pose)
    span = ur5.limits.upper - ur5.limits.lower
    turns = np.round(span / (2 * np.pi))  # 2 for joints of ±2π, 1 for the elbow
    assert set(turns) <= {1, 2}
    assert 1 < len(once) <= 8 and len(found) == len(once) * turns.prod()
    shift = np.where(turns == 2, 2 * np.pi, 0.0)
    assert apart(ur5, found.q, q - shift).min() < 1e-9
    without = mp.inverse_kinematics(ur5, pose, turns=False)
    assert len(without) == len(once)
    assert np.abs(without.q).max() <= np.pi
    for row in once.q:
        assert apart(ur5, without.q, row).min() < 1e-9


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "joint", "skew"),
    [
        ("panda", 4, False),
        ("panda", 5, False),
        ("panda", 6, False),
        ("talos_right_arm", 2, False),
        ("talos_right_arm", 3, True),
        ("talos_right_arm", 4, False),
        ("simple_humanoid_right_arm", 2, False),
        ("simple_humanoid_right_arm", 6, False),
        ("icub", 5, False),
    ],
)
def test_any_joint_that_may_be_held(arm, rng, name, joint, skew):
    robot = arm(name)
    held = [robot.joint_names[joint - 1]]
    form = closed_form(robot, held)
    assert form.held == (joint - 1,) and form.moves_axes
    assert (arrangement(form.screws.axes[list(form.free)], form.screws.points[list(form.free)])[0] == SKEW) == skew
    q = robot.random_configuration(rng, size=500)
    assert recall(robot, q, held) == 1.0
    found = mp.inverse_kinematics(robot, pose_of(robot, q[0]), [q[0, joint - 1]], held=held)
    assert found.parameter_names == tuple(held)
    assert (found.q[:, joint - 1] == q[0, joint - 1]).all()
    sound(robot, found, [pose_of(robot, q[0])])


def test_tiago_holds_its_prismatic_joint_and_another(arm, rng):
    robot = arm("tiago")
    slide = robot.joint_names[robot.joint_types.index("prismatic")]
    form = closed_form(robot, ["arm_3_joint", slide])  # in any order
    q = robot.random_configuration(rng, size=300)
    assert form.name == "spherical" and recall(robot, q, ["arm_3_joint", slide]) == 1.0
    assert closed_form(robot, ["arm_3_joint", "arm_1_joint"]) is None  # the slide cannot be solved for


@pytest.mark.parametrize("name", ["simple_humanoid_right_arm", "icub"])
def test_the_elbow_of_a_spherical_arm_cannot_be_held(arm, name):
    robot = arm(name)
    with pytest.raises(mp.errors.InvalidInputError, match="held.*still move"):
        mp.inverse_kinematics(robot, pose_of(robot, robot.neutral), held=[robot.joint_names[3]])


@pytest.mark.slow
@pytest.mark.parametrize(("name", "count"), [("baxter_left", 6), ("so100", 10)])
def test_arms_without_a_closed_form(arm, rng, name, count):
    robot = arm(name)
    hits = 0
    for q in robot.random_configuration(rng, size=count):
        solver = Solver.of(robot, task=None, held=None, method="auto", seed=0)
        given = list(q[list(solver.held)]) or None
        found = mp.inverse_kinematics(robot, pose_of(robot, q), given, seed=1)
        assert found.method == "newton" and found.complete == "statistical" and 0 <= found.missing < 0.2
        sound(robot, found, [pose_of(robot, q)])
        hits += len(found) > 0 and apart(robot, found.q, q).min() < 1e-6
    assert hits == count


def test_random_starts_are_the_same_for_the_same_seed(arm, rng):
    robot = arm("so100")
    pose = pose_of(robot, robot.random_configuration(rng))
    one, same = (mp.inverse_kinematics(robot, pose, seed=3) for _ in range(2))
    assert len(one) and np.array_equal(one.q, same.q) and one.missing == same.missing


def test_planar_arms(planar, rng):
    q = rng.uniform(-2, 2, 3)
    full = mp.inverse_kinematics(planar, pose_of(planar, q), task=mp.Task.pose())
    assert full.method == "newton" and full.complete == "statistical"
    assert len(full) == 2 and apart(planar, full.q, q).min() < 1e-6  # elbow up and elbow down
    position = mp.inverse_kinematics(planar, pose_of(planar, q), [0.0])
    assert len(position) == 2 and apart(planar, position.q, q).min() < 1e-6


def test_a_planar_arm_reaches_the_position_at_each_rotation(planar, rng):
    q = rng.uniform(-1, 1, 3)
    pose = pose_of(planar, q)
    found = mp.inverse_kinematics(planar, pose, samples=12)
    assert found.parameter_names == ("tool rotation",) and len(found) >= 4
    for each in found.q:
        assert np.abs(pose_of(planar, each)[:3, 3] - pose[:3, 3]).max() <= 1e-10


@pytest.mark.parametrize(
    ("task", "names", "fixed"),
    [
        (mp.Task.position(), ("azimuth", "tilt", "tool rotation"), (slice(0, 3), slice(3, 4))),
        (mp.Task.planar(), ("shift along (0, 0, 1)", "azimuth", "tilt", "tool rotation"), (slice(0, 2), slice(3, 4))),
        (mp.Task.custom(np.eye(6)[[0, 1, 3, 4, 5]]), ("shift along (0, 0, 1)",), (slice(0, 2), slice(0, 4))),
    ],
    ids=["position", "position in the plane", "height free"],
)
def test_a_free_motion_of_the_tool_is_sampled(ur5, rng, task, names, fixed):
    pose = pose_of(ur5, rng.uniform(-1, 1, 6))
    found = mp.inverse_kinematics(ur5, pose, task=task, samples=4, turns=False)
    assert found.parameter_names == names and len(found) > 4
    reached = np.array([pose_of(ur5, q) for q in found.q])
    assert np.abs((reached - pose)[:, fixed[0], fixed[1]]).max() <= 1e-10
    assert np.linalg.norm(reached - pose, axis=(1, 2)).max() > 0.1


@pytest.mark.slow
def test_held_joints_of_a_long_planar_arm():
    arm = mp.planar_arm([0.5] * 8)
    q = np.linspace(0.1, 0.8, 8)
    held = ["joint1", "joint3", "joint5", "joint7", "joint8"]
    found = mp.inverse_kinematics(arm, pose_of(arm, q), q[[0, 2, 4, 6, 7]], held=held, task=mp.Task.pose())
    assert found.method == "newton" and apart(arm, found.q, q).min() < 1e-6


# singular poses, the boundary of reach, and beyond


@pytest.mark.slow
@pytest.mark.parametrize("q5", [0.0, 1e-12, 1e-9, 1e-7, 1e-5])
@pytest.mark.parametrize("name", ["ur5", "z1", "kinova"])
def test_wrist_axes_in_line(arm, rng, name, q5):
    """At a singular wrist a continuum reaches the pose; one of its answers at least is given, and beside it all."""
    robot = arm(name)
    q = robot.neutral + 0.1
    q[4] = q5
    found = mp.inverse_kinematics(robot, pose_of(robot, q))
    assert len(found)
    sound(robot, found, [pose_of(robot, q)])
    if name == "ur5":
        assert np.abs(found.q[:, 4]).min() <= max(2 * q5, 1e-6)


@pytest.mark.parametrize("elbow", [0.0, 1e-12, 1e-8, 1e-6, 1e-4])
def test_arm_stretched(arm, elbow):
    """At the boundary of reach two answers become one: it is still found."""
    robot = arm("simple_humanoid_right_arm")
    q = np.array([0.3, 0.4, 0.2, -elbow, 0.3, 0.2, 0.1])
    assert (robot.limits.outside(q) <= 0).all()
    found = mp.inverse_kinematics(robot, pose_of(robot, q), parameters_of(robot, q[None]))
    sound(robot, found, [pose_of(robot, q)])
    assert len(found) and np.abs(found.q[:, 3] + elbow).min() < 2e-5


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur5", "panda", "talos_right_arm"])
def test_on_the_boundary_of_reach_and_just_beyond(arm, name):
    robot = arm(name)
    form = closed_form(robot)
    q = robot.random_configuration(np.random.default_rng(5))
    given = list(q[list(form.held)]) or None
    held = [robot.joint_names[k] for k in form.held]
    pose = pose_of(robot, q)
    if name == "ur5":
        q[2] = 0.0
        pose = pose_of(robot, q)
        found = mp.inverse_kinematics(robot, pose)
        assert len(found) and np.abs(found.q[:, 2]).min() < 1e-4
    outward = pose[:3, 3] / np.linalg.norm(pose[:3, 3])
    for further in (3.0, 10.0, 1e6):
        far = pose.copy()
        far[:3, 3] += further * outward
        beyond = mp.inverse_kinematics(robot, far, given, held=held)
        assert len(beyond) == 0 and beyond.q.shape == (0, robot.n) and beyond.complete == "exact"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["baxter_left", "so100"])
def test_out_of_reach_by_random_starts(arm, name):
    robot = arm(name)
    pose = pose_of(robot, robot.neutral)
    pose[:3, 3] += 5.0
    found = mp.inverse_kinematics(robot, pose, samples=1)
    assert len(found) == 0 and found.complete == "statistical"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "z1", "talos_right_arm", "simple_humanoid_right_arm", "ur5", "xarm7"])
def test_configurations_on_their_limits(arm, rng, name):
    """Rounding puts an answer outside a limit by 1e-16 as often as inside."""
    robot, limits = arm(name), arm(name).limits
    robot = robot.with_limits(lower=limits.lower + 0.1 * rng.random(robot.n), upper=limits.upper - 0.1 * rng.random(robot.n))
    q = robot.random_configuration(rng, size=200)
    side = rng.random(q.shape)
    q = np.where(side < 0.15, robot.limits.lower, np.where(side > 0.85, robot.limits.upper, q))
    # the closed form of a rounded arm may put an answer farther outside than a limit forgives
    assert recall(robot, q) >= (0.9 if name in ROUNDED else 1.0)


def test_an_endless_joint_is_held_anywhere(arm, rng):
    robot = arm("kinova")
    assert not np.isfinite(robot.limits.lower).all()
    found = mp.inverse_kinematics(robot, pose_of(robot, robot.random_configuration(rng)))
    endless = ~np.isfinite(robot.limits.lower)
    assert len(found) and (np.abs(found.q[:, endless]) <= np.pi).all()


# what is asked for


def test_pointing(panda, rng):
    q = panda.random_configuration(rng)
    axis = np.array([1.0, 2.0, 2.0]) / 3
    pose = pose_of(panda, q)
    found = mp.inverse_kinematics(panda, pose, task=mp.Task.pointing(axis), samples=(10, 16))
    assert found.parameter_names == ("panda_joint7", "tool rotation") and len(found) > 10
    turned = set()
    for each, (_, angle) in zip(found.q, found.parameters, strict=True):
        reached = pose_of(panda, each)
        assert np.abs(reached[:3, 3] - pose[:3, 3]).max() <= 1e-10
        assert np.abs(reached[:3, :3] @ axis - pose[:3, :3] @ axis).max() <= 1e-9
        assert np.abs(reached[:3, :3] - pose[:3, :3] @ pin.exp3(angle * axis)).max() <= 1e-9
        turned.add(angle)
    assert len(turned) > 4
    again = mp.inverse_kinematics(panda, pose, [q[6], 0.0], task=mp.Task.pointing(axis))
    assert again.complete == "exact" and apart(panda, again.q, q).min() < 1e-6


def test_batches(panda, rng):
    q = panda.random_configuration(rng, size=4)
    poses = np.array([pose_of(panda, each) for each in q])
    poses[2, :3, 3] += 10.0
    found = mp.inverse_kinematics(panda, poses, samples=20)
    assert set(found.pose_index) == {0, 1, 3} and found.for_pose(2).shape == (0, 7)
    for k in (0, 1, 3):
        alone = mp.inverse_kinematics(panda, poses[k], samples=20)
        assert np.array_equal(alone.q, found.for_pose(k)) and len(alone)
    of_list = mp.inverse_kinematics(panda, [pin.SE3(pose) for pose in poses], samples=20)
    one = mp.inverse_kinematics(panda, pin.SE3(poses[1]), samples=20)
    assert np.allclose(of_list.q, found.q, atol=1e-9) and np.allclose(one.q, found.for_pose(1), atol=1e-9)
    assert not len(mp.inverse_kinematics(panda, poses[:0], samples=20))


def test_grids_of_parameters(panda):
    pose = pose_of(panda, panda.neutral)
    found = mp.inverse_kinematics(panda, pose, samples=9)
    lower, upper = panda.limits.lower[6], panda.limits.upper[6]
    assert found.complete == "to-resolution" and found.complete is not None
    grid = np.linspace(lower, upper, 9)
    assert np.abs(found.parameters[:, :1] - grid).min(axis=1).max() < 1e-12 and len(np.unique(found.parameters)) > 2
    assert np.array_equal(found.q[:, 6], found.parameters[:, 0])
    several = mp.inverse_kinematics(panda, pose, [[0.1], [panda.neutral[6]], [upper + 1.0]])
    assert several.complete == "exact" and set(several.parameters[:, 0]) <= {0.1, panda.neutral[6]}
    assert apart(panda, several.q, panda.neutral).min() < 1e-6
    default = mp.inverse_kinematics(panda, pose)
    assert len(default) > len(found) and "spherical" in str(default) and str(len(default)) in str(default)


def test_swivel_grid(arm):
    robot = arm("simple_humanoid_right_arm")
    pose = pose_of(robot, robot.neutral + 0.0)
    found = mp.inverse_kinematics(robot, pose, samples=40)
    assert found.parameter_names == ("swivel",) and found.complete == "to-resolution"
    for q, (swivel,) in zip(found.q, found.parameters, strict=True):
        turned = parameters_of(robot, q[None])[0, 0] - swivel
        assert abs((turned + np.pi) % (2 * np.pi) - np.pi) < 1e-5


def test_six_joints_need_no_parameters(ur5):
    found = mp.inverse_kinematics(ur5, pose_of(ur5, ur5.neutral))
    assert found.parameter_names == () and found.parameters.shape == (len(found), 0) and len(found)
    assert found.complete == "exact" == mp.inverse_kinematics(ur5, pose_of(ur5, ur5.neutral), samples=3).complete


# errors


def turned_wrong(kind):
    pose = np.eye(4)
    pose[:3, 3] = (0.4, 0.0, 0.4)
    if kind == "nan":
        pose[0, 3] = np.nan
    elif kind == "infinite":
        pose[2, 3] = np.inf
    elif kind == "scaled":
        pose[:3, :3] *= 1.01
    elif kind == "mirrored":
        pose[0, 0] = -1.0
    elif kind == "row":
        pose[3, 0] = 0.5
    return pose


@pytest.mark.parametrize("kind", ["nan", "infinite", "scaled", "mirrored", "row"])
def test_matrices_that_are_no_pose(panda, kind):
    with pytest.raises(mp.errors.InvalidInputError, match=r"^pose: got .*allowed: (finite|a rotation)"):
        mp.inverse_kinematics(panda, turned_wrong(kind), [0.0])
    with pytest.raises(mp.errors.InvalidInputError, match=r"^pose\[1\]: got .*allowed: (finite|a rotation)"):
        mp.inverse_kinematics(panda, np.array([turned_wrong("none"), turned_wrong(kind)]), [0.0])


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"parameters": [0.0, 0.0]}, r"^parameters: .*allowed: .*\(1,\)"),
        ({"parameters": [[0.0, 0.0]]}, r"^parameters: .*allowed: .*\(any, 1\)"),
        ({"parameters": [[[0.0]]]}, r"^parameters: .*allowed: "),
        ({"parameters": [np.nan]}, r"^parameters: .*allowed: finite"),
        ({"parameters": ["zero"]}, r"^parameters: .*allowed: real numbers"),
        ({"parameters": [0.0], "samples": 4}, r"^samples: got 4; allowed: nothing where parameters"),
        ({"samples": 0}, r"^samples: got 0; allowed: a whole number, at least 1"),
        ({"samples": 2.5}, r"^samples: got 2.5; allowed: a whole number"),
        ({"samples": [3, 4]}, r"^samples: got \[3, 4\]; allowed: .*panda_joint7"),
        ({"samples": [0]}, r"^samples\[0\] \(panda_joint7\): got 0; allowed: a whole number"),
        ({"held": ["panda_joint"]}, r"^held: .*did you mean panda_joint"),
        ({"held": ["elbow"]}, r"^held: .*one of panda_joint1"),
        ({"held": ["panda_joint1", "panda_joint2"]}, r"^held: .*allowed: 1 different joints"),
        ({"held": []}, r"^held: .*allowed: 1 different joints"),
        ({"held": "panda_joint7"}, r"^held: .*allowed: a list of names"),
        ({"held": [7]}, r"^held\[0\]: got 7; allowed: a text"),
        ({"task": mp.Task.rotation([0, 0, 1])}, r"^task: got 'rotation'; allowed: rotations that are fixed, free, or"),
        ({"task": "pose"}, r"^task: .*allowed: a Task"),
        ({"method": "closed_form"}, r"^method: .*did you mean closed-form"),
        ({"turns": "no"}, "^turns: got 'no'"),
        ({"method": "newtn"}, r"^method: .*did you mean newton"),
        ({"seed": -1}, r"^seed: got -1; allowed: a whole number, at least 0"),
        ({"held": ["panda_joint2"], "method": "closed-form"}, r"^method: got .closed-form.; allowed: .newton."),
    ],
)
def test_wrong_arguments(panda, options, told):
    with pytest.raises(mp.errors.InvalidInputError, match=told):
        mp.inverse_kinematics(panda, pose_of(panda, panda.neutral), **options)


@pytest.mark.parametrize(
    "pose", [np.eye(3), np.zeros((0,)), "pose", None, [1.0, 2.0], np.zeros((2, 3, 4)), [np.eye(4), np.eye(3)]]
)
def test_what_is_no_pose_at_all(ur5, pose):
    with pytest.raises(mp.errors.InvalidInputError, match=r"^pose.*allowed: "):
        mp.inverse_kinematics(ur5, pose)


def test_a_robot_is_asked_for():
    with pytest.raises(mp.errors.InvalidInputError, match=r"^robot: .*allowed: a Robot"):
        mp.inverse_kinematics("panda", np.eye(4))


@pytest.mark.slow
@pytest.mark.parametrize("place", ["file/cache", "cache"])
def test_without_a_library_llvm_compiles(place, tmp_path):
    """In processes of their own, with the same solutions, also where the cache folder cannot be made."""
    (tmp_path / "file").write_text("")
    program = """
import sys, manipplan as mp
from manipplan.support import kernels
if len(sys.argv) > 1:
    kernels.find_library = lambda: None
ur5 = mp.load_robot("ur5")
found = mp.inverse_kinematics(ur5, ur5.kinematics(compiled=False).pose(ur5.neutral + 0.3))
print("llvmlite" in sys.modules, found.q.tolist())
"""
    answers = []
    for arguments in ([], ["llvm"], ["llvm"]):
        run = subprocess.run(
            [sys.executable, "-c", program, *arguments],
            env=os.environ | {"MANIPPLAN_CACHE": str(tmp_path / place), "CC": ""},
            capture_output=True,
            text=True,
            check=True,
        )
        answers.append(run.stdout.split(maxsplit=1))
    assert [by_llvm for by_llvm, _ in answers] == [str(find_library() is None), "True", "True"]
    assert len({found for _, found in answers}) == 1


@pytest.mark.parametrize(("lower", "upper"), [(-1.0, np.inf), (-np.inf, 1.0)])
def test_a_limit_on_one_side_only_is_refused(lower, upper):
    robot = mp.load_robot("panda")
    limits = {side: getattr(robot.limits, side).copy() for side in ("lower", "upper")}
    limits["lower"][6], limits["upper"][6] = lower, upper
    half = robot.with_limits(**limits)
    assert not half.continuous_joints.any()
    with pytest.raises(mp.errors.InvalidInputError, match="limits of panda_joint7: .*both sides"):
        mp.inverse_kinematics(half, np.eye(4))


def test_a_slider_without_limits_is_refused():
    robot = mp.load_robot("tiago")
    assert robot.joint_types[0] == "prismatic"
    limits = {side: getattr(robot.limits, side).copy() for side in ("lower", "upper")}
    limits["lower"][0], limits["upper"][0] = -np.inf, np.inf
    with pytest.raises(mp.errors.InvalidInputError, match=f"limits of {robot.joint_names[0]}"):
        mp.inverse_kinematics(robot.with_limits(**limits), np.eye(4))


@pytest.mark.slow
@pytest.mark.parametrize("method", ["closed-form", "newton"])
def test_no_poses_have_no_answers(method):
    found = mp.inverse_kinematics(mp.load_robot("panda"), np.zeros((0, 4, 4)), samples=2, method=method)
    assert len(found) == 0 and found.missing == 0.0


def _arm(folder, kinds, size):
    """An arm of revolute ("r") and prismatic ("p") joints about z, y, x, z, ..., links of `size` [m] along z."""
    axes = ("0 0 1", "0 1 0", "1 0 0")
    joints = "".join(
        f'<link name="{k + 1}"/><joint name="j{k}" type="{"revolute" if kind == "r" else "prismatic"}"><parent link="{k}"/>'
        f'<child link="{k + 1}"/><origin xyz="0 0 {size}"/><axis xyz="{axes[k % 3]}"/>'
        f'<limit lower="{-3 if kind == "r" else -size}" upper="{3 if kind == "r" else size}" velocity="1" effort="1"/></joint>'
        for k, kind in enumerate(kinds)
    )
    end = f'<joint name="end" type="fixed"><parent link="{len(kinds)}"/><child link="tip"/><origin xyz="{size} 0 {size}"/></joint>'
    (folder / "arm.urdf").write_text(f'<robot name="arm"><link name="0"/>{joints}<link name="tip"/>{end}</robot>')
    return mp.load_robot(folder / "arm.urdf", tool="tip")


@pytest.mark.parametrize("kinds", ["r", "p", "rr", "pr", "rrr", "rpr"])
def test_arms_of_few_joints(kinds, tmp_path, rng):
    robot = _arm(tmp_path, kinds, 0.3)
    for q in robot.random_configuration(rng, size=3):
        found = mp.inverse_kinematics(robot, robot.kinematics(mp.Task.pose()).pose(q))
        assert np.abs(found.q - q).max(axis=1).min() < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize("kinds", ["rprrpr", "rrrrrr"])
@pytest.mark.parametrize("size", [0.1, 1.0])
def test_singular_poses_of_arms_without_a_closed_form(kinds, size, tmp_path, rng):
    robot = _arm(tmp_path, kinds, size)
    kinematics = robot.kinematics(mp.Task.pose())
    # with the middle joints at zero, the first and the fourth axis are one line
    for q in (np.zeros(6), np.array([0.4, 0.0, 0.0, 0.0, 0.0, -0.7])):
        assert np.linalg.svd(kinematics.jacobian(q), compute_uv=False).min() < 1e-12
        found = mp.inverse_kinematics(robot, kinematics.pose(q))
        assert found.method == "newton"
        assert len(found)
        assert found.residual.max() <= 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur5", "xarm7"])
def test_full_turns_of_few_solutions_are_all_solutions(name, rng, request):
    """Each solution that is listed at several full turns comes from the one with the smallest values."""
    arm = mp.load_robot(name)
    solver = Solver.of(arm, task=None, held=None, method="auto", seed=0)
    pose = pose_of(arm, arm.random_configuration(rng))[None]
    samples = solver.grid(None, (30,), pose)
    owners = np.zeros(len(samples), dtype=np.int64)
    once, every = solver.solve_once(pose, owners, samples), solver.solve(pose, owners, samples)
    lower, upper = arm.limits.lower, arm.limits.upper
    assert len(every.q) > 3 * len(once.q) > 0
    for q, source in zip(once.q, once.source, strict=True):
        free = solver.form.free
        turns = [np.arange(q[k], upper[k] + 1e-9, 2 * np.pi) if k in free else q[k] for k in range(arm.n)]
        wanted = np.array(np.meshgrid(*turns)).reshape(arm.n, -1).T
        found = every.q[every.source == source]
        assert (q[list(solver.form.free)] < lower[list(solver.form.free)] + 2 * np.pi + 1e-9).all()
        assert np.abs(wanted[:, None] - found).max(axis=2).min(axis=1).max() < 1e-9
    assert (arm.limits.outside(every.q) <= 0).all()


@pytest.mark.parametrize(
    ("task", "names"), [(mp.Task.position(), 2), (mp.Task.pointing([0, 0, 1]), 0)], ids=["position", "pointing"]
)
def test_five_joints_reach_what_counts_of_a_pose(rng, task, names):
    arm = mp.load_robot("so100")
    q = np.array([0.2, 1.2, -1.1, 0.4, 0.3])
    pose = pose_of(arm, q)
    parameters = None
    if names:
        held = list(Solver.of(arm, task=task, held=None, method="auto", seed=0).held)
        parameters = q[held]
    found = mp.inverse_kinematics(arm, pose, parameters, task=task)
    assert len(found.parameter_names) == names and found.complete == "statistical"
    assert apart(arm, found.q, q).min() < 1e-6  # the configuration that the pose is of is among them
    for each in found.q:
        assert np.abs(pose_of(arm, each)[:3, 3] - pose[:3, 3]).max() <= 1e-9
    assert (arm.limits.outside(found.q) <= 0).all()


@pytest.mark.parametrize("task", [mp.Task.pose(), mp.Task.pointing([0, 0, 1])])
@pytest.mark.parametrize("turns", [True, False])
def test_a_generous_time_limit_changes_nothing(panda, task, turns):
    poses = panda.kinematics().pose(panda.neutral + np.linspace(0, 0.3, 5)[:, None])
    poses[-1, :3, 3] *= 3  # out of reach
    free = mp.inverse_kinematics(panda, poses, task=task, turns=turns)
    timed = mp.inverse_kinematics(panda, poses, task=task, turns=turns, time_limit=600.0)
    np.testing.assert_array_equal(timed.q, free.q)
    np.testing.assert_array_equal(timed.pose_index, free.pose_index)
    np.testing.assert_array_equal(timed.parameters, free.parameters)
    assert (timed.complete, timed.missing) == (free.complete, free.missing)


@pytest.mark.slow
def test_a_time_limit_holds_for_many_samples(panda):
    """The solutions by then are some of all, of samples that are spread over the grid; what is missing is estimated."""
    pose = panda.kinematics().pose(panda.neutral)
    free = mp.inverse_kinematics(panda, pose, samples=300_000)
    timed = mp.inverse_kinematics(panda, pose, samples=300_000, time_limit=1e-6)
    assert 0 < len(timed) < len(free) / 10 and timed.complete == "statistical" and timed.missing > 0.9
    assert np.ptp(timed.parameters) > 0.7 * np.ptp(free.parameters)
    assert {tuple(q) for q in timed.q} <= {tuple(q) for q in free.q}


def test_a_time_limit_holds_for_many_poses_out_of_reach(panda):
    """Finer grids and random starts for each of them took half a minute, whatever the limit."""
    poses = np.tile(panda.kinematics().pose(panda.neutral), (1000, 1, 1))
    poses[:, :3, 3] += np.linspace(1.0, 4.0, 1000)[:, None]
    begun = time.monotonic()
    timed = mp.inverse_kinematics(panda, poses, time_limit=0.2)
    assert time.monotonic() - begun < 4.0
    assert len(timed) == 0 and timed.complete == "statistical" and timed.missing == 1.0


@pytest.mark.parametrize("limit", [0.0, -1.0, np.nan, np.inf, "long", True])
def test_wrong_time_limits_are_refused(panda, limit):
    with pytest.raises(mp.errors.InvalidInputError, match="time_limit: got"):
        mp.inverse_kinematics(panda, panda.kinematics().pose(panda.neutral), time_limit=limit)


@pytest.mark.slow
def test_poses_of_a_path_have_as_many_random_starts_as_one():
    """Of many poses each had 8, of one 64: some of a path that the arm reaches had no solution."""
    robot, task, rng = mp.load_robot("so100"), mp.Task.pointing([0, 0, 1]), np.random.default_rng(7)
    middle = robot.limits.lower + (robot.limits.upper - robot.limits.lower) * rng.uniform(0.25, 0.75, (300, 5))
    found = mp.inverse_kinematics(robot, robot.kinematics(mp.Task.position()).pose(middle), task=task)
    np.testing.assert_array_equal(np.unique(found.pose_index), np.arange(300))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["tiago", "talos_left_arm", "panda"])
@pytest.mark.parametrize("task", [mp.Task.position(), mp.Task.pointing([0, 0, 1])], ids=["position", "pointing"])
def test_free_motions_have_solutions_at_the_edge_of_the_reach(name, task):
    """There, so few rotations of the tool have a solution that no grid contains one."""
    robot, rng = mp.load_robot(name), np.random.default_rng(4)
    kinematics, lower, upper = robot.kinematics(), np.maximum(robot.limits.lower, -7), np.minimum(robot.limits.upper, 7)
    for direction in rng.normal(size=(4, 3)):
        starts = rng.uniform(lower, upper, (500, robot.n))
        first = starts[np.argmax(kinematics.pose(starts)[:, :3, 3] @ direction)]
        farthest = minimize(
            lambda q, d=direction: -kinematics.pose(q)[:3, 3] @ d, first, bounds=list(zip(lower, upper, strict=True))
        )
        near = np.clip(farthest.x + rng.normal(size=robot.n) * 0.03, robot.limits.lower, robot.limits.upper)
        found = mp.inverse_kinematics(robot, kinematics.pose(near), task=task)
        assert len(found)
        misses = kinematics.pose(found.q) - kinematics.pose(near)
        assert np.abs(misses[:, :3, 3]).max() < 1e-8
        if task.name.startswith("pointing"):
            assert np.abs(misses[:, :3, 2]).max() < 1e-8
