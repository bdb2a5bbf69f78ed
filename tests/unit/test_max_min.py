"""Layers and the exact search on cases made by hand: arguments, degenerate layers, what is told on failure."""

import pickle
import subprocess
import sys
from itertools import pairwise

import numpy as np
import pytest

import manipplan as mp
from manipplan.search.layers import Layers
from manipplan.search.max_min import SearchResult, max_min_search
from manipplan.support.status import Status

LINE = ([[[0.0]], [[0.1], [0.5]], [[0.2]]], [[3.0], [2.0, 9.0], [4.0]])


def layers(*each, m=None, **more):
    q = [np.array(layer, dtype=float).reshape(len(layer), -1) for layer in each]
    return Layers.from_arrays(q, m or [np.ones(len(layer)) for layer in q], **more)


@pytest.mark.parametrize(
    ("q", "m", "words"),
    [
        ([[[0.0]]], [[1.0]], "at least two layers"),
        ([[[0.0]], np.empty((0, 1))], [[1.0], []], r"q\[1\].*no candidate"),
        ([[[0.0]], [[0.0, 1.0]]], [[1.0], [1.0]], r"q\[1\].*the width of q\[0\]"),
        ([[[0.0]], [0.0]], [[1.0], [1.0]], r"q\[1\].*shape \(k, n\)"),
        ([[[0.0]], [[0.0]]], [[1.0], [1.0, 2.0]], r"m\[1\].*one per candidate"),
        ([[[0.0]], [[0.0]]], [[1.0]], "m: .*as many layers as q: 2"),
        ([[[0.0]], [[np.nan]]], [[1.0], [1.0]], r"q\[1\].*NaN"),
        ([[[0.0]], [[np.inf]]], [[1.0], [1.0]], r"q\[1\].*inf"),
        ([[[0.0]], [[1e200]]], [[1.0], [1.0]], r"q\[1\].*too large"),
        ([[[0.0]], [[0.0]]], [[1.0], [-np.inf]], r"m\[1\].*finite"),
        ([[[0.0]], [[0.0]]], [[np.nan], [1.0]], r"m\[0\].*finite"),
        ([[["a"]], [[0.0]]], [[1.0], [1.0]], r"q\[0\].*real numbers"),
        (None, [[1.0]], "a list of arrays"),
        ([np.empty((1, 0)), np.empty((1, 0))], [[1.0], [1.0]], "n at least 1"),
    ],
)
def test_bad_layers_are_named(q, m, words):
    with pytest.raises(mp.errors.InvalidInputError, match=words):
        Layers.from_arrays(q, m)


def test_layers_take_arrays_without_a_copy():
    q = [np.zeros((1000, 7)), np.zeros((2000, 7))]
    m = [np.ones(1000), np.arange(2000.0)]
    each = Layers.from_arrays(q, m, continuous=np.ones(7, dtype=bool))
    assert all(a is b or np.shares_memory(a, b) for a, b in zip(q + m, each.q + each.m, strict=True))
    assert q[0].flags.writeable
    assert (each.n, each.count, list(each.sizes), each.bound, each.nbytes) == (7, 3000, [1000, 2000], 1.0, 8 * 8 * 3000)
    assert pickle.loads(pickle.dumps(each)).count == 3000


def test_layers_take_lists_and_other_numbers():
    each = Layers.from_arrays(
        [[[1, 2]], np.ones((3, 2), dtype=np.float32), np.asfortranarray(np.ones((2, 2)))], [[1], [1] * 3, [2, 3]]
    )
    assert all(layer.dtype == np.float64 and layer.flags.c_contiguous for layer in each.q)


@pytest.mark.parametrize("continuous", [[True], True, [0, 1], "no"])
def test_bad_continuous_is_told(continuous):
    with pytest.raises(mp.errors.InvalidInputError, match="continuous"):
        Layers.from_arrays([[[0.0, 0.0]], [[0.0, 0.0]]], [[1.0], [1.0]], continuous=continuous)


