"""The arms of example-robot-data beside Pinocchio and coal on their original files: kinematics, limits, contacts, plans.

Run with `make benchmark`. Writes docs/benchmarks/catalogue_arms.md.
"""

import argparse
import time
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
from description_judge import Judge
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "catalogue_arms.md"
HEAD = (
    "| arm | pose, J, limits: largest difference | postures | in collision | wrongly free | wrongly touching "
    "| within the excess | plans | OPTIMAL | other success | touching or beyond a limit | processor time, median |"
)
#: Largest motion of a joint between two samples of a plan [rad or m], distances that are contact by rounding [m], and how far
#: joints may be beyond their limits [rad or m].
STEP, ROUNDING, INSIDE = 2e-3, 1e-6, 1e-7


def kinematic_difference(robot: mp.Robot, judge: Judge, postures: np.ndarray) -> float:
    """The largest difference of poses, Jacobians and limits."""
    worst = 0.0
    for tool in robot.tools:
        arm = robot.arm(tool)
        kinematics = arm.kinematics(mp.Task.pose(length=1.0))
        columns = list(robot.joints_of(tool))
        for q in postures:
            whole = robot.neutral.copy()
            whole[columns] = q[columns]
            pose, jacobian = judge.pose_and_jacobian(whole, tool)
            worst = max(worst, np.abs(kinematics.pose(q[columns]) - pose).max())
            worst = max(worst, np.abs(kinematics.jacobian(q[columns]) - jacobian[:, columns]).max())
    joints = {each.get("name"): each for each in ET.parse(robot.source.file).getroot().findall("joint")}
    for k, name in enumerate(robot.joint_names):
        limit = joints[name].find("limit")
        if limit is None:  # a continuous joint
            continue
        stated = float(limit.get("velocity", "0"))
        pairs = [(robot.limits.velocity[k], stated)] if stated > 0 and np.isfinite(robot.limits.velocity[k]) else []
        if joints[name].get("type") != "continuous":
            pairs += [(robot.limits.lower[k], limit.get("lower", "0")), (robot.limits.upper[k], limit.get("upper", "0"))]
        worst = max([worst, *(abs(ours - float(text)) for ours, text in pairs)])
    return worst


def row(name: str, postures: int, plans: int) -> tuple[str, list[int]]:
    """The line of one arm, and its counts."""
    described = mp.load_robot(name)
    speeds, ramps = described.limits.velocity, described.limits.acceleration  # the files of some arms state no velocities
    robot = described.with_limits(
        velocity=np.where(np.isfinite(speeds), speeds, 1.0), acceleration=np.where(np.isfinite(ramps), ramps, 5.0)
    )
    rng = np.random.default_rng(1)
    q, judge = robot.random_configuration(rng, size=postures), Judge(robot.source.file, robot)
    scene = mp.Scene()
    model, ours, verdicts = scene.collision_model(robot), scene.in_collision(robot, q), judge.verdicts(q)
    left_out = verdicts.always | verdicts.unclear | set(robot.disabled_pairs or ())
    excess = 2 * max(model.excess.values(), default=0.0) + ROUNDING
    free = wrong = close = hits = 0
    for k in range(postures):
        links = verdicts.touching[k] - left_out
        hits += bool(links)
        free += bool(links) and not ours[k]
        if ours[k] and not links and not verdicts.touching[k] & verdicts.unclear:
            near = judge.least(q[k], left_out) <= excess
            close, wrong = close + near, wrong + (not near)
    candidates = q[~ours]
    optimal = other = bad = count = 0
    times = []
    for start, goal in zip(candidates[0 : 2 * plans : 2], candidates[1 : 2 * plans : 2], strict=False):
        count += 1
        begun = time.process_time()
        plan = mp.plan(robot, start, goal, throw=False)
        times.append(time.process_time() - begun)
        if not plan.status.ok:
            continue
        optimal += plan.status is mp.Status.OPTIMAL
        other += plan.status is not mp.Status.OPTIMAL
        motion = plan.trajectory
        samples = motion(np.linspace(0.0, motion.duration, 401))
        steps = int(np.ceil(np.abs(np.diff(samples, axis=0)).max(axis=1).sum() / STEP)) + 1
        t = np.linspace(0.0, motion.duration, max(401, steps))
        places, speeds = motion(t), motion(t, order=1)
        beyond = (places < robot.limits.lower - INSIDE).any() or (places > robot.limits.upper + INSIDE).any()
        beyond = beyond or (np.abs(speeds) > robot.limits.velocity * (1 + 1e-6)).any()
        bad += bool(beyond) or any(touching - left_out for touching in judge.verdicts(places).touching)
    counts = [postures, hits, free, wrong, close, count, optimal, other, bad]
    median = f"{np.median(times):.2f} s" if times else "–"
    difference = kinematic_difference(described, judge, q[:50])
    return f"| `{name}` | {difference:.0e} | {' | '.join(map(str, counts))} | {median} |", counts


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--postures", type=int, default=200)
    parser.add_argument("--plans", type=int, default=3)
    parser.add_argument("--arms", nargs="*", default=list(mp.available_robots()))
    options = parser.parse_args()
    lines, sums = [HEAD, f"|{'---|' * HEAD.count(' | ')}---|"], np.zeros(9, dtype=int)
    for name in track(options.arms, "arms"):
        line, counts = row(name, options.postures, options.plans)
        lines.append(line)
        sums += counts
    lines += [
        f"| **all** | | {' | '.join(map(str, sums))} | |",
        "",
        f"Command: `python benchmarks/catalogue_arms.py --postures {options.postures} --plans {options.plans}`.",
    ]
    OUT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(OUT.read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
