"""ssik's inverse kinematics of an arm it has prebuilt: `python ssik_solutions.py problem.npz result.npz`.

A problem has: arm (a prebuilt name), count of random configurations inside ssik's own limits. An unknown name tells the names.
"""

import sys
import time

import numpy as np
import ssik


def main():
    with np.load(sys.argv[1]) as file:
        problem = {key: value.item() if value.ndim == 0 else value for key, value in file.items()}
    names = [each.name for each in ssik.list_arms()]
    if problem["arm"] not in names:
        np.savez(sys.argv[2], names=names)
        return
    arm = ssik.Manipulator.from_prebuilt(problem["arm"])
    lower, upper = np.array(arm.joint_limits).T
    q = np.random.default_rng(0).uniform(lower, upper, (problem["count"], len(lower)))
    poses = [arm.fk(each) for each in q]
    arm.solve(poses[0])
    began = time.perf_counter()
    answers = [arm.solve(pose) for pose in poses]
    seconds = time.perf_counter() - began
    worst, hits = [], 0
    for each, pose, true in zip(answers, poses, q, strict=True):
        worst += [np.abs(arm.fk(one.q) - pose).max() for one in each]
        hits += any(np.abs(one.q - true).max() < 1e-6 for one in each)
    np.savez(sys.argv[2], seconds=seconds, residual=worst, hits=hits, names=names)


main()
