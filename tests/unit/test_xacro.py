"""Robots from xacro files: what they expand to, what an untrusted file may do, and every wrong input."""

import json
import logging
import math
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.plans.archive import robot_data, robot_of
from manipplan.robots import urdf_files
from manipplan.robots.packages import PackageFolders
from manipplan.robots.xacro_child import RefusedError, evaluate
from manipplan.viz.viewer.bodies import visual_geometry

HEAD = '<robot name="two" xmlns:xacro="http://www.ros.org/wiki/xacro">'
#: Two joints; the length and the prefix are arguments, the limits come from a YAML file of the package.
ARM = """
<xacro:arg name="prefix" default=""/><xacro:arg name="length" default="0.5"/><xacro:arg name="hand" default="false"/>
<xacro:property name="limits" value="${xacro.load_yaml('$(find arm_description)/config/limits.yaml')}"/>
<xacro:property name="names" value="${['turn', 'lift']}"/>
<xacro:include filename="inc/joint.xacro"/>
<link name="$(arg prefix)base"/>
<xacro:joint i="0" parent="$(arg prefix)base" x="0"/>
<xacro:joint i="1" parent="$(arg prefix)link0" x="${$(arg length) * 2 / sqrt(4)}"/>
<xacro:if value="$(arg hand)"><xacro:include filename="$(find hand_description)/urdf/hand.xacro"/></xacro:if>
"""
JOINT = """
<xacro:macro name="joint" params="i parent x axis:='0 0 1'"><link name="$(arg prefix)link${i}"><collision><geometry>
<mesh filename="package://arm_description/meshes/m.obj"/></geometry></collision><visual><geometry>
<mesh filename="package://arm_description/meshes/m.obj"/></geometry></visual></link>
<joint name="${names[i]}" type="revolute"><parent link="${parent}"/><child link="$(arg prefix)link${i}"/><origin xyz="${x} 0 0"/>
<axis xyz="${axis if i == 0 else '0 1 0'}"/>
<limit lower="${-pi}" upper="${limits[names[i]].upper}" velocity="${limits[names[i]]['velocity']}" effort="10"/></joint></xacro:macro>
"""
HAND = """
<xacro:arg name="fingers" default="1"/><link name="hand"/>
<joint name="wrist" type="fixed"><parent link="$(arg prefix)link1"/><child link="hand"/><origin xyz="0.25 0 0"/></joint>
"""
LIMITS = "turn: {upper: !degrees 90, velocity: 2}\nlift: {upper: 1.5, velocity: 3.0}\n"
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


@pytest.fixture
def arm(tmp_path):
    """A package as ROS has it; the function writes the main file with further elements and returns it."""
    package = tmp_path / "work" / "arm"
    texts = {"inc/joint.xacro": f"{HEAD}{JOINT}</robot>", "../config/limits.yaml": LIMITS, "../meshes/m.obj": TETRAHEDRON}
    texts["../package.xml"] = "<package><name>arm_description</name></package>"
    texts["../../../hand-main/urdf/hand.xacro"] = f"{HEAD}{HAND}</robot>"
    for name, text in texts.items():
        file = Path(os.path.normpath(package / "urdf" / name))
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def write(elements="", text=ARM, name="arm.urdf.xacro"):
        file = package / "urdf" / name
        file.write_text(f"{HEAD}{text}{elements}</robot>")
        return file

    return write


@pytest.fixture
def read(arm):
    """A robot whose main file has further elements."""
    return lambda elements="", **options: mp.Robot.from_urdf(arm(elements), **options)


# ---- what a file expands to


