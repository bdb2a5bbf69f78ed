"""The code and numbers of README.md, and of the pages with the same figures, are those that a reader gets."""

import csv
import re
import tomllib
from importlib import metadata
from pathlib import Path
from typing import Any

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import manipplan as mp

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()
PAPERS = (ROOT / "docs" / "studies" / "papers.md").read_text()


def test_the_first_example_prints_what_it_says(tmp_path, monkeypatch, capsys):
    [code] = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    [expected] = re.findall(r"```text\n(.*?)```", README, re.DOTALL)
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out == expected
    assert len(list((tmp_path / "plan").iterdir())) == 7


def test_the_two_commands_install_all_packages_in_exact_versions():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    del extras["menagerie"]  # gigabytes of models, for a benchmark
    exact = [Requirement(line) for line in (ROOT / "requirements.txt").read_text().splitlines() if not line.startswith("#")]
    versions = {canonicalize_name(each.name): str(each.specifier).removeprefix("==") for each in exact}
    waiting = [Requirement(line) for line in [*project["dependencies"], *(line for lines in extras.values() for line in lines)]]
    seen = set()
    while waiting:
        needed = waiting.pop()
        version = versions[canonicalize_name(needed.name)]
        assert version in needed.specifier, str(needed)
        for line in metadata.requires(needed.name) or []:
            further = Requirement(line)
            wanted = any(further.marker is None or further.marker.evaluate({"extra": extra}) for extra in ["", *needed.extras])
            if wanted and str(further) not in seen:
                seen.add(str(further))
                waiting.append(further)


def test_the_first_page_is_short():
    assert len(README.split()) <= 700


@pytest.mark.parametrize("page", ["README.md", "docs/index.md"])
def test_the_first_pages_state_the_numbers_of_the_film(page):
    problem = mp.demo.panda_among_boxes()
    plan = mp.plan(problem.robot, problem.start, problem.goal, problem.scene, clearance=problem.clearance)
    ours, seeds = plan.report.min_manipulability, plan.report.seed_min_manipulability
    text = (ROOT / page).read_text()
    assert f"Minimum manipulability: planner {seeds:.4f}, manipplan {ours:.4f} m⁶." in text
    [code] = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    names: dict[str, Any] = {}
    exec(compile(code[: code.index("plan = ")], page, "exec"), names)
    for shown, wanted in (("start", problem.start), ("goal", problem.goal)):
        assert names[shown] == wanted.tolist()
    boxes = {name: each for name, each in names.items() if isinstance(each, mp.Box)}
    assert [(box.name, *box.size, *box.position) for box in boxes.values()] == [
        (box.name, *box.size, *box.position) for box in problem.scene.obstacles
    ]


def test_figures_of_the_papers_are_those_that_the_studies_assert():
    with (ROOT / "studies" / "dufour2020" / "expected.csv").open(newline="") as file:
        expected = {row["claim"]: float(row["ours"]) for row in csv.DictReader(file)}
    for claim, shown in (
        (
            "(14) at its best one α below (10) at the best α of each path",
            "{least:.1f} to {most:.0f} %, {mean:.1f} % on average",
        ),
        ("(14) at 5e5 below (10) at the α of the paper's own paths", "{least:.1f} to {most:.1f} %, {mean:.1f} % on average"),
    ):
        measured = {what: expected[f"{claim}, {what} [%]"] for what in ("least", "mean", "most")}
        assert shown.format(**measured).replace("-", "−") in PAPERS
    assert f"by up to {expected['deviation of (10) with it, most [mm]'] / 1000:.2f} m" in PAPERS
    with (ROOT / "studies" / "guilamo2006" / "expected.csv").open(newline="") as file:
        expected = {row["claim"]: int(float(row["ours"])) for row in csv.DictReader(file)}
    for claim in (
        "77 × 51 × 78, circle: valid candidates",
        "28 × 18 × 28, circle: valid candidates",
        "circle, coarse: new starts",
    ):
        assert f"{expected[claim]:,}" in PAPERS


def test_links_to_files_exist():
    for target in re.findall(r"\]\(([^)#]+)\)", README):
        if not target.startswith("http"):
            assert (ROOT / target).exists(), target
