"""Arms of MuJoCo Menagerie, judged by MuJoCo's own compiled models: poses, Jacobians, limits, contacts, and plans.

Run with `python benchmarks/menagerie.py FOLDER`, where FOLDER is a checkout of MuJoCo Menagerie (default: the environment
variable MUJOCO_MENAGERIE). Writes docs/benchmarks/menagerie.md.

A contact of MuJoCo is one at a distance of at most zero between geoms that an active joint moves relative to each other.
MuJoCo takes the convex hull of a mesh, the library the mesh itself. So where MuJoCo alone finds a contact, the triangles of its
compiled meshes decide, by coal, and by their solid angle whether one is inside the other.
"""

import argparse
import os
import platform
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import coal
import mujoco
import numpy as np
import trimesh
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "menagerie.md"
VARIABLE = "MUJOCO_MENAGERIE"
#: Angle or length between samples of a motion [rad or m].
STEP = 2e-3
#: The files, with the tool where the description does not say which of its ends is meant.
FILES: dict[str, dict[str, Any]] = {
    "agilex_piper/piper.xml": {},
    "aloha/aloha.xml": {"tool": "left/gripper_base"},
    "apptronik_apollo/apptronik_apollo.xml": {"tool": "l_wrist_pitch_link"},
    "arx_l5/arx_l5.xml": {},
    "booster_t1/t1.xml": {"tool": "left_hand_link"},
    "boston_dynamics_spot/spot_arm.xml": {"tool": "arm_link_wr1"},
    "dynamixel_2r/dynamixel_2r.xml": {},
    "flexiv_rizon4/flexiv_rizon4.xml": {},
    "fourier_n1/n1.xml": {"tool": "left_end_effector_link"},
    "franka_emika_panda/mjx_panda.xml": {},
    "franka_emika_panda/panda.xml": {},
    "franka_emika_panda/panda_nohand.xml": {},
    "franka_fr3/fr3.xml": {},
    "franka_fr3_v2/fr3v2.xml": {},
    "google_robot/robot.xml": {},
    "hello_robot_stretch/stretch.xml": {"tool": "link_gripper_slider"},
    "hello_robot_stretch_3/stretch.xml": {"tool": "link_SG3_gripper_body"},
    "i2rt_yam/yam.xml": {},
    "kinova_gen3/gen3.xml": {},
    "kuka_iiwa_14/iiwa14.xml": {},
    "low_cost_robot_arm/low_cost_robot_arm.xml": {},
    "pal_talos/talos.xml": {"tool": "arm_left_7_link"},
    "pal_tiago/tiago.xml": {"tool": "arm_7_link"},
    "pal_tiago_dual/tiago_dual.xml": {"tool": "arm_left_7_link"},
    "pndbotics_adam_lite/adam_lite.xml": {"tool": "wristYawLeft"},
    "rethink_robotics_sawyer/sawyer.xml": {},
    "robotis_op3/op3.xml": {"tool": "l_el_link"},
    "robotstudio_so101/so101.xml": {},
    "stanford_tidybot/tidybot.xml": {},
    "toddlerbot_2xc/toddlerbot_2xc.xml": {"tool": "left_wrist_pitch_link"},
    "toddlerbot_2xm/toddlerbot_2xm.xml": {"tool": "left_wrist_pitch_link"},
    "trossen_vx300s/vx300s.xml": {},
    "trossen_wx250s/wx250s.xml": {},
    "trossen_wxai/trossen_ai_bimanual.xml": {"tool": "left/link_6"},
    "trs_so_arm100/so_arm100.xml": {},
    "ufactory_lite6/lite6.xml": {},
    "ufactory_lite6/lite6_gripper_narrow.xml": {},
    "ufactory_lite6/lite6_gripper_wide.xml": {},
    "ufactory_xarm7/xarm7.xml": {},
    "ufactory_xarm7/xarm7_nohand.xml": {},
    "unitree_g1/g1.xml": {"tool": "left_wrist_yaw_link"},
    "unitree_g1/g1_with_hands.xml": {"tool": "left_wrist_yaw_link"},
    "unitree_h1/h1.xml": {"tool": "left_elbow_link"},
    "unitree_z1/z1.xml": {},
    "unitree_z1/z1_gripper.xml": {},
    "universal_robots_ur5e/ur5e.xml": {},
    "universal_robots_ur10e/ur10e.xml": {},
}
HULL, DROPPED, OTHER = "hull", "dropped", "other"
HEAD = (
    "| file | tool | joints | load [s] | pose; J | limits | postures in contact: both "
    "| MuJoCo only: hulls; by construction; other | library only | plans | contacts on them: hulls; by construction; other |"
)


