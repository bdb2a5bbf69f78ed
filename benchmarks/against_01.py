"""`mp.plan` beside an older version, whose checkout `--old` names, in the same run: time and g on three suites of the Panda.

Free pairs are the first random ones of panda_pairs.py, those among five boxes are of panda_boxes.py, those in the shelf of
benchmarks/pairs, with 10 mm of clearance. One worker process per version has everything built; they take turns, and which one
begins alternates, so that a slow moment of the machine meets both. Times are processor times. Version 0.1 is made by
`git worktree add PATH 6f9afba`. Writes docs/benchmarks/against_01.md; answers are kept in --results, as in convergence.py.
"""

import argparse
import platform
import tempfile
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from convergence import CLEARANCE, Row, boxes_tasks, no_package, random_tasks, ratio, run_old, table, task
from path_suite import PAIRS, load

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "against_01.md"
#: g may be above the older version's by this share.
ABOVE = 1e-2
#: What is wanted, by suite: the older version's time over ours, in the median.
WANTED = {"random": 5, "boxes": 8, "shelf": 8}
NAMES = {"random": "free pairs", "boxes": "five boxes", "shelf": "shelf"}
#: Number of problems of each suite; the shelf has 17.
COUNT = 20


def shelf_tasks(count: int) -> list[Row]:
    """The first pairs of the Panda in the shelf."""
    scene = mp.Scene.from_yaml(PAIRS / "shelf_panda.yaml")
    pairs = [pair for pair in load() if pair["arm"] == "panda" and pair["scene"] == "shelf"][:count]
    ends = [(pair["start"], pair["goal"]) for pair in pairs]
    return [task("shelf", f"{k}", {"name": "panda"}, *each, scene, clearance=CLEARANCE) for k, each in enumerate(ends)]


def cells(rows: Sequence[Row]) -> list[str]:
    """The figures of a suite."""
    both = [row for row in rows if np.isfinite([row["new"]["g"], row["old"]["g"]]).all()]
    times = np.array(
        [row["old"]["cpu"] / row["new"]["cpu"] for row in rows if {"cpu"} <= row["old"].keys() & row["new"].keys()]
    )
    g = np.array([ratio(row["new"]["g"], row["old"]["g"]) for row in both])
    better, worse = (
        sum(np.isinf(row[one]["g"]) and np.isfinite(row[other]["g"]) for row in rows)
        for one, other in (("old", "new"), ("new", "old"))
    )
    kept = int((g <= 1 + ABOVE).sum()) + better
    counted = len(g) + better + worse
    ms = {version: [1e3 * row[version]["cpu"] for row in rows if "cpu" in row[version]] for version in ("new", "old")}
    return [
        f"{len(rows)}",
        *(f"{np.median(ms[version]):.0f}, {np.quantile(ms[version], 0.95):.0f}" for version in ("old", "new")),
        f"{np.median(times):.2f}, {np.quantile(times, 0.05):.2f}",
        f"{kept} of {counted} ({100 * kept / max(counted, 1):.0f} %)",
        f"{g.mean():.4f}, {g.max():.3f}" if len(g) else "",
        f"{better}, {worse}",
        ", ".join(f"{count} {status}" for status, count in Counter(row["new"]["status"] for row in rows).most_common()),
    ]


def main(arguments: Sequence[str] | None = None) -> list[Row]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--old", type=Path, required=True, help="checkout of the older version")
    parser.add_argument("--count", type=int, default=COUNT, help="maximum number of problems of each suite")
    results = Path(tempfile.gettempdir()) / "manipplan_against_01"
    parser.add_argument("--results", type=Path, default=results, help="folder of the answers")
    parser.add_argument("--again", action="store_true", help="solve everything anew, also what --results holds")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    if not (given.old / "manipplan" / "__init__.py").is_file():
        parser.error(no_package(given.old))
    if given.again:
        (given.results / "old.jsonl").unlink(missing_ok=True)
    rows = run_old([*random_tasks(given.count), *boxes_tasks(given.count), *shelf_tasks(given.count)], given.results, given.old)
    suites = {suite: [row for row in rows if row["suite"] == suite] for suite in WANTED}
    head = [
        "suite",
        "problems",
        "older version: median, 95 % [ms]",
        "this version: median, 95 % [ms]",
        "older over this: median of the problems, lowest 5 %",
        "wanted",
        f"g not above the older one's by more than {100 * ABOVE:g} %",
        "g over the older one's: mean, worst",
        "finite g from this version alone, from the older one alone",
        "statuses of this version",
    ]
    lines = []
    for suite, some in suites.items():
        every = cells(some)
        lines.append([NAMES[suite], *every[:4], f"{WANTED[suite]}", *every[4:]])
    text = [
        *table(head, lines),
        "",
        f"Processor time of `mp.plan`; Python {platform.python_version()}, {platform.machine()}, one thread; command: "
        f"`.venv/bin/python benchmarks/against_01.py --old PATH --count {given.count}`.",
    ]
    given.out.write_text("\n".join(text) + "\n")
    print("\n".join(text))
    return rows


if __name__ == "__main__":
    main()
