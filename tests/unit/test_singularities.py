"""The floor of the objective, and what is said about the singularities on a path."""

import logging
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ellipkinc

import manipplan as mp
from manipplan.cost.crossings import describe, find_crossings, least_crossings, runs_along, with_shares
from manipplan.cost.objective import SAMPLES, SHARE, typical_measure
from manipplan.kinematics.factors import determinant_factors, singularity_signs
from manipplan.optimize.program import PathProgram
from manipplan.paths.basis import find_basis

UPRIGHT = [0.0, -np.pi / 2, 0.0, -np.pi / 2, 0.0, 0.0]


@pytest.fixture(scope="module")
def two_links():
    """m = |sin q2|."""
    return mp.planar_arm([1.0, 1.0])


def crossings_of(path, integral):
    return find_crossings(path, integral, integral.cost(path))


def revolute(folder, joints):
    """A URDF of revolute joints, each with its origin xyz, rpy and axis; the tool is 0.1 m along x beyond the last."""
    lines = ['<robot name="made"><link name="l0"/>']
    for k, (xyz, rpy, axis) in enumerate(joints):
        lines.append(
            f'<link name="l{k + 1}"/><joint name="j{k + 1}" type="revolute"><parent link="l{k}"/><child link="l{k + 1}"/>'
            f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>'
        )
    last = f'<parent link="l{len(joints)}"/><child link="tip"/><origin xyz="0.1 0 0"/>'
    lines.append(f'<link name="tip"/><joint name="end" type="fixed">{last}')
    file = folder / "made.urdf"
    file.write_text("".join([*lines, "</joint></robot>"]))
    return mp.Robot.from_urdf(file, tool="tip")


SPHERICAL = [
    ("0 0 0.5", "0 0 0", "0 0 1"),
    ("0.15 0 0", "0 0 0", "0 1 0"),
    ("0 0 0.6", "0 0 0", "0 1 0"),
    ("0.7 0 0.1", "0 0 0", "1 0 0"),
    ("0 0 0", "0 0 0", "0 1 0"),
    ("0 0 0", "0 0 0", "1 0 0"),
]


@pytest.mark.parametrize("floor", [0.3, 1e-2, 1e-4, 1e-6])
def test_g_with_a_floor_is_an_elliptic_integral(two_links, floor):
    """∫ dθ / sqrt(sin²θ + ε²) = F(θ | -1/ε²) / ε along a line on which the first joint moves half as much as the second."""
    path = mp.JointPath.line([0.2, -0.9], [1.15, 1.0])
    exact = np.hypot(1.0, 0.5) * (ellipkinc(1.0, -(floor**-2)) + ellipkinc(0.9, -(floor**-2))) / floor
    kinematics = two_links.kinematics(mp.Task.planar())
    assert mp.path_cost(path, kinematics, 1.0, floor=floor).g == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("floor", [0.3, 1e-2, 1e-4])
def test_g_of_the_square_with_a_floor(two_links, floor):
    path = mp.JointPath.line([0.2, -0.9], [0.2, 1.0])
    root = np.sqrt(1 + floor**2)
    exact = sum(np.arctan(np.tan(each) * root / floor) for each in (0.9, 1.0)) / (floor * root)
    kinematics = two_links.kinematics(mp.Task.planar())
    assert mp.path_cost(path, kinematics, 2.0, floor=floor).g == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("power", [0.5, 1.0, 2.0])
def test_the_floor_changes_g_by_a_bounded_share(panda, rng, power):
    kinematics = panda.kinematics()
    for start, goal in panda.random_configuration(rng, size=10).reshape(5, 2, 7):
        path = mp.JointPath.line(start, goal)
        plain = mp.path_cost(path, kinematics, power)
        floor = 0.3 * plain.min_manipulability
        with_floor = mp.path_cost(path, kinematics, power, floor=floor)
        assert (1 + 0.3**2) ** (-power / 2) * plain.g <= with_floor.g < plain.g
        assert with_floor.min_manipulability == plain.min_manipulability


