"""All errors and warnings that manipplan raises on purpose; `ManipplanError` is the root of the errors."""

from manipplan.support.errors import (
    CompilerError,
    CompilerWarning,
    FileFormatError,
    InvalidInputError,
    ManipplanError,
    MissingExtraError,
    MissingProgramError,
    MissingSourcesError,
    OutOfReachError,
    PlanningError,
    RobotNotFetchedError,
    UnknownNameError,
    UnsupportedJointError,
)

__all__ = [
    "CompilerError",
    "CompilerWarning",
    "FileFormatError",
    "InvalidInputError",
    "ManipplanError",
    "MissingExtraError",
    "MissingProgramError",
    "MissingSourcesError",
    "OutOfReachError",
    "PlanningError",
    "RobotNotFetchedError",
    "UnknownNameError",
    "UnsupportedJointError",
]
