"""On which side of its singularities an arm with a square Jacobian is: the signs of det J's factors, or of det J itself."""

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from manipplan.kinematics.batch import NativeKernel, run_kernel, wanted_kernel
from manipplan.kinematics.factors import DeterminantFactor, determinant_factors
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.chain import SymbolicChain
from manipplan.symbolic.determinant import determinant
from manipplan.symbolic.task import Task

#: A value counts as zero below this share of its usual size.
ZERO = 1e-6
#: Number of random configurations over which the usual size of det J is a mean.
SAMPLES = 40


@dataclass(frozen=True, kw_only=True, eq=False)
class SingularitySigns:
    """Smooth functions of the configuration whose product is det J, up to a constant: an arm is singular where one is zero.

    Attributes:
        names: the factors' names; ("",) for det J itself, where its factors are not known.
        joints: for each the only joint on which it depends, counted from 0; None for several.
        zero: (f,) absolute values below which one counts as zero.
        function: all of them, (f, 1), of q (n,).
        kernel: their machine code for batches; None where there is no compiler.
    """

    names: tuple[str, ...]
    joints: tuple[int | None, ...]
    zero: Array
    function: ca.Function
    kernel: NativeKernel | None

    def values(self, q: Array) -> Array:
        """The values (k, f) at configurations q (k, n)."""
        if self.kernel is not None:
            found = run_kernel(self.kernel, np.ascontiguousarray(q, dtype=float), len(self.names), threads=1)
            if found is not None:
                return found
        return np.array(self.function(ca.DM(q.T))).T

    def vanishing(self, q: Array) -> list[str]:
        """The names of those that are zero at a configuration (n,)."""
        small = np.abs(self.values(q[None])[0]) < self.zero
        return [name for name, is_small in zip(self.names, small, strict=True) if is_small]

    def changes(self, q: Array) -> int:
        """How often any of them changes its sign along configurations (k, n); where one is zero it keeps the sign before."""
        values = self.values(q)
        return sum(int((np.diff(v[np.abs(v) >= zero] >= 0)).sum()) for v, zero in zip(values.T, self.zero, strict=True))


def sides_of(kinematics: Kinematics) -> SingularitySigns | None:
    """The sides for an arm and task, built once; None for arms with more joints than rows."""
    if not kinematics.is_square:
        return None
    return _sides(kinematics.robot, kinematics.task, kinematics.compiled, kinematics.backend)


@once_per_owner
def _sides(robot: Robot, task: Task, compiled: bool | str, backend: str) -> SingularitySigns:
    is_pose = task.rows == 6 and not (task.world_rows and task.tool_rows)
    factors = determinant_factors(robot) if is_pose else ()
    kinematics = robot.kinematics(task, compiled=compiled, backend=backend)
    function = _factors(robot, factors) if factors else _determinant(kinematics)
    return SingularitySigns(
        names=tuple(each.name for each in factors) or ("",),
        joints=tuple(each.joint for each in factors) or (None,),
        zero=ZERO * (np.array([each.usual for each in factors]) if factors else _usual(function, robot)),
        function=function,
        kernel=wanted_kernel(function, compiled, f"sides of {robot.name}, in batches"),
    )


def _factors(robot: Robot, factors: tuple[DeterminantFactor, ...]) -> ca.Function:
    chain = SymbolicChain.of(robot.model, robot.tool)
    places = chain.joints[1:]
    axes = [place.rotation @ ca.DM(axis) for axis, place in zip(chain.tree.axes, places, strict=True)]
    z, o = _vectors(axes), _vectors([place.origin for place in places])
    values = ca.vertcat(*(each.value(z, o) for each in factors))
    return ca.Function("sides", [chain.q], [ca.densify(values)], ["q"], ["values"])


def _vectors(columns: Sequence[ca.SX]) -> list[list[ca.SX]]:
    return [ca.vertsplit(ca.densify(each)) for each in columns]


def _determinant(kinematics: Kinematics) -> ca.Function:
    value = determinant(kinematics.symbolic.posture.jacobian)
    return ca.Function("sides", [kinematics.chain.q], [ca.densify(value)], ["q"], ["values"])


def _usual(function: ca.Function, robot: Robot) -> Array:
    samples = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    return np.array([float(np.abs(np.array(function(ca.DM(samples.T)))).mean())])
