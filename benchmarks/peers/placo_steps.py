"""PlaCo's steps: `python placo_steps.py problem.npz result.npz`.

Its manipulability term is weight |λ Δq - g / 2λ|² with g the gradient of Yoshikawa's index: whatever its weight, it
moves the null space by Δq = g / 2λ².
"""

import placo
from steps import GAIN, arm_urdf, run

REGULARIZATION = 1e-6


def make(problem):
    """The step function of a problem."""
    dt, frame, weight = problem["dt"], problem["frame"], problem["manipulability_cost"]
    robot = placo.RobotWrapper("", placo.Flags.ignore_collisions, arm_urdf(problem))
    assert list(robot.joint_names()) == list(problem["active"])
    solver = placo.KinematicsSolver(robot)
    solver.mask_fbase(True)
    solver.dt = dt
    solver.enable_joint_limits(True)
    solver.enable_velocity_limits(True)
    task = solver.add_frame_task(frame, problem["poses"][0])
    task.configure("tool", "soft", 1.0, 1.0)
    if weight:
        scale = (2 * weight * GAIN * dt) ** -0.5
        term = solver.add_manipulability_task(frame, "both", scale)
        term.configure("manipulability", "soft", REGULARIZATION / scale**2)
    else:
        solver.add_regularization_task(REGULARIZATION)

    def step(q, _, pose):
        task.T_world_frame = pose
        robot.state.q[7:] = q
        robot.update_kinematics()
        return solver.solve(False)[6:] / dt

    return step


run(make)
