"""Whether the ends of a motion keep its constraints."""

from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError


def check_start(constraints: ConstraintSet, start: Array) -> None:
    """Raise InvalidInputError where the start (n,) breaks a constraint: it names the constraint, and by how much."""
    _check("start", constraints, start)


def check_ends(constraints: ConstraintSet, start: Array, goal: Array) -> None:
    """The same for both ends; and where the goal (n,) differs from the start in a held joint."""
    check_start(constraints, start)
    _check("goal", constraints, goal)
    moved = constraints.moved(start, goal)
    if moved:
        raise InvalidInputError("goal", goal.tolist(), f"a configuration with the held joints of the start: {moved}")


def _check(argument: str, constraints: ConstraintSet, q: Array) -> None:
    broken = constraints.broken(q)
    if broken:
        raise InvalidInputError(argument, q.tolist(), f"a configuration that keeps the constraints, but it breaks {broken}")
