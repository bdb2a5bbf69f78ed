"""What a mesh is: closed, convex and open parts, cavities, orientation, files and their faults; against brute force."""

import json
import logging
import math
import pickle
import re
import struct
import sys

import coal
import numpy as np
import pinocchio as pin
import pytest
from broken_files import count_refused

import manipplan as mp
from manipplan.collision.surfaces import merge_corners, mesh_parts, shells, winding_number
from manipplan.robots.mesh_files import triangle_tree
from manipplan.robots.mesh_scenes import read_collada, split_polygons

trimesh = pytest.importorskip("trimesh")

BOX = np.array(trimesh.creation.box().triangles)
SMALL = np.array(trimesh.creation.box(extents=[0.5] * 3).triangles)
RING = np.array(trimesh.creation.annulus(r_min=0.3, r_max=0.5, height=1.0).triangles)
SQUARE = np.array([[[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 0, 0], [1, 1, 0], [0, 1, 0]]], dtype=float)


def kinds(triangles):
    """Kind of each part, C for a hull and B for triangles, in capitals where it is solid."""
    parts = mp.Mesh(triangles=triangles).parts()
    letters = ["c" if isinstance(part.shape, coal.ConvexBase) else "b" for part in parts]
    return "".join(each.upper() if part.closed else each for each, part in zip(letters, parts, strict=True))


def open_bin(thickness=0.0):
    """A box without its lid, 1 m wide; with walls of a thickness it is one closed surface."""
    if not thickness:
        return BOX[~(BOX[:, :, 2] > 0.4).all(axis=1)]
    outer, t = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]), thickness
    inner = outer * (1 - 2 * t)
    low, high, floor = -0.5, 0.5, -0.5 + t
    corners = [*np.c_[outer, np.full(4, low)], *np.c_[outer, np.full(4, high)]]
    corners += [*np.c_[inner, np.full(4, floor)], *np.c_[inner, np.full(4, high)]]
    polygons = [[3, 2, 1, 0], [8, 9, 10, 11]]
    for k in range(4):
        j = (k + 1) % 4
        polygons += [[k, j, 4 + j, 4 + k], [8 + j, 8 + k, 12 + k, 12 + j], [4 + k, 4 + j, 12 + j, 12 + k]]
    return split_polygons(np.array(corners), polygons)


def distance(part, point, radius=0.0):
    """coal's distance of a ball to a part."""
    place = coal.Transform3s.Identity()
    place.setTranslation(np.asarray(point, dtype=float))
    request = coal.DistanceRequest()
    request.gjk_tolerance = 1e-10
    ball = coal.Sphere(max(radius, 1e-6))
    return coal.distance(part.shape, coal.Transform3s.Identity(), ball, place, request, coal.DistanceResult()) - part.radius


@pytest.mark.parametrize(
    ("triangles", "expected"),
    [
        (BOX, "C"),
        (BOX[:, ::-1], "C"),  # inside out
        (np.array([t if k % 3 else t[::-1] for k, t in enumerate(BOX)]), "C"),  # without an orientation
        (np.concatenate([BOX, BOX]), "C"),  # every triangle twice
        (np.concatenate([BOX, BOX[:1]]), "C"),
        (np.concatenate([BOX, BOX + 3.0]), "CC"),
        (np.concatenate([BOX, SMALL]), "CC"),  # a solid inside a solid
        (np.concatenate([BOX, SMALL[:, ::-1]]), "B"),  # a cavity
        (np.concatenate([BOX[:, ::-1], SMALL]), "B"),  # a cavity, all inside out
        (np.concatenate([BOX, BOX + [1.0, 1.0, 0.0]]), "B"),  # a common edge
        (np.concatenate([BOX, BOX + [1.0, 0.0, 0.0]]), "B"),  # a common face
        (RING, "B"),
        (open_bin(), "b"),
        (open_bin(0.1), "B"),
        (SQUARE, "b"),
        (np.concatenate([SQUARE, SQUARE[:, ::-1]]), "b"),  # a plate with two sides
        (np.concatenate([SQUARE, SQUARE + 2.0, BOX + 9.0]), "Cb"),  # all open parts are one
        (np.concatenate([BOX, [[[0.5, 0.5, 0.5]] * 3, [[-0.5] * 3, [0.5, -0.5, -0.5], [0.0, -0.5, -0.5]]]]), "C"),  # no area
        (np.array(trimesh.creation.icosphere(subdivisions=3).triangles), "C"),
        (np.array(trimesh.creation.torus(1.0, 0.3).triangles), "B"),
        (np.array(trimesh.creation.icosphere(subdivisions=2).triangles).astype(np.float32).astype(float) + 1000.0, "C"),
    ],
)
def test_what_each_part_is(triangles, expected):
    assert kinds(triangles) == expected


