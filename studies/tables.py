"""A table of results, written as CSV and as Markdown."""

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

Cell = str | float | int | bool


@dataclass(frozen=True, kw_only=True)
class Table:
    """A heading and rows of cells; `name` is the name of its files."""

    name: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]

    @classmethod
    def of(cls, name: str, head: Sequence[str], rows: Sequence[Sequence[Cell]]) -> "Table":
        """Build one from sequences."""
        return cls(name=name, head=tuple(head), rows=tuple(tuple(row) for row in rows))

    def write(self, folder: Path) -> None:
        """Write name.csv, and name.md with rounded numbers."""
        self.write_csv(folder)
        lines = [self.head, ["---"] * len(self.head), *([shown(cell) for cell in row] for row in self.rows)]
        (folder / f"{self.name}.md").write_text("".join(f"| {' | '.join(line)} |\n" for line in lines))

    def write_csv(self, folder: Path) -> None:
        """Write name.csv."""
        with (folder / f"{self.name}.csv").open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerows([self.head, *([_plain(cell) for cell in row] for row in self.rows)])


def shown(cell: Cell) -> str:
    """The text of a cell in Markdown: three digits, large numbers with powers of ten."""
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, str):
        return cell
    if abs(cell) >= 1e4:
        return f"{cell:.3g}".replace("e+0", "e")
    if float(cell).is_integer():
        return str(int(cell))
    return f"{cell:.3f}" if abs(cell) < 1 else f"{cell:.3g}" if abs(cell) < 100 else f"{cell:.0f}"


def _plain(cell: Cell) -> str:
    return f"{cell:.6g}" if isinstance(cell, float) else shown(cell) if isinstance(cell, bool) else str(cell)
