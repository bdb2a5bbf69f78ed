"""RoboPlan's OInK steps: `python roboplan_steps.py problem.npz result.npz`. It has no manipulability term."""

import numpy as np
from roboplan.core import CartesianConfiguration, Scene, loadUrdfSceneDescriptionFromXml
from roboplan.optimal_ik import AccelerationLimit, FrameTask, Oink, PositionLimit, VelocityLimit
from steps import arm_urdf, run


def make(problem):
    """The step function of a problem."""
    dt = problem["dt"]
    scene = Scene("arm", loadUrdfSceneDescriptionFromXml(arm_urdf(problem)))
    assert list(scene.getJointNames()) == list(problem["active"])
    oink = Oink(scene)
    task = FrameTask(oink, scene, CartesianConfiguration("", problem["frame"], problem["poses"][0]))
    acceleration = AccelerationLimit(oink, dt, problem["acceleration"])
    limits = [PositionLimit(oink), VelocityLimit(oink, dt, problem["velocity"]), acceleration]
    delta = np.zeros(oink.num_variables)

    def step(q, qd, pose):
        task.setTargetFrameTransform(pose)
        acceleration.setLastVelocity(qd)
        oink.solveIk(q, [task], limits, delta, 1e-6)
        return delta / dt

    return step


run(make)
