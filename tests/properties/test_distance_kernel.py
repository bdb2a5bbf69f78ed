"""The compiled kernel against coal, for arms and scenes of every shape, and the gradient of distances."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin
import pytest
from coal_oracle import by_coal
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.collision.kernel import UNDECIDED, DistanceKernel
from manipplan.collision.shapes import Part
from manipplan.support.kernels import kernel_by_llvm

ARMS = ["panda", "ur5", "planar", "two", "eggs"]
MORE_ARMS = [
    "panda_collision",
    "ur3",
    "ur10",
    "xarm7",
    "kinova",
    "z1",
    "baxter_left",
    "talos_right_arm",
    "tiago",
    "icub",
    "so100",
]
SHAPES = ["box", "fat box", "sphere", "capsule", "cylinder", "plane", "mesh", "ring", "cup", "cloud"]


@pytest.fixture(scope="session")
def wedge(tmp_path_factory):
    """A mesh file of two separate parts: a tetrahedron and a slab."""
    file = tmp_path_factory.mktemp("mesh") / "wedge.obj"
    corners = [(0, 0, 0), (0.3, 0, 0), (0, 0.3, 0), (0.05, 0.05, 0.4), (0.5, 0, 0), (0.6, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.05)]
    sides = [(1, 3, 2), (1, 2, 4), (2, 3, 4), (1, 4, 3)]
    faces = sides + [tuple(k + 4 for k in side) for side in sides]
    lines = ["v " + " ".join(map(str, corner)) for corner in corners] + ["f " + " ".join(map(str, face)) for face in faces]
    file.write_text("\n".join(lines) + "\n")
    return str(file)


#: Two ellipsoids, which the kernel leaves to coal.
EGGS = """<mujoco><worldbody><body name="a" pos="0 0 0.3"><joint name="i" axis="0 0 1" range="-170 170"/>
  <geom type="ellipsoid" size="0.3 0.1 0.05" pos="0.3 0 0"/><body name="b" pos="0.7 0 0"><joint name="j" axis="0 1 0" range="-120 120"/>
  <geom type="ellipsoid" size="0.25 0.05 0.1" pos="0.3 0 0"/></body></body></worldbody></mujoco>"""


@dataclass(frozen=True, kw_only=True)
class FatBox(mp.Box):
    """A box with rounded edges: an obstacle of the user's own, whose part has a distance around it."""

    def parts(self):
        return (Part(shape=coal.Box(*self.size), radius=0.05),)


@pytest.fixture
def arm(request, panda, ur5, planar, two_link_urdf, tmp_path):
    known = {"panda": panda, "ur5": ur5, "planar": planar}
    name = request.param
    if name == "two":
        return mp.load_robot(two_link_urdf(), tool="tip")
    if name == "eggs":
        (tmp_path / "eggs.xml").write_text(EGGS)
        return mp.Robot.from_mjcf(tmp_path / "eggs.xml", tool="b", velocity=1.0)
    return known.get(name) or mp.load_robot(name)


def obstacle(shape, place, turn, size, wedge):
    options = {"position": place, "rotation": turn, "name": shape}
    return {
        "box": lambda: mp.Box(size=(size, 0.3 * size, 0.1 + size), **options),
        "fat box": lambda: FatBox(size=(size, 0.3 * size, 0.1 + size), **options),
        "sphere": lambda: mp.Sphere(radius=size / 2, **options),
        "capsule": lambda: mp.Capsule(radius=size / 4, length=size, **options),
        "cylinder": lambda: mp.Cylinder(radius=size / 3, length=0.2 * size, **options),
        "plane": lambda: mp.Plane(**options),
        "mesh": lambda: mp.Mesh(file=wedge, scale=2 * size, **options),
        "ring": lambda: mp.Mesh(triangles=size * ring(), **options),
        "cup": lambda: mp.Mesh(triangles=size * ring()[::2], **options),
        "cloud": lambda: mp.PointCloud(points=size * ring().reshape(-1, 3)[::3], radius=0.05 * size, **options),
    }[shape]()


