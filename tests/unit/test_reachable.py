"""Proofs that a goal cannot be reached: never where there is a path, and soon where the case can be decided."""

import sys
from dataclasses import dataclass, replace
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin
import pytest
from scipy.optimize import linprog
from scipy.spatial import ConvexHull

import manipplan as mp
from manipplan.robots.hulls import convex_hull
from manipplan.seeds import connect, reachable
from manipplan.seeds.reachable import Space, find_barrier, find_inscribed_ball, why_unreachable
from manipplan.seeds.task import SeedTask
from manipplan.support.deadline import work_time

OUTSIDE = Path(__file__).parents[2] / "benchmarks" / "outside"
#: Walls that the first link of a planar arm of three links of 1 m cannot pass.
NORTH = mp.Box(size=[0.05, 0.8, 0.4], position=(0.0, 0.9, 0.0), name="north")
SOUTH = mp.Box(size=[0.05, 0.8, 0.4], position=(0.0, -0.9, 0.0), name="south")
EAST, WEST = [0.0, 0.5, 0.3], [np.pi, 0.5, 0.3]
#: A posture of the Panda with the hand down, and one beside it.
DOWN = np.array([0.0, -0.3, 0.0, -2.0, 0.0, 1.8, 0.785])
BESIDE = DOWN + np.array([1.5, -0.5, 0.0, 0.0, 0.0, 0.0, 0.0])


def task(robot, start, goal, scene, clearance=0.0):
    model = scene.collision_model(robot)
    q = [
        model.free_configuration(name, np.array(each, dtype=float), clearance)
        for name, each in zip(("start", "goal"), (start, goal), strict=True)
    ]
    distances = tuple(model.least_distance(each[None])[0] for each in q)
    given = {"seed": 0, "clearance": clearance, "signs": None, "most_crossings": None, "checks": None}
    return SeedTask(model=model, start=q[0], goal=q[1], distances=distances, deadline=work_time() + 10.0, **given)


def cage(middle, *, inner=0.14, hole=0.105, thick=0.02):
    """A closed cage around a place, but for a square hole of half width `hole` in its lid."""
    x, y, z = middle
    out = 2 * (inner + thick)
    boxes = []
    for name, axis, side in (("left", 1, -1), ("right", 1, 1), ("back", 0, -1), ("front", 0, 1), ("floor", 2, -1)):
        size, place = [out] * 3, np.array(middle)
        size[axis] = thick
        place[axis] += side * (inner + thick / 2)
        boxes.append(mp.Box(size=size, position=place, name=name))
    wide, over = out / 2 - hole, z + inner + thick / 2
    for k, side in enumerate((-1, 1)):
        away = side * (hole + wide / 2)
        boxes.append(mp.Box(size=[wide, out, thick], position=(x + away, y, over), name=f"lid{k}"))
        boxes.append(mp.Box(size=[2 * hole, wide, thick], position=(x, y + away, over), name=f"lid{k + 2}"))
    return mp.Scene(boxes)


@pytest.fixture(scope="module")
def carrier(panda):
    """The Panda with a ball in its hand."""
    return panda.attach(mp.Sphere(radius=0.12, position=(0, 0, 0.15), name="globe"))


@pytest.fixture(scope="module")
def around(carrier):
    """A cage around that ball in the posture DOWN; the hand reaches in through its hole, through which the ball cannot pass."""
    pose = carrier.kinematics().pose(DOWN)
    scene = cage(pose[:3, 3] + 0.15 * pose[:3, 2])
    with pytest.raises(mp.errors.PlanningError):  # compiles and loads what the searches need
        mp.seed_path(carrier, BESIDE, DOWN, scene)
    return scene


@pytest.mark.parametrize(("start", "goal", "end"), [(BESIDE, DOWN, "goal"), (DOWN, BESIDE, "start")])
def test_an_enclosed_body_is_told_with_what_encloses_it(carrier, around, start, goal, end):
    began = work_time()
    with pytest.raises(
        mp.errors.PlanningError, match=rf"proven .* globe is enclosed at the {end}, and \w+ is .* radius 120 mm"
    ):
        mp.seed_path(carrier, start, goal, around)
    assert work_time() - began < 2.0  # 0.2 s


