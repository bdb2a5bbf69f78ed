"""Expands a xacro file in a process of its own: see `urdf_files`, which starts it.

The library xacro keeps its state in module variables and evaluates expressions by Python's `eval`; what it forbids there is
easily avoided, for instance inside a lambda. Here, unless the file is trusted, `evaluate` evaluates them instead (arithmetic,
text, lists, mappings, known functions; there is no way to attributes such as `__class__` or `__globals__`, from which a file
could reach the rest of Python), files are read from known folders only, and environment variables are not read.

The process runs with an empty package `manipplan`: this module and what it imports need nothing but the standard library.
"""

import ast
import operator
import os
import re
from collections import ChainMap
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from manipplan.robots.packages import PackageFolders
from manipplan.support.commands import request_in, set_limits, write_answer


class RefusedError(Exception):
    """A file wants something that is done only for a file that the user trusts."""


OPERATORS: Mapping[type[ast.AST], Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
    ast.Not: operator.not_,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
    ast.In: lambda part, whole: part in whole,
    ast.NotIn: lambda part, whole: part not in whole,
}
_ANY_SEQUENCE = frozenset({"count", "index"})
_TEXT = """
    capitalize endswith find isalnum isalpha isdigit join lower lstrip removeprefix removesuffix replace rfind rstrip split
    splitlines startswith strip title upper zfill
"""
#: Methods that expressions may call. `format` is not one of them: its fields reach attributes.
METHODS: Mapping[type, frozenset[str]] = {
    str: _ANY_SEQUENCE | set(_TEXT.split()),
    dict: frozenset({"get", "items", "keys", "values"}),
    list: _ANY_SEQUENCE,
    tuple: _ANY_SEQUENCE,
    float: frozenset({"is_integer"}),
}


def evaluate(text: str, names: Mapping[str, Any]) -> Any:
    """The value of a Python expression. It may call every function in `names`, or in a mapping of it.

    Raises RefusedError where it contains something that is not evaluated here, such as `lambda`, or an attribute that is no
    method of `METHODS` and no key of a mapping; and whatever the operation itself raises.
    """
    return _value(ast.parse(text.strip(), mode="eval").body, names)


def _value(node: ast.expr, names: Mapping[str, Any]) -> Any:
    match node:
        case ast.Constant(value=value):
            return value
        case ast.Name(id=name):
            return _look_up(name, names)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            return OPERATORS[type(op)](_value(left, names), _value(right, names))
        case ast.UnaryOp(op=op, operand=operand) if type(op) in OPERATORS:
            return OPERATORS[type(op)](_value(operand, names))
        case ast.BoolOp(op=op, values=values):
            value = None
            for each in values:
                value = _value(each, names)
                if bool(value) == isinstance(op, ast.Or):
                    break
            return value
        case ast.Compare(left=left, ops=ops, comparators=others):
            first, result = _value(left, names), True
            for comparison, other in zip(ops, others, strict=True):
                second = _value(other, names)
                result = OPERATORS[type(comparison)](first, second)
                if not result:
                    break
                first = second
            return result
        case ast.IfExp(test=test, body=body, orelse=other):
            return _value(body if _value(test, names) else other, names)
        case ast.Subscript(value=whole, slice=part):
            return _value(whole, names)[_value(part, names)]
        case ast.Slice(lower=lower, upper=upper, step=step):
            return slice(*(None if each is None else _value(each, names) for each in (lower, upper, step)))
        case ast.Attribute(value=whole, attr=name):
            return _attribute(_value(whole, names), name)
        case ast.Call(func=function, args=arguments, keywords=keywords):
            given = {each.arg: _value(each.value, names) for each in keywords if each.arg is not None}
            if len(given) < len(keywords):
                raise _refusal("**")
            return _value(function, names)(*_items(arguments, names), **given)
        case ast.List(elts=items):
            return _items(items, names)
        case ast.Tuple(elts=items):
            return tuple(_items(items, names))
        case ast.Set(elts=items):
            return set(_items(items, names))
        case ast.Dict(keys=keys, values=values) if None not in keys:
            pairs = zip(keys, values, strict=True)
            return {_value(key, names): _value(value, names) for key, value in pairs if key is not None}
        case ast.ListComp(elt=item) | ast.GeneratorExp(elt=item):
            return [_value(item, inner) for inner in _loops(node.generators, names)]
        case ast.SetComp(elt=item):
            return {_value(item, inner) for inner in _loops(node.generators, names)}
        case ast.DictComp(key=key, value=item):
            return {_value(key, inner): _value(item, inner) for inner in _loops(node.generators, names)}
        case ast.JoinedStr(values=parts):
            return "".join(str(_value(each, names)) for each in parts)
        case ast.FormattedValue(value=part, conversion=-1, format_spec=form):
            return format(_value(part, names), "" if form is None else _value(form, names))
    raise _refusal("lambda" if isinstance(node, ast.Lambda) else ast.unparse(node))


def _refusal(what: str) -> RefusedError:
    return RefusedError(f"{what} is evaluated only if trust_file=True, because it could run any code")


def _items(items: list[ast.expr], names: Mapping[str, Any]) -> list[Any]:
    values: list[Any] = []
    for each in items:
        values += _value(each.value, names) if isinstance(each, ast.Starred) else [_value(each, names)]
    return values


def _look_up(name: str, names: Mapping[str, Any]) -> Any:
    if name.startswith("__"):
        raise _refusal(name)
    try:
        return names[name]
    except KeyError:
        raise NameError(f"name {name!r} is not defined") from None


def _attribute(whole: Any, name: str) -> Any:
    """A method of `METHODS`, or the value under a key of one of xacro's mappings, which have dotted access."""
    if any(isinstance(whole, kind) and name in methods for kind, methods in METHODS.items()):
        return getattr(whole, name)
    if isinstance(whole, dict) and type(whole) is not dict and not name.startswith("_"):
        try:
            return whole[name]
        except KeyError:
            raise NameError(f"name {name!r} is not defined") from None
    raise _refusal(f"the attribute {name!r}")


def _loops(loops: list[ast.comprehension], names: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    """The names inside the loops of a comprehension, in each round."""
    if not loops:
        yield names
        return
    first, *others = loops
    for item in _value(first.iter, names):
        inner = ChainMap(_assign(first.target, item), names)  # type: ignore[arg-type]  # only the first is written
        if all(_value(test, inner) for test in first.ifs):
            yield from _loops(others, inner)


def _assign(target: ast.expr, item: Any) -> dict[str, Any]:
    match target:
        case ast.Name(id=name):
            return {name: item}
        case ast.Tuple(elts=parts) | ast.List(elts=parts) if not any(isinstance(each, ast.Starred) for each in parts):
            pairs = zip(parts, item, strict=True)
            return {name: value for part, each in pairs for name, value in _assign(part, each).items()}
    raise _refusal(ast.unparse(target))


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
