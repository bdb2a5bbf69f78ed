"""plan_many: many problems on many workers.

Finished problems in a folder: one file per problem, named by its content, so that a later call does only the rest.

Problem: the arguments of one call of `plan`, to be planned together with others.

Many problems on an executor: a few at a time on their way, those whose worker died once more.

Parcels: problems on their way to a worker, and their outcomes on the way back.

Robots and scenes are large, and costly to prepare: a worker keeps those it was sent, by their content. A parcel names them.
Small scenes are in it; a worker that lacks a robot or a large scene asks for it.
"""

import copy
import logging
import pickle
import sys
import threading
import uuid
from collections import OrderedDict, deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Generic, TypeVar

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import is_own
from manipplan.constraints.constraint import Constraint
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.cost.integral import metric_matrix
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import Goal, read_configuration, read_goals
from manipplan.jobs.plan import plan
from manipplan.measures.measure import Measure
from manipplan.optimize.optimize import check_options
from manipplan.optimize.problem import initial_path
from manipplan.paths.basis import PathShape
from manipplan.plans.archive import plan_of, read_checked_json, write_plan
from manipplan.plans.result import PartialPlan, Plan
from manipplan.robots.robot import Robot
from manipplan.robots.subchain import uncouple
from manipplan.seeds.seeding import Seeding
from manipplan.support.checks import ArrayLike, flag, instance, number, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import FileFormatError, InvalidInputError, inside
from manipplan.support.files import writable_folder
from manipplan.support.memo import code_key, content_key, once_per_owner
from manipplan.support.progress import Progress, as_callback
from manipplan.support.status import Status
from manipplan.support.workers import WorkerLostError, Workers
from manipplan.timing.retime import check_timing_limits

log = logging.getLogger("manipplan")


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """One of the problems of `plan_many`: a robot, a start, a goal, obstacles, and the options of `plan`.

    Problems may share a robot and a scene, and should: each process then prepares them once. `plan_many` checks the values.

    Attributes:
        robot, start, goal, scene, constraints, objective, shape, seeding, clearance, torque: the arguments of `plan`.
        name: what the problem is called in messages and progress.
    """

    robot: Robot
    start: ArrayLike | str
    goal: Goal
    scene: Scene | None = None
    constraints: Sequence[Constraint] = ()
    objective: PathObjective = PathObjective()
    shape: PathShape = PathShape()
    seeding: Seeding = Seeding()
    clearance: float = 0.0
    torque: bool = False
    name: str = ""


def checked(argument: str, problem: Problem) -> Problem:
    """The problem with arrays and poses for start, goal and first path; raises InvalidInputError, which names `argument`.

    Whether robot and scene allow start, goal and first path is left to `plan`: it depends on values that are computed, and one
    such problem is no reason to plan none.
    """
    instance(argument, problem, Problem)
    with inside(argument):
        robot, seeding = instance("robot", problem.robot, Robot), problem.seeding
        if problem.scene is not None:
            instance("scene", problem.scene, Scene)
        instance("name", problem.name, str)
        flag("torque", problem.torque)
        check_options(problem.objective, problem.shape, seeding)
        start = read_configuration("start", problem.start, robot)
        targets, is_list = read_goals("goal", problem.goal, robot)
        goals = [each.goal for each in targets]
        clearance = number("clearance", problem.clearance, least=0.0)
        check_timing_limits(robot.limits)
        problem.shape.ends(robot.n)
        metric_matrix("metric", problem.objective.metric, robot.n)
        problem.objective.kinematics(robot)
        constraints = ConstraintSet.of(robot, problem.constraints).constraints
        if seeding.initial is not None:
            seeding = replace(seeding, initial=initial_path(robot, seeding.initial))
        return replace(
            problem,
            start=start,
            goal=goals if is_list else goals[0],
            seeding=seeding,
            constraints=constraints,
            clearance=clearance,
        )


def options_of(problem: Problem) -> dict[str, Any]:
    """The options of `plan` that a problem holds, by name."""
    given = {each.name: getattr(problem, each.name) for each in fields(problem)}
    return {name: value for name, value in given.items() if name not in ("robot", "start", "goal", "scene", "name")}


def obstacles_of(problem: Problem) -> Scene:
    """The obstacles; an empty scene for None."""
    return problem.scene if problem.scene is not None else Scene()


def problem_key(problem: Problem) -> str:
    """What the result of a checked problem depends on, except for the version of this package, as a key."""
    return content_key(
        [robot_key(problem.robot), scene_key(obstacles_of(problem)), problem.start, problem.goal, options_of(problem)]
    )


