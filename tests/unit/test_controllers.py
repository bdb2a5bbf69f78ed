"""Files for robot controllers: read back by parsers of their own, and what the formats do not allow."""

import csv
import re

import numpy as np
import pytest

import manipplan as mp

NUMBER = r"(-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)"


@pytest.fixture(scope="module")
def ur_motion(ur5):
    return mp.plan(ur5, ur5.neutral, ur5.neutral + 0.4).trajectory


@pytest.fixture(scope="module")
def panda_motion(panda):
    return mp.plan(panda, panda.neutral, panda.neutral + [0.4, 0.2, -0.3, 0.2, 0.3, 0.2, -0.4]).trajectory


def parsed(text):
    """Name, first check and servoj commands (positions, t) of a script; every line has to be understood."""
    lines = text.splitlines()
    assert lines[0].startswith("# ")
    name = re.fullmatch(r"def (\w+)\(\):", lines[1])[1]
    assert lines[2].strip() == "here = get_actual_joint_positions()"
    first = [float(each) for each in re.findall(rf"norm\(here\[\d\] - \({NUMBER}\)\) > 0\.01", lines[3])]
    assert [line.strip().split("(")[0] for line in lines[4:7]] == ["popup", "halt", "end"]
    commands = []
    for line in lines[7:-3]:
        inside, rest = re.fullmatch(r"  servoj\(\[(.*)\], (.*)\)", line).groups()
        options = dict(each.split("=") for each in rest.split(", "))
        commands.append([float(each) for each in inside.split(", ")] + [float(options["t"])])
    assert [line.strip() for line in lines[-3:]] == ["stopj(2.0)", "end", f"{name}()"]
    return name, np.array(first), np.array(commands)


@pytest.mark.parametrize("rate", [125, 500])
def test_urscript_is_the_motion(ur_motion, tmp_path, rate):
    ur_motion.to_urscript(tmp_path / "motion.script", rate=rate, name="wave")
    name, first, commands = parsed((tmp_path / "motion.script").read_text())
    assert name == "wave"
    np.testing.assert_array_equal(first, ur_motion.q[0])
    assert (commands[:, 6] == 1 / rate).all()
    times = np.minimum(np.arange(len(commands)) / rate, ur_motion.duration)
    np.testing.assert_allclose(commands[:, :6], ur_motion(times), atol=1e-12)
    np.testing.assert_array_equal(commands[-1, :6], ur_motion.q[-1])
    assert 0 <= (len(commands) - 1) / rate - ur_motion.duration < 1 / rate


