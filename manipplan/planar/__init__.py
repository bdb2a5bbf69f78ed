"""The planar n-link arm in closed form: the analytic part of the toolkit [kth2012].

    PlanarArm -> positions, Jacobian -> μ and its derivatives, ‖J‖_F, κ -> all stationary postures, with proof
              -> workspaces with and without joint limits; inverse kinematics; ellipses; executable theorems

``PlanarArm(lengths).robot()`` is the same arm as a robot for the rest of manipplan.
"""

from manipplan.planar.arm import PlanarArm
from manipplan.planar.ellipsoids import force_ellipse, matrix_ellipsoid, velocity_ellipse
from manipplan.planar.inverse import PostureFamily, pose_postures, position_family, two_link_postures
from manipplan.planar.manipulability import (
    frobenius_norm,
    inverse_condition,
    manipulability,
    manipulability_gradient,
    manipulability_hessian,
    minors,
    singular_distance,
    singular_postures,
    singular_radii,
    squared_manipulability,
    squared_manipulability_gradient,
    squared_manipulability_hessian,
)
from manipplan.planar.orientations import is_dexterous, is_reachable, reachable_orientations
from manipplan.planar.postures import PostureSet, optimal_radius, stationary_kind, stationary_postures
from manipplan.planar.proportions import Proportions, manipulability_bound, optimal_lengths
from manipplan.planar.theorems import (
    Counterexample,
    Theorem,
    condition_theorem,
    convexity_counterexample,
    frobenius_theorem,
    manipulability_theorem,
)
from manipplan.planar.trigonometric import TrigonometricPolynomial, squared_manipulability_series, squared_radius_series
from manipplan.planar.workspace import (
    Annulus,
    Arc,
    critical_arcs,
    dexterous_annuli,
    reachable_annulus,
    reachable_radii,
    workspace_boundary,
)
from manipplan.planar.zeros import Zeros, torus_zeros

__all__ = [
    "Annulus",
    "Arc",
    "Counterexample",
    "PlanarArm",
    "PostureFamily",
    "PostureSet",
    "Proportions",
    "Theorem",
    "TrigonometricPolynomial",
    "Zeros",
    "condition_theorem",
    "convexity_counterexample",
    "critical_arcs",
    "dexterous_annuli",
    "force_ellipse",
    "frobenius_norm",
    "frobenius_theorem",
    "inverse_condition",
    "is_dexterous",
    "is_reachable",
    "manipulability",
    "manipulability_bound",
    "manipulability_gradient",
    "manipulability_hessian",
    "manipulability_theorem",
    "matrix_ellipsoid",
    "minors",
    "optimal_lengths",
    "optimal_radius",
    "pose_postures",
    "position_family",
    "reachable_annulus",
    "reachable_orientations",
    "reachable_radii",
    "singular_distance",
    "singular_postures",
    "singular_radii",
    "squared_manipulability",
    "squared_manipulability_gradient",
    "squared_manipulability_hessian",
    "squared_manipulability_series",
    "squared_radius_series",
    "stationary_kind",
    "stationary_postures",
    "torus_zeros",
    "two_link_postures",
    "velocity_ellipse",
    "workspace_boundary",
]
