"""
Follow a circle, and stay able to move
======================================

.. image:: /pictures/tracking.jpg
   :alt: A Panda on a circle that reaches to the edge of its workspace.
   :width: 560px

*For those who follow a prescribed path in real time.*

A Panda moves its hand around a circle that touches the edge of its reach. If the hand
follows it exactly, the manipulability falls to a third there. Inside a tube of 2 cm
there is a motion that keeps most of it.
"""

# sphinx_gallery_thumbnail_path = "pictures/tracking.jpg"

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
start = [0.0, -0.3, 0.0, -2.2, 0.0, 2.0, 0.785]
near = robot.kinematics().pose(start)
path = mp.CartesianPath.circle(
    near, near[:3, 3] + [0.1405, 0.0, 0.0], axis=(0.0, 0.0, 1.0)
)

# %%
# Three ways to follow it, each in steps of 10 ms. Every motion keeps the position,
# velocity and acceleration limits.

tube = mp.Tolerance(position=0.02, rotation=0.1)
motions = {
    "exactly": mp.track(
        robot, path, start, mp.formulations.General(), dt=0.01, duration=4.0
    ),
    "held at a stiffness of 10⁴": mp.track(
        robot, path, start, mp.formulations.LogDrive(), dt=0.01, duration=4.0
    ),
    "inside a tube of 2 cm": mp.track(
        robot,
        path,
        start,
        mp.formulations.LogDrive(),
        dt=0.01,
        duration=4.0,
        tolerance=tube,
        stiffness=mp.StiffnessProfile(degree=20),
    ),
}
for name, motion in motions.items():
    m, off = motion.manipulability.min(), 1e3 * motion.deviation.max()
    print(f"{name}: minimum manipulability {m:.4f} m^6, deviation {off:.1f} mm")
    assert motion.status is mp.Status.TRACKED
assert motions["exactly"].manipulability.min() < 0.0045
assert motions["inside a tube of 2 cm"].manipulability.min() > 0.0085

figure, (top, bottom) = plt.subplots(2, 1, figsize=(7, 5.2), sharex=True)
for (name, motion), style in zip(motions.items(), ("k:", "C0--", "C2-"), strict=True):
    top.plot(motion.t, motion.manipulability, style, label=name)
    bottom.plot(motion.t, 1e3 * motion.deviation, style)
top.set(ylabel="manipulability [m⁶]", ylim=(0, None))
top.legend(frameon=False)
bottom.set(xlabel="time [s]", ylabel="deviation [mm]")
figure.tight_layout()

# %%
# The motion as a trajectory of positions and velocities, and the largest share of each
# limit, computed in closed form.

trajectory = motions["inside a tube of 2 cm"].trajectory()
use = mp.limit_use(trajectory, robot.limits)
for kind in ("velocity", "acceleration"):
    print(f"{kind}: {use[kind].ratio:.1%} of the limit, {use[kind].joint}")
    assert use[kind].ratio <= 1 + 1e-6

# %%
# One step of the controller alone, as a control loop calls it: the joint velocities for
# the next 10 ms, and the report of the step.

controller = mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01)
velocity = controller.step(start, np.zeros(robot.n), near)
report = controller.report
print("velocities [rad/s]:", velocity.round(3) + 0.0)
print(f"{report.status.name}, m = {report.manipulability:.4f} m^6")
