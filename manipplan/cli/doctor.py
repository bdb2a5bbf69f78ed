"""`manipplan doctor`: what of manipplan works on this machine, what is missing, and the line that installs it."""

import os
import platform
import shlex
import time
from collections.abc import Callable
from importlib.metadata import version
from importlib.util import find_spec

from rich.console import Console

from manipplan.cli.terminal import progress, show_line
from manipplan.jobs.demo import panda_among_boxes, planar_path
from manipplan.jobs.follow import follow
from manipplan.jobs.plan import plan
from manipplan.paths.cartesian import CartesianPath
from manipplan.robots.catalog import load_robot
from manipplan.support.compiler import find_compiler, install_line
from manipplan.support.errors import ManipplanError, MissingExtraError
from manipplan.support.files import cache_folder
from manipplan.support.kernel_library import find_library

#: A module of each extra.
EXTRAS = {
    "robots": "example_robot_data",
    "descriptions": "robot_descriptions",
    "menagerie": "mujoco_menagerie",
    "cluster": "distributed",
    "mesh": "trimesh",
    "mujoco": "mujoco",
    "ros": "rosbags",
    "xacro": "xacro",
    "viewer": "viser",
    "film": "mujoco",
}
#: The packages whose versions matter most.
PACKAGES = ("casadi", "pin", "coal", "ompl", "toppra", "numpy", "scipy")


def doctor() -> int:
    """Show versions, compiler, cache folder and extras, and test each kind of job; the exit code is 1 if a test failed."""
    console = Console()

    def show(name: str, text: str, style: str = "") -> None:
        show_line(console, f"{name:<10} {text}", style=style)

    show("manipplan", f"{version('manipplan')} on Python {platform.python_version()}, {platform.platform()}")
    show("packages", ", ".join(f"{each} {version(each)}" for each in PACKAGES))
    compiler = find_compiler()
    slower = f"none: control steps and kinematics are about three times slower; {install_line()}"
    show("compiler", slower if compiler is None else shlex.join(compiler))
    library = find_library()
    show("kernels", "compiled by LLVM at their first use" if library is None else f"built in ({library.name})")
    show("cache", _describe_cache())
    for extra, module in EXTRAS.items():
        missing = find_spec(module) is None
        show(
            "extra", f"{extra}: " + (f"pip install 'manipplan[{extra}]'" if missing else "installed"), "dim" if missing else ""
        )
    passed = []
    for k, (name, test) in enumerate(TESTS.items()):
        with progress() as notify:
            notify(k / len(TESTS), name)
            line, style = _run(name, test)
        show("test", line, style)
        passed.append(not style)
    return int(not all(passed))


def _describe_cache() -> str:
    folder = cache_folder()
    sizes = [file.stat().st_size for file in folder.rglob("*") if file.is_file()]
    nearest = next(each for each in (folder, *folder.parents) if each.exists())
    trouble = "" if os.access(nearest, os.W_OK) else "; it cannot be written: set MANIPPLAN_CACHE to a folder that can"
    return f"{folder}, {sum(sizes) / 1e6:.0f} MB{trouble}"


def _run(name: str, test: Callable[[], str]) -> tuple[str, str]:
    """What a test found, and the style of that line: "" if it did not fail."""
    began = time.perf_counter()
    try:
        found, style = test(), ""
    except MissingExtraError as error:
        found, style = f"left out: {error}", ""
    except ManipplanError as error:
        found, style = f"failed: {error}", "red"
    return f"{name}: {found} ({time.perf_counter() - began:.1f} s)", style


def _plan_planar() -> str:
    job = planar_path()
    return plan(job.robot, job.start, job.goal).status.name


def _plan_among_boxes() -> str:
    job = panda_among_boxes()
    return plan(job.robot, job.start, job.goal, job.scene, clearance=job.clearance).status.name


def _follow_a_line() -> str:
    robot = load_robot("panda")
    begin = robot.kinematics().pose(robot.states["default"])
    end = begin.copy()
    end[1, 3] += 0.1
    return follow(robot, CartesianPath.line(begin, end)).status.name


#: A short test of each kind of job; it returns what it found.
TESTS = {
    "plan of a planar arm": _plan_planar,
    "plan of a Panda among boxes": _plan_among_boxes,
    "path of a Panda's tool": _follow_a_line,
}
