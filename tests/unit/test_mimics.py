"""Joints that mimic another, mostly locked ones: Pinocchio and MuJoCo, which move them, are the oracles."""

import itertools

import mujoco
import numpy as np
import pinocchio as pin
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp

LIMIT = '<limit lower="-9" upper="9" velocity="1" effort="1"/>'


def joint(name, parent, child, *, kind="revolute", axis="0 0 1", mimic="", xyz="0.1 0.2 0"):
    return (
        f'<link name="{child}"/><joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}" rpy="0.1 0.2 0.3"/><axis xyz="{axis}"/>{LIMIT if kind != "fixed" else ""}{mimic}</joint>'
    )


def follows(leader, multiplier=1.0, offset=0.0):
    return f'<mimic joint="{leader}" multiplier="{multiplier!r}" offset="{offset!r}"/>'


@pytest.fixture(scope="module")
def urdf(tmp_path_factory):
    def write(*joints):
        file = tmp_path_factory.mktemp("mimic") / "arm.urdf"
        file.write_text(f'<robot name="r"><link name="base"/>{"".join(joints)}</robot>')
        return file

    return write


def placements(model, q, names):
    data = model.createData()
    pin.framesForwardKinematics(model, data, np.asarray(q, float))
    return [data.oMf[model.getFrameId(name, pin.FrameType.BODY)].homogeneous for name in names]


KINDS = st.sampled_from(["revolute", "prismatic", "continuous"])
NUMBERS = st.floats(-3.0, 3.0)


@examples(60)
@given(
    leader=st.sampled_from(["revolute", "prismatic"]), follower=st.sampled_from(["revolute", "prismatic"]),
    multiplier=NUMBERS, offset=NUMBERS, value=NUMBERS, q=NUMBERS, axis=st.sampled_from(["1 0 0", "0 0.6 0.8"]),
)  # fmt: skip
def test_followers_of_a_locked_joint_are_where_pinocchio_has_them(urdf, leader, follower, multiplier, offset, value, q, axis):
    file = urdf(
        joint("turn", "base", "tip"),
        joint("lead", "tip", "a", kind=leader, axis=axis),
        joint("same", "tip", "b", kind=follower, mimic=follows("lead", multiplier, offset)),
        joint("more", "a", "c", kind=leader, axis=axis, mimic=follows("lead", -multiplier)),
    )
    robot = mp.Robot.from_urdf(file, tool="tip", locked={"lead": value})
    theirs = pin.buildModelFromUrdf(str(file), mimic=True)
    order = {theirs.names[i]: theirs.joints[i].idx_q for i in range(1, 3)}
    angles = np.zeros(2)
    angles[[order["turn"], order["lead"]]] = q, value
    for mine, expected in zip(placements(robot.model, [q], "abc"), placements(theirs, angles, "abc"), strict=True):
        np.testing.assert_allclose(mine, expected, atol=1e-12)


@pytest.mark.parametrize("order", list(itertools.permutations(range(4))))
def test_followers_of_followers_in_any_order(urdf, order):
    joints = [
        joint("lead", "tip", "a"),
        joint("two", "tip", "b", mimic=follows("lead", 2.0, 0.1)),
        joint("three", "tip", "c", mimic=follows("two", 3.0, 0.2)),
        joint("four", "tip", "d", kind="prismatic", mimic=follows("three", -1.0, 0.3)),
    ]
    file = urdf(joint("turn", "base", "tip"), *(joints[i] for i in order))
    locked = mp.Robot.from_urdf(file, tool="tip", locked={"lead": 0.5}).locked
    assert locked == pytest.approx({"lead": 0.5, "two": 1.1, "three": 3.5, "four": -3.2})
    moving = mp.Robot.from_urdf(file, tool="a")
    moved = {"lead": 0.5, "two": 1.1, "three": 3.5, "four": -3.2}
    assert moving.joint_names[-1] == "lead" or order[0] != 0
    assert {name: each.position(0.5) for name, each in moving.followers.items()} == pytest.approx(
        {name: value for name, value in moved.items() if name != "lead"}
    )


def test_both_fingers_of_the_panda_open():
    opened = mp.load_robot("panda", locked={"panda_finger_joint1": 0.03})
    left, right = placements(opened.model, opened.neutral, ["panda_leftfinger", "panda_rightfinger"])
    assert np.linalg.norm(left[:3, 3] - right[:3, 3]) == pytest.approx(0.06)


def test_a_follower_is_not_locked_against_its_leader(two_link_urdf):
    file = two_link_urdf()
    robot = mp.Robot.from_urdf(file, tool="tip", locked={"finger": 0.03, "mirror": 0.07})
    assert robot.locked == pytest.approx({"finger": 0.03, "mirror": 0.07})
    for locked, where in (
        ({"mirror": 0.02}, "0.01: .* as 2 \\* finger \\+ 0.01; lock finger, which is at 0"),
        ({"mirror": 0.07, "finger": 0.04}, "0.09"),
    ):
        with pytest.raises(mp.errors.InvalidInputError, match=rf"locked\['mirror'\]: got 0.0.; allowed: {where}"):
            mp.Robot.from_urdf(file, tool="tip", locked=locked)


