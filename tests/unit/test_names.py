"""Robots by name: robot_descriptions, MuJoCo Menagerie, entry points, the catalogue, and the limits of data sheets."""

import logging
import os
import re
import subprocess
import sys
import warnings

import numpy as np
import pytest

import manipplan as mp
from manipplan.cli import commands, main
from manipplan.ik.form import closed_form
from manipplan.robots import collections
from manipplan.robots.catalog import CATALOG, FR3

LIMIT = '<limit lower="{}" upper="{}" velocity="{}" effort="50"/>'


def urdf(joints, lower=-3.0, upper=3.0, velocity=2.6):
    """A chain of revolute joints of these names, alternating about z and y, with a mesh-free body each."""
    text = '<link name="base"/>'
    for k, name in enumerate(joints, start=1):
        parent = "base" if k == 1 else f"link{k - 1}"
        text += f'<link name="link{k}"/><joint name="{name}" type="revolute"><parent link="{parent}"/><child link="link{k}"/>'
        text += f'<origin xyz="{0.05 * (k % 2)} 0 0.2"/><axis xyz="0 {(k + 1) % 2} {k % 2}"/>'
        text += f"{LIMIT.format(lower, upper, velocity)}</joint>"
    return f'<robot name="arm">{text}</robot>'


MJCF = """<mujoco><compiler angle="radian"/><worldbody><body name="base">
 <body name="l1" pos="0 0 .2"><joint name="j1" axis="0 0 1" range="-2 2"/><geom size=".03"/>
 <body name="l2" pos="0 0 .2"><joint name="j2" axis="0 1 0" range="-2 2"/><geom size=".03"/></body></body></body></worldbody></mujoco>"""


@pytest.fixture
def descriptions(tmp_path, monkeypatch):
    """A package called robot_descriptions with modules of the given text; each has REPOSITORY_PATH and PACKAGE_PATH."""
    package = tmp_path / "site" / "robot_descriptions"
    package.mkdir(parents=True)
    repository = tmp_path / "repository"
    repository.mkdir()

    def make(**modules):
        (package / "__init__.py").write_text(f"DESCRIPTIONS = {dict.fromkeys(modules)!r}\n")
        for name, text in modules.items():
            (package / f"{name}.py").write_text(f"REPOSITORY_PATH = PACKAGE_PATH = {str(repository)!r}\n{text}\n")
        return repository

    monkeypatch.syspath_prepend(tmp_path / "site")
    for name in [each for each in sys.modules if each.split(".")[0] == "robot_descriptions"]:
        monkeypatch.delitem(sys.modules, name)
    yield make
    for name in [each for each in sys.modules if each.split(".")[0] == "robot_descriptions"]:
        del sys.modules[name]


@pytest.mark.slow
def test_a_module_of_robot_descriptions(descriptions, tmp_path, capfd):
    text = 'import os, sys\nprint("Cloning ...")\nprint("50 %", file=sys.stderr)\nURDF_PATH = os.path.join(PACKAGE_PATH, "arm.urdf")'
    repository = descriptions(own_description=text)
    (repository / "arm.urdf").write_text(urdf(["a", "b", "c"]))
    robot = mp.load_robot("own_description")
    assert (robot.joint_names, robot.tool) == (("a", "b", "c"), "link3")
    assert capfd.readouterr() == ("", "")
    plan = mp.plan(robot, [0.1, 0.4, 0.5], [0.6, 0.8, 0.9])
    plan.save(tmp_path / "plan")
    assert mp.Plan.load(tmp_path / "plan").robot.source.name == "own_description"


