"""Every number that a study prints, compared with its pages, and what made the pages.

`classes.csv` says which numbers are not converged: "time" depends on the machine's speed and is not compared, "chaotic" changes
with the last bit of a sum and is compared within a share of the largest number of its column. "claim" is compared with
expected.csv, within a tolerance of its own. All other numbers are exact or converged: they are compared within one unit of the
last printed digit, or within a share of `CONVERGED`.
"""

import ast
import csv
import hashlib
import json
import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).parent
CLASSES = HERE / "classes.csv"
STAMP = "made.json"
NUMBER = re.compile(r"(?<![\w.^])[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w^])")
#: Share by which a converged number may differ.
CONVERGED = 2e-3
#: Numbers that differ by less are rounding errors of zero.
TINY = 1e-8
TIME, CHAOTIC, CLAIM, CONVERGING = "time", "chaotic", "claim", "converged"


@dataclass(kw_only=True)
class Comparison:
    """How many numbers were compared, by class, tables that a quick run leaves out, and a line per difference."""

    counts: Counter[str] = field(default_factory=Counter)
    left_out: list[str] = field(default_factory=list)
    differences: list[str] = field(default_factory=list)

    @property
    def summary(self) -> str:
        """What was compared, in words."""
        parts = [f"{self.counts[CONVERGING]} printed numbers agree with the pages"]
        if self.counts[CLAIM]:
            parts.append(f"{self.counts[CLAIM]} numbers of claims agree with expected.csv")
        if self.counts[CHAOTIC]:
            parts.append(f"{self.counts[CHAOTIC]} chaotic ones are within their spread")
        if self.counts[TIME]:
            parts.append(f"{self.counts[TIME]} times are of this machine and were not compared")
        if self.left_out:
            parts.append(f"tables left out by --quick: {', '.join(self.left_out)}")
        return "; ".join(parts)


def compare(made: Path, pages: Path, *, quick: bool = False) -> Comparison:
    """Compare all tables that a run wrote to `made` with those of the pages; `quick` runs leave out tables, rows and cells."""
    found = Comparison()
    kept = rules(pages.name)
    for file in sorted(pages.glob("*.csv")):
        other = made / file.name
        wanted, given = _read(file), _read(other) if other.is_file() else [[]]
        if len(wanted) != len(given) or wanted[0] != given[0]:
            if quick:
                found.left_out.append(file.stem)
            else:
                found.differences.append(f"{file.stem}: {'other rows or columns' if other.is_file() else 'not made'}")
            continue
        _compare_table(file.stem, wanted, given, kept, found, quick=quick)
    return found


@dataclass(frozen=True, kw_only=True)
class Rule:
    """The class of some numbers of a table: those of a column, or of all columns, in the rows that `where` holds for.

    `where` is "column = text" or "column > number"; empty, it holds for all rows.
    """

    table: str
    column: str
    where: str
    kind: str
    share: float

    def holds(self, head: list[str], row: list[str], column: str) -> bool:
        """Whether the rule is for this cell."""
        if self.column and self.column != column:
            return False
        if not self.where:
            return True
        sign = "=" if "=" in self.where else ">"
        name, wanted = (part.strip() for part in self.where.split(sign))
        cell = row[head.index(name)]
        return cell == wanted if sign == "=" else float(cell) > float(wanted)


def rules(study: str) -> list[Rule]:
    """The rules of classes.csv for a study; the first that holds counts."""
    with CLASSES.open(newline="", encoding="utf-8") as file:
        return [
            Rule(
                table=row["table"], column=row["column"], where=row["where"], kind=row["class"], share=float(row["share"] or 0)
            )
            for row in csv.DictReader(file)
            if row["study"] == study
        ]


#: For cells without a rule of their own.
DEFAULT = Rule(table="", column="", where="", kind=CONVERGING, share=CONVERGED)


