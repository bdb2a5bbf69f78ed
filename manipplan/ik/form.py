"""Selects the closed form that fits an arm and the joints that it holds at sampled values.

All solutions of a closed form for many poses and values of the held joints, by `inverse.c`.
"""

import ctypes
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.bridge import SKEW, arrangement, as_bool, as_float64, as_int64, ik_functions
from manipplan.ik.geometry import EXACT, MEETS, Screws
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, one_of, texts
from manipplan.support.errors import InvalidInputError
from manipplan.support.kernels import struct
from manipplan.support.memo import once_per_source
from manipplan.symbolic.task import Task

#: Solver of a closed form; as in inverse.c.
SPHERICAL, PARALLEL, SWIVEL = range(3)
NAMES = ("spherical", "parallel", "swivel")


@dataclass(frozen=True, kw_only=True, eq=False)
class ClosedForm:
    """A solver for one arm: with the held joints (and a swivel) fixed, it has finitely many solutions.

    Attributes:
        screws: the arm.
        solver: SPHERICAL, PARALLEL or SWIVEL.
        held: indices of the joints that are held, ascending.
        free: indices of the other joints in the solver's order.
        backward: whether the solver reads the chain from the tool to the base.
        meeting: (2, 3) the point where the last three (or two) free axes meet, and the shoulder of SWIVEL.
        triple: index of the joint that carries the first of these points.
        miss: deviation of the arm from the geometry that the form assumes [m or rad].
    """

    screws: Screws
    solver: int
    held: tuple[int, ...]
    free: tuple[int, ...]
    backward: bool
    meeting: Array
    triple: int
    miss: float

    @property
    def exact(self) -> bool:
        """Whether the form fits the arm exactly, and not only up to the rounding of its description."""
        return self.miss < EXACT

    @property
    def name(self) -> str:
        """Name of the method."""
        return NAMES[self.solver]

    @property
    def moves_axes(self) -> bool:
        """Whether a held joint lies between free ones, so that it moves some of their axes relative to others."""
        return any(min(self.free) < joint < max(self.free) for joint in self.held)


def closed_form(robot: Robot, held: Sequence[str] | None = None) -> ClosedForm | None:
    """The simplest closed form of an arm, with the joints in `held` held; None where there is none.

    Raises UnknownNameError or InvalidInputError where `held` names unknown joints, or not exactly n - 6 joints.
    """
    if robot.n < 6 or robot.planar:
        return None
    chosen = held_indices(robot, held, robot.n - 6) if held is not None else None
    return _closed_form(robot, chosen)


@once_per_source
def _closed_form(robot: Robot, held: tuple[int, ...] | None) -> ClosedForm | None:
    screws = Screws.of(robot)
    if screws.follow is not None:
        return None
    if held is not None and not _moves_everywhere(robot, held):
        wanted = "joints that can be held while the others still move the tool in all directions"
        raise InvalidInputError("held", [robot.joint_names[k] for k in held], wanted)
    return _simplest(screws, held)


def _simplest(screws: Screws, held: tuple[int, ...] | None) -> ClosedForm | None:
    if held is None:
        swivel = _swivel(screws)
        if swivel is not None:
            return swivel
    choices = [held] if held is not None else combinations(range(screws.n), screws.n - 6)
    forms = [form for chosen in choices for form in _six_joints(screws, chosen)]
    return min(forms, key=_effort, default=None)


def held_indices(robot: Robot, held: Sequence[str], count: int) -> tuple[int, ...]:
    """The indices of `count` joints, ascending; raises UnknownNameError or InvalidInputError."""
    for name in texts("held", held):
        one_of("held", name, robot.joint_names)
    if len(set(held)) != count or len(held) != count:
        raise InvalidInputError("held", list(held), f"{count} different joints, the arm's degree of redundancy")
    return tuple(sorted(robot.joint_names.index(name) for name in held))


def _moves_everywhere(robot: Robot, held: tuple[int, ...]) -> bool:
    """Whether the joints that are not held move the tool in all six degrees of freedom."""
    q = robot.random_configuration(np.random.default_rng(0), size=5)
    jacobians = np.delete(robot.kinematics(Task.pose()).jacobian(q), held, axis=2)
    return int(np.linalg.matrix_rank(jacobians, tol=1e-8).max()) == 6


def _swivel(screws: Screws) -> ClosedForm | None:
    """The form with held joints, a spherical shoulder, an elbow and a spherical wrist, if it fits."""
    n = screws.n
    if n < 7:
        return None
    first = n - 7
    shoulder = screws.meeting_point((first, first + 1, first + 2))
    wrist = screws.meeting_point((n - 3, n - 2, n - 1))
    if shoulder is None or wrist is None or screws.slides[first:].any():
        return None
    h, p = screws.axes[first + 3], screws.points[first + 3]
    off = np.cross(h, [shoulder[0] - p, wrist[0] - p])
    if np.linalg.norm(off, axis=1).min() < 1e-6:  # the elbow would not change the reach
        return None
    return ClosedForm(
        screws=screws,
        solver=SWIVEL,
        held=tuple(range(first)),
        free=tuple(range(first, n)),
        backward=False,
        meeting=np.array([wrist[0], shoulder[0]]),
        triple=n - 3,
        miss=max(shoulder[1], wrist[1]),
    )


