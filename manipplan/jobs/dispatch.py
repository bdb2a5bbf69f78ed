"""Many problems on an executor: a few at a time on their way, those whose worker died once more."""

import sys
import uuid
from collections import deque
from collections.abc import Callable, Mapping
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait

from manipplan.jobs.parcel import CacheMiss, Outcome, Packer, plan_parcel
from manipplan.jobs.problem import Problem
from manipplan.jobs.result import PartialPlan
from manipplan.support.errors import InvalidInputError
from manipplan.support.processes.workers import WorkerLostError, Workers
from manipplan.support.status import Status

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
