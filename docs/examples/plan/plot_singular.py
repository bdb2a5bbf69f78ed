"""
When every path is singular
===========================

A UR5 has six joints and a pose has six numbers, so its configurations fall into
regions between which every motion crosses a singularity. Then g is infinite
whatever the path. The planner says so; this page shows what it says, why, and what
to do.
"""

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("ur5")
kinematics = robot.kinematics()
start = np.array([0.4, -1.2, 1.5, -1.8, -1.3, 0.7])
goal = np.array([1.4, -0.5, -1.3, 0.3, -1.2, 0.5])  # somebody chose elbow down

# %%
# With ``throw=False`` the result comes back, and its status says what is wrong and
# what would help.

result = mp.optimize_path(robot, start, goal, throw=False)
print(result.status.name)
print(result.status.value)
print("g:", result.g)
assert result.status is mp.Status.SINGULAR and np.isinf(result.g)

# %%
# Why: det J has different signs at the two ends, so on the way it has to be zero
# somewhere.

signs = {
    name: np.sign(np.linalg.det(kinematics.jacobian(q)))
    for name, q in (("start", start), ("goal", goal))
}
print({name: f"{sign:+.0f}" for name, sign in signs.items()})

# %%
# The remedy: the tool's pose is what matters, and other configurations reach it.
# Take those with the sign of the start, and of these the one to which the path of
# least g leads. The same sign is needed, but not enough: the index of this arm is a
# product of three factors, one each of shoulder, elbow and wrist, and a change of
# two of them leaves the sign as it was.

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
    f"{len(solutions)} configurations reach the goal's pose, {len(same)} of them on "
    "the side of the start"
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
# The sign of det J and the index along both paths: the first one touches zero, the
# second one does not.

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
# **Which limit binds?** A path can also be worse than need be because of a limit.
# The certificate says how near it comes to each, and by how much g is above that of
# the same problem without limits: the gap. On a planar arm, joint 3 is held below a
# stop:

arm = mp.planar_arm([1.0, 1.0, 1.0])
start, goal = [2.0, -2.6, 1.3], [-1.8, 2.0, 0.2]
free = mp.optimize_path(arm, start, goal, power=2)
stopped = arm.with_limits(lower=-3.1, upper=[3.1, 3.1, 1.4])
held = mp.optimize_path(stopped, start, goal, power=2)
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
