"""Deviation of a motion's tool from a workspace path, and the spline that joins configurations."""

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import manipplan as mp
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import _from_piece as from_piece
from manipplan.paths.deviation import beyond_polygon, deviation_at, deviation_from, deviations, distances_from
from manipplan.symbolic.free_motion import FreeMotion

RNG = np.random.default_rng(7)
START = pin.SE3(pin.rpy.rpyToMatrix(0.4, -0.3, 1.1), np.array([0.4, -0.1, 0.3])).homogeneous
END = pin.SE3(pin.rpy.rpyToMatrix(0.9, 0.5, 0.2), np.array([0.5, 0.4, 0.1])).homogeneous
LINE = CartesianPath.line(START, END)


def turned(poses, rotvec):
    """Turned about the tool's own axes."""
    new = np.array(poses)
    new[..., :3, :3] = new[..., :3, :3] @ pin.exp3(np.asarray(rotvec, dtype=float))
    return new


def shifted(poses, by):
    new = np.array(poses)
    new[..., :3, 3] += by
    return new


# ---- deviation


def test_a_motion_on_the_path_has_none_whatever_its_timing():
    s = np.sort(RNG.uniform(size=300)) ** 2
    for path in (LINE, CartesianPath.circle(START, START[:3, 3] + [0.1, 0, 0], [0, 0, 1], turning=True)):
        found = deviation_from(path, path(s))
        assert found.position < 2e-7  # of chords of a 2000th
        assert found.rotation < 1e-6
        assert found.position > 0 or found.rotation > 0 or path is LINE


@pytest.mark.parametrize("offset", [1e-6, 1e-3, 0.05])
def test_a_known_offset_is_found_where_it_is(offset):
    s = np.linspace(0, 1, 101)
    across = np.cross(END[:3, 3] - START[:3, 3], [0, 0, 1.0])
    across /= np.linalg.norm(across)
    poses = LINE(s)
    poses[30] = shifted(poses[30], offset * across)
    poses[70] = turned(poses[70], [0, 0, offset])
    found = deviation_from(LINE, poses)
    assert found.position == pytest.approx(offset, rel=1e-6)
    assert found.position_at == pytest.approx(0.3)
    assert found.rotation == pytest.approx(offset, rel=0.01, abs=1e-12)
    assert found.rotation_at == pytest.approx(0.7)
    assert f"{1e3 * offset:.3g} mm" in str(found)


def test_an_offset_beyond_the_ends_counts():
    beyond = shifted(LINE(np.array([0.0, 1.0])), (END - START)[:3, 3] * np.array([[-0.1], [0.1]]))
    found = deviation_from(LINE, beyond)
    assert found.position == pytest.approx(0.1 * np.linalg.norm((END - START)[:3, 3]), rel=1e-9)


def test_the_angle_is_right_up_to_half_a_turn():
    still = CartesianPath.line(START, shifted(START, [0.2, 0, 0]))
    for angle in (1e-8, 0.5, 2.0, np.pi - 1e-3, np.pi):
        assert deviation_from(still, turned(still([0.5]), [0, angle, 0])).rotation == pytest.approx(angle, abs=1e-7)


def pointing(axis):
    return FreeMotion.of(mp.Task.pointing(axis))


def test_a_pointing_tool_may_turn_about_its_axis_and_no_other():
    axis = np.array([0.6, 0.0, 0.8])
    s = np.linspace(0, 1, 50)
    spun = np.array([turned(pose, angle * axis) for pose, angle in zip(LINE(s), 5 * s, strict=True)])
    assert deviation_from(LINE, spun).rotation > 2
    found = deviation_from(LINE, spun, pointing(axis))
    assert found.rotation < 1e-6 and found.position < 1e-9
    leaning = np.array([turned(pose, 0.02 * np.array([0.0, 1.0, 0.0])) for pose in spun])
    assert 0.01 < deviation_from(LINE, leaning, pointing(axis)).rotation < 0.021


