"""Tables of numbers in CSV files: every row has as many cells as the first, which names the columns."""

import csv
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

#: Maximum size of a file [bytes].
LARGEST_TABLE = 64 * 2**20
#: A number as it is written in every language: no digits grouped by `_`, no decimal comma.
NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|[+-]?(?:nan|inf|infinity)", re.IGNORECASE)


@dataclass(frozen=True, kw_only=True)
class Table:
    """The cells of a file: the names of its columns, and of each row the number of its line and the cells."""

    path: Path
    header: tuple[str, ...]
    rows: tuple[tuple[int, tuple[str, ...]], ...]

    @classmethod
    def read(cls, path: Path, *, comments: bool = False) -> "Table":
        """Read a file; with `comments`, lines that begin with # are left out.

        Raises FileFormatError for a file that is too large, is no text in UTF-8, is empty, or has a row with another number of
        cells than the first.
        """
        size = path.stat().st_size
        if size > LARGEST_TABLE:
            raise FileFormatError("file", f"{path} of {size:,} bytes", f"a CSV of at most {LARGEST_TABLE:,} bytes")
        try:
            with path.open(newline="", encoding="utf-8-sig") as stream:
                lines = list(_lines(csv.reader(stream, strict=True), comments=comments))
        except (csv.Error, UnicodeDecodeError) as error:
            raise FileFormatError("file", str(path), f"a text file (CSV); {error}") from error
        if not lines:
            raise FileFormatError("file", f"{path}, which is empty", "a CSV whose first line names the columns")
        (_, first), *rows = lines
        header = tuple(cell.removeprefix("#").strip() for cell in first)
        for line, row in rows:
            if len(row) != len(header):
                several = 1 < len(header) < len(row)
                more = "; a decimal comma makes two cells of a number: write 0.5" if several else f": {first[0]}"
                wanted = f"{len(header)} cells, as in the first row, which names the columns{more}"
                raise FileFormatError("file", f"{path}, row {line}, with {len(row)} cells", wanted)
        return cls(path=path, header=header, rows=tuple(rows))

    def column(self, names: Sequence[str], wanted: str) -> int:
        """Index of the only column with one of the names."""
        found = [k for k, column in enumerate(self.header) if column in names]
        if len(found) != 1:
            many, each = len(found) or "no", " or ".join(names)
            listed = ", ".join(self.header)
            raise FileFormatError("file", str(self.path), f"{wanted}; it has {many} column {each}, its columns are {listed}")
        return found[0]

    def numbers(self, columns: Sequence[int]) -> Array:
        """The cells of some columns as finite numbers (rows, columns); raises FileFormatError, which names row and column."""
        data = np.empty((len(self.rows), len(columns)))
        for k, (_, row) in enumerate(self.rows):
            for j, column in enumerate(columns):
                cell = row[column]
                if not NUMBER.fullmatch(cell):
                    raise FileFormatError("file", f"{self.name_cell(k, column)}: {cell}", "a number")
                data[k, j] = float(cell)
        for k, j in np.argwhere(~np.isfinite(data)).tolist():
            column = columns[j]
            got = f"{self.name_cell(k, column)}: {self.rows[k][1][column]}"
            raise FileFormatError("file", got, "a finite number, no NaN or inf")
        return data

    def name_cell(self, k: int, column: int) -> str:
        """Where a cell of row k is, in words."""
        return f"{self.path}, row {self.rows[k][0]}, {self.header[column]}"


def _lines(reader: Iterator[list[str]], *, comments: bool) -> Iterator[tuple[int, tuple[str, ...]]]:
    """Number and cells of each line that is not empty."""
    for cells in reader:
        row = tuple(cell.strip() for cell in cells)
        if any(row) and not (comments and row[0].startswith("#")):
            yield reader.line_num, row  # type: ignore[attr-defined]  # of csv.reader
