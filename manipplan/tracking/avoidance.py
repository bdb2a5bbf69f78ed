"""Collision avoidance as rows of the QP: velocity dampers on closest points, (A.1) and (A.2) in dufour2020."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from manipplan.collision import shapes
from manipplan.collision.build import check_names
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike, array_of_shape, flag, instance, number, one_of, texts
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.symbolic.chain import Placement, SymbolicChain
from manipplan.tracking.bodies import (
    CapsuleBodies,
    CapsuleBody,
    NearestPoints,
    SymbolicBox,
    SymbolicCapsule,
    SymbolicPlane,
    nearest,
)
from manipplan.tracking.bounds import nearest_rotation

#: Number of values per moving obstacle: rotation (9, column by column), position (3), linear and angular velocity (3 each).
OBSTACLE_SIZE = 18
#: Share of the joints' acceleration limits with which bodies can be braked: not all joints help, and normals turn on the way.
BRAKING = 0.5


@one_line
@dataclass(frozen=True, kw_only=True)
class Avoidance:
    """Obstacles and links that a controller keeps apart, and its distances.

    Two bodies closer than `influence` may approach at no more than ξ (d - d_s)/(d_i - d_s). A servo also moves toward bodies at
    any distance only as fast as it can stop in time. Links are modelled as capsules that contain them; pairs of the robot's own
    links for which capsules are too coarse are left out (`Controller.unguarded` names them). Each pair costs 0.1 µs per step,
    and time to compile: name the links that matter.

    Attributes:
        scene: obstacles; spheres, capsules, boxes, cylinders (as enclosing capsules) and planes.
        influence: d_i > d_s [m].
        security: d_s >= 0 [m].
        damping: ξ > 0 [m/s].
        moving: names of obstacles whose pose and velocity are given at every step.
        links: names of the links that avoid collisions; None: all moving links.
        itself: whether self-collisions are avoided.
    """

    scene: Scene = field(default_factory=Scene)
    influence: float = 0.1
    security: float = 0.02
    damping: float = 0.5
    moving: Sequence[str] = ()
    links: Sequence[str] | None = None
    itself: bool = True

    def __post_init__(self) -> None:
        instance("scene", self.scene, Scene)
        number("security", self.security, least=0.0)
        number("influence", self.influence, above=self.security)
        number("damping", self.damping, above=0.0)
        flag("itself", self.itself)
        object.__setattr__(self, "moving", texts("moving", self.moving))
        object.__setattr__(self, "links", None if self.links is None else texts("links", self.links))
        for name in self.moving:
            one_of("moving", name, self.scene.names)
        for obstacle in self.scene.obstacles:
            _shape(obstacle, _constant(obstacle))


@dataclass(frozen=True, kw_only=True)
class AvoidanceRows:
    """Rows a_k q̇ >= b_k: symbolic (k, n) and (k, 1), the distances d_k (k, 1) [m], and their pairs of bodies.

    Attributes:
        matrix, bound, distance: as above; b is -inf beyond the distance of influence where braking in time is not asked for.
        obstacles: symbols of the moving obstacles, OBSTACLE_SIZE numbers each.
        names: pairs of names.
    """

    matrix: ca.SX
    bound: ca.SX
    distance: ca.SX
    obstacles: ca.SX
    names: tuple[tuple[str, str], ...]


def avoidance_rows(robot: Robot, chain: SymbolicChain, avoidance: Avoidance, *, brakes_in_time: bool = False) -> AvoidanceRows:
    """The rows of a robot at the symbolic configuration of `chain`.

    With `brakes_in_time` the robot moves toward bodies at any distance only as fast as its acceleration limits let it stop.

    Raises InvalidInputError for a robot without collision geometry, UnknownNameError for an unknown link or an unknown name in
    an allowed pair.
    """
    check_names(robot, avoidance.scene)
    bodies = CapsuleBodies.of(robot)
    guarded = _find_guarded(robot, bodies, avoidance)
    symbols = ca.SX.sym("obstacles", OBSTACLE_SIZE * len(avoidance.moving))
    lines, limits = _lines(chain), robot.limits if brakes_in_time else None
    rows: list[tuple[ca.SX, ca.SX, ca.SX]] = []
    names: list[tuple[str, str]] = []
    for name, obstacle in zip(avoidance.scene.names, avoidance.scene.obstacles, strict=True):
        motion = _motion(symbols, avoidance.moving.index(name)) if name in avoidance.moving else None
        placement = motion[0] if motion else _constant(obstacle)
        for body in guarded:
            if frozenset((body.link, name)) in avoidance.scene.allowed:
                continue
            near = nearest(_capsule(chain, body), _shape(obstacle, placement))
            approach = ca.dot(near.normal, _velocity_at(motion, near.second)) if motion else ca.SX(0)
            rows.append(_row(avoidance, near, _rate(chain, lines, body.joint, near.first, near.normal), approach, limits))
            names.append((body.name, name))
    if avoidance.itself:
        for i, j in bodies.pairs:
            first, second = bodies.items[i], bodies.items[j]
            unguarded = first not in guarded and second not in guarded
            if unguarded or frozenset((first.link, second.link)) in avoidance.scene.allowed:
                continue
            near = nearest(_capsule(chain, first), _capsule(chain, second))
            rate = _rate(chain, lines, first.joint, near.first, near.normal)
            rate -= _rate(chain, lines, second.joint, near.second, near.normal)
            rows.append(_row(avoidance, near, rate, ca.SX(0), limits))
            names.append((first.name, second.name))
    if not rows:
        raise InvalidInputError(
            "avoidance", repr(avoidance.scene), "at least one obstacle, or itself=True for an arm that can collide with itself"
        )
    matrix, bound, distance = (ca.vertcat(*column) for column in zip(*rows, strict=True))
    return AvoidanceRows(matrix=matrix, bound=bound, distance=distance, obstacles=symbols, names=tuple(names))


def set_moving(avoidance: Avoidance | None, obstacles: Mapping[str, tuple[Any, ArrayLike]], numbers: Array) -> None:
    """Write the poses (4, 4) or SE3 and velocities (6,), linear first, of moving obstacles to their OBSTACLE_SIZE numbers each.

    Those that are not named rest at their last pose.

    Raises InvalidInputError for an unknown name or a wrong shape; values may be NaN.
    """
    moving = tuple(avoidance.moving) if avoidance is not None else ()
    if not isinstance(obstacles, Mapping):
        raise InvalidInputError("obstacles", obstacles, "a mapping of names to pairs of a pose (4, 4) and a velocity (6,)")
    numbers.reshape(-1, OBSTACLE_SIZE)[:, 12:] = 0.0
    for name, given in obstacles.items():
        at = OBSTACLE_SIZE * moving.index(one_of("obstacles", name, moving))
        try:
            pose, velocity = given
            matrix = array_of_shape(name, getattr(pose, "homogeneous", pose), (4, 4))
            speed = array_of_shape(name, velocity, (6,))
        except (TypeError, ValueError) as error:
            raise InvalidInputError(f"obstacles[{name}]", given, "a pose (4, 4) and a velocity (6,)") from error
        numbers[at : at + OBSTACLE_SIZE] = np.concatenate([matrix[:3, :3].ravel(order="F"), matrix[:3, 3], speed])


def _row(
    avoidance: Avoidance, near: NearestPoints, rate: ca.SX, approach: ca.SX, limits: JointLimits | None
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """(A.1) with n from the obstacle to the robot: nᵀ (J q̇ - v) >= - ξ (d - d_s) / (d_i - d_s) where d <= d_i.

    With `limits` the robot also moves toward a body no faster than √(2 a (d - d_s)) and, beyond d_i, √(ξ² + 2 a (d - d_i)):
    from there the joints can brake in time, with a = BRAKING Σ_i |nᵀ J_i| A_i of their acceleration limits A_i.
    """
    room, beyond = near.distance - avoidance.security, near.distance - avoidance.influence
    damper = approach - avoidance.damping * room / (avoidance.influence - avoidance.security)
    bound = ca.if_else(beyond <= 0, damper, -ca.inf)
    if limits is not None and np.isfinite(limits.acceleration).all():
        braking = 2 * BRAKING * ca.fabs(rate) @ ca.DM(limits.acceleration)
        square = ca.if_else(beyond <= 0, braking * room, ca.fmin(braking * room, avoidance.damping**2 + braking * beyond))
        bound = ca.fmax(bound, -ca.sqrt(ca.fmax(square, 0)))
    return rate, bound, near.distance


def _lines(chain: SymbolicChain) -> ca.SX:
    """Velocity fields of the N joints, (6, N): that of joint i at a point p is lines[:3, i] + lines[3:, i] x p."""
    columns = []
    for i, joint in enumerate(chain.joints[1:]):
        axis = joint.rotation @ ca.sparsify(ca.DM(chain.tree.axes[i]))
        if chain.tree.slides[i]:
            columns.append(ca.vertcat(axis, ca.SX(3, 1)))
        else:
            columns.append(ca.vertcat(ca.cross(joint.origin, axis), axis))
    return ca.horzcat(*columns)


def _rate(chain: SymbolicChain, lines: ca.SX, joint: int, point: ca.SX, normal: ca.SX) -> ca.SX:
    """nᵀ J(q, p) of a point on the body that `joint` carries, (1, n): nᵀ (a x p) = aᵀ (p x n)."""
    tree = chain.tree
    wrench = ca.vertcat(normal, ca.cross(point, normal)).T
    rates = [ca.SX(1, 1)] * chain.q.shape[0]
    for i in np.flatnonzero(tree.carries[joint, 1:]):
        rates[tree.leader[i]] += float(tree.ratio[i]) * (wrench @ lines[:, i])
    return ca.horzcat(*rates)


def _capsule(chain: SymbolicChain, body: CapsuleBody) -> SymbolicCapsule:
    frame = chain.joints[body.joint]
    ends = [frame.origin + frame.rotation @ ca.SX(ca.DM(point)) for point in (body.start, body.end)]
    return SymbolicCapsule(start=ends[0], end=None if np.array_equal(body.start, body.end) else ends[1], radius=body.radius)


def _shape(obstacle: Obstacle, placement: Placement) -> SymbolicCapsule | SymbolicBox | SymbolicPlane:
    if isinstance(obstacle, shapes.Box):
        half = tuple((np.asarray(obstacle.size) / 2).tolist())
        return SymbolicBox(rotation=placement.rotation, centre=placement.origin, half=half)
    if isinstance(obstacle, shapes.Plane):
        normal = placement.rotation[:, 2]
        return SymbolicPlane(normal=normal, offset=ca.dot(normal, placement.origin))
    if isinstance(obstacle, shapes.Sphere):
        return SymbolicCapsule(start=placement.origin, end=None, radius=obstacle.radius)
    if isinstance(obstacle, shapes.Capsule | shapes.Cylinder):
        along = placement.rotation[:, 2] * (obstacle.length / 2)
        return SymbolicCapsule(start=placement.origin - along, end=placement.origin + along, radius=obstacle.radius)
    raise InvalidInputError(
        "scene", obstacle, "spheres, capsules, boxes, cylinders or planes, whose distances have closed forms"
    )


def _constant(obstacle: Obstacle) -> Placement:
    return Placement(rotation=ca.SX(ca.DM(obstacle.pose.rotation)), origin=ca.SX(ca.DM(obstacle.pose.translation)))


def _motion(symbols: ca.SX, k: int) -> tuple[Placement, ca.SX, ca.SX]:
    """Placement, linear and angular velocity of the k-th moving obstacle."""
    own = symbols[OBSTACLE_SIZE * k : OBSTACLE_SIZE * (k + 1)]
    rotation, _ = nearest_rotation(ca.reshape(own[:9], 3, 3))
    return Placement(rotation=rotation, origin=own[9:12]), own[12:15], own[15:18]


def _velocity_at(motion: tuple[Placement, ca.SX, ca.SX], point: ca.SX) -> ca.SX:
    placement, linear, angular = motion
    return linear + ca.cross(angular, point - placement.origin)


def _find_guarded(robot: Robot, bodies: CapsuleBodies, avoidance: Avoidance) -> list[CapsuleBody]:
    moving = [body for body in bodies.items if body.joint > 0]
    if not moving:
        raise InvalidInputError("avoidance", robot.name, "a robot whose description has collision geometry")
    if avoidance.links is None:
        return moving
    known = {body.link for body in moving}
    for link in avoidance.links:
        one_of("links", link, known)
    return [body for body in moving if body.link in avoidance.links]
