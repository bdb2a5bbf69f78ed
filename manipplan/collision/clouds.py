"""Clouds of points: those of a depth image, fewer of them, and the tree over them that coal takes.

Files of points: PLY, PCD, NPY and NPZ.
"""

import tokenize
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any

import coal
import numpy as np

from manipplan.collision.surfaces import MERGED
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.mesh_files import first_of_rows, read_ply, triangle_tree
from manipplan.support.checks import Array, ArrayLike, number, number_array
from manipplan.support.errors import FileFormatError, InvalidInputError
from manipplan.support.memo import once_per_owner, state_without_memo

#: Distance of the corners of a point's triangle from the point [m]. For triangles without an area coal's distance to a sphere
#: is wrong, by metres.
TINY = 1e-7
TRIANGLE = TINY / np.sqrt(6.0) * np.array([[2.0, -1.0, -1.0], [-1.0, 2.0, -1.0], [-1.0, -1.0, 2.0]])


#: Maximum number of points that are read, and of those that are left after thinning: a tree over them takes 7 s and 1.3 GB per
#: million.
MOST_POINTS, MOST_KEPT = 5_000_000, 500_000


def thinned(argument: str, points: Array, spacing: float) -> Array:
    """Of points (k, 3), the first in each cube of edge `spacing` [m]; all of them for 0.

    Raises InvalidInputError when there is none, one is farther away than `FARTHEST`, or there are too many.
    """
    if not len(points):
        raise InvalidInputError(argument, "no points", "at least one point")
    if len(points) > MOST_POINTS:
        raise InvalidInputError(argument, f"{len(points):,} points", f"at most {MOST_POINTS:,}")
    farthest = np.abs(points).max()
    if not farthest <= FARTHEST:
        raise InvalidInputError(argument, f"a point at {farthest:g} m", f"points within {FARTHEST:g} m of the origin")
    if spacing != 0.0:
        points = np.asarray(points[np.sort(first_of_rows(np.floor(points / max(spacing, MERGED)))[0])])
    if len(points) > MOST_KEPT:
        wanted = f"at most {MOST_KEPT:,} points after thinning; give a larger spacing"
        raise InvalidInputError(argument, f"{len(points):,} points with a spacing of {spacing:g} m", wanted)
    return points


class Points:
    """Points (k, 3) [m] and the tree over them, which is built when it is first needed."""

    def __init__(self, points: Array) -> None:
        self.points = points

    @once_per_owner
    def tree(self) -> coal.BVHModelOBBRSS:
        """A tree over the points: a triangle of size `TINY` about each."""
        corners = (self.points[:, None] + TRIANGLE).reshape(-1, 3)
        return triangle_tree(corners, np.arange(len(corners)).reshape(-1, 3))

    def __getstate__(self) -> dict[str, Any]:
        return state_without_memo(self)


def depth_points(image: ArrayLike, intrinsics: ArrayLike, farthest: float) -> Array:
    """The points (k, 3) [m], in the camera's frame, of the valid pixels of a depth image (h, w) [m].

    Invalid pixels are 0, negative, not finite or beyond `farthest`. Raises InvalidInputError when none is valid.
    """
    depth = number_array("image", image)
    if depth.ndim != 2:
        raise InvalidInputError("image", f"shape {depth.shape}", "depths of shape (h, w) [m]")
    given = number_array("intrinsics", intrinsics)
    if given.shape == (3, 3):
        given = np.array([given[0, 0], given[1, 1], given[0, 2], given[1, 2]])
    if given.shape != (4,) or not np.isfinite(given).all() or not (given[:2] > 0).all():
        raise InvalidInputError("intrinsics", intrinsics, "fx, fy above zero and cx, cy [pixels], or the matrix (3, 3) of them")
    if farthest != np.inf:
        farthest = number("farthest", farthest, above=0.0)
    with np.errstate(invalid="ignore"):
        rows, columns = np.nonzero(np.isfinite(depth) & (depth > 0) & (depth <= farthest))
    if not len(rows):
        raise InvalidInputError(
            "image", f"no valid pixel of {depth.size}", f"at least one depth above 0, at most {farthest:g} m"
        )
    fx, fy, cx, cy = given
    z = depth[rows, columns]
    return np.stack([(columns - cx) * z / fx, (rows - cy) * z / fy, z], axis=1)


