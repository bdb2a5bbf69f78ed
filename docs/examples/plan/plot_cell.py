"""
Load a machine in a real cell
=============================

.. image:: /pictures/cell.jpg
   :alt: A Panda with a workpiece between a table, scanned crates and the housing of
         a milling machine.
   :width: 560px

*For machine tending, with obstacles from CAD and a depth camera.*

A Panda takes a workpiece from a table and puts it into a milling machine. The machine
comes from CAD as an STL file, what lies between comes from a depth camera, and the
workpiece has to be checked for collisions as soon as the arm carries it. You want a
motion that keeps 1 cm of clearance to all of them.
"""

# %%
# **The machine.** To make this page run as it stands, it first writes the STL file that
# you would export from CAD, in millimetres. The housing is one closed surface: its
# profile goes from the back of the machine along the outside to the front, through the
# door, and along the cavity to the inside of the back wall. The bed and the spindle
# in the cavity are solids of their own.

# sphinx_gallery_thumbnail_path = "pictures/cell.jpg"
import tempfile
from itertools import pairwise
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

#: Rectangles along the profile: depth y, then edges left, right, low and high [mm].
HOUSING = [
    (600, -320, 320, 0, 760),  # outside, back
    (0, -320, 320, 0, 760),  # outside, front
    (0, -230, 230, 250, 690),  # door, outside
    (30, -230, 230, 250, 690),  # door, inside
    (30, -280, 280, 220, 720),  # cavity, front
    (560, -280, 280, 220, 720),  # cavity, back
]
#: Corners, and the lower and upper end [mm]; both reach 5 mm into the housing.
BED = ([[-180, 200], [180, 200], [180, 480], [-180, 480]], 215, 290)
TURN = np.arange(24) * np.pi / 12
SPINDLE = (np.c_[35 * np.cos(TURN), 340 + 35 * np.sin(TURN)], 560, 725)


def rectangle(y, left, right, low, high):
    return [[left, y, low], [right, y, low], [right, y, high], [left, y, high]]


def prism(outline, low, high):
    return skin([[[x, y, z] for x, y in outline] for z in (low, high)])


def skin(rings):
    """Triangles of the closed surface through `rings` of corners, with a lid at each
    end."""
    triangles = []
    for ring, following in pairwise(rings):
        for k, (a, d) in enumerate(zip(ring, following, strict=True)):
            b, c = ring[k - 1], following[k - 1]
            triangles += [[a, c, b], [a, d, c]]
    for lid in (rings[0][::-1], rings[-1]):
        triangles += [[lid[0], lid[k], lid[k + 1]] for k in range(1, len(lid) - 1)]
    return triangles


def write_stl(file, triangles):
    facet = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")]
    rows = np.zeros(len(triangles), dtype=facet)
    rows["corners"] = triangles
    count = np.array([len(rows)], dtype="<u4")
    file.write_bytes(bytes(80) + count.tobytes() + rows.tobytes())


stl = Path(tempfile.mkdtemp()) / "machine.stl"
housing = skin([rectangle(*row) for row in HOUSING])
write_stl(stl, [*housing, *prism(*BED), *prism(*SPINDLE)])

# %%
# STL files state no unit, so ``scale`` gives the metres per unit of the file. Triangles
# that enclose a volume are a solid: here three of them. The wall of the housing is
# solid, its cavity is empty, and the arm can reach in through the door.

MACHINE = (0.10, 0.42, -0.20)
machine = mp.Mesh(file=stl, scale=0.001, position=MACHINE, name="machine")
for part in machine.parts():
    print(type(part.shape).__name__, "solid" if part.closed else "surface")
assert all(part.closed for part in machine.parts())

# %%
# **The scan.** A depth camera looks down at crates on a pallet. Its image is computed
# here: the depth of the nearest crate in each pixel, with noise of 2 mm, and one pixel
# in fifty without a value.

FOCAL, WIDTH, HEIGHT = 420.0, 320, 240  # [pixels]
EYE, TARGET = np.array([0.95, -0.10, 1.05]), np.array([0.60, 0.0, 0.0])
#: x, y, z of the centre, half of each edge [m], turned about z [rad].
PALLET = (0.60, -0.02, -0.185, 0.22, 0.26, 0.015, 0.0)
CRATES = [
    PALLET,
    (0.48, -0.17, -0.12, 0.07, 0.06, 0.05, 0.4),
    (0.66, -0.16, -0.11, 0.08, 0.06, 0.06, -0.2),
    (0.50, 0.02, -0.12, 0.06, 0.07, 0.05, 1.3),
    (0.68, 0.02, -0.115, 0.07, 0.08, 0.055, 0.1),
    (0.55, 0.16, -0.11, 0.09, 0.05, 0.06, -0.3),
    (0.73, 0.17, -0.12, 0.06, 0.06, 0.05, 0.7),
    (0.56, -0.08, -0.025, 0.07, 0.06, 0.045, 0.9),
    (0.62, 0.08, -0.015, 0.06, 0.06, 0.045, -0.5),
]


