"""The planar examples of kth2012, degrees 1 to 8: the thesis, the energy optimum, the optimised g, and 60 random starts.

Writes docs/benchmarks/planar_suite.md. The random starts are a reference of their own: another formulation of g, its
gradient by NumPy, minimised by SciPy's BFGS from random polynomials.
"""

from pathlib import Path

import numpy as np
from numpy.polynomial import legendre
from rich.progress import track
from scipy.optimize import minimize

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "planar_suite.md"
STARTS = 60
DEGREES = range(1, 9)
PROBLEMS = {
    "(6.10)": ((0.0, -3.0, -2.0), (np.pi, 0.1, 1.4)),
    "(6.12)": ((0.0, -1.1, -1.6), (np.pi / 2, 0.5, 1.5)),
}
#: Tables 6.1 and 6.2, whose exponent is 2 (ERRATA), by degree from 1.
THESIS = {
    "(6.10)": (2.7218, 2.4600, 2.3168, 2.2542, 2.2376, 2.2361),
    "(6.12)": (3.9420, 1.1371, 1.1185, 1.1143, 1.1114, 1.1114),
}


class PlainCost:
    """g of start + s (goal - start) + Σ_j c_j ∫P_j, and its gradient in c, on 400 Gauss points."""

    def __init__(self, kinematics, start, goal, degree, power):
        s, self.weights = mp.JointPath.line(start, goal).quadrature()
        self.kinematics, self.power, self.start, self.goal = kinematics, power, np.array(start), np.array(goal)
        integrals = [legendre.legint(np.eye(degree)[j], lbnd=-1) / 2 for j in range(1, degree)]
        self.values = np.column_stack([legendre.legval(2 * s - 1, each) for each in integrals])
        self.slopes = legendre.legvander(2 * s - 1, degree - 1)[:, 1:]
        self.line = self.start + s[:, None] * (self.goal - self.start)
        self.integrals = integrals

    def __call__(self, flat):
        c = flat.reshape(self.values.shape[1], -1)
        q, v = self.line + self.values @ c, self.goal - self.start + self.slopes @ c
        index, slope = self.kinematics.manipulability(q), self.kinematics.gradient(q)
        speed = np.linalg.norm(v, axis=1) + 1e-30
        h = self.weights * speed / index**self.power
        by_q = -(self.power * h / index)[:, None] * slope
        by_v = (h / speed**2)[:, None] * v
        return h.sum(), (self.values.T @ by_q + self.slopes.T @ by_v).ravel()

    def fine(self, flat):
        """g of the same on 4,000 points."""
        c = flat.reshape(self.values.shape[1], -1)
        s, weights = mp.JointPath.line(self.start, self.goal).quadrature(panels=400)
        values = np.column_stack([legendre.legval(2 * s - 1, each) for each in self.integrals])
        q = self.start + s[:, None] * (self.goal - self.start) + values @ c
        v = self.goal - self.start + legendre.legvander(2 * s - 1, len(c))[:, 1:] @ c
        return weights @ (np.linalg.norm(v, axis=1) / self.kinematics.manipulability(q) ** self.power)


def best_of_random_starts(kinematics, start, goal, degree, power):
    """The least g, and how many starts came within 1e-6 of it."""
    cost = PlainCost(kinematics, start, goal, degree, power)
    rng = np.random.default_rng(0)
    found = []
    for _ in range(STARTS):
        guess = rng.normal(size=(degree - 1) * 3) * rng.choice([0.6, 2.0, 6.0])
        result = minimize(cost, guess, jac=True, method="BFGS", options={"gtol": 1e-9, "maxiter": 500})
        fine = cost.fine(result.x)
        found.append(fine if abs(fine - result.fun) < 1e-6 * fine else np.inf)
    found = np.array(found)
    return found.min(), int((found < found.min() * (1 + 1e-6)).sum())


def main() -> None:
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    kinematics = arm.kinematics()
    lines = [
        "| path | p | degree | thesis | energy optimum | optimised g | best of 60 random starts (reached by) | difference |",
        "|---|---|---|---|---|---|---|---|",
    ]
    cases = [(name, power, degree) for name in PROBLEMS for power in (1, 2) for degree in DEGREES]
    worst = 0.0
    for name, power, degree in track(cases, description="planar suite"):
        start, goal = PROBLEMS[name]
        objective = mp.PathObjective(power=power, floor=0.0)
        result = mp.optimize_path(arm, start, goal, shape=mp.PathShape(degree=degree), objective=objective)
        printed = THESIS[name][degree - 1] if power == 2 and degree <= 6 else None
        energy = result.history[0].g if result.history else result.g
        best, reached = result.g, None
        if degree > 1:
            best, reached = best_of_random_starts(kinematics, start, goal, degree, power)
        difference = result.g / best - 1
        worst = max(worst, difference)
        thesis = "" if printed is None else f"{printed:.4f}"
        random = "" if reached is None else f"{best:.6f} ({reached})"
        beside = "" if reached is None else f"{difference:+.1e}"
        lines.append(f"| {name} | {power} | {degree} | {thesis} | {energy:.6f} | {result.g:.6f} | {random} | {beside} |")
        if printed is not None and round(result.g, 4) > printed:
            raise SystemExit(f"{name}, degree {degree}: {result.g:.6f} is above the {printed} that the thesis prints")
    lines += ["", f"Largest share by which the optimised g is above the best of the random starts: {worst:.1e}."]
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
