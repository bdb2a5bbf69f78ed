"""Time of `import manipplan` in a new interpreter, and what comes with it. Run with `make benchmark`."""

import statistics
import subprocess
import sys
import time
from pathlib import Path

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "import_time.md"
HEAVY = ("matplotlib", "ompl", "toppra", "scipy", "viser")


def seconds(code: str) -> float:
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", code], check=True)
    return time.perf_counter() - began


def main() -> None:
    seconds("import manipplan")
    whole = statistics.median(seconds("import manipplan") for _ in range(11))
    bare = statistics.median(seconds("pass") for _ in range(11))
    code = f"import sys, manipplan; print(' '.join(name for name in {HEAVY!r} if name in sys.modules))"
    brought = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.strip()
    lines = [
        "| figure | value |",
        "|---|---|",
        f"| `import manipplan`, median of 11 new interpreters, less that of an empty one | {whole - bare:.2f} s |",
        f"| of {', '.join(HEAVY)} imported along | {brought or 'none'} |",
    ]
    OUT.parent.mkdir(parents=True, exist_ok=True)
    OUT.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
