"""One control step as one CasADi Function: kinematics, bounds, rows, the condensed QP by DAQP, and a check of its solution.

δ of (3) and ε of (14) in dufour2020 are eliminated, δ = ṙ - J q̇. The QP's variables are the n joint velocities and,
where these are used, one slack for the tube and one for the avoidance:

    min  ½ q̇ᵀ (Q + Jᵀ Q_δ J + H) q̇ + (g - Jᵀ Q_δ ṙ)ᵀ q̇ + penalties of the slacks
    s.t. bounds <= q̇ <= bounds,  |δ| T <= tolerance + slack,  A q̇ >= b - slack

The paper's ṙ brings the tool to its target within one step. With bounded accelerations that overshoots, so the deviation
left by the last step is corrected no faster than it can be braked; see `_correction`.

A drive has equilibria with the tracking away from the target, at an active bound even in the null space alone, and leads the
arm to others. The drive of a formulation that `yields` therefore fades where the target stands still and the arm is away from
it; see `_Approach`, which also notices that the arm comes no closer, as STALLED reports.
"""

from dataclasses import dataclass, replace
from enum import IntEnum

import casadi as ca

from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.tolerance import row_shares
from manipplan.support.checks import POSE, Array
from manipplan.support.expressions import making_expressions
from manipplan.symbolic.chain import Placement
from manipplan.symbolic.task import Task
from manipplan.tracking.avoidance import OBSTACLE_SIZE, Avoidance, AvoidanceRows, avoidance_rows
from manipplan.tracking.bounds import nearest_rotation, task_error, velocity_bounds
from manipplan.tracking.derivatives import SymbolicMeasure, convexified, gram
from manipplan.tracking.formulations import Drive, Formulation
from manipplan.tracking.reference import Reference, return_rate

#: Weights (w, w') of the penalties w p s + ½ w' s² on the slacks s, where p is stiffness and drive: large enough that a slack
#: is used only where the constraints are infeasible, and no larger, since that costs the solver precision.
TUBE_PENALTY = (10.0, 1e3)
AVOIDANCE_PENALTY = (100.0, 1e4)
PULL_LEAST = 1e3
#: Weight of the return to a reference in the null space, and share of the formulation's terms beside it. So ∇ log m of
#: `LogDrive` counts as in the servo, and both count little beside the tracking.
RETURN_WEIGHT = 10.0
BESIDE_RETURN = 0.1
#: Maximum rate that a target demands [m/s]; a farther target pulls no harder.
FASTEST = 5.0
#: Tolerances of an accepted solution on bounds and rows [rad/s, m/s], and on optimality conditions relative to their terms.
#: Where slacks are used, multipliers are 1e6 at a cost of 1. The velocity is clipped to its exact bounds afterwards.
ROW_TOLERANCE = 1e-3
OPTIMALITY_TOLERANCE = 1e-5
#: Time constant with which a deviation may approach the boundary of its tube [s].
TUBE_TIME = 0.1
#: Deceleration at which the return from outside the tube is braked [m/s²].
TUBE_RETURN = 2.0
#: A target stands still if its speed [m/s] is at most this share of its distance [m].
SLOW = 1e-2
#: The arm comes closer if the distance shrinks by this share; without that it has stalled after STALLING [s].
CLOSER = 0.005
STALLING = 1.0
#: An arm is away from its target from this distance on [m].
AWAY = 5e-4
#: Time within which a drive that yields grows or fades [s], the distance to which it may pull the tool off a target that
#: stands still [m], and the share from which it grows again.
FADING = 0.5
OFF = 1e-4
SEED = 2e-3
#: Numbers that a step remembers beside those of a formulation: the last target, whether there was one, and of `_Approach`.
MEMORY = 20
SOLVER_OPTIONS = {"primal_tol": 1e-9, "iter_limit": 1000}


class StepStatus(IntEnum):
    """Outcome of a step."""

    SOLVED = 0
    #: The QP's solution did not pass its check, for example with a nonconvex cost and convexify=False: the arm brakes.
    NOT_SOLVED = 1
    #: The target or an obstacle is not finite or no pose, or stiffness, drive or tolerance are out of range: the arm brakes.
    BAD_TARGET = 2
    #: The state is not finite: the velocity is zero.
    BAD_STATE = 3
    #: The step was solved, but for one second the arm has not come closer to its target, which stands still.
    STALLED = 4

    @property
    def brakes(self) -> bool:
        """Whether the arm brakes, since there is no valid solution."""
        return self not in (StepStatus.SOLVED, StepStatus.STALLED)


