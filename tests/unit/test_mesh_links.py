"""Links whose meshes decide: closed ones are solid, and pieces are refined only where that is not enough."""

import pickle

import coal
import numpy as np
import pytest

import manipplan as mp
from manipplan.collision import build, covers, surfaces
from manipplan.collision.model import CollisionModel
from manipplan.collision.world import mesh_key, mesh_triangles
from manipplan.robots.hulls import convex_hull
from manipplan.robots.mesh_files import triangle_tree
from manipplan.support.memo import content_key

BALL, FOREARM = '<sphere radius="0.03"/>', '<box size="0.2 0.04 0.04"/>'


def write(file, triangles):
    lines = ["v " + " ".join(f"{x:.17g}" for x in corner) for corner in triangles.reshape(-1, 3)]
    lines += [f"f {3 * k + 1} {3 * k + 2} {3 * k + 3}" for k in range(len(triangles))]
    file.write_text("\n".join(lines) + "\n")
    return file


def tube(inner, outer, length, sides=96):
    """Triangles (t, 3, 3) of a tube along x, seen from outside counterclockwise."""
    angle = 2 * np.pi * np.arange(sides) / sides
    profile = [(inner, -length / 2), (outer, -length / 2), (outer, length / 2), (inner, length / 2)]
    corner = np.array([[[z, r * np.cos(a), r * np.sin(a)] for r, z in profile] for a in angle])
    found = []
    for k in range(sides):
        here, following = corner[k], corner[(k + 1) % sides]
        for i in range(4):
            j = (i + 1) % 4
            found += [[here[i], following[i], following[j]], [here[i], following[j], here[j]]]
    return np.array(found)


def cube(half):
    corners = np.array([[x, y, z] for x in (-half, half) for y in (-half, half) for z in (-half, half)])
    faces = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]  # fmt: skip
    return corners[np.array(faces)]


def joint(name, parent, child, origin, axis, low, high, kind="revolute"):
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{origin}"/>'
        f'<axis xyz="{axis}"/><limit lower="{low}" upper="{high}" velocity="2" effort="1"/></joint>'
    )


def mesh_tag(file):
    return f'<mesh filename="{file}"/>'


def collision(geometry, origin="0 0 0"):
    return f'<collision><origin xyz="{origin}"/><geometry>{geometry}</geometry></collision>'


def cabinet(folder, shape):
    """The arm of menagerie.md, fault 1, as URDF: a large closed body on the base, a small one on a slide inside it."""
    file = folder / "cabinet.urdf"
    file.write_text(
        f'<robot name="cabinet"><link name="base">{collision(shape, "0.6 0 0.5")}</link><link name="a"/><link name="b"/>'
        f'<link name="c">{collision(BALL, "0.1 0 0")}</link>'
        + joint("j1", "base", "a", "0 0 0.5", "0 0 1", -1, 1)
        + joint("j2", "a", "b", "0.1 0 0", "0 1 0", -1, 1)
        + joint("j3", "b", "c", "0.2 0 0", "1 0 0", 0, 0.5, "prismatic")
        + '<link name="tool"/><joint name="t" type="fixed"><parent link="c"/><child link="tool"/><origin xyz="0.1 0 0"/></joint>'
        "</robot>"
    )
    return mp.load_robot(file, tool="tool")


def test_a_small_part_inside_a_large_closed_mesh_touches(tmp_path, rng):
    """menagerie.md, fault 1: 57 of 400 postures were found, 110 with a box in place of the cube, and a motion inside passed."""
    mesh = mesh_tag(write(tmp_path / "cube.obj", cube(0.25)))
    robot, filled = cabinet(tmp_path, mesh), cabinet(tmp_path, '<box size="0.5 0.5 0.5"/>')
    q = robot.random_configuration(rng, size=400)
    hits = mp.Scene().in_collision(robot, q)
    np.testing.assert_array_equal(hits, mp.Scene().in_collision(filled, q))
    assert 60 < hits.sum() < 200
    with pytest.raises(mp.errors.InvalidInputError, match="overlap"):
        mp.plan(robot, [-0.15, 0, 0.25], [0.15, 0.1, 0.3])