@dataclass(kw_only=True)
class Row:
    """What was measured of one file."""

    file: str
    fault: str = ""
    tool: str = ""
    joints: int = 0
    load: float = 0.0
    pose: float = 0.0
    jacobian: float = 0.0
    limits: bool = False
    both: int = 0
    alone: int = 0
    missed: Counter[str] = field(default_factory=Counter)
    statuses: Counter[str] = field(default_factory=Counter)
    contacts: Counter[str] = field(default_factory=Counter)
    notes: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        if self.fault:
            return f"| `{self.file}` | {self.fault} |" + " |" * 9
        three = (HULL, DROPPED, OTHER)
        cells = [
            f"`{self.file}`",
            f"`{self.tool}`",
            str(self.joints),
            f"{self.load:.1f}",
            f"{self.pose:.0e}; {self.jacobian:.0e}",
            "equal" if self.limits else "**differ**",
            str(self.both),
            "; ".join(str(self.missed[each]) for each in three),
            str(self.alone),
            ", ".join(f"{count} {name}" for name, count in self.statuses.most_common()),
            "; ".join(str(self.contacts[each]) for each in three),
        ]
        return f"| {' | '.join(cells)} |"


class Judge:
    """MuJoCo's model of a file, with the joints of a robot."""

    def __init__(self, file: Path, robot: mp.Robot) -> None:
        self.model = mujoco.MjModel.from_xml_path(str(file))
        self.data = mujoco.MjData(self.model)
        self.joints = [self.model.joint(name) for name in robot.joint_names]
        for name, value in robot.locked.items():
            joint = self.model.joint(name)
            if self.model.jnt_type[joint.id] in (2, 3):
                self.data.qpos[joint.qposadr[0]] = value
        self.couplings = [  # follower, leader, polynomial about their references
            (int(self.model.eq_obj1id[k]), int(self.model.eq_obj2id[k]), self.model.eq_data[k, :2])
            for k in range(self.model.neq)
            if self.model.eq_type[k] == mujoco.mjtEq.mjEQ_JOINT and self.model.eq_active0[k] and self.model.eq_obj2id[k] >= 0
        ]
        self.slopes = np.zeros((self.model.nv, robot.n))  # of all joints, by those of the arm
        for k, joint in enumerate(self.joints):
            self.slopes[joint.dofadr[0], k] = 1.0
        for follower, leader, line in self.couplings * len(self.couplings):  # followers of followers too
            follows, leads = self.model.jnt_dofadr[[follower, leader]]
            if self.slopes[leads].any():
                self.slopes[follows] = line[1] * self.slopes[leads]
        moved = np.flatnonzero(self.slopes.any(axis=1))
        active = {int(self.model.dof_bodyid[dof]) for dof in moved}
        self.mover = [0] * self.model.nbody  # the body of the last active joint that carries each body
        for body in range(1, self.model.nbody):
            self.mover[body] = body if body in active else self.mover[self.model.body_parentid[body]]
        self.meshes: dict[int, trimesh.Trimesh] = {}
        dropped = mp.Scene().collision_model(robot).dropped
        self.reasons = {frozenset(each.split(".")[0] for each in pair): reason for pair, reason in dropped.items()}
        self.names = self._names(robot)

    def _names(self, robot: mp.Robot) -> dict[int, tuple[str, str]]:
        """The library's name of each colliding geom, and its link, found by the place of the geom in its body's list."""
        found, bodies = {}, Counter[int]()
        own = {item.name: robot.link_of(item) for item in robot.geometry.geometryObjects}
        paired = {*self.model.pair_geom1.tolist(), *self.model.pair_geom2.tolist()}
        for k in range(self.model.ngeom):
            if not (self.model.geom_contype[k] or self.model.geom_conaffinity[k] or k in paired):
                continue
            body, name = int(self.model.geom_bodyid[k]), self.model.geom(k).name
            if not name:
                name = f"{self.model.body(body).name}_{bodies[body]}"
                bodies[body] += 1
            found[k] = name, own[name]
        return found

    def place(self, q: np.ndarray) -> None:
        """Put the arm at q (n,)."""
        for joint, value in zip(self.joints, q, strict=True):
            self.data.qpos[joint.qposadr[0]] = value
        for follower, leader, line in self.couplings * len(self.couplings):
            follows, leads = self.model.jnt_qposadr[[follower, leader]]
            if self.slopes[self.model.jnt_dofadr[leader]].any():
                offset = self.data.qpos[leads] - self.model.qpos0[leads]
                self.data.qpos[follows] = self.model.qpos0[follows] + line[0] + line[1] * offset
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)

    def contacts(self, q: np.ndarray) -> list[tuple[str, tuple[int, int], float]]:
        """Kind, geoms and depth [m] of the contacts between bodies that active joints move relative to each other."""
        self.place(q)
        mujoco.mj_collision(self.model, self.data)
        pairs: dict[tuple[int, int], float] = {}
        for contact in self.data.contact:
            a, b = sorted(int(each) for each in contact.geom)
            if contact.dist <= 0 and self.mover[self.model.geom_bodyid[a]] != self.mover[self.model.geom_bodyid[b]]:
                pairs[a, b] = max(pairs.get((a, b), 0.0), -float(contact.dist))
        return [(self.kind(pair), pair, depth) for pair, depth in pairs.items()]

    def kind(self, pair: tuple[int, int]) -> str:
        """Whether only hulls touch, the library leaves the pair out since it touches by construction, or neither."""
        names = [self.names.get(each, ("", "")) for each in pair]
        for chosen in (frozenset(each[0] for each in names), frozenset(each[1] for each in names)):
            reason = self.reasons.get(chosen, "")
            if reason.startswith(("touching", "parent")):
                return DROPPED
        return OTHER if self.touch(*pair) else HULL

    def touch(self, a: int, b: int) -> bool:
        """Whether two geoms touch, meshes taken by their triangles, closed ones as solid."""
        shapes = [self.shape(each) for each in (a, b)]
        places = [coal.Transform3s(self.data.geom_xmat[each].reshape(3, 3), self.data.geom_xpos[each]) for each in (a, b)]
        if coal.collide(shapes[0], places[0], shapes[1], places[1], coal.CollisionRequest(), coal.CollisionResult()):
            return True
        return self.inside(a, b) or self.inside(b, a)

    def inside(self, a: int, b: int) -> bool:
        """Whether a point of geom a, its centre or a corner, is in the closed mesh b."""
        if self.model.geom_type[b] != mujoco.mjtGeom.mjGEOM_MESH or not self.mesh(b).is_watertight:
            return False
        points = np.zeros((1, 3))
        if self.model.geom_type[a] == mujoco.mjtGeom.mjGEOM_MESH:
            points = self.mesh(a).vertices[:1]
        places = [(self.data.geom_xmat[each].reshape(3, 3), self.data.geom_xpos[each]) for each in (a, b)]
        world = points @ places[0][0].T + places[0][1]
        corners = self.mesh(b).triangles - (world - places[1][1]) @ places[1][0]
        first, second, third = np.moveaxis(corners, 1, 0)
        lengths = np.linalg.norm(corners, axis=2)
        volume = np.einsum("ij,ij->i", first, np.cross(second, third))
        dots = [np.einsum("ij,ij->i", *pair) for pair in ((second, third), (first, third), (first, second))]
        half = np.arctan2(volume, lengths.prod(axis=1) + sum(dots[i] * lengths[:, i] for i in range(3)))
        return bool(abs(half.sum()) > np.pi)  # the solid angle of the whole surface, halved, is 2 pi inside and 0 outside

    def mesh(self, geom: int) -> trimesh.Trimesh:
        """The triangles of a geom's mesh, after compilation."""
        number = int(self.model.geom_dataid[geom])
        if number not in self.meshes:
            mesh = self.model.mesh(number)
            vertices = self.model.mesh_vert[mesh.vertadr[0] : mesh.vertadr[0] + mesh.vertnum[0]]
            faces = self.model.mesh_face[mesh.faceadr[0] : mesh.faceadr[0] + mesh.facenum[0]]
            self.meshes[number] = trimesh.Trimesh(vertices.astype(float), faces, process=True)
        return self.meshes[number]

    def shape(self, geom: int) -> coal.CollisionGeometry:
        """A geom as a shape of coal."""
        kind, size = mujoco.mjtGeom(int(self.model.geom_type[geom])).name, self.model.geom_size[geom]
        if kind == "mjGEOM_MESH":
            mesh, surface = self.mesh(geom), coal.BVHModelOBBRSS()
            surface.beginModel(len(mesh.faces), len(mesh.vertices))
            surface.addVertices(np.asarray(mesh.vertices))
            surface.addTriangles(np.asarray(mesh.faces))
            surface.endModel()
            return surface
        shapes = {
            "mjGEOM_PLANE": lambda: coal.Halfspace(np.array([0.0, 0.0, 1.0]), 0.0),
            "mjGEOM_SPHERE": lambda: coal.Sphere(size[0]),
            "mjGEOM_CAPSULE": lambda: coal.Capsule(size[0], 2 * size[1]),
            "mjGEOM_CYLINDER": lambda: coal.Cylinder(size[0], 2 * size[1]),
            "mjGEOM_ELLIPSOID": lambda: coal.Ellipsoid(*size),
            "mjGEOM_BOX": lambda: coal.Box(*(2 * size)),
        }
        return shapes[kind]()


