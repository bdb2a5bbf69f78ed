"""The figures of the study are those of expected.csv, of its page, and of calculations that share nothing with it."""

import csv
import itertools
import re
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from numpy.testing import assert_allclose

import manipplan as mp
from manipplan import cli
from manipplan.planar import PlanarArm, manipulability
from studies import printed
from studies.kth2012 import claims, classes, config, figures, geodesics, polynomials, results, run, starts, tables_postures
from studies.report import study_text


def quick_figures():
    return set(figures.figures(results.Results(quick=True))) - set(figures.FULL_ONLY)


def test_the_quick_study_makes_what_is_expected(tmp_path, capsys):
    assert cli.main(["study", "kth2012", "--quick", "--out", str(tmp_path)]) == 0
    assert "kth2012: all figures are as expected" in capsys.readouterr().out
    assert {file.stem for file in tmp_path.glob("*.svg")} == quick_figures()
    report = (tmp_path / "report.html").read_text()
    assert report.count("<img ") == len(quick_figures())
    assert report.count("<table>") == len(list(tmp_path.glob("*.md")))
    left = {file.stem for file in config.PAGES.iterdir() if file.name != printed.STAMP} - {
        file.stem for file in tmp_path.iterdir()
    }
    assert set(figures.FULL_ONLY) < left
    assert set(re.findall(r">(\w+): left out by --quick", report)) == left
    assert not re.search(r'(?:src|href)="(?!data:)', report)
    for value in ("2.63463340", "2.2222", "Chapter 6"):
        assert value in report


def test_differences_are_told_in_report_and_exit_code(tmp_path, capsys, monkeypatch):
    made = replace(run.STUDY, make=lambda _out, _quick, _tell: [], differences=lambda _found, _quick: ["Table <6.1>: 2, not 3"])
    monkeypatch.setattr(run, "STUDY", made)
    assert cli.main(["study", "kth2012", "--quick", "--out", str(tmp_path)]) == 1
    assert "1 figures of kth2012 are not as expected" in capsys.readouterr().err
    assert "Table &lt;6.1&gt;: 2, not 3" in (tmp_path / "report.html").read_text()


@pytest.mark.slow
def test_the_whole_study_makes_what_is_expected(tmp_path):
    assert run.STUDY.main(["--out", str(tmp_path)]) == []
    assert {file.name for file in tmp_path.iterdir()} == {file.name for file in config.PAGES.iterdir()} - {printed.STAMP}


@pytest.mark.slow
@pytest.mark.parametrize("case", range(len(config.POSTS)))
def test_paths_among_posts_are_measured_anew(case):
    """g and the distances of links and posts, from the joints' angles alone."""
    example, posts = config.POSTS[case]
    found = results.Results(quick=False).among(example, posts)
    q = found.path(np.linspace(0.0, 1.0, 20001))
    angles = np.cumsum(q, axis=1)
    joints = np.zeros((len(q), 4, 2))
    joints[:, 1:] = np.cumsum(np.stack([np.cos(angles), np.sin(angles)], axis=-1), axis=1)
    links = np.diff(joints, axis=1)
    for post in posts:
        away = post - joints[:, :-1]
        along = np.clip((away * links).sum(axis=-1) / (links**2).sum(axis=-1), 0.0, 1.0)
        distance = np.linalg.norm(away - along[..., None] * links, axis=-1).min() - config.POST_RADIUS - 0.05
        assert distance >= config.CLEARANCE
    lever = joints[:, -1:] - joints[:, :-1]
    jacobian = np.stack([-lever[..., 1], lever[..., 0]], axis=1)
    m = np.sqrt(np.linalg.det(jacobian @ jacobian.swapaxes(1, 2)))
    g = (np.linalg.norm(np.diff(q, axis=0), axis=1) / ((m[1:] + m[:-1]) / 2) ** config.TABLE_POWER).sum()
    assert g == pytest.approx(found.g, rel=1e-6)
    [wanted] = [
        v for text, v, _ in claims.expected(quick=False) if text == f"{example.name} among {len(posts)} of the posts: g"
    ]
    assert g == pytest.approx(wanted, rel=1e-4)


