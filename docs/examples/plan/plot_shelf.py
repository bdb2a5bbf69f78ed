"""
Plan through a shelf
====================

A Panda takes a part from the upper board of a shelf and puts it on the lower one.
What you have: two poses of the hand and the boards' sizes. What you want: a motion
that keeps 2 cm from everything, and does not pass near a singularity where the
boards force the arm to fold.
"""

# %%
# The shelf is five boxes: three boards, two sides. The position of a box is that of
# its centre.

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
# Two poses of the hand, pointing forward into the shelf. A pose is reached by many
# configurations; which of them is the start is a decision that no path can undo. So
# all are listed, and those too near to something are dropped. Of the others the
# start is the one of the highest index, and the goal the nearest to it among those
# whose index is at least three quarters of the highest.

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
    index = kinematics.manipulability(free)
    print(
        f"{position}: {len(q)} configurations, {len(free)} of them free; index "
        f"{index.min():.4f} to {index.max():.4f} m^6"
    )
    return free, index


starts, index = free_configurations([0.66, 0.15, 0.65])
start = starts[index.argmax()]
goals, index = free_configurations([0.64, -0.15, 0.27])
goals = goals[index >= 0.75 * index.max()]
goal = goals[np.linalg.norm(goals - start, axis=1).argmin()]

# %%
# ``seeds=3`` looks for three first paths. Those that can be deformed into each
# other without touching anything are of one class, of which only the best is
# optimised. Of different classes each is optimised, and those that lose are kept as
# rivals.

plan = mp.plan(robot, start, goal, scene, clearance=clearance, seeds=3)
print(plan.report)
rivals = [f"{rival.g:.1f}" for rival in plan.result.rivals]
print(
    f"g of the best {plan.result.g:.1f}; of {len(rivals)} rivals: {', '.join(rivals)}"
)
assert plan.report.passed
assert plan.report.proven_clearance > clearance - 1e-4

# %%
# The arm among the boards, and the index on the way.

figure = plt.figure(figsize=(11, 4.8), layout="constrained")
left, right = figure.subfigures(1, 2, width_ratios=(1.1, 1))
viz.plot_arm(robot, plan.path, scene, ax=left.add_subplot(projection="3d"))
viz.plot_index(
    kinematics, {"optimised": plan.path, "seed": plan.result.seed}, ax=right.subplots()
)

# %%
# How near it comes: the least distance to any board or link along the motion, at
# each moment. The dotted line is what was asked for. The report's *proven* figure
# holds between these samples, too.

t = np.linspace(0, plan.trajectory.duration, 200)
least = scene.distances(robot, plan.trajectory(t)).min(axis=1)
fig, ax = plt.subplots(figsize=(7, 2.8), layout="constrained")
ax.plot(t, 1e3 * least, color="#0072B2")
ax.axhline(1e3 * clearance, color="0.4", linestyle=":")
ax.set(xlabel="time [s]", ylabel="least distance [mm]", xlim=(0, t[-1]), ylim=(0, None))
plt.show()

# %%
# What to do when it fails:
#
# - *start touches ...*: the message names the two bodies; take another
#   configuration of the same pose, or less ``clearance``.
# - *no collision-free path was found*: the boards may leave no room. Try with less
#   clearance first: if that works, the gap is too narrow, otherwise allow more
#   ``time_limit`` or another ``seed``.
# - the status ends in *seed ... is returned*: the planner's path is free but
#   nothing better was found; raise ``degree``.
