"""The figure of the study."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.figure import Figure

from manipplan.viz.style import STYLE, label_powers
from studies.singularities.slopes import Series

DPI = 110
TITLES = {"planar_2_link": "two links in a plane", "ur5": "UR5"}
COLOURS = ("#000000", "#0072B2", "#009E73", "#D55E00")


def slopes(arms: Sequence[Sequence[Series]], file: Path) -> None:
    """g, and g without its crossings, over the floor: one panel per arm, one colour per number of crossings."""
    with rc_context(STYLE):
        figure = Figure(figsize=(11, 4.6), layout="constrained")
        axes: Any = figure.subplots(1, len(arms))
        for ax, series in zip(axes, arms, strict=True):
            for each, colour in zip(series, COLOURS, strict=True):
                count = len(each.crossings)
                label = f"{count} crossing{'s' * (count != 1)}: slope {round(each.slope, 6):.4g}"
                ax.semilogx(each.floors, each.g, "o-", color=colour, markersize=4, label=label)
                ax.semilogx(each.floors, each.finite, ":", color=colour)
            ax.invert_xaxis()
            ax.set(xlabel="floor ε [unit of m]", ylabel="g", title=TITLES[each.arm])
            ax.xaxis.set_major_formatter("{x:g}")
            ax.minorticks_off()
            ax.legend(loc="upper left")
        label_powers(figure)
        figure.savefig(file, dpi=DPI, metadata={"Software": None})
