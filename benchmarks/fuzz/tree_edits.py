"""Edits of XML and YAML as trees, so that the edited file is still well-formed and reaches the code behind the parser."""

import copy
import datetime
import math
import random
import xml.etree.ElementTree as ET
from typing import Any

from fuzz.text_edits import NUMBER, VALUES

#: Depth of nests and number of copies, beyond every bound of the package.
DEEP, MANY = 20_000, 3_000
#: Put in front of the root of an XML file: entities that grow, recur or name a file.
DOCTYPES = (
    '<!DOCTYPE r [<!ENTITY a "aaaaaaaaaa">'
    + "".join(f'<!ENTITY {x} "{f"&{y};" * 20}">' for x, y in zip("bcdefgh", "abcdefg", strict=True))
    + "]>",
    '<!DOCTYPE r [<!ENTITY a "&a;">]>',
    '<!DOCTYPE r [<!ENTITY a SYSTEM "file:///etc/hostname">]>',
    "<!DOCTYPE",
    '<?xml version="1.0" encoding="utf-16"?>',
    '<?xml version="1.0" encoding="nobodys"?>',
    '<?xml version="9.9"?>',
)
#: Values of YAML and JSON in place of another one.
PLAIN: tuple[Any, ...] = (
    *(math.nan, math.inf, -math.inf, 1e308, -1e308, 1e-308, 1e20, -1, 0, 0.0, 1, 2, 0.5, 2**31, 2**63, 2**64, 10**400),
    *("", "a", "é", " ", "nan", "1e5", "1.0", "../../x", "\x00", "box", "mesh", "universe", "x" * 10_000, True, False, None),
    *([], {}, [[]], [None], {"a": 1}, [1, 2], [1, 2, 3], [1, 2, 3, 4], [[1, 2], [3]], ["a", "b", "c"], {1: 2}, {None: None}),
    *(datetime.date(2001, 1, 1), b"\x00\xff", [0.0, 0.0, 0.0], [math.nan] * 3, [1e308] * 3, [1e200] * 4, [True] * 3, [0.0] * 4),
)


def edit_xml(rng: random.Random, data: bytes) -> bytes:
    """One edit of the tree of an XML file; a file that is not XML (any longer), or too deep, stays as it is."""
    try:
        return _edited(rng, ET.fromstring(data))
    except (ET.ParseError, ValueError, LookupError, RecursionError):
        return data


def _edited(rng: random.Random, root: ET.Element) -> bytes:
    if rng.random() < 0.02:
        doctype = rng.choice(DOCTYPES)
        body = ET.tostring(root, encoding="unicode")
        name = VALUES[0] if "ENTITY" not in doctype else rng.choice(("&a;", "&h;"))
        return (doctype + body.replace('name="', f'name="{name}', 1)).encode()
    parents = {child: parent for parent in root.iter() for child in parent}
    elements = list(root.iter())
    element, other = rng.choice(elements), rng.choice(elements)
    with_values = [each for each in elements if each.attrib]
    kind = rng.choice(("value",) * 6 + ("word",) * 4 + ("swap",) * 3 + ("drop attribute", "rename attribute", "add attribute"))
    if rng.random() < 0.4:
        kind = rng.choice(("delete", "double", "copy", "rename", "exchange", "text", "deep", "many", "empty", "wrap"))
    if kind in ("value", "word", "swap", "drop attribute", "rename attribute") and with_values:
        _edit_attribute(rng, kind, rng.choice(with_values), rng.choice(with_values))
    elif kind == "add attribute":
        if other.attrib:
            key = rng.choice(list(other.attrib))
            element.set(key, other.attrib[key])
    elif kind == "delete" and element in parents:
        parents[element].remove(element)
    elif kind == "double" and element in parents:
        parents[element].append(copy.deepcopy(element))
    elif kind == "copy":
        element.append(copy.deepcopy(other))
    elif kind == "rename":
        element.tag = rng.choice((other.tag, "x", "include", "frame", "capsule"))
    elif kind == "exchange":
        element.tag, other.tag = other.tag, element.tag
    elif kind == "text":
        element.text = rng.choice(VALUES)
    elif kind == "empty":
        element.clear()
    elif kind == "wrap" and element in parents:
        parents[element].remove(element)
        ET.SubElement(parents[element], other.tag, other.attrib).append(element)
    elif kind == "many" and rng.random() < 0.2:
        small = ET.Element(element.tag, element.attrib)
        numbered = rng.random() < 0.7
        for k in range(MANY):
            each = copy.copy(small)
            if numbered and "name" in each.attrib:
                each.set("name", f"{each.get('name')}{k}")
            (parents.get(element, root)).append(each)
    elif kind == "deep" and rng.random() < 0.2:
        start, end = f"<{element.tag}>".encode(), f"</{element.tag}>".encode()
        text = ET.tostring(root)
        return text.replace(start[:-1], start * DEEP + start[:-1], 1) + (end * DEEP if rng.random() < 0.5 else b"")
    return ET.tostring(root, encoding="utf-8")


