"""The rooms of the house: their list in CONTRIBUTING.md and the folders agree, and imports point up that list."""

import ast
import re
from collections import Counter
from pathlib import Path

import pytest

import manipplan

PACKAGE = Path(manipplan.__file__).parent
CONTRIBUTING = PACKAGE.parent / "CONTRIBUTING.md"
ROOMS = re.findall(r"^\| `(\w+)/` \|", CONTRIBUTING.read_text(), flags=re.MULTILINE)
#: Methods that are conveniences of a value, and import at their call from a room further down.
CONVENIENCES = {
    "robots.robot.Robot.default_task",
    "robots.robot.Robot.kinematics",
    "robots.robot.Robot.self_collisions",
    "support.display.Pictured._repr_html_",
    "plans.result.PartialPlan.save",
    "plans.result.PartialPlan.show",
    "plans.result.PartialPlan.record",
    "programs.program.Program.save",
    "programs.program.Program.show",
    "programs.program.Program.record",
}

#: Benchmarks and studies that import more than public names, each with the reason.
INSIDE = {
    "benchmarks/constant_speed.py": "takes the largest constant speed of a joint path that was chosen without one",
    "benchmarks/inverse_kinematics.py": "counts the poses whose own swivel or held joints are given, in batches",
    "benchmarks/own_configuration.py": "gives the values of the parameters that a configuration has",
    "benchmarks/seeds.py": "takes the times of a search and of its proof apart",
    "studies/dufour2020/figures.py": "renders the arm with its meshes at single postures",
}


def name_of(file):
    parts = file.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(file): file for file in sorted(PACKAGE.rglob("*.py"))}


def imported(node):
    """The modules of the package that one import statement names."""
    if isinstance(node, ast.Import):
        return [each.name for each in node.names if each.name in MODULES]
    if isinstance(node, ast.ImportFrom) and node.module in MODULES:
        below = [f"{node.module}.{each.name}" for each in node.names]
        return [each if each in MODULES else node.module for each in below]
    return []


def imports(module):
    """Each import of a module: what is imported, and the function it is in; "" at import time. Those for types are left out."""
    found = []

    def visit(node, function, name):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.If) and ast.unparse(child.test) == "TYPE_CHECKING":
                continue
            inner, named = function, name
            if isinstance(child, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
                named = f"{name}.{child.name}".lstrip(".")
                inner = function if isinstance(child, ast.ClassDef) else named
            found.extend((each, function) for each in imported(child))
            visit(child, inner, named)

    visit(ast.parse(MODULES[module].read_text()), "", "")
    return found


def room_of(module):
    room = module.split(".")[1] if "." in module else ""
    return room if room in ROOMS else ""


def points_down(module, target):
    """Whether an import goes to a room further down the list."""
    rooms = room_of(module), room_of(target)
    return rooms[0] != rooms[1] and all(rooms) and ROOMS.index(rooms[1]) > ROOMS.index(rooms[0])


def test_contributing_lists_the_rooms():
    folders = {each.name for each in PACKAGE.iterdir() if (each / "__init__.py").is_file()}
    assert folders == set(ROOMS) and len(ROOMS) == len(set(ROOMS))
    assert {each.name for each in PACKAGE.glob("*.py")} == {"__init__.py", "__main__.py", "errors.py", "results.py"}


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_says_what_it_is_for(room):
    assert ast.get_docstring(ast.parse((PACKAGE / room / "__init__.py").read_text()))


@pytest.mark.slow
@pytest.mark.parametrize("module", MODULES)
def test_imports_point_up_the_list(module):
    assert not [target for target, function in imports(module) if function == "" and points_down(module, target)]


@pytest.mark.slow
def test_conveniences_alone_import_from_further_down():
    found = {
        f"{module.removeprefix('manipplan.')}.{function}"
        for module in MODULES
        for target, function in imports(module)
        if function and points_down(module, target)
    }
    assert found == CONVENIENCES


@pytest.mark.slow
def test_there_is_no_circle_at_import_time():
    needs = {
        module: {target for target, function in imports(module) if function == "" and target != module} for module in MODULES
    }
    left = {module for module in MODULES if module != "manipplan"}
    while ready := {module for module in left if not needs[module] & left}:
        left -= ready
    assert not left


@pytest.mark.slow
def test_no_class_name_stands_twice():
    """One name has one meaning, with or without an underscore in front."""
    names = Counter(
        node.name.lstrip("_")
        for file in MODULES.values()
        for node in ast.parse(file.read_text()).body
        if isinstance(node, ast.ClassDef)
    )
    assert [name for name, count in names.items() if count > 1] == []


def not_public(file):
    """What a script imports from the package besides public names."""
    found = []
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            found += [each.name for each in node.names if each.name.startswith("manipplan.")]
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "manipplan":
            public = manipplan
            for name in node.module.split(".")[1:]:
                public = getattr(public, name) if name in getattr(public, "__all__", ()) else None
            found += [f"{node.module}.{each.name}" for each in node.names if each.name not in getattr(public, "__all__", ())]
    return found


@pytest.mark.slow
def test_benchmarks_and_studies_import_public_names_only():
    root = PACKAGE.parent
    found = {
        file.relative_to(root).as_posix()
        for place in ("benchmarks", "studies")
        for file in (root / place).rglob("*.py")
        if not_public(file)
    }
    assert found == set(INSIDE)
