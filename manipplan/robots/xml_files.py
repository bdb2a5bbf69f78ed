"""XML files from outside: well-formed, in UTF-8, not too deep; and the numbers in their attributes."""

import codecs
import xml.etree.ElementTree as ET
from pathlib import Path
from xml.parsers import expat

from manipplan.support.errors import FileFormatError

#: Maximum depth of nested XML elements and maximum number of links in a chain: Pinocchio reads both recursively.
DEEPEST = 500
#: Maximum number of collision bodies and of joints of a robot: time and memory grow with the number of their pairs.
MOST_BODIES, MOST_JOINTS = 1000, 1000
#: Largest number in a description: products of larger ones overflow.
LARGEST = 1e12
#: Maximum size of a file [bytes], and maximum number of elements.
MOST_BYTES, MOST_ELEMENTS = 100_000_000, 500_000


def read_xml(argument: str, file: Path, root_tag: str, text: str | None = None) -> ET.Element:
    """The root of an XML file in UTF-8, the encoding that Pinocchio assumes for every file; or of the text made from it."""
    root = read_bounded_xml(argument, file, text)
    if root.tag != root_tag:
        raise FileFormatError(argument, str(file), f"an XML file whose root is <{root_tag}>, not <{root.tag}>")
    return root


def read_bounded_xml(argument: str, file: Path, text: str | None = None) -> ET.Element:
    """The root of any XML file in UTF-8, or of the text made from it, whose elements are not nested deeper than `DEEPEST`.

    As in ROS's and MuJoCo's parser, a prefix such as that of <gazebo:link> is a part of the name and may lack its xmlns, and
    spaces and blank lines may stand before <?xml.
    """
    try:
        size = file.stat().st_size if text is None else len(text)
        if size > MOST_BYTES:
            raise FileFormatError(argument, f"{file} of {size:,} bytes", f"XML of at most {MOST_BYTES:,} bytes")
        text = file.read_bytes().decode("utf-8-sig") if text is None else text
        return _TreeBuilder(argument, file).read(text.lstrip())
    except FileFormatError:
        raise
    except expat.ExpatError as error:
        raise FileFormatError(argument, str(file), f"well-formed XML ({error})") from error
    except (UnicodeError, LookupError) as error:  # bytes that are not UTF-8, or an unknown encoding
        raise FileFormatError(argument, str(file), f"XML in UTF-8 ({error})") from error
    except OSError as error:
        raise FileFormatError(argument, str(file), f"a file that can be read ({error.strerror})") from error


class _TreeBuilder:
    """Builds the elements of a file, with names as they are written: ElementTree's own parser refuses an unbound prefix."""

    def __init__(self, argument: str, file: Path) -> None:
        self.wanted = argument, str(file)
        self.depth = self.count = 0
        self.builder = ET.TreeBuilder()

    def read(self, text: str) -> ET.Element:
        parser = expat.ParserCreate("utf-8")  # whatever the file declares
        parser.buffer_text = True
        parser.XmlDeclHandler = self._on_declaration
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self.builder.data
        parser.SkippedEntityHandler = self._on_skipped_entity
        parser.Parse(text.encode(), True)
        return self.builder.close()

    def _on_declaration(self, _: str, encoding: str | None, __: int) -> None:
        codecs.lookup(encoding or "utf-8")

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self.depth += 1
        self.count += 1
        if self.count > MOST_ELEMENTS:
            raise FileFormatError(*self.wanted, f"XML with at most {MOST_ELEMENTS:,} elements")
        if self.depth > DEEPEST:
            raise FileFormatError(*self.wanted, f"XML with elements nested at most {DEEPEST} deep")
        self.builder.start(tag, attributes)

    def _end(self, tag: str) -> None:
        self.depth -= 1
        self.builder.end(tag)

    def _on_skipped_entity(self, name: str, _: bool) -> None:
        raise FileFormatError(*self.wanted, f"well-formed XML (there is no entity {name!r})")


def numbers(text: str | None, count: int, *, largest: float = LARGEST) -> tuple[float, ...] | None:
    """The `count` numbers within ±`largest` in `text`, separated by spaces; None if `text` is anything else."""
    words = text.split() if text is not None else []
    if text is not None and (not text.isascii() or "_" in text):  # Python reads ١ and 1_0
        return None
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        return None
    return values if len(values) == count and all(abs(value) <= largest for value in values) else None
