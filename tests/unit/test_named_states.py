"""Named states of an SRDF, read, used from Python and shell, and written for Pinocchio's own reader."""

import copy
import json
import pickle

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from manipplan.cli import main

SRDF = """<robot name="two">
  <end_effector name="hand" parent_link="tip" group="arm"/>
  <group_state name="home" group="gripper"><joint name="finger" value="0.02"/></group_state>
  <group_state name="home" group="arm"><joint name="turn" value="0.5"/><joint name="slide" value="0.1"/></group_state>
  <group_state name="ready" group="arm"><joint name="slide" value="0.3"/><joint name="turn" value="-1.5"/></group_state>
  <group_state name="half" group="arm"><joint name="turn" value="1"/></group_state>
  <group_state name="far" group="arm"><joint name="turn" value="9"/><joint name="slide" value="0.1"/></group_state>
</robot>"""


@pytest.fixture
def arm(two_link_urdf, tmp_path):
    (tmp_path / "arm.srdf").write_text(SRDF)
    return mp.Robot.from_urdf(two_link_urdf(), srdf=tmp_path / "arm.srdf")


def test_states_of_all_active_joints_are_known(arm):
    assert list(arm.states) == ["home", "ready", "far"]
    np.testing.assert_array_equal(arm.states["ready"], [-1.5, 0.3])
    np.testing.assert_array_equal(arm.states["home"], [0.5, 0.1])  # not that of the gripper
    with pytest.raises(ValueError, match="read-only"):
        arm.states["home"][0] = 1.0


def test_another_name_is_told_with_the_nearest(arm, planar):
    with pytest.raises(mp.errors.UnknownNameError, match=r"named state: got 'redy'; allowed: did you mean ready"):
        arm.states["redy"]
    with pytest.raises(mp.errors.UnknownNameError, match="read without an SRDF"):
        planar.states["home"]
    assert "redy" not in arm.states
    assert arm.states.get("redy") is None


def test_states_follow_the_arm(arm):
    for other in (arm.with_limits(velocity=1.0), copy.deepcopy(arm), pickle.loads(pickle.dumps(arm)), arm.source.load()):
        assert list(other.states) == ["home", "ready", "far"]
        np.testing.assert_array_equal(other.states["ready"], [-1.5, 0.3])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "states"),
    [
        ("panda", ["default"]),
        ("xarm7", ["home", "hold-up"]),
        ("z1", ["home", "arm_up"]),
        ("talos_right_arm", ["half_sitting"]),
        ("kinova", ["arm_up"]),
        ("tiago", []),
        ("ur5", []),
    ],
)
def test_states_are_those_pinocchio_reads(name, states):
    robot = mp.load_robot(name)
    assert list(robot.states) == states
    if not states:
        return
    from manipplan.robots.catalog import CATALOG, _descriptions

    whole = pin.buildModelFromUrdf(str(robot.source.file))
    pin.loadReferenceConfigurations(whole, str(_descriptions() / CATALOG[name].folder / CATALOG[name].srdf), False)
    for state in states:
        q = whole.referenceConfigurations[state]
        for joint, value in zip(robot.joint_names, robot.states[state], strict=True):
            at = whole.joints[whole.getJointId(joint)]
            theirs = q[at.idx_q] if at.nq == 1 else np.arctan2(q[at.idx_q + 1], q[at.idx_q])
            assert np.cos(theirs - value) == pytest.approx(1.0, abs=1e-12) if at.nq == 2 else theirs == value


