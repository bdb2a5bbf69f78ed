"""Bodies that a description fixes to other links: verdicts of twenty arms beside Pinocchio and coal.

Twelve generated arms carry pedestals, tables, brackets, cameras and grippers on fixed joints, as boxes, cylinders, spheres and
convex meshes. Eight arms of the catalogue get a gripper at the tool and a pedestal below the base. The judge reads the original
file by Pinocchio and coal, takes parent and child link of one joint as adjacent and nothing else, and leaves out links that
touch in 95 % of its own postures. Run with `make benchmark`. Writes docs/benchmarks/fixed_bodies.md.
"""

import argparse
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
from description_judge import Judge
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "fixed_bodies.md"
ARMS = ("panda", "panda_collision", "ur3", "ur5", "ur10", "xarm7", "z1", "kinova")
#: Distances below this are contact by rounding [m].
ROUNDING = 1e-6


def shape(rng: np.random.Generator, folder: Path) -> str:
    """The geometry of a small body: box, cylinder, sphere or the mesh of a wedge in millimetres."""
    kind, size = rng.choice(["box", "cylinder", "sphere", "mesh"]), rng.uniform(0.03, 0.12, 3)
    if kind == "box":
        return f'<box size="{size[0]} {size[1]} {size[2]}"/>'
    if kind == "cylinder":
        return f'<cylinder radius="{size[0] / 2}" length="{2 * size[1]}"/>'
    if kind == "sphere":
        return f'<sphere radius="{size[0] / 2}"/>'
    file = folder / f"wedge{len(list(folder.glob('*.stl')))}.stl"
    a, b, c = 1e3 * size
    corners = np.array([[0, 0, 0], [a, 0, 0], [0, b, 0], [0, 0, c], [a, 0, c], [0, b, c]]) - [a / 3, b / 3, c / 2]
    faces = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex {} {} {}\n".format(*corners[k]) for k in face)
        + "endloop\nendfacet\n"
        for face in faces
    )
    file.write_text(f"solid wedge\n{facets}endsolid wedge\n")
    return f'<mesh filename="{file}" scale="0.001 0.001 0.001"/>'


def collision(rng: np.random.Generator, folder: Path, place: np.ndarray) -> str:
    angles = rng.uniform(-1, 1, 3)
    origin = f'<origin xyz="{place[0]} {place[1]} {place[2]}" rpy="{angles[0]} {angles[1]} {angles[2]}"/>'
    return f"<collision>{origin}<geometry>{shape(rng, folder)}</geometry></collision>"


def fixed(name: str, parent: str, place: np.ndarray) -> str:
    origin = f'<origin xyz="{place[0]} {place[1]} {place[2]}"/>'
    return f'<joint name="{name}_fixed" type="fixed"><parent link="{parent}"/><child link="{name}"/>{origin}</joint>'


def generated(seed: int, folder: Path) -> Path:
    """An arm of three to seven joints with bodies fixed to its base, to links between, and to its flange."""
    rng = np.random.default_rng(seed)
    joints, parts = int(rng.integers(3, 8)), ['<link name="base"/>']

    def add(name: str, parent: str, reach: float, bodies: int) -> None:
        own = "".join(collision(rng, folder, rng.uniform(-reach, reach, 3)) for _ in range(bodies))
        parts.extend([f'<link name="{name}">{own}</link>', fixed(name, parent, rng.uniform(-reach, reach, 3))])

    add("pedestal", "base", 0.1, 1)
    add("table", "pedestal", 0.3, 2)
    parent = "base"
    for k in range(joints):
        axis, length = np.eye(3)[int(rng.integers(3))], rng.uniform(0.1, 0.3)
        low, high = rng.uniform(-3, -1), rng.uniform(1, 3)
        body = collision(rng, folder, np.array([0, 0, length / 2])) if rng.random() < 0.8 else ""
        parts.append(f'<link name="l{k}">{body}</link>')
        parts.append(
            f'<joint name="j{k}" type="revolute"><parent link="{parent}"/><child link="l{k}"/><origin xyz="0 0 {length}"/>'
            f'<axis xyz="{axis[0]} {axis[1]} {axis[2]}"/><limit lower="{low}" upper="{high}" velocity="2" effort="9"/></joint>'
        )
        parent = f"l{k}"
        if rng.random() < 0.5:
            add(f"bracket{k}", parent, 0.1, 1)
    add("hand", parent, 0.08, 1)
    add("finger_a", "hand", 0.06, 1)
    add("finger_b", "hand", 0.06, 1)
    add("camera", "hand", 0.12, 1)
    file = folder / f"generated{seed}.urdf"
    file.write_text(f'<robot name="generated{seed}">{"".join(parts)}</robot>')
    return file


