"""PathResult: what the path optimiser returns."""

from dataclasses import dataclass, field

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.cost.objective import PathCost, PathObjective
from manipplan.measures.indices import Yoshikawa
from manipplan.measures.measure import Measure
from manipplan.optimize.certificate import Certificate, Optimality
from manipplan.optimize.local import Step
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.status import Status
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True)
class PathResult:
    """The result of `optimize_path`.

    Attributes:
        path: the JointPath; the seed when `status` says so, None when there is none (NO_PATH, with throw=False).
        g: ∫ ‖q'‖_W / m^power ds to ten digits: (6.6) in kth2012 with its exponent as a parameter.
        length: length of the path in joint space [rad].
        min_manipulability: minimum manipulability on a dense grid [measure.unit(task)]; `min_at` is the s where it occurs.
        power, task: exponent of the objective, and task of its manipulability.
        seed, seed_cost: the collision-free first path (straight without a scene) and its cost, for comparison.
        history: all solves, in order.
        status: how the path came about.
        measure, metric: m, and W (n, n) or None for the identity.
        rivals: results of other seed classes and shifted goals, best first; each path differs from those before it.
        certificate: figures measured on the path; None when there is no path.
    """

    path: JointPath | None
    g: float
    length: float
    min_manipulability: float
    min_at: float
    power: float
    task: Task
    seed: JointPath | None
    seed_cost: PathCost
    history: tuple[Step, ...]
    status: Status
    measure: Measure = field(default_factory=Yoshikawa)
    metric: Array | None = None
    rivals: tuple["PathResult", ...] = ()
    certificate: Certificate | None = None


def make_result(
    path: JointPath,
    objective: PathObjective,
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
) -> PathResult:
    """The result for a path of known cost that came from `seed`, with every other figure measured on the path."""
    certificate = Certificate.of(
        path,
        objective,
        cost,
        model,
        clearance=clearance,
        status=status,
        solver=solver,
        optimality=optimality,
        unconstrained_g=unconstrained_g,
    )
    return PathResult(
        path=path,
        g=cost.g,
        length=cost.length,
        min_manipulability=cost.min_manipulability,
        min_at=cost.at,
        power=objective.power,
        task=objective.kinematics.task,
        measure=objective.kinematics.measure,
        metric=objective.metric,
        seed=seed,
        seed_cost=seed_cost,
        history=history,
        status=status,
        certificate=certificate,
    )


def no_path(objective: PathObjective) -> PathResult:
    """The result when there is no collision-free seed."""
    nothing = PathCost(g=np.inf, length=np.inf, min_manipulability=0.0, at=0.0)
    return PathResult(
        path=None,
        g=np.inf,
        length=np.inf,
        min_manipulability=0.0,
        min_at=0.0,
        power=objective.power,
        task=objective.kinematics.task,
        measure=objective.kinematics.measure,
        metric=objective.metric,
        seed=None,
        seed_cost=nothing,
        history=(),
        status=Status.NO_PATH,
    )
