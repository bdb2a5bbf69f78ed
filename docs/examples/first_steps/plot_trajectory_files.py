"""
Trajectories in and out of files
================================

.. image:: /pictures/trajectory_files.jpg
   :alt: A UR5 and the way of its tool from the start to the goal.
   :width: 560px

*For anyone who passes motions to a controller, a spreadsheet or another program.*

Motions are exchanged in files: a recording as CSV, ROS messages for a controller, a
NumPy archive for a script. This page writes one trajectory in each format, reads it
back, and shows the error messages for broken files.
"""

# sphinx_gallery_thumbnail_path = "pictures/trajectory_files.jpg"

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("ur5")
path = mp.JointPath.line(
    [0.0, -1.4, 1.4, -1.6, -1.5, 0.0], [1.2, -1.0, 0.9, -1.2, -1.3, 0.6]
)
trajectory = mp.retime(path, robot)
print(
    f"{trajectory.duration:.3f} s, {len(trajectory.t)} samples of {trajectory.n} joints"
)

# %%
# There are four formats: CSV for people and spreadsheets, JSON for programs, YAML with
# a ROS 2 ``trajectory_msgs/JointTrajectory`` message, and a NumPy archive. Each stores
# times, positions and velocities with all digits.

folder = Path(tempfile.mkdtemp())
formats = {
    "csv": "motion.csv",
    "json": "motion.json",
    "ros": "motion.yaml",
    "npz": "motion.npz",
}
for name, file in formats.items():
    getattr(trajectory, f"to_{name}")(folder / file)
    back = getattr(mp.Trajectory, f"from_{name}")(folder / file)
    error = max(
        np.abs(back.t - trajectory.t).max(),
        np.abs(back.q - trajectory.q).max(),
        np.abs(back.qd - trajectory.qd).max(),
    )
    print(
        f"{file:12s} {(folder / file).stat().st_size:7d} bytes, largest difference "
        f"after reading {error:.1e}"
    )
    assert error < 1e-9 and back.joint_names == trajectory.joint_names

# %%
# The first lines of the CSV and of the ROS message.

print(
    "\n".join(
        line[:110] + " ..."
        for line in (folder / "motion.csv").read_text().splitlines()[:3]
    )
)
print()
print(
    "\n".join(
        line[:110] for line in (folder / "motion.yaml").read_text().splitlines()[:16]
    )
)

# %%
# Between the samples, the motion is the cubic spline through the positions and
# velocities. This is what a joint trajectory controller executes, so a file gives the
# same motion as the object at any time. ``order`` selects the derivative.

read = mp.Trajectory.from_csv(folder / "motion.csv")
t = np.linspace(0, read.duration, 400)
figure, panels = plt.subplots(1, 3, figsize=(11, 3.2), layout="constrained")
labels = ("position [rad]", "velocity [rad/s]", "acceleration [rad/s²]")
for order, (ax, label) in enumerate(zip(panels, labels, strict=True)):
    for values, name in zip(read(t, order).T, read.joint_names, strict=True):
        ax.plot(t, values, label=name.removesuffix("_joint"))
    ax.set(xlabel="time [s]", ylabel=label, xlim=(0, read.duration))
panels[0].legend(frameon=False, fontsize=7)
plt.show()

# %%
# **A recording** with only times and positions can be read, too. Its velocities are
# those of the spline through the samples. Here the motion is sampled at 50 Hz and read
# again.

t = np.arange(0, trajectory.duration, 0.02)
header = ",".join(["time", *(f"q_{name}" for name in robot.joint_names)])
np.savetxt(
    folder / "recorded.csv",
    np.column_stack([t, trajectory(t)]),
    delimiter=",",
    header=header,
    comments="",
)
recorded = mp.Trajectory.from_csv(folder / "recorded.csv")
between = np.linspace(0, recorded.duration, 999)
print(
    "largest error between the samples: "
    f"{1e3 * np.abs(recorded(between) - trajectory(between)).max():.1f} mrad"
)
assert np.abs(recorded(between) - trajectory(between)).max() < 5e-4

# %%
# **A broken file** is rejected, and the message says what is expected.

(folder / "broken.csv").write_text("t,joint_1,joint_2\n0,0.1,0.2\n1,0.3,0.4\n")
(folder / "newer.json").write_text('{"format": "manipplan-trajectory", "version": 99}')
for read_it, file in (
    (mp.Trajectory.from_csv, "broken.csv"),
    (mp.Trajectory.from_json, "newer.json"),
):
    try:
        read_it(folder / file)
    except mp.errors.FileFormatError as error:
        print(str(error).replace(f"{folder}/", ""))
