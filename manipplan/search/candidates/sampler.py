"""CandidateSampler: the candidates of one position, in this process or another one."""

import pickle
import threading
from functools import lru_cache

import numpy as np

from manipplan.ik.enumeration import CHUNK
from manipplan.ik.solver import Solver
from manipplan.ik.window import random_near
from manipplan.paths.deviation import distances_between
from manipplan.search.candidates.sampling import SamplingSpec
from manipplan.support.checks import Array

#: Number of random starts for the nearest miss of a pose.
STARTS = 40
#: Maximum number of configurations whose distances are measured for a message.
MEASURED = 2000
#: Distance within which a joint counts as being at its limit [rad or m].
AT_LIMIT = 1e-6


class CandidateSampler:
    """Samples positions for one spec; thread-safe, and pickled as its spec."""

    def __init__(self, spec: SamplingSpec) -> None:
        self.spec = spec
        robot = spec.robot
        self.solver = Solver.of(robot, task=spec.task, held=spec.held, method=spec.method, seed=spec.seed)
        self.kinematics = robot.kinematics(self.solver.task, measure=spec.measure, threads=1)
        self.collision = spec.collision_model()
        self._own = threading.local()
        few = robot.random_configuration(np.random.default_rng(0), size=2)
        self.kinematics.manipulability(few)  # compiled before threads use it
        self.solver.kinematics.pose(few)

    def __reduce__(self) -> tuple[object, ...]:
        return _sampler_of, (pickle.dumps(self.spec),)

    def sample(self, pose: Array, values: Array) -> tuple[Array, Array, int]:
        """Candidates q (k, n) that reach `pose` for parameters (s, r), manipulability (k,), and the number before checks."""
        blocks, reached = [np.zeros((0, self.spec.robot.n))], 0
        for some in _blocks(values):
            q = self.solver.solve_once(pose[None], np.zeros(len(some), dtype=np.int64), some).q
            reached += len(q)
            blocks.append(q[self._free(q)])
        _, q = self.solver.with_turns(np.concatenate(blocks))  # full turns change no collisions
        return q, self.kinematics.manipulability(q), reached

    def _free(self, q: Array) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        if self.collision is None:
            return np.ones(len(q), dtype=np.bool_)
        if not hasattr(self._own, "model"):
            self._own.model = self.collision.copy()
        return np.asarray(~self._own.model.in_collision_rows(q, clearance=self.spec.clearance))

    def widest(self, pose: Array, values: Array) -> tuple[float, tuple[str, str]]:
        """The largest of the smallest distances [m] at up to MEASURED configurations that reach `pose`, and its pair."""
        assert self.collision is not None
        q = np.concatenate(
            [self.solver.solve_once(pose[None], np.zeros(len(some), dtype=np.int64), some).q for some in _blocks(values)]
        )
        q = q[:: -(-len(q) // MEASURED)]
        least = [self.collision.least_distance(each[None]) for each in q]
        apart, _, pair = max(least)
        return apart, self.collision.pair_names[pair]

    def nearest_miss(self, pose: Array) -> tuple[float, float, list[str]]:
        """Smallest error to a pose over random starts [m, rad], and the joints that are at a limit there."""
        from scipy.optimize import least_squares

        from manipplan.search.program import PoseRows

        solver, robot = self.solver, self.spec.robot
        limits, rows, target = robot.limits, PoseRows(self.kinematics), pose[None]
        slopes = rows.error.jacobian()

        def errors(q: Array) -> Array:
            return np.asarray(rows.errors(q[None], target)[0])

        def jacobian(q: Array) -> Array:
            return np.asarray(slopes(q, pose.T.ravel(), 0)[0])

        options = {"bounds": (limits.lower, limits.upper), "xtol": 1e-12, "ftol": 1e-14, "gtol": 1e-14}
        starts = random_near(robot, pose, np.random.default_rng(0), STARTS)
        q = np.array([least_squares(errors, start, jacobian, **options).x for start in starts])
        far, angle = distances_between(solver.kinematics.pose(q), np.tile(pose, (STARTS, 1, 1)), solver.free)
        best = int(np.argmin(far**2 + angle**2))
        stopped = np.minimum(q[best] - limits.lower, limits.upper - q[best]) < AT_LIMIT
        names = [name for name, at in zip(robot.joint_names, stopped, strict=True) if at]
        return float(far[best]), float(angle[best]), names


def _blocks(values: Array) -> list[Array]:
    return [values[begin : begin + CHUNK] for begin in range(0, len(values), CHUNK)]


@lru_cache(maxsize=2)
def _sampler_of(spec: bytes) -> CandidateSampler:
    """The sampler of a spec, built once per process."""
    return CandidateSampler(pickle.loads(spec))