def test_franka_table_is_the_motion(panda_motion, tmp_path):
    panda_motion.to_franka_csv(tmp_path / "motion.csv")
    with (tmp_path / "motion.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == ["time", *(f"joint{k}" for k in range(1, 8))]
    table = np.array([[float(value) for value in row.values()] for row in rows])
    np.testing.assert_allclose(np.diff(table[:, 0]), 1e-3, atol=1e-12)
    times = np.minimum(table[:, 0], panda_motion.duration)
    np.testing.assert_allclose(table[:, 1:], panda_motion(times), atol=1e-11)
    held = np.vstack([table[:1, 1:]] * 3 + [table[:, 1:]] + [table[-1:, 1:]] * 3)
    assert np.abs(np.diff(held, axis=0) * 1e3).max() <= 2.62
    assert np.abs(np.diff(held, n=3, axis=0) * 1e9).max() <= 1e4


def test_columns_are_found_by_their_names(ur_motion, panda_motion, tmp_path):
    for motion, write in ((ur_motion, "to_urscript"), (panda_motion, "to_franka_csv")):
        back = mp.Trajectory(
            t=motion.t,
            q=motion.q[:, ::-1],
            qd=motion.qd[:, ::-1],
            joint_names=[f"left_{each}" for each in motion.joint_names[::-1]],
        )
        getattr(motion, write)(tmp_path / "usual")
        getattr(back, write)(tmp_path / "reversed")
        assert (tmp_path / "usual").read_text() == (tmp_path / "reversed").read_text()
        other = mp.Trajectory(t=motion.t, q=motion.q, qd=motion.qd, joint_names=[f"j{k}" for k in range(motion.n)])
        with pytest.raises(mp.errors.InvalidInputError, match="names that end in"):
            getattr(other, write)(tmp_path / "other")


def test_limits_and_length_of_a_table(panda_motion, ur_motion, tmp_path):
    q = panda_motion.q[0] + np.outer([0, 1, 0], [0, 0, 0, 3.0, 0, 0, 0])
    high = mp.Trajectory(t=[0.0, 50.0, 100.0], q=q, qd=np.zeros((3, 7)), joint_names=panda_motion.joint_names)
    with pytest.raises(mp.errors.InvalidInputError, match=r"panda_joint4 at .* from -3\.0718 to -0\.0698 rad"):
        high.to_franka_csv(tmp_path / "motion")
    with pytest.raises(mp.errors.InvalidInputError, match="at most 600 s"):
        ur_motion.slower(10_000.0).to_urscript(tmp_path / "motion")
    fast = mp.Trajectory(t=ur_motion.t / 20, q=ur_motion.q, qd=ur_motion.qd * 20, joint_names=ur_motion.joint_names)
    with pytest.raises(mp.errors.InvalidInputError, match="a joint speed of"):
        fast.to_urscript(tmp_path / "motion")


def test_what_the_formats_do_not_allow(ur_motion, panda_motion, tmp_path):
    file = tmp_path / "motion"
    with pytest.raises(mp.errors.InvalidInputError, match="the joints of a UR arm: names that end in ...shoulder_pan_joint"):
        panda_motion.to_urscript(file)
    with pytest.raises(mp.errors.InvalidInputError, match="the joints of a Franka Panda"):
        ur_motion.to_franka_csv(file)
    for options, argument in (
        ({"rate": 250}, "rate"),
        ({"rate": True}, "rate"),
        ({"name": "a b"}, "name"),
        ({"name": "x():\n  halt"}, "name"),
        ({"gain": 5}, "gain"),
        ({"lookahead_time": 1.0}, "lookahead_time"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=argument):
            ur_motion.to_urscript(file, **options)
    moving = mp.Trajectory(t=ur_motion.t[:50], q=ur_motion.q[:50], qd=ur_motion.qd[:50], joint_names=ur_motion.joint_names)
    with pytest.raises(mp.errors.InvalidInputError, match=r"moves at .* at its end'; allowed: a motion from rest to rest"):
        moving.to_urscript(file)
    far = mp.Trajectory(t=ur_motion.t, q=ur_motion.q + 7.0, qd=ur_motion.qd, joint_names=ur_motion.joint_names)
    with pytest.raises(mp.errors.InvalidInputError, match="joint at .* from -6.2832 to 6.2832 rad"):
        far.to_urscript(file)
    fast = mp.Trajectory(t=panda_motion.t / 20, q=panda_motion.q, qd=panda_motion.qd * 20, joint_names=panda_motion.joint_names)
    with pytest.raises(mp.errors.InvalidInputError, match=r"a velocity of .* rad/s'; allowed: at most 2\.\d+ rad/s"):
        fast.to_franka_csv(file)
    line = panda_motion.q[0] + np.linspace(0, 1, 3)[:, None] * np.array([0.1, 0, 0, 0, 0, 0, 0])
    jump = mp.Trajectory(t=np.array([0.0, 0.1, 0.2]), q=line, qd=np.zeros((3, 7)), joint_names=panda_motion.joint_names)
    with pytest.raises(mp.errors.InvalidInputError, match=r"joint 1 at 0\.\d+ s\): got '(an acceleration|a jerk) of"):
        jump.to_franka_csv(file)
    assert not file.exists()
