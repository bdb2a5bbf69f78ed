"""Obstacle shapes of the user: pieces, and bodies of a support function, which a polytope encloses."""

import logging
import pickle
from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.collision.shapes import EXCESS
from manipplan.jobs.plan_many import scene_key
from manipplan.viz.shapes import triangles_of

CORNERS = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T / 2
PANDA = mp.load_robot("panda")


@dataclass(frozen=True, kw_only=True, eq=False)
class Angle(mp.Obstacle):
    """Two boxes."""

    size: float = 0.3

    def pieces(self):
        first = CORNERS * [self.size, 0.1, 0.1]
        return [first, CORNERS * [0.1, 0.1, self.size] + [self.size / 2 - 0.05, 0.0, self.size / 2]]


@dataclass(frozen=True, kw_only=True, eq=False)
class Ellipsoid(mp.Obstacle):
    radii: tuple[float, float, float]

    def support(self, directions):
        stretched = directions * self.radii
        return self.radii * stretched / np.linalg.norm(stretched, axis=1, keepdims=True)


@dataclass(frozen=True, kw_only=True, eq=False)
class Rounded(mp.Obstacle):
    """The points within a distance of a polytope."""

    points: np.ndarray
    around: float = 0.0
    excess: float = EXCESS

    def support(self, directions):
        return self.points[(directions @ self.points.T).argmax(axis=1)] + self.around * directions


@dataclass(frozen=True, kw_only=True, eq=False)
class Answering(mp.Obstacle):
    """Returns what it is given."""

    answer: object = None
    excess: object = None

    def support(self, directions):
        return self.answer(directions)


def corners_of(shape):
    (part,) = shape.parts()
    return np.array(part.shape.points())


def configurations(count):
    return PANDA.random_configuration(np.random.default_rng(0), size=count)


def test_pieces_are_solid_as_boxes_are():
    pose = pin.SE3(pin.rpy.rpyToMatrix(0.3, -0.4, 0.5), np.array([0.4, 0.1, 0.5])).homogeneous
    own = mp.Scene([Angle().at(pose)])
    boxes = [mp.Box(size=(0.3, 0.1, 0.1)), mp.Box(size=(0.1, 0.1, 0.3), position=(0.1, 0.0, 0.15))]
    both = mp.Scene([each.at(pose) for each in boxes])
    q = configurations(200)
    found, wanted = (scene.collision_model(PANDA) for scene in (own, both))
    assert (found.in_collision_rows(q) == wanted.in_collision_rows(q)).all() and found.in_collision_rows(q).any()
    for each in q[:50]:
        assert found.distances(each).min() == pytest.approx(wanted.distances(each).min(), abs=1e-6)


def test_triangles_are_pieces_as_in_a_mesh():
    triangles = CORNERS[[[0, 1, 3], [0, 3, 2]]]  # a surface
    mesh = mp.Mesh(triangles=triangles)
    own = Answering()
    object.__setattr__(own, "pieces", lambda: [triangles, CORNERS + 2.0])
    object.__setattr__(own, "support", None)
    surface, solid = own.parts()
    assert (surface.closed, solid.closed) == (mesh.parts()[0].closed, True) == (False, True)
    assert surface.shape.num_tris == mesh.parts()[0].shape.num_tris


