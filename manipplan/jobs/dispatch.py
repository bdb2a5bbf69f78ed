"""Many problems on an executor: a few at a time on their way, those whose worker died once more.

Parcels: problems on their way to a worker, and their outcomes on the way back.

Robots and scenes are large, and costly to prepare: a worker keeps those it was sent, by their content. A parcel names them.
Small scenes are in it; a worker that lacks a robot or a large scene asks for it.
"""

import logging
import pickle
import sys
import threading
import uuid
from collections import OrderedDict, deque
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from dataclasses import dataclass, field, fields, replace
from typing import Any, Generic, TypeVar

from manipplan.collision.scene import Scene
from manipplan.jobs.plan import plan
from manipplan.jobs.problem import Problem, obstacles_of, options_of, robot_key, scene_key
from manipplan.jobs.result import PartialPlan
from manipplan.robots.robot import Robot
from manipplan.support.errors import InvalidInputError
from manipplan.support.processes.workers import WorkerLostError, Workers
from manipplan.support.status import Status

log = logging.getLogger("manipplan")
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


class _Kept(threading.local):
    """The robots and scenes of this thread."""

    def __init__(self) -> None:
        self.robots: Latest[Robot] = Latest(MOST_ROBOTS)
        self.scenes: Latest[Scene] = Latest(MOST_SCENES)


_kept = _Kept()


def plan_parcel(parcel: Parcel) -> Outcome | CacheMiss:
    """In a worker: the outcome of a parcel, or what is missing to plan it."""
    known = {parcel.robot: parcel.robot in _kept.robots, parcel.scene: parcel.scene in _kept.scenes}
    missing = [key for key, is_kept in known.items() if not is_kept and key not in parcel.contents]
    if missing:
        return CacheMiss(keys=missing)
    robot = _kept.robots.get(parcel.robot, lambda: pickle.loads(parcel.contents[parcel.robot]))
    scene = _kept.scenes.get(parcel.scene, lambda: pickle.loads(parcel.contents[parcel.scene]))
    return Outcome.of(planned(Problem(robot=robot, scene=scene, **pickle.loads(parcel.rest))))


def planned(problem: Problem) -> PartialPlan:
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
