"""EmbodiK on the streams of servo.py: a frame task with a velocity, and all of its limits."""

import embodik
import numpy as np
from twists import DT, bare_file, run


class Embodik:
    def __init__(self, arm, *, mode=None):
        self.solver = embodik.KinematicsSolver(embodik.RobotModel(bare_file(arm)))
        self.solver.dt = DT
        self.solver.enable_position_limits(True)
        self.solver.enable_velocity_limits(True)
        for i, speed in enumerate(arm.velocity):
            self.solver.set_joint_velocity_limit(i, float(speed))
        self.solver.set_acceleration_limits(arm.acceleration)
        self.solver.enable_acceleration_limits(True)
        self.task = self.solver.add_frame_task("tool", arm.tool, embodik.TaskType.FRAME_POSE)
        if mode is not None:
            self.task.solve_mode = mode

    def reset(self):
        pass

    def step(self, q, qd, twist):
        self.solver.set_previous_joint_velocities(qd)
        self.task.set_target_velocity(twist)
        return np.array(self.solver.solve_velocity(q, True).joint_velocities)


run(
    {
        "EmbodiK 0.23, as it comes": Embodik,
        "EmbodiK 0.23, minimum error": lambda arm: Embodik(arm, mode=embodik.TaskSolveMode.MIN_ERROR),
    }
)
