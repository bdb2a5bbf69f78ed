"""Origins of joints in millimetres: refused by joint and value, while long rails and cranes load."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import manipplan as mp

LENGTHS = st.lists(st.floats(0.05, 1.5), min_size=4, max_size=8)


def write(file, origins, *, stand="0 0 0", slide=None, body=""):
    """A URDF of revolute joints j1, j2, ... with these origins; the first slides 0 to `slide` metres."""
    parts = ['<robot name="a"><link name="world"/><link name="l0"/><joint name="stand" type="fixed"><parent link="world"/>']
    parts.append(f'<child link="l0"/><origin xyz="{stand}"/></joint>')
    for k, origin in enumerate(origins, start=1):
        slides = k == 1 and slide is not None
        parts.append(
            f'<link name="l{k}">{body}</link><joint name="j{k}" type="{"prismatic" if slides else "revolute"}">'
            f'<parent link="l{k - 1}"/><child link="l{k}"/><origin xyz="{origin}"/><axis xyz="0 {k % 2} {1 - k % 2}"/>'
            f'<limit lower="0" upper="{slide if slides else 2}" velocity="1" effort="1"/></joint>'
        )
    file.write_text("".join(parts) + "</robot>")
    return file


@pytest.mark.parametrize(
    ("origins", "options", "message"),
    [
        (
            ["0 0 333", "0 0 .3", "0 0 .4"],
            {},
            "within 10.5 m of their parents; joint j1 has link l1 at 0 0 333.*333 looks like",
        ),
        (["0 0 .3", "88 0 0", "0 0 .3"], {}, "within 9 m.*; joint j2 has link l2 at 88 0 0 in its parent"),
        (["0 0 .1", ".1 0 0", "0 6 0"], {}, "within 5 m.*; joint j3 has link l3 at 0 6 0"),
        (["0 0 333"], {}, "within 100 m.*joint j1"),
        (["0 0 45", "0 65 0", "0 0 95", "-8 0 0"], {}, "an arm of at most 100 m, not 213 m; joint j3 .* at 0 0 95"),
        (["0 0 .3", "0 0 .3"], {"stand": "0 0 -800"}, "joint stand has link l0 at 0 0 -800 .* 800 looks like millimetres"),
        (["333 0 0", "0 0 .3"], {"slide": 40}, "within 40 m.*joint j1"),
    ],
)
def test_an_origin_in_millimetres_is_refused(tmp_path, origins, options, message):
    file = write(tmp_path / "arm.urdf", origins, **options)
    with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
        mp.Robot.from_urdf(file)
    assert str(file) in str(caught.value)


@pytest.mark.parametrize(
    ("origins", "options"),
    [
        (["0 0 .3", "0 0 .3"], {"stand": "60 20 0"}),  # where the robot stands
        (["20 0 0", "0 35 0", "0 0 .3"], {"slide": 40}),  # a bridge crane
        (["0 0 2", "0 12 0", "0 0 12", "0 0 12", "0 0 8"], {}),  # a concrete pump
        (["0 0 .2"] + ["0 0 4.9"] * 30, {}),  # a snake of 147 m
        (["0 0 2", "0 0 15", "0 0 .3"], {"body": '<collision><geometry><box size="1 1 16"/></geometry></collision>'}),
        (["0 0 0", "0 0 0"], {}),
    ],
)
def test_large_robots_load(tmp_path, origins, options):
    assert mp.Robot.from_urdf(write(tmp_path / "arm.urdf", origins, **options)).n == len(origins)


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(lengths=LENGTHS, number=st.integers(0, 7))
def test_one_origin_in_millimetres_among_others_in_metres(tmp_path_factory, lengths, number):
    file, wrong = tmp_path_factory.mktemp("arm") / "arm.urdf", number % len(lengths)
    write(file, [f"0 0 {length!r}" for length in lengths])
    assert mp.Robot.from_urdf(file).n == len(lengths)
    lengths[wrong] *= 1000
    write(file, [f"0 0 {length!r}" for length in lengths])
    with pytest.raises(mp.errors.FileFormatError, match=f"joint j{wrong + 1} has link l{wrong + 1} at 0 0"):
        mp.Robot.from_urdf(file)


@pytest.mark.slow
def test_an_mjcf_body_in_millimetres_is_refused(tmp_path):
    pytest.importorskip("mujoco")
    file = tmp_path / "arm.xml"
    text = (
        '<mujoco><worldbody><body name="stand" pos="30 0 0"><geom size=".1"/><body name="a" pos="0 0 .3"><joint name="j"/>'
        '<geom size=".1"/><body name="b" pos="{}"><joint name="k" axis="0 1 0"/><geom size=".1"/>'
        '<body name="tcp" pos="0 0 .1"/></body></body></body></worldbody></mujoco>'
    )
    file.write_text(text.format("0 0 .3"))
    assert mp.Robot.from_mjcf(file).n == 2
    file.write_text(text.format("0 0 316"))
    with pytest.raises(mp.errors.FileFormatError, match="joint k has link b at 0 0 316"):
        mp.Robot.from_mjcf(file)