def test_a_path_that_turns_about_the_pointing_axis_leaves_no_bias():
    """Pieces whose turn does not count have to be divided by their length alone: a share of it once made 0.1 mm of nothing."""
    circle = CartesianPath.circle(START, START[:3, 3] + [0.0, 0.1, 0.0], [0, 0, 1], turning=True)
    axis = START[:3, :3].T @ [0, 0, 1.0]
    found = deviation_from(circle, circle(RNG.uniform(size=400)), pointing(axis))
    assert found.position < 2e-7
    assert found.rotation < 1e-6


def test_a_path_of_rotation_alone():
    spin = CartesianPath.line(START, turned(START, [0, 0, 1.5]))
    s = RNG.uniform(size=100)
    assert deviation_from(spin, spin(s)).rotation < 1e-7
    assert deviation_from(spin, spin(s), pointing([1.0, 0, 0])).rotation < 1e-6
    off = deviation_from(spin, turned(spin(s), [0.1, 0, 0]))
    assert 0.05 < off.rotation < 0.1 + 1e-9
    assert off.position < 1e-12
    assert deviation_from(spin, shifted(spin(s), [0, 0.01, 0])).position == pytest.approx(0.01)


def test_a_coarse_curve_and_one_pose():
    """Three poses on a path through far-apart poses; the nearest piece is found although none of its ends is near."""
    path = CartesianPath.through([START, shifted(END, [5, 0, 0]), shifted(START, [0, 9, 0])])
    s = np.array([0.12345, 0.5, 0.98765])
    assert deviation_from(path, path(s)).position < 1e-5
    assert deviation_from(path, shifted(path(s[:1]), [0, 0, 0.25])).position == pytest.approx(0.25, rel=0.2)
    with pytest.raises(mp.errors.InvalidInputError, match="poses: .*at least one pose"):
        deviation_from(path, path(s[:0]))


def test_by_parameter_a_shortcut_and_a_wrong_order_are_found():
    """Each pose lies on the path, but the way is not the path's."""
    there_and_back = CartesianPath.circle(START, START[:3, 3] + [0.1, 0, 0], [0, 0, 1])
    s = np.linspace(0, 1, 200)
    still = np.broadcast_to(START, (200, 4, 4))
    assert deviation_from(there_and_back, still).position < 1e-9
    assert deviation_at(there_and_back, s, still).position == pytest.approx(0.2, rel=1e-3)
    assert deviation_from(LINE, LINE(s[::-1])).position < 1e-9
    assert deviation_at(LINE, s, LINE(s[::-1])).position == pytest.approx(LINE.length, rel=1e-6)
    assert deviation_at(LINE, s, LINE(s)).position == 0


# ---- JointPath.spline


S = np.array([0.0, 0.1, 0.35, 0.5, 0.8, 1.0])
Q = RNG.normal(size=(6, 3))


def one_sided(path, s, order):
    """The derivative just before and just after s."""
    return path(s - 1e-9, order), path(s + 1e-9, order)


def test_a_spline_interpolates_and_is_twice_continuously_differentiable():
    path = mp.JointPath.spline(S, Q)
    np.testing.assert_allclose(path(S), Q, atol=1e-12)
    np.testing.assert_array_equal(path.start, Q[0])
    np.testing.assert_array_equal(path.goal, Q[-1])
    for s in S[1:-1]:
        for order in (1, 2):
            before, after = one_sided(path, s, order)
            np.testing.assert_allclose(before, after, atol=1e-4)
    third = one_sided(path, 0.35, 3)
    assert np.abs(third[0] - third[1]).max() > 1  # a spline of its own, not one cubic
    cubic = S[:, None] ** [1, 2, 3]
    np.testing.assert_allclose(mp.JointPath.spline(S, cubic)(0.6), [0.6, 0.36, 0.216], atol=1e-12)


def test_a_closed_spline_is_periodic_in_slope_and_curvature():
    q = np.vstack([Q[:-1], Q[:1]])
    path, open_path = mp.JointPath.spline(S, q, closed=True), mp.JointPath.spline(S, q)
    np.testing.assert_allclose(path(S), q, atol=1e-12)
    for order in (1, 2):
        np.testing.assert_allclose(path(0.0, order), path(1.0, order), atol=1e-9)
        assert np.abs(open_path(0.0, order) - open_path(1.0, order)).max() > 0.1


