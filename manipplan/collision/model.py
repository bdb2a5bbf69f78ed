"""CollisionModel: a robot as convex bodies among the obstacles of a scene, and the pairs that are checked.

Distances of only those pairs that are near: among a thousand obstacles these are few.

The nearest points of pairs of bodies, the direction between them, and the gradients of their distances.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.kernel import TOUCHING, UNDECIDED, DistanceKernel, kernel_of
from manipplan.collision.surfaces import find_components, winding_number
from manipplan.collision.world import core_of, placed_triangles
from manipplan.paths.joint import JointPath
from manipplan.robots.mesh_files import triangle_tree
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import state_without_memo

#: Distance below which two bodies touch, for messages [m].
CONTACT = 1e-6


@dataclass(frozen=True, kw_only=True, eq=False)
class NearPairs:
    """Distances below a limit at m configurations, ordered by row, then pair; (e,) each.

    Attributes:
        shape: number of configurations and of all pairs.
        rows: indices of the configurations.
        pairs: indices of the pairs.
        distances: signed distances [m].
    """

    shape: tuple[int, int]
    rows: NDArray[np.intp]
    pairs: NDArray[np.intp]
    distances: Array

    @classmethod
    def of(cls, shape: tuple[int, int], where: NDArray[np.intp], distances: Array) -> "NearPairs":
        """From row * number of pairs + pair (e,), sorted, and distances (e,) [m]."""
        rows, pairs = np.divmod(where, max(shape[1], 1))
        return cls(shape=shape, rows=rows, pairs=pairs, distances=distances)

    def at(self, rows: NDArray[np.intp], pairs: NDArray[np.intp], default: float | Array) -> Array:
        """Distances (k,) of pairs (k,) at rows (k,) [m]; `default` for those that are not near."""
        where, wanted = self.rows * self.shape[1] + self.pairs, rows * self.shape[1] + pairs
        entry = np.minimum(np.searchsorted(where, wanted), max(len(where) - 1, 0))
        known = where[entry] == wanted if len(where) else np.zeros(len(wanted), dtype=bool)
        found = np.array(np.broadcast_to(default, wanted.shape), dtype=float)
        found[known] = self.distances[entry[known]]
        return found

    def beside(self, default: float) -> tuple[Array, Array]:
        """Distances (e,) of the same pairs at the configurations before and after [m]; inf where there is none."""
        before, after = (self.at(self.rows + step, self.pairs, default) for step in (-1, 1))
        before[self.rows == 0] = after[self.rows == self.shape[0] - 1] = np.inf
        return before, after


def apart_text(distance: float) -> str:
    """What messages say of the distance of two bodies [m], such as "are 3.2 mm apart"."""
    if abs(distance) < CONTACT:
        return "touch"
    return f"are {1e3 * distance:.3g} mm apart" if distance > 0 else f"overlap by {-1e3 * distance:.3g} mm"


@dataclass(frozen=True, kw_only=True, eq=False)
class Witnesses:
    """Two points fixed to the bodies of each of m pairs: the pair's distance is at most that of the points minus both `radii`.

    The point of a sphere or capsule lies on its centre or axis, that of any other body on its surface.

    Attributes:
        distances: (m,) signed distances [m].
        joints: (m, 2) indices of the joints that carry the two bodies (0: the world).
        normals: (m, 3) unit vectors from the second body to the first, in the frame of the second's joint. They lead out of a
            solid that the first body is in.
        opposites: (m, 3) the opposite vectors, in the frame of the first's joint.
        points, others: (m, 3) the points of the first and the second bodies, in the frames of their joints [m].
        radii: (m, 2) of the two bodies around their points [m]; 0 for points on the surface.
        gradients: (m, n) of the distances [m per rad or m].
    """

    distances: Array
    joints: NDArray[np.int64]
    normals: Array
    opposites: Array
    points: Array
    others: Array
    radii: Array
    gradients: Array

    @property
    def offsets(self) -> Array:
        """(m,) normals · p [m], with p the points of the second bodies' surfaces: these bodies lie below."""
        return np.asarray((self.normals * self.others).sum(axis=1) + self.radii[:, 1])


