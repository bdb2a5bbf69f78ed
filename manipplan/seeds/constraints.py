"""The constraints of a search as its compiled code takes them: `Constraints` of constraints.h."""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from manipplan.constraints.constraint_set import ConstraintSet, OwnRows
from manipplan.constraints.tool_frame import POSE
from manipplan.support.checks import Array

#: Value to which a projection leads a row that is broken [rad or m], since edges between such configurations cut corners; at
#: most this share of the largest value that the row has at random configurations.
AIM, SHARE = 0.02, 0.2
#: Share of that which checked configurations keep, but no more than start and goal have: a path may come lower between them.
LEAST = 0.1
#: Number of those.
SAMPLES = 200
P, N = ctypes.c_void_p, ctypes.c_long


class _Constraints(ctypes.Structure):
    """`Constraints` of constraints.h."""

    _fields_ = [
        *((name, N) for name in ("n", "rows", "of_tool")),
        *((name, P) for name in ("weights", "tool", "own", "least", "aim", "work")),
    ]


@dataclass(frozen=True, kw_only=True, eq=False)
class SearchConstraints:
    """Constraints for compiled code, with everything that it points to."""

    data: _Constraints
    kept: tuple[Any, ...]

    @classmethod
    def of(
        cls, constraints: ConstraintSet, ends: Array, guarded: Callable[[Callable[[int, int, int], int]], Any]
    ) -> "SearchConstraints | None":
        """The rows of constraints; None where there are only held joints.

        `ends` (2, n) are start and goal, and `guarded` makes functions that C can call back.
        """
        if not constraints.count:
            return None
        n = constraints.robot.n
        weights, aim = np.ascontiguousarray(constraints.weights), _aim(constraints)
        least = np.minimum(LEAST * aim, constraints.values(ends).min(axis=0))
        work = np.empty(POSE + 6 * n + (constraints.count + 1) * (n + 1))
        tool, others = None, None
        if constraints.tool is not None:
            kernel = constraints.tool.kernel
            tool = kernel.run if kernel is not None else guarded(_tool(constraints))
        if constraints.own is not None:
            others = guarded(_own(n, constraints.own))
        data = _Constraints(
            n=n,
            rows=constraints.count,
            of_tool=len(weights),
            weights=weights.ctypes.data,
            tool=None if tool is None else ctypes.cast(tool, P),
            own=None if others is None else ctypes.cast(others, P),
            least=least.ctypes.data,
            aim=aim.ctypes.data,
            work=work.ctypes.data,
        )
        return cls(data=data, kept=(weights, least, aim, work, tool, others))

    @property
    def address(self) -> int:
        """Where the structure is."""
        return ctypes.addressof(self.data)


def _aim(constraints: ConstraintSet) -> Array:
    q = constraints.robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    return np.asarray(np.clip(SHARE * constraints.values(q).max(axis=0), 0.0, AIM))


def _tool(constraints: ConstraintSet) -> Callable[[int, int, int], int]:
    """The tool's pose and Jacobian, by CasADi's virtual machine."""
    n = constraints.robot.n

    def values(q: int, out: int, count: int) -> int:
        assert constraints.tool is not None
        pose, jacobian = constraints.tool.at(_array(q, count, n))
        _array(out, count, POSE + 6 * n)[:] = np.hstack([pose, jacobian.reshape(count, -1)])
        return 0

    return values


def _own(n: int, own: OwnRows) -> Callable[[int, int, int], int]:
    """The rows of a user's class, and then their gradients, for n joints."""

    def values(q: int, out: int, count: int) -> int:
        here = _array(q, count, n)
        found = np.hstack([own.value.by_columns(here), own.gradient.by_columns(here)])
        _array(out, count, own.count * (n + 1))[:] = found
        return 0 if np.isfinite(found).all() else 1

    return values


def _array(address: int, rows: int, columns: int) -> Array:
    numbers: Array = np.ctypeslib.as_array((ctypes.c_double * (rows * columns)).from_address(address))
    return numbers.reshape(rows, columns)
