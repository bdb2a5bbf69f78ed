"""Collada files (DAE), judged before the mesh loader reads them: an index that is not a number makes it fill the memory."""

import re
import xml.etree.ElementTree as ET
from pathlib import Path

from manipplan.robots.formats.xml_files import bounded_xml
from manipplan.support.errors import FileFormatError

#: Elements that hold whole numbers, and elements that hold numbers.
WHOLE = ("p", "ph", "h", "v", "vcount", "int_array")
REAL = ("float_array", "matrix", "translate", "rotate", "scale", "skew", "lookat", "bind_shape_matrix")
#: Attributes that are numbers of entries.
COUNTS = ("count", "stride", "offset", "set")
_WHOLE = re.compile(r"[ \t\r\n]*(?:-?[0-9]+(?:[ \t\r\n]+|$))*")
_REAL = re.compile(r"[ \t\r\n]*(?:[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?(?:[ \t\r\n]+|$))*")


def fault_of(file: Path) -> str | None:
    """The fault in the numbers of a Collada file; None if there is none."""
    try:
        root = bounded_xml("mesh", file)
        size = file.stat().st_size
    except FileFormatError as error:
        return error.allowed
    for element in root.iter():
        fault = _fault(element, element.tag.rpartition("}")[2], size)
        if fault is not None:
            return fault
    return None


def _fault(element: ET.Element, tag: str, size: int) -> str | None:
    for name in COUNTS:
        count = element.get(name)
        if count is not None and not (count.isascii() and count.isdigit() and len(count) < 19 and int(count) <= size):
            return f"<{tag}> needs {name} with a whole number within the size of the file, not {count!r}"
    form = _WHOLE if tag in WHOLE else _REAL if tag in REAL else None
    text = element.text or ""
    if form is None:
        return None
    read = form.match(text)
    if len(element) or read is None or read.end() < len(text):
        found = text[read.end() if read is not None else 0 :][:40]
        return f"<{tag}> needs {'whole ' if tag in WHOLE else ''}numbers, not {found!r}"
    return None
