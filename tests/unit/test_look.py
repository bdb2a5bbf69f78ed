"""Looks along a curve: compiled code and NumPy find the same places, and no place of a bracket is nearer than its bottom."""

import numpy as np
import pytest

import manipplan as mp
from manipplan.collision import look
from manipplan.collision.kernel import DistanceKernel
from manipplan.collision.look import BOTTOM, CLOSE, INTERVALS, NOTHING, SPACING, DistanceSearch
from manipplan.paths.joint import JointPath

GRID = np.linspace(0.0, 1.0, 41)


@pytest.fixture(scope="module")
def dips(panda):
    """A path through a post, and every bracket of the grid in which a pair nearer than 0.1 m has a dip."""
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post")])
    path = JointPath.line([-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8])
    search = DistanceSearch(model=scene.collision_model(panda))
    found = search.model.distance_rows(path(GRID))
    k, pairs = np.nonzero((found[1:-1] <= found[:-2]) & (found[1:-1] < found[2:]) & (found[1:-1] < 0.1))
    return search, path.curve(), (GRID[k], GRID[k + 2]), GRID[k + 1], found[k + 1, pairs], pairs


def without_kernel(search, monkeypatch):
    """The same search by NumPy."""
    monkeypatch.setattr(look, "_calls", lambda: None)
    return DistanceSearch(model=search.model)


def test_compiled_code_and_numpy_find_the_same_bottoms(dips, monkeypatch):
    search, *where = dips
    compiled = search.bottoms(*where)
    assert search._compiled is not None, "without compiled code this test compares nothing"
    assert compiled[1].min() < -0.01 and compiled[1].max() > 0.0  # also depths
    for one, other in zip(compiled, without_kernel(search, monkeypatch).bottoms(*where), strict=True):
        np.testing.assert_array_equal(one, other)


def same(one, other):
    for name in ("s", "pairs", "is_bottom"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
    np.testing.assert_allclose(one.distances, other.distances, rtol=0, atol=1e-11)


@pytest.mark.parametrize("band", [2e-3, 0.02, 0.1])
@pytest.mark.parametrize("target", [0.0, 0.01])
def test_compiled_code_and_numpy_look_at_the_same_places(dips, monkeypatch, band, target):
    search, curve, *_ = dips
    pairs = np.unique(dips[-1])[:2].tolist()
    known = [(0.0, pairs[0]), (0.3777, pairs[-1]), (1.0, pairs[0])]
    found = search.look(curve, target, band, known)
    assert found.is_bottom.any() and not found.is_bottom.all()
    assert (np.diff(found.distances) >= 0).all() and found.least == found.distances[0]
    same(found, without_kernel(search, monkeypatch).look(curve, target, band, known))


def test_a_look_has_every_place_that_is_near(dips):
    """Against the distances of all pairs at all places of the grid."""
    search, curve, *_ = dips
    found = search.look(curve, 0.01, 0.05)
    s = np.linspace(0.0, 1.0, INTERVALS + 1)
    distances = search.model.distance_rows(curve(s))
    row, pair = np.nonzero(distances < 0.01 + CLOSE)
    wide, other = np.nonzero(distances[::SPACING] < 0.01 + 0.05)
    wanted = {(s[k], p) for k, p in zip(row, pair, strict=True)} | {
        (s[SPACING * k], p) for k, p in zip(wide, other, strict=True)
    }
    on_grid = ~found.is_bottom
    assert set(zip(found.s[on_grid], found.pairs[on_grid], strict=True)) == wanted
    assert len(wanted) > 20


def test_a_look_finds_room_for_many_near_places(panda, dips, monkeypatch):
    search, curve, *_ = dips
    whole = search.look(curve, 0.0, 0.1)
    monkeypatch.setattr(look, "ROOM", 1)
    known = [(0.5, int(dips[-1][0]))] * 50
    few = DistanceSearch(model=search.model)
    same(few.look(curve, 0.0, 0.1), whole)
    assert len(few.look(curve, 0.0, 0.1, known).s) == len(whole.s) + 50
    same(few.look(curve, 0.0, 0.1), whole)


def test_coal_is_asked_where_the_kernel_cannot_tell(dips, monkeypatch):
    """The kernel is made to say nothing of one pair."""
    search, curve, *_ = dips
    whole, near = search.look(curve, 0.0, 0.02), DistanceKernel.near
    pair = int(whole.pairs[0])

    def silent(kernel, q, reach):
        where, found = near(kernel, q, reach)
        found[where % kernel.pairs == pair] = np.nan
        return where, found

    monkeypatch.setattr(look._Compiled, "look", lambda *_: None)
    monkeypatch.setattr(DistanceKernel, "near", silent)
    asked = DistanceSearch(model=search.model).look(curve, 0.0, 0.02)
    assert len(asked.s) == len(whole.s)
    np.testing.assert_allclose(asked.distances, whole.distances, atol=1e-7)


def test_nothing_is_near_far_from_everything(panda, dips):
    free = DistanceSearch(model=mp.Scene([mp.Sphere(radius=0.01, position=(5.0, 0.0, 0.0))]).collision_model(panda))
    path = JointPath.line([0.0, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.01, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8])
    far = free.look(path.curve(), -0.02, 1e-3)
    assert len(far.s) == 0 and far.least == NOTHING.least == np.inf


def test_bottoms_are_the_nearest_places_of_their_brackets(dips):
    search, curve, bracket, middle, least, pairs = dips
    at, distances = search.bottoms(curve, bracket, middle, least, pairs)
    fine = np.linspace(*bracket, 201)
    for k, pair in enumerate(pairs):
        measured = search.distances(curve, fine[:, k], np.full(len(fine), pair))
        assert distances[k] <= measured.min() + 1e-4  # depths of overlaps have several minima
        assert distances[k] == pytest.approx(search.distances(curve, at[k : k + 1], pairs[k : k + 1])[0], abs=1e-9)
        if distances[k] > 0:
            assert np.abs(at[k] - fine[measured.argmin(), k]) <= fine[1, k] - fine[0, k] + BOTTOM


def test_no_bracket_gives_no_bottom(dips):
    search, curve, *_ = dips
    empty = np.empty(0)
    at, distances = search.bottoms(curve, (empty, empty), empty, empty, np.empty(0, dtype=np.intp))
    assert at.shape == distances.shape == (0,)
