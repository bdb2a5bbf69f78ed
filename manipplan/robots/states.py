"""NamedStates: the named postures of a robot's SRDF, such as "ready" and "home"."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.errors import UnknownNameError


class NamedStates(dict[str, Array]):
    """Configurations (n,) [rad or m] by name; an unknown name raises UnknownNameError with the nearest names."""

    @classmethod
    def of(cls, states: Iterable[tuple[str, Mapping[str, float]]], joints: Sequence[str]) -> "NamedStates":
        """The states of an SRDF that give each of `joints` a value; of several with the same name, the first."""
        found = cls()
        for name, values in states:
            if name not in found and all(joint in values for joint in joints):
                q = np.array([values[joint] for joint in joints])
                q.flags.writeable = False
                found[name] = q
        return found

    def __missing__(self, name: str) -> Array:
        raise UnknownNameError("named state", str(name), self or ["none: the robot was read without an SRDF that names any"])
