"""
Play a motion in MuJoCo
=======================

.. image:: /pictures/mujoco_playback.jpg
   :alt: A Panda among five boxes, on its planned path and on the planner's.
   :width: 560px

*For those who want to try a motion in simulation first.*

A plan keeps the velocity, acceleration and jerk limits. Can a simulated arm with servo
control follow it, and which torques does this take? The simulator is MuJoCo, which
shares no code with the planner: its inputs are the robot's URDF and a CSV file.
"""

# %%
# The plan is that of the Panda among five boxes. For comparison, the planner's first
# path, the seed, is timed within the same limits. Both are written as CSV: time,
# positions, velocities and accelerations of all samples.

# sphinx_gallery_thumbnail_path = "pictures/mujoco_playback.jpg"
import csv
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

import matplotlib.pyplot as plt
import mujoco
import numpy as np
from scipy.interpolate import CubicHermiteSpline

import manipplan as mp

problem = mp.demo.panda_among_boxes()
robot = problem.robot
plan = mp.plan(
    robot, problem.start, problem.goal, problem.scene, clearance=problem.clearance
)
assert plan.status is mp.Status.OPTIMAL and plan.report.min_manipulability > 0.009
folder = Path(tempfile.mkdtemp())
plan.trajectory.to_csv(folder / "optimised.csv")
mp.retime(plan.result.seed, robot).to_csv(folder / "seed.csv")

# %%
# MuJoCo's compiler reads the URDF. Meshes are left out, because the motion was already
# checked for collisions, and the fingers are fixed. A servo drives each joint: a
# position actuator and a velocity actuator, kp (q* - q) + kv (q̇* - q̇), plus the
# torque that holds the arm against gravity. The sum is cut off at the joint's effort
# limit. This is what the position interface of an industrial arm does.
BANDWIDTH = 50.0  # of the servos [rad/s], about 8 Hz


def simulated_arm(urdf, fixed, effort, start):
    """A MuJoCo model of the arm with one critically damped servo per joint.

    The gains follow from the joint inertias at `start`.
    """
    root = ET.parse(urdf).getroot()
    for link in root.iter("link"):
        for part in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(part)
    for joint in root.iter("joint"):
        if joint.get("name") in fixed:
            joint.set("type", "fixed")
    spec = mujoco.MjSpec.from_string(ET.tostring(root, encoding="unicode"))
    spec.option.timestep = 1e-3
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    inertia = mass_matrix(spec.compile(), start).diagonal()
    for body in spec.bodies[1:]:
        body.gravcomp = 1
    for joint, limit, m in zip(spec.joints, effort, inertia, strict=True):
        joint.actgravcomp = True
        joint.actfrclimited = True
        joint.actfrcrange = [-limit, limit]
        position = spec.add_actuator(
            target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT
        )
        position.set_to_position(kp=m * BANDWIDTH**2)
        velocity = spec.add_actuator(
            target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT
        )
        velocity.set_to_velocity(kv=2 * m * BANDWIDTH)
    return spec.compile()


def mass_matrix(model, q):
    """M(q), (n, n), by MuJoCo: M times each unit vector."""
    data = mujoco.MjData(model)
    data.qpos[:] = q
    mujoco.mj_forward(model, data)
    columns = np.zeros((model.nv, model.nv))
    for column, unit in zip(columns, np.eye(model.nv), strict=True):
        mujoco.mj_mulM(model, data, column, unit)
    return columns.T


def recorded(file):
    """Times (k,), positions and velocities (k, n) of a CSV file."""
    with file.open() as stream:
        head, *rows = csv.reader(stream)
    data = np.array(rows, dtype=float)
    return [
        data[:, [k for k, name in enumerate(head) if name.startswith(kind)]]
        for kind in ("time", "q_", "qd_")
    ]


def play(model, file, *, feed_forward=False):
    """Follow the file's motion and record the tracking errors and torques.

    Returns times (k,) [s], tracking errors (k, n) [rad] and torques (k, n) [N m].
    With `feed_forward`, the torques that the motion itself needs are added to those of
    the servos: M(q) q̈*, Coriolis and centrifugal torques.
    """
    t, q, qd = recorded(file)
    motion = CubicHermiteSpline(t[:, 0], q, qd)
    data = mujoco.MjData(model)
    data.qpos[:] = q[0]
    times, errors, torques = np.arange(0.0, t[-1, 0], model.opt.timestep), [], []
    for now in times:
        data.ctrl[0::2], data.ctrl[1::2] = motion(now), motion(now, 1)
        if feed_forward:
            mujoco.mj_mulM(model, data, data.qfrc_applied, motion(now, 2))
            data.qfrc_applied += data.qfrc_bias - data.qfrc_gravcomp
        mujoco.mj_step(model, data)
        errors.append(data.qpos - motion(min(now + model.opt.timestep, t[-1, 0])))
        torques.append(data.qfrc_actuator + data.qfrc_applied)
    return times, np.array(errors), np.array(torques)


model = simulated_arm(
    robot.source.file, set(robot.locked), robot.limits.effort, problem.start
)
runs = {
    "optimised": play(model, folder / "optimised.csv"),
    "seed": play(model, folder / "seed.csv"),
    "optimised, with feed-forward": play(
        model, folder / "optimised.csv", feed_forward=True
    ),
}

# %%
# A servo alone does not know the torque that the next acceleration needs, so it lags
# behind. Torque feed-forward from the accelerations of the motion removes most of this
# error.
for name, (times, errors, torques) in runs.items():
    share = np.abs(torques) / robot.limits.effort
    joint = robot.joint_names[int(share.max(axis=0).argmax())]
    print(f"{name}: {times[-1]:.2f} s")
    print(
        f"  tracking error: mean {1e3 * np.abs(errors).mean():.2f}, at most "
        f"{1e3 * np.abs(errors).max():.2f} mrad"
    )
    print(f"  torque: at most {100 * share.max():.0f} % of the effort limit, {joint}")
    assert share.max() < 1
largest = {name: np.abs(errors).max() for name, (_, errors, _) in runs.items()}
assert largest["optimised, with feed-forward"] < largest["optimised"] / 3

# %%
# No torque reaches its limit, so the limits do not distort the motion. The optimised
# path does not need less torque than the seed: both are timed to be as fast as the same
# limits allow, and the optimised path moves the heavy joints faster. Where torque
# matters, ``mp.plan(..., torque=True)`` keeps the effort limits, and lower
# ``acceleration`` limits reduce the torque further.
#
# Top: largest tracking error of any joint. Bottom: largest share of an effort limit.
figure, (above, below) = plt.subplots(
    2, 1, figsize=(8.0, 5.0), sharex=True, layout="constrained"
)
for (name, (times, errors, torques)), colour in zip(
    runs.items(), ("#0072B2", "#D55E00", "#009E73"), strict=True
):
    above.plot(times, 1e3 * np.abs(errors).max(axis=1), color=colour, label=name)
    below.plot(
        times,
        100 * (np.abs(torques) / robot.limits.effort).max(axis=1),
        color=colour,
        label=name,
    )
above.set(ylabel="tracking error [mrad]", ylim=(0, None))
above.legend()
below.set(xlabel="time [s]", ylabel="torque [% of the limit]", ylim=(0, 100))
