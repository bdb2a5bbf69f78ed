"""Small random layers, and what a search has to find in them by trying all: plain NumPy, no grid, no rounds."""

import itertools

import numpy as np

from manipplan.search.layers import Layers

TAU = 2 * np.pi


def random_layers(rng, *, closed=False, most=25, positions=6):
    """Layers with ties, duplicates and joints that turn without end, with an ε that connects about half of them."""
    count, n = rng.integers(2, positions + 1), rng.integers(1, 5)
    digits = rng.integers(1, 4)
    span = rng.choice([0.5, 2.0, 7.0])
    q = [rng.uniform(-span, span, (rng.integers(1, most + 1), n)).round(digits) for _ in range(count)]
    m = [rng.normal(size=len(each)).round(rng.integers(0, 4)) for each in q]
    layers = Layers.from_arrays(q, m, continuous=rng.random(n) < 0.4, closed=closed)
    epsilon = np.minimum(span * rng.uniform(0.05, 1.0, n), 3.0).round(1) + 0.1  # on the grid of the joints: steps of just ε
    return layers, epsilon if rng.random() < 0.5 else float(epsilon[0])


def steps(layers, a, b):
    d = b - a
    return np.where(layers.continuous, d - TAU * np.floor(d / TAU + 0.5), d)


def neighbours(layers, i, j, epsilon, strict):
    """Which candidates of layer i neighbour which of layer j: (k_i, k_j)."""
    size = np.abs(steps(layers, layers.q[i][:, None], layers.q[j][None]))
    return (size < epsilon).all(-1) if strict else (size <= epsilon).all(-1)


def widest(layers, epsilon, strict):
    """The largest minimum manipulability by all pairs; of a cycle from each begin."""
    count = len(layers.q)
    edges = [neighbours(layers, i, (i + 1) % count, epsilon, strict) for i in range(count)]

    def forward(value):
        for i in range(1, count):
            value = np.minimum(layers.m[i], np.where(edges[i - 1], value[:, None], -np.inf).max(0))
        return value

    if not layers.closed:
        return forward(layers.m[0]).max()
    best = -np.inf
    for begin in range(len(layers.q[0])):
        alone = np.full(len(layers.q[0]), -np.inf)
        alone[begin] = layers.m[0][begin]
        best = max(best, np.where(edges[-1][:, begin], forward(alone), -np.inf).max())
    return best


def paths(layers, epsilon, strict):
    """All continuous paths, as tuples of candidates."""
    count = len(layers.q)
    edges = [neighbours(layers, i, (i + 1) % count, epsilon, strict) for i in range(count)]
    for path in itertools.product(*(range(len(each)) for each in layers.q)):
        inner = all(edges[i][path[i], path[i + 1]] for i in range(count - 1))
        if inner and (not layers.closed or edges[-1][path[-1], path[0]]):
            yield path


def indices_along(layers, path):
    return np.array([layers.m[i][k] for i, k in enumerate(path)])


def path_steps(layers, path):
    q = np.array([layers.q[i][k] for i, k in enumerate(path)])
    pairs = [(k, k + 1) for k in range(len(q) - 1)] + ([(len(q) - 1, 0)] if layers.closed else [])
    return np.array([steps(layers, q[a], q[b]) for a, b in pairs])


def length(layers, path):
    return np.linalg.norm(path_steps(layers, path), axis=1).sum()


def least_factor(layers, epsilon):
    """The least factor of ε that connects, from all paths."""
    everything = np.full(layers.n, np.inf)
    return min((np.abs(path_steps(layers, path)) / epsilon).max() for path in paths(layers, everything, True))
