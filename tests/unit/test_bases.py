"""The bases of the path optimiser: same optimum in each of one piece, splines of several, coefficients as NumPy has them."""

import numpy as np
import pytest
from numpy.polynomial import Chebyshev, Legendre, Polynomial

import manipplan as mp
from manipplan.cost.integral import PathIntegral
from manipplan.optimize.program import PathProgram
from manipplan.paths.basis import BASES, SPLINES, find_basis

START, GOAL = (0.0, 1.5, -2.0), (np.pi, -2.0, 2.0)  # (6.13) in kth2012
ONE_PIECE = ("legendre", "bernstein", "chebyshev", "monomial")
CASES = [(name, degree, 1) for name in ONE_PIECE for degree in (2, 6, 9)] + [
    ("bspline", 1, 5),
    ("bspline", 3, 4),
    ("bspline", 5, 9),
    ("composite", 2, 3),
    ("composite", 4, 5),
]


@pytest.mark.parametrize(("name", "degree", "pieces"), CASES)
def test_functions_vanish_at_the_ends_and_have_these_derivatives(name, degree, pieces):
    basis = find_basis(name, degree, pieces)
    assert np.abs(basis.values(np.array([0.0, 1.0]))).max() < 1e-14
    s = np.linspace(0.0, 1.0, 1001)[1:-1]
    s = s[np.abs(s[:, None] - basis.breaks).min(axis=1) > 1e-4]
    for order in (1, 2):
        numeric = (basis.values(s + 1e-6, order - 1) - basis.values(s - 1e-6, order - 1)) / 2e-6
        np.testing.assert_allclose(basis.values(s, order), numeric, atol=1e-8 * (1 + np.abs(numeric).max()))
    assert np.linalg.matrix_rank(basis.values(s)) == basis.size


@pytest.mark.parametrize(("name", "degree", "pieces"), CASES)
def test_paths_are_the_line_and_the_sum(name, degree, pieces, rng):
    basis = find_basis(name, degree, pieces)
    start, goal, x = rng.normal(size=3), rng.normal(size=3), rng.normal(size=(3, basis.size))
    path, s = basis.path(start, goal, x), np.linspace(0.0, 1.0, 101)
    expected = start + s[:, None] * (goal - start) + basis.values(s) @ x.T
    np.testing.assert_allclose(path(s), expected, atol=1e-12)
    np.testing.assert_array_equal(path([0.0, 1.0]), [start, goal])
    np.testing.assert_allclose(basis.fit(path, s), x, atol=1e-8)
    line, rows = basis.hull(6)
    hull = start + line[:, None] * (goal - start) + rows @ x.T
    low, high = path.bounds()
    assert (hull.min(axis=0) <= low + 1e-12).all()
    assert (hull.max(axis=0) >= high - 1e-12).all()


@pytest.mark.parametrize(("name", "degree", "pieces"), CASES)
def test_gauss_points_integrate_products_of_slopes(name, degree, pieces):
    """The rule of a solve is exact for them, also across the breaks; compared with a fine sum inside the pieces."""
    basis = find_basis(name, degree, pieces)
    s, weights = basis.gauss(degree)
    slopes = basis.values(s, 1)
    fine = (np.arange(200_000) + 0.5) / 200_000
    many = basis.values(fine, 1)
    np.testing.assert_allclose(slopes.T @ (weights[:, None] * slopes), many.T @ many / len(fine), rtol=1e-3, atol=1e-3)


@pytest.mark.parametrize(
    ("name", "degree"), [("bspline", 1), ("bspline", 3), ("bspline", 5), ("composite", 2), ("composite", 5)]
)
def test_pieces_join_smoothly_and_no_more(name, degree, rng):
    """One-sided derivatives from the control points of the two pieces that meet."""
    basis = find_basis(name, degree, 4)
    path = basis.path(np.zeros(2), np.ones(2), rng.normal(size=(2, basis.size)))
    continuous = degree - 1 if name == "bspline" else 1
    before, after = path.control[:-1], path.control[1:]
    for order in range(continuous + 2):
        jump = np.abs(np.diff(before, order, axis=1)[:, -1] - np.diff(after, order, axis=1)[:, 0])
        size = np.abs(np.diff(path.control, order, axis=1)).max()
        if order <= continuous:
            assert jump.max() < 1e-11 * size
        else:
            assert (jump.max(axis=1) > 1e-3 * size).all()