#: Entries of a step's second output.
REPORT = (
    "status",
    "manipulability",
    "position_deviation",
    "rotation_deviation",
    "tube_excess",
    "clearance",
    "avoidance_excess",
    "convexified",
)
#: Name of the generated function; `step` is already a function of the C library.
STEP_NAME = "manipplan_step"
#: Magnitude from which numbers count as not finite.
HUGE = 1e12
INPUTS = ("q", "qd", "qdd", "target", "stiffness", "drive", "tolerance", "obstacles", "memory")
PROGRAM = ("h", "g", "a", "lbx", "ubx", "lba", "uba")


@dataclass(frozen=True, kw_only=True)
class StepSetup:
    """Settings of a step: arm and task, formulation, dt [s], diagonal of Q (n,), the deceleration [m/s²] at which
    corrections are braked, which constraint rows there are, and a planned motion near which the arm stays.
    """

    kinematics: Kinematics
    formulation: Formulation
    dt: float
    weights: Array
    approach: float
    tube: bool
    avoidance: Avoidance | None
    reference: Reference | None


@dataclass(frozen=True, kw_only=True)
class ControlStep:
    """The Function of a step and the pairs of bodies of its rows.

    Attributes:
        function: maps INPUTS to the next velocity (n,), the report and the next memory. INPUTS are q, qd, qdd (n,), target
            (4, 4) transposed (so that its numbers are stored row by row), stiffness, drive (a factor on the terms of the
            formulation), tolerance (2,) [m, rad], numbers of the moving obstacles, memory.
        problem: maps the same inputs to the PROGRAM, and to the values that the report needs.
        pairs: names of the pairs that are kept apart.
    """

    function: ca.Function
    problem: ca.Function
    pairs: tuple[tuple[str, str], ...]


@making_expressions()
def step_of(setup: StepSetup) -> ControlStep:
    """Build the step: set up the problem, solve it, check the solution."""
    symbolic = setup.kinematics.symbolic
    n = symbolic.chain.q.shape[0]
    measure = SymbolicMeasure(symbolic)
    drive = setup.formulation.drive(measure, setup.dt)
    rows = avoidance_rows(setup.kinematics.robot, symbolic.chain, setup.avoidance) if setup.avoidance else None
    inputs = [
        symbolic.chain.q,
        ca.SX.sym("qd", n),
        ca.SX.sym("qdd", n),
        ca.SX.sym("target", 4, 4),
        ca.SX.sym("stiffness"),
        ca.SX.sym("drive"),
        ca.SX.sym("tolerance", 2),
        rows.obstacles if rows else ca.SX(0, 1),
        ca.vertcat(drive.memory, ca.SX.sym("before", MEMORY)),
    ]
    problem = _problem(setup, inputs, measure.value, drive, rows)
    given = [ca.MX.sym(problem.name_in(i), problem.sparsity_in(i)) for i in range(problem.n_in())]
    made = dict(zip(problem.name_out(), problem.call(given), strict=True))
    answer, solved = _answer(setup, problem, made)
    finish = _finish(setup, problem, answer.sparsity())
    ended = finish.call([solved, answer, *(made[name] for name in finish.name_in()[2:])])
    outputs = [*ended, made["next_memory"]]
    function = ca.Function(STEP_NAME, given, outputs, list(INPUTS), ["velocity", "report", "next_memory"])
    return ControlStep(function=function, problem=problem, pairs=rows.names if rows else ())


def _soundness(inputs: list[ca.SX]) -> tuple[ca.SX, ca.SX]:
    """Whether the state is valid, and whether the target and the inputs given with it are."""
    q, qd, qdd, target, stiffness, drive, tolerance, obstacles, _ = inputs
    state = _all(ca.fabs(ca.vertcat(q, qd, qdd)) < HUGE)
    given = ca.vertcat(ca.vec(target), stiffness, drive, obstacles)
    turns = [target[:3, :3], *(ca.reshape(obstacles[at : at + 9], 3, 3) for at in range(0, obstacles.shape[0], OBSTACLE_SIZE))]
    rigid = [nearest_rotation(turn)[1] for turn in turns]
    last = ca.fabs(target[:, 3] - ca.DM([0, 0, 0, 1])) <= POSE
    return state, _all(ca.vertcat(ca.fabs(given) < HUGE, stiffness > 0, drive >= 0, tolerance >= 0, last, *rigid))


