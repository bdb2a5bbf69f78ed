"""The servo: limits in every step, ways out of singular postures, commands that are late or wrong, and one law in three forms."""

import itertools
import shutil
import subprocess

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.support.compiler import find_compiler
from manipplan.tracking.servo import LONGEST_STEP, Servo, ServoLimit, ServoStatus, Singularity

DT = 0.002
UPRIGHT = np.array([0.0, -np.pi / 2, 0.0, -np.pi / 2, 0.0, 0.0])
STRAIGHT = np.array([0.3, -0.8, 0.0, -1.0, 1.2, 0.0])
SINGULAR = {
    "ur5 upright": ("ur5", UPRIGHT),
    "ur5 elbow": ("ur5", STRAIGHT),
    "ur5 wrist": ("ur5", np.array([0.2, -1.3, 1.5, -1.2, 0.0, 0.3])),
    "xarm7 zero": ("xarm7", np.zeros(7)),
    "panda shoulder and wrist": ("panda", np.array([0.556, 0.0, -1.769, -2.593, 1.161, 3.435, 0.433])),
}
SCALE = np.array([1.0, 1.0, 1.0, 0.3, 0.3, 0.3])


def robot_without_jerk(name):
    robot = mp.load_robot(name)
    return robot.with_limits(jerk=np.inf)


@pytest.fixture(scope="module")
def servos():
    """Servos by the name of the arm; each test begins with an empty memory."""
    made = {}

    def servo(name, **options):
        key = (name, *options.items())
        if key not in made:
            made[key] = Servo(robot_without_jerk(name), dt=DT, **options)
        made[key].reset()
        return made[key]

    return servo


def kinematics(robot, q):
    """Pose and scaled Jacobian by Pinocchio."""
    data = robot.model.createData()
    links = [frame.type for frame in robot.model.frames if frame.name == robot.tool]  # a joint may have the link's name
    frame = robot.model.getFrameId(robot.tool, pin.FrameType.BODY if pin.FrameType.BODY in links else links[0])
    jacobian = pin.computeFrameJacobian(robot.model, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
    return data.oMf[frame].copy(), jacobian * SCALE[:, None]


def moved(first, second):
    """The scaled displacement (6,) of the tool between two poses."""
    return SCALE * np.concatenate([second.translation - first.translation, pin.log3(second.rotation @ first.rotation.T)])


def drive(servo, q, twist, seconds, frame="world", after=None):
    """q and q̇ of an ideal arm, (N + 1, n)."""
    q, qd = np.array(q, dtype=float), np.zeros(len(q))
    all_q, all_qd = [q], [qd]
    for k in range(round(seconds / DT)):
        qd = servo.step(q, qd, twist(k * DT) if callable(twist) else twist, frame)
        q = q + DT * qd
        all_q.append(q)
        all_qd.append(qd)
        if after is not None and after(q):
            break
    return np.array(all_q), np.array(all_qd)


def test_far_from_singularities_the_twist_is_followed_exactly(servos):
    servo = servos("panda")
    q = np.array([0.3, -0.3, 0.2, -2.0, 0.1, 1.8, 0.5])
    twist = np.array([0.02, -0.03, 0.01, 0.05, 0.0, -0.1])
    path, _ = drive(servo, q, twist, 0.4)
    _, jacobian = kinematics(servo.robot, path[-1])
    assert np.allclose(
        jacobian @ servo.step(path[-1], np.zeros(7) + (path[-1] - path[-2]) / DT, twist, "world"), SCALE * twist, atol=1e-9
    )
    gauge = servo.gauge
    assert gauge.status is ServoStatus.FOLLOWING
    assert gauge.kind is Singularity.CLEAR
    assert gauge.followed == pytest.approx(1.0)
    assert gauge.slip == pytest.approx(0.0, abs=1e-9)
    assert gauge.seconds == np.inf


@pytest.mark.parametrize("frame", ["tool", "base", "world", "camera"])
def test_axes_of_the_twist(servos, frame):
    robot = mp.load_robot("ur5").at(pin.SE3(pin.rpy.rpyToMatrix(0.3, -0.5, 1.0), np.array([0.2, -0.1, 0.4])).homogeneous)
    servo = Servo(robot, dt=DT)
    q = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3])
    pose, jacobian = kinematics(robot, q)
    camera = pin.rpy.rpyToMatrix(1.0, 0.2, -0.7)
    axes = {"tool": pose.rotation, "base": robot.base[:3, :3], "world": np.eye(3), "camera": camera}[frame]
    twist = 1e-3 * np.array([1.0, -2.0, 0.5, 0.3, 1.0, -0.4])
    expected = np.kron(np.eye(2), axes) @ twist
    qd = servo.step(q, np.zeros(6), twist, camera if frame == "camera" else frame)
    assert np.allclose(jacobian @ qd, SCALE * expected, atol=1e-12)


def test_free_directions_are_not_followed(servos):
    servo = servos("ur5")
    q = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3])
    pose, jacobian = kinematics(servo.robot, q)
    twist = 1e-3 * np.array([1.0, -2.0, 0.5, 0.3, 1.0, -0.4])
    qd = servo.step(q, np.zeros(6), twist, "tool", free=("z", "ry"))
    in_tool = np.kron(np.eye(2), pose.rotation.T) @ (jacobian @ qd / SCALE)
    followed = [0, 1, 3, 5]
    assert np.allclose(in_tool[followed], twist[followed], atol=1e-6)
    assert abs(in_tool[2] - twist[2]) > 1e-5
    qd = servo.step(q, np.zeros(6), twist, "tool")
    assert np.allclose(np.kron(np.eye(2), pose.rotation.T) @ (jacobian @ qd / SCALE), twist, atol=1e-10)


@pytest.mark.parametrize("kind", [list, set, tuple])
def test_free_directions_count_for_one_step(servos, kind):
    servo = servos("ur5")
    q = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3])
    twist = 1e-3 * np.array([1.0, -2.0, 0.5, 0.3, 1.0, -0.4])
    free = kind(["z", "ry"])
    first = servo.step(q, np.zeros(6), twist, "tool", free=free)
    whole = servo.step(q, np.zeros(6), twist, "tool")
    assert np.abs(servos("ur5").step(q, np.zeros(6), twist, "tool") - whole).max() < 1e-12
    assert np.abs(first - whole).max() > 1e-4


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("rate", [0.0, 0.05, 0.5])
def test_the_side_is_kept_in_the_axes_of_a_camera_that_turns(servos, rate, side):
    """Its rows change at each step, and what was learned of the fold still holds."""
    servo = servos("ur5")
    elbow = np.array([1.0, 1.0, side, 1.0, 1.0, 1.0])
    q, qd = elbow * [0.3, -0.6, 0.5, -1.2, -1.2, 0.4], np.zeros(6)
    pose, jacobian = kinematics(servo.robot, q * [1.0, 1.0, 0.0, 1.0, 1.0, 1.0])
    outward = np.linalg.svd(jacobian)[0][:3, -1]
    outward *= np.sign(outward @ (pose.translation - [0.0, 0.0, 0.089])) / np.linalg.norm(outward)
    for k in range(5000):
        axes = pin.exp3(np.array([0.0, 0.0, 0.3 + rate * k * DT]))
        twist = np.append(0.1 * axes.T @ (outward if k < 2500 else -outward), np.zeros(3))
        qd = servo.step(q, qd, twist, axes, free=("rz",))
        q = q + DT * qd
    assert side * q[2] > 1.5


