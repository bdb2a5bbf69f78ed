"""Every item of the papers with its verdict, as a page: `python -m studies.checklist`.

checklist.csv has a row per item: what is printed, our value and its class (exact, converged, chaotic) where a claim of a study
has them, the verdict, a file and a text in it that shows the item, and a note.
"""

import csv
from collections import Counter
from pathlib import Path

from studies.tables import Table

HERE = Path(__file__).parent
ROOT = HERE.parent
FILE = HERE / "checklist.csv"
PAGES = ROOT / "docs" / "studies" / "papers"
VERDICTS = {
    "reproduced": "ours agrees with the print",
    "in part": "holds with a limit that the note names",
    "contradicted": "computation contradicts the print",
    "misprint": "the print is wrong, and what it should be is clear",
    "beyond the paper": "our own question",
    "nothing to compute": "a photograph, a definition without consequence",
    "not done": "we have no answer; the note says why",
}
CLASSES = ("", "exact", "converged", "chaotic")
PAPERS = ("kth2012", "dufour2020", "guilamo2006")


def items() -> list[dict[str, str]]:
    """The rows of checklist.csv."""
    with FILE.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def summary_table() -> Table:
    """Number of items by paper and verdict."""
    counts = {paper: Counter(row["verdict"] for row in items() if row["paper"] == paper) for paper in PAPERS}
    rows = [
        (verdict, meaning, *(counts[paper][verdict] for paper in PAPERS), sum(counts[paper][verdict] for paper in PAPERS))
        for verdict, meaning in VERDICTS.items()
    ]
    rows.append(("all", "", *(counts[paper].total() for paper in PAPERS), sum(each.total() for each in counts.values())))
    return Table.of("summary", ("verdict", "meaning", *PAPERS, "all"), rows)


def paper_table(paper: str) -> Table:
    """The items of one paper."""
    rows = [
        tuple(_safe(row[name]) for name in ("item", "where", "printed", "ours", "class", "verdict", "evidence"))
        for row in items()
        if row["paper"] == paper
    ]
    return Table.of(paper, ("item", "where", "printed", "ours", "class", "verdict", "note"), rows)


def tables() -> list[Table]:
    """All tables of the page."""
    return [summary_table(), *(paper_table(paper) for paper in PAPERS)]


def faults(rows: list[dict[str, str]]) -> list[str]:
    """Rows whose verdict, class, number or page is not what it says."""
    kept = {paper: _expected(paper) for paper in PAPERS}
    wrong = []
    for number, row in enumerate(rows, start=2):
        name = f"line {number}, {row['paper']}, {row['item']}"
        if row["verdict"] not in VERDICTS or row["class"] not in CLASSES:
            wrong.append(f"{name}: verdict {row['verdict']!r}, class {row['class']!r}")
        if row["claim"]:
            claim = kept[row["paper"]].get(row["claim"])
            if claim is None:
                wrong.append(f"{name}: no claim {row['claim']!r}")
            elif abs(float(row["ours"]) - claim[0]) > claim[1] or row["class"] != claim[2]:
                wrong.append(f"{name}: {row['ours']}, {row['class']}; expected {claim[0]:g}, {claim[2]}")
        if row["verdict"] == "nothing to compute":
            continue
        page = ROOT / row["page"]
        if not row["page"] or not row["shows"] or not page.is_file():
            wrong.append(f"{name}: no page or no text {row['page']!r}, {row['shows']!r}")
        elif row["shows"] not in " ".join(page.read_text(encoding="utf-8").split()):
            wrong.append(f"{name}: {row['page']} does not show {row['shows']!r}")
    return wrong


def _expected(paper: str) -> dict[str, tuple[float, float, str]]:
    """Value, tolerance and class of each claim of a study."""
    with (HERE / paper / "expected.csv").open(newline="", encoding="utf-8") as file:
        return {
            row.get("figure") or row["claim"]: (float(row["ours"]), float(row["tolerance"]), row["class"])
            for row in csv.DictReader(file)
        }


def _safe(text: str) -> str:
    return text.replace("|", "\\|")


if __name__ == "__main__":
    PAGES.mkdir(exist_ok=True)
    for table in tables():
        table.write(PAGES)