#: Endings of the files that are read.
ENDINGS = (".ply", ".pcd", ".npy", ".npz")
#: NumPy's letters for the types of PCD.
KINDS = {"F": "f", "I": "i", "U": "u"}
#: Maximum size of a file, and of what a compressed one unpacks to [bytes].
MOST_BYTES = 256 * 2**20
#: Maximum number of packed bytes: unpacking takes about a second for every four million.
MOST_PACKED = 16 * 2**20
#: What reading a broken file raises; NumPy and zipfile raise the unusual ones.
READING = (
    *(ValueError, KeyError, IndexError, OSError, EOFError, OverflowError, MemoryError),
    *(zipfile.BadZipFile, zlib.error, tokenize.TokenError, SyntaxError, TypeError, NotImplementedError, RuntimeError),
)


def read_points(argument: str, file: Path) -> Array:
    """The finite points (k, 3) of a file; raises FileFormatError with the fault."""
    ending = file.suffix.lower()
    if ending not in ENDINGS:
        raise FileFormatError(argument, str(file), f"points in a file that ends with {', '.join(ENDINGS)}")
    try:
        if file.stat().st_size > MOST_BYTES:
            raise ValueError(f"it has {file.stat().st_size:,} bytes, of at most {MOST_BYTES:,}")
        if ending == ".ply":
            points = read_ply(file, rows=MOST_POINTS, faces=MOST_POINTS).vertices
        elif ending == ".pcd":
            points = _pcd(file.read_bytes())
        else:
            points = _numpy(file)
    except READING as error:
        reason = " ".join(str(error).split())[:160]
        raise FileFormatError(argument, str(file), f"points in the format {ending[1:].upper()}; {reason}") from error
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        raise FileFormatError(argument, str(file), "at least one finite point")
    return points


def _numpy(file: Path) -> Array:
    """The array of an NPY file, or of an NPZ file the one that is called points, or the only one."""
    if file.suffix.lower() == ".npz":
        with zipfile.ZipFile(file) as archive:
            if sum(each.file_size for each in archive.infolist()) > MOST_BYTES:
                raise ValueError(f"it unpacks to more than {MOST_BYTES:,} bytes")
            for each in archive.infolist():
                with archive.open(each) as stream:
                    _check_count(_read_count(stream))
    loaded = np.load(file, mmap_mode="r" if file.suffix.lower() == ".npy" else None, allow_pickle=False)
    if isinstance(loaded, Mapping):
        names = list(loaded)
        if "points" not in names and len(names) != 1:
            raise ValueError(f"its arrays are {', '.join(names)[:80] or 'none'}; one of them has to be called points")
        loaded = loaded["points" if "points" in names else names[0]]
    if loaded.ndim != 2 or loaded.shape[1] != 3 or loaded.dtype.kind not in "fiu":
        raise ValueError(f"an array of {loaded.dtype} of shape {loaded.shape} instead of numbers (k, 3)")
    _check_count(len(loaded))
    return np.array(loaded, dtype=float)


def _read_count(stream: IO[bytes]) -> int:
    """The number of rows that the header of an NPY file states."""
    version = np.lib.format.read_magic(stream)
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    shape = read(stream)[0]
    return shape[0] if shape else 0


def _check_count(points: int) -> None:
    """Raise ValueError for too many points, before they are made."""
    if points > MOST_POINTS:
        raise ValueError(f"{points:,} points, of at most {MOST_POINTS:,}")