def _rigid(target: ca.SX) -> ca.SX:
    """The rigid transform nearest to a target, both transposed (4, 4)."""
    pose = ca.SX(target)
    pose[:3, :3] = nearest_rotation(target[:3, :3])[0]
    return pose


def _problem(
    setup: StepSetup, inputs: list[ca.SX], manipulability: ca.SX, drive: Drive, rows: AvoidanceRows | None
) -> ca.Function:
    """The QP (where there is none the velocity instead), and the values that the report needs."""
    q, qd, qdd, target, stiffness, share, *_ = inputs
    goal = _rigid(target)
    symbolic, formulation, dt = setup.kinematics.symbolic, setup.formulation, setup.dt
    jacobian = ca.densify(symbolic.posture.jacobian)
    good_state, good_target = _soundness(inputs)
    sound = ca.logic_and(good_state, good_target)
    error = ca.densify(task_error(symbolic.task, symbolic.chain.tool, _placement(goal)))
    deviation = _deviation_before(setup, inputs, goal)
    approach = _Approach.of(setup, inputs, error, deviation)
    rate = (error - (1 - _correction(setup, deviation)) * deviation) / dt
    if setup.approach < ca.inf:
        rate *= ca.fmin(1, FASTEST / (ca.sqrt(ca.sumsqr(rate)) + 1e-300))
    low, high = velocity_bounds(q, qd, qdd, setup.kinematics.robot.limits, dt)
    if formulation.yields:
        share *= approach.share
    bent = ca.SX(0)
    back = null = ca.SX(0)
    if setup.reference is not None:
        back, null = return_rate(setup.reference, q, symbolic.chain.tool, symbolic.task, jacobian, dt)
        drive = replace(drive, hessian=BESIDE_RETURN * drive.hessian, gradient=BESIDE_RETURN * drive.gradient)
    outputs: dict[str, ca.SX]
    if not formulation.solves_qp:
        velocity = formulation.closed_form(jacobian, rate, share * (back - drive.gradient))
        outputs = {"velocity": velocity, "lbx": low, "ubx": high}
    else:
        hessian = ca.diag(ca.SX(ca.DM(setup.weights))) + stiffness * gram(jacobian) + share * drive.hessian
        if setup.approach < ca.inf:
            # damping by the remaining deviation, for a target out of reach [sugihara2011]
            hessian += stiffness * ca.sumsqr(deviation) * ca.SX.eye(q.shape[0])
        if formulation.convexify:
            hessian, bent = convexified(hessian)
        gradient = share * drive.gradient - stiffness * (jacobian.T @ rate)
        if setup.reference is not None:  # ½ w (q̇ - back)ᵀ N (q̇ - back) with the projector N
            hessian += share * RETURN_WEIGHT * null
            gradient -= share * RETURN_WEIGHT * back
        tube = _tube(setup, inputs, jacobian, error, deviation) if setup.tube else None
        pull = stiffness + ca.sqrt(ca.sumsqr(share * drive.gradient))
        program = _program(hessian, gradient, pull, (low, high), tube, rows)
        outputs = dict(zip(PROGRAM, program, strict=True))
        free, feasible = _free_minimum(hessian, gradient, program)
        outputs["feasible"] = ca.logic_or(feasible, ca.logic_not(sound))  # invalid inputs need no QP solver
        outputs["free"] = ca.vertcat(free, ca.SX.zeros(program[0].shape[0] - free.shape[0]))
    clearance = ca.mmin(rows.distance) if rows else ca.SX(ca.inf)
    figures = ca.vertcat(good_state, good_target, approach.stalled, manipulability, clearance, bent)
    outputs |= {"jacobian": jacobian, "error": error, "figures": figures}
    outputs["next_memory"] = _next_memory(drive.next_memory, goal, approach, good_state, sound)
    made = ca.cse([ca.densify(each) for each in outputs.values()])
    return ca.Function("problem", inputs, made, list(INPUTS), list(outputs))


