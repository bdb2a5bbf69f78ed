"""The reference names every public name once, and every work that the code cites is in the list of literature."""

import inspect
import pydoc
import re
from collections import Counter
from pathlib import Path

import manipplan
from manipplan.results import ServoStatus, StepStatus

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"


def documented():
    """Full names of all entries and modules of the reference, with how often each is there: those described and those in lists."""
    names = []
    for page in sorted((DOCS / "reference").glob("*.md")):
        module = "manipplan"
        for kind, entry, listed in re.findall(
            r"^\.\. (currentmodule|module|auto\w+):: (\S+)$|^   ~?([\w.]+)$", page.read_text(encoding="utf-8"), re.MULTILINE
        ):
            name = entry or listed
            if "module" in kind:
                module = name
            if kind != "currentmodule":
                names.append(name if "." in name else f"{module}.{name}")
    return Counter(names)


def test_every_public_name_is_documented_once():
    found = documented()
    wanted = {f"manipplan.{name}" for name in manipplan.__all__ if not inspect.ismodule(getattr(manipplan, name))}
    for space in ("demo", "errors", "formulations", "measures", "planar", "results", "viz"):
        wanted |= {f"manipplan.{space}.{name}" for name in getattr(manipplan, space).__all__}
    assert {name: found[name] for name in wanted if found[name] != 1} == {}


def test_nothing_is_documented_that_is_not_there():
    assert [name for name in documented() if pydoc.locate(name) is None] == []


def test_every_reference_page_is_in_the_list():
    index = (DOCS / "reference" / "index.md").read_text(encoding="utf-8")
    pages = {page.stem for page in (DOCS / "reference").glob("*.md")} - {"index"}
    assert pages == set(re.findall(r"\((\w+)\.md\)", index))


def test_every_work_that_is_cited_is_in_the_literature():
    known = set(re.findall(r"^@\w+\{(\w+),", (DOCS / "references.bib").read_text(encoding="utf-8"), re.MULTILINE))
    sources = [*(ROOT / "manipplan").rglob("*.py"), *(ROOT / "studies").rglob("*.py")]
    pages = [page for page in DOCS.rglob("*.md") if "_build" not in page.parts]
    cited = {
        key for file in sources for key in re.findall(r"\[([a-z]+(?:19|20)\d\d[a-z]?)[\],]", file.read_text(encoding="utf-8"))
    }
    cited |= {
        key
        for page in pages
        for keys in re.findall(r"\{cite:\w\}`([^`]+)`", page.read_text(encoding="utf-8"))
        for key in keys.split(",")
    }
    assert len(cited) > 15
    assert cited <= known


def test_every_status_has_its_remedy_on_the_page():
    page = (DOCS / "howto" / "status.md").read_text(encoding="utf-8")
    tables = re.findall(r"\| (.*?) \| what .*\n\|[-|]+\n((?:\|.*\n)+)", page)
    steps = {kind: f"{{py:class}}`~manipplan.results.{kind.__name__}`" for kind in (StepStatus, ServoStatus)}
    for kind, wanted in (
        (manipplan.Status, lambda head: head not in steps.values()),
        *((kind, lambda head, name=name: head == name) for kind, name in steps.items()),
    ):
        rows = [row.split("|")[1:-1] for head, table in tables if wanted(head) for row in table.splitlines()]
        assert [row[0].strip(" `") for row in rows] == [each.name for each in kind]
        if hasattr(next(iter(kind)), "ok"):
            assert {row[0].strip(" `"): row[2].strip() == "yes" for row in rows} == {each.name: each.ok for each in kind}
