"""YAML files that are not what they should be: scenes and ROS's trajectories."""

import time

import pytest

import manipplan as mp

POINTS = "joint_names: [a]\npoints:\n- {positions: [0], velocities: [0], time_from_start: {sec: 0, nanosec: 0}}\n"
BOMB = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n" + "".join(
    f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]\n" for i in range(1, 10)
)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("obstacles: [{shape: plane}]\nobstacles: []", "the key 'obstacles' of line 1 is repeated, in line 2"),
        ("obstacles:\n- shape: sphere\n  radius: 1\n  radius: 2\n", "the key 'radius' of line 3 is repeated, in line 4"),
        ("obstacles:\n- {shape: sphere, radius: 1, 'radius': 2}", "the key 'radius' of line 2"),
        ("obstacles:\n- {shape: sphere, radius: 1, position: &p [*p, 1, 2]}", r"the value of \*p contains itself, in line 2"),
        ("obstacles: " + "[" * 100_000, "values nested more than 100 deep"),
        ("obstacles:\n" + "- " * 100_000, "values nested more than 100 deep"),
        (BOMB, "more than 500,000 values"),
        ("obstacles: [{shape: sphere, radius: 2001-13-45}]", "ambiguous"),
        ("obstacles: [{shape: sphere, radius: " + "9" * 5000 + "}]", "4300 digits"),
        ("obstacles: [!!int '']", "YAML"),
        ("obstacles: [!!timestamp a]", "YAML"),
        ("obstacles: [!!bool perhaps]", "YAML"),
        ("obstacles: [!!python/object:os.system a]", "could not determine a constructor"),
        ("obstacles: [{{a: b}: c}]", "unhashable key"),
    ],
)
def test_yaml_that_is_refused(tmp_path, text, message):
    file = tmp_path / "file.yaml"
    file.write_text(text)
    for read in (mp.Scene.from_yaml, mp.Trajectory.from_ros):
        began = time.monotonic()
        with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
            read(file)
        assert len(str(caught.value)) < 1000
        assert time.monotonic() - began < 20


def test_yaml_is_utf_8(tmp_path):
    file = tmp_path / "file.yaml"
    file.write_text("obstacles: [{shape: plane, name: plancher_é}]", encoding="utf-8")
    assert mp.Scene.from_yaml(file).names == ("plancher_é",)
    file.write_text("obstacles: [{shape: plane, name: plancher_é}]", encoding="latin-1")
    with pytest.raises(mp.errors.FileFormatError, match="YAML"):
        mp.Scene.from_yaml(file)


def test_anchors_and_merged_keys_are_read(tmp_path):
    file = tmp_path / "scene.yaml"
    file.write_text(
        "obstacles:\n- &a {shape: sphere, radius: 1, position: &p [0, 1, 2]}\n- &b {<<: *a, radius: 2}\n"
        "- {<<: *b, name: last}\n- {shape: box, size: [1, 1, 1], position: *p}\n"
    )
    obstacles = mp.Scene.from_yaml(file).obstacles
    assert [each.radius for each in obstacles[:3]] == [1, 2, 2]
    assert [each.position.tolist() for each in obstacles] == [[0, 1, 2]] * 4


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("rotation: [[1, 2], [3]]", r"rotation\): got \[\[1, 2\], \[3\]\]; allowed: real numbers"),
        ("position: [1, 2, " + "9" * 4000 + "]", r"position\): got .*real numbers"),
        ("position: [" + "1," * 300_000 + "]", r"not \(300000,\)"),
        ("position: 2001-11-05", "ambiguous"),
    ],
)
def test_wrong_values_of_an_obstacle(tmp_path, text, message):
    file = tmp_path / "scene.yaml"
    file.write_text(f"obstacles: [{{shape: sphere, radius: 1, {text}}}]")
    with pytest.raises(mp.errors.InvalidInputError, match=message) as caught:
        mp.Scene.from_yaml(file)
    assert len(str(caught.value)) < 500


@pytest.mark.parametrize("value", ['"a"', "1.5", "true", "-1", "99999999999", "[1]"])
@pytest.mark.parametrize("key", ["sec", "nanosec"])
def test_times_of_ros_are_whole_numbers(tmp_path, key, value):
    file = tmp_path / "motion.yaml"
    stamp = {"sec": "1", "nanosec": "0", key: value}
    stamp = ", ".join(f"{name}: {number}" for name, number in stamp.items())
    file.write_text(f"{POINTS}- {{positions: [0], velocities: [0], time_from_start: {{{stamp}}}}}\n")
    with pytest.raises(mp.errors.FileFormatError, match=rf"time_from_start\.{key}: got .*whole number"):
        mp.Trajectory.from_ros(file)
