"""The floor ε of an objective: below it, a smaller manipulability costs hardly more.

∫ ‖q'‖ / m^p ds is infinite on every path that crosses a singularity for p >= 1. With (m² + ε²)^(p/2) in place of m^p it is
finite, and smooth where det J changes its sign.
"""

import logging

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.measure import Measure
from manipplan.paths.rounding import with_bits
from manipplan.robots.robot import Robot
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.task import Task

log = logging.getLogger("manipplan")

#: Default floor as a share of the arm's typical measure. Where m stays above ten floors, g differs by less than p / 2 per cent;
#: on most paths of redundant arms m stays above a tenth of its typical value, where g differs by less than p / 2 * 1e-4.
SHARE = 1e-3
#: Number of random configurations whose median is the typical value.
SAMPLES = 200
#: Bits of the typical value, so that it is the same on every processor.
BITS = 24


def typical_measure(kinematics: Kinematics) -> float:
    """The median of the measure over SAMPLES random configurations with a fixed seed, to BITS bits."""
    return _typical(kinematics.robot, kinematics.task, kinematics.measure, kinematics.compiled)


def floor_of(kinematics: Kinematics, floor: float | None) -> float:
    """The floor ε, in the unit of the measure: `floor` itself, or the default for None.

    That is SHARE of the typical measure, and 0 for a constant one.
    """
    if floor is not None:
        return floor
    return 0.0 if kinematics.measure.constant else SHARE * typical_measure(kinematics)


def warn_of_floor(kinematics: Kinematics, floor: float) -> None:
    """Log a warning about a floor above the typical measure: it hides most singularities."""
    typical = typical_measure(kinematics)
    if floor > typical:
        name, unit = kinematics.measure.name, kinematics.measure.unit(kinematics.task)
        told = "floor=%g is above the typical %s of %s, %.4g %s: singularities hardly count"
        log.warning(told, floor, name, kinematics.robot.name, typical, unit)


@once_per_owner
def _typical(robot: Robot, task: Task, measure: Measure, compiled: bool | str) -> float:
    q = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    values = robot.kinematics(task, measure=measure, compiled=compiled).manipulability(q)
    return float(with_bits(np.array([np.median(values)]), BITS)[0])
