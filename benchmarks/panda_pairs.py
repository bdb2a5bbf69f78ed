"""A thousand random pairs of the Panda without obstacles: `mp.optimize_path`, and minimising g directly.

Run with `make benchmark`. Writes docs/benchmarks/panda_pairs.md. "Directly" is g = ∫ ‖q'‖ / m^p ds on twelve panels of Gauss
points, in the same polynomials and limits, by IPOPT from the straight line, with CasADi's own derivatives in its virtual
machine. Each pair is solved by all, one after the other. Times are those of the processor, on one core; ours are of the whole
call, with two or more solves, certificate and all checks, those of the direct solves of IPOPT alone.
"""

import os
import platform
import time
from collections import Counter
from math import comb
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # before NumPy is imported

import casadi as ca
import numpy as np
from numpy.polynomial import legendre
from rich.progress import track
from scipy.optimize import nnls

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "panda_pairs.md"
PAIRS, PLAIN, DIRECT, AGAIN = {1: 1000, 2: 100}, {1: 200, 2: 50}, {1: 50, 2: 15}, 20
DEGREE = 5
PIECES = 6
#: A gradient of g below this share of g a radian, once what active limits hold is taken away, is zero.
FLAT = 1e-4


def integrals(s):
    """The integrated Legendre polynomials (m, 4) and their slopes, which vanish at neither end but as integrals do."""
    columns = [legendre.legval(2 * s - 1, legendre.legint(np.eye(DEGREE)[j], lbnd=-1) / 2) for j in range(1, DEGREE)]
    return np.column_stack(columns), legendre.legvander(2 * s - 1, DEGREE - 1)[:, 1:]


def control_rows():
    """Of the pieces' Bernstein control points: the part of the straight line (r,), and of the four integrals (r, 4)."""
    u = np.linspace(0.0, 1.0, DEGREE + 1)
    collocation = np.array([[comb(DEGREE, k) * x**k * (1 - x) ** (DEGREE - k) for k in range(DEGREE + 1)] for x in u])
    places = [(piece + u) / PIECES for piece in range(PIECES)]
    rows = np.concatenate([np.linalg.solve(collocation, integrals(s)[0]) for s in places])
    line = np.concatenate(places)
    moving = np.abs(rows).max(axis=1) > 1e-9
    return line[moving], rows[moving]


class Direct:
    """g minimised as it stands."""

    def __init__(self, robot, power, extra):
        kinematics = robot.kinematics(compiled=False)
        n, q, v = robot.n, kinematics.symbolic.chain.q, ca.SX.sym("v", robot.n)
        jacobian = kinematics.symbolic.posture.jacobian
        index = ca.trace(ca.log(ca.chol(jacobian @ jacobian.T)))
        density = ca.Function("h", [q, v], [ca.norm_2(v) / ca.exp(power * index)])
        s, weights = mp.JointPath.line([0.0], [1.0]).quadrature(panels=12)
        values, slopes = integrals(s)
        start, goal, x = ca.MX.sym("start", n), ca.MX.sym("goal", n), ca.MX.sym("x", n, DEGREE - 1)
        scale = ca.MX.sym("scale")
        places = start @ ca.DM.ones(1, len(s)) + (goal - start) @ ca.DM(s).T + x @ ca.DM(values).T
        speeds = (goal - start) @ ca.DM.ones(1, len(s)) + x @ ca.DM(slopes).T
        g = ca.dot(density.map(len(s))(places, speeds), ca.DM(weights).T)
        line, rows = control_rows()
        points = start @ ca.DM.ones(1, len(line)) + (goal - start) @ ca.DM(line).T + x @ ca.DM(rows).T
        program = {"x": ca.vec(x), "p": ca.vertcat(start, goal, scale), "f": g * scale, "g": ca.vec(points)}
        ipopt = {"print_level": 0, "sb": "yes", "max_iter": 1000, "tol": 1e-9, "bound_relax_factor": 0.0, **extra}
        options = {"print_time": False, "error_on_fail": False, "calc_lam_p": False, "no_nlp_grad": True, "ipopt": ipopt}
        self.robot, self.lines, self.solver = robot, len(line), ca.nlpsol("direct", "ipopt", program, options)

    def __call__(self, start, goal, g_line):
        limits = self.robot.limits
        result = self.solver(
            x0=0.0,
            p=np.concatenate([start, goal, [1 / g_line]]),
            lbg=np.tile(limits.lower, self.lines),
            ubg=np.tile(limits.upper, self.lines),
        )
        return self.solver.stats()["return_status"], np.array(result["x"]).reshape(self.robot.n, -1, order="F")


