"""The built site in a real browser: readable by all, on a phone and on a wide screen, in light and dark, and without a network.

`make docs` builds the site and runs these; MANIPPLAN_SITE names a site that was built elsewhere.
"""

import os
from pathlib import Path

import pytest

pytestmark = pytest.mark.site
SITE = Path(os.environ.get("MANIPPLAN_SITE", Path(__file__).parents[2] / "docs" / "_build" / "html"))
#: One of each kind: start, a concept with formulas and pictures, a recipe, the gallery, one of its pages, a study, the reference.
SAMPLE = (
    "index.html",
    "start.html",
    "concepts/tracking.html",
    "howto/status.html",
    "gallery/index.html",
    "gallery/plot_measures.html",
    "studies/kth2012.html",
    "reference/jobs.html",
    "benchmarks.html",
)
#: WCAG's level AA asks 4.5 to 1 of text; axe calls what bars readers serious or critical.
GRAVE = {"serious", "critical"}


def pages():
    """Every page of the site, by its name; a missing site is a failure of the first test, not a quiet nothing."""
    return sorted(file.relative_to(SITE).as_posix() for file in SITE.rglob("*.html") if "_static" not in file.parts)


@pytest.fixture(scope="module")
def browser():
    playwright = pytest.importorskip("playwright.sync_api")
    import shutil

    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    assert program, "no Chromium was found: make browser"
    with playwright.sync_playwright() as engine:
        chromium = engine.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield chromium
        chromium.close()


@pytest.fixture
def open_page(browser):
    """Opens a page of the site from its file, and fails where it asks another machine for something or logs an error."""
    contexts, asked, logged = [], [], []

    def open_(name, *, width=1280, scheme="light"):
        context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)
        contexts.append(context)
        page = context.new_page()
        page.on("request", lambda request: asked.append(request.url) if request.url.startswith("http") else None)
        page.on("console", lambda message: logged.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: logged.append(str(error)))
        page.goto((SITE / name).as_uri())
        return page

    yield open_
    for context in contexts:
        context.close()
    assert asked == []
    assert logged == []


def test_the_site_is_built():
    assert {*SAMPLE, "search.html", "literature.html"} <= {*pages()}, f"build the site first: make docs ({SITE})"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", SAMPLE)
def test_axe_finds_nothing_grave(open_page, name, scheme):
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(open_page(name, scheme=scheme)).response
    assert found["passes"], "axe did not run"
    grave = [each for each in found["violations"] if each["impact"] in GRAVE]
    told = [f"{each['id']}: {node['html'][:160]} {node['failureSummary']}" for each in grave for node in each["nodes"][:4]]
    assert not told, "\n".join(told)


@pytest.mark.parametrize("width", [390, 1600])
def test_no_page_is_wider_than_the_screen(browser, width):
    context = browser.new_context(viewport={"width": width, "height": 900})
    page = context.new_page()
    wide = {}
    for name in pages():
        page.goto((SITE / name).as_uri())
        got = page.evaluate("document.documentElement.scrollWidth")
        if got > width:
            wide[name] = got
    context.close()
    assert wide == {}


def test_search_works_from_files(open_page):
    page = open_page("search.html")
    page.goto(f"{(SITE / 'search.html').as_uri()}?q=clearance")
    page.wait_for_selector("#search-results li a", timeout=15000)
    targets = page.eval_on_selector_all("#search-results li a", "links => links.map(link => link.href)")
    assert any("howto/clearance.html" in target for target in targets)
    assert all(target.startswith("file:") for target in targets)


def test_formulas_are_drawn_without_a_script(browser):
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    page = context.new_page()
    page.goto((SITE / "concepts/tracking.html").as_uri())
    sizes = page.eval_on_selector_all("math[display=block]", "all => all.map(each => [each.offsetWidth || each.getBoundingClientRect().width, each.getBoundingClientRect().height])")  # fmt: skip
    context.close()
    assert len(sizes) >= 2
    assert all(width > 100 and height > 15 for width, height in sizes)
