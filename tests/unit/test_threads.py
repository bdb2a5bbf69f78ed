"""Threads may share a robot and a scene: each has its own models, and finds what it finds alone."""

import subprocess
import sys

import pytest

PROGRAM = """
from concurrent.futures import ThreadPoolExecutor
import numpy as np, manipplan as mp

{robot}
patient = mp.Seeding(time_limit=600.0)

def planned(k):
    turn = 0.02 * k
    start, goal = np.add(start_at, turn), np.subtract(goal_at, turn)
    plan = mp.plan(robot, start, goal, scene, seeding=patient)
    line = mp.CartesianPath.line(robot.kinematics().pose(start), robot.kinematics().pose(start + 0.05))
    along = mp.follow(robot, line, scene, positions=6, samples=40).path
    report = mp.check(robot, plan.trajectory, scene)
    random = robot.random_configuration(np.random.default_rng(k))
    return plan.path(0.5).tolist(), along(0.5).tolist(), report.clearance, scene.distances(robot, random).tolist()

with ThreadPoolExecutor(4) as pool:
    together = list(pool.map(planned, range(8)))
assert together == [planned(k) for k in range(8)], together
"""
PLANAR = """
robot = mp.planar_arm([1.0, 1.0, 1.0])
scene = mp.Scene([mp.Cylinder(radius=0.2, length=1.0, position=(1.0, 1.0, 0.0))])
start_at, goal_at = [0.0, -1.1, -1.6], [1.57, 0.5, 1.5]
"""
UR5 = """
robot = mp.load_robot("ur5")
scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3))])
start_at, goal_at = [-0.8, -1.4, 1.6, -1.77, -1.57, 0.0], [0.8, -1.4, 1.6, -1.77, -1.57, 0.3]
"""


@pytest.mark.slow
@pytest.mark.parametrize("robot", [PLANAR, UR5], ids=["planar", "ur5"])
def test_threads_that_share_a_robot_and_a_scene(robot):
    """F2 of reviews/trust.md. A fault would kill the process."""
    run = subprocess.run([sys.executable, "-c", PROGRAM.format(robot=robot)], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr[-3000:]
