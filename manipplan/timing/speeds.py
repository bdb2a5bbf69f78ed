"""The fastest speed along a piece of path under limits of velocity, acceleration and torque, by toppra."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.deadline import building
from manipplan.support.display import round_down
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.dynamics import PathDynamics

#: Relative tolerance by which a given speed may exceed the limits, for rounding in the caller's arithmetic.
DIGITS = 1e-9


def fastest_speeds(
    demands: PathDynamics, names: Sequence[str], given: Callable[[float], float], start: float = 0.0, end: float = 0.0
) -> Array:
    """Speed dl/dt [rad/s] at each grid point (k,), from `start` to `end` [rad/s].

    Raises InvalidInputError when limits do not allow these speeds, PlanningError when no speed is within the limits;
    `given` converts a path parameter into that of the given path, for the message.
    """
    unit = demands.speed_unit
    _check_end("start_speed", start, demands, names, given, 0)
    _check_end("end_speed", end, demands, names, given, -1)
    algorithm = _algorithm(demands)
    first = min((start / unit) ** 2, demands.fastest[0])
    last = min((end / unit) ** 2, demands.fastest[-1])
    _, speed, _ = algorithm.compute_parameterization(np.sqrt(first), np.sqrt(last))
    if speed is None or not np.isfinite(speed).all():
        raise _failure(demands, names, given, start, end)
    speed = np.asarray(np.maximum(speed, 0.0), dtype=float)
    if (speed[1:-1] <= 0).any():
        k = int(np.flatnonzero(speed[1:-1] <= 0)[0]) + 1
        raise PlanningError(
            f"the motion comes to rest inside the path, {_place(demands, k, given)}; {_binding(demands, names, k)}"
        )
    return speed * unit


def _algorithm(demands: PathDynamics) -> Any:
    """toppra's algorithm with our rows."""
    with building():
        import toppra
        from toppra.constraint import LinearConstraint
        from toppra.constraint.linear_constraint import canlinear_colloc_to_interpolate
        from toppra.interpolator import AbstractGeometricPath

    count = demands.tangent.shape[1]
    rows = demands.u.shape[1]

    class Geometric(AbstractGeometricPath):  # type: ignore[misc]  # toppra has no stubs
        dof = count
        path_interval = np.array([0.0, 1.0])
        waypoints = None

        def __call__(self, _places: Any, _order: int = 0) -> Array:
            raise NotImplementedError

    class Speed(LinearConstraint):  # type: ignore[misc]
        dof = count

        def compute_constraint_params(self, *_: Any) -> tuple[Any, ...]:
            bound = np.column_stack([np.zeros(len(demands.fastest)), np.minimum(demands.fastest, 1e12)])
            return None, None, None, None, None, None, bound

    class Rows(LinearConstraint):  # type: ignore[misc]
        dof = count

        def __init__(self) -> None:
            super().__init__()
            self.identical = True

        def compute_constraint_params(self, _path: Any, points: Array, *_: Any) -> tuple[Any, ...]:
            both = np.vstack([np.eye(rows), -np.eye(rows)])
            return tuple(
                canlinear_colloc_to_interpolate(
                    demands.u, demands.x, demands.constant, both, np.ones(2 * rows), None, None, points, identical=True
                )
            )

    return toppra.algorithm.TOPPRA([Speed(), Rows()], Geometric(), gridpoints=demands.at, solver_wrapper="seidel")


def _place(demands: PathDynamics, k: int, given: Callable[[float], float]) -> str:
    return f"at s = {given(float(demands.curve.s(demands.length[k]))):.4f}"


def _binding(demands: PathDynamics, names: Sequence[str], k: int) -> str:
    """The joint and kind of the tightest limit at grid point k, as a sentence."""
    n = len(names)
    row = int(np.argmax(np.abs(demands.constant[k]) + 1e-9 * np.abs(demands.x[k])))
    kind = "acceleration" if row < n else "effort"
    return f"the {kind} limit of {names[row % n]} allows no motion"


def _check_end(
    name: str, speed: float, demands: PathDynamics, names: Sequence[str], given: Callable[[float], float], k: int
) -> None:
    most = float(np.sqrt(demands.fastest[k]) * demands.speed_unit)
    if speed <= most * (1 + DIGITS):
        return
    ratio = np.abs(demands.tangent[k]) / demands.bounds.velocity[k]
    joint = int(np.argmax(ratio))
    by_joint = most * ratio[joint] / demands.curve.length > 1 - 1e-6
    whose = f"the velocity limit of {names[joint]}" if by_joint else "the tool speed limit of a segment"
    allowed = f"0 to {round_down(most, 6):.6g}: {whose} allows no higher speed {_place(demands, k, given)}"
    raise InvalidInputError(name, speed, allowed)


def _failure(
    demands: PathDynamics, names: Sequence[str], given: Callable[[float], float], start: float, end: float
) -> Exception:
    """The error to raise, with the reason why there is no motion."""
    if end > 0 and (most := _most(demands, end, lambda speed: (start, speed))) is not None:
        return InvalidInputError(
            "end_speed", end, f"0 to {most:.6g}: a higher one cannot be reached from start_speed = {start:g} within the limits"
        )
    if start > 0 and (most := _most(demands, start, lambda speed: (speed, 0.0))) is not None:
        return InvalidInputError(
            "start_speed", start, f"0 to {most:.6g}: from a higher one the arm cannot slow down in time for the path ahead"
        )
    ahead = _algorithm(demands).compute_controllable_sets(0.0, 0.0)
    empty = np.flatnonzero(~np.isfinite(ahead).all(axis=1))
    k = int(empty[-1]) if len(empty) else 0
    return PlanningError(f"no motion is within the limits: {_binding(demands, names, k)} {_place(demands, k, given)}")


def _most(demands: PathDynamics, given: float, ends: Callable[[float], tuple[float, float]]) -> float | None:
    """The largest speed below the given one that allows a motion, rounded down; None when even 0 does not."""
    algorithm = _algorithm(demands)

    def works(speed: float) -> bool:
        _, found, _ = algorithm.compute_parameterization(*(each / demands.speed_unit for each in ends(speed)))
        return found is not None and bool(np.isfinite(found).all())

    if not works(0.0):
        return None
    low, high = 0.0, given
    for _ in range(16):
        middle = (low + high) / 2
        low, high = (middle, high) if works(middle) else (low, middle)
    return round_down(low, 4)
