"""The tool of a description where none is named: unmoved ends, names, SRDF chains, fingers, jaws; real branches are refused."""

import logging
from itertools import pairwise

import pytest

import manipplan as mp


def joint(name, parent, child, kind="revolute", *, xyz=(0, 0, 0.2), axis=(0, 1, 0), lower=-2.0, upper=2.0, mimic=None):
    """A joint of a URDF, without its links."""
    limit = "" if kind in ("fixed", "continuous") else f'<limit lower="{lower}" upper="{upper}" velocity="1" effort="1"/>'
    axis_text = "" if kind == "fixed" else f'<axis xyz="{" ".join(map(str, axis))}"/>'
    follows = f'<mimic joint="{mimic}"/>' if mimic else ""
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{" ".join(map(str, xyz))}"/>{axis_text}{limit}{follows}</joint>'
    )


def arm(count=6, prefix=""):
    """A chain base, l1, ... of `count` joints, and the name of its last link."""
    links = ["base", *(f"{prefix}l{k}" for k in range(1, count + 1))]
    parts = [
        joint(f"{prefix}j{k}", a, b, axis=((0, 0, 1), (0, 1, 0))[k % 2]) for k, (a, b) in enumerate(pairwise(links), start=1)
    ]
    return parts, links[-1]


def fixed(parent, child, xyz=(0, 0, 0.05)):
    return joint(f"to_{child}", parent, child, "fixed", xyz=xyz)


@pytest.fixture
def load(tmp_path):
    """Load a robot of some joints, whose links are made for them."""

    def make(joints, srdf=None, **options):
        text = "".join(joints)
        links = {part.split('"')[0] for key in ('parent link="', 'child link="') for part in text.split(key)[1:]}
        file = tmp_path / "arm.urdf"
        file.write_text(f'<robot name="arm">{"".join(f"<link name={name!r}/>" for name in sorted(links))}{text}</robot>')
        if srdf is not None:
            (tmp_path / "arm.srdf").write_text(f'<robot name="arm">{srdf}</robot>')
            options["srdf"] = tmp_path / "arm.srdf"
        return mp.load_robot(file, **options)

    return make


def test_an_end_that_no_joint_moves_does_not_count(load, caplog):
    """Reproduction 5 in reviews of robots: ROS-Industrial's frame `base` on the base link."""
    parts, last = arm(3)
    with caplog.at_level(logging.INFO, "manipplan"):
        assert load([*parts, fixed("base", "world_frame")]).tool == last


@pytest.mark.parametrize(
    ("ends", "tool"),
    [
        (("flange", "tool0"), "tool0"),
        (("flange", "tcp"), "tcp"),
        (("ee_link", "welding_tcp", "flange"), "welding_tcp"),
        (("tcp_frame", "flange"), "tcp_frame"),
        (("ee_link", "robot_tool0"), "robot_tool0"),
        (("ee_link", "cover"), "ee_link"),
        (("camera", "gripper_frame_link"), "gripper_frame_link"),
    ],
)
def test_of_several_ends_on_one_body_the_name_decides_and_the_log_says_so(load, caplog, ends, tool):
    parts, last = arm(6)
    with caplog.at_level(logging.INFO, "manipplan"):
        robot = load([*parts, *(fixed(last, end) for end in ends)])
    assert robot.tool == tool
    assert robot.n == 6
    assert f"the tool is {tool}" in caplog.text


def test_ends_whose_names_do_not_decide_are_listed(load):
    parts, last = arm(6)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"several ends on one body: cover, plate\. Choose one, as in tool='cover'"
    ):
        load([*parts, fixed(last, "cover"), fixed(last, "plate")])
    with pytest.raises(mp.errors.InvalidInputError, match="left_tcp, right_tcp"):
        load([*parts, fixed(last, "left_tcp"), fixed(last, "right_tcp")])


def test_an_end_on_a_body_that_carries_further_joints_does_not_count(load):
    parts, last = arm(6)
    assert load([*parts, fixed("l3", "camera")]).tool == last


def test_two_arms_are_refused_with_the_call_that_works(load):
    left, left_end = arm(6, "left_")
    right, right_end = arm(6, "right_")
    head = [joint("pan", "base", "neck"), joint("tilt", "neck", "head")]
    with pytest.raises(mp.errors.InvalidInputError, match="several ends") as caught:
        load([*head, *left, *right])
    call = f"tool=['{left_end}', '{right_end}']"
    assert call in str(caught.value)
    assert "head" in str(caught.value)
    assert load([*head, *left, *right], tool=[left_end, right_end]).n == 12


