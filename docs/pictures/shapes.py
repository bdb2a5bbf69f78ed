"""Draws what counts as touching: an arm's meshes, their convex pieces, the controller's capsules, and how far they stick out.

Run: python docs/pictures/shapes.py [name ...]. Writes PNG files into this folder.
"""

import sys
from pathlib import Path

import coal
import matplotlib as mpl

mpl.use("agg")
import matplotlib.pyplot as plt
import numpy as np
import pinocchio as pin
from matplotlib.colors import LinearSegmentedColormap, PowerNorm, to_rgb
from PIL import Image
from raster import Raster
from scipy.spatial import ConvexHull

import manipplan as mp
from manipplan.collision.covers import distances_to
from manipplan.collision.world import core_of, mesh_triangles
from manipplan.tracking.bodies import CapsuleBodies
from manipplan.viz.shapes import surface_of
from manipplan.viz.style import ARM, ELLIPSOID, PIECES, STYLE

HERE = Path(__file__).parent
METAL = "#B9C0C9"
#: Lays what stands upright on its side.
ON_ITS_SIDE = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
EXCESS = LinearSegmentedColormap.from_list("excess", ["#C9D3DE", "#F6D58A", "#E69F00", "#D55E00", "#7A1F12"])
UR5 = np.array([-0.5, -1.25, 1.55, -1.9, -1.3, 0.0])


def ur5():
    """The UR5: meshes with recesses, cut into pieces."""
    return arm("ur5", UR5, azimuth=-62, elevation=16)


def panda():
    """The Panda: its meshes are convex but for some hundredths of a millimetre."""
    robot = mp.load_robot("panda")
    return arm("panda", robot.neutral, azimuth=-58, elevation=14)


def excess():
    """The forearm of the UR5 as mesh, as pieces and as capsule, coloured by the distance from the mesh."""
    robot, link = mp.load_robot("ur5"), "forearm_link_0"
    model = mp.Scene().collision_model(robot)
    item = next(each for each in robot.geometry.geometryObjects if each.name == link)
    pieces = [each for each in bodies_of(model) if each.name.rpartition(".")[0] == link]
    [capsule] = [body for body in CapsuleBodies.of(robot).items if body.name == link]
    most = max(model.excess[each.name] for each in pieces)
    panels = (
        ("the mesh of the UR5's forearm", [described(item)], METAL),
        (f"{len(pieces)} convex pieces stick out by at most {1e3 * most:.0f} mm", [described(each) for each in pieces], None),
        (f"1 capsule sticks out by at most {1e3 * capsule.excess:.0f} mm", [around(capsule)], None),
    )
    everything = np.concatenate([each.reshape(-1, 3) for _, bodies, _ in panels for each in bodies]) @ ON_ITS_SIDE.T
    scale = PowerNorm(0.5, 0, 50)
    figure, axes = plt.subplots(3, 1, figsize=(7.2, 5.7), layout="constrained")
    for ax, (title, bodies, colour) in zip(axes, panels, strict=True):
        raster = Raster(azimuth=-90, elevation=24, points=everything, pixels=1700)
        triangles = np.concatenate([split(each, 0.007) for each in bodies] if colour is None else bodies)
        raster.draw(triangles @ ON_ITS_SIDE.T, tint(triangles, item, scale) if colour is None else np.array(to_rgb(colour)))
        ax.imshow(raster.pixels())
        ax.set_title(title, color=ARM)
        ax.axis("off")
    bar = figure.colorbar(mpl.cm.ScalarMappable(scale, EXCESS), ax=axes, shrink=0.8, pad=0.02, ticks=[0, 2, 5, 10, 20, 30, 50])
    bar.set_label("distance from the mesh [mm]")
    bar.outline.set_visible(False)
    return figure


def tint(triangles, item, scale):
    """A colour per corner of triangles in the frame of the joint, by the distance from the item."""
    points, place = np.unique(triangles.reshape(-1, 3).round(7), axis=0, return_inverse=True)
    local = (points - item.placement.translation) @ item.placement.rotation
    colours = EXCESS(scale(1e3 * distances_to(local, item.geometry)))[:, :3]
    return colours[place.ravel()].reshape(-1, 3, 3)


