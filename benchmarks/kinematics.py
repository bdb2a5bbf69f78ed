"""Kinematics of the Panda by us, by Pinocchio with NumPy, and by CasADi's own means, side by side on one thread.

Run with `make benchmark`. Writes docs/benchmarks/kinematics.md; times are the best of several
repetitions, but for the call that compiles.
"""

import os
import platform
import subprocess
import tempfile
import time
import unittest.mock
from pathlib import Path

import casadi as ca
import numpy as np
import pinocchio as pin
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "kinematics.md"
TASK = mp.Task.pose(length=1.0)
STEP = 1e-4  # of the finite differences, in the range that the paper names


class Pinocchio:
    """The same work as a user of Pinocchio and NumPy writes it."""

    def __init__(self, robot):
        self.model, self.data = robot.model, robot.model.createData()
        self.frame, self.n = robot.model.getFrameId(robot.tool), robot.n

    def jacobian(self, q):
        return pin.computeFrameJacobian(self.model, self.data, q, self.frame, pin.LOCAL_WORLD_ALIGNED)

    def index(self, q):
        jacobian = self.jacobian(q)
        return np.sqrt(np.linalg.det(jacobian @ jacobian.T))

    def step(self, q):
        """J, m and ∇m by (18) in dufour2020, the kinematic Hessian from Pinocchio."""
        pin.computeJointJacobians(self.model, self.data, q)
        pin.computeJointKinematicHessians(self.model, self.data)
        pin.updateFramePlacement(self.model, self.data, self.frame)
        jacobian = pin.getFrameJacobian(self.model, self.data, self.frame, pin.LOCAL_WORLD_ALIGNED)
        hessian = pin.getFrameKinematicHessian(self.model, self.data, self.frame, pin.LOCAL_WORLD_ALIGNED)
        gram = jacobian @ jacobian.T
        m = np.sqrt(np.linalg.det(gram))
        weights = np.linalg.solve(gram, jacobian)
        # its memory holds ∂J_ij/∂q_k column by column, whatever its strides say
        columns = hessian.ravel().reshape((6 * self.n, self.n), order="F")
        return jacobian, m, m * (weights.ravel(order="F") @ columns)

    def differences(self, q):
        """∇m by (17)."""
        moves = STEP * np.eye(self.n)
        return np.array([(self.index(q + move) - self.index(q - move)) / (2 * STEP) for move in moves])

    def second_differences(self, q):
        """The Hessian by (19): 4 n² Jacobians."""
        moves = STEP * np.eye(self.n)
        return np.array([(self.differences(q + move) - self.differences(q - move)) / (2 * STEP) for move in moves])


def best(work, repeat, rounds=7):
    """Seconds a call."""
    least = np.inf
    for _ in range(rounds):
        began = time.perf_counter()
        for _ in range(repeat):
            work()
        least = min(least, (time.perf_counter() - began) / repeat)
    return least


def compiled(function):
    """A CasADi Function as machine code, in the way that CasADi's users take."""
    with tempfile.TemporaryDirectory() as folder:
        source, library = Path(folder) / f"{function.name()}.c", Path(folder) / f"{function.name()}.so"
        generator = ca.CodeGenerator(source.name)
        generator.add(function)
        generator.generate(f"{folder}/")
        subprocess.run(["cc", "-O3", "-march=native", "-fPIC", "-shared", source, "-o", library, "-lm"], check=True)
        return ca.external(function.name(), str(library))


def one_configuration(robot, peer, q):
    steps = {c: robot.kinematics(TASK, compiled=c).evaluator("jacobian", "manipulability", "gradient") for c in (True, False)}
    hessians = {c: robot.kinematics(TASK, compiled=c).evaluator("hessian") for c in (True, False)}
    for ours, theirs in zip(steps[True](q), peer.step(q), strict=True):
        np.testing.assert_allclose(ours, theirs, atol=1e-10)
    np.testing.assert_allclose(hessians[True](q)[0], peer.second_differences(q), atol=1e-5)
    peer_step, peer_hessian = best(lambda: peer.step(q), 2000), best(lambda: peer.second_differences(q), 20)
    rows = [("J, m, ∇m of one q: Pinocchio and NumPy, by (18)", peer_step, None, "")]
    rows += [
        ("the same, finite differences (17) for ∇m", best(lambda: (peer.index(q), peer.differences(q)), 200), peer_step, "")
    ]
    rows += [("the same, ours in CasADi's virtual machine", best(lambda: steps[False](q), 5000), peer_step, "3")]
    rows += [("the same, ours compiled", best(lambda: steps[True](q), 20000), peer_step, "10")]
    rows += [("Hessian of one q: the paper's (19), Pinocchio and NumPy", peer_hessian, None, "")]
    rows += [("the same, exact, ours in CasADi's virtual machine", best(lambda: hessians[False](q), 500), peer_hessian, "")]
    rows += [("the same, exact, ours compiled", best(lambda: hessians[True](q), 5000), peer_hessian, "250")]
    return rows


