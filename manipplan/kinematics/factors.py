"""The factors of det J of an arm with six joints: elbow, wrist and shoulder, each of which is a kind of singularity.

Two constructions make det J a product:

- Three neighbouring joints with parallel axes, along n, move three of six directions: turning about n and shifting across it.
  det J is the area that their axes span (the elbow) times a determinant of three rows, for the shift along n and the turns
  across it, of the other three joints. Where two of these have axes that meet, it is the lever of the third (the shoulder)
  times the sine between the two (the wrist).
- Three last joints whose axes meet in a point only turn the tool about it. det J is that of their axes (the wrist) times that
  of the velocity of the point, which the first three joints move (the arm). Where two of those are parallel, the latter is the
  area that the two axes and the point span (the elbow) times the lever of the third (the shoulder).

The product is compared with det J at random configurations before it is used.

On which side of its singularities an arm with a square Jacobian is: the signs of det J's factors, or of det J itself.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import casadi as ca
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.kinematics.batch import BatchKernel, run_kernel
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.model_tree import axis_of, frame_index, is_prismatic
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_source
from manipplan.symbolic.chain import SymbolicChain
from manipplan.symbolic.motion import determinant
from manipplan.symbolic.task import Task

#: Axes count as parallel, or as meeting in a point, within this [rad, or share of the arm's size]: descriptions round them.
ROUNDED = 1e-5
#: Largest deviation of the product of the factors from det J, relative to its size, and number of configurations compared.
AGREEMENT, SAMPLES = 1e-3, 40

#: Directions (6, 3) of the joint axes and a point (6, 3) on each, in the world.
Axes = tuple[Array, Array]
#: A vector of three numbers or symbols per joint.
Vectors = Sequence[Any] | Array
#: A function of the directions and points.
Value = Callable[[Vectors, Vectors], Any]


@dataclass(frozen=True, kw_only=True, eq=False)
class DeterminantFactor:
    """A factor of det J, up to a constant.

    Attributes:
        name: "elbow", "wrist", "shoulder" or "arm".
        joint: the only joint on which it depends, counted from 0; None for several.
        value: the factor as a function of the `Axes`, which can also be symbols.
    """

    name: str
    joint: int | None
    value: Value


@once_per_source
def determinant_factors(robot: Robot) -> tuple[DeterminantFactor, ...]:
    """The factors of det J of the tool's pose; empty where the arm has none of the two constructions.

    Such are all arms that do not have six revolute joints, one after another.
    """
    model = robot.model
    serial = (
        list(model.parents)[1:] == list(range(robot.n)) and model.frames[frame_index(model, robot.tool)].parentJoint == robot.n
    )
    if robot.n != 6 or not serial or any(is_prismatic(joint) for joint in model.joints[1:]):
        return ()
    samples = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    axes = _axes(robot, samples)
    found = _of_three_parallel(axes) or _of_spherical_wrist(axes)
    values = {name: np.array([float(value(*each)) for each in axes]) for name, value in found.items()}
    true = np.array([_determinant_at(*each) for each in axes])
    product = np.prod(list(values.values()), axis=0)
    if not found or not _is_proportional(product, true):
        return ()
    return tuple(
        DeterminantFactor(name=name, joint=_only_joint(robot, value, samples), value=value) for name, value in found.items()
    )


def _axes(robot: Robot, q: Array) -> list[Axes]:
    """The axes at configurations q (k, n)."""
    model, data = robot.model, robot.model.createData()
    own = [axis_of(joint) for joint in model.joints[1:]]
    found = []
    for each in q:
        pin.forwardKinematics(model, data, np.asarray(each, dtype=float))
        frames = list(data.oMi)[1:]
        directions = [frame.rotation @ axis for frame, axis in zip(frames, own, strict=True)]
        found.append((np.array(directions), np.array([frame.translation for frame in frames])))
    return found


def _determinant_at(z: Array, o: Array) -> float:
    """det J of the pose, which does not depend on the tool."""
    return float(np.linalg.det(np.concatenate([np.cross(z, -o), z], axis=1)))


def _of_three_parallel(axes: list[Axes]) -> dict[str, Value]:
    for i in range(1, 3):  # the parallel axes are the second to fourth, or the third to fifth
        rest = [k for k in range(6) if not i <= k <= i + 2]
        if not all(_parallel(z, i, k) for z, _ in axes for k in (i + 1, i + 2)):
            continue
        elbow = partial(_area, n=i, corners=(i, i + 1, i + 2))
        pairs = ((rest[1], rest[2]), (rest[0], rest[1]))
        pair = next((each for each in pairs if all(_meet(z, o, *each) for z, o in axes)), None)
        if pair is None:
            return {"elbow": elbow, "wrist and shoulder": partial(_across, n=i, rest=rest)}
        [single] = [k for k in rest if k not in pair]
        return {
            "elbow": elbow,
            "wrist": partial(_volume, triple=(i, *pair)),
            "shoulder": partial(_lever, n=i, joint=single, pair=pair),
        }
    return {}


def _of_spherical_wrist(axes: list[Axes]) -> dict[str, Value]:
    if not all(_meet(z, o, 3, 4) and _meet(z, o, 4, 5) and _meet_in_a_point(z, o) for z, o in axes):
        return {}
    wrist = partial(_volume, triple=(3, 4, 5))
    for single, a, b in ((0, 1, 2), (2, 0, 1)):
        if all(_parallel(z, a, b) for z, _ in axes):
            elbow, shoulder = partial(_area_to_wrist, a=a, b=b), partial(_lever, n=a, joint=single, pair=(3, 4))
            return {"elbow": elbow, "wrist": wrist, "shoulder": shoulder}
    return {"arm": _velocity_of_wrist, "wrist": wrist}


def _triple(a: Any, b: Any, c: Any) -> Any:
    """The determinant of three vectors."""
    return ca.dot(a, ca.cross(b, c))


def _area(z: Vectors, o: Vectors, *, n: int, corners: tuple[int, int, int]) -> Any:
    """Twice the area that three axes along n span."""
    a, b, c = (o[k] for k in corners)
    return _triple(z[n], b - a, c - a)


def _area_to_wrist(z: Vectors, o: Vectors, *, a: int, b: int) -> Any:
    """Twice the area that two parallel axes and the common point of the last three span."""
    wrist = _common(z, o, 3, 4)
    return _triple(z[a], wrist - o[a], wrist - o[b])


def _volume(z: Vectors, _o: Vectors, *, triple: tuple[int, int, int]) -> Any:
    """The determinant of three directions."""
    return _triple(*(z[k] for k in triple))


def _lever(z: Vectors, o: Vectors, *, n: int, joint: int, pair: tuple[int, int]) -> Any:
    """The velocity along n that a joint gives to the point where the axes of a pair meet."""
    return _triple(z[n], z[joint], _common(z, o, *pair) - o[joint])


def _velocity_of_wrist(z: Vectors, o: Vectors) -> Any:
    """The determinant of the velocities that the first three joints give to the common point of the last three axes."""
    wrist = _common(z, o, 3, 4)
    return _triple(*(ca.cross(z[k], wrist - o[k]) for k in range(3)))


def _across(z: Vectors, o: Vectors, *, n: int, rest: list[int]) -> Any:
    """The determinant of the other joints' shifts along the parallel axes and turns across them."""
    a, b, c = rest
    return sum(_triple(z[n], o[i], z[i]) * _triple(z[n], z[j], z[k]) for i, j, k in ((a, b, c), (b, c, a), (c, a, b)))


