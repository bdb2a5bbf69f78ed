"""Plans in one JSON file, written and read: all data needed to show a plan, to check it again and to play it.

The file holds the source of the robot, not the robot itself, and the joints' names, limits and screws and the outlines of the
bodies, by which a different robot is detected. A checksum detects a file that was changed. Numbers keep all their digits.
Infinite ones are strings, since JSON has none.
"""

import hashlib
import json
import logging
from collections.abc import Callable, Mapping
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

from manipplan.collision.scene import Scene
from manipplan.cost.integral import PathCost
from manipplan.jobs.check import Report
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
from manipplan.support.checks import existing_file
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.files import write_text
from manipplan.support.json_data import from_json, json_ready, stored_array
from manipplan.support.status import Status
from manipplan.symbolic.task import Task

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan

log = logging.getLogger("manipplan")

FORMAT, VERSION = "manipplan-plan", 1
#: Name of the file in a result's folder.
NAME = "plan.json"


def write_plan(plan: "Plan", file: Path) -> None:
    """Write a plan that has a trajectory. Parts that cannot be written are logged, now and when the file is read."""
    import manipplan

    result = plan.result
    folder = file.expanduser().resolve().parent
    figures = ("g", "length", "min_manipulability", "min_at", "status", "seed_cost", "certificate", "first_paths", "missing")
    data = {
        "format": FORMAT,
        "version": VERSION,
        "manipplan": manipplan.__version__,
        "robot": robot_data(plan.robot, folder),
        "scene": scene_data(plan.scene, folder),
        "task": result.task,
        "measure": measure_data(result.measure),
        "power": result.power,
        "floor": result.floor,
        "metric": result.metric,
        "status": plan.status,
        "message": plan.message,
        "path": plan.path,
        "seed": result.seed,
        "result": {name: getattr(result, name) for name in figures},
        "trajectory": plan.trajectory,
        "report": plan.report,
        "workspace_path": _workspace_data(plan.workspace_path),
        "tolerance": plan.tolerance,
        "refinement": plan.refinement,
        "deviation": plan.deviation,
    }
    for part in ("robot", "scene", "measure", "workspace_path"):
        if isinstance(data[part], dict) and "missing" in data[part]:
            log.warning("%s: not written: %s, %s", file, part, data[part]["missing"])
    plain = json_ready(data)
    write_text(file, json.dumps({**plain, "sha256": checksum(plain)}, allow_nan=False) + "\n")


def read_plan(file: str | Path, *, robot: Robot | None, scene: Scene | None, measure: Measure | None) -> "Plan":
    """Read a file of `write_plan`; see `Plan.load`."""
    from manipplan.jobs.result import Plan

    path = _plan_file(file)
    data = _checked_json(path)
    folder = path.resolve().parent
    try:
        arm = robot_of(path, data["robot"], folder, robot)
        world = scene_of(path, data["scene"], folder, scene)
        restored = measure_of(path, data["measure"], measure)
        joints = from_json(data["path"], JointPath)
        # a seed that is the path itself remains the same object, by which pictures know that there is only one path
        seed = joints if data["seed"] == data["path"] else from_json(data["seed"], JointPath)
        numbers = data["result"]
        result = PathResult(
            path=joints,
            seed=seed,
            g=float(numbers["g"]),
            length=float(numbers["length"]),
            min_manipulability=float(numbers["min_manipulability"]),
            min_at=float(numbers["min_at"]),
            power=float(data["power"]),
            floor=float(data.get("floor", 0.0)),  # files of version 0.1 have none
            task=from_json(data["task"], Task),
            measure=restored,
            metric=_maybe(data["metric"], stored_array),
            seed_cost=from_json(numbers["seed_cost"], PathCost),
            history=(),
            status=Status[numbers["status"]],
            certificate=from_json(numbers["certificate"], Certificate),
            first_paths=int(numbers.get("first_paths", 1)),  # older files have none
            missing=float(numbers.get("missing", "nan")),
        )
        return Plan(
            robot=arm,
            scene=world,
            status=Status[data["status"]],
            message=str(data["message"]),
            path=joints,
            trajectory=from_json(data["trajectory"], Trajectory),
            report=from_json(data["report"], Report),
            result=result,
            workspace_path=_maybe(data["workspace_path"], _workspace),
            tolerance=_maybe(data["tolerance"], lambda each: from_json(each, Tolerance)),
            refinement=_maybe(data["refinement"], lambda each: from_json(each, Refinement)),
            deviation=_maybe(data["deviation"], lambda each: from_json(each, Deviation)),
        )
    except FileFormatError:
        raise
    except (InvalidInputError, KeyError, TypeError, ValueError, AttributeError, OverflowError, OSError) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:200]
        raise FileFormatError("file", str(path), f"a result written by Plan.save, unchanged since ({reason})") from error


def checksum(data: Mapping[str, Any]) -> str:
    """SHA-256 of all other values of a file, in hexadecimal digits."""
    return hashlib.sha256(json.dumps(data).encode()).hexdigest()


def _workspace_data(workspace: CartesianPath | None) -> Any:
    if workspace is None:
        return None
    kind = type(workspace)
    if PATHS.get(kind.__name__) is not kind:
        return {"missing": f"a path of a class of your own, {kind.__name__}"}
    return {"kind": kind.__name__, **{each.name: getattr(workspace, each.name) for each in fields(workspace)}}  # type: ignore[arg-type]  # a dataclass


def _workspace(data: Mapping[str, Any]) -> CartesianPath | None:
    """The workspace path; None if its class cannot be stored, which was logged when the plan was saved."""
    if "missing" in data:
        log.warning("the workspace path is missing: %s", data["missing"])
        return None
    values: dict[str, Any] = {
        key: stored_array(value) if isinstance(value, list) else value for key, value in data.items() if key != "kind"
    }
    return PATHS[data["kind"]](**values)


def _maybe(data: Any, build: Callable[[Any], Any]) -> Any:
    return None if data is None else build(data)


def _plan_file(file: str | Path) -> Path:
    """The plan's file, given by its own path or by its folder."""
    if isinstance(file, str | Path) and Path(file).expanduser().is_dir():
        inside = Path(file).expanduser() / NAME
        if not inside.is_file():
            raise FileFormatError("file", str(file), f"a folder written by Plan.save, with {NAME} in it")
        return inside
    return existing_file("file", file)


def _checked_json(path: Path) -> dict[str, Any]:
    try:
        data = json.loads(path.read_text())
    except (ValueError, OSError, RecursionError) as error:
        wanted = f"a complete result ({error}); it was truncated or is not a {NAME}: save the plan again"
        raise FileFormatError("file", str(path), wanted) from error
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise FileFormatError("file", str(path), f"a result written by Plan.save, an object with format {FORMAT!r}")
    version = data.get("version")
    if version != VERSION:
        wanted = (
            f"a result of version {VERSION}; this is version {version!r}, written by manipplan {data.get('manipplan')!r}: "
            "read it with that version, or install that version here"
        )
        raise FileFormatError("file", str(path), wanted)
    if data.pop("sha256", None) != checksum(data):
        raise FileFormatError(
            "file", str(path), "a result as Plan.save wrote it; this one was changed since: save the plan again"
        )
    return data