@pytest.mark.slow
def test_a_plan_from_a_named_state(panda, tmp_path, capsys):
    """From the state of the catalogue's SRDF to one of a file, by the command."""
    goal = panda.states["default"] + 0.2
    panda.to_srdf(tmp_path / "own.srdf", {**panda.states, "aside": goal})
    names = ["--start", "default", "--goal", "aside", "--srdf", str(tmp_path / "own.srdf")]
    code = main(["plan", "panda", *names, "--out", str(tmp_path / "out")])
    assert code == 0, capsys.readouterr().err
    trajectory = mp.Trajectory.from_json(tmp_path / "out" / "trajectory.json")
    np.testing.assert_allclose(trajectory.q[[0, -1]], [panda.states["default"], goal], atol=1e-9)
    again = mp.Plan.load(tmp_path / "out")
    np.testing.assert_array_equal(again.robot.states["aside"], goal)
    assert json.loads((tmp_path / "out" / "plan.json").read_text())["robot"]["source"]["name"] == "panda"


@pytest.mark.parametrize(
    ("robot", "start", "message"),
    [
        ("panda", ["defalt"], "start: got 'defalt'; allowed: did you mean default"),
        ("panda", ["0", "x"], "start: got '0 x'; allowed: one number per joint, or the name of one state"),
        ("ur5", ["home"], "start: got 'home'; allowed: one number per joint: the robot has no named states"),
        ("panda", ["nan"], "start"),
    ],
)
def test_wrong_names_in_the_shell(tmp_path, capsys, robot, start, message):
    assert main(["plan", robot, "--start", *start, "--goal", "default", "--out", str(tmp_path)]) == 2
    assert message in capsys.readouterr().err


def test_the_srdf_that_is_written_is_read_by_pinocchio(panda, tmp_path, rng):
    file = tmp_path / "panda.srdf"
    states = {"low": panda.random_configuration(rng), "high & <up>": panda.random_configuration(rng)}
    panda.to_srdf(file, states, group="panda_arm")
    whole = pin.buildModelFromUrdf(str(panda.source.file))
    pin.loadReferenceConfigurations(whole, str(file), False)
    for name, q in states.items():
        for joint, value in zip(panda.joint_names, q, strict=True):
            assert whole.referenceConfigurations[name][whole.joints[whole.getJointId(joint)].idx_q] == value
    again = mp.load_robot("panda", srdf=file)
    assert list(again.states) == list(states)
    assert again.disabled_pairs == panda.disabled_pairs
    assert again.joint_names == panda.joint_names


def test_disabled_pairs_are_those_of_the_first_file(panda, tmp_path):
    """Pinocchio removes the same pairs by the file that we wrote as by the maker's."""
    from manipplan.robots.catalog import CATALOG, _descriptions

    folder = _descriptions() / "panda_description"
    panda.to_srdf(tmp_path / "panda.srdf")
    whole = pin.buildModelFromUrdf(str(panda.source.file))
    left = []
    for srdf in (folder / CATALOG["panda"].srdf, tmp_path / "panda.srdf"):
        geometry = pin.buildGeomFromUrdf(
            whole, str(panda.source.file), pin.GeometryType.COLLISION, package_dirs=[str(folder.parents[2])]
        )
        geometry.addAllCollisionPairs()
        pin.removeCollisionPairs(whole, geometry, str(srdf))
        left.append([(pair.first, pair.second) for pair in geometry.collisionPairs])
    assert left[0] == left[1]


def test_what_cannot_be_written_is_told(panda, tmp_path):
    for states, message in (
        ({"a": [0.0]}, r"states\['a'\]"),
        ({"a": [np.nan] * 7}, r"states\['a'\]"),
        ([1], "states"),
        ({"": [0.0] * 7}, "states"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=message):
            panda.to_srdf(tmp_path / "x.srdf", states)
    with pytest.raises(mp.errors.InvalidInputError, match="group"):
        panda.to_srdf(tmp_path / "x.srdf", group="")
    assert not list(tmp_path.iterdir())


def test_a_state_without_a_name_is_told(two_link_urdf, tmp_path):
    file = tmp_path / "arm.srdf"
    file.write_text('<robot name="two"><group_state group="arm"><joint name="turn" value="0"/></group_state></robot>')
    with pytest.raises(mp.errors.FileFormatError, match="a name for every <group_state>"):
        mp.Robot.from_urdf(two_link_urdf(), tool="tip", srdf=file)
