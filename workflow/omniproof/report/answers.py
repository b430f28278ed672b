r"""What to use for each numbered equation: as printed, as it should read, and as text to paste.

Everything comes from the ledger and from the derivations. A corrected formula is read back from the
LaTeX that is offered, in the paper's own letters, and `unproved` tells where it is not what
mechanics gives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sympy import Expr, MatrixBase

from omniproof.audit.context import Context, flat
from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.audit.sympy_equality import confirmed_equal
from omniproof.corrected import ANSWERS, FUNCTIONS
from omniproof.corrected.answer import Answer, Line
from omniproof.decide.answer import Proved
from omniproof.formula.errors import UnsupportedError
from omniproof.report.changes import changes
from omniproof.report.groups import Group, groups, matrix_of
from omniproof.report.latexfmt import is_latex, is_settable
from omniproof.report.paper_context import paper_context
from omniproof.report.pastes import (
    Product,
    latex_paste,
    numpy_paste,
    omniproof_paste,
    sympy_paste,
)
from omniproof.report.survival import replaced
from omniproof.transcription.entries import entry_span
from omniproof.transcription.ids import base, index, whole
from omniproof.transcription.model import Kind
from omniproof.transcription.reader import read_with
from omniproof.transcription.tokens import LatexError

UNKNOWN = frozenset({Verdict.UNCHECKABLE, Verdict.UNDECIDED})


@dataclass(frozen=True)
class Shown:
    """One formula, ready to show: LaTeX with faults marked, and what to paste by kind."""

    claims: tuple[str, ...]
    rows: tuple[Row, ...]
    printed: str
    corrected: str
    pastes: Mapping[str, str]

    @property
    def is_faulty(self) -> bool:
        """Whether something in it is not as it should be."""
        return any(row.verdict.is_fault for row in self.rows)


class Equations:
    """The equations of one paper, and other places with a formula to use instead."""

    def __init__(self, ledger: Ledger) -> None:
        self.ledger = ledger
        self.groups = {group.base: group for group in groups(ledger.rows)}
        self._known: dict[str, Any] = {}

    @cached_property
    def context(self) -> Context:
        """The paper, to read formulas in its letters."""
        return paper_context(self.ledger)

    @cached_property
    def answers(self) -> dict[str, Answer]:
        """Return an answer for every numbered equation, and for what else has a formula."""
        own = {
            place: answer
            for place, answer in ANSWERS.get(self.ledger.paper, {}).items()
            if self.groups.keys() >= answer.claims
        }
        places = dict.fromkeys(whole(n) for n in self.groups if n.startswith("eq:"))
        others = [base(rows[0].id) for rows in replaced(self.ledger)]
        places |= dict.fromkeys(n for n in others if not n.startswith("eq:") and self._is_pure(n))
        return {place: own.get(place) or self._plain(place) for place in (*places, *own)}

    @cached_property
    def _respelt(self) -> dict[str, list[tuple[str, str]]]:
        """What is misspelt in an equation without being false: the print, and what it should be."""
        found: dict[str, list[tuple[str, str]]] = {}
        for row in self.ledger.rows:
            if row.kind is Kind.EDITORIAL and changes(row.printed, row.correction):
                found.setdefault(whole(row.id), []).append((row.printed, row.correction))
        return found

    def _plain(self, place: str) -> Answer:
        """Return the parts of an equation one after the other, each as it stands."""
        functions = FUNCTIONS.get(self.ledger.paper, {})
        parts = [name for name in self.groups if place in {name, whole(name)}]
        formulas = [name for name in parts if self._is_formula(self.groups[name])]
        lines = (Line(f"<{name}>", function=functions.get(name)) for name in formulas or parts)
        return Answer("", tuple(lines))

    @staticmethod
    def _is_formula(group: Group) -> bool:
        row = group.rows[0]
        return row.kind in {Kind.IDENTITY, Kind.RELATION} and is_latex(
            row.correction or row.printed
        )

    def _is_pure(self, claim: str) -> bool:
        """Whether what a claim should say is a formula without words."""
        return r"\text" not in self.right(claim) and self._reads(self.right(claim))

    def _reads(self, latex: str) -> bool:
        try:
            read_with(latex_paste(latex), self.context.loaded.paper.notation, self.context.names)
        except LatexError:
            return False
        return True

    def shown(self, place: str, line: Line) -> Shown:
        """Return a line of the answer for a place, ready to show."""
        rows = tuple(row for name in line.claims for row in self.groups[name].rows)
        return Shown(
            line.claims,
            rows,
            latex_paste(line.filled(self.printed)),
            latex_paste(line.filled(self.marked)),
            dict(self._pastes(place, line, rows)),
        )

    def printed(self, claim: str) -> str:
        """Return a claim as it is printed, with a box around what is not as it should be."""
        group = self.groups[claim]
        if group.is_matrix:
            return self._with_entries(group, lambda row: _boxed(row.printed, row)) or group.whole
        row = group.rows[0]
        changed = changes(row.printed, _right(row)) if row.verdict.is_fault else None
        return changed.printed if changed else _boxed(row.printed, row)

    def marked(self, claim: str) -> str:
        """Return a claim as it should read, with marks on what changes in it."""
        group = self.groups[claim]
        if group.is_matrix:
            return self._right_matrix(group, lambda row: _changed(_form(row), row))
        row = group.rows[0]
        changed = changes(row.printed, _right(row)) if row.verdict.is_fault else None
        return changed.corrected if changed else _changed(_right(row), row)

    def right(self, claim: str) -> str:
        """Return a claim as it should read."""
        group = self.groups[claim]
        latex = self._right_matrix(group, _form) if group.is_matrix else _right(group.rows[0])
        for wrong, right in self._respelt.get(whole(claim), ()):
            latex = latex.replace(wrong, right)
        return latex

    def _right_matrix(self, group: Group, write: Callable[[Row], str]) -> str:
        """Return a matrix with its entries mended; one that is left unevaluated, multiplied out."""
        if latex := self._with_entries(group, write):
            return latex
        if any(row.verdict.is_fault for row in group.rows):
            return matrix_of(group, lambda row: row.correction or row.derived)
        return group.whole

    def _with_entries(self, group: Group, write: Callable[[Row], str]) -> str:
        """Return the print with every entry written anew; nothing when an entry has no place."""
        latex, tree = self.context.printed(group.base), self.context.loaded.trees[group.base]
        spans = {row: entry_span(tree, tuple(map(int, index(row.id)))) for row in group.rows}
        if None in spans.values():
            return ""
        for row, span in sorted(spans.items(), key=lambda found: found[1] or (), reverse=True):
            start, end = span or (0, 0)
            latex = latex[:start] + write(row) + latex[end:]
        return latex

    def _pastes(self, place: str, line: Line, rows: tuple[Row, ...]) -> Iterator[tuple[str, str]]:
        if any(row.verdict in UNKNOWN for row in rows):
            return
        latex = latex_paste(line.filled(self.right))
        if is_settable(latex) and self._reads(latex):
            yield "LaTeX", latex
        function = line.function
        name = function.__name__ if function else line.name or _slug(place)
        if product := self.product(line):
            texts = {"NumPy": numpy_paste(name, product), "SymPy": sympy_paste(name, product)}
            yield from ((kind, text) for kind, text in texts.items() if text)
        if function and line.call:
            yield "omniproof", omniproof_paste(function.__module__, name, line.call)

    def product(self, line: Line) -> Product | None:
        """Return what a line is worth, in the form that is printed or should be."""
        names = (*line.factors, line.per) if line.per else line.factors
        values = [self.value(name) for name in names]
        if not values or any(value is None or value == 0 for value in values):
            return None  # a side that is 0 by what the paper chooses is nothing to calculate with
        return Product(tuple(values[:-1]), values[-1]) if line.per else Product(tuple(values))

    def value(self, claim: str) -> Any:
        """Return what a claim ought to say as SymPy, in the form of the print; None for none."""
        if claim not in self._known:
            self._known[claim] = self._value(claim)
        return self._known[claim]

    def _value(self, claim: str) -> Any:
        group = self.groups[claim]
        if (
            group.rows[0].kind is not Kind.IDENTITY
            or claim not in self.context.registry.derivations
        ):
            return None
        try:
            read = self.context.value(latex_paste(self.right(claim)), claim)
        except (LatexError, UnsupportedError):
            read = self.context.derive_by_mechanics(claim)
        last = read[-1] if isinstance(read, tuple) else read
        return last if isinstance(last, Expr | MatrixBase) else None

    def unproved(self) -> Iterator[str]:
        """Name the claims whose formula to paste is not proved to be what mechanics gives.

        Of those that are right as printed the audit has proved it.
        """
        for name, group in self.groups.items():
            if any(row.verdict.is_fault for row in group.rows):
                value = self.value(name)
                if value is not None and not self._proved(name, value):
                    yield name

    def _proved(self, claim: str, value: Any) -> bool:
        right = self.context.derive_by_mechanics(claim)
        domain = self.context.domain(claim)
        return getattr(right, "shape", ()) == getattr(value, "shape", ()) and all(
            isinstance(confirmed_equal(*pair, domain), Proved)
            for pair in zip(flat(value), flat(right), strict=True)
        )


def _form(row: Row) -> str:
    """Return the right form; a verified one is the printed one."""
    if row.verdict is Verdict.VERIFIED:
        return row.printed
    return row.correction or row.derived or row.printed


def _right(row: Row) -> str:
    """Return the right form of a formula, with the left side that is printed."""
    right = _form(row)
    left, sign, _ = row.printed.partition("=")
    return f"{left}= {right}" if sign and left.strip() and "=" not in right else right


def _boxed(latex: str, row: Row) -> str:
    return rf"\boxed{{{latex}}}" if row.verdict.is_fault and is_latex(latex) else latex


def _changed(latex: str, row: Row) -> str:
    return rf"\changed{{{latex}}}" if row.verdict.is_fault else latex


def _slug(place: str) -> str:
    return "".join(sign if sign.isalnum() else "_" for sign in place).strip("_")
