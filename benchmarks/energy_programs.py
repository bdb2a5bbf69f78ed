"""Real programs of the energy: what `mp.plan` asks `PathProgram.solve` to minimise, with and without clearance rows.

`collected(40)` plans problems of MotionBenchMaker and of benchmarks/pairs in turn, and keeps some of their solves. Each has
the arguments of `PathProgram.solve`, so that any solver with the same call can be put beside another one:

    for each in energy_programs.collected(40):
        solution = each.program.solve(*each.arguments)
"""

import itertools
import os
from collections import defaultdict
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import numpy as np
from numpy.typing import NDArray
from outside import problems
from path_suite import load

import manipplan as mp
from manipplan.optimize.clearance import ClearanceRows
from manipplan.optimize.program import PathProgram, Solution
from manipplan.optimize.rows import ConstraintSearch
from manipplan.support.deadline import NEVER, Deadline

PAIRS = Path(__file__).parent / "pairs"
#: Number of solves that are kept of one problem: with rows, and without.
OF_ONE_PROBLEM = 2, 1
#: Time limit of the planner [s].
TIME_LIMIT = 10.0


@dataclass(frozen=True, kw_only=True, eq=False)
class EnergyProgram:
    """One solve of the energy.

    Attributes:
        source: the set and number of the problem that it comes from.
        program: the program, of one arm, objective and basis.
        start, goal, guess, floor, rows: the arguments of `PathProgram.solve`.
    """

    source: str
    program: PathProgram
    start: NDArray[np.float64]
    goal: NDArray[np.float64]
    guess: NDArray[np.float64]
    floor: float
    rows: ClearanceRows | None

    @property
    def arguments(self) -> tuple:
        """The arguments of `PathProgram.solve`, in its order."""
        return self.start, self.goal, self.guess, self.floor, self.rows


@contextmanager
def recorded(source: str) -> Iterator[list[EnergyProgram]]:
    """A list that gets every program that is solved inside the `with` block."""
    found: list[EnergyProgram] = []
    solve = PathProgram.solve

    def listening(
        self: PathProgram,
        start: NDArray[np.float64],
        goal: NDArray[np.float64],
        guess: NDArray[np.float64],
        floor: float,
        rows: ClearanceRows | None = None,
        deadline: Deadline = NEVER,
        constraints: ConstraintSearch | None = None,
    ) -> Solution:
        arrays = {"start": start.copy(), "goal": goal.copy(), "guess": guess.copy()}
        found.append(EnergyProgram(source=source, program=self, floor=floor, rows=rows, **arrays))
        return solve(self, start, goal, guess, floor, rows, deadline, constraints)

    PathProgram.solve = listening
    try:
        yield found
    finally:
        PathProgram.solve = solve


def spread(some: Sequence[EnergyProgram], count: int) -> list[EnergyProgram]:
    """At most `count` of them, evenly over the list, with the first and the last."""
    if len(some) <= count:
        return list(some)
    return [some[k] for k in np.linspace(0, len(some) - 1, count).round().astype(int)]


def planned() -> Iterator[tuple[str, mp.Robot, NDArray[np.float64], NDArray[np.float64], mp.Scene, float]]:
    """Source, robot, start, goal, scene and clearance of the problems: one of each set, then the next of each."""
    groups: dict[str, list[tuple]] = defaultdict(list)
    panda = problems.robot("panda")
    for each in problems.load("panda"):
        if not (panda.limits.outside(np.array([each.start, each.goal])) > 0).any():
            groups[each.set].append((panda, each.start, each.goal, each.scene, 0.0))
    robots = {arm: mp.load_robot(arm) for arm in ("panda", "ur5", "xarm7")}
    for pair in load():
        name, arm = pair["scene"], pair["arm"]
        scene = mp.Scene() if name == "free" else mp.Scene.from_yaml(PAIRS / f"{name}_{arm}.yaml")
        groups[f"{arm}, {name}"].append((robots[arm], pair["start"], pair["goal"], scene, 0.01))
    for number, several in enumerate(itertools.zip_longest(*groups.values())):
        for group, one in zip(groups, several, strict=True):
            if one is not None:
                yield f"{group}, {number}", *one


def collected(count: int) -> list[EnergyProgram]:
    """`count` programs, as far as possible half of them with clearance rows."""
    with_rows: list[EnergyProgram] = []
    without: list[EnergyProgram] = []
    for source, robot, start, goal, scene, clearance in planned():
        with recorded(source) as found:
            seeding = mp.Seeding(time_limit=TIME_LIMIT)
            mp.plan(robot, start, goal, scene, clearance=clearance, seeding=seeding, throw=False)
        with_rows += spread([each for each in found if each.rows], OF_ONE_PROBLEM[0])
        without += spread([each for each in found if not each.rows], OF_ONE_PROBLEM[1])
        half = count // 2
        if len(with_rows) >= half and len(without) >= count - half:
            return without[: count - half] + with_rows[:half]
    raise ValueError(f"count is {count}; all problems together have fewer programs")
