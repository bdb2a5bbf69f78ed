"""Record a motion as one HTML file that plays in any browser without Python and without a network."""

from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from manipplan.support.checks import number
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_text
from manipplan.viz.viewer.motion import ShownMotion
from manipplan.viz.viewer.plan_viewer import chart_of, table
from manipplan.viz.viewer.server import Page, require_extra
from manipplan.viz.viewer.stage import Stage

if TYPE_CHECKING:
    from manipplan.jobs.programs.program import Program
    from manipplan.jobs.result import Plan

#: Time for which the last picture is shown before the motion repeats [s].
PAUSE = 0.8
#: Folds the panel initially on a narrow screen.
FOLD = "<script>if (innerWidth < 700) document.getElementById('figures').open = false</script>"
#: End of viser's part of the page.
END = "</body>"


def record(plan: "Plan | Program", file: str | Path, *, rate: float = 25.0) -> Path:
    """Write the motion of a plan as a self-contained HTML file, with legend, measure over time and values; returns the file.

    The page of one to two megabytes plays the motion at real speed; the bar at its bottom selects the time.

    Args:
        plan: with a trajectory; or a Program.
        file: file name that ends in .html.
        rate: pictures per second.

    Raises:
        MissingExtraError: viser is not installed.
        PlanningError: the plan has no trajectory.
        InvalidInputError: the file name does not end in .html, or the file cannot be written.
    """
    require_extra()
    rate = number("rate", rate, above=0.0, most=120.0)
    if not isinstance(file, str | Path) or Path(file).suffix.lower() not in (".html", ".htm"):
        raise InvalidInputError("file", file, "a file whose name ends in .html")
    path = Path(file).expanduser()
    motion = ShownMotion.of(plan)
    with Page(0, "localhost", motion.robot.name) as page:
        stage = Stage(page.server, motion)
        label = page.server.scene.add_label("/time", "", anchor="bottom-left", font_screen_scale=0.8)
        serializer = page.server.get_scene_serializer()
        times = np.append(np.arange(0.0, motion.trajectory.duration, 1.0 / rate), motion.trajectory.duration)
        for t, wait in zip(times, np.append(np.diff(times), PAUSE), strict=True):
            stage.place(float(t))
            label.text = f"{t:.2f} s, measure {float(np.interp(t, motion.t, motion.ours.manipulability)):.3g}"
            label.position = stage.ellipsoids[0].mesh.position
            serializer.insert_sleep(float(wait))
        html = serializer.as_html()
    cut = html.rindex(END)
    write_text(path, html[:cut] + _panel(motion) + html[cut:])
    return path


def _panel(motion: ShownMotion) -> str:
    """The panel beside the scene; it can be folded, so that it covers nothing on a small screen."""
    rows = [("duration", f"{motion.trajectory.duration:.2f} s"), *motion.least()]
    return (
        '<details open id="figures" style="position:fixed;left:0.8em;top:0.8em;width:min(320px,calc(100vw - 1.6em));z-index:5;'
        'background:rgba(255,255,255,0.92);border:1px solid #ddd;border-radius:6px;padding:0.4em 0">'
        '<summary style="font:600 13px sans-serif;padding:0.1em 0.75em;cursor:pointer">'
        f"{escape(motion.robot.name)}</summary>{chart_of(motion).html()}{table(rows)}</details>{FOLD}"
    )