@pytest.mark.parametrize("depth", [1e-5, 1e-4, 1e-3, 0.1])
def test_a_dent_is_not_filled(depth):
    fine = trimesh.creation.box().subdivide().subdivide()
    vertices = np.array(fine.vertices)
    vertices[np.linalg.norm(vertices - [0, 0, 0.5], axis=1).argmin()] -= [0, 0, depth]
    assert kinds(vertices[fine.faces]) == "B"


def test_edges_that_are_concave_while_all_corners_are_on_the_hull():
    """A cube of which one edge has been turned inward across a bent face."""
    corners = np.array([[0, 0, 0], [1, 0, 0.3], [1, 1, 0], [0, 1, 0.3], [0.5, 0.5, -1]], dtype=float)
    valley = [[0, 1, 2], [0, 2, 3]]  # along 0-2, which is the lower diagonal
    ridge = [[0, 1, 3], [1, 2, 3]]
    sides = [[1, 0, 4], [2, 1, 4], [3, 2, 4], [0, 3, 4]]
    assert kinds(corners[valley + sides]) == "B" and kinds(corners[ridge + sides]) == "C"


@pytest.mark.slow
@pytest.mark.parametrize("triangles", [RING, open_bin(0.1), BOX, np.concatenate([BOX, SMALL[:, ::-1]])])
def test_faces_of_solids_face_outward(triangles, rng):
    """Also when the file has any orientation: the winding number is 1 inside and 0 outside, as rays tell."""
    given = triangles[:, ::-1]
    [shell] = shells(given)
    points = rng.uniform(-0.7, 0.7, size=(400, 3))
    inside = np.array([crossings(triangles, point) % 2 == 1 for point in points])
    np.testing.assert_allclose(winding_number(shell.triangles, points), inside, atol=1e-9)
    assert 20 < inside.sum() < 380


def crossings(triangles, point):
    """How many of the triangles a ray from the point meets."""
    ray = np.array([0.31, 0.59, 0.74])
    count = 0
    for a, b, c in triangles:
        solution = (
            np.linalg.solve(np.stack([b - a, c - a, -ray], axis=1), point - a)
            if abs(np.linalg.det([b - a, c - a, ray])) > 1e-12
            else [-1, 0, 0]
        )
        count += solution[0] >= 0 and solution[1] >= 0 and solution[0] + solution[1] <= 1 and solution[2] > 0
    return count


def test_an_open_bin_is_empty(tmp_path):
    for thickness in (0.0, 0.1):
        [part] = mp.Mesh(triangles=open_bin(thickness)).parts()
        assert part.closed is (thickness > 0)
        assert distance(part, [0, 0, 0.1], 0.2) == pytest.approx(0.3 - thickness, abs=1e-6)
        assert distance(part, [0.45, 0, 0.1], 0.2) <= 0
    [filled] = mp.Mesh(triangles=open_bin(0.1), fill="hull").parts()
    assert filled.closed and isinstance(filled.shape, coal.ConvexBase) and distance(filled, [0, 0, 0.1], 0.2) < 0


@pytest.mark.parametrize("thickness", [0.0, 0.1])
def test_an_arm_can_reach_into_an_open_bin(tmp_path, thickness):
    file = tmp_path / "ball.urdf"
    file.write_text(
        '<robot name="ball"><link name="base"/><link name="b"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>'
        '<joint name="z" type="prismatic"><parent link="base"/><child link="b"/><axis xyz="0 0 1"/>'
        '<limit lower="-5" upper="5" velocity="1" effort="1"/></joint></robot>'
    )
    robot = mp.load_robot(file)
    heights = np.array([[0.0], [0.8], [-0.31], [-0.45], [-0.9]])
    scene = mp.Scene([mp.Mesh(triangles=open_bin(thickness))])
    np.testing.assert_array_equal(scene.in_collision(robot, heights), [False, False, thickness > 0, True, False])
    filled = mp.Scene([mp.Mesh(triangles=open_bin(thickness), fill="hull")])
    np.testing.assert_array_equal(filled.in_collision(robot, heights), [True, False, True, True, False])