def test_a_jog_to_the_other_side_of_a_fold_is_not_undone(servos):
    servo = servos("ur5")
    q, qd = np.array([0.3, -0.6, 0.5, -1.2, -1.2, 0.4]), np.zeros(6)
    inward = np.append(-0.1 * kinematics(servo.robot, q)[0].translation, np.zeros(3))
    for _ in range(2000):
        qd = servo.step(q, qd, -inward, "world")
        q = q + DT * qd
    for elbow in (-0.6, -0.01):
        while abs(q[2] - elbow) > 1e-4 or abs(qd[2]) > 1e-3:
            qd = servo.step_joints(q, qd, np.array([0.0, 0.0, np.clip(5 * (elbow - q[2]), -0.5, 0.5), 0.0, 0.0, 0.0]))
            q = q + DT * qd
    for _ in range(1000):
        qd = servo.step(q, qd, inward, "world")
        q = q + DT * qd
    assert q[2] < -0.3


def test_axes_are_given_anew_with_each_step(servos):
    servo = servos("ur5")
    q = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3])
    servo.step(q, np.zeros(6), np.full(6, 1e-3), pin.exp3(np.array([0.0, 0.0, 1.0])))
    with pytest.raises(mp.errors.InvalidInputError, match="frame: got None"):
        servo.step(q, np.zeros(6), np.full(6, 1e-3), None)


