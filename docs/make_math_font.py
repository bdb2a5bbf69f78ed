"""Makes docs/_static/fonts/formulas.woff, the font of formulas: `python docs/make_math_font.py STIXMath-Regular.otf`.

Browsers draw MathML well only in a font with a MATH table, and not every machine has one. This is the part of STIX Math
(Debian's package fonts-stix) that formulas need. Its license, the SIL Open Font License, wants a changed font to have
another name.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

FOLDER = Path(__file__).parent / "_static" / "fonts"
NAME = "Manipplan Formulas"
#: Latin, accents, Greek, superscripts, letters like ℝ, arrows, operators, brackets and their pieces, italic and bold letters.
RANGES = (
    (0x20, 0x7E), (0xA0, 0xFF), (0x2C6, 0x2DC), (0x300, 0x338), (0x370, 0x3FF), (0x2010, 0x2044), (0x2057, 0x2057),
    (0x2061, 0x2064), (0x2070, 0x209C), (0x20D0, 0x20DC), (0x2100, 0x214F), (0x2190, 0x21FF), (0x2200, 0x22FF),
    (0x2308, 0x230B), (0x239B, 0x23BD), (0x23DC, 0x23E1), (0x25A0, 0x25FF), (0x27E6, 0x27EB), (0x27F5, 0x27FF),
    (0x2A00, 0x2A0C), (0x2A7D, 0x2A7E), (0x1D400, 0x1D467), (0x1D6A8, 0x1D71B),
)  # fmt: skip


def main(source: str) -> Path:
    """Write the font, of the one in the file `source`; returns where."""
    font = TTFont(source)
    options = subset.Options(layout_features=["*"], name_IDs=["*"], notdef_outline=True)
    part = subset.Subsetter(options)
    part.populate(unicodes=[code for first, last in RANGES for code in range(first, last + 1)])
    part.subset(font)
    for record in list(font["name"].names):
        if record.nameID in (1, 3, 4, 6, 16, 18):
            font["name"].setName(NAME.replace(" ", "-") if record.nameID == 6 else NAME, *_place(record))
    if "CFF " in font:
        font["CFF "].cff.fontNames = [NAME.replace(" ", "-")]
        font["CFF "].cff.topDictIndex[0].FullName = font["CFF "].cff.topDictIndex[0].FamilyName = NAME
    font.flavor = "woff"
    FOLDER.mkdir(parents=True, exist_ok=True)
    file = FOLDER / "formulas.woff"
    font.save(file)
    return file


def _place(record):
    return record.nameID, record.platformID, record.platEncID, record.langID


if __name__ == "__main__":
    print(main(sys.argv[1]))
