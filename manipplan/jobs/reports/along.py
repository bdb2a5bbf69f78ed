"""PathPart: a part of a motion on which the tool follows a workspace path."""

from dataclasses import dataclass

from manipplan.support.display import one_line
from manipplan.timing.steady.speed import SteadySpeed


@one_line
@dataclass(frozen=True, kw_only=True)
class PathPart:
    """A part of a motion on which the tool follows a workspace path, or a part of one.

    Attributes:
        begin, end: times at which it begins and ends [s].
        s_begin, s_end: where on the workspace path; beyond 1 where it goes on around a closed one.
        min_manipulability: minimum manipulability on it; None where it is not known.
        tool_speed: speed of the tool on it; None where none was asked for.
    """

    begin: float
    end: float
    s_begin: float = 0.0
    s_end: float = 1.0
    min_manipulability: float | None = None
    tool_speed: SteadySpeed | None = None


def lines(along: tuple[PathPart, ...], duration: float) -> list[str]:
    """Lines of a report on the parts of a motion of some duration [s]."""
    made = []
    least = [part.min_manipulability for part in along if part.min_manipulability is not None]
    if along and along[0].begin > 0:
        after = f"; minimum m along the path after it: {min(least):.4g}" if least else ""
        made.append(f"  lead-in      {along[0].begin:.3f} s{after}")
    in_parts = len(along) > 1 or any(part.s_begin > 0 for part in along)
    if in_parts:
        kind = "between which the tool leaves it" if len(along) > 1 else "which goes on around it"
        made.append(f"  parts        {len(along)} of the path, {kind}:")
    for part in along:
        if in_parts:
            minimum = "" if part.min_manipulability is None else f"; minimum m {part.min_manipulability:.4g}"
            when = f"from {part.begin:.3f} s to {part.end:.3f} s"
            made.append(f"               s = {part.s_begin:.4f} to {part.s_end:.4f} {when}{minimum}")
        if part.tool_speed is not None:
            made.append(f"  tool speed   {part.tool_speed}")
    if along and along[-1].end < duration:
        made.append(f"  return       {duration - along[-1].end:.3f} s, to the configuration in which the path began")
    return made
