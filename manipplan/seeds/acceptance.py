"""Which paths are accepted as seeds: proven free, within constraints, with no more crossings of singularities than allowed."""

import logging
from collections.abc import Callable

import numpy as np

from manipplan.collision.path_clearance import path_clearance
from manipplan.constraints.constraint import KEPT
from manipplan.constraints.proof import prove
from manipplan.paths.joint import JointPath
from manipplan.seeds.task import SeedTask
from manipplan.support.checks import Array

log = logging.getLogger("manipplan")

#: Maximum joint motion between two checks of a finished path [rad or m].
CHECK_STEP = 1e-3
#: The same for the look at a path before its proof, which begins with every FIRST-th configuration.
LOOK_STEP, FIRST = 0.05, 8
#: Maximum joint motion between two configurations whose sides of the singularities are compared [rad or m].
SIDES_STEP = 5e-3
#: Minimum distance of the ends beyond the clearance for a proof [m]; the proof's own tolerances take as much.
PROVABLE = 1e-4


def acceptance(task: SeedTask) -> Callable[[JointPath], bool]:
    """The acceptance test of a seed: proven free, or free at every milliradian if an end is too near contact for a proof.

    A look at samples comes first, since it refutes most paths that are not free in much less time.
    """
    if min(task.distances) <= task.clearance + PROVABLE:
        log.info("start or goal is too close to contact for a proof; the seed is checked at every milliradian")
        return lambda path: looks_free(task, path) and keeps_constraints(task, path) and is_free(task, path)

    def is_proven(path: JointPath) -> bool:
        if not (looks_free(task, path) and keeps_constraints(task, path)):
            return False
        return path_clearance(task.model, path, clearance=task.clearance, tolerance=None).proven

    return is_proven


def crossing_limit(task: SeedTask) -> Callable[[JointPath], bool]:
    """Whether a path crosses singularities no more often than allowed."""
    sides, most = task.sides, task.most_crossings
    if sides is None or most is None:
        return lambda _: True
    return lambda path: sides.changes(configurations(path, SIDES_STEP)) <= most


def keeps_constraints(task: SeedTask, path: JointPath) -> bool:
    """Whether the path keeps the constraints everywhere, as `prove` says."""
    return task.constraints is None or prove(task.constraints, path).kept


def looks_free(task: SeedTask, path: JointPath) -> bool:
    """Whether the path is free and keeps the constraints at samples."""
    q = configurations(path, LOOK_STEP)
    if task.constraints is not None and task.constraints.values(q).min(initial=0.0) < -KEPT:
        return False
    few = q[FIRST // 2 :: FIRST]
    return not any(task.model.in_collision_rows(rows, clearance=task.clearance).any() for rows in (few, q))


def is_free(task: SeedTask, path: JointPath) -> bool:
    """Whether the path is free at every milliradian, and the proof found no contact in between."""
    return (
        task.model.path_is_free(path, CHECK_STEP, task.clearance)
        and not path_clearance(task.model, path, clearance=task.clearance, tolerance=None).refuted
    )


def configurations(path: JointPath, step: float) -> Array:
    """Configurations (m, n) along a path; between neighbours no joint moves by more than `step` [rad or m].

    In a Bernstein piece no joint is faster than the degree times the largest difference of neighbouring control points.
    """
    most = path.degree * np.abs(np.diff(path.control, axis=1)).max(axis=(1, 2))
    counts = np.maximum(1, np.ceil(most / step)).astype(int)
    first = np.cumsum(counts) - counts
    share = (np.arange(counts.sum()) - np.repeat(first, counts)) / np.repeat(counts, counts)
    s = np.repeat(path.breaks[:-1], counts) + share * np.repeat(np.diff(path.breaks), counts)
    return path(np.append(s, 1.0))