@pytest.mark.slow
@pytest.mark.parametrize("name", SINGULAR)
def test_every_way_out_of_a_singular_posture_is_taken(servos, name):
    """20 mm along each of 12 directions; those that need another posture far away are left out."""
    arm, q = SINGULAR[name]
    servo = servos(arm)
    start, _ = kinematics(servo.robot, q)
    unreachable = {"ur5 upright": (4, 8), "ur5 elbow": (), "ur5 wrist": (), "xarm7 zero": (), "panda shoulder and wrist": ()}[
        name
    ]
    left = []
    for i in range(12):
        twist = np.zeros(6)
        twist[i // 2] = (0.1 if i < 6 else 0.1 / 0.3) * (1 - 2 * (i % 2))
        direction = SCALE * twist / np.linalg.norm(SCALE * twist)

        def far(x, direction=direction):
            return direction @ moved(start, kinematics(servo.robot, x)[0]) >= 0.02

        servo.reset()
        path, _ = drive(servo, q, twist, 2.0, after=far)
        left.append(far(path[-1]))
        assert len(path) * DT < 0.6 or not left[-1]
    reached = [i for i in range(12) if left[i]]
    assert len(reached) >= 9, (name, reached, unreachable)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_elbow_is_not_pushed_through(servos, sign):
    """Outward for four seconds, across, and inward again: the arm folds to the side from which it came."""
    servo = servos("ur5")
    q = np.array([0.3, -0.6, 0.5 * sign, -1.2, -1.2, 0.4])
    straight = q * [1, 1, 0, 1, 1, 1]
    outward = kinematics(servo.robot, straight)[0].translation - [0, 0, 0.089]
    lost = np.linalg.svd(kinematics(servo.robot, straight)[1])[0][:3, -1]
    outward = np.sign(lost @ outward) * lost / np.linalg.norm(lost)
    across = np.cross(outward, [0, 0, 1])
    legs = [outward, outward + across, outward - across, -outward]

    def twist(t):
        d = legs[min(int(t // 2), 3)]
        return np.concatenate([0.1 * d / np.linalg.norm(d), np.zeros(3)])

    path, _ = drive(servo, q, twist, 8.0)
    assert (sign * path[:, 2] > 0).all()
    assert np.abs(path[:, 2]).min() < 0.02
    assert abs(path[-1, 2]) > 0.3


def test_pushed_against_the_reach_the_arm_rests(servos):
    """Ten seconds along what a straight elbow loses: no drift of σ, and no motion but what the command has besides."""
    servo = servos("ur5")
    q = np.array([0.3, -0.6, 0.1, -1.2, -1.2, 0.4])
    straight = q * [1, 1, 0, 1, 1, 1]
    pose, jacobian = kinematics(servo.robot, straight)
    lost = np.linalg.svd(jacobian)[0][:, -1]
    lost = lost * np.sign(lost[:3] @ (pose.translation - [0, 0, 0.089]))
    path, velocity = drive(servo, q, 0.1 * lost / SCALE, 10.0)
    assert servo.gauge.wall > 0.9
    assert servo.gauge.kind is Singularity.FOLD
    sigma = [np.linalg.svd(kinematics(servo.robot, x)[1], compute_uv=False)[-1] for x in path[-2500::100]]
    assert np.ptp(sigma) < 1e-5
    assert np.abs(velocity[-1]).max() < 0.02
    assert (path[:, 2] > 0).all()


def test_the_other_side(servos):
    servo = servos("ur5", side="other")
    q = np.array([0.3, -0.6, 0.5, -1.2, -1.2, 0.4])
    straight = q * [1, 1, 0, 1, 1, 1]
    lost = np.linalg.svd(kinematics(servo.robot, straight)[1])[0][:3, -1]
    outward = lost * np.sign(lost @ (kinematics(servo.robot, straight)[0].translation - [0, 0, 0.089]))
    outward = 0.1 * outward / np.linalg.norm(outward)
    path, _ = drive(servo, q, lambda t: np.concatenate([outward if t < 4 else -outward, np.zeros(3)]), 8.0)
    assert path[-1, 2] < -0.3


def test_the_gauge_sees_the_reach_ahead(servos):
    """seconds is the time in which σ² falls to zero at the commanded speed."""
    servo = servos("ur5")
    q = np.array([0.3, -0.6, 0.5, -1.2, -1.2, 0.4])
    straight = q * [1, 1, 0, 1, 1, 1]
    lost = np.linalg.svd(kinematics(servo.robot, straight)[1])[0][:3, -1]
    outward = lost * np.sign(lost @ (kinematics(servo.robot, straight)[0].translation - [0, 0, 0.089]))
    twist = np.concatenate([0.1 * outward / np.linalg.norm(outward), np.zeros(3)])
    seen = []

    def note(x):
        gauge = servo.gauge
        seen.append((gauge.kind, gauge.seconds, gauge.metres, gauge.joint, x[2]))
        return x[2] < 0.01

    drive(servo, q, twist, 5.0, after=note)
    arrival = len(seen) * DT
    for k, (kind, seconds, metres, joint, _) in enumerate(seen):
        left = arrival - k * DT
        if 0.3 < left < 0.6:
            assert kind is Singularity.FOLD
            assert joint == "elbow_joint"
            assert seconds == pytest.approx(left, rel=0.5)
            assert metres == pytest.approx(0.1 * seconds)


@pytest.mark.parametrize("name", ["ur5", "panda", "so100"])
def test_signs_of_singular_vectors_do_not_matter(servos, name):
    """U of the last step, from which the decomposition goes on, with signs flipped and rows exchanged at random."""
    rng = np.random.default_rng(1)
    servo = servos(name)
    q = {"ur5": np.array([0.2, -1.3, 0.02, -1.2, 0.03, 0.3]), "panda": SINGULAR["panda shoulder and wrist"][1] + 0.02}
    start = q.get(name, np.array([0.1, 0.3, 0.2, 0.1, 0.2]))
    paths = []
    for flips in (False, True):
        servo.reset()
        x, qd = start, np.zeros(len(start))
        for k in range(400):
            if flips:
                guess = np.array(servo.law.guess).reshape(6, 6)
                m = servo.law.world_rows + servo.law.tool_rows
                guess[:m, :m] = rng.permutation(guess[:m, :m]) * rng.choice([-1.0, 1.0], (m, 1))
                servo.law.guess[:] = guess.ravel().tolist()
            t = k * DT
            qd = servo.step(
                x, qd, [0.1 * np.cos(3 * t), 0.1 * np.sin(5 * t), -0.1 * np.cos(4 * t), 0.2, 0.3 * np.sin(4 * t), -0.1], "world"
            )
            x = x + DT * qd
        paths.append(x)
    assert np.allclose(*paths, atol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5", "kinova", "so100", "baxter_left", "xarm7"])
@settings(max_examples=15, deadline=None)
@given(data=st.data())
def test_no_step_leaves_the_limits(servos, name, data):
    """Any twists, modes and time steps, from postures at limits: position, velocity and acceleration, to 1e-9."""
    servo = servos(name)
    robot, n = servo.robot, servo.robot.n
    limits = robot.limits
    rng = np.random.default_rng(data.draw(st.integers(0, 10**6)))
    low, high = np.maximum(limits.lower, -3), np.minimum(limits.upper, 3)
    q = np.where(rng.random(n) < 0.3, np.where(rng.random(n) < 0.5, low, high), rng.uniform(low, high))
    qd, twist = np.zeros(n), np.zeros(6)
    for k in range(300):
        if k % 25 == 0:
            twist = data.draw(st.sampled_from([0.1, 1.0, 30.0])) * rng.standard_normal(6)
            mode = data.draw(st.sampled_from(["twist", "joints", "brake", "nan", "none"]))
        dt = DT * rng.uniform(0.2, LONGEST_STEP)
        before = qd
        if mode == "joints":
            qd = servo.step_joints(q, qd, rng.standard_normal(n) * 3, dt=dt)
        elif mode == "brake":
            qd = servo.brake(q, qd, dt=dt)
        else:
            given_twist = {"twist": twist, "nan": np.full(6, np.nan), "none": None}[mode]
            qd = servo.step(q, qd, given_twist, dt=dt)
        q = q + dt * qd
        assert (np.abs(qd) <= limits.velocity * (1 + 1e-12)).all()
        assert (np.abs(qd - before) <= limits.acceleration * dt * (1 + 1e-9) + 1e-12).all()
        assert (q >= limits.lower - 1e-9).all()
        assert (q <= limits.upper + 1e-9).all()


@pytest.mark.parametrize(
    ("name", "q", "qd", "twist"),
    [
        (
            "panda",
            [-0.90696, -1.74586, -0.70377, -0.61055, 0.05801, 0.01536, -2.89265],
            [0.5934, 0.3529, 0.648, 1.3361, -0.1789, -0.8599, 0.3191],
            [0.0004, 0.0591, -0.0889, 0.0569, 0.2595, -0.0091],
        ),
        (
            "xarm7",
            [1.79295, -2.059, 0.88888, -0.13758, -1.93899, 1.7364, -2.87033],
            [2.3537, 0.0, -0.0883, -0.8752, -1.3023, 1.2347, -1.3397],
            [0.0966, -0.0462, -0.1212, 0.083, -0.0087, -0.1703],
        ),
        (
            "baxter_left",
            [-0.97205, -2.147, 3.05417, 2.6179, -3.0492, 0.79964, -1.17714],
            [-0.4687, 0.0, 0.0, 0.0, -0.6249, 0.0571, 0.0362],
            [0.022, -0.004, -0.0353, -0.0847, 0.2903, 0.2587],
        ),
        (  # other joints brake less: this one begins earlier than it has to
            "baxter_left",
            [0.053632, -1.665595, -0.192967, 0.676943, 2.96745, -1.539022, -0.726483],
            [-0.17269, 0.26413, -0.08733, -0.69949, 0.37087, -0.69254, -0.04247],
            [-0.07306, -0.05763, -0.01576, 0.03325, 0.33349, 0.00619],
        ),
    ],
)
def test_the_tool_does_not_move_backward_where_a_joint_brakes_at_its_limit(servos, name, q, qd, twist):
    """States of random streams in which a joint is about to reach its limit; the tool moved backward by 15 to 30 % of the twist."""
    servo, q, qd, twist = servos(name), np.array(q), np.array(qd), np.array(twist)
    command = SCALE * twist
    for _ in range(80):
        qd = servo.step(q, qd, twist, "world")
        assert command @ kinematics(servo.robot, q)[1] @ qd > -0.02 * command @ command
        q = q + DT * qd


def test_the_guard_of_a_fold_does_not_move_the_tool_backward(servos):
    """The fold appears too late to stop in time; the tool moved backward by a quarter of the twist."""
    servo, twist = servos("baxter_left"), np.array([-0.03241, 0.08292, -0.03747, 0.08423, -0.01165, 0.01453])
    q = np.array([1.014429, 0.750563, 1.802662, 0.286033, -3.032927, -0.028797, -0.709191])
    qd = np.array([0.84327, -0.39817, -0.32387, -1.5, 0.08682, -0.79119, 0.79187])
    for _ in range(60):
        qd = servo.step(q, qd, twist, "world")
        assert SCALE * twist @ kinematics(servo.robot, q)[1] @ qd > -0.02 * (SCALE * twist) @ (SCALE * twist)
        q = q + DT * qd


def test_a_way_out_of_a_pole_does_not_move_the_tool_backward(servos):
    """Along what a UR5 loses where it is slightly a fold: joints that turn the lost direction away moved the tool backward by 5 %."""
    servo, twist = servos("ur5"), np.array([0.05524, -0.08096, 0.0, 0.04245, 0.02896, 0.04178])
    start = [0.598733, -0.830679, -2.718959, 1.296143, -0.831564, 1.271965]
    path, rates = drive(servo, start, lambda t: twist * min(t / 0.1, 1), 0.3)
    for k in range(10, 150):
        command = SCALE * twist * min(k * DT / 0.1, 1)
        assert command @ kinematics(servo.robot, path[k])[1] @ rates[k + 1] > -0.02 * command @ command


@pytest.mark.parametrize("speed", [1e-5, 1e-4])
@pytest.mark.parametrize("name", SINGULAR)
def test_joints_creep_where_the_command_does(servos, name, speed):
    """A command of 0.01 mm/s along a lost direction once turned a joint at 1.7 rad/s."""
    arm, start = SINGULAR[name]
    for i in range(12):
        servo, twist = servos(arm), np.zeros(6)
        twist[i // 2] = (1 - 2 * (i % 2)) * speed / SCALE[i // 2]
        assert np.abs(drive(servo, start, twist, 0.1)[1]).max() <= 1500 * speed


def least_singular_value(robot, q):
    return np.linalg.svd(kinematics(robot, q)[1], compute_uv=False)[-1]


def either_side(robot, sigma, rng):
    """Two postures (n,), 1e-12 rad apart, between which the smallest singular value passes sigma."""
    lower, upper = np.maximum(robot.limits.lower, -3) + 0.3, np.minimum(robot.limits.upper, 3) - 0.3
    ends = {}
    while len(ends) < 2:
        q = rng.uniform(lower, upper)
        ends[least_singular_value(robot, q) > sigma] = q
    for _ in range(40):
        middle = (ends[True] + ends[False]) / 2
        ends[least_singular_value(robot, middle) > sigma] = middle
    return ends.values()


@pytest.mark.parametrize("name", ["panda", "ur5", "xarm7"])
@settings(deadline=None)
@given(data=st.data())
def test_the_gauge_has_a_lower_bound_of_the_singular_values_which_is_exact_where_they_are_small(servos, name, data):
    servo = servos(name)
    lower, upper = np.maximum(servo.robot.limits.lower, -3), np.minimum(servo.robot.limits.upper, 3)
    shares = st.lists(st.floats(0.1, 0.9), min_size=servo.robot.n, max_size=servo.robot.n)
    q = lower + np.array(data.draw(shares)) * (upper - lower)
    servo.step(q, np.zeros(servo.robot.n), np.array([0.01, -0.02, 0.01, 0.02, 0.01, -0.01]), "world")
    least = least_singular_value(servo.robot, q)
    assert min(least, 0.12) - 1e-12 <= servo.gauge.smallest <= least + 1e-12


@pytest.mark.parametrize("sigma", [0.12, 0.03, 0.02, 0.01])
@pytest.mark.parametrize("name", ["panda", "ur5"])
@settings(deadline=None, max_examples=8)
@given(seed=st.integers(0, 2**31))
def test_the_law_is_continuous_where_singular_values_become_small(name, sigma, seed):
    robot, rng = robot_without_jerk(name), np.random.default_rng(seed)
    servo = Servo(robot.with_limits(acceleration=1e4), dt=DT)
    twist = rng.standard_normal(6)
    twist *= 0.1 / np.linalg.norm(SCALE * twist)
    rates = []
    for q in either_side(robot, sigma, rng):
        servo.reset()
        rates.append(servo.step(q, np.zeros(robot.n), twist, "world"))
    assert np.allclose(*rates, rtol=0, atol=5e-3)


@pytest.mark.parametrize(
    ("name", "least", "q", "twist"),
    [
        (
            "xarm7",
            0.4,
            [-2.220372423, -9.666e-06, -1.578306304, -0.140249197, -0.026791531, 1.419728252, 2.221445081],
            [-0.0061, 0.00482, -0.09434, -0.06336, -0.08679, -0.00021],
        ),
        (
            "panda",
            0.03,
            [0.356407124, -1.1974e-05, 1.710371846, -0.313270023, -0.723790768, 1.68194761, -0.787433494],
            [0.00595, -0.00773, -0.0808, 0.18823, -0.04144, 0.01926],
        ),
    ],
)
def test_a_spin_out_of_a_singular_posture_moves_the_tool_forward_and_ends_soon(servos, name, least, q, twist):
    servo, rates, followed = servos(name), np.zeros(7), []
    for k in range(round(0.35 / DT)):
        rates = servo.step(q, rates, np.array(twist) * min(k * DT / 0.1, 1.0), "world")
        q = q + DT * rates
        followed.append(servo.gauge.followed)
    assert min(followed) > -0.005 and np.mean(followed[round(0.25 / DT) :]) > least


def reversals(robot, rates):
    """Changes of sign of accelerations above 2 % of the limit, per joint, of the rates (N, n) of all steps."""
    changes = np.diff(rates, axis=0) / DT
    loud = np.where(np.abs(changes) > 0.02 * robot.limits.acceleration, np.sign(changes), 0.0)
    return [np.count_nonzero(np.diff(joint[joint != 0])) for joint in loud.T]


@pytest.mark.parametrize(
    ("name", "q", "qd", "twist"),
    [
        (  # a small σ beside a direction that the joints at their limits take away
            "baxter_left",
            [-0.26851, 0.554488, 3.05418, 0.2082, 3.059, 0.667185, -0.744867],
            [-0.03874, -0.13439, 0.0, -0.02812, 0.0, -0.02967, -0.19306],
            [0.1994, 0.06416, 0.06286, -0.14357, 0.21108, 0.13832],
        ),
        (  # of the joints that are not at their limits one does not move the tool
            "so100",
            [1.999998, 1e-06, -3.141578, -1.872763, 0.058275],
            [0.0, 0.0, 0.0, 0.24507, -0.3716],
            [-0.00517, -0.03071, -0.03593, 0.0, 0.0, 0.0],
        ),
    ],
)
def test_it_does_not_dither_where_joints_stand_at_their_limits(servos, name, q, qd, twist):
    servo, q, rates = servos(name), np.array(q), [np.array(qd)]
    for _ in range(150):
        rates.append(servo.step(q, rates[-1], twist, "world"))
        q = q + DT * rates[-1]
    assert max(reversals(servo.robot, np.array(rates))) <= 6


def test_jerk_limits_are_kept_in_equal_steps():
    robot = mp.load_robot("panda")
    servo = Servo(robot, dt=DT)
    rng = np.random.default_rng(0)
    twists = [np.concatenate([0.3 * rng.standard_normal(3), rng.standard_normal(3)]) for _ in range(8)]
    _, velocity = drive(servo, np.array([0.3, -0.3, 0.2, -2.0, 0.1, 1.8, 0.5]), lambda t: twists[min(int(t / 0.25), 7)], 2.0)
    jerk = np.diff(velocity, 2, axis=0) / DT**2
    assert (np.abs(jerk) <= robot.limits.jerk * (1 + 1e-6)).all()


BAD = [
    ("twist", np.full(6, np.nan)),
    ("twist", np.array([np.inf, 0, 0, 0, 0, 0])),
    ("pose", np.zeros((4, 4))),
    ("pose", np.full((4, 4), np.nan)),
    ("pose", np.diag([1.0, 1.0, -1.0, 1.0])),
    ("joints", np.full(6, np.nan)),
    ("twist", np.array([1e10, 0, 0, 0, 0, 0])),
    ("joints", np.array([0, 0, 0, 0, 0, -1e6])),
]


@pytest.mark.parametrize(("mode", "value"), BAD)
def test_wrong_commands_brake(servos, mode, value):
    servo = servos("ur5")
    q, qd = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3]), np.full(6, 0.1)
    call = {"twist": servo.step, "pose": servo.step_pose, "joints": servo.step_joints}[mode]
    braked = call(q, qd, value)
    assert servo.status is ServoStatus.BAD_COMMAND
    assert np.allclose(braked, np.maximum(qd - servo.robot.limits.acceleration * DT, 0.0))
    servo.step(q, qd, None, "world")
    assert servo.status is ServoStatus.STALE
    again = servo.step(q, np.zeros(6), np.array([0.01, 0, 0, 0, 0, 0]), "world")
    assert servo.status is ServoStatus.FOLLOWING
    assert np.abs(again).max() > 0


@pytest.mark.parametrize("axes", [np.zeros((3, 3)), 2 * np.eye(3), np.diag([1.0, 1.0, -1.0]), np.full((3, 3), np.nan)])
@pytest.mark.parametrize("free", [None, ("rz",)])
def test_axes_that_are_no_rotation_brake(servos, axes, free):
    servo = servos("ur5")
    q, qd = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3]), np.full(6, 0.1)
    braked = servo.step(q, qd, np.full(6, 0.01), axes, free=free)
    assert servo.status is ServoStatus.BAD_COMMAND
    assert np.allclose(braked, np.maximum(qd - servo.robot.limits.acceleration * DT, 0.0))
    servo.step(q, qd, np.full(6, 0.01), "tool")
    assert servo.status is ServoStatus.FOLLOWING


@pytest.mark.parametrize("free", [None, ("x",)])
def test_axes_that_are_no_rotation_brake_without_a_new_twist(servos, free):
    servo = servos("ur5")
    q, qd = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3]), np.zeros(6)
    for _ in range(20):
        qd = servo.step(q, qd, np.full(6, 0.01), "world")
    braked = servo.step(q, qd, None, np.full((3, 3), np.nan), free=free)
    assert servo.status is ServoStatus.BAD_COMMAND
    assert np.isfinite(braked).all()


