"""
A circle with the arm of TALOS
==============================

.. image:: /pictures/talos_circle.jpg
   :alt: The humanoid TALOS, its right hand on an upright circle.
   :width: 560px

*For motions that repeat, and for readers of the paper.*

A humanoid moves its hand around a circle with a diameter of 20 cm and comes back to the
first configuration, so that the motion can be repeated. The arm has seven joints, so
each pose has infinitely many configurations. The task is taken from
:cite:t:`guilamo2006`; :doc:`a study </studies/guilamo2006>` repeats their whole table.
"""

# sphinx_gallery_thumbnail_path = "pictures/talos_circle.jpg"

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
# The arm has one redundant joint. ``samples`` is the number of values at which it is
# sampled. The step between two values has to be below the ε of the search, which is the
# largest motion of a joint from one position to the next.

positions, epsilon = 40, np.deg2rad(10.0)
layers = mp.sample_layers(robot, circle, positions, samples=240, closed=True)
print(
    f"{layers.count} candidates that are inside the limits and free of "
    f"self-collision, of {layers.considered}"
)

# %%
# The search is exact: no continuous cycle through these candidates has a larger minimum
# manipulability. No motion, continuous or not, can exceed ``bound``. ``refine``
# improves the path between the samples.

found = mp.max_min_search(layers, epsilon)
refined = mp.refine(layers, found)
print(refined)
assert found.status is mp.Status.PROVEN_OPTIMAL
assert 0.0050 < refined.refined <= 0.0051 and refined.refined >= found.minimum
step = np.abs(np.diff(np.vstack([refined.q, refined.q[:1]]), axis=0)).max()
print(
    f"largest step of a joint: {np.rad2deg(step):.2f} degrees, including the step "
    "from the last to the first position; allowed: 10"
)
assert step < epsilon

# %%
# All candidates by position and angle of the sampled joint, coloured by manipulability,
# with the path through them.

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
figure.colorbar(dots, ax=left, label="manipulability [m⁶]")
left.plot(refined.q[:, joint], color="#D55E00", linewidth=2.5)
left.set(
    xlabel="position on the circle",
    ylabel=f"{name} [rad]",
    xlim=(-0.5, positions - 0.5),
)
viz.plot_layers(layers, refined, ax=right)
plt.show()

# %%
# If no path is found, the message names the positions between which the layers are not
# connected and the smallest ε that would connect them. More ``samples`` bring the
# candidates closer together; more positions make the steps smaller. A circle that is
# partly out of reach is rejected at once, and the message says how far away the arm
# stays:

far = pose.copy()
far[:3, 3] += [0.45, 0.0, 0.0]
try:
    mp.sample_layers(
        robot,
        mp.CartesianPath.circle(far, far[:3, 3] - [0, 0, 0.1], axis=(1, 0, 0)),
        positions,
        samples=40,
    )
except mp.errors.InvalidInputError as error:
    print(error)
