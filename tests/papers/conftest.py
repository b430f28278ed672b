"""One audit of each paper, shared by its tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from omniproof.audit.ledger import Ledger
from omniproof.audit.run import audit_paper


@pytest.fixture(scope="session")
def omni_arrangement(root: Path) -> Ledger:
    """Return the ledger of the paper as it stands in the repository."""
    return audit_paper(root / "paper_data" / "omni-arrangement")


@pytest.fixture(scope="session")
def ballbot(root: Path) -> Ledger:
    """Return the ledger of the paper as it stands in the repository."""
    return audit_paper(root / "paper_data" / "ballbot")
