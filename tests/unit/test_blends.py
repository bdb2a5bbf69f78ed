"""Blends stay in the convex hull of the two pieces that they replace; their radii, one for each move; what is left of paths."""

from itertools import pairwise

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp
from manipplan.programs.blend import BlendHull
from manipplan.programs.steps import ProgramFile

START = {
    "panda": np.array([0.0, -0.5, 0.0, -2.2, 0.0, 1.8, 0.8]),
    "ur5": np.array([0.0, -1.4, 1.6, -1.77, -1.57, 0.0]),
    "xarm7": np.array([0.0, -0.3, 0.0, 1.1, 0.0, 1.4, 0.0]),
}
ROBOTS = {}


def arm(name):
    if name not in ROBOTS:
        ROBOTS[name] = mp.load_robot(name)
    return ROBOTS[name]


def placed(robot, motion, count=4000):
    """Positions of the tool by Pinocchio."""
    data, frame = robot.model.createData(), robot.model.getFrameId(robot.tool)
    places = []
    for q in motion(np.linspace(0.0, motion.duration, count)):
        pin.framesForwardKinematics(robot.model, data, q)
        places.append(data.oMf[frame].translation.copy())
    return np.array(places)


def beyond_triangle(places, corners):
    """Largest distance of places (k, 3) from a triangle (3, 3), also a flat one: in closed form."""
    a, b, c = corners
    best = np.full(len(places), np.inf)
    for one, other in ((a, b), (b, c), (c, a)):
        way = other - one
        share = np.clip((places - one) @ way / max(way @ way, 1e-18), 0.0, 1.0)
        best = np.minimum(best, np.linalg.norm(places - one - share[:, None] * way, axis=1))
    normal = np.cross(b - a, c - a)
    if np.linalg.norm(normal) > 1e-12:
        shares = np.linalg.lstsq(np.stack([b - a, c - a], axis=1), (places - a).T, rcond=None)[0]
        inside = (shares >= 0).all(axis=0) & (shares.sum(axis=0) <= 1)
        height = np.abs((places - a) @ normal) / np.linalg.norm(normal)
        best = np.where(inside, np.minimum(best, height), best)
    return float(best.max())


@pytest.mark.slow
@pytest.mark.parametrize("name", ["panda", "ur5"])
@pytest.mark.parametrize("blend", [0.0, 0.01, 0.03])
def test_straight_in_and_out_goes_no_deeper(name, blend):
    """F07: 50 mm in and 50 mm out went 76.5 mm deep."""
    robot, q = arm(name), arm(name).states.get("default", START[name])
    tip = robot.kinematics().pose(q)[:3, :3] @ [0, 0, 1.0]
    made = mp.sequence(robot, q, [mp.MoveAlong([0, 0, 0.05]), mp.MoveAlong([0, 0, -0.05])], blend=blend)
    depth = (placed(robot, made.trajectory) - robot.kinematics().pose(q)[:3, 3]) @ tip
    assert made.passed and depth.max() < 0.05 + 1e-5
    assert len(made.stops) == 1 and made.marks[0].blend == 0.0
    if blend:
        (warning,) = made.warnings
        assert warning.startswith(f"steps[0]: a stop at the corner before steps[1], instead of a blend of {1e3 * blend:g} mm: ")


directions = st.tuples(*[st.floats(-1, 1)] * 3).map(np.array).filter(lambda each: np.linalg.norm(each) > 0.1)


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(
    name=st.sampled_from(list(START)),
    first=directions,
    across=directions,
    angle=st.floats(5, 180),
    ways=st.tuples(st.floats(0.03, 0.15), st.floats(0.03, 0.15)),
    blend=st.floats(0.002, 0.2),
)
def test_straight_corners_stay_in_their_triangle(name, first, across, angle, ways, blend):
    robot, q = arm(name), START[name]
    first = first / np.linalg.norm(first)
    across = np.cross(first, across)
    if np.linalg.norm(across) < 0.05:
        return
    across /= np.linalg.norm(across)
    second = np.cos(np.radians(angle)) * first + np.sin(np.radians(angle)) * across
    try:
        made = mp.sequence(robot, q, [mp.MoveAlong(ways[0] * first), mp.MoveAlong(ways[1] * second)], blend=blend)
    except (mp.errors.PlanningError, mp.errors.InvalidInputError):
        return  # out of reach
    pose = robot.kinematics().pose(q)
    begin, corner = pose[:3, 3], pose[:3, 3] + pose[:3, :3] @ (ways[0] * first)
    end = corner + pose[:3, :3] @ (ways[1] * second)
    places = placed(robot, made.trajectory)
    assert beyond_triangle(places, (begin, corner, end)) <= 1e-4
    used = made.marks[0].blend
    assert 0 <= used <= min(blend, *(0.5 * each for each in ways)) * (1 + 1e-9)
    assert (used == 0) == (len(made.stops) == 1)
    assert (used < blend * (1 - 1e-9)) == bool(made.warnings)
    # what is left of both ways
    for one, other, way in ((begin, corner, ways[0]), (corner, end, ways[1])):
        along = (places - one) @ (other - one) / way
        off = np.linalg.norm(places - one - along[:, None] * (other - one) / way, axis=1)
        on = along[(off < 1e-4) & (along > -1e-4) & (along < way + 1e-4)]
        assert np.ptp(on) > way - used - 1e-3


def cut_corner(robot, **blends):
    """Up, across and down again, about an ordinary posture."""
    first, across, last = (blends.get(name) for name in ("first", "across", "last"))
    return [
        mp.MoveAlong([0, 0, -0.1], blend=first),
        mp.MoveAlong([0.12, 0, 0], blend=across),
        mp.MoveAlong([0, 0, 0.1], blend=last),
    ]


