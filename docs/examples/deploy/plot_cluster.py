"""
Sweep on a Dask cluster
=======================

One plan takes a second; a study of a cell takes thousands of them: every pick with every place, several robots, several mounting
positions. Everything here that does many independent things takes an ``executor=``, any of ``concurrent.futures``. A Dask
client's ``get_executor()`` is one, and behind it may be this machine or a hundred others.
"""

# %%
# A cluster. Here the scheduler and two workers are processes of this machine, started as on others: ``dask scheduler`` on one of them,
# ``dask worker tcp://...:8786`` on each of the rest, and ``Client("tcp://...:8786")`` where you sit. Nothing else on this page changes.

import subprocess
import sys
import tempfile
import time

import matplotlib.pyplot as plt
import numpy as np
from distributed import Client, LocalCluster

import manipplan as mp

cluster = LocalCluster(n_workers=0, dashboard_address=None)
command = [sys.executable, "-m", "distributed.cli.dask_worker", cluster.scheduler_address, "--nthreads", "1", "--no-nanny"]
folder = ["--no-dashboard", "--local-directory", tempfile.mkdtemp()]
workers = [subprocess.Popen([*command, *folder], stderr=subprocess.DEVNULL) for _ in range(2)]
client = Client(cluster)
client.wait_for_workers(2)
executor = client.get_executor()
print(f"{len(client.scheduler_info()['workers'])} workers")

# %%
# **One problem, many first paths.** ``seeds=`` first paths are looked for and solved side by side. The result does not depend on where
# that happens, so that it is the same as without an executor.

arm = mp.planar_arm([1.0, 1.0, 1.0])
posts = [(0.0, 2.3), (-1.9, 0.5), (1.2, -1.6)]
scene = mp.Scene([mp.Cylinder(radius=0.15, length=1.0, position=(x, y, 0.0), name=f"post at {x}, {y}") for x, y in posts])
start, goal = [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0]
options = {"degree": 8, "power": 2, "scene": scene, "clearance": 0.02, "seeds": 4}
begin = time.perf_counter()
here = mp.optimize_path(arm, start, goal, **options)
alone = time.perf_counter() - begin
begin = time.perf_counter()
there = mp.optimize_path(arm, start, goal, executor=executor, **options)
print(f"here {alone:.1f} s, on the cluster {time.perf_counter() - begin:.1f} s; {len(there.rivals)} rivals")
print(f"g {here.g:.9f} and {there.g:.9f}")
assert np.isclose(here.g, there.g, rtol=1e-9)

# %%
# **Many problems.** A sweep is a function and a list. Here: where along a table should the base of the arm stand, so that its path between two
# points of the table is farthest from singularities? Each case has its own inverse kinematics and optimisation; the function returns
# numbers, not robots, so that little travels.


def case(base):
    robot = mp.planar_arm([1.0, 1.0, 1.0])
    kinematics = robot.kinematics()
    ends = []
    for x in (-0.8, 0.8):
        pose = np.eye(4)
        pose[:3, 3] = [x - base[0], -base[1], 0.0]
        q = mp.inverse_kinematics(robot, pose, samples=24).q
        if not len(q):
            return {"base": base, "g": np.inf, "least": 0.0}
        ends.append(q[kinematics.manipulability(q).argmax()])
    result = mp.optimize_path(robot, *ends, degree=6, power=2, compiled=False, throw=False)
    return {"base": base, "g": result.g, "least": result.min_manipulability}


xs, ys = np.linspace(-1.5, 1.5, 9), np.linspace(-2.4, -0.4, 6)
bases = [(float(x), float(y)) for y in ys for x in xs]
begin = time.perf_counter()
rows = [future.result() for future in [executor.submit(case, base) for base in bases]]
print(f"{len(rows)} cases in {time.perf_counter() - begin:.1f} s")

print("   base [m]          g   least index [m²]")
for row in sorted(rows, key=lambda row: row["g"])[:6]:
    print(f"({row['base'][0]:5.2f}, {row['base'][1]:5.2f})  {row['g']:8.3f}  {row['least']:12.3f}")

# %%
# The same case computed here is the same to rounding: nothing depends on the worker.

best = min(rows, key=lambda row: row["g"])
assert np.isclose(case(best["base"])["g"], best["g"], rtol=1e-9)
values = np.array([row["g"] for row in rows]).reshape(len(ys), len(xs))
figure, ax = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
image = ax.pcolormesh(xs, ys, np.log10(np.where(np.isfinite(values), values, np.nan)), cmap="viridis_r", shading="nearest")
figure.colorbar(image, ax=ax, label=r"$\log_{10} g$: low is good")
ax.plot([-0.8, 0.8], [0, 0], "s", color="#D55E00", markersize=9, label="the two points of the table")
ax.plot(*best["base"], "*", color="white", markeredgecolor="black", markersize=16, label="best base")
ax.set(xlabel="x of the base [m]", ylabel="y of the base [m]", aspect="equal", ylim=(ys[0] - 0.2, 0.2))
ax.legend(frameon=True, fontsize=8, loc="upper left")
plt.show()

# %%
# ``mp.sample_layers`` and ``mp.follow`` take the same ``executor=``. When the cluster is done with:

client.shutdown()
print("workers ended with", [worker.wait(timeout=30) for worker in workers])

# %%
# When it fails: workers need the same versions of manipplan, CasADi and Pinocchio as the client (Dask warns of differences), and files that a
# scene names, such as meshes, at the same paths. Compiled objectives are kept in the cache folder of each machine, so the first case on a
# new worker takes some seconds longer.
