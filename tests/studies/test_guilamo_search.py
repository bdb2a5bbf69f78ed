"""The search of guilamo2006: its counts on cases small enough to follow by hand, and its optimum beside brute force."""

import layered
import numpy as np
import pytest

import manipplan as mp
from studies.guilamo2006.search import search


def layers(*each, **more):
    """Of (position, index) pairs, one joint."""
    return mp.Layers.from_arrays([[[q] for q, _ in layer] for layer in each], [[m for _, m in layer] for layer in each], **more)


def test_one_start_suffices_where_the_bound_is_reached():
    each = layers([(0.0, 5.0), (9.0, 4.0)], [(0.1, 3.0), (0.2, 1.0)], [(0.2, 7.0)])
    result = search(each, 0.5, memoised=False)
    assert result.start == (1, 0)  # the layer whose best is the least, its best candidate
    assert (result.new_starts, result.branches) == (1, 2)
    assert result.indices == [0, 0, 0]
    assert (result.minimum, result.end) == (3.0, "found")
    np.testing.assert_array_equal(result.manipulability, [5.0, 3.0, 7.0])


def test_the_next_start_has_the_next_lower_index_of_any_layer():
    each = layers([(0.0, 5.0), (9.0, 6.0)], [(8.0, 4.0), (0.1, 3.0)], [(0.2, 7.0), (0.3, 3.5)])
    result = search(each, 0.5, memoised=False)
    # 4.0 has no continuous neighbour, 3.5 has one, of a lower index; 3.0 succeeds
    assert (result.new_starts, result.start) == (3, (1, 1))
    assert (result.branches, result.comparisons) == (2, 5)
    assert result.indices == [0, 1, 0]
    assert result.minimum == 3.0


def test_it_goes_back_where_the_best_candidate_leads_nowhere():
    each = layers([(0.0, 1.0)], [(0.1, 9.0), (-0.1, 8.0)], [(-0.3, 5.0)])
    result = search(each, 0.25, memoised=False)
    assert result.indices == [0, 1, 0]
    assert (result.new_starts, result.branches, result.comparisons) == (1, 3, 4)


def dead_end(width, length):
    """A lattice of good candidates that never reaches the last layer, and one bad path that does."""
    lattice = [(0.01 * k, 5.0) for k in range(width)]
    return layers([(0.0, 4.0)], *[[*lattice, (-0.1, 1.0)]] * length, [(-0.2, 9.0)])


def test_memory_saves_what_back_tracking_repeats():
    each = dead_end(3, 8)
    literal, memoised = (search(each, 0.15, memoised=value) for value in (False, True))
    assert literal.minimum == memoised.minimum == mp.max_min_search(each, 0.15).minimum == 1.0
    assert literal.new_starts == memoised.new_starts
    assert memoised.branches < each.count * memoised.new_starts
    assert memoised.comparisons < literal.comparisons
    assert literal.branches > 3**8


def test_it_gives_up_after_so_many_branches():
    each = dead_end(4, 30)
    result = search(each, 0.15, memoised=False, most_branches=100_000)
    assert (result.end, result.branches, result.indices, result.minimum) == ("gave up", 100_000, [], -np.inf)
    assert search(each, 0.15, memoised=False, most_branches=0).branches == 0
    assert search(each, 0.15, memoised=True).end == "found"


def test_every_candidate_up_to_the_bound_is_a_start_where_nothing_connects():
    each = layers([(0.0, 5.0), (0.1, 2.0)], [(9.0, 4.0), (9.1, 4.0)])
    result = search(each, 0.5, memoised=False)
    assert (result.end, result.new_starts, result.branches) == ("not connected", 3, 0)


def test_an_equal_index_of_another_candidate_is_a_start_too():
    each = layers([(0.0, 3.0), (5.0, 3.0)], [(5.1, 9.0)])
    result = search(each, 0.5, memoised=False)
    assert (result.start, result.new_starts) == ((0, 1), 2)


def test_a_joint_that_turns_without_end():
    each = layers([(3.1, 1.0)], [(-3.1, 1.0)], [(-2.9, 1.0)], continuous=[True])
    assert search(each, 0.3, memoised=False).end == "found"
    assert search(layers([(3.1, 1.0)], [(-3.1, 1.0)], continuous=[False]), 0.3, memoised=False).end == "not connected"


@pytest.mark.parametrize("memoised", [False, True])
def test_its_optimum_is_that_of_all_pairs(memoised):
    rng = np.random.default_rng(7)
    for _ in range(500):
        each, epsilon = layered.random_layers(rng, most=12, positions=5)
        epsilon = float(np.max(epsilon))
        expected = layered.widest(each, epsilon, True)
        result = search(each, epsilon, memoised=memoised)
        assert result.minimum == expected
        assert (result.end == "found") == (expected > -np.inf)
        if result.end == "found":
            assert (np.abs(layered.path_steps(each, tuple(result.indices))) < epsilon).all()
            layer, candidate = result.start
            assert result.indices[layer] == candidate
            assert each.m[layer][candidate] == result.minimum
