"""Where controllers come to rest: at their target, or away from it with a status that says so?

Run with `make benchmark`. Every formulation runs from random starts towards poses of other random configurations, which stand
still, so each of them can be reached. The tool's final pose is computed by Pinocchio from the original file. An end is at rest
at the target within 1 mm and 1 mrad, stalled if the last step says so, and wrong otherwise: away from the target and SOLVED
although the arm has not come closer for the last seconds. Stalled ends are sorted by what holds the arm: a joint at its limit,
the rank of the Jacobian, or neither. Writes docs/benchmarks/rest.md.
"""

import argparse
import platform
from collections import Counter
from pathlib import Path

import numpy as np
import pinocchio as pin
from rich.progress import track

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "rest.md"
ARMS = ("panda", "ur5")
FORMULATIONS = {
    "General": mp.formulations.General(),
    "Classical, gain 0": mp.formulations.Classical(),
    "Classical, gain 1": mp.formulations.Classical(1.0),
    "Objective, (10)": mp.formulations.Objective(15e3),
    "Equality, (14)": mp.formulations.Equality(5e5),
    "LogDrive": mp.formulations.LogDrive(),
    "LogDrive, yields=False": mp.formulations.LogDrive(yields=False),
}
SEED, DT, NEAR = 45, 0.01, 1e-3
#: An arm still approaches if its distance has shrunk by this share within this time [s].
CLOSER, LOOK_BACK = 0.005, 5.0
#: Distance to a limit [rad], and the least singular value over the largest at which a Jacobian has lost its rank.
AT_LIMIT, SINGULAR = 1e-4, 0.01
COLUMNS = (
    "at the target",
    "stalled at a joint limit",
    "stalled at a singularity",
    "stalled elsewhere",
    "still approaching",
    "wrong",
)


class Judge:
    """Forward kinematics of the original file, with the joints that are locked held in place."""

    def __init__(self, robot: mp.Robot) -> None:
        assert robot.source is not None
        self.model = pin.buildModelFromUrdf(str(robot.source.file))
        self.data = self.model.createData()
        self.frame = self.model.getFrameId(robot.tool)
        self.q = pin.neutral(self.model)
        self.at = [self.model.joints[self.model.getJointId(name)].idx_q for name in robot.joint_names]

    def pose(self, q: np.ndarray) -> pin.SE3:
        self.q[self.at] = q
        pin.forwardKinematics(self.model, self.data, self.q)
        return pin.updateFramePlacement(self.model, self.data, self.frame).copy()

    def condition(self, q: np.ndarray) -> float:
        self.q[self.at] = q
        columns = [self.model.joints[j].idx_v for j in range(1, self.model.njoints) if self.model.joints[j].idx_q in self.at]
        jacobian = pin.computeFrameJacobian(self.model, self.data, self.q, self.frame, pin.LOCAL)[:, columns]
        sizes = np.linalg.svd(jacobian, compute_uv=False)
        return float(sizes[-1] / sizes[0])

    def distance(self, q: np.ndarray, target: pin.SE3) -> float:
        """Largest of the distance [m] and the angle [rad]."""
        pose = self.pose(q)
        turned = np.linalg.norm(pin.log3(pose.rotation.T @ target.rotation))
        return float(max(np.linalg.norm(pose.translation - target.translation), turned))


def end_of(robot: mp.Robot, judge: Judge, run: mp.results.Rollout, target: pin.SE3) -> str:
    """One of COLUMNS."""
    q = run.q[-1]
    away = judge.distance(q, target)
    if away < NEAR:
        return "at the target"
    if run["status"][-1] == mp.results.StepStatus.STALLED:
        room = np.minimum(q - robot.limits.lower, robot.limits.upper - q).min()
        if room < AT_LIMIT:
            return "stalled at a joint limit"
        return "stalled at a singularity" if judge.condition(q) < SINGULAR else "stalled elsewhere"
    before = judge.distance(run.q[-1 - round(LOOK_BACK / DT)], target)
    return "still approaching" if away < (1 - CLOSER) * before else "wrong"


def main(arguments: list[str] | None = None) -> dict[tuple[str, str], Counter[str]]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000, help="number of starts and targets")
    parser.add_argument("--seconds", type=float, default=60.0, help="length of a run")
    parser.add_argument("--arms", nargs="+", choices=ARMS, default=ARMS)
    parser.add_argument("--out", type=Path, default=OUT, help="file of the table")
    given = parser.parse_args(arguments)
    steps = round(given.seconds / DT)
    found: dict[tuple[str, str], Counter[str]] = {}
    for arm in given.arms:
        robot = mp.load_robot(arm)
        judge = Judge(robot)
        rng = np.random.default_rng(SEED)
        starts, ends = (rng.uniform(robot.limits.lower, robot.limits.upper, (given.count, robot.n)) for _ in range(2))
        targets = [judge.pose(q) for q in ends]
        for name, formulation in FORMULATIONS.items():
            controller = mp.Controller(robot, formulation, dt=DT)
            counts = found[arm, name] = Counter()
            for start, target in zip(track(starts, description=f"{arm}, {name}"), targets, strict=True):
                run = controller.rollout(start, np.broadcast_to(target.homogeneous, (steps, 4, 4)))
                counts[end_of(robot, judge, run, target)] += 1
    lines = [f"| arm | formulation | {' | '.join(COLUMNS)} |", f"|{'---|' * (len(COLUMNS) + 2)}"]
    lines += [
        f"| {arm} | {name} | {' | '.join(str(counts[column]) for column in COLUMNS)} |" for (arm, name), counts in found.items()
    ]
    lines += [
        "",
        f"{given.count} random starts and as many targets per arm, runs of {given.seconds:g} s at {1e3 * DT:g} ms; a joint is "
        f"at its limit within {AT_LIMIT:g} rad, and the arm at a singularity if the least singular value is below {SINGULAR:g} "
        f"of the largest; Python {platform.python_version()}, {platform.machine()}; command: `.venv/bin/python "
        f"benchmarks/rest.py --count {given.count} --seconds {given.seconds:g}`.",
    ]
    given.out.parent.mkdir(parents=True, exist_ok=True)
    given.out.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return found


if __name__ == "__main__":
    main()
