"""Plans in one JSON file, written and read: all data needed to show a plan, to check it again and to play it.

The file holds the source of the robot, not the robot itself, and the joints' names, limits and screws and the outlines of the
bodies, by which a different robot is detected. A checksum detects a file that was changed. Numbers keep all their digits.
Infinite ones are strings, since JSON has none.
"""

import hashlib
import json
import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle
from manipplan.constraints.constraint import Constraint, constraint_data, constraint_of
from manipplan.cost.integral import PathCost
from manipplan.goals.candidates import GoalCandidate
from manipplan.measures.measure import Measure
from manipplan.measures.names import measure_data, restore_measure
from manipplan.optimize.certificate import Certificate
from manipplan.optimize.result import PathResult
from manipplan.paths.cartesian import PATHS, CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.report import PlanReport
from manipplan.robots.attached import CarriedPart, with_part
from manipplan.robots.description import FILES, FOLDERS, FOLDERS_BY_NAME, TRUST, RobotSource
from manipplan.robots.hulls import box_around
from manipplan.robots.limits import JointLimits
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.search.refine import Refinement
from manipplan.support.checks import Array, existing_file, instance, is_folder, path_of
from manipplan.support.data_files import from_json, json_ready, pack_array, read_array, read_json, unpack_array
from manipplan.support.errors import FileFormatError, InvalidInputError, ManipplanError, MissingExtraError, reading
from manipplan.support.files import absolute_and_relative, finish, found_again, write_text
from manipplan.support.memo import code_key
from manipplan.support.status import Status
from manipplan.symbolic.task import Task

if TYPE_CHECKING:
    from manipplan.plans.result import PartialPlan, Plan

log = logging.getLogger("manipplan")

#: Tolerance on screws, home pose and bodies of the rebuilt robot against the stored ones [m, rad].
REBUILT_TOLERANCE = 1e-6
#: Number of values for a body's joint, placement and box.
OUTLINE = 1 + 12 + 6
#: Number of points or triangles of an obstacle above which they are stored compressed.
MANY = 100
LIMITS = ("lower", "upper", "velocity", "acceleration", "jerk", "effort")


def fingerprint(robot: Robot) -> tuple[Array, Array]:
    """The pose of each tool at q = 0 (k, 4, 4) and every joint's screw there (n, 6), linear part first, in the world's frame.

    By the product of exponentials they give the poses of the tools at every q: different kinematics have different values.
    """
    data = robot.model.createData()
    zero = np.zeros(robot.n)
    pin.computeJointJacobians(robot.model, data, zero)
    pin.framesForwardKinematics(robot.model, data, zero)
    tools = [data.oMf[frame_index(robot.model, tool)].homogeneous for tool in robot.tools]
    return np.array(tools), np.array(data.J.T)


def outlines(robot: Robot) -> Array:
    """Joint number, placement in the joint's frame and bounding box of each body of the collision geometry (k, OUTLINE).

    A shape that was replaced, scaled or moved has a different row.
    """
    rows = []
    for body in robot.geometry.geometryObjects:
        rows.append([[body.parentJoint], body.placement.homogeneous[:3].ravel(), *box_around(body.geometry)])
    return np.array([np.concatenate(row) for row in rows]).reshape(-1, OUTLINE)


