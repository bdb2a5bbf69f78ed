"""Where random starts for a pose lie: slides where the other joints bridge what is left to it, near the arm for far poses."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from manipplan.ik.bridge import bridge
from manipplan.ik.ranges import reach_in, slides_of, span, within_reach
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array

#: Number of reaches from which a pose is approached, by steps of this ratio.
FAR_AWAY, FARTHER = 30.0, 10.0


def window(robot: Robot, poses: Array) -> tuple[Array, Array]:
    """Limits lower and upper (n,), in which slides are confined to where one of poses (k, 4, 4) may be reached."""
    (lower, upper), slides = span(robot), list(slides_of(robot))
    if slides:
        lower[slides], upper[slides] = bridge(robot, tuple(slides), True).window(poses)
    return lower, upper


def approach(robot: Robot, pose: Array) -> list[tuple[Array, float]]:
    """Poses (4, 4) from near the arm to `pose`, in the same direction, and the share of its distance at which each is.

    Only poses that slides carry far beyond the other links are approached; for any other, it is the only one.
    """
    (lower, upper), slides = within_reach(robot), list(slides_of(robot))
    shares = [1.0]
    if slides:
        base = np.asarray(robot.model.jointPlacements[1].translation)
        away, reach = pose[:3, 3] - base, reach_in(robot, (lower, upper))[1]
        while shares[0] * np.linalg.norm(away) > FAR_AWAY * reach:
            shares.insert(0, shares[0] / FARTHER)
    poses = [pose] * len(shares)
    if len(shares) > 1:
        poses = [pose.copy() for _ in shares]
        for each, share in zip(poses, shares, strict=True):
            each[:3, 3] = base + share * away
    return list(zip(poses, shares, strict=True))


@dataclass(frozen=True, kw_only=True, eq=False)
class Starts:
    """Where random starts for a pose lie: between limits (n,), with the joints `slides` in one of boxes (k, g)."""

    limits: tuple[Array, Array]
    slides: tuple[int, ...]
    boxes: tuple[Array, Array]

    @classmethod
    def near(cls, robot: Robot, pose: Array, *, whole_pose: bool) -> "Starts":
        """Those for a pose (4, 4), or for its position alone."""
        slides = slides_of(robot)
        none = np.zeros((1, 0))
        boxes = bridge(robot, slides, whole_pose).around(pose) if slides else (none, none)
        return cls(limits=span(robot), slides=slides, boxes=boxes)

    def random(self, rng: np.random.Generator, count: int) -> Array:
        """Random configurations (count, n)."""
        q = rng.uniform(*self.limits, (count, len(self.limits[0])))
        if self.slides:
            chosen = rng.integers(len(self.boxes[0]), size=count)
            q[:, list(self.slides)] = rng.uniform(self.boxes[0][chosen], self.boxes[1][chosen])
        return q


class StartsOfPoses:
    """The `Starts` of poses, kept for the pose asked for last, as samples of one pose follow each other."""

    def __init__(self, robot: Robot, *, whole_pose: bool) -> None:
        self._robot, self._whole = robot, whole_pose
        self._pose: Array = np.zeros(0)
        self._starts: Starts | None = None

    def of(self, pose: Array) -> Starts:
        """Those of a pose (4, 4)."""
        if self._starts is None or not np.array_equal(pose, self._pose):
            self._pose, self._starts = pose.copy(), Starts.near(self._robot, pose, whole_pose=self._whole)
        return self._starts

    def random(self, poses: Array, rng: np.random.Generator) -> Array:
        """A random configuration (k, n) for each of poses (k, 4, 4)."""
        changes = np.flatnonzero(np.abs(np.diff(poses, axis=0)).max(axis=(1, 2), initial=0.0)) + 1
        edges = [0, *changes.tolist(), len(poses)]
        if not slides_of(self._robot):
            edges = [0, len(poses)]
        return np.concatenate([self.of(poses[a]).random(rng, b - a) for a, b in pairwise(edges)])


def random_near(robot: Robot, pose: Array, rng: np.random.Generator, count: int, *, whole_pose: bool = True) -> Array:
    """Random configurations (count, n), with slides where a pose (4, 4), or its position alone, may be reached."""
    return Starts.near(robot, pose, whole_pose=whole_pose).random(rng, count)
