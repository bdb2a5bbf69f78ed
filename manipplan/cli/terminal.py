"""Output of every command: a progress bar, and at the end the report and the files."""

import shlex
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from rich.console import Console

from manipplan.plans.result import Plan
from manipplan.robots.robot import Robot
from manipplan.support.progress import Progress
from manipplan.support.untrusted import printable, terminal_text

#: Prefix of the source of limits that were not given.
DEFAULT = "default"


@contextmanager
def progress(first: str = "") -> Iterator[Progress]:
    """A bar with the fraction done and the remaining time; without a terminal, one line per tenth. `first`: its first text."""
    console = Console(stderr=True)
    if not console.is_terminal:
        last = -1

        def line(share: float, text: str) -> None:
            nonlocal last
            if int(10 * share) > last:
                last = int(10 * share)
                console.print(terminal_text(f"... {10 * last} % {text}"))

        if first:
            line(0.0, first)
        yield line
        return
    from rich import progress as bars

    columns = (
        bars.TextColumn("{task.description}", markup=False),
        bars.BarColumn(),
        bars.TimeElapsedColumn(),
        bars.TimeRemainingColumn(),
    )
    with bars.Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(first, total=1.0)
        yield lambda share, text: bar.update(task, completed=share, description=printable(text))


def show_plan(plan: Plan, files: Sequence[Path], *lines: str) -> int:
    """Print what was assumed about the robot, the plan's report followed by `lines`, and its files.

    Returns the exit code: 0, or 3 for a checked motion that does not meet the request.
    """
    show_assumptions(Console(), plan.robot)
    show_result("\n  ".join((str(plan.report), *lines)), files, files[0].parent)
    return 0 if plan.status.ok else 3


def show_assumptions(console: Console, robot: Robot) -> None:
    """Print what was assumed about a robot: limits that nobody gave, and locked joints."""
    assumed = [f"{kind} limits: {source}" for kind, source in robot.limits.sources.items() if source.startswith(DEFAULT)]
    if robot.locked:
        assumed.append("locked joints: " + ", ".join(f"{name} at {value:g}" for name, value in robot.locked.items()))
    for line in assumed:
        show_line(console, line, style="dim")


def show_result(report: str, files: Sequence[Path], folder: Path | None = None) -> None:
    """Print a report, its files, and how to view the saved plan or program in `folder`."""
    console = Console()
    show_line(console, report)
    show_line(console, "wrote " + " ".join(map(str, files)))
    if folder is not None:
        show_line(console, f"to see it: manipplan view {shlex.quote(str(folder))}\n")


def show_line(console: Console, text: str, style: str = "") -> None:
    """Print `text` unchanged, without line breaks; names in it are not interpreted as markup."""
    console.print(terminal_text(text, style), soft_wrap=True)