def robot_data(robot: Robot, folder: Path) -> dict[str, Any]:
    """The data of a robot for a file in `folder`; paths are stored both absolute and relative to `folder`."""
    home, screws = fingerprint(robot)
    limits = {kind: getattr(robot.limits, kind) for kind in LIMITS}
    data = {
        "arm": robot.name,
        "tools": robot.tools,
        "joint_names": robot.joint_names,
        "neutral": robot.neutral,
        "limits": {**limits, "sources": robot.limits.sources},
        "limit_tolerance": robot.limit_tolerance,
        "home": home,
        "screws": screws,
        "outlines": outlines(robot),
        "base": robot.base,
        "frames": [vars(added) for added in robot.added_frames],
        "parts": [[name, type(part.solid).__name__, part.frame] for name, part in robot.carried.items()],
    }
    carried = []
    for name, part in robot.carried.items():
        if not isinstance(part.solid, Obstacle) or "missing" in scene_data(Scene([part.solid]), folder):
            return {**data, "missing": f"the part {name!r} of a class of your own, {type(part.solid).__name__}"}
        carried.append(part.solid.called(name))
    data["carried"] = scene_data(Scene(carried), folder)
    source = robot.source
    if source is None:
        return {**data, "missing": "an arm that was put together by hand"}
    options = {
        key: _option(key, value, lambda path: absolute_and_relative(path, folder))
        for key, value in source.options.items()
        if key != TRUST
    }
    file = absolute_and_relative(source.file, folder) if source.file is not None and source.kind != "catalogue" else None
    return {**data, "source": {"kind": source.kind, "name": source.name, "file": file, "options": options}}


def robot_of(path: Path, data: Mapping[str, Any], folder: Path, given: Robot | None) -> Robot:
    """The arm rebuilt from the data, or the one given; both have to be the robot of the file."""
    if given is None:
        if "source" not in data:
            raise FileFormatError("file", str(path), f"a result with its robot, but it has {data['missing']}; give robot=")
        source = data["source"]
        try:
            options = {
                key: _option(key, value, lambda each: found_again(each, folder))
                for key, value in source["options"].items()
                if key != TRUST  # a saved plan may come from anywhere
            }
            file = found_again(source["file"], folder) if source["file"] is not None else None
            arm = RobotSource(kind=source["kind"], name=source["name"], file=file, options=options).load()
            arm = _apply_changes(arm, path, data, folder)
            limits = from_json(data["limits"], JointLimits)
            if limits.n == arm.n:  # otherwise it is another arm, which raises below
                arm = replace(arm, limits=limits, neutral=read_array(data["neutral"]))
                arm = arm.with_limits(limit_tolerance=data["limit_tolerance"])
        except MissingExtraError:
            raise
        except ManipplanError as error:
            wanted = f"a result whose robot can be read again ({error}); put its files back, or give robot="
            raise FileFormatError("file", str(path), wanted) from error
    else:
        arm = instance("robot", given, Robot)
    stored = [read_array(data[key]) for key in ("home", "screws")]
    stored.append(read_array(data["outlines"]).reshape(-1, OUTLINE))
    names = tuple(data["joint_names"])
    found = (*fingerprint(arm), outlines(arm))
    tools = tuple(data["tools"])
    parts = [[name, type(part.solid).__name__, part.frame] for name, part in arm.carried.items()]
    if (
        arm.joint_names != names
        or arm.tools != tools
        or parts != data["parts"]
        or not all(_agree(a, b) for a, b in zip(found, stored, strict=True))
    ):
        said = f"{arm.name} with {', '.join(arm.joint_names)} and tool {' and '.join(arm.tools)}"
        wanted = (
            f"the robot of {path}: {data['arm']} with {', '.join(names)} and tool {' and '.join(tools)}, and links as when the "
            "plan was saved. Its files were changed, or it is another robot: give the right robot="
        )
        raise FileFormatError("robot", said, wanted)
    other = [kind for kind in LIMITS if not np.array_equal(getattr(arm.limits, kind), read_array(data["limits"][kind]))]
    if other:
        log.warning("%s: the robot given has other limits (%s) than the plan was made and checked for", path, ", ".join(other))
    return arm


def _apply_changes(arm: Robot, path: Path, data: Mapping[str, Any], folder: Path) -> Robot:
    """The arm with the base, the tool frames and the parts of the data."""
    base = read_array(data["base"])
    if not np.array_equal(base, arm.base):
        arm = arm.at(base)
    for added in data["frames"]:
        arm = arm.with_tool(read_array(added["pose"]), name=added["name"], tool=added["frame"])
    return with_parts(arm, path, data, folder)