def test_an_arm_and_a_head_are_refused(load):
    parts, last = arm(6)
    with pytest.raises(mp.errors.InvalidInputError, match=f"several ends: {last}, head"):
        load([*parts, joint("pan", "base", "neck"), joint("tilt", "neck", "head")])


def test_an_arm_beside_wheels_is_refused(load):
    """Wheels have no limits: they are no fingers."""
    parts, last = arm(3)
    wheels = [joint(f"wheel{k}", last, f"rim{k}", "continuous", xyz=(0.05, 0, 0)) for k in range(2)]
    with pytest.raises(mp.errors.InvalidInputError, match="several ends: rim0, rim1"):
        load([*parts, *wheels])


FINGERS = [
    joint("f1", "hand", "left", "prismatic", xyz=(0, 0, 0.05), lower=0, upper=0.04),
    joint("f2", "hand", "right", "prismatic", xyz=(0, 0, 0.05), lower=0, upper=0.04),
]


def test_the_body_that_carries_fingers_is_the_tool(load, caplog):
    parts, last = arm(6)
    with caplog.at_level(logging.INFO, "manipplan"):
        robot = load([*parts, fixed(last, "hand"), *FINGERS])
    assert (robot.tool, robot.n) == ("hand", 6)
    assert set(robot.locked) == {"f1", "f2"}
    assert "the body that carries the fingers; locked: f1, f2" in caplog.text


def test_a_frame_beside_the_fingers_is_the_tool(load):
    parts, last = arm(6)
    hand = [*parts, fixed(last, "hand"), *FINGERS]
    assert load([*hand, fixed("hand", "hand_tcp")]).tool == "hand_tcp"
    assert load([*hand, fixed("hand", "tip")]).tool == "tip"
    assert load([*hand, fixed("hand", "camera_link")]).tool == "hand"
    assert load([*hand, fixed(last, "tool0")]).tool == "hand", "tool0 is before the hand"


def test_knuckles_that_mimic_are_fingers(load):
    parts, last = arm(6)
    fingers = [
        joint("k1", last, "knuckle1", xyz=(0, 0, 0.05), upper=0.8, lower=0),
        joint("k2", last, "knuckle2", xyz=(0, 0, 0.05), upper=0.8, lower=0, mimic="k1"),
        joint("t1", "knuckle1", "pad1", xyz=(0, 0, 0.05), upper=0.8, lower=-0.8, mimic="k1"),
        joint("t2", "knuckle2", "pad2", xyz=(0, 0, 0.05), upper=0.8, lower=-0.8, mimic="k1"),
    ]
    robot = load([*parts, *fingers])
    assert (robot.tool, robot.n) == (last, 6)


def test_a_motor_beside_the_fingers_is_no_end(load):
    parts, last = arm(6)
    motor = joint("gripper", last, "prop", "continuous", xyz=(0, 0, 0.02))
    robot = load([*parts, fixed(last, "hand"), *FINGERS, motor])
    assert (robot.tool, robot.n) == (last, 6)
    with pytest.raises(mp.errors.InvalidInputError, match="several ends"):
        load([*parts, fixed(last, "hand"), *FINGERS, motor.replace('"gripper"', '"wheel"')])


def test_the_piston_of_a_balancer_is_no_end(load):
    parts, last = arm(6)
    piston = [
        joint("cylinder", "l1", "cylinder", xyz=(0.1, 0, 0), mimic="j2"),
        joint("piston", "l2", "piston", xyz=(0.1, 0, 0), mimic="j2"),
    ]
    robot = load([*parts, *piston])
    assert (robot.tool, robot.n, list(robot.followers)) == (last, 6, ["cylinder", "piston"])
    with pytest.raises(mp.errors.InvalidInputError, match="several ends: tool0, free"):
        load([*parts, fixed(last, "tool0"), joint("free", "l1", "free", xyz=(0.1, 0, 0))])


def test_a_long_finger_that_mimics_the_other_is_no_linkage(load):
    parts, last = arm(6)
    first = [joint(f"a{k}", last, f"u{k}", xyz=(0, 0, 0.3), mimic="a0" if k else None) for k in range(2)]
    second = [joint(f"b{k}", f"u{k}", f"finger{k}", xyz=(0, 0, 0.3), mimic="b0" if k else None) for k in range(2)]
    with pytest.raises(mp.errors.InvalidInputError, match="several ends: finger0, finger1"):
        load([*parts, *first, *second])


