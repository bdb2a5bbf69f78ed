"""The factors of det J of an arm with six joints: elbow, wrist and shoulder, each of which is a kind of singularity.

Two constructions make det J a product [angeles2014, sec. 5.8]:

- Three neighbouring joints with parallel axes, along n, move three of six directions: turning about n and shifting across it.
  det J is the area that their axes span (the elbow) times a determinant of three rows, for the shift along n and the turns
  across it, of the other three joints. Where two of these have axes that meet, it is the lever of the third (the shoulder)
  times the sine between the two (the wrist).
- Three last joints whose axes meet in a point only turn the tool about it. det J is that of their axes (the wrist) times that
  of the velocity of the point, which the first three joints move (the arm). Where two of those are parallel, the latter is the
  area that the two axes and the point span (the elbow) times the lever of the third (the shoulder).

The product is compared with det J at random configurations before it is used.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from manipplan.robots.model_tree import axis_of, frame_index, is_prismatic
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner

#: Axes count as parallel, or as meeting in a point, within this [rad, or share of the arm's size]: descriptions round them.
ROUNDED = 1e-5
#: Largest deviation of the product of the factors from det J, relative to its size, and number of configurations compared.
AGREEMENT, SAMPLES = 1e-3, 40

#: Directions (n, 3) of the joint axes and a point (n, 3) on each, in the world.
Axes = tuple[Array, Array]


@dataclass(frozen=True, kw_only=True, eq=False)
class DeterminantFactor:
    """A factor of det J, up to a constant.

    Attributes:
        name: "elbow", "wrist", "shoulder" or "arm".
        joint: the only joint on which it depends, counted from 0; None for several.
    """

    name: str
    joint: int | None
    _value: Callable[[Array, Array], float]
    _robot: Robot

    def __call__(self, q: Array) -> Array:
        """Values (k,) at configurations q (k, n)."""
        return np.array([self._value(*_axes(self._robot, each)) for each in q])


@once_per_owner
def determinant_factors(robot: Robot) -> tuple[DeterminantFactor, ...]:
    """The factors of det J of the tool's pose; empty where the arm has none of the two constructions.

    Such are all arms that do not have six revolute joints, one after another.
    """
    model = robot.model
    serial = list(model.parents)[1:] == list(range(robot.n)) and model.frames[frame_index(model, robot.tool)].parentJoint == robot.n
    if robot.n != 6 or not serial or any(is_prismatic(joint) for joint in model.joints[1:]):
        return ()
    samples = robot.random_configuration(np.random.default_rng(0), size=SAMPLES)
    axes = [_axes(robot, q) for q in samples]
    found = _of_three_parallel(axes) or _of_spherical_wrist(axes)
    factors = [
        DeterminantFactor(name=name, joint=_only_joint(robot, value, samples[0]), _value=value, _robot=robot)
        for name, value in found
    ]
    if not factors:
        return ()
    true = np.linalg.det(robot.kinematics().jacobian(samples))
    product = np.prod([factor(samples) for factor in factors], axis=0)
    scale = float(true @ product / (product @ product))
    agrees = np.abs(true - scale * product).max() <= AGREEMENT * np.abs(true).max()
    return tuple(factors) if agrees else ()


def _axes(robot: Robot, q: Array) -> Axes:
    model, data = robot.model, _data(robot)
    pin.forwardKinematics(model, data, np.asarray(q, dtype=float))
    places = list(data.oMi)[1:]
    directions = [place.rotation @ axis_of(joint) for place, joint in zip(places, model.joints[1:], strict=True)]
    return np.array(directions), np.array([place.translation for place in places])


def _of_three_parallel(axes: list[Axes]) -> list[tuple[str, Callable[[Array, Array], float]]]:
    for i in range(1, 3):  # the three are in the middle, or come second
        three, rest = [i, i + 1, i + 2], [k for k in range(6) if not i <= k <= i + 2]
        if all(_parallel(z, three[0], k) for z, _ in axes for k in three[1:]):
            elbow = ("elbow", lambda z, o, i=i: float(z[i] @ np.cross(o[i + 1] - o[i], o[i + 2] - o[i])))
            pair = next(((a, b) for a, b in ((rest[1], rest[2]), (rest[0], rest[1])) if all(_meet(*each, a, b) for each in axes)), None)
            if pair is None:
                return [elbow, ("wrist and shoulder", lambda z, o, i=i, rest=rest: _across(z, o, i, rest))]
            single = next(k for k in rest if k not in pair)
            return [
                elbow,
                ("wrist", lambda z, o, i=i, pair=pair: float(z[i] @ np.cross(z[pair[0]], z[pair[1]]))),
                ("shoulder", lambda z, o, i=i, pair=pair, k=single: float(z[i] @ np.cross(z[k], _common(z, o, *pair) - o[k]))),
            ]
    return []


def _of_spherical_wrist(axes: list[Axes]) -> list[tuple[str, Callable[[Array, Array], float]]]:
    if not all(_meet(*each, 3, 4) and _meet(*each, 4, 5) and _near(*each) for each in axes):
        return []
    wrist = ("wrist", lambda z, o: float(z[3] @ np.cross(z[4], z[5])))
    for single, a, b in ((0, 1, 2), (2, 0, 1)):
        if all(_parallel(z, a, b) for z, _ in axes):
            return [
                ("elbow", lambda z, o, a=a, b=b: float(z[a] @ np.cross(_wrist(z, o) - o[a], _wrist(z, o) - o[b]))),
                wrist,
                ("shoulder", lambda z, o, a=a, k=single: float(z[a] @ np.cross(z[k], _wrist(z, o) - o[k]))),
            ]
    return [("arm", lambda z, o: float(np.linalg.det(np.cross(z[:3], _wrist(z, o) - o[:3])))), wrist]


def _across(z: Array, o: Array, i: int, rest: list[int]) -> float:
    """The determinant of the other joints' shifts along the parallel axes and turns across them."""
    n = z[i]
    e = np.linalg.svd(n[None])[2][1:]
    e = e if n @ np.cross(e[0], e[1]) > 0 else e[::-1]
    rows = [[n @ np.cross(z[k], -o[k]) for k in rest], *([each @ z[k] for k in rest] for each in e)]
    return float(np.linalg.det(np.array(rows)))


