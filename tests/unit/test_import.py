"""The library is light to import, and each public name has one place."""

import contextlib
import inspect
import pydoc
import subprocess
import sys
from collections import Counter

import pytest

import manipplan as mp

SPACES = ("demo", "errors", "formulations", "measures", "planar", "results", "viz")


def test_the_top_holds_what_a_script_writes():
    assert {name for name in mp.__all__ if inspect.ismodule(getattr(mp, name))} == set(SPACES)
    assert len(mp.__all__) - len(SPACES) <= 66
    assert dir(mp) == sorted([*mp.__all__, "__version__"])


def test_a_public_name_is_in_one_namespace():
    names = Counter(name for space in (mp, *(getattr(mp, each) for each in SPACES)) for name in space.__all__)
    assert [name for name, count in names.items() if count > 1] == []


def test_a_name_that_is_in_a_namespace_is_found_by_the_message():
    with pytest.raises(AttributeError, match="manipplan has no Yoshikawa; it is manipplan.measures.Yoshikawa"):
        mp.Yoshikawa  # noqa: B018  # to read it raises
    assert not hasattr(mp, "nonsense")


@pytest.mark.slow
def test_pictures_and_the_planar_arm_are_imported_when_used():
    code = (
        "import sys, manipplan as mp\n"
        "assert not {'manipplan.planar', 'manipplan.viz'} & set(sys.modules)\n"
        "print(mp.planar.PlanarArm.__name__, mp.viz.draw_figure.__name__)"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert out.split() == ["PlanarArm", "draw_figure"]


@pytest.mark.slow
def test_import_brings_no_heavy_or_optional_package():
    heavy = ("matplotlib", "ompl", "toppra", "scipy", "llvmlite", "viser", "rich", "example_robot_data")
    code = f"import sys, manipplan; print([name for name in {heavy!r} if name in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"


@pytest.mark.slow
def test_missing_descriptions_name_the_install_line():
    code = (
        "import sys; sys.modules['example_robot_data'] = None\n"
        "import manipplan as mp\n"
        "try: mp.load_robot('panda')\n"
        "except mp.errors.MissingExtraError as error: print(error)"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert "pip install 'manipplan[robots]'" in out


@pytest.mark.slow
def test_signatures_are_short_enough_to_read():
    assert len(str(inspect.signature(mp.Box))) < 130
    signature = pydoc.render_doc(mp.plan, renderer=pydoc.plaintext).partition("Plan a motion")[0]
    assert len(signature) < 950 and "goal: Goal," in signature
    for space in (mp, *(getattr(mp, each) for each in SPACES)):
        for name in space.__all__:
            for _, member in [("", getattr(space, name)), *inspect.getmembers(getattr(space, name), inspect.isroutine)]:
                with contextlib.suppress(TypeError, ValueError):  # modules, and what is not written in Python
                    assert "numpy._" not in str(inspect.signature(member)), name
