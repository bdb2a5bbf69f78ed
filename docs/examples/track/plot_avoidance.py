"""
A controller in a loop, with something in the way
=================================================

.. image:: /pictures/avoidance.jpg
   :alt: A Panda gives way to a ball that flies through the place of its wrist.
   :width: 560px

*For teleoperation and visual servoing.*

Your robot's interface needs joint velocities every few milliseconds. You have a target
pose of the tool, perhaps from a teleoperation device or a camera, and moving obstacles.
``mp.Controller`` computes the velocities, keeps the limits, avoids the obstacles, and
raises the manipulability.
"""

# sphinx_gallery_thumbnail_path = "pictures/avoidance.jpg"

import time

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
kinematics = robot.kinematics()
dt = 0.005
q = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 2.0, 0.785])
start = kinematics.pose(q)

# %%
# The controller is built once. The ball moves; the floor does not. Below the distance
# ``influence``, the speed at which an obstacle and the arm may approach is limited, and
# the limit falls to zero at ``security``.

ball = mp.Sphere(radius=0.07, position=(0.60, 0.45, 0.62), name="ball")
scene = mp.Scene([ball, mp.Plane(position=(0.0, 0.0, -0.02), name="floor")])
avoidance = mp.Avoidance(
    scene=scene,
    influence=0.15,
    security=0.03,
    damping=0.5,
    moving=["ball"],
    links=["panda_link4", "panda_link5", "panda_link6", "panda_link7", "panda_hand"],
    itself=False,
)
tube = mp.Tolerance(position=0.05, rotation=0.3)
controller = mp.Controller(
    robot, mp.formulations.LogDrive(), dt=dt, tolerance=tube, avoidance=avoidance
)
print(f"{len(controller.pairs)} pairs of bodies are kept apart")

# %%
# The loop: the tool moves sideways and back while the ball flies through the place of
# the wrist. At each step the controller gets the state, the target, and the position
# and velocity of the ball.

steps = 1200
log = {name: np.empty(steps) for name in ("m", "clearance", "deviation", "solved")}
postures, balls = np.empty((steps, robot.n)), np.empty((steps, 3))
qd = np.zeros(robot.n)
speed = np.array([0.0, -0.20, 0.0])
largest = np.zeros(robot.n)
for k in range(steps):
    t = k * dt
    target = start.copy()
    target[:3, 3] += [0.0, 0.25 * np.sin(2 * np.pi * t / 6.0), 0.0]
    centre = np.array([0.60, 0.45, 0.62]) + speed * t
    place = np.eye(4)
    place[:3, 3] = centre
    command = controller.step(
        q, qd, target, obstacles={"ball": (place, [*speed, 0.0, 0.0, 0.0])}
    )
    report = controller.report
    largest = np.maximum(largest, np.abs(command - qd) / dt / robot.limits.acceleration)
    q, qd = q + dt * command, command
    postures[k], balls[k] = q, centre
    log["m"][k], log["clearance"][k] = report.manipulability, report.clearance
    log["deviation"][k] = np.linalg.norm((kinematics.pose(q) - target)[:3, 3])
    log["solved"][k] = not report.status.brakes
print(
    f"{int(log['solved'].sum())} of {steps} steps solved; minimum distance "
    f"{1e3 * log['clearance'].min():.1f} mm"
)
print(f"largest share of an acceleration limit: {largest.max():.4f}")
assert log["solved"].all() and log["clearance"].min() > 0.03
assert largest.max() <= 1 + 1e-6

# %%
# Time of one step, measured on the machine that built this page: called from Python,
# and inside a rollout in C.


around = {"ball": (place, [*speed, 0.0, 0.0, 0.0])}
durations = np.empty(2000)
for k in range(len(durations)):
    begin = time.perf_counter()
    controller.step(q, qd, target, obstacles=around)
    durations[k] = time.perf_counter() - begin
median, slow = 1e6 * np.quantile(durations, [0.5, 0.99])
print(
    f"one step from Python: median {median:.0f} µs, 99 % below {slow:.0f} µs, of a "
    f"period of {1e6 * dt:.0f} µs"
)
targets = np.repeat(start[None], 2000, axis=0)
begin = time.perf_counter()
controller.rollout(q, targets)
print(f"one step in a rollout: {1e6 * (time.perf_counter() - begin) / 2000:.0f} µs")

# %%
# The ball approaches, the arm gives way inside its tube, and then it returns to its
# target.

t = dt * np.arange(steps)
figure, panels = plt.subplots(
    3, 1, figsize=(7.5, 6.4), sharex=True, layout="constrained"
)
panels[0].plot(t, 1e3 * log["clearance"], color="#D55E00")
panels[0].axhline(30, color="0.4", linestyle=":", label="security distance")
panels[0].set(ylabel="minimum distance [mm]", ylim=(0, None), xlim=(0, t[-1]))
panels[1].plot(t, 1e3 * log["deviation"], color="#0072B2")
panels[1].axhline(50, color="0.4", linestyle=":", label="tube")
panels[1].set(ylabel="deviation [mm]", ylim=(0, None))
panels[2].plot(t, log["m"], color="#009E73")
panels[2].set(
    xlabel="time [s]", ylabel="manipulability [m⁶]", ylim=(0, 1.15 * log["m"].max())
)
for ax in panels[:2]:
    ax.legend(frameon=False, fontsize=8)
plt.show()

# %%
# A bad message must not break the control loop: if the target is not a number, the
# controller brakes within all limits and reports it.

controller.step(q, qd, np.full((4, 4), np.nan), obstacles=around)
print(controller.report.status.name)
assert controller.report.status is mp.results.StepStatus.BAD_TARGET