def _answer(setup: StepSetup, problem: ca.Function, made: dict[str, ca.MX]) -> tuple[ca.MX, ca.MX]:
    """The QP's variables, and whether they solve it.

    If the unconstrained minimum satisfies all constraints, it is the solution; otherwise DAQP computes it.
    """
    if not setup.formulation.solves_qp:
        return made["velocity"], ca.MX(1)
    names = [*PROGRAM, "free"]
    inputs = [ca.MX.sym(name, problem.sparsity_out(name)) for name in names]
    keep = ca.Function("keep", inputs, [inputs[-1], ca.MX(1)])
    sparsity = {"h": inputs[0].sparsity(), "a": inputs[2].sparsity()}
    solver = ca.conic("qp", "daqp", sparsity, {"error_on_fail": False, "daqp": SOLVER_OPTIONS})
    solution = solver(**dict(zip(PROGRAM, inputs, strict=False)))
    parts = [ca.SX.sym(name, problem.sparsity_out(name)) for name in PROGRAM]
    found = [ca.SX.sym(name, solution[name].sparsity()) for name in ("x", "lam_x", "lam_a")]
    check = ca.Function("check", [*parts, *found], [_is_solved(parts, *found)])
    checked = check(*inputs[:-1], solution["x"], solution["lam_x"], solution["lam_a"])
    search = ca.Function("search", inputs, [solution["x"], checked])
    answer, solved = ca.Function.if_else("answer", keep, search).call([made["feasible"], *(made[name] for name in names)])
    return answer, solved


def _free_minimum(hessian: ca.SX, gradient: ca.SX, program: list[ca.SX]) -> tuple[ca.SX, ca.SX]:
    """The unconstrained minimum of ½ q̇ᵀ H q̇ + gᵀ q̇, by L D Lᵀ, and whether it satisfies all constraints without slack."""
    _, _, matrix, low, high, below, above = program
    n = hessian.shape[0]
    factor, pivots = ca.SX(hessian), []
    for j in range(n):
        pivots.append(factor[j, j])
        for i in range(j + 1, n):
            share = factor[i, j] / pivots[j]
            for k in range(i, n):
                factor[k, i] -= share * factor[k, j]
            factor[i, j] = share
    velocity = ca.SX(-gradient)
    for i in range(n):
        velocity[i] -= sum((factor[i, j] * velocity[j] for j in range(i)), start=ca.SX(0))
    for i in range(n):
        velocity[i] /= pivots[i]
    for i in reversed(range(n)):
        velocity[i] -= sum((factor[j, i] * velocity[j] for j in range(i + 1, n)), start=ca.SX(0))
    checks = [ca.vertcat(*pivots) > 0, velocity >= low[:n], velocity <= high[:n]]
    if matrix.shape[0]:
        values = matrix[:, :n] @ velocity
        checks += [values >= below, values <= above]
    return velocity, _all(ca.vertcat(*checks))


def _finish(setup: StepSetup, problem: ca.Function, answer: ca.Sparsity) -> ca.Function:
    """The Function from whether the QP is solved and its solution to the velocity and the report."""
    names = ("lbx", "ubx", "jacobian", "error", "figures")
    made = {name: ca.SX.sym(name, problem.sparsity_out(name)) for name in names}
    variables, solved = ca.SX.sym("answer", answer), ca.SX.sym("solved")
    good_state, good_target, stalled, value, clearance, bent = ca.vertsplit(made["figures"])
    n = made["jacobian"].shape[1]
    low, high = made["lbx"][:n], made["ubx"][:n]
    velocity, slack = variables[:n], variables[n:]
    solved_too = ca.logic_and(solved, _all(ca.fabs(velocity) < HUGE))
    # braking: the velocity within the bounds that is nearest to zero
    accepted = ca.logic_and(solved_too, ca.logic_and(good_state, good_target))
    velocity = ca.if_else(good_state, _clip(ca.if_else(accepted, velocity, 0), low, high), 0)
    status = ca.if_else(stalled, float(StepStatus.STALLED), float(StepStatus.SOLVED))
    status = ca.if_else(solved_too, status, float(StepStatus.NOT_SOLVED))
    status = ca.if_else(good_target, status, float(StepStatus.BAD_TARGET))
    status = ca.if_else(good_state, status, float(StepStatus.BAD_STATE))
    left = made["error"] - made["jacobian"] @ velocity * setup.dt
    tube, avoidance = slack[0] if setup.tube else 0, slack[-1] if setup.avoidance else 0
    report = ca.vertcat(status, value, *_deviation(setup.kinematics.task, left), tube * setup.dt, clearance, avoidance, bent)
    inputs = [solved, variables, *made.values()]
    outputs = [ca.densify(velocity), ca.densify(report)]
    return ca.Function("finish", inputs, outputs, ["solved", "answer", *names], ["velocity", "report"])


def _next_memory(learned: ca.SX, goal: ca.SX, approach: "_Approach", good_state: ca.SX, sound: ca.SX) -> ca.SX:
    """The memory of the next step, without values from an invalid state or target."""
    learned = ca.if_else(good_state, learned, 0) if learned.shape[0] else learned
    known = ca.if_else(sound, ca.vertcat(approach.share, approach.nearest, approach.waited), 0)
    return ca.vertcat(learned, ca.vec(goal), sound, known)


