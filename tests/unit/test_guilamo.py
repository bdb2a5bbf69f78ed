"""The search of guilamo2006: its counts on cases small enough to follow by hand."""

import numpy as np
import pytest

import manipplan as mp
from manipplan.search.guilamo import guilamo_search
from manipplan.search.layers import Layers
from manipplan.search.max_min import max_min_search
from manipplan.support.status import Status


def layers(*each, **more):
    """Of (position, index) pairs, one joint."""
    return Layers.from_arrays([[[q] for q, _ in layer] for layer in each], [[m for _, m in layer] for layer in each], **more)


def test_one_start_suffices_where_the_bound_is_reached():
    each = layers([(0.0, 5.0), (9.0, 4.0)], [(0.1, 3.0), (0.2, 1.0)], [(0.2, 7.0)])
    result = guilamo_search(each, 0.5)
    assert result.start == (1, 0)  # the layer whose best is the least, its best candidate
    assert (result.new_starts, result.branches) == (1, 2)
    np.testing.assert_array_equal(result.indices, [0, 0, 0])
    assert (result.minimum, result.status) == (3.0, Status.PROVEN_OPTIMAL)
    assert result.status.ok


def test_the_next_start_has_the_next_lower_index_of_any_layer():
    each = layers([(0.0, 5.0), (9.0, 6.0)], [(8.0, 4.0), (0.1, 3.0)], [(0.2, 7.0), (0.3, 3.5)])
    result = guilamo_search(each, 0.5)
    # 4.0 has no continuous neighbour, 3.5 has one, of a lower index; 3.0 succeeds
    assert (result.new_starts, result.start) == (3, (1, 1))
    assert result.branches == 2
    np.testing.assert_array_equal(result.indices, [0, 1, 0])
    assert result.minimum == 3.0


def test_it_goes_back_where_the_best_candidate_leads_nowhere():
    each = layers([(0.0, 1.0)], [(0.1, 9.0), (-0.1, 8.0)], [(-0.3, 5.0)])
    result = guilamo_search(each, 0.25)
    np.testing.assert_array_equal(result.indices, [0, 1, 0])
    assert (result.new_starts, result.branches) == (1, 3)


def dead_end(width, length):
    """A lattice of good candidates that never reaches the last layer, and one bad path that does."""
    lattice = [(0.01 * k, 5.0) for k in range(width)]
    return layers([(0.0, 4.0)], *[[*lattice, (-0.1, 1.0)]] * length, [(-0.2, 9.0)])


def test_memory_saves_what_back_tracking_repeats():
    each = dead_end(3, 8)
    literal, memoised = (guilamo_search(each, 0.15, memoised=value) for value in (False, True))
    assert literal.minimum == memoised.minimum == max_min_search(each, 0.15).minimum == 1.0
    assert literal.new_starts == memoised.new_starts
    assert memoised.branches < each.count * memoised.new_starts
    assert literal.branches > 3**8


def test_it_gives_up_after_so_many_branches():
    each = dead_end(4, 30)
    result = guilamo_search(each, 0.15, most_branches=100_000, throw=False)
    assert result.status is Status.GAVE_UP
    assert result.branches == 100_000
    assert result.q.shape == (0, 1)
    assert (len(result.indices), result.minimum) == (0, -np.inf)
    with pytest.raises(mp.errors.PlanningError, match="max_min_search") as caught:
        guilamo_search(each, 0.15, most_branches=0)
    assert caught.value.result.branches == 0
    assert guilamo_search(each, 0.15, memoised=True).status.ok


def test_every_candidate_up_to_the_bound_is_a_start_where_nothing_connects():
    each = layers([(0.0, 5.0), (0.1, 2.0)], [(9.0, 4.0), (9.1, 4.0)])
    result = guilamo_search(each, 0.5, throw=False)
    assert result.status is Status.NOT_CONNECTED
    assert (result.new_starts, result.branches) == (3, 0)
    with pytest.raises(mp.errors.PlanningError, match="take a larger epsilon"):
        guilamo_search(each, 0.5)


def test_an_equal_index_of_another_candidate_is_a_start_too():
    each = layers([(0.0, 3.0), (5.0, 3.0)], [(5.1, 9.0)])
    result = guilamo_search(each, 0.5)
    assert (result.start, result.new_starts) == ((0, 1), 2)


def test_a_joint_that_turns_without_end():
    each = layers([(3.1, 1.0)], [(-3.1, 1.0)], [(-2.9, 1.0)], continuous=[True])
    np.testing.assert_allclose(np.diff(guilamo_search(each, 0.3).q[:, 0]), [2 * np.pi - 6.2, 0.2])


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"epsilon": 0.0}, "above zero"),
        ({"epsilon": 1.0, "memoised": 1}, "memoised"),
        ({"epsilon": 1.0, "most_branches": -1}, "most_branches"),
        ({"epsilon": 1.0, "most_branches": 1.5}, "most_branches"),
    ],
)
def test_bad_arguments_are_told(arguments, words):
    with pytest.raises(mp.errors.InvalidInputError, match=words):
        guilamo_search(dead_end(1, 1), **arguments)


def test_closed_layers_are_refused():
    with pytest.raises(mp.errors.InvalidInputError, match="cycles"):
        guilamo_search(layers([(0.0, 1.0)], [(0.0, 1.0)], closed=True), 1.0)
