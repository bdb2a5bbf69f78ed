"""Processor time of each page of the gallery, alone in a new interpreter. Run with `make benchmark`.

Processor time, of a page and of what it starts, does not change with other work on the machine. The cache of compiled code is
as it is: the first run after a change of the sources compiles, the next one tells what a page costs from then on.
"""

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGES = ROOT / "docs" / "examples"
OUT = ROOT / "docs" / "benchmarks" / "gallery.md"
#: What a page may take [s].
MOST = 20.0


def processor_time(page: Path) -> float:
    """Processor time [s] of one page and of what it starts."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "MPLBACKEND": "Agg", "TMPDIR": folder}
        subprocess.run([sys.executable, page], check=True, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    times = {}
    for page in sorted(PAGES.glob("**/plot_*.py")):
        name = page.relative_to(PAGES).with_suffix("").as_posix()
        times[name] = processor_time(page)
        print(f"{name:40s} {times[name]:6.1f} s", flush=True)
    lines = ["| page | processor time [s] |", "|---|---|", *(f"| {name} | {time:.1f} |" for name, time in times.items())]
    lines.append(f"| all {len(times)} | {sum(times.values()):.0f} |")
    OUT.write_text("\n".join(lines) + "\n")
    slow = [name for name, time in times.items() if time > MOST]
    if slow:
        sys.exit(f"longer than {MOST:g} s: {', '.join(slow)}")


if __name__ == "__main__":
    main()
