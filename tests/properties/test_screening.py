"""What screening calls free is free: against coal, for arms and scenes of every shape, and the gradient of distances."""

import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.collision.screening import Screening, free_rows

ARMS = ["panda", "ur5", "planar", "two"]
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
SHAPES = ["box", "sphere", "capsule", "cylinder", "plane", "mesh"]


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


@pytest.fixture
def arm(request, panda, ur5, planar, two_link_urdf):
    known = {"panda": panda, "ur5": ur5, "planar": planar}
    name = request.param
    if name == "two":
        return mp.load_robot(two_link_urdf(), tool="tip")
    return known.get(name) or mp.load_robot(name)


def obstacle(shape, place, turn, size, wedge):
    options = {"position": place, "rotation": turn, "name": shape}
    return {
        "box": lambda: mp.Box(size=(size, 0.3 * size, 0.1 + size), **options),
        "sphere": lambda: mp.Sphere(radius=size / 2, **options),
        "capsule": lambda: mp.Capsule(radius=size / 4, length=size, **options),
        "cylinder": lambda: mp.Cylinder(radius=size / 3, length=0.2 * size, **options),
        "plane": lambda: mp.Plane(**options),
        "mesh": lambda: mp.Mesh(file=wedge, scale=2 * size, **options),
    }[shape]()


def assert_screening_is_right(model, q, clearance):
    """The pairs that are not suspected are apart by more than the clearance, and what is said to be free is."""
    screening = Screening.of(model)
    suspects = screening.suspects(q, clearance)
    distances = np.array([model.distances(each) for each in q]).reshape(len(q), -1)
    assert (distances[~suspects] > clearance - 1e-9).all()
    hit = np.array([model.in_collision(each, clearance=clearance) for each in q])
    np.testing.assert_array_equal(free_rows(screening, model.copy(), q, clearance), ~hit)
    return suspects, hit


@pytest.mark.slow
@pytest.mark.parametrize("arm", [*ARMS, *(pytest.param(name, marks=pytest.mark.long) for name in MORE_ARMS)], indirect=True)
@pytest.mark.parametrize("clearance", [0.0, 0.04])
def test_an_arm_among_obstacles_of_every_shape(arm, wedge, rng, clearance):
    hits, spared = 0, 0
    for k, shape in enumerate(SHAPES):
        place = 0.8 * arm.kinematics().pose(arm.random_configuration(rng))[:3, 3]
        turn = rng.uniform(-3, 3, 3)
        if shape == "plane":
            place, turn = [0, 0, -0.1 - 0.2 * k / 6], [0.1, 0.2, 0.0]
        scene = mp.Scene([obstacle(shape, place, turn, 0.4, wedge)])
        q = arm.random_configuration(rng, size=60)
        suspects, hit = assert_screening_is_right(scene.collision_model(arm), q, clearance)
        hits, spared = hits + hit.sum(), spared + (~suspects).sum()
    assert hits > 5 and spared > 100  # both answers were at stake


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
    assert_screening_is_right(scene.collision_model(panda), q, clearance)


def test_the_clearance_is_a_sharp_border(panda):
    """At a hair less than the distance a configuration is free, at a hair more it is not."""
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.6, 0.1, 0.3), name="ball")])
    model = scene.collision_model(panda)
    q = panda.neutral[None]
    screening, distance = Screening.of(model), model.distances(panda.neutral).min()
    assert free_rows(screening, model, q, distance - 1e-6).all()
    assert not free_rows(screening, model, q, distance + 1e-6).any()


def test_no_pairs_is_free_everywhere():
    arm = mp.load_robot("simple_humanoid_right_arm")
    model = mp.Scene().collision_model(arm)
    q = arm.random_configuration(np.random.default_rng(0), size=5)
    assert free_rows(Screening.of(model), model, q, 0.0).all()


# ---- the collision model


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
            np.testing.assert_allclose(model.distance_gradient(q, int(pair)), central[:, pair], atol=4e-3)
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
    np.testing.assert_allclose(model.distance_gradient(q, pair), numbers, atol=1e-3)


def test_touches_looks_at_the_given_pairs_alone(panda, rng):
    scene = mp.Scene([mp.Box(size=(0.5, 0.5, 0.5), position=(0.4, 0, 0.4), name="block")])
    model = scene.collision_model(panda)
    seen = 0
    for q in panda.random_configuration(rng, size=20):
        hit = set(model.touching_pairs(q))
        assert model.touches(q, hit) is bool(hit)
        assert not model.touches(q, set(range(len(model.pair_names))) - hit)
        assert not model.touches(q, [])
        seen += len(hit)
        distances = model.distances(q)
        near = [k for k, d in enumerate(distances) if 0.001 < d < 0.049]
        assert all(model.touches(q, [k], clearance=0.05) for k in near)
        assert not model.touches(q, near)  # the margin does not stay
    assert seen > 5


def test_a_copy_answers_alike_and_for_itself(panda, rng):
    model = mp.Scene([mp.Sphere(radius=0.2, position=(0.4, 0.2, 0.4), name="ball")]).collision_model(panda)
    copy = model.copy()
    assert copy.pair_names == model.pair_names and copy.primitives == model.primitives
    for q in panda.random_configuration(rng, size=10):
        np.testing.assert_array_equal(copy.distances(q), model.distances(q))
        assert copy.in_collision(q, clearance=0.1) == model.in_collision(q, clearance=0.1)
    copy.geometry.removeAllCollisionPairs()
    assert len(model.geometry.collisionPairs) == len(model.pair_names) > 0
