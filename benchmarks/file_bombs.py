"""Files that ask for much: each is refused within 5 s and 1 GB, or read.

Run with `python benchmarks/file_bombs.py`; --only takes part of a name, --count a number of files. A child process reads each
file. Its time is that of the processor, with that of the processes which it starts, and its memory the largest of any of them;
the import of the package, some 0.2 GB, counts. Writes docs/benchmarks/file_bombs.md.
"""

import argparse
import io
import json
import os
import platform
import struct
import subprocess
import sys
import tempfile
import time
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "file_bombs.md"
#: Bounds on time [s] and memory [bytes] of a refusal, and when a child is stopped [s].
MOST_TIME, MOST_MEMORY, STOP = 5.0, 2**30, 120.0
#: How each kind of file is read.
READERS = {
    "cloud": "mp.Scene([mp.PointCloud(file=file, radius=0.01)]).in_collision(ARM, [0.1, 0.2])",
    "mesh": "mp.Scene([mp.Mesh(file=file)]).in_collision(ARM, [0.1, 0.2])",
    "scene": "mp.Scene.from_yaml(file).in_collision(ARM, [0.1, 0.2])",
    "moveit": "mp.Scene.from_moveit(file)",
    "mujoco scene": "mp.Scene.from_mjcf(file)",
    "mujoco arm": "mp.Robot.from_mjcf(file, tool='b')",
    "urdf": "mp.Robot.from_urdf(file)",
    "motion": "dict(csv=mp.Trajectory.from_csv, json=mp.Trajectory.from_json, yaml=mp.Trajectory.from_ros, "
    "npz=mp.Trajectory.from_npz)[file.rsplit('.')[-1]](file)",
    "poses": "mp.CartesianPath.from_csv(file)",
    "plan": "mp.Plan.load(file)",
    "report": "mp.results.Report.from_json(file)",
}
CHILD = """
import sys, resource, warnings
import manipplan as mp

def spent():
    both = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    seconds = sum(each.ru_utime + each.ru_stime for each in both)
    own = [line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM")]  # without its parent
    return seconds, max(int(own[0]), both[1].ru_maxrss)

warnings.simplefilter("ignore")
ARM = mp.planar_arm([1.0, 1.0])
mp.Scene([mp.Sphere(radius=0.1, position=(5.0, 0.0, 0.0))]).in_collision(ARM, [0.1, 0.2])
file, began = sys.argv[1], spent()[0]
try:
    {read}
    said = "read"
except mp.errors.ManipplanError as error:
    said = "refused: " + str(error)[:2000]
except BaseException as error:
    said = "FAULT: " + type(error).__name__ + ": " + str(error)[:200]
seconds, kilobytes = spent()
print(seconds - began, kilobytes)
print(" ".join(said.split()))
"""


@dataclass(frozen=True, kw_only=True)
class Bomb:
    """A file: its kind, its name, and what it holds."""

    kind: str
    name: str
    made: Callable[[], bytes]


