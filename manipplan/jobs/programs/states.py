"""What a program changes: which parts the arm carries, and which obstacles are in the scene."""

from dataclasses import dataclass

import numpy as np

from manipplan.collision.near_pairs import apart_text
from manipplan.collision.scene import Scene
from manipplan.collision.shapes import Obstacle
from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong, MoveTo
from manipplan.paths.cartesian import CartesianPath
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError, UnknownNameError

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
    """

    robot: Robot
    scene: Scene
    history: tuple[object, ...] = ()

    def touching(self, q: Array, clearance: float) -> str:
        """Which bodies touch at q (n,), or are nearer than the clearance [m]; "" where none do."""
        model = self.scene.collision_model(self.robot)
        distance, _, pair = model.least_distance(q[None])
        if distance > clearance + TOUCHING:
            return ""
        first, second = model.pair_names[pair]
        return f"{first} and {second} {apart_text(distance)}; scene.allow takes out a pair such as a part and its table"

    def after(self, step: Attach | Detach, q: Array) -> "State":
        """The state after a part was taken up or put down at q (n,)."""
        tool = self.robot.kinematics().pose(q)
        robot, scene = self.robot, self.scene
        if isinstance(step, Detach):
            pose, name = tool, step.name
            solid = robot.carried[name].solid.at(tool)
            assert isinstance(solid, Obstacle)
            robot = robot.detach(name)
            scene = Scene([*scene.named, solid.called(name)], allowed=scene.allowed)
        elif isinstance(step.part, str):
            pose, name = tool, step.part
            (solid,) = (each for each in scene.named if each.name == name)
            robot = robot.attach(solid.at(np.linalg.inv(tool)), name=name)
            scene = Scene([each for each in scene.named if each.name != name], allowed=scene.allowed)
        else:
            pose, name = np.zeros((4, 4)), step.part_name  # it does not depend on where the tool is
            robot = robot.attach(step.part, name=name)
        place = tuple(np.round(pose.ravel() / SAME).astype(np.int64).tolist())
        return State(robot=robot, scene=scene, history=(*self.history, (type(step).__name__, name, place)))


def _parts(goal: object) -> list[tuple[str, str]]:
    """The parts whose poses are goals, with what messages call them: goal, or goal[k]."""
    if isinstance(goal, PoseGoal):
        return [("goal", goal.of)] if goal.of else []
    listed = goal if isinstance(goal, list | tuple) else []
    return [(f"goal[{k}]", each.of) for k, each in enumerate(listed) if isinstance(each, PoseGoal) and each.of]


def check_parts(steps: list[tuple[str, object]], robot: Robot, scene: Scene) -> None:
    """Raise an error for a part that is taken up twice, or is not there, before anything is planned.

    So does a goal of a part that the arm does not carry then, or whose pose in the hand is not known before it is planned.
    """
    carried, there = set(robot.carried), set(scene.names)
    turned: set[str] = set()  # parts taken up at the end of a path that leaves the tool's turn free
    is_turned = False
    for argument, step in steps:
        if isinstance(step, MoveTo):
            is_turned = False
            for each, of in _parts(step.goal):
                if of not in carried:
                    raise UnknownNameError(f"{argument}.{each}.of", of, carried, empty="none: the arm carries nothing then")
                if of in turned:
                    wanted = "a part that was taken up and put down after a MoveTo, or after a path with Task.pose()"
                    raise InvalidInputError(f"{argument}.{each}.of", of, wanted)
        elif isinstance(step, MoveAlong) and step.task is not None and step.task.free_axis is not None:
            is_turned = True
        elif isinstance(step, MoveAlong) and isinstance(step.path, CartesianPath):
            is_turned = False
        elif is_turned and isinstance(step, Detach):
            turned.add(step.name)
        elif is_turned and isinstance(step, Attach) and isinstance(step.part, str):
            turned.add(step.part)
        if isinstance(step, Attach) and isinstance(step.part, str):
            if step.part in carried:
                raise InvalidInputError(f"{argument}.part", step.part, "a part that the arm does not carry already")
            if step.part not in there:
                raise UnknownNameError(f"{argument}.part", step.part, there, empty="none: the scene is empty")
            there.remove(step.part)
            carried.add(step.part)
        elif isinstance(step, Attach):
            if step.part_name in carried | there:
                raise InvalidInputError(
                    f"{argument}.name", step.part_name, "the name of no obstacle and of no part that is carried"
                )
            if not isinstance(step.part, Obstacle):
                raise InvalidInputError(f"{argument}.part", step.part, "an obstacle such as a Box, so that it can be put down")
            carried.add(step.part_name)
        elif isinstance(step, Detach):
            if step.name not in carried:
                raise UnknownNameError(f"{argument}.name", step.name, carried, empty="none: the arm carries nothing then")
            carried.remove(step.name)
            there.add(step.name)
