"""Finished problems in a folder: one file per problem, named by its content, so that a later call does only the rest."""

import logging
from pathlib import Path

from manipplan.jobs.archive import checked_json, plan_of, write_plan
from manipplan.jobs.problem import Problem, obstacles_of, problem_key
from manipplan.jobs.result import PartialPlan
from manipplan.measures.measure import Measure
from manipplan.support.content import code_key
from manipplan.support.errors import FileFormatError
from manipplan.support.files import writable_folder
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
