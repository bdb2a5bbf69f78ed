"""Draws the pictures of the concept pages into this folder: python docs/pictures/draw.py [name ...].

Colours and lines are those of manipplan.viz.style. All curves are computed; none is drawn by hand.
"""

import sys
from pathlib import Path

import matplotlib as mpl

mpl.use("svg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Ellipse, FancyArrowPatch, FancyBboxPatch

import manipplan as mp
from manipplan.cost.crossings import find_crossings
from manipplan.cost.objective import floor_of
from manipplan.viz.motions import skeleton
from manipplan.viz.style import ARM, ELLIPSOID, JOINTS, OBSTACLE, OPTIMUM, SEED, STRAIGHT, STYLE, label_powers

HERE = Path(__file__).parent
#: Every run writes the same file; titles are centred, and legends are as large as other text.
FIXED = {"svg.hashsalt": "manipplan", "svg.fonttype": "path", "axes.titlelocation": "center", "legend.fontsize": 9}


#: What else a row of `flow` is taken for.
MORE = {
    "plan": "each move of mp.sequence; one arm or two",
    "follow": "paths of a program; mp.carry with both hands",
    "improve": "",
}


def flow():
    """Data flow from the user's input to a plan."""
    figure, ax = plt.subplots(figsize=(9.2, 3.7))
    ax.set(xlim=(0, 92), ylim=(0, 37))
    ax.axis("off")
    rows = {
        30: (OPTIMUM, "plan", ["start, goal", "seed_path\nRRT-Connect", "optimize_path\nminimum g"]),
        18: (ELLIPSOID, "follow", ["path of the tool", "sample_layers\nall configurations", "max_min_search\nrefine"]),
        6: (JOINTS[3], "improve", ["recording", "smooth\nno noise", "tube program\nm raised"]),
    }
    for y, (colour, job, boxes) in rows.items():
        for k, text in enumerate(boxes):
            box(ax, 2 + 20 * k, y, 15, text, colour if k else "#FFFFFF", ARM if k == 0 else "#FFFFFF")
            if k:
                arrow(ax, (17 + 20 * (k - 1), y), (2 + 20 * k, y))
        title = ax.text(2.0, y + 4.6, f"mp.{job}", color=colour, weight="bold", fontsize=10)
        beside = {"xycoords": title, "textcoords": "offset points", "color": ARM, "fontsize": 8.5}
        ax.annotate(MORE[job], (1.0, 0.0), (8.0, 0.0), **beside)
        arrow(ax, (57, y), (62, 18 + (y - 18) / 6))
    box(ax, 62, 18, 12, "retime\nq(t) within\nall limits", ARM, "#FFFFFF")
    arrow(ax, (74, 18), (78, 18))
    box(ax, 78, 18, 12, "Report\nevery number\nmeasured", ARM, "#FFFFFF")
    arrow(ax, (84, 9.5), (84, 14.8))
    ax.text(84, 6.0, "any trajectory:\nmp.check", ha="center", va="center", color=ARM, fontsize=8.5, linespacing=1.3)
    return figure


def box(ax, x, y, width, text, colour, ink):
    """A rounded box, its left edge at x and its middle at y."""
    patch = FancyBboxPatch(
        (x, y - 3.2), width, 6.4, boxstyle="round,pad=0,rounding_size=1", facecolor=colour, edgecolor=ARM, linewidth=0.8
    )
    ax.add_patch(patch)
    ax.text(x + width / 2, y, text, ha="center", va="center", color=ink, fontsize=8.5, linespacing=1.15)


def arrow(ax, begin, end, colour=ARM, **options):
    """An arrow between two points."""
    style = {"arrowstyle": "-|>", "mutation_scale": 10, "color": colour, "linewidth": 1.1, "shrinkA": 1, "shrinkB": 1}
    ax.add_patch(FancyArrowPatch(begin, end, **{**style, **options}))


def frames():
    """Base, tool, and the frame in which tool velocities are expressed."""
    arm = mp.planar_arm([1.0, 0.9, 0.6])
    q = np.array([0.9, -0.8, -0.75])
    points = skeleton(arm, q)[1:, :2]
    figure, ax = plt.subplots(figsize=(6.2, 3.3))
    ax.plot(*points.T, "-", color=ARM, linewidth=6, solid_capstyle="round", alpha=0.25)
    ax.plot(*points[:-1].T, "o", color=ARM, markersize=7)
    turn = q.sum()
    tool = points[-1]
    for origin, angle, colour, name, length in (
        (points[0], 0.0, ARM, "base", 0.55),
        (tool, 0.0, OPTIMUM, "LOCAL_WORLD_ALIGNED:\norigin of the tool, axes of the base", 0.55),
        (tool, turn, JOINTS[3], "tool", 0.4),
    ):
        for k, axis in enumerate("xy"):
            a = angle + k * np.pi / 2
            end = origin + length * np.array([np.cos(a), np.sin(a)])
            arrow(ax, origin, end, colour, linewidth=1.8, mutation_scale=12, shrinkA=0, shrinkB=0)
            ax.text(
                *(origin + (length + 0.08) * np.array([np.cos(a), np.sin(a)])), axis, color=colour, ha="center", va="center"
            )
        shift = {"base": (0.0, -0.16), "tool": (0.22, -0.42)}.get(name, (0.2, 0.52))
        ax.text(*(origin + shift), name, color=colour, fontsize=9)
    ax.set(xlim=(-0.35, 4.3), ylim=(-0.3, 1.75), aspect="equal")
    ax.axis("off")
    return figure


def ellipsoids():
    """Four postures of the arm of three links with their velocity ellipsoids."""
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    kin = arm.kinematics()
    postures = {
        "almost stretched": [0.4, -0.12, 0.08],
        "folded": [0.5, 2.4, -2.2],
        "large": [-0.35, 0.780, 1.132],
        "round": None,
    }
    grid = np.stack(np.meshgrid(np.linspace(-np.pi, np.pi, 181), np.linspace(-np.pi, np.pi, 181)), axis=-1).reshape(-1, 2)
    shape = arm.kinematics(measure="inverse_condition")
    every = np.column_stack([np.zeros(len(grid)), grid])
    postures["round"] = [0.3, *grid[shape.manipulability(every).argmax()]]
    figure, panels = plt.subplots(1, 4, figsize=(9.2, 2.7), sharex=True, sharey=True, layout="constrained")
    for ax, (name, q) in zip(panels, postures.items(), strict=True):
        points = skeleton(arm, np.asarray(q))[1:, :2]
        ellipsoid = mp.measures.velocity_ellipsoid(kin.jacobian(q))
        axes, radii = np.asarray(ellipsoid.axes), np.asarray(ellipsoid.radii)
        angle = np.degrees(np.arctan2(axes[1, 0], axes[0, 0]))
        ax.add_patch(
            Ellipse(
                points[-1], *(0.6 * radii), angle=angle, facecolor=ELLIPSOID, alpha=0.25, edgecolor=ELLIPSOID, linewidth=1.5
            )
        )
        ax.plot(*points.T, "o-", color=ARM, linewidth=2.5, markersize=4)
        ax.set_title(f"{name}\nm = {kin.manipulability(q):.2f} m², κ = {shape.manipulability(q):.2f}", fontsize=9)
        ax.set(xlim=(-0.4, 3.4), ylim=(-0.9, 2.3), aspect="equal", xticks=[], yticks=[])
        ax.grid(visible=False)
        for side in ax.spines.values():
            side.set_visible(False)
    figure.supxlabel("ellipses are drawn at 0.3 of their size; κ is the condition σ₂/σ₁", fontsize=9, color="#444444")
    return figure


def measures():
    """Six measures along the Panda's elbow, each divided by its maximum."""
    robot = mp.load_robot("panda")
    elbow = np.linspace(robot.limits.lower[3], robot.limits.upper[3], 400)
    q = np.tile(robot.neutral, (len(elbow), 1))
    q[:, 3] = elbow
    figure, ax = plt.subplots(figsize=(8.2, 3.6))
    names = ("yoshikawa", "smallest_singular_value", "inverse_condition", "isotropy", "dynamic", "frobenius")
    for name, colour, dash in zip(names, JOINTS, ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 1))), strict=False):
        values = robot.kinematics(mp.Task.pose(length=0.5), measure=name).manipulability(q)
        ax.plot(elbow, values / values.max(), color=colour, linestyle=dash, label=name, linewidth=1.8)
    ax.set(xlabel="joint 4 of the Panda, the elbow [rad]: folded on the left", ylabel="share of the maximum")
    ax.set(ylim=(0, 1.05), xlim=(elbow[0], 0.05))
    ax.axvline(0, color=STRAIGHT, linewidth=1)
    ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=9)
    return figure