@pytest.mark.slow
def test_every_job_and_planner_tells_it(carrier, around):
    result = mp.optimize_path(carrier, BESIDE, DOWN, around, throw=False)
    assert "globe is enclosed at the goal" in result.message
    part = mp.plan(carrier, BESIDE, DOWN, around, throw=False)
    assert part.status is mp.Status.NO_PATH and "globe is enclosed at the goal" in part.message
    began = work_time()
    for planner in ("RRTConnect", "connect-star"):
        with pytest.raises(mp.errors.PlanningError, match="globe is enclosed at the goal"):
            mp.seed_path(carrier, BESIDE, DOWN, around, seeding=mp.Seeding(planner=planner))
    assert work_time() - began < 4.0


@pytest.mark.slow
@pytest.mark.parametrize("inner", [0.13, 0.14])
def test_a_cage_without_lid_or_with_a_wide_hole_does_not_enclose(carrier, around, inner):
    pose = carrier.kinematics().pose(DOWN)
    middle = pose[:3, 3] + 0.15 * pose[:3, 2]
    for scene in (
        cage(middle, inner=inner).without("lid0", "lid1", "lid2", "lid3"),
        cage(middle, inner=inner, hole=0.125),
        cage(middle, inner=inner).without("front"),
    ):
        assert why_unreachable(task(carrier, BESIDE, DOWN, scene)) is None
    assert mp.seed_path(carrier, BESIDE, DOWN, around.without("lid0", "lid1", "lid2", "lid3")).n == 7


@pytest.mark.slow
def test_the_clearance_counts(carrier, around):
    """The ball passes a hole of 125 mm with 4 mm to spare, and not with 6 mm."""
    pose = carrier.kinematics().pose(DOWN)
    scene = cage(pose[:3, 3] + 0.15 * pose[:3, 2], hole=0.125)
    assert why_unreachable(task(carrier, BESIDE, DOWN, scene, clearance=0.004)) is None
    found = why_unreachable(task(carrier, BESIDE, DOWN, scene, clearance=0.015))
    assert found is not None and "the clearance of 15 mm" in found


def test_a_mesh_and_a_cloud_enclose_as_well(carrier, around):
    boxes = [each for each in around.obstacles if each.name != "floor"]
    floor = next(each for each in around.obstacles if each.name == "floor")
    x, y, z = floor.position
    w = 0.16
    corners = np.array([[x - w, y - w, z], [x + w, y - w, z], [x + w, y + w, z], [x - w, y + w, z]])
    sheet = mp.Mesh(triangles=[corners[[0, 1, 2]], corners[[0, 2, 3]]], name="sheet")
    grid = np.stack(np.meshgrid(np.arange(x - w, x + w, 0.01), np.arange(y - w, y + w, 0.01), [z]), axis=-1).reshape(-1, 3)
    cloud = mp.PointCloud(points=grid, radius=0.01, name="cloud")
    for other in (sheet, cloud):
        assert "globe is enclosed" in why_unreachable(task(carrier, BESIDE, DOWN, mp.Scene([*boxes, other])))
    assert why_unreachable(task(carrier, BESIDE, DOWN, mp.Scene(boxes))) is None


def test_walls_that_the_first_joint_cannot_pass(planar):
    began = work_time()
    with pytest.raises(mp.errors.PlanningError, match=r"every motion of joint1 .* two bodies into contact; .* (north|south)"):
        mp.seed_path(planar, EAST, WEST, mp.Scene([NORTH, SOUTH]))
    assert work_time() - began < 2.0
    found = why_unreachable(task(planar, EAST, WEST, mp.Scene([NORTH, SOUTH]), clearance=0.01))
    assert "closer than the clearance of 10 mm" in found


