"""Aspects: the parts into which singularities divide the configurations of an arm with as many joints as task rows.

Within an aspect det J keeps its sign [borrel1986], so a path on which it changes crosses a singularity, where g is infinite for
powers of at least 1. The sign is a cheap necessary condition; two aspects can have the same sign.
"""

from dataclasses import dataclass

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array

#: Maximum joint motion between two checks of the sign along a path [rad or m].
STEP = 5e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class Aspect:
    """The configurations at which det J has one sign, 1 or -1."""

    kinematics: Kinematics
    sign: float

    @classmethod
    def shared(cls, kinematics: Kinematics, start: Array, goal: Array) -> "Aspect | None":
        """The aspect of start and goal; None if their signs differ or are zero, or if the Jacobian is not square."""
        if kinematics.task.rows != kinematics.robot.n:
            return None
        signs = _signs(kinematics, np.stack([start, goal]))
        return cls(kinematics=kinematics, sign=float(signs[0])) if signs[0] == signs[1] != 0 else None

    def has(self, q: Array) -> bool:
        """Whether det J has this sign at all configurations q (n,) or (k, n)."""
        return bool((_signs(self.kinematics, np.atleast_2d(q)) == self.sign).all())

    def holds(self, path: JointPath) -> bool:
        """Whether det J has this sign on a whole path, checked every `STEP`."""
        return self.has(path(path.fine_samples(STEP)))


def _signs(kinematics: Kinematics, q: Array) -> Array:
    return np.asarray(np.linalg.slogdet(kinematics.jacobian(q))[0])
