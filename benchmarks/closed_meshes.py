"""Random bodies inside, across and outside of closed meshes: every verdict against an independent signed distance.

Run with `make benchmark`. Each mesh stands in the scene, and is a link of the robot that moves. The judge is written here: the
distances of points, edges and triangles, and winding numbers, by NumPy. Writes docs/benchmarks/closed_meshes.md.
"""

import argparse
import platform
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "closed_meshes.md"
SEED = 44
#: Verdicts are not compared where the signed distance is smaller than this [m]: there rounding decides.
ROUNDING = 1e-6
HEAD = (
    "| mesh is | body is | verdicts | inside | across | outside "
    "| wrongly free | wrongly touching | of these beyond the excess |"
)
BODIES = ("sphere", "box", "tube")

Array = NDArray[np.float64]


# ---- closed meshes


def extruded(outline: Array, height: float) -> Array:
    """Triangles (t, 3, 3) of a prism over an outline (k, 2) that its middle sees as a whole."""
    k = len(outline)
    low, high = (np.column_stack([outline, np.full(k, z)]) for z in (-height / 2, height / 2))
    found = []
    for i in range(k):
        j = (i + 1) % k
        found += [[low[i], low[j], high[j]], [low[i], high[j], high[i]]]
        found += [[high[i], high[j], [0, 0, height / 2]], [low[j], low[i], [0, 0, -height / 2]]]
    return np.array(found)


def turned(profile: Sequence[tuple[float, float]], sides: int) -> Array:
    """Triangles (t, 3, 3) of a closed profile of radius and height, counterclockwise, turned around the z axis."""
    angle = 2 * np.pi * np.arange(sides) / sides
    corner = np.array([[[r * np.cos(a), r * np.sin(a), z] for r, z in profile] for a in angle])
    found = []
    for k in range(sides):
        here, following = corner[k], corner[(k + 1) % sides]
        for i in range(len(profile)):
            j = (i + 1) % len(profile)
            found += [[here[i], following[i], following[j]], [here[i], following[j], here[j]]]
    return np.array(found)


def blob(rng: np.random.Generator, rows: int = 12) -> Array:
    """A ball with random bumps and dents."""
    along, around = np.meshgrid(np.linspace(0, np.pi, rows), np.linspace(0, 2 * np.pi, 2 * rows, endpoint=False), indexing="ij")
    radius = rng.uniform(0.12, 0.25, along.shape)
    radius[0], radius[-1] = radius[0, 0], radius[-1, 0]
    corner = radius[..., None] * np.stack(
        [np.sin(along) * np.cos(around), np.sin(along) * np.sin(around), np.cos(along)], axis=-1
    )
    found = []
    for i in range(rows - 1):
        for j in range(2 * rows):
            m = (j + 1) % (2 * rows)
            a, b, c, d = corner[i, j], corner[i + 1, j], corner[i + 1, m], corner[i, m]
            found += ([[a, b, c]] if i < rows - 2 else []) + ([[a, c, d]] if i > 0 else [])
    return np.array(found)


def closed_mesh(number: int, rng: np.random.Generator) -> Array:
    """One of seven kinds of closed meshes of about half a metre, counterclockwise seen from outside."""
    size = rng.uniform(0.7, 1.3)
    if number % 7 == 0:
        return size * extruded(0.25 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float), 0.5)
    if number % 7 == 1:
        angle, radius = 2 * np.pi * np.arange(24) / 24, np.where(np.arange(24) % 2, 0.16, 0.25)
        return size * extruded(radius[:, None] * np.column_stack([np.cos(angle), np.sin(angle)]), 0.2)
    if number % 7 == 2:  # a ring
        return size * turned([(0.14, -0.08), (0.25, -0.08), (0.25, 0.08), (0.14, 0.08)], 32)
    if number % 7 == 3:  # a pot
        profile = [(1e-3, -0.2), (0.22, -0.2), (0.22, 0.2), (0.18, 0.2), (0.18, -0.12), (1e-3, -0.12)]
        return size * turned(profile, 24)
    if number % 7 == 4:
        return size * blob(rng)
    if number % 7 == 5:  # a hollow box: the wall around a cavity
        box = extruded(0.25 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=float), 0.5)
        return size * np.concatenate([box, 0.6 * box[:, ::-1]])
    corners = np.array([[0.0, -0.25], [0.25, -0.25], [0.25, -0.05], [0.05, 0.05], [-0.05, 0.25], [-0.25, 0.25], [-0.25, 0.0]])
    return size * extruded(corners, 0.3)