@pytest.mark.slow
def test_a_joint_that_goes_around_a_wall_arrives_a_turn_away(planar):
    """Values of joints are plain angles: to get from 0 to π a joint takes every value between."""
    scene, around = mp.Scene([NORTH]), [-np.pi, *WEST[1:]]
    reason = "every motion of joint1 within its limits from start to goal brings link1_0 and north into contact"
    for limit in (np.inf, 1e6, 4.0):
        arm = planar.with_limits(lower=-limit, upper=limit)
        assert f"{reason}; goals a full turn away are other goals (Seeding.shifts)" in why_unreachable(
            task(arm, EAST, WEST, scene)
        )
        assert why_unreachable(task(arm, EAST, around, scene)) is None
        assert mp.seed_path(arm, EAST, around, scene).n == 3
    result = mp.optimize_path(planar, EAST, WEST, scene, seeding=mp.Seeding(shifts="within-limits"))
    np.testing.assert_allclose(result.path.goal, around)
    arm = planar.with_limits(lower=[-1.0, -np.inf, -np.inf], upper=[4.0, np.inf, np.inf])
    assert why_unreachable(task(arm, EAST, WEST, scene)).endswith(reason)


def test_walls_that_two_joints_cannot_pass(planar):
    """The second link, which cannot fold back, crosses every circle between 1.2 and 1.7 m."""
    walls = [
        replace(each, size=[0.05, 0.5, 0.4], position=(0.0, np.sign(each.position[1]) * 1.45, 0.0)) for each in (NORTH, SOUTH)
    ]
    assert why_unreachable(task(planar, EAST, WEST, mp.Scene(walls))) is None
    assert mp.seed_path(planar, EAST, WEST, mp.Scene(walls)).n == 3
    arm = planar.with_limits(lower=[-np.inf, -1.0, -np.inf], upper=[np.inf, 1.0, np.inf])
    found = why_unreachable(task(arm, EAST, WEST, mp.Scene(walls)))
    assert "every motion of joint1 and joint2 within their limits from start to goal brings two bodies" in found


def shoulder(file, head):
    """An arm as Sawyer's: joint `turn` carries a head of radius `head` and, by `lift` and `roll`, an upper arm beside it."""
    links = {
        "base": "",
        "body": "",
        "head": f'<origin xyz="0 0 0.4"/><geometry><sphere radius="{head}"/></geometry>',
        "side": "",
        "upper": '<origin xyz="0 0 0.25"/><geometry><cylinder radius="0.06" length="0.4"/></geometry>',
        "fore": '<origin xyz="0 0 0.15"/><geometry><cylinder radius="0.04" length="0.2"/></geometry>',
    }
    joints = [
        ("turn", "revolute", "base", "body", "0 0 0.3", "0 0 1", 3.0),
        ("neck", "fixed", "body", "head", "0 0 0", "0 0 1", 0.0),
        ("lift", "revolute", "body", "side", "0 0.15 0.1", "0 1 0", 2.9),
        ("roll", "revolute", "side", "upper", "0 0 0", "0 0 1", 3.0),
        ("elbow", "revolute", "upper", "fore", "0 0 0.5", "0 1 0", 2.0),
    ]
    bodies = [f'<link name="{name}">{text and f"<collision>{text}</collision>"}</link>' for name, text in links.items()]
    for name, kind, parent, child, xyz, axis, limit in joints:
        limits = f'<axis xyz="{axis}"/><limit lower="-{limit}" upper="{limit}" velocity="1" effort="1"/>' if limit else ""
        bodies.append(
            f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}"/>'
            f"{limits}</joint>"
        )
    file.write_text(f'<robot name="shoulder">{"".join(bodies)}</robot>')
    return mp.Robot.from_urdf(file, tool="fore")


