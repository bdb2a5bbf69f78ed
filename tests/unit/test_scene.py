"""Obstacles, their files, and collision and distance against closed forms."""

import re
import struct

import coal
import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial import ConvexHull

import manipplan as mp
from manipplan.collision.covers import fit_capsules
from manipplan.collision.world import mesh_triangles, outside


def tetrahedra(file, offsets):
    """An STL file (ASCII) of unit tetrahedra at the given x offsets."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    facets = []
    for x in offsets:
        for face in ([0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]):
            points = corners[face] + [x, 0, 0]
            vertices = "".join(f"vertex {p[0]} {p[1]} {p[2]}\n" for p in points)
            facets.append(f"facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    file.write_text("solid t\n" + "".join(facets) + "endsolid t\n")
    return file


def one_joint_ball(tmp_path):
    """An arm of one sliding joint along x with a ball of 0.1 m."""
    file = tmp_path / "ball.urdf"
    file.write_text("""<robot name="ball"><link name="base"/><link name="b"><collision><geometry><sphere radius="0.1"/></geometry>
      </collision></link><joint name="x" type="prismatic"><parent link="base"/><child link="b"/><axis xyz="1 0 0"/>
      <limit lower="-5" upper="5" velocity="1" effort="1"/></joint></robot>""")
    return mp.load_robot(file)


@pytest.mark.parametrize(
    ("obstacle", "expected"),
    [
        (mp.Box(size=(1, 1, 1), position=(2, 0, 0)), 1.4),
        (mp.Box(size=(1, 1, 1), position=(2, 0, 0), rotation=(0, 0, np.pi / 4)), 2 - np.sqrt(0.5) - 0.1),
        (mp.Sphere(radius=0.5, position=(2, 0, 0)), 1.4),
        (mp.Capsule(radius=0.2, length=1.0, position=(2, 0, 0)), 1.7),
        (mp.Cylinder(radius=0.2, length=1.0, position=(2, 0, 0), rotation=(0, np.pi / 2, 0)), 1.4),
        (mp.Sphere(radius=0.5, position=(0.3, 0, 0)), -0.3),
    ],
)
def test_distance_to_every_shape(tmp_path, obstacle, expected):
    robot = one_joint_ball(tmp_path)
    scene = mp.Scene([obstacle])
    assert scene.distances(robot, [0.0]).min() == pytest.approx(expected, abs=1e-6)
    assert scene.in_collision(robot, [0.0]) is bool(expected < 0)


def test_a_mesh_is_solid_and_its_parts_are_apart(tmp_path):
    robot = one_joint_ball(tmp_path)
    scene = mp.Scene([mp.Mesh(file=tetrahedra(tmp_path / "two.stl", [0.0, 3.0]), position=(0, -0.2, -0.2), scale=1.0)])
    assert len(scene.obstacles[0].shapes()) == 2
    inside, between = [0.25], [2.0]
    assert scene.in_collision(robot, inside)
    assert not scene.in_collision(robot, between)
    np.testing.assert_array_equal(scene.in_collision(robot, [inside, between]), [True, False])


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5", "baxter_left"])
def test_capsules_contain_the_mesh_they_stand_for(name):
    robot = mp.load_robot(name)
    meshes = [item.geometry for item in robot.geometry.geometryObjects if isinstance(item.geometry, coal.BVHModelBase)]
    for mesh in meshes[:6]:
        triangles = mesh_triangles(mesh)
        primitives = fit_capsules(triangles)
        # every point of the surface, sampled, lies in at least one primitive
        weights = np.random.default_rng(0).dirichlet([1, 1, 1], size=len(triangles))
        points = np.einsum("tk,tkx->tx", weights, triangles)
        excess = np.array([outside(primitive, points) for primitive in primitives])
        assert excess.min(axis=0).max() == 0.0
        assert sum(primitive.volume for primitive in primitives) < 8 * abs(mesh.computeVolume())


def test_primitives_touch_wherever_the_meshes_do(panda, demo_problem, rng):
    """Against Pinocchio with the meshes of the description: nothing that touches is missed."""
    scene = demo_problem.scene
    geometry = panda.geometry.copy()
    bodies = range(geometry.ngeoms)
    for obstacle in scene.obstacles:
        index = geometry.addGeometryObject(pin.GeometryObject("o", 0, 0, obstacle.pose, obstacle.shapes()[0]))
        for body in bodies:
            if geometry.geometryObjects[body].parentJoint > 0:
                geometry.addCollisionPair(pin.CollisionPair(body, index))
    data, geometry_data = panda.model.createData(), pin.GeometryData(geometry)
    hits = 0
    for q in panda.random_configuration(rng, size=150):
        if pin.computeCollisions(panda.model, data, geometry, geometry_data, q, True):
            hits += 1
            assert scene.in_collision(panda, q)
    assert hits >= 20


def test_pairs_without_srdf_come_from_sampling(two_link_urdf):
    robot = mp.Robot.from_urdf(two_link_urdf(), tool="tip")
    model = mp.Scene().collision_model(robot)
    assert model.pair_names == ()
    assert set(model.dropped.values()) == {"parent and child link of one joint"}


def test_yaml_round_trip(tmp_path, panda):
    tetrahedra(tmp_path / "part.stl", [0.0])
    scene = mp.Scene(
        [
            mp.Box(size=(0.1, 0.2, 0.3), position=(0.4, 0.5, 0.6), rotation=(0.1, 0.2, 0.3), name="crate"),
            mp.Sphere(radius=0.1, position=(0.5, 0, 0.5)),
            mp.Capsule(radius=0.1, length=0.4, position=(0.5, 0.5, 0.5)),
            mp.Cylinder(radius=0.1, length=0.4, position=(-0.5, 0.5, 0.5)),
            mp.Mesh(file=tmp_path / "part.stl", scale=0.2, position=(-0.5, -0.5, 0.5)),
        ]
    )
    scene.to_yaml(tmp_path / "scene.yaml")
    again = mp.Scene.from_yaml(tmp_path / "scene.yaml")
    assert again.names == ("crate", "sphere1", "capsule2", "cylinder3", "mesh4")
    np.testing.assert_allclose(again.distances(panda, panda.neutral), scene.distances(panda, panda.neutral), atol=1e-12)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("obstacles: [{shape: bocks, size: [1, 1, 1]}]", r"obstacles\[0\]\.shape: got 'bocks'.*box"),
        ("obstacles: [{shape: box, size: [1, -1, 1]}]", r"obstacles\[0\].*size.*above zero"),
        ("obstacles: [{shape: box, size: [1, .nan, 1]}]", r"obstacles\[0\].*size.*finite"),
        ("obstacles: [{shape: box, size: [1, 1]}]", r"size.*shape \(3,\)"),
        ("obstacles: [{shape: box}]", "size"),
        ("obstacles: [{shape: sphere, radius: -0.1}]", "radius.*above 0"),
        ("obstacles: [{shape: sphere, radius: big}]", "radius.*: got 'big'"),
        ("obstacles: [{shape: sphere, radius: 1, colour: red}]", "colour"),
        ("obstacles: [{shape: sphere, radius: 1, position: [0, .inf, 0]}]", "position.*finite"),
        ("obstacles: [{shape: box, size: [1, 1, 1], rotation: [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}]", "rotation matrix"),
        ("obstacles: [{shape: mesh, file: nothing.stl}]", "existing file"),
        ("obstacles: [3]", "a mapping with shape"),
        ("obstacles: [{shape: [box]}]", "shape"),
        ("obstacles: [{shape: sphere, radius: 1, name: 7}]", r"name\): got 7"),
        ("boxes: []", "a list under the key obstacles"),
        ("{obstacles: [], allowed: [a]}", "pairs of two different names"),
        ("{obstacles: [], allowed: [[a, a]]}", "pairs of two different names"),
        ("{obstacles: [], allowed: [[a, [b]]]}", "pairs of two different names"),
        ("{obstacles: [], allowed: 3}", "a list of pairs"),
        ("obstacles: [", "YAML"),
        ("", "a list under the key"),
        ("obstacles: [{shape: sphere, radius: 1, name: a}, {shape: sphere, radius: 1, name: a}]", "names that differ"),
    ],
)
def test_wrong_scene_files(tmp_path, text, message):
    file = tmp_path / "scene.yaml"
    file.write_text(text)
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Scene.from_yaml(file)


def test_a_file_that_is_no_mesh(tmp_path):
    (tmp_path / "bad.stl").write_text("not a mesh")
    with pytest.raises(mp.errors.FileFormatError, match="a mesh"):
        mp.Mesh(file=tmp_path / "bad.stl")


def test_obstacles_need_a_robot_with_geometry(tmp_path):
    file = tmp_path / "bare.urdf"
    file.write_text("""<robot name="bare"><link name="base"/><link name="b"/><joint name="x" type="prismatic"><parent link="base"/>
      <child link="b"/><axis xyz="1 0 0"/><limit lower="-5" upper="5" velocity="1" effort="1"/></joint></robot>""")
    with pytest.raises(mp.errors.InvalidInputError, match="no collision geometry to check; collision='visual' checks"):
        mp.Scene([mp.Sphere(radius=1.0)]).in_collision(mp.load_robot(file), [0.0])


@pytest.mark.parametrize(
    ("stretch", "message"),
    [
        ((1, 1, 1e-7), "one is flat"),
        ((1, 1, 1e-8), "one is flat"),
        ((1, 1, 0), "one is flat"),
        ((1e15, 1, 1), r"within 1e\+06 m"),
        ((1.5e23, 1, 1), r"within 1e\+06 m"),
        ((1e7, 1e7, 1e7), r"within 1e\+06 m"),
        ((1e-10, 1e-10, 1e-10), "at least one triangle with an area"),
    ],
)
def test_meshes_that_are_flat_or_far_away(tmp_path, stretch, message):
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) * stretch
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in corners.tolist()] + ["f 1 3 2", "f 1 2 4", "f 2 3 4", "f 3 1 4"]
    (tmp_path / "m.obj").write_text("\n".join(lines) + "\n")
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Mesh(file=tmp_path / "m.obj", fill="hull")
    if "flat" in message:
        assert isinstance(mp.Mesh(file=tmp_path / "m.obj").shapes()[0], coal.BVHModelOBBRSS)


@pytest.mark.parametrize("thickness", [1e-2, 1e-5])
def test_thin_plates_are_bodies(tmp_path, thickness):
    corners = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, thickness)]
    faces = ConvexHull(np.array(corners)).simplices + 1
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {a} {b} {c}" for a, b, c in faces]
    (tmp_path / "m.obj").write_text("\n".join(lines) + "\n")
    [hull] = mp.Mesh(file=tmp_path / "m.obj").shapes()
    assert hull.num_points == 8


def ply(file, *, form="ascii", last=3):
    """A tetrahedron in PLY whose last face ends at the corner `last`."""
    corners, faces = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, last]]
    head = (
        f"ply\nformat {form} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    if form == "ascii":
        body = "".join(" ".join(map(str, row)) + "\n" for row in (*corners, *([3, *face] for face in faces))).encode()
    else:
        order = "<" if "little" in form else ">"
        body = b"".join(struct.pack(f"{order}3f", *corner) for corner in corners)
        body += b"".join(struct.pack(f"{order}B3i", 3, *face) for face in faces)
    file.write_bytes(head.encode() + body)
    return file


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_faces_of_a_ply_file(tmp_path, form):
    [hull] = mp.Mesh(file=ply(tmp_path / "m.ply", form=form)).shapes()
    assert hull.num_points == 4
    for last in (4, -1, 100, 10_000_000):
        with pytest.raises(mp.errors.FileFormatError, match=re.escape(f"a face names corner {last:g} of 4")):
            mp.Mesh(file=ply(tmp_path / "m.ply", form=form, last=last))
    whole = ply(tmp_path / "m.ply", form=form).read_bytes()
    for kept in (40, len(whole) - 8):
        (tmp_path / "m.ply").write_bytes(whole[:kept])
        with pytest.raises(mp.errors.FileFormatError, match="cut off"):
            mp.Mesh(file=tmp_path / "m.ply")


@pytest.mark.parametrize("name", ["m.ply", "package://m.ply", "file://{folder}/m.ply", "{folder}/m.ply"])
def test_faces_of_a_robots_ply_file(tmp_path, name):
    ply(tmp_path / "m.ply", last=10_000_000)
    mesh = f'<mesh filename="{name.format(folder=tmp_path)}"/>'
    (tmp_path / "arm.urdf").write_text(
        f'<robot name="a"><link name="b"/><link name="l"><collision><geometry>{mesh}</geometry></collision></link>'
        '<joint name="j" type="revolute"><parent link="b"/><child link="l"/>'
        '<limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>'
    )
    with pytest.raises(mp.errors.FileFormatError, match=r"m\.ply.*a face names corner 1e\+07 of 4"):
        mp.load_robot(tmp_path / "arm.urdf")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("shape: sphere, radius: 1.0e+308", "radius.*at most 1e\\+06"),
        ("shape: cylinder, radius: 1, length: 2.0e+6", "length.*at most 1e\\+06"),
        ("shape: box, size: [1, 1, 1.0e+308]", "size.*numbers from -1e\\+06 to 1e\\+06"),
        ("shape: plane, position: [0, 0, -1.0e+7]", "position.*numbers from -1e\\+06 to 1e\\+06"),
        (
            "shape: plane, rotation: [[1.0e+200, 0, 0], [0, 1, 0], [0, 0, 1]]",
            r"rotation.*numbers from -1e\+12",
        ),
        ("shape: mesh, triangles: [[[0, 0, 0], [1, 0, 0], [0, 1.0e+308, 0]]]", "corners within 1e\\+06 m"),
    ],
)
def test_numbers_of_obstacles_are_bounded(tmp_path, text, message):
    file = tmp_path / "scene.yaml"
    file.write_text(f"obstacles: [{{{text}}}]")
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Scene.from_yaml(file)


def test_an_obstacle_is_not_moved_beyond_the_bounds():
    far = np.eye(4)
    far[0, 3] = 6e5
    moved = mp.Sphere(radius=1.0).at(far)
    with pytest.raises(mp.errors.InvalidInputError, match="pose"):
        moved.at(far)


def test_a_mesh_is_a_file_or_triangles(tmp_path):
    file = tetrahedra(tmp_path / "one.stl", [0.0])
    for given, said in (({}, "neither"), ({"file": file, "triangles": np.zeros((1, 3, 3))}, "both")):
        with pytest.raises(mp.errors.InvalidInputError, match=f"{said} of file and triangles"):
            mp.Mesh(**given)
    for triangles in (np.zeros((0, 3, 3)), np.zeros((2, 3, 3)), np.zeros((2, 3)), [[["a"] * 3] * 3]):
        with pytest.raises(mp.errors.InvalidInputError, match="triangles"):
            mp.Mesh(triangles=triangles)


def test_a_moved_obstacle_is_frozen():
    moved = mp.Box(size=(1, 1, 1)).at(np.eye(4))
    for array in (moved.position, moved.rotation):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


def test_angles_of_obstacles_are_no_degrees():
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"rotation.*up to 25.13 rad; for degrees np.deg2rad\(\[0.0, 0.0, 90.0\]\)"
    ):
        mp.Box(size=(1, 1, 1), rotation=(0, 0, 90))
    assert mp.Box(size=(1, 1, 1), rotation=(0, 0, 4 * np.pi)).pose.isApprox(mp.Box(size=(1, 1, 1)).pose)
