"""Triangle meshes of coal's shapes, for a browser."""

import coal
import numpy as np
from numpy.typing import NDArray

from manipplan.collision.primitives import core_of, mesh_triangles
from manipplan.support.checks import Array

#: Maximum number of triangles per mesh: a browser without a graphics card can still animate two arms of ten links.
MOST = 4000
#: Minimum angle of an edge that stays sharp under smooth shading [rad].
CREASE = 0.6
#: Half the side of the square that is drawn for a plane [m].
PLANE = 1.5

Faces = NDArray[np.int64]


def triangles_of(shape: coal.CollisionGeometry, most: int = MOST) -> tuple[Array, Faces] | None:
    """Vertices (v, 3) [m] in the shape's frame and faces (f, 3), about `most` of them for a mesh; None for an empty mesh.

    A shape of an unknown type is drawn as its bounding box.
    """
    from trimesh import creation

    if isinstance(shape, coal.BVHModelBase):
        return _reduced(*_mesh(shape), most)
    if isinstance(shape, coal.ConvexBase):
        return _hull(core_of(shape)[0])
    if isinstance(shape, coal.Halfspace | coal.Plane):
        return _square(np.asarray(shape.n), float(shape.d))
    if isinstance(shape, coal.Box):
        mesh = creation.box(2 * np.asarray(shape.halfSide))
        return np.asarray(mesh.triangles).reshape(-1, 3), np.arange(3 * len(mesh.faces)).reshape(-1, 3)  # sharp edges
    if isinstance(shape, coal.Sphere):
        mesh = creation.icosphere(subdivisions=3, radius=shape.radius)
    elif isinstance(shape, coal.Ellipsoid):
        mesh = creation.icosphere(subdivisions=3)
        mesh.apply_scale(np.asarray(shape.radii))
    elif isinstance(shape, coal.Capsule):
        mesh = creation.capsule(height=2 * shape.halfLength, radius=shape.radius, count=(24, 24))
        mesh.apply_translation(-mesh.bounds.mean(axis=0))
    elif isinstance(shape, coal.Cylinder):
        mesh = creation.cylinder(radius=shape.radius, height=2 * shape.halfLength, sections=40)
    elif isinstance(shape, coal.Cone):
        mesh = creation.cone(radius=shape.radius, height=2 * shape.halfLength, sections=40)
        mesh.apply_translation((0.0, 0.0, -shape.halfLength))
    else:
        return _hull(core_of(shape)[0])
    return _creased(np.asarray(mesh.vertices), np.asarray(mesh.faces))


def _mesh(shape: coal.BVHModelBase) -> tuple[Array, Faces]:
    """A mesh with coincident vertices merged."""
    vertices, index = np.unique(mesh_triangles(shape).reshape(-1, 3).round(6), axis=0, return_inverse=True)
    faces = index.reshape(-1, 3)
    flat = (faces == np.roll(faces, 1, axis=1)).any(axis=1)
    return vertices, faces[~flat]


def _reduced(vertices: Array, faces: Faces, most: int) -> tuple[Array, Faces] | None:
    import fast_simplification

    if not len(faces):
        return None
    if len(faces) > most:
        fewer = fast_simplification.simplify(vertices.astype(np.float32), faces.astype(np.int32), target_count=most)
        vertices, faces = np.asarray(fewer[0], dtype=float), np.asarray(fewer[1], dtype=int)
    return _creased(vertices, faces)


def _hull(points: Array) -> tuple[Array, Faces] | None:
    import trimesh

    mesh = trimesh.convex.convex_hull(points)
    return _creased(np.asarray(mesh.vertices), np.asarray(mesh.faces))


def _square(normal: Array, offset: float) -> tuple[Array, Faces]:
    """A square in the plane normal · x = offset."""
    normal = normal / np.linalg.norm(normal)
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    corners = [offset * normal + PLANE * (a * first + b * second) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return np.array(corners), np.array([[0, 1, 2], [0, 2, 3]])


def _creased(vertices: Array, faces: Faces) -> tuple[Array, Faces]:
    """The same triangles, with separate vertices on the two sides of a sharp edge."""
    import trimesh
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    mesh = trimesh.Trimesh(vertices=vertices, faces=faces, process=False)
    smooth = mesh.face_adjacency[mesh.face_adjacency_angles < CREASE]
    graph = coo_array((np.ones(len(smooth)), tuple(smooth.T)), shape=(len(faces),) * 2)
    patch = connected_components(graph, directed=False)[1]
    corners = np.stack([faces.ravel(), np.repeat(patch, 3)], axis=1)
    kept, index = np.unique(corners, axis=0, return_inverse=True)
    return vertices[kept[:, 0]], index.reshape(-1, 3)
