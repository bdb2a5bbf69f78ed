"""
Improve a recorded path
=======================

Somebody has led the arm by hand, or a planner of another kind has made a motion,
and you have it as a CSV file: times and joint angles. The tool's way is what you
want; how the elbow moved meanwhile is chance. ``mp.improve`` follows the recorded
poses inside a tolerance and uses what the arm has to spare to stay farther from
singularities.
"""

# %%
# The recording of this page is made up: a Panda's hand is led along an arc near the
# edge of its reach, sampled at 50 Hz with the noise of a hand. Yours has the same
# columns: ``time`` [s], then ``q_<joint>`` [rad].

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
# One call. The tube is 2 cm and 0.2 rad wide; the recording is slowed down first if
# it is faster than the arm's limits allow.

tube = mp.Tolerance(position=0.02, rotation=0.2)
plan = mp.improve(robot, file, tolerance=tube)
print(plan.report)
assert plan.status.ok

# %%
# Before and after. The upper picture is the index, the middle one how far the tool
# is from the recorded poses, and the lower one which joints move otherwise. A step
# knows the tool's motion to first order, so that the wall of the tube is kept to
# some micrometres.

recorded = mp.Trajectory.from_csv(file)
index = robot.kinematics().manipulability
tracking = plan.tracking
before = index(recorded(np.linspace(0, recorded.duration, 400)))
after = index(plan.trajectory(np.linspace(0, plan.trajectory.duration, 400)))
print(
    f"minimum manipulability: {before.min():.4f} -> {after.min():.4f} m^6;  mean: "
    f"{before.mean():.4f} -> {after.mean():.4f} m^6"
)
print(
    f"largest deviation: {1e3 * tracking.deviation.max():.3f} mm; the tube: "
    f"{1e3 * tube.position:.0f} mm"
)
assert after.min() > before.min() and after.mean() > before.mean()
assert tracking.deviation.max() <= tube.position * 1.001

share = np.linspace(0, 1, 400)
figure, (top, middle, bottom) = plt.subplots(
    3, 1, figsize=(7.5, 7), sharex=True, layout="constrained"
)
top.plot(share, before, color="#E69F00", label="recorded")
top.plot(share, after, color="#0072B2", label="improved")
top.set(ylabel="index [m⁶]", ylim=(0, 1.15 * after.max()), xlim=(0, 1))
top.legend(frameon=False)
middle.plot(tracking.t / tracking.t[-1], 1e3 * tracking.deviation, color="#0072B2")
middle.axhline(1e3 * tube.position, color="0.4", linestyle=":", label="tolerance")
middle.set(ylabel="deviation [mm]", ylim=(0, None))
middle.legend(frameon=False, loc="lower center")
change = plan.trajectory(share * plan.trajectory.duration) - recorded(
    share * recorded.duration
)
for joint in np.argsort(-np.abs(change).max(axis=0)):
    bottom.plot(
        share, change[:, joint], label=robot.joint_names[joint].removeprefix("panda_")
    )
low, high = bottom.get_ylim()
bottom.set(ylim=(low - 0.35 * (high - low), high))  # room for the legend
bottom.set(xlabel="share of the time", ylabel="change of joint [rad]")
bottom.legend(frameon=False, ncols=4, fontsize=8, loc="lower center")
plt.show()

# %%
# The result goes back to a file that a controller reads:
# ``plan.trajectory.to_csv``, ``to_json``, ``to_ros``.
#
# What to do when it fails: *NOT_BETTER* says that the tube leaves nothing to gain,
# so allow more tolerance, or a task with fewer rows (``task=mp.Task.position()`` if
# the orientation was chance, too). *NOT_FOLLOWED* says that the limits do not let
# the arm stay in the tube: allow more time (``duration=``) or more tolerance.
