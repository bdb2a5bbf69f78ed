"""Expressions of a xacro file, evaluated without Python's `eval`: arithmetic, text, lists, mappings, known functions.

There is no way to attributes such as `__class__` or `__globals__`, from which a file could reach the rest of Python.
"""

import ast
import operator
from collections import ChainMap
from collections.abc import Callable, Iterator, Mapping
from typing import Any


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
    """The value of an expression.

    Args:
        text: a Python expression.
        names: values and functions by name. Expressions may call every function that is in it, or in a mapping of it.

    Raises:
        RefusedError: it contains something that is not evaluated here, such as `lambda`, or an attribute that is no method of
            `METHODS` and no key of a mapping.
        Exception: what the operation itself raises: SyntaxError, NameError, TypeError, ZeroDivisionError, ...
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
