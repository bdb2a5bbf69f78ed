"""Scenes of MoveIt in both formats: each shape where MoveIt has it, and one clear error for everything else."""

import contextlib

import numpy as np
import pinocchio as pin
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp

ROOT = 0.5**0.5
#: The same scene in the format with and without the poses of objects.
OLD = f"""(noname)
* table
2
box
0.8 1.2 0.05
0.5 0 0.4
0 0 0 1
0 0 0 0
cylinder
0.1 0.4
0.2 0.3 0.6
0 {ROOT} 0 {ROOT}
1 0 0 1
* ball
1
sphere
0.07
0.5 0 0.6
0 0 0 1
0 0 0 0
.
"""
NEW = f"""my scene
* table
0.5 0 0.4
0 0 0 1
2
box
0.8 1.2 0.05
0 0 0
0 0 0 1
0 0 0 0
cylinder
0.1 0.4
-0.3 0.3 0.2
0 {ROOT} 0 {ROOT}
1 0 0 1
1
handle 0.1 0.2 0.3
0 0 0 1
* ball
0.5 0 0.6
0 0 0 1
1
sphere
0.07
0 0 0
0 0 0 1
0 0 0 0
0
.
"""
POSE = {"position": [0.5, 0.0, 0.4], "orientation": [0.0, 0.0, 0.0, 1.0]}
MESSAGE = {
    "name": "(noname)",
    "robot_model_name": "panda",
    "fixed_frame_transforms": [{"child_frame_id": "world", "transform": {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1]}}],
    "world": {
        "collision_objects": [
            {
                "id": "table",
                "primitives": [
                    {"type": "box", "dimensions": [0.8, 1.2, 0.05]},
                    {"type": "cylinder", "dimensions": [0.4, 0.1]},
                ],
                "primitive_poses": [POSE, {"position": [0.2, 0.3, 0.6], "orientation": [0, ROOT, 0, ROOT]}],
            },
            {
                "id": "ball",
                "primitives": [{"type": "sphere", "dimensions": [0.07]}],
                "primitive_poses": [{"position": [0.5, 0, 0.6], "orientation": [0, 0, 0, 1]}],
            },
        ]
    },
}


def read(tmp_path, content, **options):
    """The scene of a text, or of a message."""
    file = tmp_path / ("s.scene" if isinstance(content, str) else "s.yaml")
    file.write_text(content if isinstance(content, str) else yaml.safe_dump(content))
    return mp.Scene.from_moveit(file, **options)


def changed(**objects):
    """The message with one object alone, changed."""
    [table, _] = MESSAGE["world"]["collision_objects"]
    return {"world": {"collision_objects": [{**table, **objects}]}}


def expected():
    turn = pin.utils.rotate("y", np.pi / 2)
    return mp.Scene(
        [
            mp.Box(size=(0.8, 1.2, 0.05), position=(0.5, 0, 0.4), name="table.0"),
            mp.Cylinder(radius=0.1, length=0.4, position=(0.2, 0.3, 0.6), rotation=turn, name="table.1"),
            mp.Sphere(radius=0.07, position=(0.5, 0, 0.6), name="ball"),
        ]
    )


@pytest.mark.parametrize("content", [OLD, NEW, MESSAGE], ids=["old text", "new text", "yaml"])
def test_every_format_gives_the_same_scene(tmp_path, panda, rng, content):
    scene = read(tmp_path, content)
    assert scene.names == ("table.0", "table.1", "ball") and not scene.allowed
    for q in panda.random_configuration(rng, size=4):
        np.testing.assert_allclose(scene.distances(panda, q), expected().distances(panda, q), atol=1e-9)