@pytest.mark.slow
def test_formats_and_options_of_robot_descriptions(descriptions):
    pytest.importorskip("xacro")
    repository = descriptions(
        first_description='XACRO_PATH = PACKAGE_PATH + "/arm.urdf.xacro"\nXACRO_ARGS = {"n": "0.7", "more": True}',
        second_mj_description='MJCF_PATH = PACKAGE_PATH + "/arm.xml"',
        third_description='URDF_PATH = PACKAGE_PATH + "/arm.urdf"\nSRDF_PATH = PACKAGE_PATH + "/arm.srdf"',
    )
    xacro = urdf(["a", "b"]).replace("<robot ", '<robot xmlns:xacro="http://ros.org/wiki/xacro" ')
    arguments = '<xacro:arg name="more" default="false"/><xacro:unless value="$(arg more)"><link name="x"/></xacro:unless>'
    text = xacro.replace('upper="3.0"', 'upper="$(arg n)"').replace("</robot>", f"{arguments}</robot>")
    (repository / "arm.urdf.xacro").write_text(text)
    (repository / "arm.xml").write_text(MJCF)
    (repository / "arm.urdf").write_text(urdf(["a", "b", "c"]))
    (repository / "arm.srdf").write_text('<robot name="arm"><end_effector name="e" parent_link="link2" group="g"/></robot>')
    np.testing.assert_array_equal(mp.load_robot("first_description").limits.upper, 0.7)
    np.testing.assert_array_equal(mp.load_robot("first_description", arguments={"n": 0.9}).limits.upper, 0.9)
    assert mp.load_robot("second_mj_description", velocity=1.0).joint_names == ("j1", "j2")
    assert mp.load_robot("third_description").tool == "link2"
    assert mp.load_robot("third_description", tool="link3").tool == "link3"


def test_a_description_that_cannot_be_fetched(descriptions, capfd):
    text = """
import sys
class GitCommandError(Exception):
    stderr = "fatal: could not resolve host"
print("Cloning ...", file=sys.stderr)
raise GitCommandError("Cmd('git') failed")
"""
    descriptions(gone_description=text, broken_description="raise OSError('no space left')")
    with pytest.raises(
        mp.errors.RobotNotFetchedError, match=r"gone_description could not be fetched: fatal: could not resolve host; run: "
    ) as caught:
        mp.load_robot("gone_description")
    assert "ROBOT_DESCRIPTIONS_CACHE" in str(caught.value)
    with pytest.raises(mp.errors.RobotNotFetchedError, match="no space left"):
        mp.load_robot("broken_description")
    assert capfd.readouterr() == ("", "")


def test_fetching_changes_nothing_in_this_process(descriptions):
    text = """
import logging, os, sys, warnings
logging.disable(logging.CRITICAL)
os.environ["GIT_TERMINAL_PROMPT"] = os.environ["ADDED"] = "1"
sys.stdout = sys.stderr = None
warnings.simplefilter("error")
URDF_PATH = PACKAGE_PATH + "/arm.urdf"
"""
    (descriptions(own_description=text) / "arm.urdf").write_text(urdf(["a", "b", "c"]))
    before = logging.root.manager.disable, dict(os.environ), sys.stdout, sys.stderr, list(warnings.filters)
    assert mp.load_robot("own_description").n == 3
    assert (logging.root.manager.disable, dict(os.environ), sys.stdout, sys.stderr, list(warnings.filters)) == before
    assert "robot_descriptions.own_description" not in sys.modules


@pytest.mark.slow
def test_a_process_that_ends_without_an_answer(descriptions, monkeypatch):
    descriptions(own_description="import os\nos._exit(3)", slow_description="import time\ntime.sleep(60)")
    with pytest.raises(mp.errors.RobotNotFetchedError, match="ended with code 3"):
        mp.load_robot("own_description")
    monkeypatch.setattr(collections, "TIME_LIMIT", 1.0)
    with pytest.raises(mp.errors.RobotNotFetchedError, match="takes more than 1 s"):
        mp.load_robot("slow_description")


def test_names_of_robot_descriptions(descriptions):
    descriptions(ur5e_description="")
    with pytest.raises(mp.errors.UnknownNameError, match="did you mean ur5e_description"):
        mp.load_robot("ur5f_description")


def test_unknown_names_are_told_of_the_other_collections():
    for name, told in (("fr3", "did you mean ur3? Or"), ("iiwa", "in all), or")):
        with pytest.raises(mp.errors.UnknownNameError, match=re.escape(told) + ".* 'menagerie:franka_fr3', or a file"):
            mp.load_robot(name)


