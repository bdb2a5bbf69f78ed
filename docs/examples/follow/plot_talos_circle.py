"""
A circle with the arm of TALOS
==============================

A humanoid's hand is to move around a circle 20 cm wide, and come back to the
configuration in which it began, so that the motion can be repeated for ever. The
arm has seven joints, so each pose has infinitely many configurations. The task is
that of :cite:t:`guilamo2006`; :doc:`a study </studies/guilamo2006>` repeats their
whole table.
"""

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

robot = mp.load_robot("talos_right_arm")
print(robot)

# %%
# The circle stands upright in front of the robot. The orientation of the hand does
# not change.

pose = np.eye(4)
pose[:3, :3] = np.column_stack(
    [(0.0, 0.0, -1.0), (0.0, -1.0, 0.0), (-1.0, 0.0, 0.0)]
)  # the wrist's z axis points to the elbow
centre = np.array([0.35, -0.35, 0.05])
pose[:3, 3] = centre
pose[2, 3] += 0.10
circle = mp.CartesianPath.circle(pose, centre, axis=(1.0, 0.0, 0.0))
print(f"length of the circle: {circle.length:.3f} m")

# %%
# What the arm has to spare is one joint. ``samples`` is how finely it is sampled:
# its step has to be below the ε of the search, which is how far a joint may move
# from one position to the next.

positions, epsilon = 40, np.deg2rad(10.0)
layers = mp.sample_layers(robot, circle, positions, samples=240, closed=True)
print(
    f"{layers.count} candidates that are inside the limits and do not touch the "
    f"robot itself, of {layers.considered}"
)

# %%
# The search is exact: of all continuous cycles through these candidates none has a
# higher minimum manipulability. ``bound`` is what no motion can exceed, continuous or not.
# ``refine`` goes on between the samples.

found = mp.max_min_search(layers, epsilon)
refined = mp.refine(layers, found)
print(refined)
assert found.connected and refined.refined >= found.minimum
step = np.abs(np.diff(np.vstack([refined.q, refined.q[:1]]), axis=0)).max()
print(
    f"largest step of a joint: {np.rad2deg(step):.2f} degrees, the last to the "
    "first included; allowed: 10"
)
assert step < epsilon

# %%
# All candidates by position and by the angle of the joint that was sampled,
# coloured by their index, with the path through them.

[name] = mp.inverse_kinematics(robot, pose, samples=240).parameter_names
joint = robot.joint_names.index(name)
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.4), layout="constrained")
at = np.concatenate([np.full(len(m), position) for position, m in enumerate(layers.m)])
dots = left.scatter(
    at,
    np.concatenate(layers.q)[:, joint],
    c=np.concatenate(layers.m),
    s=6,
    cmap="viridis",
    rasterized=True,
)
figure.colorbar(dots, ax=left, label="index [m⁶]")
left.plot(refined.q[:, joint], color="#D55E00", linewidth=2.5)
left.set(
    xlabel="position on the circle",
    ylabel=f"{name} [rad]",
    xlim=(-0.5, positions - 0.5),
)
viz.plot_layers(layers, refined, ax=right)
plt.show()

# %%
# What to do when nothing connects: the message names the positions between which
# the layers break and the smallest ε that would connect them. More ``samples``
# bring candidates nearer together, more positions make the steps smaller. A circle
# that is partly out of reach is refused at once, with how far off the arm stays:

far = pose.copy()
far[:3, 3] += [0.45, 0.0, 0.0]
try:
    mp.sample_layers(
        robot,
        mp.CartesianPath.circle(far, far[:3, 3] - [0, 0, 0.1], axis=(1, 0, 0)),
        positions,
        samples=40,
    )
except mp.InvalidInputError as error:
    print(error)
