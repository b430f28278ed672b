"""One audit of each paper, shared by all tests of a process."""

from __future__ import annotations

from pathlib import Path

import pytest
from audited import audited_once

from omniproof.audit.ledger import Ledger, Row


@pytest.fixture(scope="module")
def paper_folder(root: Path, request: pytest.FixtureRequest) -> Path:
    """Return the folder of the paper that the test module names as `PAPER`."""
    return root / "paper_data" / str(request.module.PAPER)


@pytest.fixture(scope="module")
def ledger(paper_folder: Path) -> Ledger:
    """Return the ledger of the paper that the test module names."""
    return audited_once(paper_folder)


@pytest.fixture(scope="module")
def rows(ledger: Ledger) -> dict[str, Row]:
    """Return the rows of that ledger by their ids."""
    return {row.id: row for row in ledger.rows}
