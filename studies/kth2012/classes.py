"""Homotopy classes of paths of the three-link arm: walks over the cells between the singular postures.

The arm is singular where θ_2 and θ_3 are whole multiples of π: points of the plane, the corners of square cells with sides π.
The plane without these points can be contracted to the grid that connects the centres of neighbouring cells. So a class of
paths with fixed ends is a walk over neighbouring cells without immediate reversal, and each such walk is one class.
"""

import itertools
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

import manipplan as mp

Array = NDArray[np.float64]
Cell = tuple[int, int]
Walk = tuple[Cell, ...]
ARROWS = {(1, 0): "→", (-1, 0): "←", (0, 1): "↑", (0, -1): "↓"}


def cell(q: ArrayLike) -> Cell:
    """The cell that a configuration (3,) [rad] lies in."""
    second, third = np.floor(np.asarray(q)[1:] / np.pi)
    return int(second), int(third)


def walks(start: Cell, most: int) -> Iterator[Walk]:
    """All walks from a cell with at most `most` steps and without immediate reversal."""
    growing: list[Walk] = [(start,)]
    for _ in range(most + 1):
        yield from growing
        growing = [
            (*walk, after)
            for walk in growing
            for step in ARROWS
            if (after := (walk[-1][0] + step[0], walk[-1][1] + step[1])) not in walk[-2:-1]
        ]


def walk_of(q: Array) -> Walk:
    """The class of a densely sampled path (m, 3). Raises ValueError if consecutive samples are not in neighbouring cells."""
    walk: list[Cell] = []
    for after in zip(*np.floor(q[:, 1:] / np.pi).astype(int).T.tolist(), strict=True):
        if walk and after == walk[-1]:
            continue
        if walk and abs(after[0] - walk[-1][0]) + abs(after[1] - walk[-1][1]) != 1:
            raise ValueError(f"a jump from cell {walk[-1]} to {after}")
        if len(walk) > 1 and after == walk[-2]:
            walk.pop()  # an immediate reversal encloses nothing
        else:
            walk.append(after)
    return tuple(walk)


def arrows(walk: Walk) -> str:
    """A walk as arrows: θ_2 to the right, θ_3 upwards."""
    steps = [ARROWS[after[0] - before[0], after[1] - before[1]] for before, after in itertools.pairwise(walk)]
    return "".join(steps) or "·"


def through(start: Array, goal: Array, walk: Walk) -> mp.JointPath:
    """A first path of a class: straight pieces through the centres of the cells in between; θ_1 changes evenly along it."""
    middles = [[0.0, (a + 0.5) * np.pi, (b + 0.5) * np.pi] for a, b in walk[1:-1]]
    points = np.array([start, *middles, goal])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points[:, 1:], axis=0), axis=1))])
    points[:, 0] = start[0] + (goal[0] - start[0]) * along / along[-1]
    return mp.JointPath.through(points)
