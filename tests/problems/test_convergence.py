"""benchmarks/convergence.py: what its tables count, on rows made up here, and workers that solve planar problems."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import convergence

ROOT = convergence.ROOT


def answer(g, status="OPTIMAL", **more):
    return {"g": g, "status": status, "first g": 5.0, "clearance": 0.01, "kernels": "Haswell"} | more


def line(table, label):
    """The cells of the table's line that begins with `label`."""
    [found] = [each for each in table if each.startswith(f"| {label} |")]
    return [cell.strip() for cell in found.strip("|").split("|")][1:]


@pytest.mark.parametrize(
    ("over", "under", "wanted"), [(3.0, 2.0, 1.5), (np.inf, 2.0, np.inf), (2.0, np.inf, 0.0), (np.inf, np.inf, np.nan)]
)
def test_ratio_of_finite_and_infinite_g(over, under, wanted):
    np.testing.assert_equal(convergence.ratio(over, under), wanted)


def test_runs_with_another_optimum_are_named():
    values = {"one": (1.0, 2.0, np.inf, 4.0), "two": (1.0 + 1e-7, 2.0, np.inf, np.inf), "three": (1.0, 2.1, np.inf, 4.0)}
    rows = {
        setting: [{"suite": "planar", "name": f"{k}"} | answer(g) for k, g in enumerate(of_setting)]
        for setting, of_setting in values.items()
    }
    table = convergence.table_cpu(rows)
    assert line(table, "planar")[:4] == ["4", "2 of 4 (50.0 %)", "99 %", "inf"]
    assert [each for each in table if each.startswith("- ")] == [
        "- planar, 1: g = 2, OPTIMAL (one and two); g = 2.1, OPTIMAL (three)",
        "- planar, 3: g = 4, OPTIMAL (one and three); g = inf, OPTIMAL (two)",
    ]


def test_problems_worse_than_in_the_old_version_are_named():
    pairs = [(0.5, 1.0, 0.01), (1.0004, 1.0, 0.02), (1.2, 1.0, 0.01005), (2.0, np.inf, 0.5), (np.inf, np.inf, 0.5)]
    rows = [
        {
            "suite": "pairs",
            "name": f"{k}",
            "clearance": 0.01,
            "new": answer(new, clearance=clearance, cpu=2.0),
            "old": answer(old, cpu=1.0 + k),
        }
        for k, (new, old, clearance) in enumerate(pairs)
    ]
    table = convergence.table_old(rows)
    assert line(table, "g over that of 0.1 is at most 1.000") == ["3 of 4 (75.0 %)"]
    assert line(table, "g over that of 0.1: median, worst") == ["0.750, 1.200"]
    assert line(table, "finite g from this version alone; from 0.1 alone") == ["1, 0"]
    assert line(table, "the same, of paths within 0.1 mm of the demanded clearance: median") == ["0.850 of 2"]
    assert line(table, "processor time of `mp.plan` over that of 0.1: median, 90 %, worst") == ["0.67, 1.60, 2.00"]
    assert [each for each in table if each.startswith("- ")] == [
        "- pairs, 2: g = 1.2 (OPTIMAL), with 0.1 1 (OPTIMAL); ratio 1.2000"
    ]


def test_only_optimal_results_count_as_lowered():
    def row(name, last, status="OPTIMAL"):
        solves = [{"g": 1.0, "status": "OPTIMAL"}, {"g": last, "status": "OPTIMAL"}]
        return {"suite": "random", "name": name} | answer(1.0, status) | {"again": solves if status == "OPTIMAL" else []}

    table = convergence.table_again([row("0", 0.9995), row("1", 0.98), row("2", 1.1), row("3", 0.5, "STOPPED_EARLY")])
    assert line(table, "OPTIMAL at first")[0] == "3"
    assert line(table, "others")[0] == "1 STOPPED_EARLY"
    assert line(table, "OPTIMAL, and lowered by more than 0.1 %")[0] == "1"
    assert line(table, "largest lowering")[0] == "2 %"
    assert [each[:14] for each in table if each.startswith("- ")] == ["- random, 1: g"]


def test_pairs_worse_with_degree_12_and_figures_of_certificates():
    rows = [
        {"suite": "random", "name": f"{k}", "6": answer(1.0), "12": answer(g, projected_gradient=g * 1e-7)}
        for k, g in enumerate((0.9, 1.0005, 1.01))
    ]
    table = convergence.table_degree(rows)
    assert line(table, "degree 12 has a g higher by more than 0.1 %") == ["1", "0"]
    assert line(table, "g of degree 12 over that of degree 6: median, worst")[0] == "1.000500, 1.010000"
    label = "`projected_gradient` of 3 certificates of OPTIMAL results: median, largest"
    assert line(table, label)[0] == "1e-07, 1e-07"
    assert not any("complementarity" in each for each in table)


def test_tables_of_other_parts_stay(tmp_path):
    texts = {"old": "a table", "again": "another\n\n- a name"}
    page = convergence.assembled(texts)
    assert convergence.sections(page) == texts
    added = convergence.assembled(convergence.sections(page) | {"cpu": "first"})
    assert list(convergence.sections(added)) == ["cpu", "old", "again"]