@pytest.mark.slow
@pytest.mark.parametrize("triangles", [RING, open_bin(), np.concatenate([SQUARE, BOX + 2.0])])
def test_distances_are_those_to_the_triangles(triangles, rng):
    parts = mp.Mesh(triangles=triangles).parts()
    for point in rng.uniform(-4, 4, size=(60, 3)):
        nearest = trimesh.triangles.closest_point(triangles, np.tile(point, (len(triangles), 1)))
        expected = np.linalg.norm(nearest - point, axis=1).min() - 0.05
        if expected > 0 and crossings(triangles, point) % 2 == 0:
            assert min(distance(part, point, 0.05) for part in parts) == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("height", [2e-9, 1e-7, 1e-5])
def test_distances_to_thin_triangles(height, rng):
    """coal's distance of a ball to a triangle without an area is wrong; to those that are kept it is right."""
    triangle = np.array([[[0, 0, 0], [1, 0, 0], [0.3, height, 0]]])
    [part] = mp.Mesh(triangles=triangle).parts()
    for point in rng.uniform(-2, 2, size=(50, 3)):
        nearest = np.array([np.clip(point[0], 0, 1), 0, 0])
        assert distance(part, point, 0.05) == pytest.approx(np.linalg.norm(point - nearest) - 0.05, abs=2e-5)


@pytest.mark.parametrize("fill", [None, "hull"])
@pytest.mark.parametrize(
    ("triangles", "message"),
    [
        (np.full((1, 3, 3), np.nan), "triangles.*finite"),
        (BOX * np.inf, "triangles.*finite"),
        (BOX * 1.5e23, r"triangles: got .*7.5e\+22 m.*within 1e\+06 m"),
        (BOX + 1e7, "within"),
        (np.zeros((0, 3, 3)), "at least one triangle"),
        (np.zeros((4, 3, 3)), "at least one triangle with an area"),
        (BOX * 1e-12, "at least one triangle with an area"),
        ([[[0, 0, 0], [1, 0, 0], [2, 0, 0]]], "at least one triangle with an area"),
        (np.zeros((2, 3)), "triangles"),
        ([[["a"] * 3] * 3], "triangles"),
    ],
)
def test_triangles_that_are_refused(triangles, message, fill):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Mesh(triangles=triangles, fill=fill)


@pytest.mark.parametrize("thickness", [1e-10, 1e-8, 5e-7, 1e-6, 2e-6, 1e-5, 1e-3])
def test_plates_of_any_thickness(thickness):
    """coal crashes on the hull of a plate that is thinner than 1e-6 m; such a plate is a surface."""
    [part] = mp.Mesh(triangles=BOX * [1.0, 1.0, thickness]).parts()
    assert distance(part, [0.2, 0.1, 1.0], 0.1) == pytest.approx(0.9 - thickness / 2, abs=1e-5)
    if thickness < 5e-7:
        with pytest.raises(mp.errors.InvalidInputError, match="one is flat"):
            mp.Mesh(triangles=BOX * [1.0, 1.0, thickness], fill="hull")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"up": "x"}, "Mesh.up: got 'x'.*'z' or 'y'"),
        ({"up": None}, "Mesh.up"),
        ({"fill": "hulls"}, "Mesh.fill: got 'hulls'.*None or 'hull'"),
        ({"fill": True}, "Mesh.fill"),
        ({"scale": 0.0}, "Mesh.scale"),
        ({"scale": 1e300}, "Mesh.scale: .*at most 1e\\+12"),
        ({"scale": 1e11}, "within"),
    ],
)
def test_options_that_are_refused(options, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Mesh(triangles=BOX, **options)


def test_up_and_scale():
    mesh = mp.Mesh(triangles=SQUARE * [1000, 2000, 1], scale=0.001, up="y")
    corners = merge_corners(np.array(mesh.shapes()[0].vertices()).reshape(-1, 1, 3).repeat(3, axis=1))[0]
    assert {tuple(corner) for corner in corners.round(9).tolist()} == {(0, 0, 0), (1, 0, 0), (1, 0, 2), (0, 0, 2)}


def test_a_mesh_survives_pickle_and_moves():
    for triangles in (BOX, RING, open_bin()):
        mesh = pickle.loads(pickle.dumps(mp.Mesh(triangles=triangles)))
        [part], [first] = mesh.parts(), mp.Mesh(triangles=triangles).parts()
        assert (part.closed, type(part.shape)) == (first.closed, type(first.shape))
        assert distance(part, [2, 0.3, 0.1], 0.1) == pytest.approx(distance(first, [2, 0.3, 0.1], 0.1), abs=1e-9)
        assert mesh.at(np.eye(4)).parts()[0].shape is part.shape  # not built again


def test_meshes_can_be_carried_and_clouds_cannot(panda):
    for mesh in (mp.Mesh(triangles=0.05 * BOX), mp.Mesh(triangles=0.05 * RING), mp.Mesh(triangles=0.05 * RING, fill="hull")):
        assert "part" in panda.attach(mesh).carried
    with pytest.raises(mp.errors.InvalidInputError, match="shape: got .*without a distance around it"):
        panda.attach(mp.PointCloud(points=[[0, 0, 0.1]], radius=0.01))


def test_polygons_are_split_within_themselves(rng):
    """The area is that of the polygon, also when it is concave, and lies in any plane."""
    outlines = [
        [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)],  # U
        [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)],  # L
        [(0, 0), (2, 1), (4, 0), (2, 4)],  # an arrow of four corners
        [(0, 0), (1, 0), (2, 0), (2, 2), (0, 2)],  # a corner on an edge
    ]
    for outline in outlines:
        flat = np.array(outline, dtype=float)
        x, y = flat.T
        area = 0.5 * abs(x @ np.roll(y, -1) - y @ np.roll(x, -1))
        for turn in (pin.SE3.Random().rotation, np.eye(3), np.diag([1.0, -1.0, -1.0])):
            corners = np.c_[flat, np.zeros(len(flat))] @ turn.T
            for order in (np.arange(len(flat)), np.arange(len(flat))[::-1], np.roll(np.arange(len(flat)), 2)):
                triangles = split_polygons(corners, [order])
                normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) / 2
                assert np.linalg.norm(normals, axis=1).sum() == pytest.approx(area, rel=1e-9)
                assert np.linalg.norm(normals.sum(axis=0)) == pytest.approx(area, rel=1e-9)


