"""Meshes of every format as collision meshes of a robot: each body where it was drawn, and where assimp has it."""

import sys
import tempfile
from pathlib import Path

import coal
import hypothesis.strategies as st
import numpy as np
import pytest
from examples import examples
from hypothesis import assume, given
from scipy.spatial import cKDTree

from manipplan.robots.mesh_files import read_mesh, welded
from manipplan.robots.mesh_scenes import split_polygons

pytest.importorskip("trimesh")
sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import mesh_readers


@pytest.mark.slow
@examples(50)
@given(kind=st.sampled_from(mesh_readers.FORMATS), seed=st.integers(0, 2**32))
def test_a_body_is_where_it_was_drawn(kind, seed):
    """Units, nested nodes, winding, polygons, negative indices; and the same file cut off is refused or seen to be whole."""
    with tempfile.TemporaryDirectory() as folder:
        apart, theirs, end = mesh_readers.one(np.random.default_rng(seed), Path(folder), kind)
    assert apart <= 1e-9 and not theirs > 1e-9
    assert end != "LESS"


@examples(50)
@given(kind=st.sampled_from(["text.stl", "binary.stl", "plain.obj", "text.ply", "nodes.dae"]), seed=st.integers(0, 2**32))
def test_assimp_has_the_body_there_too(kind, seed):
    """It has 32 bits, and applies no unit."""
    rng = np.random.default_rng(seed)
    drawing = mesh_readers.draw(rng)
    assume(max(map(len, drawing.faces)) < 300)  # its lines end after 4,096 characters
    data, _ = mesh_readers.write(rng, kind, drawing)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"m.{kind[-3:]}"
        file.write_bytes(data)
        corners, _ = welded(read_mesh("file", file).triangles)
        theirs = np.array(coal.MeshLoader().load(str(file), np.ones(3)).vertices())
    size = np.abs(corners).max()
    assert cKDTree(theirs).query(corners)[0].max() < 1e-5 * size
    assert cKDTree(corners).query(theirs)[0].max() < 1e-5 * size


@examples(100)
@given(sides=st.integers(4, 60), seed=st.integers(0, 2**32))
def test_concave_polygons_are_split_within_themselves(sides, seed):
    """Also with points on a line and corners that occur twice: the triangles have the polygon's area, wound as it is."""
    rng = np.random.default_rng(seed)
    angles = 2 * np.pi * (np.arange(sides) + rng.uniform(-0.4, 0.4, sides)) / sides
    ring = rng.uniform(0.2, 1.0, sides)[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    middles = (ring + np.roll(ring, -1, axis=0)) / 2
    flat = np.stack([ring, middles], axis=1).reshape(-1, 2) if rng.random() < 0.5 else ring
    turned = np.c_[flat, np.zeros(len(flat))] @ np.linalg.qr(rng.normal(size=(3, 3)))[0].T
    triangles = split_polygons(turned, [list(range(len(flat)))])
    vectors = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) / 2
    expected = np.cross(turned, np.roll(turned, -1, axis=0)).sum(axis=0) / 2
    np.testing.assert_allclose(vectors.sum(axis=0), expected, atol=1e-12)
    assert np.linalg.norm(vectors, axis=1).sum() == pytest.approx(np.linalg.norm(expected), abs=1e-9)
    assert len(triangles) == len(flat) - 2


@pytest.mark.parametrize("sides", [300, pytest.param(5000, marks=pytest.mark.slow)])
def test_a_spiral_of_many_corners(sides):
    """The ears of 300 corners took 38 s."""
    turn = np.linspace(0, 12 * np.pi, sides // 2)
    outer, inner = (np.c_[np.cos(turn), np.sin(turn), 0 * turn] * (width + turn)[:, None] for width in (1.0, 1.3))
    polygon = np.r_[inner[::-1], outer]
    triangles = split_polygons(polygon, [list(range(len(polygon)))])
    vectors = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) / 2
    area = np.linalg.norm(np.cross(polygon, np.roll(polygon, -1, axis=0)).sum(axis=0)) / 2
    assert np.linalg.norm(vectors, axis=1).sum() == pytest.approx(area, rel=1e-9)
