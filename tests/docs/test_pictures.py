"""Pictures that `make pictures` draws: they are compared with those that are committed, and the stills are those of the pages."""

import io
import runpy
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

DOCS = Path(__file__).parents[2] / "docs"
difference = runpy.run_path(str(DOCS / "compare_pictures.py"))["difference"]


def stored(pixels, kind):
    stream = io.BytesIO()
    first, *others = [Image.fromarray(each.astype(np.uint8)) for each in pixels]
    first.save(stream, format=kind, **({"save_all": True, "append_images": others} if others else {}))
    return stream.getvalue()


@pytest.fixture
def picture():
    rows, columns = np.mgrid[:160, :240]
    return np.stack([rows, columns, 0 * rows + 90], axis=-1)


def test_pictures_that_differ_by_a_little_look_the_same(picture):
    noise = np.random.default_rng(0).integers(-6, 7, picture.shape)
    assert difference(".png", stored([picture], "PNG"), stored([np.clip(picture + noise, 0, 255)], "PNG")) == ""


def test_other_pictures_look_different(picture):
    old = stored([picture], "PNG")
    assert "mean difference" in difference(".png", old, stored([picture[::-1]], "PNG"))
    assert "120 x 160 pixels instead of 240 x 160" in difference(".png", old, stored([picture[:, :120]], "PNG"))
    moved = [np.roll(picture, 8 * k, axis=0) for k in range(18)]
    assert difference(".webp", stored(moved, "WEBP"), stored(moved, "WEBP")) == ""
    assert "2 frames compared instead of 1" in difference(".webp", stored(moved[:5], "WEBP"), stored(moved, "WEBP"))


def test_drawings_are_compared_by_their_coordinates():
    old = b'<path d="M 1.0 2.5 L 3 4"/>'
    assert difference(".svg", old, b'<path d="M 1.2 2.5 L 3 4"/>') == ""
    assert "5 apart" in difference(".svg", old, b'<path d="M 1.0 7.5 L 3 4"/>')
    assert difference(".svg", old, b'<path d="M 1.0 2.5"/>') == "other shapes"


def test_the_still_of_an_example_is_that_of_the_page(monkeypatch):
    pytest.importorskip("mujoco")
    monkeypatch.setattr(sys, "path", [str(DOCS / "pictures"), *sys.path])
    drawn = runpy.run_path(str(DOCS / "pictures" / "stills.py"))
    page = "first_steps/first_plan"
    stream = io.BytesIO()
    drawn["picture"](drawn["STILLS"][page], drawn["run"](page)).save(stream, format="PNG")
    assert difference(".jpg", (DOCS / "pictures" / "first_plan.jpg").read_bytes(), stream.getvalue()) == ""


def test_every_still_has_its_page_and_every_page_its_still():
    drawn = runpy.run_path(str(DOCS / "pictures" / "stills.py"))["STILLS"]
    shown = {
        f"{page.parent.name}/{page.stem.removeprefix('plot_')}"
        for page in (DOCS / "examples").glob("**/plot_*.py")
        if "sphinx_gallery_thumbnail_path" in page.read_text()
    }
    assert set(drawn) == shown
    assert all((DOCS / "pictures" / f"{Path(page).name}.jpg").is_file() for page in drawn)
