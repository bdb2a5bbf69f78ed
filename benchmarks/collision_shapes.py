"""How far the shapes that are checked stick out of each arm's meshes: the planner's convex pieces, the controller's capsules.

Run with `make benchmark`. Writes docs/benchmarks/collision_shapes.md.
"""

from pathlib import Path

import coal
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "collision_shapes.md"
HEAD = (
    "| arm | meshes | convex pieces | largest excess of a moving piece | of one that does not move "
    "| capsules | largest excess of a moving capsule |"
)


def row(name: str) -> str:
    """The line of one arm."""
    robot = mp.load_robot(name)
    model = mp.Scene().collision_model(robot)
    meshes = {item.name for item in robot.geometry.geometryObjects if isinstance(item.geometry, coal.BVHModelBase)}
    pieces = [item for item in list(model.geometry.geometryObjects)[: model.bodies] if mesh_of(item.name, meshes)]
    capsules = mp.Controller(robot, mp.formulations.General(), dt=0.01, compiled=False).bodies
    cells = [
        f"`{name}`",
        str(len(meshes)),
        str(len(pieces)),
        worst([(each.name, model.excess[each.name]) for each in pieces if each.parentJoint > 0]),
        worst([(each.name, model.excess[each.name]) for each in pieces if each.parentJoint == 0]),
        str(len(capsules)),
        worst([(each.name, each.excess) for each in capsules if each.joint > 0]),
    ]
    return f"| {' | '.join(cells)} |"


def mesh_of(name: str, meshes: set[str]) -> bool:
    """Whether a body is a mesh or, with a number after a dot, a piece of one."""
    return name in meshes or name.rpartition(".")[0] in meshes


def worst(found: list[tuple[str, float]]) -> str:
    """The largest excess in millimetres, and the body; a dash without bodies."""
    if not found:
        return "–"
    name, most = max(found, key=lambda each: each[1])
    return f"{1e3 * most:.0f} mm, `{name}`" if most >= 5e-4 else "0 mm"


def main() -> None:
    rows = [row(name) for name in track(mp.available_robots(), "arms")]
    lines = [HEAD, "|---|---|---|---|---|---|---|", *rows, "", "Command: `python benchmarks/collision_shapes.py`."]
    OUT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(OUT.read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
