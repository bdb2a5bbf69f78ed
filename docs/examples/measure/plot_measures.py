"""
Ellipsoids and measures
=======================

.. image:: images/sphx_glr_plot_measures_001.png
   :alt: A planar arm in three postures with its velocity and force ellipsoids.

*For anyone who has to choose a measure.*

What a posture is good for: in which directions the tool is fast, in which it is strong,
and how fast it can accelerate.
"""

# %%
# A planar arm with three links. The velocity and force ellipsoids have the same axes
# and inverse radii: in a direction in which the tool is fast, it is weak. Their shape
# shows at a glance what a single number hides.

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

arm = mp.planar_arm([1.0, 1.0, 1.0])
kin = arm.kinematics()
postures = {
    "stretched": [0.3, 0.25, 0.2],
    "bent": [0.2, 1.2, 0.9],
    "folded": [0.4, 2.2, -2.3],
}
figure, panels = plt.subplots(1, 3, figsize=(11, 3.8), sharex=True, sharey=True)
for ax, (name, q) in zip(panels, postures.items(), strict=True):
    angles = np.cumsum(q)
    joints = np.vstack(
        [
            np.zeros(2),
            np.cumsum(np.stack([np.cos(angles), np.sin(angles)], axis=1), axis=0),
        ]
    )
    ax.plot(*joints.T, "o-", color="#333333", linewidth=2)
    jacobian = kin.jacobian(q)
    viz.plot_ellipsoid(
        mp.measures.velocity_ellipsoid(jacobian),
        joints[-1],
        ax=ax,
        scale=0.25,
        label="velocity",
        axes=True,
    )
    viz.plot_ellipsoid(
        mp.measures.force_ellipsoid(jacobian),
        joints[-1],
        ax=ax,
        scale=0.25,
        color="#D55E00",
        label="force",
        axes=True,
    )
    ax.set_title(f"{name}: m = {kin.manipulability(q):.2f} m²", fontsize=10)
    ax.set_aspect("equal")
    ax.set_xlabel("x [m]")
panels[0].set_ylabel("y [m]")
panels[0].legend(loc="upper left", frameon=False)
figure.tight_layout()

# %%
# The Panda in space: velocity in green, and in blue the accelerations from rest for
# joint torques of norm 1, which also depend on the inertia of the links.

panda = mp.load_robot("panda")
position = panda.kinematics(mp.Task.position())
q = panda.neutral
jacobian = position.jacobian(q)
centre = position.pose(q)[:3, 3]
velocity = mp.measures.velocity_ellipsoid(jacobian)
acceleration = mp.measures.dynamic_ellipsoid(jacobian, position.mass_matrix(q))
figure = plt.figure(figsize=(5.5, 4.6))
ax = figure.add_subplot(projection="3d")
viz.plot_ellipsoid(velocity, centre, ax=ax, scale=0.3, alpha=0.35)
viz.plot_ellipsoid(
    acceleration,
    centre,
    ax=ax,
    scale=0.3 * velocity.radii[0] / acceleration.radii[0],
    color="#0072B2",
    alpha=0.35,
)
ax.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
ax.set_aspect("equal")
ax.locator_params(nbins=4)
# sphinx_gallery_thumbnail_number = 2

# %%
# Every measure at the same posture.

for name in mp.measures.available_measures():
    if "transmission" in name:
        continue
    measure = panda.kinematics(mp.Task.pose(0.5), measure=name)
    print(
        f"{name:29s} {measure.manipulability(q):10.4g}  "
        f"{measure.measure.unit(measure.task)}"
    )
for measure in (
    mp.measures.VelocityTransmission(direction=(0, 0, 1)),
    mp.measures.ForceTransmission(direction=(0, 0, 1)),
):
    value = panda.kinematics(mp.Task.position(), measure=measure).manipulability(q)
    print(
        f"{measure.name + ' along z':29s} {value:10.4g}  "
        f"{measure.unit(mp.Task.position())}"
    )

# %%
# Along one joint, here the elbow, the measures disagree about where the arm is best.
# The Frobenius norm adds up the speeds of all directions, so it is largest near the
# limit, where the other three have already dropped.

bend = np.linspace(panda.limits.lower[3], panda.limits.upper[3], 300)
many = np.tile(q, (300, 1))
many[:, 3] = bend
best = {}
figure, ax = plt.subplots(figsize=(7, 3.4))
for name, line in (
    ("yoshikawa", "-"),
    ("smallest_singular_value", "--"),
    ("isotropy", "-."),
    ("frobenius", ":"),
):
    values = panda.kinematics(mp.Task.position(), measure=name).manipulability(many)
    ax.plot(bend, values / values.max(), line, label=name)
    print(f"{name:24s} largest at {bend[values.argmax()]:6.2f} rad")
    best[name] = bend[values.argmax()]
assert best["frobenius"] > -0.1 > -1.4 > best["yoshikawa"]
ax.set(xlabel="elbow angle [rad]", ylabel="share of the maximum", ylim=(0, 1.05))
ax.legend(frameon=False, fontsize=8)
figure.tight_layout()
