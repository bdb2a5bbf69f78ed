"""Stationary and optimal postures: Tables 5.1 and 5.2 of kth2012 to high precision, and that none is missed."""

import itertools
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from numpy.polynomial.polynomial import polyadd, polysub, polyval

import manipplan as mp
from manipplan import planar
from manipplan.planar.zeros import multiply, real_roots

UNIT = planar.PlanarArm([1.0, 1.0, 1.0])
H = np.pi / 2
TABLE_5_2 = [  # R, θ2, θ3, μ, κ as printed
    (1.0, 1.57, 1.57, 1.73, 0.58),
    (1.4, 1.30, 1.44, 2.18, 0.54),
    (1.8, 1.02, 1.29, 2.52, 0.44),
    (2.2, 0.74, 1.10, 2.63, 0.33),
    (2.6, 0.47, 0.80, 2.30, 0.22),
    (3.0, 0.00, 0.00, 0.00, 0.00),
]


def gram(second, third, lengths=(1, 1, 1)):
    """J Jᵀ in mpmath, from the definition of the tool's position alone."""
    angles = [mpmath.mpf(0), second, second + third]
    x = [-sum(length * mpmath.sin(a) for length, a in list(zip(lengths, angles, strict=True))[i:]) for i in range(3)]
    y = [sum(length * mpmath.cos(a) for length, a in list(zip(lengths, angles, strict=True))[i:]) for i in range(3)]

    def dot(a, b):
        return sum(p * q for p, q in zip(a, b, strict=True))

    return dot(x, x), dot(x, y), dot(y, y)


def precise(second, third):
    """μ, κ, R at 40 digits."""
    a, b, d = gram(second, third)
    root = mpmath.sqrt((a - d) ** 2 / 4 + b**2)
    mu = mpmath.sqrt(a * d - b * b)
    radius = mpmath.sqrt(squares(second, third)[1])
    return mu, mpmath.sqrt(((a + d) / 2 - root) / ((a + d) / 2 + root)), radius


def squares(second, third):
    a, b, d = gram(second, third)
    cos, sin = mpmath.cos, mpmath.sin
    square = (1 + cos(second) + cos(second + third)) ** 2 + (sin(second) + sin(second + third)) ** 2
    return a * d - b * b, square


def partial(which, of, second, third):
    return mpmath.diff(lambda s, t: squares(s, t)[of], (second, third), (1, 0) if which == 2 else (0, 1))


def test_table_5_1():
    """Maximum of μ without constraints, and within ±π/2, (5.4) and (5.6): against 40 digits, and the print."""
    best = planar.stationary_postures(UNIT).best
    with mpmath.workdps(40):
        s, t = mpmath.findroot(lambda s, t: [partial(2, 0, s, t), partial(3, 0, s, t)], (0.78, 1.13))
        mu, _, radius = precise(s, t)
    assert len(best) == 2
    assert best.complete
    np.testing.assert_allclose(np.abs(best.q), [[0, float(s), float(t)]] * 2, atol=1e-12)
    np.testing.assert_allclose(best.manipulability, float(mu), rtol=1e-13)
    assert best.bound == best.manipulability[0]
    assert planar.optimal_radius(UNIT) == pytest.approx(float(radius), abs=1e-12)
    np.testing.assert_allclose(
        [best.radius[0], *np.abs(best.q[0, 1:]), best.manipulability[0]], [2.15, 0.78, 1.13, 2.63], atol=5e-3
    )
    limited = planar.stationary_postures(UNIT, lower=-H, upper=H).best
    np.testing.assert_allclose(limited.q, best.q, atol=1e-12)


@pytest.mark.parametrize("row", TABLE_5_2)
def test_table_5_2(row):
    """Maximum of μ within ±π/2 at a fixed radius, (5.7): against 40 digits, and the print."""
    radius, second, third, *_ = row
    best = planar.stationary_postures(UNIT, radius=radius, lower=-H, upper=H).best
    found = best.q[np.argmax(best.q[:, 1])]
    with mpmath.workdps(40):
        if radius == 1.0:  # the tool comes no nearer: the corner of the limits
            s = t = mpmath.pi / 2
        elif radius == 3.0:
            s = t = mpmath.mpf(0)
        else:

            def lagrange(s, t):
                area = partial(2, 0, s, t) * partial(3, 1, s, t) - partial(3, 0, s, t) * partial(2, 1, s, t)
                return [area, squares(s, t)[1] - mpmath.mpf(str(radius)) ** 2]

            s, t = mpmath.findroot(lagrange, (second, third))
        mu, kappa, _ = precise(s, t)
    np.testing.assert_allclose(found[1:], [float(s), float(t)], atol=1e-10)
    values = [best.manipulability[0], best.inverse_condition[0]]
    np.testing.assert_allclose(values, [float(mu), float(kappa)], atol=1e-12)
    np.testing.assert_allclose([radius, *found[1:], *values], row, atol=5.1e-3)
    np.testing.assert_allclose(best.radius, radius, atol=1e-12)


