"""A chapter: one paper's ledger, told piece by piece, and every row of it in one table."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from omniproof.audit.ledger import Ledger, Row, Verdict, read_json
from omniproof.report.anchors import selects
from omniproof.report.answers import Equations
from omniproof.report.derived import Derived
from omniproof.report.fragments.addresses import Addresses
from omniproof.report.fragments.answers import answers_html
from omniproof.report.fragments.base import (
    Fragment,
    Written,
    corrigendum_link,
    link,
    results_folder,
    table,
)
from omniproof.report.fragments.counts import accounting_html
from omniproof.report.fragments.figures import drawn_html
from omniproof.report.fragments.rows import rows_html
from omniproof.report.fragments.survival import survives_html
from omniproof.report.fragments.tables import Labels, beside_html, grid_html
from omniproof.report.fragments.theorems import Theorem, read_theorems, theorem_markdown
from omniproof.report.fragments.values import Value
from omniproof.report.latexfmt import cell


class Chapter:
    """One paper in the book; its calls return fragments of the page `<paper>.html`."""

    def __init__(self, ledger: Ledger, theorems: Iterable[Theorem], results: Path) -> None:
        self.ledger = ledger
        self.theorems = tuple(t for t in theorems if ledger.paper in t.papers)
        self.results = results
        self._rows = {row.id: row for row in ledger.rows}
        self._addresses = Addresses(ledger)
        self._derived = Derived(ledger)

    @classmethod
    def open(cls, paper: str, results: Path | None = None) -> Chapter:
        """Open a paper's chapter from the folder of results (found from the working folder)."""
        folder = results or results_folder()
        ledger = read_json(folder / "ledger" / f"{paper}.json")
        return cls(ledger, read_theorems(folder / "theorems.json"), folder)

    def row(self, claim_id: str) -> Row:
        """Return one row. Raises `KeyError` when the ledger has no such id."""
        return self._rows[claim_id]

    def answers(self) -> Fragment:
        """Show every numbered equation as a whole, with what to use; before the rows of any."""
        equations = Equations(self.ledger)
        self._addresses.give_to_answers(n for n in equations.answers if n.startswith("eq:"))
        return Fragment(answers_html(equations, self.href), "answers")

    def every_row(self) -> Fragment:
        """Show all rows of the paper as one table; last, for others bear addresses, too."""
        return Fragment(rows_html(self.ledger, self.href, self._addresses), "every row")

    def table(
        self, *selectors: str, columns: Labels | None = None, rows: Labels | None = None
    ) -> Fragment:
        """Show a table of numbers, printed beside computed; headings by the names in the ids."""
        html = beside_html(self._selected(selectors), self.href, columns or {}, rows or {})
        return Fragment(html, f"table {' '.join(selectors)}")

    def grid(self, head: Sequence[str], rows: Iterable[Sequence[str]]) -> Fragment:
        """Show computed cells (text with `$math$`) under column heads; the first names the row."""
        return Fragment(grid_html(head, rows), "grid")

    def conditions(self) -> Fragment:
        """Show what each conditional row needs; the rows themselves stand in their sections."""
        body = [
            f'<tr><th scope="row">{link(row.id, self.href)}</th><td>{cell(row.printed)}</td>'
            f"<td>{cell(row.assumption)}</td></tr>"
            for row in self.ledger.rows
            if row.verdict is Verdict.CONDITIONAL
        ]
        found = table(["place", "printed", "holds for"], body, "grid")
        title = f"{len(body)} statements, and what each needs"
        html = f"<details><summary>{title}</summary>{found}</details>"
        return Fragment(html, "conditions")

    def figure(self, number: int | str) -> Fragment:
        """Show figure N of the paper as it was drawn again, or a drawing of our own by its name."""
        address = f"fig-{number}" if self._addresses.take(f"fig-{number}") else f"figure-{number}"
        html = drawn_html(self.results, self.ledger.paper, number, address)
        return Fragment(html, f"figure {number}")

    def theorem(self, theorem_id: str) -> Written:
        """Show one theorem with its proof. Raises `KeyError` when there is no such theorem."""
        found = {theorem.id: theorem for theorem in self.theorems}[theorem_id]
        return Written(theorem_markdown(found), theorem_id)

    def all_theorems(self) -> Written:
        """Show all theorems that concern this paper."""
        return Written("\n".join(map(theorem_markdown, self.theorems)), "theorems")

    def counts(self) -> Fragment:
        """Show the verdicts of this paper as a bar and a table, and link to its corrigendum."""
        link_to_pdf = f"<p>{corrigendum_link(self.ledger.paper)}</p>"
        return Fragment(accounting_html(self.ledger) + link_to_pdf, "counts")

    def survives(self) -> Fragment:
        """Show which conclusions stand, and which fall with which fault."""
        return Fragment(survives_html(self.ledger, self.href), "what survives")

    def value(self, claim_id: str, column: str = "printed") -> Value:
        """Return one cell of the ledger for running text (see `in_text`)."""
        return Value(cell(str(getattr(self.row(claim_id), column))))

    def href(self, claim_id: str) -> str | None:
        """Return the link to a claim on this page, or None when there is no such place."""
        return self._addresses.href(claim_id)

    def _selected(self, selectors: Iterable[str]) -> list[Row]:
        """Return the selected rows. Raises `ValueError` when a selector names none."""
        wanted = tuple(selectors)
        for selector in wanted:
            if not any(selects(selector, claim_id) for claim_id in self._rows):
                raise ValueError(f"{self.ledger.paper}: no claim is selected by {selector!r}")
        return [r for r in self.ledger.rows if any(selects(s, r.id) for s in wanted)]
