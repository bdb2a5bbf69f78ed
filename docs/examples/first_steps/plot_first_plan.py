"""
A Panda among five boxes
========================

.. image:: /pictures/first_plan.jpg
   :alt: A Panda arm between a post and a shelf, on the optimised path of its tool
         in blue; the planner's path in yellow.
   :width: 560px

*For anyone who plans with the library for the first time.*

Plan a trajectory from a start to a goal, step by step: this is the problem that ``make
demo`` solves.
"""

# %%
# The robot comes from the catalogue. Its fingers are locked. The acceleration and jerk
# limits are those that the manufacturer publishes.

# sphinx_gallery_thumbnail_path = "pictures/first_plan.jpg"
import matplotlib.pyplot as plt

import manipplan as mp
from manipplan import viz

robot = mp.load_robot("panda")
print(robot)

# %%
# Obstacles are shapes. ``position`` is the centre of the shape in metres.
scene = mp.Scene(
    [
        mp.Box(size=(0.9, 1.4, 0.05), position=(0.5, 0.0, -0.03), name="table"),
        mp.Box(size=(0.10, 0.10, 0.45), position=(0.5, 0.0, 0.22), name="post"),
        mp.Box(size=(0.35, 0.30, 0.03), position=(0.55, 0.42, 0.5), name="shelf"),
        mp.Box(size=(0.22, 0.22, 0.2), position=(0.5, -0.45, 0.1), name="crate"),
        mp.Box(size=(0.30, 0.30, 0.06), position=(0.25, 0.0, 1.15), name="lamp"),
    ]
)
start = [-0.18, 0.07, -0.53, -2.09, -0.28, 1.93, -0.86]
goal = [-1.53, -0.03, 2.63, -2.03, -0.5, 2.14, -0.63]

# %%
# One call finds a collision-free seed path, optimises it, times it, and checks the
# result. The motion keeps a clearance of 10 mm to every obstacle and between the arm's
# own links.
plan = mp.plan(robot, start, goal, scene, clearance=0.01)
print(plan.report)
assert plan.status is mp.Status.OPTIMAL
assert plan.report.min_manipulability > 0.009  # [m^6]; 0.002 on the seed path

# %%
# The straight line in joint space passes close to a singularity and collides. The
# planner's seed path is collision-free, but its minimum manipulability is only a
# quarter of that of the optimised path.
_ = viz.draw_figure(plan, plt.figure(figsize=(11.5, 6.0)))

# %%
# The trajectory is a cubic spline in time. It gives positions, velocities and
# accelerations at any time.
trajectory = plan.trajectory
print(f"duration {trajectory.duration:.3f} s")
print("joint velocities at half the duration [rad/s]:")
print(trajectory(trajectory.duration / 2, order=1).round(2))