def newton_from_everywhere(function, jacobian, rng, count=400):
    """Zeros that Newton's method finds from random starts on the torus; function: (k, 2) -> (k, 2)."""
    x = rng.uniform(-np.pi, np.pi, (count, 2))
    for _ in range(60):
        slope = jacobian(x) + 1e-14 * np.eye(2)
        x = x - np.clip(np.linalg.solve(slope, function(x)[..., None])[..., 0], -0.3, 0.3)
    return x[np.abs(function(x)).max(axis=1) < 1e-10]


def stacked(functions):
    return lambda x: np.stack([f(x) for f in functions], axis=-1)


def stacked_twice(rows):
    return lambda x: np.stack([np.stack([f(x) for f in row], axis=-1) for row in rows], axis=-2)


def apart(a, b):
    return np.abs(np.angle(np.exp(1j * (a[:, None] - b[None])))).max(axis=-1)


@pytest.mark.parametrize("lengths", [[1, 1, 1], [1.0, 0.7, 0.4], [0.2, 1.0, 0.5], [3.0, 1.0, 1.0]])
def test_no_stationary_posture_is_missed(lengths, rng):
    """The thesis' own check, Newton from many starts, finds nothing new; and peaks - passes + pits = 0 on a torus."""
    arm = planar.PlanarArm(lengths)
    series = planar.squared_manipulability_series(arm)
    slopes = [series.derivative(i) for i in range(2)]
    bends = [[slope.derivative(j) for j in range(2)] for slope in slopes]
    ours = planar.stationary_postures(arm)
    assert ours.complete
    found = newton_from_everywhere(stacked(slopes), stacked_twice(bends), rng)
    distance = apart(found, ours.q[:, 1:])
    assert distance.min(axis=1).max() < 1e-7  # all that Newton found is ours
    assert distance.min(axis=0).max() < 1e-7  # and Newton finds all of ours
    kinds = [planar.stationary_kind(arm, q) for q in ours.q]
    assert kinds.count("maximum") - kinds.count("saddle") + kinds.count("minimum") == 0
    assert kinds[0] == "maximum"
    np.testing.assert_allclose(planar.squared_manipulability_gradient(arm, ours.q), 0, atol=1e-11 * arm.lengths.sum() ** 4)


@pytest.mark.slow
@pytest.mark.parametrize("lengths", [[1.0, 1.0, 1.0], [1.0, 0.7, 0.4], [0.3, 1.0, 0.5]])
@pytest.mark.parametrize("share", [0.15, 0.45, 0.7, 0.93])
def test_no_stationary_posture_at_a_radius_is_missed(lengths, share, rng):
    arm = planar.PlanarArm(lengths)
    least, most = planar.reachable_radii(arm)
    radius = least + share * (most - least)
    f, r = planar.squared_manipulability_series(arm), planar.squared_radius_series(arm)
    df, dr = [f.derivative(i) for i in range(2)], [r.derivative(i) for i in range(2)]

    def lagrange(x):
        return np.stack([df[0](x) * dr[1](x) - df[1](x) * dr[0](x), r(x) - radius**2], axis=-1)

    def slope(x, h=1e-6):
        return np.stack([(lagrange(x + h * e) - lagrange(x - h * e)) / (2 * h) for e in np.eye(2)], axis=-1)

    ours = planar.stationary_postures(arm, radius=radius)
    np.testing.assert_allclose(lagrange(ours.q[:, 1:]), 0, atol=1e-9)
    found = newton_from_everywhere(lagrange, slope, rng)
    distance = apart(found, ours.q[:, 1:])
    assert distance.min(axis=1).max() < 1e-6
    assert distance.min(axis=0).max() < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("lengths", [[1.0, 1.0, 1.0], [1.0, 0.6, 0.5], [0.4, 0.9, 0.7], [0.5, 0.3, 0.3]])
