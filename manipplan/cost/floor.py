"""The floor ε of an objective: below it, a smaller manipulability costs hardly more.

∫ ‖q'‖ / m^p ds is infinite on every path that crosses a singularity for p >= 1. With (m² + ε²)^(p/2) in place of m^p it is
finite, and smooth where det J changes its sign.
"""

import logging

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.measure import Measure
from manipplan.robots.robot import Robot
from manipplan.support.checks import number
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.task import Task

log = logging.getLogger("manipplan")

#: Default floor as a share of the arm's typical measure. Where m stays above ten floors, g differs by less than p / 2 per cent;
#: on most paths of redundant arms m stays above a tenth of its typical value, where g differs by less than p / 2 * 1e-4.
SHARE = 1e-3
#: Number of random configurations whose median is the typical value.
SAMPLES = 200


def typical_measure(kinematics: Kinematics) -> float:
    """The median of the measure over SAMPLES random configurations with a fixed seed."""
    return _typical(kinematics.robot, kinematics.task, kinematics.measure)


def floor_of(kinematics: Kinematics, floor: float | None) -> float:
    """The floor ε, in the unit of the measure: `floor` itself, or the default SHARE of the typical measure for None.

    A floor above the typical measure is accepted with a warning: it hides most singularities.
    """
    typical = typical_measure(kinematics)
    if floor is None:
        return SHARE * typical
    if floor > typical:
        measure, unit = kinematics.measure.name, kinematics.measure.unit(kinematics.task)
        log.warning(
            "floor=%g is above the typical %s of %s, %.4g %s: singularities hardly count",
            floor,
            measure,
            kinematics.robot.name,
            typical,
            unit,
        )
    return floor


def check_floor(floor: float | None) -> float | None:
    """A valid floor; raises InvalidInputError for one that is negative or not finite."""
    return None if floor is None else number("floor", floor, least=0.0)


@once_per_owner
def _typical(robot: Robot, task: Task, measure: Measure) -> float:
    q = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    values = robot.kinematics(task, measure=measure).manipulability(q)
    return float(np.median(values))
