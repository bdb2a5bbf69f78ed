"""The nonlinear program that improves a whole path within the tolerance of given poses, and the joint path through its result.

The program raises the minimum manipulability, or shortens the path at that minimum. Unknowns: configurations X (n, L) and the
level t. Constraints: m(x_i) >= t, pose rows within the tolerance, steps within ε, and linearised distance constraints. It is
solved inside a trust region around the current path, where the linearisation holds.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from manipplan.ik.solver import Solver
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import SMALLEST, Tolerance
from manipplan.search.layers import INSIDE_LIMITS
from manipplan.search.sweep import full_turns
from manipplan.support.checks import Array
from manipplan.support.expressions import making_expressions
from manipplan.support.memo import once_per_owner
from manipplan.symbolic.chain import Placement
from manipplan.symbolic.free_motion import BoundedMotion, Turns, complement

#: Number of linear distance rows per position.
ROWS = 4
#: Largest number of positions for which the program is kept.
SHORT = 40
#: Number of terms of a series for rotations up to 60°, and least cosine of a rotation, beyond which they have no one vector.
SERIES, LEAST_COSINE = 24, -1 + 1e-9
#: Bound on the pose rows [m or rad] where there is no tolerance.
EXACT = 1e-11


def level_program(kinematics: Kinematics, positions: int, *, closed: bool) -> "LevelProgram":
    """The program for L positions of one arm and task; those of short paths, which programs of moves have, are kept."""
    if positions > SHORT:
        return LevelProgram(kinematics, positions, closed=closed)
    return _find_program(kinematics, positions, closed=closed)


@once_per_owner
def _find_program(kinematics: Kinematics, positions: int, *, closed: bool) -> "LevelProgram":
    return LevelProgram(kinematics, positions, closed=closed)


class LevelProgram:
    """The program for L positions of one arm and task; built once, solved for many paths.

    Args:
        kinematics: defines the manipulability that is raised, for a task whose rows fix a set of poses.
        positions: L.
        closed: whether the last position neighbours the first.
    """

    def __init__(self, kinematics: Kinematics, positions: int, *, closed: bool) -> None:
        self.kinematics, self.positions, self.closed = kinematics, positions, closed
        n = kinematics.robot.n
        self.rows = PoseRows(kinematics)
        x, t = ca.MX.sym("x", n, positions), ca.MX.sym("t")
        about = ca.MX.sym("about", n, positions)
        poses = ca.MX.sym("poses", 16, positions)
        slopes = ca.MX.sym("slopes", n * ROWS, positions)
        scale = ca.MX.sym("scale")
        weight = ca.MX.sym("weight")
        winding = ca.MX.sym("winding", n)
        level = _derivatives(kinematics)
        m, slopes_of_m, error, slopes_of_error = level.first.map(positions)(x, poses)
        ends = ca.horzcat(x[:, 1:], x[:, 0] + winding) if closed else x[:, 1:]
        steps = ends - (x if closed else x[:, :-1])
        turned = [ca.reshape(each, n, ROWS).T for each in ca.horzsplit(slopes)]
        distances = [rows @ (x[:, k] - about[:, k]) for k, rows in enumerate(turned)]
        self._steps = positions if closed else positions - 1
        unknowns = ca.vertcat(ca.vec(x), t)
        parameters = ca.vertcat(ca.vec(about), ca.vec(poses), ca.vec(slopes), winding, scale, weight)
        shorter = weight / max(self._steps, 1)
        nlp = {
            "x": unknowns,
            "p": parameters,
            "f": (weight - 1) * t + shorter * ca.sumsqr(steps),
            "g": ca.vertcat(m.T / scale - t, ca.vec(error), ca.vec(steps), ca.vertcat(*distances)),
        }
        # the derivatives block by block: CasADi's own take twenty times as long
        differences = _differences(n, positions, closed=closed)
        none = ca.MX(differences.shape[0] + (self.rows.count + ROWS) * positions, 1)
        jacobian = ca.vertcat(
            _diagonal(slopes_of_m, n) / scale, _diagonal(slopes_of_error, n), ca.MX(differences), ca.diagcat(*turned)
        )
        jacobian = ca.horzcat(jacobian, ca.vertcat(-ca.MX.ones(positions, 1), none))
        factors, weights = ca.MX.sym("factors", nlp["g"].shape[0]), ca.MX.sym("weight of f")
        of_error = ca.reshape(factors[positions : positions * (1 + self.rows.count)], self.rows.count, positions)
        curved = level.second.map(positions)(x, poses, factors[:positions].T / scale, of_error)
        squares = 2 * weights * shorter * ca.MX(differences.T @ differences)
        hessian = ca.diagcat(_diagonal(curved, n) + squares, ca.MX(1, 1))
        options = {
            "jac_g": ca.Function("jac_g", [unknowns, parameters], [nlp["g"], jacobian]),
            "hess_lag": ca.Function("hess_lag", [unknowns, parameters, weights, factors], [ca.triu(hessian)]),
            "print_time": False,
            "error_on_fail": False,
            "ipopt": {
                "print_level": 0,
                "sb": "yes",
                "max_iter": 60,
                "tol": 1e-7,
                "constr_viol_tol": 1e-11,
                "bound_relax_factor": 0.0,
                "mu_strategy": "adaptive",
            },
        }
        self._solve = ca.nlpsol("level", "ipopt", nlp, options)

    def solve(
        self,
        q: Array,
        poses: Array,
        *,
        epsilon: Array,
        tolerance: Array,
        trust: float,
        slopes: Array,
        slack: Array,
        level: float | None = None,
        hold_start: bool = False,
    ) -> tuple[Array, float]:
        """A path (L, n) with a higher level, and its level [the measure's unit]; with `level`, a shorter path at that level.

        Args:
            q: (L, n) the current path.
            poses: (L, 4, 4).
            epsilon: (n,) largest steps [rad or m], or for each step.
            tolerance: (rows,) half width of the box of each pose row; 0: met exactly.
            trust: largest change of each joint from the current path.
            slopes: (L, ROWS, n) gradients of distances [m per rad or m]; zeros where there is none.
            slack: (L, ROWS) amount by which each distance may shrink [m], at least 0.
            level: see above.
            hold_start: whether the first configuration stays as it is, whatever its pose.
        """
        limits, positions = self.kinematics.robot.limits, self.positions
        m = self.kinematics.manipulability(q)
        scale = float(np.abs(m).min()) or 1.0
        turns = full_turns(q, self.kinematics.robot.continuous_joints)
        weights = np.array([scale, 0.0 if level is None else 1.0])
        parameters = [q.ravel(), poses.transpose(0, 2, 1).ravel(), slopes.ravel(), turns, weights]
        # a configuration nearer to a limit than INSIDE_LIMITS goes no nearer: the spline through the path bows outwards
        lower = np.maximum(q - trust, np.minimum(limits.lower + INSIDE_LIMITS, q))
        upper = np.minimum(q + trust, np.maximum(limits.upper - INSIDE_LIMITS, q))
        box = np.tile(np.maximum(tolerance, EXACT), positions)
        if hold_start:
            lower[0] = upper[0] = q[0]
            box[: len(tolerance)] = np.inf
        most = np.broadcast_to(epsilon, (self._steps, q.shape[1])).ravel()
        fixed = None if level is None else level / scale
        result = self._solve(
            x0=np.append(q.ravel(), m.min() / scale if fixed is None else fixed),
            p=np.concatenate(parameters),
            lbx=np.append(lower.ravel(), -np.inf if fixed is None else fixed),
            ubx=np.append(upper.ravel(), np.inf if fixed is None else fixed),
            lbg=np.concatenate([np.zeros(positions), -box, -most, -slack.ravel()]),
            ubg=np.concatenate([np.full(positions, np.inf), box, most, np.full(slack.size, np.inf)]),
        )
        x = np.asarray(result["x"]).ravel()
        return x[:-1].reshape(q.shape), float(x[-1]) * scale


@dataclass(frozen=True, kw_only=True, eq=False)
class LevelDerivatives:
    """Functions of a configuration q (n,) and a pose (16,) that the program needs.

    Attributes:
        first: manipulability, its gradient (1, n), pose rows (rows,), their Jacobian (rows, n).
        second: of weights (1,) and (rows,) of manipulability and pose rows, the Hessian (n, n) of their weighted sum.
    """

    first: ca.Function
    second: ca.Function


@once_per_owner
@making_expressions()
def _derivatives(kinematics: Kinematics) -> LevelDerivatives:
    symbolic, q, pose = kinematics.symbolic, ca.SX.sym("q", kinematics.robot.n), ca.SX.sym("pose", 16)
    error = pose_error(kinematics)(q, pose)
    of_m, of_error = ca.SX.sym("of_m"), ca.SX.sym("of_error", error.shape[0])
    dense = [ca.densify(e) for e in (symbolic.manipulability(q), symbolic.gradient(q).T, error, ca.jacobian(error, q))]
    hessian = ca.densify(of_m * symbolic.hessian(q) + ca.hessian(ca.dot(of_error, error), q)[0])
    return LevelDerivatives(
        first=ca.Function("first", [q, pose], dense), second=ca.Function("second", [q, pose, of_m, of_error], [hessian])
    )


def _diagonal(blocks: ca.MX, n: int) -> ca.MX:
    """The block-diagonal matrix of blocks (r, n) that stand beside each other."""
    return ca.diagcat(*ca.horzsplit(blocks, n))


def _differences(n: int, positions: int, *, closed: bool) -> ca.DM:
    """The matrix of the steps between configurations (n, positions), column by column."""
    count = positions if closed else positions - 1
    rows = [*range(count), *range(count)]
    columns = [*range(count), *((k + 1) % positions for k in range(count))]
    along = ca.DM.triplet(rows, columns, ca.DM([-1.0] * count + [1.0] * count), count, positions)
    return ca.kron(along, ca.DM.eye(n))


@making_expressions()
def pose_error(kinematics: Kinematics) -> ca.Function:
    """Error of the tool at q (n,) to a pose (16,), column by column: position [m], then sines of angles; smooth.

    Of the position what the task fixes. Three angles about the pose's axes, one for a planar arm; where the tool may turn about
    one axis, two perpendicular to it; none where it may turn at all. Within a region see `_error_in_region`.
    """
    chain, free, planar = kinematics.symbolic.chain, kinematics.free_motion, kinematics.robot.planar
    pose = ca.SX.sym("pose", 16)
    matrix = ca.reshape(pose, 4, 4)
    target, tool = Placement(rotation=matrix[:3, :3], origin=matrix[:3, 3]), chain.tool
    turned = target.rotation.T @ tool.rotation
    position = tool.origin - target.origin
    if isinstance(free, BoundedMotion):
        turned = turned if free.in_tool else tool.rotation @ target.rotation.T
        moved = target.rotation.T @ position if free.in_tool else position
        error = ca.vertcat(moved[:2] if planar else moved, _turn_in_region(free, turned, planar=planar))
        return ca.Function("pose_error", [chain.q, pose], [ca.densify(error)])
    if free.in_tool:
        position = target.rotation.T @ position
    skew = _skew_part(turned)
    rows = [ca.DM(complement(np.vstack([free.shifts, np.eye(3)[2:]])) if planar else free.fixed_directions) @ position]
    if free.turns is Turns.NONE:
        rows.append(skew[2] if planar else skew)
    elif free.turns is not Turns.ANY and not planar:
        turn = turned if free.turns is Turns.TOOL_AXIS else tool.rotation @ target.rotation.T
        rows.append(ca.DM(np.linalg.svd(free.axis[None, :])[2][1:]) @ (turn @ ca.DM(free.axis)))
    return ca.Function("pose_error", [chain.q, pose], [ca.densify(ca.vertcat(*rows))])


def _skew_part(turned: ca.SX) -> ca.SX:
    """The axis of a rotation times the sine of its angle (3,)."""
    return ca.vertcat(turned[2, 1] - turned[1, 2], turned[0, 2] - turned[2, 0], turned[1, 0] - turned[0, 1]) / 2


def _turn_in_region(free: BoundedMotion, turned: ca.SX, *, planar: bool) -> ca.SX:
    """What is bounded of a rotation (3, 3): its rotation vector; of a cone 1 - cos of the tilt, and the spin if bounded."""
    trace = turned[0, 0] + turned[1, 1] + turned[2, 2]
    if free.region.cone is not None:
        axis = ca.DM(np.array(free.region.axis))
        tilt = 1 - ca.dot(axis, turned @ axis)
        spin = 2 * ca.atan2(2 * ca.dot(_skew_part(turned), axis), 1 + trace)
        return tilt if free.region.spin == np.pi else ca.vertcat(tilt, spin)
    # angle / sine of the angle, over 1 - cosine: a series where the quotient is not smooth
    cosine = (trace - 1) / 2
    series, term = ca.SX(0), ca.SX(1)
    for k in range(SERIES):
        series += term
        term *= (1 - cosine) * (k + 1) / (2 * k + 3)
    far = ca.fmin(ca.fmax(cosine, LEAST_COSINE), 0.5)
    scale = ca.if_else(cosine > 0.5, series, ca.acos(far) / ca.sqrt(1 - far**2))
    vector = scale * _skew_part(turned)
    return vector[2] if planar else vector


class PoseRows:
    """Errors of the tool to poses, row by row; see `pose_error`."""

    def __init__(self, kinematics: Kinematics) -> None:
        self.error, free = pose_error(kinematics), kinematics.free_motion
        self.count = int(self.error.size1_out(0))
        self._region = free if isinstance(free, BoundedMotion) else None
        self._planar = kinematics.robot.planar
        self._moves = (3 if self._region is not None else len(free.fixed_directions)) - self._planar

    def box(self, tolerance: Tolerance | None) -> Array:
        """Half widths (rows,) of the box inside the ball of a tolerance, in the rows' units; zeros without a tolerance.

        Within a region the tolerance is added to its bounds.
        """
        if self._region is not None:
            return self._box_about(self._region, tolerance)
        rows = np.zeros(self.count)
        if tolerance is not None:
            moves = self._moves
            if tolerance.position is not None and moves:
                rows[:moves] = tolerance.position / np.sqrt(moves)
            if tolerance.rotation is not None and self.count > moves:
                rows[moves:] = np.sin(min(tolerance.rotation, np.pi / 2)) / np.sqrt(self.count - moves)
        return rows

    def _box_about(self, free: BoundedMotion, tolerance: Tolerance | None) -> Array:
        moves, turns = self._moves, self.count - self._moves
        more = np.zeros(2) if tolerance is None else np.array([tolerance.position or 0.0, tolerance.rotation or 0.0])
        widths = free.widths[[0, 1, 5] if self._planar else slice(None)]
        position, rotation = widths[:moves] + more[0] / np.sqrt(moves), widths[moves:]
        if free.region.cone is None:
            return np.append(position, rotation + more[1] / np.sqrt(turns))
        tilt = 1 - np.cos(min(free.region.cone + more[1] / np.sqrt(turns), np.pi))
        return np.append(position, [tilt, free.region.spin + more[1] / np.sqrt(turns)][:turns])

    def errors(self, q: Array, poses: Array) -> Array:
        """The pose rows (L, rows) of configurations (L, n)."""
        columns = self.error.map(len(q))(ca.DM(q.T), ca.DM(poses.transpose(0, 2, 1).reshape(len(q), 16).T))
        return np.asarray(columns).T


#: Number of points between two knots at which the deviation is checked, an odd one, as it is largest half-way between them,
#: number of knot insertions, and their maximum number while each reduces the deviation to this share, as at corners.
POINTS_BETWEEN_KNOTS = 5
DOUBLINGS, MOST_DOUBLINGS, HELPS = 6, 16, 0.7
#: Distance beyond a position limit that is rounding, a share of what the check of a motion allows [rad or m].
BEYOND = 1e-9
#: Shares of the tube's width that are tried where all of it does not help.
NARROWER = (0.6, 0.3, 0.0)


def joint_path(
    solver: Solver,
    rows: PoseRows,
    path: CartesianPath,
    s: Array,
    q: Array,
    *,
    closed: bool,
    allowed: Array,
    most: Array,
    tube: Tolerance | None = None,
    hold_start: bool = False,
) -> tuple[JointPath, NDArray[np.bool_]]:
    """A smooth joint path through q (k, n) at s (k,), which follows `path` to `allowed` (rows,) also between the positions.

    Also returns in which of the intervals between them it does to `most` (rows,), which is no less, (k - 1,).

    Where it does not, or leaves the position limits, knots are added half-way and projected onto the workspace path, or into a
    `tube` around it. Where that does not help within DOUBLINGS rounds, since a path from one side of the tube to the other
    bows out of it, the tube is made narrower for all knots, but for the first with `hold_start`.
    """
    narrower = () if tube is None else (0.0,) if solver.free.names else NARROWER
    for share in (1.0, *narrower):
        narrow = None if tube is None or share == 0 else tube.scaled(share)
        begun = q
        if share < 1:
            begun = _onto_tube(solver, narrow, path(s), q, inside=0.0)
            begun[0] = q[0] if hold_start else begun[0]
            if closed:
                begun[-1] = begun[0] + (q[-1] - q[0])
        joints, loose = _with_knots(solver, rows, path, s, begun, closed=closed, allowed=allowed, most=most, tube=narrow)
        if not len(loose):
            break
    is_inside = np.ones(len(s) - 1, dtype=np.bool_)
    is_inside[np.searchsorted(s, loose, side="right") - 1] = False
    return joints, is_inside


def _with_knots(
    solver: Solver,
    rows: PoseRows,
    path: CartesianPath,
    s: Array,
    q: Array,
    *,
    closed: bool,
    allowed: Array,
    most: Array,
    tube: Tolerance | None,
) -> tuple[JointPath, Array]:
    """The joint path with knots added, and the s (w,) of intervals in which it does not follow the path to `most` even so."""
    worst = np.inf
    for k in range(MOST_DOUBLINGS + 1):
        joints = JointPath.spline(s, q, closed=closed)
        shares = np.arange(1, 2 * POINTS_BETWEEN_KNOTS, 2) / (2 * POINTS_BETWEEN_KNOTS)
        between = s[:-1, None] + np.diff(s)[:, None] * shares
        errors = rows.errors(joints(between.ravel()), path(between.ravel())).reshape(len(s) - 1, POINTS_BETWEEN_KNOTS, -1)
        outside = solver.robot.limits.outside(_extremes(joints, s)).max(axis=(1, 2)) > BEYOND
        wide = np.flatnonzero((np.abs(errors) > allowed).any(axis=(1, 2)) | outside)
        middle = (s[wide] + s[wide + 1]) / 2
        before, worst = worst, float((np.abs(errors[wide]) / np.maximum(most, SMALLEST)).max(initial=0.0))
        if not len(wide) or k == MOST_DOUBLINGS or (k >= DOUBLINGS and worst > HELPS * before):
            loose = wide[(np.abs(errors[wide]) > most).any(axis=(1, 2)) | outside[wide]]
            middle = (s[loose] + s[loose + 1]) / 2
            break
        s = np.insert(s, wide + 1, middle)
        q = np.insert(q, wide + 1, _onto_tube(solver, tube, path(middle), joints(middle), inside=INSIDE_LIMITS / 2), axis=0)
    return joints, middle


def _extremes(joints: JointPath, s: Array) -> Array:
    """Where joints turn back on cubic pieces between knots s (k,), and the end of those where they do not, (k - 1, 2, n)."""
    q, slopes, widths = joints(s), joints(s, 1), np.diff(s)[:, None]
    moved, first, last = np.diff(q, axis=0), widths * slopes[:-1], widths * slopes[1:]
    square, cube = 3 * moved - 2 * first - last, first + last - 2 * moved
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(np.maximum(square**2 - 3 * first * cube, 0.0))
        far = -(square + np.copysign(root, square))
        u = np.stack([far / (3 * cube), first / far], axis=1)
    u = np.where((u > 0) & (u < 1), u, 1.0)
    return np.asarray(q[:-1, None] + u * (first[:, None] + u * (square[:, None] + u * cube[:, None])))


def _onto_tube(solver: Solver, tube: Tolerance | None, targets: Array, q: Array, *, inside: float) -> Array:
    """Configurations q (k, n) moved into the tube around targets (k, 4, 4), or onto them; see `Solver.onto` for `inside`."""
    if tube is not None and not solver.free.names:
        targets = _into(tube, targets, solver.kinematics.pose(q))
    return solver.onto(q, targets, inside=inside)


def _into(tube: Tolerance, targets: Array, poses: Array) -> Array:
    """Poses (k, 4, 4) moved towards targets until they are inside the tube; onto the target where it gives no tolerance."""
    from scipy.spatial.transform import Rotation

    moved = targets.copy()
    offset = poses[:, :3, 3] - targets[:, :3, 3]
    turn = Rotation.from_matrix(np.swapaxes(targets[:, :3, :3], 1, 2) @ poses[:, :3, :3]).as_rotvec()
    moved[:, :3, 3] += _shorten(offset, tube.position)
    moved[:, :3, :3] = targets[:, :3, :3] @ Rotation.from_rotvec(_shorten(turn, tube.rotation)).as_matrix()
    return moved


def _shorten(vectors: Array, longest: float | None) -> Array:
    """Vectors (k, 3) shortened to at most `longest`; zeros for None."""
    lengths = np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-300)
    return np.asarray(vectors * np.minimum((longest or 0.0) / lengths, 1.0))
