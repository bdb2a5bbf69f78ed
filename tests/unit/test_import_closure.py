"""Kernels are compiled again when a file that they are made of changes, and not when another one does."""

import shutil
from pathlib import Path

import pytest

import manipplan
from manipplan.support.compiling.kernels import import_closure, state_of

PACKAGE = Path(manipplan.__file__).parent

FILES = {
    "__init__.py": "from made.viewer import show\n",
    "support/__init__.py": "",
    "support/compiling/kernels.py": "from made.folders import folder\ndef kernel(f): return f\n",
    "folders.py": "folder = 'cache'\n",
    "viewer.py": "def show(): pass\n",
    "search.py": (
        "import math\nfrom typing import TYPE_CHECKING\nimport numpy\n"
        "from made.support.compiling.kernels import kernel\nfrom made import limits\nfrom .room.cells import SIZE\n"
        "if TYPE_CHECKING:\n    from made.typed import Kind\nelse:\n    import made.otherwise\n"
        "class Late:\n    from made.of_class import x\n    def method(self):\n        from made.late import y\n"
    ),
    "limits.py": "import made.numbers as numbers\n",
    "numbers.py": "TAU = 6.28\n",
    "typed.py": "",
    "otherwise.py": "",
    "late.py": "",
    "of_class.py": "x = 1\n",
    "room/__init__.py": "",
    "room/cells.py": "from ..numbers import TAU\nfrom . import steps\nSIZE = 1\n",
    "room/steps.py": "from made.search import kernel\n",  # a circle
}
INSIDE = {
    "search.py",
    "otherwise.py",
    "support/compiling/kernels.py",
    "limits.py",
    "numbers.py",
    "of_class.py",
    "room/cells.py",
    "room/steps.py",
    "room/__init__.py",
}


@pytest.fixture
def made(tmp_path):
    root = tmp_path / "made"
    for name, text in FILES.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    return root


def test_the_closure_is_what_runs_while_a_module_is_imported(made):
    found = import_closure(made / "search.py", made, leaves=[made / "support" / "compiling" / "kernels.py"])
    # `from made import limits` also takes the package itself, which here imports the viewer
    assert {each.relative_to(made).as_posix() for each in found} == INSIDE | {"__init__.py", "viewer.py"}
    whole = import_closure(made / "search.py", made)
    assert {each.relative_to(made).as_posix() for each in whole - found} == {"folders.py"}


@pytest.mark.parametrize("name", FILES)
def test_the_state_changes_with_the_closure_alone(made, name):
    state_of.cache_clear()
    before = state_of(made / "room" / "cells.py", made), state_of(made / "search.py", made)
    (made / name).write_text(FILES[name] + '"""Another line."""\n')
    state_of.cache_clear()
    after = state_of(made / "room" / "cells.py", made), state_of(made / "search.py", made)
    state_of.cache_clear()
    changed = name in INSIDE | {"__init__.py", "viewer.py"}
    assert (after[1] != before[1]) is changed
    assert (after[0] != before[0]) is changed  # a circle: both are made of the same


@pytest.mark.slow
def test_a_copy_of_this_package(tmp_path):
    """The files that kernels really are in: an edit of the viewer keeps their names, one of `steps` changes the search's."""
    copy = tmp_path / "manipplan"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    modules = [file for file in sorted(copy.rglob("*.py")) if "@kernel" in file.read_text()]
    assert len(modules) >= 9

    def states():
        state_of.cache_clear()
        return {file.relative_to(copy).as_posix(): state_of(file, copy) for file in modules}

    def edit(name):
        with (copy / name).open("a") as stream:
            stream.write('\n"""More."""\n')

    before = states()
    for outside in (
        "viz/plan.py",
        "jobs/plan.py",
        "cli/plan.py",
        "tracking/step.py",
        "support/compiling/compiler.py",
        "__init__.py",
    ):
        edit(outside)
    assert states() == before
    edit("search/steps.py")
    changed = {name for name, state in states().items() if state != before[name]}
    assert "search/kernels.py" in changed
    assert not {name for name in changed if name.startswith("ik/")}
    before = states()
    edit("support/compiling/kernels.py")
    assert not set(states().values()) & set(before.values())
    state_of.cache_clear()
