"""Mesh files of robots: each format gives its body where the file says, in metres; what is broken is refused."""

import sys
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.robots.mesh_files import read_mesh

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
from fuzz import samples

MESHES = samples.meshes()
HEAD = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
HEAD += "property list uchar int vertex_indices\nend_header\n"
BODY = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"


def robot(folder, name, mesh):
    """The arm of a URDF with a mesh of this name and contents."""
    (folder / name).write_bytes(mesh)
    (folder / "arm.urdf").write_bytes(samples.urdf(name))
    return mp.Robot.from_urdf(folder / "arm.urdf", tool="tip")


@pytest.mark.parametrize("name", MESHES)
def test_each_format_gives_the_same_body(tmp_path, name):
    body = robot(tmp_path, name, MESHES[name]).geometry.geometryObjects[2]
    vertices = np.unique(np.array(body.geometry.vertices()).round(6), axis=0)
    np.testing.assert_allclose(vertices, np.unique(0.5 * samples.CORNERS, axis=0), atol=1e-6)
    assert body.meshPath == str(tmp_path / name) and body.meshScale.tolist() == [0.5, 0.5, 0.5]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (HEAD.replace("vertex 4", "vertex 5") + BODY, "a line of 4 numbers where 3 are expected"),
        (HEAD.replace("face 4", "face 3") + BODY, "more than its header announces"),
        (HEAD + BODY.replace("3 2 0 3", "0"), "a face with 0 corners"),
        (HEAD + BODY.replace("3 2 0 3", "2 0 1"), "a face with 2 corners"),
        (HEAD + BODY.replace("3 2 0 3", "3 2 0"), "a line of 3 numbers"),
        (HEAD + BODY.replace("3 2 0 3", "3 2 0 4"), "a face names corner 4 of 4"),
        (HEAD + BODY.replace("3 2 0 3", "3 2 0 0.5"), "a face names corner 0.5 of 4"),
        (HEAD + BODY.replace("1 0 0", "1 nan 0", 1), "finite vertices within 1e.06 m, unlike .*m.ply of upper_1"),
        (HEAD + BODY.replace("1 0 0", "1 1e200 0", 1), "finite vertices within"),
        (HEAD.replace("face 4", "face 0") + BODY[:24], "at least one triangle"),
        (HEAD.replace("vertex_indices", "texture") + BODY, "a face without one list called vertex_indices"),
        (HEAD.replace("float z", "float w") + BODY, "lack x, y or z"),
        (HEAD.replace("face 4", "face 99999999999") + BODY, "cut off"),
        (
            HEAD.replace("end_header", "element tristrips 1\nproperty list int int vertex_indices\nend_header")
            + BODY
            + "3 0 1 2\n",
            "strips",
        ),
        (HEAD.replace("end_header", "element face 1\nproperty list uchar int vertex_indices\nend_header") + BODY, "same name"),
        ("", "no end_header"),
    ],
)
def test_ply_files_of_robots(tmp_path, text, message):
    with pytest.raises(mp.errors.FileFormatError, match=message):
        robot(tmp_path, "m.ply", text.encode())


@pytest.mark.parametrize("scheme", ["package://", "model://", "file://"])
def test_a_mesh_is_judged_wherever_its_name_points(tmp_path, scheme):
    (tmp_path / "pack").mkdir()
    (tmp_path / "pack" / "m.ply").write_bytes(b"ply\n")
    text = samples.urdf("m.ply").decode()
    assert "package://m.ply" in text
    place = tmp_path / "pack" / "m.ply" if scheme == "file://" else "pack/m.ply"
    (tmp_path / "arm.urdf").write_text(text.replace("package://m.ply", f"{scheme}{place}"))
    with pytest.raises(mp.errors.FileFormatError, match="no end_header"):
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")


def test_lines_of_a_ply_file_that_are_swapped(tmp_path):
    lines = MESHES["text.ply"].decode().splitlines()
    corner, face = lines.index("0 0 0.2"), lines.index("3 2 3 4")
    lines[corner], lines[face] = lines[face], lines[corner]
    with pytest.raises(mp.errors.FileFormatError, match="a line of"):
        robot(tmp_path, "m.ply", "\n".join(lines).encode())


@pytest.mark.parametrize("name", ["m", "m.bin", "m.ply ", "m.blend"])
def test_the_format_of_a_mesh_is_that_of_its_name(tmp_path, name):
    """By its contents the loader would take it for a PLY file, which nobody has judged."""
    with pytest.raises(mp.errors.FileFormatError, match=r"ends with \.stl, \.obj, \.ply, \.dae"):
        robot(tmp_path, name, MESHES["wedge.ply"])


