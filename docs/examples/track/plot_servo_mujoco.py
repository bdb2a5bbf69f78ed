"""
A servo in a closed loop with MuJoCo
====================================

.. image:: /pictures/servo_mujoco.jpg
   :alt: A Panda stretched to the edge of its reach, and the way of its tool.
   :width: 560px

*For teleoperation of an arm that is not ideal.*

A real arm lags behind its commands: its motors have torque limits, its
state arrives late, and so does the command. Here ``mp.Servo`` drives a Panda in MuJoCo
with all three, out to the edge of its reach, sideways, and back. Damped least squares,
the usual remedy at singularities, does the same for comparison.
"""

# %%
# The simulated arm: a position and a velocity actuator per joint with the gains of a
# stiff industrial servo, cut off at the joint's effort limit, and links without meshes.

# sphinx_gallery_thumbnail_path = "pictures/servo_mujoco.jpg"
import collections
import xml.etree.ElementTree as ET

import matplotlib.pyplot as plt
import mujoco
import numpy as np

import manipplan as mp

DT = 0.004  # period of the control loop [s]
DELAY = 2  # steps by which the state is late, and the command again
BANDWIDTH = 60.0  # of the joints' servos [rad/s]
robot = mp.load_robot("panda")
kinematics = robot.kinematics(mp.Task.pose(length=1.0))


def simulated(start):
    """The Panda in MuJoCo at `start`, with its torque limits."""
    root = ET.parse(robot.source.file).getroot()
    for link in root.iter("link"):
        for part in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(part)
    for joint in root.iter("joint"):
        if joint.get("name") not in robot.joint_names:
            joint.set("type", "fixed")
    spec = mujoco.MjSpec.from_string(ET.tostring(root, encoding="unicode"))
    spec.option.timestep = DT / 4
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    for body in spec.bodies[1:]:
        body.gravcomp = 1
    bare = spec.compile()
    data, inertia = mujoco.MjData(bare), np.zeros((robot.n, robot.n))
    data.qpos[:] = start
    mujoco.mj_forward(bare, data)
    for column, unit in zip(inertia, np.eye(robot.n), strict=True):
        mujoco.mj_mulM(bare, data, column, unit)
    for joint, limit, m in zip(
        spec.joints, robot.limits.effort, inertia.diagonal(), strict=True
    ):
        joint.actgravcomp = True
        joint.actfrclimited = True
        joint.actfrcrange = [-limit, limit]
        for gain in ("kp", "kv"):
            actuator = spec.add_actuator(
                target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT
            )
            if gain == "kp":
                actuator.set_to_position(kp=m * BANDWIDTH**2)
            else:
                actuator.set_to_velocity(kv=2 * m * BANDWIDTH)
    model = spec.compile()
    data = mujoco.MjData(model)
    data.qpos[:] = start
    return model, data


# %%
# What the operator does: forward until the arm is stretched and 2 s longer, sideways,
# and back.
FORWARD, SIDE = np.array([0.15, 0.0, 0.06]), np.array([0.0, 0.15, 0.0])


def command(t):
    """Twist (6,) in the world [m/s, rad/s]."""
    for end, velocity in ((4.0, FORWARD), (5.0, SIDE), (8.0, -FORWARD)):
        if t < end:
            return np.concatenate([velocity, np.zeros(3)])
    return np.zeros(6)


# %%
# The loop. The law gets the late measured positions and its own last command, and the
# joints' servos get the integral of the commands.


