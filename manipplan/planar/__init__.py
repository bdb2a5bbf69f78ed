"""The planar n-link arm in closed form: the analytic part of the toolkit [kth2012].

    PlanarArm -> positions, Jacobian -> μ and its derivatives, ‖J‖_F, κ -> all stationary postures, with proof
              -> workspaces with and without joint limits; inverse kinematics; ellipses; executable theorems

``PlanarArm(lengths).robot()`` is the same arm as a robot for the rest of manipplan.
"""

from manipplan.planar.arm import PlanarArm, PostureFamily, pose_postures, position_family, two_link_postures
from manipplan.planar.manipulability import (
    force_ellipse,
    frobenius_norm,
    inverse_condition,
    manipulability,
    manipulability_gradient,
    manipulability_hessian,
    matrix_ellipsoid,
    minors,
    singular_distance,
    singular_postures,
    singular_radii,
    squared_manipulability,
    squared_manipulability_gradient,
    squared_manipulability_hessian,
    velocity_ellipse,
)
from manipplan.planar.postures import PostureSet, optimal_radius, stationary_kind, stationary_postures
from manipplan.planar.theorems import (
    Counterexample,
    Proportions,
    Theorem,
    condition_theorem,
    convexity_counterexample,
    frobenius_theorem,
    manipulability_bound,
    manipulability_theorem,
    optimal_lengths,
)
from manipplan.planar.workspace import (
    Annulus,
    Arc,
    critical_arcs,
    dexterous_annuli,
    is_dexterous,
    is_reachable,
    reachable_annulus,
    reachable_orientations,
    reachable_radii,
    workspace_boundary,
)
from manipplan.planar.zeros import (
    TrigonometricPolynomial,
    Zeros,
    squared_manipulability_series,
    squared_radius_series,
    torus_zeros,
)

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
