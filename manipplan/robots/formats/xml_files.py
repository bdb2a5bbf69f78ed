"""XML files from outside: well-formed, in UTF-8, not too deep; and the numbers in their attributes."""

import io
import xml.etree.ElementTree as ET
from pathlib import Path

from manipplan.support.errors import FileFormatError

#: Maximum depth of nested XML elements and maximum number of links in a chain: Pinocchio reads both recursively.
DEEPEST = 500
#: Maximum number of collision bodies and of joints of a robot: time and memory grow with the number of their pairs.
MOST_BODIES, MOST_JOINTS = 1000, 1000
#: Largest number in a description: products of larger ones overflow.
LARGEST = 1e12


def read_xml(argument: str, file: Path, root_tag: str, text: str | None = None) -> ET.Element:
    """The root of an XML file in UTF-8, the encoding that Pinocchio assumes for every file; or of the text made from it."""
    root = bounded_xml(argument, file, text)
    if root.tag != root_tag:
        raise FileFormatError(argument, str(file), f"an XML file whose root is <{root_tag}>, not <{root.tag}>")
    return root


def bounded_xml(argument: str, file: Path, text: str | None = None) -> ET.Element:
    """The root of any XML file in UTF-8, or of the text made from it, whose elements are not nested deeper than `DEEPEST`."""
    try:
        if text is None:
            file.read_text(encoding="utf-8")
        return _bounded(argument, file, file if text is None else io.BytesIO(text.encode()))
    except FileFormatError:
        raise
    except ET.ParseError as error:
        raise FileFormatError(argument, str(file), f"well-formed XML ({error})") from error
    except (ValueError, LookupError) as error:  # bytes that are not UTF-8, or an unknown encoding
        raise FileFormatError(argument, str(file), f"XML in UTF-8 ({error})") from error
    except OSError as error:
        raise FileFormatError(argument, str(file), f"a file that can be read ({error.strerror})") from error


def _bounded(argument: str, file: Path, source: Path | io.BytesIO) -> ET.Element:
    """The root of XML whose elements are not nested deeper than `DEEPEST`."""
    depth = 0
    root: ET.Element | None = None
    for event, element in ET.iterparse(source, events=("start", "end")):
        depth += 1 if event == "start" else -1
        root = element if root is None else root
        if depth > DEEPEST:
            raise FileFormatError(argument, str(file), f"XML with elements nested at most {DEEPEST} deep")
    if root is None:
        raise ET.ParseError("no element found")
    return root


def numbers(text: str | None, count: int) -> tuple[float, ...] | None:
    """The `count` numbers within ±`LARGEST` in `text`, separated by spaces; None if `text` is anything else."""
    words = text.split() if text is not None else []
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        return None
    return values if len(values) == count and all(abs(value) <= LARGEST for value in values) else None