@pytest.mark.parametrize("kind", [1, "BOX", "box"])
@pytest.mark.parametrize("style", ["lists", "mappings"])
def test_what_ros_writes(tmp_path, kind, style):
    """Numbers for shapes, mappings for poses, the pose of an object, a header."""
    pose = {"position": [0.1, 0.2, 0.3], "orientation": [0.0, 0.0, ROOT, ROOT]}
    if style == "mappings":
        keys = {"position": "xyz", "orientation": "xyzw"}
        pose = {name: dict(zip(keys[name], values, strict=True)) for name, values in pose.items()}
    entry = {
        "header": {"frame_id": "world", "stamp": {"sec": 0, "nanosec": 0}},
        "id": "box",
        "type": {"key": "", "db": ""},
        "pose": pose,
        "primitives": [{"type": kind, "dimensions": [0.1, 0.2, 0.3]}],
        "primitive_poses": [{"position": {"x": 1.0}, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 0.0}}],
        "meshes": [],
        "mesh_poses": [],
        "operation": 0,
    }
    octomap = {"octomap": {"data": []}}
    [box] = read(tmp_path, {"world": {"collision_objects": [entry], "octomap": octomap}, "is_diff": False}).obstacles
    np.testing.assert_allclose(box.position, [0.1, 1.2, 0.3], atol=1e-12)
    np.testing.assert_allclose(box.pose.rotation, pin.utils.rotate("z", np.pi / 2), atol=1e-12)


