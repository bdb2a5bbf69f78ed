"""
Add your own measure
====================

.. image:: /pictures/own_measure.jpg
   :alt: A Panda and the ways of its tool, by the new measure and by Yoshikawa's.
   :width: 560px

*For tasks that no built-in measure describes.*

If none of the library's twelve measures fits your task, write your own. A measure is a
class with two methods: its value as a CasADi expression, and its unit. You get the
gradient, the Hessian, machine code, batches and the path optimiser without further
code.
"""

# %%
# The task of this page: an arm that deburrs a horizontal plate presses along z of its
# base and slides along x. It should be **strong** in z and **fast** in x at the same
# time. With the rows of the position Jacobian, √(aᵀ J Jᵀ a) is the speed of the
# tool along a for joint velocities of norm 1. The ratio below is large where sliding is
# fast and pressing is strong.

# sphinx_gallery_thumbnail_path = "pictures/own_measure.jpg"
from dataclasses import dataclass

import casadi as ca
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp


@dataclass(frozen=True, kw_only=True)
class SlideAndPress(mp.measures.Measure):
    """sqrt(xᵀ J Jᵀ x) / sqrt(zᵀ J Jᵀ z + floor²), times Yoshikawa's measure."""

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
# Use it like any other measure. The library differentiates it; here finite differences
# check the derivatives.

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
# Optimise a path for it, and compare it with the path that is best for Yoshikawa's
# manipulability. ``larger_is_better = True``, the default of a measure, says that larger is
# better, which the optimiser needs. ``compiled=False`` skips the compilation, which
# pays off only if the same robot and measure are used many times.

start, goal = (
    [-0.6, -0.2, 0.1, -2.3, 0.0, 2.1, 0.8],
    [0.7, 0.3, 0.2, -1.9, 0.2, 2.3, 0.8],
)
for_ours = mp.PathObjective(power=2, task=task, measure=measure)
for_theirs = mp.PathObjective(power=2, task=task)
ours = mp.optimize_path(robot, start, goal, objective=for_ours, compiled=False)
theirs = mp.optimize_path(robot, start, goal, objective=for_theirs, compiled=False)
print(f"{ours.status.name}; minimum on the path {ours.min_manipulability:.4f}")
g_theirs = mp.path_cost(theirs.path, kinematics, 2).g
print(f"g by our measure: {ours.g:.3f} on our path, {g_theirs:.3f} on Yoshikawa's path")
assert ours.status is theirs.status is mp.Status.OPTIMAL
assert ours.g < 70 and g_theirs > 150

# %%
# The effect in numbers: the speed along x for joint velocities of norm 1, and the force
# along z for joint torques of norm 1.

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
# If it fails: a measure that is not differentiable somewhere (``fabs``, ``if_else``)
# stops the optimiser there, so smooth it, as the floor above does. A measure for which
# smaller is better needs ``larger_is_better = False``. It can be evaluated but not maximised; use
# its inverse instead.