def test_a_name_of_a_mesh_that_is_too_long(tmp_path):
    (tmp_path / "arm.urdf").write_bytes(samples.urdf("9" * 4000 + ".ply"))
    with pytest.raises(mp.errors.FileFormatError, match="names of meshes that can be files .File name too long., unlike"):
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")


@pytest.mark.slow
def test_meshes_of_an_mjcf_are_in_mujoco_s_formats(tmp_path):
    (tmp_path / "wedge.stl").write_bytes(MESHES["wedge.stl"])
    (tmp_path / "arm.xml").write_text(samples.MJCF)
    assert mp.Robot.from_mjcf(tmp_path / "arm.xml", velocity=1.0).geometry.ngeoms == 5
    (tmp_path / "wedge.ply").write_bytes(MESHES["wedge.ply"])
    (tmp_path / "arm.xml").write_text(samples.MJCF.replace("wedge.stl", "wedge.ply"))
    with pytest.raises(mp.errors.FileFormatError, match=r"MuJoCo says: .*wedge\.ply"):
        mp.Robot.from_mjcf(tmp_path / "arm.xml", velocity=1.0)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("<p>0 2 1", "<p>0 world 1", "'world'"),
        ("<p>0 2 1", "<p>0 2 1,5", "'1,5'"),
        ("<p>0 2 1", "<p>0 2 1_0", "numbers are needed, not '1_0'"),
        ("<p>0 2 1", "<p>0 2 ١", "numbers are needed"),
        ("<p>0 2 1", "<p>0 <a/>2 1", "<p> needs numbers, not <a>"),
        ("<p>0 2 1", "<p>0 2 5", "names a vertex outside 0 to 4"),
        ("<p>0 2 1", "<p>0 2 -1", "names a vertex outside 0 to 4"),
        ('stride="3"', 'stride="1e9"', "'1e9'"),
        ('<accessor source="#array" count="5"', '<accessor source="#array" count="6"', "does not fit its numbers"),
        ("0.2 0.2 0<", "0.2 0.2 nan<", "finite vertices"),
        ("<matrix>1 0", "<matrix>1 a", "'a'"),
        ("<matrix>1 0", "<matrix>1", "<matrix> with 15 finite numbers instead of 16"),
        ("</COLLADA>", "", "well-formed XML"),
        ('id="node"', 'id="é"', "XML in UTF-8"),
    ],
)
def test_collada_files(tmp_path, old, new, message):
    text = MESHES["wedge.dae"].decode()
    assert old in text
    data = text.replace(old, new).encode("latin-1" if "é" in new else "utf-8")
    with pytest.raises(mp.errors.FileFormatError, match=message):
        robot(tmp_path, "m.dae", data)


def test_collada_files_are_not_too_deep(tmp_path):
    deep = MESHES["wedge.dae"].decode().replace("<scene>", "<scene>" * 1000)
    with pytest.raises(mp.errors.FileFormatError, match="nested at most 500 deep"):
        robot(tmp_path, "m.dae", deep.encode())


@pytest.mark.parametrize("name", ["text.ply", "wedge.ply"])
def test_ply_files_of_obstacles_are_read_without_the_mesh_loader(tmp_path, name):
    file = tmp_path / "m.ply"
    file.write_bytes(MESHES[name])
    [hull] = mp.Mesh(file=file, scale=2.0).shapes()
    points = np.array([hull.point(i) for i in range(hull.num_points)])
    np.testing.assert_allclose(np.unique(points.round(6), axis=0), np.unique(2 * samples.CORNERS, axis=0), atol=1e-6)
    file.write_bytes(MESHES[name].replace(b"face 6", b"face 600"))
    with pytest.raises(mp.errors.FileFormatError, match="cut off"):
        mp.Mesh(file=file)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nF 1 3 2\n", "it has lines 'F'"),
        ("v 0 0 0\nv 1 0 0\nV 0 1 0\nf 1 2 3\n", "it has lines 'V'"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a vertex outside 1 to 3"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "a vertex outside 1 to 3"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "vertex 0"),
        ("v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 has fewer than three"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0,5\nf 1 2 3\n", "'0,5'"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 1_0\nf 1 2 3\n", "'1_0'"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "a face with 2 corners"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3.0\n", "'3.0'"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "at least one triangle"),
    ],
)
def test_obj_files(tmp_path, text, message):
    with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
        robot(tmp_path, "m.obj", text.encode())
    assert "mesh of link upper in" in str(caught.value) and "arm.urdf" in str(caught.value)
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Mesh(file=tmp_path / "m.obj")