@pytest.mark.parametrize(("name", "degree", "pieces"), [("bspline", 5, 7), ("composite", 5, 3), ("bernstein", 5, 1)])
def test_each_holds_the_polynomials_of_its_degree(name, degree, pieces, rng):
    poly = Polynomial(rng.normal(size=degree + 1))
    s = np.linspace(0.0, 1.0, 161)
    basis = find_basis(name, degree, pieces)
    control = find_basis("monomial", degree).path(np.array([poly(0.0)]), np.array([poly(1.0)]), poly.coef[None, 2:])
    again = basis.path(control.start, control.goal, basis.fit(control, s))
    np.testing.assert_allclose(again(s)[:, 0], poly(s), atol=1e-12)
    np.testing.assert_allclose(again(s, 2)[:, 0], poly.deriv(2)(s), atol=1e-9)


@pytest.mark.parametrize("degree", [1, 2, 6, 12])
def test_coefficients_are_those_of_numpy(degree, rng):
    path = mp.JointPath(breaks=[0.0, 1.0], control=rng.normal(size=(1, degree + 1, 3)))
    s = np.linspace(0.0, 1.0, 57)
    classes = {
        "monomial": Polynomial,
        "legendre": lambda c: Legendre(c, domain=[0.0, 1.0]),
        "chebyshev": lambda c: Chebyshev(c, domain=[0.0, 1.0]),
    }
    for name, series in classes.items():
        coefficients = path.coefficients(name)
        assert coefficients.shape == (3, degree + 1)
        for order in (0, 1):
            values = np.column_stack([series(c).deriv(order)(s) for c in coefficients])
            np.testing.assert_allclose(values, path(s, order), atol=1e-8)
    power = path.coefficients("monomial")[1]
    converted = Polynomial(power).convert(kind=Chebyshev, domain=[0.0, 1.0]).coef
    np.testing.assert_allclose(path.coefficients("chebyshev")[1], converted, atol=1e-7)
    np.testing.assert_array_equal(path.coefficients("bernstein"), path.control[0].T)


def test_the_coefficients_of_table_6_3(planar):
    """The table's rows sum to (3.14, -2.00, 1.98), rounding (ERRATA): between these ends ours has a g not above its."""
    table = [
        [0.0, 1.05, 2.30, 0.92, -0.26, -0.60, -0.27],
        [1.50, -4.19, 0.84, -0.54, -0.86, -0.09, 1.34],
        [-2.00, 0.61, 1.05, 0.89, 0.55, 0.44, 0.44],
    ]
    start, goal = np.array(START), np.sum(table, axis=1)
    printed = find_basis("monomial", 6).path(start, goal, np.array(table)[:, 2:])
    np.testing.assert_allclose(printed.coefficients(), table, atol=1e-12)
    result = mp.optimize_path(
        planar, start, goal, shape=mp.PathShape(degree=6, basis="monomial"), objective=mp.PathObjective(power=2)
    )
    a = result.path.coefficients()
    np.testing.assert_allclose(a[:, 0], start, atol=1e-12)  # (6.14)
    np.testing.assert_allclose(a.sum(axis=1), goal, atol=1e-9)
    assert result.g < mp.path_cost(printed, planar.kinematics(), 2).g < 1.001 * result.g


@pytest.mark.parametrize("name", [*ONE_PIECE, "bspline"])
def test_degree_one_of_one_piece_is_the_straight_line(planar, name):
    result = mp.optimize_path(
        planar, START, GOAL, shape=mp.PathShape(degree=1, basis=name), objective=mp.PathObjective(power=2)
    )
    assert result.status is mp.Status.OPTIMAL
    np.testing.assert_allclose(result.path.control, [[START, GOAL]], atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("power", [1, 2])
def test_bases_of_one_piece_have_one_optimum(planar, power):
    costs = [
        mp.optimize_path(
            planar, START, GOAL, shape=mp.PathShape(degree=6, basis=name), objective=mp.PathObjective(power=power)
        ).g
        for name in (*ONE_PIECE, *SPLINES)
    ]
    np.testing.assert_allclose(
        costs,
        mp.optimize_path(planar, START, GOAL, shape=mp.PathShape(degree=6), objective=mp.PathObjective(power=power)).g,
        rtol=1e-8,
    )


@pytest.mark.slow
def test_bases_of_one_piece_have_one_optimum_on_the_panda(panda):
    start, goal = np.array([0, -0.3, 0, -2.2, 0, 2, np.pi / 4]), np.array([1.2, 0.5, -0.4, -1.2, 0.6, 2.6, -0.5])
    results = [mp.optimize_path(panda, start, goal, shape=mp.PathShape(degree=5, basis=name)) for name in ONE_PIECE]
    assert all(each.status is mp.Status.OPTIMAL for each in results)
    np.testing.assert_allclose([each.g for each in results], results[0].g, rtol=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "degree", "limit"), [("bspline", 3, 1e-5), ("bspline", 5, 1e-7), ("composite", 3, 1e-6)])