@once_per_owner
def robot_key(robot: Robot) -> str:
    """The content of a robot as a key: all that plans depend on, not where it was read from."""
    model, geometry, followers = uncouple(robot.model, robot.geometry)  # as it is pickled
    parts = {each.name: getattr(robot, each.name) for each in fields(robot) if each.name not in ("model", "geometry", "source")}
    bodies = [
        (body.name, body.parentJoint, body.parentFrame, body.placement, body.meshScale, body.geometry)
        for body in geometry.geometryObjects
    ]
    return content_key([parts, model, followers, bodies])


@once_per_owner
def scene_key(scene: Scene) -> str:
    """The content of a scene as a key; of a shape of the user its parts."""
    own = [obstacle.parts() for obstacle in scene.obstacles if is_own(obstacle)]
    return content_key([scene.obstacles, own, scene.names, scene.allowed])


Value = TypeVar("Value")

#: Number of robots and scenes that each thread of a worker keeps, and of pickled ones that the sender keeps.
MOST_ROBOTS, MOST_SCENES, MOST_PICKLED = 8, 16, 4
#: Pickled scenes up to this size travel with every problem [bytes].
SMALL = 64_000


class Latest(Generic[Value]):
    """The values that were used last, by key."""

    def __init__(self, most: int) -> None:
        self.most = most
        self._values: OrderedDict[str, Value] = OrderedDict()

    def get(self, key: str, make: Callable[[], Value]) -> Value:
        """The value, made if it is not there."""
        if key not in self._values:
            self._values[key] = make()
        self._values.move_to_end(key)
        while len(self._values) > self.most:
            self._values.popitem(last=False)
        return self._values[key]

    def __contains__(self, key: str) -> bool:
        return key in self._values


@dataclass(frozen=True, kw_only=True, eq=False)
class Parcel:
    """One problem for a worker.

    Attributes:
        label: text that differs for each parcel that is sent: Dask computes equal calls only once.
        robot, scene: their keys.
        rest: the other arguments of `plan`, pickled.
        contents: pickled robots and scenes, by key.
    """

    label: str
    robot: str
    scene: str
    rest: bytes
    contents: Mapping[str, bytes] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, eq=False)
class CacheMiss:
    """A worker's answer where it lacks robot or scene: their keys."""

    keys: Sequence[str]


@dataclass(frozen=True, kw_only=True, eq=False)
class Outcome:
    """A plan without its robot and scene, which the caller has: its class and its other attributes."""

    kind: type[PartialPlan]
    parts: Mapping[str, Any]

    @classmethod
    def of(cls, plan: PartialPlan) -> "Outcome":
        """What a plan holds besides robot and scene."""
        names = [each.name for each in fields(plan) if each.name not in ("robot", "scene")]
        return cls(kind=type(plan), parts={name: getattr(plan, name) for name in names})

    def plan(self, robot: Robot, scene: Scene) -> PartialPlan:
        """The plan for the robot and the scene of the caller."""
        return self.kind(robot=robot, scene=scene, **self.parts)


class Packer:
    """Packs the problems of one call."""

    def __init__(self, label: str) -> None:
        self._label = label
        self._count = 0
        self._pickled: Latest[bytes] = Latest(MOST_PICKLED)

    def pack(self, problem: Problem, wanted: Sequence[str] = ()) -> Parcel:
        """The parcel of a checked problem, with the robot and the scene if their keys are wanted."""
        scene = obstacles_of(problem)
        values: dict[str, Robot | Scene] = {robot_key(problem.robot): problem.robot, scene_key(scene): scene}
        robot, place = values
        contents = {key: self._pickle(key, values[key]) for key in wanted}
        if len(small := self._pickle(place, scene)) <= SMALL:
            contents[place] = small
        rest = pickle.dumps({"start": problem.start, "goal": problem.goal, **options_of(problem)})
        self._count += 1
        return Parcel(label=f"{self._label} {self._count}", robot=robot, scene=place, rest=rest, contents=contents)

    def _pickle(self, key: str, value: Robot | Scene) -> bytes:
        return self._pickled.get(key, lambda: pickle.dumps(value))


class _WorkerCache(threading.local):
    """The robots and scenes of this thread."""

    def __init__(self) -> None:
        self.robots: Latest[Robot] = Latest(MOST_ROBOTS)
        self.scenes: Latest[Scene] = Latest(MOST_SCENES)


_cache = _WorkerCache()