def test_a_difference_is_told():
    found = [claims.Claim(text=text, thesis="", value=value) for text, value, _ in claims.expected(quick=False)]
    assert claims.differences(found, quick=False) == []
    found[2] = claims.Claim(text=found[2].text, thesis="", value=found[2].value + 1000)
    [line] = claims.differences(found, quick=False)
    assert found[2].text in line
    assert claims.differences(found[3:], quick=False)


def test_the_page_shows_what_is_expected():
    with (config.PAGES / "claims.csv").open(newline="") as file:
        rows = [
            claims.Claim(text=row["figure"], thesis=row["thesis"], value=float(row["ours"])) for row in csv.DictReader(file)
        ]
    assert claims.differences(rows, quick=False) == []
    page = study_text(config.PAGES.with_suffix(".md"))
    assert {file.stem for file in config.PAGES.glob("*.svg")} == set(figures.figures(results.Results(quick=False)))
    for file in config.PAGES.iterdir():
        if file.suffix in (".svg", ".md"):
            assert file.stat().st_size < 300_000
            assert f"kth2012/{file.name}" in page


# Tables 5.1 and 5.2 from J itself with 30 digits, by another solver and from the thesis' two digits.


def squared(second, third):
    one, two, three = 0, second, second + third
    x = [mpmath.cos(one), mpmath.cos(two), mpmath.cos(three)]
    y = [mpmath.sin(one), mpmath.sin(two), mpmath.sin(three)]
    j = mpmath.matrix([[-sum(y[i:]) for i in range(3)], [sum(x[i:]) for i in range(3)]])
    return mpmath.det(j * j.T), sum(x) ** 2 + sum(y) ** 2, j


def slope(function, point):
    return [mpmath.diff(function, tuple(point), order) for order in ((1, 0), (0, 1))]


def test_table_5_1_with_thirty_digits():
    with mpmath.workdps(30):
        solved = mpmath.findroot(lambda a, b: slope(lambda *x: squared(*x)[0], (a, b)), config.TABLE_5_1[1:3])
        square, radius, _ = squared(*solved)
        exact = [float(mpmath.sqrt(radius)), *map(float, solved), float(mpmath.sqrt(square))]
    best = results.Results(quick=True).free.best
    ours = [best.radius[0], *np.abs(best.q[0, 1:]), best.manipulability[0]]
    assert_allclose(ours, exact, rtol=0, atol=1e-9)


@pytest.mark.parametrize("radius", [1.4, 1.8, 2.2, 2.6])
def test_table_5_2_with_thirty_digits(radius):
    def conditions(a, b):
        """The gradients of μ² and R² are parallel, and R is what is asked for."""
        of_index, of_radius = (slope(lambda *x, k=k: squared(*x)[k], (a, b)) for k in (0, 1))
        return of_index[0] * of_radius[1] - of_index[1] * of_radius[0], squared(a, b)[1] - mpmath.mpf(str(radius)) ** 2

    with mpmath.workdps(30):
        solved = mpmath.findroot(conditions, config.TABLE_5_2[radius][:2])
        square, _, j = squared(*solved)
        values = mpmath.svd_r(j, compute_uv=False)
        exact = [*map(float, solved), float(mpmath.sqrt(square)), float(min(values) / max(values))]
    assert_allclose(tables_postures.row_5_2(results.Results(quick=True), radius), exact, rtol=0, atol=1e-9)


def test_table_5_2_at_its_ends():
    kept = results.Results(quick=True)
    right = [np.pi / 2, np.pi / 2, np.sqrt(3.0), 1 / np.sqrt(3.0)]  # a square without its fourth side
    assert_allclose(tables_postures.row_5_2(kept, 1.0), right, rtol=0, atol=1e-9)
    assert_allclose(tables_postures.row_5_2(kept, 3.0), np.zeros(4), rtol=0, atol=1e-9)


def test_no_posture_of_a_fine_grid_is_better():
    angles = np.linspace(-np.pi, np.pi, 721)
    q = np.stack(np.broadcast_arrays(0.0, angles[:, None], angles), axis=-1)
    mu, radius = manipulability(config.ARM, q), config.ARM.radius(q)
    kept = results.Results(quick=True)
    assert mu.max() <= kept.free.manipulability[0] < mu.max() + 1e-3
    inside = (np.abs(q[..., 1:]) <= np.pi / 2 + 1e-9).all(axis=-1)
    for each in config.TABLE_5_2:
        if 1.0 < each < 3.0:
            near = mu[inside & (np.abs(radius - each) < 2e-3)].max()
            assert abs(tables_postures.row_5_2(kept, each)[2] - near) < 5e-3