# files


def stl(triangles, *, count=None):
    table = np.zeros(len(triangles), dtype=[("n", "<f4", 3), ("c", "<f4", (3, 3)), ("r", "<u2")])
    table["c"] = triangles
    return bytes(80) + struct.pack("<I", len(triangles) if count is None else count) + table.tobytes()


def ascii_stl(triangles):
    facets = [
        "facet normal 0 0 0\n outer loop\n" + "".join(f"  vertex {x} {y} {z}\n" for x, y, z in t) + " endloop\nendfacet\n"
        for t in triangles.tolist()
    ]
    return ("solid a facet b\n" + "".join(facets[:6]) + "endsolid a\nsolid b\n" + "".join(facets[6:]) + "endsolid\n").encode()


QUADS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
OBJ = (
    "# box\no first\n"
    + QUADS
    + "vn 0 0 1\nvt 0 0\ns off\ng a\nf 4//1 3//1 2//1 1//1\nf 5/1/1 6/1/1 7/1/1 8/1/1\no second\nf 1 2 6 5\nf 2 3 \\\n 7 6\nf -6 -5 -1 -2\nl 1 2\nf 4 1 5 8\n"
)


def ply_quads(form):
    corners = [[float(x) for x in line.split()[1:]] for line in QUADS.splitlines()]
    faces = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4], [3, 4, 7]]
    head = f"ply\nformat {form} 1.0\ncomment c\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
    head += "element face 7\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
    if form == "ascii":
        rows = [[*corner, 9] for corner in corners] + [[len(face), *face, 2, 99.5, -7] for face in faces]
        return head.encode() + "\n".join(" ".join(map(str, row)) for row in rows).encode()
    order = "<" if "little" in form else ">"
    body = b"".join(struct.pack(order + "3fB", *corner, 9) for corner in corners)
    body += b"".join(struct.pack(f"{order}B{len(f)}iB2f", len(f), *f, 2, 99.5, -7) for f in faces)
    return head.encode() + body


def dae(*, unit=1.0, up="Z_UP", nodes=None, primitive=None, extra=""):
    numbers = " ".join(line[2:] for line in QUADS.splitlines())
    primitive = primitive or (
        '<polylist count="6"><input semantic="NORMAL" source="#n" offset="0"/><input semantic="VERTEX" source="#v" offset="1"/>'
        "<vcount>4 4 4 4 4 4</vcount><p>"
        + " ".join(f"0 {k}" for k in [3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7])
        + "</p></polylist>"
    )
    nodes = nodes or '<node><instance_geometry url="#g"/></node>'
    return f"""<?xml version="1.0" encoding="utf-8"?>
    <COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
    <asset><unit name="u" meter="{unit}"/><up_axis>{up}</up_axis></asset>
    <library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="24">{numbers}</float_array>
    <technique_common><accessor source="#pa" count="8" stride="3"/></technique_common></source>
    <source id="n"><float_array count="3">0 0 1</float_array></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>{primitive}</mesh></geometry></library_geometries>{extra}
    <library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>
    <scene><instance_visual_scene url="#s"/></scene></COLLADA>""".encode()