@pytest.mark.parametrize("name", ["wedge.stl", "text.stl"])
def test_stl_files_that_are_cut_off(tmp_path, name):
    for share in (0.3, 0.7, 0.95):
        with pytest.raises(mp.errors.FileFormatError, match="announces|cut off|is expected"):
            robot(tmp_path, name, MESHES[name][: int(share * len(MESHES[name]))])


@pytest.mark.parametrize("header", [b"solid of a CAD program", b"made elsewhere"])
def test_bytes_behind_a_binary_stl_are_told(tmp_path, header):
    with pytest.raises(mp.errors.FileFormatError, match="its header announces 6 facets, but it holds 6.04"):
        robot(tmp_path, "wedge.stl", header.ljust(80) + MESHES["wedge.stl"][80:] + bytes(2))


def test_a_base_offset_is_no_length_of_the_arm(tmp_path, caplog):
    """A turntable with a long table: nothing tells its unit."""
    body = '<collision><geometry><box size="0.9 0.05 0.05"/></geometry></collision>'
    joint = (
        '<origin xyz="0 0 0.1"/><parent link="base"/><child link="table"/><limit lower="-2" upper="2" velocity="1" effort="1"/>'
    )
    (tmp_path / "r.urdf").write_text(
        f'<robot name="r"><link name="base"/><link name="table">{body}</link><joint name="j" type="revolute">{joint}</joint></robot>'
    )
    mp.load_robot(tmp_path / "r.urdf")
    assert "another unit" not in caplog.text


def collada(tmp_path, unit, transform, up="Z_UP"):
    """The wedge of the samples in a file of another unit and with another transform of its node."""
    text = MESHES["wedge.dae"].decode().replace('<unit meter="1" name="meter"/>', unit).replace("Z_UP", up)
    old = text[text.index("<matrix>") : text.index("</matrix>") + 9]
    (tmp_path / "m.dae").write_text(text.replace(old, transform))
    return tmp_path / "m.dae"


@pytest.mark.parametrize("up", ["X_UP", "Y_UP", "Z_UP"])
@pytest.mark.parametrize(
    ("unit", "length"), [('<unit meter="0.001"/>', 1e-3), ('<unit name="inch" meter="0.0254"/>', 0.0254), ("", 1)]
)
def test_units_and_nodes_of_collada(tmp_path, unit, length, up):
    """RViz applies the unit to vertices and to translations of nodes, and no vertical axis."""
    file = collada(tmp_path, unit, "<translate>3 0 0</translate><rotate>0 0 1 90</rotate><scale>2 1 1</scale>", up)
    corners = samples.CORNERS @ np.diag([2.0, 1, 1]) @ np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]) + [3, 0, 0]
    mesh = read_mesh("file", file)
    assert mesh.unit == length
    np.testing.assert_allclose(np.unique(mesh.triangles.reshape(-1, 3).round(9), axis=0), np.unique(corners.round(9), axis=0))
    body = robot(tmp_path, "m.dae", file.read_bytes()).geometry.geometryObjects[2]
    expected = np.unique((0.5 * length * corners).round(9), axis=0)
    np.testing.assert_allclose(np.unique(np.array(body.geometry.vertices()).round(9), axis=0), expected, atol=2e-9)


