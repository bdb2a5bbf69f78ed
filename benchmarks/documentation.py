"""How long a newcomer waits: from a fresh clone to the first plan of the start page, and for the whole site to build.

Wall time, as it is waited for: run it when nothing else runs. Run with `make benchmark`.
"""

import platform
import re
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
OUT = ROOT / "docs" / "benchmarks" / "documentation.md"


def seconds(*command: str | Path, folder: Path) -> float:
    """Wall time [s] of a command that has to succeed."""
    began = time.monotonic()
    subprocess.run(command, check=True, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.monotonic() - began


def main() -> None:
    with tempfile.TemporaryDirectory() as place:
        clone = Path(place) / "manipplan"
        times = {"`git clone`": seconds("git", "clone", ROOT, clone, folder=Path(place))}
        times["`make demo`: set-up, downloads, two plans"] = seconds("make", "demo", folder=clone)
        first, *_ = re.findall(r"```python\n(.*?)```", (clone / "docs" / "start.md").read_text(), re.DOTALL)
        python = clone / ".venv" / "bin" / "python"
        times["the first plan of the start page, saved"] = seconds(python, "-c", first, folder=clone)
        newcomer = sum(times.values())
        times["**clone to first plan**"] = newcomer
        built = clone / "docs" / "_build" / "html"
        site = seconds(python, "-m", "sphinx", "-W", "-q", "-j", "auto", "-b", "html", "docs", built, folder=clone)
        pages = len(list((clone / "docs" / "examples").glob("**/plot_*.py")))
        times[f"**site from nothing, {pages} examples run, warnings as errors**"] = site
    lines = ["| what | wall time [s] |", "|---|---|", *(f"| {name} | {value:.0f} |" for name, value in times.items())]
    version = f"Python {platform.python_version()}, {platform.machine()}; command: `python benchmarks/documentation.py`."
    OUT.write_text("\n".join([*lines, "", version]) + "\n")
    print(OUT.read_text())


if __name__ == "__main__":
    main()
