"""The exact max-min search beside a ladder graph and a dense dynamic programme, on the same layers.

Run with `make benchmark`. mp.Layers are made of smooth self-motions: at each position every inverse-kinematic branch of a
seven-joint arm is a surface over two angles, on which the index is smooth. From position to position the surfaces move
slowly; index and holes (collisions) move along them at a `speed`, so that high candidates of one position need not
neighbour high ones of the next. Every large case runs in a process of its own, for its memory. Writes
docs/benchmarks/search.md.
"""

import argparse
import json
import os
import platform
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np
from rich.progress import Progress

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "search.md"
CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
POSITIONS, JOINTS, BRANCHES, WAVES = 50, 7, 8, 4


@dataclass(frozen=True, kw_only=True)
class Case:
    """mp.Layers to search.

    Attributes:
        count: candidates in all, before the holes.
        epsilon: largest step [rad].
        speed: how fast index and holes move [rad a position].
        swing: how much the index of a whole branch rises and falls along the path: a branch that is good at the begin need
            not be at the end.
        seed: of the random numbers.
    """

    count: int
    epsilon: float
    speed: float
    swing: float = 0.0
    seed: int = 0


SMALL = Case(count=45_000, epsilon=0.4, speed=0.05, swing=1.2)
LARGE = {
    "at rest": Case(count=10_000_000, epsilon=0.1, speed=0.0),
    "swinging": Case(count=10_000_000, epsilon=0.1, speed=0.05, swing=1.2),
    "drifting": Case(count=10_000_000, epsilon=0.1, speed=0.5),
    "drifting fast": Case(count=10_000_000, epsilon=0.1, speed=2.0),
    "swinging and drifting fast": Case(count=10_000_000, epsilon=0.1, speed=2.0, swing=1.2),
}


def layers_of(case: Case) -> mp.Layers:
    """The layers of a case, made one after the other so that nothing else is held."""
    rng = np.random.default_rng(case.seed)
    terms = rng.integers(-1, 2, (BRANCHES, JOINTS, 3, 2)).astype(float)
    phases, sizes = rng.uniform(0, 2 * np.pi, (BRANCHES, JOINTS, 3)), rng.uniform(0.2, 0.6, (BRANCHES, JOINTS, 3))
    middle, drift = rng.uniform(-1.5, 1.5, (BRANCHES, JOINTS)), 0.01 * rng.normal(size=(BRANCHES, JOINTS))
    level, turn = rng.uniform(0.8, 1.2, BRANCHES), rng.uniform(0, 2 * np.pi, BRANCHES)
    waves = rng.integers(-2, 3, (2, BRANCHES, WAVES, 2)).astype(float)
    begin = rng.uniform(0, 2 * np.pi, (2, BRANCHES, WAVES))
    pace = case.speed * rng.normal(size=(2, BRANCHES, WAVES))
    each = case.count // POSITIONS
    configurations, indices = [], []
    for i in range(POSITIONS):
        configurations.append(np.empty((each, JOINTS)))
        indices.append(np.empty(each))
        filled = 0
        while filled < each:  # candidates in holes are drawn again
            branch = rng.integers(0, BRANCHES, each)
            angles = rng.uniform(0, 2 * np.pi, (each, 2))
            for b in range(BRANCHES):
                on = angles[branch == b]
                field, hole = (np.cos(on @ waves[f, b].T + begin[f, b] + i * pace[f, b]).sum(axis=1) / WAVES for f in range(2))
                height = level[b] + case.swing * np.cos(np.pi * i / (POSITIONS - 1) + turn[b]) + field
                free = np.flatnonzero((hole < 0.45) & (height > 0))[: each - filled]
                place = np.tile(middle[b] + i * drift[b], (len(free), 1))
                for k in range(3):
                    place += sizes[b, :, k] * np.sin(on[free] @ terms[b, :, k].T + phases[b, :, k])
                configurations[-1][filled : filled + len(free)] = place
                indices[-1][filled : filled + len(free)] = height[free]
                filled += len(free)
        order = rng.permutation(each)  # candidates come in no order that a search could lean on
        configurations[-1], indices[-1] = configurations[-1][order], indices[-1][order]
    return mp.Layers.from_arrays(configurations, indices)


