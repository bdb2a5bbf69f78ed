"""
When no motion follows the path
===============================

.. image:: /pictures/no_motion.jpg
   :alt: A Panda on a line that its tool follows while it turns.
   :width: 560px

*For anyone whose path was refused.*

A Panda draws a line while the tool turns about its own axis, once around and a bit more.
No single motion follows that. The message says where the motions end, what ends them, and
how closely that was searched; three remedies are at hand.
"""

# %%
# The tool points down, moves 60 cm along y, and turns by 7 rad.

# sphinx_gallery_thumbnail_path = "pictures/no_motion.jpg"
from itertools import pairwise

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")


def line(turn):
    """The line on which the tool turns by an angle [rad]."""
    u = np.linspace(0, 1, 61)
    poses = np.tile(np.eye(4), (len(u), 1, 1))
    cos, sin = np.cos(turn * u), np.sin(turn * u)
    poses[:, 0, 0], poses[:, 0, 1], poses[:, 1, 0] = cos, -sin, -sin
    poses[:, 1, 1], poses[:, 2, 2] = -cos, -1
    poses[:, :3, 3] = np.stack([0.5 + 0 * u, -0.3 + 0.6 * u, 0.3 + 0 * u], axis=1)
    return mp.CartesianPath.through(poses)


path = line(7.0)
refused = mp.follow(robot, path, throw=False)
print(*refused.message.split("; "), sep="\n")
assert "limit of panda_joint7" in refused.message

# %%
# The message is about all configurations at positions along the path, not about one
# attempt. Where motions ended, positions were added between those there were, down to an
# eighth of their distance, and samples where branches of configurations meet. A gap that
# remains is therefore one of the arm and not of the samples, down to that resolution.
#
# All configurations of the arm along the path, by their last joint, which turns the tool.
# Blue: motions from the beginning of the path come there. Orange: motions lead from there
# to its end. The two overlap in s and meet nowhere: the last joint is at its limit where
# the blue ones end.

s = np.linspace(0, 1, 241)
layers = mp.sample_layers(robot, path, s, spacing=0.05)


def reached(order):
    """Which configurations a motion from the first of the positions in this order reaches."""
    found = [np.ones(len(layers.q[order[0]]), dtype=bool)]
    for a, b in pairwise(order):
        from_here, there = layers.q[a][found[-1]], layers.q[b]
        steps = np.abs(there[:, None] - from_here[None]).max(axis=2)
        near = (
            (steps < 0.2).any(axis=1)
            if len(from_here)
            else np.zeros(len(there), dtype=bool)
        )
        found.append(near)
    return dict(zip(order, found, strict=True))


onward, backward = reached(range(len(s))), reached(range(len(s) - 1, -1, -1))
figure, ax = plt.subplots(figsize=(8, 4.5), layout="constrained")
for k, q in enumerate(layers.q):
    joint, at = np.rad2deg(q[:, 6]), np.full(len(q), s[k])
    for here, color in ((onward[k], "C0"), (backward[k], "C1")):
        ax.plot(at[here], joint[here], ".", color=color, markersize=1.5)
for color, label in (("C0", "reached from the beginning"), ("C1", "lead to the end")):
    ax.plot([], [], "o", color=color, label=label)
for limit in (robot.limits.lower[6], robot.limits.upper[6]):
    ax.axhline(np.rad2deg(limit), color="k", linestyle="--", linewidth=1)
ax.set(
    xlabel="s along the path", ylabel="last joint [°]; dashed: its limits", xlim=(0, 1)
)
ax.legend(loc="upper center", ncols=2, bbox_to_anchor=(0.5, 1.12), frameon=False)
plt.show()

last = max(k for k, each in onward.items() if each.any())
first = min(k for k, each in backward.items() if each.any())
assert first < last < len(s) - 1

# %%
# The first remedy: let the tool leave the path. With one interruption it comes back to the
# same pose in another configuration. That number is proven to be the smallest, down to the
# same resolution.

parts = mp.follow(robot, path, interruptions=1)
for part in parts.report.along:
    print(f"s = {part.s_begin:.2f} to {part.s_end:.2f}, from {part.begin:.1f} s on")
assert parts.status is mp.Status.FOLLOWED_IN_PARTS and len(parts.report.along) == 2

# %%
# The second remedy: leave free what does not matter. A round tool need not turn.

round_tool = mp.PathObjective(task=mp.Task.pointing([0, 0, 1]))
free = mp.follow(robot, path, objective=round_tool)
least = free.report.min_manipulability
print(
    f"{free.status.name}: {free.trajectory.duration:.2f} s, minimum m {least:.4f} m^5"
)
assert free.status is mp.Status.FOLLOWED

# %%
# The third remedy: change the path. If the tool turns by only 2 rad, a motion follows
# it. Shifting the path, or the base of the arm, may help as well.

less = mp.follow(robot, line(2.0))
least = less.report.min_manipulability
print(
    f"{less.status.name}: {less.trajectory.duration:.2f} s, minimum m {least:.4f} m^6"
)
assert less.status is mp.Status.FOLLOWED