def tetrahedron():
    vertices = np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]])
    return vertices, np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def test_meshes_are_read(tmp_path):
    vertices, faces = tetrahedron()
    (tmp_path / "meshes").mkdir()
    lines = [f"v {x} {y} {z}" for x, y, z in vertices] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    (tmp_path / "meshes" / "t.obj").write_text("\n".join(lines) + "\n")
    numbers = "\n".join(" ".join(map(str, row)) for row in [*vertices, *faces])
    text = f"x\n* t\n1\nmesh\n4 4\n{numbers}\n0 0 0\n0 0 0 1\n0 0 0 0\n.\n"
    pose = [{"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}]
    inline = {
        "vertices": [dict(zip("xyz", row, strict=True)) for row in vertices.tolist()],
        "triangles": [{"vertex_indices": row} for row in faces.tolist()],
    }
    scenes = [read(tmp_path, text)]
    for mesh in (inline, {"resource": "package://parts/t.obj"}, {"resource": "meshes/t.obj", "dimensions": [1, 1, 1]}):
        message = {"world": {"collision_objects": [{"id": "t", "meshes": [mesh], "mesh_poses": pose}]}}
        scenes.append(read(tmp_path, message, packages={"parts": tmp_path / "meshes"}))
    for scene in scenes:
        [hull] = scene.obstacles[0].shapes()
        corners = np.array([hull.point(k) for k in range(hull.num_points)])
        assert {tuple(row) for row in corners.round(6).tolist()} == {tuple(row) for row in vertices.tolist()}


def test_a_plane_is_the_half_space_behind_it(tmp_path):
    text = "x\n* floor\n1\nplane\n0 0 2 -1\n0 0 0\n0 0 0 1\n0 0 0 0\n.\n"
    message = {"id": "floor", "planes": [{"coef": [0, 0, 2, -1]}], "plane_poses": [{"position": [0, 0, 0]}]}
    for content in (text, {"world": {"collision_objects": [message]}}):
        [plane] = read(tmp_path, content).obstacles
        assert isinstance(plane, mp.Plane)
        np.testing.assert_allclose(plane.pose.act(np.array([3.0, 4.0, 0.0]))[2], 0.5)
        np.testing.assert_allclose(plane.pose.rotation[:, 2], [0, 0, 1], atol=1e-12)


def test_frames_are_followed_to_one_root(tmp_path):
    transforms = [
        {"header": {"frame_id": "world"}, "child_frame_id": "cell", "transform": {"translation": [0, 0, 1]}},
        {"header": {"frame_id": "cell"}, "child_frame_id": "tray", "transform": {"translation": {"x": 2.0}}},
    ]
    message = changed(header={"frame_id": "tray"})
    assert read(tmp_path, message).names == ("table.0", "table.1")  # one frame alone is the world
    scene = read(tmp_path, {**message, "fixed_frame_transforms": transforms})
    np.testing.assert_allclose(scene.obstacles[0].position, [2.5, 0.0, 1.4])
    two = {
        "world": {"collision_objects": [*message["world"]["collision_objects"], {**changed()["world"]["collision_objects"][0]}]}
    }
    two["world"]["collision_objects"][1] |= {"id": "other", "header": {"frame_id": "camera"}}
    with pytest.raises(mp.errors.FileFormatError, match=r"'camera', 'tray'.*one frame for all"):
        read(tmp_path, two)
    loop = [{**transforms[0], "header": {"frame_id": "tray"}}, transforms[1]]
    with pytest.raises(mp.errors.FileFormatError, match="not a loop"):
        read(tmp_path, {**message, "fixed_frame_transforms": loop})


def test_pairs_of_an_object_and_a_link_may_touch(tmp_path):
    names = ["table", "panda_hand", "panda_link1"]
    rows = [[True, True, False], [True, True, True], [False, True, True]]
    matrix = {"entry_names": names, "entry_values": [{"enabled": row} for row in rows]}
    scene = read(tmp_path, {**changed(), "allowed_collision_matrix": matrix})
    assert scene.allowed_names() == [["panda_hand", "table.0"], ["panda_hand", "table.1"]]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "its name, objects that begin"),
        ("x\n* a\n1\nbox\n1 1 1\n0 0 0\n0 0 0 1\n0 0 0 0\n", "a last line"),
        ("x\n* a\n1\nbox\n1 1\n.\n", "object a: .*3 finite numbers for a box"),
        ("x\n* a\n1\nbox\n1 1 x\n.\n", "3 numbers for a box"),
        ("x\n* a\n1\nbox\n1 1 nan\n.\n", "3 finite numbers"),
        ("x\n* a\n1\nbox\n1 1 -1\n0 0 0\n0 0 0 1\n0 0 0 0\n.\n", "object a, Box.size"),
        ("x\n* a\n1\nbox\n1 1 1\n0 0 0\n1 1 1 1\n0 0 0 0\n.\n", "quaternion"),
        ("x\n* a\n2\nbox\n1 1 1\n0 0 0\n0 0 0 1\n0 0 0 0\n.\n", "object a: the end.*a shape"),
        ("x\n* a\n1\nbox\n1 1 1\n0 0 0\n0 0 0 1\n0 0 0 0\n7\n.\n", "the next object"),
        ("x\n* a\n1.5\n.\n", "the number of shapes"),
        ("x\n* a\n1e300\n.\n", "the number of shapes"),
        ("x\n* a\n1\ncone\n1 1\n.\n", "'cone'"),
        ("x\n* a\n1\nmesh\n3 1\n0 0 0 1 0 0 0 1 0\n0 1 9\n0 0 0\n0 0 0 1\n0 0 0 0\n.\n", "vertices 0 to 2"),
        (OLD.replace("* ball", "* table"), "object table, twice.*names that differ"),
        (OLD.replace("* table", "1\n* table"), "its name, objects"),
        (OLD + "more\n", "its name, objects"),
        (OLD.replace("* table", " * table").replace("* ball", " * ball"), "its name, objects"),
        (OLD.replace("0.8 1.2", "0_8 1.2"), "3 finite numbers for a box"),
        ({}, "the key world"),
        ({"world": None}, "collision_objects"),
        ({"world": {"collision_object": []}}, "'collision_object'.*collision_objects"),
        (changed(primitivs=[]), "'primitivs'.*primitives"),
        (changed(frame_id="other"), "'frame_id'"),
        (changed(primitive_poses=[POSE, {"translation": [1, 0, 0]}]), "'translation'"),
        (changed(primitive_poses=[POSE, {"position": {"X": 1}}]), "'X'"),
        (changed(primitive_poses=[POSE, {"orientation": {"roll": 1}}]), "'roll'"),
        ({**changed(), "fixed_frame_transforms": [{"child_frame_id": "a"}] * 2}, "'a' twice"),
        (
            {**changed(), "fixed_frame_transforms": [{"child_frame_id": "a", "transform": {"position": [1, 0, 0]}}]},
            "'position'",
        ),
        ([], "a mapping"),
        ({"world": {"collision_objects": 3}}, "collision_objects.*a list"),
        ({"world": {"collision_objects": [3]}}, r"collision_objects\[0\].*a mapping"),
        (changed(id=""), "a name"),
        (changed(primitives=[], primitive_poses=[]), "at least one primitive"),
        (changed(primitive_poses=[POSE]), "1 poses.*2, one for each"),
        (changed(primitives=[{"type": 4, "dimensions": [1, 1]}], primitive_poses=[POSE]), "'4'"),
        (changed(primitives=[{"type": "box", "dimensions": [1, 1]}], primitive_poses=[POSE]), r"table.primitives\[0\]"),
        (changed(primitives=[{"type": "sphere", "dimensions": [-1]}], primitive_poses=[POSE]), "above 0"),
        (changed(primitive_poses=[POSE, {**POSE, "orientation": [1, 1, 1, 1]}]), "quaternion"),
        (changed(primitive_poses=[POSE, {**POSE, "position": [1, ".nan", 1]}]), "position"),
        (changed(operation=1), "operation.*0, which adds"),
        (changed(meshes=[{"resource": "package://parts/t.stl"}], mesh_poses=[POSE]), "packages: got 'parts'"),
        (changed(meshes=[{"resource": "t.stl"}], mesh_poses=[POSE]), "existing file"),
        (changed(meshes=[{"vertices": [], "triangles": []}], mesh_poses=[POSE]), "at least one triangle"),
        ({**changed(), "robot_state": {"attached_collision_objects": [{"object": {"id": "cup"}}]}}, "cup.*robot.attach"),
        ({"world": {"collision_objects": [], "octomap": {"octomap": {"data": [1, 2]}}}}, "octomap"),
    ],
)
def test_wrong_files(tmp_path, content, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        read(tmp_path, content)


def test_a_text_without_objects_is_an_empty_scene(tmp_path):
    assert read(tmp_path, "(noname)\n.\n").names == ()


@pytest.mark.parametrize("packages", [["x"], {"parts": 5}, {"parts": "nowhere"}])
def test_wrong_packages(tmp_path, packages):
    with pytest.raises(mp.errors.InvalidInputError, match="packages"):
        read(tmp_path, MESSAGE, packages=packages)


def test_paddings_are_told(tmp_path, caplog):
    read(tmp_path, {**changed(), "link_padding": [{"link_name": "a", "padding": 0.01}], "link_scale": [{"scale": 1.0}]})
    assert "link_padding is not used" in caplog.text and "link_scale" not in caplog.text


@pytest.mark.slow
@given(st.data())
def test_spoilt_text_is_refused_or_read(tmp_path_factory, data):
    """Texts with words taken out, doubled or exchanged give a scene or our error, never another exception."""
    words = data.draw(st.sampled_from([OLD, NEW])).split(" ")
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(words) - 1))
        words[at : at + 1] = data.draw(
            st.sampled_from([[], [words[at]] * 2, ["-1"], ["1e400"], ["*"], ["nan"], ["\n.\n"], ["mesh"]])
        )
    with contextlib.suppress(mp.errors.InvalidInputError):
        assert read(tmp_path_factory.mktemp("spoilt"), " ".join(words)).names


@pytest.mark.parametrize(
    ("shape", "pose", "message"),
    [
        ("sphere\n0.1", "1e308 0 0\n0 0 0 1", r"position.*numbers from -1e\+06 to 1e\+06"),
        ("sphere\n0.1", "0 0 0\n1e308 0 0 1e308", r"orientation.*numbers from -1e\+12"),
        ("sphere\n1e308", "0 0 0\n0 0 0 1", r"radius.*at most 1e\+06"),
        ("plane\n1e308 0 1e308 0", "0 0 0\n0 0 0 1", r"plane.*numbers from -1e\+06 to 1e\+06"),
        ("plane\n1e-320 0 0 1", "0 0 0\n0 0 0 1", r"a plane (within 1e\+06 m|with a normal other than zero)"),
    ],
)
def test_huge_numbers(tmp_path, shape, pose, message):
    file = tmp_path / "cell.scene"
    file.write_text(f"cell\n* a\n0 0 0\n0 0 0 1\n1\n{shape}\n{pose}\n0 0 0 0\n0\n.\n")
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Scene.from_moveit(file)
