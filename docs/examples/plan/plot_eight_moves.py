"""
A program of eight moves
========================

.. image:: /pictures/eight_moves.jpg
   :alt: A Panda carries a part over the wall of a tray.
   :width: 560px

*For whole programs of a cell: grasp, carry, place, and a seam at constant speed.*

A Panda takes a part from a table, carries it upright over the wall of a tray, puts it
down there, and then draws a bead along a seam at a constant speed before it goes home.
The eight moves are planned together.
"""

# sphinx_gallery_thumbnail_path = "pictures/eight_moves.jpg"

import matplotlib.pyplot as plt
import numpy as np
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan import viz

open_hand = {"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04}
robot = mp.load_robot("panda", locked=open_hand)
tray = np.array([0.45, -0.35, 0.0])
walls = [
    mp.Box(size=(0.3, 0.01, 0.08), position=tray + np.array([0.0, y, 0.04]), name=name)
    for name, y in (("near wall", 0.15), ("far wall", -0.15))
]
scene = mp.Scene(
    [
        mp.Box(size=(0.9, 1.6, 0.04), position=(0.6, 0.0, -0.02), name="table"),
        mp.Box(size=(0.04, 0.04, 0.1), position=(0.4, 0.4, 0.051), name="part"),
        *walls,
    ]
).allow("part", "table")

# %%
# There are sixteen grasps: from above and tilted by 30°, from eight sides each. The goal
# of the carried part is a pose of the part, so the hand arrives tilted as it grasped. On
# the way the hand has to stay within 15° of straight down, which rules out the tilted
# grasps.


def hand_at(x, y, z, turn=0.0, tilt=0.0, away=0.0):
    """The hand points at a place from a distance, turned and tilted [rad]."""
    pose = np.eye(4)
    pose[:3, :3] = Rotation.from_euler("ZX", [turn, np.pi - tilt]).as_matrix()
    pose[:3, 3] = np.array([x, y, z]) - away * pose[:3, 2]
    return pose


turns = np.arange(8) * np.pi / 4
grasps = [hand_at(0.4, 0.4, 0.06, a, b, away=0.03) for a in turns for b in (0.0, 0.5)]
look = [hand_at(0.4, 0.4, 0.35, turn) for turn in turns]
place = np.eye(4)
place[:3, 3] = tray + np.array([0.0, 0.0, 0.051])
seam = mp.CartesianPath.line(hand_at(0.45, -0.1, 0.25), hand_at(0.45, 0.2, 0.25))
upright = mp.TiltLimit(axis=[0, 0, 1], direction=[0, 0, -1], angle=np.deg2rad(15))

steps = [
    mp.MoveTo(look),
    mp.MoveTo(grasps, approach=0.08),
    mp.Attach("part"),
    mp.MoveAlong([0, 0, -0.12]),
    mp.MoveTo(mp.PoseGoal(place, of="part"), approach=0.12, constraints=[upright]),
    mp.Detach("part"),
    mp.MoveAlong([0, 0, -0.12]),
    mp.MoveTo(hand_at(0.45, -0.1, 0.35)),
    mp.MoveAlong(seam, tool_speed=0.15),
    mp.MoveTo("default"),
]
program = mp.sequence(robot, "default", steps, scene, blend=0.05)
assert program.passed and not program.stops
assert program.min_manipulability > 0.0099  # [m^6], that of the start
print("\n".join(str(program).splitlines()[:15]))

# %%
# The program uses one of the eight grasps from above: only these keep the part upright.

print(
    f"grasp {program.goals[1]} of {len(grasps)}, the first look from {program.goals[0]}"
)
assert program.goals[1] % 2 == 0

# %%
# The arm with the part at its first place, on the way and in the tray; manipulability
# and joints over time. Vertical lines mark where steps begin.

viz.draw_figure(program, plt.figure(figsize=(11.5, 6.0)))
plt.show()

# %%
# The speed of the tool, which is constant along the seam between its ramps.

told = program.marks[8].tool_speed
assert told is not None and told.is_steady
print(told)
t = np.linspace(0.0, program.duration, 3000)
way = robot.kinematics().pose(program.trajectory(t))[:, :3, 3]
speed = np.linalg.norm(np.gradient(way, t, axis=0), axis=1)
fig, ax = plt.subplots(figsize=(7.5, 3.0), layout="constrained")
ax.plot(t, speed)
ax.axvspan(told.begin, told.end, color="C2", alpha=0.15, linewidth=0, label="seam")
ax.set(xlabel="time [s]", ylabel="speed of the tool [m/s]", xlim=(0, t[-1]))
ax.set_ylim(0, None)
ax.legend(frameon=False)
plt.show()
