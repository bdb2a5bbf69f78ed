"""The code of every page runs as it stands, and prints what the page says that it prints.

The Python blocks of a page run one after the other, as one program. A `text` block right after a Python block holds what it
prints. Whole numbers are the same to a thousandth. Numbers with a decimal point may differ by a thousandth, or by one in the last digit that
is printed: processors round differently, a converged g agrees to 1e-6, durations and clearances to 1e-3, and a figure
between two roundings can be printed as either. `<!-- not run: reason -->` before a block leaves it out. Lines of a `sh` block that begin with `manipplan` are run, too, in a folder that has the page's YAML blocks as scene.yaml.
"""

import re
import shlex
import subprocess
import sys
from decimal import Decimal
from pathlib import Path

import pytest

PAGES = Path(__file__).parents[2] / "docs"
BLOCK = re.compile(r"(<!-- not run: [^>]+ -->\n)?```(python|sh|yaml)\n(.*?)```(?:\n\n```text\n(.*?)```)?", re.DOTALL)
AT_THE_LIMIT = re.compile(r"(% of the limit), \w+ at [\d.]+ s")
USE = re.compile(r"([\d.]+) % of the limit")
NUMBER = re.compile(r"-?\d+(?:[.,]\d+)*(?:e[-+]?\d+)?")
GENERATED = {"_build", "gallery", "benchmarks"}
#: What no page prints: a reader wants the value behind it, and what has to hold is asserted.
BARE = re.compile(r"\b(True|False|None)\b")
#: Calls that lead to a motion, and what a page says about it.
MOTION = re.compile(r"\bmp\.(plan|optimize_path|follow|track|sequence|carry|improve|check)\(")
OUTCOME = re.compile(r"\.status|\.passed|\.faults|print\((plan|report)\.(report|comparison)\)")


def blocks(page, language):
    """(code, what it prints or "") of the blocks of one language that are run."""
    found = BLOCK.findall((PAGES / page).read_text(encoding="utf-8"))
    return [(code, printed) for skipped, kind, code, printed in found if kind == language and not skipped]


def pages_with(language):
    pages = (file.relative_to(PAGES) for file in sorted(PAGES.rglob("*.md")))
    return [page.as_posix() for page in pages if page.parts[0] not in GENERATED and blocks(page, language)]


def last_digit(number):
    """One in the last printed digit of a number with a decimal point, else 0."""
    return 10.0 ** Decimal(number).as_tuple().exponent if "." in number else 0.0


def assert_printed(wanted, got, where):
    """The words are the same, and numbers to a thousandth or one in their last digit.

    Which joint is the nearest to its limit, and when, is not compared: in a timed motion several reach it, to rounding.
    How much of a limit is used that does not bind follows from the others, and is compared to a tenth.
    """
    wanted, got = (AT_THE_LIMIT.sub(r"\1", each) for each in (wanted, got))
    for a, b in zip(USE.findall(wanted), USE.findall(got), strict=True):
        assert float(b) == pytest.approx(float(a), rel=1e-3 if float(a) > 95 else 0.1), f"{where} prints {b} for {a}\n{got}"
    wanted, got = (USE.sub("of the limit", each) for each in (wanted, got))
    assert NUMBER.sub("#", wanted).split() == NUMBER.sub("#", got).split(), f"{where} prints\n{got}"
    for a, b in zip(NUMBER.findall(wanted.replace(",", "")), NUMBER.findall(got.replace(",", "")), strict=True):
        digit = 1.001 * max(last_digit(a), last_digit(b))
        assert float(a) == pytest.approx(float(b), rel=1e-3, abs=digit), f"{where} prints {b} for {a}\n{got}"


def test_there_is_code_on_the_pages():
    assert {"start.md", "index.md", "howto/shell.md", "concepts/tracking.md"} <= {*pages_with("python"), *pages_with("sh")}


@pytest.mark.parametrize("page", pages_with("python"))
def test_a_page_prints_values_instead_of_truths(page):
    shown = [printed for _, printed in blocks(page, "python") if BARE.search(printed)]
    assert shown == []


@pytest.mark.parametrize("page", [page for page in pages_with("python") if page.startswith("howto/")])
def test_a_how_to_that_makes_a_motion_says_what_came_of_it(page):
    code = "".join(code for code, _ in blocks(page, "python"))
    assert OUTCOME.search(code) or not MOTION.search(code)


@pytest.mark.parametrize("page", pages_with("python"))
def test_the_code_of_a_page_runs(page, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    space = {"__name__": "__main__"}
    for code, printed in blocks(page, "python"):
        exec(compile(code, page, "exec"), space)
        got = capsys.readouterr().out
        if printed:
            assert_printed(printed, got, page)


@pytest.mark.parametrize("page", pages_with("sh"))
def test_the_commands_of_a_page_run(page, tmp_path):
    for scene, _ in blocks(page, "yaml"):
        (tmp_path / "scene.yaml").write_text(scene)
    lines = "\n".join(code for code, _ in blocks(page, "sh")).replace("\\\n", " ").splitlines()
    commands = [shlex.split(line, comments=True) for line in lines if line.startswith("manipplan ")]
    assert commands
    for command in commands:
        done = subprocess.run(
            [sys.executable, "-m", *command], cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False
        )
        assert done.returncode == 0, f"{' '.join(command)}\n{done.stdout}{done.stderr}"
