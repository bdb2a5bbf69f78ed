"""Arms by name: those of the package example-robot-data, and other collections; and the planar n-link arm, without a file."""

import difflib
import importlib
import logging
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import EntryPoint
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from manipplan.robots.collections import ENDING, GROUP, MENAGERIE, own_robots, package_of, robot_file
from manipplan.robots.description import RobotSource
from manipplan.robots.limits import JointLimits
from manipplan.robots.model_tree import MOST_ACTIVE, frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import ArrayLike, number, number_array
from manipplan.support.errors import InvalidInputError, ManipplanError, MissingExtraError, UnknownNameError

log = logging.getLogger("manipplan")

#: Limits that hold together: a velocity holds on its range of positions.
RANGE = ("lower", "upper", "velocity")


@dataclass(frozen=True, kw_only=True)
class DataSheet:
    """Published limits of the arm whose joints have these names in the maker's description, and where they are published.

    They are in SI units, one number or one per joint, by their names in JointLimits.
    """

    joints: tuple[str, ...]
    limits: Mapping[str, tuple[float, ...] | float]
    source: str


PANDA = DataSheet(
    joints=tuple(f"panda_joint{k}" for k in range(1, 8)),
    limits={
        "acceleration": (15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0),
        "jerk": (7500.0, 3750.0, 5000.0, 6250.0, 7500.0, 10000.0, 10000.0),
    },
    source="Franka Emika control interface, robot and interface specifications",
)
#: The FR3's velocity limits depend on the position and fall to zero at the position limits. These are the constants that its
#: maker publishes for planners, with the narrower range of positions on which they hold; `paths.controllers.franka` has the
#: whole rule.
FR3 = DataSheet(
    joints=tuple(f"fr3_joint{k}" for k in range(1, 8)),
    limits={
        "lower": (-2.3093, -1.5133, -2.4937, -2.7478, -2.4800, 0.8521, -2.6895),
        "upper": (2.3093, 1.5133, 2.4937, -0.4461, 2.4800, 4.2094, 2.6895),
        "velocity": (2.0, 1.0, 1.5, 1.25, 3.0, 1.5, 3.0),
        "acceleration": (10.0,) * 7,
        "jerk": (5000.0,) * 7,
    },
    source="Franka Robotics control interface, robot limits of the FR3: constant velocities on a narrower range of positions",
)
SHEETS = (PANDA, FR3)
XARM7 = DataSheet(
    joints=tuple(f"joint{k}" for k in range(1, 8)),
    limits={"acceleration": float(np.deg2rad(1145.0)), "jerk": float(np.deg2rad(28647.0))},
    source="UFACTORY xArm user manual, motion parameters",
)


def with_published_limits(robot: Robot, given: Collection[str], sheet: DataSheet | None = None) -> Robot:
    """The robot with the limits of a data sheet, by default that of its joints, if any, but for the kinds in `given`.

    Where one of lower, upper and velocity is given, the sheet's other two are left out as well: they hold together.
    """
    sheet = sheet or next((each for each in SHEETS if each.joints == robot.joint_names), None)
    if sheet is None:
        return robot
    left_out = {*given, *(RANGE if set(RANGE) & set(given) else ())}
    limits: dict[str, Any] = {kind: value for kind, value in sheet.limits.items() if kind not in left_out}
    return robot.with_limits(source=sheet.source, **limits) if limits else robot


#: Endings of the files that hold a robot.
FILES = (".urdf", ".xacro", ".xml", ".mjcf")


@dataclass(frozen=True, kw_only=True)
class CatalogEntry:
    """One arm of the catalogue: where its files are and which part of them is the arm.

    Attributes:
        folder, urdf, srdf: folder in the package, and files in it.
        tool: the tool frame, or several, one for each arm.
        joints: number of active joints, which `manipplan robots` lists without loading the arm.
        ik: method of `inverse_kinematics`; of several arms that of each.
        first: the first active joint; None: all joints that move a tool are active.
        neutral: usual posture, one value per joint [rad or m].
        sheet: published limits of an arm whose joints have names that say nothing.
    """

    folder: str
    urdf: str
    tool: str | tuple[str, ...]
    joints: int
    ik: str = "newton"
    first: str | None = None
    srdf: str | None = None
    neutral: tuple[float, ...] | None = None
    sheet: DataSheet | None = None


