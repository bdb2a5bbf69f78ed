"""YAML files from untrusted sources: no repeated key, no value that contains itself, bounds on depth and size."""

from pathlib import Path
from typing import Any

import yaml
from yaml.composer import Composer

from manipplan.support.errors import FileFormatError

#: Maximum depth of nested values, and maximum number of values, with those of every alias counted again.
DEEPEST, MOST = 100, 10_000_000

_Base: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # in C where available


def read_yaml(argument: str, path: Path) -> Any:
    """The value of a YAML file.

    Raises FileFormatError when it is not YAML in UTF-8, a key is repeated in a mapping, a value contains itself, or it is
    nested too deeply or too large.
    """
    try:
        return yaml.load(path.read_text(encoding="utf-8"), Loader=_Loader)
    except yaml.YAMLError as error:
        reason = " ".join(str(error).replace('"<unicode string>", ', "").split())
    except UnicodeDecodeError as error:
        reason = f"in UTF-8; {error}"
    except (ValueError, ArithmeticError, LookupError, AttributeError, TypeError) as error:  # no such date or number
        reason = " ".join(str(error).split())
    except OSError as error:
        reason = str(error.strerror)
    raise FileFormatError(argument, str(path), f"YAML ({reason})")


class _Bounded(Composer):
    """Composes nodes within the bounds.

    Attributes:
        open: anchor, or None, of every value that contains the next one.
        sizes: number of values under each anchor.
        count: number of values so far.
    """

    open: list[str | None]
    sizes: dict[str | None, int]
    count: int

    def compose_node(self, parent: Any, index: Any) -> Any:
        event = self.peek_event()  # type: ignore[attr-defined]  # a method of the parser
        if isinstance(event, yaml.AliasEvent):
            if event.anchor in self.open:
                raise _error(f"the value of *{event.anchor} contains itself", event)
            self.count += self.sizes.get(event.anchor, 0)
        self.count += 1
        if self.count > MOST:
            raise _error(f"more than {MOST:,} values, counting those of aliases", event)
        if len(self.open) >= DEEPEST:
            raise _error(f"values nested more than {DEEPEST} deep", event)
        before = self.count
        self.open.append(None if isinstance(event, yaml.AliasEvent) else event.anchor)
        node = super().compose_node(parent, index)
        anchor = self.open.pop()
        if anchor is not None:
            self.sizes[anchor] = self.count - before
        return node

    def compose_mapping_node(self, anchor: Any) -> Any:
        node = super().compose_mapping_node(anchor)
        lines: dict[tuple[str, str], int] = {}
        for key, _ in node.value:
            if isinstance(key, yaml.ScalarNode):
                line = key.start_mark.line + 1
                if (key.tag, key.value) in lines:
                    raise _error(f"the key {key.value!r} of line {lines[key.tag, key.value]} is repeated", key)
                lines[key.tag, key.value] = line
        return node


class _Loader(_Bounded, _Base):  # type: ignore[misc]  # the base is chosen at run time
    def __init__(self, stream: Any) -> None:
        _Base.__init__(self, stream)
        self.anchors: dict[str, Any] = {}
        self.open, self.sizes, self.count = [], {}, 0


def _error(problem: str, event: Any) -> yaml.YAMLError:
    return yaml.composer.ComposerError(None, None, f"{problem}, in line {event.start_mark.line + 1}", None)
