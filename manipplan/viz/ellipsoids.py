"""Ellipsoids of velocity, force and acceleration, in the plane and in space."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from manipplan.checks import finite_array, instance, number
from manipplan.errors import InvalidInputError
from manipplan.measures.ellipsoid import Ellipsoid
from manipplan.viz import style


def plot_ellipsoid(
    ellipsoid: Ellipsoid,
    centre: ArrayLike,
    *,
    ax: Any,
    scale: float = 1.0,
    largest: float | None = None,
    axes: bool = False,
    **look: Any,
) -> None:
    """Draw an ellipsoid of two rows as an ellipse, one of three as a surface on a 3D axes.

    Args:
        ellipsoid: with 2 or 3 radii.
        centre: where, (2,) or (3,) [m].
        ax: Matplotlib's axes; with projection="3d" for three rows.
        scale: metres drawn for one unit of the radii.
        largest: radii above are drawn as long as this; needed where one is infinite.
        axes: draw the principal axes too.
        **look: color, alpha, label and other properties of the patch or surface.

    Raises InvalidInputError for other numbers of rows, or an infinite radius without `largest`.
    """
    m = len(instance("ellipsoid", ellipsoid, Ellipsoid).radii)
    if m not in (2, 3):
        raise InvalidInputError("ellipsoid", ellipsoid.radii.tolist(), "2 or 3 radii; take those rows of the Jacobian")
    if not hasattr(ax, "plot_surface" if m == 3 else "fill"):
        raise InvalidInputError("ax", ax, "Matplotlib's axes, with projection='3d' for three rows")
    middle = finite_array("centre", centre, (m,))
    number("scale", scale, above=0.0)
    radii = ellipsoid.radii if largest is None else np.minimum(ellipsoid.radii, number("largest", largest, above=0.0))
    if not np.isfinite(radii).all():
        raise InvalidInputError("largest", None, "a length to draw the infinite radius with")
    look = {"color": style.ELLIPSOID, "alpha": 0.3, "linewidth": 0, **look}
    spokes = scale * radii * ellipsoid.axes
    if axes:
        for spoke in spokes.T:
            ax.plot(*np.stack([middle - spoke, middle + spoke]).T, color=look["color"], linewidth=1.0)
    if m == 2:
        around = np.linspace(0.0, 2 * np.pi, 90)
        outline = middle + np.stack([np.cos(around), np.sin(around)], axis=1) @ spokes.T
        ax.fill(*outline.T, **look)
    else:
        ax.plot_surface(*np.moveaxis(_ball() @ spokes.T + middle, 2, 0), **{"rcount": 17, "ccount": 33, **look})


def _ball() -> Any:
    """Points of the unit sphere, (17, 33, 3)."""
    around, up = np.meshgrid(np.linspace(0, 2 * np.pi, 33), np.linspace(0, np.pi, 17))
    return np.stack([np.cos(around) * np.sin(up), np.sin(around) * np.sin(up), np.cos(up)], axis=2)
