"""The compiler and its cache: damage, other processes, failing compilers."""

import hashlib
import os
import shutil
import signal
import subprocess
import sys
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.cost.integral import PathIntegral
from manipplan.cost.objective import energy_density
from manipplan.kinematics import batch, kinematics
from manipplan.optimize.clearance import ClearanceRows, row_functions
from manipplan.support import compiler as module
from manipplan.support.commands import run
from manipplan.support.compiler import find_compiler, load_library
from manipplan.support.files import is_private
from manipplan.symbolic import machine_code

SOURCE = "int answer(void) { return 42; }"
BUILD = f"""
from pathlib import Path
from manipplan.support.compiler import load_library
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


@pytest.mark.compiler
def test_a_library_is_built_once(folder):
    file = shared_library(SOURCE)
    built = file.stat().st_mtime_ns
    assert answer(file) == "42"
    assert shared_library(SOURCE) == file
    assert file.stat().st_mtime_ns == built
    assert shared_library(SOURCE.replace("42", "43")) != file
    assert shared_library(SOURCE, flags=("-O1",)) != file


@pytest.mark.compiler
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


@pytest.mark.slow
@pytest.mark.compiler
def test_several_processes_build_at_once(folder):
    running = [subprocess.Popen([sys.executable, "-c", BUILD], stdout=subprocess.PIPE, text=True) for _ in range(4)]
    files = {process.communicate()[0].strip() for process in running}
    assert all(process.returncode == 0 for process in running)
    assert len(files) == 1
    assert answer(files.pop()) == "42"
    assert len(list(folder.iterdir())) == 2


@pytest.mark.slow
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


@pytest.fixture
def at_once(monkeypatch):
    """Machine code is built at the first evaluation, not when that pays off."""
    monkeypatch.setattr(machine_code, "PAYS_OFF", 0.0)
    monkeypatch.setattr(batch, "PAYS_OFF", 0.0)
    monkeypatch.setattr(kinematics, "FEW", 0)


def test_a_failing_compiler_is_told_once_and_does_no_harm(folder, compiler, at_once):
    compiler("echo 'strange-cc: out of ideas' >&2; exit 1")
    robot = mp.planar_arm([1.0, 0.7, 0.4])
    kin = robot.kinematics()
    expected = robot.kinematics(compiled=False).manipulability([0.1, 0.5, 0.9])
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        assert kin.manipulability([0.1, 0.5, 0.9]) == expected
        np.testing.assert_allclose(kin.manipulability([[0.1, 0.5, 0.9]]), [expected])
        assert np.isfinite(kin.gradient([0.1, 0.5, 0.9])).all()
    assert [each.category for each in told] == [mp.errors.CompilerWarning]
    assert "out of ideas" in str(told[0].message)
    with pytest.raises(mp.errors.CompilerError, match="out of ideas"):
        robot.kinematics(compiled=True).manipulability([0.1, 0.5, 0.9])


def test_without_a_compiler_nothing_is_told(folder, monkeypatch):
    monkeypatch.setenv("CC", "")
    find_compiler.cache_clear()
    robot = mp.planar_arm([1.0, 0.7, 0.4])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        robot.kinematics().manipulability([0.1, 0.5, 0.9])
    with pytest.raises(mp.errors.CompilerError, match="there is no C compiler; install one with: "):
        robot.kinematics(compiled=True).manipulability([0.1, 0.5, 0.9])
    monkeypatch.undo()
    find_compiler.cache_clear()


@pytest.mark.compiler
def test_a_folder_that_cannot_be_written(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "file" / "cache"))
    with pytest.raises(mp.errors.CompilerError, match="cannot be written"):
        shared_library(SOURCE)
    robot = mp.planar_arm([1.0, 0.7])
    with pytest.warns(mp.errors.CompilerWarning, match="cannot be written"):
        assert robot.kinematics().manipulability([0.1, 0.5]) == robot.kinematics(compiled=False).manipulability([0.1, 0.5])


def test_cache_keys_name_the_processor():
    assert module._processor()


def test_a_library_that_cannot_be_loaded(folder, compiler, at_once):
    """A compiler for another machine: its libraries are well-formed files and no use here."""
    compiler('while [ "$1" != -o ]; do shift; done\necho not for this machine > "$2"\n')
    robot = mp.planar_arm([0.9, 0.7, 0.4])
    expected = robot.kinematics(compiled=False).manipulability([0.1, 0.5, 0.9])
    with pytest.warns(mp.errors.CompilerWarning, match="cannot be loaded"):
        assert robot.kinematics().manipulability([0.1, 0.5, 0.9]) == expected
    np.testing.assert_allclose(robot.kinematics().manipulability([[0.1, 0.5, 0.9]]), expected)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="there is no gcc")
def test_a_compiler_with_options(monkeypatch, folder):
    monkeypatch.setenv("CC", "gcc -m64")
    find_compiler.cache_clear()
    assert answer(shared_library(SOURCE)) == "42"
    monkeypatch.undo()
    find_compiler.cache_clear()


@pytest.mark.compiler
def test_old_remains_of_killed_builds_are_removed(folder):
    old, new = folder / "building-old", folder / "building-new"
    for each in (old, new):
        each.mkdir(parents=True)
    os.utime(old, (0, 0))
    shared_library(SOURCE)
    assert not old.exists()
    assert new.exists()


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no g++")
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
        with pytest.warns(mp.errors.CompilerWarning, match=r"\$CC"):
            assert find_compiler() is None
    finally:
        monkeypatch.undo()
        find_compiler.cache_clear()


# ---- libraries that cannot be loaded


def everything_compiled(robot, compiled):
    """All ways to machine code, with their results: one q, many q, rows of paths, density, a control step."""
    q = np.array([0.1, 0.5, 0.9])
    kinematics = robot.kinematics(compiled=compiled)
    found = [kinematics.manipulability(q), kinematics.jacobian(np.tile(q, (2, 1)))]
    column = ClearanceRows.of(3, np.zeros(1), 3, np.ones(3), 0, np.eye(3)[0], 0.1, 0.0).columns[0]
    found.append(np.array(row_functions(kinematics).functions[1](q, column)))
    found.append(np.array(energy_density(PathIntegral(kinematics=kinematics, power=1.0)).functions[1](q, q, [1.0, 1.0, 0.0])))
    controller = mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01, compiled=compiled)
    found.append(controller.step(q, np.zeros(3), kinematics.pose(q)))
    return found, controller


def assert_same(found, expected):
    for one, other in zip(found, expected, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-9, atol=1e-12)


EVERYTHING = """
import sys
sys.path.insert(0, {here!r})
import warnings
import numpy as np
import manipplan as mp
from manipplan.kinematics import batch, kinematics
from test_compiler import everything_compiled
batch.PAYS_OFF = kinematics.FEW = 0  # machine code at the first evaluation
with warnings.catch_warnings(record=True) as told:
    warnings.simplefilter("always")
    found, controller = everything_compiled(mp.planar_arm([1.0, 0.7, 0.4]), "auto")
