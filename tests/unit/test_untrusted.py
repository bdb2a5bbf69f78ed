"""Names from files hold anything; what they reach takes them as text: C source, exported C, pages, terminals."""

import ctypes
import html
import io
import logging
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

import manipplan as mp
from manipplan import cli
from manipplan.cli import terminal
from manipplan.kinematics import batch
from manipplan.optimize.clearance import row_functions
from manipplan.support import compiler
from manipplan.support.compiler import find_compiler, load_library
from manipplan.support.errors import ManipplanError
from manipplan.support.untrusted import KEYWORDS, LONGEST, identifier, is_identifier, printable
from manipplan.symbolic import machine_code
from manipplan.symbolic.machine_code import generate_source
from manipplan.tracking import export

#: A C function that creates the file @MARK@ as soon as a library that holds it is loaded.
BOOBY_TRAP = '\n#include <stdio.h>\n__attribute__((constructor)) static void trap(void) { fclose(fopen("@MARK@", "w")); }\n'
HOSTILE = {
    "the end of a comment": f"*/{BOOBY_TRAP}/*",
    "the end of a string": f'";{BOOBY_TRAP}//',
    "a line end": f"arm{BOOBY_TRAP}",
    "a line that goes on": "arm\\",
    "a trigraph": "arm??/",
    "formats": "%s%n%99999d{}{0}@ROBOT@@DT@",
    "backticks": "`touch @MARK@`",
    "a command": "$(touch @MARK@); touch @MARK@ #",
    "a script": "</script></title><script>document.title='@MARK@'</script><img src=x onerror=alert(1)>",
    "Markdown": "**[x](javascript:alert(1))** {alert(1)}",
    "rich's markup": "[red]arm[/red] [/] [link=file:///etc/passwd]x[/link] :warning:",
    "a keyword": "int",
    "a digit": "7",
    "letters of another alphabet": "λ",
    "a control character": "arm\x9b2J\u202e",
    "a path": "../../etc/passwd",
    "an option": "-o@MARK@",
    "many characters": "a" * 5000,
}
#: Those that a compiler sees in the tests; the text of exported C, which is the same, is compared for all.
COMPILED = ("the end of a comment", "the end of a string", "a line end", "a line that goes on", "a trigraph", "a command")
DT = 0.01


def urdf(name, folder):
    """A planar arm of three bodies; `name` is part of every name in it."""
    root = ET.Element("robot", name=name)
    links = [f"{name}L{k}" for k in range(4)]
    for each in links:
        collision = ET.SubElement(ET.SubElement(root, "link", name=each), "collision", name=f"{each}C")
        ET.SubElement(collision, "origin", xyz="0.2 0 0")
        ET.SubElement(ET.SubElement(collision, "geometry"), "box", size="0.3 0.05 0.05")
    for k in range(3):
        joint = ET.SubElement(root, "joint", name=f"{name}J{k}", type="revolute")
        ET.SubElement(joint, "parent", link=links[k])
        ET.SubElement(joint, "child", link=links[k + 1])
        ET.SubElement(joint, "origin", xyz="0.4 0 0")
        ET.SubElement(joint, "axis", xyz="0 0 1")
        ET.SubElement(joint, "limit", lower="-2", upper="2", velocity="1", effort="10")
    return _written(root, folder / "arm.urdf")


def mjcf(name, folder):
    """The same in MuJoCo's format."""
    root = ET.Element("mujoco", model=name)
    parent = ET.SubElement(root, "worldbody")
    for k in range(3):
        parent = ET.SubElement(parent, "body", name=f"{name}B{k}", pos="0.4 0 0")
        ET.SubElement(parent, "joint", name=f"{name}J{k}", type="hinge", axis="0 0 1", range="-100 100")
        ET.SubElement(parent, "geom", name=f"{name}G{k}", type="capsule", size="0.05", fromto="0 0 0 0.3 0 0")
    return _written(root, folder / "arm.xml")


def _written(root, file):
    ET.ElementTree(root).write(file, encoding="utf-8", xml_declaration=True)
    return file


def loaded(make, name, tmp_path):
    """The robot whose names hold `name`, and the file that would give an injection away."""
    mark = tmp_path / "mark"
    robot = mp.load_robot(str(make(name.replace("@MARK@", str(mark)), tmp_path)))
    return robot.with_limits(velocity=1.0, acceleration=8.0), mark


def avoiding(robot, scene, compiled):
    """A controller that keeps the arm away from itself and from one moving obstacle."""
    avoidance = mp.Avoidance(scene=scene, moving=list(scene.names), itself=True)
    return mp.Controller(
        robot, mp.formulations.LogDrive(), dt=DT, task=mp.Task.planar(), avoidance=avoidance, compiled=compiled
    )