def test_a_refused_call_does_not_change_the_axes(servos):
    servo = servos("ur5")
    q, twist = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3]), np.array([0.001, 0, 0, 0, 0, 0])
    usual = servo.step(q, np.zeros(6), twist, "world")
    with pytest.raises(mp.errors.InvalidInputError, match="free"):
        servo.step(q, np.zeros(6), twist, "tool", free=("w",))
    servo.reset()
    assert (servo.step(q, np.zeros(6), twist, "world") == usual).all()


def test_a_jog_ends_a_stream_of_twists(servos):
    servo = servos("ur5")
    q = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3])
    servo.step(q, np.zeros(6), np.array([0.1, 0, 0, 0, 0, 0]), "world")
    servo.step_joints(q, np.zeros(6), np.zeros(6))
    assert not servo.step(q, np.zeros(6), None, "world").any()


@pytest.mark.parametrize(
    ("name", "changes", "seeds"), [("bravo7_gripper", {}, [25]), ("ur5", {"velocity": np.inf, "acceleration": 10.0}, [55, 30])]
)
def test_joints_without_a_velocity_limit(name, changes, seeds):
    """Near singular postures, where their ways out were infinitely fast."""
    robot = mp.load_robot(name)
    robot = robot.with_limits(**changes) if changes else robot
    servo, limits = Servo(robot, dt=0.001, compiled=False), robot.limits
    low, high = np.where(np.isfinite([limits.lower, limits.upper]), [limits.lower, limits.upper], [[-3.0], [3.0]])
    for seed in seeds:
        rng = np.random.default_rng(seed)
        servo.reset()
        q, qd = low + rng.random(6) * (high - low), np.zeros(6)
        q[2] = np.clip(0.0, low[2], high[2]) if seed % 2 else q[2]
        twist = 0.2 * rng.normal(size=6)
        for _ in range(200):
            qd = servo.step(q, qd, twist, "world")
            assert np.isfinite(qd).all()
            assert servo.status is ServoStatus.FOLLOWING
            q = q + servo.dt * qd