print(controller.compiled, [each.category.__name__ for each in told])
"""


def in_another_process():
    """What `everything_compiled` says there, where no library is loaded yet."""
    code = EVERYTHING.format(here=str(Path(__file__).parent))
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout.strip()


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("content", ["garbage", "an empty file", "the library of another function"])
def test_a_library_that_cannot_be_loaded_is_built_again(folder, content):
    """Its checksum fits, or fits another library: it was damaged before it was summed up, or copied there."""
    assert in_another_process() == "True []"
    files = sorted(folder.glob("*.so"))
    assert len(files) >= 3
    before = [file.read_bytes() for file in files]
    for file, other in zip(files, files[1:] + files[:1], strict=True):
        if content == "the library of another function":
            file.write_bytes(before[files.index(other)])
            file.with_suffix(".sha256").write_text(hashlib.sha256(other.name.encode() + file.read_bytes()).hexdigest())
        else:
            file.write_bytes(b"garbage" * 1000 if content == "garbage" else b"")
            file.with_suffix(".sha256").write_text(module.digest(file.read_bytes(), file))
            assert module.is_sound(file)
    assert in_another_process() == "True []"
    assert all(file.stat().st_size > 8000 and module.is_sound(file) for file in files)


@pytest.mark.compiler
def test_libraries_that_can_never_be_loaded(folder, compiler, tmp_path):
    """As in a cache folder on a file system that forbids execution: one warning, CasADi's virtual machine, no more builds."""
    calls = tmp_path / "calls"
    compiler(f'echo call >> {calls}\nwhile [ "$1" != -o ]; do shift; done\necho no library > "$2"\n')
    robot = mp.planar_arm([1.0, 0.7, 0.4])
    expected, _ = everything_compiled(robot, False)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found, controller = everything_compiled(robot, "auto")
    assert_same(found, expected)
    assert not controller.compiled
    assert [each.category for each in told] == [mp.errors.CompilerWarning]
    assert "cannot be loaded" in str(told[0].message)
    assert calls.read_text().split() == ["call"]
    for ask in (
        lambda: robot.kinematics(compiled=True).manipulability(np.zeros(3)),
        lambda: robot.kinematics(compiled=True).manipulability(np.zeros((2, 3))),
        lambda: row_functions(robot.kinematics(compiled=True)),
        lambda: mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01, compiled=True),
    ):
        with pytest.raises(mp.errors.CompilerError, match="cannot be loaded"):
            ask()


