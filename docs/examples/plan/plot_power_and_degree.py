"""
What to choose: power, degree, measure, shifts
==============================================

.. image:: images/sphx_glr_plot_power_and_degree_001.png
   :alt: Paths of a planar arm over a map of its manipulability, for three powers
         and a shifted goal.

*For users of the path optimiser who want to tune it.*

``optimize_path`` has few parameters. On a planar arm with three unit links each run
takes less than a second, so this page varies them and shows what each does to the path
and what it costs.
"""

# sphinx_gallery_thumbnail_path = "pictures/power_and_degree.jpg"
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

arm = mp.planar_arm([1.0, 1.0, 1.0])
kinematics = arm.kinematics()
start, goal = [2.0, -2.6, 1.3], [-1.8, 2.0, 0.2]
s = np.linspace(0, 1, 400)


def mean(path, measure="yoshikawa"):
    """Mean along the path by arc length; the path's own parameter has no meaning."""
    speed = np.linalg.norm(path(s, 1), axis=1)
    return np.average(
        arm.kinematics(measure=measure).manipulability(path(s)), weights=speed
    )


# %%
# **Power.** The path minimises g = ∫ ‖q′‖ / mᵖ ds, where p is the power. With a power
# near 0 it is the shortest path. The higher the power, the longer the detours that the
# path makes to stay where the manipulability is large.

by_power = {
    power: mp.optimize_path(
        arm,
        start,
        goal,
        shape=mp.PathShape(degree=8),
        objective=mp.PathObjective(power=power),
    )
    for power in (0.25, 1, 2, 4, 8)
}
print("power  length [rad]  minimum manipulability [m²]      mean m [m²]")
for power, result in by_power.items():
    print(
        f"{power:5g}  {result.length:12.3f}  {result.min_manipulability:16.3f}  "
        f"{mean(result.path):15.3f}"
    )
assert by_power[8].length > by_power[0.25].length and mean(by_power[8].path) > mean(
    by_power[0.25].path
)

# %%
# **Degree.** This is the degree of the polynomial of each joint. g falls with the
# degree until nothing more can be gained. A degree of 5 to 8 is enough for most paths
# without obstacles.

by_degree = {
    degree: mp.optimize_path(
        arm,
        start,
        goal,
        shape=mp.PathShape(degree=degree),
        objective=mp.PathObjective(power=2),
    )
    for degree in range(1, 11)
}
print("degree:", *(f"{degree:7d}" for degree in by_degree))
print("g:     ", *(f"{result.g:7.3f}" for result in by_degree.values()))

# %%
# **Measure.** This is the definition of m. Yoshikawa's manipulability measures the
# volume of the velocity ellipsoid, the inverse condition its roundness, and the
# smallest singular value the speed in the slowest direction. Each path is optimised for
# one measure and evaluated by all of them. The table lists the means along the path.

names = ("yoshikawa", "inverse_condition", "smallest_singular_value")
by_measure = {
    name: mp.optimize_path(
        arm,
        start,
        goal,
        shape=mp.PathShape(degree=8),
        objective=mp.PathObjective(power=2, measure=name),
    )
    for name in names
}
print(f"{'path optimised for':23s}  length  " + "  ".join(names))
for name, result in by_measure.items():
    values = [mean(result.path, other) for other in names]
    print(
        f"{name:23s}  {result.length:6.3f}  "
        + "  ".join(
            f"{value:{len(other)}.3f}"
            for other, value in zip(names, values, strict=True)
        )
    )

# %%
# **Shifts.** A goal that differs by full turns of a joint is the same posture.
# ``mp.Seeding(shifts="within-limits")`` tries every such goal inside the limits. Some
# of these goals have shorter paths, or paths through better postures. The joints of
# this arm turn without limits, so there are 27 goals.

shifted = mp.optimize_path(
    arm,
    start,
    goal,
    shape=mp.PathShape(degree=8),
    objective=mp.PathObjective(power=2),
    seeding=mp.Seeding(shifts="within-limits"),
)
turns = np.round((shifted.path.goal - goal) / (2 * np.pi)).astype(int)
print(
    f"g {by_power[2].g:.3f} -> {shifted.g:.3f} with the goal shifted by {turns} "
    f"turns; {len(shifted.rivals)} rivals"
)
assert shifted.status is mp.Status.OPTIMAL
assert shifted.g < 1.24 and 1.36 < by_power[2].g < 1.38

# %%
# The paths in the plane of joints 2 and 3. The background is the manipulability, which
# does not depend on joint 1: dark is singular.

edge = np.linspace(-np.pi, 2 * np.pi, 241)
second, third = np.meshgrid(edge, edge)
m = kinematics.manipulability(np.stack([np.zeros_like(second), second, third], axis=-1))
figure, (left, right) = plt.subplots(
    1, 2, figsize=(11, 4.6), layout="constrained", width_ratios=(1.15, 1)
)
image = left.pcolormesh(
    second, third, m, cmap="gray", shading="gouraud", rasterized=True
)
figure.colorbar(image, ax=left, label="manipulability [m²]")
lines = {f"power {power:g}": by_power[power] for power in (0.25, 2, 8)} | {
    "power 2, shifted goal": shifted
}
for (name, result), colour in zip(
    lines.items(), ("#E69F00", "#56B4E9", "#009E73", "#D55E00"), strict=True
):
    q = result.path(s)
    left.plot(q[:, 1], q[:, 2], color=colour, linewidth=2.2)
    left.plot(*q[-1, 1:], "o", color=colour)
    right.plot(
        s,
        kinematics.manipulability(q),
        color=colour,
        label=f"{name}: {result.length:.2f} rad",
    )
left.plot(*start[1:], "ws", markeredgecolor="black")
inside = np.concatenate([result.path(s)[:, 1:] for result in lines.values()])
left.set(xlabel="joint 2 [rad]", ylabel="joint 3 [rad]", aspect="equal")
left.set(
    xlim=(inside[:, 0].min() - 0.6, inside[:, 0].max() + 0.6),
    ylim=(inside[:, 1].min() - 0.6, inside[:, 1].max() + 0.6),
)
right.set(xlabel="s", ylabel="manipulability [m²]", ylim=(0, None))
right.legend(fontsize=8, frameon=False)
plt.show()

# %%
# Start with ``mp.PathObjective(power=1)``. Raise the power to 2 or 4 where the minimum
# manipulability matters more than the time. Beyond that the path hardly changes, and g
# becomes very large. Use ``shifts`` of ``mp.Seeding`` for arms whose joints have a wide
# range, and its ``count`` among obstacles.