@pytest.mark.slow
def test_a_package_with_includes_yaml_and_macros(arm, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    robot = mp.load_robot(arm().relative_to(tmp_path))
    assert robot.joint_names == ("turn", "lift") and robot.tool == "link1" and robot.name == "two"
    np.testing.assert_allclose(robot.limits.lower, -np.pi)
    np.testing.assert_allclose(robot.limits.upper, [np.pi / 2, 1.5])
    np.testing.assert_allclose(robot.limits.velocity, [2, 3])
    assert robot.geometry.ngeoms == 2
    pose = robot.kinematics(mp.Task.position(), compiled=False).pose([0.3, 0.4])
    np.testing.assert_allclose(pose[:3, 3], [0.5 * np.cos(0.3), 0.5 * np.sin(0.3), 0.0], atol=1e-12)
    assert visual_geometry(robot)[0].ngeoms == 2


@pytest.mark.slow
def test_arguments_and_packages(read, tmp_path):
    hand = {"hand_description": tmp_path / "hand-main"}
    robot = read(arguments={"prefix": "left_", "length": 0.75, "hand": True}, packages=hand)
    assert robot.tool == "hand"
    pose = robot.kinematics(mp.Task.position(), compiled=False).pose([0.0, 0.0])
    np.testing.assert_allclose(pose[:3, 3], [1.0, 0.0, 0.0], atol=1e-12)
    again = robot.source.load()
    assert again.source == robot.source and again.tool == "hand" and visual_geometry(again)[0].ngeoms == 2
    with pytest.raises(mp.errors.UnknownNameError, match="arguments: got 'lenght'; allowed: did you mean length"):
        read(arguments={"lenght": 1})
    with pytest.raises(mp.errors.UnknownNameError, match="got 'fingers'"):  # of the file that is not included
        read(arguments={"fingers": 2})
    assert read(arguments={"fingers": 2, "hand": True}, packages=hand).n == 2
    for wrong in ({"length": [1.0]}, {"length": None}, 5):
        with pytest.raises(mp.errors.InvalidInputError, match="arguments"):
            read(arguments=wrong)
    with pytest.raises(
        mp.errors.FileFormatError, match=r"package 'hand_description' is not found; .*packages={'hand_description': folder}"
    ):
        read(arguments={"hand": True})


@pytest.mark.parametrize(
    "elements",
    [
        '<xacro:property name="z" value="$(arg needed)"/><link name="${z}"/>',
        '<xacro:arg name="needed"/>',
        '<xacro:arg name="needed"/><xacro:if value="$(arg needed)"/>',
        '<xacro:include filename="$(arg needed).xacro"/>',
        '<xacro:macro name="of" params="p"><link name="${p}$(arg needed)"/></xacro:macro><xacro:of p="l"/>',
    ],
)
def test_an_argument_without_a_value_is_named(read, elements):
    match = r"the argument 'needed' has no value; give it in arguments={'needed': \.\.\.}"
    with pytest.raises(mp.errors.FileFormatError, match=match):
        read(elements)


@pytest.mark.slow
def test_all_arguments_without_a_value_are_named_at_once(read):
    elements = '<xacro:arg name="kind"/><!-- $(arg no) --><frame name="$(arg kind)$(arg size)$(arg prefix)">$(arg load)</frame>'
    match = r"the arguments 'kind', 'size', 'load' have no value; give it in arguments={'kind': \.\.\., 'size': \.\.\., 'load'"
    with pytest.raises(mp.errors.FileFormatError, match=match):
        read(elements)
    with pytest.raises(mp.errors.FileFormatError, match="the arguments 'size', 'load' have no value"):
        read(elements, arguments={"kind": "a"})
    assert read(elements, arguments={"kind": "a", "size": 1, "load": 2.5}).n == 2


@pytest.mark.slow
def test_a_default_holds_before_its_line(arm):
    """As in Universal Robots' files, whose first line is <robot name="$(arg name)">."""
    file = arm('<xacro:arg name="name" default="ur"/>')
    file.write_text(file.read_text().replace('name="two"', 'name="$(arg name)"', 1))
    assert mp.Robot.from_urdf(file).name == "ur"
    assert mp.Robot.from_urdf(file, arguments={"name": "other"}).name == "other"
    file.write_text(file.read_text().replace('default="ur"', 'default="$(arg kind)"'))
    with pytest.raises(mp.errors.FileFormatError, match="the arguments 'name', 'kind' have no value"):
        mp.Robot.from_urdf(file)


def test_a_missing_file_named_by_an_argument(read):
    """The default of Universal Robots' type, ur5x, stands for none of their arms."""
    elements = '<xacro:arg name="ur_type" default="ur5x"/><xacro:arg name="unused" default="zz"/>'
    elements += """<xacro:property name="z" value="${xacro.load_yaml('$(arg ur_type)/limits.yaml')}"/><link name="${z}"/>"""
    match = r"ur5x/limits\.yaml.*; give other values in arguments= than .*ur_type='ur5x'"
    with pytest.raises(mp.errors.FileFormatError, match=match) as error:
        read(elements)
    assert "unused" not in str(error.value)


@pytest.mark.slow
def test_packages_are_found_as_in_ros(arm, tmp_path, monkeypatch):
    file = arm(text=ARM.replace("$(arg hand)", "true"))
    hand = tmp_path / "hand-main"
    with pytest.raises(mp.errors.FileFormatError, match="'hand_description' is not found"):
        mp.load_robot(file)
    for variable, place in (("AMENT_PREFIX_PATH", "prefix/share"), ("ROS_PACKAGE_PATH", "ros")):
        (tmp_path / place).mkdir(parents=True)
        (tmp_path / place / "hand_description").symlink_to(hand)  # as colcon's --symlink-install does
        monkeypatch.setenv(variable, f"/nowhere:{tmp_path / place.removesuffix('/share')}")
        assert mp.load_robot(file).tool == "hand"
        monkeypatch.delenv(variable)
    assert (
        mp.load_robot(file, package_dirs=[shutil.copytree(hand, tmp_path / "all" / "hand_description").parent]).tool == "hand"
    )
    shutil.copytree(hand, tmp_path / "work" / "hand_description")
    with pytest.raises(mp.errors.FileFormatError, match="'hand_description' is not found"):
        mp.load_robot(file)  # any folder could be meant, until it has a package.xml
    (tmp_path / "work" / "hand_description" / "package.xml").write_text("<package><name> hand_description </name></package>")
    assert mp.load_robot(file).tool == "hand"


@pytest.mark.slow
def test_the_library_alone_expands_to_the_same(arm):
    """The library as ROS calls it, in a process of its own, is the oracle."""
    text = ARM.replace("$(find arm_description)", str(arm().parents[1]))
    file = arm('<!-- ${no} --><link name="$${1}"/><link name="${\'%03d\' % 7}"/><link name="${names + [round(2.5)]}"/>', text)
    code = f"import xacro; print(xacro.process_file({str(file)!r}, mappings={{'prefix': 'p_'}}).toxml())"
    oracle = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()
    for trust in (False, True):
        assert urdf_files.expand(PackageFolders(file=file), {"prefix": "p_"}, trust=trust) == oracle
    assert 'name="${1}"' in oracle and "007" in oracle and "['turn', 'lift', 2]" in oracle and 'link="p_base"' in oracle


def test_nothing_of_the_library_stays_in_this_process(read):
    modules = set(sys.modules)
    read()
    assert not {name.partition(".")[0] for name in set(sys.modules) - modules} & {"xacro", "rospkg"}


def test_warnings_of_the_library_are_logged(read, caplog):
    caplog.set_level(logging.WARNING, "manipplan")
    read("${xacro.message('careful', 'now')}")
    assert "xacro says: careful now" in caplog.text


# ---- expressions

NUMBERS = st.integers(-9, 9).map(str) | st.floats(-9, 9).map(repr) | st.sampled_from(["pi", "e", "True", "None"])
LISTS = st.lists(NUMBERS, max_size=3).map(lambda each: f"[{', '.join(each)}]")
BINARY = st.sampled_from(["+", "-", "*", "/", "//", "%", "and", "or", "<", "<=", ">", ">=", "==", "!=", "in", "not in"])


def combined(inner):
    return st.one_of(
        st.builds("({} {} {})".format, inner, BINARY, inner),
        st.builds("({} < {} <= {})".format, inner, inner, inner),
        st.builds("({} if {} else {})".format, inner, inner, inner),
        st.builds("({}{})".format, st.sampled_from(["-", "+", "not "]), inner),
        st.builds("{}({})".format, st.sampled_from(["str", "len", "max", "sin", "abs"]), inner),
        st.builds("[{0}, {1}][{2}]".format, inner, inner, st.sampled_from(["0", "-1", "1:", "::-1", "5"])),
        st.builds("[i + {0} for i in [{1}, 1] if i != {0}]".format, inner, inner),
        st.builds("{{'a': {0}, 'b': {1}}}.get('a')".format, inner, inner),
        st.builds("f'<{{{0}}}>'.upper().replace('1', 'one')".format, NUMBERS),
    )


@pytest.mark.slow
@examples(500)
@given(st.recursive(NUMBERS | LISTS, combined, max_leaves=6))
def test_expressions_are_those_of_python(text):
    names = {"pi": math.pi, "e": math.e, "sin": math.sin, "str": str, "len": len, "max": max, "abs": abs}

    def outcome(function):
        try:
            return repr(function())
        except RefusedError:
            raise
        except Exception as error:
            return type(error)

    with np.errstate(all="ignore"):
        import warnings

        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SyntaxWarning)
            assert outcome(lambda: evaluate(text, names)) == outcome(lambda: eval(text, dict(names)))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("{k: v * 2 for k, v in {'a': 1}.items()}", {"a": 2}),
        ("{x % 2 for x in (1, 2, 3)}", {0, 1}),
        ("sum(x * y for x in [1, 2] for y in [*[3], 4] if y > x)", 21),
        ("' a,b '.strip().split(',')[::-1]", ["b", "a"]),
        ("dict(a=1, b=[1, 2])['b'][-1]", 2),
        ("f'{1.0:.3f}|{2:>{3}}'", "1.000|  2"),
        ("(1.0).is_integer() and 'x' not in 'abc'", True),
        ("2 ** 3 ^ 1 | 4 & 6", 13),
        ("(None is None) + (True is not None) * 2", 3),
    ],
)
def test_expressions(text, value):
    assert evaluate(text, {"dict": dict, "sum": sum}) == value == eval(text)


