"""The fastest speed along a piece of path when jerk is limited, too: a barrier method on a quadratic spline.

Unknown is a(l) = (dl/dt)², a quadratic spline with coefficients c; b = d²l/dt² = a'/2 is then continuous and piecewise
linear. With unit tangent t and curvature κ, acceleration t b + κ a at grid points is linear in c, and the jerk limit on
the interval from one to the next,

    |Δ(t b + κ a)| <= J h,    h = 2 Δl / (√a_k + √a_k+1),

has a right side that is convex in a: linearised it stays on the safe side, so every Newton step of the barrier method goes
from one motion within all limits to a faster one (the successive linearisation of Verscheure and of TOPP3, within one
interior-point method). At a stop a piece begins with constant jerk j, l = j t³/6, so a = 1.5 l b at the first grid point.
"""

from dataclasses import dataclass

import numpy as np

from manipplan.checks import Array
from manipplan.timing.demands import Demands

#: The motion is at most this share slower than the local optimum on its grid.
GAP = 1e-3
#: How many times heavier time counts from one round of the barrier method to the next.
HEAVIER = 8.0
#: Newton steps a round, and linear programs in search of a motion within the limits.
STEPS, SEARCHES = 40, 12
#: Stands for an infinite jerk on a part of the path, in units in which accelerations are one.
UNLIMITED = 1e12


@dataclass(frozen=True, kw_only=True, eq=False)
class SquaredSpeed:
    """a = (dl/dt)² and b = d²l/dt² at all grid points (k,), in the units of the demands; the time of each interval."""

    a: Array
    b: Array
    steps: Array