def test_a_part_inside_a_closed_mesh_that_is_not_convex_touches(tmp_path, rng):
    """A thick tube as a cabinet: the sphere touches in its wall, and does not beside it."""
    robot = cabinet(tmp_path, mesh_tag(write(tmp_path / "tube.obj", tube(0.1, 0.25, 0.5, 32))))
    q = robot.random_configuration(rng, size=2000)
    tool = robot.kinematics().pose(q)[:, :3, 3] - [0.6, 0.0, 0.5]
    across, along = np.linalg.norm(tool[:, 1:], axis=1), np.abs(tool[:, 0])
    wall, beside = (across > 0.1) & (across < 0.245) & (along < 0.25), (across > 0.281) | (along > 0.281)
    hits = mp.Scene().in_collision(robot, q)
    assert hits[wall].all() and wall.sum() > 100
    assert not hits[beside].any() and beside.sum() > 100


def wrist(folder, before, behind, bend):
    """An arm with a mesh on the link before a wrist and one on the link behind it."""
    file = folder / "wrist.urdf"
    files = [write(folder / name, each) for name, each in (("before.obj", before), ("behind.obj", behind))]
    meshes = [collision(mesh_tag(each)) for each in files]
    file.write_text(
        f'<robot name="wrist"><link name="base"/><link name="l1">{meshes[0]}</link><link name="l2"/><link name="l3">{meshes[1]}'
        f'</link><link name="l4">{collision(FOREARM, "0.15 0 0")}</link>'
        + joint("j1", "base", "l1", "0 0 0.5", "0 0 1", -3, 3)
        + joint("j2", "l1", "l2", "0 0 0", "1 0 0", -3, 3)
        + joint("j3", "l2", "l3", "0 0 0", "0 1 0", -bend, bend)
        + joint("j4", "l3", "l4", "0.3 0 0", "0 0 1", -2, 2)
        + '<link name="tool"/><joint name="t" type="fixed"><parent link="l4"/><child link="tool"/><origin xyz="0.25 0 0"/></joint>'
        "</robot>"
    )
    return mp.load_robot(file, tool="tool")


@pytest.mark.slow
def test_a_ring_around_a_rod_is_taken_by_more_pieces(tmp_path, rng):
    """robots.md, fault 6: the pair was left to coal, and plans stopped early after seconds."""
    robot = wrist(tmp_path, tube(0.06, 0.08, 0.05), tube(0.0, 0.04, 0.3), 0.2)
    model = mp.Scene().collision_model(robot)
    assert any(name.startswith("l1_0.of") for pair in model.pair_names for name in pair) and not model.solids
    q = robot.random_configuration(rng, size=500)
    assert not model.in_collision_rows(q).any()
    assert str(model).count("0 parts of obstacles")
    finer = [model.excess[name] for name in model.excess if ".of" in name]
    assert max(finer) < 0.01
    assert mp.plan(robot, q[0], q[1]).report.passed


def test_sleeves_with_a_gap_of_a_millimetre_are_taken_by_sectors(tmp_path, rng):
    robot = wrist(tmp_path, tube(0.041, 0.05, 0.2, 96), tube(0.03, 0.039, 0.3, 96), 0.012)
    model = mp.Scene().collision_model(robot)
    outer = [name for pair in model.pair_names for name in pair if name.startswith("l1_0.of")]
    assert len(set(outer)) >= 24 and not model.solids
    q = robot.random_configuration(rng, size=300)
    assert not model.in_collision_rows(q).any()
    q[:, 2] = 0.022
    assert model.in_collision_rows(q).all()


