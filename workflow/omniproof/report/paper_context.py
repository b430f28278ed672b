"""A paper as the audit read it, to evaluate more formulas in its letters: nothing is judged."""

from __future__ import annotations

from pathlib import Path

import omniproof
from omniproof.audit.context import Context
from omniproof.audit.ledger import Ledger
from omniproof.report.derived import Derived
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
    derived = Derived(ledger)
    choices = {row.id: reading for row in ledger.rows if (reading := derived.reading(row.id))}
    return Context(load_paper(paper_folder(ledger.paper)), derived.registry, {}, choices)