def _six_joints(screws: Screws, held: tuple[int, ...]) -> list[ClosedForm]:
    """All closed forms of the six remaining joints."""
    free = tuple(k for k in range(screws.n) if k not in held)
    if screws.slides[list(free)].any():
        return []
    forms = []
    for backward in (False, True):
        order = free[::-1] if backward else free
        for solver, meeting in ((SPHERICAL, order[3:]), (PARALLEL, order[4:])):
            between = any(min(meeting) < joint < max(meeting) for joint in held)
            point = None if between else _meeting(screws, meeting)
            if point is None:
                continue
            miss = point[1]
            if solver == PARALLEL:
                middle = order[1:4]
                between = any(min(middle) < joint < max(middle) for joint in held)
                if between or screws.askew(*middle) > MEETS or screws.askew(order[0], order[1]) < MEETS:
                    continue
                miss = max(miss, screws.askew(*middle))
            else:
                miss = max(miss, arrangement(screws.axes[list(order)], screws.points[list(order)])[2])
            forms.append(
                ClosedForm(
                    screws=screws,
                    solver=solver,
                    held=held,
                    free=order,
                    backward=backward,
                    meeting=np.array([point[0], np.zeros(3)]),
                    triple=meeting[0],
                    miss=miss,
                )
            )
    return forms


def _meeting(screws: Screws, joints: tuple[int, ...]) -> tuple[Array, float] | None:
    if len(joints) == 2 and screws.askew(*joints) < MEETS:
        return None
    return screws.meeting_point(joints)


def _effort(form: ClosedForm) -> tuple[int, int, int, int]:
    """Sort key, fastest form first: axes to be moved, a quartic, a backward chain, joints held far from the base."""
    free = list(form.free)
    skew = form.solver == SPHERICAL and arrangement(form.screws.axes[free], form.screws.points[free])[0] == SKEW
    return int(form.moves_axes), int(skew), int(form.backward), sum(form.held)


#: Number of samples that a block of solutions is sized for.
CHUNK = 8192
#: As in spherical.h: amount by which a solution may exceed a limit [rad], and maximum number of solutions.
AT_LIMIT, MOST = 1e-5, 8


class Enumeration:
    """Enumerates the solutions of one closed form inside limits; threads may share it.

    Joints without limits are in [-π, π]; others are listed at every full turn inside the limits.

    Args:
        form: the arm's closed form.
        lower, upper: (n,) limits [rad or m]; infinite on both sides for continuous joints.
        axis: (3,) tool axis about which the tool is free to rotate; None for a full pose.
    """

    def __init__(self, form: ClosedForm, lower: Array, upper: Array, axis: Array | None) -> None:
        screws, endless = form.screws, np.isinf(lower)
        # inverse.c undoes the held joints in this order: of those behind all free joints, the outermost comes first
        behind = [k for k, joint in enumerate(form.held) if joint > max(form.free)]
        self._order = [*(k for k in range(len(form.held)) if k not in behind), *reversed(behind)]
        low, high = np.where(endless, -np.pi, lower), np.where(endless, np.pi, upper)
        turns = np.where(endless, 0, (high - low + 2 * AT_LIMIT) // (2 * np.pi))[list(form.free)]
        self._n, self._most = screws.n, MOST * int(np.prod(np.maximum(turns + 1, 1)))
        self._arrays: dict[str, NDArray[Any]] = {
            "axes": as_float64(screws.axes),
            "points": as_float64(screws.points),
            "slides": as_bool(screws.slides),
            "held": as_int64([form.held[k] for k in self._order]),
            "free": as_int64(form.free),
            "meeting": as_float64(form.meeting),
            "home": as_float64(np.linalg.inv(screws.home)),
            "lower": as_float64(low),
            "upper": as_float64(high),
            "endless": as_bool(endless),
            "turning": as_float64(axis if axis is not None else np.zeros(3)),
        }
        self._form = struct("inverse", "Form")(
            n=screws.n,
            helds=len(form.held),
            frees=len(form.free),
            solver=form.solver,
            backward=form.backward,
            moves_axes=form.moves_axes,
            triple=form.triple,
            **{name: array.ctypes.data for name, array in self._arrays.items()},
        )

    def __call__(
        self, poses: Array, owners: NDArray[np.int64], samples: Array
    ) -> Iterator[tuple[Array, NDArray[np.int64], int]]:
        """Blocks of solutions q (k, n), with the sample (k,) of each, and the number of samples solved so far.

        Args:
            poses: (p, 4, 4).
            owners: (s,) pose index of each sample.
            samples: (s, r) values of the held joints, then the swivel, then the rotation about `axis` where it is free.
        """
        columns = [*self._order, *range(len(self._order), samples.shape[1])]
        poses, owners, samples = as_float64(poses), as_int64(owners), as_float64(samples[:, columns])
        asked = struct("inverse", "Samples")(
            poses=poses.ctypes.data,
            owners=owners.ctypes.data,
            values=samples.ctypes.data,
            count=len(samples),
            width=samples.shape[1],
        )
        rows = max(4 * self._most, min(len(samples) * MOST, CHUNK * MOST))
        work, begin, call = np.empty(6 * self._n), 0, ik_functions()["solutions"]
        while begin < len(samples):
            out, source = np.empty((rows, self._n)), np.empty(rows, dtype=np.int64)
            found = struct("inverse", "Solutions")(out=out.ctypes.data, source=source.ctypes.data, rows=rows)
            begin = call(
                ctypes.addressof(self._form),
                ctypes.addressof(asked),
                begin,
                self._most,
                work.ctypes.data,
                ctypes.addressof(found),
            )
            yield out[: found.filled], source[: found.filled], begin