# Accelerations and jerks are given only where the manufacturer publishes them (data sheets, above);
# otherwise the default of JointLimits applies.
_PANDA = CatalogEntry(
    folder="panda_description", urdf="urdf/panda.urdf", srdf="srdf/panda.srdf", tool="panda_hand_tcp", joints=7, ik="spherical"
)
_UR_NEUTRAL = (0.0, -1.5708, 1.5708, -1.5708, -1.5708, 0.0)
_UR = CatalogEntry(
    folder="ur_description",
    urdf="urdf/ur5_robot.urdf",
    srdf="srdf/ur5.srdf",
    tool="tool0",
    joints=6,
    ik="parallel",
    neutral=_UR_NEUTRAL,
)
_BAXTER_NEUTRAL = (0.0, -0.55, 0.0, 0.75, 0.0, 1.26, 0.0)
_BAXTER = CatalogEntry(
    folder="baxter_description",
    urdf="urdf/baxter.urdf",
    srdf="srdf/baxter_manipulation.srdf",
    tool=("left_gripper", "right_gripper"),
    joints=14,
    neutral=_BAXTER_NEUTRAL * 2,
)
_KINOVA = CatalogEntry(
    folder="kinova_description",
    urdf="robots/kinova.urdf",
    srdf="srdf/kinova.srdf",
    tool="j2s6s200_end_effector",
    joints=6,
    ik="spherical",
    neutral=(4.8, 2.9, 1.0, 4.2, 1.4, 0.0),
)
_Z1 = CatalogEntry(
    folder="z1_description",
    urdf="urdf/z1.urdf",
    srdf="srdf/z1.srdf",
    tool="gripperStator",
    joints=6,
    ik="parallel",
    neutral=(0.0, 1.5, -1.0, -0.54, 0.0, 0.0),
)
_BRAVO = CatalogEntry(
    folder="bravo7_description",
    urdf="urdf/bravo7_no_ee.urdf",
    srdf="srdf/bravo7_no_ee.srdf",
    tool="end_effector_ball",
    joints=6,
)
_BRAVO_HAND = "bravo_finger_jaws_base_link"
_TALOS = CatalogEntry(
    folder="talos_data",
    urdf="robots/talos_reduced.urdf",
    srdf="srdf/talos.srdf",
    tool=("wrist_left_ft_tool_link", "wrist_right_ft_tool_link"),
    joints=16,
    ik="spherical",
)
_HUMANOID = CatalogEntry(
    folder="simple_humanoid_description",
    urdf="urdf/simple_humanoid.urdf",
    srdf="srdf/simple_humanoid.srdf",
    tool=("l_wrist", "r_wrist"),
    joints=7,
    ik="swivel",
)
_ICUB = CatalogEntry(
    folder="icub_description", urdf="robots/icub.urdf", srdf="srdf/icub.srdf", tool=("l_hand", "r_hand"), joints=7, ik="swivel"
)
_PR2 = CatalogEntry(
    folder="pr2_description",
    urdf="urdf/pr2.urdf",
    srdf="srdf/pr2.srdf",
    tool=("l_gripper_tool_frame", "r_gripper_tool_frame"),
    joints=15,
    ik="spherical",
)
_ROMEO = CatalogEntry(
    folder="romeo_description",
    urdf="urdf/romeo.urdf",
    srdf="srdf/romeo.srdf",
    tool=("l_gripper", "r_gripper"),
    joints=7,
    ik="swivel",
)
_G1 = CatalogEntry(
    folder="g1_description", urdf="urdf/g1_29dof_rev_1_0.urdf", tool=("left_rubber_hand", "right_rubber_hand"), joints=7
)
_ALEX = CatalogEntry(
    folder="alex_description",
    urdf="urdf/alex_nub_hands.urdf",
    srdf="srdf/alex_nub_hands.srdf",
    tool=("leftNub", "rightNub"),
    joints=7,
)
_CENTAURO = CatalogEntry(
    folder="centauro_description",
    urdf="urdf/centauro.urdf",
    srdf="srdf/centauro.srdf",
    tool=("ball1_tip", "ball2_tip"),
    joints=13,
    ik="spherical",
)
_TIAGO_PRO = CatalogEntry(
    folder="tiago_pro_description", urdf="robots/tiago_pro.urdf", tool=("arm_left_tool_link", "arm_right_tool_link"), joints=15
)
_TIAGO_ARM = (0.2, -0.6, 1.5, 1.6, -1.57, 0.2, 0.0)  # mirror images have the same values on both sides

