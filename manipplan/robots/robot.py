"""Robot: the active joints cut out of a robot description that move one tool or several, with limits and geometry."""

import logging
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.robots import attached, description, mjcf, model_tree, subchain
from manipplan.robots.arms import (
    arm_of,
    carriers,
    check_tools,
    find_disabled_within_arms,
    known_tool,
    neutral_arm,
    one_tool,
    supports,
)
from manipplan.robots.attached import AddedFrame, CarriedPart, Solid
from manipplan.robots.description import RobotSource
from manipplan.robots.limits import DEFAULT_RAMP_TIME, LARGEST_TOLERANCE, LIMIT_TOLERANCE, JointLimits, check_configuration
from manipplan.robots.model_tree import Mimic
from manipplan.robots.own_ik import OwnInverseKinematics, PoseSolver
from manipplan.robots.srdf import NamedStates, read_srdf, state_of_others, write_srdf
from manipplan.robots.urdf_files import UrdfFiles
from manipplan.support.checks import Array, ArrayLike, existing_file, instance, number, one_of, pose_matrix, text, whole_number
from manipplan.support.display import Pictured
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_source, share_results, state_without_memo

if TYPE_CHECKING:
    from manipplan.collision.self_collisions import SelfCollisions
    from manipplan.kinematics.kinematics import Kinematics
    from manipplan.measures.measure import Measure
    from manipplan.symbolic.task import Task

log = logging.getLogger("manipplan")

#: How far a named state may be outside the limits without a warning, in which its file rounds [rad or m].
STATE_TOLERANCE = 1e-3
#: Maximum number of random configurations per call.
MOST_AT_ONCE = 10**9


