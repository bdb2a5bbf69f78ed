"""Paths, trajectories and their files."""

import json

import numpy as np
import pytest
import yaml
from scipy.interpolate import BPoly, CubicHermiteSpline

import manipplan as mp
from manipplan.paths.joint import rounded


def random_path(rng, degree=5, pieces=1, n=3):
    points = rng.normal(size=(pieces * degree + 1, n))
    control = np.array([points[k * degree : (k + 1) * degree + 1] for k in range(pieces)])
    return mp.JointPath(breaks=np.linspace(0, 1, pieces + 1), control=control)


def random_trajectory(rng, count=7):
    t = np.concatenate([[0.0], np.cumsum(rng.uniform(0.05, 0.5, count - 1))])
    names = ("a", "b", "c")
    return mp.Trajectory(t=np.round(t, 9), q=rng.normal(size=(count, 3)), qd=rng.normal(size=(count, 3)), joint_names=names)


@pytest.mark.parametrize("pieces", [1, 4])
def test_path_and_derivatives_equal_scipy(rng, pieces):
    path = random_path(rng, pieces=pieces)
    oracle = BPoly(path.control.transpose(1, 0, 2), path.breaks)
    s = np.sort(rng.uniform(size=50))
    for order in range(7):
        np.testing.assert_allclose(path(s, order), oracle(s, nu=order), rtol=1e-9, atol=1e-8)
    np.testing.assert_array_equal(path(0.0), path.start)
    np.testing.assert_array_equal(path(1.0), path.goal)


def test_length_of_a_polyline_is_the_sum_of_its_edges(rng):
    points = rng.normal(size=(6, 4))
    path = mp.JointPath.through(points)
    assert path.length == pytest.approx(np.linalg.norm(np.diff(points, axis=0), axis=1).sum(), rel=1e-12)


def test_joined_paths_are_their_parts(rng):
    """Of any degrees; each has the share of s that its length has of the whole."""
    knots = rng.normal(size=(5, 3))
    first = mp.JointPath(breaks=np.array([0.0, 1.0]), control=rng.normal(size=(1, 7, 3)))
    second = mp.JointPath.spline(np.linspace(0, 1, 5), np.vstack([first.goal, knots[1:]]))
    third = mp.JointPath.line(second.goal, knots[0])
    parts = (first, second, third)
    whole = mp.JointPath.joined(parts)
    ends = np.cumsum([0.0, *(part.length for part in parts)]) / whole.length
    for part, begin, end in zip(parts, ends[:-1], ends[1:], strict=True):
        s = np.linspace(0.0, 1.0, 57)[1:-1]
        np.testing.assert_allclose(whole(begin + (end - begin) * s), part(s), atol=1e-9)
    assert whole.length == pytest.approx(sum(part.length for part in parts), rel=1e-9)
    for wrong in ([], [first, third], [first, mp.JointPath(breaks=np.array([0.0, 1.0]), control=np.zeros((1, 2, 3)))]):
        with pytest.raises(mp.errors.InvalidInputError):
            mp.JointPath.joined(wrong)


def test_bounds_are_those_of_a_dense_sample(rng):
    for _ in range(20):
        path = random_path(rng, degree=6, pieces=2)
        low, high = path.bounds()
        dense = path(np.linspace(0, 1, 20001))
        np.testing.assert_allclose(low, dense.min(axis=0), atol=1e-6)
        np.testing.assert_allclose(high, dense.max(axis=0), atol=1e-6)
        assert (dense >= low - 1e-12).all()
        assert (dense <= high + 1e-12).all()


def test_fine_samples_leave_no_wide_step(rng):
    path = random_path(rng, degree=6, pieces=3)
    s = path.fine_samples(1e-2)
    assert (s[0], s[-1]) == (0.0, 1.0)
    assert np.abs(np.diff(path(s), axis=0)).max() <= 1e-2
    assert len(s) < 1.5 * np.abs(path(np.linspace(0, 1, 5001), 1)).max(axis=1).mean() / 1e-2 + 10


def test_rounded_corners_are_smooth_and_stay_near(rng):
    points = rng.normal(size=(5, 3))
    path = rounded(points, lambda _: True)
    np.testing.assert_allclose(path.start, points[0])
    np.testing.assert_allclose(path.goal, points[-1], atol=1e-12)
    inner = path.breaks[1:-1]
    for order in (1, 2):
        np.testing.assert_allclose(path(inner - 1e-12, order), path(inner, order), atol=1e-6 * np.abs(path(inner, 1)).max())
    edges = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    assert path.length < edges


def test_a_corner_that_cannot_be_rounded_stays_sharp():
    points = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
    path = rounded(points, lambda _: False)
    np.testing.assert_allclose(path(path.breaks), points)


@pytest.mark.parametrize(
    ("breaks", "control"),
    [
        ([0, 1], np.zeros((1, 1, 2))),
        ([0, 0.5], np.zeros((1, 3, 2))),
        ([0, 1], np.zeros((2, 3, 2))),
        ([0, 0.5, 1], [[[0.0], [1.0]], [[2.0], [3.0]]]),
        ([0, 1], [[[0.0], [np.nan]]]),
    ],
)
def test_wrong_paths(breaks, control):
    with pytest.raises(mp.errors.InvalidInputError):
        mp.JointPath(breaks=breaks, control=control)


@pytest.mark.parametrize("s", [-0.1, 1.1, np.nan])
def test_parameters_outside(rng, s):
    with pytest.raises(mp.errors.InvalidInputError, match="s: got"):
        random_path(rng)(s)