def proof():
    """Distance along an optimised path, and the lower bounds of the pieces that prove the clearance."""
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    post = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
    path = mp.optimize_path(
        arm, [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0], objective=mp.PathObjective(power=2), scene=post, clearance=0.04
    ).path
    model = post.collision_model(arm)
    s = np.linspace(0, 1, 801)
    distance = np.array([model.distances(q).min() for q in path(s)])
    figure, ax = plt.subplots(figsize=(8.2, 3.2))
    stack, pieces = [(0.0, 1.0)], []
    while stack:
        a, b = stack.pop()
        middle = (a + b) / 2
        # no point of this arm is farther from joint k than the length of the links after it plus their radius
        way = np.abs(path(np.linspace(a, b, 65)) - path(middle)).max(axis=0) @ np.array([3.1, 2.1, 1.1])
        low = model.distances(path(middle)).min() - way
        if low >= 0.02:
            pieces.append((a, b, low))
        else:
            stack += [(a, middle), (middle, b)]
    begins, ends, lows = zip(*sorted(pieces), strict=True)
    ax.stairs(lows, [*begins, 1.0], color=OPTIMUM, alpha=0.12, fill=True)
    ax.hlines(lows, begins, ends, color=OPTIMUM, linewidth=2)
    ax.plot(s, distance, color=ARM, label="measured distance")
    ax.plot([], [], color=OPTIMUM, label=f"bounds of {len(pieces)} pieces")
    ax.axhline(0.02, color=OBSTACLE, linestyle="--", label="clearance to be proven")
    ax.set(xlabel="s", ylabel="distance [m]", xlim=(0, 1), ylim=(0, None))
    ax.legend(loc="upper center", ncols=3, bbox_to_anchor=(0.5, 1.17))
    return figure