def planar():
    """Degree 2, p = 1 of both paths of the planar suite."""
    return [each for each in convergence.planar_tasks() if each["options"] == {"degree": 2, "power": 1}]


def test_kernels_that_are_the_same_or_do_not_run_are_left_out(monkeypatch):
    monkeypatch.setattr(convergence, "kernels_of", {"One": "one", "Two": "one", "Three": "", "Four": "four"}.get)
    cores, left_out = convergence.different(["One", "Two", "Three", "Four"])
    assert cores == ["One", "Four"]
    assert left_out == [
        "For Two OpenBLAS uses the kernels that it uses for One.",
        "This machine cannot run the kernels for Three.",
    ]


def test_a_worker_gives_the_g_of_optimize_path_and_its_answers_are_kept(tmp_path):
    found = convergence.run_cpu(planar(), tmp_path, cores=["Haswell"])
    assert list(found) == ["Haswell, machine code", "Haswell, virtual machine"]
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    for k, given in enumerate(planar()):
        shape, objective = mp.PathShape(degree=2), mp.PathObjective(power=1)
        wanted = mp.optimize_path(arm, given["start"], given["goal"], shape=shape, objective=objective)
        for rows in found.values():
            assert rows[k]["g"] == pytest.approx(wanted.g, rel=1e-6)
            assert rows[k]["status"] == wanted.status.name
            assert np.isfinite(rows[k]["first g"])
    [file] = tmp_path.glob("*machine_code.jsonl")
    changed = file.read_text().replace('"status": "OPTIMAL"', '"status": "KEPT"')
    file.write_text(changed)
    rows = convergence.answered(
        file,
        [each | {"job": "optimise", "options": each["options"] | {"compiled": True}} for each in planar()],
        convergence.sources(ROOT),
        lambda _: pytest.fail("solved again"),
        lambda: None,
    )
    assert [row["status"] for row in rows] == ["KEPT", "KEPT"]


def test_options_are_grouped_for_this_version_and_flat_for_the_old_one(monkeypatch):
    path = mp.JointPath.line([0.0, 1.5, -2.0], [np.pi, -2.0, 2.0])
    options = {"degree": 3, "basis": "bspline", "pieces": 8, "power": 2, "time_limit": 30.0, "clearance": 0.01, "initial": path}
    made = convergence.arguments(options)
    assert sorted(made) == ["clearance", "objective", "seeding", "shape"]
    assert (made["shape"].degree, made["shape"].basis, made["shape"].pieces) == (3, "bspline", 8)
    assert (made["objective"].power, made["clearance"]) == (2, 0.01)
    assert (made["seeding"].time_limit, made["seeding"].initial) == (30.0, path)
    monkeypatch.delattr(mp, "PathObjective")
    assert convergence.arguments(options) is options


def test_the_same_version_twice_has_the_ratio_one_and_answers_a_refused_problem(tmp_path):
    refused = convergence.task("planar", "no way to go", {"lengths": [1.0, 1.0, 1.0]}, [0.0, 1.0, 1.0], [0.0, 1.0, 2000.0])
    rows = convergence.run_old([planar()[0], refused], tmp_path, ROOT)
    assert rows[0]["new"]["g"] == rows[0]["old"]["g"]
    assert rows[0]["new"]["cpu"] > 0
    assert rows[1]["new"]["status"] == "InvalidInputError"
    assert "| problems | 2 |" in convergence.table_old(rows)


def test_a_path_is_optimised_again_from_itself(tmp_path):
    [row] = convergence.run_again(planar()[:1], tmp_path)
    assert len(row["again"]) == 2
    assert (row["pieces"], row["degree"]) == (1, 2)
    assert max(each["g"] for each in row["again"]) <= row["g"] * (1 + 1e-6)


def test_a_worker_that_ends_is_an_error(tmp_path):
    with convergence.Worker(ROOT) as worker, pytest.raises(RuntimeError, match="KeyError"):
        worker({"arm": {"lengths": [1.0, 1.0, 1.0]}, "obstacles": None, "job": "unknown"})


def test_a_worker_with_another_package_is_an_error(tmp_path):
    with convergence.Worker(tmp_path) as worker, pytest.raises(RuntimeError, match="not the package of"):
        worker(planar()[0])


def test_part_old_needs_a_checkout():
    script = [sys.executable, str(ROOT / "benchmarks" / "convergence.py"), "--part", "old"]
    said = subprocess.run(script, capture_output=True, text=True, check=False)
    assert said.returncode == 2
    assert "--old PATH is needed" in said.stderr


def test_suites_have_their_problems():
    pairs = convergence.pairs_tasks(30)
    assert len(pairs) == 60
    groups = [each["name"].rsplit(",", 1)[0] for each in pairs]
    assert {groups.count(each) for each in groups} == {10}
    assert len(convergence.pairs_tasks(50)) == 100
    assert len(convergence.planar_tasks()) == 32
    outside = convergence.outside_tasks(1)
    assert len({each["name"].split(",")[0] for each in outside}) == len(outside) == 7
