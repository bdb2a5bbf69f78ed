"""
All configurations that reach a pose
====================================

.. image:: /pictures/all_solutions.jpg
   :alt: A Panda whose hand stays in place while the elbow may swivel.
   :width: 560px

*For anyone who has to choose a configuration.*

You have a pose of the tool and you want every configuration that reaches it: to choose
the best one, to know whether a motion has to change from elbow up to elbow down, or to
see that there is none. ``mp.inverse_kinematics`` returns them all and says in what
sense they are complete.
"""

# sphinx_gallery_thumbnail_path = "pictures/all_solutions.jpg"

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp
from manipplan import viz

# %%
# **Six joints: a UR5.** There are finitely many solutions, at most eight: shoulder left
# or right, elbow up or down, wrist flipped or not. The limits of this arm are two full
# turns, so each solution also has copies that differ by full turns.

ur5 = mp.load_robot("ur5")
q = np.array([0.4, -1.2, 1.5, -1.8, -1.3, 0.7])
pose = ur5.kinematics().pose(q)
solutions = mp.inverse_kinematics(ur5, pose)
families = mp.inverse_kinematics(
    ur5, pose, turns=False
).q  # solutions that differ by full turns count once
print(solutions)
print(
    f"{len(solutions.q)} configurations, of {len(families)} postures; largest error "
    f"{solutions.residual.max():.1e}"
)
print(f"completeness: {solutions.complete.value}")
print(families.round(3))
assert len(families) == 8
assert np.isclose(np.angle(np.exp(1j * (families - q))), 0, atol=1e-6).all(axis=1).any()

# %%
# The manipulability tells good solutions from bad ones. The sign of det J matters as
# much: a motion between solutions of different signs has to cross a singularity.

kinematics = ur5.kinematics()
signs = np.sign([np.linalg.det(kinematics.jacobian(x)) for x in families])
for x, sign in zip(families, signs, strict=True):
    print(f"m = {kinematics.manipulability(x):.5f} m^6, sign of det J {sign:+.0f}")

# %%
# **Seven joints: a Panda.** The solutions of each family form a curve. One joint is
# held at each value of a grid, and the closed form gives all solutions for the other
# joints. They are exact for these values. Here the grid has 180 values.

panda = mp.load_robot("panda")
given = np.array([0.2, 0.3, -0.9, -1.9, 0.7, 2.2, 0.3])
pose = panda.kinematics().pose(given)
curve = mp.inverse_kinematics(panda, pose, samples=180)
print(curve)
print(
    f"held: {curve.parameter_names[0]}; completeness: {curve.complete.value}, by the "
    f"method {curve.method!r}"
)
m = panda.kinematics().manipulability(curve.q)
best = curve.q[m.argmax()]
print(
    "manipulability of the given configuration "
    f"{panda.kinematics().manipulability(given):.4f}, of the best one "
    f"{m.max():.4f} m^6"
)
assert m.max() > 0.015 and panda.kinematics().manipulability(given) < 0.009

# %%
# The self-motion: the hand stays in place while the elbow swivels. Left: all solutions
# by the held joint and joint 2, coloured by manipulability; the star is the best one.
# Right: one branch of solutions, which starts at the given configuration.

figure = plt.figure(figsize=(11, 4.6), layout="constrained")
left, right = figure.subfigures(1, 2)
ax = left.subplots()
dots = ax.scatter(curve.parameters[:, 0], curve.q[:, 1], c=m, s=10)
[name] = curve.parameter_names
held = panda.joint_names.index(name)
ax.plot(best[held], best[1], "*", color="#D55E00", markersize=14)
left.colorbar(dots, ax=ax, label="manipulability [m⁶]")
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
# **Any other arm.** If no three axes meet in a point and no three are parallel,
# Newton's method starts from random configurations until it has found no new solution
# for a long time. Completeness is then an estimate, and the set says so.

baxter = mp.load_robot("baxter_left")
found = mp.inverse_kinematics(
    baxter, baxter.kinematics().pose(baxter.neutral), samples=12
)
print(found)
print(
    f"completeness: {found.complete.value}; share that may be missing: {found.missing:.2g}"
)

# %%
# A pose out of reach gives an empty set, not an error: check ``len(solutions.q)``.

far = pose.copy()
far[0, 3] = 2.0
print(len(mp.inverse_kinematics(panda, far).q), "solutions")
