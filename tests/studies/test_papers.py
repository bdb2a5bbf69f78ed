"""Every item of the papers has a verdict that its page shows; misprints are what they say; pages are not stale."""

import csv
import importlib.util
import itertools
import shutil

import numpy as np
import pytest

from manipplan.planar import PlanarArm, manipulability
from studies import checklist, misprints, printed
from studies.dufour2020 import config as dufour
from studies.guilamo2006 import config as guilamo
from studies.kth2012 import config as kth
from studies.kth2012 import eikonal

needs_marching = pytest.mark.skipif(
    importlib.util.find_spec("skfmm") is None, reason="needs scikit-fmm: make marching, which builds it by a C compiler"
)
STUDIES = [kth.PAGES, dufour.PAGES, guilamo.PAGES]


def test_every_item_has_a_verdict_that_its_page_shows():
    rows = checklist.items()
    assert len(rows) >= 191
    assert len({(row["paper"], row["item"], row["where"]) for row in rows}) == len(rows)
    assert {row["paper"] for row in rows} == set(checklist.PAPERS)
    assert checklist.faults(rows) == []


@pytest.mark.parametrize(
    ("column", "value"),
    [("verdict", "fine"), ("class", "stable"), ("page", "docs/nowhere.md"), ("shows", "nowhere to be read"), ("shows", "")],
)
def test_a_wrong_row_is_told(column, value):
    rows = checklist.items()
    row = next(row for row in rows if row["verdict"] == "reproduced" and not row["claim"])
    row[column] = value
    [line] = checklist.faults(rows)
    assert row["item"] in line


@pytest.mark.parametrize(("column", "value"), [("ours", "1e9"), ("claim", "no such claim")])
def test_a_wrong_number_is_told(column, value):
    rows = checklist.items()
    row = next(row for row in rows if row["claim"])
    row[column] = value
    [line] = checklist.faults(rows)
    assert row["item"] in line


@pytest.mark.parametrize("table", [*checklist.tables(), misprints.misprints_table()], ids=lambda each: each.name)
def test_the_pages_are_those_of_the_lists(table, tmp_path):
    table.write(tmp_path)
    for file in tmp_path.iterdir():
        assert file.read_text() == (checklist.PAGES / file.name).read_text()


@pytest.mark.parametrize("each", misprints.MISPRINTS, ids=lambda each: f"{each.paper}, {each.place}")
def test_what_is_printed_is_wrong_and_the_correction_is_right(each):
    assert each.how
    if each.values is not None:
        printed_value, right, true = each.values
        assert abs(printed_value - true) > 1e-3
        assert right == pytest.approx(true, rel=2e-5, abs=1e-6)


@pytest.mark.parametrize("pages", STUDIES, ids=lambda pages: pages.name)
def test_pages_are_not_stale(pages):
    assert printed.stale(pages, pages.name) == []


def test_stale_pages_are_told(tmp_path):
    pages = tmp_path / "kth2012"
    shutil.copytree(kth.PAGES, pages)
    (pages / "table5_1.md").write_text("| 3 |")
    (pages / "added.csv").write_text("3")
    (pages / "links.svg").unlink()
    assert printed.stale(pages, "kth2012") == ["added.csv", "links.svg", "table5_1.md"]
    assert "the sources of the study" in printed.stale(pages, "dufour2020")


@pytest.mark.parametrize("pages", STUDIES, ids=lambda pages: pages.name)
def test_pages_agree_with_themselves(pages):
    found = printed.compare(pages, pages)
    assert found.differences == found.left_out == []
    assert found.counts["converged"] > 300


