"""
Move an arm with a gamepad
==========================

.. image:: /_static/viewer_servo.png
   :alt: The viewer in a browser: a stretched Panda; the panel has buttons that move the
         tool and says that a fold of the elbow is ahead.
   :width: 560px

*For teleoperation, without a robot first.*

This script opens a page in the browser with a Panda and moves its tool by a gamepad:
left stick forward and sideways, triggers up and down, right stick and shoulder buttons
to turn, B back to the start. Without a gamepad, the keys and buttons of the page do the
same. Push the arm outward: it stops at the edge of its reach, the gamepad rumbles, and
the arm comes back at once.

This page was not run, because it is interactive. Run it with ``python
docs/examples/track/live_gamepad.py`` and stop it with Ctrl-C. It needs the extra
``viewer`` and ``pip install pygame``. ``--record FILE`` keeps what the gamepad did, and
``--replay FILE`` needs no gamepad: ``gamepad.csv`` beside the script is such a file.
"""

# sphinx_gallery_thumbnail_path = "_static/viewer_servo.png"

import argparse
import csv
import os
import time
from pathlib import Path

import numpy as np

import manipplan as mp
from manipplan.viz import viewer

PERIOD = 0.02  # [s]
SPEED, TURN = 0.2, 0.8  # [m/s], [rad/s] of a stick at its stop
DEAD = 0.12  # share of a stick's way that counts as nothing
# Numbers of SDL's controllers, the same for all makes.
LEFT_SHOULDER, RIGHT_SHOULDER, B = 9, 10, 1
NAMES = ("left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger")


def twist_of(axes, buttons):
    """The twist (6,) of the tool in the world for axes (6,) in [-1, 1] and a set of buttons.

    Sticks are -1 at the left and at the top, triggers 0 at rest.
    """
    way = np.abs(axes)
    lx, ly, rx, ry, down, up = np.where(
        way > DEAD, np.sign(axes) * (way - DEAD) / (1 - DEAD), 0.0
    )
    spin = (LEFT_SHOULDER in buttons) - (RIGHT_SHOULDER in buttons)
    return np.concatenate(
        [SPEED * np.array([-ly, -lx, up - down]), TURN * np.array([-rx, -ry, spin])]
    )


class Gamepad:
    """The first gamepad that SDL finds."""

    def __init__(self):
        try:
            import pygame
            from pygame._sdl2 import controller
        except ImportError:
            raise SystemExit(
                "pygame is not installed: pip install pygame; or use --replay FILE"
            ) from None
        self.pygame = pygame
        os.environ.setdefault("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1")  # no window
        pygame.display.init()  # events come through it
        controller.init()
        found = [
            i for i in range(controller.get_count()) if controller.is_controller(i)
        ]
        if not found:
            raise SystemExit("no gamepad found: connect one, or use --replay FILE")
        self.pad = controller.Controller(found[0])
        self.axes, self.buttons = np.zeros(6), set()

    def read(self):
        """(axes, buttons) now; None once the gamepad is gone."""
        for event in self.pygame.event.get():
            if event.type == self.pygame.CONTROLLERAXISMOTION:
                self.axes[event.axis] = np.clip(event.value / 32767, -1, 1)
            elif event.type == self.pygame.CONTROLLERBUTTONDOWN:
                self.buttons.add(event.button)
            elif event.type == self.pygame.CONTROLLERBUTTONUP:
                self.buttons.discard(event.button)
            elif event.type == self.pygame.CONTROLLERDEVICEREMOVED:
                return None
        return self.axes.copy(), set(self.buttons)

    def feel(self, wall):
        """Rumble by a share in [0, 1]."""
        self.pad.rumble(0.0, float(wall), 100)


class Replay:
    """A file that --record wrote, in real time."""

    def __init__(self, file):
        with Path(file).open(newline="") as stream:
            self.rows = list(csv.DictReader(stream))
        self.began = None

    def read(self):
        """(axes, buttons) since the first call; None at the end of the file."""
        self.began = self.began or time.monotonic()
        now = time.monotonic() - self.began
        if now > float(self.rows[-1]["time"]):
            return None
        row = [row for row in self.rows if float(row["time"]) <= now][-1]
        axes = np.array([float(row[name]) for name in NAMES])
        return axes, {int(each) for each in row["buttons"].split()}

    def feel(self, wall):
        """A file feels nothing."""


def main(arguments=None):
    """Move the arm until Ctrl-C, the end of the file, or until the gamepad is gone."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--robot", default="panda")
    parser.add_argument("--replay", type=Path)
    parser.add_argument("--record", type=Path)
    parser.add_argument("--no-browser", action="store_true")
    given = parser.parse_args(arguments)
    device = Replay(given.replay) if given.replay else Gamepad()
    robot = mp.load_robot(given.robot)
    rows, walls, farthest = [], [], 0.0
    with viewer.teleoperate(robot, port=0, open_browser=not given.no_browser) as page:
        print(f"move the arm at {page.url}; Ctrl-C ends it")
        start, began = page.pose[:3, 3], time.monotonic()
        try:
            while (state := device.read()) is not None:
                axes, buttons = state
                if B in buttons:
                    page.restart()
                elif axes.any() or buttons:  # otherwise the keys of the page count
                    page.twist = twist_of(axes, buttons)
                wall = page.gauge.wall if page.gauge else 0.0
                device.feel(wall)
                walls.append(wall)
                farthest = max(farthest, np.linalg.norm(page.pose[:3, 3] - start))
                now = time.monotonic() - began
                if not rows or rows[-1][1:] != [*axes, " ".join(map(str, buttons))]:
                    rows.append([now, *axes, " ".join(map(str, buttons))])
                time.sleep(PERIOD)
        except KeyboardInterrupt:
            pass
        print(f"the tool moved by up to {farthest:.2f} m")
        print(
            f"at the edge of the reach for {PERIOD * sum(w > 0.5 for w in walls):.1f} s"
        )
    if given.record and rows:
        rows.append([time.monotonic() - began, *rows[-1][1:]])
        with given.record.open("w", newline="") as stream:
            csv.writer(stream).writerows([["time", *NAMES, "buttons"], *rows])


if __name__ == "__main__":
    main()