def run(law, start, seconds=9.0):
    """Record commands, speeds of the tool and torques of the law in the loop."""
    model, data = simulated(start)
    states = collections.deque([start] * (DELAY + 1), maxlen=DELAY + 1)
    commands = collections.deque([np.zeros(robot.n)] * (DELAY + 1), maxlen=DELAY + 1)
    goal, qd = start.copy(), np.zeros(robot.n)
    log = {"q": [], "qd": [], "torque": [], "tool": [], "change": []}
    for k in range(round(seconds / DT)):
        states.append(data.qpos.copy())
        new = law(states[0], qd, command(k * DT))
        log["change"].append((new - qd) / DT)
        qd = new
        commands.append(qd)
        goal = goal + DT * commands[0]
        data.ctrl[0::2], data.ctrl[1::2] = goal, commands[0]
        torque = np.zeros(robot.n)
        for _ in range(4):
            mujoco.mj_step(model, data)
            torque = np.maximum(torque, np.abs(data.qfrc_actuator))
        log["q"].append(data.qpos.copy())
        log["qd"].append(qd)
        log["torque"].append(torque / robot.limits.effort)
        log["tool"].append(kinematics.jacobian(data.qpos) @ data.qvel)
    return {name: np.array(values) for name, values in log.items()}


servo = mp.Servo(robot, dt=DT)


def damped(q, qd, twist):
    """Damped least squares, within the limits of velocity and acceleration."""
    jacobian = kinematics.jacobian(q)
    wanted = jacobian.T @ np.linalg.solve(
        jacobian @ jacobian.T + 0.05**2 * np.eye(6), twist
    )
    wanted /= max(1.0, (np.abs(wanted) / robot.limits.velocity).max())
    change = robot.limits.acceleration * DT
    return np.clip(wanted, qd - change, qd + change)


start = robot.states["default"]
runs = {
    "mp.Servo": run(lambda q, qd, twist: servo.step(q, qd, twist, "world"), start),
    "damped least squares": run(damped, start),
}

# %%
# Speed of the tool along the command. At the edge of the reach both arms only slide
# along it. When the operator pulls back, at 5 s, the servo leaves it at once, and damped
# least squares about a second later, because its damping is largest exactly there.
times = DT * np.arange(len(runs["mp.Servo"]["q"]))
twists = np.array([command(t) for t in times])[:, :3]
size = np.linalg.norm(twists, axis=1)
leaves = (times > 5.3) & (times < 6.0)
speeds = {}
for name, log in runs.items():
    unit = twists / np.maximum(size, 1e-9)[:, None]
    speeds[name] = np.sum(log["tool"][:, :3] * unit, axis=1)
    print(
        f"{name}: {speeds[name][leaves].mean():.2f} of {size[leaves].mean():.2f} m/s "
        f"when it leaves the edge; torque up to {100 * log['torque'].max():.0f} %"
    )
assert speeds["mp.Servo"][leaves].mean() > 0.95 * size[leaves].mean()
assert speeds["damped least squares"][leaves].mean() < 0.5 * size[leaves].mean()
assert min(speeds["mp.Servo"]) > -0.002  # [m/s]: never backward, in spite of the delay

# %%
# The servo's commands keep the limits of velocity and acceleration, the simulated joints
# those of position, and no torque is cut off.
log, limits = runs["mp.Servo"], robot.limits
assert (np.abs(log["qd"]) <= limits.velocity * (1 + 1e-9)).all()
assert (np.abs(log["change"]) <= limits.acceleration * (1 + 1e-9)).all()
assert (log["q"] > limits.lower).all() and (log["q"] < limits.upper).all()
assert log["torque"].max() < 0.95

figure, (above, below) = plt.subplots(
    2, 1, figsize=(8.0, 5.0), sharex=True, layout="constrained"
)
above.plot(times, size, color="0.5", linestyle="--", label="command")
for (name, log), colour in zip(runs.items(), ("#0072B2", "#D55E00"), strict=True):
    above.plot(times, speeds[name], color=colour, label=name)
    below.plot(times, 100 * log["torque"].max(axis=1), color=colour, label=name)
above.set(ylabel="speed [m/s]", ylim=(-0.01, 0.27))
above.legend(frameon=False, ncols=3, loc="upper right")
below.set(xlabel="time [s]", ylabel="torque [% of the limit]", ylim=(0, 100))
for ax in (above, below):
    ax.spines[["top", "right"]].set_visible(False)
plt.show()
