"""What was covered: what the source texts print, and which engines decided what.

A report of verdicts says nothing of what nobody looked at. The inventories list all that a simple
scan finds in the source texts; here they are counted, with what became a claim and what did not.
"""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Mapping
from html import escape
from pathlib import Path

from omniproof.audit.ledger import Ledger, Origin, Verdict, read_ledgers
from omniproof.report.fragments.base import Fragment, badge, results_folder, table
from omniproof.report.fragments.claims import engine_names
from omniproof.report.fragments.values import Value
from omniproof.report.theme import MARKS

ITEMS = ("equation", "cell", "numeral", "comparison", "reference")
"""Kinds of items of an inventory, as its column `item` names them."""


class Coverage:
    """Inventories and engines of all papers, as tables."""

    def __init__(self, ledgers: tuple[Ledger, ...], papers: Path) -> None:
        self.ledgers = ledgers
        self.papers = papers

    @classmethod
    def open(cls, results: Path | None = None) -> Coverage:
        """Open all ledgers of the folder of results (found from the working folder)."""
        folder = results or results_folder()
        return cls(read_ledgers(folder), folder.parent / "paper_data")

    def verdicts(self) -> Fragment:
        """Show what each verdict means."""
        rows = (
            f'<tr><th scope="row">{badge(verdict)}</th><td>{MARKS[verdict].meaning}</td></tr>'
            for verdict in Verdict
        )
        return Fragment(table(["verdict", "the printed form is"], rows), "verdicts")

    def inventory(self) -> Fragment:
        """Show how many items of each kind the sources print, and how many became claims."""
        body = [
            f'<tr><th scope="row">{escape(ledger.paper)}</th>'
            + "".join(_share(kind, self.items(ledger.paper)) for kind in ITEMS)
            + "</tr>"
            for ledger in self.ledgers
        ]
        head = ["paper", *(f"{kind}s" for kind in ITEMS)]
        return Fragment(table(head, body, "counted"), "inventory")

    def engines(self) -> Fragment:
        """Show how many rows each set of engines decided, the largest first."""
        rows = (row for ledger in self.ledgers for row in ledger.rows)
        counts = Counter(_deciders(row.engines, row.origin, row.verdict) for row in rows)
        body = (
            f'<tr><th scope="row">{name}</th><td class="number">{number}</td></tr>'
            for name, number in sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))
        )
        return Fragment(table(["decided by", "rows"], body, "counted"), "engines")

    def count(self, what: str) -> Value:
        """Return a number for running text: `items`, `claimed` ones, `left out` ones."""
        counts = (self.items(ledger.paper) for ledger in self.ledgers)
        found = sum(counts, Counter[tuple[str, bool]]())
        chosen = {"items": (True, False), "claimed": (True,), "left out": (False,)}[what]
        return Value(str(sum(n for (_, claimed), n in found.items() if claimed in chosen)))

    def items(self, paper: str) -> Counter[tuple[str, bool]]:
        """Count the items of a paper's inventory: (kind, whether it has a claim)."""
        path = self.papers / paper / "inventory.csv"
        with path.open(encoding="utf-8", newline="") as file:
            return Counter(
                (row["item"].rpartition("-")[0], bool(row["claim"])) for row in csv.DictReader(file)
            )


def _share(kind: str, items: Mapping[tuple[str, bool], int]) -> str:
    """Return a cell: how many of a kind have a claim, and how many there are."""
    claimed = items.get((kind, True), 0)
    every = claimed + items.get((kind, False), 0)
    return f'<td class="number">{claimed}/{every}</td>' if every else "<td></td>"


def _deciders(engines: str, origin: Origin, verdict: Verdict) -> str:
    """Return who decided a row, in words (HTML)."""
    if verdict is Verdict.UNCHECKABLE:
        return "nobody: uncheckable"
    if origin is Origin.READ:
        return "a reader, with a reason"
    return engine_names(engines)