def test_the_default_floor_is_a_share_of_the_typical_measure(panda):
    kinematics = panda.kinematics()
    q = panda.random_configuration(np.random.default_rng(0), size=SAMPLES)
    typical = np.median(kinematics.manipulability(q))
    assert typical_measure(kinematics) == pytest.approx(typical, rel=1e-6)
    assert mp.PathObjective().integral(panda).floor == SHARE * typical_measure(kinematics)
    assert mp.PathObjective(floor=0.0).integral(panda).floor == 0.0
    assert mp.PathObjective(floor=0.01).resolved(panda).floor == 0.01


@pytest.mark.parametrize("floor", [-1e-9, np.nan, np.inf, "high", [0.1]])
def test_floors_that_are_none(floor):
    with pytest.raises(mp.errors.InvalidInputError, match="floor"):
        mp.PathObjective(floor=floor)
    with pytest.raises(mp.errors.InvalidInputError, match="floor"):
        mp.path_cost(mp.JointPath.line([0.0, 1.0], [1.0, 1.0]), mp.planar_arm([1.0, 1.0]).kinematics(), 1.0, floor=floor)


def test_a_floor_above_the_typical_measure_is_told(panda, caplog):
    with caplog.at_level(logging.WARNING, "manipplan"):
        mp.PathObjective(floor=10.0).resolved(panda)
    assert "floor=10 is above the typical yoshikawa of panda" in caplog.text and "m^6" in caplog.text


@pytest.mark.slow
def test_a_redundant_arm_takes_the_same_path_with_the_default_floor(panda, rng):
    """Where m stays above ten floors, the path differs by at most 1e-3 rad."""
    compared = 0
    for start, goal in panda.random_configuration(rng, size=12).reshape(6, 2, 7):
        plain, usual = (
            mp.optimize_path(panda, start, goal, objective=objective, throw=False)
            for objective in (mp.PathObjective(floor=0.0), mp.PathObjective())
        )
        if plain.status is usual.status is mp.Status.OPTIMAL and plain.min_manipulability > 10 * usual.floor:
            assert np.abs(at_equal_lengths(plain.path) - at_equal_lengths(usual.path)).max() < 1e-3
            compared += 1
    assert compared >= 4


def at_equal_lengths(path):
    """101 configurations at equal distances: g does not depend on the pace."""
    s = np.linspace(0.0, 1.0, 5001)
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path(s), axis=0), axis=1))])
    return path(np.interp(np.linspace(0.0, length[-1], 101), length, s))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur3", "ur5", "ur10", "z1", "kinova"])
def test_three_parallel_axes_have_three_factors(name, rng):
    robot = mp.load_robot(name)
    factors = determinant_factors(robot)
    assert [(each.name, each.joint) for each in factors] == [("elbow", 2), ("wrist", 4), ("shoulder", None)]
    assert_product(robot, factors, rng)


def assert_product(robot, factors, rng):
    q = robot.random_configuration(rng, size=30)
    signs = singularity_signs(robot.kinematics())
    assert signs.names == tuple(each.name for each in factors)
    true, product = np.linalg.det(robot.kinematics().jacobian(q)), signs.values(q).prod(axis=1)
    ratio = true[np.abs(true) > 1e-2 * np.abs(true).max()] / product[np.abs(true) > 1e-2 * np.abs(true).max()]
    assert len(ratio) > 10
    np.testing.assert_allclose(ratio, ratio[0], rtol=1e-2)


def test_a_spherical_wrist_has_three_factors(tmp_path, rng):
    robot = revolute(tmp_path, SPHERICAL)
    factors = determinant_factors(robot)
    assert [(each.name, each.joint) for each in factors] == [("elbow", 2), ("wrist", 4), ("shoulder", None)]
    assert_product(robot, factors, rng)


def test_a_spherical_wrist_on_an_arm_without_parallel_axes(tmp_path, rng):
    skew = [*SPHERICAL[:2], ("0 0 0.6", "0.4 0 0", "0 1 0"), *SPHERICAL[3:]]
    robot = revolute(tmp_path, skew)
    factors = determinant_factors(robot)
    assert [each.name for each in factors] == ["arm", "wrist"]
    assert_product(robot, factors, rng)