def ladder(layers: mp.Layers, epsilon: float) -> float:
    """As Descartes plans: all edges of all pairs of rungs are built and stored, then the graph is searched."""
    edges = []
    for a, b in pairwise(layers.q):
        near = [np.flatnonzero((np.abs(b - each) < epsilon).all(axis=1)) for each in a]
        edges.append((np.repeat(np.arange(len(a)), [len(each) for each in near]), np.concatenate(near)))
    value = layers.m[0]
    for (source, target), m in zip(edges, layers.m[1:], strict=True):
        best = np.full(len(m), -np.inf)
        np.maximum.at(best, target, value[source])
        value = np.minimum(m, best)
    return float(value.max())


def dense(layers: mp.Layers, epsilon: float) -> float:
    """As CppFlow does: a dynamic programme over dense matrices of all pairs of neighbouring layers."""
    value = layers.m[0]
    for (a, b), m in zip(pairwise(layers.q), layers.m[1:], strict=True):
        near = np.ones((len(b), len(a)), dtype=bool)
        for j in range(JOINTS):
            near &= np.abs(b[:, np.newaxis, j] - a[:, j]) < epsilon
        value = np.minimum(m, np.where(near, value, -np.inf).max(axis=1))
    return float(value.max())


def timed(work: Callable, repeat: int = 1) -> tuple[float, object]:
    """The least time of some runs [s], and the result."""
    least, result = np.inf, None
    for _ in range(repeat):
        began = time.perf_counter()
        result = work()
        least = min(least, time.perf_counter() - began)
    return least, result


def warm() -> None:
    """Compile everything: the first call in a process also loads what an earlier process compiled."""
    layers = layers_of(Case(count=2000, epsilon=1.0, speed=0.1))
    for prefer in ("first", "shortest", "lexicographic"):
        mp.max_min_search(layers, 1.0, prefer=prefer)


def quantile(layers: mp.Layers, value: float) -> float:
    """The share of all candidates whose index is below the value."""
    return sum(int((m < value).sum()) for m in layers.m) / layers.count


def small(notify: Callable[[str], None]) -> list[str]:
    """All searches on layers that all of them can hold."""
    layers, epsilon = layers_of(SMALL), SMALL.epsilon
    exact, result = timed(lambda: mp.max_min_search(layers, epsilon, prefer="first", threads=1), repeat=5)
    rows = [
        f"{layers.count} candidates in {POSITIONS} layers, ε = {epsilon:g} rad, one thread:",
        "",
        "| search | time | of the exact search | minimum manipulability | |",
        "|---|---|---|---|---|",
        f'| exact, prefer="first" | {exact:.4f} s | 1 x | {result.minimum:.6f} | {result.rounds} passes |',
    ]

    def row(name: str, seconds: float, minimum: float, remark: str) -> None:
        rows.append(f"| {name} | {seconds:.4g} s | {seconds / exact:.4g} x | {minimum:.6f} | {remark} |")

    for prefer in ("shortest", "lexicographic"):
        notify(prefer)
        seconds, path = timed(partial(mp.max_min_search, layers, epsilon, prefer=prefer, threads=1), repeat=5)
        row(
            f'exact, prefer="{prefer}"',
            seconds,
            path.minimum,
            f'path {1 - path.length / result.length:.0%} shorter than "first"',
        )
    for name, peer, remark in (
        ("dense dynamic programme, as CppFlow's, NumPy", dense, "all pairs"),
        ("ladder graph, as Descartes', NumPy", ladder, "all pairs, edges stored"),
    ):
        notify(name)
        seconds, minimum = timed(partial(peer, layers, epsilon))
        row(name, seconds, minimum, remark)
    return rows


def large(name: str, threads: int) -> dict:
    """One large case, in this process."""
    case = LARGE[name]
    warm()
    layers = layers_of(case)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    seconds, result = timed(lambda: mp.max_min_search(layers, case.epsilon, prefer="first", threads=threads), repeat=3)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    alone, _ = timed(lambda: mp.max_min_search(layers, case.epsilon, prefer="first", threads=1), repeat=3)
    longer, shortest = timed(lambda: mp.max_min_search(layers, case.epsilon, prefer="shortest", threads=threads))
    assert shortest.minimum == result.minimum
    first = []
    began = time.perf_counter()
    for each in mp.max_min_search(layers, case.epsilon, prefer="first", anytime=True, threads=threads):
        if each.connected:
            first.append((time.perf_counter() - began, each.certified_gap))
    return {
        "count": layers.count,
        "bytes": layers.nbytes,
        "seconds": seconds,
        "alone": alone,
        "shortest": longer,
        "shorter": 1 - shortest.length / result.length,
        "minimum": result.minimum,
        "bound": result.bound,
        "quantile": quantile(layers, result.minimum),
        "rounds": result.rounds,
        "nodes": result.nodes,
        "made": 1024 * before,
        "peak": 1024 * peak,
        "first_path": first[0],
    }


