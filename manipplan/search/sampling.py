"""sample_layers: the configurations that reach each position of a workspace path, filtered by collision and rated.

CandidateSampler: the candidates of one position, in this process or another one.
"""

import math
import pickle
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ThreadPoolExecutor, wait
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel, apart_text
from manipplan.collision.scene import Scene
from manipplan.ik.newton import Nearest, millimetres_hint, nearest_to
from manipplan.ik.solutions import apart
from manipplan.ik.solver import Found, Solver
from manipplan.kinematics.batch import all_cores
from manipplan.measures.measure import Measure
from manipplan.paths.cartesian import CartesianPath
from manipplan.robots.robot import Robot
from manipplan.search.layers import Layers, check_positions, count_positions
from manipplan.search.sweep import check_epsilon
from manipplan.support.checks import Array, ArrayLike, finite_array, flag, instance, number, pose_matrix
from manipplan.support.deadline import NEVER, Cancellation, Deadline
from manipplan.support.errors import InvalidInputError, OutOfReachError
from manipplan.support.progress import Progress, as_callback
from manipplan.support.workers import usable_memory
from manipplan.symbolic.task import Task


@dataclass(frozen=True, kw_only=True, eq=False)
class PositionSample:
    """The candidates q (k, n) of one position, their manipulability m (k,), and how many there were before checks."""

    q: Array
    m: Array
    reached: int


@dataclass(frozen=True, kw_only=True, eq=False)
class SamplingSpec:
    """The arguments of `sample_layers` that define a candidate; `clearance` includes the spare one."""

    robot: Robot
    task: Task | None
    measure: Measure | str | None
    held: Sequence[str] | None
    method: str
    scene: Scene
    collisions: bool
    clearance: float
    spare: float
    seed: int

    def collision_model(self) -> CollisionModel | None:
        """The model that candidates are checked with; None where they are not checked."""
        return self.scene.collision_model(self.robot) if self.collisions else None


#: Number of samples that one job solves, and that are solved, or checked for collisions, between two looks at the deadline.
JOB, BLOCK = 8192, 1024
#: Time between reports of progress [s].
REPORT = 0.05
#: How often the distance between two samples is halved where their solutions are apart.
HALVINGS = 7
#: Range of a joint from which on one of its full turns is searched first [rad].
WIDE = 3 * np.pi
#: Difference from a full turn that counts as none [rad].
EVEN = 1e-6
#: Default number of samples per parameter, for one, two, three, ... parameters. For three and more it is smaller, but at least
#: FEWEST, where they would give more than ENOUGH candidates.
SAMPLES = (720, 96, 36, 16, 9, 6)
FEWEST, ENOUGH = 5, 1e6
#: Number of candidates within a region at all positions, and fewest and most samples at each.
IN_REGION = (1e6, 64, 4000)
#: The same for arms without a closed form, whose solutions are searched: some 2.5 ms for a sample. With one parameter of a full
#: turn their distance is just below an ε of 0.2. And for arms with fewer than six joints, of which only rows are solved for.
SEARCHED, FEW_SAMPLES = (32, 10, 5, 4, 3), (48, 12, 6, 4)
#: Differences from the parameters of a given configuration, for each parameter [rad or m].
BESIDE = (-0.2, -0.1, 0.0, 0.1, 0.2)
#: Share of the machine's memory that candidates may take.
MEMORY = 0.5
#: Number of positions, and of samples at each, from which the number of candidates is estimated.
PROBES, PROBE = 3, 2000
#: Memory per grid point while the grid is built [bytes].
GRID = 200
#: Tolerances within which a pose is within reach [m, rad].
REACHES = (1e-6, 1e-6)


