"""Clouds of points: their balls against a search tree of SciPy, depth images, files and their faults."""

import io
import json
import pickle
import struct
import zlib

import coal
import numpy as np
import pinocchio as pin
import pytest
from broken_files import count_refused
from scipy.spatial import cKDTree

import manipplan as mp
from manipplan.collision.clouds import _lzf
from manipplan.plans.archive import scene_data, scene_of
from manipplan.support.data_files import json_ready, pack_array, unpack_array

RNG = np.random.default_rng(3)
CLOUDS = {
    "one": np.array([[1.0, 2.0, 3.0]]),
    "two": np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
    "coincident": np.tile([[0.1, 0.2, 0.3]], (50, 1)),
    "collinear": np.outer(np.linspace(0, 1, 60), [1.0, 2.0, 3.0]),
    "coplanar": np.c_[RNG.random((200, 2)), np.zeros(200)],
    "grid": np.stack(np.meshgrid(*[np.arange(6) / 6.0] * 3), axis=-1).reshape(-1, 3),
    "doubled": np.tile(RNG.random((50, 3)), (2, 1)),
    "far": RNG.random((100, 3)) + 1e5,
    "many": RNG.random((5000, 3)),
}


def distance(cloud, shape, place):
    [part] = cloud.parts()
    pose = coal.Transform3s.Identity()
    pose.setTranslation(np.asarray(place, dtype=float))
    request = coal.DistanceRequest()
    request.gjk_tolerance = 1e-10
    found = coal.distance(part.shape, coal.Transform3s.Identity(), shape, pose, request, coal.DistanceResult())
    back = coal.distance(shape, pose, part.shape, coal.Transform3s.Identity(), request, coal.DistanceResult())
    assert np.isfinite(found) and found == pytest.approx(back, abs=1e-9)
    return found - part.radius


@pytest.mark.parametrize("name", CLOUDS)
def test_distances_are_those_to_balls(name, rng):
    """Also where points coincide, or are on a line or in a plane; and never larger than the true ones."""
    points = CLOUDS[name]
    cloud, tree = mp.PointCloud(points=points, radius=0.01), cKDTree(points)
    assert cloud.parts()[0].closed is False and cloud.parts()[0].radius == 0.01
    size = np.maximum(np.ptp(points, axis=0), 0.3)
    for place in points.mean(axis=0) + rng.normal(size=(80, 3)) * size:
        ball = tree.query(place)[0] - 0.05 - 0.01
        along = np.clip(points[:, 2] - place[2], -0.1, 0.1)
        rod = np.linalg.norm(points - place - np.c_[0 * along, 0 * along, along], axis=1).min() - 0.05 - 0.01
        box = np.linalg.norm(np.maximum(np.abs(points - place) - 0.05, 0.0), axis=1).min() - 0.01
        for shape, expected in ((coal.Sphere(0.05), ball), (coal.Capsule(0.05, 0.2), rod), (coal.Box(0.1, 0.1, 0.1), box)):
            if expected > 0:
                found = distance(cloud, shape, place)
                assert found == pytest.approx(expected, abs=1e-6) and found <= expected + 1e-9


def test_fewer_points_cover_all_that_was_covered(rng):
    points = rng.random((4000, 3))
    whole, thin = mp.PointCloud(points=points, radius=0.01), mp.PointCloud(points=points, radius=0.01, spacing=0.1)
    [part] = thin.parts()
    assert len(thin.kept) <= 1000 < len(whole.kept) and part.radius == pytest.approx(0.01 + np.sqrt(3) * 0.1)
    assert (cKDTree(thin.kept).query(points)[0] <= np.sqrt(3) * 0.1 + 1e-12).all()


