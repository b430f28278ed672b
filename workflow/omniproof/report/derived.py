"""What stands behind the cards of a chapter: SymPy text of what is derived, and where that is done.

The ledger has LaTeX only, for people and in the paper's letters. Programs want the expression, and
a doubting reader the code; both come from the paper's derivations.
"""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Any

from sympy import MatrixBase, sstr

import omniproof
from omniproof.audit.ledger import Ledger
from omniproof.corrected.formula import derived_form
from omniproof.registry import Registry, load_registry
from omniproof.transcription.ids import base, index

LONGEST = 1500
"""Characters of SymPy text; a longer one would make the page heavy, and is read from the code."""

_PACKAGE = Path(omniproof.__file__).parent


class Derived:
    """The derivations of one paper, by claim; of a paper without any, nothing."""

    def __init__(self, ledger: Ledger) -> None:
        try:
            self.registry = load_registry(ledger.paper)
        except ModuleNotFoundError:
            self.registry = Registry(ledger.paper)
        self._readings = {base(row.id): row.convention for row in ledger.rows}
        self._forms: dict[str, Any] = {}

    def sympy(self, claim_id: str) -> str:
        """Return what is derived for a claim, or an entry of it, as SymPy writes it, or nothing."""
        name = self._bound(claim_id)
        if name not in self._forms:
            self._forms[name] = derived_form(self.registry, name, self._readings.get(name, ""))
        form = self._forms[name]
        if isinstance(form, MatrixBase):
            form = _entry(form, index(claim_id)) if name != claim_id else form
        text = f"Matrix({sstr(form.tolist())})" if isinstance(form, MatrixBase) else sstr(form)
        return str(text) if form is not None and len(text) <= LONGEST else ""

    def source(self, claim_id: str) -> str:
        """Return file and line of a derivation, from the package's folder; nothing for none."""
        derivation = self.registry.derivations.get(self._bound(claim_id))
        if derivation is None:
            return ""
        code = inspect.unwrap(derivation.build).__code__
        file = Path(code.co_filename).relative_to(_PACKAGE)
        return f"omniproof/{file.as_posix()}:{code.co_firstlineno}"

    def _bound(self, claim_id: str) -> str:
        """Return the id that has a derivation: the claim's own, or that of its matrix."""
        return claim_id if claim_id in self.registry.derivations else base(claim_id)


def _entry(matrix: MatrixBase, place: tuple[str, ...]) -> Any:
    """Return an entry by its printed index, from 1; None for a place that the matrix lacks."""
    if not place or not all(part.isdigit() for part in place):
        return None
    row, column = int(place[0]) - 1, int(place[-1]) - 1 if len(place) > 1 else 0
    return matrix[row, column] if row < matrix.rows and column < matrix.cols else None
