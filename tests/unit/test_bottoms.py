"""Bottoms of dips: compiled code and NumPy find the same ones, and no place of the bracket is nearer."""

import numpy as np
import pytest

import manipplan as mp
from manipplan.collision import bottoms
from manipplan.collision.bottoms import BOTTOM, DipSearch
from manipplan.paths.joint import JointPath

GRID = np.linspace(0.0, 1.0, 41)


@pytest.fixture(scope="module")
def dips(panda):
    """A path through a post, and every bracket of the grid in which a pair nearer than 0.1 m has a dip."""
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post")])
    path = JointPath.line([-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8])
    search = DipSearch(model=scene.collision_model(panda))
    found = search.model.distance_rows(path(GRID))
    k, pairs = np.nonzero((found[1:-1] <= found[:-2]) & (found[1:-1] < found[2:]) & (found[1:-1] < 0.1))
    return search, path, (GRID[k], GRID[k + 2]), GRID[k + 1], found[k + 1, pairs], pairs


def test_compiled_code_and_numpy_find_the_same_bottoms(dips, monkeypatch):
    search, *where = dips
    compiled = search.bottoms(*where)
    assert bottoms._narrow() is not None, "without compiled code this test compares nothing"
    assert compiled[1].min() < -0.01 and compiled[1].max() > 0.0  # also where only Coal can tell the depth
    monkeypatch.setattr(bottoms, "_narrow", lambda: None)
    for one, other in zip(compiled, search.bottoms(*where), strict=True):
        np.testing.assert_array_equal(one, other)


def test_bottoms_are_the_nearest_places_of_their_brackets(dips):
    search, path, bracket, middle, least, pairs = dips
    at, distances = search.bottoms(path, bracket, middle, least, pairs)
    fine = np.linspace(*bracket, 201)
    for k, pair in enumerate(pairs):
        measured = search.distances(path, fine[:, k], np.full(len(fine), pair))
        assert distances[k] <= measured.min() + 1e-4  # depths of overlaps have several minima
        assert distances[k] == pytest.approx(search.distances(path, at[k : k + 1], pairs[k : k + 1])[0], abs=1e-9)
        if distances[k] > 0:
            assert np.abs(at[k] - fine[measured.argmin(), k]) <= fine[1, k] - fine[0, k] + BOTTOM


def test_no_bracket_gives_no_bottom(dips):
    search, path, *_ = dips
    empty = np.empty(0)
    at, distances = search.bottoms(path, (empty, empty), empty, empty, np.empty(0, dtype=np.intp))
    assert at.shape == distances.shape == (0,)
