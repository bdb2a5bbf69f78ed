"""The Python of the pages runs as it stands, one page after the other."""

import re
from pathlib import Path

import pytest

PAGES = Path(__file__).parents[2] / "docs"


@pytest.mark.parametrize("page", ["how-the-optimiser-decides", "timing", "kinematics", "tracking", "best-motion"])
def test_the_code_of_a_page_runs(page, tmp_path, monkeypatch):
    text = (PAGES / f"{page}.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    # two things that cost minutes or that only a user has
    blocks = [block for block in blocks if "pinocchio_casadi" not in block and "demonstration.csv" not in block]
    monkeypatch.chdir(tmp_path)
    exec(compile("\n".join(blocks), f"{page}.md", "exec"), {})
    assert blocks