FILES = {
    "a.stl": stl(BOX + 0.5),
    "b.STL": ascii_stl(BOX + 0.5),
    "solid.stl": b"solid" + stl(BOX + 0.5)[5:],  # binary, though its header begins as text does
    "c.obj": OBJ.encode(),
    "crlf.obj": OBJ.replace("\n", "\r\n").encode(),
    "d.ply": ply_quads("ascii"),
    "e.ply": ply_quads("binary_little_endian"),
    "f.ply": ply_quads("binary_big_endian"),
    "g.dae": dae(),
}


@pytest.mark.parametrize("name", FILES)
def test_the_same_box_in_every_format(tmp_path, name):
    (tmp_path / name).write_bytes(FILES[name])
    [part] = mp.Mesh(file=tmp_path / name).parts()
    assert part.closed and isinstance(part.shape, coal.ConvexBase) and part.shape.num_points == 8
    assert distance(part, [3, 0.5, 0.5], 0.5) == pytest.approx(1.5, abs=1e-6)
    assert part.shape.computeVolume() == pytest.approx(1.0)


def two_boxes():
    scene = trimesh.Scene()
    box = trimesh.creation.box()
    scene.add_geometry(box, node_name="base", geom_name="box", transform=trimesh.transformations.translation_matrix([0, 0, 5]))
    turn = trimesh.transformations.rotation_matrix(np.pi / 2, [0, 0, 1])
    turn[:3, :3] *= 2.0
    turn[:3, 3] = [3, 0, 0]
    scene.add_geometry(box, node_name="arm", geom_name="box2", parent_node_name="base", transform=turn)
    return scene


@pytest.mark.parametrize("ending", ["glb", "gltf"])
def test_transforms_of_gltf(tmp_path, caplog, ending):
    file = tmp_path / f"two.{ending}"
    written = two_boxes().export(file_type=ending)
    for name, data in ({file.name: written} if ending == "glb" else written).items():
        (tmp_path / (file.name if name == "model.gltf" else name)).write_bytes(data)
    with caplog.at_level(logging.WARNING, "manipplan"):
        parts = mp.Mesh(file=file).parts()
    assert "its y axis is vertical" in caplog.text and 'up="y"' in caplog.text
    middles = sorted(tuple(np.array([p.shape.point(k) for k in range(8)]).mean(axis=0).round(9).tolist()) for p in parts)
    assert middles == [(0.0, 0.0, 5.0), (3.0, 0.0, 5.0)]
    assert sorted(p.shape.computeVolume() for p in parts) == pytest.approx([1.0, 8.0])
    upright = mp.Mesh(file=file, up="y").parts()
    middles = sorted(tuple(np.array([p.shape.point(k) for k in range(8)]).mean(axis=0).round(9).tolist()) for p in upright)
    assert middles == [(0.0, -5.0, 0.0), (3.0, -5.0, 0.0)]


def change(document, **values):
    return json.dumps({**json.loads(document), **values}).encode()


def test_gltf_that_is_not_read(tmp_path, monkeypatch):
    parts = trimesh.Scene(trimesh.creation.box()).export(file_type="gltf")
    for name, data in parts.items():
        (tmp_path / name).write_bytes(data)
    document = parts["model.gltf"]
    mode = json.loads(document)["meshes"]
    mode[0]["primitives"][0]["mode"] = 6
    cases = {
        "KHR_draco_mesh_compression": change(document, extensionsRequired=["KHR_draco_mesh_compression"]),
        "mode 6": change(document, meshes=mode),
        "its meshes is not a list": change(document, meshes=None),
        "EXT_mesh_gpu_instancing": change(document, extensionsUsed=["EXT_mesh_gpu_instancing"]),
        "sparse accessors": change(document, accessors=[{"sparse": {}}]),
        "morph targets": change(document, meshes=[{"primitives": [{"mode": 4, "targets": [{}]}]}]),
        "its extensionsRequired is not a list": change(document, extensionsRequired=5),
        "its primitives is not a list": change(document, meshes=[{"primitives": 5}]),
        "one of its meshes is not an object": change(document, meshes=[5]),
        "skins": change(document, skins=[{}]),
        "trimesh says": change(document, buffers=[{"uri": "nothing.bin", "byteLength": 4}]),
        "not an object": b"[]",
        "JSON cannot be read": document[:-4],
        "at least one triangle": change(document, meshes=[], nodes=[{}]),
    }
    for said, data in cases.items():
        (tmp_path / "m.gltf").write_bytes(data)
        with pytest.raises(mp.errors.FileFormatError, match=said):
            mp.Mesh(file=tmp_path / "m.gltf")
    (tmp_path / "m.glb").write_bytes(two_boxes().export(file_type="glb")[:-100])
    with pytest.raises(mp.errors.FileFormatError, match="cut off"):
        mp.Mesh(file=tmp_path / "m.glb")
    (tmp_path / "m.gltf").write_bytes(document)
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(mp.errors.MissingExtraError, match=re.escape("manipplan[mesh]")):
        mp.Mesh(file=tmp_path / "m.gltf")


