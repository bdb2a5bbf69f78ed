"""One valid call of every public function, and odd values for each of its arguments.

`calls(folder)` gives the calls by name. Each argument is replaced in turn: by values that are wrong whatever the argument
means (`never`), where only an error of the package will do, and by values that may be right (`perhaps`).
"""

import contextlib
import inspect
import signal
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import manipplan as mp
from manipplan import formulations, planar, viz
from manipplan.viz import viewer

LONGEST = 5.0


class Hostile:
    """Nothing can be done with it."""

    def _fail(self, *_, **__):
        raise RuntimeError("hostile")

    __array__ = __eq__ = __repr__ = __str__ = __len__ = __iter__ = __bool__ = __float__ = __index__ = __getitem__ = _fail
    __lt__ = __le__ = __gt__ = __ge__ = __contains__ = __add__ = __mul__ = __fspath__ = __int__ = _fail
    __hash__ = object.__hash__


class TooSlow(BaseException):
    """A call takes longer than `LONGEST`."""


@dataclass
class Call:
    """A function with valid arguments.

    `free` names those that may be anything, such as a title, or that are checked where they are used; `nan` those in which NaN
    is an ordinary value, such as depth images. `heavy` calls get no values that may be right.
    """

    function: Callable[..., Any]
    arguments: dict[str, Any] = field(default_factory=dict)
    free: tuple[str, ...] = ()
    nan: tuple[str, ...] = ()
    heavy: bool = False


def _contains_itself() -> list[Any]:
    value: list[Any] = [1.0]
    value.append(value)
    return value


def never(valid: Any) -> Iterator[Any]:
    """Values that are wrong wherever `valid` is right."""
    yield from (Hostile(), [Hostile()], b"bytes", 1j, object(), np.array([b"a"]), np.array([1 + 1j]), _contains_itself())
    yield from (
        np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 0]),
        10**5000,
        -(10**5000),
        [10**400, 0, 0],
        np.nan,
        np.array([np.nan] * 3),
    )
    if isinstance(valid, bool):
        yield from (0, 1, 1.0, "nan", "False", np.array([True, False]), [True], None)
    elif isinstance(valid, float | int):
        yield from (True, "1", "1e3", [valid, valid], np.array([[1.0, 2.0]]), np.datetime64("2020-01-01"), np.bool_(True))
    elif isinstance(valid, str):
        yield from (3, True, {"a": 1}, np.array(["a", "b"]), 0.5)
    elif isinstance(valid, np.ndarray | list | tuple):
        array = np.asarray(valid, dtype=None if _is_even(valid) else object)
        if array.size and array.dtype.kind in "iuf":
            flat = array.astype(float)
            spoiled = flat.copy()
            spoiled[(0,) * flat.ndim] = np.nan
            yield from (
                np.ma.array(flat, mask=flat > flat.min()),
                np.ma.array(flat),
                [np.ma.array(flat)],
                spoiled,
                spoiled.tolist(),
            )
            yield from (
                flat.astype(bool),
                flat.astype(str),
                flat.astype(str).tolist(),
                flat.astype(complex),
            )
            huge = flat.astype(object)
            huge[(0,) * flat.ndim] = 10**400
            yield from (huge, huge.tolist())
            if flat.ndim:
                truth = flat.tolist()
                inner = truth
                while isinstance(inner[0], list):
                    inner = inner[0]
                inner[0] = True
                yield truth
    elif hasattr(valid, "__dict__") or hasattr(valid, "__slots__"):
        yield from (type(valid), "\0", True)


def has_nan(value: Any) -> bool:
    """Whether there is NaN among real numbers."""
    if isinstance(value, np.ma.MaskedArray) or not isinstance(value, np.ndarray | list | float):
        return False
    if isinstance(value, list):
        return _is_even(value) and any(map(has_nan, value))
    return np.asarray(value).dtype.kind == "f" and bool(np.isnan(value).any())


def _is_even(value: Any) -> bool:
    """Whether NumPy can make an array of it: lists in lists have one length."""
    lengths = {len(each) if isinstance(each, list | tuple | np.ndarray) else -1 for each in value}
    return len(lengths) == 1 and all(_is_even(each) for each in value if isinstance(each, list | tuple))


def perhaps() -> Iterator[Any]:
    """Values that are right for some arguments."""
    yield from (None, np.inf, -np.inf, -1, 0, 1, 0.5, -1.0, 1e300, -1e300, 1e-320, 2**31, 2**63, -(2**63), 10**12, "", "x", "/")
    yield from ([], {}, (), np.empty(0), np.empty((0, 3)), np.zeros((4, 4)), [[]], [None], {"a": None}, len, int, "x" * 100_000)
    yield from (
        [1e300] * 3,
        [1e-320] * 3,
        np.zeros(3),
        np.full(3, 1e30),
        np.float16(0.1),
        np.zeros((3, 3), dtype=int),
        "\ud800",
    )


@contextlib.contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """Raise TooSlow where the block takes longer."""

    def stop(*_: Any) -> None:
        raise TooSlow

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def outcome(call: Call, name: str, value: Any) -> str:
    """What comes of the call with another value: "accepted", "refused", or what is wrong."""
    try:
        with at_most(LONGEST):
            call.function(**{**call.arguments, name: value})
    except mp.errors.ManipplanError as error:
        return "refused" if str(error) else "an error without a text"
    except TooSlow:
        return f"more than {LONGEST} s"
    except Exception as error:
        import traceback

        last = traceback.extract_tb(error.__traceback__)[-1]
        return f"{type(error).__name__}: {error} ({Path(last.filename).name}:{last.lineno})"[:300]
    return "accepted"


