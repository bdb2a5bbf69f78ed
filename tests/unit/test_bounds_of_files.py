"""Bounds on what a file may cost, and the benchmark that measures it."""

import sys
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import file_bombs

ARM = mp.planar_arm([1.0, 1.0])
BOMBS = {f"{each.kind} {each.name}": each for each in file_bombs.bombs()}


def test_there_are_a_hundred_different_files():
    assert len(BOMBS) >= 100
    assert len({each.kind for each in BOMBS.values()}) == len(file_bombs.READERS)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        "cloud int8_1e+07.npz",
        "cloud zeros_2e+07.pcd",
        "mesh no_view_6e+07.gltf",
        "scene points_1e+06.yaml",
        "scene sexagesimal.yaml",
        "mujoco scene replicate_1x1e+06.xml",
        "urdf power.urdf.xacro",
    ],
)
def test_files_of_the_review_are_refused_within_seconds(tmp_path, name):
    found = file_bombs.main(["--only", name, "--out", str(tmp_path / "table.md")])
    assert found == []
    assert "refused" in (tmp_path / "table.md").read_text()


@pytest.mark.slow
def test_what_takes_too_much_is_seen(tmp_path, monkeypatch):
    monkeypatch.setattr(file_bombs, "STOP", 1.0)
    monkeypatch.setitem(file_bombs.READERS, "cloud", "time = __import__('time'); time.sleep(60)")
    found = file_bombs.main(["--only", "no_points.pcd", "--out", str(tmp_path / "table.md")])
    assert [text for _, text in found] == ["FAULT: not done after 1 s"]


@pytest.mark.parametrize("pairs", [0, 3, 40])
def test_compressed_points_are_unpacked_as_they_were(tmp_path, pairs):
    """References that overlap what they append, and runs, against the bytes they stand for."""
    from manipplan.collision.clouds import _lzf

    packed, plain = bytearray([2, 1, 2, 3]), bytearray([1, 2, 3])
    rng = np.random.default_rng(pairs)
    for _ in range(pairs):
        back, length = int(rng.integers(1, len(plain) + 1)), int(rng.integers(3, 200))
        for k in range(length):
            plain.append(plain[len(plain) - back])
            del k
        packed += (
            bytes([(7 << 5) | ((back - 1) >> 8), length - 9])
            if length >= 9
            else bytes([((length - 2) << 5) | ((back - 1) >> 8)])
        )
        packed += bytes([(back - 1) & 255])
    assert _lzf(bytes(packed), len(plain)) == bytes(plain)


def test_clouds_of_many_points_ask_for_a_spacing():
    points = np.random.default_rng(0).random((500_001, 3))
    with pytest.raises(mp.errors.InvalidInputError, match=r"500,001 points with a spacing of 0 m'; allowed: at most 500,000"):
        mp.PointCloud(points=points, radius=0.01)
    assert len(mp.PointCloud(points=points, radius=0.01, spacing=0.1).kept) <= 1000


@pytest.mark.slow
def test_a_face_of_many_corners_is_refused(tmp_path):
    file = tmp_path / "a.obj"
    file.write_bytes(file_bombs.obj_polygon(20_000))
    with pytest.raises(mp.errors.FileFormatError, match="20,000 corners, of at most 10,000"):
        mp.Mesh(file=file)
    file.write_bytes(file_bombs.obj_text(10_000, 40))
    with pytest.raises(mp.errors.FileFormatError, match="concave faces with more than 100,000 corners"):
        mp.Mesh(file=file)


@pytest.mark.parametrize("component", [5120, 5121, 5122, 5123, 5125])
def test_positions_of_gltf_are_floats(tmp_path, component):
    file = tmp_path / "a.gltf"
    file.write_bytes(file_bombs.gltf(3, view=True, kind=component))
    with pytest.raises(mp.errors.FileFormatError, match=f"positions of the component type {component}: only floats"):
        mp.Mesh(file=file)


def test_a_rotation_of_zeros_is_named_in_the_log(tmp_path, caplog):
    file = tmp_path / "a.scene"
    file.write_text("(noname)+\n* ball\n1\nsphere\n0.1\n1 0 0\n0 0 0 0\n0 0 0 0\n.\n")
    assert len(mp.Scene.from_moveit(file).obstacles) == 1
    assert "is 0 0 0 0, which is no rotation" in caplog.text
