"""Twist streams of servo.py: they depend on time alone, so that all laws get identical ones."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq
from servo_judge import DT, LENGTH, SCALE, Arm, Array, Twist

HALF = np.pi / 2
#: Speeds of designed streams [m/s, rad/s].
SPEED, TURN = 0.1, 0.4


@dataclass(frozen=True, kw_only=True)
class Stream:
    """A twist (6,) over time in the axes of the base, from a start at rest."""

    arm: str
    start: Array
    twist: Twist
    seconds: float = 20.0


def lost(arm: Arm, q: Array, rank: int = -1) -> Array:
    """The direction that the tool loses at a singular q, as a twist (6,)."""
    found = np.zeros(6)
    found[arm.rows] = np.linalg.svd(arm.jacobian(q))[0][:, rank] / SCALE[arm.rows]
    return found


def line(*direction: float) -> Array:
    d = np.array(direction)
    return np.concatenate([d / np.linalg.norm(d) * SPEED, np.zeros(3)])


def turn(*axis: float) -> Array:
    d = np.array(axis)
    return np.concatenate([np.zeros(3), d / np.linalg.norm(d) * TURN])


def steady(twist: Array) -> Twist:
    """The same twist all the time."""
    return lambda _: twist


def phases(*parts: tuple[float, Array]) -> Twist:
    """Twists for some seconds each, with ramps of 0.1 s between them."""
    ends = np.cumsum([seconds for seconds, _ in parts])
    twists = [each for _, each in parts]

    def twist(t: float) -> Array:
        i = min(int(np.searchsorted(ends, t, side="right")), len(parts) - 1)
        before = twists[i - 1] if i else np.zeros(6)
        share = min((t - (ends[i - 1] if i else 0.0)) / 0.1, 1.0)
        return np.asarray((1 - share) * before + share * twists[i])

    return twist


def walk(seed: int, seconds: float = 20.0) -> Twist:
    """White noise through 1 / ((1 s + 1) (0.15 s + 1)²), about 0.12 m/s and 0.35 rad/s: smooth, so chatter is a law's."""
    rng = np.random.default_rng(seed)
    dt = 0.01
    x = y = w = np.zeros(6)
    size, rows = np.array([0.085] * 3 + [0.25] * 3), []
    for _ in range(round((seconds + 3) / dt)):
        x = x - dt * x + size * np.sqrt(2 * dt) * rng.standard_normal(6)
        y = y + dt / 0.15 * (x - y)
        w = w + dt / 0.15 * (y - w)
        rows.append(w)
    fine = CubicSpline(dt * np.arange(len(rows)), np.array(rows))(DT * np.arange(round((seconds + 2) / DT)))
    return lambda t: np.asarray(min(t / 0.2, 1.0) * fine[round(t / DT)])


def _unit(v: Array) -> Array:
    return np.asarray(v / np.linalg.norm(v))


def designed(arms: dict[str, Arm]) -> dict[str, Stream]:
    """Folds approached, slid along and left; poles passed, straight and beside; starts in singularities; and walks."""
    found = _of_ur5(arms["ur5"]) | _of_xarm7(arms["xarm7"]) | _of_panda(arms["panda"])
    return {
        name: Stream(arm=name.split()[0], start=np.asarray(start, dtype=float), twist=twist)
        for name, (start, twist) in found.items()
    }


