"""Page anchors of claims: the permanent address of a row is its page and its anchor.

The rule is fixed (other programs and readers rely on it): every character outside `[A-Za-z0-9_]`
becomes `-`, runs are folded, ends trimmed. The rule is not injective (`eq:5-1` and `eq:5[1]`), so
uniqueness on a page is checked, not assumed.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

SEPARATORS = tuple(":/[#.")
_OTHER = re.compile(r"[^A-Za-z0-9_]+")


def anchor(claim_id: str) -> str:
    """Return the page anchor of a claim id: `eq:6[2,3]` becomes `eq-6-2-3`."""
    return _OTHER.sub("-", claim_id).strip("-")


def rows_anchor(equation: str) -> str:
    """Return the page anchor of an equation's rows; its own is borne by its answer."""
    return f"rows-{anchor(equation)}"


def unique_anchors(claim_ids: Iterable[str]) -> dict[str, str]:
    """Return id -> anchor.

    Raises `ValueError` naming every pair of different ids that would share an address.
    """
    owners: dict[str, str] = {}
    clashes: list[str] = []
    for claim_id in claim_ids:
        owner = owners.setdefault(anchor(claim_id), claim_id)
        if owner != claim_id:
            clashes.append(f"{owner} and {claim_id} (both #{anchor(claim_id)})")
    if clashes:
        raise ValueError("claims with the same address: " + "; ".join(clashes))
    return {claim_id: address for address, claim_id in owners.items()}


def selects(selector: str, claim_id: str) -> bool:
    """Whether a selector names this claim or something that contains it.

    `eq:6` selects `eq:6`, `eq:6/line-1`, `eq:6[2,3]` and `eq:6#2`, but not `eq:60` or `eq:6-2`;
    `eq:A` selects `eq:A.1`; `xref` selects every cross-reference. One that ends in a separator
    selects what is inside only: `tab:2[` the cells of Table 2, but not `tab:2/caption-wording`.
    """
    rest = claim_id.removeprefix(selector)
    ends = not rest or rest[0] in SEPARATORS or selector[-1:] in SEPARATORS
    return claim_id.startswith(selector) and ends
