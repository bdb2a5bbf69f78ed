"""Plans in one JSON file, written and read: all data needed to show a plan, to check it again and to play it.

The file holds the source of the robot, not the robot itself, and the joints' names, limits and screws and the outlines of the
bodies, by which a different robot is detected. A checksum detects a file that was changed. Numbers keep all their digits.
Infinite ones are strings, since JSON has none.
"""

import hashlib
import json
import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint
from manipplan.constraints.stored import constraint_data, constraint_of
from manipplan.cost.integral import PathCost
from manipplan.jobs.goals.candidates import GoalCandidate
from manipplan.jobs.reports.report import PlanReport
from manipplan.jobs.stored import robot_data, robot_of, scene_data, scene_of
from manipplan.measures.measure import Measure
from manipplan.measures.stored import measure_data, measure_of
from manipplan.optimize.certificate import Certificate
from manipplan.optimize.result import PathResult
from manipplan.paths.cartesian import PATHS, CartesianPath
from manipplan.paths.deviation import Deviation
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.robot import Robot
from manipplan.search.refine import Refinement
from manipplan.support.checks import existing_file, is_folder, path_of
from manipplan.support.content import code_key
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.files import write_text
from manipplan.support.json_data import from_json, json_ready, read_json, stored_array
from manipplan.support.saving import finish
from manipplan.support.status import Status
from manipplan.symbolic.task import Task

if TYPE_CHECKING:
    from manipplan.jobs.result import PartialPlan, Plan

log = logging.getLogger("manipplan")

FORMAT, VERSION = "manipplan-plan", 1
#: Name of the file in a result's folder.
NAME = "plan.json"


def write_plan(plan: "PartialPlan", file: Path, *, problem: str | None = None, home: Path | None = None) -> None:
    """Write a plan, with the keys of its problem and of this code.

    Parts that cannot be written are logged, now and when the file is read.

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
        "path": plan.path,
        "trajectory": plan.trajectory,
        "report": plan.report,
        "workspace_path": _workspace_data(plan.workspace_path),
        "tolerance": plan.tolerance,
        "refinement": plan.refinement,
        "deviation": plan.deviation,
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
    plain = json_ready(data)
    write_text(file, json.dumps({**plain, "sha256": checksum(plain)}, allow_nan=False) + "\n")


def _result_data(result: PathResult | None) -> dict[str, Any]:
    if result is None:
        return {"result": None}
    figures = ("g", "length", "min_manipulability", "min_at", "status", "seed_cost", "certificate", "first_paths", "missing")
    return {
        "task": result.task,
        "measure": measure_data(result.measure),
        "power": result.power,
        "floor": result.floor,
        "metric": result.metric,
        "seed": result.seed,
        "result": {name: getattr(result, name) for name in figures},
    }


def read_plan(file: str | Path, *, robot: Robot | None, scene: Scene | None, measure: Measure | None) -> "Plan":
    """Read a file of `write_plan`; see `Plan.load`."""
    from manipplan.jobs.result import Plan

    path = _plan_file(file)
    plan = plan_of(path, checked_json(path), robot=robot, scene=scene, measure=measure)
    if not isinstance(plan, Plan):
        wanted = f"a plan with a trajectory; this one has none, with status {plan.status.name}: {plan.message}"
        raise FileFormatError("file", str(path), wanted)
    return plan


def plan_of(
    path: Path, data: Mapping[str, Any], *, robot: Robot | None, scene: Scene | None, measure: Measure | None
) -> "PartialPlan":
    """The plan of a file's data, a Plan if it has a trajectory."""
    from manipplan.jobs.result import PartialPlan, Plan

    folder = path.resolve().parent
    try:
        arm = robot_of(path, data["robot"], folder, robot)
        world = scene_of(path, data["scene"], folder, scene)
        joints = _maybe(data["path"], lambda each: from_json(each, JointPath))
        parts: dict[str, Any] = {
            "robot": arm,
            "scene": world,
            "status": Status[data["status"]],
            "message": str(data["message"]),
            "path": joints,
            "trajectory": _maybe(data["trajectory"], lambda each: from_json(each, Trajectory)),
            "report": _maybe(data["report"], lambda each: from_json(each, PlanReport)),
            "result": _maybe(data["result"], lambda numbers: _path_result(path, data, numbers, joints, measure)),
            "workspace_path": _maybe(data["workspace_path"], _workspace),
            "tolerance": _maybe(data["tolerance"], lambda each: from_json(each, Tolerance)),
            "refinement": _maybe(data["refinement"], lambda each: from_json(each, Refinement)),
            "deviation": _maybe(data["deviation"], lambda each: from_json(each, Deviation)),
            "constraints": _constraints(data.get("constraints", ())),
            "goal_index": int(data.get("goal_index", 0)),  # older files have none
            "candidates": tuple(from_json(each, GoalCandidate) for each in data.get("candidates", ())),
        }
        complete = all(parts[name] is not None for name in ("path", "trajectory", "report", "result"))
        return Plan(**parts) if complete else PartialPlan(**parts)
    except FileFormatError:
        raise
    except (InvalidInputError, KeyError, TypeError, ValueError, AttributeError, OverflowError, OSError) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:200]
        raise FileFormatError("file", str(path), f"a result written by Plan.save, unchanged since ({reason})") from error


def _path_result(
    path: Path, data: Mapping[str, Any], numbers: Mapping[str, Any], joints: JointPath, measure: Measure | None
) -> PathResult:
    return PathResult(
        path=joints,
        # a seed that is the path itself remains the same object, by which pictures know that there is only one path
        seed=joints if data["seed"] == data["path"] else from_json(data["seed"], JointPath),
        g=float(numbers["g"]),
        length=float(numbers["length"]),
        min_manipulability=float(numbers["min_manipulability"]),
        min_at=float(numbers["min_at"]),
        power=float(data["power"]),
        floor=float(data.get("floor", 0.0)),  # files of version 0.1 have none
        task=from_json(data["task"], Task),
        measure=measure_of(path, data["measure"], measure),
        metric=_maybe(data["metric"], stored_array),
        seed_cost=from_json(numbers["seed_cost"], PathCost),
        history=(),
        status=Status[numbers["status"]],
        certificate=_maybe(numbers["certificate"], lambda data: from_json(data, Certificate)),
        first_paths=int(numbers.get("first_paths", 1)),  # older files have none
        missing=float(numbers.get("missing", "nan")),
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
        key: stored_array(value) if isinstance(value, list) else _workspace(value) if isinstance(value, dict) else value
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


def checked_json(path: Path, kind: str = FORMAT, number: int = VERSION) -> dict[str, Any]:
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
