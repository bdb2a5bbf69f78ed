"""The interactive planar page in a real browser: its numbers are manipplan's, and everything on it can be used."""

import importlib.util
import json
import re
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.measures.ellipsoid import force_ellipsoid, velocity_ellipsoid

DOCS = Path(__file__).parents[2] / "docs"
PAGE = DOCS / "_static" / "planar.html"
FLAGS = "--no-sandbox --disable-gpu --disable-background-networking --no-first-run --disable-component-update --disable-sync"
UNIT = (1.0, 1.0, 1.0)
DIGIT = 0.5001e-4  # half of the last digit shown


@pytest.fixture
def open_page(browser):
    """Opens the page; whatever it says on the console or asks for from elsewhere is an error at the end."""
    said, asked, pages = [], [], []

    def open_(width=1400, **options):
        page = browser.new_page(viewport={"width": width, "height": 900}, **options)
        page.on("console", lambda message: said.append(message.text))
        page.on("pageerror", lambda error: said.append(str(error)))
        page.on("request", lambda request: asked.append(request.url))
        page.goto(PAGE.as_uri())
        pages.append(page)
        return page

    yield open_
    for page in pages:
        page.close()
    assert said == []
    assert {url for url in asked if not url.startswith("data:")} == {PAGE.as_uri()}


@pytest.fixture
def page(open_page):
    return open_page()


@pytest.fixture(scope="module")
def script():
    spec = importlib.util.spec_from_file_location("make_planar_page", DOCS / "make_planar_page.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def data(script):
    return json.loads(script.BLOCK.search(PAGE.read_text(encoding="utf-8"))[0].split("\n")[1])


def values(page, name):
    return [float(word) for word in page.text_content(f"#n-{name}").replace("−", "-").replace("∞", "inf").split()]


def value(page, name):
    [only] = values(page, name)
    return only


def angles(page):
    shown = [page.text_content(f"#o-t{i}").replace("−", "-") for i in (1, 2, 3)]
    return np.array([float(text.split()[0]) for text in shown])


def put(page, lengths, q):
    for name, numbers in (("l", lengths), ("t", q)):
        for i, number in enumerate(numbers, start=1):
            page.fill(f"#{name}{i}", str(number))


def kinematics(lengths=UNIT):
    return mp.planar_arm(lengths).kinematics()


def centre(page, selector):
    box = page.locator(f"{selector} .ring").bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag(page, selector, dx, dy):
    x, y = centre(page, selector)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + dx, y + dy, steps=12)
    page.mouse.up()


def pixels_per_metre(page):
    """From the length of the bar of 1 m, on the screen."""
    return page.evaluate("document.querySelector('#arm path[d^=\"M14 390\"]').getBoundingClientRect().width")


def image(page):
    return page.inner_html("#arm")


def test_it_is_one_small_file_that_asks_for_nothing(page):
    text = PAGE.read_text(encoding="utf-8")
    assert len(text.encode()) < 60_000
    assert {part.split('"')[0] for part in text.split("http://")[1:]} == {"www.w3.org/2000/svg"}
    assert "https:" not in text
    shot = page.screenshot()
    assert len(shot) > 50_000
    put(page, UNIT, (0.5, -1.2, 2.0))
    assert page.screenshot() != shot


@pytest.mark.parametrize(
    ("lengths", "q"),
    [
        (UNIT, (0.0, 0.78, 1.13)),
        (UNIT, (0.0, -3.0, -2.0)),
        (UNIT, (-1.4, 0.0, 0.0)),
        (UNIT, (0.3, 0.01, 3.14)),
        ((0.5, 1.35, 0.8), (2.2, 1.9, -0.7)),
        ((2.0, 0.2, 1.0), (-2.95, -1.31, 2.6)),
    ],
)
def test_numbers_and_ellipses_are_those_of_the_library(page, lengths, q):
    put(page, lengths, q)
    arm = kinematics(lengths)
    jacobian, pose = arm.jacobian(q), arm.pose(q)
    sigma = np.linalg.svd(jacobian, compute_uv=False)
    minors = [np.linalg.det(jacobian[:, columns]) for columns in ([0, 1], [0, 2], [1, 2])]
    expected = {
        "mu": arm.manipulability(q),
        "kappa": mp.planar_arm(lengths).kinematics(measure="inverse_condition").manipulability(q),
        "s1": sigma[0],
        "s2": sigma[1],
        "fro": np.linalg.norm(jacobian) / np.sqrt(2),
        "m12": minors[0],
        "m13": minors[1],
        "m23": minors[2],
        "x": pose[0, 3],
        "y": pose[1, 3],
        "r": np.hypot(pose[0, 3], pose[1, 3]),
        "phi": np.arctan2(pose[1, 0], pose[0, 0]),
    }
    for name, number in expected.items():
        assert abs(value(page, name) - number) < DIGIT, name
    np.testing.assert_allclose([values(page, "jx"), values(page, "jy")], jacobian, rtol=0, atol=10 * DIGIT)

    scale = page.evaluate("document.querySelector('#arm path[d^=\"M14 390\"]').getBBox().width * 0.5")
    for name, ellipsoid in (("velocity", velocity_ellipsoid(jacobian)), ("force", force_ellipsoid(jacobian))):
        get = page.locator(f"#{name}").get_attribute
        turn = -np.radians(float(get("transform").split("(")[1].split()[0]))
        radii = np.array([float(get("rx")), float(get("ry"))]) / scale
        shown = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        shape = shown @ np.diag(radii**2) @ shown.T  # of the ellipse, whatever the order of its axes
        if np.isfinite(ellipsoid.radii).all() and ellipsoid.radii[0] < 50:
            truth = ellipsoid.axes @ np.diag(ellipsoid.radii**2) @ ellipsoid.axes.T
            np.testing.assert_allclose(shape, truth, rtol=0, atol=1e-6 * ellipsoid.radii[0] ** 2)
        else:  # drawn far beyond the picture
            assert radii[1] > 50