# ---- what an untrusted file may do

#: Expressions that write the file MARK in Python's own evaluation; the library forbids none of them.
OPEN = "[c for c in ().__class__.__base__.__subclasses__() if c.__name__ == '_wrap_close'][0].__init__.__globals__['system']('touch MARK')"
ESCAPES = {
    "lambda": f"${{(lambda: {OPEN})()}}",
    "two lambdas": "${list(map(lambda x: x[0].__init__.__globals__['system']('touch MARK'), "
    "[[c for c in (lambda: ().__class__.__base__.__subclasses__())() if (lambda: c.__name__)() == '_wrap_close']]))}",
    "eval": r"""$(eval ${'open\x28"MARK", "w"\x29'})""",
    "a unit in YAML": None,
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", ESCAPES)
def test_no_code_runs_unless_the_file_is_trusted(read, arm, tmp_path, kind):
    mark = tmp_path / "mark"
    escape = ESCAPES[kind]
    if kind == "a unit in YAML":
        (arm().parents[1] / "config" / "bad.yaml").write_text(
            f'a: !degrees "{ESCAPES["lambda"][2:-1].replace("MARK", str(mark))}"'
        )
        escape = "${xacro.load_yaml('$(find arm_description)/config/bad.yaml')}"
    escape = escape.replace("MARK", str(mark))
    escape = escape.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")
    element = f'<xacro:property name="p" value="{escape}"/><xacro:if value="${{str(p) == \'x\'}}"/>'
    with pytest.raises(mp.errors.FileFormatError, match="trust_file=True|name 'open' is not defined"):
        read(element)
    assert not mark.exists()
    read(element, trust_file=True)
    assert mark.exists()


@pytest.mark.parametrize(
    "text",
    [
        "().__class__",
        "''.format()",
        "'{0.__globals__}'.format(load)",
        "load.__globals__",
        "load.func_globals",
        "(lambda: 1)()",
        "[(lambda: 1) for i in [1]]",
        "__import__('os')",
        "__builtins__",
        "(x := 1)",
        "f'{load!r:}'",
        "dict(**{'a': 1})",
        "{**{}}",
        "[].append(1)",
        "str.join",
        "(i for i in [1]).gi_frame",
        "[x for x.y in [1]]",
        "await load",
    ],
)
def test_expressions_that_are_refused(text):
    with pytest.raises((RefusedError, SyntaxError)):
        evaluate(text, {"load": test_expressions, "dict": dict, "str": str})


@pytest.mark.slow
def test_environment_variables(read, monkeypatch):
    monkeypatch.setenv("SECRET", "0.7")
    for text in ("$(env SECRET)", "$(optenv SECRET 1)", "$(eval env${'\\x28'}'SECRET'${'\\x29'})"):
        with pytest.raises(mp.errors.FileFormatError, match="environment variable SECRET is read only if trust_file=True"):
            read(f'<xacro:property name="p" value="{text}"/><link name="x${{p}}"/>')
    tool = read(
        '<link name="x$(env SECRET)"/><joint name="f" type="fixed"><parent link="link1"/><child link="x0.7"/></joint>',
        trust_file=True,
    )
    assert tool.tool == "x0.7"


@pytest.mark.slow
def test_files_outside_the_packages(read, arm, tmp_path):
    outside = tmp_path / "secret.yaml"
    outside.write_text("a: tip")
    (arm().parents[1] / "config" / "link.yaml").symlink_to(outside)
    (arm().parent / "pipe").parent.mkdir(exist_ok=True)
    os.mkfifo(arm().parent / "pipe")
    frame = '<link name="{0}"/><joint name="f" type="fixed"><parent link="link1"/><child link="{0}"/></joint>'
    for path in (outside, "../../../secret.yaml", "../config/link.yaml", "$(find arm_description)/../../secret.yaml"):
        elements = frame.format(f"${{xacro.load_yaml('{path}').a}}")
        with pytest.raises(
            mp.errors.FileFormatError, match="outside the folders that may be read; give its folder in packages="
        ):
            read(elements)
        assert read(elements, trust_file=True).tool == "tip"
        assert read(elements, package_dirs=[tmp_path]).tool == "tip"
    for path in ("/dev/zero", "/etc/passwd", "../../../*.yaml"):
        with pytest.raises(mp.errors.FileFormatError, match="outside the folders"):
            read(f'<xacro:include filename="{path}"/>')
    with pytest.raises(mp.errors.FileFormatError, match="not a plain file"):
        read('<xacro:include filename="pipe"/>')
    for name in ("..", ".", "etc", "../hand-main", tmp_path.name):
        with pytest.raises(mp.errors.FileFormatError, match="is not found"):
            read(f'<xacro:include filename="$(find {name})/passwd"/>')


@pytest.mark.slow
def test_a_saved_robot_does_not_say_that_its_file_is_trusted(arm, tmp_path):
    mark = tmp_path / "mark"
    code = ESCAPES["lambda"].replace("MARK", str(mark))
    file = arm(f'<xacro:property name="p" value="{code}"/><xacro:if value="${{str(p) == \'x\'}}"/>')
    robot = mp.Robot.from_urdf(file, trust_file=True, arguments={"length": 0.6})
    assert mark.exists() and robot.source.load().n == 2
    data = json.loads(
        json.dumps(robot_data(robot, tmp_path), default=lambda each: getattr(each, "tolist", lambda: str(each))())
    )
    assert data["source"]["options"]["arguments"] == {"length": "0.6"} and "trust_file" not in data["source"]["options"]
    data["source"]["options"]["trust_file"] = True
    mark.unlink()
    with pytest.raises(mp.errors.FileFormatError, match=r"trust_file=True.*give robot="):
        robot_of(tmp_path, data, tmp_path, None)
    assert not mark.exists()


@pytest.mark.slow
def test_a_library_that_evaluates_elsewhere_is_not_used(read, tmp_path, monkeypatch):
    """A later version may do so; then what replaces its evaluation has no effect."""
    import importlib.util

    folder = Path(importlib.util.find_spec("xacro").origin).parent
    for change in (("return safe_eval(eval_text", "return eval(eval_text"), ("def safe_eval(", "def eval_safely(")):
        copied = tmp_path / change[0][:6].strip() / "xacro"
        shutil.copytree(folder, copied)
        text = (copied / "__init__.py").read_text()
        assert change[0] in text
        (copied / "__init__.py").write_text(text.replace(*change))
        monkeypatch.syspath_prepend(copied.parent)
        with pytest.raises(
            mp.errors.FileFormatError, match=r"this version of xacro is not supported.*pip install 'manipplan\[xacro\]'"
        ):
            read()


# ---- wrong files

DOUBLING = '<xacro:macro name="m0"><link name="x"/></xacro:macro>' + "".join(
    f'<xacro:macro name="m{i + 1}"><xacro:m{i}/><xacro:m{i}/></xacro:macro>' for i in range(40)
)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("elements", "message"),
    [
        (
            '<xacro:include filename="arm.urdf.xacro"/>',
            "a macro or an include that calls itself without end; in .*arm.urdf.xacro",
        ),
        ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "calls itself without end; in .*macro m"),
        (
            '<xacro:property name="a" value="${b}"/><xacro:property name="b" value="${a}"/><link name="${a}"/>',
            "circular variable",
        ),
        (f'<link name="${{{"[" * 300 + "]" * 300}}}"/>', "too many nested|nested too deeply"),
        ('<link name="${10**10**10}"/>', "it takes more than 1 s"),
        ("<link name=\"${'a'*10**11}\"/>", "needs more than 1 GiB of memory"),
        (DOUBLING + "<xacro:m40/>", "it takes more than 1 s"),
        ('<link name="${1/0}"/>', "division by zero when evaluating expression '1/0'"),
        ('<link name="${nope}"/>', "name 'nope' is not defined"),
        ("<link name=\"${limits['x']}\"/>", "no key 'x'"),
        ('<xacro:include filename="nope.xacro"/>', "No such file or directory: '.*nope.xacro'"),
        ("<xacro:nope/>", "unknown macro name: xacro:nope"),
        ('<xacro:joint i="0"/>', "Undefined parameters"),
        ("<link", "not well-formed"),
        ('<xacro:include filename="../config/limits.yaml"/>', "syntax error.*; in .*limits.yaml"),
        ('<xacro:include filename="$(find arm_description"/>', "invalid expression|No such file"),
        ("${xacro.fatal('stop', 'here')}", "stop here"),
        ("&#27;[2J${\x7fb}", "."),
    ],
)
def test_wrong_files(read, monkeypatch, elements, message):
    if "it takes" in message:
        monkeypatch.setattr(urdf_files, "TIME_LIMIT", 1.0)
    start = time.monotonic()
    with pytest.raises(mp.errors.FileFormatError, match=message) as caught:
        read(elements)
    assert time.monotonic() - start < 30.0
    assert "arm.urdf.xacro" in str(caught.value) and "\x1b" not in str(caught.value)


