"""Generated meshes in every format as collision meshes of a URDF: each body where it was drawn, to 1e-9.

A drawing is a solid of polygons: prisms and cones of 3 to 5,000 sides, stars (concave polygons), slivers. It is written as STL,
OBJ, PLY, COLLADA or GLB by this file, in one of several units, below nested nodes, wound outward or inward, and placed by the
URDF with a scale (which may mirror it) and an origin. Two judges: the drawing itself, and trimesh where it reads the format
in full precision. Every file is read a second time cut off at a random place: then it is refused, or gives the whole body.
Writes docs/benchmarks/mesh_readers.md.
"""

import argparse
import json
import platform
import struct
import tempfile
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh
from numpy.typing import NDArray
from rich.progress import track
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "mesh_readers.md"
#: Largest distance of a corner, and difference of areas and volumes in units of the size, that passes.
CLOSE = 1e-9
FORMATS = ("binary.stl", "text.stl", "plain.obj", "negative.obj", "text.ply", "little.ply", "big.ply", "nodes.dae", "nodes.glb")
#: Formats whose end cannot be seen in the file.
OPEN_ENDED = ("plain.obj", "negative.obj")
#: Formats with coordinates of 32 bits, in which polygons would not be flat: they hold triangles.
SHORT = ("binary.stl", "big.ply", "nodes.glb")

Points = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Drawing:
    """A solid: corners (v, 3) and the corners of each polygon, in order; outward: whether these turn left seen from outside."""

    points: Points
    faces: list[list[int]]
    outward: bool


def draw(rng: np.random.Generator) -> Drawing:
    """A prism, cone or star of random shape and size, or a sliver of one, at a random place."""
    kind = rng.choice(["prism", "cone", "star"])
    sides = int(rng.choice([rng.integers(3, 12), rng.integers(3, 300), rng.integers(3, 5001)], p=[0.8, 0.18, 0.02]))
    sides = max(sides, 6) + max(sides, 6) % 2 if kind == "star" else sides
    angles = 2 * np.pi * np.arange(sides) / sides
    radii = np.where(np.arange(sides) % 2, 0.4, 1.0) if kind == "star" else np.ones(sides)
    ring = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    low = np.c_[ring, np.full(sides, -0.5)]
    if kind == "cone":
        points = np.r_[low, [[0.0, 0.0, 0.5]]]
        faces = [[k, (k + 1) % sides, sides] for k in range(sides)]
    else:
        points = np.r_[low, np.c_[ring, np.full(sides, 0.5)]]
        faces = [[k, (k + 1) % sides, sides + (k + 1) % sides, sides + k] for k in range(sides)]
        faces.append(list(range(sides, 2 * sides)))
    faces.append(list(range(sides))[::-1])
    stretch = 10 ** rng.uniform(-5, 0, 3) if rng.random() < 0.2 else rng.uniform(0.05, 1.0, 3)
    points = rng.uniform(0.1, 1.0) * points * stretch @ Rotation.random(rng=rng).as_matrix().T + rng.uniform(-1, 1, 3)
    if rng.random() < 0.3:  # triangles only
        faces = (
            [[face[0], face[j], face[j + 1]] for face in faces for j in range(1, len(face) - 1)] if kind != "star" else faces
        )
    outward = bool(rng.random() < 0.7)
    return Drawing(points=points, faces=faces if outward else [face[::-1] for face in faces], outward=outward)


def triangles_of(points: Points, faces: list[list[int]]) -> list[list[int]]:
    """The triangles of the polygons: fans, and of a star its tips and the polygon between them."""
    found = []
    for face in faces:
        if len(face) > 4 and _is_star(points[face]):
            tips = [k for k in range(len(face)) if k % 2 == _tip(points[face])]
            found += [[face[k - 1], face[k], face[(k + 1) % len(face)]] for k in tips]
            inner = [face[k] for k in range(len(face)) if k not in tips]
            found += [[inner[0], inner[j], inner[j + 1]] for j in range(1, len(inner) - 1)]
        else:
            found += [[face[0], face[j], face[j + 1]] for j in range(1, len(face) - 1)]
    return found


def _is_star(corners: Points) -> bool:
    along = np.roll(corners, -1, axis=0) - corners
    turns = np.cross(np.roll(along, 1, axis=0), along)
    return bool((turns @ turns[0] < 0).any())


def _tip(corners: Points) -> int:
    """0 or 1: whether the even or the odd corners of a star are its tips: an affine picture of it turns right at the others."""
    along = np.roll(corners, -1, axis=0) - corners
    turns = np.cross(np.roll(along, 1, axis=0), along)
    whole = np.cross(corners - corners.mean(axis=0), np.roll(corners - corners.mean(axis=0), -1, axis=0)).sum(axis=0)
    return 0 if turns[0] @ whole > 0 else 1


