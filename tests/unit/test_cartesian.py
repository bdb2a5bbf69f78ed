"""CartesianPath: lines, arcs, splines and files of poses."""

from itertools import pairwise

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import manipplan as mp

START = pin.SE3(pin.rpy.rpyToMatrix(0.1, 0.2, 0.3), np.array([0.4, 0.0, 0.5]))
END = pin.SE3(pin.rpy.rpyToMatrix(0.5, -0.2, 1.3), np.array([0.4, 0.6, 0.3]))
HEAD = "x,y,z,qx,qy,qz,qw"


def some_poses(rng, count=6):
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, :3, 3] = np.cumsum(rng.normal(scale=0.2, size=(count, 3)), axis=0)
    poses[:, :3, :3] = [pin.exp3(each) for each in rng.normal(size=(count, 3))]
    return poses


def all_paths(rng):
    return {
        "line": mp.CartesianPath.line(START, END),
        "still line": mp.CartesianPath.line(START, pin.SE3(START.rotation, END.translation)),
        "circle": mp.CartesianPath.circle(START, [0.2, 0.0, 0.5], [0.0, 1.0, 2.0]),
        "turning arc": mp.CartesianPath.circle(START, [0.2, 0.0, 0.5], [0.0, 1.0, 2.0], -2.0, turning=True),
        "spline": mp.CartesianPath.through(some_poses(rng)),
        "two poses": mp.CartesianPath.through([START, END]),
    }


def test_all_poses_are_rotations_and_translations(rng):
    for path in all_paths(rng).values():
        poses = path(np.linspace(0, 1, 101))
        turned = np.swapaxes(poses[:, :3, :3], 1, 2) @ poses[:, :3, :3]
        np.testing.assert_allclose(turned, np.tile(np.eye(3), (101, 1, 1)), atol=1e-12)
        assert (np.linalg.det(poses[:, :3, :3]) > 0).all()
        np.testing.assert_array_equal(poses[:, 3], np.tile([0.0, 0.0, 0.0, 1.0], (101, 1)))


def test_no_path_jumps(rng):
    for path in all_paths(rng).values():
        poses = path(np.linspace(0, 1, 4001))
        assert np.abs(np.diff(poses, axis=0)).max() < 0.01


def test_a_line_is_straight_and_even():
    path = mp.CartesianPath.line(START, END)
    np.testing.assert_allclose(path([0.0, 1.0]), [START.homogeneous, END.homogeneous], atol=1e-15)
    positions = path(np.linspace(0, 1, 11))[:, :3, 3]
    np.testing.assert_allclose(np.diff(positions, axis=0), np.tile((END.translation - START.translation) / 10, (10, 1)))
    assert path.length == pytest.approx(np.linalg.norm(END.translation - START.translation))


def test_a_line_turns_evenly_about_one_axis():
    rotations = mp.CartesianPath.line(START, END)(np.linspace(0, 1, 11))[:, :3, :3]
    turns = np.array([pin.log3(a.T @ b) for a, b in pairwise(rotations)])
    np.testing.assert_allclose(turns, np.tile(pin.log3(START.rotation.T @ END.rotation) / 10, (10, 1)), atol=1e-12)


def test_a_line_with_a_half_turn_is_sound():
    turned = pin.SE3(START.rotation @ pin.exp3(np.array([0.0, np.pi, 0.0])), START.translation)
    poses = mp.CartesianPath.line(START, turned)(np.linspace(0, 1, 5))
    angles = [np.linalg.norm(pin.log3(START.rotation.T @ each[:3, :3])) for each in poses]
    np.testing.assert_allclose(angles, np.linspace(0, np.pi, 5), atol=1e-6)


def test_a_circle_stays_on_its_circle_and_closes():
    centre, axis = np.array([0.2, 0.1, 0.4]), np.array([0.0, 1.0, 2.0])
    path = mp.CartesianPath.circle(START, centre, axis)
    poses = path(np.linspace(0, 1, 101))
    arms = poses[:, :3, 3] - centre
    np.testing.assert_allclose(np.linalg.norm(arms, axis=1), np.linalg.norm(arms[0]))
    np.testing.assert_allclose(arms @ axis, arms[0] @ axis)
    np.testing.assert_allclose(poses[-1], START.homogeneous, atol=1e-12)
    np.testing.assert_allclose(poses[:, :3, :3], np.tile(START.rotation, (101, 1, 1)))
    radius = np.linalg.norm(arms[0] - arms[0] @ axis * axis / 5)
    assert path.length == pytest.approx(2 * np.pi * radius, rel=1e-5)