@pytest.mark.parametrize("is_jog", [True, False])
def test_a_fast_arm_brakes_before_an_obstacle(is_jog):
    """A stretched UR5 that turns about its base at full speed: from 0.1 m on it could not stop before the ball."""
    robot, q, qd = mp.load_robot("ur5"), np.array([0.0, -0.6, 0.8, -0.2, 1.2, 0.0]), np.zeros(6)
    data, frame, least = robot.model.createData(), robot.model.getFrameId(robot.tool), np.inf

    def tool(at):
        pin.framesForwardKinematics(robot.model, data, at)
        return data.oMf[frame].translation.copy()

    ball = mp.Sphere(radius=0.1, position=tool(q + np.array([1.6, 0, 0, 0, 0, 0])), name="ball")
    servo = Servo(robot, dt=DT, avoidance=mp.Avoidance(scene=mp.Scene([ball]), itself=False), compiled=False)
    for _ in range(round(2.0 / DT)):
        if is_jog:
            qd = servo.step_joints(q, qd, [3.1, 0, 0, 0, 0, 0])
        else:
            x, y, _ = tool(q)
            around = 2.0 / np.hypot(x, y)
            qd = servo.step(q, qd, [-around * y, around * x, 0, 0, 0, around], "world")
        q = q + DT * qd
        least = min(least, servo.gauge.clearance, float(np.linalg.norm(tool(q) - ball.pose.translation)) - 0.1)
    assert 0.019 < least < 0.09


def test_an_obstacle_that_comes_from_afar_does_not_move_the_arm():
    """Links with little leverage toward it, which cannot flee, do not turn the joints."""
    robot, q, qd = mp.load_robot("ur5"), np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3]), np.zeros(6)
    ball = mp.Sphere(radius=0.1, position=(3.0, 0.5, 0.3), name="ball")
    avoidance = mp.Avoidance(scene=mp.Scene([ball]), itself=False, moving=["ball"])
    servo = Servo(robot, dt=DT, avoidance=avoidance, compiled=False)
    for k in range(200):
        pose = pin.SE3(np.eye(3), np.array([3.0 - 2.0 * k * DT, 0.5, 0.3]))
        qd = servo.step(q, qd, np.zeros(6), "world", obstacles={"ball": (pose, [-2.0, 0, 0, 0, 0, 0])})
        assert np.abs(qd).max() < 1e-9 and servo.status is ServoStatus.FOLLOWING
        q = q + DT * qd


@pytest.mark.parametrize("seed", [22801, 27737, 28999])
def test_rounding_of_large_multipliers_is_no_failure(servos, seed):
    servo, rng = servos("panda"), np.random.default_rng(seed)
    limits = servo.robot.limits
    q, qd = rng.uniform(limits.lower, limits.upper), rng.uniform(-1, 1, 7) * limits.velocity
    servo.step(q, qd, 10 * rng.normal(size=6), "world", dt=5 * DT)
    assert servo.status is ServoStatus.FOLLOWING


def test_without_a_singularity_ahead_it_is_infinitely_far(servos):
    servo = servos("ur5")
    q = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3])
    for twist in (np.zeros(6), np.array([0, 0, 0, 0.01, 0, 0])):
        servo.step(q, np.zeros(6), twist, "world")
        assert servo.gauge.seconds == servo.gauge.metres == np.inf


def test_wrong_states_and_time_steps(servos):
    servo = servos("ur5")
    q, twist = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3]), np.array([0.01, 0, 0, 0, 0, 0])
    assert (servo.step(np.full(6, np.nan), np.zeros(6), twist) == 0).all()
    assert servo.status is ServoStatus.BAD_STATE
    for dt in (0.0, -1.0, np.nan, np.inf, 6 * DT):
        braked = servo.step(q, np.full(6, 0.1), twist, dt=dt)
        assert servo.status is ServoStatus.BAD_TIME_STEP
        assert (braked < 0.1).all()
    for outside in (servo.robot.limits.upper + 0.1, servo.robot.limits.lower - 0.1):
        qd = servo.step(outside, np.zeros(6), twist)
        back = np.sign(servo.robot.limits.upper - outside)
        assert (back * qd > 0).all()


