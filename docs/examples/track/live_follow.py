"""
Drag a target, the arm follows
==============================

.. image:: /_static/viewer.png
   :alt: The viewer in a browser: a Panda among boxes, with an ellipsoid at its hand
         and the manipulability over time.
   :width: 560px

*For a first impression of the controller.*

This script opens a page in the browser with a Panda next to a crate. Drag the arrows at
the tool: a controller follows in real time, keeps every limit, stays away from the
crate, and uses the remaining freedom to raise the manipulability. The ellipsoid and the
manipulability curve are updated as the arm moves. Clear the check box "raise the
manipulability" to follow the target only.

This page was not run, because it is interactive. Run it with ``python
docs/examples/track/live_follow.py`` and stop it with Ctrl-C. It needs the extra
``viewer``.
"""

# sphinx_gallery_thumbnail_path = "_static/viewer.png"

import manipplan as mp
from manipplan.viz import viewer

robot = mp.load_robot("panda")
scene = mp.Scene(
    [mp.Box(size=(0.2, 0.2, 0.4), position=(0.5, 0.45, 0.2), name="crate")]
)
with viewer.follow_target(robot, mp.formulations.LogDrive(), scene=scene) as page:
    print(f"drag the target at {page.url}; Ctrl-C ends it")
    page.wait()
