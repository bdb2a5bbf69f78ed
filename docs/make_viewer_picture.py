"""Draw docs/_static/viewer.png: the demo's plan in the viewer, as a browser shows it.

Run: python docs/make_viewer_picture.py
"""

import io
import shutil
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

import manipplan as mp
from manipplan.jobs.demo import panda_among_boxes

PICTURE = Path(__file__).parent / "_static" / "viewer.png"
FLAGS = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")
#: Where the motion is looked at, as a share of its duration.
PLACE = 0.45


def main() -> None:
    problem = panda_among_boxes()
    plan = mp.plan(
        problem.robot,
        problem.start,
        problem.goal,
        problem.scene,
        objective=mp.PathObjective(power=problem.power),
        clearance=problem.clearance,
    )
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))))
    with plan.show(port=0, open_browser=False) as viewer, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        page = browser.new_page(viewport={"width": 1200, "height": 760})
        page.goto(viewer.url)
        page.locator(".mantine-Notification-closeButton").click(timeout=60_000)  # it tells that there is no graphics card
        viewer.time = PLACE * plan.trajectory.duration
        before, after = b"", page.screenshot()
        while after != before:  # without a graphics card the scene appears slowly
            page.wait_for_timeout(4000)
            before, after = after, page.screenshot()
        shot = Image.open(io.BytesIO(after)).convert("RGB")
        browser.close()
    shot.quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(PICTURE, optimize=True)
    print(f"wrote {PICTURE}, {PICTURE.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