def test_optimum_within_limits_by_grid(lengths, rng):
    arm = planar.PlanarArm(lengths)
    for _ in range(4):
        lower = np.r_[-1.0, rng.uniform(-2.5, 0.5, 2)]
        upper = np.r_[1.0, lower[1:] + rng.uniform(0.2, 3.0, 2)]
        ours = planar.stationary_postures(arm, lower=lower, upper=upper)
        assert ((ours.q >= lower) & (ours.q <= upper)).all()
        axes = [np.linspace(a, b, 400) for a, b in zip(lower[1:], upper[1:], strict=True)]
        grid = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
        q = np.column_stack([np.zeros(len(grid)), grid])
        mu, radius = planar.manipulability(arm, q), arm.radius(q)
        assert mu.max() <= ours.manipulability[0] + 1e-12
        assert mu.max() > ours.manipulability[0] * (1 - 1e-3)
        # the same at a radius: of the grid's postures, those near it
        for target in rng.uniform(radius.min(), radius.max(), 3):
            at = planar.stationary_postures(arm, radius=target, lower=lower, upper=upper)
            near = np.abs(radius - target) < 2e-3 * arm.lengths.sum()
            steep = 40 * 2e-3 * arm.lengths.sum() ** 2
            assert np.abs(at.radius - target).max() < 1e-9
            assert abs(mu[near].max() - at.manipulability[0]) < steep


@pytest.mark.slow
def test_optimal_radius_is_the_best_of_all_radii():
    """Figure 5.3 in kth2012: the curve of optima over the radius has its top at the optimal radius."""
    arm = planar.PlanarArm([1.0, 0.8, 0.5])
    radii = np.linspace(*planar.reachable_radii(arm), 60)
    tops = [planar.stationary_postures(arm, radius=r).best.manipulability[0] for r in radii]
    best = planar.stationary_postures(arm).best
    assert max(tops) <= best.manipulability[0]
    assert abs(radii[np.argmax(tops)] - planar.optimal_radius(arm)) < radii[1] - radii[0]
    there = planar.stationary_postures(arm, radius=planar.optimal_radius(arm)).best
    assert there.manipulability[0] == pytest.approx(best.manipulability[0], rel=1e-12)


@pytest.mark.parametrize("radius", [0.0, 1.0, 3.0, 1e-7, 1 - 1e-7, 1 + 1e-7, 3 - 1e-9])
def test_radii_at_which_the_curve_degenerates(radius):
    """R = 0 and 3 are single postures, R = 1 three lines that cross: optimum by scanning the distance of tool and joint 2."""
    ours = planar.stationary_postures(UNIT, radius=radius)
    reach = np.linspace(max(abs(1 - radius), 1e-9), min(1 + radius, 2.0), 100_001)
    third = np.arccos(reach**2 / 2 - 1)
    second = np.arccos(np.clip((radius**2 - 1 - reach**2) / (2 * reach), -1, 1)) - np.array([[1], [-1]]) * third / 2
    q = np.stack(np.broadcast_arrays(0.0, second, np.stack([third, -third])), axis=-1)
    np.testing.assert_allclose(UNIT.radius(q), radius, atol=1e-7)
    assert ours.manipulability[0] == pytest.approx(planar.manipulability(UNIT, q).max(), abs=1e-6)
    assert np.abs(ours.radius - radius).max() < 1e-9


@pytest.mark.slow
def test_two_and_four_links(rng):
    two = planar.stationary_postures(planar.PlanarArm([1.0, 0.4]))
    np.testing.assert_allclose(np.sort(np.abs(two.q[:, 1])), [0, H, H, np.pi], atol=1e-12)
    assert two.best.manipulability[0] == pytest.approx(0.4)
    bent = planar.stationary_postures(planar.PlanarArm([1.0, 0.4]), radius=1.0)
    np.testing.assert_allclose(np.cos(bent.q[:, 1]), -0.2, atol=1e-12)
    arm = planar.PlanarArm([1.0, 1.0, 1.0, 1.0])
    four = planar.stationary_postures(arm)
    assert four.complete
    q = rng.uniform(-np.pi, np.pi, (400_000, 4))
    assert 0.97 * four.manipulability[0] < planar.manipulability(arm, q).max() <= four.manipulability[0]
    # Morse: the numbers of stationary points by index alternate to zero on the 3-torus
    index = [(np.linalg.eigvalsh(planar.squared_manipulability_hessian(arm, p)[1:, 1:]) < 0).sum() for p in four.q]
    assert sum((-1) ** int(k) for k in index) == 0


