"""Setup: what the candidates of layers are sampled of."""

from collections.abc import Sequence
from dataclasses import dataclass

from manipplan.measures.measure import Measure
from manipplan.measures.task import Task
from manipplan.robots.collision import CollisionModel
from manipplan.robots.robot import Robot
from manipplan.robots.scene import Scene


@dataclass(frozen=True, kw_only=True, eq=False)
class Setup:
    """The arguments of `sample_layers` that say what a candidate is."""

    robot: Robot
    task: Task | None
    measure: Measure | str | None
    held: Sequence[str] | None
    method: str
    scene: Scene
    collisions: bool
    clearance: float
    seed: int

    def collision_model(self) -> CollisionModel | None:
        """What candidates are checked with; None where they are not."""
        return self.scene.collision_model(self.robot) if self.collisions else None
