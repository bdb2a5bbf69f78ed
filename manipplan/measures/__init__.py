"""Measures of manipulability as expressions of the Jacobian, and ellipsoids.

In: the symbolic posture of an arm. Out: the value of a measure with its derivatives, its name and its unit.
`names` lists the measures that a user can choose by name.
"""

from manipplan.measures.dynamic import Asada, DynamicManipulability
from manipplan.measures.ellipsoid import Ellipsoid, dynamic_ellipsoid, force_ellipsoid, velocity_ellipsoid
from manipplan.measures.limited import JointLimitPenalised
from manipplan.measures.manipulability import Constant, FrobeniusNorm, Isotropy, LogDet, Yoshikawa
from manipplan.measures.measure import Measure, Posture
from manipplan.measures.names import available_measures
from manipplan.measures.over_tools import OverTools
from manipplan.measures.spectral import ConditionNumber, InverseCondition, SmallestSingularValue
from manipplan.measures.transmission import ForceTransmission, VelocityTransmission

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