def _pcd(data: bytes) -> Array:
    """The points of a PCD file: text, binary, or binary with LZF compression."""
    head, at = dict[str, list[str]](), 0
    while "DATA" not in head:
        end = data.find(b"\n", at)
        if end < 0:
            raise ValueError("no DATA line")
        words = data[at:end].decode("ascii", errors="replace").partition("#")[0].split()
        at = end + 1
        if words:
            head[words[0].upper()] = words[1:]
    fields = head["FIELDS"]
    sizes, counts = ([int(word) for word in head.get(key, ["1"] * len(fields))] for key in ("SIZE", "COUNT"))
    kinds = [f"<{KINDS[kind]}{size}" for kind, size in zip(head["TYPE"], sizes, strict=True)]
    if not len(fields) == len(sizes) == len(counts):
        raise ValueError("FIELDS, SIZE, TYPE and COUNT differ in length")
    extent = [int(head[key][0]) for key in ("WIDTH", "HEIGHT") if key in head]
    total = int(head["POINTS"][0]) if "POINTS" in head else extent[0] * extent[1]
    if min(extent, default=0) < 0 or (len(extent) == 2 and total != extent[0] * extent[1]):
        raise ValueError(f"{total} points are not its width times its height")
    if not {"x", "y", "z"} <= set(fields) or min(total, *counts, *sizes) < 0:
        raise ValueError(f"its fields are {' '.join(fields)[:80]}, {total} points")
    axes = [fields.index(axis) for axis in "xyz"]
    if any(counts[axis] != 1 for axis in axes):
        raise ValueError("x, y and z need COUNT 1")
    _check_count(total)
    row = sum(size * count for size, count in zip(sizes, counts, strict=True))
    body, form = data[at:], (head["DATA"] or [""])[0].lower()
    if form == "ascii":
        first = np.cumsum([0, *counts])
        values = body.split()
        if len(values) != total * first[-1]:
            raise ValueError(f"{len(values)} numbers instead of {total * first[-1]}")
        table = np.array(values, dtype=object).reshape(total, first[-1])
        return table[:, [first[axis] for axis in axes]].astype(float)
    if form == "binary_compressed":
        packed, size = (int(word) for word in np.frombuffer(body, "<u4", 2))
        if size != total * row or packed > min(len(body) - 8, MOST_PACKED) or size > MOST_BYTES:
            raise ValueError(f"{len(body)} bytes that unpack to {size}, for {total} points of {row} bytes")
        body = _lzf(body[8 : 8 + packed], size)
        first = total * np.cumsum([0, *(size * count for size, count in zip(sizes, counts, strict=True))])
        return np.stack([np.frombuffer(body, kinds[axis], total, first[axis]).astype(float) for axis in axes], axis=1)
    if form != "binary" or not total * row <= len(body) < (total + 1) * row:
        raise ValueError(f"{len(body)} bytes of {form!r} for {total} points of {row} bytes")
    kind = np.dtype([(f"{k}", kind, (count,)) for k, (kind, count) in enumerate(zip(kinds, counts, strict=True))])
    rows = np.frombuffer(body, kind, total)
    return np.stack([rows[f"{axis}"][:, 0].astype(float) for axis in axes], axis=1)


def _lzf(packed: bytes, size: int) -> bytes:
    """Data in the format LZF, unpacked: runs of bytes, and references to bytes before."""
    out, at = bytearray(), 0
    while at < len(packed):
        control = packed[at]
        at += 1
        if control < 32:  # a run of control + 1 bytes
            out += packed[at : at + control + 1]
            at += control + 1
        else:  # a reference: length in 3 bits, or 7 and another byte; distance in 13 bits
            length = control >> 5
            if length == 7:
                length += packed[at]
                at += 1
            start = len(out) - ((control & 31) << 8) - packed[at] - 1
            at += 1
            if not 0 <= start < len(out):
                raise ValueError("its compressed data refer to bytes before the first")
            copied = bytes(out[start : start + length + 2])  # repeated where the copy overlaps what it appends
            out += (copied * (1 + (length + 2) // len(copied)))[: length + 2]
        if len(out) > size:
            break
    if len(out) != size:
        raise ValueError(f"its compressed data unpack to {len(out)} bytes instead of {size}")
    return bytes(out)