def test_parallel_axes_without_a_meeting_pair(tmp_path, rng):
    joints = [
        ("0 0 0.2", "0.3 0 0", "0 0 1"),
        ("0 0.1 0.2", "0 0 0", "0 1 0"),
        ("0.1 0 0.5", "0 0 0", "0 1 0"),
        ("0.5 0 0", "0 0 0", "0 1 0"),
        ("0 0.1 0.1", "0 0 0.3", "1 0 0"),
        ("0.1 0.05 0", "0 0.2 0", "0 0 1"),
    ]
    robot = revolute(tmp_path, joints)
    factors = determinant_factors(robot)
    assert [each.name for each in factors] == ["elbow", "wrist and shoulder"]
    assert_product(robot, factors, rng)


def test_arms_without_known_factors(tmp_path, panda):
    general = [(xyz, "0.3 0.2 0.1", axis) for xyz, _, axis in SPHERICAL[:4]] + [
        ("0.1 0.05 0", "0.3 0.2 0.1", axis) for _, _, axis in SPHERICAL[4:]
    ]
    robot = revolute(tmp_path, general)
    assert determinant_factors(robot) == () == determinant_factors(panda)
    start, goal = robot.random_configuration(np.random.default_rng(3), size=2)
    integral = mp.PathObjective().integral(robot)
    found = crossings_of(mp.JointPath.line(start, goal), integral)
    assert all(each.kind == "" for each in found)
    signs = np.sign(np.linalg.det(robot.kinematics().jacobian([start, goal])))
    assert least_crossings(robot.kinematics(), start, goal) == int(signs[0] != signs[1]) == len(found) % 2


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur5", "z1", "kinova"])
def test_crossings_are_where_factors_vanish(name, rng):
    robot = mp.load_robot(name)
    integral, signs = mp.PathObjective().integral(robot), singularity_signs(robot.kinematics())
    count = 0
    for start, goal in robot.random_configuration(rng, size=20).reshape(10, 2, 6):
        path = mp.JointPath.line(start, goal)
        found = crossings_of(path, integral)
        assert least_crossings(integral.kinematics, start, goal) <= len(found)
        s = np.linspace(0.0, 1.0, 4001)
        for kind, values in zip(signs.names, signs.values(path(s)).T, strict=True):
            places = s[:-1][np.diff(values >= 0)]
            mine = [each.at for each in found if each.kind == kind]
            np.testing.assert_allclose(mine, places, atol=1.0 / 4000)
            count += len(places)
    assert count > 3


def test_a_joint_that_does_not_move_what_counts_leaves_the_factors_of_the_pose(rng):
    """The UR5's last joint turns about the tool's z-axis: J of that axis is square without it, and its determinant the same."""
    robot = mp.load_robot("ur5")
    kinematics = robot.kinematics(mp.Task.pointing([0, 0, 1]))
    signs, q = singularity_signs(kinematics), robot.random_configuration(rng, size=200)
    assert signs.names == ("elbow", "wrist", "shoulder")
    ratio = np.abs(signs.values(q).prod(axis=1)) / kinematics.manipulability(q)
    np.testing.assert_allclose(ratio, ratio[0], rtol=1e-6)
    start = np.array([0.3, -1.2, 1.4, -0.5, 0.8, 0.0])
    goal = start * [1, 1, 1, 1, -1, 1]
    assert least_crossings(kinematics, start, goal) == 1
    found = crossings_of(mp.JointPath.line(start, goal), mp.PathObjective(task=kinematics.task).integral(robot))
    assert [(each.kind, round(each.at, 9)) for each in found] == [("wrist", 0.5)]
    assert singularity_signs(robot.kinematics(mp.Task.pointing([1, 0, 0]))) is None  # that axis is moved by all joints
    assert singularity_signs(robot.kinematics(mp.Task.position())) is None


@pytest.mark.slow
def test_two_factors_that_vanish_between_the_same_samples():
    """Here det J has the same sign at all samples: the elbow and the shoulder vanish within a ten-thousandth of the path."""
    robot = mp.load_robot("kinova")
    q = robot.random_configuration(np.random.default_rng(1), size=8)
    path = mp.JointPath.line(q[6], q[7])
    found = crossings_of(path, mp.PathObjective().integral(robot))
    assert [each.kind for each in found] == ["shoulder", "elbow"]
    assert found[1].at - found[0].at < 1e-3


