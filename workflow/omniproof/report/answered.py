"""Read the answers of finished pages back: each equation has its block, with what it has to offer.

What a block has to offer is made anew from the ledger, whose corrections are proved, and from the
derivations.
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from html.parser import HTMLParser

from omniproof.audit.ledger import Ledger
from omniproof.report.anchors import anchor, rows_anchor
from omniproof.report.answers import Equations


class Blocks(HTMLParser):
    """The texts to paste on a page, by the address of the block that they stand in."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.ids: set[str] = set()
        self.pastes: dict[str, list[tuple[str, str]]] = {}
        self._block = self._kind = ""
        self._inside = False
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Enter a block, a tab, its code."""
        found = {name: value or "" for name, value in attrs}
        self.ids.add(found.get("id", ""))
        if "answer" in found.get("class", "").split():
            self._block = found.get("data-place", "")
            self.pastes.setdefault(self._block, [])
        self._kind = found.get("data-kind", self._kind)
        if tag == "code" and self._kind:
            self._inside = True
            self.pastes.setdefault(self._block, []).append((self._kind, ""))

    def handle_endtag(self, tag: str) -> None:
        """Leave a tab with its code."""
        if tag == "code" and self._inside:
            self._inside, self._kind = False, ""

    def handle_data(self, data: str) -> None:
        """Note the code of a tab."""
        if self._inside:
            kind, text = self.pastes[self._block].pop()
            self.pastes[self._block].append((kind, text + data))


def answer_faults(page: str, text: str, ledger: Ledger) -> Iterator[str]:
    """Name every equation whose answer is missing, or is not what it should be."""
    blocks, equations = Blocks(text), Equations(ledger)
    rows = {row.id for row in ledger.rows}
    for place, answer in equations.answers.items():
        for address in sorted(_addresses(place, rows) - blocks.ids):
            yield f"{page}: {place} has no element #{address}"
        lines = [equations.shown(place, line) for line in answer.lines]
        wanted = [paste for shown in lines for paste in shown.pastes.items()]
        found = blocks.pastes.get(place, [])
        for kind, formula in wanted:
            if (kind, formula) not in found:
                yield f"{page}: the answer for {place} lacks its {kind}: {formula}"
        if len(found) > len(wanted):
            yield f"{page}: the answer for {place} offers more than it should"


def _addresses(place: str, rows: Container[str]) -> set[str]:
    """Return the addresses that an equation has of its own, and not as a row of the ledger."""
    if not place.startswith("eq:"):
        return set()
    return {rows_anchor(place)} if place in rows else {rows_anchor(place), anchor(place)}