def test_a_stream_that_stops(servos):
    servo = servos("ur5", timeout=0.05)
    q, qd = np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3]), np.zeros(6)
    twist = np.array([0.05, 0, 0, 0, 0, 0.0])
    for _ in range(50):
        qd = servo.step(q, qd, twist, "world")
        q = q + DT * qd
    statuses = []
    for _ in range(60):
        qd = servo.step(q, qd, None, "world")
        q = q + DT * qd
        statuses.append(servo.status)
    assert statuses[:24] == [ServoStatus.FOLLOWING] * 24
    assert statuses[-1] is ServoStatus.STALE
    assert (qd == 0).all()


def test_a_pose_is_reached_and_joints_are_jogged(servos):
    servo = servos("panda")
    q, qd = np.array([0.3, -0.3, 0.2, -2.0, 0.1, 1.8, 0.5]), np.zeros(7)
    goal, _ = kinematics(servo.robot, q + 0.2)
    for _ in range(1500):
        qd = servo.step_pose(q, qd, goal)
        q = q + DT * qd
    assert np.linalg.norm(moved(kinematics(servo.robot, q)[0], goal)) < 1e-4
    velocity = servo.step_joints(q, qd, 1e-3 * np.ones(7))
    assert np.allclose(velocity, 1e-3, atol=2e-2)
    half_turn = kinematics(servo.robot, q)[0] * pin.SE3(np.diag([1.0, -1.0, -1.0]), np.zeros(3))
    servo.step_pose(q, qd, half_turn)
    assert servo.status is ServoStatus.FOLLOWING


@settings(deadline=None, max_examples=20)
@given(
    acceleration=st.floats(0.2, 30.0),
    dt=st.sampled_from([0.002, 0.01, 0.02]),
    smoothing=st.sampled_from([0.0, 0.05, 0.2]),
    late=st.integers(0, 2),
    seed=st.integers(0, 2**31),
)
@pytest.mark.parametrize("name", ["ur3", "kinova"])
def test_a_pose_is_approached_no_faster_than_the_joints_can_stop_there(name, acceleration, dt, smoothing, late, seed):
    """With accelerations of 0.3 rad/s² a tool went 0.2 m beyond its goal, and 0.11 m to and fro after ten seconds.

    Where positions are a step or more late, joints did not come to rest.
    """
    robot = robot_without_jerk(name).with_limits(acceleration=acceleration)
    servo, rng = Servo(robot, dt=dt, smoothing=smoothing), np.random.default_rng(seed)
    q = {"ur3": np.array([0.2, -1.3, 1.5, -1.2, 0.8, 0.3]), "kinova": np.array([0.5, 3.2, 1.6, 0.3, 1.2, 0.4])}[name]
    goal, _ = kinematics(robot, q + rng.uniform(-0.3, 0.3, 6))
    begin = moved(goal, kinematics(robot, q)[0])
    qd, beyond, positions = np.zeros(6), 0.0, [q] * (late + 1)
    for _ in range(round(30 / dt)):
        qd = servo.step_pose(positions[0], qd, goal)
        q = q + dt * qd
        positions = [*positions[1:], q]
        left = moved(goal, kinematics(robot, q)[0])
        beyond = max(beyond, -float(left @ begin) / float(np.linalg.norm(begin)))
        if np.linalg.norm(left) < 1e-5 and np.abs(qd).max() < 1e-4:
            break
    assert beyond < 1e-3 + 0.1 * late * dt  # a late position shows the tool farther away than it is
    assert np.linalg.norm(left) < 1e-4


#: Tasks with a free rotation, and its axis: in the tool, or in the world, or None where all rotations are free.
FREE_TURNS = {
    "tool": (mp.Task.pointing(), (0.0, 0.0, 1.0)),
    "slanted": (mp.Task.pointing((0.6, 0.0, -0.8)), (0.6, 0.0, -0.8)),
    "world": (mp.Task.custom(np.eye(6)[:5] * [1, 1, 1, 0.3, 0.3, 0.3], name="level"), (0.0, 0.0, 1.0)),
    "all": (mp.Task.position(), None),
}


@settings(deadline=None, max_examples=8)
@given(st.one_of(st.just(np.pi), st.floats(-np.pi, np.pi)), st.integers(0, 2**31))
@pytest.mark.parametrize("name", FREE_TURNS)
def test_a_pose_is_reached_but_for_the_turns_that_are_free(servos, name, angle, seed):
    """Also where the tool stands half a turn from it: the free turn does not bend the way there."""
    task, axis = FREE_TURNS[name]
    servo, rng = servos("ur5", task=task), np.random.default_rng(seed)
    q, qd = np.array([0.3, -1.3, 1.6, -1.2, 1.2, 0.3]), np.zeros(6)
    goal, _ = kinematics(servo.robot, q + rng.uniform(-0.25, 0.25, 6))
    turn = pin.exp3(rng.uniform(-2, 2, 3) if axis is None else angle * np.array(axis))
    goal.rotation = turn @ goal.rotation if name == "world" else goal.rotation @ turn
    for _ in range(2000):
        qd = servo.step_pose(q, qd, goal)
        q = q + DT * qd
    reached, _ = kinematics(servo.robot, q)
    assert np.linalg.norm(reached.translation - goal.translation) < 1e-4
    if name == "world":  # the vertical as the tool sees it
        np.testing.assert_allclose(reached.rotation[2], goal.rotation[2], atol=1e-3)
    elif axis is not None:
        np.testing.assert_allclose(reached.rotation @ axis, goal.rotation @ axis, atol=1e-3)


def test_at_rest_without_a_command(servos):
    servo = servos("panda")
    q = np.array([0.3, -0.3, 0.2, -2.0, 0.1, 1.8, 0.5])
    path, _ = drive(servo, q, np.zeros(6), 1.0)
    assert (path == q).all()


@pytest.mark.slow
def test_obstacles_are_kept_at_a_distance():
    """A ball 0.3 m ahead of the tool, towards which it is driven, and which then comes nearer by itself."""
    robot = robot_without_jerk("ur5")
    q, qd = np.array([0.0, -1.6, 2.0, -2.0, -1.57, 0.3]), np.zeros(6)
    tool = kinematics(robot, q)[0].translation
    centre = tool + [0.0, 0.35, 0.0]
    ball = mp.Sphere(radius=0.05, position=centre, name="ball")
    avoidance = mp.Avoidance(scene=mp.Scene([ball]), moving=("ball",), influence=0.1, security=0.02)
    servo = Servo(robot, dt=DT, avoidance=avoidance)
    twist, clearances, reasons = np.array([0.0, 0.2, 0.0, 0.0, 0.0, 0.0]), [], set()
    for _ in range(1500):
        qd = servo.step(q, qd, twist, "world")
        q = q + DT * qd
        clearances.append(servo.gauge.clearance)
        reasons.add(servo.gauge.reason)
    assert 0.019 < min(clearances) < 0.03
    assert ServoLimit.OBSTACLE in reasons
    pose = np.eye(4)
    pose[:3, 3] = kinematics(robot, q)[0].translation + [0.0, 0.25, 0.0]
    for _ in range(1000):
        pose[1, 3] -= DT * 0.1
        qd = servo.step(q, qd, np.zeros(6), "world", obstacles={"ball": (pose, [0, -0.1, 0, 0, 0, 0])})
        q = q + DT * qd
        assert servo.gauge.clearance > 0.015
    servo.step(q, qd, twist, "world", obstacles={"ball": (pose, np.full(6, np.nan))})
    assert servo.status is ServoStatus.BAD_COMMAND