CATALOG: Mapping[str, CatalogEntry] = {
    "panda": _PANDA,
    "panda_collision": replace(_PANDA, urdf="urdf/panda_collision.urdf"),
    "ur3": replace(_UR, urdf="urdf/ur3_robot.urdf"),
    "ur3_gripper": replace(_UR, urdf="urdf/ur3_gripper.urdf", srdf="srdf/ur3_gripper.srdf"),
    "ur3_limited": replace(_UR, urdf="urdf/ur3_joint_limited_robot.urdf"),
    "ur5": _UR,
    "ur5_gripper": replace(_UR, urdf="urdf/ur5_gripper.urdf", srdf="srdf/ur5_gripper.srdf"),
    "ur5_limited": replace(_UR, urdf="urdf/ur5_joint_limited_robot.urdf", srdf="srdf/ur5_joint_limited_robot.srdf"),
    "ur10": replace(_UR, urdf="urdf/ur10_robot.urdf"),
    "ur10_limited": replace(_UR, urdf="urdf/ur10_joint_limited_robot.urdf"),
    "xarm7": CatalogEntry(
        folder="xarm_description",
        urdf="urdf/xarm7.urdf",
        srdf="srdf/xarm7.srdf",
        tool="link_eef",
        joints=7,
        ik="spherical",
        neutral=(0.0, -0.5, 0.0, 1.0, 0.0, 1.5, 0.0),
        sheet=XARM7,
    ),
    "kinova": _KINOVA,
    "anymal_kinova": replace(
        _KINOVA, folder="anymal_b_simple_description", urdf="robots/anymal-kinova.urdf", srdf="srdf/anymal-kinova.srdf"
    ),
    "z1": _Z1,
    "b1_z1": replace(_Z1, folder="b1_description", urdf="urdf/b1-z1.urdf", srdf="srdf/b1-z1.srdf"),
    "bravo7_no_ee": _BRAVO,
    "bravo7_gripper": replace(_BRAVO, urdf="urdf/bravo7_gripper.urdf", srdf="srdf/bravo7_gripper.srdf", tool=_BRAVO_HAND),
    "baxter_left": replace(_BAXTER, tool="left_gripper", joints=7, neutral=_BAXTER_NEUTRAL),
    "baxter_right": replace(_BAXTER, tool="right_gripper", joints=7, neutral=_BAXTER_NEUTRAL),
    "baxter": _BAXTER,
    "talos": _TALOS,
    "talos_left_arm": replace(_TALOS, tool="wrist_left_ft_tool_link", first="arm_left_1_joint", joints=7),
    "talos_right_arm": replace(_TALOS, tool="wrist_right_ft_tool_link", first="arm_right_1_joint", joints=7),
    "talos_torso_right_arm": replace(_TALOS, tool="wrist_right_ft_tool_link", joints=9),
    "simple_humanoid_left_arm": replace(_HUMANOID, tool="l_wrist", first="LARM_SHOULDER_P"),
    "simple_humanoid_right_arm": replace(_HUMANOID, tool="r_wrist", first="RARM_SHOULDER_P"),
    "pr2": _PR2,
    "pr2_left_arm": replace(
        _PR2,
        tool="l_gripper_tool_frame",
        first="l_shoulder_pan_joint",
        joints=7,
        neutral=(0.79, 0.44, 1.55, -1.16, 0.0, -1.05, 0.0),
    ),
    "pr2_right_arm": replace(
        _PR2,
        tool="r_gripper_tool_frame",
        first="r_shoulder_pan_joint",
        joints=7,
        neutral=(-0.79, 0.44, -1.55, -1.16, 0.0, -1.05, 0.0),
    ),
    "romeo_left_arm": replace(_ROMEO, tool="l_gripper", first="LShoulderPitch"),
    "romeo_right_arm": replace(_ROMEO, tool="r_gripper", first="RShoulderPitch"),
    "g1_left_arm": replace(_G1, tool="left_rubber_hand", first="left_shoulder_pitch_joint"),
    "g1_right_arm": replace(_G1, tool="right_rubber_hand", first="right_shoulder_pitch_joint"),
    "alex_left_arm": replace(_ALEX, tool="leftNub", first="LeftShoulderPitch"),
    "alex_right_arm": replace(_ALEX, tool="rightNub", first="RightShoulderPitch"),
    "centauro": _CENTAURO,
    "centauro_left_arm": replace(_CENTAURO, tool="ball1_tip", first="j_arm1_1", joints=6),
    "centauro_right_arm": replace(_CENTAURO, tool="ball2_tip", first="j_arm2_1", joints=6),
    "tiago": CatalogEntry(folder="tiago_description", urdf="robots/tiago.urdf", tool="arm_tool_link", joints=8, ik="spherical"),
    "tiago_no_hand": CatalogEntry(
        folder="tiago_description", urdf="robots/tiago_no_hand.urdf", tool="wrist_ft_tool_link", joints=8, ik="spherical"
    ),
    "tiago_dual": CatalogEntry(
        folder="tiago_description",
        urdf="robots/tiago_dual.urdf",
        tool=("arm_left_tool_link", "arm_right_tool_link"),
        joints=15,
        ik="spherical",
        neutral=(0.15, *_TIAGO_ARM, *_TIAGO_ARM),
    ),
    "tiago_pro": _TIAGO_PRO,
    "tiago_pro_left_arm": replace(_TIAGO_PRO, tool="arm_left_tool_link", first="arm_left_1_joint", joints=7),
    "tiago_pro_right_arm": replace(_TIAGO_PRO, tool="arm_right_tool_link", first="arm_right_1_joint", joints=7),
    "icub": replace(_ICUB, tool="r_hand", first="r_shoulder_pitch"),
    "icub_left_arm": replace(_ICUB, tool="l_hand", first="l_shoulder_pitch", neutral=(-0.5, 0.8, 0.0, 1.0, 0.0, 0.0, 0.0)),
    "so100": CatalogEntry(folder="so_arm_description", urdf="urdf/so100.urdf", tool="gripper", joints=5),
    "so101": CatalogEntry(folder="so_arm_description", urdf="urdf/so101.urdf", tool="gripper_frame_link", joints=5),
    "asr_twodof": CatalogEntry(folder="asr_twodof_description", urdf="urdf/TwoDofs.urdf", tool="Tip", joints=2),
}


