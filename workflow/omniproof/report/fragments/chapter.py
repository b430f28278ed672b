"""A chapter: one paper's ledger, shown piece by piece, each row exactly once.

The chapter remembers what it has shown. A row that is shown twice would have two elements with one
address: that is an error at once. A row that no section has shown appears in `rest()`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from omniproof.audit.ledger import Ledger, Row, Verdict, read_json
from omniproof.report.anchors import anchor, selects
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
from omniproof.report.fragments.claims import group_html
from omniproof.report.fragments.counts import accounting_html
from omniproof.report.fragments.figures import drawn_html
from omniproof.report.fragments.survival import survives_html
from omniproof.report.fragments.tables import Labels, beside_html, grid_html, list_html
from omniproof.report.fragments.theorems import Theorem, read_theorems, theorem_markdown
from omniproof.report.fragments.values import Value
from omniproof.report.groups import Group, groups
from omniproof.report.latexfmt import cell
from omniproof.transcription.ids import base


class Chapter:
    """One paper in the book; its calls return fragments of the page `<paper>.html`."""

    def __init__(self, ledger: Ledger, theorems: Iterable[Theorem], results: Path) -> None:
        self.ledger = ledger
        self.theorems = tuple(t for t in theorems if ledger.paper in t.papers)
        self.results = results
        self._rows = {row.id: row for row in ledger.rows}
        self._addresses = Addresses(ledger)
        self._derived = Derived(ledger)
        self._shown: set[str] = set()

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

    def claims(self, *selectors: str) -> Fragment:
        """Show the cards of all claims that the selectors name (`eq:6` names its entries too)."""
        return self._cards(self._take(selectors), " ".join(selectors))

    def rest(self) -> Fragment:
        """Show the cards of all claims that nothing before has shown."""
        rows = [row for row in self.ledger.rows if row.id not in self._shown]
        self._shown.update(row.id for row in rows)
        if not rows:
            return Fragment("<p>Nothing: every row stands in a section above.</p>", "nothing else")
        return self._cards(rows, "everything else")

    def table(
        self, *selectors: str, columns: Labels | None = None, rows: Labels | None = None
    ) -> Fragment:
        """Show a table of numbers, printed beside computed; headings by the names in the ids."""
        found = self._take(selectors)
        html = beside_html(found, self.href, columns or {}, rows or {}, self._derived)
        return Fragment(self._boxed(found, html), f"table {' '.join(selectors)}")

    def listing(self, *selectors: str) -> Fragment:
        """Show claims as a list of one line each: a nomenclature, references, spelling."""
        found = self._take(selectors)
        html = list_html(found, self.href, self._derived)
        return Fragment(self._boxed(found, html), f"list {' '.join(selectors)}")

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
        return Fragment(table(["place", "printed", "holds for"], body, "grid"), "conditions")

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
        address = self._addresses.find(claim_id)
        return f"#{address}" if address else None

    def _cards(self, rows: Iterable[Row], name: str) -> Fragment:
        cards = "".join(map(self._card, groups(rows)))
        return Fragment(f'<div class="claims">{cards}</div>', f"claims {name}")

    def _card(self, group: Group) -> str:
        free = not self._addresses.is_answered(group.base)
        addressed = free and (not group.is_matrix or self._addresses.take(anchor(group.base)))
        html = group_html(group, self.href, addressed=addressed, derived=self._derived)
        rows = self._addresses.rows_of(group.base)
        return f'<span id="{rows}"></span>{html}' if rows else html

    def _boxed(self, rows: Iterable[Row], html: str) -> str:
        """Put a table into a box with the address of the table that the rows are cells of."""
        whole = {base(row.id) for row in rows if base(row.id) != row.id}
        free = [a for a in sorted(map(anchor, whole)) if self._addresses.take(a)]
        return "".join(f'<span id="{address}"></span>' for address in free) + html

    def _take(self, selectors: Iterable[str]) -> list[Row]:
        """Mark the selected rows as shown.

        Raises `ValueError` when a selector names no row, or a row that was shown before.
        """
        wanted = tuple(selectors)
        for selector in wanted:
            if not any(selects(selector, claim_id) for claim_id in self._rows):
                raise ValueError(f"{self.ledger.paper}: no claim is selected by {selector!r}")
        rows = [r for r in self.ledger.rows if any(selects(s, r.id) for s in wanted)]
        again = [row.id for row in rows if row.id in self._shown]
        if again:
            raise ValueError(f"{self.ledger.paper}: shown twice: {', '.join(again)}")
        self._shown.update(row.id for row in rows)
        return rows
