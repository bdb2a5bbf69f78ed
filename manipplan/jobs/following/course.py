"""RefinedToolPath: the joint path along a workspace path, found by the search, refined, and joined between its positions."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from manipplan.collision.model import CollisionModel
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import BETWEEN, Tolerance
from manipplan.search.layers import Layers
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.search.refine import Refinement, refine
from manipplan.search.sampling import sample_layers
from manipplan.support.checks import Array
from manipplan.support.progress import Progress

#: Share of a tolerance that is used at the positions, and between them before knots are added: timing needs some of it, too.
AT_POSITIONS, IN_TUBE = 0.9, 0.97
#: The latter if no tolerance is given.
AT_KNOTS = 0.5


@dataclass(frozen=True, kw_only=True, eq=False)
class RefinedToolPath:
    """A joint path along a workspace path, over the same s.

    Attributes:
        search: the path found among the candidates.
        refinement: that path, refined.
        path: the spline through its configurations.
        seed: the same for the path that the search found.
    """

    search: SearchResult
    refinement: Refinement
    path: JointPath
    seed: JointPath


@dataclass(frozen=True, kw_only=True, eq=False)
class ToolPathPlanner:
    """What courses along one workspace path share.

    Attributes:
        path: the workspace path.
        layers: candidates at its positions, with their sampler.
        tolerance: what was asked for; None: the default.
        samples: number of grid points of the redundancy, as in `sample_layers`.
    """

    path: CartesianPath
    layers: Layers
    tolerance: Tolerance | None
    samples: int | Sequence[int] | None = None

    def is_at_start(self, q: Array) -> bool:
        """Whether the tool stands at the first pose at q (n,): near enough for a spline that goes on inside the tolerance."""
        from manipplan.search.program import PoseRows

        assert self.layers.sampler is not None
        rows = PoseRows(self.layers.sampler.kinematics)
        wide = AT_KNOTS * rows.box(BETWEEN)
        if self.tolerance is not None:
            wide = np.maximum(wide, rows.box(self.tolerance.scaled(AT_POSITIONS)))
        return bool((np.abs(rows.errors(q[None], self.path(np.zeros(1)))) <= AT_POSITIONS * wide).all())

    def starting_at(self, q: Array) -> "ToolPathPlanner":
        """The same with q (n,) as only candidate at the first position, at the pose that it reaches."""
        assert self.layers.sampler is not None and self.layers.poses is not None
        kinematics, poses = self.layers.sampler.kinematics, self.layers.poses.copy()
        poses[0] = kinematics.pose(q)
        configurations = (np.array(q[None]), *self.layers.q[1:])
        m = (np.array([float(kinematics.manipulability(q))]), *self.layers.m[1:])
        return replace(self, layers=replace(self.layers, q=configurations, m=m, poses=poses))

    def between(self, first: int, last: int) -> "ToolPathPlanner":
        """The same for the part of the path from one position to another, which may be beyond the last one of a closed path."""
        layers = self.layers
        assert layers.s is not None and layers.poses is not None
        turned = np.arange(first, last + 1)
        k, s = turned % len(layers.q), layers.s[turned % len(layers.q)] + turned // len(layers.q)
        begin, end = float(s[0]), float(s[-1])
        some = replace(
            layers,
            q=tuple(layers.q[i] for i in k),
            m=tuple(layers.m[i] for i in k),
            closed=False,
            s=np.concatenate([[0.0], (s[1:-1] - begin) / (end - begin), [1.0]]),
            poses=layers.poses[k],
        )
        return replace(self, path=self.path.part(begin, end), layers=some)

    def along(self, found: SearchResult, progress: Progress, *, hold_start: bool = False) -> RefinedToolPath:
        """The course through the positions of a path that the search found; `hold_start` keeps its first configuration."""
        inner = self.tolerance.scaled(AT_POSITIONS) if self.tolerance is not None else None
        refined = refine(self.layers, found, tolerance=inner, hold_start=hold_start, progress=progress)
        path, seed = self._joined(refined.q, self.tolerance), self._joined(found.q, None)
        return RefinedToolPath(search=found, refinement=refined, path=path, seed=seed)

    def in_the_way(self, found: SearchResult) -> str:
        """Where no path was found: the bodies that are in the way, if there is a path without them, for a message."""
        sampler = self.layers.sampler
        assert sampler is not None and self.layers.s is not None
        if sampler.collision is None:
            return ""
        spec = sampler.spec
        through = sample_layers(
            spec.robot,
            self.path,
            self.layers.s,
            task=spec.task,
            measure=spec.measure,
            samples=self.samples,
            collisions=False,
            closed=self.layers.closed,
            seed=spec.seed,
        )
        if len(self.layers.q[0]) == 1:
            through = replace(self, layers=through).starting_at(self.layers.q[0][0]).layers
        free = max_min_search(through, found.epsilon, strict=found.strict, explain=False, throw=False)
        if not free.connected:
            return ""
        needed = f", and {1e3 * spec.clearance:.4g} mm are needed" if spec.clearance else ""
        return f"; without bodies in the way there is a motion, on which {nearest_pair(sampler.collision, free.q)}{needed}"

    def _joined(self, q: Array, tolerance: Tolerance | None) -> JointPath:
        """The joint path through q (L, n). With a tolerance they are joined as they are while their spline stays inside it."""
        from manipplan.search.program import PoseRows, joint_path
        from manipplan.search.sweep import full_turns

        layers = self.layers
        assert layers.sampler is not None and layers.s is not None
        rows, s = PoseRows(layers.sampler.kinematics), layers.s
        allowed = AT_KNOTS * rows.box(BETWEEN)
        tube = None
        if tolerance is not None:
            allowed = np.maximum(allowed, IN_TUBE * rows.box(tolerance))
            tube = tolerance.scaled(AT_POSITIONS / np.sqrt(3))  # inside the box of the rows
        if layers.closed:
            s, q = np.append(s, 1.0), np.vstack([q, q[0] + full_turns(q, layers.continuous)])  # the way back to the start
        return joint_path(layers.sampler.solver, rows, self.path, s, q, closed=layers.closed, allowed=allowed, tube=tube)


def nearest_pair(model: CollisionModel, q: Array) -> str:
    """The nearest two bodies at configurations (k, n) along a path, and at which share of it."""
    bodies, row = model.nearest_bodies(q)
    return f"{bodies} at {row / max(len(q) - 1, 1):.2f} of the path"
