"""The 3D viewer in a browser: it shows and records plans, runs a controller that follows a dragged target, and a servo by keys.

It needs the extra `viewer`, whose packages are imported only when something is shown.
"""

from manipplan.viz.viewer.live import LiveViewer, follow_target
from manipplan.viz.viewer.plan_viewer import Embedded, PlanViewer, embed, record, show
from manipplan.viz.viewer.teleoperation import ServoViewer, teleoperate

__all__ = ["Embedded", "LiveViewer", "PlanViewer", "ServoViewer", "embed", "follow_target", "record", "show", "teleoperate"]
