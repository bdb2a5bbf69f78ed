"""RoboPlan's OInK on the streams of servo.py: a frame task towards the pose one step ahead, with all of its limits."""

import numpy as np
from roboplan.core import CartesianConfiguration, Scene, loadUrdfSceneDescriptionFromXml
from roboplan.optimal_ik import (
    AccelerationLimit,
    FrameTask,
    FrameTaskOptions,
    Oink,
    OinkSettings,
    PositionLimit,
    VelocityLimit,
)
from twists import DT, bare_urdf, moved, run


class Roboplan:
    """As it comes, its solver stops at 1e-6 in the units of a step; tuned, at 1e-10, undamped and at the judge's costs."""

    def __init__(self, arm, *, tuned):
        self.arm, self.regularization = arm, 1e-12 if tuned else 1e-6
        self.scene = Scene("arm", loadUrdfSceneDescriptionFromXml(bare_urdf(arm)))
        assert list(self.scene.getJointNames()) == arm.joints
        settings = OinkSettings()
        if tuned:
            settings.eps_abs, settings.eps_rel, settings.max_iter = 1e-10, 0.0, 200
        self.oink = Oink(self.scene, settings)
        target = CartesianConfiguration("", arm.tool, np.asfortranarray(np.eye(4)))
        costs = {"position_cost": 1.0, "orientation_cost": 0.3, "task_gain": 1.0, "lm_damping": 0.0} if tuned else {}
        self.task = FrameTask(self.oink, self.scene, target, FrameTaskOptions(**costs))
        self.acceleration = AccelerationLimit(self.oink, DT, arm.acceleration)
        self.limits = [PositionLimit(self.oink), VelocityLimit(self.oink, DT, arm.velocity), self.acceleration]
        self.delta = np.zeros(self.oink.num_variables)
        self.failed = b""

    def reset(self):
        self.acceleration.reset()

    def step(self, q, qd, twist):
        self.task.setTargetFrameTransform(np.asfortranarray(moved(self.arm.pose(q), twist, DT).homogeneous))
        self.acceleration.setLastVelocity(qd)
        given = np.concatenate([q, qd, twist]).tobytes()
        if given == self.failed:  # an arm that stands: the solver would fail again, after a tenth of a second
            raise RuntimeError("the same problem was not solved in the last step")
        self.failed = given
        self.oink.solveIk(q, [self.task], self.limits, self.delta, self.regularization)
        self.failed = b""
        return self.delta / DT


run(
    {
        "roboplan-oink 0.7, as it comes": lambda arm: Roboplan(arm, tuned=False),
        "roboplan-oink 0.7, tuned": lambda arm: Roboplan(arm, tuned=True),
    }
)