def test_zeros_with_and_without_proof():
    sine = planar.TrigonometricPolynomial(frequencies=np.array([[1.0]]), cosine=np.zeros(1), sine=np.ones(1))
    found = planar.torus_zeros([sine])
    assert found.complete
    np.testing.assert_allclose(np.sort(np.abs(found.points[:, 0])), [0, np.pi], atol=1e-14)
    double = planar.TrigonometricPolynomial(  # 1 - cos x touches zero: no proof that there is just one
        frequencies=np.array([[0.0], [1.0]]), cosine=np.array([1.0, -1.0]), sine=np.zeros(2)
    )
    touched = planar.torus_zeros([double])
    assert not touched.complete
    assert np.abs(touched.unresolved).max() < 1e-4
    assert touched.half_width <= 1e-8


@pytest.mark.slow
def test_random_trigonometric_systems(rng):
    """Nothing that Newton's method finds from random starts is missing, and no root is there twice."""
    for _ in range(4):
        k = np.array(list(itertools.product(range(-2, 3), range(3))), dtype=float)
        system = [
            planar.TrigonometricPolynomial(frequencies=k, cosine=rng.normal(size=15), sine=rng.normal(size=15)) for _ in "ab"
        ]
        slopes = [[f.derivative(j) for j in range(2)] for f in system]
        ours = planar.torus_zeros(system)
        assert ours.complete
        found = newton_from_everywhere(stacked(system), stacked_twice(slopes), rng)
        assert len(found) > 100
        assert apart(found, ours.points).min(axis=1).max() < 1e-8
        own = apart(ours.points, ours.points) + 9 * np.eye(len(ours.points))
        assert own.min() > 1e-6
        # by index they cancel, as always on a torus
        assert np.sign(np.linalg.det(stacked_twice(slopes)(ours.points))).sum() == 0


def test_real_roots_by_sturm():
    roots = [Fraction(-3, 2), Fraction(1, 3), Fraction(1, 3), Fraction(2), Fraction(2), Fraction(2), Fraction(9)]
    p = multiply(*[[-r, Fraction(1)] for r in roots], [Fraction(1), Fraction(0), Fraction(1)])
    assert [float(r) for r in real_roots(p, Fraction(-2), Fraction(2))] == pytest.approx([-1.5, 1 / 3, 2], abs=1e-30)
    assert real_roots(p, Fraction(2), Fraction(2)) == [2]
    assert real_roots([Fraction(1), Fraction(0), Fraction(1)], Fraction(-9), Fraction(9)) == []
    root = real_roots([Fraction(-2), Fraction(0), Fraction(1)], Fraction(0), Fraction(2))[0]
    assert abs(root**2 - 2) < Fraction(1, 2**117)
    close = multiply([Fraction(-1), Fraction(1)], [-1 - Fraction(1, 10**20), Fraction(1)])
    assert len(real_roots(close, Fraction(0), Fraction(2))) == 2