def test_sleeves_with_a_gap_of_a_millimetre_are_decided_by_their_triangles(tmp_path, rng, monkeypatch):
    monkeypatch.setattr(build, "FINE", ())
    robot = wrist(tmp_path, tube(0.041, 0.05, 0.2, 24), tube(0.03, 0.0395, 0.3, 24), 0.02)
    model = mp.Scene().collision_model(robot)
    assert ("l3_0.mesh", "l1_0.mesh") in model.pair_names and len(model.solids) == 2
    scene_model = mp.Scene([mp.Box(size=(1, 1, 0.1), name="floor")]).collision_model(robot)
    assert scene_model.solids == model.solids
    for name in ("_distance", "_touches"):
        monkeypatch.setattr(CollisionModel, name, lambda *_: pytest.fail("coal was asked"))
    q = robot.random_configuration(rng, size=300)
    bent = np.abs(q[:, 2]) * 0.1
    hits = model.in_collision_rows(q)
    assert not hits[bent < 0.0008].any() and hits[bent > 0.0018].all()
    copied = model.copy()
    np.testing.assert_array_equal(copied.in_collision_rows(q), hits)


@pytest.fixture
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def sleeves(folder):
    """An arm with a pair that is decided by triangles where `FINE` is empty."""
    return wrist(folder, tube(0.041, 0.05, 0.2, 24), tube(0.03, 0.0395, 0.3, 24), 0.02)


def measured(robot):
    """All that a collision model says, and its distances."""
    model = mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), position=(0.4, 0.1, 0.5), name="box")]).collision_model(robot)
    q = robot.random_configuration(np.random.default_rng(1), size=50)
    return model.distance_rows(q), (
        model.pair_names,
        dict(model.dropped),
        model.contacts,
        model.excess,
        model.links,
        model.solids,
    )


@pytest.mark.slow
@pytest.mark.parametrize("fine", [(), (12, 24, 48)], ids=["triangles", "pieces"])
def test_a_later_process_computes_nothing_again(tmp_path, cache, monkeypatch, fine):
    monkeypatch.setattr(build, "FINE", fine)
    distances, said = measured(sleeves(tmp_path))
    assert sorted(each.name for each in cache.iterdir() if each.is_dir()) == ["choices", "parts", "pieces"]
    for module, name in ((covers, "convex_pieces"), (surfaces, "mesh_parts"), (build, "_choose")):
        monkeypatch.setattr(module, name, lambda *_, name=name: pytest.fail(f"{name} was called"))
    again, same = measured(sleeves(tmp_path))
    assert said == same
    np.testing.assert_array_equal(distances, again)


@pytest.mark.slow
@pytest.mark.parametrize(
    "spoil",
    [
        lambda content: b"",
        lambda content: content[:-9],
        lambda content: content[:40] + b"7" + content[41:],
        lambda content: content[32:],
    ],
    ids=["empty", "cut off", "changed", "without digest"],
)
def test_spoilt_files_are_made_again(tmp_path, cache, monkeypatch, spoil):
    monkeypatch.setattr(build, "FINE", ())
    distances, said = measured(sleeves(tmp_path))
    written = {file: file.read_bytes() for kind in ("choices", "parts", "pieces") for file in (cache / kind).iterdir()}
    assert len(written) >= 5
    for file, content in written.items():
        file.write_bytes(spoil(content))
    again, same = measured(sleeves(tmp_path))
    assert said == same
    np.testing.assert_array_equal(distances, again)
    assert {file: file.read_bytes() for file in written} == written


def test_a_mesh_and_its_copy_have_the_same_triangles_and_key():
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    tree = triangle_tree(corners, faces)
    copied, open_one = tree.clone(), triangle_tree(corners, faces[:3])
    pickled = pickle.loads(pickle.dumps(tree))
    assert not vars(copied) and not vars(pickled)
    assert content_key(tree) == content_key(triangle_tree(corners, faces)) and mesh_key(tree) == mesh_key(pickled)
    np.testing.assert_array_equal(mesh_triangles(tree), mesh_triangles(copied))
    assert mesh_key(tree) == mesh_key(copied) != mesh_key(open_one)


def test_a_hull_is_the_body_that_coal_makes_of_its_triangles(rng):
    hull = convex_hull(rng.normal(size=(200, 3)))
    points, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    points.extend(hull.corners)
    triangles.extend(coal.Triangle(*each) for each in hull.faces.tolist())
    assert hull.shape() == coal.Convex(points, triangles)