# ---- the judge


def winding(triangles: Array, point: Array) -> float:
    """How often closed triangles (t, 3, 3) go around a point: solid angles by van Oosterom and Strackee."""
    a, b, c = (triangles[:, k] - point for k in range(3))
    la, lb, lc = (np.linalg.norm(each, axis=1) for each in (a, b, c))
    volume = (a * np.cross(b, c)).sum(axis=1)
    under = la * lb * lc + (a * b).sum(axis=1) * lc + (b * c).sum(axis=1) * la + (c * a).sum(axis=1) * lb
    return float(np.arctan2(volume, under).sum() / (2 * np.pi))


def point_distance(points: Array, triangles: Array) -> float:
    """The smallest distance of points (k, 3) from the insides of triangles (t, 3, 3), where they project into them."""
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    gap = points[:, None] - triangles[None, :, 0]
    height = (gap * normal).sum(axis=2)
    foot = points[:, None] - height[..., None] * normal
    into = np.ones(height.shape, dtype=bool)
    for k in range(3):
        side = triangles[:, (k + 1) % 3] - triangles[:, k]
        into &= (np.cross(side, normal)[None] * (foot - triangles[None, :, k])).sum(axis=2) <= 0
    return float(np.where(into, np.abs(height), np.inf).min(initial=np.inf))


def segment_distance(one: Array, two: Array) -> float:
    """The smallest distance of segments (k, 2, 3) from segments (m, 2, 3)."""
    p, d = one[:, None, 0], (one[:, 1] - one[:, 0])[:, None]
    q, e = two[None, :, 0], (two[:, 1] - two[:, 0])[None]
    gap = p - q
    dd, ee, de = (d * d).sum(-1), (e * e).sum(-1), (d * e).sum(-1)
    dg, eg = (d * gap).sum(-1), (e * gap).sum(-1)
    best = np.full(de.shape, np.inf)
    with np.errstate(divide="ignore", invalid="ignore"):
        inner = np.nan_to_num((de * eg - ee * dg) / (dd * ee - de * de))
        for begin in (np.clip(inner, 0, 1), np.zeros_like(de), np.ones_like(de)):
            t = np.clip(np.nan_to_num((eg + begin * de) / ee), 0, 1)
            s = np.clip(np.nan_to_num((t * de - dg) / dd), 0, 1)
            t = np.clip(np.nan_to_num((eg + s * de) / ee), 0, 1)
            best = np.minimum(best, np.linalg.norm(gap + s[..., None] * d - t[..., None] * e, axis=-1))
    return float(best.min(initial=np.inf))


