"""CollisionModel: a robot as convex primitives among the obstacles of a scene, and the pairs that are checked."""

from collections.abc import Iterable, Mapping

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike

from manipplan.collision.contact import Contact, Witness
from manipplan.collision.primitives import core_of
from manipplan.paths.joint import JointPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError

#: Accuracy of coal's distances between curved bodies [m]; at coal's default, 1e-6, gradients are off by 5 %.
GJK_TOLERANCE = 1e-10


class CollisionModel:
    """Collision checks and distances of one robot with itself and with a scene, by Pinocchio and coal.

    Not safe to share between threads: it holds Pinocchio's working data.

    Attributes:
        geometry: the primitives of the robot and the obstacles, with the pairs that are checked.
        pair_names: (first, second) of every pair; the first belongs to the robot.
        dropped: pairs of the robot's bodies that are not checked, with the reason.
        primitives: number of primitives of the robot, which are the first objects of `geometry`.
    """

    def __init__(
        self, robot: Robot, geometry: pin.GeometryModel, dropped: Mapping[tuple[str, str], str], primitives: int = 0
    ) -> None:
        self.robot = robot
        self.primitives = primitives
        self.geometry = geometry
        self.dropped = dropped
        objects = geometry.geometryObjects
        self.pair_names = tuple((objects[p.first].name, objects[p.second].name) for p in geometry.collisionPairs)
        self._data = robot.model.createData()
        self._geometry_data = pin.GeometryData(geometry)
        for request in self._geometry_data.distanceRequests:
            request.gjk_tolerance = GJK_TOLERANCE
        self._results = [self._geometry_data.distanceResults[k] for k in range(len(self.pair_names))]
        self._margin = 0.0
        self._cores: dict[int, tuple[Array, float]] = {}

    def in_collision(self, q: Array, *, clearance: float = 0.0) -> bool:
        """Whether any pair is nearer than `clearance` [m] at q (n,); 0: whether any pair touches."""
        self._set_margin(clearance)
        return bool(pin.computeCollisions(self.robot.model, self._data, self.geometry, self._geometry_data, q, True))

    def touches(self, q: Array, pairs: Iterable[int], *, clearance: float = 0.0) -> bool:
        """Whether any of the pairs with these indices is nearer than `clearance` [m] at q (n,)."""
        self._set_margin(clearance)
        pin.updateGeometryPlacements(self.robot.model, self._data, self.geometry, self._geometry_data, q)
        return any(pin.computeCollision(self.geometry, self._geometry_data, int(pair)) for pair in pairs)

    def copy(self) -> "CollisionModel":
        """A copy with its own working data, for another thread."""
        return CollisionModel(self.robot, self.geometry.copy(), self.dropped, self.primitives)

    def with_pairs(self, pairs: Iterable[int]) -> "CollisionModel":
        """The same bodies with only the pairs of these indices, in this order."""
        geometry = self.geometry.copy()
        geometry.removeAllCollisionPairs()
        for pair in pairs:
            geometry.addCollisionPair(self.geometry.collisionPairs[int(pair)])
        return CollisionModel(self.robot, geometry, self.dropped, self.primitives)

    def touching_pairs(self, q: Array) -> list[int]:
        """Indices of the pairs that touch at q (n,)."""
        self._set_margin(0.0)
        pin.computeCollisions(self.robot.model, self._data, self.geometry, self._geometry_data, q, False)
        return [k for k, result in enumerate(self._geometry_data.collisionResults) if result.isCollision()]

    def distances(self, q: Array) -> Array:
        """Signed distances (k,) of all pairs at q (n,) [m]."""
        pin.computeDistances(self.robot.model, self._data, self.geometry, self._geometry_data, q)
        return np.array([result.min_distance for result in self._results])

    def pair_distances(self, q: Array, pairs: Iterable[int]) -> list[float]:
        """Signed distance [m] of the pairs with these indices at q (n,)."""
        pin.updateGeometryPlacements(self.robot.model, self._data, self.geometry, self._geometry_data, q)
        return [pin.computeDistance(self.geometry, self._geometry_data, pair).min_distance for pair in pairs]

    def distance_gradient(self, q: Array, pair: int) -> Array:
        """Gradient (n,) of the distance of a pair at q (n,) [m per rad or m]."""
        model, data = self.robot.model, self._data
        pin.computeJointJacobians(model, data, q)
        pin.updateGeometryPlacements(model, data, self.geometry, self._geometry_data)
        result = pin.computeDistance(self.geometry, self._geometry_data, pair)
        bodies = self.geometry.collisionPairs[pair]
        gradient = np.zeros(self.robot.n)
        for body, point, side in (
            (bodies.first, result.getNearestPoint1(), -1.0),
            (bodies.second, result.getNearestPoint2(), 1.0),
        ):
            joint = self.geometry.geometryObjects[body].parentJoint
            if joint > 0:
                jacobian = pin.getJointJacobian(model, data, joint, pin.LOCAL_WORLD_ALIGNED)
                lever = np.asarray(point) - data.oMi[joint].translation
                motion = jacobian[:3] - pin.skew(lever) @ jacobian[3:]
                gradient += side * (np.asarray(result.normal) @ motion)  # coal's normal points from the first to the second
        return gradient

    def contact(self, q: Array, pair: int) -> Contact:
        """Nearest points and separating plane of the pair with the given index at q (n,)."""
        pin.updateGeometryPlacements(self.robot.model, self._data, self.geometry, self._geometry_data, q)
        result = pin.computeDistance(self.geometry, self._geometry_data, pair)
        bodies = self.geometry.collisionPairs[pair]
        first, second = (self.geometry.geometryObjects[i].parentJoint for i in (bodies.first, bodies.second))
        normal = -np.array(result.normal)  # coal's points from the first to the second
        place = self._data.oMi[second]
        points, radius = self._core(bodies.first)
        return Contact(
            distance=float(result.min_distance),
            first=first,
            second=second,
            normal=place.rotation.T @ normal,
            offset=float(normal @ (result.getNearestPoint2() - place.translation)),
            points=points,
            radius=radius,
        )

    def witness(self, q: Array, pair: int) -> tuple[Witness, Array]:
        """The nearest points of the pair with the given index at q (n,), and the unit vector from the second to the first.

        The vector (3,) is in the frame of the joint that carries the second body.
        """
        pin.updateGeometryPlacements(self.robot.model, self._data, self.geometry, self._geometry_data, q)
        result = pin.computeDistance(self.geometry, self._geometry_data, pair)
        bodies = self.geometry.collisionPairs[pair]
        normal = np.array(result.normal)  # coal's points from the first body to the second
        carriers, points, radii = [], [], []
        for body, nearest, outwards in (
            (bodies.first, result.getNearestPoint1(), normal),
            (bodies.second, result.getNearestPoint2(), -normal),
        ):
            item = self.geometry.geometryObjects[body]
            radius = float(item.geometry.radius) if isinstance(item.geometry, coal.Sphere | coal.Capsule) else 0.0
            carriers.append(int(item.parentJoint))
            points.append(self._data.oMi[item.parentJoint].actInv(np.array(nearest) - radius * outwards))
            radii.append(radius)
        witness = Witness(first=carriers[0], second=carriers[1], point=points[0], other=points[1], radius=sum(radii))
        return witness, -self._data.oMi[carriers[1]].rotation.T @ normal

    def turned(self, q: Array, vector: Array, joint: int, into: int) -> Array:
        """A vector given in the frame of joint `joint`, expressed in that of joint `into` (0: the world), at q (n,); (3,)."""
        pin.forwardKinematics(self.robot.model, self._data, q)
        return np.asarray(self._data.oMi[into].rotation.T @ (self._data.oMi[joint].rotation @ vector))

    def nearest_points(self, q: Array, contact: Contact, count: int) -> Array:
        """The `count` core points of the contact's first body that are nearest to its plane at q (n,)."""
        pin.forwardKinematics(self.robot.model, self._data, q)
        normal = self._data.oMi[contact.second].rotation @ contact.normal
        height = contact.points @ (self._data.oMi[contact.first].rotation.T @ normal)
        return contact.points[np.argsort(np.round(height, 9), kind="stable")[:count]]  # rounding errors do not change the order

    def free_configuration(self, argument: str, q: ArrayLike, clearance: float = 0.0) -> Array:
        """Check that q (n,) is inside the limits and collision-free.

        Raises InvalidInputError that names the limit or the pair.
        """
        q = self.robot.configuration(argument, q)
        distances = self.distances(q)
        nearest = int(distances.argmin()) if len(distances) else -1
        if nearest >= 0 and (distances[nearest] <= 0 or distances[nearest] < clearance):
            first, second = self.pair_names[nearest]
            apart = (
                f"are {distances[nearest]:.4g} m apart" if distances[nearest] > 0 else f"overlap by {-distances[nearest]:.4g} m"
            )
            demanded = f", but the required clearance is {clearance:g} m" if clearance else ""
            raise InvalidInputError(
                argument, q.tolist(), f"a collision-free configuration; {first} and {second} {apart}{demanded}"
            )
        return q

    def path_is_free(self, path: JointPath, step: float, clearance: float = 0.0) -> bool:
        """Whether the path keeps the clearance [m] at samples between which no joint moves more than `step` [rad or m].

        Samples that are far apart come first, so that a collision is found early.
        """
        s = path.fine_samples(step)
        q = path(s)
        return not any(self.in_collision(q[k], clearance=clearance) for k in _coarse_to_fine(len(s)))

    def _core(self, body: int) -> tuple[Array, float]:
        """Core points (k, 3) of a geometry object in its joint's frame, and the radius around them [m]."""
        if body not in self._cores:
            item = self.geometry.geometryObjects[body]
            points, radius = core_of(item.geometry)
            self._cores[body] = points @ item.placement.rotation.T + item.placement.translation, radius
        return self._cores[body]

    def _set_margin(self, clearance: float) -> None:
        if clearance != self._margin:
            for request in self._geometry_data.collisionRequests:
                request.security_margin = clearance
            self._margin = clearance


def _coarse_to_fine(count: int) -> list[int]:
    """The numbers 0 to count - 1, by the largest power of two that divides them, largest first."""
    return sorted(range(count), key=lambda k: k & -k if k else count, reverse=True)
