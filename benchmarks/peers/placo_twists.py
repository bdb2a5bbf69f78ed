"""PlaCo on the streams of servo.py: a frame task towards the pose one step ahead. It has no limits of accelerations."""

import pinocchio as pin
import placo
from twists import DT, bare_urdf, moved, run


class Placo:
    def __init__(self, arm, *, orientation, regularization):
        self.arm = arm
        self.robot = placo.RobotWrapper("", placo.Flags.ignore_collisions, bare_urdf(arm))
        assert list(self.robot.joint_names()) == arm.joints
        self.solver = placo.KinematicsSolver(self.robot)
        self.solver.mask_fbase(True)
        self.solver.dt = DT
        self.solver.enable_joint_limits(True)
        self.solver.enable_velocity_limits(True)
        self.robot.update_kinematics()
        self.task = self.solver.add_frame_task(arm.tool, self.robot.get_T_world_frame(arm.tool))
        self.task.configure("tool", "soft", 1.0, orientation)
        self.solver.add_regularization_task(regularization)

    def reset(self):
        pass

    def step(self, q, _, twist):
        self.robot.state.q[7:] = q
        self.robot.update_kinematics()
        pose = pin.SE3(self.robot.get_T_world_frame(self.arm.tool))
        self.task.T_world_frame = moved(pose, twist, DT).homogeneous
        return self.solver.solve(False)[6:] / DT


run(
    {
        "placo 0.10, as it comes": lambda arm: Placo(arm, orientation=1.0, regularization=1e-4),
        "placo 0.10, less regularization": lambda arm: Placo(arm, orientation=0.3, regularization=1e-5),
    }
)
