"""What every peer's script shares: the arm's URDF, and the timed loop over the targets.

A problem has: urdf (path), frame (tool frame), active (names of the n joints from base to tool), locked (names),
locked_q, q0 (n,), dt, poses (N, 4, 4) with poses[k] the tool's pose after step k, velocity, acceleration, lower,
upper (n,), and manipulability_cost: 0 switches the peer's manipulability term off, 1 is its tuned weight. Tuned, each
moves the null space by GAIN g, g the gradient of Yoshikawa's index: what the toolbox's NEO example has.
"""

import sys
import time
from collections.abc import Callable
from xml.etree import ElementTree

import numpy as np

WARM_UP = 20
GAIN = 100.0  # 1/s


def numbers(values) -> str:
    """Values as URDF writes them."""
    return " ".join(repr(float(x)) for x in values)


def rotation(axis, angle: float) -> np.ndarray:
    """Rotation matrix about a unit axis."""
    K = np.cross(np.eye(3), axis)
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def fix(joint, q: float) -> None:
    """Makes a joint of the URDF fixed at q."""
    origin, axis = joint.find("origin"), joint.find("axis")
    origin = ElementTree.SubElement(joint, "origin") if origin is None else origin
    xyz, rpy = (np.array(origin.get(key, "0 0 0").split(), float) for key in ("xyz", "rpy"))
    a = np.array([1.0, 0, 0] if axis is None else axis.get("xyz").split(), float)
    x, y, z = np.eye(3)
    R = rotation(z, rpy[2]) @ rotation(y, rpy[1]) @ rotation(x, rpy[0])
    if joint.get("type") == "prismatic":
        xyz = xyz + R @ a * q
    else:
        R = R @ rotation(a, q)
    rpy = np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], np.hypot(R[2, 1], R[2, 2])), np.arctan2(R[1, 0], R[0, 0])
    origin.set("xyz", numbers(xyz))
    origin.set("rpy", numbers(rpy))
    joint.set("type", "fixed")
    for part in joint.findall("mimic") + joint.findall("limit"):
        joint.remove(part)


def arm_urdf(problem: dict) -> str:
    """The problem's URDF with its locked joints fixed, its limits, and no meshes."""
    robot = ElementTree.parse(problem["urdf"]).getroot()
    for link in robot.findall("link"):
        for part in link.findall("visual") + link.findall("collision"):
            link.remove(part)
    active, locked = list(problem["active"]), dict(zip(problem["locked"], problem["locked_q"], strict=True))
    for joint in robot.findall("joint"):
        name = joint.get("name")
        if name in locked:
            fix(joint, locked[name])
        elif name in active:
            i, limit = active.index(name), joint.find("limit")
            for key in ("lower", "upper", "velocity"):
                limit.set(key, numbers([problem[key][i]]))
    return ElementTree.tostring(robot, encoding="unicode")


def run(make: Callable) -> None:
    """Runs the step function that `make` returns for the problem, and writes what it did.

    A step takes q, the last qd and the target, and returns qd; where it raises, q is held and the first error kept.
    """
    with np.load(sys.argv[1]) as file:
        problem = {key: value.item() if value.ndim == 0 else value for key, value in file.items()}
    step, dt, N = make(problem), problem["dt"], len(problem["poses"])
    q_all, qd_all = np.zeros((2, N, len(problem["q0"])))
    seconds, failed = np.zeros(N), np.zeros(N, bool)
    for count in (min(WARM_UP, N), N):
        q, qd, first = problem["q0"], np.zeros(len(problem["q0"])), ""
        for k in range(count):
            said = ""
            start = time.perf_counter()
            try:
                qd = step(q, qd, problem["poses"][k])
            except Exception as error:
                qd, said = np.zeros_like(q), f"step {k}: {type(error).__name__}: {error}"
            seconds[k] = time.perf_counter() - start
            q = q + qd * dt
            q_all[k], qd_all[k], failed[k] = q, qd, bool(said)
            first = first or said
    np.savez(sys.argv[2], q=q_all, qd=qd_all, time=seconds, failed=failed, error=first)
