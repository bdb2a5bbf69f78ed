"""Mink's steps: `python mink_steps.py problem.npz result.npz`. It has no manipulability term."""

import mink
import mujoco
from steps import arm_urdf, run

COMPILER = '<mujoco><compiler fusestatic="false" boundmass="1e-3" boundinertia="1e-3"/></mujoco></robot>'


def make(problem):
    """The step function of a problem."""
    model = mujoco.MjModel.from_xml_string(arm_urdf(problem).replace("</robot>", COMPILER))
    names = [model.joint(i).name for i in range(model.njnt)]
    assert names == list(problem["active"])
    configuration = mink.Configuration(model)
    task = mink.FrameTask(problem["frame"], "body", position_cost=1.0, orientation_cost=1.0)
    limits = [mink.ConfigurationLimit(model), mink.VelocityLimit(model, dict(zip(names, problem["velocity"], strict=True)))]

    def step(q, _, pose):
        task.set_target(mink.SE3.from_matrix(pose))
        configuration.update(q)
        return mink.solve_ik(configuration, [task], problem["dt"], solver="daqp", damping=1e-6, limits=limits)

    return step


run(make)
