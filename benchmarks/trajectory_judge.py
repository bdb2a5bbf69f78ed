"""The judge of check_trajectories.py, written with NumPy, Pinocchio and coal alone.

It samples densely where `mp.check` has closed forms, proofs and compiled kernels. Of the package it takes the limits and the
Pinocchio model of a robot, and the bodies and pairs of its collision model.
"""

from collections.abc import Sequence

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

import manipplan as mp

Array = NDArray[np.float64]
#: Number of samples of each cubic piece.
SAMPLES = 101
#: Maximum joint motion between two configurations at which all pairs are measured [rad or m].
STEP = 0.03
#: Distances above the smallest one up to which the way beside a local minimum is measured again, and up to which a pair is
#: measured there [m], and number of samples.
NEAR, PAIRS_NEAR, AGAIN = 0.03, 0.1, 15
#: Number of poses of a tool or a path that are compared, and weight of an angle in the search for the nearest [m/rad].
POSES, RADIAN = 1001, 0.1
#: Sudden changes of acceleration that do not count: a share of its limit; rounding of times [s], up to a larger share.
JUMP, NANOSECOND, MOST_JUMP = 1e-5, 1e-9, 1e-2


class Judge:
    """Measures motions of one robot among the bodies of its collision model."""

    def __init__(self, robot: mp.Robot, geometry: pin.GeometryModel) -> None:
        self.robot, self.geometry = robot, geometry
        self.data, self.placed = robot.model.createData(), pin.GeometryData(geometry)
        self.tool = robot.model.getFrameId(robot.tool)
        for k in range(len(geometry.collisionPairs)):
            self.placed.distanceRequests[k] = coal.DistanceRequest(True)
            self.placed.distanceRequests[k].gjk_tolerance = 1e-10

    def excesses(self, motion: mp.Trajectory) -> dict[str, float]:
        """By how much limits are exceeded, in rad or m for positions, as a share otherwise; negative where they are kept.

        That of jerk is inf where the acceleration jumps.
        """
        limits, q = self.robot.limits, dense(motion)
        found = {
            "position": np.maximum(limits.lower - q, q - limits.upper).max(),
            "velocity": (np.abs(samples(motion, 1)) / limits.velocity).max() - 1,
            "acceleration": (np.abs(samples(motion, 2)) / limits.acceleration).max() - 1,
            "jerk": jerk_ratio(motion, limits) - 1,
        }
        return {kind: float(value) for kind, value in found.items()}

    def touches(self, q: Array) -> bool:
        """Whether two bodies touch at one of few configurations (m, n)."""
        parts = self.robot.model, self.data, self.geometry, self.placed
        return any(pin.computeCollisions(*parts, each, True) for each in q)

    def smallest_distance(self, q: Array) -> float:
        """The smallest distance of a pair at dense configurations (m, n), first at a few, then beside each low minimum [m]."""
        few = spread(q, STEP)
        rows = np.array([self.distances(q[k]) for k in few])
        if not rows.size:
            return np.inf
        values, best = rows.min(axis=1), float(rows.min())
        pairs = np.flatnonzero(rows.min(axis=0) < best + PAIRS_NEAR).tolist()
        padded = np.concatenate([[np.inf], values, [np.inf]])
        for k in np.flatnonzero((values <= padded[:-2]) & (values <= padded[2:]) & (values < best + NEAR)):
            begin, end = few[max(k - 1, 0)], few[min(k + 1, len(few) - 1)]
            while end - begin > 1:
                inner = np.unique(np.linspace(begin, end, AGAIN).astype(int))
                found = np.array([self.distances(q[each], pairs).min() for each in inner])
                at, best = int(found.argmin()), min(best, float(found.min()))
                if len(inner) < AGAIN:
                    break
                begin, end = inner[max(at - 1, 0)], inner[min(at + 1, len(inner) - 1)]
        return best

    def distances(self, q: Array, pairs: Sequence[int] | None = None) -> Array:
        """Distances [m] of pairs, all by default, at q (n,)."""
        if pairs is None:
            pin.computeDistances(self.robot.model, self.data, self.geometry, self.placed, q)
            return np.array([each.min_distance for each in self.placed.distanceResults])
        pin.updateGeometryPlacements(self.robot.model, self.data, self.geometry, self.placed, q)
        return np.array([pin.computeDistance(self.geometry, self.placed, pair).min_distance for pair in pairs])

    def poses(self, q: Array) -> Array:
        """Poses (m, 4, 4) of the tool at q (m, n)."""
        found = []
        for each in q:
            pin.framesForwardKinematics(self.robot.model, self.data, each)
            found.append(self.data.oMf[self.tool].homogeneous.copy())
        return np.array(found)

    def tool_errors(self, q: Array, begin: Array, end: Array) -> tuple[float, float]:
        """Largest distance [m] and angle [rad] of the tool from a straight path of one rotation, from pose to pose (4, 4).

        Those of the path from the way of the tool, and those of the ends from each other, count as well.
        """
        tool = self.poses(q[np.unique(np.linspace(0, len(q) - 1, 2 * POSES).astype(int))])
        offset, along = tool[:, :3, 3] - begin[:3, 3], end[:3, 3] - begin[:3, 3]
        share = np.clip(offset @ along / (along @ along), 0.0, 1.0)
        turned = angles(tool[:, :3, :3], begin[:3, :3])
        distances = [np.linalg.norm(offset - share[:, None] * along, axis=1)]
        missed = []
        for s in np.linspace(0.0, 1.0, POSES):  # where the tool comes past
            apart = np.linalg.norm(offset - s * along, axis=1)
            k = int((apart + RADIAN * turned).argmin())
            missed.append((apart[k], turned[k]))
        ends = np.linalg.norm(tool[[0, -1], :3, 3] - np.array([begin, end])[:, :3, 3], axis=1)
        return float(np.max([*distances[0], *ends, *(each for each, _ in missed)])), float(turned.max())


