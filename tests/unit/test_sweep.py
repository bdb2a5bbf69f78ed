"""Compiled kernels of the search by themselves: cells against NumPy, and LLVM's code against the compiler's."""

from itertools import pairwise

import numpy as np
import pytest

import manipplan as mp
from manipplan.search import sweep
from manipplan.search.sweep import choose_grid, largest_of_each, sorted_into_cells
from manipplan.support.kernels import kernel_by_llvm

TURNS = np.array([False, True, False, True])


def some_layers(rng, count=60):
    q = [np.cumsum(rng.uniform(-0.3, 0.3, (count, 4)), axis=0) for _ in range(6)]
    return q, [np.round(rng.uniform(0.1, 1.0, count), 2) for _ in q]


@pytest.mark.parametrize("share", [1.0, 0.5])
def test_candidates_sorted_by_cell(share, rng):
    q, m = rng.uniform(-3, 3, (5000, 4)), rng.uniform(size=5000)
    grid = choose_grid(q, np.array([q.min(axis=0), q.max(axis=0)]), np.full(4, 0.4), TURNS, 2000)
    assert grid.wraps.any() and (grid.count > 1).sum() > 1
    cells = sorted_into_cells(q, m, np.full(4, 0.4), 0.3, share, 0.9, grid)
    taken = np.sort(cells.ids)
    if share == 1:
        np.testing.assert_array_equal(taken, np.flatnonzero(m >= 0.3))
    else:
        assert 0.4 < len(taken) / (m >= 0.3).sum() < 0.6
        assert set(sorted_into_cells(q, m, np.full(4, 0.4), 0.3, 0.2, 0.9, grid).ids) <= set(taken)
    np.testing.assert_array_equal(cells.m, np.minimum(m[cells.ids], 0.9))
    np.testing.assert_array_equal(cells.rows, q[cells.ids][:, grid.order])
    x = q[taken][:, grid.joints]
    place = np.where(grid.wraps, (x / (2 * np.pi)) % 1.0 * grid.count, (x - grid.low) * grid.per).clip(0, grid.count - 1)
    cell = np.ravel_multi_index(place.astype(int).T, grid.count)
    np.testing.assert_array_equal(cells.start, np.searchsorted(np.sort(cell), np.arange(grid.cells + 1)))
    np.testing.assert_array_equal(cells.ids, taken[np.argsort(cell, kind="stable")])
    expected = [cells.m[a:b].max(initial=-np.inf) for a, b in pairwise(cells.start)]
    np.testing.assert_array_equal(largest_of_each(cells.start, cells.m), expected)


@pytest.fixture
def by_llvm(monkeypatch):
    engine = kernel_by_llvm("sweep")
    calls = engine.functions()

    def use():
        monkeypatch.setattr(sweep, "calls", lambda: calls)

    yield use
    monkeypatch.undo()
    del engine


def test_llvm_and_the_compiler_agree(by_llvm, rng):
    """The same paths, bit by bit, of every search."""
    q, m = some_layers(rng)
    layers = mp.Layers.from_arrays(q, m, continuous=TURNS)
    loop = mp.Layers.from_arrays(q, m, continuous=TURNS, closed=True)

    def everything():
        for prefer in ("first", "shortest", "lexicographic"):
            yield mp.max_min_search(layers, 1.0, prefer=prefer)
        yield mp.max_min_search(loop, 1.5, throw=False)
        yield mp.max_min_search(layers, 1e-3, throw=False)

    usual = list(everything())
    by_llvm()
    for one, other in zip(usual, everything(), strict=True):
        np.testing.assert_array_equal(one.indices, other.indices)
        np.testing.assert_array_equal(one.q, other.q)
        assert one.status is other.status
        np.testing.assert_array_equal(getattr(one, "smallest_epsilon", None), getattr(other, "smallest_epsilon", None))
    assert sum(len(each.indices) > 0 for each in usual) >= 4
