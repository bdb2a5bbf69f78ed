"""Colours and lines that every picture shares; the colours are told apart also by the colour-blind [okabe2008]."""

from typing import Any

OPTIMUM = "#0072B2"
SEED = "#E69F00"
STRAIGHT = "#999999"
OBSTACLE = "#CC79A7"
ELLIPSOID = "#009E73"
ARM = "#333333"
JOINTS = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#000000", "#8F8F00", "#7F3C8D")

STYLE: dict[Any, Any] = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#E4E4E4",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.6,
    "legend.frameon": False,
    "figure.dpi": 110,
}