def test_g_without_its_crossings_does_not_depend_on_the_floor():
    robot = mp.load_robot("ur5")
    path = mp.JointPath.line([0.0, -1.2, 1.4, -1.0, 1.0, 0.0], [0.8, -0.9, -1.0, -1.4, -1.4, 0.5])
    typical = typical_measure(robot.kinematics())
    rest, g = [], []
    for share in (1e-3, 1e-4, 1e-5):
        integral = mp.PathObjective(floor=share * typical).integral(robot)
        found = crossings_of(path, integral)
        assert [each.kind for each in found] == ["wrist", "elbow"]
        g.append(integral.cost(path).g)
        rest.append(g[-1] - sum(each.cost for each in found))
    np.testing.assert_allclose(rest, rest[-1], rtol=1e-3)
    slope = sum(2 / each.steepness for each in found)
    assert g[1] - g[0] == pytest.approx(slope * np.log(10), rel=1e-3)
    assert g[2] - g[1] == pytest.approx(slope * np.log(10), rel=1e-5)


@pytest.mark.parametrize("power", [0.5, 1.0, 2.0, 2.9])
def test_the_cost_of_a_crossing_for_other_powers(two_links, power):
    """Beside the crossing m is nearly linear, so that a short path's g is the cost of its crossing, but for m beyond the path."""
    arm, end = two_links, 1e-3
    integral = mp.PathObjective(power=power, floor=1e-5, task=mp.Task.planar()).integral(arm)
    path = mp.JointPath.line([0.0, -end], [0.0, end])
    [crossing] = crossings_of(path, integral)
    assert crossing.steepness == pytest.approx(1.0, rel=1e-6)
    x = np.sinh(np.linspace(0.0, np.arcsinh(typical_measure(integral.kinematics) / 1e-5), 20_001)) * 1e-5
    beyond = x >= end
    values = (x**2 + 1e-10) ** (-power / 2)
    assert crossing.cost == pytest.approx(2 * np.trapezoid(values, x), rel=1e-4)
    share = crossing.cost - 2 * np.trapezoid(values[beyond], x[beyond])
    assert integral.cost(path).g == pytest.approx(share, rel=1e-2)


def test_sentences():
    robot = mp.load_robot("ur5")
    integral = mp.PathObjective().integral(robot)
    start, goal = [0.0, -1.2, 1.4, -1.0, 1.0, 0.0], [0.8, -0.9, -1.0, -1.4, 1.4, 0.5]
    line = mp.JointPath.line(start, goal)
    found = crossings_of(line, integral)
    least = least_crossings(integral.kinematics, line.start, line.goal)
    expected = (
        "crosses an elbow singularity at s = 0.583; this cannot be avoided, since start and goal lie in different aspects"
    )
    assert describe(found, least) == expected
    there_and_back = mp.JointPath.through([start, goal, [0.1, *start[1:]]])
    told = describe(crossings_of(there_and_back, integral), 0)
    assert told.count("crosses an elbow singularity") == 2 and "may lie in one aspect" in told
    assert describe((), 0) == ""
    upright = crossings_of(mp.JointPath.line(UPRIGHT, start), integral)
    assert str(upright[0]) == "starts at an elbow, wrist and shoulder singularity" and upright[0].at_end
    assert upright[0].lost == ()  # three factors vanish at once


def test_powers_whose_rest_has_no_limit_have_no_cost(two_links):
    path, task = mp.JointPath.line([0.0, -1.0], [0.3, 1.0]), mp.Task.planar()
    for power in (3.0, 4.0):
        [crossing] = crossings_of(path, mp.PathObjective(power=power, task=task).integral(two_links))
        assert np.isnan(crossing.cost) and crossing.steepness > 0
    half = mp.JointPath.line([0.0, 0.0], [0.3, 1.0])
    costs = [crossings_of(half, mp.PathObjective(power=p, task=task).integral(two_links))[0].cost for p in (1.0, 2.0)]
    assert np.isfinite(costs[0]) and np.isnan(costs[1])