def test_an_upper_arm_that_cannot_pass_the_head(tmp_path):
    """Of Sawyer's joints the second and third decide: its upper arm touches the head wherever it is lifted past it."""
    start, goal = [0.3, -1.2, 0.4, 0.5], [-0.4, 1.3, 1.0, -0.5]
    robot = shoulder(tmp_path / "arm.urdf", 0.2)
    model = pin.buildModelFromUrdf(str(robot.source.file))
    geometry = pin.buildGeomFromUrdf(model, str(robot.source.file), pin.GeometryType.COLLISION)
    upper, head = (geometry.getGeometryId(name) for name in ("upper_0", "head_0"))
    geometry.addCollisionPair(pin.CollisionPair(upper, head))
    data, found = model.createData(), pin.GeometryData(geometry)
    for roll in np.linspace(-3.0, 3.0, 61):
        pin.updateGeometryPlacements(model, data, geometry, found, np.array([0.0, 0.0, roll, 0.0]))
        assert pin.computeCollision(geometry, found, 0)
    began = work_time()
    with pytest.raises(
        mp.errors.PlanningError, match="every motion of lift and roll within their limits .* brings head_0 and upper_0"
    ):
        mp.seed_path(robot, start, goal)
    assert work_time() - began < 3.0
    low = shoulder(tmp_path / "low.urdf", 0.06)
    assert why_unreachable(task(low, start, goal, mp.Scene())) is None
    assert mp.seed_path(low, start, goal).n == 4


@pytest.mark.slow
def test_there_is_no_proof_of_joints_inside_the_arm_where_there_is_a_path(tmp_path, rng):
    """Heads of random sizes: some goals are proven to be out of reach, and for none of these is a path found."""
    proven = found = 0
    for k in range(12):
        arm = shoulder(tmp_path / f"{k}.urdf", rng.uniform(0.05, 0.25))
        q = arm.random_configuration(rng, size=60)
        free = q[~mp.Scene().in_collision(arm, q)]
        for start, goal in zip(free[:6], free[6:12], strict=False):
            is_proven = why_unreachable(task(arm, start, goal, mp.Scene())) is not None
            proven += is_proven
            try:
                mp.seed_path(arm, start, goal, seeding=mp.Seeding(time_limit=0.1))
                found += 1
                assert not is_proven
            except mp.errors.PlanningError:
                pass
    assert proven >= 5 and found >= 20, (proven, found)


@pytest.mark.slow
def test_there_is_no_proof_where_there_is_a_path(rng):
    """Random posts around planar arms: some goals are proven to be out of reach, and for none of these is a path found."""
    proven = found = 0
    for k in range(24):
        if k % 8 == 0:
            n = 2 + k // 8 % 2
            arm = mp.planar_arm([1.0, 0.8, 0.5][:n], radius=0.05)
            arm = arm.with_limits(lower=rng.uniform(-3.5, -1.0, n), upper=rng.uniform(1.0, 3.5, n))
        posts = []
        for _ in range(rng.integers(2, 6)):
            angle, far = rng.uniform(-np.pi, np.pi), rng.uniform(0.3, 1.8)
            posts.append(
                mp.Cylinder(radius=rng.uniform(0.05, 0.2), length=0.3, position=(far * np.cos(angle), far * np.sin(angle), 0))
            )
        scene = mp.Scene(posts)
        q = arm.random_configuration(rng, size=30)
        free = q[~scene.in_collision(arm, q)]
        for start, goal in zip(free[:4], free[4:8], strict=False):
            is_proven = why_unreachable(task(arm, start, goal, scene)) is not None
            proven += is_proven
            try:
                mp.seed_path(arm, start, goal, scene, seeding=mp.Seeding(time_limit=0.03))
                found += 1
                assert not is_proven
            except mp.errors.PlanningError:
                pass
    assert proven >= 10 and found >= 25, (proven, found)


@pytest.mark.slow
@pytest.mark.parametrize("arm", ["panda", "ur5"])
def test_there_is_no_proof_for_problems_of_others(arm, monkeypatch):
    """A path is known for each of them."""
    monkeypatch.syspath_prepend(str(OUTSIDE))
    problems = sys.modules.get("problems") or __import__("problems")
    robot = problems.robot(arm)
    for each in problems.load(arm)[5::61]:
        given = task(robot, each.start, each.goal, each.scene)
        began = work_time()
        for one in (given, replace(given, start=given.goal, goal=given.start)):
            assert why_unreachable(one) is None
        assert work_time() - began < 2.0  # 0.1 to 0.7 s