def _of_ur5(arm: Arm) -> dict[str, tuple[Array, Twist]]:
    found: dict[str, tuple[Array, Twist]] = {}
    q = np.array([0.3, -0.6, 0.5, -1.2, -1.2, 0.4])
    straight = q * [1, 1, 0, 1, 1, 1]
    outward = arm.pose(straight).translation - [0, 0, 0.089]
    u = _unit(lost(arm, straight)[:3])
    u = u * np.sign(u @ outward)
    side = _unit(np.cross(u, [0, 0, 1]))
    up = np.cross(side, u)
    found["ur5 elbow in, along, oblique, out"] = (
        q,
        phases((5, line(*u)), (3, line(*side)), (4, line(*(u + up))), (3, line(*(-u - up))), (5, line(*-u))),
    )
    found["ur5 elbow in and out"] = q, phases(*[(2, line(*(u if i % 2 == 0 else -u))) for i in range(10)])
    q = np.array([0.2, -1.3, 1.5, -1.2, 0.5, 0.3])
    wrist = q * [1, 1, 1, 1, 0, 1]
    axis = arm.jacobian(wrist)[3:, 4] / LENGTH
    found["ur5 wrist through"] = q, phases(*[(2.5, turn(*(axis if i % 2 else -axis))) for i in range(8)])
    across = _unit(lost(arm, wrist)[3:])
    tilted = -axis + 0.1 * across
    found["ur5 wrist past"] = q, phases(*[(2.5, turn(*(tilted if i % 2 == 0 else -tilted))) for i in range(8)])
    beside = q * [1, 1, 1, 1, 0, 1] + [0, 0, 0, 0, 0.02, 0]
    found["ur5 wrist along lost"] = (
        beside,
        phases((5, turn(*across)), (5, turn(*-across)), (5, turn(*(across + axis))), (5, turn(*(-across + axis)))),
    )
    shoulder = np.array([0.0, -1.9, 1.9, -1.6, -1.3, 0.0])

    def determinant(x: float) -> float:
        return float(np.linalg.det(arm.jacobian(np.concatenate([[0.0, x], shoulder[2:]]))))

    grid = np.linspace(-2.9, -1.0, 60)
    values = [determinant(x) for x in grid]
    root = next(brentq(determinant, *grid[i : i + 2]) for i in range(59) if values[i] * values[i + 1] < 0)
    above = np.concatenate([[0.0, root], shoulder[2:]])
    u = _unit(lost(arm, above)[:3])
    step = arm.pose(above + 0.35 * np.eye(6)[1]).translation - arm.pose(above).translation
    over = _unit(step)
    found["ur5 shoulder along lost"] = (
        above + 0.02 * np.eye(6)[1],
        phases((5, line(*u)), (5, line(*-u)), (5, line(*(u + over))), (5, line(*(-u - over)))),
    )
    upright = np.array([0, -HALF, 0, -HALF, 0, 0])
    found["ur5 upright start"] = (
        upright,
        phases((5, line(0, 0, -1)), (5, line(1, 0, 0)), (5, line(0, 1, 0)), (5, line(0, 0, 1))),
    )
    straight = np.array([0.3, -0.8, 0.0, -1.0, 1.2, 0.0])
    u = _unit(lost(arm, straight)[:3])
    u = u * np.sign(u @ (arm.pose(straight).translation - [0, 0, 0.089]))
    found["ur5 straight start"] = straight, phases(*[(5, line(*(-u if i % 2 == 0 else u))) for i in range(4)])
    return found | {"ur5 walk 0": (upright, walk(0)), "ur5 walk 2": (wrist, walk(2))}


def _of_xarm7(arm: Arm) -> dict[str, tuple[Array, Twist]]:
    q = np.array([0.2, 0.3, 0.2, 0.9, 0.1, 1.2, 0.0])
    d = _unit(arm.pose(q).translation - [0, 0, 0.267])
    side = _unit(np.cross(d, [0, 0, 1]))
    up = np.cross(side, d)
    beside = np.array([0.3, 0.02, 0.0, 1.2, 0.0, 0.02, 0.2])
    u = _unit(lost(arm, beside * [1, 0, 1, 1, 1, 0, 1])[3:])
    return {
        "xarm7 reach in, along, oblique, out": (
            q,
            phases((6, line(*d)), (3, line(*side)), (3, line(*(d + up))), (3, line(*(-d - up))), (5, line(*-d))),
        ),
        "xarm7 zero start": (
            np.zeros(7),
            phases((5, line(0, 0, 1)), (5, line(1, 0, 0)), (5, line(0, 1, 0)), (5, line(0, 0, -1))),
        ),
        "xarm7 wrist and shoulder along lost": (
            beside,
            phases((5, turn(*u)), (5, turn(*-u)), (5, line(0, 1, 0)), (5, line(0, -1, 0))),
        ),
        "xarm7 walk 0": (np.zeros(7), walk(100)),
    }