@pytest.mark.slow
def test_proportions_approach_their_bound_and_never_pass_it(rng):
    for n in range(2, 9):
        bound = planar.manipulability_bound(n, 2.0)
        joints = np.zeros(n) + 1e-9
        joints[[(n + 1) // 2 - 1, n - 1]] = 1.0 - 1e-9 * (n - 2) / 2  # ⌈n/2⌉ joints at the base, the others half way
        q = np.zeros(n)
        q[(n + 1) // 2] = H
        assert planar.manipulability(planar.PlanarArm(joints), q) == pytest.approx(bound, rel=1e-7)
        lengths = rng.dirichlet(rng.choice([0.1, 0.3, 1.0], n), 2000) + 1e-12
        lengths *= 2.0 / lengths.sum(axis=1)[:, None]
        for row in lengths[:400]:
            postures = rng.uniform(-np.pi, np.pi, (200, n))
            assert planar.manipulability(planar.PlanarArm(row), postures).max() <= bound


@pytest.mark.parametrize(("n", "steps", "share"), [(3, 2000, 0.003), (4, 160, 0.04)])
def test_the_last_step_of_the_bound_by_grid(n, steps, share):
    """Σ a_j² (a_i - a_j)², with its largest value between the nodes of a grid: each term's slopes are below 0.3."""
    axes = np.meshgrid(*[np.linspace(0, 1, steps + 1)] * (n - 1), indexing="ij", sparse=True)
    a = [np.ones((1,) * (n - 1)), *axes]
    total = sum(np.minimum(a[i], a[j]) ** 2 * (a[i] - a[j]) ** 2 for i in range(n) for j in range(i + 1, n))
    bound = (n // 2) * ((n + 1) // 2) / 16
    assert total.max() == pytest.approx(bound, abs=1e-12)  # it is reached, at a node
    between = 0.3 * (n - 1) ** 2 * 0.5 / steps
    assert total.max() + between <= bound * (1 + share)


def test_the_last_step_of_the_bound_for_three_links_exactly():
    """f(s, t) = s²(1-s)² + t²(1-t)² + t²(s-t)² <= 1/8 on 0 <= t <= s <= 1: at all its stationary points, and on the edges.

    ∂f/∂t = 0 is t² = a t - b with a = 3(1+s)/4, b = (1+s²)/4. It makes t³ - s t² = s(1-s)(1-2s), which is ∂f/∂s = 0, linear:
    D t = N. Hence N² - a N D + b D² = 0, a polynomial in s.
    """
    s, a, b = ([Fraction(x) for x in c] for c in (["0", "1"], ["3/4", "3/4"], ["1/4", "0", "1/4"]))
    c = multiply(s, [Fraction(1), Fraction(-1)], [Fraction(1), Fraction(-2)])
    d = polysub(polysub(multiply(a, a), b), multiply(s, a))
    n = polyadd(polysub(multiply(a, b), multiply(s, b)), c)
    joint = polyadd(polysub(multiply(n, n), multiply(a, n, d)), multiply(b, d, d))

    def f(s, t):
        return s**2 * (1 - s) ** 2 + t**2 * (1 - t) ** 2 + t**2 * (s - t) ** 2

    roots = real_roots(joint, Fraction(0), Fraction(1))
    assert roots
    for root in roots:
        below = polyval(root, d)
        assert abs(below) > Fraction(1, 10**6)
        t = polyval(root, n) / below
        if 0 < t < root < 1:
            assert f(root, t) < Fraction(1, 8) - Fraction(1, 10**6)
    edge = np.linspace(0, 1, 101)  # f is 2 x²(1-x)² at s = 1 and t = s, and half of it at t = 0: largest at x = 1/2
    np.testing.assert_allclose(f(1.0, edge), f(edge, edge), atol=1e-15)
    assert f(1.0, edge).max() == 1 / 8


@pytest.mark.slow
def test_best_lengths_of_three_links_by_grid():
    ours = planar.optimal_lengths(3, total=1.0, least=0.1, starts=8)
    assert ours.lengths.sum() == pytest.approx(1.0)
    assert ours.lengths.min() >= 0.1
    assert ours.manipulability < ours.bound
    shares = [(a, b, 10 - a - b) for a in range(1, 9) for b in range(1, 10 - a)]
    tops = {s: planar.stationary_postures(planar.PlanarArm(np.array(s) / 10)).best.manipulability[0] for s in shares}
    assert max(tops.values()) <= ours.manipulability
    assert ours.manipulability - max(tops.values()) < 0.01
    again = planar.stationary_postures(planar.PlanarArm(ours.lengths)).best
    assert again.manipulability[0] == pytest.approx(ours.manipulability, rel=1e-9)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: planar.stationary_postures(UNIT, radius=3.1), "radius: got 3.1; allowed: 0 to 3 m"),
        (lambda: planar.stationary_postures(UNIT, radius=0.9, lower=-H, upper=H), "radius: got 0.9; allowed: 1 to 3 m"),
        (lambda: planar.stationary_postures(planar.PlanarArm([1.0, 0.4]), radius=0.5), "allowed: 0.6 to 1.4 m"),
        (lambda: planar.stationary_postures(UNIT, radius=-1.0), "radius: got -1.0"),
        (lambda: planar.stationary_postures(UNIT, lower=1.0, upper=-1.0), "lower, upper: got"),
        (lambda: planar.stationary_postures(UNIT, lower=[0.0, 0.0]), "lower: got"),
        (lambda: planar.stationary_postures(planar.PlanarArm([1] * 5)), "2 to 4 links"),
        (lambda: planar.stationary_postures(planar.PlanarArm([1] * 4), radius=2.0), "2 to 3 links"),
        (lambda: planar.stationary_kind(UNIT, [[0.0, 0.0, 0.0]]), "one posture"),
        (lambda: planar.optimal_lengths(1), "n: got 1"),
        (lambda: planar.optimal_lengths(3, least=0.4), "least: got 0.4"),
        (lambda: planar.manipulability_bound(3, 0.0), "total: got 0.0"),
    ],
)
def test_wrong_arguments(call, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        call()
