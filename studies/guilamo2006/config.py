"""Constants of the study; a comment says where the paper states each one, or that it is ours."""

from pathlib import Path

import numpy as np

import manipplan as mp

HERE = Path(__file__).parent
EXPECTED = HERE / "expected.csv"
PAGES = HERE.parents[1] / "docs" / "studies" / "guilamo2006"

# Section V: chest pitch and yaw and the right arm of HRP2-DH, 9 joints, to the wrist. HRP2 is not public; we use TALOS.
ROBOT = "talos_torso_right_arm"
SHOULDER = "arm_right_1_joint"  # reach is measured from here
SECOND = "simple_humanoid_right_arm"  # ours; one redundant parameter, the swivel
SECOND_SHOULDER = "RARM_SHOULDER_P"
TASK = mp.Task.pose(length=1.0)  # the six rows without weights, in metres and radians; the paper does not state it

# Section V: circle of 20 cm, 50 positions; line of 20 cm, 20 positions; the hand keeps one horizontal orientation.
DIAMETER, CIRCLE_POSITIONS = 0.2, 50
LENGTH, LINE_POSITIONS = 0.2, 20
FORWARD = (-1.0, 0.0, 0.0)  # the wrist's z axis points into the forearm in both robots: the hand points forward
SIDE = (0.0, -1.0, 0.0)  # its x axis; ours
SECOND_SIDE = (0.0, 0.0, 1.0)  # of the second robot; ours
CENTRE = (0.45, -0.25, 0.15)  # [m], ours
#: The line goes straight forward at the height and side of the circle's centre. Its end is the last whole centimetre that
#: has a candidate on the full grid; the reach itself ends within 5 mm beyond it. Measured by `courses.furthest`.
LINE_END = 0.93  # [m]
SECOND_CENTRE = (0.4, -0.16, 0.426)  # [m], ours
SECOND_LINE_END = 0.49  # [m], measured in the same way

# Section V: 306,306 configurations at each position. The factors and their joints (torso 1, torso 2, arm 1) are ours.
CONSIDERED = 306_306
FULL = (77, 51, 78)
#: The same number with other factors: arm 1 has steps of 2.4 degrees.
UNEVEN = (77, 78, 51)
#: As many valid candidates as the paper has.
COARSE = (28, 18, 28)
SECOND_SAMPLES = 1440
SECOND_EPSILONS = (2.0, 5.0, 10.0)  # [degrees], ours
#: Grids of the sweep: with --quick, and in the whole study.
GRIDS = ((16, 10, 16), (20, 13, 20), COARSE, (40, 26, 40))
FULL_GRIDS = (*GRIDS, (56, 36, 56), FULL, UNEVEN)
THIN = 22  # every 22nd candidate of the full set gives as many candidates as the paper has

DELTA = 2.0  # [degrees], section V
EPSILONS = (1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0)  # [degrees]; ours, except for 2
COARSE_EPSILON = {"circle": 3.0, "line": 10.0}  # [degrees], ours: the smallest of EPSILONS that connect
COMPARED_EPSILONS = (3.0, 5.0)  # [degrees]; for the claims on ε
FULL_EPSILON = {"circle": DELTA, "line": 5.0}
TINY = 0.05  # [degrees]; nothing connects at this ε, so the search returns the smallest ε that does
#: Number of branches after which the paper's search is stopped.
MOST_BRANCHES, MOST_BRANCHES_FULL, MOST_BRANCHES_SWEEP = 300_000, 300_000, 100_000

POSTURES = 4  # in the figures, as in Fig. 6 to 8

#: Section V: "about 1/1000" of the manipulability along the line, in its own unit; ours: up to twice that counts as "about".
PERTURBATION = 2e-3
# Numbers of the paper for the circle, from Table I and the text below it.
PAPER_CIRCLE = {"valid": 59_561, "starts": 9_407, "branches": 36_596}


def radians(degrees: float) -> float:
    """An ε of the tables in the unit of the library."""
    return float(np.deg2rad(degrees))
