"""
Load my own URDF
================

.. image:: /pictures/own_robot.jpg
   :alt: A grey arm of six cylinders beside a post; the way of its torch in blue,
         the planner's in yellow.
   :width: 560px

*For users of an arm that is not in the catalogue.*

You have the URDF of an arm, and perhaps the SRDF that MoveIt's setup assistant wrote,
and you want to plan with it. This page writes the URDF of a small arm with six joints,
loads it, explains the table that is printed, plans a motion, and shows the most common
errors.
"""

# %%
# The arm has six revolute joints, links made of cylinders (no mesh files), and a frame
# ``torch`` 12 cm beyond the last joint. A manufacturer's URDF has the same structure
# but is longer.

# sphinx_gallery_thumbnail_path = "pictures/own_robot.jpg"
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

# name, parent, child, origin of the joint, axis, lower, upper, velocity, effort
JOINTS = [
    ("turn", "base", "column", "0 0 0.15", "0 0 1", -3.0, 3.0, 2.0, 120.0),
    ("shoulder", "column", "upper", "0 0 0.20", "0 1 0", -2.0, 2.0, 2.0, 120.0),
    ("elbow", "upper", "fore", "0 0 0.45", "0 1 0", -2.6, 2.6, 2.5, 80.0),
    ("roll", "fore", "wrist", "0 0 0.20", "0 0 1", -3.1, 3.1, 3.0, 30.0),
    ("pitch", "wrist", "hand", "0 0 0.20", "0 1 0", -2.2, 2.2, 3.0, 30.0),
    ("twist", "hand", "flange", "0 0 0.08", "0 0 1", -6.2, 6.2, 3.0, 20.0),
]
SHAPES = {  # link: length and radius of a cylinder along z [m], mass [kg]
    "base": (0.15, 0.09, 5.0),
    "column": (0.20, 0.07, 4.0),
    "upper": (0.45, 0.055, 3.5),
    "fore": (0.20, 0.05, 2.0),
    "wrist": (0.20, 0.045, 1.5),
    "hand": (0.08, 0.04, 0.8),
    "flange": (0.04, 0.035, 0.3),
}


def link(name, length, radius, mass):
    side, spin = mass * (3 * radius**2 + length**2) / 12, mass * radius**2 / 2
    return f"""
  <link name="{name}">
    <inertial><origin xyz="0 0 {length / 2}"/><mass value="{mass}"/>
      <inertia ixx="{side}" iyy="{side}" izz="{spin}" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <collision><origin xyz="0 0 {length / 2}"/>
      <geometry><cylinder length="{length}" radius="{radius}"/></geometry></collision>
  </link>"""


def joint(name, parent, child, origin, axis, lower, upper, velocity, effort):
    return f"""
  <joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/>
    <origin xyz="{origin}"/><axis xyz="{axis}"/>
    <limit lower="{lower}" upper="{upper}" velocity="{velocity}" effort="{effort}"/>
  </joint>"""


torch = """
  <link name="torch"/>
  <joint name="torch_mount" type="fixed">
    <parent link="flange"/><child link="torch"/><origin xyz="0 0 0.12"/></joint>"""
text = (
    "".join(link(name, *shape) for name, shape in SHAPES.items())
    + "".join(joint(*row) for row in JOINTS)
    + torch
)
folder = Path(tempfile.mkdtemp())
urdf = folder / "welder.urdf"
urdf.write_text(f'<robot name="welder">{text}\n</robot>\n')

# %%
# The SRDF lists the pairs of links that need no collision check. Pairs of neighbouring
# links are left out automatically. The base and the upper arm cannot collide either, at
# any shoulder angle. Leaving out this pair saves one distance computation in every
# check.

srdf = folder / "welder.srdf"
srdf.write_text("""<robot name="welder">
  <disable_collisions link1="base" link2="upper" reason="Never"/>
</robot>
""")
robot = mp.Robot.from_urdf(urdf, tool="torch", srdf=srdf)
print(robot)

# %%
# The last lines of the table say where each number comes from. A URDF has no
# acceleration limits, so the default lets each joint reach full speed in 0.2 s, and
# there is no jerk limit. Pass the values of the data sheet instead. A single number
# applies to all joints.

robot = mp.Robot.from_urdf(
    urdf, tool="torch", srdf=srdf, acceleration=[6, 6, 8, 12, 12, 15], jerk=200.0
)
print(
    robot.limits.sources["acceleration"], robot.limits.acceleration, robot.limits.jerk
)

# %%
# Does the model match your arm? Compare one pose with the manufacturer's data. Here all
# joints are at zero and the arm stands upright, so the height of the tool is the sum of
# the offsets.

height = robot.kinematics().pose(np.zeros(6))[2, 3]
print(f"height of the torch: {height:.3f} m")
assert np.isclose(height, 0.15 + 0.20 + 0.45 + 0.20 + 0.20 + 0.08 + 0.12)

# %%
# Plan a motion past a post. The figure shows the arm from its start (light) to its goal
# (dark).

start, goal = [-1.2, 0.5, 1.0, 0.2, 0.9, 0.0], [1.2, 0.6, 1.2, -0.4, 0.7, 0.5]
scene = mp.Scene(
    [
        mp.Box(size=(0.08, 0.08, 0.7), position=(0.55, 0.0, 0.35), name="post"),
        mp.Plane(position=(0.0, 0.0, -0.001), name="floor"),
    ]
)
plan = mp.plan(robot, start, goal, scene, clearance=0.01)
print(plan.report)
assert plan.status is mp.Status.OPTIMAL
assert plan.report.g < 255 and plan.report.proven_clearance > 0.0099
_ = viz.draw_figure(plan, plt.figure(figsize=(11.5, 6.0)))

# %%
# The most common errors. Each message names the argument, the value that was given, and
# the values that are allowed.


def attempt(what, call):
    try:
        call()
    except mp.errors.ManipplanError as error:
        message = str(error).replace(f"{folder}/", "")
        print(f"{what}:\n  {type(error).__name__}: {message}\n")


attempt("a frame that does not exist", lambda: mp.Robot.from_urdf(urdf, tool="tourch"))
attempt(
    "a misspelt joint",
    lambda: mp.Robot.from_urdf(urdf, tool="torch", joints=["turn", "sholder"]),
)
attempt(
    "a file that does not exist", lambda: mp.Robot.from_urdf(folder / "welder.udrf")
)
attempt(
    "a start outside the limits", lambda: mp.plan(robot, [4.0, 0, 0, 0, 0, 0], goal)
)
attempt(
    "degrees instead of radians",
    lambda: mp.plan(robot, start, [69, 34, 69, -23, 40, 29]),
)
attempt(
    "one limit too few",
    lambda: mp.Robot.from_urdf(urdf, tool="torch", acceleration=[6, 6, 8, 12, 12]),
)
