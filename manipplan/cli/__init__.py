"""The command `manipplan`: the jobs from a shell.

Exit codes: 0 done, 1 no result, or a trajectory that does not pass `check`, 2 invalid input, such as a misspelt name, 3 a
checked motion that does not meet the request (its status says why), 4 a pose out of reach, 130 interrupted.
"""

import logging
import os
import sys
from collections.abc import Callable, Sequence
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


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit code and prints errors on one line, without a traceback."""
    log = logging.StreamHandler()
    log.setFormatter(_Printable())
    logging.basicConfig(level=logging.WARNING, handlers=[log])
    logging.getLogger("toppra").setLevel(logging.ERROR)
    logging.getLogger("manipplan.support.compiling.compiler").setLevel(logging.INFO)
    errors = Console(stderr=True)
    given = sys.argv[1:] if arguments is None else list(arguments)
    if given == ["--version"]:
        show_line(Console(), f"manipplan {version('manipplan')}")
        return 0
    try:
        code = tyro.extras.subcommand_cli_from_dict(
            COMMANDS,
            prog="manipplan",
            description="Robot-arm motion that stays away from singularities. --version prints the version.",
            args=arguments,
        )
    except ManipplanError as error:
        show_line(errors, f"manipplan: {error}", style="red")
        if isinstance(error, OutOfReachError):
            return 4
        return 2 if isinstance(error, InvalidInputError | MissingExtraError) else 1
    except KeyboardInterrupt:
        errors.print("manipplan: interrupted; finished files are complete, and no partial file is left", style="red")
        return 130
    return code or 0


class _Printable(logging.Formatter):
    """Formats the message alone, without control characters from names in it."""

    def format(self, record: logging.LogRecord) -> str:
        return printable(super().format(record))


def run() -> None:
    """Entry point of the console script."""
    try:
        sys.exit(main())
    except BrokenPipeError:  # what reads the output has ended, such as `head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
