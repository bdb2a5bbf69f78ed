"""
Where in the workspace the arm is good
======================================

.. image:: images/sphx_glr_plot_workspace_map_001.png
   :alt: Histogram of the manipulability, and two maps of the workspace.

*For those who lay out a cell.*

Where should the arm be mounted, or how high should the table be? A map of the
manipulability over the workspace answers this. This page evaluates a million
configurations and shows a slice through the workspace.
"""

# sphinx_gallery_thumbnail_path = "pictures/workspace_map.jpg"
import time

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("xarm7")
kinematics = robot.kinematics(mp.Task.position())

# %%
# A million random configurations inside the limits. All methods take arrays of any
# leading shape. If a C compiler is available, large batches run in vectorised machine
# code on all cores.

rng = np.random.default_rng(0)
q = robot.random_configuration(rng, size=1_000_000)
kinematics.manipulability(q[:20_000])  # the first large batch compiles
begin = time.perf_counter()
m = kinematics.manipulability(q)
seconds = time.perf_counter() - begin
print(
    f"{len(q):,} manipulabilities in {1e3 * seconds:.0f} ms, "
    f"{len(q) / seconds / 1e6:.0f} million per second"
)
begin = time.perf_counter()
position = kinematics.pose(q)[:, :3, 3]
print(f"poses in {1e3 * (time.perf_counter() - begin):.0f} ms")

# %%
# The distribution of the manipulability: most random configurations are mediocre, and
# singular ones are not rare.

low, high = np.quantile(m, [0.05, 0.95])
print(
    f"5 % are below {low:.4f} m³, 5 % above {high:.4f} m³, the largest is "
    f"{m.max():.4f} m³"
)

# %%
# The arm turns about its first axis, so the distance from that axis and the height
# describe a place completely. Each cell of 2.5 cm shows the largest manipulability of
# its configurations, and the share of nearly singular configurations.

reach, height = np.hypot(position[:, 0], position[:, 1]), position[:, 2]
edges = np.arange(0.0, 0.95, 0.025), np.arange(-0.6, 1.25, 0.025)
columns = np.digitize(reach, edges[0]) - 1, np.digitize(height, edges[1]) - 1
shape = len(edges[0]) - 1, len(edges[1]) - 1
inside = (columns[0] < shape[0]) & (columns[1] >= 0) & (columns[1] < shape[1])
cell = np.ravel_multi_index([c[inside] for c in columns], shape)
highest = np.full(np.prod(shape), np.nan)
np.fmax.at(highest, cell, m[inside])
count = np.bincount(cell, minlength=highest.size)
poor = np.bincount(cell, weights=m[inside] < low, minlength=highest.size) / np.maximum(
    count, 1
)
poor[count < 20] = np.nan
best = np.unravel_index(np.nanargmax(highest), shape)
assert 0.11 < m.max() < 0.12
print(
    f"best cell: {edges[0][best[0]]:.2f} m from the axis, {edges[1][best[1]]:.2f} m "
    f"high, manipulability {np.nanmax(highest):.4f} m³"
)

figure, (left, middle, right) = plt.subplots(
    1, 3, figsize=(11.5, 4.4), layout="constrained", width_ratios=(1, 1, 1)
)
left.hist(m, bins=120, color="#0072B2")
left.set(xlabel="manipulability [m³]", ylabel="configurations", xlim=(0, None))
for ax, values, label in (
    (middle, highest, "largest manipulability [m³]"),
    (right, poor, "share of nearly singular configurations"),
):
    image = ax.pcolormesh(
        *edges, values.reshape(shape).T, cmap="viridis" if ax is middle else "magma_r"
    )
    figure.colorbar(image, ax=ax, label=label)
    ax.set(
        xlabel="distance from the first axis [m]",
        ylabel="height above the base [m]",
        aspect="equal",
    )
plt.show()

# %%
# How to read it: put the work where the middle map is bright. Near the edge of the
# reach every configuration is poor, at any angle of the elbow. For a task that also
# needs the orientation, use ``Task.pose()``; for a single wall or table, ask
# ``mp.inverse_kinematics`` for the poses on it.