def test_the_only_frame_without_geometry_is_the_tool(load, tmp_path):
    parts, last = arm(3)
    text = [*parts, fixed(last, "plate"), fixed(last, "cover"), fixed(last, "camera_frame")]
    with pytest.raises(mp.errors.InvalidInputError, match="camera_frame, cover, plate"):
        load(text)
    file = tmp_path / "arm.urdf"
    shape = '<link name="cover"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>'
    file.write_text(file.read_text().replace("<link name='cover'/>", shape))
    assert mp.load_robot(file).tool == "plate"


@pytest.mark.parametrize(
    "branch",
    [
        {"xyz": (0, 0, 0.5)},  # its second link is far away: too long for a finger
        {"kind": "continuous"},
    ],
)
def test_short_branches_that_are_no_fingers_are_refused(load, branch):
    parts, last = arm(6)
    first = [joint(f"a{k}", last, f"u{k}", xyz=(0, 0, 0.1)) for k in range(2)]
    second = [joint(f"b{k}", f"u{k}", f"v{k}", **branch) for k in range(2)]
    with pytest.raises(mp.errors.InvalidInputError, match="several ends: v0, v1"):
        load([*parts, *first, *second])


def test_branches_of_three_joints_are_no_fingers(load):
    parts, last = arm(3)
    chains = []
    for k in range(2):
        names = [last, *(f"c{k}{i}" for i in range(3))]
        chains += [joint(f"t{k}{i}", a, b, xyz=(0, 0, 0.03)) for i, (a, b) in enumerate(pairwise(names))]
    with pytest.raises(mp.errors.InvalidInputError, match="several ends: c02, c12"):
        load([*parts, *chains])


def test_two_short_branches_on_a_torso_are_arms(load):
    """A body that one joint moves carries no hand."""
    torso = [joint("waist", "base", "torso")]
    arms = [joint(f"a{k}", "torso", f"u{k}", xyz=(0, 0.03, 0)) for k in range(2)]
    with pytest.raises(mp.errors.InvalidInputError, match="several ends: u0, u1"):
        load([*torso, *arms])


@pytest.mark.parametrize(
    ("name", "link", "before"),
    [
        ("gripper", "jaw", "l5"),
        ("j6", "moving_jaw", "l5"),
        ("Jaw", "Moving_Jaw", "l5"),
        ("jointGripper", "mover", "l5"),
        ("j6", "gripper_mover", "gripper_stator"),
        ("finger_joint", "l6", "l5"),
    ],
)
def test_a_jaw_is_no_joint_of_the_arm(load, name, link, before):
    parts, last = arm(5)
    parts = [part.replace(f'"{last}"', f'"{before}"') for part in parts]
    robot = load([*parts, joint(name, before, link, xyz=(0.02, 0, 0.05), lower=-0.2, upper=1.7)])
    assert (robot.tool, robot.n) == (before, 5)
    assert set(robot.locked) == {name}


@pytest.mark.parametrize(
    ("name", "link", "options"),
    [
        ("wrist_roll", "gripper", {}),  # the last joint of an SO-ARM100 without its jaw
        ("gripper_roll_joint", "hand", {}),
        ("j6", "gripper", {}),  # a gripper without moving parts on a last joint
        ("joint_6", "link_6", {"upper": 1.5, "lower": -1.5}),
        ("gripper", "jaw", {"lower": -3.0, "upper": 3.0}),  # turns too far for a jaw
        ("gripper", "jaw", {"xyz": (0, 0, 0.2), "far": 0.6}),  # reaches too far
    ],
)
def test_a_last_wrist_joint_is_never_a_jaw(load, name, link, options):
    options = dict(options)
    far = options.pop("far", None)
    parts, last = arm(5)
    tail = [fixed(link, "end", (0, 0, far))] if far else []
    robot = load([*parts, joint(name, last, link, **{"lower": -1.5, "upper": 1.5, **options}), *tail])
    assert robot.n == 6
    assert not robot.locked


def test_a_tool_frame_on_the_last_link_is_no_jaw(load):
    parts, last = arm(5)
    jaw = joint("gripper_joint", last, "l6", xyz=(0, 0, 0.05), lower=-1, upper=1)
    robot = load([*parts, jaw, fixed("l6", "tcp")])
    assert (robot.tool, robot.n) == ("tcp", 6)


def test_the_finger_can_still_be_named(load):
    parts, last = arm(5)
    jaw = joint("gripper", last, "jaw", xyz=(0.02, 0, 0.05), lower=-0.2, upper=1.7)
    assert load([*parts, jaw], tool="jaw").n == 6