def test_a_cube_in_millimetres_is_where_it_is_drawn(tmp_path):
    """A cube of 100 mm at (300, 0, 0) mm on the last link; a wall on its way was passed through."""
    trimesh = pytest.importorskip("trimesh")
    cube = trimesh.creation.box(extents=[100, 100, 100])
    numbers = " ".join(map(str, (np.array(cube.vertices) + [300, 0, 0]).ravel()))
    text = MESHES["wedge.dae"].decode().replace('meter="1"', 'meter="0.001"')
    old = text[text.index("<float_array") : text.index("</float_array>")]
    text = text.replace(old, f'<float_array id="array" count="24">{numbers}').replace('count="5" stride', 'count="8" stride')
    old = text[text.index("<p>") : text.index("</p>")]
    text = text.replace(old, "<p>" + " ".join(map(str, np.array(cube.faces).ravel()))).replace('count="6"', 'count="12"')
    (tmp_path / "cube.dae").write_text(text)
    links = '<link name="base"/><link name="l1"/><link name="l2"/><link name="l3"><collision><geometry>'
    links += f'<mesh filename="{tmp_path}/cube.dae"/></geometry></collision></link>'
    joints = ""
    for k, (parent, child) in enumerate([("base", "l1"), ("l1", "l2"), ("l2", "l3")]):
        joints += f'<joint name="j{k}" type="revolute"><parent link="{parent}"/><child link="{child}"/><axis xyz="0 0 1"/>'
        joints += f'<origin xyz="{0.2 if k else 0} 0 {0 if k else 0.5}"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>'
    (tmp_path / "arm.urdf").write_text(f'<robot name="arm">{links}{joints}</robot>')
    arm = mp.load_robot(tmp_path / "arm.urdf")
    wall = mp.Scene([mp.Box(size=(0.2, 0.2, 1.2), position=(0.614, 0.336, 0.5))])
    truth = []
    for turn in np.linspace(0, 1, 101):  # the cube as a square against the wall, from its corners and edges
        rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        edge = np.linspace(-0.05, 0.05, 41)
        square = np.stack(np.meshgrid(0.4 + 0.3 + edge, edge), axis=-1).reshape(-1, 2) @ rotation.T
        truth.append((np.abs(square - [0.614, 0.336]) < 0.1).all(axis=1).any())
    found = wall.in_collision(arm, np.c_[np.linspace(0, 1, 101), np.zeros((101, 2))])
    assert 10 < np.sum(truth) < 90 and (found != truth).sum() <= 2


@pytest.mark.parametrize("name", ["m.gltf", "m.glb"])
def test_gltf_meshes_of_a_robot(tmp_path, name, monkeypatch):
    trimesh = pytest.importorskip("trimesh")
    wedge = trimesh.Scene(trimesh.Trimesh(samples.CORNERS, samples.FACES, process=False))
    data = wedge.export(file_type=name[2:])
    for other, part in data.items() if isinstance(data, dict) else ():
        (tmp_path / other).write_bytes(part)
    body = robot(tmp_path, name, data["model.gltf"] if isinstance(data, dict) else data).geometry.geometryObjects[2]
    vertices = np.unique(np.array(body.geometry.vertices()).round(6), axis=0)
    np.testing.assert_allclose(vertices, np.unique(0.5 * samples.CORNERS, axis=0), atol=1e-6)
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(mp.errors.MissingExtraError, match=r"pip install 'manipplan\[mesh\]'"):
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")


def obj(triangles):
    lines = [f"v {x!r} {y!r} {z!r}\n" for x, y, z in triangles.reshape(-1, 3).tolist()]
    return "".join(lines + [f"f {3 * k + 1} {3 * k + 2} {3 * k + 3}\n" for k in range(len(triangles))]).encode()


def test_bodies_that_are_drawn_in_another_unit(tmp_path):
    """The arm of the samples is about 1 m long; what is larger than ten times that is refused with its name."""
    corners = samples.CORNERS[samples.FACES]
    for good in (corners, 50 * corners, corners + [18.0, 0, 0]):
        robot(tmp_path, "m.obj", obj(good))
    with pytest.raises(
        mp.errors.FileFormatError, match=r"body upper_1 of link upper \(mesh .*m\.obj\) is 100 m long.*scale=\"0.001"
    ) as caught:
        robot(tmp_path, "m.obj", obj(1000 * corners))
    assert str(tmp_path / "arm.urdf") in str(caught.value)
    with pytest.raises(mp.errors.FileFormatError, match=r"body upper_1 of link upper .* is 150 m away from its link"):
        robot(tmp_path, "m.obj", obj(corners + [300.0, 0, 0]))


@pytest.mark.parametrize("lowest", [-12, -8])
@pytest.mark.parametrize("seed", range(3))
def test_thirty_triangles_of_all_sizes(tmp_path, seed, lowest):
    """Corners from 1e-12 to 1e5 m: they ended the process in the first collision model."""
    rng = np.random.default_rng(seed)
    directions = rng.normal(size=(30, 3, 3))
    directions /= np.linalg.norm(directions, axis=2, keepdims=True)
    triangles = 10 ** rng.uniform(lowest, 5, size=(30, 3, 1)) * directions
    with pytest.raises(mp.errors.FileFormatError, match=r"m\.obj\) is .* m long"):
        robot(tmp_path, "m.obj", obj(triangles))