def test_a_named_state_sets_the_leader_alone(two_link_urdf, tmp_path):
    srdf = tmp_path / "two.srdf"
    values = "".join(f'<joint name="{name}" value="{value}"/>' for name, value in (("finger", 0.04), ("mirror", 0.0)))
    srdf.write_text(f'<robot name="two"><group_state name="open" group="hand">{values}</group_state></robot>')
    robot = mp.Robot.from_urdf(two_link_urdf(), tool="tip", srdf=srdf)
    assert robot.locked == pytest.approx({"finger": 0.04, "mirror": 0.09})


def test_a_leader_that_is_fixed_is_at_zero(urdf):
    file = urdf(
        joint("turn", "base", "tip"),
        joint("rigid", "tip", "a", kind="fixed"),
        joint("f", "tip", "b", mimic=follows("rigid", 2.0, 0.4)),
    )
    assert mp.Robot.from_urdf(file, tool="tip").locked == {"f": 0.4}


# ---- leaders and followers that would be active


def test_a_follower_of_the_tool_is_held_with_its_leader(two_link_urdf):
    robot = mp.Robot.from_urdf(two_link_urdf(), tool="right", locked={"finger": 0.02})
    assert robot.joint_names == ("turn", "slide") and robot.locked == pytest.approx({"finger": 0.02, "mirror": 0.05})
    theirs = pin.buildModelFromUrdf(two_link_urdf(), mimic=True)
    [mine], [expected] = placements(robot.model, [0.3, 0.2], ["right"]), placements(theirs, [0.3, 0.2, 0.02], ["right"])
    np.testing.assert_allclose(mine, expected, atol=1e-14)
    np.testing.assert_allclose(robot.kinematics(mp.Task.position(), compiled=False).pose([0.3, 0.2]), expected, atol=1e-12)


def test_a_chain_with_leader_and_follower(urdf):
    """As in a parallelogram, whose last joint keeps the tool level."""
    file = urdf(
        joint("turn", "base", "a"),
        joint("lift", "a", "b", axis="0 1 0"),
        joint("level", "b", "tip", axis="0 1 0", mimic=follows("lift", -1.0)),
    )
    assert mp.load_robot(file).joint_names == ("turn", "lift")
    with pytest.raises(
        mp.errors.UnsupportedJointError, match=r"got 'level'.*mimics another, as -1 \* lift \+ 0.*name lift instead"
    ):
        mp.load_robot(file, joints=["turn", "level"])
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"locked\['level'\].*level mimics another, as -1 \* lift \+ 0; lock lift"
    ):
        mp.load_robot(file, locked={"level": 0.3})
    robot = mp.load_robot(file, joints=["turn"], locked={"lift": 0.7})
    [mine], [expected] = (
        placements(robot.model, [0.2], ["tip"]),
        placements(pin.buildModelFromUrdf(str(file), mimic=True), [0.2, 0.7], ["tip"]),
    )
    np.testing.assert_allclose(mine, expected, atol=1e-14)


def test_a_leader_beside_the_tool(two_link_urdf):
    both = mp.Robot.from_urdf(two_link_urdf(), tool="left")
    assert both.joint_names == ("turn", "slide", "finger") and list(both.followers) == ["mirror"]
    other = mp.Robot.from_urdf(two_link_urdf(), tool="right")
    assert other.joint_names == ("turn", "slide", "finger") and other.joints_of("right") == (0, 1, 2)
    theirs = pin.buildModelFromUrdf(str(two_link_urdf()), mimic=True)
    for each in (both, other):
        mine, expected = (placements(model, [0.3, 0.2, 0.02], ["left", "right"]) for model in (each.model, theirs))
        np.testing.assert_allclose(mine, expected, atol=1e-14)
    robot = mp.Robot.from_urdf(two_link_urdf(), tool="left", joints=["turn", "slide"], locked={"finger": 0.03})
    assert robot.locked == pytest.approx({"finger": 0.03, "mirror": 0.07})
    with pytest.raises(mp.errors.UnsupportedJointError, match="mirror mimics another, as 2 .*name finger instead"):
        mp.Robot.from_urdf(two_link_urdf(), tool="right", joints=["turn", "slide", "mirror"])


# ---- wrong files


