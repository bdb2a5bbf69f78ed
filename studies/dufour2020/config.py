"""Constants of the study; a comment says where the paper states each one, or that it is ours."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

import manipplan as mp

HERE = Path(__file__).parent
PATHS = HERE / "paths"
EXPECTED = HERE / "expected.csv"
PAGES = HERE.parents[1] / "docs" / "studies" / "dufour2020"

# Section 5: a Baxter research robot, T = 10 ms, Q = I. Our choice: the left arm, position and velocity limits of the URDF.
ROBOT = "baxter_left"
DT = 0.01  # [s]
FAST_DT = 0.001  # [s], section 6: 1 kHz
ACCELERATION = 40.0  # [rad/s²], ours; section 3.2 mentions acceleration limits without values
TASK = mp.Task.pose(length=1.0)  # (5): the six rows without weights, in metres and radians
STARTS = 60  # ours; starts of the search for the arm's largest manipulability, by which all values are divided (section 5)
# Section 3.2: Q_high in 1e4 to 1e5, Q_low in 1 to 10, Fig. 1. The degree is ours.
STIFFNESS = mp.StiffnessProfile(high=1e4, low=10.0, degree=6.0)
DEAD_BEAT = np.inf  # section 3.1: the deviation is corrected within one step
GENTLE = 2.0  # [m/s²], the library's default for this correction
SETTLING = 2.0  # [s], ours; time at the end of a path, without drive
HOLD = 1e4  # ours; stiffness during this time

# Fig. 4 names α = 15000; the other values for (10) are ours. Table 1: 5e5 for (14), 50 to 120 thousand for (10).
ALPHA = 15e3
ALPHAS = (5e3, 15e3, 50e3)
PAPERS_ALPHAS = {"T1": 50e3, "T2": 70e3, "T3": 70e3, "T4": 120e3, "T5": 90e3}
ONE_ALPHA = 5e5
PAPERS_LOSS = (3.0, 5.0)  # [%], section 5: how much (14) at ONE_ALPHA is below (10) at the α of each path
NOT_MUCH = 10.0  # [%], ours: up to here "no more improvement" of section 5 counts as confirmed
LOG_WEIGHT, LOG_RATE = 10.0, 10.0  # ours
#: Added to every joint of the first posture [rad], ours. A run whose results change with it is chaotic: they also change with
#: the last bit of a sum, and so with the type of processor.
NUDGE = 1e-10
LITERAL_ALPHAS = (1e3, 1e4, 15e3, 5e4, 1e5)  # of (20) as printed, ours
MOVED_STARTS = 12  # starts moved by up to NUDGE, for the spread of (20) as printed on T3, ours
# Tremor of the hand that guides the arm: amplitude [rad], frequency [Hz], and time to fade in and out [s], ours.
TREMORS, TREMOR_FREQUENCY, FADE = (0.0, 5e-4, 2e-3), 8.0, 0.5
# Sweeps, ours.
GAINS = (0.0, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0, 1000.0)
SWEEP = (*(share * 10.0**power for power in (3, 4, 5, 6) for share in (1.0, 1.5, 2.0, 3.0, 5.0, 7.0)), 1e7)
WEIGHTS = tuple(share * 10.0**power for power in (-2, -1, 0, 1, 2) for share in (1.0, 2.0, 5.0))
TUBES = (0.05, 0.02, 0.005)  # [m]
TUBE_SLACK = 1.15  # a step takes the path as straight, so a deviation can be a little larger than the tube

# When a run is sound, ours: the classical formula has to keep its path, and every run has to reach the end without a braking
# step and without chatter. A joint chatters when its acceleration changes sign from one step to the next and both values are
# above half of the limit.
KEPT = 1e-3  # [m]
REACHED = (1e-4, 1e-3)  # [m], [rad]
CHATTER = 0.01  # largest share of joints and steps that chatter

# Scenario 3: the paper shows a sphere near the elbow and states neither its position nor d_i, d_s, ξ. All values are ours.
SPHERE = mp.Sphere(radius=0.05, position=(0.44, 0.40, 0.84))
BLOCKING = mp.Sphere(radius=0.05, position=(0.16, 0.32, 0.80))  # with it, the goal cannot be reached
INFLUENCE, SECURITY, DAMPING = 0.15, 0.05, 0.5  # [m], [m], [m/s]

Posture = tuple[float, ...]
#: Baxter's posture at the start of its demonstrations ("untucked"), left arm.
UNTUCKED: Posture = (-0.08, -1.0, -1.19, 1.94, 0.67, 1.03, -0.5)
# Scenario 1, Fig. 2: along the vertical, by cubic interpolation. Posture, length and duration are ours.
LINE_HEIGHT, LINE_DURATION = 0.4, 4.0  # [m], [s]


@dataclass(frozen=True, kw_only=True)
class Demonstration:
    """Postures [rad] through which an arm is guided in `duration` [s]; `seed` of the wobble of the hand."""

    name: str
    postures: tuple[Posture, ...]
    duration: float
    seed: int


@dataclass(frozen=True, kw_only=True)
class Planned:
    """A start and a goal [rad] for OMPL, the duration of the path [s], the seed and the clearance [m]."""

    name: str
    start: Posture
    goal: Posture
    duration: float
    seed: int
    clearance: float = 0.02


#: Size and position [m] of two boxes around which OMPL plans.
TABLE = ((0.8, 1.4, 0.05), (0.9, 0.2, -0.25))
SHELF = ((0.5, 0.04, 0.6), (0.85, 0.45, 0.1))
DEMONSTRATIONS = (
    Demonstration(
        name="S2",
        postures=(
            UNTUCKED,
            (0.1, -0.6, -0.9, 1.0, 0.5, 0.55, -0.4),
            (0.3, -0.25, -0.5, 0.3, 0.3, 0.1, -0.3),
            (0.45, -0.1, -0.3, 0.6, 0.2, 0.3, -0.2),
            (0.6, 0.0, -0.2, 0.9, 0.1, 0.6, -0.1),
        ),
        duration=6.0,
        seed=2,
    ),
    Demonstration(
        name="T4",
        postures=(UNTUCKED, (-0.4, -0.7, -1.0, 1.4, 0.8, 1.2, -0.2), (-0.6, -0.2, -0.9, 0.9, 0.9, 1.4, 0.1)),
        duration=5.0,
        seed=4,
    ),
    Demonstration(
        name="T5",
        postures=(
            (0.3, -0.9, -0.6, 1.6, 0.4, 0.9, 0.0),
            (0.6, -0.4, -0.4, 0.8, 0.2, 0.5, 0.2),
            (0.8, 0.2, -0.3, 0.5, 0.1, 0.9, 0.4),
            (0.6, 0.3, -0.5, 1.1, 0.2, 0.4, 0.3),
        ),
        duration=6.0,
        seed=5,
    ),
)
PLANNED = (
    Planned(name="T1", start=UNTUCKED, goal=(0.5, -0.5, -0.3, 1.2, 0.2, 0.9, 0.0), duration=5.0, seed=1),
    Planned(
        name="T2",
        start=(0.51, -1.25, -0.97, 2.23, -1.66, -0.99, -1.03),
        goal=(0.08, -1.03, -1.59, 1.52, -2.6, -1.34, 1.5),
        duration=6.0,
        seed=2,
    ),
    Planned(
        name="T3",
        start=(-0.59, -0.86, -0.16, 1.76, 0.07, 0.34, -0.5),
        goal=(0.67, -0.93, -1.09, 1.25, 0.19, 0.97, 0.84),
        duration=6.0,
        seed=3,
    ),
)
TABLE_1 = ("T1", "T2", "T3", "T4", "T5")
