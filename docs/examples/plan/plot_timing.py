"""
Time a path: jerk, torque, and how fast the tool may go
=======================================================

.. image:: images/sphx_glr_plot_timing_001.png
   :alt: Speed of the tool and largest share of an acceleration limit over time, for
         four timings of one path.

*For anyone who has a path and needs a motion.*

You have a path from any planner or file, and you want the fastest motion along it that
your arm can execute. ``mp.retime`` keeps the robot's velocity, acceleration and jerk
limits, or the ``limits=`` that you pass instead. On request it also limits the torques,
the speed in parts of the path, and the speed of the tool. The result is checked: no
limit is exceeded.
"""

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
start = np.array([-0.8, -0.3, 0.3, -2.3, 0.0, 2.0, 0.8])
result = mp.optimize_path(robot, start, [0.9, 0.4, -0.2, -1.6, 0.3, 2.2, 1.2])
assert result.status is mp.Status.OPTIMAL
path = result.path
limits = robot.limits
print("jerk limits [rad/s³]:", limits.jerk)

# %%
# Compare the options one at a time. Without jerk limits, the acceleration jumps, which
# excites vibrations of the arm. With them, the motion takes a little longer. A path
# with corners stops at each corner.

no_jerk = robot.with_limits(jerk=np.inf).limits
gentle = robot.with_limits(
    jerk=limits.jerk / 20, source="a twentieth of the data sheet"
).limits
slow_end = mp.Segment(begin=0.7, end=1.0, velocity=0.3)
careful = mp.Segment(begin=0.3, end=0.6, tool_speed=0.25)
motions = {
    "velocity and acceleration": mp.retime(path, robot, limits=no_jerk),
    "and jerk of the data sheet": mp.retime(path, robot, limits=limits),
    "and a twentieth of that jerk": mp.retime(path, robot, limits=gentle),
    "and the last part at 30 % speed": mp.retime(
        path, robot, limits=gentle, segments=[slow_end]
    ),
    "and the tool below 0.25 m/s in the middle": mp.retime(
        path, robot, limits=gentle, segments=[careful]
    ),
    "data sheet, and torque": mp.retime(path, robot, limits=limits, torque=True),
    "data sheet, straight lines, two corners": mp.retime(
        mp.JointPath.through(path([0.0, 0.3, 0.7, 1.0])), robot, limits=limits
    ),
}
print(
    f"{'what limits the motion':42s} time [s]  velocity  acceleration  jerk    torque"
)
for name, motion in motions.items():
    use = mp.limit_use(motion, limits)
    jerk = mp.jerk_use(motion, limits).ratio
    torque = mp.torque_use(motion, robot.model, limits.effort).ratio
    shares = f"{use['velocity'].ratio:8.1%}  {use['acceleration'].ratio:12.1%}"
    shares += f"  {jerk:5.1%}  {torque:6.1%}"
    print(f"{name:42s} {motion.duration:8.3f}  {shares}")
assert (
    motions["velocity and acceleration"].duration
    <= motions["and jerk of the data sheet"].duration
)
assert 0.9 < motions["and jerk of the data sheet"].duration < 1.0  # [s]
assert mp.jerk_use(motions["and a twentieth of that jerk"], gentle).ratio <= 1 + 1e-9

# %%
# A jerk of "inf" means that the acceleration jumps somewhere. The torques of all these
# motions are already within the effort limits, so ``torque=True`` changes little here.
# With a heavy payload it changes more. The two motions with a slower part are timed
# with the low jerk limit.
#
# Top: speed of the tool over time. Bottom: largest share of an acceleration limit.

velocity = robot.kinematics(mp.Task.position())


def tool_speed(motion, t):
    return np.linalg.norm(
        np.einsum("kij,kj->ki", velocity.jacobian(motion(t)), motion(t, 1)), axis=1
    )


shown = (
    "velocity and acceleration",
    "and a twentieth of that jerk",
    "and the tool below 0.25 m/s in the middle",
    "and the last part at 30 % speed",
)
figure, (top, bottom) = plt.subplots(
    2, 1, figsize=(7.8, 5.4), sharex=True, layout="constrained"
)
for name, colour in zip(
    shown, ("#E69F00", "#009E73", "#0072B2", "#CC79A7"), strict=True
):
    motion = motions[name]
    t = np.linspace(0, motion.duration, 1500)
    top.plot(t, tool_speed(motion, t), color=colour, label=name)
    bottom.plot(
        t, (np.abs(motion(t, 2)) / limits.acceleration).max(axis=1), color=colour
    )
top.axhline(0.25, color="0.5", linestyle=":", linewidth=1)
top.set(ylabel="speed of the tool [m/s]", ylim=(0, None))
top.legend(
    frameon=False, fontsize=8, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2
)
bottom.set(
    xlabel="time [s]",
    ylabel="largest share of an\nacceleration limit",
    xlim=(0, None),
    ylim=(0, 1.05),
)
plt.show()

# %%
# **Begin or end in motion.** ``start_speed`` and ``end_speed`` are norms of the joint
# velocity along the path. A speed above the limits is rejected, and the message gives
# the largest speed that the limits allow.

moving = mp.retime(path, robot, limits=no_jerk, start_speed=0.5)
print(
    f"starting at 0.5 rad/s: {moving.duration:.3f} s instead of "
    f"{motions['velocity and acceleration'].duration:.3f} s"
)
try:
    mp.retime(path, robot, limits=no_jerk, end_speed=50.0)
except mp.errors.InvalidInputError as error:
    print(error)

# %%
# When no motion is possible at all, the message names the joint and the cause. Here
# the shoulder is too weak to hold the arm up:

weak = robot.with_limits(effort=np.where(np.arange(7) == 1, 5.0, limits.effort)).limits
try:
    mp.retime(path, robot, limits=weak, torque=True)
except mp.errors.PlanningError as error:
    print(error)