@pytest.mark.slow
def test_each_move_has_its_own_radius(tmp_path):
    robot, q = arm("panda"), START["panda"]
    made = mp.sequence(robot, q, cut_corner(robot, first=0.01, last=0.05), blend=0.02)
    assert [mark.blend for mark in made.marks] == [0.01, 0.02, None]
    assert not made.stops and not made.warnings
    assert "blend        10 mm at its end" in str(made)
    places = placed(robot, made.trajectory)
    pose = robot.kinematics().pose(q)
    corners = [pose[:3, 3] + pose[:3, :3] @ each for each in ([0, 0, -0.1], [0.12, 0, -0.1])]
    nearest = [np.linalg.norm(places - corner, axis=1).min() for corner in corners]
    assert 0.001 < nearest[0] < 0.01 and nearest[0] < nearest[1] < 0.02
    stopped = mp.sequence(robot, q, cut_corner(robot, first=0.0), blend=0.02)
    assert [mark.blend for mark in stopped.marks] == [0.0, 0.02, None] and len(stopped.stops) == 1
    made.save(tmp_path)
    assert mp.Program.load(tmp_path).marks == made.marks
    rows = [row.split(",") for row in (tmp_path / "marks.csv").read_text().splitlines()]
    assert [row[rows[0].index("blend")] for row in rows[1:]] == ["0.01", "0.02", ""]


@pytest.mark.slow
@pytest.mark.parametrize("blend", [0.02, 0.1, 2.0])
def test_half_of_each_path_is_left(blend):
    """S4: of 300 mm 54 were left, silently."""
    robot = arm("panda")
    poses = [np.diag([1.0, -1.0, -1.0, 1.0]) for _ in range(3)]
    for pose, place in zip(poses, ([0.5, -0.15, 0.3], [0.5, 0.15, 0.3], [0.5, 0.15, 0.5]), strict=True):
        pose[:3, 3] = place
    lines = [mp.CartesianPath.line(one, other) for one, other in pairwise(poses)]
    steps = [mp.MoveTo(poses[0]), mp.MoveAlong(lines[0]), mp.MoveAlong(lines[1])]
    made = mp.sequence(robot, "default", steps, blend=blend)
    places = placed(robot, made.trajectory, 8000)
    off = np.linalg.norm(places[:, [0, 2]] - [0.5, 0.3], axis=1)
    assert np.ptp(places[off < 5e-5, 1]) >= 0.15 - 1e-3
    before, along, last = made.marks
    assert 0 < before.blend <= min(blend, 0.075) and 0 < along.blend <= min(blend, 0.075) and last.blend is None
    smaller = [f"steps[{mark.step}]" for mark in (before, along) if mark.blend < blend]
    assert [each.split(":")[0] for each in made.warnings] == smaller
    assert all("half of each path" in each or "hull" in each for each in made.warnings)


@pytest.mark.slow
def test_the_corner_of_an_approach_has_the_radius_of_its_move():
    robot = mp.load_robot("panda", locked={"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04})
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = 0.45, 0.2, 0.2
    made = mp.sequence(robot, "default", [mp.MoveTo(pose, approach=0.1, blend=0.03), mp.MoveAlong([0, 0, -0.1])])
    assert 0 < made.marks[0].path_blend <= 0.03
    assert made.marks[0].blend == 0.0 and len(made.stops) == 1  # in and straight out
    assert "mm where its path begins" in str(made)


@pytest.mark.parametrize("value", [-0.01, np.nan, np.inf, "wide", True])
@pytest.mark.parametrize("step", [mp.MoveTo, mp.MoveAlong])
def test_bad_radii(step, value):
    with pytest.raises(mp.errors.InvalidInputError, match="blend"):
        step([0.0, 0.0, 0.1], blend=value)


def test_radii_in_a_file(tmp_path):
    file = tmp_path / "cell.yaml"
    move_to = "- move_to: {goal: {state: default}, blend: 0.01}"
    file.write_text(f"start: default\nblend: 0.02\nsteps:\n{move_to}\n- move_along: {{way: [0, 0, 0.1], blend: 0}}\n")
    robot = arm("panda")
    assert [each.blend for each in ProgramFile.read(file).steps(robot)] == [0.01, 0.0]
    file.write_text(file.read_text().replace("blend: 0}", "blend: -1}"))
    with pytest.raises(mp.errors.FileFormatError, match=r"steps\[1\]\.move_along\.blend"):
        ProgramFile.read(file).steps(robot)


@settings(max_examples=60, deadline=None)
@given(rank=st.integers(1, 3), count=st.integers(2, 30), seed=st.integers(0, 10_000))
def test_distances_from_a_hull(rank, count, seed):
    """The vector found is a normal of the hull where it ends: no corner of the hull is beyond the plane through its end."""
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(count, rank)) @ rng.normal(size=(rank, 3)) * 0.05 + rng.normal(size=3)
    places = np.concatenate([points.mean(axis=0) + 0.2 * rng.normal(size=(8, 3)), points, [points.mean(axis=0)]])
    beyond = BlendHull.of(points).beyond(places)
    ends = places - beyond
    for place, off, end in zip(places, beyond, ends, strict=True):
        size = np.linalg.norm(off)
        if size > 1e-7:
            assert ((points - end) @ off / size).max() < 1e-6
            assert np.isclose(np.linalg.norm(place - end), size)
    assert np.linalg.norm(beyond[8:], axis=1).max() < 1e-6
