"""The programs of README.md and the start page are correctly typed, for mypy --strict and for pyright."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import manipplan

ROOT = Path(manipplan.__file__).parents[1]
PROGRAMS = ["README.md", "docs/start.md"]
#: Pages whose programs are checked together; in viewer.md two viewers of different kinds share a name.
HOW_TOS = [
    *sorted((ROOT / "docs" / "howto").glob("*.md")),
    *(ROOT / "docs" / "tutorials" / f"{name}.md" for name in ("cell", "weld", "teleoperation")),
]
#: Commands that check a file. basedpyright is pyright as a wheel, with its own Node. Runs of mypy share what they know of packages.
CHECKERS = {
    "mypy": [sys.executable, "-m", "mypy", "--strict", "--config-file=", f"--cache-dir={os.environ['MANIPPLAN_CACHE']}/mypy"],
    "pyright": [sys.executable, "-m", "basedpyright", "--pythonpath", sys.executable, "--level", "error"],
}
#: With throw=False a plan may be incomplete, so its trajectory may be None.
INCOMPLETE = """
import manipplan as mp

plan = mp.plan(mp.load_robot("panda"), [0.0] * 7, [0.1] * 7, throw=False)
print(plan.trajectory.duration)
"""


def program_of(page):
    """All Python blocks of a page that are run, as one program."""
    found = re.findall(r"(<!-- not run: .*? -->\n)?```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)
    return "\n".join(code for skipped, code in found if not skipped)


def checked(checker, program, folder):
    """The finished process of a checker on a program."""
    (folder / "program.py").write_text(program, encoding="utf-8")
    return run([*CHECKERS[checker], "program.py"], folder)


def run(command, folder):
    """The finished process of a command in a folder, for which the sources of this library are on the path."""
    paths = {"MYPYPATH": str(ROOT), "PYTHONPATH": str(ROOT)}
    return subprocess.run(command, cwd=folder, env=os.environ | paths, capture_output=True, text=True, timeout=600, check=False)


@pytest.mark.parametrize("checker", CHECKERS)
@pytest.mark.parametrize("page", PROGRAMS)
def test_programs_of_the_first_pages_are_typed(page, checker, tmp_path):
    program = program_of(page)
    assert "mp.plan(" in program
    done = checked(checker, program, tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_programs_of_all_how_tos_and_tutorials_are_typed(tmp_path):
    pages = {page.stem.replace("-", "_"): str(page.relative_to(ROOT)) for page in HOW_TOS if page.stem != "viewer"}
    programs = {f"{name}.py": program_of(page) for name, page in pages.items()}
    for file, program in programs.items():
        (tmp_path / file).write_text(program, encoding="utf-8")
    done = run([*CHECKERS["mypy"], "--disable-error-code=import-untyped", *programs], tmp_path)  # scipy has no types
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("checker", CHECKERS)
def test_what_may_be_missing_is_typed_so(checker, tmp_path):
    done = checked(checker, INCOMPLETE, tmp_path)
    assert done.returncode == 1, done.stdout + done.stderr
    assert "None" in done.stdout
    assert len(re.findall(r"error:", done.stdout)) == 1