def with_parts(arm: Robot, path: Path, data: Mapping[str, Any], folder: Path) -> Robot:
    """The arm with the parts of the data instead of those that it carries; as it is where the data have none.

    A part may be in the hand of another arm, which does not move.
    """
    if "carried" not in data:
        return arm
    for name in arm.carried:
        arm = arm.detach(name)
    solids = scene_of(path, data["carried"], folder, None).named
    for solid, (name, _, frame) in zip(solids, data["parts"], strict=True):
        geometry, bodies = with_part(arm.model, arm.geometry, frame, solid, name)
        arm = replace(
            arm, geometry=geometry, carried={**arm.carried, name: CarriedPart(solid=solid, bodies=bodies, frame=frame)}
        )
    return arm


def _agree(first: Array, second: Array) -> bool:
    return first.shape == second.shape and np.allclose(first, second, rtol=0.0, atol=REBUILT_TOLERANCE)


def scene_data(scene: Scene, folder: Path) -> Any:
    """The data of a scene for a file in `folder`, or why there are none: an obstacle is of an unknown class."""
    try:
        obstacles = [{key: _store(value, folder) for key, value in entry.items()} for entry in scene.entries()]
        return {"obstacles": obstacles, "allowed": scene.allowed_names()}
    except InvalidInputError as error:
        return {"missing": str(error)}


def scene_of(path: Path, data: Any, folder: Path, given: Scene | None) -> Scene:
    """The scene rebuilt from the data, or the one given."""
    if given is not None:
        return instance("scene", given, Scene)
    if "missing" in data:
        raise FileFormatError("file", str(path), f"a result with its scene, but {data['missing']}; give scene=")
    entries = [{key: _restore(key, value, folder) for key, value in entry.items()} for entry in data["obstacles"]]
    try:
        return Scene.from_entries(entries, folder, allowed=data["allowed"])
    except InvalidInputError as error:
        wanted = f"a result whose scene can be built again ({error}); put its files back, or give scene="
        raise FileFormatError("file", str(path), wanted) from error


def _store(value: Any, folder: Path) -> Any:
    """A value of an obstacle: paths as two, many numbers compressed."""
    if isinstance(value, Path):
        return absolute_and_relative(value, folder)
    return pack_array(np.array(value, dtype=float)) if isinstance(value, list) and len(value) > MANY else value


def _restore(key: str, value: Any, folder: Path) -> Any:
    if key == "file":
        return found_again(value, folder)
    return unpack_array(value) if isinstance(value, Mapping) else value


def _option(key: str, value: Any, change: Callable[[Any], Any]) -> Any:
    """An option of a robot, with its paths changed and its lists of numbers as arrays."""
    if key in FILES:
        return change(value)
    if key in FOLDERS:
        return [change(each) for each in value]
    if key in FOLDERS_BY_NAME:
        return {name: change(folder) for name, folder in value.items()}
    return read_array(value) if key in (*LIMITS, "neutral", "lengths") else value


FORMAT, VERSION = "manipplan-plan", 3
#: Parts of a plan that `from_json` restores, and numbers of its result, each with its type.
PARTS = {
    "path": JointPath,
    "trajectory": Trajectory,
    "report": PlanReport,
    "tolerance": Tolerance,
    "refinement": Refinement,
}
FIGURES = {"g": float, "length": float, "min_manipulability": float, "min_at": float, "first_paths": int, "missing": float}
#: Name of the file in a result's folder.
NAME = "plan.json"


