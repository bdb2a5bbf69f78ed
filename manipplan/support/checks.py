"""Checks of arguments that every public function shares: one clear error, before work starts; and tolerances, one per meaning.

Numbers from outside are rounded: poses to float32 or to some digits in a file, points to whatever a recorder keeps. What lies
within such a tolerance is taken to what was meant, once, where it comes in; from there on all work is exact.
"""

import operator
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray
from typing_extensions import TypeAliasType

from manipplan.support.errors import FileFormatError, InvalidInputError, UnknownNameError

#: Largest difference between an entry of a pose and that of the nearest rigid transform: float32, or five digits or more.
POSE = 1e-5
#: Up to this difference a pose is kept bit by bit: it is the rounding of a few products of rotations in double precision.
EXACT = 1e-12
#: Largest difference of a quaternion's length from 1: two digits or more. Its length says nothing of the rotation.
QUATERNION = 1e-2
#: Two points, configurations or poses nearer than this are one [rad or m]: a goal this near is reached.
COINCIDENT = 1e-6


#: Types of what is returned and of what is taken for an array; signatures show these names, not NumPy's private union.
Array = TypeAliasType("Array", NDArray[np.float64])
ArrayLike = TypeAliasType("ArrayLike", npt.ArrayLike)
T = TypeVar("T")

LAST_ROW = np.array([0.0, 0.0, 0.0, 1.0])
#: Largest random seed; OMPL stores it in 32 bits.
LARGEST_SEED = 2**31 - 1
#: Bounds on every number and every whole number, on entries of configurations [rad or m], beyond which an angle has lost its
#: digits, and on positions [m].
LARGEST, LARGEST_COUNT, LARGEST_ANGLE, FARTHEST = 1e12, 10**9, 1e8, 1e6
#: Maximum number of threads.
MOST_THREADS = 1024
#: Smallest number above zero that can be divided by without overflow.
SMALLEST = 1e-100


def read_only(array: Array) -> Array:
    """The array itself, which nobody can write to from now on."""
    array.flags.writeable = False
    return array


def finite_array(argument: str, value: ArrayLike, shape: tuple[int | None, ...], *, most: float = LARGEST) -> Array:
    """`value` as a read-only float array of `shape` (None: any length), every entry finite and within ±`most`."""
    array = number_array(argument, value)
    if array.ndim != len(shape) or any(want not in (None, have) for want, have in zip(shape, array.shape, strict=True)):
        wanted = "(" + ", ".join("any" if k is None else str(k) for k in shape) + ("," if len(shape) == 1 else "") + ")"
        raise InvalidInputError(argument, value, f"numbers of shape {wanted}, not {array.shape}")
    _all_finite(argument, value, array)
    return _within(argument, value, array, most)


def configurations(argument: str, value: ArrayLike, n: int) -> Array:
    """`value` as configurations of shape (..., n) [rad or m], every entry finite."""
    array = number_array(argument, value)
    if array.ndim == 0 or array.shape[-1] != n:
        raise InvalidInputError(argument, value, f"one value per joint, shape ({n},) or (..., {n}), not {array.shape}")
    return _within(argument, value, _all_finite(argument, value, array), LARGEST_ANGLE)


def positive_array(argument: str, value: ArrayLike, n: int) -> Array:
    """`value`, one number or n of them, as a read-only array (n,), each > 0 (inf: no limit)."""
    array = number_array(argument, value)
    if array.shape not in ((), (n,)):
        raise InvalidInputError(argument, value, f"one number or {n} of them, one per joint")
    if not (array >= SMALLEST).all():
        tiny = f", at least {SMALLEST:g}" if (array > 0).all() else ""
        raise InvalidInputError(argument, value, f"numbers above zero{tiny} (inf where there is no limit)")
    return read_only(np.broadcast_to(array, (n,)).copy())


def pose_matrix(argument: str, value: Any) -> Array:
    """A pose, (4, 4) or pin.SE3, as a read-only matrix (4, 4): the rigid transform nearest to it, at most `POSE` away."""
    matrix = finite_array(argument, getattr(value, "homogeneous", value), (4, 4))
    wanted = "a rotation and a translation: a (4, 4) matrix, or a pin.SE3"
    rotation, off = nearest_rotation(matrix[:3, :3])
    if np.abs(matrix[3] - LAST_ROW).max() > POSE:
        raise InvalidInputError(argument, matrix.tolist(), f"{wanted}; its last row has to be 0 0 0 1")
    if off > POSE:
        raise InvalidInputError(argument, matrix.tolist(), f"{wanted}; {_no_rotation(matrix[:3, :3], off)}")
    _within(argument, value, matrix[:3, 3], FARTHEST)
    if off == 0.0 and (matrix[3] == LAST_ROW).all():
        return matrix
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation, matrix[:3, 3]
    return read_only(pose)


