"""
Sweep on a Dask cluster
=======================

.. image:: images/sphx_glr_plot_cluster_001.png
   :alt: A map of g by the position of the robot's base.

*For studies with thousands of plans.*

One plan takes a second; the study of a robot cell needs thousands of them: every pick
with every place, several robots, several mounting positions. Every function that does
many independent computations takes an ``executor=`` with the interface of
``concurrent.futures``. A Dask client's ``get_executor()`` returns one. Its workers may
run on this machine or on a hundred others.
"""

# %%
# Start the cluster. Here the scheduler and two workers are processes on this machine.
# On several machines, run ``dask scheduler`` on one of them and ``dask worker
# tcp://...:8786`` on each of the others, and create ``Client("tcp://...:8786")`` in
# your own script. Nothing else on this page changes.

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
# **One problem, many first paths.** With ``mp.Seeding(count=4)`` the planner looks for
# four first paths and optimises them in parallel. The result is the same as without an
# executor, up to the tolerance at which a descent ends: 5e-7 of g. A problem as small as
# this one is not worth the overhead; it only shows the call. The first call also loads
# the library on the workers.

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
options = {
    "objective": mp.PathObjective(power=2),
    "shape": mp.PathShape(degree=8),
    "seeding": mp.Seeding(count=4),
    "clearance": 0.02,
}
begin = time.perf_counter()
here = mp.optimize_path(arm, start, goal, scene, **options)
alone = time.perf_counter() - begin
begin = time.perf_counter()
there = mp.optimize_path(arm, start, goal, scene, executor=executor, **options)
print(
    f"here {alone:.1f} s, on the cluster {time.perf_counter() - begin:.1f} s; "
    f"{len(there.rivals)} rivals"
)
print(f"g {here.g:.5f} and {there.g:.5f}")
assert here.status is there.status is mp.Status.OPTIMAL and here.g < 1.47
assert np.isclose(here.g, there.g, rtol=1e-6)

# %%
# **Many problems.** A sweep is a function and a list of arguments. Here: where should a
# UR5 be mounted, so that its path from one place of a table to another stays farthest
# from singularities? Each task computes one row of the map, so it takes about a second
# and loads the robot only once. It returns numbers, not robots, so little data is
# transferred. Start and goal are the configurations of the two poses that have the same
# sign of det J and are nearest to each other.


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
    result = mp.optimize_path(
        robot, starts[first], goals[last], shape=mp.PathShape(degree=4), throw=False
    )
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
# A row computed in this process is the same up to rounding: the result does not depend
# on the worker. White places in the figure are out of reach.

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
# ``mp.sample_layers`` and ``mp.follow`` take the same ``executor=``. Shut the cluster
# down when you no longer need it:

client.shutdown()
print("workers ended with", [worker.wait(timeout=30) for worker in workers])

# %%
# If it fails: the workers need the same versions of manipplan, CasADi and Pinocchio as
# the client (Dask warns if they differ). Files that a scene refers to, such as meshes,
# must have the same paths on all machines. Compiled objectives are kept in the cache
# folder of each machine, so the first case on a new worker takes some seconds longer.
