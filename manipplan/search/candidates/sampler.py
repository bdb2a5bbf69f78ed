"""CandidateSampler: the candidates of one position, in this process or another one."""

import pickle
import threading
from functools import cached_property, lru_cache

import numpy as np

from manipplan.ik.enumeration import CHUNK
from manipplan.ik.nearest import Nearest, nearest_to
from manipplan.ik.solver import Solver
from manipplan.search.candidates.sampling import SamplingSpec
from manipplan.support.checks import Array
from manipplan.symbolic.task import Task

#: Maximum number of configurations whose distances are measured for a message.
MEASURED = 2000
#: Number of random configurations that show which pairs never have a distance to spare.
SHOWN = 50


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
        model, spec = self._own.model, self.spec
        free = ~model.in_collision_rows(q, clearance=spec.clearance)
        if spec.spare and not free.all() and self._tight.any():
            near = np.flatnonzero(~free)
            distances = model.distance_rows(q[near], beyond=spec.clearance)
            needed = np.where(self._tight, spec.clearance - spec.spare, spec.clearance)
            free[near] = ((distances > 0) & (distances >= needed)).all(axis=1)
        return np.asarray(free)

    @cached_property
    def _tight(self) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """The pairs (k,) that no configuration brings as far apart as candidates have to be, so that nothing is to be spared.

        An example is a link that turns in a gap of the link before.
        """
        assert self.collision is not None
        q = self.spec.robot.random_configuration(np.random.default_rng(0), size=SHOWN)
        found = self.collision.copy().distance_rows(q, beyond=self.spec.clearance)
        return np.asarray((found < self.spec.clearance).all(axis=0))

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

    def nearest(self, pose: Array) -> Nearest:
        """The configuration inside the limits that comes nearest to a pose (4, 4), collisions aside."""
        return nearest_to(self.spec.robot.kinematics(Task.pose(length=1.0), threads=1), self.solver.free, pose)


def _blocks(values: Array) -> list[Array]:
    return [values[begin : begin + CHUNK] for begin in range(0, len(values), CHUNK)]


@lru_cache(maxsize=2)
def _sampler_of(spec: bytes) -> CandidateSampler:
    """The sampler of a spec, built once per process."""
    return CandidateSampler(pickle.loads(spec))