def test_a_search_that_ends_soon_does_not_ask(panda, monkeypatch):
    asked = []
    monkeypatch.setattr("manipplan.seeds.seed.why_unreachable", asked.append)
    scene = mp.Scene([mp.Box(size=[0.1, 0.1, 1.2], position=(0.35, 0.45, 0.3), name="pillar")])
    goal = DOWN + [2.0, 0, 0, 0, 0, 0, 0]
    mp.seed_path(panda, DOWN, goal, scene)
    assert not asked
    monkeypatch.setattr(connect, "PATIENCE", 0)
    mp.seed_path(panda, DOWN, goal, scene)
    assert len(asked) == 1


def test_without_a_proof_the_nearest_bodies_at_the_goal_are_named(planar, monkeypatch):
    monkeypatch.setattr(reachable, "find_barrier", lambda *_: None)
    with pytest.raises(
        mp.errors.PlanningError, match=r"in 0.05 s; .* reached: there link\d_0 and (north|south) are the nearest .* mm"
    ):
        mp.seed_path(planar, EAST, WEST, mp.Scene([NORTH, SOUTH]), seeding=mp.Seeding(time_limit=0.05))


@pytest.mark.parametrize("job", [mp.plan, mp.seed_path, mp.optimize_path])
@pytest.mark.parametrize("scene", [None, mp.Scene([NORTH])])
def test_huge_limits(planar, job, scene):
    arm = planar.with_limits(lower=-1e6, upper=1e6)
    goal = [-np.pi, 0.5, 0.3]
    job(arm, EAST, goal, scene)
    far = round(1e6 / (2 * np.pi) - 1) * 2 * np.pi
    job(arm, [far, 0.5, 0.3], [far - np.pi, 0.5, 0.3], scene)
    began = work_time()
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"goal\[0\]: got 1000000.0; allowed: -1000 to 1000: at most 1000 rad"
    ):
        job(arm, EAST, [1e6, 0.5, 0.3], scene)
    assert work_time() - began < 1.0


GANTRY = """<robot name="gantry"><link name="world"/>
  <link name="bridge"/><link name="trolley"/>
  <link name="hoist"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  {joints}</robot>"""


def gantry(tmp_path, limit):
    links = ["world", "bridge", "trolley", "hoist"]
    joints = "".join(
        f'<joint name="{axis}" type="prismatic"><parent link="{links[k]}"/><child link="{links[k + 1]}"/>'
        f'<axis xyz="{" ".join(str(int(k == i)) for i in range(3))}"/>'
        f'<limit lower="-{limit}" upper="{limit}" velocity="1" effort="1"/></joint>'
        for k, axis in enumerate("xyz")
    )
    file = tmp_path / "gantry.urdf"
    file.write_text(GANTRY.format(joints=joints))
    return mp.Robot.from_urdf(file, tool="hoist")


def test_prismatic_joints_with_huge_limits(tmp_path):
    arm = gantry(tmp_path, 1e6)
    scene = mp.Scene([mp.Box(size=[0.1, 2.0, 2.0], name="wall")])
    path = mp.seed_path(arm, [-1.0, 0, 0], [1.0, 0, 0], scene)
    assert scene.path_clearance(arm, path).proven
    assert np.abs(path.control).max() < 10.0
    with pytest.raises(mp.errors.InvalidInputError, match="at most 1000 rad or m"):
        mp.plan(arm, [-1.0, 0, 0], [1e6, 0, 0], scene)


def test_a_gantry_among_boxes_that_close_a_room(tmp_path):
    """Its three joints are the axes of the world, so the room of the hoist is what the boxes leave; a gap opens it."""
    arm = gantry(tmp_path, 2.0)
    wall = mp.Box(size=[0.02, 5.0, 5.0], name="wall")
    began = work_time()
    with pytest.raises(mp.errors.PlanningError, match="hoist_0 and wall into contact"):
        mp.seed_path(arm, [-0.5, 0, 0], [0.5, 0, 0], mp.Scene([wall]))
    assert work_time() - began < 2.0
    wall = replace(wall, size=[0.02, 5.0, 4.0], position=(0.0, 0.0, -0.4))  # it ends at z = 1.6 m
    assert mp.seed_path(arm, [-0.5, 0, 0], [0.5, 0, 0], mp.Scene([wall])).n == 3
    assert why_unreachable(task(arm, [-0.5, 0, 0], [0.5, 0, 0], mp.Scene([wall]))) is None


