"""drake's KinematicTrajectoryOptimization with an index cost: `python drake_paths.py problem.npz result.npz`.

A problem has what world.py writes, and: seeds (k, m, n), the first paths at even s; control_points, samples and checks,
numbers; clearance [m]; time_limit [s]; cost, "g" or "sum". The cost is a sum over `samples` places of ‖q'‖ / m ("g", what
the paths are judged by), or of ‖q'‖² + 1 / m with drake's own path-energy cost ("sum", what comes to mind first), with m
Yoshikawa's index of drake's Jacobian and its gradient by central differences. The clearance is demanded at `checks` places.

The result has knots, control (k, control_points, n) of cubic B-splines, time and cpu (k,) [s] and said (k,).
"""

import sys
import time

import numpy as np
from pydrake.all import (
    AddMultibodyPlantSceneGraph,
    BsplineTrajectory,
    CollisionFilterDeclaration,
    DiagramBuilder,
    ExtractGradient,
    ExtractValue,
    GeometrySet,
    InitializeAutoDiff,
    JacobianWrtVariable,
    KinematicTrajectoryOptimization,
    MinimumDistanceLowerBoundConstraint,
    Parser,
    SnoptSolver,
    SolverOptions,
)

STEP = 1e-6
#: Pairs nearer than the clearance and this [m] enter drake's distance constraint.
INFLUENCE = 0.02


def read():
    with np.load(sys.argv[1]) as file:
        return {key: value.item() if value.ndim == 0 else value for key, value in file.items()}


class Arm:
    """The plant, its index, and the constraint on the distances of the checked pairs."""

    def __init__(self, problem):
        builder = DiagramBuilder()
        self.plant, graph = AddMultibodyPlantSceneGraph(builder, 0.0)
        Parser(self.plant).AddModels(problem["urdf"])
        self.plant.WeldFrames(self.plant.world_frame(), self.plant.GetFrameByName("base"))
        self.plant.Finalize()
        geometry = {}
        for link in {name for pair in problem["pairs"] for name in pair}:
            (geometry[link],) = self.plant.GetCollisionGeometriesForBody(self.plant.GetBodyByName(link))
        checked = {frozenset(pair) for pair in problem["pairs"].tolist()}
        names = sorted(geometry)
        declaration = CollisionFilterDeclaration()
        for j, second in enumerate(names):
            for first in names[:j]:
                sets = GeometrySet(geometry[first]), GeometrySet(geometry[second])
                if frozenset((first, second)) in checked:
                    declaration.AllowBetween(*sets)
                else:
                    declaration.ExcludeBetween(*sets)
        graph.collision_filter_manager().Apply(declaration)
        self.diagram = builder.Build()
        self.root = self.diagram.CreateDefaultContext()
        self.context = self.plant.GetMyMutableContextFromRoot(self.root)
        self.tool, self.world = self.plant.GetFrameByName("tool"), self.plant.world_frame()
        self.n = self.plant.num_positions()
        self.weights = np.r_[np.full(3, problem["angular"]), np.ones(3)][:, None]  # drake puts angular rows first
        order = [self.plant.GetJointByName(name).position_start() for name in problem["joints"]]
        assert order == list(range(self.n))

    def index(self, q):
        self.plant.SetPositions(self.context, q)
        J = self.weights * self.plant.CalcJacobianSpatialVelocity(
            self.context, JacobianWrtVariable.kQDot, self.tool, np.zeros(3), self.world, self.world
        )
        return np.sqrt(max(np.linalg.det(J @ J.T), 0.0))

    def manipulability_gradient(self, q):
        steps = STEP * np.eye(self.n)
        return np.array([self.index(q + step) - self.index(q - step) for step in steps]) / (2 * STEP)


