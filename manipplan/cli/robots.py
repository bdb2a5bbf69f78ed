"""`manipplan robots`: the known arms."""

from rich.console import Console
from rich.table import Table
from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.robots.catalog import available_robots, load_robot
from manipplan.support.untrusted import terminal_text


def robots(name: Positional[str | None] = None, /) -> None:
    """List the known arms, or print the table of one.

    Args:
        name: An arm's name, or a URDF, xacro or MJCF file.
    """
    console = Console()
    if name is not None:
        terminal.show_line(console, str(load_robot(name)))
        return
    table = Table("name", "joints", "tool frame", box=None)
    names = available_robots()
    with terminal.progress() as tell:
        for k, each in enumerate(names):
            tell(k / len(names), f"loading {each}")
            robot = load_robot(each)
            table.add_row(each, str(robot.n), terminal_text(", ".join(robot.tools)))
    console.print(table)
