"""A study as a command: output folder, progress, and differences from the expected results."""

import argparse
import shutil
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from rich import progress as bars

from studies import printed

Claims = TypeVar("Claims")
#: A function of the share of the work that is done, in [0, 1], and a text that names the current step.
Progress = Callable[[float, str], None]
#: Name of the stage, its approximate duration [s], and the function that runs it.
Stage = tuple[str, float, Callable[[], object]]


@dataclass(frozen=True, kw_only=True)
class Study(Generic[Claims]):
    """All tables and figures of a paper.

    Attributes:
        pages: folder of its tables and figures in the docs; the page itself is next to it, with the same name.
        quick: help text of --quick: the parts of the study that it runs.
        make: writes tables and figures into a folder, with or without --quick, and returns the results.
        differences: compares the results, with or without --quick, with expected.csv; returns one line per difference.
    """

    pages: Path
    quick: str
    make: Callable[[Path, bool, Progress], Claims]
    differences: Callable[[Claims, bool], list[str]]

    def run(self, out: Path, *, quick: bool, progress: Progress) -> printed.Comparison:
        """Write tables and figures into `out`, and compare every number with expected.csv and with the pages."""
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory() as before:
            pages = Path(before) / self.pages.name
            shutil.copytree(self.pages, pages)  # the run may write over them
            expected = self.differences(self.make(out, quick, progress), quick)
            found = printed.compare(out, pages, quick=quick)
        found.differences = [*expected, *found.differences]
        return found

    def main(self, arguments: list[str] | None = None) -> list[str]:
        """Run the study with command-line arguments; returns the differences from the expected results."""
        command, what = f"python -m studies.{self.pages.name}", "Reproduce all tables and figures of the paper."
        parser = argparse.ArgumentParser(prog=command, description=what)
        parser.add_argument("--quick", action="store_true", help=self.quick)
        where = f"folder for tables and figures (default: docs/studies/{self.pages.name}; a temporary one with --quick)"
        parser.add_argument("--out", type=Path, help=where)
        options = parser.parse_args(arguments)
        out = options.out or (Path(tempfile.mkdtemp(prefix=f"{self.pages.name}-")) if options.quick else self.pages)
        with bars.Progress(transient=True) as bar:
            task = bar.add_task("", total=1.0)

            def notify(share: float, text: str) -> None:
                bar.update(task, completed=share, description=text)

            found = self.run(out, quick=options.quick, progress=notify)
        if out == self.pages:
            printed.stamp(out, self.pages.name)
        lines = (*(found.differences or [f"all figures are as expected: {found.summary}"]), f"wrote {out}")
        bar.console.print("\n".join(lines), markup=False, highlight=False, soft_wrap=True)
        return found.differences


def in_stages(stages: Sequence[Stage], notify: Progress) -> None:
    """Run the stages in order and report the progress."""
    whole, done = sum(weight for _, weight, _ in stages), 0.0
    for text, weight, do in stages:
        notify(done / whole, text)
        do()
        done += weight
