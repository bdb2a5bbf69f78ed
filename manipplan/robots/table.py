"""The table that an arm prints: its joints with their limits, where these come from, what it carries, what is locked."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from manipplan.robots.robot import Robot

#: Number of locked joints that are named.
NAMED = 6


def robot_table(robot: "Robot") -> str:
    """The text of `str(robot)`."""
    limits = robot.limits
    head = ("joint", "type", "lower", "upper", "velocity", "acceleration", "jerk", "effort")
    rows: list[tuple[str, ...]] = [head]
    for i, (name, kind) in enumerate(zip(robot.joint_names, robot.joint_types, strict=True)):
        values = (getattr(limits, column)[i] for column in head[2:])
        rows.append((name, kind, *(f"{v:.4g}" for v in values)))
    widths = [max(len(row[k]) for row in rows) for k in range(len(head))]
    frames = f"tool frame{'s' * (len(robot.tools) > 1)} {' and '.join(robot.tools)}"
    lines = [f"{robot.name}: {robot.n} joints, {frames}   (SI units, rad)"]
    for row in rows:
        cells = [c.ljust(w) if k < 2 else c.rjust(w) for k, (c, w) in enumerate(zip(row, widths, strict=True))]
        lines.append("  ".join(cells).rstrip())
    lines += [f"{kind} limits: {source}" for kind, source in limits.sources.items()]
    if robot.followers:
        shown = [f"{joint} = {mimic}" for joint, mimic in list(robot.followers.items())[:NAMED]]
        more = f", ... ({len(robot.followers)} in all)" if len(robot.followers) > NAMED else ""
        lines.append(f"followers: {', '.join(shown)}{more}")
    if robot.carried:
        lines.append(f"carried: {', '.join(robot.carried)}")
    if robot.locked:
        shown = [f"{joint} = {value:g}" for joint, value in list(robot.locked.items())[:NAMED]]
        more = f", ... ({len(robot.locked)} in all)" if len(robot.locked) > NAMED else ""
        lines.append(f"locked: {', '.join(shown)}{more}")
    return "\n".join(lines)