@pytest.mark.parametrize(
    ("mimic", "message"),
    [
        ('<mimic joint="slide" multiplier="two"/>', "numbers in <mimic> of f"),
        ('<mimic joint="turn" multiplier="nan"/>', "finite numbers in <mimic> of f"),
        ('<mimic joint="turn" offset="1e999"/>', "finite numbers"),
        ('<mimic joint="trun"/>', "<mimic> of f: .*did you mean turn"),
        ("<mimic/>", "joints as leaders; <mimic> of f"),
        ('<mimic joint="f"/>', "f mimics f"),
        ('<mimic joint="g"/>', "f mimics f, g"),
        ('<mimic joint="drift"/>', "drift is floating"),
    ],
)  # fmt: skip
def test_wrong_mimics(urdf, mimic, message):
    drift = joint("drift", "tip", "d", kind="floating")
    file = urdf(
        joint("turn", "base", "tip"), joint("f", "tip", "a", mimic=mimic), joint("g", "tip", "b", mimic=follows("f")), drift
    )
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Robot.from_urdf(file, tool="tip")


# ---- MJCF


@pytest.fixture
def mjcf(tmp_path):
    """An arm with three fingers; what couples them is given."""

    def write(equality, refs=("", "", "")):
        fingers = "".join(
            f'<body name="{name}" pos="0 0 0.1"><joint name="{name}" type="{kind}" axis="0 1 0" range="-90 90" {ref}/>'
            '<geom type="sphere" size="0.05" pos="0.1 0 0"/></body>'
            for name, kind, ref in zip("abc", ("hinge", "slide", "hinge"), refs, strict=True)
        )
        file = tmp_path / "arm.xml"
        file.write_text(
            '<mujoco><worldbody><body name="arm"><joint name="turn" axis="0 0 1" range="-90 90"/><geom type="sphere" size="0.1"/>'
            f"{fingers}</body></worldbody><equality>{equality}</equality></mujoco>"
        )
        return file

    return write


@pytest.mark.slow
@pytest.mark.parametrize("refs", [("", "", ""), ('ref="20"', 'ref="0.3"', 'ref="-10"')])
@pytest.mark.parametrize(
    "equality",
    [
        '<joint joint1="b" joint2="a" polycoef="0.1 -0.5"/><joint joint1="c" joint2="a"/>',
        '<joint joint1="c" joint2="b" polycoef="0.2 2 0 0 0"/><joint joint1="b" joint2="a" polycoef="0.1"/>',
        '<joint joint1="b" polycoef="0.1 0 0 0 0"/><joint joint1="c" joint2="b"/>',
    ],
)
def test_couplings_of_mujoco(mjcf, equality, refs):
    """MuJoCo's own error of the couplings is zero where the followers are held."""
    file = mjcf(equality, refs)
    robot = mp.Robot.from_mjcf(file, tool="arm", velocity=1.0, locked={"a": 0.4})
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    for name, value in robot.locked.items():
        data.joint(name).qpos[:] = value
    data.joint("turn").qpos[:] = 0.3
    mujoco.mj_forward(model, data)
    coupled = data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY
    assert coupled.sum() == 2
    np.testing.assert_allclose(data.efc_pos[coupled], 0.0, atol=1e-12)
    for name, mine in zip("abc", placements(robot.model, [0.3], "abc"), strict=True):
        np.testing.assert_allclose(mine[:3, 3], data.body(name).xpos, atol=1e-9)
        np.testing.assert_allclose(mine[:3, :3], data.body(name).xmat.reshape(3, 3), atol=1e-9)
    assert robot.locked["b"] != 0.0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("equality", "message"),
    [
        ('<joint joint1="b" joint2="a" polycoef="0 1 0.5 0 0"/>', "straight line, .* that of b is '0 1 0.5 0 0'"),
        ('<joint joint1="b" joint2="a" polycoef="0 x"/>', "bad format in attribute 'polycoef'"),
        ('<joint joint1="bb" joint2="a"/>', "unknown element 'bb' in equality"),
        ('<joint joint1="b" joint2="a"/><joint joint1="a" joint2="b"/>', "joints that do not mimic themselves"),
    ],
)
def test_wrong_couplings(mjcf, equality, message):
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Robot.from_mjcf(mjcf(equality), tool="arm", velocity=1.0)


@pytest.mark.slow
def test_couplings_of_active_joints(mjcf):
    coupling = '<joint joint1="b" joint2="a" active="{}"/>'
    for tool in "ab":
        robot = mp.Robot.from_mjcf(mjcf(coupling.format("true")), tool=tool, velocity=1.0)
        assert robot.joint_names == ("turn", "a") and list(robot.followers) == ["b"]
        [mine] = placements(robot.model, [0.3, 0.4], ["b"])
        model = mujoco.MjModel.from_xml_path(str(mjcf(coupling.format("true"))))
        data = mujoco.MjData(model)
        data.qpos[:3] = 0.3, 0.4, 0.4
        mujoco.mj_forward(model, data)
        np.testing.assert_allclose(mine[:3, 3], data.body("b").xpos, atol=1e-9)
    assert mp.Robot.from_mjcf(mjcf(coupling.format("false")), tool="a", velocity=1.0).n == 2
    held = mp.Robot.from_mjcf(mjcf(coupling.format("true")), tool="b", velocity=1.0, locked={"a": 0.2})
    assert held.joint_names == ("turn",) and held.locked["b"] == 0.2