@dataclass(frozen=True, kw_only=True, eq=False)
class Robot(Pictured):
    """An arm, or several with a tool each: n active joints and those that follow them; all others are locked.

    Configurations are plain angles [rad] or lengths [m], (n,), also for continuous joints. Build a Robot with
    `load_robot`, `Robot.from_urdf`, `Robot.from_mjcf` or `planar_arm`. A robot holds working data of Pinocchio and IPOPT:
    give every thread or process its own copy, by `copy.deepcopy` or pickle.

    Attributes:
        name: what the arm is called.
        model: the Pinocchio model of the active joints and of those that follow them as mimic joints; its nq = nv = n.
        geometry: the collision geometry of the description (meshes and shapes), placed on `model`.
        tool: name of the tool frame; of several the first.
        other_tools: names of the further tool frames; `tools` has all.
        limits: JointLimits.
        limit_tolerance: a start, goal or other configuration that is given outside a position limit by at most this is taken to
            the limit, as reports and the log say [rad or m]; see `with_limits`.
        neutral: (n,) a posture inside the limits; see `from_urdf`.
        locked: the locked joints of the description, with their values [rad or m].
        disabled_pairs: pairs of links that need no self-collision check, from an SRDF, but for those of two arms with a tool
            each; None without an SRDF.
        unchecked: pairs of geometry objects (by name) that the description exempts from checks, with the reason: on one link,
            or on the parent and the child link of one joint.
        planar: True when the arm moves only in the x-y plane.
        states: the SRDF's named postures that give every active joint a value: (n,) by name [rad or m].
        source: what the arm was read from, to build it again; None for an arm that was built by hand.
        base: (4, 4) pose of the base in the world.
        added_frames: the frames that `with_tool` added.
        carried: the parts that `attach` added, by name, posed in the tool frame.
        own_ik: what `with_inverse_kinematics` was given; None: the library's own method.
    """

    name: str
    model: pin.Model
    geometry: pin.GeometryModel
    tool: str
    other_tools: tuple[str, ...] = ()
    limits: JointLimits
    neutral: Array
    locked: Mapping[str, float] = field(default_factory=dict)
    disabled_pairs: frozenset[frozenset[str]] | None = None
    unchecked: Mapping[frozenset[str], str] = field(default_factory=dict)
    planar: bool = False
    states: Mapping[str, Array] = field(default_factory=NamedStates)
    source: RobotSource | None = None
    base: Array = field(default_factory=lambda: pose_matrix("base", np.eye(4)))
    added_frames: tuple[AddedFrame, ...] = ()
    carried: Mapping[str, CarriedPart] = field(default_factory=dict)
    limit_tolerance: float = LIMIT_TOLERANCE
    own_ik: OwnInverseKinematics | None = None

    @classmethod
    def from_urdf(
        cls,
        file: str | Path,
        *,
        tool: str | Sequence[str] | None = None,
        joints: Sequence[str] | None = None,
        srdf: str | Path | None = None,
        name: str | None = None,
        locked: Mapping[str, float] | str | None = None,
        neutral: ArrayLike | None = None,
        package_dirs: Sequence[str | Path] = (),
        packages: Mapping[str, str | Path] | None = None,
        meshes: bool = True,
        collision: str = "collision",
        arguments: Mapping[str, str | float | bool] | None = None,
        trust_file: bool = False,
        **limits: ArrayLike,
    ) -> "Robot":
        """Read an arm from a URDF or a xacro file.

        Args:
            file: the URDF or xacro file.
            tool: frame (link or joint) whose motion counts, or several, one for each arm. Default: the end effector or the
                chain of the SRDF, or the end of the only arm; where it ends in fingers or a jaw, the body that carries them,
                so that their joints are locked. `robots.ends` has the rule, and the log says what was chosen.
            joints: the active joints, from base to tool. Default: all that move a tool, themselves or by joints that mimic
                them. A joint that mimics an active one moves with it, one that mimics a locked one is locked.
            srdf: MoveIt's semantic description: pairs that are not checked, named postures.
            name: name of the arm. Default: the robot's name in the file.
            locked: values [rad or m] at which other joints are locked, or the name of a state of the SRDF that has them, such
                as "open" of a gripper. Default: the SRDF's first posture, or 0 (or the
                nearest limit). A value outside a joint's limits is accepted, with a warning in the log.
            neutral: (n,) usual posture. Default: the SRDF's first posture, or the middle of the limits.
            package_dirs: where `package://` paths start; the folders above `file` are searched as well.
            packages: folder of each package by its name in `package://name/...`, where the folder has another name.
            meshes: whether collision meshes are read. Without them only the description's primitives are checked, and the log
                says so.
            collision: "visual" checks the visual elements of the links instead of the collision elements, for a description
                that has no others.
            arguments: values of a xacro file's arguments, by name.
            trust_file: whether a xacro file may run Python code and read any file and environment variable. Otherwise it
                gets arithmetic, text, lists and mappings, and files of its own and the other packages.
            **limits: lower, upper, velocity, acceleration, jerk, effort: one number or (n,), instead of the file's. Without
                them, position and velocity limits are also such that joints that follow stay within theirs; the log says so.

        Raises:
            FileFormatError: a file is missing, not XML, cannot be expanded, or Pinocchio cannot read it.
            UnknownNameError: a frame, joint or xacro argument does not exist (the nearest names are listed).
            UnsupportedJointError: an active joint is a mimic, floating or planar joint.
            MissingExtraError: the file has elements of xacro, and the package xacro is not installed.
            InvalidInputError: the description has several arms and no tool is given (the ends are listed), joints out of order,
                limits that are not positive, or a folder in `packages` that does not exist.
        """
        files = UrdfFiles(
            package_dirs=package_dirs,
            packages={} if packages is None else packages,
            meshes=meshes,
            collision=collision,
            arguments={} if arguments is None else arguments,
            trust_file=trust_file,
        )
        read = description.read_urdf(existing_file("file", file), files)
        given = dict[str, Any](tool=tool, joints=joints, srdf=srdf, name=name, locked=locked, neutral=neutral)
        return cls._cut(read, {**given, **limits, **vars(files)}, limits)

    @classmethod
    def from_mjcf(
        cls,
        file: str | Path,
        *,
        tool: str | Sequence[str] | None = None,
        joints: Sequence[str] | None = None,
        srdf: str | Path | None = None,
        name: str | None = None,
        locked: Mapping[str, float] | str | None = None,
        neutral: ArrayLike | None = None,
        **limits: ArrayLike,
    ) -> "Robot":
        """Read an arm from a MuJoCo MJCF file; arguments and errors as for `from_urdf`.

        MJCF states no velocity limits: they are infinite unless `velocity` is given.
        """
        read = mjcf.read_mjcf(existing_file("file", file))
        given = dict[str, Any](tool=tool, joints=joints, srdf=srdf, name=name, locked=locked, neutral=neutral)
        return cls._cut(read, {**given, **limits}, limits)

    @classmethod
    def _cut(cls, read: description.Description, given: Mapping[str, Any], limits: Mapping[str, ArrayLike]) -> "Robot":
        """The arm of a description, by all options that were `given`, `limits` among them."""
        name, locked, neutral = given["name"], given["locked"], given["neutral"]
        if name is not None:
            text("name", name)
        semantic = read_srdf(existing_file("srdf", given["srdf"]), read.model) if given["srdf"] is not None else None
        whole = read.model
        tools = subchain.choose_tools(read, given["tool"], semantic)
        chain = [whole.names[i] for i in sorted({i for each in tools for i in supports(whole, each)})]
        if isinstance(locked, str):
            locked = state_of_others(semantic, locked, chain)
        locked = {} if locked is None else locked
        active = subchain.choose_joints(whole, tools, chain, given["joints"], read.mimics, locked)
        held = subchain.locked_values(whole, active, locked, semantic, read.mimics)
        model, geometry = subchain.reduce(whole, read.geometry, active, held, read.mimics)
        check_tools(model, tools)
        base = subchain.limits_of(model, read.source, limits)
        base = subchain.limits_of_leaders(base, whole, subchain.followers_of(model), active, limits)
        if "acceleration" not in limits:
            with np.errstate(over="ignore"):  # inf: no limit
                ramp = {"acceleration": base.velocity / DEFAULT_RAMP_TIME}
            source = f"default: full speed in {DEFAULT_RAMP_TIME:g} s"
            if np.isinf(base.velocity).all():
                source = "none, as there are no velocity limits; acceleration= gives them"
            base = base.with_changes(ramp, source=source)
        states = NamedStates.of(semantic.states if semantic is not None else (), active)
        for each, q in states.items():
            over = base.outside(q)
            if over.max() > STATE_TOLERANCE:
                worst = int(np.argmax(over))
                log.warning("state %s of the SRDF is outside the limits: %s is %g", each, active[worst], q[worst])
        if neutral is None:
            neutral = next((q for q in states.values() if not base.outside(q).any()), None)
        robot = cls(
            name=name or model.name or read.file.stem,
            model=model,
            geometry=geometry,
            tool=tools[0],
            other_tools=tools[1:],
            limits=base,
            neutral=subchain.usual_posture(base, neutral),
            locked=held,
            disabled_pairs=find_disabled_within_arms(model, tools, semantic.disabled) if semantic is not None else None,
            unchecked=read.unchecked,
            states=states,
            source=RobotSource.of(read.source.lower(), read.file, given),
        )
        if held:
            log.info("%s: locked joints: %s", robot.name, ", ".join(held))
        return robot

    @property
    def n(self) -> int:
        """Number of active joints."""
        return int(self.model.nv)

    @property
    def tools(self) -> tuple[str, ...]:
        """Names of all tool frames."""
        return (self.tool, *self.other_tools)

    def joints_of(self, tool: str) -> tuple[int, ...]:
        """Indices of the active joints that move a tool; raises UnknownNameError for a tool that the robot does not have."""
        return tuple(carriers(self.model, known_tool(self, "tool", tool)))

    def arm(self, tool: str, q: ArrayLike | None = None) -> "Robot":
        """The arm of one tool; other joints are locked at q (n,), by default `neutral`, and their links are still checked.

        A saved plan of it does not say how to build it: give `robot=` when it is loaded.

        Raises UnknownNameError when the robot has no such tool, and InvalidInputError when q is not a configuration.
        """
        joints, q = self.joints_of(tool), None if q is None else self.configuration("q", q)
        if len(joints) == self.n and self.tools == (tool,):
            return self
        return neutral_arm(self, tool) if q is None else arm_of(self, tool, joints, q)

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the active joints, from base to tool; of several arms one after the other."""
        return model_tree.joint_names(self.model)

    @property
    def followers(self) -> dict[str, Mimic]:
        """The joints that move with an active one, by name: position = multiplier * leader's position + offset [rad or m]."""
        return subchain.followers_of(self.model)

    @property
    @once_per_source
    def tree(self) -> model_tree.JointTree:
        """All joints of `model`, followers included, as arrays."""
        return model_tree.joint_tree(self.model)

    @property
    def joint_types(self) -> tuple[str, ...]:
        """'revolute', 'continuous' or 'prismatic' for each active joint."""
        return model_tree.joint_types(self.model, np.isinf(self.limits.lower).tolist())

    @property
    def continuous_joints(self) -> NDArray[np.bool_]:
        """Mask (n,) of the joints of `turns` without a limit on either side."""
        return np.asarray(np.isinf(self.limits.lower) & np.isinf(self.limits.upper) & self.turns)

    @property
    def turns(self) -> NDArray[np.bool_]:
        """Mask (n,) of the joints whose full turn brings the arm back to the same posture.

        They are revolute, and so are their followers, which make whole turns.
        """
        back = ~self.tree.slides & (self.tree.ratio == np.round(self.tree.ratio))
        return np.asarray(np.bincount(self.tree.leader[~back], minlength=self.n) == 0)

    @property
    def default_task(self) -> "Task":
        """Task.planar() for a planar arm, Task.pose() from six joints on (per tool), otherwise Task.position().

        For an arm whose joints cannot make all these motions, such as one of two joints, it is the part that they span, if
        that is fixed in the world or in the tool: x and y for a gantry of two slides. Otherwise the manipulability is
        identically zero, and `plan` searches for the shortest path.
        """
        from manipplan.symbolic.spanned import default_task

        return default_task(self)

    @property
    def self_collisions(self) -> "SelfCollisions":
        """Which pairs of links are checked for contact with each other, and why the others are not; `to_srdf` writes them."""
        from manipplan.collision.self_collisions import SelfCollisions

        return SelfCollisions.of(self)

    def kinematics(
        self,
        task: "Task | None" = None,
        *,
        measure: "Measure | str | None" = None,
        backend: str = "auto",
        compiled: bool | str = "auto",
        threads: int | None = None,
    ) -> "Kinematics":
        """Pose, Jacobian, a measure of manipulability and its derivatives for a task; see `Kinematics`.

        Args:
            task: default `default_task`.
            backend: "chain" (CasADi SX built from the model), "bindings" (pinocchio.casadi), "bridge" (Pinocchio's C++,
                compiled once on this machine; see `pinocchio_casadi`) or "auto": the bindings where they can be imported,
                otherwise the chain. All agree to 1e-12.
            compiled: True: machine code, made by the C compiler at the first call of each quantity (0.1 to 4 s) and kept in
                the user's cache folder. False: CasADi's virtual machine. "auto": an interpreter; where there is a compiler,
                machine code after a hundred single configurations, or a tenth of a second of work on many.
            measure: one of `available_measures()`, or a Measure with its options. Default: Yoshikawa's manipulability.
            threads: number of threads that share a large batch. Default: all cores this process may use.

        Raises:
            UnknownNameError: no such backend or measure; the nearest names are listed.
            CompilerError: at the first call, when compiled is True and there is no compiler or it fails.
        """
        from manipplan.kinematics.kinematics import kinematics_of

        return kinematics_of(self, task, measure, backend, compiled, threads)

    def configuration(self, argument: str, q: ArrayLike, *, tolerance: float | None = None) -> Array:
        """One configuration (n,), inside the position limits: joints outside by at most the tolerance are taken to the limit.

        Args:
            argument: what messages and the log call it.
            q: (n,) [rad or m].
            tolerance: [rad or m]; None: `limit_tolerance`.

        Raises InvalidInputError that names `argument`, the joint, its value, its limits, and by how much it misses them.
        """
        return check_configuration(self, argument, q, tolerance)

    def random_configuration(self, rng: np.random.Generator, *, size: int | None = None) -> Array:
        """Uniform configurations inside the limits, (n,) or (size, n); continuous joints in [-π, π].

        Raises InvalidInputError when `rng` is no numpy.random.Generator, or `size` no whole number.
        """
        instance("rng", rng, np.random.Generator)
        size = None if size is None else whole_number("size", size, least=0, most=MOST_AT_ONCE)
        lower = np.where(np.isfinite(self.limits.lower), self.limits.lower, -np.pi)
        upper = np.where(np.isfinite(self.limits.upper), self.limits.upper, np.pi)
        return rng.uniform(lower, upper, (self.n,) if size is None else (size, self.n))

    def with_limits(self, *, source: str = "given", limit_tolerance: float | None = None, **changes: ArrayLike) -> "Robot":
        """A copy with other limits.

        Args:
            source: where the numbers come from; `print(robot)` shows it.
            limit_tolerance: how far configurations may be given outside the position limits, up to 0.1 [rad or m]: they are
                taken to the limit. None: as before; 1e-6 for a robot that was read.
            **changes: lower, upper, velocity, acceleration, jerk, effort; one number or (n,).

        Raises InvalidInputError when a number is not usable as such a limit.
        """
        limits, tolerance = self.limits.with_changes(changes, source=source), self.limit_tolerance
        if limit_tolerance is not None:
            tolerance = number("limit_tolerance", limit_tolerance, least=0.0, most=LARGEST_TOLERANCE)
        neutral = np.clip(self.neutral, limits.lower, limits.upper)
        return replace(self, limits=limits, limit_tolerance=tolerance, neutral=neutral)

    def with_tool(self, pose: ArrayLike | pin.SE3, *, name: str = "tcp", tool: str | None = None) -> "Robot":
        """The arm with another tool frame, at `pose`, (4, 4) or pin.SE3, in the current tool frame.

        Of several tools it replaces `tool`, by default the first.

        Raises InvalidInputError when the pose is no pose, or a frame of the robot has that name already, and UnknownNameError
        when the robot has no such tool.
        """
        pose, old = pose_matrix("pose", pose), self.tool if tool is None else known_tool(self, "tool", tool)
        attached.check_new_name(name, self.model, self.geometry, self.carried)
        model = attached.with_frame(self.model, old, pin.SE3(pose), name)
        first, *others = (name if each == old else each for each in self.tools)
        return replace(
            self,
            model=model,
            tool=first,
            other_tools=tuple(others),
            added_frames=(*self.added_frames, AddedFrame(name=name, pose=pose, frame=old)),
            carried=attached.in_new_frame(self.carried, old, pin.SE3(pose), name),
        )

    def at(self, pose: ArrayLike | pin.SE3) -> "Robot":
        """The arm with its base at `pose`, (4, 4) or pin.SE3, in the world; poses and obstacles are given in the world.

        Geoms of the world in an MJCF, such as its floor, stay where they are.

        Raises InvalidInputError when the pose is no pose, or takes a planar arm out of the x-y plane.
        """
        base = pose_matrix("pose", pose)
        if self.planar and not attached.keeps_plane(base):
            raise InvalidInputError("pose", base.tolist(), "a pose in the x-y plane, in which a planar arm moves")
        motion = pin.SE3(base) * pin.SE3(self.base).inverse()
        model, geometry = attached.move_base(self.model, self.geometry, motion)
        return replace(self, model=model, geometry=geometry, base=base)

    def with_inverse_kinematics(self, solver: PoseSolver | None, *, complete: bool = False) -> "Robot":
        """The arm with inverse kinematics of your own, instead of the library's.

        `inverse_kinematics`, pose goals, `sample_layers` and `follow` call it once for every pose, or sample of a pose that a
        task leaves partly free. Its answers are checked: configurations outside the limits are left out, others are moved onto
        the pose by Newton steps to the last digits, and each is listed at every full turn inside the limits. It stays valid
        with `at`, `with_tool`, `with_limits`, `attach` and `detach`: the pose that it gets is always that of the tool and the
        base for which it was given. The arm of some joints (`arm`) has the library's method again. So have arms with too few
        joints for a pose, where the task leaves part of it free.

        Args:
            solver: function of a pose (4, 4) of the tool in the world, which returns configurations (k, n) [rad or m] or None.
                It is called by one thread at a time. None: the library's own method again.
            complete: whether it returns every solution, up to full turns; the solutions of an arm with more joints than a pose
                needs are a continuum, of which no function returns all.

        Raises InvalidInputError when it cannot be called, or the robot has several tools. Later calls raise it where the solver
        raises an error, returns something else, or a configuration that misses the pose by more than 1e-3 m or rad.
        """
        one_tool(self, "inverse kinematics of your own")
        return replace(self, own_ik=None if solver is None else OwnInverseKinematics.of(self, solver, complete))

    def attach(self, shape: Solid, *, name: str = "", tool: str | None = None) -> "Robot":
        """The arm with a part in its hand, which is checked for collisions from now on.

        It is checked against everything but the bodies that move with the tool; what else it may touch, such as the table
        that it is lifted from, is allowed in the scene (`Scene.allow`).

        Args:
            shape: an obstacle such as Box or Mesh, posed in the tool frame. One that is posed in the world is in the tool
                frame as `shape.at(np.linalg.inv(robot.kinematics().pose(q)))`, with q the configuration of the grasp.
            name: name of the part. Default: that of the shape, or "part".
            tool: of several tools the one that carries it; default the first.

        A mesh that is not convex is checked as the meshes of links are, in place of which convex pieces stand.

        Raises InvalidInputError when `shape` is not a shape with a pose, is unbounded or a cloud of points, or the robot has a
        link, body or part of that name.
        """
        if not isinstance(shape, Solid) or isinstance(shape, type):
            raise InvalidInputError("shape", shape, "a shape with a pose, such as Box, Sphere or Mesh")
        name = text("name", name) or shape.name or "part"
        attached.check_new_name(name, self.model, self.geometry, self.carried)
        frame = self.tool if tool is None else known_tool(self, "tool", tool)
        geometry, bodies = attached.with_part(self.model, self.geometry, frame, shape, name)
        carried = {**self.carried, name: CarriedPart(solid=shape, bodies=bodies, frame=frame)}
        return share_results(replace(self, geometry=geometry, carried=carried), self)

    def detach(self, name: str = "part") -> "Robot":
        """The arm without the part of that name.

        Raises UnknownNameError when it carries no such part; the nearest names are listed.
        """
        one_of("name", name, self.carried, empty="none: the robot carries nothing")
        geometry = attached.without_bodies(self.geometry, self.carried[name].bodies)
        carried = {each: part for each, part in self.carried.items() if each != name}
        return share_results(replace(self, geometry=geometry, carried=carried), self)

    def link_of(self, body: pin.GeometryObject) -> str:
        """The name of the part or link to which a body of `geometry` belongs; a geom of the world of an MJCF is its own.

        Raises InvalidInputError when `body` is no pin.GeometryObject.
        """
        instance("body", body, pin.GeometryObject)
        part = next((name for name, part in self.carried.items() if body.name in part.bodies), None)
        if part is not None:
            return part
        return str(self.model.frames[body.parentFrame].name if body.parentFrame > 0 else body.name)

    @property
    def world_geoms(self) -> frozenset[str]:
        """Names of the bodies that an MJCF gives to the world itself, such as its floor: like obstacles, they stay put."""
        return frozenset(item.name for item in self.geometry.geometryObjects if item.parentFrame == 0)

    def to_srdf(self, file: str | Path, states: Mapping[str, ArrayLike] | None = None, *, group: str = "arm") -> None:
        """Write MoveIt's semantic description: the arm as one group, its tool, named states, pairs that need no check.

        Args:
            file: the file to write, completely or not at all.
            states: configurations (n,) [rad or m] by name; default `states`.
            group: name of the group.

        Raises InvalidInputError when a state is not a configuration, or the file cannot be written.
        """
        write_srdf(self, file, states, group=group)

    def __getstate__(self) -> dict[str, Any]:
        # Pinocchio writes mimic joints that end the process when they are read
        model, geometry, followers = subchain.uncouple(self.model, self.geometry)
        return state_without_memo(self) | {"model": model, "geometry": geometry, "followers": followers}

    def __setstate__(self, state: dict[str, Any]) -> None:
        followers = state.pop("followers")
        state["model"], state["geometry"] = subchain.coupled(state["model"], state["geometry"], followers)
        vars(self).update(state)

    def __repr__(self) -> str:
        tools = f"tool={self.tool!r}" if len(self.tools) == 1 else f"tools={self.tools}"
        return f"Robot({self.name!r}, joints={self.n}, {tools})"

    def __str__(self) -> str:
        return robot_table(self)