def available_robots() -> tuple[str, ...]:
    """List the names that `load_robot` knows: those of the catalogue, then those that installed packages add by an entry point.

    `load_robot` also takes the names of robot_descriptions and of MuJoCo Menagerie's folders. No package is imported for the
    list. A name that a package cannot add, such as one of the catalogue, is left out, and the log says why.
    """
    names = []
    for name, points in own_robots().items():
        reason = refusal(name, points)
        if reason is None:
            names.append(name)
        else:
            log.warning("the entry point %s is left out; allowed: %s", name, reason)
    return (*CATALOG, *names)


def refusal(name: str, points: Sequence[EntryPoint]) -> str | None:
    """What the name of an entry point has to be instead, and which packages have it; None if it can be used."""
    packages = " and ".join(f"{package_of(each)} ({each.value})" for each in points)
    if name in CATALOG:
        return f"a name that the catalogue does not have: rename the entry point of {packages}"
    if name.endswith(ENDING) or name.startswith(MENAGERIE):
        return f"a name unlike those of other collections (*{ENDING}, {MENAGERIE}*): rename the entry point of {packages}"
    if name.endswith(FILES):
        return f"a name that does not end like a file ({', '.join(FILES)}): rename the entry point of {packages}"
    return f"a name that one package has, not {packages}: remove one of them" if len(points) > 1 else None