def write_plan(plan: "PartialPlan", file: Path, *, problem: str | None = None, home: Path | None = None) -> None:
    """Write a plan, with the keys of its problem and of this code; parts that cannot be written are logged, also at reading.

    `home` is the folder that the file will be in; None: the one that it is written to.
    """
    import manipplan

    folder = (home if home is not None else file.parent).expanduser().resolve()
    data = {
        "format": FORMAT,
        "version": VERSION,
        "manipplan": manipplan.__version__,
        "code": code_key() if problem is not None else None,
        "robot": robot_data(plan.robot, folder),
        "scene": scene_data(plan.scene, folder),
        "problem": problem,
        **_result_data(plan.result),
        "status": plan.status,
        "message": plan.message,
        **{name: getattr(plan, name) for name in PARTS},
        "workspace_path": _workspace_data(plan.workspace_path),
        "constraints": [constraint_data(each) for each in plan.constraints],
        "goal_index": plan.goal_index,
        "candidates": plan.candidates,
    }
    for part in ("robot", "scene", "measure", "workspace_path"):
        lost = data.get(part)
        if isinstance(lost, dict) and "missing" in lost:
            log.warning("%s: not written: %s, %s", file, part, lost["missing"])
    for each in data["constraints"]:
        if "missing" in each:
            log.warning("%s: not written: %s", file, each["missing"])
    write_checked_json(file, data)


def write_checked_json(file: Path, data: Mapping[str, Any]) -> None:
    """Write a file that `read_checked_json` reads."""
    plain = json_ready(data)
    write_text(file, json.dumps({**plain, "sha256": checksum(plain)}, allow_nan=False) + "\n")


def _result_data(result: PathResult | None) -> dict[str, Any]:
    if result is None:
        return {"result": None}
    return {
        "task": result.task,
        "measure": measure_data(result.measure),
        "power": result.power,
        "floor": result.floor,
        "metric": result.metric,
        "seed": result.seed,
        "result": {name: getattr(result, name) for name in (*FIGURES, "status", "seed_cost", "certificate")},
    }


def read_plan(file: str | Path, *, robot: Robot | None, scene: Scene | None, measure: Measure | None) -> "Plan":
    """Read a file of `write_plan`; see `Plan.load`."""
    from manipplan.plans.result import Plan

    path = _plan_file(file)
    plan = plan_of(path, read_checked_json(path), robot=robot, scene=scene, measure=measure)
    if not isinstance(plan, Plan):
        wanted = f"a plan with a trajectory; this one has none, with status {plan.status.name}: {plan.message}"
        raise FileFormatError("file", str(path), wanted)
    return plan


def plan_of(
    path: Path, data: Mapping[str, Any], *, robot: Robot | None, scene: Scene | None, measure: Measure | None
) -> "PartialPlan":
    """The plan of a file's data, a Plan if it has a trajectory."""
    from manipplan.plans.result import PartialPlan, Plan

    folder = path.resolve().parent
    with reading("file", path, "a result written by Plan.save, unchanged since"):
        parts: dict[str, Any] = {
            "robot": robot_of(path, data["robot"], folder, robot),
            "scene": scene_of(path, data["scene"], folder, scene),
            "status": Status[data["status"]],
            "message": str(data["message"]),
            **{name: None if data[name] is None else from_json(data[name], kind) for name, kind in PARTS.items()},
            "workspace_path": _maybe(data["workspace_path"], _workspace),
            "constraints": _constraints(data["constraints"]),
            "goal_index": int(data["goal_index"]),
            "candidates": tuple(from_json(each, GoalCandidate) for each in data["candidates"]),
        }
        parts["result"] = _maybe(data["result"], lambda numbers: _path_result(path, data, numbers, parts["path"], measure))
        complete = all(parts[name] is not None for name in ("path", "trajectory", "report", "result"))
        return Plan(**parts) if complete else PartialPlan(**parts)


