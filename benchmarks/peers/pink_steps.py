"""Pink's steps: `python pink_steps.py problem.npz result.npz`.

Its manipulability term is cost² |g·Δq - rate|² with g the gradient of Yoshikawa's index and rate per step, not per
second. With damping d it moves the null space by Δq = cost² rate g / d.
"""

import pinocchio as pin
from pink import Configuration, solve_ik
from pink.limits import AccelerationLimit, ConfigurationLimit, VelocityLimit
from pink.tasks import FrameTask, ManipulabilityTask
from steps import GAIN, arm_urdf, run

DAMPING = 1e-6


def make(problem):
    """The step function of a problem."""
    model = pin.buildModelFromXML(arm_urdf(problem))
    assert list(model.names[1:]) == list(problem["active"])
    dt, frame, weight = problem["dt"], problem["frame"], problem["manipulability_cost"]
    configuration = Configuration(model, model.createData(), problem["q0"])
    task = FrameTask(frame, position_cost=1.0, orientation_cost=1.0)
    tasks = [task]
    if weight:
        cost = (weight * GAIN * dt * DAMPING) ** 0.5
        tasks.append(ManipulabilityTask(frame, model, cost=cost, manipulability_rate=1.0))
    acceleration = AccelerationLimit(model, problem["acceleration"])
    limits = [ConfigurationLimit(model), VelocityLimit(model), acceleration]

    def step(q, qd, pose):
        task.set_target(pin.SE3(pose))
        configuration.update(q)
        acceleration.set_last_integration(qd, dt)
        return solve_ik(configuration, tasks, dt, solver="daqp", damping=DAMPING, limits=limits)

    return step


run(make)
