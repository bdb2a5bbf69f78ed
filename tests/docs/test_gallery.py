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


#: Functions whose result has a status.
MOTION = {"plan", "optimize_path", "follow", "track", "sequence", "carry", "improve", "max_min_search"}


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


@pytest.mark.parametrize("page", sorted(EXAMPLES.glob("**/[pl]*.py")), ids=name_of)
def test_a_page_begins_with_its_picture_and_says_for_whom(page):
    """The picture of a page is the one that the page draws, or a still that `make pictures` renders.

    It is also the thumbnail, or the thumbnail is one of its plots.
    """
    text = page.read_text()
    _, _, blank, first, *rest = (ast.get_docstring(ast.parse(text)) or "").splitlines()
    [picture] = re.findall(r"^\.\. image:: (\S+)$", first)
    assert blank == "" and rest[0].startswith("   :alt: ") and len(rest[0]) > 40
    assert rest[rest.index("") + 1].startswith("*For "), "the sentence after the picture"
    if picture.startswith("/"):
        assert f'# sphinx_gallery_thumbnail_path = "{picture[1:]}"' in text
        assert (ROOT / "docs" / picture[1:]).stat().st_size < 100_000
    else:
        assert re.fullmatch(rf"images/sphx_glr_{page.stem}_\d{{3}}\.png", picture)
        thumbnail = re.findall(r'sphinx_gallery_thumbnail_path = "(\S+)"', text)
        assert thumbnail in ([], [f"pictures/{page.stem.removeprefix('plot_')}.jpg"])


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_a_page_asserts_its_status_and_a_number(page):
    tree = ast.parse(page.read_text())
    asserted = [node.test for node in ast.walk(tree) if isinstance(node, ast.Assert)]
    values = [node for test in asserted for node in ast.walk(test)]
    assert any(isinstance(node, ast.Constant) and isinstance(node.value, float | int) for node in values)
    if MOTION & {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}:
        assert {"status", "passed"} & {node.attr for node in values if isinstance(node, ast.Attribute)}


def test_the_times_of_all_pages_were_measured():
    table = (ROOT / "docs" / "benchmarks" / "gallery.md").read_text()
    times = {name: float(time) for name, time in re.findall(r"\| (\S+/plot_\w+) \| ([\d.]+) \|", table)}
    assert set(times) == {name_of(page) for page in PAGES}
    assert max(times.values()) < 20


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_a_page_does_not_begin_with_an_empty_block(page):
    """A comment for the gallery alone is not shown, but its block is."""
    _, _, first = re.split(r"(?m)^# %%", page.read_text())[0].split('"""', 2)
    lines = first.split("\n")
    assert not any(lines) or any(line and not line.startswith("#") for line in lines)
