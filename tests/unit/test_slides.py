"""Inverse kinematics of arms with slides of any length, at any place in the chain, and what happens when time runs out."""

import logging

import numpy as np
import pinocchio as pin
import pytest
from chains import chain_file

import manipplan as mp
from manipplan.ik.bridge import Bridge, span

#: Place of each joint of a seven-joint arm with a spherical shoulder, its turn and its limits.
ARM = (
    ("0 0 0.333", "0 0 0", -2.8973, 2.8973),
    ("0 0 0", "-1.57079632679 0 0", -1.7628, 1.7628),
    ("0 -0.316 0", "1.57079632679 0 0", -2.8973, 2.8973),
    ("0.0825 0 0", "1.57079632679 0 0", -3.0718, -0.0698),
    ("-0.0825 0.384 0", "-1.57079632679 0 0", -2.8973, 2.8973),
    ("0 0 0", "1.57079632679 0 0", -0.0175, 3.7525),
    ("0.088 0 0", "1.57079632679 0 0", -2.8973, 2.8973),
)
LENGTHS = (1.0, 5.0, 100.0, 1e6)
#: Joints put into the chain: where, of which kind, about or along which axis.
KINDS = {
    "rotating base, then slide": ((0, "prismatic", "1 0 0"), (0, "revolute", "0 0 1")),
    "slide first": ((0, "prismatic", "1 0 0"),),
    "slide, then rotating base": ((0, "revolute", "0 0 1"), (0, "prismatic", "1 0 0")),
    "two slides": ((0, "prismatic", "1 0 0"), (0, "prismatic", "0 1 0")),
    "turn, tilt, slide": ((0, "prismatic", "0 0 1"), (0, "revolute", "0 1 0"), (0, "revolute", "0 0 1")),
    "slide second": ((1, "prismatic", "1 0 0"),),
    "slide third": ((2, "prismatic", "1 0 0"),),
    "slide in the middle": ((4, "prismatic", "0 1 0"),),
    "slide at the end": ((7, "prismatic", "1 0 0"),),
}
#: Those without a closed form.
SEARCHED = ("slide second", "slide third")


@pytest.fixture(scope="module", autouse=True)
def no_compiler():
    """Every example is another arm: machine code of its forward kinematics would take a second each."""
    with pytest.MonkeyPatch.context() as patch:
        for module in ("support.compiler", "symbolic.machine_code"):
            patch.setattr(f"manipplan.{module}.find_compiler", lambda language="c": None)
        yield


def with_slides(folder, kind, length, parts=ARM):
    """An arm with further joints, all of them with limits of ± length, and the file."""
    joints = [("revolute", place, turn, "0 0 1", low, high) for place, turn, low, high in parts]
    for at, sort, axis in KINDS[kind]:
        joints.insert(at, (sort, "0 0 0.05", "0 0 0", axis, -length, length))
    file = chain_file(folder / "slides.urdf", joints, "0 0 0.107")
    return mp.Robot.from_urdf(file, tool="tool"), file


def own_pose(file, q):
    """Forward kinematics of the file by Pinocchio alone."""
    model = pin.buildModelFromUrdf(str(file))
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    return data.oMf[model.getFrameId("tool")].homogeneous


def near_or_far(robot, rng, near):
    """A random configuration, with slides within 2 m of their middle if `near`."""
    q = rng.uniform(*span(robot))
    slides = [k for k, kind in enumerate(robot.joint_types) if kind == "prismatic"]
    if near:
        q[slides] = rng.uniform(-np.minimum(robot.limits.upper[slides], 2.0), np.minimum(robot.limits.upper[slides], 2.0))
    return q


def sound(robot, file, found, pose):
    assert (robot.limits.outside(found.q) <= 0).all()
    allowed = 1e-10 * max(1.0, np.abs(pose[:3, 3]).max() / 1e4)
    for q in found.q[:: max(1, len(found) // 20)]:
        stopped = ((q == robot.limits.lower) | (q == robot.limits.upper)).any()
        assert np.abs(own_pose(file, q) - pose).max() <= (1e-6 if stopped else 2 * allowed)


@pytest.mark.slow
@pytest.mark.parametrize("near", [True, False])
@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in SEARCHED])
def test_poses_are_reached_however_long_the_slide_is(tmp_path, kind, length, near):
    robot, file = with_slides(tmp_path, kind, length)
    rng = np.random.default_rng(3)
    for _ in range(10):
        pose = own_pose(file, near_or_far(robot, rng, near))
        found = mp.inverse_kinematics(robot, pose)
        assert len(found)
        sound(robot, file, found, pose)
        assert (found.complete == "statistical") == (found.missing > 0)


