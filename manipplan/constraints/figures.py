"""ConstraintFigure: how a path or a motion keeps a constraint."""

from dataclasses import dataclass

from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.constraints.held import HeldJoints
from manipplan.constraints.proof import TOLERANCE, ConstraintProof
from manipplan.support.display import one_line


@one_line
@dataclass(frozen=True, kw_only=True)
class ConstraintFigure:
    """How a path or a motion keeps one constraint.

    Attributes:
        name: of the constraint.
        least, at: the smallest value of its rows that was found, at least 0 where it is kept, and the share of the path or of
            the duration at which it occurs. For held joints minus the largest change [rad or m].
        figure: the same in words.
        proven: whether it is proven on the whole path, and not only kept at samples between which no joint moves by more than
            1e-3 rad or m.
    """

    name: str
    least: float
    at: float
    figure: str
    proven: bool

    def __str__(self) -> str:
        return f"{self.name}: {self.figure}{', proven' if self.proven else ''}"


def figures(constraints: ConstraintSet, proof: ConstraintProof) -> tuple[ConstraintFigure, ...]:
    """The figures of all constraints on a path that was judged."""
    return tuple(
        ConstraintFigure(
            name=each.name,
            least=float(proof.least[k]),
            at=float(proof.least_at[k]),
            figure=each.figure(_without_noise(float(proof.least[k]), isinstance(each, HeldJoints))),
            proven=proof.proven[k],
        )
        for k, each in enumerate(constraints.constraints)
    )


def _without_noise(value: float, held: bool) -> float:
    return 0.0 if held and abs(value) <= TOLERANCE else value