def cuts(segments: Array, triangles: Array) -> bool:
    """Whether any of segments (k, 2, 3) passes through any of triangles (t, 3, 3)."""
    start, way = segments[:, None, 0], (segments[:, 1] - segments[:, 0])[:, None]
    a, e, f = triangles[None, :, 0], (triangles[:, 1] - triangles[:, 0])[None], (triangles[:, 2] - triangles[:, 0])[None]
    h = np.cross(way, f)
    det = (e * h).sum(-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        s = start - a
        u = (s * h).sum(-1) / det
        g = np.cross(s, e)
        v, t = (way * g).sum(-1) / det, (f * g).sum(-1) / det
        return bool(((np.abs(det) > 0) & (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0) & (t <= 1)).any())


@dataclass(frozen=True, kw_only=True)
class Body:
    """A ball about a point, or closed triangles.

    Attributes:
        kind: one of BODIES.
        size: radius, or half sides, or inner and outer radius and length of a tube [m].
        triangles: (t, 3, 3); empty for a ball.
    """

    kind: str
    size: tuple[float, ...]
    triangles: Array

    @classmethod
    def random(cls, kind: str, rng: np.random.Generator) -> "Body":
        if kind == "sphere":
            return cls(kind=kind, size=(float(rng.uniform(0.01, 0.06)),), triangles=np.empty((0, 3, 3)))
        if kind == "box":
            half = rng.uniform(0.01, 0.06, 3)
            square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half[:2]
            return cls(kind=kind, size=tuple(half.tolist()), triangles=extruded(square, 2 * half[2]))
        inner, wall, length = rng.uniform(0.01, 0.03), rng.uniform(0.005, 0.02), rng.uniform(0.02, 0.1)
        outer = inner + wall
        profile = [(inner, -length / 2), (outer, -length / 2), (outer, length / 2), (inner, length / 2)]
        return cls(kind=kind, size=(inner, outer, length), triangles=turned(profile, 12))

    def collision(self, folder: Path) -> str:
        """The body in URDF."""
        if self.kind == "sphere":
            shape = f'<sphere radius="{self.size[0]}"/>'
        elif self.kind == "box":
            shape = f'<box size="{" ".join(str(2 * half) for half in self.size)}"/>'
        else:
            shape = f'<mesh filename="{write_mesh(folder / "tube.obj", self.triangles)}"/>'
        return f"<collision><geometry>{shape}</geometry></collision>"

    def signed_distance(self, pose: Array, mesh: Array) -> tuple[float, str]:
        """From closed triangles, at a pose (4, 4); and whether it is inside, across or outside of them."""
        if not len(self.triangles):
            centre = pose[:3, 3][None]
            edges = edges_of(mesh)
            apart = min(point_distance(centre, mesh), segment_distance(np.stack([centre, centre], axis=1), edges))
            within = abs(winding(mesh, centre[0])) > 0.5
            place = "across" if apart <= self.size[0] else "inside" if within else "outside"
            return (apart - self.size[0]) * (-1 if place == "inside" else 1), place
        own = self.triangles @ pose[:3, :3].T + pose[:3, 3]
        one, two = edges_of(own), edges_of(mesh)
        if cuts(one, mesh) or cuts(two, own):
            return -ROUNDING - 1e-9, "across"
        apart = min(
            point_distance(own.reshape(-1, 3), mesh), point_distance(mesh.reshape(-1, 3), own), segment_distance(one, two)
        )
        if abs(winding(mesh, own[0, 0])) > 0.5 or abs(winding(own, mesh[0, 0])) > 0.5:
            return -apart, "inside"
        return apart, "outside"


def edges_of(triangles: Array) -> Array:
    """Edges (k, 2, 3) of triangles (t, 3, 3), each once."""
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    return edges[
        (edges[:, 0] - edges[:, 1]) @ np.array([1.0, np.pi, np.e]) > 0
    ]  # the other triangle has it the other way round


# ---- robots


def write_mesh(file: Path, triangles: Array) -> Path:
    """Write triangles (t, 3, 3) as OBJ."""
    lines = ["v " + " ".join(f"{x:.17g}" for x in corner) for corner in triangles.reshape(-1, 3)]
    lines += [f"f {3 * k + 1} {3 * k + 2} {3 * k + 3}" for k in range(len(triangles))]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return file


def flying(body: Body, folder: Path, carried: str) -> mp.Robot:
    """A body that six joints carry, behind a first link, on a slide along x, with collision geometry `carried`."""
    chain, parent = [], "base"
    for name, kind, axis, most in (
        ("slide", "prismatic", "1 0 0", 1.0),
        *((f"p{axis}", "prismatic", axes, 1.0) for axis, axes in (("x", "1 0 0"), ("y", "0 1 0"), ("z", "0 0 1"))),
        *((f"r{axis}", "revolute", axes, 3.1) for axis, axes in (("x", "1 0 0"), ("y", "0 1 0"), ("z", "0 0 1"))),
    ):
        geometry = carried if name == "slide" else body.collision(folder) if name == "rz" else ""
        chain.append(f'<link name="{name}_link">{geometry}</link>')
        chain.append(
            f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{name}_link"/><axis xyz="{axis}"/>'
            f'<limit lower="-{most}" upper="{most}" velocity="1" effort="1"/></joint>'
        )
        parent = f"{name}_link"
    file = folder / "flying.urdf"
    file.write_text(f'<robot name="flying"><link name="base"/>{"".join(chain)}</robot>', encoding="utf-8")
    return mp.Robot.from_urdf(file, tool=parent)


def pose_of(q: Array) -> Array:
    """The pose (4, 4) of the body relative to the first link at q (7,)."""
    pose = np.eye(4)
    pose[:3, 3] = q[1:4]
    for k, angle in enumerate(q[4:]):
        c, s, turn = np.cos(angle), np.sin(angle), np.eye(3)
        i, j = (k + 1) % 3, (k + 2) % 3
        turn[i, i], turn[i, j], turn[j, i], turn[j, j] = c, -s, s, c
        pose[:3, :3] = pose[:3, :3] @ turn
    return pose


def places(mesh: Array, count: int, rng: np.random.Generator) -> Array:
    """Configurations (count, 7): a third of the bodies near the surface, the others anywhere in and around the mesh's box."""
    q = np.column_stack([rng.uniform(-1, 1, count), np.zeros((count, 3)), rng.uniform(-3, 3, (count, 3))])
    low, high = mesh.min(axis=(0, 1)), mesh.max(axis=(0, 1))
    q[:, 1:4] = rng.uniform(low - 0.05, high + 0.05, (count, 3))
    near = rng.random(count) < 1 / 3
    chosen = mesh[rng.integers(len(mesh), size=int(near.sum()))].mean(axis=1)
    q[near, 1:4] = chosen + rng.normal(scale=0.05, size=chosen.shape)
    return q


@dataclass(kw_only=True)
class Row:
    """Counts of one line of the table."""

    verdicts: int = 0
    inside: int = 0
    across: int = 0
    outside: int = 0
    free: int = 0
    touching: int = 0
    beyond: int = 0

    def count(self, hits: Array, found: Sequence[tuple[float, str]], excess: float) -> None:
        """Add verdicts, `hits` (m,), and what the judge found; `excess`: by how much bodies are known to stick out [m]."""
        for hit, (distance, place) in zip(hits, found, strict=True):
            if abs(distance) < ROUNDING:
                continue
            self.verdicts += 1
            setattr(self, place, getattr(self, place) + 1)
            self.free += int(not hit and distance < 0)
            self.touching += int(hit and distance > 0)
            self.beyond += int(hit and distance > excess + ROUNDING)


def measure(meshes: int, bodies: int) -> dict[tuple[str, str], Row]:
    """Verdicts of `bodies` bodies per mesh, by where the mesh is and what the body is."""
    rng, rows = np.random.default_rng(SEED), {(where, kind): Row() for where in ("obstacle", "link") for kind in BODIES}
    for number in track(range(meshes), "closed meshes"):
        mesh = closed_mesh(number, rng)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            carried = f'<collision><geometry><mesh filename="{write_mesh(folder / "mesh.obj", mesh)}"/></geometry></collision>'
            for kind in BODIES:
                body, q = Body.random(kind, rng), places(mesh, -(-bodies // len(BODIES)), rng)
                found = [body.signed_distance(pose_of(each), mesh) for each in q]
                link = mp.Scene().collision_model(flying(body, folder, carried))
                rows["link", kind].count(link.in_collision_rows(q), found, 2 * max(link.excess.values(), default=0.0))
                q[:, 0] = 0.0  # the obstacle stands where the first link is then
                alone = mp.Scene([mp.Mesh(triangles=mesh, name="mesh")]).collision_model(flying(body, folder, ""))
                rows["obstacle", kind].count(alone.in_collision_rows(q), found, max(alone.excess.values(), default=0.0))
    return rows


def main(arguments: Sequence[str] | None = None) -> dict[tuple[str, str], Row]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--meshes", type=int, default=50)
    parser.add_argument("--bodies", type=int, default=21, help="bodies per mesh")
    parser.add_argument("--out", type=Path, default=OUT)
    given = parser.parse_args(arguments)
    rows = measure(given.meshes, given.bodies)
    lines = [HEAD, "|---" * 9 + "|"]
    for (where, kind), row in rows.items():
        cells = [
            where,
            kind,
            *map(str, (row.verdicts, row.inside, row.across, row.outside, row.free, row.touching, row.beyond)),
        ]
        lines.append(f"| {' | '.join(cells)} |")
    command = f"python benchmarks/closed_meshes.py --meshes {given.meshes} --bodies {given.bodies}"
    lines += ["", f"Python {platform.python_version()}, {platform.machine()}; command: `{command}`."]
    given.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(given.out.read_text(encoding="utf-8"))
    return rows


if __name__ == "__main__":
    main()
