"""Robots of MJCF files: MuJoCo compiles the file, and its model becomes a description, number by number.

MuJoCo applies defaults, includes, frames, mesh scales and orientations of all kinds. What is taken over is its result: the
positions of joints are MuJoCo's `qpos`, and the limits its `jnt_range`. Free bodies stay where the file has them.
"""

import logging
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.robots.description import Description, check_origins, check_sizes
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.mesh_files import triangle_tree
from manipplan.robots.mjcf_files import MOST_HEIGHTS, compile_mjcf
from manipplan.robots.model_tree import WORLD, Mimic, first_leaders, joint_about
from manipplan.robots.xml_files import MOST_BODIES, MOST_JOINTS
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError

log = logging.getLogger("manipplan")

#: MuJoCo's kinds of joints and geoms, by their numbers.
JOINTS = ("free", "ball", "slide", "hinge")
SHAPES = ("plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "sdf")
#: MuJoCo's kinds of equality constraints.
EQUALITIES = ("connect", "weld", "joint", "tendon", "flex", "flexvert", "flexstrain", "distance")
#: Number of groups of geoms that MuJoCo's viewer draws by default.
DRAWN_GROUPS = 3
#: Why two geoms are not checked against each other.
ONE_BODY, ADJACENT = "one rigid body", "parent and child body of one joint"
EXCLUDED, MASKED = "excluded in the file (<exclude>)", "masks of the file (contype, conaffinity)"
#: Bits of MuJoCo's flags: parent and child bodies are checked as well.
FILTER_PARENT = "mjDSBL_FILTERPARENT"


def read_mjcf(file: Path) -> Description:
    """The robot of an MJCF file; raises as `compile_mjcf`, and FileFormatError that names what a robot cannot have."""
    mj = compile_mjcf(file)
    colliding = colliding_geoms(file, mj)
    names = _joint_names(mj)
    model, frames = _tree(file, mj, names)
    geometry = _geometry(file, mj, model, frames, colliding)
    check_origins(file, model, geometry)
    check_sizes(file, model, geometry)
    _log_left_out(file, mj)
    return Description(
        file=file,
        source="MJCF",
        model=model,
        geometry=geometry,
        mimics=_couplings(file, mj, names),
        unchecked=_find_unchecked(mj, colliding, [item.name for item in geometry.geometryObjects]),
    )


def read_visuals(file: Path) -> tuple[pin.Model, pin.GeometryModel]:
    """The robot of an MJCF file with the geoms that MuJoCo's viewer draws, in their colours."""
    mj = compile_mjcf(file)
    model, frames = _tree(file, mj, _joint_names(mj))
    drawn = [k for k in range(mj.ngeom) if mj.geom_group[k] < DRAWN_GROUPS and _colour(mj, k)[3] > 0]
    return model, _geometry(file, mj, model, frames, drawn)


def local_pose(position: Array, quaternion: Array) -> pin.SE3:
    """A pose from MuJoCo's position (3,) and quaternion (4,), whose real part is the first."""
    w, x, y, z = quaternion
    return pin.SE3(pin.Quaternion(w, x, y, z).normalized().matrix(), np.asarray(position))


def stands_still(mj: Any, body: int) -> bool:
    """Whether no joint moves a body."""
    while body > 0 and not mj.body_jntnum[body]:
        body = int(mj.body_parentid[body])
    return body == 0


def fixed_pose(mj: Any, body: int) -> pin.SE3:
    """The pose in the world of a body that no joint moves."""
    pose = pin.SE3.Identity()
    while body > 0:
        pose = local_pose(mj.body_pos[body], mj.body_quat[body]) * pose
        body = int(mj.body_parentid[body])
    return pose


def surface_of(file: Path, mj: Any, geom: int) -> tuple[Array, NDArray[np.int64]]:
    """Vertices (k, 3) [m] and triangles (t, 3) of a mesh or height field, in the frame of its geom.

    Raises FileFormatError for a mesh without triangles or with vertices farther away than `FARTHEST`, and for a height field of
    more than `MOST_HEIGHTS` heights.
    """
    number = int(mj.geom_dataid[geom])
    if SHAPES[mj.geom_type[geom]] == "hfield":
        return _height_field(file, mj, number)
    vertices, faces = (
        np.array(values[start : start + count])
        for values, start, count in (
            (mj.mesh_vert, mj.mesh_vertadr[number], mj.mesh_vertnum[number]),
            (mj.mesh_face, mj.mesh_faceadr[number], mj.mesh_facenum[number]),
        )
    )
    if not len(faces) or not (np.abs(vertices) <= FARTHEST).all():
        wanted = f"meshes with triangles and finite vertices within {FARTHEST:g} m, unlike {mj.mesh(number).name}"
        raise FileFormatError("file", str(file), wanted)
    return vertices.astype(float), faces.astype(np.int64)


def colliding_geoms(file: Path, mj: Any) -> list[int]:
    """The geoms that can touch others: by their masks, or because a `<pair>` names them.

    Raises FileFormatError for more than `MOST_BODIES`.
    """
    collides = (mj.geom_contype != 0) | (mj.geom_conaffinity != 0)
    collides[mj.pair_geom1] = collides[mj.pair_geom2] = True
    found: list[int] = np.flatnonzero(collides).tolist()
    if len(found) > MOST_BODIES:
        raise FileFormatError("file", str(file), f"at most {MOST_BODIES} colliding geoms, not {len(found)}")
    return found


# ---- bodies and joints


def _tree(file: Path, mj: Any, names: Sequence[str]) -> tuple[pin.Model, list[int]]:
    """The joints, frames and masses of a compiled model, and the frame of each body; `names` are those of the joints."""
    model = pin.Model()
    model.name = mj.names.split(b"\0", 1)[0].decode()
    model.gravity = pin.Motion(np.asarray(mj.opt.gravity), np.zeros(3))
    bodies = _body_names(mj)
    for name in (*names, *bodies[1:], *(mj.site(k).name for k in range(mj.nsite))):
        if name == WORLD:
            wanted = f"joints, bodies and sites with other names than {WORLD!r}, Pinocchio's name for the world"
            raise FileFormatError("file", str(file), wanted)
    if mj.njnt > MOST_JOINTS or mj.nbody - 1 > MOST_JOINTS:
        raise FileFormatError("file", str(file), f"at most {MOST_JOINTS} joints and bodies, not {mj.njnt} and {mj.nbody - 1}")
    armature, frames = list[float](), [0]
    for body in range(1, mj.nbody):
        frame = frames[mj.body_parentid[body]]
        joint, placement = int(model.frames[frame].parentJoint), model.frames[frame].placement
        placement = placement * local_pose(mj.body_pos[body], mj.body_quat[body])
        moving = _joints_of(mj, body)
        for k in moving:
            joint, placement = _add_joint(model, mj, joint, placement, k, names[k])
            start, count = int(mj.jnt_dofadr[k]), model.joints[joint].nv
            armature += mj.dof_armature[start : start + count].tolist()
            frame = model.addJointFrame(joint, frame)
        if not moving:
            fixed = pin.Frame(f"{bodies[body]}_fixed", joint, frame, placement, pin.FrameType.FIXED_JOINT)
            frame = model.addFrame(fixed, False)
        frames.append(model.addFrame(pin.Frame(bodies[body], joint, frame, placement, pin.FrameType.BODY), False))
        inner = local_pose(mj.body_ipos[body], mj.body_iquat[body])
        inertia = pin.Inertia(float(mj.body_mass[body]), np.zeros(3), np.diag(mj.body_inertia[body]))
        model.appendBodyToJoint(joint, inertia, placement * inner)
    model.armature = np.array(armature)
    for k in range(mj.nsite):
        site = mj.site(k)
        if site.name:
            frame = frames[mj.site_bodyid[k]]
            base = model.frames[frame]
            placement = base.placement * local_pose(mj.site_pos[k], mj.site_quat[k])
            model.addFrame(pin.Frame(site.name, base.parentJoint, frame, placement, pin.FrameType.OP_FRAME), False)
    return model, frames


def _add_joint(model: pin.Model, mj: Any, parent: int, placement: pin.SE3, k: int, name: str) -> tuple[int, pin.SE3]:
    """Add joint `k` of a body that is at `place` in the frame of the joint `parent`.

    MuJoCo's joint is at rest at its reference, `qpos0`; Pinocchio's at 0. Returns the joint, and the body's place in its frame.
    """
    anchor = pin.SE3(np.eye(3), np.array(mj.jnt_pos[k]))
    back = anchor.inverse()
    kind, axis = JOINTS[mj.jnt_type[k]], np.array(mj.jnt_axis[k])
    if kind == "ball":
        return model.addJoint(parent, pin.JointModelSpherical(), placement * anchor, name), back
    reference = float(mj.qpos0[mj.jnt_qposadr[k]])
    if kind == "slide":
        at_zero = pin.SE3(np.eye(3), -reference * axis)
    else:
        at_zero = pin.SE3(pin.AngleAxis(-reference, axis).toRotationMatrix() if reference else np.eye(3), np.zeros(3))
    joint = joint_about(axis, slides=kind == "slide")
    lower, upper = mj.jnt_range[k] if mj.jnt_limited[k] else (-np.inf, np.inf)
    limits = (_effort(mj, k), np.inf, lower, upper)
    return model.addJoint(parent, joint, placement * anchor * at_zero, name, *(np.array([each]) for each in limits)), back


def _effort(mj: Any, joint: int) -> float:
    """The largest force or torque on a joint [N or Nm] in both directions, where one limit or one actuator states it."""
    if mj.jnt_actfrclimited[joint]:
        return float(max(0.0, min(-mj.jnt_actfrcrange[joint, 0], mj.jnt_actfrcrange[joint, 1])))
    acting = [a for a in range(mj.nu) if mj.actuator_trnid[a, 0] == joint and mj.actuator_trntype[a] in (0, 1)]  # a joint's
    if len(acting) != 1 or not mj.actuator_forcelimited[acting[0]]:
        return float(np.inf)
    low, high = mj.actuator_forcerange[acting[0]] * abs(mj.actuator_gear[acting[0], 0])
    return float(max(0.0, min(-low, high)))


def _joints_of(mj: Any, body: int) -> list[int]:
    """The joints of a body but free ones, from its parent on."""
    first = int(mj.body_jntadr[body])
    joints = range(first, first + int(mj.body_jntnum[body]))
    return [k for k in joints if JOINTS[mj.jnt_type[k]] != "free"]


def _body_names(mj: Any) -> list[str]:
    """The name of each body; one without a name is called after its number."""
    taken = {mj.body(k).name for k in range(mj.nbody)}
    return [mj.body(k).name or _new(f"body{k}", taken) for k in range(mj.nbody)]


def _joint_names(mj: Any) -> list[str]:
    """The name of each joint; one without a name is called after its body."""
    bodies, taken = _body_names(mj), {mj.joint(k).name for k in range(mj.njnt)}
    return [mj.joint(k).name or _new(f"{bodies[mj.jnt_bodyid[k]]}_joint", taken) for k in range(mj.njnt)]


def _new(name: str, taken: set[str]) -> str:
    """`name`, with a number if it is taken; from now on it is."""
    found, number = name, 2
    while found in taken:
        found, number = f"{name}{number}", number + 1
    taken.add(found)
    return found


# ---- geoms


def _geometry(file: Path, mj: Any, model: pin.Model, frames: Sequence[int], geoms: Sequence[int]) -> pin.GeometryModel:
    """The given geoms on the links of `model`; `frames` is the frame of each body. Those of the world belong to no link."""
    geometry, bodies = pin.GeometryModel(), _body_names(mj)
    surfaces: dict[tuple[int, int], coal.BVHModelOBBRSS] = {}
    numbers, taken = Counter[int](), {mj.geom(k).name for k in geoms}
    for k in geoms:
        body = int(mj.geom_bodyid[k])
        name = mj.geom(k).name
        if body == 0 and name in bodies:
            name = _new(name, taken)  # a geom of the world counts as a link of its own
        elif not name:
            name = _new(f"{bodies[body]}_{numbers[body]}", taken)
            numbers[body] += 1
        frame = model.frames[frames[body]]
        data = int(mj.geom_type[k]), int(mj.geom_dataid[k])  # several geoms may show one mesh
        kind = SHAPES[mj.geom_type[k]]
        if kind in ("mesh", "hfield"):
            surfaces[data] = shape = surfaces.get(data) or triangle_tree(*surface_of(file, mj, k))
        else:
            shape = _primitive(file, kind, name, [float(each) for each in mj.geom_size[k]])
        placement = frame.placement * local_pose(mj.geom_pos[k], mj.geom_quat[k])
        item = pin.GeometryObject(name, frame.parentJoint, frames[body], placement, shape)
        item.meshColor, item.overrideMaterial = _colour(mj, k), True
        geometry.addGeometryObject(item)
    return geometry


#: The shape of each kind of geom without triangles, from its size (3,).
PRIMITIVES: Mapping[str, Callable[[Sequence[float]], coal.CollisionGeometry]] = {
    "plane": lambda _: coal.Halfspace(np.array([0.0, 0.0, 1.0]), 0.0),
    "sphere": lambda size: coal.Sphere(size[0]),
    "capsule": lambda size: coal.Capsule(size[0], 2 * size[1]),
    "cylinder": lambda size: coal.Cylinder(size[0], 2 * size[1]),
    "ellipsoid": lambda size: coal.Ellipsoid(*size),
    "box": lambda size: coal.Box(*(2 * each for each in size)),
}


def _primitive(file: Path, kind: str, name: str, size: Sequence[float]) -> coal.CollisionGeometry:
    if kind != "plane" and max(size) > FARTHEST:
        raise FileFormatError("file", str(file), f"geoms of at most {FARTHEST:g} m; the {kind} {name} has the size {size}")
    if kind not in PRIMITIVES:
        wanted = f"geoms of the kinds {', '.join(SHAPES[:-1])}; {name} is of the kind {kind}: make it a mesh, or give it"
        raise FileFormatError("file", str(file), f'{wanted} contype="0" conaffinity="0"')
    return PRIMITIVES[kind](size)


def _height_field(file: Path, mj: Any, number: int) -> tuple[Array, NDArray[np.int64]]:
    """The closed surface of a height field: its heights, the base below them, and the walls between."""
    rows, columns, start = int(mj.hfield_nrow[number]), int(mj.hfield_ncol[number]), int(mj.hfield_adr[number])
    if rows * columns > MOST_HEIGHTS:
        wanted = f"height fields of at most {MOST_HEIGHTS} heights; {mj.hfield(number).name} has {rows} x {columns}"
        raise FileFormatError("file", str(file), wanted)
    half_x, half_y, top, base = (float(each) for each in mj.hfield_size[number])
    x, y = np.meshgrid(np.linspace(-half_x, half_x, columns), np.linspace(-half_y, half_y, rows))
    heights = top * np.array(mj.hfield_data[start : start + rows * columns], dtype=float)
    above = np.column_stack([x.ravel(), y.ravel(), heights])
    below = np.column_stack([x.ravel(), y.ravel(), np.full(rows * columns, -base)])
    at = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (each.ravel() for each in (at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]))
    upper = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    rim = np.concatenate([at[0, :-1], at[:-1, -1], at[-1, :0:-1], at[:0:-1, 0]])  # anticlockwise from above
    after, deep = np.roll(rim, -1), rows * columns
    walls = np.concatenate([np.column_stack([rim, rim + deep, after + deep]), np.column_stack([rim, after + deep, after])])
    return np.concatenate([above, below]), np.concatenate([upper, upper[:, ::-1] + deep, walls])


