"""
A weld seam with a free tool axis
=================================

The torch of a Panda follows a seam of 40 cm. The rotation about its axis does not matter, so a pose leaves two numbers to
choose: a joint and the turn about the axis. All configurations at 40 positions are enumerated; the dots are the candidates.
The search finds the continuous motion whose least index is the highest, and the refinement raises it between the samples.
"""

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
start = robot.kinematics().pose(robot.neutral)
turn = np.deg2rad(70)
start[:3, :3] = [[np.cos(turn), np.sin(turn), 0], [np.sin(turn), -np.cos(turn), 0], [0, 0, -1]]  # the torch points down
start[:3, 3] = [0.5, -0.2, 0.3]
end = start.copy()
end[:3, 3] = [0.4, 0.2, 0.4]
seam = mp.CartesianPath.line(start, end)
task = mp.Task.pointing([0, 0, 1])

layers = mp.sample_layers(robot, seam, 40, task=task, samples=(60, 60))
epsilon = np.deg2rad(8)
found = mp.max_min_search(layers, epsilon)
refined = mp.refine(layers, found)
print(f"{layers.count} candidates; {refined}")

# %%
# What the freedom brings, judged by the same index: here little, since the last joint of the Panda turns about the same axis.
held = mp.max_min_search(mp.sample_layers(robot, seam, 40, samples=720), epsilon)
index_held = robot.kinematics(task).manipulability(held.q)
print(f"least index with the rotation held: {index_held.min():.4g}, free: {refined.refined:.4g}")

# %%
rng = np.random.default_rng(0)
fig, ax = plt.subplots(figsize=(7.5, 4), layout="constrained")
for position, index in enumerate(layers.m):
    shown = rng.choice(index, min(150, len(index)), replace=False)
    ax.plot(np.full(len(shown), position), shown, ".", color="0.8", markersize=2)
ax.plot([index.max() for index in layers.m], color="0.4", linestyle=":", label="highest of each position")
ax.plot(found.manipulability, color="#e69f00", label="best continuous path of the samples")
ax.plot(refined.manipulability, color="#0072b2", label="refined")
ax.plot(index_held, color="#009e73", label="rotation held")
ax.axhline(refined.bound, color="0.2", linewidth=0.8, label="bound")
ax.set(xlabel="position on the seam", ylabel=r"index [$\mathrm{m}^5$]", xlim=(0, 39), ylim=(0, None))
ax.legend(loc="lower right", fontsize=8)
plt.show()

# %%
# The whole job in one call: the motion, timed and checked.
plan = mp.follow(robot, seam, 40, task=task, samples=(60, 60), epsilon=epsilon)
print(plan.report)
print(plan.deviation)