def _edit_attribute(rng: random.Random, kind: str, element: ET.Element, other: ET.Element) -> None:
    key, its = rng.choice(list(element.attrib)), rng.choice(list(other.attrib))
    if kind == "value":
        element.set(key, rng.choice(VALUES))
    elif kind == "word":
        found = list(NUMBER.finditer(element.attrib[key]))
        if found:
            start, stop = rng.choice(found).span()
            element.set(key, element.attrib[key][:start] + rng.choice(VALUES) + element.attrib[key][stop:])
    elif kind == "swap":
        element.attrib[key], other.attrib[its] = other.attrib[its], element.attrib[key]
    elif kind == "drop attribute":
        del element.attrib[key]
    elif kind == "rename attribute":
        element.set(its, element.attrib.pop(key))


def edit_value(rng: random.Random, value: Any) -> Any:
    """One edit of a tree of mappings and lists: a copy."""
    value = copy.deepcopy(value)
    places = _places(value)
    if not places:
        return rng.choice(PLAIN)
    # values of the upper levels are as often chosen as the many numbers below
    depths = sorted({depth for depth, _, _ in places})
    depth = rng.choice(depths)
    _, parent, key = rng.choice([place for place in places if place[0] == depth])
    _, other, its = rng.choice(places)
    kind = rng.choice(("plain",) * 4 + ("delete", "swap", "double", "rename", "many", "deep", "copy", "insert"))
    if kind == "plain":
        parent[key] = copy.deepcopy(rng.choice(PLAIN))
    elif kind == "delete":
        del parent[key]
    elif kind == "swap":
        first, second = copy.deepcopy(parent[key]), copy.deepcopy(other[its])
        parent[key] = second
        if other is not parent[key]:
            other[its] = first
    elif kind == "double" and isinstance(parent, list):
        parent.insert(key, copy.deepcopy(parent[key]))
    elif kind == "copy":
        parent[key] = copy.deepcopy(other[its])
    elif kind == "insert" and isinstance(parent, list):
        parent.insert(key, copy.deepcopy(rng.choice(PLAIN)))
    elif kind == "rename" and isinstance(parent, dict):
        names = [each for _, mapping, each in places if isinstance(mapping, dict)]
        parent[rng.choice((*names, "x", 1, None, ""))] = parent.pop(key)
    elif kind == "many" and isinstance(parent, list) and rng.random() < 0.3:
        parent.extend([copy.deepcopy(parent[key]) for _ in range(300)])
    elif kind == "deep" and rng.random() < 0.3:
        for _ in range(rng.choice((3, 50, 150))):
            parent[key] = [parent[key]] if rng.random() < 0.5 else {"a": parent[key]}
    return value


def _places(value: Any, depth: int = 0) -> list[tuple[int, Any, Any]]:
    """Depth, container and key of every value below `value`."""
    keys = list(value) if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ()
    places = []
    for key in keys:
        places += [(depth, value, key), *_places(value[key], depth + 1)]
    return places