def calls(folder: Path) -> dict[str, Call]:
    """A valid call of each function; files are written to `folder`."""
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    q, goal = np.array([0.1, 0.6, 0.8]), np.array([0.4, 0.5, 0.9])
    kinematics = arm.kinematics()
    pose, away = kinematics.pose(q), kinematics.pose(goal)
    scene = mp.Scene(
        [
            mp.Sphere(radius=0.1, position=(5.0, 0.0, 0.0), name="ball"),
            mp.Box(size=(0.1, 0.1, 0.1), position=(0, 6, 0), name="box"),
        ]
    )
    path = mp.JointPath.line(q, goal)
    motion = mp.retime(path, arm)
    line = mp.CartesianPath.line(pose, away)
    position = mp.Task.planar()
    objective, shape, seeding = mp.PathObjective(), mp.PathShape(), mp.Seeding()
    layers = mp.sample_layers(arm, line, 4, task=position, measure="yoshikawa")
    found = mp.max_min_search(layers, 1.0)
    plan = mp.plan(arm, q, goal)
    reach = [0.0, -0.8, 0.0, -2.4, 0.0, 1.6, 0.8]
    link = planar.PlanarArm([1.0, 1.0, 1.0])
    two = planar.PlanarArm([1.0, 1.0])
    tracking = mp.track(arm, line, q, formulations.General(), dt=0.05, duration=1.0, task=position)
    followed = mp.follow(arm, line, positions=4)
    step = {"pose": pose}
    jacobian = np.array([[1.0, 0.2, 0.1], [0.3, 1.0, 0.5]])
    mesh = folder / "mesh.stl"
    mesh.write_text(_tetrahedron())
    motion.to_csv(folder / "m.csv")
    motion.to_json(folder / "m.json")
    motion.to_ros(folder / "m.yaml")
    motion.to_npz(folder / "m.npz")
    scene.to_yaml(folder / "scene.yaml")
    (folder / "poses.csv").write_text("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n1,0,0,1,0,0,0\n")
    (folder / "arm.urdf").write_text(_urdf())
    np.save(folder / "cloud.npy", [[1, 2, 3], [4, 5, 6.0]])
    plan.report.to_json(folder / "report.json")
    plan.save(folder / "saved")
    mp.sequence(arm, q, [mp.MoveTo(goal)]).save(folder / "program")
    motion.to_rosbag(folder / "recorded")
    (folder / "world.scene").write_text("(noname)+\n* ball\n1\nsphere\n0.1\n1 0 0\n0 0 0 1\n0 0 0 0\n.\n")
    (folder / "world.xml").write_text('<mujoco><worldbody><geom size=".1" pos="3 0 0"/></worldbody></mujoco>')
    ur = ("shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint")
    franka = tuple(f"panda_joint{k}" for k in range(1, 8))
    usual = np.array([0.0, 0, 0, -1.5, 0, 1.5, 0])
    of_ur, of_franka = (
        mp.retime(
            mp.JointPath.line(usual[: len(names)], usual[: len(names)] + 0.1),
            mp.load_robot(robot),
        )
        for names, robot in ((ur, "ur5"), (franka, "panda"))
    )
    solid = {"position": (0.0, 0.0, 0.0), "rotation": np.eye(3), "name": "a"}
    baxter, up = mp.load_robot("baxter"), np.eye(4)
    up[2, 3] = 0.02
    hands = {tool: baxter.arm(tool).kinematics().pose(baxter.arm(tool).neutral) for tool in baxter.tools}
    given = []
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    with contextlib.suppress(mp.errors.PlanningError):
        own = mp.Seeding(planner=given.append, time_limit=1e5)
        mp.seed_path(mp.planar_arm([1.0, 1.0, 1.0]), [0.0, 1.5, -2.0], [3.14, -2.0, 2.0], post, seeding=own)
    problem = given[0]
    C = Call
    ends = {"robot": arm, "start": q, "goal": goal, "scene": scene}
    found_calls = {
        "Attach": C(mp.Attach, {"part": mp.Sphere(radius=0.1), "name": "ball", "tool": ""}, free=("part",)),
        "Detach": C(mp.Detach, {"name": "part"}),
        "Wait": C(mp.Wait, {"seconds": 1.0}),
        "MoveTo": C(mp.MoveTo, {"goal": goal}, free=("goal",)),
        "MoveAlong": C(
            mp.MoveAlong,
            {
                "path": line,
                "tool_speed": 0.1,
                "slowdown": 0.1,
                "tolerance": mp.Tolerance(position=0.1),
                "task": position,
                "positions": 9,
            },
        ),
        "Avoidance": C(
            mp.Avoidance,
            {
                "scene": scene,
                "influence": 0.1,
                "security": 0.02,
                "damping": 0.5,
                "moving": ("ball",),
                "links": ("link1",),
                "itself": True,
            },
        ),
        "Box": C(mp.Box, {**solid, "size": (1.0, 1.0, 1.0)}),
        "Sphere": C(mp.Sphere, {**solid, "radius": 1.0}),
        "Capsule": C(mp.Capsule, {**solid, "radius": 1.0, "length": 1.0}),
        "Cylinder": C(mp.Cylinder, {**solid, "radius": 1.0, "length": 1.0}),
        "Plane": C(mp.Plane, solid),
        "Mesh": C(mp.Mesh, {**solid, "file": str(mesh), "scale": 1.0, "up": "z", "fill": "hull"}),
        "PointCloud": C(mp.PointCloud, {**solid, "points": np.array([[1.0, 2.0, 3.0]]), "radius": 0.1, "spacing": 0.01}),
        "PointCloud.from_file": C(mp.PointCloud.from_file, {"file": str(folder / "cloud.npy"), "radius": 0.1, "spacing": 0.0}),
        "PointCloud.from_depth": C(
            mp.PointCloud.from_depth,
            {"image": np.ones((2, 2)), "intrinsics": np.array([[1.0, 0, 1], [0, 1, 1], [0, 0, 1]]), "radius": 0.1},
            nan=("image",),
        ),
        "Box.at": C(mp.Box(size=(1, 1, 1)).at, {"pose": pose}),
        "Box.called": C(mp.Box(size=(1, 1, 1)).called, {"name": "b"}),
        "CartesianPath.line": C(mp.CartesianPath.line, {"start": pose, "end": away}),
        "CartesianPath.circle": C(
            mp.CartesianPath.circle, {"start": pose, "centre": (0.0, 0, 0), "axis": (0.0, 0, 1), "angle": 1.0, "turning": True}
        ),
        "CartesianPath.through": C(mp.CartesianPath.through, {"poses": [pose, away]}),
        "CartesianPath.from_csv": C(mp.CartesianPath.from_csv, {"file": str(folder / "poses.csv")}),
        "CartesianPath.__call__": C(line, {"s": np.array([0.0, 0.5])}),
        "CartesianPath.part": C(line.part, {"begin": 0.1, "end": 0.5}),
        "CartesianPath.sample": C(line.sample, {"n": 5}),
        "ConditionNumber": C(mp.measures.ConditionNumber()),
        "DynamicManipulability": C(mp.measures.DynamicManipulability, {"regularisation": 1e-6}),
        "Isotropy": C(mp.measures.Isotropy, {"regularisation": 1e-6}),
        "LogDet": C(mp.measures.LogDet, {"regularisation": 1e-6}),
        "Yoshikawa": C(mp.measures.Yoshikawa, {"regularisation": 1e-6}),
        "ForceTransmission": C(mp.measures.ForceTransmission, {"direction": (1.0, 0.0)}),
        "VelocityTransmission": C(mp.measures.VelocityTransmission, {"direction": (1.0, 0.0), "regularisation": 1e-6}),
        "FrobeniusNorm": C(mp.measures.FrobeniusNorm, {"weights": (1.0, 2.0, 1.0)}),
        "JointLimitPenalised": C(mp.measures.JointLimitPenalised, {"measure": mp.measures.Yoshikawa(), "k": 1.0}),
        "OverTools": C(mp.measures.OverTools, {"measure": mp.measures.Yoshikawa(), "weights": {"a": 1.0}}),
        **{
            f"{name}.__call__": C(getattr(mp.measures, name)(**options), {"jacobian": jacobian})
            for name, options in _OF_MATRICES.items()
        },
        "Servo": C(
            mp.Servo,
            {
                "robot": arm,
                "dt": 0.01,
                "task": position,
                "side": "same",
                "reference": followed,
                "smoothing": 0.0,
                "timeout": 0.1,
                "compiled": False,
            },
        ),
        "Controller": C(
            mp.Controller,
            {
                "robot": arm,
                "formulation": formulations.General(),
                "dt": 0.01,
                "task": position,
                "measure": "yoshikawa",
                "stiffness": 1e4,
                "weights": (1.0, 1.0, 1.0),
                "approach": 2.0,
                "tolerance": mp.Tolerance(position=0.1),
                "avoidance": mp.Avoidance(scene=scene),
                "reference": followed,
                "compiled": False,
            },
        ),
        "Deviation.excess": C(
            mp.results.Deviation(position=0.1, position_at=0.0, rotation=0.1, rotation_at=0.0).excess,
            {"tolerance": mp.Tolerance(position=0.01), "of": "a"},
            free=("of",),
        ),
        "HeldJoints": C(mp.HeldJoints, {"joints": ("joint1",)}),
        "JointLimits": C(
            mp.JointLimits,
            {name: getattr(arm.limits, name) for name in ("lower", "upper", "velocity", "acceleration", "jerk", "effort")},
        ),
        "JointLimits.with_changes": C(arm.limits.with_changes, {"changes": {"velocity": 1.0}, "source": "given"}),
        "JointLimits.outside": C(arm.limits.outside, {"q": q}),
        "JointPath": C(mp.JointPath, {"breaks": path.breaks, "control": path.control}),
        "JointPath.__call__": C(path, {"s": np.array([0.1, 0.2]), "order": 1}),
        "JointPath.coefficients": C(path.coefficients, {"basis": "monomial"}),
        "JointPath.curve": C(path.curve, {"order": 1}),
        "JointPath.fine_samples": C(path.fine_samples, {"step": 0.01}),
        "JointPath.joined": C(mp.JointPath.joined, {"parts": [path]}),
        "JointPath.line": C(mp.JointPath.line, {"start": q, "goal": goal}),
        "JointPath.panel_edges": C(path.panel_edges, {"panels": 4}),
        "JointPath.quadrature": C(path.quadrature, {"panels": 4, "points": 4}),
        "JointPath.spline": C(
            mp.JointPath.spline, {"s": np.array([0.0, 0.5, 1.0]), "q": np.array([q, goal, q]), "closed": False}
        ),
        "JointPath.through": C(mp.JointPath.through, {"waypoints": np.array([q, goal])}),
        "Kinematics.batch_code": C(kinematics.batch_code, {"quantity": "pose"}),
        "Kinematics.evaluator": C(lambda quantity, evaluator=kinematics.evaluator: evaluator(quantity), {"quantity": "pose"}),
        **{
            f"Kinematics.{name}": C(getattr(kinematics, name), {"q": q})
            for name in ("gradient", "hessian", "jacobian", "manipulability", "mass_matrix", "pose")
        },
        "Evaluator.__call__": C(kinematics.evaluator("pose"), {"q": q}),
        "Layers.from_arrays": C(
            mp.Layers.from_arrays, {"q": [np.zeros((2, 3)), np.ones((1, 3))], "m": [np.ones(2), np.ones(1)], "closed": False}
        ),
        "Layers.inside": C(layers.inside, {"limits": arm.limits}),
        "PathObjective": C(
            mp.PathObjective, {"power": 1.0, "task": position, "measure": "yoshikawa", "metric": (1.0, 1.0, 1.0), "floor": 0.01}
        ),
        **{
            f"PathObjective.{name}": C(getattr(objective, name), {"robot": arm, "compiled": False})
            for name in ("integral", "kinematics", "resolved")
        },
        "PathShape": C(mp.PathShape, {"degree": 6, "basis": "bspline", "pieces": 8, "start_slope": q, "goal_slope": q}),
        "PathShape.ends": C(shape.ends, {"n": 3}),
        "Seeding": C(
            mp.Seeding,
            {"planner": "auto", "seed": 0, "count": 1, "time_limit": 10.0, "shifts": "none", "initial": path},
            free=("initial",),
        ),
        "PoseGoal": C(
            mp.PoseGoal, {"pose": pose, "free_axis": (0.0, 0.0, 1.0), "tolerance": mp.Tolerance(position=0.1), "of": ""}
        ),
        "PoseGoal.missed_by": C(mp.PoseGoal(pose).missed_by, {"robot": arm, "q": q}),
        "PoseGoal.errors": C(mp.PoseGoal(pose).errors, {"robot": arm, "q": q, "tool": arm.tool}),
        "PoseGoal.task": C(mp.PoseGoal(pose).task, {"robot": arm}),
        "PositionBox": C(mp.PositionBox, {"lower": (0.0, 0, 0), "upper": (1.0, 1, 1)}),
        "TiltLimit": C(mp.TiltLimit, {"axis": (0.0, 0, 1), "direction": (0.0, 0, 1), "angle": 0.1}),
        "Problem": C(
            mp.Problem,
            {**ends, "objective": objective, "shape": shape, "seeding": seeding, "clearance": 0.0, "torque": False},
            free=("robot", "start", "goal", "scene", "objective", "shape", "seeding", "clearance", "torque"),
        ),
        "Report.from_json": C(mp.results.Report.from_json, {"file": str(folder / "report.json")}),
        "Report.to_json": C(plan.report.to_json, {"file": str(folder / "r.json")}),
        "Plan.load": C(mp.Plan.load, {"file": str(folder / "saved")}),
        "Plan.save": C(plan.save, {"folder": str(folder / "plan")}, heavy=True),
        "Program.load": C(mp.Program.load, {"folder": str(folder / "program")}),
        "Robot.arm": C(arm.arm, {"tool": arm.tool, "q": q}),
        "Robot.at": C(arm.at, step),
        "Robot.attach": C(arm.attach, {"shape": mp.Sphere(radius=0.1), "name": "ball", "tool": arm.tool}),
        "Robot.detach": C(arm.attach(mp.Sphere(radius=0.1)).detach, {"name": "part"}),
        "Robot.configuration": C(arm.configuration, {"argument": "q", "q": q, "tolerance": 0.1}, free=("argument",)),
        "Robot.from_urdf": C(
            mp.Robot.from_urdf,
            {
                "file": str(folder / "arm.urdf"),
                "tool": "c",
                "joints": ("j",),
                "name": "arm",
                "locked": {"k": 0.1},
                "neutral": np.array([0.1]),
                "package_dirs": (),
                "packages": {},
                "meshes": True,
                "collision": "collision",
                "arguments": {},
                "velocity": 1.0,
                "trust_file": False,
            },
        ),
        "Robot.joints_of": C(arm.joints_of, {"tool": arm.tool}),
        "Robot.kinematics": C(
            arm.kinematics, {"task": position, "measure": "yoshikawa", "backend": "auto", "compiled": False, "threads": 1}
        ),
        "Robot.link_of": C(arm.link_of, {"body": next(iter(arm.geometry.geometryObjects), None)}),
        "Robot.random_configuration": C(arm.random_configuration, {"rng": np.random.default_rng(0), "size": 3}),
        "Robot.to_srdf": C(arm.to_srdf, {"file": str(folder / "a.srdf"), "states": {"a": q}, "group": "arm"}),
        "Robot.with_limits": C(arm.with_limits, {"source": "given", "velocity": np.ones(3), "lower": -np.ones(3), "jerk": 3.0}),
        "Robot.with_inverse_kinematics": C(arm.with_inverse_kinematics, {"solver": np.zeros_like, "complete": True}),
        "Robot.with_tool": C(arm.with_tool, {"pose": pose, "name": "tip", "tool": arm.tool}),
        "Scene": C(mp.Scene, {"obstacles": [mp.Sphere(radius=0.1, name="ball")], "allowed": [("ball", "link1")]}),
        "Scene.allow": C(scene.allow, {"first": "ball", "second": "link1"}),
        "Scene.at": C(scene.at, step),
        "Scene.collision_model": C(scene.collision_model, {"robot": arm}),
        "Scene.distances": C(scene.distances, {"robot": arm, "q": q}),
        "Scene.in_collision": C(scene.in_collision, {"robot": arm, "q": q}),
        "Scene.path_clearance": C(scene.path_clearance, {"robot": arm, "path": path, "clearance": 0.01, "tolerance": 0.001}),
        "Scene.from_entries": C(
            mp.Scene.from_entries, {"entries": [{"shape": "sphere", "radius": 1.0}], "folder": str(folder)}
        ),
        "Scene.from_yaml": C(mp.Scene.from_yaml, {"file": str(folder / "scene.yaml")}),
        "Scene.from_moveit": C(mp.Scene.from_moveit, {"file": str(folder / "world.scene"), "packages": {}}),
        "Scene.from_mjcf": C(mp.Scene.from_mjcf, {"file": str(folder / "world.xml")}),
        "Scene.to_yaml": C(scene.to_yaml, {"file": str(folder / "s.yaml")}),
        "Scene.without": C(lambda name, without=scene.without: without(name), {"name": "ball"}),
        "Segment": C(
            mp.Segment,
            {
                "begin": 0.1,
                "end": 0.5,
                "limits": arm.limits,
                "velocity": 1.0,
                "acceleration": 1.0,
                "jerk": 1.0,
                "tool_speed": 1.0,
            },
        ),
        "SolutionSet.for_pose": C(mp.inverse_kinematics(arm, pose, task=position).for_pose, {"pose": 0}),
        "StiffnessProfile": C(mp.StiffnessProfile, {"high": 1e4, "low": 1.0, "degree": 6.0}),
        "StiffnessProfile.__call__": C(mp.StiffnessProfile(), {"u": 0.5}),
        "Task": C(
            mp.Task,
            {
                "name": "t",
                "world_rows": ((1.0, 0, 0, 0, 0, 0),),
                "tool_rows": ((0.0, 1, 0, 0, 0, 0),),
                "length": 1.0,
                "relative_to": None,
            },
        ),
        "Task.custom": C(mp.Task.custom, {"rows": np.eye(6)[:2], "frame": "world", "length": 1.0, "name": "c"}),
        "Task.direction": C(mp.Task.direction, {"axis": (1.0, 0, 0), "frame": "world", "relative_to": "a"}),
        "Task.rotation": C(mp.Task.rotation, {"axis": (1.0, 0, 0), "frame": "world", "relative_to": "a"}),
        "Task.pointing": C(mp.Task.pointing, {"axis": (1.0, 0, 0), "length": 1.0, "relative_to": "a"}),
        "Task.pose": C(mp.Task.pose, {"length": 1.0, "relative_to": "a"}),
        **{f"Task.{name}": C(getattr(mp.Task, name), {"relative_to": "a"}) for name in ("orientation", "planar", "position")},
        "Task.within": C(
            mp.Task.pose().within,
            {"position": 0.1, "rotation": 0.0, "cone": 0.1, "axis": (1.0, 0, 0), "spin": 1.0, "frame": "tool"},
        ),
        "Tolerance": C(mp.Tolerance, {"position": 0.1, "rotation": 0.1}),
        "Tolerance.scaled": C(mp.Tolerance(position=0.1).scaled, {"factor": 2.0}),
        "Trajectory": C(mp.Trajectory, {"t": motion.t, "q": motion.q, "qd": motion.qd, "joint_names": motion.joint_names}),
        "Trajectory.__call__": C(motion, {"t": np.array([0.0, 0.1]), "order": 1}),
        "Trajectory.from_csv": C(mp.Trajectory.from_csv, {"file": str(folder / "m.csv"), "joints": list(arm.joint_names)}),
        "Trajectory.from_json": C(mp.Trajectory.from_json, {"file": str(folder / "m.json")}),
        "Trajectory.from_ros": C(mp.Trajectory.from_ros, {"file": str(folder / "m.yaml")}),
        "Trajectory.from_npz": C(mp.Trajectory.from_npz, {"file": str(folder / "m.npz")}),
        "Trajectory.from_rosbag": C(
            mp.Trajectory.from_rosbag, {"file": str(folder / "recorded"), "topic": "/joint_states", "joints": ["joint1"]}
        ),
        "Trajectory.in_order": C(motion.in_order, {"joint_names": arm.joint_names}),
        "Trajectory.named": C(motion.named, {"joint_names": motion.joint_names}),
        "Trajectory.slower": C(motion.slower, {"factor": 2.0}),
        **{
            f"Trajectory.{name}": C(getattr(motion, name), {"file": str(folder / "out")})
            for name in ("to_csv", "to_json", "to_npz", "to_ros")
        },
        "Trajectory.to_franka_csv": C(of_franka.to_franka_csv, {"file": str(folder / "franka.csv")}),
        "Trajectory.to_rosbag": C(motion.to_rosbag, {"file": str(folder / "bag"), "storage": "mcap", "rate": 100.0}),
        "Trajectory.to_urscript": C(
            of_ur.to_urscript, {"file": str(folder / "u"), "rate": 500, "name": "a", "lookahead_time": 0.1, "gain": 300.0}
        ),
        "carry": C(
            mp.carry,
            {
                "robot": baxter,
                "path": mp.CartesianPath.line(hands["left_gripper"], up @ hands["left_gripper"]),
                "grasps": {
                    "left_gripper": np.eye(4),
                    "right_gripper": np.linalg.inv(hands["left_gripper"]) @ hands["right_gripper"],
                },
                "scene": mp.Scene(),
                "start": baxter.neutral,
                "positions": 5,
                "epsilon": 0.4,
                "samples": 12,
                "tolerance": mp.Tolerance(position=0.01),
                "clearance": 0.0,
                "torque": False,
                "seed": 0,
                "throw": False,
            },
            heavy=True,
        ),
        "check": C(
            mp.check,
            {
                "robot": arm,
                "trajectory": motion,
                "scene": scene,
                "start": q,
                "goal": goal,
                "path_begin": 0.0,
                "path_parts": (),
                "constraints": (),
                "clearance": 0.0,
                "objective": objective,
                "torque": False,
            },
            heavy=True,
        ),
        "dynamic_ellipsoid": C(mp.measures.dynamic_ellipsoid, {"jacobian": jacobian, "mass_matrix": np.eye(3)}),
        "force_ellipsoid": C(mp.measures.force_ellipsoid, {"jacobian": jacobian}),
        "velocity_ellipsoid": C(mp.measures.velocity_ellipsoid, {"jacobian": jacobian}),
        "fewest_interruptions": C(mp.fewest_interruptions, {"layers": layers, "epsilon": 0.5, "strict": True}),
        "max_min_search": C(mp.max_min_search, {"layers": layers, "epsilon": 0.5, "strict": True, "prefer": "shortest"}),
        "refine": C(
            mp.refine,
            {
                "layers": layers,
                "found": found,
                "tolerance": mp.Tolerance(position=0.1),
                "resample": 2,
                "hold_start": False,
                "time_limit": 10.0,
            },
        ),
        "follow": C(
            mp.follow,
            {
                "robot": arm,
                "path": line,
                "scene": scene,
                "start": q,
                "tool_speed": 0.01,
                "slowdown": 0.1,
                "positions": 6,
                "interruptions": 0,
                "retreat": 0.05,
                "objective": mp.PathObjective(task=position),
                "epsilon": 0.5,
                "samples": 4,
                "tolerance": None,
                "clearance": 0.0,
                "closed": False,
                "torque": False,
                "seeding": seeding,
                "time_limit": 60.0,
                "throw": True,
            },
            heavy=True,
        ),
        "improve": C(
            mp.improve,
            {
                "robot": arm,
                "recorded": motion,
                "scene": scene,
                "duration": 3.0,
                "tolerance": mp.Tolerance(position=0.01),
                "objective": objective,
                "clearance": 0.0,
                "degrees": False,
                "time_limit": 10.0,
                "throw": True,
            },
            heavy=True,
        ),
        "inverse_kinematics": C(
            mp.inverse_kinematics,
            {
                "robot": arm,
                "pose": pose,
                "task": position,
                "samples": 4,
                "method": "auto",
                "turns": True,
                "time_limit": 1.0,
                "seed": 0,
            },
        ),
        "jerk_use": C(mp.jerk_use, {"trajectory": motion, "limits": arm.limits}),
        "limit_use": C(mp.limit_use, {"trajectory": motion, "limits": arm.limits}),
        "torque_use": C(mp.torque_use, {"trajectory": motion, "model": arm.model, "effort": np.ones(3), "inside": 6}),
        "load_robot": C(mp.load_robot, {"name": "ur5"}),
        "optimize_path": C(
            mp.optimize_path,
            {
                **ends,
                "objective": objective,
                "shape": shape,
                "seeding": seeding,
                "constraints": (),
                "clearance": 0.0,
                "throw": True,
                "compare": False,
            },
            heavy=True,
        ),
        "path_cost": C(
            mp.path_cost,
            {"path": path, "kinematics": kinematics, "power": 1.0, "floor": 0.0, "metric": (1.0, 1.0, 1.0), "panels": 10},
        ),
        "pinocchio_casadi": C(mp.pinocchio_casadi, {"robot": arm, "source": "bindings"}),
        "plan": C(
            mp.plan,
            {
                **ends,
                "constraints": (),
                "objective": objective,
                "shape": shape,
                "seeding": seeding,
                "clearance": 0.0,
                "torque": False,
                "throw": True,
            },
            heavy=True,
        ),
        "plan_many": C(mp.plan_many, {"problems": [], "executor": 1}, free=("problems",)),
        "planar_arm": C(mp.planar_arm, {"lengths": (1.0, 1.0), "radius": 0.1}),
        "retime": C(
            mp.retime,
            {
                "path": path,
                "robot": arm,
                "limits": arm.limits,
                "torque": False,
                "segments": (),
                "start_speed": 0.0,
                "end_speed": 0.0,
                "grid": 100,
            },
        ),
        "sample_layers": C(
            mp.sample_layers,
            {
                "robot": arm,
                "path": line,
                "positions": 4,
                "task": position,
                "measure": "yoshikawa",
                "samples": 3,
                "held": None,
                "method": "auto",
                "scene": scene,
                "collisions": True,
                "clearance": 0.0,
                "spare": 0.0,
                "spacing": 0.5,
                "closed": False,
            },
        ),
        "PlannerProblem.is_free": C(problem.is_free, {"q": problem.start}),
        "PlannerProblem.motion_is_free": C(problem.motion_is_free, {"first": problem.start, "last": problem.start}),
        "seed_path": C(
            mp.seed_path,
            {
                **ends,
                "seeding": seeding,
                "same_aspect": False,
                "fewest_crossings": False,
                "checks": 1000,
                "constraints": (),
                "clearance": 0.0,
            },
            heavy=True,
        ),
        "sequence": C(
            mp.sequence,
            {
                "robot": arm,
                "start": q,
                "steps": [mp.MoveTo(goal)],
                "scene": scene,
                "blend": 0.0,
                "objective": objective,
                "shape": shape,
                "seeding": seeding,
                "clearance": 0.0,
                "torque": False,
            },
            heavy=True,
        ),
        "track": C(
            mp.track,
            {
                "robot": arm,
                "path": line,
                "start": q,
                "formulation": formulations.General(),
                "dt": 0.05,
                "duration": 1.0,
                "task": position,
                "reference": followed,
            },
            heavy=True,
        ),
        "formulations.Classical": C(formulations.Classical, {"gain": 1.0, "damping": 1e-6}),
        "formulations.Equality": C(formulations.Equality, {"alpha": 1.0, "sample_time": 0.01, "gradient": "exact"}),
        "formulations.Objective": C(
            formulations.Objective,
            {"alpha": 1.0, "sample_time": 0.01, "gradient": "exact", "hessian": "exact", "convexify": True},
        ),
        "formulations.LogDrive": C(formulations.LogDrive, {"weight": 1.0, "rate": 1.0, "regularisation": 0.001}),
        "planar.PlanarArm": C(planar.PlanarArm, {"lengths": (1.0, 1.0)}),
        **{
            f"planar.PlanarArm.{name}": C(getattr(link, name), {"q": q})
            for name in ("jacobian", "joint_positions", "levers", "orientation", "pose_jacobian", "position", "radius")
        },
        **{f"planar.{name}": C(getattr(planar, name), {"arm": link, "q": q}) for name in _OF_POSTURES},
        **{f"planar.{name}": C(getattr(planar, name), {"arm": link}) for name in _OF_ARMS},
        **{
            f"planar.{name}": C(getattr(planar, name), {"n": 3})
            for name in ("condition_theorem", "frobenius_theorem", "manipulability_theorem")
        },
        **{
            f"planar.{name}": C(getattr(planar, name), {"arm": link, "lower": (-2.0, -2, -2), "upper": (2.0, 2, 2)})
            for name in ("critical_arcs", "reachable_radii", "workspace_boundary", "optimal_radius")
        },
        **{
            f"planar.{name}": C(
                getattr(planar, name), {"arm": link, "position": (1.0, 0.5), "lower": (-2.0, -2, -2), "upper": (2.0, 2, 2)}
            )
            for name in ("is_dexterous", "is_reachable", "reachable_orientations")
        },
        "planar.stationary_postures": C(
            planar.stationary_postures, {"arm": link, "radius": 1.0, "lower": (-2.0, -2, -2), "upper": (2.0, 2, 2)}
        ),
        "planar.pose_postures": C(planar.pose_postures, {"arm": link, "position": (1.0, 0.5), "orientation": 0.3}),
        "planar.position_family": C(planar.position_family, {"arm": link, "position": (1.0, 0.5)}),
        "planar.two_link_postures": C(planar.two_link_postures, {"arm": two, "position": (1.0, 0.5)}),
        "planar.PostureFamily.__call__": C(planar.position_family(link, (1.0, 0.5)), {"orientation": 0.3}),
        "planar.manipulability_bound": C(planar.manipulability_bound, {"n": 3, "total": 1.0}),
        "planar.optimal_lengths": C(planar.optimal_lengths, {"n": 3, "total": 1.0, "least": 0.1, "starts": 2, "seed": 0}),
        "planar.matrix_ellipsoid": C(planar.matrix_ellipsoid, {"matrix": np.eye(2)}),
        "planar.torus_zeros": C(planar.torus_zeros, {"system": [planar.squared_radius_series(two)]}),
        "planar.Annulus.contains": C(planar.reachable_annulus(link).contains, {"position": (1.0, 0.5)}),
        "planar.TrigonometricPolynomial.__call__": C(planar.squared_radius_series(link), {"x": q[1:]}),
        "planar.TrigonometricPolynomial.derivative": C(planar.squared_radius_series(link).derivative, {"variable": 0}),
        "planar.TrigonometricPolynomial.restricted": C(
            planar.squared_radius_series(link).restricted, {"variable": 0, "value": 0.5}
        ),
        "viz.animate": C(
            viz.animate,
            {
                "plan": plan,
                "file": str(folder / "film.gif"),
                "fps": 2.0,
                "speed": 1.0,
                "size": (4.0, 3.0),
                "dpi": 20.0,
                "colours": 96,
            },
            heavy=True,
        ),
        "viz.film": C(
            viz.film,
            {
                "plan": mp.plan(mp.load_robot("panda"), reach, np.add(reach, 0.01)),
                "file": str(folder / "film.webp"),
                "dark": False,
                "width": 300,
                "fps": 2.0,
                "speed": 1.0,
                "colours": 96,
                "quality": 50,
            },
            heavy=True,
        ),
        "viz.viewer.embed": C(viewer.embed, {"plan": plan, "height": 480, "rate": 2.0}, heavy=True),
        "viz.plot_arm": C(viz.plot_arm, {"robot": arm, "path": path, "scene": scene, "places": 3}, heavy=True),
        "viz.plot_joints": C(
            viz.plot_joints, {"trajectory": motion, "limits": arm.limits, "order": 1, "share": False}, heavy=True
        ),
        "viz.plot_layers": C(viz.plot_layers, {"layers": layers, "result": found}, heavy=True),
        "viz.plot_ellipsoids": C(
            viz.plot_ellipsoids, {"kinematics": kinematics, "path": path, "places": 3, "scale": 1.0}, heavy=True
        ),
        "viz.plot_manipulability": C(
            viz.plot_manipulability,
            {"kinematics": kinematics, "paths": {"a": path}, "straight": False, "bound": 1.0},
            heavy=True,
        ),
        "viz.plot_tool_path": C(viz.plot_tool_path, {"robot": arm, "motion": tracking, "workspace_path": line}, heavy=True),
    }
    controller = mp.Controller(arm, formulations.General(), dt=0.01, task=position, compiled=False)
    found_calls["Controller.step"] = C(controller.step, {"q": q, "qd": np.zeros(3), "target": pose}, nan=("q", "qd", "target"))
    found_calls["Controller.brake"] = C(controller.brake, {"q": q, "qd": np.zeros(3)}, nan=("q", "qd"))
    servo = mp.Servo(arm, dt=0.01, task=position, compiled=False)
    still = {"q": q, "qd": np.zeros(3)}
    found_calls["Servo.step"] = C(
        servo.step, {**still, "twist": np.zeros(6), "frame": "tool", "dt": 0.01}, nan=("q", "qd", "twist", "dt")
    )
    found_calls["Servo.step_pose"] = C(servo.step_pose, {**still, "pose": pose, "dt": 0.01}, nan=("q", "qd", "pose", "dt"))
    found_calls["Servo.step_joints"] = C(
        servo.step_joints, {**still, "velocity": np.zeros(3), "dt": 0.01}, nan=("q", "qd", "velocity", "dt")
    )
    found_calls["Servo.brake"] = C(servo.brake, {**still, "dt": 0.01}, nan=("q", "qd", "dt"))
    found_calls["Servo.export_c"] = C(servo.export_c, {"folder": folder / "servo"}, heavy=True)
    found_calls["Controller.rollout"] = C(controller.rollout, {"q": q, "targets": pose[None]})
    return {name: call for name, call in found_calls.items() if name != "ConditionNumber"}


