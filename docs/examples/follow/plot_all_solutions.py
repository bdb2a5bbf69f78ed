"""
All configurations that reach a pose
====================================

You have a pose of the tool and want to know every way to reach it: to choose the
best, to know whether a motion has to change from elbow up to elbow down, or to see
that there is none. ``mp.inverse_kinematics`` gives them all, and says in what
sense.
"""

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

# %%
# **Six joints: a UR5.** Finitely many answers: up to eight, by shoulder left or
# right, elbow up or down, wrist turned or not. The limits of this arm are two full
# turns, so that each comes with its copies a full turn away.

ur5 = mp.load_robot("ur5")
q = np.array([0.4, -1.2, 1.5, -1.8, -1.3, 0.7])
pose = ur5.kinematics().pose(q)
solutions = mp.inverse_kinematics(ur5, pose)
families = mp.inverse_kinematics(
    ur5, pose, turns=False
).q  # those that differ by full turns once
print(solutions)
print(
    f"{len(solutions.q)} configurations, of {len(families)} postures; largest error "
    f"{solutions.residual.max():.1e}"
)
print(f"complete: {solutions.complete.value}")
print(families.round(3))
assert len(families) == 8
assert np.isclose(np.angle(np.exp(1j * (families - q))), 0, atol=1e-6).all(axis=1).any()

# %%
# The index tells good ones from bad ones. The sign of det J matters as much: a
# motion between two signs has to cross a singularity.

kinematics = ur5.kinematics()
signs = np.sign([np.linalg.det(kinematics.jacobian(x)) for x in families])
for x, sign in zip(families, signs, strict=True):
    print(f"index {kinematics.manipulability(x):.5f} m^6, sign of det J {sign:+.0f}")

# %%
# **Seven joints: a Panda.** A curve of answers for each of its families. One joint
# is held at each value of a grid, and the closed form gives all answers of the
# others: exact for these values. Here 180 values are tried.

panda = mp.load_robot("panda")
given = np.array([0.2, 0.3, -0.9, -1.9, 0.7, 2.2, 0.3])
pose = panda.kinematics().pose(given)
curve = mp.inverse_kinematics(panda, pose, samples=180)
print(curve)
print(
    f"held: {curve.parameter_names}; complete: {curve.complete.value}, by the "
    f"method {curve.method!r}"
)
index = panda.kinematics().manipulability(curve.q)
best = curve.q[index.argmax()]
print(
    "index of the configuration given "
    f"{panda.kinematics().manipulability(given):.4f}, of the best one "
    f"{index.max():.4f} m^6"
)

# %%
# The self-motion: the hand stays, the elbow goes round. Left, all answers by the
# held joint and by joint 2, coloured by their index; the star is the best. Right,
# one branch of them, from the configuration given.

figure = plt.figure(figsize=(11, 4.6), layout="constrained")
left, right = figure.subfigures(1, 2)
ax = left.subplots()
dots = ax.scatter(curve.parameters[:, 0], curve.q[:, 1], c=index, s=10)
[name] = curve.parameter_names
held = panda.joint_names.index(name)
ax.plot(best[held], best[1], "*", color="#D55E00", markersize=14)
left.colorbar(dots, ax=ax, label="index [m⁶]")
ax.set(xlabel=f"{name}, held [rad]", ylabel="panda_joint2 [rad]")
space = right.add_subplot(projection="3d")
branch = [given]
for value in np.unique(curve.parameters[curve.parameters[:, 0] > given[6], 0]):
    near = curve.q[curve.parameters[:, 0] == value]
    near = near[np.linalg.norm(near - branch[-1], axis=1).argmin()]
    if np.linalg.norm(near - branch[-1]) < 0.4:  # the same family
        branch.append(near)
viz.plot_arm(panda, mp.JointPath.through(branch), ax=space)
plt.show()

# %%
# **Any other arm.** Where no three axes meet and no three are parallel, Newton
# steps start from random configurations until no new answer has been met for long.
# Then completeness is an estimate, and the set says so.

baxter = mp.load_robot("baxter_left")
found = mp.inverse_kinematics(
    baxter, baxter.kinematics().pose(baxter.neutral), samples=12
)
print(found)
print(
    f"complete: {found.complete.value}; share that may be missing: {found.missing:.2g}"
)

# %%
# A pose out of reach gives an empty set, not an error: check ``len(solutions.q)``.

far = pose.copy()
far[0, 3] = 2.0
print(len(mp.inverse_kinematics(panda, far).q))
