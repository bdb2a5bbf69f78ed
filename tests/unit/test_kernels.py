"""The kernels: one library that is built with the package, and LLVM's code of the same sources where there is none."""

import ctypes
import gc
import logging
import os
import runpy
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.support import compiler, kernel_library, kernels
from manipplan.support.compiler import log_when_slow
from manipplan.support.kernel_library import KERNELS, build_library, digest_of
from manipplan.support.kernels import compile_by_llvm, kernel_by_llvm, llvm_texts, load_kernel

ANSWER = "define i32 @answer() {\n  ret i32 42\n}\n"


@pytest.fixture
def sources(tmp_path, monkeypatch):
    """A copy of the folder of kernels, without a library."""
    folder = tmp_path / "csrc"
    shutil.copytree(kernel_library.FOLDER, folder, ignore=shutil.ignore_patterns("*.so"))
    monkeypatch.setattr(kernel_library, "FOLDER", folder)
    return folder


@pytest.fixture
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def test_a_long_build_is_logged_once(monkeypatch, caplog):
    monkeypatch.setattr(compiler, "PATIENCE", 0.02)
    with caplog.at_level(logging.INFO, logger=compiler.log.name):
        with log_when_slow("compiling inverse kinematics"):
            time.sleep(0.1)
        monkeypatch.setattr(compiler, "PATIENCE", 10.0)
        with log_when_slow("something short"):
            pass
    assert [record.getMessage() for record in caplog.records] == ["... compiling inverse kinematics"]


def test_llvm_s_texts_are_those_of_the_sources():
    """`make kernels` writes them."""
    assert set(llvm_texts()) == set(KERNELS)
    for name, (digest, text) in llvm_texts().items():
        assert digest == digest_of(name), f"{name}.c was edited: make kernels"
        assert "target" not in text and "define" in text
    assert kernels.LLVM_TEXTS.stat().st_size < 200_000


def test_every_source_is_a_kernel():
    assert {file.stem for file in kernel_library.FOLDER.glob("*.c")} == set(KERNELS)


@pytest.mark.slow
@pytest.mark.compiler
def test_the_library_is_built_once_and_has_every_kernel(sources, monkeypatch):
    assert kernel_library.find_library() is None
    file = build_library()
    built = file.stat().st_mtime_ns
    assert build_library() == file == kernel_library.find_library() and file.stat().st_mtime_ns == built
    assert [each.name for each in sources.glob("kernels-*")] == [file.name]
    library = ctypes.CDLL(str(file))
    for name in KERNELS:
        assert all(hasattr(library, f"manipplan_{each}") for each in kernels.signatures(name))
    (sources / "curves.c").write_text((sources / "curves.c").read_text() + "\n")
    assert kernel_library.find_library() is None, "it is of other sources"


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        ("", "there is no C compiler"),
        ("/nowhere/cc", "there is no C compiler"),
        ("/bin/false", "/bin/false -O3"),
        ("cc 'open", "is no command"),
        ("sh -c 'exec sleep 60'", "did not end within 0.2 s"),
    ],
)
def test_where_no_library_can_be_built_it_says_why(sources, monkeypatch, command, reason):
    monkeypatch.setenv("CC", command)
    monkeypatch.setattr(kernel_library, "TIME_LIMIT", 0.2 if "sleep" in command else 60.0)
    with pytest.raises(OSError, match=reason):
        build_library()
    assert not list(sources.glob("kernels-*"))


def test_the_installation_runs_the_file_on_its_own():
    """It imports nothing but the standard library."""
    found = runpy.run_path(kernel_library.__file__)
    assert found["library_file"]() == kernel_library.library_file()
    code = "import runpy, sys; runpy.run_path(sys.argv[1]); print('numpy' in sys.modules, 'manipplan' in sys.modules)"
    run = subprocess.run([sys.executable, "-c", code, kernel_library.__file__], capture_output=True, text=True, check=True)
    assert run.stdout.split() == ["False", "False"]


def test_edited_sources_are_not_run_as_they_were(sources, monkeypatch):
    monkeypatch.setattr(kernels, "find_library", lambda: None)
    (sources / "curves.c").write_text((sources / "curves.c").read_text() + "\n")
    with pytest.raises(mp.errors.CompilerError, match=r"curves\.c: it was edited and not built; build it with: make kernels"):
        kernel_by_llvm("curves")