@dataclass(frozen=True, kw_only=True, eq=False)
class Ring(Space):
    """Points that keep away from a sphere's surface of radius 1 about the origin, but for a gap around the first axis."""

    gap: float

    def measure(self, centres, half, rows, pairs):
        at = centres[rows]
        along = at[:, 0] / np.linalg.norm(at, axis=1)
        distance = np.abs(np.linalg.norm(at, axis=1) - 1.0)
        to_edge = np.linalg.norm(at - np.eye(len(half))[0], axis=1)
        return np.where(along > np.cos(self.gap), to_edge, distance), np.full(len(rows), np.linalg.norm(half))


@pytest.mark.parametrize("k", [1, 2, 3])
@pytest.mark.parametrize("gap", [0.0, 0.6])
def test_cells_separate_the_inside_of_a_sphere_from_its_outside(k, gap):
    ends = np.zeros(k) + 0.01, np.full(k, 1.5)
    box = {
        "low": np.full(k, -2.0),
        "high": np.full(k, 2.0),
        "goes_on": np.zeros(k, dtype=bool),
        "pairs": np.array([0]),
        "most": 200_000,
    }
    space = Ring(**box, ends=ends, least=0.25, gap=gap)
    closed = find_barrier(space)
    if gap and k > 1:
        assert closed is None
    else:
        small = 0 if k > 1 else 1
        assert closed.pairs == (0,) and closed.end == small
        assert find_barrier(replace(space, ends=ends[::-1])).end == 1 - small
    assert find_barrier(replace(space, least=-1.0)) is None


@dataclass(frozen=True, kw_only=True, eq=False)
class Wall(Space):
    """Points that keep away from x = 0."""

    def measure(self, centres, half, rows, pairs):
        return np.abs(centres[rows, 0]), np.full(len(rows), half[0])


@pytest.mark.parametrize("k", [1, 2, 3])
def test_a_wall_ends_where_an_axis_goes_on(k):
    box = {"low": np.full(k, -2.0), "high": np.full(k, 2.0), "pairs": np.array([0]), "least": 0.3, "most": 100_000}
    wall = Wall(**box, goes_on=np.zeros(k, dtype=bool), ends=(np.full(k, -1.0), np.full(k, 1.0)))
    assert find_barrier(wall) is not None
    assert find_barrier(replace(wall, goes_on=np.arange(k) == 0)) is not None  # both sides of the wall go on, apart
    if k > 1:
        assert find_barrier(replace(wall, goes_on=np.arange(k) == 1)) is None


def test_inscribed_balls_are_inside_and_large(rng):
    for _ in range(20):
        points = rng.normal(size=(30, 3)) * rng.uniform(0.02, 0.2, 3) + rng.normal(size=3)
        place = pin.SE3.Random()
        ball = find_inscribed_ball(pin.GeometryObject("hull", 0, 0, place, convex_hull(points).shape()))
        faces = ConvexHull(points).equations
        inside = -(faces[:, :3] @ place.actInv(ball.centre) + faces[:, 3])
        assert 0 < ball.radius <= inside.min()
        ones = np.ones((len(faces), 1))
        largest = linprog([0, 0, 0, -1], A_ub=np.hstack([faces[:, :3], ones]), b_ub=-faces[:, 3], bounds=[(None, None)] * 4)
        assert ball.radius > 0.8 * largest.x[3]
    for shape, radius in (
        (coal.Sphere(0.2), 0.2),
        (coal.Capsule(0.1, 1.0), 0.1),
        (coal.Cylinder(0.3, 0.4), 0.2),
        (coal.Box(0.2, 0.4, 0.6), 0.1),
    ):
        ball = find_inscribed_ball(pin.GeometryObject("part", 0, 0, pin.SE3.Identity(), shape), 0.01)
        assert ball.radius == pytest.approx(radius + 0.01, abs=1e-5) and not ball.centre.any()
    assert find_inscribed_ball(pin.GeometryObject("plane", 0, 0, pin.SE3.Identity(), coal.Halfspace(np.eye(3)[2], 0.0))) is None
