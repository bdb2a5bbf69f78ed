"""Colours and line styles of all pictures; the colours are distinguishable with colour blindness [okabe2008]."""

import re
from contextlib import AbstractContextManager
from typing import Any

from manipplan.kinematics.kinematics import Kinematics
from manipplan.support.checks import instance
from manipplan.support.errors import InvalidInputError

__all__ = ["ARM", "ELLIPSOID", "JOINTS", "OBSTACLE", "OPTIMUM", "PIECES", "SEED", "STRAIGHT", "STYLE", "label_powers", "shared"]

#: Maximum number of places along a motion at which something is drawn.
MOST_PLACES = 1000

OPTIMUM = "#0072B2"
SEED = "#E69F00"
STRAIGHT = "#999999"
OBSTACLE = "#CC79A7"
OBSTACLE_NAME = "#7A2E5C"
ELLIPSOID = "#009E73"
ARM = "#333333"
BODY_FIRST, BODY_LAST = "#DDE3EA", "#B9C4D0"
FLOOR = "#C9C9C9"
CANDIDATE = "#BFC5CC"
LIMIT = "#D55E00"
#: Neighbouring bodies that are checked for collisions.
PIECES = ("#5B9DC9", "#EDBD58", "#5DB996", "#DBA0C1", "#94CFEF", "#E28F55")
JOINTS = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#000000", "#8F8F00", "#7F3C8D")

SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

STYLE: dict[Any, Any] = {
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#E4E4E4",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.6,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "figure.dpi": 110,
    "text.parse_math": False,  # names come from files and may contain any character
}


def shared() -> AbstractContextManager[None]:
    """A context in which Matplotlib draws in the style of all pictures."""
    from matplotlib import rc_context

    return rc_context(STYLE)


def axes_for(ax: Any, *, solid: bool = False, size: tuple[float, float] = (7.0, 4.0)) -> Any:
    """The axes to draw into: `ax`, or those of a new figure of `size` [inches].

    `solid`: whether axes with projection="3d" are required, instead of 2D axes. Raises InvalidInputError for the other kind.
    """
    if ax is not None:
        if not hasattr(ax, "plot") or (getattr(ax, "name", "") == "3d") != solid:
            kind = "with projection='3d'" if solid else "without projection='3d'"
            raise InvalidInputError("ax", ax, f"Matplotlib axes {kind}, or None for a new figure")
        return ax
    import matplotlib.pyplot as plt

    with shared():
        figure = plt.figure(figsize=size, layout="constrained")
        return figure.add_subplot(projection="3d") if solid else figure.add_subplot()


def raised(unit: str) -> str:
    """The `unit` of a measure or task, such as "m^6", with superscript powers; "" for "1"."""
    return "" if unit == "1" else re.sub(r"\^(-?\d+)", lambda power: power[1].translate(SUPERSCRIPTS), unit)


def with_unit(name: str, unit: str) -> str:
    """An axis label; `unit` as for `raised`."""
    return f"{name} [{raised(unit)}]" if raised(unit) else name


def measure_label(kinematics: Kinematics) -> str:
    """The axis label of a measure of manipulability."""
    return with_unit(kinematics.measure.name, kinematics.measure.unit(kinematics.task))


def label_powers(figure: Any) -> None:
    """Label a Matplotlib figure's logarithmic axes with 0.5, 100 and 2×10⁴.

    Matplotlib would write formulas, which `STYLE` shows as they are: a name from a file is none. Raises InvalidInputError for
    anything but a figure.
    """
    from matplotlib.figure import FigureBase
    from matplotlib.ticker import LogFormatterSciNotation

    class Powers(LogFormatterSciNotation):
        def __call__(self, x: float, pos: int | None = None) -> str:
            formula = super().__call__(x, pos)  # such as $\mathdefault{2\times10^{4}}$
            if formula and 0.01 <= x < 1e4:
                return f"{x:g}"
            text = re.sub(r"\^\{(-?\d+)\}", lambda power: power[1].translate(SUPERSCRIPTS), formula)
            return text.removeprefix(r"$\mathdefault{").removesuffix("}$").replace(r"\times", "×")

    instance("figure", figure, FigureBase)
    for axis in (each for ax in figure.axes for each in (ax.xaxis, ax.yaxis)):
        if axis.get_scale() == "log" and isinstance(axis.get_major_formatter(), LogFormatterSciNotation):
            axis.set_major_formatter(Powers())
        if axis.get_scale() == "log" and isinstance(axis.get_minor_formatter(), LogFormatterSciNotation):
            axis.set_minor_formatter(Powers())


def name_axes(ax: Any) -> None:
    """Label spatial axes with x, y and z in metres."""
    ax.set(xlabel="x [m]", ylabel="y [m]")
    if ax.name == "3d":
        ax.set_zlabel("z [m]")


def rgb(colour: str) -> tuple[float, float, float]:
    """Red, green and blue in [0, 1] of "#rrggbb"."""
    return int(colour[1:3], 16) / 255, int(colour[3:5], 16) / 255, int(colour[5:7], 16) / 255
