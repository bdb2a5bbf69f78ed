"""Expands a xacro file in a process of its own: see `urdf_files`, which starts it.

The library xacro keeps its state in module variables and evaluates expressions by Python's `eval`; what it forbids there is
easily avoided, for instance inside a lambda. Here, unless the file is trusted, `expressions` evaluates them instead, files are
read from known folders only, and environment variables are not read.

The process runs with an empty package `manipplan`: this module and what it imports need nothing but the standard library.
"""

import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from manipplan.robots.formats.expressions import RefusedError, evaluate
from manipplan.robots.formats.packages import PackageFolders
from manipplan.support.commands import request_in, set_limits, write_answer

#: Maximum number of files that include one another in a row.
DEEPEST = 50
#: Use of an argument; the beginning of an expression; number of arguments that a message lists.
USE, EXPRESSION, SHOWN = re.compile(r"\$\(arg\s+([^\s()]+)\s*\)"), "$", 8
#: Largest memory of this process [bytes].
MEMORY = 2**30
#: Largest URDF [characters], and largest file that may be written, with a URDF or with messages [bytes].
LARGEST, WRITTEN = 100_000_000, 2**30
#: What is replaced in the library. Another version may lack it: then nothing is expanded.
REPLACED = {
    "xacro": ("parse", "safe_eval", "eval_text", "process_file", "filestack", "_global_symbols", "Table"),
    "xacro.substitution_args": ("_eval", "_eval_env", "_eval_optenv", "_eval_find", "_eval_dict", "convert_value"),
}
UNSUPPORTED = "this version of xacro is not supported, install another with: pip install 'manipplan[xacro]'"
#: Texts that have to be refused before an untrusted file is read: they prove that the replacements take effect.
PROBES = ("${(lambda: 1)()}", "${().__class__}", "$(eval [].__class__)", "$(env PATH)", "$(optenv PATH)")
PROBE_FILE = "${xacro.load_yaml('/')}"


class Arguments(dict[str, str]):
    """Values of the arguments by name, the names for which the files ask, and what the files say about them.

    An argument that is used before the line with its default, as in the name of the robot, has that default.
    """

    def __init__(self, given: Mapping[str, str]) -> None:
        super().__init__(given)
        self.known: set[str] = set()
        self.defaults: dict[str, str] = {}
        self.used: dict[str, None] = {}

    def __getitem__(self, name: str) -> str:
        if name not in self and EXPRESSION not in (default := self.defaults.get(name, EXPRESSION)):
            self[name] = default
        value = super().__getitem__(name)
        self.known.add(name)
        return value

    def read(self, document: Any) -> None:
        """Note the arguments of a file; one without a default is needed where it is reached, also if nothing uses it."""
        for each in document.getElementsByTagName("xacro:arg"):
            name = each.getAttribute("name")
            self.known.add(name)
            if each.hasAttribute("default"):
                self.defaults.setdefault(name, each.getAttribute("default"))
            else:
                each.setAttribute("default", f"$(arg {name})")
        for element in document.getElementsByTagName("*"):
            texts = [value for _, value in element.attributes.items()]
            texts += [node.data for node in element.childNodes if node.nodeType == node.TEXT_NODE]
            self.used |= dict.fromkeys(name for text in texts for name in USE.findall(text))

    def without_value(self, name: str) -> str:
        """The error for an argument without a value; it names the others to which the same applies."""
        names = [name, *(each for each in self.used if each not in self and each not in self.defaults and each != name)]
        shown = ", ".join(map(repr, names[:SHOWN]))
        call = ", ".join(f"{each!r}: ..." for each in names[:SHOWN])
        what = f"arguments {shown} have" if len(names) > 1 else f"argument {shown} has"
        return f"the {what} no value; give it in arguments={{{call}}}"

    def in_path(self, path: str) -> str:
        """The plain defaults of which the name of a missing file may be made, as text."""
        plain = [name for name, text in self.defaults.items() if EXPRESSION not in text and self.get(name) == text]
        return ", ".join(f"{name}={self[name]!r}" for name in plain if self[name] in path)


def main(folder: str) -> None:
    """Expand the file of the request in `folder`; the answer is the URDF, or the error."""
    request = request_in(folder)
    set_limits(memory=MEMORY, written=WRITTEN, processor=request["processor"])
    write_answer(folder, expanded(request))


