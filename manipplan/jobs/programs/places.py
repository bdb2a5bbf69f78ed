"""PartPoses: where parts are, in the hand or in the world, as the configurations of the legs before determine it.

A part is carried as it was grasped, so each grasp has configurations of its own in which the part is at a given pose. The nodes
of a leg are found for every way in which the parts may be there, and go with those nodes before that lead to it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from manipplan.collision.scene import Scene
from manipplan.jobs.following.straight import moved_by
from manipplan.jobs.programs.legs import Leg
from manipplan.jobs.programs.steps import Attach, Detach, MoveAlong
from manipplan.paths.cartesian import CartesianPath
from manipplan.robots.model_tree import frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.tolerances import SAME


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

    @property
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
    return tuple(np.round(pose.ravel() / SAME).astype(np.int64).tolist())


def needed_by(legs: Sequence[Leg]) -> list[set[str]]:
    """For each leg, the parts on which its goals or those of later legs depend; at last none."""
    parts = [{each.pose.of for each in leg.targets if each.pose is not None and each.pose.of} for leg in legs]
    return [set().union(*parts[k:]) for k in range(len(legs) + 1)]


def different(places: Sequence[PartPoses]) -> list[PartPoses]:
    """Each once."""
    return list({each.key: each for each in places}.values())