def write(rng: np.random.Generator, kind: str, drawing: Drawing) -> tuple[bytes, Points]:
    """The file of a drawing, and the transform (4, 4) of its nodes in metres."""
    points, faces = drawing.points, drawing.faces
    nodes = np.eye(4)
    if kind in ("binary.stl", "text.stl"):
        corners = points[triangles_of(points, faces)]
        if kind == "binary.stl":
            rows = b"".join(struct.pack("<12fH", 0, 0, 0, *each.ravel(), 0) for each in corners)
            return b"drawn".ljust(80) + struct.pack("<I", len(corners)) + rows, nodes
        text = "".join(
            "facet normal 0 0 0\nouter loop\n"
            + "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in each.tolist())
            + "endloop\nendfacet\n"
            for each in corners
        )
        return f"solid drawn\n{text}endsolid drawn\n".encode(), nodes
    lines = [f"{x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    if kind.endswith(".obj"):
        start = len(points) if kind == "negative.obj" else -1
        text = "".join(f"v {line}\n" for line in lines) + "vn 0 0 1\nvt 0 0\ng drawn\n"
        slash = rng.choice(["", "//1", "/1/1"])
        text += "".join("f " + " ".join(f"{k - start}{slash}" for k in face) + "\n" for face in faces)
        return text.encode(), nodes
    if kind.endswith(".ply"):
        form = {"text.ply": "ascii", "little.ply": "binary_little_endian", "big.ply": "binary_big_endian"}[kind]
        number = "float" if kind == "big.ply" else "double"
        faces = triangles_of(points, faces) if kind == "big.ply" else faces
        head = f"ply\nformat {form} 1.0\nelement vertex {len(points)}\n" + "".join(f"property {number} {c}\n" for c in "xyz")
        head += f"element face {len(faces)}\nproperty list int int vertex_indices\nend_header\n"
        if kind == "text.ply":
            body = "\n".join(lines) + "\n" + "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in faces)
            return (head + body).encode(), nodes
        order = "<" if kind == "little.ply" else ">"
        packed = points.astype(f"{order}f{4 if kind == 'big.ply' else 8}").tobytes()
        return head.encode() + packed + b"".join(struct.pack(f"{order}i{len(f)}i", len(f), *f) for f in faces), nodes
    if kind == "nodes.glb":
        return _glb(rng, drawing)
    return _collada(rng, drawing)


def _collada(rng: np.random.Generator, drawing: Drawing) -> tuple[bytes, Points]:
    unit = float(rng.choice([1.0, 0.001, 0.01, 0.0254]))
    points, faces, nodes = drawing.points / unit, drawing.faces, np.eye(4)
    opening, depth = "", int(rng.integers(0, 4))
    for _ in range(depth):
        opening += "<node>"
        for kind in rng.permutation(["matrix", "translate", "rotate", "scale"])[: rng.integers(0, 4)]:
            step = np.eye(4)
            if kind == "translate":
                step[:3, 3] = rng.uniform(-0.2, 0.2, 3) / unit
                numbers = step[:3, 3]
            elif kind == "scale":
                step[:3, :3] = np.diag(rng.uniform(0.7, 1.3, 3) * rng.choice([1, -1], 3, p=[0.8, 0.2]))
                numbers = np.diag(step)[:3]
            elif kind == "rotate":
                axis, angle = Rotation.random(rng=rng).as_matrix()[0], rng.uniform(-180, 180)
                step[:3, :3] = Rotation.from_rotvec(np.deg2rad(angle) * axis).as_matrix()
                numbers = np.r_[axis, angle]
            else:
                step[:3, :3] = Rotation.random(rng=rng).as_matrix() @ np.diag(rng.uniform(0.8, 1.2, 3))
                step[:3, 3] = rng.uniform(-0.1, 0.1, 3) / unit
                numbers = step.ravel()
            opening += f"<{kind}>{' '.join(map(repr, numbers.tolist()))}</{kind}>"
            nodes = nodes @ step
    source = "".join(f"{x!r} {y!r} {z!r} " for x, y, z in points.tolist())
    corner = '<input semantic="VERTEX" source="#v" offset="0"/>'
    if rng.random() < 0.5:
        counts = " ".join(str(len(face)) for face in faces)
        indices = " ".join(f"{k} 0" for face in faces for k in face)
        body = f'<polylist count="{len(faces)}">{corner}<input semantic="NORMAL" source="#n" offset="1"/>'
        body += f"<vcount>{counts}</vcount><p>{indices}</p></polylist>"
    else:
        listed = "".join(f"<p>{' '.join(map(str, face))}</p>" for face in faces)
        body = f'<polygons count="{len(faces)}">{corner}{listed}</polygons>'
    up = rng.choice(["X_UP", "Y_UP", "Z_UP"])
    text = (
        f'<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>'
        f'<unit meter="{unit!r}"/><up_axis>{up}</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="s">'
        f'<float_array id="a" count="{points.size}">{source}</float_array><technique_common><accessor source="#a" '
        f'count="{len(points)}" stride="3"><param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common>'
        f'</source><source id="n"><float_array id="b" count="3">0 0 1</float_array><technique_common><accessor source="#b" '
        f'count="1" stride="3"><param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common></source>'
        f'<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>{body}</mesh></geometry></library_geometries>'
        f'<library_visual_scenes><visual_scene id="w"><node>{opening}<instance_geometry url="#g"/>{"</node>" * depth}</node>'
        '</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>'
    )
    nodes[:3, 3] *= unit  # points of the drawing are in metres
    return text.encode(), nodes


def _glb(rng: np.random.Generator, drawing: Drawing) -> tuple[bytes, Points]:
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = Rotation.random(rng=rng).as_matrix(), rng.uniform(-0.3, 0.3, 3)
    triangles = np.array(triangles_of(drawing.points, drawing.faces), dtype="<u4")
    corners = drawing.points.astype("<f4")
    data = corners.tobytes() + triangles.tobytes()
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "matrix": place.T.ravel().tolist()}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3", "min": corners.min(0).tolist()}
            | {"max": corners.max(0).tolist()},
            {"bufferView": 1, "componentType": 5125, "count": triangles.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": corners.nbytes},
            {"buffer": 0, "byteOffset": corners.nbytes, "byteLength": triangles.nbytes},
        ],
        "buffers": [{"byteLength": len(data)}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks, place


def figures(points: Points, faces: list[list[int]]) -> tuple[float, float]:
    """Area and signed volume of planar polygons, by the vector area of each."""
    middle, area, volume = points.mean(axis=0), 0.0, 0.0
    for face in faces:
        corners = points[face] - middle
        vector = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0) / 2
        area += float(np.linalg.norm(vector))
        volume += float(vector @ corners[0]) / 3
    return area, volume


