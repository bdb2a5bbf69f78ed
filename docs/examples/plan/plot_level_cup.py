"""
Carry a level cup
=================

.. image:: /pictures/level_cup.jpg
   :alt: A Panda carries a cup past a post; the level way in blue, the free one in
         yellow.
   :width: 560px

*For transport of what must not tilt.*

A Panda carries a cup past a post. A free motion tilts the cup, a motion with a tilt
limit does not, and a proof says so for all times. This page plans both, draws the tilt
and the manipulability over time, and shows what the limit costs.
"""

# sphinx_gallery_thumbnail_path = "pictures/level_cup.jpg"

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

# %%
# The hand holds the cup from above. From now on the cup is a part of the robot; it
# stands along the hand's z axis, which points down. The goal is a place for the cup,
# which may turn about its own axis.

cup = mp.Cylinder(radius=0.03, length=0.1, position=(0.0, 0.0, 0.06))
robot = mp.load_robot("panda").attach(cup, name="cup")
scene = mp.Scene(
    [
        mp.Box(size=(0.9, 1.6, 0.04), position=(0.6, 0.0, -0.02), name="table"),
        mp.Box(size=(0.12, 0.12, 0.55), position=(0.4, 0.25, 0.275), name="post"),
    ]
)
kinematics = robot.kinematics()
goal = kinematics.pose(robot.neutral).copy()
goal[:3, 3] = [0.2, 0.5, 0.25]
place = mp.PoseGoal(goal, free_axis=[0, 0, 1])

# %%
# The limit: the tool's axis z stays within 5° of straight down.

level = mp.TiltLimit(axis=[0, 0, 1], direction=[0, 0, -1], angle=np.deg2rad(5))
plans = {
    "free": mp.plan(robot, robot.neutral, place, scene),
    "level": mp.plan(robot, robot.neutral, place, scene, constraints=[level]),
}
for name, plan in plans.items():
    figures = f"g {plan.report.g:.1f}, {plan.trajectory.duration:.2f} s"
    print(f"{name}: {plan.status.name}, {figures}")
    assert plan.status is mp.Status.OPTIMAL
assert plans["level"].report.constraints[0].proven

# %%
# The tilt of the cup along both motions. The level motion touches the limit on a part of
# its way and keeps it everywhere.


def tilt(plan, count=400):
    """Share of the time, and angle between cup and vertical [°]."""
    share = np.linspace(0.0, 1.0, count)
    axes = kinematics.pose(plan.trajectory(share * plan.trajectory.duration))[:, :3, 2]
    return share, np.rad2deg(np.arccos(np.clip(-axes[:, 2], -1.0, 1.0)))


fig, (top, bottom) = plt.subplots(
    2, 1, figsize=(7.5, 5.0), sharex=True, layout="constrained"
)
for name, plan in plans.items():
    share, angle = tilt(plan)
    top.plot(share, angle, label=name)
    q = plan.trajectory(share * plan.trajectory.duration)
    bottom.plot(share, kinematics.manipulability(q), label=name)
top.axhline(5.0, color="0.4", linestyle="--", linewidth=1.0)
top.annotate("limit", (0.99, 5.0), ha="right", va="bottom", fontsize=8, color="0.3")
top.set(ylabel="tilt of the cup [°]", ylim=(0, None))
bottom.set(xlabel="share of the time", ylabel="m [m⁶]", xlim=(0, 1), ylim=(0, None))
top.legend(frameon=False)
plt.show()
assert tilt(plans["level"])[1].max() <= 5.0001 < tilt(plans["free"])[1].max()

# %%
# The arm on the level motion.

figure = plt.figure(figsize=(8.5, 6.0), layout="constrained")
ax = figure.add_subplot(projection="3d")
viz.plot_arm(robot, plans["level"].path, scene, ax=ax)
plt.show()
