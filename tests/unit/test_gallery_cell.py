"""The gallery's cell of a mesh, a cloud and a carried part: MuJoCo, with a model of its own, is the judge of its plan.

MuJoCo reads the robot from its URDF and the meshes named there; the walls of the machine are boxes made of the numbers from which
the page writes its STL file; each point of the cloud is a ball.
"""

from pathlib import Path

import mujoco
import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "examples" / "plan" / "plot_cell.py"
#: Maximum difference of two distances [m]. The STL file holds 24 bits, and both libraries iterate.
AGREE = 1e-6
#: Distance up to which distances are compared, and the balls of the cloud are there [m].
NEAR = 0.2


def machine_boxes(page):
    """Centre and half edges [m], in the world, of the boxes that make up the machine's housing and its bed."""
    (deep, left, right, low, high), _, door, door_in, cavity, back = page["HOUSING"]
    _, c_left, c_right, c_low, c_high = cavity
    corners = [
        ((left, 0, low), (c_left, deep, high)),
        ((c_right, 0, low), (right, deep, high)),
        ((c_left, 0, low), (c_right, deep, c_low)),
        ((c_left, 0, c_high), (c_right, deep, high)),
        ((c_left, back[0], c_low), (c_right, deep, c_high)),
        ((c_left, 0, c_low), (door[1], door_in[0], c_high)),
        ((door[2], 0, c_low), (c_right, door_in[0], c_high)),
        ((door[1], 0, c_low), (door[2], door_in[0], door[3])),
        ((door[1], 0, door[4]), (door[2], door_in[0], c_high)),
    ]
    outline, *ends = page["BED"]
    corners.append(((*outline[0], ends[0]), (*outline[2], ends[1])))
    for a, b in 1e-3 * np.array(corners, dtype=float):
        yield (a + b) / 2 + page["MACHINE"], (b - a) / 2


class Judge:
    """The cell in MuJoCo at any configuration."""

    def __init__(self, page, near):
        robot = page["robot"]
        text = robot.source.file.read_text()
        meshes = robot.source.file.parents[1] / "meshes" / "collision"
        compiler = f'<mujoco><compiler meshdir="{meshes}" strippath="true" discardvisual="true" fusestatic="false"/></mujoco>'
        spec = mujoco.MjSpec.from_string(text.replace("</robot>", compiler + "</robot>"))
        for geom in spec.geoms:
            geom.name = f"{geom.parent.name}:{len(geom.parent.geoms)}:{id(geom)}"
            geom.contype, geom.conaffinity = 2, 1
        world = {"contype": 1, "conaffinity": 0}
        box = mujoco.mjtGeom.mjGEOM_BOX
        self.obstacles = {}

        def add(name, **values):
            geom = spec.worldbody.add_geom(name=f"{name}:{len(self.obstacles)}", **world, **values)
            self.obstacles[geom.name] = name

        for centre, half in machine_boxes(page):
            add("machine", type=box, pos=centre, size=half)
        outline, low, high = page["SPINDLE"]
        corners = 1e-3 * np.concatenate([np.c_[outline, np.full(len(outline), z)] for z in (low, high)])
        spec.add_mesh(name="spindle", uservert=(corners + page["MACHINE"]).ravel())
        add("machine", type=mujoco.mjtGeom.mjGEOM_MESH, meshname="spindle")
        table, part = page["table"], page["workpiece"]
        add("table", type=box, pos=table.position, size=np.asarray(table.size) / 2)
        add("floor", type=mujoco.mjtGeom.mjGEOM_PLANE, pos=page["floor"].position, size=[5, 5, 0.1])
        for point in near:
            add("scan", type=mujoco.mjtGeom.mjGEOM_SPHERE, pos=point, size=[page["scan"].parts()[0].radius, 0, 0])
        hand = next(body for body in spec.bodies if body.name == "panda_hand_tcp")
        placed = np.linalg.inv(page["pick"]) @ part.pose.homogeneous
        quat = np.empty(4)
        mujoco.mju_mat2Quat(quat, placed[:3, :3].ravel())
        half = np.asarray(part.size) / 2
        hand.add_geom(name="workpiece", type=box, pos=placed[:3, 3], quat=quat, size=half, contype=2, conaffinity=1, mass=0.1)
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)
        self.joints = [self.model.joint(name).qposadr[0] for name in robot.joint_names]
        for name, value in robot.locked.items():
            self.data.qpos[self.model.joint(name).qposadr[0]] = value
        self.bodies = {}
        for k in range(self.model.ngeom):
            if self.model.geom(k).name not in self.obstacles:
                body = self.model.body(self.model.geom_bodyid[k]).name
                self.bodies[k] = "workpiece" if self.model.geom(k).name == "workpiece" else body
        self.obstacles = {self.model.geom(name).id: obstacle for name, obstacle in self.obstacles.items()}

    def place(self, q):
        self.data.qpos[self.joints] = q
        mujoco.mj_kinematics(self.model, self.data)

    def contacts(self, q, margin=0.0):
        """Pairs of names that are nearer than `margin` [m]; with 0, of which MuJoCo reports a contact.

        MuJoCo's contacts of two boxes apart state a distance along one axis, which may be less than the true one. So contacts
        within a margin are measured by mj_geomDistance.
        """
        self.model.geom_margin[list(self.obstacles)] = margin
        self.place(q)
        mujoco.mj_comPos(self.model, self.data)
        mujoco.mj_collision(self.model, self.data)
        found = set()
        for contact in self.data.contact:
            a, b = sorted(contact.geom, key=lambda k: k in self.obstacles)
            if margin == 0 or mujoco.mj_geomDistance(self.model, self.data, a, b, NEAR, None) < margin:
                found.add((self.bodies[a], self.obstacles[b]))
        return found - {("panda_link0", name) for name in ("table", "floor", "scan", "machine")}

    def distances(self, q):
        """Smallest distance of each link or part to each obstacle [m], where it is below NEAR."""
        self.place(q)
        found = {}
        for body, link in self.bodies.items():
            for geom, obstacle in self.obstacles.items():
                apart = mujoco.mj_geomDistance(self.model, self.data, body, geom, NEAR, None)
                found[link, obstacle] = min(found.get((link, obstacle), NEAR), apart)
        return found