def _path_result(
    path: Path, data: Mapping[str, Any], numbers: Mapping[str, Any], joints: JointPath, measure: Measure | None
) -> PathResult:
    return PathResult(
        path=joints,
        # a seed that is the path itself remains the same object, by which pictures know that there is only one path
        seed=joints if data["seed"] == data["path"] else from_json(data["seed"], JointPath),
        **{name: kind(numbers[name]) for name, kind in FIGURES.items()},
        power=float(data["power"]),
        floor=float(data["floor"]),
        task=from_json(data["task"], Task),
        measure=restore_measure(path, data["measure"], measure),
        metric=_maybe(data["metric"], read_array),
        seed_cost=from_json(numbers["seed_cost"], PathCost),
        history=(),
        status=Status[numbers["status"]],
        certificate=_maybe(numbers["certificate"], lambda data: from_json(data, Certificate)),
    )


def checksum(data: Mapping[str, Any]) -> str:
    """SHA-256 of all other values of a file, in hexadecimal digits."""
    return hashlib.sha256(json.dumps(data).encode()).hexdigest()


def _workspace_data(workspace: CartesianPath | None) -> Any:
    if workspace is None:
        return None
    kind = type(workspace)
    if PATHS.get(kind.__name__) is not kind:
        return {"missing": f"a path of a class of your own, {kind.__name__}"}
    values = {each.name: getattr(workspace, each.name) for each in fields(workspace)}  # type: ignore[arg-type]  # a dataclass
    inner = {key: _workspace_data(value) for key, value in values.items() if isinstance(value, CartesianPath)}
    missing = next((each["missing"] for each in inner.values() if each is not None and "missing" in each), None)
    return {"missing": missing} if missing else {"kind": kind.__name__, **values, **inner}


def _workspace(data: Mapping[str, Any]) -> CartesianPath | None:
    """The workspace path; None if its class cannot be stored, which was logged when the plan was saved."""
    if "missing" in data:
        log.warning("the workspace path is missing: %s", data["missing"])
        return None
    values: dict[str, Any] = {
        key: read_array(value) if isinstance(value, list) else _workspace(value) if isinstance(value, dict) else value
        for key, value in data.items()
        if key != "kind"
    }
    return PATHS[data["kind"]](**values)


def _constraints(data: Sequence[Mapping[str, Any]]) -> tuple[Constraint, ...]:
    """The constraints, without those whose class cannot be stored, which was logged when the plan was saved."""
    for each in data:
        if "missing" in each:
            log.warning("a constraint is missing: %s", each["missing"])
    return tuple(constraint_of(each) for each in data if "missing" not in each)


def _maybe(data: Any, build: Callable[[Any], Any]) -> Any:
    return None if data is None else build(data)


def _plan_file(file: str | Path) -> Path:
    """The plan's file, given by its own path or by its folder."""
    path = path_of("file", file)
    if is_folder(path):
        finish(path)
        inside = path / NAME
        if not inside.is_file():
            raise FileFormatError("file", str(file), f"a folder written by Plan.save, with {NAME} in it")
        return inside
    return existing_file("file", file)


def read_checked_json(path: Path, kind: str = FORMAT, number: int = VERSION) -> dict[str, Any]:
    """The data of a file, of a format and version and unchanged."""
    try:
        data = read_json("file", path)
    except FileFormatError as error:
        wanted = f"a complete result ({error.allowed}); it was truncated or is not a {path.name}: save the plan again"
        raise FileFormatError("file", str(path), wanted) from error
    if not isinstance(data, dict) or data.get("format") != kind:
        raise FileFormatError("file", str(path), f"a result written by Plan.save, an object with format {kind!r}")
    version = data.get("version")
    if version != number:
        wanted = (
            f"a result of version {number}; this is version {version!r}, written by manipplan {data.get('manipplan')!r}: "
            "read it with that version, or install that version here"
        )
        raise FileFormatError("file", str(path), wanted)
    if data.pop("sha256", None) != checksum(data):
        raise FileFormatError(
            "file", str(path), "a result as Plan.save wrote it; this one was changed since: save the plan again"
        )
    return data
