"""A first inventory for a paper: items get the claims that evidently belong to them.

What is left blank is for a person to settle: a claim to write, or a reason to give.
"""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Callable, Iterator
from io import StringIO

from omniproof.transcription.inventory import COLUMNS, NUMBER_WORDS, Item, scan
from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.model import Claim, Kind
from omniproof.transcription.verbatim import FoldedText, normalise, pinned

WORDS = {"eq": "eq", "fig": "fig", "tab": "tab", "app": "app", "cha": "sec", "sec": "sec"}


def draft(source: str, loaded: LoadedPaper) -> str:
    """Write an inventory as CSV, with claims where they are evident and no reasons."""
    drafter = _Drafter(source, loaded)
    out = StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(COLUMNS)
    for item in scan(source):
        writer.writerow([item.line, item.key[1], item.text, " ".join(drafter.claims(item)), ""])
    return out.getvalue()


class _Drafter:
    """Finds the claims of items; a reference or value claim is used up by its item."""

    def __init__(self, source: str, loaded: LoadedPaper) -> None:
        self.lines = source.split("\n")
        self.folded = FoldedText.of(source)
        self.claims_of_paper = loaded.claims
        self.spans = list(_spans(loaded.claims, self.folded))
        self.used: set[str] = set()
        self.seen: Counter[str] = Counter()

    def claims(self, item: Item) -> list[str]:
        """The ids of the claims that an item evidently belongs to."""
        rules: dict[str, Callable[[Item], list[str]]] = {
            "equation": self.numbered,
            "reference": self.referring,
            "cell": self.in_table,
            "numeral": self.printed,
        }
        found = rules.get(item.kind, self.around)(item)
        return found or self.around(item)

    def around(self, item: Item) -> list[str]:
        """The first claim whose verbatim text contains the item."""
        before = normalise(self.lines[item.line - 1][: item.column])
        start = self.folded.starts[item.line - 1] + len(before)
        start += bool(before) and self.folded.text[start : start + 1] == " "
        end = start + len(normalise(item.text))
        return [claim for claim, (low, high) in self.spans if low <= start and end <= high][:1]

    def numbered(self, item: Item) -> list[str]:
        """All claims of an equation number; `#2` where the paper prints it a second time."""
        number = re.sub(r"\\q?quad|\\text|\\tag|[\s(){}]", "", item.text).replace(",", ".")
        self.seen[number] += 1
        again = f"#{self.seen[number]}" if self.seen[number] > 1 else ""
        pattern = re.compile(rf"eq:{re.escape(number + again)}(?![\w.#-])")
        return [claim.id for claim in self.claims_of_paper if pattern.match(claim.id)]

    def referring(self, item: Item) -> list[str]:
        """The next reference claim of the line that points to what the item names."""
        numbers = re.findall(r"[A-Z],?\d+|\d+|(?<=\()[A-Z](?=\))", item.text)
        numbers = [re.sub(r"(?<=[A-Z]),?(?=\d)", ".", number) for number in numbers]
        word = re.match("[a-z]*", item.text.lower())
        kind = WORDS.get(word[0][:3].rstrip("s") if word else "", "cites")
        for claim in self.claims_of_paper:
            target = re.split(r"[/\[#]", claim.target or "")[0]
            cited = kind == "cites" and any(f"cites-{n}-" in f"{claim.id}-" for n in numbers)
            points = any(target == f"{kind}:{number}" for number in numbers)
            if claim.line == item.line and (points or cited) and claim.id not in self.used:
                self.used.add(claim.id)
                return [claim.id]
        return []

    def in_table(self, item: Item) -> list[str]:
        """The claim of a printed cell, or of its row."""
        row = (c.id for c in self.claims_of_paper if c.line == item.line and c.id[:4] == "tab:")
        return self.printed(item) or [claim for claim in row if "," not in claim][:1]

    def printed(self, item: Item) -> list[str]:
        """The value claim of the line that prints this numeral."""
        text = NUMBER_WORDS.get(item.text.lower(), item.text)
        for claim in self.claims_of_paper:
            fits = claim.kind is Kind.VALUE and claim.line == item.line and claim.printed == text
            if fits and claim.id not in self.used:
                self.used.add(claim.id)
                return [claim.id]
        return []


def _spans(claims: tuple[Claim, ...], folded: FoldedText) -> Iterator[tuple[str, tuple[int, int]]]:
    """Claims with the places of their verbatim texts in the folded source."""
    for claim in claims:
        for _, text in pinned(claim):
            at = folded.on_line(text, claim.line)
            if at is not None:
                yield claim.id, (at, at + len(normalise(text)))
        for fragment in claim.latex[1:]:
            for at in folded.occurrences(fragment):
                if folded.line(at) >= claim.line:
                    yield claim.id, (at, at + len(normalise(fragment)))
                    break
