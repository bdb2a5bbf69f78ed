"""Compiled kernels of inverse kinematics by themselves: roots of quartics, checks of poses and duplicates, Newton steps."""

import mpmath
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.ik import bridge
from manipplan.ik.geometry import Screws
from manipplan.ik.newton import MovingArm
from manipplan.ik.solutions import are_poses, distinct, residuals
from manipplan.support import kernels
from manipplan.support.checks import COINCIDENT
from manipplan.support.kernels import kernel_by_llvm, source_text


@pytest.fixture(scope="module")
def by_llvm():
    code = kernel_by_llvm("inverse")
    yield code.functions()


def exact_roots(a):
    with mpmath.workdps(60):
        found = mpmath.polyroots([*map(mpmath.mpf, a), mpmath.mpf(1)], maxsteps=2000, extraprec=2000, asc=True)
        return np.array([complex(each) for each in found])


def missed(roots, expected):
    """How far the nearest of `roots` is from each expected one, relative to the largest; each root is used once."""
    left, worst, size = list(roots), 0.0, max(np.abs(expected).max(), 1e-3)
    for each in expected:
        nearest = min(left, key=lambda root: abs(root - each))
        left.remove(nearest)
        worst = max(worst, abs(nearest - each) / size)
    return worst


@pytest.mark.slow
@pytest.mark.parametrize("spread", [0.1, 1.0, 3.0])
def test_roots_of_random_quartics(spread, rng):
    for _ in range(200):
        real = rng.normal(size=4) * 10.0 ** rng.uniform(-spread, spread, 4)
        roots = real.astype(complex)
        if rng.random() < 0.5:
            roots[1], roots[2] = complex(real[1], real[2]), complex(real[1], -real[2])
        a = np.poly(roots).real[:0:-1]
        expected = exact_roots(a)
        apart = min(abs(x - y) for i, x in enumerate(expected) for y in expected[:i]) / abs(expected).max()
        # a root moves by the rounding of the coefficients divided by its distance from the others
        assert missed(bridge.quartic_roots(a), expected) < 1e-12 / max(apart, 1e-12)


@pytest.mark.parametrize(
    "a",
    [[-1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 0, 0], [4, 0, -5, 0], [0, 0, 0, -1], [1, -4, 6, -4], [4, 0, -4, 0], [1e-8, 0, 0, 0]],
)
def test_roots_of_symmetric_quartics(a):
    """Their companion matrices are turned by steps without shift, so that those would never end; some roots are multiple."""
    expected = np.roots([1.0, *a[::-1]])
    assert len(bridge.quartic_roots(np.array(a, dtype=float))) == 4
    assert (
        missed(bridge.quartic_roots(np.array(a, dtype=float)), expected) < 1e-3
    )  # ε to the power of 1/4, for four equal roots


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf])
def test_quartics_that_are_not_finite_have_no_roots(wrong):
    assert len(bridge.quartic_roots(np.array([1.0, wrong, 0.0, 0.0]))) == 0


def test_poses_are_told_from_other_matrices(rng):
    good = np.array([pin.SE3.Random().homogeneous for _ in range(5)])
    assert are_poses(good)
    assert are_poses(good[::2]), "also where rows are not adjacent in memory"
    assert are_poses(good[:0])
    for i, j, change in ((0, 0, 1e-3), (1, 3, np.nan), (2, 3, np.inf), (3, 0, 1e-3), (3, 3, 1e-3)):
        wrong = good.copy()
        wrong[2, i, j] += change
        assert not are_poses(wrong)
    mirrored = good.copy()
    mirrored[1, :, 0] *= -1
    assert not are_poses(mirrored)


def test_residuals_and_duplicates_as_numpy_has_them(rng):
    reached, targets, owners = rng.normal(size=(20, 4, 4)), rng.normal(size=(3, 4, 4)), rng.integers(3, size=20)
    reached[:, 3] = targets[:, 3] = [0, 0, 0, 1]
    np.testing.assert_array_equal(residuals(reached, targets, owners), np.abs(reached - targets[owners]).max(axis=(1, 2)))
    q = rng.integers(2, size=(60, 2)) + rng.uniform(-0.4, 0.4, (60, 2)) * COINCIDENT
    source = rng.integers(4, size=60)
    kept = []
    for k in np.argsort(source, kind="stable"):
        if not any(source[k] == source[i] and (np.abs(q[k] - q[i]) < COINCIDENT).all() for i in kept):
            kept.append(k)
    assert distinct(q, source).tolist() == kept
    assert 4 < len(kept) < 20