def test_extent_of_all_sizes_of_layers():
    rng = np.random.default_rng(0)
    for size in (1, 2, 63, 64, 65, 640, 1000):
        q = rng.normal(size=(size, 3))
        each = Layers.from_arrays([q, q[:1]], [np.ones(size), [1.0]])
        np.testing.assert_array_equal(each.extent, [q.min(axis=0), q.max(axis=0)])


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"epsilon": 0}, "above zero"),
        ({"epsilon": -1.0}, "above zero"),
        ({"epsilon": np.nan}, "above zero"),
        ({"epsilon": np.inf}, "finite"),
        ({"epsilon": [0.1, 0.2]}, "one number or 1 of them"),
        ({"epsilon": "far"}, "real numbers"),
        ({"epsilon": 0.1, "prefer": "shortes"}, "did you mean shortest"),
        ({"epsilon": 0.1, "prefer": None}, "prefer"),
        ({"epsilon": 0.1, "strict": "yes"}, "strict"),
        ({"epsilon": 0.1, "anytime": 1}, "anytime"),
        ({"epsilon": 0.1, "throw": None}, "throw"),
        ({"epsilon": 0.1, "threads": 0}, "threads"),
        ({"epsilon": 0.1, "progress": 3}, "progress"),
    ],
)
def test_bad_arguments_are_told_at_once(arguments, words):
    with pytest.raises(mp.errors.InvalidInputError, match=words):
        max_min_search(Layers.from_arrays(*LINE), **{"anytime": True} | arguments)


def test_other_things_than_layers_are_told():
    with pytest.raises(mp.errors.InvalidInputError, match="a Layers"):
        max_min_search(LINE, 0.1)


def test_epsilon_of_a_joint_that_turns_without_end_is_below_pi():
    each = Layers.from_arrays(*LINE, continuous=[True])
    with pytest.raises(mp.errors.InvalidInputError, match="below π"):
        max_min_search(each, np.pi)


def test_result_of_a_line():
    result = max_min_search(Layers.from_arrays(*LINE), 0.2)
    assert isinstance(result, SearchResult)
    np.testing.assert_array_equal(result.q[:, 0], [0.0, 0.1, 0.2])
    np.testing.assert_array_equal(result.indices, [0, 0, 0])
    np.testing.assert_array_equal(result.manipulability, [3.0, 2.0, 4.0])
    assert (result.minimum, result.bound, result.gap, result.certified_gap) == (2.0, 3.0, 1.0, 0.0)
    assert result.status is Status.PROVEN_OPTIMAL
    assert result.status.ok
    assert result.connected
    assert (result.breaks_at, result.smallest_epsilon) == (None, None)
    assert result.length == pytest.approx(0.2)
    assert (result.nodes, result.rounds, result.closed, result.strict) == (4, 2, False, True)
    assert "minimum 2" in result.message


def test_a_step_of_exactly_epsilon():
    each = layers([0.0], [0.5], [1.0])
    assert not max_min_search(each, 0.5, throw=False).connected
    assert max_min_search(each, 0.5, strict=False).connected
    assert max_min_search(each, np.nextafter(0.5, 1)).connected


def test_a_joint_that_turns_without_end_goes_on():
    angles = np.linspace(0, 4 * np.pi, 41)
    wrapped = (angles + np.pi) % (2 * np.pi) - np.pi
    each = layers(*[[a] for a in wrapped], continuous=[True])
    result = max_min_search(each, 0.32)
    np.testing.assert_allclose(np.diff(result.q[:, 0]), np.pi / 10)
    assert not max_min_search(layers(*[[a] for a in wrapped]), 0.32, throw=False).connected


