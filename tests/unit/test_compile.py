"""The compiler and its cache: damage, other processes, failing compilers."""

import os
import signal
import shutil
import subprocess
import sys
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.kinematics import compile as module
from manipplan.cache_folder import is_private
from manipplan.kinematics.compile import find_compiler, load_library

SOURCE = "int answer(void) { return 42; }"
BUILD = f"""
from pathlib import Path
from manipplan.kinematics.compile import load_library
print(load_library({SOURCE!r}, Path, subject="a test"))
"""


def shared_library(source, **options):
    """The file of the library."""
    return load_library(source, Path, subject="a test", **options)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def compiler(tmp_path, monkeypatch):
    """Put another compiler in place: a script with this text."""

    def put(text):
        script = tmp_path / "strange-cc"
        script.write_text('#!/bin/sh\nif [ "$1" = --version ]; then echo strange; exit 0; fi\n' + text)
        script.chmod(0o755)
        monkeypatch.setenv("CC", str(script))
        find_compiler.cache_clear()

    yield put
    monkeypatch.undo()
    find_compiler.cache_clear()


def answer(file):
    """In another interpreter, since a loaded library stays."""
    code = f"import ctypes; print(ctypes.CDLL({str(file)!r}).answer())"
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def test_a_library_is_built_once(folder):
    file = shared_library(SOURCE)
    built = file.stat().st_mtime_ns
    assert answer(file) == "42"
    assert shared_library(SOURCE) == file
    assert file.stat().st_mtime_ns == built
    assert shared_library(SOURCE.replace("42", "43")) != file
    assert shared_library(SOURCE, flags=("-O1",)) != file


@pytest.mark.parametrize("damage", ["truncated", "other bytes", "no checksum", "no library"])
def test_a_damaged_entry_is_built_again(folder, damage):
    file = shared_library(SOURCE)
    if damage == "truncated":
        file.write_bytes(file.read_bytes()[:1000])
    elif damage == "other bytes":
        file.write_bytes(file.read_bytes()[::-1])
    elif damage == "no checksum":
        file.with_suffix(".sha256").unlink()
    else:
        file.unlink()
    assert shared_library(SOURCE) == file
    assert answer(file) == "42"
    assert {each.name for each in folder.iterdir()} == {file.name, file.with_suffix(".sha256").name}


def test_several_processes_build_at_once(folder):
    running = [subprocess.Popen([sys.executable, "-c", BUILD], stdout=subprocess.PIPE, text=True) for _ in range(4)]
    files = {process.communicate()[0].strip() for process in running}
    assert all(process.returncode == 0 for process in running)
    assert len(files) == 1
    assert answer(files.pop()) == "42"
    assert len(list(folder.iterdir())) == 2


def test_a_killed_build_leaves_nothing_that_is_used(folder, compiler):
    """The compiler is killed with its process group half way through writing the library."""
    compiler('for last; do :; done\nwhile [ "$1" != -o ]; do shift; done\necho half > "$2"\nsleep 60\n')
    process = subprocess.Popen([sys.executable, "-c", BUILD], start_new_session=True)
    end = time.monotonic() + 60
    while not list(folder.glob("building-*/*.so")):
        assert time.monotonic() < end, "the build never began"
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert not [each for each in folder.iterdir() if not each.name.startswith("building-")]


def test_a_failing_compiler_is_told_once_and_does_no_harm(folder, compiler):
    compiler("echo 'strange-cc: out of ideas' >&2; exit 1")
    robot = mp.planar_arm([1.0, 0.7, 0.4])
    kinematics = robot.kinematics()
    expected = robot.kinematics(compiled=False).manipulability([0.1, 0.5, 0.9])
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        assert kinematics.manipulability([0.1, 0.5, 0.9]) == expected
        assert kinematics.manipulability([[0.1, 0.5, 0.9]])[0] == expected
        assert np.isfinite(kinematics.gradient([0.1, 0.5, 0.9])).all()
    assert [each.category for each in told] == [mp.CompilerWarning]
    assert "out of ideas" in str(told[0].message)
    with pytest.raises(mp.CompilerError, match="out of ideas"):
        robot.kinematics(compiled=True).manipulability([0.1, 0.5, 0.9])


def test_without_a_compiler_nothing_is_told(folder, monkeypatch):
    monkeypatch.setenv("CC", "")
    find_compiler.cache_clear()
    robot = mp.planar_arm([1.0, 0.7, 0.4])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        robot.kinematics().manipulability([0.1, 0.5, 0.9])
    with pytest.raises(mp.CompilerError, match="there is no C compiler; install one with: "):
        robot.kinematics(compiled=True).manipulability([0.1, 0.5, 0.9])
    monkeypatch.undo()
    find_compiler.cache_clear()


def test_a_folder_that_cannot_be_written(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "file" / "cache"))
    with pytest.raises(mp.CompilerError, match="cannot be written"):
        shared_library(SOURCE)
    robot = mp.planar_arm([1.0, 0.7])
    with pytest.warns(mp.CompilerWarning, match="cannot be written"):
        assert robot.kinematics().manipulability([0.1, 0.5]) == robot.kinematics(compiled=False).manipulability([0.1, 0.5])


def test_cache_keys_name_the_processor():
    assert module._processor()


def test_a_library_that_cannot_be_loaded(folder, compiler):
    """A compiler for another machine: its libraries are well-formed files and no use here."""
    compiler('while [ "$1" != -o ]; do shift; done\necho not for this machine > "$2"\n')
    robot = mp.planar_arm([0.9, 0.7, 0.4])
    expected = robot.kinematics(compiled=False).manipulability([0.1, 0.5, 0.9])
    with pytest.warns(mp.CompilerWarning, match="cannot be loaded"):
        assert robot.kinematics().manipulability([0.1, 0.5, 0.9]) == expected
    np.testing.assert_allclose(robot.kinematics().manipulability([[0.1, 0.5, 0.9]]), expected)


def test_a_compiler_with_options(monkeypatch, folder):
    monkeypatch.setenv("CC", "gcc -m64")
    find_compiler.cache_clear()
    assert answer(shared_library(SOURCE)) == "42"
    monkeypatch.undo()
    find_compiler.cache_clear()


def test_old_remains_of_killed_builds_are_removed(folder):
    old, new = folder / "building-old", folder / "building-new"
    for each in (old, new):
        each.mkdir(parents=True)
    os.utime(old, (0, 0))
    shared_library(SOURCE)
    assert not old.exists()
    assert new.exists()


def test_a_cxx_compiler_takes_c_as_c(folder, monkeypatch):
    monkeypatch.setenv("CC", "g++ -ffast-math")
    find_compiler.cache_clear()
    try:
        assert answer(shared_library(SOURCE)) == "42"
    finally:
        monkeypatch.undo()
        find_compiler.cache_clear()


@pytest.mark.parametrize("command", ["/bin/false", "/nowhere/cc", "gcc 'open"])
def test_what_is_no_compiler_is_told(monkeypatch, command):
    monkeypatch.setenv("CC", command)
    find_compiler.cache_clear()
    try:
        with pytest.warns(mp.CompilerWarning, match=r"\$CC"):
            assert find_compiler() is None
    finally:
        monkeypatch.undo()
        find_compiler.cache_clear()
