"""EAIK's inverse kinematics: `python eaik_solutions.py problem.npz result.npz`.

A problem has: axes, points (n, 3) of the joints at zero, home (4, 4) the tool's pose there, poses (N, 4, 4), held: the index
of a joint that is locked, or -1, value: at which it is locked for all poses, values (M,): for the first M poses one by one,
grid (G,): for the first pose. With no poses it only tells which arms it takes: locked (K, n) are sets of joints to lock.
"""

import sys
import time

import numpy as np
from eaik.IK_HP import HPRobot

REPEATS = 5


def make(problem, locked):
    """A robot with joints locked at values."""
    points, home = problem["points"], problem["home"]
    offsets = np.vstack([points[:1], np.diff(points, axis=0), home[None, :3, 3] - points[-1:]])
    return HPRobot(problem["axes"], offsets, locked)


def rows(answers, n):
    """All rows (k, n) and which answer each is of."""
    found = [np.asarray(each.Q).reshape(-1, n) for each in answers]
    return np.concatenate(found), np.repeat(np.arange(len(found)), [len(each) for each in found])


def known(problem):
    """Whether EAIK knows the arm with one of the sets of joints locked."""
    for locked in problem["locked"]:
        try:
            if make(problem, [(int(k), 0.3) for k in np.flatnonzero(locked)]).hasKnownDecomposition():
                return True
        except RuntimeError:
            continue
    return False


def main():
    with np.load(sys.argv[1]) as file:
        problem = {key: value.item() if value.ndim == 0 else value for key, value in file.items()}
    if "poses" not in problem:
        np.savez(sys.argv[2], known=known(problem))
        return
    n, held = len(problem["axes"]), problem["held"]
    poses = problem["poses"].copy()
    poses[:, :3, :3] = poses[:, :3, :3] @ problem["home"][:3, :3].T  # its tool is turned as the base at zero

    def locked_at(value):
        return make(problem, [] if held < 0 else [(held, float(value))])

    robot = locked_at(problem["value"])
    if not robot.hasKnownDecomposition():
        np.savez(sys.argv[2], known=False)
        return
    batch, alone, grid = [], [], []
    for _ in range(REPEATS):
        began = time.perf_counter()
        answers = robot.IK_batched(poses, 1)
        batch.append(time.perf_counter() - began)
        began = time.perf_counter()
        own = [locked_at(value).IK(pose) for pose, value in zip(poses, problem["values"], strict=False)]
        alone.append(time.perf_counter() - began)
        began = time.perf_counter()
        swept = [locked_at(value).IK(poses[0]) for value in problem["grid"]]
        grid.append(time.perf_counter() - began)
    result = {"known": True, "batch": min(batch), "alone": min(alone), "grid": min(grid), "family": robot.getKinematicFamily()}
    for name, each in (("batch", answers), ("alone", own), ("grid", swept)):
        result[f"{name}_q"], result[f"{name}_source"] = rows(each, n)
    np.savez(sys.argv[2], **result)


main()