def _common(z: Vectors, o: Vectors, a: int, b: int) -> Any:
    """The point on axis `a` nearest to axis `b`."""
    cosine, between = ca.dot(z[a], z[b]), o[b] - o[a]
    along = (ca.dot(between, z[a]) - cosine * ca.dot(between, z[b])) / (1 - cosine * cosine)
    return o[a] + along * z[a]


def _parallel(z: Array, a: int, b: int) -> bool:
    return bool(np.linalg.norm(np.cross(z[a], z[b])) < ROUNDED)


def _meet(z: Array, o: Array, a: int, b: int) -> bool:
    """Whether two axes that are not parallel meet."""
    across = np.cross(z[a], z[b])
    return bool(np.linalg.norm(across) > ROUNDED and abs(across @ (o[b] - o[a])) < ROUNDED * _size(o) * np.linalg.norm(across))


def _meet_in_a_point(z: Array, o: Array) -> bool:
    """Whether the last three axes meet in one point."""
    return bool(ca.norm_2(_common(z, o, 3, 4) - _common(z, o, 4, 5)) < ROUNDED * _size(o))


def _size(o: Array) -> float:
    return float(np.linalg.norm(np.diff(o, axis=0), axis=1).sum())


def _only_joint(robot: Robot, value: Value, samples: Array) -> int | None:
    """The joint on which a function of the axes depends, if it is only one."""

    def values(q: Array) -> Array:
        return np.array([float(value(*each)) for each in _axes(robot, q)])

    here = values(samples)
    changes = [np.abs(values(samples + 0.7 * moved) - here).max() for moved in np.eye(6)]
    moving = [joint for joint, change in enumerate(changes) if change > 1e-3 * max(changes)]
    return moving[0] if len(moving) == 1 else None