def _compare_table(
    name: str, wanted: list[list[str]], given: list[list[str]], kept: list[Rule], found: Comparison, *, quick: bool
) -> None:
    head, kept = wanted[0], [each for each in kept if each.table == name]
    for k, column in enumerate(head):
        largest = max((abs(value) for row in wanted[1:] for value, _ in numbers(row[k])), default=0.0)
        for number, (first, second) in enumerate(zip(wanted[1:], given[1:], strict=True), start=1):
            rule = next((each for each in kept if each.holds(head, first, column)), DEFAULT)
            before, after = first[k], second[k]
            if quick and not after:
                continue
            found.counts[rule.kind] += len(numbers(before))
            where = f"{name}, row {number}, {column}: {after}, printed {before}"
            if rule.kind == CHAOTIC and _far(before, after, lambda _a, _unit, room=rule.share * largest: room):
                found.differences.append(f"{where}, further than {rule.share:g} of the column's largest")
            if rule.kind == CONVERGING and (NUMBER.sub("#", before) != NUMBER.sub("#", after) or _far(before, after, _close)):
                found.differences.append(where)


def _close(value: float, unit: float) -> float:
    return max(CONVERGED * abs(value), 1.01 * unit, TINY)


def _far(before: str, after: str, room: Callable[[float, float], float]) -> bool:
    pairs = zip(numbers(before), numbers(after), strict=False)
    return any(abs(old - new) > room(old, unit) for (old, unit), (new, _) in pairs)


def numbers(text: str) -> list[tuple[float, float]]:
    """The numbers in a cell, each with the unit of its last printed digit."""
    found = []
    for each in NUMBER.findall(text):
        plain = each.replace("−", "-")
        mantissa, _, power = plain.partition("e")
        digits = len(mantissa.partition(".")[2])
        found.append((float(plain), 10.0 ** (int(power or 0) - digits)))
    return found


def _read(file: Path) -> list[list[str]]:
    with file.open(newline="", encoding="utf-8") as stream:
        return list(csv.reader(stream))


def stamp(folder: Path, study: str) -> None:
    """Note in made.json the hashes of what made the pages, and of the pages."""
    files = {file.name: digest(file.read_bytes()) for file in sorted(folder.iterdir()) if file.name != STAMP}
    text = json.dumps({"made by": source_hash(study), "files": files}, indent=1, ensure_ascii=False)
    (folder / STAMP).write_text(text + "\n", encoding="utf-8")


def stale(folder: Path, study: str) -> list[str]:
    """What does not fit to made.json: the sources, and files that were changed, added or lost; empty if all fits."""
    noted = json.loads((folder / STAMP).read_text(encoding="utf-8"))
    files = {file.name: digest(file.read_bytes()) for file in folder.iterdir() if file.name != STAMP}
    wrong = [name for name in sorted(files.keys() | noted["files"].keys()) if files.get(name) != noted["files"].get(name)]
    return [*wrong, *(["the sources of the study"] if noted["made by"] != source_hash(study) else [])]


def source_hash(study: str) -> str:
    """Hash of a study's code, without comments, docstrings and layout, and of its data; claims are compared, not made."""
    parts = [HERE / "tables.py", *sorted((HERE / study).rglob("*.py")), *sorted((HERE / study).rglob("paths/*.csv"))]
    return digest("\n".join(_meaning(part) for part in parts).encode())


def _meaning(file: Path) -> str:
    text = file.read_text(encoding="utf-8")
    if file.suffix != ".py":
        return text
    tree = ast.parse(text)
    for node in _documented(tree):
        node.body = node.body[1:] or [ast.Pass()]
    return ast.dump(tree)


def _documented(tree: ast.Module) -> Iterator[ast.Module | ast.ClassDef | ast.FunctionDef]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node) is not None:
            yield node


def digest(data: bytes) -> str:
    """A short hash."""
    return hashlib.sha256(data).hexdigest()[:16]
