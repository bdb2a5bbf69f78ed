"""Known arms by name, from the package example-robot-data, and the planar n-link arm built without a file."""

import logging
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike

from manipplan.robots.limits import JointLimits
from manipplan.robots.model_tree import MOST_ACTIVE, frame_index
from manipplan.robots.robot import Robot
from manipplan.robots.source import RobotSource
from manipplan.support.checks import number, number_array
from manipplan.support.errors import InvalidInputError, MissingExtraError, UnknownNameError

log = logging.getLogger("manipplan")


@dataclass(frozen=True, kw_only=True)
class Entry:
    """One arm of the catalogue: where its files are and which part of them is the arm."""

    folder: str
    urdf: str
    tool: str | tuple[str, ...]
    first: str | None = None
    srdf: str | None = None
    neutral: tuple[float, ...] | None = None
    acceleration: tuple[float, ...] | float | None = None
    jerk: tuple[float, ...] | float | None = None
    data_sheet: str = ""


# Accelerations and jerks are given only where the manufacturer publishes them; otherwise the default of JointLimits applies.
_PANDA = Entry(
    folder="panda_description",
    urdf="urdf/panda.urdf",
    srdf="srdf/panda.srdf",
    tool="panda_hand_tcp",
    acceleration=(15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0),
    jerk=(7500.0, 3750.0, 5000.0, 6250.0, 7500.0, 10000.0, 10000.0),
    data_sheet="Franka Emika control interface, robot and interface specifications",
)
_UR_NEUTRAL = (0.0, -1.5708, 1.5708, -1.5708, -1.5708, 0.0)
_BAXTER_NEUTRAL = (0.0, -0.55, 0.0, 0.75, 0.0, 1.26, 0.0)

_TIAGO_ARM = (0.2, -0.6, 1.5, 1.6, -1.57, 0.2, 0.0)  # mirror images have the same values on both sides

CATALOG: Mapping[str, Entry] = {
    "panda": _PANDA,
    "panda_collision": replace(_PANDA, urdf="urdf/panda_collision.urdf"),
    "ur3": Entry(folder="ur_description", urdf="urdf/ur3_robot.urdf", srdf="srdf/ur5.srdf", tool="tool0", neutral=_UR_NEUTRAL),
    "ur5": Entry(folder="ur_description", urdf="urdf/ur5_robot.urdf", srdf="srdf/ur5.srdf", tool="tool0", neutral=_UR_NEUTRAL),
    "ur10": Entry(
        folder="ur_description", urdf="urdf/ur10_robot.urdf", srdf="srdf/ur5.srdf", tool="tool0", neutral=_UR_NEUTRAL
    ),
    "xarm7": Entry(
        folder="xarm_description",
        urdf="urdf/xarm7.urdf",
        srdf="srdf/xarm7.srdf",
        tool="link_eef",
        neutral=(0.0, -0.5, 0.0, 1.0, 0.0, 1.5, 0.0),
        acceleration=float(np.deg2rad(1145.0)),
        jerk=float(np.deg2rad(28647.0)),
        data_sheet="UFACTORY xArm user manual, motion parameters",
    ),
    "kinova": Entry(
        folder="kinova_description",
        urdf="robots/kinova.urdf",
        srdf="srdf/kinova.srdf",
        tool="j2s6s200_end_effector",
        neutral=(4.8, 2.9, 1.0, 4.2, 1.4, 0.0),
    ),
    "z1": Entry(
        folder="z1_description",
        urdf="urdf/z1.urdf",
        srdf="srdf/z1.srdf",
        tool="gripperStator",
        neutral=(0.0, 1.5, -1.0, -0.54, 0.0, 0.0),
    ),
    "baxter_left": Entry(
        folder="baxter_description",
        urdf="urdf/baxter.urdf",
        srdf="srdf/baxter_manipulation.srdf",
        tool="left_gripper",
        neutral=_BAXTER_NEUTRAL,
    ),
    "baxter_right": Entry(
        folder="baxter_description",
        urdf="urdf/baxter.urdf",
        srdf="srdf/baxter_manipulation.srdf",
        tool="right_gripper",
        neutral=_BAXTER_NEUTRAL,
    ),
    "baxter": Entry(
        folder="baxter_description",
        urdf="urdf/baxter.urdf",
        srdf="srdf/baxter_manipulation.srdf",
        tool=("left_gripper", "right_gripper"),
        neutral=_BAXTER_NEUTRAL * 2,
    ),
    "talos": Entry(
        folder="talos_data",
        urdf="robots/talos_reduced.urdf",
        srdf="srdf/talos.srdf",
        tool=("wrist_left_ft_tool_link", "wrist_right_ft_tool_link"),
    ),
    "talos_right_arm": Entry(
        folder="talos_data",
        urdf="robots/talos_reduced.urdf",
        srdf="srdf/talos.srdf",
        tool="wrist_right_ft_tool_link",
        first="arm_right_1_joint",
    ),
    "talos_torso_right_arm": Entry(
        folder="talos_data",
        urdf="robots/talos_reduced.urdf",
        srdf="srdf/talos.srdf",
        tool="wrist_right_ft_tool_link",
    ),
    "simple_humanoid_right_arm": Entry(
        folder="simple_humanoid_description",
        urdf="urdf/simple_humanoid.urdf",
        srdf="srdf/simple_humanoid.srdf",
        tool="r_wrist",
        first="RARM_SHOULDER_P",
    ),
    "tiago": Entry(
        folder="tiago_description",
        urdf="robots/tiago.urdf",
        tool="arm_tool_link",
    ),
    "tiago_dual": Entry(
        folder="tiago_description",
        urdf="robots/tiago_dual.urdf",
        tool=("arm_left_tool_link", "arm_right_tool_link"),
        neutral=(0.15, *_TIAGO_ARM, *_TIAGO_ARM),
    ),
    "icub": Entry(
        folder="icub_description", urdf="robots/icub.urdf", srdf="srdf/icub.srdf", tool="r_hand", first="r_shoulder_pitch"
    ),
    "so100": Entry(folder="so_arm_description", urdf="urdf/so100.urdf", tool="gripper"),
}


