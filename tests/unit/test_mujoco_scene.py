"""The static bodies of an MJCF as obstacles: MuJoCo's own distances are the judge."""

import os
import sys

import mujoco
import numpy as np
import pytest

import manipplan as mp

CELL = """<mujoco><compiler angle="degree"/>
<asset><mesh name="wedge" vertex="0 0 0 0.1 0 0 0 0.1 0 0 0 0.1" scale="2 2 2"/></asset>
<worldbody>
<geom name="floor" type="plane" size="1 1 0.1" pos="0 0 -0.1"/>
<body name="table" pos="0.5 0 0.2" euler="10 20 30"><geom name="top" type="box" size="0.2 0.3 0.01"/>
<geom type="cylinder" size="0.02 0.1" pos="0 0 -0.1"/>
<body name="cup" pos="0 0.1 0.1"><geom name="cup" type="capsule" fromto="0 0 0 0.1 0.1 0.1" size="0.03"/></body></body>
<body name="ball" pos="1 0 0"><geom name="ball" type="sphere" size="0.05"/>
<geom name="drawn" type="box" size="1 1 1" contype="0" conaffinity="0"/></body>
<body name="wedge" pos="0 0.6 0.3" euler="0 40 0"><geom name="wedge" type="mesh" mesh="wedge"/></body>
<body name="moving" pos="0 0 1"><joint name="j" type="hinge" axis="0 0 1"/><geom type="box" size="0.1 0.1 0.1"/>
<body><geom type="box" size="0.1 0.1 0.1"/></body></body>
<body name="probe" mocap="true" pos="0 0 5"><geom name="probe" type="sphere" size="0.05" contype="0" conaffinity="0"/></body>
</worldbody></mujoco>"""


@pytest.fixture
def cell(tmp_path):
    file = tmp_path / "cell.xml"
    file.write_text(CELL)
    return file


@pytest.mark.slow
def test_static_bodies_that_collide_are_obstacles(cell):
    scene = mp.Scene.from_mjcf(cell)
    assert scene.names == ("floor", "top", "table.2", "cup", "ball", "wedge")


@pytest.mark.slow
def test_pairs_and_mocap_bodies_are_obstacles_of_robot_and_scene_alike(tmp_path):
    file = tmp_path / "cell.xml"
    off = 'contype="0" conaffinity="0"'
    file.write_text(f"""<mujoco><worldbody><geom name="wall" type="box" size=".1 .1 .1" pos="1 0 0" {off}/>
        <geom name="drawn" size=".1" {off}/><body name="stand" mocap="true" pos="0 1 0"><geom name="stand" size=".1"/>
        <body><geom name="top" size=".1" pos="0 0 1"/></body></body>
        <body name="arm"><joint name="j" axis="0 0 1"/><geom name="g" type="capsule" size=".05" fromto="0 0 0 1 0 0"/>
        <site name="tip" pos="1 0 0"/></body></worldbody><contact><pair geom1="wall" geom2="g"/></contact></mujoco>""")
    scene, alone = mp.Scene.from_mjcf(file), mp.Robot.from_mjcf(file, tool="tip")
    assert scene.names == ("wall", "stand", "top")
    q = np.array([[0.0], [0.5], [np.pi / 2], [3.0]])
    assert mp.Scene().in_collision(alone, q).tolist() == [True, False, True, False]
    (tmp_path / "arm.xml").write_text("""<mujoco><worldbody><body name="arm"><joint name="j" axis="0 0 1"/>
        <geom name="g" type="capsule" size=".05" fromto="0 0 0 1 0 0"/><site name="tip" pos="1 0 0"/></body></worldbody></mujoco>""")
    arm = mp.Robot.from_mjcf(tmp_path / "arm.xml", tool="tip")
    assert scene.in_collision(arm, q).tolist() == [True, False, True, False]


