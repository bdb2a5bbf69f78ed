"""Writes the numbers of the interactive planar page into docs/_static/planar.html: python docs/make_planar_page.py.

The page computes kinematics itself. What it takes from here: the posture of Table 5.1 in kth2012, the paths of degree 6 of
section 6.2 and 6.3, and the colours of the map.
"""

import json
import re
from itertools import product
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

import manipplan as mp

PAGE = Path(__file__).parent / "_static" / "planar.html"
BLOCK = re.compile(r'(<script type="application/json" id="data">\n).*?(\n</script>)', re.DOTALL)
#: Start and goal of the examples, by equation number.
EXAMPLES = {
    "6.10": ((0.0, -3.0, -2.0), (np.pi, 0.1, 1.4)),
    "6.12": ((0.0, -1.1, -1.6), (np.pi / 2, 0.5, 1.5)),
    "6.13": ((0.0, 1.5, -2.0), (np.pi, -2.0, 2.0)),
}
DEGREE = 6
POWERS = (1, 2)
COLOURS = 17
DIGITS = 10


def optimum(kinematics) -> list[float]:
    """θ of the largest index with θ₁ = 0 and θ₂ > 0, by Newton's steps after BFGS from a grid of starts."""
    starts = product(np.arange(0.3, 3.0, 0.9), np.arange(-2.7, 3.0, 0.9))
    found = [
        minimize(
            lambda x: -kinematics.manipulability([0.0, *x]),
            start,
            jac=lambda x: -kinematics.gradient([0.0, *x])[1:],
            method="BFGS",
        )
        for start in starts
    ]
    x = min((each for each in found if each.x[0] > 0), key=lambda each: each.fun).x
    for _ in range(4):
        q = [0.0, *x]
        x = x - np.linalg.solve(kinematics.hessian(q)[1:, 1:], kinematics.gradient(q)[1:])
    return [0.0, *x]


def palette() -> list[str]:
    """Colours from low to high that those who are colour-blind tell apart, too: matplotlib's cividis."""
    from matplotlib import colormaps
    from matplotlib.colors import to_hex

    return [to_hex(colormaps["cividis"](x)) for x in np.linspace(0, 1, COLOURS)]


def numbers() -> dict:
    """What the page holds."""
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    paths = []
    for name, (start, goal) in EXAMPLES.items():
        found = {
            p: mp.optimize_path(arm, start, goal, shape=mp.PathShape(degree=DEGREE), objective=mp.PathObjective(power=p)).path
            for p in POWERS
        }
        control = {str(p): path.control[0].round(DIGITS).tolist() for p, path in found.items()}
        paths.append({"name": name, "line": [list(start), list(goal)], "optimal": control})
    best = np.round(optimum(arm.kinematics()), DIGITS).tolist()
    return {"optimum": best, "paths": paths, "palette": palette()}


def main() -> None:
    text = json.dumps(numbers(), separators=(",", ":"))
    page, count = BLOCK.subn(lambda match: match[1] + text + match[2], PAGE.read_text(encoding="utf-8"))
    if count != 1:
        raise SystemExit(f"{PAGE} has {count} blocks for data; there has to be one")
    PAGE.write_text(page, encoding="utf-8")
    print(f"wrote {len(text)} characters of numbers into {PAGE}")


if __name__ == "__main__":
    main()