def test_the_packages_that_are_missing(monkeypatch):
    monkeypatch.setattr(collections, "find_spec", lambda name: None)
    monkeypatch.delenv("MUJOCO_MENAGERIE", raising=False)
    with pytest.raises(mp.errors.MissingExtraError, match=r"pip install 'manipplan\[descriptions\]'"):
        mp.load_robot("ur5e_description")
    with pytest.raises(
        mp.errors.MissingExtraError, match=r"checkout of MuJoCo Menagerie in MUJOCO_MENAGERIE.*'manipplan\[menagerie\]'"
    ):
        mp.load_robot("menagerie:franka_fr3")


@pytest.mark.slow
def test_the_package_itself_with_a_cache_and_without(tmp_path, monkeypatch, capfd):
    """The package as its makers ship it: a repository in its cache is used; where there is none, git cannot clone it."""
    pytest.importorskip("robot_descriptions")
    monkeypatch.setenv("ROBOT_DESCRIPTIONS_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("GIT_CONFIG_COUNT", "1")
    monkeypatch.setenv("GIT_CONFIG_KEY_0", f"url.{tmp_path / 'nothing'}/.insteadOf")
    monkeypatch.setenv("GIT_CONFIG_VALUE_0", "https://")
    with pytest.raises(
        mp.errors.RobotNotFetchedError, match=r"panda_description could not be fetched: .*python -m robot_descriptions pull"
    ):
        mp.load_robot("panda_description")
    assert capfd.readouterr() == ("", "")
    made = tmp_path / "made"
    folder = made / "robots" / "panda_description"
    (folder / "urdf").mkdir(parents=True)
    (folder / "srdf").mkdir()
    (folder / "urdf" / "panda.urdf").write_text(urdf([f"panda_joint{k}" for k in range(1, 8)]))
    (folder / "srdf" / "panda.srdf").write_text('<robot name="arm"/>')

    def git(*words):
        return subprocess.run(["git", "-C", str(made), *words], check=True, capture_output=True, text=True).stdout.strip()

    git("init", "-q")
    git("add", ".")
    git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "a")
    commit = git("rev-parse", "HEAD")
    place = tmp_path / "cache" / f"example-robot-data-{commit}"
    place.mkdir(parents=True)
    made.rename(place / "example-robot-data")
    monkeypatch.setenv("ROBOT_DESCRIPTION_COMMIT", commit)
    robot = mp.load_robot("panda_description")
    assert robot.n == 7
    np.testing.assert_array_equal(robot.limits.acceleration, [15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0])
    assert capfd.readouterr() == ("", "")


@pytest.fixture
def menagerie(tmp_path, monkeypatch):
    """A checkout with folders of one robot, of several, and of none."""
    root = tmp_path / "menagerie"
    for name, files in {
        "maker_arm": ("arm.xml", "mjx_arm.xml", "scene.xml", "arm_nohand.xml"),
        "one": ("robot.xml", "scene_left.xml"),
        "hands": ("left.xml", "right.xml", "scene.xml"),
        "empty": ("scene.xml",),
        "assets": (),
    }.items():
        (root / name).mkdir(parents=True)
        for file in files:
            (root / name / file).write_text(MJCF.replace("l2", file.removesuffix(".xml")))
    monkeypatch.setenv("MUJOCO_MENAGERIE", str(root))
    return root


def test_a_misspelt_prefix_of_menagerie():
    with pytest.raises(mp.errors.UnknownNameError, match="did you mean menagerie:franka_fr3"):
        mp.load_robot("menagrie:franka_fr3")


def test_a_part_of_a_name_is_enough_for_a_suggestion():
    error = mp.errors.UnknownNameError(
        "name", "fr3", [*("panda", "kinova", "baxter", "talos", "tiago", "icub", "romeo"), "franka_fr3", "franka_fr3_v2"]
    )
    assert "did you mean franka_fr3, franka_fr3_v2?" in str(error)