@pytest.mark.slow
@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("kind", SEARCHED)
def test_poses_are_reached_without_a_closed_form(tmp_path, kind, length):
    robot, file = with_slides(tmp_path, kind, length)
    rng = np.random.default_rng(3)
    for k in range(6):
        pose = own_pose(file, near_or_far(robot, rng, k % 2 == 0))
        found = mp.inverse_kinematics(robot, pose, samples=8, time_limit=10.0)
        assert len(found) and found.complete == "statistical"
        sound(robot, file, found, pose)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["rotating base, then slide", "slide first", "two slides", "slide at the end"])
def test_a_step_longer_than_the_reach_is_not_called_complete(tmp_path, kind):
    robot, file = with_slides(tmp_path, kind, 5.0)
    rng = np.random.default_rng(0)
    for _ in range(5):
        pose = own_pose(file, near_or_far(robot, rng, near=False))
        coarse, fine = (mp.inverse_kinematics(robot, pose, samples=count) for count in (1, 12))
        assert coarse.complete == "statistical" and 0 < coarse.missing <= 1
        assert fine.complete == "to-resolution" and fine.missing == 0 and len(fine)


@pytest.mark.slow
def test_poses_apart_get_their_own_values(tmp_path):
    robot, file = with_slides(tmp_path, "rotating base, then slide", 1e3)
    rng = np.random.default_rng(1)
    poses = np.array([own_pose(file, near_or_far(robot, rng, k % 2 == 0)) for k in range(6)])
    found = mp.inverse_kinematics(robot, poses)
    for k, pose in enumerate(poses):
        alone = mp.inverse_kinematics(robot, pose)
        np.testing.assert_array_equal(found.for_pose(k), alone.q)
        assert len(alone)


@pytest.mark.slow
@pytest.mark.parametrize("behind", [2, 3])
def test_several_joints_are_held_behind_the_others(tmp_path, behind):
    """Their motions are undone from the tool inwards."""
    parts = (*ARM, ("0.05 0.1 0.2", "0.3 0.4 0.5", -2.0, 2.0), ("0.1 0 0.1", "0.9 0.1 0.4", -2.0, 2.0))[: 6 + behind]
    joints = [("revolute", place, turn, "0 0 1", low, high) for place, turn, low, high in parts]
    file = chain_file(tmp_path / "long.urdf", joints, "0 0 0.1")
    robot = mp.Robot.from_urdf(file, tool="tool")
    held = robot.joint_names[6:]
    rng = np.random.default_rng(0)
    for _ in range(20):
        q = robot.random_configuration(rng)
        found = mp.inverse_kinematics(robot, own_pose(file, q), q[6:], held=held)
        assert np.abs(found.q - q).max(axis=1).min() < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("length", [5.0, 1e6])
def test_a_rotating_base_on_a_long_slide(tmp_path, length):
    robot, file = with_slides(tmp_path, "rotating base, then slide", length)
    rng = np.random.default_rng(8)
    for near in (True, False):
        pose = own_pose(file, near_or_far(robot, rng, near))
        found = mp.inverse_kinematics(robot, pose)
        assert len(found) and found.complete == "to-resolution"
        sound(robot, file, found, pose)


@pytest.mark.slow
def test_a_pose_out_of_reach_has_no_solution(tmp_path):
    robot, file = with_slides(tmp_path, "slide first", 100.0)
    pose = own_pose(file, np.zeros(8))
    pose[:3, 3] = [40.0, 3.0, 0.0]
    assert not len(mp.inverse_kinematics(robot, pose))


@pytest.mark.slow
@pytest.mark.parametrize("kind", list(KINDS))
@pytest.mark.parametrize("whole", [True, False])
def test_boxes_hold_the_values_of_every_configuration(tmp_path, kind, whole):
    """The bound never excludes what reaches a pose: random configurations lie in a box of their own pose."""
    robot, file = with_slides(tmp_path, kind, 20.0)
    rng = np.random.default_rng(0)
    for trial in range(15):
        swept = sorted(rng.choice(robot.n, size=1 + trial % 4, replace=False).tolist())
        bridge = Bridge(robot, swept, whole_pose=whole)
        q = near_or_far(robot, rng, near=False)
        lower, upper = bridge.around(own_pose(file, q))
        assert ((lower <= q[swept] + 1e-9) & (q[swept] - 1e-9 <= upper)).all(axis=1).any()


