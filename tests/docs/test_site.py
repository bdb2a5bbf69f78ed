"""The built site in a real browser: readable by all, on a phone and on a wide screen, in light and dark, and without a network.

`make docs` builds the site and runs these; MANIPPLAN_SITE names a site that was built elsewhere.
"""

import html
import os
import re
import unicodedata
from pathlib import Path

import nbformat
import pytest
from axe_playwright_python.sync_playwright import Axe
from fontTools.ttLib import TTFont
from nbclient import NotebookClient

pytestmark = pytest.mark.site
SITE = Path(os.environ.get("MANIPPLAN_SITE", Path(__file__).parents[2] / "docs" / "_build" / "html"))
#: One of each kind: start, a concept with formulas and pictures, a recipe, the gallery, one of its pages, a study, the reference.
SAMPLE = (
    "index.html",
    "start.html",
    "concepts/tracking.html",
    "howto/status.html",
    "gallery/index.html",
    next(
        (file.relative_to(SITE).as_posix() for file in sorted(SITE.glob("gallery/**/plot_*.html"))),
        "gallery/plot_first_plan.html",
    ),
    "studies/kth2012-paths.html",
    "studies/planar-arm.html",
    "reference/jobs.html",
    "reference/api/manipplan.plan.html",
    "reference/api/manipplan.Scene.html",
    "benchmarks.html",
    "tutorials/cell.html",
    "other-tools.html",
)
#: WCAG's level AA asks 4.5 to 1 of text; axe calls what bars readers serious or critical.
GRAVE = {"serious", "critical"}
FLAGS = "--no-sandbox"
FONT = "Manipplan Formulas"
#: Tallest page but those of the reference, on a screen of that width [px]. What is taller is cut into chapters.
TALLEST, TALL_AT = 12_000, 1400
#: Examples whose notebooks are run: the fastest of each section.
NOTEBOOKS = ("trajectory_files", "singular", "all_solutions", "lerobot", "own_measure", "certificate")
#: Width and height of a page, with what its text is wider than its column: furo scrolls that inside, where the page hides it.
SIZE = """() => {
    const root = document.documentElement, text = document.querySelector(".content");
    return [root.scrollWidth + (text ? text.scrollWidth - text.clientWidth : 0), root.scrollHeight];
}"""
#: Number of parts in which all pages are visited, beside each other.
PARTS = 6
#: What a search is for, and the page that it shows first.
FOUND_FIRST = {
    "singularity": "concepts/singularities.html",
    "manipulability": "concepts/measures.html",
    "time limit": "concepts/how-it-plans.html",
    "collision": "concepts/collisions.html",
    "inverse kinematics": "concepts/kinematics.html",
    "joint limits": "concepts/timing.html",
    "units": "concepts/frames-and-units.html",
    "plan": "reference/api/manipplan.plan.html",
    "PoseGoal": "reference/api/manipplan.PoseGoal.html",
}


def pages():
    """Every page of the site, by its name; a missing site is a failure of the first test, not a quiet nothing."""
    return sorted(file.relative_to(SITE).as_posix() for file in SITE.rglob("*.html") if "_static" not in file.parts)


@pytest.fixture
def open_page(browser):
    """Opens a page of the site from its file."""
    contexts = []

    def open_(name="index.html", *, width=1280, scheme="light"):
        contexts.append(browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme))
        page = contexts[-1].new_page()
        page.goto((SITE / name).as_uri())
        return page

    yield open_
    for context in contexts:
        context.close()


def test_the_site_is_built():
    assert {*SAMPLE, "search.html", "literature.html"} <= {*pages()}, f"build the site first: make docs ({SITE})"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", SAMPLE)
def test_axe_finds_nothing_grave(open_page, name, scheme):
    found = Axe().run(open_page(name, scheme=scheme)).response
    assert found["passes"], "axe did not run"
    grave = [each for each in found["violations"] if each["impact"] in GRAVE]
    told = [f"{each['id']}: {node['html'][:160]} {node['failureSummary']}" for each in grave for node in each["nodes"][:4]]
    assert not told, "\n".join(told)


