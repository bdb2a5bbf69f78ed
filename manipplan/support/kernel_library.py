"""The library of all kernels, `manipplan/csrc/*.c`, which is built when the package is installed.

The installation runs this file on its own, without this package: it imports the standard library only.
"""

import hashlib
import os
import platform
import shlex
import shutil
import subprocess
from pathlib import Path

#: The kernels and their headers.
FOLDER = Path(__file__).parents[1] / "csrc"
#: Each is a source, and a module in LLVM's language in `kernels.ll.xz`.
KERNELS = (
    *("barrier", "batch", "body_motion", "connect", "curves", "distances", "inverse", "near_pairs", "panels"),
    *("servo", "star", "steps", "sweep", "winding"),
)
#: Products and sums are not fused, so that every machine computes the same numbers.
FLAGS = ("-O3", "-fno-fast-math", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-shared", "-fPIC", "-w")
#: Extensions of x86 processors that are used together, and the options for them.
EXTENSIONS = (
    ({"avx2", "fma", "bmi1", "bmi2"}, ("-mavx2", "-mfma", "-mbmi", "-mbmi2")),
    (
        {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"},
        ("-mavx512f", "-mavx512bw", "-mavx512cd", "-mavx512dq", "-mavx512vl"),
    ),
)
#: Time limit of the build [s]; it takes 5 s on a computer of today.
TIME_LIMIT = 600.0
#: Compilers that are tried, unless $CC names one; an empty $CC means none.
USUAL = ("cc", "gcc", "clang")


def find_library() -> Path | None:
    """The library of these sources that this processor can run; None where it was not built."""
    file = library_file()
    return file if file.is_file() else None


def build_library() -> Path:
    """Build the library unless it is there; raises OSError where that fails."""
    file = library_file()
    if file.is_file():
        return file
    new = file.with_suffix(f".{os.getpid()}")
    sources = [str(FOLDER / f"{name}.c") for name in KERNELS]
    command = [*_compiler(), *FLAGS, *_processor_flags(), *sources, "-o", str(new), "-lm"]
    try:
        subprocess.run(command, check=True, stderr=subprocess.PIPE, text=True, timeout=TIME_LIMIT)
    except subprocess.CalledProcessError as error:
        raise OSError(f"{shlex.join(command)}\n{error.stderr.strip()}") from error
    except subprocess.TimeoutExpired as error:
        raise OSError(f"{shlex.join(command)}\ndid not end within {TIME_LIMIT:g} s") from error
    new.replace(file)
    return file


def library_file() -> Path:
    """Where the library is or would be: its name has a hash of all that it is built from."""
    parts = [each.read_bytes() for each in sorted((*FOLDER.glob("*.c"), *FOLDER.glob("*.h")))]
    parts += [" ".join((*KERNELS, *FLAGS, *_processor_flags(), platform.system(), platform.machine())).encode()]
    return FOLDER / f"kernels-{hashlib.sha256(b''.join(parts)).hexdigest()[:16]}.so"


def digest_of(name: str) -> str:
    """Hash of a kernel's source with all headers."""
    files = [FOLDER / f"{name}.c", *sorted(FOLDER.glob("*.h"))]
    return hashlib.sha256(b"".join(each.read_bytes() for each in files)).hexdigest()


def _processor_flags() -> tuple[str, ...]:
    """Options for what this processor can do, of x86 processors only."""
    listing = Path("/proc/cpuinfo")
    if platform.machine() != "x86_64" or not listing.is_file():
        return ()
    able = set(next((line for line in listing.read_text().splitlines() if line.startswith("flags")), "").split())
    return tuple(option for needed, options in EXTENSIONS if needed <= able for option in options)


def _compiler() -> list[str]:
    try:
        commands = [shlex.split(os.environ["CC"])] if "CC" in os.environ else [[name] for name in USUAL]
    except ValueError as error:
        raise OSError(f"$CC = {os.environ['CC']!r} is no command") from error
    for command in commands:
        if command and shutil.which(command[0]):
            return command
    raise OSError("there is no C compiler")


if __name__ == "__main__":
    build_library()
