"""Decoded displays against the glyphs that a damaged source text has kept.

Where text recognition re-encodes fonts (v for omega) and loses the order of a display, no
transcription is verbatim any more. How often each glyph stands there is still printed evidence: it
tells `d_1^2 + d_1^2` from `d_1^2 + d_2^2`, and a plus from a minus. So the paper states its
decoding once, as a table from LaTeX to glyphs, and each decoded display is re-encoded by it and
counted against the source. What recognition lost (norm bars, angle brackets) has to be named, glyph
by glyph: what it would explain too easily (an index, a sign) then stands out.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeAlias

from omniproof.transcription.model import Claim, Reading

Table: TypeAlias = Mapping[str, Sequence[str]]
"""LaTeX to the glyphs that stand for it in the source; the first one is the one to count."""

_LAYOUT = re.compile(
    r"\\(?:left|right|frac|begin\s*\{[a-z]+\}|end\s*\{[a-z]+\}|math[a-z]+|boldsymbol|[\\,;:! ])"
    r"|[{}_^&\s]"
)
_SEPARATORS = frozenset(",.")


def encode(latex: str, table: Table) -> Counter[str]:
    """Count the glyphs that LaTeX would leave in the source; functions by the letters they have."""
    keys = "|".join(re.escape(key) for key in sorted(table, key=len, reverse=True))
    rule = rf"(?P<key>{keys or '(?!)'})|\\(?P<sign>[{{}}|])|(?P<layout>{_LAYOUT.pattern})"

    def glyph(match: re.Match[str]) -> str:
        if match["key"]:
            return table[match["key"]][0]
        return (match["sign"] or "").replace("|", "||")

    return Counter(re.sub(rule, glyph, latex).replace("\\", ""))


def count(source: str, table: Table) -> Counter[str]:
    """Count the glyphs of a piece of the source, those with one meaning as one."""
    for first, *others in table.values():
        for other in sorted(others, key=len, reverse=True):
            source = source.replace(other, first)
    return Counter("".join(source.split()))


def misread(claims: Iterable[Claim], table: Table) -> Iterator[tuple[Claim, str]]:
    """Find decoded claims whose glyphs are not those of the source: the first claim of a display.

    Claims that name the same piece of the source share it, each text of theirs once. Commas and
    points between them may be left over.
    """
    displays: dict[tuple[int, str], list[Claim]] = defaultdict(list)
    for claim in claims:
        if claim.reading is Reading.GLYPHS and claim.glyphs:
            displays[claim.line, claim.glyphs].append(claim)
    for (_, source), group in displays.items():
        difference = _difference(group, source, table)
        if difference:
            yield group[0], difference


def _difference(group: Sequence[Claim], source: str, table: Table) -> str:
    printed = count(source, table)
    decoded: Counter[str] = Counter()
    texts = (text for claim in group for text in (*claim.latex, claim.quote or ""))
    for text in dict.fromkeys(texts):
        decoded += encode(text, table)
    for lost in dict.fromkeys(claim.lost or "" for claim in group):
        printed += Counter("".join(lost.split()))
    missing, added = printed - decoded, decoded - printed
    left = {glyph: number for glyph, number in missing.items() if glyph not in _SEPARATORS}
    parts = [f"without {_shown(left)}"] if left else []
    parts += [f"with {_shown(added)} too many"] if added else []
    return " and ".join(parts)


def _shown(glyphs: Mapping[str, int]) -> str:
    return " ".join(
        f"{n}×`{glyph}`" if n > 1 else f"`{glyph}`" for glyph, n in sorted(glyphs.items())
    )