@pytest.fixture(scope="module")
def samples(page):
    """Configurations along the motion, 5 mrad apart."""
    path = page["plan"].trajectory.path()
    return path(path.fine_samples(5e-3))


@pytest.fixture(scope="module")
def judge(page, samples):
    scan = page["scan"]
    points = scan.kept @ scan.pose.rotation.T + scan.pose.translation
    placed = page["kinematics"].pose(samples)[:, :3, 3]  # of the tool; the links that come near the cloud are within 0.4 m
    near = np.array([np.linalg.norm(placed - point, axis=1).min() < 0.4 + NEAR for point in points])
    assert near.sum() > 1000
    return Judge(page, points[near])


def ours(page, q):
    """The same by the library."""
    scene, robot = page["free"], page["carrying"]
    found = {}
    for (body, obstacle), apart in zip(scene.collision_model(robot).pair_names, scene.distances(robot, q), strict=True):
        other = obstacle.split(".")[0]
        link = body if body == "workpiece" else body.rpartition("_")[0]
        if other in scene.names:
            found[link, other] = min(found.get((link, other), NEAR), float(apart))
    return found


@pytest.mark.slow
def test_every_pixel_is_in_a_ball(page):
    """The points by another formula than the library's: all are inside the balls that are kept."""
    from scipy.spatial import cKDTree

    image, scan = page["image"], page["scan"]
    v, u = np.nonzero(np.isfinite(image) & (image > 0))
    pixel = np.linalg.inv([[page["FOCAL"], 0, page["WIDTH"] / 2], [0, page["FOCAL"], page["HEIGHT"] / 2], [0, 0, 1]])
    points = np.c_[(pixel @ [u, v, np.ones_like(u)]).T * image[v, u, None], np.ones(len(u))] @ page["camera"][:3].T
    assert len(points) == len(scan.points) >= 20_000
    kept = scan.kept @ scan.pose.rotation.T + scan.pose.translation
    assert cKDTree(kept).query(points)[0].max() <= scan.parts()[0].radius - 0.008 + 1e-9


@pytest.mark.slow
def test_the_walls_are_the_machine(page):
    """Boxes for MuJoCo and triangles of the STL file enclose the same volume."""
    trimesh = pytest.importorskip("trimesh")
    housing = trimesh.Trimesh(**trimesh.triangles.to_kwargs(1e-3 * np.array(page["housing"], dtype=float)))
    assert housing.is_watertight
    walls = list(machine_boxes(page))[:-1]
    assert sum(8 * half.prod() for _, half in walls) == pytest.approx(housing.volume, rel=1e-9)
    assert page["stl"].stat().st_size < 100_000


@pytest.mark.slow
def test_mujoco_finds_the_planned_clearance(page, judge, samples):
    assert page["plan"].report.passed
    assert len(samples) > 400
    margin = page["clearance"] - 1e-6
    assert [pairs for q in samples if (pairs := judge.contacts(q, margin))] == []


@pytest.mark.slow
def test_distances_are_mujoco_s(page, judge, samples):
    compared = 0
    for q in samples[::20]:
        theirs, own = judge.distances(q), ours(page, q)
        for pair, apart in own.items():
            assert apart == pytest.approx(theirs[pair], abs=AGREE), pair
            compared += apart < NEAR
    assert compared > 100


@pytest.mark.slow
def test_both_find_the_same_collisions(page, judge, samples):
    """On the straight line, at random configurations near the motion, and with the part pushed into the bed."""
    scene, robot, rng = page["free"], page["carrying"], np.random.default_rng(3)
    line = np.linspace(page["start"], page["goal"], 60)
    around = samples[rng.integers(len(samples), size=200)] + rng.normal(scale=0.15, size=(200, robot.n))
    pushed = page["goal"] + np.outer(np.linspace(0, 0.2, 20), np.eye(robot.n)[1])
    pairs = scene.collision_model(robot).pair_names
    columns = [k for k, (_, other) in enumerate(pairs) if other.split(".")[0] in scene.names]
    count = {True: 0, False: 0}
    for q in np.clip(np.concatenate([line, around, pushed]), robot.limits.lower, robot.limits.upper):
        least = scene.distances(robot, q)[columns].min()
        if abs(least) < 1e-4:
            continue
        touching = bool(judge.contacts(q))
        assert touching == (least < 0), (least, judge.contacts(q))
        assert scene.in_collision(robot, q) or not touching
        count[touching] += 1
    assert min(count.values()) > 50


@pytest.mark.slow
def test_the_carried_part_leaves_the_table_at_once(page):
    assert page["rising"].min() > -1e-4 and page["rising"][-1] == pytest.approx(0.02, abs=1e-6)