def rotation_matrix(argument: str, value: ArrayLike, wanted: str = "a rotation matrix (3, 3)") -> Array:
    """A rotation as a read-only matrix (3, 3): the one nearest to `value`, at most `POSE` away."""
    matrix = finite_array(argument, value, (3, 3))
    rotation, off = nearest_rotation(matrix)
    if off > POSE:
        raise InvalidInputError(argument, matrix.tolist(), f"{wanted}; {_no_rotation(matrix, off)}")
    return read_only(rotation)


def unit_quaternion(argument: str, value: ArrayLike, order: str) -> Array:
    """A quaternion (4,) of length 1, from one whose length differs from that by at most `QUATERNION`; `order`: "x, y, z, w"."""
    wanted = f"a quaternion {order} of length 1"
    quaternion = finite_array(argument, value, (4,))
    if np.abs(quaternion).max() > 2.0:  # its square may overflow
        raise InvalidInputError(argument, quaternion.tolist(), wanted)
    length = float(np.linalg.norm(quaternion))
    if abs(length - 1.0) > QUATERNION:
        raise InvalidInputError(argument, quaternion.tolist(), f"{wanted}, not {length:.4g}")
    return np.asarray(quaternion / length)


def unit_vector(argument: str, value: ArrayLike) -> Array:
    """The direction (3,) of `value`, a vector (3,) that is not zero, with length 1."""
    direction = finite_array(argument, value, (3,))
    return direction / number(f"the length of {argument}", float(np.linalg.norm(direction)), above=1e-9)


def nearest_rotation(matrix: Array) -> tuple[Array, float]:
    """The rotation nearest to a finite matrix (3, 3), and the largest difference of an entry.

    A matrix that is a rotation up to `EXACT` is its own nearest one, with the difference 0.
    """
    if np.abs(matrix).max() <= 2.0 and np.abs(matrix.T @ matrix - np.eye(3)).max() <= EXACT and _volume(matrix) > 0:
        return matrix, 0.0
    left, _, right = np.linalg.svd(matrix)
    left[:, 2] *= np.sign(_volume(left @ right))
    return left @ right, float(np.abs(left @ right - matrix).max())


def _volume(matrix: Array) -> float:
    """The determinant of a matrix (3, 3)."""
    return float(np.cross(matrix[0], matrix[1]) @ matrix[2])


def _no_rotation(matrix: Array, off: float) -> str:
    """Why a matrix (3, 3) is no rotation, where the nearest one is `off` away."""
    if not matrix.any():
        return "it is zero"
    if _volume(matrix / np.abs(matrix).max()) < 0:
        return "it mirrors: its determinant is negative"
    return f"it differs by {off:.3g} from the nearest rotation, and at most {POSE:g} counts as rounding"


def number(argument: str, value: Any, *, above: float = -np.inf, least: float = -np.inf, most: float = LARGEST) -> float:
    """`value` as one finite float, > above, >= least, <= most."""
    wanted = ["a finite number"]
    if np.isfinite(above):
        wanted.append(f"above {above:g}")
    if np.isfinite(least):
        wanted.append(f"at least {least:g}")
    result = _as_float(value)
    if most != LARGEST or result > most:
        wanted.append(f"at most {most:g}")
    if not (np.isfinite(result) and result > above and least <= result <= most):
        raise InvalidInputError(argument, value, ", ".join(wanted))
    return result


def _as_float(value: Any) -> float:
    """`value` as a float: inf where it is too large, nan where it is no number."""
    if isinstance(value, bool) or not isinstance(value, int | float | np.floating | np.integer):
        return np.nan
    try:
        return float(value)
    except OverflowError:
        return np.inf


def whole_number(argument: str, value: Any, *, least: int, most: int = LARGEST_COUNT) -> int:
    """`value` as an int >= least and <= most."""
    is_whole = not isinstance(value, bool) and isinstance(value, int | np.integer)
    result = operator.index(value) if is_whole else least - 1
    if not least <= result <= most:
        upper = f", at most {most}" if most != LARGEST_COUNT or result > most else ""
        raise InvalidInputError(argument, value, f"a whole number, at least {least}{upper}")
    return result


def random_seed(argument: str, value: Any) -> int:
    """`value` as a random seed: a whole number from 0 to `LARGEST_SEED`."""
    return whole_number(argument, value, least=0, most=LARGEST_SEED)


def instance(argument: str, value: Any, kind: type[T]) -> T:
    """`value`, checked to be a `kind`."""
    if not isinstance(value, kind):
        raise InvalidInputError(argument, value, f"a {kind.__name__}")
    return value


def path_of(argument: str, value: Any) -> Path:
    """`value`, the path of a file or folder, with the user's home folder in place of `~`."""
    if not isinstance(value, str | Path):
        raise InvalidInputError(argument, value, "the path of a file or folder")
    try:
        os.fsencode(value)
        return Path(value).expanduser()
    except (RuntimeError, UnicodeEncodeError) as error:  # ~ of an unknown user, half of a character
        raise InvalidInputError(argument, str(value), f"a path ({error})") from error


