"""
Improve a recorded path
=======================

.. image:: /pictures/improve_recording.jpg
   :alt: A Panda on an arc; the recorded way in yellow, the improved one in blue.
   :width: 560px

*For recorded or hand-guided motions.*

Someone has guided the arm by hand, or another planner has made a motion, and you have
it as a CSV file with times and joint angles. You want to keep the path of the tool and
the time; how the elbow moved is arbitrary, and the noise should go. ``mp.improve``
stays inside a tolerance of the recorded poses and uses the rest of the arm's freedom
to stay farther from singularities.
"""

# %%
# The recording of this page is synthetic: a Panda's hand is guided along an arc near
# the edge of its reach, sampled at 50 Hz, with noise as from a human hand. Your file
# has the same columns: ``time`` [s] and ``q_<joint>`` [rad], in any order.

# sphinx_gallery_thumbnail_path = "pictures/improve_recording.jpg"
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
rng = np.random.default_rng(1)
t = np.linspace(0.0, 8.0, 401)
u = t / t[-1]
u = u**2 * (3 - 2 * u)
begin = np.array([-0.9, 0.55, 0.0, -1.45, 0.0, 2.0, 0.785])
end = np.array([0.9, 0.75, 0.1, -1.05, 0.1, 1.8, 0.9])
bow = np.array([0.0, 0.12, 0.0, 0.25, 0.0, 0.0, 0.0])
noise = np.cumsum(rng.normal(0.0, 2e-4, (len(t), robot.n)), axis=0)
q = begin + np.outer(u, end - begin) + np.outer(4 * u * (1 - u), bow) + noise
file = Path(tempfile.mkdtemp()) / "demonstration.csv"
header = ",".join(["time", *(f"q_{name}" for name in robot.joint_names)])
np.savetxt(file, np.column_stack([t, q]), delimiter=",", header=header, comments="")
print(file.read_text()[:220], "...")

# %%
# One call improves the recording. The tolerance is 2 cm and 0.2 rad; the duration
# stays 8 s. The end of the report has both motions side by side.

tube = mp.Tolerance(position=0.02, rotation=0.2)
plan = mp.improve(robot, file, tolerance=tube)
print(plan.report)
assert plan.status is mp.Status.IMPROVED
assert plan.report.min_manipulability > 0.0090  # [m^6]; 0.0078 as recorded

# %%
# Before and after. Top: manipulability. Middle: deviation of the tool from the recorded
# poses. Bottom: change of each joint.

recorded = mp.Trajectory.from_csv(file)
kinematics = robot.kinematics()
share = np.linspace(0, 1, 400)
first = recorded(share * recorded.duration)
second = plan.trajectory(share * plan.trajectory.duration)
before, after = kinematics.manipulability(first), kinematics.manipulability(second)
apart = np.linalg.norm(kinematics.pose(first) - kinematics.pose(second), axis=1)[:, 3]
assert plan.trajectory.duration == recorded.duration
assert after.min() >= before.min() and after.mean() > before.mean()
assert apart.max() <= tube.position

figure, (top, middle, bottom) = plt.subplots(
    3, 1, figsize=(7.5, 7), sharex=True, layout="constrained"
)
top.plot(share, before, color="#E69F00", label="recorded")
top.plot(share, after, color="#0072B2", label="improved")
top.set(ylabel="manipulability [m⁶]", ylim=(0, 1.15 * after.max()), xlim=(0, 1))
top.legend(frameon=False)
middle.plot(share, 1e3 * apart, color="#0072B2")
middle.axhline(1e3 * tube.position, color="0.4", linestyle=":", label="tolerance")
middle.set(ylabel="deviation [mm]", ylim=(0, None))
middle.legend(frameon=False, loc="lower center")
change = second - first
for joint in np.argsort(-np.abs(change).max(axis=0)):
    bottom.plot(
        share, change[:, joint], label=robot.joint_names[joint].removeprefix("panda_")
    )
low, high = bottom.get_ylim()
bottom.set(ylim=(low - 0.35 * (high - low), high))  # room for the legend
bottom.set(xlabel="share of the duration", ylabel="change of joint [rad]")
bottom.legend(frameon=False, ncols=4, fontsize=8, loc="lower center")
plt.show()

# %%
# Write the result to a file for a controller with ``plan.trajectory.to_csv``,
# ``to_json`` or ``to_ros``.
#
# *NOT_BETTER* means that nothing can be gained inside the tolerance, so allow more
# tolerance, or a task with fewer rows
# (``objective=mp.PathObjective(task=mp.Task.position())`` if the orientation is
# arbitrary, too). A duration that the limits do not allow is refused with the shortest
# one that they do.
