"""NamedStates: the postures that a robot's SRDF gives names, such as "ready" and "home"."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.errors import UnknownNameError


class NamedStates(dict[str, Array]):
    """Configurations (n,) [rad or m] by name; a name that is not there raises UnknownNameError with the nearest."""

    @classmethod
    def of(cls, states: Iterable[tuple[str, Mapping[str, float]]], joints: Sequence[str]) -> "NamedStates":
        """Those of an SRDF's states that give each of `joints` a value; of several with one name the first."""
        found = cls()
        for name, values in states:
            if name not in found and all(joint in values for joint in joints):
                q = np.array([values[joint] for joint in joints])
                q.flags.writeable = False
                found[name] = q
        return found

    def __missing__(self, name: str) -> Array:
        raise UnknownNameError("named state", str(name), self or ["none: the robot was read without an SRDF that names any"])
