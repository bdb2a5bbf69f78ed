"""Public solvers on the same programs of the energy: time, convergence and optimum of each, beside IPOPT with our derivatives.

Run with `make benchmark`. The programs are those of energy_programs.py. IPOPT and sqpmethod evaluate the derivatives
that this package assembles; the others derive the same compiled functions by CasADi's rules. Each method works in
processes of its own, so that a crash or an endless solve counts as not converged. Building is not counted: every solver is
built once per program and called twice, and the faster call counts. Writes docs/benchmarks/energy_solvers.md.
"""

import argparse
import multiprocessing
import os
import platform
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from multiprocessing.connection import Connection
from pathlib import Path

#: One thread each; SPRAL asks for the last two.
os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMP_CANCELLATION": "TRUE", "OMP_PROC_BIND": "TRUE"}

import casadi as ca
import numpy as np
from energy_ipopt import SLACK_COST, Integral, along, capacity_for, moving_hull, solver_arguments, solver_of
from energy_programs import EnergyProgram, collected
from numpy.typing import NDArray
from rich.progress import track
from scipy.optimize import nnls

from manipplan.cost.density import energy_density, hessian_of
from manipplan.optimize import program as program_module
from manipplan.optimize.clearance import row_functions
from manipplan.optimize.program import SPACING, LimitHull, PathProgram
from manipplan.paths.rounding import on_grid
from manipplan.symbolic.machine_code import compile_together

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "energy_solvers.md"
#: Two optima are the same when their energies differ by at most this share of the first path's energy.
#: IPOPT's own tolerance leaves 4e-6 where many rows are active.
SAME = 1e-5
#: A solution that violates a constraint by more than this [rad or m] has not converged.
VIOLATION = 1e-6
#: A constraint this near to its bound [rad or m] is active, and a gradient of the energy below FLAT, as a share of the first
#: path's energy a radian, once what active constraints hold is taken away, is zero.
ACTIVE, FLAT = 1e-5, 1e-3
#: Longest processor time of one program, with building and two solves [s]: a hundred times that of IPOPT.
PATIENCE = 3
#: Spacing to which our solutions are rounded [rad or m].
EXACT_SPACING = 2.0**-40
QUIET = {"print_time": False, "error_on_fail": False, "show_eval_warnings": False}
#: For solvers that get our derivatives: no others are derived.
NO_OTHERS = {"calc_lam_p": False, "no_nlp_grad": True}
IPOPT = {
    "print_level": 0,
    "sb": "yes",
    "max_iter": 100,
    "tol": 1e-7,
    "mu_strategy": "adaptive",
    "constr_viol_tol": 1e-9,
    "bound_relax_factor": 0.0,
    "acceptable_iter": 0,
}
SQP = {"print_header": False, "print_iteration": False, "print_status": False, "max_iter": 60, "tol_pr": 1e-9, "tol_du": 1e-6}
QRQP = {"print_iter": False, "print_header": False, "print_info": False}
EXACT, REGULAR = {}, {"convexify_strategy": "regularize"}


def sqp(hessian: dict, quadratic: str, **options: object) -> dict:
    """Options of sqpmethod with a solver of quadratic programs: with the exact Hessian, or one with shifted eigenvalues."""
    return SQP | hessian | {"qpsol": quadratic, "qpsol_options": {"error_on_fail": False, **options}}