def test_an_obstacle_that_is_not_given_rests():
    """One that was on its way out of the arm's way, too."""
    robot = robot_without_jerk("ur5")
    q, qd = np.array([0.0, -1.6, 2.0, -2.0, -1.57, 0.3]), np.zeros(6)
    pose = np.eye(4)
    pose[:3, 3] = kinematics(robot, q)[0].translation + [0.0, 0.35, 0.0]
    ball = mp.Sphere(radius=0.05, position=pose[:3, 3], name="ball")
    avoidance = mp.Avoidance(scene=mp.Scene([ball]), moving=("ball",), itself=False)
    servo, clearances = Servo(robot, dt=DT, avoidance=avoidance, compiled=False), []
    for k in range(1500):
        obstacles = {"ball": (pose, [0.0, 0.5, 0.0, 0.0, 0.0, 0.0])} if k == 0 else None
        qd = servo.step(q, qd, np.array([0.0, 0.2, 0.0, 0.0, 0.0, 0.0]), "world", obstacles=obstacles)
        q = q + DT * qd
        clearances.append(servo.gauge.clearance)
    assert min(clearances) > 0.019
    assert (servo.obstacles[12:] == 0).all()


@pytest.mark.slow
def test_arms_of_many_kinds():
    """Rails, branches and followers: the rows that count are followed where nothing limits."""
    for robot in (mp.load_robot("tiago"), mp.load_robot("talos_torso_right_arm"), mp.planar_arm([0.5, 0.4, 0.3])):
        servo = Servo(robot, dt=DT)
        rng = np.random.default_rng(5)
        low, high = np.maximum(robot.limits.lower, -2), np.minimum(robot.limits.upper, 2)
        q = low + (high - low) * rng.uniform(0.3, 0.7, robot.n)
        task = robot.kinematics(servo.task)
        jacobian = task.jacobian(q)
        twist = 1e-4 * rng.standard_normal(6)
        twist[2:] *= servo.task.rows > 2
        qd = servo.step(q, np.zeros(robot.n), twist, "world")
        world, _ = servo.task.matrices
        assert np.allclose(jacobian @ qd, world @ twist, atol=1e-9), robot.name


def test_what_is_refused(servos):
    robot = mp.load_robot("ur5")
    for argument, value in {"dt": 0.0, "side": "left", "smoothing": -1.0, "timeout": np.nan}.items():
        with pytest.raises(mp.errors.InvalidInputError, match=argument):
            Servo(robot, **{"dt": DT} | {argument: value})
    with pytest.raises(mp.errors.InvalidInputError, match="one tool"):
        Servo(mp.load_robot("baxter"), dt=DT)
    with pytest.raises(mp.errors.InvalidInputError, match="region"):
        Servo(robot, dt=DT, task=mp.Task.pose().within(position=0.01))
    servo, q = servos("ur5"), np.array([0.2, -1.2, 1.4, -1.0, 1.1, 0.3])
    for wrong in (np.zeros(5), np.zeros((6, 1)), "x", None):
        with pytest.raises(mp.errors.InvalidInputError, match="q:"):
            servo.step(wrong, np.zeros(6), np.zeros(6))
    with pytest.raises(mp.errors.InvalidInputError, match="twist"):
        servo.step(q, np.zeros(6), np.zeros(3))
    with pytest.raises(mp.errors.InvalidInputError, match="tool"):
        servo.step(q, np.zeros(6), np.zeros(6), "tol")
    with pytest.raises(mp.errors.InvalidInputError, match="frame"):
        servo.step(q, np.zeros(6), np.zeros(6), np.eye(4))
    with pytest.raises(mp.errors.InvalidInputError, match="free"):
        servo.step(q, np.zeros(6), np.zeros(6), free=("roll",))
    with pytest.raises(mp.errors.InvalidInputError, match="five"):
        servo.step(q, np.zeros(6), np.zeros(6), free=("x", "y", "z", "rx", "ry", "rz"))


@pytest.mark.compiler
def test_machine_code_and_virtual_machine_agree_bit_by_bit():
    robot = mp.load_robot("panda")
    rng = np.random.default_rng(5)
    twists = [np.concatenate([0.2 * rng.standard_normal(3), rng.standard_normal(3)]) for _ in range(10)]
    paths = []
    for compiled in (False, True):
        servo = Servo(robot, dt=DT, compiled=compiled)
        assert servo.compiled is compiled
        paths.append(drive(servo, SINGULAR["panda shoulder and wrist"][1], lambda t: twists[int(t / 0.2)], 1.9)[0])
    assert np.array_equal(*paths)


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("name", ["panda", "so100", "panda with a plan"])
def test_the_exported_servo_has_the_same_bits(name, tmp_path):
    robot, plan = mp.load_robot(name.partition(" ")[0]), None
    if name == "panda with a plan":
        begin = np.array(robot.kinematics().pose(robot.neutral))
        end = begin.copy()
        end[0, 3] += 0.2
        plan = mp.follow(robot, mp.CartesianPath.line(begin, end), start=robot.neutral, positions=6, samples=120)
    servo = Servo(robot, dt=DT, reference=plan, compiled=False)
    servo.export_c(tmp_path)
    command = [
        *find_compiler(),
        "-O2",
        "-ffp-contract=off",
        "example.c",
        "servo.c",
        "problem.c",
        "-o",
        "example",
        "-lm",
    ]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    printed = subprocess.run([str(tmp_path / "example")], capture_output=True, text=True, check=True).stdout
    found = np.array([[float(word) for word in line.split()] for line in printed.splitlines()])
    q, qd, expected = np.array(robot.neutral), np.zeros(robot.n), []
    for k in range(2000):
        qd = servo.step(q, qd, [0.1 if k < 1000 else -0.1, 0, 0, 0, 0, 0], "world")
        q = q + DT * qd
        gauge = servo.gauge
        expected.append([*q, gauge.status, gauge.followed, gauge.seconds])
    assert np.array_equal(found, expected)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("cmake") is None, reason="there is no cmake")
def test_the_exported_project_builds_by_cmake(tmp_path):
    mp.Servo(mp.load_robot("ur5"), dt=DT, compiled=False).export_c(tmp_path / "servo")
    for command in (["cmake", "-S", "servo", "-B", "build"], ["cmake", "--build", "build"], ["build/example"]):
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)