@pytest.mark.slow
@pytest.mark.parametrize("turns", [3.0, 9.0, 318309.0])
def test_joints_of_many_turns_are_listed_once_per_turn_or_once(tmp_path, turns):
    lower = np.array([-turns * np.pi, -1.7, -2.8, -3.0, -2.8, 0.0, -2.8])
    robot = mp.load_robot("panda").with_limits(lower=lower, upper=-lower + [0, 0, 0, -3.05, 0, 3.7, 0])
    q = np.array([0.4, 0.3, 0.2, -1.5, 0.3, 1.8, 0.5])
    found = mp.inverse_kinematics(robot, robot.kinematics().pose(q), [q[6]])
    near = found.q[np.abs(found.q[:, 1:] - q[1:]).max(axis=1) < 1e-6]
    assert len(near) == (3 if turns == 3.0 else 1)  # ±3π hold three, ±9π and more count as one turn
    assert len(near) == len(np.unique(np.round(near[:, 0], 6)))


@pytest.fixture(scope="module")
def skew(tmp_path_factory):
    """A seven-joint arm without a closed form."""
    h = "1.5707963"
    parts = (
        ("0 0 0.1", "0 0 0", -2.94, 2.94),
        ("0.03 0 0.1", f"{h} 0 0", -2.5, 0.75),
        ("-0.03 0.17 0", f"-{h} 0 0", -2.94, 2.94),
        ("-0.04 0 0.08", f"{h} -{h} 0", -2.15, 1.39),
        ("0.041 0.09 0", f"-{h} 0 0", -5.06, 5.06),
        ("-0.027 0 0.17", f"{h} 0 0", -1.53, 2.4),
        ("0.027 0.03 0", f"-{h} 0 0", -3.99, 3.99),
    )
    joints = [("revolute", place, turn, "0 0 1", low, high) for place, turn, low, high in parts]
    return mp.Robot.from_urdf(chain_file(tmp_path_factory.mktemp("skew") / "skew.urdf", joints, "0 0 0.05"), tool="tool")


@pytest.mark.slow
def test_what_was_found_until_the_limit_is_returned_and_labelled(skew):
    pose = skew.kinematics().pose(np.array([0.3, -0.5, 0.4, -0.6, 0.5, 0.8, 0.2]))
    found = mp.inverse_kinematics(skew, pose, samples=4000, time_limit=1.0)
    whole = mp.inverse_kinematics(skew, pose, samples=12)
    assert found.complete == "statistical" and found.missing > 0.3
    assert len(np.unique(found.parameters)) < 2000 and len(whole)
    lower, upper = skew.limits.lower[2], skew.limits.upper[2]
    assert np.ptp(found.parameters) > 0.3 * (upper - lower)  # spread over the grid, not its first values


@pytest.mark.slow
def test_a_closed_form_ends_at_the_limit_too(panda):
    pose = panda.kinematics().pose(panda.neutral)
    found = mp.inverse_kinematics(panda, pose, samples=3_000_000, time_limit=1e-3)
    assert found.complete == "statistical" and 0.5 < found.missing < 1 and len(found)
    unlimited, generous = (mp.inverse_kinematics(panda, pose, time_limit=limit) for limit in (None, 60.0))
    np.testing.assert_array_equal(unlimited.q, generous.q)
    assert generous.complete == "to-resolution" and generous.missing == 0


@pytest.mark.parametrize("limit", [0, -1.0, np.nan, np.inf, "1", True, 10**400])
def test_a_wrong_time_limit_is_refused(panda, limit):
    with pytest.raises(mp.errors.InvalidInputError, match=r"^time_limit"):
        mp.inverse_kinematics(panda, panda.kinematics().pose(panda.neutral), time_limit=limit)


@pytest.mark.slow
def test_the_log_says_how_to_get_faster(skew, caplog, monkeypatch):
    monkeypatch.setattr("manipplan.ik.solutions.SLOW", 1e-4)
    pose = skew.kinematics().pose(np.array([0.3, -0.5, 0.4, -0.6, 0.5, 0.8, 0.2]))
    with caplog.at_level(logging.INFO):
        mp.inverse_kinematics(skew, pose, samples=2)
        assert not caplog.text  # the caller knows of it
        mp.inverse_kinematics(skew, pose)
    assert "samples=" in caplog.text and "time_limit=" in caplog.text


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"samples": 2**63}, "samples"),
        ({"samples": 10**5000}, "samples"),
        ({"samples": 10**9}, "samples"),
        ({"method": np.zeros(3)}, "method"),
        ({"parameters": [[1], [2, 3]]}, "parameters"),
        ({"turns": np.array([True, False])}, "turns"),
        ({"seed": 10**5000}, "seed"),
    ],
)
def test_odd_arguments_of_inverse_kinematics_are_refused(panda, options, named):
    with pytest.raises(mp.errors.InvalidInputError, match=rf"^{named}"):
        mp.inverse_kinematics(panda, panda.kinematics().pose(panda.neutral), **options)
