"""manipplan: from a robot description and a task to a timed trajectory that keeps the arm far from singularities.

    URDF / MJCF / name -> Robot -> Kinematics(task): pose, J, manipulability m, its gradient and Hessian
                               -> Scene: collision and distance
    pose -> inverse_kinematics: every configuration that reaches it
    CartesianPath -> sample_layers -> max_min_search (the largest minimum manipulability) -> refine
    CartesianPath -> track (one QP per step, which raises m while following) -> Tracking
    start, goal -> seed_path (RRT-Connect) -> optimize_path (minimises ∫ ‖q'‖/m^p ds) -> retime (toppra) -> Trajectory -> Report

One call runs a whole row, for instance ``mp.plan(robot, start, goal, scene)``. ``mp.check(robot, trajectory, scene)`` judges a
Trajectory that anybody made.
"""

from manipplan.collision.path_clearance import PathClearance
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Box, Capsule, Cylinder, Mesh, Obstacle, Plane, PointCloud, Sphere
from manipplan.constraints.built_in import HeldJoints, PositionBox, TiltLimit
from manipplan.constraints.constraint import Constraint, SymbolicPose
from manipplan.constraints.constraint_set import ConstraintFigure
from manipplan.cost.crossings import Crossing
from manipplan.cost.integral import PathCost, path_cost
from manipplan.cost.objective import PathObjective
from manipplan.goals.candidates import GoalCandidate
from manipplan.goals.pose_goal import PoseGoal
from manipplan.ik.solutions import Completeness, SolutionSet, inverse_kinematics
from manipplan.jobs.carry import carry
from manipplan.jobs.check import check
from manipplan.jobs.follow import follow
from manipplan.jobs.improve import improve
from manipplan.jobs.plan import plan
from manipplan.jobs.plan_many import Problem, plan_many
from manipplan.jobs.programs.program import Mark, Program
from manipplan.jobs.programs.sequence import sequence
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong, MoveTo, ProgramStep, Wait
from manipplan.jobs.recordings.comparison import Comparison, MotionFigures
from manipplan.jobs.report import PathPart, PlanReport, Report, ToolFigure
from manipplan.jobs.result import PartialPlan, Plan
from manipplan.kinematics.batch import Evaluator
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.dynamic import Asada, DynamicManipulability
from manipplan.measures.ellipsoid import Ellipsoid, dynamic_ellipsoid, force_ellipsoid, velocity_ellipsoid
from manipplan.measures.limited import JointLimitPenalised
from manipplan.measures.manipulability import Constant, FrobeniusNorm, Isotropy, LogDet, Yoshikawa
from manipplan.measures.measure import Measure, Posture
from manipplan.measures.names import available_measures
from manipplan.measures.over_tools import OverTools
from manipplan.measures.spectral import ConditionNumber, InverseCondition, SmallestSingularValue
from manipplan.measures.transmission import ForceTransmission, VelocityTransmission
from manipplan.optimize.certificate import Certificate, LimitApproach
from manipplan.optimize.optimize import optimize_path
from manipplan.optimize.result import NoPath, PathResult
from manipplan.paths.basis import PathShape
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import Deviation
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import StiffnessProfile, Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.catalog import available_robots, load_robot, planar_arm
from manipplan.robots.configuration import TakenToLimit
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.search.guilamo import GuilamoResult, guilamo_search
from manipplan.search.interruptions import Interruptions, fewest_interruptions
from manipplan.search.layers import Layers
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.search.refine import Refinement, refine
from manipplan.search.sampling import sample_layers
from manipplan.seeds.seed import seed_path
from manipplan.seeds.seeding import Seeding
from manipplan.support.errors import (
    CompilerError,
    CompilerWarning,
    FileFormatError,
    InvalidInputError,
    ManipplanError,
    MissingExtraError,
    MissingProgramError,
    MissingSourcesError,
    OutOfReachError,
    PlanningError,
    RobotNotFetchedError,
    UnknownNameError,
    UnsupportedJointError,
)
from manipplan.support.status import Status
from manipplan.symbolic.pinocchio_casadi import PinocchioCasadi, pinocchio_casadi
from manipplan.symbolic.task import Task
from manipplan.timing.constant_speed import SteadySpeed
from manipplan.timing.retime import retime
from manipplan.timing.stops import Segment
from manipplan.timing.verify import LimitUse, jerk_use, limit_use, torque_use
from manipplan.tracking import formulations
from manipplan.tracking.avoidance import Avoidance
from manipplan.tracking.controller import Controller, Rollout, StepReport
from manipplan.tracking.step import StepStatus
from manipplan.tracking.track import Tracking, track