def test_transforms_of_dae(tmp_path, caplog):
    """Nested nodes, instances of nodes, mirrored ones; unit and vertical axis are stated but not applied."""
    nodes = (
        '<node><translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 1 1</scale><instance_geometry url="#g"/>'
        '<node><matrix>1 0 0 0 0 1 0 5 0 0 1 0 0 0 0 1</matrix><instance_geometry url="#g"/></node></node>'
        '<node><scale>-1 1 1</scale><instance_node url="#lib"/></node>'
    )
    extra = '<library_nodes><node id="lib"><translate>0 0 7</translate><instance_geometry url="#g"/></node></library_nodes>'
    (tmp_path / "m.dae").write_bytes(dae(nodes=nodes, extra=extra, unit=0.0254, up="Y_UP"))
    with caplog.at_level(logging.WARNING, "manipplan"):
        parts = mp.Mesh(file=tmp_path / "m.dae").parts()
    assert "scale=0.0254" in caplog.text and "its y axis is vertical" in caplog.text
    middles = sorted(tuple(np.array([p.shape.point(k) for k in range(8)]).mean(axis=0).round(9).tolist()) for p in parts)
    assert middles == [(-0.5, 0.5, 7.5), (4.5, 1.0, 0.5), (9.5, 1.0, 0.5)]
    caplog.clear()
    with caplog.at_level(logging.WARNING, "manipplan"):
        mp.Mesh(file=tmp_path / "m.dae", scale=0.0254, up="y")
    assert not caplog.text


def test_an_obj_file_with_a_mark_of_its_byte_order(tmp_path):
    faces = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
    (tmp_path / "m.obj").write_bytes(b"\xef\xbb\xbf" + (QUADS + faces).encode())
    [part] = mp.Mesh(file=tmp_path / "m.obj").parts()
    assert part.shape.computeVolume() == pytest.approx(1.0)


@pytest.mark.parametrize("jitter", [0.0, 1e-16, 1e-12, 1e-10, 2.5e-10])
def test_corners_that_nearly_coincide_are_one(rng, jitter):
    """Wherever they are, also on an edge of a grid of the tolerance."""
    turn = pin.exp3(rng.normal(size=3))
    for _ in range(40):
        place = np.round(rng.normal(size=3) * 1e3) * 1e-3 + 0.5e-9
        triangles = RING @ turn.T + place + rng.uniform(-jitter, jitter, RING.shape)
        [shell] = shells(triangles)
        assert shell.closed
        corners, faces = merge_corners(triangles)
        assert len(corners) == len(merge_corners(RING)[0]) and len(faces) == len(RING)


def test_geometries_of_dae_without_a_name(tmp_path):
    """Without a scene every geometry counts, also those that have no name, or the same one."""
    text = dae().decode()
    assert text.count("<geometry ") == 1
    begin, end = text.index("<library_geometries>") + len("<library_geometries>"), text.index("</library_geometries>")
    geometry = text[begin:end]
    other = geometry
    for old, new in (('"v"', '"w"'), ('"#v"', '"#w"'), ('"p"', '"r"'), ('"#p"', '"#r"')):
        other = other.replace(old, new)
    for name in ('id="g"', ""):
        both = (geometry + other).replace('id="g"', name)
        (tmp_path / "m.dae").write_text(f"{text[:begin]}{both}</library_geometries></COLLADA>")
        triangles, *_ = read_collada("file", tmp_path / "m.dae")
        assert len(triangles) == 2 * 12


def with_primitive(text):
    return dae(primitive=text)