@pytest.mark.slow
def test_the_folder_of_a_checkout(menagerie, tmp_path):
    assert mp.load_robot("menagerie:maker_arm").tool == "arm"
    assert mp.load_robot("menagerie:one").tool == "robot"
    assert mp.load_robot("menagerie:hands/right.xml").tool == "right"
    assert mp.load_robot("menagerie:maker_arm/arm_nohand.xml", tool="l1", joints=["j1"]).n == 1
    robot = mp.load_robot("menagerie:maker_arm", velocity=1.0)
    mp.plan(robot, [0.1, 0.2], [0.5, 0.7]).save(tmp_path / "plan")
    assert mp.Plan.load(tmp_path / "plan").robot.tool == "arm"


@pytest.mark.parametrize(
    ("name", "error", "message"),
    [
        ("hands", mp.errors.FileFormatError, "choose one: menagerie:hands/left.xml, menagerie:hands/right.xml"),
        ("empty", mp.errors.FileFormatError, "choose one: it has none"),
        ("hands/lift.xml", mp.errors.UnknownNameError, "did you mean left.xml"),
        ("maker_arn", mp.errors.UnknownNameError, "did you mean maker_arm"),
        ("assets", mp.errors.UnknownNameError, "one of empty, hands"),
        ("..", mp.errors.UnknownNameError, "one of"),
        ("one/../hands/left.xml", mp.errors.UnknownNameError, "got '../hands/left.xml'"),
        ("", mp.errors.UnknownNameError, "one of"),
    ],
)
def test_folders_and_files_that_are_not_there(menagerie, name, error, message):
    with pytest.raises(error, match=message):
        mp.load_robot(f"menagerie:{name}")


def test_a_checkout_that_is_not_there(monkeypatch):
    monkeypatch.setenv("MUJOCO_MENAGERIE", "/nowhere")
    with pytest.raises(mp.errors.InvalidInputError, match="MUJOCO_MENAGERIE: got '/nowhere'"):
        mp.load_robot("menagerie:franka_fr3")


@pytest.mark.slow
def test_the_downloader(tmp_path, monkeypatch, capfd):
    """The package mujoco-menagerie, by a stand-in with the names that its makers document."""
    monkeypatch.delenv("MUJOCO_MENAGERIE", raising=False)
    folder = tmp_path / "cache" / "maker_arm"
    folder.mkdir(parents=True)
    for file in ("first.xml", "second.xml"):
        (folder / file).write_text(MJCF.replace("l2", file.removesuffix(".xml")))
    (tmp_path / "site").mkdir()
    (tmp_path / "site" / "mujoco_menagerie.py").write_text(f"""
import pathlib
class Entry:
    file = "second.xml"
class Robot:
    default_model = "second"
    def __init__(self, name): self.name = name
    def entry(self, name): return Entry
    def path(self, progress=print):
        print("downloading")
        if self.name == "gone": raise RuntimeError("HTTP 404")
        return pathlib.Path({str(folder)!r})
def names(): return ["maker_arm", "gone"]
def get(name): return Robot(name)
""")
    monkeypatch.syspath_prepend(tmp_path / "site")
    monkeypatch.delitem(sys.modules, "mujoco_menagerie", raising=False)
    assert mp.load_robot("menagerie:maker_arm").tool == "second"
    assert mp.load_robot("menagerie:maker_arm/first.xml").tool == "first"
    with pytest.raises(mp.errors.UnknownNameError, match="did you mean maker_arm"):
        mp.load_robot("menagerie:maker_arn")
    with pytest.raises(
        mp.errors.RobotNotFetchedError, match="gone could not be fetched: HTTP 404; run: mujoco-menagerie prefetch gone"
    ):
        mp.load_robot("menagerie:gone")
    assert capfd.readouterr() == ("", "")
    del sys.modules["mujoco_menagerie"]


OWN_CELL = """
import manipplan as mp
ARM = "arm.urdf"
NO_FILE = "missing.urdf"
def arm(**options): return mp.load_robot(FILE, **options)
def wrong(**options): return 3
def broken(**options): return 1 / 0
"""


