"""
Follow a circle, and stay able to move
======================================

A Panda moves its hand around a circle that touches the edge of its reach. If the hand
follows it exactly, the manipulability falls to a third there. Inside a tube of 2 cm
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
    print(f"{name}: {motion}")

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
for kind, use in mp.limit_use(trajectory, robot.limits).items():
    print(f"{kind:12s} {use.ratio:.6f} {use.joint}")

# %%
# One step of the controller alone, as a control loop calls it: the joint velocities for
# the next 10 ms, and the report of the step.

controller = mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01)
velocity = controller.step(start, np.zeros(robot.n), near)
print(velocity.round(4))
print(controller.report)