def scene_of(name):
    return mp.Scene([mp.Sphere(radius=0.05, position=(0.0, 2.0, 0.0), name=f"{name}O")])


@pytest.fixture
def compiled_sources(monkeypatch):
    """Everything that is compiled from now on: (source, options)."""
    seen = []

    def remember(source, load, **options):
        seen.append((source, options.get("flags")))
        return load_library(source, load, **options)

    for module in (compiler, machine_code, batch, export):
        monkeypatch.setattr(module, "load_library", remember)
    return seen


def all_machine_code(robot, name):
    """Build all that is compiled for a robot."""
    q = np.array([0.3, 0.5, 0.7])
    kinematics = robot.kinematics(mp.Task.planar(), compiled=True)
    kinematics.evaluator("pose", "jacobian", "manipulability", "gradient", "hessian")(q)
    kinematics.jacobian(np.tile(q, (3, 1)))
    row_functions(kinematics)
    controller = avoiding(robot, scene_of(name), compiled=True)
    assert controller.compiled
    controller.step(q, np.zeros(3), kinematics.pose(q))


def without_name(text, name):
    """The text with the whitelisted name taken out."""
    return text.replace(f'"{identifier(name)}"', '"arm"')


@pytest.mark.compiler
def test_the_trap_works(tmp_path):
    """What the tests below would miss if the trap never sprang: a name in a comment, as text, runs code."""
    mark = tmp_path / "mark"
    source = f"/* {HOSTILE['the end of a comment'].replace('@MARK@', str(mark))} */ int answer(void) {{ return 42; }}"
    load_library(source, lambda file: ctypes.CDLL(str(file)), subject="a test")
    assert mark.exists()


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("make", [urdf, mjcf])
def test_compiled_code_is_that_of_a_harmless_name(make, tmp_path, compiled_sources):
    benign, _ = loaded(make, "arm", tmp_path)
    all_machine_code(benign, "arm")
    expected = list(compiled_sources)
    assert len(expected) >= 5
    for kind in COMPILED:
        name = HOSTILE[kind]
        compiled_sources.clear()
        robot, mark = loaded(make, name, tmp_path)
        assert robot.joint_names[0].startswith(name.replace("@MARK@", str(mark)))
        all_machine_code(robot, name)
        for (source, flags), (harmless, harmless_flags) in zip(compiled_sources, expected, strict=True):
            assert without_name(source, robot.name) == harmless, kind
            assert flags == harmless_flags, kind
        assert not mark.exists(), kind


@pytest.mark.slow
@pytest.mark.parametrize("make", [urdf, mjcf])
def test_exported_c_is_that_of_a_harmless_name(make, tmp_path):
    def exported(name, folder):
        robot, mark = loaded(make, name, tmp_path)
        files = avoiding(robot, scene_of(name), compiled=False).export_c(tmp_path / folder)
        texts = {each.name: each.read_text() for each in files if each.suffix != ".a"}
        return {key: without_name(text, robot.name) for key, text in texts.items()}, mark

    expected, _ = exported("arm", "benign")
    for kind, name in HOSTILE.items():
        found, mark = exported(name, "hostile")
        assert found == expected, kind
        assert not mark.exists(), kind
    for text in expected.values():
        assert not [comment for comment in re.findall(r"/\*.*?\*/", text, re.DOTALL) if '"arm"' in comment]


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("kind", ["the end of a comment", "a trigraph", "a line that goes on"])
def test_exported_c_of_a_hostile_name_compiles_and_runs(tmp_path, kind):
    robot, mark = loaded(urdf, HOSTILE[kind], tmp_path)
    folder = tmp_path / "exported"
    avoiding(robot, scene_of(HOSTILE[kind]), compiled=False).export_c(folder)
    flags = ("-std=c99", "-Wall", "-Wextra", "-Wno-unused", "-Werror", "-trigraphs", "-I.", "-Iinclude")
    files = ("example.c", "controller.c", "step.c", "lib/libdaqpstat.a", "-lm")
    for command in ([*find_compiler(), *flags, *files, "-o", "example"], ["./example"]):
        subprocess.run(command, cwd=folder, check=True, capture_output=True, timeout=300)
    assert not mark.exists()


def test_a_function_whose_names_are_no_identifiers_is_refused():
    """CasADi checks names of Functions, but not those of their arguments, which it writes to C as they are."""
    import casadi as ca

    x = ca.SX.sym("x")
    for inputs, outputs in ((['"; int y; "'], ["y"]), (["x"], ["a*/b"]), (["int"], ["y"])):
        with pytest.raises(ManipplanError, match="not an identifier"):
            generate_source([ca.Function("f", [x], [x], inputs, outputs)])


# ---- the whitelist itself


