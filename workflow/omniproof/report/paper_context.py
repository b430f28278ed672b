"""A paper as the audit read it, to evaluate more formulas in its letters: nothing is judged."""

from __future__ import annotations

from pathlib import Path

import omniproof
from omniproof.audit.context import Context
from omniproof.audit.ledger import Ledger
from omniproof.registry import load_registry
from omniproof.transcription.ids import base
from omniproof.transcription.loader import FILE, load_paper

CHECKOUT = Path(omniproof.__file__).parents[2]


def paper_folder(paper: str) -> Path:
    """Find a paper's data here, in a folder above, or where the package was installed from.

    Raises `ValueError` when there is none.
    """
    here = Path.cwd()
    for folder in (here, *here.parents, CHECKOUT):
        if (folder / "paper_data" / paper / FILE).is_file():
            return folder / "paper_data" / paper
    raise ValueError(f"no folder paper_data/{paper} here or above: start in the project's folder")


def paper_context(ledger: Ledger) -> Context:
    """Load a paper with the readings of its conventions that its ledger was judged under."""
    choices = {base(row.id): row.convention for row in ledger.rows if row.convention}
    registry = load_registry(ledger.paper)
    return Context(load_paper(paper_folder(ledger.paper)), registry, {}, choices)