def load_robot(name: str | Path, **options: object) -> Robot:
    """Load an arm by its name, or from a URDF, xacro or MJCF file.

    Args:
        name: one of `available_robots()`; a name of the package robot_descriptions, such as "ur5e_description" (extra
            descriptions); a folder of MuJoCo Menagerie, such as "menagerie:franka_fr3" or, where it holds several robots,
            "menagerie:ufactory_lite6/lite6_gripper_wide.xml", of the checkout in the environment variable MUJOCO_MENAGERIE or
            downloaded (extra menagerie); or a path that ends in .urdf, .xacro, .xml or .mjcf. The catalogue's names come first.
        **options: as for `Robot.from_urdf` (tool, joints, srdf, locked, velocity, acceleration, jerk, ...).

    Robots by name get the limits that their maker publishes, where `limits` of a robot names a data sheet as the source.

    Raises:
        UnknownNameError: no such name; the nearest names are listed.
        MissingExtraError: the package with the robot descriptions is not installed.
        RobotNotFetchedError: the files of the robot have to be fetched, and that failed.
        FileFormatError: a folder holds several robots, or a file cannot be read.
        InvalidInputError: an option is wrong; or an entry point fails, or its name cannot be used. The message names the
            package that has it. An error of manipplan raised in that package passes, with a note that names it.
    """
    if not isinstance(name, str | Path):
        raise InvalidInputError("name", name, "a name of the catalogue, or the path of a URDF, xacro or MJCF file")
    file = Path(name).expanduser()
    if str(name) in CATALOG:
        return _of_catalogue(str(name), options)
    if str(name).endswith(ENDING) or str(name).startswith(MENAGERIE):
        own = own_robots()
        if str(name) in own:
            raise InvalidInputError("name", str(name), str(refusal(str(name), own[str(name)])))
    found = robot_file(str(name))
    if found is not None:
        given = dict(options)
        for option in ("arguments", "packages"):  # one that is given leaves the others of the collection as they are
            if isinstance(given.get(option), Mapping):
                given[option] = {**found.options.get(option, {}), **options[option]}  # type: ignore[dict-item]
        robot = _read(found.file, {**found.options, **given})
        if options.get("joints") is None:
            robot = with_published_limits(robot, options)
        return replace(robot, source=RobotSource.of("catalogue", found.file, options, name=str(name)))
    if file.suffix in FILES:
        return _read(file, options)
    own = own_robots()
    if str(name) not in own:
        prefix, colon, folder = str(name).partition(":")
        if colon and difflib.get_close_matches(prefix.lower() + colon, [MENAGERIE], cutoff=0.7):
            raise UnknownNameError("name", str(name), [f"{MENAGERIE}{folder}"])
        others = (
            f"a name of another collection, such as 'ur5e{ENDING}' or '{MENAGERIE}franka_fr3', or a file ({', '.join(FILES)})"
        )
        raise UnknownNameError("name", str(name), [*CATALOG, *own], others=others)
    reason = refusal(str(name), own[str(name)])
    if reason is not None:
        raise InvalidInputError("name", str(name), reason)
    return _of_package(own[str(name)][0], options)


def _of_package(point: EntryPoint, options: Mapping[str, object]) -> Robot:
    """The robot of an entry point: of the function that it names, or of the file whose path it names."""
    text = f"the entry point {point.name} = {point.value} of {package_of(point)}"
    file = None
    try:
        made = point.load()
        if isinstance(made, str | Path):  # a relative path starts at the folder of its module
            file = Path(importlib.import_module(point.module).__file__ or "").parent / made
            made = _read(file, options)
        elif callable(made):
            made = made(**options)
    except ManipplanError as error:
        error.add_note(f"raised in {text}")
        raise
    except Exception as error:  # whatever a package raises
        reason = f"another one, until {text} is repaired: it raised {type(error).__name__}: {error}"
        raise InvalidInputError("name", point.name, reason) from error
    if not isinstance(made, Robot):
        wanted = f"an entry point of {GROUP} that names a file, or a function that returns a Robot, not {made!r}: {text}"
        raise InvalidInputError("name", point.name, wanted)
    return replace(made, source=RobotSource.of("catalogue", file, options, name=point.name))


def _read(file: Path, options: Mapping[str, object]) -> Robot:
    """The robot of a file, by its ending."""
    read = Robot.from_urdf if file.suffix in (".urdf", ".xacro") else Robot.from_mjcf
    return read(file, **options)  # type: ignore[arg-type]  # checked by these functions themselves


