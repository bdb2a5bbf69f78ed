"""The code and numbers of README.md, and of the pages with the same figures, are those that a reader gets."""

import csv
import re
from pathlib import Path
from typing import Any

import pytest

import manipplan as mp

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()
HEADLINES = (ROOT / "docs" / "benchmarks.md").read_text().split("## The scripts")[0]
PAPERS = (ROOT / "docs" / "studies" / "papers.md").read_text()
LIMITS = " ".join((ROOT / "docs" / "limits.md").read_text().split())


def test_the_first_example_prints_what_it_says(tmp_path, monkeypatch, capsys):
    [code] = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    [expected] = re.findall(r"```text\n(.*?)```", README, re.DOTALL)
    monkeypatch.chdir(tmp_path)
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out == expected
    assert len(list((tmp_path / "plan").iterdir())) == 7


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


def rows(name):
    """The cells of every line of docs/benchmarks/name.md that belongs to a table."""
    lines = (ROOT / "docs" / "benchmarks" / f"{name}.md").read_text().splitlines()
    return [[cell.strip() for cell in line.strip("| ").split(" | ")] for line in lines if line.startswith("| ")]


def test_times_of_control_steps_are_those_of_the_table():
    """README, the headlines and the page on tracking show the step along a path and the one with active bounds."""
    page = (ROOT / "docs" / "concepts" / "tracking.md").read_text()
    median, high = {}, {}
    for case, step, formulation, count, _, middle, _, slow in rows("control_step")[1:]:
        if (formulation, count) == ("LogDrive", "5"):
            median[case, step], high[case, step] = middle, slow
    path, fast, rest = median
    assert f"| {median[path]}, 99 %: {high[path]} |" in README
    assert f"| {median[path]}, {high[path]}; " in HEADLINES
    assert f"| {median[rest]}, {high[rest]} |" in HEADLINES
    for key in (path, fast, rest):
        assert median[key] in page
    assert f"{float(high[rest].split()[0]):.0f} µs" in page


def test_limitations_state_what_the_benchmarks_count():
    [whole] = [row for row in rows("six_joint_arms") if row[0] == "all"]
    assert f"of {whole[1]} random pairs of four arms {whole[5]} cross as often as the lower bound" in LIMITS
    assert whole[1] == whole[3] and whole[6] == "100 %", "all are OPTIMAL, with at most two crossings more"
    table = (ROOT / "docs" / "benchmarks" / "motionbenchmaker.md").read_text()
    [(every, refused, free)] = re.findall(r"Of all (\d+) problems (\d+) are refused.* touch nothing in (\d+) of these", table)
    assert f"Of MotionBenchMaker's {every} problems of the Panda {refused} are refused" in LIMITS
    assert free == "0", "none is refused that the meshes call free"
    becomes, figures, *_ = [row for row in rows("motionbenchmaker") if row[0] == "all"]
    [(solved, planned, good, inside)] = re.findall(
        r"(\d+) of (\d+) get a motion, .* (\d+) of the (\d+) inside the limits", table
    )
    assert planned == becomes[1]
    median, high = figures[4].split(", ")
    assert f"| MotionBenchMaker, Panda: {planned} problems, {refused} of them beyond limits |" in README
    assert good == inside and f"| all {good} others solved and proven; {median} in the median, 95 %: {high} |" in README
    assert f"| {solved} of {planned} get a motion, {good} of the {inside} inside the limits a proven one" in HEADLINES
    assert f"time, median and 95 %: {figures[4]} |" in HEADLINES


def test_counts_of_the_first_page_are_those_of_the_tables():
    [every] = [row for row in rows("timed_motions") if row[0] == "all"]
    assert f"| timed motions that are free by the meshes | {every[2]}; mplib {every[3].split()[0]} |" in README
    sets = [row for row in rows("programs") if row[0] == "**all**"]
    solved, asked = (sum(int(row[k]) for row in sets) for k in (2, 1))
    medians, worst = [float(row[9].split()[0]) for row in sets], max(float(row[11].split()[0]) for row in sets)
    text = f"{solved} of {asked}; {medians[0]:.2f} and {medians[1]:.2f} s in the median, {worst:.1f} s at most"
    assert f"| programs of eight moves, three arms | {text} |" in README
    arms = [row for row in rows("two_arms") if row[0] != "robot"]
    solved, asked = (sum(int(row[k]) for row in arms) for k in (2, 1))
    medians, worst = [float(row[3].split()[0]) for row in arms], max(float(row[5].split()[0]) for row in arms)
    text = f"{solved} of {asked}; {min(medians):.1f} to {max(medians):.1f} s in the median, {worst:.1f} s at most"
    assert f"| both arms of Baxter, TIAGo, TALOS | {text} |" in README


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