class JerkProblem:
    """The fastest a(l) on the grid of `demands` with a jerk limit for each interval, (k - 1, n) [rad/s³]."""

    def __init__(self, demands: Demands, jerk: Array, start: float, end: float) -> None:
        """`start` and `end` are a at the ends, in the units of the demands; 0: a stop."""
        self.demands = demands
        grid = demands.at
        self.fixed = (start, end)
        first, last = int(start == 0), len(grid) - int(end == 0)
        self.inner = slice(first, last)
        p = grid[self.inner]
        self.h = np.diff(p)
        # a_k = w_k c_k + (1 - w_k) c_k+1 and b_k = d_k (c_k+1 - c_k)
        before, after = np.diff(p, prepend=p[0]), np.diff(p, append=p[-1])
        self.w, self.d = after / (before + after), 1 / (before + after)
        self.first, self.last = grid[1] - grid[0], grid[-1] - grid[-2]
        # c_0 = r_0 c_1 + e_0 and likewise at the end: b = ± a / (1.5 l) at a stop
        ratio = [1.5 * self.first / self.h[0], 1.5 * self.last / self.h[-1]]
        self.tied = [0.0 if fixed else x / (1 + x) for fixed, x in zip(self.fixed, ratio, strict=True)]
        self.u, self.x, self.constant = (part[self.inner] for part in (demands.u, demands.x, demands.constant))
        self.fastest = np.minimum(demands.fastest[self.inner], 1e12).copy()
        for k, fixed in ((0, start), (-1, end)):
            if fixed:  # given, and checked before
                self.fastest[k] = np.inf
        t, kappa = demands.tangent[self.inner], demands.curvature[self.inner]
        # qdd at point k is A_k c_k + B_k c_k+1
        limited = np.isfinite(jerk).any(axis=0)
        self.A = (t * -self.d[:, None] + kappa * self.w[:, None])[:, limited]
        self.B = (t * self.d[:, None] + kappa * (1 - self.w[:, None]))[:, limited]
        self.rowA = self.u * -self.d[:, None] + self.x * self.w[:, None]
        self.rowB = self.u * self.d[:, None] + self.x * (1 - self.w[:, None])
        scaled = np.minimum(jerk * demands.time_unit**3, UNLIMITED)
        self.J = scaled[first : last - 1, limited]
        with np.errstate(divide="ignore"):
            at_start = (scaled[0] / np.abs(t[0])).min()
            at_end = (scaled[-1] / np.abs(t[-1])).min()
        # b <= (6 j² l)^(1/3) where a piece begins with constant jerk j
        self.most = [
            np.inf if start else float((6 * at_start**2 * self.first) ** (1 / 3)),
            np.inf if end else float((6 * at_end**2 * self.last) ** (1 / 3)),
        ]
        self.rows = 2 * self.u.size + 2 * self.J.size + 2 * len(p) + 3

    def coefficients(self, z: Array) -> Array:
        """All spline coefficients of the free ones."""
        return np.concatenate([[self.tied[0] * z[0] + self.fixed[0]], z, [self.tied[1] * z[-1] + self.fixed[1]]])

    def slacks(self, c: Array, loose: float = 1.0) -> tuple[Array, ...] | None:
        """What each limit, `loose` times as large, leaves; None where one is exceeded."""
        a = self.w * c[:-1] + (1 - self.w) * c[1:]
        if not (c > 0).all():  # then a > 0 everywhere, between grid points, too
            return None
        value = self.rowA * c[:-1, None] + self.rowB * c[1:, None] + self.constant
        qdd = self.A * c[:-1, None] + self.B * c[1:, None]
        root = np.sqrt(a)
        step = 2 * self.h / (root[:-1] + root[1:])
        room = self.J * step[:, None] * loose
        change = np.diff(qdd, axis=0)
        b = (self.d[0] * (c[1] - c[0]), -self.d[-1] * (c[-1] - c[-2]))
        most = np.array([m * loose - x if np.isfinite(m) else 1.0 for m, x in zip(self.most, b, strict=True)])
        found = (loose * self.fastest - a, loose - value, loose + value, room - change, room + change, most, c)
        if not all((part > 0).all() for part in found):
            return None
        return (*found, root, step)

    def time(self, root: Array, step: Array) -> float:
        """Duration in the units of the demands."""
        total = step.sum()
        total += 0.0 if self.fixed[0] else 3 * self.first / root[0]
        total += 0.0 if self.fixed[1] else 3 * self.last / root[-1]
        return float(total)

    def merit(self, z: Array, weight: float, loose: float) -> float:
        """weight · time - Σ log of slacks; inf outside the limits."""
        found = self.slacks(self.coefficients(z), loose)
        if found is None:
            return np.inf
        *slacks, root, step = found
        logs = sum(float(np.log(part[np.isfinite(part)]).sum()) for part in slacks)
        return weight * self.time(root, step) - logs

    def newton(self, z: Array, weight: float, loose: float) -> tuple[Array, float]:
        """The Newton step of the linearised barrier, and its decrement."""
        from scipy.linalg import solveh_banded

        c = self.coefficients(z)
        found = self.slacks(c, loose)
        assert found is not None
        fast, high, low, up, down, most, _, root, step = found
        count = len(c)
        g = np.zeros(count)
        H = np.zeros((3, count))  # diagonals of the symmetric matrix: H[k, i] at (i, i + k)

        g -= 1 / c
        H[0] += 1 / c**2

        # functions of a_k: weight · time, and what the jerk limits gain with it
        dstep = -step / (root[:-1] + root[1:])  # ∂h/∂√a of both ends
        da_left, da_right = dstep / (2 * root[:-1]), dstep / (2 * root[1:])
        both = root[:-1] + root[1:]
        second = 2 * step / both**2
        ll = second / (4 * root[:-1] ** 2) - dstep / (4 * root[:-1] ** 3)
        rr = second / (4 * root[1:] ** 2) - dstep / (4 * root[1:] ** 3)
        lr = second / (4 * root[:-1] * root[1:])
        ga, Ha, Hlr = np.zeros(len(root)), np.zeros(len(root)), weight * lr
        ga[:-1] += weight * da_left
        ga[1:] += weight * da_right
        Ha[:-1] += weight * ll
        Ha[1:] += weight * rr
        for k, size, fixed in ((0, self.first, self.fixed[0]), (-1, self.last, self.fixed[1])):
            if not fixed:
                ga[k] -= weight * 1.5 * size / root[k] ** 3
                Ha[k] += weight * 2.25 * size / root[k] ** 5
        inverse = np.where(np.isfinite(fast), 1 / fast, 0.0)
        ga += inverse
        Ha += inverse**2

        # rows at points, in c_k and c_k+1
        slope, bend = 1 / high - 1 / low, 1 / high**2 + 1 / low**2
        gl, gr = (slope * self.rowA).sum(axis=1), (slope * self.rowB).sum(axis=1)
        Hll = (bend * self.rowA**2).sum(axis=1)
        Hrr = (bend * self.rowB**2).sum(axis=1)
        Hcc = (bend * self.rowA * self.rowB).sum(axis=1)
        w, v = self.w, 1 - self.w
        gl, gr = gl + w * ga, gr + v * ga
        Hll, Hrr, Hcc = Hll + w**2 * Ha, Hrr + v**2 * Ha, Hcc + w * v * Ha
        g[:-1] += gl
        g[1:] += gr
        H[0, :-1] += Hll
        H[0, 1:] += Hrr
        H[1, :-1] += Hcc

        # intervals, in c_k, c_k+1 and c_k+2: time's mixed part, and jerk's slacks J h ∓ change
        wl, vl, wr, vr = w[:-1], v[:-1], w[1:], v[1:]
        H[1, :-2] += Hlr * wl * wr
        H[0, 1:-1] += 2 * Hlr * vl * wr
        H[2, :-2] += Hlr * wl * vr
        H[1, 1:-1] += Hlr * vl * vr
        gain = loose * self.J
        h0 = gain * (da_left * wl)[:, None]
        h1 = gain * (da_left * vl + da_right * wr)[:, None]
        h2 = gain * (da_right * vr)[:, None]
        d0, d1, d2 = -self.A[:-1], self.A[1:] - self.B[:-1], self.B[1:]
        for sign, slack in ((1.0, up), (-1.0, down)):
            r0, r1, r2 = ((h - sign * d) / slack for h, d in ((h0, d0), (h1, d1), (h2, d2)))
            g[:-2] -= r0.sum(axis=1)
            g[1:-1] -= r1.sum(axis=1)
            g[2:] -= r2.sum(axis=1)
            H[0, :-2] += (r0 * r0).sum(axis=1)
            H[0, 1:-1] += (r1 * r1).sum(axis=1)
            H[0, 2:] += (r2 * r2).sum(axis=1)
            H[1, :-2] += (r0 * r1).sum(axis=1)
            H[1, 1:-1] += (r1 * r2).sum(axis=1)
            H[2, :-2] += (r0 * r2).sum(axis=1)
        for k, i, sign in ((0, 0, 1.0), (1, count - 2, -1.0)):
            if np.isfinite(self.most[k]):
                slope_b = sign * self.d[0 if k == 0 else -1]
                g[i] -= slope_b / most[k]
                g[i + 1] += slope_b / most[k]
                H[0, i : i + 2] += (slope_b / most[k]) ** 2
                H[1, i] -= (slope_b / most[k]) ** 2

        # the tied ends
        r, s = self.tied
        g[1] += r * g[0]
        H[0, 1] += 2 * r * H[1, 0] + r**2 * H[0, 0]
        H[1, 1] += r * H[2, 0]
        g[-2] += s * g[-1]
        H[0, -2] += 2 * s * H[1, -2] + s**2 * H[0, -1]
        H[1, -3] += s * H[2, -3]
        gradient = g[1:-1]
        banded = H[:, 1:-1].copy()
        size = banded.shape[1]
        banded[1, size - 1 :] = 0.0
        banded[2, max(size - 2, 0) :] = 0.0
        scale = 1 / np.sqrt(banded[0])
        banded[0] = 1.0 + 1e-14
        banded[1, :-1] *= scale[:-1] * scale[1:]
        banded[2, :-2] *= scale[:-2] * scale[2:]
        direction = -scale * solveh_banded(banded[: min(3, size)], scale * gradient, lower=True, check_finite=False)
        return direction, float(-gradient @ direction)

    def centred(self, z: Array, weight: float, loose: float = 1.0, steps: int = STEPS) -> Array:
        """The least of the merit, from z inside the limits."""
        value = self.merit(z, weight, loose)
        for _ in range(steps):
            direction, decrement = self.newton(z, weight, loose)
            if not np.isfinite(decrement) or decrement < 1e-2:
                break
            size = 1.0
            while size > 1e-9:
                after = self.merit(z + size * direction, weight, loose)
                if after <= value - 1e-2 * size * decrement:
                    break
                size /= 2
            else:
                break
            z, gained, value = z + size * direction, value - after, after
            if gained < 1e-2:
                break
        return z

    def solved(self, guess: Array | None = None) -> SquaredSpeed | None:
        """The fastest motion found; None where none is within the limits. `guess`: a at the grid points."""
        z = self._inside(guess)
        if z is None:
            return None
        found = self.slacks(self.coefficients(z))
        assert found is not None
        weight = self.rows / self.time(*found[-2:]) * (10.0 if guess is not None else 1.0)
        while True:
            z = self.centred(z, weight)
            found = self.slacks(self.coefficients(z))
            assert found is not None
            if self.rows / weight < GAP * self.time(*found[-2:]):
                break
            weight *= HEAVIER
        return self._result(self.coefficients(z))

    def _inside(self, guess: Array | None) -> Array | None:
        """Free coefficients within the limits: a guess made slower; where speeds are given, a search for the centre."""
        p = self.demands.at[self.inner]
        knots = np.concatenate([[p[0]], p, [p[-1]]])
        greville = (knots[:-1] + knots[1:]) / 2
        known = (greville * (1 - greville) + 1e-12) ** (4 / 3) if guess is None else guess
        shape = known if guess is None else np.interp(greville, self.demands.at, known)
        z = np.maximum(shape[1:-1], 1e-9 * shape.max())
        if not any(self.fixed):
            for _ in range(400):
                if self.slacks(self.coefficients(z)) is not None:
                    return np.asarray(0.95 * z)
                z = 0.8 * z
            return None
        z = np.maximum(z / z.max() * max(self.fixed), np.interp(greville[1:-1], [0, 1], self.fixed) * 0.999)
        for _ in range(SEARCHES):
            if self.slacks(self.coefficients(z)) is not None:
                return np.asarray(z)
            nearer = self._nearer(z)
            if nearer is None:
                return None
            z = nearer
        return None

    def _nearer(self, z: Array) -> Array | None:
        """Coefficients that exceed limits by the least share, with jerk limits linearised at z; None where that fails."""
        from scipy.optimize import linprog
        from scipy.sparse import csr_array, diags_array, hstack, vstack

        c = self.coefficients(z)
        count = len(c)
        a = self.w * c[:-1] + (1 - self.w) * c[1:]
        root = np.sqrt(a)
        step = 2 * self.h / (root[:-1] + root[1:])
        dstep = -step / (root[:-1] + root[1:])
        points = count - 1

        def rows(left: Array, right: Array) -> csr_array:
            return csr_array(diags_array([left, right], offsets=[0, 1], shape=(points, count)))

        squared = rows(self.w, 1 - self.w)
        grows = (
            diags_array([dstep / (2 * root[:-1]), dstep / (2 * root[1:])], offsets=[0, 1], shape=(points - 1, points)) @ squared
        )
        parts: list[tuple[csr_array, Array, Array]] = []  # matrix · c <= right + share · excess
        finite = self.fastest < UNLIMITED
        parts.append((squared[finite], self.fastest[finite], self.fastest[finite]))
        for A, B, constant in zip(self.rowA.T, self.rowB.T, self.constant.T, strict=True):
            for sign in (1.0, -1.0):
                parts.append((sign * rows(A, B), 1.0 - sign * constant, np.ones(points)))
        for A, B, J in zip(self.A.T, self.B.T, self.J.T, strict=True):
            change = rows(A, B)
            change = change[1:] - change[:-1]
            for sign in (1.0, -1.0):
                matrix = sign * change - diags_array([J], offsets=[0]) @ grows
                parts.append((csr_array(matrix), J * (step - grows @ c), J * step))
        b = rows(-self.d, self.d)
        for k, most in enumerate(self.most):
            if np.isfinite(most):
                parts.append((b[:1] if k == 0 else -b[-1:], np.array([most]), np.array([most])))
        ties = [(0, 1, self.tied[0]), (count - 1, count - 2, self.tied[1])]
        equal = np.zeros((2, count + 1))
        for row, (end, beside, share) in enumerate(ties):
            equal[row, end], equal[row, beside] = 1.0, -share
        matrix = hstack(
            [vstack([part[0] for part in parts]), -csr_array(np.concatenate([part[2] for part in parts])[:, None])],
            format="csr",
        )
        scale = 1 / np.maximum(np.abs(matrix).max(axis=1).toarray().ravel(), 1e-300)
        right = np.concatenate([part[1] for part in parts])
        low = np.append(0.1 * c, -0.05)
        answer = linprog(
            np.append(np.zeros(count), 1.0),
            A_ub=csr_array(diags_array([scale], offsets=[0]) @ matrix),
            b_ub=scale * right,
            A_eq=equal,
            b_eq=np.array(self.fixed),
            bounds=np.column_stack([low, np.append(np.full(count, np.inf), np.inf)]),
            method="highs-ipm",
        )
        if answer.x is None or not np.isfinite(answer.x).all():
            return None
        return np.asarray(np.maximum(answer.x[1:-2], 1e-12 * c.max()), dtype=float)

    def _result(self, c: Array) -> SquaredSpeed:
        count = len(self.demands.at)
        a, b = np.zeros(count), np.zeros(count)
        a[self.inner] = self.w * c[:-1] + (1 - self.w) * c[1:]
        b[self.inner] = self.d * np.diff(c)
        # exact time of a quadratic a over each interval
        nodes, weights = np.polynomial.legendre.leggauss(12)
        x = (nodes + 1) / 2
        h = np.diff(self.demands.at)
        rise = np.diff(b)[:, None]
        inside = a[:-1, None] + h[:, None] * (2 * b[:-1, None] * x + rise * x**2)
        with np.errstate(divide="ignore", invalid="ignore"):
            steps = h * (weights / 2 / np.sqrt(np.maximum(inside, 1e-300))).sum(axis=1)
        if not self.fixed[0]:
            steps[0] = 3 * h[0] / np.sqrt(a[1])
        if not self.fixed[1]:
            steps[-1] = 3 * h[-1] / np.sqrt(a[-2])
        return SquaredSpeed(a=a, b=b, steps=steps)