def test_a_slider_moves_the_arm_by_keys(page):
    before, mu = image(page), value(page, "mu")
    page.focus("#t2")
    for _ in range(20):
        page.keyboard.press("ArrowRight")
    assert abs(angles(page)[1] - 0.98) < 1e-9
    assert value(page, "mu") < mu - 0.01
    assert image(page) != before


@pytest.mark.parametrize("keep", [True, False])
def test_a_dragged_tool_goes_there(page, keep):
    page.set_checked("#keep", keep)
    put(page, UNIT, (0.2, 0.9, 0.8))
    x, y, phi, scale = value(page, "x"), value(page, "y"), value(page, "phi"), pixels_per_metre(page)
    for dx, dy in ((0.5, -0.6), (-1.4, 0.2), (0.1, -0.5)):
        drag(page, "#tool", dx * scale, -dy * scale)
        x, y = x + dx, y + dy
        assert np.hypot(value(page, "x") - x, value(page, "y") - y) < 2e-3
        if keep:
            assert abs(value(page, "phi") - phi) < DIGIT * 2
        pose = kinematics().pose(angles(page))
        assert np.hypot(pose[0, 3] - x, pose[1, 3] - y) < 5e-3
    assert keep == (abs(value(page, "phi") - phi) < 1e-3)


@pytest.mark.parametrize("keep", [True, False])
def test_a_tool_dragged_out_of_reach_stretches_the_arm_and_comes_back(page, keep):
    page.set_checked("#keep", keep)
    put(page, UNIT, (0.2, 0.9, 0.8))
    scale = pixels_per_metre(page)
    drag(page, "#tool", (3.3 - value(page, "x")) * scale, 0)
    assert value(page, "r") > 2.995
    drag(page, "#tool", -1.5 * scale, 0)
    assert abs(value(page, "r") - 1.8) < 0.3
    put(page, (2.0, 0.5, 0.5), (0.0, 2.0, 0.5))  # a hole of 1 m around the base
    scale = pixels_per_metre(page)
    drag(page, "#tool", -value(page, "x") * scale, value(page, "y") * scale)
    assert 1 - DIGIT < value(page, "r") < 1.01


def test_joints_can_be_dragged(page):
    put(page, UNIT, (0.0, 0.0, 1.0))
    scale = pixels_per_metre(page)
    drag(page, "#joint2", -scale, -scale)  # from (1, 0) to (0, 1)
    np.testing.assert_allclose(angles(page), [np.pi / 2, 0, 1], atol=2e-3)
    drag(page, "#joint3", scale, scale)  # from (0, 2) to (1, 1)
    np.testing.assert_allclose(angles(page), [np.pi / 2, -np.pi / 2, 1], atol=2e-3)
    x, y = centre(page, "#turn")
    tool = centre(page, "#tool")
    drag(page, "#turn", tool[0] - x + 2 * scale, tool[1] - y + np.sin(1) * scale)  # to the height of joint 3
    np.testing.assert_allclose(angles(page), [np.pi / 2, -np.pi / 2, 0], atol=2e-3)


