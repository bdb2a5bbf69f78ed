"""Legs: each free motion of a program, with the steps that follow it until the next one.

What a program changes: which parts the arm carries, and which obstacles are in the scene.

PartPoses: where parts are, in the hand or in the world, as the configurations of the legs before determine it.

A part is carried as it was grasped, so each grasp has configurations of its own in which the part is at a given pose. The nodes
of a leg are found for every way in which the parts may be there, and go with those nodes before that lead to it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from manipplan.collision.model import apart_text
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.goals.goal import PoseGoal, Target, read_goals
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.tolerance import with_defaults
from manipplan.programs.steps import Attach, Detach, MoveAlong, MoveTo, ProgramStep, Wait
from manipplan.robots.arms import carriers, known_tool, one_tool
from manipplan.robots.attached import Solid, check_in_hand
from manipplan.robots.model_tree import frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array
from manipplan.support.errors import InvalidInputError, UnknownNameError
from manipplan.symbolic.free_motion import FreeMotion
from manipplan.timing.constant_speed import check_corners, check_tool_speed
from manipplan.tool_path.transit import moved_by


@dataclass(frozen=True, kw_only=True, eq=False)
class Leg:
    """A free motion, and what follows it.

    Attributes:
        number: index of its first step.
        targets: the goals of the free motion; none where it leads to the first pose of `rest`, whose first step is a path.
        approach: straight way of the tool by which the free motion ends, in the tool frame [m]; None for none.
        constraints: what the free motion keeps.
        rest: the steps that follow, with their indices.
        is_free: False for what begins at the start of the program, without a free motion.
    """

    number: int
    targets: tuple[Target, ...]
    approach: Array | None
    constraints: ConstraintSet
    rest: tuple[tuple[int, ProgramStep], ...]
    is_free: bool = True

    @property
    def along(self) -> MoveAlong | None:
        """The path to whose first pose the free motion leads; None where it has goals of its own."""
        first = self.rest[0][1] if self.rest and not self.targets else None
        return first if isinstance(first, MoveAlong) and self.is_free else None


def read_steps(
    steps: Sequence[ProgramStep],
    robot: Robot,
    start: Array,
    *,
    blend: float = 0.0,
    turns: bool = False,
    leads_in: bool = False,
) -> list[Leg]:
    """The legs of a program that begins at start (n,) and has blends of a size [m].

    With `turns`, full turns of configurations reach a goal as well. With `leads_in`, a path whose first pose the start reaches
    may begin in another configuration.

    Raises InvalidInputError, which names the step, for what is no step or does not fit the robot.
    """
    if not isinstance(steps, list | tuple) or not steps:
        raise InvalidInputError("steps", steps, "a list of at least one step, such as mp.MoveTo(goal)")
    for k, step in enumerate(steps):
        if not isinstance(step, MoveTo | MoveAlong | Attach | Detach | Wait):
            raise InvalidInputError(f"steps[{k}]", step, "a MoveTo, MoveAlong, Attach, Detach or Wait")
    kinematics = robot.kinematics()
    none = ConstraintSet.of(robot, ())
    legs = [Leg(number=0, targets=(), approach=None, constraints=none, rest=(), is_free=False)]
    at: Array | None = None if leads_in else kinematics.pose(start)  # the tool's pose where it is known
    for k, step in enumerate(steps):
        if isinstance(step, MoveTo):
            targets, at = _targets(k, step, robot, turns), None
            only = targets[0] if len(targets) == 1 else None
            if only is not None and only.q is not None:
                at = kinematics.pose(only.q)
            elif only is not None and only.pose is not None and only.pose.is_exact:
                at = only.pose.matrix
            approach = None if step.approach is None else np.array(step.approach)
            constraints = ConstraintSet.of(robot, step.constraints)
            legs.append(Leg(number=k, targets=targets, approach=approach, constraints=constraints, rest=()))
            continue
        if isinstance(step, MoveAlong):
            _check_tool(k, robot)
        if isinstance(step, MoveAlong) and isinstance(step.path, CartesianPath):
            if step.tool_speed is not None:
                before = steps[k - 1] if k else step
                radii = [each.blend for each in (before, step) if isinstance(each, MoveTo | MoveAlong)]
                _check_speed(k, step, robot, max(blend if each is None else each for each in radii))
            if at is None or max(PoseGoal(step.path(0.0)).distances(at[None])) > COINCIDENT:
                legs.append(Leg(number=k, targets=(), approach=None, constraints=none, rest=()))
            at = step.path(1.0)
        elif isinstance(step, MoveAlong) and at is not None:
            at = at @ moved_by(np.array(step.path))
        legs[-1] = replace(legs[-1], rest=(*legs[-1].rest, (k, step)))
    return legs if legs[0].rest else legs[1:]


def _check_tool(k: int, robot: Robot) -> None:
    try:
        one_tool(robot, "following a path of the tool")
    except InvalidInputError as error:
        raise InvalidInputError(f"steps[{k}].path", error.value, error.allowed) from error


def _check_speed(k: int, step: MoveAlong, robot: Robot, blend: float) -> None:
    assert step.tool_speed is not None and isinstance(step.path, CartesianPath)
    try:
        check_tool_speed(step.tool_speed, step.path)
        position = with_defaults(step.tolerance).position
        assert position is not None
        check_corners(step.tool_speed, step.path, robot, position=position, slowdown=step.slowdown, margin=blend)
    except InvalidInputError as error:
        raise InvalidInputError(f"steps[{k}].tool_speed", error.value, error.allowed) from error


def _targets(k: int, step: MoveTo, robot: Robot, turns: bool) -> tuple[Target, ...]:
    targets, _ = read_goals(f"steps[{k}].goal", step.goal, robot)
    for each in targets:
        if each.q is not None:
            robot.configuration(each.argument, each.q)
        if step.approach is not None and each.pose is None:
            given = sorted(each.tools) if each.q is None and each.tools else np.array(each.q).tolist()
            raise InvalidInputError(each.argument, given, "a pose of the tool, since there is an approach")
    return tuple(replace(each, turns=turns) for each in targets)


@dataclass(frozen=True, kw_only=True, eq=False)
class PartPoses:
    """Where the parts are on which later goals depend.

    Attributes:
        held: poses (4, 4) in the tool frame of those that the tool carries.
        placed: poses (4, 4) in the world of the others.
    """

    held: Mapping[str, Array] = field(default_factory=dict)
    placed: Mapping[str, Array] = field(default_factory=dict)

    @classmethod
    def at_first(cls, robot: Robot, scene: Scene, names: set[str]) -> "PartPoses":
        """Where these parts are at the beginning of a program."""
        held, placed = {}, {each.name: each.pose.homogeneous for each in scene.named}
        for name, part in robot.carried.items():
            pose = part.solid.pose.homogeneous
            if part.frame == robot.tool:
                held[name] = pose
            else:  # a hand that is not moved: the part is where it will be put down
                placed[name] = frame_pose(robot.model, part.frame, robot.neutral) @ pose
        return cls(held=held, placed=placed).of(names)

    @cached_property
    def key(self) -> tuple[object, ...]:
        """Equal for the same places."""
        poses = [(kind, name, pose) for kind in ("held", "placed") for name, pose in sorted(getattr(self, kind).items())]
        return tuple((kind, name, *rounded(pose)) for kind, name, pose in poses)

    def of(self, names: set[str]) -> "PartPoses":
        """Of these parts only."""
        return PartPoses(
            held={name: pose for name, pose in self.held.items() if name in names},
            placed={name: pose for name, pose in self.placed.items() if name in names},
        )

    def after(self, leg: Leg, tool: Array) -> "PartPoses":
        """Where the parts are after a leg whose goal is reached with the tool at a pose (4, 4)."""
        held, placed = dict(self.held), dict(self.placed)
        for _, step in leg.rest:
            if isinstance(step, MoveAlong):
                tool = step.path(1.0) if isinstance(step.path, CartesianPath) else tool @ moved_by(np.array(step.path))
            elif isinstance(step, Attach):
                if not isinstance(step.part, str):
                    held[step.part_name] = step.part.pose.homogeneous
                elif step.part in placed:
                    held[step.part] = np.linalg.inv(tool) @ placed.pop(step.part)
            elif isinstance(step, Detach) and step.name in held:
                placed[step.name] = tool @ held.pop(step.name)
        return PartPoses(held=held, placed=placed)


#: Without any part.
NOWHERE = PartPoses()


def rounded(pose: Array) -> tuple[int, ...]:
    """A pose (4, 4), or a configuration (n,), as a key: equal for the same ones."""
    return tuple(np.round(pose.ravel() / COINCIDENT).astype(np.int64).tolist())


def needed_by(legs: Sequence[Leg]) -> list[set[str]]:
    """For each leg, the parts on which its goals or those of later legs depend; at last none."""
    parts = [{each.pose.of for each in leg.targets if each.pose is not None and each.pose.of} for leg in legs]
    return [set().union(*parts[k:]) for k in range(len(legs) + 1)]


def different(part_poses: Sequence[PartPoses]) -> list[PartPoses]:
    """Each once."""
    return list({each.key: each for each in part_poses}.values())


#: Poses of parts that differ by less than this are the same [m, rad].
SAME_HAND = 1e-9
#: Bodies nearer than this beyond the clearance touch: rounding decides on which side of it they are [m].
TOUCHING = 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class State:
    """The arm with the parts it carries, and its scene.

    Attributes:
        robot, scene: as they are now.
        history: names and poses of the parts taken up and put down so far: equal for equal states.
        arms: the arms of the states before.
    """

    robot: Robot
    scene: Scene
    history: tuple[object, ...] = ()
    arms: tuple[Robot, ...] = ()

    def touching(self, q: Array, clearance: float) -> str:
        """Which bodies touch at q (n,), or are nearer than the clearance [m]; "" where none do."""
        model = self.scene.collision_model(self.robot)
        distance, _, pair = model.least_distance(q[None])
        if distance > clearance + TOUCHING:
            return ""
        first, second = model.pair_names[pair]
        hint = model.contact_hint(pair)
        return f"{first} and {second} {apart_text(distance)}{hint}; scene.allow takes out a pair such as a part and its table"

    def after(self, step: Attach | Detach, q: Array) -> "State":
        """The state after a part was taken up or put down at q (n,)."""
        robot, scene = self.robot, self.scene
        if isinstance(step, Detach):
            name, part = step.name, robot.carried[step.name]
            hand = frame_pose(robot.model, part.frame, q)
            solid = part.solid.at(hand)
            assert isinstance(solid, Obstacle)
            robot = self._without(name)
            scene = Scene([*scene.named, solid.called(name)], allowed=scene.allowed)
        else:
            name, tool = step.part_name, step.tool or robot.tool
            if isinstance(step.part, str):
                hand = frame_pose(robot.model, tool, q)
                (standing,) = (each for each in scene.named if each.name == name)
                held: Solid = standing.at(np.linalg.inv(hand))
                scene = Scene([each for each in scene.named if each.name != name], allowed=scene.allowed)
            else:
                held, hand = step.part, np.zeros((4, 4))  # it does not depend on where the hand is
            robot = robot.attach(held, name=name, tool=tool)
        place = tuple(np.round(hand.ravel() / SAME_HAND).astype(np.int64).tolist())
        history = (*self.history, (type(step).__name__, name, place))
        return State(robot=robot, scene=scene, history=history, arms=(*self.arms, self.robot))

    def _without(self, name: str) -> Robot:
        """The arm without a part: the same one as before it was taken up, whose kinematics and collision model are built."""
        left = {each: part for each, part in self.robot.carried.items() if each != name}

        def carries_these(arm: Robot) -> bool:
            return arm.carried.keys() == left.keys() and all(arm.carried[each] is part for each, part in left.items())

        return next((arm for arm in reversed(self.arms) if carries_these(arm)), None) or self.robot.detach(name)


def check_parts(steps: Sequence[tuple[str, object]], robot: Robot, scene: Scene) -> None:
    """Check which parts are taken up and put down before anything is planned; `steps` come with what messages call them.

    Raises InvalidInputError or UnknownNameError for a part that is taken up twice or is not there, for a hand that is not
    named or does not exist, and for a goal of a part that the tool does not carry then, or whose pose in the hand is not known
    before the program is planned.
    """
    hands = GripperState(
        robot=robot, carried={name: part.frame for name, part in robot.carried.items()}, there=set(scene.names)
    )
    for argument, step in steps:
        if isinstance(step, MoveTo):
            hands.move(argument, step)
        elif isinstance(step, MoveAlong):
            hands.follow(step)
        elif isinstance(step, Attach):
            hands.take(argument, step)
        elif isinstance(step, Detach):
            hands.put(argument, step)


@dataclass(kw_only=True, eq=False)
class GripperState:
    """What the hands hold at a step of a program.

    Attributes:
        robot: as it is at the beginning.
        carried: the tool frame that carries each part, by its name.
        there: names of the obstacles.
        turned: parts that were taken up or put down where the tool's turn was not known.
        is_turned: whether the tool's turn is not known now, since it came along a path that leaves it free.
    """

    robot: Robot
    carried: dict[str, str]
    there: set[str]
    turned: set[str] = field(default_factory=set)
    is_turned: bool = False

    def move(self, argument: str, step: MoveTo) -> None:
        """Check the goals that are poses of parts."""
        self.is_turned = False
        several = isinstance(step.goal, list | tuple)
        for k, goal in enumerate(step.goal if isinstance(step.goal, list | tuple) else [step.goal]):
            if not isinstance(goal, PoseGoal) or not goal.of:
                continue
            name = f"{argument}.goal[{k}].of" if several else f"{argument}.goal.of"
            check_in_hand(name, goal.of, self.carried, self.robot.tool)
            if goal.of in self.turned:
                wanted = "a part that was taken up and put down after a MoveTo, or after a path with Task.pose()"
                raise InvalidInputError(name, goal.of, wanted)

    def follow(self, step: MoveAlong) -> None:
        """Note whether the tool's pose is known at the end of a path."""
        if step.task is not None and FreeMotion.of(step.task, planar=self.robot.planar).names:
            self.is_turned = True
        elif isinstance(step.path, CartesianPath):
            self.is_turned = False

    def take(self, argument: str, step: Attach) -> None:
        """Check a part that is taken up, and the hand."""
        if step.tool:
            known_tool(self.robot, f"{argument}.tool", step.tool)
        elif len(self.robot.tools) > 1:
            wanted = f"the hand that takes up the part: {' or '.join(map(repr, self.robot.tools))}"
            raise InvalidInputError(f"{argument}.tool", step.tool, wanted)
        name = step.part_name
        if isinstance(step.part, str):
            if name in self.carried:
                raise InvalidInputError(f"{argument}.part", name, "a part that the arm does not carry already")
            if name not in self.there:
                raise UnknownNameError(f"{argument}.part", name, self.there, empty="none: the scene is empty")
            self.there.remove(name)
            if self.is_turned:
                self.turned.add(name)
        else:
            if name in self.carried or name in self.there:
                raise InvalidInputError(f"{argument}.name", name, "the name of no obstacle and of no part that is carried")
            if not isinstance(step.part, Obstacle):
                raise InvalidInputError(f"{argument}.part", step.part, "an obstacle such as a Box, so that it can be put down")
        self.carried[name] = step.tool or self.robot.tool

    def put(self, argument: str, step: Detach) -> None:
        """Check a part that is put down."""
        if step.name not in self.carried:
            raise UnknownNameError(f"{argument}.name", step.name, self.carried, empty="none: the arm carries nothing then")
        hand = self.carried.pop(step.name)
        self.there.add(step.name)
        if self.is_turned or (hand != self.robot.tool and carriers(self.robot.model, hand)):
            self.turned.add(step.name)
