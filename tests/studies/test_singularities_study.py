"""The study of singularities makes what is expected, and a wrong slope is told."""

import re

import pytest

from manipplan import cli
from studies.singularities import run, slopes

pytestmark = pytest.mark.slow


def test_the_study_makes_what_is_expected(tmp_path, capsys):
    assert cli.main(["study", "singularities", "--out", str(tmp_path)]) == 0
    assert "singularities: all figures are as expected" in capsys.readouterr().out
    assert {file.name for file in tmp_path.iterdir()} == {file.name for file in run.PAGES.iterdir()} | {"report.html"}
    for file in run.PAGES.glob("*.md"):
        assert (tmp_path / file.name).read_text() == file.read_text()
    report = (tmp_path / "report.html").read_text()
    assert report.count("<img ") == 1
    assert report.count("<table>") == 2
    assert not re.search(r'(?:src|href)="(?!data:)', report)


def test_slopes_count_the_crossings_of_two_links():
    series = slopes.planar()
    assert [len(each.crossings) for each in series] == [0, 1, 2, 3]
    for count, each in enumerate(series):
        assert each.slope == pytest.approx(count * 2 * 1.25**0.5, abs=1e-8)
        assert each.error < 2e-11


def test_a_difference_is_told():
    found = {name: value for each in slopes.planar() for name, value in run.numbers(each)}
    assert any("not in both" in line for line in run.wrong(found))