def differences(ours: tuple[Points, Points], theirs: Points, area: float, volume: float) -> float:
    """The largest distance of a corner, and differences of area and volume, against the drawing [m, in units of its size]."""
    corners, triangles = ours
    size = max(1.0, float(np.ptp(theirs, axis=0).max()))
    apart = max(cKDTree(theirs).query(corners)[0].max(), cKDTree(corners).query(theirs)[0].max())
    local = triangles - theirs.mean(axis=0)
    vectors = np.cross(local[:, 1] - local[:, 0], local[:, 2] - local[:, 0]) / 2
    found_area = float(np.linalg.norm(vectors, axis=1).sum())
    found_volume = float(np.einsum("ti,ti->", vectors, local[:, 0])) / 3
    return max(float(apart), abs(found_area - area) / size**2, abs(found_volume - volume) / size**3)


def body_of(folder: Path) -> tuple[Points, Points]:
    """Corners (v, 3) and triangles (t, 3, 3) of the arm's only body, in the frame of its link."""
    [item] = mp.Robot.from_urdf(folder / "arm.urdf", tool="l1").geometry.geometryObjects
    tree, place = item.geometry, item.placement
    corners = np.array(tree.vertices()) @ place.rotation.T + place.translation
    faces = np.array([[tree.tri_indices(k)[j] for j in range(3)] for k in range(tree.num_tris)])
    return corners, corners[faces]


