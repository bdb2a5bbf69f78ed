"""How a result was found: the layered search with its candidates, and the optimiser solve by solve."""

from typing import Any

import numpy as np

from manipplan.optimize.result import PathResult
from manipplan.search.candidates.layers import Layers
from manipplan.search.max_min import SearchResult
from manipplan.search.refine import Refinement
from manipplan.support.checks import instance
from manipplan.support.errors import InvalidInputError
from manipplan.viz import style

#: Maximum number of candidates drawn per position.
CANDIDATES = 120


def plot_layers(layers: Layers, result: SearchResult | Refinement | None = None, *, ax: Any = None) -> Any:
    """The manipulability of the candidates at each position, and the path that was found among them.

    Args:
        layers: the candidates; at most 120 per position are drawn, evenly by rank.
        result: a SearchResult or a Refinement of these layers: its manipulability at each position, its minimum and its
            bound. For a search that found no path, the position that no path reaches.
        ax: Matplotlib axes; None: those of a new figure.

    Returns the axes. Raises InvalidInputError for a result with another number of positions.
    """
    instance("layers", layers, Layers)
    if result is not None and not isinstance(result, SearchResult | Refinement):
        raise InvalidInputError("result", result, "a SearchResult, a Refinement or None")
    count = len(layers.m)
    if result is not None and len(result.manipulability) not in (0, count):
        raise InvalidInputError("result", f"{len(result.manipulability)} positions", f"a result of these {count} layers")
    shown = [_evenly(m) for m in layers.m]
    place = np.repeat(np.arange(count), [len(each) for each in shown])
    ax = style.axes_for(ax)
    with style.shared():
        ax.plot(place, np.concatenate(shown), ".", color=style.CANDIDATE, markersize=2.5, label="candidates", zorder=1.5)
        ax.plot([each.max() for each in layers.m], color=style.STRAIGHT, linestyle=":", label="largest per position")
        if result is not None and len(result.manipulability):
            m = result.manipulability
            name = "refined path" if isinstance(result, Refinement) else "best continuous path"
            ax.plot(m, color=style.OPTIMUM, linewidth=2.0, label=name)
            ax.plot(m.argmin(), m.min(), "o", color=style.OPTIMUM, markersize=5, label=f"minimum: {m.min():.4g}")
        if result is not None:
            ax.axhline(
                result.bound, color=style.LIMIT, linestyle=(0, (4, 3)), linewidth=1.2, label=f"bound: {result.bound:.4g}"
            )
        breaks_at = getattr(result, "breaks_at", None)
        if breaks_at is not None:
            ax.axvline(breaks_at, color=style.ARM, linewidth=1.2, label="no continuous path reaches this position")
        ax.set(xlabel="position along the path", xlim=(-0.5, count - 0.5))
        ax.set_ylabel("manipulability" if layers.sampler is None else style.measure_label(layers.sampler.kinematics))
        if min(each.min() for each in shown) >= 0:
            ax.set_ylim(0, None)
        ax.set_title(f"{layers.count} candidates at {count} positions")
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=3)
    return ax


def plot_convergence(result: PathResult, *, ax: Any = None) -> Any:
    """g after each solve of the optimiser: filled for a collision-free path, hollow for a path in collision.

    Args:
        result: of `optimize_path`, or `plan.result`.
        ax: Matplotlib axes; None: those of a new figure.

    Returns the axes. Raises InvalidInputError for a result without solves.
    """
    history = instance("result", result, PathResult).history
    if not history:
        raise InvalidInputError("result", result.status.name, "the result of an optimisation that made at least one solve")
    solve = np.arange(1, len(history) + 1)
    g = np.array([step.g for step in history])
    free = np.array([step.clearance > 0 for step in history])
    first = np.array([step.first for step in history])
    ax = style.axes_for(ax)
    with style.shared():
        for name, marker in zip(dict.fromkeys(first.tolist()), "osD^", strict=False):
            for which, fill in ((free, style.OPTIMUM), (~free, "none")):
                chosen = (first == name) & which & np.isfinite(g)
                text = f"from {name}, {'collision-free' if fill != 'none' else 'in collision'}"
                if chosen.any():
                    ax.plot(solve[chosen], g[chosen], marker, color=style.OPTIMUM, markerfacecolor=fill, label=text)
        ax.axhline(result.g, color=style.ARM, linestyle="--", linewidth=1.2, label=f"result: {result.g:.4g}")
        values = np.append(g[np.isfinite(g)], result.g)
        low, high = values.min(), values.max()
        spare = max(0.15 * (high - low), 1e-3 * high)
        ax.set_ylim(low - spare, high + spare)
        above = result.seed_cost.g > high + spare  # usually by far: drawn to scale, it would compress the solves
        text = f"seed: {result.seed_cost.g:.4g}" + (", above the picture" if above else "")
        ax.axhline(result.seed_cost.g if not above else np.nan, color=style.SEED, linestyle=":", linewidth=1.2, label=text)
        ax.set(xlabel="solve", ylabel="g, the cost of the path", xlim=(0.5, len(history) + 0.5))
        ax.xaxis.get_major_locator().set_params(integer=True)
        ax.set_title(f"{len(history)} solves")
        ax.legend(loc="best")
    return ax


def _evenly(m: Any) -> Any:
    """At most CANDIDATES of the values (k,), evenly by rank, including the smallest and the largest."""
    if len(m) <= CANDIDATES:
        return np.sort(m)
    return np.sort(m)[np.linspace(0, len(m) - 1, CANDIDATES).round().astype(int)]
