"""Pictures of motions and of how they were found.

Every `plot_*` draws into the given Matplotlib axes, `ax=`, or into those of a new figure, and returns the axes. A motion is a
JointPath, a Trajectory or a Tracking. Matplotlib is imported with the first picture.
"""

from manipplan.viz import style
from manipplan.viz.animation import animate
from manipplan.viz.arm import plot_arm, plot_ellipsoid, plot_ellipsoids, plot_tool_path
from manipplan.viz.curves import (
    plot_convergence,
    plot_deviation,
    plot_joints,
    plot_layers,
    plot_manipulability,
    plot_singular_values,
)
from manipplan.viz.figure import draw_figure, save_figure
from manipplan.viz.films import film

__all__ = [
    "animate",
    "draw_figure",
    "film",
    "plot_arm",
    "plot_convergence",
    "plot_deviation",
    "plot_ellipsoid",
    "plot_ellipsoids",
    "plot_joints",
    "plot_layers",
    "plot_manipulability",
    "plot_singular_values",
    "plot_tool_path",
    "save_figure",
    "style",
]
