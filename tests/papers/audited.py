"""One audit of each paper as it stands in the repository, for all tests of a process."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from omniproof.audit.ledger import Ledger
from omniproof.audit.run import audit_paper


@cache
def audited_once(folder: Path) -> Ledger:
    """Audit a paper; its rows are frozen, so tests can share them."""
    return audit_paper(folder)
