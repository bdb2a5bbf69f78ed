"""The exact search against brute force on a thousand random layered graphs, and laws that hold for all of them."""

from dataclasses import replace
from itertools import combinations, pairwise, product

import layered
import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

from manipplan.search import max_min, sweep
from manipplan.search.interruptions import fewest_interruptions, find_gaps
from manipplan.search.layers import Layers
from manipplan.search.max_min import max_min_search, minimum_from_each, path_above, search_within
from manipplan.support.errors import PlanningError
from manipplan.support.progress import silent
from manipplan.support.status import Status

GRAPHS = 1000


def check_path(layers, epsilon, strict, result):
    """The path is what the result says it is, and it is continuous."""
    path = tuple(result.indices)
    size = np.abs(layered.path_steps(layers, path))
    assert ((size < epsilon) if strict else (size <= epsilon)).all()
    values = layered.indices_along(layers, path)
    np.testing.assert_array_equal(result.manipulability, values)
    assert result.minimum == values.min()
    np.testing.assert_allclose(result.length, layered.length(layers, path), rtol=1e-12, atol=1e-12)
    taken = np.array([layers.q[i][k] for i, k in enumerate(path)])
    np.testing.assert_array_equal(result.q[:, ~layers.continuous], taken[:, ~layers.continuous])
    turned = (result.q - taken)[:, layers.continuous] / (2 * np.pi)
    np.testing.assert_allclose(turned, np.round(turned), atol=1e-9)
    assert (np.abs(np.diff(result.q, axis=0)) <= epsilon + 1e-9).all()


@pytest.fixture(params=["as it is", "with samples"])
def forced(request, monkeypatch):
    """Rounds and samples are for large layers: with other constants small ones go through them, too."""
    if request.param != "as it is":
        monkeypatch.setattr(max_min, "FIRST", 4)
        monkeypatch.setattr("manipplan.search.max_min.FIRST", 4)
        monkeypatch.setattr("manipplan.search.max_min.TOP", 0.3)
        monkeypatch.setattr(sweep, "LEAST", 1)
    return request.param != "as it is"


