"""Classes of what the calls of the package return; a script reads them and seldom makes one."""

from manipplan.collision.path_clearance import PathClearance
from manipplan.constraints.constraint_set import ConstraintFigure
from manipplan.cost.crossings import Crossing
from manipplan.cost.integral import PathCost
from manipplan.goals.candidates import GoalCandidate
from manipplan.ik.solutions import Completeness, SolutionSet
from manipplan.kinematics.batch import Evaluator
from manipplan.optimize.certificate import Certificate, LimitApproach
from manipplan.optimize.result import NoPath, PathResult
from manipplan.paths.deviation import Deviation
from manipplan.plans.report import Comparison, MotionFigures, PathPart, PlanReport, Report, ToolFigure
from manipplan.plans.result import PartialPlan
from manipplan.programs.program import Mark
from manipplan.programs.steps import ProgramStep
from manipplan.robots.limits import TakenToLimit
from manipplan.search.interruptions import Interruptions
from manipplan.search.max_min import SearchResult
from manipplan.search.refine import Refinement
from manipplan.symbolic.backends import PinocchioCasadi
from manipplan.timing.constant_speed import SteadySpeed
from manipplan.timing.verify import LimitUse
from manipplan.tracking.controller import Rollout, StepReport
from manipplan.tracking.reference import Reference
from manipplan.tracking.servo import ServoGauge, ServoLimit, ServoStatus, Singularity
from manipplan.tracking.step import StepStatus
from manipplan.tracking.track import Tracking

__all__ = [
    "Certificate",
    "Comparison",
    "Completeness",
    "ConstraintFigure",
    "Crossing",
    "Deviation",
    "Evaluator",
    "GoalCandidate",
    "Interruptions",
    "LimitApproach",
    "LimitUse",
    "Mark",
    "MotionFigures",
    "NoPath",
    "PartialPlan",
    "PathClearance",
    "PathCost",
    "PathPart",
    "PathResult",
    "PinocchioCasadi",
    "PlanReport",
    "ProgramStep",
    "Reference",
    "Refinement",
    "Report",
    "Rollout",
    "SearchResult",
    "ServoGauge",
    "ServoLimit",
    "ServoStatus",
    "Singularity",
    "SolutionSet",
    "SteadySpeed",
    "StepReport",
    "StepStatus",
    "TakenToLimit",
    "ToolFigure",
    "Tracking",
]
