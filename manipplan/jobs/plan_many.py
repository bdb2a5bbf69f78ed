"""plan_many: many problems on many workers.

Finished problems in a folder: one file per problem, named by its content, so that a later call does only the rest.
"""

import copy
import logging
from collections.abc import Iterable, Sequence
from concurrent.futures import BrokenExecutor, Executor
from dataclasses import dataclass, field, replace
from pathlib import Path

from manipplan.collision.scene import Scene
from manipplan.jobs.archive import checked_json, plan_of, write_plan
from manipplan.jobs.dispatch import MOST_SCENES, Latest, Outcome, label, plan_on, planned, workers_of
from manipplan.jobs.problem import Problem, checked, obstacles_of, problem_key, robot_key, scene_key
from manipplan.jobs.result import PartialPlan, Plan
from manipplan.measures.measure import Measure
from manipplan.robots.robot import Robot
from manipplan.support.checks import whole_number
from manipplan.support.content import code_key
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.files import writable_folder
from manipplan.support.processes.workers import Workers
from manipplan.support.progress import Progress, teller
from manipplan.support.status import Status

log = logging.getLogger("manipplan")

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
            data = checked_json(file)
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
    tell = teller(progress)
    if executor is not None and not isinstance(executor, Executor):
        executor = whole_number("executor", executor, least=1) if isinstance(executor, int) else _no_executor(executor)
    batch = _Batch.of(problems, None if folder is None else Finished(folder), tell)
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
    tell: Progress
    results: dict[int, PartialPlan] = field(default_factory=dict)
    failures: int = 0

    @classmethod
    def of(cls, problems: Iterable[Problem], finished: Finished | None, tell: Progress) -> "_Batch":
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
        return cls(problems=given, shared=shared, finished=finished, tell=tell)

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
            self._done(k, Outcome.of(planned(replace(problem, scene=here))))

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
        self.tell(len(self.results) / len(self.problems), f"{len(self.results)} of {len(self.problems)} problems{failed}")