def camera_pose(eye, target):
    """The camera looks along z; x points right and y down in the image."""
    z = (target - eye) / np.linalg.norm(target - eye)
    x = np.cross(z, [0.0, 0.0, 1.0]) / np.hypot(*z[:2])
    pose = np.eye(4)
    pose[:3] = np.c_[x, np.cross(z, x), z, eye]
    return pose


def depth_image(camera, boxes):
    """Depth (h, w) of the nearest of `boxes` in each pixel [m]; inf where there is
    none."""
    u, v = np.meshgrid(np.arange(WIDTH) - WIDTH / 2, np.arange(HEIGHT) - HEIGHT / 2)
    rays = np.stack([u / FOCAL, v / FOCAL, np.ones_like(u)], axis=-1)
    image = np.full(u.shape, np.inf)
    for *numbers, angle in boxes:
        centre, half = np.reshape(numbers, (2, 3))
        c, s = np.cos(angle), np.sin(angle)
        turned = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ camera[:3]
        from_box = turned[:, 3] - [
            c * centre[0] + s * centre[1],
            c * centre[1] - s * centre[0],
            centre[2],
        ]
        along = rays @ turned[:, :3].T
        ends = np.sort([(-half - from_box) / along, (half - from_box) / along], axis=0)
        near, far = ends[0].max(axis=-1), ends[1].min(axis=-1)
        image = np.where(near < far, np.minimum(image, near), image)
    return image


camera = camera_pose(EYE, TARGET)
rng = np.random.default_rng(7)
image = depth_image(camera, CRATES)
image += rng.normal(scale=0.002, size=image.shape)
image[rng.random(image.shape) < 0.02] = 0.0

# %%
# ``from_depth`` makes points of all valid pixels. Each counts as a ball of ``radius``.
# Neighbouring pixels see points 3 mm apart, and the noise reaches 3 × 2 mm, so 8 mm
# leave no gap. ``spacing`` thins the points to one per cube of 1.5 cm. It enlarges
# the balls so that they cover all that was covered: the plan is faster, and the scan
# appears up to 26 mm thicker. Space that the camera cannot see counts as free.

scan = mp.PointCloud.from_depth(
    image,
    (FOCAL, FOCAL, WIDTH / 2, HEIGHT / 2),
    radius=0.008,
    pose=camera,
    spacing=0.015,
    name="scan",
)
print(f"{len(scan.points)} points, {len(scan.kept)} kept")
print(f"each a ball of {1e3 * scan.parts()[0].radius:.1f} mm")
assert len(scan.points) >= 20_000

# %%
# **The cell.** As long as the workpiece stands on the table, it is an obstacle like all
# others. The fingers are opened to its width.

table = mp.Box(size=(0.5, 0.5, 0.04), position=(0.30, -0.67, 0.08), name="table")
workpiece = mp.Box(
    size=(0.05, 0.05, 0.12), position=(0.30, -0.45, 0.16), name="workpiece"
)
floor = mp.Plane(position=(0.0, 0.0, -0.20), name="floor")
cell = mp.Scene([machine, scan, table, floor, workpiece])
open_fingers = {"panda_finger_joint1": 0.026, "panda_finger_joint2": 0.026}
robot = mp.load_robot("panda", locked=open_fingers)

# %%
# At the grasp the hand comes from 35° above the horizontal. From then on the workpiece
# belongs to the arm: it is taken out of the scene and attached, posed in the tool
# frame. It touches the table at the start: for the lift, this pair is allowed.

TILT = np.deg2rad(35)


def hand_pose(position, heading):
    """The hand points along `heading` [rad] and down by TILT."""
    ahead = np.array([np.cos(heading), np.sin(heading), 0.0])
    approach = np.cos(TILT) * ahead - np.sin(TILT) * np.array([0.0, 0.0, 1.0])
    across = np.array([-ahead[1], ahead[0], 0.0])
    pose = np.eye(4)
    pose[:3] = np.c_[np.cross(across, approach), across, approach, position]
    return pose


pick = hand_pose((0.30, -0.45, 0.18), -np.pi / 2)
carrying = robot.attach(workpiece.at(np.linalg.inv(pick)))
free = cell.without("workpiece")
lifting = free.allow("workpiece", "table")

