"""Trajectory files that are damaged or hostile, and disks that are full: one of our errors each time."""

import errno
import io
import os
import stat
import threading
import zipfile
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.support.files import write_bytes


@pytest.fixture
def motion():
    t = np.linspace(0.0, 1.0, 40)
    return mp.Trajectory(t=t, q=np.stack([t, t**2], axis=1), qd=np.stack([t**0, 2 * t], axis=1), joint_names=("a", "b"))


@pytest.mark.parametrize("compressed", [False, True])
def test_mutated_archives(motion, tmp_path, rng, compressed):
    whole = io.BytesIO()
    save = np.savez_compressed if compressed else np.savez
    save(whole, t=motion.t, q=motion.q, qd=motion.qd, joint_names=np.array(motion.joint_names))
    file = tmp_path / "motion.npz"
    refused = 0
    for _ in range(400):
        data = bytearray(whole.getvalue())
        for place in rng.integers(0, len(data), rng.integers(1, 6)):
            data[place] = rng.integers(0, 256)
        file.write_bytes(bytes(data[: rng.integers(0, len(data))]) if rng.random() < 0.2 else bytes(data))
        try:
            mp.Trajectory.from_npz(file)
        except mp.errors.FileFormatError as error:
            refused += 1
            assert str(file) in str(error)
    assert refused > 100


@pytest.mark.slow
def test_an_archive_that_unpacks_to_gigabytes(tmp_path):
    file = tmp_path / "motion.npz"
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive, archive.open("t.npy", "w", force_zip64=True) as stream:
        for _ in range(1100):
            stream.write(bytes(2**20))
    with pytest.raises(mp.errors.FileFormatError, match="of at most 134,217"):
        mp.Trajectory.from_npz(file)


@pytest.mark.parametrize("text", ["time,q_a\n0,0\n1," + "1" * 200_000, 'time,q_a\n0,0\n1,"1\x00', "time,q_a\n0,0\n1,1e400\n"])
def test_odd_cells(tmp_path, text):
    file = tmp_path / "motion.csv"
    file.write_text(text)
    with pytest.raises(mp.errors.FileFormatError, match="a CSV with columns time|row 3|a text file \\(CSV\\)"):
        mp.Trajectory.from_csv(file)


def test_a_full_disk(motion, tmp_path, monkeypatch):
    def full(self, data):
        raise OSError(errno.ENOSPC, "No space left on device")

    file = tmp_path / "motion.npz"
    motion.to_npz(file)
    before = file.read_bytes()
    monkeypatch.setattr(np, "savez", lambda stream, **arrays: full(stream, arrays))
    with pytest.raises(mp.errors.InvalidInputError, match=r"motion\.npz.*can be written \(No space left on device\)"):
        motion.to_npz(file)
    assert file.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == ["motion.npz"]


def test_a_device_that_is_full(tmp_path):
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"file: got .*motion\.csv.*a path that can be written \(No space left"
    ):
        write_bytes(tmp_path / "motion.csv", lambda stream: Path("/dev/full").write_bytes(b"0"))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("seed", [2**31, 10**19, -1, 0.5, True])
def test_seeds_are_bounded(planar, seed):
    pose = planar.kinematics(mp.Task.pose()).pose(planar.neutral)
    with pytest.raises(mp.errors.InvalidInputError, match="seed: got .*a whole number, at least 0, at most 2147483647"):
        mp.Seeding(seed=seed)
    with pytest.raises(mp.errors.InvalidInputError, match="seed: got .*at most 2147483647"):
        mp.inverse_kinematics(planar, pose, seed=seed)


def test_numbers_of_first_paths_are_bounded():
    with pytest.raises(mp.errors.InvalidInputError, match="count: got .*at most 10000"):
        mp.Seeding(count=10**19)


