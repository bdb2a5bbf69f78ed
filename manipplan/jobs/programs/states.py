"""What a program changes: which parts the arm carries, and which obstacles are in the scene."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from manipplan.collision.near_pairs import apart_text
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle
from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong, MoveTo
from manipplan.paths.cartesian import CartesianPath
from manipplan.robots.arms import carriers, known_tool
from manipplan.robots.attached import Solid, check_in_hand
from manipplan.robots.model_tree import frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, UnknownNameError
from manipplan.symbolic.free_motion import FreeMotion

#: Poses of parts that differ by less than this are the same [m, rad].
SAME = 1e-9
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
        place = tuple(np.round(hand.ravel() / SAME).astype(np.int64).tolist())
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