def large_rows(notify: Callable[[str], None]) -> list[str]:
    """Every large case, each in a fresh process."""
    threads = CORES
    rows = [
        f'50 layers, ε = 0.1 rad, prefer="first", {threads} threads; memory is the peak of the whole process, with the '
        "candidates themselves in brackets.",
        "",
        '| layers | candidates | search | one thread | prefer="shortest" | its path | minimum manipulability (bound) '
        "| quantile | passes, candidates in the last | memory | first path, and its certified gap |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for name in LARGE:
        notify(name)
        command = [sys.executable, __file__, "--large", name, "--threads", str(threads)]
        told = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
        rows.append(
            f"| {name} | {told['count']} | {told['seconds']:.3f} s | {told['alone']:.3f} s | {told['shortest']:.3f} s "
            f"| {told['shorter']:.0%} shorter | {told['minimum']:.4f} ({told['bound']:.4f}) | {told['quantile']:.3f} "
            f"| {told['rounds']}, {told['nodes']} | {told['peak'] / 1e9:.2f} GB ({told['bytes'] / 1e9:.2f}) "
            f"| {told['first_path'][0]:.3f} s, {told['first_path'][1]:.3f} |"
        )
    return rows


def sampled_rows(notify: Callable[[str], None]) -> list[str]:
    """The circle of the study: TALOS' torso and arm, 306,306 samples of what it has to spare at each of 50 positions."""
    notify("sampling TALOS' circle")
    robot = mp.load_robot("talos_torso_right_arm")
    start = np.array([[0.0, 0.0, -1.0, 0.45], [-1.0, 0.0, 0.0, -0.25], [0.0, 1.0, 0.0, 0.25], [0.0, 0.0, 0.0, 1.0]])
    circle = mp.CartesianPath.circle(start, start[:3, 3] - [0.0, 0.0, 0.1], (1.0, 0.0, 0.0))
    mp.sample_layers(robot, circle, 3, samples=(9, 9, 9))  # kernels, collision shapes
    lines = [
        "TALOS' torso and right arm on a vertical circle, 306,306 samples at each of 50 positions, each with up to eight "
        f"answers; sampling on {CORES} threads:",
        "",
        "| collisions | candidates | sampling | ε | search | minimum manipulability (bound) | together |",
        "|---|---|---|---|---|---|---|",
    ]
    for collisions in (False, True):
        began = time.perf_counter()
        layers = mp.sample_layers(robot, circle, 50, samples=(77, 51, 78), collisions=collisions)
        sampled = time.perf_counter() - began
        for degrees in (2, 3, 5):
            began = time.perf_counter()
            found = mp.max_min_search(layers, np.deg2rad(degrees), throw=False)
            searched = time.perf_counter() - began
            figures = f"{found.minimum:.6f} ({found.bound:.6f})"
            if found.smallest_epsilon is not None:
                figures = f"not connected; above {np.rad2deg(found.smallest_epsilon.max()):.3f}°"
            row = f"{layers.count} | {sampled:.1f} s | {degrees}° | {searched:.2f} s | {figures} | {sampled + searched:.1f} s"
            lines.append(f"| {'checked' if collisions else 'not checked'} | {row} |")
    return lines


def main(arguments: list[str] | None = None) -> None:
    """Run, and write the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=OUT)
    parser.add_argument("--large", choices=list(LARGE), help="one large case only, as JSON")
    parser.add_argument("--threads", type=int, default=CORES)
    options = parser.parse_args(arguments)
    if options.large:
        print(json.dumps(large(options.large, options.threads)))
        return
    # a section of the page each: its lines
    sections: list[Callable[[Callable[[str], None]], list[str]]] = [
        sampled_rows,
        small,
        large_rows,
    ]
    text: list[str] = []
    with Progress() as progress:
        bar = progress.add_task("compiling", total=len(sections))
        warm()
        for section in sections:
            text += [*section(lambda words: progress.update(bar, description=words)), ""]
            progress.advance(bar)
    told = f"Python {platform.python_version()}, {platform.machine()}, {CORES} cores; command: `make benchmark`."
    page = "\n".join([*text, told, ""])
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(page)
    print(page)


if __name__ == "__main__":
    main()