@pytest.mark.slow
@pytest.mark.parametrize("closed", [False, True])
def test_optimum_is_that_of_brute_force(closed, forced):
    rng = np.random.default_rng(1 + closed)
    connected = 0
    for _ in range(GRAPHS // 2):
        layers, epsilon = layered.random_layers(rng, closed=closed)
        strict = bool(rng.random() < 0.5)
        result = max_min_search(layers, epsilon, strict=strict, prefer="first", throw=False)
        assert result.minimum == layered.widest(layers, epsilon, strict)
        assert result.connected == result.status.ok == (result.breaks_at is None)
        if result.connected:
            connected += 1
            assert result.minimum == result.certified_bound <= result.bound == layers.bound
            check_path(layers, epsilon, strict, result)
    assert GRAPHS / 10 < connected < GRAPHS / 2


@pytest.mark.slow
@pytest.mark.parametrize("closed", [False, True])
def test_preferred_paths_are_those_of_brute_force(closed):
    rng = np.random.default_rng(3 + closed)
    compared = 0
    while compared < 100:
        layers, epsilon = layered.random_layers(rng, closed=closed, most=5, positions=5)
        strict = bool(rng.random() < 0.5)
        all_paths = list(layered.paths(layers, epsilon, strict))
        if len(all_paths) < 2:
            continue
        compared += 1
        vectors = {path: np.sort(layered.indices_along(layers, path)) for path in all_paths}
        highest = max(vector[0] for vector in vectors.values())
        best = [path for path in all_paths if vectors[path][0] == highest]
        shortest = max_min_search(layers, epsilon, strict=strict)
        check_path(layers, epsilon, strict, shortest)
        assert shortest.minimum == highest
        np.testing.assert_allclose(shortest.length, min(layered.length(layers, path) for path in best), rtol=1e-12, atol=1e-12)
        found = max_min_search(layers, epsilon, strict=strict, prefer="lexicographic")
        check_path(layers, epsilon, strict, found)
        wanted = max(tuple(vectors[path]) for path in best)
        assert tuple(np.sort(found.manipulability)) == wanted
        ties = [path for path in best if tuple(vectors[path]) == wanted]
        np.testing.assert_allclose(found.length, min(layered.length(layers, path) for path in ties), rtol=1e-12, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("closed", [False, True])
def test_smallest_epsilon_is_that_of_brute_force(closed):
    rng = np.random.default_rng(5 + closed)
    compared = 0
    while compared < 50:
        layers, epsilon = layered.random_layers(rng, closed=closed, most=4, positions=5)
        epsilon = np.asarray(epsilon) * rng.uniform(0.001, 0.5)
        result = max_min_search(layers, epsilon, throw=False)
        if result.connected:
            continue
        factor = layered.least_factor(layers, epsilon)
        if factor == 1.0:
            continue
        compared += 1
        np.testing.assert_allclose(result.smallest_epsilon, factor * result.epsilon, rtol=1e-12)
        if (result.smallest_epsilon[layers.continuous] < np.pi).all():
            assert max_min_search(layers, result.smallest_epsilon, strict=False).connected
            assert not max_min_search(layers, result.smallest_epsilon * (1 - 1e-9), throw=False).connected
            assert max_min_search(layers, np.nextafter(result.smallest_epsilon, np.inf), throw=False).connected
        reached = 0
        while reached + 1 < len(layers.q) and reaches(layers, reached + 1, epsilon):
            reached += 1
        assert result.breaks_at == (reached + 1) % len(layers.q)


def reaches(layers, position, epsilon):
    here = np.ones(len(layers.q[0]), dtype=bool)
    for i in range(position):
        here = (layered.neighbours(layers, i, i + 1, epsilon, True) & here[:, None]).any(0)
    return here.any()


@pytest.mark.slow
@pytest.mark.parametrize("closed", [False, True])
def test_anytime_results_close_in_on_the_optimum(closed, forced):
    rng = np.random.default_rng(9 + closed)
    steps = 0
    for _ in range(100):
        layers, epsilon = layered.random_layers(rng, closed=closed)
        results = list(max_min_search(layers, epsilon, anytime=True, throw=False))
        optimum = layered.widest(layers, epsilon, True)
        assert results[-1].minimum == optimum
        for result in results:
            assert result.minimum <= optimum <= max(result.certified_bound, optimum if result is results[-1] else -np.inf)
            assert result.connected == (len(result.q) > 0)
        for before, after in pairwise(results):
            assert before.status is Status.IMPROVING
            assert after.minimum >= before.minimum or after.status is Status.NOT_CONNECTED
            assert after.certified_bound <= before.certified_bound
        steps += len(results) - 1
    assert steps > 0 or not forced


@pytest.mark.slow
@examples(30)
@given(st.integers(0, 2**32 - 1))
def test_threads_do_not_change_the_optimum(seed):
    rng = np.random.default_rng(seed)
    layers, epsilon = layered.random_layers(rng)
    more = Layers.from_arrays([np.tile(q, (400, 1)) for q in layers.q], [np.tile(m, 400) for m in layers.m])
    one = max_min_search(more, epsilon, prefer="first", throw=False, threads=1)
    two = max_min_search(more, epsilon, prefer="first", throw=False, threads=2)
    assert one.minimum == two.minimum
    np.testing.assert_array_equal(one.indices, two.indices)


@examples(50)
@given(st.integers(0, 2**32 - 1), st.booleans())
def test_a_higher_epsilon_never_makes_it_worse_and_a_scaled_index_scales_it(seed, closed):
    rng = np.random.default_rng(seed)
    layers, epsilon = layered.random_layers(rng, closed=closed)
    before = max_min_search(layers, epsilon, prefer="first", throw=False)
    more = max_min_search(layers, np.minimum(1.2 * np.asarray(epsilon), 3.1), prefer="first", throw=False)
    assert more.minimum >= before.minimum
    scaled = Layers.from_arrays(layers.q, [4 * m for m in layers.m], continuous=layers.continuous, closed=closed)
    assert max_min_search(scaled, epsilon, prefer="first", throw=False).minimum == 4 * before.minimum


@examples(30)
@given(st.integers(0, 2**32 - 1), st.integers(1, 5))
def test_a_cycle_does_not_depend_on_where_it_begins(seed, shift):
    rng = np.random.default_rng(seed)
    layers, epsilon = layered.random_layers(rng, closed=True)
    shift %= len(layers.q)
    turned = Layers.from_arrays(
        layers.q[shift:] + layers.q[:shift], layers.m[shift:] + layers.m[:shift], continuous=layers.continuous, closed=True
    )
    first, second = (max_min_search(each, epsilon, throw=False) for each in (layers, turned))
    assert first.minimum == second.minimum
    np.testing.assert_allclose(first.length, second.length, rtol=1e-12)


def best_cuts(layers, epsilon, strict):
    """By brute force: the number of the fewest parts and their largest minimum manipulability; None where a step has no path."""
    count = len(layers.q)
    ends = 2 * count if layers.closed else count
    values = {}
    for first, last in combinations(range(ends), 2):
        if last - first <= count:
            turned = [k % count for k in range(first, last + 1)]
            some = Layers.from_arrays(
                [layers.q[k] for k in turned], [layers.m[k] for k in turned], continuous=layers.continuous
            )
            values[first, last] = layered.widest(some, epsilon, strict)
    found = []
    for begin in range(count if layers.closed else 1):
        end = begin + count if layers.closed else count - 1
        best = {begin: (0, -np.inf)}  # the number of parts, and minus their minimum
        for last in range(begin + 1, end + 1):
            ways = [
                (best[first][0] + 1, max(best[first][1], -values[first, last]))
                for first in range(begin, last)
                if first in best and values[first, last] > -np.inf
            ]
            if ways:
                best[last] = min(ways)
        if end in best:
            found.append(best[end])
    return min(found) if found else None


@pytest.mark.slow
@pytest.mark.parametrize("closed", [False, True])
def test_fewest_interruptions_are_those_of_brute_force(closed):
    rng = np.random.default_rng(11 + closed)
    interrupted = none = 0
    for _ in range(400):
        layers, epsilon = layered.random_layers(rng, closed=closed, most=4, positions=7)
        strict = bool(rng.random() < 0.5)
        wanted = best_cuts(layers, epsilon, strict)
        if wanted is None:
            none += 1
            with pytest.raises(PlanningError, match="no interruption helps"):
                fewest_interruptions(layers, epsilon, strict=strict)
            continue
        found = fewest_interruptions(layers, epsilon, strict=strict)
        assert (found.parts, found.minimum) == (wanted[0], -wanted[1])
        interrupted += found.parts > 1
        count = len(layers.q)
        assert len({found.edges, *found.others}) == 1 + len(found.others)
        for edges in (found.edges, *found.others):
            assert len(edges) == len(found.edges) and edges[-1] - edges[0] == (count if closed else count - 1)
            values = []
            for first, last in pairwise(edges):
                turned = [k % count for k in range(first, last + 1)]
                some = Layers.from_arrays(
                    [layers.q[k] for k in turned], [layers.m[k] for k in turned], continuous=layers.continuous
                )
                values.append(layered.widest(some, epsilon, strict))
            assert min(values) == found.minimum
    assert interrupted > 5 and none > 20


def test_all_places_for_an_interruption_are_offered_from_the_middle_out():
    """One branch leads from position 0 to 5, the other from 3 to 8."""
    branches = [[k <= 5, k >= 3] for k in range(9)]
    q = [np.array([[0.0], [1.0]])[each] for each in branches]
    layers = Layers.from_arrays(q, [np.ones(len(each)) for each in q])
    found = fewest_interruptions(layers, 0.5)
    assert found.edges == (0, 4, 8) and found.minimum == 1.0
    assert set(found.others) == {(0, 3, 8), (0, 5, 8)}


@pytest.mark.slow
def test_the_minimum_from_each_first_candidate_is_that_of_brute_force():
    rng = np.random.default_rng(11)
    reached = lost = 0
    for _ in range(GRAPHS // 5):
        layers, epsilon = layered.random_layers(rng)
        strict = bool(rng.random() < 0.5)
        best = layers.m[-1]
        for i in range(len(layers.q) - 2, -1, -1):
            edges = layered.neighbours(layers, i, i + 1, epsilon, strict)
            best = np.minimum(layers.m[i], np.where(edges, best, -np.inf).max(axis=1))
        found = minimum_from_each(layers, epsilon, strict=strict)
        np.testing.assert_array_equal(found, best)
        cap = float(np.median(layers.m[0]))
        np.testing.assert_array_equal(minimum_from_each(layers, epsilon, strict=strict, cap=cap), np.minimum(best, cap))
        reached += np.isfinite(best).sum()
        lost += np.isinf(best).sum()
    assert reached > 100 and lost > 100


@pytest.mark.slow
def test_gaps_are_where_the_way_from_the_start_ends_and_the_way_to_the_next_position_begins():
    rng, seen = np.random.default_rng(5), 0
    for _ in range(300):
        layers, epsilon = layered.random_layers(rng)
        found = find_gaps(layers, epsilon)
        assert bool(found.ranges) == (layered.widest(layers, epsilon, True) == -np.inf)
        if not found.ranges:
            assert found.parts == 1
            continue
        edges = [layered.neighbours(layers, i, i + 1, epsilon, True) for i in range(len(layers.q) - 1)]
        reached, last = np.ones(len(layers.q[0]), dtype=bool), 0
        while (reached := edges[last][reached].any(axis=0)).any():
            last += 1
        leading, begin = np.ones(len(layers.q[last + 1]), dtype=bool), last + 1
        while begin > 0 and (leading := edges[begin - 1][:, leading].any(axis=1)).any():
            begin -= 1
        assert found.ranges[0] == (max(begin - 1, 0), last + 1)
        seen += begin < last + 1
    assert seen > 10


@pytest.mark.slow
@pytest.mark.parametrize("closed", [False, True])
def test_paths_within_one_label_are_the_best_of_each_label_alone(closed):
    rng = np.random.default_rng(7 + closed)
    found = 0
    for _ in range(60):
        layers, epsilon = layered.random_layers(rng, closed=closed)
        labels = tuple(rng.integers(0, 2, len(m)) for m in layers.m)
        alone = [-np.inf]
        for label in (0, 1):
            members = [each == label for each in labels]
            if all(each.any() for each in members):
                q = [q[each] for q, each in zip(layers.q, members, strict=True)]
                m = [m[each] for m, each in zip(layers.m, members, strict=True)]
                some = Layers.from_arrays(q, m, continuous=layers.continuous, closed=closed)
                alone.append(layered.widest(some, epsilon, True))
        result = search_within(layers, labels, epsilon)
        assert result.minimum == max(alone)
        found += result.connected
        if result.connected:
            check_path(layers, epsilon, True, result)
            assert len({int(each[k]) for each, k in zip(labels, result.indices, strict=True)}) == 1
            if not closed:
                assert minimum_from_each(layers, result.epsilon, labels=labels).max() == result.minimum
    assert 5 < found < 55


@pytest.mark.parametrize("closed", [False, True])
def test_a_path_above_a_minimum_is_the_best_one_or_none(closed):
    rng = np.random.default_rng(9 + closed)
    connected = 0
    for _ in range(60):
        layers, epsilon = layered.random_layers(rng, closed=closed)
        reach = np.tile(epsilon, (len(layers.q) - (not closed), 1))
        best = layered.widest(layers, epsilon, True)
        if best == -np.inf:
            assert path_above(layers, reach, float(min(m.min() for m in layers.m)), silent) is None
            continue
        connected += 1
        q = path_above(layers, reach, best, silent)
        indices = tuple(int(np.abs(rows - each).max(axis=1).argmin()) for rows, each in zip(layers.q, q, strict=True))
        assert (np.abs(layered.path_steps(layers, indices)) < epsilon).all()
        assert path_above(layers, reach, np.nextafter(best, np.inf), silent) is None
    assert 5 < connected < 60


# ---- full turns


def at_all_turns(layers, turning, lower, upper):
    """Layers with each candidate at all full turns of some joints inside limits (n,), and the same that say so."""
    turns = np.array(list(product(*[range(-4, 5) if each else [0] for each in turning])))
    sets, values = [], []
    for q, m in zip(layers.q, layers.m, strict=True):
        every = (q + 2 * np.pi * turns[:, None]).reshape(-1, layers.n)
        inside = (((every >= lower) & (every <= upper)) | ~turning).all(axis=1)
        sets.append(every[inside])
        values.append(np.tile(m, len(turns))[inside])
    several = Layers.from_arrays(sets, values, continuous=layers.continuous & ~turning, closed=layers.closed)
    return several, replace(several, turn_middles=np.where(turning, (lower + upper) / 2, np.nan) if turning.any() else None)


@pytest.mark.parametrize("closed", [False, True])
@examples(100)
@given(seed=st.integers(0, 2**31))
def test_a_search_in_one_turn_finds_what_one_in_all_finds(closed, seed):
    rng = np.random.default_rng(seed)
    layers, epsilon = layered.random_layers(rng, closed=closed, most=6, positions=6)
    epsilon = epsilon * (1 + 1e-4)  # no step is just that
    turning = rng.random(layers.n) < 0.7
    middle, room = rng.uniform(-1, 1, layers.n), rng.uniform(np.pi + 1e-3, 3 * np.pi, layers.n)
    several, told = at_all_turns(layers, turning, middle - room, middle + room)
    prefer = rng.choice(["first", "shortest", "lexicographic"])
    wanted, found = (max_min_search(each, epsilon, prefer=prefer, throw=False, explain=False) for each in (several, told))
    assert (found.connected, found.minimum, found.breaks_at) == (wanted.connected, wanted.minimum, wanted.breaks_at)
    if found.connected:
        check_path(several, epsilon, True, found)
        if prefer != "first":
            np.testing.assert_allclose(found.length, wanted.length, rtol=1e-12, atol=1e-12)
            np.testing.assert_array_equal(np.sort(found.manipulability)[0], np.sort(wanted.manipulability)[0])


@pytest.mark.parametrize(("step", "connected"), [(0.1, True), (0.3, True), (0.5, False)])
def test_a_joint_turns_as_far_as_its_limits_allow(step, connected):
    q = (step * np.arange(30)[:, None, None] + np.pi) % (2 * np.pi) - np.pi
    layers = Layers.from_arrays(list(q), [[1.0]] * 30)
    several, told = at_all_turns(layers, np.array([True]), np.array([-2 * np.pi]), np.array([2 * np.pi]))
    result = max_min_search(told, 0.6, throw=False)
    assert result.connected == max_min_search(several, 0.6, throw=False).connected == connected
    assert not connected or (np.abs(result.q) <= 2 * np.pi).all()
    assert max_min_search(told.in_one_turn, 0.6).connected


def test_a_given_first_configuration_is_kept_at_its_turn():
    q = np.linspace(-2, 2, 30)[:, None, None] + [[0.0]]
    several, _ = at_all_turns(Layers.from_arrays(list(q), [[1.0]] * 30), np.array([True]), np.array([-9.0]), np.array([9.0]))
    first = np.array([[-2 + 2 * np.pi]])
    some = replace(several, q=(first, *several.q[1:]), m=(np.ones(1), *several.m[1:]), turn_middles=np.zeros(1))
    found = max_min_search(some, 0.2)
    np.testing.assert_allclose(found.q[:, 0], np.linspace(-2, 2, 30) + 2 * np.pi, atol=1e-12)


def test_candidates_of_one_label_at_several_turns():
    """The best candidates at the middle have another label than those at both ends."""
    q = np.repeat(np.linspace(-2, 2, 30)[:, None, None], 2, axis=1)
    q[:, 1] += 0.01
    layers = Layers.from_arrays(list(q), [[1.0, 2.0]] * 30)
    _, told = at_all_turns(layers, np.array([True]), np.array([-9.0]), np.array([9.0]))
    labels = [(each == 2.0).astype(np.int64) for each in told.m]
    labels[0][:] = 0
    assert search_within(told, labels, 0.2).minimum == 1.0
    assert max_min_search(told, 0.2).minimum == 2.0