# ---- compilers that hang


@pytest.fixture
def short_limits(monkeypatch):
    monkeypatch.setattr(module, "VERSION_LIMIT", 0.5)
    monkeypatch.setattr(module, "BUILD_LIMIT", 1.0)


def gone(file):
    """Whether the process whose number is in `file` has ended."""
    end = time.monotonic() + 10
    while time.monotonic() < end:
        try:
            state = Path(f"/proc/{file.read_text().strip()}/stat").read_text().rpartition(")")[2].split()[0]
        except FileNotFoundError:
            return True
        if state == "Z":
            return True
        time.sleep(0.05)
    return False


#: Starts a child, as compilers start assemblers, and waits with it for a time that no test takes.
HANG = "sleep 300 & echo $! > {child}\nwait\n"


@pytest.mark.slow
def test_a_build_that_hangs_is_given_up_with_its_children(folder, compiler, short_limits, tmp_path):
    child = tmp_path / "child"
    compiler(HANG.format(child=child))
    robot = mp.planar_arm([1.0, 0.7, 0.4])
    expected, _ = everything_compiled(robot, False)
    began = time.monotonic()
    with pytest.warns(mp.errors.CompilerWarning, match="did not end within 1 s") as told:
        found, controller = everything_compiled(robot, "auto")
    assert time.monotonic() - began < 20
    assert len(told) == 1
    assert_same(found, expected)
    assert not controller.compiled
    assert gone(child)
    with pytest.raises(mp.errors.CompilerError, match="did not end within 1 s"):
        mp.Controller(robot, mp.formulations.LogDrive(), dt=0.01, compiled=True)
    assert not list(folder.glob("building-*"))


@pytest.mark.slow
@pytest.mark.parametrize("named", [True, False])
def test_a_compiler_that_never_tells_its_version_is_given_up(folder, monkeypatch, short_limits, tmp_path, named):
    child, script = tmp_path / "child", tmp_path / "bin" / "cc"
    script.parent.mkdir()
    script.write_text("#!/bin/sh\nPATH=/usr/bin:/bin\n" + HANG.format(child=child))
    script.chmod(0o755)
    if named:
        monkeypatch.setenv("CC", str(script))
    else:
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setenv("PATH", str(script.parent))
    find_compiler.cache_clear()
    try:
        with pytest.warns(mp.errors.CompilerWarning, match=r"--version did not end within 0.5 s"):
            assert find_compiler("c") is None
        assert gone(child)
        robot = mp.planar_arm([1.0, 0.7])
        q = [0.1, 0.5]
        assert robot.kinematics().manipulability(q) == robot.kinematics(compiled=False).manipulability(q)
        with pytest.raises(mp.errors.CompilerError, match="not a working compiler" if named else "there is no C compiler"):
            robot.kinematics(compiled=True).manipulability(q)
    finally:
        monkeypatch.undo()
        find_compiler.cache_clear()