def sample_layers(
    robot: Robot,
    path: CartesianPath,
    positions: int | ArrayLike = 50,
    *,
    task: Task | None = None,
    measure: Measure | str | None = None,
    samples: int | Sequence[int] | None = None,
    held: Sequence[str] | None = None,
    method: str = "auto",
    scene: Scene | None = None,
    collisions: bool = True,
    clearance: float = 0.0,
    spare: float = 0.0,
    spacing: ArrayLike | None = None,
    closed: bool = False,
    near: ArrayLike | None = None,
    executor: Executor | None = None,
    memory: float | None = None,
    seed: int = 0,
    progress: Progress | None = None,
) -> Layers:
    """Sample all configurations that reach positions along a path, on a grid over the arm's redundant parameters.

    Args:
        robot: the arm.
        path: of the tool.
        positions: number of positions, equally spaced in s, or their s (L,), from 0 to 1; with `closed`, the last one does not
            repeat the first.
        task: Task.pose(), the default, or one that leaves a motion of the tool free, such as Task.pointing(axis) or
            Task.position(); this is sampled as well. The manipulability of candidates is that of this task.
        measure: of manipulability; see `Robot.kinematics`.
        samples: number of grid points, one number, or one per parameter of `inverse_kinematics` (held joints, swivel, free
            motion). Along a path that keeps to one value of a parameter its steps can be any; else they have to be below the ε
            of the search. None: 720 for one parameter, 96 for two, and for more as many as give about a million candidates;
            32, 10, 5, ... for arms without closed form; 48, 12, 6, ... for arms with fewer than six joints and a free motion.
            With a free motion, samples that keep the whole pose are added. Random starts are tried at a position that no
            sample reaches.
        held, method, seed: as in `inverse_kinematics`.
        scene: obstacles; default None.
        collisions: whether candidates in collision with an obstacle or with the arm itself are dropped.
        clearance: minimum distance [m] of candidates to obstacles and between the arm's own links.
        spare: distance [m] beyond the clearance that candidates keep, for the motion between positions.
        spacing: of an arm with a closed form and one parameter, samples are added where a solution has none at the next sample
            whose joints all differ by less [rad or m], one number or (n,): where a branch of solutions turns back, ends, or
            moves fast. So branches that meet between two samples are connected. None: the grid stays as it is.
        closed: whether the path returns to its start, so that the motion has to as well.
        near: (n,) a configuration in which the motion may begin; of an arm with several parameters, values of them around those
            of this configuration are added at every position.
        executor: where positions are sampled: threads of this process by default; processes, or a Dask client's
            `get_executor()`.
        memory: maximum memory of the candidates [bytes]; default: half of what the process may use.
        progress: called with the share done in [0, 1] and a text.

    Raises:
        InvalidInputError: an argument is not usable; the bodies of all candidates are too near at a position (the message
            gives the two that are too near in the best case, and their distance); the candidates would exceed the memory, as
            estimated before the work starts.
        OutOfReachError: no configuration reaches a position; `nearest` is the one that comes nearest, with its error.
    """
    instance("robot", robot, Robot)
    if not isinstance(path, CartesianPath):
        raise InvalidInputError("path", path, "a CartesianPath")
    for name, value in (("closed", closed), ("collisions", collisions)):
        flag(name, value)
    if closed and not path.closes:
        raise InvalidInputError("closed", closed, "False, as the path's last pose is not its first")
    spec = SamplingSpec(
        robot=robot,
        task=task,
        measure=measure,
        held=held,
        method=method,
        scene=instance("scene", scene if scene is not None else Scene(), Scene),
        collisions=collisions,
        clearance=number("clearance", clearance, least=0.0) + number("spare", spare, least=0.0),
        spare=spare,
        seed=seed,
    )
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InvalidInputError("executor", executor, "a concurrent.futures.Executor, or None")
    notify = as_callback(progress)
    between = None if spacing is None else check_epsilon(spacing, robot.continuous_joints, "spacing")
    allowed = number("memory", memory, above=0.0) if memory is not None else MEMORY * usable_memory()
    sampler = CandidateSampler(spec)
    n = count_positions(positions)
    usual = default_samples(sampler.solver)
    _check_grid(sampler, n, samples, usual, allowed)
    s = check_positions(positions, closed=closed)
    is_default = samples is None
    if samples is None and sampler.solver.free.bounds is not None and sampler.solver.form is not None:
        most = min(max(IN_REGION[0] / (n * sampler.solver.most), IN_REGION[1]), IN_REGION[2])
        samples = [max(int(most ** (1 / len(sampler.solver.sampled_names))), FEWEST)] * len(sampler.solver.sampled_names)
    poses = np.array([pose_matrix(f"path, position {k} of 0 to {n - 1}", pose) for k, pose in enumerate(path(s))])
    values = sampler.solver.grid(samples, usual, poses)
    share = _share_found(sampler, poses, values, allowed)
    if samples is None and len(sampler.solver.names) > 2 and share * len(values) * n > ENOUGH:
        most = int((ENOUGH / (share * n)) ** (1 / len(sampler.solver.names)))
        values = sampler.solver.grid(max(most, FEWEST), usual, poses)
    near_values = np.zeros((0, len(sampler.solver.names)))
    if near is not None and sampler.solver.has_several_parameters:
        q = finite_array("near", near, (robot.n,))
        near_values = sampler.solver.parameters_of(q[None], poses[:1])[0] + _offsets(len(sampler.solver.names))
    sampling = PathSampling(
        sampler=sampler,
        path=path,
        values=values,
        near=near_values,
        whole=usual if is_default else None,
        at_random=is_default,
        spacing=between,
        executor=executor,
    )
    sets = sampling.sets(poses)
    _check_memory(sampler, n, values, share * sum(map(len, sets)), allowed)
    found = sampling.at(poses, sets, lambda k: f"path, position {k} of 0 to {n - 1} (s = {s[k]:.4g})", notify)
    return Layers(
        q=tuple(each.q for each in found),
        m=tuple(each.m for each in found),
        continuous=robot.continuous_joints,
        closed=closed,
        s=s,
        poses=poses,
        considered=sum(map(len, sets)),
        sampling=sampling,
        turn_middles=_turn_middles(sampler.solver),
    )


