"""
Pick, carry and place from poses
================================

.. image:: /pictures/pick_and_place.jpg
   :alt: A Panda carries a part past a post over a table.
   :width: 560px

*For pick and place with poses alone.*

A program of moves: the hand goes to a part on a table with a straight approach, takes
it up, carries it past a post, puts it down and goes home. Everything is given as poses:
four grasps, and where the part is to stand at the end. Each grasp needs another pose of
the hand there. The grasp and the configurations of all moves are chosen together, for
the largest minimum manipulability, and the corners between the moves are rounded.
"""

# sphinx_gallery_thumbnail_path = "pictures/pick_and_place.jpg"

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

open_hand = {"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04}
robot = mp.load_robot("panda", locked=open_hand)
scene = mp.Scene(
    [
        mp.Box(size=(0.9, 1.6, 0.04), position=(0.6, 0.0, -0.02), name="table"),
        mp.Box(size=(0.1, 0.1, 0.3), position=(0.45, 0.0, 0.15), name="post"),
        mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, 0.051), name="part"),
    ]
).allow("part", "table")


def grasps(x, y, z):
    """The hand points down, turned about the vertical by multiples of 90°."""
    poses = []
    for angle in np.arange(4) * np.pi / 2:
        c, s = np.cos(angle), np.sin(angle)
        poses.append([[c, s, 0, x], [s, -c, 0, y], [0, 0, -1, z], [0, 0, 0, 1]])
    return [np.array(pose) for pose in poses]


# %%
# Straight ways are given in the tool's frame, whose z-axis points down here: the
# approach is 10 cm along it, the retreat 10 cm back.

place = np.array([[0, -1, 0, 0.45], [1, 0, 0, -0.3], [0, 0, 1, 0.051], [0, 0, 0, 1]])
steps = [
    mp.MoveTo(grasps(0.45, 0.3, 0.09), approach=0.1),
    mp.Attach("part"),
    mp.MoveAlong([0, 0, -0.1]),
    mp.MoveTo(mp.PoseGoal(place, of="part"), approach=0.1),
    mp.Detach("part"),
    mp.MoveAlong([0, 0, -0.1]),
    mp.MoveTo("default"),
]
program = mp.sequence(robot, "default", steps, scene, blend=0.05)
assert program.passed
assert not program.stops  # the arm stops only to take the part up and put it down
assert program.duration < 4.5  # [s]
for mark in program.marks:
    print(f"{mark.begin:.2f} s  step {mark.step}: {mark.name}")
end = program.final_scene
stands = end.obstacles[end.names.index("part")].pose.homogeneous
assert np.abs(stands - place).max() < 1e-5

# %%
# The whole program: the part at its first place, in the hand, and put down. Vertical
# lines mark where steps begin; the hand closes and opens at the solid ones.

viz.draw_figure(program, plt.figure(figsize=(11.5, 6.0)))
plt.show()

# %%
# The controller gets one trajectory. The hand closes and opens at the dashed lines; at
# the blended corners the arm keeps moving.

motion = program.trajectory
t = np.linspace(0.0, motion.duration, 1500)
pose = robot.kinematics().pose(motion(t))
speed = np.linalg.norm(np.gradient(pose[:, :3, 3], t, axis=0), axis=1)
fig, (top, bottom) = plt.subplots(
    2, 1, figsize=(7.5, 5.0), sharex=True, layout="constrained"
)
top.plot(t, pose[:, 2, 3], label="height")
top.plot(t, speed, label="speed", color="C2", linewidth=1.0)
top.set(ylabel="tool [m, m/s]", ylim=(0, None))
top.legend(frameon=False)
bottom.plot(t, robot.kinematics().manipulability(motion(t)), color="C1")
bottom.set(xlabel="time [s]", ylabel="m [m⁶]", xlim=(0, t[-1]), ylim=(0, None))
for mark in program.marks:
    if mark.name in ("Attach", "Detach"):
        for ax in (top, bottom):
            ax.axvline(mark.begin, color="0.4", linestyle="--", linewidth=1.0)
        top.annotate(mark.name, (mark.begin, top.get_ylim()[1]), fontsize=8, va="top")
plt.show()