def is_folder(path: Path) -> bool:
    """Whether there is such a folder; a path that the system refuses, such as one that is too long, is none."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


def flag(argument: str, value: Any) -> bool:
    """`value` as a bool; numbers and texts are no flags."""
    if not isinstance(value, bool | np.bool_):
        raise InvalidInputError(argument, value, "True or False")
    return bool(value)


def text(argument: str, value: Any) -> str:
    """`value`, checked to be a text."""
    if not isinstance(value, str):
        raise InvalidInputError(argument, value, "a text")
    return str(value)


def one_of(argument: str, value: Any, known: Iterable[str], *, empty: str = "none") -> str:
    """`value`, checked to be one of the names that are `known`; `empty` is what is allowed where there are none."""
    known = list(known)
    if not isinstance(value, str):
        raise InvalidInputError(argument, value, f"one of {', '.join(map(repr, known[:12]))}" if known else empty)
    if value not in known:
        raise UnknownNameError(argument, value, known, empty=empty)
    return str(value)


def texts(argument: str, value: Any) -> tuple[str, ...]:
    """`value` as a tuple of texts; a single text is none."""
    return tuple(text(f"{argument}[{k}]", each) for k, each in enumerate(entries(argument, value, "a list of names")))


def entries(argument: str, value: Any, wanted: str) -> tuple[Any, ...]:
    """The entries of a list, or of another value that can be iterated over; a text and a mapping are none."""
    try:
        if not isinstance(value, str | bytes | Mapping) and isinstance(value, Iterable):
            return tuple(value)
        reason = None
    except Exception as error:  # the iterator of a foreign object can raise any exception
        reason = error
    raise InvalidInputError(argument, value, wanted) from reason


def distinct_names(argument: str, value: Any, n: int) -> tuple[str, ...]:
    """`value` as n different names."""
    names = tuple(value) if isinstance(value, list | tuple | np.ndarray) else ()
    if (
        len(names) != n
        or not all(isinstance(name, str) and name and name.isprintable() for name in names)
        or len(set(names)) != n
    ):
        raise InvalidInputError(argument, value, f"{n} different names of printable characters")
    return tuple(str(name) for name in names)


def existing_file(argument: str, path: str | Path) -> Path:
    """`path` as an existing file; the error for a missing one lists similar names in the same folder."""
    path = path_of(argument, path)
    try:
        if path.is_file():
            return path
        folder = path.is_dir()
    except OSError as error:  # a name that is too long
        raise FileFormatError(argument, str(path), f"an existing file ({error.strerror})") from error
    if folder:
        raise FileFormatError(argument, str(path), "a file, not a folder")
    import difflib

    beside = [f.name for f in path.parent.iterdir() if f.is_file()] if path.parent.is_dir() else []
    near = difflib.get_close_matches(path.name, beside, n=3, cutoff=0.5)
    hint = f"; did you mean {', '.join(near)} in the same folder?" if near else ""
    raise FileFormatError(argument, str(path), f"an existing file{hint}")


def number_array(argument: str, value: ArrayLike) -> Array:
    """`value` as a new float array; raises InvalidInputError for anything but real numbers, so also for masked arrays."""
    try:
        raw = np.asarray(value)
        if raw.dtype.kind not in "iuf" or not _only_numbers(value):
            raise TypeError(raw.dtype)
        return np.array(raw, dtype=np.float64)
    except Exception as error:  # the __array__ of a foreign object can raise any exception
        masked = "; no value may be masked" if isinstance(value, np.ma.MaskedArray) else ""
        raise InvalidInputError(argument, value, f"real numbers{masked}") from error


def array_of_shape(argument: str, value: Any, shape: tuple[int, ...]) -> Array:
    """`value` as an array of `shape`, which may contain NaN; raises InvalidInputError for anything else."""
    array = number_array(argument, value)
    if array.shape != shape:
        raise InvalidInputError(argument, value, f"numbers of shape {shape}, not {array.shape}")
    return array


def _only_numbers(value: Any) -> bool:
    """Whether there is no truth value and no masked array in it: NumPy makes numbers of both."""
    if isinstance(value, list | tuple):
        return all(map(_only_numbers, value))
    return not isinstance(value, bool | np.bool_ | np.ma.MaskedArray)


def _within(argument: str, value: ArrayLike, array: Array, most: float) -> Array:
    if (np.abs(array) > most).any():
        raise InvalidInputError(argument, value, f"numbers from {-most:g} to {most:g}")
    return array


def _all_finite(argument: str, value: ArrayLike, array: Array) -> Array:
    if not np.isfinite(array).all():
        raise InvalidInputError(argument, value, "finite numbers, no NaN or inf")
    return read_only(array)
