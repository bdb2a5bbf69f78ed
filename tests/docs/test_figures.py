"""Numbers in prose are those of the tables in docs/benchmarks, and no page states others by hand."""

import re
import runpy
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FIGURES = runpy.run_path(str(ROOT / "docs" / "figures.py"))
SENTENCES = FIGURES["sentences"]()
PAGES = list(dict.fromkeys(each.page for each in SENTENCES))
#: The part of a page that states results, and what it says that no table holds: settings, properties and rounded statements.
STATED = {
    "README.md": ("## Measured", "## Limits", set()),
    "docs/benchmarks.md": ("## Ten headline figures", "## Eight chapters", {"10 mm", "10 ms"}),
    "docs/measured/kinematics.md": ("# Measured", "## Kinematics", set()),
    "docs/measured/plans.md": ("# Measured", "## Panda among five boxes", set()),
    "docs/measured/servo.md": ("# Measured", "## Servoing near singularities", set()),
    "docs/concepts/which-job.md": ("The jobs promise", "Two examples", set()),
    "docs/limits.md": ("# Limits", "## Which other tool", {"17 mm", "46 mm", "215 mm"}),
}


@pytest.fixture
def pages(tmp_path):
    """A folder with a copy of each page."""
    for page in PAGES:
        (tmp_path / page).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / page, tmp_path / page)
    return tmp_path


def test_numbers_of_the_pages_are_those_of_the_tables(pages):
    assert FIGURES["write"](pages) == [], "run: make figures"


@pytest.mark.parametrize("sentence", SENTENCES, ids=lambda each: each.words[:50])
def test_a_number_that_disagrees_is_found(sentence, pages):
    file = pages / sentence.page
    before = file.read_text()
    begin, end = sentence.pattern.search(before).span(1)
    file.write_text(f"{before[:begin]}98765{before[end:]}")
    assert FIGURES["write"](pages) == [sentence.page]
    assert file.read_text() == before


def test_a_sentence_that_its_page_no_longer_has_is_an_error(pages):
    file = pages / "README.md"
    file.write_text(file.read_text().replace("mplib", "another planner"))
    with pytest.raises(SystemExit, match="README.md has this sentence 0 times"):
        FIGURES["write"](pages)


@pytest.mark.parametrize("page", STATED)
def test_no_result_is_written_by_hand(page):
    begin, end, allowed = STATED[page]
    content = (ROOT / page).read_text()
    part = content[content.index(begin) : content.index(end)]
    for each in SENTENCES:
        if each.page == page:
            part = each.pattern.sub("", part)
    found = {match.group() for match in FIGURES["CLAIM"].finditer(part)}
    assert found - allowed == set()
    assert allowed <= found


def test_film_and_text_of_the_start_page_show_one_problem():
    """The report on the start page is that of the film of the first page."""
    caption = re.search(r"planner (\d\.\d+), manipplan (\d\.\d+) m⁶", (ROOT / "README.md").read_text())
    report = re.search(r"minimum m +(\d\.\d+) m\^6 \(yoshikawa; seed (\d\.\d+)", (ROOT / "docs" / "start.md").read_text())
    assert [f"{float(value):.4f}" for value in report.groups()[::-1]] == list(caption.groups())
