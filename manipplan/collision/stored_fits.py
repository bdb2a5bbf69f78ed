"""Fitted primitives on disk, by the content of the mesh. Fitting takes seconds per arm and is done once per machine."""

import hashlib
import json
import logging
from pathlib import Path
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from manipplan.collision import fitting
from manipplan.collision.primitives import Primitive, outside
from manipplan.support.checks import Array, pose_matrix
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import private_folder, write_text

log = logging.getLogger("manipplan")

#: Class of each stored shape, and its number of sizes.
SHAPES = {"Box": (coal.Box, 3), "Sphere": (coal.Sphere, 1), "Capsule": (coal.Capsule, 2)}


def find_or_fit(triangles: Array, *, boxes: bool = True) -> list[Primitive]:
    """The primitives of `fit_primitives`, read from the cache folder if an earlier process stored them.

    Stored primitives are used only if they contain every triangle; otherwise the mesh is fitted again. Raises ManipplanError as
    `fit_primitives` does.
    """
    try:
        file = private_folder() / "primitives" / f"{_key(triangles, boxes)}.json"
        file.parent.mkdir(mode=0o700, exist_ok=True)
        stored = _read(file)
    except OSError as error:
        log.info("fitted primitives are not kept on disk: %s", error)
        return fitting.fit_primitives(triangles, boxes=boxes)
    if stored is not None and _contain(stored, fitting.subdivide(triangles)):
        return stored
    fitted = fitting.fit_primitives(triangles, boxes=boxes)
    try:
        write_text(file, json.dumps([_plain(each) for each in fitted]))
    except InvalidInputError as error:
        log.info("fitted primitives are not kept on disk: %s", error)
    return fitted


def _key(triangles: Array, boxes: bool) -> str:
    """Hash of the triangles, of `boxes`, of the source of fitting.py and of the versions of NumPy and SciPy."""
    import scipy

    parts = [Path(fitting.__file__).read_bytes(), f"{scipy.__version__} {np.__version__} {boxes}".encode()]
    return hashlib.sha256(b"\0".join([*parts, np.ascontiguousarray(triangles).tobytes()])).hexdigest()[:32]


def _read(file: Path) -> list[Primitive] | None:
    """The primitives of a file; None if there is no file, or it holds something else."""
    try:
        return [_primitive(entry) for entry in json.loads(file.read_text())]
    except FileNotFoundError:
        return None
    except (InvalidInputError, ValueError, TypeError, LookupError) as error:
        log.debug("%s is fitted again: %s", file, error)
        return None


def _contain(primitives: list[Primitive], triangles: Array) -> bool:
    """Whether each triangle (t, 3, 3) lies inside one of the primitives."""
    inside = np.zeros(len(triangles), dtype=bool)
    for primitive in primitives:
        inside |= (outside(primitive, triangles.reshape(-1, 3)) == 0).reshape(-1, 3).all(axis=1)
    return bool(inside.all())


def _plain(primitive: Primitive) -> dict[str, Any]:
    shape = primitive.shape
    if isinstance(shape, coal.Box):
        sizes = (2 * shape.halfSide).tolist()
    else:
        sizes = [shape.radius] if isinstance(shape, coal.Sphere) else [shape.radius, 2 * shape.halfLength]
    pose = primitive.placement.homogeneous.tolist()
    return {"shape": type(shape).__name__, "sizes": sizes, "pose": pose, "volume": primitive.volume}


def _primitive(entry: Any) -> Primitive:
    kind, count = SHAPES[entry["shape"]]
    sizes, pose = np.array(entry["sizes"], dtype=float), pose_matrix("pose", entry["pose"])
    if sizes.shape != (count,) or not (sizes >= 0).all():
        raise ValueError(f"sizes {sizes.tolist()} of a {entry['shape']}")
    return Primitive(shape=kind(*sizes), placement=pin.SE3(pose[:3, :3], pose[:3, 3]), volume=float(entry["volume"]))
