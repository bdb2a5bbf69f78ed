"""What every peer's script for servo.py shares: its laws go through the streams, behind the ideal drive of servo_judge.py.

A problem has: arms (JSON, as servo.py writes it), runs (JSON: a list of arm, start (n,) and distance [m], 0 for the whole
stream), and "twists 0" (N, 6), "twists 1", ... of the runs. The result has for law i and run k "i k q", "i k qd", "i k raw",
"i k seconds", "i k errors", and the names of the laws.
"""

import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from steps import arm_urdf

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from servo_judge import DT, Arm, Law, arrival, moved, simulate

__all__ = ["DT", "bare_file", "bare_urdf", "moved", "run"]


def bare_urdf(arm: Arm) -> str:
    """The arm's URDF without meshes, its other joints fixed where the judge has them."""
    others = [name for name in list(arm.model.names)[1:] if name not in arm.joints]
    problem = {"urdf": arm.urdf, "active": arm.joints, "locked": others, "locked_q": np.zeros(len(others))}
    return arm_urdf(problem | {"lower": arm.lower, "upper": arm.upper, "velocity": arm.velocity})


def bare_file(arm: Arm) -> str:
    """The same as a file, beside the result."""
    file = Path(sys.argv[2]).with_name(f"{arm.name}.urdf")
    file.write_text(bare_urdf(arm))
    return str(file)


def run(laws: dict[str, Callable[[Arm], Law]]) -> None:
    """Run every law on every run of the problem, and write what they did."""
    with np.load(sys.argv[1]) as given:
        problem = dict(given)
    arms = {name: Arm(each) for name, each in json.loads(problem["arms"].item()).items()}
    found: dict[str, np.ndarray] = {"laws": np.array(list(laws))}
    for i, make in enumerate(laws.values()):
        made: dict[str, Law] = {}
        for k, each in enumerate(json.loads(problem["runs"].item())):
            arm, twists, start = arms[each["arm"]], problem[f"twists {k}"], np.array(each["start"])
            if arm.name not in made:
                made[arm.name] = make(arm)
            stop = arrival(arm, start, twists[0], each["distance"]) if each["distance"] else None
            done = simulate(made[arm.name], arm, start, lambda t, twists=twists: twists[round(t / DT)], len(twists) * DT, stop)
            values = {"q": done.q, "qd": done.qd, "raw": done.raw, "seconds": done.seconds, "errors": done.errors}
            found |= {f"{i} {k} {key}": np.asarray(value) for key, value in values.items()}
    np.savez(sys.argv[2], **found)
