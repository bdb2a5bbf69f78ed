"""
A UR5 from its home posture
===========================

.. image:: /pictures/home.jpg
   :alt: A UR5 reaches between the two boards of a shelf; the way of its tool begins
         above the arm.
   :width: 560px

*For programs that begin at an upright, singular home posture.*

Upright, a UR5 is singular three times over: elbow, wrist and shoulder. Nearly every
program starts there. This page plans from there into a shelf, reads what the report
says about singularities, looks for a better configuration of the goal, and plays the
motion in MuJoCo.
"""

# sphinx_gallery_thumbnail_path = "pictures/home.jpg"

import xml.etree.ElementTree as ET

import matplotlib.pyplot as plt
import mujoco
import numpy as np

import manipplan as mp
from manipplan import viz

robot = mp.load_robot("ur5")
home = np.array([0.0, -np.pi / 2, 0.0, -np.pi / 2, 0.0, 0.0])
boards = [
    mp.Box(size=(0.3, 0.8, 0.02), position=(0.65, 0.0, z), name=name)
    for name, z in (("lower", 0.15), ("upper", 0.60))
]
scene = mp.Scene(boards)

# %%
# The tool points into the shelf, between the boards. All configurations that reach this
# pose are listed, and those that touch something are dropped. Take the one nearest to
# the home posture.

pose = np.eye(4)
pose[:3, :3] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]  # z points forward
pose[:3, 3] = [0.60, 0.10, 0.38]
goals = mp.inverse_kinematics(robot, pose).q
goals = goals[(scene.distances(robot, goals) > 0.01).all(axis=1)]
goal = goals[np.linalg.norm(goals - home, axis=1).argmin()]
print(f"{len(goals)} collision-free configurations; nearest: {goal.round(2)}")

# %%
# The report tells in one sentence which singularities the motion meets, and whether
# they can be avoided.

plan = mp.plan(robot, home, goal, scene, clearance=0.01)
print(plan.report)
assert plan.status is mp.Status.OPTIMAL and plan.trajectory.duration < 1.2
assert plan.report.crossing_note.startswith("starts at an elbow, wrist and shoulder")

# %%
# Other configurations reach the same pose, and with the pose as its goal ``plan``
# chooses among them. All motions share the singular start, which makes up nearly all of
# g here, so g hardly differs.

by_pose = mp.plan(robot, home, pose, scene, clearance=0.01)
print(
    f"g {by_pose.result.g:.0f}; {len(by_pose.candidates)} configurations were compared"
)
assert by_pose.status is mp.Status.OPTIMAL and by_pose.result.g <= 1.01 * plan.result.g
assert np.allclose(robot.kinematics().pose(by_pose.path.goal), pose, atol=1e-9)

# %%
# The arm in the shelf, and the manipulability along the motion.

figure = plt.figure(figsize=(11, 4.8), layout="constrained")
left, right = figure.subfigures(1, 2, width_ratios=(1.1, 1))
viz.plot_arm(robot, plan.path, scene, ax=left.add_subplot(projection="3d"))
viz.plot_manipulability(
    robot.kinematics(),
    {"optimised": plan.path, "seed": plan.result.seed},
    ax=right.subplots(),
)

# %%
# A joint motion passes a singularity without trouble, since joint speeds are limited and
# not the speed of the tool. To show that, MuJoCo plays the motion with a servo per joint that also
# holds the arm against gravity. The meshes are left out of its model.

root = ET.parse(robot.source.file).getroot()
for link in root.iter("link"):
    for part in [*link.findall("visual"), *link.findall("collision")]:
        link.remove(part)
spec = mujoco.MjSpec.from_string(ET.tostring(root, encoding="unicode"))
spec.option.timestep = 1e-3
spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
for body in spec.bodies[1:]:
    body.gravcomp = 1
for joint in spec.joints:
    actuator = spec.add_actuator(target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    actuator.set_to_position(kp=4000.0, kv=400.0)
model = spec.compile()
data = mujoco.MjData(model)
data.qpos[:] = home
times = np.arange(0.0, plan.trajectory.duration, spec.option.timestep)
errors = []
for t in times:
    data.ctrl[:] = plan.trajectory(t) + 0.1 * plan.trajectory(t, 1)
    errors.append(data.qpos - plan.trajectory(t))
    mujoco.mj_step(model, data)
print(f"largest error of a joint: {np.degrees(np.abs(errors).max()):.2f} degrees")
assert np.abs(errors).max() < 0.05

fig, ax = plt.subplots(figsize=(7, 2.8), layout="constrained")
ax.plot(times, np.degrees(errors), label=robot.joint_names)
ax.set(xlabel="time [s]", ylabel="error of each joint [°]", xlim=(0, times[-1]))
ax.legend(frameon=False, fontsize=7, ncols=2)
plt.show()