@pytest.mark.slow
@pytest.mark.parametrize("radii", [(0.2, 0.2, 0.2), (0.5, 0.1, 0.05), (0.3, 0.3, 0.003), (1.0, 0.004, 0.004)])
def test_a_polytope_encloses_an_ellipsoid(radii, rng):
    corners = corners_of(Ellipsoid(radii=radii))
    directions = rng.normal(size=(5000, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    excess = (directions @ corners.T).max(axis=1) - np.linalg.norm(directions * radii, axis=1)
    assert excess.min() >= 0.0 and excess.max() <= EXCESS
    body, ball = coal.Ellipsoid(*radii), coal.Sphere(1e-6)  # judged by coal as well
    for corner in corners[:: max(1, len(corners) // 50)]:
        apart = coal.distance(
            body, coal.Transform3s(), ball, coal.Transform3s(np.eye(3), corner), coal.DistanceRequest(), coal.DistanceResult()
        )
        assert apart <= EXCESS + 1e-5


@pytest.mark.slow
@settings(deadline=None, max_examples=40)
@given(
    seed=st.integers(0, 10**6),
    count=st.integers(4, 40),
    scale=st.tuples(*[st.floats(0.02, 0.5)] * 3),
    around=st.sampled_from([0.0, 0.01, 0.1]),
)
def test_a_polytope_encloses_any_convex_body(seed, count, scale, around):
    rng = np.random.default_rng(seed)
    body = Rounded(points=rng.normal(size=(count, 3)) * scale, around=around, excess=5e-3)
    corners = corners_of(body)
    directions = rng.normal(size=(2000, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    excess = (directions @ corners.T).max(axis=1) - np.einsum("ij,ij->i", directions, body.support(directions))
    assert excess.min() >= 0.0 and excess.max() <= 5e-3


def test_a_box_by_its_support_is_that_box():
    body = Rounded(points=CORNERS * [0.4, 0.3, 0.02])
    lower, upper = corners_of(body).min(axis=0), corners_of(body).max(axis=0)
    assert np.abs(upper - [0.2, 0.15, 0.01]).max() < 1e-8 and np.abs(lower + upper).max() < 1e-8


@pytest.mark.slow
def test_clearances_are_on_the_safe_side():
    """Distances to a ball by its support are those of a sphere, or up to 1 mm less."""
    place = (0.4, 0.2, 0.5)
    own = mp.Scene([Ellipsoid(radii=(0.15, 0.15, 0.15), position=place)]).collision_model(PANDA)
    ball = mp.Scene([mp.Sphere(radius=0.15, position=place)]).collision_model(PANDA)
    for q in configurations(300):
        less = ball.distances(q).min() - own.distances(q).min()
        if ball.distances(q).min() > 0:
            assert -1e-6 <= less <= EXCESS + 1e-6


@pytest.mark.slow
def test_plans_keep_clear_of_it(tmp_path):
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    scene = mp.Scene([Ellipsoid(radii=(0.12, 0.1, 0.4), position=(0.03, 2.2, 0.0), name="post")])
    plan = mp.plan(arm, [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0], scene)
    assert plan.status.ok and scene.path_clearance(arm, plan.path).proven
    plan.save(tmp_path / "result")
    with pytest.raises(mp.errors.FileFormatError, match="post, a Ellipsoid.*give scene="):
        mp.Plan.load(tmp_path / "result")
    assert mp.Plan.load(tmp_path / "result", scene=scene).status.ok
    with pytest.raises(mp.errors.InvalidInputError, match="post, a Ellipsoid.*a file stores no others"):
        scene.to_yaml(tmp_path / "scene.yaml")


@pytest.mark.slow
def test_it_is_an_obstacle_as_any_other():
    assert mp.Scene([Angle(), Ellipsoid(radii=(0.1, 0.1, 0.1))]).names == ("angle0", "ellipsoid1")
    held = PANDA.attach(Angle(size=0.2, name="part"))
    assert held.carried["part"].bodies == ("part.0", "part.1")
    shape = Ellipsoid(radii=(0.1, 0.2, 0.1), position=(1.0, 0.0, 0.0), rotation=(0.0, 0.0, np.pi / 2))
    vertices, faces = triangles_of(shape.shapes()[0])
    assert len(faces) and np.abs(vertices).max(axis=0) == pytest.approx([0.1, 0.2, 0.1], abs=EXCESS)
    again = pickle.loads(pickle.dumps(shape))
    assert np.array_equal(corners_of(again), corners_of(shape)) and shape.called("other").parts()


@pytest.mark.slow
def test_stored_results_know_its_shape():
    """The key holds what the methods return, not only the fields."""
    keys = [scene_key(mp.Scene([Rounded(points=CORNERS * size)])) for size in (0.1, 0.1, 0.2)]
    assert keys[0] == keys[1] != keys[2]
    first, second = (Answering(answer=bound) for bound in (support_of(0.1), support_of(0.2)))
    assert scene_key(mp.Scene([first])) != scene_key(mp.Scene([second]))


def support_of(size):
    return lambda directions: size * directions


@pytest.mark.slow
def test_a_large_round_body_has_more_excess_and_the_log_says_so(caplog):
    caplog.set_level(logging.INFO, "manipplan")
    mp.Scene([Ellipsoid(radii=(2.0, 2.0, 2.0))])
    assert "planes enclose the body, at most 1" in caplog.text and "mm away" in caplog.text
    with pytest.raises(mp.errors.InvalidInputError, match=r"Answering.support: got 'a body of 4 m .*excess = 0.01\d or more"):
        mp.Scene([Answering(answer=support_of(2.0), excess=1e-3)])
    assert len(corners_of(Answering(answer=support_of(2.0), excess=0.1))) < 400


class Neither(mp.Obstacle):
    pass


class Both(mp.Obstacle):
    def pieces(self):
        return [CORNERS]

    def support(self, directions):
        return directions


class Pieces(mp.Obstacle):
    answer = None

    def pieces(self):
        return self.answer


@pytest.mark.parametrize("kind", [mp.Obstacle, Neither, Both])
def test_one_of_the_methods_is_needed(kind):
    with pytest.raises(
        mp.errors.InvalidInputError, match=f"{kind.__name__} with (both|neither) .*; allowed: a class with one of"
    ):
        mp.Scene([kind()])


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (None, "Pieces.pieces: got None; allowed: a list of 1 to 10,000 arrays"),
        ([], "Pieces.pieces: got"),
        ([CORNERS, "x"], r"Pieces.pieces\[1\]"),
        ([[[0.0, 1.0, 2.0], [0.0]]], r"Pieces.pieces\[0\]"),
        ([CORNERS[:, :2]], r"Pieces.pieces\[0\].*\(any, 3\)"),
        ([CORNERS * np.nan], r"Pieces.pieces\[0\].*finite"),
        ([CORNERS * 1e7], r"Pieces.pieces\[0\]"),
        ([CORNERS * [1, 1, 0]], r"Pieces.pieces\[0\]: got '8 points that are flat'; allowed: points whose hull has a volume"),
    ],
)
def test_pieces_that_are_refused(answer, message):
    shape = Pieces()
    object.__setattr__(shape, "answer", answer)
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Scene([shape])


def not_the_farthest(directions):
    points = np.array(directions)
    points[directions[:, 2] > 0.9] *= 0.5
    return points


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (lambda directions: directions[:, :2], r"Answering.support.*\(26, 3\), not \(26, 2\)"),
        (lambda directions: directions[0], r"\(26, 3\), not \(3,\)"),
        (lambda directions: directions / 0.0 * np.inf, "finite"),
        (lambda directions: 1e7 * directions, "Answering.support"),
        (lambda directions: directions * [1, 1, 0], "points of a body with a volume"),
        (lambda directions: 0 * directions, "points of a body with a volume"),
        (lambda directions: -directions, r"the point of the body that is farthest in its direction"),
        (not_the_farthest, r"farthest in its direction \[.*; another one is farther"),
        (lambda directions: directions.nothing, "<lambda>.*it raised AttributeError|raised AttributeError"),
    ],
)
def test_support_functions_that_are_refused(answer, message):
    with np.errstate(all="ignore"), pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Scene([Answering(answer=answer)])


@pytest.mark.parametrize("excess", [0.0, -1.0, "small", np.nan])
def test_excess_is_a_length(excess):
    with pytest.raises(mp.errors.InvalidInputError, match="Answering.excess"):
        mp.Scene([Answering(answer=support_of(0.1), excess=excess)])


@pytest.mark.parametrize("method", ["pieces", "support"])
def test_a_kind_of_a_built_in_shape_has_no_parts_of_its_own(method):
    with pytest.raises(
        mp.errors.InvalidInputError, match=rf"Tall: got 'a kind of Box with {method}\(\)'; allowed: one of mp.Obstacle"
    ):
        type("Tall", (mp.Box,), {method: lambda self, *_: []})