def npz(array: np.ndarray, names: str = "points") -> bytes:
    """An archive of arrays, compressed."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in names.split():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as stream:
                head = io.BytesIO()
                described = np.lib.format.header_data_from_array_1_0(array[:1])
                np.lib.format.write_array_header_1_0(head, {**described, "shape": array.shape})
                stream.write(head.getvalue())
                step = max(1, 10**7 // max(array[:1].nbytes, 1))
                for first in range(0, len(array), step):
                    stream.write(np.ascontiguousarray(array[first : first + step]).tobytes())
    return out.getvalue()


def points_npz(count: int, kind: str) -> bytes:
    """Equal points."""
    return npz(np.broadcast_to(np.ones(1, kind), (count, 3)))


def pcd(count: int, form: str, body: bytes = b"") -> bytes:
    """A PCD file of points of three floats."""
    head = (
        f"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {count}\nHEIGHT 1\nPOINTS {count}\nDATA {form}\n"
    )
    return head.encode() + body


def lzf_zeros(size: int) -> bytes:
    """Zeros in the format LZF, with the two lengths before them: one byte, then references to it."""
    out = bytearray([0, 0])
    left = size - 1
    while left >= 264:
        out += bytes([0xE0, 255, 0])
        left -= 264
    while left > 0:
        part = min(left, 8)
        if part < 3:
            out += bytes([part - 1, *([0] * part)])
        else:
            out += bytes([(part - 2) << 5, 0])
        left -= part
    return struct.pack("<II", len(out), size) + bytes(out)


def lzf_runs(size: int) -> bytes:
    """Bytes that are not compressed."""
    out = b"".join(bytes([31]) + bytes(32) for _ in range(size // 32))
    return struct.pack("<II", len(out), size) + out


def gltf(count: int, *, view: bool, indices: int = 0, kind: int = 5126, length: int = 36) -> bytes:
    """A glTF file whose positions, and indices, have `count` elements by their accessor."""
    data = "data:application/octet-stream;base64," + "A" * (length * 4 // 3)
    accessors = [{"componentType": kind, "count": count, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]}]
    primitive: dict[str, object] = {"attributes": {"POSITION": 0}}
    if indices:
        accessors.append({"componentType": 5125, "count": indices, "type": "SCALAR"})
        primitive["indices"] = 1
    if view:
        accessors = [each | {"bufferView": 0} for each in accessors]
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "accessors": accessors,
        "bufferViews": [{"buffer": 0, "byteLength": length}],
        "buffers": [{"byteLength": length, "uri": data}],
    }
    return json.dumps(document).encode()


def many_nodes(depth: int, width: int) -> bytes:
    """A glTF file whose nodes share children, so that one mesh stands in it width^depth times."""
    document = json.loads(gltf(3, view=True))
    document["nodes"] = [{"children": [k + 1] * width} for k in range(depth)] + [{"mesh": 0}]
    return json.dumps(document).encode()


def ply(vertices: int, faces: int, form: str = "ascii", body: bytes = b"") -> bytes:
    """A PLY file that announces vertices and faces."""
    head = f"ply\nformat {form} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n"
    return (head + f"element face {faces}\nproperty list uchar int vertex_indices\nend_header\n").encode() + body


def collada(instances: int, depth: int) -> bytes:
    """A DAE file whose nodes hold the next one several times."""
    inner = '<instance_geometry url="#g"/>'
    nodes = "".join(
        f'<node id="n{k}">' + (f'<instance_node url="#n{k + 1}"/>' * instances if k + 1 < depth else inner) + "</node>"
        for k in range(depth)
    )
    mesh = (
        '<geometry id="g"><mesh><source id="s"><float_array id="f" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>'
        '<accessor source="#f" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>'
        '<param name="Z" type="float"/></accessor>'
        '</technique_common></source><vertices id="v"><input semantic="POSITION" source="#s"/></vertices>'
        '<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>'
    )
    return (
        '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset/>'
        f"<library_geometries>{mesh}</library_geometries><library_nodes>{nodes}</library_nodes><library_visual_scenes>"
        '<visual_scene id="w"><node><instance_node url="#n0"/></node></visual_scene></library_visual_scenes>'
        '<scene><instance_visual_scene url="#w"/></scene></COLLADA>'
    ).encode()


def mujoco(inner: str, *, extra: str = "") -> bytes:
    """An MJCF file with one arm of a joint, and more in its world."""
    arm = '<body name="b"><joint name="j" type="hinge" axis="0 0 1" range="-1 1"/><geom size=".1"/></body>'
    return f"<mujoco>{extra}<worldbody>{arm}{inner}</worldbody></mujoco>".encode()


#: Elements of MJCF that ask for much in a few letters.
ASKED = {
    "texture": '<asset><texture name="t" type="2d" builtin="flat" width="30000" height="30000"/></asset>',
    "plate": '<asset><mesh name="m" builtin="plate" params="3000 3000"/></asset>',
    "sensor": '<sensor><user dim="500000000" name="x"/></sensor>',
    "keys": '<size nkey="100000000"/>',
    "numbers": '<size nuser_geom="100000000" nuser_body="100000000"/>',
    "memory": '<size memory="100G"/>',
}


def replicate(counts: list[int], inner: str = '<geom size=".1"/>') -> str:
    """Nested repetitions."""
    for count in counts:
        inner = f'<replicate count="{count}" offset="1 0 0">{inner}</replicate>'
    return inner


def urdf(inner: str = "", *, links: int = 1, head: str = "") -> bytes:
    """A chain of links, and more."""
    limit = '<limit lower="-1" upper="1" velocity="1" effort="1"/>'
    joints = "".join(
        f'<joint name="j{k}" type="revolute"><parent link="l{k}"/><child link="l{k + 1}"/><axis xyz="0 0 1"/>{limit}</joint>'
        for k in range(links)
    )
    bodies = "".join(f'<link name="l{k}"/>' for k in range(links + 1))
    return f'<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro">{head}{bodies}{joints}{inner}</robot>'.encode()


def doubling(depth: int, call: str = "") -> bytes:
    """A xacro file whose macros call the next one twice."""
    macros = "".join(f'<xacro:macro name="m{k}"><xacro:m{k - 1}/><xacro:m{k - 1}/></xacro:macro>' for k in range(1, depth + 1))
    return urdf(head=f'<xacro:macro name="m0"><gazebo/></xacro:macro>{macros}<xacro:m{depth}/>{call}')


def aliases(levels: int, width: int, head: str = "obstacles") -> bytes:
    """YAML whose aliases hold each other."""
    lines = [f"a0: &a0 [{', '.join(['1'] * width)}]"]
    lines += [f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * width)}]" for k in range(1, levels)]
    return "\n".join([*lines, f"{head}: *a{levels - 1}"]).encode()


def yaml_cloud(count: int) -> bytes:
    """A scene with points."""
    return b"obstacles:\n- shape: cloud\n  radius: 0.01\n  points:\n" + b"  - [1, 2, 3]\n" * count


def ros_points(count: int) -> bytes:
    """A JointTrajectory."""
    point = "- {positions: [0.0, 0.0], velocities: [0.0, 0.0], time_from_start: {sec: %d, nanosec: 0}}\n"
    return ("joint_names: [joint1, joint2]\npoints:\n" + "".join(point % k for k in range(count))).encode()


def csv_rows(count: int) -> bytes:
    """A recording."""
    return ("time,q_joint1,q_joint2\n" + "".join(f"{k},0.1,0.2\n" for k in range(count))).encode()


def pose_rows(count: int) -> bytes:
    """Poses on a line."""
    return ("x,y,z,qw,qx,qy,qz\n" + "".join(f"{k / count:.9f},0,0,1,0,0,0\n" for k in range(count))).encode()


def json_motion(count: int) -> bytes:
    """A trajectory in JSON."""
    data = {"format": "manipplan-trajectory", "version": 1, "joint_names": ["joint1", "joint2"]}
    data |= {"time": list(range(count)), "position": [[0.1, 0.2]] * count, "velocity": [[0.0, 0.0]] * count}
    return json.dumps(data).encode()


def stl_text(count: int) -> bytes:
    """Facets in text."""
    facet = b"facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    return b"solid a\n" + facet * count + b"endsolid a\n"


def stl_binary(count: int) -> bytes:
    """Facets in binary, all different."""
    rows = np.zeros(count, [("n", "<f4", 3), ("c", "<f4", (3, 3)), ("a", "<u2")])
    rows["c"] = np.random.default_rng(0).random((count, 3, 3))
    return bytes(80) + struct.pack("<I", count) + rows.tobytes()


def obj_text(count: int, polygon: int = 3) -> bytes:
    """Faces in text."""
    corners = b"".join(f"v {np.cos(k):.6f} {np.sin(k):.6f} {k % 7}\n".encode() for k in range(max(polygon, 3)))
    return corners + (b"f " + b" ".join(str(k + 1).encode() for k in range(polygon)) + b"\n") * count


def obj_polygon(corners: int) -> bytes:
    """One face of many corners on a star."""
    angles = np.linspace(0, 2 * np.pi, corners, endpoint=False)
    radius = 1 + 0.5 * (np.arange(corners) % 2)
    rows = "".join(f"v {r * np.cos(a):.9f} {r * np.sin(a):.9f} 0\n" for a, r in zip(angles, radius, strict=True))
    return (rows + "f " + " ".join(str(k + 1) for k in range(corners)) + "\n").encode()


def bombs() -> Iterator[Bomb]:
    """All files."""

    def bomb(kind: str, name: str, made: Callable[[], bytes]) -> Bomb:
        return Bomb(kind=kind, name=name, made=made)

    for count in (10**6, 10**7, 10**8):
        yield bomb("cloud", f"int8_{count:.0e}.npz", lambda n=count: points_npz(n, "i1"))
    yield bomb("cloud", "float64_2e7.npz", lambda: points_npz(2 * 10**7, "f8"))
    yield bomb("cloud", "two_arrays.npz", lambda: npz(np.broadcast_to(np.ones(1, "i1"), (2 * 10**7, 3)), "points other"))
    yield bomb("cloud", "wide.npz", lambda: npz(np.broadcast_to(np.ones(1, "i1"), (3, 10**8))))
    yield bomb("cloud", "cut_off.npz", lambda: points_npz(10**6, "i1")[:-100])
    for count in (10**6, 2 * 10**7, 10**8):
        yield bomb("cloud", f"zeros_{count:.0e}.pcd", lambda n=count: pcd(n, "binary_compressed", lzf_zeros(12 * n)))
    yield bomb("cloud", "runs_2e6.pcd", lambda: pcd(2 * 10**6, "binary_compressed", lzf_runs(24 * 10**6)))
    yield bomb("cloud", "announced_1e15.pcd", lambda: pcd(10**15, "binary"))
    yield bomb("cloud", "announced_1e15_text.pcd", lambda: pcd(10**15, "ascii", b"1 2 3"))
    yield bomb("cloud", "text_1e6.pcd", lambda: pcd(10**6, "ascii", b"1 2 3\n" * 10**6))
    yield bomb("cloud", "no_points.pcd", lambda: pcd(0, "ascii"))
    yield bomb("cloud", "announced_1e9.ply", lambda: ply(10**9, 0))
    yield bomb("cloud", "binary_6e6.ply", lambda: ply(6 * 10**6, 0, "binary_little_endian", bytes(72 * 10**6)))
    yield bomb("cloud", "text_1e6.ply", lambda: ply(10**6, 0, body=b"1 2 3\n" * 10**6))
    yield bomb("cloud", "header_1e9.npy", lambda: _npy_header((10**9, 3)))
    yield bomb("cloud", "header_negative.npy", lambda: _npy_header((-1, 3)))
    for count in (6 * 10**7, 3 * 10**8, 10**12):
        yield bomb("mesh", f"no_view_{count:.0e}.gltf", lambda n=count: gltf(n, view=False))
        yield bomb("mesh", f"view_{count:.0e}.gltf", lambda n=count: gltf(n, view=True))
    yield bomb("mesh", "indices_3e8.gltf", lambda: gltf(3, view=True, indices=3 * 10**8))
    yield bomb("mesh", "int16.gltf", lambda: gltf(3, view=True, kind=5122))
    yield bomb("mesh", "zeros_4e6.gltf", lambda: gltf(4 * 10**6, view=True, length=48 * 10**6))
    yield bomb("mesh", "nodes_2^20.gltf", lambda: many_nodes(20, 2))
    yield bomb("mesh", "nodes_2^40.gltf", lambda: many_nodes(40, 2))
    yield bomb("mesh", "nodes_deep.gltf", lambda: many_nodes(5000, 1))
    yield bomb("mesh", "nested.gltf", lambda: b'{"asset":' + b"[" * 200_000)
    yield bomb("mesh", "announced.stl", lambda: bytes(80) + struct.pack("<I", 2**32 - 1))
    yield bomb("mesh", "binary_1e5.stl", lambda: stl_binary(10**5))
    yield bomb("mesh", "binary_1.5e6.stl", lambda: stl_binary(1_500_000))
    yield bomb("mesh", "text_2e5.stl", lambda: stl_text(200_000))
    yield bomb("mesh", "text_1e6.stl", lambda: stl_text(1_000_000))
    yield bomb("mesh", "faces_1e6.obj", lambda: obj_text(10**6))
    yield bomb("mesh", "faces_1e7.obj", lambda: obj_text(10**7))
    for corners in (2_000, 20_000, 100_000):
        yield bomb("mesh", f"polygon_{corners}.obj", lambda n=corners: obj_polygon(n))
    yield bomb("mesh", "polygons_1e5.obj", lambda: obj_text(10**5, 40))
    yield bomb("mesh", "announced_1e9.ply", lambda: ply(10**9, 10**9))
    yield bomb("mesh", "faces_1e6.ply", lambda: ply(3, 10**6, body=b"0 0 0\n1 0 0\n0 1 0\n" + b"3 0 1 2\n" * 10**6))
    yield bomb("mesh", "entities.dae", lambda: _entities("COLLADA"))
    for width, depth in ((2, 20), (2, 60), (10, 9)):
        yield bomb("mesh", f"instances_{width}^{depth}.dae", lambda w=width, d=depth: collada(w, d))
    yield bomb("mesh", "elements_1e6.dae", lambda: b"<COLLADA>" + b"<a/>" * 10**6 + b"</COLLADA>")
    for count in (10**5, 2 * 10**5, 10**6):
        yield bomb("scene", f"points_{count:.0e}.yaml", lambda n=count: yaml_cloud(n))
    yield bomb("scene", "sexagesimal.yaml", lambda: b"obstacles: [{shape: sphere, radius: 1" + b":59" * 200_000 + b"}]")
    yield bomb("scene", "digits.yaml", lambda: b"obstacles: [{shape: sphere, radius: " + b"9" * 600_000 + b"}]")
    yield bomb("scene", "underscores.yaml", lambda: b"obstacles: [{shape: sphere, radius: 1" + b"_0" * 300_000 + b"}]")
    yield bomb("scene", "binary.yaml", lambda: b"obstacles: [{shape: sphere, radius: 0b" + b"1" * 600_000 + b"}]")
    yield bomb("scene", "hexadecimal.yaml", lambda: b"obstacles: [{shape: sphere, radius: 0x" + b"f" * 600_000 + b"}]")
    yield bomb("scene", "exponent.yaml", lambda: b"obstacles: [{shape: sphere, radius: 1e999999999}]")
    yield bomb("scene", "aliases_10^9.yaml", lambda: aliases(9, 10))
    yield bomb("scene", "aliases_2^60.yaml", lambda: aliases(60, 2))
    yield bomb("scene", "nested.yaml", lambda: b"obstacles: " + b"[" * 10**6)
    yield bomb("scene", "nested_flow.yaml", lambda: b"obstacles: " + b"{a: " * 10**6)
    yield bomb("scene", "nested_dashes.yaml", lambda: b"obstacles:\n" + b"- " * 10**6)
    yield bomb("scene", "keys_3e5.yaml", lambda: b"".join(b"k%d: 1\n" % k for k in range(300_000)))
    yield bomb("scene", "obstacles_1e5.yaml", lambda: b"obstacles:\n" + b"- {shape: plane}\n" * 10**5)
    yield bomb("scene", "spheres_2e4.yaml", lambda: b"obstacles:\n" + b"- {shape: sphere, radius: 1}\n" * 20_000)
    yield bomb("scene", "one_name.yaml", lambda: b"obstacles:\n- {shape: plane, name: " + b"x" * 10**7 + b"}\n")
    yield bomb("scene", "bytes_1e8.yaml", lambda: b"# " + b"x" * 10**8 + b"\nobstacles: []\n")
    yield bomb("scene", "merges.yaml", lambda: b"a: &a {x: 1}\n" + b"".join(b"b%d: {<<: *a}\n" % k for k in range(100_000)))
    yield bomb("moveit", "points_1e6.yaml", lambda: b"world:\n  collision_objects:\n" + b"  - {id: a}\n" * 10**6)
    yield bomb("moveit", "vertices.scene", lambda: b"(a)\n* a\n1\nmesh\n999999999 999999999\n.\n")
    yield bomb(
        "moveit",
        "objects_1e5.scene",
        lambda: b"(a)\n" + b"".join(b"* a%d\n1\nsphere\n1\n0 0 0\n0 0 0 1\n0 0 0 0\n" % k for k in range(10**5)) + b".\n",
    )
    yield bomb("moveit", "words_1e7.scene", lambda: b"(a)\n* a\n1\nbox\n" + b"1 " * 10**7 + b"\n.\n")
    for counts in ([10**6], [100] * 6, [10**5], [2] * 40, [10**18]):
        yield bomb("mujoco scene", f"replicate_{len(counts)}x{counts[0]:.0e}.xml", lambda c=counts: mujoco(replicate(c)))
    yield bomb("mujoco scene", "entities.xml", lambda: _entities("mujoco"))
    yield bomb(
        "mujoco scene",
        "heights.xml",
        lambda: mujoco("", extra='<asset><hfield name="h" nrow="60000" ncol="60000" size="1 1 1 1"/></asset>'),
    )
    yield bomb("mujoco scene", "geoms_3e4.xml", lambda: mujoco('<geom size=".1"/>' * 30_000))
    yield bomb("mujoco arm", "replicate_1e6.xml", lambda: mujoco(replicate([10**6], '<body><geom size=".1"/></body>')))
    yield bomb("mujoco arm", "nested_bodies.xml", lambda: mujoco('<body><geom size=".1"/>' * 400 + "</body>" * 400))
    yield bomb("mujoco arm", "bodies_5e4.xml", lambda: mujoco('<body><geom size=".1"/></body>' * 50_000))
    yield bomb(
        "mujoco arm",
        "composite.xml",
        lambda: mujoco('<body><composite type="cable" count="100000 1 1" size="1"><geom size=".1"/></composite></body>'),
    )
    for name, extra in ASKED.items():
        yield bomb("mujoco arm", f"{name}.xml", lambda e=extra: mujoco("", extra=e))
    flex = '<flexcomp name="f" type="grid" count="300 300 1" spacing=".1 .1 .1" dim="2"/>'
    yield bomb("mujoco arm", "flex.xml", lambda: mujoco(flex))
    yield bomb("urdf", "power.urdf.xacro", lambda: urdf(head='<xacro:property name="a" value="${9**9**9}"/>${a}'))
    yield bomb("urdf", "text.urdf.xacro", lambda: urdf(head='<xacro:property name="a" value="${\'a\' * 10**10}"/>${a}'))
    yield bomb("urdf", "list.urdf.xacro", lambda: urdf(head='<xacro:property name="a" value="${[0] * 10**9}"/>${len(a)}'))
    yield bomb("urdf", "range.urdf.xacro", lambda: urdf(head='<xacro:property name="a" value="${sum(range(10**12))}"/>${a}'))
    yield bomb(
        "urdf",
        "loops.urdf.xacro",
        lambda: urdf(head='<xacro:property name="a" value="${len([i for i in range(10**5) for j in range(10**5)])}"/>${a}'),
    )
    yield bomb("urdf", "doubling_30.urdf.xacro", lambda: doubling(30))
    yield bomb("urdf", "doubling_16.urdf.xacro", lambda: doubling(16))
    yield bomb("urdf", "endless.urdf.xacro", lambda: urdf(head='<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>'))
    yield bomb("urdf", "entities.urdf", lambda: _entities("robot"))
    yield bomb("urdf", "elements_1e6.urdf", lambda: urdf("<gazebo/>" * 10**6))
    yield bomb("urdf", "nested.urdf", lambda: urdf("<a>" * 10**5 + "</a>" * 10**5))
    yield bomb("urdf", "links_1000.urdf", lambda: urdf(links=1000))
    yield bomb("urdf", "links_20000.urdf", lambda: urdf(links=20_000))
    yield bomb("urdf", "name.urdf", lambda: urdf().replace(b'"l1"', b'"' + b"x" * 10**7 + b'"'))
    for count in (10**5, 10**6, 10**7):
        yield bomb("motion", f"rows_{count:.0e}.csv", lambda n=count: csv_rows(n))
    yield bomb("motion", "columns_1e6.csv", lambda: b"time," + b"q_a," * 10**6 + b"\n")
    yield bomb("motion", "cell.csv", lambda: b"time,q_joint1,q_joint2\n0," + b"1" * 10**7 + b",0\n")
    yield bomb("motion", "quote.csv", lambda: b'time,q_joint1,q_joint2\n0,"' + b"1\n" * 10**7)
    yield bomb("motion", "points_2e4.yaml", lambda: ros_points(20_000))
    yield bomb("motion", "points_2e5.yaml", lambda: ros_points(200_000))
    yield bomb("motion", "samples_1e5.json", lambda: json_motion(10**5))
    yield bomb("motion", "samples_3e6.json", lambda: json_motion(3 * 10**6))
    yield bomb("motion", "nested.json", lambda: b"[" * 10**7)
    yield bomb("motion", "digits.json", lambda: b'{"format": ' + b"9" * 10**6 + b"}")
    yield bomb("motion", "zeros_1e8.npz", lambda: npz(np.broadcast_to(np.zeros(1), (10**8,)), "t"))
    yield bomb("motion", "four_zeros.npz", lambda: npz(np.broadcast_to(np.zeros(1), (4 * 10**6, 1)), "t q qd joint_names"))
    yield bomb("poses", "rows_2e4.csv", lambda: pose_rows(20_000))
    yield bomb("poses", "rows_1e6.csv", lambda: pose_rows(10**6))
    yield bomb("plan", "nested.json", lambda: b'{"a":' * 10**6)
    yield bomb("report", "keys.json", lambda: b"{" + b",".join(b'"k%d": 1' % k for k in range(10**6)) + b"}")


def _npy_header(shape: tuple[int, ...]) -> bytes:
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(head, {"descr": "<f8", "fortran_order": False, "shape": shape})
    return head.getvalue()


def _entities(root: str) -> bytes:
    declared = '<!ENTITY e0 "aaaaaaaaaa">' + "".join(f'<!ENTITY e{k} "{f"&e{k - 1};" * 10}">' for k in range(1, 12))
    return f"<!DOCTYPE r [{declared}]><{root}>&e11;</{root}>".encode()


def judged(bomb: Bomb, folder: Path) -> tuple[float, int, float, str]:
    """Size of the file [bytes]; time [s], memory [bytes], and what came of it."""
    file = folder / bomb.name
    data = bomb.made()
    file.write_bytes(data)
    began = time.monotonic()
    command = [sys.executable, "-c", CHILD.format(read=READERS[bomb.kind]), str(file)]
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=STOP, check=False, env=environment, cwd=folder)
    except subprocess.TimeoutExpired:
        return len(data), time.monotonic() - began, np.nan, f"FAULT: not done after {STOP:g} s"
    finally:
        file.unlink()
    if run.returncode or not run.stdout.strip():
        return len(data), time.monotonic() - began, np.nan, f"FAULT: ended with code {run.returncode}: {run.stderr[-200:]}"
    figures, said = run.stdout.strip().splitlines()[-2:]
    seconds, kilobytes = map(float, figures.split())
    if said != "read" and (seconds > MOST_TIME or kilobytes * 1024 > MOST_MEMORY):
        said = f"FAULT: too much; {said}"
    return len(data), seconds, kilobytes * 1024, said


def main(arguments: list[str] | None = None) -> list[tuple[Bomb, str]]:
    """Read all files, write the table, and return those at fault."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", default="", help="part of the names of the files to read")
    parser.add_argument("--count", type=int, default=None, help="number of files to read")
    parser.add_argument("--out", type=Path, default=OUT)
    options = parser.parse_args(arguments)
    chosen = [each for each in bombs() if options.only in f"{each.kind} {each.name}"][: options.count]
    rows, faults = [], []
    with tempfile.TemporaryDirectory() as place:
        for bomb in chosen:
            size, seconds, memory, said = judged(bomb, Path(place))
            word = said.partition(":")[0]
            print(f"{bomb.kind} {bomb.name}: {seconds:.2f} s, {memory / 2**20:.0f} MiB, {said[:300]}", flush=True)
            rows.append(f"| {bomb.kind} | `{bomb.name}` | {size / 1000:,.1f} | {seconds:.2f} | {memory / 2**20:.0f} | {word} |")
            if word == "FAULT":
                faults.append((bomb, said))
    head = "| read as | file | kB | s | MiB | outcome |\n|---|---|---|---|---|---|\n"
    text = head + "\n".join(rows)
    text += (
        f"\n\n{len(chosen)} files, {len(faults)} at fault: not refused within {MOST_TIME:g} s of the processor and "
        f"{MOST_MEMORY / 2**30:g} GiB, refused by a foreign error, or never done. Time and memory are those "
        "of the whole process and of what it starts, with 0.2 GiB for the package itself.\n\n"
        f"Python {platform.python_version()}, {platform.machine()}; command: `python benchmarks/file_bombs.py`.\n"
    )
    options.out.write_text(text)
    return faults


if __name__ == "__main__":
    sys.exit(bool(main()))
