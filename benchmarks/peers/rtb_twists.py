"""The Robotics Toolbox's NEO on the streams of servo.py: the QP of its example neo.py [Haviland & Corke 2021].

There are no obstacles. Its slack is weighted by the error of a pose, which is here that of the pose one step ahead. It has no
limits of accelerations.
"""

import io

import numpy as np
import qpsolvers
import roboticstoolbox as rtb
from roboticstoolbox.models.URDF.URDFRobot import URDF_file
from twists import DT, bare_urdf, run

#: Of the example: weight of the joint speeds, where a joint limit stops a joint and slows it down [rad], largest slack.
DAMPING, STOP, INFLUENCE, SLACK = 0.01, 0.05, 0.9, 10.0


class Neo:
    def __init__(self, arm, *, climbs):
        links, name, _ = URDF_file(io.StringIO(bare_urdf(arm)))
        self.robot, self.rows, self.climbs = rtb.Robot(links, name=name), arm.rows, climbs
        self.end, self.bound = self.robot.link_dict[arm.tool], np.r_[arm.velocity, np.full(len(arm.rows), SLACK)]
        q = np.linspace(-0.5, 0.7, arm.n)
        assert np.allclose(self.robot.fkine(q, end=self.end).A, arm.pose(q).homogeneous, atol=1e-6)

    def reset(self):
        pass

    def step(self, q, _, twist):
        n, m = len(q), len(self.rows)
        inverse = self.robot.fkine(q, end=self.end).R.T
        v = np.r_[inverse @ twist[:3], inverse @ twist[3:]][self.rows]
        error = max(np.abs(v).sum() * DT, 1e-6)
        Q = np.diag(np.r_[np.full(n, DAMPING), np.full(m, 1 / error)])
        A = np.c_[self.robot.jacobe(q, end=self.end)[self.rows], np.eye(m)]
        G, h = np.zeros((n, n + m)), np.zeros(n)
        G[:, :n], h[:] = self.robot.joint_velocity_damper(q, STOP, INFLUENCE, n)
        c = np.zeros(n + m)
        if self.climbs:
            c[:n] = -self.robot.jacobm(q, end=self.end).ravel()
        x = qpsolvers.solve_qp(Q, c, G, h, A, v, lb=-self.bound, ub=self.bound, solver="quadprog")
        if x is None:
            raise RuntimeError("no solution")
        return x[:n]


run(
    {
        "Robotics Toolbox 1.5, NEO": lambda arm: Neo(arm, climbs=True),
        "Robotics Toolbox 1.5, NEO without manipulability": lambda arm: Neo(arm, climbs=False),
    }
)