@pytest.fixture
def install(tmp_path, monkeypatch):
    """Installs a package: its name, the text of its module, and its entry points; the folder has a file arm.urdf."""
    (tmp_path / "arm.urdf").write_text(urdf(["a", "b"]))
    monkeypatch.syspath_prepend(tmp_path)
    modules = []

    def make(package, text, points):
        module = package.replace("-", "_")
        modules.append(module)
        (tmp_path / f"{module}.py").write_text(f"FILE = {str(tmp_path / 'arm.urdf')!r}\n{text}")
        info = tmp_path / f"{module}-1.0.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n")
        lines = [f"{name} = {module}:{value}" for name, value in points.items()]
        (info / "entry_points.txt").write_text("\n".join(["[manipplan.robots]", *lines, ""]))

    yield make
    for module in modules:
        sys.modules.pop(module, None)


def test_own_robots_by_an_entry_point(install):
    """An installed package whose entry point names a function, or the path of a file."""
    install("own-cell", OWN_CELL, {"cell_arm": "arm", "cell_file": "ARM"})
    assert mp.available_robots()[-2:] == ("cell_arm", "cell_file")
    for name in ("cell_arm", "cell_file"):
        robot = mp.load_robot(name, velocity=1.0)
        assert (robot.n, robot.source.load().limits.velocity[0]) == (2, 1.0)
    with pytest.raises(mp.errors.UnknownNameError, match="did you mean cell_arm"):
        mp.load_robot("cel_arm")


def test_an_entry_point_that_fails_is_named_with_its_package(install):
    points = {each: each for each in ("wrong", "broken", "no_such")} | {"no_file": "NO_FILE", "arm_of_cell": "arm"}
    install("own-cell", OWN_CELL, points)
    install("own-import", "import no_such_module", {"no_import": "arm"})
    for name, reason in {
        "wrong": r"returns a Robot, not 3: the entry point wrong = own_cell:wrong of own-cell 1\.0",
        "broken": r"the entry point broken = own_cell:broken of own-cell 1\.0 .* ZeroDivisionError",
        "no_such": r"the entry point no_such = own_cell:no_such of own-cell 1\.0 .* AttributeError",
        "no_import": r"the entry point no_import = own_import:arm of own-import 1\.0 .* ModuleNotFoundError",
    }.items():
        with pytest.raises(mp.errors.InvalidInputError, match=reason):
            mp.load_robot(name)
    for name, options in {"no_file": {}, "arm_of_cell": {"velocity": -1.0}}.items():
        with pytest.raises(mp.errors.InvalidInputError, match="missing.urdf|velocity") as caught:
            mp.load_robot(name, **options)
        assert f"the entry point {name} = own_cell:" in caught.value.__notes__[0]


def test_names_that_a_package_cannot_use(install, caplog, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "300")
    names = ["panda", "cell_description", "menagerie:cell", "cell.urdf", "twice"]
    install("own-cell", OWN_CELL, dict.fromkeys(names, "arm"))
    install("other-cell", OWN_CELL, {"twice": "arm"})
    found = mp.available_robots()
    assert found.count("panda") == 1
    assert not set(names[1:]) & set(found)
    for name in names:
        assert f"{name} is left out" in caplog.text
    assert mp.load_robot("panda").n == 7
    for name in names[1:3]:
        with pytest.raises(mp.errors.InvalidInputError, match=r"rename the entry point of own-cell 1\.0 \(own_cell:arm\)"):
            mp.load_robot(name)
    with pytest.raises(mp.errors.InvalidInputError, match=r"not .*(own|other)-cell 1\.0 .* and .*(own|other)-cell 1\.0"):
        mp.load_robot("twice")
    main(["robots"])
    assert "cannot be loaded" in capsys.readouterr().out


def test_listing_own_robots_imports_no_package(install):
    install("own-cell", "raise SystemExit('imported')", {"cell_arm": "arm"})
    assert "cell_arm" in mp.available_robots()
    main(["robots"])
    assert "own_cell" not in sys.modules


