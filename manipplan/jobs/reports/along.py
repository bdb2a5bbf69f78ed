"""PathPart: the part of a motion on which the tool follows a workspace path."""

from dataclasses import dataclass

from manipplan.support.display import one_line
from manipplan.timing.steady.speed import SteadySpeed


@one_line
@dataclass(frozen=True, kw_only=True)
class PathPart:
    """The part of a motion on which the tool follows a workspace path, which is its end.

    Attributes:
        begin: time at which it begins, after the lead-in [s]; 0 without one.
        min_manipulability: minimum manipulability on it.
        tool_speed: speed of the tool on it; None where none was asked for.
    """

    begin: float
    min_manipulability: float
    tool_speed: SteadySpeed | None = None

    def lines(self) -> list[str]:
        """Lines of a report."""
        lines = []
        if self.begin > 0:
            lines.append(f"  lead-in      {self.begin:.3f} s; minimum m along the path after it: {self.min_manipulability:.4g}")
        if self.tool_speed is not None:
            lines.append(f"  tool speed   {self.tool_speed}")
        return lines