def plan_parcel(parcel: Parcel) -> Outcome | CacheMiss:
    """In a worker: the outcome of a parcel, or what is missing to plan it."""
    known = {parcel.robot: parcel.robot in _cache.robots, parcel.scene: parcel.scene in _cache.scenes}
    missing = [key for key, is_known in known.items() if not is_known and key not in parcel.contents]
    if missing:
        return CacheMiss(keys=missing)
    robot = _cache.robots.get(parcel.robot, lambda: pickle.loads(parcel.contents[parcel.robot]))
    scene = _cache.scenes.get(parcel.scene, lambda: pickle.loads(parcel.contents[parcel.scene]))
    return Outcome.of(plan_problem(Problem(robot=robot, scene=scene, **pickle.loads(parcel.rest))))


def plan_problem(problem: Problem) -> PartialPlan:
    """The plan of a problem; what `plan` raises becomes a status."""
    scene = obstacles_of(problem)
    draft = PartialPlan(robot=problem.robot, scene=scene, status=Status.NOT_VALID)
    try:
        return plan(problem.robot, problem.start, problem.goal, scene, throw=False, **options_of(problem))
    except InvalidInputError as error:
        return replace(draft, message=str(error))
    except Exception as error:  # one problem must not end the others; the message and the log tell what happened
        log.exception("unexpected error in a problem of plan_many")
        return replace(draft, status=Status.ERROR, message=f"{type(error).__name__}: {error}")


#: Number of times that a problem is begun whose worker dies, the last time alone.
TRIES = 2
#: Problems on their way per worker: one that is planned and one that waits, so that no worker waits for the caller.
PER_WORKER = 2
#: Problems on their way where the number of workers is not known.
UNKNOWN = 32


def plan_on(executor: Executor, problems: Mapping[int, Problem], done: Callable[[int, Outcome], None]) -> None:
    """Plan checked problems, given by their numbers, on the workers of an executor; `done` is called for each.

    Raises:
        BrokenExecutor: a process of the executor died and it takes no more work; some problems are done.
        InvalidInputError: the executor takes no work, or its workers cannot load a problem.
    """
    _Dispatch(executor, problems, done).run()


class _Dispatch:
    def __init__(self, executor: Executor, problems: Mapping[int, Problem], done: Callable[[int, Outcome], None]) -> None:
        self.executor = executor
        self.problems = problems
        self.done = done
        self.waiting = deque(problems)
        self.suspects = deque[int]()  # their worker died
        self.deaths = dict.fromkeys(problems, 0)
        self.wanted: dict[int, set[str]] = {k: set() for k in problems}
        self.going: dict[Future[Outcome | CacheMiss], int] = {}
        self.packer = Packer(uuid.uuid4().hex)
        self.broken: BrokenExecutor | None = None
        self.replied = False  # whether any worker has: then an error is that of one problem, and ends no other

    def run(self) -> None:
        workers = workers_of(self.executor)
        most = UNKNOWN if workers is None else PER_WORKER * workers
        try:
            while self.waiting or self.suspects or self.going:
                if not (self.waiting or self.going):
                    self.waiting.append(self.suspects.popleft())
                while self.waiting and len(self.going) < most and self.broken is None:
                    self._submit(self.waiting.popleft())
                for future in wait(self.going, return_when=FIRST_COMPLETED).done:
                    self._receive(self.going.pop(future), future)
                if self.broken is not None and not self.going:
                    raise self.broken
        finally:
            for future in self.going:
                future.cancel()

    def _submit(self, k: int) -> None:
        try:
            parcel = self.packer.pack(self.problems[k], sorted(self.wanted[k]))
        except Exception as error:  # pickle raises errors of any class
            wanted = f"a problem that can be pickled ({error})"
            raise InvalidInputError(f"problems[{k}]", self.problems[k], wanted) from error
        try:
            self.going[self.executor.submit(plan_parcel, parcel)] = k
        except BrokenExecutor as error:
            self.broken = error
        except RuntimeError as error:
            raise InvalidInputError("executor", self.executor, f"an executor that takes work ({error})") from error

    def _receive(self, k: int, future: Future[Outcome | CacheMiss]) -> None:
        try:
            reply = future.result()
        except BrokenExecutor as error:
            self.broken = error
        except CancelledError as error:
            raise InvalidInputError("executor", self.executor, "an executor that is not shut down while it plans") from error
        except Exception as error:
            self._failed(k, error)
        else:
            self.replied = True
            if isinstance(reply, CacheMiss):
                self.wanted[k].update(reply.keys)
                self.waiting.appendleft(k)
            else:
                self.done(k, reply)

    def _failed(self, k: int, error: Exception) -> None:
        """The executor failed, not the planning."""
        if isinstance(error, WorkerLostError) and not error.started and not self.replied:
            wanted = f"processes that can start; standard error shows why this one did not ({error})"
            raise InvalidInputError("executor", self.executor, wanted) from error
        if not _is_lost(error):
            message = f"{type(error).__name__}: {error}"
            if not self.replied:
                wanted = f"workers that can load {label(k, self.problems[k])} ({message})"
                raise InvalidInputError("executor", self.executor, wanted) from error
            self.done(k, Outcome(kind=PartialPlan, parts={"status": Status.ERROR, "message": message}))
            return
        self.deaths[k] += 1
        if self.deaths[k] < TRIES:
            self.suspects.append(k)
        else:
            self.done(k, Outcome(kind=PartialPlan, parts={"status": Status.WORKER_LOST, "message": str(error)}))