def many_configurations(robot, peer, count=1_000_000, sample=20_000):
    """Index of many q; returns the rows and the largest relative error against Pinocchio and singular values."""
    q = robot.random_configuration(np.random.default_rng(1), size=count)
    ours = robot.kinematics(TASK, compiled=True, threads=1)
    both = robot.kinematics(TASK, compiled=True)
    values = ours.manipulability(q)
    oracle = np.array([np.prod(np.linalg.svd(peer.jacobian(each), compute_uv=False)) for each in track(q, "oracle")])
    error = np.abs(values / oracle - 1).max()

    def by_casadi(function):
        mapped = compiled(ca.Function("mapped", [each := ca.SX.sym("q", 7)], [function(each)]).map(sample))
        buffer, run = mapped.buffer()
        source, target = np.ascontiguousarray(q[:sample]).reshape(-1), np.empty(sample)
        buffer.set_arg(0, source.data)
        buffer.set_res(0, target.data)
        seconds = best(run, 1) / sample
        np.testing.assert_allclose(target, values[:sample], rtol=1e-6, atol=1e-12)
        return seconds

    jacobian = ours.symbolic.jacobian
    symbol = ca.SX.sym("q", 7)
    plain = jacobian(symbol)
    usual = ca.Function("usual", [symbol], [ca.sqrt(ca.det(plain @ plain.T))])
    casadi_usual, casadi_ours = by_casadi(usual), by_casadi(ours.symbolic.manipulability)
    loop = best(lambda: [peer.index(each) for each in q[:2000]], 1) / 2000
    single, threads = best(lambda: ours.manipulability(q), 1) / count, best(lambda: both.manipulability(q), 1) / count
    gradient = best(lambda: ours.gradient(q), 1, 3) / count
    rows = [("index of many q: a loop of Pinocchio and NumPy", loop, None, "")]
    rows += [("CasADi's compiled map of sqrt(det(J Jᵀ))", casadi_usual, loop, "")]
    rows += [("CasADi's compiled map of our expression of the index", casadi_ours, loop, "")]
    rows += [("ours, 10⁶ q, one thread", single, loop, "200")]
    rows += [(f"ours, 10⁶ q, {both.threads} threads", threads, loop, "")]
    rows += [("gradient of 10⁶ q, ours, one thread", gradient, None, "")]
    return rows, error, casadi_usual / single, casadi_ours / single


def first_call():
    """Seconds from a loaded robot to its first index, nothing built before, without a compiler."""
    robot = mp.load_robot("panda")
    began = time.perf_counter()
    robot.kinematics(TASK, compiled=False).evaluator("jacobian", "manipulability", "gradient")(robot.neutral)
    return time.perf_counter() - began


def main() -> None:
    robot = mp.load_robot("panda")
    peer = Pinocchio(robot)
    first = min(first_call() for _ in range(3))
    with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(os.environ, MANIPPLAN_CACHE=folder):
        began = time.perf_counter()
        robot.kinematics(TASK, compiled=True).evaluator("jacobian", "manipulability", "gradient")
        compile_time = time.perf_counter() - began
        rows = one_configuration(robot, peer, robot.neutral)
        many, error, over_usual, over_ours = many_configurations(robot, peer)
    lines = ["| work | time | faster | wanted |", "|---|---|---|---|"]
    for what, seconds, reference, wanted in rows + many:
        shown = f"{seconds * 1e6:.2f} µs" if seconds > 1e-7 else f"{seconds * 1e9:.1f} ns"
        lines.append(
            f"| {what} | {shown} | {f'{reference / seconds:.1f} x' if reference else ''} | {wanted and wanted + ' x'} |"
        )
    lines += [
        "",
        "| figure | value | wanted |",
        "|---|---|---|",
        f"| 10⁶ q: faster than CasADi's compiled map of sqrt(det(J Jᵀ)) | {over_usual:.1f} x | 20 x |",
        f"| 10⁶ q: faster than CasADi's compiled map of our own expression | {over_ours:.1f} x | |",
        f"| 10⁶ q: largest relative error against Pinocchio and an SVD | {error:.1e} | 1e-10 |",
        f"| first call for a new robot without the compiler | {first:.3f} s | 0.3 s |",
        f"| first call for a new robot with the compiler | {compile_time:.2f} s | |",
        "",
        f"Panda, six rows; Python {platform.python_version()}, {platform.machine()}; command: `make benchmark`.",
    ]
    OUT.parent.mkdir(parents=True, exist_ok=True)
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