@pytest.mark.parametrize(
    ("tag", "rest"),
    [
        ("triangles", "<p>3 2 1 3 1 0 4 5 6 4 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7</p>"),
        ("polygons", "<p>3 2 1 0</p><p>4 5 6 7</p><p>0 1 5 4</p><p>1 2 6 5</p><p>2 3 7 6</p><p>3 0 4 7</p>"),
        ("tristrips", "<p>0 1 3 2 7 6 4 5 0 1</p><p>1 5 2 6</p><p>0 3 4 7</p>"),
        ("trifans", "<p>3 2 1 0</p><p>4 5 6 7</p><p>0 1 5 4</p><p>1 2 6 5</p><p>2 3 7 6</p><p>3 0 4 7</p>"),
    ],
)
def test_primitives_of_dae(tmp_path, tag, rest):
    (tmp_path / "m.dae").write_bytes(with_primitive(f'<{tag}><input semantic="VERTEX" source="#v" offset="0"/>{rest}</{tag}>'))
    [part] = mp.Mesh(file=tmp_path / "m.dae").parts()
    assert isinstance(part.shape, coal.ConvexBase) and part.shape.computeVolume() == pytest.approx(1.0)


VERTEX = '<input semantic="VERTEX" source="#v" offset="0"/>'


@pytest.mark.parametrize(
    ("name", "data", "message"),
    [
        ("m.stl", b"", "STL"),
        ("m.stl", b"solid a\nendsolid a\n", "at least one triangle"),
        ("m.stl", stl(BOX)[:-30], "announces 12 facets, but it holds 11.4"),
        ("m.stl", stl(BOX, count=2**32 - 1), "announces 4294967295 facets"),
        ("m.stl", stl(BOX * np.nan), "got .*m.stl: a corner at nan m"),
        ("m.stl", stl(BOX * 1e30), "a corner at"),
        ("m.stl", ascii_stl(BOX)[:-60], "cut off"),
        ("m.stl", ascii_stl(BOX).replace(b"vertex 0.5", b"vertex 0,5", 1), "0,5"),
        ("m.stl", ascii_stl(BOX).replace(b"endloop", b"vertex 1 2 3", 1), "cut off"),
        ("m.obj", b"v 0 0 0\nv 1 0 0\n", "at least one triangle"),
        ("m.obj", QUADS.encode() + b"f 1 2 9\n", "outside 1 to 8"),
        ("m.obj", QUADS.encode() + b"f 1 2 -9\n", "outside 1 to 8"),
        ("m.obj", QUADS.encode() + b"f 0 1 2\n", "vertex 0; they count from 1"),
        ("m.obj", b"v 0 0 0\nf 0 1 1\n" + QUADS.encode(), "vertex 0; they count from 1"),
        ("m.obj", QUADS.encode() + b"f 1 2 x\n", "OBJ; invalid literal"),
        ("m.obj", QUADS.encode() + b"f 1 2\n", "a face with 2 corners"),
        ("m.obj", QUADS.encode() + b"fo 1 2 3\n", "lines 'fo', which are not read"),
        ("m.obj", b"v 0 0\n" + QUADS.encode() + b"f 2 3 4\n", "fewer than three"),
        ("m.obj", b"v 0 nan 0\n" + QUADS.encode() + b"f 1 3 4\n", "a corner at nan"),
        ("m.obj", b"v 0 1e300 0\n" + QUADS.encode() + b"f 1 3 4\n", r"a corner at 1e\+300"),
        ("m.ply", b"ply\n", "no end_header"),
        ("m.ply", ply_quads("ascii")[:-9], "cut off"),
        ("m.ply", ply_quads("binary_big_endian")[:-9], "cut off"),
        ("m.ply", ply_quads("ascii").replace(b"vertex 8", b"vertex 800000000000"), "cut off"),
        ("m.ply", ply_quads("binary_little_endian").replace(b"vertex 8", b"vertex 800000000000"), "cut off"),
        ("m.ply", ply_quads("ascii").replace(b"vertex 8", b"vertex -8"), "cut off"),
        ("m.dae", b"<COLLADA/>", "at least one triangle"),
        ("m.dae", b"<robot/>", "root is <robot>"),
        ("m.dae", dae()[:-30], "well-formed XML"),
        ("m.dae", dae(nodes='<node><instance_geometry url="#x"/></node>'), "#x, which is not there"),
        ("m.dae", dae(nodes='<node id="a"><instance_node url="#a"/></node>'), "a node inside itself"),
        ("m.dae", dae(nodes="<node><skew>1 2 3 4 5 6 7</skew></node>"), "<skew>, which is not read"),
        ("m.dae", dae(nodes="<node><translate>1 2</translate></node>"), "<translate> with 2"),
        ("m.dae", dae(nodes='<node><instance_controller url="#c"/></node>'), "skins"),
        ("m.dae", dae(unit=0.0), "its unit is 0 m"),
        ("m.dae", dae(nodes="<node><matrix>" + "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix></node>"), "last row"),
        ("m.dae", dae().replace(b'source="#pa"', b'source="#other"'), "not one of X, Y, Z in its own numbers"),
        (
            "m.dae",
            dae().replace(b'stride="3"/>', b'stride="3"><param name="Z"/><param name="Y"/><param name="X"/></accessor>'),
            "not one of X, Y, Z in its own numbers",
        ),
        ("m.dae", with_primitive(f"<triangles>{2 * VERTEX}<p>0 1 2</p></triangles>"), "without one input of VERTEX"),
        ("m.dae", dae().replace(b"<mesh>", b"<convex_mesh>").replace(b"</mesh>", b"</convex_mesh>"), "without <mesh>"),
        ("m.dae", with_primitive(f"<triangles>{VERTEX}<p>0 1 8</p></triangles>"), "outside 0 to 7"),
        ("m.dae", with_primitive(f"<triangles>{VERTEX}<p>0 1</p></triangles>"), "cut off"),
        ("m.dae", with_primitive(f"<polylist>{VERTEX}<vcount>4</vcount><p>0 1 2</p></polylist>"), "does not fit"),
        ("m.dae", with_primitive(f"<polygons>{VERTEX}<ph><p>0 1 2</p><h>3 4 5</h></ph></polygons>"), "holes"),
        ("m.dae", with_primitive("<triangles><p>0 1 2</p></triangles>"), "VERTEX"),
        ("m.step", b"ISO", r"ends with \.stl, \.obj"),
    ],
)
def test_files_that_are_refused(tmp_path, name, data, message):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
        mp.Mesh(file=tmp_path / name, name="part")
    assert caught.value.argument == "part.file" and name in str(caught.value.value)


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_broken_files_raise_one_error_or_are_read(tmp_path, name):
    """Nothing but FileFormatError, and no crash."""
    assert 0 < count_refused(tmp_path / name, FILES[name], lambda file: mp.Mesh(file=file)) < 150


