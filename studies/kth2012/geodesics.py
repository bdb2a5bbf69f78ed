"""The best of all curves instead of polynomials: geodesics of the metric μ^(-2p) Σ dθ_i², by an independent method.

g = ∫ ‖θ'‖/μ^p ds is the length of a curve in the metric λ I with λ = μ^(-2p). Its geodesics, in a parameter along which g
grows evenly, satisfy

    θ'' = ½ ‖θ'‖² ∇φ - (∇φ · θ') θ',    φ = ln λ = -p ln μ².

First a sine series is fitted to a first path and its energy ∫ λ ‖θ'‖² ds is reduced; then SciPy solves the boundary value
problem. The path optimiser is not used: manipulability and gradient are the closed forms of `manipplan.planar`.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_bvp
from scipy.optimize import minimize

import manipplan as mp
from manipplan.planar import PlanarArm, manipulability, squared_manipulability, squared_manipulability_gradient

Array = NDArray[np.float64]
MODES, PANELS, NODES = 30, 24, 201
TOLERANCE = 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class Geodesic:
    """A geodesic: q (m, n) [rad] at even steps of g, its g, and the relative variation of the speed of g along it."""

    arm: PlanarArm
    q: Array
    g: float
    unevenness: float

    @property
    def length(self) -> float:
        """Length in joint space [rad]."""
        return float(np.linalg.norm(np.diff(self.q, axis=0), axis=1).sum())

    @property
    def least(self) -> float:
        """Minimum μ [m²]."""
        return float(manipulability(self.arm, self.q).min())


def geodesic(arm: PlanarArm, first: mp.JointPath, power: float) -> Geodesic:
    """The geodesic near a first path. Raises RuntimeError if the boundary value problem is not solved."""
    start, goal, n = first.start, first.goal, arm.n
    s, q, v = _smoothed(arm, first, power)

    def equation(_s: Array, y: Array) -> Array:
        q, v = y[:n].T, y[n:].T
        slope = _conformal(arm, q, power)[1]
        along = np.sum(slope * v, axis=1, keepdims=True)
        return np.vstack([v.T, (0.5 * slope * np.sum(v * v, axis=1, keepdims=True) - along * v).T])

    def ends(first: Array, last: Array) -> Array:
        return np.concatenate([first[:n] - start, last[:n] - goal])

    found = solve_bvp(equation, ends, s, np.vstack([q.T, v.T]), tol=TOLERANCE, max_nodes=20_000)
    if not found.success:
        raise RuntimeError(f"geodesic from {start} to {goal}: {found.message}")
    y = found.sol(np.linspace(0.0, 1.0, 4001))
    speed = np.sqrt(_conformal(arm, y[:n].T, power)[0]) * np.linalg.norm(y[n:], axis=0)
    g = float(np.mean(speed))
    return Geodesic(arm=arm, q=y[:n].T.copy(), g=g, unevenness=float(np.ptp(speed)) / g)


def _conformal(arm: PlanarArm, q: Array, power: float) -> tuple[Array, Array]:
    """λ (m,) and ∇φ (m, n)."""
    square = squared_manipulability(arm, q)
    return square**-power, -power * squared_manipulability_gradient(arm, q) / square[:, None]


def _smoothed(arm: PlanarArm, first: mp.JointPath, power: float) -> tuple[Array, Array, Array]:
    """s, q and q' of a sine series of low energy near a first path."""
    start, step = first.start, first.goal - first.start
    k = np.arange(1, MODES + 1)

    def series(s: Array) -> tuple[Array, Array]:
        return np.sin(np.pi * np.outer(s, k)) / k, np.pi * np.cos(np.pi * np.outer(s, k))

    fine = np.linspace(0.0, 1.0, 2001)
    bulge = first(fine) - start - fine[:, None] * step
    guess = 2 * k[:, None] * (np.sin(np.pi * np.outer(k, fine)) @ bulge) / (len(fine) - 1)
    s, weights = mp.JointPath.line(first.start, first.goal).quadrature(panels=PANELS)
    values, slopes = series(s)

    def energy(flat: Array) -> tuple[float, Array]:
        c = flat.reshape(guess.shape)
        q, v = start + s[:, None] * step + values @ c, step + slopes @ c
        density, slope = _conformal(arm, q, power)
        part = weights * density * np.sum(v * v, axis=1)
        return float(part.sum()), (
            values.T @ (part[:, None] * slope) + 2 * slopes.T @ ((weights * density)[:, None] * v)
        ).ravel()

    # not L-BFGS-B: on a busy machine its threads wait for each other and it takes ten times as long
    lowered = minimize(energy, guess.ravel(), jac=True, method="CG", options={"maxiter": 300, "gtol": 1e-3})
    c = lowered.x.reshape(guess.shape)
    nodes = np.linspace(0.0, 1.0, NODES)
    values, slopes = series(nodes)
    return nodes, start + nodes[:, None] * step + values @ c, step + slopes @ c
