"""All figures, by file name."""

from collections.abc import Callable
from pathlib import Path

from studies.kth2012 import figures_arm, figures_beyond, figures_paths, figures_postures
from studies.kth2012.config import FIRST, SECOND
from studies.kth2012.results import Results

#: What --quick leaves out.
FULL_ONLY = ("torus", "convergence", "obstacles", "links", "global")


def figures(results: Results) -> dict[str, Callable[[Path], None]]:
    """The function that writes each figure to a file."""
    postures, paths, beyond = figures_postures, figures_paths, figures_beyond
    return {
        "figure2_1": figures_arm.schematic,
        "figure2_2": figures_arm.ellipses,
        "figure4_1": figures_arm.condition_number,
        "figure5_1": lambda file: postures.spaces(file, limited=False),
        "figure5_2": lambda file: postures.whole_map(results, file),
        "figure5_3": lambda file: postures.by_radius(results, file),
        "figure5_4": lambda file: postures.feasible(results, file),
        "figure5_5": lambda file: postures.at_radii(results, file),
        "figure5_6": lambda file: postures.spaces(file, limited=True),
        "figure5_7": lambda file: postures.limited_map(results, file),
        "figure5_8": lambda file: postures.limited_feasible(results, file),
        "figure5_9": lambda file: postures.both_ellipses(results, file),
        "figure6_1": lambda file: paths.by_degree(results, FIRST, file),
        "figure6_2": lambda file: paths.by_degree(results, SECOND, file),
        "figure6_3": lambda file: paths.line_and_optimum(results, file),
        "figure6_4": lambda file: paths.along(results, file),
        "classes": lambda file: beyond.class_map(results, file),
        "torus": lambda file: beyond.turned(results, file),
        "convergence": lambda file: beyond.convergence(results, file),
        "obstacles": lambda file: beyond.obstacles(results, file),
        "global": lambda file: beyond.march(results, file),
        "links": lambda file: beyond.more_links(results, file),
    }
