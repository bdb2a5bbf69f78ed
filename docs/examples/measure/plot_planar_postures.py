"""
The best posture of a planar arm, with proof
============================================

.. image:: images/sphx_glr_plot_planar_postures_001.png
   :alt: The best postures of a planar arm, and the largest manipulability by the
         distance of the tool.

*For students, and for designers of planar arms.*

For the planar arm much is known in closed form. Which posture has the largest
manipulability, at a given distance or within given limits? This page finds *all*
stationary postures and proves that none is missing, so the best of them is the global
optimum.
"""

# sphinx_gallery_thumbnail_path = "pictures/planar_postures.jpg"
import matplotlib.pyplot as plt
import numpy as np

from manipplan import planar

arm = planar.PlanarArm([1.0, 1.0, 1.0])

# %%
# All stationary postures of three unit links, the best first. ``complete`` says that
# the list is proven to be complete.

free = planar.stationary_postures(arm)
print(f"{len(free)} postures; none is missing")
for q, m, radius, kappa in zip(
    free.q, free.manipulability, free.radius, free.inverse_condition, strict=True
):
    print(
        f"q {np.rad2deg(q).round(2)}°  manipulability {m:.4f} m²  distance "
        f"{radius:.4f} m  1/condition {kappa:.3f}"
    )
assert free.complete and 2.634 < free.bound < 2.635

# %%
# Random sampling agrees: it comes close to the optimum and stays below it.

rng = np.random.default_rng(0)
sampled = planar.manipulability(arm, rng.uniform(-np.pi, np.pi, (200_000, 3))).max()
print(
    f"best of 200,000 random postures: {sampled:.5f} m², proven optimum: "
    f"{free.bound:.5f} m²"
)
assert sampled <= free.bound

# %%
# The best postures with the tool at a fixed distance, and with joint limits.

distances = np.linspace(0.05, 2.95, 59)
best = [planar.stationary_postures(arm, radius=r).best for r in distances]
limited = planar.stationary_postures(
    arm, lower=[-np.pi, -0.5, -0.5], upper=[np.pi, 0.9, 0.9]
).best
print(
    f"with joints 2 and 3 in [-0.5, 0.9] rad: m = {limited.manipulability[0]:.4f} "
    f"m² at {limited.q[0].round(3)} rad"
)

figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6), layout="constrained")
for postures, colour, name in (
    (free.best, "#0072B2", "free"),
    (planar.stationary_postures(arm, radius=1.0).best, "#E69F00", "tool at 1 m"),
    (planar.stationary_postures(arm, radius=2.7).best, "#009E73", "tool at 2.7 m"),
    (limited, "#CC79A7", "joints limited"),
):
    angles = np.cumsum(postures.q[0])
    joints = np.vstack(
        [
            np.zeros(2),
            np.cumsum(np.stack([np.cos(angles), np.sin(angles)], axis=1), axis=0),
        ]
    )
    left.plot(
        *joints.T,
        "o-",
        color=colour,
        linewidth=2.5,
        label=f"{name}: {postures.manipulability[0]:.3f} m²",
    )
left.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
left.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
right.plot(distances, [b.manipulability[0] for b in best], color="#0072B2")
right.axvline(
    planar.optimal_radius(arm),
    color="0.5",
    linestyle=":",
    label="distance of the free optimum",
)
right.set(
    xlabel="distance of the tool from the base [m]",
    ylabel="largest manipulability [m²]",
    xlim=(0, 3),
    ylim=(0, None),
)
right.legend(frameon=False, fontsize=8)
plt.show()

# %%
# **Which link lengths are best?** With a total of 3 m and links of at least 0.3 m, a
# long first and a long last link are better than equal links.

proportions = planar.optimal_lengths(3, total=3.0, least=0.3)
print(
    f"lengths {proportions.lengths.round(3)} m: manipulability "
    f"{proportions.manipulability:.4f} m², equal lengths {free.bound:.4f} m²"
)
print(f"no arm of this total length exceeds {proportions.bound:.4f} m²")
assert free.bound < proportions.manipulability <= proportions.bound