def _parallel(z: Array, a: int, b: int) -> bool:
    return bool(np.linalg.norm(np.cross(z[a], z[b])) < ROUNDED)


def _meet(z: Array, o: Array, a: int, b: int) -> bool:
    """Whether two axes that are not parallel meet."""
    across = np.cross(z[a], z[b])
    return bool(np.linalg.norm(across) > ROUNDED and abs(across @ (o[b] - o[a])) < ROUNDED * _size(o) * np.linalg.norm(across))


def _near(z: Array, o: Array) -> bool:
    """Whether the last three axes meet in one point."""
    return bool(np.linalg.norm(_wrist(z, o) - _common(z, o, 4, 5)) < ROUNDED * _size(o))


def _wrist(z: Array, o: Array) -> Array:
    return _common(z, o, 3, 4)


def _common(z: Array, o: Array, a: int, b: int) -> Array:
    """The point (3,) on axis `a` nearest to axis `b`."""
    cosine, between = z[a] @ z[b], o[b] - o[a]
    along = (between @ z[a] - cosine * (between @ z[b])) / (1 - cosine**2)
    return np.asarray(o[a] + along * z[a])


def _size(o: Array) -> float:
    return float(np.linalg.norm(np.diff(o, axis=0), axis=1).sum())


def _only_joint(robot: Robot, value: Callable[[Array, Array], float], q: Array) -> int | None:
    """The joint on which a function of the axes depends, if it is only one."""
    here = value(*_axes(robot, q))
    changes = []
    for joint in range(6):
        moved = q.copy()
        moved[joint] += 0.7
        changes.append(abs(value(*_axes(robot, moved)) - here))
    most = max(changes)
    moving = [joint for joint, change in enumerate(changes) if change > 1e-3 * most]
    return moving[0] if len(moving) == 1 else None


@once_per_owner
def _data(robot: Robot) -> pin.Data:
    return robot.model.createData()