def path_of(start, goal, coefficients):
    u = np.linspace(0.0, 1.0, DEGREE + 1)
    collocation = np.array([[comb(DEGREE, k) * x**k * (1 - x) ** (DEGREE - k) for k in range(DEGREE + 1)] for x in u])
    control = start + u[:, None] * (goal - start) + np.linalg.solve(collocation, integrals(u)[0] @ coefficients.T)
    return mp.JointPath(breaks=np.array([0.0, 1.0]), control=control[None])


def steepness(robot, path, power):
    """Norm of g's gradient by the coefficients, as a share of g, that no active limit holds; by NumPy on 4,000 points."""
    kinematics = robot.kinematics()
    s, weights = path.quadrature(panels=400)
    values, slopes = integrals(s)
    q, v = path(s), path(s, 1)
    index, slope, speed = kinematics.manipulability(q), kinematics.gradient(q), np.linalg.norm(v, axis=1)
    h = weights * speed / index**power
    gradient = -(power * h / index)[:, None] * slope, (h / speed**2)[:, None] * v
    gradient = (values.T @ gradient[0] + slopes.T @ gradient[1]).ravel() / h.sum()
    line, rows = control_rows()
    even = np.linspace(0.0, 1.0, 101)
    fitted = np.linalg.lstsq(
        integrals(even)[0], path(even) - path.start - even[:, None] * (path.goal - path.start), rcond=None
    )[0]
    points = path.start + line[:, None] * (path.goal - path.start) + rows @ fitted
    holding = []
    for k, joint in zip(*np.nonzero(points < robot.limits.lower + 1e-6), strict=True):
        holding.append(np.outer(rows[k], np.eye(robot.n)[joint]).ravel())
    for k, joint in zip(*np.nonzero(points > robot.limits.upper - 1e-6), strict=True):
        holding.append(-np.outer(rows[k], np.eye(robot.n)[joint]).ravel())
    return nnls(np.array(holding).T, gradient)[1] if holding else np.linalg.norm(gradient)


def timed(work, *arguments, **options):
    began = time.process_time()
    result = work(*arguments, **options)
    return time.process_time() - began, result


def lower_nearby(robot, start, goal, power, result, rng):
    """The least g, over the result's, of new solves from five disturbed copies of the path."""
    found = []
    for _ in range(5):
        control = result.path.control.copy()
        control[0, 1:-1] += rng.normal(scale=0.1, size=control[0, 1:-1].shape)
        control = np.clip(control, robot.limits.lower, robot.limits.upper)
        first = mp.JointPath(breaks=result.path.breaks, control=control)
        again = mp.optimize_path(
            robot,
            start,
            goal,
            shape=mp.PathShape(degree=DEGREE),
            objective=mp.PathObjective(power=power, floor=0.0),
            seeding=mp.Seeding(initial=first),
            throw=False,
        )
        found.append(again.g / result.g - 1)
    return min(found)


def run(robot, power):
    rng = np.random.default_rng(2012)
    pairs = [robot.random_configuration(rng, size=2) for _ in range(PAIRS[power])]
    extra = {"exact Hessian": {}, "L-BFGS": {"hessian_approximation": "limited-memory"}}
    direct = {name: Direct(robot, power, options) for name, options in extra.items()}
    times = {name: [] for name in ("compiled", "VM", *direct)}
    rows, beside = [], {name: [] for name in direct}
    statuses = Counter()
    for k, (start, goal) in enumerate(track(pairs, description=f"p = {power}")):
        options = {"shape": mp.PathShape(degree=DEGREE), "objective": mp.PathObjective(power=power, floor=0.0), "throw": False}
        if k == 0:
            for compiled in ("auto", False):
                mp.optimize_path(robot, start, goal, compiled=compiled, **options)
        took, result = timed(mp.optimize_path, robot, start, goal, **options)
        times["compiled"].append(took)
        plain = None
        if k < PLAIN[power]:
            took, plain = timed(mp.optimize_path, robot, start, goal, compiled=False, **options)
            times["VM"].append(took)
        statuses[result.status.name] += 1
        ended = result.certificate.solver.startswith("no step lowers g")
        lowered = result.g < result.history[0].g
        rows.append(
            (
                result.g,
                result.seed_cost.g,
                np.nan if plain is None else plain.g,
                ended,
                lowered,
                steepness(robot, result.path, power),
            )
        )
        if k < DIRECT[power]:
            for name, solver in direct.items():
                took, (status, coefficients) = timed(solver, start, goal, result.seed_cost.g)
                times[name].append(took)
                cost = mp.path_cost(path_of(start, goal, coefficients), robot.kinematics(), power)
                beside[name].append((status == "Solve_Succeeded", cost.g / result.g))
        if k < AGAIN:
            rows[-1] += (lower_nearby(robot, start, goal, power, result, rng),)
    return statuses, {name: np.array(each) for name, each in times.items()}, rows, beside


