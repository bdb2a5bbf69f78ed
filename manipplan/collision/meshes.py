"""Meshes of the world: read from files, and replaced by the convex hulls of their connected parts."""

from pathlib import Path

import coal
import numpy as np

from manipplan.collision.primitives import mesh_triangles
from manipplan.robots.hulls import FARTHEST, convex_hull, has_hull
from manipplan.robots.ply import fault_of
from manipplan.support.checks import Array
from manipplan.support.errors import FileFormatError, InvalidInputError

#: Number of decimals to which corners [m] are rounded to find those that triangles share.
DECIMALS = 9


def hulls_of_file(argument: str, file: Path, scale: float) -> list[coal.CollisionGeometry]:
    """Convex hulls of the connected parts of a mesh file, with its corners multiplied by `scale`.

    Raises FileFormatError when it is no mesh, or one of its parts has no volume.
    """
    fault = fault_of(file) if file.suffix.lower() == ".ply" else None
    if fault is not None:
        raise FileFormatError(argument, str(file), f"a mesh (STL, OBJ, DAE, ...); {fault}")
    try:
        mesh = coal.MeshLoader(coal.NODE_TYPE.BV_OBBRSS).load(str(file), np.full(3, scale))
    except (ValueError, RuntimeError) as error:
        reason = " ".join(str(error).split())[:160]
        raise FileFormatError(argument, str(file), f"a mesh (STL, OBJ, DAE, ...); the loader says: {reason}") from error
    if not (mesh.num_tris and np.isfinite(np.array(mesh.vertices())).all()):
        raise FileFormatError(argument, str(file), "a mesh of triangles with finite vertices")
    try:
        return hulls_of_triangles(argument, mesh_triangles(mesh))
    except InvalidInputError as error:
        raise FileFormatError(argument, str(file), error.allowed) from error


def hulls_of_triangles(argument: str, triangles: Array) -> list[coal.CollisionGeometry]:
    """Convex hulls of the connected parts of triangles (t, 3, 3) [m]; raises InvalidInputError when one has no volume."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    if not len(triangles):
        raise InvalidInputError(argument, "no triangles", "at least one triangle")
    vertices, same = np.unique(triangles.reshape(-1, 3).round(DECIMALS), axis=0, return_inverse=True)
    faces = same.reshape(-1, 3)
    links = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]]])
    graph = coo_array((np.ones(len(links)), (links[:, 0], links[:, 1])), shape=(len(vertices),) * 2)
    count, part_of = connected_components(graph, directed=False)
    hulls = []
    for part in range(count):
        corners = vertices[part_of == part]
        if not has_hull(corners):
            wanted = f"a mesh whose parts have a volume, with corners within {FARTHEST:g} m; one part is flat or too far away"
            raise InvalidInputError(argument, f"{len(triangles)} triangles", wanted)
        hulls.append(convex_hull(corners))
    return hulls