def test_scene_files_hold_all_options(tmp_path):
    (tmp_path / "bin.stl").write_bytes(stl(open_bin()))
    scene = mp.Scene([mp.Mesh(file=tmp_path / "bin.stl", scale=0.5, up="y", fill="hull", name="bin")])
    scene.to_yaml(tmp_path / "scene.yaml")
    [again] = mp.Scene.from_yaml(tmp_path / "scene.yaml").obstacles
    assert (again.scale, again.up, again.fill) == (0.5, "y", "hull") and isinstance(again.shapes()[0], coal.ConvexBase)
    (tmp_path / "scene.yaml").write_text("obstacles: [{shape: mesh, file: bin.stl, fill: convex}]")
    with pytest.raises(mp.errors.InvalidInputError, match=r"obstacles\[0\].*fill.*'convex'.*'hull'"):
        mp.Scene.from_yaml(tmp_path / "scene.yaml")


@pytest.mark.slow
def test_many_parts_are_quick():
    boxes = (BOX[None] + 3.0 * np.arange(200)[:, None, None, None] * [1, 0, 0]).reshape(-1, 3, 3)
    assert len(mp.Mesh(triangles=boxes).parts()) == 200
    loose = np.random.default_rng(0).random((3000, 3, 3))
    assert len(mp.Mesh(triangles=loose).parts()) == 1


def test_a_tree_is_of_all_triangles():
    tree = triangle_tree(*merge_corners(RING))
    assert tree.num_tris == len(RING) and math.isfinite(tree.aabb_radius) and len(mesh_parts("m", RING)) == 1


def test_a_closed_mesh_with_both_sides_of_each_triangle_is_solid():
    """Some programs write each triangle twice, once per side: the box was a hollow surface."""
    both = np.concatenate([BOX, BOX[:, ::-1]])
    for triangles in (both, both[np.random.default_rng(0).permutation(len(both))]):
        [part] = mp.Mesh(triangles=triangles).parts()
        [once] = mp.Mesh(triangles=BOX).parts()
        assert part.closed and type(part.shape) is type(once.shape)
    [sheet] = mp.Mesh(triangles=np.concatenate([BOX[:2], BOX[:2, ::-1]])).parts()
    assert not sheet.closed