def ring():
    """Triangles (t, 3, 3) of a closed torus with radii 1 and 0.4, seen from outside counterclockwise."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(0, 2 * np.pi, 13), indexing="ij")
    far = 1 + 0.4 * np.cos(v)
    corner = np.stack([far * np.cos(u), far * np.sin(u), 0.4 * np.sin(v)], axis=-1)
    corner[-1], corner[:, -1] = corner[0], corner[:, 0]
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    return np.concatenate([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)


def assert_alike(found, expected):
    """Distances to 3e-7 m, the size of a point of a cloud; of depths, which coal finds one way or another, only the sign."""
    np.testing.assert_allclose(found[expected > 0], expected[expected > 0], rtol=0, atol=3e-7)
    assert (found[expected <= 0] <= 0).all()


def assert_kernel_is_right(model, q, clearance):
    """Distances and verdicts equal those of coal; returns the verdicts."""
    slow = by_coal(model)
    distances = slow.distance_rows(q)
    assert_alike(model.distance_rows(q), distances)
    reach = np.linspace(-0.05, 0.3, len(q))
    assert_alike(model.distance_rows(q, beyond=reach), np.minimum(distances, reach[:, None]))
    if distances.size:
        pairs = np.arange(len(q)) % distances.shape[1]
        chosen = distances[np.arange(len(q)), pairs]
        assert_alike(model.pair_distances(q, pairs), chosen)
        assert_alike(model.pair_distances(q, pairs, beyond=reach), np.minimum(chosen, reach))
        least, row, pair = model.least_distance(q)
        assert_alike(np.array([least, distances[row, pair]]), np.full(2, distances.min()))
    hit = model.in_collision_rows(q, clearance=clearance)
    clear = np.abs(distances - clearance).min(axis=1, initial=np.inf) > 1e-8  # elsewhere rounding decides
    np.testing.assert_array_equal(hit[clear], (distances < clearance).any(axis=1)[clear])
    np.testing.assert_array_equal(hit, [model.in_collision(each, clearance=clearance) for each in q])
    np.testing.assert_array_equal(hit[clear], slow.in_collision_rows(q, clearance=clearance)[clear])
    return hit


@pytest.mark.slow
@pytest.mark.parametrize("arm", [*ARMS, *(pytest.param(name, marks=pytest.mark.long) for name in MORE_ARMS)], indirect=True)
@pytest.mark.parametrize("clearance", [0.0, 0.04])
def test_an_arm_among_obstacles_of_every_shape(arm, wedge, rng, clearance):
    hits = []
    for k, shape in enumerate(SHAPES):
        place = 0.8 * arm.kinematics().pose(arm.random_configuration(rng))[:3, 3]
        turn = rng.uniform(-3, 3, 3)
        if shape == "plane":
            place, turn = [0, 0, -0.1 - 0.2 * k / 6], [0.1, 0.2, 0.0]
        scene = mp.Scene([obstacle(shape, place, turn, 0.4, wedge)])
        q = arm.random_configuration(rng, size=60)
        hits += list(assert_kernel_is_right(scene.collision_model(arm), q, clearance))
    assert sum(hits) > 5  # some arms always have links within 40 mm of each other
    assert clearance or sum(hits) < len(hits) - 5


angle = st.floats(-np.pi, np.pi)


@pytest.mark.slow
@examples(60)
@given(
    shape=st.sampled_from(SHAPES),
    place=st.tuples(*[st.floats(-1.0, 1.0)] * 3),
    turn=st.tuples(*[angle] * 3),
    size=st.floats(0.01, 1.5),
    clearance=st.sampled_from([0.0, 1e-3, 0.02, 0.3]),
    seed=st.integers(0, 2**31),
)
def test_any_single_obstacle(panda, wedge, shape, place, turn, size, clearance, seed):
    scene = mp.Scene([obstacle(shape, place, turn, size, wedge)])
    q = panda.random_configuration(np.random.default_rng(seed), size=6)
    assert_kernel_is_right(scene.collision_model(panda), q, clearance)


@pytest.mark.slow
@examples(40)
@given(
    shape=st.sampled_from(SHAPES),
    place=st.tuples(*[st.floats(-0.8, 0.8)] * 3),
    turn=st.tuples(*[angle] * 3),
    size=st.floats(0.05, 1.0),
    step=st.sampled_from([0.0, 1e-9, 1e-4, 1e-2, 0.3]),
    seed=st.integers(0, 2**31),
)
def test_distances_along_a_path_are_those_of_each_configuration(panda, wedge, shape, place, turn, size, step, seed):
    """Along a path each pair is compared from the simplex or the triangles that were nearest before."""
    model = mp.Scene([obstacle(shape, place, turn, size, wedge)]).collision_model(panda)
    start, end = panda.random_configuration(np.random.default_rng(seed), size=2)
    q = start + step * np.linspace(0, 1, 12)[:, None] * (end - start)
    alone = np.concatenate([model.distance_rows(each[None]) for each in q])
    np.testing.assert_allclose(model.distance_rows(q), alone, rtol=0, atol=2e-8)


def test_the_clearance_is_a_sharp_border(panda):
    """At a hair less than the distance a configuration is free, at a hair more it is not."""
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.6, 0.1, 0.3), name="ball")])
    model = scene.collision_model(panda)
    q = panda.neutral[None]
    distance = model.distances(panda.neutral).min()
    assert not model.in_collision_rows(q, clearance=distance - 1e-6).any()
    assert model.in_collision_rows(q, clearance=distance + 1e-6).all()


def test_a_body_inside_a_solid_mesh_touches_and_in_the_hole_of_a_ring_does_not(planar):
    """The last link, about 1 cm thick, stands wholly inside the tube of a large ring, or in its hole."""
    q = np.array([0.3, 0.4, 0.5])
    middle = planar.kinematics().pose(q)[:3, 3]
    rings = {
        "inside": mp.Mesh(triangles=20 * ring(), position=middle - [20, 0, 0], name="inside"),
        "hole": mp.Mesh(triangles=20 * ring(), position=middle, name="hole"),
        "open": mp.Mesh(triangles=20 * ring()[1:], position=middle - [20, 0, 0], name="open"),
    }
    for name, mesh in rings.items():
        model = mp.Scene([mesh]).collision_model(planar)
        for each in (model, by_coal(model)):
            assert each.in_collision(q) is (name == "inside")
            distances = each.distances(q)[[k for k, pair in enumerate(model.pair_names) if pair[1] == name]]
            assert ((distances < 0) if name == "inside" else (distances > 0)).all() and np.abs(distances).min() > 1


def test_the_nearest_points_of_a_mesh_and_a_cloud(panda, rng):
    """The witness of a pair, found at the nearest triangle alone, equals that of the whole mesh by coal."""
    options = {"position": (0.5, 0.1, 0.4), "rotation": (0.3, 0.2, 0.1)}
    meshes = [mp.Mesh(triangles=0.2 * ring(), name="ring", **options)]
    meshes.append(mp.PointCloud(points=0.2 * ring().reshape(-1, 3), radius=0.02, name="cloud", position=(-0.5, 0.1, 0.4)))
    model, compared = mp.Scene(meshes).collision_model(panda), 0
    slow = by_coal(model)
    for q in panda.random_configuration(rng, size=20):
        distances = model.distances(q)
        for pair in [k for k, d in enumerate(distances) if 1e-3 < d < 0.3 and model.pair_names[k][1] in ("ring", "cloud")]:
            one, other = model.witnesses(q[None], [pair]), slow.witnesses(q[None], [pair])
            np.testing.assert_allclose(one.normals, other.normals, atol=1e-4)
            np.testing.assert_array_equal(one.radii, other.radii)
            assert one.distances[0] == pytest.approx(distances[pair], abs=1e-9)
            compared += 1
    assert compared > 50


@pytest.mark.slow
@pytest.mark.parametrize("arm", ARMS, indirect=True)
def test_nearest_points_and_directions_agree_with_each_other_and_with_coal(arm, rng):
    """In the world the two points are as far apart as the pair plus both radii, along the direction between them."""
    scene = mp.Scene(
        [
            mp.Box(size=(0.2, 0.1, 0.3), position=(0.4, 0.2, 0.5), rotation=(0.3, 0.1, 0.7), name="box"),
            mp.Capsule(radius=0.05, length=0.3, position=(-0.3, 0.4, 0.6), rotation=(0.4, 0.8, 0), name="bar"),
            mp.Cylinder(radius=0.1, length=0.3, position=(0.0, -0.5, 0.4), rotation=(0.2, 0, 0), name="drum"),
            mp.Plane(rotation=(0.1, 0, 0), position=(0, 0, -1.5), name="floor"),
        ]
    )
    model, data, compared, overlaps = scene.collision_model(arm), arm.model.createData(), 0, 0
    slow = by_coal(model)
    for q in arm.random_configuration(rng, size=15):
        distances, pairs = model.distances(q), np.arange(len(model.pair_names))
        found, expected = (each.witnesses(np.tile(q, (len(pairs), 1)), pairs) for each in (model, slow))
        np.testing.assert_allclose(found.distances, distances, atol=1e-9)
        np.testing.assert_allclose(found.distances, expected.distances, atol=2e-6)  # depths of overlaps, too
        overlaps += int((distances < 0).sum())
        np.testing.assert_array_equal(found.joints, expected.joints)
        pin.forwardKinematics(arm.model, data, q)
        for k in pairs:
            first, second = (data.oMi[int(joint)] for joint in found.joints[k])
            point, other = first.act(found.points[k]), second.act(found.others[k])
            direction = second.rotation @ found.normals[k]
            np.testing.assert_allclose(first.rotation @ found.opposites[k], -direction, atol=1e-12)
            if found.distances[k] + found.radii[k].sum() > 1e-6:  # the bodies' cores are apart
                np.testing.assert_allclose(point - other, (distances[k] + found.radii[k].sum()) * direction, atol=1e-9)
            if found.distances[k] > 1e-3:
                np.testing.assert_allclose(found.normals[k], expected.normals[k], atol=2e-3)
                np.testing.assert_allclose(found.gradients[k], expected.gradients[k], atol=4e-3)
                compared += 1
    assert compared > 100 and (overlaps > 3 or arm.n < 6)


def test_coal_s_answers_do_not_depend_on_those_before(planar, rng):
    """Pinocchio lets coal begin at its last answer; then depths differed by 1e-8 m and their directions by 1e-4."""
    post = mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")
    model = mp.Scene([post]).collision_model(planar)
    q = planar.random_configuration(rng, size=2000)
    distances = model.distance_rows(q)
    touching = np.flatnonzero(distances.min(axis=1) < 0)
    q, pairs = q[touching], distances[touching].argmin(axis=1)
    used = by_coal(model)
    several = used.witnesses(q, pairs)
    for k in range(len(q)):
        alone = by_coal(model).witnesses(q[k : k + 1], pairs[k : k + 1])
        for name in ("distances", "normals", "points", "gradients"):
            np.testing.assert_array_equal(getattr(alone, name)[0], getattr(several, name)[k])
    assert len(q) > 10


def test_threads_that_share_a_model_do_not_disturb_each_other(panda, rng):
    model = mp.Scene([mp.Box(size=(0.3, 0.3, 0.3), position=(0.5, 0, 0.4), name="box")]).collision_model(panda)
    batches = panda.random_configuration(rng, size=8 * 3000).reshape(8, 3000, 7)
    alone = [model.in_collision_rows(q) for q in batches]
    near = [model.distance_rows(q[:200], beyond=0.05) for q in batches]
    with ThreadPoolExecutor(4) as pool:
        together = [pool.submit(model.in_collision_rows, q) for q in batches]
        distances = [pool.submit(model.distance_rows, q[:200], beyond=0.05) for q in batches]
        single = [pool.submit(lambda q: [model.in_collision(each) for each in q[:500]], q) for q in batches]
    for k in range(8):
        np.testing.assert_array_equal(together[k].result(), alone[k])
        np.testing.assert_array_equal(single[k].result(), alone[k][:500])
        np.testing.assert_allclose(distances[k].result(), near[k], atol=2e-6)  # depths by coal


def test_near_pairs_are_the_distances_below_a_limit(panda, rng):
    scene = mp.Scene([mp.Sphere(radius=0.1, position=(0.4, 0.1 * k, 0.4), name=f"ball{k}") for k in range(4)])
    model, q = scene.collision_model(panda), panda.random_configuration(rng, size=30)
    for beyond in (np.linspace(-0.02, 2.0, 30), np.full(30, 0.1), np.full(30, 1e3)):  # up to all pairs, which need more room
        rows = model.distance_rows(q)
        near = rows < beyond[:, None]
        for some in (model, by_coal(model)):
            found = some.near_pairs(q, beyond)
            np.testing.assert_array_equal(np.stack([found.rows, found.pairs]), np.nonzero(near))
            assert_alike(found.distances, rows[near])
            whole = found.at(*(each.ravel() for each in np.indices(rows.shape)), 7.0)
            np.testing.assert_array_equal((whole == 7.0).reshape(rows.shape), ~near)
            before, after = found.beside(7.0)
            padded = np.pad(np.where(near, rows, 7.0), ((1, 1), (0, 0)), constant_values=np.inf)
            assert_alike(before, padded[found.rows, found.pairs])
            assert_alike(after, padded[found.rows + 2, found.pairs])


def test_distances_of_what_is_not_finite_are_not_known(panda):
    model = mp.Scene([mp.Sphere(radius=0.1, position=(0.4, 0.1, 0.4))]).collision_model(panda)
    for wrong in (np.nan, np.inf):
        q = np.array([panda.neutral, panda.neutral])
        q[1, 2] = wrong
        found, leaf = model._kernel._pairs(q, model._kernel._bodies[:2], np.full(2, 1.0))
        assert np.isfinite(found[0]) and np.isnan(found[1]) and leaf[1] == -1
        where, distances = model._kernel.near(q, np.full(2, 0.05))
        assert np.isnan(distances[where >= len(model.pair_names)]).sum() == len(model.pair_names)
        for some in (model, by_coal(model)):
            near = some.near_pairs(q, 0.05)
            assert (near.rows == 1).any() and not (near.distances[near.rows == 1] > 0.05).any(), "what is not known is not far"


def test_what_is_not_finite_is_not_called_free(panda):
    """Public calls refuse it; the kernel leaves it to coal."""
    kernel = mp.Scene().collision_model(panda)._kernel
    if kernel is not None:
        q = np.array([[0, 0, 0, np.nan, 0, 1, 0], [0, 0, 0, -np.inf, 0, 1, 0]])
        assert (kernel.check_rows(q, 0.0) == UNDECIDED).all() and np.isnan(kernel.distances(q, np.full(2, np.inf))).all()


def test_no_pairs_is_free_everywhere():
    arm = mp.load_robot("simple_humanoid_right_arm")
    model = mp.Scene().collision_model(arm)
    q = arm.random_configuration(np.random.default_rng(0), size=5)
    assert not model.in_collision_rows(q).any()
    assert model.least_distance(q) == (np.inf, 0, -1)


# ---- the collision model


@pytest.mark.slow
@pytest.mark.parametrize("arm", ARMS, indirect=True)
def test_the_gradient_of_each_distance_by_finite_differences(arm, wedge, rng):
    """Of pairs that are apart; where the nearest points jump between features there is none, which differences show."""
    scene = mp.Scene(
        [
            mp.Sphere(radius=0.05, position=(0.3, 0.4, 0.5), name="ball"),
            mp.Capsule(radius=0.05, length=0.3, position=(-0.3, 0.4, 0.6), rotation=(0.4, 0.8, 0), name="bar"),
        ]
    )
    model, step, compared = scene.collision_model(arm), 1e-3, 0
    for q in arm.random_configuration(rng, size=6):
        at = model.distances(q)
        sides = [(model.distances(q + step * e), model.distances(q - step * e)) for e in np.eye(arm.n)]
        central = np.array([(a - b) / (2 * step) for a, b in sides])
        smooth = (np.array([np.abs(a + b - 2 * at) for a, b in sides]) < 4e-6).all(axis=0) & (at > 0.01)
        for pair in np.flatnonzero(smooth):
            np.testing.assert_allclose(model.witnesses(q[None], [pair]).gradients[0], central[:, pair], atol=4e-3)
            compared += 1
        assert np.abs(central[:, smooth]).max() > 0.01
    assert compared > 6


def test_a_gradient_also_where_bodies_overlap(planar):
    """The distance is negative; it still falls as the link goes deeper into the ball."""
    q = np.array([0.3, 0.4, 0.5])
    tool = planar.kinematics().pose(q)[:3, 3]
    model = mp.Scene([mp.Sphere(radius=0.3, position=tool + [0.05, 0.1, 0], name="ball")]).collision_model(planar)
    distances = model.distances(q)
    pair = int(distances.argmin())
    assert distances[pair] < 0
    numbers = [(model.distances(q + 1e-6 * e)[pair] - model.distances(q - 1e-6 * e)[pair]) / 2e-6 for e in np.eye(3)]
    np.testing.assert_allclose(model.witnesses(q[None], [pair]).gradients[0], numbers, atol=1e-3)


def test_a_copy_answers_alike_and_for_itself(panda, rng):
    model = mp.Scene([mp.Sphere(radius=0.2, position=(0.4, 0.2, 0.4), name="ball")]).collision_model(panda)
    copy = model.copy()
    assert copy.pair_names == model.pair_names and copy.bodies == model.bodies
    for q in panda.random_configuration(rng, size=10):
        np.testing.assert_array_equal(copy.distances(q), model.distances(q))
        assert copy.in_collision(q, clearance=0.1) == model.in_collision(q, clearance=0.1)


@pytest.mark.slow
@pytest.mark.parametrize("shape", ['type="sphere" size="0.05"', 'type="ellipsoid" size="0.05 0.04 0.05"'])
def test_inside_a_solid_the_way_leads_out(tmp_path, shape):
    """Distance, its gradient and the plane of a ball that slides from the middle of a tube through its wall."""
    file = tmp_path / "ball.xml"
    file.write_text(f"""<mujoco><worldbody><body name="b"><joint name="x" type="slide" axis="1 0 0" range="-5 5"/>
      <geom {shape}/></body></worldbody></mujoco>""")
    robot = mp.Robot.from_mjcf(file, tool="b", velocity=1.0)
    model = mp.Scene([mp.Mesh(triangles=ring(), name="ring")]).collision_model(robot)  # solid for 0.6 < |x| < 1.4
    for x, sign in ((1.25, 1.0), (0.75, -1.0), (1.6, 1.0), (0.4, -1.0)):
        q = np.array([x])
        [distance] = model.distances(q)
        assert (distance < 0) == (0.6 < x < 1.4)
        found = model.witnesses(q[None], [0])
        assert sign * found.gradients[0, 0] > 0.9, "further out is better"
        assert found.distances[0] == pytest.approx(distance, abs=1e-9)
        assert sign * found.normals[0, 0] > 0.9 and sign * found.opposites[0, 0] < -0.9


def test_parts_of_own_obstacles_are_checked(panda):
    for radius in (np.nan, -1.0, "x"):
        with pytest.raises(mp.errors.InvalidInputError, match="radius"):
            Part(shape=coal.Box(1, 1, 1), radius=radius)
    with pytest.raises(mp.errors.InvalidInputError, match="shape: got .*; allowed: a shape of coal"):
        Part(shape=mp.Box(size=(1, 1, 1)))
    with pytest.raises(mp.errors.InvalidInputError, match="without a distance around it"):
        panda.attach(FatBox(size=(0.1, 0.1, 0.1)), name="part")


def by_llvm(model, calls):
    """A model whose kernel is that of LLVM's language."""
    other = model.copy()
    other.__dict__["_kernel"] = DistanceKernel(calls, model._kernel._arrays)
    return other


