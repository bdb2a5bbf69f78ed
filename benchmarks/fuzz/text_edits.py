"""Edits of files as bytes, words and lines: what disks, editors and programs do to a file, and what an attacker would."""

import random
import re

#: Texts in place of a number, a name or a whole attribute.
_WORDS = """
    nan inf -inf 1e308 -1e308 1e-308 1e400 -1 0 -0 1e20 1e-20 0.5 -0.3 2 7 255 2147483647 2147483648 4294967295
    18446744073709551616 0x10 1_0 1,5 +1 1e --1 a é \u202e %s%n ../../x universe world true null ~ &amp; */ [ {} !!a
"""
VALUES = (*_WORDS.split(), "", " ", "1 2", "1 2 3", "0 0 0", "1 2 3 4", "- 1", "9" * 400, "x" * 10_000)
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")
#: Bytes that many parsers treat in a special way.
BYTES = (0x00, 0x01, 0x09, 0x0A, 0x0D, 0x1A, 0x20, 0x22, 0x26, 0x27, 0x2A, 0x3C, 0x3E, 0x5B, 0x7B, 0x7F, 0x80, 0xC3, 0xFE, 0xFF)


def edit_bytes(rng: random.Random, data: bytes) -> bytes:
    """One edit of the bytes: some changed, cut out, doubled, inserted, or the file cut off."""
    changed = bytearray(data)
    start = rng.randrange(len(changed) + 1)
    stop = min(len(changed), start + rng.choice((1, 4, 16, 64, 256, 4096)))
    kind = rng.choice(("flip", "flip", "set", "cut", "truncate", "double", "insert", "zero", "move"))
    if kind == "flip":
        for _ in range(rng.choice((1, 1, 2, 5, 20)) if changed else 0):
            changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
    elif kind == "set" and changed:
        changed[rng.randrange(len(changed))] = rng.choice(BYTES)
    elif kind == "cut":
        del changed[start:stop]
    elif kind == "truncate":
        del changed[start:]
    elif kind == "double":
        changed[start:start] = changed[start:stop]
    elif kind == "insert":
        changed[start:start] = bytes(rng.choice(BYTES) for _ in range(rng.choice((1, 1, 3, 40))))
    elif kind == "zero":
        changed[start:stop] = bytes(stop - start)
    elif kind == "move":
        part = changed[start:stop]
        del changed[start:stop]
        place = rng.randrange(len(changed) + 1)
        changed[place:place] = part
    return bytes(changed)


def edit_words(rng: random.Random, data: bytes) -> bytes:
    """One edit of a number, of a word or of two words; in a binary file those of its header are found as well."""
    text = data.decode("latin-1")
    pattern = NUMBER if rng.random() < 0.7 else re.compile(r"[\w.\-]+")
    found = [match.span() for match in pattern.finditer(text)]
    if not found:
        return edit_bytes(rng, data)
    (start, stop), (first, last) = rng.choice(found), rng.choice(found)
    value = text[first:last] if rng.random() < 0.3 else rng.choice(VALUES)
    return data[:start] + value.encode() + data[stop:]


def edit_lines(rng: random.Random, data: bytes) -> bytes:
    """One edit of lines: deleted, doubled, swapped, indented, emptied, or repeated very often."""
    lines = data.split(b"\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    kind = rng.choice(("delete", "double", "swap", "indent", "empty", "delete many", "repeat", "join"))
    if kind == "delete":
        del lines[i]
    elif kind == "double":
        lines.insert(j, lines[i])
    elif kind == "swap":
        lines[i], lines[j] = lines[j], lines[i]
    elif kind == "indent":
        lines[i] = rng.choice((b" ", b"\t", b"  ", b"- ")) + lines[i]
    elif kind == "empty":
        lines[i] = b""
    elif kind == "delete many":
        del lines[min(i, j) : max(i, j)]
    elif kind == "repeat":
        lines[i:i] = [lines[i][:200]] * rng.choice((10, 100, 1000))
    elif kind == "join" and i + 1 < len(lines):
        lines[i : i + 2] = [lines[i] + lines[i + 1]]
    return b"\n".join(lines)


def edit_encoding(rng: random.Random, data: bytes) -> bytes:
    """The file in another encoding, or with another beginning or end."""
    text = data.decode("utf-8", "replace")
    return rng.choice(
        (
            lambda: text.encode("utf-16"),
            lambda: text.encode("utf-32-le"),
            lambda: b"\xef\xbb\xbf" + data,
            lambda: text.replace("a", "é", 3).encode("latin-1", "replace"),
            lambda: text.replace("a", "é", 3).encode(),
            lambda: data.replace(b"\n", b"\r\n"),
            lambda: data.replace(b"\n", b"\r"),
            lambda: data + bytes(rng.choice((1, 1000))),
            lambda: bytes(rng.choice((1, 1000))) + data,
            data.upper,
            lambda: data + data,
            lambda: b"",
            lambda: rng.randbytes(rng.choice((1, 10, 1000))),
        )
    )()
