"""What is read from our C sources is what the compiler makes of them."""

import ctypes
import re
import subprocess

import pytest

from manipplan.support import kernels
from manipplan.support.compiler import find_compiler
from manipplan.support.errors import CompilerError
from manipplan.support.kernel_library import KERNELS
from manipplan.support.kernels import TYPES, signatures, source_text, struct

STRUCTS = {
    "body_motion": ["Arm"],
    "distances": ["World"],
    "near_pairs": ["Dips", "Scan", "Bracket", "Found"],
    "panels": ["Integral"],
    "inverse": ["Form", "Samples", "Solutions", "Screws", "Vector", "Turns"],
    "curves": ["Curve"],
    "sweep": ["Grid", "Cells", "Values", "Step"],
    "connect": ["Constraints", "Side", "Search"],
    "star": ["Star"],
    "barrier": ["Motion", "Descent"],
}


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("source", STRUCTS)
def test_structs_are_laid_out_as_the_compiler_does(source, tmp_path):
    read = {name: struct(source, name) for name in STRUCTS[source]}
    lines = [f'printf("%zu\\n", sizeof({name}));' for name in read]
    lines += [f'printf("%zu\\n", offsetof({name}, {field}));' for name, kind in read.items() for field, _ in kind._fields_]
    text = f"{source_text(source)}\n#include <stddef.h>\n#include <stdio.h>\nint main(void) {{ {' '.join(lines)} return 0; }}\n"
    (tmp_path / "layout.c").write_text(text)
    command = [*find_compiler(), "layout.c", "-o", "layout", "-lm", "-w"]
    subprocess.run(command, cwd=tmp_path, check=True, timeout=120)
    found = subprocess.run([tmp_path / "layout"], capture_output=True, check=True, text=True, timeout=20).stdout.split()
    expected = [ctypes.sizeof(kind) for kind in read.values()]
    expected += [getattr(kind, field).offset for kind in read.values() for field, _ in kind._fields_]
    assert list(map(int, found)) == expected


def test_every_function_of_the_kernels_is_read():
    for source in KERNELS:
        called = re.findall(r"manipplan_(\w+)\(", source_text(source))
        assert set(signatures(source)) == set(called) and called


def test_odd_declarations(tmp_path, monkeypatch):
    monkeypatch.setattr(kernels, "FOLDER", tmp_path)
    (tmp_path / "odd.c").write_text(
        "typedef struct { long k; double (*f)(const void *, double); unsigned char c[2][3], *d; } Whole; /* } Whole; */\n"
        "typedef struct { Whole one, *other; const double *const last; } Nested;\n"
        "typedef struct { Unknown one; } Lost;\n"
        "typedef struct { long bits : 3; } Bits;\n"
        "static int manipplan_hidden(long k) { return 0; }\n"
        "unsigned long long manipplan_shown(const Whole *w, long k,\n                                   double const_x) { return 0; }\n"
    )
    whole = struct("odd", "Whole")
    assert [name for name, _ in whole._fields_] == ["k", "f", "c", "d"] and whole.c.size == 6
    assert signatures("odd")["shown"] == (TYPES["unsigned long long"], ctypes.c_void_p, ctypes.c_long, ctypes.c_double)
    for name, said in (("Lost", "Unknown"), ("Bits", "bits"), ("None", "None")):
        with pytest.raises(CompilerError, match=said):
            struct("odd", name)
