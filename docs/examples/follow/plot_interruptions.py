"""
A path that needs two interruptions
===================================

.. image:: /pictures/interruptions.jpg
   :alt: A Panda with the path of its tool around itself: three turns of a helix
         with two retreats.
   :width: 560px

*For paths that are longer than the range of a joint.*

A Panda stands inside a tank and sprays its wall: the tool goes three times around the
robot and rises. The cables allow the first joint 137 degrees to either side, so no
single motion follows the path. How often does the tool have to leave it, and where?
"""

# %%
# The path is laid through the poses of a helix with a diameter of 1 m.

# sphinx_gallery_thumbnail_path = "pictures/interruptions.jpg"
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
lower, upper = robot.limits.lower.copy(), robot.limits.upper.copy()
lower[0], upper[0] = -2.4, 2.4
robot = robot.with_limits(lower=lower, upper=upper, source="cables")

share = np.linspace(0, 1, 161)
angle = 6 * np.pi * share - np.pi
poses = np.tile(np.eye(4), (len(share), 1, 1))
poses[:, 0, 0] = poses[:, 0, 3] = np.cos(angle)
poses[:, 1, 0] = poses[:, 1, 3] = np.sin(angle)
poses[:, 0, 1], poses[:, 1, 1] = np.sin(angle), -np.cos(angle)
poses[:, 2, 2] = -1  # the tool points down
poses[:, :2, 3] *= 0.5
poses[:, 2, 3] = 0.2 + 0.3 * share
path = mp.CartesianPath.through(poses)
print(f"length of the path: {path.length:.2f} m")

# %%
# Without ``interruptions`` the path is refused, and the message says how many of them
# would do. That number is proven to be the smallest among all configurations at the
# sampled positions.

try:
    mp.follow(robot, path, positions=180)
except mp.errors.PlanningError as error:
    message = str(error)
print(message.rsplit("; ", maxsplit=1)[-1])
assert "2 interruptions" in message

# %%
# With ``interruptions=2`` there is a motion. At an interruption the tool
# retreats by 5 cm against its z-axis, the arm moves to another configuration, and the
# tool comes back to the pose where it left. Of all motions with so few interruptions
# this one has the largest minimum manipulability on the path.

plan = mp.follow(robot, path, positions=180, interruptions=2, retreat=0.05)
print(plan.status.name)
assert plan.status is mp.Status.FOLLOWED_IN_PARTS
assert plan.report.min_manipulability > 0.005  # [m^6], on the path
for part in plan.report.along:
    print(
        f"s = {part.s_begin:.2f} to {part.s_end:.2f}: minimum manipulability "
        f"{part.min_manipulability:.4f} m^6"
    )
assert len(plan.off_path) == 2

# %%
# Left: the tool's way seen from above, one colour for each part, and the ways between
# them in grey. Right: the first joint, which goes back while the tool is off the path.

t = np.linspace(0, plan.trajectory.duration, 3000)
q = plan.trajectory(t)
x, y, z = robot.kinematics().pose(q)[:, :3, 3].T

figure = plt.figure(figsize=(11, 5), layout="constrained")
left, right = figure.subfigures(1, 2)
above = left.add_subplot(projection="3d")
ax = right.subplots()
for begin, end in plan.off_path:
    here = (t >= begin) & (t <= end)
    above.plot(x[here], y[here], z[here], color="0.6", linewidth=1)
    ax.axvspan(begin, end, color="0.9")
for k, part in enumerate(plan.report.along):
    here = (t >= part.begin) & (t <= part.end)
    label, color = f"part {k + 1}", f"C{k}"
    above.plot(x[here], y[here], z[here], color=color, label=label)
    ax.plot(t[here], np.rad2deg(q[here, 0]), color=color, label=label)
above.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
above.set_aspect("equal")
above.set_box_aspect(None, zoom=0.85)
above.legend(loc="upper left")
for limit in (lower[0], upper[0]):
    ax.axhline(np.rad2deg(limit), color="k", linestyle="--", linewidth=1)
ax.set(xlabel="time [s]", ylabel="first joint [°]; dashed: limits")
ax.set_xlim(0, t[-1])
plt.show()

# %%
# Switch the spray off during ``plan.off_path``. ``mp.check`` judges such a trajectory
# part by part, whoever made it.

judged = mp.check(robot, plan.trajectory, path=path, path_parts=plan.report.along)
print(f"duration {judged.duration:.1f} s, {len(judged.faults)} faults")
assert judged.passed and judged.deviation.position < 1e-4  # [m]
