"""Laws of inverse kinematics on random arms of every kind that has a closed form."""

import numpy as np
import pinocchio as pin
import pytest
from chains import random_rotation, seeds
from examples import examples
from hypothesis import assume, given

import manipplan as mp
from manipplan.ik.bridge import A_MEETS_B, A_PARALLEL_B, B_MEETS_C, B_PARALLEL_C, SKEW, arrangement, swivels_of
from manipplan.ik.form import closed_form
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot

KINDS = {
    "first two meet": A_MEETS_B,
    "second and third meet": B_MEETS_C,
    "first two parallel": A_PARALLEL_B,
    "second and third parallel": B_PARALLEL_C,
    "skew": SKEW,
}


@pytest.fixture(scope="module", autouse=True)
def no_compiler():
    """Every example is another arm: machine code of its forward kinematics would take a second each."""
    with pytest.MonkeyPatch.context() as patch:
        for module in ("support.compiler", "symbolic.machine_code"):
            patch.setattr(f"manipplan.{module}.find_compiler", lambda language="c": None)
        yield


def arm(axes, points, rng, limit=np.pi):
    """A robot with these axes (n, 3) through these points (n, 3) at q = 0, and a tool somewhere."""
    model, joint, before = pin.Model(), 0, np.zeros(3)
    n = len(axes)
    for k in range(n):
        turn = pin.SE3(np.eye(3), points[k] - before)
        joint = model.addJoint(joint, pin.JointModelRevoluteUnaligned(axes[k]), turn, f"joint{k + 1}")
        model.appendBodyToJoint(joint, pin.Inertia.Random(), pin.SE3.Identity())
        before = points[k]
    model.addBodyFrame("tool", joint, pin.SE3(random_rotation(rng), rng.uniform(-0.5, 0.5, 3)), 0)
    limits = JointLimits(
        lower=np.full(n, -limit),
        upper=np.full(n, limit),
        velocity=np.ones(n),
        acceleration=np.ones(n),
        jerk=np.full(n, np.inf),
        effort=np.full(n, np.inf),
    )
    return Robot(name="random", model=model, geometry=pin.GeometryModel(), tool="tool", limits=limits, neutral=np.zeros(n))


def directions(rng, n):
    axes = rng.normal(size=(n, 3))
    return axes / np.linalg.norm(axes, axis=1, keepdims=True)


def spherical_wrist(rng, kind):
    """Axes and points (6, 3): the last three meet, the first three lie as `kind` says."""
    axes, points = directions(rng, 6), rng.uniform(-0.6, 0.6, (6, 3))
    points[4] = points[5] = points[3]
    first = {A_MEETS_B: 0, B_MEETS_C: 1, A_PARALLEL_B: 0, B_PARALLEL_C: 1}.get(kind)
    if kind in (A_MEETS_B, B_MEETS_C):
        points[first + 1] = points[first]
    elif first is not None:
        axes[first + 1] = rng.choice([-1, 1]) * axes[first]
    return axes, slid(rng, axes, points)


def slid(rng, axes, points):
    """Other points of the same axes."""
    return points + rng.uniform(-0.3, 0.3, (len(axes), 1)) * axes


def pose_of(robot, q):
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    return data.oMf[robot.model.getFrameId("tool")].homogeneous


def regular(robot, q, free):
    """Whether the joints that are solved for move the tool well in all directions."""
    data = robot.model.createData()
    J = pin.computeFrameJacobian(robot.model, data, q, robot.model.getFrameId("tool"), pin.LOCAL_WORLD_ALIGNED)
    return np.linalg.svd(J[:, free], compute_uv=False)[5] > 1e-3


def found_again(robot, q, parameters=None, held=None):
    """Whether q is among the answers; each of them is checked by Pinocchio."""
    pose = pose_of(robot, q)
    found = mp.inverse_kinematics(robot, pose, parameters, held=held, method="closed-form")
    assert found.complete == "exact" and (robot.limits.outside(found.q) <= 0).all()
    for each in found.q:
        assert np.abs(pose_of(robot, each) - pose).max() <= 1e-10
    for k in range(len(found)):  # once each
        assert not len(found.q[k + 1 :]) or np.abs(found.q[k + 1 :] - found.q[k]).max(axis=1).min() > 1e-7
    return len(found) > 0 and np.abs(found.q - q).max(axis=1).min() < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("backward", [False, True], ids=["wrist", "shoulder"])
@pytest.mark.parametrize("kind", KINDS)
@examples(25)
@given(seed=seeds)
def test_three_axes_that_meet(kind, backward, seed):
    rng = np.random.default_rng(seed)
    axes, points = spherical_wrist(rng, KINDS[kind])
    robot = arm(axes[::-1], points[::-1], rng) if backward else arm(axes, points, rng)
    form = closed_form(robot)
    assert (form.name, form.backward) == ("spherical", backward)
    assert arrangement(form.screws.axes[list(form.free)], form.screws.points[list(form.free)])[0] == KINDS[kind]
    q = rng.uniform(-np.pi, np.pi, 6)
    assume(regular(robot, q, range(6)))
    assert found_again(robot, q)