@pytest.mark.slow
def test_an_interrupt_stops_the_compiler_and_its_children(folder, compiler, tmp_path, sigint):
    child = tmp_path / "child"
    compiler(HANG.format(child=child))
    process = subprocess.Popen([sys.executable, "-c", BUILD], stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + 60
    while not (child.is_file() and child.read_text().strip()):
        assert time.monotonic() < end, "the build never began"
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in process.communicate(timeout=60)[1]
    assert gone(child)
    assert list(folder.iterdir()) == []


def test_a_command_is_run_without_a_shell_and_all_it_says_is_kept():
    said = run(
        [sys.executable, "-c", "import sys; print(sys.argv[1:]); sys.exit(sys.stdin.read() or 'bad \\xff')", "$(x)"], limit=60
    )
    assert (said.returncode, said.stdout, said.stderr) == (1, "['$(x)']\n", "bad \xff\n")
    with pytest.raises(FileNotFoundError):
        run(["/nowhere/cc"], limit=1)


# ---- what other users can write


posix = pytest.mark.skipif(os.name != "posix", reason="needs POSIX permissions")
root = pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root can give files to another user")


@posix
@pytest.mark.compiler
@pytest.mark.parametrize("which", ["library", "checksum"])
@pytest.mark.parametrize("mode", [0o775, 0o757])
def test_a_file_that_others_can_write_is_built_again(folder, which, mode):
    file = shared_library(SOURCE)
    open_ = file if which == "library" else file.with_suffix(".sha256")
    before = file.stat().st_ino
    open_.chmod(mode)
    assert shared_library(SOURCE) == file
    assert file.stat().st_ino != before
    assert is_private(file) and is_private(file.with_suffix(".sha256"))
    assert answer(file) == "42"


@root
@pytest.mark.compiler
def test_another_user_s_library_is_built_again(folder, monkeypatch):
    """As this user, root, sees files of another one, and as that one sees those of a third."""
    file = shared_library(SOURCE)
    other = file.read_bytes().replace(b"\x2a\x00\x00\x00", b"\x2b\x00\x00\x00", 1)
    file.write_bytes(other)
    file.with_suffix(".sha256").write_text(module.digest(file.read_bytes(), file))
    assert module.is_sound(file)
    assert answer(file) == "43"
    for each in (file, file.with_suffix(".sha256")):
        os.chown(each, 12345, 12345)
    assert answer(shared_library(SOURCE)) == "42"
    assert file.stat().st_uid == 0
    monkeypatch.setattr(os, "geteuid", lambda: 54321)
    assert is_private(file)
    os.chown(file, 12345, 12345)
    assert not is_private(file)


@posix
@pytest.mark.compiler
@pytest.mark.parametrize("mode", [0o777, 0o1777, 0o770])
def test_in_a_shared_cache_folder_each_user_has_a_folder_of_his_own(folder, mode):
    folder.mkdir()
    folder.chmod(mode)
    file = shared_library(SOURCE)
    assert file.parent == folder / f"user-{os.geteuid()}"
    assert file.parent.stat().st_mode & 0o777 == 0o700
    assert answer(file) == "42"
    file.parent.chmod(0o777)
    with pytest.raises(mp.errors.CompilerError, match="another user can write to it"):
        shared_library(SOURCE)
    robot = mp.planar_arm([1.0, 0.7])
    with pytest.warns(mp.errors.CompilerWarning, match="another user can write to it"):
        assert robot.kinematics().manipulability([0.1, 0.5]) == robot.kinematics(compiled=False).manipulability([0.1, 0.5])


@posix
@pytest.mark.compiler
def test_a_lax_umask_does_no_harm(folder):
    before = os.umask(0o000)
    try:
        file = shared_library(SOURCE)
    finally:
        os.umask(before)
    assert file.parent == folder
    built = file.stat().st_mtime_ns
    assert shared_library(SOURCE) == file
    assert file.stat().st_mtime_ns == built


@posix
@pytest.mark.compiler
def test_a_link_is_not_followed(folder, tmp_path):
    file = shared_library(SOURCE)
    file.rename(tmp_path / "elsewhere.so")
    file.symlink_to(tmp_path / "elsewhere.so")
    assert shared_library(SOURCE) == file
    assert not file.is_symlink()