def test_large_primitives_stand_on_no_joint(tmp_path):
    floor = '<link name="base"><collision><origin xyz="0 0 -1"/><geometry><box size="200 200 1"/></geometry></collision>'
    text = samples.urdf("m.obj").decode()
    (tmp_path / "m.obj").write_bytes(MESHES["wedge.obj"])
    (tmp_path / "arm.urdf").write_text(text.replace('<link name="base">', floor))
    assert mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip").geometry.ngeoms == 5
    (tmp_path / "arm.urdf").write_text(text.replace('<sphere radius="0.08"/>', '<sphere radius="80"/>'))
    with pytest.raises(
        mp.errors.FileFormatError, match=r"body fore_0 of link fore \(a Sphere\) is 160 m long.*lengths are in metres"
    ):
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")
    (tmp_path / "arm.urdf").write_text(text.replace('<origin xyz="0.2 0 0"/>', '<origin xyz="200 0 0"/>'))
    with pytest.raises(mp.errors.FileFormatError, match=r"body fore_0 of link fore \(a Sphere\) is 200 m away"):
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")


def test_missing_meshes_are_named_together(tmp_path):
    text = samples.urdf("one.stl").decode()
    more = '<link name="tip"><collision><geometry><mesh filename="package://pack/two.stl"/></geometry></collision></link>'
    (tmp_path / "arm.urdf").write_text(text.replace('<link name="tip"/>', more))
    with pytest.raises(mp.errors.FileFormatError) as caught:
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")
    message = str(caught.value)
    assert "not found: package://one.stl (link upper), package://pack/two.stl (link tip)" in message
    assert all(remedy in message for remedy in ("packages=", "package_dirs=", "meshes=False"))


@pytest.mark.parametrize(
    "name", ["package://../../x.stl", "package://pack/../../x.stl", "model://pack/a/../../../x.stl", "package://.."]
)
def test_a_mesh_does_not_leave_its_package(tmp_path, name):
    (tmp_path / "a" / "b" / "pack").mkdir(parents=True)
    (tmp_path / "x.stl").write_bytes(MESHES["wedge.stl"])
    (tmp_path / "a" / "x.stl").write_bytes(MESHES["wedge.stl"])
    file = tmp_path / "a" / "b" / "arm.urdf"
    file.write_text(samples.urdf("x.stl").decode().replace("package://x.stl", name))
    with pytest.raises(mp.errors.FileFormatError, match="stay inside their package, unlike"):
        mp.Robot.from_urdf(file, tool="tip")


@pytest.mark.parametrize(
    "name", ["http://x/m.stl", "../meshes/wedge.stl", "package:///meshes/wedge.stl", "package://meshes/./a/../wedge.stl"]
)
def test_names_of_meshes(tmp_path, name, monkeypatch):
    for folder in ("urdf", "meshes", "elsewhere"):
        (tmp_path / folder).mkdir()
    (tmp_path / "meshes" / "a").mkdir()
    (tmp_path / "meshes" / "wedge.stl").write_bytes(MESHES["wedge.stl"])
    file = tmp_path / "urdf" / "arm.urdf"
    file.write_text(samples.urdf("x.stl").decode().replace("package://x.stl", name))
    monkeypatch.chdir(tmp_path / "elsewhere")
    if name.startswith("http"):
        with pytest.raises(mp.errors.FileFormatError, match="package://, model://, file:// or a path, unlike http://x"):
            mp.Robot.from_urdf(file, tool="tip")
    else:
        assert mp.Robot.from_urdf(file, tool="tip").geometry.ngeoms == 4


@pytest.mark.parametrize("faces", ["f 1 1 2\n", "f 1 2 4\n", "f 1 1 1\nf 1 2 4\n"])
def test_meshes_without_an_area(tmp_path, faces):
    with pytest.raises(mp.errors.FileFormatError, match=r"one triangle with an area, unlike .*m\.obj of upper_1"):
        robot(tmp_path, "m.obj", f"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\n{faces}".encode())


def test_distances_to_an_obj_with_a_face_less(tmp_path):
    """`F` for `f` was passed over: the distance to the open box was -1.8e308 m."""
    text = MESHES["wedge.obj"].decode()
    (tmp_path / "m.obj").write_text(text.replace("\nf ", "\nF ", 1))
    with pytest.raises(mp.errors.FileFormatError, match="it has lines 'F', which are not read"):
        mp.Scene([mp.Mesh(file=tmp_path / "m.obj")])
