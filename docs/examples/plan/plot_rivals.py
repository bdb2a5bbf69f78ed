"""
Ways round two posts, and their rivals
======================================

.. image:: images/sphx_glr_plot_rivals_001.png
   :alt: Paths of the tool around two posts, and the manipulability along each.

*For anyone who wants to choose among several ways around obstacles.*

Between the same two configurations, an arm can pass a post on either side and turn a
joint in either direction. Each of these ways has its own optimum. The planner looks for
several first paths and optimises one path per class. The best one is the result; the
others are its rivals.
"""

# %%
# The joints of the arm turn 4.5 rad in each direction. There are two posts, and several
# ways lead from the start to the goal.

# sphinx_gallery_thumbnail_path = "pictures/rivals.jpg"
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

arm = mp.planar_arm([1.0, 1.0, 1.0]).with_limits(lower=-4.5, upper=4.5)
posts = [(0.0, 2.3), (-1.9, 0.5)]
scene = mp.Scene(
    [
        mp.Cylinder(
            radius=0.15, length=1.0, position=(x, y, 0.0), name=f"post at {x}, {y}"
        )
        for x, y in posts
    ]
)
start, goal = [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0]

# %%
# The seeding looks for two first paths to each goal (``count=2``). ``shifts`` adds the
# goals that differ by a full turn of any joint, which are the same posture.

best = mp.optimize_path(
    arm,
    start,
    goal,
    scene,
    objective=mp.PathObjective(power=2),
    seeding=mp.Seeding(count=2, shifts="within-limits"),
    clearance=0.02,
)
print(best.certificate)
print()
print(f"{len(best.rivals)} rivals; the first of them:")
print("rank       g   length [rad]   minimum manipulability [m²]   turns of the goal")
for rank, result in enumerate([best, *best.rivals[:9]]):
    turns = np.round((result.path.goal - goal) / (2 * np.pi)).astype(int)
    figures = f"{result.length:12.2f} {result.min_manipulability:16.3f}"
    print(f"{rank:4d} {result.g:8.3f} {figures}        {turns}")
assert best.status is mp.Status.OPTIMAL and best.g < 1.47
assert len(best.rivals) >= 5 and all(rival.g >= best.g for rival in best.rivals)

# %%
# The path of the tool, and the manipulability along it. A rival can be shorter and
# still be worse, because it comes closer to a singularity.
kinematics = arm.kinematics()
s = np.linspace(0, 1, 400)
fig, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
for x, y in posts:
    left.add_patch(plt.Circle((x, y), 0.15, color="0.4"))
for rank, result in enumerate([best, *best.rivals[:4]]):
    tool = kinematics.pose(result.path(s))[:, :2, 3]
    name = f"g {result.g:.2f}, length {result.length:.1f} rad"
    style = {"linewidth": 2.5 if rank == 0 else 1.2, "color": plt.cm.viridis(rank / 5)}
    left.plot(*tool.T, **style)
    right.plot(s, kinematics.manipulability(result.path(s)), label=name, **style)
left.plot(
    *kinematics.pose(np.array([start, goal], dtype=float))[:, :2, 3].T,
    "ko",
    markersize=5,
)
left.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
left.set_title("path of the tool and the two posts", loc="left")
right.set(xlabel="s", ylabel="manipulability m [m²]", ylim=(0, None))
right.legend(fontsize=8)
plt.show()

# %%
# If the best path is not the one you want, because a cable would wind up or a post is
# too close, take a rival: it is a full result, with path and certificate. A larger
# ``count`` finds more classes and costs one more optimisation per class.