def test_more_pieces_come_to_the_optimum_of_high_degree(planar, name, degree, limit):
    best = mp.optimize_path(planar, START, GOAL, shape=mp.PathShape(degree=20), objective=mp.PathObjective(power=2)).g
    excess = []
    for pieces in (1, 4, 16):
        result = mp.optimize_path(
            planar,
            START,
            GOAL,
            shape=mp.PathShape(degree=degree, basis=name, pieces=pieces),
            objective=mp.PathObjective(power=2),
            compare=True,
        )
        assert result.status.ok
        excess.append(result.g / best - 1)
        assert abs(result.certificate.gap) < 1e-6
    assert excess[0] > 3 * max(excess[1], 1e-9)
    assert excess[1] > 3 * max(excess[2], 1e-9) or excess[1] < limit
    assert abs(excess[2]) < limit


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "degree", "pieces"), [*((name, 6, 1) for name in ONE_PIECE), ("bspline", 3, 8), ("composite", 4, 4)]
)
def test_joint_limits_hold_on_the_whole_curve(planar, name, degree, pieces):
    shape = mp.PathShape(degree=degree, basis=name, pieces=pieces)
    options = {"shape": shape, "objective": mp.PathObjective(power=2)}
    free = mp.optimize_path(planar, (0.0, -1.1, -1.6), (np.pi / 2, 0.5, 1.5), **options)
    s = np.linspace(0.0, 1.0, 20_001)
    q = free.path(s)
    least, most = np.minimum(q[0], q[-1]), np.maximum(q[0], q[-1])
    assert max((least - q).max(), (q - most).max()) > 0.1, "the limits below must bind"
    tight = planar.with_limits(lower=0.3 * q.min(axis=0) + 0.7 * least - 1e-3, upper=0.3 * q.max(axis=0) + 0.7 * most + 1e-3)
    held = mp.optimize_path(tight, (0.0, -1.1, -1.6), (np.pi / 2, 0.5, 1.5), **options)
    assert held.status is mp.Status.OPTIMAL
    assert tight.limits.outside(held.path(s)).max() < 1e-7
    assert free.g < held.g < held.seed_cost.g


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "degree", "pieces"), [("chebyshev", 7, 1), ("monomial", 7, 1), ("bspline", 4, 6), ("composite", 5, 3)]
)
def test_end_derivatives_are_met_in_every_basis(planar, name, degree, pieces):
    wanted = {"start_slope": [3.0, -1.0, 2.0], "goal_slope": [0.0, 0.0, 0.0], "start_second_derivative": [0.0, 1.0, 0.0]}
    places = {"start_slope": (0.0, 1), "goal_slope": (1.0, 1), "start_second_derivative": (0.0, 2)}
    result = mp.optimize_path(
        planar,
        START,
        GOAL,
        shape=mp.PathShape(degree=degree, basis=name, pieces=pieces, **wanted),
        objective=mp.PathObjective(power=2),
    )
    assert result.status is mp.Status.OPTIMAL
    for key, value in wanted.items():
        np.testing.assert_allclose(result.path(*places[key]), value, atol=1e-8)
    if pieces == 1:
        same = mp.optimize_path(
            planar, START, GOAL, shape=mp.PathShape(degree=degree, **wanted), objective=mp.PathObjective(power=2)
        )
        assert result.g == pytest.approx(same.g, rel=1e-6)


@pytest.fixture(scope="module")
def slalom(tmp_path_factory):
    """A gantry that has to pass seven walls, left and right in turn, and the path of seven corners that does."""
    file = tmp_path_factory.mktemp("urdf") / "gantry.urdf"
    file.write_text("""<robot name="gantry"><link name="base"/><link name="bridge"/>
      <link name="tool"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
      <joint name="x" type="prismatic"><parent link="base"/><child link="bridge"/><axis xyz="1 0 0"/>
        <limit lower="-1" upper="5" velocity="1" effort="10"/></joint>
      <joint name="y" type="prismatic"><parent link="bridge"/><child link="tool"/><axis xyz="0 1 0"/>
        <limit lower="-1" upper="1" velocity="1" effort="10"/></joint></robot>""")
    x, side = 0.5 * np.arange(1, 8), (-1.0) ** np.arange(7)
    walls = [
        mp.Box(size=(0.06, 1.0, 1.0), position=(at, -0.45 * sign, 0.0), name=f"wall {k}")
        for k, (at, sign) in enumerate(zip(x, side, strict=True))
    ]
    corners = np.vstack([[0.0, 0.0], np.column_stack([x, 0.3 * side]), [4.0, 0.0]])
    return mp.Robot.from_urdf(file), mp.Scene(walls), mp.JointPath.through(corners)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "degree", "pieces"), [("bspline", 3, 8), ("bspline", 4, 12), ("composite", 3, 8)])