def expanded(request: Mapping[str, Any]) -> dict[str, Any]:
    """The URDF and the names of the arguments, or an error and the files and macros in which it occurred."""
    import xacro

    packages = {name: Path(folder) for name, folder in request["packages"].items()}
    package_dirs = [Path(folder) for folder in request["package_dirs"]]
    folders = PackageFolders(file=Path(request["file"]), packages=packages, package_dirs=package_dirs)
    arguments = Arguments(request["arguments"])
    try:
        _replace(folders, arguments, trust=request["trust"])
        urdf = xacro.process_file(request["file"], mappings=arguments).toxml()
    except RecursionError:
        return {"error": "a macro or an include that calls itself without end", "where": _where(xacro)}
    except Exception as error:
        reason, cause = _reason(error)
        if type(cause).__name__ == "ArgException":
            reason = arguments.without_value(str(cause))
        elif isinstance(cause, FileNotFoundError) and (values := arguments.in_path(str(cause.filename))):
            reason += f"; give other values in arguments= than {values}"
        if isinstance(cause, RecursionError):
            reason = "an expression that is nested too deeply, or calls itself"
        if isinstance(cause, MemoryError):
            reason = f"it needs more than {MEMORY / 2**30:g} GiB of memory"
        return {"error": reason, "where": _where(xacro)}
    if len(urdf) > LARGEST:
        return {"error": f"it expands to more than {LARGEST:,} characters", "where": []}
    return {"urdf": urdf, "arguments": sorted(arguments.known)}


def _replace(folders: PackageFolders, arguments: Arguments, *, trust: bool) -> None:
    import xacro
    from xacro import substitution_args

    for module in (xacro, substitution_args):
        missing = [name for name in REPLACED[module.__name__] if not hasattr(module, name)]
        if missing:
            raise RuntimeError(f"{UNSUPPORTED}; it has no {', '.join(missing)}")
    parse = xacro.parse

    def parse_and_note(text: Any, filename: str | None = None) -> Any:
        if len(xacro.filestack) > DEEPEST:
            xacro.filestack[2:] = []
            raise RecursionError
        document = parse(text, filename)
        arguments.read(document)
        return document

    def find(name: str) -> str:
        folder = folders.find(name)
        if folder is None:
            raise FileNotFoundError(f"the package {name!r} is not found; give its folder: packages={{{name!r}: folder}}")
        return str(folder)

    xacro.parse = parse_and_note
    substitution_args._eval_find = substitution_args._eval_dict["find"] = find
    if trust:
        return

    def open_known(path: str, *_: Any, **__: Any) -> Any:
        if not folders.may_read(Path(path)):
            wanted = "give its folder in packages= or package_dirs=, or trust_file=True"
            raise RefusedError(f"{os.path.normpath(path)} is outside the folders that may be read; {wanted}")
        if Path(path).exists() and not Path(path).is_file():
            raise RefusedError(f"{path} is not a plain file")
        return Path(path).open(encoding="utf-8")  # xacro closes it

    def refuse_variable(name: str, *_: str, **__: str) -> str:
        raise RefusedError(f"the environment variable {name} is read only if trust_file=True; an argument can replace it")

    def evaluate_extension(text: str, _: Any) -> str:
        values = {name: substitution_args.convert_value(value, "auto") for name, value in arguments.items()}
        known = {"true": True, "false": False, "str": str, "float": float, "int": int, "list": list, "dict": dict, "map": map}
        known |= {"find": find, "env": refuse_variable, "optenv": refuse_variable}
        known["arg"] = lambda name: substitution_args.convert_value(arguments[name], "auto")
        return str(evaluate(text, {**values, **xacro._global_symbols["math"], **known}))

    xacro.open = open_known
    xacro.safe_eval = evaluate
    substitution_args._eval = evaluate_extension
    substitution_args._eval_env = substitution_args._eval_optenv = refuse_variable
    for name in ("vars", "type"):  # from these, expressions could reach what the attributes of an object hide
        dict.pop(xacro._global_symbols["python"], name, None)
    for probe in (*PROBES, PROBE_FILE):
        try:
            xacro.eval_text(probe, xacro.Table(xacro._global_symbols))
        except Exception as error:
            if isinstance(_reason(error)[1], RefusedError):
                continue
        raise RuntimeError(f"{UNSUPPORTED}; it does not refuse {probe}")


def _reason(error: BaseException) -> tuple[str, BaseException]:
    """What went wrong, in one line, and its cause: the library wraps one exception into another."""
    suffix = ""
    while isinstance(inner := getattr(error, "exc", None), BaseException):
        suffix = getattr(error, "suffix", None) or suffix
        error = inner
    text = str(error) or type(error).__name__
    if isinstance(error, KeyError):
        text = f"there is no {text}"
    return " ".join(f"{text} {suffix}".split()), error


def _where(xacro: Any) -> list[str]:
    """The files, from the one that was given to the one at fault, and then the macros."""
    files = [os.path.normpath(each) for each in xacro.filestack or () if each]
    macros = [f"macro {each.body.getAttribute('name')}" for each in xacro.macrostack or ()]
    return files[-3:] + macros[-3:]
