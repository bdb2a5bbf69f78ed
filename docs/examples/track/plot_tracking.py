"""
Follow a circle, and stay able to move
======================================

A Panda moves its hand around a circle that touches the edge of its reach. Followed
exactly, the manipulability index falls to a third there; inside a tube of 2 cm
there is a motion that keeps most of it.
"""

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
# Three ways to follow it, each in steps of 10 ms. Every motion keeps the limits of
# position, velocity and acceleration.

tube = mp.Tolerance(position=0.02, rotation=0.1)
motions = {
    "exactly": mp.track(robot, path, start, 0.01, mp.General(), duration=4.0),
    "held at a stiffness of 10⁴": mp.track(
        robot, path, start, 0.01, mp.LogDrive(), duration=4.0
    ),
    "inside a tube of 2 cm": mp.track(
        robot,
        path,
        start,
        0.01,
        mp.LogDrive(),
        duration=4.0,
        tolerance=tube,
        stiffness=mp.StiffnessProfile(degree=20),
    ),
}
for name, motion in motions.items():
    print(f"{name}: {motion}")

figure, (top, bottom) = plt.subplots(2, 1, figsize=(7, 5.2), sharex=True)
for (name, motion), style in zip(motions.items(), ("k:", "C0--", "C2-"), strict=True):
    top.plot(motion.t, motion.manipulability, style, label=name)
    bottom.plot(motion.t, 1e3 * motion.deviation, style)
top.set(ylabel="index [m⁶]", ylim=(0, None))
top.legend(frameon=False)
bottom.set(xlabel="time [s]", ylabel="deviation [mm]")
figure.tight_layout()

# %%
# The motion as a trajectory of position and velocity, checked from closed forms:
# the largest share of each limit.

trajectory = motions["inside a tube of 2 cm"].trajectory()
for kind, use in mp.limit_use(trajectory, robot.limits).items():
    print(f"{kind:12s} {use.ratio:.6f} {use.joint}")

# %%
# One step of the controller alone, as a control loop calls it: the velocities for
# the next 10 ms, and what the step found.

controller = mp.Controller(robot, mp.LogDrive(), 0.01)
velocity = controller.step(start, np.zeros(robot.n), near)
print(velocity.round(4))
print(controller.report)
