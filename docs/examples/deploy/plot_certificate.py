"""
Do not believe us: check a plan with Pinocchio alone
====================================================

.. image:: /pictures/certificate.jpg
   :alt: A Panda reaches round a post on a table.
   :width: 560px

*For those who approve a motion before it runs.*

A plan comes with a report and a certificate. Before you run the plan on a robot, you
may want to check both with independent tools. This page prints both, then computes the
numbers again from the exported file, with NumPy, Pinocchio and its collision library
coal.
"""

# %%
# Plan a motion among a few boxes and save the plan.

# sphinx_gallery_thumbnail_path = "pictures/certificate.jpg"
import json
import tempfile
from pathlib import Path

import coal
import matplotlib.pyplot as plt
import numpy as np
import pinocchio as pin

import manipplan as mp

robot = mp.load_robot("panda")
scene = mp.Scene(
    [
        mp.Box(size=(0.9, 1.4, 0.05), position=(0.5, 0.0, -0.03), name="table"),
        mp.Box(size=(0.12, 0.12, 0.5), position=(0.5, 0.0, 0.25), name="post"),
    ]
)
start, goal = (
    [-0.5, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8],
    [0.7, 0.4, 0.1, -1.8, 0.1, 2.2, 0.9],
)
plan = mp.plan(robot, start, goal, scene, clearance=0.01, torque=True)
folder = Path(tempfile.mkdtemp())
assert plan.status is mp.Status.OPTIMAL and plan.report.g < 125
print("files:", ", ".join(file.name for file in plan.save(folder)))

# %%
# The **report** is measured on the finished trajectory. The **certificate** describes
# the path: how it was found, whether the first-order conditions of a local optimum
# hold, g, the minimum distance that is *proven* for the whole curve, and the limits that the
# path comes closest to. An optimal path among obstacles runs at the clearance: here 10
# mm, plus the 0.05 mm that the optimiser adds so that the proof succeeds.

print(plan.report)
print()
print(plan.result.certificate)

# %%
# **Now without manipplan.** The inputs are the CSV file, the report's JSON file, and
# the model of the arm. Between the samples, the motion is the cubic spline through the
# positions and velocities, which is what a joint trajectory controller executes.

table = np.genfromtxt(folder / "trajectory.csv", delimiter=",", names=True)
report = json.loads((folder / "report.json").read_text())
names = [name.removeprefix("q_") for name in table.dtype.names if name.startswith("q_")]
t = table["time"]
q, qd = (
    np.column_stack([table[f"{kind}_{name}"] for name in names]) for kind in ("q", "qd")
)

h = np.diff(t)[:, None, None]
u = np.linspace(0, 1, 20)[None, :, None]
a, b, va, vb = q[:-1, None], q[1:, None], qd[:-1, None] * h, qd[1:, None] * h
position = (
    a + va * u + (3 * (b - a) - 2 * va - vb) * u**2 + (2 * (a - b) + va + vb) * u**3
)
velocity = (
    va + 2 * (3 * (b - a) - 2 * va - vb) * u + 3 * (2 * (a - b) + va + vb) * u**2
) / h
acceleration = (
    2 * (3 * (b - a) - 2 * va - vb) + 6 * (2 * (a - b) + va + vb) * u
) / h**2
Q, V, A = (x.reshape(-1, len(names)) for x in (position, velocity, acceleration))

model = robot.model  # a pinocchio.Model: the URDF with the fingers locked
data = model.createData()
tool = model.getFrameId(robot.tool)
length = 0.5  # [m] weight of rotation against translation, as in the report
weights = np.array([1, 1, 1, length, length, length])[:, None]


def manipulability(x):
    J = weights * pin.computeFrameJacobian(
        model, data, x, tool, pin.LOCAL_WORLD_ALIGNED
    )
    return np.sqrt(np.linalg.det(J @ J.T))