def test_a_spline_follows_many_corners(slalom, name, degree, pieces):
    """The index of a gantry is constant, so g is the length; the shortest way, by the corners of the walls, is 4.14 m."""
    robot, scene, first = slalom
    objective, seeding = mp.PathObjective(task=mp.Task.planar()), mp.Seeding(initial=first)
    options = {"scene": scene, "objective": objective, "seeding": seeding}
    low = mp.optimize_path(robot, first.start, first.goal, shape=mp.PathShape(degree=6), **options)
    assert low.status is mp.Status.SEED_IS_SAFE
    result = mp.optimize_path(
        robot, first.start, first.goal, shape=mp.PathShape(degree=degree, basis=name, pieces=pieces), **options
    )
    assert result.status.ok
    assert scene.collision_model(robot).path_is_free(result.path, 1e-3)
    assert result.certificate.clearance > 0
    straight = np.array([[0.0, 0.0], *([0.5 * k, 0.1 * (-1.0) ** (k - 1)] for k in range(1, 8)), [4.0, 0.0]])
    shortest = np.linalg.norm(np.diff(straight, axis=0), axis=1).sum()
    assert shortest < result.length < 1.06 * shortest < 0.8 * first.length


@pytest.mark.parametrize("name", BASES)
def test_no_small_change_lowers_the_energy(planar, name, rng):
    pieces = 5 if name in SPLINES else 1
    program = PathProgram(PathIntegral(kinematics=planar.kinematics(), power=2.0), find_basis(name, 4, pieces))
    start, goal, size = np.array(START), np.array(GOAL), program.basis.size

    def energy(path):
        s, weights = path.quadrature()
        return weights @ ((path(s, 1) ** 2).sum(axis=1) / planar.kinematics().manipulability(path(s)) ** 4)

    best = program.solve(start, goal, np.zeros((3, size)), 0.0)
    least = energy(program.basis.path(start, goal, best.coefficients))
    assert best.converged
    for _ in range(20):
        change = 1e-3 * rng.normal(size=(3, size))
        assert energy(program.basis.path(start, goal, best.coefficients + change)) > least - 1e-7 * least


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"basis": "bsplines"}, "basis: got 'bsplines'; allowed: did you mean bspline"),
        ({"basis": "fourier"}, "basis: got 'fourier'; allowed: one of bernstein, bspline"),
        ({"basis": None}, "basis: got None"),
        ({"pieces": 3}, "pieces: got 3; allowed: 1 with basis 'legendre'; bspline and composite"),
        ({"basis": "bspline", "pieces": 0}, "pieces: got 0.*at least 1"),
        ({"basis": "bspline", "pieces": 2.5}, "pieces"),
        ({"basis": "bspline", "pieces": 33}, "pieces.*at most 32"),
        ({"basis": "composite", "pieces": 32, "degree": 20}, "pieces: got 32; allowed: fewer.*608 coefficients.*200"),
        ({"basis": "composite", "pieces": 3, "degree": 1}, "degree: got 1; allowed: at least 2 with basis 'composite'"),
        (
            {"basis": "monomial", "degree": 2, "start_slope": [0.0] * 3, "goal_second_derivative": [0.0] * 3},
            "degree: got 2.*at least 3",
        ),
        (
            {"basis": "bspline", "pieces": 8, "degree": 1, "start_second_derivative": [0.0] * 3},
            "degree: got 1.*at least 2 for these 1",
        ),
    ],
)
def test_wrong_arguments(planar, change, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.optimize_path(planar, START, GOAL, shape=mp.PathShape(**change))


def test_coefficients_of_a_wrong_kind(planar):
    path = mp.JointPath.line(START, GOAL)
    with pytest.raises(mp.errors.InvalidInputError, match="basis: got 'monomials'; allowed: did you mean monomial"):
        path.coefficients("monomials")
    with pytest.raises(
        mp.errors.InvalidInputError, match="path of 2 pieces; allowed: a path of one piece|coefficients: got 'a path of 2"
    ):
        mp.JointPath.through([START, (1.0, 1.0, 1.0), GOAL]).coefficients()