def _is_lost(error: Exception) -> bool:
    """Whether an executor that can still be used says by this error that a worker died."""
    distributed = sys.modules.get("distributed")
    return isinstance(error, WorkerLostError) or (distributed is not None and isinstance(error, distributed.KilledWorker))


def label(k: int, problem: Problem) -> str:
    """What a problem is called in messages."""
    return f"problems[{k}] ({problem.name})" if problem.name else f"problems[{k}]"


def workers_of(executor: Executor) -> int | None:
    """The number of problems that an executor plans at a time; None where it does not say."""
    if isinstance(executor, Workers):
        return executor.count
    client = getattr(executor, "_client", None)  # of a Dask client's executor
    if client is not None:
        return int(max(1, sum(client.nthreads().values())))
    count = getattr(executor, "_max_workers", None)  # of the executors of concurrent.futures
    return int(count) if isinstance(count, int) else None


#: Results that another attempt may change.
UNFINISHED = (Status.WORKER_LOST, Status.ERROR)
#: Number of digits of a key in a file's name; the file holds all of them.
DIGITS = 24


class Finished:
    """The plans in a folder, as JSON files like those of `Plan.save`."""

    def __init__(self, folder: str | Path) -> None:
        self.folder = writable_folder("folder", folder)

    def load(self, problem: Problem) -> PartialPlan | None:
        """The plan of a checked problem; None where there is none, or one that cannot be used, which the log says."""
        key = problem_key(problem)
        file = self._file(key)
        if not file.exists():
            return None
        measure = problem.objective.measure
        try:
            data = read_checked_json(file)
            if data.get("problem") != key:
                raise FileFormatError("file", str(file), "the result of this problem; it holds that of another one")
            if data.get("code") != code_key():
                log.warning("%s is of other code, of manipplan %s: planned again", file, data.get("manipplan"))
                return None
            own = measure if isinstance(measure, Measure) else None
            return plan_of(file, data, robot=problem.robot, scene=obstacles_of(problem), measure=own)
        except FileFormatError as error:
            log.warning("planned again: %s", error)
            return None

    def save(self, problem: Problem, plan: PartialPlan) -> None:
        """Write a plan whole or not at all; those of lost workers and of unexpected errors are left out."""
        if plan.status not in UNFINISHED:
            key = problem_key(problem)
            write_plan(plan, self._file(key), problem=key)

    def _file(self, key: str) -> Path:
        return self.folder / f"{key[:DIGITS]}.json"


def plan_many(
    problems: Iterable[Problem],
    executor: Executor | int | None = None,
    *,
    folder: str | Path | None = None,
    progress: Progress | None = None,
) -> list[Plan | PartialPlan]:
    """Plan many problems, on several workers: the results are in the order of the problems.

    A problem that cannot be solved is a result like the others: a PartialPlan, or a Plan with Status.CHECK_FAILED, with the
    reason in `status` and `message`. Status.NOT_VALID says that start or goal is outside the limits or in collision. The
    results do not depend on the executor, as long as no planner reaches its `time_limit`.

    A worker that dies is replaced and its problem planned again, at the end and alone; if that one dies, too, the result has
    Status.WORKER_LOST. A ProcessPoolExecutor cannot be used after that: the rest is planned by as many processes of our own,
    which the log says.

    Args:
        problems: what to plan; see `Problem`. Problems that share a robot or a scene share what is prepared for it.
        executor: an int: the number of processes, each with one thread of linear algebra. Only where a problem holds a value of
            a class that your program itself defines does the program need the line ``if __name__ == "__main__":``. Or any
            `concurrent.futures.Executor`, such as a Dask client's `get_executor()`. Threads take turns: planning holds Python's
            lock. None: this process, one problem after the other.
        folder: where each result is written as soon as it is known, and looked for before: after an interrupt or for more
            problems, the same call plans only the rest. A file is used only for the same problem and version of this package.
            Results read from it lack `history` and `rivals`. Those with Status.WORKER_LOST and Status.ERROR are not kept.
        progress: called with the share done in [0, 1] and a text, whenever a result is known.

    Raises:
        InvalidInputError: an argument is invalid; of a problem, the message names its number: `problems[17].start`. Nothing
            was planned then. Or the executor takes no work, or its workers cannot load the problems.
        KeyboardInterrupt: Ctrl-C; finished results are in `folder`.
    """
    notify = as_callback(progress)
    if executor is not None and not isinstance(executor, Executor):
        executor = whole_number("executor", executor, least=1) if isinstance(executor, int) else _no_executor(executor)
    batch = _Batch.of(problems, None if folder is None else Finished(folder), notify)
    left = batch.read_finished()
    if executor is None:
        batch.plan_here(left)
    elif isinstance(executor, Executor):
        try:
            batch.plan_on(executor, left)
        except BrokenExecutor as error:
            left, executor = batch.left(), workers_of(executor) or 1
            log.warning("%s %d processes of plan_many plan the other %d problems", error, executor, len(left))
    if isinstance(executor, int) and left:
        with Workers(min(executor, len(left))) as workers:
            batch.plan_on(workers, left)
    return [batch.results[k] for k in range(len(batch.problems))]