m = np.array([manipulability(x) for x in Q])
torque = np.array([pin.rnea(model, data, *row) for row in zip(Q, V, A, strict=True)])
g = (np.linalg.norm(np.diff(Q, axis=0), axis=1) * (1 / m[1:] + 1 / m[:-1]) / 2).sum()
checks = {
    "minimum manipulability [m^6]": (m.min(), report["min_manipulability"]),
    "g": (g, report["g"]),
    "duration [s]": (t[-1] - t[0], report["duration"]),
    "largest share of velocity": (
        (np.abs(V) / model.velocityLimit).max(),
        report["limits"]["velocity"]["ratio"],
    ),
    "largest share of acceleration": (
        (np.abs(A) / robot.limits.acceleration).max(),
        report["limits"]["acceleration"]["ratio"],
    ),
    "largest share of torque": (
        (np.abs(torque) / model.effortLimit).max(),
        report["limits"]["torque"]["ratio"],
    ),
}
print(f"{'figure':30s} {'Pinocchio':>12s} {'report':>12s}")
for name, (theirs, ours) in checks.items():
    print(f"{name:30s} {theirs:12.6g} {ours:12.6g}")
    assert np.isclose(theirs, ours, rtol=2e-3), name
assert (Q - model.lowerPositionLimit >= -1e-9).all() and (
    model.upperPositionLimit - Q >= -1e-9
).all()

# %%
# **The clearance** is measured with the arm's own meshes instead of the convex bodies
# that the planner checks. The meshes are inside these bodies, so the true distance is at
# least the proven one. Coal computes the distance from every mesh to the two boxes.


geometry, placed = robot.geometry, pin.GeometryData(robot.geometry)
boxes = [
    (coal.Box(0.9, 1.4, 0.05), [0.5, 0.0, -0.03]),
    (coal.Box(0.12, 0.12, 0.5), [0.5, 0.0, 0.25]),
]
moving = [i for i, part in enumerate(geometry.geometryObjects) if part.parentJoint > 1]


def mesh_distance(x):
    pin.updateGeometryPlacements(model, data, geometry, placed, x)
    least = np.inf
    for i in moving:
        for box, centre in boxes:
            request, found = coal.DistanceRequest(), coal.DistanceResult()
            place = coal.Transform3s(placed.oMg[i].rotation, placed.oMg[i].translation)
            coal.distance(
                geometry.geometryObjects[i].geometry,
                place,
                box,
                coal.Transform3s(np.eye(3), np.array(centre)),
                request,
                found,
            )
            least = min(least, found.min_distance)
    return least


some = np.linspace(0, len(Q) - 1, 60).astype(int)
mesh = np.array([mesh_distance(Q[i]) for i in some])
print(
    f"meshes to boxes {1e3 * mesh.min():.1f} mm; proven by the planner: at least "
    f"{1e3 * report['proven_clearance']:.1f} mm"
)
assert mesh.min() > report["proven_clearance"] > 0

times = (t[:-1, None] + np.diff(t)[:, None] * u[0].T).ravel()
figure, (top, bottom) = plt.subplots(
    2, 1, figsize=(7.5, 5), sharex=True, layout="constrained"
)
top.plot(times, m, color="#0072B2")
top.axhline(
    report["min_manipulability"],
    color="0.4",
    linestyle=":",
    label="minimum manipulability of the report",
)
top.set(ylabel="m by Pinocchio [m⁶]", ylim=(0, 1.15 * m.max()))
top.set(xlim=(0, times[-1]))
top.legend(frameon=False, fontsize=8)
bottom.plot(times[some], 1e3 * mesh, color="#D55E00")
bottom.axhline(
    1e3 * report["proven_clearance"],
    color="0.4",
    linestyle=":",
    label="proven clearance of the report",
)
bottom.set(xlabel="time [s]", ylabel="meshes to boxes [mm]", ylim=(0, None))
bottom.legend(frameon=False, fontsize=8)
plt.show()

# %%
# If a number disagrees, first check that the tool frame, the characteristic length and
# the payload are the same. If ``passed`` is false, the first lines of the report say
# which check failed. Such a plan is returned only with ``throw=False``.
