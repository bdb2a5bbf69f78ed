"""Ruckig's motions from rest to rest between waypoints: `python ruckig_motions.py problem.npz result.npz`.

A problem has: waypoints (k, n), velocity, acceleration, jerk (n,), straight (whether all joints move in phase, so that each
piece is a straight line), rounds, and samples per piece. Ruckig's own mode for waypoints asks a server and is not used.
"""

import sys
import time

import numpy as np
from ruckig import InputParameter, Result, Ruckig, Synchronization, Trajectory


def main():
    with np.load(sys.argv[1]) as file:
        problem = {key: value.item() if value.ndim == 0 else value for key, value in file.items()}
    n = problem["waypoints"].shape[1]
    given = InputParameter(n)
    given.max_velocity, given.max_acceleration, given.max_jerk = (
        problem[kind].tolist() for kind in ("velocity", "acceleration", "jerk")
    )
    if problem["straight"]:
        given.synchronization = Synchronization.Phase
    generator = Ruckig(n)

    def motions():
        found = []
        for a, b in zip(problem["waypoints"], problem["waypoints"][1:], strict=False):
            given.current_position, given.target_position = a.tolist(), b.tolist()
            motion = Trajectory(n)
            if generator.calculate(given, motion) not in (Result.Working, Result.Finished):
                raise RuntimeError("Ruckig found no motion")
            found.append(motion)
        return found

    seconds = []
    for _ in range(problem["rounds"]):
        began = time.process_time()
        made = motions()
        seconds.append(time.process_time() - began)
    samples = [each.at_time(t)[0] for each in made for t in np.linspace(0, each.duration, problem["samples"])]
    np.savez(sys.argv[2], seconds=seconds, duration=sum(each.duration for each in made), q=samples)


main()