@pytest.mark.parametrize("name", [*HOSTILE.values(), "", "_", "__x__", "7up", "int_", "lambda", "a" * 62 + "_b"])
def test_an_identifier_is_one_in_every_language(name):
    made = identifier(name)
    assert re.fullmatch("[A-Za-z][A-Za-z0-9_]*", made, re.ASCII)
    assert len(made) <= LONGEST
    assert made not in KEYWORDS
    assert made.isidentifier() and "__" not in made
    assert identifier(made) == made


def test_a_harmless_name_stays_what_it_is():
    for name in ("panda", "ur5_robot", "a1", "x" * LONGEST):
        assert is_identifier(name)
        assert identifier(name) == name
    assert identifier("talos-right arm") == "talos_right_arm"
    assert printable("a λ °\tb\nc") == "a λ °\tb\nc"
    assert printable("a\x1b[2J\x9b\u202e") == "a\\x1b[2J\\x9b\\u202e"


# ---- terminals and pages


@pytest.mark.parametrize("kind", HOSTILE)
def test_a_terminal_shows_names_as_they_are(kind, tmp_path, monkeypatch):
    name = HOSTILE[kind]
    for is_terminal in (True, False):
        out = io.StringIO()
        console = Console(file=out, force_terminal=is_terminal, color_system=None, width=10_000)
        terminal.show_line(console, f"{name} end")
        assert out.getvalue() == f"{printable(name)} end\n"

        out = io.StringIO()
        monkeypatch.setattr(terminal, "Console", lambda stderr, out=out, t=is_terminal: Console(file=out, force_terminal=t))
        with terminal.progress() as notify:
            notify(0.5, f"{name} now")
        words = printable(name).split()[:1] if len(name) < 60 else []
        assert all(word in out.getvalue() for word in words)
        assert "\x9b" not in out.getvalue() and "\u202e" not in out.getvalue()


def test_commands_print_names_as_they_are(tmp_path, capsys):
    for kind in ("rich's markup", "a control character", "formats"):
        robot, _ = loaded(urdf, HOSTILE[kind], tmp_path)
        assert cli.main(["robots", str(tmp_path / "arm.urdf")]) == 0
        assert printable(robot.name) in capsys.readouterr().out
        obstacle = tmp_path / "nothing" / HOSTILE[kind].replace("/", "|")
        assert cli.main(["view", str(obstacle)]) == 2
        assert not set(capsys.readouterr().err) & {"\x9b", "\u202e"}


@pytest.mark.slow
def test_the_log_of_a_command_shows_control_characters_as_escapes():
    code = (
        "import logging, manipplan.cli as cli\n"
        "cli.COMMANDS['robots'] = lambda: logging.getLogger('manipplan').warning('arm\\x1b[2J\\x9b') or 0\n"
        "cli.main(['robots'])"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True)
    assert run.stderr.decode() == "arm\\x1b[2J\\x9b\n"
    assert logging.getLogger("manipplan").name == "manipplan"


def straight_plan(robot, scene):
    """The plan of a plain arm, given to a robot some of whose joint names are refused in a motion."""
    arm = mp.planar_arm([0.4, 0.4, 0.4])
    plan = mp.plan(arm, [0.1, 0.2, 0.3], [0.6, 0.5, 0.4], shape=mp.PathShape(degree=1))
    return replace(plan, robot=robot, scene=scene)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["a script", "the end of a string"])
def test_pages_show_names_as_text(kind, tmp_path):
    from manipplan.viz.motions import ShownMotion
    from manipplan.viz.viewer.plan_viewer import about

    robot, mark = loaded(urdf, HOSTILE[kind], tmp_path)
    plan = straight_plan(robot, scene_of(HOSTILE[kind].replace("@MARK@", str(mark))))
    page = Path(plan.record(tmp_path / "page.html")).read_text()
    for text in (page, about(ShownMotion.of(plan))):
        assert html.escape(robot.name) in text
        assert robot.name not in text
        assert "<script>document" not in text and "<img src=x" not in text


@pytest.mark.slow
def test_the_viewer_takes_no_markdown_with_names(tmp_path, monkeypatch):
    """viser renders HTML and links in Markdown."""
    import viser

    robot, _ = loaded(urdf, HOSTILE["Markdown"], tmp_path)
    plan = straight_plan(robot, mp.Scene())
    shown = []
    for name in ("add_markdown", "add_html"):
        add = getattr(viser.GuiApi, name)
        monkeypatch.setattr(
            viser.GuiApi, name, lambda gui, text, add=add, name=name: shown.append((name, text)) or add(gui, text)
        )
    with plan.show(port=0, open_browser=False):
        assert {name for name, text in shown if robot.name in text} == {"add_html"}
