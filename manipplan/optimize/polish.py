"""The polish: after the energy optimum, g itself is minimised in the same basis, and only kept where it can be believed."""

from manipplan.optimize import clearance as near
from manipplan.optimize.local import Candidate, LocalSearch
from manipplan.optimize.problem import AGREEMENT, POLISH_PANELS

#: Solves at most on each rule; each after the first has rows where the one before came too near to something.
ROUNDS = 3
#: They end when one that is not free, which bounds what the next can reach, lowers g by less than this share.
SMALL_GAIN = 1e-3


def polished(search: LocalSearch, best: Candidate) -> Candidate:
    """The candidate of least g near `best`, by Newton steps on g [(6.6) in kth2012]; `best` itself when none is better.

    One that is not free, leaves the limits, or whose g is not lower when it is measured to ten digits is rejected. Where the
    rule it was solved on passes by a dip of the index, a finer one is taken.
    """
    for panels in POLISH_PANELS:
        candidate, done = _on_panels(search, best, panels)
        if candidate is not None and candidate.cost.g < best.cost.g:
            best = candidate
        if done:
            break
    return best


def _on_panels(search: LocalSearch, best: Candidate, panels: int) -> tuple[Candidate | None, bool]:
    """What comes of polishing on one rule, and whether a finer one would find the same."""
    program = search.program
    places = best.places
    if search.model is not None:
        places = near.nearest(search.model, best.path, places)
    for _ in range(ROUNDS):
        rows = search.rows(best.path, best.path, places)
        solution = program.polish(search.start, search.goal, best.coefficients, rows, panels=panels)
        candidate, distances, touched = search.judged("polish", solution, places)
        if candidate is not None:
            return candidate, program.objective.agree(candidate.path, candidate.cost.g, panels, AGREEMENT)
        if best.cost.g - search.history[-1].g < SMALL_GAIN * best.cost.g:
            break
        more = search.more_places(places, distances, touched, touching=True)
        if len(more) == len(places):
            break
        places = more
    return None, True
