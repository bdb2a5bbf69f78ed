"""`manipplan study`: the tables and figures of a paper."""

import importlib
import time
from pathlib import Path
from typing import Literal

from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.support.errors import MissingSourcesError, PlanningError
from manipplan.support.files import place_for

Paper = Literal["kth2012", "dufour2020", "guilamo2006", "singularities"]


def study(paper: Positional[Paper], /, quick: bool = False, out: Path | None = None) -> None:
    """Reproduce all tables and figures of a paper or of a study of our own, and collect them in report.html.

    Args:
        paper: kth2012 (paths of a planar arm), dufour2020 (QP inverse kinematics), guilamo2006 (search along a path), or our
            own study: singularities (g of paths that cross them).
        quick: Skip what takes long; the report says what is skipped.
        out: Folder for tables, figures and report. Default: study/PAPER.
    """
    folder = place_for("out", out if out is not None else Path("study") / paper)
    try:
        made = importlib.import_module(f"studies.{paper}.run").STUDY
        write_report = importlib.import_module("studies.report").write_report
    except ModuleNotFoundError as error:
        if error.name != "studies":
            raise
        raise MissingSourcesError("the studies") from error
    began = time.monotonic()
    with terminal.progress() as notify:
        wrong = made.run(folder, quick=quick, progress=notify)
    seconds = time.monotonic() - began
    report = write_report(made.pages.with_suffix(".md"), folder, quick=quick, seconds=seconds, differences=wrong)
    terminal.show_result("\n".join(wrong or [f"{paper}: all figures are as expected"]), [report])
    if wrong:
        raise PlanningError(f"{len(wrong)} figures of {paper} are not as expected; see {report}")
