"""manipplan: from a robot description and a task to a timed trajectory that keeps the arm far from singularities.

    URDF / MJCF / name -> Robot -> Kinematics(task): pose, J, manipulability m, its gradient and Hessian
                               -> Scene: collision and distance
    pose -> inverse_kinematics: every configuration that reaches it
    CartesianPath -> sample_layers -> max_min_search (the largest minimum manipulability) -> refine
    CartesianPath -> track (one QP per step, which raises m while following) -> Tracking
    start, goal -> seed_path (RRT-Connect) -> optimize_path (minimises ∫ ‖q'‖/m^p ds) -> retime (toppra) -> Trajectory -> Report

One call runs a whole row, for instance ``mp.plan(robot, start, goal, scene)``. ``mp.check(robot, trajectory, scene)`` judges a
Trajectory that anybody made.

Here is what a script writes. `measures` holds the measures of manipulability, `formulations` the ways to raise it while
tracking, `results` the classes of what calls return, `errors` all errors and warnings, `planar` the closed forms of the planar
arm, `viz` the pictures, `demo` the problems of `manipplan demo`.
"""

import importlib
from typing import TYPE_CHECKING

from manipplan import errors, measures, results
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Box, Capsule, Cylinder, Mesh, Obstacle, Plane, PointCloud, Sphere
from manipplan.constraints.constraint import Constraint, HeldJoints, PositionBox, SymbolicPose, TiltLimit
from manipplan.cost.integral import path_cost
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import PoseGoal
from manipplan.ik.solutions import inverse_kinematics
from manipplan.jobs import demo
from manipplan.jobs.carry import carry
from manipplan.jobs.check import check
from manipplan.jobs.follow import follow
from manipplan.jobs.improve import improve
from manipplan.jobs.plan import plan
from manipplan.jobs.plan_many import Problem, plan_many
from manipplan.jobs.sequence import sequence
from manipplan.kinematics.kinematics import Kinematics
from manipplan.optimize.optimize import optimize_path
from manipplan.paths.basis import PathShape
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import StiffnessProfile, Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.result import Plan
from manipplan.programs.program import Program
from manipplan.programs.steps import Attach, Detach, MoveAlong, MoveTo, Wait
from manipplan.robots.catalog import available_robots, load_robot, planar_arm
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.search.interruptions import fewest_interruptions
from manipplan.search.layers import Layers
from manipplan.search.max_min import max_min_search
from manipplan.search.refine import refine
from manipplan.search.sampling import sample_layers
from manipplan.seeds.seed import seed_path
from manipplan.seeds.seeding import PlannerProblem, Seeding
from manipplan.support.status import Status
from manipplan.symbolic.backends import pinocchio_casadi
from manipplan.symbolic.task import Task
from manipplan.timing.retime import retime
from manipplan.timing.stops import Segment
from manipplan.timing.verify import jerk_use, limit_use, torque_use
from manipplan.tracking import formulations
from manipplan.tracking.avoidance import Avoidance
from manipplan.tracking.controller import Controller
from manipplan.tracking.servo import Servo
from manipplan.tracking.track import track

if TYPE_CHECKING:
    from manipplan import planar, viz

__version__ = "0.2.0.dev0"

__all__ = [
    "Attach",
    "Avoidance",
    "Box",
    "Capsule",
    "CartesianPath",
    "Constraint",
    "Controller",
    "Cylinder",
    "Detach",
    "HeldJoints",
    "JointLimits",
    "JointPath",
    "Kinematics",
    "Layers",
    "Mesh",
    "MoveAlong",
    "MoveTo",
    "Obstacle",
    "PathObjective",
    "PathShape",
    "Plan",
    "Plane",
    "PlannerProblem",
    "PointCloud",
    "PoseGoal",
    "PositionBox",
    "Problem",
    "Program",
    "Robot",
    "Scene",
    "Seeding",
    "Segment",
    "Servo",
    "Sphere",
    "Status",
    "StiffnessProfile",
    "SymbolicPose",
    "Task",
    "TiltLimit",
    "Tolerance",
    "Trajectory",
    "Wait",
    "available_robots",
    "carry",
    "check",
    "demo",
    "errors",
    "fewest_interruptions",
    "follow",
    "formulations",
    "improve",
    "inverse_kinematics",
    "jerk_use",
    "limit_use",
    "load_robot",
    "max_min_search",
    "measures",
    "optimize_path",
    "path_cost",
    "pinocchio_casadi",
    "plan",
    "plan_many",
    "planar",
    "planar_arm",
    "refine",
    "results",
    "retime",
    "sample_layers",
    "seed_path",
    "sequence",
    "torque_use",
    "track",
    "viz",
]


def __dir__() -> list[str]:
    return [*__all__, "__version__"]


if not TYPE_CHECKING:  # else type checkers would accept any name

    def __getattr__(name: str) -> object:
        if name in ("planar", "viz"):  # imported when first used
            return importlib.import_module(f"manipplan.{name}")
        for space in (errors, formulations, measures, results):
            if name in space.__all__:
                raise AttributeError(f"manipplan has no {name}; it is manipplan.{space.__name__.rpartition('.')[2]}.{name}")
        raise AttributeError(f"module 'manipplan' has no attribute {name!r}")