@pytest.mark.slow
def test_a_hundred_thousand_points_survive_moves_and_pickle():
    cloud = mp.PointCloud(points=np.random.default_rng(0).random((100_000, 3)), radius=0.005)
    tree = cloud.parts()[0].shape
    assert cloud.at(np.eye(4)).parts()[0].shape is tree and cloud.called("scan").parts()[0].shape is tree
    text = pickle.dumps(cloud)
    assert len(text) < 5e6  # not the tree, of which coal writes 1.7 kB per point
    again = pickle.loads(text)
    np.testing.assert_array_equal(again.kept, cloud.kept)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"radius": 0.01}, "neither of points and file"),
        ({"points": [[0, 0, 0]], "file": "a.ply", "radius": 0.01}, "both of points and file"),
        ({"points": [[0, 0, 0]], "radius": 0.0}, "radius.*above 0"),
        ({"points": [[0, 0, 0]], "radius": 0.1, "spacing": -1}, "spacing.*at least 0"),
        ({"points": np.zeros((0, 3)), "radius": 0.1}, "at least one point"),
        ({"points": [[0, 0, np.nan]], "radius": 0.1}, "points.*finite"),
        ({"points": [[0, 0, 1e7]], "radius": 0.1}, r"points: got .*1e\+07 m"),
        ({"points": [[0, 0]], "radius": 0.1}, r"shape \(any, 3\)"),
    ],
)
def test_clouds_that_are_refused(given, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.PointCloud(**given)


def test_a_depth_image_is_where_the_camera_sees_it():
    """A plane across the view, seen by a camera that looks down at it."""
    camera = pin.SE3(np.diag([1.0, -1.0, -1.0]), np.array([0.5, 0.2, 2.0]))
    depth = np.full((4, 6), 1.5)
    depth[0, :5] = [0.0, np.nan, np.inf, -1.0, 9.0]
    fx, fy, cx, cy = 10.0, 20.0, 2.5, 1.5
    cloud = mp.PointCloud.from_depth(depth, (fx, fy, cx, cy), radius=0.01, pose=camera, farthest=5.0, name="scan")
    assert cloud.name == "scan" and len(cloud.kept) == 24 - 5
    world = cloud.kept @ cloud.pose.rotation.T + cloud.pose.translation
    rows, columns = np.divmod(np.arange(24), 6)
    expected = np.stack([0.5 + (columns - cx) / fx * 1.5, 0.2 - (rows - cy) / fy * 1.5, np.full(24, 0.5)], axis=1)
    np.testing.assert_allclose(world, expected[5:], atol=1e-12)
    matrix = [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]
    np.testing.assert_array_equal(mp.PointCloud.from_depth(depth, matrix, radius=0.01, farthest=5.0).kept, cloud.kept)


@pytest.mark.parametrize(
    ("image", "intrinsics", "options", "message"),
    [
        (np.zeros((2, 2)), (1, 1, 0, 0), {}, "image: .*no valid pixel of 4"),
        (np.ones(4), (1, 1, 0, 0), {}, "image: .*shape"),
        (np.ones((2, 2)), (0, 1, 0, 0), {}, "intrinsics"),
        (np.ones((2, 2)), (1, 1, 0), {}, "intrinsics"),
        (np.ones((2, 2)), (1, 1, np.nan, 0), {}, "intrinsics"),
        (np.ones((2, 2)), (1, 1, 0, 0), {"farthest": 0.0}, "farthest"),
        (np.ones((2, 2)), (1, 1, 0, 0), {"farthest": 0.5}, "no valid pixel"),
        (np.ones((2, 2)), (1, 1, 0, 0), {"pose": np.ones((4, 4))}, "pose"),
    ],
)
def test_depth_images_that_are_refused(image, intrinsics, options, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.PointCloud.from_depth(image, intrinsics, radius=0.01, **options)


# files

POINTS = np.array([[0.5, -1.25, 2.0], [3.0, 4.0, 5.0], [np.nan, 0.0, 0.0], [3.0, 4.0, 5.0], [3.0, 4.0, 5.5]])


def pcd(form, points=POINTS):
    """With a field before and one of three values after the coordinates."""
    k = len(points)
    head = f"# .PCD v0.7\nVERSION 0.7\nFIELDS label x y z normal\nSIZE 2 4 4 8 4\nTYPE U F F F F\nCOUNT 1 1 1 1 3\nWIDTH {k}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {k}\nDATA {form}\n"
    rows = np.zeros(k, dtype=[("l", "<u2"), ("x", "<f4"), ("y", "<f4"), ("z", "<f8"), ("n", "<f4", 3)])
    for axis, name in enumerate("xyz"):
        rows[name] = points[:, axis]
    if form == "ascii":
        body = "\n".join(f"7 {x} {y} {z} 0 0 1" for x, y, z in points).encode()
    elif form == "binary":
        body = rows.tobytes()
    else:
        columns = b"".join(np.ascontiguousarray(rows[name]).tobytes() for name in rows.dtype.names)
        packed = lzf_packed(columns)
        body = struct.pack("<II", len(packed), len(columns)) + packed
    return head.encode() + body


def lzf_packed(data):
    """A greedy packer, which refers back wherever three bytes have been seen."""
    out, at, run, seen = bytearray(), 0, bytearray(), {}

    def flush():
        while run:
            out.append(len(run[:32]) - 1)
            out.extend(run[:32])
            del run[:32]

    while at < len(data):
        start = seen.get(data[at : at + 3], -1) if at + 3 <= len(data) else -1
        if start >= 0 and at - start <= 8192:
            length = 3
            while at + length < len(data) and length < 264 and data[start + length] == data[at + length]:
                length += 1
            flush()
            back, rest = at - start - 1, length - 2
            out.append((min(rest, 7) << 5) | back >> 8)
            if rest >= 7:
                out.append(rest - 7)
            out.append(back & 255)
        else:
            length = 1
            run.append(data[at])
        for k in range(at, at + length):
            seen[data[k : k + 3]] = k
        at += length
    flush()
    return bytes(out)


def ply(form, points=POINTS):
    head = f"ply\nformat {form} 1.0\nelement vertex {len(points)}\nproperty uchar red\nproperty float x\nproperty float y\nproperty double z\nend_header\n"
    if form == "ascii":
        return (head + "\n".join(f"1 {x} {y} {z}" for x, y, z in points)).encode()
    order = "<" if "little" in form else ">"
    return head.encode() + b"".join(struct.pack(order + "Bffd", 1, *point) for point in points)


def saved(save, *arrays, **named):
    stream = io.BytesIO()
    save(stream, *arrays, **named)
    return stream.getvalue()


FILES = {
    "a.ply": ply("ascii"),
    "b.ply": ply("binary_little_endian"),
    "c.PLY": ply("binary_big_endian"),
    "d.pcd": pcd("ascii"),
    "e.pcd": pcd("binary"),
    "f.pcd": pcd("binary_compressed"),
    "g.npy": saved(np.save, POINTS),
    "h.npz": saved(np.savez_compressed, other=np.zeros(3), points=POINTS),
    "i.npz": saved(np.savez, POINTS.astype(np.float32)),
}


@pytest.mark.parametrize("name", FILES)
def test_the_same_points_in_every_format(tmp_path, name):
    """Points that are not finite are those that the sensor did not see."""
    (tmp_path / name).write_bytes(FILES[name])
    cloud = mp.PointCloud.from_file(tmp_path / name, radius=0.02, position=(1, 0, 0), name="scan")
    np.testing.assert_array_equal(cloud.kept, POINTS[[0, 1, 3, 4]])
    assert cloud.parts()[0].radius == 0.02 and cloud.name == "scan" and cloud.pose.translation[0] == 1.0


def test_long_runs_are_unpacked(rng):
    for data in (bytes(100_000), rng.integers(0, 256, 5000, dtype=np.uint8).tobytes(), b"abc" * 400 + b"x"):
        assert _lzf(lzf_packed(data), len(data)) == data


@pytest.mark.parametrize(
    ("name", "data", "message"),
    [
        ("m.ply", ply("ascii")[:-8], "cut off"),
        ("m.ply", ply("binary_little_endian")[:-8], "cut off"),
        ("m.ply", ply("ascii").replace(b"float y", b"float v"), "lack x, y or z"),
        ("m.ply", ply("ascii", POINTS[2:3]), "at least one finite point"),
        ("m.pcd", b"VERSION 0.7\n", "no DATA line"),
        ("m.pcd", pcd("ascii")[:-8], "numbers instead of 35"),
        ("m.pcd", pcd("binary")[:-8], "bytes"),
        ("m.pcd", pcd("binary_compressed")[:-8], "bytes"),
        ("m.pcd", pcd("binary").replace(b"POINTS 5", b"POINTS 5000000000000"), "5000000000000 points are not"),
        ("m.pcd", pcd("binary").replace(b"FIELDS label x", b"FIELDS label w"), "its fields are label w"),
        ("m.pcd", pcd("binary").replace(b"TYPE U F", b"TYPE U Q"), "PCD"),
        ("m.pcd", pcd("binary").replace(b"SIZE 2 4", b"SIZE 2"), "PCD"),
        ("m.pcd", pcd("binary").replace(b"z normal", b"z"), "differ in length"),
        ("m.pcd", pcd("binary").replace(b"HEIGHT 1", b"HEIGHT 2"), "not its width times its height"),
        ("m.pcd", pcd("binary").replace(b"WIDTH 5", b"WIDTH -5").replace(b"HEIGHT 1", b"HEIGHT -1"), "width times its height"),
        ("m.pcd", pcd("binary").replace(b"WIDTH 5", b"WIDTH 4").replace(b"POINTS 5", b"POINTS 4"), "bytes of"),
        ("m.pcd", pcd("binary").replace(b"COUNT 1 1 1 1 3", b"COUNT 1 0 1 1 3"), "need COUNT 1"),
        ("m.pcd", pcd("binary_compressed").replace(b"COUNT 1 1 1 1 3", b"COUNT 1 1 2 1 3"), "need COUNT 1"),
        ("m.pcd", pcd("binary").replace(b"DATA binary", b"DATA other!"), "other!"),
        ("m.npy", saved(np.save, np.zeros((3, 2))), r"shape \(3, 2\)"),
        ("m.npy", saved(np.save, np.array([None] * 3)), "NPY"),
        ("m.npy", saved(np.save, POINTS)[:-8], "NPY"),
        ("m.npz", saved(np.savez, a=POINTS, b=POINTS), "has to be called points"),
        ("m.npz", saved(np.savez, POINTS)[:-30], "NPZ"),
        ("m.npy", saved(np.save, np.zeros((0, 3))), "NPY|at least one finite point"),
        ("m.xyz", b"0 0 0", r"ends with \.ply, \.pcd"),
    ],
)
def test_files_that_are_refused(tmp_path, name, data, message):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.PointCloud(file=tmp_path / name, radius=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_broken_files_raise_one_error_or_are_read(tmp_path, name):
    """Nothing but FileFormatError, and no crash."""
    assert 0 < count_refused(tmp_path / name, FILES[name], lambda file: mp.PointCloud(file=file, radius=0.01)) < 150


# scenes


def test_scene_files_hold_clouds(tmp_path, rng):
    (tmp_path / "scan.ply").write_bytes(FILES["b.ply"])
    many = rng.random((3000, 3))
    scene = mp.Scene(
        [
            mp.PointCloud(file=tmp_path / "scan.ply", radius=0.02, position=(1, 2, 3)),
            mp.PointCloud(points=[[0, 0, 1]], radius=0.02, spacing=0.01, name="few"),
            mp.PointCloud(points=many, radius=0.02),
        ]
    )
    scene.to_yaml(tmp_path / "cell.yaml")
    assert len((tmp_path / "cell.yaml").read_text()) < 1000 and (tmp_path / "cell.cloud2.npy").is_file()
    again = mp.Scene.from_yaml(tmp_path / "cell.yaml")
    assert again.names == ("cloud0", "few", "cloud2")
    for first, second in zip(scene.obstacles, again.obstacles, strict=True):
        np.testing.assert_array_equal(first.kept, second.kept)
        assert first.parts()[0].radius == second.parts()[0].radius
    (tmp_path / "cell.yaml").write_text("obstacles: [{shape: cloud, file: scan.ply}]")
    with pytest.raises(mp.errors.InvalidInputError, match=r"obstacles\[0\] \(cloud\).*radius"):
        mp.Scene.from_yaml(tmp_path / "cell.yaml")


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_plans_store_points_in_little_space(tmp_path, kind):
    points = np.random.default_rng(0).random((10_000, 3)).astype(kind)
    scene = mp.Scene(
        [mp.PointCloud(points=points, radius=0.01), mp.Mesh(triangles=points[:9999].reshape(-1, 3, 3).astype(float))]
    )
    text = json.dumps(json_ready(scene_data(scene, tmp_path)))
    assert len(text) < 2 * 16 * 4 / 3 * 10_000 * (1 if kind is np.float32 else 2)
    again = scene_of(tmp_path / "plan.json", json.loads(text), tmp_path, None)
    np.testing.assert_array_equal(again.obstacles[0].kept, scene.obstacles[0].kept)
    np.testing.assert_array_equal(again.obstacles[1].triangles, scene.obstacles[1].triangles)


def test_packed_numbers_that_are_refused():
    good = pack_array(np.arange(6.0).reshape(2, 3))
    np.testing.assert_array_equal(unpack_array(good), np.arange(6.0).reshape(2, 3))
    bomb = pack_array(np.zeros((1000, 1000)))
    wrong = [
        {**good, "shape": [2, 4]},
        {**good, "shape": [1, 3]},
        {**good, "shape": [-2, -3]},
        {**good, "type": "O"},
        {**good, "packed": "!"},
        {**good, "packed": "aaaa"},
        {**bomb, "shape": [2, 3]},
    ]
    for data in wrong:
        with pytest.raises((ValueError, zlib.error), match="packed|base64|alphabet|padding"):
            unpack_array(data)


@pytest.mark.slow
def test_pictures_hold_few_of_many_points(tmp_path):
    import matplotlib

    matplotlib.use("Agg")
    from manipplan.viz.shapes import CUBES, TRIANGLES, obstacle_surfaces

    points = np.random.default_rng(0).random((20_000, 3))
    ball = np.array(__import__("trimesh").creation.torus(1.0, 0.3, 200, 100).triangles)
    scene = mp.Scene([mp.PointCloud(points=points, radius=0.01, position=(1, 0, 0)), mp.Mesh(triangles=ball)])
    (_, cloud), (_, mesh) = obstacle_surfaces(scene)
    assert len(cloud.faces) == 6 * CUBES and len(mesh.faces) <= TRIANGLES
    np.testing.assert_allclose([cloud.points.min(axis=0), cloud.points.max(axis=0)], [[1, 0, 0], [2, 1, 1]], atol=0.03)
    np.testing.assert_allclose(mesh.points.max(axis=0), [1.3, 1.3, 0.3], atol=0.05)
    assert np.linalg.norm(mesh.points[:, :2], axis=1).min() > 0.6  # the hole stays
