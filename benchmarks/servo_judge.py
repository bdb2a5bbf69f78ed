"""The judge of servo.py, written with NumPy, Pinocchio and DAQP alone, from the arm's own URDF file.

An ideal drive executes commands: it clips each joint's to the velocities from which the joint can still stop inside its limits,
by braking in discrete time. Limits are those of the file; accelerations, which URDF does not have, are given.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

Array = NDArray[np.float64]
Twist = Callable[[float], Array]
#: Time step [s]; metres per radian in speeds of the tool.
DT, LENGTH = 0.002, 0.3
SCALE = np.array([1.0, 1.0, 1.0, LENGTH, LENGTH, LENGTH])
#: A smallest singular value that counts as near a singularity [m], and the time around it that does as well [s].
NEAR, AROUND = 0.05, 1.0
#: Motion across the command that the bound allows in each direction, as a share of that along it.
CONE = 0.3
#: Steps between two samples.
EVERY = 25
#: Share of the command by which a sample moves backward, and the longest time [s] before a sample in which joints could have
#: reached other velocities.
BACKWARD, REACTION = -0.02, 0.1
#: A stall: a window [s] in which less than a share is followed, although a pose ahead [m] is reachable with no joint moving
#: farther than this [rad].
WINDOW, STALLED, AHEAD, FARTHEST = 0.25, 0.05, 0.005, 0.8


class Law(Protocol):
    """A way to turn twists into joint velocities."""

    def reset(self) -> None: ...

    def step(self, q: Array, qd: Array, twist: Array) -> Array:
        """Joint velocities (n,) for a twist (6,) of the tool in the axes of the base, linear first."""
        ...


class Arm:
    """An arm by Pinocchio alone. `rows` are those of the six directions of its tool that count."""

    def __init__(self, description: dict[str, object]) -> None:
        self.description = d = description
        self.name, self.tool, self.urdf = str(d["name"]), str(d["tool"]), str(d["urdf"])
        self.model = pin.buildModelFromUrdf(self.urdf)
        self.data, self.frame = self.model.createData(), self.model.getFrameId(self.tool, pin.FrameType.BODY)
        self.joints = list(d["joints"])  # type: ignore[call-overload]
        self.rows = np.array(d["rows"], dtype=int)
        parts = [self.model.joints[self.model.getJointId(name)] for name in self.joints]
        self.n, self.columns = len(parts), [each.idx_v for each in parts]
        self.places = [(each.idx_q, each.nq == 2) for each in parts]
        self.velocity, self.acceleration = self.model.velocityLimit[self.columns], np.array(d["acceleration"])
        lower, upper = self.model.lowerPositionLimit, self.model.upperPositionLimit
        self.lower = np.array([-np.inf if circle else lower[i] for i, circle in self.places])
        self.upper = np.array([np.inf if circle else upper[i] for i, circle in self.places])

    def configuration(self, q: Array) -> Array:
        """Pinocchio's configuration, in which joints without limits are points of a circle; other joints rest."""
        whole = pin.neutral(self.model)
        for x, (i, circle) in zip(q, self.places, strict=True):
            if circle:
                whole[i : i + 2] = np.cos(x), np.sin(x)
            else:
                whole[i] = x
        return np.asarray(whole)

    def pose(self, q: Array) -> pin.SE3:
        pin.framesForwardKinematics(self.model, self.data, self.configuration(q))
        return self.data.oMf[self.frame].copy()

    def jacobian(self, q: Array) -> Array:
        """The rows that count, angular ones in metres."""
        raw = pin.computeFrameJacobian(self.model, self.data, self.configuration(q), self.frame, pin.LOCAL_WORLD_ALIGNED)
        return np.asarray((raw * SCALE[:, None])[self.rows][:, self.columns])

    def scaled(self, twist: Array) -> Array:
        return np.asarray((twist * SCALE)[self.rows])

    def error(self, target: pin.SE3, pose: pin.SE3) -> Array:
        turn = pin.log3(target.rotation @ pose.rotation.T)
        return self.scaled(np.concatenate([target.translation - pose.translation, turn]))

    def bounds(self, q: Array, qd: Array) -> tuple[Array, Array]:
        lowest, highest = self.stopping(q)
        change = self.acceleration * DT
        return np.clip(qd - change, lowest, highest), np.clip(qd + change, lowest, highest)

    def stopping(self, q: Array) -> tuple[Array, Array]:
        """The velocities from which the joints can stop inside their limits; of one q or many (..., n)."""
        room, change = np.array([q - self.lower, self.upper - q]), self.acceleration * DT
        free = np.isinf(room)
        room[free] = 0.0
        steps = np.floor((np.sqrt(1 + 8 * np.maximum(room, 0) / (DT * change)) - 1) / 2)
        speed = np.clip(room / (DT * (steps + 1)) + change * steps / 2, -self.velocity, self.velocity)
        below, above = np.where(free, self.velocity, speed)
        return np.minimum(-below, above), above