FR3_JOINTS = [f"fr3_joint{k}" for k in range(1, 8)]


def fastest(q):
    """Largest velocities (7,) of the FR3 upwards at q (7,), by the formulas of its maker's page."""
    a, b = [0.3, 0.2, 0.2, 0.3, 0.35, 0.35, 0.35], [12.0, 5.17, 7.0, 8.0, 34.0, 11.0, 34.0]
    top, most = [2.7501, 1.7918, 2.9065, -0.1458, 2.8101, 4.5205, 3.0196], [2.62, 2.62, 2.62, 2.62, 5.26, 4.18, 5.26]
    return [min(m, max(0.0, -x + max(0.0, y * (z - each)) ** 0.5)) for x, y, z, m, each in zip(a, b, top, most, q, strict=True)]


def slowest(q):
    """The same downwards."""
    a, b = [0.3, 0.2, 0.2, 0.3, 0.35, 0.35, 0.35], [12.0, 5.17, 7.0, 8.0, 34.0, 11.0, 34.0]
    low, most = [2.7501, 1.7918, 2.9065, 3.0481, 2.8101, -0.54092, 3.0196], [2.62, 2.62, 2.62, 2.62, 5.26, 4.18, 5.26]
    return [max(-m, min(0.0, x - max(0.0, y * (z + each)) ** 0.5)) for x, y, z, m, each in zip(a, b, low, most, q, strict=True)]


def test_constant_velocities_of_the_fr3_hold_on_its_narrower_range():
    lower, upper, velocity = (np.array(FR3.limits[kind]) for kind in ("lower", "upper", "velocity"))
    for q in np.random.default_rng(0).uniform(lower, upper, (1000, 7)):
        assert (velocity <= np.array(fastest(q)) + 1e-4).all()
        assert (-velocity >= np.array(slowest(q)) - 1e-4).all()
    assert (np.array(fastest(upper)) < velocity + 1e-3).all(), "the range is as wide as these velocities allow"


@pytest.fixture
def fr3(descriptions):
    repository = descriptions(fr3_description='URDF_PATH = PACKAGE_PATH + "/arm.urdf"')
    (repository / "arm.urdf").write_text(urdf(FR3_JOINTS, -3.1, 4.6, 5.2))
    return lambda **options: mp.load_robot("fr3_description", **options)


@pytest.mark.slow
def test_an_fr3_by_name_has_the_limits_of_its_data_sheet(fr3):
    robot = fr3()
    for kind, values in FR3.limits.items():
        np.testing.assert_array_equal(getattr(robot.limits, kind), values)
        assert robot.limits.sources[kind] == FR3.source
    assert "narrower range" in str(robot)
    np.testing.assert_array_equal(fr3(jerk=100.0).limits.jerk, 100.0)
    own = fr3(velocity=0.5).limits
    np.testing.assert_array_equal(own.velocity, 0.5)
    np.testing.assert_array_equal(own.lower, -3.1, "the range of positions belongs to the velocities of the sheet")
    np.testing.assert_array_equal(own.acceleration, 10.0)
    assert fr3(joints=FR3_JOINTS[:3], tool="link3").limits.velocity[0] == 5.2


def motion(q, duration=2.0, joints=FR3_JOINTS):
    """A motion of one second from rest to rest through the mean of two configurations, by a polynomial of degree 7."""
    s = np.linspace(0.0, 1.0, 2001)[:, None]
    shape, slope = s**4 * (35 - 84 * s + 70 * s**2 - 20 * s**3), 140 * s**3 * (1 - s) ** 3 / duration
    q = np.asarray(q, dtype=float)
    return mp.Trajectory(t=s[:, 0] * duration, q=q[0] + shape * (q[1] - q[0]), qd=slope * (q[1] - q[0]), joint_names=joints)


READY = np.array([0.0, -np.pi / 4, 0.0, -3 * np.pi / 4, 0.0, np.pi / 2, np.pi / 4])