def one(rng: np.random.Generator, folder: Path, kind: str) -> tuple[float, float, str]:
    """The difference to the drawing and to trimesh of one mesh, and what became of the file that is cut off."""
    drawing = draw(rng)
    data, nodes = write(rng, kind, drawing)
    file = folder / f"mesh.{kind.partition('.')[2]}"
    file.write_bytes(data)
    scale = rng.uniform(0.5, 1.5, 3) * rng.choice([1, -1], 3, p=[0.8, 0.2])
    xyz, rpy = rng.uniform(-0.5, 0.5, 3), rng.uniform(-3, 3, 3)
    texts = {name: " ".join(map(repr, value.tolist())) for name, value in (("xyz", xyz), ("rpy", rpy), ("scale", scale))}
    (folder / "arm.urdf").write_text(
        '<robot name="arm"><link name="base"/><link name="l1"><collision><origin xyz="{xyz}" rpy="{rpy}"/><geometry>'
        '<mesh filename="{file}" scale="{scale}"/></geometry></collision></link><joint name="j" type="revolute">'
        '<parent link="base"/><child link="l1"/><origin xyz="0 0 1"/><axis xyz="0 0 1"/>'
        '<limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>'.format(file=file.name, **texts)
    )
    ours = body_of(folder)
    drawn = drawing.points.astype(np.float32).astype(float) if kind in SHORT else drawing.points
    place = np.eye(4)
    place[:3, :3] = Rotation.from_euler("xyz", rpy).as_matrix() @ np.diag(scale)
    place[:3, 3] = xyz

    def placed(points: Points) -> Points:
        whole = place @ nodes
        return points @ whole[:3, :3].T + whole[:3, 3]

    faces = triangles_of(drawing.points, drawing.faces) if kind in SHORT else drawing.faces
    area, volume = figures(placed(drawn), faces)
    apart = differences(ours, placed(drawn), area, abs(volume) * (1 if drawing.outward else -1))
    return apart, _against_trimesh(kind, file, faces, ours, place), _cut_off(rng, kind, folder, file, data, ours)


def _against_trimesh(kind: str, file: Path, faces: list[list[int]], ours: tuple[Points, Points], place: Points) -> float:
    """The largest distance of a corner to trimesh's [m]; NaN where trimesh does not read the file, or in 32 bits only."""
    if kind in ("nodes.dae", "text.stl") or (kind.endswith(".ply") and len(set(map(len, faces))) > 1):
        return np.nan
    mesh = trimesh.load_scene(file, process=False).to_geometry()
    theirs = np.asarray(mesh.vertices, dtype=float) @ place[:3, :3].T + place[:3, 3]
    theirs = theirs[np.unique(mesh.faces)]
    return float(max(cKDTree(theirs).query(ours[0])[0].max(), cKDTree(ours[0]).query(theirs)[0].max()))


def _cut_off(rng: np.random.Generator, kind: str, folder: Path, file: Path, data: bytes, ours: tuple[Points, Points]) -> str:
    file.write_bytes(data[: int(rng.integers(len(data)))])
    try:
        corners, triangles = body_of(folder)
    except mp.errors.ManipplanError:
        return "refused"
    if np.array_equal(corners, ours[0]) and np.array_equal(triangles, ours[1]):
        return "the same body"
    return "less, which cannot be seen" if kind in OPEN_ENDED else "LESS"


def main(arguments: list[str] | None = None) -> dict[str, list[tuple[float, float, str]]]:
    """Run, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10_000, help="number of meshes")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=OUT)
    options = parser.parse_args(arguments)
    found: dict[str, list[tuple[float, float, str]]] = {kind: [] for kind in FORMATS}
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        for k in track(range(options.count), description="meshes"):
            kind = FORMATS[k % len(FORMATS)]
            found[kind].append(one(np.random.default_rng([options.seed, k]), Path(folder), kind))
    seconds = (time.perf_counter() - start) / options.count
    lines = ["| format | meshes | within 1e-9 of the drawing | largest difference | read by trimesh | largest distance to it "]
    lines[0] += "| cut off: refused | the same body | less |"
    lines.append("|---|---|---|---|---|---|---|---|---|")
    for kind, rows in found.items():
        ends = Counter(end for _, _, end in rows)
        apart, theirs = np.array([each[:2] for each in rows]).reshape(-1, 2).T
        asked = theirs[~np.isnan(theirs)]
        less = sum(count for end, count in ends.items() if end.lower().startswith("less"))
        lines.append(
            f"| {kind} | {len(rows)} | {(apart <= CLOSE).sum()} | {apart.max(initial=0.0):.0e} | {len(asked)} "
            f"| {f'{asked.max():.0e}' if len(asked) else ''} | {ends['refused']} | {ends['the same body']} | {less} |"
        )
    close = sum(apart <= CLOSE for rows in found.values() for apart, _, _ in rows)
    lines.append(f"| all | {options.count} | {close} | | | | | | |")
    text = (
        f"{seconds * 1e3:.0f} ms for each mesh, both readings and the judges; an OBJ file does not say where it ends. "
        f"Python {platform.python_version()}, {platform.machine()}; seed {options.seed}; "
        f"command: `.venv/bin/python benchmarks/mesh_readers.py --count {options.count}`."
    )
    options.out.write_text("\n".join([*lines, "", text, ""]))
    print(options.out.read_text())
    return found


if __name__ == "__main__":
    main()
