"""
A tray with two arms
====================

.. image:: /pictures/tray.jpg
   :alt: The two arms of a Baxter hold a tray above a box.
   :width: 560px

*For robots with two arms that carry one object.*

Both hands of a Baxter hold a tray and lift it over a box. One arm leads, the other
follows, and the hands keep their poses to each other. This page draws the motion, the
manipulability of both arms, and how far the hands leave their relative pose.
"""

# sphinx_gallery_thumbnail_path = "pictures/tray.jpg"

import matplotlib.pyplot as plt
import numpy as np
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan import viz

# %%
# The hands hold the rim of the tray from above and outside. The tray is attached to the
# left hand, so that it is checked for collisions, too.


def at_the_rim(side):
    """Pose of a hand in the frame of the tray; side is 1 for the left one, else -1."""
    pose = np.eye(4)
    lean, turn = np.pi - side * np.pi / 4, side * np.pi / 2
    pose[:3, :3] = Rotation.from_euler("XZ", [lean, turn]).as_matrix()
    pose[:3, 3] = 0.0, 0.22 * side, 0.02
    return pose


grasps = {"left_gripper": at_the_rim(1), "right_gripper": at_the_rim(-1)}
tray = mp.Box(size=(0.3, 0.4, 0.02), name="tray")
in_hand = tray.at(np.linalg.inv(grasps["left_gripper"]))
robot = mp.load_robot("baxter").attach(in_hand, tool="left_gripper")
scene = mp.Scene(
    [
        mp.Box(size=(0.7, 1.6, 0.05), position=(0.85, 0.0, -0.2), name="table"),
        mp.Box(size=(0.12, 0.2, 0.13), position=(0.66, 0.0, -0.11), name="box"),
    ]
)

# %%
# The tray stays level on its way up, across the box, and down again.

places = [(0.6, -0.15, 0.0), (0.63, -0.07, 0.1), (0.67, 0.07, 0.1), (0.7, 0.15, 0.0)]
poses = np.tile(np.eye(4), (len(places), 1, 1))
poses[:, :3, 3] = places
plan = mp.carry(
    robot, mp.CartesianPath.through(poses), grasps, scene, positions=25, samples=12
)
print(plan.report)
assert plan.status is mp.Status.CARRIED
assert plan.report.min_manipulability > 0.013  # [m^6]

# %%
# The robot at the start, on the way and at the goal.

figure = plt.figure(figsize=(8.5, 7.0), layout="constrained")
ax = figure.add_subplot(projection="3d")
viz.plot_arm(robot, plan.path, scene, places=3, ax=ax)
ax.view_init(elev=32, azim=-12)
ax.set(xlim=(-0.2, 1.1), ylim=(-0.65, 0.65), zlim=(-0.4, 0.9))
plt.show()

# %%
# Above, the manipulability of both arms: the smaller one counts. Below, how far the right
# hand is from where it should be, seen from the left one. A relative task gives this
# pose; the tolerance is 0.1 mm.

t = np.linspace(0.0, plan.trajectory.duration, 800)
q = plan.trajectory(t)
fig, (top, bottom) = plt.subplots(
    2, 1, figsize=(7.5, 5.0), sharex=True, layout="constrained"
)
for tool in robot.tools:
    own = robot.arm(tool).kinematics()
    m = own.manipulability(q[:, list(robot.joints_of(tool))])
    top.plot(t, m, label=tool.replace("_gripper", " arm"))
top.set(ylabel="m [m⁶]", ylim=(0, None))
top.legend(frameon=False)
seen = robot.kinematics(mp.Task.pose(relative_to="right_gripper")).pose(q)
wanted = np.linalg.inv(grasps["right_gripper"]) @ grasps["left_gripper"]
apart = np.linalg.norm(seen[:, :3, 3] - wanted[:3, 3], axis=1)
bottom.plot(t, 1e6 * apart)
bottom.set(xlabel="time [s]", ylabel="deviation [µm]", xlim=(0, t[-1]), ylim=(0, None))
plt.show()
assert apart.max() < 1e-4
