"""The files of this package on which a module depends, read from its imports without running it."""

import ast
from collections.abc import Collection, Iterator
from pathlib import Path


def import_closure(file: Path, root: Path, *, leaves: Collection[Path] = ()) -> frozenset[Path]:
    """`file` and all files of the package in folder `root` that are needed to import it.

    Imports inside functions or only for type checkers do not count: they set no value of the module. `leaves` belong to the
    closure, but their imports do not.
    """
    found: set[Path] = set()
    waiting = [file]
    while waiting:
        each = waiting.pop()
        if each not in found:
            found.add(each)
            if each not in leaves:
                waiting += _imported(each, root)
    return frozenset(found)


def _imported(file: Path, root: Path) -> list[Path]:
    """The files of the package that `file` itself imports."""
    package = [root.name, *file.parent.relative_to(root).parts]
    names: list[list[str]] = []
    for statement in _at_import(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(statement, ast.Import):
            names += [each.name.split(".") for each in statement.names]
        elif isinstance(statement, ast.ImportFrom):
            above = package[: len(package) + 1 - statement.level] if statement.level else []
            module = [*above, *(statement.module.split(".") if statement.module else ())]
            names += [module, *([*module, each.name] for each in statement.names)]
    files = [_file_of(name, root) for name in names]
    return [each for each in files if each is not None]


def _at_import(node: ast.AST) -> Iterator[ast.AST]:
    """All statements below `node` that run while the module is imported."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            continue
        if isinstance(child, ast.If) and ast.unparse(child.test) in ("TYPE_CHECKING", "typing.TYPE_CHECKING"):
            child = ast.Module(body=child.orelse, type_ignores=[])  # noqa: PLW2901
        yield child
        yield from _at_import(child)


def _file_of(name: list[str], root: Path) -> Path | None:
    """The file of a module or package of the package `root`; None for anything else."""
    if name[0] != root.name:
        return None
    place = root.joinpath(*name[1:])
    return next((each for each in (place.with_suffix(".py"), place / "__init__.py") if each.is_file()), None)