def test_an_arc_goes_by_the_right_hand_and_turns_the_tool_when_asked():
    start = pin.SE3(np.eye(3), np.array([1.0, 0.0, 0.0]))
    still = mp.CartesianPath.circle(start, np.zeros(3), [0.0, 0.0, 5.0], np.pi / 2)
    turning = mp.CartesianPath.circle(start, np.zeros(3), [0.0, 0.0, 5.0], np.pi / 2, turning=True)
    np.testing.assert_allclose(still(1.0)[:3, 3], [0.0, 1.0, 0.0], atol=1e-15)
    np.testing.assert_allclose(still(1.0)[:3, :3], np.eye(3))
    np.testing.assert_allclose(turning(1.0)[:3, :3], pin.utils.rotate("z", np.pi / 2), atol=1e-15)


def test_a_spline_goes_through_all_its_poses(rng):
    poses = some_poses(rng)
    path = mp.CartesianPath.through(poses)
    angles = np.array([np.linalg.norm(pin.log3(a[:3, :3].T @ b[:3, :3])) for a, b in pairwise(poses)])
    steps = np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1) + angles / 10
    s = np.concatenate([[0.0], np.cumsum(steps) / steps.sum()])
    np.testing.assert_allclose(path(np.minimum(s, 1.0)), poses, atol=1e-9)


def test_a_spline_takes_poses_of_any_kind(rng):
    poses = some_poses(rng)
    expected = mp.CartesianPath.through(poses)(0.37)
    np.testing.assert_array_equal(mp.CartesianPath.through([pin.SE3(each) for each in poses])(0.37), expected)
    np.testing.assert_array_equal(mp.CartesianPath.through([each.tolist() for each in poses])(0.37), expected)


def test_shapes_follow_those_of_s():
    path = mp.CartesianPath.line(START, END)
    assert path(0.5).shape == (4, 4)
    assert path([[0.1, 0.2, 0.3]]).shape == (1, 3, 4, 4)
    assert path(np.empty(0)).shape == (0, 4, 4)
    np.testing.assert_array_equal(path([[0.1, 0.2]])[0, 1], path(0.2))


def test_samples_are_even_with_both_ends(rng):
    path = mp.CartesianPath.through(some_poses(rng))
    np.testing.assert_array_equal(path.sample(5), path([0.0, 0.25, 0.5, 0.75, 1.0]))