def _no_executor(value: object) -> int:
    raise InvalidInputError("executor", value, "a number of processes, a concurrent.futures.Executor, or None")


@dataclass(kw_only=True)
class _Batch:
    """The problems of one call and their results.

    Attributes:
        problems: as given, checked.
        shared: the same, with one robot and one scene for all that are equal.
        finished: the results on disk.
        results: by number.
    """

    problems: Sequence[Problem]
    shared: Sequence[Problem]
    finished: Finished | None
    notify: Progress
    results: dict[int, PartialPlan] = field(default_factory=dict)
    failures: int = 0

    @classmethod
    def of(cls, problems: Iterable[Problem], finished: Finished | None, notify: Progress) -> "_Batch":
        """A batch of checked problems."""
        if not isinstance(problems, Iterable):
            raise InvalidInputError("problems", problems, "a list of Problem")
        given, shared = [], []
        robots, scenes, nothing = dict[str, Robot](), dict[str, Scene](), Scene()
        for k, each in enumerate(problems):
            problem = checked(f"problems[{k}]", each)
            problem = replace(problem, scene=problem.scene if problem.scene is not None else nothing)
            scene = obstacles_of(problem)
            given.append(problem)
            robot = robots.setdefault(robot_key(problem.robot), problem.robot)
            shared.append(replace(problem, robot=robot, scene=scenes.setdefault(scene_key(scene), scene)))
        return cls(problems=given, shared=shared, finished=finished, notify=notify)

    def read_finished(self) -> list[int]:
        """Take the results that are on disk; returns the numbers of the other problems."""
        for k, problem in enumerate(self.problems if self.finished is not None else ()):
            found = self.finished.load(problem) if self.finished is not None else None
            if found is not None:
                self._take(k, found)
        return self.left()

    def left(self) -> list[int]:
        """The numbers of the problems without a result."""
        return [k for k in range(len(self.problems)) if k not in self.results]

    def plan_here(self, numbers: Sequence[int]) -> None:
        """Plan in this process. Scenes are copies, so that what is prepared for a thousand of them is not all kept."""
        scenes = Latest[Scene](MOST_SCENES)
        for k in numbers:
            problem = self.shared[k]
            scene = obstacles_of(problem)
            here = scenes.get(scene_key(scene), lambda scene=scene: copy.copy(scene))  # type: ignore[misc]
            self._done(k, Outcome.of(plan_problem(replace(problem, scene=here))))

    def plan_on(self, executor: Executor, numbers: Sequence[int]) -> None:
        """Plan on an executor; raises BrokenExecutor as `plan_on` does."""
        plan_on(executor, {k: self.shared[k] for k in numbers}, self._done)

    def _done(self, k: int, outcome: Outcome) -> None:
        problem = self.problems[k]
        plan = outcome.plan(problem.robot, obstacles_of(problem))
        if self.finished is not None:
            self.finished.save(problem, plan)
        self._take(k, plan)

    def _take(self, k: int, plan: PartialPlan) -> None:
        self.results[k] = plan
        if not plan.status.has_path:
            self.failures += 1
            log.info("%s: %s: %s", label(k, self.problems[k]), plan.status.name, plan.message)
        failed = f", {self.failures} failed" if self.failures else ""
        self.notify(len(self.results) / len(self.problems), f"{len(self.results)} of {len(self.problems)} problems{failed}")
