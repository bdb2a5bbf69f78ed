"""Mesh files that a mesh loader crashes on, or fills the memory with: refused before it reads them."""

import sys
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.robots.meshes.files import fault_of

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
    assert fault_of(tmp_path / name) is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        # the loader reads a line for each entry, whatever the header says: it crashes when these are out of step
        (HEAD.replace("vertex 4", "vertex 5") + BODY, "a face|cut off"),
        (HEAD + BODY.replace("3 2 0 3", "0"), "a face has 0 corners"),
        (HEAD + BODY.replace("3 2 0 3", "2 0 1"), "a face has 2 corners"),
        (HEAD + BODY.replace("3 2 0 3", "3 2 0 4"), "a face names corner 4 of 4"),
        (HEAD + BODY.replace("3 2 0 3", "3 2 0 0.5"), "a face names corner 0.5 of 4"),
        (HEAD + BODY.replace("1 0 0", "1 nan 0", 1), "corner 1 is at .*nan"),
        (HEAD + BODY.replace("1 0 0", "1 1e200 0", 1), "corner 1 is at .*not at finite places"),
        (HEAD.replace("face 4", "face 0") + BODY, "no faces"),
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
    with pytest.raises(mp.FileFormatError, match=message):
        robot(tmp_path, "m.ply", text.encode())


@pytest.mark.parametrize("scheme", ["package://", "model://", "file://"])
def test_a_mesh_is_judged_wherever_its_name_points(tmp_path, scheme):
    (tmp_path / "pack").mkdir()
    (tmp_path / "pack" / "m.ply").write_bytes(b"ply\n")
    text = samples.urdf("m.ply").decode()
    assert "package://m.ply" in text
    place = tmp_path / "pack" / "m.ply" if scheme == "file://" else "pack/m.ply"
    (tmp_path / "arm.urdf").write_text(text.replace("package://m.ply", f"{scheme}{place}"))
    with pytest.raises(mp.FileFormatError, match="no end_header"):
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")


def test_lines_of_a_ply_file_that_are_swapped(tmp_path):
    lines = MESHES["text.ply"].decode().splitlines()
    corner, face = lines.index("0 0 0.2"), lines.index("3 2 3 4")
    lines[corner], lines[face] = lines[face], lines[corner]
    with pytest.raises(mp.FileFormatError, match="PLY|a face"):
        robot(tmp_path, "m.ply", "\n".join(lines).encode())


@pytest.mark.parametrize("name", ["m", "m.bin", "m.ply ", "m.blend"])
def test_the_format_of_a_mesh_is_that_of_its_name(tmp_path, name):
    """By its contents the loader would take it for a PLY file, which nobody has judged."""
    with pytest.raises(mp.FileFormatError, match=r"collision meshes are \.stl, \.obj, \.dae, \.ply files, unlike package://m"):
        robot(tmp_path, name, MESHES["wedge.ply"])


def test_a_name_of_a_mesh_that_is_too_long(tmp_path):
    (tmp_path / "arm.urdf").write_bytes(samples.urdf("9" * 4000 + ".ply"))
    with pytest.raises(mp.FileFormatError, match="File name too long"):
        mp.Robot.from_urdf(tmp_path / "arm.urdf", tool="tip")


def test_meshes_of_an_mjcf_are_in_mujoco_s_formats(tmp_path):
    (tmp_path / "wedge.stl").write_bytes(MESHES["wedge.stl"])
    (tmp_path / "arm.xml").write_text(samples.MJCF)
    assert mp.Robot.from_mjcf(tmp_path / "arm.xml", velocity=1.0).geometry.ngeoms == 5
    (tmp_path / "wedge.ply").write_bytes(MESHES["wedge.ply"])
    (tmp_path / "arm.xml").write_text(samples.MJCF.replace("wedge.stl", "wedge.ply"))
    with pytest.raises(mp.FileFormatError, match=r"MuJoCo says: .*wedge\.ply"):
        mp.Robot.from_mjcf(tmp_path / "arm.xml", velocity=1.0)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("<p>0 2 1", "<p>0 world 1", "<p> needs whole numbers, not 'world 1 "),
        ("<p>0 2 1", "<p>0 2 1,5", "<p> needs whole numbers, not '1,5 1 2"),
        ("<p>0 2 1", "<p>0 2 ١", "<p> needs whole numbers"),
        ("<p>0 2 1", "<p>0 <a/>2 1", "<p> needs whole numbers"),
        ('"array" count="15"', '"array" count="4294967295"', "<float_array> needs count .* within the size of the file"),
        ('count="6"', 'count="-1"', "<triangles> needs count with a whole number"),
        ('count="6"', f'count="{"9" * 400}"', "<triangles> needs count"),
        ('stride="3"', 'stride="1e9"', "<accessor> needs stride"),
        ("0.2 0.2 0<", "0.2 0.2 nan<", "<float_array> needs numbers, not 'nan'"),
        ("<matrix>1 0", "<matrix>1 a", "<matrix> needs numbers, not 'a 0"),
        ("</COLLADA>", "", "well-formed XML"),
        ('id="node"', 'id="é"', "XML in UTF-8"),
    ],
)
def test_collada_files(tmp_path, old, new, message):
    text = MESHES["wedge.dae"].decode().replace(old, new)
    data = text.encode("latin-1" if "é" in new else "utf-8")
    with pytest.raises(mp.FileFormatError, match=message):
        robot(tmp_path, "m.dae", data)


def test_collada_files_are_not_too_deep(tmp_path):
    deep = MESHES["wedge.dae"].decode().replace("<scene>", "<scene>" * 1000)
    with pytest.raises(mp.FileFormatError, match="nested at most 500 deep"):
        robot(tmp_path, "m.dae", deep.encode())


@pytest.mark.parametrize("name", ["text.ply", "wedge.ply"])
def test_ply_files_of_obstacles_are_read_without_the_mesh_loader(tmp_path, name):
    file = tmp_path / "m.ply"
    file.write_bytes(MESHES[name])
    [hull] = mp.Mesh(file=file, scale=2.0).shapes()
    points = np.array([hull.point(i) for i in range(hull.num_points)])
    np.testing.assert_allclose(np.unique(points.round(6), axis=0), np.unique(2 * samples.CORNERS, axis=0), atol=1e-6)
    file.write_bytes(MESHES[name].replace(b"face 6", b"face 600"))
    with pytest.raises(mp.FileFormatError, match="cut off"):
        mp.Mesh(file=file)