def arms(file: Path) -> dict[str, Arm]:
    """The arms of a file that `servo.py` writes."""
    return {name: Arm(each) for name, each in json.loads(file.read_text()).items()}


@dataclass(frozen=True, kw_only=True)
class Run:
    """N steps: q, qd (N + 1, n), twists (N, 6), raw commands (N, n), times of the calls (N,) [s] and the number of errors."""

    q: Array
    qd: Array
    twist: Array
    raw: Array
    seconds: Array
    errors: int
    halts: int


def simulate(
    law: Law, arm: Arm, start: Array, twist: Twist, seconds: float, stop: Callable[[Array], bool] | None = None
) -> Run:
    """What an ideal drive does of a law's commands."""
    import time

    count = round(seconds / DT)
    q, qd = np.array(start, dtype=float), np.zeros(arm.n)
    law.reset()
    twists = np.array([twist(k * DT) for k in range(count)])
    all_q, all_qd, raws, times, errors, halts = [q], [qd], [], np.zeros(count), 0, 0
    for k in range(count):
        begin = time.perf_counter()
        try:
            raw = np.asarray(law.step(q, qd, twists[k]), dtype=float)
        except Exception:
            errors += 1
            raw = np.zeros(arm.n)
        times[k] = time.perf_counter() - begin
        halts += bool(getattr(law, "halted", False))
        raws.append(raw)
        low, high = arm.bounds(q, qd)
        qd = np.clip(np.nan_to_num(raw), low, high)
        q = q + DT * qd
        all_q.append(q)
        all_qd.append(qd)
        if stop is not None and stop(q):
            break
    done = len(raws)
    return Run(
        q=np.array(all_q), qd=np.array(all_qd), twist=twists[:done], raw=np.array(raws), seconds=times[:done],
        errors=errors, halts=halts,
    )  # fmt: skip


def arrival(arm: Arm, start: Array, twist: Array, distance: float) -> Callable[[Array], bool]:
    """Whether the tool at q (n,) is `distance` [m] along a twist from where it was at `start`."""
    begin, direction = arm.pose(start), arm.scaled(twist) / np.linalg.norm(arm.scaled(twist))
    return lambda q: bool(direction @ arm.error(arm.pose(q), begin) >= distance)


def judge(arm: Arm, run: Run) -> dict[str, float]:
    """The figures of one stream, see servo.py."""
    raw, before = np.nan_to_num(run.raw), run.qd[:-1]
    found: dict[str, float] = {"errors": run.errors, "halts": run.halts}
    lowest, highest = arm.stopping(run.q[:-1])
    found["over_velocity"] = float((np.abs(raw) / arm.velocity).max() - 1)
    found["over_acceleration"] = float((np.abs(raw - before) / DT / arm.acceleration).max() - 1)
    moved = run.q[:-1] + DT * raw
    found["over_position"] = float(np.maximum(arm.lower - moved, moved - arm.upper).max())
    found["not_viable"] = float(np.maximum(lowest - raw, raw - highest).max())
    change = np.diff(run.qd, axis=0) / DT
    found["chatter"] = sum(flips(change[:, j], arm.acceleration[j]) for j in range(arm.n)) / (len(raw) * DT) / arm.n
    found |= _following(arm, run)
    found["step"] = float(np.median(run.seconds))
    return found