def lines_of(power, statuses, times, rows, beside):
    count = len(rows)
    g, line, plain, ended, lowered, steep = (np.array(each) for each in zip(*(row[:6] for row in rows), strict=True))
    again = np.array([row[6] for row in rows if len(row) > 6])
    told = ", ".join(f"{number} {name}" for name, number in statuses.most_common())
    both = np.isfinite(plain)
    same = np.abs(plain[both] / g[both] - 1) < 1e-6
    finite = np.isfinite(line)
    lines = [
        f"| **p = {power}, {count} pairs** | |",
        f"| status | {told} |",
        f"| the descent ended because no step lowers g | {ended.sum()} of {count} |",
        f"| g is lower than at the energy's optimum, where the descent began | {lowered.sum()} of {count} |",
        f"| gradient of g, without what active limits hold, below {FLAT:g} g a radian | {(steep < FLAT).sum()} of {count} |",
        f"| lower g from any of five disturbed copies, by more than 1e-6; by more than 1 % | "
        f"{(again < -1e-6).sum()}, {(again < -1e-2).sum()} of {len(again)} |",
        f"| g over the straight line's: median, worst | {np.median((g / line)[finite]):.3g}, {(g / line)[finite].max():.3g} |",
        f"| machine code and virtual machine give the same g to 1e-6 | {same.sum()} of {both.sum()} |",
    ]
    for name, label in (("compiled", "ours, machine code"), ("VM", "ours, virtual machine")):
        ms = 1e3 * times[name]
        lines.append(f"| {label}: median, worst time of {len(ms)} | {np.median(ms):.0f} ms, {ms.max():.0f} ms |")
    for name, found in beside.items():
        first, ms = len(found), 1e3 * times[name]
        good, ratio = (np.array(each) for each in zip(*found, strict=True))
        ours = {each: times[each][:first] for each in ("compiled", "VM")}
        faster = {each: (np.median(times[name] / ours[each]), times[name].sum() / ours[each].sum()) for each in ours}
        lines += [
            f"| directly, {name}, first {first}: median, worst time | {np.median(ms):.0f} ms, {ms.max():.0f} ms |",
            f"| … converged | {good.sum()} of {first} |",
            f"| … its g is lower than ours by over 1 %, within 1 %, higher by over 1 % | "
            f"{(ratio < 0.99).sum()}, {(np.abs(ratio - 1) <= 0.01).sum()}, {(ratio > 1.01).sum()} |",
            f"| … its time over ours in machine code: median of pairs, total | "
            f"{faster['compiled'][0]:.1f}, {faster['compiled'][1]:.1f} |",
            f"| … its time over ours in the virtual machine: median of pairs, total | "
            f"{faster['VM'][0]:.1f}, {faster['VM'][1]:.1f} |",
        ]
    return lines


def by_default(robot, count):
    """Lines on the first `count` pairs, optimised without any option."""
    rng, statuses, times = np.random.default_rng(2012), Counter(), []
    mp.optimize_path(robot, *robot.random_configuration(np.random.default_rng(0), size=2), throw=False)
    for _ in track(range(count), description="by default"):
        took, result = timed(mp.optimize_path, robot, *robot.random_configuration(rng, size=2), throw=False)
        times.append(1e3 * took)
        statuses[result.status.name] += 1
    told = ", ".join(f"{number} {name}" for name, number in statuses.most_common())
    return [
        f"| **without options (degree 6, with a floor), {count} pairs** | |",
        f"| status | {told} |",
        f"| median, 95 %, worst time | {np.median(times):.0f} ms, {np.quantile(times, 0.95):.0f} ms, {max(times):.0f} ms |",
    ]


def main() -> None:
    robot = mp.load_robot("panda")
    lines = ["| figure | value |", "|---|---|", *by_default(robot, PAIRS[1])]
    machine = f"Python {platform.python_version()}, {platform.machine()}, two shared cores"
    for power in PAIRS:
        lines += lines_of(power, *run(robot, power))
    lines += [
        "",
        f"Processor time of one core. {machine}; command: `make benchmark`.",
    ]
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