def test_the_map_sets_two_angles(page):
    box = page.locator("#plot").bounding_box()

    def place(a, b):
        return (box["x"] + box["width"] * (a / 2 / np.pi + 0.5), box["y"] + box["height"] * (0.5 - b / 2 / np.pi))

    put(page, UNIT, (0.4, 0.5, 1.0))
    before = page.screenshot()
    np.testing.assert_allclose(centre(page, "#dot"), place(0.5, 1.0), atol=0.6)
    drag(page, "#dot", *np.subtract(place(-1.7, 2.2), place(0.5, 1.0)))
    np.testing.assert_allclose(angles(page), [0.4, -1.7, 2.2], atol=2e-3)
    assert abs(value(page, "mu") - kinematics().manipulability([0.4, -1.7, 2.2])) < 5e-3
    page.mouse.click(*place(2.0, -0.5))
    np.testing.assert_allclose(angles(page), [0.4, 2.0, -0.5], atol=2e-3)
    assert page.screenshot() != before


def test_a_finger_taps_the_map_and_drags_the_dot(open_page):
    page = open_page(360, has_touch=True)
    page.locator("#plot").scroll_into_view_if_needed()
    box = page.locator("#plot").bounding_box()
    page.touchscreen.tap(round(box["x"] + box["width"] * 0.75), round(box["y"] + box["height"] * 0.75))
    np.testing.assert_allclose(angles(page)[1:], [np.pi / 2, -np.pi / 2], atol=0.03)
    assert page.evaluate("getComputedStyle(document.getElementById('dot')).touchAction") == "none"
    assert page.evaluate("getComputedStyle(document.getElementById('plot')).touchAction") != "none"


def test_handles_move_by_keys(page):
    put(page, UNIT, (0.2, 0.9, 0.8))
    x, y = value(page, "x"), value(page, "y")
    page.focus("#tool")
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("ArrowUp")
    np.testing.assert_allclose([value(page, "x"), value(page, "y")], [x - 0.05, y + 0.05], atol=2 * DIGIT)
    put(page, UNIT, (0.2, 0.9, 0.8))
    page.focus("#dot")
    page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("ArrowDown")
    np.testing.assert_allclose(angles(page), [0.2, 0.91, 0.75], atol=1e-9)


def test_the_map_shows_another_index_and_the_same_radius(page):
    mu = page.screenshot()
    page.check("#what-kappa")
    kappa = page.screenshot()
    page.check("#same")
    assert len({mu, kappa, page.screenshot()}) == 3


def test_limits_hold_for_all_that_moves(page):
    put(page, UNIT, (0.2, 2.8, -2.0))
    page.check("#limits")
    np.testing.assert_allclose(angles(page), [0.2, 1.571, -1.571], atol=1e-9)
    scale = pixels_per_metre(page)
    for keep in (True, False):
        page.set_checked("#keep", keep)
        for dx, dy in ((-2.0, -1.0), (3.0, 2.0), (-1.0, 1.5)):
            drag(page, "#tool", dx * scale, dy * scale)
            assert np.abs(angles(page)).max() <= 1.5711
    page.click("#best")
    np.testing.assert_allclose(np.abs(angles(page)[1:]), [0.780, 1.132], atol=1e-9)  # the optimum is inside, section 5.4
    page.select_option("#preset", label="singular: zigzag")
    assert not page.is_checked("#limits")
    assert page.text_content("#status").startswith("Singular")


def test_the_presets_hold_table_5_1_and_singular_postures(page):
    page.select_option("#preset", label="largest μ (Table 5.1)")
    shown = (value(page, "r"), *angles(page)[1:], value(page, "mu"))
    assert [f"{number:.2f}" for number in shown] == ["2.15", "0.78", "1.13", "2.63"]
    labels = [text for text in page.locator("#preset option").all_text_contents() if text.startswith("singular")]
    assert len(labels) == 4
    for label in labels:
        page.select_option("#preset", label=label)
        assert value(page, "mu") == 0
        assert value(page, "s2") == 0
        assert kinematics().manipulability(angles(page)) < 5e-3


@pytest.mark.parametrize(("lengths", "limited"), [((1.0, 0.6, 1.4), False), ((2.0, 1.5, 0.5), False), ((0.5, 0.7, 2.0), True)])
def test_the_largest_index_for_other_lengths(page, lengths, limited):
    put(page, lengths, (0.1, 0.2, 0.3))
    page.set_checked("#limits", limited)
    page.click("#best")
    edge = np.pi / 2 if limited else np.pi
    grid = np.linspace(-edge, edge, 301)
    q = np.stack(np.broadcast_arrays(0.0, grid[:, None], grid), axis=-1)
    top = kinematics(lengths).manipulability(q).max()
    assert -DIGIT < value(page, "mu") - top < 1e-3


def test_the_numbers_are_those_that_the_command_writes(script, data):
    fresh = script.numbers()
    assert fresh["palette"] == data["palette"]
    np.testing.assert_allclose(data["optimum"], fresh["optimum"], rtol=0, atol=1e-9)
    assert [path["line"] for path in data["paths"]] == [path["line"] for path in fresh["paths"]]


