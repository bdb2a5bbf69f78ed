"""Time of each page of the gallery, alone in a new interpreter. Run with `make benchmark`.

Each page runs twice, and the second run counts: the first one fills the cache of compiled code where it is empty.
"""

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGES = ROOT / "docs" / "examples"
OUT = ROOT / "docs" / "benchmarks" / "gallery.md"
#: What a page may take [s].
MOST = 20.0


def run(page: Path) -> tuple[float, float]:
    """Wall and processor time [s] of one page and of what it starts."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "MPLBACKEND": "Agg", "TMPDIR": folder}
        subprocess.run([sys.executable, page], check=True, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
    wall, after = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    pages = sorted(PAGES.glob("**/plot_*.py"))
    rows = []
    for page in pages:
        run(page)
        wall, processor = run(page)
        rows.append((page.relative_to(PAGES).with_suffix("").as_posix(), wall, processor))
        print(f"{rows[-1][0]:40s} {wall:6.1f} s, processor {processor:6.1f} s", flush=True)
    lines = ["| page | wall time [s] | processor time [s] |", "|---|---|---|"]
    lines += [f"| {name} | {wall:.1f} | {processor:.1f} |" for name, wall, processor in rows]
    lines.append(f"| all {len(rows)} | {sum(row[1] for row in rows):.0f} | {sum(row[2] for row in rows):.0f} |")
    OUT.write_text("\n".join(lines) + "\n")
    slow = [name for name, wall, _ in rows if wall > MOST]
    if slow:
        sys.exit(f"longer than {MOST:g} s: {', '.join(slow)}")


if __name__ == "__main__":
    main()