#: Number of random configurations in which joints that do not move the tool are looked for, and the largest entry of their
#: columns of the Jacobian, as a share of the largest of all.
POSTURES, IDLE = 50, 1e-9
#: A value counts as zero below this share of its mean size over a number of random configurations.
ZERO, SIGN_SAMPLES = 1e-6, 40


@dataclass(frozen=True, kw_only=True, eq=False)
class SingularitySigns:
    """Smooth functions of the configuration whose product is det J, up to a constant: an arm is singular where one is zero.

    Attributes:
        names: the factors' names; ("",) for det J itself, where its factors are not known.
        joints: for each the only joint on which it depends, counted from 0; None for several.
        zero: (f,) absolute values below which one counts as zero.
        kernel: all of them, (f,) at each of many q (n,).
    """

    names: tuple[str, ...]
    joints: tuple[int | None, ...]
    zero: Array
    kernel: BatchKernel

    def values(self, q: Array) -> Array:
        """The values (k, f) at configurations q (k, n)."""
        found = run_kernel(self.kernel, np.ascontiguousarray(q, dtype=float), len(self.names), threads=1)
        if found is None:
            raise InvalidInputError("q", q, "finite numbers, no NaN or inf")
        return found

    def vanishing(self, q: Array) -> list[str]:
        """The names of those that are zero at a configuration (n,)."""
        small = np.abs(self.values(q[None])[0]) < self.zero
        return [name for name, is_small in zip(self.names, small, strict=True) if is_small]

    def changes(self, q: Array) -> int:
        """How often any of them changes its sign along configurations (k, n); where one is zero it keeps the sign before."""
        values = self.values(q)
        return sum(int((np.diff(v[np.abs(v) >= zero] >= 0)).sum()) for v, zero in zip(values.T, self.zero, strict=True))


def idle_joints(kinematics: Kinematics) -> NDArray[np.bool_]:
    """Which joints (n,) never move the tool as the task counts it, such as one whose axis the tool lies on."""
    q = kinematics.robot.random_configuration(np.random.default_rng(0), size=POSTURES)
    jacobians = np.abs(kinematics.jacobian(q))
    return np.asarray(jacobians.max(axis=(0, 1)) <= IDLE * jacobians.max())


def singularity_signs(kinematics: Kinematics) -> SingularitySigns | None:
    """The signs for an arm and task, built once; None for arms with more joints than rows, but for those that are idle."""
    if kinematics.measure.over_tools or kinematics.measure.constant:
        return None
    return _singularity_signs(kinematics.robot, kinematics.task, kinematics.compiled, kinematics.backend)


@once_per_source
def _singularity_signs(robot: Robot, task: Task, compiled: bool | str, backend: str) -> SingularitySigns | None:
    kinematics = robot.kinematics(task, compiled=compiled, backend=backend)
    moving = np.ones(robot.n, dtype=np.bool_) if robot.n == task.rows else ~idle_joints(kinematics)
    if moving.sum() != task.rows:
        return None
    q = robot.random_configuration(np.random.default_rng(0), size=SIGN_SAMPLES)
    factors, function = determinant_factors(robot), _determinant_function(kinematics, moving)
    if factors:
        product = _factors(robot, factors)
        if _is_proportional(np.prod(np.array(product(ca.DM(q.T))), axis=0), np.array(function(ca.DM(q.T)))[0]):
            function = product
        else:
            factors = ()
    return SingularitySigns(
        names=tuple(each.name for each in factors) or ("",),
        joints=tuple(each.joint for each in factors) or (None,),
        zero=ZERO * np.abs(np.array(function(ca.DM(q.T)))).mean(axis=1),
        kernel=BatchKernel(function, compiled, f"signs of {robot.name}, in batches"),
    )


def _is_proportional(product: Array, true: Array) -> bool:
    """Whether true values (k,) are a multiple of those of a product, which is not zero everywhere."""
    if not product.any():
        return False
    scale = float(true @ product / (product @ product))
    return bool(np.abs(true - scale * product).max() <= AGREEMENT * np.abs(true).max())


def _factors(robot: Robot, factors: tuple[DeterminantFactor, ...]) -> ca.Function:
    chain = SymbolicChain.of(robot.model, robot.tool)
    frames = chain.joints[1:]
    z = [frame.rotation @ ca.DM(axis) for axis, frame in zip(chain.tree.axes, frames, strict=True)]
    values = ca.vertcat(*(each.value(z, [frame.origin for frame in frames]) for each in factors))
    return ca.Function("signs", [chain.q], [ca.densify(values)], ["q"], ["values"])


def _determinant_function(kinematics: Kinematics, moving: NDArray[np.bool_]) -> ca.Function:
    value = determinant(kinematics.symbolic.posture.jacobian[:, np.flatnonzero(moving).tolist()])
    return ca.Function("signs", [kinematics.chain.q], [ca.densify(value)], ["q"], ["values"])
