"""The picture of a plan: the arm along the path, its manipulability and that of the initial path, and the joints over time."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from manipplan.robots.robot import Robot
from manipplan.support.checks import instance
from manipplan.support.errors import PlanningError
from manipplan.support.files import write_bytes
from manipplan.support.interrupts import uninterrupted
from manipplan.support.status import RECORDED
from manipplan.viz import style
from manipplan.viz.arm import plot_arm
from manipplan.viz.curves import plot_joints, plot_manipulability
from manipplan.viz.motions import named_paths
from manipplan.viz.planar import plot_planar_arm

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan


def save_plan(plan: "Plan", file: str | Path) -> None:
    """Write the picture of a plan as PNG; see `plan_figure`."""
    with uninterrupted():  # drawing the first figure imports Matplotlib and builds its formula parser
        figure = plan_figure(plan)
        write_bytes(file, lambda stream: figure.savefig(stream, format="png", dpi=110))


def plan_figure(plan: "Plan", figure: Any = None) -> Any:
    """Draw a plan: the arm along the path, its manipulability and that of the initial path, and the joints over time.

    `figure` is a Matplotlib figure to draw into; default: a new one of 11.5 x 6 inches. Returns the figure. Raises
    PlanningError for a plan without a trajectory.
    """
    from matplotlib.figure import Figure

    finished(plan)
    paths = named_paths(plan)
    seed, names = plan.result.seed if len(paths) > 1 else None, (next(iter(paths)), list(paths)[-1])
    with style.shared():
        figure = figure if figure is not None else Figure(figsize=(11.5, 6.0))
        figure.set_layout_engine("constrained")
        parts: Any = figure.subfigures(1, 2, width_ratios=(1.15, 1))
        left, right = parts
        title = f"{plan.robot.name}: {plan.trajectory.duration:.2f} s"
        if plan.report.counts:
            title += f", minimum manipulability {plan.report.min_manipulability:.3g}"
        left.suptitle(title, fontsize=11, x=0.02, ha="left")
        if plan.robot.planar:
            plot_planar_arm(plan.robot, plan.path, plan.scene, seed=seed, names=names, ax=left.subplots())
        else:
            ax = left.add_subplot(projection="3d")
            plot_arm(plan.robot, plan.path, plan.scene, seed=seed, names=names, ax=ax)
        top, bottom = right.subplots(2, 1)
        kinematics = plan.robot.kinematics(plan.result.task, measure=plan.result.measure)
        bound = plan.refinement.bound if plan.refinement is not None else None
        started_free = plan.refinement is None and plan.result.status not in RECORDED  # a tool path allows no straight line
        plot_manipulability(kinematics, paths, straight=started_free, bound=bound, ax=top)
        limits = plan.robot.limits
        ranged = bool(np.isfinite([limits.lower, limits.upper]).all())
        plot_joints(plan.trajectory, limits, share=ranged, unit=joint_unit(plan.robot), ax=bottom)
        for begin, end in plan.off_path:
            bottom.axvspan(begin, end, color=style.ARM, alpha=0.12, linewidth=0)
            bottom.annotate(
                "off the path",
                (begin, 0.0),
                xycoords=("data", "axes fraction"),
                xytext=(3, 3),
                textcoords="offset points",
                fontsize=8,
                color=style.ARM,
            )
    return figure


def finished(plan: "Plan") -> None:
    """Raises InvalidInputError for an object that is not a plan, PlanningError for a plan without trajectory."""
    from manipplan.jobs.result import PartialPlan, Plan

    instance("plan", plan, PartialPlan)
    if not isinstance(plan, Plan):
        raise PlanningError(f"there is no trajectory to draw: {plan.status.value}", plan)


def joint_unit(robot: Robot) -> str:
    """The unit of a robot's joint positions."""
    units = {"m" if kind == "prismatic" else "rad" for kind in robot.joint_types}
    return " or ".join(sorted(units, reverse=True))
