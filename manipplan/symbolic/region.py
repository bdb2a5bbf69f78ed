"""PoseRegion: the poses about a pose that count as that pose, in a box or a cone."""

from dataclasses import dataclass

import numpy as np

from manipplan.support.checks import number, one_of
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError


@one_line
@dataclass(frozen=True, kw_only=True)
class PoseRegion:
    """A box of positions about a pose, and a box of rotation vectors or a cone about a tool axis. Made by `Task.within`.

    Attributes:
        position: half widths of the box [m], 0 for none.
        rotation: half widths of the box of rotation vectors [rad], at most π.
        cone: largest angle between the tool axis and that of the pose [rad]; None: no cone.
        axis: unit vector, the tool axis.
        spin: with a cone, largest turn about that axis [rad]; π: any.
        frame: whose axes the boxes have: those of the pose, "tool", or of the "world".
    """

    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rotation: tuple[float, float, float] = (0.0, 0.0, 0.0)
    cone: float | None = None
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    spin: float = np.pi
    frame: str = "tool"

    def __post_init__(self) -> None:
        one_of("frame", self.frame, ("tool", "world"))
        for k in range(3):
            number(f"position[{k}]", self.position[k], least=0.0)
            number(f"rotation[{k}]", self.rotation[k], least=0.0, most=np.pi)
        number("spin", self.spin, least=0.0, most=np.pi)
        if self.cone is not None:
            number("cone", self.cone, above=0.0, most=np.pi)
            if any(self.rotation):
                raise InvalidInputError("rotation", self.rotation, "0 together with a cone, which has `spin` for its axis")
        elif self.spin != np.pi:
            raise InvalidInputError("spin", self.spin, "π without a cone; rotation=(0, 0, ...) bounds a turn about one axis")
        if self.cone is None and not any(self.position) and not any(self.rotation):
            raise InvalidInputError("region", "all 0", "a position, a rotation, or a cone")