def measure(folder: Path, file: str, options: dict[str, Any], postures: int, plans: int, time_limit: float) -> Row:
    """Everything about one file."""
    row = Row(file=file)
    began = time.perf_counter()
    try:
        robot = mp.load_robot(folder / file, velocity=2.0, **options)
    except mp.errors.ManipplanError as error:
        row.fault = f"{type(error).__name__}: {str(error).partition('allowed: ')[2][:160]}"
        return row
    mp.Scene().collision_model(robot)
    row.load, row.tool, row.joints = time.perf_counter() - began, robot.tool, robot.n
    judge, rng = Judge(folder / file, robot), np.random.default_rng(0)
    kinematics(row, robot, judge, rng)
    verdicts(row, robot, judge, robot.random_configuration(rng, size=postures))
    for k in range(plans):
        plan(row, robot, judge, rng, k, time_limit)
    return row


def kinematics(row: Row, robot: mp.Robot, judge: Judge, rng: np.random.Generator) -> None:
    """Poses and Jacobians of the tool, and the limits."""
    kin = robot.kinematics(mp.Task.pose(length=1.0), compiled=False)
    body = mujoco.mj_name2id(judge.model, mujoco.mjtObj.mjOBJ_BODY, robot.tool)
    site = mujoco.mj_name2id(judge.model, mujoco.mjtObj.mjOBJ_SITE, robot.tool) if body < 0 else -1
    for q in robot.random_configuration(rng, size=20):
        judge.place(q)
        theirs = np.eye(4)
        linear, angular = np.zeros((2, 3, judge.model.nv))
        if site < 0:
            theirs[:3, 3], theirs[:3, :3] = judge.data.xpos[body], judge.data.xmat[body].reshape(3, 3)
            mujoco.mj_jacBody(judge.model, judge.data, linear, angular, body)
        else:
            theirs[:3, 3], theirs[:3, :3] = judge.data.site_xpos[site], judge.data.site_xmat[site].reshape(3, 3)
            mujoco.mj_jacSite(judge.model, judge.data, linear, angular, site)
        row.pose = max(row.pose, float(np.abs(kin.pose(q) - theirs).max()))
        difference = kin.jacobian(q) - np.concatenate([linear, angular]) @ judge.slopes
        row.jacobian = max(row.jacobian, float(np.abs(difference).max()))
    ranges = [
        judge.model.jnt_range[joint.id] if judge.model.jnt_limited[joint.id] else (-np.inf, np.inf) for joint in judge.joints
    ]
    row.limits = bool((np.array(ranges) == np.column_stack([robot.limits.lower, robot.limits.upper])).all())