def _of_panda(arm: Arm) -> dict[str, tuple[Array, Twist]]:  # noqa: ARG001
    q = np.array([0.0, -0.3, 0.0, -1.6, 0.0, 1.6, 0.785])
    singular = np.array([0.556, 0.0, -1.769, -2.593, 1.161, 3.435, 0.433])
    return {
        "panda reach in, along, oblique, out": (
            q,
            phases((6, line(1, 0, 0.4)), (3, line(0, 1, 0)), (3, line(1, 0, 1)), (3, line(-1, 0, -1)), (5, line(-1, 0, -0.4))),
        ),
        "panda shoulder and wrist lines": (
            singular,
            phases((4, line(0, 1, 0)), (4, line(0, -1, 0)), (4, line(-1, 0, 0)), (4, line(1, 0.2, 0)), (4, turn(1, 0, 0))),
        ),
        "panda walk 1": (singular, walk(201)),
    }


def singular_postures(arm: Arm, count: int, seed: int) -> list[Array]:
    """Random postures inside the limits with σ_min below 1e-6 m, by descent of σ from random ones."""
    rng, found = np.random.default_rng(seed), list[Array]()
    low, high = np.maximum(arm.lower, -np.pi) + 0.05, np.minimum(arm.upper, np.pi) - 0.05
    while len(found) < count:
        q = rng.uniform(low, high)
        for _ in range(40):
            left, sigma, right = np.linalg.svd(arm.jacobian(q))
            if sigma[-1] < 1e-6:
                found.append(q)
                break
            u, v = left[:, len(sigma) - 1], right[len(sigma) - 1]
            slope = np.array(
                [u @ (arm.jacobian(q + step) - arm.jacobian(q - step)) @ v / 2e-6 for step in 1e-6 * np.eye(arm.n)]
            )
            change = -sigma[-1] * slope / (slope @ slope + 1e-9)
            q = np.clip(q + change * min(1.0, 0.3 / (np.abs(change).max() + 1e-12)), low, high)
    return found


def is_walk(number: int) -> bool:
    """Whether the random stream of this number is a walk; six arms take turns."""
    return number // 6 % 2 == 1


def touching(arm: Arm, number: int, seconds: float = 20.0) -> Stream:
    """The stream of this number that begins at or near a singular posture: a walk, or lines and turns along what is lost."""
    start = singular_postures(arm, 1, number)[0]
    rng = np.random.default_rng(10_000 + number)
    u = lost(arm, start)
    if number // 12 % 3:  # a third begins exactly there
        offset = rng.uniform(-0.2, 0.2, arm.n)
        start = np.clip(start + offset, np.maximum(arm.lower, -10), np.minimum(arm.upper, 10))
    if is_walk(number):
        return Stream(arm=arm.name, start=start, twist=walk(number, seconds), seconds=seconds)
    parts = []
    for i in range(round(seconds / 2.5)):
        other = np.zeros(6)
        other[arm.rows] = rng.standard_normal(len(arm.rows)) / SCALE[arm.rows]
        other *= np.linalg.norm(u * SCALE) / np.linalg.norm(other * SCALE)
        d = (u, -u, u + 0.5 * other, other)[i % 4] if rng.random() < 0.7 else other
        parts.append((2.5, SPEED * d / np.linalg.norm(d * SCALE)))
    return Stream(arm=arm.name, start=start, twist=phases(*parts), seconds=seconds)


#: Singular postures of the leaving test.
POSTURES = {
    "ur5 upright": ("ur5", [0, -HALF, 0, -HALF, 0, 0]),
    "ur5 elbow": ("ur5", [0.3, -0.8, 0.0, -1.0, 1.2, 0.0]),
    "ur5 wrist": ("ur5", [0.2, -1.3, 1.5, -1.2, 0.0, 0.3]),
    "xarm7 zero": ("xarm7", [0.0] * 7),
    "panda shoulder and wrist": ("panda", [0.556, 0.0, -1.769, -2.593, 1.161, 3.435, 0.433]),
}