__version__ = "0.2.0.dev0"

__all__ = [
    "Asada",
    "Attach",
    "Avoidance",
    "Box",
    "Capsule",
    "CartesianPath",
    "Certificate",
    "Comparison",
    "CompilerError",
    "CompilerWarning",
    "Completeness",
    "ConditionNumber",
    "Constant",
    "Constraint",
    "ConstraintFigure",
    "Controller",
    "Crossing",
    "Cylinder",
    "Detach",
    "Deviation",
    "DynamicManipulability",
    "Ellipsoid",
    "Evaluator",
    "FileFormatError",
    "ForceTransmission",
    "FrobeniusNorm",
    "GoalCandidate",
    "GuilamoResult",
    "HeldJoints",
    "Interruptions",
    "InvalidInputError",
    "InverseCondition",
    "Isotropy",
    "JointLimitPenalised",
    "JointLimits",
    "JointPath",
    "Kinematics",
    "Layers",
    "LimitApproach",
    "LimitUse",
    "LogDet",
    "ManipplanError",
    "Mark",
    "Measure",
    "Mesh",
    "MissingExtraError",
    "MissingProgramError",
    "MissingSourcesError",
    "MotionFigures",
    "MoveAlong",
    "MoveTo",
    "NoPath",
    "Obstacle",
    "OutOfReachError",
    "OverTools",
    "PartialPlan",
    "PathClearance",
    "PathCost",
    "PathObjective",
    "PathPart",
    "PathResult",
    "PathShape",
    "PinocchioCasadi",
    "Plan",
    "PlanReport",
    "Plane",
    "PlanningError",
    "PointCloud",
    "PoseGoal",
    "PositionBox",
    "Posture",
    "Problem",
    "Program",
    "ProgramStep",
    "Refinement",
    "Report",
    "Robot",
    "RobotNotFetchedError",
    "Rollout",
    "Scene",
    "SearchResult",
    "Seeding",
    "Segment",
    "SmallestSingularValue",
    "SolutionSet",
    "Sphere",
    "Status",
    "SteadySpeed",
    "StepReport",
    "StepStatus",
    "StiffnessProfile",
    "SymbolicPose",
    "TakenToLimit",
    "Task",
    "TiltLimit",
    "Tolerance",
    "ToolFigure",
    "Tracking",
    "Trajectory",
    "UnknownNameError",
    "UnsupportedJointError",
    "VelocityTransmission",
    "Wait",
    "Yoshikawa",
    "available_measures",
    "available_robots",
    "carry",
    "check",
    "dynamic_ellipsoid",
    "fewest_interruptions",
    "follow",
    "force_ellipsoid",
    "formulations",
    "guilamo_search",
    "improve",
    "inverse_kinematics",
    "jerk_use",
    "limit_use",
    "load_robot",
    "max_min_search",
    "optimize_path",
    "path_cost",
    "pinocchio_casadi",
    "plan",
    "plan_many",
    "planar_arm",
    "refine",
    "retime",
    "sample_layers",
    "seed_path",
    "sequence",
    "torque_use",
    "track",
    "velocity_ellipsoid",
]