def _colour(mj: Any, geom: int) -> Array:
    """Red, green, blue and opacity (4,) of a geom; its material has precedence, as in MuJoCo."""
    material = int(mj.geom_matid[geom])
    return np.array(mj.mat_rgba[material] if material >= 0 else mj.geom_rgba[geom], dtype=float)


# ---- pairs


def _find_unchecked(mj: Any, geoms: Sequence[int], names: Sequence[str]) -> dict[frozenset[str], str]:
    """The pairs of geoms that MuJoCo does not check, and those of the base and the link that its first joint moves."""
    of = np.array(geoms, dtype=int)
    body = mj.geom_bodyid[of]
    weld = mj.body_weldid[body]
    above = mj.body_weldid[mj.body_parentid[weld]]
    is_one_link = weld[:, None] == weld
    moving = (weld[:, None] != 0) & (weld != 0)
    child = (weld[:, None] == above) & moving & (not _flag(mj, FILTER_PARENT))
    # MuJoCo checks a fixed base against the first link, which it touches by construction
    child |= (body[:, None] == mj.body_parentid[body]) & (body[:, None] > 0) & (weld[:, None] == 0) & (weld == body)
    masks = (mj.geom_contype[of][:, None] & mj.geom_conaffinity[of]) | (mj.geom_conaffinity[of][:, None] & mj.geom_contype[of])
    named, excluded = np.zeros(masks.shape, dtype=bool), np.zeros((mj.nbody, mj.nbody), dtype=bool)
    named[np.searchsorted(of, mj.pair_geom1), np.searchsorted(of, mj.pair_geom2)] = True
    excluded[mj.exclude_signature >> 16, mj.exclude_signature & 0xFFFF] = True
    excluded = excluded[np.ix_(body, body)]
    kinds = ((is_one_link, ONE_BODY), (named, ""), (excluded, EXCLUDED), (child, ADJACENT), (masks == 0, MASKED))
    reasons = np.select([each | each.T for each, _ in kinds], [reason for _, reason in kinds], "")
    pairs = ((i, j) for j in range(len(of)) for i in range(j) if reasons[i, j])
    return {frozenset((names[i], names[j])): str(reasons[i, j]) for i, j in pairs}


