"""
Sweep on a Dask cluster
=======================

One plan takes a second; a study of a cell takes thousands of them: every pick with
every place, several robots, several mounting positions. Everything here that does
many independent things takes an ``executor=``, any of ``concurrent.futures``. A
Dask client's ``get_executor()`` is one, and behind it may be this machine or a
hundred others.
"""

# %%
# A cluster. Here the scheduler and two workers are processes of this machine,
# started as on others: ``dask scheduler`` on one of them, ``dask worker
# tcp://...:8786`` on each of the rest, and ``Client("tcp://...:8786")`` where you
# sit. Nothing else on this page changes.

import subprocess
import sys
import tempfile
import time

import matplotlib.pyplot as plt
import numpy as np
from distributed import Client, LocalCluster

import manipplan as mp

cluster = LocalCluster(n_workers=0, dashboard_address=None)
command = [
    sys.executable,
    "-m",
    "distributed.cli.dask_worker",
    cluster.scheduler_address,
    "--nthreads",
    "1",
    "--no-nanny",
]
folder = ["--no-dashboard", "--local-directory", tempfile.mkdtemp()]
workers = [
    subprocess.Popen([*command, *folder], stderr=subprocess.DEVNULL) for _ in range(2)
]
client = Client(cluster)
client.wait_for_workers(2)
executor = client.get_executor()
print(f"{len(client.scheduler_info()['workers'])} workers")

# %%
# **One problem, many first paths.** ``seeds=`` first paths are looked for and solved
# side by side. The result does not depend on where that happens, so it is the same as
# without an executor. A problem as small as this one is not worth the way: it shows
# how the call looks. The first call also loads the library on the workers.

arm = mp.planar_arm([1.0, 1.0, 1.0])
posts = [(0.0, 2.3), (-1.9, 0.5), (1.2, -1.6)]
scene = mp.Scene(
    [
        mp.Cylinder(
            radius=0.15, length=1.0, position=(x, y, 0.0), name=f"post at {x}, {y}"
        )
        for x, y in posts
    ]
)
start, goal = [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0]
options = {"degree": 8, "power": 2, "scene": scene, "clearance": 0.02, "seeds": 4}
begin = time.perf_counter()
here = mp.optimize_path(arm, start, goal, **options)
alone = time.perf_counter() - begin
begin = time.perf_counter()
there = mp.optimize_path(arm, start, goal, executor=executor, **options)
print(
    f"here {alone:.1f} s, on the cluster {time.perf_counter() - begin:.1f} s; "
    f"{len(there.rivals)} rivals"
)
print(f"g {here.g:.9f} and {there.g:.9f}")
assert np.isclose(here.g, there.g, rtol=1e-9)

# %%
# **Many problems.** A sweep is a function and a list. Here: where should a UR5
# stand, so that its way from one place of a table to another is farthest from
# singularities? A task is one row of the map, so that it takes about a second and
# loads the robot once; it returns numbers, not robots, so that little travels.
# Start and goal are the configurations of the two poses that have the same sign of
# det J and are nearest to each other.


def row_of_map(y, xs):
    robot = mp.load_robot("ur5").with_limits(lower=-np.pi, upper=np.pi)
    kinematics = robot.kinematics()
    return [case(robot, kinematics, x, y) for x in xs]


def case(robot, kinematics, x, y):
    ends = []
    for place in (-0.35, 0.35):
        pose = np.diag([1.0, -1.0, -1.0, 1.0])  # the tool points down
        pose[:3, 3] = [place - x, -y, 0.15]
        ends.append(mp.inverse_kinematics(robot, pose).q)
    if not all(map(len, ends)):
        return np.inf, 0.0
    starts, goals = ends
    signs = [np.sign(np.linalg.det(kinematics.jacobian(q))) for q in ends]
    distance = np.linalg.norm(starts[:, None] - goals, axis=2)
    distance[signs[0][:, None] != signs[1]] = np.inf
    first, last = np.unravel_index(distance.argmin(), distance.shape)
    result = mp.optimize_path(robot, starts[first], goals[last], degree=4, throw=False)
    return result.g, result.min_manipulability


xs, ys = np.linspace(-0.4, 0.4, 7), np.linspace(-0.75, -0.3, 4)
begin = time.perf_counter()
futures = [executor.submit(row_of_map, y, xs) for y in ys]
table = np.array([future.result() for future in futures])
del futures  # the cluster may forget them
print(
    f"{table[..., 0].size} cases in {time.perf_counter() - begin:.1f} s; out of "
    f"reach: {(table[..., 1] == 0).sum()}"
)

order = np.argsort(table[..., 0], axis=None)
print("   base [m]          g   minimum manipulability [m^6]")
for row, column in zip(*np.unravel_index(order[:5], table.shape[:2]), strict=True):
    g, least = table[row, column]
    print(f"({xs[column]:5.2f}, {ys[row]:5.2f})  {g:8.1f}  {least:12.4f}")

# %%
# A row computed here is the same to rounding: nothing depends on the worker. In the
# picture white is out of reach.

row, column = np.unravel_index(order[0], table.shape[:2])
assert np.allclose(
    row_of_map(ys[row], xs[column : column + 1]), table[row, column], rtol=1e-6
)

figure, ax = plt.subplots(figsize=(5.6, 4.4), layout="constrained")
g = np.where(np.isfinite(table[..., 0]), table[..., 0], np.nan)
image = ax.pcolormesh(xs, ys, np.log10(g), cmap="viridis_r", shading="nearest")
figure.colorbar(image, ax=ax, label=r"$\log_{10} g$: low is good")
ax.plot(
    [-0.35, 0.35],
    [0, 0],
    "s",
    color="#D55E00",
    markersize=9,
    label="the two places of the table",
)
ax.plot(
    xs[column],
    ys[row],
    "*",
    color="white",
    markeredgecolor="black",
    markersize=17,
    label="best base",
)
ax.set(
    xlabel="x of the base [m]",
    ylabel="y of the base [m]",
    aspect="equal",
    ylim=(ys[0] - 0.05, 0.16),
)
ax.legend(fontsize=8, loc="upper left", ncols=2)
plt.show()

# %%
# ``mp.sample_layers`` and ``mp.follow`` take the same ``executor=``. When the
# cluster is done with:

client.shutdown()
print("workers ended with", [worker.wait(timeout=30) for worker in workers])

# %%
# When it fails: workers need the same versions of manipplan, CasADi and Pinocchio
# as the client (Dask warns of differences), and files that a scene names, such as
# meshes, at the same paths. Compiled objectives are kept in the cache folder of
# each machine, so the first case on a new worker takes some seconds longer.