def _turn_middles(solver: "Solver") -> Array | None:
    """The middle of the limits of joints whose configurations are listed at several full turns (n,), nan for others."""
    limits = solver.robot.limits
    ranges = limits.upper - limits.lower
    several = [j for j in solver.turning if WIDE <= ranges[j] < np.inf]
    middles = np.full(solver.robot.n, np.nan)
    middles[several] = (limits.lower[several] + limits.upper[several]) / 2
    return middles if several else None


@dataclass(frozen=True, kw_only=True, eq=False)
class PathSampling:
    """How the positions of one path are sampled, so that more of them can be.

    Attributes:
        sampler: finds the candidates of a position.
        path: of the tool.
        values: (s, r) parameters of redundancy that are tried at each position.
        near: (k, r) more of them, near a given configuration.
        whole: default numbers of samples, where samples that keep the whole pose are added; else None.
        at_random: whether random starts are tried at a position that no sample reaches.
        spacing, executor: as in `sample_layers`.
    """

    sampler: "CandidateSampler"
    path: CartesianPath
    values: Array
    near: Array
    whole: Sequence[int] | None
    at_random: bool
    spacing: Array | None
    executor: Executor | None

    def sets(self, poses: Array) -> list[Array]:
        """The parameters (s, r) that are tried at each of poses (p, 4, 4)."""
        sets = [np.vstack([self.values, self.near])] * len(poses)
        if self.whole is None:
            return sets
        # a motion through whole poses is among those with a free motion
        whole = self.sampler.solver.whole_poses(self.whole, poses)
        return [np.vstack([each, more]) if len(more) else each for each, more in zip(sets, whole, strict=True)]

    def at(self, poses: Array, sets: Sequence[Array], name: Callable[[int], str], notify: Progress) -> "list[PositionSample]":
        """The candidates at poses (p, 4, 4) for their `sets`; name(k) is in the error that says why there are none."""
        found = list[PositionSample]()
        with ExitStack() as stack:
            cancellation = Cancellation()  # processes, other than threads, end the jobs that they have begun
            run = self.executor if self.executor is not None else stack.enter_context(ThreadPoolExecutor(all_cores()))
            count = max(1, min(JOB // max(map(len, sets)), -(-len(poses) // (4 * all_cores()))))
            blocks = [slice(k, k + count) for k in range(0, len(poses), count)]
            jobs = [run.submit(self.sampler.sample, poses[each], sets[each], self.spacing, cancellation) for each in blocks]
            stack.callback(cancellation.cancel)
            stack.callback(lambda: [job.cancel() for job in jobs])
            for job in jobs:
                while not wait([job], REPORT).done:
                    notify(len(found) / len(poses), f"sampling positions: {sum(len(each.m) for each in found):,} candidates")
                for each in job.result():
                    k = len(found)
                    sample = self.sampler.sample_at_random(poses[k]) if self.at_random and not each.reached else each
                    if not len(sample.q):
                        raise _no_candidate(name(k), self.sampler, poses[k], sets[k], sample.reached)
                    found.append(sample)
                candidates = sum(len(each.m) for each in found)
                notify(len(found) / len(poses), f"sampling positions: {candidates:,} candidates")
        return found

    def with_positions(self, layers: Layers, s: Array, notify: Progress) -> Layers:
        """The layers with positions at s (k,), ascending, too, which are between those there are."""
        assert layers.s is not None and layers.poses is not None
        before = np.searchsorted(layers.s, s)
        poses = self.path(s)
        found = self.at(poses, self.sets(poses), lambda k: f"path, s = {s[k]:.6g}", notify)
        q, m = list(layers.q), list(layers.m)
        for k, each in zip(before[::-1], reversed(found), strict=True):
            q.insert(k, each.q)
            m.insert(k, each.m)
        return replace(
            layers,
            q=tuple(q),
            m=tuple(m),
            s=np.insert(layers.s, before, s),
            poses=np.insert(layers.poses, before, poses, axis=0),
            longest=None if layers.longest is None else np.insert(layers.longest, before, layers.longest[before - 1]),
        )


def _offsets(parameters: int) -> Array:
    """Differences (k, r) from parameters near which more samples are taken [rad or m]."""
    return np.array(list(product(BESIDE if parameters < 5 else BESIDE[1:4], repeat=parameters)))


def default_samples(solver: "Solver") -> Sequence[int]:
    """Default number of samples per parameter, by the number of parameters."""
    if solver.by_rows:
        return FEW_SAMPLES
    return SAMPLES if solver.form is not None else SEARCHED


def _no_candidate(position: str, sampler: "CandidateSampler", pose: Array, values: Array, reached: int) -> InvalidInputError:
    """The error that says why a position has no candidate, and the remedy."""
    if reached:
        spec = sampler.spec
        widest = sampler.widest(pose, values)
        needed = f"clearance {1e3 * (spec.clearance - spec.spare):.4g} mm" if spec.clearance > spec.spare else "no collision"
        needed += f" and {1e3 * spec.spare:.4g} mm to spare for the motion between positions" if spec.spare else ""
        best = f"in the best of them {' and '.join(widest[1])} {apart_text(widest[0])}" if widest else "none of them is free"
        wanted = f"a pose with a collision-free configuration; {reached:,} reach it, and {best}; needed: {needed}"
        return InvalidInputError(position, pose.tolist(), wanted)
    nearest, own = sampler.nearest(pose), sampler.solver.own
    if own is not None:
        wanted = (
            f"a pose for which {own.name} returns a configuration inside the limits; the nearest one found is {nearest.away}"
        )
        return InvalidInputError(position, pose.tolist(), wanted)
    if nearest.position < REACHES[0] and nearest.rotation < REACHES[1]:
        wanted = "a pose that some sample reaches: it is within reach, but no value on the grid reaches it; take more samples"
        return InvalidInputError(position, pose.tolist(), wanted)
    hint = millimetres_hint(pose, nearest.position, lambda each: sampler.nearest(each).position)
    wanted = f"a pose within reach and joint limits; the arm stays {nearest}{hint}"
    return OutOfReachError(position, pose.tolist(), wanted, nearest)


def _check_grid(
    sampler: "CandidateSampler", n: int, samples: int | Sequence[int] | None, usual: Sequence[int], allowed: float
) -> None:
    """Raises InvalidInputError where the poses or the grid of parameters would not fit into memory."""
    from manipplan.ik.solver import sample_counts

    counts = sample_counts(samples, sampler.solver.sampled_names, usual)
    for argument, value, needed in (("positions", n, 8 * 16 * n), ("samples", samples, GRID * math.prod(counts))):
        if needed > allowed:
            wanted = f"fewer: they need {needed / 1e9:.2g} GB, and memory allows {allowed / 1e9:.2g} GB"
            raise InvalidInputError(argument, value, wanted)


def _share_found(sampler: "CandidateSampler", poses: Array, values: Array, allowed: float) -> float:
    """Number of candidates that one sample (s, r) gives in the mean, estimated from few; the most if these are allowed."""
    most = sampler.solver.most
    if len(sampler.solver.names) < 3 and most * len(values) * len(poses) * 8 * (sampler.spec.robot.n + 1) <= allowed:
        return float(most)
    rng = np.random.default_rng(0)
    some = values[rng.choice(len(values), min(PROBE, len(values)), replace=False)]
    few = np.unique(np.linspace(0, len(poses) - 1, PROBES).astype(int))
    return float(np.mean([len(sampler.sample(poses[k : k + 1], [some])[0].q) / len(some) for k in few]))


def _check_memory(sampler: "CandidateSampler", positions: int, values: Array, candidates: float, allowed: float) -> None:
    """Raises InvalidInputError where the samples would give more candidates than fit into memory."""
    needed = candidates * 8 * (sampler.spec.robot.n + 1)
    if needed > allowed:
        wanted = f"fewer: about {candidates:.2g} candidates need {needed / 1e9:.2g} GB; memory allows {allowed / 1e9:.2g} GB"
        raise InvalidInputError("samples", f"{len(values):,} at each of {positions} positions", wanted)


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

    def sample(
        self, poses: Array, sets: Sequence[Array], spacing: Array | None = None, deadline: Deadline = NEVER
    ) -> "list[PositionSample]":
        """The candidates of each of poses (p, 4, 4) for its parameters, sets[k] (s, r); see `sample_layers` for `spacing`.

        Raises OutOfTimeError soon after the deadline.
        """
        lines = [np.zeros(len(each), dtype=np.bool_) for each in sets]
        if spacing is not None and self.solver.form is not None and self.solver.is_line:
            lines = [np.asarray((np.abs(each[:, 1:]) < EVEN).all(axis=1)) for each in sets]  # those of the whole pose
        on_lines = [_with_end(each[line]) if line.any() else each[:0] for each, line in zip(sets, lines, strict=True)]
        others = [each[~line] for each, line in zip(sets, lines, strict=True)]
        every, of = list[Array](), list[NDArray[np.int64]]()
        for some, between in ((on_lines, spacing), (others, None)):
            owners, values = np.repeat(np.arange(len(poses)), [len(each) for each in some]), np.concatenate(some)
            if not len(values):
                continue
            found = self._solve(poses, owners, values, deadline)
            if between is not None:
                owners, found = self._fill(poses, owners, values, found, between, deadline)
            every.append(found.q)
            of.append(owners[found.source])
        return self._candidates(np.concatenate(every), np.concatenate(of), len(poses), deadline)

    def sample_at_random(self, pose: Array) -> "PositionSample":
        """The candidates of a pose (4, 4) to which random starts lead, where no parameter that was tried reaches it."""
        found = self.solver.random_solutions(pose)
        if len(found):
            found = self.solver.judged(found, pose).q
        return self._candidates(found, np.zeros(len(found), dtype=np.int64), 1, NEVER)[0]

    def _candidates(self, found: Array, of: NDArray[np.int64], count: int, deadline: Deadline) -> "list[PositionSample]":
        """Those of configurations found (k, n) that are free, at every full turn, for each of `count` positions."""
        free = np.concatenate([self.free(found[each]) for each in _slices(len(found), BLOCK, deadline)])
        reached = np.bincount(of, minlength=count)
        order = np.flatnonzero(free)[np.argsort(of[free], kind="stable")]
        rows, q = self.solver.with_turns(found[order])  # full turns change neither collisions nor manipulability
        m = self.kinematics.manipulability(found[order])[rows]
        ends = np.cumsum(np.bincount(of[order][rows], minlength=count))[:-1]
        every = zip(np.split(q, ends), np.split(m, ends), reached.tolist(), strict=True)
        return [PositionSample(q=np.ascontiguousarray(q), m=m, reached=reached) for q, m, reached in every]

    def _solve(self, poses: Array, owners: NDArray[np.int64], values: Array, deadline: Deadline) -> Found:
        found, source = list[Found](), list[NDArray[np.int64]]()
        for each in _slices(len(values), BLOCK, deadline):
            found.append(self.solver.solve_once(poses, owners[each], values[each], deadline))
            source.append(found[-1].source + each.start)
        return Found(
            q=np.concatenate([each.q for each in found]),
            source=np.concatenate(source),
            residual=np.concatenate([each.residual for each in found]),
        )

    def _fill(
        self, poses: Array, owners: NDArray[np.int64], values: Array, found: Found, spacing: Array, deadline: Deadline
    ) -> tuple[NDArray[np.int64], Found]:
        """More samples of the one parameter where solutions of neighbouring values are farther apart than `spacing` (n,).

        These are the values at which a branch begins, turns back, or moves fast. Intervals are halved up to HALVINGS times.
        """
        turns, finest = self.spec.robot.turns, np.inf
        if len(values) < 2:
            return owners, found
        for _ in range(HALVINGS + 1):
            order = np.lexsort((values[:, 0], owners))
            place = np.empty_like(order)
            place[order] = np.arange(len(order))
            owners, values = owners[order], values[order]
            source = place[found.source]
            rows = np.argsort(source, kind="stable")
            found = Found(q=found.q[rows], source=source[rows], residual=found.residual[rows])
            widths = np.diff(values[:, 0])
            if finest == np.inf:
                finest = float(np.median(widths)) / 2**HALVINGS * 1.5
            wide = np.flatnonzero(apart(found.q, found.source, owners, turns, spacing) & (widths > finest))
            if not len(wide):
                break
            middle, own = (values[wide] + values[wide + 1]) / 2, owners[wide]
            more = self._solve(poses, own, middle, deadline)
            found = Found(
                q=np.concatenate([found.q, more.q]),
                source=np.concatenate([found.source, more.source + len(values)]),
                residual=np.concatenate([found.residual, more.residual]),
            )
            owners, values = np.concatenate([owners, own]), np.concatenate([values, middle])
        return owners, found

    def free(self, q: Array) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """Which rows of q (k, n) keep the clearance, (k,)."""
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

    def widest(self, pose: Array, values: Array) -> tuple[float, tuple[str, str]] | None:
        """The largest of the smallest distances [m] at up to MEASURED configurations that reach `pose`, and its pair.

        None if no configuration with one of the parameters `values` (s, r) reaches it.
        """
        assert self.collision is not None
        q = np.concatenate(
            [
                self.solver.solve_once(pose[None], np.zeros(len(values[each]), dtype=np.int64), values[each]).q
                for each in _slices(len(values), BLOCK)
            ]
        )
        if not len(q):
            return None
        q = q[:: -(-len(q) // MEASURED)]
        least = [self.collision.least_distance(each[None]) for each in q]
        apart, _, pair = max(least)
        return apart, self.collision.pair_names[pair]

    def nearest(self, pose: Array) -> Nearest:
        """The configuration inside the limits that comes nearest to a pose (4, 4), collisions aside."""
        return nearest_to(self.spec.robot.kinematics(Task.pose(length=1.0), threads=1), self.solver.free, pose)


def _slices(rows: int, block: int, deadline: Deadline = NEVER) -> Iterator[slice]:
    """Slices of up to `block` of a number of rows, at least one; raises OutOfTimeError after the deadline."""
    for begin in range(0, max(rows, 1), block):
        deadline.check()
        yield slice(begin, begin + block)


def _with_end(values: Array) -> Array:
    """Values (s, r) of one parameter, the first, with the end of the turn where they are evenly spread over one."""
    steps = np.diff(np.sort(values[:, 0]))
    whole = np.ptp(values[:, 0]) + np.median(steps) if len(steps) else 0.0
    end = values[values[:, 0].argmin()] + 2 * np.pi * np.eye(values.shape[1])[0]
    return np.vstack([values, end]) if abs(whole - 2 * np.pi) < EVEN else values


@lru_cache(maxsize=2)
def _sampler_of(spec: bytes) -> CandidateSampler:
    """The sampler of a spec, built once per process."""
    return CandidateSampler(pickle.loads(spec))
