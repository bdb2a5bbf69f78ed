"""The polish: after the energy optimum, g itself is minimised in the same basis, and only kept where it can be believed."""

from manipplan.optimize import clearance as near
from manipplan.optimize.local import Candidate, LocalSearch

#: Solves at most; each after the first has rows where the one before came too near to something.
ROUNDS = 3
#: They end when one that is not free, which bounds what the next can reach, lowers g by less than this share.
SMALL_GAIN = 1e-3
#: A polished g is believed when a rule ten times finer than the reported one agrees to this share.
AGREEMENT = 1e-7


def polished(search: LocalSearch, best: Candidate) -> Candidate:
    """The candidate of least g near `best`, by Newton steps on g [(6.6) in kth2012]; `best` itself when none is better.

    One that is not free, leaves the limits, or whose g a rule ten times finer does not confirm is rejected.
    """
    program = search.program
    places = best.places
    if search.model is not None:
        places = near.nearest(search.model, best.path, places)
    for _ in range(ROUNDS):
        rows = search.rows(best.path, best.path, places)
        solution = program.polish(search.start, search.goal, best.coefficients, rows)
        candidate, distances, touched = search.judged("polish", solution, places)
        if candidate is not None:
            fine = program.objective.cost(candidate.path, panels=400)
            agrees = abs(fine.g - candidate.cost.g) <= AGREEMENT * fine.g
            return candidate if agrees and candidate.cost.g < best.cost.g else best
        if best.cost.g - search.history[-1].g < SMALL_GAIN * best.cost.g:
            break
        more = search.more_places(places, distances, touched, touching=True)
        if len(more) == len(places):
            break
        places = more
    return best