def index_cost(arm, basis, problem):
    """The cost as a function of the control points, with its gradient when drake asks for one."""
    count, n = basis.num_basis_functions(), arm.n
    nodes, weights = np.polynomial.legendre.leggauss(problem["samples"])
    s, weights = (nodes + 1) / 2, weights / 2
    # rows of basis values and slopes, from drake's own curve of unit control points
    units = [BsplineTrajectory(basis, [np.eye(count)[i : i + 1].T for i in range(count)])]
    values = np.array([units[0].value(each)[:, 0] for each in s])
    slopes = np.array([units[0].EvalDerivative(each, 1)[:, 0] for each in s])

    def evaluate(control, gradient):
        q, v = values @ control, slopes @ control
        speed = np.sqrt((v**2).sum(axis=1) + 1e-12)
        m = np.maximum([arm.index(each) for each in q], 1e-9)
        along = speed if problem["cost"] == "g" else np.ones(len(s))
        total = float(weights @ (along / m))
        if not gradient:
            return total, None
        dm = np.array([arm.manipulability_gradient(each) for each in q])
        d = values.T @ (-(weights * along / m**2)[:, None] * dm)
        if problem["cost"] == "g":
            d += slopes.T @ ((weights / m / speed)[:, None] * v)
        return total, d

    def cost(x):
        if x.dtype == float:
            return evaluate(x.reshape(n, count).T, False)[0]
        total, d = evaluate(ExtractValue(x).reshape(n, count).T, True)
        return InitializeAutoDiffWith(total, d.T.reshape(1, -1) @ ExtractGradient(x))

    return cost


def InitializeAutoDiffWith(value, gradient):  # noqa: N802  # named as drake's own
    return InitializeAutoDiff(np.array([[value]]), gradient)[0, 0]


def solve(arm, problem, seed):
    count, n = int(problem["control_points"]), arm.n
    trajopt = KinematicTrajectoryOptimization(n, count, spline_order=4, duration=1.0)
    prog = trajopt.get_mutable_prog()
    trajopt.AddDurationConstraint(1.0, 1.0)
    trajopt.AddPositionBounds(problem["lower"], problem["upper"])
    trajopt.AddPathPositionConstraint(seed[0], seed[0], 0)
    trajopt.AddPathPositionConstraint(seed[-1], seed[-1], 1)
    constraint = MinimumDistanceLowerBoundConstraint(arm.plant, problem["clearance"], arm.context, None, INFLUENCE)
    for s in np.linspace(0, 1, int(problem["checks"]) + 2)[1:-1]:
        trajopt.AddPathPositionConstraint(constraint, s)
    basis = trajopt.basis()
    if problem["cost"] == "sum":
        trajopt.AddPathEnergyCost(1.0)
    prog.AddCost(index_cost(arm, basis, problem), vars=trajopt.control_points().ravel())
    # the seed's least-squares fit with its ends kept
    units = BsplineTrajectory(basis, [np.eye(count)[i : i + 1].T for i in range(count)])
    rows = np.array([units.value(s)[:, 0] for s in np.linspace(0, 1, len(seed))])
    ends = np.outer(rows[:, 0], seed[0]) + np.outer(rows[:, -1], seed[-1])
    inner = np.linalg.lstsq(rows[:, 1:-1], seed - ends, rcond=None)[0]
    first = np.clip(np.vstack([seed[:1], inner, seed[-1:]]), problem["lower"], problem["upper"])
    trajopt.SetInitialGuess(BsplineTrajectory(basis, [each[:, None] for each in first]))
    options = SolverOptions()
    options.SetOption(SnoptSolver.id(), "Time limit", problem["time_limit"])
    options.SetOption(SnoptSolver.id(), "Major optimality tolerance", 1e-5)
    result = SnoptSolver().Solve(prog, None, options)
    curve = trajopt.ReconstructTrajectory(result)
    said = f"{result.get_solution_result().name} {result.get_solver_details().info}"
    return np.array(basis.knots()), np.array(curve.control_points())[:, :, 0], said


def main():
    problem = read()
    arm = Arm(problem)
    solve(arm, problem | {"time_limit": 0.5}, problem["seeds"][0])
    knots, control, seconds, cpu, said = [], [], [], [], []
    for seed in problem["seeds"]:
        began, used = time.perf_counter(), time.process_time()
        found = solve(arm, problem, seed)
        seconds.append(time.perf_counter() - began)
        cpu.append(time.process_time() - used)
        for place, value in zip((knots, control, said), found, strict=True):
            place.append(value)
    np.savez(sys.argv[2], knots=knots[0], control=control, time=seconds, cpu=cpu, said=said)


if __name__ == "__main__":
    main()
