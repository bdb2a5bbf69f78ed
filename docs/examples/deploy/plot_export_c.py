"""
Export C for a controller
=========================

.. image:: images/sphx_glr_plot_export_c_001.png
   :alt: Joint angles by Python and by the exported C, and their difference below
         1e-12 rad.

*For real-time controllers.*

The computer that drives the robot runs C, perhaps without an operating system that
supports Python. ``Controller.export_c`` writes the whole control step as a C project:
kinematics, limits and the QP solver, without memory allocation in a step. This page
writes the project, builds it with CMake, runs it, and compares the results with Python,
digit by digit.
"""

# sphinx_gallery_thumbnail_path = "pictures/export_c.jpg"
import shutil
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp

robot = mp.load_robot("panda")
tube = mp.Tolerance(position=0.02, rotation=0.1)
controller = mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01, tolerance=tube)
folder = Path(tempfile.mkdtemp()) / "controller"
for file in controller.export_c(folder):
    if file.parent == folder:
        print(f"{file.name:16s} {file.stat().st_size:7d} bytes")

# %%
# The interface is one function. The folder contains everything that it needs; the
# solver (DAQP) is a static library.

header = (folder / "controller.h").read_text()
print(header[header.index("int controller_step") : header.index("/* Many steps")])

# %%
# ``example.c`` is a client that moves the tool by 10 cm in one second. It prints the
# joint angles after each step, with 17 digits.

if not (shutil.which("cmake") and shutil.which("cc")):
    raise SystemExit(
        "this page needs CMake and a C compiler: sudo apt-get install cmake gcc"
    )


def run(*command):
    return subprocess.run(
        list(map(str, command)), check=True, capture_output=True, text=True
    ).stdout


run("cmake", "-S", folder, "-B", folder / "build")
run("cmake", "--build", folder / "build")
printed = run(folder / "build" / "example")
table = np.array(
    [[float(word) for word in line.split()] for line in printed.splitlines()]
)
q_c, status_c, m_c = table[:, : robot.n], table[:, robot.n], table[:, robot.n + 1]
print(f"{len(table)} steps; the last: {q_c[-1].round(6)}")

# %%
# The same steps, computed in Python.

q, qd = robot.neutral.copy(), np.zeros(robot.n)
pose = robot.kinematics().pose(q)
controller.reset()
q_python, m_python = np.empty_like(q_c), np.empty(len(q_c))
for k in range(len(q_c)):
    u = (k + 1) / len(q_c)
    target = pose.copy()
    target[0, 3] -= 0.1 * u * u * (3 - 2 * u)
    qd = controller.step(q, qd, target)
    q = q + 0.01 * qd
    q_python[k], m_python[k] = q, controller.report.manipulability
difference = np.abs(q_c - q_python).max()
print(
    f"largest difference between C and Python in {len(q_c)} steps: {difference:.1e} "
    "rad,"
)
print(f"and in the manipulability {np.abs(m_c - m_python).max():.1e} m^6")
assert (status_c == 0).all() and difference < 1e-12

t = 0.01 * np.arange(1, len(q_c) + 1)
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 3.8), layout="constrained")
for joint, name in enumerate(robot.joint_names):
    [line] = left.plot(
        t, q_python[:, joint] - robot.neutral[joint], label=name.removeprefix("panda_")
    )
    left.plot(
        t[::10],
        q_c[::10, joint] - robot.neutral[joint],
        "o",
        color=line.get_color(),
        markersize=4,
    )
left.set(
    xlabel="time [s]",
    ylabel="joint angle from the start [rad]",
    title="lines: Python, dots: exported C",
)
left.legend(frameon=False, fontsize=8, ncols=2)
right.semilogy(
    t, np.maximum(np.abs(q_c - q_python).max(axis=1), 1e-17), color="#0072B2"
)
right.axhline(1e-12, color="0.4", linestyle=":", label="asserted bound")
right.set(xlabel="time [s]", ylabel="largest difference [rad]", ylim=(1e-18, 1e-11))
right.legend(frameon=False, fontsize=8)
plt.show()

# %%
# Time of one step in C: this client calls ``controller_rollout`` and reads the clock.

client = r"""
#include "controller.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
enum { STEPS = 20000 };
int main(int argc, char** argv) {
    const int n = CONTROLLER_JOINTS;
    double *q = calloc((STEPS + 1) * n, 8), *qd = calloc((STEPS + 1) * n, 8);
    double *targets = calloc(STEPS * 16, 8), *tube = calloc(STEPS * 2, 8);
    double *stiffness = calloc(STEPS, 8), *drive = calloc(STEPS, 8);
    double *report = calloc(STEPS * CONTROLLER_REPORT, 8), qdd[CONTROLLER_JOINTS] = {0};
    for (int i = 0; i < n; ++i) q[i] = atof(argv[1 + i]);
    for (int k = 0; k < STEPS; ++k) {
        for (int i = 0; i < 16; ++i) targets[16 * k + i] = atof(argv[1 + n + i]);
        stiffness[k] = STIFFNESS, drive[k] = 1;
        tube[2 * k] = 0.02, tube[2 * k + 1] = 0.1;
    }
    struct timespec a, b;
    clock_gettime(CLOCK_MONOTONIC, &a);
    int failed = controller_rollout(controller_new(), STEPS, targets, stiffness, drive,
                                    tube, NULL, q, qd, qdd, report);
    clock_gettime(CLOCK_MONOTONIC, &b);
    double nanoseconds = (b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec);
    printf("%.3f", nanoseconds / STEPS / 1e3);
    return failed;
}
"""
(folder / "clock.c").write_text(
    "#define _POSIX_C_SOURCE 199309L\n"
    + client.replace("STIFFNESS,", f"{controller.stiffness!r},")
)
build = folder / "build"
flags = [
    "-O2",
    "-I",
    folder,
    folder / "clock.c",
    build / "libcontroller.a",
    folder / "lib" / "libdaqpstat.a",
    "-lm",
]
run("cc", *flags, "-o", build / "clock")
arguments = [repr(float(x)) for x in (*robot.neutral, *pose.ravel())]
microseconds = run(build / "clock", *arguments)
print(f"one step in C, on the machine that built this page: {microseconds} µs")
