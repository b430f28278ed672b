"""Where the claims of one paper stand on its page."""

from __future__ import annotations

from collections.abc import Iterable

from omniproof.audit.ledger import Ledger
from omniproof.report.anchors import anchor, selects, unique_anchors
from omniproof.transcription.ids import base


class Addresses:
    """The anchors of a paper's rows, and those that other elements of the page have taken."""

    def __init__(self, ledger: Ledger) -> None:
        """Raise `ValueError` when two rows would share an anchor."""
        self._of_rows = unique_anchors(row.id for row in ledger.rows)
        self._of_groups = {base(claim): anchor(base(claim)) for claim in self._of_rows}
        self._taken = set(self._of_rows.values())
        self._answered: set[str] = set()

    def find(self, claim_id: str) -> str | None:
        """Return the anchor of a claim, a matrix or table, or of the first claim inside a place."""
        if claim_id in self._answered:
            return anchor(claim_id)
        for known in (self._of_rows, self._of_groups):
            if claim_id in known:
                return known[claim_id]
        inside = (address for claim, address in self._of_rows.items() if selects(claim_id, claim))
        return next(inside, None)

    def href(self, claim_id: str) -> str | None:
        """Return the link to a claim on its page, or None when there is no such place."""
        address = self.find(claim_id)
        return f"#{address}" if address else None

    def take(self, address: str) -> bool:
        """Give an anchor to an element that is no row; False when it has been given already."""
        free = address not in self._taken
        self._taken.add(address)
        return free

    def give_to_answers(self, equations: Iterable[str]) -> None:
        """Let the blocks of answers bear the addresses of these equations, and not their rows."""
        self._answered.update(equations)
        self._taken.update(map(anchor, self._answered))

    def is_answered(self, claim_id: str) -> bool:
        """Whether the address of a claim is borne by the answer for it."""
        return claim_id in self._answered
