"""
Every picture
=============

.. image:: images/sphx_glr_plot_pictures_003.png
   :alt: A planar arm on its path past a ball, with the path of its tool and ellipsoids.
   :width: 560px

*For papers, talks and reports.*

This page shows every function of `viz`. All of them draw into Matplotlib axes: those
given as `ax=`, or those of a new figure, which they return. Everything is drawn as
vectors; save a figure with `savefig("picture.svg")` or `.pdf`.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

import manipplan as mp
from manipplan import viz

# %%
# A plan in one figure
# --------------------
# The figure that `plan.save` writes to plan.png.
problem = mp.demo.panda_among_boxes()
robot, scene = problem.robot, problem.scene
plan = mp.plan(robot, problem.start, problem.goal, scene)
assert plan.status is mp.Status.OPTIMAL and plan.report.min_manipulability > 0.009
_ = viz.draw_figure(plan, plt.figure(figsize=(11.5, 6.0)))

# %%
# The arm among obstacles
# -----------------------
# Obstacles are drawn with their shapes and names. The arm is drawn with its links at
# the start (light) and at the goal (dark), and as a skeleton in between. The green
# ellipsoids show how fast the tool can move in each direction.
shapes = mp.Scene(
    [
        mp.Plane(name="floor", position=(0.0, 0.0, -0.06)),
        mp.Cylinder(radius=0.07, length=0.45, position=(0.5, 0.0, 0.22), name="post"),
        mp.Capsule(
            radius=0.05,
            length=0.3,
            position=(0.55, 0.42, 0.5),
            rotation=(0.0, 1.3, 0.4),
            name="bar",
        ),
        mp.Sphere(radius=0.12, position=(0.5, -0.45, 0.12), name="ball"),
        mp.Box(
            size=(0.3, 0.3, 0.06),
            position=(0.25, 0.0, 1.15),
            rotation=(0.2, 0.0, 0.5),
            name="lamp",
        ),
    ]
)
ax = viz.plot_arm(
    robot, plan.path, shapes, seed=plan.result.seed, names=("optimised", "seed")
)
clearance = shapes.path_clearance(robot, plan.path)
assert clearance.proven
print(f"proven clearance {1e3 * clearance.lower:.1f} mm")

# %%
# A planar arm is drawn from above.
planar = mp.planar_arm([1.0, 1.0, 1.0])
wall = mp.Plane(name="wall", position=(-2.4, 0.0, 0.0), rotation=(0.0, np.pi / 2, 0.0))
ball = mp.Sphere(radius=0.25, position=(0.9, -0.9, 0.0), name="ball")
flat = mp.plan(
    planar,
    [0.0, 1.5, -2.0],
    [np.pi, -2.0, 2.0],
    mp.Scene([wall, ball]),
    objective=mp.PathObjective(power=2.0),
)
ax = viz.plot_arm(
    planar, flat.path, flat.scene, seed=flat.result.seed, names=("optimised", "seed")
)

# %%
# Joints
# ------
# Positions, velocities, accelerations or jerks, with the limits as dashed lines in the
# joint's colour, or as shares of the limits.

# sphinx_gallery_thumbnail_number = 3
_, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
viz.plot_joints(plan.trajectory, robot.limits, ax=left)
_ = viz.plot_joints(plan.trajectory, robot.limits, order=1, share=True, ax=right)

# %%
# Manipulability and singular values
# ----------------------------------
kinematics = robot.kinematics()
_, (left, right) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
viz.plot_manipulability(
    kinematics, {"optimised": plan.path, "seed": plan.result.seed}, ax=left
)
_ = viz.plot_singular_values(kinematics, plan.path, ax=right)

# %%
# Ellipsoids
# ----------
# Left: single ellipsoids, here of velocity and force at a posture of the planar arm.
# Right: ellipsoids along a path.
figure = plt.figure(figsize=(11, 4.4), layout="constrained")
figure.get_layout_engine().set(wspace=0.12)  # room for the label of z
left, right = figure.add_subplot(1, 2, 1), figure.add_subplot(1, 2, 2, projection="3d")
q = np.array([0.4, 0.9, 0.5])
jacobian, tool = planar.kinematics().jacobian(q), planar.kinematics().pose(q)[:2, 3]
viz.plot_ellipsoid(
    mp.measures.velocity_ellipsoid(jacobian),
    tool,
    ax=left,
    scale=0.2,
    axes=True,
    label="velocity",
)
viz.plot_ellipsoid(
    mp.measures.force_ellipsoid(jacobian),
    tool,
    ax=left,
    scale=0.2,
    axes=True,
    color="#E69F00",
    label="force",
)
left.set(xlabel="x [m]", ylabel="y [m]")
left.set_aspect("equal", adjustable="datalim")
left.legend()
_ = viz.plot_ellipsoids(robot.kinematics(mp.Task.position()), plan.path, 9, ax=right)

# %%
# The path of the tool
# --------------------
# A circle followed inside a tube of 2 cm, which the arm uses to stay away from
# singularities.
start = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, 0.785])
near = kinematics.pose(start)
circle = mp.CartesianPath.circle(
    near, near[:3, 3] + [0.1405, 0.0, 0.0], axis=(0.0, 0.0, 1.0)
)
tube = mp.Tolerance(position=0.02, rotation=0.1)
tracking = mp.track(
    robot,
    circle,
    start,
    mp.formulations.LogDrive(),
    dt=0.01,
    duration=4.0,
    tolerance=tube,
)
figure = plt.figure(figsize=(11, 4.4), layout="constrained")
figure.get_layout_engine().set(wspace=0.12)  # room for the label of z
way = figure.add_subplot(1, 2, 1, projection="3d")
viz.plot_tool_path(robot, tracking, circle, ax=way)
way.locator_params(nbins=4)
_ = viz.plot_deviation(tracking, tolerance=tube, ax=figure.add_subplot(1, 2, 2))

# %%
# How a solution was found
# ------------------------
# Left, the layered search: each dot is a configuration that reaches a position of the
# path; the line is the continuous path with the largest minimum manipulability. Right,
# the optimiser: g after each solve, with filled markers where the path was
# collision-free.
seam = mp.CartesianPath.line(
    near,
    near @ np.array([[1, 0, 0, 0.0], [0, 1, 0, 0.25], [0, 0, 1, 0.1], [0, 0, 0, 1]]),
)
layers = mp.sample_layers(robot, seam, 25, samples=240)
found = mp.max_min_search(layers, np.deg2rad(12))
_, (left, right) = plt.subplots(1, 2, figsize=(11, 4.4), layout="constrained")
viz.plot_layers(layers, found, ax=left)
_ = viz.plot_convergence(plan.result, ax=right)

# %%
# In motion
# ---------
# `viz.animate` writes a GIF, or an MP4 with ffmpeg; the suffix of the file selects the
# format. Three frames of the animation:
figure, panels = plt.subplots(3, 1, figsize=(7, 10), layout="constrained")
with tempfile.TemporaryDirectory() as folder:
    film = Path(folder) / "plan.gif"
    viz.animate(flat, film, fps=10)
    print(f"{film.name}: {film.stat().st_size // 1000} kB")
    with Image.open(film) as frames:
        for panel, frame in zip(panels, (0, 8, 16), strict=True):
            frames.seek(frame)
            panel.imshow(frames.convert("RGB"))
            panel.set_axis_off()
