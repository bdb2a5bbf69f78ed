"""C sources of our own: told about when they take long, compiled ahead, and each by one thread."""

import logging
import os
import subprocess
import sys
import threading
import time

import pytest

from manipplan.support.compiling import compiler, native
from manipplan.support.compiling.compiler import log_when_slow
from manipplan.support.compiling.native import NativeCode, compile_ahead, native_code, require_code
from manipplan.support.errors import CompilerError


@pytest.fixture
def slow_builds(monkeypatch):
    """Builds take 50 ms; the list of those that were begun."""
    begun = []

    def build(source, subject):
        begun.append((source.name, subject))
        time.sleep(0.05)
        return NativeCode(address=lambda name: 0, owner=None, source=source)

    monkeypatch.setattr(native, "_found", {})
    monkeypatch.setattr(native, "_compile", build)
    return begun


def test_a_long_build_is_told_about_once(monkeypatch, caplog):
    monkeypatch.setattr(compiler, "PATIENCE", 0.02)
    with caplog.at_level(logging.INFO, logger=compiler.log.name):
        with log_when_slow("compiling inverse kinematics"):
            time.sleep(0.1)
        monkeypatch.setattr(compiler, "PATIENCE", 10.0)
        with log_when_slow("something short"):
            pass
    assert [record.getMessage() for record in caplog.records] == ["... compiling inverse kinematics"]


def test_threads_that_need_one_source_share_its_build(slow_builds):
    file, found = native.PACKAGE / "paths" / "curves.c", []
    threads = [threading.Thread(target=lambda: found.append(native_code(file, "curves"))) for _ in range(5)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert slow_builds == [("curves.c", "curves")]
    assert len(found) == 5 and len(set(found)) == 1


@pytest.mark.compiler
def test_sources_are_compiled_ahead_once(slow_builds):
    began = time.perf_counter()
    compile_ahead("paths/curves.c", "search/sweep.c")
    assert time.perf_counter() - began < 0.04, "it does not wait"
    for source in ("search/sweep.c", "paths/curves.c"):
        assert native_code(native.PACKAGE / source, "needed now") is not None
    compile_ahead("paths/curves.c", "search/sweep.c")
    time.sleep(0.02)
    assert sorted(name for name, _ in slow_builds) == ["curves.c", "sweep.c"]


def test_without_a_compiler_nothing_is_compiled_ahead(no_compiler, slow_builds):
    compile_ahead("paths/curves.c")
    time.sleep(0.02)
    assert not slow_builds


def test_jobs_name_sources_that_there_are():
    from manipplan.jobs import plan
    from manipplan.jobs.following import follow

    for job in (follow, plan):
        assert all((native.PACKAGE / source).is_file() for source in job.SOURCES)


def test_code_that_cannot_be_replaced_is_needed(monkeypatch):
    monkeypatch.setattr(native, "native_code", lambda source, subject: None)
    with pytest.raises(CompilerError, match=r"inverse kinematics.*neither a C compiler nor LLVM can compile inverse\.c"):
        require_code(native.PACKAGE / "ik" / "inverse.c", "inverse kinematics")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_child_does_not_wait_for_its_parent_s_threads():
    """A process that is forked during a build compiles for itself."""
    program = """
import os, threading, time
from manipplan.support.compiling import native
file = native.PACKAGE / "paths" / "curves.c"
begun = threading.Event()
def build(source, subject):
    begun.set()
    time.sleep(0.5)
native._compile = build
thread = threading.Thread(target=native.native_code, args=(file, "curves"))
thread.start()
begun.wait()
child = os.fork()
if child == 0:
    native._compile = lambda source, subject: None
    os._exit(0 if native.native_code(file, "curves") is None else 1)
began = time.monotonic()
assert os.waitpid(child, 0)[1] == 0
thread.join()
"""
    subprocess.run([sys.executable, "-W", "ignore", "-c", program], check=True, timeout=60)