def test_a_singular_end_has_no_sign(two_links):
    """det J is rounding noise there; the path may leave to either side."""
    kinematics = two_links.kinematics(mp.Task.planar())
    for first in np.linspace(0.1, 3.0, 12):
        for other in (-0.8, 0.8):
            assert least_crossings(kinematics, np.array([first, 0.0]), np.array([0.2, other])) == 0
    assert least_crossings(kinematics, np.array([0.1, -0.3]), np.array([0.2, 0.8])) == 1
    ur5 = mp.load_robot("ur5")
    assert least_crossings(ur5.kinematics(), np.array(UPRIGHT), np.array([0.8, -1.0, 1.2, -0.5, 0.7, 0.3])) == 0


def test_another_factor_that_vanishes_soon_after_a_singular_start():
    """The wrist is singular at the start, and the elbow a hundredth of a radian later: both are told."""
    robot = mp.load_robot("ur5")
    path = mp.JointPath.line([0.0, -1.2, 0.01, -1.0, 0.0, 0.0], [0.4, -1.0, -1.0, -1.4, 1.0, 0.5])
    found = crossings_of(path, mp.PathObjective().integral(robot))
    assert [(each.kind, each.at_end) for each in found] == [("wrist", True), ("elbow", False)]
    assert least_crossings(robot.kinematics(), path.start, path.goal) == 1


def test_a_redundant_arm_that_has_to_cross(tmp_path):
    """Spherical shoulder and wrist, and an elbow without offset: J loses rank wherever the elbow is straight."""
    spherical = [
        ("0 0 0.3", "z"),
        ("0 0 0", "y"),
        ("0 0 0", "z"),
        ("0 0 0.4", "y"),
        ("0 0 0.4", "z"),
        ("0 0 0", "y"),
        ("0 0 0", "z"),
    ]
    axis = {"y": "0 1 0", "z": "0 0 1"}
    robot = revolute(tmp_path, [(xyz, "0 0 0", axis[name]) for xyz, name in spherical])
    integral = mp.PathObjective().integral(robot)
    path = mp.JointPath.line([0.1, 0.7, 0.2, -0.8, 0.3, 0.9, 0.1], [0.4, 0.5, 0.3, 1.1, 0.2, 0.8, 0.3])
    [crossing] = crossings_of(path, integral)
    assert crossing.at == pytest.approx(0.8 / 1.9, abs=1e-6) and crossing.kind == ""
    assert least_crossings(integral.kinematics, path.start, path.goal) is None
    assert describe([crossing], None).startswith("crosses a singularity at s = 0.421")


def test_six_parallel_axes_with_a_task_of_six_rows():
    """det J is zero everywhere: no factors, and a clear answer."""
    arm = mp.planar_arm([1.0] * 6)
    assert determinant_factors(arm) == ()
    line = mp.JointPath.line(np.full(6, 0.1), np.full(6, 0.4))
    integral = mp.PathObjective(task=mp.Task.pose(), floor=0.1).integral(arm)
    assert all(each.at_end for each in crossings_of(line, integral))


def test_a_large_floor_makes_no_path_singular(panda, rng):
    start, goal = panda.random_configuration(rng, size=2)
    result = mp.optimize_path(panda, start, goal, objective=mp.PathObjective(floor=1.0))
    assert result.status is not mp.Status.SINGULAR


