"""`manipplan view`: show a saved plan or program in the browser, or record it as an HTML file."""

from contextlib import suppress
from pathlib import Path

from rich.console import Console
from tyro.conf import Positional

from manipplan.cli.terminal import show_line
from manipplan.plans.result import Plan
from manipplan.programs.program import NAME as PROGRAM
from manipplan.programs.program import Program


def view(
    result: Positional[Path],
    /,
    port: int = 8080,
    host: str = "localhost",
    browser: bool = True,
    record: Path | None = None,
) -> None:
    """Show a saved plan or program in the browser until Ctrl-C, or record it as an HTML file.

    Args:
        result: Folder that `manipplan plan`, `follow`, `improve` or `run` wrote, or its plan.json or program.json.
        port: Port of the page; 0 takes any free port.
        host: Address on which the page is served; 0.0.0.0 lets other machines see it.
        browser: Open the page in the browser.
        record: Write this HTML file, which plays anywhere, instead of showing the page.
    """
    console = Console()
    is_program = result.name == PROGRAM or (result / PROGRAM).is_file()
    plan = Program.load(result) if is_program else Plan.load(result)
    if record is not None:
        file = plan.record(record)
        show_line(console, f"wrote {file}; open it in a browser")
        return
    with plan.show(port=port, host=host, open_browser=False) as page, suppress(KeyboardInterrupt):
        show_line(console, f"{plan.robot.name} at {page.url}; press Ctrl-C to stop")
        if browser:
            page.open()
        page.wait()