def _placement(rows: ca.SX) -> Placement:
    """The placement from a pose (4, 4) stored row by row, which CasADi reads as its transpose."""
    return Placement(rotation=rows[:3, :3].T, origin=rows[3, :3].T)


def _deviation(task: Task, left: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Length [m] and angle [rad] of the residual `left` (m, 1) of a task's rows."""
    turns = [any(row[3:]) for row in (*task.world_rows, *task.tool_rows)]
    position = [left[i] for i, turned in enumerate(turns) if not turned]
    rotation = [left[i] / task.length for i, turned in enumerate(turns) if turned]
    return ca.sqrt(ca.sumsqr(ca.vertcat(0, *position))), ca.sqrt(ca.sumsqr(ca.vertcat(0, *rotation)))


def _deviation_before(setup: StepSetup, inputs: list[ca.SX], goal: ca.SX) -> ca.SX:
    """Deviation of the tool from the target of the last step, (m, 1); the whole error if there was none."""
    last = inputs[8][-MEMORY:]
    before, started = ca.reshape(last[:16], 4, 4), last[16] > 0
    symbolic = setup.kinematics.symbolic
    target = _placement(ca.if_else(started, before, goal))
    return task_error(symbolic.task, symbolic.chain.tool, target)


def _correction(setup: StepSetup, deviation: ca.SX) -> ca.SX:
    """Share of a deviation that one step corrects: all of it, but no faster than it can be braked, sqrt(2 a |e|)."""
    if setup.approach == ca.inf:
        return ca.SX(1)
    size = ca.sqrt(ca.sumsqr(deviation)) + 1e-300
    return ca.fmin(1, setup.dt * ca.sqrt(2 * setup.approach / size))


def _width(setup: StepSetup, inputs: list[ca.SX]) -> ca.SX:
    """Half of the tube's width in each row (m, 1)."""
    position, rotation = (ca.DM(share) for share in row_shares(setup.kinematics.task))
    return position * inputs[6][0] + rotation * inputs[6][1]


@dataclass(frozen=True, kw_only=True)
class _Approach:
    """Whether the arm comes closer to a target that stands still.

    Attributes:
        share: factor on a drive that yields, from 0 to 1: it grows while the target moves, and fades while the target stands
            still and the arm is away from it.
        nearest: least distance to the target, or to its tube, about STALLING ago [m].
        waited: time since that distance has shrunk by its share CLOSER [s].
        stalled: whether the arm is away from its target and has waited for STALLING.
    """

    share: ca.SX
    nearest: ca.SX
    waited: ca.SX
    stalled: ca.SX

    @classmethod
    def of(cls, setup: StepSetup, inputs: list[ca.SX], error: ca.SX, deviation: ca.SX) -> "_Approach":
        _, started, share, nearest, waited = ca.vertsplit(inputs[8][-MEMORY:], [0, 16, 17, 18, 19, 20])
        dt = setup.dt
        outside = ca.fmax(ca.fabs(error) - _width(setup, inputs), 0) if setup.tube else error
        distance = ca.sqrt(ca.sumsqr(outside))
        still = ca.sqrt(ca.sumsqr(error - deviation)) <= dt * SLOW * (distance + OFF)
        waits = ca.logic_and(ca.logic_and(started, still), distance > (1 - CLOSER) * nearest)
        waited = ca.if_else(waits, waited + dt, 0)
        away = distance > AWAY
        # near the target the share settles where the drive pulls the tool off by OFF
        near = (share + SEED) * (1 - distance / OFF) / FADING
        change = ca.if_else(still, ca.if_else(away, -1 / FADING, near), 1 / FADING)
        share = ca.if_else(started, ca.fmax(0, ca.fmin(1, share + dt * change)), ca.logic_not(away))
        stalled = ca.logic_and(waited >= STALLING, away)
        # an arm that creeps must not look closer after many seconds
        crept = nearest - ca.fmax(nearest - distance, 0) * min(dt / STALLING, 1.0)
        return cls(share=share, nearest=ca.if_else(waits, crept, distance), waited=waited, stalled=stalled)


def _tube(setup: StepSetup, inputs: list[ca.SX], jacobian: ca.SX, error: ca.SX, deviation: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Bounds J q̇ >= low, J q̇ <= high of the tube.

    A step may use the share κ of the distance from the deviation e, from the last target, to the tube's boundary w: it leaves
    a deviation δ T of at most e + κ (w - e). So the arm slows down before it reaches the boundary. A deviation outside the
    tube returns as fast as it can be braked.
    """
    started = inputs[8][16 - MEMORY] > 0
    width = _width(setup, inputs)
    share = ca.if_else(started, min(setup.dt / TUBE_TIME, 1.0), 1.0)

    def most(side: ca.SX) -> ca.SX:
        beyond = side - width
        back = ca.fmin(1, setup.dt * ca.sqrt(2 * TUBE_RETURN / ca.fmax(beyond, 1e-12)))
        return ca.if_else(beyond > 0, width + (1 - back) * beyond, side + share * (width - side))

    high, low = most(deviation), -most(-deviation)
    # the opposite boundary does not restrict the return
    high, low = (
        ca.if_else(deviation < 0, ca.fmax(high, low), high),
        ca.if_else(deviation > 0, ca.fmin(low, high), low),
    )
    return jacobian, (error - high) / setup.dt, (error - low) / setup.dt


def _program(
    hessian: ca.SX,
    gradient: ca.SX,
    pull: ca.SX,
    bounds: tuple[ca.SX, ca.SX],
    tube: tuple[ca.SX, ca.SX, ca.SX] | None,
    rows: AvoidanceRows | None,
) -> list[ca.SX]:
    """H, g, A, variable bounds, row bounds of the QP in (q̇, slack of the tube, slack of the avoidance).

    `pull` is the part of the cost that the penalties of the slacks have to outweigh.
    """
    n = gradient.shape[0]
    penalties = [*([TUBE_PENALTY] if tube else []), *([AVOIDANCE_PENALTY] if rows else [])]
    slacks = len(penalties)
    hessian = ca.diagcat(hessian, *(square for _, square in penalties))
    gradient = ca.vertcat(gradient, *(linear * (PULL_LEAST + pull) for linear, _ in penalties))
    low = ca.vertcat(bounds[0], ca.SX.zeros(slacks))
    high = ca.vertcat(bounds[1], ca.inf * ca.SX.ones(slacks))
    matrix, below, above = ca.SX(0, n + slacks), ca.SX(0, 1), ca.SX(0, 1)
    if tube:
        jacobian, least, most = tube
        m = jacobian.shape[0]
        slack = ca.horzcat(ca.SX.ones(m, 1), ca.SX(m, slacks - 1))
        matrix = ca.vertcat(matrix, ca.horzcat(jacobian, slack), ca.horzcat(jacobian, -slack))
        below = ca.vertcat(below, least, -ca.inf * ca.SX.ones(m))
        above = ca.vertcat(above, ca.inf * ca.SX.ones(m), most)
    if rows:
        count = rows.matrix.shape[0]
        slack = ca.horzcat(ca.SX(count, slacks - 1), ca.SX.ones(count, 1))
        matrix = ca.vertcat(matrix, ca.horzcat(rows.matrix, slack))
        below, above = ca.vertcat(below, rows.bound), ca.vertcat(above, ca.inf * ca.SX.ones(count))
    return [hessian, gradient, matrix, low, high, below, above]


def _is_solved(parts: list[ca.SX], x: ca.SX, at_bounds: ca.SX, at_rows: ca.SX) -> ca.SX:
    """Whether x with its multipliers satisfies the constraints and the first-order conditions; false if a number is NaN."""
    hessian, gradient, matrix, low, high, below, above = parts
    curve, push = hessian @ x, matrix.T @ at_rows
    residual = ca.fabs(curve + gradient + push + at_bounds)
    scale = 1 + ca.fabs(curve) + ca.fabs(gradient) + ca.fabs(push) + ca.fabs(at_bounds)
    checks = [residual <= OPTIMALITY_TOLERANCE * scale, x >= low - ROW_TOLERANCE, x <= high + ROW_TOLERANCE]
    if matrix.shape[0]:
        values = matrix @ x
        checks += [values >= below - ROW_TOLERANCE, values <= above + ROW_TOLERANCE]
    return _all(ca.vertcat(*checks))


def _all(conditions: ca.SX) -> ca.SX:
    held = conditions[0]
    for each in ca.vertsplit(conditions)[1:]:
        held = ca.logic_and(held, each)
    return held


def _clip(values: ca.SX, low: ca.SX, high: ca.SX) -> ca.SX:
    return ca.fmin(ca.fmax(values, low), high)