@pytest.mark.slow
def test_optimising_again_returns_the_path():
    robot = mp.load_robot("ur5")
    start, goal = [0.0, -1.2, 1.4, -1.0, 1.0, 0.0], [0.8, -0.9, -1.0, -1.4, 1.4, 0.5]
    first = mp.optimize_path(robot, start, goal)
    again = mp.optimize_path(robot, start, goal, seeding=mp.Seeding(initial=first.path))
    assert again.status is mp.Status.OPTIMAL
    assert again.g == pytest.approx(first.g, rel=1e-5) and again.g <= first.g * (1 + 1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur5", "z1", "kinova"])
def test_paths_between_aspects_are_optimised(name, rng):
    robot = mp.load_robot(name)
    for start, goal in robot.random_configuration(rng, size=8).reshape(4, 2, 6):
        result = mp.optimize_path(robot, start, goal)
        certificate = result.certificate
        assert result.status is mp.Status.OPTIMAL
        assert result.g <= result.seed_cost.g
        assert len(certificate.crossings) >= certificate.least_crossings
        assert certificate.finite_g < result.g or not certificate.crossings


@pytest.mark.slow
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_upright_start_is_ordinary(sign):
    plan = mp.plan(mp.load_robot("ur5"), UPRIGHT, [0.8, -1.0, sign * 1.2, -0.5, 0.7, 0.3])
    assert plan.status.ok and plan.report.passed and np.isfinite(plan.result.g)
    assert plan.report.crossing_note.startswith("starts at an elbow, wrist and shoulder singularity")
    assert "minimum m    0 m^6" in str(plan.report)


def test_without_a_floor_g_is_infinite():
    robot = mp.load_robot("ur5")
    start, goal = [0.0, -1.2, 1.4, -1.0, 1.0, 0.0], [0.8, -0.9, -1.0, -1.4, 1.4, 0.5]
    result = mp.optimize_path(robot, start, goal, objective=mp.PathObjective(floor=0.0), throw=False)
    assert result.status is mp.Status.SINGULAR and np.isinf(result.g)
    with pytest.raises(mp.errors.PlanningError, match="g is infinite"):
        mp.optimize_path(robot, start, goal, objective=mp.PathObjective(floor=0.0))


def test_a_path_along_the_singular_set_is_told(two_links):
    objective = mp.PathObjective(task=mp.Task.planar())
    line = mp.JointPath.line([0.0, 0.0], [1.0, 0.0])
    integral = objective.integral(two_links)
    assert runs_along(line, integral, integral.cost(line))
    options = {"objective": objective, "throw": False}
    held = mp.optimize_path(two_links, [0.0, 0.0], [1.0, 0.0], shape=mp.PathShape(degree=1), **options)
    assert held.status is mp.Status.SINGULAR and np.isfinite(held.g)
    bent = mp.optimize_path(two_links, [0.0, 0.0], [1.0, 0.0], **options)
    assert bent.g < 0.5 * held.g


@pytest.mark.parametrize("floor", [1e-1, 1e-3])
def test_moving_panels_give_exact_derivatives(two_links, floor, rng):
    """The value's panels follow each path; gradient and Hessian are those of the integral all the same."""
    integral = replace(mp.PathObjective(task=mp.Task.planar()).integral(two_links), floor=floor)
    program = PathProgram(integral, find_basis("legendre", 6))
    start, goal = np.array([0.0, -0.9]), np.array([1.0, 1.1])
    true, z = program.descent_program(start, goal, np.zeros((2, program.basis.size)), None, moving=True)
    for _ in range(3):
        z = z + 0.05 * rng.normal(size=z.shape)
        along = rng.normal(size=z.shape)
        along /= np.linalg.norm(along)
        ahead, behind = z + 1e-5 * along, z - 1e-5 * along
        slope = (true.length.value(ahead) - true.length.value(behind)) / 2e-5
        assert slope == pytest.approx(float((true.length.gradient(z) * along).sum()), abs=1e-6)
        bend = (true.length.gradient(ahead) - true.length.gradient(behind)).ravel() / 2e-5
        np.testing.assert_allclose(bend, true.length.derivatives(z)[1] @ along.ravel(), rtol=1e-3, atol=1e-4)
        path = true.length.curves.path(z)
        assert true.length.without_energy.value(z) * true.length.g0 == pytest.approx(integral.cost(path).g, rel=1e-9)


@pytest.mark.slow
def test_a_singular_start_has_its_share_of_g():
    plan = mp.plan(mp.load_robot("ur5"), UPRIGHT, [0.8, -1.0, 1.2, -0.5, 0.7, 0.3])
    start = plan.result.certificate.crossings[0]
    assert start.at == 0.0 and 0.9 < start.share <= 1.0
    assert f"({100 * start.share:.0f} % of g)" in str(start)


def test_the_share_of_an_end_is_its_part_of_the_integral(two_links):
    """θ₂ from 0 to 1 at constant θ₁: m = sin θ₂, so ∫ dθ / sqrt(sin² θ + ε²) up to a tenth of the typical m."""
    integral = replace(mp.PathObjective(task=mp.Task.planar()).integral(two_links), floor=1e-3)
    path = mp.JointPath.line([0.3, 0.0], [0.3, 1.0])
    cost = integral.cost(path)
    [start] = with_shares(find_crossings(path, integral, cost), path, integral, cost)
    until = np.arcsin(0.1 * typical_measure(integral.kinematics))
    part, _ = quad(lambda x: 1 / np.hypot(np.sin(x), 1e-3), 0.0, until, epsabs=1e-10)
    assert start.share == pytest.approx(part / cost.g, rel=2e-3)


def test_the_lost_direction_is_one_that_no_joint_gives(two_links):
    """Stretched along x, a two-link arm cannot move its tip along x."""
    integral = mp.PathObjective(task=mp.Task.planar()).integral(two_links)
    path = mp.JointPath.line([0.5, -0.5], [-0.5, 0.5])
    [crossing] = find_crossings(path, integral, integral.cost(path))
    q = path(np.array([crossing.at]))
    lost = np.array(crossing.lost)
    assert np.linalg.norm(lost) == pytest.approx(1.0)
    np.testing.assert_allclose(lost @ integral.kinematics.jacobian(q)[0], 0.0, atol=1e-6)
    np.testing.assert_allclose(lost, [1.0, 0.0], atol=1e-6)


@pytest.mark.slow
def test_the_report_tells_how_long_m_is_below_the_floor():
    robot = mp.load_robot("ur5")
    plan = mp.plan(robot, [0.0, -1.2, 1.4, -1.0, 1.0, 0.0], [0.8, -0.9, -1.0, -1.4, 1.4, 0.5])
    t = np.linspace(0.0, plan.trajectory.duration, 2_000_001)
    share = (robot.kinematics().manipulability(plan.trajectory(t)) < plan.result.floor).mean()
    assert 0 < plan.report.below_floor == pytest.approx(share * plan.trajectory.duration, rel=0.05)
    assert f"for {1e3 * plan.report.below_floor:.2g} ms" in str(plan.report)
    away = mp.plan(robot, [0.0, -1.2, 1.4, -1.0, 1.0, 0.0], [0.5, -1.0, 1.2, -1.2, 1.2, 0.2])
    assert away.report.below_floor == 0.0 and "is below" not in str(away.report)


@pytest.mark.slow
def test_a_pose_as_the_goal_avoids_the_crossing():
    robot, kinematics = mp.load_robot("ur5"), mp.load_robot("ur5").kinematics()
    start, goal = [0.4, -1.2, 1.5, -1.8, -1.3, 0.7], [1.4, -0.5, -1.3, 0.3, -1.2, 0.5]
    given = mp.optimize_path(robot, start, goal, mp.Scene())
    assert given.certificate.least_crossings == 1
    plan = mp.plan(robot, start, kinematics.pose(goal))
    assert plan.result.g < given.g and not plan.result.certificate.crossings
    np.testing.assert_allclose(kinematics.pose(plan.path.goal), kinematics.pose(goal), atol=1e-9)


@pytest.mark.slow
def test_more_first_paths_are_never_worse_and_are_counted():
    robot = mp.load_robot("ur5")
    start, goal = [0.0, -1.2, 1.4, -1.0, 1.0, 0.0], [0.8, -0.9, -1.0, -1.4, 1.4, 0.5]
    post = mp.Scene([mp.Cylinder(radius=0.06, length=1.5, position=(0.35, 0.35, 0.5), name="post")])
    one = mp.optimize_path(robot, start, goal, post)
    several = mp.optimize_path(robot, start, goal, post, seeding=mp.Seeding(count=4))
    assert several.g <= one.g * (1 + 1e-5)
    found = (several, *several.rivals)
    assert sum(each.first_paths for each in found) == 4
    assert several.missing == sum(each.first_paths == 1 for each in found) / 4
    assert np.isnan(one.missing) and one.first_paths == 1
