"""Draw docs/_static/viewer.png, viewer_checked.png, viewer_program.png and viewer_servo.png: what a browser shows.

Run: python docs/make_viewer_picture.py [viewer] [viewer_checked] [viewer_program] [viewer_servo]
"""

import io
import shutil
import sys
import time
from pathlib import Path

import numpy as np
from PIL import Image
from playwright.sync_api import sync_playwright

import manipplan as mp
from manipplan.viz import viewer

FOLDER = Path(__file__).parent / "_static"
FLAGS = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")
#: Where the motion is looked at, as a share of its duration.
PLACE = 0.45
#: Time after which a picture is given up [ms]: without a graphics card it can take a minute.
PATIENCE = 240_000


def demo():
    """The demo's plan."""
    problem = mp.demo.panda_among_boxes()
    objective = mp.PathObjective(power=problem.power)
    return mp.plan(problem.robot, problem.start, problem.goal, problem.scene, objective=objective, clearance=problem.clearance)


def beside_a_block():
    """A short motion of a UR5, whose links are cut into several pieces."""
    start = np.array([-0.9, -1.25, 1.55, -1.9, -1.3, 0.0])
    block = mp.Box(size=(0.2, 0.2, 0.3), position=(-0.35, 0.55, 0.15), name="block")
    return mp.plan(mp.load_robot("ur5"), start, start + np.array([0.9, 0.2, -0.3, 0.2, 0.3, 0.2]), mp.Scene([block]))


def carrying():
    """The program of docs/howto/programs.md, whose place is a pose of the part."""
    robot = mp.load_robot("panda", locked={"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04})
    scene = mp.Scene(
        [
            mp.Box(size=(0.9, 1.6, 0.04), position=(0.6, 0.0, -0.02), name="table"),
            mp.Box(size=(0.1, 0.1, 0.3), position=(0.45, 0.0, 0.15), name="post"),
            mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, 0.051), name="part"),
        ]
    ).allow("part", "table")
    grasp, place = np.diag([1.0, -1.0, -1.0, 1.0]), np.eye(4)
    grasp[:3, 3], place[:3, 3] = [0.45, 0.3, 0.09], [0.45, -0.3, 0.051]
    away = mp.MoveAlong([0, 0, -0.1])
    steps = [mp.MoveTo(grasp, approach=0.1), mp.Attach("part"), away]
    steps += [mp.MoveTo(mp.PoseGoal(place, of="part"), approach=0.1), mp.Detach("part"), away, mp.MoveTo("default")]
    return mp.sequence(robot, "default", steps, scene, blend=0.05)


def stretched():
    """A page of the servo, on which a held key has stretched the arm and goes on."""
    page = viewer.teleoperate(mp.load_robot("panda"), start="default", port=0, open_browser=False)
    page.press(0, 1, seconds=1e4)
    end = time.monotonic() + 60.0
    while page.gauge is None or page.gauge.wall < 0.5:
        assert time.monotonic() < end, "the arm did not come to the edge of its reach"
        time.sleep(0.02)
    return page


#: Each picture: its plan or program, the switches that are on and off, and the size of the window.
PICTURES = {
    "viewer": (demo, (), (), (1200, 760)),
    "viewer_checked": (
        beside_a_block,
        ("what is checked",),
        ("side by side", "seed", "path, seed", "ellipsoid, tool", "ellipsoids, path"),
        (1200, 830),
    ),
    "viewer_program": (carrying, (), (), (1200, 760)),
    "viewer_servo": (stretched, (), (), (1200, 900)),
}


def main(names) -> None:
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))))
    for name in names or PICTURES:
        make, on, off, (width, height) = PICTURES[name]
        made, file = make(), FOLDER / f"{name}.png"
        live = isinstance(made, viewer.ServoViewer)
        with made if live else made.show(port=0, open_browser=False) as shown, sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
            page = browser.new_page(viewport={"width": width, "height": height})
            page.set_default_timeout(PATIENCE)
            page.goto(shown.url)
            page.locator(".mantine-Notification-closeButton").click()  # it tells that there is no graphics card
            if not live:
                shown.time = PLACE * made.trajectory.duration
            labels = [] if live else list(shown.stage.layers)
            boxes = page.get_by_role("checkbox")
            for switch in (*on, *off):  # the switches are the panel's last boxes
                boxes.nth(boxes.count() - len(labels) + labels.index(switch)).click(force=True)
            before, after, count = b"", page.screenshot(), 0
            while after != before and not (live and count > 4):  # without a graphics card the scene appears slowly
                page.wait_for_timeout(4000)
                before, after, count = after, page.screenshot(), count + 1
            assert live or all(shown.stage.layers[switch].visible for switch in on), "the click came to nothing"
            shot = Image.open(io.BytesIO(after)).convert("RGB")
            browser.close()
        shot.quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(file, optimize=True)
        print(f"wrote {file}, {file.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