def test_trajectory_equals_scipy_and_its_path(rng):
    trajectory = random_trajectory(rng)
    oracle = CubicHermiteSpline(trajectory.t, trajectory.q, trajectory.qd)
    t = rng.uniform(0, trajectory.duration, 40)
    for order in range(4):
        np.testing.assert_allclose(trajectory(t, order), oracle(t, nu=order), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(trajectory.path()(t / trajectory.duration), oracle(t), atol=1e-12)
    slow = trajectory.slower(2.0)
    np.testing.assert_allclose(slow(2 * t), trajectory(t), atol=1e-6)
    np.testing.assert_allclose(slow(2 * t, 1), trajectory(t, 1) / 2, atol=1e-6)


@pytest.mark.parametrize("kind", ["csv", "json", "ros", "npz"])
@pytest.mark.parametrize("names", [("a,b", 'c"d', "e f"), ("yes", "1", "null"), ("ü", "q_", "x:y")])
def test_odd_joint_names_come_back(tmp_path, rng, kind, names):
    plain = random_trajectory(rng)
    trajectory = mp.Trajectory(t=plain.t, q=plain.q, qd=plain.qd, joint_names=names)
    getattr(trajectory, f"to_{kind}")(tmp_path / "file")
    assert getattr(mp.Trajectory, f"from_{kind}")(tmp_path / "file").joint_names == names


@pytest.mark.parametrize("names", [("a", "a", "b"), ("a", "b", "c\r"), (1, 2, 3), "abc", ("a", "b")])
def test_joint_names_are_different_names(rng, names):
    plain = random_trajectory(rng)
    with pytest.raises(mp.errors.InvalidInputError, match="joint_names"):
        mp.Trajectory(t=plain.t, q=plain.q, qd=plain.qd, joint_names=names)


@pytest.mark.parametrize("kind", ["csv", "json", "ros", "npz"])
def test_round_trips_are_exact(tmp_path, rng, kind):
    trajectory = random_trajectory(rng)
    file = tmp_path / f"motion.{kind}"
    getattr(trajectory, f"to_{kind}")(file)
    again = getattr(mp.Trajectory, f"from_{kind}")(file)
    assert again.joint_names == trajectory.joint_names
    for name in ("t", "q", "qd"):
        np.testing.assert_array_equal(getattr(again, name), getattr(trajectory, name))
    assert [f.name for f in tmp_path.iterdir()] == [file.name]


def test_ros_message_has_the_fields_of_trajectory_msgs(tmp_path, rng):
    trajectory = random_trajectory(rng)
    trajectory.to_ros(tmp_path / "motion.yaml")
    message = yaml.safe_load((tmp_path / "motion.yaml").read_text())
    assert message["joint_names"] == ["a", "b", "c"]
    point = message["points"][3]
    assert set(point) == {"positions", "velocities", "accelerations", "effort", "time_from_start"}
    stamp = point["time_from_start"]
    assert stamp["sec"] + 1e-9 * stamp["nanosec"] == pytest.approx(trajectory.t[3], abs=1e-9)
    np.testing.assert_allclose(point["accelerations"], trajectory(trajectory.t[3], 2))


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        ("csv", ""),
        ("csv", "time,a,x\n0,1,2\n1,2,3\n"),
        ("csv", "time,q_a,q_a\n0,1,2\n1,2,3\n"),
        ("csv", "q_a,q_b\n0,1\n1,2\n"),
        ("csv", "time,q_a,q_b,qd_a\n0,1,1,0\n1,2,1,0\n"),
        ("csv", "time,q_a,qd_a\n0,1,0\n1,x,0\n"),
        ("csv", "time,q_a,qd_a\n0,1,0\n1,2\n"),
        ("csv", "time,q_a,qd_a\n1,1,0\n0,2,0\n"),
        ("json", "{"),
        ("json", json.dumps({"format": "manipplan-trajectory", "version": 99})),
        ("json", json.dumps({"format": "manipplan-trajectory", "version": 1, "joint_names": ["a"]})),
        ("ros", "joint_names: [a]"),
        ("ros", "- 1"),
        ("ros", "{"),
        ("ros", "joint_names: [a]\npoints: [{positions: [1], time_from_start: {sec: 0, nanosec: 0}}]"),
        ("npz", "nothing"),
    ],
)
def test_broken_files_are_told(tmp_path, kind, text):
    file = tmp_path / "broken"
    file.write_text(text)
    with pytest.raises(mp.errors.FileFormatError, match="broken"):
        getattr(mp.Trajectory, f"from_{kind}")(file)


def test_writing_where_nothing_can_be_written(tmp_path, rng):
    with pytest.raises(mp.errors.InvalidInputError, match="path that can be written"):
        random_trajectory(rng).to_csv(tmp_path / "missing" / "file.csv")


def test_a_failed_write_leaves_the_old_file(tmp_path, rng):
    from manipplan.support.files import write_bytes

    file = tmp_path / "kept.txt"
    file.write_text("old")

    def broken(stream):
        stream.write(b"half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_bytes(file, broken)
    assert file.read_text() == "old"
    assert [f.name for f in tmp_path.iterdir()] == ["kept.txt"]


@pytest.mark.parametrize(("t", "count"), [([0.0], 1), ([0.0, 0.0], 2), ([0.1, 0.2], 2), ([0.0, np.nan], 2), ([0.0, 1.0], 3)])
def test_wrong_trajectories(t, count):
    with pytest.raises(mp.errors.InvalidInputError):
        mp.Trajectory(t=t, q=np.zeros((count, 1)), qd=np.zeros((count, 1)), joint_names=("a",))


def test_places_of_a_spline_are_named_as_given(rng):
    with pytest.raises(mp.errors.InvalidInputError, match=r"^s: got .*; allowed: 3 increasing numbers from 0 to 1"):
        mp.JointPath.spline([0, 1, 2], rng.normal(size=(3, 2)))