@pytest.mark.slow
def test_a_file_that_expands_to_very_much(read):
    with pytest.raises(mp.errors.FileFormatError, match="more than 100,000,000 characters"):
        read("<link name=\"${'a'*150000000}\"/>")


@pytest.mark.slow
def test_other_files(arm, tmp_path):
    for namespace in ("www.ros.org/wiki", "ros.org/wiki", "wiki.ros.org"):  # all three are in use
        named = arm()
        named.write_text(named.read_text().replace("www.ros.org/wiki", namespace))
        assert mp.load_robot(named).n == 2
        assert mp.load_robot(shutil.copy(named, named.with_suffix(""))).n == 2  # the same file as .urdf
    plain = tmp_path / "plain.urdf"
    plain.write_text('<robot name="r"><link name="a"/></robot>')
    with pytest.raises(mp.errors.InvalidInputError, match="only a xacro file has arguments"):
        mp.load_robot(plain, arguments={"a": 1})
    with pytest.raises(mp.errors.FileFormatError, match="at least one <link>; .* give the file that includes it"):
        mp.load_robot(arm(text=""))
    with pytest.raises(mp.errors.InvalidInputError, match="an existing file"):
        mp.load_robot(tmp_path / "no.xacro")
    with pytest.raises(mp.errors.FileFormatError, match="UTF-8|utf-8"):
        file = arm()
        file.write_bytes(file.read_bytes() + b"<!-- \xe9 -->")
        mp.load_robot(file)


def test_the_library_is_not_installed(arm, monkeypatch):
    monkeypatch.setattr(urdf_files.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(
        mp.errors.MissingExtraError, match=r"xacro is not installed; install it with: pip install 'manipplan\[xacro\]'"
    ):
        mp.load_robot(arm())


@pytest.mark.slow
def test_nothing_is_left_behind(arm, monkeypatch, tmp_path):
    monkeypatch.setattr(urdf_files.tempfile, "tempdir", str(tmp_path / "tmp"))
    (tmp_path / "tmp").mkdir()
    before = sorted(tmp_path.rglob("*")) + [arm()]
    for elements in ("", "<link"):
        try:
            mp.load_robot(arm(elements))
        except mp.errors.FileFormatError:
            assert elements
    assert set(tmp_path.rglob("*")) == set(before)
