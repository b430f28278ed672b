"""The tiny paper, loaded and judged."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
import tiny_paper

from omniproof.audit import run
from omniproof.audit.ledger import Ledger


@pytest.fixture(scope="module")
def tiny_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Return the folder of the tiny paper, with its derivations and readings in place."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(run, "load_registry", lambda paper: tiny_paper.registry())
        patch.setattr(run, "load_readings", lambda paper: tiny_paper.READINGS)
        yield tiny_paper.write(tmp_path_factory.mktemp("papers") / "tiny-paper")


@pytest.fixture(scope="module")
def tiny_ledger(tiny_folder: Path) -> Ledger:
    """Return the ledger of the tiny paper."""
    return run.audit_paper(tiny_folder)
