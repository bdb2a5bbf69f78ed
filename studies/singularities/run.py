"""The whole study in one command."""

import csv
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from studies import command
from studies.expected import differences
from studies.singularities import figures
from studies.singularities.slopes import Series, planar, spatial
from studies.tables import Table

PAGES = Path(__file__).parents[2] / "docs" / "studies" / "singularities"
EXPECTED = Path(__file__).with_name("expected.csv")


def study(out: Path, _quick: bool, notify: command.Progress) -> dict[str, float]:
    """Make the tables and the figure; returns the numbers that are compared."""
    arms: list[list[Series]] = []
    command.in_stages(
        [
            ("two links", 1.0, lambda: arms.append(planar())),
            ("UR5", 3.0, lambda: arms.append(spatial())),
            ("figure", 1.0, lambda: figures.slopes(arms, out / "slopes.png")),
        ],
        notify,
    )
    for name, series in zip(("planar", "spatial"), arms, strict=True):
        table(name, series).write(out)
    return {f"{each.arm}, {len(each.crossings)} crossings: {text}": v for a in arms for each in a for text, v in numbers(each)}


def table(name: str, series: list[Series]) -> Table:
    """A row per path."""
    head = ("crossings", "singularities", "slope of g over log(1/ε)", "Σ 2/σ", "g at the largest ε", "at the smallest")
    head += ("g without crossings, largest ε", "smallest ε")
    rows: list[list[str | float | int]] = []
    for each in series:
        kinds = ", ".join(crossing.kind or "elbow" for crossing in each.crossings) or "none"
        shown = (each.slope, each.derived, each.g[0], each.g[-1], each.finite[0], each.finite[-1])
        rows.append([len(each.crossings), kinds, *(f"{round(value, 6):.5g}" for value in shown)])
    return Table.of(name, head, rows)


def numbers(series: Series) -> list[tuple[str, float]]:
    """The numbers of a path that expected.csv has, by their texts."""
    found = [
        ("slope", series.slope),
        ("slope less that from the steepness", series.slope - series.derived),
        ("g without crossings, smallest floor", float(series.finite[-1])),
    ]
    return found if np.isnan(series.error) else [*found, ("relative difference from the closed form", series.error)]


def wrong(found: Mapping[str, float]) -> list[str]:
    """One line per number that is not as expected.csv has it."""
    with EXPECTED.open(newline="", encoding="utf-8") as file:
        wanted = [(row["number"], float(row["value"]), float(row["tolerance"])) for row in csv.DictReader(file)]
    return differences(found, wanted)


STUDY = command.Study(pages=PAGES, quick="nothing is left out", make=study, differences=lambda found, _quick: wrong(found))