def arm(name, q, *, azimuth, elevation):
    """An arm at q (n,): its meshes, the bodies that a plan is checked with, and the capsules of a controller."""
    robot = mp.load_robot(name)
    model = mp.Scene().collision_model(robot)
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, q)
    meshes = [placed(data, each.parentJoint, described(each)) for each in robot.geometry.geometryObjects]
    pieces = [placed(data, each.parentJoint, described(each)) for each in bodies_of(model)]
    colours = [np.tile(to_rgb(PIECES[k % len(PIECES)]), (len(each), 1)) for k, each in enumerate(pieces)]
    capsules = [placed(data, body.joint, around(body)) for body in CapsuleBodies.of(robot).items]
    points = np.concatenate([each.reshape(-1, 3) for each in capsules])
    rasters = [Raster(azimuth=azimuth, elevation=elevation, points=points, pixels=430) for _ in range(3)]
    height, width = rasters[0].shape
    metal = np.array(to_rgb(METAL))
    rasters[0].draw(np.concatenate(meshes), metal)
    rasters[1].draw(np.concatenate(pieces), np.concatenate(colours))
    rasters[2].draw(np.concatenate(meshes), metal)
    rasters[2].draw(np.concatenate(capsules), np.array(to_rgb(ELLIPSOID)), opacity=0.38)
    titles = (
        "the description's meshes",
        f"a plan is checked with {len(pieces)} convex bodies",
        f"a controller keeps {len(capsules)} capsules apart",
    )
    figure, axes = plt.subplots(1, 3, figsize=(9.2, 0.35 + 3.0 * height / width), layout="constrained")
    for ax, raster, title in zip(axes, rasters, titles, strict=True):
        ax.imshow(raster.pixels())
        ax.set_title(title, color=ARM)
        ax.axis("off")
    return figure


def bodies_of(model):
    return list(model.geometry.geometryObjects)[: model.bodies]


def described(item):
    """Triangles (t, 3, 3) of a geometry object in the frame of its joint [m]."""
    shape = item.geometry
    if isinstance(shape, coal.BVHModelBase):
        triangles = mesh_triangles(shape)
    elif isinstance(shape, coal.ConvexBase):
        points = core_of(shape)[0]
        triangles = points[ConvexHull(points).simplices]
    else:
        triangles = fans(surface_of(shape).faces)
    return triangles @ item.placement.rotation.T + item.placement.translation


def around(body):
    """Triangles (t, 3, 3) of a controller's capsule in the frame of its joint [m]."""
    along = body.end - body.start
    length = float(np.linalg.norm(along))
    turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), along).matrix() if length else np.eye(3)
    faces = surface_of(coal.Capsule(body.radius, length)).faces
    return fans(faces) @ turn.T + (body.start + body.end) / 2


def fans(polygons):
    """Polygons as triangles (t, 3, 3)."""
    found = [[face[0], face[k], face[k + 1]] for face in polygons for k in range(1, len(face) - 1)]
    return np.array(found)


def placed(data, joint, triangles):
    return triangles @ data.oMi[joint].rotation.T + data.oMi[joint].translation


def split(triangles, size):
    """The same triangles in parts with edges of at most `size` [m]."""
    done = []
    while len(triangles):
        edges = np.linalg.norm(np.roll(triangles, -1, axis=1) - triangles, axis=2)
        long = edges.max(axis=1) > size
        done.append(triangles[~long])
        triangles, first = triangles[long], edges[long].argmax(axis=1)
        row = np.arange(len(triangles))
        a, b, c = (triangles[row, (first + k) % 3] for k in range(3))
        middle = (a + b) / 2
        triangles = np.concatenate([np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)])
    return np.concatenate(done)


PICTURES = (ur5, panda, excess)


def main(names):
    """Draw the pictures named, or all."""
    for draw in PICTURES:
        if names and draw.__name__ not in names:
            continue
        file = HERE / f"shapes_{draw.__name__}.png"
        with mpl.rc_context({**STYLE, "axes.titlelocation": "center"}):
            figure = draw()
            figure.savefig(file, dpi=150, facecolor="white")
            plt.close(figure)
        Image.open(file).convert("RGB").save(file, optimize=True)
        print(f"wrote {file}, {file.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
