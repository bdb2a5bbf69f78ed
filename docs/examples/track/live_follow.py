"""
Drag a target, the arm follows
==============================

A page in the browser with a Panda beside a crate. Drag the arrows at its tool: a controller follows in real time, keeps
every limit, stays away from the crate, and raises the manipulability index with what freedom is left. The ellipsoid and the
curve of the index move along. Take the tick off "raise the manipulability", and only the target counts.

This page was not run: it waits for your hand. Run it with ``python docs/examples/track/live_follow.py``; Ctrl-C ends it. It
needs the extra ``viewer``.
"""

# sphinx_gallery_thumbnail_path = "_static/viewer.png"

import manipplan as mp
from manipplan.viz import viewer

robot = mp.load_robot("panda")
scene = mp.Scene(
    [mp.Box(size=(0.2, 0.2, 0.4), position=(0.5, 0.45, 0.2), name="crate")]
)
with viewer.follow_target(robot, mp.LogDrive(), scene=scene) as page:
    print(f"drag the target at {page.url}; Ctrl-C ends it")
    page.wait()