@pytest.mark.parametrize("part", range(PARTS))
def test_every_page_fits_the_screen_and_asks_no_other_machine(open_page, part):
    """On a narrow screen and a wide one, and none is too tall to survey."""
    page = open_page()
    asked, logged, wide, heights = [], [], [], {}
    page.on("request", lambda request: asked.append(request.url) if request.url.startswith("http") else None)
    page.on("console", lambda message: logged.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: logged.append(str(error)))
    for name in pages()[part::PARTS]:
        page.goto((SITE / name).as_uri())
        for width in (390, TALL_AT, 1600):
            page.set_viewport_size({"width": width, "height": 900})
            size = page.evaluate(SIZE)
            if size[0] > width:
                wide.append((name, *size))
            if width == TALL_AT:
                heights[name] = size[1]
    assert wide == []
    assert asked == []
    assert logged == []
    assert max(heights.values()) > 900
    assert {name: got for name, got in heights.items() if got > TALLEST and not name.startswith("reference/")} == {}


def test_search_works_from_files(open_page):
    page = open_page("search.html")
    page.goto(f"{(SITE / 'search.html').as_uri()}?q=clearance")
    page.wait_for_selector("#search-results li a", timeout=15000)
    targets = page.eval_on_selector_all("#search-results li a", "links => links.map(link => link.href)")
    assert any("howto/clearance.html" in target for target in targets)
    assert all(target.startswith("file:") for target in targets)


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebooks_run_where_nothing_else_is(name, tmp_path):
    """What a reader downloads from an example's page, run by Jupyter's kernel in an empty folder."""
    [file] = SITE.glob(f"_downloads/*/plot_{name}.ipynb")
    notebook = nbformat.read(file, as_version=4)
    NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown = [each for cell in notebook.cells for each in cell.get("outputs", [])]
    assert [each["text"] for each in shown if each.get("name") == "stderr"] == []
    assert any("image/png" in each.get("data", {}) for each in shown)


def test_examples_print_values_instead_of_truths(open_page):
    page, found = open_page(), {}
    for name in pages():
        if name.startswith("gallery/"):
            page.goto((SITE / name).as_uri())
            printed = page.eval_on_selector_all(".sphx-glr-script-out", "blocks => blocks.map(block => block.innerText)")
            found[name] = [each for each in printed if re.search(r"\b(True|False|None)\b", each)]
    assert len(found) > 20
    assert {name: each for name, each in found.items() if each} == {}


def test_concepts_are_found_first(open_page):
    page = open_page("search.html")
    first = {}
    for query in FOUND_FIRST:
        page.goto(f"{(SITE / 'search.html').as_uri()}?q={query}")
        page.wait_for_selector("#search-results li a", timeout=15000)
        page.wait_for_function("document.querySelector('#search-results p.search-summary')?.innerText.includes('finished')")
        link = page.eval_on_selector("#search-results li a", "link => link.href")
        first[query] = link.split("#")[0].split("?")[0].removeprefix(SITE.as_uri() + "/")
    assert first == FOUND_FIRST


@pytest.mark.parametrize("name", [name for name in pages() if name.startswith("reference/")])
def test_signatures_say_what_is_returned_in_names_that_can_be_read(name):
    """The types are those of the source: NumPy's array-like is one name, not the union that it stands for."""
    page = (SITE / name).read_text(encoding="utf-8")
    calls = re.findall(r'<dl class="py (?:function|method)">\n<dt class="sig.*?</dt>', page, re.DOTALL)
    assert [call for call in calls if "sig-return" not in call and "__init__" not in call] == []
    assert not re.search(r"_SupportsArray|_NestedSequence|pinocchio_pywrap", re.sub(r"<[^>]+>", "", page))


def test_formulas_are_drawn(open_page):
    page = open_page("concepts/tracking.html")
    script = "all => all.map(each => each.getBoundingClientRect()).map(box => [box.width, box.height])"
    sizes = page.eval_on_selector_all("math[display=block]", script)
    assert len(sizes) >= 2
    assert all(width > 100 and height > 15 for width, height in sizes)
    assert page.eval_on_selector_all("script[src*=mathjax], merror", "all => all.length") == 0


def test_formulas_have_their_font_with_all_their_letters(open_page):
    page = open_page("concepts/tracking.html")
    page.evaluate("document.fonts.ready.then(() => 0)")
    assert page.evaluate("[...document.fonts].map(font => [font.family, font.status])") == [[FONT, "loaded"]]
    font = TTFont(SITE / "_static" / "fonts" / "formulas.woff")
    assert "MATH" in font
    letters = set()
    for name in pages():
        for formula in re.findall(r"<math.*?</math>", (SITE / name).read_text(encoding="utf-8"), re.DOTALL):
            letters |= set(html.unescape(re.sub(r"<[^>]+>", "", formula)))
    assert len(letters) > 50
    seen = {letter for letter in letters if unicodedata.category(letter) not in ("Cf", "Cc", "Zs")}  # those that are drawn
    assert {letter for letter in seen if ord(letter) not in font.getBestCmap()} == set()
