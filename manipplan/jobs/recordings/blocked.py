"""Whether a body that moves with the tool stays in an obstacle wherever in the tube the tool is: no motion is possible then."""

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel
from manipplan.collision.near_pairs import apart_text
from manipplan.jobs.recordings.comparison import held
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.model_tree import frame_index
from manipplan.support.checks import Array
from manipplan.symbolic.task import Task

#: Maximum number of samples of a recording that are looked at.
SAMPLES = 2000


def blocked(model: CollisionModel, motion: Trajectory, tolerance: Tolerance, task: Task, clearance: float) -> str:
    """Why the tube leaves no motion: the two bodies, their overlap, the time, and how far the one can move; "" where it may.

    A point of a body that moves with the tool moves by at most r + 2 sin(ρ/2) d inside a tube of the radii r and ρ, with its
    distance d from the tool. The distances of convex bodies, and their depths where they overlap, change by no more than that.
    """
    robot, kernel = model.robot, model.kernel_copy()
    pairs, levers = _pairs_of_tool(model)
    if kernel is None or not len(pairs) or len(robot.tools) > 1:
        return ""
    position, rotation = held(task)
    if not position or tolerance.position is None or task.relative_to is not None:
        return ""
    is_turned = rotation and tolerance.rotation is not None and task.free_axis is None
    angle = tolerance.rotation if is_turned and tolerance.rotation is not None else np.pi
    reach = tolerance.position + 2 * np.sin(min(angle, np.pi) / 2) * levers
    rows = np.unique(np.linspace(0, len(motion.t) - 1, SAMPLES).astype(np.int64))
    q = np.repeat(motion.q[rows], len(pairs), axis=0)
    found = kernel.pair_distances(q, np.tile(pairs, len(rows)), np.full(len(q), max(clearance, 0.0)))
    short = clearance - reach - found.reshape(len(rows), len(pairs))
    short = np.where(np.isnan(short), -np.inf, short)
    row, pair = (int(k) for k in np.unravel_index(np.argmax(short), short.shape))
    if short[row, pair] <= 0:
        return ""
    first, second = model.pair_names[pairs[pair]]
    apart = apart_text(float(found.reshape(short.shape)[row, pair]))
    return (
        f"on the recording {first} and {second} {apart} at {motion.t[rows[row]]:.3f} s, and inside the tolerance no point of "
        f"{first} moves by more than {1e3 * reach[pair]:.3g} mm"
    )


def _pairs_of_tool(model: CollisionModel) -> tuple[NDArray[np.int64], Array]:
    """Indices (k,) of the pairs of a convex body that moves with the tool and an obstacle, and levers (k,) [m].

    A lever is the largest distance of the body's points from the tool.
    """
    robot = model.robot
    frame = robot.model.frames[frame_index(robot.model, robot.tool)]
    objects = model.geometry.geometryObjects
    pairs, levers = [], []
    for k, pair in enumerate(model.geometry.collisionPairs):
        first, second = objects[pair.first], objects[pair.second]
        mine, other = (first, second) if second.parentJoint == 0 else (second, first)
        if mine.parentJoint != frame.parentJoint or other.parentJoint != 0 or {pair.first, pair.second} & set(model.solids):
            continue
        mine.geometry.computeLocalAABB()
        centre = mine.placement.act(np.asarray(mine.geometry.aabb_center).ravel())
        around = mine.geometry.aabb_radius + max(model.radii.get(pair.first, 0.0), model.radii.get(pair.second, 0.0))
        pairs.append(k)
        levers.append(float(np.linalg.norm(centre - frame.placement.translation)) + around)
    return np.array(pairs, dtype=np.int64), np.array(levers)