#: CasADi's plugin and its options, by title. "generated" is sqpmethod, written as C as a whole.
METHODS: dict[str, tuple[str, dict]] = {
    "IPOPT, MUMPS, with our derivatives and scaling": ("ipopt", {}),
    "our descent on DAQP, as it is used here": ("ours", {}),
    "IPOPT, MUMPS with its own scaling": ("ipopt", {"ipopt": IPOPT}),
    "IPOPT, SPRAL": ("ipopt", {"ipopt": IPOPT | {"linear_solver": "spral"}}),
    "IPOPT, MA27": ("ipopt", {"ipopt": IPOPT | {"linear_solver": "ma27"}}),
    "sqpmethod, QRQP": ("sqpmethod", sqp(EXACT, "qrqp", **QRQP)),
    "sqpmethod, QRQP, regularised": ("sqpmethod", sqp(REGULAR, "qrqp", **QRQP)),
    "sqpmethod, QRQP, all of it generated C": ("generated", sqp(EXACT, "qrqp", **QRQP)),
    "sqpmethod, DAQP": ("sqpmethod", sqp(EXACT, "daqp")),
    "sqpmethod, DAQP, regularised": ("sqpmethod", sqp(REGULAR, "daqp")),
    "sqpmethod, OSQP": ("sqpmethod", sqp(EXACT, "osqp", osqp={"verbose": False})),
    "sqpmethod, OSQP, regularised": ("sqpmethod", sqp(REGULAR, "osqp", osqp={"verbose": False})),
    "sqpmethod, qpOASES": ("sqpmethod", sqp(EXACT, "qpoases", printLevel="none")),
    "sqpmethod, qpOASES, regularised": ("sqpmethod", sqp(REGULAR, "qpoases", printLevel="none")),
    "sqpmethod, ProxQP": ("sqpmethod", sqp(EXACT, "proxqp")),
    "sqpmethod, ProxQP, regularised": ("sqpmethod", sqp(REGULAR, "proxqp")),
    "sqpmethod, PIQP": ("sqpmethod", sqp(EXACT, "piqp")),
    "sqpmethod, PIQP, regularised": ("sqpmethod", sqp(REGULAR, "piqp")),
    "sqpmethod, HiGHS, regularised": ("sqpmethod", sqp(REGULAR, "highs", highs={"output_flag": False})),
    "feasiblesqpmethod, QRQP": ("feasiblesqpmethod", {"print_header": False, "print_iteration": False, "qpsol": "qrqp"}),
    "fatrop": ("fatrop", {"structure_detection": "manual", "fatrop": {"print_level": 0, "tolerance": 1e-7}}),
    "blockSQP": ("blocksqp", {"print_header": False, "print_iteration": False, "opttol": 1e-7, "schur": False}),
    "qrsqp": (
        "qrsqp",
        {"print_header": False, "print_iteration": False, "qpsol": "qrqp", "qpsol_options": QRQP | {"error_on_fail": False}},
    ),
    "SLEQP": ("sleqp", {}),
    "Uno": ("uno", {}),
    "alpaqa": ("alpaqa", {}),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class Nlp:
    """One program as solvers take it.

    Attributes:
        oracle, arguments: objective and constraints, and a solver's arguments.
        ipopt: IPOPT with our derivatives.
        slacks: the number of unknowns that are slacks, the last ones; as many constraints, the last ones, have one each.
    """

    oracle: dict[str, ca.MX]
    ipopt: ca.Function
    arguments: dict[str, NDArray[np.float64]]
    slacks: int


@dataclass(frozen=True, kw_only=True)
class Answer:
    """What a solver makes of one program: its time [s], energy as a share of the first path's, and whether it converged."""

    seconds: float
    energy: float
    converged: bool


@cache
def symbols(program: PathProgram) -> tuple[tuple[ca.Function, ...], tuple[ca.Function, ...]]:
    """The energy's density and the functions of clearance rows, which CasADi can write as C."""
    kinematics = program.kinematics
    kinematics = kinematics.robot.kinematics(kinematics.task, measure=kinematics.measure, compiled=False)
    return energy_density(replace(program.integral, kinematics=kinematics)).functions, row_functions(kinematics).functions


@cache
def derivable(program: PathProgram) -> tuple[ca.Function, ca.Function]:
    """The same as machine code that CasADi can derive twice."""
    density, rows = symbols(program)
    energy = differentiable("energy_density", *density[:2], hessian_of(density[2]), moving=2)
    return compile_together(energy, "the energy")[0], compile_together(differentiable("row", *rows, moving=1), "rows")[0]


def nlp(each: EnergyProgram, *, generated: bool = False) -> Nlp:
    """The program of one solve; `generated`: of functions that CasADi can write as C, instead of compiled ones."""
    program, capacity = each.program, capacity_for(each.rows)
    integral, rows = Integral.of(program), row_functions(program.kinematics).functions
    if generated:
        density, rows = symbols(program)
        integral = replace(integral, density=density)
        energy = differentiable("energy_density", *density[:2], hessian_of(density[2]), moving=2)[0]
        distance = differentiable("row", *rows, moving=1)[0]
    else:
        energy, distance = derivable(program)
    ipopt = solver_of(program, capacity, integral, rows)
    arguments = solver_arguments(program, each.start, each.goal, each.guess, each.floor, each.rows)
    hull = moving_hull(program)
    oracle = derived_oracle(program, energy, distance, hull, capacity, len(arguments["p"]))
    return Nlp(oracle=oracle, ipopt=ipopt, arguments=arguments, slacks=capacity)


def derived_oracle(
    program: PathProgram, density: ca.Function, distance: ca.Function, hull: LimitHull, capacity: int, parameters: int
) -> dict[str, ca.MX]:
    """The objective and the constraints of `ipopt_solver`, in functions of `differentiable`."""
    n, basis, free, energy = program.n, program.basis, program.free, Integral.of(program)
    size, fixed = n * free.shape[1], 2 * n + 2 + n * basis.size
    z, p = ca.MX.sym("z", size + capacity), ca.MX.sym("p", parameters)
    start, goal, scale, floor = p[:n], p[n : 2 * n], p[2 * n], p[2 * n + 1]
    x = ca.reshape(p[2 * n + 2 : fixed], n, basis.size) + ca.reshape(z[:size], n, free.shape[1]) @ ca.DM(free).T

    def curve(s: ca.DM | ca.MX, values: ca.DM | ca.MX) -> ca.MX:
        return start @ ca.DM.ones(1, s.numel()) + (goal - start) @ s + x @ values

    slack, nodes = z[size:], len(energy.s)
    q = curve(ca.DM(energy.s).T, ca.DM(basis.values(energy.s)).T)
    v = (goal - start) @ ca.DM.ones(1, nodes) + x @ ca.DM(basis.values(energy.s, 1)).T
    numbers = ca.repmat(ca.vertcat(1.0, program.integral.power, floor), 1, nodes)
    values = density.map(nodes)(ca.vertcat(q, v), numbers)
    f = scale * (values @ ca.DM(energy.weights)) + SLACK_COST * ca.sum1(slack)
    g = ca.vec(curve(ca.DM(hull.line).T, ca.DM(hull.rows).T))
    if capacity:
        table = ca.reshape(p[fixed:], (parameters - fixed) // capacity, capacity)
        places = curve(table[basis.size, :], table[: basis.size, :])
        g = ca.vertcat(g, distance.map(capacity)(places, table[basis.size + 1 :, :]).T + slack)
    return {"x": z, "p": p, "f": f, "g": g}


def differentiable(
    name: str, value: ca.Function, gradient: ca.Function, hessian: ca.Function, *, moving: int
) -> list[ca.Function]:
    """A function of (w, b), its Jacobian and that one's; w: the first `moving` arguments of `value` as one column, b: the rest.

    By their names, CasADi takes the two others as derivatives of the first when all are in one library.
    """
    sizes = [value.numel_in(i) for i in range(value.n_in())]
    w, b = ca.MX.sym("w", sum(sizes[:moving])), ca.MX.sym("b", sum(sizes[moving:]))
    nw, nb = w.numel(), b.numel()
    arguments = [
        part
        for whole, some in ((w, sizes[:moving]), (b, sizes[moving:]))
        for part in ca.vertsplit(whole, np.cumsum([0, *some]).tolist())
    ]
    y, along_w, along_b = ca.MX.sym("y"), ca.MX.sym("along_w", 1, nw), ca.MX.sym("along_b", ca.Sparsity(1, nb))
    plain = ca.Function(name, [w, b], [value(*arguments)], ["w", "b"], ["y"])
    first = ca.Function(
        f"jac_{name}",
        [w, b, y],
        [gradient(*arguments).T, ca.MX(1, nb)],
        ["w", "b", "out_y"],
        ["jac_y_w", "jac_y_b"],
    )
    second = ca.Function(
        f"jac_jac_{name}",
        [w, b, y, along_w, along_b],
        [hessian(*arguments), ca.MX(nw, nb), ca.MX(nw, 1), ca.MX(nb, nw), ca.MX(nb, nb), ca.MX(nb, 1)],
        ["w", "b", "out_y", "out_jac_y_w", "out_jac_y_b"],
        [f"jac_jac_y_{a}_{c}" for a in ("w", "b") for c in ("w", "b", "out_y")],
    )
    return [plain, first, second]


def built(plugin: str, options: dict, given: Nlp) -> ca.Function:
    """The solver of a method for one program."""
    if plugin == "ipopt" and not options:
        return given.ipopt
    options, nx, ng = QUIET | options, given.arguments["x0"].size, given.arguments["lbg"].size
    f, jac_g, hessian = (given.ipopt.get_function(f"nlp_{name}") for name in ("grad_f", "jac_g", "hess_l"))
    if plugin == "ipopt":
        options |= NO_OTHERS | {"grad_f": f, "jac_g": jac_g, "hess_lag": hessian}
    if plugin in ("sqpmethod", "generated"):
        x, p = ca.MX.sym("x", nx), ca.MX.sym("p", given.arguments["p"].size)
        lam_f, lam_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", ng)
        whole = ca.Function("hess_lag", [x, p, lam_f, lam_g], [ca.triu2symm(hessian(x, p, lam_f, lam_g))])
        options |= NO_OTHERS | {"hess_lag": whole, "jac_fg": ca.Function("jac_fg", [x, p], [*f(x, p), *jac_g(x, p)])}
    if plugin == "fatrop":  # one stage, whose inputs are all unknowns
        options |= {"N": 0, "nx": [0], "nu": [nx], "ng": [ng]}
    if plugin == "generated":
        solver = ca.nlpsol("energy", "sqpmethod", given.oracle, options | {"error_on_fail": True})
        return compile_together([solver], "sqpmethod")[0]
    return ca.nlpsol("energy", plugin, given.oracle, options)


def answer(plugin: str, options: dict, each: EnergyProgram) -> Answer:
    """What a method makes of one program."""
    given = nlp(each, generated=plugin == "generated")
    solver = partial(ours, each, given) if plugin == "ours" else built(plugin, options, given)
    seconds = []
    for _ in range(2):
        began = time.process_time()
        result = solver(**given.arguments)
        seconds.append(time.process_time() - began)
    energy, converged = judged(given, np.asarray(result["x"]).ravel())
    return Answer(seconds=min(seconds), energy=energy, converged=converged)


def ours(each: EnergyProgram, given: Nlp, **_: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """The unknowns of the program's own solution, without the rounding that makes it the same on every processor.

    A slack of the size of that rounding would count a thousand times in the energy.
    """
    program, rounded = each.program, program_module.SOLVED_SPACING
    program_module.SOLVED_SPACING = EXACT_SPACING
    try:
        found = program.solve(*each.arguments).coefficients
    finally:
        program_module.SOLVED_SPACING = rounded
    kept = program._rounded(each.guess - on_grid(each.guess @ along(program), SPACING) @ program.free.T)
    z = (found - kept) @ along(program)
    return {"x": np.concatenate([z.ravel(order="F"), np.zeros(given.slacks)])}


def judged(given: Nlp, x: NDArray[np.float64]) -> tuple[float, bool]:
    """The energy at x, and whether x meets the constraints and no step along them lowers it, whatever the solver says.

    The slacks are the smallest that the path allows, so that neither a barrier nor a tolerance of the solver counts.
    """
    p, arguments = given.arguments["p"], given.arguments
    if given.slacks:
        distances = np.asarray(given.ipopt.get_function("nlp_g")(x, p)).ravel()[-given.slacks :] - x[-given.slacks :]
        x = np.concatenate([x[: -given.slacks], np.maximum(-distances, 0.0)])
    energy, gradient = (np.asarray(each).ravel() for each in given.ipopt.get_function("nlp_grad_f")(x, p))
    g, jacobian = (np.asarray(each) for each in given.ipopt.get_function("nlp_jac_g")(x, p))
    if not np.isfinite(np.concatenate([x, energy, g.ravel()])).all():
        return np.inf, False
    values, slopes = np.concatenate([x, g.ravel()]), np.concatenate([np.eye(len(x)), jacobian])
    low, high = (np.concatenate([arguments[f"{side}x"], arguments[f"{side}g"]]) for side in ("lb", "ub"))
    if max((low - values).max(), (values - high).max()) > VIOLATION:
        return float(energy[0]), False
    pushing = np.concatenate([slopes[values < low + ACTIVE], -slopes[values > high - ACTIVE]])
    left = nnls(pushing.T, gradient)[1] if len(pushing) else np.linalg.norm(gradient)
    return float(energy[0]), bool(left <= FLAT)


def work(plugin: str, options: dict, programs: Sequence[EnergyProgram], to: Connection) -> None:
    """Send the answer to each program, or the error."""
    nothing = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 1)
    os.dup2(nothing, 2)
    for each in programs:
        try:
            to.send(answer(plugin, options, each))
        except RuntimeError as error:  # CasADi's, of any failure
            to.send(str(error))


def answers(plugin: str, options: dict, programs: Sequence[EnergyProgram]) -> list[Answer | str]:
    """What a method makes of each program: an answer, or the reason why there is none."""
    found: list[Answer | str] = []
    context = multiprocessing.get_context("fork")  # programs hold CasADi functions, which cannot be sent
    while len(found) < len(programs):
        here, there = context.Pipe()
        worker = context.Process(target=work, args=(plugin, options, programs[len(found) :], there))
        worker.start()
        there.close()
        try:
            while len(found) < len(programs):
                until = used(worker) + PATIENCE
                while not here.poll(0.1) and used(worker) < until:
                    pass
                if not here.poll(0):
                    found.append(f"no answer within {PATIENCE} s")
                    break
                found.append(here.recv())
        except EOFError:
            found.append("the process died")
        worker.kill()
        worker.join()
    return found


def used(worker: multiprocessing.Process) -> float:
    """Processor time of a process so far [s], as Linux counts it; that of its compilers does not count."""
    file = Path(f"/proc/{worker.pid}/stat")
    fields = file.read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def cells(found: Sequence[Answer | str], first: Sequence[Answer | str]) -> str:
    """The cells of a method: converged; same, lower and higher optimum than the first; times of what converged."""
    done = [each for each in found if isinstance(each, Answer) and each.converged]
    pairs = [
        (each.energy, other.energy)
        for each, other in zip(found, first, strict=True)
        if isinstance(each, Answer) and isinstance(other, Answer) and each.converged and other.converged
    ]
    same, lower = (sum(pick(a, b) for a, b in pairs) for pick in (lambda a, b: abs(a - b) <= SAME, lambda a, b: a < b - SAME))
    ms = [1e3 * each.seconds for each in done]
    times = f"{np.median(ms):.1f}, {np.quantile(ms, 0.9):.1f}" if ms else ""
    return f"{len(done)} of {len(found)} | {same}, {lower}, {len(pairs) - same - lower} | {times}"


def main(arguments: Sequence[str] | None = None) -> dict[str, list[Answer | str]]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=int, default=40, help="number of programs, half of them with clearance rows")
    parser.add_argument("--methods", nargs="*", choices=tuple(METHODS), default=list(METHODS), help="which solvers")
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    programs = collected(given.programs)
    found = {name: answers(*METHODS[name], programs) for name in track(given.methods, description="solving")}
    first = next(iter(found.values()))
    has_rows = np.array([bool(each.rows) for each in programs])
    parts = [np.flatnonzero(~has_rows), np.flatnonzero(has_rows)]
    kinds = ("no rows", "with rows")
    columns = ("converged", "optimum same, lower, higher", "processor time median, 90 % [ms]")
    lines = [
        "| solver | " + " | ".join(f"{kind}: {column}" for kind in kinds for column in columns) + " |",
        "|---" * (1 + len(kinds) * len(columns)) + "|",
    ]
    for name, each in found.items():
        of_parts = (cells([each[k] for k in part], [first[k] for k in part]) for part in parts)
        lines.append(f"| {name} | " + " | ".join(of_parts) + " |")
    reasons = [f"- {name}: {why}." for name, each in found.items() for why in sorted({shown(one) for one in each} - {""})]
    rows = np.array([0 if each.rows is None else len(each.rows.s) for each in programs])[parts[1]]
    lines += [
        "",
        *(["Without an answer to some program:", "", *reasons, ""] if reasons else []),
        f"{len(parts[0])} programs without rows, {len(parts[1])} with {rows.min()} to {rows.max()} rows, from "
        f"{len({each.source for each in programs})} problems; one thread. Python {platform.python_version()}, "
        f"{platform.machine()}, CasADi {ca.__version__}; command: `.venv/bin/python benchmarks/energy_solvers.py"
        f"{'' if len(found) == len(METHODS) else ' --methods ' + ' '.join(map(repr, found))}`.",
    ]
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


def shown(found: Answer | str) -> str:
    """The last line of a reason, without files; "" for an answer."""
    if isinstance(found, Answer):
        return ""
    lines = [line.strip() for line in found.splitlines() if line.strip() and ".cpp" not in line]
    return lines[-1].removesuffix(".")[:160] if lines else "an error"


if __name__ == "__main__":
    main()