def test_a_closed_spline_may_end_full_turns_further_on():
    q = np.vstack([Q[:-1], Q[:1] + [2 * np.pi, 0, -4 * np.pi]])
    path = mp.JointPath.spline(S, q, closed=True)
    np.testing.assert_allclose(path(S), q, atol=1e-12)
    for order in (1, 2):
        np.testing.assert_allclose(path(0.0, order), path(1.0, order), atol=1e-9)


def test_a_closed_spline_of_three_rows():
    path = mp.JointPath.spline([0.0, 0.5, 1.0], [[0.0], [1.0], [0.0]], closed=True)
    np.testing.assert_allclose(path([0.0, 0.5, 1.0])[:, 0], [0, 1, 0], atol=1e-12)
    np.testing.assert_allclose(path(0.0, 1), path(1.0, 1), atol=1e-12)


@pytest.mark.parametrize(
    ("s", "q", "closed", "message"),
    [
        ([0.0, 0.5], Q, False, "s: .*increasing numbers from 0 to 1, one per row of q"),
        ([0.0], Q[:1], False, "s: "),
        ([0.0, 0.6, 0.5], Q[:3], False, "s: "),
        ([0.0, 0.5, 0.5], Q[:3], False, "s: "),
        ([0.0, 0.5, 2.0], Q[:3], False, "s: "),
        ([0.1, 0.5, 1.0], Q[:3], False, "s: "),
        ([0.0, np.nan, 1.0], Q[:3], False, "s: .*finite"),
        ([0.0, 0.5, 1.0], [[0.0], [np.inf], [1.0]], False, "q: .*finite"),
        ([0.0, 0.5, 1.0], [0.0, 1.0, 2.0], False, "q: .*shape"),
        ("s", Q, False, "s: got 's'"),
        (S, Q, True, "q: .*a last row equal to the first up to full turns"),
    ],
)
def test_wrong_splines(s, q, closed, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.JointPath.spline(s, q, closed=closed)


# ---- against all pieces of the line


@pytest.mark.parametrize("task", [mp.Task.pose(), mp.Task.pointing([0, 0, 1]), mp.Task.position()], ids=lambda task: task.name)
def test_the_nearest_piece_is_found_among_all_also_where_a_path_passes_beside_itself(task):
    free, rng = FreeMotion.of(task), np.random.default_rng(4)
    s = np.linspace(0, 1, 160)
    line = np.tile(START, (len(s), 1, 1))
    line[:, :3, 3] += 0.1 * np.stack([np.sin(7 * s), np.sin(16 * s), 0.01 * s], axis=1)  # crosses itself
    line = np.array([turned(pose, [0.2 * x, 0, x]) for pose, x in zip(line, s, strict=True)])
    poses = np.array(
        [
            shifted(turned(line[k], v), w)
            for k, v, w in zip(
                rng.integers(0, len(s), 300), rng.normal(0, 0.02, (300, 3)), rng.normal(0, 2e-3, (300, 3)), strict=True
            )
        ]
    )
    found = np.array(distances_from(line, poses, free))
    every = np.array([from_piece(poses, line[[k] * 300], line[[k + 1] * 300], free) for k in range(len(s) - 1)])
    least = (every[:, 0] + 0.1 * every[:, 1]).min(axis=0)
    np.testing.assert_allclose(found[0] + 0.1 * found[1], least, rtol=0.05, atol=1e-9)
    assert np.median((found[0] + 0.1 * found[1]) / least) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.slow
def test_corners_between_evenly_spaced_poses_are_no_deviation():
    """Poses 21 mm apart on a zigzag of 12 m: of 2000 evenly spaced pieces of it, each corner is beside the middle of one."""
    corners = np.array([[0.5 * k, 0.3 * (k % 2), 0] for k in range(21)])
    way = np.append(0.0, np.linalg.norm(np.diff(corners, axis=0), axis=1).cumsum())
    s = np.union1d(np.linspace(0, way[-1], 561), way)
    given = np.tile(START, (len(s), 1, 1))
    given[:, :3, 3] += np.array([np.interp(s, way, column) for column in corners.T]).T
    path = CartesianPath.through(given)
    assert deviation_from(path, path(np.sort(RNG.uniform(size=4000)))).position < 3e-4
    assert deviation_from(path, path(path.knots)).position < 1e-7


def test_a_pose_within_the_tolerance_of_some_pose_of_the_path_is_within_it():
    """The nearest pose by distance and angle together turns less, and is farther away than the tolerance allows."""
    tolerance = mp.Tolerance(position=1e-4, rotation=2e-3)
    turning = CartesianPath.line(START, turned(shifted(START, [0.1, 0, 0]), [0, 0, 3.0]))
    s = np.linspace(0.1, 0.9, 50)
    poses = turned(shifted(turning(s), [0, 0.96e-4, 0]), [0, 0, 1.9e-3])
    plain = deviations(turning, poses)
    assert plain[0].max() > tolerance.position
    position, rotation = deviations(turning, poses, tolerance=tolerance)
    assert position.max() <= tolerance.position and rotation.max() <= tolerance.rotation
    beyond = turned(shifted(turning(s), [0, 1.5e-4, 0]), [0, 0, 2.9e-3])
    position, rotation = deviations(turning, beyond, tolerance=tolerance)
    assert ((position > tolerance.position) | (rotation > tolerance.rotation)).all()


@pytest.mark.slow
@settings(deadline=None, max_examples=50)
@given(st.floats(0.5, 0.95), st.floats(2.0, 40.0), st.floats(0.0, 0.8), st.integers(1, 8))
def test_both_parts_are_kept_where_the_sum_is_not_smallest(height, rate, share, fineness):
    """A tool that turns by `rate` [rad/m] past a pose whose position is `height` tolerances off its straight way."""
    tolerance = mp.Tolerance(position=1e-4, rotation=1e-3)
    half = 1e-4 * np.sqrt(1 - height**2)  # of the way on which the position is kept
    u = np.arange(-6e-4, 6e-4, 4e-6 / fineness)
    angles = 1e-3 + rate * (share * half - u)  # the rotation is kept from u = share * half on
    way = np.tile(np.eye(4), (len(u), 1, 1))
    way[:, 0, 3] = u
    way[:, :3, :3] = Rotation.from_rotvec(angles[:, None] * [0.0, 0.0, 1.0]).as_matrix()
    pose = np.eye(4)
    pose[1, 3] = height * 1e-4
    position, rotation = distances_from(way, pose[None], tolerance=tolerance)
    fine = np.linspace(-6e-4, 6e-4, 200_001)
    apart = [np.hypot(fine, height * 1e-4) / 1e-4, np.abs(1e-3 + rate * (share * half - fine)) / 1e-3]
    least = np.max(apart, axis=0).min()
    assert least <= 1
    assert max(position[0] / 1e-4, rotation[0] / 1e-3) <= max(1.0, least + 0.02)


SHAPES = ("line", "circle", "turning circle", "polygon", "turn", "eight")
ALONG_TOOL = mp.Task.custom(np.eye(6)[[0, 1, 3, 4, 5]], frame="tool", name="free along z")


def shape_of(kind, rng):
    if "circle" in kind:
        return CartesianPath.circle(START, START[:3, 3] + [0.05, 0, 0], [0, 0, 1], turning=kind != "circle")
    if kind == "polygon":
        poses = np.tile(np.eye(4), (rng.integers(3, 12), 1, 1))
        poses[:, :3, :3] = Rotation.from_rotvec(rng.normal(0, 0.4, (len(poses), 3))).as_matrix()
        poses[:, :3, 3] = rng.normal(0, 0.1, (len(poses), 3))
        return CartesianPath.through(poses)
    if kind == "eight":
        t = np.linspace(0, 2 * np.pi, 60)
        poses = np.tile(np.eye(4), (len(t), 1, 1))
        poses[:, :2, 3] = np.column_stack([0.2 * np.sin(t), 0.1 * np.sin(2 * t)])
        poses[:, :3, :3] = Rotation.from_rotvec(np.outer(np.sin(t), rng.normal(0, 0.5, 3))).as_matrix()
        return CartesianPath.through(poses)
    return CartesianPath.line(START, END if kind == "line" else turned(START, [0.3, 1.0, 0.2]))


@pytest.mark.slow
@settings(deadline=None, max_examples=40)
@given(
    st.sampled_from(SHAPES),
    st.sampled_from([mp.Task.pose(), mp.Task.pointing([0, 0, 1]), ALONG_TOOL]),
    st.sampled_from([(0.01, 0.09), (0.03, 0.01), (1e-3, 0.3)]),
    st.integers(0, 2**31),
)
def test_a_tool_within_the_tolerance_of_each_pose_in_order_is_within_it(kind, task, widths, seed):
    """Whichever piece of the path is the nearest: at the seam of a closed one, beside corners, where only the rotation turns."""
    rng, tolerance = np.random.default_rng(seed), mp.Tolerance(position=widths[0], rotation=widths[1])
    path, free = shape_of(kind, rng), FreeMotion.of(task)
    s = np.linspace(0.0, 1.0, 1001 if task is not ALONG_TOOL else 201)
    ways = np.cos(np.outer(s, rng.uniform(0, 6, 6)) + rng.uniform(0, 2 * np.pi, 6))
    ways /= np.maximum(1.0, [np.linalg.norm(part, axis=1).max() for part in (ways[:, :3], ways[:, 3:])]).repeat(3)
    reached = shifted(path(s), 0.9 * widths[0] * ways[:, :3])
    reached[:, :3, :3] = reached[:, :3, :3] @ Rotation.from_rotvec(0.9 * widths[1] * ways[:, 3:]).as_matrix()
    if task is ALONG_TOOL:
        reached[:, :3, 3] += 0.05 * ways[:, :1] * path(s)[:, :3, 2]
    assert deviation_at(path, s, reached, free).excess(tolerance, "path") == ""
    found = [deviations(path, reached, free, tolerance), distances_from(reached, path(s), free, tolerance, is_reached=True)]
    if path.given is not None:
        found.append(beyond_polygon(path.given, reached, free, tolerance))
    for position, rotation in found:
        assert position.max() <= 1.001 * widths[0]
        assert rotation.max() <= 1.001 * widths[1]


@pytest.mark.parametrize("tolerance", [mp.Tolerance(position=1e-4), mp.Tolerance(rotation=2e-3)], ids=["position", "rotation"])
def test_a_tolerance_of_one_part_leaves_the_other_finite(tolerance):
    poses = shifted(LINE(np.linspace(0, 1, 30)), [0, 3e-3, 0])
    position, rotation = deviations(LINE, turned(poses, [0.02, 0, 0]), tolerance=tolerance)
    assert np.isfinite(position).all() and np.isfinite(rotation).all()
    assert position.max() < 0.02 and rotation.max() < 0.3


@pytest.mark.parametrize("angle", [1e-3, 0.01, 0.05, 0.2])
def test_a_wide_tolerance_of_rotation_does_not_move_the_nearest_pose_away(angle):
    """On a path that turns, a pose as far along that turns as much is farther away than the narrow tolerance of position."""
    turning = CartesianPath.line(START, turned(shifted(START, [0.2, 0, 0]), [0, 0, 2.0]))
    poses = turned(turning(np.linspace(0.3, 0.7, 40)), [0, 0, 0.9 * angle])
    tolerance = mp.Tolerance(position=1e-4, rotation=angle)
    position, rotation = deviations(turning, poses, tolerance=tolerance)
    assert position.max() <= tolerance.position and rotation.max() <= tolerance.rotation


def test_a_share_of_the_smallest_tolerance_is_the_smallest():
    """follow uses a share of each: the error named 9e-10 where 1e-9 was given, which is allowed."""
    smallest = mp.Tolerance(position=1e-9, rotation=2e-9)
    assert smallest.scaled(0.9) == mp.Tolerance(position=1e-9, rotation=0.9 * 2e-9)
    assert mp.Tolerance(rotation=1e-3).scaled(2) == mp.Tolerance(rotation=2e-3)
