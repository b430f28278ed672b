"""Parts of claim ids: `eq:6[2,3]` is an entry of `eq:6`, `eq:10/a3` a part of `eq:10`."""

from __future__ import annotations

import re


def base(claim_id: str) -> str:
    """Return the id without its index: the matrix or table that an entry belongs to."""
    return claim_id.partition("[")[0]


def index(claim_id: str) -> tuple[str, ...]:
    """Return the parts of the index: `eq:6[2,3]` gives `("2", "3")`, `eq:7` gives `()`."""
    _, _, rest = claim_id.partition("[")
    return tuple(rest.rstrip("]").split(",")) if rest else ()


def whole(claim_id: str) -> str:
    """Return the numbered object that an id belongs to: `eq:10` for `eq:10/a3[2]`."""
    return re.split(r"[/\[]", claim_id)[0]
