"""The command `manipplan`: the jobs from a shell.

Exit codes: 0 done, 1 no result, or a trajectory that does not pass `check`, 2 invalid input, such as a misspelt name, 3 a
checked motion that does not meet the request (its status says why), 4 a pose out of reach, 130 interrupted.
"""

import io
import logging
import os
import re
import sys
from collections.abc import Callable, Sequence
from contextlib import redirect_stderr
from functools import partial, wraps
from importlib.metadata import version

import tyro
from rich.console import Console

from manipplan.cli import commands
from manipplan.cli.doctor import doctor
from manipplan.cli.terminal import show_line
from manipplan.support.errors import InvalidInputError, ManipplanError, MissingExtraError, OutOfReachError
from manipplan.support.untrusted import printable

NAMES = ("demo", "plan", "run", "follow", "improve", "check", "view", "study", "robots")
COMMANDS: dict[str, Callable[..., int | None]] = {name: getattr(commands, name) for name in NAMES} | {"doctor": doctor}
DESCRIPTION = (
    "Robot-arm motion that stays away from singularities. --version prints the version; --tyro-print-completion bash, zsh or "
    "tcsh prints the completion for that shell."
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit code and prints errors on one line, without a traceback."""
    log = logging.StreamHandler()
    log.setFormatter(_Printable())
    logging.basicConfig(level=logging.WARNING, handlers=[log])
    logging.getLogger("toppra").setLevel(logging.ERROR)
    logging.getLogger("manipplan.support.compiler").setLevel(logging.INFO)
    errors = Console(stderr=True)
    given = sys.argv[1:] if arguments is None else list(arguments)
    if given == ["--version"]:
        show_line(Console(), f"manipplan {version('manipplan')}")
        return 0
    boxes = io.StringIO()
    try:
        with redirect_stderr(boxes):
            work = tyro.extras.subcommand_cli_from_dict(
                {name: _later(command) for name, command in COMMANDS.items()},
                prog="manipplan",
                description=DESCRIPTION,
                args=arguments,
            )
        code = work()
    except SystemExit as end:
        if not end.code:  # a help text was printed
            raise
        show_line(errors, f"manipplan: {unboxed(boxes.getvalue())}", style="red")
        return 2
    except ManipplanError as error:
        show_line(errors, f"manipplan: {error}", style="red")
        if isinstance(error, OutOfReachError):
            return 4
        return 2 if isinstance(error, InvalidInputError | MissingExtraError) else 1
    except KeyboardInterrupt:
        errors.print("manipplan: interrupted; finished files are complete, and no partial file is left", style="red")
        return 130
    return code or 0


def _later(command: Callable[..., int | None]) -> Callable[..., Callable[[], int | None]]:
    """The command with its arguments, which is run when these have been read."""

    @wraps(command)
    def with_arguments(*values: object, **options: object) -> Callable[[], int | None]:
        return partial(command, *values, **options)

    return with_arguments


#: What tyro says, and what we say instead.
REWORDED = {
    r"Error parsing (\S+): invalid literal for int\(\) with base 10: (.*)": r"\1: got \2; allowed: a whole number",
    r"Error parsing (\S+): could not convert string to float: (.*)": r"\1: got \2; allowed: a number",
    r"invalid choice (\S+) for argument '(\S+)'\. Expected one of \((.*)\)": r"\2: got \1; allowed: \3",
    r"Missing value for argument '(\S+)'\. Expected 1 values": r"\1: a value is missing",
    r"Error parsing (\S+): no type matching .* could be instantiated from \[(.*)\]": r"\1: got [\2], not what it takes",
    r"Got errors: .*": "",
    r"Missing from .*: (.*)": r"missing: \1",
    r"Argument helptext: (.*)": r"\1",
    r"For full helptext, \w+:? (.*)": r"for help: \1",
}


def unboxed(text: str) -> str:
    """The sentences in a box of tyro on one line, without the title of the box and without the help texts below options."""
    lines = [line.strip("╭╮╰╯│─").rstrip("─ ") for line in text.splitlines()[1:]]
    lines = ["" if set(line) <= set("- ") else line for line in lines]
    least = min((len(line) - len(line.lstrip()) for line in lines if line), default=0)
    shallow = "\n".join(line.strip() for line in lines if not line.startswith((least + 8) * " "))
    parts = [" ".join(part.split()).rstrip(".") for part in shallow.strip().split("\n\n")]
    return "; ".join(filter(None, map(_reworded, parts)))


def _reworded(sentence: str) -> str:
    for said, ours in REWORDED.items():
        sentence = re.sub(f"^{said}$", ours, sentence)
    return sentence


class _Printable(logging.Formatter):
    """Formats the message alone, without control characters from names in it."""

    def format(self, record: logging.LogRecord) -> str:
        return printable(super().format(record))


def run() -> None:
    """Entry point of the console script."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a terminal without, say, superscripts shows question marks
            stream.reconfigure(errors="replace")
    try:
        sys.exit(main())
    except BrokenPipeError:  # what reads the output has ended, such as `head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