#: Number of locked joints, and of followers, that are named.
NAMED = 6


def robot_table(robot: "Robot") -> str:
    """The text of `str(robot)`."""
    limits = robot.limits
    head = ("joint", "type", "lower", "upper", "velocity", "acceleration", "jerk", "effort")
    rows: list[tuple[str, ...]] = [head]
    for i, (name, kind) in enumerate(zip(robot.joint_names, robot.joint_types, strict=True)):
        values = (getattr(limits, column)[i] for column in head[2:])
        rows.append((name, kind, *(f"{v:.4g}" for v in values)))
    widths = [max(len(row[k]) for row in rows) for k in range(len(head))]
    frames = f"tool frame{'s' * (len(robot.tools) > 1)} {' and '.join(robot.tools)}"
    lines = [f"{robot.name}: {robot.n} joints, {frames}   (SI units, rad)"]
    for row in rows:
        cells = [c.ljust(w) if k < 2 else c.rjust(w) for k, (c, w) in enumerate(zip(row, widths, strict=True))]
        lines.append("  ".join(cells).rstrip())
    lines += [f"{kind} limits: {source}" for kind, source in limits.sources.items()]
    lines += _first_of("followers", [f"{joint} = {mimic}" for joint, mimic in robot.followers.items()])
    lines += [f"carried: {', '.join(robot.carried)}"] if robot.carried else []
    lines += _first_of("locked", [f"{joint} = {value:g}" for joint, value in robot.locked.items()])
    return "\n".join(lines)


def _first_of(what: str, texts: list[str]) -> list[str]:
    """A line with the first of some texts and their number; none without a text."""
    more = f", ... ({len(texts)} in all)" if len(texts) > NAMED else ""
    return [f"{what}: {', '.join(texts[:NAMED])}{more}"] if texts else []
