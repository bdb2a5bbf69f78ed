"""Constants of the study; a comment says where the thesis states each one, or that it is ours."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from manipplan.planar import PlanarArm

HERE = Path(__file__).parent
EXPECTED = HERE / "expected.csv"
PAGES = HERE.parents[1] / "docs" / "studies" / "kth2012"

ARM = PlanarArm([1.0, 1.0, 1.0])  # (5.1), (6.8)
QUARTER = np.pi / 2  # (5.6), (5.7): |θ_i| <= π/2

# Table 5.1, and Table 5.2 by radius: θ_2, θ_3, μ, κ.
TABLE_5_1 = (2.15, 0.78, 1.13, 2.63)
TABLE_5_2 = {
    1.0: (1.57, 1.57, 1.73, 0.58),
    1.4: (1.30, 1.44, 2.18, 0.54),
    1.8: (1.02, 1.29, 2.52, 0.44),
    2.2: (0.74, 1.10, 2.63, 0.33),
    2.6: (0.47, 0.80, 2.30, 0.22),
    3.0: (0.00, 0.00, 0.00, 0.00),
}
SMALL_RADII = (0.05, 0.25, 0.5)  # below those of Table 5.2; without limits
FIGURE_5_4_RADIUS = 2.15
FIGURE_5_5_RADII = (0.0, 0.75, 1.5, 2.25, 3.0)
FIGURE_5_8_RADII = (1.4, 2.2)  # "two different radii"; the thesis does not name them
ELLIPSE_SCALE = 1 / 3  # figures 5.5 and 5.9, from the factor 3 in their captions


@dataclass(frozen=True, kw_only=True)
class Example:
    """A path problem of chapter 6: start and goal (3,) [rad], and the g of its table by degree from 1."""

    name: str
    start: tuple[float, ...]
    goal: tuple[float, ...]
    thesis: tuple[float, ...] = ()


FIRST = Example(
    name="(6.10)", start=(0.0, -3.0, -2.0), goal=(np.pi, 0.1, 1.4), thesis=(2.7218, 2.4600, 2.3168, 2.2542, 2.2376, 2.2361)
)
SECOND = Example(
    name="(6.12)", start=(0.0, -1.1, -1.6), goal=(np.pi / 2, 0.5, 1.5), thesis=(3.9420, 1.1371, 1.1185, 1.1143, 1.1114, 1.1114)
)
THIRD = Example(name="(6.13)", start=(0.0, 1.5, -2.0), goal=(np.pi, -2.0, 2.0))
EXAMPLES = (FIRST, SECOND, THIRD)
DEGREES = range(1, 7)
BEST_DEGREE = 6
TABLE_POWER, TEXT_POWER = 2.0, 1.0  # exponent of μ in the tables, and in (6.6)

# Table 6.3: a_ij by j, and Table 6.4 with the ratios as printed.
TABLE_6_3 = (
    (0.00, 1.05, 2.30, 0.92, -0.26, -0.60, -0.27),
    (1.50, -4.19, 0.84, -0.54, -0.86, -0.09, 1.34),
    (-2.00, 0.61, 1.05, 0.89, 0.55, 0.44, 0.44),
)
TABLE_6_4 = (0.27, 0.92, 0.60, 0.50)

# The constants from here on are ours.
LINKS = range(2, 9)  # numbers of links for the theorems
START_DEGREES, STARTS = (3, 6), 10  # random starts; 60, and more degrees, in benchmarks/planar_suite.py
MOST_DEGREE = 12  # largest degree of the convergence study
RATIO_LINKS, SHARE = (2, 3, 4, 5), 0.1  # proportions: every link is at least this share of the total
MANY_LINKS = (3, 4, 5, 6, 7)
PROVEN_LINKS = 4  # largest number of links for which all stationary postures are found
POSTURE_STARTS = 60  # random starts for more links
TWO_LINKS = PlanarArm([1.0, 1.0])
TWO_LINK_ENDS = ((0.0, 0.4), (2.0, 2.5))  # [rad]; for the check in closed form
OBSTACLE_DEGREE, FIRST_PATHS = 12, 4
LOW_DEGREE = 8  # ends in another class among the two posts of (6.10)
LINK_RADIUS, POST_RADIUS, CLEARANCE = 0.05, 0.1, 0.005  # [m]
REACH = LINK_RADIUS + POST_RADIUS + CLEARANCE  # smallest distance of a link's axis from a post's [m]
#: Posts in the way of the free optimum, (x, y) [m].
POSTS = (
    (FIRST, ((-0.4, 2.0),)),
    (FIRST, ((-0.4, 2.0), (-1.6, 0.8))),
    (SECOND, ((0.8, 2.0),)),
    (SECOND, ((0.4, 2.4), (2.0, -0.4))),
)

# The global optimum by fast marching: grid steps [rad] without posts and among them; the pairs of postures are random.
MARCH_STEPS, POST_STEPS, PAIR_STEP, SHIFT_STEP = (0.1, 0.05, 0.035), (0.1, 0.07), 0.07, 0.1
PAIR_STARTS, PAIR_GOALS, PAIR_PATHS = 5, 20, 4
#: The optimiser's path counts as the global optimum up to this share.
NEAR = 1e-3
#: Among posts V falls by up to this share as the grid is refined further, because its postures leave room to the posts.
POST_ERROR = 0.02
#: Number of straight pieces of the polyline among posts.
POLYLINE_PIECES = 400
#: Curves count as approximately the same up to this distance [rad].
ALIKE = 0.1
