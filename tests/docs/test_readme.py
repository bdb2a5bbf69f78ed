"""The code and numbers of README.md are those that a reader gets."""

import csv
import re
from pathlib import Path

import pytest

import manipplan as mp

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


def test_the_first_page_states_the_gain_of_the_demo():
    problem = mp.demo.panda_among_boxes()
    plan = mp.plan(problem.robot, problem.start, problem.goal, problem.scene, clearance=problem.clearance)
    ours, seeds = plan.report.min_manipulability, plan.report.seed_min_manipulability
    page = " ".join((ROOT / "docs" / "index.md").read_text().split())
    assert f"{ours:.4f} against {seeds:.4f} m⁶" in page
    assert "4.5 times" in page
    assert 4.45 <= ours / seeds < 4.55


def rows(name):
    """The cells of every line of docs/benchmarks/name.md that belongs to a table."""
    lines = (ROOT / "docs" / "benchmarks" / f"{name}.md").read_text().splitlines()
    return [[cell.strip() for cell in line.strip("| ").split(" | ")] for line in lines if line.startswith("| ")]


def test_times_of_control_steps_are_those_of_the_table():
    """README and the page on tracking show the step along a path and the one with active bounds."""
    page = (ROOT / "docs" / "concepts" / "tracking.md").read_text()
    median, high = {}, {}
    for case, step, formulation, count, _, middle, _, slow in rows("control_step")[1:]:
        if (formulation, count) == ("LogDrive", "5"):
            median[case, step], high[case, step] = middle, slow
    path, fast, rest = median
    assert f"| {median[path]}, {high[path]}; " in README
    assert f"| {median[rest]}, {high[rest]} |" in README
    for key in (path, fast, rest):
        assert median[key] in page
    assert f"{float(high[rest].split()[0]):.0f} µs" in page


def test_limitations_state_what_the_benchmarks_count():
    [whole] = [row for row in rows("six_joint_arms") if row[0] == "all"]
    assert f"of {whole[1]} random pairs of four arms {whole[5]} cross as often as the lower bound" in " ".join(README.split())
    assert whole[1] == whole[3] and whole[6] == "100 %", "all are OPTIMAL, with at most two crossings more"
    table = (ROOT / "docs" / "benchmarks" / "motionbenchmaker.md").read_text()
    [(every, refused, free)] = re.findall(r"Of all (\d+) problems (\d+) are refused.* touch nothing in (\d+) of these", table)
    assert f"Of MotionBenchMaker's {every} problems of the Panda {refused} are refused" in " ".join(README.split())
    assert free == "0", "none is refused that the meshes call free"
    becomes, figures, *_ = [row for row in rows("motionbenchmaker") if row[0] == "all"]
    solved, planned, good, inside = re.findall(r"(\d+) of (\d+) get a motion, .* (\d+) of the (\d+) inside the limits", table)[
        0
    ]
    assert planned == becomes[1]
    assert f"| {solved} of {planned} get a motion, {good} of the {inside} inside the limits a proven one" in README
    assert f"time, median and 95 %: {figures[4]} |" in README


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
        assert shown.format(**measured).replace("-", "−") in README
    assert f"by up to {expected['deviation of (10) with it, most [mm]'] / 1000:.2f} m" in README
    with (ROOT / "studies" / "guilamo2006" / "expected.csv").open(newline="") as file:
        expected = {row["claim"]: int(float(row["ours"])) for row in csv.DictReader(file)}
    for claim in (
        "77 × 51 × 78, circle: valid candidates",
        "28 × 18 × 28, circle: valid candidates",
        "circle, coarse: new starts",
    ):
        assert f"{expected[claim]:,}" in README


def test_links_to_files_exist():
    for target in re.findall(r"\]\(([^)#]+)\)", README):
        if not target.startswith("http"):
            assert (ROOT / target).is_file(), target
