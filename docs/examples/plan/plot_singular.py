"""
Start and goal in different aspects
===================================

.. image:: /pictures/singular.jpg
   :alt: A UR5 at the goal, on the path to a configuration in the aspect of the
         start.
   :width: 560px

*For users of arms with six joints.*

A UR5 has six joints and a pose has six numbers, so its configurations form regions, the
aspects, and every motion from one to another crosses a singularity. The optimiser
crosses it steeply. This page shows what the certificate says about that, and how another
configuration of the same goal avoids it.
"""

# sphinx_gallery_thumbnail_path = "pictures/singular.jpg"

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("ur5")
kinematics = robot.kinematics()
start = np.array([0.4, -1.2, 1.5, -1.8, -1.3, 0.7])
goal = np.array([1.4, -0.5, -1.3, 0.3, -1.2, 0.5])  # the elbow bends the other way

# %%
# The certificate names the singularities that the path crosses, and the smallest number
# that any path has to cross.

result = mp.optimize_path(robot, start, goal)
certificate = result.certificate
print(result.status.name, f"g {result.g:.0f}")
for crossing in certificate.crossings:
    print(f"{crossing}; its share in g: {crossing.cost:.0f}")
print("smallest number of crossings of any path:", certificate.least_crossings)
assert result.status is mp.Status.OPTIMAL
assert len(certificate.crossings) == certificate.least_crossings == 1

# %%
# Often only the pose of the tool matters, and other configurations reach it, too. With
# the pose as its goal, ``plan`` chooses the configuration with the best motion.

plan = mp.plan(robot, start, kinematics.pose(goal))
best = plan.result
print(f"g {best.g:.0f} instead of {result.g:.0f}")
assert plan.status is mp.Status.OPTIMAL
assert best.g < 150 and 1200 < result.g < 1400
for each in plan.candidates[:4]:
    print(each.q.round(2), f"at least {each.least_crossings} crossings")
assert not best.certificate.crossings
assert np.allclose(kinematics.pose(best.path.goal), kinematics.pose(goal), atol=1e-9)

# %%
# det J along both paths: the first one crosses zero steeply, the second one does not.

s = np.linspace(0, 1, 800)
fig, ax = plt.subplots(figsize=(7.5, 3.6), layout="constrained")
for name, path, colour in (
    ("goal as given", result.path, "#D55E00"),
    ("another configuration of the same pose", best.path, "#0072B2"),
):
    ax.plot(
        s,
        [np.linalg.det(J) for J in kinematics.jacobian(path(s))],
        color=colour,
        label=name,
    )
ax.axhline(0.0, color="0.3", linewidth=0.8)
ax.annotate("singular", (0.02, 0.0), xytext=(0.02, 0.0), va="bottom", fontsize=8)
ax.set(xlabel="s", ylabel="det J [m⁶]", xlim=(0, 1))
ax.legend(frameon=False)
plt.show()

# %%
# **Which limit is active?** A limit can also make a path worse. The certificate gives
# the distance of the path to each limit, and how much larger g is than for the same
# problem without limits: the gap. Here a mechanical stop limits joint 3 of a planar
# arm:

arm = mp.planar_arm([1.0, 1.0, 1.0])
start, goal = [2.0, -2.6, 1.3], [-1.8, 2.0, 0.2]
options = {"objective": mp.PathObjective(power=2), "compare": True}
free = mp.optimize_path(arm, start, goal, **options)
stopped = arm.with_limits(lower=-3.1, upper=[3.1, 3.1, 1.4])
held = mp.optimize_path(stopped, start, goal, **options)
for name, result in (("no limits", free), ("joint 3 below 1.4 rad", held)):
    print(
        f"{name:22s} g {result.g:.3f}, gap {result.certificate.gap:7.2%}, joint 3 "
        f"up to {result.path.bounds()[1][2]:.3f} rad"
    )
for approach in held.certificate.limits[:3]:
    print(
        f"{approach.joint}: {approach.distance:.4f} {approach.unit} to its "
        f"{approach.side} limit, at s = {approach.at:.2f}"
    )
assert held.status is free.status is mp.Status.OPTIMAL
assert 1.36 < free.g < 1.38 and 1.38 < held.g < 1.41
