"""Pink on the streams of servo.py: a frame task towards the pose one step ahead."""

import pinocchio as pin
from pink import Configuration, solve_ik
from pink.limits import AccelerationLimit, ConfigurationLimit, VelocityLimit
from pink.tasks import FrameTask
from twists import DT, bare_urdf, moved, run


class Pink:
    """As its README has it: equal costs, limits of positions and velocities. Tuned: the judge's costs, accelerations too."""

    def __init__(self, arm, *, tuned):
        self.model, self.tuned, self.tool = pin.buildModelFromXML(bare_urdf(arm)), tuned, arm.tool
        assert list(self.model.names[1:]) == arm.joints
        self.configuration = Configuration(self.model, self.model.createData(), pin.neutral(self.model))
        self.task = FrameTask(arm.tool, position_cost=1.0, orientation_cost=0.3 if tuned else 1.0)
        self.acceleration = AccelerationLimit(self.model, arm.acceleration)
        self.limits = [ConfigurationLimit(self.model), VelocityLimit(self.model)]
        self.options = {"damping": 1e-9, "safety_break": False} if tuned else {"safety_break": False}
        if tuned:
            self.limits.append(self.acceleration)

    def reset(self):
        pass

    def step(self, q, qd, twist):
        self.configuration.update(q)
        self.task.set_target(moved(self.configuration.get_transform_frame_to_world(self.tool), twist, DT))
        self.acceleration.set_last_integration(qd, DT)
        return solve_ik(self.configuration, [self.task], DT, solver="daqp", limits=self.limits, **self.options)


run({"pink 4.4, as it comes": lambda arm: Pink(arm, tuned=False), "pink 4.4, tuned": lambda arm: Pink(arm, tuned=True)})