def test_motions_of_too_many_time_steps(planar):
    slow = planar.with_limits(velocity=1e-9)
    line = mp.JointPath.line([0.0, 1.0, 1.0], [1.0, 1.0, 1.0])
    with pytest.raises(mp.errors.InvalidInputError, match=r"allowed: a position that joint1 reaches at 1e-09 per second"):
        mp.improve(slow, mp.retime(line, planar))
    path = mp.CartesianPath.line(planar.kinematics().pose([0.0, 1.0, 1.0]), planar.kinematics().pose([0.1, 1.0, 1.0]))
    with pytest.raises(mp.errors.InvalidInputError, match="at most 1,000,000 time steps"):
        mp.track(planar, path, [0.0, 1.0, 1.0], mp.formulations.LogDrive(), dt=1e-9, duration=1.0)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"t": [0.0, 1e-320]}, "t: got .*times at least 1e-12 s apart, up to 1e"),
        ({"t": [0.0, 1e300]}, "t: got .*times at least 1e-12 s apart, up to 1e"),
        ({"q": [[0.0], [1e308]]}, "q: got .*numbers from -1e"),
        ({"qd": [[0.0], [-1e308]]}, "qd: got .*numbers from -1e"),
    ],
)
def test_motions_whose_coefficients_overflow(tmp_path, values, message):
    given = {"t": [0.0, 1.0], "q": [[0.0], [1.0]], "qd": [[0.0], [0.0]], **values}
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.Trajectory(**{key: np.array(value) for key, value in given.items()}, joint_names=("a",))
    file = tmp_path / "motion.csv"
    rows = [f"{t!r},{q!r}" for t, [q] in zip(given["t"], given["q"], strict=True)]
    file.write_text("\n".join(["time,q_a", *rows]))
    if "qd" not in values:
        with pytest.raises(mp.errors.FileFormatError, match=message):
            mp.Trajectory.from_csv(file)


def test_recorded_times_of_a_csv_that_are_too_close(tmp_path):
    file = tmp_path / "motion.csv"
    file.write_text("time,q_a\n0,0\n1e-300,1\n2e-300,3\n1,4\n")
    with pytest.raises(mp.errors.FileFormatError, match="times at least 1e-12 s apart"):
        mp.Trajectory.from_csv(file)


def test_messages_have_a_longest_length():
    text = "x" * 10**6
    for error in (mp.errors.InvalidInputError(text, text, text), mp.errors.FileFormatError(text, [text] * 100, text)):
        assert len(str(error)) < 3000
        assert error.allowed == text


def test_a_link_stays_and_its_file_is_replaced(motion, tmp_path):
    real, link = tmp_path / "real.csv", tmp_path / "link.csv"
    real.write_text("old")
    real.chmod(0o640)
    link.symlink_to(real)
    motion.to_csv(link)
    assert link.is_symlink() and real.stat().st_mode & 0o777 == 0o640
    assert len(mp.Trajectory.from_csv(real).t) == len(motion.t)
    beyond = tmp_path / "beyond.csv"
    beyond.symlink_to(tmp_path / "new.csv")
    motion.to_csv(beyond)
    assert beyond.is_symlink() and (tmp_path / "new.csv").is_file()
    assert not list(tmp_path.glob("*.part"))
    for name, other in (("first", "second"), ("second", "first")):
        (tmp_path / name).symlink_to(tmp_path / other)
    with pytest.raises(mp.errors.InvalidInputError, match="path that can be written"):
        motion.to_csv(tmp_path / "first")
    assert (tmp_path / "first").is_symlink()


def test_a_pipe_is_written_and_stays_a_pipe(motion, tmp_path):
    pipe, read = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()))
    reader.start()
    motion.to_csv(tmp_path / "same.csv")
    motion.to_csv(pipe)
    reader.join()
    assert stat.S_ISFIFO(pipe.stat().st_mode) and read == [(tmp_path / "same.csv").read_bytes()]


@pytest.mark.parametrize("umask", [0o022, 0o077, 0o002])
def test_a_new_file_has_the_permissions_that_the_umask_leaves(motion, tmp_path, umask):
    before = os.umask(umask)
    try:
        motion.to_csv(tmp_path / "motion.csv")
    finally:
        os.umask(before)
    assert (tmp_path / "motion.csv").stat().st_mode & 0o777 == 0o666 & ~umask


def test_a_comment_as_the_first_row_is_named(tmp_path):
    file = tmp_path / "noted.csv"
    file.write_text("# hi\ntime,q_a\n0,0\n1,1\n")
    with pytest.raises(mp.errors.FileFormatError, match="row 2, with 2 cells'; allowed: 1 cells, as in the first row.*: # hi"):
        mp.Trajectory.from_csv(file)


def test_a_cell_is_told_as_it_stands_in_the_file(tmp_path):
    file = tmp_path / "printed.csv"
    file.write_text("time,q_a\n0,np.float64(-0.6)\n1,1\n")
    with pytest.raises(mp.errors.FileFormatError, match=r"q_a: np\.float64\(-0\.6\)'; allowed: a number"):
        mp.Trajectory.from_csv(file)
