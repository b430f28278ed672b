"""Whether a transcription stands in the source text, word for word and on the stated line.

Blank space is folded, nothing else: a transcription that repairs a misprint must fail here. What
is decoded from a damaged source has its glyphs counted (see `glyphs`); what is reconstructed is
passed over.
"""

from __future__ import annotations

import os
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from omniproof.transcription.faults import Fault, shorten
from omniproof.transcription.glyphs import misread
from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.model import Claim, Kind, Reading

ROOT = Path(__file__).resolve().parents[3]


def sources_folder() -> Path:
    """The folder of the source texts; it need not exist."""
    return Path(os.environ.get("OMNIPROOF_SOURCES", ROOT.parent / "shared" / "papers"))


def source_text(loaded: LoadedPaper) -> str | None:
    """The source text of a paper, `None` where it is not present."""
    path = sources_folder() / loaded.paper.edition.source
    return path.read_text(encoding="utf-8") if path.is_file() else None


def normalise(text: str) -> str:
    """Fold all blank space."""
    return " ".join(text.split())


@dataclass(frozen=True)
class FoldedText:
    """A text with its blank space folded, and where each of its lines starts in it."""

    text: str
    starts: tuple[int, ...]

    @classmethod
    def of(cls, source: str) -> FoldedText:
        """Fold a text; line n of the source starts at `starts[n - 1]`."""
        parts, starts, length = list[str](), list[int](), 0
        for line in source.split("\n"):
            folded = normalise(line)
            starts.append(length)
            if folded:
                parts.append(folded)
                length += len(folded) + 1
        return cls(" ".join(parts), tuple(starts))

    def line(self, offset: int) -> int:
        """The line of the source, from 1, on which an offset stands."""
        return bisect_right(self.starts, offset)

    def on_line(self, text: str, line: int) -> int | None:
        """Offset of the first occurrence that starts on a line."""
        if not 1 <= line <= len(self.starts):
            return None
        return next((at for at in self.occurrences(text) if self.line(at) == line), None)

    def occurrences(self, text: str) -> Iterator[int]:
        """All offsets at which a text starts, once its own blank space is folded."""
        text = normalise(text)
        at = self.text.find(text)
        while at >= 0:
            yield at
            at = self.text.find(text, at + 1)


def missing(loaded: LoadedPaper, source: str) -> list[Fault]:
    """List what is not printed where its claim says.

    The first LaTeX fragment, the quote, and the wording of a consistency claim start on the claim's
    line; later fragments follow in order. A table's cells stand on the line of their row.
    """
    folded = FoldedText.of(source)
    faults = []
    if sha256(source.encode()).hexdigest() != loaded.paper.edition.sha256:
        message = "expected the source text with this sha256, found another text"
        cure = "audit the text that is named"
        faults.append(loaded.start.fault("edition.sha256", message, cure))
    for claim in loaded.claims:
        for key, message, cure in _misplaced(claim, folded):
            faults.append(loaded.fault(claim.id, message, cure, key))
    return sorted([*faults, *_misread(loaded)])


def _misread(loaded: LoadedPaper) -> Iterator[Fault]:
    for claim, difference in misread(loaded.claims, loaded.paper.notation.glyphs):
        message = f"expected the glyphs of the source, found them {difference}"
        cure = "decode it by `notation.glyphs`, and name what is `lost`"
        yield loaded.fault(claim.id, message, cure, "glyphs")


def _misplaced(claim: Claim, folded: FoldedText) -> Iterator[tuple[str, str, str]]:
    """Key, message and cure for each text of a claim that is not at its place."""
    for key, text in pinned(claim):
        if folded.on_line(text, claim.line) is None:
            yield key, *_elsewhere(folded, text, claim.line)
            return
    yield from _later_fragments(claim, folded)


def pinned(claim: Claim) -> Iterator[tuple[str, str]]:
    """The verbatim texts of a claim that start on its line, by their key."""
    if claim.glyphs:
        yield "glyphs", claim.glyphs
    if claim.reading is not Reading.PLAIN:
        return
    if claim.latex:
        yield "latex", claim.latex[0]
    if claim.quote:
        yield "quote", claim.quote
    cell = claim.kind is Kind.VALUE and claim.id.startswith("tab:") and "[" in claim.id
    if claim.printed and (claim.kind is Kind.CONSISTENCY or cell):
        yield "printed", claim.printed


def _later_fragments(claim: Claim, folded: FoldedText) -> Iterator[tuple[str, str, str]]:
    if claim.reading is not Reading.PLAIN or len(claim.latex) < 2:
        return
    at = folded.on_line(claim.latex[0], claim.line) or 0
    for number, fragment in enumerate(claim.latex[1:], 2):
        after = at + 1
        at = next((offset for offset in folded.occurrences(fragment) if offset >= after), -1)
        if at < 0:
            message = f"expected this after line {claim.line}, found no {shorten(fragment)}"
            yield f"latex[{number}]", message, "copy the fragments in the order of the source"
            return


def _elsewhere(folded: FoldedText, text: str, line: int) -> tuple[str, str]:
    lines = sorted({folded.line(offset) for offset in folded.occurrences(text)})
    if lines:
        shown = ", ".join(map(str, lines[:5]))
        return f"expected this on line {line}, found it on line {shown}", f"set `line: {lines[0]}`"
    message = f"expected verbatim text of the source, found {shorten(text)}"
    return message, f"copy it from line {line} of the source text"
