"""Films of plans, the renderer behind them, and the colours of meshes."""

import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from scipy.spatial import cKDTree

import manipplan as mp
from manipplan import viz
from manipplan.collision.world import mesh_triangles
from manipplan.robots.mesh_scenes import read_collada, read_coloured
from manipplan.viz import render, style
from manipplan.viz.shapes import faces_of
from manipplan.viz.viewer.bodies import appearance_of, visual_geometry


@pytest.fixture(scope="module")
def reach_plan():
    robot = mp.load_robot("panda")
    post = mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post")
    return mp.plan(robot, [-0.6, 0.3, 0.0, -2.0, 0.0, 2.3, 0.8], [0.9, 0.2, -0.2, -2.1, 0.3, 2.2, 0.8], mp.Scene([post]))


@pytest.fixture(scope="module")
def planar_plan():
    return mp.plan(mp.planar_arm([1.0, 1.0, 1.0]), [0.0, 1.5, -2.0], [0.5, 1.2, -1.5])


def pixel(points, lookat, distance, wide):
    """Where a camera with the renderer's angles sees points (k, 3), from -1 to 1 across and along; and their depths (k,) [m]."""
    azimuth, elevation = np.deg2rad([render.AZIMUTH, render.ELEVATION])
    turn = pin.rpy.rpyToMatrix(0.0, -elevation, azimuth)  # x looks ahead
    ahead, left, up = ((points - lookat) @ turn).T
    depth, slope = distance + ahead, np.tan(np.deg2rad(render.FIELD) / 2)
    return np.stack([-left / depth / slope / wide, up / depth / slope], axis=1), depth


@settings(deadline=None)
@given(st.integers(0, 10**6), st.floats(0.3, 3.0))
def test_the_camera_sees_all_points_and_no_more_than_it_needs(seed, wide):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(rng.integers(2, 20), 3)) * rng.uniform(0.05, 2.0, 3) + rng.normal(size=3)
    lookat, distance = render._fit(points, wide)
    seen, depth = pixel(points, lookat, distance, wide)
    assert depth.min() >= render.NEAREST - 1e-9
    assert np.abs(seen).max() <= render.FILLED + 1e-9
    if depth.min() > render.NEAREST + 1e-9:
        assert np.abs(seen).max() == pytest.approx(render.FILLED, abs=1e-6)


@pytest.mark.slow
def test_a_box_is_drawn_where_it_is():
    robot = mp.load_robot("panda")
    box = mp.Box(size=(0.06, 0.06, 0.06), position=(0.3, -0.5, 0.8))
    shown = np.array([[0.0, 0.0, 0.0], [0.4, 0.4, 1.0]])
    size = (300, 200)
    points = np.concatenate([shown, box.pose.translation + 0.03 * np.array(np.meshgrid(*[(-1, 1)] * 3)).reshape(3, -1).T])
    with render.Renderer(robot, mp.Scene([box]), shown, size) as renderer:
        picture = renderer.draw(robot.neutral).astype(float)
    red, green, blue = np.moveaxis(picture, 2, 0)
    rows, columns = np.nonzero((red > 1.3 * green) & (blue > 1.2 * green))  # the arm and the background are grey
    [[x, y]], _ = pixel(box.pose.translation[None], *render._fit(points, 1.5), 1.5)
    assert len(rows) > 50
    assert columns.mean() == pytest.approx((1 + x) / 2 * size[0], abs=2.0)
    assert rows.mean() == pytest.approx((1 - y) / 2 * size[1], abs=2.0)


@pytest.mark.slow
def test_a_film_has_its_frames_and_a_dark_one_is_dark(reach_plan, tmp_path):
    done = []
    viz.film(reach_plan, tmp_path / "film.webp", width=300, fps=3, speed=1.0, progress=lambda share, _: done.append(share))
    with Image.open(tmp_path / "film.webp") as film:
        assert film.n_frames == np.ceil(3 * reach_plan.trajectory.duration - 1e-9) + 1
        assert film.size[0] == 300
        film.seek(film.n_frames - 1)
        last = np.asarray(film.convert("RGB")).astype(int)
    assert done[-1] == 1.0 and done == sorted(done)
    viz.film(reach_plan, tmp_path / "film.png", width=300, dark=True)
    dark = np.asarray(Image.open(tmp_path / "film.png").convert("RGB")).astype(int)
    assert dark.shape == last.shape
    assert np.median(last) > 200 and np.median(dark) < 60
    for colour in (style.SEED, style.OPTIMUM):  # both have their mark
        assert (np.abs(dark - 255 * np.array(style.rgb(colour))).max(axis=2) < 12).sum() > 30


@pytest.mark.slow
def test_a_plan_that_stays_where_it_is_is_filmed_too(tmp_path):
    robot = mp.load_robot("ur5")
    q = [0.3, -1.2, 1.4, -1.5, -1.3, 0.2]
    plan = mp.plan(robot, q, q)
    viz.film(plan, tmp_path / "film.gif", width=300, fps=2)
    with Image.open(tmp_path / "film.gif") as film:
        assert film.size[0] == 300