def _flag(mj: Any, name: str) -> bool:
    """Whether one of the options of MuJoCo is disabled in the file."""
    import mujoco

    return bool(mj.opt.disableflags & int(getattr(mujoco.mjtDisableBit, name)))


# ---- couplings


def _couplings(file: Path, mj: Any, names: Sequence[str]) -> dict[str, Mimic]:
    """The followers: joint1 of each active `<equality><joint>`, whose leader is joint2.

    MuJoCo counts both from their references. Without joint2, joint1 stays where it is, as if it followed the world.

    Raises FileFormatError when the polynomial is not a straight line, a joint has two leaders, or follows itself.
    """
    direct: dict[str, Mimic] = {}
    for k in range(mj.neq):
        if EQUALITIES[mj.eq_type[k]] != "joint" or not mj.eq_active0[k]:
            continue
        name, second = names[mj.eq_obj1id[k]], int(mj.eq_obj2id[k])
        zero, slope, *curved = (float(each) for each in mj.eq_data[k, :5])
        if any(curved) and second >= 0:
            line = " ".join(f"{each:g}" for each in (zero, slope, *curved))
            wanted = (
                f"<equality> joints with a polycoef that is a straight line, such as '0 1 0 0 0'; that of {name} is {line!r}"
            )
            raise FileFormatError("file", str(file), wanted)
        offset = zero + float(mj.qpos0[mj.jnt_qposadr[mj.eq_obj1id[k]]])
        mimic = Mimic(leader=WORLD, multiplier=0.0, offset=offset)
        if second >= 0:
            offset -= slope * float(mj.qpos0[mj.jnt_qposadr[second]])
            mimic = Mimic(leader=names[second], multiplier=slope, offset=offset)
        if direct.get(name, mimic) != mimic:
            wanted = f"one <equality> per joint that follows; {name} follows {direct[name]} and {mimic}"
            raise FileFormatError("file", str(file), wanted)
        direct[name] = mimic
    return first_leaders(file, direct)