def drives():
    """Pull of each formulation along the gradient of the manipulability."""
    m = np.linspace(0.002, 0.14, 300)
    step, rate = 0.01, 10.0
    pulls = {
        "Objective (10): α T, constant": (np.full_like(m, 15e3 * step), OPTIMUM, "--"),
        "Equality (14): α T m": (5e5 * step * m, SEED, "-."),
        "LogDrive: β ρ / m": (10.0 * rate / m, ELLIPSOID, "-"),
    }
    figure, ax = plt.subplots(figsize=(7.2, 3.2))
    for name, (pull, colour, dash) in pulls.items():
        ax.plot(m, pull, color=colour, linestyle=dash, label=name)
    ax.set(
        xlabel="manipulability m of Baxter's arm: singular on the left, best posture on the right",
        ylabel="pull on ∇m",
        ylim=(10, 5e4),
    )
    ax.set(yscale="log", xlim=(0, 0.14))
    ax.legend(loc="upper right")
    return figure


def search():
    """Candidates of each position and the widest path."""
    robot = mp.planar_arm([1.0, 0.8, 0.6])
    begin, end = np.eye(4), np.eye(4)
    begin[:2, 3], end[:2, 3] = [1.9, -0.9], [0.9, 1.3]
    layers = mp.sample_layers(robot, mp.CartesianPath.line(begin, end), 24, task=mp.Task.planar(), samples=90)
    found = mp.max_min_search(layers, 0.25)
    figure, ax = plt.subplots(figsize=(8.2, 3.6))
    s = np.repeat(layers.s, [len(each) for each in layers.m])
    q, m = np.vstack(layers.q), np.concatenate(layers.m)
    dots = ax.scatter(s, q[:, 0], c=m, s=9, cmap="cividis", linewidths=0, rasterized=True)
    ax.plot(
        layers.s,
        found.q[:, 0],
        color=JOINTS[3],
        linewidth=2,
        label=f"widest path, minimum manipulability {found.minimum:.2f} m²",
    )
    k = int(found.manipulability.argmin())
    ax.plot(
        layers.s[k], found.q[k, 0], "o", color=JOINTS[3], markersize=9, fillstyle="none", markeredgewidth=1.8, label="minimum"
    )
    figure.colorbar(dots, label="manipulability m [m²]", pad=0.02)
    ax.set(xlabel="s, position along the path of the tool", ylabel="joint 1 of each candidate [rad]", xlim=(-0.02, 1.02))
    ax.legend(loc="upper center", ncols=2, bbox_to_anchor=(0.5, 1.15))
    return figure