@pytest.mark.parametrize("far", [1e3, 1e8, 1e12])
def test_angles_many_turns_away(far):
    turns = 2 * np.pi * np.round(far / (2 * np.pi))
    each = layers([0.0, 2.0], [turns + 0.05, turns + 1.0], [-turns, -turns + 2.1], continuous=[True])
    result = max_min_search(each, 0.5 if far < 1e10 else 0.6, prefer="first")
    assert list(result.indices) == [0, 0, 0]


def test_places_far_from_zero_keep_their_steps():
    rng = np.random.default_rng(0)
    q = [1e9 + rng.uniform(0, 1, (50, 2)).round(3) for _ in range(4)]
    each = Layers.from_arrays(q, [rng.random(50) for _ in q])
    steps = [np.abs(b[None] - a[:, None]).max(-1) for a, b in pairwise(q)]
    value = each.m[0]
    for size, m in zip(steps, each.m[1:], strict=True):
        value = np.minimum(m, np.where(size < 0.1, value[:, None], -np.inf).max(0))
    assert max_min_search(each, 0.1, prefer="first").minimum == value.max()


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("prefer", ["first", "shortest", "lexicographic"])
def test_degenerate_layers(prefer, closed):
    rng = np.random.default_rng(0)
    one = layers([[0.1, 0.2]], [[0.1, 0.2]], closed=closed)
    assert max_min_search(one, 1e-300, prefer=prefer).minimum == 1.0
    assert max_min_search(one, 1e9, prefer=prefer).minimum == 1.0
    same = layers(*[np.zeros((300, 2))] * 5, closed=closed)
    assert max_min_search(same, 1e-12, prefer=prefer).length == 0.0
    uneven = layers([0.0], rng.uniform(-1, 1, 5000), [0.0], rng.uniform(-1, 1, 3), closed=closed)
    assert max_min_search(uneven, 1.5, prefer=prefer).minimum == 1.0
    negative = layers([0.0, 0.1], [0.0, 0.1], m=[[-5.0, -3.0], [-4.0, -1.0]], closed=closed)
    assert max_min_search(negative, 1.0, prefer=prefer).minimum == -3.0
    zeros = layers([0.0, 0.1], [0.0], m=[[0.0, -0.0], [-0.0]], closed=closed)
    assert max_min_search(zeros, 1.0, prefer=prefer).minimum == 0.0


def test_the_shortest_of_many_equal_paths():
    rng = np.random.default_rng(1)
    q = [rng.uniform(-1, 1, (400, 2)) for _ in range(20)]
    each = Layers.from_arrays(q, [np.ones(400)] * 20)
    first, shortest = (max_min_search(each, 0.5, prefer=prefer) for prefer in ("first", "shortest"))
    assert first.minimum == shortest.minimum == 1.0
    assert shortest.length < 0.8 * first.length


def test_lexicographic_lifts_what_is_above_the_minimum():
    each = layers([0.0], [0.0, 0.1], [0.0], [0.0, 0.2], m=[[1.0], [2.0, 3.0], [9.0], [8.0, 7.0]])
    shortest = max_min_search(each, 1.0)
    best = max_min_search(each, 1.0, prefer="lexicographic")
    assert shortest.minimum == best.minimum == 1.0
    np.testing.assert_array_equal(np.sort(best.manipulability), [1.0, 3.0, 8.0, 9.0])
    assert shortest.length < best.length


def test_a_cycle_ends_where_it_begins():
    """Ends that drift apart: the open path has the higher index, the cycle has to come back."""
    drift = np.linspace(0, 1, 6)
    q = [[[d], [0.0]] for d in drift]
    m = [[5.0, 1.0]] * 6
    assert max_min_search(Layers.from_arrays(q, m), 0.3).minimum == 5.0
    cycle = max_min_search(Layers.from_arrays(q, m, closed=True), 0.3)
    assert cycle.minimum == 1.0
    assert abs(cycle.q[-1, 0] - cycle.q[0, 0]) < 0.3