def samples(motion: mp.Trajectory, order: int) -> Array:
    """The Hermite spline or a derivative at SAMPLES times of each piece (k - 1, SAMPLES, n)."""
    h = np.diff(motion.t)[:, None, None]
    u = np.linspace(0.0, 1.0, SAMPLES)[None, :, None]
    basis = (
        (2 * u**3 - 3 * u**2 + 1, u**3 - 2 * u**2 + u, 3 * u**2 - 2 * u**3, u**3 - u**2),
        (6 * u**2 - 6 * u, 3 * u**2 - 4 * u + 1, 6 * u - 6 * u**2, 3 * u**2 - 2 * u),
        (12 * u - 6, 6 * u - 4, 6 - 12 * u, 6 * u - 2),
        (12 + 0 * u, 6 + 0 * u, 0 * u - 12, 6 + 0 * u),
    )[order]
    q, qd = motion.q[:, None], motion.qd[:, None]
    return np.asarray((basis[0] * q[:-1] + basis[1] * h * qd[:-1] + basis[2] * q[1:] + basis[3] * h * qd[1:]) / h**order)


def dense(motion: mp.Trajectory) -> Array:
    """Configurations (m, n) at the same times, one after the other."""
    return samples(motion, 0).reshape(-1, motion.n)


def jerk_ratio(motion: mp.Trajectory, limits: mp.JointLimits) -> float:
    """The largest ratio of jerk to its limit; inf where the acceleration jumps."""
    bends, h = samples(motion, 2), np.diff(motion.t)
    jumps = np.abs(bends[1:, 0] - bends[:-1, -1])
    rounding = 6 * np.abs(motion.qd[1:-1]) * NANOSECOND * (h[1:] ** -2.0 + h[:-1] ** -2.0)[:, None]
    allowed = np.minimum(np.maximum(rounding, JUMP * limits.acceleration), MOST_JUMP * limits.acceleration)
    if (jumps > allowed).any():
        return np.inf
    return float((np.abs(samples(motion, 3)[:, 0]) / limits.jerk).max())


def spread(q: Array, step: float) -> NDArray[np.intp]:
    """Numbers of configurations (m, n), with first and last, between which no joint moves by much more than `step`."""
    gone = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(q, axis=0)).max(axis=1))])
    wanted = np.linspace(0.0, gone[-1], int(np.ceil(gone[-1] / step)) + 2)
    return np.unique(np.searchsorted(gone, wanted).clip(0, len(q) - 1))


def angles(rotations: Array, other: Array) -> Array:
    """Angles between rotations (m, 3, 3) and another one (3, 3) [rad]."""
    turned = np.swapaxes(rotations, 1, 2) @ other
    axis = np.stack([turned[:, 2, 1] - turned[:, 1, 2], turned[:, 0, 2] - turned[:, 2, 0], turned[:, 1, 0] - turned[:, 0, 1]])
    return np.asarray(np.arctan2(np.linalg.norm(axis, axis=0), np.trace(turned, axis1=1, axis2=2) - 1))
