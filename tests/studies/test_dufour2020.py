"""The figures of the study are those of expected.csv, and of its page."""

import csv

import numpy as np
import pytest

import manipplan as mp
from studies import printed
from studies.dufour2020 import claims, config, run
from studies.dufour2020.follow import Arm
from studies.dufour2020.make_paths import demonstrated
from studies.report import study_text


@pytest.fixture(scope="module")
def arm():
    return Arm()


@pytest.mark.long  # the whole study runs the same stages
def test_the_quick_study_makes_what_is_expected(tmp_path):
    assert run.STUDY.main(["--quick", "--out", str(tmp_path)]) == []
    assert {file.name for file in tmp_path.glob("*.png")} == {
        *(f"scenario{k}.png" for k in (1, 2, 3, 4)),
        "claim1.png",
        "stiffness.png",
        "hessians.png",
        "pareto_S1.png",
        "times.png",
    }


@pytest.mark.slow
def test_the_whole_study_makes_what_is_expected(tmp_path):
    assert run.STUDY.main(["--out", str(tmp_path)]) == []
    assert {file.name for file in tmp_path.iterdir()} == {file.name for file in config.PAGES.iterdir()} - {printed.STAMP}


def test_a_difference_is_told():
    found = [claims.Claim(text=text, paper="", value=value) for text, value, _ in claims.expected()]
    assert claims.differences(found) == []
    found[2] = claims.Claim(text=found[2].text, paper="", value=found[2].value + 1)
    [line] = claims.differences(found)
    assert found[2].text in line
    assert claims.differences(found[3:])


def test_the_page_shows_what_is_expected():
    with (config.PAGES / "claims.csv").open(newline="") as file:
        rows = [claims.Claim(text=row["claim"], paper=row["paper"], value=float(row["ours"])) for row in csv.DictReader(file)]
    assert claims.differences(rows) == []
    page = study_text(config.PAGES.with_suffix(".md"))
    for figure in config.PAGES.glob("*.png"):
        assert figure.stat().st_size < 300_000
        assert f"dufour2020/{figure.name}" in page


def test_the_demonstrations_are_those_of_the_script(arm):
    for demonstration in config.DEMONSTRATIONS:
        t, q = demonstrated(arm.robot, demonstration)
        table = np.loadtxt(config.PATHS / f"{demonstration.name}.csv", delimiter=",", skiprows=1)
        np.testing.assert_allclose(table, np.column_stack([t, q]), atol=5.1e-5)


def test_a_run_is_that_of_track(arm):
    course = arm.courses["S1"]
    ours = arm.follow("S1", "(14)", config.ONE_ALPHA)
    tracked = mp.track(
        arm.robot,
        course.path,
        course.start,
        mp.formulations.Equality(config.ONE_ALPHA),
        dt=config.DT,
        duration=course.duration,
        task=config.TASK,
        stiffness=config.STIFFNESS,
        approach=config.DEAD_BEAT,
    )
    assert tracked.status is mp.Status.TRACKED
    steps = ours.steps + 1
    np.testing.assert_allclose(ours.q[:steps], tracked.q[:steps], atol=1e-6)
    np.testing.assert_allclose(ours.deviation[:steps], tracked.deviation[:steps], atol=1e-6)