def _log_left_out(file: Path, mj: Any) -> None:
    """Name what MuJoCo has and the robot has not, in one line; a warning where it changes what the robot can do."""
    active = Counter(EQUALITIES[mj.eq_type[k]] for k in range(mj.neq) if mj.eq_active0[k])
    constraints = [f"{count} <{kind}> of <equality>" for kind, count in active.items() if kind != "joint"]
    limited = int(np.count_nonzero(mj.tendon_limited))
    constraints += [f"limits of {limited} tendon{'s' * (limited > 1)}"] * bool(limited)
    bodies, free = _body_names(mj), JOINTS.index("free")
    others = [f"the free joint of {bodies[body]}, which stays where it is" for body in mj.jnt_bodyid[mj.jnt_type == free]]
    kinds = (("ntendon", "tendon"), ("nflex", "flex"), ("nskin", "skin"), ("nplugin", "plugin"))
    for attribute, kind in (*kinds, ("nu", "actuator"), ("nkey", "keyframe")):
        count = int(getattr(mj, attribute))
        others += [f"{count} {kind}{'s' * (count > 1)}"] * bool(count)
    others += ["gravcomp"] if np.any(mj.body_gravcomp) else []
    others += ["contact=disable"] if _flag(mj, "mjDSBL_CONTACT") else []
    if constraints or others:
        say = log.warning if constraints else log.info
        say("%s: not taken over: %s", file, ", ".join([*constraints, *others]))