def verdicts(row: Row, robot: mp.Robot, judge: Judge, postures: np.ndarray) -> None:
    """Contacts in random postures; of those that MuJoCo finds alone the gravest kind counts."""
    ours = mp.Scene().in_collision(robot, postures)
    for q, touching in zip(postures, ours, strict=True):
        found = judge.contacts(q)
        kinds = {kind for kind, _, _ in found}
        row.both += bool(touching and kinds)
        row.alone += bool(touching and not kinds)
        if not touching and kinds:
            row.missed[next(each for each in (OTHER, DROPPED, HULL) if each in kinds)] += 1
        if touching and not kinds:
            model = mp.Scene().collision_model(robot)
            row.notes.append(f"library only: {model.nearest_bodies(q[None])[0]}")
        row.notes += [described(judge, pair, depth) for kind, pair, depth in found if kind == OTHER and not touching]


def described(judge: Judge, pair: tuple[int, int], depth: float) -> str:
    """Two geoms in contact, for the log."""
    names = " and ".join(judge.names.get(each, (f"geom {each}", ""))[0] for each in pair)
    return f"MuJoCo only: {names} {1e3 * depth:.2f} mm"


def plan(row: Row, robot: mp.Robot, judge: Judge, rng: np.random.Generator, seed: int, time_limit: float) -> None:
    """One plan between free random postures, and the contacts at samples of it."""
    free = (q for q in (robot.random_configuration(rng) for _ in range(2000)) if not mp.Scene().in_collision(robot, q))
    start, goal = next(free, None), next(free, None)
    if goal is None:
        row.statuses["no free posture"] += 1
        return
    try:
        made = mp.plan(robot, start, goal, seeding=mp.Seeding(seed=seed, time_limit=time_limit), throw=False)
    except mp.errors.ManipplanError as error:
        row.statuses[type(error).__name__] += 1
        row.notes.append(f"plan: {error}")
        return
    row.statuses[made.status.name] += 1
    if made.path is None or not made.report.passed:
        return
    kinds = set[str]()
    for q in made.path(made.path.fine_samples(STEP)):
        for kind, pair, depth in judge.contacts(q):
            kinds.add(kind)
            if kind == OTHER:
                row.notes.append(f"on a plan, {described(judge, pair, depth)}")
    row.contacts.update(kinds)


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, nargs="?", default=os.environ.get(VARIABLE), help="a checkout of MuJoCo Menagerie")
    parser.add_argument("--files", default="*", help="pattern of the files, such as 'unitree*'")
    parser.add_argument("--postures", type=int, default=200, help="number of random postures of each arm")
    parser.add_argument("--plans", type=int, default=3, help="number of plans of each arm")
    parser.add_argument("--time-limit", type=float, default=10.0, help="time limit of a plan [s]")
    parser.add_argument("--out", type=Path, default=OUT, help="the table's file")
    options = parser.parse_args(arguments)
    if options.folder is None or not Path(options.folder).is_dir():
        parser.error(f"give the folder of a checkout of MuJoCo Menagerie, or set {VARIABLE}")
    chosen = [file for file in FILES if fnmatch(file, options.files) and (options.folder / file).is_file()]
    rows = []
    for file in track(chosen, "arms"):
        row = measure(options.folder, file, FILES[file], options.postures, options.plans, options.time_limit)
        rows.append(row)
        print(row, flush=True)
        for note, count in Counter(row.notes).most_common(12):
            print(f"    {count} x {note}", flush=True)
    read = [row for row in rows if not row.fault]
    statuses: Counter[str] = sum((row.statuses for row in read), Counter())
    told = ", ".join(f"{count} {name}" for name, count in statuses.most_common())
    missed: Counter[str] = sum((row.missed for row in read), Counter())
    contacts: Counter[str] = sum((row.contacts for row in read), Counter())
    lines = [
        HEAD,
        "|---" * 11 + "|",
        *map(str, rows),
        "",
        f"{len(read)} of {len(rows)} files. Largest error of a pose {max((row.pose for row in read), default=0):.0e}, of a "
        f"Jacobian {max((row.jacobian for row in read), default=0):.0e}; limits equal in {sum(row.limits for row in read)}. "
        f"{options.postures} postures each: {sum(row.both for row in read)} in contact by both, MuJoCo only {missed[HULL]} by "
        f"hulls, {missed[DROPPED]} by construction, {missed[OTHER]} others; library only {sum(row.alone for row in read)}. "
        f"Plans: {told}; {contacts[OTHER]} of them in contact, {contacts[DROPPED]} of pairs left out, {contacts[HULL]} of "
        "hulls.",
        "",
        f"MuJoCo {mujoco.__version__}; Python {platform.python_version()}, {platform.machine()}; command: "
        "`python benchmarks/menagerie.py FOLDER`.",
    ]
    options.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(lines[-3])


if __name__ == "__main__":
    main()
