"""The library is light to import."""

import subprocess
import sys


def test_import_brings_no_heavy_or_optional_package():
    heavy = ("matplotlib", "ompl", "toppra", "scipy", "llvmlite", "viser", "rich", "example_robot_data")
    code = f"import sys, manipplan; print([name for name in {heavy!r} if name in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"


def test_missing_descriptions_name_the_install_line():
    code = (
        "import sys; sys.modules['example_robot_data'] = None\n"
        "import manipplan as mp\n"
        "try: mp.load_robot('panda')\n"
        "except mp.MissingExtraError as error: print(error)"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert "pip install 'manipplan[robots]'" in out