def flips(acceleration: Array, limit: float) -> int:
    """Changes of sign above 2 % of the limit."""
    large = acceleration[np.abs(acceleration) > 0.02 * limit]
    return int((np.sign(large[1:]) != np.sign(large[:-1])).sum())


def _following(arm: Arm, run: Run) -> dict[str, float]:
    share, bound, sigma, angle, slip, speed, at = [], [], [], [], [], [], []
    backward_avoidable = stalls_avoidable = 0
    for k in range(0, len(run.raw), EVERY):
        command = arm.scaled(run.twist[k])
        size = float(np.linalg.norm(command))
        if size < 1e-3:
            continue
        jacobian = arm.jacobian(run.q[k])
        moves, along = jacobian @ run.qd[k + 1], command / size
        forward = float(along @ moves)
        across = float(np.linalg.norm(moves - forward * along))
        at.append(k)
        share.append(forward / size)
        bound.append(_possible(jacobian, command, *arm.stopping(run.q[k])) or 0.0)
        if share[-1] < BACKWARD:
            backward_avoidable += _in_time(arm, run, k, jacobian, command) is not None
        sigma.append(np.linalg.svd(jacobian, compute_uv=False)[-1])
        angle.append(np.degrees(np.arctan2(across, forward)))
        slip.append(across / size)
        speed.append(np.linalg.norm(moves))
    followed, limit, moving = np.clip(share, 0, 1), np.array(bound), np.array(speed) > 2e-3
    close = np.convolve(np.array(sigma) < NEAR, np.ones(2 * round(AROUND / (EVERY * DT)) + 1), "same") > 0
    counts = close[: len(limit)] & (limit > 0.02)
    window, stalls = round(WINDOW / (EVERY * DT)), 0
    for i in range(0, len(at) - window, window):
        if np.mean(share[i : i + window]) < STALLED:
            middle = at[i + window // 2]
            if _reachable(arm, run.q[middle], run.twist[middle]):
                stalls += 1
                best = [
                    _in_time(arm, run, k, arm.jacobian(run.q[k]), arm.scaled(run.twist[k])) or 0.0 for k in at[i : i + window]
                ]
                stalls_avoidable += bool(np.mean(best) >= STALLED)
    near = np.minimum(followed, limit)[counts].sum() / limit[counts].sum() if counts.any() else np.nan
    return {
        "near": float(near),
        "followed": float(followed.mean()),
        "backward": float((np.array(share) < BACKWARD).mean()),
        "backward_avoidable": backward_avoidable,
        "angle": float(np.mean(np.array(angle)[moving])) if moving.any() else 0.0,
        "slip": float(np.mean(slip)),
        "stalled": stalls * WINDOW,
        "stalls_avoidable": stalls_avoidable,
        "least_sigma": float(np.min(sigma)),
    }


def _in_time(arm: Arm, run: Run, k: int, jacobian: Array, command: Array) -> float | None:
    """Largest share of a command at step k by velocities that the joints could have reached in time; None as below.

    In REACTION, or since the command came: since all that followed were within CONE of the one at step k.
    """
    first = max(k - round(REACTION / DT), 0) + 1
    commands = (run.twist[first : k + 1] * SCALE)[:, arm.rows]
    along = commands @ command / np.linalg.norm(command)
    turned = np.flatnonzero(np.linalg.norm(commands, axis=1) > np.hypot(1, CONE) * along)
    first += int(turned[-1]) + 1 if len(turned) else 0
    low, high = arm.stopping(run.q[k])
    before, change = run.qd[first], arm.acceleration * DT * (k + 1 - first)
    return _possible(jacobian, command, np.clip(before - change, low, high), np.clip(before + change, low, high))


def _possible(jacobian: Array, command: Array, low: Array, high: Array) -> float | None:
    """Largest share of a command (m,) that joint velocities make with at most CONE of motion across it.

    A tool that rests is inside the cone: 0 where the best that velocities can do is to keep it at rest, and None where all of
    them move it backward or out of the cone.
    """
    import daqp  # not in every peer's environment, which simulates but does not judge

    m, n = jacobian.shape
    size = float(np.linalg.norm(command))
    along = command / size
    across = np.linalg.svd(along[None, :])[2][1:]
    # variables: q̇, the speed a along the command, the speeds e across it, |e| <= CONE a
    equal = np.hstack([jacobian, -along[:, None], -across.T])
    cone = [np.hstack([np.zeros((m - 1, n)), -CONE * np.ones((m - 1, 1)), sign * np.eye(m - 1)]) for sign in (1, -1)]
    matrix = np.ascontiguousarray(np.vstack([equal, *cone]))
    upper = np.concatenate([high, [size], 10 * np.ones(m - 1), np.zeros(len(matrix))])
    lower = np.concatenate([low, [0.0], -10 * np.ones(m - 1), np.zeros(m), np.full(2 * (m - 1), -1e20)])
    sense = np.array([0] * (n + m) + [5] * m + [0] * (2 * (m - 1)), dtype=np.int32)
    cost = np.zeros(n + m)
    cost[n] = -1
    x, _, flag, _ = daqp.solve(1e-7 * np.eye(n + m), cost, matrix, upper, lower, sense)
    return float(np.clip(x[n] / size, 0, 1)) if flag > 0 else None


def moved(pose: pin.SE3, twist: Array, seconds: float) -> pin.SE3:
    """The pose after a twist in the axes of the base."""
    return pin.SE3(pin.exp3(twist[3:] * seconds) @ pose.rotation, pose.translation + twist[:3] * seconds)


def solve_pose(arm: Arm, target: pin.SE3, start: Array, tolerance: float) -> Array | None:
    """A configuration within the limits that reaches a pose, by damped Newton steps."""
    q = start
    for _ in range(60):
        error = arm.error(target, arm.pose(q))
        size = float(np.linalg.norm(error))
        if size < tolerance:
            inside = (q >= arm.lower).all() and (q <= arm.upper).all()
            return q if inside else None
        jacobian = arm.jacobian(q)
        step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + (1e-4 * size + 1e-12) * np.eye(len(error)), error)
        q = q + step * min(1.0, 0.3 / (np.abs(step).max() + 1e-12))
    return None


