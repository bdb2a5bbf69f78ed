"""
Time a path: jerk, torque, and how fast the tool may go
=======================================================

You have a path, from any planner or file, and want the fastest motion along it that
your arm can play. ``mp.retime`` knows limits of velocity, acceleration, jerk and
torque, slower parts, and the tool's speed. What comes out is checked: no limit is
exceeded.
"""

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
start = np.array([-0.8, -0.3, 0.3, -2.3, 0.0, 2.0, 0.8])
path = mp.optimize_path(robot, start, [0.9, 0.4, -0.2, -1.6, 0.3, 2.2, 1.2]).path
limits = robot.limits
print("jerk limits [rad/s³]:", limits.jerk)

# %%
# One option at a time. Without jerk limits acceleration jumps, which excites an
# arm; with them the motion takes a little longer. A path through corners stops at
# each.

no_jerk = robot.with_limits(jerk=np.inf).limits
gentle = robot.with_limits(
    jerk=limits.jerk / 20, source="a twentieth of the data sheet"
).limits
slow_end = mp.Segment(begin=0.7, end=1.0, velocity=0.3)
careful = mp.Segment(begin=0.3, end=0.6, tool_speed=0.25)
motions = {
    "velocity and acceleration": mp.retime(path, no_jerk),
    "and jerk of the data sheet": mp.retime(path, limits),
    "and a twentieth of that jerk": mp.retime(path, gentle),
    "and the last part at 30 % speed": mp.retime(path, gentle, segments=[slow_end]),
    "and the tool below 0.25 m/s in the middle": mp.retime(
        path, gentle, segments=[careful], robot=robot
    ),
    "data sheet, and torque": mp.retime(path, limits, torque_model=robot.model),
    "data sheet, straight by way of two corners": mp.retime(
        mp.JointPath.through(path([0.0, 0.3, 0.7, 1.0])), limits
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
assert mp.jerk_use(motions["and a twentieth of that jerk"], gentle).ratio <= 1 + 1e-9

# %%
# A jerk of "inf" means that acceleration jumps somewhere. The torque of all these
# motions is within the effort limits already, so that asking for it changes little
# here; with a heavy load in the hand it does. The two tighter parts are timed with
# the low jerk limit.
#
# Above the speed of the tool by time, below the largest share of an acceleration
# limit.

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
# **Begin or end moving.** ``start_speed`` and ``end_speed`` are norms of the joint
# velocity along the path. More than the limits allow is refused, with the most that
# they do.

moving = mp.retime(path, no_jerk, start_speed=0.5)
print(
    f"starting at 0.5 rad/s: {moving.duration:.3f} s instead of "
    f"{motions['velocity and acceleration'].duration:.3f} s"
)
try:
    mp.retime(path, no_jerk, end_speed=50.0, joint_names=robot.joint_names)
except mp.InvalidInputError as error:
    print(error)

# %%
# When no motion is possible at all, the message names the joint and the cause. Here
# the shoulder is too weak to hold the arm up:

weak = robot.with_limits(effort=np.where(np.arange(7) == 1, 5.0, limits.effort)).limits
try:
    mp.retime(path, weak, torque_model=robot.model, joint_names=robot.joint_names)
except mp.PlanningError as error:
    print(error)