@pytest.mark.parametrize("power", [1, 2])
def test_paths_are_those_of_the_optimiser(page, data, script, power):
    arm = kinematics()
    page.select_option("#power", str(power))
    for i, (name, (start, goal)) in enumerate(script.EXAMPLES.items()):
        page.select_option("#example", label=f"({name})")
        control = np.array(data["paths"][i]["optimal"][str(power)])
        paths = {"line": mp.JointPath.line(start, goal), "optimal": mp.JointPath(breaks=[0.0, 1.0], control=control[None])}
        for kind, path in paths.items():
            s, weights = path.quadrature(panels=400)
            index = arm.manipulability(path(s))
            g = weights @ (np.linalg.norm(path(s, 1), axis=1) / index**power)
            assert abs(float(page.text_content(f"#g-{kind}")) - g) < DIGIT
            assert abs(float(page.text_content(f"#len-{kind}")) - path.length) < 10 * DIGIT
            assert abs(float(page.text_content(f"#min-{kind}")) - index.min()) < 2e-3
        best = mp.optimize_path(
            mp.planar_arm(UNIT),
            start,
            goal,
            shape=mp.PathShape(degree=script.DEGREE),
            objective=mp.PathObjective(power=power, floor=0.0),
        )
        assert abs(g / best.g - 1) < 1e-6
        page.fill("#way", "0.4")  # of the length of the optimal path
        t = np.linspace(0, 1, 4001)
        length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path(t), axis=0), axis=1))])
        q = path(np.interp(0.4 * length[-1], length, t))
        np.testing.assert_allclose(np.cos(angles(page) - q), 1, rtol=0, atol=1e-6)  # angles but for full turns


def test_a_path_plays_and_stops(page):
    page.click("#play-line")
    page.wait_for_function("document.getElementById('way').value > 0.1")
    assert page.is_enabled("#stop")
    page.click("#stop")
    share = page.input_value("#way")
    assert 0.1 < float(share) < 1
    page.wait_for_timeout(200)
    assert page.input_value("#way") == share
    assert page.is_disabled("#stop")


def test_reduced_motion_is_respected(open_page):
    page = open_page(reduced_motion="reduce")
    page.click("#play-optimal")
    before = image(page)
    page.wait_for_timeout(300)
    assert image(page) == before
    assert "slider" in page.text_content("#way-note")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 800, 1400])
def test_it_is_readable_at_every_width_in_light_and_dark(open_page, width, scheme):
    page = open_page(width, color_scheme=scheme)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.evaluate("[...document.querySelectorAll('section')].every(s => s.scrollWidth <= s.clientWidth)")
    small = page.evaluate(
        "[...document.querySelectorAll('svg text')].map(t => parseFloat(getComputedStyle(t).fontSize) * t.getScreenCTM().d)"
        ".map(Math.abs).filter(size => size > 0 && size < 9.5)"
    )
    assert small == []
    for selector in ("p", ".why", "button", "th", "output"):
        assert contrast(page, selector) >= 4.5, selector


def contrast(page, selector):
    """WCAG's ratio of the text to the first background behind it that is not transparent."""
    pair = page.evaluate(
        """selector => {
            let node = document.querySelector(selector);
            const text = getComputedStyle(node).color;
            while (getComputedStyle(node).backgroundColor === "rgba(0, 0, 0, 0)") node = node.parentElement;
            return [text, getComputedStyle(node).backgroundColor].map(c => c.match(/\\d+/g).map(Number));
        }""",
        selector,
    )
    linear = [np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4) for c in np.array(pair)[:, :3] / 255]
    low, high = sorted(float(c @ [0.2126, 0.7152, 0.0722]) for c in linear)
    return (high + 0.05) / (low + 0.05)


def test_every_control_has_a_name(page):
    nameless = page.evaluate(
        """[...document.querySelectorAll("input, select, button, [tabindex]")].filter(node =>
            !node.getAttribute("aria-label") && !(node.labels && node.labels.length) && !node.textContent.trim())
            .map(node => node.outerHTML)"""
    )
    assert nameless == []


def test_the_documentation_embeds_it_and_its_code_runs(capsys):
    text = (DOCS / "studies" / "planar-arm.md").read_text(encoding="utf-8")
    assert '<iframe src="../_static/planar.html"' in text
    assert '<a href="../_static/planar.html"' in text
    assert "studies/planar-arm" in (DOCS / "index.md").read_text(encoding="utf-8")
    [code] = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    exec(compile(code, "planar-arm.md", "exec"), {})
    index, g, least = map(float, re.findall(r"\d+\.\d+", capsys.readouterr().out))
    assert round(index, 2) == 2.63  # Table 5.1
    assert g < 3.9420 / 3  # the straight line of Table 6.2, and what the page says of it
    assert least > 1.4