def test_a_newton_step_is_that_of_least_squares(rng):
    """One undamped step from nearby: the pseudoinverse of Pinocchio's Jacobian times the error of the pose."""
    panda = mp.load_robot("panda")
    screws = Screws.of(panda)
    q = panda.random_configuration(rng)
    near = q + rng.uniform(-1e-2, 1e-2, 7)
    kinematics = panda.kinematics(mp.Task.pose(1.0), compiled=False)
    target, pose, jacobian = kinematics.pose(near), kinematics.pose(q), kinematics.jacobian(q)
    error = np.concatenate([target[:3, 3] - pose[:3, 3], pin.log3(target[:3, :3] @ pose[:3, :3].T)])
    moves = np.arange(7) != 2
    jacobian[:, ~moves] = 0
    arm = MovingArm(screws, moves)
    stepped = arm.refine(q[None], target[None], np.zeros(1, dtype=np.int64), steps=1, tolerance=1e-12)[0]
    np.testing.assert_allclose(stepped, q + np.linalg.pinv(jacobian, rcond=1e-10) @ error, atol=1e-9)
    assert stepped[2] == q[2]


def test_steps_stop_at_the_limits(rng):
    """The least distance to a pose beyond the limits has joints at their limits, and no other step leads nearer."""
    panda = mp.load_robot("panda")
    lower, upper = panda.limits.lower, panda.limits.upper
    target = panda.kinematics(mp.Task.pose(), compiled=False).pose(upper + 0.3)
    arm = MovingArm(Screws.of(panda), np.ones(7, dtype=np.bool_))
    q, miss = arm.search(panda.random_configuration(rng, size=20), target, lower, upper, steps=300, tolerance=1e-12)
    assert ((q >= lower) & (q <= upper)).all()
    assert ((q == lower) | (q == upper)).any(axis=1).sum() > 10
    assert (miss > 1e-3).any()


def test_all_joints_held_stay_where_they_are():
    panda = mp.load_robot("panda")
    arm = MovingArm(Screws.of(panda), np.zeros(7, dtype=np.bool_))
    q, target = panda.neutral[None], np.eye(4)
    assert (arm.refine(q, target[None], np.zeros(1, dtype=np.int64), steps=9, tolerance=1e-9) == q).all()


@pytest.mark.slow
def test_llvm_and_the_compiler_agree(by_llvm, monkeypatch, rng):
    """The same bits of all solutions of arms of each closed form."""
    for name in ("panda", "ur5", "kinova"):
        robot = mp.load_robot(name)
        poses = robot.kinematics(compiled=False).pose(robot.random_configuration(rng, size=10))
        options = {"task": mp.Task.pointing(), "samples": 5} if name == "ur5" else {"samples": 20} if robot.n > 6 else {}
        usual = mp.inverse_kinematics(robot, poses, **options)
        with monkeypatch.context() as patch:
            patch.setattr(bridge, "ik_functions", lambda: by_llvm)
            for module in ("form", "newton", "solutions"):
                patch.setattr(f"manipplan.ik.{module}.ik_functions", lambda: by_llvm)
            other = mp.inverse_kinematics(robot, poses, **options)
        np.testing.assert_array_equal(other.q, usual.q)
        assert len(usual) > 20


def test_headers_stand_in_place_of_their_lines_once(tmp_path, monkeypatch):
    monkeypatch.setattr(kernels, "FOLDER", tmp_path)
    (tmp_path / "a.c").write_text('#include <math.h>\n#include "b.h"\n#include "c.h"\nint a;\n')
    (tmp_path / "b.h").write_text('#pragma once\n#include "c.h"\nint b;\n')
    (tmp_path / "c.h").write_text("#pragma once\nint c;\n")
    assert source_text("a") == "#include <math.h>\nint c;\nint b;\nint a;\n"
