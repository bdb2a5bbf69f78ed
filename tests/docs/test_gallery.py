"""The gallery as files: what is there, what it may use, and that its times were measured. `make docs` runs the pages."""

import ast
import re
from pathlib import Path

import pytest

import manipplan as mp
from manipplan import planar, viz

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "docs" / "examples"
PAGES = sorted(EXAMPLES.glob("**/plot_*.py"))
PUBLIC = {"manipplan": mp, "manipplan.planar": planar, "manipplan.viz": viz}
PUBLIC |= {f"manipplan.{name}": getattr(mp, name) for name in ("demo", "errors", "formulations", "measures", "results")}


def name_of(page):
    return page.relative_to(EXAMPLES).with_suffix("").as_posix()


def test_there_are_enough_pages_and_every_section_says_what_it_is():
    assert len(PAGES) >= 12
    for folder in {page.parent for page in PAGES}:
        title, line, *rest = (folder / "README.rst").read_text().splitlines()
        assert set(line) <= set("=-") and len(line) == len(title)
        assert "".join(rest).strip()


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_a_page_uses_public_names_only(page):
    tree = ast.parse(page.read_text())
    modules = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name.split(".")[0] == "manipplan":
                    assert (alias.name, alias.asname) == ("manipplan", "mp")
                    modules["mp"] = mp
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "manipplan":
            for alias in node.names:
                assert hasattr(PUBLIC[node.module], alias.name)
                if f"{node.module}.{alias.name}" in PUBLIC:
                    modules[alias.name] = PUBLIC[f"{node.module}.{alias.name}"]
    assert modules
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in modules:
            assert node.attr in modules[node.value.id].__all__, f"{node.value.id}.{node.attr}"


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_a_page_has_a_title_text_and_a_picture(page):
    tree = ast.parse(page.read_text())
    title, line, *rest = (ast.get_docstring(tree) or "").splitlines()
    assert line == "=" * len(title)
    assert len(" ".join(rest)) > 80
    assert page.read_text().count("# %%") >= 3
    assert re.search(r"plt\.|viz\.", page.read_text())


def test_the_times_of_all_pages_were_measured():
    table = (ROOT / "docs" / "benchmarks" / "gallery.md").read_text()
    times = {name: float(time) for name, time in re.findall(r"\| (\S+/plot_\w+) \| ([\d.]+) \|", table)}
    assert set(times) == {name_of(page) for page in PAGES}
    assert max(times.values()) < 20