CHAIN = '<group name="{0}"><chain base_link="{1}" tip_link="{2}"/></group>'


def test_the_tip_of_the_only_chain_of_an_srdf_is_the_tool(load):
    parts, last = arm(6)
    ends = [*parts, fixed(last, "cover"), fixed(last, "plate")]
    assert load(ends, CHAIN.format("arm", "base", "plate")).tool == "plate"
    twice = CHAIN.format("arm", "base", "plate") + CHAIN.format("arm2", "l1", "plate")
    assert load(ends, twice).tool == "plate"
    mount = CHAIN.format("mount", last, "cover")  # moves nothing
    assert load(ends, CHAIN.format("arm", "base", "plate") + mount).tool == "plate"
    hand = [*parts, fixed(last, "hand"), *FINGERS]
    assert load(hand, CHAIN.format("arm", "base", last) + CHAIN.format("hand", "hand", "left")).tool == last


def test_an_end_effector_comes_before_chains(load):
    parts, last = arm(6)
    effector = '<end_effector name="hand" parent_link="l6" group="hand"/>'
    assert load([*parts, fixed(last, "plate")], CHAIN.format("arm", "base", "plate") + effector).tool == "l6"


def test_chains_to_several_tips_are_listed(load):
    left, left_end = arm(6, "left_")
    right, right_end = arm(6, "right_")
    srdf = CHAIN.format("left", "base", left_end) + CHAIN.format("right", "base", right_end)
    with pytest.raises(
        mp.errors.InvalidInputError, match=rf"several tips: {left_end}, {right_end}.*tool=\['{left_end}', '{right_end}'\]"
    ):
        load([*left, *right], srdf)


def test_a_chain_to_an_unknown_link_is_refused(load):
    parts, _ = arm(3)
    with pytest.raises(mp.errors.UnknownNameError, match="'plato'"):
        load(parts, CHAIN.format("arm", "base", "plato"))


MJCF = """<mujoco><compiler angle="radian"/><worldbody><body name="base">
 <body name="l1" pos="0 0 .2"><joint name="j1" axis="0 0 1" range="-2 2"/><geom size=".03"/>
 <body name="l2" pos="0 0 .2"><joint name="j2" axis="0 1 0" range="-2 2"/><geom size=".03"/>
 <body name="l3" pos="0 0 .2"><joint name="j3" axis="0 1 0" range="-2 2"/><geom size=".03"/>{}</body></body></body></body>
</worldbody></mujoco>"""
FINGER = '<body name="{0}" pos="0 {1} .05"><joint name="{0}_joint" type="slide" axis="0 1 0" range="0 .04"/><geom size=".01"/></body>'
JAW = '<body name="jaw" pos="0 .02 .05"><joint name="grip" axis="1 0 0" range="-.2 1.5"/><geom size=".01"/></body>'


@pytest.mark.slow
@pytest.mark.parametrize(
    ("hand", "tool"),
    [
        (
            f'<body name="hand" pos="0 0 .05"><geom size=".02"/>{FINGER.format("a", 0.02)}{FINGER.format("b", -0.02)}</body>',
            "hand",
        ),
        (FINGER.format("a", 0.02) + FINGER.format("b", -0.02), "l3"),
        (JAW, "l3"),
    ],
)
def test_the_rule_is_that_of_mjcf_too(tmp_path, hand, tool):
    (tmp_path / "arm.xml").write_text(MJCF.format(hand))
    robot = mp.load_robot(tmp_path / "arm.xml", velocity=1.0)
    assert (robot.tool, robot.n) == (tool, 3)


@pytest.mark.parametrize(
    ("file", "tool", "count"),
    [
        ("panda_description/urdf/panda.urdf", "panda_hand_tcp", 7),
        ("so_arm_description/urdf/so100.urdf", "gripper", 5),
        ("so_arm_description/urdf/so101.urdf", "gripper_frame_link", 5),
        ("z1_description/urdf/z1.urdf", "gripperStator", 6),
        ("ur_description/urdf/ur5_robot.urdf", "tool0", 6),
        ("kinova_description/robots/kinova.urdf", "j2s6s200_end_effector", 6),
        ("bravo7_description/urdf/bravo7_gripper.urdf", "bravo_finger_jaws_base_link", 6),
    ],
)
def test_described_arms_load_without_arguments(file, tool, count):
    from manipplan.robots.catalog import _descriptions

    robot = mp.load_robot(_descriptions() / file, meshes=False)
    assert (robot.tool, robot.n) == (tool, count)