def test_the_table_of_an_fr3_keeps_velocities_that_depend_on_the_position(tmp_path):
    far = READY + np.array([1.0, 0.3, 0.5, 0.5, 0.5, 0.5, 0.5])
    motion([READY, far]).to_franka_csv(tmp_path / "motion.csv")
    rows = np.genfromtxt(tmp_path / "motion.csv", delimiter=",", skip_header=1)
    v = np.diff(rows[:, 1:], axis=0) * 1000
    assert all(
        (each <= np.array(fastest(q))).all() and (each >= np.array(slowest(q))).all()
        for each, q in zip(v, rows[:, 1:], strict=False)
    )
    # the same motion next to the limit of joint 1, where 1.09 rad/s is too fast
    shift = np.array([2.7437 - 1.0 - 0.0, 0, 0, 0, 0, 0, 0])
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"joint 1 at .*a velocity of .*at most [\d.]+ rad/s at this position"
    ):
        motion([READY + shift, far + shift]).to_franka_csv(tmp_path / "limit.csv")
    with pytest.raises(mp.errors.InvalidInputError, match=r"joint 1 at .*an acceleration of .*at most 10 rad/s²"):
        motion([READY, far], duration=0.85).to_franka_csv(tmp_path / "fast.csv")
    outside = far + np.array([2.0, 0, 0, 0, 0, 0, 0])
    with pytest.raises(mp.errors.InvalidInputError, match="a Franka Research 3 from -2.7437 to 2.7437"):
        motion([READY, outside], duration=9.0).to_franka_csv(tmp_path / "outside.csv")
    assert not (tmp_path / "limit.csv").exists()


@pytest.mark.slow
def test_a_plan_of_an_fr3_within_its_data_sheet_gives_a_table(fr3, tmp_path):
    robot = fr3()
    plan = mp.plan(robot, READY, READY + np.array([0.8, 0.4, -0.5, 0.4, 0.4, 0.5, -0.6]))
    plan.trajectory.to_franka_csv(tmp_path / "motion.csv")
    assert len((tmp_path / "motion.csv").read_text().splitlines()) > 100


@pytest.mark.slow
def test_the_command_lists_what_can_be_had_at_once(capsys, monkeypatch, descriptions, menagerie):
    descriptions(b_description="raise OSError", a_description="")
    monkeypatch.setattr(commands, "load_robot", None)
    assert main(["robots"]) == 0
    shown = capsys.readouterr().out
    assert all(name in shown for name in CATALOG)
    assert "robot_descriptions: 2 names, such as a_description   (--names lists them)" in shown
    assert "MuJoCo Menagerie: 4 names" in shown
    assert main(["robots", "--names"]) == 0
    shown = capsys.readouterr().out
    assert "  b_description" in shown
    assert "  menagerie:hands" in shown
    monkeypatch.delenv("MUJOCO_MENAGERIE")
    monkeypatch.setattr(collections, "find_spec", lambda name: None)
    assert main(["robots"]) == 0
    shown = capsys.readouterr().out
    assert "robot_descriptions: pip install 'manipplan[descriptions]'" in shown
    assert "MuJoCo Menagerie: pip install 'manipplan[menagerie]', or set MUJOCO_MENAGERIE to a checkout" in shown


@pytest.mark.slow
@pytest.mark.parametrize("name", ["pr2_left_arm", "pr2_right_arm", "icub_left_arm", "b1_z1", "ur5_gripper", "anymal_kinova"])
def test_neutral_postures_given_here_are_free(name):
    robot = mp.load_robot(name)
    assert not mp.Scene().in_collision(robot, robot.neutral)


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOG)
def test_the_catalogue_says_what_its_arms_are(name):
    robot, entry = mp.load_robot(name), CATALOG[name]
    assert robot.n == entry.joints
    assert robot.tools == ((entry.tool,) if isinstance(entry.tool, str) else entry.tool)
    for tool in robot.tools:
        arm = robot.arm(tool)
        if arm.n >= 6:
            form = closed_form(arm)
            assert (form.name if form is not None else "newton") == entry.ik
    assert not robot.limits.outside(robot.neutral).any()