def equipped(name: str, folder: Path) -> tuple[Path, mp.Robot]:
    """The file of an arm of the catalogue with a gripper and a pedestal, and the arm that is read from it."""
    known = mp.load_robot(name)
    file = known.source.file
    root = ET.fromstring(file.read_text(encoding="utf-8"))
    for mesh in root.iter("mesh"):
        path = str(mesh.get("filename")).removeprefix("package://").removeprefix("example-robot-data/robots/")
        mesh.set("filename", str(file.parents[2] / path))
    base = next(
        link.get("name")
        for link in root.findall("link")
        if all(link.get("name") != joint.find("child").get("link") for joint in root.findall("joint"))
    )
    flange = known.tool
    for link, parent, place, size in (
        ("pedestal", base, (0.0, 0.0, -0.3), (0.3, 0.3, 0.5)),
        ("palm", flange, (0.0, 0.0, 0.06), (0.05, 0.16, 0.06)),
        ("jaw_a", "palm", (0.0, 0.06, 0.1), (0.02, 0.02, 0.14)),
        ("jaw_b", "palm", (0.0, -0.06, 0.1), (0.02, 0.02, 0.14)),
        ("camera", "palm", (0.08, 0.0, -0.02), (0.1, 0.03, 0.03)),
    ):
        body = f'<box size="{size[0]} {size[1]} {size[2]}"/>'
        root.append(ET.fromstring(f'<link name="{link}"><collision><geometry>{body}</geometry></collision></link>'))
        root.append(ET.fromstring(fixed(link, parent, np.array(place))))
    own = folder / f"{name}.urdf"
    own.write_text(ET.tostring(root, encoding="unicode"))
    return own, mp.Robot.from_urdf(own, tool=flange, joints=known.joint_names, locked=dict(known.locked), name=name)


def row(name: str, file: Path, robot: mp.Robot, postures: int) -> list[int]:
    """Numbers of postures, contacts by the judge, wrongly free, wrongly touching, touching within the excess."""
    q = robot.random_configuration(np.random.default_rng(1), size=postures)
    judge, model = Judge(file, robot), mp.Scene().collision_model(robot)
    verdicts, ours = judge.verdicts(q), mp.Scene().in_collision(robot, q)
    counts = [0, 0, 0, 0, 0]
    excess = 2 * max(model.excess.values(), default=0.0) + ROUNDING
    disabled = set(robot.disabled_pairs or ())
    for k in range(postures):
        links = verdicts.touching[k] - verdicts.always - disabled
        if verdicts.touching[k] & verdicts.unclear and links <= verdicts.unclear:
            continue
        counts[0] += 1
        counts[1] += bool(links)
        if links and not ours[k]:
            counts[2] += 1
            print(name, "wrongly free", q[k].tolist(), sorted(map(sorted, links)))
        if ours[k] and not links:
            near = judge.least(q[k], verdicts.always | disabled | verdicts.unclear) <= excess
            counts[4 if near else 3] += 1
            if not near:
                print(name, "wrongly touching", q[k].tolist(), model.nearest_bodies(q[k][None])[0])
    return counts


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--postures", type=int, default=1000)
    parser.add_argument("--generated", type=int, default=12)
    options = parser.parse_args()
    lines = [
        "| arm | postures | in collision, by the judge | wrongly free | wrongly touching | within the excess of pieces |",
        "|---|---|---|---|---|---|",
    ]
    sums = np.zeros(5, dtype=int)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        arms = [*range(options.generated), *ARMS]
        for arm in track(arms, "arms"):
            if isinstance(arm, int):
                file = generated(arm, folder)
                name, robot = f"generated {arm}", mp.load_robot(file, tool="hand")
            else:
                name = arm
                file, robot = equipped(arm, folder)
            counts = row(name, file, robot, options.postures)
            sums += counts
            lines.append(f"| {name} | {' | '.join(map(str, counts))} |")
    lines += [f"| **all** | {' | '.join(map(str, sums))} |", "", "Command: `python benchmarks/fixed_bodies.py`."]
    OUT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(OUT.read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