def test_a_gap_is_told_with_the_epsilon_that_closes_it():
    each = layers([[0.0, 0.0], [5.0, 5.0]], [[0.1, 0.2]], [[0.4, 0.9], [-0.3, 0.8]], [[0.4, 0.9]])
    with pytest.raises(mp.errors.PlanningError, match="no candidate of position 2 can be reached from position 1") as caught:
        max_min_search(each, [0.2, 0.4])
    result = caught.value.result
    assert result.status is Status.NOT_CONNECTED
    assert not result.status.ok
    assert result.breaks_at == 2
    np.testing.assert_allclose(result.smallest_epsilon, 1.75 * np.array([0.2, 0.4]))
    assert "1.75 times epsilon" in str(caught.value)
    assert (result.minimum, result.gap, result.length) == (-np.inf, np.inf, np.inf)
    assert result.q.shape == (0, 2)
    assert result.bound == 1.0
    with pytest.raises(mp.errors.PlanningError):
        max_min_search(each, result.smallest_epsilon)
    assert max_min_search(each, result.smallest_epsilon, strict=False).connected
    copy = pickle.loads(pickle.dumps(caught.value))
    assert copy.result.breaks_at == 2


def test_a_cycle_that_does_not_close_is_told():
    each = layers([0.0], [0.2], [0.4], [0.6], closed=True)
    result = max_min_search(each, 0.3, throw=False)
    assert result.breaks_at == 0
    np.testing.assert_allclose(result.smallest_epsilon, [0.6])
    assert "no path closes" in result.message


@pytest.mark.parametrize("size", [1e-9, 1e-3, 1e9])
def test_the_smallest_epsilon_of_any_size(size):
    rng = np.random.default_rng(2)
    q = [size * rng.uniform(-1, 1, (30, 3)) for _ in range(5)]
    each = Layers.from_arrays(q, [np.ones(30)] * 5)
    result = max_min_search(each, size * 1e-4, throw=False)
    assert not result.connected
    assert max_min_search(each, result.smallest_epsilon, strict=False).connected
    assert not max_min_search(each, result.smallest_epsilon, throw=False).connected


def test_progress_only_rises_and_ends_at_one():
    rng = np.random.default_rng(3)
    q = [rng.uniform(-1, 1, (20000, 3)) for _ in range(10)]
    each = Layers.from_arrays(q, [rng.random(20000) for _ in q])
    told = []
    max_min_search(each, 0.2, progress=lambda done, text: told.append((done, text)))
    shares = [done for done, _ in told]
    assert shares == sorted(shares)
    assert shares[0] == 0.0
    assert shares[-1] == 1.0
    assert all(isinstance(text, str) and text for _, text in told)


def test_anytime_tells_its_first_path_before_the_last():
    rng = np.random.default_rng(4)
    q = [np.column_stack([rng.uniform(0, 6, 8000), np.full(8000, 0.1 * i)]) for i in range(30)]
    m = [np.cos(each[:, 0] - 0.5 * i) for i, each in enumerate(q)]
    each = Layers.from_arrays(q, m)
    results = list(max_min_search(each, 0.15, prefer="first", anytime=True))
    exact = max_min_search(each, 0.15, prefer="first")
    assert len(results) > 2
    assert any(result.connected for result in results[:-1])
    assert results[-1].minimum == exact.minimum == results[-1].certified_bound
    assert results[-1].status is Status.PROVEN_OPTIMAL
    minima = [result.minimum for result in results]
    assert minima == sorted(minima)
    iterator = max_min_search(each, 0.15, anytime=True)
    next(iterator)
    iterator.close()  # an early stop leaves no thread behind


def test_anytime_raises_at_its_end():
    each = layers([0.0], [1.0])
    with pytest.raises(mp.errors.PlanningError):
        list(max_min_search(each, 0.5, anytime=True))


@pytest.mark.slow
def test_neither_the_package_nor_the_search_brings_llvm_when_imported():
    code = "import sys, manipplan, manipplan.search.max_min; print('llvmlite' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "False"