def test_a_library_that_cannot_be_loaded_is_not_needed(tmp_path, monkeypatch, caplog):
    (tmp_path / "broken.so").write_bytes(b"garbage" * 100)
    monkeypatch.setattr(kernels, "find_library", lambda: tmp_path / "broken.so")
    kernels._library.cache_clear()
    try:
        with caplog.at_level(logging.WARNING, logger="manipplan"):
            assert kernels._library() is None
        assert "broken.so cannot be loaded, so LLVM compiles the kernels" in caplog.text
    finally:
        kernels._library.cache_clear()


def test_a_kernel_is_loaded_once():
    assert load_kernel("curves") is load_kernel("curves")


@pytest.mark.slow
def test_the_code_lives_as_long_as_its_functions():
    call = kernel_by_llvm("winding").functions()["winding"]
    gc.collect()
    found, points = np.empty(1), np.zeros((1, 3))
    call(None, 0, points.ctypes.data, 1, found.ctypes.data)
    assert found == 0


def answer(engine):
    return ctypes.CFUNCTYPE(ctypes.c_int)(engine.get_function_address("answer"))()


def test_llvm_s_code_is_stored(cache, monkeypatch):
    assert answer(compile_by_llvm(ANSWER, "a test")) == 42
    files = sorted(cache.iterdir())
    assert [file.suffix for file in files] == [".o", ".sha256"]
    monkeypatch.setattr("manipplan.support.kernels._machine_code", None)  # what is stored is not compiled again
    assert answer(compile_by_llvm(ANSWER, "a test")) == 42


@pytest.mark.parametrize("damage", ["truncated", "other bytes", "no checksum", "written by others"])
def test_damaged_code_is_compiled_again(cache, damage):
    compile_by_llvm(ANSWER, "a test")
    (file,) = cache.glob("*.o")
    content = file.read_bytes()
    if damage == "truncated":
        file.write_bytes(content[:100])
    elif damage == "other bytes":
        file.write_bytes(content[::-1])
    elif damage == "no checksum":
        file.with_suffix(".sha256").unlink()
    else:
        file.chmod(0o777)
    assert answer(compile_by_llvm(ANSWER, "a test")) == 42
    assert file.read_bytes() == content and file.with_suffix(".sha256").is_file()


def test_without_a_cache_folder_llvm_compiles_in_each_process(tmp_path, monkeypatch, caplog):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "file" / "cache"))
    with caplog.at_level(logging.INFO, logger="manipplan"):
        assert answer(compile_by_llvm(ANSWER, "a test")) == 42
    assert "a test: compiled by LLVM in each process" in caplog.text


def test_what_llvm_does_not_accept_is_refused(cache):
    with pytest.raises(mp.errors.CompilerError, match="a test: .*parsing error"):
        compile_by_llvm("define nonsense", "a test")


@pytest.mark.slow
def test_a_build_hook_makes_wheels_with_and_without_the_library(tmp_path):
    """For this platform where there is a C compiler, otherwise for all."""
    root, source = Path(mp.__file__).parents[1], tmp_path / "source"
    shutil.copytree(root / "manipplan", source / "manipplan", ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    for name in ("pyproject.toml", "hatch_build.py", "README.md", "LICENSE"):
        shutil.copy(root / name, source)
    names = []
    for change in ({"CC": ""}, {"MANIPPLAN_PURE": "1"}, {}):
        out = tmp_path / str(len(names))
        command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "-w", str(out), "."]
        subprocess.run(command, cwd=source, env=os.environ | change, check=True, timeout=300)
        names += [each.name for each in out.iterdir()]
    pure = [name.endswith("py3-none-any.whl") for name in names]
    assert pure == [True, True, compiler.find_compiler() is None]


@pytest.mark.slow
@pytest.mark.parametrize("name", KERNELS)
def test_llvm_compiles_each_kernel(name):
    """The functions are there by the same names."""
    assert kernel_by_llvm(name).functions().keys() == load_kernel(name).functions().keys()