@pytest.mark.slow
def test_distances_are_those_of_mujoco(cell, panda, rng):
    """A ball carried by the arm is as far from each obstacle as MuJoCo's ball at the same place."""
    scene = mp.Scene.from_mjcf(cell)
    carrying = panda.attach(mp.Sphere(radius=0.05), name="probe")
    pairs = scene.collision_model(carrying).pair_names
    model = mujoco.MjModel.from_xml_path(str(cell))
    data = mujoco.MjData(model)
    for q in panda.random_configuration(rng, size=8):
        data.mocap_pos[0] = panda.kinematics().pose(q)[:3, 3]
        mujoco.mj_forward(model, data)
        ours = dict(zip(pairs, scene.distances(carrying, q), strict=True))
        for name in scene.names:
            geom = 2 if name == "table.2" else model.geom(name).id
            theirs = mujoco.mj_geomDistance(model, data, model.geom("probe").id, geom, 10.0, None)
            assert ours["probe", name] == pytest.approx(theirs, abs=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<mujoco><worldbody><geom type='box' size='1 1'/></worldbody></mujoco>", "MuJoCo says"),
        ("<scene/>", "root is <mujoco>, not <scene>"),
        ("<mujoco><worldbody><geom name='egg' type='ellipsoid' size='1 2 3'/></worldbody></mujoco>", "egg: got 'ellipsoid'"),
    ],
)
def test_wrong_files(tmp_path, text, message):
    file = tmp_path / "bad.xml"
    file.write_text(text)
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Scene.from_mjcf(file)


@pytest.mark.slow
def test_geoms_of_one_mesh_share_its_hull(cell):
    more = "<geom type='mesh' mesh='wedge' pos='0 0 1' name='other'/>"
    cell.write_text(cell.read_text().replace('mesh="wedge"/>', f'mesh="wedge"/>{more}', 1))
    first, second = mp.Scene.from_mjcf(cell).obstacles[-2:]
    assert (first.name, second.name) == ("wedge", "other")
    assert first.shapes()[0] is second.shapes()[0]
    assert abs(second.pose.translation - first.pose.translation).max() > 0.5


@pytest.mark.slow
def test_a_mesh_file_changed_within_a_second_is_read_again(tmp_path):
    """MuJoCo's cache of meshes compares the times of files to the second."""
    for size in (1.0, 2.0):
        corners = size * np.vstack([np.zeros(3), np.eye(3)])
        lines = [f"v {x} {y} {z}" for x, y, z in corners] + ["f 1 3 2", "f 1 2 4", "f 1 4 3", "f 2 3 4"]
        (tmp_path / "wedge.obj").write_text("\n".join(lines))
        os.utime(tmp_path / "wedge.obj", (1e9, 1e9))
        (tmp_path / "cell.xml").write_text(
            '<mujoco><asset><mesh name="wedge" file="wedge.obj"/></asset>'
            '<worldbody><geom name="wedge" type="mesh" mesh="wedge"/></worldbody></mujoco>'
        )
        (wedge,) = mp.Scene.from_mjcf(tmp_path / "cell.xml").obstacles
        edges = wedge.triangles - np.roll(wedge.triangles, 1, axis=1)
        assert np.linalg.norm(edges, axis=-1).max() == pytest.approx(size * 2**0.5)


def test_names_are_in_utf_8(tmp_path):
    (tmp_path / "part.xml").write_bytes(b"<mujoco><worldbody><body name='\x80'><geom size='1'/></body></worldbody></mujoco>")
    whole = "<mujoco><include file='part.xml'/></mujoco>"
    for text in ((tmp_path / "part.xml").read_bytes(), whole.encode()):
        (tmp_path / "cell.xml").write_bytes(text)
        with pytest.raises(mp.errors.FileFormatError, match="UTF-8"):
            mp.Scene.from_mjcf(tmp_path / "cell.xml")


@pytest.mark.slow
@pytest.mark.parametrize("size", ["1e308", "1e7"])
def test_sizes_are_bounded(tmp_path, size):
    (tmp_path / "cell.xml").write_text(f"<mujoco><worldbody><geom type='box' size='1 1 {size}'/></worldbody></mujoco>")
    with pytest.raises(mp.errors.InvalidInputError, match=r"size: got .*from -1e\+06 to 1e\+06|finite numbers"):
        mp.Scene.from_mjcf(tmp_path / "cell.xml")


def test_without_mujoco_the_error_says_how_to_install_it(cell, monkeypatch):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(mp.errors.MissingExtraError, match=r"pip install 'manipplan\[mujoco\]'"):
        mp.Scene.from_mjcf(cell)
