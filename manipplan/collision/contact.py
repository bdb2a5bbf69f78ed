"""Nearest points of a pair of bodies, and the plane between them."""

from dataclasses import dataclass

from manipplan.support.checks import Array


@dataclass(frozen=True, kw_only=True)
class Contact:
    """The nearest points of one pair at one configuration, and the plane between the two bodies.

    Attributes:
        distance: [m], negative where the two overlap.
        first, second: indices of the joints that carry the bodies (0: the world).
        normal: (3,) unit vector from the second body to the first, in the frame of joint `second`.
        offset: normal · p [m] in that frame, where p is the point of the second body nearest to the first: the second body
            lies below this plane.
        points: (k, 3) core points of the first body in the frame of joint `first` [m].
        radius: radius of the first body around its core points [m].
    """

    distance: float
    first: int
    second: int
    normal: Array
    offset: float
    points: Array
    radius: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Witness:
    """Two points fixed to the bodies of a pair: the distance of the pair is at most that of the points minus `radius`.

    The point of a sphere or capsule lies on its centre or axis, that of any other body on its surface.

    Attributes:
        first, second: indices of the joints that carry the two bodies (0: the world).
        point, other: (3,) the points of the first and the second body, in the frames of these joints [m].
        radius: sum of the radii of the two bodies around their points [m]; 0 for points on the surface.
    """

    first: int
    second: int
    point: Array
    other: Array
    radius: float
