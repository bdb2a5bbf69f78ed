"""
Weld a seam with a free tool axis
=================================

.. image:: /pictures/weld_seam.jpg
   :alt: A UR5 with its flange on a straight seam.
   :width: 560px

*For welding, gluing and other work with a round tool.*

The torch of a UR5 follows a seam of 60 cm. A pose has six numbers and the arm has six
joints: if the whole pose is prescribed, the only choice is one of eight postures. But
the torch is round, so its rotation about its own axis does not matter. This one degree
of freedom makes the difference.
"""

# %%
# The torch is mounted at 45 degrees to the flange, as usual, so a rotation about its
# axis moves the whole wrist. Cables limit every joint to half a turn in each direction.

# sphinx_gallery_thumbnail_path = "pictures/weld_seam.jpg"
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

robot = mp.load_robot("ur5").with_limits(lower=-np.pi, upper=np.pi, source="cables")
# the axis of the torch, in the frame of the flange
axis = np.array([1.0, 0.0, 1.0]) / np.sqrt(2)
down = np.array([[1, 0, 0], [0, -1, 0], [0, 0, -1]])  # a flange that points down
tilt = np.array([[1, 0, -1], [0, np.sqrt(2), 0], [1, 0, 1]]) / np.sqrt(2)
start = np.eye(4)
start[:3, :3] = down @ tilt
assert np.allclose(start[:3, :3] @ axis, [0, 0, -1])  # the torch points down
start[:3, 3] = [0.45, -0.30, 0.10]
end = start.copy()
end[:3, 3] = [0.30, 0.30, 0.10]
seam = mp.CartesianPath.line(start, end)
print(f"length of the seam: {seam.length:.3f} m")

# %%
# ``Task.pointing`` leaves the rotation about an axis of the tool free. All
# configurations at 30 positions of the seam are enumerated, with the rotation in steps
# of 4 degrees. The search finds the continuous motion with the largest minimum
# manipulability, and ``refine`` raises it between the samples.

task = mp.Task.pointing(axis)
positions, epsilon = 30, np.deg2rad(9)
layers = mp.sample_layers(robot, seam, positions, task=task, samples=90)
found = mp.max_min_search(layers, epsilon)
refined = mp.refine(layers, found)
print(f"{layers.count} candidates; {refined}")

# %%
# For comparison, the rotation is held as in the first pose, and the motion is evaluated
# with the same measure. There is no parameter to sample, only the eight postures.

held = mp.max_min_search(
    mp.sample_layers(robot, seam, positions), epsilon, prefer="first"
)
m_held = robot.kinematics(task).manipulability(held.q)
print(
    f"minimum manipulability with fixed rotation: {m_held.min():.4f} m^5, free: "
    f"{refined.refined:.4f} m^5"
)
assert m_held.min() < 0.0145 and refined.refined > 0.0160

# %%
# Grey: the candidates. The bound is the largest candidate at the worst position; no
# motion can exceed it.

fig, ax = plt.subplots(figsize=(7.5, 4), layout="constrained")
viz.plot_layers(layers, refined, ax=ax)
ax.plot(m_held, color="#009E73", linestyle="--", label="fixed rotation")
ax.legend(loc="lower left", fontsize=8)
plt.show()

# %%
# The whole job in one call: the motion is planned, timed, and compared with every pose
# of the seam. The deviation shows that the point and the axis are kept.

plan = mp.follow(
    robot,
    seam,
    positions=positions,
    samples=90,
    epsilon=epsilon,
    objective=mp.PathObjective(task=task),
)
print(plan.report)
print(plan.deviation)
assert plan.status is mp.Status.FOLLOWED
assert plan.report.passed and plan.deviation.position < 1e-4
_ = viz.draw_figure(plan, plt.figure(figsize=(11.5, 6.0)))

# %%
# Rotation of the torch about its axis along the seam.

s = np.linspace(0, 1, 200)
poses = robot.kinematics().pose(plan.trajectory(s * plan.trajectory.duration))
sideways = poses[:, :3, 1]  # the flange's y axis, perpendicular to the torch
turn = np.unwrap(np.arctan2(sideways[:, 1], sideways[:, 0])) - np.arctan2(
    start[1, 1], start[0, 1]
)
travelled = np.linalg.norm(poses[:, :3, 3] - start[:3, 3], axis=1)
fig, ax = plt.subplots(figsize=(7.5, 2.8), layout="constrained")
ax.plot(100 * travelled, np.rad2deg(turn), color="#0072B2", label="free rotation")
ax.axhline(0, color="#009E73", label="fixed rotation")
ax.set(
    xlabel="distance along the seam [cm]",
    ylabel="rotation about the\ntorch's axis [degrees]",
    xlim=(0, None),
)
ax.legend(frameon=False, fontsize=8)
plt.show()

# %%
# If it fails: the message *no continuous motion* names the positions between which the
# candidates are not connected and the smallest ε that would connect them. More
# ``samples`` and more positions help. A seam that passes the arm's shoulder may have to
# be welded in two parts. A tolerance (``tolerance=mp.Tolerance(...)``) gives more
# manipulability where the seam allows it.
