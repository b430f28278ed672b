"""One audit of each paper, shared by the tests of a module."""

from __future__ import annotations

from pathlib import Path

import pytest

from omniproof.audit.ledger import Ledger, Row
from omniproof.audit.run import audit_paper


@pytest.fixture(scope="module")
def paper_folder(root: Path, request: pytest.FixtureRequest) -> Path:
    """Return the folder of the paper that the test module names as `PAPER`."""
    return root / "paper_data" / str(request.module.PAPER)


@pytest.fixture(scope="module")
def ledger(paper_folder: Path) -> Ledger:
    """Return the ledger of the paper as it stands in the repository."""
    return audit_paper(paper_folder)


@pytest.fixture(scope="module")
def rows(ledger: Ledger) -> dict[str, Row]:
    """Return the rows of that ledger by their ids."""
    return {row.id: row for row in ledger.rows}
