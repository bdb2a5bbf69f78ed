"""Pictures: what is drawn is what the data say; files are read back with programs that are not ours."""

import shutil
import subprocess
import sys
from dataclasses import replace
from xml.etree import ElementTree

import coal
import matplotlib.pyplot as plt
import numpy as np
import pinocchio as pin
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image

import manipplan as mp
from manipplan import viz
from manipplan.search.refine import Refinement
from manipplan.viz import style
from manipplan.viz.arm import draw_surface
from manipplan.viz.shapes import arm_surfaces, obstacle_surfaces, plane_patches, surface_of

CUBE = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(autouse=True)
def no_figures_left():
    yield
    plt.close("all")


@pytest.fixture
def flat():
    return Figure().add_subplot()


@pytest.fixture
def space():
    return Figure().add_subplot(projection="3d")


@pytest.fixture(scope="module")
def planar_plan(planar):
    ball = mp.Sphere(radius=0.2, position=(0.5, -0.9, 0.0), name="ball")
    return mp.plan(planar, [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0], mp.Scene([ball]), objective=mp.PathObjective(power=2.0))


@pytest.fixture(scope="module")
def tracked(planar):
    start = np.array([0.4, 0.8, -0.6])
    pose = planar.kinematics().pose(start)
    end = pose.copy()
    end[:3, 3] += (-0.3, 0.4, 0.0)
    tube = mp.Tolerance(position=0.02)
    path = mp.CartesianPath.line(pose, end)
    return mp.track(planar, path, start, mp.formulations.LogDrive(), dt=0.01, duration=1.0, tolerance=tube), path


def every_obstacle(tmp_path):
    corner = np.array([[0, 0, 0], [0.3, 0, 0], [0, 0.2, 0], [0, 0, 0.4]])
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    lines = [f"v {x} {y} {z}" for x, y, z in corner] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    (tmp_path / "wedge.obj").write_text("\n".join(lines) + "\n")
    placed = {"position": (0.4, -0.3, 0.5), "rotation": (0.3, -0.5, 0.9)}
    return mp.Scene(
        [
            mp.Box(size=(0.3, 0.2, 0.1), name="box", **placed),
            mp.Sphere(radius=0.15, name="ball", **placed),
            mp.Capsule(radius=0.1, length=0.4, name="capsule", **placed),
            mp.Cylinder(radius=0.1, length=0.4, name="post", **placed),
            mp.Mesh(file=tmp_path / "wedge.obj", name="wedge", **placed),
        ]
    )


def dashed(ax):
    return sorted(line.get_ydata()[0] for line in ax.lines if len(line.get_ydata()) == 2)


@pytest.mark.parametrize(("order", "limit"), [(0, None), (1, "velocity"), (2, "acceleration"), (3, "jerk")])
def test_joint_curves_are_the_trajectory_and_the_dashes_its_limits(demo_plan, flat, order, limit):
    limits = demo_plan.robot.limits
    assert viz.plot_joints(demo_plan.trajectory, limits, order=order, ax=flat) is flat
    curves = [line for line in flat.lines if len(line.get_xdata()) > 2]
    t = curves[0].get_xdata()
    np.testing.assert_array_equal([line.get_ydata() for line in curves], demo_plan.trajectory(t, order).T)
    assert [line.get_label() for line in curves] == list(demo_plan.robot.joint_names)
    bounds = [limits.lower, limits.upper] if limit is None else [-getattr(limits, limit), getattr(limits, limit)]
    np.testing.assert_allclose(dashed(flat), np.sort(np.ravel(bounds)))


def test_joints_as_share_of_their_range(demo_plan, flat, planar_plan):
    limits = demo_plan.robot.limits
    viz.plot_joints(demo_plan.trajectory, limits, share=True, ax=flat)
    t = flat.lines[0].get_xdata()
    shares = (demo_plan.trajectory(t) - limits.lower) / (limits.upper - limits.lower)
    np.testing.assert_allclose([line.get_ydata() for line in flat.lines], shares.T)
    with pytest.raises(mp.errors.InvalidInputError, match="share"):
        viz.plot_joints(planar_plan.trajectory, planar_plan.robot.limits, share=True)
    with pytest.raises(mp.errors.InvalidInputError, match="limits of 7 joints"):
        viz.plot_joints(demo_plan.trajectory, planar_plan.robot.limits)
    with pytest.raises(mp.errors.InvalidInputError, match="order"):
        viz.plot_joints(demo_plan.trajectory, order=4)


