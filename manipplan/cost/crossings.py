"""Where a path meets singularities, of which kind, how steeply, and what that costs.

Along a path of length ℓ through a singularity at ℓ_c, m = |σ (ℓ - ℓ_c)| + O(ℓ - ℓ_c)², with the steepness σ = |d det J / dℓ|.
So g_ε = Σ_c (k_c / σ_c) ∫ (x² + ε²)^(-p/2) dx over 0 <= x <= M, plus a rest, with k_c = 2, or 1 at an end of the path. The rest
has a limit as ε falls to 0 for p < 1 + k_c. For p = 1 the integral is asinh(M / ε), which grows like log(1 / ε).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from manipplan.cost.integral import PathCost, PathIntegral, speeds
from manipplan.cost.objective import floor_of, typical_measure
from manipplan.kinematics.factors import SingularitySigns, singularity_signs
from manipplan.kinematics.kinematics import Kinematics
from manipplan.measures.manipulability import Yoshikawa
from manipplan.paths.joint import JointPath
from manipplan.support.checks import Array
from manipplan.support.display import one_line

#: Maximum joint motion between two configurations at which the sign of det J is compared [rad or m].
STEP = 5e-3
#: The same for a factor that depends on one joint.
COARSE_STEP = 0.05
#: Number of times an interval in which det J changes its sign is cut, and number of parts.
CUTS, PARTS = 10, 16
#: Powers from which on crossings have no cost, since the rest of g has no limit, by the number of sides from which the path
#: comes near the singularity: one at its ends, otherwise two.
NO_COST = {1: 2.0, 2: 3.0}
#: Half of the share of the path over which the steepness is measured.
WIDTH = 1e-6
#: J loses rank where its smallest singular value is below this share of its largest.
VANISHING = 1e-9
#: A second direction counts as lost where its singular value is below this share of the largest.
NEARLY = 1e-6
#: A path that moves no joint by more than this beside a singularity stands still, as a timed motion does at its ends
#: [rad or m].
STANDING = 1e-9
#: Distance from a crossing, in floors, up to which m must be linear, and the largest relative deviation.
NEAR, BENT = 10.0, 0.2
#: A change of sign up to which m stays below this share of its typical value from a singular end can be part of that end.
END_SHARE = 1e-2
#: The share of a singular end goes up to where m reaches this part of its typical value.
OUT = 0.1
#: A path runs along singularities where m is below the floor on more than this share of its length.
LONG = 0.1
#: Number of places of the path at which that is measured.
PATH_SAMPLES = 2000
#: Number of places on a path that are checked for whether it is singular everywhere.
ALONG = 25


@one_line
@dataclass(frozen=True, kw_only=True)
class Crossing:
    """A place where a path meets a singularity.

    Attributes:
        at: s in [0, 1]; 0 or 1 where start or goal is singular.
        kind: the factors of det J that vanish there, such as "elbow" or "elbow and wrist"; "" where they are not known.
        steepness: slope of m over the length of the path, in the metric of g, beside the place [unit of m per rad or m]; nan
            where the path stands still.
        cost: share of it in g, for m up to its typical value and linear in ℓ. nan where m is not linear there, such as where
            several factors vanish at once, and for powers from 3 on (2 at an end), whose rest has no limit.
        share: share of g, from 0 to 1, between a singular start or goal and the place where m first reaches a tenth of its
            typical value. nan for other places, and where m does not reach it.
        lost: unit vector (m,) in the rows of the task's Jacobian: the direction in which no joint velocity moves the tool.
            () where several directions are lost.
    """

    at: float
    kind: str
    steepness: float
    cost: float
    share: float = np.nan
    lost: tuple[float, ...] = ()

    @property
    def at_end(self) -> bool:
        """Whether start or goal is singular."""
        return self.at in (0.0, 1.0)

    def __str__(self) -> str:
        kind = f"{self.kind} singularity" if self.kind else "singularity"
        article = "an" if kind.startswith(("a", "e")) else "a"
        if self.at_end:
            share = "" if np.isnan(self.share) else f" ({100 * self.share:.0f} % of g)"
            return f"{'starts' if self.at == 0 else 'ends'} at {article} {kind}{share}"
        return f"crosses {article} {kind} at s = {self.at:.3f}"


def find_crossings(path: JointPath, integral: PathIntegral, cost: PathCost) -> tuple[Crossing, ...]:
    """The singularities that a path of known cost meets, in their order along the path.

    With as many joints as task rows, apart from joints that never move what counts, they are the places where a factor of
    det J, or det J itself where its factors are not known, changes its sign. With more joints it is the place of the
    minimum of m, if J loses rank there. A singular start or goal comes besides. Two factors that vanish at one place count
    as two crossings. A path that is singular everywhere crosses none.
    """
    kinematics = integral.kinematics
    ends = {s: path(np.array([s])) for s in (0.0, 1.0)}
    ends = {s: q for s, q in ends.items() if _loses_rank(kinematics, q)}
    if len(ends) == 2 and all(_loses_rank(kinematics, each[None]) for each in path(np.linspace(0.0, 1.0, ALONG))):
        return ()
    signs = singularity_signs(kinematics)
    vanishing = {s: [] if signs is None else signs.vanishing(q[0]) for s, q in ends.items()}

    def is_part_of(s: float, kind: str, end: float) -> bool:
        """Whether the same factor vanishes at a singular end, and m nearly vanishes on the way there: it is one singularity."""
        return (not kind or kind in vanishing[end]) and _is_low(path, kinematics, s, end)

    if signs is not None:
        found = _sign_changes(path, signs)
        met = [(s, kind) for s, kind in found if not any(is_part_of(s, kind, end) for end in ends)]
    else:
        inner = cost.at not in (0.0, 1.0) and _loses_rank(kinematics, path(np.array([cost.at])))
        met = [(cost.at, "")] if inner else []
    met += [(s, _list_names(names)) for s, names in vanishing.items()]
    return tuple(_crossing(path, integral, s, kind) for s, kind in sorted(met))


def with_shares(crossings: Sequence[Crossing], path: JointPath, integral: PathIntegral, cost: PathCost) -> tuple[Crossing, ...]:
    """The crossings of a path of known cost, those at its ends with their share of g."""
    return tuple(replace(each, share=_share(path, integral, cost, each.at)) if each.at_end else each for each in crossings)


def least_crossings(kinematics: Kinematics, start: Array, goal: Array) -> int | None:
    """A lower bound on the crossings of any path between two configurations (n,); None where `singularity_signs` are.

    A factor of det J that depends on one joint vanishes at least as often as on the straight way of that joint; any other one
    at least once if it has different signs at start and goal. Where the factors are not known, det J counts as the only one.
    A factor that vanishes at start or goal has no sign there, so the path may leave to either side.
    """
    return least_crossings_to(kinematics, start, goal[None])[0]


def least_crossings_to(kinematics: Kinematics, start: Array, goals: Array) -> list[int] | list[None]:
    """The same for paths from one configuration (n,) to several (k, n)."""
    signs = singularity_signs(kinematics)
    if signs is None:
        return [None] * len(goals)
    counts = np.zeros(len(goals), dtype=np.int64)
    for k, joint in enumerate(signs.joints):
        if joint is None:
            q, owners = np.vstack([np.tile(start, (len(goals), 1)), goals]), np.tile(np.arange(len(goals)), 2)
        else:
            steps = 1 + (np.abs(goals[:, joint] - start[joint]) / COARSE_STEP).astype(np.int64)
            owners = np.repeat(np.arange(len(goals)), steps + 1)
            within = np.arange(len(owners)) - np.repeat(np.cumsum(steps + 1) - (steps + 1), steps + 1)
            q = np.tile(start, (len(owners), 1))
            q[:, joint] += within / steps[owners] * (goals[owners, joint] - start[joint])
        values = signs.values(q)[:, k]
        clear = np.flatnonzero(np.abs(values) >= signs.zero[k])
        clear = clear[np.argsort(owners[clear], kind="stable")]
        changed = (owners[clear[1:]] == owners[clear[:-1]]) & ((values[clear[1:]] >= 0) != (values[clear[:-1]] >= 0))
        counts += np.bincount(owners[clear[1:]][changed], minlength=len(goals))
    return [int(each) for each in counts]


def is_beside_singular_end(path: JointPath, kinematics: Kinematics, s: float) -> bool:
    """Whether m nearly vanishes all the way between s and a singular start or goal."""
    return any(_loses_rank(kinematics, path(np.array([end]))) and _is_low(path, kinematics, s, end) for end in (0.0, 1.0))


def runs_along(path: JointPath, integral: PathIntegral, cost: PathCost) -> bool:
    """Whether m is below the floor, and below the default floor, on more than the share LONG of the length of a path."""
    floor = min(integral.floor, floor_of(integral.kinematics, None))
    if cost.min_manipulability >= floor:
        return False
    s = np.linspace(0.0, 1.0, PATH_SAMPLES + 1)
    speed = speeds(path(s, 1), integral.metric)
    low = integral.kinematics.manipulability(path(s)) < floor
    return bool((speed * low).sum() > LONG * speed.sum())


def is_singular(path: JointPath, integral: PathIntegral, cost: PathCost) -> bool:
    """Whether g of a path is infinite, or the path runs along singularities: what Status.SINGULAR says."""
    return not np.isfinite(cost.g) or runs_along(path, integral, cost)


def describe(crossings: Sequence[Crossing], least: int | None) -> str:
    """What a path does at singularities, in a sentence; "" for nothing."""
    if not crossings:
        return ""
    sentence = ", ".join(str(each) for each in crossings)
    inner = sum(not each.at_end for each in crossings)
    if inner == 0 or least is None:
        return sentence
    if inner <= least:
        one = "this" if inner == 1 else f"these {inner}"
        return f"{sentence}; {one} cannot be avoided, since start and goal lie in different aspects"
    if least == 0:
        return f"{sentence}; start and goal may lie in one aspect"
    return f"{sentence}; at least {least} cannot be avoided"


def _crossing(path: JointPath, integral: PathIntegral, s: float, kind: str) -> Crossing:
    kinematics = integral.kinematics
    found = Crossing(at=s, kind=kind, steepness=np.nan, cost=np.nan, lost=_lost(kinematics, path(np.array([s]))))
    ends = path(np.clip([s - WIDTH, s + WIDTH], 0.0, 1.0))
    moved = ends[1] - ends[0]
    if np.abs(moved).max() < STANDING:
        return found
    if kinematics.is_square and isinstance(kinematics.measure, Yoshikawa):
        change = abs(float(np.diff(np.linalg.det(kinematics.jacobian(ends)))[0]))
    else:
        change = float(kinematics.manipulability(ends).max())
    steepness = change / float(speeds(moved[None], integral.metric)[0])
    sides = 1 if s in (0.0, 1.0) else 2
    cost = np.nan
    if integral.power < NO_COST[sides] and _is_linear(path, integral, s, steepness):
        cost = sides / steepness * _linear_cost(integral, typical_measure(kinematics))
    return replace(found, steepness=steepness, cost=cost)


def _share(path: JointPath, integral: PathIntegral, cost: PathCost, end: float) -> float:
    """The part of g between an end and the place where m first reaches a tenth of its typical value."""
    s = np.abs(end - np.linspace(0.0, 1.0, PATH_SAMPLES + 1))
    high = integral.kinematics.manipulability(path(s)) >= OUT * typical_measure(integral.kinematics)
    if not high.any() or not 0 < cost.g < np.inf:
        return np.nan
    first, last = sorted((end, float(s[int(high.argmax())])))
    if first == last:  # the measure does not vanish there
        return 0.0
    edges = np.unique(np.append(integral.fine_panels(path), [first, last]))
    return float(min(integral.on_panels(path, edges[(edges >= first) & (edges <= last)]) / cost.g, 1.0))


def _lost(kinematics: Kinematics, q: Array) -> tuple[float, ...]:
    """The direction that the tool loses at a configuration (1, n), largest entry positive; () where it loses several."""
    left, values, _ = np.linalg.svd(kinematics.jacobian(q)[0])
    if len(values) > 1 and values[-2] <= NEARLY * values[0]:
        return ()
    return tuple((left[:, -1] * np.sign(left[np.abs(left[:, -1]).argmax(), -1])).tolist())


def _is_linear(path: JointPath, integral: PathIntegral, s: float, steepness: float) -> bool:
    """Whether m grows in proportion to the distance from s, where it is one and where it is NEAR times the floor."""
    if steepness == 0:
        return False
    floor = max(integral.floor, VANISHING * typical_measure(integral.kinematics))
    speed = float(speeds(path(np.array([s]), 1), integral.metric)[0])
    away = np.array([-NEAR, -1.0, 1.0, NEAR]) * floor / steepness / speed
    places = s + away[(s + away >= 0) & (s + away <= 1)]
    m = integral.kinematics.manipulability(path(places))
    return bool(len(places) > 0 and (np.abs(m / (steepness * speed * np.abs(places - s)) - 1) < BENT).all())


def _is_low(path: JointPath, kinematics: Kinematics, s: float, end: float) -> bool:
    """Whether m nearly vanishes between two places."""
    between = kinematics.manipulability(path(np.linspace(s, end, 21)))
    return bool(between.max() < END_SHARE * typical_measure(kinematics))


def _linear_cost(integral: PathIntegral, most: float) -> float:
    """∫ (x² + ε²)^(-p/2) dx over 0 <= x <= most."""
    if integral.floor == 0:
        return most ** (1 - integral.power) / (1 - integral.power) if integral.power < 1 else np.inf
    if integral.power == 1:
        return float(np.arcsinh(most / integral.floor))
    from scipy.special import hyp2f1

    ratio = -((most / integral.floor) ** 2)
    return float(most * integral.floor**-integral.power * hyp2f1(0.5, integral.power / 2, 1.5, ratio))


def _sign_changes(path: JointPath, signs: SingularitySigns) -> list[tuple[float, str]]:
    """The s where a factor of det J changes its sign, with its name; of det J itself where its factors are not known."""
    s = path.fine_samples(STEP)
    found = []
    for k, (name, values) in enumerate(zip(signs.names, signs.values(path(s)).T, strict=True)):
        changes = np.flatnonzero(np.diff(values >= 0))  # zero counts as positive

        def factor(at: Array, k: int = k) -> Array:
            return signs.values(path(at))[:, k]

        found += [(at, name) for at in _zeros(factor, s[changes], s[changes + 1])]
    return found


def _zeros(function: Callable[[Array], Array], low: Array, high: Array) -> list[float]:
    """Zeros of a function of s between places (k,) at which it has different signs."""
    if not len(low):
        return []
    positive, k = function(low) >= 0, np.arange(len(low))
    for _ in range(CUTS):
        grid = np.linspace(low, high, PARTS + 1)  # one column per interval
        inside = (function(grid[1:-1].ravel()) >= 0).reshape(PARTS - 1, -1)
        first = np.argmax(np.vstack([inside != positive, np.ones((1, len(k)), dtype=bool)]), axis=0)
        low, high = grid[first, k], grid[first + 1, k]
    return [float(each) for each in (low + high) / 2]


def _list_names(names: list[str]) -> str:
    """Names with commas and an "and"."""
    return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else "".join(names)


def _loses_rank(kinematics: Kinematics, q: Array) -> bool:
    """Whether the task's Jacobian has a row too few at a configuration (1, n); never where the measure is constant."""
    if kinematics.measure.constant:
        return False
    values = np.linalg.svd(kinematics.jacobian(q)[0], compute_uv=False)
    return bool(values[-1] <= VANISHING * values[0])
