"""SelfCollisions: which pairs of a robot's links are checked for contact, why the others are not, and an SRDF that says so."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

import numpy as np

from manipplan.collision.build import SAMPLES, self_model
from manipplan.robots.robot import Robot
from manipplan.robots.srdf import write_srdf
from manipplan.support.checks import number

#: Largest number of touching pairs that are printed.
PRINTED = 30
#: Reasons of an SRDF, as MoveIt's assistant writes them, by the beginnings of ours.
_REASONS = {"parent": "Adjacent", "touching": "Always", "no joint": "Fixed"}


@dataclass(frozen=True, kw_only=True)
class LinkPair:
    """Two links with collision bodies.

    Attributes:
        first, second: their names; a carried part has its own.
        reason: why the pair is not checked; "" if all its bodies are checked.
        checked: whether any two bodies of the pair are checked.
        contact: share of random configurations at which the two touch, if they are checked; otherwise nan.
    """

    first: str
    second: str
    reason: str
    checked: bool
    contact: float

    def __str__(self) -> str:
        state = "checked" if self.checked else self.reason
        if self.contact > 0:
            state = f"touching at {round(self.contact * (SAMPLES + 1))} of {SAMPLES + 1} configurations"
        return f"{self.first} - {self.second}: {state}"


@dataclass(frozen=True, kw_only=True, eq=False)
class SelfCollisions:
    """The pairs of a robot's links, those that touch most often first.

    Printed: the `PRINTED` pairs that touch most often, and how many others there are.
    """

    robot: Robot
    pairs: tuple[LinkPair, ...]

    @classmethod
    def of(cls, robot: Robot) -> "SelfCollisions":
        """The pairs of all links and carried parts that have collision bodies."""
        model = self_model(robot)
        carrier = {link: item.parentJoint for item, link in zip(model.objects, model.links, strict=True)}
        checked = {frozenset((model.links[i], model.links[j])) for i, j in model.pairs.tolist()}
        reasons: dict[frozenset[str], str] = {}
        link = {item.name: name for item, name in zip(model.objects, model.links, strict=True)}
        for (first, second), reason in model.dropped.items():
            reasons.setdefault(frozenset((link.get(first, first), link.get(second, second))), reason)
        pairs = []
        for first, second in combinations(carrier, 2):
            names = frozenset((first, second))
            fixed = "no joint between them moves" if carrier[first] == carrier[second] else ""
            pairs.append(
                LinkPair(
                    first=first,
                    second=second,
                    reason=reasons.get(names, fixed),
                    checked=names in checked,
                    contact=model.contacts.get(names, 0.0) if names in checked else np.nan,
                )
            )
        return cls(robot=robot, pairs=tuple(sorted(pairs, key=lambda each: -np.nan_to_num(each.contact, nan=-1.0))))

    @property
    def checked(self) -> tuple[LinkPair, ...]:
        """The pairs that are checked."""
        return tuple(pair for pair in self.pairs if pair.checked)

    @property
    def left_out(self) -> tuple[LinkPair, ...]:
        """The pairs that are not checked, each with its reason."""
        return tuple(pair for pair in self.pairs if not pair.checked)

    def to_srdf(self, file: str | Path, *, touching: float = 1.0) -> None:
        """Write MoveIt's semantic description, as `Robot.to_srdf`, that disables all pairs that are not checked.

        Args:
            file: the file to write, completely or not at all. `srdf=` of `load_robot` reads it.
            touching: links that touch in at least this share of random configurations are disabled as well. Look at them first:
                `print(robot.self_collisions)` lists them at the top.

        Raises InvalidInputError when the file cannot be written, or `touching` is not in (0, 1].
        """
        number("touching", touching, above=0.0, most=1.0)
        not_links = self.robot.carried.keys() | self.robot.world_geoms
        disabled = {
            frozenset((pair.first, pair.second)): next((v for k, v in _REASONS.items() if pair.reason.startswith(k)), "User")
            for pair in self.pairs
            if (not pair.checked or pair.contact >= touching) and not {pair.first, pair.second} & not_links
        }
        write_srdf(self.robot, file, disabled=disabled)

    def __iter__(self) -> Iterator[LinkPair]:
        return iter(self.pairs)

    def __len__(self) -> int:
        return len(self.pairs)

    def __repr__(self) -> str:
        return f"SelfCollisions({self.robot.name!r}, {len(self.checked)} checked, {len(self.left_out)} left out)"

    def __str__(self) -> str:
        touching = [f"  {pair}" for pair in self.checked if pair.contact > 0]
        shown = touching[:PRINTED]
        if len(touching) > PRINTED:
            shown.append(f"  ... and {len(touching) - PRINTED} more that touch less often; .checked has all")
        reasons = Counter(pair.reason for pair in self.left_out)
        left_out = [f"  left out, {reason}: {count}" for reason, count in reasons.most_common()]
        return "\n".join([repr(self), *shown, f"  checked, never touching: {len(self.checked) - len(touching)}", *left_out])