@pytest.mark.parametrize(
    ("study", "table", "row", "column", "share", "told"),
    [
        (kth.PAGES, "table5_1", 1, 1, 1.01, True),
        (kth.PAGES, "table5_1", 1, 1, 1 + 1e-9, False),
        (dufour.PAGES, "real_time", 1, 3, 3.0, False),
        (dufour.PAGES, "claim1", 25, 7, 1.1, False),
        (dufour.PAGES, "claim1", 25, 7, 2.0, True),
        (dufour.PAGES, "literal", 1, 4, 1.1, True),
        (guilamo.PAGES, "resolution", 3, 3, 1.1, True),
    ],
)
def test_a_number_that_differs_is_told(study, table, row, column, share, told, tmp_path):
    made = tmp_path / study.name
    shutil.copytree(study, made)
    with (made / f"{table}.csv").open(newline="") as file:
        rows = list(csv.reader(file))
    [(value, _)] = printed.numbers(rows[row][column])
    rows[row][column] = repr(value * share)
    with (made / f"{table}.csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)
    found = printed.compare(made, study)
    assert bool(found.differences) == told
    assert all(table in line for line in found.differences)


def test_a_table_that_was_not_made_or_is_shorter_is_told(tmp_path):
    made = tmp_path / "kth2012"
    shutil.copytree(kth.PAGES, made)
    (made / "links.csv").unlink()
    (made / "torus.csv").write_text("".join((kth.PAGES / "torus.csv").read_text().splitlines(keepends=True)[:-1]))
    found = printed.compare(made, kth.PAGES, quick=True)
    assert found.differences == []
    assert found.left_out == ["links", "torus"]
    assert "tables left out by --quick: links, torus" in found.summary
    whole = printed.compare(made, kth.PAGES)
    assert whole.differences == ["links: not made", "torus: other rows or columns"]
    assert whole.left_out == []


def test_numbers_of_a_cell():
    assert printed.numbers("2.15 / 2.1451") == [(2.15, 0.01), (2.1451, 0.0001)]
    assert printed.numbers("9.4e-10") == [(9.4e-10, pytest.approx(1e-11))]
    assert printed.numbers("(-2π, 0)") == [(0.0, 1.0)]
    assert printed.numbers("θ₂, T1") == []


def test_comments_and_layout_do_not_change_the_hash(tmp_path, monkeypatch):
    monkeypatch.setattr(printed, "HERE", tmp_path)
    (tmp_path / "tables.py").write_text('"""Tables."""\nA = 1\n')
    (tmp_path / "some").mkdir()
    before = printed.source_hash("some")
    (tmp_path / "tables.py").write_text('"""Other words."""\n\nA = 1  # one\n')
    assert printed.source_hash("some") == before
    (tmp_path / "tables.py").write_text("A = 2\n")
    assert printed.source_hash("some") != before


# The global optimum.


@needs_marching
def test_marching_finds_the_global_optimum():
    found = eikonal.global_optimum(kth.ARM, np.array(kth.SECOND.start), np.array(kth.SECOND.goal), 2.0, (0.1,))
    assert found.path.g == pytest.approx(1.1106673, rel=1e-6)  # of classes.csv, by another first path
    assert found.values[-1] == pytest.approx(found.path.g, rel=5e-3)
    assert found.proven


@needs_marching
def test_marching_near_the_start_is_the_cost_of_a_line():
    start, power = np.array([0.0, 0.8, 1.1]), 1.0
    field = eikonal.solve(kth.ARM, start, [start + 0.5], power, 0.05)
    goal = start + [0.3, 0.0, 0.0]  # μ does not change along it, and is nearly the largest
    assert field(goal)[0] == pytest.approx(0.3 / manipulability(kth.ARM, start), rel=5e-3)
    assert field(start)[0] == pytest.approx(0.0, abs=0.01)


def test_postures_at_a_post_are_left_out():
    arm, post, reach = PlanarArm([1.0, 1.0, 1.0]), (1.2, 0.9), 0.3
    axes = [np.linspace(-1.0, 1.5, 6), np.linspace(-2.0, 2.0, 7), np.linspace(-2.0, 2.0, 8)]
    kept = eikonal.free(arm, axes, [post], reach)
    s = np.linspace(0.0, 1.0, 2001)[:, None]
    for index in np.ndindex(kept.shape):
        joints = arm.joint_positions([axis[k] for axis, k in zip(axes, index, strict=True)])
        points = np.concatenate([a + s * (b - a) for a, b in itertools.pairwise(joints)])
        distance = np.linalg.norm(points - post, axis=1).min()
        assert abs(distance - reach) < 1e-3 or kept[index] == (distance >= reach)
    assert 0 < kept.sum() < kept.size


def test_an_empty_cell_is_told_unless_the_run_is_quick(tmp_path):
    made = tmp_path / "kth2012"
    shutil.copytree(kth.PAGES, made)
    text = (made / "table6_1.csv").read_text()
    assert text.count("2.222248") == 2
    (made / "table6_1.csv").write_text(text.replace(",2.222248,3.5", ",,3.5"))
    assert [line.split(",")[0] for line in printed.compare(made, kth.PAGES).differences] == ["table6_1"]
    assert printed.compare(made, kth.PAGES, quick=True).differences == []
