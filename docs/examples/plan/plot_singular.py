"""
When every path is singular
===========================

A UR5 has six joints and a pose has six numbers, so its configurations form regions, and
every motion from one region to another crosses a singularity. Then g is infinite for
every path. The planner reports this. This page shows the message, the cause, and the
remedy.
"""

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("ur5")
kinematics = robot.kinematics()
start = np.array([0.4, -1.2, 1.5, -1.8, -1.3, 0.7])
goal = np.array([1.4, -0.5, -1.3, 0.3, -1.2, 0.5])  # elbow down

# %%
# With ``throw=False`` the result is returned, and its status says what is wrong and
# what would help.

result = mp.optimize_path(robot, start, goal, throw=False)
print(result.status.name)
print(result.status.value)
print("g:", result.g)
assert result.status is mp.Status.SINGULAR and np.isinf(result.g)

# %%
# The cause: det J has different signs at start and goal, so it is zero somewhere along
# the path.

signs = {
    name: np.sign(np.linalg.det(kinematics.jacobian(q)))
    for name, q in (("start", start), ("goal", goal))
}
print({name: f"{sign:+.0f}" for name, sign in signs.items()})

# %%
# The remedy: only the pose of the tool matters, and other configurations reach it. Take
# those with the same sign as the start, and choose the one whose path has the smallest
# g. The same sign is necessary, but not sufficient: det J of this arm is a product of
# three factors, one each for shoulder, elbow and wrist, and if two of them change their
# signs, the sign of det J stays the same.

solutions = mp.inverse_kinematics(robot, kinematics.pose(goal)).q
same = np.array(
    [
        q
        for q in solutions
        if np.sign(np.linalg.det(kinematics.jacobian(q))) == signs["start"]
    ]
)
nearest = same[np.argsort(np.linalg.norm(same - start, axis=1))][:6]
print(
    f"{len(solutions)} configurations reach the goal's pose, {len(same)} of "
    "them with the same sign of det J as the start"
)
tried = [mp.optimize_path(robot, start, q, throw=False) for q in nearest]
for candidate in tried:
    print(
        f"goal {candidate.path.goal.round(2)}: {candidate.status.name}, g "
        f"{candidate.g:.1f}, length {candidate.length:.2f} rad"
    )
best = min(tried, key=lambda candidate: candidate.g)
assert np.isfinite(best.g)
assert np.allclose(kinematics.pose(best.path.goal), kinematics.pose(goal), atol=1e-9)

# %%
# det J along both paths: the first one crosses zero, the second one does not.

s = np.linspace(0, 1, 800)
fig, ax = plt.subplots(figsize=(7.5, 3.6), layout="constrained")
for name, path, colour in (
    ("goal as given", result.path, "#D55E00"),
    ("another configuration of the same pose", best.path, "#0072B2"),
):
    ax.plot(
        s,
        [np.linalg.det(J) for J in kinematics.jacobian(path(s))],
        color=colour,
        label=name,
    )
ax.axhline(0.0, color="0.3", linewidth=0.8)
ax.annotate("singular", (0.02, 0.0), xytext=(0.02, 0.0), va="bottom", fontsize=8)
ax.set(xlabel="s", ylabel="det J [m⁶]", xlim=(0, 1))
ax.legend(frameon=False)
plt.show()

# %%
# **Which limit is active?** A limit can also make a path worse. The certificate gives
# the distance of the path to each limit, and how much larger g is than for the same
# problem without limits: the gap. Here a mechanical stop limits joint 3 of a planar
# arm:

arm = mp.planar_arm([1.0, 1.0, 1.0])
start, goal = [2.0, -2.6, 1.3], [-1.8, 2.0, 0.2]
free = mp.optimize_path(arm, start, goal, objective=mp.PathObjective(power=2))
stopped = arm.with_limits(lower=-3.1, upper=[3.1, 3.1, 1.4])
held = mp.optimize_path(stopped, start, goal, objective=mp.PathObjective(power=2))
for name, result in (("no limits", free), ("joint 3 below 1.4 rad", held)):
    print(
        f"{name:22s} g {result.g:.3f}, gap {result.certificate.gap:7.2%}, joint 3 "
        f"up to {result.path.bounds()[1][2]:.3f} rad"
    )
for approach in held.certificate.limits[:3]:
    print(
        f"{approach.joint}: {approach.distance:.4f} {approach.unit} to its "
        f"{approach.side} limit, at s = {approach.at:.2f}"
    )
assert held.g > free.g
