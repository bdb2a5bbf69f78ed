"""Expressions of CasADi are made and freed by one thread at a time: otherwise they end the process."""

import os
import subprocess
import sys
import threading

import casadi as ca
import pytest

from manipplan.support import expressions
from manipplan.support.expressions import making_expressions

#: Threads that make functions of the same constants, and drop them outside the block. Without the block four of five such
#: processes end by a signal.
MANY = """
import sys, threading
import casadi as ca, numpy as np
from manipplan.support.expressions import making_expressions
constants = np.random.default_rng(0).uniform(0.1, 0.9, (30, 4, 4))

@making_expressions()
def made():
    q, product = ca.SX.sym("q", 7), ca.SX.eye(4)
    for k, each in enumerate(constants):
        product = product @ (ca.SX(ca.DM(each)) * q[k % 7])
    return product, ca.Function("product", [q], [product])

def work():
    for _ in range(100):
        made()

threads = [threading.Thread(target=work) for _ in range(4)]
for each in threads:
    each.start()
for each in threads:
    each.join()
"""
#: Jobs of all kinds; prints the lines of the package that made expressions outside the block, as their temporaries were freed.
JOBS = """
import traceback
import casadi as ca, numpy as np
import manipplan as mp
from manipplan.support import expressions

outside, free = set(), ca.SX.__del__

def watched(expression):
    if not expressions._turn.lock._is_owned():
        outside.update(f"{line.filename}:{line.lineno}" for line in traceback.extract_stack()[:-1] if "manipplan" in line.filename)
    free(expression)

ca.SX.__del__ = watched
class Low(mp.Constraint):
    name = "low"
    def rows(self, pose):
        return 5.0 - pose.position[2]

robot, scene = mp.load_robot("ur5"), mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3))])
start, goal = np.array([-0.8, -1.4, 1.6, -1.77, -1.57, 0.0]), np.array([0.8, -1.4, 1.6, -1.77, -1.57, 0.3])
kinematics = robot.kinematics(mp.Task.position(), measure=mp.measures.InverseCondition())
kinematics.hessian(start), kinematics.mass_matrix(start), kinematics.pose(start), mp.measures.InverseCondition()(np.eye(3))
tilt = mp.TiltLimit(axis=[0, 0, 1], direction=[0, 0, -1], angle=3.0)
assert mp.plan(robot, start, goal, scene, constraints=[tilt, Low()], throw=False).path is not None
assert mp.plan(robot, start, [robot.kinematics().pose(goal)], scene).status.has_path
line = mp.CartesianPath.line(robot.kinematics().pose(start), robot.kinematics().pose(start + 0.05))
followed = mp.follow(robot, line, scene, positions=6, samples=40)
assert mp.improve(robot, followed.trajectory, scene, duration=1.0, throw=False) is not None
for formulation in (mp.formulations.Classical(gain=1.0), mp.formulations.LogDrive()):
    mp.track(robot, line, start, formulation, dt=0.01, duration=0.1)
print(*sorted(outside), sep="\\n")
"""


def printed(program):
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout.strip()


@pytest.mark.slow
def test_threads_that_share_constants():
    for _ in range(3):
        printed(MANY)


@pytest.mark.slow
def test_all_jobs_make_their_expressions_in_the_block():
    assert printed(JOBS) == ""


def test_what_another_thread_drops_is_freed_when_the_block_ends():
    expression, others = ca.SX.sym("x") + 0.123, []

    def drop():
        nonlocal expression
        expression = None
        others.append(len(expressions._turn.unused))

    with making_expressions():
        thread = threading.Thread(target=drop)
        thread.start()
        thread.join()
        assert others == [1] == [len(expressions._turn.unused)]
    assert not expressions._turn.unused
    expression = ca.SX.sym("y")
    del expression
    assert not expressions._turn.unused


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_child_makes_its_own_while_a_thread_of_its_parent_does():
    program = """
import os, threading
from manipplan.support.expressions import making_expressions
begun, ended = threading.Event(), threading.Event()

def busy():
    with making_expressions():
        begun.set()
        ended.wait()

thread = threading.Thread(target=busy)
thread.start()
begun.wait()
child = os.fork()
if child == 0:
    with making_expressions():
        os._exit(0)
assert os.waitpid(child, 0)[1] == 0
ended.set()
thread.join()
"""
    subprocess.run([sys.executable, "-W", "ignore", "-c", program], check=True, timeout=60)


@pytest.mark.slow
def test_expressions_that_are_left_when_the_process_ends_say_nothing():
    program = (
        "import sys, casadi as ca, manipplan as mp; sys.left = [ca.SX.sym('x'), mp.planar_arm([1.0, 1.0, 1.0]).kinematics()]"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stderr == ""