@pytest.mark.parametrize("s", [-1e-9, 1.0 + 1e-9, [0.5, 2.0], np.nan, "half"])
def test_s_outside_zero_and_one_raises(s):
    with pytest.raises(mp.errors.InvalidInputError, match="s: got"):
        mp.CartesianPath.line(START, END)(s)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: mp.CartesianPath.line(np.eye(3), END), r"start: .*\(4, 4\)"),
        (lambda: mp.CartesianPath.line(START, 2 * np.eye(4)), "end: .*a rotation and a translation"),
        (lambda: mp.CartesianPath.line(START, np.diag([1.0, 1.0, -1.0, 1.0])), "end: .*a rotation"),
        (lambda: mp.CartesianPath.line(START, np.full((4, 4), np.nan)), "end: .*no NaN"),
        (lambda: mp.CartesianPath.circle(START, [0.0, 0.0], [0.0, 0.0, 1.0]), r"centre: .*\(3,\)"),
        (lambda: mp.CartesianPath.circle(START, np.zeros(3), np.zeros(3)), "axis: got 0.0|the length of axis: got 0.0"),
        (lambda: mp.CartesianPath.circle(START, np.zeros(3), [0, 0, 1.0], np.inf), "angle: got inf"),
        (lambda: mp.CartesianPath.circle(START, np.zeros(3), [0, 0, 1.0], turning=1), "turning: got 1"),
        (lambda: mp.CartesianPath.through([START]), "poses: .*at least two poses"),
        (lambda: mp.CartesianPath.through(START), "poses: .*at least two poses"),
        (lambda: mp.CartesianPath.through([START, END, np.eye(3)]), r"poses\[2\]: .*\(4, 4\)"),
        (lambda: mp.CartesianPath.through([END, END, END]), "poses: got '3 poses'.*at least two poses that differ"),
        (lambda: mp.CartesianPath.line(START, END).sample(1), "n: got 1.*at least 2"),
    ],
)
def test_what_makes_no_path_raises(make, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        make()


# ---- files


def row(pose, scale=1.0):
    quaternion = pin.Quaternion(pose.rotation)
    values = [*pose.translation, *(scale * each for each in quaternion.coeffs())]
    return ",".join(repr(float(value)) for value in values)


def written(tmp_path, *lines):
    file = tmp_path / "poses.csv"
    file.write_text("\n".join(lines) + "\n")
    return file


def test_a_file_gives_the_path_through_its_poses(tmp_path):
    middle = pin.SE3(pin.exp3(np.array([0.5, 0.2, 0.1])), np.array([0.5, 0.3, 0.6]))
    file = written(tmp_path, "# a demonstration", HEAD, row(START), "", row(middle, -1.0), row(END, 1.0005))
    expected = mp.CartesianPath.through([START, middle, END])
    for name in (file, str(file)):
        np.testing.assert_allclose(mp.CartesianPath.from_csv(name).sample(20), expected.sample(20), atol=1e-9)


@pytest.mark.slow
@given(order=st.permutations(range(7)))
@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_columns_are_found_by_their_names(tmp_path, order):
    """w first, as older files have it, or last."""
    lines = [",".join(line.split(",")[k] for k in order) for line in (HEAD, row(START), row(END))]
    np.testing.assert_allclose(
        mp.CartesianPath.from_csv(written(tmp_path, *lines))([0.0, 1.0]), [START.homogeneous, END.homogeneous], atol=1e-12
    )


def test_spaces_around_the_columns_do_not_matter(tmp_path):
    file = written(tmp_path, HEAD.replace(",", " , "), row(START).replace(",", ", "), row(END))
    np.testing.assert_allclose(mp.CartesianPath.from_csv(file)(0.0), START.homogeneous, atol=1e-12)


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ([], "which is empty"),
        (["x,y,z"], "a first line x,y,z,qx,qy,qz,qw, in any order"),
        ([HEAD, row(START), "1,2,3"], "row 3, with 3 cells.*7 cells"),
        ([HEAD, row(START), row(END).replace("0.4", "left")], "row 3, .*: left.*a number"),
        ([HEAD, "nan" + row(START)[3:], row(END)], "row 2, x: nan.*a finite number"),
        ([HEAD, row(START), row(END, 1.1)], "row 3: .*a quaternion qx, qy, qz, qw of length 1"),
        ([HEAD, row(START), row(END, 0.0)], "row 3: .*a quaternion qx, qy, qz, qw of length 1"),
        (["# made by hand", HEAD, "", row(START), "", "1,2,3"], "row 6, with 3 cells.*7 cells"),
    ],
)
def test_a_wrong_file_is_told_with_its_row(tmp_path, lines, message):
    with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
        mp.CartesianPath.from_csv(written(tmp_path, *lines))
    assert "poses.csv" in str(caught.value)


def test_a_file_of_one_pose_is_told_as_a_wrong_file(tmp_path):
    with pytest.raises(mp.errors.InvalidInputError, match="at least two poses"):
        mp.CartesianPath.from_csv(written(tmp_path, HEAD, row(START)))


def test_a_missing_file_names_its_neighbour(tmp_path):
    written(tmp_path, HEAD, row(START), row(END))
    with pytest.raises(mp.errors.FileFormatError, match="did you mean poses.csv"):
        mp.CartesianPath.from_csv(tmp_path / "pose.csv")


def test_a_file_that_is_no_text_is_told(tmp_path):
    file = tmp_path / "poses.csv"
    file.write_bytes(bytes(range(256)))
    with pytest.raises(mp.errors.FileFormatError, match="poses.csv"):
        mp.CartesianPath.from_csv(file)
