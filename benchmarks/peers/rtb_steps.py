"""The Robotics Toolbox's NEO steps: `python rtb_steps.py problem.npz result.npz`.

The QP of its example neo.py [Haviland & Corke 2021] without obstacles. Its manipulability term is -g·qd with g the
gradient of Yoshikawa's index, beside λ/2 |qd|²: it moves the null space by qd = g / λ, λ = 0.01 in the example.
"""

import io

import numpy as np
import qpsolvers
import roboticstoolbox as rtb
from roboticstoolbox.models.URDF.URDFRobot import URDF_file
from steps import GAIN, arm_urdf, run

DAMPING = 1 / GAIN
STOP, INFLUENCE = 0.05, 0.9  # rad from a joint limit: where to stop, where to slow down


def make(problem):
    """The step function of a problem."""
    links, name, _ = URDF_file(io.StringIO(arm_urdf(problem)))
    robot = rtb.Robot(links, name=name)
    end, n = robot.link_dict[problem["frame"]], robot.n
    assert n == len(problem["active"])
    bound = np.r_[problem["velocity"], 10 * np.ones(6)]

    def step(q, _, pose):
        T = robot.fkine(q, end=end).A
        v, _ = rtb.p_servo(T, pose, 1 / problem["dt"])
        error = max(np.sum(np.abs(v)) * problem["dt"], 1e-6)
        Q = np.diag(np.r_[np.full(n, DAMPING), np.full(6, 1 / error)])
        A = np.c_[robot.jacobe(q, end=end), np.eye(6)]
        G, h = np.zeros((n, n + 6)), np.zeros(n)
        G[:, :n], h[:] = robot.joint_velocity_damper(q, STOP, INFLUENCE, n)
        c = np.zeros(n + 6)
        if problem["manipulability_cost"]:
            c[:n] = -problem["manipulability_cost"] * robot.jacobm(q, end=end).ravel()
        x = qpsolvers.solve_qp(Q, c, G, h, A, v, lb=-bound, ub=bound, solver="quadprog")
        if x is None:
            raise RuntimeError("no solution")
        return x[:n]

    return step


run(make)
