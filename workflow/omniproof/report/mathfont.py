"""The font of the formulas: STIX Two Math, cut down to the signs that the pages use.

MathML needs a font that knows how brackets grow; not every machine has one. A data address carries
it inside a style sheet, because browsers refuse fonts in files of their own to pages from disk.
"""

from __future__ import annotations

import base64
import importlib.util
import logging
from collections.abc import Iterable, Iterator
from io import BytesIO
from pathlib import Path

from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

FAMILY = "omniproof math"
PACKAGE, FILE = "ziamath", "fonts/STIXTwoMath-Regular.ttf"
FEATURES = ("ssty", "dtls")
"""Shapes for scripts, and letters without dots under accents: MathML asks for them."""

LEGAL = (0, 1, 2, 3, 4, 5, 6, 13, 14)
"""Entries of the font's table of names: the licence stays with the font."""

_ROOT = 0x221A
logging.getLogger("fontTools.subset").setLevel(logging.WARNING)  # else each glyph is told


def font_face(signs: Iterable[str]) -> str:
    """Return a style sheet with the font, for the given characters.

    Raises `ModuleNotFoundError` when the package that brings the font is not installed.
    """
    data = base64.b64encode(_subset(signs)).decode()
    return (
        f'@font-face {{ font-family: "{FAMILY}"; font-display: block; '
        f'src: url("data:font/woff;base64,{data}") format("woff"); }}\n'
    )


def _subset(signs: Iterable[str]) -> bytes:
    options = Options()
    options.layout_features = [*FEATURES]
    options.name_IDs = [*LEGAL]
    options.hinting = False
    options.flavor = "woff"
    font = TTFont(_file(), recalcTimestamp=False)
    _narrow_roots(font)
    subsetter = Subsetter(options)
    subsetter.populate(unicodes={_ROOT, *map(ord, signs)})  # no text of MathML has a root
    subsetter.subset(font)
    font.flavor = options.flavor
    stream = BytesIO()
    font.save(stream)
    return stream.getvalue()


def _file() -> Path:
    package = importlib.util.find_spec(PACKAGE)
    if package is None or package.origin is None:
        raise ModuleNotFoundError(f"{PACKAGE} is not installed: run `make`")
    return Path(package.origin).parent / FILE


def _narrow_roots(font: TTFont) -> None:
    """Make high root signs as narrow as the low one.

    Chromium gives each root the width of the widest sign, and a small one a gap behind it.
    """
    glyphs, widths, drawn = font["glyf"], font["hmtx"], font.getGlyphSet()
    low = font.getBestCmap()[_ROOT]
    for name in set(_high_roots(font, low)) - {low}:
        width, bearing = widths[name]
        factor = widths[low][0] / width
        pen = TTGlyphPen(None)
        drawn[name].draw(TransformPen(pen, (factor, 0, 0, 1, 0, 0)))
        glyphs[name] = pen.glyph()
        widths[name] = (widths[low][0], round(bearing * factor))


def _high_roots(font: TTFont, low: str) -> Iterator[str]:
    variants = font["MATH"].table.MathVariants
    growing = variants.VertGlyphConstruction[variants.VertGlyphCoverage.glyphs.index(low)]
    yield from (record.VariantGlyph for record in growing.MathGlyphVariantRecord)
    yield from (part.glyph for part in growing.GlyphAssembly.PartRecords)
