"""The code and numbers of README.md are those that a reader gets."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()


def test_the_first_example_prints_what_it_says(tmp_path, monkeypatch, capsys):
    [code] = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    [expected] = re.findall(r"```text\n(.*?)```", README, re.DOTALL)
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out == expected
    assert len(list((tmp_path / "plan").iterdir())) == 7


@pytest.mark.parametrize("name", ["panda_boxes", "import_time"])
def test_benchmark_tables_are_those_of_the_documentation(name):
    table = (ROOT / "docs" / "benchmarks" / f"{name}.md").read_text()
    if name == "panda_boxes":
        [shown] = re.findall(r"<!-- benchmark -->\n(.*?)<!-- /benchmark -->", README, re.DOTALL)
        assert shown.strip() == table.strip()
    assert table.startswith("| figure | value |")


def test_links_to_files_exist():
    for target in re.findall(r"\]\(([^)#]+)\)", README):
        if not target.startswith("http"):
            assert (ROOT / target).is_file(), target