#: Accuracy of coal's distances between curved bodies [m]; at coal's default, 1e-6, gradients are off by 5 %.
GJK_TOLERANCE = 1e-10
#: Number of configurations of a path that are checked at a time.
BLOCK = 256
#: Number of configurations from one to the next whose distances are all measured first; these bound the smallest.
COARSE_STEP = 16
#: Two links that touch at more than this share of random configurations may touch by their shape.
OFTEN = 0.3
#: Number of random configurations that tell how often two links are nearer than a clearance.
NEARNESS_SAMPLES = 200
#: Distances up to which the nearest pair is searched, in turn [m]: where something is near, the others are not measured.
REACHES = (0.05, 0.2, 0.8, np.inf)


class CollisionModel:
    """Collision checks and distances of one robot with itself and with a scene: by a kernel, and by coal what it cannot decide.

    Not safe to share between threads: it holds working data.

    Attributes:
        objects: the convex bodies of the robot and the obstacles.
        pairs: (k, 2) indices of the objects that are checked for contact.
        dropped: pairs of links, or of single bodies where others of the same links are checked, that are left out, with the
            reason.
        bodies: number of convex bodies of the robot, which are the first objects.
        excess: by how much bodies that are pieces of a mesh are known to stick out of it [m], by name.
        radii: distances around objects of `geometry` that belong to them as well [m], by index; 0 for the others.
        solids: indices of the surfaces that are solid inside.
        links: the link, carried part or obstacle of each object.
        contacts: share of random configurations at which two links touch that are checked, by their names.
    """

    def __init__(
        self,
        robot: Robot,
        geometry: pin.GeometryModel,
        pairs: NDArray[np.int64],
        dropped: Mapping[tuple[str, str], str],
        *,
        bodies: int = 0,
        excess: Mapping[str, float] = MappingProxyType({}),
        radii: Mapping[int, float] = MappingProxyType({}),
        solids: Collection[int] = (),
        links: Sequence[str] = (),
        contacts: Mapping[frozenset[str], float] = MappingProxyType({}),
    ) -> None:
        self.robot = robot
        self.bodies = bodies
        self.objects = tuple(geometry.geometryObjects)
        self.pairs = pairs
        self.dropped = dropped
        self.excess = excess
        self.radii = radii
        self.solids = solids
        self.links = links
        self.contacts = contacts
        self._geometry = geometry  # its own pairs do not count
        self._data = robot.model.createData()
        around = np.array([radii.get(k, 0.0) for k in range(len(self.objects))])
        self._radii = around[pairs].sum(axis=1)
        carriers = np.array([item.parentJoint for item in self.objects], dtype=np.int64)
        self._bodies = np.where((carriers[pairs[:, 0]] == 0)[:, None], pairs[:, ::-1], pairs)
        self._carriers = carriers[self._bodies]
        self._around = (around + [_radius(item.geometry) for item in self.objects])[self._bodies]
        is_solid = np.zeros(len(self.objects), dtype=bool)
        is_solid[list(solids)] = True
        solid = is_solid[pairs]
        self._solid_pairs = {
            k: [(pairs[k, 1 - side].item(), pairs[k, side].item()) for side in (1, 0) if solid[k, side]]
            for k in np.flatnonzero(solid.any(axis=1)).tolist()
        }
        self._margin = np.nan  # coal's, set when it is first asked
        self._cores: dict[int, tuple[Array, float]] = {}
        self._surfaces: dict[int, tuple[Array, Array, Array]] = {}  # triangles of solids, and a box around them
        self._probes: dict[int, Array] = {}

    def __repr__(self) -> str:
        later = [item.name for item in self.objects[self.bodies :]]
        others = sum(name not in self.excess for name in later)  # the robot's finer bodies come after its bodies, too
        most = 1e3 * max(self.excess.values(), default=0.0)
        counts = f"{self.bodies} bodies, {others} part{'s' * (others != 1)} of obstacles, {len(self.pairs)} pairs"
        return f"CollisionModel({self.robot.name!r}, {counts}, excess up to {most:.1f} mm)"

    @cached_property
    def pair_names(self) -> tuple[tuple[str, str], ...]:
        """(first, second) of every pair; the first belongs to the robot."""
        names = [item.name for item in self.objects]
        return tuple((names[i], names[j]) for i, j in self.pairs.tolist())

    @cached_property
    def geometry(self) -> pin.GeometryModel:
        """The objects and pairs as Pinocchio takes them, made where it is first asked."""
        geometry = self._geometry.copy()
        geometry.removeAllCollisionPairs()
        for i, j in self.pairs.tolist():
            geometry.addCollisionPair(pin.CollisionPair(i, j))
        return geometry

    @cached_property
    def _geometry_data(self) -> pin.GeometryData:
        """Coal's working data, made where it is first asked."""
        data = pin.GeometryData(self.geometry)
        for k in range(len(self.pairs)):  # Pinocchio's requests start at the last answer, which changes the next
            data.distanceRequests[k] = coal.DistanceRequest(True)
            data.distanceRequests[k].gjk_tolerance = GJK_TOLERANCE
            data.collisionRequests[k] = coal.CollisionRequest()
        return data

    @cached_property
    def _kernel(self) -> DistanceKernel:
        radii = np.array([self.radii.get(k, 0.0) for k in range(len(self.objects))])
        return kernel_of(self.robot, self.objects, self.pairs, radii, self.solids)

    def copy_of_bodies(self) -> pin.GeometryModel:
        """The objects without pairs, to which others can be added."""
        return self._geometry.copy()

    def copy(self) -> "CollisionModel":
        """A copy with its own working data, for another thread."""
        copied = object.__new__(CollisionModel)
        vars(copied).update(state_without_memo(self))
        for name in ("geometry", "_geometry_data"):  # made anew
            vars(copied).pop(name, None)
        vars(copied).update(_data=self.robot.model.createData(), _margin=np.nan, _kernel=self.kernel_copy())
        return copied

    def kernel_copy(self) -> DistanceKernel:
        """A kernel for compiled code, with its own working memory."""
        return self._kernel.copy()

    def in_collision(self, q: Array, *, clearance: float = 0.0) -> bool:
        """Whether any pair is nearer than `clearance` [m] at q (n,); 0: whether any pair touches."""
        verdict = self._kernel.check(q, clearance)
        return verdict == TOUCHING if verdict != UNDECIDED else self._touches(q, clearance)

    def in_collision_rows(self, q: Array, *, clearance: float = 0.0) -> NDArray[np.bool_]:
        """The same for every row of q (m, n); (m,)."""
        verdicts = self._kernel.check_rows(q, clearance)
        found: NDArray[np.bool_] = verdicts == TOUCHING
        for k in np.flatnonzero(verdicts == UNDECIDED):
            found[k] = self._touches(q[k], clearance)
        return found

    def distances(self, q: Array, *, beyond: float = np.inf) -> Array:
        """Signed distances (k,) of all pairs at q (n,) [m], those above `beyond` cut off there."""
        found: Array = self.distance_rows(np.asarray(q)[None], beyond=beyond)[0]
        return found

    def distance_rows(self, q: Array, *, beyond: float | Array = np.inf) -> Array:
        """Signed distances (m, k) of all pairs at q (m, n) [m], those above `beyond`, a number or (m,), cut off there."""
        reach = np.broadcast_to(np.asarray(beyond, dtype=float), (len(q),))
        found: Array = self._kernel.distances(q, np.maximum(reach, 0.0))
        if found.size and np.isnan(found.min()):
            for k, pair in zip(*np.nonzero(np.isnan(found)), strict=True):
                found[k, pair] = min(self._distance(q[k], int(pair)), reach[k])
        return np.asarray(np.minimum(found, reach[:, None])) if (reach < 0).any() else found

    def near_pairs(self, q: Array, beyond: float | Array) -> NearPairs:
        """The pairs nearer than `beyond`, a number or (m,), at q (m, n), with their signed distances [m]."""
        reach = np.array(np.broadcast_to(np.asarray(beyond, dtype=float), (len(q),)))
        shape = (len(q), len(self.pairs))
        where, found = self._kernel.near(q, np.maximum(reach, 0.0))
        for k in np.flatnonzero(np.isnan(found)):
            row, pair = divmod(int(where[k]), shape[1])
            found[k] = self._distance(q[row], pair)
        is_near = ~(found >= reach[where // max(shape[1], 1)])  # nan is not far
        return NearPairs.of(shape, where[is_near], found[is_near])

    def pair_distances(self, q: Array, pairs: ArrayLike, *, beyond: float | Array = np.inf) -> Array:
        """Signed distance [m] of one pair at each configuration: of pairs (m,) at q (m, n), cut off at `beyond`; (m,)."""
        chosen, reach = np.asarray(pairs, dtype=np.int64), np.broadcast_to(np.asarray(beyond, dtype=float), (len(q),))
        found = self._kernel.pair_distances(q, chosen, np.maximum(reach, 0.0))
        for k in np.flatnonzero(np.isnan(found)):
            found[k] = self._distance(q[k], int(chosen[k]))
        return np.asarray(np.minimum(found, reach))

    def interval_bounds(
        self, q: Array, slopes: Array, pairs: ArrayLike, *, beyond: Array, bends: Array, motions: Array
    ) -> tuple[Array, Array]:
        """Distances of one pair at each configuration, as `pair_distances`, and lower bounds while the joints move, (m,) each.

        Args:
            q: (m, n).
            slopes: (m, n); the joints move by t slopes with |t| <= 1, and further as `bends` says [rad or m].
            pairs: (m,).
            beyond: (m,) distances above it are cut off there [m].
            bends: (m,) largest motion of a point of one of the bodies relative to the other beyond that by the slopes [m].
            motions: (m,) largest motion of the bodies towards each other altogether [m].

        Returns:
            The distances, and the bounds [m]; -inf where none is known.
        """
        chosen = np.asarray(pairs, dtype=np.int64)
        if (beyond < 0).any():
            return self.pair_distances(q, chosen, beyond=beyond), np.full(len(q), -np.inf)
        found, bounds = self._kernel.interval_bounds(q, slopes, chosen, beyond, bends, motions)
        for k in np.flatnonzero(np.isnan(found)):
            found[k] = min(self._distance(q[k], int(chosen[k])), beyond[k])
        return found, bounds

    def least_distance(self, q: Array) -> tuple[float, int, int]:
        """The smallest distance at all q (m, n) [m], its row, and the index of its pair; inf, 0, -1 if nothing is checked."""
        if not len(self.pairs):
            return np.inf, 0, -1
        for reach in REACHES:
            found = self._kernel.least(q, reach, COARSE_STEP)
            if found is None:
                break
            if found[2] >= 0:
                return found
        bound = np.inf
        for reach in REACHES:
            bound = float(self.distance_rows(q[:1], beyond=reach).min())
            if bound < reach:
                break
        bound = float(self.distance_rows(q[::COARSE_STEP], beyond=max(bound, 0.0)).min())
        rows = self.distance_rows(q, beyond=max(bound, 0.0) + 1e-9)  # so that the smallest itself is not cut off
        row, pair = divmod(int(rows.argmin()), rows.shape[1])
        return float(rows[row, pair]), row, pair

    def witnesses(self, q: Array, pairs: ArrayLike, leaves: ArrayLike = -1) -> Witnesses:
        """The nearest points of one pair at each configuration: of pairs (m,) at q (m, n).

        `leaves` (m,): the triangle or point of the second body, a surface, that counts alone, as in ProximitySamples; -1: all.
        """
        chosen = np.asarray(pairs, dtype=np.int64)
        found = self._kernel.witnesses(q, chosen, np.broadcast_to(np.asarray(leaves, dtype=np.int64), chosen.shape))
        for k in np.flatnonzero(np.isnan(found[:, 0])):
            found[k] = self._witness(q[k], int(chosen[k]))
        distances, normals, opposites, points, others, gradients = np.split(found, (1, 4, 7, 10, 13), axis=1)
        return Witnesses(
            distances=distances[:, 0],
            joints=self._carriers[chosen],
            normals=normals,
            opposites=opposites,
            points=points,
            others=others,
            radii=self._around[chosen],
            gradients=gradients,
        )

    def _witness(self, q: Array, pair: int) -> Array:
        """The same numbers as those of `DistanceKernel.witnesses` (13 + n,) by coal."""
        model, data = self.robot.model, self._data
        pin.computeJointJacobians(model, data, q)
        pin.updateGeometryPlacements(model, data, self.geometry, self._geometry_data)
        result = self._nearest(q, pair)
        sign, straight = self._sign(pair, result), self.pairs[pair, 0] == self._bodies[pair, 0]
        between = np.array(result.normal) * (1 if straight else -1)  # from the first body to the second
        ends = [np.array(result.getNearestPoint1()), np.array(result.getNearestPoint2())]
        points, turns, gradient = [], [], np.zeros(self.robot.n)
        for body, joint, end, outwards in zip(
            self._bodies[pair].tolist(),
            self._carriers[pair].tolist(),
            ends if straight else ends[::-1],
            (between, -between),
            strict=True,
        ):
            frame = data.oMi[joint]
            points.append(frame.actInv(end - _radius(self.objects[body].geometry) * outwards))
            turns.append(frame.rotation.T @ (sign * outwards))
            if joint > 0:
                jacobian = pin.getJointJacobian(model, data, joint, pin.LOCAL_WORLD_ALIGNED)
                gradient -= sign * (outwards @ (jacobian[:3] - pin.skew(end - frame.translation) @ jacobian[3:]))
        distance = sign * result.min_distance - self._radii[pair]
        return np.concatenate([[distance], turns[1], turns[0], *points, gradient])

    def turned(self, q: Array, vector: Array, joint: int, into: int) -> Array:
        """A vector given in the frame of joint `joint`, expressed in that of joint `into` (0: the world), at q (n,); (3,)."""
        pin.forwardKinematics(self.robot.model, self._data, q)
        return np.asarray(self._data.oMi[into].rotation.T @ (self._data.oMi[joint].rotation @ vector))

    def nearest_bodies(self, q: Array) -> tuple[str, int]:
        """The nearest two bodies at configurations (k, n), with their distance or overlap, and the row where they are."""
        apart, row, pair = self.least_distance(q)
        if pair < 0:
            return "no two bodies that are checked", 0
        return f"{' and '.join(self.pair_names[pair])} {apart_text(apart)}{self.contact_hint(pair)}", row

    def contact_hint(self, pair: int) -> str:
        """What to do about a pair whose links touch at more than OFTEN of random configurations; "" for any other."""
        first, second = (self.links[k] if self.links else "" for k in self.pairs[pair, ::-1])
        share = self.contacts.get(frozenset((first, second)), 0.0)
        if share <= OFTEN:
            return ""
        remedy = f"scene.allow({first!r}, {second!r}) leaves them out, robot.self_collisions.to_srdf(file, touching={OFTEN})"
        return f"; they touch at {share:.0%} of random configurations. If that is their shape, {remedy} all such links"

    def _nearness_hint(self, pair: int, clearance: float) -> str:
        """What to do about a pair of own links nearer than a clearance at more than OFTEN of random configurations; "" else."""
        bodies = self.pairs[pair, ::-1].tolist()
        if not self.links or any(k in self.radii for k in bodies):  # one is an obstacle
            return ""
        names = [self.links[k] for k in bodies]
        of_links = [k for k, each in enumerate(self.pairs) if {self.links[i] for i in each} == set(names)]
        samples = self.robot.random_configuration(np.random.default_rng(0), size=NEARNESS_SAMPLES)
        share = float((self.distance_rows(samples, beyond=clearance)[:, of_links].min(axis=1) < clearance).mean())
        if share <= OFTEN:
            return ""
        remedy = f"ask for less, or leave them out by scene.allow({names[0]!r}, {names[1]!r})"
        return f"; these links of the arm are nearer than that at {share:.0%} of random configurations: {remedy}"

    def free_configuration(self, argument: str, q: ArrayLike, clearance: float = 0.0) -> Array:
        """Check that q (n,) is inside the limits and collision-free.

        Raises InvalidInputError that names the limit or the pair.
        """
        q = self.robot.configuration(argument, q)
        least, _, nearest = self.least_distance(q[None])
        if least <= 0 or least < clearance:
            first, second = self.pair_names[nearest]
            apart = f"are {least:.4g} m apart" if least > 0 else f"overlap by {-least:.4g} m"
            demanded = f", but the required clearance is {clearance:g} m" if clearance else ""
            hint = self.contact_hint(nearest) if least <= 0 else self._nearness_hint(nearest, clearance)
            raise InvalidInputError(
                argument, q.tolist(), f"a collision-free configuration; {first} and {second} {apart}{demanded}{hint}"
            )
        return q

    def path_is_free(self, path: JointPath, step: float, clearance: float = 0.0) -> bool:
        """Whether the path keeps the clearance [m] at samples between which no joint moves more than `step` [rad or m].

        Samples that are far apart come first, so that a collision is found early.
        """
        s = path.fine_samples(step)
        q = path(s)[_coarse_to_fine(len(s))]
        return not any(self.in_collision_rows(q[k : k + BLOCK], clearance=clearance).any() for k in range(0, len(q), BLOCK))

    def core(self, pair: int) -> tuple[Array, float]:
        """Points (k, 3) of the first body of a pair in its joint's frame, and a radius: it lies in balls about them [m]."""
        body = int(self._bodies[pair, 0])
        points, radius = self._core(body)
        return points, radius + self.radii.get(body, 0.0)

    def _core(self, body: int) -> tuple[Array, float]:
        """Core points (k, 3) of a geometry object in its joint's frame, and the radius around them [m]."""
        if body not in self._cores:
            item = self.objects[body]
            points, radius = core_of(item.geometry)
            self._cores[body] = points @ item.placement.rotation.T + item.placement.translation, radius
        return self._cores[body]

    def _touches(self, q: Array, clearance: float) -> bool:
        """`in_collision` by coal."""
        if clearance != self._margin:
            self._set_margin(clearance)
        if pin.computeCollisions(self.robot.model, self._data, self.geometry, self._geometry_data, q, True):
            return True
        return any(self._is_inside(pair) for pair in self._solid_pairs)

    def _distance(self, q: Array, pair: int) -> float:
        """Signed distance of one pair at q (n,) [m] by coal."""
        pin.updateGeometryPlacements(self.robot.model, self._data, self.geometry, self._geometry_data, q)
        distance = float(pin.computeDistance(self.geometry, self._geometry_data, pair).min_distance - self._radii[pair])
        return -distance if distance > 0 and pair in self._solid_pairs and self._is_inside(pair) else distance

    def _nearest(self, q: Array, pair: int) -> coal.DistanceResult:
        """Nearest points of a pair at q (n,), where the bodies are placed; a mesh is looked at only where it is nearest."""
        one, other = self.pairs[pair].tolist()
        first, second = self.objects[one], self.objects[other]
        if second.parentJoint > 0 or not isinstance(second.geometry, coal.BVHModelBase):
            return pin.computeDistance(self.geometry, self._geometry_data, pair)
        corners = self._kernel.nearest_triangle(q, pair)
        if corners is None:
            return pin.computeDistance(self.geometry, self._geometry_data, pair)
        pose, result, request = self._geometry_data.oMg[one], coal.DistanceResult(), self._geometry_data.distanceRequests[pair]
        here, there = coal.Transform3s(pose.rotation, pose.translation), coal.Transform3s()
        coal.distance(first.geometry, here, triangle_tree(corners, np.arange(3)[None]), there, request, result)
        return result

    def _sign(self, pair: int, result: coal.DistanceResult) -> float:
        """-1 where one body of a pair is wholly inside the other, which is a solid surface, otherwise 1."""
        return -1.0 if result.min_distance > 0 and pair in self._solid_pairs and self._is_inside(pair) else 1.0

    def _is_inside(self, pair: int) -> bool:
        """Whether a part of one body of a pair is inside the other, which is a solid surface, where the bodies are placed."""
        objects = self.objects
        for body, solid in self._solid_pairs[pair]:
            here, there = (self._data.oMi[objects[k].parentJoint] for k in (body, solid))
            if solid not in self._surfaces:
                triangles = placed_triangles(objects[solid])
                self._surfaces[solid] = triangles, triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
            triangles, low, high = self._surfaces[solid]
            points = self._inner_points(body) @ (there.rotation.T @ here.rotation).T + there.actInv(here.translation)
            points = points[((points >= low) & (points <= high)).all(axis=1)]
            if (np.abs(winding_number(triangles, points)) > 0.5).any():
                return True
        return False

    def _inner_points(self, body: int) -> Array:
        """A point (k, 3) of each connected part of a geometry object, in its joint's frame."""
        if body not in self._probes:
            item = self.objects[body]
            if isinstance(item.geometry, coal.BVHModelBase):
                parts = [placed_triangles(item)] if body in self.solids else find_components(placed_triangles(item))
                self._probes[body] = np.array([part[0, 0] for part in parts])
            elif isinstance(item.geometry, coal.Halfspace | coal.Plane):  # without bounds, it is inside nothing
                self._probes[body] = np.empty((0, 3))
            else:  # the middle of a convex core is inside the body, a corner of a box around it may not be
                self._probes[body] = self._core(body)[0].mean(axis=0)[None]
        return self._probes[body]

    def _set_margin(self, clearance: float) -> None:
        """Let coal count pairs nearer than `clearance` [m] as touching."""
        for request, radius in zip(self._geometry_data.collisionRequests, self._radii, strict=True):
            request.security_margin = clearance + radius
        self._margin = clearance


def _radius(shape: coal.CollisionGeometry) -> float:
    """Radius of a sphere or capsule [m]; 0 for other shapes."""
    return float(shape.radius) if isinstance(shape, coal.Sphere | coal.Capsule) else 0.0


def _coarse_to_fine(count: int) -> list[int]:
    """The numbers 0 to count - 1, by the largest power of two that divides them, largest first."""
    return sorted(range(count), key=lambda k: k & -k if k else count, reverse=True)
