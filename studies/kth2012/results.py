"""Postures, paths and geodesics of the study; each is computed once."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeVar, cast

import numpy as np
from numpy.typing import NDArray

import manipplan as mp
from manipplan.planar import PostureSet, stationary_postures
from studies.kth2012 import classes, config, eikonal
from studies.kth2012.classes import Walk
from studies.kth2012.config import ARM, Example
from studies.kth2012.geodesics import Geodesic, geodesic
from studies.kth2012.polylines import polyline_among
from studies.kth2012.starts import best_of_random_starts

Array = NDArray[np.float64]
Kind = TypeVar("Kind")
TURN = 2 * np.pi


@dataclass(frozen=True, kw_only=True, eq=False)
class Crossing:
    """A class of paths and its geodesic; `shift` (3,) full turns are added to the example's goal."""

    example: Example
    shift: tuple[int, int, int]
    walk: Walk
    found: Geodesic

    @property
    def stayed(self) -> bool:
        """Whether the geodesic belongs to the class in which it was searched."""
        return classes.walk_of(self.found.q) == self.walk


@dataclass(frozen=True, eq=False)
class Results:
    """Cache of all results, shared by tables, figures and claims."""

    quick: bool
    kept: dict[object, object] = field(default_factory=dict)

    @cached_property
    def robot(self) -> mp.Robot:
        """The unit arm as a robot for the general algorithms."""
        return mp.planar_arm(ARM.lengths, radius=config.LINK_RADIUS)

    @cached_property
    def kinematics(self) -> mp.Kinematics:
        """Kinematics of the unit arm's position."""
        return self.robot.kinematics()

    @cached_property
    def free(self) -> PostureSet:
        """All stationary postures, (5.4)."""
        return stationary_postures(ARM)

    def at_radius(self, radius: float, *, limited: bool) -> PostureSet:
        """All stationary postures at a radius [m], (5.5), or (5.7) when `limited`."""
        limits = {"lower": -config.QUARTER, "upper": config.QUARTER} if limited else {}
        return self.once(("posture", radius, limited), lambda: stationary_postures(ARM, radius=radius, **limits))

    def path(self, example: Example, degree: int, power: float = config.TABLE_POWER) -> mp.results.PathResult:
        """The optimal path of a degree, by the general optimiser."""

        def run() -> mp.results.PathResult:
            return mp.optimize_path(
                self.robot,
                example.start,
                example.goal,
                shape=mp.PathShape(degree=degree),
                objective=mp.PathObjective(power=power, floor=0.0),
            )

        return self.once(("path", example, degree, power), run)

    def multistart(self, example: Example, degree: int) -> float:
        """The smallest g from random starts."""
        return self.once(
            ("starts", example, degree),
            lambda: best_of_random_starts(example, degree, config.TABLE_POWER, config.STARTS),
        )

    @property
    def start_degrees(self) -> tuple[int, ...]:
        """Degrees for which random starts are run."""
        return config.START_DEGREES[:1] if self.quick else config.START_DEGREES

    @property
    def classes(self) -> tuple[Crossing, ...]:
        """Classes for the unshifted goal: all within one winding, that is with at most two steps more than the minimum."""
        found = []
        for example in config.EXAMPLES:
            goal = classes.cell(example.goal)
            all_walks = [
                walk for walk in classes.walks(classes.cell(example.start), 2 if self.quick else 4) if walk[-1] == goal
            ]
            found += [self._crossing(example, walk) for walk in all_walks]
        return tuple(found)

    @property
    def torus(self) -> tuple[Crossing, ...]:
        """Classes with at most two steps, to the goal and to all goals that differ from it by full turns."""
        found = []
        for example in config.EXAMPLES:
            goal = classes.cell(example.goal)
            for walk in classes.walks(classes.cell(example.start), 2):
                if all((end - want) % 2 == 0 for end, want in zip(walk[-1], goal, strict=True)):
                    found.append(self._crossing(example, walk))
        return tuple(found)

    def best_crossing(self, example: Example, *, shifted: bool) -> Crossing:
        """The class with the smallest g, to the goal itself or, with `shifted`, to all goals."""
        rows = [each for each in (self.torus if shifted else self.classes) if each.example is example]
        return min(rows, key=lambda each: each.found.g)

    def _crossing(self, example: Example, walk: Walk) -> Crossing:
        def run() -> Crossing:
            base = classes.cell(example.goal)
            second, third = ((end - want) // 2 for end, want in zip(walk[-1], base, strict=True))
            start = np.array(example.start)
            goal = np.array(example.goal) + TURN * np.array([0, second, third])
            found = geodesic(ARM, classes.through(start, goal, walk), config.TABLE_POWER)
            return Crossing(example=example, shift=(0, second, third), walk=walk, found=found)

        return self.once(("class", example, walk), run)

    def limit(self, example: Example, power: float = config.TABLE_POWER) -> Geodesic:
        """The geodesic to which paths of increasing degree converge, found from the path of highest degree in the tables."""
        return self.once(
            ("limit", example, power), lambda: geodesic(ARM, self.path(example, config.BEST_DEGREE, power).path, power)
        )

    def two_links(self) -> tuple[float, float, float]:
        """g of two unit links with p = 1: of the geodesic, of the optimal polynomial, and in closed form.

        μ = |sin θ_2|, so the metric is (dθ_1² + dθ_2²)/sin² θ_2: the strip model of the hyperbolic plane, which
        w = exp(θ_1 + i θ_2) maps to the upper half-plane, where cosh d = 1 + |w_1 - w_2|²/(2 Im w_1 Im w_2).
        """

        def run() -> tuple[float, float, float]:
            start, goal = config.TWO_LINK_ENDS
            curve = geodesic(config.TWO_LINKS, mp.JointPath.line(start, goal), config.TEXT_POWER)
            robot = config.TWO_LINKS.robot()
            path = mp.optimize_path(
                robot,
                start,
                goal,
                shape=mp.PathShape(degree=config.MOST_DEGREE),
                objective=mp.PathObjective(power=config.TEXT_POWER, floor=0.0),
            )
            a, b = (np.exp(first + 1j * second) for first, second in config.TWO_LINK_ENDS)
            return curve.g, path.g, float(np.arccosh(1 + abs(a - b) ** 2 / (2 * a.imag * b.imag)))

        return self.once("two links", run)

    def shifted(self, example: Example) -> mp.results.PathResult:
        """The best path over goals that differ by full turns, by the general optimiser, with its rivals."""

        def run() -> mp.results.PathResult:
            return mp.optimize_path(
                self.robot,
                example.start,
                example.goal,
                shape=mp.PathShape(degree=config.BEST_DEGREE),
                objective=mp.PathObjective(power=config.TABLE_POWER, floor=0.0),
                seeding=mp.Seeding(shifts="within-limits"),
            )

        return self.once(("shifted", example), run)

    def among(
        self, example: Example, posts: tuple[tuple[float, float], ...], degree: int = config.OBSTACLE_DEGREE
    ) -> mp.results.PathResult:
        """The best path found among posts."""

        def run() -> mp.results.PathResult:
            post = [mp.Cylinder(radius=config.POST_RADIUS, length=1.0, position=(x, y, 0.0)) for x, y in posts]
            return mp.optimize_path(
                self.robot,
                example.start,
                example.goal,
                shape=mp.PathShape(degree=degree),
                objective=mp.PathObjective(power=config.TABLE_POWER, floor=0.0),
                scene=mp.Scene(post),
                clearance=config.CLEARANCE,
                seeding=mp.Seeding(count=config.FIRST_PATHS),
            )

        return self.once(("among", example, posts, degree), run)

    def shifted_goal(self, example: Example) -> Array:
        """The goal of the best path over goals that differ by full turns of θ_2 and θ_3, p = 2."""
        return np.array(example.goal) + TURN * np.array(self.best_crossing(example, shifted=True).shift)

    def global_optimum(self, example: Example, power: float, *, shifted: bool = False) -> eikonal.Global:
        """The best of all paths to the goal, or to the shifted goal, by fast marching."""
        goal = self.shifted_goal(example) if shifted else np.array(example.goal)

        def run() -> eikonal.Global:
            return eikonal.global_optimum(ARM, np.array(example.start), goal, power, config.MARCH_STEPS)

        return self.once(("global", example, power, shifted), run)

    def to_goal(self, example: Example, power: float, goal: Array) -> mp.results.PathResult:
        """The optimal path of degree 6 to another goal."""

        def run() -> mp.results.PathResult:
            objective = mp.PathObjective(power=power, floor=0.0)
            shape = mp.PathShape(degree=config.BEST_DEGREE)
            return mp.optimize_path(self.robot, example.start, goal, shape=shape, objective=objective)

        return self.once(("to goal", example, power, tuple(goal)), run)

    def turns(self, example: Example, power: float) -> dict[tuple[int, int], float]:
        """V at the goals that differ by a full turn of θ_2 and θ_3."""
        shifts = [(k, j) for k in (-1, 0, 1) for j in (-1, 0, 1)]
        goals = np.array([np.array(example.goal) + TURN * np.array([0, *each]) for each in shifts])

        def run() -> dict[tuple[int, int], float]:
            field = eikonal.solve(ARM, example.start, goals, power, config.SHIFT_STEP)
            return dict(zip(shifts, field(goals).tolist(), strict=True))

        return self.once(("turns", example, power), run)

    def among_optimum(self, example: Example, posts: tuple[tuple[float, float], ...]) -> tuple[tuple[float, ...], float]:
        """V at the goal among posts, by grid step, and g of the polyline that the way back leads to."""

        def run() -> tuple[tuple[float, ...], float]:
            goal, power = np.array(example.goal), config.TABLE_POWER
            fields = [
                eikonal.solve(ARM, example.start, [goal], power, step, posts=posts, reach=config.REACH)
                for step in config.POST_STEPS
            ]
            best = polyline_among(ARM, fields[0].back(goal), power, posts, config.REACH, config.POLYLINE_PIECES)
            return tuple(float(field(goal)[0]) for field in fields), best

        return self.once(("global among", example, posts), run)

    def pairs(self, power: float) -> Array:
        """Of random pairs V, g of the geodesic that the way back leads to, and of the optimiser's path of degree 6 (k, 4).

        The optimiser starts from the straight line, and then from PAIR_PATHS first paths.
        """

        def descend(start: Array, goal: Array) -> list[float]:
            shape, objective = mp.PathShape(degree=config.BEST_DEGREE), mp.PathObjective(power=power, floor=0.0)
            several = [mp.Seeding(count=count) for count in (1, config.PAIR_PATHS)]
            return [
                mp.optimize_path(self.robot, start, goal, shape=shape, objective=objective, seeding=each).g for each in several
            ]

        def run() -> Array:
            random = np.random.default_rng(0)
            found = []
            for _ in range(config.PAIR_STARTS):
                start = np.array([0.0, *random.uniform(-np.pi, np.pi, 2)])
                goals = random.uniform((0, -np.pi, -np.pi), np.pi, (config.PAIR_GOALS, 3))
                marched = eikonal.solve(ARM, start, goals, power, config.PAIR_STEP)
                for goal, value in zip(goals, marched(goals), strict=True):
                    found.append((value, geodesic(ARM, marched.back(goal), power).g, *descend(start, goal)))
            return np.array(found)

        return self.once(("pairs", power), run)

    def once(self, key: object, run: Callable[[], Kind]) -> Kind:
        """The result for this key; runs the function if there is none yet."""
        if key not in self.kept:
            self.kept[key] = run()
        return cast(Kind, self.kept[key])


def signed(difference: float, digits: int) -> str:
    """Text of a difference: sign and digits; no sign if it rounds to zero."""
    rounded = round(difference, digits)
    return f"{rounded:+.{digits}f}" if rounded else f"{0:.{digits}f}"