def available_robots() -> tuple[str, ...]:
    """Names that `load_robot` knows."""
    return tuple(CATALOG)


def load_robot(name: str | Path, **options: object) -> Robot:
    """An arm by its catalogue name, or from a URDF, xacro or MJCF file.

    Args:
        name: one of `available_robots()`, or a path that ends in .urdf, .xacro, .xml or .mjcf.
        **options: as for `Robot.from_urdf` (tool, joints, srdf, locked, velocity, acceleration, jerk, ...).

    Raises:
        UnknownNameError: no such name; the nearest names are listed.
        MissingExtraError: the package with the robot descriptions is not installed.
    """
    if not isinstance(name, str | Path):
        raise InvalidInputError("name", name, "a name of the catalogue, or the path of a URDF, xacro or MJCF file")
    file = Path(name).expanduser()
    if file.suffix in (".urdf", ".xacro"):
        return Robot.from_urdf(file, **options)  # type: ignore[arg-type]  # checked by from_urdf itself
    if file.suffix in (".xml", ".mjcf"):
        return Robot.from_mjcf(file, **options)  # type: ignore[arg-type]  # checked by from_mjcf itself
    if str(name) not in CATALOG:
        raise UnknownNameError("name", str(name), CATALOG)
    entry = CATALOG[str(name)]
    folder = _descriptions() / entry.folder
    chosen: dict[str, object] = {
        "tool": entry.tool,
        "joints": None,
        "srdf": folder / entry.srdf if entry.srdf else None,
        "name": str(name),
        "neutral": entry.neutral,
    }
    if "joints" in options or "tool" in options:
        chosen["neutral"] = None  # the catalogue's posture is for the whole arm
    robot_options = {**chosen, **options}
    if entry.first is not None and robot_options["joints"] is None:
        robot_options["joints"] = _chain_from(folder / entry.urdf, str(robot_options["tool"]), entry.first)
    with _own_srdf():
        robot = Robot.from_urdf(folder / entry.urdf, **robot_options)  # type: ignore[arg-type]  # checked by from_urdf itself
    published = {"acceleration": entry.acceleration, "jerk": entry.jerk}
    published = {kind: value for kind, value in published.items() if value is not None and kind not in options}
    if published and robot_options["joints"] is None:
        robot = robot.with_limits(source=entry.data_sheet, **published)  # type: ignore[arg-type]  # checked by with_limits itself
    return replace(robot, source=RobotSource.of("catalogue", folder / entry.urdf, options, name=str(name)))


@contextmanager
def _own_srdf() -> Iterator[None]:
    """Without the warnings about names in an SRDF: those of the catalogue are known, and one serves three arms of UR."""

    def others(record: logging.LogRecord) -> bool:
        return record.module != "srdf"

    log.addFilter(others)
    try:
        yield
    finally:
        log.removeFilter(others)


def planar_arm(lengths: ArrayLike, *, radius: float | None = None) -> Robot:
    """The planar n-link arm of the thesis [kth2012, ch. 2]: revolute joints about z, links along x.

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