# %%
# An allowed pair is not checked anywhere on a path. So it is allowed for the first
# 2 cm only, straight up. After them the motion into the machine is planned with all
# pairs. It ends 2 cm above the bed, because it keeps 1 cm to the machine; the last
# 2 cm are a straight motion again, like the first. Planning takes about 10 s.

UP = np.array([0.0, 0.0, 0.02])
bed = np.array(MACHINE) + 1e-3 * np.array([0.0, 300.0, BED[2]])
lifted = hand_pose(pick[:3, 3] + UP, -np.pi / 2)
place = hand_pose(bed + 5 * UP, np.pi / 2)  # the hand is 8 cm above the part's foot
clearance = 0.01
kinematics = robot.kinematics()


def free_configurations(scene, pose):
    q = mp.inverse_kinematics(robot, pose, samples=180).q
    return q[(scene.distances(carrying, q) > clearance).all(axis=1)]


def nearest(configurations, q):
    return configurations[np.linalg.norm(configurations - q, axis=1).argmin()]


starts, goals = free_configurations(free, lifted), free_configurations(free, place)
start = starts[kinematics.manipulability(starts).argmax()]
m = kinematics.manipulability(goals)
goal = nearest(goals[m > 0.7 * m.max()], start)
grasp = nearest(free_configurations(lifting, pick), start)

plan = mp.plan(carrying, start, goal, free, clearance=clearance)
print(plan.report.status.name.lower())
print(f"proven clearance {1e3 * plan.report.proven_clearance:.1f} mm")
assert plan.status is mp.Status.OPTIMAL
assert plan.report.proven_clearance > clearance - 1e-4
assert not plan.report.straight_free  # the straight line in joint space collides

# %%
# There is nothing to optimise in 2 cm: the lift is a straight line between two
# neighbouring configurations, proven and timed. Does the workpiece leave the table at
# once? The pair was allowed, so this is asked of the scene in which it is not.

line = mp.JointPath.line(grasp, start)
assert lifting.path_clearance(carrying, line, clearance=clearance).proven
lift = mp.retime(line, carrying)
q = lift(np.linspace(0.0, lift.duration, 50))
pairs = free.collision_model(carrying).pair_names
column = pairs.index(("workpiece", "table"))
rising = free.distances(carrying, q)[:, column]
print(f"from {1e3 * abs(rising[0]):.1f} to {1e3 * rising[-1]:.1f} mm above the table")
assert rising.min() > -1e-4

# %%
# The scan is drawn as what is checked: points with their balls. The tool path leaves the
# table, passes beside the crates and enters through the door.

figure = plt.figure(figsize=(8.5, 6.0), layout="constrained")
ax = viz.plot_arm(
    carrying, plan.path, free, places=6, ax=figure.add_subplot(projection="3d")
)
ax.view_init(elev=28, azim=-64)
sides = [np.ptp(limits) for limits in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())]
ax.set_box_aspect(sides, zoom=1.08)

# %%
# The smallest distance of the arm with its part to each obstacle. The dotted line is
# the clearance. Inside the machine the distance is about 1 cm and not negative, since
# the cavity is not solid.

t = np.linspace(0.0, plan.trajectory.duration, 300)
q = plan.trajectory(t)
distances = free.distances(carrying, q)
fig, ax = plt.subplots(figsize=(7, 2.8), layout="constrained")
for name, colour in (("machine", "#D55E00"), ("scan", "#009E73"), ("table", "#0072B2")):
    columns = [k for k, (_, other) in enumerate(pairs) if other.split(".")[0] == name]
    ax.plot(t, 1e3 * distances[:, columns].min(axis=1), color=colour, label=name)
ax.axhline(1e3 * clearance, color="0.4", linestyle=":")
ax.set(xlabel="time [s]", ylabel="distance [mm]", xlim=(0, t[-1]), ylim=(0, 420))
ax.legend(ncols=3, loc="upper right", frameon=False)
plt.show()

# %%
# What to know before you use your own files:
#
# - A mesh that is not closed, such as one with a missing triangle, is a surface: a body
#   that is inside it and touches no triangle counts as free. Check
#   ``all(part.closed for part in machine.parts())``, as above.
# - ``fill="hull"`` of a mesh fills its cavity: nothing could reach in here.
# - The arm itself has to be cut out of a scan first, and so has the workpiece: the
#   library does not know which points are theirs.
# - A carried mesh that is not convex is checked as convex pieces. ``robot.detach`` takes it off again.