def test_stationary_postures_obey_euler():
    kinds = [tables_postures.stationary_kind(config.ARM, q) for q in results.Results(quick=True).free.q]
    assert kinds.count("maximum") - kinds.count("saddle") + kinds.count("minimum") == 0
    assert kinds.count("maximum") == 2


# Geodesics and classes.


@pytest.mark.parametrize("goal", [(2.0, 2.5), (-0.7, 0.4), (3.0, 1.6)])
def test_geodesics_of_two_links_are_hyperbolic(goal):
    arm, start = PlanarArm([1.0, 1.0]), (0.0, 0.4)
    found = geodesics.geodesic(arm, mp.JointPath.line(start, goal), 1.0)
    a, b = (np.exp(first + 1j * second) for first, second in (start, goal))
    assert found.g == pytest.approx(np.arccosh(1 + abs(a - b) ** 2 / (2 * a.imag * b.imag)), rel=1e-8)
    assert found.unevenness < 1e-6


def test_a_geodesic_is_a_lower_bound_of_its_polynomials():
    kept = results.Results(quick=True)
    limit = kept.limit(config.SECOND)
    for degree in (2, 4, 6, 8):
        assert kept.path(config.SECOND, degree).g > limit.g
    assert kept.path(config.SECOND, 8).g < limit.g * (1 + 1e-6)


def test_walks_are_all_words_without_a_step_straight_back():
    counts = [sum(len(walk) == steps + 1 for walk in classes.walks((0, 0), 4)) for steps in range(5)]
    assert counts == [1, 4, 12, 36, 108]
    words = {classes.arrows(walk) for walk in classes.walks((0, 0), 3)}
    back = ("→←", "←→", "↑↓", "↓↑")
    brute = {"".join(word) for k in range(4) for word in itertools.product("→←↑↓", repeat=k)}
    assert words - {"·"} == {word for word in brute if word and not any(pair in word for pair in back)}


def test_first_paths_are_of_their_class():
    start = np.array([0.0, 0.4, -2.2])
    for walk in classes.walks(classes.cell(start), 4):
        if len(walk) == 1:
            continue
        goal = np.array([1.0, (walk[-1][0] + 0.2) * np.pi, (walk[-1][1] + 0.7) * np.pi])
        path = classes.through(start, goal, walk)
        assert classes.walk_of(path(path.fine_samples(1e-3))) == walk


def test_a_path_through_a_corner_has_no_class():
    with pytest.raises(ValueError, match="jump"):
        classes.walk_of(np.array([[0.0, -0.1, -0.1], [0.0, 0.1, 0.1]]))


def test_a_loop_that_goes_back_is_taken_out():
    points = np.array([[0.0, 0.5, 0.5], [0.0, 3.5, 0.5], [0.0, 3.5, 3.5], [0.0, 3.5, 0.5], [0.0, 0.5, 0.5]])
    assert classes.walk_of(points) == ((0, 0),)


# Polynomials.


def test_coefficients_are_those_of_the_path():
    a = np.array(config.TABLE_6_3)
    path = polynomials.polynomial(a)
    t = np.linspace(0.0, 1.0, 11)
    assert_allclose(path(t), np.stack([np.polynomial.polynomial.polyval(t, row) for row in a], axis=-1), atol=1e-12)
    assert_allclose(path.coefficients("monomial"), a, atol=1e-12)


def test_means_of_a_path_do_not_depend_on_its_pace_by_length():
    path = polynomials.polynomial(config.TABLE_6_3)
    t = np.linspace(0.0, 1.0, 401)
    slower = mp.JointPath.spline(t, path(t**2 * (3 - 2 * t)))
    first, second = polynomials.means(path), polynomials.means(slower)
    assert second.mu_by_length == pytest.approx(first.mu_by_length, rel=1e-6)
    assert abs(second.mu - first.mu) > 1e-3


def test_random_starts_find_the_straight_line_cost_at_degree_two_or_less():
    line = results.Results(quick=True).path(config.SECOND, 1).g
    best = starts.best_of_random_starts(config.SECOND, 2, config.TABLE_POWER, 3)
    assert best < line
    assert best == pytest.approx(results.Results(quick=True).path(config.SECOND, 2).g, rel=1e-8)
