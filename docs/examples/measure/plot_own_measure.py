"""
Add your own measure
====================

The twelve measures of the library may not be the one that your task needs. A
measure is a class with two methods: its value as a CasADi expression, and its unit.
Gradient, Hessian, machine code, batches and the path optimiser come by themselves.
"""

# %%
# The task of this page: an arm that deburrs presses along the tool's axis z and
# slides along x. It should be **strong** in z and **fast** in x at once. With the
# rows of the position Jacobian, (a J Jᵀ a)^(1/2) is how fast joints of unit speed
# move the tool along a; the ratio below is large where sliding is fast and pressing
# is strong.

from dataclasses import dataclass

import casadi as ca
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp


@dataclass(frozen=True, kw_only=True)
class SlideAndPress(mp.Measure):
    """sqrt(xᵀ J Jᵀ x) / sqrt(zᵀ J Jᵀ z + floor²), times Yoshikawa's index."""

    floor: float = (
        0.05  # [m] keeps the measure smooth where pressing is infinitely strong
    )

    name = "slide_and_press"
    formula = "‖Jᵀ x‖ / sqrt(‖Jᵀ z‖² + floor²) · m"
    source = ""

    def unit(self, task):
        return task.unit

    def value(self, posture):
        J = posture.jacobian
        slide, press = ca.sumsqr(J[0, :]), ca.sumsqr(J[2, :])
        volume = ca.sqrt(ca.det(J @ J.T))
        return ca.sqrt(slide / (press + self.floor**2)) * volume


# %%
# It is used like any other. The library differentiates it; finite differences check
# that.

robot = mp.load_robot("panda")
task = mp.Task.position()
measure = SlideAndPress()
kinematics = robot.kinematics(task, measure=measure)
q = robot.neutral
gradient, hessian = kinematics.gradient(q), kinematics.hessian(q)
step = 1e-6
differences = np.array(
    [
        (
            kinematics.manipulability(q + step * e)
            - kinematics.manipulability(q - step * e)
        )
        / (2 * step)
        for e in np.eye(robot.n)
    ]
)
curvature = np.array(
    [
        (kinematics.gradient(q + step * e) - kinematics.gradient(q - step * e))
        / (2 * step)
        for e in np.eye(robot.n)
    ]
)
print(f"value {kinematics.manipulability(q):.4f} {measure.unit(task)}")
print("gradient:", gradient.round(4))
print(
    f"against differences: gradient {np.abs(gradient - differences).max():.1e}, "
    f"Hessian {np.abs(hessian - curvature).max():.1e}"
)
assert np.allclose(gradient, differences, atol=1e-7)
assert np.allclose(hessian, curvature, atol=1e-6)

# %%
# Optimise a path for it, and compare with the path that is best for Yoshikawa's
# index. ``grows = True``, the default of a measure, says that larger is better,
# which the optimiser needs. ``compiled=False`` spares the compiler, which pays only
# when the same robot and measure are used again and again.

start, goal = (
    [-0.6, -0.2, 0.1, -2.3, 0.0, 2.1, 0.8],
    [0.7, 0.3, 0.2, -1.9, 0.2, 2.3, 0.8],
)
options = {"task": task, "power": 2, "compiled": False}
ours = mp.optimize_path(robot, start, goal, measure=measure, **options)
theirs = mp.optimize_path(robot, start, goal, **options)
print(f"{ours.status.name}; least value on the path {ours.min_manipulability:.4f}")
g_theirs = mp.path_cost(theirs.path, kinematics, 2).g
print(f"g by our measure: {ours.g:.3f} on our path, {g_theirs:.3f} on Yoshikawa's path")
assert ours.g < g_theirs

# %%
# What it means in numbers: speed along x and force along z for joints of unit speed
# and unit torque.

s = np.linspace(0, 1, 300)
position = robot.kinematics(task)
figure, panels = plt.subplots(1, 3, figsize=(11, 3.4), layout="constrained")
for name, result, colour in (
    ("slide and press", ours, "#0072B2"),
    ("yoshikawa", theirs, "#E69F00"),
):
    J = position.jacobian(result.path(s))
    values = (
        kinematics.manipulability(result.path(s)),
        np.linalg.norm(J[:, 0], axis=1),
        1 / np.linalg.norm(J[:, 2], axis=1),
    )
    for ax, value in zip(panels, values, strict=True):
        ax.plot(s, value, color=colour, label=f"path for {name}")
labels = ("slide and press [m³]", "speed along x [m/s]", "force along z [N]")
for ax, label in zip(panels, labels, strict=True):
    ax.set(xlabel="s", ylabel=label, xlim=(0, 1))
figure.legend(
    *panels[0].get_legend_handles_labels(), loc="outside upper center", ncols=2
)
plt.show()

# %%
# When it fails: a measure that is not differentiable somewhere (``fabs``,
# ``if_else``) stops the optimiser there, so round it off, as the floor above does.
# One that is better when smaller needs ``grows = False``; it can be evaluated, not
# maximised: take its inverse.
