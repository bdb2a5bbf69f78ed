"""
Plan through a shelf
====================

.. image:: /pictures/shelf.jpg
   :alt: A Panda reaches into a shelf from the upper to the lower board.
   :width: 560px

*For picking and placing between shelves.*

A Panda takes a part from the upper board of a shelf and puts it on the lower one. You
have two poses of the hand and the sizes of the boards. You want a motion that keeps a
clearance of 2 cm to everything and does not pass near a singularity where the boards
force the arm to fold.
"""

# %%
# The shelf consists of five boxes: three boards and two sides. The position of a box is
# the position of its centre.

# sphinx_gallery_thumbnail_path = "pictures/shelf.jpg"
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

robot = mp.load_robot("panda")
boards = [
    mp.Box(size=(0.32, 0.90, 0.02), position=(0.70, 0.0, z), name=name)
    for name, z in (("bottom", 0.10), ("middle", 0.45), ("top", 0.85))
]
sides = [
    mp.Box(size=(0.32, 0.02, 0.75), position=(0.70, y, 0.475), name=name)
    for name, y in (("right", -0.45), ("left", 0.45))
]
scene = mp.Scene([*boards, *sides])

# %%
# In both poses the hand points forward into the shelf. Many configurations reach a
# pose, and a path cannot make up for a bad choice of the start. So all configurations
# are listed, and those too close to an obstacle or another link are dropped. The start
# is the remaining configuration with the largest manipulability. The goal is the
# configuration nearest to the start among those with at least three quarters of the
# largest manipulability.

forward = np.array(
    [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]]
)  # columns: the tool's axes; z points forward
kinematics = robot.kinematics()
clearance = 0.02


def free_configurations(position):
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = forward, position
    q = mp.inverse_kinematics(robot, pose, samples=180).q
    free = q[(scene.distances(robot, q) > clearance).all(axis=1)]
    m = kinematics.manipulability(free)
    print(
        f"{position}: {len(q)} configurations, {len(free)} collision-free; m from "
        f"{m.min():.4f} to {m.max():.4f} m^6"
    )
    return free, m


starts, m = free_configurations([0.66, 0.15, 0.65])
start = starts[m.argmax()]
goals, m = free_configurations([0.64, -0.15, 0.27])
goals = goals[m >= 0.75 * m.max()]
goal = goals[np.linalg.norm(goals - start, axis=1).argmin()]

# %%
# ``mp.Seeding(count=3)`` looks for three first paths. Paths that can be deformed into
# each other without a collision belong to one class, and of each class one is
# optimised. The best result is returned, and those of other classes are kept as rivals.
# Here all three belong to one class, so there are none.

plan = mp.plan(
    robot, start, goal, scene, clearance=clearance, seeding=mp.Seeding(count=3)
)
print(plan.report)
print(f"{len(plan.result.rivals)} rivals of another class")
assert plan.status is mp.Status.OPTIMAL and plan.report.g < 490
assert plan.report.proven_clearance > clearance - 1e-4

# %%
# The arm among the boards, and the manipulability along the path.

figure = plt.figure(figsize=(11, 4.8), layout="constrained")
left, right = figure.subfigures(1, 2, width_ratios=(1.1, 1))
viz.plot_arm(robot, plan.path, scene, ax=left.add_subplot(projection="3d"))
viz.plot_manipulability(
    kinematics, {"optimised": plan.path, "seed": plan.result.seed}, ax=right.subplots()
)

# %%
# The clearance along the motion: the minimum distance to any board or link at each
# time. The dotted line is the requested clearance. The *proven* clearance of the report
# also holds between these samples.

t = np.linspace(0, plan.trajectory.duration, 200)
least = scene.distances(robot, plan.trajectory(t)).min(axis=1)
fig, ax = plt.subplots(figsize=(7, 2.8), layout="constrained")
ax.plot(t, 1e3 * least, color="#0072B2")
ax.axhline(1e3 * clearance, color="0.4", linestyle=":")
ax.set(
    xlabel="time [s]", ylabel="minimum distance [mm]", xlim=(0, t[-1]), ylim=(0, None)
)
plt.show()

# %%
# What to do if it fails:
#
# - *start touches ...*: the message names the two bodies. Take another
#   configuration of the same pose, or a smaller ``clearance``.
# - *no collision-free path was found*: the boards may leave no room. Try a smaller
#   clearance first. If that works, the gap is too narrow; otherwise set a longer
#   ``time_limit`` or another ``seed``.
# - the status ends in *seed ... is returned*: the planner's path is collision-free,
#   but nothing better was found. Raise the degree: ``mp.PathShape(degree=8)``.
