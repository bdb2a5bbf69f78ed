"""PathResult: what the path optimiser returns."""

from dataclasses import dataclass, field

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.collision.path_clearance import path_clearance
from manipplan.constraints.constraint_set import ConstraintSet, figures, prove
from manipplan.cost.crossings import find_crossings, least_crossings, with_shares
from manipplan.cost.integral import PathCost, PathIntegral
from manipplan.measures.manipulability import Yoshikawa
from manipplan.measures.measure import Measure
from manipplan.optimize.certificate import Certificate, Optimality, _clearance, limit_approaches
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.display import one_line
from manipplan.support.status import Failure, Status
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True)
class Step:
    """One solve of the optimiser: the kind of its first path, its g, its clearance [m], and how the solver ended."""

    first: str
    g: float
    clearance: float
    solver: str


@one_line
@dataclass(frozen=True, kw_only=True)
class PathResult:
    """The result of `optimize_path`.

    Attributes:
        path: the JointPath; the seed when `status` says so.
        g: ∫ ‖q'‖_W / (m² + floor²)^(power/2) ds to ten digits: (6.6) in kth2012 with its exponent and a floor.
        length: length of the path in joint space [rad].
        min_manipulability: minimum manipulability on a dense grid [measure.unit(task)]; `min_at` is the s where it occurs.
        power, floor, task: exponent and floor of the objective, and task of its manipulability.
        seed, seed_cost: the collision-free first path (straight without a scene) and its cost, for comparison.
        history: all solves, in order; those in a coarse copy of the scene are called so.
        status: how the path came about.
        measure, metric: m, and W (n, n) or None for the identity.
        rivals: results of other seed classes and shifted goals, best first; each path differs from those before it.
        first_paths: number of first paths of this result's class. One of a class is optimised; that the others would lead to
            the same path is assumed.
        missing: estimated probability that one more first path leads to a path that is not among these, better or not: the
            share of first paths whose path no other one led to [good1953]. nan with a single first path to each goal, and of
            rivals.
        certificate: figures measured on the path.
    """

    path: JointPath
    g: float
    length: float
    min_manipulability: float
    min_at: float
    power: float
    task: Task
    seed: JointPath
    seed_cost: PathCost
    history: tuple[Step, ...]
    status: Status
    measure: Measure = field(default_factory=Yoshikawa)
    metric: Array | None = None
    floor: float = 0.0
    rivals: tuple["PathResult", ...] = ()
    first_paths: int = 1
    missing: float = np.nan
    certificate: Certificate | None = None


@one_line
@dataclass(frozen=True, kw_only=True)
class NoPath(Failure):
    """What `optimize_path` returns with throw=False when it finds no collision-free first path; `message` is the reason."""

    status: Status = Status.NO_PATH
    path: None = None
    seed: None = None
    g: float = np.inf


def make_result(
    path: JointPath,
    integral: PathIntegral,
    *,
    cost: PathCost,
    seed: JointPath,
    seed_cost: PathCost,
    model: CollisionModel | None,
    clearance: float,
    status: Status,
    solver: str = "",
    optimality: Optimality | None = None,
    unconstrained_g: float = np.nan,
    history: tuple[Step, ...] = (),
    constraints: ConstraintSet | None = None,
) -> PathResult:
    """The result for a path of known cost that came from `seed`, with every other figure measured on the path."""
    kinematics = integral.kinematics
    least, clearance_at, pair = _clearance(path, model)
    certificate = Certificate(
        status=status,
        solver=solver,
        projected_gradient=np.nan if optimality is None else optimality.projected_gradient,
        complementarity=np.nan if optimality is None else optimality.complementarity,
        active_clearance=np.nan if optimality is None else optimality.active_clearance,
        g=cost.g,
        unconstrained_g=unconstrained_g,
        power=integral.power,
        floor=integral.floor,
        measure=kinematics.measure.name,
        unit=kinematics.measure.unit(kinematics.task),
        min_manipulability=cost.min_manipulability,
        min_at=cost.at,
        clearance=least,
        clearance_at=clearance_at,
        nearest_pair=pair,
        proven_clearance=np.inf if model is None else path_clearance(model, path, clearance=clearance).lower,
        limits=limit_approaches(path, kinematics.robot),
        crossings=with_shares(find_crossings(path, integral, cost), path, integral, cost),
        least_crossings=least_crossings(kinematics, path.start, path.goal),
        constraints=() if constraints is None else figures(constraints, prove(constraints, path)),
    )
    return PathResult(
        path=path,
        g=cost.g,
        length=cost.length,
        min_manipulability=cost.min_manipulability,
        min_at=cost.at,
        power=integral.power,
        task=kinematics.task,
        measure=kinematics.measure,
        metric=integral.metric,
        floor=integral.floor,
        seed=seed,
        seed_cost=seed_cost,
        history=history,
        status=status,
        certificate=certificate,
    )