def test_what_is_followed_is_not_turned_with_what_has_vanished(servos):
    """A joint at its limit takes one direction away; the tool moved backward along another one, whose σ is 17 mm."""
    servo, twist = servos("so100"), np.array([-0.0181, 0.09817, -0.00587, 0.0, 0.0, 0.0])
    q = np.array([2.0, 3.305181, -2.958311, -0.860079, -2.418525])
    qd = np.array([0.0, 0.326785, -0.447363, -0.160505, 0.002478])
    for _ in range(80):
        qd = servo.step(q, qd, twist, "world")
        assert twist[:3] @ kinematics(servo.robot, q)[1][:3] @ qd > -0.02 * twist @ twist
        q = q + DT * qd


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_oblique_command_bends_a_straight_elbow(servos, sign):
    """Downward from a straight elbow: other rows move it to the wrong side first, from where the way out leads back through 0."""
    path, _ = drive(servos("ur5"), STRAIGHT + 1e-17 * sign, [0.0, 0.0, -0.1, 0.0, 0.0, 0.0], 0.3)
    assert abs(path[-1, 2]) > 0.2


@pytest.mark.parametrize(
    ("name", "start"),
    [
        ("ur5", [0.0730953, 2.6326706, -2.2683485, 2.8262597, -1.1640137, -0.4740868]),
        ("ur5", [2.873, -1.841, -2.916, -3.004, 2.475, 1.6]),
    ],
)
@pytest.mark.parametrize("sign", [1, -1])
def test_it_does_not_dither_between_a_pole_and_a_fold(servos, name, start, sign):
    """Commanded along what is lost, at singular postures of a small curvature."""
    servo = servos(name)
    _, jacobian = kinematics(servo.robot, np.array(start))
    lost = sign * np.linalg.svd(jacobian)[0][:, -1]
    _, rates = drive(servo, start, 0.1 * lost / SCALE, 1.0)
    assert max(reversals(servo.robot, rates)) <= 6


@pytest.mark.slow
@pytest.mark.parametrize("name", [each for each in mp.available_robots() if each not in ("baxter", "asr_twodof")])
def test_exact_zeros_of_the_catalogue_are_left(name):
    """From all joints at zero, in both signs of zero: no stall in a direction that another posture within 0.8 rad reaches."""
    try:
        robot = robot_without_jerk(name)
        servo = Servo(robot, dt=DT)
    except mp.errors.InvalidInputError:
        pytest.skip("more joints or tools than a servo takes")
    zero = np.clip(np.zeros(robot.n), robot.limits.lower, robot.limits.upper)
    start, _ = kinematics(robot, zero)
    world, _ = servo.task.matrices
    rows = [int(np.flatnonzero(row)[0]) for row in world]
    rng = np.random.default_rng(0)
    for row, sign, zero_sign in itertools.product(rows, (1, -1), (1.0, -1.0)):
        twist = np.zeros(6)
        twist[row] = sign * (0.1 if row < 3 else 0.1 / 0.3)
        direction = SCALE * twist / np.linalg.norm(SCALE * twist)
        servo.reset()
        path, _ = drive(
            servo,
            np.where(zero == 0, 0.0 * zero_sign, zero),
            twist,
            1.5,
            after=lambda x, d=direction: d @ moved(start, kinematics(robot, x)[0]) > 0.02,
        )
        if direction @ moved(start, kinematics(robot, path[-1])[0]) > 0.005:
            continue
        goal = pin.SE3(pin.exp3(twist[3:] * 0.05) @ start.rotation, start.translation + twist[:3] * 0.05)  # 5 mm ahead
        assert not reaches(servo, goal, zero, rng), (name, row, sign)


def reaches(servo, goal, start, rng):
    """Whether a posture within 0.8 rad has the goal's rows, by damped Newton steps."""
    robot = servo.robot
    rows = [int(np.flatnonzero(row)[0]) for row in servo.task.matrices[0]]
    for trial in range(20):
        q = start + (0.25 * rng.standard_normal(robot.n) if trial else 0)
        for _ in range(60):
            pose, jacobian = kinematics(robot, q)
            error, part = moved(pose, goal)[rows], jacobian[rows]
            if np.linalg.norm(error) < 1e-6:
                inside = (q >= robot.limits.lower).all() and (q <= robot.limits.upper).all()
                if inside and np.abs(q - start).max() < 0.8:
                    return True
                break
            step = part.T @ np.linalg.solve(part @ part.T + (1e-4 * np.linalg.norm(error) + 1e-12) * np.eye(len(rows)), error)
            q = q + step * min(1.0, 0.3 / (np.abs(step).max() + 1e-12))
    return False


#: Arms with a joint at its limit near singular postures: name, q, qd, twist in the world.
AT_LIMITS = [
    (
        "baxter_left",
        [-1.582256, -0.567599, 3.054179, 0.768327, -1.82405, -0.894052, -1.408978],
        [-0.0985, 0.273, 0.0, 0.9609, 0.9546, 0.0693, -0.9361],
        [-0.1285, 0.0217, -0.0629, 0.1706, -0.0882, 0.2549],
    ),
    (
        "baxter_left",
        [1.27034, -1.548893, 3.054179, 0.166508, 0.174233, 0.051349, 0.503808],
        [0.2177, 0.0138, 0.0, 0.0581, -0.3552, -0.0642, 0.1893],
        [0.023, -0.0146, 0.0948, 0.0148, -0.0297, 0.0443],
    ),
    (
        "panda",
        [-1.222614, -0.990973, -2.897299, -1.268375, -1.2448, 0.215716, 0.238936],
        [-0.0209, -0.4493, 0.0, 0.9788, -1.1109, -0.0105, -0.9372],
        [0.019, 0.2029, 0.0449, 0.3419, 0.115, -0.0187],
    ),
]


@pytest.mark.parametrize(("name", "q", "qd", "twist"), AT_LIMITS)
def test_a_joint_at_its_limit_does_not_make_others_vibrate(servos, name, q, qd, twist):
    """Accelerations seldom change sign from one step to the next; 34 to 98 times while decompositions took turns."""
    servo = servos(name)
    limits = servo.robot.limits
    q, qd, velocities = np.clip(q, limits.lower, limits.upper), np.array(qd), []
    for _ in range(500):
        qd = servo.step(q, qd, np.array(twist), "world")
        q = q + DT * qd
        velocities.append(qd)
    change = np.diff(velocities, axis=0) / DT / limits.acceleration
    turns = (change[1:] * change[:-1] < 0) & (np.abs(change[1:]) > 0.05) & (np.abs(change[:-1]) > 0.05)
    assert turns.sum() <= 20


def test_nothing_is_left_of_a_stream_after_a_reset(servos):
    """What was learned is that of a new servo: way out, sides and joints that stood at their limits included."""
    servo = servos("panda")
    q, qd = SINGULAR["panda shoulder and wrist"][1], np.zeros(7)
    for twist in ([0, 0.1, 0, 0, 0, 0], [0, 0, -0.2, 0, 0, 0], [0.3, 0.2, 0.1, 1, 1, 1]):
        for _ in range(400):
            qd = servo.step(q, qd, np.array(twist, dtype=float), "world")
            q = q + DT * qd
    assert servo.law.has_way
    servo.reset()
    new = Servo(servo.robot, dt=DT)
    for name in (
        "qdd",
        "held",
        "filtered",
        "age",
        "inside",
        "way",
        "stays",
        "reverses",
        "guessed",
        "has_inside",
        "has_way",
        "leaves",
    ):
        learned, first = getattr(servo.law, name), getattr(new.law, name)
        assert list(np.atleast_1d(learned)) == list(np.atleast_1d(first)), name
