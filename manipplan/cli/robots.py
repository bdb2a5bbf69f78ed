"""`manipplan robots`: the arms that can be had by name."""

from collections.abc import Iterator

from rich.console import Console
from rich.table import Column, Table
from tyro.conf import Positional

from manipplan.cli import terminal
from manipplan.robots.catalog import CATALOG, load_robot, refusal
from manipplan.robots.collections import CHECKOUT, names_of_collections, own_robots, package_of
from manipplan.support.untrusted import terminal_text

#: How the robots of each collection become available.
REMEDIES = {
    "robot_descriptions": "pip install 'manipplan[descriptions]'",
    "MuJoCo Menagerie": f"pip install 'manipplan[menagerie]', or set {CHECKOUT} to a checkout",
}


def robots(name: Positional[str | None] = None, /, *, names: bool = False) -> None:
    """List the known arms, or print the table of one.

    Args:
        name: An arm's name, or a URDF, xacro or MJCF file.
        names: Also list all names of robot_descriptions and of MuJoCo Menagerie.
    """
    console = Console()
    if name is not None:
        terminal.show_line(console, str(load_robot(name)))
        return
    table = Table(Column("name", no_wrap=True), "joints", Column("tool frame", overflow="fold"), "IK", "source", box=None)
    for each, entry in CATALOG.items():
        tools = (entry.tool,) if isinstance(entry.tool, str) else entry.tool
        table.add_row(each, str(entry.joints), terminal_text(", ".join(tools)), entry.ik, "example-robot-data")
    for each, points in own_robots().items():
        reason = refusal(each, points)
        source = f"{package_of(points[0])}: {points[0].value}" if reason is None else f"cannot be loaded; allowed: {reason}"
        table.add_row(terminal_text(each), "", "", "", terminal_text(source))
    console.print(table)
    for line in _collections(names):
        terminal.show_line(console, line)


def _collections(all_names: bool) -> Iterator[str]:
    """What can be had of other collections, or how."""
    for collection, found in names_of_collections().items():
        if not found:
            yield f"{collection}: {REMEDIES[collection]}"
            continue
        yield f"{collection}: {len(found)} names, such as {found[0]}" + ("" if all_names else "   (--names lists them)")
        if all_names:
            yield from (f"  {each}" for each in found)