def _of_catalogue(name: str, options: Mapping[str, object]) -> Robot:
    entry = CATALOG[name]
    folder = _descriptions() / entry.folder
    file = folder / entry.urdf
    neutral = None if "joints" in options or "tool" in options else entry.neutral  # it is for the whole arm
    chosen = {"tool": entry.tool, "joints": None, "srdf": folder / entry.srdf if entry.srdf else None, "neutral": neutral}
    robot_options: dict[str, object] = {**chosen, "name": name, **options}
    if entry.first is not None and robot_options["joints"] is None:
        robot_options["joints"] = _chain_from(file, str(robot_options["tool"]), entry.first)
    robot = _read(file, robot_options)
    if robot_options["joints"] is None:
        robot = with_published_limits(robot, options, entry.sheet)
    return replace(robot, source=RobotSource.of("catalogue", file, options, name=name))


def planar_arm(lengths: ArrayLike, *, radius: float | None = None) -> Robot:
    """The planar n-link arm of the thesis [kth2012, chapter 2]: revolute joints about z, links along x.

    The links lie in stacked planes, so they may cross each other; obstacles are avoided with links of `radius`.

    Args:
        lengths: (n,) link lengths [m], 2 <= n <= 100.
        radius: radius of the links [m], for obstacles and pictures. Default 3 % of the shortest link.

    Raises InvalidInputError when a length is not positive or there are fewer than two or too many lengths.
    """
    size = number_array("lengths", lengths)
    if size.ndim != 1 or len(size) < 2 or not (np.isfinite(size).all() and (size > 0).all()):
        raise InvalidInputError("lengths", lengths, "at least two finite numbers above zero [m]")
    if len(size) > MOST_ACTIVE:
        raise InvalidInputError("lengths", f"{len(size)} lengths", f"at most {MOST_ACTIVE}")
    radius = 0.03 * float(size.min()) if radius is None else number("radius", radius, above=0.0)
    n = len(size)
    model = pin.Model()
    model.name = f"planar_{n}_link"
    geometry = pin.GeometryModel()
    joint = 0
    for i, length in enumerate(size):
        placement = pin.SE3(np.eye(3), np.array([size[i - 1], 0.0, 0.0]) if i else np.zeros(3))
        joint = model.addJoint(joint, pin.JointModelRZ(), placement, f"joint{i + 1}")
        rod = pin.Inertia.FromCylinder(1.0, radius, float(length))
        along_x = pin.SE3(pin.utils.rotate("y", np.pi / 2), np.array([length / 2, 0.0, 0.0]))
        model.appendBodyToJoint(joint, rod, along_x)
        body = model.addBodyFrame(f"link{i + 1}", joint, pin.SE3.Identity(), 0)
        capsule = coal.Capsule(radius, float(length))
        geometry.addGeometryObject(pin.GeometryObject(f"link{i + 1}_0", joint, body, along_x, capsule))
    model.addBodyFrame("tool", joint, pin.SE3(np.eye(3), np.array([size[-1], 0.0, 0.0])), 0)
    model.gravity = pin.Motion.Zero()
    unlimited = np.full(n, np.inf)
    limits = JointLimits(
        lower=-unlimited,
        upper=unlimited,
        velocity=np.full(n, np.pi),
        acceleration=np.full(n, 5 * np.pi),
        jerk=unlimited,
        effort=unlimited,
        sources={"velocity, acceleration": "planar_arm: π rad/s, full speed in 0.2 s"},
    )
    neutral = np.full(n, np.pi / (2 * n))
    return Robot(
        name=model.name,
        model=model,
        geometry=geometry,
        tool="tool",
        limits=limits,
        neutral=neutral,
        disabled_pairs=frozenset(frozenset((f"link{i + 1}", f"link{j + 1}")) for i in range(n) for j in range(i)),
        planar=True,
        source=RobotSource.of("planar", None, {"lengths": size, "radius": radius}),
    )


def _descriptions() -> Path:
    package = find_spec("example_robot_data")  # it has a loader of its own, whose import takes longer than this search
    if package is not None and package.origin is not None:
        folder = Path(package.origin).parents[4] / "share" / "example-robot-data" / "robots"
        if folder.is_dir():
            return folder
    raise MissingExtraError("example-robot-data", "robots")


def _chain_from(urdf: Path, tool: str, first: str) -> Sequence[str] | None:
    """Joints from `first` to the tool; None if `first` does not move it, so that `from_urdf` checks the tool."""
    model = pin.buildModelFromUrdf(str(urdf))
    if not model.existFrame(tool):
        return None
    chain = [model.names[i] for i in model.supports[model.frames[frame_index(model, tool)].parentJoint]]
    return chain[chain.index(first) :] if first in chain else None