_OF_MATRICES: dict[str, dict[str, Any]] = {
    **{
        name: {}
        for name in (
            "ConditionNumber",
            "InverseCondition",
            "SmallestSingularValue",
            "FrobeniusNorm",
            "Isotropy",
            "LogDet",
            "Yoshikawa",
        )
    },
    "ForceTransmission": {"direction": (1.0, 0.0)},
    "VelocityTransmission": {"direction": (1.0, 0.0)},
}
_OF_POSTURES = [
    "force_ellipse",
    "frobenius_norm",
    "inverse_condition",
    "manipulability",
    "manipulability_gradient",
    "manipulability_hessian",
    "minors",
    "singular_distance",
    "squared_manipulability",
    "squared_manipulability_gradient",
    "squared_manipulability_hessian",
    "stationary_kind",
    "velocity_ellipse",
]
_OF_ARMS = [
    "convexity_counterexample",
    "dexterous_annuli",
    "reachable_annulus",
    "singular_postures",
    "singular_radii",
    "squared_manipulability_series",
    "squared_radius_series",
]


def _tetrahedron() -> str:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    faces = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
    text = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex {} {} {}\n".format(*corners[k]) for k in face)
        + "endloop\nendfacet\n"
        for face in faces
    )
    return f"solid a\n{text}endsolid a\n"


def _urdf() -> str:
    joint = (
        '<joint name="{}" type="revolute"><parent link="{}"/><child link="{}"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/>'
        '<limit lower="-2" upper="2" velocity="1" effort="9"/></joint>'
    )
    joints = joint.format("j", "a", "b") + joint.format("k", "b", "c")
    return f'<robot name="arm"><link name="a"/><link name="b"/><link name="c"/>{joints}</robot>'


def signature_of(call: Call) -> set[str]:
    """The names of all arguments."""
    return set(inspect.signature(call.function).parameters)
