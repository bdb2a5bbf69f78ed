"""The 3D viewer in a browser: it shows and records plans, and runs a controller that follows a dragged target.

It needs the extra `viewer`, whose packages are imported only when something is shown.
"""

from manipplan.viz.viewer.live import LiveViewer, follow_target
from manipplan.viz.viewer.plan_viewer import Embedded, PlanViewer, embed, record, show

__all__ = ["Embedded", "LiveViewer", "PlanViewer", "embed", "follow_target", "record", "show"]
