"""The arm that a command was given."""

from pathlib import Path

from manipplan.robots.catalog import load_robot
from manipplan.robots.robot import Robot


def load_arm(name: str, tool: str | None, srdf: Path | None) -> Robot:
    """A known arm or that of a file, with the options that were given."""
    given = {"tool": tool, "srdf": srdf}
    return load_robot(name, **{key: value for key, value in given.items() if value is not None})
