"""The command of a study: its options, a bar, where it writes, and what is not as expected."""

import argparse
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeVar

from rich.console import Console
from rich.progress import Progress

Claims = TypeVar("Claims")
#: What is done, about how long it takes [s], and how it is done.
Stage = tuple[str, float, Callable[[], object]]


def run(
    pages: Path,
    quick: str,
    study: Callable[[Path, bool, Progress], Claims],
    differences: Callable[[Claims, bool], list[str]],
    arguments: list[str] | None,
) -> list[str]:
    """Run `study` and return what is not as expected; `pages` is its folder in the docs, `quick` what --quick leaves."""
    parser = argparse.ArgumentParser(prog=f"python -m studies.{pages.name}", description="The whole study in one command.")
    parser.add_argument("--quick", action="store_true", help=quick)
    where = f"folder for tables and figures (default: docs/studies/{pages.name}; a temporary one with --quick)"
    parser.add_argument("--out", type=Path, help=where)
    options = parser.parse_args(arguments)
    out = options.out or (Path(tempfile.mkdtemp(prefix=f"{pages.name}-")) if options.quick else pages)
    out.mkdir(parents=True, exist_ok=True)
    console = Console()
    began = time.monotonic()
    with Progress(console=console, transient=True) as progress:
        found = study(out, options.quick, progress)
    wrong = differences(found, options.quick)
    console.print(f"{out} written in {time.monotonic() - began:.0f} s")
    for line in wrong or ["all figures are as expected"]:
        console.print(line, markup=False)
    return wrong


def in_stages(name: str, stages: Sequence[Stage], progress: Progress) -> None:
    """Do one after the other, and show how far it is."""
    bar = progress.add_task(name, total=sum(weight for _, weight, _ in stages))
    for text, weight, do in stages:
        progress.update(bar, description=text)
        do()
        progress.update(bar, advance=weight)