@pytest.mark.slow
def test_what_cannot_be_filmed_is_said_before_anything_is_rendered(reach_plan, planar_plan, tmp_path, monkeypatch):
    for change in ({"width": 100}, {"fps": 0}, {"speed": -1}, {"colours": 1}, {"quality": 101}, {"dark": 1}, {"progress": 3}):
        with pytest.raises(mp.errors.InvalidInputError, match=next(iter(change))):
            viz.film(reach_plan, tmp_path / "film.webp", **change)
    with pytest.raises(mp.errors.InvalidInputError, match=r"\.webp, \.gif or \.png"):
        viz.film(reach_plan, tmp_path / "film.mp4")
    with pytest.raises(mp.errors.InvalidInputError, match=r"viz\.animate draws planar arms"):
        viz.film(planar_plan, tmp_path / "film.webp")
    with pytest.raises(mp.errors.PlanningError, match="no trajectory"):
        viz.film(
            mp.results.PartialPlan(robot=planar_plan.robot, scene=planar_plan.scene, status=mp.Status.NO_PATH),
            tmp_path / "film.webp",
        )
    monkeypatch.setattr("manipplan.viz.films.find_spec", lambda name: None)
    with pytest.raises(mp.errors.MissingExtraError, match=r"manipplan\[film\]"):
        viz.film(reach_plan, tmp_path / "film.webp")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_meshes_have_the_colours_of_their_files():
    bodies = appearance_of(mp.load_robot("panda")).bodies
    named = {body.name for body in bodies}
    assert len(bodies) > len(named)
    assert {tuple(np.round(body.colour[:3], 2)) for body in bodies} >= {(1.0, 1.0, 1.0), (0.25, 0.25, 0.25)}
    robot = mp.load_robot("panda")
    for item in robot.geometry.geometryObjects:  # the collision hulls lie about the visual meshes
        own = [body.vertices for body in bodies if body.name == item.name]
        if own and item.meshPath:
            seen, hull = np.concatenate(own), item.geometry.vertices() @ item.placement.rotation.T + item.placement.translation
            assert np.abs(seen.min(axis=0) - hull.min(axis=0)).max() < 0.02
            assert np.abs(seen.max(axis=0) - hull.max(axis=0)).max() < 0.02


def nearest_apart(points, others):
    return cKDTree(others).query(points)[0].max()


@pytest.mark.slow
@pytest.mark.parametrize(("robot", "body", "most"), [("baxter", "pedestal_0", 2500), ("ur5", "forearm_link_0", 1000)])
def test_a_mesh_with_fewer_triangles_has_no_part_missing(robot, body, most):
    geometry, _ = visual_geometry(mp.load_robot(robot))
    [item] = [each for each in geometry.geometryObjects if each.name == body]
    triangles = mesh_triangles(item.geometry)
    vertices, faces = faces_of(triangles, most)
    assert 0.5 * most < len(faces) <= most
    rng = np.random.default_rng(0)

    def sampled(corners, count):
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        chosen = corners[rng.choice(len(corners), count, p=areas / areas.sum())]
        return np.einsum("kc,kcx->kx", rng.dirichlet(np.ones(3), count), chosen)

    size = np.ptp(triangles.reshape(-1, 3), axis=0).max()
    whole, fewer = sampled(triangles, 40000), sampled(vertices[faces], 40000)
    assert nearest_apart(whole, fewer) < 0.05 * size
    assert nearest_apart(fewer, whole) < 0.05 * size


MESH = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema"><asset><unit meter="0.01"/></asset>
<library_effects><effect id="e1"><profile_COMMON><technique sid="c"><lambert><diffuse>{diffuse}</diffuse></lambert></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="m1"><instance_effect url="#e1"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="s" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
<triangles material="other" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m1"/></technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>"""


@pytest.mark.parametrize(
    ("diffuse", "colour"),
    [
        ("<color>0.1 0.2 0.3 1</color>", (0.1, 0.2, 0.3)),
        ('<texture texture="t" texcoord="u"/>', None),
        ("<color>2 0 0 1</color>", None),
        ("<color>0.1 0.2 0.3</color>", None),
        ("<color>nan 0 0 1</color>", None),
        ("", None),
    ],
)
def test_a_colour_that_cannot_be_read_is_none_and_costs_no_triangle(tmp_path: Path, diffuse, colour):
    file = tmp_path / "part.dae"
    file.write_text(MESH.format(diffuse=diffuse))
    ET.parse(file)
    parts = read_coloured("file", file)
    assert {own for own, _ in parts} == {colour, None}
    triangles, unit, _ = read_collada("file", file)
    assert sum(len(part) for _, part in parts) == len(triangles) == 2
    np.testing.assert_allclose(np.concatenate([part for _, part in parts]), unit * triangles)


@pytest.mark.slow
def test_without_egl_the_remedy_is_told(reach_plan, tmp_path):
    """In a process that finds no driver of EGL, as on a machine without its packages."""
    reach_plan.save(tmp_path)
    code = "import sys; from manipplan import viz, Plan; viz.film(Plan.load(sys.argv[1]), sys.argv[1] + '/film.png')"
    environment = {**os.environ, "__EGL_VENDOR_LIBRARY_DIRS": str(tmp_path / "none")}
    environment.pop("MUJOCO_GL", None)
    process = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, env=environment, check=False
    )
    assert process.returncode == 1 and not (tmp_path / "film.png").exists()
    assert re.search(
        r"ManipplanError: MuJoCo cannot render here: .*[^.]\. On Linux it needs EGL: sudo apt-get install", process.stderr
    )
