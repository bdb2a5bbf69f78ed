"""Measures of manipulability as expressions of the Jacobian, and ellipsoids.

In: the symbolic posture of an arm. Out: the value of a measure with its derivatives, its name and its unit.
`names` lists the measures that a user can choose by name.
"""

from manipplan.measures.dynamic import Asada, DynamicManipulability
from manipplan.measures.ellipsoid import Ellipsoid, dynamic_ellipsoid, force_ellipsoid, velocity_ellipsoid
from manipplan.measures.manipulability import (
    Constant,
    ForceTransmission,
    FrobeniusNorm,
    Isotropy,
    JointLimitPenalised,
    LogDet,
    VelocityTransmission,
    Yoshikawa,
)
from manipplan.measures.measure import Measure, Posture
from manipplan.measures.names import available_measures
from manipplan.measures.over_tools import OverTools
from manipplan.measures.spectral import ConditionNumber, InverseCondition, SmallestSingularValue

__all__ = [
    "Asada",
    "ConditionNumber",
    "Constant",
    "DynamicManipulability",
    "Ellipsoid",
    "ForceTransmission",
    "FrobeniusNorm",
    "InverseCondition",
    "Isotropy",
    "JointLimitPenalised",
    "LogDet",
    "Measure",
    "OverTools",
    "Posture",
    "SmallestSingularValue",
    "VelocityTransmission",
    "Yoshikawa",
    "available_measures",
    "dynamic_ellipsoid",
    "force_ellipsoid",
    "velocity_ellipsoid",
]
