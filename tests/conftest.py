"""What the tests share: real robots, loaded once, and the scene of five boxes."""

import os
import runpy
import shutil
import signal
from pathlib import Path

import numpy as np
import pytest
from examples import FEW

import manipplan as mp
from manipplan.support.compiler import find_compiler

#: Folders of tests that `make test-all` adds, and fixtures whose tests it adds.
SLOW_FOLDERS, SLOW_FIXTURES = ("docs", "problems", "studies"), ("browser",)
#: Maximum time that a test of `make quick` took last time [s], and where the cache knows it.
BRIEF, SECONDS = 0.2, "manipplan/seconds"


def pytest_configure(config):
    """Machine code of the tests is kept in a folder of their own, which all workers and later runs share.

    A $CC or $CXX of this machine that does not work is no failure of the tests, which run without a compiler then.
    """
    os.environ.setdefault("MANIPPLAN_CACHE", str(config.cache.mkdir("manipplan")))
    # each worker is a process of its own, so its linear algebra takes one thread
    for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(threads, "1")
    if "not slow" in config.option.markexpr:
        os.environ[FEW] = "1"
    if not hasattr(config, "workerinput"):  # the process that hears of all tests
        config.pluginmanager.register(Stopwatch(config))
    config.addinivalue_line(
        "filterwarnings", r"ignore:\$(CC|CXX) = .* is not a working compiler:manipplan.support.errors.CompilerWarning"
    )
    config.addinivalue_line("markers", "compiler: needs a C compiler that works")


def pytest_ignore_collect(collection_path, config):
    """`make test` does not even import folders of which it runs nothing."""
    is_slow = collection_path.parent == Path(__file__).parent and collection_path.name in SLOW_FOLDERS
    return True if is_slow and "not slow" in config.option.markexpr else None


def pytest_addoption(parser):
    parser.addoption("--brief", action="store_true", help="of each test the first case, if it took less than BRIEF last time")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    """Mark as slow what `make test` leaves to `make test-all`, and leave out what `make quick` does."""
    here = Path(__file__).parent
    if config.option.brief:
        seconds, first = config.cache.get(SECONDS, {}), {}
        for item in items:
            first.setdefault(item.nodeid.partition("[")[0], item)
        items[:] = [item for item in first.values() if seconds.get(item.nodeid, 0.0) < BRIEF]
    for item in items:
        folder = item.path.relative_to(here).parts[0]
        if folder in SLOW_FOLDERS or set(SLOW_FIXTURES) & set(item.fixturenames):
            item.add_marker(pytest.mark.slow)


class Stopwatch:
    """Remembers in pytest's cache how long each test took, for `make quick`."""

    def __init__(self, config):
        self.config, self.seconds = config, {}

    def pytest_runtest_logreport(self, report):
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration

    def pytest_sessionfinish(self):
        self.config.cache.set(SECONDS, self.config.cache.get(SECONDS, {}) | self.seconds)


def pytest_runtest_setup(item):
    if item.get_closest_marker("compiler") and find_compiler() is None:
        pytest.skip("there is no C compiler that works")


@pytest.fixture(scope="session")
def panda():
    return mp.load_robot("panda")


@pytest.fixture(scope="session")
def ur5():
    return mp.load_robot("ur5")


@pytest.fixture(scope="session")
def planar():
    return mp.planar_arm([1.0, 1.0, 1.0])


@pytest.fixture(scope="session")
def demo_problem():
    return mp.demo.panda_among_boxes()


@pytest.fixture(scope="session")
def demo_plan(demo_problem):
    return mp.plan(demo_problem.robot, demo_problem.start, demo_problem.goal, demo_problem.scene)


@pytest.fixture(scope="module")
def page(request):
    """Names in the gallery's page PAGE of the test's module, after a run of it."""
    import matplotlib

    matplotlib.use("Agg")
    names = runpy.run_path(str(request.module.PAGE))
    yield names
    names["plt"].close("all")


@pytest.fixture(scope="module")
def browser(request):
    """Chromium with the FLAGS of the test's module."""
    from playwright.sync_api import sync_playwright

    found = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    assert found, "no Chromium was found; install it with: sudo apt-get install chromium   (as root: make browser)"
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=found, args=request.module.FLAGS.split())
        yield chromium
        chromium.close()


@pytest.fixture
def no_compiler(monkeypatch):
    monkeypatch.setenv("CC", "")
    find_compiler.cache_clear()
    yield
    monkeypatch.undo()
    find_compiler.cache_clear()


@pytest.fixture
def sigint():
    """Interrupts reach this process and those that it starts; a shell's background job ignores them, and so would they."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def rng():
    return np.random.default_rng(20120521)


@pytest.fixture(scope="session")
def two_link_urdf(tmp_path_factory):
    """A URDF of a revolute and a prismatic joint, with a mimic finger beside the tool; {} is put into the first joint."""

    def write(first_joint: str = "", name: str = "arm.urdf", axis: str = "0 0 1", velocity: str = "1.5") -> str:
        file = tmp_path_factory.mktemp("urdf") / name
        file.write_text(f"""<robot name="two">
  <link name="base"/>
  <link name="upper"><collision><origin xyz="0.25 0 0"/><geometry><box size="0.5 0.1 0.1"/></geometry></collision></link>
  <link name="fore"><collision><origin xyz="0.2 0 0"/><geometry><sphere radius="0.08"/></geometry></collision></link>
  <link name="tip"/><link name="left"/><link name="right"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="{axis}"/>
    <limit lower="-2" upper="2" velocity="{velocity}" effort="10"/>{first_joint}</joint>
  <joint name="slide" type="prismatic"><parent link="upper"/><child link="fore"/><origin xyz="0.5 0 0.2"/>
    <axis xyz="0.6 0 0.8"/><limit lower="0" upper="0.4" velocity="0.3" effort="20"/></joint>
  <joint name="end" type="fixed"><parent link="fore"/><child link="tip"/><origin xyz="0.3 0 0" rpy="0.1 0.2 0.3"/></joint>
  <joint name="finger" type="prismatic"><parent link="fore"/><child link="left"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.1" velocity="0.3" effort="20"/></joint>
  <joint name="mirror" type="prismatic"><parent link="fore"/><child link="right"/><axis xyz="0 -1 0"/>
    <limit lower="0" upper="0.1" velocity="0.3" effort="20"/><mimic joint="finger" multiplier="2" offset="0.01"/></joint>
</robot>""")
        return str(file)

    return write