def crossings():
    """g with a floor against the floor, of straight paths of the UR5 that cross no, one and two singularities."""
    robot = mp.load_robot("ur5")
    kinematics = robot.kinematics()
    start = np.array([0.0, -1.2, 1.4, -1.0, 1.0, 0.0])
    goals = {
        "no crossing": [0.8, -0.9, 1.0, -1.4, 1.4, 0.5],
        "one: the elbow": [0.8, -0.9, -1.0, -1.4, 1.4, 0.5],
        "two: elbow and wrist": [0.8, -0.9, -1.0, -1.4, -1.4, 0.5],
    }
    floors = np.logspace(-8, -3, 41)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.2, 3.4), layout="constrained")
    for (text, goal), colour in zip(goals.items(), (STRAIGHT, OPTIMUM, SEED), strict=True):
        path = mp.JointPath.line(start, goal)
        g = [mp.path_cost(path, kinematics, 1.0, floor=floor).g for floor in floors]
        rest = [result_without_crossings(robot, path, floor) for floor in floors]
        left.plot(floors, g, color=colour, label=text)
        right.plot(floors, rest, color=colour, label=text)
    for ax, title in ((left, "g with the floor"), (right, "g without its crossings")):
        powers = np.arange(-8, -2)
        ax.set(xscale="log", xlabel="floor ε [m⁶]", title=title)
        ax.set_xticks(10.0**powers, [f"1e{power}" for power in powers], minor=False)
        ax.set_xticks([], minor=True)
        ax.axvline(floor_of(kinematics, None), color=ARM, linestyle=":", linewidth=1.0)
        ax.invert_xaxis()
    right.annotate("default", (floor_of(kinematics, None), 300.0), (6, 0), textcoords="offset points", fontsize=8)
    left.legend(loc="upper left")
    return figure


def result_without_crossings(robot, path, floor):
    """g of a path less the cost of its crossings."""
    integral = mp.PathObjective(floor=floor).integral(robot)
    cost = integral.cost(path)
    return cost.g - sum(each.cost for each in find_crossings(path, integral, cost))


PICTURES = (flow, frames, ellipsoids, measures, proof, drives, search, crossings)


def main(names):
    """Draw the pictures named, or all."""
    for draw in PICTURES:
        if names and draw.__name__ not in names:
            continue
        with mpl.rc_context({**STYLE, **FIXED}):
            figure = draw()
            label_powers(figure)
            figure.savefig(
                HERE / f"{draw.__name__}.svg", dpi=200, bbox_inches="tight", metadata={"Date": None}, facecolor="white"
            )
            plt.close(figure)


if __name__ == "__main__":
    main(sys.argv[1:])