def _reachable(arm: Arm, q: Array, twist: Array) -> bool:
    size = float(np.linalg.norm(arm.scaled(twist)))
    if size < 1e-3:
        return False
    rng = np.random.default_rng(0)
    target = moved(arm.pose(q), twist, AHEAD / size)
    starts = [q, *(q + 0.25 * rng.standard_normal(arm.n) for _ in range(7))]
    found = (solve_pose(arm, target, start, 1e-5) for start in starts)
    return any(x is not None and np.abs(x - q).max() <= FARTHEST for x in found)


def leaving_bound(arm: Arm, q: Array, twist: Array, distance: float, seed: int) -> float | None:
    """A lower bound on the time to be `distance` along a twist from rest, joint by joint with free end speed [s]."""
    rng = np.random.default_rng(seed)
    size = float(np.linalg.norm(arm.scaled(twist)))
    target, best = moved(arm.pose(q), twist, distance / size), None
    for trial in range(80):
        start = q if trial == 0 else q + rng.choice([0.1, 0.3, 0.8]) * rng.standard_normal(arm.n)
        x = solve_pose(arm, target, start, 1e-6)
        if x is None or np.abs(x - q).max() > 2.0:
            continue
        way = np.abs(x - q)
        ramp = arm.velocity**2 / (2 * arm.acceleration)
        joint = np.where(
            way <= ramp, np.sqrt(2 * way / arm.acceleration), arm.velocity / arm.acceleration + (way - ramp) / arm.velocity
        )
        seconds = max(float(joint.max()), distance / size)
        best = seconds if best is None else min(best, seconds)
    return best
