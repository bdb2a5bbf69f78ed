"""Points that are one but for rounding: of neighbours nearer than `SAME` a path keeps one."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array
from manipplan.support.tolerances import SAME

Distances = Callable[[NDArray[np.intp], NDArray[np.intp]], Array]


def distinct(count: int, apart: Distances, most: float = SAME) -> NDArray[np.intp]:
    """Indices of the points of a sequence that are `most` or more apart from the one kept before, with the last point.

    `apart` gives the distances of points i and j (k,). The first point and the last one are kept; [0] where all are one.
    """
    every = np.arange(count)
    if (apart(every[:-1], every[1:]) >= most).all():
        return every

    def is_far(first: int, second: int) -> bool:
        return bool(apart(np.array([first]), np.array([second]))[0] >= most)

    kept = [0]
    for k in range(1, count):
        if is_far(kept[-1], k):
            kept.append(k)
    while len(kept) > 1 and kept[-1] != count - 1 and not is_far(kept[-1], count - 1):
        kept.pop()  # the last point stands for it
    if kept[-1] != count - 1 and is_far(kept[-1], count - 1):
        kept.append(count - 1)
    return np.array(kept)
