"""Every error that manipplan raises on purpose: one root, and children that carry the details.

An invalid argument raises at once (`InvalidInputError` and its children), before any work starts. A computation without a
solution raises `PlanningError`, which holds the result and its status; ``throw=False`` returns that result instead.
"""

import difflib
import inspect
import re
import reprlib
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any


class ManipplanError(Exception):
    """Root of all errors of this package; its messages hold plain numbers."""

    def __init__(self, *args: object) -> None:
        super().__init__(*(plain_numbers(each) if isinstance(each, str) else each for each in args))

    def __reduce__(self) -> tuple[Any, ...]:
        """Each class keeps its arguments as attributes of the same names; the root has those of every exception."""
        names = inspect.signature(type(self)).parameters
        return type(self), self.args if "args" in names else tuple(getattr(self, name) for name in names)


def plain_numbers(text: str) -> str:
    """The text with numbers as Python writes them, where it holds the representations of NumPy's."""
    return _NUMBER.sub(r"\1\2", text) if "np." in text else text


#: A number, or a truth value, as NumPy represents it.
_NUMBER = re.compile(r"np\.(?:float|longdouble|u?int)\w*\(([^()]*)\)|np\.(True|False)_")


class InvalidInputError(ManipplanError, ValueError):
    """An argument is invalid; the message names the argument, its value and what is allowed."""

    def __init__(self, argument: str, value: object, allowed: str) -> None:
        self.argument = argument
        self.value = value
        self.allowed = allowed
        allowed_text = plain_numbers(_cut_off(allowed, 2000))
        text = f"{_cut_off(argument, 400)}: got {_short(value)}; allowed: {allowed_text}"
        super(ManipplanError, self).__init__(text)  # as it is


@contextmanager
def inside(argument: str) -> Iterator[None]:
    """Errors of the block name their argument as a part of `argument`."""
    try:
        yield
    except InvalidInputError as error:
        raise InvalidInputError(f"{argument}.{error.argument}", error.value, error.allowed) from error


class UnknownNameError(InvalidInputError):
    """A name that does not exist, with the nearest names that do."""

    def __init__(self, argument: str, name: str, known: Iterable[str], *, empty: str = "none", others: str = "") -> None:
        """`empty`: what is allowed where no name is known; `others`: what is allowed beside the names."""
        self.known, self.empty, self.others = sorted(known), empty, others
        folded = {each.lower(): each for each in self.known}
        nearness = 0.5 if len(self.known) > FEW_NAMES else 0.7  # few names are listed rather than one that is hardly alike
        near = [folded[each] for each in difflib.get_close_matches(name.lower(), folded, n=3, cutoff=nearness)]
        if not near and len(name) >= 3:
            near = [each for each in self.known if name.lower() in each.lower()][:3]
        listed = ", ".join(near or self.known[:12])
        more = "" if near or len(self.known) <= 12 else f", ... ({len(self.known)} in all)"
        allowed = f"did you mean {listed}?" if near else f"one of {listed}{more}" if self.known else empty
        beside = f"{' Or' if near else ', or'} {others}" if others else ""
        super().__init__(argument, name, f"{allowed}{beside}")

    def __reduce__(self) -> tuple[Any, ...]:
        return partial(type(self), empty=self.empty, others=self.others), (self.argument, self.value, self.known)


class OutOfReachError(InvalidInputError):
    """A pose that no configuration inside the limits reaches.

    `nearest` is the configuration found that comes nearest: its `q` (n,), its distance `position` [m] and angle `rotation`
    [rad] from the pose, and the names of the joints that are `stopped` at a limit.
    """

    def __init__(self, argument: str, value: object, allowed: str, nearest: Any) -> None:
        self.nearest = nearest
        super().__init__(argument, value, allowed)


class FileFormatError(InvalidInputError):
    """A file that cannot be read as what it should be."""


@contextmanager
def reading(argument: str, file: object, wanted: str) -> Iterator[None]:
    """What goes wrong in a block that takes the data of a file apart becomes a FileFormatError with the reason."""
    try:
        yield
    except FileFormatError:
        raise
    except (ArithmeticError, AttributeError, LookupError, OSError, RecursionError, TypeError, ValueError) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:200]
        raise FileFormatError(argument, str(file), f"{wanted} ({reason})") from error


class UnsupportedJointError(InvalidInputError):
    """A joint of a kind that a serial chain of revolute and prismatic joints cannot contain."""


class MissingExtraError(ManipplanError, ImportError):
    """An optional package is not installed; the message holds the command that installs it."""

    def __init__(self, package: str, extra: str) -> None:
        self.package = package
        self.extra = extra
        super().__init__(f"{package} is not installed; install it with: pip install 'manipplan[{extra}]'")


class RobotNotFetchedError(ManipplanError):
    """The files of a robot of another collection are not on this machine and could not be fetched; `remedy` says what helps."""

    def __init__(self, robot: str, reason: str, remedy: str) -> None:
        self.robot = robot
        self.reason = reason
        self.remedy = remedy
        super().__init__(f"{robot} could not be fetched: {_cut_off(reason, 400)}; {remedy}")


class MissingSourcesError(ManipplanError, ImportError):
    """Something is part of the sources only, not of the installed package."""

    def __init__(self, subject: str) -> None:
        self.subject = subject
        super().__init__(
            f"{subject} are part of the sources, not of the installed package; in a clone of the repository, run "
            "make demo, then .venv/bin/manipplan study"
        )


class MissingProgramError(ManipplanError):
    """A program that is not a Python package is not installed; the message holds the command that installs it."""

    def __init__(self, program: str, install: str, otherwise: str) -> None:
        self.program = program
        self.install = install
        self.otherwise = otherwise
        super().__init__(f"{program} is not installed; install it with: {install}   ({otherwise})")


class CompilerError(ManipplanError):
    """Compilation failed: there is no compiler, or it reported an error. `output` is its message."""

    def __init__(self, subject: str, output: str) -> None:
        self.subject = subject
        self.output = output
        super().__init__(f"compiling {subject}: {output}")


class CompilerWarning(UserWarning):
    """The compiler failed; the same work is done more slowly without machine code."""


class PlanningError(ManipplanError):
    """No solution was found. `result` is what was computed, with its status; None when there is nothing."""

    def __init__(self, message: str, result: Any = None) -> None:
        self.result = result
        super().__init__(message)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (*self.args, self.result)


def _short(value: object) -> str:
    text = " ".join(_SHORT.repr(value).split())
    return _cut_off(text if isinstance(value, str) else plain_numbers(text), 160)


def _cut_off(text: str, longest: int) -> str:
    """The text, cut off after `longest` characters: it may hold text from a file."""
    return text if len(text) <= longest else text[: longest - 3] + "..."


class _Plain(reprlib.Repr):
    """Truncated representations: a value may hold a million numbers, or one that Python refuses to write."""

    def repr_int(self, x: int, level: int) -> str:
        if x.bit_length() > LONGEST_INT:
            return f"a whole number of {x.bit_length()} bits"
        return super().repr_int(x, level)


#: Number of names up to which all are listed where none is much like the one given.
FEW_NAMES = 8
#: Number of bits up to which a whole number is written out.
LONGEST_INT = 1000
_SHORT = _Plain()
_SHORT.maxlevel = 4
_SHORT.maxlist = _SHORT.maxtuple = _SHORT.maxdict = _SHORT.maxset = _SHORT.maxfrozenset = 60
_SHORT.maxstring = _SHORT.maxother = _SHORT.maxlong = 400
