"""mplib's timed motions: `python mplib_paths.py problem.npz result.npz`.

A problem has what `write_description` of world.py writes, and: starts and goals (k, n), scenes (k,), each JSON of the
obstacles (kind, position, quaternion w x y z, size or radius and length), and time_limit [s] of the planner. mplib plans by
RRT-Connect and OMPL's simplification and times the spline through the waypoints by TOPP-RA. It checks the arm's meshes, as
its own example does, and no obstacle against the base. It has no clearance and no jerk limits.

The result has time and cpu (k,) [s] of `Planner.plan_qpos`, said (k,), and by rows of all motions together: row (r,) the
number of the problem, t (r,), q, qd and qdd (r, n), every STEP of the motion and at its end.
"""

import json
import sys
import time

import mplib
import numpy as np
from mplib.collision_detection import fcl

#: The motion is sampled so often [s]; mplib's own default is 0.1.
STEP = 0.002


def read():
    with np.load(sys.argv[1]) as file:
        return {key: value.item() if value.ndim == 0 else value for key, value in file.items()}


def shape(entry):
    """mplib's shape of an obstacle."""
    if entry["kind"] == "box":
        return fcl.Box(entry["size"])
    if entry["kind"] == "cylinder":
        return fcl.Cylinder(entry["radius"], entry["length"])
    return fcl.Sphere(entry["radius"])


def furnish(planner, base, scene):
    """Put the obstacles of a scene in the place of those that are there."""
    for name in planner.planning_world.get_object_names():
        planner.remove_object(name)
    for number, entry in enumerate(scene):
        name, pose = f"obstacle{number}", mplib.Pose(np.array(entry["position"]), np.array(entry["quaternion"]))
        parts = [fcl.CollisionObject(shape(entry), mplib.Pose())]
        planner.planning_world.add_object(fcl.FCLObject(name, pose, parts, [mplib.Pose()]))
        planner.acm.set_entry(base, name, True)


def main():
    problem = read()
    n = len(problem["joints"])
    mplib.set_global_seed(1)
    planner = mplib.Planner(
        problem["urdf"],
        problem["tool"],
        srdf=problem["srdf"],
        joint_vel_limits=problem["velocity"],
        joint_acc_limits=problem["acceleration"],
    )
    names = planner.user_joint_names
    assert [names[k] for k in planner.move_group_joint_indices] == list(problem["joints"])
    assert len(names) == n
    seconds, cpu, said, rows = [], [], [], []
    for number, (start, goal, text) in enumerate(zip(problem["starts"], problem["goals"], problem["scenes"], strict=True)):
        furnish(planner, problem["base"], json.loads(str(text)))
        began, used = time.perf_counter(), time.process_time()
        try:
            found = planner.plan_qpos([goal], start, time_step=STEP, planning_time=float(problem["time_limit"]))
        except RuntimeError as error:  # of the timing
            found = {"status": str(error)}
        cpu.append(time.process_time() - used)
        seconds.append(time.perf_counter() - began)
        said.append(found["status"])
        if found["status"] == "Success":
            parts = [found["time"], found["position"], found["velocity"], found["acceleration"]]
            rows.append(np.column_stack([np.full(len(parts[0]), number), *parts]))
    table = np.concatenate([np.zeros((0, 2 + 3 * n)), *rows])
    motions = {"row": table[:, 0].astype(int), "t": table[:, 1]}
    for k, name in enumerate(("q", "qd", "qdd")):
        motions[name] = table[:, 2 + k * n : 2 + (k + 1) * n]
    np.savez(sys.argv[2], time=seconds, cpu=cpu, said=said, **motions)


if __name__ == "__main__":
    main()