@pytest.fixture(scope="session")
def llvm_calls():
    return kernel_by_llvm("distances")


@pytest.mark.slow
@pytest.mark.parametrize("arm", ARMS, indirect=True)
def test_llvm_s_kernel_gives_the_same(arm, wedge, rng, llvm_calls):
    """Bit by bit, as both are the same operations without contraction."""
    for shape in SHAPES:
        place = 0.8 * arm.kinematics().pose(arm.random_configuration(rng))[:3, 3]
        model = mp.Scene([obstacle(shape, place, rng.uniform(-3, 3, 3), 0.3, wedge)]).collision_model(arm)
        other, q = by_llvm(model, llvm_calls), arm.random_configuration(rng, size=300)
        np.testing.assert_array_equal(other.distance_rows(q), model.distance_rows(q))
        np.testing.assert_array_equal(other.in_collision_rows(q), model.in_collision_rows(q))
        np.testing.assert_array_equal([other.in_collision(each) for each in q[:50]], model.in_collision_rows(q[:50]))


@pytest.mark.slow
def test_without_a_compiler_the_kernel_is_made_by_llvm(tmp_path):
    """In a process of its own with an empty cache, and with the same verdicts."""
    program = """
import numpy as np, manipplan as mp
robot = mp.load_robot("panda")
scene = mp.Scene([mp.Box(size=(0.3, 0.3, 0.3), position=(0.5, 0.0, 0.5))])
q = robot.random_configuration(np.random.default_rng(0), size=500)
print(scene.collision_model(robot)._kernel is not None, scene.in_collision(robot, q).nonzero()[0].tolist())
"""
    answers = []
    for compiler in ({}, {"CC": "", "MANIPPLAN_CACHE": str(tmp_path)}):
        run = subprocess.run(
            [sys.executable, "-c", program], env=os.environ | compiler, capture_output=True, text=True, check=True
        )
        answers.append(run.stdout)
    assert answers[0] == answers[1]
    assert answers[0].startswith("True ")


def test_distances_along_a_path_are_smooth(rng):
    """They do not depend on where the search for them began: those of `witnesses` are found anew, and more exactly."""
    robot = mp.load_robot("panda")
    bodies = [
        mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3)),
        mp.Cylinder(radius=0.1, length=0.5, position=(0.3, 0.4, 0.4)),
        mp.Box(size=(0.4, 0.4, 0.02), position=(0.5, -0.3, 0.5)),
    ]
    model = mp.Scene(bodies).collision_model(robot)
    differences = []
    for _ in range(5):
        first, last = rng.uniform(0.9 * robot.limits.lower, 0.9 * robot.limits.upper, (2, robot.n))
        q = first + np.linspace(0.0, 0.2, 200)[:, None] * (last - first)
        distances = model.distance_rows(q)
        row, pair = np.nonzero((distances > 1e-3) & (distances < 0.3))
        differences.append(np.abs(model.witnesses(q[row], pair).distances - distances[row, pair]))
    found = np.concatenate(differences)
    assert found.max() < 1e-10 and (found > 1e-13).mean() < 0.01