@pytest.mark.slow
@pytest.mark.parametrize("backward", [False, True], ids=["forward", "reversed"])
@examples(25)
@given(seed=seeds)
def test_three_parallel_axes(backward, seed):
    rng = np.random.default_rng(seed)
    axes, points = directions(rng, 6), rng.uniform(-0.6, 0.6, (6, 3))
    axes[2], axes[3] = rng.choice([-1, 1], 2)[:, None] * axes[1]
    points[5] = points[4]
    points = slid(rng, axes, points)
    robot = arm(axes[::-1], points[::-1], rng) if backward else arm(axes, points, rng)
    form = closed_form(robot)
    assert (form.name, form.backward) == ("parallel", backward)
    q = rng.uniform(-np.pi, np.pi, 6)
    assume(regular(robot, q, range(6)))
    assert found_again(robot, q)


@pytest.mark.slow
@examples(50)
@given(seed=seeds)
def test_spherical_shoulder_and_wrist(seed):
    rng = np.random.default_rng(seed)
    axes, points = directions(rng, 7), rng.uniform(-0.6, 0.6, (7, 3))
    points[1] = points[2] = points[0]
    points[5] = points[6] = points[4]
    points = slid(rng, axes, points)
    robot = arm(axes, points, rng)
    form = closed_form(robot)
    assert form.name == "swivel"
    q = rng.uniform(-np.pi, np.pi, 7)
    assume(all(regular(robot, q, [k for k in range(7) if k != held]) for held in (0, 6)))
    wrist, shoulder = form.meeting
    assert found_again(robot, q, swivels_of(form.screws.axes, form.screws.points, shoulder, wrist, q[None]))
    assert found_again(robot, q, [q[1]], ["joint2"]) or not regular(robot, q, [0, 2, 3, 4, 5, 6])


@pytest.mark.slow
@examples(50)
@given(seed=seeds)
def test_a_joint_held_anywhere(seed):
    """An arm with a spherical wrist and one joint more, between or before the others, revolute joints of any direction."""
    rng = np.random.default_rng(seed)
    axes, points = spherical_wrist(rng, rng.choice(list(KINDS.values())))
    place = int(rng.integers(0, 4))
    axes, points = (
        np.insert(a, place, b, axis=0) for a, b in ((axes, directions(rng, 1)), (points, rng.uniform(-1, 1, (1, 3))))
    )
    robot = arm(axes, points, rng)
    q = rng.uniform(-np.pi, np.pi, 7)
    assume(regular(robot, q, [k for k in range(7) if k != place]))
    assert found_again(robot, q, [q[place]], [f"joint{place + 1}"])


@pytest.mark.slow
@examples(25)
@given(seed=seeds)
def test_scaling_lengths_leaves_the_answers(seed):
    """Lengths times ten, and the pose's: the same configurations."""
    axes, points = spherical_wrist(np.random.default_rng(seed), SKEW)
    answers = []
    q = np.random.default_rng(seed + 1).uniform(-np.pi, np.pi, 6)
    for scale in (1.0, 10.0):
        robot = arm(axes, scale * points, np.random.default_rng(seed))
        pose = pose_of(robot, q)
        assume(regular(robot, q, range(6)))
        answers.append(mp.inverse_kinematics(robot, pose).q)
    assume(all(len(each) for each in answers))
    nearest = [np.abs(each - q).max(axis=1).min() for each in answers]
    assert max(nearest) < 1e-6


@pytest.mark.slow
@examples(50)
@given(seed=seeds)
def test_a_turn_of_the_base_joint_turns_the_first_angle(seed):
    """With the pose turned about the first axis all answers turn with it."""
    rng = np.random.default_rng(seed)
    axes, points = spherical_wrist(rng, rng.choice(list(KINDS.values())))
    robot = arm(axes, points, rng)
    q, angle = rng.uniform(-np.pi, np.pi, 6), 0.5
    assume(regular(robot, q, range(6)))
    about = pin.SE3(pin.exp3(angle * axes[0]), points[0] - pin.exp3(angle * axes[0]) @ points[0])
    one = mp.inverse_kinematics(robot, pose_of(robot, q)).q
    other = mp.inverse_kinematics(robot, about.homogeneous @ pose_of(robot, q)).q
    assert len(one) == len(other)
    one[:, 0] = (one[:, 0] + angle + np.pi) % (2 * np.pi) - np.pi
    for each in one:
        assert np.abs((other - each + np.pi) % (2 * np.pi) - np.pi).max(axis=1).min() < 1e-5