def test_manipulability_over_the_length_with_its_least_and_a_bound(demo_plan, flat):
    kinematics = demo_plan.robot.kinematics()
    viz.plot_manipulability(kinematics, {"ours": demo_plan.path, "again": demo_plan.trajectory}, bound=0.02, ax=flat)
    ours, dot = flat.lines[:2]
    s = np.linspace(0.0, 1.0, len(ours.get_xdata()))
    np.testing.assert_allclose(ours.get_ydata(), kinematics.manipulability(demo_plan.path(s)))
    assert dot.get_ydata()[0] == pytest.approx(demo_plan.result.min_manipulability, rel=1e-4)
    half = demo_plan.path(np.linspace(0.0, 0.5, 20001))
    share = np.linalg.norm(np.diff(half, axis=0), axis=1).sum() / demo_plan.path.length
    assert ours.get_xdata()[len(s) // 2] == pytest.approx(share, abs=1e-5)
    assert 0.02 in dashed(flat)
    assert "yoshikawa [m⁶]" in flat.get_ylabel()
    assert [text.get_text() for text in flat.get_legend().get_texts()][-2:] == ["straight", "bound"]
    with pytest.raises(mp.errors.InvalidInputError, match="paths"):
        viz.plot_manipulability(kinematics, {}, ax=flat)
    with pytest.raises(mp.errors.InvalidInputError, match="7 joints"):
        viz.plot_manipulability(kinematics, {"other": mp.JointPath.line([0.0], [1.0])}, ax=flat)


def test_equal_curves_are_drawn_once(planar, flat):
    line = mp.JointPath.line([0.1, 0.5, 0.5], [1.0, 1.0, 1.0])
    viz.plot_manipulability(planar.kinematics(), {"seed": line}, ax=flat)
    assert [text.get_text() for text in flat.get_legend().get_texts()] == ["seed, straight"]


def test_singular_values_are_those_of_pinocchios_jacobian(demo_plan, flat):
    robot, length = demo_plan.robot, 0.3
    viz.plot_singular_values(robot.kinematics(mp.Task.pose(length=length)), demo_plan.path, ax=flat)
    curves = [line.get_ydata() for line in flat.lines if len(line.get_xdata()) > 2]
    assert len(curves) == 6
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    for k in (0, 300, 800):
        q = demo_plan.path(k / 800)
        jacobian = pin.computeFrameJacobian(robot.model, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
        values = np.linalg.svd(np.diag([1, 1, 1, length, length, length]) @ jacobian, compute_uv=False)
        np.testing.assert_allclose([curve[k] for curve in curves], values, atol=1e-9)


def test_ellipses_along_a_path_have_the_axes_of_the_svd(planar, flat):
    path = mp.JointPath.line([0.2, 0.7, 0.6], [1.0, 1.2, -0.9])
    viz.plot_ellipsoids(planar.kinematics(), path, 5, scale=0.1, ax=flat)
    assert len(flat.patches) == 5
    for place, patch in zip(np.linspace(0, 1, 5), flat.patches, strict=True):
        q = path(place)
        tool = np.cumsum(np.stack([np.cos(np.cumsum(q)), np.sin(np.cumsum(q))], axis=1), axis=0)[-1]
        u, sigma, _ = np.linalg.svd(planar.kinematics().jacobian(q))
        local = (patch.get_path().vertices[:-1] - tool) @ u / (0.1 * sigma)
        np.testing.assert_allclose(np.linalg.norm(local, axis=1), 1.0)


def test_ellipsoids_of_a_pose_task_are_those_of_the_linear_velocity(demo_plan, space):
    viz.plot_ellipsoids(demo_plan.robot.kinematics(), demo_plan.path, ax=space)
    assert len(space.collections) == 7
    q = demo_plan.path(0.0)
    kinematics = demo_plan.robot.kinematics(mp.Task.position())
    form = np.linalg.inv(kinematics.jacobian(q) @ kinematics.jacobian(q).T)
    out = space.collections[0]._faces.reshape(-1, 3) - kinematics.pose(q)[:3, 3]
    size = np.einsum("ki,ij,kj->k", out, form, out)
    np.testing.assert_allclose(size, size[0], rtol=1e-9)


def test_drawn_obstacles_lie_on_the_obstacles(tmp_path):
    """By coal's distance of a tiny ball at each corner; and they reach as far as the shape does."""
    scene = every_obstacle(tmp_path)
    drawn = dict(obstacle_surfaces(scene))
    assert list(drawn) == list(scene.names)
    probe = coal.Sphere(1e-9)
    for name, obstacle in zip(scene.names, scene.obstacles, strict=True):
        [shape] = obstacle.shapes()
        pose = coal.Transform3s(obstacle.pose.rotation, obstacle.pose.translation)
        for point in [*drawn[name].points[::7], *np.concatenate(drawn[name].edges)[::3]]:
            result = coal.DistanceResult()
            at = coal.Transform3s(np.eye(3), point)
            distance = coal.distance(shape, pose, probe, at, coal.DistanceRequest(), result)
            assert abs(distance) < 2e-6, name
        shape.computeLocalAABB()
        local = (drawn[name].points - obstacle.pose.translation) @ obstacle.pose.rotation
        np.testing.assert_allclose(local.max(axis=0), shape.aabb_local.max_, atol=2e-3)
        np.testing.assert_allclose(local.min(axis=0), shape.aabb_local.min_, atol=2e-3)


def test_flat_ends_are_closed_and_other_shapes_boxed():
    cylinder = surface_of(coal.Cylinder(0.1, 0.4))
    flat = [face for face in cylinder.faces if np.ptp(face[:, 2]) < 1e-12]
    assert sorted(face[0, 2] for face in flat) == [-0.2, 0.2]
    np.testing.assert_allclose(np.linalg.norm(flat[0][:, :2], axis=1), 0.1)
    ellipsoid = surface_of(coal.Ellipsoid(0.1, 0.2, 0.3)).points / (0.1, 0.2, 0.3)
    np.testing.assert_allclose(np.linalg.norm(ellipsoid, axis=1), 1.0)
    assert surface_of(coal.Cone(0.1, 0.4)).points[:, 2].max() == 0.2
    field = coal.HeightFieldAABB(0.2, 0.4, np.array([[0.1, 0.2], [0.1, 0.3]]), 0.0)
    assert len(np.unique(surface_of(field).points.round(9), axis=0)) == 8


def test_a_flat_mesh_is_drawn_by_its_triangles():
    corners = np.array([[0.0, 0.0, 0.1], [1.0, 0.0, 0.1], [0.0, 1.0, 0.1], [1.0, 1.0, 0.1]])
    vertices, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    vertices.extend(list(corners))
    triangles.extend([coal.Triangle(0, 1, 2), coal.Triangle(1, 3, 2)])
    mesh = coal.BVHModelOBBRSS()
    mesh.beginModel(2, 4)
    mesh.addSubModel(vertices, triangles)
    mesh.endModel()
    surface = surface_of(mesh)
    np.testing.assert_array_equal(surface.faces, [corners[[0, 1, 2]], corners[[1, 3, 2]]])


def test_planes_are_cut_to_the_picture():
    tilted = mp.Plane(name="ramp", position=(0.0, 0.0, 0.1), rotation=(0.4, 0.2, 0.0))
    scene = mp.Scene([tilted, mp.Plane(name="far", position=(0.0, 0.0, -9.0))])
    [(name, patch)] = plane_patches(scene, np.full(3, -1.0), np.full(3, 1.0))
    assert name == "ramp"
    np.testing.assert_allclose((patch - tilted.position) @ tilted.pose.rotation[:, 2], 0.0, atol=1e-12)
    assert np.abs(patch).max() <= 1 + 1e-12
    turn = np.cross(np.roll(patch, -1, axis=0) - patch, np.roll(patch, -2, axis=0) - np.roll(patch, -1, axis=0))
    assert (turn @ turn[0] > 0).all()  # convex: the corners are in order


def test_drawn_links_are_corners_of_the_meshes_where_pinocchio_has_them(demo_plan):
    robot = demo_plan.robot
    q = demo_plan.path(0.4)
    data, geometry = robot.model.createData(), pin.GeometryData(robot.geometry)
    pin.updateGeometryPlacements(robot.model, data, robot.geometry, geometry, q)
    drawn = arm_surfaces(robot, q)
    assert len(drawn) == len(robot.geometry.geometryObjects)
    for surface, each, pose in zip(drawn, robot.geometry.geometryObjects, geometry.oMg, strict=True):
        local = each.geometry.vertices() if hasattr(each.geometry, "vertices") else CUBE * each.geometry.halfSide
        corners = np.array(local) @ pose.rotation.T + pose.translation
        apart = np.linalg.norm(surface.points[:, None] - corners[None], axis=2).min(axis=1)
        assert apart.max() < 1e-12
        assert np.ptp(surface.points, axis=0) == pytest.approx(np.ptp(corners, axis=0), rel=0.15, abs=0.01)


def test_the_arm_stands_among_named_obstacles(demo_plan, space):
    ax = viz.plot_arm(demo_plan.robot, demo_plan.path, demo_plan.scene, seed=demo_plan.result.seed, ax=space)
    assert {"start", "goal", *demo_plan.scene.names} == {text.get_text() for text in ax.texts}
    legend = [text.get_text() for text in ax.get_legend().get_texts()]
    assert legend == ["tool, path", "tool, seed"]
    pose = demo_plan.robot.kinematics().pose
    for name, path in (("tool, path", demo_plan.path), ("tool, seed", demo_plan.result.seed)):
        [way] = [line for line in ax.lines if line.get_label() == name]
        x, y, z = way.get_data_3d()
        np.testing.assert_allclose([x[-1], y[-1], z[-1]], pose(path.goal)[:3, 3], atol=1e-12)
    box = ax.get_w_lims()
    assert np.allclose(ax._box_aspect / np.ptp(np.reshape(box, (3, 2)), axis=1), ax._box_aspect[0] / (box[1] - box[0]))


def test_a_way_that_returns_is_named_once(planar, flat):
    there = np.array([[0.2, 0.7, 0.6], [1.0, 1.2, -0.9], [0.2, 0.7, 0.6]])
    viz.plot_arm(planar, mp.JointPath.through(there), ax=flat)
    assert [text.get_text() for text in flat.texts] == ["start and goal"]


def test_a_cloud_is_drawn_and_named(panda, space, rng):
    """Its balls have no edges to draw."""
    cloud = mp.PointCloud(points=rng.uniform(size=(50, 3)), radius=0.02, name="scan")
    viz.plot_arm(panda, mp.JointPath.line(panda.neutral, panda.neutral + 0.1), mp.Scene([cloud]), ax=space)
    assert "scan" in [text.get_text() for text in space.texts]
    assert max(len(each.get_facecolor()) for each in space.collections) >= 6 * 50


def test_the_planar_arm_among_what_is_around_it(planar_plan, flat):
    wall = mp.Plane(name="wall", position=(-2.2, 0.0, 0.0), rotation=(0.0, np.pi / 2, 0.0))
    turned = mp.Box(size=(0.4, 0.2, 1.0), position=(2.0, 2.0, 0.0), rotation=(0.0, 0.0, 0.5), name="block")
    scene = mp.Scene([*planar_plan.scene.obstacles, wall, turned])
    viz.plot_arm(planar_plan.robot, planar_plan.path, scene, ax=flat)
    assert {"start", "goal", "ball", "wall", "block"} == {text.get_text() for text in flat.texts}
    ball, block = (patch.get_path().vertices[:-1] for patch in flat.patches[:2])
    assert np.linalg.norm(ball - (0.5, -0.9), axis=1).max() == pytest.approx(0.2)
    turn = np.array([[np.cos(0.5), -np.sin(0.5)], [np.sin(0.5), np.cos(0.5)]])
    np.testing.assert_allclose(np.sort(np.abs((block - (2.0, 2.0)) @ turn), axis=0), [[0.2, 0.1]] * 4)
    side = flat.patches[2]
    assert side.get_path().vertices[:, 0].max() == pytest.approx(-2.2)
    flat.figure.draw_without_rendering()
    assert flat.get_xlim()[0] < -2.2
    with pytest.raises(mp.errors.InvalidInputError, match="3d"):
        viz.plot_arm(mp.load_robot("panda"), mp.JointPath.line(np.zeros(7), np.ones(7)), ax=flat)


def test_tool_path_beside_what_it_follows(tracked, planar, demo_plan, space, flat):
    tracking, path = tracked
    viz.plot_tool_path(planar, tracking, path, ax=flat)
    wanted, way = flat.lines
    np.testing.assert_allclose(wanted.get_xydata()[[0, -1]], path([0.0, 1.0])[:, :2, 3])
    distance = (way.get_xydata() - wanted.get_xydata()[0]) @ (0.8, 0.6)  # across the line of (-0.3, 0.4)
    assert np.abs(distance).max() < 0.0205
    viz.plot_tool_path(demo_plan.robot, demo_plan.trajectory, ax=space)
    assert len(space.lines) == 1 + 9 + 1
    with pytest.raises(mp.errors.InvalidInputError, match="CartesianPath"):
        viz.plot_tool_path(planar, tracking, 3)


def test_deviation_over_time_with_its_tolerance(tracked, flat):
    tracking, _ = tracked
    viz.plot_deviation(tracking, tolerance=mp.Tolerance(position=0.02), ax=flat)
    np.testing.assert_array_equal(flat.lines[0].get_ydata(), 1e3 * tracking.deviation)
    np.testing.assert_array_equal(flat.lines[0].get_xdata(), tracking.t)
    assert dashed(flat) == [20.0]


@pytest.mark.slow
def test_deviation_of_a_followed_path_by_brute_force(demo_plan):
    """From a workspace path beside the way of the tool, in millimetres and degrees."""
    poses = demo_plan.robot.kinematics().pose(demo_plan.path(np.linspace(0.0, 1.0, 30)))
    poses[:, 2, 3] += 0.004
    path = mp.CartesianPath.through(list(poses))
    plan = replace(demo_plan, workspace_path=path, tolerance=mp.Tolerance(position=0.005, rotation=0.1))
    ax = viz.plot_deviation(plan)
    position, rotation = (axes.lines[0].get_ydata() for axes in ax.figure.axes)
    fine = path.sample(20_001)
    times = np.linspace(0.0, demo_plan.trajectory.duration, len(position))
    piece = 10 * np.linalg.norm(np.diff(fine[:, :3, 3], axis=0), axis=1).max()  # of the 2000 that a pose is compared with
    for k in (0, 250, 500, 800):
        pose = demo_plan.robot.kinematics().pose(demo_plan.trajectory(times[k]))
        angle = np.array([np.linalg.norm(pin.log3(pose[:3, :3].T @ each[:3, :3])) for each in fine])
        apart = np.linalg.norm(fine[:, :3, 3] - pose[:3, 3], axis=1)
        least = (apart + 0.1 * angle).min()  # a radian counts as a tenth of a metre
        assert position[k] / 1e3 + 0.1 * np.deg2rad(rotation[k]) == pytest.approx(least, abs=piece / 2)
        between = (
            np.linalg.norm(np.diff(fine[:, :3, 3], axis=0), axis=1).max() / 2
        )  # the nearest point may lie between two samples
        assert 1e3 * (apart.min() - between) <= position[k] < 5.0
    assert [dashed(axes) for axes in ax.figure.axes] == [[5.0], [pytest.approx(np.rad2deg(0.1))]]
    with pytest.raises(mp.errors.InvalidInputError, match="follow or improve"):
        viz.plot_deviation(demo_plan)


def layers_by_hand(rng):
    q = [rng.uniform(-0.2, 0.2, (300, 2)) for _ in range(6)]
    return mp.Layers.from_arrays(q, [rng.uniform(1.0, 2.0, 300) for _ in q])


def test_layers_show_candidates_and_the_path_that_was_found(rng, flat):
    layers = layers_by_hand(rng)
    found = mp.max_min_search(layers, 0.1)
    viz.plot_layers(layers, found, ax=flat)
    dots, highest, path, least = flat.lines[:4]
    for position, value in zip(dots.get_xdata(), dots.get_ydata(), strict=True):
        assert value in layers.m[int(position)]
    assert {value.max() for value in layers.m} <= set(dots.get_ydata())
    np.testing.assert_array_equal(highest.get_ydata(), [value.max() for value in layers.m])
    np.testing.assert_array_equal(path.get_ydata(), [value[k] for value, k in zip(layers.m, found.indices, strict=True)])
    assert least.get_ydata()[0] == found.minimum
    assert dashed(flat) == [found.bound]
    with pytest.raises(mp.errors.InvalidInputError, match="6 layers"):
        viz.plot_layers(layers, replace(found, manipulability=found.manipulability[1:]))


def test_layers_show_where_no_path_leads_on(flat):
    layers = mp.Layers.from_arrays([[[0.0]], [[0.1]], [[5.0]]], [[1.0], [1.0], [2.0]])
    found = mp.max_min_search(layers, 0.2, throw=False)
    viz.plot_layers(layers, found, ax=flat)
    assert [line.get_xdata()[0] for line in flat.lines if "no continuous" in line.get_label()] == [2]


def test_convergence_shows_every_solve(demo_plan, flat):
    result = demo_plan.result
    viz.plot_convergence(result, ax=flat)
    drawn = {
        (x, y, line.get_markerfacecolor() != "none")
        for line in flat.lines
        if line.get_marker() != "None"
        for x, y in zip(line.get_xdata(), line.get_ydata(), strict=True)
    }
    assert drawn == {(k + 1, step.g, step.clearance > 0) for k, step in enumerate(result.history)}
    assert result.g in dashed(flat)
    labels = " ".join(text.get_text() for text in flat.get_legend().get_texts())
    assert f"seed: {result.seed_cost.g:.4g}, above" in labels
    with pytest.raises(mp.errors.InvalidInputError, match="at least one solve"):
        viz.plot_convergence(replace(result, history=()))


def legends(figure):
    return [[text.get_text() for text in ax.get_legend().get_texts()] for ax in figure.axes[:2]]


@pytest.mark.slow
def test_each_job_names_its_paths_alike_on_both_sides(demo_plan):
    improved = replace(demo_plan.result, status=mp.Status.IMPROVED)
    nothing = np.zeros((1, 7))
    refinement = Refinement(
        q=nothing, manipulability=nothing[0], discrete=0.0, resampled=0.0, refined=0.0, bound=0.02, length=0.0, history=()
    )
    for plan, ours, first, more in (
        (demo_plan, "optimised", "seed", ["straight"]),
        (replace(demo_plan, refinement=refinement), "refined", "best of the samples", ["bound"]),
        (replace(demo_plan, result=improved), "improved", "recorded", []),
    ):
        assert legends(viz.draw_figure(plan)) == [[f"tool, {ours}", f"tool, {first}"], [ours, first, *more]]
    kept = replace(demo_plan, path=demo_plan.result.seed)
    assert legends(viz.draw_figure(kept)) == [["tool, seed"], ["seed", "straight"]]


def test_two_motions_of_one_tool_path_are_one_line(planar):
    path = mp.JointPath.line([0.1, 0.5, 0.7], [0.9, 1.0, 0.4])
    same = mp.JointPath.through(path(np.linspace(0, 1, 9)))
    ax = viz.plot_arm(planar, path, seed=same, names=("refined", "sampled"))
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["tool, refined and sampled"]


@pytest.mark.slow
def test_a_figure_is_drawn_as_vectors_alone(demo_plan, planar_plan, tmp_path):
    for plan in (demo_plan, planar_plan):
        viz.draw_figure(plan).savefig(tmp_path / "plan.svg")
        root = ElementTree.parse(tmp_path / "plan.svg").getroot()
        assert not list(root.iter(f"{SVG}image"))
        paths = list(root.iter(f"{SVG}path"))
        assert len(paths) > (2000 if plan is demo_plan else 100)
        assert (tmp_path / "plan.svg").stat().st_size < 2e6


@pytest.mark.slow
def test_new_axes_are_made_and_returned(demo_plan):
    for draw in (viz.plot_arm, viz.plot_tool_path):
        ax = draw(demo_plan.robot, demo_plan.path)
        assert ax.name == "3d"
        assert ax.figure.number in plt.get_fignums()
    assert viz.plot_joints(demo_plan.trajectory).name == "rectilinear"
    with pytest.raises(mp.errors.InvalidInputError, match="without projection"):
        viz.plot_joints(demo_plan.trajectory, ax=ax)
    with pytest.raises(mp.errors.InvalidInputError, match="with projection='3d'"):
        viz.plot_arm(demo_plan.robot, demo_plan.path, ax=Figure().add_subplot())
    with pytest.raises(mp.errors.InvalidInputError, match="ax"):
        viz.plot_convergence(demo_plan.result, ax="here")


@pytest.mark.slow
def test_a_gif_holds_the_motion_in_its_time(planar_plan, tmp_path):
    file, told = tmp_path / "plan.gif", []
    viz.animate(planar_plan, file, fps=8, speed=2.0, size=(4, 2), dpi=60, progress=lambda share, text: told.append(share))
    duration = planar_plan.trajectory.duration / 2
    with Image.open(file) as film:
        assert film.size == (240, 120)
        assert film.n_frames == np.ceil(8 * duration) + 1
        shown, pictures = [], []
        for k in range(film.n_frames):
            film.seek(k)
            shown.append(film.info["duration"])
            pictures.append(np.asarray(film.convert("RGB"), dtype=int))
    assert shown[-1] == 1000
    assert sum(shown[:-1]) == pytest.approx(1000 * duration, abs=126)
    assert np.abs(pictures[0] - pictures[-1]).max() > 100
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert len(told) == len(shown) + 1


@pytest.mark.slow
def test_a_film_that_is_interrupted_leaves_what_was_there(planar_plan, tmp_path):
    file = tmp_path / "plan.gif"
    file.write_bytes(b"before")

    def stop(share, text):
        if share > 0.3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        viz.animate(planar_plan, file, fps=4, size=(3, 2), dpi=40, progress=stop)
    assert file.read_bytes() == b"before"
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.slow
def test_the_demo_in_motion_is_a_small_gif(demo_plan, tmp_path):
    viz.animate(demo_plan, tmp_path / "demo.gif", fps=6)
    assert (tmp_path / "demo.gif").stat().st_size < 500_000


@pytest.mark.slow
def test_an_mp4_has_as_many_frames_in_as_much_time(planar_plan, tmp_path):
    assert shutil.which("ffprobe"), (
        "ffprobe was not found; install it with: sudo apt-get install ffmpeg   (as root: make ffmpeg)"
    )
    viz.animate(planar_plan, tmp_path / "plan.mp4", fps=10, size=(4.01, 2.0), dpi=60)
    ask = ["-count_frames", "-select_streams", "v", "-show_entries", "stream=nb_read_frames,avg_frame_rate,width"]
    line = ["ffprobe", "-v", "error", *ask, "-of", "csv=p=0", str(tmp_path / "plan.mp4")]
    width, rate, frames = subprocess.run(line, capture_output=True, text=True, check=True).stdout.strip().split(",")
    assert (int(width), rate) == (240, "10/1")
    assert int(frames) == np.ceil(10 * planar_plan.trajectory.duration) + 1


def test_what_cannot_be_animated_is_said_before_anything_is_drawn(planar_plan, tmp_path, monkeypatch):
    for name in ("plan.avi", "plan"):
        with pytest.raises(mp.errors.InvalidInputError, match=r"\.gif or \.mp4"):
            viz.animate(planar_plan, tmp_path / name)
    for change in (
        {"fps": 0},
        {"fps": 60},
        {"speed": 0},
        {"colours": 1},
        {"dpi": -1},
        {"dpi": 1},
        {"size": (0, 1)},
        {"dpi": 1e6},
        {"size": (1e3, 1)},
        {"progress": 3},
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=next(iter(change))):
            viz.animate(planar_plan, tmp_path / "plan.gif", **change)
    with pytest.raises(mp.errors.InvalidInputError, match="can be written"):
        viz.animate(planar_plan, tmp_path / "nowhere" / "plan.gif")
    with pytest.raises(mp.errors.PlanningError, match="no trajectory"):
        viz.animate(
            mp.results.PartialPlan(robot=planar_plan.robot, scene=planar_plan.scene, status=mp.Status.NO_PATH),
            tmp_path / "plan.gif",
        )
    with pytest.raises(mp.errors.InvalidInputError, match="plan"):
        viz.animate(planar_plan.trajectory, tmp_path / "plan.gif")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(mp.errors.MissingProgramError, match="sudo apt-get install ffmpeg"):
        viz.animate(planar_plan, tmp_path / "plan.mp4")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_importing_viz_does_not_import_matplotlib():
    code = "import sys; from manipplan import viz; print('matplotlib' in sys.modules, 'PIL' in sys.modules)"
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert out.split() == ["False", "False"]


def test_round_bodies_need_no_memory_that_nobody_has_set(space, monkeypatch):
    # the flat ends of a cylinder have more corners than its sides: Matplotlib would fill up the sides from np.empty
    empty = np.empty

    def unset(shape, dtype=float, **options):
        array = empty(shape, dtype, **options)
        if array.dtype == float:
            array.fill(1e308)
        return array

    monkeypatch.setattr(np, "empty", unset)
    for body in (coal.Cylinder(0.1, 0.4), coal.Capsule(0.1, 0.4), coal.Sphere(0.1), coal.Box(0.1, 0.2, 0.3)):
        draw_surface(space, surface_of(body), "#000000", alpha=1.0, edges=True)
    low, high = space.get_zlim3d()
    assert low < -0.3 < 0.3 < high < 0.4  # half the capsule's length and its radius, with a margin


@pytest.fixture
def odd_plan(tmp_path):
    name = "$x_{$"
    body = '<collision><geometry><cylinder radius="0.03" length="0.3"/></geometry></collision>'
    limits = '<limit lower="-2" upper="2" velocity="1" effort="1"/>'
    links = "".join(
        f'<link name="{k}{name}">{body}</link><joint name="{k}{name}" type="revolute"><parent link="{k - 1}{name}"/>'
        f'<child link="{k}{name}"/><origin xyz="0 0 0.3"/><axis xyz="{axis}"/>{limits}</joint>'
        for k, axis in enumerate(("0 0 1", "0 1 0", "0 1 0"), start=1)
    )
    (tmp_path / "arm.urdf").write_text(
        f'<robot name="{name}"><link name="0{name}"/>{links}<link name="tip"/><joint name="end" type="fixed"><parent link="3{name}"/><child link="tip"/><origin xyz="0 0 0.3"/></joint></robot>'
    )
    scene = mp.Scene(
        [mp.Cylinder(radius=0.1, length=0.2, position=(1.0, 0, 0), name=name), mp.Plane(position=(0, 0, -1), name=f"{name}^")]
    )
    robot = mp.load_robot(tmp_path / "arm.urdf")
    assert robot.name == name
    return mp.plan(robot, [-0.5, 0.4, 0.6], [0.5, 0.8, 0.9], scene)


@pytest.mark.slow
def test_names_are_drawn_as_they_are(odd_plan, tmp_path):
    assert (tmp_path / "out" / "plan.png") in odd_plan.save(tmp_path / "out")
    figure = viz.draw_figure(odd_plan)
    figure.savefig(tmp_path / "plan.svg")
    named = [text for text in figure.findobj(Text) if "x_{" in text.get_text()]
    assert len(named) == 5  # title, obstacle, joints
    assert not any(text.get_parse_math() for text in named)


@pytest.mark.slow
def test_the_data_are_written_before_the_picture(odd_plan, tmp_path, monkeypatch):
    def fails(plan, file):
        raise RuntimeError("no picture")

    monkeypatch.setattr(viz, "save_figure", fails)
    with pytest.raises(RuntimeError, match="no picture"):
        odd_plan.save(tmp_path / "out")
    again = mp.Plan.load(tmp_path / "out")
    np.testing.assert_array_equal(again.trajectory.q, odd_plan.trajectory.q)
    assert len(list((tmp_path / "out").iterdir())) == 6


def test_the_deviation_of_an_improved_recording_is_that_of_its_comparison(planar, flat):
    line = mp.JointPath.line([0.3, 0.5, 0.6], [0.8, 0.4, 0.8])
    plan = mp.improve(planar, mp.retime(line, planar).slower(4.0))
    viz.plot_deviation(plan, ax=flat)
    shown = flat.lines[0]
    assert shown.get_xdata()[-1] == pytest.approx(plan.trajectory.duration)
    assert shown.get_ydata().max() == pytest.approx(1e3 * plan.comparison.deviation.position, rel=1e-2)
    assert dashed(flat) == [20.0]


def test_a_planar_arm_in_space(planar_plan, space):
    """With its ellipsoids, which are flat."""
    axes = mp.viz.plot_arm(planar_plan.robot, planar_plan.path, planar_plan.scene, ax=space)
    assert axes is space and len(space.collections) > 3


def test_characters_that_no_font_has_are_told_once(caplog):
    """The names of obstacles come from files; the picture shows boxes for such characters."""
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), position=(0.5, 0.0, 0.0), name="箱子箱")])
    with caplog.at_level("WARNING", logger="manipplan"):
        assert "<img" in scene._repr_html_()
    [record] = [each for each in caplog.records if "font" in each.message]
    assert "has no 箱子: install one" in record.message and "fonts-noto-cjk" in record.message


def test_logarithmic_axes_have_labels_without_formulas():
    with style.shared():
        figure = Figure()
        upper, lower = figure.subplots(2)
        upper.plot([1e-5, 2e4], [1, 2])
        upper.set(xscale="log", xlim=(1e-5, 1e5))
        lower.plot([1.5, 8.0], [1, 2])
        lower.set(xscale="log")
        lower.set_yscale("log")
        lower.set_yticks([1, 2], ["one", "two"])
        style.label_powers(figure)
        figure.canvas.draw()
    labels = [label.get_text() for label in upper.get_xticklabels()]
    assert {"10⁻⁵", "0.1", "1000"} <= set(labels) and not any("$" in label for label in labels)
    assert {"2", "4"} <= {label.get_text() for label in lower.get_xticklabels(minor=True)}
    assert [label.get_text() for label in lower.get_yticklabels()] == ["one", "two"]
